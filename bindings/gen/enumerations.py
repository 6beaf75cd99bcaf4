"""Which constants are values of one enumeration, and what takes them: api.json's "enumerations"."""

from c_reader import HeaderError

# prefix: (name, what its values are). "choice": one of them; "bits": any of them together; "code": a result.
# Longer prefixes come first where one begins another.
GROUPS = {
    "CAROM_E_": ("result", "code"),
    "CAROM_MIX_": ("mix", "choice"),
    "CAROM_BODY_FIELD_": ("body_fields", "bits"),
    "CAROM_BODY_STAYS_AWAKE": ("body_fields", "bits"),
    "CAROM_BODY_DISABLED": ("body_fields", "bits"),
    "CAROM_BODY_": ("body_type", "choice"),
    "CAROM_LOCK_": ("locks", "bits"),
    "CAROM_ATTRIBUTE_": ("attribute", "choice"),
    "CAROM_CONTINUOUS_": ("continuous", "choice"),
    "CAROM_FIELD_": ("field", "choice"),
    "CAROM_SCALAR_": ("scalar", "choice"),
    "CAROM_CAST_": ("cast", "choice"),
    "CAROM_OVERLAP_": ("overlap", "choice"),
    "CAROM_DIAL_KIND_": ("dial_kind", "choice"),
    "CAROM_DIAL_": ("dial", "choice"),
    "CAROM_INTEGRATOR_": ("integrator", "choice"),
    "CAROM_ROTATION_": ("rotation", "choice"),
    "CAROM_SOLVER_": ("solver", "choice"),
    "CAROM_SEARCH_": ("search", "choice"),
    "CAROM_BROAD_": ("broad", "choice"),
    "CAROM_NARROW_": ("narrow", "choice"),
    "CAROM_SIMPLEX_": ("simplex", "choice"),
    "CAROM_MANIFOLD_": ("manifold", "choice"),
    "CAROM_SWEEP_": ("sweep", "choice"),
    "CAROM_PRECISION_": ("precision", "choice"),
    "CAROM_PRESET_": ("preset", "choice"),
    "CAROM_DRAW_BY_": ("draw_by", "choice"),
    "CAROM_DRAW_": ("draw", "bits"),
    "CAROM_LOG_": ("log", "choice"),
    "CAROM_EVENTS_": ("events", "bits"),
    "CAROM_CONTACT_": ("contact", "choice"),
    "CAROM_SENSOR_": ("sensor", "choice"),
    "CAROM_SLEEP_": ("sleep", "choice"),
    "CAROM_FORCE_FIELD_": ("force_field", "choice"),
    "CAROM_JOINT_WORLD_FRAME": ("joint_fields", "bits"),
    "CAROM_JOINT_COLLIDE": ("joint_fields", "bits"),
    "CAROM_JOINT_ACCELERATIONS": ("joint_fields", "bits"),
    "CAROM_JOINT_FIELD_": ("joint_fields", "bits"),
    "CAROM_JOINT_BULK_": ("joint_bulk", "choice"),
    "CAROM_JOINT_": ("joint", "choice"),
    "CAROM_COORDINATE_": ("coordinate", "choice"),
    "CAROM_AXIS_MODE_": ("axis_mode", "choice"),
    "CAROM_AXIS_": ("axis", "choice"),
    "CAROM_DRIVE_": ("drive", "choice"),
    "CAROM_GAINS_": ("gains", "choice"),
    "CAROM_EFFECT_": ("effect", "choice"),
    "CAROM_MODE_": ("mode", "choice"),
    "CAROM_TIME_": ("time", "choice"),
    "CAROM_FORM_": ("form", "choice"),
    "CAROM_PLUGIN_HOST_THREAD": ("plugin_flags", "bits"),
    "CAROM_QUERY_": ("query", "choice"),
    "CAROM_RECORD_": ("record", "choice"),
    "CAROM_SCENERY_": ("scenery_flags", "bits"),
    "CAROM_SNAPSHOT_": ("snapshot", "choice"),
    "CAROM_ISLAND_": ("island_flags", "bits"),
    "CAROM_STAGE_": ("stage", "choice"),
    "CAROM_REASON_": ("reason", "choice"),
    "CAROM_FAULT_": ("fault", "choice"),
    "CAROM_WANT_": ("want", "choice"),
    "CAROM_GROUND_": ("ground", "choice"),
    "CAROM_VEHICLE_AUTOMATIC": ("vehicle_flags", "bits"),
    "CAROM_VEHICLE_ACKERMANN": ("vehicle_flags", "bits"),
    "CAROM_CHARACTER_TURNS": ("character_flags", "bits"),
    "CAROM_CHARACTER_FLIES": ("character_flags", "bits"),
    "CAROM_ASK_": ("query_flags", "bits"),
    "CAROM_COLUMN_": ("column", "choice"),
    "CAROM_WHEN_": ("when", "choice"),
    "CAROM_STOPPED_": ("stopped", "choice"),
    "CAROM_RANDOM_": ("random", "choice"),
}
# Constants that are a value of nothing: versions, defaults, what stands for none.
ALONE = {
    "CAROM_VERSION_MAJOR",
    "CAROM_VERSION_MINOR",
    "CAROM_VERSION_PATCH",
    "CAROM_NULL_HANDLE",
    "CAROM_NO_SHAPE",
    "CAROM_NO_PARAM",
    "CAROM_PLAN_NO_EFFECT",
    "CAROM_FILTER_CATEGORY",
    "CAROM_FILTER_MASK",
    "CAROM_PLUGIN_ABI_MAJOR",
    "CAROM_PLUGIN_ABI_MINOR",
    "CAROM_SHAPE_PLUGIN_SYMBOL",
    "CAROM_ATTRIBUTE_NUMBERS",
    "CAROM_CHARACTER_CONTACTS",
    "CAROM_VEHICLE_WHEELS",
    "CAROM_NO_WHEEL",
}


def add_enumerations(api):
    """api["enumerations"]: name, kind, header, values (names), count (the constant that counts them, or null).
    @raise HeaderError for a constant that is in no group, for two values of one that are the same"""
    groups = {}
    for constant in api["constants"]:
        name = constant["name"]
        if name in ALONE:
            continue
        prefix = "CAROM_E_" if name == "CAROM_OK" else next((p for p in GROUPS if name.startswith(p)), None)
        if prefix is None:
            raise HeaderError(
                f"{constant['header']}: {name}: which enumeration is it of? bindings/gen/enumerations.py says so"
            )
        word, kind = GROUPS[prefix]
        group = groups.setdefault(
            word, {"name": word, "kind": kind, "header": constant["header"], "count": None, "values": []}
        )
        if name.endswith("_COUNT"):
            group["count"] = name
        else:
            group["values"].append(name)
    values = {c["name"]: c["value"] for c in api["constants"]}
    for group in groups.values():
        numbers = [values[name] for name in group["values"]]
        if len(set(numbers)) != len(numbers):
            raise HeaderError(f"{group['header']}: two values of {group['name']} are the same")
        if group["count"] and values[group["count"]] != len(numbers):
            raise HeaderError(
                f"{group['header']}: {group['count']} is {values[group['count']]}, but there are {len(numbers)}"
            )
    api["enumerations"] = list(groups.values())
