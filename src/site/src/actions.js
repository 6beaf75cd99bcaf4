// What a visitor can do to a world. An action is plain data and means the same in every run: bodies are named by
// their place in
// world.bodies(), numbers are doubles.

const SPRING = 4; // Hz, of the pull on a body that is dragged
const DAMPING = 0.7; // ratio

/** q v q*, q = x, y, z, w */
export function rotate([x, y, z, w], [a, b, c]) {
  const tx = 2 * (y * c - z * b),
    ty = 2 * (z * a - x * c),
    tz = 2 * (x * b - y * a);
  return [a + w * tx + y * tz - z * ty, b + w * ty + z * tx - x * tz, c + w * tz + x * ty - y * tx];
}
/** @returns length: the same bits in every browser, which Math.hypot() does not promise */
const size = ([x, y, z]) => Math.sqrt(x * x + y * y + z * z);
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

const ACTIONS = {
  dial(sim, { name, value }) {
    sim.world.setDial(name, value);
  },
  preset(sim, { value }) {
    sim.world.setPreset(value);
  },
  effect(sim, { effect, mode }) {
    sim.world.setEffect(effect, mode);
  },
  gravity(sim, { value }) {
    sim.world.gravity = value;
  },
  /** A spring from a point of the body (its own frame) to a target in the world, for one step. */
  pull(sim, { body, at, to }) {
    const b = sim.bodies[body];
    if (!b || b.type !== "dynamic") return;
    b.wake();
    const arm = rotate(b.orientation, at),
      p = b.position,
      centre = b.center;
    const point = arm.map((x, i) => x + p[i]),
      lever = point.map((x, i) => x - centre[i]);
    const v = b.linearVelocity,
      spin = cross(b.angularVelocity, lever),
      w = 2 * Math.PI * SPRING,
      m = b.mass;
    const force = [0, 1, 2].map((i) => m * (w * w * (to[i] - point[i]) - 2 * DAMPING * w * (v[i] + spin[i])));
    // The lever is shortened so that a long body is turned, not whirled.
    b.addForce(
      force,
      cross(lever, force).map((x) => 0.3 * x),
    );
  },
  /** A new body. @property shape  id of a plugin, "box"   @property params  of the shape */
  spawn(sim, { shape, params, position, velocity = [0, 0, 0], density = 1000 }) {
    const body = sim.world.body({
      shape: sim.engine.shape(shape, params),
      density,
      position,
      linear_velocity: velocity,
      user: 0xffffffffn,
    });
    sim.refresh();
    return body;
  },
  /** What is asked of the car, the character, the arm.   @property value  numbers: drive.js */
  input(sim, { value }) {
    if (!Array.isArray(value) || !value.every(Number.isFinite)) throw new TypeError("an input is a list of numbers");
    sim.driver?.set(value);
  },
  /** Bodies within reach fly off, the nearest fastest.   @property at [3] m   @property speed m/s   @property reach m */
  explode(sim, { at, speed, reach }) {
    for (const b of sim.bodies) {
      if (b.type !== "dynamic") continue;
      const away = b.center.map((x, i) => x - at[i]),
        far = size(away);
      if (far > reach) continue;
      b.wake();
      const push = (b.mass * speed * (1 - far / reach)) / Math.max(far, 1e-6);
      b.addImpulse(away.map((x, i) => push * (x + (i === 1 ? 0.3 * far : 0))));
    }
  },
  /** The joints of a body go. */
  cut(sim, { body }) {
    const b = sim.bodies[body];
    for (const joint of b ? sim.world.joints() : []) {
      const { body_a, body_b } = joint.desc;
      if (body_a === b.handle || body_b === b.handle) joint.destroy();
    }
    b?.wake();
  },
  remove(sim, { body }) {
    const b = sim.bodies[body];
    if (!b) return;
    b.destroy();
    sim.refresh();
  },
};

/** @param action { do: name of one above, ... }   @throws CaromError, TypeError: then nothing has changed */
export function act(sim, action) {
  if (!Object.hasOwn(ACTIONS, action?.do)) throw new TypeError(`there is no action "${action?.do}"`);
  return ACTIONS[action.do](sim, action);
}
