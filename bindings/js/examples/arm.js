// A robot's arm by inverse dynamics: two links of 2 kg move to a pose and stay there, against gravity.
import assert from "node:assert/strict";
import { load } from "carom";

const carom = await load();
const engine = carom.engine(),
  world = engine.world();
const rod = engine.box(0.5, 0.05, 0.05),
  inertia = [0.01, 0, 0, 0, 0.17, 0, 0, 0, 0.17],
  axes = [0, -Math.SQRT1_2, 0, Math.SQRT1_2]; // hinges about z
let link = null;
for (let i = 0; i < 2; ++i) {
  const next = world.body({ shape: rod, position: [i + 0.5, 0, 0], mass: 2, center: [0, 0, 0], inertia });
  world.joint("hinge", link, next, { at: [i, 0, 0], axes });
  link = next;
}
const arm = world.tree(link),
  goal = [0.5, -0.5]; // rad
const level = arm.forces({ speeds: [0, 0] }); // what bears the weight in the first pose
let angle;
for (let i = 0; i < 120; ++i) {
  angle = world.readJoints("position");
  const speed = world.readJoints("velocity");
  const accelerations = goal.map((to, k) => 400 * (to - angle[k]) - 40 * speed[k]); // rad/s^2
  world.writeJoints("target_effort", arm.forces({ accelerations }));
  world.step(1 / 60);
}
const [a, b] = Array.from(angle, (x) => x.toFixed(2));
console.log(
  `${level[0].toFixed(2)} and ${level[1].toFixed(2)} N m hold it level; after 2 s it is at ${a} and ${b} rad`,
);
assert(Math.abs(level[0] - 4 * 9.81) < 1e-9 && Math.abs(level[1] - 9.81) < 1e-9);
assert(Math.abs(angle[0] - 0.5) < 0.005 && Math.abs(angle[1] + 0.5) < 0.005);
world.free();
engine.free();
