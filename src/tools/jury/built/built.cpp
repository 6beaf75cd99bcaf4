// A seed of what is built: its family, its step, and all else that the family draws.
#include "jury/built/built.h"

#include <algorithm>
#include <iterator>

#include "jury/built/builder.h"

namespace carom::tools::jury {
namespace {

struct Family {
  const char* name;
  void (*draw)(Builder& b);
};

constexpr Family kFamilies[] = {
    {"vehicle", draw_vehicle}, {"track", draw_track},     {"bridge", draw_bridge},     {"net", draw_net},
    {"doll", draw_doll},       {"walker", draw_walker},   {"gripper", draw_gripper},   {"door", draw_door},
    {"cards", draw_cards},     {"stack", draw_stack},     {"overlap", draw_overlap},   {"cradle", draw_cradle},
    {"crane", draw_crane},     {"linkage", draw_linkage}, {"conveyor", draw_conveyor}, {"meddler", draw_meddler}};

const Family& of(std::uint64_t seed) { return kFamilies[seed % std::size(kFamilies)]; }

}  // namespace

const char* family_of(std::uint64_t seed) { return of(seed).name; }

std::vector<std::string> all_families() {
  std::vector<std::string> names;
  for (const Family& family : kFamilies) names.emplace_back(family.name);
  return names;
}

Case draw_built(std::uint64_t seed, Stage& stage) {
  Builder b(seed, stage);
  b.scene.seed = seed, b.scene.family = of(seed).name;
  static constexpr double kSteps[] = {1.0 / 60, 1.0 / 60, 1.0 / 60, 1.0 / 50, 1.0 / 90, 1.0 / 120, 1.0 / 30};
  b.scene.dt = kSteps[b.count(0, 6)];
  of(seed).draw(b);
  std::stable_sort(b.scene.deeds.begin(), b.scene.deeds.end(),
                   [](const Deed& one, const Deed& other) { return one.time < other.time; });
  int hertz = 1;
  while (hertz * b.scene.dt < 0.999) ++hertz;
  b.scene.summary += ", " + std::to_string(hertz) + " Hz";
  return std::move(b.scene);
}

}  // namespace carom::tools::jury
