// Two convex outlines over one plane, cut against each other: where they overlap, and at which corners.
#pragma once

#include <algorithm>
#include <span>

#include "collision/manifold/facet.h"

namespace carom::collision {

struct OutlineCorner {
  Real x, y;           // m
  std::uint32_t name;  // for matching; 0: unknown
};

/// The height of a plane over that of the outline, m: height + slope_x x + slope_y y.
struct OutlinePlane {
  Real height, slope_x, slope_y;
};

/// A facet seen along a normal: its outline in the plane, and its height over it, an affine function of the place; of a
/// facet of several faces, the least or greatest of several, as it is convex.
struct Outline {
  static constexpr int kMax = 64;         // corners; of more, evenly spaced ones are taken
  static constexpr std::size_t kMostWithin = Facet::kMostCorners, kMostPlanes = Facet::kMostUnited;
  int count = 0;                          // 1: a point, 2: a line, else a polygon, counter-clockwise
  Real x[kMax], y[kMax];                  // m
  std::uint32_t name[kMax];               // of the corner, for matching; 0: unknown
  Real in_x[kMax], in_y[kMax], in[kMax];  // of the side that leaves a corner: in_x x + in_y y - in is m inside it
  Real height = 0, slope_x = 0, slope_y = 0;

  // Of several faces:
  std::size_t planes = 0, within_count = 0;
  bool below = false;  // it is the under side of its shape
  OutlinePlane plane[kMostPlanes];
  OutlineCorner within[kMostWithin];  // corners that lie within the outline

  /// Once all corners stand: what is inside which side.
  void close();
  /// The outline of points (it sorts them); those within it are kept as such.
  void wrap(std::span<OutlineCorner> points);
  void add_plane(const OutlinePlane& p) { plane[planes++] = p; }

  Real z(Real px, Real py) const {
    if (planes == 0) return height + slope_x * px + slope_y * py;
    Real most = kInfinity;  // of the upper side the least height, of the lower the greatest
    const Real sign = below ? -1 : 1;
    for (std::size_t k = 0; k < planes; ++k)
      most = std::min(most, sign * (plane[k].height + plane[k].slope_x * px + plane[k].slope_y * py));
    return sign * most;
  }
};

/// One corner of the overlap.
struct ClippedVertex {
  Real x, y;              // m
  std::uint32_t feature;  // which corners or sides met; 0: unknown
};

/// Receives the corners of an overlap, any number.
class ClippedVertices {
 public:
  static constexpr int kMax = 16;
  int count = 0;
  ClippedVertex at[kMax];

  /// Add a corner unless it is there already (within 2 `same`); when the array is full, corners that no direction of
  /// eight singles out, weighed by their height at kChoiceTilt, nor the least separation, make place.
  /// @param separation  m
  void add(const ClippedVertex& m, Real separation, Real same);

 private:
  void thin();
  Real separation_[kMax];
};

/// Corners of the overlap of two outlines. Empty if they pass by each other; a line and a line give the place where
/// they cross, or, within 0.03 rad of parallel, the two ends of what they share.
/// @param tolerance  m: a corner this far outside still counts as inside, and corners this close are one
void cut_outlines(const Outline& a, const Outline& b, Real tolerance, ClippedVertices& out);

}  // namespace carom::collision
