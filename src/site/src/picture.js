// A simulation as three.js objects: one instanced mesh for each shape and kind of body, lines and points over them.
import * as THREE from "three";
import { Shape } from "carom";
import { DRAW } from "./simulation.js";
import { COARSE, drawnMesh, FINE, geometryOf, ROUGH } from "./geometry.js";
import { bodyMaterial } from "./look.js";
import { crowdOf } from "./merged.js";
import { bodyColour, FIXED, KINDS } from "./palette.js";
import { Ghosts } from "./truth.js";

const ASLEEP = 0.45; // of its brightness
const CROWD = 250, // parts: of more each has fewer corners
  CHEAP_CROWD = 40; // where the processor draws

/** What is drawn at first. */
export const SHOWN = {
  contacts: false,
  joints: false,
  bounds: false,
  outlines: false,
  frames: false,
  islands: false,
  sleep: true,
  truth: true,
};

export class Picture {
  /** @param row  of the scenes' index: names and kinds of bodies; may be {}   @param cheap  the processor draws */
  constructor(sim, row, cheap = false) {
    Object.assign(this, { sim, row, cheap });
    this.group = new THREE.Group();
    this.geometries = new Map();
    this.shown = { ...SHOWN };
    this.lines = new THREE.LineSegments(
      new THREE.BufferGeometry(),
      new THREE.LineBasicMaterial({ vertexColors: true, depthTest: false }),
    );
    ((this.lines.renderOrder = 2), (this.lines.frustumCulled = false));
    this.points = new THREE.Points(
      new THREE.BufferGeometry(),
      new THREE.PointsMaterial({ color: KINDS[1], size: 0.06 }),
    );
    this.points.frustumCulled = false;
    this.group.add(this.lines, this.points);
    this.structure = -1;
  }

  /** What is drawn beside bodies. */
  get beside() {
    return this.sim.driver ?? this.row.beside;
  }

  numberOf(body) {
    return Number(BigInt.asUintN(32, this.sim.bodies[body].user));
  }
  kindOf(body) {
    return this.row.bodies?.[this.numberOf(body)]?.[1] ?? "thrown";
  }
  nameOf(body) {
    return this.row.bodies?.[this.numberOf(body)]?.[0] ?? `body ${body}`;
  }

  /** What bodies look like: what the scene says, of others their colliders. A mesh for the eye stands in `shape`. */
  #parts() {
    const places = new Map(this.sim.bodies.map((_, body) => [this.numberOf(body), body]));
    const looks = (this.row.looks ?? []).filter((look) => places.has(look.body)),
      meshed = new Set(looks.filter((look) => look.mesh !== undefined).map((look) => places.get(look.body)));
    return this.sim.parts
      .filter((part) => !meshed.has(part.body))
      .concat(
        looks.map((look) => ({
          ...look,
          body: places.get(look.body),
          shape: this.row.meshes?.[look.mesh] ?? this.sim.engine.shape(look.shape, look.params).handle,
        })),
      );
  }

  #geometry(shape, around) {
    return shape.points ? drawnMesh(shape) : geometryOf(new Shape(this.sim.engine, shape), around);
  }

  /** Of what is drawn.   @param moving  those that move, or those that stand   @returns [[x, y, z, r]] m */
  balls(moving) {
    const { driver } = this.sim;
    if (driver?.room) return moving ? [[...driver.place(), driver.room]] : []; // what is steered is followed, alone
    const { array } = this.sim.poses.update(),
      out = [];
    this.types.forEach((type, i) => {
      if ((type === "static") === moving || !(this.reach[i] > 0)) return;
      const at = [array[7 * i], array[7 * i + 1], array[7 * i + 2]];
      if (at.every(Number.isFinite)) out.push([...at, this.reach[i]]);
    });
    if (moving && this.row.beside)
      for (const pose of this.row.beside.poses(this.sim.step)) out.push([...pose.slice(0, 3), 0.5]);
    const { array: points } = this.points.geometry.attributes.position ?? { array: [] },
      { count } = this.points.geometry.drawRange;
    if (moving && this.row.particles)
      for (let i = 0; i < count; i += 50) out.push([...points.slice(3 * i, 3 * i + 3), 0.1]);
    return out;
  }

  #rebuild() {
    for (const mesh of this.meshes ?? []) {
      (this.group.remove(mesh), mesh.dispose(), mesh.material.dispose());
      if (mesh.userData.driven) mesh.geometry.dispose();
    }
    this.meshes = [];
    this.structure = this.sim.structure;
    const sets = new Map(),
      all = this.#parts();
    this.types = this.sim.bodies.map((b) => b.type);
    for (const part of all) {
      const fixed = this.types[part.body] !== "dynamic";
      const kind = this.kindOf(part.body),
        key = `${part.mesh === undefined ? part.shape : `mesh ${part.mesh}`}/${fixed ? "" : kind}`;
      if (!sets.has(key)) sets.set(key, { shape: part.shape, fixed, kind, parts: [] });
      sets.get(key).parts.push(part);
    }
    const kinds = [...new Set([...sets.values()].filter((s) => !s.fixed).map((s) => s.kind))],
      around = this.cheap ? (all.length < CHEAP_CROWD ? COARSE : ROUGH) : all.length < CROWD ? FINE : COARSE,
      seen = new Map(); // kind -> how many of it there are so far
    this.reach = new Float64Array(this.types.length); // m, of each body about its origin; 0: nothing of it is drawn
    for (const set of sets.values()) {
      if (!this.geometries.has(set.shape)) this.geometries.set(set.shape, this.#geometry(set.shape, around));
      const geometry = this.geometries.get(set.shape);
      if (!geometry) continue;
      geometry.computeBoundingSphere();
      const material = bodyMaterial({ side: set.fixed ? THREE.DoubleSide : THREE.FrontSide });
      const mesh = crowdOf(geometry, material, set.parts.length, this.cheap);
      Object.assign(mesh, { castShadow: true, receiveShadow: true, frustumCulled: false });
      const k = kinds.indexOf(set.kind),
        count = this.types.filter((_, body) => this.kindOf(body) === set.kind).length;
      const colours = set.parts.map(({ body, position, orientation }) => {
        const { center, radius } = geometry.boundingSphere;
        const middle = center.clone().applyQuaternion(new THREE.Quaternion(...orientation));
        this.reach[body] = Math.max(this.reach[body], middle.add(new THREE.Vector3(...position)).length() + radius);
        if (set.fixed) return new THREE.Color(FIXED);
        const i = seen.get(set.kind) ?? 0;
        seen.set(set.kind, i + 1);
        return bodyColour(set.kind, k, i, count);
      });
      mesh.userData = { ...set, colours };
      this.meshes.push(mesh);
      this.group.add(mesh);
    }
    for (const look of this.beside?.looks() ?? []) {
      const geometry = geometryOf({ info: { kind: `carom.${look.shape}` }, params: look.params }),
        mesh = crowdOf(geometry, bodyMaterial(), 1, this.cheap);
      mesh.setColorAt(0, bodyColour(look.kind, 0, 0, 1));
      Object.assign(mesh, { castShadow: true, receiveShadow: true, frustumCulled: false, userData: { driven: true } });
      this.meshes.push(mesh);
      this.group.add(mesh);
    }
    this.ghosts?.dispose();
    this.ghosts = null;
    if (!this.row.truth) return;
    const { bodies } = this.sim;
    this.ghosts = new Ghosts(this.row.truth, all, this.geometries, bodies.length, (body) => this.numberOf(body));
    this.group.add(this.ghosts.group);
  }

  /** m: how far the farthest body is from its true place; NaN where that is not known. */
  error() {
    return this.ghosts ? this.row.truth.error(this.sim, this.ghosts.places) : NaN;
  }

  update() {
    const fresh = this.structure !== this.sim.structure;
    if (fresh) this.#rebuild();
    const poses = this.sim.poses.update().array;
    const body = new THREE.Matrix4(),
      local = new THREE.Matrix4(),
      one = new THREE.Vector3(1, 1, 1);
    const p = new THREE.Vector3(),
      q = new THREE.Quaternion(),
      colour = new THREE.Color();
    const dim = this.shown.sleep && Number(this.sim.report?.asleep_bodies ?? 0) > 0,
      paint = dim || this.dimmed || fresh;
    this.dimmed = dim;
    const driven = this.beside?.poses(this.sim.step);
    for (const mesh of this.meshes.filter((m) => m.userData.driven)) {
      const pose = driven.shift();
      mesh.setMatrixAt(0, body.compose(p.fromArray(pose), q.fromArray(pose, 3), one));
      mesh.instanceMatrix.needsUpdate = true;
    }
    for (const mesh of this.meshes) {
      if (mesh.userData.driven) continue;
      mesh.userData.parts.forEach((part, i) => {
        const at = 7 * part.body;
        body.compose(p.fromArray(poses, at), q.fromArray(poses, at + 3), one);
        local.compose(p.fromArray(part.position), q.fromArray(part.orientation), one);
        mesh.setMatrixAt(i, body.multiply(local));
        if (!paint) return;
        const asleep = dim && !mesh.userData.fixed && this.sim.bodies[part.body].asleep;
        mesh.setColorAt(i, colour.copy(mesh.userData.colours[i]).multiplyScalar(asleep ? ASLEEP : 1));
      });
      mesh.instanceMatrix.needsUpdate = true;
      if (paint) mesh.instanceColor.needsUpdate = true;
      mesh.boundingSphere = null; // of before
    }
    if (this.ghosts) {
      this.ghosts.update(this.sim.step, poses);
      this.ghosts.group.visible &&= this.shown.truth;
    }
    this.#draw();
  }

  #draw() {
    let what = 0;
    for (const name of Object.keys(DRAW)) if (this.shown[name]) what |= DRAW[name];
    const { points, colours } = what
      ? this.sim.world.draw(what, { colouring: this.shown.islands ? 1 : 0 })
      : { points: new Float32Array(), colours: new Uint32Array() };
    const rgb = new Float32Array(points.length);
    colours.forEach((c, i) => {
      for (let k = 0; k < 6; ++k) rgb[6 * i + k] = ((c >>> (24 - 8 * (k % 3))) & 255) / 255;
    });
    (this.#fill(this.lines.geometry, "position", points), this.#fill(this.lines.geometry, "color", rgb));
    this.lines.geometry.setDrawRange(0, points.length / 3);
    const particles = this.row.particles ? this.sim.world.particlePositions() : new Float32Array();
    this.#fill(this.points.geometry, "position", particles);
    this.points.geometry.setDrawRange(0, particles.length / 3);
  }

  #fill(geometry, name, values) {
    const old = geometry.attributes[name];
    if (old && old.array.length >= values.length) {
      old.array.set(values);
      old.needsUpdate = true;
      return;
    }
    const roomy = new Float32Array(Math.max(96, 2 * values.length));
    roomy.set(values);
    geometry.dispose();
    geometry.setAttribute(name, new THREE.BufferAttribute(roomy, 3));
  }

  /** Body under a ray, and where on it.   @returns {{body, point: THREE.Vector3}} or null */
  pick(ray) {
    const hit = this.sim.world.castRay(ray.origin.toArray(), ray.direction.toArray(), 1e4);
    if (!hit || hit.outcome === 0) return null;
    const body = this.sim.index.get(hit.body.handle);
    return body === undefined ? null : { body, point: new THREE.Vector3(...hit.point) };
  }

  dispose() {
    for (const mesh of this.meshes ?? []) {
      (mesh.dispose(), mesh.material.dispose());
      if (mesh.userData.driven) mesh.geometry.dispose();
    }
    this.ghosts?.dispose();
    for (const geometry of this.geometries.values()) geometry?.dispose();
    for (const object of [this.lines, this.points]) (object.geometry.dispose(), object.material.dispose());
    this.group.removeFromParent();
  }
}
