// Step times beside the npm packages of Rapier and Jolt, on scenes of the S-table. Wants: npm install, and the scenes:
//   carom pack out/bench falling:n=1024 bunnies:n=100,boxes=2,spheres=0 pyramid:n=30 --steps 0     in the root
//   node bench/peers.mjs [--seconds S] [--repeats N] [--chromium] [SCENE ...]                      in bindings/js
import { readFile } from "node:fs/promises";
import { cpus } from "node:os";
import { parseArgs } from "node:util";
import { load } from "../src/index.js";
import { carom, jolt, rapier } from "./engines.mjs";
import { race, table } from "./race.mjs";

const SECONDS = { falling_n_1024: 15, bunnies_n_100_boxes_2_spheres_0: 10, pyramid_n_30: 10 }; // as tests/bench
const { values, positionals } = parseArgs({
  options: { seconds: { type: "string" }, repeats: { type: "string", default: "3" }, chromium: { type: "boolean" } },
  allowPositionals: true,
});
const folder = new URL("../../../out/bench/", import.meta.url);
const index = JSON.parse(
  await readFile(new URL("index.json", folder)).catch(() => {
    console.error(
      "out/bench is missing; in the root: carom pack out/bench falling:n=1024 bunnies:n=100,boxes=2,spheres=0 pyramid:n=30 --steps 0",
    );
    process.exit(2);
  }),
);
const rows = index.filter((row) => !positionals.length || positionals.includes(row.name));
const options = (row) => ({
  seconds: Number(values.seconds ?? SECONDS[row.name] ?? row.seconds),
  repeats: Number(values.repeats),
});

async function here() {
  const [simd, plain, joltOf] = await Promise.all(
    ["@dimforge/rapier3d-simd-compat", "@dimforge/rapier3d-compat", "jolt-physics/wasm-compat"].map(
      (name) => import(name),
    ),
  );
  (await simd.init(), await plain.init());
  const module = await load();
  const version = JSON.parse(
    await readFile(new URL("../node_modules/jolt-physics/package.json", import.meta.url)),
  ).version;
  const engines = [
    carom(module),
    rapier(simd, "Rapier (SIMD)"),
    rapier(plain, "Rapier"),
    jolt(await joltOf.default(), `Jolt (jolt-physics ${version})`),
  ];
  console.log(`node ${process.version}, ${cpus()[0].model}`);
  for (const row of rows) {
    const bytes = await readFile(new URL(row.world, folder));
    console.log(`\n### ${row.name}, ${options(row).seconds} s, ${values.repeats} repeats\n`);
    console.log(
      table(race(module, engines, row, bytes, { ...options(row), say: (text) => process.stderr.write(`${text}\n`) })),
    );
  }
}

/** The same in a page, from the same files. */
async function inChromium() {
  const { chromium } = await import("playwright-core"),
    { serve } = await import("../../../src/site/serve.mjs");
  const server = await serve(0, new URL("../../../", import.meta.url).pathname),
    browser = await chromium.launch({
      executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
      args: ["--no-sandbox"],
    });
  try {
    const page = await browser.newPage();
    page.on("console", (m) => process.stderr.write(`${m.text()}\n`));
    await page.goto(`http://localhost:${server.address().port}/bindings/js/bench/peers.html`);
    await page.waitForFunction(() => globalThis.run);
    console.log(`Chromium ${browser.version()}, ${cpus()[0].model}`);
    for (const row of rows) {
      console.log(`\n### ${row.name}, ${options(row).seconds} s, ${values.repeats} repeats\n`);
      console.log(await page.evaluate(([r, o]) => globalThis.run(r, o), [row, options(row)]));
    }
  } finally {
    await browser.close();
    server.close();
  }
}
await (values.chromium ? inChromium() : here());
