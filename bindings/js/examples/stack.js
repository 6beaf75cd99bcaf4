// Bodies and stacks: ten boxes stand on each other, to a millimetre a box.
import assert from "node:assert/strict";
import { load } from "carom";

const carom = await load();
const engine = carom.engine(),
  world = engine.world();
world.ground();
const box = engine.box(0.5, 0.5, 0.5); // half extents, m; of 1000 kg/m^3, where nothing else is said
const boxes = [];
for (let i = 0; i < 10; ++i) boxes.push(world.body({ shape: box, position: [0, 0.52 + 1.02 * i, 0] }));
for (let i = 0; i < 180; ++i) world.step(1 / 60);
const [x, y, z] = boxes[9].position;
console.log(`10 boxes of ${boxes[0].mass.toFixed(0)} kg stand for 3 s, the top one at y = ${y.toFixed(2)} m`);
assert(Math.abs(y - 9.5) < 0.01 && Math.abs(x) < 0.01 && Math.abs(z) < 0.01);
world.free();
engine.free();
