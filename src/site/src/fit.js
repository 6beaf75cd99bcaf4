// Where a camera stands so that all bodies are seen, whatever the width of the picture.
import * as THREE from "three";

const ROOM = 1.12; // of the picture, about what is to be seen

/** @param balls [[x, y, z, r]] m   @param direction  unit, from what is looked at to the camera
 *  @param camera  its field of view, aspect and up count   @param covered  share of the height, at the top, that tools hide
 *  @returns { target, distance } */
export function fit(balls, direction, camera, covered) {
  const look = new THREE.Matrix4().lookAt(direction, new THREE.Vector3(), camera.up),
    [right, up] = [0, 1].map((k) => new THREE.Vector3().setFromMatrixColumn(look, k)),
    half = Math.tan((camera.fov * Math.PI) / 360),
    tall = (half / ROOM) * (1 - covered),
    wide = (half / ROOM) * camera.aspect;
  const seen = balls.map(([x, y, z, r]) => {
    const p = new THREE.Vector3(x, y, z);
    return [p.dot(right), p.dot(up), p.dot(direction), r];
  });
  const middle = [0, 1, 2].map((k) => {
    const low = Math.min(...seen.map((s) => s[k] - s[3])),
      high = Math.max(...seen.map((s) => s[k] + s[3]));
    return (low + high) / 2;
  });
  let distance = 0;
  // How far each ball asks the camera to be; then what is seen is centred, and asked again.
  for (let pass = 0; pass < 3; ++pass) {
    const reach = (k, tangent) =>
      Math.max(
        ...seen.map((s) => Math.abs(s[k] - middle[k]) / tangent + s[3] * Math.hypot(1, 1 / tangent) + s[2] - middle[2]),
      );
    distance = Math.max(reach(0, wide), reach(1, tall));
    for (const k of [0, 1]) {
      const sides = [-1, 1].map((sign) =>
        Math.max(...seen.map((s) => (sign * (s[k] - middle[k]) + s[3]) / (distance - s[2] + middle[2]))),
      );
      middle[k] += ((sides[1] - sides[0]) / 2) * distance;
    }
  }
  const target = right
    .clone()
    .multiplyScalar(middle[0])
    .addScaledVector(up, middle[1] + covered * half * distance)
    .addScaledVector(direction, middle[2]);
  return { target, distance };
}

/** Those that belong together: what flew off far is left out, or nobody would see the rest.
 *  @param balls [[x, y, z, r]]   @param size m, how far apart they were at first */
export function crowd(balls, size) {
  if (balls.length < 2) return balls;
  const middle = [0, 1, 2].map((k) => balls.map((b) => b[k]).sort((a, b) => a - b)[balls.length >> 1]);
  const far = balls.map((b) => Math.hypot(b[0] - middle[0], b[1] - middle[1], b[2] - middle[2])),
    most = Math.max(1.2 * size, 2 * far.toSorted((a, b) => a - b)[Math.floor(0.85 * (far.length - 1))]);
  return balls.filter((_, i) => far[i] <= most);
}
