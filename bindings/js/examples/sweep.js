// Casts and overlaps: how far a crate can be moved before it touches, and what a blast of 2 m reaches.
import assert from "node:assert/strict";
import { load } from "carom";

const carom = await load();
const engine = carom.engine(),
  world = engine.world();
world.ground();
const wall = world.body({ shape: engine.box(0.5, 2, 2), type: "static", position: [5, 2, 0] });
const ball = engine.sphere(0.5),
  balls = [1, -2, 4].map((z) => world.body({ shape: ball, position: [0, 6, z] }));
for (let i = 0; i < 120; ++i) world.step(1 / 60); // they fall to the ground
const crate = engine.box(0.5, 0.5, 0.5); // of no body: it only asks
const hit = world.castShape(crate, [0, 1, 0], [8, 0, 0]); // time is a fraction of the way
const found = world.overlaps(engine.sphere(2), [0, 0.5, 0]).map(({ body }) => body.handle);
const reached = balls.filter(({ handle }) => found.includes(handle)).length;
console.log(`${(8 * hit.time).toFixed(2)} m to the wall, and ${reached} of ${balls.length} balls lie within 2 m`);
assert(hit.body.handle === wall.handle && Math.abs(8 * hit.time - 4) < 1e-4 && reached === 2);
world.free();
engine.free();
