// Bulk arrays: velocities of 1000 balls are set in one call, their positions read in one.
import assert from "node:assert/strict";
import { load } from "carom";

const carom = await load();
const engine = carom.engine(),
  world = engine.world();
const sphere = engine.sphere(0.5),
  balls = [];
for (let i = 0; i < 1000; ++i) {
  const position = [2 * Math.floor(i / 100), 5 + 2 * (Math.floor(i / 10) % 10), 2 * (i % 10)];
  balls.push(world.body({ shape: sphere, position }));
}
const velocities = world.view("linearVelocity", { bodies: balls }).update();
for (let i = 0; i < balls.length; ++i) velocities.array[3 * i + 1] = 9.81 / 2; // in the module's memory
velocities.write();
const positions = world.view("position", { bodies: balls });
const meanHeight = () => positions.update().array.reduce((sum, x, i) => sum + (i % 3 === 1 ? x : 0), 0) / balls.length;
const height = [meanHeight()];
for (let i = 0; i < 2; ++i) {
  for (let step = 0; step < 30; ++step) world.step(1 / 60);
  height.push(meanHeight());
}
const rise = height[1] - height[0],
  off = Math.abs(height[2] - height[0]);
console.log(`${balls.length} balls rise by ${rise.toFixed(3)} m and are back after 1 s, ${off.toFixed(3)} m off`);
assert(Math.abs(rise - 9.81 / 8) < 1e-9 && off < 1e-9);
world.free();
engine.free();
