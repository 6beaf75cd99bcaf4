// What a shape looks like, as three.js geometry in the shape's own frame.
import * as THREE from "three";
import { ConvexGeometry } from "three/addons/geometries/ConvexGeometry.js";
import { creased, plain, quartered, round } from "./look.js";

const DIRECTIONS = 600; // in which a shape that three.js does not know is asked for its farthest points

export function spread(n) {
  const out = new Float64Array(3 * n);
  for (let i = 0; i < n; ++i) {
    // Fibonacci's lattice on the sphere
    const y = 1 - (2 * i + 1) / n,
      r = Math.sqrt(1 - y * y),
      turn = i * Math.PI * (3 - Math.sqrt(5));
    out.set([r * Math.cos(turn), y, r * Math.sin(turn)], 3 * i);
  }
  return out;
}

function hull(points) {
  const vectors = [];
  for (let i = 0; i < points.length; i += 3) vectors.push(new THREE.Vector3(points[i], points[i + 1], points[i + 2]));
  return new ConvexGeometry(vectors);
}

/** Corners around what is round: of few bodies, of a crowd, of a crowd that the processor draws. */
export const [FINE, COARSE, ROUGH] = [24, 12, 8];
const ball = ([x, y = x, z = x], around) =>
  round(new THREE.SphereGeometry(1, around, (2 * around) / 3).scale(x, y, z), [x, y, z]);
const KNOWN = {
  "carom.sphere": ball,
  "carom.ellipsoid": ball,
  "carom.box": ([x, y, z]) => new THREE.BoxGeometry(2 * x, 2 * y, 2 * z),
  "carom.capsule": ([r, h], around) => new THREE.CapsuleGeometry(r, 2 * h, Math.round(around / 3), around),
  "carom.cylinder": ([r, h], around) => quartered(creased(new THREE.CylinderGeometry(r, r, 2 * h, around + 8)), r),
  "carom.cone": ([r, h], around) => new THREE.ConeGeometry(r, 2 * h, around + 8),
  "carom.hull": (points) => hull(points),
};

/** @param around  corners of what is round   @returns geometry, or null for a half-space */
export function geometryOf(shape, around = FINE) {
  const { kind } = shape.info;
  if (kind === "half_space") return null;
  if (kind === "scenery") {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.Float32BufferAttribute(shape.triangles(), 3));
    return creased(geometry, false);
  }
  if (!KNOWN[kind]) return creased(hull(shape.supports(spread(DIRECTIONS))));
  const geometry = KNOWN[kind](shape.params, around);
  return geometry.attributes.rim ? geometry : creased(geometry);
}

const MANY = 400; // faces: of more it is taken for something round
/** A mesh for the eye, as `carom pack` writes it.   @param mesh  { unit m, points [3n], faces [3m] } whole numbers */
export function drawnMesh({ unit, points, faces }) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute(
    "position",
    new THREE.BufferAttribute(
      Float32Array.from(points, (x) => unit * x),
      3,
    ),
  );
  geometry.setIndex(faces);
  return faces.length < 3 * MANY ? creased(geometry) : plain(geometry);
}
