// Accuracy in, steps out: carom/accuracy.h by the methods of a world.
import { strict as assert } from "node:assert";
import { after, test } from "node:test";
import { CaromError, load } from "../src/index.js";

const carom = await load();
const engine = carom.engine();
after(() => engine.free());

/** Rods of half a metre, one at the end of the other, about axes along z.   @param angles  from straight down, rad */
function rods(angles) {
  const world = engine.world();
  let before = null,
    at = [0, 0];
  for (const angle of angles) {
    const down = [Math.sin(angle), -Math.cos(angle)];
    const rod = world.body({
      position: [at[0] + down[0] / 4, at[1] + down[1] / 4, 0],
      mass: 1,
      inertia: [0.02, 0, 0, 0, 0.02, 0, 0, 0, 0.02],
    });
    world.joint("hinge", before, rod, { at: [...at, 0], axes: [0, -Math.SQRT1_2, 0, Math.SQRT1_2] });
    before = rod;
    at = [at[0] + down[0] / 2, at[1] + down[1] / 2];
  }
  return world;
}

/** Angle of a pendulum of rods() from straight down after some seconds: its equation of motion by Runge and Kutta. */
function swung(angle, seconds) {
  const about = (0.02 + 1 / 16) / (9.81 / 4),
    rate = ([a, w]) => [w, -Math.sin(a) / about];
  let state = [angle, 0];
  const h = seconds / 100000,
    on = (s, k, f) => s.map((x, i) => x + f * k[i]);
  for (let i = 0; i < 100000; ++i) {
    const a = rate(state),
      b = rate(on(state, a, h / 2)),
      c = rate(on(state, b, h / 2)),
      d = rate(on(state, c, h));
    state = state.map((x, k) => x + (h / 6) * (a[k] + 2 * b[k] + 2 * c[k] + d[k]));
  }
  return state[0];
}

test("what is asked is told again, and nothing by default", () => {
  const world = rods([1]);
  assert.equal(world.accuracy, null);
  assert.deepEqual(world.islands(), []);
  world.setAccuracy({ place: 1e-4 });
  assert.deepEqual(world.accuracy, { place: 1e-4, turn: 1e-3, substeps: 256 });
  world.setAccuracy({ place: 0, turn: 2e-5, substeps: 64 });
  assert.deepEqual(world.accuracy, { place: 0, turn: 2e-5, substeps: 64 });
  world.clearAccuracy();
  assert.equal(world.accuracy, null);
  world.free();
});

test("a pendulum errs as little as was asked, and more is more work", () => {
  const truth = swung(1.5, 2);
  const work = [];
  for (const tolerance of [1e-3, 1e-6, 1e-9]) {
    const world = rods([1.5]),
      [rod] = world.bodies();
    world.gravity = [0, -9.81, 0];
    world.setAccuracy({ place: tolerance, turn: tolerance });
    let done = 0;
    for (let i = 0; i < 120; ++i) {
      world.step(1 / 60);
      const [island] = world.islands();
      assert.ok(island.flags.includes("joints_alone") && !island.flags.includes("bound"));
      assert.ok(island.share <= 1, `${island.share} at step ${i}`);
      assert.equal(island.body.handle, rod.handle);
      done += island.work;
    }
    const [x, y] = rod.position,
      error = Math.abs(Math.atan2(x, -y) - truth);
    assert.ok(error < 2 * tolerance, `${error} for ${tolerance}`);
    work.push(done);
    world.free();
  }
  assert.ok(work[0] < work[2], `${work}`);
});

test("islands come worst first, and tell of a bound that was hit", () => {
  const world = rods([1]);
  for (let k = 0; k < 3; ++k) {
    const ball = world.body({ position: [3 + 2 * k, 0, 0], linear_velocity: [0, 0, 3 * k] });
    world.joint("distance", null, ball, { position_a: [2 + 2 * k, 0, 0], length: 1 });
  }
  world.setAccuracy({ place: 1e-9, turn: 1e-9, substeps: 2 });
  world.step(1 / 60);
  const islands = world.islands();
  assert.equal(islands.length, 4);
  for (let i = 1; i < 4; ++i) assert.ok(islands[i].share <= islands[i - 1].share);
  assert.ok(islands[0].flags.includes("bound") && islands[0].share > 1 && islands[0].substeps <= 2);
  world.free();
});

test("chaos is told from what is regular, and the world stays as it is", () => {
  const wild = rods([2, 2.5]),
    calm = rods([1]);
  for (const world of [wild, calm]) world.setAccuracy({ place: 1e-5, turn: 1e-5 });
  const before = wild.hash(),
    growth = wild.measureGrowth({ steps: 1200 });
  assert.equal(wild.hash(), before);
  assert.ok(growth.sensitive === true && growth.rate > 1 && growth.body && growth.steps <= 1200);
  assert.equal(calm.measureGrowth({ steps: 1200, dt: 1 / 60 }).sensitive, false);
  (wild.free(), calm.free());
});

test("what is wrong is refused with a remedy, and nothing changes", () => {
  const world = rods([1]),
    before = world.hash();
  for (const wrong of [
    () => world.setAccuracy({ place: -1 }),
    () => world.setAccuracy({ place: NaN }),
    () => world.setAccuracy({ place: 0, turn: 0 }),
    () => world.setAccuracy({ substeps: 1 }),
    () => world.measureGrowth({ steps: 0 }),
    () => world.measureGrowth(),
    () => world.measureGrowth({ steps: 10, dt: NaN }),
  ])
    assert.throws(wrong, (e) => e instanceof CaromError && e.remedy.length > 10);
  assert.throws(() => world.setAccuracy({ tolerance: 1 }), /no field "tolerance".*place/);
  assert.equal(world.hash(), before);
  world.free();
});
