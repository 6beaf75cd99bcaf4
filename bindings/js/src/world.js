// A world: bodies, joints and materials, and the step.
import * as C from "./constants.js";
import { accuracy } from "./accuracy.js";
import { Body, Joint } from "./body.js";
import { net, Owned } from "./owner.js";
import { particlePositions } from "./particles.js";
import { record } from "./recording.js";
import { joints } from "./tree.js";
import { BodyView } from "./view.js";

const FIELDS = {
  position: [C.CAROM_FIELD_POSITION, 3],
  orientation: [C.CAROM_FIELD_ORIENTATION, 4],
  pose: [C.CAROM_FIELD_POSE, 7],
  linearVelocity: [C.CAROM_FIELD_LINEAR_VELOCITY, 3],
  angularVelocity: [C.CAROM_FIELD_ANGULAR_VELOCITY, 3],
  velocity: [C.CAROM_FIELD_VELOCITY, 6],
  force: [C.CAROM_FIELD_FORCE, 6],
  center: [C.CAROM_FIELD_CENTER, 3],
  mass: [C.CAROM_FIELD_MASS, 1],
};
const TYPES = { static: C.CAROM_BODY_STATIC, kinematic: C.CAROM_BODY_KINEMATIC, dynamic: C.CAROM_BODY_DYNAMIC };

function chosen(table, key, what) {
  if (typeof key === "number") return key;
  if (!(key in table)) throw new TypeError(`there is no ${what} "${key}": ${Object.keys(table).join(", ")}`);
  return table[key];
}

export class World {
  constructor(engine, options, pointer = 0) {
    this.engine = engine;
    const m = (this.module = engine.module);
    const made =
      pointer ||
      m.frame((room) => {
        const out = room(8);
        m.call("carom_world_create", engine.pointer, m.put(room, "carom_world_desc", options), out);
        return m.view.getUint32(out, true);
      });
    this.owned = new Owned(made, (p) => m.check(m.raw.carom_world_destroy(p, m.error), "world.free"), engine.owned);
    net.register(this, this.owned, this);
  }

  get pointer() {
    if (!this.owned.pointer) throw new TypeError("this world was freed: make another with engine.world()");
    return this.owned.pointer;
  }

  free() {
    this.owned.release();
    net.unregister(this);
  }

  /** @param dt s */
  step(dt = 1 / 60) {
    this.module.call("carom_world_step", this.pointer, dt);
  }

  /** @param options  type "static", "kinematic" or "dynamic"; position, orientation, linear_velocity, ... as
   * carom_body_desc;
   *  shape, and of its collider density, friction, restitution */
  body({ shape, type = "dynamic", density, friction, restitution, material, fields = 0, ...desc } = {}) {
    const m = this.module;
    for (const field of ["mass", "center", "inertia"])
      if (desc[field] !== undefined) fields |= C[`CAROM_BODY_FIELD_${field.toUpperCase()}`];
    const handle = m.frame((room) => {
      const out = room(8);
      m.call(
        "carom_body_create",
        this.pointer,
        m.put(room, "carom_body_desc", { ...desc, fields, type: chosen(TYPES, type, "type of body") }),
        out,
      );
      return m.view.getBigUint64(out, true);
    });
    const body = new Body(this, handle);
    try {
      if (friction !== undefined || restitution !== undefined) material = this.material({ friction, restitution });
      if (shape) body.addCollider(shape, { density, material });
    } catch (error) {
      body.destroy();
      throw error;
    }
    return body;
  }

  /** Level ground: a half-space up to `height`. */
  ground({ height = 0, normal = [0, 1, 0], ...surface } = {}) {
    return this.body({ type: "static", shape: this.engine.halfSpace(normal, height), ...surface });
  }

  /** @param desc  friction, restitution, ... of carom_material_desc   @returns handle */
  material(desc) {
    const m = this.module;
    return m.frame((room) => {
      const out = room(8);
      m.call("carom_material_create", this.pointer, m.put(room, "carom_material_desc", desc), out);
      return m.view.getBigUint64(out, true);
    });
  }

  /** @param kind  "ball", "hinge", ...   @param a, b  bodies, or null: the world   @param desc  of carom_joint_desc;
   * `at` [3] m and
   *  `axes` [4] instead of frames: a point and a frame in the world, as the bodies stand now */
  joint(kind, a, b, { at, axes, fields = 0, ...desc } = {}) {
    const m = this.module;
    if (at)
      (Object.assign(desc, { position_a: at, orientation_a: axes ?? [0, 0, 0, 1] }),
        (fields |= C.CAROM_JOINT_WORLD_FRAME));
    if (desc.length !== undefined) fields |= C.CAROM_JOINT_FIELD_LENGTH;
    return new Joint(
      this,
      m.frame((room) => {
        const out = room(8);
        m.call(
          "carom_joint_create",
          this.pointer,
          m.put(room, "carom_joint_desc", {
            ...desc,
            fields,
            kind: chosen(C.JOINTS, kind, "kind of joint"),
            body_a: a?.handle ?? 0n,
            body_b: b?.handle ?? 0n,
          }),
          out,
        );
        return m.view.getBigUint64(out, true);
      }),
    );
  }

  bodyCount() {
    const m = this.module;
    return Number(m.u64((at) => m.raw.carom_world_get_bodies(this.pointer, 0, 0n, at, m.error), "bodyCount"));
  }

  bodies() {
    return Array.from(this.module.handles("carom_world_get_bodies", this.pointer), (handle) => new Body(this, handle));
  }

  joints() {
    return Array.from(this.module.handles("carom_world_get_joints", this.pointer), (handle) => new Joint(this, handle));
  }

  /** A field of all bodies, or of some, without copies: see BodyView. */
  view(field, options) {
    const [number, width] = chosen(FIELDS, field, "field");
    return new BodyView(this, number, width, options);
  }

  /** Of the state, 16 hexadecimal digits: the same on every machine. */
  hash() {
    const m = this.module;
    return m
      .u64((at) => m.raw.carom_world_hash(this.pointer, at, m.error), "hash")
      .toString(16)
      .padStart(16, "0");
  }

  /** @param whole  with bodies and shapes, for an empty world of any process   @returns Uint8Array */
  save({ whole = false } = {}) {
    const m = this.module,
      flags = whole ? C.CAROM_SNAPSHOT_WHOLE : C.CAROM_SNAPSHOT_STATE;
    return m.frame((room) => {
      const needed = room(8),
        result = m.raw.carom_world_save(this.pointer, flags, 0, 0n, needed, m.error);
      m.check(result, "save");
      const size = Number(m.view.getBigUint64(needed, true)),
        at = room(size);
      m.call("carom_world_save", this.pointer, flags, at, BigInt(size), needed);
      return new Uint8Array(m.buffer, at, size).slice();
    });
  }

  restore(bytes) {
    const m = this.module;
    m.frame((room) => {
      const at = room(bytes.length);
      new Uint8Array(m.buffer, at, bytes.length).set(bytes);
      m.call("carom_world_restore", this.pointer, at, BigInt(bytes.length));
    });
  }

  /** Write down all that is done from now on.   @param states  after each step, too
   *  @returns {{ end(): Uint8Array }} for new Recording(engine, bytes), and for `carom replay` */
  record(options) {
    return record(this, options);
  }

  /** A second world that goes on as this one, bit for bit. */
  fork() {
    const m = this.module;
    return new World(
      this.engine,
      {},
      m.frame((room) => {
        const out = room(8);
        m.call("carom_world_fork", this.pointer, out);
        return m.view.getUint32(out, true);
      }),
    );
  }

  #dial(name) {
    if (typeof name === "number") return name;
    const m = this.module;
    return m.frame((room) => {
      const out = room(4);
      m.call("carom_dial_find", m.putText(room, name), out);
      return m.view.getUint32(out, true);
    });
  }
  /** @param name  "substeps", or CAROM_DIAL_* */
  setDial(name, value) {
    this.module.call("carom_world_set_dial", this.pointer, this.#dial(name), value);
  }
  dial(name) {
    const m = this.module;
    return m.frame((room) => {
      const out = room(8);
      m.call("carom_world_get_dial", this.pointer, this.#dial(name), out);
      return m.view.getFloat64(out, true);
    });
  }
  /** @param preset  CAROM_PRESET_* */
  setPreset(preset) {
    this.module.call("carom_world_set_preset", this.pointer, preset);
  }

  get gravity() {
    const m = this.module;
    return m.frame((room) => {
      const at = room(24);
      m.call("carom_world_get_gravity", this.pointer, at);
      return m.doubles(at, 3);
    });
  }
  set gravity(value) {
    const m = this.module;
    m.frame((room) => m.call("carom_world_set_gravity", this.pointer, m.putDoubles(room, value, 3, "gravity")));
  }

  /** Times, counts and residuals of the last step: carom_step_report. */
  report() {
    const m = this.module;
    return m.get("carom_step_report", (at) => m.raw.carom_world_get_report(this.pointer, at, m.error), "report");
  }
  /** What the last step left undone: carom_residuals. */
  residuals() {
    const m = this.module;
    return m.get("carom_residuals", (at) => m.raw.carom_world_get_residuals(this.pointer, at, m.error), "residuals");
  }
  #list(struct, name, ...before) {
    const m = this.module;
    return m.list(
      struct,
      (at, stride, capacity, count) => m.raw[name](this.pointer, ...before, at, stride, capacity, count, m.error),
      name,
    );
  }
  /** Keep an account of energy and momentum by cause from now on (carom/ledger.h); no bit changes. */
  keepLedger(on = true) {
    this.module.call("carom_world_enable_ledger", this.pointer, on ? 1 : 0);
  }
  /** What each cause gave, in the last step and in all; none of a world that keeps no ledger. */
  ledger() {
    const m = this.module;
    return this.#list("carom_ledger_entry", "carom_world_get_ledger").map((entry) => ({
      ...entry,
      name: m.text(entry.name),
    }));
  }
  contacts() {
    return this.#list("carom_contact", "carom_world_get_contacts");
  }
  /** Keep events from now on; they are those of the last step.   @param kinds  CAROM_EVENTS_* bits   @param hitSpeed m/s:
   *  faster contacts are hits */
  collectEvents(kinds = C.CAROM_EVENTS_CONTACT, hitSpeed = 1) {
    this.module.call("carom_world_collect_events", this.pointer, kinds, hitSpeed);
  }
  /** Contacts that began, ended or hit in the last step: `kind` "begin", "end" or "hit". */
  contactEvents() {
    return this.#list("carom_contact_event", "carom_world_get_contact_events").map((event) => ({
      ...event,
      kind: ["begin", "end", "hit"][event.kind],
      body_a: new Body(this, event.body_a),
      body_b: new Body(this, event.body_b),
    }));
  }
  /** What the last step ran, for what, at what cost, and what it left out. */
  plan() {
    return this.#list("carom_plan_line", "carom_world_get_plan");
  }
  faults() {
    return this.#list("carom_fault", "carom_world_get_faults");
  }
  /** @param mode  CAROM_MODE_* */
  setEffect(effect, mode) {
    this.module.call("carom_world_set_effect", this.pointer, effect, mode);
  }
  timeEffects(on = true) {
    this.module.call("carom_world_time_effects", this.pointer, on ? 1 : 0);
  }

  /** Debug lines. @param what CAROM_DRAW_* bits
   *  @returns {{points: Float32Array, colours: Uint32Array}}  [6n] m, from and to; [n] 0xRRGGBBAA */
  draw(what, { colouring = C.CAROM_DRAW_BY_TYPE, scale = 0.2 } = {}) {
    const m = this.module,
      size = m.structs.size("carom_draw_line");
    const { fields } = m.structs.layouts.get("carom_draw_line");
    return m.frame((room) => {
      const desc = m.put(room, "carom_draw_desc", { what, colouring, scale }),
        count = room(8);
      m.call("carom_world_draw", this.pointer, desc, 0, BigInt(size), 0n, count);
      const n = Number(m.view.getBigUint64(count, true)),
        at = room(n * size);
      if (n) m.call("carom_world_draw", this.pointer, desc, at, BigInt(size), BigInt(n), count);
      const points = new Float32Array(6 * n),
        colours = new Uint32Array(n),
        view = m.view;
      const from = fields.get("from").offset,
        colour = fields.get("colour").offset;
      for (let i = 0; i < n; ++i) {
        for (let k = 0; k < 6; ++k) points[6 * i + k] = view.getFloat64(at + i * size + from + 8 * k, true);
        colours[i] = view.getUint32(at + i * size + colour, true);
      }
      return { points, colours };
    });
  }

  /** Of all particles of all sets.   @returns Float32Array [3n] m */
  particlePositions() {
    return particlePositions(this);
  }

  /** What a ray meets first, or null.   @param direction [3] m per unit of time   @returns body, collider, time,
   * point, normal */
  castRay(origin, direction, max = Infinity) {
    const m = this.module,
      size = m.structs.size("carom_world_hit");
    return m.frame((room) => {
      const at = room(size);
      m.call(
        "carom_world_cast_ray",
        this.pointer,
        m.putDoubles(room, origin, 3, "castRay(origin)"),
        m.putDoubles(room, direction, 3, "castRay(direction)"),
        max,
        0,
        at,
        BigInt(size),
      );
      const hit = m.structs.read(m.view, "carom_world_hit", at);
      if (!hit.collider) return null;
      return { ...hit, body: new Body(this, hit.body) };
    });
  }

  /** One shape to ask with, where it stands and how it moves. */
  #asking(room, shape, position, orientation, motion) {
    const m = this.module,
      handle = room(8),
      given = (values, n, what) => (values ? m.putDoubles(room, values, n, what) : 0);
    m.view.setBigUint64(handle, shape.handle, true);
    return m.put(room, "carom_query_shapes", {
      scalar: C.CAROM_SCALAR_F64,
      count: 1n,
      shapes: handle,
      positions: m.putDoubles(room, position, 3, "position"),
      orientations: given(orientation, 4, "orientation"),
      motions: given(motion, 3, "motion"),
    });
  }

  /** What a shape meets first as it moves without turning, or null.   @param motion [3] m   @returns as castRay(); time is
   * a fraction of the motion */
  castShape(shape, position, motion, orientation) {
    const m = this.module,
      size = m.structs.size("carom_world_hit");
    return m.frame((room) => {
      const asking = this.#asking(room, shape, position, orientation, motion),
        at = room(size);
      m.call("carom_world_cast_shapes", this.pointer, asking, C.CAROM_WANT_FIRST, 0, at, BigInt(size));
      const hit = m.structs.read(m.view, "carom_world_hit", at);
      return hit.collider ? { ...hit, body: new Body(this, hit.body) } : null;
    });
  }

  /** All that a shape at a place overlaps.   @returns [as castRay()] */
  overlaps(shape, position, orientation) {
    return this.module
      .frame((room) => {
        const asking = this.#asking(room, shape, position, orientation);
        return this.#list("carom_world_hit", "carom_world_overlap_shapes", asking, 0);
      })
      .filter((hit) => hit.collider)
      .map((hit) => ({ ...hit, body: new Body(this, hit.body) }));
  }

  /** Every collider, however the world was made: handle, body, shape, pose on the body.
   *  @param radius m: of a ball about the origin in which they are looked for */
  colliders(radius = 1e7) {
    const m = this.module,
      ball = this.engine.sphere(radius);
    try {
      const found = m.frame((room) => {
        const shapes = this.#asking(room, ball, [0, 0, 0]);
        const desc = m.put(room, "carom_query_desc", { flags: C.CAROM_ASK_SENSORS });
        return this.#list("carom_world_hit", "carom_world_overlap_shapes", shapes, desc);
      });
      return found.filter((hit) => hit.collider).map((hit) => this.collider(hit.collider));
    } finally {
      ball.destroy();
    }
  }

  /** @param handle  of a collider   @returns carom_collider_desc, with `handle` and `body` */
  collider(handle) {
    const m = this.module;
    return m.frame((room) => {
      const body = room(8);
      const desc = m.get(
        "carom_collider_desc",
        (at) => m.raw.carom_collider_get(this.pointer, handle, at, body, m.error),
        "collider",
      );
      return { ...desc, handle, body: new Body(this, m.view.getBigUint64(body, true)) };
    });
  }
}
for (const part of [accuracy, joints]) Object.defineProperties(World.prototype, Object.getOwnPropertyDescriptors(part));
if (Symbol.dispose) World.prototype[Symbol.dispose] = World.prototype.free;
