// Engines in turn on one scene: a step counts with its least time over the repeats, so that what else the machine does tells least.
import { judge, read } from "./scene.mjs";

const MOMENTS = 10; // at which poses are judged, in the first repeat

/** @param engines  of engines.mjs   @param row, bytes  of a packed scene   @param seconds  of the scene
 *  @returns [{ name, mean, p99, worst: ms; deepest, overlap: m; lost, strayed }] */
export function race(carom, engines, row, bytes, { seconds, repeats = 3, say = () => {} }) {
  const engine = carom.engine(),
    world = engine.world();
  world.restore(bytes);
  const scene = read(world),
    steps = Math.round(seconds / row.dt);
  const rows = engines.map(({ name }) => ({
    name,
    least: new Float64Array(steps).fill(Infinity),
    deepest: 0,
    overlap: 0,
    lost: 0,
    strayed: 0,
  }));
  for (let repeat = 0; repeat < repeats; ++repeat)
    engines.forEach((maker, k) => {
      const sim = maker.make(scene, bytes),
        out = rows[k];
      for (let i = 0; i < steps; ++i) {
        const before = performance.now();
        sim.step(row.dt);
        out.least[i] = Math.min(out.least[i], performance.now() - before);
        if (repeat || (i + 1) % Math.ceil(steps / MOMENTS)) continue;
        const verdict = judge(engine, scene, sim.poses());
        out.deepest = Math.max(out.deepest, verdict.deepest);
        Object.assign(out, { overlap: verdict.mean, lost: verdict.lost, strayed: verdict.strayed });
      }
      sim.free();
      say(`${row.name}: ${maker.name}, repeat ${repeat + 1} of ${repeats}`);
    });
  (world.free(), engine.free());
  return rows.map(({ least, ...out }) => {
    const sorted = [...least].sort((a, b) => a - b);
    return {
      ...out,
      mean: least.reduce((a, b) => a + b, 0) / steps,
      p99: sorted[Math.floor(0.99 * (steps - 1))],
      worst: sorted.at(-1),
    };
  });
}

export function table(rows) {
  const best = Math.min(...rows.slice(1).map((r) => r.mean));
  const cells = rows.map((r) => [
    r.name,
    r.mean.toFixed(3),
    r.p99.toFixed(2),
    r.worst.toFixed(2),
    (1e3 * r.deepest).toFixed(1),
    (1e3 * r.overlap).toFixed(2),
    String(r.lost),
    r.strayed.toFixed(3),
  ]);
  const head = ["engine", "mean ms", "p99", "worst", "deepest mm", "mean overlap mm", "lost", "farthest m"];
  return [
    `| ${head.join(" | ")} |`,
    `|${"---|".repeat(head.length)}`,
    ...cells.map((c) => `| ${c.join(" | ")} |`),
    `\nCarom takes ${(rows[0].mean / best).toFixed(2)} times the fastest peer's step.`,
  ].join("\n");
}
