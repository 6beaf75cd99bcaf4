// A reader of Wavefront OBJ geometry: positions and faces, errors by line.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>

#include "host/files.h"
#include "host/host.h"
#include "mesh/mesh.h"
#include "mesh/parts.h"
#include "mesh/read_mesh.h"

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

/// @param begins  out: of the faces, where an object or a group begins
Mesh read(const std::string& path, std::vector<std::size_t>& begins) {
  std::istringstream file(read_file(path, "check the path and its permissions"));
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
    } else if (kind == "o" || kind == "g") {
      begins.push_back(mesh.faces.size());
    }
  }
  if (mesh.points.empty()) throw Error(path + " has no vertices", "give an OBJ file with v and f lines");
  return mesh;
}

}  // namespace

Mesh read_obj(const std::string& path) {
  std::vector<std::size_t> begins;
  return read(path, begins);
}

std::vector<Mesh> read_parts(const std::string& path) {
  if (mesh_ending(path) != ".obj") return {read_mesh(path)};
  std::vector<std::size_t> begins;
  const Mesh all = read(path, begins);
  begins.push_back(0), begins.push_back(all.faces.size());
  std::ranges::sort(begins);
  std::vector<Mesh> parts;
  for (std::size_t k = 0; k + 1 < begins.size(); ++k) {
    if (begins[k] == begins[k + 1]) continue;
    Mesh& part = parts.emplace_back();
    std::vector<std::uint32_t> number(all.points.size(), UINT32_MAX);
    for (std::size_t f = begins[k]; f < begins[k + 1]; ++f) {
      auto& face = part.faces.emplace_back();
      for (std::size_t i = 0; i < 3; ++i) {
        std::uint32_t& n = number[all.faces[f][i]];
        if (n == UINT32_MAX)
          n = static_cast<std::uint32_t>(part.points.size()), part.points.push_back(all.points[all.faces[f][i]]);
        face[i] = n;
      }
    }
  }
  if (parts.empty()) throw Error(path + " has no faces", "give an OBJ file with v and f lines");
  return parts;
}

void write_parts(const std::string& path, const std::vector<Mesh>& hulls) {
  std::ofstream file(path);
  file << "# convex parts, an object each\n";
  file.precision(17);
  file.imbue(std::locale::classic());
  std::size_t first = 1, number = 0;
  for (const Mesh& hull : hulls) {
    file << "o part_" << ++number << "\n";
    for (const Eigen::Vector3d& p : hull.points) file << "v " << p.x() << ' ' << p.y() << ' ' << p.z() << "\n";
    for (const auto& f : hull.faces) file << "f " << first + f[0] << ' ' << first + f[1] << ' ' << first + f[2] << "\n";
    first += hull.points.size();
  }
  file.flush();
  if (!file) throw Error("cannot write " + path, "check the path, its permissions and the space left");
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
