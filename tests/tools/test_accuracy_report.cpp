// Sweeps and their report: fronts and profiles against brute force, files that come back as they were written, a page
// that is well-formed, has every section, and shows the numbers of the file.
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>

#include "accuracy/page/measured.h"
#include "accuracy/page/report.h"
#include "accuracy/page/view.h"
#include "accuracy/sweep/sweep.h"
#include "carom_test.h"
#include "tools/xml_check.h"

using namespace carom::tools;
using namespace carom::tools::accuracy;

namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// Points on a coarse grid, so that ties are common.
std::vector<accuracy::Point> random_points(std::mt19937& random, int n) {
  std::vector<accuracy::Point> points;
  for (int i = 0; i < n; ++i) {
    const double cost = 1 + static_cast<double>(random() % 12), error = static_cast<double>(random() % 12);
    points.push_back({cost, random() % 15 ? error : kNever});
  }
  return points;
}

bool beats(const accuracy::Point& a, const accuracy::Point& b) {
  return a.cost <= b.cost && a.error <= b.error && (a.cost < b.cost || a.error < b.error);
}

/// A sweep of three quick scenes, made once.
const Sweep& tiny() {
  static const Sweep found = [] {
    Engine engine(PluginPath({CAROM_PLUGIN_DIR}));
    SweepPlan plan;
    for (const char* name : {"slide", "skid", "massratio1e2"}) plan.scenes.push_back(&find_challenge(name));
    for (Entry& entry : carom_entries())
      if (entry.setting == kDefaultSetting || entry.setting == "direct, 1 substep")
        plan.entries.push_back(std::move(entry));
    // Another engine that is Carom in disguise: at its worst, so that it is beaten, and at its best on one scene.
    plan.entries.push_back({"Other 1.0 (double)",
                            "as it comes",
                            [](const Challenge& c) { return c.scene.name != "massratio1e2"; },
                            {"solver=soft_step", "substeps=1"},
                            {}});
    plan.entries.push_back({"Other 1.0 (double)",
                            "finer",
                            [](const Challenge& c) { return c.scene.name == "slide"; },
                            {"solver=direct", "substeps=16"},
                            {}});
    plan.steps = {1.0 / 30, 1.0 / 60, 1.0 / 120};
    plan.seconds = 60;
    return sweep(engine, plan, {});
  }();
  return found;
}

std::filesystem::path temporary(const std::string& name) {
  return std::filesystem::temp_directory_path() / ("carom_report_" + std::to_string(getpid()) + "_" + name);
}

std::string without_doctype(const std::string& html) { return html.substr(html.find("<html")); }

}  // namespace

static void a_front_is_what_no_point_beats(void**) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 400; ++trial) {
    const auto points = random_points(random, 1 + trial % 30);
    const auto front = pareto_front(points);
    for (std::size_t k = 0; k < front.size(); ++k) {
      for (const auto& other : points) assert_false(beats(other, points[front[k]]));
      if (k > 0)
        assert_true(points[front[k]].cost > points[front[k - 1]].cost &&
                    points[front[k]].error < points[front[k - 1]].error);
    }
    for (const auto& p : points) {  // and every other one is beaten by, or the same as, one on it
      if (!std::isfinite(p.error)) continue;
      assert_true(std::any_of(front.begin(), front.end(), [&](std::size_t i) {
        return beats(points[i], p) || (points[i].cost == p.cost && points[i].error == p.error);
      }));
    }
  }
  assert_true(pareto_front({}).empty() && pareto_front({{1, kNever}}).empty());
}

static void a_lead_is_the_smaller_of_both_factors(void**) {
  const std::vector<accuracy::Point> ours = {{1, 1e-2}, {10, 1e-4}};
  assert_true(std::fabs(lead_of({2, 1e-3}, ours) - 5) < 1e-12);                 // 10 in error, 5 in cost
  assert_true(std::fabs(lead_of({8, 1e-3}, ours) - 1.25) < 1e-12);              // 10 in error, 1.25 in cost
  assert_true(lead_of({2, 1e-2}, ours) == 1 && lead_of({20, 1e-3}, ours) < 1);  // beaten
  assert_true(std::fabs(lead_of({0.5, 1e-2}, ours) - 2) < 1e-12);               // nothing as cheap: half the cost
  assert_true(std::fabs(lead_of({20, 1e-5}, ours) - 10) < 1e-12);               // nothing as exact
  assert_true(std::isinf(lead_of({0.5, 1e-5}, ours)) && std::isinf(lead_of({1, 1}, {})));
  // Brute force: the largest factor f by which ours may be improved in both at once and still not beat theirs... is what
  // the smaller one of the two single factors bounds: at f below the lead no point of ours, scaled, reaches theirs.
  std::mt19937 random(11);
  for (int trial = 0; trial < 300; ++trial) {
    auto mine = random_points(random, 8);
    for (auto& p : mine) p.error += 1;
    const accuracy::Point theirs{1 + static_cast<double>(random() % 12), 1 + static_cast<double>(random() % 12)};
    const double lead = lead_of(theirs, mine);
    const bool beaten = std::any_of(mine.begin(), mine.end(), [&](const accuracy::Point& p) {
      return p.cost <= theirs.cost && p.error <= theirs.error;
    });
    assert_true(beaten == (lead <= 1));
    if (beaten) continue;
    double by_error = kNever, by_cost = kNever;
    for (const auto& p : mine) {
      if (p.cost <= theirs.cost) by_error = std::min(by_error, p.error / theirs.error);
      if (p.error <= theirs.error) by_cost = std::min(by_cost, p.cost / theirs.cost);
    }
    assert_true(lead == std::min(by_error, by_cost));
  }
}

static void a_slope_is_the_order_of_a_power(void**) {
  for (const double order : {1.0, 2.0, 4.0}) {
    std::vector<std::pair<double, double>> data;
    for (int rate = 30; rate <= 960; rate *= 2) data.emplace_back(1.0 / rate, 3 * std::pow(1.0 / rate, order));
    Slope slope = fit_slope(data, 1e-15);
    assert_true(std::fabs(slope.order - order) < 1e-9 && std::fabs(slope.at_1s - 3) < 1e-6 && slope.points == 6);
    data.emplace_back(1e-4, 1e-16);   // rounding
    data.emplace_back(1e-4, kNever);  // nothing
    slope = fit_slope(data, 1e-15);
    assert_true(std::fabs(slope.order - order) < 1e-9 && slope.points == 6);
  }
  assert_int_equal(fit_slope({{0.1, 1}, {0.05, 0.5}}, 0).points, 0);
}

static void a_profile_counts_who_is_within_tau_of_the_best(void**) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 100; ++trial) {
    const std::size_t solvers = 1 + random() % 4, problems = 1 + random() % 9;
    std::vector<std::vector<double>> costs(solvers, std::vector<double>(problems));
    for (auto& row : costs)
      for (double& c : row) c = random() % 4 ? 1 + static_cast<double>(random() % 9) : kNever;
    const auto ratios = profile_ratios(costs);
    for (const double tau : {1.0, 1.5, 2.0, 4.0, 100.0})
      for (std::size_t s = 0; s < solvers; ++s) {
        std::size_t within = 0;
        for (std::size_t p = 0; p < problems; ++p) {
          double best = kNever;
          for (const auto& row : costs) best = std::min(best, row[p]);
          within += std::isfinite(costs[s][p]) && costs[s][p] <= tau * best;
        }
        assert_true(std::fabs(profile_at(ratios[s], problems, tau) -
                              static_cast<double>(within) / static_cast<double>(problems)) < 1e-15);
      }
  }
}

static void every_setting_is_one_that_a_world_takes(void**) {
  Engine engine(PluginPath({CAROM_PLUGIN_DIR}));
  std::vector<std::string> names;
  for (const Setting& setting : carom_settings()) {
    Stage stage(engine);
    for (const std::string& dial : setting.dials) stage.world.set_dial(dial);  // throws
    assert_true(std::find(names.begin(), names.end(), setting.name) == names.end());
    names.push_back(setting.name);
  }
  assert_true(std::find(names.begin(), names.end(), kDefaultSetting) != names.end());
  // The default is a new world's.
  for (const Setting& setting : carom_settings()) {
    if (setting.name != kDefaultSetting) continue;
    Stage stage(engine);
    const double solver = stage.world.dial(CAROM_DIAL_SOLVER), substeps = stage.world.dial(CAROM_DIAL_SUBSTEPS);
    for (const std::string& dial : setting.dials) stage.world.set_dial(dial);
    assert_true(stage.world.dial(CAROM_DIAL_SOLVER) == solver && stage.world.dial(CAROM_DIAL_SUBSTEPS) == substeps);
  }
}

static void a_sweep_is_what_runs_one_by_one_give(void**) {
  Engine engine(PluginPath({CAROM_PLUGIN_DIR}));
  int compared = 0;
  for (const Row& row : tiny().rows) {
    assert_int_equal(row.errors.size(), find_challenge(row.scene).metrics.size());
    if (row.scene != "slide" || row.engine != "Carom" || row.setting != kDefaultSetting) continue;
    Request request;
    request.dt = row.dt;
    const Result one = run(engine, find_challenge("slide"), request, std::nullopt);
    assert_true(one.errors == row.errors && one.fell_at == row.fell_at);  // the same bits
    assert_true(row.cost > 0 && !row.left_out);
    ++compared;
  }
  assert_int_equal(compared, 3);
  // Maps come with massratio1e2: seven ratios at three steps, both settings.
  assert_int_equal(std::count_if(tiny().rows.begin(), tiny().rows.end(), [](const Row& r) { return !r.knobs.empty(); }),
                   42);
}

static void what_does_not_fit_into_the_time_is_left_out_and_says_so(void**) {
  Engine engine(PluginPath({CAROM_PLUGIN_DIR}));
  SweepPlan plan;
  plan.scenes = {&find_challenge("rolling")};
  plan.entries = carom_entries();
  plan.steps = sweep_steps();
  plan.seconds = 0.2;
  const Sweep found = sweep(engine, plan, {});
  const auto ran = std::count_if(found.rows.begin(), found.rows.end(), [](const Row& r) { return !r.left_out; });
  assert_true(ran > 0 && static_cast<std::size_t>(ran) < found.rows.size());
  for (const Row& row : found.rows) assert_true(row.left_out == !(row.simulated > 0));
}

static void a_file_comes_back_as_it_was_written(void**) {
  const auto path = temporary("sweep.json");
  Sweep sweep = tiny();
  sweep.rows[0].errors[0] = kNever;
  sweep.rows[1].errors[0] = 0;
  write_json(path.string(), sweep);
  const Sweep back = read_json(path.string());
  assert_true(back.machine == sweep.machine && back.date == sweep.date && back.engines.size() == sweep.engines.size());
  assert_int_equal(back.rows.size(), sweep.rows.size());
  for (std::size_t i = 0; i < back.rows.size(); ++i) {
    const Row &a = back.rows[i], &b = sweep.rows[i];
    assert_true(a.engine == b.engine && a.setting == b.setting && a.scene == b.scene && a.knobs == b.knobs);
    assert_true(a.dt == b.dt && a.errors == b.errors && a.fell_at == b.fell_at && a.cost == b.cost);
    assert_true(a.simulated == b.simulated && a.left_out == b.left_out);
  }
  std::filesystem::remove(path);
  for (const char* wrong : {"", "{", "[]", "{\"format\": \"carom accuracy sweep 0\"}", "{\"rows\": []}",
                            "{\"format\": \"carom accuracy sweep 1\", \"machine\": 1}"}) {
    std::ofstream(path) << wrong;
    bool refused = false;
    try {
      read_json(path.string());
    } catch (const Error& error) {
      refused = !error.remedy.empty();
    }
    assert_true(refused);
  }
  std::filesystem::remove(path);
}

static void the_page_is_well_formed_has_every_section_and_the_numbers_of_the_file(void**) {
  Extras extras;
  extras.effects = {{"drag", "body", 44, 2}};
  extras.tolerances = {{"boxes, apart", 1e-6, 400, 1e-9}, {"boxes, apart", 1e-3, 300, 1e-7}};
  const std::string page = report_page(tiny(), extras);
  const XmlCheck xml(without_doctype(page));
  assert_true(xml.well_formed());
  for (const char* outside : {"http://www.w3.org/2000/svg"}) assert_true(page.find(outside) != std::string::npos);
  for (const char* refers : {"src=", "@import", "url(", "<link", "https:"})
    assert_true(page.find(refers) == std::string::npos);
  std::vector<std::string> ids;
  for (const Element& e : xml.elements())
    if (e.attributes.count("id")) {
      assert_true(std::find(ids.begin(), ids.end(), e.attributes.at("id")) == ids.end());
      ids.push_back(e.attributes.at("id"));
    }
  for (const char* id :
       {"findings", "defaults", "peers", "work-precision", "wp-slide", "wp-skid", "orders", "maps", "map-massratio",
        "profiles", "profile-solvers", "profile-engines", "effects", "tolerance", "method"})
    assert_true(std::find(ids.begin(), ids.end(), id) != ids.end());
  for (const Element& e : xml.elements())  // the contents lead somewhere
    if (e.name == "a") assert_true(std::find(ids.begin(), ids.end(), e.attributes.at("href").substr(1)) != ids.end());
  // A dot for every run that was not left out, with its figures to the last bit.
  std::size_t dots = 0;
  for (const Row& row : tiny().rows) {
    if (!row.knobs.empty() || row.left_out) continue;
    const auto found = std::count_if(xml.elements().begin(), xml.elements().end(), [&](const Element& e) {
      return e.attributes.count("data-setting") && e.attributes.at("data-setting") == row.engine + ": " + row.setting &&
             std::atof(e.attributes.at("data-dt").c_str()) == row.dt &&
             std::atof(e.attributes.at("data-cost").c_str()) == row.cost &&
             (std::atof(e.attributes.at("data-error").c_str()) == row.errors[0] || !std::isfinite(row.errors[0]));
    });
    assert_true(found >= 1);
    ++dots;
  }
  assert_true(dots > 20);
}

static void a_peer_that_is_ahead_is_marked_and_one_that_is_not_is_not(void**) {
  Sweep sweep = tiny();
  std::erase_if(sweep.rows, [](const Row& r) { return r.scene != "slide" || r.engine != "Carom" || !r.knobs.empty(); });
  for (Row& row : sweep.rows) row.cost = 1e-3, row.errors[0] = 1e-3;
  Row peer = sweep.rows[0];
  peer.engine = "Other", peer.setting = "best";
  const auto marked = [&](double cost, double error, double fell_at = -1) {
    Sweep both = sweep;
    both.rows.push_back(peer);
    both.rows.back().cost = cost, both.rows.back().errors[0] = error, both.rows.back().fell_at = fell_at;
    return report_page(both, {}).find("<tr class=\"bad\"") != std::string::npos;
  };
  assert_true(marked(1e-3, 1e-4));        // ten times less error for the same
  assert_true(marked(1e-4, 1e-3));        // ten times cheaper
  assert_false(marked(2e-3, 1e-3));       // dearer
  assert_false(marked(0.9e-3, 1e-3));     // within what times differ by
  assert_false(marked(1e-3, 1e-4, 0.5));  // it fell
  const auto ahead = view_of(sweep);
  assert_true(worst_lead(ahead.scenes[0]).theirs == nullptr);
}

static void the_page_of_errors_has_every_scene(void**) {
  std::ifstream file(std::string(CAROM_SOURCE_DIR) + "/src/tools/accuracy/ERRORS.md");
  const std::string page(std::istreambuf_iterator<char>(file), {});
  for (const Challenge& c : all_challenges())
    for (const Metric& metric : c.metrics) {
      const std::string unit = metric.unit.empty() ? "" : ", " + metric.unit;
      assert_true(page.find("| " + c.scene.name + " | " + metric.what + unit + " |") != std::string::npos);
    }
}

static void tolerances_and_effects_are_measured(void**) {
  Engine engine(PluginPath({CAROM_PLUGIN_DIR}));
  const auto tolerances = measure_tolerances(engine);
  assert_true(tolerances.size() == 8 * 7);
  for (const auto& t : tolerances) {
    // A bracket is as narrow as was asked, relative to the pair's size of at most 3 m; rounding of metres beside it. A deep
    // pair of curved shapes ends where its polytope has as many faces as there is room for, and says how wide that is.
    const double least = t.pair == "ellipsoids, deep" ? 1e-8 : 1e-13;
    if (!(t.width <= 3 * t.tolerance + least))
      std::printf("%s, tolerance %g: %g m wide\n", t.pair.c_str(), t.tolerance, t.width);
    assert_true(t.ns > 0 && t.width >= 0 && t.width <= 3 * t.tolerance + least);
  }
  const auto path = temporary("effects.csv");
  std::ofstream(path)
      << "effect,participants,unit,evaluations_a_step,ns_a_participant,ns_an_evaluation,ms_a_scene,spread_ms,"
         "ms_a_step,ns_alone,spread_alone_ns\n\"drag, air\",10000,bodies,8,350,44,3.5,0.1,9,120,5\n";
  const auto effects = read_effects(path.string());
  std::filesystem::remove(path);
  assert_int_equal(effects.size(), 1);
  assert_true(effects[0].name == "drag, air" && effects[0].ns == 350 && std::fabs(effects[0].spread - 10) < 1e-9);
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(a_front_is_what_no_point_beats),
      cmocka_unit_test(a_lead_is_the_smaller_of_both_factors),
      cmocka_unit_test(a_slope_is_the_order_of_a_power),
      cmocka_unit_test(a_profile_counts_who_is_within_tau_of_the_best),
      cmocka_unit_test(every_setting_is_one_that_a_world_takes),
      cmocka_unit_test(a_sweep_is_what_runs_one_by_one_give),
      cmocka_unit_test(what_does_not_fit_into_the_time_is_left_out_and_says_so),
      cmocka_unit_test(a_file_comes_back_as_it_was_written),
      cmocka_unit_test(the_page_is_well_formed_has_every_section_and_the_numbers_of_the_file),
      cmocka_unit_test(a_peer_that_is_ahead_is_marked_and_one_that_is_not_is_not),
      cmocka_unit_test(the_page_of_errors_has_every_scene),
      cmocka_unit_test(tolerances_and_effects_are_measured),
  };
  return cmocka_run_group_tests_name("tools/accuracy_report", tests, nullptr, nullptr);
}
