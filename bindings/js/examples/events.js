// Events of contacts: when a ball that falls 2 m hits the ground, and how fast.
import assert from "node:assert/strict";
import { load } from "carom";
import { CAROM_EVENTS_CONTACT as CONTACT } from "carom/constants";

const carom = await load();
const engine = carom.engine(),
  world = engine.world();
world.ground();
const ball = world.body({ shape: engine.sphere(0.5), position: [0, 2.5, 0] });
world.collectEvents(CONTACT, 1); // m/s: what is faster is a hit
const hits = [];
for (let step = 1; step <= 60; ++step) {
  world.step(1 / 60); // events are those of the last step
  for (const event of world.contactEvents()) if (event.kind === "hit") hits.push({ ...event, at: step / 60 });
}
const [{ at, approach_speed: speed, body_a, body_b }] = hits;
console.log(`${hits.length} hit, after ${at.toFixed(2)} s, at ${speed.toFixed(2)} m/s`);
const fall = Math.sqrt((2 * 2) / 9.81); // s
assert(hits.length === 1 && [body_a.handle, body_b.handle].includes(ball.handle));
assert(Math.abs(at - fall) < 2 / 60 && Math.abs(speed - 9.81 * fall) < 9.81 / 60);
world.free();
engine.free();
