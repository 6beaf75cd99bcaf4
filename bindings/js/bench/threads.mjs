// Time of a step without threads and with some, in turn, and whether they have the same bits:
//   node bench/threads.mjs ../../out/scenes falling pyramid [--threads 1,2] [--steps N] [--repeats N]
import { readFile } from "node:fs/promises";
import { join } from "node:path";
import { load } from "../src/index.js";

const argument = (name, value) => {
  const at = process.argv.indexOf(name);
  return at < 0 ? value : process.argv.splice(at, 2)[1];
};
const numbers = argument("--threads", "1,2").split(",").map(Number),
  repeats = Number(argument("--repeats", 5)),
  most = Number(argument("--steps", 1e9)),
  [folder, ...names] = process.argv.slice(2);
const index = JSON.parse(await readFile(join(folder, "index.json")));

/** ms of each step, and the hash at the end. */
function run({ carom, alone }, row, bytes) {
  const engine = carom.engine(alone ? { threads: 1 } : {}),
    world = engine.world(),
    times = [];
  world.restore(bytes);
  for (let i = Math.min(most, Math.ceil(row.seconds / row.dt - 1e-6)); i > 0; --i) {
    const before = performance.now();
    world.step(row.dt);
    times.push(performance.now() - before);
  }
  const hash = world.hash();
  (world.free(), engine.free());
  return { times, hash };
}

const builds = [{ name: "carom.wasm", carom: await load() }];
for (const threads of numbers) {
  const carom = await load({ threads: Math.max(2, threads) });
  if (threads === 1) carom.stopThreads();
  builds.push({ name: `${threads} thread${threads > 1 ? "s" : ""}`, carom, alone: threads === 1 });
}
console.log(`| scene | ${builds.map((b) => b.name).join(" | ")} |\n|---|${"---|".repeat(builds.length)}`);
for (const row of index.filter((r) => !names.length || names.includes(r.name))) {
  const bytes = await readFile(join(folder, row.world)),
    least = builds.map(() => []),
    hashes = new Set();
  for (let repeat = 0; repeat < repeats; ++repeat)
    builds.forEach((build, k) => {
      const { times, hash } = run(build, row, bytes);
      hashes.add(hash);
      times.forEach((time, i) => (least[k][i] = Math.min(least[k][i] ?? Infinity, time)));
    });
  if (hashes.size > 1) throw new Error(`${row.name}: bits differ`);
  const mean = least.map((list) => list.reduce((sum, x) => sum + x, 0) / list.length);
  console.log(`| ${row.name} | ${mean.map((x) => `${x.toFixed(3)} ms, ${(x / mean[0]).toFixed(2)}`).join(" | ")} |`);
}
