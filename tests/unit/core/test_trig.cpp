// Own sine and cosine against long double, with the argument reduction's loss accounted for.
#include <cmath>
#include <initializer_list>

#include "carom_test.h"
#include "core/pose.h"

using namespace carom;

static void sin_cos_is_right_to_an_ulp(void**) {
  Real worst = 0;
  for (int i = -200000; i <= 200000; ++i) {
    const Real x = i * 0.0497318;
    const SinCos got = sin_cos(x);
    worst = std::max(worst, std::fabs(got.sin - static_cast<Real>(std::sin(static_cast<long double>(x)))));
    worst = std::max(worst, std::fabs(got.cos - static_cast<Real>(std::cos(static_cast<long double>(x)))));
  }
  // Results are below 1: half an ulp for the rounding of the value, one for the last operation of the kernel.
  assert_true(worst <= 1.5 * kEpsilon / 2);
}

static void a_huge_angle_stays_finite_and_on_the_circle(void**) {
  for (Real x : {1e9, 1e12, 1e300, -1e300}) {
    const SinCos got = sin_cos(x);
    assert_true(std::fabs(got.sin * got.sin + got.cos * got.cos - 1) < 8 * kEpsilon);
  }
}

static void the_exponential_map_joins_its_two_branches(void**) {
  for (Real a : {0.0, 1e-300, 1e-8, 0.9999999e-3, 1e-3, 1.0000001e-3, 1.0, 3.0, 100.0}) {
    const Quat q = exp_map(Vec3(0, a, 0));
    assert_true(std::fabs(q.w() - std::cos(a / 2)) <= 2 * kEpsilon);
    assert_true(std::fabs(q.y() - std::sin(a / 2)) <= 2 * kEpsilon);
    assert_true(std::fabs(q.squared_norm() - 1) <= 4 * kEpsilon);
  }
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(sin_cos_is_right_to_an_ulp),
      cmocka_unit_test(a_huge_angle_stays_finite_and_on_the_circle),
      cmocka_unit_test(the_exponential_map_joins_its_two_branches),
  };
  return cmocka_run_group_tests_name("core/trig", tests, nullptr, nullptr);
}
