// Real numbers, vectors, matrices: the only place that chooses them.
//
// Plain structs: a file that only adds vectors compiles in a tenth of the time that a matrix library takes. Eigen stays
// where matrices are factored. Sums of three terms are x0 + (x1 + x2) everywhere: that order is part of a
// trajectory's bits, and so no expression here may be written otherwise without new golden hashes.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

#include "core/layers.h"

namespace carom::core {

using Real = double;

inline constexpr Real kInfinity = std::numeric_limits<Real>::infinity();
inline constexpr Real kEpsilon = std::numeric_limits<Real>::epsilon();  // 2^-52: spacing of numbers at 1
inline constexpr Real kUnitRoundoff = kEpsilon / 2;                     // u: |fl(x op y) - (x op y)| <= u |x op y|

inline bool finite(Real x) { return std::isfinite(x); }

/// The larger and the smaller of two numbers; the first where they are equal or one is no number.
template <class T>
constexpr T larger(T a, T b) {
  return a < b ? b : a;
}
template <class T>
constexpr T smaller(T a, T b) {
  return b < a ? b : a;
}

/// Two numbers: a vector in a plane.
template <class T>
struct Vector2 {
  T at[2];

  Vector2() = default;  // not initialised, as a number is not
  constexpr Vector2(T x, T y) : at{x, y} {}
  static constexpr Vector2 zero() { return {0, 0}; }

  constexpr T x() const { return at[0]; }
  constexpr T y() const { return at[1]; }
  constexpr T dot(const Vector2& o) const { return at[0] * o.at[0] + at[1] * o.at[1]; }
  constexpr T squared_norm() const { return dot(*this); }
  T norm() const { return std::sqrt(squared_norm()); }

  friend constexpr bool operator==(const Vector2& a, const Vector2& b) {
    return a.at[0] == b.at[0] && a.at[1] == b.at[1];
  }
  friend constexpr Vector2 operator+(const Vector2& a, const Vector2& b) {
    return {a.at[0] + b.at[0], a.at[1] + b.at[1]};
  }
  friend constexpr Vector2 operator-(const Vector2& a, const Vector2& b) {
    return {a.at[0] - b.at[0], a.at[1] - b.at[1]};
  }
  friend constexpr Vector2 operator-(const Vector2& a) { return {-a.at[0], -a.at[1]}; }
  friend constexpr Vector2 operator*(T s, const Vector2& a) { return {s * a.at[0], s * a.at[1]}; }
  friend constexpr Vector2 operator/(const Vector2& a, T s) { return {a.at[0] / s, a.at[1] / s}; }
};

/// Three numbers: a point, a direction, a velocity. Components by name, x(), or by number, v[0] and v(0).
template <class T>
struct Vector3 {
  T at[3];

  Vector3() = default;  // not initialised, as a number is not
  constexpr Vector3(T x, T y, T z) : at{x, y, z} {}
  static constexpr Vector3 zero() { return {0, 0, 0}; }
  static constexpr Vector3 constant(T c) { return {c, c, c}; }
  static constexpr Vector3 unit_x() { return {1, 0, 0}; }
  static constexpr Vector3 unit_y() { return {0, 1, 0}; }
  static constexpr Vector3 unit_z() { return {0, 0, 1}; }
  static constexpr Vector3 unit(int axis) { return {T(axis == 0), T(axis == 1), T(axis == 2)}; }
  /// Of three numbers in a row.
  static constexpr Vector3 from(const T* p) { return {p[0], p[1], p[2]}; }

  constexpr T x() const { return at[0]; }
  constexpr T y() const { return at[1]; }
  constexpr T z() const { return at[2]; }
  constexpr T& x() { return at[0]; }
  constexpr T& y() { return at[1]; }
  constexpr T& z() { return at[2]; }
  template <class I>
  constexpr T operator[](I i) const {
    return at[i];
  }
  template <class I>
  constexpr T& operator[](I i) {
    return at[i];
  }
  template <class I>
  constexpr T operator()(I i) const {
    return at[i];
  }
  template <class I>
  constexpr T& operator()(I i) {
    return at[i];
  }
  constexpr const T* data() const { return at; }
  constexpr T* data() { return at; }
  constexpr Vector2<T> xy() const { return {at[0], at[1]}; }
  void set_zero() { *this = zero(); }

  constexpr T sum() const { return at[0] + (at[1] + at[2]); }
  constexpr T product() const { return at[0] * (at[1] * at[2]); }
  constexpr T dot(const Vector3& o) const { return times(o).sum(); }
  constexpr Vector3 cross(const Vector3& o) const {
    return {at[1] * o.at[2] - at[2] * o.at[1], at[2] * o.at[0] - at[0] * o.at[2], at[0] * o.at[1] - at[1] * o.at[0]};
  }
  constexpr T squared_norm() const { return dot(*this); }
  T norm() const { return std::sqrt(squared_norm()); }
  /// Scaled to length 1; zero, and what is no number, as it is.
  Vector3 normalized() const {
    const T n2 = squared_norm();
    return n2 > 0 ? *this / std::sqrt(n2) : *this;
  }
  void normalize() { *this = normalized(); }

  // Component by component.
  Vector3 abs() const { return {std::fabs(at[0]), std::fabs(at[1]), std::fabs(at[2])}; }
  constexpr Vector3 times(const Vector3& o) const { return {at[0] * o.at[0], at[1] * o.at[1], at[2] * o.at[2]}; }
  constexpr Vector3 over(const Vector3& o) const { return {at[0] / o.at[0], at[1] / o.at[1], at[2] / o.at[2]}; }
  constexpr Vector3 reciprocal() const { return {1 / at[0], 1 / at[1], 1 / at[2]}; }
  constexpr Vector3 min(const Vector3& o) const {
    return {smaller(at[0], o.at[0]), smaller(at[1], o.at[1]), smaller(at[2], o.at[2])};
  }
  constexpr Vector3 max(const Vector3& o) const {
    return {larger(at[0], o.at[0]), larger(at[1], o.at[1]), larger(at[2], o.at[2])};
  }
  constexpr T max_entry() const { return larger(at[0], larger(at[1], at[2])); }
  constexpr T min_entry() const { return smaller(at[0], smaller(at[1], at[2])); }
  /// The first of the largest components.
  constexpr int max_axis() const {
    const int first = at[1] > at[0];
    return at[2] > at[first] ? 2 : first;
  }
  constexpr int min_axis() const {
    const int first = at[1] < at[0];
    return at[2] < at[first] ? 2 : first;
  }
  constexpr bool is_zero() const { return at[0] == 0 && at[1] == 0 && at[2] == 0; }
  bool all_finite() const { return std::isfinite(at[0]) && std::isfinite(at[1]) && std::isfinite(at[2]); }
  /// Whether each component is below o's, or at most o's; never where one is no number.
  constexpr bool all_below(const Vector3& o) const { return at[0] < o.at[0] && at[1] < o.at[1] && at[2] < o.at[2]; }
  constexpr bool all_within(const Vector3& o) const { return at[0] <= o.at[0] && at[1] <= o.at[1] && at[2] <= o.at[2]; }
  template <class U>
  constexpr Vector3<U> cast() const {
    return {U(at[0]), U(at[1]), U(at[2])};
  }

  constexpr Vector3& operator+=(const Vector3& o) { return *this = *this + o; }
  constexpr Vector3& operator-=(const Vector3& o) { return *this = *this - o; }
  constexpr Vector3& operator*=(T s) { return *this = *this * s; }
  constexpr Vector3& operator/=(T s) { return *this = *this / s; }
  friend constexpr Vector3 operator+(const Vector3& a, const Vector3& b) {
    return {a.at[0] + b.at[0], a.at[1] + b.at[1], a.at[2] + b.at[2]};
  }
  friend constexpr Vector3 operator-(const Vector3& a, const Vector3& b) {
    return {a.at[0] - b.at[0], a.at[1] - b.at[1], a.at[2] - b.at[2]};
  }
  friend constexpr Vector3 operator-(const Vector3& a) { return {-a.at[0], -a.at[1], -a.at[2]}; }
  friend constexpr Vector3 operator*(T s, const Vector3& a) { return {s * a.at[0], s * a.at[1], s * a.at[2]}; }
  friend constexpr Vector3 operator*(const Vector3& a, T s) { return {a.at[0] * s, a.at[1] * s, a.at[2] * s}; }
  friend constexpr Vector3 operator/(const Vector3& a, T s) { return {a.at[0] / s, a.at[1] / s, a.at[2] / s}; }
  friend constexpr bool operator==(const Vector3& a, const Vector3& b) {
    return a.at[0] == b.at[0] && a.at[1] == b.at[1] && a.at[2] == b.at[2];
  }
};

/// A matrix of three rows and columns; entries by m(row, column), in memory column after column.
template <class T>
struct Matrix3 {
  T at[9];
  using Vector = Vector3<T>;

  Matrix3() = default;  // not initialised, as a number is not
  /// Row by row, as it is written.
  constexpr Matrix3(T a, T b, T c, T d, T e, T f, T g, T h, T i) : at{a, d, g, b, e, h, c, f, i} {}
  static constexpr Matrix3 zero() { return {0, 0, 0, 0, 0, 0, 0, 0, 0}; }
  static constexpr Matrix3 identity() { return {1, 0, 0, 0, 1, 0, 0, 0, 1}; }
  static constexpr Matrix3 columns(const Vector& a, const Vector& b, const Vector& c) {
    return {a[0], b[0], c[0], a[1], b[1], c[1], a[2], b[2], c[2]};
  }
  static constexpr Matrix3 diagonal(const Vector& d) { return {d[0], 0, 0, 0, d[1], 0, 0, 0, d[2]}; }
  /// Of nine numbers in a row, row by row.
  static constexpr Matrix3 from_rows(const T* p) { return {p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7], p[8]}; }

  template <class I, class J>
  constexpr T operator()(I row, J column) const {
    return at[3 * column + row];
  }
  template <class I, class J>
  constexpr T& operator()(I row, J column) {
    return at[3 * column + row];
  }
  constexpr const T* data() const { return at; }
  constexpr T* data() { return at; }
  template <class J>
  constexpr Vector col(J j) const {
    return Vector::from(at + 3 * j);
  }
  template <class J>
  constexpr void set_col(J j, const Vector& v) {
    at[3 * j] = v[0], at[3 * j + 1] = v[1], at[3 * j + 2] = v[2];
  }
  template <class I>
  constexpr Vector row(I i) const {
    return {at[i], at[3 + i], at[6 + i]};
  }
  constexpr Vector diagonal() const { return {at[0], at[4], at[8]}; }
  constexpr void add_to_diagonal(const Vector& d) { at[0] += d[0], at[4] += d[1], at[8] += d[2]; }
  void set_zero() { *this = zero(); }
  void set_identity() { *this = identity(); }

  constexpr Matrix3 transpose() const { return {at[0], at[1], at[2], at[3], at[4], at[5], at[6], at[7], at[8]}; }
  constexpr T trace() const { return diagonal().sum(); }
  constexpr T sum() const {
    return ((at[0] + at[1]) + (at[2] + at[3])) + ((at[4] + at[5]) + (at[6] + (at[7] + at[8])));
  }
  /// Of all entries (Frobenius).
  constexpr T squared_norm() const {
    Matrix3 squares;
    for (int k = 0; k < 9; ++k) squares.at[k] = at[k] * at[k];
    return squares.sum();
  }
  T norm() const { return std::sqrt(squared_norm()); }
  Matrix3 abs() const {
    Matrix3 out;
    for (int k = 0; k < 9; ++k) out.at[k] = std::fabs(at[k]);
    return out;
  }
  constexpr T max_entry() const {
    T most = at[0];
    for (int k = 1; k < 9; ++k) most = larger(most, at[k]);
    return most;
  }
  bool all_finite() const { return col(0).all_finite() && col(1).all_finite() && col(2).all_finite(); }
  constexpr T determinant() const { return minor(0, 1, 2) - minor(1, 0, 2) + minor(2, 0, 1); }
  /// By cofactors: for a matrix that is known to be far from singular. Not finite where it is singular.
  constexpr Matrix3 inverse() const {
    const Vector first(cofactor<0, 0>(), cofactor<1, 0>(), cofactor<2, 0>());
    const T s = 1 / first.dot(col(0));
    return {first[0] * s,         first[1] * s,         first[2] * s,
            cofactor<0, 1>() * s, cofactor<1, 1>() * s, cofactor<2, 1>() * s,
            cofactor<0, 2>() * s, cofactor<1, 2>() * s, cofactor<2, 2>() * s};
  }
  template <class U>
  constexpr Matrix3<U> cast() const {
    return Matrix3<U>::columns(col(0).template cast<U>(), col(1).template cast<U>(), col(2).template cast<U>());
  }

  constexpr Matrix3& operator+=(const Matrix3& o) { return *this = *this + o; }
  constexpr Matrix3& operator-=(const Matrix3& o) { return *this = *this - o; }
  constexpr Matrix3& operator*=(T s) { return *this = s * *this; }
  friend constexpr Matrix3 operator+(const Matrix3& a, const Matrix3& b) {
    return columns(a.col(0) + b.col(0), a.col(1) + b.col(1), a.col(2) + b.col(2));
  }
  friend constexpr Matrix3 operator-(const Matrix3& a, const Matrix3& b) {
    return columns(a.col(0) - b.col(0), a.col(1) - b.col(1), a.col(2) - b.col(2));
  }
  friend constexpr Matrix3 operator-(const Matrix3& a) { return columns(-a.col(0), -a.col(1), -a.col(2)); }
  friend constexpr Matrix3 operator*(T s, const Matrix3& a) {
    return columns(s * a.col(0), s * a.col(1), s * a.col(2));
  }
  friend constexpr Matrix3 operator*(const Matrix3& a, T s) { return s * a; }
  friend constexpr Matrix3 operator/(const Matrix3& a, T s) {
    return columns(a.col(0) / s, a.col(1) / s, a.col(2) / s);
  }
  friend constexpr Vector operator*(const Matrix3& a, const Vector& v) {
    return {a.at[0] * v.at[0] + (a.at[3] * v.at[1] + a.at[6] * v.at[2]),
            a.at[1] * v.at[0] + (a.at[4] * v.at[1] + a.at[7] * v.at[2]),
            a.at[2] * v.at[0] + (a.at[5] * v.at[1] + a.at[8] * v.at[2])};
  }
  friend constexpr Matrix3 operator*(const Matrix3& a, const Matrix3& b) {
    return columns(a * b.col(0), a * b.col(1), a * b.col(2));
  }
  friend constexpr bool operator==(const Matrix3& a, const Matrix3& b) {
    return a.col(0) == b.col(0) && a.col(1) == b.col(1) && a.col(2) == b.col(2);
  }

 private:
  constexpr T minor(int a, int b, int c) const {
    const Matrix3& m = *this;
    return m(0, a) * (m(1, b) * m(2, c) - m(1, c) * m(2, b));
  }
  template <int I, int J>
  constexpr T cofactor() const {
    constexpr int i1 = (I + 1) % 3, i2 = (I + 2) % 3, j1 = (J + 1) % 3, j2 = (J + 2) % 3;
    return at[3 * j1 + i1] * at[3 * j2 + i2] - at[3 * j2 + i1] * at[3 * j1 + i2];
  }
};

using Vec2 = Vector2<Real>;
using Vec3 = Vector3<Real>;
using Mat3 = Matrix3<Real>;

inline bool finite(const Vec3& v) { return v.all_finite(); }

/// The matrix a b^T.
template <class T>
constexpr Matrix3<T> outer(const Vector3<T>& a, const Vector3<T>& b) {
  return Matrix3<T>::columns(a * b[0], a * b[1], a * b[2]);
}
/// diag(d) m: rows scaled.
template <class T>
constexpr Matrix3<T> scale_rows(const Vector3<T>& d, const Matrix3<T>& m) {
  return Matrix3<T>::columns(d.times(m.col(0)), d.times(m.col(1)), d.times(m.col(2)));
}
/// m diag(d): columns scaled.
template <class T>
constexpr Matrix3<T> scale_columns(const Matrix3<T>& m, const Vector3<T>& d) {
  return Matrix3<T>::columns(m.col(0) * d[0], m.col(1) * d[1], m.col(2) * d[2]);
}

/// Any unit vector at right angles to a unit vector. Deterministic, continuous except at n.z = -0.
/// @source [Duff2017]
inline Vec3 any_perpendicular(const Vec3& n) {
  const Real sign = std::copysign(Real(1), n.z());
  const Real a = Real(-1) / (sign + n.z());
  return Vec3(Real(1) + sign * n.x() * n.x() * a, sign * n.x() * n.y() * a, -sign * n.x());
}

/// The matrix K with K x = v cross x.
inline Mat3 cross_matrix(const Vec3& v) { return {0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0}; }

}  // namespace carom::core
