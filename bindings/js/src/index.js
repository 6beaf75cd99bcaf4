// Carom for JavaScript: the C interface in WebAssembly, with objects, exceptions and views. See ../README.md.
import * as constants from "./constants.js";
import { bringShape, bringSupport, Engine } from "./engine.js";
import { instantiate } from "./module.js";
import { instantiateShared, stopThreads, threadsToUse } from "./threads.js";

export { Body, Joint } from "./body.js";
export { constants };
export { Engine, Shape } from "./engine.js";
export { CaromError } from "./errors.js";
export { Character, Vehicle } from "./kit.js";
export { Recording } from "./recording.js";
export { BodyView } from "./view.js";
export { World } from "./world.js";

class Carom {
  constructor(module) {
    this.module = module;
    this.raw = module.raw;
  }

  get version() {
    const m = this.module;
    return m.frame((room) => {
      const at = room(12);
      m.check(m.raw.carom_version(at, at + 4, at + 8), "version");
      return [0, 4, 8].map((i) => m.view.getUint32(at + i, true)).join(".");
    });
  }

  /** Threads that share a step, the calling one included. */
  get threads() {
    return this.module.threads;
  }

  /** @param options  threads: 1 leaves the others alone */
  engine(options) {
    return new Engine(this.module, options);
  }

  /** End the workers; worlds go on with one thread, and the same bits. */
  stopThreads() {
    stopThreads(this.module);
  }

  /** A shape plugin as a side module, for any number of engines.   @throws TypeError (no side module of a shape) */
  bringShape(source) {
    return bringShape(this.module, source);
  }

  /** A function as a shape, for any number of engines: engine.useShape(). It is slower than a side module, and of modules
   *  with one thread.   @param support (params, direction) => [3] m, the farthest point of the shape along the direction
   *  @param params  [[name, unit, least, most]] of the numbers that it takes   @throws CaromError (UNSUPPORTED) */
  bringSupport(support, id, params) {
    return bringSupport(this.module, support, id, params);
  }

  /** Every dial: name, bounds, choices, what it trades. */
  dials() {
    const m = this.module;
    const count = m.frame((room) => {
      const at = room(4);
      m.check(m.raw.carom_dial_get_count(at), "dials");
      return m.view.getUint32(at, true);
    });
    return Array.from({ length: count }, (_, dial) => this.#dial(dial));
  }

  #dial(dial) {
    const m = this.module;
    const info = m.get("carom_dial_info", (at) => m.raw.carom_dial_get_info(dial, at, m.error), "dials");
    for (const field of ["name", "unit", "summary"]) info[field] = m.text(info[field]);
    info.choices = Array.from({ length: info.choice_count }, (_, i) =>
      m.text(m.view.getUint32(info.choices + 4 * i, true)),
    );
    return info;
  }

  /** Names by CAROM_PRESET_*. */
  presets() {
    return Array.from({ length: constants.CAROM_PRESET_COUNT }, (_, i) =>
      this.module.text(this.raw.carom_preset_name(i)),
    );
  }
  /** Names by CAROM_STAGE_*. */
  stages() {
    return Array.from({ length: constants.CAROM_STAGE_COUNT }, (_, i) =>
      this.module.text(this.raw.carom_stage_name(i)),
    );
  }
}

/** Load the engine.   @param source  where carom.wasm is: bytes, a URL, a Response, a compiled module; by default the
 *  package's. Or options: { source, threads }, where threads is a number or "auto": one where there can be no more
 *  @throws CaromError (UNSUPPORTED) for more than one thread where memory cannot be shared; (NOT_FOUND) where there is no
 *  module of this package's version, with its address and what to do */
export async function load(source) {
  const isOptions = source && Object.getPrototypeOf(source) === Object.prototype;
  const options = isOptions ? source : { source };
  const strange = Object.keys(options).find((name) => name !== "source" && name !== "threads");
  if (strange) throw new TypeError(`load() has no option ${strange}: source, threads`);
  const threads = await threadsToUse(options.threads ?? 1);
  return new Carom(await (threads > 1 ? instantiateShared(options.source, threads) : instantiate(options.source)));
}
