// Threads: the same bits for any number of them, and what shared memory changes. In node;
// threads_page.test.js has a browser.
import { strict as assert } from "node:assert";
import { execFile } from "node:child_process";
import { existsSync } from "node:fs";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { promisify } from "node:util";
import { gzipSync } from "node:zlib";

import { heap } from "../bench/heap.mjs";
import { CaromError, load } from "../src/index.js";
import { askForShared } from "../src/side_module.js";

const file = new URL("../dist/carom.threads.wasm", import.meta.url);
const template = new URL("../dist/template.wasm", import.meta.url);
const folder = new URL("../../../out/scenes/", import.meta.url);
const skip = !existsSync(file) && "not built: cmake --preset wasm-threads && cmake --build --preset wasm-threads";
const packed = existsSync(new URL("index.json", folder));

/** Use the module with threads, then end them.   @param use  (carom) => ... */
const withThreads = (threads, use) => async (t) => {
  const carom = await load({ threads });
  try {
    await use(carom, t);
  } finally {
    carom.stopThreads();
  }
};

test("any number of threads has the bits of the module without", { skip }, async (t) => {
  const alone = heap(await load());
  for (const threads of [2, 4])
    await withThreads(threads, (carom) => {
      assert.equal(carom.threads, threads);
      assert.equal(carom.engine().threads, threads);
      assert.deepEqual(heap(carom), alone);
      assert.deepEqual(heap(carom, { threads: 1 }), alone, "an engine that steps alone");
      carom.stopThreads();
      assert.equal(carom.threads, 1);
      assert.deepEqual(heap(carom), alone, "after its threads have ended");
    })(t);
});

test(
  "scenes have the native build's bits on several threads",
  { skip: skip || (!packed && "not packed: carom pack out/scenes, in the root") },
  async (t) => {
    const index = JSON.parse(await readFile(new URL("index.json", folder)));
    let compared = 0;
    for (const threads of [2, 4])
      await withThreads(threads, async (carom) => {
        for (const name of ["falling", "pyramid", "bunnies", "ragdoll", "seesaw"]) {
          const row = index.find((r) => r.name === name);

          const engine = carom.engine(),
            world = engine.world();
          world.restore(await readFile(new URL(row.world, folder)));
          for (let step = 0; row.hashes[step]; ++step) {
            if (step) world.step(row.dt);
            assert.equal(world.hash(), row.hashes[step], `${name} on ${threads} threads, step ${step}`);
            ++compared;
          }
          (world.free(), engine.free());
        }
      })(t);
    assert.ok(compared > 900);
    t.diagnostic(`${compared} hashes`);
  },
);

test(
  "a world steps on while its threads are others' or ended",
  { skip },
  withThreads(3, (carom) => {
    const engine = carom.engine(),
      world = engine.world();
    world.ground();
    for (let i = 0; i < 200; ++i)
      world.body({ shape: engine.sphere(0.5), position: [i % 6, 1 + Math.floor(i / 36), Math.floor(i / 6) % 6] });
    const fork = world.fork();
    for (let i = 0; i < 20; ++i) (world.step(), fork.step());
    carom.stopThreads();
    for (let i = 0; i < 20; ++i) (world.step(), fork.step());
    assert.equal(world.hash(), fork.hash());
    (world.free(), fork.free(), engine.free());
  }),
);

test(
  "views and texts over shared memory, and its growth",
  { skip },
  withThreads(2, (carom) => {
    const engine = carom.engine(),
      world = engine.world();
    world.ground();
    const memory = carom.raw.memory;
    assert.ok(memory.buffer instanceof SharedArrayBuffer);
    const view = world.view("position");
    const shape = engine.box(0.1, 0.1, 0.1);
    const ball = world.body({ shape, position: [-1, 10, 0] });
    const first = view.update().array;
    const bytes = memory.buffer.byteLength;
    for (let i = 0; memory.buffer.byteLength === bytes; ++i) world.body({ shape, position: [i, 10, 0] });
    assert.deepEqual([...first.slice(3)], [-1, 10, 0], "what was taken before still reads the same memory");
    const n = world.bodyCount();
    assert.equal(view.update().array.length, 3 * n);
    assert.equal(view.array.buffer, memory.buffer);
    assert.deepEqual([...view.array.slice(3 * (n - 1))], [n - 3, 10, 0]);
    const speeds = world.view("linearVelocity", { bodies: [ball] }).update();
    speeds.array.set([3, 0, 0]);
    speeds.write();
    assert.deepEqual(ball.linearVelocity, [3, 0, 0]);
    world.step();
    const state = world.save();
    assert.ok(state.buffer instanceof ArrayBuffer, "a snapshot is a copy");
    const hash = world.hash();
    world.step();
    world.restore(state);
    assert.equal(world.hash(), hash);
    assert.throws(
      () => world.setDial("no_such", 1),
      (e) => e instanceof CaromError && e.remedy.length > 10 && /no_such/.test(e.text),
    );
    assert.ok(
      carom
        .dials()
        .find((d) => d.name === "solver")
        .choices.includes("soft_step"),
    );
    assert.match(carom.version, /^\d+\.\d+\.\d+$/);
    (view.free(), speeds.free(), world.free(), engine.free());
  }),
);

test(
  "memory that a step of several threads lets grow",
  { skip },
  withThreads(2, (carom) => {
    const engine = carom.engine(),
      world = engine.world();
    world.ground();
    const shape = engine.sphere(0.5);
    for (let i = 0; i < 6000; ++i)
      world.body({
        shape,
        position: [0.9 * (i % 20), 0.5 + 0.9 * Math.floor(i / 400), 0.9 * (Math.floor(i / 20) % 20)],
      });
    const before = carom.raw.memory.buffer.byteLength;
    world.step();
    assert.ok(carom.raw.memory.buffer.byteLength > before);
    assert.equal(world.view("position").update().array.length, 3 * world.bodyCount());
    assert.ok(world.contacts().length > 10000);
    (world.free(), engine.free());
  }),
);

test("memory that ends is an error with a remedy, also inside of a step", { skip }, async (t) => {
  const { Memory } = WebAssembly;
  const isOut = (e) => e instanceof CaromError && e.result === "CAROM_E_OUT_OF_MEMORY" && e.remedy.length > 10;
  for (const maximum of [120, 1300]) {
    WebAssembly.Memory = function (limits) {
      return new Memory({ ...limits, maximum });
    };
    await withThreads(3, (carom) => {
      const engine = carom.engine(),
        world = engine.world(),
        shape = engine.box(0.5, 0.5, 0.5);
      const fill = () => {
        for (let i = 0; i < 40000; ++i)
          world.body({ shape, position: [0.9 * (i % 20), 0.9 * Math.floor(i / 400), 0.9 * (Math.floor(i / 20) % 20)] });
      };
      if (maximum === 120) assert.throws(fill, isOut);
      else fill();
      assert.throws(() => world.step(1 / 60), isOut);
      for (const body of world.bodies().slice(100)) body.destroy();
      if (maximum > 120) world.step(1 / 60);
      (world.free(), engine.free());
    })(t).finally(() => (WebAssembly.Memory = Memory));
  }
});

test("a side module's shape is asked by all threads", { skip }, async (t) => {
  const run = async (carom) => {
    const { pointer } = await carom.bringShape(template);
    const shape = (engine) => engine.shape(engine.useShape({ pointer }), [0.3, 0.4]);
    return heap(carom, { shape });
  };
  const alone = await run(await load());
  for (const threads of [2, 4])
    await withThreads(threads, async (carom) => {
      heap(carom, { steps: 5 }); // workers that have worked before learn of it, too
      assert.deepEqual(await run(carom), alone);
      assert.deepEqual(await run(carom), alone, "a second copy has other indices");
      const wrong = [new Uint8Array([1, 2, 3]), WebAssembly.CompileError];
      await assert.rejects(carom.bringShape(wrong[0]), wrong[1]);
      await assert.rejects(carom.bringShape(file), TypeError);
      await assert.rejects(carom.bringShape(new WebAssembly.Module(await readFile(template))), /bytes/);
    })(t);
});

test("a side module is made to ask for shared memory", { skip }, async () => {
  const shared = askForShared(new Uint8Array(await readFile(template)));
  assert.ok(WebAssembly.validate(shared));
  assert.deepEqual(askForShared(shared), shared, "also one that does already");
  const cut = (n) => askForShared(shared.slice(0, n));
  for (const n of [9, 20, 60, 90])
    try {
      cut(n);
    } catch (error) {
      assert.ok(error instanceof TypeError);
    }
});

test("where threads cannot be had the exception says what to do", { skip }, async () => {
  const isUnsupported = (e) =>
    e instanceof CaromError && e.result === "CAROM_E_UNSUPPORTED" && /Cross-Origin-Opener-Policy/.test(e.remedy);
  globalThis.crossOriginIsolated = false; // as in a page without the two headers
  try {
    await assert.rejects(load({ threads: 2 }), isUnsupported);
    const carom = await load({ threads: "auto" });
    assert.equal(carom.threads, 1);
    assert.ok(!(carom.raw.memory.buffer instanceof SharedArrayBuffer));
  } finally {
    delete globalThis.crossOriginIsolated;
  }
  for (const threads of [0, 1.5, -1, 257, "many", null])
    await assert.rejects(load({ threads: threads ?? NaN }), TypeError);
  await assert.rejects(
    load({ threads: 2, source: new URL("../dist/carom.wasm", import.meta.url) }),
    /carom.threads.wasm/,
  );
  await assert.rejects(load(file), /threads: 2/);
  const carom = await load();
  assert.throws(
    () => carom.engine({ threads: 2 }),
    (e) => e instanceof CaromError && /load\(\{ threads: 2 \}\)/.test(e.remedy),
  );
  assert.equal(carom.engine({ threads: 1 }).threads, 1);
});

test("the C interface starts no threads beside the module's own", { skip }, () =>
  withThreads(2, (carom) => {
    const m = carom.module,
      engine = carom.engine({ threads: 1 });
    assert.throws(
      () =>
        m.frame((room) =>
          m.call("carom_engine_set_jobs", engine.pointer, m.put(room, "carom_jobs_desc", { threads: 2 })),
        ),
      (e) => e.result === "CAROM_E_LIMIT",
    );
    engine.free();
  })(),
);

test("a step whose worker has stopped throws, and does not wait for good", { skip }, async () => {
  const text = `import { load } from ${JSON.stringify(new URL("../src/index.js", import.meta.url).href)};
    import { heap } from ${JSON.stringify(new URL("../bench/heap.mjs", import.meta.url).href)};
    const carom = await load({ threads: 2 });
    const at = carom.module.claim(64); // what is no module: the worker throws when it is to bring it
    carom.module.view.setUint32(at + 4, 8, true);
    carom.raw.carom_js_share(at);
    try {
      for (let i = 0; i < 100; ++i) heap(carom, { steps: 10 });
    } catch (error) {
      console.log(error.constructor.name);
    }`;
  const run = promisify(execFile)(process.execPath, ["--input-type=module", "--eval", text], { timeout: 60000 });
  assert.equal((await run).stdout, "RuntimeError\n");
});

test("a program ends though its workers wait", { skip }, async () => {
  const text = `import { load } from ${JSON.stringify(new URL("../src/index.js", import.meta.url).href)};
    const carom = await load({ threads: 3 });
    console.log(carom.threads, carom.raw.memory.buffer.constructor.name);`;
  const run = promisify(execFile)(process.execPath, ["--input-type=module", "--eval", text], { timeout: 30000 });
  assert.equal((await run).stdout, "3 SharedArrayBuffer\n");
});

test("the module's size", { skip }, async (t) => {
  const bytes = await readFile(file);
  const gzip = gzipSync(bytes, { level: 9 }).length;
  t.diagnostic(`carom.threads.wasm: ${bytes.length} bytes, ${gzip} by gzip -9`);
  assert.ok(gzip < 0.76e6); // what it was when this was last looked at, and a little more
});
