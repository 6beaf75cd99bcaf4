// How many substeps fit into a budget of time, on a machine that is made up: a step costs `fixed + each * substeps`.
#include "abi/budget.h"
#include "carom_test.h"

using carom::abi::Budget;

namespace {

struct Machine {
  double fixed = 1e-3, each = 0.5e-3;  // s
  double step(Budget& budget, std::uint32_t& substeps) const {
    substeps = budget.choose(substeps);
    budget.learn(fixed + each * substeps, each * substeps, substeps);
    return fixed + each * substeps;
  }
};

}  // namespace

static void it_fills_the_budget_and_stays(void**) {
  const Machine machine;
  for (const double seconds : {2e-3, 3e-3, 4.2e-3, 9e-3}) {
    Budget budget(seconds, 1, 64);
    std::uint32_t substeps = 1;
    for (int i = 0; i < 100; ++i) assert_true(machine.step(budget, substeps) <= seconds);
    const std::uint32_t settled = substeps;
    for (int i = 0; i < 100; ++i) {
      machine.step(budget, substeps);
      assert_int_equal(substeps, settled);
    }
    // One more would have taken the last 15 %, which is kept as room.
    assert_true(machine.fixed + machine.each * (settled + 1) > 0.85 * seconds);
  }
}

static void a_step_that_takes_too_long_is_answered_at_once(void**) {
  Machine machine;
  Budget budget(6e-3, 2, 64);
  std::uint32_t substeps = 4;
  for (int i = 0; i < 50; ++i) machine.step(budget, substeps);
  const std::uint32_t before = substeps;
  machine.each *= 3;
  assert_true(machine.step(budget, substeps) > 6e-3);  // nobody could know
  assert_true(machine.step(budget, substeps) <= 6e-3);
  assert_true(substeps < before && substeps >= 2);
  machine.each /= 3;
  for (int i = 0; i < 100; ++i) assert_true(machine.step(budget, substeps) <= 6e-3);
  assert_int_equal(substeps, before);  // what was learnt of the bad moment is forgotten
}

static void its_bounds_hold(void**) {
  const Machine machine;
  for (const double seconds : {1e-9, 10.0}) {
    Budget budget(seconds, 3, 7);
    std::uint32_t substeps = 20;
    for (int i = 0; i < 20; ++i) {
      machine.step(budget, substeps);
      assert_true(substeps >= 3 && substeps <= 7);
    }
    assert_int_equal(substeps, seconds < 1 ? 3 : 7);
  }
}

static void a_world_without_substeps_to_pay_for_learns_nothing_false(void**) {
  Budget budget(1e-3, 1, 8);
  for (int i = 0; i < 10; ++i) budget.learn(0.2e-3, 0, 1);  // nothing moves
  assert_int_equal(budget.choose(4), 4);
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(it_fills_the_budget_and_stays),
      cmocka_unit_test(a_step_that_takes_too_long_is_answered_at_once),
      cmocka_unit_test(its_bounds_hold),
      cmocka_unit_test(a_world_without_substeps_to_pay_for_learns_nothing_false),
  };
  return cmocka_run_group_tests_name("dynamics/budget", tests, nullptr, nullptr);
}
