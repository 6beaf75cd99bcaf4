// Saving and loading: a world as bytes, for a file, goes on in another engine with the same bits.
import assert from "node:assert/strict";
import { load } from "carom";

const carom = await load();
const engine = carom.engine(),
  world = engine.world();
world.ground();
const box = engine.box(0.5, 0.5, 0.5);
for (let i = 0; i < 5; ++i) world.body({ shape: box, position: [0.1 * i, 0.5 + 1.1 * i, 0] });
for (let i = 0; i < 60; ++i) world.step(1 / 60);
const saved = world.save({ whole: true }); // with bodies and shapes: fs.writeFileSync("five.world", saved)
const other = carom.engine(),
  copy = other.world();
copy.restore(saved); // into a world in which nothing was made yet
for (let i = 0; i < 60; ++i) (world.step(1 / 60), copy.step(1 / 60));
const same = world.hash() === copy.hash() ? "yes" : "no",
  bodies = copy.bodies(),
  top = bodies[5].position[1];
console.log(`${bodies.length} bodies went on, the last one is at y = ${top.toFixed(2)} m; the same bits: ${same}`);
assert(same === "yes" && Math.abs(top - 4.5) < 0.01);
copy.free();
other.free();
world.free();
engine.free();
