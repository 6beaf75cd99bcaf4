// Every pair routine against thousands of directions through the support functions, its slow and obvious twin.
//
// For every unit direction n, s(n) = min_B n.b - max_A n.a bounds the signed distance from below, and the signed
// distance is the largest of them. So an answer is right if and only if its own normal attains it and no other
// direction beats it.
#include <algorithm>
#include <cstdio>

#include "carom_test.h"
#include "collision/narrow/query.h"
#include "pair_cases.h"

using namespace carom;
using namespace carom::test;

namespace {

/// Directions all over the sphere, and around the answer at every scale down to 1e-6 rad.
Real best_of_sweep(const Shape& a, const Shape& b, const Frame& b_in_a, const Vec3& normal, int count, Random& random) {
  Real best = -kInfinity;
  for (int i = 0; i < count; ++i) best = std::max(best, separation_along(a, b, b_in_a, random.direction()));
  for (int axis = 0; axis < 3; ++axis)
    for (const Real side : {-1.0, 1.0})
      for (const Vec3& n : {Vec3(side * Vec3::unit(axis)), Vec3(side * b_in_a.r.col(axis))})
        best = std::max(best, separation_along(a, b, b_in_a, n / n.norm()));
  for (Real angle = 0.3; angle > 1e-6; angle *= 0.5) {
    const Vec3 n = normal + angle * random.direction();
    best = std::max(best, separation_along(a, b, b_in_a, n / n.norm()));
  }
  return best;
}

/// Name what went wrong, so that a failure can be looked at.
bool within(const char* what, Form a, Form b, int pose, Real error, Real tol) {
  if (error <= tol) return true;
  std::printf("forms %u-%u pose %d: %s off by %g, tolerance %g\n", static_cast<unsigned>(a), static_cast<unsigned>(b),
              pose, what, error, tol);
  return false;
}

void check_pair(Form form_a, Form form_b, Real scale, int poses, std::uint64_t seed) {
  Random random(seed);
  for (int i = 0; i < poses; ++i) {
    const Shape a = random_shape(form_a, scale, random), b = random_shape(form_b, scale, random);
    const Frame pose = random_pose(a, b, random);
    const PairEntry& entry = pair_entry(form_a, form_b);
    Candidates found;
    entry.routine(a, b, pose, kInfinity, found);
    const Real size = pair_size(a, b, pose), tol = (16 * kUnitRoundoff + entry.accuracy) * size;
    if (found.count == 0 && !entry.exact_apart) {  // only because they are apart, along some direction (GJK names one)
      QueryResult named;
      SupportFault fault;
      generic_distance(a, b, pose, QuerySettings(), nullptr, named, fault);
      assert_true(separation_along(a, b, pose, named.normal) > -tol);
      continue;
    }
    assert_true(within("number of points", form_a, form_b, i, found.count == 0, 0));
    const ContactPoint& p = *deepest(found);
    assert_true(within("length of normal", form_a, form_b, i, std::fabs(p.normal.norm() - 1), 8 * kEpsilon));

    // Its points are where it says, and beyond neither shape's support planes.
    for (int k = 0; k < found.count; ++k) {
      const ContactPoint& q = found.point[k];
      const Real along = q.normal.dot(pose.apply(q.on_b) - q.on_a);
      assert_true(within("separation of its points", form_a, form_b, i, std::fabs(along - q.separation),
                         16 * kUnitRoundoff * size));
      for (int d = 0; d < 20; ++d) {
        const Vec3 n = random.direction();
        assert_true(within("point of B outside", form_a, form_b, i, n.dot(q.on_b) - support_value(b, n), tol));
        assert_true(within("point of A outside", form_a, form_b, i, n.dot(q.on_a) - support_value(a, n), tol));
      }
    }
    if (!entry.exact_apart && p.separation > 0) continue;
    const Real own = separation_along(a, b, pose, p.normal);
    assert_true(within("own normal", form_a, form_b, i, std::fabs(own - p.separation), tol));
    if (form_a == Form::half_space) continue;  // there is one direction only
    const Real best = best_of_sweep(a, b, pose, p.normal, 200, random);
    assert_true(within("sweep", form_a, form_b, i, best - p.separation, tol));
  }
}

void check_all(Real scale, int poses) {
  std::uint64_t seed = 1;
  for (const auto& [a, b] : kRoutinePairs) check_pair(a, b, scale, poses, seed++);
}

}  // namespace

static void no_direction_beats_a_routine_at_unit_size(void**) { check_all(1, 1500); }
static void no_direction_beats_a_routine_at_a_tenth_of_a_millimetre(void**) { check_all(1e-4, 200); }
static void no_direction_beats_a_routine_at_ten_kilometres(void**) { check_all(1e4, 200); }

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(no_direction_beats_a_routine_at_unit_size),
      cmocka_unit_test(no_direction_beats_a_routine_at_a_tenth_of_a_millimetre),
      cmocka_unit_test(no_direction_beats_a_routine_at_ten_kilometres),
  };
  return cmocka_run_group_tests_name("oracle/pairs_vs_sweep", tests, nullptr, nullptr);
}
