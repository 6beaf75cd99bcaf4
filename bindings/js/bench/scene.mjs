// A packed scene as plain numbers, so that any engine can be given it, and a judge of poses that sees nothing else.
import { Shape } from "../src/index.js";

const FRICTION = 0.5; // of every pair, as in tests/bench

/** @param world  of carom, restored
 *  @returns bodies [{ moves, position, orientation, velocity, spin, solid: { kind, params }, density }] in the order of world.bodies() */
export function read(world) {
  const bodies = world.bodies(),
    index = new Map(bodies.map((body, i) => [body.handle, i]));
  const list = bodies.map((body) => ({
    moves: body.type === "dynamic",
    position: body.position,
    orientation: body.orientation,
    velocity: body.linearVelocity,
    spin: body.angularVelocity,
  }));
  for (const collider of world.colliders()) {
    const body = list[index.get(collider.body.handle)];
    if (body.solid) throw new Error("a body of several parts: these engines are compared on bodies of one");
    body.solid = solidOf(world.engine, collider.shape);
    body.shape = collider.shape;
    body.density = collider.density;
  }
  const reach = Math.max(...list.filter((b) => b.moves).flatMap((b) => b.position.map(Math.abs)));
  return { bodies: list, groundHalfWidth: reach + 30, groundHalfDepth: 10, friction: FRICTION };
}

const solids = new Map(); // of one engine
function solidOf(engine, handle) {
  const key = `${engine.pointer}/${handle}`;
  if (!solids.has(key)) {
    const shape = new Shape(engine, handle),
      { kind } = shape.info;
    const params = kind === "half_space" ? planeOf(engine, handle) : shape.params;
    solids.set(key, { kind: kind.replace("carom.", ""), params });
  }
  return solids.get(key);
}

/** Signed distance, m, and the normal from A to B.   @param a, b  [shape, pose [7]] */
function distance(engine, ...ends) {
  const m = engine.module,
    size = m.structs.size("carom_distance");
  return m.frame((room) => {
    const args = ends.flatMap(([shape, pose]) => [
      shape,
      m.putDoubles(room, pose.slice(0, 3), 3, "position"),
      m.putDoubles(room, pose.slice(3), 4, "orientation"),
    ]);
    const out = room(size);
    m.view.setUint32(out, size, true);
    m.call("carom_shape_distance", engine.pointer, ...args, 0, out);
    return m.structs.read(m.view, "carom_distance", out);
  });
}

const HERE = [0, 0, 0, 0, 0, 0, 1];
/** A half-space does not tell its numbers; a ball at the origin does.   @returns normal, offset */
function planeOf(engine, handle) {
  const ball = engine.sphere(1),
    { separation, normal } = distance(engine, [ball.handle, HERE], [handle, HERE]);
  ball.destroy();
  return [...normal.map((x) => -x), -(separation + 1)];
}

/** How well poses hold: overlaps by Carom's distance, bodies that are lost, how far the farthest went from its start.
 *  @returns deepest, mean (of those that overlap), strayed: m; lost */
export function judge(engine, scene, poses) {
  const moving = scene.bodies.map((b, i) => i).filter((i) => scene.bodies[i].moves);
  let deepest = 0,
    sum = 0,
    overlaps = 0,
    lost = 0,
    strayed = 0;
  const radius = scene.bodies.map((b) => new Shape(engine, b.shape).info.bounding_radius);
  // What stands still is where the scene has it, whatever an engine has in its place.
  const at = (i) => [
    scene.bodies[i].shape,
    scene.bodies[i].moves ? poses[i] : [...scene.bodies[i].position, ...scene.bodies[i].orientation],
  ];
  const gap = (i, j) => distance(engine, at(i), at(j)).separation;
  const note = (d) => {
    if (d >= 0) return;
    ((sum -= d), ++overlaps, (deepest = Math.max(deepest, -d)));
  };
  for (const i of moving) {
    const p = poses[i];
    if (!p.every(Number.isFinite) || p[1] < -1) {
      ++lost;
      continue;
    }
    strayed = Math.max(strayed, Math.hypot(...[0, 1, 2].map((k) => p[k] - scene.bodies[i].position[k])));
    for (const j of moving) {
      if (j <= i) continue;
      const q = poses[j],
        reach = radius[i] + radius[j];
      if ((p[0] - q[0]) ** 2 + (p[1] - q[1]) ** 2 + (p[2] - q[2]) ** 2 < reach * reach) note(gap(i, j));
    }
    for (let j = 0; j < scene.bodies.length; ++j) if (!scene.bodies[j].moves) note(gap(i, j));
  }
  return { deepest, mean: overlaps ? sum / overlaps : 0, lost, strayed };
}
