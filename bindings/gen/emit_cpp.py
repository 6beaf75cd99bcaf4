"""The generated part of include/carom/carom.hpp: which function fills which struct. Declarations are the headers' own."""

BY = "// Written by bindings/gen/generate from include/carom; do not edit."


def fill(api):
    out = [BY, "#ifndef CAROM_FILL_HPP", "#define CAROM_FILL_HPP", "#include <carom/carom.h>", "",
           "namespace carom::raw {"]
    for s in api["structs"]:
        if s["init"]:
            out.append(f"inline void fill({s['name']} &it) noexcept {{ {s['init']}(&it, sizeof it); }}")
        elif s["fields"][0]["name"] == "struct_size":
            out.append(f"inline void fill({s['name']} &it) noexcept {{ it = {{}}, it.struct_size = sizeof it; }}")
    return "\n".join(out + ["}  // namespace carom::raw", "#endif", ""])
