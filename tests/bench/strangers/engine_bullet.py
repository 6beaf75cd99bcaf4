"""Bullet by the Python package pybullet (double precision), at its defaults: steps of 1/240 s, four a frame; no damping.

It has no kinematic bodies that carry others along: they are heavy bodies without weight that are put where they belong in each
frame. What hangs on a hinge is a link of a tree. Meshes and fields have their inner edges mended as far as the package can.
"""
from importlib import metadata

import pybullet as bullet

from scene import FRAME, UPRIGHT, Clock, Path, conjugate, product, triangles_of, turned

SUBSTEPS = 4
HEAVY = 1e6  # kg


def version():
    return metadata.version("pybullet")


def volume_of(shape):
    word, *n = shape
    pi = 3.141592653589793
    if word == "box":
        return 8 * n[0] * n[1] * n[2]
    if word == "sphere":
        return 4 / 3 * pi * n[0] ** 3
    if word == "cylinder":
        return 2 * pi * n[0] ** 2 * n[1]
    if word == "capsule":
        return 2 * pi * n[0] ** 2 * n[1] + 4 / 3 * pi * n[0] ** 3
    import engine_carom
    return engine_carom.shape_of(shape)[0].info.volume


class World:
    def __init__(self, scene):
        self.scene, self.clock, self.time, self.shapes = scene, Clock(), 0.0, {}
        self.client = bullet.connect(bullet.DIRECT)
        self.to = {"physicsClientId": self.client}
        bullet.setGravity(0, -scene.gravity, 0, **self.to)
        self.place, self.paths = [None] * len(scene.bodies), {}  # (body, link)
        held = {hinge.b for hinge in scene.hinges if hinge.a is not None}
        for i, body in enumerate(scene.bodies):
            if i not in held:
                self.add(i, body)
        for i, (body, link) in enumerate(self.place):
            bullet.changeDynamics(body, link, lateralFriction=scene.friction ** 0.5, restitution=scene.restitution ** 0.5, linearDamping=0,
                                  angularDamping=0, jointDamping=0, **self.to)
            if scene.sweeps and scene.bodies[i].kind == "dynamic":
                bullet.changeDynamics(body, link, ccdSweptSphereRadius=0.5 * scene.size, **self.to)
        for hinge in scene.hinges:
            body, link = self.place[hinge.b]
            bullet.setJointMotorControl2(body, link, bullet.VELOCITY_CONTROL, force=0, **self.to)
            rest = (0, 0, 0) if hinge.a is None else scene.bodies[hinge.a].spin
            rate = sum(x * (w - r) for x, w, r in zip(hinge.axis, scene.bodies[hinge.b].spin, rest))
            bullet.resetJointState(body, link, 0, rate, **self.to)
            if hinge.lower is not None:
                bullet.changeDynamics(body, link, jointLowerLimit=hinge.lower, jointUpperLimit=hinge.upper, jointLimitForce=1e9, **self.to)

    def shape(self, pieces):
        key = tuple(id(piece[0]) for piece in pieces) + tuple(piece[1:] for piece in pieces)
        if key not in self.shapes:
            self.shapes[key] = self.make(pieces)
        return self.shapes[key]

    def make(self, pieces):
        if len(pieces) > 1:
            words = {"box": bullet.GEOM_BOX}
            return bullet.createCollisionShapeArray(
                shapeTypes=[words[shape[0]] for shape, _, _ in pieces], halfExtents=[shape[1:] for shape, _, _ in pieces],
                collisionFramePositions=[p for _, p, _ in pieces], collisionFrameOrientations=[q for _, _, q in pieces], **self.to)
        (word, *n), position, q = pieces[0]
        if word in ("cylinder", "capsule"):  # z is their axis
            q = product(q, (-0.5 ** 0.5, 0.0, 0.0, 0.5 ** 0.5))
        frame = {"collisionFramePosition": position, "collisionFrameOrientation": q, **self.to}
        if word == "plane":
            return bullet.createCollisionShape(bullet.GEOM_PLANE, planeNormal=(0, 1, 0), **frame)
        if word == "box":
            return bullet.createCollisionShape(bullet.GEOM_BOX, halfExtents=n, **frame)
        if word == "sphere":
            return bullet.createCollisionShape(bullet.GEOM_SPHERE, radius=n[0], **frame)
        if word in ("cylinder", "capsule"):
            kind = bullet.GEOM_CYLINDER if word == "cylinder" else bullet.GEOM_CAPSULE
            return bullet.createCollisionShape(kind, radius=n[0], height=2 * n[1], **frame)
        if word == "hull":
            return bullet.createCollisionShape(bullet.GEOM_MESH, vertices=n[0], **frame)
        vertices, triangles = triangles_of(*n) if word == "field" else n
        return bullet.createCollisionShape(bullet.GEOM_MESH, vertices=vertices, indices=[k for t in triangles for k in t],
                                           flags=bullet.GEOM_FORCE_CONCAVE_TRIMESH | bullet.GEOM_CONCAVE_INTERNAL_EDGE, **frame)

    def mass(self, body):
        if body.kind == "static":
            return 0
        return HEAVY if body.kind == "kinematic" else body.density * sum(volume_of(shape) for shape, _, _ in body.pieces())

    def add(self, i, body):
        on_it = [h for h in self.scene.hinges if h.a == i]
        to_world = next((h for h in self.scene.hinges if h.b == i and h.a is None), None)
        links, base = ([(to_world, i)], None) if to_world else ([(h, h.b) for h in on_it], body)
        origin = to_world.at if to_world else body.position
        about = {}
        if links:
            hung = [self.scene.bodies[k] for _, k in links]
            about = {
                "linkMasses": [self.mass(b) for b in hung], "linkCollisionShapeIndices": [self.shape(b.pieces()) for b in hung],
                "linkVisualShapeIndices": [-1] * len(links),
                "linkPositions": [tuple(p - o for p, o in zip(h.at, origin)) for h, _ in links],  # of the hinges
                "linkOrientations": [b.orientation for b in hung],
                "linkInertialFramePositions": [turned(conjugate(b.orientation), tuple(p - o for p, o in zip(b.position, h.at)))
                                               for (h, _), b in zip(links, hung)],
                "linkInertialFrameOrientations": [UPRIGHT] * len(links), "linkParentIndices": [0] * len(links),
                "linkJointTypes": [bullet.JOINT_REVOLUTE] * len(links),
                "linkJointAxis": [turned(conjugate(b.orientation), h.axis) for (h, _), b in zip(links, hung)]}
            # shapes are placed from the hinge
            about["linkCollisionShapeIndices"] = [self.make([(shape, at, q)]) for b, at, (shape, _, q) in zip(
                hung, about["linkInertialFramePositions"], [b.pieces()[0] for b in hung])]
        made = bullet.createMultiBody(baseMass=0 if base is None else self.mass(body),
                                      baseCollisionShapeIndex=-1 if base is None else self.shape(body.pieces()),
                                      basePosition=origin, baseOrientation=UPRIGHT if base is None else body.orientation, **about, **self.to)
        if base is not None:
            self.place[i] = (made, -1)
            if body.kind != "static":
                bullet.resetBaseVelocity(made, body.velocity, body.spin, **self.to)
            if body.kind == "kinematic":
                self.paths[i] = Path(body)
        for k, (_, b) in enumerate(links):
            self.place[b] = (made, k)

    def step(self):
        for i, path in self.paths.items():
            if self.scene.bodies[i].drive:
                path.velocity = self.scene.bodies[i].drive(self.time)
            bullet.resetBasePositionAndOrientation(self.place[i][0], path.position, path.orientation, **self.to)
            bullet.resetBaseVelocity(self.place[i][0], path.velocity, path.spin, **self.to)
            path.go()
        loads = [(*self.place[h.b], h.torque) for h in self.scene.hinges if h.torque]
        with self.clock:
            for _ in range(SUBSTEPS):
                for i in self.paths:
                    bullet.applyExternalForce(self.place[i][0], -1, (0, HEAVY * self.scene.gravity, 0), bullet.getBasePositionAndOrientation(
                        self.place[i][0], **self.to)[0], bullet.WORLD_FRAME, **self.to)
                for body, link, torque in loads:
                    bullet.setJointMotorControl2(body, link, bullet.TORQUE_CONTROL, force=torque, **self.to)
                bullet.stepSimulation(**self.to)
        self.time += FRAME

    def pose(self, i):
        body, link = self.place[i]
        if link < 0:
            return bullet.getBasePositionAndOrientation(body, **self.to)
        return bullet.getLinkState(body, link, computeForwardKinematics=1, **self.to)[:2]

    def velocity(self, i):
        body, link = self.place[i]
        if link < 0:
            return bullet.getBaseVelocity(body, **self.to)
        return bullet.getLinkState(body, link, computeLinkVelocity=1, computeForwardKinematics=1, **self.to)[6:8]

    def rays(self, origins, directions, far):
        ends = [tuple(p + far * x for p, x in zip(o, d)) for o, d in zip(origins, directions)]
        with self.clock:
            hits = bullet.rayTestBatch(origins, ends, numThreads=1, **self.to)
        return [None if hit[0] < 0 else hit[2] * far for hit in hits]

    def close(self):
        bullet.disconnect(**self.to)
