// A pile at rest, a fast linkage and a flying top in one world: what each takes where an accuracy is asked for.
#include <carom/accuracy.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "accuracy/ask.h"
#include "host/cpu_time.h"
#include "report/plot.h"

namespace carom::tools::accuracy {
namespace {

constexpr double kMixedStep = 1.0 / 60;  // s

std::string dial(const char* name, double value) {
  char text[64];
  std::snprintf(text, sizeof text, "%s=%.17g", name, value);
  return text;
}

/// Of a substep.
double stages_of(const carom_island& island) {
  if (!(island.flags & CAROM_ISLAND_JOINTS_ALONE)) return 1;
  return island.order == 6 ? 9 : island.order == 4 ? 5 : 1;
}

struct MixedScene {
  Stage stage;
  carom_body pile = CAROM_NULL_HANDLE, linkage = CAROM_NULL_HANDLE, top = CAROM_NULL_HANDLE;
  explicit MixedScene(Engine& engine) : stage(engine) {}
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
void add_linkage(MixedScene& scene) {
  std::size_t before = 0;
  for (int i = 0; i < 4; ++i) {
    const std::size_t now = scene.stage.add(rod("rod " + std::to_string(i + 1), Vec(20.25 + 0.5 * i, 8, 0), 0, 0.5));
    if (i == 0) {
      Actor hook;
      hook.name = "hook", hook.kind = "hook", hook.type = CAROM_BODY_STATIC, hook.position = Vec(20, 8, 0);
      before = scene.stage.add(hook);
    }
    scene.stage.join(CAROM_JOINT_HINGE, before, now, Vec(20 + 0.5 * i, 8, 0),
                     Quat(Eigen::AngleAxisd(-M_PI / 2, Vec::UnitY())));
    before = now;
    scene.linkage = scene.stage.actors[now].body;
  }
}

void add_pile_and_top(MixedScene& scene) {
  scene.stage.add_half_space("ground", Vec::UnitY(), Vec::Zero());
  for (int row = 0; row < 4; ++row)
    for (int i = 0; i < 4 - row; ++i) {
      Actor box;
      box.name = "box " + std::to_string(4 * row + i), box.kind = "box";
      box.position = Vec(1.05 * i + 0.525 * row, 0.5 + row, 0);
      box.parts.push_back({.shape = "box", .params = {0.5, 0.5, 0.5}});
      scene.pile = scene.stage.actors[scene.stage.add(box)].body;
    }
  Actor top;
  top.name = "top", top.kind = "top";
  top.position = Vec(-20, 400, 0), top.linear_velocity = Vec(0, 60, 0), top.angular_velocity = Vec(0.1, 12, 0.1);
  top.mass = 1, top.center = Vec::Zero();
  top.inertia = Vec(1, 2, 3).asDiagonal();
  scene.top = scene.stage.actors[scene.stage.add(top)].body;
}

/// ms of computing per simulated second, the least of three.
template <class Watch>
double cost(Engine& engine, bool all, const std::vector<std::string>& dials, double seconds, Watch&& watch) {
  double least = HUGE_VAL;
  for (int again = 0; again < 3; ++again) {
    MixedScene scene(engine);
    if (all) add_pile_and_top(scene);
    add_linkage(scene);
    for (const std::string& d : dials) scene.stage.world.set_dial(d);
    const int settle = static_cast<int>(0.5 / kMixedStep), steps = static_cast<int>(seconds / kMixedStep);
    for (int k = 0; k < settle; ++k) scene.stage.world.step(kMixedStep);
    double spent = 0;
    for (int k = 0; k < steps; ++k) {
      const double begun = cpu_time();
      scene.stage.world.step(kMixedStep);
      spent += cpu_time() - begun;
      if (again == 0) watch(scene);
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
  const auto nothing = [](const MixedScene&) {};
  m.linkage_ms = cost(engine, false, asked, seconds, nothing);
  m.all_ms = cost(engine, true, asked, seconds, [&](const MixedScene& scene) {
    Mixed::Step taken;
    taken.time = kMixedStep * static_cast<double>(m.steps.size());
    for (const carom_island& island : scene.stage.world.islands()) {
      const bool is_linkage = island.flags & CAROM_ISLAND_JOINTS_ALONE, is_top = island.body == scene.top;
      (is_linkage ? m.linkage_substeps : is_top ? m.top_substeps : m.pile_substeps) += island.substeps;
      (is_linkage ? taken.linkage
       : is_top   ? taken.top
                  : taken.pile) += static_cast<double>(island.work) * stages_of(island);
    }
    m.steps.push_back(taken);
  });
  for (double* mean : {&m.linkage_substeps, &m.pile_substeps, &m.top_substeps})
    *mean /= static_cast<double>(m.steps.size());
  const auto fixed = std::clamp(static_cast<int>(std::lround(m.linkage_substeps)), 1, 64);
  m.all_fixed_ms = cost(engine, true, {"substeps=" + std::to_string(fixed), "joint_order=4"}, seconds, nothing);
  return m;
}

std::string draw_mixed(const Mixed& mixed) {
  report::LinePlot plot;
  char text[256];
  std::snprintf(text, sizeof text, "Asked for %.0e: each island takes the work that its error asks for",
                mixed.tolerance);
  plot.title = text;
  plot.x.label = "s";
  plot.y.label = "stages a step of 1/60 s";
  plot.y.scale = report::Scale::log;
  plot.dense = true;
  const auto add = [&](const char* name, int colour, double Mixed::Step::*of) {
    report::Series series;
    series.name = name, series.colour = colour;
    for (const Mixed::Step& step : mixed.steps) series.points.push_back({step.time, step.*of});
    plot.series.push_back(std::move(series));
  };
  add("linkage", 0, &Mixed::Step::linkage);
  add("top", 1, &Mixed::Step::top);
  add("pile", 2, &Mixed::Step::pile);
  std::snprintf(
      text, sizeof text,
      "Rods alone cost %.2g ms a second, with a resting pile and a flying top %.2f times that. m and rad per second.",
      mixed.linkage_ms, mixed.all_ms / mixed.linkage_ms);
  plot.note = text;
  return report::draw(plot);
}

}  // namespace carom::tools::accuracy
