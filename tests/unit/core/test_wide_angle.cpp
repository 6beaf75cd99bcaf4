// Angles from sides against long double, and lanes against single numbers.
#include <algorithm>
#include <cmath>

#include "carom_test.h"
#include "core/vec.h"
#include "core/wide_angle.h"

using namespace carom;

static void angles_are_right_to_a_few_ulps(void**) {
  Real worst = 0;
  for (int i = -3000; i <= 3000; ++i)
    for (const Real r : {1e-120, 0.37, 1.0, 5e3, 1e120}) {
      const Real a = i * 1.0471e-3, x = r * std::cos(a), y = r * std::sin(a);
      const auto truth = static_cast<Real>(std::atan2(static_cast<long double>(y), static_cast<long double>(x)));
      worst = std::max(worst, std::fabs(angle_of<double>(y, x) - truth));
    }
  assert_true(worst < 1e-15);
}

static void ends_and_corners(void**) {
  assert_true(angle_of<double>(0, 0) == 0 && angle_of<double>(0, 1) == 0 && angle_of<double>(0, 1e-9) == 0);
  assert_true(angle_of<double>(0, -1) == 3.14159265358979323846);
  assert_true(std::fabs(angle_of<double>(1, 0) - 3.14159265358979323846 / 2) < 1e-15);
  assert_true(std::fabs(angle_of<double>(-2, 0) + 3.14159265358979323846 / 2) < 1e-15);
}

static void lanes_have_the_bits_of_single_numbers(void**) {
  for (int i = 0; i < 500; ++i) {
    const Lanes y = {0.01 * i, -0.3 + 1e-3 * i, 2.0 - i, 0}, x = {1.0 - 0.02 * i, 0.7, -1.5, -0.1 * i};
    const Lanes got = angle_of<Lanes>(y, x);
    for (int k = 0; k < kLanes; ++k) assert_true(got[k] == angle_of<double>(y[k], x[k]));
  }
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(angles_are_right_to_a_few_ulps),
      cmocka_unit_test(ends_and_corners),
      cmocka_unit_test(lanes_have_the_bits_of_single_numbers),
  };
  return cmocka_run_group_tests_name("core/wide_angle", tests, nullptr, nullptr);
}
