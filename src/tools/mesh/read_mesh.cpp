// Which reader a file is for.
#include "mesh/read_mesh.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "host/files.h"
#include "host/host.h"

namespace carom::tools {

std::string mesh_ending(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

Mesh read_mesh(const std::string& path) {
  const std::string ending = mesh_ending(path);
  if (ending == ".obj") return read_obj(path);
  if (ending != ".stl" && ending != ".ply")
    throw Error("the mesh " + path + " is of no kind that can be read", "give a file that ends in .obj, .stl or .ply");
  const std::string bytes = read_file(path, "check the path and its permissions");
  return ending == ".stl" ? parse_stl(bytes, path) : parse_ply(bytes, path);
}

}  // namespace carom::tools
