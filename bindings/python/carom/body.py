"""Bodies, colliders, materials: light objects around handles. The world owns what they name."""
from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, Any, ClassVar, Sequence

from . import raw
from .attributes import Attributes
from ._values import bits, describe, enum, record, vec3, vector, word

if TYPE_CHECKING:
    from .shape import Shape
    from .world import World


class Thing:
    """A handle and its world. Equal when both are; forgetting it destroys nothing."""

    __slots__ = ("world", "handle")
    _destroy: ClassVar[Any] = None

    def __init__(self, world: World, handle: int):
        self.world, self.handle = world, handle

    def __eq__(self, other):
        return type(self) is type(other) and self.handle == other.handle and self.world is other.world

    def __hash__(self):
        return hash(self.handle)

    def __repr__(self):
        return f"<carom.{type(self).__name__} {self.handle:#x}>"

    def _call(self, function, *arguments):
        self.world._call(function, self.handle, *arguments)

    def _get(self, function, type):
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

    def update(self, **about) -> None:
        """@param about  fields of carom_material_desc; those that are not named get their default"""
        self._call(raw.carom_material_update, ctypes.byref(describe(raw.carom_material_desc, about)))


def _field(field, count, doc):
    """One field of one body, as World.read() reads it for many."""
    def get(self):
        out = (ctypes.c_double * count)()
        self.world._call(raw.carom_world_read, field, raw.CAROM_SCALAR_F64, ctypes.c_uint64(self.handle), 1, out, 0)
        return tuple(out) if count > 1 else out[0]

    def set(self, value):
        self.world._call(raw.carom_world_write, field, raw.CAROM_SCALAR_F64, ctypes.c_uint64(self.handle), 1,
                         vector(value, count, "value"), 0)
    return property(get, None if field >= raw.CAROM_FIELD_CENTER else set, doc=doc)


class Body(Thing):
    __slots__ = ()
    _destroy = staticmethod(raw.carom_body_destroy)

    position = _field(raw.CAROM_FIELD_POSITION, 3, "m, world, of the body frame's origin")
    orientation = _field(raw.CAROM_FIELD_ORIENTATION, 4, "x, y, z, w, body to world")
    linear_velocity = _field(raw.CAROM_FIELD_LINEAR_VELOCITY, 3, "m/s, world, of the centre of mass")
    angular_velocity = _field(raw.CAROM_FIELD_ANGULAR_VELOCITY, 3, "rad/s, world")
    center = _field(raw.CAROM_FIELD_CENTER, 3, "m, world: centre of mass")
    mass = _field(raw.CAROM_FIELD_MASS, 1, "kg")

    def collider(self, shape: Shape, position: Sequence[float] | None = None, orientation: Sequence[float] | None = None,
                 density: float | None = None, material: Material | None = None) -> Collider:
        """Put a shape on the body; its mass follows. @param density  kg/m^3, default 1000"""
        desc = describe(raw.carom_collider_desc, {"shape": shape, "position": position, "orientation": orientation,
                                                  "density": density, "material": material})
        return self.world._create("carom_collider", raw.carom_collider_create, self.handle, ctypes.byref(desc))

    @property
    def desc(self):
        """Everything there is to know, as fields of carom_body_desc; type in words."""
        desc = raw.carom_body_desc(struct_size=ctypes.sizeof(raw.carom_body_desc))
        self._call(raw.carom_body_get, ctypes.byref(desc))
        return record(desc, type=word("BODY", desc.type, ("static", "kinematic", "dynamic")))

    def set_pose(self, position: Sequence[float], orientation: Sequence[float] = (0, 0, 0, 1)) -> None:
        self._call(raw.carom_body_set_pose, vec3(position, "position"), vector(orientation, 4, "orientation"))

    def set_velocity(self, linear: Sequence[float] = (0, 0, 0), angular: Sequence[float] = (0, 0, 0)) -> None:
        self._call(raw.carom_body_set_velocity, vec3(linear, "linear"), vec3(angular, "angular"))

    def add_force(self, force: Sequence[float], torque: Sequence[float] = (0, 0, 0), point: Sequence[float] | None = None) -> None:
        """N and N m, for the next step; with `point` the force acts there (m, world)."""
        if point is not None:
            self._call(raw.carom_body_add_force_at, vec3(force, "force"), vec3(point, "point"))
            force = (0, 0, 0)
        if point is None or any(torque):
            self._call(raw.carom_body_add_force, vec3(force, "force"), vec3(torque, "torque"))

    def add_impulse(self, impulse: Sequence[float], point: Sequence[float] | None = None) -> None:
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
        return self._get(raw.carom_body_get_gravity_factor, ctypes.c_double)

    @gravity_factor.setter
    def gravity_factor(self, value: float) -> None:
        self._call(raw.carom_body_set_gravity_factor, value)

    @property
    def locks(self) -> int:
        """Axes on which it does not move: CAROM_LOCK_* bits; set also by words: {"linear_z", "angular_x"}, "plane"."""
        return self._get(raw.carom_body_get_locks, ctypes.c_uint32)

    @locks.setter
    def locks(self, value) -> None:
        self._call(raw.carom_body_set_locks, bits("LOCK", value))

    @property
    def continuous(self) -> str:
        """When it is swept: "auto", "always", "never"."""
        return word("CONTINUOUS", self._get(raw.carom_body_get_continuous, ctypes.c_uint32), ("auto", "always", "never"))

    @continuous.setter
    def continuous(self, value: str | int) -> None:
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

    def hold_apart(self, other: Body, apart: bool = True) -> None:
        """The two make no contacts with each other."""
        self._call(raw.carom_body_hold_apart, other.handle, int(apart))


class Collider(Thing):
    __slots__ = ()
    _destroy = staticmethod(raw.carom_collider_destroy)

    @property
    def desc(self):
        """Fields of carom_collider_desc, and `body`."""
        desc, body = raw.carom_collider_desc(struct_size=ctypes.sizeof(raw.carom_collider_desc)), ctypes.c_uint64()
        self._call(raw.carom_collider_get, ctypes.byref(desc), ctypes.byref(body))
        return record(desc, self.world._wrap, body=Body(self.world, body.value))

    @property
    def sensor(self) -> bool:
        return bool(self._get(raw.carom_collider_is_sensor, ctypes.c_uint32))

    @sensor.setter
    def sensor(self, value: bool) -> None:
        self._call(raw.carom_collider_set_sensor, int(value))

    def set_filter(self, category: int = 1, mask: int = 2**64 - 1, group: int = 0) -> None:
        self._call(raw.carom_collider_set_filter, category, mask, group)

    def set_surface_velocity(self, linear: Sequence[float] = (0, 0, 0), angular: Sequence[float] = (0, 0, 0)) -> None:
        """m/s and rad/s in the shape's axes: a conveyor belt, a turntable."""
        self._call(raw.carom_collider_set_surface_velocity, vec3(linear, "linear"), vec3(angular, "angular"))
