// What an effect costs: the same scene with its participants, and with the effect forbidden; the difference is the
// effect's.
//
// ns a participant, ns an evaluation, ms a scene, and what one participant costs among all the others; then 20,000
// particles beside a loop written by hand. Exit codes: 0; 1 an effect has no scene, or did not serve whom it should.
#include <time.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>

#include "dynamics/plan_view.h"
#include "effects/crowds.h"

namespace carom::bench {
namespace {

using test::TestWorld;

constexpr Real kStep = 1.0 / 60;  // s

struct Options {
  std::string csv;
  std::vector<std::string> only;
  int repeats = 9, steps = 20;
  bool quick = false;
};

/// s, of this thread.
double cpu_time() {
  timespec t;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return n == 0 ? 0 : (values[(n - 1) / 2] + values[n / 2]) / 2;
}

double timed_step(const Crowd& crowd, TestWorld& t, std::uint32_t calling) {
  if (crowd.before_step) crowd.before_step(t, calling);
  const double start = cpu_time();
  t.world.step(kStep);
  return cpu_time() - start;
}

struct Cost {
  double effect = 0;       // s a step: median of repeats
  double spread = 0;       // s, half of what lies between the quartiles of repeats
  double step = 0;         // s, of all
  double evaluations = 0;  // a step
  std::uint64_t participants = 0;
  std::string unit;
  bool as_told = true;  // it served somebody, and forbidden nobody
};

/// Both worlds take turns, step by step, and are made anew for each repeat: neither the machine's mood nor where memory
/// happens to lie is taken for the effect's.
Cost cost_of(const Crowd& crowd, std::uint32_t bodies, std::uint32_t calling, const Options& options) {
  std::vector<double> differences, steps;
  Cost cost;
  for (int repeat = 0; repeat < options.repeats; ++repeat) {
    TestWorld with, without;
    for (TestWorld* t : {&with, &without}) {
      crowd.build(*t, bodies, calling);
      for (int i = 0; i < 3; ++i) timed_step(crowd, *t, calling);
    }
    without.world.set_mode(crowd.row, EffectMode::forbid);
    const auto& row = with.world.plan->effects[crowd.row];
    const auto& idle = without.world.plan->effects[crowd.row];
    timed_step(crowd, with, calling), timed_step(crowd, without, calling);  // it makes a plan
    const std::uint64_t before = row.evaluations, idle_before = idle.evaluations;
    std::vector<double> difference;
    for (int i = 0; i < options.steps; ++i) {
      const bool first = (i + repeat) % 2 == 0;
      const double a = timed_step(crowd, first ? with : without, calling);
      const double b = timed_step(crowd, first ? without : with, calling);
      difference.push_back(first ? a - b : b - a);
      steps.push_back(first ? a : b);
    }
    differences.push_back(median(difference));
    cost.evaluations = static_cast<double>(row.evaluations - before) / options.steps;
    cost.as_told &= row.evaluations > before && idle.evaluations == idle_before;
    const PlanLine line = plan_line(with.world, kStageCount + crowd.row);
    cost.participants = line.participants;
    cost.unit = line.unit;
  }
  cost.effect = median(differences);
  cost.step = median(steps);
  std::sort(differences.begin(), differences.end());
  const std::size_t n = differences.size();
  cost.spread = (differences[3 * n / 4 < n ? 3 * n / 4 : n - 1] - differences[n / 4]) / 2;
  return cost;
}

/// A step of particles as anybody would write it, by the method that a world has by default (velocity Verlet).
void fly_by_hand(double* x, double* v, std::size_t n, double pull, double h) {
  const double kick = h / 2 * pull;
  for (std::size_t i = 0; i < n; ++i) {
    v[i] += kick;
    x[i] += h * v[i];
    v[i] += kick;
  }
}

/// @param n  particles   @return whether both end in the same bits
bool compare_particles(std::size_t n, int steps) {
  TestWorld t;
  const std::uint32_t set = handle_slot(t.world.particles.create({}, n));
  t.world.particles.extend(set, n);
  for (std::size_t i = 0; i < n; ++i) t.world.particles.set_velocity(set, i, Vec3(1, 2, 1e-3 * static_cast<double>(i)));
  std::vector<double> x[3], v[3];
  for (int k = 0; k < 3; ++k) {
    x[k].assign(n, 0);
    const auto& from = t.world.particles.set[set].v[static_cast<std::size_t>(k)];
    v[k].assign(from.begin(), from.end());
  }
  std::vector<double> engine, by_hand;
  for (int i = 0; i < steps; ++i) {
    double start = cpu_time();
    t.world.step(kStep);
    engine.push_back(cpu_time() - start);
    start = cpu_time();
    for (int k = 0; k < 3; ++k) fly_by_hand(x[k].data(), v[k].data(), n, k == 1 ? -9.81 : 0, kStep);
    by_hand.push_back(cpu_time() - start);
  }
  bool same = true;  // and it is the same work
  for (std::size_t i = 0; i < n; ++i)
    for (int k = 0; k < 3; ++k) same &= x[k][i] == t.world.particles.set[set].x[static_cast<std::size_t>(k)][i];
  std::printf(
      "\n%zu particles: a step of the engine %.4f ms, a plain loop %.4f ms: %.2f times; least %.4f and %.4f: %.2f; "
      "%s\n",
      n, 1e3 * median(engine), 1e3 * median(by_hand), median(engine) / median(by_hand),
      1e3 * *std::min_element(engine.begin(), engine.end()), 1e3 * *std::min_element(by_hand.begin(), by_hand.end()),
      *std::min_element(engine.begin(), engine.end()) / *std::min_element(by_hand.begin(), by_hand.end()),
      same ? "same bits" : "other bits");
  return same;
}

int run(const Options& options) {
  std::ofstream csv;
  if (!options.csv.empty()) csv.open(options.csv);
  csv << "effect,participants,unit,evaluations_a_step,ns_a_participant,ns_an_evaluation,ms_a_scene,spread_ms,ms_a_step,"
         "ns_alone,spread_alone_ns\n";
  std::printf("%-25s %9s %-15s %11s %13s %16s %10s %8s %9s  %s\n", "effect", "participants", "", "evaluations",
              "ns/participant", "ns/evaluation", "ms/scene", "+-", "ms/step", "one among 10,000, ns");
  bool good = true;
  std::vector<bool> covered(kEffectCount);
  for (const Crowd& crowd : crowds()) {
    covered[crowd.row] = true;
    const bool asked =
        options.only.empty() || std::any_of(options.only.begin(), options.only.end(),
                                            [&](const auto& o) { return crowd.name.find(o) != std::string::npos; });
    if (!asked) continue;
    const std::uint32_t bodies = options.quick ? 30 : crowd.bodies;
    const Cost all = cost_of(crowd, bodies, bodies, options);
    Cost one;
    if (crowd.can_be_alone) one = cost_of(crowd, options.quick ? 30 : 10000, 1, options);
    if (!all.as_told || !one.as_told || (crowd.can_be_alone && one.participants != 1)) {
      std::fprintf(stderr, "%s: it did not serve whom it should, or was not to be forbidden\n", crowd.name.c_str());
      good = false;
    }
    const double per = 1e9 * all.effect / static_cast<double>(std::max<std::uint64_t>(1, all.participants));
    const double each = 1e9 * all.effect / std::max(1.0, all.evaluations);
    std::printf("%-25s %9llu %-15s %11.0f %13.2f %16.2f %10.4f %8.4f %9.3f", crowd.name.c_str(),
                static_cast<unsigned long long>(all.participants), all.unit.c_str(), all.evaluations, per, each,
                1e3 * all.effect, 1e3 * all.spread, 1e3 * all.step);
    if (crowd.can_be_alone)
      std::printf("  %.0f +- %.0f\n", 1e9 * one.effect, 1e9 * one.spread);
    else
      std::printf("\n");
    std::fflush(stdout);
    csv << '"' << crowd.name << "\"," << all.participants << ',' << all.unit << ',' << all.evaluations << ',' << per
        << ',' << each << ',' << 1e3 * all.effect << ',' << 1e3 * all.spread << ',' << 1e3 * all.step << ',';
    if (crowd.can_be_alone) csv << 1e9 * one.effect << ',' << 1e9 * one.spread;
    csv << '\n';
  }
  for (std::size_t row = 0; row < kEffectCount; ++row)
    if (!covered[row]) {
      std::fprintf(stderr, "no scene for %s: add one to crowds.cpp\n", effect_table()[row].name);
      good = false;
    }
  if (options.only.empty()) good &= compare_particles(options.quick ? 500 : 20000, options.quick ? 3 : 2000);
  if (!options.csv.empty() && !csv.flush()) {
    std::fprintf(stderr, "cannot write %s\n", options.csv.c_str());
    return 1;
  }
  return good ? 0 : 1;
}

}  // namespace
}  // namespace carom::bench

int main(int argc, char** argv) {
  CLI::App app{
      "What each effect of a step costs: a scene with its participants, less the same scene with it forbidden"};
  carom::bench::Options options;
  app.add_option("ONLY", options.only, "Effects whose name contains one of these; default: all");
  app.add_option("--csv", options.csv, "Write the table there, too")->type_name("FILE");
  app.add_option("--repeats", options.repeats, "Of each scene")->check(CLI::Range(1, 1000))->capture_default_str();
  app.add_option("--steps", options.steps, "Timed in each repeat")->check(CLI::Range(1, 100000))->capture_default_str();
  app.add_flag("--quick", options.quick, "30 bodies, to see that it works");
  CLI11_PARSE(app, argc, argv);
  if (options.quick) options.repeats = 1, options.steps = 2;
  return carom::bench::run(options);
}
