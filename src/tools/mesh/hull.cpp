// Convex hulls by qhull (reentrant library), and their reduction to few vertices with the loss measured.
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

#include "host/host.h"
#include "mesh/mesh.h"
#include "mesh/solid.h"

namespace carom::tools {
namespace {

using Eigen::Vector3d;

/// qhull writes its complaints to a FILE*; keep them for the error message.
class ErrorText {
 public:
  ~ErrorText() {
    if (file_) std::fclose(file_);
  }
  FILE* file() { return file_; }
  std::string first_line() {
    char line[400] = "";
    if (file_) std::rewind(file_), static_cast<void>(std::fgets(line, sizeof line, file_) != nullptr);
    const std::string all(line);
    return all.substr(0, all.find('\n'));
  }

 private:
  FILE* file_ = std::tmpfile();  // null: they go to stderr
};

/// Largest distance from a vertex of `full` to the boundary of `kept`; vertices inside `kept` count as 0.
double hausdorff(const Mesh& full, const Mesh& kept) {
  double worst = 0;
  for (const Vector3d& p : full.points) {
    double nearest = std::numeric_limits<double>::infinity();
    bool outside = false;
    for (const auto& f : kept.faces) {
      const Vector3d &a = kept.points[f[0]], &b = kept.points[f[1]], &c = kept.points[f[2]];
      outside = outside || (b - a).cross(c - a).dot(p - a) > 0;
      nearest = std::min(nearest, distance_squared(p, a, b, c));
    }
    if (outside) worst = std::max(worst, nearest);
  }
  return std::sqrt(worst);
}

}  // namespace

Mesh convex_hull(const std::vector<Vector3d>& points) {
  std::vector<double> coordinates;
  coordinates.reserve(points.size() * 3);
  for (const Vector3d& p : points) coordinates.insert(coordinates.end(), p.data(), p.data() + 3);
  ErrorText complaints;
  qhT state;
  qh_zero(&state, complaints.file());
  char command[] = "qhull Qt Pp";  // Qt: triangulated facets
  const int failed = qh_new_qhull(&state, 3, static_cast<int>(points.size()), coordinates.data(), False, command,
                                  nullptr, complaints.file());
  Mesh hull;
  if (!failed) {
    qhT* qh = &state;  // qhull's FORALL macros name it so
    std::vector<std::uint32_t> number(points.size(), UINT32_MAX);
    facetT* facet;
    FORALLfacets {
      std::array<std::uint32_t, 3> corners{};
      std::size_t n = 0;
      vertexT *vertex, **vertexp;
      FOREACHvertex_(facet->vertices) {
        std::uint32_t& id = number[static_cast<std::size_t>(qh_pointid(qh, vertex->point))];
        if (id == UINT32_MAX) {
          id = static_cast<std::uint32_t>(hull.points.size());
          hull.points.emplace_back(vertex->point[0], vertex->point[1], vertex->point[2]);
        }
        if (n < 3) corners[n++] = id;
      }
      const Vector3d outward(facet->normal[0], facet->normal[1], facet->normal[2]);
      const Vector3d& a = hull.points[corners[0]];
      if ((hull.points[corners[1]] - a).cross(hull.points[corners[2]] - a).dot(outward) < 0)
        std::swap(corners[1], corners[2]);
      hull.faces.push_back(corners);
    }
  }
  qh_freeqhull(&state, !qh_ALL);
  int chunks = 0, bytes = 0;
  qh_memfreeshort(&state, &chunks, &bytes);
  if (failed) throw Error("no convex hull of these points: " + complaints.first_line(), "give a mesh that is not flat");
  return hull;
}

ReducedHull reduce_hull(const Mesh& hull, std::size_t limit) {
  if (hull.points.size() <= limit) return {hull, 0};
  std::vector<char> taken(hull.points.size(), 0);
  std::vector<Vector3d> kept;
  auto farthest = [&](const Vector3d& direction) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < hull.points.size(); ++i)
      if (direction.dot(hull.points[i]) > direction.dot(hull.points[best])) best = i;
    return best;
  };
  auto take = [&](std::size_t i) {
    if (!taken[i] && kept.size() < limit) kept.push_back(hull.points[i]);
    taken[i] = 1;
  };
  // Axes and diagonals: at least four points not in one plane, however the hull lies.
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z)
        if ((x || y || z) && (kept.size() < 6 || kept.size() < limit / 2)) take(farthest(Vector3d(x, y, z)));
  // All of them on one face of a flat hull: what is farthest off it takes the last one's place.
  const auto middle = [&] {
    Vector3d sum = Vector3d::Zero();
    for (const Vector3d& p : kept) sum += p;
    return Vector3d(sum / static_cast<double>(kept.size()));
  };
  for (int off = 0; off < 2; ++off) {
    const Vector3d c = middle();
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const Vector3d& p : kept) spread += (p - c) * (p - c).transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread);
    constexpr double kFlat = 1e-18;  // of squared lengths
    if (axes.eigenvalues()[0] > kFlat * axes.eigenvalues()[2]) break;
    const Vector3d n = axes.eigenvectors().col(0);
    const std::size_t i =
        std::fabs(n.dot(hull.points[farthest(n)] - c)) > std::fabs(n.dot(hull.points[farthest(-n)] - c)) ? farthest(n)
                                                                                                         : farthest(-n);
    if (kept.size() == limit) kept.pop_back();
    take(i);
  }
  Mesh now = convex_hull(kept);
  while (kept.size() < limit) {
    std::vector<std::pair<double, std::size_t>>
        gaps;  // how far the hull sticks out of each facet, and with which vertex
    for (const auto& f : now.faces) {
      const Vector3d& a = now.points[f[0]];
      const Vector3d normal = (now.points[f[1]] - a).cross(now.points[f[2]] - a);
      if (!(normal.norm() > 0)) continue;
      const std::size_t i = farthest(normal);
      if (!taken[i]) gaps.emplace_back(normal.normalized().dot(hull.points[i] - a), i);
    }
    if (gaps.empty()) break;
    std::sort(gaps.begin(), gaps.end(), [](const auto& l, const auto& r) {
      return l.first != r.first ? l.first > r.first : l.second < r.second;
    });
    // A few at a time: one by one is hardly better and needs a hull for each.
    gaps.resize(std::min(gaps.size(), std::max<std::size_t>(1, limit / 32)));
    for (const auto& [gap, i] : gaps) take(i);
    now = convex_hull(kept);
  }
  return {now, hausdorff(hull, now)};
}

std::vector<double> hull_params(const Mesh& hull) {
  std::vector<double> params;
  for (const Vector3d& p : hull.points) params.insert(params.end(), p.data(), p.data() + 3);
  return params;
}

}  // namespace carom::tools
