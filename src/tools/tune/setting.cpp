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

std::string Setting::text() const {
  std::string text = whole(steps_per_frame) + (steps_per_frame == 1 ? " step" : " steps");
  for (const auto& [dial, value] : dials) text += ", " + dial + "=" + value;
  return dials.empty() ? text + ", all dials at their defaults" : text;
}

std::vector<Setting> first_candidates(const Participants& who, bool few) {
  std::vector<Setting> all = {{1, {}}};
  const auto add = [&](Setting setting) {
    if (std::find(all.begin(), all.end(), setting) == all.end()) all.push_back(std::move(setting));
  };
  for (const char* preset : {"fast", "accurate", "reference"})
    for (const int steps : {1, 2, 4})
      if (!few || (steps == 1 && preset != std::string("reference"))) add({steps, {{"preset", preset}}});
  const auto grid = [&](const char* solver, std::initializer_list<int> steps, std::initializer_list<int> substeps) {
    for (const int n : steps)
      for (const int m : substeps) {
        const bool own = (!*solver || solver == std::string("auto")) && n == 1 && m == 4;  // the first of all
        if (n * m > kMostSubsteps || own) continue;
        Setting setting{n, {}};
        if (*solver) set(setting, "solver", solver);
        set(setting, "substeps", whole(m));
        add(std::move(setting));
      }
  };
  if (!who.contacts && !who.joints) {  // nothing to solve
    grid("", {1, 2, 4, 8}, {1, 2, 4, 8, 16});
    return all;
  }
  for (const char* asked : {"0.01", "0.001", "0.0001"})  // m and rad per second of motion
    if (!few || asked != std::string("0.0001")) add({1, {{"accuracy_place", asked}, {"accuracy_turn", asked}}});
  if (few) {
    grid("auto", {1}, {1, 2, 8});
    grid("auto", {2}, {1, 4});
    grid("soft_step", {1}, {2, 4, 8});
    grid("direct", {1}, {1, 4});
    return all;
  }
  for (const char* solver : {"auto", "direct"}) grid(solver, {1, 2, 4, 8}, {1, 2, 4, 8, 16});
  grid("soft_step", {1, 2}, {2, 4, 8, 16});
  if (who.contacts) grid("severity", {1, 2, 4}, {1, 4});  // it knows no joints
  return all;
}

std::vector<Setting> neighbours(const Setting& setting, const Participants& who) {
  std::vector<Setting> near;
  const auto with = [&](const std::string& dial, const std::string& value) {
    if (get(setting, dial) == value) return;
    Setting s = setting;
    set(s, dial, value);
    near.push_back(std::move(s));
  };
  const std::string solver = get(setting, "solver");
  const bool preset = !get(setting, "preset").empty();
  if (who.forces && !who.joints) with("integrator", "rk4");
  if (who.turns) with("rotation", preset ? "splitting_6" : "splitting_4");
  if (who.bounces) with("restitution_speed", "0.01");
  if (who.joints)
    for (const carom_dial_info& dial : all_dials())
      if (dial.name == std::string("joint_order"))
        for (const char* order : {"4", "6"}) with(dial.name, order);
  if (!who.contacts) return near;
  with("hold_angle", "0");
  with("precision", "float");
  if (solver == "severity") {
    for (const char* most : {"4", "30"}) with("velocity_iterations", most);
    return near;
  }
  if (!preset && solver != "direct")
    for (const char* frequency : {"20", "60"}) with("contact_frequency", frequency);
  if (!preset && solver != "soft_step") with("velocity_tolerance", "1e-6");
  if (solver.empty() || solver == "auto") with("direct_sink", "0.0001");
  return near;
}

Setting reference_setting(const Participants& who, bool rough) {
  Setting s{rough ? 2 : 4,
            {{"solver", "auto"},
             {"substeps", rough ? "8" : "16"},
             {"direct_sink", "0.0001"},
             {"restitution_speed", "0.01"},
             {"rotation", "splitting_6"}}};
  // Forces that change along the way are of second order by Verlet's method: candidates would be finer than it.
  if (who.forces && !who.joints && !who.contacts) set(s, "integrator", "rk4");
  return s;
}

Setting half_reference_setting(const Participants& who, bool rough) {
  Setting s = reference_setting(who, rough);
  s.steps_per_frame /= 2;
  return s;
}

}  // namespace carom::tools::tune
