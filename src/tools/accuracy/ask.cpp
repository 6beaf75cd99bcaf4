#include "accuracy/ask.h"

#include <carom/accuracy.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include "host/cpu_time.h"

namespace carom::tools::accuracy {
namespace {

constexpr double kTimedAgain = 0.2;  // s of computing, below which a run is timed three times

bool is_place_or_turn(const Metric& m) { return m.unit == "m" || m.unit == "rad"; }

std::size_t metric_of(const Challenge& challenge) {
  for (std::size_t i = 0; i < challenge.metrics.size(); ++i)
    if (is_place_or_turn(challenge.metrics[i]) && challenge.metrics[i].what.find("gap") == std::string::npos) return i;
  return challenge.metrics.size();
}

struct Timed {
  double error, ms;
};

/// @return nothing where it took too long
std::optional<Timed> timed(Engine& engine, const Challenge& challenge, std::vector<std::string> dials,
                           double patience) {
  Request request;
  request.dials = std::move(dials);
  request.patience = patience;
  Result r = run(engine, challenge, request, std::nullopt);
  if (r.given_up) return std::nullopt;
  for (int again = 0; again < 2 && r.ms_per_second * r.simulated < 1e3 * kTimedAgain; ++again)
    r.ms_per_second = std::min(r.ms_per_second, run(engine, challenge, request, std::nullopt).ms_per_second);
  return Timed{r.fell_at >= 0 ? HUGE_VAL : r.errors[metric_of(challenge)], r.ms_per_second};
}

std::string dial(const char* name, double value) {
  char text[64];
  std::snprintf(text, sizeof text, "%s=%.17g", name, value);
  return text;
}

}  // namespace

std::vector<const Challenge*> scenes_to_ask() {
  std::vector<const Challenge*> all;
  for (const Challenge& challenge : all_challenges())
    if (metric_of(challenge) < challenge.metrics.size() && challenge.reference_dt == 0) all.push_back(&challenge);
  return all;
}

std::vector<Got> ask(Engine& engine, const Challenge& challenge, const std::vector<double>& tolerances,
                     double patience) {
  struct Fixed {
    std::string name;
    Timed result;
  };
  std::vector<Fixed> fixed;
  for (const char* order : {"0", "2", "4", "6"}) {
    for (const int substeps : {1, 2, 4, 8, 16, 32, 64}) {
      const std::string name = "substeps=" + std::to_string(substeps);
      const auto result = timed(engine, challenge, {name, std::string("joint_order=") + order}, patience);
      if (!result) break;
      // Without joints the order changes nothing.
      if (*order != '0' && !fixed.empty() && result->error == fixed.front().result.error) break;
      fixed.push_back({name + (*order == '0' ? "" : std::string(" joint_order=") + order), *result});
    }
  }
  const Metric& metric = challenge.metrics[metric_of(challenge)];
  std::vector<Got> all;
  for (const double tolerance : tolerances) {
    const auto result =
        timed(engine, challenge, {dial("accuracy_place", tolerance), dial("accuracy_turn", tolerance)}, patience);
    if (!result) continue;
    Got g;
    g.scene = challenge.scene.name, g.what = metric.what, g.unit = metric.unit;
    g.tolerance = tolerance, g.asked = tolerance * challenge.scene.seconds;
    g.got = result->error, g.ms = result->ms;
    for (const Fixed& f : fixed)
      if (f.result.error <= g.got && (g.fixed_ms == 0 || f.result.ms < g.fixed_ms))
        g.fixed_ms = f.result.ms, g.fixed = f.name;
    all.push_back(g);
  }
  return all;
}

namespace {

constexpr double kMixedStep = 1.0 / 60;

struct Room {
  Stage stage;
  carom_body pile = CAROM_NULL_HANDLE, linkage = CAROM_NULL_HANDLE, top = CAROM_NULL_HANDLE;
  explicit Room(Engine& engine) : stage(engine) {}
};

Actor rod(const std::string& name, const Vec& middle, double angle, double length) {
  Actor a;
  a.name = name, a.kind = "rod";
  a.position = middle;
  a.orientation = Quat(Eigen::AngleAxisd(angle, Vec::UnitZ()));
  a.mass = 1;
  a.center = Vec::Zero();
  a.inertia = Vec(1e-3, length * length / 12, length * length / 12).asDiagonal();
  return a;
}

/// Four rods of half a metre, the first hung, let go from the level: they whirl.
void add_linkage(Room& room) {
  std::size_t before = 0;
  for (int i = 0; i < 4; ++i) {
    const std::size_t now = room.stage.add(rod("rod " + std::to_string(i + 1), Vec(20.25 + 0.5 * i, 8, 0), 0, 0.5));
    if (i == 0) {
      Actor hook;
      hook.name = "hook", hook.kind = "hook", hook.type = CAROM_BODY_STATIC, hook.position = Vec(20, 8, 0);
      before = room.stage.add(hook);
    }
    room.stage.join(CAROM_JOINT_HINGE, before, now, Vec(20 + 0.5 * i, 8, 0),
                    Quat(Eigen::AngleAxisd(-M_PI / 2, Vec::UnitY())));
    before = now;
    room.linkage = room.stage.actors[now].body;
  }
}

void add_pile_and_top(Room& room) {
  room.stage.add_half_space("ground", Vec::UnitY(), Vec::Zero());
  for (int row = 0; row < 4; ++row)
    for (int i = 0; i < 4 - row; ++i) {
      Actor box;
      box.name = "box " + std::to_string(4 * row + i), box.kind = "box";
      box.position = Vec(1.05 * i + 0.525 * row, 0.5 + row, 0);
      box.parts.push_back({.shape = "box", .params = {0.5, 0.5, 0.5}});
      room.pile = room.stage.actors[room.stage.add(box)].body;
    }
  Actor top;
  top.name = "top", top.kind = "top";
  top.position = Vec(-20, 400, 0), top.linear_velocity = Vec(0, 60, 0), top.angular_velocity = Vec(0.1, 12, 0.1);
  top.mass = 1, top.center = Vec::Zero();
  top.inertia = Vec(1, 2, 3).asDiagonal();
  room.top = room.stage.actors[room.stage.add(top)].body;
}

/// ms of computing per simulated second, the least of three.
template <class Watch>
double cost(Engine& engine, bool all, const std::vector<std::string>& dials, double seconds, Watch&& watch) {
  double least = HUGE_VAL;
  for (int again = 0; again < 3; ++again) {
    Room room(engine);
    if (all) add_pile_and_top(room);
    add_linkage(room);
    for (const std::string& d : dials) room.stage.world.set_dial(d);
    const int settle = static_cast<int>(0.5 / kMixedStep), steps = static_cast<int>(seconds / kMixedStep);
    for (int k = 0; k < settle; ++k) room.stage.world.step(kMixedStep);
    double spent = 0;
    for (int k = 0; k < steps; ++k) {
      const double begun = cpu_time();
      room.stage.world.step(kMixedStep);
      spent += cpu_time() - begun;
      if (again == 0) watch(room);
    }
    least = std::min(least, 1e3 * spent / (steps * kMixedStep));
  }
  return least;
}

}  // namespace

Mixed ask_mixed(Engine& engine, double tolerance, double seconds) {
  Mixed m;
  m.tolerance = tolerance;
  const std::vector<std::string> asked = {dial("accuracy_place", tolerance), dial("accuracy_turn", tolerance)};
  const auto nothing = [](const Room&) {};
  m.linkage_ms = cost(engine, false, asked, seconds, nothing);
  double steps = 0;
  m.all_ms = cost(engine, true, asked, seconds, [&](const Room& room) {
    for (const carom_island& island : room.stage.world.islands()) {
      const bool is_linkage = island.flags & CAROM_ISLAND_JOINTS_ALONE, is_top = island.body == room.top;
      (is_linkage ? m.linkage_substeps : is_top ? m.top_substeps : m.pile_substeps) += island.substeps;
    }
    ++steps;
  });
  for (double* mean : {&m.linkage_substeps, &m.pile_substeps, &m.top_substeps}) *mean /= steps;
  const auto fixed = std::clamp(static_cast<int>(std::lround(m.linkage_substeps)), 1, 64);
  m.all_fixed_ms = cost(engine, true, {"substeps=" + std::to_string(fixed), "joint_order=4"}, seconds, nothing);
  return m;
}

}  // namespace carom::tools::accuracy
