// A fan of rays from the place under the pointer, cast by the engine at each picture: in the plane of the surface there, as a
// scanner turns. It reads, so no bit of the world depends on it.
import * as THREE from "three";

const FAN = 90, // rays
  REACH = 1, // m for 1 m that the camera is away
  LIFT = 2e-3, // likewise, off the surface: a ray would begin in it
  NORMAL = 0.06; // likewise, of the line that shows the surface's direction
const HIT = [0.84, 0.37, 0],
  FREE = [0.55, 0.58, 0.62],
  UP = [0, 0.45, 0.7];

/** Two unit vectors across a unit vector. */
export function across([x, y, z]) {
  const [a, b, c] = Math.abs(y) < 0.9 ? [0, 1, 0] : [1, 0, 0],
    u = [y * c - z * b, z * a - x * c, x * b - y * a],
    size = Math.sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]),
    [p, q, r] = u.map((k) => k / size);
  return [
    [p, q, r],
    [y * r - z * q, z * p - x * r, x * q - y * p],
  ];
}

/** What is met from a place of the scene.   @param world  asked by castRay()   @param origin, direction  of the pointer's ray
 *  @param far  m, of the camera   @returns null where nothing is under the pointer; else { first, lines: [[from, to, colour]],
 *  hits, nearest }   nearest: m, Infinity where no ray of the fan meets anything */
export function scan(world, origin, direction, far) {
  const first = world.castRay(origin, direction, 1e4);
  if (!first || first.outcome === 0) return null;
  const step = (from, along, size) => from.map((x, i) => x + size * along[i]),
    inward = first.normal.reduce((sum, x, i) => sum + x * direction[i], 0) > 0,
    normal = inward ? first.normal.map((x) => -x) : [...first.normal], // towards the eye
    from = step(first.point, normal, LIFT * far),
    [u, v] = across(normal),
    reach = REACH * far,
    lines = [[first.point, step(first.point, normal, NORMAL * far), UP]];
  let hits = 0,
    nearest = Infinity;
  for (let i = 0; i < FAN; ++i) {
    const turn = (2 * Math.PI * i) / FAN,
      along = u.map((x, k) => Math.cos(turn) * x + Math.sin(turn) * v[k]),
      hit = world.castRay(from, along, reach),
      met = hit && hit.outcome !== 0;
    if (met) ((hits += 1), (nearest = Math.min(nearest, hit.time)));
    lines.push([from, met ? [...hit.point] : step(from, along, reach), met ? HIT : FREE]);
  }
  return { first, lines, hits, nearest };
}

export class Rays {
  constructor() {
    this.ray = null; // of the pointer
    this.lines = new THREE.LineSegments(
      new THREE.BufferGeometry(),
      new THREE.LineBasicMaterial({ vertexColors: true, transparent: true, opacity: 0.75 }),
    );
    for (const name of ["position", "color"])
      this.lines.geometry.setAttribute(name, new THREE.BufferAttribute(new Float32Array(6 * (FAN + 1)), 3));
    ((this.lines.frustumCulled = false), (this.lines.visible = false));
  }

  /** @param ray  of the pointer, or null: none   @param far  m, of the camera */
  aim(ray, far) {
    Object.assign(this, { ray, far });
  }

  /** @returns what is met, in words; "" where nobody asks */
  update(picture) {
    const found =
      this.ray && scan(picture.sim.world, this.ray.origin.toArray(), this.ray.direction.toArray(), this.far);
    this.lines.visible = Boolean(found);
    picture.group.add(this.lines); // of two pictures that one which is pointed at
    if (!found) return this.ray ? "the ray meets nothing" : "";
    const { position, color } = this.lines.geometry.attributes;
    found.lines.forEach(([from, to, rgb], i) => {
      (position.array.set(from, 6 * i), position.array.set(to, 6 * i + 3));
      (color.array.set(rgb, 6 * i), color.array.set(rgb, 6 * i + 3));
    });
    position.needsUpdate = color.needsUpdate = true;
    const body = picture.sim.index.get(found.first.body.handle),
      metres = (x) => `${Number(x.toPrecision(3))} m`,
      rest = found.hits
        ? `${found.hits} of ${FAN} rays around meet something, the nearest after ${metres(found.nearest)}`
        : "no ray around meets anything";
    return `${picture.nameOf(body)}, ${metres(found.first.time)} from the eye; ${rest}`;
  }
}
