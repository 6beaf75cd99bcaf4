// Readers of mesh files, by what their names end in. All give points that several triangles share once, where the
// format says so or (STL, which never does) where they are equal to the bit.
#pragma once

#include <string>
#include <string_view>

#include "mesh/mesh.h"

namespace carom::tools {

/// What the name of a file ends in, in small letters: ".obj".
std::string mesh_ending(const std::string& path);

/// Read an OBJ, STL (text or binary) or PLY (text or binary, either byte order) file; polygons are fanned, all but
/// positions and faces is skipped.
/// @throws Error naming the line or byte at fault: cut off, a number that is none, an index out of range, no vertices
Mesh read_mesh(const std::string& path);

/// The same of bytes that are in memory. @param path  for errors
Mesh parse_stl(std::string_view bytes, const std::string& path);
Mesh parse_ply(std::string_view bytes, const std::string& path);

}  // namespace carom::tools
