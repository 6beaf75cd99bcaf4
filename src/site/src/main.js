// The page: scenes, time, tools, settings and a comparison, put together. What each part does stands in its own file.
import { Recording } from "carom";
import { AccuracyPanel, number, TRIALS } from "./accuracy.js";
import { besideOf, CodePanel, exampleRows, run } from "./code.js";
import { Dials } from "./dials.js";
import { plotAll, plotCauses } from "./curves.js";
import { engine } from "./engine.js";
import { readLink, writeLink } from "./link.js";
import { listScenes, made, THINGS } from "./made.js";
import { opened } from "./opened.js";
import { Keys } from "./keys.js";
import { Picture, SHOWN } from "./picture.js";
import { PlanPanel } from "./plan.js";
import { Pointer } from "./pointer.js";
import { Rays } from "./rays.js";
import { apart, Simulation } from "./simulation.js";
import { Stage } from "./stage.js";
import { offTruth, Truth } from "./truth.js";

const $ = (id) => document.getElementById(id);
const BUDGET = 12; // ms of a frame for steps
const TELL = 200; // ms from one time that numbers and curves are brought up to date to the next, while it plays
const REST = 1.5; // s that a scene which nobody touched is seen at its end, before it begins anew

const state = {
  row: {},
  start: null,
  dt: 1 / 60,
  sims: [],
  pictures: [],
  engine: null,
  playing: true,
  owed: 0,
  following: null,
  difference: [],
  shapes: [], // that visitors brought: { id, plugin }
  last: 0,
  told: 0, // when numbers were
  pace: 0, // ms from one picture to the next, of late
  stepping: 0, // ms of the last frame
  inSight: true,
  touched: false, // by a visitor: until then a scene begins anew when it has ended
};
const shown = { ...SHOWN };
let carom, rows, stage, panel, pointer, plan, accuracy, keys, code, rays;

/** @param isNote  it says what is, not what went wrong */
function say(text, isNote = false) {
  $("message").textContent = text;
  $("message").classList.toggle("note", isNote);
  $("message").hidden = false;
  clearTimeout(say.timer);
  say.timer = setTimeout(() => ($("message").hidden = true), 12000);
}

/** Do it, or say why not. */
function attempt(work) {
  try {
    return work();
  } catch (error) {
    say(error.message);
    return undefined;
  }
}

/** Make the scene anew.   @param sides  [{settings, log}]: of A, and of B where there is one */
function begin(row, start, sides) {
  const engine = carom.engine(),
    made = [];
  try {
    for (const plugin of [...(row.plugins ?? []), ...state.shapes.map((shape) => shape.plugin)])
      engine.useShape(plugin);
    const recording = row.recording ? new Recording(engine, row.recording) : null;
    for (const { settings, log } of sides) {
      const sim = new Simulation(engine, start, row.dt ?? 1 / 60, [...settings], recording, row.driver);
      made.push(sim);
      sim.load(log);
    }
  } catch (error) {
    for (const sim of made) sim.free();
    engine.free();
    throw error;
  }
  clear();
  const other = row !== state.row;
  Object.assign(state, { row, start, engine, sims: made, following: null, difference: [], owed: 0 });
  show(other);
}

function clear() {
  for (const picture of state.pictures) picture.dispose();
  for (const sim of state.sims) sim.free();
  state.engine?.free();
  state.pictures = [];
}

function show(other) {
  state.pictures = state.sims.map((sim) => {
    const picture = new Picture(sim, state.row, stage.cheap);
    picture.shown = shown;
    stage.scene.add(picture.group);
    return picture;
  });
  const two = state.sims.length === 2;
  $("compare").checked = two;
  if (panel.row !== state.row) ((panel.row = state.row), panel.show(state.row.knobs));
  panel.refresh(two);
  $("difference").hidden = !two;
  $("error").hidden = !state.row.truth;
  keys.show();
  code.look(state.row);
  for (const picture of state.pictures) picture.update();
  if (other) stage.look(state.row, state.pictures);
  else stage.follow(state.pictures, Infinity);
  redraw();
}

function advance() {
  for (const sim of state.sims) {
    const pull = pointer.pull(sim);
    if (pull) sim.do(pull);
    const input = keys.input(sim);
    if (input) sim.do(input);
    sim.advance();
  }
  if (state.sims.length === 2) state.difference[state.sims[0].step] = apart(...state.sims);
}

function seek(step) {
  attempt(() => {
    for (const sim of state.sims) sim.seek(step);
  });
  redraw();
}

function act(action) {
  attempt(() => {
    for (const sim of state.sims) sim.do(action);
  });
  redraw();
}

/** @param seconds  that the camera has had to follow; Infinity: it is there at once */
function redraw(seconds = Infinity) {
  for (const picture of state.pictures) picture.update();
  const met = rays.update(state.pictures[pointer.view?.view] ?? state.pictures[0]);
  if (pointer.tool === "rays") $("told").textContent = met || "Point at something";
  const followed = state.sims[0].bodies[state.following];
  if (followed) stage.keep(followed.position);
  else if (seconds < Infinity) stage.follow(state.pictures, seconds);
  stage.render(state.pictures);
  if (seconds === Infinity) tell();
}

/** Numbers and curves. */
function tell() {
  const [sim] = state.sims,
    hash = sim.hash();
  $("hash").textContent = state.sims.map((s) => s.hash()).join("  ");
  const plain = !sim.settings.length && !(sim.lastAction >= 0 && Math.min(...sim.actions.keys()) <= sim.step);
  const other = state.row.example ? "the program" : state.row.recording ? "the recording" : "the native build";
  const native = plain ? state.row.hashes?.[sim.step] : undefined;
  $("native").textContent =
    native === undefined ? "" : native === hash ? `${other} has the same bits` : `${other} has ${native}`;
  $("native").dataset.same = native === undefined ? "" : String(native === hash);
  $("at").textContent = sim.step;
  $("scrub").max = Math.max(sim.newest, sim.step);
  $("scrub").value = sim.step;
  $("fit").hidden = stage.auto;
  state.pictures.forEach(({ sim: s }, i) => (s.errors[s.step] = state.pictures[i].error()));
  $("off").textContent = state.row.truth ? state.sims.map((s) => offTruth(s.errors[s.step])).join("  ") : "";
  if (pointer.tool !== "rays") $("told").textContent = (state.touched ? sim.driver?.told() : sim.driver?.keys) ?? "";
  const { report } = sim;
  $("bodies").textContent = sim.bodies.length + (state.row.particles ?? 0);
  $("contacts").textContent = report ? Number(report.contact_points) : "–";
  $("milliseconds").textContent = report ? number(1e3 * report.total_seconds) : "–";
  $("frames").textContent = state.playing && state.pace ? Math.round(1000 / state.pace) : "–";
  if ($("curves-box").open) plotAll(state, $);
  sim.account($("causes-box").open);
  if ($("causes-box").open) plotCauses($("causes"), $("causes-table"), sim);
  if ($("plan-box").open) plan.update(sim.world.plan());
  accuracy.update();
  const two = state.sims.length === 2;
  for (const k of [0, 1]) $(`label-${"ab"[k]}`).textContent = two ? `${"AB"[k]}: ${accuracy.briefly(k)}` : "";
}

function play(on) {
  state.playing = on;
  $("play").textContent = on ? "Pause" : "Play";
  $("play").setAttribute("aria-pressed", String(on));
}

function frame(now) {
  requestAnimationFrame(frame);
  const ms = now - state.last,
    passed = Math.min(0.1, ms / 1000);
  state.last = now;
  if (!state.sims.length || !state.inSight) return;
  const moved = stage.controls.update();
  if (!state.playing) {
    if (moved) stage.render(state.pictures);
    return;
  }
  if (ms < 1000) state.pace += 0.1 * (ms - state.pace);
  if (ms < 1000) stage.adapt(ms - state.stepping);
  const { dt, step } = state.sims[0],
    begun = performance.now();
  if (!state.touched && state.row.seconds && step * dt > state.row.seconds + REST) seek(0);
  state.owed = Math.min(state.owed + passed * Number($("speed").value), 8 * dt);
  const went = attempt(() => {
    while (state.owed >= dt && performance.now() < begun + BUDGET) {
      advance();
      state.owed -= dt;
    }
    return true;
  });
  if (!went) play(false);
  state.stepping = performance.now() - begun;
  redraw(passed);
  if (now - state.told > TELL) ((state.told = now), tell());
}

async function truthOf(told) {
  const response = await fetch(`scenes/${told.file}`);
  if (!response.ok) throw new Error(`scenes/${told.file} is missing: build the page again`);
  return new Truth(told, await response.arrayBuffer());
}

/** For the eye; where `carom view` packed the scene, they stand in its row. */
async function meshesOf(told) {
  if (typeof told !== "string") return told;
  const response = await fetch(`scenes/${told}`);
  if (!response.ok) throw new Error(`scenes/${told} is missing: build the page again`);
  return response.json();
}

async function open(name, sides = [{ settings: [], log: [] }]) {
  const row = rows.find((r) => r.name === name);
  if (!row) throw new Error(`there is no scene "${name}"; choose one of ${rows.map((r) => r.name).join(", ")}`);
  if (row.thing) {
    const { start, row: more } = (await import("./things.js")).madeHere(carom, row.thing);
    return shownAs(name, { ...row, ...more }, start, sides);
  }
  if (row.example) {
    const text = await (await fetch(`examples/${row.files.js}`)).text(),
      result = await run(text, await compiled());
    if (result.error) throw new Error(`the example stopped: ${result.error}`);
    return shownProgram(row, result, sides);
  }
  const response = await fetch(`scenes/${row.world}`);
  if (!response.ok) throw new Error(`scenes/${row.world} is missing: build the page again`);
  const bytes = new Uint8Array(await response.arrayBuffer());
  const file = row.world.endsWith(".rec") ? await opened(carom, row.world, bytes) : { start: bytes };
  const truth = row.truth ? { truth: await truthOf(row.truth) } : {},
    meshes = row.meshes ? { meshes: await meshesOf(row.meshes) } : {};
  return shownAs(name, { ...row, ...file.row, ...truth, ...meshes }, file.start, sides);
}

/** The engine's code, for workers that run programs. */
function compiled() {
  compiled.once ??= WebAssembly.compileStreaming(fetch("carom.wasm"));
  return compiled.once;
}

/** The world of a program that ran: its calls are made again, step by step. */
async function shownProgram(row, { printed, recording, shapes, beside, floor }, sides = [{ settings: [], log: [] }]) {
  const plugins = shapes.map(({ text, id, params }) => {
    try {
      const support = new Function(`return (${text})`)(); // of the visitor's own program
      support(
        params.map(([, , least, most]) => Math.min(most, Math.max(least, 1))),
        [0, 1, 0],
      );
      return carom.bringSupport(support, id, params);
    } catch (error) {
      throw new Error(
        `the shape ${id} is not shown here: its function needs more than what it is given (${error.message})`,
      );
    }
  });
  const { start, row: more } = await opened(carom, `${row.example}.rec`, recording, plugins),
    seconds = more.dt * Object.keys(more.hashes).length;
  const about = { ...row, ...more, printed, plugins, seconds, beside: besideOf(beside), ground: floor ? 10 : 0 };
  return shownAs(row.name, about, start, sides);
}

function shownAs(name, row, start, sides) {
  begin(row, start, sides);
  $("scene").value = name;
  $("trials").value = TRIALS.some(([trial]) => trial === name) ? name : "";
  $("whole").href = `?scene=${name}`;
  $("about").textContent = row.example
    ? `${row.summary} It prints: ${row.says}.`
    : `${row.summary} Look for: ${row.look_for}.`;
}

async function make(name, values) {
  const { row, start } = await made(name, values);
  begin(row, start, [{ settings: [], log: [] }]);
}

function compare(on) {
  attempt(() => {
    const [a] = state.sims,
      at = a.step,
      side = { settings: a.settings, log: a.log() };
    begin(state.row, state.start, on ? [side, { settings: [...a.settings], log: a.log() }] : [side]);
    for (let i = 0; i < at; ++i) advance();
  });
  redraw();
}

/** A, a rough step, beside B, what was set: from the start.   @param rough  actions that make a world rough */
function duel(rough) {
  const b = state.sims.at(-1).settings;
  attempt(() =>
    begin(state.row, state.start, [
      { settings: rough, log: [] },
      { settings: b, log: [] },
    ]),
  );
  $("accuracy-side").value = "1";
  play(true);
  tell();
}

function link() {
  const query = writeLink(
    {
      scene: state.row.name,
      step: state.sims[0].step,
      plays: state.playing,
      sides: state.sims.map((sim) => ({ settings: sim.settings, log: sim.log() })),
    },
    carom.presets(),
  );
  if (state.row.made) return say("a scene of other numbers has no link: save the world, and send the file");
  if (!state.row.name) return say("an opened file has no link: save the world, and send the file");
  if (!query) return say("too much was done by hand for a link: save the world, and send the file");
  history.replaceState(null, "", query);
  navigator.clipboard?.writeText(location.href).catch(() => {});
  return undefined;
}

/** Offer a file of this scene at this step. */
function download(blob, ending) {
  const a = document.createElement("a");
  a.href = URL.createObjectURL(blob);
  a.download = `${state.row.name ?? "world"}-${state.sims[0].step}.${ending}`;
  a.click();
  setTimeout(() => URL.revokeObjectURL(a.href), 1000);
}

/** A film of the picture, from this click to the next. */
function film() {
  if (film.recorder) return film.recorder.stop();
  const kind = ["video/mp4", "video/webm"].find((type) => globalThis.MediaRecorder?.isTypeSupported(type));
  if (!kind) return say("this browser makes no films: take a picture, or copy the link");
  const parts = [],
    button = $("film"),
    show = (on) => (
      (button.textContent = on ? "End the film" : "Film"),
      button.setAttribute("aria-pressed", String(on))
    );
  const recorder = new MediaRecorder($("view").captureStream(30), { mimeType: kind, videoBitsPerSecond: 6e6 });
  recorder.ondataavailable = ({ data }) => parts.push(data);
  recorder.onstop = () => (
    (film.recorder = null),
    show(false),
    download(new Blob(parts, { type: kind }), kind.slice(6))
  );
  recorder.start();
  film.recorder = recorder;
  show(true);
  return play(true);
}

/** The code in place of numbers and settings, or these again. */
function showCode(on) {
  $("code-box").hidden = !on;
  document.body.classList.toggle("coding", on);
  $("code").setAttribute("aria-expanded", String(on));
  code.look(state.row);
}

/** Take up a tool. */
function choose(button) {
  pointer.tool = button.dataset.tool;
  pointer.shape = button.shape;
  state.following = null;
  rays.aim(null);
  for (const other of document.querySelectorAll("[data-tool]"))
    other.setAttribute("aria-checked", String(other === button));
  redraw();
}

/** A shape that was dropped is there from now on, in this scene and in later ones, with a tool that drops bodies of it. */
function bring(plugin, name) {
  const id = state.engine.useShape(plugin);
  state.shapes.push({ id, plugin });
  const params = state.engine
    .parameters(id)
    .map(({ unit, min, max }) => Math.min(max, Math.max(min, unit === "m" ? 0.4 : 1)));
  const button = document.createElement("button");
  Object.assign(button, { type: "button", textContent: `Drop ${id}`, shape: { shape: id, params } });
  (button.setAttribute("role", "radio"), (button.dataset.tool = "shape"));
  button.onclick = () => choose(button);
  $("tools").append(button);
  choose(button);
  say(`${name}: click where a body of the shape ${id} should fall`, true);
}

/** A file that was opened or dropped; beside it may be that of a robot's names. What is wrong is told, and the scene stays
 *  as it was. */
async function openFiles(files) {
  const names = [...files].find(({ name }) => name.endsWith(".json")),
    file = [...files].find((other) => other !== names) ?? names;
  if (!file) return;
  try {
    const { start, row, shape, action, note } = await opened(
      carom,
      file.name,
      new Uint8Array(await file.arrayBuffer()),
      [],
      names ? await names.text() : null,
    );
    if (shape) return bring(shape, file.name);
    if (action) {
      const to = stage.controls.target.toArray();
      for (const sim of state.sims) sim.do({ ...action, position: action.position.map((x, i) => x + to[i]) });
      redraw();
    } else {
      begin(row, start, [{ settings: [], log: [] }]);
      $("about").textContent = note ?? file.name;
      $("scene").selectedIndex = -1;
    }
    if (note) say(note, true);
  } catch (error) {
    say(error.message);
  }
}

function controls() {
  $("play").onclick = () => play(!state.playing);
  $("step").onclick = () => (play(false), attempt(advance), redraw());
  $("back").onclick = () => (play(false), seek(Math.max(0, state.sims[0].step - 1)));
  $("reset").onclick = () =>
    attempt(() =>
      begin(
        state.row,
        state.start,
        state.sims.map((s) => ({ settings: s.settings, log: [] })),
      ),
    );
  $("scrub").oninput = () => (play(false), seek(Number($("scrub").value)));
  $("compare").onchange = () => compare($("compare").checked);
  $("trials").onchange = () =>
    $("trials").value &&
    open($("trials").value).then(
      () => play(true),
      (e) => say(e.message),
    );
  $("scene").onchange = () => open($("scene").value).catch((e) => say(e.message));
  $("link").onclick = link;
  $("save").onclick = () => download(new Blob([state.sims[0].world.save({ whole: true })]), "world");
  $("open").onchange = () => openFiles($("open").files).then(() => ($("open").value = ""));
  $("stage").ondragover = (e) => e.preventDefault();
  $("stage").ondrop = (e) => (e.preventDefault(), openFiles(e.dataTransfer.files));
  $("theme").onclick = () => {
    const { dataset } = document.documentElement;
    dataset.theme = dataset.theme === "dark" ? "light" : "dark";
    stage.paint();
    redraw();
  };
  $("code").onclick = () => showCode($("code-box").hidden);
  $("shot").onclick = () => (
    stage.render(state.pictures),
    $("view").toBlob((blob) => download(blob, "png"), "image/png")
  );
  $("film").onclick = film;
  for (const button of document.querySelectorAll("[data-tool]")) button.onclick = () => choose(button);
  addEventListener("keydown", (e) => {
    if (e.target.closest("input, select, button, summary")) return;
    if (keys.takes(e)) return;
    const key = { " ": "play", ArrowRight: "step", ArrowLeft: "back", r: "reset" }[e.key];
    if (key) (e.preventDefault(), $(key).click());
  });
  for (const box of document.querySelectorAll("details[id]")) box.ontoggle = () => state.sims.length && redraw();
  $("fit").onclick = () => (
    (state.following = null),
    (stage.auto = true),
    stage.follow(state.pictures, Infinity),
    redraw()
  );
  new ResizeObserver(() => {
    if (!state.sims.length) return;
    stage.render(state.pictures); // the picture has its new shape
    stage.follow(state.pictures, Infinity);
    redraw();
  }).observe($("stage"));
  // Out of sight nothing is computed, in frames of the documentation as well.
  new IntersectionObserver(([entry]) => (state.inSight = entry.isIntersecting)).observe($("stage"));
  for (const kind of ["pointerdown", "keydown", "input", "change"])
    addEventListener(kind, () => (state.touched = true), { capture: true });
}

async function start() {
  if (matchMedia("(prefers-color-scheme: dark)").matches) document.documentElement.dataset.theme = "dark";
  const index = fetch("scenes/index.json");
  carom = await engine(say);
  const programs = await exampleRows();
  rows = [...(await (await index).json()), ...THINGS, ...programs];
  listScenes($("scene"), rows);
  stage = new Stage($("view"), () => $("tools").offsetHeight + $("tools").offsetTop);
  stage.paint();
  plan = new PlanPanel($("stages"), $("plan"), (effect, mode) => act({ do: "effect", effect, mode }));
  accuracy = new AccuracyPanel($("accuracy-box"), {
    dials: () => carom.dials(),
    sims: () => state.sims,
    error: (which) => state.sims[which].errors[state.sims[which].step],
    act: (which, action) => (attempt(() => state.sims[which].do(action)), panel.refresh()),
    follow: (body) => ((state.following = body), (stage.auto = false), redraw()),
    restart: () => state.row.truth && (seek(0), play(true)),
    duel,
  });
  $("trials").append(new Option("a scene whose truth is known", ""));
  for (const [name, title] of TRIALS)
    if (rows.some((row) => row.name === name)) $("trials").append(new Option(title, name));
  panel = new Dials($("panel"), {
    carom,
    shown,
    onShown: () => redraw(),
    onMake: (values) => make(state.row.name, values).catch((e) => say(e.message)),
    apply: (which, action) => attempt(() => state.sims[which]?.do(action)),
    dial: (which, name) => (state.sims[which] ?? state.sims[0])?.world.dial(name) ?? 0,
  });
  rays = new Rays();
  pointer = new Pointer({
    canvas: $("view"),
    camera: stage.camera,
    get controls() {
      return stage.controls;
    },
    act,
    say,
    place: (u, v) => ((pointer.view = stage.place(u, v)), pointer.view),
    picture: () => state.pictures[pointer.view.view],
    follow: (body) => ((state.following = body), (stage.auto = false)),
    aim: (ray, far) => (rays.aim(ray, far), state.playing || redraw()),
  });
  keys = new Keys(
    $("pad"),
    () => state.sims[0]?.driver,
    () => stage.direction,
  );
  code = new CodePanel($("code-box"), {
    rows: programs,
    compiled,
    show: async (row, result) => (await shownProgram(row, result), play(true)),
  });
  controls();
  let wanted = { scene: null, step: 0, plays: true, sides: undefined };
  attempt(() => (wanted = readLink(location.search, carom.presets(), carom.dials())));
  const first = (rows.find((row) => row.first) ?? rows.find((row) => row.name === "wall") ?? rows[0]).name;
  await open(wanted.scene ?? first, wanted.sides).catch(async (e) => (say(e.message), await open(first)));
  // A link to a step shows that step. All else plays, but not for people who ask for less motion.
  const calm = matchMedia("(prefers-reduced-motion: reduce)").matches;
  play(!calm && wanted.plays);
  if (wanted.code) showCode(true);
  if (wanted.step)
    attempt(() => {
      while (state.sims[0].step < wanted.step) advance();
    });
  for (const picture of state.pictures) picture.update();
  stage.follow(state.pictures, Infinity);
  redraw();
  // For tests and the curious.
  globalThis.caromViewer = {
    get step() {
      return state.sims[0].step;
    },
    get hash() {
      return state.sims[0].hash();
    },
    state,
    stage,
    threads: carom.threads,
    seek,
    probe: (u, v) => pointer.probe(u, v),
    /** How well it is drawn: 0 is best. */
    get quality() {
      return stage.quality;
    },
    /** Geometries and textures that the graphics card holds. */
    get held() {
      return { ...stage.renderer.info.memory };
    },
  };
  requestAnimationFrame(frame);
}

start().catch((error) => say(`the page could not start: ${error.message}`));
