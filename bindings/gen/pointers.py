"""What C leaves unsaid of a pointer: which way its data goes, whether it may be NULL, how many elements it has.

    direction  "in" the call reads, "out" it writes, "inout" it reads first: a struct_size, how many there is room for
    nullable   NULL is allowed; the documentation says what it means then
    length     elements, in other arguments or fields; left out: one. Of strings "zero-terminated"
    stride     the argument that says how many bytes lie between elements; 0: packed

Most follows from the type. What does not follow stands in the tables below; tests/bindings/test_pointers.py passes NULL
for every argument of a loaded library and compares.
"""

import re

# (function, argument): how many elements
LENGTHS = {
    ("carom_world_read", "dst"): "n * width of field",
    ("carom_world_write", "src"): "n * width of field",
    ("carom_world_read", "handles"): "n",
    ("carom_world_write", "handles"): "n",
    ("carom_particles_add", "positions"): "3 * n",
    ("carom_particles_add", "velocities"): "3 * n",
    ("carom_particles_remove", "indices"): "n",
    ("carom_particles_read", "indices"): "n",
    ("carom_particles_read", "dst"): "n * width of field",
    ("carom_particles_write", "indices"): "n",
    ("carom_particles_write", "src"): "n * width of field",
    ("carom_particles_get_quarantined", "indices"): "capacity",
    ("carom_pairs_distance", "dst"): "pairs->count",
    ("carom_device_pairs_distance", "dst"): "pairs->count",
    ("carom_rays_cast", "positions"): "3 * shape_count",
    ("carom_rays_cast", "orientations"): "4 * shape_count",
    ("carom_rays_cast", "shapes"): "shape_count",
    ("carom_shape_create", "params"): "count",
    ("carom_shape_create_named", "params"): "count",
    ("carom_shape_create_hull_of", "parts"): "count",
    ("carom_shape_create_hull_of", "positions"): "3 * count",
    ("carom_shape_create_hull_of", "orientations"): "4 * count",
    ("carom_shape_create_hull_of", "scales"): "3 * count",
    ("carom_shape_get_parts", "parts"): "*count",
    ("carom_shape_get_parts", "positions"): "3 * *count",
    ("carom_shape_get_parts", "orientations"): "4 * *count",
    ("carom_shape_get_parts", "scales"): "3 * *count",
    ("carom_body_create_named", "params"): "count",
    ("carom_world_read_joints", "dst"): "n * width of field",
    ("carom_world_read_joints", "joints"): "n",
    ("carom_world_write_joints", "src"): "n * width of field",
    ("carom_world_write_joints", "joints"): "n",
    ("carom_tree_get_speeds", "speeds"): "n",
    ("carom_tree_get_forces", "speeds"): "n",
    ("carom_tree_get_forces", "accelerations"): "n",
    ("carom_tree_get_forces", "forces"): "n",
    ("carom_tree_get_mass", "mass"): "n * n",
    ("carom_shape_get_params", "params"): "*count",
    ("carom_shape_get_triangles", "corners"): "9 * *count",
    ("carom_shape_support", "dirs"): "3 * n",
    ("carom_shape_support", "points"): "3 * n",
    ("carom_world_save", "buffer"): "capacity",
    ("carom_world_restore", "bytes"): "size",
    ("carom_world_compare", "bytes"): "size",
    ("carom_world_translate_handles", "handles"): "n",
    ("carom_world_translate_handles", "translated"): "n",
    ("carom_world_cast_shapes", "dst"): "shapes->count",
    ("carom_world_find_nearest", "dst"): "shapes->count",
    ("carom_vehicle_drive", "wheel_descs"): "n",
    ("carom_vehicle_drive", "wheels"): "n",
    ("carom_batch_read", "columns"): "count",
    ("carom_batch_write", "columns"): "count",
    ("carom_batch_add_start", "bytes"): "size",
    ("carom_batch_save", "buffer"): "capacity",
    ("carom_batch_get_hashes", "hashes"): "n",
    ("carom_batch_get_stopped", "stopped"): "n",
    ("carom_random_fill", "keys"): "3 * n",
    ("carom_random_fill", "dst"): "n * width",
    ("carom_support_fn", "params"): "param_len",
    ("carom_write_fn", "bytes"): "size",
}
# Arguments whose name says that their length is `capacity` elements.
WITH_CAPACITY = ("dst", "handles", "joints", "colliders", "sets", "indices")
STRIDES = {
    ("carom_particles_add", "positions"): "position_stride",
    ("carom_particles_add", "velocities"): "velocity_stride",
}

# Where the argument's own documentation does not tell: it is "as" that of another function, or tells of another's NULL.
NULLABLE = {
    ("carom_world_write", "handles"),
    ("carom_world_write_joints", "joints"),
    ("carom_particles_write", "indices"),
    ("carom_shape_get_params", "params"),
    ("carom_world_cast_rays_all", "desc"),
    ("carom_world_cast_shapes_all", "desc"),
    ("carom_world_overlap_shapes", "desc"),
    ("carom_world_find_nearest", "desc"),
}
NOT_NULLABLE = {("carom_shape_get_triangles", "count"), ("carom_body_get_user", "user")}
INOUT = {("carom_shape_get_params", "count"), ("carom_shape_get_triangles", "count")}


def pointers_in(api):
    """(owner, its arguments or fields, what it is) of all that may hold pointers"""
    for kind in ("functions", "callbacks"):
        for owner in api[kind]:
            yield owner, owner["arguments"], kind
    for owner in api["structs"]:
        yield owner, owner["fields"], "structs"


def is_pointer(type):
    return "*" in type and "(*)" not in type


def parameter_docs(doc):
    """{argument: what its @param says}, for several names before one text, too"""
    found = {}
    for names, text in re.findall(r"@param\s+((?:\w+,\s*)*\w+)\s+(.*?)(?=@\w|\Z)", doc, flags=re.S):
        for name in re.split(r",\s*", names):
            found[name] = " ".join(text.split())
    return found


def says_null(text):
    return re.search(r"\bNULL\b", text) is not None


def sized(struct):
    return struct is not None and struct["fields"][0]["name"] == "struct_size"


def add_pointers(api):
    structs = {s["name"]: s for s in api["structs"]}
    opaque = {o["name"] for o in api["opaque"]}
    for owner, members, kind in pointers_in(api):
        docs = parameter_docs(owner["doc"])
        names = {m["name"] for m in members}
        for member in members:
            type, name = member["type"], member["name"]
            if not is_pointer(type):
                continue
            key, base = (owner["name"], name), re.sub(r"\bconst\b|\*", "", type).strip()
            text = member.get("doc", "") if kind == "structs" else docs.get(name, "")
            out = not type.startswith("const")
            if base in opaque and type.count("*") == 1 or base == "void" and name in ("user", "context", "alloc_user", "log_user"):
                direction = "in"
            elif type == "const carom_shape_plugin **" or not out and type.count("*") == 1:
                direction = "out" if type.endswith("**") else "in"
            elif not out:
                direction = "in"
            elif key in INOUT:
                direction = "inout"
            elif sized(structs.get(base)) and not owner["name"].endswith("_init"):
                direction = "inout"  # the caller sets struct_size
            else:
                direction = "out"
            member["direction"] = direction
            member["nullable"] = nullable(key, member, text, names, kind, owner, opaque, base)
            length = length_of(key, member, text, names, base)
            if length:
                member["length"] = length
            stride = STRIDES.get(key) or ("stride" if "stride" in names and name in ("dst", "src") else None)
            if stride:
                member["stride"] = stride


def nullable(key, member, text, names, kind, owner, opaque, base):
    name = member["name"]
    if key in NULLABLE:
        return True
    if key in NOT_NULLABLE:
        return False
    if name in ("error", "user", "context", "alloc_user", "log_user"):
        return True
    if kind == "structs":
        return says_null(text) or owner["name"].endswith("_hits")  # where answers go: NULL, not wanted
    if kind == "functions" and "capacity" in names and length_of(key, member, text, names, base) == "capacity":
        return True
    return says_null(text)


def length_of(key, member, text, names, base):
    name, type = member["name"], member["type"]
    if key in LENGTHS:
        return LENGTHS[key]
    if "count" in member:
        return str(member["count"])
    if base == "char":
        return "zero-terminated" if type.count("*") == 1 else f"{bracketed(text)}, each zero-terminated"
    if "capacity" in names and name in WITH_CAPACITY and name != "count":
        return "capacity"
    if "offset" in member:  # a field: its doc says so in brackets
        length = bracketed(text)
        return re.sub(r"\bcount\b", "rays->count", length) if length and key[0].endswith("_hits") else length
    return None


def bracketed(text):
    """ "[3 vertex_count] m" is 3 * vertex_count; "[rows][columns]" their product; "[count] 3 scalars" 3 * count."""
    match = re.match(r"((?:\[[\w ]+\])+)(?: (\d) scalars?)?", text)
    if not match:
        return None
    parts = [" * ".join(part.split()) for part in re.findall(r"\[([\w ]+)\]", match.group(1))]
    return " * ".join(([match.group(2)] if match.group(2) not in (None, "1") else []) + parts)


def add_owners(api):
    """Of each handle and opaque struct: the owner ("engine", "world", "caller"), what makes it and what ends it."""
    functions = {f["name"]: f for f in api["functions"]}
    for thing in api["handles"] + api["opaque"]:
        name = thing["name"]
        makers = [
            f["name"]
            for f in api["functions"]
            if re.search(r"_(create\w*|load|register|fork)$", f["name"])
            and any(a.get("direction") == "out" and a["type"] in (f"{name} *", f"{name} **") for a in f["arguments"])
        ]
        first = functions[makers[0]]["arguments"][0]["type"] if makers else ""
        thing["owner"] = "caller" if thing in api["opaque"] else re.sub(r"const |carom_| \*", "", first) or None
        thing["made_by"] = makers
        end = f"{name}_destroy"
        thing["ended_by"] = end if end in functions else None
