// Figure 3: steps per second of the paper's four scenes.
#include "report/paper.h"
#include "report/plot.h"

namespace carom::report {
namespace {

// Averages that the paper measured on a PC of 2006.
struct Entry {
  const char* label;
  const char* scene;
  double paper;
};
constexpr Entry kEntries[] = {{"A seesaw", "seesaw", 991},
                              {"B catapult", "catapult", 501},
                              {"C bunnies", "bunnies", 104},
                              {"D particles", "particles", 170}};

// The methods the paper names, as dials of ours.
const std::vector<std::string> kPaperDials = {"integrator=explicit_euler",   "solver=severity",
                                              "severity_search=linear",      "groups=on",
                                              "broad_phase=sweep_and_prune", "narrow_phase=hybrid"};

}  // namespace

std::size_t scene_runs() { return 2 * std::size(kEntries); }

Figure scene_speeds(PaperRun& run) {
  Figure figure;
  figure.heading = "Steps per second of the paper's scenes";
  figure.file_name = "scenes.svg";
  figure.table.title = figure.heading;
  figure.table.header = {"scene", "bodies",          "steps",          "min",  "average",
                         "max",   "paper's methods", "paper, 2006 PC", "ratio"};
  BarChart chart;
  chart.title = figure.heading;
  chart.value = {"steps per second", Scale::log, false, {}};
  chart.note = "bars: our defaults, one thread; dashed: the paper's average on a PC of 2006";
  std::string slower;
  for (const Entry& e : kEntries) {
    const auto told = [&](double done) { run.progress(e.label, done); };
    told(0);
    RunSpec spec{e.scene, {{}, run.mesh_path}, {}, run.quick ? 1.0 : 0};
    const Measured ours = measure(run.engine, spec, told);
    const std::string label = std::string(e.label) + ", paper's methods";
    const auto told_again = [&](double done) { run.progress(label, done); };
    told_again(0);
    spec.dials = kPaperDials;
    const Measured faithful = measure(run.engine, spec, told_again);
    const double average = ours.run.average_rate;
    figure.table.rows.push_back({e.label, short_number(static_cast<double>(ours.run.last.dynamic_bodies)),
                                 short_number(static_cast<double>(ours.run.steps)), number(ours.run.min_rate),
                                 number(average), number(ours.run.max_rate), number(faithful.run.average_rate),
                                 short_number(e.paper), number(average / e.paper)});
    chart.rows.push_back({e.label, {{"ours", average, 0}}, number(average), e.paper, "paper " + short_number(e.paper)});
    if (average < e.paper) slower += (slower.empty() ? "" : ", ") + std::string(e.label);
  }
  figure.remarks.push_back(
      "Two computers 15 years or more apart: the ratio is what a reader of the paper would see today, not "
      "a comparison of methods. The scenes are built after the paper's descriptions; sizes it does not "
      "give are ours.");
  if (!slower.empty()) figure.remarks.push_back("Slower here than in the paper: " + slower + ".");
  if (run.quick)
    figure.remarks.push_back(
        "This was a quick run of the first second, when little touches: expect the full run to be slower.");
  figure.drawing = draw(chart);
  return figure;
}

}  // namespace carom::report
