// The space of settings: which are tried, and what is near one of them.
#include <algorithm>

#include "tune/tune.h"

namespace carom::tools::tune {
namespace {

constexpr int kMostSubsteps = 16;  // a frame: beyond, a candidate is as dear as a reference

std::string whole(int n) { return std::to_string(n); }

void set(Setting& s, const std::string& dial, const std::string& value) {
  const auto at = std::find_if(s.dials.begin(), s.dials.end(), [&](const auto& d) { return d.first == dial; });
  if (at == s.dials.end())
    s.dials.emplace_back(dial, value);
  else
    at->second = value;
}

std::string get(const Setting& s, const std::string& dial) {
  const auto at = std::find_if(s.dials.begin(), s.dials.end(), [&](const auto& d) { return d.first == dial; });
  return at == s.dials.end() ? "" : at->second;
}

}  // namespace

const char* name_of(ErrorKind kind) {
  static constexpr const char* kNames[] = {"truth", "pose", "drift", "energy", "gap"};
  return kNames[static_cast<int>(kind)];
}

const char* unit_of(ErrorKind kind) {
  static constexpr const char* kUnits[] = {"", "m", "m", "J", "m"};
  return kUnits[static_cast<int>(kind)];
}

std::string Setting::text() const {
  std::string text = whole(steps_per_frame) + (steps_per_frame == 1 ? " step" : " steps");
  for (const auto& [dial, value] : dials) text += ", " + dial + "=" + value;
  return dials.empty() ? text + ", all dials at their defaults" : text;
}

std::vector<Setting> first_candidates() {
  std::vector<Setting> all = {{1, {}}};
  for (const char* solver : {"severity", "sequential", "soft_step", "auto", "direct"})
    for (const int steps : {1, 2, 4, 8})
      for (const int substeps : {1, 2, 4, 8, 16}) {
        const bool own = solver == std::string("auto") && steps == 1 && substeps == 4;  // the first of all
        if (steps * substeps > kMostSubsteps || own) continue;
        all.push_back({steps, {{"solver", solver}, {"substeps", whole(substeps)}}});
      }
  return all;
}

std::vector<Setting> neighbours(const Setting& setting) {
  std::vector<Setting> near;
  const auto with = [&](const std::string& dial, const std::string& value) {
    if (get(setting, dial) == value) return;
    Setting s = setting;
    set(s, dial, value);
    near.push_back(std::move(s));
  };
  const std::string solver = get(setting, "solver");
  for (const char* integrator : {"semi_implicit_euler", "rk4"}) with("integrator", integrator);
  with("restitution_speed", "0.01");
  with("rotation", "splitting_4");
  if (solver == "sequential" || solver == "severity")
    for (const char* sweeps : {"4", "30"}) with("velocity_iterations", sweeps);
  if (solver != "sequential" && solver != "severity")
    for (const char* frequency : {"20", "60"}) with("contact_frequency", frequency);
  if (solver.empty() || solver == "auto") with("direct_sink", "0.0001");
  return near;
}

Setting reference_setting() {
  return {4,
          {{"solver", "auto"},
           {"substeps", "16"},
           {"direct_sink", "0.0001"},
           {"restitution_speed", "0.01"},
           {"rotation", "splitting_6"}}};
}

Setting half_reference_setting() {
  Setting s = reference_setting();
  s.steps_per_frame = 2;
  return s;
}

}  // namespace carom::tools::tune
