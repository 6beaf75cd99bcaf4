// Random numbers without a state: what they are follows from a key alone, so that who draws them, when and on how many
// threads, changes nothing. Philox4x32-10 [Salmon2011].
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "core/logarithm.h"
#include "core/trig.h"

namespace carom::core {

using RandomBlock = std::array<std::uint32_t, 4>;

/// The block of a key, by ten rounds.
/// @param counter, key  any
/// @oracle tests/unit/core/test_keyed_random: the published blocks
inline RandomBlock philox(RandomBlock counter, std::array<std::uint32_t, 2> key) {
  for (int round = 0; round < 10; ++round) {
    const std::uint64_t a = std::uint64_t(0xD2511F53) * counter[0], b = std::uint64_t(0xCD9E8D57) * counter[2];
    counter = {static_cast<std::uint32_t>(b >> 32) ^ counter[1] ^ key[0], static_cast<std::uint32_t>(b),
               static_cast<std::uint32_t>(a >> 32) ^ counter[3] ^ key[1], static_cast<std::uint32_t>(a)};
    key[0] += 0x9E3779B9, key[1] += 0xBB67AE85;
  }
  return counter;
}

/// What numbers are drawn for.
struct RandomKey {
  std::uint64_t seed, world, step;
};

/// Two numbers in [0, 1), multiples of 2^-53; of `pair` any.
/// Seed and world, mixed by a block of their own, are the key of the block that step and pair count: numbers of two seeds
/// or worlds agree with a chance of 2^-96.
inline std::array<double, 2> uniform_pair(const RandomKey& key, std::uint64_t pair) {
  const auto low = [](std::uint64_t x) { return static_cast<std::uint32_t>(x); };
  const auto high = [](std::uint64_t x) { return static_cast<std::uint32_t>(x >> 32); };
  const RandomBlock mixed = philox({low(key.world), high(key.world), high(pair), 0}, {low(key.seed), high(key.seed)});
  const RandomBlock r = philox({low(key.step), high(key.step), low(pair), mixed[2]}, {mixed[0], mixed[1]});
  const auto number = [](std::uint32_t a, std::uint32_t b) {
    return static_cast<double>((std::uint64_t(a) << 32 | b) >> 11) * 0x1p-53;
  };
  return {number(r[0], r[1]), number(r[2], r[3])};
}

/// Two independent normal numbers of mean 0 and deviation 1, by Box and Muller's transformation; the same bits on every
/// platform.   @accuracy  of logarithm() and sin_cos(); none is beyond 8.6
inline std::array<double, 2> normal_pair(const RandomKey& key, std::uint64_t pair) {
  const auto u = uniform_pair(key, pair);
  constexpr double kFullTurn = 0x1.921fb54442d18p+2;  // rad
  const double radius = std::sqrt(-2 * logarithm(1 - u[0]));
  const SinCos turn = sin_cos(kFullTurn * u[1]);
  return {radius * turn.cos, radius * turn.sin};
}

}  // namespace carom::core
