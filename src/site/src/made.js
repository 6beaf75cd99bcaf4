// A scene of other numbers, as `carom view` makes it.

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
  return { row: { ...row, made: values }, start: bytes.slice(4 + n) };
}
