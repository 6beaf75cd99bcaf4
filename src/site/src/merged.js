// Many bodies of one shape as one mesh. A graphics card takes an instanced one; where the processor draws, each instance
// costs as much as a mesh of its own, so there all corners stand in one list, and those of bodies that moved are computed
// here.
import * as THREE from "three";

class Merged extends THREE.Mesh {
  constructor(shape, material, count) {
    const source = shape.index ? shape.toNonIndexed() : shape,
      { position, normal, rim } = source.attributes,
      n = position.count,
      geometry = new THREE.BufferGeometry(),
      room = (size) => new THREE.BufferAttribute(new Float32Array(size * n * count), size);
    for (const name of ["position", "normal", "instanceColor"]) geometry.setAttribute(name, room(3));
    if (rim) {
      geometry.setAttribute("rim", room(4));
      for (let i = 0; i < count; ++i) geometry.attributes.rim.array.set(rim.array, 4 * n * i);
    }
    for (const name of ["position", "normal"]) geometry.attributes[name].setUsage(THREE.DynamicDrawUsage);
    material.defines = { ...material.defines, USE_INSTANCING_COLOR: "" };
    super(geometry, material);
    Object.assign(this, { n, from: [position.array, normal.array], last: new Float64Array(16 * count).fill(NaN) });
    if (source !== shape) source.dispose();
    // As of an instanced mesh: said once all have their place.
    this.instanceMatrix = { needsUpdate: false };
    this.instanceColor = geometry.attributes.instanceColor;
  }

  setMatrixAt(i, { elements: m }) {
    const { last, n } = this;
    let same = true;
    for (let k = 0; k < 16; ++k) same &&= last[16 * i + k] === m[k];
    if (same) return;
    last.set(m, 16 * i);
    const { position, normal } = this.geometry.attributes,
      [p, q] = this.from,
      a = position.array,
      b = normal.array;
    for (let k = 0, at = 3 * n * i; k < 3 * n; k += 3, at += 3) {
      const x = p[k],
        y = p[k + 1],
        z = p[k + 2],
        u = q[k],
        v = q[k + 1],
        w = q[k + 2];
      a[at] = m[0] * x + m[4] * y + m[8] * z + m[12];
      a[at + 1] = m[1] * x + m[5] * y + m[9] * z + m[13];
      a[at + 2] = m[2] * x + m[6] * y + m[10] * z + m[14];
      b[at] = m[0] * u + m[4] * v + m[8] * w;
      b[at + 1] = m[1] * u + m[5] * v + m[9] * w;
      b[at + 2] = m[2] * u + m[6] * v + m[10] * w;
    }
    position.needsUpdate = normal.needsUpdate = true;
  }

  setColorAt(i, { r, g, b }) {
    const { array } = this.instanceColor;
    for (let k = 0, at = 3 * this.n * i; k < this.n; ++k, at += 3)
      [array[at], array[at + 1], array[at + 2]] = [r, g, b];
  }

  /** three.js sorts by it; what is opaque needs no order. */
  computeBoundingSphere() {
    this.boundingSphere = new THREE.Sphere(new THREE.Vector3(), Infinity);
  }

  dispose() {
    this.geometry.dispose();
  }
}

/** @param cheap  the processor draws */
export const crowdOf = (shape, material, count, cheap) =>
  cheap ? new Merged(shape, material, count) : new THREE.InstancedMesh(shape, material, count);
