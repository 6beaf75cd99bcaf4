// Bodies and joints: handles with the calls that take them. The world checks a handle on every call.
import * as C from "./constants.js";
import { Shape } from "./engine.js";

const TYPES = ["static", "kinematic", "dynamic"];

export class Body {
  constructor(world, handle) {
    this.world = world;
    this.handle = handle;
  }

  #read(field, width) {
    const { module: m, pointer } = this.world;
    return m.frame((room) => {
      const handle = room(8),
        to = room(8 * width);
      m.view.setBigUint64(handle, this.handle, true);
      m.call("carom_world_read", pointer, field, C.CAROM_SCALAR_F64, handle, 1n, to, 0n);
      return m.doubles(to, width);
    });
  }

  get position() {
    return this.#read(C.CAROM_FIELD_POSITION, 3);
  }
  get orientation() {
    return this.#read(C.CAROM_FIELD_ORIENTATION, 4);
  }
  get linearVelocity() {
    return this.#read(C.CAROM_FIELD_LINEAR_VELOCITY, 3);
  }
  get angularVelocity() {
    return this.#read(C.CAROM_FIELD_ANGULAR_VELOCITY, 3);
  }
  get center() {
    return this.#read(C.CAROM_FIELD_CENTER, 3);
  }
  get mass() {
    return this.#read(C.CAROM_FIELD_MASS, 1)[0];
  }
  get type() {
    return TYPES[this.desc.type];
  }
  /** Anything of the host's, a bigint of 64 bits; snapshots keep it. */
  get user() {
    return this.desc.user;
  }
  set user(value) {
    this.world.module.call("carom_body_set_user", this.world.pointer, this.handle, BigInt.asUintN(64, value));
  }

  /** All of carom_body_desc, as the engine uses it. */
  get desc() {
    const { module: m, pointer } = this.world;
    return m.get("carom_body_desc", (at) => m.raw.carom_body_get(pointer, this.handle, at, m.error), "body.desc");
  }

  setPose(position, orientation = this.orientation) {
    this.#vectors("carom_body_set_pose", position, 3, orientation, 4);
  }
  setVelocity(linear, angular = [0, 0, 0]) {
    this.#vectors("carom_body_set_velocity", linear, 3, angular, 3);
  }
  /** For the next step only. @param force [3] N   @param torque [3] N m about the centre of mass */
  addForce(force, torque = [0, 0, 0]) {
    this.#vectors("carom_body_add_force", force, 3, torque, 3);
  }
  /** @param impulse [3] N s   @param point [3] m, world */
  addImpulse(impulse, point = this.center) {
    this.#vectors("carom_body_add_impulse", impulse, 3, point, 3);
  }

  #vectors(name, a, n, b, k) {
    const { module: m, pointer } = this.world;
    m.frame((room) =>
      m.call(name, pointer, this.handle, m.putDoubles(room, a, n, name), m.putDoubles(room, b, k, name)),
    );
  }

  /** @param options  density kg/m^3, position, orientation in the body's frame, material   @returns handle of the
   * collider */
  addCollider(shape, options = {}) {
    const { module: m, pointer } = this.world;
    if (!(shape instanceof Shape)) throw new TypeError("addCollider() takes a shape: engine.box(x, y, z) makes one");
    return m.frame((room) => {
      const out = room(8);
      const desc = m.put(room, "carom_collider_desc", { ...options, shape: shape.handle });
      m.call("carom_collider_create", pointer, this.handle, desc, out);
      return m.view.getBigUint64(out, true);
    });
  }

  #is(call) {
    const { module: m, pointer } = this.world;
    return m.frame((room) => {
      const out = room(4);
      m.call(call, pointer, this.handle, out);
      return m.view.getUint32(out, true) === 1;
    });
  }
  get asleep() {
    return this.#is("carom_body_is_asleep");
  }
  /** Whether it takes part in steps; a disabled body keeps its pose and velocity, and touches nothing. */
  get enabled() {
    return this.#is("carom_body_is_enabled");
  }
  set enabled(value) {
    this.world.module.call("carom_body_set_enabled", this.world.pointer, this.handle, value ? 1 : 0);
  }
  wake() {
    this.world.module.call("carom_body_wake", this.world.pointer, this.handle);
  }

  /** @param attribute CAROM_ATTRIBUTE_*   @param value up to four numbers */
  setAttribute(attribute, ...value) {
    const { module: m, pointer } = this.world;
    const four = [0, 1, 2, 3].map((i) => value[i] ?? 0);
    m.frame((room) =>
      m.call("carom_body_set_attribute", pointer, this.handle, attribute, m.putDoubles(room, four, 4, "setAttribute")),
    );
  }

  destroy() {
    this.world.module.call("carom_body_destroy", this.world.pointer, this.handle);
  }
}

export class Joint {
  constructor(world, handle) {
    this.world = world;
    this.handle = handle;
  }
  /** All of carom_joint_desc: kind, body_a, body_b, frames. */
  get desc() {
    const { module: m, pointer } = this.world;
    return m.get("carom_joint_desc", (at) => m.raw.carom_joint_get(pointer, this.handle, at, m.error), "joint.desc");
  }
  /** All of carom_joint_state: force, torque, gap, coordinates. */
  get state() {
    const { module: m, pointer } = this.world;
    return m.get(
      "carom_joint_state",
      (at) => m.raw.carom_joint_get_state(pointer, this.handle, at, m.error),
      "joint.state",
    );
  }
  setLimit(coordinate, lower, upper) {
    this.#set("carom_joint_set_limit", "carom_joint_limit", coordinate, { enabled: 1, lower, upper });
  }
  /** @param speed m/s or rad/s   @param max_force N or N m */
  setMotor(coordinate, speed, maxForce) {
    this.#set("carom_joint_set_motor", "carom_joint_motor", coordinate, { enabled: 1, speed, max_force: maxForce });
  }
  setSpring(coordinate, target, frequency, damping = 1) {
    this.#set("carom_joint_set_spring", "carom_joint_spring", coordinate, { enabled: 1, target, frequency, damping });
  }
  #set(call, struct, coordinate, values) {
    const { module: m, pointer } = this.world;
    m.frame((room) => m.call(call, pointer, this.handle, coordinate, m.put(room, struct, values)));
  }
  destroy() {
    this.world.module.call("carom_joint_destroy", this.world.pointer, this.handle);
  }
}
