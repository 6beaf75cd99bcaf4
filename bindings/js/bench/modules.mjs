// Step times of several builds of the module beside each other, in turn, and whether they have the same bits:
//   node bench/modules.mjs ../../out/scenes old.wasm new.wasm [--steps N] [--repeats N]
import { readFile } from "node:fs/promises";
import { join } from "node:path";
import { load } from "../src/index.js";

const argument = (name, value) => {
  const at = process.argv.indexOf(name);
  return at < 0 ? value : Number(process.argv.splice(at, 2)[1]);
};
const steps = argument("--steps", 120),
  repeats = argument("--repeats", 5),
  [folder, ...files] = process.argv.slice(2);
const index = JSON.parse(await readFile(join(folder, "index.json")));
const modules = await Promise.all(files.map(async (file) => load(await readFile(file))));

/** ms of each step, and the hash at the end. */
function run(carom, row, bytes) {
  const engine = carom.engine(),
    world = engine.world(),
    times = [];
  world.restore(bytes);
  for (let i = 0; i < steps; ++i) {
    const before = performance.now();
    world.step(row.dt);
    times.push(performance.now() - before);
  }
  const hash = world.hash();
  (world.free(), engine.free());
  return { times, hash };
}

const ratios = files.map(() => []);
console.log(`| scene | ${files.join(" | ")} |\n|---|${"---|".repeat(files.length)}`);
for (const row of index) {
  const bytes = await readFile(join(folder, row.world)),
    least = files.map(() => new Array(steps).fill(Infinity)),
    hashes = new Set();
  for (let repeat = 0; repeat < repeats; ++repeat)
    modules.forEach((carom, k) => {
      const { times, hash } = run(carom, row, bytes);
      hashes.add(hash);
      times.forEach((time, i) => (least[k][i] = Math.min(least[k][i], time)));
    });
  if (hashes.size > 1) throw new Error(`${row.name}: the modules' bits differ`);
  const mean = least.map((list) => list.reduce((sum, x) => sum + x, 0) / steps);
  mean.forEach((x, k) => ratios[k].push(x / mean[0]));
  console.log(`| ${row.name} | ${mean.map((x) => `${x.toFixed(3)} ms, ${(x / mean[0]).toFixed(2)}`).join(" | ")} |`);
}
const middle = (list) => list.sort((a, b) => a - b)[list.length >> 1];
console.log(
  `| median; most | ${ratios.map((list) => `${middle(list).toFixed(2)}; ${Math.max(...list).toFixed(2)}`).join(" | ")} |`,
);
