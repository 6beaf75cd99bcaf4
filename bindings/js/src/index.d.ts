// Types of the package. Names of structs' fields are those of include/carom; the raw interface is in raw.d.ts.
import * as constants from "./constants.js";
import type { Raw } from "./raw.js";

export { constants };
export type Vector = ArrayLike<number>;
export type Quaternion = ArrayLike<number>;
export type Handle = bigint;
export type Support = (params: number[], direction: number[]) => Vector;

/** What a call that failed throws. The call changed nothing. */
export class CaromError extends Error {
  /** CAROM_E_* */
  readonly code: number;
  /** "CAROM_E_OUT_OF_RANGE" */
  readonly result: string;
  /** Which argument of the C call, from 1; 0: none in particular. */
  readonly argument: number;
  /** What is wrong. */
  readonly text: string;
  /** What to do. */
  readonly remedy: string;
  readonly witness: { direction: number[]; point: number[] } | null;
}

export interface Dial {
  dial: number;
  kind: number;
  name: string;
  unit: string;
  summary: string;
  choices: string[];
  min: number;
  max: number;
  initial: number;
}

export interface Carom {
  readonly version: string;
  /** The C interface, for what has no method here. */
  readonly raw: Raw;
  /** Threads that share a step, the calling one included. */
  readonly threads: number;
  /** threads: 1 leaves the others alone; all of them by default. */
  engine(options?: { threads?: number }): Engine;
  /** End the workers. Worlds go on with one thread, and the same bits. */
  stopThreads(): void;
  /** A shape plugin as a side module, for any number of engines: engine.useShape(). */
  bringShape(source: Source): Promise<ShapePlugin>;
  /** A function as a shape: the farthest point of the shape along a direction. It is slower than a side module, and of
   * modules with one thread.   @param params  [name, unit, least, most] of the numbers that it takes */
  bringSupport(support: Support, id: string, params: [string, string, number, number][]): ShapePlugin;
  dials(): Dial[];
  /** Names by CAROM_PRESET_*. */
  presets(): string[];
  /** Names by CAROM_STAGE_*. */
  stages(): string[];
}

export type Source = string | URL | Response | BufferSource | WebAssembly.Module;

/** Load the engine.   @param source  where carom.wasm is; by default beside the package. Or options: threads above 1
 *  take carom.threads.wasm, for which memory must be shared; "auto" takes one where it cannot be. */
export function load(source?: Source | { source?: Source; threads?: number | "auto" }): Promise<Carom>;

export class Shape {
  readonly engine: Engine;
  readonly handle: Handle;
  readonly info: {
    kind: string;
    volume: number;
    bounding_radius: number;
    aabb_min: number[];
    aabb_max: number[];
    [field: string]: unknown;
  };
  readonly params: number[];
  /** @param directions [3n]   @returns [3n] m */
  supports(directions: Vector): Float64Array;
  /** Of scenery.   @returns [9n] m */
  triangles(): Float64Array;
  destroy(): void;
}

export class Engine {
  /** In a step, the calling one included. */
  readonly threads: number;
  shape(id: string, params: Vector): Shape;
  sphere(radius: number): Shape;
  /** Half extents, m. */
  box(x: number, y: number, z: number): Shape;
  capsule(radius: number, halfHeight: number): Shape;
  taperedCapsule(radiusBottom: number, radiusTop: number, halfHeight: number): Shape;
  cylinder(radius: number, halfHeight: number): Shape;
  cone(radius: number, halfHeight: number): Shape;
  ellipsoid(x: number, y: number, z: number): Shape;
  hull(points: Vector): Shape;
  hullOf(parts: { shape: Shape; position?: Vector; orientation?: Vector; scale?: Vector }[], radius?: number): Shape;
  halfSpace(normal?: Vector, offset?: number): Shape;
  mesh(vertices: Vector, triangles: ArrayLike<number>, options?: { twoSided?: boolean }): Shape;
  heightField(heights: Vector, columns: number, spacing: Vector): Shape;
  /** A shape plugin as a side module.   @returns its id, for shape(id, params) */
  loadShape(source: Source): Promise<string>;
  /** A shape that carom.bringShape() brought.   @returns its id */
  useShape(plugin: ShapePlugin): string;
  /** A function as a shape, see Carom.bringSupport().   @returns its id, for shape(id, params) */
  supportPlugin(support: Support, id: string, params: [string, string, number, number][]): string;
  /** What shape(id, params) takes at least. */
  parameters(id: string): { name: string; unit: string; min: number; max: number }[];
  world(options?: { gravity?: Vector; body_capacity?: number | bigint }): World;
  /** Its worlds first. */
  free(): void;
}

export interface Surface {
  density?: number;
  friction?: number;
  restitution?: number;
  material?: Handle;
}

export interface BodyOptions extends Surface {
  shape?: Shape;
  type?: "static" | "kinematic" | "dynamic";
  position?: Vector;
  orientation?: Quaternion;
  linear_velocity?: Vector;
  angular_velocity?: Vector;
  mass?: number;
  center?: Vector;
  inertia?: Vector;
  linear_damping?: number;
  angular_damping?: number;
  user?: bigint;
  fields?: number;
}

export type Field =
  "position" | "orientation" | "pose" | "linearVelocity" | "angularVelocity" | "velocity" | "force" | "center" | "mass";

/** A field of bodies in the module's memory. Ask for `array` each time: memory that grows empties typed arrays taken
 * before. */
export class BodyView {
  readonly array: Float64Array | Float32Array;
  readonly count: number;
  update(): this;
  write(): void;
  choose(bodies: Body[] | null): void;
  free(): void;
}

export class Body {
  readonly world: World;
  readonly handle: Handle;
  readonly position: number[];
  readonly orientation: number[];
  readonly linearVelocity: number[];
  readonly angularVelocity: number[];
  readonly center: number[];
  readonly mass: number;
  readonly type: "static" | "kinematic" | "dynamic";
  user: bigint;
  readonly asleep: boolean;
  enabled: boolean;
  setPose(position: Vector, orientation?: Quaternion): void;
  setVelocity(linear: Vector, angular?: Vector): void;
  addForce(force: Vector, torque?: Vector): void;
  addImpulse(impulse: Vector, point?: Vector): void;
  addCollider(
    shape: Shape,
    options?: { density?: number; position?: Vector; orientation?: Quaternion; material?: Handle },
  ): Handle;
  setAttribute(attribute: number, ...value: number[]): void;
  wake(): void;
  destroy(): void;
}

export class Joint {
  readonly world: World;
  readonly handle: Handle;
  /** Of carom_joint_desc. */
  readonly desc: {
    kind: number;
    body_a: Handle;
    body_b: Handle;
    position_a: number[];
    orientation_a: number[];
    position_b: number[];
    orientation_b: number[];
    length: number;
  };
  readonly state: {
    broken: number;
    force: number[];
    torque: number[];
    gap: number;
    angle: number;
    coordinate: number[];
    axis: number[];
  };
  setLimit(coordinate: number, lower: number, upper: number): void;
  setMotor(coordinate: number, speed: number, maxForce: number): void;
  setSpring(coordinate: number, target: number, frequency: number, damping?: number): void;
  destroy(): void;
}

export interface Hit {
  body: Body;
  collider: Handle;
  time: number;
  lower: number;
  upper: number;
  point: number[];
  normal: number[];
  outcome: number;
}

/** An error tolerance, per second of motion. One of place and turn may be 0: it is not asked for. */
export interface Accuracy {
  /** m per second of motion; 1e-3 by default */
  place: number;
  /** rad per second of motion; 1e-3 by default */
  turn: number;
  /** Bound of work: that an island may take in a step, 2 to 4096; 256 by default. */
  substeps: number;
}

/** Bodies that contacts, joints and springs connect. Errors are those of its step per second of motion, as estimated. */
export interface Island {
  /** That of its bodies which has the lowest slot; null if that was destroyed since. */
  body: Body | null;
  bodies: number;
  substeps: number;
  /** Of the error, as the estimate takes it. */
  order: number;
  /** "estimated": in this step. "bound": the bound of work was hit. "stalled": more substeps do not lessen its error. */
  flags: ("estimated" | "bound" | "joints_alone" | "stalled")[];
  /** Substeps of all runs of the step. */
  work: number;
  /** m/s */
  place: number;
  /** rad/s */
  turn: number;
  /** The larger of the two over what was asked. */
  share: number;
}

/** How errors grow by themselves. */
export interface Growth {
  /** That were taken. */
  steps: number;
  /** Where the two motions are farthest apart. */
  body: Body | null;
  /** Errors grow e-fold, as in chaos. */
  sensitive: boolean;
  factor: number;
  /** 1/s */
  rate: number;
}

export class World {
  readonly engine: Engine;
  gravity: Vector;
  step(dt?: number): void;
  body(options?: BodyOptions): Body;
  ground(options?: { height?: number; normal?: Vector } & Surface): Body;
  material(desc: { friction?: number; restitution?: number; friction_mix?: number; restitution_mix?: number }): Handle;
  joint(
    kind: keyof typeof constants.JOINTS,
    a: Body | null,
    b: Body | null,
    options?: { at?: Vector; axes?: Quaternion; length?: number; [field: string]: unknown },
  ): Joint;
  joints(): Joint[];
  bodyCount(): number;
  bodies(): Body[];
  view(field: Field, options?: { scalar?: "f64" | "f32"; bodies?: Body[] | null }): BodyView;
  particlePositions(): Float32Array;
  /** 16 hexadecimal digits: the same on every machine. */
  hash(): string;
  save(options?: { whole?: boolean }): Uint8Array;
  restore(bytes: Uint8Array): void;
  fork(): World;
  /** Write down all that is done from now on.   @param options.states  the state after each step, too */
  record(options?: { states?: boolean }): { end(): Uint8Array };
  setDial(name: string | number, value: number): void;
  dial(name: string | number): number;
  setPreset(preset: number): void;
  setEffect(effect: number, mode: number): void;
  timeEffects(on?: boolean): void;
  /** Set an error tolerance, from the next step on: islands take the substeps that their own error asks for. */
  setAccuracy(about?: Partial<Accuracy>): void;
  /** All islands take the substeps of the dial, as in a new world. */
  clearAccuracy(): void;
  /** The tolerance that is set, or null. */
  readonly accuracy: Accuracy | null;
  /** Islands of the last step, worst first; none of a world that asks for nothing. */
  islands(): Island[];
  /** By two copies of the world that begin a little apart; the world itself stays as it is. */
  measureGrowth(options: { steps: number; dt?: number }): Growth;
  report(): Record<string, number | bigint | number[]>;
  /** Keep an account of energy and momentum by cause from now on; no bit changes. */
  keepLedger(on?: boolean): void;
  /** What each cause gave, J, N s, N m s: in the last step, and in all (`total_...`). */
  ledger(): {
    name: string;
    kinetic: number;
    potential: number;
    linear: number[];
    angular: number[];
    total_kinetic: number;
    total_potential: number;
    [field: string]: unknown;
  }[];
  residuals(): Record<string, number | bigint | number[]>;
  contacts(): {
    point: number[];
    normal: number[];
    separation: number;
    normal_impulse: number;
    body_a: Handle;
    body_b: Handle;
    [field: string]: unknown;
  }[];
  plan(): {
    name: string;
    runs: number;
    participants: bigint;
    seconds: number;
    reason: string;
    [field: string]: unknown;
  }[];
  faults(): Record<string, unknown>[];
  draw(what: number, options?: { colouring?: number; scale?: number }): { points: Float32Array; colours: Uint32Array };
  castRay(origin: Vector, direction: Vector, max?: number): Hit | null;
  /** What a shape meets first as it moves by `motion` without turning; time is a fraction of it. */
  castShape(shape: Shape, position: Vector, motion: Vector, orientation?: Quaternion): Hit | null;
  /** All that a shape at a place overlaps. */
  overlaps(shape: Shape, position: Vector, orientation?: Quaternion): Hit[];
  /** Keep events from now on.   @param kinds  CAROM_EVENTS_* bits   @param hitSpeed m/s: faster contacts are hits */
  collectEvents(kinds?: number, hitSpeed?: number): void;
  /** Of the last step. */
  contactEvents(): ContactEvent[];
  /** A field of CAROM_JOINT_BULK_*, as "position", of all joints or of some: each one's numbers in turn. */
  readJoints(field: string, joints?: Joint[]): Float64Array;
  writeJoints(field: string, numbers: Vector, joints?: Joint[]): void;
  /** The tree of joints that a body belongs to. */
  tree(body: Body): Tree;
  colliders(
    radius?: number,
  ): { handle: Handle; body: Body; shape: Handle; position: number[]; orientation: number[]; density: number }[];
  collider(handle: Handle): {
    handle: Handle;
    body: Body;
    shape: Handle;
    position: number[];
    orientation: number[];
    density: number;
  };
  free(): void;
}

export interface ContactEvent {
  kind: "begin" | "end" | "hit";
  body_a: Body;
  body_b: Body;
  collider_a: Handle;
  collider_b: Handle;
  point: number[];
  normal: number[];
  impulse: number;
  approach_speed: number;
}

/** Inverse dynamics of bodies that joints connect without a loop: carom/tree.h. */
export interface Tree {
  readonly size: number;
  /** Forces that give these accelerations at the present pose, N or N m.   @param options  accelerations [size], by
   * default 0; speeds [size], by default those that it has */
  forces(options?: { accelerations?: Vector; speeds?: Vector }): Float64Array;
  /** The mass matrix, [size size] row by row. */
  mass(): Float64Array;
}

/** A shape that walks; it is no body. A frame is world.step(dt), move(walk, dt), push(dt). */
export class Character {
  /** @param options  fields of carom_character_desc, too: step_up, max_slope, ... */
  constructor(
    world: World,
    shape: Shape,
    options?: { position?: Vector; orientation?: Quaternion; [field: string]: unknown },
  );
  readonly world: World;
  /** All of carom_character. */
  readonly state: Record<string, unknown>;
  /** m, of the shape's origin. Setting it teleports. */
  position: number[];
  /** m/s: on firm ground along it and relative to it, else in the world. */
  readonly velocity: number[];
  /** m, from the origin down to the lowest point. */
  readonly foot: number;
  /** "firm": it can walk and jump; "steep": it slides; "air": it falls. */
  readonly ground: "air" | "steep" | "firm";
  /** What was in its way in the last move. */
  readonly contacts: { body: Body; point: number[]; normal: number[]; speed: number }[];
  /** @param walk m/s, relative to the ground   @param jump m/s, taken off with from firm ground */
  move(walk: Vector, dt?: number, jump?: number): void;
  /** Leave forces on what the last move met and on what it stands on, for the next step. */
  push(dt?: number): void;
  /** To crouch, to stand up.   @returns false: there is no place for it, and nothing has changed */
  setShape(shape: Shape, always?: boolean): boolean;
  save(): Uint8Array;
  restore(saved: Uint8Array): void;
}

/** A dynamic body on wheels that are no bodies. A frame is drive(input, dt), then world.step(dt). */
export class Vehicle {
  /** @param wheels  fields of carom_wheel_desc of each   @param about  fields of carom_vehicle_desc */
  constructor(chassis: Body, wheels: Record<string, unknown>[], about?: Record<string, unknown>);
  readonly chassis: Body;
  /** m/s, forward */
  readonly speed: number;
  /** All of carom_vehicle. */
  readonly state: Record<string, unknown>;
  /** All of carom_wheel, of each. */
  readonly wheels: Record<string, unknown>[];
  /** @param input  throttle, brake, handbrake 0 to 1; steer -1 to 1: to the left; gear 0: neutral, -1: reverse */
  drive(
    input?: { throttle?: number; brake?: number; handbrake?: number; steer?: number; gear?: number },
    dt?: number,
  ): void;
  /** Of all wheels, rad/s, forward. */
  setSpin(spin: number): void;
  save(): Uint8Array;
  restore(saved: Uint8Array): void;
}

/** A session that was recorded: of World.record(), of `carom run --record`, of any host. */
export class Recording {
  /** @param engine  keeps the shapes of the recording */
  constructor(engine: Engine, bytes: Uint8Array);
  readonly start: Uint8Array;
  /** dt, s; `calls` were made before the step. */
  readonly steps: { dt: number; calls: { name: string; content: Uint8Array }[] }[];
  /** After each step. */
  readonly hashes: string[];
  /** false: it was cut off. */
  readonly ended: boolean;
  /** As the recording begins. */
  world(): World;
  /** What was done before a step, once more.   @returns whether anything was done */
  perform(world: World, step: number): boolean;
}

/** A shape plugin that was brought into the module, for any of its engines. */
export interface ShapePlugin {
  readonly pointer: number;
}
