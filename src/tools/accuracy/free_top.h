// The torque-free top in closed form: Jacobi's elliptic functions for its spin, one quadrature for its precession.
// Scenes 3 to 5 are judged by it, and the library's own tests of rotation.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace carom::tools::accuracy {

struct Jacobi {
  double sn, cn, dn;
};

/// @param kc2  1 - k^2, square of the complementary modulus, in (0, 1]: near the separatrix it keeps the digits k lacks
/// @accuracy   a few u, also where sn is near 1, which the recurrence of amplitudes by asin loses half the digits of
/// @source     descending Landen transformations on cn/sn [Bulirsch1965]
inline Jacobi jacobi(double u, double kc2) {
  double mean[16], root[16], a = 1, b = kc2;
  int n = 0;
  for (;; ++n) {
    mean[n] = a;
    root[n] = b = std::sqrt(b);
    const double next = (a + b) / 2;
    const bool done = std::fabs(a - b) <= 1e-9 * a || n == 15;  // quadratic: the next difference is below 1e-18
    b *= a, a = next;
    if (done) break;
  }
  const double s = std::sin(a * u), c = std::cos(a * u);
  if (s == 0) return {0, c, 1};
  double dn = 1, ratio = c / s, scaled = a * ratio;
  for (; n >= 0; --n) {
    ratio *= scaled;
    scaled *= dn;
    dn = (root[n] + ratio) / (mean[n] + ratio);
    ratio = scaled / mean[n];
  }
  const double sn = std::copysign(1 / std::sqrt(scaled * scaled + 1), s);
  return {sn, scaled * sn, dn};
}

/// K, a quarter of the period of sn.
inline double quarter_period(double kc2) {
  double a = 1, b = std::sqrt(kc2);
  for (int i = 0; i < 10; ++i) {
    const double next = (a + b) / 2;
    b = std::sqrt(a * b), a = next;
  }
  return std::numbers::pi / (a + b);
}

/// u with sn u = sn, cn u = cn, in (-2K, 2K].
///   F(phi) = sn R_F(cn^2, dn^2, 1) for cn >= 0; the halving of R_F's spread is repeated until its mean is exact to u
/// @source duplication theorem [Carlson1995]
inline double inverse_sn(double sn, double cn, double kc2) {
  double x = cn * cn, y = cn * cn + kc2 * sn * sn, z = 1;
  while (std::fmax(std::fabs(x - y), std::fabs(z - x)) > 1e-8 * z) {
    const double lambda = std::sqrt(x * y) + std::sqrt(y * z) + std::sqrt(z * x);
    x = (x + lambda) / 4, y = (y + lambda) / 4, z = (z + lambda) / 4;
  }
  const double f = sn / std::sqrt((x + y + z) / 3);
  return cn >= 0 ? f : std::copysign(2 * quarter_period(kc2), sn) - f;
}

/// Simpson's rule on n (even) intervals.
template <class F>
double integral(F&& f, double from, double to, int n) {
  const double h = (to - from) / n;
  double sum = f(from) + f(to);
  for (int i = 1; i < n; ++i) sum += (i % 2 ? 4 : 2) * f(from + i * h);
  return sum * h / 3;
}

/// A body with principal moments along its axes, all three different, left spinning.
///   spin (body axes e, m, o: the one the momentum circles, the middle one, the other)          [Landau1976 §37]
///     w_e = a_e dn, w_m = a_m sn, w_o = a_o cn  of  u = u_0 + r t
///   orientation  q = C R_e(psi) R_1(theta) R_e(phi), C constant, L = C e
///     psi' = |L| (I_1 w_1^2 + I_2 w_2^2) / (I_1^2 w_1^2 + I_2^2 w_2^2),  axes 1, 2, e right-handed
class FreeTop {
 public:
  using Vec3 = Eigen::Vector3d;
  using Quat = Eigen::Quaterniond;

  /// @param inertia  [3] kg m^2   @param omega [3] rad/s, body axes, at t = 0, where body and world axes agree
  FreeTop(const Vec3& inertia, const Vec3& omega) : i_(inertia) {
    const Vec3 l = inertia.cwiseProduct(omega);
    l_ = l.norm();
    const double l2 = l.squaredNorm(), t2 = l.dot(omega);
    int low = 0, high = 0;
    for (int k = 1; k < 3; ++k) {
      if (inertia[k] < inertia[low]) low = k;
      if (inertia[k] > inertia[high]) high = k;
    }
    m_ = 3 - low - high;
    const bool circles_high = l2 > t2 * inertia[m_];
    e_ = circles_high ? high : low;
    o_ = 3 - e_ - m_;
    const double ie = i_[e_], im = i_[m_], io = i_[o_];
    const auto square = [&](int k) { return omega[k] * omega[k]; };
    // 2T I_e - L^2, L^2 - 2T I_o and L^2 - 2T I_m without cancellation; they vanish for spins about e, o and m.
    const double far = im * (ie - im) * square(m_) + io * (ie - io) * square(o_);
    const double near = im * (im - io) * square(m_) + ie * (ie - io) * square(e_);
    const double between = ie * (ie - im) * square(e_) + io * (io - im) * square(o_);
    a_o_ = std::sqrt(far / (io * (ie - io)));
    a_m_ = std::sqrt(far / (im * (ie - im)));
    a_e_ = std::copysign(std::sqrt(near / (ie * (ie - io))), omega[e_]);
    const double right_handed = (m_ - o_ + 3) % 3 == 1 ? 1 : -1;  // o, m, e in cyclic order
    a_m_ *= right_handed * ((ie - io) * a_e_ > 0 ? 1 : -1);
    r_ = std::sqrt((ie - im) * near / (io * im * ie));
    kc2_ = (ie - io) * between / ((ie - im) * near);
    u0_ = inverse_sn(omega[m_] / a_m_, omega[o_] / a_o_, kc2_);
  }

  /// rad/s, body axes
  Vec3 omega(double t) const {
    const Jacobi j = jacobi(u0_ + r_ * t, kc2_);
    Vec3 w;
    w[e_] = a_e_ * j.dn, w[m_] = a_m_ * j.sn, w[o_] = a_o_ * j.cn;
    return w;
  }
  /// body -> world   @accuracy Simpson at 2,000 intervals a second: (r h)^4/180 of the angle, 1e-12 for r = 5 /s
  Quat orientation(double t) const {
    const int first = (e_ + 1) % 3, second = (e_ + 2) % 3;
    const auto rate = [&](double at) {
      const Vec3 w = omega(at), l = i_.cwiseProduct(w);
      return l_ * (l[first] * w[first] + l[second] * w[second]) / (l[first] * l[first] + l[second] * l[second]);
    };
    const double psi = integral(rate, 0, t, 2 * static_cast<int>(std::ceil(1000 * t) + 1));
    return inner(0).conjugate() * turn(e_, psi) * inner(t);
  }
  int middle() const { return m_; }
  double period() const { return 4 * quarter_period(kc2_) / r_; }
  /// s, when the spin about the middle axis passes through zero for the n-th time after u = 0
  double zero(int n) const { return (2 * n * quarter_period(kc2_) - u0_) / r_; }

 private:
  static Quat turn(int axis, double angle) {
    Vec3 v = Vec3::Zero();
    v[axis] = std::sin(angle / 2);
    return Quat(std::cos(angle / 2), v.x(), v.y(), v.z());
  }
  Quat inner(double t) const {
    const int first = (e_ + 1) % 3, second = (e_ + 2) % 3;
    const Vec3 n = i_.cwiseProduct(omega(t)) / l_;  // (sin theta sin phi, sin theta cos phi, cos theta)
    const double theta = std::atan2(std::hypot(n[first], n[second]), n[e_]), phi = std::atan2(n[first], n[second]);
    return turn(first, theta) * turn(e_, phi);
  }

  Vec3 i_;
  int e_, m_, o_;
  double l_, a_e_, a_m_, a_o_, r_, kc2_, u0_;
};

}  // namespace carom::tools::accuracy
