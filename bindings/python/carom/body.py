"""Bodies, colliders, materials: light objects around handles. The world owns what they name."""
from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, Any, Callable, ClassVar, Iterable

from . import raw
from .attributes import Attributes
from .records import BodyRecord, ColliderRecord
from ._values import bits, describe, enum, record, vec3, vector, word

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ._values import Vector
    from .records import ContinuousWord, LocksWord, MaterialKeywords
    from .shape import Shape
    from .world import World


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
        return f"<carom.{type(self).__name__} {self.handle:#x}>"

    def _call(self, function: Callable[..., int], *arguments: object) -> None:
        self.world._call(function, self.handle, *arguments)

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
        self._call(raw.carom_material_set_resistance, *value)

    def update(self, **about: Unpack[MaterialKeywords]) -> None:
        """@param about  fields of carom_material_desc; those that are not named get their default"""
        self._call(raw.carom_material_update, ctypes.byref(describe(raw.carom_material_desc, about)))


class Body(Thing):
    __slots__ = ()
    _destroy = staticmethod(raw.carom_body_destroy)

    def _read(self, field: int, count: int) -> tuple[float, ...]:
        """One field of one body, as World.read() reads it for many."""
        out = (ctypes.c_double * count)()
        self.world._call(raw.carom_world_read, field, raw.CAROM_SCALAR_F64, ctypes.c_uint64(self.handle), 1, out, 0)
        return tuple(out)

    def _write(self, field: int, count: int, value: Iterable[float]) -> None:
        self.world._call(raw.carom_world_write, field, raw.CAROM_SCALAR_F64, ctypes.c_uint64(self.handle), 1,
                         vector(value, count, "value"), 0)

    @property
    def position(self) -> tuple[float, ...]:
        """m, world, of the body frame's origin"""
        return self._read(raw.CAROM_FIELD_POSITION, 3)

    @position.setter
    def position(self, value: Vector) -> None:
        self._write(raw.CAROM_FIELD_POSITION, 3, value)

    @property
    def orientation(self) -> tuple[float, ...]:
        """x, y, z, w, body to world"""
        return self._read(raw.CAROM_FIELD_ORIENTATION, 4)

    @orientation.setter
    def orientation(self, value: Vector) -> None:
        self._write(raw.CAROM_FIELD_ORIENTATION, 4, value)

    @property
    def linear_velocity(self) -> tuple[float, ...]:
        """m/s, world, of the centre of mass"""
        return self._read(raw.CAROM_FIELD_LINEAR_VELOCITY, 3)

    @linear_velocity.setter
    def linear_velocity(self, value: Vector) -> None:
        self._write(raw.CAROM_FIELD_LINEAR_VELOCITY, 3, value)

    @property
    def angular_velocity(self) -> tuple[float, ...]:
        """rad/s, world"""
        return self._read(raw.CAROM_FIELD_ANGULAR_VELOCITY, 3)

    @angular_velocity.setter
    def angular_velocity(self, value: Vector) -> None:
        self._write(raw.CAROM_FIELD_ANGULAR_VELOCITY, 3, value)

    @property
    def center(self) -> tuple[float, ...]:
        """m, world: centre of mass"""
        return self._read(raw.CAROM_FIELD_CENTER, 3)

    @property
    def mass(self) -> float:
        """kg"""
        return self._read(raw.CAROM_FIELD_MASS, 1)[0]

    def collider(self, shape: Shape, position: Vector | None = None, orientation: Vector | None = None,
                 density: float | None = None, material: Material | None = None) -> Collider:
        """Put a shape on the body; its mass follows. @param density  kg/m^3, default 1000"""
        desc = describe(raw.carom_collider_desc, {"shape": shape, "position": position, "orientation": orientation,
                                                  "density": density, "material": material})
        return self.world._create(Collider, raw.carom_collider_create, self.handle, ctypes.byref(desc))

    @property
    def desc(self) -> BodyRecord:
        """Everything there is to know, as fields of carom_body_desc; type in words."""
        desc = raw.carom_body_desc(struct_size=ctypes.sizeof(raw.carom_body_desc))
        self._call(raw.carom_body_get, ctypes.byref(desc))
        return record(BodyRecord, desc, type=word("BODY", desc.type, ("static", "kinematic", "dynamic")))

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
        self._call(raw.carom_body_set_gravity_factor, value)

    @property
    def locks(self) -> int:
        """Axes on which it does not move: CAROM_LOCK_* bits; set also by words: {"linear_z", "angular_x"}, "plane"."""
        return int(self._get(raw.carom_body_get_locks, ctypes.c_uint32))

    @locks.setter
    def locks(self, value: int | LocksWord | Iterable[LocksWord]) -> None:
        self._call(raw.carom_body_set_locks, bits("LOCK", value))

    @property
    def enabled(self) -> bool:
        """Whether it takes part in steps. A disabled body keeps its pose and velocity, and touches nothing."""
        return bool(self._get(raw.carom_body_is_enabled, ctypes.c_uint32))

    @enabled.setter
    def enabled(self, value: bool) -> None:
        self._call(raw.carom_body_set_enabled, int(value))

    @property
    def continuous(self) -> str:
        """When it is swept: "auto", "always", "never"."""
        return word("CONTINUOUS", self._get(raw.carom_body_get_continuous, ctypes.c_uint32), ("auto", "always", "never"))

    @continuous.setter
    def continuous(self, value: ContinuousWord | int) -> None:
        self._call(raw.carom_body_set_continuous, enum("CONTINUOUS", value))

    @property
    def drag(self) -> tuple[float, float]:
        """kg/s and kg/m: linear and quadratic drag of the air"""
        linear, quadratic = ctypes.c_double(), ctypes.c_double()
        self._call(raw.carom_body_get_drag, ctypes.byref(linear), ctypes.byref(quadratic))
        return linear.value, quadratic.value

    @drag.setter
    def drag(self, value: tuple[float, float]) -> None:
        self._call(raw.carom_body_set_drag, *value)

    def set_filter(self, category: int = 1, mask: int = 2**64 - 1, group: int = 0) -> None:
        """Of all colliders that it has now."""
        self._call(raw.carom_body_set_filter, category, mask, group)

    def ignore_collision(self, other: Body, ignored: bool = True) -> None:
        """The two make no contacts with each other, whatever their filters say. Calls are counted: undo each one."""
        self._call(raw.carom_body_ignore_collision, other.handle, int(ignored))


class Collider(Thing):
    __slots__ = ()
    _destroy = staticmethod(raw.carom_collider_destroy)

    @property
    def desc(self) -> ColliderRecord:
        """Fields of carom_collider_desc, and `body`."""
        desc, body = raw.carom_collider_desc(struct_size=ctypes.sizeof(raw.carom_collider_desc)), ctypes.c_uint64()
        self._call(raw.carom_collider_get, ctypes.byref(desc), ctypes.byref(body))
        return record(ColliderRecord, desc, self.world._wrap, body=Body(self.world, body.value))

    @property
    def sensor(self) -> bool:
        return bool(self._get(raw.carom_collider_is_sensor, ctypes.c_uint32))

    @sensor.setter
    def sensor(self, value: bool) -> None:
        self._call(raw.carom_collider_set_sensor, int(value))

    def set_filter(self, category: int = 1, mask: int = 2**64 - 1, group: int = 0) -> None:
        self._call(raw.carom_collider_set_filter, category, mask, group)

    def set_surface_velocity(self, linear: Vector = (0, 0, 0), angular: Vector = (0, 0, 0)) -> None:
        """m/s and rad/s in the shape's axes: a conveyor belt, a turntable."""
        self._call(raw.carom_collider_set_surface_velocity, vec3(linear, "linear"), vec3(angular, "angular"))
