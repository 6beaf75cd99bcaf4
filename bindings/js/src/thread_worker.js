// One thread of carom.threads.wasm: a worker with an instance of its own on the memory of all. It is told first what to
// instantiate, then which thread it is, and from then on it works or waits inside the module.
import { ofNode } from "./node.js";
import { sharedImports } from "./shared_imports.js";
import { bringCopy } from "./side_module.js";

let port = null; // to the thread that loads; no top-level await: bundlers make classic scripts of workers
let exports = null;

async function instantiate({ compiled, memory }) {
  const needs = sharedImports(compiled, memory, (text) => console.error(text), {
    carom_js_bring: (at, size, first) => bringCopy({ raw: exports, memory }, at, size, first),
  });
  ({ exports } = await WebAssembly.instantiate(compiled, needs));
  return "ready";
}

/** Its stack, its thread-local variables, its work: does not return. */
function run({ thread, start, argument, stack }) {
  exports._emscripten_thread_init(thread, 0, 0, 1, 0);
  exports.stackRestore(stack);
  exports.emscripten_tls_init();
  try {
    exports.__indirect_function_table.get(start)(argument);
  } catch (error) {
    console.error(`a thread of the engine stopped: ${error}`);
    exports.carom_js_crashed(); // a step that waits for it throws
  }
}

const hear = (data) =>
  data.compiled
    ? instantiate(data).then(
        (text) => port.postMessage(text),
        (error) => port.postMessage(String(error)),
      )
    : run(data);
if (globalThis.postMessage) {
  port = globalThis;
  port.addEventListener("message", (event) => hear(event.data));
} else {
  ofNode("worker_threads").then(({ parentPort }) => {
    port = parentPort;
    port.on("message", hear);
  });
}
