// A shape plugin as a WebAssembly side module: brought into the engine's memory and table, as a loader of shared objects would.
//   emcc -O2 -fPIC -sSIDE_MODULE=2 -sEXPORTED_FUNCTIONS=_carom_shape_plugin_v1 -Iinclude myshape.c -o myshape.wasm

const ENTRY = "carom_shape_plugin_v1";
const STACK = 16384; // bytes, of a side module that wants one
const LARGEST = 1 << 26; // bytes of memory, entries of the table: a file that asks for more is damaged

/** What the linker wrote: how much memory and how many entries of the table it needs. */
function needs(compiled) {
  const [section] = WebAssembly.Module.customSections(compiled, "dylink.0");
  if (!section) throw new TypeError("no side module: build the shape with emcc -fPIC -sSIDE_MODULE=2");
  const bytes = new Uint8Array(section);
  let at = 0;
  const number = () => {
    let value = 0;
    for (let shift = 0; ; shift += 7) {
      if (at >= bytes.length || shift > 28) throw new TypeError("the side module's dylink section is damaged");
      const byte = bytes[at++];
      value += (byte & 127) * 2 ** shift;
      if (byte < 128) return value;
    }
  };
  while (at < bytes.length) {
    const kind = number();
    const end = number() + at;
    if (kind === 1) {
      const [memory, align, table] = [number(), number(), number()];
      if (memory > LARGEST || align > 16 || table > LARGEST) throw new TypeError("the side module asks for too much");
      return { memory, align: 2 ** align, table };
    }
    at = end;
  }
  return { memory: 0, align: 1, table: 0 };
}

/** @param module  the engine's   @param compiled  WebAssembly.Module
 *  @returns pointer to the carom_shape_plugin. The shape's code and data stay in memory for good.
 *  @throws TypeError where it is no shape, or calls what the engine does not give it */
export async function bring(module, compiled) {
  const wants = needs(compiled);
  if (!WebAssembly.Module.exports(compiled).some((e) => e.name === ENTRY && e.kind === "global"))
    throw new TypeError(`the side module exports no ${ENTRY}: name it in -sEXPORTED_FUNCTIONS`);
  const table = module.raw.__indirect_function_table;
  const base = Math.ceil(module.claim(wants.memory + wants.align + STACK) / wants.align) * wants.align;
  new Uint8Array(module.buffer, base, wants.memory).fill(0);
  const first = table.grow(wants.table);
  const constant = (value) => new WebAssembly.Global({ value: "i32" }, value);
  const given = {
    memory: module.raw.memory,
    __indirect_function_table: table,
    __memory_base: constant(base),
    __table_base: constant(first),
    __stack_pointer: new WebAssembly.Global({ value: "i32", mutable: true }, (base + wants.memory + STACK) & ~15),
  };
  const unknown = WebAssembly.Module.imports(compiled).filter((i) => i.module !== "env" || !(i.name in given));
  if (unknown.length)
    throw new TypeError(
      `the shape calls ${unknown.map((i) => i.name).join(", ")}, which a side module has not: ` +
        "write it with + - * /, sqrt and fabs, or link it into carom.wasm",
    );
  const { exports } = await WebAssembly.instantiate(compiled, { env: given });
  exports.__wasm_apply_data_relocs?.();
  exports.__wasm_call_ctors?.();
  return base + exports[ENTRY].value;
}
