// The tolerance as a dial: every family against every family, from 1e-2 to 1e-12. What is asked is what comes, and
// asking for more never makes an answer worse.
#include <algorithm>

#include "carom_test.h"
#include "random_pairs.h"

using namespace carom;
using namespace carom::test;

namespace {

QueryResult ask(const ShapePair& p, Simplex simplex, int digits, const QuerySettings& base = {}) {
  QuerySettings settings = base;
  settings.simplex = simplex;
  settings.tolerance = std::pow(10.0, -digits);
  QueryResult result;
  SupportFault fault;
  generic_distance(p.a, p.b, p.b_in_a, settings, nullptr, result, fault);
  return result;
}

/// What rounding adds to a bracket, both sides of it. @see Difference::rounding
Real rounding(const ShapePair& p) {
  return 96 * kUnitRoundoff * (p.b_in_a.p.abs().sum() + p.a.bounding_radius + p.b.bounding_radius);
}

template <class Check>
void for_all(Real lo, Real hi, std::uint64_t seed, const Check& check) {
  Random random(seed);
  for (int a = 0; a < kFamilyCount; ++a)
    for (int b = a; b < kFamilyCount; ++b) {
      if (a == 4 || b == 4) continue;  // a thousand vertices ask nothing that 32 do not
      for (int i = 0; i < 3; ++i) {
        const ShapePair p = random_pair(random, a, b, random.uniform(lo, hi));
        for (int s = 0; s < 3; ++s) check(p, static_cast<Simplex>(s));
      }
    }
}

void brackets_nest_and_keep_what_was_asked(const ShapePair& p, Simplex simplex) {
  const QuerySettings caps;
  const Real size = std::min(p.a.bounding_radius, p.b.bounding_radius), slack = rounding(p);
  const QueryResult best = ask(p, simplex, 12);
  QueryResult coarser;
  for (int digits = 2; digits <= 12; ++digits) {
    const QueryResult r = ask(p, simplex, digits);
    const Real asked = size * std::pow(10.0, -digits);
    assert_true(r.lower <= r.separation && r.separation <= r.upper);
    assert_true(r.lower <= best.upper && best.lower <= r.upper);
    assert_true(r.gjk_iterations <= 2 * caps.gjk_cap && r.epa_iterations <= caps.epa_cap);
    if (r.status == QueryStatus::exact_enough) {
      assert_true(r.upper - r.lower <= asked);
      assert_true(std::fabs(r.separation - best.separation) <= asked + (best.upper - best.lower));
    } else {
      assert_true(digits > 6);  // random pairs are no hard pairs
    }
    // The walk is the same one, followed further.
    if (digits > 2) {
      assert_true(r.lower >= coarser.lower - slack && r.upper <= coarser.upper + slack);
      assert_true(r.support_calls >= coarser.support_calls);
    }
    coarser = r;
  }
}

}  // namespace

static void apart_a_smaller_tolerance_is_a_better_answer(void**) {
  for_all(1e-3, 1, 41, brackets_nest_and_keep_what_was_asked);
}

static void near_touching_a_smaller_tolerance_is_a_better_answer(void**) {
  for_all(-1e-4, 1e-4, 42, brackets_nest_and_keep_what_was_asked);
}

static void deep_a_smaller_tolerance_is_a_better_answer(void**) {
  for_all(-0.3, -1e-3, 43, brackets_nest_and_keep_what_was_asked);
}

static void a_cap_widens_the_bracket_and_says_so(void**) {
  for_all(-0.3, 0.3, 44, [](const ShapePair& p, Simplex simplex) {
    const QueryResult best = ask(p, simplex, 12);
    for (const int cap : {4, 6, 8, 12, 16, 24, 32}) {
      QuerySettings few;
      few.gjk_cap = few.epa_cap = cap;
      const QueryResult r = ask(p, simplex, 9, few);
      assert_true(r.gjk_iterations <= 2 * cap && r.epa_iterations <= cap);
      assert_true(r.lower <= best.upper && best.lower <= r.upper);
      const Real asked = 1e-9 * std::min(p.a.bounding_radius, p.b.bounding_radius);
      assert_true((r.status == QueryStatus::exact_enough) == (r.upper - r.lower <= asked));
    }
  });
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(apart_a_smaller_tolerance_is_a_better_answer),
      cmocka_unit_test(near_touching_a_smaller_tolerance_is_a_better_answer),
      cmocka_unit_test(deep_a_smaller_tolerance_is_a_better_answer),
      cmocka_unit_test(a_cap_widens_the_bracket_and_says_so),
  };
  return cmocka_run_group_tests_name("oracle/tolerance", tests, nullptr, nullptr);
}
