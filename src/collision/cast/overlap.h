// Do two shapes overlap? Yes or no, each with its proof, and no more work than that takes.
#pragma once

#include "collision/narrow/query.h"

namespace carom::collision {

enum class Overlap : std::uint32_t { apart, overlapping, touching, fault };

struct OverlapResult {
  Overlap outcome = Overlap::touching;  // touching: within rounding neither was proven (or the cap came first)
  Real separation_bound = -kInfinity;   // m; apart: the separation is larger than this, which is larger than the target
  Vec3 normal = Vec3::zero();           // unit, A's frame, from A to B; apart: proves the bound
  Vec3 point = Vec3::zero();            // m, A's frame; overlapping: in both shapes
  Real slack = 0;                       // m, what rounding may have done
  bool capped = false;  // touching: the cap came first
  int support_calls = 0;
};

/// @param target    m, >= 0: shapes nearer than this count as overlapping; the witness then lies between them
/// @param rounding  beyond that of the narrow phase, relative to the size of the pair: what forming b_in_a cost
/// @param cap       support evaluations
OverlapResult overlap(const Shape& a, const Shape& b, const Frame& b_in_a, Real target, Real rounding, int cap,
                      SupportFault& fault);

/// Is a point (shape's frame) in a shape? The result is in that frame.
OverlapResult overlap_with_point(const Shape& shape, const Vec3& point, Real target, Real rounding, int cap,
                                 SupportFault& fault);

}  // namespace carom::collision
