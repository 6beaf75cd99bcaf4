// A reader of Wavefront OBJ geometry: positions and faces, errors by line.
#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>

#include "host/host.h"
#include "mesh/mesh.h"

namespace carom::tools {
namespace {

[[noreturn]] void refuse(const std::string& path, std::size_t line, const std::string& why) {
  throw Error(path + ":" + std::to_string(line) + ": " + why,
              "give an OBJ file whose v lines have three finite numbers "
              "and whose f lines name vertices that exist");
}

/// "7", "7/1", "7//3", "-1" -> 0-based index of the position.
std::uint32_t vertex_index(const std::string& token, std::size_t count, const std::string& path, std::size_t line) {
  long long index = 0;
  const auto [end, failed] = std::from_chars(token.data(), token.data() + token.size(), index);
  if (failed != std::errc() || (end != token.data() + token.size() && *end != '/'))
    refuse(path, line, "'" + token + "' is not a vertex index");
  if (index < 0) index += static_cast<long long>(count) + 1;  // negative: counted back from the latest vertex
  if (index < 1 || index > static_cast<long long>(count)) refuse(path, line, "vertex " + token + " does not exist");
  return static_cast<std::uint32_t>(index - 1);
}

}  // namespace

Mesh read_obj(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw Error("cannot read the mesh " + path, "check the path and its permissions, or leave --mesh out");
  Mesh mesh;
  std::string text;
  for (std::size_t line = 1; std::getline(file, text); ++line) {
    std::istringstream words(text);
    words.imbue(std::locale::classic());
    std::string kind;
    words >> kind;
    if (kind == "v") {
      Eigen::Vector3d p;
      if (!(words >> p.x() >> p.y() >> p.z()) || !p.allFinite())
        refuse(path, line, "a vertex needs three finite numbers");
      if (mesh.points.size() == std::numeric_limits<std::uint32_t>::max()) refuse(path, line, "too many vertices");
      mesh.points.push_back(p);
    } else if (kind == "f") {
      std::vector<std::uint32_t> corners;
      for (std::string token; words >> token;) corners.push_back(vertex_index(token, mesh.points.size(), path, line));
      if (corners.size() < 3) refuse(path, line, "a face needs three vertices");
      for (std::size_t i = 2; i < corners.size(); ++i) mesh.faces.push_back({corners[0], corners[i - 1], corners[i]});
    }
  }
  if (mesh.points.empty()) throw Error(path + " has no vertices", "give an OBJ file with v and f lines");
  return mesh;
}

void fit_to_height(Mesh& mesh, double height) {
  Eigen::Vector3d low = mesh.points.front(), high = low;
  for (const Eigen::Vector3d& p : mesh.points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  if (!(high.y() > low.y()))
    throw Error("the mesh has no height along y", "give a mesh that stands upright along +y and is not flat");
  const double scale = height / (high.y() - low.y());
  const Eigen::Vector3d centre = (low + high) / 2;
  for (Eigen::Vector3d& p : mesh.points) p = (p - centre) * scale;
}

}  // namespace carom::tools
