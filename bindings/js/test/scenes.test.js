// Every scene of `carom list` in WebAssembly: the hash of each step is the native build's, which `carom pack out/scenes` wrote.
import { strict as assert } from "node:assert";
import { existsSync } from "node:fs";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { load } from "../src/index.js";

const folder = new URL("../../../out/scenes/", import.meta.url);
const skip = !existsSync(new URL("index.json", folder)) && "not packed: carom pack out/scenes, in the root";

test("scenes have the native build's bits", { skip }, async (t) => {
  const carom = await load();
  const index = JSON.parse(await readFile(new URL("index.json", folder)));
  let compared = 0;
  for (const row of index) {
    const engine = carom.engine();
    const world = engine.world();
    world.restore(await readFile(new URL(row.world, folder)));
    for (let step = 0; row.hashes[step]; ++step) {
      if (step) world.step(row.dt);
      assert.equal(world.hash(), row.hashes[step], `${row.name}, step ${step}`);
      ++compared;
    }
    world.free();
    engine.free();
  }
  t.diagnostic(`${index.length} scenes, ${compared} hashes`);
});
