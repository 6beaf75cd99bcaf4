// Six numbers of a body: its velocity and its angular velocity, or an impulse and a moment.
#pragma once

#include "core/vec.h"

namespace carom::core {

struct Vec6 {
  Real at[6];

  Vec6() = default;  // not initialised, as a number is not
  constexpr Vec6(const Vec3& linear, const Vec3& angular)
      : at{linear[0], linear[1], linear[2], angular[0], angular[1], angular[2]} {}
  static constexpr Vec6 zero() { return {Vec3::zero(), Vec3::zero()}; }

  constexpr Vec3 linear() const { return Vec3::from(at); }
  constexpr Vec3 angular() const { return Vec3::from(at + 3); }
  constexpr void set_linear(const Vec3& v) { at[0] = v[0], at[1] = v[1], at[2] = v[2]; }
  constexpr void set_angular(const Vec3& v) { at[3] = v[0], at[4] = v[1], at[5] = v[2]; }
  constexpr void set_zero() { *this = zero(); }
  template <class I>
  constexpr Real operator[](I i) const {
    return at[i];
  }
  template <class I>
  constexpr Real& operator[](I i) {
    return at[i];
  }

  constexpr Real dot(const Vec6& o) const { return linear().dot(o.linear()) + angular().dot(o.angular()); }
  constexpr Real squared_norm() const { return dot(*this); }
  Real norm() const { return std::sqrt(squared_norm()); }
  bool all_finite() const { return linear().all_finite() && angular().all_finite(); }

  constexpr Vec6& operator+=(const Vec6& o) { return *this = *this + o; }
  constexpr Vec6& operator-=(const Vec6& o) { return *this = *this - o; }
  friend constexpr Vec6 operator+(const Vec6& a, const Vec6& b) {
    return {a.linear() + b.linear(), a.angular() + b.angular()};
  }
  friend constexpr Vec6 operator-(const Vec6& a, const Vec6& b) {
    return {a.linear() - b.linear(), a.angular() - b.angular()};
  }
  friend constexpr Vec6 operator-(const Vec6& a) { return {-a.linear(), -a.angular()}; }
  friend constexpr Vec6 operator*(Real s, const Vec6& a) { return {s * a.linear(), s * a.angular()}; }
  friend constexpr bool operator==(const Vec6& a, const Vec6& b) {
    return a.linear() == b.linear() && a.angular() == b.angular();
  }
};

}  // namespace carom::core
