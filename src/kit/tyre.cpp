// A tyre as one contact point that lags behind.
#include "kit/tyre.h"

namespace carom::kit {
namespace {

constexpr Real kDampedBelow = 3;  // m/s of rolling: a tyre that hardly rolls swings on its deflection, which this damps
constexpr Real kDampingRatio = 0.5;  // at rest, of the load on the tyre's springs
constexpr Real kSlidesAt =
    0.5;                        // m/s of slip: below it deflection does not go beyond the peak, or a stop would rebound
constexpr Real kWeight = 9.81;  // m/s^2: the mass that a load stands for, for the damping

}  // namespace

TyreForce move_tyre(Tyre& tyre, const carom_wheel_desc& d, const Real slip[2], Real rolling, Real load, Real h) {
  TyreForce out;
  if (!(load > 0)) {
    tyre = Tyre();
    return out;
  }
  const Real peak[2] = {d.relaxation * d.peak_slip, d.relaxation * d.side_peak_slip};
  const Real grip[2] = {d.grip, d.side_grip};
  Real s[2];
  for (int k = 0; k < 2; ++k) {
    tyre.deflection[k] = (tyre.deflection[k] + h * slip[k]) / (1 + h * rolling / d.relaxation);
    s[k] = tyre.deflection[k] / peak[k];
  }
  const Real speed = std::sqrt(slip[0] * slip[0] + slip[1] * slip[1]);
  const Real most = 1 + (d.slide_slip - 1) * smaller(speed / kSlidesAt, Real(1));
  Real x = std::sqrt(s[0] * s[0] + s[1] * s[1]);
  if (x > most) {
    for (int k = 0; k < 2; ++k) tyre.deflection[k] *= most / x, s[k] *= most / x;
    x = most;
  }
  const Real ratio = x > 1e-9 ? friction_at(x, d) / x : 1.5;
  const Real rest = larger(1 - rolling / kDampedBelow, Real(0));
  Real excess = 0;  // square of the share of the grip that the force takes
  for (int k = 0; k < 2; ++k) {
    const Real damping = rest * 2 * kDampingRatio * load * std::sqrt(1.5 * grip[k] / (peak[k] * kWeight));
    out.force[k] = -load * grip[k] * ratio * s[k] - damping * slip[k];
    if (k == 0) out.yields = damping + (x < 1 ? 1.5 * load * grip[0] / peak[0] * h : 0);
    if (grip[k] > 0) excess += out.force[k] * out.force[k] / (grip[k] * grip[k] * load * load);
  }
  const Real share = x > 1 ? friction_at(x, d) : 1;
  if (excess > share * share)
    for (Real& f : out.force) f *= share / std::sqrt(excess);
  return out;
}

}  // namespace carom::kit
