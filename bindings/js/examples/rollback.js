// Snapshots and rollback: a guess about a player was wrong, so 30 steps are made again with what was really done.
import assert from "node:assert/strict";
import { load } from "carom";

function play(world, ball, pushed, from, to) {
  for (let step = from; step < to; ++step) {
    if (pushed && step === 70) ball.setVelocity([2, 0, 0]);
    world.step(1 / 60);
  }
}

const carom = await load();
const engine = carom.engine(),
  world = engine.world();
world.ground();
const ball = world.body({ shape: engine.sphere(0.5), position: [0, 0.5, 0] });
play(world, ball, false, 0, 60);
const truth = world.fork(); // a world in which nothing is guessed
const saved = world.save();
play(world, ball, false, 60, 90); // the guess: no push
const guess = ball.position[0];
world.restore(saved);
play(world, ball, true, 60, 90);
play(truth, truth.bodies()[1], true, 60, 90); // bodies have the same order there
const x = ball.position[0],
  same = world.hash() === truth.hash() ? "yes" : "no";
console.log(`guessed x = ${guess.toFixed(2)} m, it was ${x.toFixed(2)} m; the same bits as without a guess: ${same}`);
assert(same === "yes" && Math.abs(guess) < 1e-6 && x > 0.4);
truth.free();
world.free();
engine.free();
