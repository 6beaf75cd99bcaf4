// Time of a step in WebAssembly, for scenes of `carom pack`:
//   node bindings/js/bench/step_time.mjs out/scenes falling pyramid       beside: carom run SCENE --seconds S
import { readFile } from "node:fs/promises";
import { load } from "../src/index.js";

const [folder, ...names] = process.argv.slice(2);
const index = JSON.parse(await readFile(`${folder}/index.json`));
const carom = await load();
for (const row of index.filter((r) => !names.length || names.includes(r.name))) {
  const engine = carom.engine();
  const world = engine.world();
  world.restore(await readFile(`${folder}/${row.world}`));
  const steps = Math.ceil(row.seconds / row.dt - 1e-6);
  let seconds = 0;
  for (let i = 0; i < steps; ++i) {
    world.step(row.dt);
    seconds += world.report().total_seconds;
  }
  console.log(`${row.name}: ${((1e3 * seconds) / steps).toFixed(3)} ms a step, ${steps} steps, hash ${world.hash()}`);
  world.free();
  engine.free();
}
