// Depth of two bodies of revolution on one axis: the one place where a ring of equal minimisers is a single point.
#pragma once

#include "collision/narrow/epa.h"

namespace carom::collision {

/// The axis that two shapes share, and by how much they miss it.
///
/// The nearest surface of such a pair is a ring, which no polytope approaches fast: n vertices around a ring of radius
/// d leave d (1 - cos(pi / n)) between it and the bracket, 3e-5 d for all 512 that EPA may have. Revolved, a polygon of
/// a dozen corners leaves nothing. Who is allowed to revolve says the declared form, which was verified.
struct Axis {
  Vec3 along = Vec3::unit_y();  // unit, A's frame, through A's origin
  Real uneven = kInfinity;      // m: no point of B is farther from where it would be on that axis; infinite: no axis
  Real tilt = 0;                // angle between the shapes' own axes, as twice the sine of its half
};

/// @return the axis of two bodies of revolution, as far as they are (sphere, capsule, cylinder, cone, ellipsoid with
/// two
///         equal radii); the caller decides how uneven is too uneven
Axis common_axis(const Shape& a, const Shape& b, const Frame& b_in_a);

/// Narrow the bracket of a difference that holds the origin and is a body of revolution about an axis, nearly: EPA in
/// the half-plane through it, on the profile.
/// @param axis    of a difference within axis.uneven of a body of revolution. The points found are then within as much
/// of
///                that body, the body within as much of the difference: a ball inside the revolved polygon, less twice
///                this, is inside the difference. The bound from below is of the difference itself
/// @param cap     iterations, at most kMaxEpaIterations
/// @param simplex out: as epa()
/// @return        as epa(); stuck, with a true bracket and no witness, where rounding or unevenness leave nothing to
/// gain
/// @oracle        tests/unit/collision/test_coaxial
EpaEnd coaxial(Difference& difference, const Axis& axis, Real gap, int cap, DifferenceSimplex& simplex,
               int& iterations);

}  // namespace carom::collision
