"""Joints: what holds two bodies together, or one to the world; limits, motors and springs of what is left free."""
from __future__ import annotations

import ctypes
import math
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any, Callable, Mapping, TypeVar

from . import raw
from ._values import Record, describe, enum, handle_of, number, record, set_field, vec3, whole
from .body import Thing
from .records import (JointAxisRecord, JointCouplingRecord, JointLimitRecord, JointMotorRecord, JointOrientationDriveRecord, JointRecord, JointSpringRecord,
                      JointStateRecord, JointTransmissionRecord)

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ._values import Vector
    from .body import Body
    from .records import (AxisWord, CoordinateWord, JointAxisKeywords, JointKeywords, JointLimitKeywords, JointMotorKeywords,
                          JointOrientationDriveKeywords, JointSpringKeywords, JointTransmissionKeywords, JointWord)
    from .world import World

R = TypeVar("R", bound=Record)

COORDINATES = ("twist", "swing", "slide", "distance")
AXES = ("x", "y", "z", "turn_x", "turn_y", "turn_z")
MODES, DRIVES, GAINS = ("free", "locked", "limited"), ("none", "position", "velocity", "effort"), ("frequency", "force", "acceleration")


def turn_x_to(axis: Vector) -> tuple[float, ...]:
    """The shortest turn (x, y, z, w) that brings the x axis to `axis`, any length."""
    x, y, z = vec3(axis, "axis")
    length = math.sqrt(x * x + y * y + z * z)
    if not length:
        raise ValueError("axis is (0, 0, 0), which has no direction; type axis=(0, 0, 1) for one along z")
    x, y, z = x / length, y / length, z / length
    if x < -1 + 1e-12:
        return 0.0, 0.0, 1.0, 0.0
    w = math.sqrt((1 + x) / 2)
    return 0.0, -z / (2 * w), y / (2 * w), w


def make_joint(world: World, kind: JointWord | int, a: Body | None, b: Body | None, position: Vector | None, orientation: Vector | None,
               axis: Vector | None, about: Mapping[str, Any]) -> Joint:
    """World.joint(). With `position` the joint is placed in the world as the bodies stand now; `axis` is the direction of its
    x axis there (of a hinge, of a slider), or `orientation` says more. Else position_a, position_b, ... are in the bodies'
    frames. Also: length, break_force, break_torque, collide=True, accelerations=True
    (each step measures them), user."""
    about = dict(about)
    fields = raw.CAROM_JOINT_COLLIDE if about.pop("collide", False) else 0
    if about.pop("accelerations", False):
        fields |= raw.CAROM_JOINT_ACCELERATIONS
    if axis is not None:
        orientation = turn_x_to(axis)
    if position is not None or orientation is not None:
        fields |= raw.CAROM_JOINT_WORLD_FRAME
        about.update(position_a=(0, 0, 0) if position is None else position, orientation_a=orientation)
    if about.get("length") is not None:
        fields |= raw.CAROM_JOINT_FIELD_LENGTH
    about.update(kind=enum("JOINT", kind, "kind"), fields=fields, body_a=handle_of(a, "a", "carom_body"),
                 body_b=handle_of(b, "b", "carom_body"))
    return world._create(Joint, raw.carom_joint_create, ctypes.byref(describe(raw.carom_joint_desc, about)))


def _polynomial(numbers: Iterable[float]) -> list[float]:
    if not isinstance(numbers, Iterable):
        raise TypeError(f"polynomial takes at most five numbers, the constant one first, got {numbers!r}")
    given = [number(x, "polynomial") for x in numbers]
    if len(given) > 5:
        raise ValueError(f"polynomial has {len(given)} numbers; it is of degree 4 at most: five numbers, the constant one first")
    return given + [0.0] * (5 - len(given))


def make_coupling(world: World, follower: Joint, leader: Joint, polynomial: Iterable[float], user: int) -> Joint:
    about = {"follower": handle_of(follower, "follower", "carom_joint", False), "leader": handle_of(leader, "leader", "carom_joint", False),
             "polynomial": _polynomial(polynomial), "user": whole(user, "user", 0, 2**64 - 1)}
    return world._create(Joint, raw.carom_joint_couple, ctypes.byref(describe(raw.carom_joint_coupling, about)))


def _with_numbers(about: Mapping[str, Any]) -> dict[str, Any]:
    """Words for modes, drives and gains as their numbers."""
    prefixes = {"mode": "AXIS_MODE", "drive": "DRIVE"}
    return {name: enum("GAINS" if name.endswith("gains") else prefixes[name], value, name)
            if name in prefixes or name.endswith("gains") else value for name, value in about.items()}


class Joint(Thing):
    """Coordinates: "twist" and "swing", rad; "slide" and "distance", m."""

    __slots__ = ()
    _destroy = staticmethod(raw.carom_joint_destroy)

    def _about(self) -> str:
        desc = self.desc
        return f"{desc.kind} of {desc.body_a!r} and {desc.body_b!r}"

    @property
    def desc(self) -> JointRecord:
        desc = raw.carom_joint_desc(struct_size=ctypes.sizeof(raw.carom_joint_desc))
        self._call(raw.carom_joint_get, ctypes.byref(desc))
        return record(JointRecord, desc, self.world._wrap, kind=raw.carom_joint_kind_name(desc.kind).decode())

    @property
    def state(self) -> JointStateRecord:
        """broken, force (N) and torque (N m) on B over the last step, gap (m), angle (rad), coordinate and axis
        {name: value}."""
        state = raw.carom_joint_state(struct_size=ctypes.sizeof(raw.carom_joint_state))
        self._call(raw.carom_joint_get_state, ctypes.byref(state))
        return record(JointStateRecord, state, broken=bool(state.broken), coordinate=dict(zip(COORDINATES, state.coordinate)),
                      axis=dict(zip(AXES, state.axis)))

    def transmission(self, **about: Unpack[JointTransmissionKeywords]) -> JointTransmissionRecord:
        """Of a pulley or a gear. Read it, or with ratio=, and of a pulley anchor_a=, anchor_b= (m, world), length=, set it;
        without a length the rope is as long as it is now."""
        struct = raw.carom_joint_transmission
        if about:
            if about.get("length") is not None:
                about["fields"] = raw.CAROM_JOINT_FIELD_LENGTH
            self._call(raw.carom_joint_set_transmission, ctypes.byref(describe(struct, about)))
        now = struct(struct_size=ctypes.sizeof(struct))
        self._call(raw.carom_joint_get_transmission, ctypes.byref(now))
        return record(JointTransmissionRecord, now)

    def coupling(self, polynomial: Iterable[float] | None = None) -> JointCouplingRecord:
        """Of a joint that World.couple() made. Read follower, leader and polynomial, or give it another polynomial."""
        struct = raw.carom_joint_coupling
        if polynomial is not None:
            self._call(raw.carom_joint_set_coupling, ctypes.byref(describe(struct, {"polynomial": _polynomial(polynomial)})))
        now = struct(struct_size=ctypes.sizeof(struct))
        self._call(raw.carom_joint_get_coupling, ctypes.byref(now))
        return record(JointCouplingRecord, now, self.world._wrap)

    def axis(self, axis: AxisWord | int, **about: Unpack[JointAxisKeywords]) -> JointAxisRecord:
        """Of a six-axis joint; "turn_x" of a hinge, "x" of a slider. Read what an axis ("x", ..., "turn_z") does, or set it, all of it: mode="free", "locked" or
        "limited", lower=, upper= (m or rad); drive="position", "velocity" or "effort", with target=, speed=, effort=, max_force=,
        drive_stiffness=, drive_damping=; rest=, spring_stiffness=, spring_damping=; stop_stiffness=, stop_damping=; and in what
        those are, stop_gains=, drive_gains=, spring_gains="frequency", "force" or "acceleration"; friction= (N or N m) and
        armature= (kg or kg m^2); effort_limit= (N or N m, of its drives together) and speed_limit= (m/s or rad/s)."""
        number, struct = enum("AXIS", axis, "axis"), raw.carom_joint_axis
        if about:
            self._call(raw.carom_joint_set_axis, number, ctypes.byref(describe(struct, _with_numbers(about))))
        now = struct(struct_size=ctypes.sizeof(struct))
        self._call(raw.carom_joint_get_axis, number, ctypes.byref(now))
        return record(JointAxisRecord, now, mode=MODES[now.mode], drive=DRIVES[now.drive],
                      **{name: GAINS[getattr(now, name)] for name in ("stop_gains", "drive_gains", "spring_gains")})

    def orientation_drive(self, **about: Unpack[JointOrientationDriveKeywords]) -> JointOrientationDriveRecord:
        """Of a ball or a six-axis joint. Read the drive to an orientation, or set it: drive="position" with target= (x, y, z, w: B's
        frame in A's), velocity= (rad/s, A's frame), stiffness=, damping=, gains=; "velocity"; "effort" with effort= (N m); max_force=."""
        struct = raw.carom_joint_orientation_drive
        if about:
            self._call(raw.carom_joint_set_orientation_drive, ctypes.byref(describe(struct, _with_numbers(about))))
        now = struct(struct_size=ctypes.sizeof(struct))
        self._call(raw.carom_joint_get_orientation_drive, ctypes.byref(now))
        return record(JointOrientationDriveRecord, now, drive=DRIVES[now.drive], gains=GAINS[now.gains])

    def _part(self, kind: type[R], struct: Any, get: Callable[..., int], set: Callable[..., int], coordinate: str | int,
              about: Mapping[str, Any]) -> R:
        number = enum("COORDINATE", coordinate, "coordinate")
        desc = struct(struct_size=ctypes.sizeof(struct))
        self._call(get, number, ctypes.byref(desc))
        if about:
            for key, value in {"enabled": True, **about}.items():
                set_field(desc, key, value)
            self._call(set, number, ctypes.byref(desc))
        return record(kind, desc, enabled=bool(desc.enabled))

    def limit(self, coordinate: CoordinateWord | int, **about: Unpack[JointLimitKeywords]) -> JointLimitRecord:
        """Read a limit, or with lower=, upper= (or enabled=False) set it."""
        return self._part(JointLimitRecord, raw.carom_joint_limit, raw.carom_joint_get_limit, raw.carom_joint_set_limit, coordinate, about)

    def motor(self, coordinate: CoordinateWord | int, **about: Unpack[JointMotorKeywords]) -> JointMotorRecord:
        """Likewise: speed=, m/s or rad/s, max_force=, N or N m."""
        return self._part(JointMotorRecord, raw.carom_joint_motor, raw.carom_joint_get_motor, raw.carom_joint_set_motor, coordinate, about)

    def spring(self, coordinate: CoordinateWord | int, **about: Unpack[JointSpringKeywords]) -> JointSpringRecord:
        """Likewise: target=, frequency=, Hz, damping=, ratio, max_force=."""
        return self._part(JointSpringRecord, raw.carom_joint_spring, raw.carom_joint_get_spring, raw.carom_joint_set_spring, coordinate, about)
