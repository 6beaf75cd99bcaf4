"""Runs scenes that `carom jury --write` wrote through Rapier and writes their motion for `carom jury --judge`.

beside_rapier calls it; README.md of src/tools/jury says what is in the files.

Needs the packages rapier3d and numpy. Rapier runs at its defaults, without sleep, as Carom does. What differs in the scene:
ellipsoids and double cones are hulls of some hundred points; a height field is a mesh of the same triangles.
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


def joint_of(joint):
    mask, kind = rapier.JointAxesMask, joint["kind"]
    locked = {"ball": mask.LOCKED_SPHERICAL_AXES, "hinge": mask.LOCKED_REVOLUTE_AXES,
              "slider": mask.LOCKED_PRISMATIC_AXES, "weld": mask.LOCKED_FIXED_AXES}[kind]
    out = rapier.GenericJoint(locked)
    out.local_frame1 = rapier.Isometry3(tuple(joint["at_a"]), rotation(joint["axes_a"]))
    out.local_frame2 = rapier.Isometry3(tuple(joint["at_b"]), rotation(joint["axes_b"]))
    out.contacts_enabled = False
    if "limit" in joint:
        axis = rapier.JointAxis.LIN_X if kind == "slider" else rapier.JointAxis.ANG_X
        out.set_limits(axis, *joint["limit"])
    return out


def state_of(body):
    t, r, v, w = body.translation, body.rotation, body.linvel, body.angvel
    return [t.x, t.y, t.z, r.i, r.j, r.k, r.w, v.x, v.y, v.z, w.x, w.y, w.z]


def run(scene, ccd):
    world = rapier.PhysicsWorld(gravity=(0, -scene["gravity"], 0))
    world.integration_parameters.dt = scene["dt"]
    world.set_num_threads(1)
    handles = [add_body(world, body, ccd) for body in scene["bodies"]]
    for joint in scene["joints"]:
        world.impulse_joints.insert(handles[joint["a"]], handles[joint["b"]], joint_of(joint))
    world.physics_pipeline.counters.enable()
    out = array.array("d", [0])
    for handle in handles:
        out.extend(state_of(world.rigid_bodies[handle]))
    for step in range(scene["steps"]):
        for paddle in scene["paddles"]:
            body = world.rigid_bodies[handles[paddle["body"]]]
            body.linvel, body.angvel = tuple(paddle["velocities"][step]), tuple(paddle["spin"])
        world.step()
        out.append(world.physics_pipeline.counters.step_time_ms / 1e3)
        for handle in handles:
            out.extend(state_of(world.rigid_bodies[handle]))
    return out


def simulate_file(folder, seed, ccd):
    with open(f"{folder}/{seed}.json") as file:
        scene = json.load(file)
    with open(f"{folder}/{seed}.motion", "wb") as file:
        run(scene, ccd).tofile(file)
