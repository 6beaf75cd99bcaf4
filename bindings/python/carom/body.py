"""Bodies, colliders, materials: light objects around handles. The world owns what they name."""
from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, Any, Callable, ClassVar, Iterable

from . import raw
from .attributes import Attributes
from .errors import Busy, CaromError, Closed, Reentrant, as_typed
from .records import BodyRecord, ColliderRecord
from ._root import count_of
from ._values import bits, describe, enum, flag, handle_of, handles_out, mask, number, record, vec3, vector, whole, word

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ._values import Vector
    from .records import BodyTypeWord, ContinuousWord, EffectWord, LocksWord, MaterialKeywords, ModeWord
    from .shape import Shape
    from .world import World


TYPES = ("static", "kinematic", "dynamic")


def pair(value: Any, name: str) -> tuple[Any, Any]:
    """Two vectors, as a pose or a velocity has them."""
    try:
        first, second = value
    except (TypeError, ValueError):
        raise ValueError(f"{name} takes two vectors, got {value!r}") from None
    return first, second


def _filter(category: int, mask_: int, group: int) -> tuple[int, int, int]:
    return mask(category, "category", 64), mask(mask_, "mask", 64), whole(group, "group", -(2**31), 2**31 - 1)


def _differ(a: list[float], b: list[float]) -> bool:
    """By more than rounding leaves."""
    return any(abs(x - y) > 1e-12 * max(map(abs, a + b)) for x, y in zip(a, b))


class Thing:
    """A handle and its world. Equal when both are; forgetting it destroys nothing."""

    __slots__ = ("world", "handle")
    _destroy: ClassVar[Any] = None

    def __init__(self, world: World, handle: int):
        self.world, self.handle = world, handle

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Thing) and type(self) is type(other) and self.handle == other.handle and self.world is other.world

    def __hash__(self) -> int:
        return hash(self.handle)

    def __repr__(self) -> str:
        what = f"carom.{type(self).__name__} {self.handle:#x}"
        try:
            return f"<{what}: {self._about()}>"
        except Closed:
            return f"<{what}, of a closed world>"
        except (Busy, Reentrant):
            return f"<{what}>"
        except ReferenceError:
            return f"<{what}, destroyed>"

    def _about(self) -> str:
        """What repr() says of it beside its handle. @raise StaleHandle  where it was destroyed"""
        raise NotImplementedError

    def _call(self, function: Callable[..., int], *arguments: object) -> None:
        self.world._call(function, self.handle, *arguments)

    def _assign(self, names: tuple[str, ...], function: Callable[..., int], *arguments: object) -> None:
        """As _call(), for what is assigned to a property that C has another word for: a refusal names what was typed.
        @param names  one for each of `arguments`"""
        try:
            self._call(function, *arguments)
        except CaromError as refused:
            raise as_typed(refused, names, 3) from None

    def _get(self, function: Callable[..., int], type: Any) -> Any:
        out = type()
        self.world._call(function, self.handle, ctypes.byref(out))
        return out.value

    def destroy(self) -> None:
        """Its handle is stale afterwards: StaleHandle."""
        self._call(self._destroy)


class Material(Thing):
    __slots__ = ()
    _destroy = staticmethod(raw.carom_material_destroy)

    @property
    def resistance(self) -> tuple[float, float]:
        """To rolling and to spinning, m"""
        rolling, spinning = ctypes.c_double(), ctypes.c_double()
        self._call(raw.carom_material_get_resistance, ctypes.byref(rolling), ctypes.byref(spinning))
        return rolling.value, spinning.value

    @resistance.setter
    def resistance(self, value: tuple[float, float]) -> None:
        self._assign(("resistance[0]", "resistance[1]"), raw.carom_material_set_resistance, *vector(value, 2, "resistance"))

    def against(self, other: Material) -> tuple[float, float, float, float]:
        """Friction, restitution, resistance to rolling and to spinning, m: what two materials are to each other."""
        surface = (ctypes.c_double * 4)()
        self._call(raw.carom_material_get_pair, handle_of(other, "other", "carom_material", False), surface)
        return tuple(surface)

    def set_against(self, other: Material, friction: float, restitution: float = 0, rolling: float = 0, spinning: float = 0) -> None:
        """Say what two materials are to each other, in place of what they mix to; @see mix_with().   @param rolling, spinning  m"""
        surface = (ctypes.c_double * 4)(number(friction, "friction"), number(restitution, "restitution"), number(rolling, "rolling"),
                                        number(spinning, "spinning"))
        self._call(raw.carom_material_set_pair, handle_of(other, "other", "carom_material", False), surface)

    def mix_with(self, other: Material) -> None:
        """Undo set_against()."""
        self._call(raw.carom_material_set_pair, handle_of(other, "other", "carom_material", False), None)

    def _about(self) -> str:
        rolling, spinning = self.resistance
        return f"resistance {rolling:g} m to rolling, {spinning:g} m to spinning"

    def update(self, **about: Unpack[MaterialKeywords]) -> None:
        """@param about  fields of carom_material_desc; those that are not named get their default; mixes in words"""
        fields: dict[str, Any] = {**about}
        for name in ("friction_mix", "restitution_mix"):
            if fields.get(name) is not None:
                fields[name] = enum("MIX", fields[name], name)
        self._call(raw.carom_material_update, ctypes.byref(describe(raw.carom_material_desc, fields)))


def collider_desc(shape: Shape, position: Vector | None, orientation: Vector | None, density: float | None,
                  material: Material | None) -> raw.carom_collider_desc:
    handle = handle_of(shape, "shape", "carom_shape", False)
    return describe(raw.carom_collider_desc, {"shape": handle, "position": position, "orientation": orientation, "density": density,
                                              "material": material})


class Body(Thing):
    __slots__ = ()
    _destroy = staticmethod(raw.carom_body_destroy)

    def _read(self, field: int, count: int) -> tuple[float, ...]:
        """One field of one body, as World.read() reads it for many."""
        out = (ctypes.c_double * count)()
        self.world._call(raw.carom_world_read, field, raw.CAROM_SCALAR_F64, ctypes.c_uint64(self.handle), 1, out, 0)
        return tuple(out)

    def _write(self, field: int, count: int, value: Iterable[float], name: str) -> None:
        self.world._call(raw.carom_world_write, field, raw.CAROM_SCALAR_F64, ctypes.c_uint64(self.handle), 1,
                         vector(value, count, name), 0)

    def _about(self) -> str:
        count = ctypes.c_uint64()
        self._call(raw.carom_body_get_colliders, None, 0, ctypes.byref(count))
        return f"{self.type}, {count_of(count.value, 'collider')}"

    @property
    def position(self) -> tuple[float, ...]:
        """m, world, of the body frame's origin"""
        return self._read(raw.CAROM_FIELD_POSITION, 3)

    @position.setter
    def position(self, value: Vector) -> None:
        self._write(raw.CAROM_FIELD_POSITION, 3, value, "position")

    @property
    def orientation(self) -> tuple[float, ...]:
        """x, y, z, w, body to world"""
        return self._read(raw.CAROM_FIELD_ORIENTATION, 4)

    @orientation.setter
    def orientation(self, value: Vector) -> None:
        self._write(raw.CAROM_FIELD_ORIENTATION, 4, value, "orientation")

    @property
    def linear_velocity(self) -> tuple[float, ...]:
        """m/s, world, of the centre of mass"""
        return self._read(raw.CAROM_FIELD_LINEAR_VELOCITY, 3)

    @linear_velocity.setter
    def linear_velocity(self, value: Vector) -> None:
        self._write(raw.CAROM_FIELD_LINEAR_VELOCITY, 3, value, "linear_velocity")

    @property
    def angular_velocity(self) -> tuple[float, ...]:
        """rad/s, world"""
        return self._read(raw.CAROM_FIELD_ANGULAR_VELOCITY, 3)

    @angular_velocity.setter
    def angular_velocity(self, value: Vector) -> None:
        self._write(raw.CAROM_FIELD_ANGULAR_VELOCITY, 3, value, "angular_velocity")

    @property
    def center(self) -> tuple[float, ...]:
        """m, world: centre of mass"""
        return self._read(raw.CAROM_FIELD_CENTER, 3)

    @property
    def pose(self) -> tuple[tuple[float, ...], tuple[float, ...]]:
        """Position, m, and orientation (x, y, z, w) in one: body.pose = other.pose."""
        both = self._read(raw.CAROM_FIELD_POSE, 7)
        return both[:3], both[3:]

    @pose.setter
    def pose(self, value: tuple[Vector, Vector]) -> None:
        self.set_pose(*pair(value, "pose"))

    @property
    def mass(self) -> float:
        """kg, 0 of what is not dynamic. Set it: the centre of mass stays and the inertia changes in proportion, and what followed
        from the colliders still does. 0: from the densities of its colliders again."""
        return self._read(raw.CAROM_FIELD_MASS, 1)[0]

    @mass.setter
    def mass(self, value: float) -> None:
        mass, center, inertia = self._masses()
        value = number(value, "mass")
        self.set_mass(value)
        if mass > 0 and value > 0:  # what was given stays: it is what the colliders do not say
            ratio = value / mass
            keep_center = center if _differ(self._masses()[1], center) else None
            if keep_center:
                self.set_mass(value, keep_center)
            inertia = [ratio * entry for entry in inertia]
            if _differ(self._masses()[2], inertia):
                self.set_mass(value, keep_center, inertia)

    def set_mass(self, mass: float, center: Vector | None = None, inertia: Vector | None = None) -> None:
        """@param mass  kg   @param center  m, body frame; None: that of its colliders   @param inertia  kg m^2, 9 numbers row by
        row, about the centre, body axes; None: that of its colliders, scaled to the mass"""
        self._call(raw.carom_body_set_mass, number(mass, "mass"), None if center is None else vec3(center, "center"),
                   None if inertia is None else vector(inertia, 9, "inertia"))

    def _masses(self) -> tuple[float, list[float], list[float]]:
        """@return mass, centre in the body frame, inertia about it"""
        mass, center, inertia = ctypes.c_double(), (ctypes.c_double * 3)(), (ctypes.c_double * 9)()
        self._call(raw.carom_body_get_mass, ctypes.byref(mass), center, inertia)
        return mass.value, list(center), list(inertia)

    @property
    def inertia(self) -> tuple[float, ...]:
        """kg m^2, 9 numbers row by row: about the centre of mass, body axes. Set it: mass and centre stay."""
        return tuple(self._masses()[2])

    @inertia.setter
    def inertia(self, value: Vector) -> None:
        mass, center, _ = self._masses()
        self.set_mass(mass, center, value)

    @property
    def type(self) -> str:
        """"static", "kinematic", "dynamic"."""
        return word("BODY", self._get(raw.carom_body_get_type, ctypes.c_uint32), TYPES)

    @type.setter
    def type(self, value: BodyTypeWord | int) -> None:
        self._call(raw.carom_body_set_type, enum("BODY", value, "type"))

    @property
    def damping(self) -> tuple[float, float]:
        """1/s: linear and angular; dv/dt = -c v"""
        linear, angular = ctypes.c_double(), ctypes.c_double()
        self._call(raw.carom_body_get_damping, ctypes.byref(linear), ctypes.byref(angular))
        return linear.value, angular.value

    @damping.setter
    def damping(self, value: tuple[float, float]) -> None:
        self._assign(("damping[0]", "damping[1]"), raw.carom_body_set_damping, *vector(value, 2, "damping"))

    @property
    def linear_damping(self) -> float:
        """1/s"""
        return self.damping[0]

    @linear_damping.setter
    def linear_damping(self, value: float) -> None:
        self._assign(("linear_damping",), raw.carom_body_set_damping, number(value, "linear_damping"), self.damping[1])

    @property
    def angular_damping(self) -> float:
        """1/s"""
        return self.damping[1]

    @angular_damping.setter
    def angular_damping(self, value: float) -> None:
        self._assign(("", "angular_damping"), raw.carom_body_set_damping, self.damping[0], number(value, "angular_damping"))

    @property
    def user(self) -> int:
        """A number of yours, 64 bits; the engine does not look."""
        return int(self._get(raw.carom_body_get_user, ctypes.c_uint64))

    @user.setter
    def user(self, value: int) -> None:
        self._call(raw.carom_body_set_user, whole(value, "user", 0, 2**64 - 1))

    @property
    def force_field_mask(self) -> int:
        """32 bits: fields that share one with it act on the body."""
        return int(self._get(raw.carom_body_get_force_field_mask, ctypes.c_uint32))

    @force_field_mask.setter
    def force_field_mask(self, value: int) -> None:
        self._call(raw.carom_body_set_force_field_mask, mask(value, "force_field_mask", 32))

    @property
    def colliders(self) -> list[Collider]:
        """Its shapes, in the order of their slots."""
        return [Collider(self.world, handle)
                for handle in handles_out(self.world._call, raw.carom_body_get_colliders, self.handle)]

    def collider(self, shape: Shape, position: Vector | None = None, orientation: Vector | None = None,
                 density: float | None = None, material: Material | None = None) -> Collider:
        """Put a shape on the body; its mass follows. @param density  kg/m^3, default 1000"""
        desc = collider_desc(shape, position, orientation, density, material)
        return self.world._create(Collider, raw.carom_collider_create, self.handle, ctypes.byref(desc))

    @property
    def desc(self) -> BodyRecord:
        """Everything there is to know, as fields of carom_body_desc; type in words."""
        desc = raw.carom_body_desc(struct_size=ctypes.sizeof(raw.carom_body_desc))
        self._call(raw.carom_body_get, ctypes.byref(desc))
        return record(BodyRecord, desc, type=word("BODY", desc.type, TYPES))

    def set_pose(self, position: Vector, orientation: Vector = (0, 0, 0, 1)) -> None:
        self._call(raw.carom_body_set_pose, vec3(position, "position"), vector(orientation, 4, "orientation"))

    def set_velocity(self, linear: Vector = (0, 0, 0), angular: Vector = (0, 0, 0)) -> None:
        self._call(raw.carom_body_set_velocity, vec3(linear, "linear"), vec3(angular, "angular"))

    def add_force(self, force: Vector, torque: Vector = (0, 0, 0), point: Vector | None = None) -> None:
        """N and N m, for the next step; with `point` the force acts there (m, world)."""
        if point is not None:
            self._call(raw.carom_body_add_force_at, vec3(force, "force"), vec3(point, "point"))
            force = (0, 0, 0)
        if point is None or any(torque):
            self._call(raw.carom_body_add_force, vec3(force, "force"), vec3(torque, "torque"))

    def add_impulse(self, impulse: Vector, point: Vector | None = None) -> None:
        """N s, at once. @param point  m, world; default the centre of mass"""
        self._call(raw.carom_body_add_impulse, vec3(impulse, "impulse"), vec3(self.center if point is None else point, "point"))

    def wake(self) -> None:
        self._call(raw.carom_body_wake)

    @property
    def asleep(self) -> bool:
        return bool(self._get(raw.carom_body_is_asleep, ctypes.c_uint32))

    @property
    def attributes(self) -> Attributes:
        """All that may be said of it beside its descriptor, by name: a mapping."""
        return Attributes(self)

    @property
    def gravity_factor(self) -> float:
        return float(self._get(raw.carom_body_get_gravity_factor, ctypes.c_double))

    @gravity_factor.setter
    def gravity_factor(self, value: float) -> None:
        self._assign(("gravity_factor",), raw.carom_body_set_gravity_factor, number(value, "gravity_factor"))

    @property
    def locks(self) -> int:
        """Axes on which it does not move: CAROM_LOCK_* bits; set also by words: {"linear_z", "angular_x"}, "plane"."""
        return int(self._get(raw.carom_body_get_locks, ctypes.c_uint32))

    @locks.setter
    def locks(self, value: int | LocksWord | Iterable[LocksWord]) -> None:
        self._call(raw.carom_body_set_locks, bits("LOCK", value, "locks"))

    @property
    def enabled(self) -> bool:
        """Whether it takes part in steps. A disabled body keeps its pose and velocity, and touches nothing."""
        return bool(self._get(raw.carom_body_is_enabled, ctypes.c_uint32))

    @enabled.setter
    def enabled(self, value: bool) -> None:
        self._call(raw.carom_body_set_enabled, flag(value, "enabled"))

    @property
    def continuous(self) -> str:
        """When it is swept: "auto", "always", "never"."""
        return word("CONTINUOUS", self._get(raw.carom_body_get_continuous, ctypes.c_uint32), ("auto", "always", "never"))

    @continuous.setter
    def continuous(self, value: ContinuousWord | int) -> None:
        self._call(raw.carom_body_set_continuous, enum("CONTINUOUS", value, "continuous"))

    @property
    def drag(self) -> tuple[float, float]:
        """kg/s and kg/m: linear and quadratic drag of the air"""
        linear, quadratic = ctypes.c_double(), ctypes.c_double()
        self._call(raw.carom_body_get_drag, ctypes.byref(linear), ctypes.byref(quadratic))
        return linear.value, quadratic.value

    @drag.setter
    def drag(self, value: tuple[float, float]) -> None:
        self._assign(("drag[0]", "drag[1]"), raw.carom_body_set_drag, *vector(value, 2, "drag"))

    def set_filter(self, category: int = 1, mask: int = 2**64 - 1, group: int = 0) -> None:
        """Of all colliders that it has now."""
        self._call(raw.carom_body_set_filter, *_filter(category, mask, group))

    def set_effect(self, effect: EffectWord | int, mode: ModeWord | int = "as_needed") -> None:
        """As World.set_effect(), for this body. @param mode  "as_needed", "forbid", "force" """
        self._call(raw.carom_body_set_effect, enum("EFFECT", effect, "effect"), enum("MODE", mode, "mode"))

    def ignore_collision(self, other: Body, ignored: bool = True) -> None:
        """The two make no contacts with each other, whatever their filters say. Calls are counted: undo each one."""
        self._call(raw.carom_body_ignore_collision, handle_of(other, "other", "carom_body", False), flag(ignored, "ignored"))


class Collider(Thing):
    __slots__ = ()
    _destroy = staticmethod(raw.carom_collider_destroy)

    @property
    def desc(self) -> ColliderRecord:
        """Fields of carom_collider_desc, and `body`."""
        desc, body = raw.carom_collider_desc(struct_size=ctypes.sizeof(raw.carom_collider_desc)), ctypes.c_uint64()
        self._call(raw.carom_collider_get, ctypes.byref(desc), ctypes.byref(body))
        return record(ColliderRecord, desc, self.world._wrap, body=Body(self.world, body.value))

    def _about(self) -> str:
        desc = self.desc
        return f"{desc.shape!r} on {desc.body!r}"

    @property
    def body(self) -> Body:
        return self.desc.body

    @property
    def density(self) -> float:
        """kg/m^3. The body's mass follows, unless it was given."""
        return self.desc.density

    @density.setter
    def density(self, value: float) -> None:
        self._call(raw.carom_collider_set_density, number(value, "density"))

    @property
    def material(self) -> Material | None:
        """None: friction 0.5, restitution 0"""
        return self.desc.material

    @material.setter
    def material(self, value: Material | None) -> None:
        self._call(raw.carom_collider_set_material, handle_of(value, "material", "carom_material"))

    @property
    def position(self) -> tuple[float, ...]:
        """m, body frame, of the shape's origin. The body's mass follows, unless it was given."""
        return self.desc.position

    @position.setter
    def position(self, value: Vector) -> None:
        self._call(raw.carom_collider_set_pose, vec3(value, "position"), vector(self.desc.orientation, 4, "orientation"))

    @property
    def orientation(self) -> tuple[float, ...]:
        """x, y, z, w, shape to body"""
        return self.desc.orientation

    @orientation.setter
    def orientation(self, value: Vector) -> None:
        self._call(raw.carom_collider_set_pose, vec3(self.desc.position, "position"), vector(value, 4, "orientation"))

    @property
    def pose(self) -> tuple[tuple[float, ...], tuple[float, ...]]:
        """Position and orientation in one."""
        desc = self.desc
        return desc.position, desc.orientation

    @pose.setter
    def pose(self, value: tuple[Vector, Vector]) -> None:
        self.set_pose(*pair(value, "pose"))

    def set_pose(self, position: Vector, orientation: Vector = (0, 0, 0, 1)) -> None:
        """In the body frame. What is remembered of its contacts is dropped."""
        self._call(raw.carom_collider_set_pose, vec3(position, "position"), vector(orientation, 4, "orientation"))

    @property
    def surface_velocity(self) -> tuple[tuple[float, ...], tuple[float, ...]]:
        """m/s and rad/s in the shape's axes, as set_surface_velocity() takes them."""
        linear, angular = (ctypes.c_double * 3)(), (ctypes.c_double * 3)()
        self._call(raw.carom_collider_get_surface_velocity, linear, angular)
        return tuple(linear), tuple(angular)

    @surface_velocity.setter
    def surface_velocity(self, value: tuple[Vector, Vector]) -> None:
        linear, angular = pair(value, "surface_velocity")
        self._assign(("surface_velocity[0]", "surface_velocity[1]"), raw.carom_collider_set_surface_velocity,
                     vec3(linear, "surface_velocity[0]"), vec3(angular, "surface_velocity[1]"))

    @property
    def filter(self) -> tuple[int, int, int]:
        """category, mask, group"""
        category, mask, group = ctypes.c_uint64(), ctypes.c_uint64(), ctypes.c_int32()
        self._call(raw.carom_collider_get_filter, ctypes.byref(category), ctypes.byref(mask), ctypes.byref(group))
        return category.value, mask.value, group.value

    @property
    def sensor(self) -> bool:
        return bool(self._get(raw.carom_collider_is_sensor, ctypes.c_uint32))

    @sensor.setter
    def sensor(self, value: bool) -> None:
        self._call(raw.carom_collider_set_sensor, flag(value, "sensor"))

    def set_filter(self, category: int = 1, mask: int = 2**64 - 1, group: int = 0) -> None:
        self._call(raw.carom_collider_set_filter, *_filter(category, mask, group))

    def set_surface_velocity(self, linear: Vector = (0, 0, 0), angular: Vector = (0, 0, 0)) -> None:
        """m/s and rad/s in the shape's axes: a conveyor belt, a turntable."""
        self._call(raw.carom_collider_set_surface_velocity, vec3(linear, "linear"), vec3(angular, "angular"))
