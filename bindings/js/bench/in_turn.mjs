// What benches share that step builds of the module in turn: least times of each step, and the same bits of all.

/** The value of an argument of the command line, taken out of it; or another. */
export function argument(name, value) {
  const at = process.argv.indexOf(name);
  return at < 0 ? value : process.argv.splice(at, 2)[1];
}

/** ms of each step, and the hash at the end.   @param options  of the engine */
function run(carom, row, bytes, steps, options) {
  const engine = carom.engine(options),
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

/** Mean ms of a step of each build, a step counting with its least time of all repeats.
 *  @param builds  [{ carom, options }]   @param row  of a pack's index   @throws Error where bits differ */
export function meansInTurn(builds, row, bytes, steps, repeats) {
  const least = builds.map(() => new Array(steps).fill(Infinity)),
    hashes = new Set();
  for (let repeat = 0; repeat < repeats; ++repeat)
    builds.forEach(({ carom, options }, k) => {
      const { times, hash } = run(carom, row, bytes, steps, options);
      hashes.add(hash);
      times.forEach((time, i) => (least[k][i] = Math.min(least[k][i], time)));
    });
  if (hashes.size > 1) throw new Error(`${row.name}: bits differ`);
  return least.map((list) => list.reduce((sum, x) => sum + x, 0) / steps);
}

/** A row of a table: each mean, and over the first. */
export const rowOf = (name, means) =>
  `| ${name} | ${means.map((x) => `${x.toFixed(3)} ms, ${(x / means[0]).toFixed(2)}`).join(" | ")} |`;
