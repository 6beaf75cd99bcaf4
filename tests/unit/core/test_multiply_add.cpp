// A product and a sum rounded once: against the C library's where it is known to be right, and bits for everywhere.
#include "core/multiply_add.h"

#include "carom_test.h"
#include "collision/narrow/simplex_geometry.h"
#include "core/hash.h"

using namespace carom;

namespace {

/// Numbers of all sizes up to 2^most, some of few bits, some beside a power of two.
class Numbers {
 public:
  std::uint64_t word() {
    std::uint64_t z = (state_ += 0x9E3779B97F4A7C15ull);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
    return z ^ (z >> 31);
  }
  int up_to(int most) { return static_cast<int>(word() % static_cast<std::uint64_t>(2 * most + 1)) - most; }
  Real number(int most) {
    Real m = 1 + static_cast<Real>(word() >> 12) * 0x1p-52;
    const std::uint64_t kind = word() % 8;
    if (kind < 2) m = std::floor(m * 16) / 16;
    if (kind == 2) m = 1 + static_cast<Real>(word() % 8) * 0x1p-52;
    const bool positive = word() & 1;
    return std::ldexp(positive ? m : -m, up_to(most));
  }
  /// Like a number, or a few units of its last place beside it.
  Real near(Real x) { return x * (1 + up_to(4) * 0x1p-52); }

 private:
  std::uint64_t state_ = 1;
};

/// What a library does whose fma() is right: glibc's and that of a processor.
Real once(Real a, Real b, Real c) { return std::fma(a, b, c); }
bool library_is_right() {
#if defined(__GLIBC__) || defined(__FP_FAST_FMA)
  return true;
#else
  return false;
#endif
}

bool alike(Real a, Real b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

}  // namespace

/// By hand: what is left of 1 - (1 + u)(1 - u), ties, and the tie that a bit far below breaks.
static void a_product_and_a_sum_are_rounded_once(void**) {
  const Real u = 0x1p-52;
  assert_true(multiply_add(1 + u, 1 - u, -1) == -u * u);
  assert_true(multiply_add(0x1p27 + 1, 0x1p27 + 1, -0x1p54) == 0x1p28 + 1);
  assert_true(multiply_add(1, u / 2, 1) == 1);          // a tie, to even
  assert_true(multiply_add(1 + u, u / 2, 1) == 1 + u);  // just above it
  assert_true(multiply_add(1 - u, u / 2, 1) == 1);      // just below
  assert_true(multiply_add(1 + u, u / 2, 1 + u) == 1 + 2 * u);
  assert_true(multiply_add(1 - u, u / 2, 1 + u) == 1 + u);  // a tie rounded twice: 1 + 2 u
  assert_true(alike(multiply_add(3, 5, -15), 0.0) && alike(multiply_add(-0.0, 5, -0.0), -0.0));
  // Beyond the bounds: the product is rounded, too.
  assert_true(multiply_add(0x1p1000, 4, -0x1p1000) == 3 * 0x1p1000 && multiply_add(0, 0x1p1023, 7) == 7);
  assert_true(multiply_add(kInfinity, 1, 1) == kInfinity && !(multiply_add(kInfinity, 0, 1) == 1));
  assert_true(multiply_add(0x1p-600, 0x1p-600, 0x1p-1074) == 0x1p-1074);
}

static void it_is_what_a_right_library_gives(void**) {
  if (!library_is_right()) skip();
  Numbers some;
  for (int i = 0; i < 2000000; ++i) {
    const int most = i % 3 == 0 ? 3 : (i % 3 == 1 ? 60 : 300);
    const Real a = some.number(most), b = some.number(most);
    const Real beside[] = {some.number(most), -a * b, some.near(-a * b), std::ldexp(-a * b, some.up_to(110))};
    const Real c = beside[some.word() % 4];
    assert_true(alike(multiply_add(a, b, c), once(a, b, c)));
    const Real d = some.number(most), e = some.near(a * b / d), de = d * e;
    assert_true(alike(difference_of_products(a, b, d, e), once(a, b, -de) + once(-d, e, de)));
  }
}

/// The same bits under every compiler and library.
static void its_bits_are_these(void**) {
  Numbers some;
  Hash hash;
  for (int i = 0; i < 200000; ++i) {
    const Real a = some.number(60), b = some.number(60), c = some.near(-a * b), d = some.number(600);
    hash.add(double(multiply_add(a, b, c))), hash.add(double(multiply_add(a, d, c)));
    hash.add(double(difference_of_products(a, b, d, some.near(a * b / d))));
  }
  assert_true(hash.value() == 0x34cef0c89fe9a192ull);
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(a_product_and_a_sum_are_rounded_once),
      cmocka_unit_test(it_is_what_a_right_library_gives),
      cmocka_unit_test(its_bits_are_these),
  };
  return cmocka_run_group_tests_name("core/multiply_add", tests, nullptr, nullptr);
}
