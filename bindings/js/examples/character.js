// A character walks over three steps of 0.2 m, and pushes a crate that stands there.
import assert from "node:assert/strict";
import { Character, load } from "carom";

const carom = await load();
const engine = carom.engine(),
  world = engine.world();
world.ground();
const step = engine.box(2, 0.1, 2);
for (let i = 0; i < 3; ++i) world.body({ shape: step, type: "static", position: [3 + 0.5 * i, 0.1 + 0.2 * i, 0] });
const crate = world.body({ shape: engine.box(0.2, 0.2, 0.2), position: [3, 0.8, 0] });
const walker = new Character(world, engine.capsule(0.3, 0.6), { position: [0, 1, 0], step_up: 0.25 });
for (let i = 0; i < 180; ++i) {
  world.step(1 / 60);
  walker.move([1.5, 0, 0], 1 / 60);
  walker.push(1 / 60);
}
const { ground } = walker,
  feet = walker.position[1] - walker.foot,
  pushed = crate.position[0] - 3;
console.log(
  `after 3 s it stands on ${ground} ground, ${feet.toFixed(2)} m up, and has pushed a crate by ${pushed.toFixed(1)} m`,
);
assert(ground === "firm" && Math.abs(feet - 0.6 - 0.0102) < 1e-4); // a skin of 0.01 m and 2 % lies between
assert(pushed > 1 && pushed < 2 && walker.contacts.some(({ body }) => body.handle === crate.handle));
world.free();
engine.free();
