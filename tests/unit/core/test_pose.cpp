// The bound on what a motion between two poses does to the points of the smaller body, against the points themselves.
#include <cstring>

#include "carom_test.h"
#include "core/pose.h"
#include "random_pairs.h"

using namespace carom;
using namespace carom::test;

static void no_point_of_the_smaller_body_moves_farther_than_the_bound(void**) {
  Random random(81);
  for (int i = 0; i < 2000; ++i) {
    const Quat q = random_rotation(random);
    const Vec3 p = random.in_cube(3);
    const Real step = std::pow(10.0, -random.uniform(0, 9));
    const Frame then(Pose{q, p}), now(Pose{normalized(exp_map(random.in_cube(step)) * q), p + random.in_cube(step)});
    const Real radius_a = random.uniform(0.1, 2), radius_b = random.uniform(0.1, 2);
    const Real bound = motion_bound(then, now, radius_a, radius_b);
    for (int k = 0; k < 20; ++k) {
      const Vec3 of_a = radius_a * random.direction(), of_b = radius_b * random.direction();
      const Real moved = radius_b <= radius_a ? (now.apply(of_b) - then.apply(of_b)).norm()
                                              : (now.apply_inverse(of_a) - then.apply_inverse(of_a)).norm();
      assert_true(moved <= bound + 64 * kUnitRoundoff);  // of places up to 10 m, each to some u
    }
  }
}

static void a_shift_and_a_turn_alone_attain_the_bound(void**) {
  const Frame here, shifted(Mat3::identity(), Vec3(3, 4, 0)), turned(Pose{exp_map(Vec3(0, 0, 0.1)), Vec3::zero()});
  assert_true(motion_bound(here, shifted, 1, 2) == 5);
  assert_true(motion_bound(here, here, 1, 2) == 0);  // what rests is kept, however little is allowed
  const Real moved = (turned.apply(Vec3(0.5, 0, 0)) - Vec3(0.5, 0, 0)).norm();
  assert_true(std::fabs(motion_bound(here, turned, 1, 0.5) - moved) <= 16 * kUnitRoundoff);
}

static void no_point_of_a_body_comes_farther_than_its_way(void**) {
  Random random(82);
  for (int i = 0; i < 2000; ++i) {
    const Quat q = random_rotation(random);
    const Vec3 p = random.in_cube(3);
    const Real step = std::pow(10.0, -random.uniform(0, 15)), radius = random.uniform(0.1, 2);
    const Frame then(Pose{q, p}), now(Pose{normalized(exp_map(random.in_cube(step)) * q), p + random.in_cube(step)});
    const Real way = way_bound(then, now, radius);
    Real most = 0;
    for (int k = 0; k < 20; ++k) {
      const Vec3 x = radius * random.direction();
      // Differences first, so that the motion is not lost in the rounding of places.
      most = std::max(most, ((now.r - then.r) * x + (now.p - then.p)).norm());
    }
    assert_true(most <= way);
    assert_true(way_bound(then, then, kInfinity) == 0);
  }
  const Frame here, shifted(Mat3::identity(), Vec3(3, 4, 0)), turned(Pose{exp_map(Vec3(0, 0, 0.1)), Vec3::zero()});
  assert_true(std::fabs(way_bound(here, shifted, kInfinity) - 5) <= 5 * 20 * kUnitRoundoff);
  assert_true(way_bound(here, turned, kInfinity) == kInfinity);
  const Real moved = (turned.apply(Vec3(0.5, 0, 0)) - Vec3(0.5, 0, 0)).norm();
  assert_true(std::fabs(way_bound(here, turned, 0.5) - moved) <= 40 * kUnitRoundoff);
}

static bool same_bits(const Quat& a, const Quat& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

static void what_has_been_scaled_once_stays_as_it_is(void**) {
  Random random(83);
  int moved = 0;
  for (int i = 0; i < 10'000'000; ++i) {
    // Of any length that a host may give, and of whole powers; some with parts that are next to nothing.
    const Real size = i % 3 == 0 ? 1 + random.uniform(-1e-6, 1e-6) : std::pow(Real(2), random.uniform(-30, 30));
    Quat q = size * random_rotation(random);
    if (i % 5 == 0) q.at[i % 4] *= 1e-9;
    const Quat scaled = normalized(q);
    assert_true(same_bits(oriented(scaled), scaled));
    assert_true(same_bits(oriented(oriented(q)), oriented(q)));
    moved += !same_bits(normalized(scaled), scaled);
  }
  assert_true(moved > 100'000);  // what it is there for: scaled again, some come out otherwise
}

static void what_is_off_by_more_is_scaled(void**) {
  Random random(84);
  for (int i = 0; i < 100'000; ++i) {
    const Quat q = random_rotation(random);
    const Real off = std::pow(Real(10), -random.uniform(6, 14)) * (i % 2 ? 1 : -1);
    const Quat given = (1 + off) * q, is = oriented(given);
    // The sum of squares errs by 3 u itself.
    assert_true(std::fabs(is.squared_norm() - 1) <= 15 * kUnitRoundoff);
    assert_true((is - q).squared_norm() <= 1e3 * kUnitRoundoff * kUnitRoundoff);
  }
  assert_true(oriented(Quat::zero()) == Quat::identity());
  assert_true(oriented(Quat(kInfinity, 0, 0, 0)) == Quat::identity());
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(no_point_of_the_smaller_body_moves_farther_than_the_bound),
      cmocka_unit_test(a_shift_and_a_turn_alone_attain_the_bound),
      cmocka_unit_test(no_point_of_a_body_comes_farther_than_its_way),
      cmocka_unit_test(what_has_been_scaled_once_stays_as_it_is),
      cmocka_unit_test(what_is_off_by_more_is_scaled),
  };
  return cmocka_run_group_tests_name("core/pose", tests, nullptr, nullptr);
}
