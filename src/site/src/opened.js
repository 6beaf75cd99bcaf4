// Files that a visitor opens or drops, told apart by their content. Nothing here changes what the page shows.
import { Recording } from "carom";

const LARGEST = 64; // MiB

const begins = (bytes, text) => new TextDecoder("latin1").decode(bytes.subarray(0, text.length)) === text;

/** What a file is:
 *  - { start, row }: a scene, as a whole snapshot; row.recording are the bytes of a session that goes with it
 *  - { shape: plugin }: a shape, to be used by engines
 *  - { action }: something that comes into the scene as it stands
 *  each with `note`, what a visitor should know.
 *  @param plugins  shapes that a recording needs beside ours
 *  @param names  text of the file of names beside a saved robot (`python3 -m carom.robots`), or null   @throws Error that says what is wrong with the file */
export async function opened(carom, name, bytes, plugins = [], names = null) {
  if (bytes.length > LARGEST << 20)
    throw new Error(`${name} is larger than ${LARGEST} MiB: the page opens smaller files`);
  if (begins(bytes, "CAROMSNP"))
    return names === null ? { start: bytes, row: { dt: 1 / 60 } } : robot(carom, bytes, names);
  if (begins(bytes, "CAROMREC")) return session(carom, name, bytes, plugins);
  if (begins(bytes, "\0asm")) return { shape: await carom.bringShape(bytes) };
  if (begins(bytes, "glTF") || /\.gltf$/i.test(name)) return (await import("./gltf.js")).sceneOf(carom, name, bytes);
  if (/\.obj$/i.test(name)) return (await import("./obj.js")).bodyOf(carom, name, bytes);
  throw new Error(
    `${name} is nothing that opens here: a saved world, a recording, a .gltf, .glb or .obj file, or a shape as .wasm`,
  );
}

/** A robot's world, whose bodies get numbers, and the names that stand beside it. */
function robot(carom, bytes, text) {
  let told;
  try {
    told = JSON.parse(text);
  } catch {
    told = null;
  }
  const { dt, bodies } = told ?? {},
    places = Object.entries(bodies ?? {});
  if (!(dt > 0 && dt < 1) || !places.length || !places.every(([, place]) => Number.isInteger(place)))
    throw new Error("the file of names is none: python3 -m carom.robots writes it beside a robot's world");
  const engine = carom.engine(),
    world = engine.world();
  try {
    world.restore(bytes);
    const all = world.bodies();
    all.forEach((body, i) => (body.user = BigInt(i)));
    const names = all.map((_, i) => places.find(([, place]) => place === i)?.[0] ?? `body ${i}`);
    return { start: world.save({ whole: true }), row: { dt, bodies: names.map((name) => [name, name]) } };
  } finally {
    (world.free(), engine.free());
  }
}

function session(carom, name, bytes, plugins) {
  const engine = carom.engine();
  try {
    for (const plugin of plugins) engine.useShape(plugin);
    const recording = new Recording(engine, bytes);
    recording.world().free(); // can it begin?
    const { steps, hashes } = recording;
    if (!steps.length) throw new Error(`${name} has no step: nothing was recorded but the world as it was`);
    return {
      start: recording.start,
      row: {
        dt: steps[0].dt,
        recording: bytes,
        hashes: Object.fromEntries(hashes.map((hash, i) => [i + 1, hash])),
      },
      note: `${name}: ${steps.length} steps${recording.ended ? "" : "; it was cut off, or its program never came back"}`,
    };
  } finally {
    engine.free();
  }
}
