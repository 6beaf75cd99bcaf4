// Which vertex of a polytope lies farthest along a direction: a scan of few, a climb over many.
#pragma once

#include <span>

#include "core/memory.h"
#include "core/vec.h"

namespace carom::collision {

/// The vertices of a declared polytope, arranged once for the question that a narrow phase asks most.
///
/// Many vertices are climbed: from a table's guess for the direction, along the edges of the hull, to a vertex without
/// a better neighbour. On a convex polytope that is the best of all, but only if "better" is judged without error:
/// where a face is flat but for rounding, or vertices crowd, rounded results stop the climb anywhere. So the climb
/// lives on a grid of its own, in whole numbers: its edges are those of the hull of the grid points, which is exact
/// (hull.h), and so is every comparison. What is left is the way from a vertex to its grid point.
class FarthestVertex {
 public:
  /// From so many points on a climb is faster than a scan: a climb costs about the same at any size, a scan 0.7 ns a
  /// point (within queries of random pairs, SSE2, 2.3 GHz).
  static constexpr std::size_t kClimb = 96;

  explicit FarthestVertex(Memory* memory)
      : coordinates_(memory), corners_(memory), neighbours_(memory), guesses_(memory) {}

  /// Arrange points; any order, repeated, flat, some within the hull. The only function here that allocates.
  /// @param xyz  [3k] m, k >= 1; finite
  void build(std::span<const double> xyz);
  bool empty() const { return coordinates_.empty() && corners_.empty(); }
  bool climbs() const { return !corners_.empty(); }

  /// @param n    [3] |n_i| < 8
  /// @return     index of a point of the build that attains max n . x. The first of equals in a scan of four lanes,
  ///             whichever the walk meets first in a climb: it depends on the points and on n alone
  /// @accuracy   n . x falls short of the largest, for unit n: in a climb by at most 11 u times half the longest side
  ///             of the bounding box, for on each axis a vertex is 2 u off its grid point (half a step) and 1 u for
  ///             taking the centre off, 3 sqrt 3 u in all, once for the vertex returned and once for the best; in a
  ///             scan by 6 u times the distance of the vertices from the origin, three products and two sums, twice.
  ///             Both are within kSupportRounding
  /// @errors     none: a direction that is no number gives some vertex
  /// @oracle     tests/unit/collision/test_farthest_vertex
  std::uint32_t operator()(const Vec3& n) const { return climbs() ? climb(n) : scan(n); }

  struct Corner {
    std::int64_t x, y, z;  // grid steps, below 2^52
    std::uint32_t first;   // of its neighbours; they end where those of the next corner begin
    std::uint32_t point;   // in the build
  };
  /// What it was arranged as, for device/pairs.c: names as below.
  struct Parts {
    std::uint32_t count, cells;
    std::span<const double> coordinates;
    std::span<const Corner> corners;
    std::span<const std::uint32_t> neighbours, guesses;
  };
  Parts parts() const { return {count_, cells_, coordinates_, corners_, neighbours_, guesses_}; }

 private:
  static constexpr std::uint32_t kLanes = 4;

  void prepare_scan(std::span<const double> xyz);
  bool prepare_climb(std::span<const double> cloud);
  void link_corners(std::span<const Vec3> y, std::span<const std::uint32_t> name,
                    std::span<const std::uint32_t> triangles);
  void fill_guesses();
  std::uint32_t scan(const Vec3& n) const;
  std::uint32_t climb(const Vec3& n) const { return corners_[climb_from(guess(n), n)].point; }
  std::uint32_t guess(const Vec3& n) const;
  std::uint32_t climb_from(std::uint32_t at, const Vec3& n) const;

  std::uint32_t count_ = 0;          // scan: points
  Array<double> coordinates_;        // [3][padded] scan: all x, all y, all z; the last point repeated
  Array<Corner> corners_;            // [k + 1] climb; the last one only ends the neighbours of the one before
  Array<std::uint32_t> neighbours_;  // climb: corners
  std::uint32_t cells_ = 0;
  Array<std::uint32_t> guesses_;  // [6][cells_][cells_] climb: a corner for each patch of directions
};

}  // namespace carom::collision
