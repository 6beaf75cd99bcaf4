"""What a step did: report, contacts, events, faults, the plan, the ledger, residuals, lines to draw."""
from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, Any, Callable, TypeVar

from . import raw
from ._values import Record, bits, copy_out, describe, enum, flag, need_numpy, number, record, whole, word
from .records import (AccuracyRecord, ContactEventRecord, ContactRecord, DrawLineRecord, FaultEventRecord, FaultRecord,
                      GroupRecord, GrowthRecord, IslandFlags, IslandRecord, JointEventRecord, LedgerEntryRecord,
                      LedgerStateRecord, PlanLineRecord, ResidualsRecord, SensorEventRecord, SleepEventRecord,
                      StepReportRecord)

if TYPE_CHECKING:
    from numpy.typing import NDArray
    from typing_extensions import Unpack

    from .records import AccuracyKeywords, DrawKeywords, DrawWord, EffectWord, EventsWord, ModeWord

R = TypeVar("R", bound=Record)

STAGES = ("refresh", "broad", "narrow", "group", "integrate", "solve", "relax", "observe")
FAULTS = ("returned", "not_finite", "outside", "not_support", "body_state", "particle_state")
MODES = ("as_needed", "forbid", "force")


def effects() -> dict[str, int]:
    """Names of all effects: "gravity", "friction", ..."""
    return {raw.carom_effect_name(i).decode(): i for i in range(raw.CAROM_EFFECT_COUNT)}


class Reports:
    """Of the last step. Lists of records; vectors are tuples, handles objects (None where there is none)."""

    _call: Callable[..., None]
    _wrap: Callable[[str, int], Any]

    def _records(self, kind: type[R], function: Callable[..., int], struct: Any, /, *before: object,
                 **words: tuple[str, tuple[str, ...]]) -> list[R]:
        found = copy_out(self._call, function, struct, *before)
        return [record(kind, one, self._wrap,
                       **{field: word(prefix, getattr(one, field), names) for field, (prefix, names) in words.items()})
                for one in found]

    @property
    def report(self) -> StepReportRecord:
        """Counts, times and residuals; stage_seconds by name."""
        report = raw.carom_step_report(struct_size=ctypes.sizeof(raw.carom_step_report))
        self._call(raw.carom_world_get_report, ctypes.byref(report))
        return record(StepReportRecord, report, stage_seconds=dict(zip(STAGES, report.stage_seconds)))

    def contacts(self) -> list[ContactRecord]:
        """Contact points: body_a, body_b, point, normal (A to B), separation, normal_impulse, ..."""
        return self._records(ContactRecord, raw.carom_world_get_contacts, raw.carom_contact)

    def contact_array(self) -> NDArray[Any]:
        """The same as one numpy structured array, a row each, fields as in carom_contact."""
        found = copy_out(self._call, raw.carom_world_get_contacts, raw.carom_contact)
        array: NDArray[Any] = need_numpy("contact_array()").ctypeslib.as_array(found)
        return array

    def groups(self) -> list[GroupRecord]:
        """Contact groups, and which solver "auto" chose for each."""
        return self._records(GroupRecord, raw.carom_world_get_groups, raw.carom_group)

    def faults(self) -> list[FaultRecord]:
        """What misbehaved: kind in words, shape, body, dir, out."""
        return self._records(FaultRecord, raw.carom_world_get_faults, raw.carom_fault, kind=("FAULT", FAULTS))

    # ---- events ----

    def collect_events(self, *kinds: EventsWord, hit_speed: float = 1.0) -> None:
        """From the next step on. @param kinds  of "contact", "sensor", "sleep", "joint", "fault"; none: nothing
        @param hit_speed  m/s: contacts that approach faster are hits"""
        self._call(raw.carom_world_collect_events, bits("EVENTS", kinds, "kinds"), number(hit_speed, "hit_speed"))

    def contact_events(self) -> list[ContactEventRecord]:
        """kind: "begin", "end", "hit" """
        return self._records(ContactEventRecord, raw.carom_world_get_contact_events, raw.carom_contact_event,
                             kind=("CONTACT", ("begin", "end", "hit")))

    def sensor_events(self) -> list[SensorEventRecord]:
        """kind: "enter", "leave" """
        return self._records(SensorEventRecord, raw.carom_world_get_sensor_events, raw.carom_sensor_event,
                             kind=("SENSOR", ("enter", "leave")))

    def sleep_events(self) -> list[SleepEventRecord]:
        """kind: "asleep", "awake" """
        return self._records(SleepEventRecord, raw.carom_world_get_sleep_events, raw.carom_sleep_event,
                             kind=("SLEEP", ("asleep", "awake")))

    def joint_events(self) -> list[JointEventRecord]:
        """Joints that broke."""
        return self._records(JointEventRecord, raw.carom_world_get_joint_events, raw.carom_joint_event)

    def fault_events(self) -> list[FaultEventRecord]:
        return self._records(FaultEventRecord, raw.carom_world_get_fault_events, raw.carom_fault_event, kind=("FAULT", FAULTS))

    # ---- accuracy in, steps out ----

    def set_accuracy(self, **about: Unpack[AccuracyKeywords]) -> None:
        """Set an error tolerance, from the next step on: place (m/s), turn (rad/s), substeps (the bound of work).
        One of place and turn is said; the other is 1e-3 by default, and 0 stands for none."""
        if about.get("place") is None and about.get("turn") is None:
            raise TypeError("set_accuracy() takes place=, in m/s, or turn=, in rad/s, or both; type set_accuracy(place=1e-4, turn=1e-4). "
                            "clear_accuracy() takes the tolerance back")
        self._call(raw.carom_world_set_accuracy, ctypes.byref(describe(raw.carom_accuracy, about)))

    def clear_accuracy(self) -> None:
        """All islands take the substeps of the dial, as in a new world."""
        self._call(raw.carom_world_set_accuracy, None)

    @property
    def accuracy(self) -> AccuracyRecord | None:
        """The tolerance that is set, or None."""
        asked, present = describe(raw.carom_accuracy, {}), ctypes.c_uint32()
        asked.struct_size = ctypes.sizeof(raw.carom_accuracy)
        self._call(raw.carom_world_get_accuracy, ctypes.byref(asked), ctypes.byref(present))
        return record(AccuracyRecord, asked) if present.value else None

    def islands(self) -> list[IslandRecord]:
        """Islands of the last step, worst first: errors by the last estimate, substeps, work, flags. Of a world that asks.
        `IslandFlags.BOUND in world.islands()[0].flags`: the bound of work was hit, it errs more than was asked."""
        found = copy_out(self._call, raw.carom_world_get_islands, raw.carom_island)
        return [record(IslandRecord, one, self._wrap, flags=IslandFlags(one.flags)) for one in found]

    def measure_growth(self, *, steps: int, dt: float = 1 / 60) -> GrowthRecord:
        """How errors grow from here, by two copies of the world that begin a little apart; the world itself stays as it is.

        `sensitive` tells chaos: errors grow e-fold, `rate` a second. Choose steps for several e-foldings of what is looked for."""
        growth = raw.carom_growth()
        growth.struct_size = ctypes.sizeof(growth)
        self._call(raw.carom_world_measure_growth, number(dt, "dt"), whole(steps, "steps"), ctypes.byref(growth))
        return record(GrowthRecord, growth, self._wrap, sensitive=bool(growth.sensitive))

    # ---- which effects run, for whom, why ----

    def plan(self) -> list[PlanLineRecord]:
        """Stages, then effects: name, runs, participants, reason, seconds, ..."""
        lines = copy_out(self._call, raw.carom_world_get_plan, raw.carom_plan_line)
        return [record(PlanLineRecord, line, runs=bool(line.runs), mode=word("MODE", line.mode, MODES),
                       effect=None if line.effect == raw.CAROM_PLAN_NO_EFFECT else line.effect) for line in lines]

    def set_effect(self, effect: EffectWord | int, mode: ModeWord | int = "as_needed") -> None:
        """@param mode  "as_needed", "forbid", "force" """
        self._call(raw.carom_world_set_effect, enum("EFFECT", effect, "effect"), enum("MODE", mode, "mode"))

    # ---- where energy and momentum come from and go to ----

    def keep_ledger(self, on: bool = True) -> None:
        """From now on, anew if one is kept."""
        self._call(raw.carom_world_enable_ledger, flag(on, "on"))

    def ledger(self) -> dict[str, LedgerEntryRecord]:
        """{cause: record of kinetic, potential (J), linear (N s), angular (N m s), total_...}"""
        entries = copy_out(self._call, raw.carom_world_get_ledger, raw.carom_ledger_entry)
        return {entry.name.decode(): record(LedgerEntryRecord, entry) for entry in entries}

    @property
    def ledger_state(self) -> LedgerStateRecord:
        """The state itself: start_..., before_..., now_kinetic, ..., and the bounds of rounding."""
        state = raw.carom_ledger_state(struct_size=ctypes.sizeof(raw.carom_ledger_state))
        self._call(raw.carom_world_get_ledger_state, ctypes.byref(state))
        return record(LedgerStateRecord, state, is_kept=bool(state.is_kept))

    # ---- what a step left undone, and how long it may take ----

    @property
    def residuals(self) -> ResidualsRecord:
        """max_penetration, joint_gap (m), joint_angle (rad), complementarity, cone, slip (m/s), energy (J), ...;
        energy_drift is None without a ledger."""
        left = raw.carom_residuals(struct_size=ctypes.sizeof(raw.carom_residuals))
        self._call(raw.carom_world_get_residuals, ctypes.byref(left))
        drift = left.energy_drift if left.ledger_is_kept else None
        return record(ResidualsRecord, left, ledger_is_kept=bool(left.ledger_is_kept), energy_drift=drift)

    @property
    def budget(self) -> tuple[float, int, int] | None:
        """(seconds, fewest, most) that substeps are chosen within, or None."""
        seconds, fewest, most = ctypes.c_double(), ctypes.c_uint32(), ctypes.c_uint32()
        self._call(raw.carom_world_get_budget, ctypes.byref(seconds), ctypes.byref(fewest), ctypes.byref(most))
        return (seconds.value, fewest.value, most.value) if seconds.value else None

    def set_budget(self, seconds: float | None, fewest: int = 1, most: int = 8) -> None:
        """Steps of about so many seconds, by `fewest` to `most` substeps: runs then depend on the machine's speed. None: off."""
        self._call(raw.carom_world_set_budget, 0.0 if seconds is None else number(seconds, "seconds"),
                   whole(fewest, "fewest"), whole(most, "most"))

    def draw(self, *what: DrawWord, **how: Unpack[DrawKeywords]) -> list[DrawLineRecord]:
        """Coloured lines: from_, to (m), colour 0xRRGGBBAA, kind, body.
        @param what  of "shapes", "scenery", "bounds", "contacts", "joints", "bodies"   @param how  colouring="island", scale="""
        fields: dict[str, Any] = {**how}
        if what:
            fields["what"] = bits("DRAW", what, "what")
        if "colouring" in how:
            fields["colouring"] = enum("DRAW_BY", how["colouring"], "colouring")
        desc = describe(raw.carom_draw_desc, fields)
        return self._records(DrawLineRecord, raw.carom_world_draw, raw.carom_draw_line, ctypes.byref(desc))
