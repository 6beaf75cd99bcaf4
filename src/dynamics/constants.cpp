// The table of constants, joined when it is compiled.
#include "dynamics/constants.h"

#include <array>

#include "collision/manifold/patch_constants.h"
#include "dynamics/accuracy/control.h"
#include "dynamics/accuracy/growth.h"
#include "dynamics/contact/asked_again.h"
#include "dynamics/contact/depth.h"
#include "dynamics/contact/impact_points.h"
#include "dynamics/contact/lone_rollers.h"
#include "dynamics/contact/rolling.h"
#include "dynamics/contact/slide.h"
#include "dynamics/contact/turning_ground.h"
#include "dynamics/give_back.h"
#include "dynamics/joint/energy_bound.h"
#include "dynamics/joint/rattle/rattle.h"
#include "dynamics/solver/auto_constants.h"
#include "dynamics/solver/direct/cone_group_constants.h"
#include "dynamics/solver/direct/yielding_constants.h"
#include "dynamics/solver/far_turns.h"
#include "dynamics/solver/float_range.h"
#include "dynamics/solver/sweep_constants.h"

namespace carom::dynamics {
namespace {

template <std::size_t... n>
constexpr auto in_one_table(const ConstantRow (&... parts)[n]) {
  std::array<ConstantRow, (n + ...)> all;
  std::size_t i = 0;
  const auto add = [&](const auto& part) {
    for (const ConstantRow& row : part) all[i++] = row;
  };
  (add(parts), ...);
  return all;
}

constexpr auto kConstantTable =
    in_one_table(kPatchConstants, kImpactConstants, kRollingConstants, kTouchingMotionConstants, kLoneRollerConstants,
                 kPatchFrictionConstants, kTurningGroundConstants, kSweepConstants, kFarTurnConstants, kDepthConstants,
                 kAskedAgainConstants, kAutoConstants, kConeGroupConstants, kYieldingConstants, kEnergyBoundConstants,
                 kRattleConstants, kAccuracyConstants, accuracy::kGrowthConstants, kFloatConstants, kGiveBackConstants);

}  // namespace

std::span<const ConstantRow> constant_table() { return kConstantTable; }

}  // namespace carom::dynamics
