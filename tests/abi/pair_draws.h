// Pairs of shapes of all kinds that ship, drawn at random and picked by hand: touching, deep, far, tiny, huge.
#pragma once

#include <carom/carom.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "carom_test.h"

namespace pair_draws {

/// With the shapes that ship.
inline carom_engine* engine_of(uint32_t threads) {
  carom_engine* engine = nullptr;
  setenv("CAROM_PLUGIN_PATH", CAROM_PLUGIN_DIR, 1);
  assert_int_equal(carom_engine_create(nullptr, &engine, nullptr), CAROM_OK);
  carom_jobs_desc jobs;
  carom_jobs_desc_init(&jobs, sizeof jobs);
  jobs.threads = threads;
  assert_int_equal(carom_engine_set_jobs(engine, &jobs, nullptr), CAROM_OK);
  return engine;
}

inline double uniform(uint64_t& state, double lo, double hi) {
  state = state * 6364136223846793005ull + 1442695040888963407ull;
  const uint64_t mixed = (state ^ (state >> 29)) * 0xBF58476D1CE4E5B9ull;
  return lo + (hi - lo) * static_cast<double>(mixed >> 11) * 0x1p-53;
}

/// Pairs, array by array, as carom_pairs has them.
struct Pairs {
  std::vector<carom_shape> shapes[2];
  std::vector<double> positions[2], orientations[2];

  std::size_t size() const { return shapes[0].size(); }
  void add(carom_shape a, const double pa[3], const double qa[4], carom_shape b, const double pb[3],
           const double qb[4]) {
    shapes[0].push_back(a), shapes[1].push_back(b);
    positions[0].insert(positions[0].end(), pa, pa + 3), positions[1].insert(positions[1].end(), pb, pb + 3);
    orientations[0].insert(orientations[0].end(), qa, qa + 4);
    orientations[1].insert(orientations[1].end(), qb, qb + 4);
  }
  carom_pairs view() const {
    carom_pairs p = {};
    p.struct_size = sizeof p;
    p.count = size();
    p.shapes_a = shapes[0].data(), p.shapes_b = shapes[1].data();
    p.positions_a = positions[0].data(), p.positions_b = positions[1].data();
    p.orientations_a = orientations[0].data(), p.orientations_b = orientations[1].data();
    return p;
  }
};

inline carom_shape named(carom_engine* engine, const char* name, const std::vector<double>& params) {
  carom_shape shape = 0;
  carom_error e = CAROM_ERROR_INIT;
  if (carom_shape_create_named(engine, name, params.data(), params.size(), &shape, &e) != CAROM_OK)
    print_error("%s: %s", name, e.message), assert_true(false);
  return shape;
}

inline void turn(uint64_t& state, double q[4]) {
  for (;;) {
    double n2 = 0;
    for (int k = 0; k < 4; ++k) q[k] = uniform(state, -1, 1), n2 += q[k] * q[k];
    if (!(n2 > 1e-3 && n2 <= 1)) continue;
    for (int k = 0; k < 4; ++k) q[k] /= std::sqrt(n2);
    return;
  }
}

/// A hull of points on an ellipsoid.
inline std::vector<double> cloud(uint64_t& state, int count, double size) {
  std::vector<double> xyz;
  const double radii[3] = {size * uniform(state, 0.4, 1), size * uniform(state, 0.4, 1), size * uniform(state, 0.4, 1)};
  while (xyz.size() < 3 * static_cast<std::size_t>(count)) {
    double v[3], n2 = 0;
    for (double& x : v) x = uniform(state, -1, 1), n2 += x * x;
    if (!(n2 > 1e-4 && n2 <= 1)) continue;
    for (int k = 0; k < 3; ++k) xyz.push_back(radii[k] * v[k] / std::sqrt(n2));
  }
  return xyz;
}

/// Three of each kind, `size` m.
inline std::vector<carom_shape> shapes_of_all_kinds(carom_engine* engine, uint64_t seed, double size) {
  std::vector<carom_shape> shapes;
  uint64_t state = seed;
  for (int i = 0; i < 3; ++i) {
    const double x = size * uniform(state, 0.3, 1), y = size * uniform(state, 0.3, 1),
                 z = size * uniform(state, 0.3, 1);
    shapes.push_back(named(engine, "sphere", {x}));
    shapes.push_back(named(engine, "box", {x, y, z}));
    shapes.push_back(named(engine, "capsule", {0.5 * x, y}));
    shapes.push_back(named(engine, "cylinder", {x, y}));
    shapes.push_back(named(engine, "cone", {x, y}));
    shapes.push_back(named(engine, "ellipsoid", {x, y, z}));
    shapes.push_back(named(engine, "tapered_capsule", {0.4 * x, 0.7 * z, y}));
    shapes.push_back(named(engine, "template", {x, y}));
    shapes.push_back(named(engine, "hull", cloud(state, 32, size)));
    shapes.push_back(named(engine, "hull", cloud(state, 600, size)));
  }
  return shapes;
}

/// @param reach  m: places of B about A's
inline void draw(Pairs& pairs, const std::vector<carom_shape>& shapes, uint64_t seed, std::size_t n, double from,
                 double reach) {
  uint64_t state = seed;
  for (std::size_t i = 0; i < n; ++i) {
    double p[2][3], q[2][4];
    for (int k = 0; k < 3; ++k) {
      p[0][k] = uniform(state, -from, from);
      p[1][k] = p[0][k] + uniform(state, -reach, reach);
    }
    turn(state, q[0]), turn(state, q[1]);
    const auto pick = [&] {
      return shapes[static_cast<std::size_t>(uniform(state, 0, static_cast<double>(shapes.size())))];
    };
    const carom_shape a = pick(), b = pick();
    pairs.add(a, p[0], q[0], b, p[1], q[1]);
  }
}

/// What random poses miss: shapes that touch along axes, in one place, far apart, far from the origin.
inline void add_degenerate(Pairs& pairs, const std::vector<carom_shape>& shapes) {
  const double upright[4] = {0, 0, 0, 1}, on_side[4] = {0, 0, std::sqrt(0.5), std::sqrt(0.5)}, zero[3] = {0, 0, 0};
  const double gaps[] = {0, 1e-300, 1e-9, 0.25, 0.5, 0.6, 1, 2, 1e6, 1e12, 1e99};
  const double far_out[3] = {1e9, -1e9, 1e9};
  for (const carom_shape a : shapes)
    for (const carom_shape b : {shapes[0], shapes[1], shapes[5], shapes[8], a}) {
      for (const double gap : gaps)
        for (int axis = 0; axis < 3; ++axis) {
          double at[3] = {0, 0, 0};
          at[axis] = gap;
          pairs.add(a, zero, upright, b, at, axis ? upright : on_side);
        }
      pairs.add(a, far_out, upright, b, far_out, upright);
    }
}

inline std::vector<carom_distance> one_by_one(carom_engine* engine, const Pairs& pairs,
                                              const carom_distance_desc* desc) {
  std::vector<carom_distance> out(pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    out[i].struct_size = sizeof out[i];
    assert_int_equal(carom_shape_distance(engine, pairs.shapes[0][i], &pairs.positions[0][3 * i],
                                          &pairs.orientations[0][4 * i], pairs.shapes[1][i], &pairs.positions[1][3 * i],
                                          &pairs.orientations[1][4 * i], desc, &out[i], nullptr),
                     CAROM_OK);
  }
  return out;
}

/// Fails with the first pair whose bits differ.
inline void assert_same(const std::vector<carom_distance>& a, const std::vector<carom_distance>& b) {
  assert_int_equal(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    if (std::memcmp(&a[i], &b[i], sizeof a[i]) != 0)
      print_error("pair %zu: %a in [%a, %a], %u steps; and %a in [%a, %a], %u steps", i, a[i].separation, a[i].lower,
                  a[i].upper, a[i].gjk_iterations, b[i].separation, b[i].lower, b[i].upper, b[i].gjk_iterations),
          assert_true(false);
}

}  // namespace pair_draws
