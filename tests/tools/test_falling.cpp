// The scene that speed is measured on, judged for quality: 15 s of 1,024 falling bodies lose none, stay finite, and lie
// still with less overlap than the eye can see.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "carom_test.h"
#include "scenes/run.h"
#include "sliced.h"

using namespace carom::tools;

static RunSummary fall(double n, double seconds, const char* dial, double value, std::vector<KindSummary>& ended) {
  Engine engine(PluginPath({CAROM_PLUGIN_DIR}));
  Stage stage(engine);
  const Scene& scene = find_scene("falling");
  build(scene, {{{"n", n}}, ""}, stage);
  if (dial) {
    uint32_t number = 0;
    assert_int_equal(carom_dial_find(dial, &number, nullptr), CAROM_OK);
    assert_int_equal(carom_world_set_dial(stage.world.get(), number, value, nullptr), CAROM_OK);
  }
  const RunSummary run = simulate(stage, nullptr, seconds, scene.dt);
  ended = where_it_ended(stage);
  return run;
}

static void nobody_is_lost(const RunSummary& run, const std::vector<KindSummary>& ended, std::size_t n) {
  std::size_t count = 0;
  for (const KindSummary& kind : ended) {
    count += kind.count;
    assert_int_equal(kind.escaped, 0);
    assert_int_equal(kind.not_finite, 0);
  }
  assert_int_equal(count, n);
  assert_int_equal(run.faults, 0);
  assert_int_equal(run.last.quarantined_bodies, 0);
  assert_true(std::isfinite(run.last.linear_energy) && std::isfinite(run.last.angular_energy));
}

/// Several heaps, since the deepest point of one is chance: of 14 heaps of 1,010 to 1,036 bodies it was 10.9 to 11.7 mm in
/// the mean, by which change had last parted their ways, with a spread of 2.2 mm; so of three a median above the 12 mm that
/// the design asks for came up now and then. By night it is of seven; by day one heap stays within four spreads of that mean.
const std::size_t kHeaps = carom::test::sliced<std::size_t>(7, 1, 1);
constexpr double kDeepestOfOne = 11.3e-3 + 4 * 2.2e-3;

static void of_1024_bodies_none_is_lost_in_15_s_and_the_heap_lies_still(void**) {
  std::vector<double> deepest(kHeaps);
  for (std::size_t k = 0; k < kHeaps; ++k) {
    const std::size_t n = 1024 - (kHeaps - 1) + 2 * k;
    std::vector<KindSummary> ended;
    const RunSummary run = fall(static_cast<double>(n), 15, nullptr, 0, ended);
    nobody_is_lost(run, ended, n);
    const double bodies = static_cast<double>(n);
    std::printf("  penetration max %.2f mm, mean %.2f mm; worst on the way %.0f mm; %.1e J a body, %.1e J of spin\n",
                1e3 * run.last.max_penetration, 1e3 * run.last.mean_penetration, 1e3 * run.worst_penetration,
                run.last.linear_energy / bodies, run.last.angular_energy / bodies);
    deepest[k] = run.last.max_penetration;
    assert_true(run.last.mean_penetration < 2e-3);
    // Bodies are counted, not joules: no law stops a ball that rolls or spins about the normal of its one contact, and
    // a single box that loses its hold on balls after 15 s has more energy than all others together.
    std::size_t moving = 0;
    for (const KindSummary& kind : ended) moving += kind.moving;
    assert_true(moving <= 10);
  }
  std::sort(deepest.begin(), deepest.end());
  assert_true(deepest[kHeaps / 2] < (kHeaps > 1 ? 12e-3 : kDeepestOfOne));
}

static void broad_phases_differ_in_time_alone(void**) {
  std::vector<KindSummary> ended;
  const RunSummary brute = fall(200, 3, "broad_phase", CAROM_BROAD_BRUTE_FORCE, ended);
  nobody_is_lost(brute, ended, 200);
  const RunSummary sweep = fall(200, 3, "broad_phase", CAROM_BROAD_SWEEP_AND_PRUNE, ended);
  const RunSummary grid = fall(200, 3, "broad_phase", CAROM_BROAD_GRID, ended);
  const RunSummary tree = fall(200, 3, "broad_phase", CAROM_BROAD_TREE, ended);
  assert_true(brute.hash == sweep.hash && brute.hash == grid.hash && brute.hash == tree.hash);
}

static void every_path_through_the_narrow_phase_keeps_the_heap_in_its_box(void**) {
  const struct {
    const char* dial;
    double value;
  } paths[] = {{"pair_routines", 0},
               {"manifold", CAROM_MANIFOLD_SINGLE},
               {"simplex", CAROM_SIMPLEX_JOHNSON},
               {"integrator", CAROM_INTEGRATOR_RK4},
               {"integrator", CAROM_INTEGRATOR_EXPLICIT_EULER},
               {"groups", 0},
               {"substeps", 2},
               {"warm_start", 0}};
  for (const auto& path : paths) {
    std::vector<KindSummary> ended;
    nobody_is_lost(fall(100, 4, path.dial, path.value, ended), ended, 100);
  }
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(of_1024_bodies_none_is_lost_in_15_s_and_the_heap_lies_still),
      cmocka_unit_test(broad_phases_differ_in_time_alone),
      cmocka_unit_test(every_path_through_the_narrow_phase_keeps_the_heap_in_its_box),
  };
  return cmocka_run_group_tests_name("tools/falling", tests, nullptr, nullptr);
}
