// The truth of an accuracy scene: where its bodies ought to be at each step, drawn as ghosts, and how far off they are.
import * as THREE from "three";

const POSE = 7; // numbers: x, y, z, then x, y, z, w of the turn, which are NaN where the truth does not tell it
const COLOUR = "#cc79a7"; // of the palette's, one that few kinds of bodies have

export class Truth {
  /** @param told  bodies, by number in the scene's list of names; frames   @param bytes  of the file of poses */
  constructor({ bodies, frames }, bytes) {
    if (bytes.byteLength !== 8 * POSE * bodies.length * frames) throw new Error("the file of true poses is damaged");
    Object.assign(this, { bodies, frames, poses: new Float64Array(bytes.slice(0)) });
  }

  /** Poses at a step, or null where the truth is not known so far. One frame alone holds at every step. */
  at(step) {
    const frame = this.frames === 1 ? 0 : step,
      size = POSE * this.bodies.length;
    return frame < this.frames ? this.poses.subarray(frame * size, (frame + 1) * size) : null;
  }

  /** m: how far the farthest body is from where it ought to be; NaN where that is not known.
   *  @param places  index among the world's bodies of each of `bodies`; -1: it is gone */
  error(sim, places) {
    const truth = this.at(sim.step),
      poses = sim.poses.update().array;
    if (!truth) return NaN;
    let most = NaN;
    places.forEach((place, i) => {
      if (place < 0) return;
      const off = Math.hypot(...[0, 1, 2].map((k) => poses[POSE * place + k] - truth[POSE * i + k]));
      most = most >= off ? most : off;
    });
    return most;
  }
}

/** In words, beside the hash. */
export function offTruth(metres) {
  return Number.isNaN(metres) ? "the truth is not known this far" : `${metres.toExponential(2)} m off the truth`;
}

/** The bodies of a picture once more, translucent, at their true poses. */
export class Ghosts {
  /** @param parts  what bodies look like   @param numberOf  body -> its number in the scene's list of names */
  constructor(truth, parts, geometries, count, numberOf) {
    Object.assign(this, { truth, group: new THREE.Group(), material: Ghosts.#look() });
    const places = new Map(Array.from({ length: count }, (_, body) => [numberOf(body), body]));
    this.places = truth.bodies.map((number) => places.get(number) ?? -1);
    const wanted = new Map(this.places.map((place, i) => [place, i]));
    const sets = new Map();
    for (const part of parts) sets.set(part.shape, [...(sets.get(part.shape) ?? []), part]);
    this.meshes = [];
    for (const [shape, list] of sets) {
      const all = list.filter((part) => wanted.has(part.body)).map((part) => ({ ...part, i: wanted.get(part.body) }));
      if (!all.length || !geometries.get(shape)) continue;
      const mesh = new THREE.InstancedMesh(geometries.get(shape), this.material, all.length);
      Object.assign(mesh, { frustumCulled: false, renderOrder: 1, userData: { parts: all } });
      this.meshes.push(mesh);
      this.group.add(mesh);
    }
  }

  static #look() {
    const material = new THREE.MeshLambertMaterial({ color: COLOUR, transparent: true, opacity: 0.45 });
    // Nearer by a little, so that a ghost is seen where its body is in the very same place.
    return Object.assign(material, {
      depthWrite: false,
      polygonOffset: true,
      polygonOffsetFactor: -1,
      polygonOffsetUnits: -4,
    });
  }

  /** @param poses  of the world's bodies: a ghost turns with its body where its own turn is not known */
  update(step, poses) {
    const truth = this.truth.at(step);
    this.group.visible = truth !== null;
    if (!truth) return;
    const body = new THREE.Matrix4(),
      local = new THREE.Matrix4(),
      p = new THREE.Vector3(),
      q = new THREE.Quaternion(),
      one = new THREE.Vector3(1, 1, 1);
    for (const mesh of this.meshes) {
      mesh.userData.parts.forEach((part, k) => {
        const at = POSE * part.i,
          turned = Number.isNaN(truth[at + 3]);
        turned ? q.fromArray(poses, POSE * part.body + 3) : q.fromArray(truth, at + 3);
        body.compose(p.fromArray(truth, at), q, one);
        local.compose(p.fromArray(part.position), q.fromArray(part.orientation), one);
        mesh.setMatrixAt(k, body.multiply(local));
      });
      mesh.instanceMatrix.needsUpdate = true;
      mesh.boundingSphere = null;
    }
  }

  dispose() {
    for (const mesh of this.meshes) mesh.dispose();
    this.material.dispose();
    this.group.removeFromParent();
  }
}
