// What a visitor steers: a car (carom/vehicle.h), a character (carom/character.h), a robot's arm. Their state lies in
// the module's memory beside the world. It is saved with each snapshot, and only actions change what is asked of them,
// so a step of the past, or of a link, has the same bits.
import { constants as C } from "carom";

/** Room for structs one after another, which lives as long as the driver.
 *  @param parts  [name of a struct, values] or, of several in a row, [name, [values, ...]]; [bytes]   @returns { begin,
 *  total, places } */
function block(m, parts) {
  const structs = ([name, values]) => (typeof name === "number" ? [] : Array.isArray(values) ? values : [values ?? {}]);
  const sizes = parts.map((part) => (part[0] > 0 ? part[0] : structs(part).length * m.structs.size(part[0])));
  const total = sizes.reduce((sum, size) => sum + ((size + 15) & ~15), 0),
    begin = m.claim(total);
  new Uint8Array(m.buffer, begin, total).fill(0);
  let at = begin;
  const places = parts.map((part, i) => {
    const here = at,
      [name] = part;
    structs(part).forEach((values, k) => {
      const one = here + k * m.structs.size(name);
      m.check(m.raw[`${name}_init`](one, m.structs.size(name)), name);
      m.structs.write(m.view, name, one, values);
    });
    at += (sizes[i] + 15) & ~15;
    return here;
  });
  return { begin, total, places };
}

class Driver {
  constructor(sim, spec) {
    Object.assign(this, { sim, spec, m: sim.world.module });
  }
  /** Handles of a world are that world's own, so those in the state are kept as places in its lists. */
  save() {
    const bytes = new Uint8Array(this.m.buffer, this.block.begin, this.block.total).slice();
    return { bytes, refs: this.handles().map(([at, list]) => this.#find(this.m.view.getBigUint64(at, true), list)) };
  }
  restore({ bytes, refs }) {
    new Uint8Array(this.m.buffer, this.block.begin, this.block.total).set(bytes);
    this.handles().forEach(([at, list], i) =>
      this.m.view.setBigUint64(at, this.sim[list][refs[i]]?.handle ?? 0n, true),
    );
  }
  #find(handle, list) {
    return handle ? this.sim[list].findIndex((one) => one.handle === handle) : -1;
  }
  /** @returns [[address of a handle, "bodies" or "parts" (colliders)]] of the state */
  handles() {
    return [];
  }
  /** Addresses of handles in a struct.   @param lists  by field */
  fields(name, at, lists) {
    return Object.entries(lists).flatMap(([field, list]) => {
      const { offset, count } = this.m.structs.layouts.get(name).fields.get(field);
      return Array.from({ length: count || 1 }, (_, i) => [at + offset + 8 * i, list]);
    });
  }
  free() {
    this.m.raw.free(this.block.begin);
  }
  before() {}
  after() {}
  /** What is asked of it now, as set() takes it. */
  value() {
    return this.m.doubles(this.asked, 3);
  }
  set(value) {
    if (value.length !== 3) throw new TypeError("an input here is three numbers");
    new Float64Array(this.m.buffer, this.asked, 3).set(value);
  }
  /** What is drawn of it beside its bodies.   @returns [{ shape, params, kind }] */
  looks() {
    return [];
  }
}

const WHEEL = { radius: 0.33, width: 0.12 }; // m, half its width

class Car extends Driver {
  keys = "drive by W, A, S, D or the arrows; space is the hand brake";
  constructor(sim, spec) {
    super(sim, spec);
    const wheels = [0, 1, 2, 3].map((i) => ({
      position: [i % 2 ? -0.78 : 0.78, -0.3, i < 2 ? 1.3 : -1.3],
      radius: WHEEL.radius,
      max_steer: i < 2 ? 0.55 : 0,
      drive: i < 2 ? 0.6 : 1,
      handbrake: i < 2 ? 0 : 4000,
      anti_roll: i % 2 ? 0 : 12000,
      anti_roll_partner: i % 2 ? 0xffffffff : i + 1,
      grip: 1.2,
      side_grip: 1.2,
    }));
    const chassis = sim.bodies[spec.body].handle;
    this.block = block(this.m, [
      ["carom_vehicle_desc", { chassis }],
      ["carom_wheel_desc", wheels],
      ["carom_vehicle_input"],
      ["carom_vehicle"],
      ["carom_wheel", wheels.map(() => ({}))],
      [24], // what is asked, each -1 to 1: forward, to the left, hand brake
    ]);
    [this.desc, this.descs, this.input, this.state, this.wheels, this.asked] = this.block.places;
  }
  handles() {
    const { size } = this.m.structs.layouts.get("carom_wheel");
    return this.fields("carom_vehicle_desc", this.desc, { chassis: "bodies" }).concat(
      ...[0, 1, 2, 3].map((i) =>
        this.fields("carom_wheel", this.wheels + i * size, { body: "bodies", collider: "parts" }),
      ),
    );
  }
  get speed() {
    return this.m.structs.read(this.m.view, "carom_vehicle", this.state).speed;
  }
  before(dt) {
    const { m } = this,
      [forward, left, hand] = this.value().map((x) => Math.min(1, Math.max(-1, x))),
      { steer } = m.structs.read(m.view, "carom_vehicle_input", this.input),
      { speed } = this;
    const slows = forward * speed < -0.5, // against the way it goes: brakes first
      most = 1 / (1 + Math.max(0, speed * speed) / 150); // at speed wheels turn less
    m.structs.write(m.view, "carom_vehicle_input", this.input, {
      throttle: slows ? 0 : Math.abs(forward),
      brake: slows ? 0.7 : 0,
      handbrake: Math.abs(hand),
      gear: forward < 0 && !slows ? -1 : 1,
      steer: Math.min(1, Math.max(-1, steer + Math.min(3 * dt, Math.max(-3 * dt, left * most - steer)))),
    });
    m.call(
      "carom_vehicle_drive",
      this.sim.world.pointer,
      this.desc,
      this.descs,
      4n,
      this.input,
      this.state,
      this.wheels,
      dt,
    );
  }
  looks() {
    return [0, 1, 2, 3].map(() => ({ shape: "cylinder", params: [WHEEL.radius, WHEEL.width], kind: "tyre" }));
  }
  /** @returns [[x, y, z, x, y, z, w]] of what looks() has */
  poses() {
    const { m } = this,
      size = m.structs.size("carom_wheel"),
      body = this.sim.bodies[this.spec.body].orientation;
    return [0, 1, 2, 3].map((i) => {
      const { position, angle, steer } = m.structs.read(m.view, "carom_wheel", this.wheels + i * size);
      // Steered about the chassis' y, turned about its x; a cylinder stands along y, so it is laid down first.
      const turn = [
        [0, 1, 0, steer],
        [1, 0, 0, angle],
        [0, 0, 1, Math.PI / 2],
      ].reduce(
        (q, [x, y, z, a]) => times(q, [x * Math.sin(a / 2), y * Math.sin(a / 2), z * Math.sin(a / 2), Math.cos(a / 2)]),
        body,
      );
      return [...position, ...turn];
    });
  }
  told() {
    return `${Math.round(3.6 * Math.abs(this.speed))} km/h`;
  }
  /** m: how far about it the camera looks */
  room = 5;
  place() {
    return this.sim.bodies[this.spec.body].position;
  }
  /** Which way it looks, level. */
  heading() {
    const [x, y, z, w] = this.sim.bodies[this.spec.body].orientation;
    return [2 * (x * z + w * y), 0, 1 - 2 * (x * x + y * y)];
  }
  wish(held) {
    const axis = (plus, minus) => (held.has(plus) ? 1 : 0) - (held.has(minus) ? 1 : 0);
    return [axis("up", "down"), axis("left", "right"), held.has("act") ? 1 : 0];
  }
}

const times = ([ax, ay, az, aw], [bx, by, bz, bw]) => [
  aw * bx + ax * bw + ay * bz - az * by,
  aw * by - ax * bz + ay * bw + az * bx,
  aw * bz + ax * by - ay * bx + az * bw,
  aw * bw - ax * bx - ay * by - az * bz,
];

const BODY = [0.3, 0.6], // m: radius and half the length of the capsule
  PACE = 3.5, // m/s
  JUMP = 5;

class Walker extends Driver {
  keys = "walk by W, A, S, D or the arrows; space jumps";
  constructor(sim, spec) {
    super(sim, spec);
    const { m } = this,
      shape = sim.engine.shape("capsule", BODY);
    this.block = block(m, [
      ["carom_character_desc", { step_up: 0.3, acceleration: 80, push_force: 500 }],
      ["carom_character", { position: spec.position }],
      [24], // what is asked: along x and z, -1 to 1; jump, 0 or 1
      [24], // the velocity of that, m/s
    ]);
    [this.desc, this.state, this.asked, this.walk] = this.block.places;
    m.call("carom_character_set_shape", sim.engine.pointer, sim.world.pointer, this.desc, this.state, shape.handle, 0);
  }
  handles() {
    return this.fields("carom_character", this.state, {
      ground_body: "bodies",
      ground_collider: "parts",
      contact_bodies: "bodies",
    });
  }
  get #state() {
    return this.m.structs.read(this.m.view, "carom_character", this.state);
  }
  before() {
    // The platform goes to and fro.
    const back = Math.floor(this.sim.step / 240) % 2;
    this.sim.bodies[this.spec.platform].setVelocity([0, 0, back ? -1 : 1], [0, 0, 0]);
  }
  after(dt) {
    const { m, sim } = this,
      [x, z, jump] = this.value();
    new Float64Array(m.buffer, this.walk, 3).set([PACE * x, 0, PACE * z]);
    m.call("carom_character_move", sim.world.pointer, this.desc, this.state, this.walk, JUMP * Math.abs(jump), dt);
    m.call("carom_character_push", sim.world.pointer, this.desc, this.state, dt);
  }
  looks() {
    return [{ shape: "capsule", params: BODY, kind: "walker" }];
  }
  poses() {
    const { position, orientation } = this.#state;
    return [[...position, ...orientation]];
  }
  told() {
    const { ground, position, foot } = this.#state;
    return `${["in the air", "on steep ground", "on firm ground"][ground]}, ${(position[1] - foot).toFixed(2)} m up`;
  }
  room = 4;
  place() {
    return this.#state.position;
  }
  /** @param camera  level direction that the camera looks along, [x, z] */
  wish(held, [cx, cz]) {
    const axis = (plus, minus) => (held.has(plus) ? 1 : 0) - (held.has(minus) ? 1 : 0),
      forward = axis("up", "down"),
      right = axis("right", "left"),
      x = forward * cx - right * cz,
      z = forward * cz + right * cx,
      size = Math.hypot(x, z) || 1;
    return [Number((x / size).toFixed(3)), Number((z / size).toFixed(3)), held.has("act") ? 1 : 0];
  }
}

class Arm extends Driver {
  keys = "the arrows, W and S move the mark: the hand goes there";
  constructor(sim, spec) {
    super(sim, spec);
    this.block = block(this.m, [[32]]); // where the mark is
    new Float64Array(this.m.buffer, this.block.begin, 3).set(spec.mark);
  }
  /** @param value [6] m: the mark; rad: angles that bring the hand there */
  value() {
    return null; // each mark is another one
  }
  set(value) {
    if (value.length !== 6) throw new TypeError("an input of an arm is six numbers");
    new Float64Array(this.m.buffer, this.block.begin, 3).set(value.slice(0, 3));
    this.#hinges()?.forEach((joint, i) =>
      joint.setSpring(C.CAROM_COORDINATE_TWIST, value[3 + i], this.spec.frequency, 1),
    );
  }
  /** None once one of them was cut. */
  #hinges() {
    const joints = this.sim.world.joints();
    return joints.length === 3 ? joints : null;
  }
  /** Motors bear what the arm weighs as it stands (carom/tree.h), springs do the rest. */
  before() {
    const { m, sim } = this,
      hinges = this.#hinges();
    if (!hinges) return;
    m.frame((room) => {
      const handles = room(24),
        still = room(24),
        efforts = room(24);
      new BigUint64Array(m.buffer, handles, 3).set(hinges.map((joint) => joint.handle));
      m.call("carom_tree_get_forces", sim.world.pointer, sim.bodies[this.spec.hand].handle, still, 0, efforts, 3n);
      const field = C.CAROM_JOINT_BULK_TARGET_EFFORT;
      m.call("carom_world_write_joints", sim.world.pointer, field, C.CAROM_SCALAR_F64, handles, 3n, efforts, 0n);
    });
  }
  mark() {
    return this.m.doubles(this.block.begin, 3);
  }
  hand() {
    const { position: p, orientation: q } = this.sim.bodies[this.spec.hand],
      { reach } = this.spec;
    return [
      p[0] + reach * (1 - 2 * (q[1] * q[1] + q[2] * q[2])),
      p[1] + reach * 2 * (q[0] * q[1] + q[3] * q[2]),
      p[2] + reach * 2 * (q[0] * q[2] - q[3] * q[1]),
    ];
  }
  looks() {
    return [{ shape: "sphere", params: [0.06], kind: "mark" }];
  }
  poses() {
    return [[...this.mark(), 0, 0, 0, 1]];
  }
  off() {
    const hand = this.hand();
    return Math.hypot(...this.mark().map((x, i) => x - hand[i]));
  }
  told() {
    return `the hand is ${(1e3 * this.off()).toPrecision(2)} mm from the mark`;
  }
  /** Angles of the three hinges: the shoulder's height and the lengths are the scene's. */
  solve([x, y, z]) {
    const { shoulder, lengths } = this.spec,
      [a, b] = lengths,
      out = Math.hypot(x, z),
      up = y - shoulder,
      most = 0.995 * (a + b),
      far = Math.hypot(out, up),
      shrink = far > most ? most / far : 1,
      c = Math.min(1, Math.max(-1, ((far * shrink) ** 2 - a * a - b * b) / (2 * a * b))),
      elbow = -Math.acos(c);
    return {
      mark: [x * shrink, shoulder + up * shrink, z * shrink],
      angles: [
        Math.atan2(-z, x),
        Math.atan2(up, out) - Math.atan2(b * Math.sin(elbow), a + b * Math.cos(elbow)),
        elbow,
      ],
    };
  }
  wish(held, [cx, cz]) {
    const axis = (plus, minus) => (held.has(plus) ? 1 : 0) - (held.has(minus) ? 1 : 0),
      by = 0.02, // m, of a step
      [x, y, z] = this.mark(),
      right = by * axis("right", "left"),
      deep = by * axis("forth", "back");
    const high = by * axis("up", "down");
    if (!right && !deep && !high) return null;
    const wanted = [x - right * cz + deep * cx, Math.max(0.1, y + high), z + right * cx + deep * cz];
    if (Math.hypot(wanted[0], wanted[2]) < 0.3) return null; // over its own foot
    const { mark, angles } = this.solve(wanted);
    return [...mark, ...angles].map((v) => Number(v.toFixed(5)));
  }
}

const DRIVERS = { car: Car, walker: Walker, arm: Arm };
export const driverOf = (sim, spec) => new DRIVERS[spec.kind](sim, spec);
