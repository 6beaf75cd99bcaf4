// What must hold between answers about related pairs: moved together, exchanged, scaled, shrunk, pushed. No reference
// is needed, and every tolerance is a bracket's own width or the rounding of the poses that were made.
#include <cstdio>

#include "carom_test.h"
#include "exact_pairs.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr Real kU = kUnitRoundoff;

/// A pair of any kinds, plain (every second) or extreme, whose bodies are apart, near touch or nested.
ShapePair any_pair(Random& random, int i) {
  const auto shape = [&](int kind) {
    // 4 of random_shape's families is the hull of 1000 points: the one of 32, only slower.
    return i % 2 ? random_shape(random, kind == 4 ? 3 : kind) : extreme_shape(random, kind, pick(random, kSizes));
  };
  Shape a = shape((i / 2) % 9), b = shape((i / 18) % 9);
  Frame f;
  if (random.uniform(0, 4) > 1) f.r = random_rotation(random).matrix();
  const Real reach = a.bounding_radius + b.bounding_radius;
  f.p = reach * pick(random, {0.0, 1e-9, 1e-3, 0.3, 1.0, 2.0}) * random.direction();
  if (random.uniform(0, 3) < 1) {  // farthest points opposite each other, or a little past each other
    const Vec3 n = random.direction(), back = -f.rotate_inverse(n);
    const Real gap = pick(random, kGaps) * reach;
    f.p = support_point(a, n) + gap * n - f.r * support_point(b, Vec3(back.normalized()));
  }
  return {std::move(a), std::move(b), f};
}

QuerySettings any_settings(Random& random) {
  QuerySettings s;
  s.simplex = static_cast<Simplex>(random.uniform(0, 3));
  s.tolerance = pick(random, {1e-3, 1e-6, 1e-9});
  s.routines = random.uniform(0, 2) < 1;
  return s;
}

QueryResult ask(const Shape& a, const Shape& b, const Frame& f, const QuerySettings& s) {
  QueryResult r;
  SupportFault fault;
  distance(a, b, f, s, nullptr, r, fault);
  assert_int_equal(fault.kind, SupportFault::none);
  return r;
}

Real size_of(const ShapePair& p) { return p.b_in_a.p.abs().sum() + p.a.bounding_radius + p.b.bounding_radius; }

/// Two brackets of one number meet.
void assert_same(const QueryResult& x, const QueryResult& y, Real slack) {
  assert_true(x.lower <= y.upper + slack && y.lower <= x.upper + slack);
}

/// The same shape, every length times k.
Shape scaled(const Shape& s, Real k) {
  const double* p = s.params.data();
  switch (s.form) {
    case Form::sphere:
      return sphere(k * s.radius);
    case Form::capsule:
      return capsule(k * s.radius, k * s.half_height);
    case Form::box:
      return box(k * s.half);
    case Form::cylinder:
      return cylinder(k * s.radius, k * s.half_height);
    case Form::cone:
      return cone(k * s.radius, k * s.half_height);
    case Form::ellipsoid:
      return ellipsoid(k * s.half);
    case Form::polytope: {
      std::vector<Vec3> points;
      for (std::size_t i = 0; i < s.params.size(); i += 3) points.push_back(k * Vec3(p[i], p[i + 1], p[i + 2]));
      return hull(points);
    }
    default:
      return rounded_box(k * Vec3(p[0], p[1], p[2]), k * s.core_radius);
  }
}

/// A subset: thinner, shorter, or with fewer points.
Shape shrunk(const Shape& s, Random& random) {
  const double* p = s.params.data();
  const auto less = [&](Real x) { return x * random.uniform(0.5, 1); };
  switch (s.form) {
    case Form::sphere:
      return sphere(less(s.radius));
    case Form::capsule:
      return capsule(less(s.radius), less(s.half_height));
    case Form::box:
      return box(Vec3(less(s.half.x()), less(s.half.y()), less(s.half.z())));
    case Form::cylinder:
      return cylinder(less(s.radius), less(s.half_height));
    case Form::cone:  // lower would move the base
      return cone(less(s.radius), s.half_height);
    case Form::ellipsoid:
      return ellipsoid(Vec3(less(s.half.x()), less(s.half.y()), less(s.half.z())));
    case Form::polytope: {
      std::vector<Vec3> points(1, Vec3(p[0], p[1], p[2]));
      for (std::size_t i = 3; i < s.params.size(); i += 3)
        if (random.uniform(0, 3) > 1) points.emplace_back(p[i], p[i + 1], p[i + 2]);
      return hull(points);
    }
    default:
      return rounded_box(Vec3(less(p[0]), less(p[1]), less(p[2])), less(s.core_radius));
  }
}

constexpr int kPairs = 3000;

}  // namespace

static void a_pair_moved_as_one_is_the_same_pair(void**) {
  Random random(301);
  for (int i = 0; i < kPairs; ++i) {
    const ShapePair p = any_pair(random, i);
    const QuerySettings s = any_settings(random);
    const QueryResult here = ask(p.a, p.b, p.b_in_a, s);
    const Real far = size_of(p) * pick(random, {0.0, 1.0, 1e3, 1e6});
    const Frame a(random_rotation(random).matrix(), far * random.direction());
    const Frame b = a * p.b_in_a;
    const QueryResult there = ask(p.a, p.b, relative(a, b), s);
    // The pose is made of two rounded ones, the position of B good to the spacing of numbers out there.
    assert_same(here, there, kPoseRounding * kU * size_of(p) + 8 * kU * far);
  }
}

static void a_pair_moved_by_round_numbers_gives_the_same_bits(void**) {
  Random random(302);
  for (int i = 0; i < kPairs; ++i) {
    ShapePair p = any_pair(random, i);
    const Real grid = std::exp2(std::ceil(std::log2(size_of(p))) - 20);
    for (int k = 0; k < 3; ++k)
      p.b_in_a.p[k] = grid * std::round(p.b_in_a.p[k] / grid) + 0.0;  // no -0, which moving loses
    const Vec3 t = grid * Vec3{std::round(random.uniform(-1e6, 1e6)), std::round(random.uniform(-1e6, 1e6)), 1 << 20};
    const QuerySettings s = any_settings(random);
    const Frame a, b(p.b_in_a.r, p.b_in_a.p), a_moved(a.r, t), b_moved(b.r, b.p + t);
    const QueryResult here = ask(p.a, p.b, relative(a, b), s), there = ask(p.a, p.b, relative(a_moved, b_moved), s);
    assert_true(here.separation == there.separation && here.lower == there.lower && here.upper == there.upper);
    assert_true(here.normal == there.normal && here.point_a == there.point_a && here.point_b == there.point_b);
  }
}

static void exchanging_the_shapes_turns_the_normal_around(void**) {
  Random random(303);
  for (int i = 0; i < kPairs; ++i) {
    const ShapePair p = any_pair(random, i);
    const QuerySettings s = any_settings(random);
    const Frame back(p.b_in_a.r.transpose(), -(p.b_in_a.r.transpose() * p.b_in_a.p));
    const QueryResult straight = ask(p.a, p.b, p.b_in_a, s), swapped = ask(p.b, p.a, back, s);
    // The transpose is the inverse but for 12 u, the offset rounds by another 3.
    const Real slack = 32 * kU * size_of(p);
    assert_same(straight, swapped, slack);
    // Where several directions are equally good the two may differ: but each proves what the other claims.
    const Vec3 n = -(p.b_in_a.r * swapped.normal);
    const Real proved = static_cast<Real>(exact_bound(p.a, p.b, p.b_in_a, n));
    assert_true(proved >= swapped.lower - slack - kBracketRounding * kU * size_of(p));
    assert_true(proved <= straight.upper + slack);
  }
}

static void lengths_times_a_power_of_two_change_no_bit(void**) {
  Random random(304);
  for (int i = 0; i < kPairs; ++i) {
    const ShapePair p = any_pair(random, i);
    const QuerySettings s = any_settings(random);
    const Real k = std::exp2(std::floor(random.uniform(-30, 31)));
    const QueryResult r = ask(p.a, p.b, p.b_in_a, s);
    const QueryResult big = ask(scaled(p.a, k), scaled(p.b, k), Frame(p.b_in_a.r, k * p.b_in_a.p), s);
    assert_true(big.separation == k * r.separation && big.lower == k * r.lower && big.upper == k * r.upper);
    assert_true(big.normal == r.normal && big.point_a == k * r.point_a && big.point_b == k * r.point_b);
    assert_true(big.status == r.status && big.support_calls == r.support_calls);
  }
}

static void lengths_times_any_factor_scale_the_bracket(void**) {
  Random random(305);
  for (int i = 0; i < kPairs; ++i) {
    const ShapePair p = any_pair(random, i);
    const QuerySettings s = any_settings(random);
    const Real k = std::pow(10.0, random.uniform(-6, 6));
    QueryResult r = ask(p.a, p.b, p.b_in_a, s);
    const QueryResult big = ask(scaled(p.a, k), scaled(p.b, k), Frame(p.b_in_a.r, k * p.b_in_a.p), s);
    r.lower *= k, r.upper *= k;
    // Every length of the scaled pair is rounded once.
    assert_same(r, big, 4 * kU * k * size_of(p));
  }
}

static void a_smaller_body_is_never_deeper_in(void**) {
  Random random(306);
  for (int i = 0; i < kPairs; ++i) {
    const ShapePair p = any_pair(random, i);
    const QuerySettings s = any_settings(random);
    const QueryResult whole = ask(p.a, p.b, p.b_in_a, s);
    assert_true(ask(shrunk(p.a, random), p.b, p.b_in_a, s).upper >= whole.lower);
    assert_true(ask(p.a, shrunk(p.b, random), p.b_in_a, s).upper >= whole.lower);
  }
}

static void a_push_changes_the_separation_by_no_more_than_itself(void**) {
  Random random(307);
  for (int i = 0; i < kPairs; ++i) {
    const ShapePair p = any_pair(random, i);
    const QuerySettings s = any_settings(random);
    const Vec3 t = size_of(p) * pick(random, {1e-12, 1e-6, 1e-2, 1.0}) * random.direction();
    const QueryResult before = ask(p.a, p.b, p.b_in_a, s);
    const QueryResult after = ask(p.a, p.b, Frame(p.b_in_a.r, p.b_in_a.p + t), s);
    // The new position is rounded once per component, the length of the push thrice.
    assert_same(before, after, t.norm() * (1 + 4 * kU) + 2 * kU * size_of(p));
  }
}

static void asking_for_more_never_gets_less(void**) {
  Random random(308);
  for (int i = 0; i < kPairs; ++i) {
    const ShapePair p = any_pair(random, i);
    QuerySettings s = any_settings(random);
    s.routines = false;
    const Real least = size_of_pair(p.a, p.b, p.b_in_a);
    QueryResult before;
    Real width = kInfinity;
    for (const Real tolerance : {1e-1, 1e-3, 1e-6, 1e-9, 1e-12, 1e-15}) {
      s.tolerance = tolerance;
      const QueryResult r = ask(p.a, p.b, p.b_in_a, s);
      if (width < kInfinity) assert_same(before, r, 0);
      // As wide as before at most; a query that got farther may end at another corner of what rounding allows.
      assert_true(r.upper - r.lower <= std::max(width, tolerance * least) + 4 * kBracketRounding * kU * size_of(p));
      width = r.upper - r.lower;
      before = r;
    }
  }
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(a_pair_moved_as_one_is_the_same_pair),
      cmocka_unit_test(a_pair_moved_by_round_numbers_gives_the_same_bits),
      cmocka_unit_test(exchanging_the_shapes_turns_the_normal_around),
      cmocka_unit_test(lengths_times_a_power_of_two_change_no_bit),
      cmocka_unit_test(lengths_times_any_factor_scale_the_bracket),
      cmocka_unit_test(a_smaller_body_is_never_deeper_in),
      cmocka_unit_test(a_push_changes_the_separation_by_no_more_than_itself),
      cmocka_unit_test(asking_for_more_never_gets_less),
  };
  return cmocka_run_group_tests_name("oracle/pair_properties", tests, nullptr, nullptr);
}
