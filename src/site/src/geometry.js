// What a shape looks like, as three.js geometry in the shape's own frame.
import * as THREE from "three";
import { ConvexGeometry } from "three/addons/geometries/ConvexGeometry.js";

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

const KNOWN = {
  "carom.sphere": ([r]) => new THREE.SphereGeometry(r, 24, 16),
  "carom.box": ([x, y, z]) => new THREE.BoxGeometry(2 * x, 2 * y, 2 * z),
  "carom.capsule": ([r, h]) => new THREE.CapsuleGeometry(r, 2 * h, 8, 20),
  "carom.cylinder": ([r, h]) => new THREE.CylinderGeometry(r, r, 2 * h, 32),
  "carom.cone": ([r, h]) => new THREE.ConeGeometry(r, 2 * h, 32),
  "carom.ellipsoid": ([x, y, z]) => new THREE.SphereGeometry(1, 24, 16).scale(x, y, z),
  "carom.hull": (points) => hull(points),
};

/** @returns geometry, or null for a half-space */
export function geometryOf(shape) {
  const { kind } = shape.info;
  if (kind === "half_space") return null;
  if (kind === "scenery") {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.Float32BufferAttribute(shape.triangles(), 3));
    geometry.computeVertexNormals();
    return geometry;
  }
  if (KNOWN[kind]) return KNOWN[kind](shape.params);
  return hull(shape.supports(spread(DIRECTIONS)));
}
