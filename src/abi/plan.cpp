// The plan as a host reads it, and what it forbids and forces.
#include <carom/plan.h>

#include "abi/copy_out.h"
#include "abi/record_calls.h"
#include "abi/world.h"
#include "dynamics/plan_view.h"

namespace carom::abi {
namespace {

static_assert(kEffectCount == CAROM_EFFECT_COUNT);  // each at its number: tests/abi/test_attributes
static_assert(static_cast<std::uint32_t>(EffectMode::forbid) == CAROM_MODE_FORBID &&
              static_cast<std::uint32_t>(EffectMode::force) == CAROM_MODE_FORCE &&
              static_cast<std::uint32_t>(Timing::in_stage) == CAROM_TIME_IN_STAGE &&
              static_cast<std::uint32_t>(Timing::off) == CAROM_TIME_OFF && PlanLine::kStage == CAROM_PLAN_NO_EFFECT);

constexpr std::uint32_t kModes = 3;

bool known_effect(Call& call, int argument, std::uint32_t effect) {
  return known(call, argument, "effect", effect, CAROM_EFFECT_COUNT);
}

bool is_of_bodies(Call& call, std::uint32_t effect) {
  return (effect != CAROM_EFFECT_PARTICLES && effect != CAROM_EFFECT_EVENTS && effect != CAROM_EFFECT_LEDGER) ||
         call.fail(CAROM_E_UNSUPPORTED, 3, "effect %s is not a body's; use carom_world_set_effect()",
                   carom_effect_name(effect));
}

template <std::size_t n>
void copy_text(const char* from, char (&to)[n]) {
  for (std::size_t i = 0; i + 1 < n && from[i]; ++i) to[i] = from[i];  // the rest is zero
}

carom_plan_line describe(const PlanLine& line) {
  carom_plan_line out{};
  out.effect = line.effect;
  out.stage = static_cast<std::uint32_t>(line.stage);
  out.mode = static_cast<std::uint32_t>(line.mode);
  out.runs = line.runs;
  out.participants = line.participants, out.wanted = line.wanted, out.evaluations = line.evaluations;
  out.bytes = line.bytes;
  out.seconds = line.seconds;
  out.timing = static_cast<std::uint32_t>(line.timing);
  copy_text(line.name, out.name), copy_text(line.unit, out.unit), copy_text(line.reason, out.reason);
  return out;
}

}  // namespace
}  // namespace carom::abi

using namespace carom;
using namespace carom::abi;

extern "C" {

const char* carom_effect_name(uint32_t effect) {
  return effect < CAROM_EFFECT_COUNT ? effect_table()[effect].name : "?";
}

int32_t carom_world_set_effect(carom_world* world, uint32_t effect, uint32_t mode, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::world_set_effect(effect, mode));
    if (changing && known_effect(call, 2, effect) && known(call, 3, "mode", mode, kModes))
      changing->set_mode(effect, static_cast<EffectMode>(mode));
  });
}

int32_t carom_world_get_effect(carom_world* world, uint32_t effect, uint32_t* mode, carom_error* error) {
  return glanced(error, [&](Call& call) {
    const Reading reading(call, world);
    if (reading && known_effect(call, 2, effect) && present(call, 3, "mode", mode))
      *mode = static_cast<std::uint32_t>(reading->scene.modes.of_world(effect));
  });
}

int32_t carom_body_set_effect(carom_world* world, carom_body body, uint32_t effect, uint32_t mode, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::body_set_effect(body, effect, mode));
    if (changing && resolve_body(call, *changing, body) && known_effect(call, 3, effect) &&
        is_of_bodies(call, effect) && known(call, 4, "mode", mode, kModes))
      changing->set_body_mode(handle_slot(body), effect, static_cast<EffectMode>(mode));
  });
}

int32_t carom_body_get_effect(carom_world* world, carom_body body, uint32_t effect, uint32_t* mode,
                              carom_error* error) {
  return glanced(error, [&](Call& call) {
    const Reading reading(call, world);
    if (reading && resolve_body(call, *reading, body) && known_effect(call, 3, effect) &&
        present(call, 4, "mode", mode))
      *mode = static_cast<std::uint32_t>(reading->scene.modes.of_body(effect, handle_slot(body)));
  });
}

int32_t carom_world_time_effects(carom_world* world, uint32_t on, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::world_time_effects(on));
    if (!changing) return;
    if (on > 1)
      call.fail(CAROM_E_OUT_OF_RANGE, 2, "on is %u, must be 1 or 0", on);
    else
      changing->times_effects = on != 0;
  });
}

int32_t carom_world_get_plan(carom_world* world, carom_plan_line* dst, uint64_t stride, uint64_t capacity,
                             uint64_t* count, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Reading reading(call, world);
    if (!reading) return;
    copy_elements<carom_plan_line>(
        call, kPlanLines, [&](std::uint64_t i) { return describe(plan_line(*reading, i)); }, dst, stride, capacity,
        count);
  });
}

}  // extern "C"
