// Real numbers, vectors, matrices: the only place that chooses them.
//
// Eigen is used without its own vectorisation (EIGEN_DONT_VECTORIZE, set by the build): packet width would otherwise
// change the order of additions, and with it the bits of a trajectory. Wide kernels are written out by hand.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>  // cross(), whose absence only the linker notices
#include <cmath>
#include <cstdint>
#include <limits>

#ifndef EIGEN_DONT_VECTORIZE
#error "build with EIGEN_DONT_VECTORIZE: same bits at every SIMD width"
#endif

namespace carom {

using Real = double;
using Vec3 = Eigen::Matrix<Real, 3, 1, Eigen::DontAlign>;
using Mat3 = Eigen::Matrix<Real, 3, 3, Eigen::DontAlign>;

inline constexpr Real kInfinity = std::numeric_limits<Real>::infinity();
inline constexpr Real kEpsilon = std::numeric_limits<Real>::epsilon();  // 2^-52: spacing of numbers at 1
inline constexpr Real kUnitRoundoff = kEpsilon / 2;                     // u: |fl(x op y) - (x op y)| <= u |x op y|

inline bool finite(Real x) { return std::isfinite(x); }
inline bool finite(const Vec3& v) { return finite(v.x()) && finite(v.y()) && finite(v.z()); }

/// Any unit vector at right angles to a unit vector. Deterministic, continuous except at n.z = -0.
/// @source [Duff2017]
inline Vec3 any_perpendicular(const Vec3& n) {
  const Real sign = std::copysign(Real(1), n.z());
  const Real a = Real(-1) / (sign + n.z());
  return Vec3(Real(1) + sign * n.x() * n.x() * a, sign * n.x() * n.y() * a, -sign * n.x());
}

/// The matrix K with K x = v cross x.
inline Mat3 cross_matrix(const Vec3& v) {
  Mat3 k;
  k << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return k;
}

}  // namespace carom
