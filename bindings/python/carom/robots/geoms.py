"""What of a model touches: shapes, friction, and which may touch which."""
from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Iterable, Optional, Tuple

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


@dataclass(frozen=True)
class Surface:
    friction: float
    spinning: float
    rolling: float
    rules: str = "maximum"  # how it mixes with others: as carom_material_desc.friction_mix


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
            if placed is None:
                continue
            shape, position, turn = placed
            if len(shapes) > known:
                made.append(shape)
            surface = surfaces[g]
            if surface not in materials:
                materials[surface] = world.material(friction=surface.friction, friction_mix=surface.rules,  # type: ignore[arg-type]
                                                    spinning=surface.spinning, rolling=surface.rolling)
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
        elif grown and kind in ("mesh", "hfield"):
            self.problems.add("geom", name, f"margin of a {kind}: contacts begin at its surface")
        elif grown:
            round_only = 1 if kind in ("sphere", "capsule") else 3  # a capsule is as long as it was
            size = tuple(x + grown if k < round_only and x else x for k, x in enumerate(size))
        key = (kind, data if kind in ("mesh", "hfield") else size)
        if key not in shapes:
            make = {"plane": lambda: engine.half_space((0, 0, 1), 0), "sphere": lambda: engine.sphere(size[0]),
                    "capsule": lambda: engine.capsule(size[0], size[1]), "cylinder": lambda: engine.cylinder(size[0], size[1]),
                    "ellipsoid": lambda: engine.ellipsoid(*size), "box": lambda: engine.box(*size),
                    "mesh": lambda: engine.hull(self.corners(data)), "hfield": lambda: engine.height_field(*self.heights(data))}
            try:
                shapes[key] = make[kind]() if kind in make else None
            except (CaromError, ValueError) as why:
                shapes[key] = None
                self.problems.add("geom", name, f"no shape can be made of it: {' '.join(str(why).split())}")
        if shapes[key] is None:
            self.problems.add("geom", name, "a signed distance field" if kind == "sdf" else "no shape can be made of it, as said above")
            return None
        return shapes[key], at, turn

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
        """MuJoCo takes the larger friction of two geoms, or that of the geom with the higher priority, or that of a pair."""
        m, found = self.model, {}
        for g in self.used:
            friction, dim = [float(x) for x in m.geom_friction[g]], int(m.geom_condim[g])
            found[g] = Surface(friction[0] if dim >= 3 else 0.0, friction[1] if dim >= 4 else 0.0, friction[2] if dim >= 6 else 0.0)
        self.unlike(found)
        ruling = [g for g in self.used if m.geom_priority[g] > min(m.geom_priority[h] for h in self.used)]
        for g in ruling:
            self.rule(found, g, [h for h in self.used if m.geom_priority[h] < m.geom_priority[g]], found[g], "its priority")
        for k in range(m.npair):
            self.pair(found, k)
        return found

    def unlike(self, found: dict[int, Surface]) -> None:
        """What the larger of two numbers does not tell."""
        m = self.model
        for kind, dim, at in (("friction", 3, 0), ("friction about the normal", 4, 1), ("friction of rolling", 6, 2)):
            has = [float(m.geom_friction[g][at]) for g in self.used if m.geom_condim[g] >= dim]
            lack = [g for g in self.used if m.geom_condim[g] < dim and has and float(m.geom_friction[g][at]) > min(has)]
            if lack:
                self.problems.add("geom", (name_of(m, "geom", g) for g in lack),
                                  f"its condim is below {dim}: where it touches one that has {kind}, that one's alone counts")

    def rule(self, found: dict[int, Surface], g: int, others: Iterable[int], wanted: Surface, why: str) -> None:
        """Let geom g have its own friction against others."""
        among = [found[h] for h in others if h != g]
        if all(wanted.friction >= one.friction and wanted.spinning >= one.spinning and wanted.rolling >= one.rolling for one in among):
            found[g] = wanted
        elif all(wanted.friction <= one.friction for one in among) and not any(one.spinning or one.rolling for one in [*among, wanted]):
            found[g] = Surface(wanted.friction, wanted.spinning, wanted.rolling, "minimum")
        else:
            self.problems.add("geom", name_of(self.model, "geom", g),
                              f"{why} gives it a friction that no way to mix two gives: the larger of two counts")

    def pair(self, found: dict[int, Surface], k: int) -> None:
        m, friction, dim = self.model, [float(x) for x in self.model.pair_friction[k]], int(self.model.pair_dim[k])
        wanted = Surface(friction[0] if dim >= 3 else 0.0, friction[2] if dim >= 4 else 0.0, friction[3] if dim >= 6 else 0.0)
        one, other = int(m.pair_geom1[k]), int(m.pair_geom2[k])
        mixed = (max if "minimum" not in (found[one].rules, found[other].rules) else min)
        has = [mixed(getattr(found[one], what), getattr(found[other], what)) for what in ("friction", "spinning", "rolling")]
        if np.allclose(has, [wanted.friction, wanted.spinning, wanted.rolling], rtol=1e-9, atol=0) and friction[0] == friction[1]:
            return
        for g, h in ((one, other), (other, one)):
            asked = {float(m.pair_friction[n][0]) for n in range(m.npair) if g in (m.pair_geom1[n], m.pair_geom2[n])}
            if len(asked) == 1 and not self.touches_by_bits(g) and friction[0] == friction[1]:
                self.rule(found, g, [h], wanted, "a pair")
                return
        self.problems.add("pair", name_of(m, "pair", k), "its friction is not that of its geoms: theirs counts")

    def touches_by_bits(self, g: int) -> bool:
        m = self.model
        return any(self.bits(g, h) for h in self.used if m.geom_bodyid[h] != m.geom_bodyid[g])

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
