// A tyre as one contact point that lags behind: deflections that grow by slip and are left behind as the wheel rolls. At
// rest they are springs, so that nothing creeps; at a steady speed they are the slip.
//   u' = V - |r w| u / L         V slip velocity, L relaxation length
//   F  = -N m(x) (grip s / x)    s = u / (L peak slip), x = |s|
// @source  single contact point, transient: [Pacejka2012 §7.2]
#pragma once

#include <carom/vehicle.h>

#include "core/vec.h"

namespace carom::kit {

struct Tyre {
  Real deflection[2] = {0, 0};  // m, along and across the wheel
};

/// What a tyre does within a part of a drive. Numbers are along and across the wheel.
struct TyreForce {
  Real force[2] = {0, 0};  // N, on the chassis
  Real yields = 0;         // N s/m: by so much does the force along the wheel fall with the slip velocity there
};

/// Friction over its largest value, by slip over that of the peak: a cubic up to 1, then down to `slide` at `slide_slip`.
inline Real friction_at(Real x, const carom_wheel_desc& d) {
  if (x <= 1) return x * (1.5 - 0.5 * x * x);
  if (x >= d.slide_slip) return d.slide;
  const Real t = (x - 1) / (d.slide_slip - 1);
  return 1 - (1 - d.slide) * t * t * (3 - 2 * t);
}

/// Move on by h.
/// @param slip     [2] m/s, of the contact over the ground: along (less what the wheel rolls) and across
/// @param rolling  m/s, |radius spin|
/// @param load     N
TyreForce move_tyre(Tyre& tyre, const carom_wheel_desc& d, const Real slip[2], Real rolling, Real load, Real h);

}  // namespace carom::kit
