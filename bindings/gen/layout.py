"""Sizes, offsets and kinds of fields, by the rules of every 64-bit platform with natural alignment.

Only a reckoning: bindings go by carom_abi_manifest(), in which the compiler says, and tests compare the two.
"""
from c_reader import HeaderError

SCALARS = {"uint8_t": ("u8", 1), "char": ("char", 1), "uint32_t": ("u32", 4), "int32_t": ("i32", 4),
           "float": ("f32", 4), "uint64_t": ("u64", 8), "int64_t": ("i64", 8), "double": ("f64", 8)}


def lay_out(api):
    """Give each field offset, size and kind, each struct its size. Kinds are the manifest's: src/abi/manifest.cpp."""
    handles = {h["name"] for h in api["handles"]}
    callbacks = {c["name"] for c in api["callbacks"]}
    for struct in api["structs"]:
        end, strictest = 0, 1
        for field in struct["fields"]:
            type = field["type"]
            if "(*)" in type or type in callbacks:
                kind, size = "fn", 8
            elif "*" in type:
                kind, size = "ptr", 8
            elif type in handles:
                kind, size = "u64", 8
            elif type in SCALARS:
                kind, size = SCALARS[type]
            else:
                raise HeaderError(f"{struct['name']}.{field['name']}: a field of type {type!r} is not known")
            end = -(-end // size) * size
            strictest = max(strictest, size)
            count = field.get("count")
            field["kind"] = kind if count is None else f"{kind}[{count}]"
            field["offset"] = end
            field["size"] = size * (1 if count is None else count)
            end += field["size"]
        struct["size"] = -(-end // strictest) * strictest
