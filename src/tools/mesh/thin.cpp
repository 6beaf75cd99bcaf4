// A mesh thinned for the eye: corners in one cell of a grid become one.
#include <cmath>
#include <map>

#include "mesh/mesh.h"

namespace carom::tools {

Mesh thinned(const Mesh& mesh, double cell) {
  struct Cluster {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double count = 0;
  };
  std::map<std::array<long, 3>, std::uint32_t> cells;
  std::vector<Cluster> clusters;
  std::vector<std::uint32_t> place;
  place.reserve(mesh.points.size());
  for (const Eigen::Vector3d& p : mesh.points) {
    const std::array<long, 3> at = {std::lround(p.x() / cell), std::lround(p.y() / cell), std::lround(p.z() / cell)};
    const auto [found, is_new] = cells.try_emplace(at, static_cast<std::uint32_t>(clusters.size()));
    if (is_new) clusters.emplace_back();
    clusters[found->second].sum += p;
    clusters[found->second].count += 1;
    place.push_back(found->second);
  }
  Mesh thin;
  for (const Cluster& cluster : clusters) thin.points.emplace_back(cluster.sum / cluster.count);
  for (const auto& [a, b, c] : mesh.faces)
    if (place[a] != place[b] && place[b] != place[c] && place[c] != place[a])
      thin.faces.push_back({place[a], place[b], place[c]});
  return thin;
}

}  // namespace carom::tools
