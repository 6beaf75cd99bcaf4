// Trials by themselves: runs of a made-up island whose error is c (1/n)^p.
#include <cmath>

#include "carom_test.h"
#include "dynamics/accuracy/control.h"

using namespace carom;
using namespace carom::dynamics;
using namespace carom::dynamics::accuracy;

namespace {

/// A trial of an island with an error of c n^-p (tolerances). @return it, over
Trial tried(const AccuracyMemory& note, Real c, int p, int least = 1, int most = 256) {
  Trial t;
  t.begin(note, note.met, p, least, most);
  const auto error = [&](int n) { return c * std::pow(Real(n), -p); };
  for (int runs = 0; t.run > 0; ++runs) {
    assert_true(runs < 40);
    const Real apart = t.coarse > 0 ? error(t.coarse) - error(t.run) : 0;
    t.end_run(true, {apart, 0});
  }
  return t;
}

}  // namespace

static void levels_ascend_and_all_but_the_first_have_a_half(void**) {
  for (int level = 1; level <= kMostLevel; ++level) {
    assert_true(substeps_at(level) > substeps_at(level - 1));
    assert_int_equal(substeps_at(level) % 2, 0);
    assert_int_equal(level_within(substeps_at(level)), level);
    assert_int_equal(level_for(substeps_at(level)), level);
    assert_int_equal(level_within(substeps_at(level) - 0.5), level - 1);
  }
}

/// What is accepted errs by less than the tolerance, and two levels fewer would err by more.
static void the_fewest_substeps_within_the_tolerance_are_found(void**) {
  for (const int p : {1, 2, 4})
    for (const Real c : {1e-3, 0.5, 3.0, 40.0, 90.0}) {
      AccuracyMemory note;
      note.level = 2;
      for (int step = 0; step < 12; ++step) note = tried(note, c, p).memory_after(note, note.met);
      const Trial t = tried(note, c, p);
      assert_true(c * std::pow(Real(t.taken), -p) <= 1);
      assert_false(t.hit_bound);
      if (note.level > 1) assert_true(c * std::pow(Real(substeps_at(note.level - 2)), -p) > kAccuracyAim);
      std::printf("  order %d, error %g of one substep: %d substeps\n", p, c, t.taken);
    }
}

/// The estimate is the error itself, where the order is as told.
static void the_estimate_is_the_error(void**) {
  for (const int p : {1, 2, 4}) {
    const Trial t = tried(AccuracyMemory{.level = 4}, 2.5, p);
    const Real truth = 2.5 * std::pow(Real(t.taken), -p);
    assert_true(std::fabs(t.error.most() - truth) < 1e-12 * truth);
  }
}

static void a_bound_of_work_is_hit_and_told(void**) {
  const Trial t = tried({}, 1e6, 1, 1, 32);
  assert_true(t.hit_bound);
  assert_int_equal(t.taken, 32);
  assert_true(t.error.most() > 1);
}

/// A quiet island is estimated every eighth step, a busy one every second, and one that meets another at once.
static void quiet_islands_are_estimated_rarely(void**) {
  const auto estimates = [](Real c) {
    AccuracyMemory note;
    int count = 0;
    for (int step = 0; step < 64; ++step) {
      const Trial t = tried(note, c, 2);
      count += t.is_estimated;
      note = t.memory_after(note, note.met);
    }
    return count;
  };
  assert_in_range(estimates(1e-4), 64 / kAccuracyEveryQuiet, 64 / kAccuracyEveryQuiet + 2);
  assert_in_range(estimates(100), 64 / kAccuracyEvery, 64 / kAccuracyEvery + 4);
  AccuracyMemory waits;
  waits.wait = 5;
  Trial t;
  t.begin(waits, 1, 2, 1, 256);
  assert_true(t.estimates);
}

/// A run that fails is tried with more; at the bound it ends.
static void what_fails_is_tried_finer_up_to_the_bound(void**) {
  Trial t;
  t.begin({}, 0, 1, 1, 64);
  int most = 0;
  for (int runs = 0; t.run > 0; ++runs) {
    assert_true(runs < 40);
    most = std::max(most, t.run);
    t.end_run(false, {});
  }
  assert_int_equal(most, 64);
  assert_true(t.hit_bound);
}

static void islands_that_join_take_the_higher_level_and_an_estimate(void**) {
  AccuracyMemory a, b;
  a.level = 3, a.wait = 4, b.level = 6, b.wait = 1;
  AccuracyMemory both;
  join_memory(both, a, true), join_memory(both, b, false);
  assert_int_equal(both.level, 6);
  assert_int_equal(both.wait, 0);
}

/// An error that does not fall is not chased up to the bound; and not again until it grows.
static void what_more_substeps_do_not_help_is_left(void**) {
  AccuracyMemory note;
  const auto step = [&](Real share) {
    Trial t;
    t.begin(note, note.met, 1, 1, 1024);
    int most = 0;
    while (t.run > 0) {
      most = std::max(most, t.run);
      t.end_run(true, {share, 0});
    }
    note = t.memory_after(note, note.met);
    return most;
  };
  assert_true(step(5) <= 32);
  assert_true(note.stalled);
  for (int k = 0; k < 30; ++k) assert_true(step(5) <= 4);
  note.wait = 0;
  assert_true(step(50) > 4);
  note.wait = 0;
  assert_true(step(0.1) <= 32);
  assert_false(note.stalled);
}

namespace {

/// Steps of an island that joints alone hold, with errors c[order] n^-order of n substeps; its last trial.
struct Linkage {
  Real c[3];  // of orders 2, 4 and 6
  AccuracyMemory memory;
  std::uint64_t stages = 0;
  Real worst = 0;  // error accepted, over the tolerance

  Trial step(int least) {
    Trial t;
    t.begin(memory, memory.met, std::max<int>(least, memory.order > 0 ? memory.order : 4), 1, 256);
    const auto error = [&](int n) { return c[t.order / 2 - 1] * std::pow(Real(n), -t.order); };
    while (t.run > 0) {
      stages += static_cast<std::uint64_t>(t.run) * (t.order == 2 ? 1 : t.order == 4 ? 5 : 9);
      const Real apart = t.coarse > 0 ? error(t.coarse) - error(t.run) : 0;
      if (t.end_run(true, {apart, 0}) == End::dropped) climb(t);
    }
    worst = std::max(worst, error(t.taken));
    memory = t.memory_after(memory, memory.met);
    choose_order(memory, t, least);
    return t;
  }
};

}  // namespace

/// In the long run the order is the one that takes the fewest stages, but for trials of a lower one.
static void orders_are_those_that_cost_least(void**) {
  struct Case {
    Real c[3];
    int order;
  };
  for (const Case& at : {Case{{1, 0.02, 0.001}, 2}, Case{{5, 0.1, 0.01}, 2}, Case{{200, 0.4, 0.1}, 4},
                         Case{{2000, 5, 0.9}, 4}, Case{{5e4, 3000, 30}, 6}, Case{{1e6, 1e5, 2e3}, 6}}) {
    Linkage l{{at.c[0], at.c[1], at.c[2]}, {}};
    for (int i = 0; i < 200; ++i) l.step(2);
    l.stages = 0, l.worst = 0;
    int at_order = 0;
    for (int i = 0; i < 400; ++i) at_order += l.step(2).order == at.order;
    std::printf("  errors %g, %g, %g: order %d in %d of 400 steps, %g stages a step\n", at.c[0], at.c[1], at.c[2],
                at.order, at_order, static_cast<double>(l.stages) / 400);
    assert_true(at_order > 340 && l.worst <= 1);
  }
}

/// A host's order is the least.
static void no_order_is_below_the_hosts(void**) {
  Linkage l{{1e-9, 1e-9, 1e-9}, {}};
  for (int i = 0; i < 200; ++i) assert_int_equal(l.step(6).order, 6);
  for (int i = 0; i < 200; ++i) assert_true(l.step(4).order >= 4);
  for (int i = 0; i < 200; ++i) l.step(2);
  assert_int_equal(l.step(2).order, 2);
}

/// A motion that grows wild and calm again is followed.
static void orders_follow_a_motion_that_changes(void**) {
  Linkage l{{0.1, 0.01, 0.001}, {}};
  for (int i = 0; i < 100; ++i) l.step(2);
  assert_int_equal(l.memory.order, 2);
  l.c[0] = 1e5, l.c[1] = 1e4, l.c[2] = 300;
  for (int i = 0; i < 8; ++i) l.step(2);  // a quiet island is estimated every eighth
  l.worst = 0;
  for (int i = 0; i < 8; ++i) l.step(2);
  assert_true(l.memory.order == 6 && l.worst <= 1);
  l.c[0] = 0.1, l.c[1] = 0.01, l.c[2] = 0.001;
  for (int i = 0; i < 400; ++i) l.step(2);
  assert_int_equal(l.memory.order, 2);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(levels_ascend_and_all_but_the_first_have_a_half),
      cmocka_unit_test(the_fewest_substeps_within_the_tolerance_are_found),
      cmocka_unit_test(the_estimate_is_the_error),
      cmocka_unit_test(a_bound_of_work_is_hit_and_told),
      cmocka_unit_test(quiet_islands_are_estimated_rarely),
      cmocka_unit_test(what_fails_is_tried_finer_up_to_the_bound),
      cmocka_unit_test(what_more_substeps_do_not_help_is_left),
      cmocka_unit_test(islands_that_join_take_the_higher_level_and_an_estimate),
      cmocka_unit_test(orders_are_those_that_cost_least),
      cmocka_unit_test(no_order_is_below_the_hosts),
      cmocka_unit_test(orders_follow_a_motion_that_changes),
  };
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
