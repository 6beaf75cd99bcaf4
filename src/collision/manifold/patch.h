// A pair's whole contact patch in one shot, from support functions, or from faces where a shape declares them.
#pragma once

#include "collision/manifold/manifold.h"
#include "collision/shape.h"

namespace carom::collision {

/// A pair as the patch sees it. At most one of the two is a half-space.
struct PatchPair {
  const Shape &a, &b;
  const Frame &frame_a, &frame_b;  // shape -> world
  Real shell;                      // m: what a margin adds around each shape (Method::hybrid)
};

/// Under what relative pose a kept patch was made, and whether it may be kept at all.
struct PatchMemory {
  bool firm = false;             // none of its facets is round
  bool of_b = false;             // its normal is a face of B's; else A's, or of two edges
  Vec3 normal = Vec3::unit_y();  // unit, A to B, frame of that one
  Frame b_in_a;                  // when it was made
};

/// Replace a manifold by the whole patch. Ages go on where an old point is found again.
/// @param found   what the query found, in the world: its deepest point gives the normal to start from
/// @param calls   raised by the number of support calls
/// @return        false if a support function misbehaved: fault is filled, the manifold is empty
/// @accuracy      points on both cores' facets to rounding; see facet.h for the normal
/// @source        support mapping along tilted directions; README.md says how
/// @oracle        tests/unit/collision/test_patch
bool update_patch(const PatchPair& pair, const Candidates& found, const ManifoldSettings& settings, Manifold& manifold,
                  PatchMemory& memory, std::uint64_t& calls, SupportFault& fault);

/// The same for a patch that a specific routine found whole: points adopted, and kept while little moves if both shapes
/// are flat where they meet.
void adopt_patch(const PatchPair& pair, const Candidates& found, const ManifoldSettings& settings, Manifold& manifold,
                 PatchMemory& memory);

/// The points of a patch, before four are chosen.
struct PatchPoints {
  static constexpr int kMax = 17;
  int count = 0;
  bool flat = false;  // both sides are: no facet is round
  ContactPoint point[kMax];
};

/// How a patch is asked for by who knows more than the two shapes do, @see scenery/meet.h
struct PatchTerms {
  bool fixed = false;  // the normal is right as it is, and the nearest point itself is no point of the patch
  Real reach = 0;      // m, @see fit_facet()
  Real tolerance = 0;  // m: beyond that of the pair's own numbers
};

/// All points of the patch of a pair.
/// @param nearest  a point of it, and the normal to start from
/// @return         false if a support function misbehaved
bool find_patch(const PatchPair& pair, const ContactPoint& nearest, const PatchTerms& terms, PatchPoints& points,
                std::uint64_t& calls, SupportFault& fault);

/// Whether the last patch still holds at the present poses; if so its separations are measured again and its points
/// grow a step older. Nothing is asked of the shapes.
bool keep_patch(const PatchPair& pair, const ManifoldSettings& settings, const PatchMemory& memory, Manifold& manifold);

}  // namespace carom::collision
