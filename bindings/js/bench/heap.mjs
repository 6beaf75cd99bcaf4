// What tests of threads step, in node and in browsers.

/** 300 bodies, and the hashes of some steps.
 *  @param threads  of the engine   @param shape  (engine) => Shape, or four kinds */
export function heap(carom, { threads, shape = null, steps = 60 } = {}) {
  const engine = carom.engine(threads && { threads });
  const world = engine.world();
  world.ground();
  const shapes = shape
    ? [shape(engine)]
    : [engine.sphere(0.3), engine.box(0.3, 0.2, 0.25), engine.capsule(0.2, 0.2), engine.cylinder(0.2, 0.3)];
  for (let i = 0; i < 300; ++i)
    world.body({
      shape: shapes[i % shapes.length],
      position: [0.7 * (i % 5) + 0.01 * (i % 7), 0.6 + 0.7 * Math.floor(i / 25), 0.7 * (Math.floor(i / 5) % 5)],
      angular_velocity: [i % 3, (i % 5) - 2, 0],
    });
  const hashes = [];
  for (let i = 0; i < steps; ++i) (world.step(1 / 60), hashes.push(world.hash()));
  world.free();
  engine.free();
  return hashes;
}
