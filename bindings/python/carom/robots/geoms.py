"""What of a model touches: shapes, friction, and which may touch which."""
from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Optional, Tuple

import numpy as np

from ..errors import CaromError
from . import turns
from .links import Links, name_of
from .problems import Problems

if TYPE_CHECKING:
    from ..body import Body, Material
    from ..shape import Shape
    from ..world import World

ALONG_Y = np.array([0.5, 0.5, 0.5, 0.5])  # y to z, z to x, x to y: Carom's capsules and cylinders lie along y, MuJoCo's along z
UP_Z = np.array([np.sqrt(0.5), 0.0, 0.0, np.sqrt(0.5)])  # y to z, z to -y: heights of a field
MOST_CLASSES = 64


def by_dim(dim: int, friction: tuple[float, ...]) -> tuple[float, float, float]:
    """@param friction  sliding, spinning, rolling   @return those that contacts of so many dimensions have"""
    sliding, spinning, rolling = friction
    return sliding if dim >= 3 else 0.0, spinning if dim >= 4 else 0.0, rolling if dim >= 6 else 0.0


@dataclass(frozen=True)
class Surface:
    friction: tuple[float, ...]  # sliding; spinning and rolling, m
    dim: int
    priority: int
    geom: int  # of which a pair speaks, or -1

    @property
    def own(self) -> tuple[float, float, float]:
        return by_dim(self.dim, self.friction)

    def against(self, other: Surface) -> tuple[float, float, float]:
        """MuJoCo's rule: the geom of the higher priority decides, or else the larger of two numbers, and of two dimensions."""
        if self.priority != other.priority:
            return max(self, other, key=lambda one: one.priority).own
        return by_dim(max(self.dim, other.dim), tuple(max(pair) for pair in zip(self.friction, other.friction)))


@dataclass(frozen=True)
class Class:
    """Geoms that touch the same others."""
    contype: int
    conaffinity: int
    body: int = -1  # of which one exclude speaks, and not of all of its link
    geom: int = -1  # of which a pair speaks that its bits do not allow


Actor = Tuple[str, int]  # what is one body of the world: ("link", its index), ("scenery", MuJoCo's body)


class Geoms:
    """Of a model: `used` are those that may touch something."""

    def __init__(self, model: Any, links: Links, problems: Problems) -> None:
        self.model, self.links, self.problems = model, links, problems
        self.types = [name[len("mjGEOM_"):].lower() for name in ("mjGEOM_PLANE", "mjGEOM_HFIELD", "mjGEOM_SPHERE", "mjGEOM_CAPSULE",
                      "mjGEOM_ELLIPSOID", "mjGEOM_CYLINDER", "mjGEOM_BOX", "mjGEOM_MESH", "mjGEOM_SDF")]
        self.paired = {int(g) for k in range(model.npair) for g in (model.pair_geom1[k], model.pair_geom2[k])}
        self.used = [g for g in range(model.ngeom) if model.geom_contype[g] or model.geom_conaffinity[g] or g in self.paired]
        self.pairs = {frozenset((int(model.pair_geom1[k]), int(model.pair_geom2[k]))) for k in range(model.npair)}
        self.excluded = {frozenset((int(s) >> 16, int(s) & 0xFFFF)) for s in model.exclude_signature}

    def actor(self, body: int) -> Actor:
        link = self.links.of_body[body]
        return ("scenery", body) if self.links.links[link].is_static else ("link", link)

    # ---- shapes ----

    def make(self, world: World, body_of: dict[Actor, Body], made: list[Any]) -> None:
        """Put colliders on bodies.
        @param body_of  takes the bodies of scenery that it makes   @param made  takes the shapes and materials"""
        shapes: dict[Any, Optional[Shape]] = {}
        materials: dict[Surface, Material] = {}
        surfaces = self.surfaces()
        filters = self.filters(body_of)
        for g in self.used:
            known = len(shapes)
            placed = self.shape(world, g, shapes)
            made += [shape for shape in list(shapes.values())[known:] if shape is not None]
            if placed is None:
                continue
            shape, position, turn = placed
            surface = surfaces[g]
            if surface not in materials:
                friction, spinning, rolling = surface.own
                materials[surface] = world.material(friction=friction, friction_mix="maximum", spinning=spinning, rolling=rolling)
                made.append(materials[surface])
            actor = self.actor(int(self.model.geom_bodyid[g]))
            if actor not in body_of:
                body_of[actor] = world.body(type="static", position=(0, 0, 0))
            on_body = np.array(self.model.geom_pos[g]), turns.from_mujoco(self.model.geom_quat[g])
            at = turns.on(self.links.within[int(self.model.geom_bodyid[g])], on_body)
            at = turns.on(at, (position, turn))
            try:
                collider = body_of[actor].collider(shape, position=at[0], orientation=at[1], density=0, material=materials[surface])
            except CaromError as why:
                self.problems.add("geom", name_of(self.model, "geom", g), f"the library refuses its place: {why}")
                continue
            if filters[g] != (1, 2**64 - 1):
                collider.set_filter(*filters[g])
        self.mix(materials)

    def shape(self, world: World, g: int, shapes: dict[Any, Optional[Shape]]) -> Any:
        """@return shape, place and turn in the geom's frame; None: there is none, and why is told"""
        m, engine = self.model, world.engine
        kind, size, data = self.types[int(m.geom_type[g])], tuple(float(x) for x in m.geom_size[g]), int(m.geom_dataid[g])
        at, turn = np.zeros(3), turns.NONE
        if kind in ("capsule", "cylinder"):
            turn = ALONG_Y
        elif kind == "hfield":
            across, deep = float(m.hfield_size[data][0]), float(m.hfield_size[data][1])
            at, turn = np.array([-across, deep, 0.0]), UP_Z
        name = name_of(m, "geom", g)
        if kind in ("plane", "hfield") and not self.links.links[self.links.of_body[int(m.geom_bodyid[g])]].is_static:
            self.problems.add("geom", name, f"a {kind} on a body that moves")
            return None
        grown = max(0.0, float(m.geom_margin[g]) - float(m.geom_gap[g]))  # MuJoCo adds those of two geoms: each is so much larger
        if grown and kind == "plane":
            at = at + (0, 0, grown)
        elif grown and kind == "hfield":
            self.problems.add("geom", name, f"margin of a {kind}: contacts begin at its surface")
        elif grown and kind != "mesh":
            round_only = 1 if kind in ("sphere", "capsule") else 3  # a capsule is as long as it was
            size = tuple(x + grown if k < round_only and x else x for k, x in enumerate(size))
        key = (kind, (data, grown) if kind == "mesh" else data if kind == "hfield" else size)
        if key not in shapes:
            make = {"plane": lambda: engine.half_space((0, 0, 1), 0), "sphere": lambda: engine.sphere(size[0]),
                    "capsule": lambda: engine.capsule(size[0], size[1]), "cylinder": lambda: engine.cylinder(size[0], size[1]),
                    "ellipsoid": lambda: engine.ellipsoid(*size), "box": lambda: engine.box(*size),
                    "mesh": lambda: self.hull(engine, data, grown, shapes), "hfield": lambda: engine.height_field(*self.heights(data))}
            try:
                shapes[key] = make[kind]() if kind in make else None
            except (CaromError, ValueError) as why:
                shapes[key] = None
                self.problems.add("geom", name, f"no shape can be made of it: {' '.join(str(why).split())}")
        if shapes[key] is None:
            self.problems.add("geom", name, "a signed distance field" if kind == "sdf" else "no shape can be made of it, as said above")
            return None
        return shapes[key], at, turn

    def hull(self, engine: Any, mesh: int, grown: float, shapes: dict[Any, Optional[Shape]]) -> Any:
        """@param shapes  takes the hull that one that is grown is made of"""
        own = shapes.get(("mesh", (mesh, 0.0))) or engine.hull(self.corners(mesh))
        if not grown:
            return own
        shapes[("mesh", (mesh, 0.0))] = own
        return engine.hull_of([own], radius=grown)

    def corners(self, mesh: int) -> Any:
        """m, (n, 3): of the hull, where MuJoCo has found it"""
        m = self.model
        first, count, graph = int(m.mesh_vertadr[mesh]), int(m.mesh_vertnum[mesh]), int(m.mesh_graphadr[mesh])
        corners = np.array(m.mesh_vert[first:first + count], float)
        if graph < 0:
            return corners
        on_hull = int(m.mesh_graph[graph])
        return corners[m.mesh_graph[graph + 2 + on_hull:graph + 2 + 2 * on_hull]]

    def heights(self, field: int) -> Any:
        """@return rows of heights, m, the last of MuJoCo's first, and spacings"""
        m = self.model
        rows, columns, first = int(m.hfield_nrow[field]), int(m.hfield_ncol[field]), int(m.hfield_adr[field])
        across, deep, up, _ = (float(x) for x in m.hfield_size[field])
        data = np.array(m.hfield_data[first:first + rows * columns], float).reshape(rows, columns)[::-1] * up
        return data.tolist(), (2 * across / (columns - 1), 2 * deep / (rows - 1))

    # ---- friction ----

    def surfaces(self) -> dict[int, Surface]:
        """Of each geom. Those that a pair names are of a kind of their own."""
        m = self.model
        return {g: Surface(tuple(float(x) for x in m.geom_friction[g]), int(m.geom_condim[g]), int(m.geom_priority[g]),
                           g if g in self.paired else -1) for g in self.used}

    def said(self) -> dict[frozenset[int], tuple[float, float, float]]:
        """Friction, spinning and rolling that pairs give their two geoms."""
        m, found = self.model, {}
        for k in range(m.npair):
            sliding, across, spinning, rolling, over = (float(x) for x in m.pair_friction[k])
            if sliding != across or rolling != over:
                self.problems.add("pair", name_of(m, "pair", k), "its friction differs by direction: the first of two counts")
            found[frozenset((int(m.pair_geom1[k]), int(m.pair_geom2[k])))] = by_dim(int(m.pair_dim[k]), (sliding, spinning, rolling))
        return found

    def mix(self, materials: dict[Surface, Material]) -> None:
        """Let materials be to each other what MuJoCo's geoms are."""
        said = self.said()
        kinds = list(materials)
        for k, one in enumerate(kinds):
            for other in kinds[k:]:
                wanted = said.get(frozenset((one.geom, other.geom)), one.against(other)) if one.geom >= 0 and other.geom >= 0 else one.against(other)
                if not np.allclose(wanted, [max(pair) for pair in zip(one.own, other.own)], rtol=1e-12, atol=0):
                    friction, spinning, rolling = wanted
                    materials[one].set_against(materials[other], friction, spinning=spinning, rolling=rolling)

    # ---- which touch which ----

    def bits(self, g: int, h: int) -> bool:
        m = self.model
        return bool(m.geom_contype[g] & m.geom_conaffinity[h] or m.geom_contype[h] & m.geom_conaffinity[g])

    def filters(self, body_of: dict[Actor, Body]) -> dict[int, tuple[int, int]]:
        """Categories and masks of geoms; bodies that touch nowhere ignore each other."""
        m = self.model
        of_actor: dict[Actor, set[int]] = {}
        for g in self.used:
            of_actor.setdefault(self.actor(int(m.geom_bodyid[g])), set()).add(int(m.geom_bodyid[g]))
        partly: set[int] = set()
        for both in self.excluded:
            a, b = (sorted(both) * 2)[:2]
            one, other = self.actor(a), self.actor(b)
            if one == other or not of_actor.get(one) or not of_actor.get(other):
                continue
            paired = any({self.actor(int(m.geom_bodyid[g])) for g in pair} == {one, other} for pair in self.pairs)
            if not paired and all(frozenset((x, y)) in self.excluded for x in of_actor[one] for y in of_actor[other]):
                self.apart(body_of, one, other)
            else:
                partly |= {a, b}
        special = {g for both in self.pairs for g in both if len(both) == 2 and (
            not self.bits(*both) or frozenset(int(m.geom_bodyid[h]) for h in both) in self.excluded)}
        classes = {g: Class(int(m.geom_contype[g]), int(m.geom_conaffinity[g]), int(m.geom_bodyid[g]) if int(m.geom_bodyid[g]) in partly else -1,
                            g if g in special else -1) for g in self.used}
        for both in self.pairs:
            self.check_pair(both)
        kinds = list(dict.fromkeys(classes.values()))
        if len(kinds) > MOST_CLASSES:
            self.problems.add("exclude", (), f"there are more than {MOST_CLASSES} kinds of geoms that touch different others: all of them may touch")
            return {g: (1, 2**64 - 1) for g in self.used}
        masks = [sum(1 << k for k, other in enumerate(kinds) if self.touch(one, other)) for one in kinds]
        if len(kinds) == 1 and masks == [1]:
            return {g: (1, 2**64 - 1) for g in self.used}
        return {g: (1 << kinds.index(classes[g]), masks[kinds.index(classes[g])]) for g in self.used}

    def touch(self, one: Class, other: Class) -> bool:
        if one.geom >= 0 and other.geom >= 0 and frozenset((one.geom, other.geom)) in self.pairs:
            return True
        if one.body >= 0 and other.body >= 0 and frozenset((one.body, other.body)) in self.excluded:
            return False
        return bool(one.contype & other.conaffinity or other.contype & one.conaffinity)

    def check_pair(self, both: frozenset[int]) -> None:
        m = self.model
        a, b = ([*both] * 2)[:2]
        links = self.links.links
        one, other = (links[self.links.of_body[int(m.geom_bodyid[g])]] for g in (a, b))
        near = one.group == other.group or any(not links[up.group].is_static and links[links[low.group].parent].group == up.group
                                               for low, up in ((one, other), (other, one)))
        if near:
            self.problems.add("pair", f"{name_of(m, 'geom', a)} and {name_of(m, 'geom', b)}",
                              "its geoms are on one link, or on two that a joint holds, which do not touch")

    def apart(self, body_of: dict[Actor, Body], one: Actor, other: Actor) -> None:
        for actor in (one, other):
            if actor not in body_of:
                body_of[actor] = next(iter(body_of.values())).world.body(type="static", position=(0, 0, 0))
        body_of[one].ignore_collision(body_of[other])
