// Two convex outlines over one plane, cut against each other: where they overlap, and at which corners.
#pragma once

#include "collision/manifold/facet.h"

namespace carom::collision {

/// A facet seen along a normal: its outline in the plane, and its height over it, an affine function of the place.
struct Outline {
  static constexpr int kMax = 64;         // corners; of more, evenly spaced ones are taken
  int count = 0;                          // 1: a point, 2: a line, else a polygon, counter-clockwise
  Real x[kMax], y[kMax];                  // m
  std::uint32_t name[kMax];               // of the corner, for matching; 0: unknown
  Real in_x[kMax], in_y[kMax], in[kMax];  // of the side that leaves a corner: in_x x + in_y y - in is m inside it
  Real height = 0, slope_x = 0, slope_y = 0;

  /// Once all corners stand: what is inside which side.
  void close();

  Real z(Real px, Real py) const { return height + slope_x * px + slope_y * py; }
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
  /// eight singles out, nor the least separation, make place.
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
