// An accuracy that is asked for: a pendulum is off by no more than a micrometre per second of motion.
import assert from "node:assert/strict";
import { load } from "carom";

const carom = await load();
const engine = carom.engine(),
  world = engine.world();
const ball = world.body({ shape: engine.sphere(0.1), position: [1, 0, 0] });
world.joint("ball", null, ball, { at: [0, 0, 0] });
world.setAccuracy({ place: 1e-6, turn: 1e-6 }); // m and rad per second
for (let i = 0; i < 120; ++i) world.step(1 / 60);
const [worst] = world.islands();
const x = ball.position[0],
  within = worst.share <= 1 ? "yes" : "no";
console.log(`after 2 s at x = ${x.toFixed(5)} m; the error is within what was asked: ${within}`);
assert(within === "yes" && Math.abs(x - 0.78507) < 5e-6); // by its equation of motion
world.free();
engine.free();
