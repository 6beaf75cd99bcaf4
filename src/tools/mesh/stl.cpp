// STL: triangles without shared vertices, as text or as 50 bytes each. Vertices equal to the bit become one.
#include <map>

#include "host/host.h"
#include "mesh/bytes.h"
#include "mesh/read_mesh.h"

namespace carom::tools {
namespace {

constexpr std::size_t kHeader = 84, kTriangle = 50;  // bytes

[[noreturn]] void refuse(const std::string& path, const std::string& where, const std::string& why) {
  throw Error(
      path + where + ": " + why,
      "give an STL file: text of facets of three vertices each, or an 80-byte header, the number of triangles and 50 "
      "bytes for each");
}

class Welded {
 public:
  void add(const Eigen::Vector3d* corners) {
    auto& face = mesh.faces.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      const Eigen::Vector3d p = corners[i] + Eigen::Vector3d::Zero();  // -0 is 0
      const auto [at, is_new] =
          number_.try_emplace({p.x(), p.y(), p.z()}, static_cast<std::uint32_t>(mesh.points.size()));
      if (is_new) mesh.points.push_back(p);
      face[i] = at->second;
    }
  }
  Mesh mesh;

 private:
  std::map<std::array<double, 3>, std::uint32_t> number_;
};

Mesh read_binary(std::string_view bytes, std::size_t triangles, const std::string& path) {
  Welded welded;
  for (std::size_t t = 0; t < triangles; ++t) {
    const std::size_t at = kHeader + t * kTriangle + 12;  // behind the normal
    Eigen::Vector3d corner[3];
    for (int i = 0; i < 9; ++i)
      corner[i / 3][i % 3] = double(value_at<float>(bytes.data() + at + 4 * static_cast<std::size_t>(i), false));
    for (const Eigen::Vector3d& p : corner)
      if (!p.allFinite()) refuse(path, ", byte " + std::to_string(at), "a vertex needs three finite numbers");
    welded.add(corner);
  }
  return welded.mesh;
}

Mesh read_text(std::string_view text, const std::string& path) {
  Welded welded;
  Words words(text);
  const auto where = [&] { return ":" + std::to_string(words.line()); };
  Eigen::Vector3d corner[3];
  int corners = 0;
  for (std::string_view word; !(word = words.next()).empty();) {
    if (word == "vertex") {
      if (corners == 3) refuse(path, where(), "a facet of more than three vertices");
      for (int i = 0; i < 3; ++i) {
        const auto value = number_of(words.next());
        if (!value) refuse(path, where(), "a vertex needs three finite numbers");
        corner[corners][i] = *value;
      }
      ++corners;
    } else if (word == "endfacet") {
      if (corners != 3) refuse(path, where(), "a facet of " + std::to_string(corners) + " vertices");
      welded.add(corner);
      corners = 0;
    }
  }
  if (corners != 0) refuse(path, where(), "the file ends within a facet");
  return welded.mesh;
}

}  // namespace

Mesh parse_stl(std::string_view bytes, const std::string& path) {
  // Headers of binary files begin with "solid", too: their length is what tells them.
  const std::uint64_t triangles = bytes.size() >= kHeader ? value_at<std::uint32_t>(bytes.data() + 80, false) : 0;
  const bool binary = bytes.size() >= kHeader && bytes.size() == kHeader + kTriangle * triangles;
  if (!binary && !bytes.starts_with("solid"))
    refuse(path, "", bytes.size() < kHeader ? "is no STL file" : "is cut off, or no STL file");
  Mesh mesh = binary ? read_binary(bytes, triangles, path) : read_text(bytes, path);
  if (mesh.points.empty()) refuse(path, "", "has no vertices");
  return mesh;
}

}  // namespace carom::tools
