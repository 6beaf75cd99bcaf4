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

}  // namespace carom::tools::accuracy
