// A scene that runs, and can go back: the world, what was done to it and when, and snapshots. Nothing here draws.
//
// Everything that changes the world is an action, written down under the step before which it acts. A step in the
// past is the
// nearest snapshot before it and the same actions again, so it has the same bits.
import { constants as C } from "carom";
import { act } from "./actions.js";
import { driverOf } from "./drive.js";

const EVERY = 20; // steps from one snapshot to the next
const MOST_BYTES = 96 << 20; // of snapshots; of older ones every second is dropped

export class Simulation {
  /** @param start  Uint8Array: a whole snapshot   @param dt s   @param settings  actions before the first step:
   * dials, presets   @param recording  a session that goes with it: its calls are made again, its steps are as long
   *  @param steered  what a visitor steers in it, for driverOf() */
  constructor(engine, start, dt, settings = [], recording = null, steered = null) {
    Object.assign(this, { engine, dt, recording });
    this.actions = new Map(); // step -> actions
    this.lastAction = -1;
    this.snapshots = new Map(); // step -> { bytes, structure, shape counts }
    this.structure = 0; // changes with the set of bodies
    this.newest = 0; // the farthest step that was reached
    this.energy = []; // J, kinetic, by step
    this.seconds = []; // s of computing, by step
    this.errors = []; // m off the truth, by step: of those that were drawn
    this.accounts = false; // kept of energy by cause?
    this.causes = new Map(); // name -> J that it gave, by step
    this.#build(start);
    this.step = 0;
    this.settings = settings;
    try {
      this.driver = steered && driverOf(this, steered);
      for (const action of settings) act(this, action);
    } catch (error) {
      this.free(); // or the engine could not be freed, and would say that instead
      throw error;
    }
    this.#keep();
  }

  #build(bytes) {
    const world = this.engine.world();
    try {
      world.restore(bytes);
    } catch (error) {
      world.free();
      throw error;
    }
    this.poses?.free();
    this.world?.free();
    this.world = world;
    if (this.accounts) world.keepLedger();
    this.poses = world.view("pose");
    this.refresh();
  }

  /** After bodies came or went: who there is, and what they look like. */
  refresh() {
    this.bodies = this.world.bodies();
    this.index = new Map(this.bodies.map((body, i) => [body.handle, i]));
    this.parts = this.world.colliders().map((c) => ({ ...c, body: this.index.get(c.body.handle) }));
    ++this.structure;
  }

  /** Do something now. What was to come after the present step is forgotten.   @throws then nothing has changed */
  do(action) {
    const isSetting = action.do === "dial" || action.do === "preset";
    if (this.step < this.newest) this.#forgetFuture();
    if (isSetting && this.step === 0 && !this.actions.size) {
      act(this, action);
      const before = this.settings.findIndex((a) => a.do === "dial" && action.do === "dial" && a.name === action.name);
      if (before >= 0) this.settings.splice(before, 1);
      this.settings.push(action); // the scene as it starts
      this.#keep();
      return;
    }
    act(this, action); // throws before it is written down
    const done = this.actions.get(this.step) ?? [];
    // Of a slider that is drawn along, and of what is asked of a driver, the last value counts.
    const isLater = { dial: (a) => a.name === action.name, input: () => true }[action.do] ?? (() => false),
      before = done.findIndex((a) => a.do === action.do && isLater(a));
    if (before >= 0) done.splice(before, 1);
    this.actions.set(this.step, [...done, action]);
    this.lastAction = Math.max(this.lastAction, this.step);
  }

  #forgetFuture() {
    for (const map of [this.actions, this.snapshots])
      for (const step of map.keys()) if (step > this.step) map.delete(step);
    // Actions of this very step were done again when it was reached, and stay.
    this.newest = this.step;
    this.energy.length = Math.min(this.energy.length, this.step);
    this.seconds.length = Math.min(this.seconds.length, this.step);
    this.errors.length = Math.min(this.errors.length, this.step + 1);
    for (const list of this.causes.values()) list.length = Math.min(list.length, this.step);
    this.lastAction = Math.max(-1, ...this.actions.keys());
  }

  /** One step on: in the past with the actions that were done then. */
  advance() {
    if (this.recording?.perform(this.world, this.step)) this.refresh();
    this.dt = this.recording?.steps[this.step]?.dt ?? this.dt;
    this.driver?.before(this.dt);
    this.world.step(this.dt);
    this.driver?.after(this.dt);
    const report = this.world.report();
    this.energy[this.step] = report.linear_energy + report.angular_energy;
    this.seconds[this.step] = report.total_seconds;
    if (this.accounts) this.#book();
    ++this.step;
    this.report = report;
    // A snapshot has what was done before, not what is done at this step.
    if (this.step % EVERY === 0 && !this.snapshots.has(this.step)) this.#keep();
    const again = this.step <= this.newest ? (this.actions.get(this.step) ?? []) : [];
    this.newest = Math.max(this.newest, this.step);
    for (const action of again) act(this, action);
  }

  /** Keep accounts of energy by cause from now on; no bit changes. */
  account(on) {
    if (this.accounts === on) return;
    this.accounts = on;
    this.world.keepLedger(on);
  }

  #book() {
    for (const { name, kinetic, potential } of this.world.ledger()) {
      if (!this.causes.has(name)) this.causes.set(name, []);
      this.causes.get(name)[this.step] = kinetic + potential;
    }
  }

  #keep() {
    const kept = this.world.save({ whole: true });
    kept.driver = this.driver?.save();
    this.snapshots.set(this.step, kept);
    let bytes = 0;
    for (const { length } of this.snapshots.values()) bytes += length;
    if (bytes < MOST_BYTES) return;
    [...this.snapshots.keys()]
      .sort((a, b) => a - b)
      .forEach((step, i, all) => {
        if (i % 2 === 1 && i < all.length - 2) this.snapshots.delete(step);
      });
  }

  /** Be at a step, past or to come. */
  seek(step) {
    if (step < this.step) {
      const from = Math.max(...[...this.snapshots.keys()].filter((s) => s <= step));
      const kept = this.snapshots.get(from);
      this.#build(kept);
      this.driver?.restore(kept.driver);
      this.step = from;
      // The first snapshot was taken after the settings, but before what was done at step 0.
      for (const action of this.actions.get(from) ?? []) act(this, action);
      this.report = undefined;
    }
    while (this.step < step) this.advance();
  }

  hash() {
    return this.world.hash();
  }

  /** All actions, for a link: [[step, action], ...]. */
  log() {
    return [...this.actions]
      .sort((a, b) => a[0] - b[0])
      .flatMap(([step, list]) => list.map((action) => [step, action]));
  }

  /** The actions of a link, before the first step is made. */
  load(log) {
    for (const [step, action] of log) {
      if (step === 0) {
        this.do(action);
        continue;
      }
      if (!this.actions.has(step)) this.actions.set(step, []);
      this.actions.get(step).push(action);
      this.newest = Math.max(this.newest, step);
      this.lastAction = this.newest;
    }
  }

  free() {
    this.driver?.free();
    this.poses.free();
    this.world.free();
  }
}

export const DRAW = {
  contacts: C.CAROM_DRAW_CONTACTS,
  joints: C.CAROM_DRAW_JOINTS,
  bounds: C.CAROM_DRAW_BOUNDS,
  outlines: C.CAROM_DRAW_SHAPES | C.CAROM_DRAW_SCENERY,
  frames: C.CAROM_DRAW_BODIES,
};

/** m: root mean square of the distances between a body of the one and the same of the other. */
export function apart(one, other) {
  const [a, b] = [one, other].map((sim) => sim.poses.update());
  if (a.count !== b.count || !a.count) return NaN;
  const x = a.array,
    y = b.array;
  let sum = 0;
  for (let i = 0; i < a.count; ++i) for (let k = 0; k < 3; ++k) sum += (x[7 * i + k] - y[7 * i + k]) ** 2;
  return Math.sqrt(sum / a.count);
}
