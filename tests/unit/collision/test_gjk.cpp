// GJK: closed forms apart, brackets, early out, warm start, scales, and support functions that misbehave.
#include <limits>

#include "carom_test.h"
#include "collision/narrow/query.h"
#include "collision/narrow/rounding.h"
#include "random_pairs.h"

using namespace carom;
using namespace carom::test;

namespace {

QueryResult ask(const Shape& a, const Shape& b, const Frame& b_in_a, const QuerySettings& settings = {},
                QueryMemory* memory = nullptr, SupportFault* fault = nullptr) {
  QueryResult result;
  SupportFault ignored;
  generic_distance(a, b, b_in_a, settings, memory, result, fault ? *fault : ignored);
  return result;
}

/// The answer is a bracket around the truth, narrow enough, and value and normal belong together.
void assert_is(const QueryResult& r, Real truth, Real width) {
  assert_int_equal(static_cast<int>(r.status), static_cast<int>(QueryStatus::exact_enough));
  assert_true(r.lower <= truth && truth <= r.upper);
  assert_true(r.upper - r.lower <= width);
  assert_true(r.lower <= r.separation && r.separation <= r.upper);
  assert_true(std::fabs(r.normal.norm() - 1) <= 4 * kEpsilon);
}

}  // namespace

static void spheres_are_exact_in_one_look(void**) {
  const Shape a = sphere(0.5), b = sphere(0.25);
  const QueryResult r = ask(a, b, at(2, 0, 0));
  // One look leaves nothing but the rounding of operands of 2 + 0.5 + 0.25 m, on both sides, and of the ends
  // themselves.
  assert_is(r, 1.25, 2 * kBracketRounding * kUnitRoundoff * 2.75 + 2 * kEpsilon);
  assert_true(r.separation == 1.25);
  assert_int_equal(r.support_calls, 1);
  assert_true(r.normal == Vec3(1, 0, 0));
  assert_true((r.point_a - Vec3(0.5, 0, 0)).norm() <= kEpsilon);
  assert_true((r.point_b - Vec3(-0.25, 0, 0)).norm() <= kEpsilon);
}

static void rounded_shapes_in_shallow_overlap_never_need_epa(void**) {
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    const ShapePair p = random_pair(random, i % 2 ? 2 : 8, i % 3 ? 8 : 2, -0.02);
    const QueryResult r = ask(p.a, p.b, p.b_in_a);
    assert_true(r.separation < 0);
    assert_int_equal(r.epa_iterations, 0);
  }
}

static void features_of_boxes_have_their_textbook_distance(void**) {
  const Shape a = box(Vec3(1, 2, 3)), b = box(Vec3(0.5, 0.5, 0.5));
  assert_is(ask(a, b, at(2, 0.3, 0.1)), 0.5, 2e-6);               // face and face
  assert_is(ask(a, b, at(2, 3, 0)), std::hypot(0.5, 0.5), 2e-6);  // edge and edge
  assert_is(ask(a, b, at(2, 3, 4)), std::sqrt(0.75), 2e-6);       // vertex and vertex
  const Real s = std::sqrt(0.5);
  const Mat3 turn(s, -s, 0, s, s, 0, 0, 0, 1);  // 45 degrees about z: an edge looks at the face
  assert_is(ask(a, b, Frame(turn, Vec3(2, 0, 0))), 1 - std::sqrt(0.5), 2e-6);
}

static void a_point_and_a_flat_box_are_shapes_too(void**) {
  const Shape point = box(Vec3::zero()), plate = box(Vec3(1, 0, 1)), line = box(Vec3(0, 1, 0));
  // A point has no size that a tolerance could be relative to: the plate's counts.
  assert_is(ask(point, plate, at(0.2, 0.5, 0.1)), 0.5, 1e-13);
  assert_is(ask(point, point, at(0, 3, 4)), 5, 1e-13);
  assert_is(ask(line, plate, at(0, 1.5, 0)), 0.5, 2e-6);
  const QueryResult same = ask(point, point, at(0, 0, 0));
  assert_true(same.separation == 0 && same.lower <= 0 && same.upper >= 0 && carom::finite(same.normal));
}

static void random_pairs_keep_their_promises(void**) {
  // What holds without a reference: points on the surfaces, as far apart as the upper bound says, along the normal the
  // lower.
  Random random(17);
  for (int i = 0; i < 600; ++i) {
    const ShapePair p =
        random_pair(random, i % kFamilyCount, (i / kFamilyCount) % kFamilyCount, random.uniform(1e-4, 1));
    const Real asked = 1e-6 * std::min(p.a.bounding_radius, p.b.bounding_radius);
    const QueryResult r = ask(p.a, p.b, p.b_in_a);
    assert_int_equal(static_cast<int>(r.status), static_cast<int>(QueryStatus::exact_enough));
    assert_true(r.upper - r.lower <= asked);
    const Vec3 between = p.b_in_a.apply(r.point_b) - r.point_a;
    assert_true(std::fabs(r.normal.dot(between) - r.separation) <= asked);
    // Off the normal by what the gap allows: |between|^2 <= (separation + gap)^2 up to the rounding of the points.
    assert_true(between.norm() <= r.upper + std::sqrt(2 * (p.a.core_radius + p.b.core_radius) * asked) + asked);
  }
}

static void six_more_digits_cost_curved_shapes_few_steps(void**) {
  // A secant's error falls with the power 1.6 or so, and the gap is its square: digits times 1.6 a step, so that twice
  // the digits take log 2 / log 1.6 = 1.5 steps and the odd one that fails. Plain GJK takes 2.7 steps for each digit, 16.
  Random random(29);
  int coarse = 0, fine = 0;
  constexpr int kPairs = 100;
  for (int i = 0; i < kPairs; ++i) {
    const ShapePair p = random_pair(random, 7, i % 2 ? 7 : 0, random.uniform(1e-2, 1));
    QuerySettings settings;
    coarse += ask(p.a, p.b, p.b_in_a, settings).gjk_iterations;
    settings.tolerance = 1e-12;
    const QueryResult r = ask(p.a, p.b, p.b_in_a, settings);
    assert_int_equal(static_cast<int>(r.status), static_cast<int>(QueryStatus::exact_enough));
    fine += r.gjk_iterations;
  }
  assert_true(fine - coarse <= 3 * kPairs);
}

static void farther_than_asked_is_cheaper_to_know(void**) {
  Random random(23);
  int full = 0, early = 0;
  for (int i = 0; i < 200; ++i) {
    const ShapePair p = random_pair(random, 3, 7, 1);
    QuerySettings settings;
    full += ask(p.a, p.b, p.b_in_a, settings).support_calls;
    settings.max_distance = 0.1;
    const QueryResult r = ask(p.a, p.b, p.b_in_a, settings);
    assert_true(r.farther && r.lower > 0.1 && r.lower <= 1 + 1e-4 && carom::finite(r.upper) && r.upper >= 1 - 1e-4);
    early += r.support_calls;
    settings.max_distance = 1.1;
    assert_false(ask(p.a, p.b, p.b_in_a, settings).farther);
  }
  assert_true(2 * early < full);
}

static void the_last_direction_starts_the_next_query_near_its_end(void**) {
  Random random(29);
  int cold = 0, warm = 0;
  for (int i = 0; i < 100; ++i) {
    ShapePair p = random_pair(random, 1, 3, 0.05);
    QueryMemory memory;
    for (int frame = 0; frame < 10; ++frame) {
      p.b_in_a.p += 1e-4 * random.direction();
      const QueryResult fresh = ask(p.a, p.b, p.b_in_a), kept = ask(p.a, p.b, p.b_in_a, {}, &memory);
      // Two brackets of one number.
      assert_true(fresh.lower <= kept.upper && kept.lower <= fresh.upper);
      if (frame == 0) continue;
      cold += fresh.gjk_iterations;
      warm += kept.gjk_iterations;
    }
  }
  assert_true(warm < cold);
  // A deep answer leaves no direction behind.
  QueryMemory memory;
  memory.direction = Vec3(1, 0, 0);
  const Shape a = box(Vec3(1, 1, 1));
  ask(a, a, at(0.5, 0.1, 0), {}, &memory);
  assert_true(memory.direction == Vec3::zero());
}

static void a_power_of_two_in_size_changes_no_bit(void**) {
  Random random(31);
  for (int i = 0; i < 100; ++i) {
    const ShapePair p = random_pair(random, i % 4, (i + 1) % 4, i % 2 ? 0.1 : -0.1);
    const QueryResult plain = ask(p.a, p.b, p.b_in_a);
    for (const Real scale : {0x1p-40, 0x1p40, 0x1p-300, 0x1p300}) {
      const auto scaled = [&](const Shape& s) {
        Shape t = s;
        for (double& x : t.params) x *= scale;
        t.core_radius *= scale;
        t.bounding_radius *= scale;
        t.bounds.lo *= scale;
        t.bounds.hi *= scale;
        t.radius *= scale;
        t.half_height *= scale;
        t.half *= scale;
        if (t.form == Form::polytope) {
          t.vertices = t.params;
          t.farthest.build(t.vertices);
        }
        return t;
      };
      const QueryResult r = ask(scaled(p.a), scaled(p.b), Frame(p.b_in_a.r, scale * p.b_in_a.p));
      assert_true(r.separation == scale * plain.separation);
      assert_true(r.lower == scale * plain.lower && r.upper == scale * plain.upper);
      assert_true(r.normal == plain.normal);
    }
  }
}

static void a_cap_keeps_the_bracket_true(void**) {
  Random random(37);
  for (int i = 0; i < 100; ++i) {
    const ShapePair p = random_pair(random, 7, 5, 0.3);
    QuerySettings settings;
    settings.tolerance = 1e-10;
    const QueryResult full = ask(p.a, p.b, p.b_in_a, settings);
    settings.gjk_cap = 4;
    const QueryResult capped = ask(p.a, p.b, p.b_in_a, settings);
    assert_true(capped.gjk_iterations <= 4);
    assert_true(capped.lower <= full.upper && full.lower <= capped.upper);
    if (capped.upper - capped.lower > 1e-10 * std::min(p.a.bounding_radius, p.b.bounding_radius))
      assert_int_equal(static_cast<int>(capped.status), static_cast<int>(QueryStatus::capped));
  }
}

static void the_hybrid_is_its_margin_nearer(void**) {
  Random random(41);
  for (int i = 0; i < 200; ++i) {
    const ShapePair p = random_pair(random, i % kFamilyCount, (i / 2) % kFamilyCount, random.uniform(-0.01, 0.2));
    QuerySettings settings;
    const QueryResult plain = ask(p.a, p.b, p.b_in_a, settings);
    settings.method = Method::hybrid;
    settings.margin = 0.01;
    const QueryResult shell = ask(p.a, p.b, p.b_in_a, settings);
    assert_true(shell.lower <= plain.upper - 0.02 + 1e-15 && plain.lower - 0.02 <= shell.upper + 1e-15);
    if (plain.lower > 0) assert_int_equal(shell.epa_iterations, 0);
  }
}

namespace {

std::int32_t refuses(void*, const double*, std::uint64_t, const double*, double*) { return 7; }
std::int32_t says_nan(void*, const double*, std::uint64_t, const double*, double* out) {
  out[0] = out[1] = out[2] = std::numeric_limits<double>::quiet_NaN();
  return 0;
}
std::int32_t flies_away(void*, const double*, std::uint64_t, const double* d, double* out) {
  for (int i = 0; i < 3; ++i) out[i] = 1e6 * d[i];
  return 0;
}
/// Takes the axes for one another: corners of the right box for the wrong directions.
std::int32_t mixes_axes(void*, const double* p, std::uint64_t count, const double* d, double* out) {
  const double turned[3] = {d[1], d[2], d[0]};
  return box_support(nullptr, p, count, turned, out);
}

}  // namespace

static void a_bad_support_function_is_caught_with_its_evidence(void**) {
  const struct {
    SupportFn support;
    SupportFault::Kind kind;
  } invalid_plugins[] = {
      {refuses, SupportFault::returned}, {says_nan, SupportFault::not_finite}, {flies_away, SupportFault::outside}};
  const Shape good = box(Vec3(1, 1, 1));
  for (const auto& invalid_plugin : invalid_plugins) {
    Shape bad = box(Vec3(0.5, 0.6, 0.7));
    bad.support = invalid_plugin.support;
    bad.form = Form::none;  // else the engine speaks for it
    for (const bool swapped : {false, true}) {
      SupportFault fault;
      const QueryResult r = ask(swapped ? bad : good, swapped ? good : bad, at(2.5, 0.4, 0.3), {}, nullptr, &fault);
      assert_int_equal(static_cast<int>(r.status), static_cast<int>(QueryStatus::fault));
      assert_int_equal(fault.kind, invalid_plugin.kind);
      assert_ptr_equal(fault.shape, &bad);
      assert_true(Vec3(fault.dir[0], fault.dir[1], fault.dir[2]).norm() > 0.5);
      assert_true(carom::finite(r.separation) && carom::finite(r.normal) && carom::finite(r.point_a) &&
                  carom::finite(r.point_b));
    }
  }
}

static void a_worse_point_than_one_seen_is_caught(void**) {
  // An invalid plugin may be consistent along the few directions of one query; over a hundred poses it is not, and the valid
  // shape is never the one blamed.
  Random random(43);
  const Shape good = box(Vec3(1, 1, 1));
  Shape bad = box(Vec3(0.5, 0.6, 0.7));
  bad.support = mixes_axes;
  bad.form = Form::none;
  int caught = 0;
  for (int i = 0; i < 100; ++i) {
    SupportFault fault;
    const QueryResult r =
        ask(good, bad, Frame(random_rotation(random).matrix(), random.in_cube(2)), {}, nullptr, &fault);
    assert_true(carom::finite(r.separation) && carom::finite(r.normal));
    if (r.status != QueryStatus::fault) continue;
    ++caught;
    assert_int_equal(fault.kind, SupportFault::not_support);
    assert_ptr_equal(fault.shape, &bad);
  }
  assert_true(caught > 10);
}

static void a_pose_that_is_no_pose_gives_no_nonsense(void**) {
  const Shape a = box(Vec3(1, 1, 1));
  for (const Real x : {std::numeric_limits<Real>::quiet_NaN(), kInfinity}) {
    const QueryResult r = ask(a, a, at(x, 0, 0));
    assert_int_equal(static_cast<int>(r.status), static_cast<int>(QueryStatus::rounding));
    assert_true(carom::finite(r.separation) && carom::finite(r.normal) && r.lower == -kInfinity &&
                r.upper == kInfinity);
  }
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(spheres_are_exact_in_one_look),
      cmocka_unit_test(rounded_shapes_in_shallow_overlap_never_need_epa),
      cmocka_unit_test(features_of_boxes_have_their_textbook_distance),
      cmocka_unit_test(a_point_and_a_flat_box_are_shapes_too),
      cmocka_unit_test(random_pairs_keep_their_promises),
      cmocka_unit_test(six_more_digits_cost_curved_shapes_few_steps),
      cmocka_unit_test(farther_than_asked_is_cheaper_to_know),
      cmocka_unit_test(the_last_direction_starts_the_next_query_near_its_end),
      cmocka_unit_test(a_power_of_two_in_size_changes_no_bit),
      cmocka_unit_test(a_cap_keeps_the_bracket_true),
      cmocka_unit_test(the_hybrid_is_its_margin_nearer),
      cmocka_unit_test(a_bad_support_function_is_caught_with_its_evidence),
      cmocka_unit_test(a_worse_point_than_one_seen_is_caught),
      cmocka_unit_test(a_pose_that_is_no_pose_gives_no_nonsense),
  };
  return cmocka_run_group_tests_name("collision/gjk", tests, nullptr, nullptr);
}
