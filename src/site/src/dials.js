// Settings: presets and dials of A or, in a comparison, of B, in units that people use; what is drawn; the scene's own
// numbers. Every change acts at once.

const CHOICE = 2,
  INTEGER = 1;
const NOTCHES = 400; // of a slider
const DECADES = 100; // bounds farther apart than this factor: a slider goes by factors
const LEAST = 1e-9; // of the default: where such a slider begins if its dial's bound is 0
const SMALL = 0.1; // m, m/s: a dial whose default is less is shown in mm

/** The first ones, by what they are for; all others are folded away. */
const FIRST = ["substeps", "contact_frequency", "contact_damping", "restitution_speed", "continuous", "sleep"];

/** The unit that a dial is shown in.   @returns { unit, factor }   shown = factor * value */
export function shownIn({ unit, initial }) {
  if (unit === "rad") return { unit: "°", factor: 180 / Math.PI };
  if (/^m(\/s)?$/.test(unit) && initial > 0 && initial < SMALL) return { unit: `m${unit}`, factor: 1e3 };
  return { unit: unit === "1" ? "" : unit, factor: 1 };
}

export const element = (name, properties = {}, children = []) => {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...children);
  return made;
};
function row(label, title, children) {
  for (const child of children) child.ariaLabel = label;
  return element("label", { className: "row", title }, [element("span", { textContent: label }), ...children]);
}
const folder = (title, id) => element("details", { id: id ?? "" }, [element("summary", { textContent: title })]);

function choice(options, value, set) {
  const select = element("select");
  for (const [name, number] of options) select.add(new Option(name, String(number)));
  select.value = String(value);
  select.onchange = () => set(Number(select.value));
  return select;
}

/** In so few letters that a box holds them. */
function few(x) {
  const plain = String(Number(x.toPrecision(4)));
  return plain.length <= 7 ? plain : String(Number(x.toPrecision(4)).toExponential());
}

/** A number with a slider beside it.   @param get, set  in the unit shown   @param bounds { min, max, whole, initial } */
function number({ min, max, whole, initial }, get, set) {
  const byFactor = min >= 0 && max / Math.max(min, 1e-12) > DECADES && !(whole && max <= DECADES),
    low = min > 0 ? min : Math.max(LEAST * initial, 1e-4 * (initial || 1)),
    high = Math.min(max, 1e4 * (initial || 1));
  const toNotch = (x) =>
      byFactor
        ? x <= low
          ? 0
          : (NOTCHES * Math.log(x / low)) / Math.log(high / low)
        : (NOTCHES * (x - min)) / (max - min),
    fromNotch = (n) =>
      byFactor ? (n <= 0 ? min : low * (high / low) ** (n / NOTCHES)) : min + ((max - min) * n) / NOTCHES;
  const tidy = (x) => (whole ? Math.round(x) : Number(x.toPrecision(3)));
  const slider = element("input", { type: "range", min: 0, max: NOTCHES, step: 1 }),
    box = element("input", { type: "number", step: whole ? 1 : "any" });
  const show = () => {
    const value = get();
    if (document.activeElement !== box) box.value = few(value);
    slider.value = String(Math.min(NOTCHES, Math.max(0, toNotch(value))));
  };
  slider.oninput = () => (set(Math.min(max, Math.max(min, tidy(fromNotch(Number(slider.value)))))), show());
  box.onchange = () => {
    const value = Number(box.value);
    if (box.value !== "" && Number.isFinite(value))
      set(Math.min(max, Math.max(min, whole ? Math.round(value) : value)));
    box.value = few(get());
    show();
  };
  return { parts: [slider, box], show };
}

export class Dials {
  /** @param page  carom, apply(which, action), dial(which, name), shown, onMake(values), onShown() */
  constructor(box, page) {
    Object.assign(this, { page, shows: [], which: 0 });
    this.side = choice(
      [
        ["A", 0],
        ["B", 1],
      ],
      0,
      (which) => ((this.which = which), this.refresh()),
    );
    this.sideRow = row("of", "which of the two settings these are", [this.side]);
    const names = page.carom.presets();
    this.preset = choice([["choose", -1], ...names.map((name, i) => [name, i])], -1, (value) => {
      if (value >= 0) page.apply(this.which, { do: "preset", value });
      this.refresh();
    });
    const dials = page.carom.dials(),
      more = folder("All dials"),
      draw = folder("Draw");
    this.knobs = folder("Scene: its own numbers");
    box.append(this.sideRow, row("preset", "from fast to exact: all dials at once", [this.preset]));
    for (const name of FIRST) box.append(this.#dial(dials.find((d) => d.name === name)));
    for (const dial of dials) if (!FIRST.includes(dial.name)) more.append(this.#dial(dial));
    for (const name of Object.keys(page.shown)) {
      const check = element("input", { type: "checkbox", checked: page.shown[name] });
      check.onchange = () => ((page.shown[name] = check.checked), page.onShown());
      draw.append(row(name, "", [check]));
    }
    box.append(this.knobs, draw, more);
  }

  #dial(dial) {
    const { page } = this,
      { unit, factor } = shownIn(dial),
      get = () => page.dial(this.which, dial.name),
      set = (value) => page.apply(this.which, { do: "dial", name: dial.name, value });
    const label = dial.name.replaceAll("_", " ");
    if (dial.kind === CHOICE) {
      const select = choice(
        dial.choices.map((name, i) => [name.replaceAll("_", " "), i]),
        get(),
        set,
      );
      this.shows.push(() => (select.value = String(get())));
      return row(label, dial.summary, [select]);
    }
    const whole = dial.kind === INTEGER,
      bounds = { min: dial.min * factor, max: dial.max * factor, initial: dial.initial * factor, whole };
    const { parts, show } = number(
      bounds,
      () => get() * factor,
      (shown) => set(shown / factor),
    );
    this.shows.push(show);
    return row(label, dial.summary, [...parts, element("i", { textContent: unit })]);
  }

  /** The numbers that a scene is made of, and a button that makes it of others. @param knobs  of the index, or none */
  show(knobs = []) {
    for (const old of this.knobs.querySelectorAll(".row, button")) old.remove();
    this.knobs.hidden = !knobs.length;
    const values = Object.fromEntries(knobs.map((k) => [k.name, k.value]));
    for (const knob of knobs) {
      const { parts, show } = number(
        { ...knob, initial: knob.value },
        () => values[knob.name],
        (value) => (values[knob.name] = value),
      );
      show();
      this.knobs.append(
        row(knob.name.replaceAll("_", " "), knob.help, [...parts, element("i", { textContent: knob.unit })]),
      );
    }
    this.knobs.append(
      element("button", {
        type: "button",
        textContent: "Make the scene anew",
        onclick: () => this.page.onMake(values),
      }),
    );
  }

  /** @param two  is B there? */
  refresh(two = !this.sideRow.hidden) {
    this.sideRow.hidden = !two;
    if (!two) this.which = 0;
    this.side.value = String(this.which);
    for (const show of this.shows) show();
  }
}
