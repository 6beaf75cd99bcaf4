// The sections of a report, in their order.
#include "accuracy/page/report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>

#include "accuracy/page/controls.h"
#include "accuracy/page/document.h"
#include "accuracy/page/figures.h"
#include "accuracy/page/findings.h"
#include "accuracy/sweep/settings.h"
#include "report/plot.h"

namespace carom::tools::accuracy {
namespace {

/// What the page's filters go by.
std::string data(const char* name, const std::string& value) {
  return std::string(" data-") + name + "=\"" + report::escape(value) + "\"";
}
std::string lead_data(const SceneView& scene) {
  const double lead = compared(scene) ? worst_lead(scene).ratio : 0;
  return data("scene", scene.challenge->scene.name) + data("lead", format("%.4g", std::min(lead, 1e300)));
}

void add_defaults_table(Document& page, const View& view) {
  std::vector<std::vector<std::string>> rows;
  std::vector<std::string> row_data;
  for (const SceneView& scene : view.scenes) {
    const Row* row = default_row(scene);
    if (!row) continue;
    row_data.push_back(lead_data(scene));
    const Metric& metric = scene.challenge->metrics[0];
    const Row* cheapest = cheapest_within(scene, kOurs);
    rows.push_back({scene.challenge->scene.name, metric.what,
                    row->fell_at >= 0 ? "fell" : error_text(row->errors[0], metric),
                    has_bound(scene) ? error_text(metric.bound, metric) : "", frame_text(row->cost),
                    cheapest           ? at_text(*cheapest)
                    : has_bound(scene) ? "none reaches it"
                                       : "",
                    cheapest ? frame_text(cheapest->cost) : ""});
  }
  page.table("Carom at its defaults, 60 steps a second; and the cheapest setting of all that is within the bound",
             {"scene", "what", "error", "bound", "a frame", "cheapest within the bound", "a frame of it"}, rows, false,
             {}, "", row_data);
}

/// The least error of ours for at most so much; of equal ones the cheapest.
const Row* best_within(const SceneView& scene, double cost) {
  const Cloud cloud = cloud_of(scene, kOurs);
  const Row* best = nullptr;
  Point least;
  for (std::size_t i = 0; i < cloud.rows.size(); ++i) {
    const Point& p = cloud.points[i];
    if (p.cost > cost || (best && (p.error > least.error || (p.error == least.error && p.cost >= least.cost))))
      continue;
    best = cloud.rows[i], least = p;
  }
  return best;
}

void add_budget(Document& page, const View& view) {
  page.heading(2, "budget", "Within a budget");
  page.paragraph(
      "What errs least on each scene for at most so much computing a frame at 60 Hz, and the command that runs it. The slider "
      "\"my budget\" at the top of the page changes it; filters by engine and setting count.");
  std::vector<std::vector<std::string>> rows;
  std::vector<std::string> row_data;
  for (const SceneView& scene : view.scenes) {
    const Row* best = best_within(scene, 60 * kFirstBudget);
    const Metric& metric = scene.challenge->metrics[0];
    const std::string& name = scene.challenge->scene.name;
    rows.push_back({name});
    if (best)
      rows.back().insert(
          rows.back().end(),
          {at_text(*best), error_text(best->errors[0], metric), frame_text(best->cost),
           "carom accuracy run " + name + " " + options_of(best->setting) + format(" --dt 1/%.4g", 1 / best->dt)});
    else
      rows.back().push_back("nothing is as cheap");
    row_data.push_back(lead_data(scene) + data("unit", metric.unit));
  }
  page.table("For " + frame_text(60 * kFirstBudget) + " a frame, unless the slider was moved",
             {"scene", "setting", "error", "a frame", "command"}, rows, false, {}, "budget-table", row_data);
}

void add_peers(Document& page, const Sweep& sweep, const View& view) {
  page.heading(2, "peers", "Beside other engines");
  const auto met = scenes_where(view, compared);
  if (met.empty()) {
    page.paragraph(
        "This sweep holds no other engine. `accuracy_peers` (tests/bench/accuracy_peers, built with "
        "CAROM_BUILD_BENCHMARKS) runs the same scenes through those that are installed, Carom among them, in one "
        "process; give its file with a second --from.");
    return;
  }
  page.paragraph(
      "The same bodies, the same judge, one process, one thread, the same clock. A row is red where some setting of "
      "another engine errs less than every setting of Carom that costs as much or less, and costs less than every one "
      "that is as exact, by more than a quarter; the ratio is the smaller of the two. Errors below 1e-12 count as "
      "equal: "
      "that is rounding. Those above a thousand times the scene's bound are no solution, and lead nowhere.");
  std::vector<std::vector<std::string>> rows;
  std::vector<bool> red;
  std::vector<std::string> row_data;
  for (const SceneView* scene : met) {
    const Metric& metric = scene->challenge->metrics[0];
    const Lead lead = worst_lead(*scene);
    const bool behind = lead.ratio > kClearLead;
    const Row *a = cheapest_within(*scene, kOurs), *b = cheapest_within(*scene, "");
    std::vector<std::string> row = {scene->challenge->scene.name, a ? frame_text(a->cost) : "never",
                                    b ? frame_text(b->cost) + " " + b->engine : "never",
                                    behind ? ratio_text(lead.ratio) : "-"};
    if (behind) {
      row.push_back(lead.theirs->engine + ", " + at_text(*lead.theirs));
      row.push_back(error_text(lead.theirs->errors[0], metric) + " at " + frame_text(lead.theirs->cost));
      row.push_back(
          (std::isfinite(lead.our_error) ? error_text(lead.our_error, metric) + " there" : "nothing as cheap") +
          (std::isfinite(lead.our_cost) ? "; as exact at " + frame_text(lead.our_cost) : "; never as exact"));
    }
    rows.push_back(std::move(row));
    red.push_back(behind);
    row_data.push_back(lead_data(*scene));
  }
  page.table("Cost of a frame at 60 Hz to reach the bound, and where a front of theirs is below Carom's",
             {"scene", "Carom", "best of the others", "behind by", "furthest below at", "which has", "Carom"}, rows,
             false, red, "peers-table", row_data);
  std::vector<std::vector<std::string>> engines;
  for (const EngineNote& e : sweep.engines) engines.push_back({e.name, e.version, e.note});
  page.table("Engines, and how they were set up", {"engine", "version", "settings"}, engines);
}

const char* const kHowToReadWorkPrecision =
    "To the left is cheaper, down is more exact. A thin line is one setting; its dots are steps of 1/30 s (coarse) to 1/960 "
    "s. The bold line is an engine's front: no other run of it is both cheaper and more exact. Dashed verticals are what a "
    "frame at 60 Hz may cost, the dashed level is the scene's bound; crosses on top are runs that fell. Marks of Carom: "
    "circles auto, squares direct, triangles soft_step, diamonds severity; presets are named. Point at a dot for its figures, at "
    "a line to single it out.";

void add_work_precision(Document& page, const View& view) {
  page.heading(2, "work-precision", "What accuracy costs");
  page.paragraph(kHowToReadWorkPrecision);
  for (const std::string& topic : topics()) {
    const auto scenes = scenes_where(view, [&](const SceneView& s) { return topic_of(*s.challenge) == topic; });
    if (scenes.empty()) continue;
    page.heading(3, "wp-" + topic, topic);
    page.begin("sorted");
    for (const SceneView* scene : scenes) {
      page.begin("scene", lead_data(*scene));
      const Metric& metric = scene->challenge->metrics[0];
      page.figure("wp-" + scene->challenge->scene.name, work_precision(*scene, view).inlined(),
                  "Truth: " + scene->challenge->reference + ". Error: " + metric.what +
                      (metric.unit.empty() ? "" : ", in " + metric.unit) +
                      (has_bound(*scene) ? "; bound " + error_text(metric.bound, metric) : "") + ".");
      std::vector<std::vector<std::string>> rows;
      std::vector<std::string> row_data;
      for (const std::string& engine : scene->engines()) {
        const Cloud cloud = cloud_of(*scene, engine);
        for (const std::size_t i : cloud.front()) {
          const Row& row = *cloud.rows[i];
          rows.push_back(
              {engine, row.setting, step_text(row.dt), frame_text(row.cost), error_text(row.errors[0], metric)});
          row_data.push_back(data("engine", engine));
        }
      }
      page.table("The fronts in figures", {"engine", "setting", "step", "a frame", "error"}, rows, true, {}, "",
                 row_data);
      page.end();
    }
    page.end();
  }
}

std::string order_title(const std::string& topic) { return topic + ": error against step"; }

void add_orders(Document& page, const View& view) {
  page.heading(2, "orders", "How errors fall with the step");
  page.paragraph(
      "Both axes are logarithmic, and a finer step stands further left, so a method of order p is a line that rises to the "
      "right by p decades a decade. Blue is Carom at its defaults with a dashed line fitted by least squares, whose slope is "
      "the order that was observed; other engines stand at the first of their settings. Motion in contact is of first order "
      "in all of them; flight and bounces are not, where an engine solves them exactly.");
  for (const std::string& topic : topics()) {
    const auto scenes = scenes_where(view, [&](const SceneView& s) { return topic_of(*s.challenge) == topic; });
    if (scenes.empty()) continue;
    page.figure("order-" + topic, order_plot(scenes, view, order_title(topic)).inlined(),
                "Fits leave out errors at or below 1e-12, which is rounding.");
  }
}

const char* const kMassTitle = "Two cubes, the upper one so many times heavier";
const char* const kHeightTitle = "A column of so many equal cubes";

void add_maps(Document& page, const Sweep& sweep) {
  page.heading(2, "maps", "What stands, and what falls");
  const bool any = std::any_of(sweep.rows.begin(), sweep.rows.end(), [](const Row& r) { return !r.knobs.empty(); });
  if (!any) {
    page.paragraph("This sweep holds no maps: they come with scenes massratio1e2 and stack10.");
    return;
  }
  const char* how =
      "A cross: it fell within ten seconds. Else the number is how far it sank, in metres; darker is better. A dash: not "
      "measured, for want of time.";
  page.figure("map-massratio", stability_map(sweep, "massratio1e2", "ratio", kMassTitle).inlined(), how);
  page.figure("map-stack", stability_map(sweep, "stack10", "n", kHeightTitle).inlined(), how);
}

std::vector<Solver> own_solvers() {
  return {{"auto", kOurs, "auto"},
          {"direct", kOurs, "direct"},
          {"soft_step", kOurs, "soft_step"},
          {"severity", kOurs, "severity"},
          {"the defaults", kOurs, kDefaultSetting}};
}

std::vector<Solver> engines_as_solvers(const View& view) {
  std::vector<Solver> list;
  for (const std::string& engine : view.engines) list.push_back({engine, engine, ""});
  return list;
}

/// Scenes on which solvers differ: contacts or joints that last.
bool solved(const SceneView& scene) {
  return has_ours(scene) && has_bound(scene) && (traits_of(*scene.challenge).has & (kTouches | kJoined));
}
bool compared_to_bound(const SceneView& scene) { return compared(scene) && has_bound(scene); }

void add_profiles(Document& page, const View& view) {
  page.heading(2, "profiles", "Who reaches the bound, and how soon");
  page.paragraph(
      "A performance profile (Dolan and More): at 1 stands the share of scenes whose bound this one reaches at the least cost "
      "of all; at 10 the share that it reaches within ten times the least cost; where a line ends on the right, all that it "
      "reaches at whatever cost. Higher is better everywhere. Each may use any of its settings and any step.");
  const auto own = scenes_where(view, solved);
  if (!own.empty())
    page.figure("profile-solvers",
                performance_profile(own, own_solvers(), "Solvers of Carom, scenes with contacts or joints"),
                "\"the defaults\" may choose its step alone.");
  const auto met = scenes_where(view, compared_to_bound);
  if (!met.empty() && view.engines.size() > 1)
    page.figure("profile-engines",
                performance_profile(met, engines_as_solvers(view), "Engines, scenes that others ran too"),
                "Every engine at the best of its settings for each scene.");
}

void add_effects(Document& page, const Extras& extras) {
  page.heading(2, "effects", "What an effect costs");
  if (extras.effects.empty()) {
    page.paragraph(
        "Not measured here: `effect_costs --csv effects.csv` (tests/bench) measures it, --effects effects.csv shows it.");
    return;
  }
  page.paragraph(
      "Nanoseconds a participant and step, at the default dials: the difference between a world in which the effect runs and "
      "the same world in which it is forbidden, or what the library's plan of a step says. An effect without participants "
      "costs nothing.");
  report::BarChart chart;
  chart.title = "Cost of an effect";
  chart.value = {"ns a participant and step", report::Scale::log, false, {}};
  std::vector<std::vector<std::string>> rows;
  for (const Extras::Effect& e : extras.effects) {
    if (!(e.ns > 0)) continue;
    chart.rows.push_back({e.name, {{"", e.ns, 0}}, report::number(e.ns, 2) + " ns a " + e.unit, 0, ""});
    rows.push_back({e.name, e.unit, report::number(e.ns, 3), e.spread > 0 ? report::number(e.spread, 2) : ""});
  }
  page.figure("effects-bars", report::draw(chart),
              "The axis is logarithmic. Unit of each: what it serves, a body or a contact or a joint.");
  page.table("The same in figures", {"effect", "participant", "ns", "+-"}, rows, true);
}

void add_tolerances(Document& page, const Extras& extras) {
  page.heading(2, "tolerance", "What a distance costs");
  if (extras.tolerances.empty()) {
    page.paragraph("Not measured here.");
    return;
  }
  page.paragraph(
      "A distance comes as a bracket that holds the true one; gjk_tolerance says how wide it may be, relative to the pair's "
      "size. Left: what a query costs at each tolerance; right: how wide its bracket really is.");
  for (const bool of_time : {true, false}) {
    report::LinePlot plot;
    plot.title =
        of_time ? "Time of a query against the tolerance asked for" : "Width of the result against the tolerance";
    plot.x = {"tolerance, relative", report::Scale::log, false, {}};
    plot.y = {of_time ? "ns a query" : "width of the bracket, m", report::Scale::log, false, {}};
    plot.note = "generic path (GJK and EPA), pairs of about 1 m, apart and in overlap";
    for (const Extras::Tolerance& t : extras.tolerances) {
      auto line = std::find_if(plot.series.begin(), plot.series.end(),
                               [&](const report::Series& s) { return s.name == t.pair; });
      if (line == plot.series.end())
        line = plot.series.insert(plot.series.end(), {t.pair, {}, static_cast<int>(plot.series.size()) % 6, false});
      line->points.push_back({t.tolerance, of_time ? t.ns : std::max(t.width, 1e-17)});
    }
    page.figure(
        of_time ? "tolerance-ns" : "tolerance-width", report::draw(plot),
        of_time ? "To the left is more exact. Polytopes are solved to the end in a few steps, so their lines are flat; "
                  "round shapes pay for every digit."
                : "Answers are as a rule narrower than they need to be.");
  }
}

}  // namespace

std::string report_page(const Sweep& sweep, const Extras& extras) {
  const View view = view_of(sweep);
  std::size_t measured = 0, left_out = 0;
  for (const Row& row : sweep.rows) ++(row.left_out ? left_out : measured);
  Document page("What accuracy costs", format("%zu runs of %zu scenes with a known solution, %s, %s", measured,
                                              view.scenes.size(), sweep.machine.c_str(), sweep.date.c_str()));
  page.heading(2, "findings", "Findings");
  page.list(findings(view));
  page.contents_here();
  std::vector<std::string> scenes, presets;
  for (const SceneView& scene : view.scenes) scenes.push_back(scene.challenge->scene.name);
  for (const Setting& setting : carom_settings())
    if (const std::string preset = preset_of(setting.name); !preset.empty()) presets.push_back(preset);
  page.controls(view.engines, presets, scenes);
  add_budget(page, view);
  page.heading(2, "defaults", "The defaults, scene by scene");
  add_defaults_table(page, view);
  add_peers(page, sweep, view);
  add_work_precision(page, view);
  add_orders(page, view);
  add_maps(page, sweep);
  add_profiles(page, view);
  add_effects(page, extras);
  add_tolerances(page, extras);
  page.heading(2, "method", "How this was measured");
  page.list(
      {"Cost is CPU time of one thread inside the steps, per simulated second; of runs shorter than 0.15 s the least of "
       "three. A frame is 1/60 s.",
       "Errors are judged by the same code for every engine, which sees poses and velocities alone.",
       format("%zu runs were left out: they would have taken, or took, longer than the sweep had time for.", left_out),
       "Scenes that ask for a minute or more are cut short (arch, cards, kapla, bridge; the table in "
       "src/tools/accuracy/sweep/settings.cpp says to what)."});
  return page.text();
}

std::string report_drawing(const Sweep& sweep, const std::string& name) {
  const View view = view_of(sweep);
  std::string known;
  for (const SceneView& scene : view.scenes) {
    if (name == "wp:" + scene.challenge->scene.name) return work_precision(scene, view).document();
    known += (known.empty() ? "wp:" : ", wp:") + scene.challenge->scene.name;
  }
  for (const std::string& topic : topics()) {
    if (name == "order:" + topic)
      return order_plot(scenes_where(view, [&](const SceneView& s) { return topic_of(*s.challenge) == topic; }), view,
                        order_title(topic))
          .document();
    known += ", order:" + topic;
  }
  if (name == "map:massratio") return stability_map(sweep, "massratio1e2", "ratio", kMassTitle).document();
  if (name == "map:stack") return stability_map(sweep, "stack10", "n", kHeightTitle).document();
  if (name == "profile:solvers")
    return performance_profile(scenes_where(view, solved), own_solvers(),
                               "Solvers of Carom, scenes with contacts or joints");
  if (name == "profile:engines")
    return performance_profile(scenes_where(view, compared_to_bound), engines_as_solvers(view),
                               "Engines, scenes that others ran too");
  throw Error("there is no drawing called '" + name + "' in this sweep",
              "the drawings are: " + known + ", map:massratio, map:stack, profile:solvers, profile:engines");
}

}  // namespace carom::tools::accuracy
