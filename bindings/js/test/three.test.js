// carom/three: meshes of three.js with bodies, as its own physics addons do it. Wants three: npm install.
import { strict as assert } from "node:assert";
import { test } from "node:test";
import { load } from "../src/index.js";
import { CaromPhysics, Physics } from "../src/three.js";

const THREE = await import("three").catch(() => null);
const skip = !THREE && "three is not installed: npm install";
const carom = await load();

function box(x, y, z, mass) {
  const mesh = new THREE.Mesh(new THREE.BoxGeometry(1, 1, 1));
  mesh.position.set(x, y, z);
  if (mass !== undefined) mesh.userData.physics = { mass };
  return mesh;
}
function ground() {
  const mesh = new THREE.Mesh(new THREE.BoxGeometry(20, 1, 20));
  mesh.position.y = -0.5;
  mesh.userData.physics = { mass: 0 };
  return mesh;
}
const pass = (physics, steps) => {
  for (let i = 0; i < steps; ++i) physics.step();
};

test("a scene's meshes fall and lie, the others stay", { skip }, () => {
  const physics = new Physics(carom),
    scene = new THREE.Scene();
  const falls = box(0, 3, 0, 2),
    plain = box(5, 3, 0);
  scene.add(ground(), falls, plain);
  physics.addScene(scene);
  assert.equal(physics.world.bodyCount(), 2);
  assert.ok(Math.abs(physics.meshes.get(falls)[0].mass - 2) < 1e-12, "the mass that was asked for");
  pass(physics, 120);
  assert.ok(Math.abs(falls.position.y - 0.5) < 2e-3);
  assert.equal(plain.position.y, 3);
  physics.dispose();
});

test("parents and scales are in the shape and the pose", { skip }, () => {
  const physics = new Physics(carom),
    scene = new THREE.Scene(),
    group = new THREE.Group();
  group.position.set(1, 2, 3);
  group.rotation.y = Math.PI / 2;
  group.scale.setScalar(2);
  const mesh = box(0, 1, 0);
  group.add(mesh);
  scene.add(group, ground());
  physics.addScene(scene);
  const body = physics.addMesh(mesh, 8);
  assert.deepEqual(
    physics.shapes.get(mesh.geometry)[0].shape.params.map((x) => +x.toFixed(12)),
    [1, 1, 1],
  );
  assert.ok(Math.abs(body.position[1] - 4) < 1e-12);
  pass(physics, 180);
  const world = mesh.getWorldPosition(new THREE.Vector3());
  assert.ok(world.distanceTo(new THREE.Vector3(1, 1, 3)) < 1e-2, `${world.toArray()}`);
  assert.ok(mesh.getWorldScale(new THREE.Vector3()).distanceTo(new THREE.Vector3(2, 2, 2)) < 1e-5);
  physics.dispose();
});

test("instances: a body each, poses in the instances", { skip }, () => {
  const physics = new Physics(carom),
    n = 20,
    mesh = new THREE.InstancedMesh(new THREE.SphereGeometry(0.5), undefined, n);
  for (let i = 0; i < n; ++i) mesh.setMatrixAt(i, new THREE.Matrix4().makeTranslation(2 * i, 2, 0));
  const bodies = physics.addMesh(mesh, 1);
  assert.equal(bodies.length, n);
  physics.addMesh(Object.assign(new THREE.Mesh(new THREE.BoxGeometry(100, 1, 10)), {}), 0);
  physics.setMeshPosition(mesh, new THREE.Vector3(-4, 8, 0), 3);
  physics.setMeshVelocity(mesh, new THREE.Vector3(0, 0, 1), 4);
  pass(physics, 10);
  const at = (i) => {
    const matrix = new THREE.Matrix4();
    mesh.getMatrixAt(i, matrix);
    return new THREE.Vector3().setFromMatrixPosition(matrix);
  };
  assert.ok(at(3).x === -4 && at(3).y > 7 && at(3).y < 8);
  assert.ok(at(4).z > 0.16 && at(4).z < 0.17);
  assert.ok(at(0).y < 2 && at(0).y > 1.8);
  physics.removeMesh(mesh);
  assert.equal(physics.world.bodyCount(), 1);
  pass(physics, 3);
  physics.dispose();
});

test("every geometry has the shape that it looks like", { skip }, () => {
  const physics = new Physics(carom);
  const kinds = [
    [new THREE.BoxGeometry(1, 2, 3), [1, 1, 1], "carom.box", 6],
    [new THREE.SphereGeometry(0.5), [1, 1, 1], "carom.sphere", Math.PI / 6],
    [new THREE.SphereGeometry(0.5), [1, 2, 1], "carom.ellipsoid", Math.PI / 3],
    [new THREE.SphereGeometry(0.5, 32, 32, 0, Math.PI), [1, 1, 1], "carom.hull", Math.PI / 12],
    [new THREE.CapsuleGeometry(0.5, 1), [1, 1, 1], "carom.capsule", Math.PI / 6 + Math.PI / 4],
    [new THREE.CylinderGeometry(0.5, 0.5, 2), [1, 1, 1], "carom.cylinder", Math.PI / 2],
    [new THREE.CylinderGeometry(0.2, 0.5, 2, 64), [1, 1, 1], "carom.hull", (Math.PI * 2 * (0.04 + 0.1 + 0.25)) / 3],
    [new THREE.ConeGeometry(0.5, 2), [2, 1, 2], "carom.cone", (Math.PI * 2) / 3],
    [
      new THREE.IcosahedronGeometry(1),
      [1, 1, 1],
      "carom.hull",
      (5 * (3 + Math.sqrt(5)) * 1.0514622242382672 ** 3) / 12,
    ],
    [new THREE.TorusKnotGeometry(1, 0.3), [1, 1, 1], "carom.hull", null],
  ];
  for (const [geometry, scale, kind, volume] of kinds) {
    const mesh = new THREE.Mesh(geometry);
    mesh.scale.set(...scale);
    const body = physics.addMesh(mesh, 3);
    const { shape } = physics.shapes.get(geometry).at(-1);
    assert.equal(shape.info.kind, kind, geometry.type);
    // What is round in the picture is made of flat pieces: hulls of it are smaller.
    if (volume)
      assert.ok(Math.abs(shape.info.volume / volume - 1) < 0.02, `${geometry.type}: ${shape.info.volume}, ${volume}`);
    assert.ok(Math.abs(body.mass - 3) < 1e-12);
    physics.removeMesh(mesh);
  }
  const still = new THREE.Mesh(new THREE.TorusKnotGeometry(1, 0.3));
  physics.addMesh(still);
  assert.equal(
    physics.shapes.get(still.geometry)[0].shape.info.kind,
    "scenery",
    "what does not move keeps its hollows",
  );
  physics.dispose();
});

test("what is wrong is told, and nothing is added", { skip }, () => {
  const physics = new Physics(carom),
    mesh = box(0, 0, 0);
  physics.addMesh(mesh, 1);
  assert.throws(() => physics.addMesh(mesh, 1), /removeMesh/);
  assert.throws(() => physics.setMeshPosition(box(0, 0, 0), new THREE.Vector3()), /addMesh/);
  assert.throws(() => physics.setMeshPosition(mesh, new THREE.Vector3(NaN, 0, 0)), /what to do|finite|number/i);
  const odd = new THREE.Mesh(new THREE.CapsuleGeometry(1, 1));
  odd.scale.set(1, 2, 1);
  assert.throws(() => physics.addMesh(odd, 1), /evenly/);
  const flat = new THREE.Mesh(new THREE.PlaneGeometry(1, 1));
  assert.throws(() => physics.addMesh(flat, 1));
  assert.equal(physics.world.bodyCount(), 1);
  physics.dispose();
});

test("time passes by itself, and in steps when it is asked to", { skip }, async () => {
  const physics = await CaromPhysics();
  const mesh = box(0, 5, 0);
  physics.addMesh(mesh, 1);
  await new Promise((ready) => setTimeout(ready, 200));
  assert.ok(mesh.position.y < 5);
  physics.dispose();
  const still = await CaromPhysics({ running: false, dt: 0.01 });
  still.addMesh(box(0, 5, 0), 1);
  assert.equal(still.update(0.035), 3);
  assert.equal(still.update(0.0051), 1);
  assert.equal(still.update(100), 5, "a pause is not made up for");
  still.dispose();
});
