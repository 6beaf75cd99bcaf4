// Scenes to steer something in, made in the page: a yard for a car, a course for a character, a robot's arm.
import { constants as C } from "carom";

const HALF = Math.SQRT1_2;

class Scene {
  constructor(carom) {
    this.engine = carom.engine();
    this.world = this.engine.world();
    this.names = [];
  }
  /** @returns its number */
  add(kind, shape, options = {}) {
    const number = this.names.length;
    this.names.push([`${kind} ${number}`, kind]);
    const body = this.world.body({ ...(shape ? { shape } : {}), ...options, user: BigInt(number) });
    return { number, body };
  }
  box(kind, half, position, options = {}) {
    return this.add(kind, this.engine.box(...half), { position, ...options });
  }
  stands(kind, half, position, options = {}) {
    return this.box(kind, half, position, { type: "static", ...options });
  }
  ground() {
    this.add("ground", this.engine.halfSpace([0, 1, 0], 0), { type: "static", friction: 0.9 });
  }
  done(row) {
    try {
      return { start: this.world.save({ whole: true }), row: { dt: 1 / 60, bodies: this.names, ground: 10, ...row } };
    } finally {
      (this.world.free(), this.engine.free());
    }
  }
}
// Turns by the tangent of half their angle: no sine, so the numbers are the same in every browser.
const lifted = (t) => [0, 0, t / Math.sqrt(1 + t * t), 1 / Math.sqrt(1 + t * t)], // x goes up, about z
  pitched = (t) => [t / Math.sqrt(1 + t * t), 0, 0, 1 / Math.sqrt(1 + t * t)],
  sine = (t) => (2 * t) / (1 + t * t);
const SLOPES = [0.1763, 0.364, 0.5774]; // 20, 40, 60 degrees

function yard(carom) {
  const s = new Scene(carom);
  s.ground();
  const chassis = s.add("chassis", null, {
    position: [0, 0.7, 0],
    mass: 1200,
    center: [0, -0.1, 0],
    inertia: [1600, 0, 0, 0, 1800, 0, 0, 0, 500],
  });
  chassis.body.addCollider(s.engine.box(0.85, 0.25, 2), { position: [0, 0.15, 0] });
  chassis.body.addCollider(s.engine.box(0.7, 0.25, 0.95), { position: [0, 0.62, -0.25] });
  s.stands("ramp", [1.8, 0.15, 3.5], [0, 0.55, 22], { orientation: pitched(-0.0963) });
  for (let row = 0; row < 4; ++row)
    for (let k = 0; k < 4 - row; ++k)
      s.box("crate", [0.5, 0.5, 0.5], [(k - (3 - row) / 2) * 1.02, 0.5 + row, 38], { density: 60 });
  for (let i = 0; i < 14; ++i) s.box("domino", [0.5, 1, 0.1], [-9, 1, 8 + 1.1 * i], { density: 80 });
  for (let i = 0; i < 8; ++i)
    s.add("bump", s.engine.capsule(0.12, 2), {
      type: "static",
      position: [9, 0.02, 6 + 2.2 * i],
      orientation: [0, 0, HALF, HALF],
    });
  for (let i = 0; i < 6; ++i) s.add("ball", s.engine.sphere(0.6), { position: [-4 + 1.6 * i, 0.6, -14], density: 40 });
  return s.done({
    driver: { kind: "car", body: chassis.number },
    camera: { from: [0, 3.2, -9], to: [0, 0.6, 0] },
  });
}

function course(carom) {
  const s = new Scene(carom);
  s.ground();
  for (let i = 0; i < 6; ++i) s.stands("step", [1.5, 0.11 * (i + 1), 0.25], [0, 0.11 * (i + 1), 4 + 0.5 * i]);
  s.stands("landing", [1.5, 0.66, 2], [0, 0.66, 8.75]);
  SLOPES.forEach((t, i) =>
    s.stands("slope", [2.5, 0.1, 1], [5, 2.5 * sine(t) - 0.1, 2 + 3 * i], { orientation: lifted(t) }),
  );
  for (let i = 0; i < 6; ++i)
    s.box("crate", [0.35, 0.35, 0.35], [-3 - 0.9 * (i % 3), 0.35 + 0.71 * Math.floor(i / 3), 3], { density: 60 });
  const platform = s.box("platform", [1.2, 0.1, 1.2], [-5, 0.1, 6], { type: "kinematic" });
  for (let i = 0; i < 5; ++i) s.add("ball", s.engine.sphere(0.3), { position: [-1.5 + 0.7 * i, 0.3, -3], density: 60 });
  return s.done({
    driver: { kind: "walker", position: [0, 1, 0], platform: platform.number },
    camera: { from: [-4, 4, -7], to: [0, 1, 1] },
  });
}

function arm(carom) {
  const s = new Scene(carom),
    shoulder = 0.9,
    lengths = [1, 0.9],
    frequency = 25; // Hz, of the hinges' springs
  s.ground();
  s.stands("foot", [0.3, 0.15, 0.3], [0, 0.15, 0]);
  const column = s.add("column", s.engine.cylinder(0.16, 0.3), { position: [0, 0.6, 0], density: 500 });
  const upper = s.box("upper arm", [lengths[0] / 2, 0.07, 0.07], [lengths[0] / 2, shoulder, 0], { density: 500 });
  const fore = s.box("forearm", [lengths[1] / 2, 0.05, 0.05], [lengths[0] + lengths[1] / 2, shoulder, 0], {
    density: 500,
  });
  const about = { y: [0, 0, HALF, HALF], z: [0, -HALF, 0, HALF] };
  const joints = [
    s.world.joint("hinge", null, column.body, { at: [0, 0.3, 0], axes: about.y }),
    s.world.joint("hinge", column.body, upper.body, { at: [0, shoulder, 0], axes: about.z }),
    s.world.joint("hinge", upper.body, fore.body, { at: [lengths[0], shoulder, 0], axes: about.z }),
  ];
  for (const joint of joints) joint.setSpring(C.CAROM_COORDINATE_TWIST, 0, frequency, 1);
  for (let i = 0; i < 3; ++i)
    for (let k = 0; k < 3 - i; ++k)
      s.box("block", [0.12, 0.12, 0.12], [1.2, 0.12 + 0.24 * i, 0.5 + 0.26 * (k + i / 2)], { density: 100 });
  return s.done({
    driver: {
      kind: "arm",
      hand: fore.number,
      reach: lengths[1] / 2,
      mark: [lengths[0] + lengths[1], shoulder, 0],
      shoulder,
      lengths,
      frequency,
    },
    camera: { from: [1.5, 1.8, 4.5], to: [0.6, 0.7, 0] },
  });
}

const MAKERS = { yard, course, arm };
export const madeHere = (carom, name) => MAKERS[name](carom);
