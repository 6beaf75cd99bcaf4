// Rotations as quaternions.
#pragma once

#include "core/vec.h"

namespace carom::core {

/// w + x i + y j + z k: w, x, y, z in calls; x, y, z, w in memory. A rotation where its length is 1. Products and turns
/// add in one order, as vectors do (core/vec.h).
template <class T>
struct Quaternion {
  T at[4];

  Quaternion() = default;  // not initialised, as a number is not
  constexpr Quaternion(T w, T x, T y, T z) : at{x, y, z, w} {}
  /// Of a rotation matrix; any unit quaternion's matrix gives it or its negative back.
  /// @accuracy  4 eps  @source [Shoemake1987]
  explicit Quaternion(const Matrix3<T>& m) {
    const T trace = m.trace();
    if (trace > 0) {
      const T root = std::sqrt(trace + 1), s = T(0.5) / root;
      *this = {T(0.5) * root, (m(2, 1) - m(1, 2)) * s, (m(0, 2) - m(2, 0)) * s, (m(1, 0) - m(0, 1)) * s};
      return;
    }
    const int first = m(1, 1) > m(0, 0), i = m(2, 2) > m(first, first) ? 2 : first, j = (i + 1) % 3, k = (j + 1) % 3;
    const T root = std::sqrt(m(i, i) - m(j, j) - m(k, k) + 1), s = T(0.5) / root;
    at[i] = T(0.5) * root, at[j] = (m(j, i) + m(i, j)) * s, at[k] = (m(k, i) + m(i, k)) * s;
    at[3] = (m(k, j) - m(j, k)) * s;
  }
  static constexpr Quaternion identity() { return {1, 0, 0, 0}; }
  static constexpr Quaternion zero() { return {0, 0, 0, 0}; }

  constexpr T w() const { return at[3]; }
  constexpr T x() const { return at[0]; }
  constexpr T y() const { return at[1]; }
  constexpr T z() const { return at[2]; }
  constexpr T& w() { return at[3]; }
  constexpr T& x() { return at[0]; }
  constexpr T& y() { return at[1]; }
  constexpr T& z() { return at[2]; }
  constexpr Vector3<T> vec() const { return {at[0], at[1], at[2]}; }
  constexpr const T* data() const { return at; }
  constexpr T* data() { return at; }

  constexpr Quaternion conjugate() const { return {at[3], -at[0], -at[1], -at[2]}; }
  constexpr T squared_norm() const { return (at[0] * at[0] + at[1] * at[1]) + (at[2] * at[2] + at[3] * at[3]); }
  T norm() const { return std::sqrt(squared_norm()); }
  constexpr T dot(const Quaternion& o) const {
    return (at[0] * o.at[0] + at[1] * o.at[1]) + (at[2] * o.at[2] + at[3] * o.at[3]);
  }
  /// Scaled to length 1; zero, and what is no number, as it is.
  Quaternion normalized() const {
    const T n2 = squared_norm();
    if (!(n2 > 0)) return *this;
    const T n = std::sqrt(n2);
    return {at[3] / n, at[0] / n, at[1] / n, at[2] / n};
  }
  bool all_finite() const { return vec().all_finite() && std::isfinite(at[3]); }
  /// Of a unit quaternion.
  constexpr Matrix3<T> matrix() const {
    const T tx = 2 * at[0], ty = 2 * at[1], tz = 2 * at[2];
    const T twx = tx * at[3], twy = ty * at[3], twz = tz * at[3];
    const T txx = tx * at[0], txy = ty * at[0], txz = tz * at[0];
    const T tyy = ty * at[1], tyz = tz * at[1], tzz = tz * at[2];
    return {1 - (tyy + tzz), txy - twz,       txz + twy,  //
            txy + twz,       1 - (txx + tzz), tyz - twx,  //
            txz - twy,       tyz + twx,       1 - (txx + tyy)};
  }
  template <class U>
  constexpr Quaternion<U> cast() const {
    return {U(at[3]), U(at[0]), U(at[1]), U(at[2])};
  }

  friend constexpr Quaternion operator*(const Quaternion& a, const Quaternion& b) {
    return {a.w() * b.w() - a.x() * b.x() - a.y() * b.y() - a.z() * b.z(),
            a.w() * b.x() + a.x() * b.w() + a.y() * b.z() - a.z() * b.y(),
            a.w() * b.y() + a.y() * b.w() + a.z() * b.x() - a.x() * b.z(),
            a.w() * b.z() + a.z() * b.w() + a.x() * b.y() - a.y() * b.x()};
  }
  /// A vector turned by a unit quaternion.
  friend constexpr Vector3<T> operator*(const Quaternion& q, const Vector3<T>& v) {
    const Vector3<T> u = q.vec().cross(v), uu = u + u;
    return v + q.w() * uu + q.vec().cross(uu);
  }
  // As four numbers.
  friend constexpr Quaternion operator+(const Quaternion& a, const Quaternion& b) {
    return {a.at[3] + b.at[3], a.at[0] + b.at[0], a.at[1] + b.at[1], a.at[2] + b.at[2]};
  }
  friend constexpr Quaternion operator-(const Quaternion& a, const Quaternion& b) {
    return {a.at[3] - b.at[3], a.at[0] - b.at[0], a.at[1] - b.at[1], a.at[2] - b.at[2]};
  }
  friend constexpr Quaternion operator*(T s, const Quaternion& a) {
    return {s * a.at[3], s * a.at[0], s * a.at[1], s * a.at[2]};
  }
  constexpr Quaternion& operator+=(const Quaternion& o) { return *this = *this + o; }
  friend constexpr bool operator==(const Quaternion& a, const Quaternion& b) {
    return a.at[0] == b.at[0] && a.at[1] == b.at[1] && a.at[2] == b.at[2] && a.at[3] == b.at[3];
  }
};

using Quat = Quaternion<Real>;

/// The least turn that takes the direction of one vector to that of another; about any axis across where they are
/// opposite. Neither is zero.
/// @accuracy  8 eps; where the two are opposite within d rad, the lesser of 8 eps / d and d
inline Quat turn_between(const Vec3& from, const Vec3& to) {
  const Vec3 a = from.normalized(), b = to.normalized();
  const Vec3 half = a + b;
  if (!(half.squared_norm() > 1e-16)) {
    const Vec3 axis = any_perpendicular(a).normalized();
    return {0, axis.x(), axis.y(), axis.z()};
  }
  const Vec3 middle = half.normalized(), axis = a.cross(middle);
  return Quat(a.dot(middle), axis.x(), axis.y(), axis.z()).normalized();
}

}  // namespace carom::core
