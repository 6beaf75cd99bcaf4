// A character, a vehicle, joints as arrays, functions as shapes: what is refused changes nothing, and states go on from bytes.
import { strict as assert } from "node:assert";
import { test } from "node:test";
import { Character, load, Vehicle } from "../src/index.js";

const carom = await load();
function made() {
  const engine = carom.engine(),
    world = engine.world();
  world.ground();
  return { engine, world, end: () => (world.free(), engine.free()) };
}

test("a character goes on from saved bytes, and refuses others", () => {
  const { engine, world, end } = made();
  const walker = new Character(world, engine.capsule(0.3, 0.6), { position: [0, 1, 0] });
  const walk = (n) => {
    for (let i = 0; i < n; ++i) (world.step(1 / 60), walker.move([1, 0, 0.5], 1 / 60, i === 5 ? 4 : 0));
    return walker.position;
  };
  walk(60);
  const saved = walker.save(),
    first = walk(40);
  walker.restore(saved);
  assert.deepEqual(walk(40), first);
  assert.throws(() => walker.restore(saved.slice(1)), /takes the \d+ bytes/);
  assert.deepEqual(walker.position, first);
  walker.position = [0, 5, 0];
  assert.equal(walker.ground, "air");
  assert.throws(() => new Character(world, engine.capsule(0.3, 0.6), { step_upp: 1 }), /no field "step_upp"/);
  assert.throws(() => walker.move([Number.NaN, 0, 0]), { result: "CAROM_E_NOT_FINITE" });
  assert.deepEqual(walker.position, [0, 5, 0]);
  end();
});

test("no place to stand up: nothing changes", () => {
  const { engine, world, end } = made();
  world.body({ shape: engine.box(5, 0.1, 5), type: "static", position: [0, 1.5, 0] });
  const walker = new Character(world, engine.capsule(0.3, 0.2), { position: [0, 0.6, 0] });
  const before = walker.save();
  assert.equal(walker.setShape(engine.capsule(0.3, 0.8)), false);
  assert.deepEqual(walker.save(), before);
  assert.equal(walker.setShape(engine.capsule(0.3, 0.25)), true);
  end();
});

test("a vehicle drives, and goes on from saved bytes with its world", () => {
  const { engine, world, end } = made();
  const body = world.body({ shape: engine.box(0.85, 0.3, 2), position: [0, 0.7, 0], density: 300 });
  const wheels = [1.3, -1.3].flatMap((z) => [0.75, -0.75].map((x) => ({ position: [x, -0.3, z], drive: 1 })));
  const car = new Vehicle(body, wheels);
  const drive = (n) => {
    for (let i = 0; i < n; ++i) (car.drive({ throttle: 0.5 }, 1 / 60), world.step(1 / 60));
    return world.hash();
  };
  drive(120);
  assert.ok(car.speed > 1, String(car.speed));
  assert.ok(car.wheels.every((wheel) => wheel.touches));
  const saved = [world.save(), car.save()],
    hash = drive(30);
  world.restore(saved[0]);
  car.restore(saved[1]);
  assert.equal(drive(30), hash);
  assert.throws(() => car.drive({ throttle: 2 }), { result: "CAROM_E_OUT_OF_RANGE" });
  assert.throws(() => new Vehicle(body, []), /takes 1 to \d+ wheels, not 0/);
  end();
});

test("joints as arrays: lengths and names are checked; the mass matrix is that of two rods", () => {
  const { engine, world, end } = made();
  const rod = world.body({ shape: engine.box(0.5, 0.05, 0.05), position: [0.5, 3, 0], mass: 2 });
  world.joint("hinge", null, rod, { at: [0, 3, 0], axes: [0, -Math.SQRT1_2, 0, Math.SQRT1_2] });
  world.writeJoints("position", [0.3]);
  assert.ok(Math.abs(world.readJoints("position")[0] - 0.3) < 1e-12);
  assert.throws(() => world.writeJoints("position", [0, 0]), /takes 1 numbers, not 2/);
  assert.throws(() => world.readJoints("positions"), /no field "positions"/);
  const [mass] = world.tree(rod).mass();
  const about = (2 * (1 + 0.1 * 0.1)) / 12 + 2 * 0.25; // kg m^2, about the hinge
  assert.ok(Math.abs(mass - about) < 1e-9, `${mass} ${about}`);
  end();
});

test("a function as a shape: what throws is refused, and a name that is taken", () => {
  const { engine, world, end } = made();
  const params = [["r", "m", 0.01, 10]];
  let calls = 0;
  const ball = engine.supportPlugin(
    ([r], d) => {
      ++calls;
      const length = Math.hypot(...d);
      return d.map((x) => (r * x) / length);
    },
    "test.ball",
    params,
  );
  const body = world.body({ shape: engine.shape(ball, [0.5]), position: [0, 2, 0] });
  for (let i = 0; i < 120; ++i) world.step(1 / 60);
  assert.ok(calls > 100 && Math.abs(body.position[1] - 0.5) < 0.01, String(body.position));
  const broken = () => engine.supportPlugin(() => assert.fail("on purpose"), "test.broken", params);
  assert.throws(broken, { result: "CAROM_E_PLUGIN_INVALID" });
  assert.throws(() => engine.supportPlugin(() => [0, 0, 0], "test.ball", params), { result: "CAROM_E_ALREADY_EXISTS" });
  end();
});
