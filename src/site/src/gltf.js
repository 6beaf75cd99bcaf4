// A glTF file as a scene: bodies and colliders of KHR_physics_rigid_bodies, or, where a file has no physics, a body for each mesh.
// The command's reader knows more (joints, filters, OMI's and our own extensions): what is left out here is told.
import * as THREE from "three";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";
import { bounds, extremes, thickness } from "./points.js";

const PHYSICS = "KHR_physics_rigid_bodies",
  SHAPES = "KHR_implicit_shapes";
// Of those that a file may require: looks, which are not needed here, and what the loader reads.
const REQUIRED =
  /^(KHR_physics_rigid_bodies|KHR_implicit_shapes|KHR_mesh_quantization|KHR_materials_\w+|KHR_texture_\w+|KHR_lights_punctual|EXT_texture_\w+)$/;
const MOST_BODIES = 5000;
const FLAT = 1e-6; // of its size: a thinner mesh has no volume
const FRICTION = 0.6; // of the extension's materials that do not say

/** The file, without its looks. Nothing is fetched: buffers stand in the file. */
async function parsed(name, bytes) {
  const manager = new THREE.LoadingManager();
  manager.setURLModifier((url) => {
    if (!/^(data|blob):/.test(url))
      throw new Error(`${name} refers to ${url.slice(0, 80)}: put its buffers into the file, as .glb`);
    return url;
  });
  const loader = new GLTFLoader(manager);
  loader.register(() => ({ name: "no looks", loadMaterial: async () => new THREE.MeshBasicMaterial() }));
  const whole = bytes.slice(); // an ArrayBuffer of its own
  const gltf = await loader.parseAsync(whole.buffer, "").catch((error) => {
    throw new Error(`${name} cannot be read as glTF: ${error.message ?? error}`);
  });
  return gltf;
}

/** Objects of nodes, by the node's number. */
function objectsOf(gltf) {
  const objects = new Map();
  gltf.scene.updateMatrixWorld(true);
  gltf.scene.traverse((object) => {
    const node = gltf.parser.associations.get(object)?.nodes;
    if (node !== undefined && !objects.has(node)) objects.set(node, object);
  });
  return objects;
}

class Builder {
  constructor(carom, name, gltf) {
    Object.assign(this, { name, gltf, json: gltf.parser.json, notes: new Map() });
    this.engine = carom.engine();
    this.world = this.engine.world();
    this.bodies = []; // [name, kind]
    this.owners = []; // bodies that move, and what is theirs
    this.looks = []; // meshes that are drawn in place of the shapes that collide
    this.meshes = [];
  }

  note(text) {
    this.notes.set(text, (this.notes.get(text) ?? 0) + 1);
  }

  body(object, options, kind) {
    if (this.bodies.length >= MOST_BODIES) throw new Error(`${this.name} has more than ${MOST_BODIES} bodies`);
    const p = new THREE.Vector3(),
      q = new THREE.Quaternion();
    object.matrixWorld.decompose(p, q, new THREE.Vector3());
    if (!q.toArray().every(Number.isFinite)) q.identity(); // scaled to nothing along an axis: the points have the turn
    const body = this.world.body({
      ...options,
      position: p.toArray(),
      orientation: q.normalize().toArray(),
      user: BigInt(this.bodies.length),
    });
    this.bodies.push([object.name || `node ${this.bodies.length}`, kind]);
    return { body, inverse: new THREE.Matrix4().compose(p, q, new THREE.Vector3(1, 1, 1)).invert() };
  }

  /** Points of the meshes at a node, in the axes of a matrix. */
  points(object, matrix) {
    const out = [],
      at = new THREE.Vector3();
    const add = (mesh) => {
      const { position } = mesh.geometry.attributes;
      const to = matrix.clone().multiply(mesh.matrixWorld);
      for (let i = 0; i < position.count; ++i)
        out.push(...at.fromBufferAttribute(position, i).applyMatrix4(to).toArray());
    };
    if (object.isMesh) add(object);
    for (const child of object.children)
      if (child.isMesh && this.gltf.parser.associations.get(child)?.nodes === undefined) add(child);
    return out;
  }

  triangles(object, matrix) {
    const vertices = [],
      corners = [];
    for (const mesh of [object, ...object.children]) {
      if (!mesh.isMesh || (mesh !== object && this.gltf.parser.associations.get(mesh)?.nodes !== undefined)) continue;
      const first = vertices.length / 3,
        { index } = mesh.geometry;
      const own = this.points(
        { isMesh: true, geometry: mesh.geometry, matrixWorld: mesh.matrixWorld, children: [] },
        matrix,
      );
      for (const x of own) vertices.push(x);
      if (index) for (const i of index.array) corners.push(first + i);
      else for (let i = 0; i < own.length / 3; ++i) corners.push(first + i);
    }
    return { vertices, corners };
  }

  /** @returns shape, or null where there is none of that kind */
  shape(given, s) {
    if (!given) throw new Error(`${this.name} names a shape that is not in it`);
    const { type } = given,
      own = given[type] ?? {},
      round = Math.abs(s.x - s.z) <= 1e-6 * Math.abs(s.x);
    if (type === "box") {
      const [x, y, z] = own.size ?? [1, 1, 1];
      return this.engine.box((x * s.x) / 2, (y * s.y) / 2, (z * s.z) / 2);
    }
    if (type === "sphere") {
      const r = own.radius ?? 0.5;
      return round && Math.abs(s.x - s.y) <= 1e-6 * s.x
        ? this.engine.sphere(r * s.x)
        : this.engine.ellipsoid(r * s.x, r * s.y, r * s.z);
    }
    const { height = 0.5, radiusTop = 0.25, radiusBottom = 0.25 } = own;
    if (type === "cylinder" && round && radiusTop === radiusBottom)
      return this.engine.cylinder(radiusTop * s.x, (height * s.y) / 2);
    if (type === "capsule" && round && Math.abs(s.x - s.y) <= 1e-6 * s.x && radiusTop === radiusBottom)
      return this.engine.capsule(radiusTop * s.x, (height * s.y) / 2);
    this.note(`a ${type}${type === "plane" ? "" : " of two radii, or scaled unevenly,"} is left out`);
    return null;
  }

  collider({ body, inverse }, object, collider, moves, density) {
    const matrix = inverse.clone().multiply(object.matrixWorld),
      p = new THREE.Vector3(),
      q = new THREE.Quaternion(),
      s = new THREE.Vector3();
    matrix.decompose(p, q, s);
    const { geometry = {} } = collider;
    let shape,
      pose = { position: p.toArray(), orientation: q.normalize().toArray() };
    if (geometry.shape !== undefined) {
      shape = this.shape(this.json.extensions?.[SHAPES]?.shapes?.[geometry.shape], s);
    } else {
      const node = geometry.node !== undefined ? this.objects.get(geometry.node) : object;
      if (!node) return null;
      pose = {};
      // Its own place is that of the node with the collider.
      const to = node !== object ? matrix.clone().multiply(node.matrixWorld.clone().invert()) : inverse;
      shape = this.meshShape(node, to, moves || geometry.convexHull);
    }
    if (!shape) return null;
    const material = this.json.extensions?.[PHYSICS]?.physicsMaterials?.[collider.physicsMaterial] ?? {};
    const surface = this.world.material({
      friction: material.dynamicFriction ?? FRICTION,
      restitution: material.restitution ?? 0,
    });
    body.addCollider(shape, { ...pose, density, material: surface });
    return shape;
  }

  meshShape(object, matrix, convex) {
    if (convex) {
      const points = extremes(this.points(object, matrix));
      if (points.length && this.isFlat(points))
        throw new Error(
          `${this.name}: the mesh "${object.name}" is flat and has no volume. A body that moves needs one: give it a thickness, or let it stand still`,
        );
      return points.length ? this.engine.hull(points) : null;
    }
    const { vertices, corners } = this.triangles(object, matrix);
    return corners.length >= 3 ? this.engine.mesh(vertices, corners, { twoSided: true }) : null;
  }

  isFlat(points) {
    return thickness(points) <= FLAT * bounds(points).size;
  }

  /** Draw a node's mesh in place of the shape that collides.   @param number  of the body it goes with */
  draw(object, matrix, number) {
    const { vertices, corners } = this.triangles(object, matrix);
    if (corners.length < 3) return;
    this.looks.push({ body: number, mesh: this.meshes.length, position: [0, 0, 0], orientation: [0, 0, 0, 1] });
    this.meshes.push({ unit: 1, points: vertices, faces: corners });
  }

  /** Bodies and colliders as the extension says. */
  withPhysics() {
    const physics = (node) => this.json.nodes[node]?.extensions?.[PHYSICS] ?? {};
    const visit = (node, above) => {
      const object = this.objects.get(node);
      if (!object) return;
      const { motion, collider, trigger, joint } = physics(node);
      if (joint) this.note("joints are left out");
      if (trigger) this.note("triggers are left out");
      let here = above;
      if (motion) {
        const { mass = 1 } = motion;
        if (!Number.isFinite(mass) || mass < 0) throw new Error(`${this.name}: node ${node} has a mass of ${mass} kg`);
        const velocity = (v) =>
          new THREE.Vector3(...(v ?? [0, 0, 0]))
            .applyQuaternion(object.getWorldQuaternion(new THREE.Quaternion()))
            .toArray();
        here = {
          ...this.body(object, { type: motion.isKinematic ? "kinematic" : "dynamic" }, "body"),
          motion,
          object,
          parts: [],
        };
        here.velocity = [velocity(motion.linearVelocity), velocity(motion.angularVelocity)];
        this.owners.push(here);
        if (motion.inertiaDiagonal || motion.centerOfMass)
          this.note("centres of mass and inertias are those of the shapes");
        if (motion.gravityFactor !== undefined && motion.gravityFactor !== 1)
          this.world.module.call(
            "carom_body_set_gravity_factor",
            this.world.pointer,
            here.body.handle,
            motion.gravityFactor,
          );
      }
      if (collider) {
        if (collider.collisionFilter !== undefined) this.note("collision filters are left out");
        if (here) here.parts.push([object, collider]);
        else this.collider(this.body(object, { type: "static" }, "ground"), object, collider, false, 1000);
      }
      for (const child of this.json.nodes[node].children ?? []) visit(child, here);
    };
    const scene = this.json.scenes[this.json.scene ?? 0];
    for (const node of scene.nodes ?? []) visit(node, null);
    for (const { body, inverse, motion, parts, velocity } of this.owners) {
      const shapes = parts.map(([object, collider]) => this.collider({ body, inverse }, object, collider, true, 1000));
      const volume = shapes.reduce((sum, shape) => sum + (shape?.info.volume ?? 0), 0);
      if (!motion.isKinematic && motion.mass > 0 && volume > 0) this.mass(body, motion.mass);
      if (velocity.flat().some((x) => x !== 0)) body.setVelocity(...velocity);
    }
  }

  /** As heavy as that, with the inertia of its shapes. */
  mass(body, wanted) {
    const factor = wanted / body.mass;
    for (const collider of this.world.colliders().filter((c) => c.body.handle === body.handle))
      this.world.module.call(
        "carom_collider_set_density",
        this.world.pointer,
        collider.handle,
        collider.density * factor,
      );
  }

  /** A body for each mesh, its convex hull, on level ground beneath all of them. In a file with motion what moves
   *  with one node is one body, and what does not move stands. What is flat stands, too. */
  withoutPhysics() {
    const moved = new Set(
      (this.json.animations ?? []).flatMap(({ channels }) => channels.map(({ target }) => target.node)),
    );
    const moving = new Set([...moved].map((node) => this.objects.get(node)).filter(Boolean)),
      owners = new Map(), // object that moves -> its body
      level = new Map(), // height -> flat and level objects there
      all = [];
    let flat = 0;
    for (const object of this.objects.values()) {
      const points = this.points(object, new THREE.Matrix4());
      if (!points.length) continue;
      for (const x of extremes(points)) all.push(x);
      let owner = object;
      while (owner && !moving.has(owner)) owner = owner.parent;
      const isFlat = this.isFlat(points),
        stands = isFlat || (moving.size > 0 && !owner);
      const { low, high, size } = bounds(points);
      if (isFlat && high[1] - low[1] <= FLAT * size) {
        level.set(low[1], [...(level.get(low[1]) ?? []), object]);
        continue;
      }
      if (isFlat) ++flat;
      const key = stands ? object : (owner ?? object);
      if (!owners.has(key)) {
        const made = this.body(
          key,
          { type: stands ? "static" : "dynamic" },
          stands ? "ground" : key.name.replace(/[\s_.]*\d+$/, "") || "mesh",
        );
        owners.set(key, { ...made, number: this.bodies.length - 1 });
      }
      const { body, inverse, number } = owners.get(key);
      const shape = this.meshShape(object, inverse, !stands);
      if (!shape) continue;
      body.addCollider(shape, { density: 1000 });
      if (!stands) this.draw(object, inverse, number);
    }
    if (!all.length) return;
    if (!this.looks.length) throw new Error(`${this.name}: nothing in it has a volume, so nothing would move`);
    const bottom = bounds(all).low[1];
    for (const [height, objects] of level)
      for (const object of height > bottom ? objects : []) {
        const { body, inverse } = this.body(object, { type: "static" }, "ground");
        body.addCollider(this.meshShape(object, inverse, false), { density: 1000 });
        ++flat;
      }
    this.floor = level.has(bottom) ? bottom : bottom - 1e-3;
    this.world.ground({ height: this.floor, user: BigInt(this.bodies.length) });
    this.bodies.push(["ground", "ground"]);
    if (level.has(bottom)) this.note("its lowest level mesh is the ground, without end");
    this.note("it has no physics: each mesh is a body, its convex hull, on level ground");
    if (moving.size) this.note("what the file moves falls and is pushed here, all else stands");
    if (flat) this.notes.set("flat meshes have no volume, and stand", flat);
  }

  build() {
    this.objects = objectsOf(this.gltf);
    const used = this.json.extensionsUsed ?? [];
    for (const extension of this.json.extensionsRequired ?? [])
      if (!REQUIRED.test(extension)) throw new Error(`${this.name} requires ${extension}, which is not known here`);
    if (used.some((e) => e.startsWith("OMI_physics")))
      throw new Error(`${this.name} has the OMI physics extensions: carom view ${this.name} reads them`);
    if (used.includes("CAROM_physics")) this.note("what its CAROM_physics says is left out");
    if (used.includes(PHYSICS)) this.withPhysics();
    else this.withoutPhysics();
    if (!this.bodies.length) throw new Error(`${this.name} has no mesh and no body`);
    const box = new THREE.Box3().setFromObject(this.gltf.scene);
    const places = this.world.bodies().map((b) => b.position);
    for (const p of places) if (Math.max(...p.map(Math.abs)) < 1e4) box.expandByPoint(new THREE.Vector3(...p));
    const middle = box.getCenter(new THREE.Vector3()),
      far = Math.max(2, 1.6 * box.getSize(new THREE.Vector3()).length());
    const left = [...this.notes].map(([text, n]) => (n > 1 ? `${text} (${n})` : text));
    return {
      start: this.world.save({ whole: true }),
      row: {
        dt: 1 / 60,
        bodies: this.bodies,
        ground: this.floor === undefined ? 0 : 10,
        floor: this.floor,
        camera: this.camera(middle, far),
        looks: this.looks,
        meshes: this.meshes,
      },
      note: `${this.name}: ${this.bodies.length} bodies${left.length ? `; ${left.join("; ")}` : ""}${used.includes(PHYSICS) && left.length ? ". carom view reads all of it" : ""}`,
    };
  }

  /** The file's own, or one from the front and a little above. */
  camera(middle, far) {
    const [own] = this.gltf.cameras;
    if (!own)
      return {
        from: middle
          .clone()
          .add(new THREE.Vector3(0.5, 0.4, 1).multiplyScalar(far / 1.2))
          .toArray(),
        to: middle.toArray(),
      };
    const from = own.getWorldPosition(new THREE.Vector3());
    return { from: from.toArray(), to: own.getWorldDirection(new THREE.Vector3()).add(from).toArray() };
  }

  free() {
    (this.world.free(), this.engine.free());
  }
}

/** @returns { start, row, note }   @throws Error that says what is wrong with the file */
export async function sceneOf(carom, name, bytes) {
  const builder = new Builder(carom, name, await parsed(name, bytes));
  try {
    return builder.build();
  } finally {
    builder.free();
  }
}
