// What accuracy costs: a scene whose truth is known, run with one setting after the other. Nothing here draws.
const ENOUGH = 60; // ms of computing: shorter runs are repeated, and the least time counts
const MOST_RUNS = 5;

function perform(carom, scene, { dials = {}, ask, dt = 1 / 60 }) {
  const engine = carom.engine(),
    world = engine.world();
  try {
    for (const [name, value] of Object.entries(dials)) world.setDial(name, value);
    if (ask) world.setAccuracy({ place: ask, turn: ask });
    const judge = scene.build(engine, world),
      steps = Math.round(scene.seconds / dt),
      every = Math.max(1, Math.round(1 / 30 / dt)); // judged at the same times, however fine the step
    let error = 0,
      ms = 0;
    for (let step = 1; step <= steps; ++step) {
      const before = performance.now();
      world.step(dt);
      ms += performance.now() - before;
      if (step % every === 0) error = Math.max(error, judge(step * dt, step === steps));
    }
    return { error, ms, hash: world.hash() };
  } finally {
    world.free();
    engine.free();
  }
}

/** One setting.   @param setting  dials { name: value }, ask (m/s and rad/s), dt s: those that differ from the usual
 *  @returns { error: largest of the run; ms: of computing, by simulated second; hash: at the end } */
export function measure(carom, scene, setting) {
  let { error, ms, hash } = perform(carom, scene, setting);
  for (let runs = 1, spent = ms; runs < MOST_RUNS && spent < ENOUGH; ++runs) {
    const again = perform(carom, scene, setting);
    if (again.hash !== hash) throw new Error("the same setting gave other bits: please report this");
    spent += again.ms;
    ms = Math.min(ms, again.ms);
  }
  return { error, ms: ms / scene.seconds, hash };
}

/** All settings of a scene.   @param told  async (series, points so far) => void, after each setting
 *  @returns [{ name, points: [{ label, error, ms, hash }] }] */
export async function curve(carom, scene, told = async () => {}) {
  perform(carom, scene, scene.series[0].settings[0]); // the first run pays for compiling
  const all = [];
  for (const { name, settings } of scene.series) {
    const series = { name, points: [] };
    all.push(series);
    for (const setting of settings) {
      series.points.push({ label: setting.label, ...measure(carom, scene, setting) });
      await told(all);
    }
  }
  return all;
}
