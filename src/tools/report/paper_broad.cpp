// Figure 1: what part of a step is spent on finding pairs.
#include <cmath>

#include "report/paper.h"
#include "report/plot.h"

namespace carom::report {
namespace {

// The paper's figures at N = 1,024 [2011 paper, results]; it prints none for the grid.
struct Strategy {
  const char* label;
  const char* dial;
  double paper_percent;  // 0: not printed
};
constexpr Strategy kStrategies[] = {{"brute force", "broad_phase=brute_force", 97},
                                    {"uniform grid", "broad_phase=grid", 0},
                                    {"sweep and prune", "broad_phase=sweep_and_prune", 16}};

std::vector<BarPart> parts(const Measured& m) {
  const double broad = 100 * m.share(CAROM_STAGE_BROAD), narrow = 100 * m.share(CAROM_STAGE_NARROW),
               response = 100 * (m.share(CAROM_STAGE_SOLVE) + m.share(CAROM_STAGE_RELAX) + m.share(CAROM_STAGE_GROUP));
  return {{"broad phase", broad, 0},
          {"narrow phase", narrow, 1},
          {"response", response, 2},
          {"all else", std::max(0.0, 100 - broad - narrow - response), 4}};
}

// Why our brute force takes another share: what its pair tests cost, and what the rest would have to.
std::string explain_brute_force(const Measured& m, double n) {
  const double broad_ms = m.ms(CAROM_STAGE_BROAD);
  const double rest_ms = m.ms() - broad_ms;
  const double tests = n * (n - 1) / 2, paper = 0.97;
  return "Brute force tests " + number(tests) + " pairs a step here, at " + number(1e6 * broad_ms / tests, 2) +
         " ns each, " + number(broad_ms) + " ms a step, beside " + number(rest_ms) +
         " ms for all the rest: " + number(100 * m.share(CAROM_STAGE_BROAD)) +
         " %. The paper's 97 % would leave only " + number(broad_ms * (1 - paper) / paper, 2) +
         " ms for the rest. Its narrow phase and response cost what they cost then, and so did a pair test on its "
         "computer: a share compares two costs, and both have changed.";
}

}  // namespace

std::size_t broad_phase_runs() { return 2 * std::size(kStrategies); }

Figure broad_phase_shares(PaperRun& run) {
  const double n = 1024, seconds = run.quick ? 1.5 : 15;
  Figure figure;
  figure.heading = "Share of a step spent in the broad phase, N = " + short_number(n);
  figure.file_name = "broad_phase.svg";
  figure.table.title = figure.heading;
  figure.table.header = {"broad phase", "share %", "paper %", "ms a step", "of it broad", "pairs reported", "contacts"};
  BarChart chart;
  chart.title = figure.heading;
  chart.value = {"% of the time of a step", Scale::linear, true, {0, 20, 40, 60, 80, 100}};
  chart.note = "falling --n " + std::to_string(static_cast<int>(n)) + ", " + short_number(seconds) +
               " s simulated; dashed: the paper, 2011, N = 1,024";
  const Crowd crowds[2] = {kHeap, kSpread};
  for (const Crowd& crowd : crowds) {
    double shares[3] = {};
    std::string brute_force;
    for (int i = 0; i < 3; ++i) {
      const Strategy& s = kStrategies[i];
      const std::string label = std::string(crowd.label) + ": " + s.label;
      const auto told = [&](double done) { run.progress("broad phase, " + label, done); };
      told(0);
      const Measured m = measure(run.engine, {"falling", crowd.settings(n), {s.dial}, seconds}, told);
      shares[i] = 100 * m.share(CAROM_STAGE_BROAD);
      const std::string share = number(shares[i]),
                        paper = s.paper_percent > 0 ? short_number(s.paper_percent) : "between";
      const std::string broad_ms = number(m.ms(CAROM_STAGE_BROAD));
      figure.table.rows.push_back(
          {label, share, paper, number(m.ms()), broad_ms, number(m.broad_pairs, 4), number(m.contacts, 4)});
      chart.rows.push_back(
          {label, parts(m), share + " %", s.paper_percent, s.paper_percent > 0 ? "paper " + paper + " %" : ""});
      if (i == 0) brute_force = explain_brute_force(m, n);
    }
    const bool ordered = shares[0] > shares[1] && shares[1] > shares[2];
    figure.remarks.push_back(std::string("Bodies in a crowd, ") + crowd.label + ": " +
                             (ordered ? "the order is the paper's: brute force, then the grid, then sweep-and-prune."
                                      : "the order is NOT the paper's (brute force, grid, sweep-and-prune)."));
    if (&crowd == &crowds[0]) figure.remarks.push_back(brute_force);
  }
  if (run.quick)
    figure.remarks.push_back(
        "This was a quick run of the first 1.5 s: less has touched than in the full one, so finding pairs weighs "
        "more.");
  figure.drawing = draw(chart);
  return figure;
}

}  // namespace carom::report
