// Rotations and rigid poses.
#pragma once

#include "core/quat.h"
#include "core/trig.h"

namespace carom::core {

/// A rigid placement of one frame in another: x_outer = q x_inner + p.
struct Pose {
  Quat q = Quat::identity();  // unit, inner -> outer
  Vec3 p = Vec3::zero();      // m, outer frame

  Vec3 apply(const Vec3& x) const { return q * x + p; }
  Pose operator*(const Pose& inner) const { return {q * inner.q, q * inner.p + p}; }
  Pose inverse() const { return {q.conjugate(), -(q.conjugate() * p)}; }
};

/// The same placement as a matrix, for places that transform many points.
struct Frame {
  Mat3 r = Mat3::identity();
  Vec3 p = Vec3::zero();

  Frame() = default;
  Frame(const Mat3& rotation, const Vec3& position) : r(rotation), p(position) {}
  explicit Frame(const Pose& pose) : r(pose.q.matrix()), p(pose.p) {}
  Vec3 apply(const Vec3& x) const { return r * x + p; }
  Vec3 apply_inverse(const Vec3& x) const { return r.transpose() * (x - p); }
  Vec3 rotate(const Vec3& x) const { return r * x; }
  Vec3 rotate_inverse(const Vec3& x) const { return r.transpose() * x; }
  Frame operator*(const Frame& inner) const { return {r * inner.r, r * inner.p + p}; }
};

/// Whether a relative pose is one: finite, with squares that stay finite, and a matrix whose entries could be a
/// rotation's (their absolute sum is at most 3 sqrt 3). Bodies that lost their numbers are quarantined upstream; a
/// query by a host is not.
inline bool usable(const Frame& f) { return f.p.abs().sum() < 1e100 && f.r.abs().sum() < 6; }

/// B's frame seen from A's, formed from the difference of positions first, so that two bodies 1e6 m from the origin
/// lose no digits of their distance beyond those that their positions lack already.
inline Frame relative(const Frame& a, const Frame& b) { return {a.r.transpose() * b.r, a.r.transpose() * (b.p - a.p)}; }

/// How far the points of one of two bodies have moved as the other sees them, at most; of the smaller body, whose
/// points move less.
///   D = |p' - p| + 2 sin(theta/2) r      for a rotation by theta
/// @param then, now  frame of B in A's
/// @param radius_a, radius_b  m, about the origins of the frames
/// @return     m; also what any support value of the bodies' difference, and their distance, has changed by at most
/// @accuracy   2 sin(theta/2) to 16 u, for matrices that are rotations to some u each
/// @oracle     tests/unit/core/test_pose
inline Real motion_bound(const Frame& then, const Frame& now, Real radius_a, Real radius_b) {
  // |R' - R| as an operator is 2 sin(theta/2), its Frobenius norm sqrt(2) times that.
  const Real turned = (now.r - then.r).norm() / std::sqrt(Real(2));
  const bool of_b = radius_b <= radius_a;
  const Vec3 shift = of_b ? Vec3(now.p - then.p) : Vec3(now.r.transpose() * now.p - then.r.transpose() * then.p);
  return shift.norm() + turned * (of_b ? radius_b : radius_a);
}

/// How far any point of a body has moved, at most.
///   D = |p' - p| + 2 sin(theta/2) r      for a rotation by theta
/// @param then, now  frame of the body   @param radius  m, about its origin; may be infinite
/// @return     m, 0 only if the frame is the same; infinite or no number where no bound is known
/// @accuracy   rounded up: not below the truth for matrices that are rotations to 4 u
/// @oracle     tests/unit/core/test_pose
inline Real way_bound(const Frame& then, const Frame& now, Real radius) {
  constexpr Real kUp = 1 + 16 * kUnitRoundoff;
  const Real turned = (now.r - then.r).norm();
  const Real swing = turned == 0 ? 0 : (kUp * turned / std::sqrt(Real(2)) + 16 * kUnitRoundoff) * radius;
  return kUp * ((now.p - then.p).norm() + swing);
}

/// Rotation by a rotation vector (exponential map).
///   q = (cos |phi|/2, sin(|phi|/2) phi/|phi|)
/// @param phi  [3] rad, axis times angle
/// @return     [4] unit to 2 eps
/// @accuracy   4 eps; the series below |phi| = 1e-3 has a remainder below 1e-17
/// @oracle     tests/unit/core/test_pose
inline Quat exp_map(const Vec3& phi) {
  const Real angle2 = phi.squared_norm();
  Real scale, w;
  if (angle2 < 1e-6) {
    scale = 0.5 - angle2 / 48 + angle2 * angle2 / 3840;  // sin(x/2)/x
    w = 1 - angle2 / 8 + angle2 * angle2 / 384;          // cos(x/2)
  } else {
    const Real angle = std::sqrt(angle2);
    const SinCos half = sin_cos(angle / 2);
    scale = half.sin / angle;
    w = half.cos;
  }
  return Quat(w, scale * phi.x(), scale * phi.y(), scale * phi.z());
}

/// Scale back to unit length; a quaternion that lost its meaning (zero, not finite) becomes identity.
inline Quat normalized(const Quat& q) {
  const Real n2 = q.squared_norm();
  if (!(n2 > 0) || !finite(n2)) return Quat::identity();
  const Real s = 1 / std::sqrt(n2);
  return Quat(q.w() * s, q.x() * s, q.y() * s, q.z() * s);
}

/// What a host gives as an orientation: as it is where its length is 1 to rounding, else scaled to that. So twice gives
/// what once gives, and what a step left (normalized() ends each) comes back with its own bits.
///   Proof: with all roundings within u, normalized() leaves |q|^2 = 1 to 3 u of its sum and 6 u of a root, a quotient
///   and a product; the sum here adds 3 u.
/// @oracle     tests/unit/core/test_pose
inline Quat oriented(const Quat& q) { return std::abs(q.squared_norm() - 1) <= 12 * kUnitRoundoff ? q : normalized(q); }

}  // namespace carom::core
