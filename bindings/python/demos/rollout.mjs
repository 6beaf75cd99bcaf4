// The rollout of rollout.py on another platform: WebAssembly.   usage: node rollout.mjs SNAPSHOT POLICY.json
import { readFile } from "node:fs/promises";
import { load } from "../../js/src/index.js";

const [snapshot, policy] = process.argv.slice(2);
const { steps, dt, strength, weights } = JSON.parse(await readFile(policy, "utf8"));
const carom = await load(await readFile(new URL("../../js/dist/carom.wasm", import.meta.url)));
const engine = carom.engine(), world = engine.world();
world.restore(new Uint8Array(await readFile(snapshot)));
for (let step = 0; step < steps; ++step) {
  const seen = [...world.readJoints("position"), ...world.readJoints("velocity")];
  world.writeJoints("target_effort", weights.map((row) => {
    let sum = 0;
    for (let k = 0; k < row.length; ++k) sum += row[k] * seen[k];
    return strength * Math.min(1, Math.max(-1, sum));
  }));
  world.step(dt);
}
console.log(world.hash());
