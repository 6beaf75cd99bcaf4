// Effects of a world by their names: forbid, force, look at the plan.
#include "host/host.h"

namespace carom::tools {
namespace {

std::uint32_t effect_called(const std::string& name) {
  std::vector<std::string> names;
  std::string list;
  for (std::uint32_t effect = 0; effect < CAROM_EFFECT_COUNT; ++effect) {
    names.emplace_back(carom_effect_name(effect));
    if (names.back() == name) return effect;
    list += (effect ? ", " : "") + names.back();
  }
  const std::string near = nearest_name(name, names);
  throw Error("there is no effect called '" + name + "'",
              (near.empty() ? std::string() : "did you mean '" + near + "'? ") + "the effects are: " + list);
}

}  // namespace

void World::set_effect(const std::string& name, std::uint32_t mode) {
  Call call;
  call.done(carom_world_set_effect(world_, effect_called(name), mode, call), "effect " + name);
}

void World::time_effects(bool on) {
  Call call;
  call.done(carom_world_time_effects(world_, on ? 1 : 0, call), "timing effects");
}

std::vector<carom_plan_line> World::plan() const {
  std::uint64_t count = 0;
  Call call;
  call.done(carom_world_get_plan(world_, nullptr, sizeof(carom_plan_line), 0, &count, call), "counting effects");
  std::vector<carom_plan_line> lines(count);
  call.done(carom_world_get_plan(world_, lines.data(), sizeof(carom_plan_line), count, &count, call),
            "reading the plan");
  return lines;
}

}  // namespace carom::tools
