// A Wavefront OBJ file as one body: the convex hull of its points.
import { OBJLoader } from "three/addons/loaders/OBJLoader.js";
import { bounds, extremes } from "./points.js";

const LEAST = 0.1, // m: smaller and larger ones are taken to be in other units
  MOST = 5;
const ABOVE = 2; // m, over what the camera looks at

/** @returns { action, note }   action: a spawn, its position to be added to the place where it should fall */
export function bodyOf(carom, name, bytes) {
  const points = [];
  new OBJLoader().parse(new TextDecoder().decode(bytes)).traverse((child) => {
    const at = child.geometry?.attributes.position;
    if (at) for (const x of at.array) points.push(x);
  });
  if (points.length < 12) throw new Error(`${name} has no faces: is it an OBJ file?`);
  const hull = extremes(points),
    { low, high, size } = bounds(hull);
  if (!(size > 0)) throw new Error(`${name} is a single point`);
  const scale = size < LEAST || size > MOST ? 1 / size : 1,
    middle = low.map((l, k) => (l + high[k]) / 2);
  const params = hull.map((x, i) => scale * (x - middle[i % 3]));
  const engine = carom.engine();
  try {
    const { volume } = engine.hull(params).info;
    if (!(volume > 0)) throw new Error(`${name} is flat: a body needs a volume`);
  } finally {
    engine.free();
  }
  return {
    action: { do: "spawn", shape: "hull", params, position: [0, ABOVE, 0] },
    note: `${name}: the convex hull of its points (${params.length / 3})${scale === 1 ? "" : ", made 1 m long"}`,
  };
}
