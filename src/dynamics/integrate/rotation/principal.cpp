// Principal axes by Jacobi rotations, sorted.
#include "dynamics/integrate/rotation/principal.h"

#include <utility>

namespace carom::dynamics {
namespace {

/// Turn the matrix about one axis such that element (p, q) vanishes; the axes are turned along.
void annihilate(Mat3& a, Mat3& axes, int p, int q) {
  if (a(p, q) == 0) return;
  const Real tau = (a(q, q) - a(p, p)) / (2 * a(p, q));
  const Real t = std::copysign(Real(1), tau) / (std::fabs(tau) + std::sqrt(1 + tau * tau));
  const Real c = 1 / std::sqrt(1 + t * t), s = t * c;
  const int r = 3 - p - q;
  const Real apr = a(p, r), aqr = a(q, r), apq = a(p, q);
  a(p, p) -= t * apq, a(q, q) += t * apq;
  a(p, q) = a(q, p) = 0;
  a(p, r) = a(r, p) = c * apr - s * aqr;
  a(q, r) = a(r, q) = s * apr + c * aqr;
  const Vec3 vp = axes.col(p), vq = axes.col(q);
  axes.set_col(p, c * vp - s * vq);
  axes.set_col(q, s * vp + c * vq);
}

}  // namespace

Principal principal_axes(const Mat3& inertia) {
  Mat3 a = inertia, axes = Mat3::identity();
  const Real small = kUnitRoundoff * inertia.trace();
  const auto residue = [&] { return std::fabs(a(0, 1)) + std::fabs(a(0, 2)) + std::fabs(a(1, 2)); };
  Principal top;
  for (int sweep = 0; sweep < 12 && residue() > small; ++sweep) {  // converges quadratically: four are plenty
    annihilate(a, axes, 0, 1), annihilate(a, axes, 0, 2), annihilate(a, axes, 1, 2);
    top.aligned = false;
  }

  const Vec3 moment = a.diagonal(), inverse = moment.reciprocal();
  std::uint8_t* k = top.axis;
  const auto swap_if = [&](bool wrong, int i, int j) {
    if (wrong) std::swap(k[i], k[j]), top.sign = -top.sign;
  };
  const auto greater = [&](int i, int j) { return moment[k[i]] > moment[k[j]]; };
  swap_if(greater(0, 1), 0, 1);
  swap_if(greater(1, 2), 1, 2);
  swap_if(greater(0, 1), 0, 1);  // ascending
  swap_if(true, 0, 1);           // the middle one first
  const auto apart = [&](int i) { return std::fabs(inverse[k[i]] - inverse[k[0]]); };
  swap_if(apart(1) > apart(2), 1, 2);

  top.moment = Vec3(moment[k[0]], moment[k[1]], moment[k[2]]);
  top.base = inverse[k[0]];
  top.dy = inverse[k[1]] - inverse[k[0]];
  top.dz = inverse[k[2]] - inverse[k[0]];
  if (!top.aligned) {
    Mat3 frame;
    for (int i = 0; i < 3; ++i) frame.set_col(i, (i == 0 ? top.sign : 1) * axes.col(k[i]));  // right-handed
    top.frame = normalized(Quat(frame));
    for (std::uint8_t i = 0; i < 3; ++i) k[i] = i;
    top.sign = 1;
  }
  return top;
}

}  // namespace carom::dynamics
