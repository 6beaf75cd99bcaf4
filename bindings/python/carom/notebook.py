"""What a notebook shows: a world as a picture with its counts, and a run of it as a film. All in one piece of HTML, which asks no
network for anything."""
from __future__ import annotations

import base64
import ctypes
import html
import json
import math
import os
from array import array
from itertools import combinations
from typing import TYPE_CHECKING, Any, Callable, Iterator, Sequence

from . import raw
from ._player import PLAYER
from ._values import number, whole
from .errors import CaromError

if TYPE_CHECKING:
    from .body import Body
    from .shape import Shape
    from .world import World

Point = tuple[float, ...]

DIRECTIONS = 160  # in which a shape is asked for its farthest points
FACETED = 32  # points: a shape of no more has faces, others are drawn as round
TRIANGLES = 4000  # of scenery: of more none is drawn
PARTS = 3000  # of a picture
COLOURS = ("#d9875a", "#4f86b8", "#e4bb58", "#6fa083", "#b9566a", "#8f7db8", "#3f9c9c", "#c9a88a")
FIXED = "#9aa1ab"
CAMERA = (0.5, 0.38, 0.78)  # from what is looked at to the camera
LIGHT = (-0.35, 0.85, 0.4)  # where it comes from
FOCAL = 1.7  # of half the picture's height
CLOSE = 0.8  # of the distance from which a ball around all is seen: scenes are flat


def _dot(a: Sequence[float], b: Sequence[float]) -> float:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def _cross(a: Sequence[float], b: Sequence[float]) -> Point:
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def _minus(a: Sequence[float], b: Sequence[float]) -> Point:
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def _unit(a: Sequence[float]) -> Point:
    length = math.sqrt(_dot(a, a)) or 1.0
    return (a[0] / length, a[1] / length, a[2] / length)


def _placed(pose: Sequence[float], v: Sequence[float]) -> Point:
    """@param pose  x, y, z and a quaternion x, y, z, w"""
    u = pose[3:6]
    t = [2 * x for x in _cross(u, v)]
    w = _cross(u, t)
    return tuple(pose[i] + v[i] + pose[6] * t[i] + w[i] for i in range(3))


def _directions() -> Iterator[Point]:
    yield from ((x, y, z) for x in (-1, 0, 1) for y in (-1, 0, 1) for z in (-1, 0, 1) if x or y or z)
    for i in range(DIRECTIONS):
        y = 1 - (2 * i + 1) / DIRECTIONS
        r, turn = math.sqrt(1 - y * y), i * math.pi * (3 - math.sqrt(5))
        yield r * math.cos(turn), y, r * math.sin(turn)


def _farthest(shape: Shape) -> list[Point]:
    flat = [x for direction in _directions() for x in direction]
    n = len(flat) // 3
    out = (ctypes.c_double * (3 * n))()
    shape.engine._call(raw.carom_shape_support, shape.handle, (ctypes.c_double * (3 * n))(*flat), n, out)
    points = [(out[3 * i], out[3 * i + 1], out[3 * i + 2]) for i in range(n)]
    size = max((max(map(abs, p)) for p in points), default=1) or 1.0
    return list({tuple(round(x / size, 6) for x in p): p for p in points}.values())


def _faces(points: list[Point]) -> list[list[int]]:
    """Of the convex hull of few points: corners counter-clockwise, seen from outside."""
    size = max(max(map(abs, p)) for p in points) or 1.0
    found: dict[frozenset[int], list[int]] = {}
    for i, j, k in combinations(range(len(points)), 3):
        normal = _cross(_minus(points[j], points[i]), _minus(points[k], points[i]))
        if _dot(normal, normal) < (1e-6 * size * size) ** 2:
            continue
        normal = _unit(normal)
        beyond = [_dot(normal, _minus(p, points[i])) for p in points]
        if max(beyond) > 1e-5 * size:
            normal, beyond = (-normal[0], -normal[1], -normal[2]), [-x for x in beyond]
        if max(beyond) > 1e-5 * size:
            continue
        on = [n for n, x in enumerate(beyond) if x > -1e-5 * size]
        middle = tuple(sum(points[n][d] for n in on) / len(on) for d in range(3))
        x = _unit(_minus(points[on[0]], middle))
        y = _cross(normal, x)
        found[frozenset(on)] = sorted(on, key=lambda n: math.atan2(_dot(y, _minus(points[n], middle)), _dot(x, _minus(points[n], middle))))
    return list(found.values())


def _triangles(shape: Shape) -> tuple[list[Point], list[list[int]]]:
    count, after = ctypes.c_uint64(), ctypes.c_uint64()
    shape.engine._call(raw.carom_shape_get_triangles, shape.handle, 0, None, ctypes.byref(count), ctypes.byref(after))
    if not 0 < count.value <= TRIANGLES:
        return [], []
    corners = (ctypes.c_double * (9 * count.value))()
    shape.engine._call(raw.carom_shape_get_triangles, shape.handle, 0, corners, ctypes.byref(count), ctypes.byref(after))
    points: list[Point] = [(corners[3 * i], corners[3 * i + 1], corners[3 * i + 2]) for i in range(3 * count.value)]
    return points, [[3 * i, 3 * i + 1, 3 * i + 2] for i in range(count.value)]


class _Scene:
    """What there is to draw: parts with the numbers of their bodies, points in the bodies' frames, faces or none: round."""

    def __init__(self, world: World):
        self.world, self.bodies = world, world.bodies
        self.fixed = [body.type != "dynamic" for body in self.bodies]
        self.floor: float | None = None
        self.parts: list[dict[str, Any]] = []
        meshes: dict[int, tuple[list[Point], list[list[int]] | None]] = {}
        kinds: list[int] = []
        planes: list[Body] = []
        for index, body in enumerate(self.bodies):
            for collider in body.colliders:
                desc = collider.desc
                shape = desc.shape
                if shape is None:
                    continue
                info = shape.info
                if info.is_half_space:
                    planes.append(body)
                    continue
                if shape.handle not in meshes:
                    if info.is_scenery:
                        meshes[shape.handle] = _triangles(shape)
                    else:
                        points = _farthest(shape)
                        meshes[shape.handle] = (points, _faces(points) if len(points) <= FACETED else None)
                points, faces = meshes[shape.handle]
                if not points or len(self.parts) >= PARTS:
                    continue
                if shape.handle not in kinds:
                    kinds.append(shape.handle)
                pose = (*desc.position, *desc.orientation)
                colour = FIXED if self.fixed[index] else COLOURS[kinds.index(shape.handle) % len(COLOURS)]
                self.parts.append({"body": index, "points": [_placed(pose, p) for p in points], "faces": faces, "colour": colour,
                                   "fixed": self.fixed[index]})

        if planes:
            (x, y, z), size = self.view(self.poses())
            below = world.ray((x + 50 * size, y + size + 1, z), (0, -1, 0))  # aside, where nothing else lies
            if below is not None and below.body in planes and below.normal[1] < -0.999:
                self.floor = below.point[1]

    def poses(self) -> list[tuple[float, ...]]:
        return [(*body.position, *body.orientation) for body in self.bodies]

    def reach(self, poses: Sequence[Sequence[float]]) -> list[tuple[Point, float, bool]]:
        """Of each part a ball that holds it, and whether it is fixed."""
        out = []
        for part in self.parts:
            points = [_placed(poses[part["body"]], p) for p in part["points"]]
            middle = tuple((min(p[i] for p in points) + max(p[i] for p in points)) / 2 for i in range(3))
            out.append((middle, max(math.dist(middle, p) for p in points), part["fixed"]))
        return out

    def view(self, poses: Sequence[Sequence[float]]) -> tuple[Point, float]:
        """What is looked at, and how large it is: what moves, and what stands that is not much larger."""
        balls = [ball for ball in self.reach(poses) if all(map(math.isfinite, ball[0]))]
        moving = [ball for ball in balls if not ball[2]] or balls
        if not moving:
            return (0.0, 1.0, 0.0), 2.0
        low = [min(m[i] - r for m, r, _ in moving) for i in range(3)]
        high = [max(m[i] + r for m, r, _ in moving) for i in range(3)]
        return tuple((low[i] + high[i]) / 2 for i in range(3)), max(math.dist(low, high) / 2, 1e-3)


def _hull(points: list[tuple[float, float]]) -> list[tuple[float, float]]:
    """Of points of a plane."""
    def half(ordered: list[tuple[float, float]]) -> list[tuple[float, float]]:
        kept: list[tuple[float, float]] = []
        for p in ordered:
            while len(kept) > 1 and ((kept[-1][0] - kept[-2][0]) * (p[1] - kept[-2][1])
                                     <= (kept[-1][1] - kept[-2][1]) * (p[0] - kept[-2][0])):
                kept.pop()
            kept.append(p)
        return kept[:-1]
    ordered = sorted(set(points))
    return half(ordered) + half(ordered[::-1])


def _shade(colour: str, by: float) -> str:
    return "#" + "".join(f"{min(255, max(0, round(int(colour[i:i + 2], 16) * by))):02x}" for i in (1, 3, 5))


class Picture:
    """An SVG picture; a notebook shows it."""

    def __init__(self, svg: str):
        self.svg = svg

    def _repr_svg_(self) -> str:
        return self.svg

    def save(self, path: str | os.PathLike[str]) -> None:
        with open(path, "w", encoding="utf-8") as file:
            file.write(self.svg)


def picture(world: World, width: int = 640, height: int = 400) -> Picture:
    """A world as it stands. @param width, height  of the picture, px"""
    width, height = whole(width, "width", 1, 16384), whole(height, "height", 1, 16384)
    scene = _Scene(world)
    poses = scene.poses()
    target, size = scene.view(poses)
    back = _unit(CAMERA)
    right = _unit(_cross((0, 1, 0), back))
    up = _cross(back, right)
    half = min(width, height) / 2
    far = size * math.sqrt(1 + FOCAL * FOCAL) * CLOSE
    eye = tuple(target[i] + far * back[i] for i in range(3))

    def seen(p: Sequence[float]) -> tuple[float, float]:
        d = _minus(p, eye)
        depth = max(-_dot(back, d), 0.05 * far)
        scale = FOCAL * half / depth
        return round(width / 2 + scale * _dot(right, d), 1), round(height / 2 - scale * _dot(up, d), 1)

    def polygon(points: Sequence[tuple[float, float]], fill: str, more: str = "") -> str:
        return f'<polygon points="{" ".join(f"{x:g},{y:g}" for x, y in points)}" fill="{fill}"{more}/>'

    horizon = height / 2 - FOCAL * half * back[1] / math.hypot(back[0], back[2])
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" height="{height}" role="img" '
           f'aria-label="{html.escape(repr(world)[1:-1], quote=True)}">', f'<rect width="{width}" height="{height}" fill="#e3e8ee"/>']
    if scene.floor is not None:
        top = max(0.0, min(float(height), horizon))
        out.append(f'<rect y="{top:g}" width="{width}" height="{height - top:g}" fill="#d6d7d4"/>')
    balls, shadows, shapes = scene.reach(poses), [], []
    for part, (middle, radius, fixed) in zip(scene.parts, balls):
        if not all(map(math.isfinite, middle)):
            continue
        points = [_placed(poses[part["body"]], p) for p in part["points"]]
        depth = -_dot(back, _minus(middle, eye)) + (1e9 if fixed and radius > size else 0)
        drawn = []
        if part["faces"] is None:
            drawn.append(polygon(_hull([seen(p) for p in points]), _shade(part["colour"], 0.95), ' stroke="#00000055"'))
            glow = [tuple(middle[i] + 0.55 * (p[i] - middle[i]) + 0.25 * radius * _unit(LIGHT)[i] for i in range(3)) for p in points]
            drawn.append(polygon(_hull([seen(p) for p in glow]), _shade(part["colour"], 1.12)))
        for face in part["faces"] or ():
            normal = _unit(_cross(_minus(points[face[1]], points[face[0]]), _minus(points[face[2]], points[face[0]])))
            if _dot(normal, _minus(eye, points[face[0]])) > 0:
                drawn.append(polygon([seen(points[n]) for n in face], _shade(part["colour"], 0.7 + 0.4 * max(0.0, _dot(normal, _unit(LIGHT)))),
                                     ' stroke="#00000055" stroke-linejoin="round"'))
        shapes.append((depth, drawn))
        if scene.floor is not None and not fixed:
            fallen = [tuple(p[i] - LIGHT[i] / LIGHT[1] * (p[1] - scene.floor) for i in range(3)) for p in points if p[1] > scene.floor - size]
            shadows.append(polygon(_hull([seen(p) for p in fallen]), "#00000030") if len(fallen) > 2 else "")
    out += shadows
    for _, drawn in sorted(shapes, key=lambda one: -one[0]):
        out += drawn
    return Picture("".join(out) + "</svg>")


class Film:
    """A run of a world that plays in a notebook, or in a file of its own: play, pause, any moment, a camera that turns."""

    def __init__(self, page: str, height: int):
        self.page, self._height = page, height

    def _repr_html_(self) -> str:
        return (f'<iframe srcdoc="{html.escape(self.page, quote=True)}" title="A run of a world" sandbox="allow-scripts" '
                f'style="width:100%;height:{self._height}px;border:0"></iframe>')

    def save(self, path: str | os.PathLike[str]) -> None:
        """As a page of its own, for any browser."""
        with open(path, "w", encoding="utf-8") as file:
            file.write(self.page)


def film(world: World, seconds: float, dt: float = 1 / 60, each: Callable[[World], object] | None = None, rate: float = 30,
         height: int = 420) -> Film:
    """Step a world, and keep what is seen: `carom.film(world, 5)` in a notebook plays.
    @param each    called with the world before each step: what drives the scene; bodies that it makes are not seen
    @param rate    pictures a second   @param height  px"""
    seconds, dt, rate = number(seconds, "seconds"), number(dt, "dt"), number(rate, "rate")
    height = whole(height, "height", 1, 16384)
    if not seconds > 0 or not dt > 0 or not rate > 0:
        raise ValueError(f"film() takes seconds, dt and rate above 0, got seconds={seconds:g}, dt={dt:g}, rate={rate:g}")
    scene = _Scene(world)
    known = {body.handle: i for i, body in enumerate(scene.bodies)}
    first = scene.poses()
    poses = array("f")
    steps, taken = max(1, round(seconds / dt)), 0

    def keep() -> None:
        nonlocal taken
        now = {body.handle: (*body.position, *body.orientation) for body in world.bodies}
        for handle in known:
            poses.extend(now.get(handle, (math.nan,) * 7))
        taken += 1

    keep()
    for step in range(1, steps + 1):
        if each is not None:
            each(world)
        world.step(dt)
        if math.floor(step * dt * rate + 1e-9) >= taken or step == steps:
            keep()
    last = [tuple(poses[len(poses) - 7 * len(known) + 7 * i + k] for k in range(7)) for i in range(len(known))]
    (a, size), (b, other) = scene.view(first), scene.view(last)
    if other < 4 * size:  # what flew far away does not make all else small
        size, a = max(size, other, (size + other + math.dist(a, b)) / 2), tuple((x + y) / 2 for x, y in zip(a, b))
    about = {"rate": rate, "bodies": len(known), "floor": scene.floor, "target": a, "size": size, "camera": CAMERA, "light": LIGHT,
             "focal": FOCAL, "close": CLOSE,
             "parts": [{**part, "points": [[round(x, 5) for x in p] for p in part["points"]]} for part in scene.parts],
             "poses": base64.b64encode(poses.tobytes()).decode()}
    return Film(PLAYER.replace("SCENE", json.dumps(about, separators=(",", ":")).replace("</", "<\\/")), height)


class Shown:
    """Of worlds."""

    def picture(self: Any, width: int = 640, height: int = 400) -> Picture:
        """As it stands, an SVG picture. @param width, height  px"""
        return picture(self, width, height)

    def _repr_html_(self: Any) -> str | None:
        try:
            counts = {"bodies": self.body_count(), "joints": len(self.joints), "contacts": len(self.contacts()),
                      "time": f"{self.report.time:.4g} s", "hash": f"<code>{self.hash:016x}</code>"}
            return (f'<figure style="margin:0">{picture(self).svg}<figcaption>'
                    + " · ".join(f"{name} {value}" for name, value in counts.items()) + "</figcaption></figure>")
        except CaromError:
            return None  # closed, or in a call: the notebook shows repr()
