// From the support function alone: bounds, volume, centre and inertia, each with a rigorous bracket.
#pragma once

#include "collision/shape.h"

namespace carom::collision {

/// World bounds of a shape.
/// @param r  [3x3] shape -> world   @param p [3] m
/// Closed forms and declared vertices directly, six support calls for other shapes. No allocation.
/// @return   bounds, exact to rounding; of a half-space all of space, or what is behind its plane if that is square to
///           an axis; empty (lo > hi) if the support function failed, with the fault
Aabb world_bounds(const Shape& shape, const Mat3& r, const Vec3& p, SupportFault& fault);

/// Bounds and bounding radius from six (and a few more) support calls: fills shape.bounds and shape.bounding_radius.
bool derive_bounds(Shape& shape, SupportFault& fault);

/// Volume, centre and inertia by growing an inscribed polytope at its worst facet until the relative width of the
/// volume bracket is below tolerance or max_supports is reached. The bracket is rigorous up to rounding:
///   V_in = sum(A H / 3) <= V <= sum(A H / 3 (1 + g/H)^3) = V_out,  A facet area, H its height over an inner point, g
///   its gap.
/// The core radius is included.
MassProperties mass_from_support(const Shape& shape, Real tolerance, int max_supports, SupportFault& fault);

/// Closed-form mass properties of a form with the numbers in shape (radius, half_height, half, vertices); exact to
/// rounding. A polytope may repeat points or have some inside; a flat one has volume 0. Form::none and the half-space:
/// all zero, not exact.
/// @param memory  for the hull of a polytope, while it is computed
MassProperties mass_from_form(Form form, Real radius, Real half_height, const Vec3& half,
                              std::span<const double> vertices, Memory* memory = std::pmr::get_default_resource());

}  // namespace carom::collision
