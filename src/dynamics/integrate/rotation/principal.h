// Principal axes of a body, in the order in which rotation methods want them.
#pragma once

#include "core/pose.h"

namespace carom::dynamics {

/// A body as its rotation method sees it. Axis x has the middle moment of inertia, y is the one whose reciprocal is
/// nearer to the middle one's: dy and dz have opposite signs, and vanish together with what two axes differ by.
struct Principal {
  Real base = 0, dy = 0, dz = 0;     // 1/(kg m^2): 1/I_x, 1/I_y - 1/I_x, 1/I_z - 1/I_x
  Vec3 moment = Vec3::zero();        // kg m^2: I_x, I_y, I_z
  Quat frame = Quat::identity();     // principal axes -> body axes, where these are not each other's up to order
  std::uint8_t axis[3] = {0, 1, 2};  // of world and body alike: x, y, z here are these there
  Real sign = 1;                     // -1: that order is left-handed, which turns rotations round
  bool aligned = true;               // the frame is the identity

  /// The same vector (a rotation's: omega, momentum) with axes in the order of this top, and back.
  Vec3 sorted(const Vec3& v) const { return Vec3(sign * v[axis[0]], sign * v[axis[1]], sign * v[axis[2]]); }
  Vec3 unsorted(const Vec3& v) const {
    Vec3 u;
    u[axis[0]] = sign * v.x(), u[axis[1]] = sign * v.y(), u[axis[2]] = sign * v.z();
    return u;
  }
  /// Likewise an orientation body -> world, as one of the principal axes.
  Quat sorted(const Quat& q) const {
    if (!aligned) return q * frame;
    const Vec3 v = sorted(Vec3(q.vec()));
    return Quat(q.w(), v.x(), v.y(), v.z());
  }
  Quat unsorted(const Quat& q) const {
    if (!aligned) return q * frame.conjugate();
    const Vec3 v = unsorted(Vec3(q.vec()));
    return Quat(q.w(), v.x(), v.y(), v.z());
  }
};

/// @param inertia  [3][3] kg m^2, symmetric, positive definite
/// @accuracy       off-diagonal residue below u of the trace; a diagonal inertia is taken as it is, without rounding
/// @source         cyclic Jacobi rotations; nothing but + - * / and roots, so that every platform gets the same bits
/// @oracle         tests/unit/dynamics/test_principal
Principal principal_axes(const Mat3& inertia);

}  // namespace carom::dynamics
