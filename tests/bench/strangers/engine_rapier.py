"""Rapier by its Python package, at its defaults: one step a frame, of 4 iterations. Meshes mend their inner edges.

Where a scene is fast, bodies look ahead (`soft_ccd_prediction`): with `ccd_enabled` more of them leave the cups. Its length_unit
stays at 1: set to the size of small things, more of them fall through.
"""
from importlib import metadata

import numpy as np
import rapier3d as rapier

from scene import FRAME, Clock


def version():
    return metadata.version("rapier3d")


def shape_of(shape):
    c, (word, *n) = rapier.Collider, shape
    if word == "plane":
        return c.halfspace((0, 1, 0))
    if word == "field":
        rows, spacing = n
        return c.heightfield(np.array(rows, float), (spacing * (len(rows[0]) - 1), 1, spacing * (len(rows) - 1)))
    if word == "mesh":
        return c.trimesh(n[0], n[1], rapier.TriMeshFlags.FIX_INTERNAL_EDGES)
    if word == "box":
        return c.cuboid(*n)
    if word == "sphere":
        return c.ball(n[0])
    if word == "hull":
        return c.convex_hull(n[0])
    return {"cylinder": c.cylinder, "capsule": c.capsule_y}[word](n[1], n[0])


def iso(position, q):
    return rapier.Isometry3(tuple(position), rapier.Rotation3.from_quaternion(q[3], q[0], q[1], q[2]))


class World:
    def __init__(self, scene):
        self.world, self.clock, self.scene, self.time = rapier.PhysicsWorld(gravity=(0, -scene.gravity, 0)), Clock(), scene, 0.0
        self.world.integration_parameters.dt = FRAME
        self.world.set_num_threads(1)
        self.handles = [self.add(body) for body in scene.bodies]
        for hinge in scene.hinges:
            self.add_hinge(hinge)
        self.driven = [(h, body.drive) for h, body in zip(self.handles, scene.bodies) if body.drive]
        self.world.update_query_pipeline()

    def add(self, body):
        builder = {"static": rapier.RigidBody.fixed, "kinematic": rapier.RigidBody.kinematic_velocity_based,
                   "dynamic": rapier.RigidBody.dynamic}[body.kind]()
        builder = builder.position(iso(body.position, body.orientation)).linvel(body.velocity).angvel(body.spin)
        builder = builder.can_sleep(False)
        if self.scene.sweeps and body.kind == "dynamic":
            builder = builder.soft_ccd_prediction(self.scene.sweeps)
        return self.world.add_body(builder, [
            shape_of(shape).position(iso(position, orientation)).density(body.density).friction(self.scene.friction)
            .restitution(self.scene.restitution) for shape, position, orientation in body.pieces()])

    def add_hinge(self, hinge):
        b = self.scene.bodies[hinge.b]
        if hinge.a is None:
            holder, origin = self.world.add_body(rapier.RigidBody.fixed(), []), (0, 0, 0)
        else:
            holder, origin = self.handles[hinge.a], self.scene.bodies[hinge.a].position
        joint = rapier.RevoluteJoint(tuple(hinge.axis))
        joint.local_anchor1 = tuple(p - o for p, o in zip(hinge.at, origin))
        frame = iso(b.position, b.orientation)
        joint.local_anchor2 = tuple(frame.inverse() * rapier.Point3(*hinge.at))
        general = joint.data
        general.local_axis2 = tuple(frame.rotation.inverse() * rapier.Vec3(*hinge.axis))
        general.contacts_enabled = False
        if hinge.lower is not None:
            general.set_limits(rapier.JointAxis.ANG_X, hinge.lower, hinge.upper)
        self.world.impulse_joints.insert(holder, self.handles[hinge.b], general)

    def step(self):
        bodies = self.world.rigid_bodies
        for handle, drive in self.driven:
            bodies[handle].linvel = drive(self.time)
        for hinge in self.scene.hinges:
            if hinge.torque:
                push = [hinge.torque * x for x in hinge.axis]
                for handle, sign in [(self.handles[hinge.b], 1)] + ([(self.handles[hinge.a], -1)] if hinge.a is not None else []):
                    bodies[handle].reset_torques()
                    bodies[handle].add_torque(tuple(sign * x for x in push))
        with self.clock:
            self.world.step()
        self.time += FRAME

    def pose(self, i):
        body = self.world.rigid_bodies[self.handles[i]]
        t, r = body.translation, body.rotation
        return (t.x, t.y, t.z), (r.i, r.j, r.k, r.w)

    def velocity(self, i):
        body = self.world.rigid_bodies[self.handles[i]]
        v, w = body.linvel, body.angvel
        return (v.x, v.y, v.z), (w.x, w.y, w.z)

    def rays(self, origins, directions, far):
        rays, ask = [rapier.Ray(o, d) for o, d in zip(origins, directions)], self.world.query_pipeline.cast_ray
        with self.clock:
            hits = [ask(ray, far, True) for ray in rays]
        return [None if hit is None else hit[1] for hit in hits]

    def close(self):
        pass
