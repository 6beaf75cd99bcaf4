// The package under node: what a page or a program does with it, and what happens when it is done wrong.
import { strict as assert } from "node:assert";
import { gzipSync } from "node:zlib";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { CaromError, constants as C, load } from "../src/index.js";

const carom = await load();

function stage() {
  const engine = carom.engine();
  const world = engine.world();
  world.ground();
  return {
    engine,
    world,
    free() {
      (world.free(), engine.free());
    },
  };
}

test("a ball falls and lies", () => {
  const s = stage();
  const ball = s.world.body({ shape: s.engine.sphere(0.5), position: [0, 3, 0] });
  for (let i = 0; i < 180; ++i) s.world.step();
  assert.ok(Math.abs(ball.position[1] - 0.5) < 1e-2);
  assert.ok(Math.abs(ball.mass - (1000 * 4 * Math.PI) / 3 / 8) < 1e-9 * ball.mass);
  assert.equal(ball.type, "dynamic");
  assert.match(s.world.hash(), /^[0-9a-f]{16}$/);
  s.free();
});

test("a hull of shapes is a sweep, and says what it is", () => {
  const engine = carom.engine();
  const ball = engine.sphere(0.25);
  const sweep = engine.hullOf([
    { shape: ball, position: [0, -1, 0] },
    { shape: ball, position: [0, 1, 0] },
  ]);
  const capsule = engine.capsule(0.25, 1).info.volume;
  assert.equal(sweep.info.kind, "hull_of");
  assert.ok(sweep.info.volume_min <= capsule && capsule <= sweep.info.volume_max);
  const crate = engine.hullOf([{ shape: engine.box(1, 1, 1), scale: [1, -2, 1] }]);
  assert.ok(Math.abs(crate.info.volume - 16) <= 12 * 16 * 2 ** -53, `${crate.info.volume}`); // a sum over twelve triangles
  assert.equal(engine.taperedCapsule(0.5, 0.25, 1).info.aabb_max[1], 1.25);
  assert.throws(() => engine.hullOf([]), CaromError);
  engine.free();
});

test("mass, centre and inertia that are given are the body's", () => {
  const engine = carom.engine(),
    world = engine.world({ gravity: [0, 0, 0] });
  const desc = { mass: 2, inertia: [1, 0, 0, 0, 2, 0, 0, 0, 2.5] };
  const body = world.body({ ...desc, center: [0.5, 0, 0] });
  assert.equal(body.mass, 2);
  assert.deepEqual(body.center, [0.5, 0, 0]);
  // A torque of 1 N m for a second about y of inertia 2 kg m^2; without the inertia it would not turn at all.
  const turned = world.body(desc);
  for (let i = 0; i < 60; ++i) (turned.addForce([0, 0, 0], [0, 1, 0]), world.step(1 / 60));
  assert.ok(Math.abs(turned.angularVelocity[1] - 0.5) < 1e-9, `${turned.angularVelocity}`);
  assert.throws(() => world.body({ inertia: desc.inertia }), CaromError);
  (world.free(), engine.free());
});

test("free fall is the closed form of the integrator", () => {
  const engine = carom.engine(),
    world = engine.world({ gravity: [0, -10, 0] });
  const point = world.body();
  for (let i = 0; i < 60; ++i) world.step(1 / 60);
  // Between the sums of explicit and of semi-implicit Euler, whatever the dials: g t^2 / 2 (1 +- dt / t).
  assert.ok(Math.abs(point.position[1] + 5) <= 5 / 60 + 1e-12);
  assert.ok(Math.abs(point.linearVelocity[1] + 10) < 1e-12);
  (world.free(), engine.free());
});

test("the ledger's causes are the change of the state, and change no bit", () => {
  const worlds = [false, true].map((kept) => {
    const s = stage();
    s.world.body({ shape: s.engine.box(0.5, 0.5, 0.5), position: [0, 2, 0], angular_velocity: [1, 2, 0] });
    if (kept) s.world.keepLedger();
    return s;
  });
  const [plain, { world }] = worlds;
  let first;
  const kinetic = () => world.report().linear_energy + world.report().angular_energy;
  for (let i = 0; i < 60; ++i) {
    (plain.world.step(), world.step());
    assert.equal(world.hash(), plain.world.hash());
    const before = world.ledger().reduce((sum, cause) => sum + cause.total_kinetic, 0);
    first ??= kinetic() - before;
    // The box of 1,000 kg falls 1.5 m: about 15 kJ, of which sums keep twelve digits.
    assert.ok(Math.abs(first + before - kinetic()) < 1e-8);
  }
  assert.ok(world.ledger().find((cause) => cause.name === "contact").total_kinetic < -1000);
  assert.deepEqual(plain.world.ledger(), []);
  for (const s of worlds) s.free();
});

test("errors are exceptions with a remedy, and change nothing", () => {
  const s = stage();
  const before = s.world.hash();
  for (const wrong of [
    () => s.engine.sphere(-1),
    () => s.engine.sphere(NaN),
    () => s.engine.shape("no_such", [1]),
    () => s.world.step(NaN),
    () => s.world.step(2),
    () => s.world.setDial("substeps", 1e9),
    () => s.world.setDial("no_such", 1),
    () => s.world.body({ position: [0, Infinity, 0] }),
    () => s.world.restore(new Uint8Array([1, 2, 3])),
    () => s.engine.free(),
  ])
    assert.throws(
      wrong,
      (e) => e instanceof CaromError && e.code < 0 && e.result.startsWith("CAROM_E_") && e.remedy.length > 10,
    );
  for (const wrong of [
    () => s.world.body({ position: [0, 1] }),
    () => s.world.body({ positoin: [0, 1, 0] }),
    () => s.world.body({ type: "dinamic" }),
    () => s.world.view("speed"),
    () => s.world.joint("glue", null, null),
  ])
    assert.throws(wrong, TypeError);
  assert.equal(s.world.bodyCount(), 1);
  assert.equal(s.world.hash(), before);
  s.free();
  assert.throws(() => s.world.step(), /freed/);
});

test("a stale handle is told", () => {
  const s = stage(),
    ball = s.world.body({ shape: s.engine.sphere(1), position: [0, 5, 0] });
  ball.destroy();
  assert.throws(
    () => ball.position,
    (e) => e.result === "CAROM_E_STALE_HANDLE",
  );
  s.free();
});

test("views survive growth of memory", () => {
  const s = stage();
  const view = s.world.view("position");
  const shape = s.engine.box(0.1, 0.1, 0.1);
  const first = view.update().array;
  const bytes = carom.raw.memory.buffer.byteLength;
  for (let i = 0; carom.raw.memory.buffer.byteLength === bytes; ++i) s.world.body({ shape, position: [i, 10, 0] });
  assert.equal(first.length, 0, "what was taken before is detached");
  const n = s.world.bodyCount();
  assert.equal(view.update().array.length, 3 * n);
  assert.deepEqual([...view.array.slice(3 * (n - 1))], [n - 2, 10, 0]);
  const floats = s.world.view("position", { scalar: "f32", bodies: s.world.bodies().slice(-2) }).update();
  assert.ok(floats.array instanceof Float32Array);
  assert.deepEqual([...floats.array], [n - 3, 10, 0, n - 2, 10, 0]);
  (view.free(), floats.free(), s.free());
});

test("views write", () => {
  const s = stage(),
    ball = s.world.body({ position: [0, 5, 0] });
  const view = s.world.view("linearVelocity", { bodies: [ball] }).update();
  view.array[0] = 3;
  view.write();
  assert.deepEqual(ball.linearVelocity, [3, 0, 0]);
  view.array[0] = NaN;
  assert.throws(() => view.write(), CaromError);
  (view.free(), s.free());
});

test("what a host says of a body goes with it through a snapshot", () => {
  const engine = carom.engine(),
    world = engine.world(),
    ball = world.body({ shape: engine.sphere(1), user: 7n });
  assert.equal(ball.user, 7n);
  for (const value of [0n, 41n, (1n << 64n) - 1n]) ((ball.user = value), assert.equal(ball.user, value));
  assert.throws(() => (ball.user = 7), TypeError); // 64 bits are a bigint
  const other = carom.engine(),
    copy = other.world();
  copy.restore(world.save({ whole: true }));
  assert.equal(copy.bodies()[0].user, (1n << 64n) - 1n);
  (copy.free(), other.free(), world.free(), engine.free());
});

test("snapshots, forks: the same bits go on", () => {
  const s = stage();
  for (let i = 0; i < 30; ++i)
    s.world.body({ shape: s.engine.box(0.3, 0.3, 0.3), position: [0.1 * (i % 3), 1 + 0.7 * i, 0] });
  for (let i = 0; i < 20; ++i) s.world.step();
  const state = s.world.save(),
    whole = s.world.save({ whole: true }),
    fork = s.world.fork();
  const other = carom.engine(),
    copy = other.world();
  copy.restore(whole);
  const hashes = [];
  for (let i = 0; i < 40; ++i) (s.world.step(), hashes.push(s.world.hash()));
  s.world.restore(state);
  for (const world of [s.world, fork, copy])
    for (let i = 0; i < 40; ++i) {
      world.step();
      assert.equal(world.hash(), hashes[i]);
    }
  assert.equal(copy.colliders().length, 31);
  assert.deepEqual(new Set(copy.colliders().map((c) => c.body.world)), new Set([copy]));
  (fork.free(), copy.free(), other.free(), s.free());
});

test("rays, plan, report, lines, dials, joints", () => {
  const s = stage();
  const ball = s.world.body({ shape: s.engine.sphere(0.5), position: [0, 2, 0] });
  const hit = s.world.castRay([0, 5, 0], [0, -1, 0]);
  assert.ok(Math.abs(hit.time - 2.5) < 1e-6 && hit.body.handle === ball.handle);
  assert.equal(s.world.castRay([0, 5, 0], [0, 1, 0]), null);
  const joint = s.world.joint("ball", null, ball, { at: [0, 3, 0] });
  s.world.step();
  assert.ok(s.world.plan().some((line) => line.name === "gravity" && line.runs === 1));
  assert.equal(s.world.report().bodies, 2n);
  assert.ok(joint.state.gap < 1e-3);
  assert.ok(s.world.draw(C.CAROM_DRAW_JOINTS).points.length > 0);
  const [found, ...others] = s.world.joints();
  assert.equal(found.handle, joint.handle);
  assert.equal(others.length, 0);
  assert.deepEqual([found.desc.body_a, found.desc.body_b], [0n, ball.handle]);
  found.destroy();
  assert.deepEqual(s.world.joints(), []);
  assert.ok(s.world.draw(C.CAROM_DRAW_SHAPES).points.length > 0);
  const dials = carom.dials();
  const solver = dials.find((d) => d.name === "solver");
  assert.ok(solver.choices.includes("soft_step") && solver.summary.length > 10);
  s.world.setDial("substeps", 8);
  assert.equal(s.world.dial("substeps"), 8);
  assert.ok(carom.presets().includes("accurate") && carom.stages().includes("solve"));
  s.free();
});

test("a shape of one's own is a side module", async () => {
  const s = stage();
  const id = await s.engine.loadShape(new URL("../dist/template.wasm", import.meta.url));
  const top = s.engine.shape(id, [0.5, 1]);
  // Two cones of radius 0.5 and height 1: pi r^2 h / 3 each.
  const { volume, volume_min, volume_max } = top.info;
  assert.ok(volume_min <= (Math.PI * 0.25 * 2) / 3 && (Math.PI * 0.25 * 2) / 3 <= volume_max && volume > 0);
  assert.deepEqual([...top.supports([0, 1, 0, 1, 0, 0])], [0, 1, 0, 0.5, 0, 0]);
  const body = s.world.body({ shape: top, position: [0, 2, 0] });
  for (let i = 0; i < 120; ++i) s.world.step();
  assert.ok(body.position[1] > 0.2 && body.position[1] < 1.01);
  await assert.rejects(s.engine.loadShape(new URL("../dist/template.wasm", import.meta.url)), CaromError);
  await assert.rejects(s.engine.loadShape(new URL("../dist/carom.wasm", import.meta.url)), TypeError);
  await assert.rejects(s.engine.loadShape(new Uint8Array([1, 2, 3])), WebAssembly.CompileError);
  s.free();
});

test("a thousand worlds leave no memory behind", () => {
  const engine = carom.engine();
  const once = () => {
    const world = engine.world();
    (world.body({ shape: engine.sphere(1), position: [0, 3, 0] }), world.ground());
    for (let i = 0; i < 5; ++i) world.step();
    world.free();
  };
  for (let i = 0; i < 50; ++i) once();
  const before = carom.raw.memory.buffer.byteLength;
  for (let i = 0; i < 1000; ++i) once();
  assert.equal(carom.raw.memory.buffer.byteLength, before);
  engine.free();
});

test("the module's size", async (t) => {
  const bytes = await readFile(new URL("../dist/carom.wasm", import.meta.url));
  const gzip = gzipSync(bytes, { level: 9 }).length;
  t.diagnostic(`carom.wasm: ${bytes.length} bytes, ${gzip} by gzip -9`);
  assert.ok(gzip < 0.9e6); // what it was when batches and hulls of shapes came, and a little more
});
