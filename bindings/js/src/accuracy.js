// Methods of a world for carom/accuracy.h: accuracy in, steps out.
import * as C from "./constants.js";
import { Body } from "./body.js";

const FLAGS = [
  ["estimated", C.CAROM_ISLAND_ESTIMATED],
  ["bound", C.CAROM_ISLAND_BOUND],
  ["joints_alone", C.CAROM_ISLAND_JOINTS_ALONE],
  ["stalled", C.CAROM_ISLAND_STALLED],
];
const bodyOf = (world, handle) => (handle ? new Body(world, handle) : null);

export const accuracy = {
  /** Set an error tolerance, from the next step on. Islands then take the substeps that their own error asks for.
   *  @param about  place (m per second of motion), turn (rad per second of motion), substeps (the bound of work) */
  setAccuracy(about = {}) {
    const m = this.module;
    m.frame((room) => m.call("carom_world_set_accuracy", this.pointer, m.put(room, "carom_accuracy", about)));
  },

  /** All islands take the substeps of the dial, as in a new world. */
  clearAccuracy() {
    this.module.call("carom_world_set_accuracy", this.pointer, 0);
  },

  /** The tolerance that is set, or null. */
  get accuracy() {
    const m = this.module;
    return m.frame((room) => {
      const present = room(4);
      const { place, turn, substeps } = m.get(
        "carom_accuracy",
        (at) => m.raw.carom_world_get_accuracy(this.pointer, at, present, m.error),
        "accuracy",
      );
      return m.view.getUint32(present, true) ? { place, turn, substeps } : null;
    });
  },

  /** Islands of the last step, worst first; none of a world that asks for nothing. */
  islands() {
    const m = this.module;
    return m
      .list("carom_island", (...out) => m.raw.carom_world_get_islands(this.pointer, ...out, m.error), "islands")
      .map((island) => ({
        ...island,
        body: bodyOf(this, island.body),
        work: Number(island.work),
        flags: FLAGS.filter(([, bit]) => island.flags & bit).map(([name]) => name),
      }));
  },

  /** How errors grow from here, by two copies of the world that begin a little apart; the world stays as it is.
   *  @param dt s   @param steps  several e-foldings of what is looked for, and more than the longest period */
  measureGrowth({ dt = 1 / 60, steps } = {}) {
    const m = this.module;
    const { body, sensitive, factor, rate, ...found } = m.get(
      "carom_growth",
      (at) => m.raw.carom_world_measure_growth(this.pointer, dt, steps, at, m.error),
      "measureGrowth",
    );
    return { steps: found.steps, body: bodyOf(this, body), sensitive: sensitive !== 0, factor, rate };
  },
};
