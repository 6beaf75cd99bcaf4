// Carry-over: the bracket of an earlier pose, widened by what moved since, in place of a query.
#pragma once

#include "collision/narrow/query.h"

namespace carom::collision {

/// Remember a result; one without a bracket of the distance (a fault, or "farther") makes the certificate unknown.
void certify(const QueryResult& result, const Frame& b_in_a, Real shell, Certificate& certificate);

/// The signed distance at a new pose, if the certificate still says enough.
///
/// A point x of B moves in A's frame by (R' - R) x + p' - p, at most D = |p' - p| + 2 sin(theta / 2) r_B for a rotation
/// by theta. So does every support value h(n) of the difference, for every n, and with them their maximum, the signed
/// distance: it lies within D of the old bracket. The motion of A in B's frame serves as well; that of the smaller
/// shape is taken. From below the old normal, fixed to A or to B, gives a fresh bound with one look each, and it is
/// that bound which is the result's separation; apart, the old witness points give one from above. The points of
/// contact move with the bodies.
/// @param width  m: upper - lower may be as wide
/// @param result a true bracket, normal and points fit for a contact; support_calls is 1 or 2. Meaningless if false
/// @return       false if the bracket has become wider, or a support function misbehaved: ask afresh
/// @accuracy     the bracket, widened by 48 u M and as much again for D
/// @oracle       tests/unit/collision/test_carry_over
bool carry_over(const Shape& a, const Shape& b, const Frame& b_in_a, Real width, Real shell,
                const Certificate& certificate, QueryResult& result);

}  // namespace carom::collision
