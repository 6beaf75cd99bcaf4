// What error do you accept? One slider, from a rough step to a micrometre; beside it what that costs, and how far off the
// bodies are: from the truth where a scene's is known, else by the engine's own estimate.
import { element } from "./dials.js";

const MOST = 12; // islands that are listed; the rest is summed
const RECENT = 20; // steps whose cost is averaged
const TOLERANCES = [1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6]; // m and rad for each second of motion
const NAMES = ["10 cm", "1 cm", "1 mm", "0.1 mm", "10 µm", "1 µm"];
const ROUGH = 0,
  USUAL = 1; // stops of the slider; then the tolerances

/** A step as many games take it: one substep over soft contacts, flight of first order. */
const ROUGH_DIALS = {
  solver: "soft_step",
  integrator: "semi_implicit_euler",
  rotation: "implicit",
  substeps: 1,
  joint_order: 0,
};
const NOTES = {
  bound: "the bound of work was hit",
  stalled: "more substeps do not lessen this error",
  joints_alone: "joints alone hold it",
  estimated: "estimated in this step",
};

/** Where it shows without a word: scenes whose truth is known. */
export const TRIALS = [
  ["accuracy_overhang", "A tower at its limit, less 1 %"],
  ["accuracy_thin_arch", "An arch 1 % thicker than falls"],
  ["accuracy_reach", "A robot's arm that must reach a mark"],
  ["accuracy_tray", "A coin that rolls on a tray"],
  ["accuracy_tower100", "A tower that carries 100 kg on 1 kg"],
  ["accuracy_cards", "A house of cards"],
  ["accuracy_massratio1e4", "10 t on a cube of 1 kg"],
  ["accuracy_pendulum", "A pendulum"],
  ["accuracy_bricard", "A ring that turns inside out"],
];

export const number = (x) => String(Number(x.toPrecision(2)));
const UNITS = [
  [1, 1, "m"],
  [1e-2, 1e-2, "cm"],
  [1e-4, 1e-3, "mm"],
  [1e-7, 1e-6, "µm"],
  [1e-9, 1e-9, "nm"],
]; // from, is
/** 0.00042 -> "0.42 mm" */
export function length(metres) {
  if (!(metres > 0)) return "0";
  if (metres < 1e-9) return "less than 1 nm";
  const [, size, unit] = UNITS.find(([least]) => metres >= least);
  return `${number(metres / size)} ${unit}`;
}
/** Share of a bar whose ends are powers of ten. */
const share = (x, low, high) => `${100 * Math.min(1, Math.max(0.01, (Math.log10(x) - low) / (high - low)))}%`;

export class AccuracyPanel {
  /** @param box  the element that holds the controls
   *  @param page  sims() [Simulation], act(which, action), follow(index of a body), dials(), restart(), duel(), error(which) */
  constructor(box, page) {
    Object.assign(this, { box, page });
    const of = (id) => box.querySelector(`#accuracy-${id}`);
    for (const id of ["slider", "told", "side", "sum", "islands", "cost", "error", "duel", "list"]) this[id] = of(id);
    this.slider.max = String(USUAL + TOLERANCES.length);
    this.slider.oninput = () => this.#ask(Number(this.slider.value));
    this.side.onchange = () => this.update();
    this.duel.onclick = () => page.duel(this.actions(ROUGH, null));
    this.dials = new Map(page.dials().map((dial) => [dial.name, dial]));
  }

  get which() {
    return Math.min(Number(this.side.value), this.page.sims().length - 1);
  }
  get #sim() {
    return this.page.sims()[this.which];
  }

  #rough(name) {
    const value = ROUGH_DIALS[name];
    return typeof value === "string" ? this.dials.get(name).choices.indexOf(value) : value;
  }

  /** What brings a world to a stop of the slider.   @param world  null: one as it is made */
  actions(stop, world) {
    const wanted = new Map();
    for (const name of Object.keys(ROUGH_DIALS))
      wanted.set(name, stop === ROUGH ? this.#rough(name) : this.dials.get(name).initial);
    const asked = TOLERANCES[stop - USUAL - 1] ?? 0;
    for (const name of ["accuracy_place", "accuracy_turn"]) wanted.set(name, asked);
    return [...wanted]
      .filter(([name, value]) => (world ? world.dial(name) : this.dials.get(name).initial) !== value)
      .map(([name, value]) => ({ do: "dial", name, value }));
  }

  /** Where a world stands on the slider. */
  #stop(world) {
    const asked = world.accuracy && Math.max(world.accuracy.place, world.accuracy.turn);
    if (asked) {
      const near = TOLERANCES.map((x) => Math.abs(Math.log(x / asked)));
      return USUAL + 1 + near.indexOf(Math.min(...near));
    }
    return Object.keys(ROUGH_DIALS).every((name) => world.dial(name) === this.#rough(name)) ? ROUGH : USUAL;
  }

  /** All of it are dials, so links, snapshots and what is gone back to have them. What has fallen does not rise by
   *  exactness: a scene whose truth is known begins anew. */
  #ask(stop) {
    const { which } = this;
    this.page.restart();
    for (const action of this.actions(stop, this.#sim.world)) this.page.act(which, action);
    this.update();
  }

  /** What a side is set to, in a few words, and how far off it is where that is known. */
  briefly(which) {
    const { world } = this.page.sims()[which],
      stop = this.#stop(world),
      off = this.page.error(which);
    const name =
      stop === ROUGH ? "a rough step" : stop === USUAL ? "usual dials" : `${NAMES[stop - USUAL - 1]} accepted`;
    return name + (Number.isFinite(off) ? `, ${length(off)} off` : "");
  }

  update() {
    const sims = this.page.sims(),
      sim = this.#sim,
      { world } = sim,
      stop = this.#stop(world),
      asked = world.accuracy && Math.max(world.accuracy.place, world.accuracy.turn);
    this.side.closest("p").hidden = sims.length < 2;
    this.slider.value = String(stop);
    this.told.textContent = asked
      ? `at most ${length(asked)} and ${number(asked)} rad off for each second of motion`
      : stop === ROUGH
        ? "a rough step: one substep, first order, as many games take it"
        : "no bound: the usual dials, which are good for play";
    this.slider.setAttribute("aria-valuetext", asked ? length(asked) : stop === ROUGH ? "a rough step" : "usual");
    const islands = asked ? world.islands() : [];
    this.#meters(sim, islands, asked);
    this.#sum(islands);
    this.#table(islands);
    this.list.hidden = !islands.length;
  }

  #meters(sim, islands, asked) {
    const recent = sim.seconds.slice(Math.max(0, sim.step - RECENT), sim.step).filter(Number.isFinite),
      ms = recent.length ? (1e3 * recent.reduce((a, b) => a + b, 0)) / recent.length : NaN,
      work = islands.reduce((sum, island) => sum + island.work, 0);
    const told = (meter, size, text) => {
      meter.querySelector("i").style.width = size;
      meter.querySelector("span").textContent = text;
    };
    told(
      this.cost,
      Number.isFinite(ms) ? share(ms, -2, 2) : "0",
      Number.isFinite(ms)
        ? `${number(ms)} ms a step${work ? `, ${work} ${work === 1 ? "substep" : "substeps"}` : ""}`
        : "no step yet",
    );
    const off = this.page.error(this.which);
    if (Number.isFinite(off)) told(this.error, share(Math.max(off, 1e-12), -9, 1), `${length(off)} off the truth`);
    else if (islands.length) {
      const estimate = islands[0].share * asked;
      told(this.error, share(estimate, -9, 1), `${length(estimate)} a second, by the engine's estimate`);
    } else told(this.error, "0", "not known: ask for an accuracy, or try a scene below");
  }

  #sum(islands) {
    const work = islands.reduce((sum, island) => sum + island.work, 0),
      over = islands.filter((island) => island.share > 1).length;
    this.sum.textContent = islands.length
      ? `${islands.length} ${islands.length === 1 ? "island" : "islands"}, ${work} substeps in all; ` +
        `the worst errs by ${percent(islands[0].share)} ${islands[0].share > 10 ? "" : "of "}what was asked` +
        (over > 1 ? `, ${over} by more than it` : "")
      : "";
  }

  #table(islands) {
    const { bodies, index } = this.#sim,
      table = this.islands;
    table.replaceChildren();
    if (!islands.length) return;
    const head = table.createTHead().insertRow();
    for (const [text, title] of [
      ["island", "the body of it that was made first, and how many there are"],
      ["estimate", "of its error, beside what was asked"],
      ["substeps", "that it took"],
      ["order", "of its error, as the estimate takes it"],
      ["cost", "substeps of all runs of the step"],
    ])
      head.append(element("th", { textContent: text, title, scope: "col" }));
    const body = table.createTBody();
    for (const island of islands.slice(0, MOST)) {
      const tr = body.insertRow(),
        at = island.body ? index.get(island.body.handle) : undefined;
      tr.classList.toggle("over", island.share > 1);
      tr.title = [
        `${number(island.place)} m/s, ${number(island.turn)} rad/s`,
        ...island.flags.map((flag) => NOTES[flag]),
      ].join("; ");
      tr.insertCell().append(bodies[at] ? this.#button(at, island.bodies) : `${island.bodies}`);
      const note = island.flags.find((flag) => flag === "bound" || flag === "stalled");
      for (const text of [percent(island.share) + (note ? ` ${note}` : ""), island.substeps, island.order, island.work])
        Object.assign(tr.insertCell(), { textContent: text, className: "number" });
    }
  }

  #button(at, count) {
    const button = element("button", {
      type: "button",
      textContent: `${at}${count > 1 ? ` +${count - 1}` : ""}`,
      title: "follow it",
      onclick: () => this.page.follow(at),
    });
    button.setAttribute("aria-label", `Follow body ${at} of an island of ${count}`);
    return button;
  }
}

const percent = (share) => (share > 10 ? `${number(share)} times` : `${number(100 * share)} %`);
