// The WebAssembly module: its memory, its errors, and calls of the C interface.
import { ofNode } from "./node.js";
import { CaromError, cannotLoad } from "./errors.js";
import { CAROM_VERSION_MAJOR, CAROM_VERSION_MINOR, CAROM_VERSION_PATCH } from "./constants.js";
import { Structs } from "./structs.js";
import { imports } from "./wasi.js";

// What addresses are relative to: the page, else this file. Not with `new URL` in one expression, which bundlers take for a file of theirs.
const BASE = globalThis.document?.baseURI ?? globalThis.location?.href ?? import.meta.url;
const SCRATCH = 4096; // bytes: arguments of one call

export class Module {
  /** @param {WebAssembly.Exports} exports  with memory
   *  @param workers  that share the work of steps: threads.js */
  constructor(exports, workers = []) {
    this.raw = exports;
    this.workers = workers;
    exports._initialize?.();
    this.structs = new Structs(this.text(exports.carom_abi_manifest()));
    const errorSize = this.structs.size("carom_error");
    this.error = this.claim(errorSize);
    new Uint8Array(this.buffer, this.error, errorSize).fill(0);
    this.view.setUint32(this.error, errorSize, true);
    this.scratch = this.claim(SCRATCH);
    this.used = 0;
  }

  /** In a step, the calling one included. */
  get threads() {
    return this.workers.length + 1;
  }

  /** The module's memory is shared: side modules and typed arrays have to do with that. */
  get isShared() {
    return !!this.raw.carom_js_start;
  }

  get buffer() {
    return this.raw.memory.buffer;
  }

  /** Of all memory, also after it has grown. */
  get view() {
    if (this.cached?.buffer !== this.raw.memory.buffer) this.cached = new DataView(this.raw.memory.buffer);
    return this.cached;
  }

  claim(bytes) {
    const at = this.raw.malloc(Math.max(bytes, 8));
    if (!at) throw new RangeError(`no memory for ${bytes} bytes: free worlds, or simulate fewer bodies`);
    return at;
  }

  /** Zero-terminated text at a pointer. */
  text(at) {
    if (!at) return "";
    const bytes = new Uint8Array(this.buffer);
    return new TextDecoder().decode(bytes.slice(at, bytes.indexOf(0, at)));
  }

  /** Room for arguments of the call that `use` makes; gone when it returns. */
  frame(use) {
    const before = this.used;
    const claimed = [];
    const room = (bytes) => {
      const padded = (bytes + 15) & ~15;
      let at = this.scratch + this.used;
      if (this.used + padded <= SCRATCH) {
        this.used += padded;
      } else {
        at = this.claim(padded);
        claimed.push(at);
      }
      new Uint8Array(this.buffer, at, padded).fill(0);
      return at;
    };
    try {
      return use(room);
    } finally {
      this.used = before;
      for (const at of claimed) this.raw.free(at);
    }
  }

  /** @throws CaromError unless the result is OK */
  check(result, doing) {
    if (result === 0) return;
    const e = this.structs.read(this.view, "carom_error", this.error);
    const own = e.code === result;
    throw new CaromError(
      {
        code: result,
        result: this.text(this.raw.carom_result_name(result)),
        argument: own ? e.argument : 0,
        text: own && e.message ? e.message : this.text(this.raw.carom_result_name(result)),
        remedy: own && e.remedy ? e.remedy : this.text(this.raw.carom_result_remedy(result)),
        witness: own && e.has_witness ? { direction: e.witness_dir, point: e.witness_out } : null,
      },
      doing,
    );
  }

  /** A call whose last argument is the error. */
  call(name, ...args) {
    this.check(this.raw[name](...args, this.error), name);
  }

  doubles(at, count) {
    return Array.from(new Float64Array(this.buffer, at, count));
  }

  putDoubles(room, values, count, what) {
    if (!values || values.length !== count) throw new TypeError(`${what} takes ${count} numbers`);
    const at = room(8 * count);
    new Float64Array(this.buffer, at, count).set(values);
    return at;
  }

  putText(room, text) {
    const bytes = new TextEncoder().encode(text);
    const at = room(bytes.length + 1);
    new Uint8Array(this.buffer, at, bytes.length).set(bytes);
    return at;
  }

  /** A struct filled by its `*_init` where it has one, then by `values`. */
  put(room, name, values, init = `${name}_init`) {
    const at = room(this.structs.size(name));
    if (this.raw[init]) this.check(this.raw[init](at, this.structs.size(name)), init);
    else this.view.setUint32(at, this.structs.size(name), true);
    this.structs.write(this.view, name, at, values);
    return at;
  }

  /** What a getter writes into a struct: call(pointer, error). */
  get(name, call, doing) {
    return this.frame((room) => {
      const at = room(this.structs.size(name));
      this.view.setUint32(at, this.structs.size(name), true);
      this.check(call(at), doing);
      return this.structs.read(this.view, name, at);
    });
  }

  u64(call, doing) {
    return this.frame((room) => {
      const at = room(8);
      this.check(call(at), doing);
      return this.view.getBigUint64(at, true);
    });
  }

  /** Handles that a getter lists of a world.   @returns BigUint64Array */
  handles(getter, world) {
    return this.frame((room) => {
      const count = room(8);
      this.call(getter, world, 0, 0n, count);
      const n = Number(this.view.getBigUint64(count, true)),
        at = room(8 * n);
      if (n) this.call(getter, world, at, BigInt(n), count);
      return new BigUint64Array(this.buffer, at, n).slice();
    });
  }

  /** Records that a call copies out: call(dst, stride, capacity, count). */
  list(name, call, doing) {
    const size = this.structs.size(name);
    return this.frame((room) => {
      const count = room(8);
      this.check(call(0, BigInt(size), 0n, count), doing);
      const n = Number(this.view.getBigUint64(count, true));
      if (!n) return [];
      const at = room(n * size);
      this.check(call(at, BigInt(size), BigInt(n), count), doing);
      return Array.from({ length: n }, (_, i) => this.structs.read(this.view, name, at + i * size));
    });
  }
}

/** @param source  bytes, a Response, a compiled module, a URL, or nothing: dist/carom.wasm of this package */
export async function instantiate(source, say = (text) => console.error(text)) {
  let instance = null;
  const needs = imports(() => instance.exports.memory, say);
  const file = source ?? new URL("../dist/carom.wasm", import.meta.url);
  const compiled = await compileOurs(file);
  if (WebAssembly.Module.imports(compiled).some((i) => i.kind === "memory"))
    throw new TypeError("carom.threads.wasm was given, but no threads: load({ source, threads: 2 })");
  checkExports(compiled, file);
  instance = await WebAssembly.instantiate(compiled, needs);
  return checkVersion(new Module(instance.exports), file);
}

const VERSION = [CAROM_VERSION_MAJOR, CAROM_VERSION_MINOR, CAROM_VERSION_PATCH];
const TAKE_OURS = `give load() the module of this package, version ${VERSION.join(".")}: dist/carom.wasm, or dist/carom.threads.wasm for threads`;
const SERVE_IT =
  "build it (carom.wasm: npm run build in bindings/js), serve it beside the script, or give its address to load()";
const nameOf = (source) => (typeof source === "string" || source instanceof URL ? String(source) : "the module given");

/** @param source  what `compiled` was read from   @throws CaromError where it is the module of something else */
export function checkExports(compiled, source) {
  const has = new Set(WebAssembly.Module.exports(compiled).map((e) => e.name));
  const lacks = ["carom_abi_manifest", "carom_version", "malloc"].find((name) => !has.has(name));
  if (lacks) throw cannotLoad(nameOf(source), `it is no module of carom: it has no ${lacks}`, TAKE_OURS);
}

/** Is it one that this package can call?   @returns the module */
export function checkVersion(module, source) {
  const version = /^carom (\d+)\.(\d+)\.(\d+)$/m.exec(module.text(module.raw.carom_abi_manifest()));
  const [major, minor, patch] = version?.slice(1).map(Number) ?? [];
  if (
    major !== VERSION[0] ||
    (major === 0 && minor !== VERSION[1]) ||
    minor < VERSION[1] ||
    (minor === VERSION[1] && patch < VERSION[2])
  )
    throw cannotLoad(
      nameOf(source),
      `it is of ${version?.[0] ?? "no version"}, this package of ${VERSION.join(".")}`,
      TAKE_OURS,
    );
  return module;
}

/** A module of the engine.   @throws CaromError where there is none, or it is no module */
export async function compileOurs(source) {
  try {
    return await compile(source);
  } catch (problem) {
    if (!(problem instanceof WebAssembly.CompileError)) throw problem;
    throw cannotLoad(nameOf(source), `it is no WebAssembly (${problem.message.split("\n")[0]})`, TAKE_OURS);
  }
}

export async function compile(source) {
  return source instanceof WebAssembly.Module ? source : WebAssembly.compile(await read(source));
}

/** @param source  bytes, a Response or a URL   @returns bytes   @throws CaromError where there are none */
export async function read(source) {
  if (source instanceof ArrayBuffer || ArrayBuffer.isView(source)) return source;
  if (typeof Response !== "undefined" && source instanceof Response) return source.arrayBuffer();
  const url = new URL(source, BASE);
  const refuse = (why) => cannotLoad(url, why, SERVE_IT);
  if (url.protocol === "file:") {
    const { readFile } = await ofNode("fs/promises");
    return readFile(url).catch((problem) => {
      throw refuse(problem.code === "ENOENT" ? "there is no such file" : problem.message);
    });
  }
  const response = await fetch(url).catch((problem) => {
    throw refuse(problem.message);
  });
  if (!response.ok) throw refuse(`${response.status} ${response.statusText}`);
  return response.arrayBuffer();
}
