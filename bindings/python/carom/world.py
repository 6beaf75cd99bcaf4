"""The second root: bodies and what holds, pushes and asks them; it steps."""
from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, Any, Callable, Iterable, Mapping, TypeVar

from . import raw
from ._root import Root, count_of
from ._values import describe, enum, flag, handle_of, handles_out, number, vec3
from .body import Body, Collider, Material, Thing, collider_desc
from .bulk import Bulk
from .dials import Dials
from .errors import Busy, CaromError, Closed, Reentrant, as_typed
from .force import ForceField, Spring, Water
from .joint import Joint, make_coupling, make_joint
from .particles import Particles
from .notebook import Shown
from .query import Questions
from .report import Reports
from .shape import Shape
from .snapshot import Snapshots
from .tree import JointTree

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ._values import Vector
    from .engine import Engine
    from .records import BodyTypeWord, ForceFieldKeywords, ForceFieldWord, JointKeywords, JointWord, MixWord, ParticlesKeywords, PresetWord

T = TypeVar("T", bound=Thing)

_OBJECTS: dict[str, type[Thing]] = {"carom_body": Body, "carom_collider": Collider, "carom_material": Material, "carom_joint": Joint,
            "carom_particles": Particles, "carom_force_field": ForceField, "carom_spring": Spring}


class World(Root, Bulk, Questions, Reports, Snapshots, Shown):
    """Made by Engine.world(). One thread steps it, or any number read it; who comes at the wrong time gets Busy.
    A step lets other Python threads run."""

    _kind = "world"

    def __init__(self, engine: Engine, desc: raw.carom_world_desc, dials: Mapping[str, Any]):
        pointer = ctypes.c_void_p()
        engine._call(raw.carom_world_create, ctypes.byref(desc), ctypes.byref(pointer))
        self._adopt(engine, pointer.value)
        try:
            for name, value in dials.items():
                self.dials[name] = value
        except BaseException:
            self.close()
            raise

    def _adopt(self, engine: Engine, pointer: int | None) -> None:
        Root.__init__(self, pointer, raw.carom_world_destroy, engine._owner)
        self.engine = engine
        engine._worlds.add(self)
        self.dials = Dials(self)

    @classmethod
    def _adopted(cls, engine: Engine, pointer: int | None) -> World:
        """The object of a world that the library made."""
        world = cls.__new__(cls)
        world._adopt(engine, pointer)
        return world

    def _wrap(self, kind: str, handle: int) -> Shape | Thing:
        """The object of a handle of this world, or of its engine."""
        return Shape(self.engine, handle) if kind == "carom_shape" else _OBJECTS[kind](self, handle)

    def _create(self, kind: type[T], function: Callable[..., int], *arguments: object) -> T:
        handle = ctypes.c_uint64()
        self._call(function, *arguments, ctypes.byref(handle))
        return kind(self, handle.value)

    def __repr__(self) -> str:
        try:
            joints = ctypes.c_uint64()
            self._call(raw.carom_world_get_joints, None, 0, ctypes.byref(joints))
            return (f"<carom.World: {count_of(self.body_count(), 'body')}, {count_of(joints.value, 'joint')}, "
                    f"at {self.report.time:.6g} s>")
        except Closed:
            return "<carom.World, closed>"
        except (Busy, Reentrant):
            return "<carom.World, in a call>"

    # ---- time ----

    def step(self, dt: float = 1 / 60) -> None:
        """Advance by dt, s, in [1e-9, 1]."""
        self._call(raw.carom_world_step, number(dt, "dt"))

    @property
    def hash(self) -> int:
        """64 bits that are equal when every pose, velocity and cached contact has the same bits."""
        value = ctypes.c_uint64()
        self._call(raw.carom_world_hash, ctypes.byref(value))
        return value.value

    def set_preset(self, preset: PresetWord | int) -> None:
        """Dials together, from the next step on: "fast", "balanced", "accurate", "reference"."""
        self._call(raw.carom_world_set_preset, enum("PRESET", preset, "preset"))

    @property
    def gravity(self) -> tuple[float, ...]:
        """m/s^2"""
        out = (ctypes.c_double * 3)()
        self._call(raw.carom_world_get_gravity, out)
        return tuple(out)

    @gravity.setter
    def gravity(self, value: Vector) -> None:
        self._call(raw.carom_world_set_gravity, vec3(value, "gravity"))

    # ---- what is in it ----

    def material(self, friction: float | None = None, restitution: float | None = None, friction_mix: MixWord | int | None = None,
                 restitution_mix: MixWord | int | None = None, rolling: float = 0, spinning: float = 0) -> Material:
        """@param friction  default 0.5   @param restitution  default 0   @param rolling, spinning  m, resistance
        @param friction_mix, restitution_mix  "geometric_mean", "maximum", "minimum", "average", "multiply" """
        def mix(value: str | int | None, name: str) -> int | None:
            return None if value is None else enum("MIX", value, name)

        desc = describe(raw.carom_material_desc, {"friction": friction, "restitution": restitution,
                                                  "friction_mix": mix(friction_mix, "friction_mix"),
                                                  "restitution_mix": mix(restitution_mix, "restitution_mix")})
        resistance = number(rolling, "rolling"), number(spinning, "spinning")
        material = self._create(Material, raw.carom_material_create, ctypes.byref(desc))
        if any(resistance):
            try:
                material.resistance = resistance
            except BaseException:
                material.destroy()
                raise
        return material

    def body(self, shape: Shape | None = None, position: Vector | None = None, orientation: Vector | None = None,
             type: BodyTypeWord | int = "dynamic", linear_velocity: Vector | None = None,
             angular_velocity: Vector | None = None, mass: float | None = None, center: Vector | None = None,
             inertia: Vector | None = None, linear_damping: float | None = None, angular_damping: float | None = None,
             stays_awake: bool = False, user: int | None = None, material: Material | None = None,
             density: float | None = None) -> Body:
        """A body, and with `shape` its first collider (of `material` and `density`).
        @param position  m   @param orientation  x, y, z, w   @param type  "static", "kinematic", "dynamic"
        @param mass  kg, default from the colliders' densities   @param center  m and
        @param inertia  kg m^2, 9 numbers row by row: need mass   @param density  kg/m^3, default 1000"""
        fields = ((raw.CAROM_BODY_FIELD_MASS if mass is not None else 0) | (raw.CAROM_BODY_FIELD_CENTER if center is not None else 0)
                  | (raw.CAROM_BODY_FIELD_INERTIA if inertia is not None else 0) | (raw.CAROM_BODY_STAYS_AWAKE if stays_awake else 0))
        desc = describe(raw.carom_body_desc, {
            "fields": fields, "type": enum("BODY", type, "type"), "position": position, "orientation": orientation,
            "linear_velocity": linear_velocity, "angular_velocity": angular_velocity, "mass": mass, "center": center,
            "inertia": inertia, "linear_damping": linear_damping, "angular_damping": angular_damping, "user": user})
        first = None if shape is None else collider_desc(shape, None, None, density, material)
        if shape is None and (density is not None or material is not None):
            raise TypeError(f"{'material' if density is None else 'density'} is that of a shape: give shape=, or say it to body.collider()")
        body = self._create(Body, raw.carom_body_create, ctypes.byref(desc))
        if first is not None:
            try:
                self._create(Collider, raw.carom_collider_create, body.handle, ctypes.byref(first))
            except BaseException:
                body.destroy()
                raise
        return body

    def ground(self, normal: Vector = (0, 1, 0), offset: float = 0, material: Material | None = None) -> Body:
        """A static half-space."""
        handle_of(material, "material", "carom_material")
        return self.body(self.engine.half_space(normal, offset), type="static", material=material)

    def joint(self, kind: JointWord | int, a: Body | None = None, b: Body | None = None, position: Vector | None = None,
              orientation: Vector | None = None, axis: Vector | None = None, **about: Unpack[JointKeywords]) -> Joint:
        """Hold two bodies together, or one and the world (None); see joint.py."""
        return make_joint(self, kind, a, b, position, orientation, axis, about)

    def couple(self, follower: Joint, leader: Joint, polynomial: Iterable[float] = (0, 1), user: int = 0) -> Joint:
        """Make the coordinate of one hinge or slider follow a polynomial of another's, the constant term first, at most five:
        (0, -1) turns it back as far as the other goes on."""
        return make_coupling(self, follower, leader, polynomial, user)

    def tree(self, body: Body) -> JointTree:
        """The joints that hang together with a dynamic body, as a robot: inverse dynamics, mass matrix."""
        handle_of(body, "body", "carom_body", False)
        return JointTree(body)

    def force_field(self, kind: ForceFieldWord | int = "uniform", **about: Unpack[ForceFieldKeywords]) -> ForceField:
        """@param kind  "uniform", "radial", "vortex"   @param about  fields of carom_force_field_desc: vector, strength, ..."""
        desc = describe(raw.carom_force_field_desc, {"kind": enum("FORCE_FIELD", kind, "kind"), **about})
        return self._create(ForceField, raw.carom_force_field_create, ctypes.byref(desc))

    def spring(self, a: Body | None, b: Body | None, rest: float, stiffness: float, damping: float | None = None,
               anchor_a: Vector | None = None, anchor_b: Vector | None = None, only_pulls: bool = False, user: int | None = None) -> Spring:
        """A spring as a force. @param rest  m   @param stiffness  N/m   @param damping  N s/m   @param anchor_a, anchor_b  m"""
        desc = describe(raw.carom_spring_desc, {
            "body_a": handle_of(a, "a", "carom_body"), "body_b": handle_of(b, "b", "carom_body"), "rest": number(rest, "rest"),
            "stiffness": number(stiffness, "stiffness"), "damping": damping,
            "anchor_a": anchor_a, "anchor_b": anchor_b, "only_pulls": flag(only_pulls, "only_pulls"), "user": user})
        return self._create(Spring, raw.carom_spring_create, ctypes.byref(desc))

    def particles(self, **about: Unpack[ParticlesKeywords]) -> Particles:
        """An empty set of point masses. @param about  gravity_factor, linear_damping, mass, capacity"""
        desc = describe(raw.carom_particles_desc, about)
        return self._create(Particles, raw.carom_particles_create, ctypes.byref(desc))

    @property
    def water(self) -> Water | None:
        """Set a carom.Water(level=..., density=...), or None: none."""
        desc, present = describe(raw.carom_water, {}), ctypes.c_uint32()
        desc.struct_size = ctypes.sizeof(raw.carom_water)
        self._call(raw.carom_world_get_water, ctypes.byref(desc), ctypes.byref(present))
        return Water._of(desc) if present.value else None

    @water.setter
    def water(self, value: Water | None) -> None:
        self._call(raw.carom_world_set_water, None if value is None else ctypes.byref(value._desc()))

    @property
    def wind(self) -> tuple[float, ...]:
        """m/s; it reaches bodies through their drag"""
        out = (ctypes.c_double * 3)()
        self._call(raw.carom_world_get_wind, out)
        return tuple(out)

    @wind.setter
    def wind(self, value: Vector) -> None:
        try:
            self._call(raw.carom_world_set_wind, vec3(value, "wind"))
        except CaromError as refused:
            raise as_typed(refused, ("wind",), 2) from None

    @property
    def bodies(self) -> list[Body]:
        """All of them, in the order of their slots; for thousands rather body_handles() and read()."""
        return [Body(self, handle) for handle in handles_out(self._call, raw.carom_world_get_bodies)]

    @property
    def joints(self) -> list[Joint]:
        return [Joint(self, handle) for handle in handles_out(self._call, raw.carom_world_get_joints)]
