// The loop of a measured run.
#include "report/measure.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace carom::report {
namespace {

constexpr double kLongEnough = 0.5;  // s of computing: shorter runs are at the mercy of whatever else runs
constexpr int kRepeats = 3;

Measured measure_once(tools::Engine& engine, const RunSpec& spec, const Progress& progress) {
  const tools::Scene& scene = tools::find_scene(spec.scene);
  tools::Stage stage(engine);
  tools::build(scene, spec.settings, stage);
  for (const std::string& dial : spec.dials) stage.world.set_dial(dial);
  const double duration = spec.seconds > 0 ? spec.seconds : scene.seconds;
  using Clock = std::chrono::steady_clock;
  Clock::time_point told = Clock::now();
  Measured m;
  m.run = tools::simulate(stage, nullptr, duration, scene.dt, [&](const carom_step_report& r) {
    m.contacts += static_cast<double>(r.contact_points);
    m.largest_group += static_cast<double>(r.largest_group);
    m.broad_pairs += static_cast<double>(r.broad_pairs);
    if (Clock::now() - told >= std::chrono::milliseconds(250)) {
      told = Clock::now();
      progress(std::min(1.0, r.time / duration));
    }
    return true;
  });
  const auto steps = static_cast<double>(m.run.steps);
  m.contacts /= steps;
  m.largest_group /= steps;
  m.broad_pairs /= steps;
  return m;
}

}  // namespace

Measured measure(tools::Engine& engine, const RunSpec& spec, const Progress& progress) {
  Measured best = measure_once(engine, spec, progress);
  for (int i = 1; i < kRepeats && best.run.total_seconds < kLongEnough; ++i) {
    Measured again = measure_once(engine, spec, progress);
    if (again.run.total_seconds < best.run.total_seconds) best = std::move(again);
  }
  return best;
}

}  // namespace carom::report
