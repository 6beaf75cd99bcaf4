// A face of one box cut to the outline of a face of the other: Sutherland-Hodgman in the coordinates of the outline.
#pragma once

#include <cstdint>

#include "core/vec.h"

namespace carom::collision {

/// A corner of a polygon over a rectangle |x| <= half_x, |y| <= half_y, with its height z above it.
struct Corner {
  Real x, y, z;        // m
  std::uint32_t side;  // label of the side that leaves this corner: 0..3 of the polygon itself, 4..7 of the rectangle
};

struct Polygon {
  // A rectangle cut by four half-planes has at most 8 corners. The rest is for rounding: a side that grazes an edge may
  // be cut twice more.
  static constexpr int kMax = 16;
  int count = 0;
  Corner corner[kMax];
};

/// Cut away what lies outside the rectangle. Corners on its outline stay as they are.
/// @accuracy  a cut corner lies on the side it was cut from to 4 u times the size
void clip_to_rectangle(Polygon& polygon, Real half_x, Real half_y);

}  // namespace carom::collision
