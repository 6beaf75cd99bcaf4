// Pairs that other libraries got wrong: every one right, with the reference inside the bracket, on all three simplex
// dials.
#include <algorithm>
#include <cstdio>

#include "carom_test.h"
#include "collision/directions.h"
#include "exact_pairs.h"
#include "hard_pairs.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr Real kTolerances[] = {1e-3, 1e-6, 1e-9, 1e-12};
constexpr Simplex kSimplices[] = {Simplex::johnson, Simplex::voronoi, Simplex::voronoi_last};

const std::vector<HardPair>& pairs() {
  static const std::vector<HardPair> all = load_hard_pairs(CAROM_TEST_DATA "/convex_pairs.jsonl");
  return all;
}

QueryResult ask(const HardPair& p, Simplex simplex, Real tolerance) {
  QuerySettings settings;
  settings.simplex = simplex;
  settings.tolerance = tolerance;
  QueryResult result;
  SupportFault fault;
  generic_distance(p.a, p.b, p.b_in_a, settings, nullptr, result, fault);
  return result;
}

/// What was asked for, in metres: the tolerance is relative to the smaller shape.
Real metres(const HardPair& p, Real tolerance) { return tolerance * size_of_pair(p.a, p.b, p.b_in_a); }

Real size_of(const HardPair& p) { return p.b_in_a.p.abs().sum() + p.a.bounding_radius + p.b.bounding_radius; }

template <class Check>
void for_all(const char* what, const Check& check) {
  int failed = 0;
  for (const Real tolerance : kTolerances)
    for (const Simplex simplex : kSimplices)
      for (const HardPair& p : pairs()) {
        const QueryResult r = ask(p, simplex, tolerance);
        if (check(p, r, tolerance)) continue;
        ++failed;
        std::printf("%s: %s, simplex %u, tolerance %g: %.17g in [%.17g, %.17g], reference %.17g +- %g\n", what,
                    p.id.c_str(), static_cast<unsigned>(simplex), tolerance, r.separation, r.lower, r.upper, p.expected,
                    p.tolerance);
      }
  assert_int_equal(failed, 0);
}

}  // namespace

static void the_data_is_all_there(void**) { assert_int_equal(pairs().size(), 323); }

static void the_bracket_holds_the_reference(void**) {
  for_all("bracket", [](const HardPair& p, const QueryResult& r, Real) {
    return r.lower - p.tolerance <= p.expected && p.expected <= r.upper + p.tolerance && r.lower <= r.separation &&
           r.separation <= r.upper;
  });
}

static void the_value_is_within_what_was_asked(void**) {
  for_all("value", [](const HardPair& p, const QueryResult& r, Real tolerance) {
    const Real allowed = std::max(p.tolerance, metres(p, tolerance));
    const bool close = std::fabs(r.separation - p.expected) <= allowed;
    const bool verdict = std::fabs(p.expected) <= allowed || (r.separation < 0) == (p.expected < 0);
    return close && verdict;
  });
}

static void the_normal_is_the_one_best_direction(void**) {
  // n off by an angle x shortens the bound by at least (1 - cos x) times the smallest feature, and only shortfall /
  // feature is controlled: cos x >= 1 - asked / smallest, asked no looser than 1e-2 of the feature.
  for_all("normal", [](const HardPair& p, const QueryResult& r, Real tolerance) {
    const Real slack = std::max(p.tolerance, metres(p, tolerance)) / p.smallest;
    return !p.normal || slack > 1e-2 || r.normal.dot(*p.normal) >= 1 - std::max(slack, 1e-9);
  });
}

static void the_normal_wastes_less_than_a_hundredth_of_the_smallest_feature(void**) {
  // What the reported normal alone proves, looked along once more in long double, whatever is unique or not.
  for_all("waste", [](const HardPair& p, const QueryResult& r, Real tolerance) {
    const Real wasted = p.expected - static_cast<Real>(exact_bound(p.a, p.b, p.b_in_a, r.normal));
    return wasted <= std::max({p.tolerance, metres(p, tolerance), 1e-2 * p.smallest}) &&
           wasted <= p.tolerance + r.upper - r.lower + kBracketRounding * kUnitRoundoff * size_of(p);
  });
}

static void the_points_lie_on_the_surfaces_as_far_apart_as_it_says(void**) {
  for_all("points", [](const HardPair& p, const QueryResult& r, Real) {
    const Real rounding = kBracketRounding * kUnitRoundoff * size_of(p);
    const Real along = r.normal.dot(p.b_in_a.apply(r.point_b) - r.point_a);
    if (!(std::fabs(along - r.separation) <= r.upper - r.lower + rounding)) return false;
    for (const Vec3& n : asking_directions())
      if (n.dot(r.point_a - support_point(p.a, n)) > rounding || n.dot(r.point_b - support_point(p.b, n)) > rounding)
        return false;
    return true;
  });
}

static void nothing_is_infinite_and_nothing_goes_on_for_ever(void**) {
  const QuerySettings caps;
  for_all("form", [&](const HardPair&, const QueryResult& r, Real) {
    const bool numbers = carom::finite(r.separation) && carom::finite(r.lower) && carom::finite(r.upper) &&
                         carom::finite(r.normal) && carom::finite(r.point_a) && carom::finite(r.point_b);
    return numbers && r.status != QueryStatus::fault && r.gjk_iterations <= caps.gjk_cap &&
           r.epa_iterations <= caps.epa_cap;
  });
}

static void a_query_that_is_exact_enough_is(void**) {
  for_all("status", [](const HardPair& p, const QueryResult& r, Real tolerance) {
    return r.status != QueryStatus::exact_enough || r.upper - r.lower <= metres(p, tolerance);
  });
}

static void swapping_the_shapes_changes_no_digit_that_matters(void**) {
  int failed = 0;
  for (const HardPair& p : pairs()) {
    const Frame a_in_b(p.b_in_a.r.transpose(), -(p.b_in_a.r.transpose() * p.b_in_a.p));
    QueryResult straight, swapped;
    SupportFault fault;
    generic_distance(p.a, p.b, p.b_in_a, QuerySettings(), nullptr, straight, fault);
    generic_distance(p.b, p.a, a_in_b, QuerySettings(), nullptr, swapped, fault);
    // Two brackets of one number overlap. The inverse pose is itself rounded: 4 u of the offset.
    const Real slack = 4 * kEpsilon * p.b_in_a.p.norm();
    if (straight.lower > swapped.upper + slack || swapped.lower > straight.upper + slack) {
      ++failed;
      std::printf("swap: %s\n", p.id.c_str());
    }
  }
  assert_int_equal(failed, 0);
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(the_data_is_all_there),
      cmocka_unit_test(the_bracket_holds_the_reference),
      cmocka_unit_test(the_value_is_within_what_was_asked),
      cmocka_unit_test(the_normal_is_the_one_best_direction),
      cmocka_unit_test(the_normal_wastes_less_than_a_hundredth_of_the_smallest_feature),
      cmocka_unit_test(the_points_lie_on_the_surfaces_as_far_apart_as_it_says),
      cmocka_unit_test(nothing_is_infinite_and_nothing_goes_on_for_ever),
      cmocka_unit_test(a_query_that_is_exact_enough_is),
      cmocka_unit_test(swapping_the_shapes_changes_no_digit_that_matters),
  };
  return cmocka_run_group_tests_name("oracle/hard_pairs", tests, nullptr, nullptr);
}
