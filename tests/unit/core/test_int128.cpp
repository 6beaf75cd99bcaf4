// Whole numbers of 128 bits of our own against the compiler's.
#include "core/int128.h"

#include <random>

#include "carom_test.h"

using carom::core::OwnInt128;
__extension__ typedef __int128 Its;
__extension__ typedef unsigned __int128 Modulo;  // sums may be beyond a signed one

namespace {

bool same(OwnInt128 own, Its its) {
  return static_cast<std::uint64_t>(own) == static_cast<std::uint64_t>(its) &&
         static_cast<std::uint64_t>(own >> 64) == static_cast<std::uint64_t>(its >> 64);
}

void sums_products_and_order_are_the_compilers(void**) {
  std::mt19937_64 random(7);
  const std::int64_t edges[] = {0, 1, -1, INT64_MAX, INT64_MIN, 0xFFFFFFFF, -0x100000000, 1ll << 53};
  for (int i = 0; i < 20000; ++i) {
    const auto number = [&](int k) {
      const std::uint64_t n = random();
      return k % 3 ? static_cast<std::int64_t>(n) >> (n & 63) : edges[n & 7];
    };
    const std::int64_t a = number(i), b = number(i / 3), c = number(i / 9);
    const OwnInt128 own = OwnInt128(a) * b - OwnInt128(c) * a, own_b = OwnInt128(static_cast<std::uint64_t>(b)) * c;
    const Its its = Its(a) * b - Its(c) * a, its_b = Its(static_cast<std::uint64_t>(b)) * c;
    assert_true(same(own, its) && same(own_b, its_b) &&
                same(own + own_b, static_cast<Its>(Modulo(its) + Modulo(its_b))));
    assert_true((own < own_b) == (its < its_b) && (own > 0) == (its > 0) && (own == own_b) == (its == its_b));
    OwnInt128 sum = own;
    sum += own >> 64;
    assert_true(same(sum, static_cast<Its>(Modulo(its) + Modulo(its >> 64))));
  }
}

}  // namespace

int main() {
  const struct CMUnitTest tests[] = {cmocka_unit_test(sums_products_and_order_are_the_compilers)};
  return cmocka_run_group_tests_name("unit/core/int128", tests, nullptr, nullptr);
}
