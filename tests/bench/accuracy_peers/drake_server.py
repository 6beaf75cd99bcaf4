"""Drake as a child process of accuracy_peers: builds and steps worlds as peer_drake.cpp asks over a socket, file 0.

    python3 drake_server.py FOLDER        (what fetch_drake.py put there)

Every message is a word of eight bytes that says what it is, one that gives its length in bytes, and doubles, or letters
where something is refused. peer_drake.cpp lists the questions and the dials.
"""
import logging
import os
import socket
import struct
import sys
import time
from importlib.metadata import version
from math import pi

for _name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ[_name] = "1"  # the comparison has one thread; to be told before numpy is loaded
sys.path.insert(0, sys.argv[1])

from drake_laws import relaxation_for, surfaces_of  # noqa: E402

import numpy as np  # noqa: E402
import pydrake  # noqa: E402, F401
from pydrake.common.value import Value  # noqa: E402
from pydrake.geometry import (AddCompliantHydroelasticProperties, AddRigidHydroelasticProperties, Box,  # noqa: E402
                              Capsule, CollisionFilterDeclaration, Cylinder, GeometrySet, HalfSpace,
                              ProximityProperties, Sphere)
from pydrake.math import RigidTransform, RotationMatrix  # noqa: E402
from pydrake.multibody.math import SpatialForce, SpatialVelocity  # noqa: E402
from pydrake.multibody.plant import (AddMultibodyPlant, CoulombFriction, ExternallyAppliedSpatialForce,  # noqa: E402
                                     MultibodyPlantConfig)
from pydrake.multibody.tree import (BallRpyJoint, FixedOffsetFrame, PrismaticJoint, PrismaticSpring,  # noqa: E402
                                    SpatialInertia, UnitInertia)
from pydrake.systems.analysis import ApplySimulatorConfig, Simulator, SimulatorConfig  # noqa: E402
from pydrake.systems.framework import DiagramBuilder  # noqa: E402
from pydrake.common.eigen_geometry import Quaternion  # noqa: E402

DIALS = ("approximation", "integrator", "accuracy", "substeps", "stiffness", "modulus", "dissipation", "relaxation",
         "threshold", "stiction", "bounce_steps", "bounce_time", "resolution")
APPROXIMATIONS = ("lagged", "similar", "sap", "tamsi")
INTEGRATORS = ("", "cenic", "implicit_euler", "radau3", "runge_kutta3", "runge_kutta5")
NONE, HALF_SPACE, SPHERE, BOX, HULL, CAPSULE, CYLINDER, CONE = range(8)
BODY_NUMBERS, JOINT_NUMBERS = 28, 22
RIGID = 1e18  # N/m, of what stands still: the pair's stiffness is the other side's (an infinite one gives NaN)


class Refused(Exception):
    """What Drake can't be asked, in words."""


def rotation(xyzw):
    q = xyzw / np.linalg.norm(xyzw)
    return RotationMatrix(Quaternion(q[3], q[0], q[1], q[2]))


class Joint:
    """A ball joint, or a slider: B slides along x of its frame, driven by a motor or pulled by a spring."""

    def __init__(self, x):
        self.ends, self.points = (int(x[0]), int(x[1])), (x[2:5], x[5:8])
        self.is_slider, self.axes = x[8] != 0, (x[9:13], x[13:17])
        self.speed, self.force, self.stiffness, self.damping, self.target = x[17:22]
        if self.force > 0:  # a force that falls to nothing at the motor's speed: Drake takes damping implicitly
            self.damping += self.force / abs(self.speed)
            self.force *= np.sign(self.speed)


class Body:
    def __init__(self, x):
        self.solid, self.params, self.is_static, self.mass = int(x[0]), x[1:5], x[5] != 0, x[6]
        self.inertia, self.kind = x[7:10], (x[10], x[11])  # friction, restitution
        self.place, self.turn, self.velocity, self.omega = x[12:15], x[15:19], x[19:22], x[22:25]
        self.start, self.shape_at = x[12:25], x[25:28]

    def pose(self):
        return RigidTransform(rotation(self.turn), self.place)


class World:
    def __init__(self, numbers):
        count, joints = int(numbers[0]), int(numbers[1])
        self.gravity = numbers[2:5]
        self.dials = dict(zip(DIALS, numbers[5:5 + len(DIALS)]))
        rest = numbers[5 + len(DIALS):]
        self.bodies = [Body(rest[BODY_NUMBERS * i:][:BODY_NUMBERS]) for i in range(count)]
        rest = rest[BODY_NUMBERS * count:]
        self.joints = [Joint(rest[JOINT_NUMBERS * i:][:JOINT_NUMBERS]) for i in range(joints)]
        self.integrator = INTEGRATORS[int(self.dials["integrator"])]
        self.approximation = APPROXIMATIONS[int(self.dials["approximation"])]
        self.surfaces = surfaces_of([b for b in self.bodies if b.solid != NONE])
        returned = {e for laws in self.surfaces.values() for (_, e), _ in laws if e > 0}
        if any(e < 1 for e in returned):
            if self.integrator:
                raise Refused("its continuous contacts have Hunt and Crossley's dissipation in place of a restitution")
            self.approximation = "sap"  # its damper is linear: the same share is left of every speed
        if any(b.solid in (HULL, CONE) for b in self.bodies):
            raise Refused("this module has no hulls and no cones")
        self.forest()
        if self.loops and (self.integrator or self.approximation == "tamsi"):
            raise Refused("joints that close a loop need the SAP solver or a tree")
        if any(joint.is_slider for joint in self.loops):
            raise Refused("this module has no slider that closes a loop")
        self.pushed = False
        self.build(1 / 60)  # so that what this Drake can't build is refused now, and not a state that was lost later

    def forest(self):
        """Joints as a forest, grown from the world: self.tree has (parent or -1, child, joint), self.loops the rest."""
        at = {}
        for joint in self.joints:
            for end in joint.ends:
                at.setdefault(end, []).append(joint)
        placed, used, self.tree = set(), set(), []

        def grow(root):
            queue = [root]
            for body in queue:
                for joint in at.get(body, ()):
                    other = joint.ends[1 if joint.ends[0] == body else 0]
                    if id(joint) in used or other < 0 or other in placed or self.bodies[other].is_static:
                        continue
                    used.add(id(joint)), placed.add(other)
                    self.tree.append((body, other, joint))
                    queue.append(other)

        grow(-1)
        for i, body in enumerate(self.bodies):
            if i not in placed and not body.is_static:
                placed.add(i)
                grow(i)
        self.loops = [joint for joint in self.joints if id(joint) not in used]

    def material(self, body, surface_law, h):
        """Contact of point pairs, and for boxes the patch of pressure that holds them by more than one point."""
        friction, restitution = surface_law
        properties = ProximityProperties()
        dials, bounces = self.dials, restitution > 0
        stiffness, dissipation, relaxation = dials["stiffness"], dials["dissipation"], dials["relaxation"]
        if bounces:
            # Stiffness goes with the mass, so that two bodies meet with that of their reduced mass: springs in series.
            steps = dials["bounce_steps"]
            rate = pi / (dials["bounce_time"] if self.integrator else steps * h)
            stiffness = RIGID if body.is_static else body.mass * rate * rate
            dissipation, relaxation = 0.0, relaxation_for(restitution, steps) * h / 2  # the pair's is the sum of both
        elif stiffness > 0 and body.is_static:
            stiffness = RIGID
        if stiffness > 0:
            properties.AddProperty("material", "point_contact_stiffness", stiffness)
        if dissipation >= 0:
            properties.AddProperty("material", "hunt_crossley_dissipation", dissipation)
        if relaxation >= 0:
            properties.AddProperty("material", "relaxation_time", relaxation)
        properties.AddProperty("material", "coulomb_friction", CoulombFriction(friction, friction))
        if dials["modulus"] > 0 and not bounces:
            if body.solid == BOX:
                AddCompliantHydroelasticProperties(1.0, dials["modulus"], properties)
            elif body.solid in (CAPSULE, CYLINDER) and dials["resolution"] > 0:  # as polyhedra of edges so long
                edge = dials["resolution"] * body.params[0]
                AddCompliantHydroelasticProperties(edge, dials["modulus"], properties)
            elif body.solid == HALF_SPACE:
                AddRigidHydroelasticProperties(properties)
        return properties

    def add_shapes(self, body, name, frame_body, pose, h):
        if body.solid == NONE:
            return
        if body.solid == HALF_SPACE:
            normal, offset = body.params[:3], body.params[3]
            pose = RigidTransform(RotationMatrix.MakeFromOneVector(normal, 2), normal * offset)
            shape = HalfSpace()
        elif body.solid == SPHERE:
            shape = Sphere(body.params[0])
        elif body.solid in (CAPSULE, CYLINDER):  # Drake's are along z
            radius, half = body.params[:2]
            shape = Capsule(radius, 2 * half) if body.solid == CAPSULE else Cylinder(radius, 2 * half)
            pose = pose @ RigidTransform(RotationMatrix.MakeXRotation(-pi / 2), body.shape_at)
        else:
            shape = Box(*(2 * body.params[:3]))
        for k, (surface_law, partner) in enumerate(self.surfaces[body.kind]):
            geometry = self.plant.RegisterCollisionGeometry(frame_body, pose, shape, f"{name}_{k}",
                                                            self.material(body, surface_law, h))
            self.groups.setdefault((body.kind, partner), []).append(geometry)

    def filter(self, scene_graph):
        manager = scene_graph.collision_filter_manager()
        groups = [(key, GeometrySet(ids)) for key, ids in self.groups.items()]
        for i, ((kind, partner), ids) in enumerate(groups):
            if partner is not None and partner != kind:
                manager.Apply(CollisionFilterDeclaration().ExcludeWithin(ids))
            for (other, others_partner), other_ids in groups[i + 1:]:
                if partner is not None and (partner != other or others_partner != kind):
                    manager.Apply(CollisionFilterDeclaration().ExcludeBetween(ids, other_ids))
        for joint in self.joints:  # what is joined does not touch
            ends = [self.of[end] for end in joint.ends if end >= 0 and not self.bodies[end].is_static]
            shapes = [g for body in ends for g in self.plant.GetCollisionGeometriesForBody(body)]
            if len(ends) == 2 and shapes:
                manager.Apply(CollisionFilterDeclaration().ExcludeWithin(GeometrySet(shapes)))

    def build(self, dt):
        """For steps of dt: a discrete plant has its step for life."""
        dials = self.dials
        self.dt = dt
        h = dt / dials["substeps"]
        config = MultibodyPlantConfig()
        config.time_step = 0.0 if self.integrator else h
        config.discrete_contact_approximation = self.approximation
        config.use_sampled_output_ports = False
        if dials["threshold"] >= 0:
            config.sap_near_rigid_threshold = dials["threshold"]
        if dials["stiction"] > 0:
            config.stiction_tolerance = dials["stiction"]
        builder = DiagramBuilder()
        self.plant, scene_graph = AddMultibodyPlant(config, builder)
        plant = self.plant
        plant.mutable_gravity_field().set_gravity_vector(self.gravity)
        self.groups, self.of, self.forces_of_motors = {}, {-1: plant.world_body()}, []
        for i, body in enumerate(self.bodies):
            if body.is_static:
                self.of[i] = plant.world_body()
                self.add_shapes(body, f"b{i}", plant.world_body(), body.pose(), h)
                continue
            inertia = UnitInertia(*(body.inertia / body.mass))
            self.of[i] = plant.AddRigidBody(f"b{i}", SpatialInertia(body.mass, np.zeros(3), inertia))
            self.add_shapes(body, f"b{i}", self.of[i], RigidTransform(), h)
        links = [(self.add_slider if link[2].is_slider else self.add_ball)(*link) for link in self.tree]
        for joint in self.loops:
            (a, on_a), (b, on_b) = self.end(joint, 0), self.end(joint, 1)
            plant.AddBallConstraint(self.of[a], on_a, self.of[b], on_b)
        self.filter(scene_graph)
        plant.Finalize()
        diagram = builder.Build()
        self.simulator = Simulator(diagram)
        if self.integrator:
            scheme = SimulatorConfig()
            scheme.integration_scheme, scheme.accuracy, scheme.max_step_size = self.integrator, dials["accuracy"], dt
            ApplySimulatorConfig(scheme, self.simulator)
        self.context = plant.GetMyMutableContextFromRoot(self.simulator.get_mutable_context())
        self.free = [i for i, b in enumerate(self.bodies) if not b.is_static and self.of[i].is_floating_base_body()]
        for i in self.free:
            body = self.bodies[i]
            plant.SetFreeBodyPose(self.context, self.of[i], body.pose())
            plant.SetFreeBodySpatialVelocity(self.context, self.of[i], SpatialVelocity(body.omega, body.velocity))
        for link, joint in zip(self.tree, links):
            self.start(link, joint)
        if plant.num_actuators():
            plant.get_actuation_input_port().FixValue(self.context, np.array(self.forces_of_motors))
        self.at_q = np.array([self.of[i].floating_positions_start() for i in self.free], dtype=int)
        self.at_v = np.array([self.of[i].floating_velocities_start_in_v() for i in self.free], dtype=int)
        self.hung = [child for _, child, _ in self.tree]
        self.forces = plant.get_applied_spatial_force_input_port()
        self.forces.FixValue(self.context, Value[list[ExternallyAppliedSpatialForce]]([]))
        self.count = 0
        self.simulator.Initialize()

    def end(self, joint, k):
        """A joint's end: body and point. A static body's is the world's."""
        i, point = joint.ends[k], joint.points[k]
        if i >= 0 and self.bodies[i].is_static:
            return -1, self.bodies[i].pose() @ point
        return i, point

    def add_ball(self, parent, child, joint):
        """Its frames have the axes of the world at the start: angles are 0 then, and a turn about z stays one angle."""
        return self.plant.AddJoint(BallRpyJoint(f"j{parent}_{child}", *self.frames(parent, child, joint)))

    def frames(self, parent, child, joint):
        """Of parent and child, at the joint, with the axes of the world at the start."""
        k = 1 if joint.ends[1] == child else 0

        def frame(i, point):
            turn = self.bodies[i].pose().rotation().inverse() if i >= 0 else RotationMatrix()
            return self.plant.AddFrame(FixedOffsetFrame(f"f{parent}_{child}_{i}", self.of[i].body_frame(),
                                                        RigidTransform(turn, point)))

        return frame(parent, self.end(joint, 1 - k)[1]), frame(child, self.end(joint, k)[1])

    def way_of(self, child, joint):
        """What a slider's child goes along where B goes along A's x; world, at the start."""
        k = 1 if joint.ends[1] == child else 0
        way = (self.bodies[child].pose().rotation() @ rotation(joint.axes[k])).matrix()[:, 0]
        return way if k == 1 else -way

    def add_slider(self, parent, child, joint):
        name = f"j{parent}_{child}"
        slider = self.plant.AddJoint(PrismaticJoint(name, *self.frames(parent, child, joint),
                                                    self.way_of(child, joint), damping=joint.damping))
        if joint.stiffness > 0:
            self.plant.AddForceElement(PrismaticSpring(slider, joint.target, joint.stiffness))
        if joint.force != 0:
            self.plant.AddJointActuator(name, slider)
            self.forces_of_motors.append(joint.force)
        return slider

    def start(self, link, made):
        """Velocities of a joint of the tree."""
        parent, child, joint = link
        body, spin, velocity = self.bodies[child], np.zeros(3), np.zeros(3)
        if parent >= 0:
            spin = self.bodies[parent].omega
            velocity = self.bodies[parent].velocity + np.cross(spin, body.place - self.bodies[parent].place)
        if joint.is_slider:
            made.set_translation_rate(self.context, self.way_of(child, joint) @ (body.velocity - velocity))
        else:
            made.set_angular_velocity(self.context, body.omega - spin)

    def step(self, dt, pushes):
        """@return  s of CPU time"""
        if dt != self.dt:
            q, v = self.plant.GetPositions(self.context), self.plant.GetVelocities(self.context)
            self.build(dt)
            self.plant.SetPositions(self.context, q), self.plant.SetVelocities(self.context, v)
        if len(pushes) or self.pushed:
            list_of = []
            for body, *force in pushes.reshape(-1, 4):
                one = ExternallyAppliedSpatialForce()
                one.body_index = self.of[int(body)].index()
                one.p_BoBq_B, one.F_Bq_W = np.zeros(3), SpatialForce(np.zeros(3), np.array(force))
                list_of.append(one)
            self.forces.FixValue(self.context, Value[list[ExternallyAppliedSpatialForce]](list_of))
            self.pushed = len(pushes) > 0
        self.count += 1
        # A discrete plant is stepped at the begin of each period: half a period before the end, all of them are done.
        until = self.count * dt - (0 if self.integrator else dt / (2 * self.dials["substeps"]))
        begun = time.thread_time_ns()
        self.simulator.AdvanceTo(until)
        return 1e-9 * (time.thread_time_ns() - begun)

    def states(self):
        """[bodies, 13] position, orientation (w last), velocity, omega"""
        found = np.array([body.start for body in self.bodies])
        if self.free:
            q, v = self.plant.GetPositions(self.context), self.plant.GetVelocities(self.context)
            span = np.arange(3)
            found[self.free, 0:3] = q[self.at_q[:, None] + 4 + span]
            found[self.free, 3:6] = q[self.at_q[:, None] + 1 + span]
            found[self.free, 6] = q[self.at_q]
            found[self.free, 7:10] = v[self.at_v[:, None] + 3 + span]
            found[self.free, 10:13] = v[self.at_v[:, None] + span]
        for i in self.hung:
            pose = self.plant.EvalBodyPoseInWorld(self.context, self.of[i])
            velocity = self.plant.EvalBodySpatialVelocityInWorld(self.context, self.of[i])
            turn = pose.rotation().ToQuaternion()
            found[i] = [*pose.translation(), turn.x(), turn.y(), turn.z(), turn.w(), *velocity.translational(),
                        *velocity.rotational()]
        return found


def serve():
    logging.getLogger("drake").setLevel(logging.ERROR)
    line = socket.socket(fileno=0)
    worlds, made = {}, 0

    def receive(size):
        data = b""
        while len(data) < size:
            more = line.recv(size - len(data))
            if not more:
                sys.exit()
            data += more
        return data

    def answer(kind, data):
        line.sendall(struct.pack("=qq", kind, len(data)) + data)

    answer(0, np.array([float(part) for part in version("drake").split(".")[:3]]).tobytes())
    while True:
        kind, size = struct.unpack("=qq", receive(16))
        numbers = np.frombuffer(receive(size))
        try:
            if kind == 0:  # build
                worlds[made] = World(numbers)
                made += 1
                answer(0, np.array([made - 1.0]).tobytes())
            elif kind == 1:  # step: which world, dt, pushes of four numbers each
                world = worlds[int(numbers[0])]
                seconds = world.step(numbers[1], numbers[2:])
                answer(0, np.append(seconds, world.states()).tobytes())
            else:  # forget
                worlds.pop(int(numbers[0]), None)
                answer(0, b"")
        except Exception as error:  # Drake's own, of a state it can't go on from, or ours: told in words
            answer(1, str(error).encode())


if __name__ == "__main__":
    serve()
