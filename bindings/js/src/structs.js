// Structs of the C interface in the module's memory. Where a field lies is asked of the module
// (carom_abi_manifest()), since
// 32-bit pointers move fields.

/** Reads and writes of one field's kind. */
const KINDS = {
  u32: { size: 4, get: (v, at) => v.getUint32(at, true), set: (v, at, x) => v.setUint32(at, x, true) },
  i32: { size: 4, get: (v, at) => v.getInt32(at, true), set: (v, at, x) => v.setInt32(at, x, true) },
  u64: { size: 8, get: (v, at) => v.getBigUint64(at, true), set: (v, at, x) => v.setBigUint64(at, BigInt(x), true) },
  f64: { size: 8, get: (v, at) => v.getFloat64(at, true), set: (v, at, x) => v.setFloat64(at, x, true) },
  ptr: { size: 4, get: (v, at) => v.getUint32(at, true), set: (v, at, x) => v.setUint32(at, x, true) },
  fn: { size: 4, get: (v, at) => v.getUint32(at, true), set: (v, at, x) => v.setUint32(at, x, true) },
  char: { size: 1 },
};

export class Structs {
  /** @param {string} manifest  lines "name offset size kind" */
  constructor(manifest) {
    this.layouts = new Map();
    for (const line of manifest.split("\n")) {
      const [name, offset, size, spelled] = line.split(" ");
      if (!spelled) continue;
      if (spelled === "struct") {
        this.layouts.set(name, { size: Number(size), fields: new Map() });
        continue;
      }
      const [struct, field] = name.split(".");
      const [, kind, count] = /^(\w+)(?:\[(\d+)\])?$/.exec(spelled);
      this.layouts.get(struct).fields.set(field, { offset: Number(offset), kind, count: count ? Number(count) : 0 });
    }
  }

  size(name) {
    return this.layouts.get(name).size;
  }

  /** All fields as numbers, BigInts, strings of char arrays, arrays of arrays. */
  read(view, name, at) {
    const out = {};
    for (const [field, f] of this.layouts.get(name).fields) out[field] = this.field(view, f, at);
    return out;
  }

  field(view, { offset, kind, count }, at) {
    if (kind === "char") {
      const bytes = new Uint8Array(view.buffer, at + offset, count);
      const end = bytes.indexOf(0);
      return new TextDecoder().decode(bytes.slice(0, end < 0 ? count : end));
    }
    const { size, get } = KINDS[kind];
    if (!count) return get(view, at + offset);
    return Array.from({ length: count }, (_, i) => get(view, at + offset + i * size));
  }

  /** @param {object} values  by field; undefined: left as it is
   *  @throws TypeError where there is no such field or an array has another length */
  write(view, name, at, values) {
    const { fields } = this.layouts.get(name);
    for (const [field, value] of Object.entries(values)) {
      if (value === undefined) continue;
      const f = fields.get(field);
      if (!f) throw new TypeError(`${name} has no field "${field}"; it has ${[...fields.keys()].join(", ")}`);
      const { size, set } = KINDS[f.kind];
      if (!f.count) {
        set(view, at + f.offset, value);
        continue;
      }
      if (value.length !== f.count)
        throw new TypeError(`${name}.${field} takes ${f.count} numbers, not ${value.length}`);
      for (let i = 0; i < f.count; ++i) set(view, at + f.offset + i * size, value[i]);
    }
  }
}
