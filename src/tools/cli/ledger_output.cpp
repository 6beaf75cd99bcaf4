// The ledger as a table and as a plot.
#include "cli/ledger_output.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "cli/table.h"
#include "report/plot.h"

namespace carom::tools {
namespace {

constexpr std::size_t kLines = 5;         // beside the state: as many colours as there are
constexpr std::size_t kMostPoints = 400;  // of a line: the plot has 600 px
constexpr double kSmall = 0.005;          // of the largest: lies on the axis

double size_of(const double v[3]) { return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }

bool gave_something(const carom_ledger_entry& e) {
  return e.total_kinetic != 0 || e.total_potential != 0 || size_of(e.total_linear) > 0 || size_of(e.total_angular) > 0;
}

std::vector<std::string> row_of(const char* name, double kinetic, double potential, const double linear[3],
                                const double angular[3]) {
  std::vector<std::string> row = {name, format("%.6g", kinetic), format("%.6g", potential),
                                  format("%.6g", kinetic + potential)};
  for (const double* v : {linear, angular})
    for (int i = 0; i < 3; ++i) row.push_back(format("%.4g", v[i]));
  return row;
}

double peak(const std::vector<double>& values) {
  double most = 0;
  for (const double value : values) most = std::max(most, std::fabs(value));
  return most;
}

}  // namespace

void print_ledger(const World& world) {
  const std::vector<carom_ledger_entry> entries = world.ledger();
  const carom_ledger_state s = world.ledger_state();
  std::vector<std::vector<std::string>> rows = {
      {"cause", "kinetic J", "potential J", "energy J", "linear x", "y", "z N s", "angular x", "y", "z N m s"}};
  double energy = 0, linear[3] = {}, angular[3] = {}, off_linear[3], off_angular[3];
  for (const carom_ledger_entry& e : entries) {
    energy += e.total_kinetic + e.total_potential;
    for (int i = 0; i < 3; ++i) linear[i] += e.total_linear[i], angular[i] += e.total_angular[i];
    if (gave_something(e))
      rows.push_back(row_of(e.name, e.total_kinetic, e.total_potential, e.total_linear, e.total_angular));
  }
  double change_linear[3], change_angular[3];
  for (int i = 0; i < 3; ++i) {
    change_linear[i] = s.now_linear[i] - s.start_linear[i], change_angular[i] = s.now_angular[i] - s.start_angular[i];
    off_linear[i] = linear[i] - change_linear[i], off_angular[i] = angular[i] - change_angular[i];
  }
  const double kinetic = s.now_kinetic - s.start_kinetic, potential = s.now_potential - s.start_potential;
  rows.push_back(row_of("change of state", kinetic, potential, change_linear, change_angular));
  std::printf("\nthe ledger, over %llu steps:\n%s", static_cast<unsigned long long>(s.steps),
              table(rows, {false, true, true, true, true, true, true, true, true, true}).c_str());
  std::printf("causes less change: %.1e J, %.1e N s, %.1e N m s\n", energy - (kinetic + potential), size_of(off_linear),
              size_of(off_angular));
}

void LedgerPlot::add(const World& world, double time) {
  const std::vector<carom_ledger_entry> entries = world.ledger();
  const carom_ledger_state s = world.ledger_state();
  if (causes_.empty())
    for (const carom_ledger_entry& e : entries) causes_.push_back({e.name, {}});
  times_.push_back(time);
  // Gravity's energy is none: drawn is what it gave to motion.
  for (std::size_t i = 0; i < entries.size(); ++i) causes_[i].energy.push_back(entries[i].total_kinetic);
  state_.push_back(s.now_kinetic - s.start_kinetic);
}

std::string LedgerPlot::draw(const std::string& title) const {
  std::vector<const Line*> most;
  for (const Line& line : causes_)
    if (peak(line.energy) > 0) most.push_back(&line);
  std::stable_sort(most.begin(), most.end(),
                   [](const Line* a, const Line* b) { return peak(a->energy) > peak(b->energy); });
  if (most.size() > kLines) most.resize(kLines);
  while (!most.empty() && peak(most.back()->energy) < kSmall * peak(most.front()->energy)) most.pop_back();
  report::LinePlot plot;
  plot.title = title;
  plot.x.label = "time, s";
  plot.y.label = "energy of motion given since the start, J";
  plot.dense = true;
  plot.note = "The ledger's largest causes; their sum, with the small ones, is the state's to rounding.";
  const auto points = [&](const std::vector<double>& values) {
    std::vector<report::Point> list;
    const std::size_t stride = 1 + times_.size() / kMostPoints;
    for (std::size_t i = 0; i < times_.size(); ++i)
      if (i % stride == 0 || i + 1 == times_.size()) list.push_back({times_[i], values[i]});
    return list;
  };
  int colour = 0;
  for (const Line* line : most) plot.series.push_back({line->name, points(line->energy), colour++});
  plot.series.push_back({"state", points(state_), colour});
  return report::draw(plot);
}

}  // namespace carom::tools
