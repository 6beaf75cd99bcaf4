// Random numbers by their keys: the published answers of Philox4x32-10, and what is asked of uniform and normal numbers.
#include "core/keyed_random.h"

#include <set>

#include "carom_test.h"

using namespace carom;

static void the_published_answers(void**) {
  const RandomBlock zeros = philox({0, 0, 0, 0}, {0, 0});
  const RandomBlock ones = philox({~0u, ~0u, ~0u, ~0u}, {~0u, ~0u});
  const RandomBlock pi = philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0});
  assert_true((zeros == RandomBlock{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  assert_true((ones == RandomBlock{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  assert_true((pi == RandomBlock{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

/// Each part of a key changes the numbers, and none changes them as another does.
static void keys_that_differ_have_other_numbers(void**) {
  std::set<double> met;
  for (const std::uint64_t x : {std::uint64_t(0), std::uint64_t(1), std::uint64_t(1) << 32, ~std::uint64_t(0)})
    for (const std::uint64_t y : {std::uint64_t(0), std::uint64_t(1), std::uint64_t(1) << 32, ~std::uint64_t(0)})
      for (const std::uint64_t z : {std::uint64_t(0), std::uint64_t(1), std::uint64_t(1) << 32, ~std::uint64_t(0)})
        for (const std::uint64_t pair : {std::uint64_t(0), std::uint64_t(1), std::uint64_t(1) << 32})
          for (const double u : uniform_pair({x, y, z}, pair)) met.insert(u);
  assert_int_equal(met.size(), 4 * 4 * 4 * 3 * 2);
}

/// Means of n numbers have a deviation of s / sqrt(n), s of one number: five of them are met once in a million tries.
static void means_and_deviations(void**) {
  constexpr int kPairs = 200000;
  const double root = std::sqrt(2.0 * kPairs);
  double u_sum = 0, u_square = 0, n_sum = 0, n_square = 0, n_fourth = 0, product = 0;
  for (int i = 0; i < kPairs; ++i) {
    const RandomKey key{7, static_cast<std::uint64_t>(i % 500), static_cast<std::uint64_t>(i / 500)};
    for (const double u : uniform_pair(key, 0)) {
      assert_true(u >= 0 && u < 1);
      u_sum += u - 0.5, u_square += (u - 0.5) * (u - 0.5) - 1.0 / 12;
    }
    const auto two = normal_pair(key, 1);
    for (const double x : two) {
      assert_true(std::fabs(x) < 8.7);
      n_sum += x, n_square += x * x - 1, n_fourth += x * x * x * x - 3;
    }
    product += two[0] * two[1];
  }
  assert_true(std::fabs(u_sum) < 5 * std::sqrt(1.0 / 12) * root);
  assert_true(std::fabs(u_square) < 5 * std::sqrt(1.0 / 180) * root);
  assert_true(std::fabs(n_sum) < 5 * root && std::fabs(n_square) < 5 * std::sqrt(2.0) * root);
  assert_true(std::fabs(n_fourth) < 5 * std::sqrt(96.0) * root);
  assert_true(std::fabs(product) < 5 * std::sqrt(1.0 * kPairs));
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(the_published_answers),
      cmocka_unit_test(keys_that_differ_have_other_numbers),
      cmocka_unit_test(means_and_deviations),
  };
  return cmocka_run_group_tests_name("core/keyed_random", tests, nullptr, nullptr);
}
