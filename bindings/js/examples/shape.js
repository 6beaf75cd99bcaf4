// A shape of your own: a support function is all of it. An elliptic cylinder, its axis upright.
import assert from "node:assert/strict";
import { load } from "carom";

/** The farthest point of the shape along a direction. */
function support([a, h, b], [x, y, z]) {
  const length = Math.hypot(a * x, b * z);
  return [length ? (a * a * x) / length : 0, y < 0 ? -h : h, length ? (b * b * z) / length : 0];
}

const carom = await load();
const engine = carom.engine(),
  world = engine.world();
world.ground();
const half = ["a", "h", "b"].map((name) => [name, "m", 1e-6, 1e3]);
const id = engine.supportPlugin(support, "example.elliptic_cylinder", half);
const body = world.body({ shape: engine.shape(id, [0.6, 0.2, 0.3]), position: [0, 1, 0] }); // 1000 kg/m^3
for (let i = 0; i < 120; ++i) world.step(1 / 60);
const y = body.position[1];
console.log(`it weighs ${body.mass.toFixed(0)} kg and lies at y = ${y.toFixed(2)} m`);
assert(Math.abs(body.mass / (1000 * Math.PI * 0.6 * 0.3 * 0.4) - 1) < 0.005 && Math.abs(y - 0.2) < 0.005);
world.free();
engine.free();
