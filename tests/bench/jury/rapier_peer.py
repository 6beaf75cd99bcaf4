"""Runs scenes that `carom jury --write` wrote through Rapier and writes their motion for `carom jury --judge`.

beside_rapier calls it; README.md of src/tools/jury says what is in the files.

Needs the packages rapier3d and numpy. Rapier runs at its defaults, without sleep, as Carom does. What differs in the scene:
ellipsoids and double cones are hulls of some hundred points; a height field is a mesh of the same triangles; how far a ball may
swing bounds two angles, a square within the circle of the one between the axes; a motor to a speed is a damper of 1e4 / s within its force. A surface that
moves though its body stays has no counterpart but a function that is called for each contact: such scenes are left out.
"""
import array
import json
import math

import rapier3d as rapier


def icosphere(halvings):
    """Points on the unit sphere, by halving the edges of an icosahedron."""
    g = (1 + math.sqrt(5)) / 2
    points = [(s * a, t * b, 0) for s in (1, -1) for t in (1, -1) for a, b in [(1, g)]]
    points = points + [(0, x, y) for x, y, _ in points] + [(y, 0, x) for x, y, _ in points]
    edge = 2.0
    for _ in range(halvings):
        more = [tuple((p + q) / 2 for p, q in zip(a, b)) for i, a in enumerate(points) for b in points[:i]
                if math.dist(a, b) < 1.3 * edge]
        scale = math.sqrt(1 + g * g)
        more = [tuple(scale * x / math.hypot(*p) for x in p) for p in more]
        points, edge = points + more, edge / 2
    return [tuple(x / math.hypot(*p) for x in p) for p in points]


SPHERE = icosphere(2)


def ring(radius, height, n):
    return [(radius * math.cos(2 * math.pi * i / n), height, radius * math.sin(2 * math.pi * i / n)) for i in range(n)]


def triangles_of(params):
    """Vertices and triangles of a height field, divided as Carom divides it."""
    columns, rows, dx, dz = int(params[0]), int(params[1]), params[2], params[3]
    vertices = [(dx * (i % columns), h, dz * (i // columns)) for i, h in enumerate(params[4:])]
    triangles = []
    for row in range(rows - 1):
        for column in range(columns - 1):
            a = row * columns + column
            triangles += [(a, a + columns + 1, a + 1), (a, a + columns, a + columns + 1)]
    return vertices, triangles


class LeftOut(Exception):
    pass


def collider_of(body):
    c, p, kind = rapier.Collider, body["params"], body["shape"]
    if kind == "half_space":
        return c.halfspace(tuple(p[:3])).translation(tuple(p[3] * x for x in p[:3]))
    if kind == "height_field":
        return c.trimesh(*triangles_of(p))
    if kind == "sphere":
        return c.ball(p[0])
    if kind == "box":
        return c.cuboid(*p)
    if kind in ("capsule", "cylinder", "cone"):
        return {"capsule": c.capsule_y, "cylinder": c.cylinder, "cone": c.cone}[kind](p[1], p[0])
    if kind == "ellipsoid":
        return c.convex_hull([tuple(r * x for r, x in zip(p, v)) for v in SPHERE])
    if kind == "template":
        return c.convex_hull(ring(p[0], 0, 64) + [(0, p[1], 0), (0, -p[1], 0)])
    if kind == "hull":
        return c.convex_hull([tuple(p[i:i + 3]) for i in range(0, len(p), 3)])
    raise ValueError("no counterpart of shape " + kind)


def rotation(q):
    return rapier.Rotation3.from_quaternion(q[3], q[0], q[1], q[2])


def add_body(world, body, ccd):
    b = rapier.RigidBody
    builder = {"static": b.fixed, "kinematic": b.kinematic_velocity_based, "dynamic": b.dynamic}[body["type"]]()
    builder = builder.position(rapier.Isometry3(tuple(body["position"]), rotation(body["orientation"])))
    builder = builder.linvel(tuple(body["velocity"])).angvel(tuple(body["spin"])).can_sleep(False).ccd_enabled(ccd)
    collider = (collider_of(body).density(body["density"]).friction(body["friction"]).restitution(body["restitution"])
                .friction_combine_rule(rapier.CoefficientCombineRule.GEOMETRIC_MEAN)
                .restitution_combine_rule(rapier.CoefficientCombineRule.MAX))
    return world.add_body(builder, [collider])


def drive(out, axis, aim):
    """What Carom calls a motor to a speed and a spring to a place; stiffness and damping in N/m and N s/m, or by angle."""
    if aim["aim"] == "speed":
        out.set_motor(axis, 0.0, aim["goal"], 0.0, 1e4)
        out.set_motor_model(axis, rapier.MotorModel.ACCELERATION_BASED)
    else:
        out.set_motor(axis, aim["goal"], 0.0, aim["stiffness"], aim["damping"])
        out.set_motor_model(axis, rapier.MotorModel.FORCE_BASED)
    out.set_motor_max_force(axis, aim["most"])


def joint_of(joint):
    mask, kind = rapier.JointAxesMask, joint["kind"]
    locked = {"ball": mask.LOCKED_SPHERICAL_AXES, "hinge": mask.LOCKED_REVOLUTE_AXES,
              "slider": mask.LOCKED_PRISMATIC_AXES, "weld": mask.LOCKED_FIXED_AXES}[kind]
    out = rapier.GenericJoint(locked)
    out.local_frame1 = rapier.Isometry3(tuple(joint["at_a"]), rotation(joint["axes_a"]))
    out.local_frame2 = rapier.Isometry3(tuple(joint["at_b"]), rotation(joint["axes_b"]))
    out.contacts_enabled = False
    axis = rapier.JointAxis.LIN_X if kind == "slider" else rapier.JointAxis.ANG_X
    if "limit" in joint:
        out.set_limits(axis, *joint["limit"])
    if "swing" in joint:
        for across in (rapier.JointAxis.ANG_Y, rapier.JointAxis.ANG_Z):
            out.set_limits(across, -joint["swing"] / math.sqrt(2), joint["swing"] / math.sqrt(2))
    if "drive" in joint:
        drive(out, axis, joint["drive"])
    return out


ABSENT = [0.0] * 6 + [1.0] + [0.0] * 6


def state_of(body):
    t, r, v, w = body.translation, body.rotation, body.linvel, body.angvel
    return [t.x, t.y, t.z, r.i, r.j, r.k, r.w, v.x, v.y, v.z, w.x, w.y, w.z]


class Run:
    def __init__(self, scene, ccd):
        if any(any(body.get("surface", ())) for body in scene["bodies"]):
            raise LeftOut("a surface that moves though its body stays")
        self.scene, self.ccd = scene, ccd
        self.world = rapier.PhysicsWorld(gravity=(0, -scene["gravity"], 0))
        self.world.set_num_threads(1)
        self.handles = [None if body.get("late") else add_body(self.world, body, ccd) for body in scene["bodies"]]
        self.joints = [self.world.impulse_joints.insert(self.handles[j["a"]], self.handles[j["b"]], joint_of(j)) for j in scene["joints"]]
        self.world.physics_pipeline.counters.enable()
        self.out = array.array("d")
        self.note(0)

    def note(self, seconds):
        self.out.append(seconds)
        for handle in self.handles:
            self.out.extend(ABSENT if handle is None else state_of(self.world.rigid_bodies[handle]))

    def act(self, deed):
        what, who = deed["what"], deed["who"]
        if what == "drive":
            joint = self.scene["joints"][who]
            joint["drive"]["goal"] = deed["value"]
            self.world.impulse_joints.get(self.joints[who]).data = joint_of(joint)
        elif what == "add":
            body = dict(self.scene["bodies"][who], **{k: deed[k] for k in ("position", "orientation", "velocity", "spin")})
            self.handles[who] = add_body(self.world, body, self.ccd)
        elif what == "remove":
            self.world.remove_body(self.handles[who])
            self.handles[who] = None
        elif what in ("put", "throw"):
            body = self.world.rigid_bodies[self.handles[who]]
            if what == "put":
                body.position = rapier.Isometry3(tuple(deed["position"]), rotation(deed["orientation"]))
            body.linvel, body.angvel = tuple(deed["velocity"]), tuple(deed["spin"])

    def step(self, number, step):
        self.world.integration_parameters.dt = step["dt"]
        for deed in step["deeds"]:
            self.act(deed)
        for paddle in self.scene["paddles"]:
            body = self.world.rigid_bodies[self.handles[paddle["body"]]]
            body.linvel, body.angvel = tuple(paddle["velocities"][number]), tuple(paddle["spin"])
        self.world.step()
        self.note(self.world.physics_pipeline.counters.step_time_ms / 1e3)


def run(scene, ccd):
    done = Run(scene, ccd)
    for number, step in enumerate(scene["steps"]):
        done.step(number, step)
    return done.out


def simulate_file(folder, seed, ccd):
    with open(f"{folder}/{seed}.json") as file:
        scene = json.load(file)
    motion = run(scene, ccd)
    with open(f"{folder}/{seed}.motion", "wb") as file:
        motion.tofile(file)
