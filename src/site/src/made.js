// The scenes that there are, and one of other numbers, as `carom view` makes it.
import { Truth } from "./truth.js";

/** Scenes that the page makes itself: things.js. */
export const THINGS = [
  {
    name: "drive",
    thing: "yard",
    summary: "A car with an engine, gears, springs and tyres, in a yard.",
    look_for: "crates, dominoes, a ramp",
  },
  {
    name: "walk",
    thing: "course",
    summary: "A character on steps, slopes of 20, 40 and 60 degrees, a moving platform.",
    look_for: "what it can climb and push",
  },
  {
    name: "arm",
    thing: "arm",
    summary: "A robot's arm of three hinges reaches for a mark.",
    look_for: "how far the hand stays off",
  },
];

/** Scenes in their order; those that one steers, and those whose truth is known, as groups of their own. */
export function listScenes(select, rows) {
  const group = (label) => Object.assign(document.createElement("optgroup"), { label }),
    plain = group("To watch and to push"),
    steered = group("To steer"),
    known = group("The truth is known");
  for (const { name, truth, thing } of rows) (thing ? steered : truth ? known : plain).append(new Option(name, name));
  select.append(...[plain, steered, known].filter((g) => g.children.length));
}

/** @param values  by knob   @returns { row, start }   @throws Error that says why it was not made */
export async function made(name, values) {
  const query = new URLSearchParams({ scene: name });
  for (const [knob, value] of Object.entries(values)) query.append("set", `${knob}=${value}`);
  const response = await fetch(`scenes/make?${query}`);
  if (response.status === 404) throw new Error("scenes are made by the command: open this page by carom view");
  if (!response.ok) throw new Error(await response.text());
  const bytes = new Uint8Array(await response.arrayBuffer()),
    n = new DataView(bytes.buffer).getUint32(0, true);
  const row = JSON.parse(new TextDecoder().decode(bytes.subarray(4, 4 + n)));
  const end = bytes.length - (row.truth?.bytes ?? 0);
  if (row.truth) row.truth = new Truth(row.truth, bytes.slice(end).buffer);
  return { row: { ...row, made: values }, start: bytes.slice(4 + n, end) };
}
