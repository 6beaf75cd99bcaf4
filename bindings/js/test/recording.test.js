// Sessions that are recorded come out the same when they are done again; damaged ones are refused, and nothing hangs or crashes.
import { strict as assert } from "node:assert";
import { execFileSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import { CaromError, constants as C, load, Recording } from "../src/index.js";

const carom = await load();

/** A session of many kinds of calls, in a world that was not empty when it began. */
function session() {
  const engine = carom.engine(),
    world = engine.world(),
    m = world.module;
  world.ground();
  const first = world.body({ shape: engine.box(0.5, 0.5, 0.5), position: [0, 0.5, 0] });
  world.step();
  const recorder = world.record(),
    hashes = [];
  const step = (dt = 1 / 60) => (world.step(dt), hashes.push(world.hash()));
  step();
  const ball = world.body({
    shape: engine.sphere(0.3),
    position: [0.1, 2, 0],
    friction: 0.7,
    linear_velocity: [0, -1, 0],
  });
  const hull = world.body({ shape: engine.hull([0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1]), position: [2, 3, 0] });
  world.joint("ball", ball, hull, { at: [1, 2.5, 0] });
  step();
  world.setDial("substeps", 2);
  ball.addForce([0, 100, 0]);
  ball.addImpulse([1, 0, 0]);
  hull.setVelocity([0, 1, 0], [1, 0, 0]);
  step(1 / 120);
  world.gravity = [0, -5, 0];
  const view = world.view("position");
  view.update();
  view.array[3 * view.count - 2] += 1; // the last body, one metre up
  view.write();
  view.free();
  step();
  first.destroy();
  m.frame((room) => m.call("carom_world_set_wind", world.pointer, m.putDoubles(room, [3, 0, 0], 3, "wind")));
  m.call("carom_body_set_drag", world.pointer, ball.handle, 0.1, 0.2);
  world.setPreset(C.CAROM_PRESET_ACCURATE);
  for (let i = 0; i < 20; ++i) step();
  ball.setPose([0, 5, 0]);
  ball.setAttribute(C.CAROM_ATTRIBUTE_GRAVITY_FACTOR, 0.5);
  step();
  const bytes = recorder.end();
  (world.free(), engine.free());
  return { bytes, hashes };
}

/** @returns hashes after each step */
function play(bytes) {
  const engine = carom.engine();
  let world;
  try {
    const recording = new Recording(engine, bytes);
    world = recording.world();
    const got = recording.steps.map(({ dt }, step) => (recording.perform(world, step), world.step(dt), world.hash()));
    return { recording, got };
  } finally {
    world?.free();
    engine.free();
  }
}

test("a session comes out the same, in another engine", () => {
  const { bytes, hashes } = session();
  const { recording, got } = play(bytes);
  assert.equal(recording.ended, true);
  assert.deepEqual(got, hashes);
  assert.deepEqual(recording.hashes, hashes);
  assert.ok(new Set(recording.steps.flatMap((s) => s.calls.map((c) => c.name))).size >= 14);
});

test("a step that was done otherwise is seen", () => {
  const { bytes, hashes } = session();
  const engine = carom.engine(),
    recording = new Recording(engine, bytes),
    world = recording.world();
  for (let i = 0; i < recording.steps.length; ++i) {
    if (i !== 2) recording.perform(world, i); // the impulse is left out
    world.step(recording.steps[i].dt);
    assert.equal(world.hash() === hashes[i], i < 2, `step ${i}`);
  }
  (world.free(), engine.free());
});

test("damaged recordings are refused or end early; nothing else happens", () => {
  const { bytes } = session();
  assert.throws(() => play(new Uint8Array(0)), /no recording/);
  assert.throws(() => play(new Uint8Array(1000).fill(65)), /no recording/);
  let refused = 0,
    played = 0;
  const random = (() => {
    let state = 12345; // of a generator that is the same everywhere
    return (n) => ((state = (Math.imul(state, 1103515245) + 12345) >>> 0), Math.floor((state / 2 ** 32) * n));
  })();
  for (let i = 0; i < 400; ++i) {
    const wrong = bytes.slice(0, i % 4 ? bytes.length : 16 + random(bytes.length - 16));
    if (i % 4) wrong[16 + random(wrong.length - 16)] ^= 1 << random(8);
    try {
      (play(wrong), ++played);
    } catch (error) {
      assert.ok(error instanceof CaromError || error instanceof TypeError, error.stack);
      assert.ok(error.message.length > 20);
      ++refused;
    }
  }
  assert.ok(refused > 100 && played > 0, `${refused} refused, ${played} played`);
  assert.deepEqual(play(bytes).got, session().hashes, "the module is as it was");
});

const tool = ["demo", "test"]
  .map((p) => new URL(`../../../build/${p}/bin/carom`, import.meta.url).pathname)
  .find(existsSync);
test("native sessions come out the same here, and ours there", { skip: !tool && "no native carom is built" }, () => {
  const folder = mkdtempSync(join(tmpdir(), "carom-"));
  const native = join(folder, "native.rec"),
    ours = join(folder, "ours.rec");
  execFileSync(tool, ["run", "ragdoll", "--seconds", "1", "--quiet", "--record", native]);
  const { recording, got } = play(readFileSync(native));
  assert.equal(got.length, 60);
  assert.deepEqual(got, recording.hashes);
  writeFileSync(ours, session().bytes);
  assert.match(execFileSync(tool, ["replay", ours]).toString(), /every step as recorded/);
});

test("a recording that is not ended, or begun twice", () => {
  const engine = carom.engine(),
    world = engine.world();
  const recorder = world.record();
  assert.throws(() => world.record(), CaromError);
  world.step();
  assert.ok(recorder.end().length > 100);
  assert.throws(() => recorder.end(), CaromError);
  world.record({ states: true });
  (world.step(), world.free(), engine.free());
});
