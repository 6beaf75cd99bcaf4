"""Drag and lift of a fluid that fills the world, by step(): MuJoCo's two models, of a body's box of inertia and of a geom's ellipsoid."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from . import turns

if TYPE_CHECKING:
    from .bodies import Bodies
    from .turns import Array, Pose

LEAST = 1e-15  # MuJoCo's: less than that divides nothing


class Fluid:
    """Of a robot; `acts`: whether there is any."""

    def __init__(self, bodies: Bodies) -> None:
        m, self.bodies = bodies.model, bodies
        self.density, self.viscosity, self.wind = float(m.opt.density), float(m.opt.viscosity), np.array(m.opt.wind, float)
        self.links: list[int] = []        # of each part: first those of boxes, then those of ellipsoids
        self.places: list[Pose] = []      # in the link
        self.sizes: list[Array] = []      # m: edges of boxes, half axes of ellipsoids
        self.laws: list[Array] = []       # of ellipsoids: geom_fluid
        self.boxes = 0
        if (self.density or self.viscosity) and not (bodies.disabled.spring and bodies.disabled.damper):
            self._find()
        self.acts = bool(self.links)
        if not self.acts:
            return
        ends = [bodies.last(bodies.links.links[link]).handle for link in self.links]
        self.handles = list(dict.fromkeys(ends))
        self.of = np.array([self.handles.index(end) for end in ends], int)
        self.within = np.array([place[0] for place in self.places])
        self.axes = np.array([turns.matrix(place[1]) for place in self.places])
        self.size, self.law = np.array(self.sizes), np.array(self.laws).reshape(-1, 12)

    def _find(self) -> None:
        m, links = self.bodies.model, self.bodies.links
        ellipsoids: list[tuple[int, Pose, Array, Array]] = []
        for body in range(1, m.nbody):
            link = links.of_body[body]
            if m.body_mass[body] < LEAST or links.links[link].is_static or links.links[link].mocap >= 0:
                continue
            geoms = range(int(m.body_geomadr[body]), int(m.body_geomadr[body] + m.body_geomnum[body]))
            own = [g for g in geoms if m.geom_fluid[g][0] > 0]
            for g in own:
                place = np.array(m.geom_pos[g], float), turns.from_mujoco(m.geom_quat[g])
                ellipsoids.append((link, turns.on(links.within[body], place), half_axes(m, g), np.array(m.geom_fluid[g], float)))
            if not own:
                a, b, c = (float(x) for x in m.body_inertia[body])
                squares = np.array([b + c - a, a + c - b, a + b - c]) * 6 / float(m.body_mass[body])
                place = np.array(m.body_ipos[body], float), turns.from_mujoco(m.body_iquat[body])
                self.links.append(link)
                self.places.append(turns.on(links.within[body], place))
                self.sizes.append(np.sqrt(np.maximum(squares, LEAST)))
        self.boxes = len(self.links)
        for link, place, size, law in ellipsoids:
            self.links.append(link)
            self.places.append(place)
            self.sizes.append(size)
            self.laws.append(law)

    def push(self) -> None:
        """Add what the fluid does to the next step's forces."""
        if not self.acts:
            return
        world = self.bodies.world
        pose, rates, center = (world.read(what, self.handles) for what in ("pose", "velocity", "center"))
        turn = turns.matrices(pose[:, 3:])[self.of]
        axes = turn @ self.axes
        arm = pose[self.of, :3] + np.einsum("nij,nj->ni", turn, self.within) - center[self.of]
        spin = rates[self.of, 3:]
        flow = rates[self.of, :3] + np.cross(spin, arm) - self.wind
        v, w = np.einsum("nji,nj->ni", axes, flow), np.einsum("nji,nj->ni", axes, spin)
        k = self.boxes
        parts = [self._box(v[:k], w[:k]), self._ellipsoid(v[k:], w[k:])]
        force, torque = (np.einsum("nij,nj->ni", axes, np.concatenate([part[i] for part in parts])) for i in (0, 1))
        whole = world.read("force", self.handles)
        np.add.at(whole, self.of, np.concatenate([force, torque + np.cross(arm, force)], axis=1))
        world.write("force", whole, self.handles)

    def _box(self, v: Array, w: Array) -> tuple[Array, Array]:
        """N and N m, axes of the body, of boxes that move at v, m/s, and turn at w, rad/s."""
        b = self.size[:self.boxes]
        around = b.mean(axis=1, keepdims=True)
        y, z = np.roll(b, -1, axis=1), np.roll(b, -2, axis=1)
        force = -3 * np.pi * self.viscosity * around * v - self.density / 2 * y * z * np.abs(v) * v
        torque = -np.pi * self.viscosity * around ** 3 * w - self.density / 64 * b * (y ** 4 + z ** 4) * np.abs(w) * w
        return force, torque

    def _ellipsoid(self, v: Array, w: Array) -> tuple[Array, Array]:
        s, law, rho, mu = self.size[self.boxes:], self.law, self.density, self.viscosity
        share, blunt, slender, turning, kutta, magnus = (law[:, k:k + 1] for k in range(6))
        carried, spun = rho * law[:, 6:9] * v, rho * law[:, 9:12] * w  # momentum of the fluid that moves with it
        force, torque = np.cross(carried, w), np.cross(carried, v) + np.cross(spun, w)
        volume = 4 / 3 * np.pi * s.prod(axis=1, keepdims=True)
        least, middle, largest = (np.sort(s, axis=1)[:, k:k + 1] for k in range(3))
        sides = np.roll(s, -1, axis=1) * np.roll(s, -2, axis=1)
        speed = np.linalg.norm(v, axis=1, keepdims=True)
        fourth, square = ((sides ** 4) * v ** 2).sum(axis=1, keepdims=True), ((sides * v) ** 2).sum(axis=1, keepdims=True)
        shown = np.pi * np.sqrt(fourth / np.maximum(LEAST, square))  # m^2, across the flow
        slant = square / np.maximum(LEAST, speed * fourth)
        around = np.cross(sides ** 2 * v, v) * kutta * rho * slant * shown
        force = force + magnus * rho * volume * np.cross(w, v) + np.cross(around, v)
        wide = 2 / 3 * s.sum(axis=1, keepdims=True)  # m: of a ball that is as wide
        longest = 8 / 15 * np.pi * middle * largest ** 4
        across = 8 / 15 * np.pi * s * np.maximum(np.roll(s, -1, axis=1), np.roll(s, -2, axis=1)) ** 4
        swept = np.linalg.norm(w * (turning * across + slender * (longest - across)), axis=1, keepdims=True)
        drag = mu * 3 * np.pi * wide + rho * speed * (shown * blunt + slender * (np.pi * largest * middle - shown))
        force = force - drag * v
        torque = torque - (mu * np.pi * wide ** 3 + rho * swept) * w
        return share * force, share * torque


def half_axes(model: Any, g: int) -> Array:
    """m, of the ellipsoid that stands for a geom in the fluid"""
    from .read import need_mujoco
    kinds, size = need_mujoco().mjtGeom, np.array(model.geom_size[g], float)
    kind = int(model.geom_type[g])
    if kind == int(kinds.mjGEOM_SPHERE):
        return np.full(3, size[0])
    if kind == int(kinds.mjGEOM_CAPSULE):
        return np.array([size[0], size[0], size[1] + size[0]])
    if kind == int(kinds.mjGEOM_CYLINDER):
        return np.array([size[0], size[0], size[1]])
    return size
