// What the module asks of its host: a clock, a way to say its last words, and refusals of all else. WASI's names.

const OK = 0;
const BAD_FILE = 8;
const NOT_SUPPORTED = 58;

/** @param {() => WebAssembly.Memory} memory  of the instance, once there is one
 *  @param {(text: string) => void} say  takes lines that C writes to stdout and stderr */
export function imports(memory, say) {
  const view = () => new DataView(memory().buffer);
  const wasi = {
    clock_time_get(id, _precision, out) {
      const now = id === 0 ? Date.now() : performance.now();
      view().setBigUint64(out, BigInt(Math.round(now * 1e6)), true);
      return OK;
    },
    clock_res_get(_id, out) {
      view().setBigUint64(out, 1000n, true);
      return OK;
    },
    fd_write(file, vectors, count, written) {
      if (file !== 1 && file !== 2) return BAD_FILE;
      const v = view();
      let bytes = 0,
        text = "";
      for (let i = 0; i < count; ++i) {
        const at = v.getUint32(vectors + 8 * i, true),
          size = v.getUint32(vectors + 8 * i + 4, true);
        text += new TextDecoder().decode(new Uint8Array(memory().buffer, at, size).slice());
        bytes += size;
      }
      if (text.trim()) say(text.trimEnd());
      v.setUint32(written, bytes, true);
      return OK;
    },
    proc_exit(code) {
      throw new Error(`the engine stopped itself (exit ${code})`);
    },
    environ_sizes_get(count, size) {
      view().setUint32(count, 0, true);
      view().setUint32(size, 0, true);
      return OK;
    },
    environ_get: () => OK,
    args_sizes_get(count, size) {
      view().setUint32(count, 0, true);
      view().setUint32(size, 0, true);
      return OK;
    },
    args_get: () => OK,
    random_get: () => NOT_SUPPORTED,
    sched_yield: () => OK,
  };
  const refuse = () => BAD_FILE;
  const names = ["fd_close", "fd_read", "fd_seek", "fd_fdstat_get", "fd_sync", "path_open"];
  for (const name of names) wasi[name] = refuse;
  return { wasi_snapshot_preview1: wasi, env: { emscripten_notify_memory_growth() {} } };
}
