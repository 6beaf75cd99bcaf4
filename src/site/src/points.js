// Points of meshes, thinned to what a convex hull needs.
import { spread } from "./geometry.js";

const ENOUGH = 64; // points: hulls of more are thinned
const DIRECTIONS = 200; // in which the farthest point is kept

/** @param points [3n]   @returns [3m] with the farthest points of many directions, each once */
export function extremes(points) {
  const unique = new Map();
  for (let i = 0; i + 2 < points.length; i += 3) {
    const p = [points[i], points[i + 1], points[i + 2]];
    if (!p.every(Number.isFinite)) throw new Error("a point of the mesh is not finite");
    unique.set(p.join(), p);
  }
  const all = [...unique.values()];
  if (all.length <= ENOUGH) return all.flat();
  const kept = new Set(),
    directions = spread(DIRECTIONS);
  for (let d = 0; d < directions.length; d += 3) {
    let best = 0,
      most = -Infinity;
    all.forEach((p, i) => {
      const along = p[0] * directions[d] + p[1] * directions[d + 1] + p[2] * directions[d + 2];
      if (along > most) ((most = along), (best = i));
    });
    kept.add(best);
  }
  return [...kept].sort((a, b) => a - b).flatMap((i) => all[i]);
}

/** m: how far points are from one plane, about; 0: they have no volume.   @param points [3n] */
export function thickness(points) {
  const at = (i) => [points[3 * i], points[3 * i + 1], points[3 * i + 2]],
    n = Math.floor(points.length / 3),
    from = at(0);
  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]],
    off = (i) => at(i).map((x, k) => x - from[k]);
  /** The point that is farthest by some measure, as a vector from the first. */
  const farthest = (measure) => {
    let best = [0, 0, 0],
      most = 0;
    for (let i = 1; i < n; ++i) {
      const v = off(i),
        far = Math.abs(measure(v));
      if (far > most) ((most = far), (best = v));
    }
    return [best, most];
  };
  const [along, length] = farthest((v) => Math.hypot(...v));
  if (!length) return 0;
  const [aside, area] = farthest((v) => Math.hypot(...cross(along, v)));
  if (!area) return 0;
  const normal = cross(along, aside).map((x) => x / area);
  return farthest((v) => v[0] * normal[0] + v[1] * normal[1] + v[2] * normal[2])[1];
}

/** @returns { low [3], high [3], size }   size: the longest edge, m */
export function bounds(points) {
  const low = [Infinity, Infinity, Infinity],
    high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < points.length; ++i) {
    low[i % 3] = Math.min(low[i % 3], points[i]);
    high[i % 3] = Math.max(high[i % 3], points[i]);
  }
  return { low, high, size: Math.max(...high.map((h, k) => h - low[k])) };
}
