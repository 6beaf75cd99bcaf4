// A shape plugin as a WebAssembly side module: brought into the engine's memory and table, as a loader of shared objects would.
//   emcc -O2 -fPIC -sSIDE_MODULE=2 -sEXPORTED_FUNCTIONS=_carom_shape_plugin_v1 -Iinclude myshape.c -o myshape.wasm
//
// Tables of functions are a thread's own. With threads each brings a copy, with the same indices and data of its own,
// before it works on; wasm/threads.cpp tells it to.
import { compile, read } from "./module.js";

const ENTRY = "carom_shape_plugin_v1";
const STACK = 16384; // bytes, of a side module that wants one
const LARGEST = 1 << 26; // bytes of memory, entries of the table: a file that asks for more is damaged
const DAMAGED = "the side module's file is damaged";

/** Numbers of a wasm file, in turn. */
class Reader {
  constructor(bytes, at = 0) {
    Object.assign(this, { bytes, at });
  }
  byte() {
    if (this.at >= this.bytes.length) throw new TypeError(DAMAGED);
    return this.bytes[this.at++];
  }
  number() {
    let value = 0;
    for (let shift = 0; ; shift += 7) {
      if (shift > 28) throw new TypeError(DAMAGED);
      const byte = this.byte();
      value += (byte & 127) * 2 ** shift;
      if (byte < 128) return value;
    }
  }
  skip(bytes) {
    this.at += bytes;
  }
}

const leb = (value) => {
  const bytes = [];
  for (; value > 127; value >>>= 7) bytes.push((value & 127) | 128);
  return [...bytes, value];
};

/** What the linker wrote: how much memory and how many entries of the table it needs. */
function needs(compiled) {
  const [section] = WebAssembly.Module.customSections(compiled, "dylink.0");
  if (!section) throw new TypeError("no side module: build the shape with emcc -fPIC -sSIDE_MODULE=2");
  const from = new Reader(new Uint8Array(section));
  while (from.at < from.bytes.length) {
    const kind = from.number();
    const end = from.number() + from.at;
    if (kind === 1) {
      const [memory, align, table] = [from.number(), from.number(), from.number()];
      if (memory > LARGEST || align > 16 || table > LARGEST) throw new TypeError("the side module asks for too much");
      return { memory, align: 2 ** align, table };
    }
    from.at = end;
  }
  return { memory: 0, align: 1, table: 0 };
}

/** The same file, asking for memory that threads share: emcc writes that only with -pthread. The code is the same. */
export function askForShared(bytes) {
  const IMPORTS = 2;
  const KIND = { function: 0, table: 1, memory: 2, global: 3 };
  const from = new Reader(bytes, 8);
  while (from.at < bytes.length) {
    const section = from.at;
    const id = from.byte();
    const size = from.number();
    const start = from.at;
    if (id !== IMPORTS) {
      from.skip(size);
      continue;
    }
    for (let left = from.number(); left > 0; --left) {
      for (const _ of ["module", "name"]) from.skip(from.number());
      const kind = from.byte();
      if (kind === KIND.function) from.number();
      else if (kind === KIND.global) from.skip(2);
      else if (kind === KIND.table || kind === KIND.memory) {
        if (kind === KIND.table) from.skip(1);
        const limits = from.at;
        const hasMost = from.byte() & 1;
        const least = from.number();
        if (hasMost) from.number();
        if (kind === KIND.table) continue;
        const shared = [3, ...leb(least), ...leb(65536)];
        const content = [...bytes.slice(start, limits), ...shared, ...bytes.slice(from.at, start + size)];
        const head = [...bytes.slice(0, section), IMPORTS, ...leb(content.length)];
        return Uint8Array.from([...head, ...content, ...bytes.slice(start + size)]);
      } else throw new TypeError(DAMAGED);
    }
  }
  return bytes;
}

/** Room for one thread's copy, and what its code is given.   @param first  index of its functions in the table */
function place(wants, { claim, memory, table }, first) {
  const base = Math.ceil(claim(wants.memory + wants.align + STACK) / wants.align) * wants.align;
  new Uint8Array(memory.buffer, base, wants.memory).fill(0);
  if (table.length < first + wants.table) table.grow(first + wants.table - table.length);
  const constant = (value) => new WebAssembly.Global({ value: "i32" }, value);
  const env = {
    memory,
    __indirect_function_table: table,
    __memory_base: constant(base),
    __table_base: constant(first),
    __stack_pointer: new WebAssembly.Global({ value: "i32", mutable: true }, (base + wants.memory + STACK) & ~15),
  };
  return { base, env };
}

function start({ exports }) {
  exports.__wasm_apply_data_relocs?.();
  exports.__wasm_call_ctors?.();
}

/** @param module  the engine's   @param source  bytes, a URL, a Response; without threads a WebAssembly.Module, too
 *  @returns pointer to the carom_shape_plugin. The shape's code and data stay in memory for good.
 *  @throws TypeError where it is no shape, or calls what the engine does not give it */
export async function bring(module, source) {
  let bytes = null;
  if (module.isShared) {
    if (source instanceof WebAssembly.Module)
      throw new TypeError(
        "with threads a shape is brought from its bytes, a URL or a Response: each thread compiles it",
      );
    const given = await read(source);
    await WebAssembly.compile(given); // says what is wrong with it, if it is no module
    bytes = askForShared(new Uint8Array(given.buffer ?? given, given.byteOffset ?? 0, given.byteLength));
  }
  const compiled = await compile(bytes ?? source);
  const wants = needs(compiled);
  if (!WebAssembly.Module.exports(compiled).some((e) => e.name === ENTRY && e.kind === "global"))
    throw new TypeError(`the side module exports no ${ENTRY}: name it in -sEXPORTED_FUNCTIONS`);
  const { memory, __indirect_function_table: table } = module.raw;
  const first = table.length;
  const { base, env } = place(wants, { claim: (n) => module.claim(n), memory, table }, first);
  const unknown = WebAssembly.Module.imports(compiled).filter((i) => i.module !== "env" || !(i.name in env));
  if (unknown.length)
    throw new TypeError(
      `the shape calls ${unknown.map((i) => i.name).join(", ")}, which a side module has not: ` +
        "write it with + - * /, sqrt and fabs, or link it into carom.wasm",
    );
  const instance = await WebAssembly.instantiate(compiled, { env });
  start(instance);
  if (bytes) shareWithThreads(module, bytes, first);
  return base + instance.exports[ENTRY].value;
}

/** SideModule of wasm/threads.cpp: three words, then the bytes. */
function shareWithThreads(module, bytes, first) {
  const at = module.claim(12 + bytes.length);
  module.view.setUint32(at + 4, bytes.length, true);
  module.view.setUint32(at + 8, first, true);
  new Uint8Array(module.buffer, at + 12, bytes.length).set(bytes);
  module.raw.carom_js_share(at);
}

/** A worker's copy of what the main thread has brought.   @param at, size  its bytes   @param first  as there */
export function bringCopy({ raw, memory }, at, size, first) {
  memory.grow(0); // its buffer here may be of before another thread let it grow
  const compiled = new WebAssembly.Module(new Uint8Array(memory.buffer, at, size).slice());
  const claim = (bytes) => {
    const room = raw.malloc(bytes);
    if (!room) throw new RangeError(`no memory for a shape of ${bytes} bytes`);
    return room;
  };
  const { env } = place(needs(compiled), { claim, memory, table: raw.__indirect_function_table }, first);
  start(new WebAssembly.Instance(compiled, { env }));
}
