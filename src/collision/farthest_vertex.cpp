// Arranging vertices for a scan or a climb, and both.
#include "collision/farthest_vertex.h"

#include <algorithm>
#include <numeric>

#include "collision/hull.h"
#include "collision/scan_kernels.h"
#include "core/int128.h"

namespace carom::collision {

namespace {

/// A direction in whole numbers, good to 2^-61, and its exact products with corners.
struct WholeDirection {
  // |n_i| < 8 fits in 63 bits; three products with 52 bits stay below 2^117.
  explicit WholeDirection(const Vec3& n) : x(whole(n.x())), y(whole(n.y())), z(whole(n.z())) {}
  template <class Corner>
  Int128 along(const Corner& c) const {
    return static_cast<Int128>(x) * c.x + static_cast<Int128>(y) * c.y + static_cast<Int128>(z) * c.z;
  }
  std::int64_t x, y, z;

 private:
  static std::int64_t whole(Real t) { return static_cast<std::int64_t>(t * 0x1p60); }
};

/// A direction's cell on the faces of a cube: the largest component names the face, the other two the place on it.
std::uint32_t cell_of(const Vec3& n, std::uint32_t cells) {
  const Vec3 a = n.abs();
  const int wider = a.y() > a.x(), axis = wider + (a.z() > std::max(a.x(), a.y())) * (2 - wider);  // without a branch
  const Real half = 0.5 * cells, scale = half / a[axis];
  const auto place = [&](Real t) {
    const Real at = t * scale + half;
    return at < cells ? static_cast<std::uint32_t>(at) : cells - 1;  // the zero vector, 0 / 0, ends here too
  };
  const std::uint32_t face = static_cast<std::uint32_t>(2 * axis) + (n[axis] < 0);
  return (face * cells + place(n[axis == 0 ? 1 : 0])) * cells + place(n[axis == 2 ? 1 : 2]);
}

Vec3 middle_of(std::uint32_t cell, std::uint32_t cells) {
  const std::uint32_t face = cell / (cells * cells);
  const auto place = [&](std::uint32_t at) { return (2 * at + 1) / Real(cells) - 1; };
  const int axis = static_cast<int>(face / 2);
  Vec3 d;
  d[axis] = face % 2 ? -1 : 1;
  d[axis == 0 ? 1 : 0] = place(cell / cells % cells);
  d[axis == 2 ? 1 : 2] = place(cell % cells);
  return d;
}

Vec3 point_of(std::span<const double> xyz, std::size_t i) { return Vec3(xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]); }

/// Points on a hull's grid: centred, the longest half side in [0.99, 1.98) so that differences stay below 4, snapped.
void put_on_grid(std::span<const double> xyz, Array<Vec3>& y) {
  Vec3 lo = Vec3::constant(kInfinity), hi = -lo;
  for (std::size_t i = 0; i < y.size(); ++i) {
    lo = lo.min(point_of(xyz, i));
    hi = hi.max(point_of(xyz, i));
  }
  const Vec3 centre = 0.5 * (lo + hi);
  const Real half = 0.5 * (hi - lo).max_entry();
  const Real scale = half > 0 ? std::ldexp(Real(1), -std::ilogb(1.01 * half)) : 1;
  for (std::size_t i = 0; i < y.size(); ++i) y[i] = HullMesh::snap(scale * (point_of(xyz, i) - centre));
}

/// Corners of a hull that do not lie within a flat face: one of the neighbours is off the plane of one of the facets.
void find_bent(std::span<const Vec3> y, std::span<const std::uint32_t> triangles, Array<std::uint8_t>& bent) {
  Array<std::uint32_t> facet_at(y.size(), 0, bent.get_allocator().resource());
  for (std::uint32_t t = 0; t < triangles.size(); ++t) facet_at[triangles[t]] = t - t % 3;
  bent.assign(y.size(), 0);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const std::uint32_t from = triangles[t], to = triangles[t % 3 == 2 ? t - 2 : t + 1];
    const std::uint32_t* f = &triangles[facet_at[from]];
    bent[from] |= HullMesh::orientation(y[f[0]], y[f[1]], y[f[2]], y[to]) != 0;
  }
}

/// Indices of four points that span as much as any.
bool find_start(std::span<const double> xyz, std::uint32_t start[4]) {
  const FitFrame frame = fit_frame_of_points(xyz);
  for (std::uint32_t i = 0; !frame.flat && i < xyz.size() / 3; ++i)
    for (int k = 0; k < 4; ++k)
      if (point_of(xyz, i) == frame.start[k]) start[k] = i;
  return !frame.flat;
}

}  // namespace

void FarthestVertex::build(std::span<const double> xyz) {
  coordinates_.clear();
  corners_.clear();
  if (xyz.size() < 3 * kClimb || !prepare_climb(xyz)) prepare_scan(xyz);
}

void FarthestVertex::prepare_scan(std::span<const double> xyz) {
  count_ = static_cast<std::uint32_t>(xyz.size() / 3);
  const std::size_t padded = (count_ + kLanes - 1) / kLanes * kLanes;
  coordinates_.resize(3 * padded);
  for (std::size_t i = 0; i < padded; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      coordinates_[k * padded + i] = xyz[3 * std::min<std::size_t>(i, count_ - 1) + k];
}

/// @return false, and nothing done, if the points are flat to rounding
bool FarthestVertex::prepare_climb(std::span<const double> cloud) {
  Memory* memory = corners_.get_allocator().resource();
  Array<double> xyz(cloud.begin(), cloud.end(), memory);
  Array<Vec3> y(cloud.size() / 3, memory);
  put_on_grid(xyz, y);
  Array<std::uint32_t> name(y.size(), memory), triangles(memory);
  std::iota(name.begin(), name.end(), 0u);
  Array<std::uint8_t> bent(memory);
  // What the hull does not need goes, corners within a flat face too: they would stop a climb that looks straight into
  // it. The second hull has none of them.
  for (;;) {
    std::uint32_t start[4] = {0, 0, 0, 0};
    if (!find_start(xyz, start) || !convex_hull_on_grid(y, start, triangles)) return false;
    find_bent(y, triangles, bent);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < name.size(); ++i) {
      if (!bent[i]) continue;
      std::copy_n(&xyz[3 * i], 3, &xyz[3 * kept]);
      y[kept] = y[i];
      name[kept++] = name[i];
    }
    if (kept == name.size()) break;
    xyz.resize(3 * kept);
    y.resize(kept);
    name.resize(kept);
  }
  link_corners(y, name, triangles);
  // Two patches a corner: finer ones guess better, but the table then leaves the cache.
  cells_ = static_cast<std::uint32_t>(std::sqrt(static_cast<Real>(name.size()) / 3)) + 1;
  fill_guesses();
  return true;
}

void FarthestVertex::link_corners(std::span<const Vec3> y, std::span<const std::uint32_t> name,
                                  std::span<const std::uint32_t> triangles) {
  Array<std::uint32_t> degree(name.size(), 0, corners_.get_allocator().resource());
  for (const std::uint32_t v : triangles) ++degree[v];  // each facet around a corner has one edge that leaves it
  const auto whole = [](Real t) { return static_cast<std::int64_t>(t / HullMesh::kGrid); };
  std::uint32_t first = 0;
  for (std::size_t v = 0; v < name.size(); ++v) {
    corners_.push_back({whole(y[v].x()), whole(y[v].y()), whole(y[v].z()), first, name[v]});
    first += degree[v];
  }
  corners_.push_back({0, 0, 0, first, 0});
  neighbours_.resize(first);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const std::uint32_t from = triangles[t], to = triangles[t % 3 == 2 ? t - 2 : t + 1];
    neighbours_[corners_[from].first + --degree[from]] = to;
  }
}

/// Each cell's corner is the one farthest along its middle, climbed to from the cell before.
void FarthestVertex::fill_guesses() {
  guesses_.resize(6 * cells_ * cells_);
  std::uint32_t at = 0;
  for (std::uint32_t cell = 0; cell < guesses_.size(); ++cell)
    guesses_[cell] = at = climb_from(at, middle_of(cell, cells_));
}

std::uint32_t FarthestVertex::guess(const Vec3& n) const { return guesses_[cell_of(n, cells_)]; }

/// A corner without a better neighbour is the best of all: its edges span the cone in which the whole polytope lies,
/// and none of them rises. (The edges of a corner within a flat face would span that face only; build() keeps no such
/// one.)
std::uint32_t FarthestVertex::climb_from(std::uint32_t at, const Vec3& n) const {
  if (!(n.abs().sum() < 8)) return 0;
  const WholeDirection d(n);
  Int128 most = d.along(corners_[at]);
  for (;;) {
    std::uint32_t best = at;
    for (std::uint32_t k = corners_[at].first; k < corners_[at + 1].first; ++k) {
      const Int128 h = d.along(corners_[neighbours_[k]]);
      if (h > most) most = h, best = neighbours_[k];
    }
    if (best == at) return at;
    at = best;
  }
}

std::uint32_t FarthestVertex::scan(const Vec3& n) const {
  const std::size_t padded = coordinates_.size() / 3;
  const std::size_t i = scan_kernel().farthest(coordinates_.data(), padded, n.data());
  return i < padded ? std::min(static_cast<std::uint32_t>(i), count_ - 1) : 0;  // padding repeats the last
}

}  // namespace carom::collision
