// The scenes that there are, and one of other numbers, as `carom view` makes it.
import { Truth } from "./truth.js";

export { THINGS } from "./things_list.js";

/** Scenes in their order; those that one steers, examples, and those whose truth is known, as groups of their own. */
export function listScenes(select, rows) {
  const group = (label) => Object.assign(document.createElement("optgroup"), { label }),
    plain = group("To watch and to push"),
    steered = group("To steer"),
    known = group("The truth is known"),
    programs = group("Examples, with their code");
  for (const { name, truth, thing, example } of rows)
    (thing ? steered : truth ? known : example ? programs : plain).append(
      new Option(name.replace(/^example_/, ""), name),
    );
  select.append(...[plain, steered, programs, known].filter((g) => g.children.length));
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
