// The control panel: presets and dials of A and, in a comparison, of B; what is drawn. Every change acts at once.
import GUI from "lil-gui";

const KIND_CHOICE = 2,
  KIND_INTEGER = 1;
const FEW = 64; // whole numbers that a slider can tell apart
const DECADES = 100; // bounds farther apart than this factor: the slider is of the exponent

/** One dial as a row.   @param read () => value   @param write (value) => void; may throw */
function addDial(folder, dial, read, write) {
  const model = {
    get value() {
      return read();
    },
    set value(v) {
      write(v);
    },
  };
  let row,
    label = dial.name;
  if (dial.kind === KIND_CHOICE) {
    row = folder.add(model, "value", Object.fromEntries(dial.choices.map((c, i) => [c, i])));
  } else if (dial.kind === KIND_INTEGER) {
    const whole = {
      get value() {
        return read();
      },
      set value(v) {
        write(Math.min(dial.max, Math.max(dial.min, Math.round(v))));
      },
    };
    row =
      dial.max - dial.min <= FEW
        ? folder.add(whole, "value", dial.min, dial.max, 1)
        : folder.add(whole, "value").step(1);
  } else if (dial.min >= 0 && dial.max / Math.max(dial.min, 1e-12) > DECADES) {
    const least = Math.log10(Math.max(dial.min, 1e-12)),
      most = Math.log10(Math.min(dial.max, 1e12));
    const log = {
      get value() {
        return Math.max(least, Math.log10(Math.max(read(), 1e-12)));
      },
      set value(v) {
        write(dial.min === 0 && v <= least ? 0 : Math.min(dial.max, Math.max(dial.min, 10 ** v)));
      },
    };
    row = folder.add(log, "value", least, most, 0.01);
    label = `log₁₀ ${dial.name}`;
  } else {
    row = folder.add(model, "value", dial.min, dial.max);
  }
  row.name(label);
  row.domElement.title = `${dial.summary}${dial.unit ? ` (${dial.unit})` : ""}`;
  return row;
}

const FIRST = [
  "substeps",
  "solver",
  "integrator",
  "velocity_iterations",
  "contact_frequency",
  "contact_damping",
  "gjk_tolerance",
  "sleep",
];

export class Panel {
  /** @param page  carom, apply(which, action), dial(which, name), shown, onCompare(on), onMake(values), onShown() */
  constructor(element, page) {
    this.page = page;
    this.gui = new GUI({ container: element, title: "Settings", touchStyles: true });
    this.compare = { on: false };
    this.a = this.#settings("A: dials", 0);
    this.gui
      .add(this.compare, "on")
      .name("Compare A with B")
      .onChange((on) => page.onCompare(on));
    this.b = this.#settings("B: dials", 1);
    this.b.hide();
    this.knobs = this.gui.addFolder("Scene: its own numbers").close();
    const draw = this.gui.addFolder("Draw").close();
    for (const name of Object.keys(page.shown)) draw.add(page.shown, name).onChange(() => page.onShown());
  }

  #settings(title, which) {
    const { page } = this,
      dials = page.carom.dials();
    const folder = this.gui.addFolder(title);
    const rows = [];
    const refresh = () => rows.forEach((row) => row.updateDisplay());
    const preset = { value: "" };
    const names = page.carom.presets();
    folder
      .add(preset, "value", { choose: "", ...Object.fromEntries(names.map((n) => [n, n])) })
      .name("preset")
      .onChange((name) => {
        if (name) page.apply(which, { do: "preset", value: names.indexOf(name) });
        refresh();
      });
    const more = folder.addFolder("More dials").close();
    const add = (dial, into) =>
      rows.push(
        addDial(
          into,
          dial,
          () => page.dial(which, dial.name),
          (value) => page.apply(which, { do: "dial", name: dial.name, value }),
        ),
      );
    for (const name of FIRST)
      add(
        dials.find((d) => d.name === name),
        folder,
      );
    for (const dial of dials) if (!FIRST.includes(dial.name)) add(dial, more);
    folder.refresh = refresh;
    return folder;
  }

  /** The numbers that a scene is made of, and a button that makes it of others. @param knobs  of the index, or none */
  show(knobs = []) {
    for (const row of [...this.knobs.controllers]) row.destroy();
    this.knobs[knobs.length ? "show" : "hide"]();
    const values = Object.fromEntries(knobs.map((k) => [k.name, k.value]));
    for (const knob of knobs) {
      const row = this.knobs.add(values, knob.name).min(knob.min).max(knob.max);
      if (knob.whole) row.step(1);
      row.name(knob.unit ? `${knob.name} (${knob.unit})` : knob.name);
      row.domElement.title = knob.help;
    }
    if (knobs.length) this.knobs.add({ make: () => this.page.onMake(values) }, "make").name("Make the scene anew");
  }

  refresh() {
    this.a.refresh();
    this.b[this.compare.on ? "show" : "hide"]();
    if (this.compare.on) this.b.refresh();
    for (const row of this.gui.controllers) row.updateDisplay();
  }
}
