// The bunny: Stanford's, from a file given or from Debian's glmark2-data; a body of ellipsoids stands in, and says so.
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "host/host.h"
#include "mesh/mesh.h"
#include "mesh/read_mesh.h"

namespace carom::tools {
namespace {

using Eigen::Vector3d;

constexpr const char* kInstalledMesh = "/usr/share/glmark2/models/bunny.obj";

/// An ellipsoid of latitude rings, appended to the mesh.
/// @param lean  rad, about the x axis: ears lean back
void add_ellipsoid(Mesh& mesh, const Vector3d& centre, const Vector3d& radii, double lean) {
  constexpr int kRings = 10, kSectors = 18;
  constexpr double kPi = 3.14159265358979323846;
  const auto first = static_cast<std::uint32_t>(mesh.points.size());
  for (int r = 0; r <= kRings; ++r)
    for (int s = 0; s < kSectors; ++s) {
      const double polar = kPi * r / kRings, turn = 2 * kPi * s / kSectors;
      const Vector3d p(radii.x() * std::sin(polar) * std::cos(turn), radii.y() * std::cos(polar),
                       radii.z() * std::sin(polar) * std::sin(turn));
      mesh.points.emplace_back(centre + Vector3d(p.x(), std::cos(lean) * p.y() - std::sin(lean) * p.z(),
                                                 std::sin(lean) * p.y() + std::cos(lean) * p.z()));
    }
  for (int r = 0; r < kRings; ++r)
    for (int s = 0; s < kSectors; ++s) {
      auto at = [&](int ring, int sector) {
        return first + static_cast<std::uint32_t>(ring * kSectors + sector % kSectors);
      };
      if (r > 0) mesh.faces.push_back({at(r, s), at(r, s + 1), at(r + 1, s)});
      if (r + 1 < kRings) mesh.faces.push_back({at(r, s + 1), at(r + 1, s + 1), at(r + 1, s)});
    }
}

Mesh procedural_bunny() {
  Mesh mesh;
  add_ellipsoid(mesh, {0, 0.30, 0}, {0.30, 0.30, 0.42}, 0);           // body
  add_ellipsoid(mesh, {0, 0.68, 0.26}, {0.19, 0.19, 0.22}, 0);        // head
  add_ellipsoid(mesh, {0.09, 0.98, 0.14}, {0.06, 0.26, 0.05}, -0.3);  // ears
  add_ellipsoid(mesh, {-0.09, 0.98, 0.14}, {0.06, 0.26, 0.05}, -0.3);
  add_ellipsoid(mesh, {0, 0.22, -0.42}, {0.10, 0.10, 0.10}, 0);  // tail
  return mesh;
}

std::string text(const char* pattern, double a, double b, double c) {
  char buffer[256];
  std::snprintf(buffer, sizeof buffer, pattern, a, b, c);
  return buffer;
}

}  // namespace

Eigen::Vector3d Bunny::half_extents() const {
  Vector3d half = Vector3d::Zero();  // the box is centred on the origin
  for (const Vector3d& p : mesh.points) half = half.cwiseMax(p.cwiseAbs());
  return half;
}

Bunny load_bunny(const std::string& mesh_path, double height, std::size_t hull_vertices) {
  Bunny bunny;
  std::error_code ignored;
  if (!mesh_path.empty()) {
    bunny.mesh = read_mesh(mesh_path);
    bunny.remarks.push_back("bunny: the mesh " + mesh_path);
  } else if (std::filesystem::is_regular_file(kInstalledMesh, ignored)) {
    bunny.mesh = read_obj(kInstalledMesh);
    bunny.remarks.push_back(std::string("bunny: the Stanford bunny (Stanford Computer Graphics Laboratory), ") +
                            std::to_string(bunny.mesh.points.size()) + " vertices, from " + kInstalledMesh);
  } else {
    bunny.mesh = procedural_bunny();
    bunny.remarks.emplace_back("bunny: NOT the Stanford bunny. ")
        .append(kInstalledMesh)
        .append(" is missing, so a body of ellipsoids stands in (apt install glmark2-data, or --mesh FILE)");
  }
  fit_to_height(bunny.mesh, height);
  const Mesh full = convex_hull(bunny.mesh.points);
  bunny.hull = reduce_hull(full, hull_vertices);
  bunny.remarks.push_back(
      text("bunny: collides as its convex hull, %.0f of %.0f hull vertices; reduction loses at most %.2f mm",
           static_cast<double>(bunny.hull.hull.points.size()), static_cast<double>(full.points.size()),
           bunny.hull.loss * 1e3));
  return bunny;
}

}  // namespace carom::tools
