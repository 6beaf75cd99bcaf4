// Own logarithm against long double, and bits for everywhere.
#include "core/logarithm.h"

#include "carom_test.h"
#include "core/hash.h"

using namespace carom;

static Real ulp_of(Real x) { return std::nextafter(std::fabs(x), kInfinity) - std::fabs(x); }

static void it_is_right_to_two_ulp(void**) {
  Real worst = 0;
  const auto check = [&](Real x) {
    const long double exact = std::log(static_cast<long double>(x));
    if (exact == 0) return;
    const auto error = static_cast<Real>(std::fabs(logarithm(x) - exact));
    worst = std::max(worst, error / ulp_of(static_cast<Real>(exact)));
  };
  for (int k = -1022; k <= 1023; ++k)
    for (int i = 0; i < 200; ++i) check(std::ldexp(1 + i * 0.00498173, k));
  for (int k = 1; k <= 52; ++k)
    for (int i = 1; i < 200; ++i) check(1 + std::ldexp(i / 200.0, -k)), check(1 - std::ldexp(i / 201.0, -k));
  // Half for the last rounding, half for the product of half the size before it, and one for all that is smaller.
  assert_true(worst <= 2);
}

static void it_has_its_ends(void**) {
  assert_true(logarithm(1) == 0 && logarithm(kInfinity) == kInfinity);
  const Real least = 0x1p-1074;
  assert_true(std::fabs(logarithm(least) / std::log(2.0) + 1074) < 1e-12);
  Real last = logarithm(least);
  for (Real x = 2 * least; x < 1e300; x *= 1.37) {
    assert_true(x < 0x1p-1060 || logarithm(x) > last);
    last = logarithm(x);
  }
}

/// The same bits under every compiler and library.
static void its_bits_are_these(void**) {
  Hash hash;
  Real x = 1e-300;
  for (int i = 0; i < 20000; ++i, x *= 1.0625) hash.add(double(logarithm(x)));
  assert_true(hash.value() == 0x46af732c8a3d46c5ull);
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(it_is_right_to_two_ulp),
      cmocka_unit_test(it_has_its_ends),
      cmocka_unit_test(its_bits_are_these),
  };
  return cmocka_run_group_tests_name("core/logarithm", tests, nullptr, nullptr);
}
