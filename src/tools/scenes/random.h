// Our own random numbers: the standard library's distributions differ between implementations, a scene must not.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>

namespace carom::tools {

/// SplitMix64: 64 bits of state, one multiply-xorshift chain per number [Steele2014].
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t bits() {
    state_ += 0x9E3779B97F4A7C15u;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  }
  /// Uniform in [0, 1), 53 bits.
  double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
  double between(double low, double high) { return low + (high - low) * unit(); }
  /// Each component in its own range, the last drawn first. C++ leaves the order in which a call evaluates its arguments
  /// to the compiler, so no two numbers of a scene may be drawn in one argument list.
  template <class Vector>
  Vector within(const Vector& low, const Vector& high) {
    Vector drawn;
    for (Eigen::Index i = drawn.size(); i-- > 0;) drawn[i] = between(low[i], high[i]);
    return drawn;
  }
  /// Uniform on the unit sphere, by rejection: no trigonometry, so the same bits on any libm.
  Eigen::Vector3d direction() {
    for (;;) {
      const Eigen::Vector3d one = Eigen::Vector3d::Ones(), p = within<Eigen::Vector3d>(-one, one);
      const double s = p.squaredNorm();
      if (s <= 1 && s > 1e-6) return p / std::sqrt(s);
    }
  }
  /// Uniform rotation, by rejection from the 4-ball.
  Eigen::Quaterniond rotation() {
    for (;;) {
      const Eigen::Vector4d one = Eigen::Vector4d::Ones(), p = within<Eigen::Vector4d>(-one, one);
      const double s = p.squaredNorm();
      if (s <= 1 && s > 1e-6) return Eigen::Quaterniond(Eigen::Vector4d(p / std::sqrt(s)));
    }
  }

 private:
  std::uint64_t state_;
};

}  // namespace carom::tools
