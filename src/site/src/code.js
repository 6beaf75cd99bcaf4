// The code of what is shown: the files of the examples, in each language, beside the picture. JavaScript runs here, as it
// is or as a visitor changed it, and the picture shows its world.
const LANGUAGES = [
  ["c", "C"],
  ["cpp", "C++"],
  ["python", "Python"],
  ["js", "JavaScript"],
  ["rust", "Rust"],
];
const LONGEST = 20; // s that a program may run
const REMEMBERED = "carom language"; // docs.js has the same

/** Which example tells of a scene's kind, where the scene is not an example itself. */
const KIN = {
  drive: "car",
  walk: "character",
  arm: "arm",
  ragdoll: "motor",
  net: "motor",
  conveyor: "motor",
  seesaw: "events",
  quoits: "events",
  catapult: "events",
  terrain: "terrain",
  particles: "arrays",
  falling: "arrays",
  bullet: "sweep",
  wall: "stack",
  pyramid: "stack",
  stacks: "stack",
  sleepers: "stack",
};
export const kinOf = (row) => row.example ?? KIN[row.name] ?? (row.name?.startsWith("accuracy_") ? "accuracy" : "save");

/** Examples as rows of the list of scenes.   @returns [{ name, example, title, files, ... }] */
export async function exampleRows() {
  const response = await fetch("examples/index.json");
  if (!response.ok) throw new Error("examples/index.json is missing: build the page again");
  return (await response.json()).map((example) => ({
    ...example,
    name: `example_${example.name}`,
    example: example.name,
  }));
}

/** Run a program to its end, apart from the page.
 *  @returns { printed, error, recording, shapes, beside }   @throws Error (it does not end) */
export function run(program, module) {
  const worker = new Worker(new URL("run_worker.js", document.baseURI), { type: "module" });
  return new Promise((done, fail) => {
    const late = setTimeout(
      () => fail(new Error(`the program did not end in ${LONGEST} s, and was stopped: step less, or a smaller world`)),
      1000 * LONGEST,
    );
    worker.onmessage = ({ data }) => (clearTimeout(late), done(data));
    worker.onerror = (e) => (clearTimeout(late), fail(new Error(e.message || "the program could not be started")));
    worker.postMessage({ program, module });
  }).finally(() => worker.terminate());
}

/** What is no body, by step, as a picture draws it. */
export function besideOf(things) {
  if (!things.length) return null;
  const at = (poses, step) => poses[Math.min(step, poses.length - 1)] ?? poses.find(Boolean);
  return { looks: () => things.map(({ look }) => look), poses: (step) => things.map(({ poses }) => at(poses, step)) };
}

export class CodePanel {
  /** @param compiled async () => the engine's code   @param show async (row, result): the world of a program that ran */
  constructor(box, { rows, compiled, show }) {
    Object.assign(this, { box, compiled, show });
    this.examples = new Map(rows.map((row) => [row.example, row]));
    this.texts = new Map(); // file -> text, as it was fetched
    this.language = localStorage.getItem(REMEMBERED) ?? "Python";
    const find = (name) => box.querySelector(`[data-code="${name}"]`);
    for (const part of ["title", "why", "tabs", "text", "edit", "copy", "run", "printed", "file"])
      this[part] = find(part);
    this.tabs.append(
      ...LANGUAGES.map(([language, name]) => {
        const tab = Object.assign(document.createElement("button"), { type: "button", textContent: name });
        tab.setAttribute("role", "tab");
        tab.dataset.language = language;
        tab.onclick = () => this.#choose(name);
        tab.onkeydown = (e) => {
          const all = [...this.tabs.children],
            way = { ArrowRight: 1, ArrowLeft: -1 }[e.key];
          if (way)
            (all.at((all.indexOf(tab) + way) % all.length).click(), this.tabs.querySelector('[tabindex="0"]').focus());
        };
        return tab;
      }),
    );
    this.copy.onclick = async () => {
      await navigator.clipboard.writeText(this.shownText()).catch(() => getSelection().selectAllChildren(this.text));
      this.copy.textContent = "Copied";
      setTimeout(() => (this.copy.textContent = "Copy"), 1500);
    };
    this.run.onclick = () => this.#runs();
    this.edit.onkeydown = (e) => e.key === "Enter" && (e.ctrlKey || e.metaKey) && this.#runs();
  }

  shownText() {
    return this.edit.hidden ? this.text.textContent : this.edit.value;
  }

  #choose(name) {
    this.language = name;
    localStorage.setItem(REMEMBERED, name);
    return this.#fill();
  }

  /** @param row  of what is shown */
  look(row) {
    const example = this.examples.get(kinOf(row));
    if (!example) return undefined;
    const other = example !== this.example;
    Object.assign(this, { row, example });
    if (other) ((this.edit.value = ""), (this.printed.textContent = ""));
    this.title.textContent = example.title;
    this.why.textContent = row.example
      ? example.summary
      : example.example === "save"
        ? "Any scene can be saved, by the button below the picture, and loaded in a program like this."
        : "The scene beside is drawn from the engine's own list; a program of this kind:";
    return this.#fill();
  }

  async #fill() {
    if (this.box.hidden || !this.example) return;
    const [language, name] = LANGUAGES.find(([, n]) => n === this.language) ?? LANGUAGES[2],
      file = this.example.files[language];
    for (const tab of this.tabs.children) {
      const chosen = tab.dataset.language === language;
      tab.setAttribute("aria-selected", String(chosen));
      tab.tabIndex = chosen ? 0 : -1;
    }
    this.file.textContent = file.split("/").slice(-1);
    if (!this.texts.has(file)) {
      const response = await fetch(`examples/${file}`);
      this.texts.set(file, response.ok ? await response.text() : `examples/${file} is missing: build the page again`);
    }
    const text = this.texts.get(file),
      runs = name === "JavaScript";
    this.text.textContent = text;
    this.text.hidden = runs;
    this.edit.hidden = this.run.hidden = !runs;
    if (runs && !this.edit.value) this.edit.value = text;
    if (!this.printed.textContent) this.printed.textContent = this.example.says;
    return undefined;
  }

  async #runs() {
    this.run.disabled = true;
    this.printed.textContent = "runs …";
    try {
      const result = await run(this.edit.value, await this.compiled());
      this.printed.textContent = [...result.printed, ...(result.error ? [`stopped: ${result.error}`] : [])].join("\n");
      if (result.recording) await this.show(this.example, result);
    } catch (error) {
      this.printed.textContent = error.message;
    } finally {
      this.run.disabled = false;
    }
  }
}
