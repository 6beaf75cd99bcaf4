// What carom.threads.wasm asks of its host, on the thread that loads it (threads.js) and on each worker (thread_worker.js).
import { imports } from "./wasi.js";

const PAGE = 65536; // bytes
const GROWTH_PAGES = 16; // at least, if there are as many: all threads are told of it

/** @param own  of this thread alone */
export function sharedImports(compiled, memory, say, own) {
  const needs = imports(() => memory, say);
  Object.assign(needs.env, {
    memory,
    emscripten_get_now: () => performance.now(),
    emscripten_date_now: () => Date.now(),
    emscripten_check_blocking_allowed() {},
    emscripten_resize_heap(bytes) {
      const needed = Math.ceil((bytes >>> 0) / PAGE) - memory.grow(0); // what it is by now, in all threads
      if (needed <= 0) return 1;
      for (const pages of [Math.max(needed, GROWTH_PAGES), needed])
        try {
          memory.grow(pages);
          return 1;
        } catch (error) {
          if (!(error instanceof RangeError)) throw error;
        }
      return 0;
    },
    ...own,
  });
  for (const { module, name, kind } of WebAssembly.Module.imports(compiled))
    if (kind === "function")
      needs[module][name] ??= () => {
        throw new Error(`the engine stopped itself (${name})`);
      };
  return needs;
}
