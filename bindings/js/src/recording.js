// Recorded sessions (carom/record.h): written here, or by any host, and done again step by step.
import { CALLS } from "./recorded_calls.js";
import { callback } from "./callback.js";
import * as C from "./constants.js";

const MAGIC = "CAROMREC",
  HEADER = 16; // bytes, of the file and of each record
const [BEGIN, SHAPE, NAME, CALL, HASH, , END] = [1, 2, 3, 4, 5, 6, 7]; // kinds of records
const WIDTHS = [3, 4, 7, 3, 3, 6, 6, 3, 1]; // numbers of each CAROM_FIELD_*

function damaged(what) {
  return new TypeError(
    `the recording is damaged: ${what}; record the session anew, or take the file again from where it was written`,
  );
}

/** Numbers and lists of one call, in the order in which they were written. */
class Arguments {
  constructor(bytes) {
    this.bytes = bytes;
    this.view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
    this.at = 0;
  }
  #take(size) {
    if (size > this.bytes.length - this.at) throw damaged("a call's arguments end too early");
    this.at += size;
    return this.at - size;
  }
  number(type) {
    if (type === "double") return this.view.getFloat64(this.#take(8), true);
    if (type === "uint64_t") return this.view.getBigUint64(this.#take(8), true);
    return type === "int32_t" ? this.view.getInt32(this.#take(4), true) : this.view.getUint32(this.#take(4), true);
  }
  handle() {
    return this.number("uint64_t");
  }
  /** @returns bytes, or null where NULL was given */
  list(element) {
    const present = this.number("uint64_t");
    if (present > 1n) throw damaged("a list is neither there nor not");
    if (!present) return null;
    const n = this.number("uint64_t");
    if (n > BigInt(this.bytes.length)) throw damaged("a list is too long");
    const size = Number(n) * element,
      from = this.#take(size);
    return this.bytes.subarray(from, from + size);
  }
}

/** A session that was recorded: the world as it was, and all that was done to it. */
export class Recording {
  /** Everything but the steps is read at once: what is damaged is told here.
   *  @param engine  keeps the shapes of the recording   @throws TypeError, CaromError (a plugin that is not there) */
  constructor(engine, bytes) {
    this.engine = engine;
    this.shapes = new Map(); // recorded handle -> ours
    /** [{ dt: s, calls }]: what was done before each step. */
    this.steps = [];
    /** Of the state after each step, 16 hexadecimal digits. */
    this.hashes = [];
    this.ended = false;
    this.#read(bytes);
  }

  /** A world as the recording begins. */
  world() {
    const world = this.engine.world();
    try {
      world.restore(this.start);
    } catch (error) {
      world.free();
      throw error;
    }
    return world;
  }

  /** What was done before a step, once more; the step itself is not taken.
   *  @param step  from 0   @returns whether anything was done
   *  @throws CaromError where a call is refused that went well then: the world is not as it was */
  perform(world, step) {
    const calls = this.steps[step]?.calls ?? [];
    for (const { name, content } of calls) this.#make(world, name, content);
    return calls.length > 0;
  }

  #read(bytes) {
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
    if (bytes.length < HEADER || new TextDecoder("latin1").decode(bytes.subarray(0, 8)) !== MAGIC)
      throw new TypeError("this is no recording: it does not begin as one does; give a file of carom run --record");
    if (view.getUint32(8, true) !== 1) throw new TypeError("the recording has a format of a newer carom: use that one");
    const names = [];
    let calls = [];
    for (let at = HEADER; bytes.length - at >= HEADER && !this.ended;) {
      const kind = view.getUint32(at, true),
        size = Number(view.getBigUint64(at + 8, true));
      if (size > bytes.length - at - HEADER) break; // it was cut off
      const content = bytes.subarray(at + HEADER, at + HEADER + size);
      at += HEADER + Math.ceil(size / 8) * 8;
      if (!this.start && kind !== BEGIN) throw damaged("it does not begin with a world");
      if (kind === BEGIN) this.start ??= content;
      else if (kind === SHAPE) this.#learn(content);
      else if (kind === NAME) names.push(this.#name(content, names.length));
      else if (kind === HASH) this.hashes.push(this.#hash(content));
      else if (kind === END) this.ended = true;
      else if (kind === CALL) {
        const name = names[new Arguments(content).number("uint32_t")];
        if (!name) throw damaged("a call is of no function");
        if (name !== "carom_world_step") calls.push({ name, content: content.subarray(4) });
        else (this.steps.push({ dt: new Arguments(content.subarray(4)).number("double"), calls }), (calls = []));
      }
    }
    if (!this.start) throw damaged("it does not begin with a world");
  }

  #name(content, expected) {
    const index = new Arguments(content).number("uint32_t"),
      name = new TextDecoder().decode(content.subarray(4));
    if (index !== expected) throw damaged("functions are named in another order");
    if (!Object.hasOwn(CALLS, name))
      throw new TypeError(`the recording calls ${name}, which this carom does not know: use a newer one`);
    return name;
  }

  #hash(content) {
    const read = new Arguments(content);
    read.number("uint64_t"); // the world's count of steps
    return read.number("uint64_t").toString(16).padStart(16, "0");
  }

  /** A shape comes as a world in which one body wears it. */
  #learn(content) {
    const read = new Arguments(content),
      recorded = read.handle(),
      collider = read.handle();
    const world = this.engine.world();
    try {
      world.restore(content.subarray(16));
      this.shapes.set(recorded, world.collider(this.#own(world, collider)).shape);
    } finally {
      world.free();
    }
  }

  #own(world, handle) {
    const m = world.module;
    return m.frame((room) => {
      const at = room(8);
      m.view.setBigUint64(at, handle, true);
      m.call("carom_world_translate_handles", world.pointer, at, 1n, at);
      return m.view.getBigUint64(at, true);
    });
  }
  #shape(recorded) {
    if (!this.shapes.has(recorded)) throw damaged("a shape is used before it is described");
    return this.shapes.get(recorded);
  }

  /** Numbers of a field, by the function that says so. */
  #width(m, asked, field) {
    return m.frame((room) => {
      const out = room(4);
      if (m.raw[asked](field, out) !== C.CAROM_OK) throw damaged("a field is none");
      return m.view.getUint32(out, true);
    });
  }

  #make(world, name, content) {
    const m = world.module,
      read = new Arguments(content),
      numbers = {}, // by name: they count the lists
      lengths = []; // to be compared with them
    m.frame((room) => {
      const put = (bytes) => {
        if (!bytes) return 0;
        const at = room(bytes.length);
        new Uint8Array(m.buffer, at, bytes.length).set(bytes);
        return at;
      };
      const given = CALLS[name].map(([what, argument, detail, more, scalar, asked]) => {
        if (what === "number") return (numbers[argument] = read.number(detail));
        if (what === "handle") return this.#own(world, read.handle());
        if (what === "shape") return this.#shape(read.handle());
        if (what === "out") return room(8);
        if (what === "stride") return 0n;
        if (what === "struct") return this.#struct(world, room, read.list(1), detail, more);
        const list = read.list(what === "vector" || what === "handles" ? 8 : what === "array" ? more : 1);
        if (what === "vector" && list && list.length !== 8 * detail) throw damaged("a vector has another length");
        if (list && what === "handles") lengths.push(() => list.length === 8 * Number(numbers[detail]));
        if (list && what === "array") lengths.push(() => list.length === more * Number(numbers[detail]));
        if (list && what === "records")
          lengths.push(() => {
            const width =
              typeof more === "number" ? more : asked ? this.#width(m, asked, numbers[more]) : WIDTHS[numbers[more]];
            return list.length === Number(numbers[detail]) * width * (numbers[scalar] === C.CAROM_SCALAR_F32 ? 4 : 8);
          });
        const at = put(list);
        if (list && what === "handles") {
          const n = BigInt(list.length / 8);
          m.call("carom_world_translate_handles", world.pointer, at, n, at);
        }
        return at;
      });
      if (!lengths.every((fits) => fits())) throw damaged("a list has another length than the call says");
      m.call(name, world.pointer, ...given);
    });
  }

  #struct(world, room, bytes, name, handles) {
    if (!bytes) return 0;
    const m = world.module,
      size = m.structs.size(name),
      at = room(Math.max(size, bytes.length));
    new Uint8Array(m.buffer, at, bytes.length).set(bytes);
    if (bytes.length < 4 || m.view.getUint32(at, true) !== bytes.length) throw damaged("a structure has another size");
    for (const [field, kind] of handles) {
      const { offset } = m.structs.layouts.get(name).fields.get(field);
      if (offset + 8 > bytes.length) continue;
      const recorded = m.view.getBigUint64(at + offset, true);
      m.view.setBigUint64(at + offset, kind === "shape" ? this.#shape(recorded) : this.#own(world, recorded), true);
    }
    return at;
  }
}

/** Where recordings of a module's worlds go. */
class Sinks {
  constructor(module) {
    this.open = new Map();
    this.next = 1;
    const take = (user, from, size) => {
      this.open.get(user)?.push(new Uint8Array(module.buffer, from, Number(size)).slice());
      return 0;
    };
    this.callback = callback(module, "iil", take);
  }
}
const sinks = new WeakMap();

/** Write down what is done to a world from now on.   @returns { end() => Uint8Array }   @throws CaromError */
export function record(world, { states = false } = {}) {
  const m = world.module;
  if (!sinks.has(m)) sinks.set(m, new Sinks(m));
  const to = sinks.get(m),
    user = to.next++,
    parts = [];
  const flags = states ? C.CAROM_RECORD_STATES : C.CAROM_RECORD_HASHES;
  to.open.set(user, parts);
  try {
    m.call("carom_world_record_begin", world.pointer, flags, to.callback, user);
  } catch (error) {
    to.open.delete(user);
    throw error;
  }
  return {
    end() {
      m.call("carom_world_record_end", world.pointer);
      to.open.delete(user);
      const all = new Uint8Array(parts.reduce((sum, part) => sum + part.length, 0));
      let at = 0;
      for (const part of parts) (all.set(part, at), (at += part.length));
      return all;
    },
  };
}
