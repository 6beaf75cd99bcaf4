// Bodies for three.js' meshes, in the manner of its own physics addons: `addScene`, `addMesh`, `setMeshPosition`.
// Poses go from the world into the meshes after each step. three.js itself is not imported: meshes bring what is needed.
import { load } from "./index.js";

const STEP = 1 / 60; // s
const MOST_STEPS = 5; // in one go: after a pause the past is not made up for

/** @param mesh  in the world: its pose and its scale. */
function placeOf(mesh) {
  mesh.updateWorldMatrix(true, false);
  const position = mesh.position.clone(),
    quaternion = mesh.quaternion.clone(),
    scale = mesh.scale.clone();
  mesh.matrixWorld.decompose(position, quaternion, scale);
  return { position, quaternion, scale };
}

/** Corners [3n] and triangles [3m] of a geometry, scaled. */
function trianglesOf(geometry, scale) {
  const at = geometry.attributes.position,
    vertices = new Float64Array(3 * at.count);
  for (let i = 0; i < at.count; ++i)
    vertices.set([at.getX(i) * scale.x, at.getY(i) * scale.y, at.getZ(i) * scale.z], 3 * i);
  const triangles = geometry.index
    ? Uint32Array.from(geometry.index.array)
    : Uint32Array.from({ length: at.count }, (_, i) => i);
  if (scale.x * scale.y * scale.z < 0)
    // a mirror turns triangles inside out
    for (let i = 0; i + 2 < triangles.length; i += 3) triangles.subarray(i + 1, i + 3).reverse();
  return { vertices, triangles };
}

function equal(a, b, what) {
  if (Math.abs(a - b) > 1e-6 * Math.abs(a))
    throw new TypeError(
      `${what}, scaled differently along its axes, is no such shape: scale it evenly, or use a BufferGeometry`,
    );
  return Math.abs(a);
}

/** Geometries that the engine has as they are; all others are hulls or, where nothing moves, triangles. */
const KNOWN = {
  BoxGeometry: (e, p, s) => e.box((p.width * s.x) / 2, (p.height * s.y) / 2, (p.depth * s.z) / 2),
  SphereGeometry: (e, p, s) =>
    s.x === s.y && s.y === s.z ? e.sphere(p.radius * s.x) : e.ellipsoid(p.radius * s.x, p.radius * s.y, p.radius * s.z),
  CapsuleGeometry: (e, p, s) => {
    const r = equal(equal(s.x, s.z, "a capsule"), s.y, "a capsule");
    return e.capsule(p.radius * r, ((p.height ?? p.length) * r) / 2);
  },
  CylinderGeometry: (e, p, s) =>
    p.radiusTop === p.radiusBottom && !p.openEnded
      ? e.cylinder(p.radiusTop * equal(s.x, s.z, "a cylinder"), (p.height * s.y) / 2)
      : null,
  ConeGeometry: (e, p, s) => (p.openEnded ? null : e.cone(p.radius * equal(s.x, s.z, "a cone"), (p.height * s.y) / 2)),
};
const PARTS = ["phiStart", "phiLength", "thetaStart", "thetaLength"];
// Their values where nothing is left out.
const WHOLE = {
  SphereGeometry: [0, 2 * Math.PI, 0, Math.PI],
  CylinderGeometry: [, , 0, 2 * Math.PI],
  ConeGeometry: [, , 0, 2 * Math.PI],
};

function isWhole(geometry) {
  const first = WHOLE[geometry.type] ?? [];
  return PARTS.every((part, i) => first[i] === undefined || (geometry.parameters[part] ?? first[i]) === first[i]);
}

export class Physics {
  /** @param carom  of load()   @param options  gravity [3] m/s^2, dt s */
  constructor(carom, { gravity = [0, -9.81, 0], dt = STEP } = {}) {
    this.carom = carom;
    this.engine = carom.engine();
    this.world = this.engine.world({ gravity });
    this.dt = dt;
    this.owed = 0; // s
    this.meshes = new Map(); // mesh -> its bodies: one, or one an instance
    this.scales = new WeakMap(); // body -> scale of its mesh or instance, in the world
    this.shapes = new Map(); // geometry -> [{ scale, moves, shape }]
    this.view = this.world.view("pose", { scalar: "f32" });
    this.moving = []; // [mesh, index], as the view has them
  }

  /** A body for each mesh below that has `userData.physics = { mass, restitution, friction }`. */
  addScene(scene) {
    scene.traverse((child) => {
      const physics = child.isMesh && child.userData.physics;
      if (physics) this.addMesh(child, physics.mass, physics.restitution, physics.friction);
    });
  }

  /** @param mass kg; 0: it does not move   @param mesh  a Mesh or an InstancedMesh: then a body for each instance
   *  @returns the body, or the bodies of instances   @throws CaromError, TypeError: then nothing was added */
  addMesh(mesh, mass = 0, restitution = 0, friction = 0.5) {
    if (this.meshes.has(mesh)) throw new TypeError("this mesh has a body already: removeMesh() first");
    const place = placeOf(mesh),
      bodies = [];
    const add = (position, quaternion, scale) => {
      const shape = this.#shape(mesh.geometry, scale, mass > 0);
      const solid = shape.info.volume;
      const body = this.world.body({
        type: mass > 0 ? "dynamic" : "static",
        shape,
        density: mass > 0 ? mass / solid : 1000,
        position: position.toArray(),
        orientation: quaternion.toArray(),
        restitution,
        friction,
      });
      this.scales.set(body, scale);
      bodies.push(body);
    };
    try {
      if (mesh.isInstancedMesh) {
        const matrix = mesh.matrixWorld.clone();
        for (let i = 0; i < mesh.count; ++i) {
          mesh.getMatrixAt(i, matrix);
          const p = place.position.clone(),
            q = place.quaternion.clone(),
            s = place.scale.clone();
          matrix.premultiply(mesh.matrixWorld).decompose(p, q, s);
          add(p, q, s);
        }
      } else {
        add(place.position, place.quaternion, place.scale);
      }
    } catch (error) {
      for (const body of bodies) body.destroy();
      throw error;
    }
    this.meshes.set(mesh, bodies);
    this.#chooseMoving();
    return mesh.isInstancedMesh ? bodies : bodies[0];
  }

  /** Its bodies go; the mesh stays where it is. */
  removeMesh(mesh) {
    for (const body of this.meshes.get(mesh) ?? []) body.destroy();
    if (this.meshes.delete(mesh)) this.#chooseMoving();
  }

  /** Put it elsewhere, at rest. @param index  of an instance   @param quaternion  as it is by default */
  setMeshPosition(mesh, position, index = 0, quaternion) {
    const body = this.#body(mesh, index);
    body.setPose(position.toArray(), quaternion?.toArray());
    if (body.type === "dynamic") (body.setVelocity([0, 0, 0]), body.wake());
    this.#write(mesh, index, body.position, body.orientation);
  }

  /** @param velocity  m/s */
  setMeshVelocity(mesh, velocity, index = 0) {
    const body = this.#body(mesh, index);
    (body.wake(), body.setVelocity(velocity.toArray(), body.angularVelocity));
  }

  /** Let time pass.   @param seconds  since the last call: as many steps of `dt` are taken as fit; the rest is kept */
  update(seconds) {
    this.owed += Math.max(0, seconds);
    const due = Math.floor(this.owed / this.dt + 1e-9),
      taken = Math.min(due, MOST_STEPS);
    this.owed -= due * this.dt;
    for (let i = 0; i < taken; ++i) this.world.step(this.dt);
    if (taken) this.#writeAll();
    return taken;
  }

  /** One step, whatever the time. */
  step() {
    this.world.step(this.dt);
    this.#writeAll();
  }

  /** Everything of the engine; the meshes stay as they are. */
  dispose() {
    this.stop?.();
    this.view.free();
    this.world.free();
    this.engine.free();
    this.meshes.clear();
  }

  #body(mesh, index) {
    const body = this.meshes.get(mesh)?.[index];
    if (!body) throw new TypeError("this mesh has no such body: addMesh(mesh, mass) gives it one");
    return body;
  }

  #shape(geometry, scale, moves) {
    if (!this.shapes.has(geometry)) this.shapes.set(geometry, []);
    const known = this.shapes.get(geometry);
    const found = known.find((k) => k.scale.equals(scale) && (k.moves === moves || k.always));
    if (found) return found.shape;
    const exact = isWhole(geometry) ? KNOWN[geometry.type]?.(this.engine, geometry.parameters, scale) : null;
    const { vertices, triangles } = exact ? {} : trianglesOf(geometry, scale);
    const shape =
      exact ?? (moves ? this.engine.hull(vertices) : this.engine.mesh(vertices, triangles, { twoSided: true }));
    known.push({ scale: scale.clone(), moves, always: Boolean(exact), shape });
    return shape;
  }

  #chooseMoving() {
    this.moving = [];
    const bodies = [];
    for (const [mesh, list] of this.meshes)
      list.forEach((body, index) => {
        if (body.type === "dynamic") (this.moving.push([mesh, index]), bodies.push(body));
      });
    this.view.choose(bodies);
  }

  #writeAll() {
    if (!this.moving.length) return;
    const poses = this.view.update().array;
    this.moving.forEach(([mesh, index], i) =>
      this.#write(mesh, index, poses.subarray(7 * i, 7 * i + 3), poses.subarray(7 * i + 3, 7 * i + 7)),
    );
    for (const [mesh] of this.moving) if (mesh.isInstancedMesh) mesh.boundingSphere = null; // of before
  }

  /** A pose in the world, into a mesh that may have parents, or into one instance. */
  #write(mesh, index, position, orientation) {
    const p = mesh.position.clone().fromArray(position),
      q = mesh.quaternion.clone().fromArray(orientation).normalize();
    if (mesh.isInstancedMesh) {
      const matrix = mesh.matrixWorld.clone().compose(p, q, this.scales.get(this.meshes.get(mesh)[index]));
      mesh.setMatrixAt(index, matrix.premultiply(mesh.matrixWorld.clone().invert()));
      mesh.instanceMatrix.needsUpdate = true;
      return;
    }
    const parent = mesh.parent;
    if (!parent || parent.isScene) {
      (mesh.position.copy(p), mesh.quaternion.copy(q));
      return;
    }
    const above = placeOf(parent); // the mesh keeps its scale
    mesh.position.copy(p.applyMatrix4(parent.matrixWorld.clone().invert()));
    mesh.quaternion.copy(above.quaternion.invert().multiply(q));
  }
}

/** The engine, with time that passes by itself, as in three.js' addons.
 *  @param options  gravity, dt; source, threads: as load() takes them; running: false,
 *                  where you call update() or step() */
export async function CaromPhysics({ source, threads, running = true, ...options } = {}) {
  const physics = new Physics(await load({ source, threads }), options);
  if (!running) return physics;
  let last = performance.now();
  const timer = setInterval(() => {
    const now = performance.now();
    physics.update((now - last) / 1000);
    last = now;
  }, 1000 * physics.dt);
  physics.stop = () => clearInterval(timer);
  return physics;
}
