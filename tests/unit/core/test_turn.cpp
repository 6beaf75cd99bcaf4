// Turns by a quotient of polynomials against long double.
#include <cmath>
#include <initializer_list>

#include "carom_test.h"
#include "core/turn.h"

using namespace carom;

static void a_turn_is_right_to_an_ulp_on_both_sides_of_the_seam(void**) {
  Real worst = 0, worst_half = 0;
  for (int i = -300000; i <= 300000; ++i) {
    const Real angle = i * 1.00003e-5;
    const Turn t = turn_by(angle);
    const auto a = static_cast<long double>(angle);
    worst = std::fmax(worst, std::fabs(static_cast<Real>(t.cos - std::cos(a))));
    worst = std::fmax(worst, std::fabs(static_cast<Real>(t.sin - std::sin(a))));
    const Real scale = std::sqrt(t.half_cos * t.half_cos + t.half_sin * t.half_sin);
    assert_true(scale >= 1 - kEpsilon && scale <= 1.005);
    worst_half = std::fmax(worst_half, std::fabs(static_cast<Real>(t.half_sin / scale - std::sin(a / 2))));
    assert_true(std::fabs(t.cos * t.cos + t.sin * t.sin - 1) <= 4 * kEpsilon);
  }
  // Numerator and denominator round by 2 u, the reciprocal of their squares by 3 u, the products by 2 u, of values up to 1.
  assert_true(worst < 8 * kUnitRoundoff && worst_half < 8 * kUnitRoundoff);
}

static void huge_angles_stay_on_the_circle(void**) {
  for (const Real angle : {1e9, -1e15, 1e300, 1e-300, 0.0}) {
    const Turn t = turn_by(angle);
    assert_true(std::fabs(t.cos * t.cos + t.sin * t.sin - 1) <= 8 * kEpsilon);
    assert_true(t.half_cos * t.half_cos + t.half_sin * t.half_sin > 0.8);
  }
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(a_turn_is_right_to_an_ulp_on_both_sides_of_the_seam),
      cmocka_unit_test(huge_angles_stay_on_the_circle),
  };
  return cmocka_run_group_tests_name("core/turn", tests, nullptr, nullptr);
}
