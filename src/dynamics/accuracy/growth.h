// How fast errors grow by themselves: two motions that begin a little apart.
#pragma once

#include "core/constant.h"
#include "dynamics/world.h"

namespace carom::dynamics::accuracy {

inline constexpr Constant<Real> kGrowthApart{
    "growth_apart", 1e-9, "m/s and rad/s", "by which velocities of the second motion differ as it begins",
    "larger: growth ends sooner, at the size of the motion; smaller: rounding is taken for growth"};
inline constexpr Constant<Real> kGrowthMost{
    "growth_most", 1e6, "1", "growth at which the two motions are far enough apart",
    "larger: they no longer grow apart as neighbours do; smaller: growth by the power of a time looks like one by e"};
inline constexpr Constant<Real> kGrowthLeast{"growth_least", 100, "1", "growth below which nothing is called sensitive",
                                             "larger: slow chaos is not reported; smaller: any motion is sensitive"};
inline constexpr Constant<Real> kGrowthShare{
    "growth_share", 0.25, "1",
    "of the time, after which growth has reached its root where errors grow e-fold: half by e, a tenth in proportion "
    "to "
    "time, a fifth to its third power",
    "larger: only chaos that sets in late is reported; smaller: a shear is called chaos"};
inline constexpr ConstantRow kGrowthConstants[] = {kGrowthApart, kGrowthMost, kGrowthLeast, kGrowthShare};

struct Growth {
  std::uint32_t body = kInvalid;  // slot: the two are farthest apart there
  std::uint32_t steps = 0;        // that both took
  Real factor = 1;                // of their distance, since they began
  Real rate = 0;                  // 1/s, of growth by e: ln(factor) over the time
  bool is_sensitive = false;      // errors grow e-fold
};

/// Two worlds that are the same take up to so many steps of dt, one of them with velocities a little off.
/// The distance is the largest over all bodies of that of their places (m), their turns (rad), and of their velocities
/// and spins times 1 s.
Growth measure_growth(World& one, World& other, Real dt, std::uint32_t steps);

}  // namespace carom::dynamics::accuracy
