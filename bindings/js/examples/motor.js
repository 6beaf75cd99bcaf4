// Joints and a motor: a motor turns a hinge at 1 rad/s, and a limit stops it at 1 rad.
import assert from "node:assert/strict";
import { load } from "carom";
import { CAROM_COORDINATE_TWIST as TWIST } from "carom/constants";

const carom = await load();
const engine = carom.engine(),
  world = engine.world();
const rod = world.body({ shape: engine.box(0.5, 0.05, 0.05), position: [0.5, 0, 0] });
const axes = [0, -Math.SQRT1_2, 0, Math.SQRT1_2]; // its x axis is the world's z axis
const hinge = world.joint("hinge", null, rod, { at: [0, 0, 0], axes });
hinge.setMotor(TWIST, 1, 200); // rad/s, N m
hinge.setLimit(TWIST, -1, 1); // rad
const angle = [];
for (const steps of [30, 120]) {
  for (let i = 0; i < steps; ++i) world.step(1 / 60);
  angle.push(hinge.state.coordinate[TWIST]);
}
console.log(`${angle[0].toFixed(2)} rad after 0.5 s, ${angle[1].toFixed(2)} rad after 2.5 s, at the limit`);
assert(Math.abs(angle[0] - 0.5) < 0.02 && Math.abs(angle[1] - 1) < 0.01);
world.free();
engine.free();
