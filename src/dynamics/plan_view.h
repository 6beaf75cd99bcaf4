// The plan of the last step as a host reads it: what ran, for which participants, why, and what was left out.
#pragma once

#include "dynamics/effects.h"

namespace carom::dynamics {

/// Whose time an effect's is; as CAROM_TIME_*.
enum class Timing : std::uint32_t { own, in_stage, off };

/// A stage or an effect.
struct PlanLine {
  static constexpr std::uint32_t kStage = 0xFFFFFFFFu;
  std::uint32_t effect = kStage;  // row of the table
  Stage stage = Stage::refresh;
  EffectMode mode = EffectMode::as_needed;
  bool runs = false;
  std::uint64_t participants = 0, wanted = 0, evaluations = 0, bytes = 0;
  double seconds = 0;
  Timing timing = Timing::own;
  const char* name = "";
  const char* unit = "";
  char reason[128] = "";
};

/// Stages first, then effects.
inline constexpr std::size_t kPlanLines = kStageCount + kEffectCount;
PlanLine plan_line(const World& world, std::size_t index);

}  // namespace carom::dynamics
