// Time of a step without threads and with some, in turn, and whether they have the same bits:
//   node bench/threads.mjs ../../out/scenes falling pyramid [--threads 1,2] [--steps N] [--repeats N]
import { readFile } from "node:fs/promises";
import { join } from "node:path";
import { load } from "../src/index.js";
import { argument, meansInTurn, rowOf } from "./in_turn.mjs";

const numbers = argument("--threads", "1,2").split(",").map(Number),
  repeats = Number(argument("--repeats", 5)),
  most = Number(argument("--steps", 1e9)),
  [folder, ...names] = process.argv.slice(2);
const index = JSON.parse(await readFile(join(folder, "index.json")));

const builds = [{ name: "carom.wasm", carom: await load() }];
for (const threads of numbers) {
  const carom = await load({ threads: Math.max(2, threads) });
  if (threads === 1) carom.stopThreads();
  const options = threads === 1 ? { threads } : {};
  builds.push({ name: `${threads} thread${threads > 1 ? "s" : ""}`, carom, options });
}
console.log(`| scene | ${builds.map((b) => b.name).join(" | ")} |\n|---|${"---|".repeat(builds.length)}`);
for (const row of index.filter((r) => !names.length || names.includes(r.name))) {
  const bytes = await readFile(join(folder, row.world)),
    steps = Math.min(most, Math.ceil(row.seconds / row.dt - 1e-6));
  console.log(rowOf(row.name, meansInTurn(builds, row, bytes, steps, repeats)));
}
