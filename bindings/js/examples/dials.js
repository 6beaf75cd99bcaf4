// Dials: a pendulum of a preset for crowds, and the same with one dial turned.
import assert from "node:assert/strict";
import { load } from "carom";
import { CAROM_PRESET_FAST as FAST } from "carom/constants";

const carom = await load();

/** m, after 2 s; where the ball should be follows from the equation of motion. */
function error(dials) {
  const engine = carom.engine(),
    world = engine.world();
  world.setPreset(FAST);
  for (const [name, value] of Object.entries(dials)) world.setDial(name, value);
  const ball = world.body({ shape: engine.sphere(0.1), position: [1, 0, 0] });
  world.joint("ball", null, ball, { at: [0, 0, 0] });
  for (let i = 0; i < 120; ++i) world.step(1 / 60);
  const off = Math.abs(ball.position[0] - 0.7850683);
  world.free();
  engine.free();
  return off;
}

const fast = error({}),
  finer = error({ substeps: 8 }),
  exact = error({ substeps: 8, joint_order: 4 });
const [a, b, word] = [(1e3 * fast).toFixed(2), (1e3 * finer).toFixed(3), exact < 1e-6 ? "yes" : "no"];
console.log(`off by ${a} mm; with 8 substeps by ${b} mm; of order 4 by less than 1 um: ${word}`);
assert(fast > 1e-3 && 1e-3 > 10 * finer && exact < 1e-6);
