// Accuracy in, steps out: a tolerance for the scene that runs, and what each island of the last step made of it.
const MOST = 12; // islands that are listed; the rest is summed
const number = (x) => String(Number(x.toPrecision(2)));
const NOTES = {
  bound: "the bound of work was hit",
  stalled: "more substeps do not lessen this error",
  joints_alone: "joints alone hold it",
  estimated: "estimated in this step",
};

export class AccuracyPanel {
  /** @param box  the element that holds the controls
   *  @param page  sims() [Simulation], act(which, action), follow(index of a body) */
  constructor(box, page) {
    this.box = box;
    this.page = page;
    const of = (id) => box.querySelector(`#accuracy-${id}`);
    Object.assign(this, { on: of("on"), slider: of("slider"), told: of("told"), side: of("side") });
    Object.assign(this, { sum: of("sum"), table: of("islands") });
    this.on.onchange = this.slider.oninput = () => this.#ask();
    this.side.onchange = () => this.update();
  }

  get #sim() {
    const sims = this.page.sims();
    return sims[Math.min(Number(this.side.value), sims.length - 1)];
  }

  /** Both are dials, so links, snapshots and what is gone back to have them. */
  #ask() {
    const value = this.on.checked ? Number((10 ** Number(this.slider.value)).toPrecision(3)) : 0,
      which = this.page.sims().indexOf(this.#sim);
    for (const name of ["accuracy_place", "accuracy_turn"]) this.page.act(which, { do: "dial", name, value });
    this.update();
  }

  /** What is asked now, and the islands of the last step. */
  update() {
    const sims = this.page.sims(),
      { world } = this.#sim;
    this.side.parentElement.hidden = sims.length < 2;
    const asked = world.accuracy,
      value = asked && Math.max(asked.place, asked.turn);
    this.on.checked = asked !== null;
    this.slider.disabled = asked === null;
    if (value) this.slider.value = Math.log10(value);
    this.told.textContent = asked ? `${number(value)} m/s, rad/s` : "off: each step takes its dial's substeps";
    const islands = asked ? world.islands() : [];
    this.#sum(islands);
    this.#list(islands);
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

  #list(islands) {
    const { bodies, index } = this.#sim;
    this.table.replaceChildren();
    this.table.hidden = !islands.length;
    if (!islands.length) return;
    const head = this.table.createTHead().insertRow();
    for (const [text, title] of [
      ["island", "the body of it that was made first, and how many there are"],
      ["estimate", "of its error, beside what was asked"],
      ["substeps", "that it took"],
      ["order", "of its error, as the estimate takes it"],
      ["cost", "substeps of all runs of the step"],
    ])
      head.append(Object.assign(document.createElement("th"), { textContent: text, title, scope: "col" }));
    const body = this.table.createTBody();
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
    const button = Object.assign(document.createElement("button"), {
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
