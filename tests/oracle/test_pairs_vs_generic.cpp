// Every pair routine against the generic path (GJK, EPA), which knows the shapes by their support functions alone.
#include <algorithm>
#include <cstdio>

#include "carom_test.h"
#include "collision/narrow/query.h"
#include "pair_cases.h"

using namespace carom;
using namespace carom::test;

namespace {

bool within(const char* what, Form a, Form b, int pose, Real error, Real tol) {
  if (error <= tol) return true;
  std::printf("forms %u-%u pose %d: %s off by %g, tolerance %g\n", static_cast<unsigned>(a), static_cast<unsigned>(b),
              pose, what, error, tol);
  return false;
}

/// Both paths answer with a bracket; two brackets of the same number overlap. The routine's is as narrow as its entry
/// says. @return what the routine answered
QueryResult check_pose(const Shape& a, const Shape& b, const Frame& pose, int i, Method method) {
  QuerySettings specific, generic;
  generic.routines = false;
  generic.method = method;
  generic.tolerance = specific.tolerance = 1e-9;
  generic.gjk_cap = generic.epa_cap = 1000;
  QueryResult fast, slow;
  SupportFault fault;
  distance(a, b, pose, specific, nullptr, fast, fault);
  distance(a, b, pose, generic, nullptr, slow, fault);
  assert_int_equal(fault.kind, SupportFault::none);
  // The generic path's own points carry its separation too, whichever way it was found.
  const Real carried = slow.normal.dot(pose.apply(slow.point_b) - slow.point_a);
  assert_true(
      within("generic points", a.form, b.form, i, std::fabs(carried - slow.separation), slow.upper - slow.lower));
  // The hybrid's shells bring everything nearer by twice their thickness; a half-space wears none.
  const Real shells = method == Method::hybrid && a.form != Form::half_space ? 2 * generic.margin : 0;
  slow.lower += shells, slow.upper += shells;
  assert_true(within("bracket of the routine", a.form, b.form, i, fast.lower - slow.upper, 0));
  assert_true(within("bracket of the generic path", a.form, b.form, i, slow.lower - fast.upper, 0));
  const Real size = pair_size(a, b, pose), width = fast.upper - fast.lower, rounding = 16 * kUnitRoundoff * size;
  assert_true(within("width", a.form, b.form, i, width, 2 * (4e-8 * size + rounding)));
  // The routine's points carry its separation along its normal.
  const Real along = fast.normal.dot(pose.apply(fast.point_b) - fast.point_a);
  assert_true(within("points", a.form, b.form, i, std::fabs(along - fast.separation), width));

  // Roles exchanged: the same distance, and a normal that attains it.
  QueryResult back;
  distance(b, a, Frame(pose.r.transpose(), -(pose.r.transpose() * pose.p)), specific, nullptr, back, fault);
  assert_true(within("exchanged", a.form, b.form, i, back.lower - fast.upper, 0));
  assert_true(within("exchanged", a.form, b.form, i, fast.lower - back.upper, 0));
  const Vec3 turned = -(pose.r * back.normal);
  const Real own = separation_along(a, b, pose, a.form == Form::half_space ? a.normal : Vec3(turned / turned.norm()));
  assert_true(within("exchanged normal", a.form, b.form, i, fast.lower - own, back.upper - back.lower + rounding));
  return fast;
}

/// Random poses, and from each of them one that touches, or misses touch by little.
void check_pair(Form form_a, Form form_b, int poses, std::uint64_t seed, Method method) {
  static constexpr Real kMiss[] = {0, 1e-15, -1e-15, 1e-12, -1e-12, 1e-9, -1e-9, 1e-8, -1e-8, 1e-7, -1e-7, 1e-5, -1e-5};
  Random random(seed);
  for (int i = 0; i < poses; ++i) {
    const Shape a = random_shape(form_a, 1, random), b = random_shape(form_b, 1, random);
    Frame pose = random_pose(a, b, random);
    const QueryResult at = check_pose(a, b, pose, i, method);
    pose.p -= (at.separation + kMiss[i % 13]) * at.normal;
    check_pose(a, b, pose, i, method);
  }
}

void check_all(int poses, Method method) {
  std::uint64_t seed = 100;
  for (const auto& [a, b] : kRoutinePairs) check_pair(a, b, poses, seed++, method);
}

}  // namespace

static void routines_agree_with_gjk_and_epa(void**) { check_all(4000, Method::gjk_epa); }
static void routines_agree_with_the_hybrid(void**) { check_all(1000, Method::hybrid); }

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(routines_agree_with_gjk_and_epa),
      cmocka_unit_test(routines_agree_with_the_hybrid),
  };
  return cmocka_run_group_tests_name("oracle/pairs_vs_generic", tests, nullptr, nullptr);
}
