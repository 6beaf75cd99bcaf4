"""The kit: a character that walks through a world, a vehicle on wheels. All of their state is here, none of it in the world."""
from __future__ import annotations

import ctypes
import sys
from typing import TYPE_CHECKING, Any, Mapping, NamedTuple, Sequence, TypeVar

from . import raw
from ._values import Record, flag, handle_of, listed, number, record, set_field, shape_of, vec3, vector, whole, word
from .body import Body, Collider
from .records import VehicleRecord, WheelRecord
from .shape import Shape

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ._values import Vector
    from .records import CharacterKeywords, VehicleKeywords, WheelKeywords
    from .world import World

S = TypeVar("S", bound=ctypes.Structure)


class _Settings(Record):
    """Fields of a descriptor."""


def _filled(struct: type[S]) -> S:
    made = struct()
    getattr(raw, struct.__name__ + "_init")(ctypes.byref(made), ctypes.sizeof(made))
    return made


def _changed(desc: S, about: Mapping[str, Any], bits: Mapping[str, int]) -> S:
    """A copy with some fields changed. @param bits  of flags, by their keyword"""
    copy = type(desc).from_buffer_copy(desc)
    for key, value in about.items():
        if key in bits:
            setattr(copy, "flags", getattr(copy, "flags") & ~bits[key] | bits[key] * flag(value, key))
        elif value is not None:
            set_field(copy, key, value)
    return copy


def _settings(desc: ctypes.Structure, bits: Mapping[str, int], wrap: Any) -> Any:
    """The reverse of _changed()."""
    found = vars(record(_Settings, desc, wrap))
    flags = found.pop("flags", 0)
    found.update({key: bool(flags & bit) for key, bit in bits.items()})
    return found


def _put(structs: Sequence[ctypes.Structure], saved: bytes, what: str) -> None:
    """The reverse of save(): nothing changes where these are no bytes of it."""
    found, at = [], 0
    for each in structs:
        found.append(bytes(saved[at:at + ctypes.sizeof(each)]))
        at += ctypes.sizeof(each)
    if at != len(saved) or any(int.from_bytes(one[:4], sys.byteorder) != len(one) for one in found):
        raise ValueError(f"restore() takes the {at} bytes that save() of this {what} gave, got {len(saved)} others")
    for each, one in zip(structs, found):
        ctypes.memmove(ctypes.addressof(each), one, len(one))


class CharacterContact(NamedTuple):
    """What was in a character's way."""
    body: Body
    """which it was"""
    point: tuple[float, ...]
    """m, world, on the body"""
    normal: tuple[float, ...]
    """unit, world, from the body to the character"""
    speed: float
    """m/s, at which it would have gone on into the body"""


class Character:
    """A shape that walks: it slides along walls, climbs steps, rides what moves (carom/character.h). It is no body, and a step does
    not move it. A frame is `world.step(dt)`, `move(walk, dt)`, `push(dt)`.

    @param shape  convex; most take a capsule   @param position  m, of the shape's origin
    @param about  fields of carom_character_desc: step_up, max_slope, gravity, ...; turns=, flies="""

    __slots__ = ("world", "_desc", "_state")
    _BITS = {"turns": raw.CAROM_CHARACTER_TURNS, "flies": raw.CAROM_CHARACTER_FLIES}

    def __init__(self, world: World, shape: Shape, position: Vector = (0, 0, 0), orientation: Vector = (0, 0, 0, 1),
                 **about: Unpack[CharacterKeywords]):
        self.world = world
        self._desc = _changed(_filled(raw.carom_character_desc), about, self._BITS)
        self._state = _filled(raw.carom_character)
        self._state.position, self._state.orientation = vec3(position, "position"), vector(orientation, 4, "orientation")
        self._state = self._shaped(self._desc, self._state, shape_of(shape, "shape"), None)

    def __repr__(self) -> str:
        return f"<carom.Character: {self.ground}, at {self.position}>"

    def _shaped(self, desc: raw.carom_character_desc, state: raw.carom_character, shape: int, fits: Any) -> raw.carom_character:
        """carom_character_set_shape() on a copy, so that what is refused changes nothing."""
        state = raw.carom_character.from_buffer_copy(state)
        self.world._call(lambda world, *rest: raw.carom_character_set_shape(self.world.engine._pointer, world, *rest),
                         ctypes.byref(desc), ctypes.byref(state), shape, fits)
        return state

    def update(self, **about: Unpack[CharacterKeywords]) -> None:
        """Change some of its settings; the others stay."""
        desc = _changed(self._desc, about, self._BITS)
        self._state, self._desc = self._shaped(desc, self._state, self._state.shape, None), desc

    @property
    def settings(self) -> CharacterKeywords:
        """All of them, as update() takes them."""
        return _settings(self._desc, self._BITS, self.world._wrap)  # type: ignore[no-any-return]

    def set_shape(self, shape: Shape, always: bool = False) -> bool:
        """Another shape: to crouch, to stand up. Its lowest point stays where it is. @param always  whatever is in its place
        @return False: there is no place for it, and nothing has changed"""
        fits = ctypes.c_uint32(1)
        asked = None if flag(always, "always") else ctypes.byref(fits)
        self._state = self._shaped(self._desc, self._state, shape_of(shape, "shape"), asked)
        return bool(fits.value)

    def move(self, walk: Vector, dt: float = 1 / 60, jump: float = 0) -> None:
        """By dt, s. @param walk  m/s, world, relative to the ground   @param jump  m/s, taken off with from firm ground"""
        self.world._call(raw.carom_character_move, ctypes.byref(self._desc), ctypes.byref(self._state), vec3(walk, "walk"),
                         number(jump, "jump"), number(dt, "dt"))

    def push(self, dt: float = 1 / 60) -> None:
        """Leave forces on what the last move met and on what it stands on, for the next step, of dt, s."""
        self.world._call(raw.carom_character_push, ctypes.byref(self._desc), ctypes.byref(self._state), number(dt, "dt"))

    def move_body(self, dt: float = 1 / 60) -> None:
        """Let the kinematic body `body=` of its settings follow in the next step, of dt, s."""
        self.world._call(raw.carom_character_move_body, ctypes.byref(self._desc), ctypes.byref(self._state), number(dt, "dt"))

    def save(self) -> bytes:
        """Where it is and how it moves; settings are not in it. With `world.save()` of the same moment all goes on bit for bit."""
        return bytes(self._state)

    def restore(self, saved: bytes) -> None:
        _put([self._state], saved, "character")

    @property
    def shape(self) -> Shape:
        return Shape(self.world.engine, self._state.shape)

    @property
    def position(self) -> tuple[float, ...]:
        """m, of the shape's origin. Setting it teleports: it is in the air until the next move."""
        return tuple(self._state.position)

    @position.setter
    def position(self, value: Vector) -> None:
        self._state.position, self._state.ground = vec3(value, "position"), raw.CAROM_GROUND_AIR

    @property
    def orientation(self) -> tuple[float, ...]:
        """x, y, z, w. Its lowest point stays where it is."""
        return tuple(self._state.orientation)

    @orientation.setter
    def orientation(self, value: Vector) -> None:
        state = raw.carom_character.from_buffer_copy(self._state)
        state.orientation = vector(value, 4, "orientation")
        self._state = self._shaped(self._desc, state, state.shape, None)

    @property
    def velocity(self) -> tuple[float, ...]:
        """m/s: on firm ground along it and relative to it, else in the world."""
        return tuple(self._state.velocity)

    @velocity.setter
    def velocity(self, value: Vector) -> None:
        self._state.velocity = vec3(value, "velocity")

    @property
    def foot(self) -> float:
        """m, from the origin down to the lowest point."""
        return float(self._state.foot)

    @property
    def ground(self) -> str:
        """"firm": it can walk and jump; "steep": it slides; "air": it falls."""
        return word("GROUND", self._state.ground, ("air", "steep", "firm"))

    @property
    def ground_body(self) -> Body | None:
        """What it stands on or slides down."""
        return Body(self.world, self._state.ground_body) if self._state.ground_body else None

    @property
    def ground_collider(self) -> Collider | None:
        """Of ground_body."""
        return Collider(self.world, self._state.ground_collider) if self._state.ground_collider else None

    @property
    def ground_point(self) -> tuple[float, ...]:
        """m, world."""
        return tuple(self._state.ground_point)

    @property
    def ground_normal(self) -> tuple[float, ...]:
        """Unit, world, from the ground to it."""
        return tuple(self._state.ground_normal)

    @property
    def ground_velocity(self) -> tuple[float, ...]:
        """m/s, world, of the ground under it; in the air of the ground that it left."""
        return tuple(self._state.ground_velocity)

    @property
    def contacts(self) -> list[CharacterContact]:
        """What was in its way in the last move."""
        s: Any = self._state
        return [CharacterContact(Body(self.world, s.contact_bodies[i]), tuple(s.contact_points[3 * i:3 * i + 3]),
                                 tuple(s.contact_normals[3 * i:3 * i + 3]), s.contact_speeds[i]) for i in range(s.contact_count)]


class Wheel:
    """One wheel of a vehicle; no body."""

    __slots__ = ("vehicle", "index")

    def __init__(self, vehicle: Vehicle, index: int):
        self.vehicle, self.index = vehicle, index

    def __repr__(self) -> str:
        return f"<carom.Wheel {self.index}: {'on the ground' if self.state.touches else 'in the air'}>"

    def update(self, **about: Unpack[WheelKeywords]) -> None:
        """Change some of its settings; the others stay."""
        self.vehicle._wheel_descs[self.index] = _changed(self.vehicle._wheel_descs[self.index], about, {})

    @property
    def settings(self) -> WheelKeywords:
        """All of them, as update() takes them."""
        return _settings(self.vehicle._wheel_descs[self.index], {}, self.vehicle.world._wrap)  # type: ignore[no-any-return]

    @property
    def state(self) -> WheelRecord:
        """What it stands on, its load, forces and slips, after the last drive."""
        one = self.vehicle._wheels[self.index]
        return record(WheelRecord, one, self.vehicle.world._wrap, touches=bool(one.touches))

    @property
    def spin(self) -> float:
        """rad/s, forward"""
        return float(self.vehicle._wheels[self.index].spin)

    @spin.setter
    def spin(self, value: float) -> None:
        self.vehicle._wheels[self.index].spin = number(value, "spin")


class Vehicle:
    """A dynamic body on wheels that are no bodies: springs, tyres, an engine (carom/vehicle.h). A frame is `drive(dt, ...)`, then
    `world.step(dt)`.

    @param wheels  keywords of each: dict(position=(0.75, -0.3, 1.3), max_steer=0.6), ...
    @param about  fields of carom_vehicle_desc: gears=(3.5, 2.1), final_drive, ...; torque_curve=[(rad/s, N m), ...];
                  automatic=, ackermann="""

    __slots__ = ("chassis", "wheels", "_desc", "_state", "_wheel_descs", "_wheels")
    _BITS = {"automatic": raw.CAROM_VEHICLE_AUTOMATIC, "ackermann": raw.CAROM_VEHICLE_ACKERMANN}

    def __init__(self, chassis: Body, wheels: Sequence[WheelKeywords], **about: Unpack[VehicleKeywords]):
        handle_of(chassis, "chassis", "carom_body", False)
        all_about = listed(wheels, "wheels", "keywords of each: [dict(position=(0.75, -0.3, 1.3)), ...]")
        if not 1 <= len(all_about) <= raw.CAROM_VEHICLE_WHEELS:
            raise ValueError(f"wheels takes 1 to {raw.CAROM_VEHICLE_WHEELS}, got {len(all_about)}")
        self.chassis = chassis
        self._desc = _filled(raw.carom_vehicle_desc)
        self._desc.chassis = chassis.handle
        self.update(**about)
        self._state = _filled(raw.carom_vehicle)
        self._wheel_descs = (raw.carom_wheel_desc * len(all_about))(
            *(_changed(_filled(raw.carom_wheel_desc), each, {}) for each in all_about))
        self._wheels = (raw.carom_wheel * len(all_about))(*(_filled(raw.carom_wheel) for _ in all_about))
        self.wheels = tuple(Wheel(self, i) for i in range(len(all_about)))

    def __repr__(self) -> str:
        return f"<carom.Vehicle on {len(self.wheels)} wheels: gear {self.gear}, {self.speed:.6g} m/s>"

    @property
    def world(self) -> World:
        return self.chassis.world

    def update(self, **about: Unpack[VehicleKeywords]) -> None:
        """Change some of its settings; the others stay."""
        rest: dict[str, Any] = dict(about)
        gears, curve = rest.pop("gears", None), rest.pop("torque_curve", None)
        desc = _changed(self._desc, rest, self._BITS)
        if gears is not None:
            desc.gear_count = _put_numbers(desc.gears, gears, "gears")
        if curve is not None:
            rows = [vector(row, 2, f"torque_curve[{i}]") for i, row in enumerate(listed(curve, "torque_curve", "[(rad/s, N m), ...]"))]
            desc.torque_count = _put_numbers(desc.torque_speeds, [row[0] for row in rows], "torque_curve")
            _put_numbers(desc.torques, [row[1] for row in rows], "torque_curve")
        self._desc = desc

    @property
    def settings(self) -> VehicleKeywords:
        """All of them, as update() takes them."""
        found = _settings(self._desc, self._BITS, None)
        found["gears"] = found["gears"][:found.pop("gear_count")]
        found["torque_curve"] = list(zip(found.pop("torque_speeds"), found.pop("torques")))[:found.pop("torque_count")]
        del found["chassis"]
        return found  # type: ignore[no-any-return]

    def drive(self, dt: float = 1 / 60, throttle: float = 0, brake: float = 0, handbrake: float = 0, steer: float = 0,
              gear: int = 1) -> None:
        """Turn wheels and engine through dt, s, and leave forces for the next step, which is to take dt.
        @param throttle, brake, handbrake  [0, 1]   @param steer  [-1, 1], 1: to the left   @param gear  0: neutral, -1: reverse"""
        given = _filled(raw.carom_vehicle_input)
        given.throttle, given.brake, given.handbrake = number(throttle, "throttle"), number(brake, "brake"), number(handbrake, "handbrake")
        given.steer, given.gear = number(steer, "steer"), whole(gear, "gear", -1, 2**31 - 1, usual=1)
        self.world._call(raw.carom_vehicle_drive, ctypes.byref(self._desc), self._wheel_descs, len(self._wheels), ctypes.byref(given),
                         ctypes.byref(self._state), self._wheels, number(dt, "dt"))

    def save(self) -> bytes:
        """Of engine, gears and wheels; the chassis is in `world.save()`, and settings are in neither."""
        return bytes(self._state) + bytes(self._wheels)

    def restore(self, saved: bytes) -> None:
        _put([self._state, *self._wheels], saved, "vehicle")

    @property
    def state(self) -> VehicleRecord:
        """Engine and gears, after the last drive."""
        return record(VehicleRecord, self._state)

    @property
    def speed(self) -> float:
        """m/s, of the chassis, forward, at the last drive."""
        return float(self._state.speed)

    @property
    def gear(self) -> int:
        """That is in, or that is being put in."""
        return int(self._state.gear)


def _put_numbers(array: Any, values: Any, name: str) -> int:
    """@return how many there are: one at least, and no more than fit"""
    given = listed(values, name, f"1 to {len(array)} numbers")
    if not 1 <= len(given) <= len(array):
        raise ValueError(f"{name} takes 1 to {len(array)}, got {len(given)}")
    for i, value in enumerate(given):
        array[i] = number(value, f"{name}[{i}]")
    return len(given)
