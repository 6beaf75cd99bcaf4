/** One field of bodies in the module's memory, read in one call: no copy into JavaScript. `array` is a typed array
 * over that
 *  memory. When memory grows, typed arrays of before are empty; `array` gives a new one, so ask for it each time. */
export class BodyView {
  constructor(world, field, width, { scalar = "f64", bodies = null } = {}) {
    if (scalar !== "f64" && scalar !== "f32") throw new TypeError('scalar is "f64" or "f32"');
    Object.assign(this, { world, field, width, bodies: null, count: 0, capacity: 0, at: 0, handles: 0 });
    this.isDouble = scalar === "f64";
    this.state = { at: 0, handles: 0, module: world.module };
    registry.register(this, this.state, this);
    if (bodies) this.choose(bodies);
  }

  /** Which bodies, in order; null: all, as world.bodies() has them. */
  choose(bodies) {
    const m = this.world.module;
    this.bodies = bodies;
    if (this.state.handles) m.raw.free(this.state.handles);
    this.state.handles = 0;
    if (!bodies) return;
    this.state.handles = m.claim(8 * bodies.length);
    new BigUint64Array(m.buffer, this.state.handles, bodies.length).set(bodies.map((b) => b.handle));
  }

  /** Read the field anew.   @returns this */
  update() {
    const m = this.world.module;
    this.count = this.bodies ? this.bodies.length : this.world.bodyCount();
    if (this.count > this.capacity) {
      if (this.state.at) m.raw.free(this.state.at);
      this.capacity = Math.max(16, this.bodies ? this.count : 2 * this.count);
      this.state.at = m.claim(this.capacity * this.width * this.bytes);
    }
    if (this.count) this.transfer("carom_world_read");
    return this;
  }

  /** Write what `array` holds now back to the bodies.   @throws CaromError for a field that is read only, or bad
   * values */
  write() {
    this.transfer("carom_world_write");
  }

  /** One call for all of them.   @param name  carom_world_read or carom_world_write */
  transfer(name) {
    const { pointer, module } = this.world;
    const scalar = this.isDouble ? 1 : 0;
    module.call(name, pointer, this.field, scalar, this.state.handles, BigInt(this.count), this.state.at, 0n);
  }

  get bytes() {
    return this.isDouble ? 8 : 4;
  }

  /** [count * width], over the module's memory as it is now. */
  get array() {
    const Type = this.isDouble ? Float64Array : Float32Array;
    const buffer = this.world.module.buffer;
    if (
      !this.kept ||
      this.kept.buffer !== buffer ||
      this.kept.length !== this.count * this.width ||
      this.kept.byteOffset !== this.state.at
    )
      this.kept = new Type(buffer, this.state.at, this.count * this.width);
    return this.kept;
  }

  free() {
    release(this.state);
    registry.unregister(this);
    this.count = this.capacity = 0;
  }
}

function release(state) {
  if (state.at) state.module.raw.free(state.at);
  if (state.handles) state.module.raw.free(state.handles);
  state.at = state.handles = 0;
}
const registry = new FinalizationRegistry(release);
