// A topic page's curve: a button measures it on the reader's machine, in the page. The wasm is that of the viewer.
import { load } from "carom";
import { diagram, legend } from "./diagram.js";
import { curve } from "./measure.js";
import { SCENES } from "./scenes.js";

let carom; // one for all curves of a page

function table(series, unit) {
  const made = document.createElement("table"),
    head = made.createTHead().insertRow();
  for (const text of ["", "setting", `error, ${unit}`, "ms a second", "hash at the end"])
    head.append(Object.assign(document.createElement("th"), { textContent: text, scope: "col" }));
  const body = made.createTBody();
  for (const { name, points } of series)
    for (const { label, error, ms, hash } of points) {
      const row = body.insertRow();
      for (const text of [name, label, error.toExponential(1), ms.toPrecision(2), hash])
        row.insertCell().textContent = text;
    }
  return made;
}

async function show(box, button, told) {
  const scene = SCENES[box.dataset.scene],
    picture = box.querySelector(".picture");
  button.disabled = true;
  box.dataset.state = "running";
  try {
    carom ??= load(new URL(box.dataset.wasm, location));
    const module = await carom;
    const series = await curve(module, scene, async (all) => {
      const points = all.reduce((n, s) => n + s.points.length, 0);
      told.textContent = `${all.at(-1).name}: ${points} of ${scene.series.reduce((n, s) => n + s.settings.length, 0)}`;
      picture.replaceChildren(diagram(all, scene.unit, scene.what), legend(all));
      await new Promise((go) => setTimeout(go, 0)); // the page stays alive
    });
    const details = document.createElement("details"),
      wide = Object.assign(document.createElement("div"), { className: "wide", tabIndex: 0 });
    wide.append(table(series, scene.unit));
    details.append(Object.assign(document.createElement("summary"), { textContent: "The numbers" }), wide);
    picture.append(details);
    told.textContent = "Measured just now, on this machine. Errors are the same on every machine, costs are not.";
    box.dataset.state = "done";
  } catch (error) {
    carom = undefined;
    told.textContent = `It could not be measured: ${error.message}`;
    box.dataset.state = "failed";
  }
  button.disabled = false;
}

for (const box of document.querySelectorAll(".curve")) {
  const button = box.querySelector("button"),
    told = box.querySelector("[role=status]");
  button.onclick = () => show(box, button, told);
}
