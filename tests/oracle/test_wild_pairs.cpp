// Shapes that nobody would model with: sizes from 1e-6 to 1e6 m, aspect ratios to 1e6, flat, repeated and lattice
// points, coplanar, concentric, or a rounding away from touching. No reference: what must hold is that no answer
// contradicts another, or a direction.
#include <cstdio>

#include "carom_test.h"
#include "collision/narrow/rounding.h"
#include "random_pairs.h"

using namespace carom;
using namespace carom::test;

namespace {

Real any_order(Random& random, Real lo, Real hi) { return std::pow(10.0, random.uniform(lo, hi)); }

int pick(Random& random, int n) { return static_cast<int>(random.uniform(0, n)); }

Shape wild_shape(Random& random, Real size) {
  const auto length = [&] { return size * any_order(random, -6, 0); };
  const Real x = length(), y = length(), z = length();
  const int kind = pick(random, kFormCount + 2);
  if (kind < kFormCount) return shape_of(kForms[kind], Vec3(x, y, z));
  switch (kind) {
    case kFormCount: {  // a cloud, often flat, with points twice
      Vec3 half(x, y, z);
      if (pick(random, 3) == 0) half[pick(random, 3)] = 0;
      if (pick(random, 5) == 0) half[pick(random, 3)] = 0;
      std::vector<Vec3> points(1, random.in_cube(1).times(half));
      for (int i = pick(random, 12); i > 0; --i)
        points.push_back(pick(random, 5) == 0 ? points[0] : Vec3(random.in_cube(1).times(half)));
      return hull(points);
    }
    default: {  // points of a lattice: exactly coplanar, collinear and equal ones
      std::vector<Vec3> points;
      for (int i = 0; i < 10; ++i)
        points.push_back(0.25 * size * Vec3(pick(random, 5) - 2, pick(random, 5) - 2, pick(random, 5) - 2));
      return hull(points);
    }
  }
}

ShapePair wild_pair(Random& random) {
  const Real size = any_order(random, -6, 6);
  Shape a = wild_shape(random, size), b = wild_shape(random, size * any_order(random, -3, 0));
  Frame b_in_a;
  if (pick(random, 5) > 1) b_in_a.r = random_rotation(random).matrix();
  if (pick(random, 5) > 0) b_in_a.p = random.in_cube(1) * size * any_order(random, -8, 0);
  if (pick(random, 3) == 0) b_in_a.p[pick(random, 3)] = 0;
  if (pick(random, 3) == 0) {
    QueryResult r;
    SupportFault fault;
    generic_distance(a, b, b_in_a, QuerySettings(), nullptr, r, fault);
    const Real gap = (pick(random, 2) ? 1 : -1) * size * any_order(random, -16, -4);
    b_in_a.p += (gap - r.separation) * r.normal;
  }
  return {std::move(a), std::move(b), b_in_a};
}

}  // namespace

static void no_answer_contradicts_another_or_a_direction(void**) {
  Random random(7);
  constexpr int kPairs = 5000;
  int wide = 0;
  for (int i = 0; i < kPairs; ++i) {
    const ShapePair p = wild_pair(random);
    const Real least = size_of_pair(p.a, p.b, p.b_in_a);
    const Real reach = p.b_in_a.p.norm() + p.a.bounding_radius + p.b.bounding_radius;
    const Frame a_in_b(p.b_in_a.r.transpose(), -(p.b_in_a.r.transpose() * p.b_in_a.p));
    QueryResult r[4];
    for (int k = 0; k < 4; ++k) {
      QuerySettings settings;
      settings.simplex = static_cast<Simplex>(k % 3);
      SupportFault fault;
      if (k < 3)
        generic_distance(p.a, p.b, p.b_in_a, settings, nullptr, r[k], fault);
      else
        generic_distance(p.b, p.a, a_in_b, settings, nullptr, r[k], fault);
      assert_int_equal(fault.kind, SupportFault::none);
      assert_true(carom::finite(r[k].normal) && carom::finite(r[k].point_a) && carom::finite(r[k].point_b));
      assert_true(r[k].lower <= r[k].separation && r[k].separation <= r[k].upper);
      assert_true(r[k].gjk_iterations <= 2 * settings.gjk_cap && r[k].epa_iterations <= settings.epa_cap);
      // Within what was asked, or the status says that it is not.
      const bool narrow = r[k].upper - r[k].lower <= settings.tolerance * least;
      assert_true(narrow == (r[k].status == QueryStatus::exact_enough));
      wide += !narrow && r[k].status == QueryStatus::rounding &&
              r[k].upper - r[k].lower > 8 * kBracketRounding * kUnitRoundoff * reach;
      // Swapping rounds the pose: 4 eps of its lengths.
      if (k > 0)
        assert_true(r[0].lower <= r[k].upper + 4 * kEpsilon * reach && r[k].lower <= r[0].upper + 4 * kEpsilon * reach);
    }
    for (int k = 0; k < 40; ++k) {
      const Vec3 n = random.direction();
      const Vec3 b = p.b_in_a.apply(support_point(p.b, p.b_in_a.rotate_inverse(-n)));
      assert_true(n.dot(b - support_point(p.a, n)) <= r[k % 3].upper);
    }
  }
  // Not a promise but a watch: queries that rounding stops short of both the tolerance and the rounding term were 1 in
  // 5,000.
  assert_true(wide <= kPairs * 4 / 1000);
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(no_answer_contradicts_another_or_a_direction),
  };
  return cmocka_run_group_tests_name("oracle/wild_pairs", tests, nullptr, nullptr);
}
