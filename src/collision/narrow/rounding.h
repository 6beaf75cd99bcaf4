// What rounding can do to a bracket: the error analysis that makes it rigorous.
#pragma once

#include "core/vec.h"

namespace carom::collision {

/// Half-width, in units of u M, that is added to both sides of every bracket of the generic path and of the casts.
///
/// The bounds are of the shapes as given: A, and B placed by the frame (R, p) as it stands in memory. Notation: u unit
/// roundoff; a, b core radii about the shapes' origins; |p| the offset; c the radii taken off at the end;
/// M = |p|_1 + a + b + c. First order in u; terms in u^2 are far below what is rounded up. For a rotation
/// || |R| ||_2 <= 5/3, so a product with R errs by 3 u 5/3 = 5 u of its operand. All in units of u:
///
/// From below, s* >= n . w / |n| for the direction n looked along and the support point w = R x_B + p - x_A:
///
///     direction for B, n_B = -R' n: off by 5, which moves the best point of B by at most its diameter     10 b
///     the way asked along, off n by 1                                                                     2 a + 2 b
///     the support functions themselves, whose values may fall short by kSupportRounding                   12 a + 12 b
///     w: product with R 5 b, adding p, subtracting x_A                                                7 b + 2 |p| + a
///     n . w, three products                                                                          3 a + 3 b + 3 |p|
///     |n|, off from 1 by kUnitLength                                                                 8 a + 8 b + 8 |p|
///     radii taken off, and the widening itself                                                       2 M
///     sum                                                                      28 a + 44 b + 15 |p| + 2 c  <=  44 M
///
/// From above, apart: |v| of a convex combination v of points w_i:
///
///     w_i as above, and support points outside their set by kSupportRounding           13 a + 19 b + 2 |p|
///     weights that sum to 1 to 5 u: v is a point of the set times that                   5 (a + b + |p|)
///     the sum of four products                                                         4 (a + b + |p|)
///     the length, and the radii taken off                                              3 (a + b + |p|) + 2 M
///     sum                                                                              <=  33 M
///
/// From above, in overlap: the smallest offset n . w_i of the faces of a closed mesh that are seen from within, each
/// larger than the rounding itself. Solid angles of one sign add up to a multiple of 4 pi that is not zero: the mesh
/// winds around the origin, so all within the smallest offset belongs to the difference. Offsets err as the bound from
/// below does, without the support functions' shortfall but with points outside: <= 44 M.
///
/// So 44 would do; 48 allows for what Eigen's order of operations adds. Observed worst case over random and
/// awkward pairs: 3.5 (tests/oracle/test_rounding).
inline constexpr Real kBracketRounding = 48;

/// What a support function may lose or gain, in units of u times the shape's radius: the best point's value, and how
/// far outside the set a point may be. Our own stay within (tests/oracle/test_rounding); a plugin that is worse, up to
/// what is accepted when a shape is made (kSloppiness), widens the truth by its own error.
inline constexpr Real kSupportRounding = 12;

/// How far the length of a direction handed to Difference::support may be from 1, in units of u.
inline constexpr Real kUnitLength = 8;

/// What forming the frame of B in A from two world poses can cost, in units of u (|p_B - p_A| + radii). Per quaternion:
/// normalisation leaves its length off by 5 u, which its matrix shows up to fourfold, its direction off by 2 u, and the
/// matrix' own sums 9 u: 31. Two of them and their product (8) displace B's points by 70 of their radius; the offset
/// pays for one of them, a product (5) and the difference (1). Positions lose nothing more, however far out both are.
inline constexpr Real kPoseRounding = 72;

}  // namespace carom::collision
