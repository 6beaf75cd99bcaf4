// carom.threads.wasm: workers that share its memory. Here is what emscripten's JavaScript would be: thread_worker.js is
// the other side, wasm/threads.cpp the pool that runs on them.
import { unsupported } from "./errors.js";
import { checkExports, checkVersion, compileOurs, Module } from "./module.js";
import { ofNode } from "./node.js";
import { sharedImports } from "./shared_imports.js";

const FIRST_PAGES = 64; // as wasm/CMakeLists.txt has it
const MOST_PAGES = [65536, 32768, 16384, 8192]; // all that there can be, else less: some browsers reserve it at once
const MOST_THREADS = 256;
const AUTO_THREADS = 4; // at most, of "auto": workers that wait for work take a core for moments

const AGAIN = 6; // EAGAIN

/** Why memory cannot be shared between threads here; null where it can. */
function whyAlone() {
  if (globalThis.crossOriginIsolated === false) return "the page is not cross-origin isolated";
  if (typeof SharedArrayBuffer === "undefined") return "there is no memory that threads can share";
  return null;
}

async function processors() {
  const { hardwareConcurrency } = globalThis.navigator ?? {};
  if (hardwareConcurrency) return hardwareConcurrency;
  const { availableParallelism, cpus } = await ofNode("os");
  return availableParallelism?.() ?? cpus().length;
}

/** @param asked  a number, or "auto"   @throws CaromError (UNSUPPORTED) where it cannot be, TypeError for no number */
export async function threadsToUse(asked) {
  const why = whyAlone();
  if (asked === "auto") return why ? 1 : Math.min(AUTO_THREADS, await processors());
  if (!Number.isInteger(asked) || asked < 1 || asked > MOST_THREADS)
    throw new TypeError(`threads is a whole number from 1 to ${MOST_THREADS}, or "auto"`);
  if (asked > 1 && why)
    throw unsupported(
      "load",
      0,
      `no ${asked} threads: ${why}`,
      "Serve the page and its scripts with the headers Cross-Origin-Opener-Policy: same-origin and " +
        'Cross-Origin-Embedder-Policy: require-corp, or load with threads: "auto"',
    );
  return asked;
}

function sharedMemory() {
  for (const maximum of MOST_PAGES)
    try {
      return new WebAssembly.Memory({ initial: FIRST_PAGES, maximum, shared: true });
    } catch (error) {
      if (!(error instanceof RangeError)) throw error;
    }
  throw new RangeError("no address space for shared memory: close other pages, or load without threads");
}

/** node's workers and browsers' differ in how they are listened to. */
function listen(worker, kind, act) {
  if (worker.on) worker.on(kind, act);
  else worker.addEventListener(kind, (event) => act(kind === "message" ? event.data : event));
}

/** A worker that has instantiated the module and waits for its thread. */
async function openWorker(compiled, memory) {
  const Worker = globalThis.Worker ?? (await ofNode("worker_threads")).Worker;
  const worker = new Worker(new URL("./thread_worker.js", import.meta.url), { type: "module", execArgv: [] });
  await new Promise((ready, fail) => {
    listen(worker, "message", (text) => (text === "ready" ? ready() : fail(new Error(text))));
    listen(worker, "error", (e) => fail(new Error(`a worker of carom did not start: ${e.message ?? "not found"}`)));
    worker.postMessage({ compiled, memory });
  }).catch((error) => {
    worker.terminate();
    throw error;
  });
  worker.unref?.(); // node: a program ends though its workers wait
  return worker;
}

/** @param source  as instantiate() takes it; by default dist/carom.threads.wasm of this package
 *  @param threads  2 or more */
export async function instantiateShared(source, threads, say = (text) => console.error(text)) {
  const file = source ?? new URL("../dist/carom.threads.wasm", import.meta.url);
  const compiled = await compileOurs(file);
  if (!WebAssembly.Module.imports(compiled).some((i) => i.kind === "memory"))
    throw new TypeError("the module given has no threads: give carom.threads.wasm, or ask for none");
  checkExports(compiled, file);
  const memory = sharedMemory();
  const opened = await Promise.allSettled(Array.from({ length: threads - 1 }, () => openWorker(compiled, memory)));
  const workers = opened.filter((o) => o.status === "fulfilled").map((o) => o.value);
  const idle = [...workers];
  let exports = null;
  const isPage = typeof document !== "undefined"; // whose thread may not sleep
  const needs = sharedImports(compiled, memory, say, {
    __emscripten_init_main_thread_js(thread) {
      exports._emscripten_thread_init(thread, isPage ? 1 : 0, 1, isPage ? 0 : 1, 0);
      exports.emscripten_tls_init();
    },
    __pthread_create_js(thread, _attributes, start, argument) {
      const worker = idle.pop();
      worker?.postMessage({ thread, start, argument, stack: exports.carom_js_stack_top(thread) });
      return worker ? 0 : AGAIN;
    },
  });
  try {
    if (workers.length < threads - 1) throw opened.find((o) => o.status === "rejected").reason;
    ({ exports } = await WebAssembly.instantiate(compiled, needs));
    exports.__wasm_call_ctors();
    if (!exports.carom_js_start(threads)) throw new Error(`no ${threads} threads to be had: ask for fewer`);
  } catch (error) {
    for (const worker of workers) worker.terminate();
    throw error;
  }
  return checkVersion(new Module({ ...exports, memory }, workers), file);
}

export function stopThreads(module) {
  if (!module.isShared) return;
  module.raw.carom_js_stop();
  for (const worker of module.workers) worker.terminate();
  module.workers = [];
}
