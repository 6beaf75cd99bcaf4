#include "dynamics/solver/direct/coupled_patch.h"

#include <algorithm>

namespace carom::dynamics {

CoupledPatch::CoupledPatch(std::span<const Real> z_n, std::span<const Real> resistance, const Vec3& z, Real r, Real mu,
                           PatchBound bound) {
  // What contacts bear together, at a multiplier.
  const auto loads = [&](Real multiplier) {
    Real sum = 0;
    for (std::size_t k = 0; k < z_n.size(); ++k)
      sum += normal[k] = std::max(Real(0), z_n[k] + mu * multiplier / resistance[k]);
    return mu * sum;
  };
  const auto nearest = [&](Real for_most) {
    bound.most = for_most;
    return project_on_bound(z, bound);
  };
  most = loads(0);
  friction = nearest(most);
  is_inside = friction == z;
  if (is_inside || !(mu > 0)) return;
  // The multiplier at a bound is what its distance falls by as it grows. It falls to nothing where the bound holds z, and
  // loads fall with it, so there is one bound between that they allow: found by false position, halved where that creeps.
  const auto multiplier = [&](Real at) { return r * (z - friction).dot(friction) / at; };
  Real low = most, high = gauge_of_bound(z, bound.n, bound.slides);
  const auto lacks = [&](Real at) {
    friction = nearest(at);
    return loads(multiplier(at)) - at;
  };
  constexpr Real kNone = 1e-12;  // of z: of bounds that are as good as none
  constexpr int kTries = 40;
  low = std::max(low, kNone * high);
  Real at_low = lacks(low), at_high = loads(0) - high;
  if (!(at_low > 0)) {
    most = low, friction = low > kNone * high ? friction : Vec3::zero();
    if (friction == Vec3::zero()) most = 0, normal.fill(0);
    return;
  }
  for (int i = 0; i < kTries; ++i) {
    most = low + at_low / (at_low - at_high) * (high - low);
    const Real lack = lacks(most);
    if (std::fabs(lack) <= 4 * kEpsilon * high || high - low <= 4 * kEpsilon * high) break;
    if (lack > 0) {
      low = most, at_low = lack;
      if (i % 2 == 1) at_high /= 2;
    } else {
      high = most, at_high = lack;
      if (i % 2 == 1) at_low /= 2;
    }
  }
}

PatchCoupling::PatchCoupling(const CoupledPatch& at, std::span<const Real> resistance, const Vec3& z, Real r, Real mu,
                             PatchBound bound) {
  bound.most = at.most;
  between = 0;
  for (std::size_t k = 0; k < resistance.size(); ++k)
    if (at.normal[k] > 0) between += 1 / resistance[k];
  const Vec3 on = at.friction / at.most;
  q = on - slope_on_bound(z, bound) * z / at.most;
  const Real multiplier = (z - at.friction).dot(on), bends = std::max(Real(0), (z.dot(q) - multiplier) / at.most);
  const Real both = mu * mu * r * between;
  weight = r * both / (1 + both * bends);
  share = mu / both;
}

}  // namespace carom::dynamics
