// Ground of a height field, in whose valley a ball comes to rest, and of triangles, down which a crate slides.
import assert from "node:assert/strict";
import { load } from "carom";

const carom = await load();
const engine = carom.engine(),
  world = engine.world();
const nine = [-4, -3, -2, -1, 0, 1, 2, 3, 4];
const valley = nine.flatMap((z) => nine.map((x) => 0.25 * Math.max(0, Math.hypot(x, z) - 1))); // m, rows along z
world.body({ shape: engine.heightField(valley, 9, [1, 1]), type: "static", position: [-4, 0, -4] }); // of its corner
const about = { position: [3, 2, 1], linear_damping: 0.5, angular_damping: 0.5 };
const ball = world.body({ shape: engine.sphere(0.5), ...about });
const tilt = Math.PI / 6,
  s = Math.sin(tilt),
  c = Math.cos(tilt);
const profile = [
  [6, 4],
  [6 + 9 * c, 4 - 9 * s],
  [6 + 9 * c, 7 - 9 * s],
]; // a wall at its end
const corners = profile.flatMap(([x, y]) => [x, y, -2, x, y, 2]);
world.body({ shape: engine.mesh(corners, [0, 1, 2, 2, 1, 3, 2, 3, 4, 4, 3, 5]), type: "static" });
const start = [6 + c + 0.5 * s, 4 - s + 0.5 * c, 0], // 1 m down
  orientation = [0, 0, -Math.sin(tilt / 2), Math.cos(tilt / 2)];
const crate = world.body({ shape: engine.box(0.5, 0.5, 0.5), position: start, orientation, friction: 0 });
for (let i = 0; i < 60; ++i) world.step(1 / 60);
const way = Math.hypot(...crate.position.map((x, k) => x - start[k]));
for (let i = 0; i < 600; ++i) world.step(1 / 60);
const [x, y] = ball.position;
console.log(`the crate slides by ${way.toFixed(2)} m in 1 s, and the ball lies at y = ${y.toFixed(2)} m`);
assert(Math.abs(way - (9.81 * s) / 2) < 0.01 && Math.abs(y - 0.5) < 0.005 && Math.abs(x) < 2);
world.free();
engine.free();
