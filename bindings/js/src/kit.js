// The kit: a character that walks through a world, a vehicle on wheels. All of their state is here, none of it in the world.
import { Body } from "./body.js";
import * as C from "./constants.js";

const GROUND = ["air", "steep", "firm"]; // by CAROM_GROUND_*

/** A struct of the C interface that a host keeps: as bytes, since the module's memory is its own. */
class Kept {
  constructor(module, name, values = {}) {
    Object.assign(this, { module, name });
    module.frame((room) => this.take(module.put(room, name, values)));
  }
  /** Into the module's memory.   @returns where */
  place(room) {
    const at = room(this.bytes.length);
    new Uint8Array(this.module.buffer, at, this.bytes.length).set(this.bytes);
    return at;
  }
  take(at) {
    this.bytes = new Uint8Array(this.module.buffer, at, this.module.structs.size(this.name)).slice();
  }
  get #view() {
    return new DataView(this.bytes.buffer, this.bytes.byteOffset, this.bytes.length);
  }
  get fields() {
    return this.module.structs.read(this.#view, this.name, 0);
  }
  /** @throws TypeError where there is no such field: nothing is written then */
  write(values) {
    const bytes = this.bytes.slice();
    this.module.structs.write(new DataView(bytes.buffer), this.name, 0, values);
    this.bytes = bytes;
  }
}

/** The reverse of save(): nothing changes where these are no bytes of it. */
function put(parts, saved, what) {
  const total = parts.reduce((sum, part) => sum + part.bytes.length, 0);
  if (saved?.length !== total)
    throw new TypeError(`restore() takes the ${total} bytes that save() of this ${what} gave, not ${saved?.length}`);
  let at = 0;
  for (const part of parts) {
    part.bytes = saved.slice(at, at + part.bytes.length);
    at += part.bytes.length;
  }
}
const together = (parts) => Uint8Array.from(parts.flatMap((part) => [...part.bytes]));

/** A shape that walks: it slides along walls, climbs steps, rides what moves (carom/character.h). It is no body, and a
 *  step does not move it. A frame is `world.step(dt)`, `move(walk, dt)`, `push(dt)`. */
export class Character {
  #desc;
  #state;
  /** @param shape  convex; most take a capsule   @param options  position and orientation; fields of
   *  carom_character_desc: step_up, max_slope, ... */
  constructor(world, shape, { position = [0, 0, 0], orientation = [0, 0, 0, 1], ...about } = {}) {
    const m = world.module;
    this.world = world;
    this.#desc = new Kept(m, "carom_character_desc", about);
    this.#state = new Kept(m, "carom_character", { position, orientation });
    this.setShape(shape, true);
  }

  #call(name, ...rest) {
    const m = this.world.module;
    m.frame((room) => {
      const state = this.#state.place(room);
      m.call(name, this.world.pointer, this.#desc.place(room), state, ...rest.map((one) => one(room)));
      this.#state.take(state);
    });
  }

  /** By dt, s.   @param walk [3] m/s, world, relative to the ground   @param jump m/s, taken off with from firm ground */
  move(walk, dt = 1 / 60, jump = 0) {
    const m = this.world.module;
    this.#call(
      "carom_character_move",
      (room) => m.putDoubles(room, walk, 3, "move(walk)"),
      () => jump,
      () => dt,
    );
  }

  /** Leave forces on what the last move met and on what it stands on, for the next step, of dt, s. */
  push(dt = 1 / 60) {
    this.#call("carom_character_push", () => dt);
  }

  /** Another shape: to crouch, to stand up. Its lowest point stays where it is.   @param always  whatever is in its place
   *  @returns false: there is no place for it, and nothing has changed */
  setShape(shape, always = false) {
    const m = this.world.module;
    return m.frame((room) => {
      const state = this.#state.place(room),
        fits = always ? 0 : room(4);
      if (fits) m.view.setUint32(fits, 1, true);
      const { pointer } = this.world.engine;
      m.call(
        "carom_character_set_shape",
        pointer,
        this.world.pointer,
        this.#desc.place(room),
        state,
        shape.handle,
        fits,
      );
      this.#state.take(state);
      return !fits || m.view.getUint32(fits, true) === 1;
    });
  }

  /** All of carom_character. */
  get state() {
    return this.#state.fields;
  }
  /** m, of the shape's origin. Setting it teleports: it is in the air until the next move. */
  get position() {
    return this.state.position;
  }
  set position(position) {
    this.#state.write({ position, ground: C.CAROM_GROUND_AIR });
  }
  get velocity() {
    return this.state.velocity;
  }
  /** m, from the origin down to the lowest point. */
  get foot() {
    return this.state.foot;
  }
  /** "firm": it can walk and jump; "steep": it slides; "air": it falls. */
  get ground() {
    return GROUND[this.state.ground];
  }
  /** What was in its way in the last move: [{ body, point, normal, speed }]. */
  get contacts() {
    const s = this.state;
    return Array.from({ length: s.contact_count }, (_, i) => ({
      body: new Body(this.world, s.contact_bodies[i]),
      point: s.contact_points.slice(3 * i, 3 * i + 3),
      normal: s.contact_normals.slice(3 * i, 3 * i + 3),
      speed: s.contact_speeds[i],
    }));
  }

  /** Where it is and how it moves; settings are not in it. */
  save() {
    return together([this.#state]);
  }
  restore(saved) {
    put([this.#state], saved, "character");
  }
}

/** A dynamic body on wheels that are no bodies: springs, tyres, an engine (carom/vehicle.h). A frame is `drive(input, dt)`,
 *  then `world.step(dt)`. */
export class Vehicle {
  #desc;
  #state;
  #descs;
  #wheels;
  /** @param wheels  fields of carom_wheel_desc of each   @param about  fields of carom_vehicle_desc */
  constructor(chassis, wheels, about = {}) {
    const m = chassis.world.module;
    if (!(wheels?.length >= 1 && wheels.length <= C.CAROM_VEHICLE_WHEELS))
      throw new TypeError(`a vehicle takes 1 to ${C.CAROM_VEHICLE_WHEELS} wheels, not ${wheels?.length}`);
    this.chassis = chassis;
    this.#desc = new Kept(m, "carom_vehicle_desc", { ...about, chassis: chassis.handle });
    this.#state = new Kept(m, "carom_vehicle");
    this.#descs = wheels.map((each) => new Kept(m, "carom_wheel_desc", each));
    this.#wheels = wheels.map(() => new Kept(m, "carom_wheel"));
  }

  /** Turn wheels and engine through dt, s, and leave forces for the next step, which is to take dt.
   *  @param input  throttle, brake, handbrake 0 to 1; steer -1 to 1: to the left; gear 0: neutral, -1: reverse */
  drive(input = {}, dt = 1 / 60) {
    const { world } = this.chassis,
      m = world.module,
      n = this.#wheels.length;
    m.frame((room) => {
      const row = (parts) => {
        const size = parts[0].bytes.length,
          at = room(size * n);
        parts.forEach((part, i) => new Uint8Array(m.buffer, at + i * size, size).set(part.bytes));
        return at;
      };
      const given = m.put(room, "carom_vehicle_input", { gear: 1, ...input }),
        descs = row(this.#descs),
        state = this.#state.place(room),
        wheels = row(this.#wheels);
      m.call("carom_vehicle_drive", world.pointer, this.#desc.place(room), descs, BigInt(n), given, state, wheels, dt);
      this.#state.take(state);
      this.#wheels.forEach((wheel, i) => wheel.take(wheels + i * wheel.bytes.length));
    });
  }

  /** Of all wheels.   @param spin rad/s, forward */
  setSpin(spin) {
    for (const wheel of this.#wheels) wheel.write({ spin });
  }
  /** All of carom_vehicle. */
  get state() {
    return this.#state.fields;
  }
  /** m/s, forward */
  get speed() {
    return this.state.speed;
  }
  /** All of carom_wheel, of each. */
  get wheels() {
    return this.#wheels.map((wheel) => wheel.fields);
  }

  /** Of engine, gears and wheels; the chassis is in `world.save()`, and settings are in neither. */
  save() {
    return together([this.#state, ...this.#wheels]);
  }
  restore(saved) {
    put([this.#state, ...this.#wheels], saved, "vehicle");
  }
}
