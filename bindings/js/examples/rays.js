// Rays: what is below a point, how far, and that beside it lies the ground.
import assert from "node:assert/strict";
import { load } from "carom";

const carom = await load();
const engine = carom.engine(),
  world = engine.world();
const ground = world.ground();
const ball = world.body({ shape: engine.sphere(0.5), position: [0, 2, 0] });
for (let i = 0; i < 120; ++i) world.step(1 / 60);
const hit = world.castRay([0, 5, 0], [0, -1, 0]); // from, direction; time counts in lengths of the direction
const beside = world.castRay([3, 5, 0], [0, -1, 0]);
const above = world.castRay([0, 5, 0], [0, 1, 0]);
const far = beside.time.toFixed(2);
console.log(`${hit.time.toFixed(2)} m down lies the ball, beside it ${far} m down the ground, above it nothing`);
assert(hit.body.handle === ball.handle && Math.abs(hit.time - 4) < 0.01);
assert(beside.body.handle === ground.handle && Math.abs(beside.time - 5) < 1e-6 && above === null);
world.free();
engine.free();
