"""A scene in words that every engine understands: SI units, y up, orientations x, y, z, w."""
import math
import time
from dataclasses import dataclass
from typing import Callable, Optional

FRAME = 1 / 60  # s: what an adapter's step() covers
UPRIGHT = (0.0, 0.0, 0.0, 1.0)

# Shapes are tuples of a word and numbers in m, and centred, as Bullet wants them:
#   ("box", x, y, z) half extents; ("sphere", r); ("cylinder", r, half height), ("capsule", r, half height of its segment), axis y;
#   ("hull", points); ("mesh", vertices, triangles); ("field", rows of heights along z, spacing); ("plane",) everything below y = 0


@dataclass
class Body:
    shape: Optional[tuple] = None
    position: tuple = (0.0, 0.0, 0.0)
    kind: str = "dynamic"  # "static", "kinematic"
    orientation: tuple = UPRIGHT
    velocity: tuple = (0.0, 0.0, 0.0)  # m/s, of the centre of mass
    spin: tuple = (0.0, 0.0, 0.0)  # rad/s
    density: float = 1000.0  # kg/m^3
    parts: tuple = ()  # in place of shape: (shape, position, orientation) in the body's frame
    drive: Optional[Callable] = None  # of a kinematic body: time, s -> velocity for the frame that begins then

    def pieces(self):
        return self.parts or ((self.shape, (0.0, 0.0, 0.0), UPRIGHT),)


@dataclass
class Hinge:
    a: Optional[int]  # index of a body, None: the world
    b: int  # it hangs on one hinge alone, and a comes before it
    at: tuple  # m, world
    axis: tuple  # unit, world
    lower: Optional[float] = None  # rad, 0 as the scene begins
    upper: Optional[float] = None
    torque: float = 0.0  # N m on b about the axis, and against it on a


@dataclass
class Scene:
    bodies: list
    hinges: tuple = ()
    friction: float = 0.5  # of every pair
    restitution: float = 0.0
    gravity: float = 9.81  # m/s^2, downwards
    size: float = 1.0  # m: half of the least thing, for engines that want to be told
    hollow: bool = False  # for rays alone: nothing collides
    sweeps: float = 0.0  # m, how far things may go in a frame: engines that sweep only on demand are asked to


class Refused(Exception):
    """The engine has no such thing, or does not take the numbers; the text says which."""


class Clock:
    """Processor time of an engine's own calls."""

    def __init__(self):
        self.spent, self.frames = 0.0, 0

    def __enter__(self):
        self.begun = time.process_time()

    def __exit__(self, *_):
        self.spent += time.process_time() - self.begun
        self.frames += 1

    def microseconds(self):
        return 1e6 * self.spent / max(1, self.frames)


def product(p, q):
    """Of two quaternions."""
    a, b, c, d = p
    x, y, z, w = q
    return (d * x + a * w + b * z - c * y, d * y + b * w + c * x - a * z, d * z + c * w + a * y - b * x,
            d * w - a * x - b * y - c * z)


def conjugate(q):
    return (-q[0], -q[1], -q[2], q[3])


def turned(q, v):
    """The vector v turned by q."""
    return product(product(q, (*v, 0.0)), conjugate(q))[:3]


def about(axis, angle):
    """The turn by angle, rad, about a unit axis."""
    s = math.sin(angle / 2)
    return (s * axis[0], s * axis[1], s * axis[2], math.cos(angle / 2))


class Path:
    """Of a kinematic body, frame by frame: for engines that have none, and take a heavy body that is put where it belongs."""

    def __init__(self, body):
        self.position, self.orientation = body.position, body.orientation
        self.velocity, self.spin = body.velocity, body.spin

    def go(self):
        self.position = tuple(p + FRAME * v for p, v in zip(self.position, self.velocity))
        rate = math.hypot(*self.spin)
        if rate:
            self.orientation = product(about(tuple(w / rate for w in self.spin), rate * FRAME), self.orientation)


def closed_below(vertices, depth):
    """Vertices of a mesh and their copies below them: for engines whose meshes are solids."""
    return list(vertices) + [(x, y - depth, z) for x, y, z in vertices]


def triangles_of(rows, spacing):
    """Vertices and triangles of a height field, centred."""
    n, m = len(rows[0]), len(rows)
    vertices = [(spacing * (i - (n - 1) / 2), h, spacing * (k - (m - 1) / 2)) for k, row in enumerate(rows) for i, h in enumerate(row)]
    triangles = []
    for k in range(m - 1):
        for i in range(n - 1):
            a = k * n + i
            triangles += [(a, a + n, a + n + 1), (a, a + n + 1, a + 1)]
    return vertices, triangles
