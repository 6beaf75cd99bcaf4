// Step times of several builds of the module beside each other, in turn, and whether they have the same bits:
//   node bench/modules.mjs ../../out/scenes old.wasm new.wasm [--steps N] [--repeats N]
import { readFile } from "node:fs/promises";
import { join } from "node:path";
import { load } from "../src/index.js";
import { argument, meansInTurn, rowOf } from "./in_turn.mjs";

const steps = Number(argument("--steps", 120)),
  repeats = Number(argument("--repeats", 5)),
  [folder, ...files] = process.argv.slice(2);
const index = JSON.parse(await readFile(join(folder, "index.json")));
const builds = await Promise.all(files.map(async (file) => ({ carom: await load(await readFile(file)) })));

const ratios = files.map(() => []);
console.log(`| scene | ${files.join(" | ")} |\n|---|${"---|".repeat(files.length)}`);
for (const row of index) {
  const mean = meansInTurn(builds, row, await readFile(join(folder, row.world)), steps, repeats);
  mean.forEach((x, k) => ratios[k].push(x / mean[0]));
  console.log(rowOf(row.name, mean));
}
const middle = (list) => list.sort((a, b) => a - b)[list.length >> 1];
console.log(
  `| median; most | ${ratios.map((list) => `${middle(list).toFixed(2)}; ${Math.max(...list).toFixed(2)}`).join(" | ")} |`,
);
