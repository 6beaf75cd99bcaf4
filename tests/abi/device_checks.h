// What holds on any device: the bits are the host's.
#pragma once

#include <cstdio>

#include "pair_draws.h"

namespace device_checks {

using namespace pair_draws;

/// Null if there is none: `error` says why.
inline carom_device* device_of(carom_engine* engine, carom_error& error) {
  carom_device* device = nullptr;
  error = CAROM_ERROR_INIT;
  return carom_device_create(engine, 0, &device, &error) == CAROM_OK ? device : nullptr;
}

inline void close(carom_engine* engine, carom_device* device) {
  assert_int_equal(carom_device_destroy(device, nullptr), CAROM_OK);
  assert_int_equal(carom_engine_destroy(engine, nullptr), CAROM_OK);
}

inline std::vector<carom_distance> on_host(carom_engine* engine, const Pairs& pairs, const carom_distance_desc* desc) {
  std::vector<carom_distance> out(pairs.size());
  const carom_pairs view = pairs.view();
  assert_int_equal(carom_pairs_distance(engine, &view, desc, out.data(), sizeof out[0], nullptr), CAROM_OK);
  return out;
}

inline std::vector<carom_distance> on_device(carom_device* device, const Pairs& pairs,
                                             const carom_distance_desc* desc) {
  std::vector<carom_distance> out(pairs.size());
  const carom_pairs view = pairs.view();
  carom_error e = CAROM_ERROR_INIT;
  if (carom_device_pairs_distance(device, &view, desc, out.data(), sizeof out[0], &e) != CAROM_OK)
    print_error("%s", e.message), assert_true(false);
  return out;
}

/// The half-space has no support function: its pairs are the host's.
inline Pairs pairs_of_all_kinds(carom_engine* engine, std::size_t n) {
  Pairs pairs;
  auto usual = shapes_of_all_kinds(engine, 1, 1);
  draw(pairs, usual, 2, n, 3, 1.6);
  draw(pairs, usual, 7, n / 10, 1e7, 2);
  draw(pairs, shapes_of_all_kinds(engine, 3, 1e-3), 4, n / 10, 3, 2e-3);
  draw(pairs, shapes_of_all_kinds(engine, 5, 1e4), 6, n / 10, 1, 3e4);
  add_degenerate(pairs, usual);
  carom_shape ground = 0;
  const double up[3] = {0, 1, 0}, zero[3] = {0, 0, 0}, upright[4] = {0, 0, 0, 1};
  assert_int_equal(carom_shape_create_half_space(engine, up, 0, &ground, nullptr), CAROM_OK);
  for (const carom_shape s : usual) pairs.add(ground, zero, upright, s, up, upright);
  return pairs;
}

/// @param n  random pairs
inline void check_bits(carom_engine* engine, carom_device* device, std::size_t n) {
  const Pairs pairs = pairs_of_all_kinds(engine, n);
  assert_same(on_device(device, pairs, nullptr), on_host(engine, pairs, nullptr));
  carom_device_info info = {};
  info.struct_size = sizeof info;
  assert_int_equal(carom_device_get_info(device, &info, nullptr), CAROM_OK);
  std::printf("%s, %s: of %zu pairs the host did %llu\n", info.name, info.version, pairs.size(),
              static_cast<unsigned long long>(info.host_pairs));
  assert_int_equal(info.pairs, pairs.size());
  assert_true(info.host_pairs > pairs.size() / 50 && info.host_pairs < pairs.size() / 2);
  for (uint32_t i = 0; i < 4; ++i) {
    carom_distance_desc d;
    carom_distance_desc_init(&d, sizeof d);
    d.simplex = i % 2 ? CAROM_SIMPLEX_VORONOI : CAROM_SIMPLEX_VORONOI_LAST;
    d.narrow_phase = i / 2 ? CAROM_NARROW_HYBRID : CAROM_NARROW_GJK_EPA;
    d.hybrid_margin = 0.01, d.tolerance = i % 2 ? 1e-3 : 1e-12, d.gjk_iterations = i == 3 ? 4 : 128;
    const Pairs fewer = pairs_of_all_kinds(engine, n / 10);
    assert_same(on_device(device, fewer, &d), on_host(engine, fewer, &d));
  }
}

}  // namespace device_checks
