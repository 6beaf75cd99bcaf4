"""bindings/python/carom/records.py: what structs say as attributes of Python objects, what keywords set of them, and the
words of enumerations; all with types."""

import re
import textwrap

from enumerations import GROUPS

# Structs that a call of the package gives as a record: which of their fields are not what C has there.
RECORDS = {
    "carom_body_desc": {"type": "str"},
    "carom_collider_desc": {"+body": "Body"},
    "carom_force_field_desc": {"kind": "str"},
    "carom_spring_desc": {},
    "carom_joint_desc": {"kind": "str"},
    "carom_joint_state": {"broken": "bool", "coordinate": "dict[str, float]", "axis": "dict[str, float]"},
    "carom_joint_transmission": {},
    "carom_joint_coupling": {},
    "carom_joint_axis": {
        "mode": "str",
        "drive": "str",
        "stop_gains": "str",
        "drive_gains": "str",
        "spring_gains": "str",
    },
    "carom_joint_orientation_drive": {"drive": "str", "gains": "str"},
    "carom_joint_limit": {"enabled": "bool"},
    "carom_joint_motor": {"enabled": "bool"},
    "carom_joint_spring": {"enabled": "bool"},
    "carom_shape_info": {"plugin": "int"},
    "carom_distance": {},
    "carom_cast": {"outcome": "str"},
    "carom_overlap": {"outcome": "str"},
    "carom_world_hit": {"outcome": "str"},
    "carom_step_report": {"stage_seconds": "dict[str, float]"},
    "carom_contact": {},
    "carom_group": {},
    "carom_accuracy": {},
    "carom_island": {"flags": "IslandFlags"},
    "carom_growth": {"sensitive": "bool"},
    "carom_fault": {"kind": "str"},
    "carom_contact_event": {"kind": "str"},
    "carom_sensor_event": {"kind": "str"},
    "carom_sleep_event": {"kind": "str"},
    "carom_joint_event": {},
    "carom_tree_coordinate": {"axis": "str"},
    "carom_vehicle": {},
    "carom_wheel": {"touches": "bool"},
    "carom_fault_event": {"kind": "str"},
    "carom_plan_line": {"runs": "bool", "mode": "str", "effect": "int | None"},
    "carom_ledger_entry": {},
    "carom_ledger_state": {"is_kept": "bool"},
    "carom_residuals": {"ledger_is_kept": "bool", "energy_drift": "float | None"},
    "carom_draw_line": {},
    "carom_batch_info": {},
}
# Bits that a record has as an enum.IntFlag: the class, and the prefix of its constants.
FLAGS = {"IslandFlags": "CAROM_ISLAND_"}
# Descriptors that calls take as keywords: which of them are given as words, too.
KEYWORDS = {
    "carom_material_desc": {"friction_mix": "MixWord | int", "restitution_mix": "MixWord | int"},
    "carom_force_field_desc": {"-": "kind"},
    "carom_particles_desc": {},
    "carom_accuracy": {},
    "carom_joint_desc": {"+collide": "bool", "+accelerations": "bool", "-": "kind fields body_a body_b"},
    "carom_joint_transmission": {},
    "carom_joint_axis": {
        "mode": "AxisModeWord | int",
        "drive": "DriveWord | int",
        "stop_gains": "GainsWord | int",
        "drive_gains": "GainsWord | int",
        "spring_gains": "GainsWord | int",
    },
    "carom_joint_orientation_drive": {"drive": "DriveWord | int", "gains": "GainsWord | int"},
    "carom_joint_limit": {"enabled": "bool"},
    "carom_joint_motor": {"enabled": "bool"},
    "carom_joint_spring": {"enabled": "bool"},
    "carom_cast_desc": {},
    "carom_distance_desc": {},
    "carom_motion": {},
    "carom_query_desc": {},
    "carom_draw_desc": {"-": "what", "colouring": "DrawByWord | int"},
    "carom_character_desc": {"-": "flags", "+turns": "bool", "+flies": "bool"},
    "carom_vehicle_desc": {
        "-": "flags chassis torque_count gear_count torque_speeds torques",
        "+torque_curve": "Rows | None",
        "+automatic": "bool",
        "+ackermann": "bool",
    },
    "carom_wheel_desc": {},
}
NUMBERS = {"double": "float", "int32_t": "int", "uint32_t": "int", "uint64_t": "int"}


def camel(name):
    return "".join(part.capitalize() for part in name.removeprefix("carom_").removesuffix("_desc").split("_"))


def fields_of(struct):
    return [f for f in struct["fields"] if f["name"] not in ("struct_size", "reserved")]


def said(field, handles):
    """The type of a field as a record has it."""
    type, count = field["type"], field.get("count")
    if type == "char" or type == "const char *":
        return "str"
    if type in handles:
        return f"{camel(type)} | None"
    number = NUMBERS[type]
    if count is None:
        return number
    return f"tuple[{', '.join([number] * count)}]" if count <= 4 else f"tuple[{number}, ...]"


def given(field, handles):
    """The type of a keyword that sets a field."""
    type = field["type"]
    if type in handles:
        return f"{camel(type)} | int | None"
    return "Vector | None" if "count" in field else f"{NUMBERS[type]} | None"


def members(struct, changes, type_of, handles):
    left_out = changes.get("-", "").split()
    rows = [
        (f["name"] + "_" if f["name"] == "from" else f["name"], changes.get(f["name"]) or type_of(f, handles))
        for f in fields_of(struct)
        if f["name"] not in left_out
    ]
    rows += [(name[1:], type) for name, type in changes.items() if name[0] == "+"]
    return [f"    {name}: {type}" for name, type in rows] or ["    pass"]


def first_sentence(doc):
    text = re.split(r"(?<=[.:;,]) ", " ".join(doc.split("@", 1)[0].split()))[0]
    return text.rstrip(":;,.").replace('"', "'")


def one_line(doc):
    return " ".join(doc.split()).replace('"', "'")


def records(api):
    handles = {h["name"] for h in api["handles"]}
    structs = {s["name"]: s for s in api["structs"]}
    prefixes = {}
    for prefix, (name, _) in GROUPS.items():
        prefixes.setdefault(name, []).append(prefix)
    out = [
        '"""What structs say, what keywords set, and the words of enumerations.',
        "",
        'Written by bindings/gen/generate from include/carom; do not edit."""',
        "from __future__ import annotations",
        "",
        "from enum import IntFlag",
        "from typing import TYPE_CHECKING, Literal, TypedDict",
        "",
        "from ._values import Record",
        "",
        "if TYPE_CHECKING:",
        "    from ._values import Rows, Vector",
        "    from .body import Body, Collider, Material",
        "    from .joint import Joint",
        "    from .particles import Particles",
        "    from .shape import Shape",
        "",
        '# Words: each is a constant without its prefix, CAROM_BODY_STATIC "static". Numbers pass, too.',
    ]
    for group in api["enumerations"]:
        if group["kind"] != "code":
            words = [
                re.sub("^(" + "|".join(prefixes[group["name"]]) + ")", "", name) or name for name in group["values"]
            ]
            words = [w for w in words if not w.startswith("CAROM_")]
            if words:
                listed = ", ".join(f'"{word.lower()}"' for word in words)
                text = f"{camel(group['name'])}Word = Literal[{listed}]"
                out += textwrap.wrap(
                    text, 118, subsequent_indent="    ", break_long_words=False, break_on_hyphens=False
                )
    for name, prefix in FLAGS.items():
        bits = [c for c in api["constants"] if c["name"].startswith(prefix)]
        out += ["", "", f"class {name}(IntFlag):", f'    """{prefix}*: bits; `{name}.{bits[0]["name"].removeprefix(prefix)} in flags`"""']
        for bit in bits:
            out += [f"    {bit['name'].removeprefix(prefix)} = {bit['value']}", f'    """{one_line(bit["doc"])}"""']
    for name, changes in RECORDS.items():
        doc = first_sentence(structs[name]["doc"]) or name
        out += [
            "",
            "",
            f"class {camel(name)}Record(Record):",
            f'    """{doc}"""',
            *members(structs[name], changes, said, handles),
        ]
    for name, changes in KEYWORDS.items():
        out += [
            "",
            "",
            f"class {camel(name)}Keywords(TypedDict, total=False):",
            *members(structs[name], changes, given, handles),
        ]
    dials = next(group for group in api["enumerations"] if group["name"] == "dial")
    out += [
        "",
        "",
        "class DialKeywords(TypedDict, total=False):",
        *(f"    {name.removeprefix('CAROM_DIAL_').lower()}: float | str" for name in dials["values"]),
    ]
    return "\n".join(out) + "\n"
