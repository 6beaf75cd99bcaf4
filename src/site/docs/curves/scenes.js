// Scenes of the topic pages whose answer is known, and the settings that are measured.
import { between, bounced, follow, freeSpin } from "./truths.js";

const GRAVITY = 9.81;
const counts = [1, 2, 4, 8, 16, 32];
const substeps = (dials = {}, most = 32) =>
  counts.filter((n) => n <= most).map((n) => ({ label: `substeps ${n}`, dials: { ...dials, substeps: n } }));
const steps = (dials = {}) => [30, 60, 120, 240, 480].map((hz) => ({ label: `1/${hz} s a step`, dials, dt: 1 / hz }));
const asked = (least) =>
  [1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8]
    .filter((x) => x >= least)
    .map((ask) => ({ label: `asked for ${ask.toExponential(0)} a second`, ask }));
const by = (name, choices, settings) =>
  choices.map(([word, value]) => ({ name: word, settings: settings({ [name]: value }) }));
const SOLVERS = [
  ["soft_step", 1],
  ["direct", 2],
  ["auto, as it comes", 3],
];
const INTEGRATORS = [
  ["explicit_euler", 0],
  ["semi_implicit_euler", 1],
  ["rk4", 2],
  ["velocity_verlet, as it comes", 3],
];
const ROTATIONS = [
  ["explicit", 1],
  ["rk4", 3],
  ["lie_midpoint", 4],
  ["splitting, as it comes", 5],
  ["splitting_4", 6],
  ["splitting_6", 7],
];

/** A rod on a hinge.   @returns (time) => m: how far its middle is from where it should be */
function pendulum(world, { length, angle, spin = 0, at }) {
  const arm = length / 2,
    inertia = (length * length) / 12,
    middle = (a) => [at[0] + arm * Math.sin(a), at[1] - arm * Math.cos(a)];
  const [x, y] = middle(angle);
  const rod = world.body({
    position: [x, y, at[2]],
    mass: 1,
    inertia: [inertia, 0, 0, 0, inertia, 0, 0, 0, inertia],
    linear_velocity: [spin * arm * Math.cos(angle), spin * arm * Math.sin(angle), 0],
    angular_velocity: [0, 0, spin],
  });
  world.joint("hinge", null, rod, { at, axes: [0, -Math.SQRT1_2, 0, Math.SQRT1_2] }); // about z
  const pull = (GRAVITY * arm) / (inertia + arm * arm),
    truth = follow(([a, w]) => [w, -pull * Math.sin(a)], [angle, spin], 2e-4 * Math.min(1, Math.sqrt(length)));
  return (time) => {
    const [u, v] = middle(truth(time)[0]),
      p = rod.position;
    return Math.hypot(p[0] - u, p[1] - v, p[2] - at[2]);
  };
}
const worst = (judges) => (time, last) => Math.max(...judges.map((judge) => judge(time, last)));
const row = (n, make) => worst(Array.from({ length: n }, (_, i) => make(i)));

export const SCENES = {
  joints: {
    what: "distance of a rod's middle from its equation of motion, the largest of 8 pendulums in 3 s",
    unit: "m",
    seconds: 3,
    build: (_, world) => row(8, (i) => pendulum(world, { length: 1, angle: 0.3 + 0.35 * i, at: [0, 0, i] })),
    series: [
      ...by(
        "joint_order",
        [
          ["order 2, as it comes", 2],
          ["order 4", 4],
          ["order 6", 6],
        ],
        substeps,
      ),
      { name: "asked for", settings: asked(1e-8) },
    ],
  },
  accuracy: {
    what: "distance of a rod's middle from its equation of motion: 40 rods of 2 m, and one of 0.1 m at 30 rad/s; 2 s",
    unit: "m",
    seconds: 2,
    build: (_, world) =>
      row(41, (i) =>
        pendulum(
          world,
          i ? { length: 2, angle: 0.2 + 0.02 * i, at: [0, 0, i] } : { length: 0.1, angle: 0, spin: 30, at: [0, 0, 0] },
        ),
      ),
    series: [
      { name: "the same substeps for all", settings: substeps() },
      ...by("joint_order", [["the same, of order 4", 4]], substeps),
      { name: "asked for", settings: asked(1e-6) },
    ],
  },
  rotation: {
    what: "turn by which a free box is off after 4 s, the largest of 8",
    unit: "rad",
    seconds: 4,
    build: (engine, world) => {
      world.gravity = [0, 0, 0];
      const shape = engine.box(0.1, 0.2, 0.3),
        inertia = [0.04 + 0.09, 0.01 + 0.09, 0.01 + 0.04].map((x) => x / 3);
      return row(8, (i) => {
        const spin = [1 + 0.3 * i, 4 - 0.2 * i, 0.5 + 0.4 * i];
        const box = world.body({ shape, mass: 1, position: [2 * i, 0, 0], angular_velocity: spin });
        const truth = follow(freeSpin(inertia), [...spin, 0, 0, 0, 1], 5e-4);
        return (time) => between(truth(time).slice(3), box.orientation);
      });
    },
    series: by("rotation", ROTATIONS, steps),
  },
  impacts: {
    what: "height by which a bouncing ball is off, the largest of 6 in 2 s",
    unit: "m",
    seconds: 2,
    build: (engine, world) => {
      const material = { friction: 0, restitution: 0.8 },
        shape = engine.sphere(0.1);
      world.ground(material);
      return row(6, (i) => {
        const drop = 0.6 + 0.13 * i,
          ball = world.body({ shape, position: [i, 0.1 + drop, 0], ...material });
        return (time) => Math.abs(ball.position[1] - bounced(drop, 0.8, 0.1, GRAVITY, time));
      });
    },
    series: by("integrator", INTEGRATORS, substeps),
  },
  friction: {
    what: "distance from where a block that slides should come to rest, the largest of 8 directions",
    unit: "m",
    seconds: 1.5,
    build: (engine, world) => {
      const material = { friction: 0.5, restitution: 0 },
        shape = engine.box(0.5, 0.1, 0.5);
      world.ground(material);
      return row(8, (i) => {
        const speed = 2 + 0.25 * i,
          along = [Math.cos(0.7 * i), Math.sin(0.7 * i)],
          way = (speed * speed) / (2 * 0.5 * GRAVITY);
        const block = world.body({
          shape,
          position: [0, 0.1, 6 * i],
          linear_velocity: [speed * along[0], 0, speed * along[1]],
          ...material,
        });
        return (_, last) => {
          const p = block.position;
          return last ? Math.hypot(p[0] - way * along[0], p[2] - 6 * i - way * along[1]) : 0;
        };
      });
    },
    series: by("solver", SOLVERS, substeps),
  },
  stacking: {
    what: "distance by which any of 10 cubes of 1 m in a column has moved in 3 s",
    unit: "m",
    seconds: 3,
    build: (engine, world) => {
      const shape = engine.box(0.5, 0.5, 0.5),
        material = { friction: 0.5, restitution: 0 };
      world.ground(material);
      return row(10, (i) => {
        const cube = world.body({ shape, position: [0, 0.5 + i, 0], ...material });
        return () => Math.hypot(cube.position[0], cube.position[1] - 0.5 - i, cube.position[2]);
      });
    },
    series: by("solver", SOLVERS, (dials) => substeps(dials, 16)),
  },
};
