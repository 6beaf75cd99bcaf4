// Threads in headless Chromium: the page's own thread steps, which may not sleep, and so does a worker's.
//   CHROMIUM names the browser where it is not /usr/bin/chromium
import { strict as assert } from "node:assert";
import { existsSync } from "node:fs";
import { test } from "node:test";
import { ISOLATED, serve } from "../../../src/site/serve.mjs";
import { heap } from "../bench/heap.mjs";
import { load } from "../src/index.js";

const executablePath = process.env.CHROMIUM ?? "/usr/bin/chromium";
const playwright = await import("playwright-core").catch(() => null);
const skip =
  (!playwright && "playwright-core is not installed: npm install") ||
  (!existsSync(executablePath) && `no browser at ${executablePath}`) ||
  (!existsSync(new URL("../dist/carom.threads.wasm", import.meta.url)) && "not built: cmake --preset wasm-threads");

/** @param headers  of the page and its files   @param use  (tab) => ... */
async function inPage(headers, use) {
  const server = await serve(0, new URL("../", import.meta.url).pathname, headers),
    browser = await playwright.chromium.launch({ executablePath, args: ["--no-sandbox"] }),
    errors = [];
  try {
    const tab = await browser.newPage();
    tab.on("console", (m) => m.type() === "error" && errors.push(m.text()));
    tab.on("pageerror", (e) => errors.push(e.message));
    await tab.goto(`http://localhost:${server.address().port}/README.md`); // any file: its scripts come from evaluate()
    await use(tab);
    assert.deepEqual(
      errors.filter((e) => !/favicon|404/.test(e)),
      [],
    );
  } finally {
    await browser.close();
    server.close();
  }
}

test("threads in a page that is cross-origin isolated", { skip, timeout: 120000 }, async () => {
  const carom = await load(),
    alone = heap(carom);
  const { pointer } = await carom.bringShape(new URL("../dist/template.wasm", import.meta.url));
  const shape = (engine) => engine.shape(engine.useShape({ pointer }), [0.3, 0.4]);
  const own = heap(carom, { shape, steps: 20 });
  await inPage(ISOLATED, async (tab) => {
    assert.equal(await tab.evaluate(() => crossOriginIsolated), true);
    for (const threads of [2, 4]) {
      const page = await tab.evaluate(async (threads) => {
        const { load } = await import("/src/index.js");
        const { heap } = await import("/bench/heap.mjs");
        const carom = await load({ threads });
        const isShared = carom.raw.memory.buffer instanceof SharedArrayBuffer,
          started = carom.threads,
          plain = heap(carom);
        const { pointer } = await carom.bringShape(`${location.origin}/dist/template.wasm`);
        const shape = (engine) => engine.shape(engine.useShape({ pointer }), [0.3, 0.4]);
        const own = heap(carom, { shape, steps: 20 });
        carom.stopThreads();
        return { isShared, started, plain, own, after: heap(carom) };
      }, threads);
      assert.deepEqual(page, { isShared: true, started: threads, plain: alone, own, after: alone });
    }
  });
});

test("threads of a worker of the page", { skip, timeout: 120000 }, async () => {
  const alone = heap(await load());
  await inPage(ISOLATED, async (tab) => {
    const hashes = await tab.evaluate(() => {
      const text = `const { load } = await import("${location.origin}/src/index.js");
        const { heap } = await import("${location.origin}/bench/heap.mjs");
        postMessage(heap(await load({ threads: 3 })));`;
      const worker = new Worker(URL.createObjectURL(new Blob([text], { type: "text/javascript" })), { type: "module" });
      return new Promise((tell, fail) => {
        worker.onmessage = (e) => tell(e.data);
        worker.onerror = (e) => fail(new Error(e.message));
      });
    });
    assert.deepEqual(hashes, alone);
  });
});

test("a page that is not isolated is told the two headers, and steps alone", { skip, timeout: 120000 }, async () => {
  await inPage({}, async (tab) => {
    const said = await tab.evaluate(async () => {
      const { load } = await import("/src/index.js");
      const remedy = await load({ threads: 2 }).catch((error) => error.remedy);
      return { remedy, threads: (await load({ threads: "auto" })).threads };
    });
    assert.match(said.remedy, /Cross-Origin-Opener-Policy: same-origin .*Cross-Origin-Embedder-Policy: require-corp/);
    assert.equal(said.threads, 1);
  });
});
