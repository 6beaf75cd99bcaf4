// A car brakes: from 20 m/s on tyres of grip 1 it needs v^2 / (2 g) = 20.4 m.
import assert from "node:assert/strict";
import { load, Vehicle } from "carom";

const carom = await load();
const engine = carom.engine(),
  world = engine.world();
world.ground();
const inertia = [1600, 0, 0, 0, 1800, 0, 0, 0, 500];
const body = world.body({ position: [0, 0.6, 0], mass: 1200, center: [0, 0, 0], inertia });
body.addCollider(engine.box(0.85, 0.3, 2), { position: [0, 0.15, 0] });
const wheels = [1.3, -1.3].flatMap((z) =>
  [0.75, -0.75].map((x) => ({ position: [x, -0.32, z], brake: 1e5, slide: 1 })),
);
const car = new Vehicle(body, wheels);

function frames(n, input) {
  for (let i = 0; i < n; ++i) {
    car.drive({ gear: 0, ...input }, 1 / 60);
    world.step(1 / 60);
  }
}

frames(120); // it settles on its springs
body.setVelocity([0, 0, 20]);
car.setSpin(20 / 0.33);
const begin = body.position[2];
frames(210, { brake: 1 });
const way = body.position[2] - begin,
  speed = Math.abs(car.speed);
console.log(`it brakes from 20 m/s in ${way.toFixed(1)} m and stands: ${speed.toFixed(2)} m/s`);
assert(Math.abs(way - 400 / (2 * 9.81)) < 0.5 && speed < 1e-3);
world.free();
engine.free();
