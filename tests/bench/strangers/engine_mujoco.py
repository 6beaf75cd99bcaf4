"""MuJoCo by its Python package, at its defaults: steps of 1/480 s (its own are 2 ms), eight a frame.

It has no kinematic bodies that carry others along: they are heavy bodies without weight that are put where they belong in each
frame. Its meshes collide as convex hulls: chunks of a flat mesh get a bottom, and hollow meshes are for rays alone. It knows no
restitution. A hinge is a coordinate of its own.
"""
import mujoco
import numpy as np

from scene import FRAME, UPRIGHT, Clock, Path, closed_below, conjugate, product, turned

SUBSTEPS = 8
HEAVY = 1e6  # kg
UP = "0.70710678118654757 -0.70710678118654757 0 0"  # w first: its z is our y


def version():
    return mujoco.__version__


def text(*numbers):
    return " ".join(repr(float(x)) for x in numbers)


def wxyz(q):
    return text(q[3], q[0], q[1], q[2])


class Writer:
    """A model as its XML."""

    def __init__(self, scene):
        self.scene, self.assets, self.names = scene, [], {}
        held = {hinge.b for hinge in scene.hinges}
        bodies = "".join(self.body(i) for i in range(len(scene.bodies)) if i not in held)
        bodies += "".join(self.body(hinge.b, hinge) for hinge in scene.hinges if hinge.a is None)
        self.xml = (f'<mujoco><compiler angle="radian" balanceinertia="true"/><option timestep="{FRAME / SUBSTEPS!r}" '
                    f'gravity="0 {-scene.gravity!r} 0"/><size memory="64M"/><asset>{"".join(self.assets)}</asset>'
                    f'<worldbody>{bodies}</worldbody></mujoco>')

    def asset(self, shape, static):
        if id(shape) not in self.names:
            name = self.names[id(shape)] = f"m{len(self.names)}"
            word, *n = shape
            if word == "field":
                rows, spacing = n
                low = min(map(min, rows))
                high = max(max(map(max, rows)) - low, 1e-3)
                heights = text(*((h - low) / high for row in rows for h in row))  # the first row is at the far end, our -z
                self.assets.append(f'<hfield name="{name}" nrow="{len(rows)}" ncol="{len(rows[0])}" elevation="{heights}" size="'
                                   f'{text(spacing * (len(rows[0]) - 1) / 2, spacing * (len(rows) - 1) / 2, high, 0.5)}"/>')
            elif word == "mesh":
                flat = len({y for _, y, _ in n[0]}) == 1
                if flat and not self.scene.hollow:
                    self.assets.append(f'<mesh name="{name}" vertex="{text(*(x for p in closed_below(n[0], 0.5) for x in p))}"/>')
                else:
                    self.assets.append(f'<mesh name="{name}" inertia="shell" vertex="{text(*(x for p in n[0] for x in p))}" '
                                       f'face="{" ".join(str(k) for t in n[1] for k in t)}"/>')
            else:
                self.assets.append(f'<mesh name="{name}" vertex="{text(*(x for p in n[0] for x in p))}"/>')
        return self.names[id(shape)]

    def geom(self, piece, body):
        (word, *n), position, q = piece
        about = f'friction="{self.scene.friction!r} 0 0" condim="{3 if self.scene.friction else 1}"'
        if self.scene.hollow:
            about += ' contype="0" conaffinity="0"'
        if body.kind == "kinematic":
            about += f' mass="{HEAVY / len(body.pieces())!r}"'
        elif body.kind == "dynamic":
            about += f' density="{body.density!r}"'
        if word in ("plane", "field", "cylinder", "capsule"):  # z is their axis
            q = product(q, (-0.5 ** 0.5, 0.0, 0.0, 0.5 ** 0.5))
        if word == "field":
            position = (position[0], position[1] + min(map(min, n[0])), position[2])
        place = f'pos="{text(*position)}" quat="{wxyz(q)}" {about}'
        if word in ("hull", "mesh", "field"):
            kind = "hfield" if word == "field" else "mesh"
            return f'<geom type="{kind}" {kind}="{self.asset(piece[0], True)}" {place}/>'
        size = (0, 0, 1) if word == "plane" else n
        return f'<geom type="{word}" size="{text(*size)}" {place}/>'

    def body(self, i, hinge=None):
        body = self.scene.bodies[i]
        position, q, inner = body.position, body.orientation, ""
        if hinge is None:
            inner = "" if body.kind == "static" else f'<freejoint name="j{i}"/>'
        else:
            if hinge.a is not None:
                position = tuple(p - o for p, o in zip(position, self.scene.bodies[hinge.a].position))
            at = turned(conjugate(q), tuple(p - o for p, o in zip(hinge.at, body.position)))
            limits = "" if hinge.lower is None else f'limited="true" range="{text(hinge.lower, hinge.upper)}"'
            inner = f'<joint name="j{i}" type="hinge" pos="{text(*at)}" axis="{text(*turned(conjugate(q), hinge.axis))}" {limits}/>'
        inner += "".join(self.geom(piece, body) for piece in body.pieces())
        inner += "".join(self.body(h.b, h) for h in self.scene.hinges if h.a == i)
        return (f'<body name="b{i}" pos="{text(*position)}" quat="{wxyz(q)}" gravcomp="{int(body.kind == "kinematic")}">{inner}</body>')


class World:
    def __init__(self, scene):
        self.scene, self.clock, self.time = scene, Clock(), 0.0
        self.model = mujoco.MjModel.from_xml_string(Writer(scene).xml)
        self.data = mujoco.MjData(self.model)
        self.ids = [mujoco.mj_name2id(self.model, mujoco.mjtObj.mjOBJ_BODY, f"b{i}") for i in range(len(scene.bodies))]
        hung = {hinge.b: hinge for hinge in scene.hinges}
        self.paths = {}
        for i, body in enumerate(scene.bodies):
            if body.kind == "kinematic":
                self.paths[i] = Path(body)
            if i in hung:
                rest = (0, 0, 0) if hung[i].a is None else scene.bodies[hung[i].a].spin
                self.data.qvel[self.dof(i)] = sum(x * (w - r) for x, w, r in zip(hung[i].axis, body.spin, rest))
            elif body.kind != "static":
                self.put(i, body.position, body.orientation, body.velocity, body.spin)
        mujoco.mj_forward(self.model, self.data)

    def dof(self, i):
        return self.model.joint(f"j{i}").dofadr[0]

    def put(self, i, position, q, velocity, spin):
        at, dof = self.model.joint(f"j{i}").qposadr[0], self.dof(i)
        self.data.qpos[at:at + 7] = (*position, q[3], q[0], q[1], q[2])
        self.data.qvel[dof:dof + 6] = (*velocity, *turned(conjugate(q), spin))

    def step(self):
        for i, path in self.paths.items():
            if self.scene.bodies[i].drive:
                path.velocity = self.scene.bodies[i].drive(self.time)
            self.put(i, path.position, path.orientation, path.velocity, path.spin)
            path.go()
        for hinge in self.scene.hinges:
            self.data.qfrc_applied[self.dof(hinge.b)] = hinge.torque
        with self.clock:
            mujoco.mj_step(self.model, self.data, SUBSTEPS)
        self.time += FRAME
        mujoco.mj_kinematics(self.model, self.data)
        mujoco.mj_comPos(self.model, self.data)
        mujoco.mj_comVel(self.model, self.data)

    def pose(self, i):
        w, x, y, z = self.data.xquat[self.ids[i]]
        return tuple(self.data.xpos[self.ids[i]]), (x, y, z, w)

    def velocity(self, i):
        out = np.zeros(6)
        mujoco.mj_objectVelocity(self.model, self.data, mujoco.mjtObj.mjOBJ_BODY, self.ids[i], out, 0)
        return tuple(out[3:]), tuple(out[:3])

    def rays(self, origins, directions, far):
        geom, origins, directions = np.zeros(1, np.int32), np.array(origins), np.array(directions)
        with self.clock:
            ways = [mujoco.mj_ray(self.model, self.data, o, d, None, 1, -1, geom) for o, d in zip(origins, directions)]
        return [None if way < 0 or way > far else way for way in ways]

    def close(self):
        pass
