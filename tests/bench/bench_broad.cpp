// Broad phases against the number of boxes and the kind of motion. Counters: pairs found, comparisons and exchanges a
// box.
#include <benchmark/benchmark.h>

#include <cmath>

#include "unit/collision/broad_scene.h"

namespace {

using namespace carom;
using namespace carom::test;

/// At rest; drifting as a pile does (a hundredth of a box a step); thrown anywhere in every step.
enum Motion { rest, drift, scatter };

/// Boxes of 0.6..1.4 m, half of the room filled, a static floor under them. Every motion is computed beforehand and
/// copied in outside the clock: 16 frames there and back.
void run(benchmark::State& state, Owned<BroadPhase> (*make)(Memory*), Motion motion) {
  const auto n = static_cast<std::uint32_t>(state.range(0));
  Numbers random(n);
  BroadScene scene;
  const Real half_room = 0.5 * std::cbrt(2.0 * n);
  Aabb floor;
  floor.lo = Vec3::constant(-kInfinity);
  floor.hi = Vec3(kInfinity, 0.5 - half_room, kInfinity);
  scene.put(0, floor, false);
  for (std::uint32_t i = 1; i <= n; ++i) {
    const Vec3 half(random.between(0.3, 0.7), random.between(0.3, 0.7), random.between(0.3, 0.7));
    scene.put(i, box_at(random.in_cube(half_room), half));
  }
  std::vector<Array<Aabb>> frames{scene.table.bounds};
  for (int f = 1; f < 16; ++f) {
    for (std::uint32_t i = 1; i <= n; ++i) {
      if (motion == drift) scene.shift(i, random.in_cube(0.01));
      if (motion == scatter) scene.shift(i, random.in_cube(half_room) - scene.table.bounds[i].lo);
    }
    frames.push_back(scene.table.bounds);
  }
  auto phase = make(std::pmr::get_default_resource());
  Array<Pair> pairs;
  phase->find_pairs(scene.table, 1, scene.settings, pairs);
  std::size_t frame = 15;
  int direction = -1;
  double steps = 0, tests = 0, swaps = 0;
  for (auto _ : state) {
    state.PauseTiming();
    if (frame == 0 || frame == 15) direction = frame == 0 ? 1 : -1;
    frame = static_cast<std::size_t>(static_cast<int>(frame) + direction);
    std::copy(frames[frame].begin(), frames[frame].end(), scene.table.bounds.begin());
    state.ResumeTiming();
    phase->find_pairs(scene.table, 1, scene.settings, pairs);
    benchmark::DoNotOptimize(pairs.data());
    ++steps;
    tests += static_cast<double>(phase->work().tests);
    swaps += static_cast<double>(phase->work().swaps);
  }
  state.counters["pairs/box"] = static_cast<double>(pairs.size()) / n;
  state.counters["tests/box"] = tests / steps / n;
  state.counters["swaps/box"] = swaps / steps / n;
}

#define CAROM_BENCH_BROAD(name, make, motion) \
  BENCHMARK_CAPTURE(run, name##_##motion, make, motion)->RangeMultiplier(2)->Unit(benchmark::kMicrosecond)
CAROM_BENCH_BROAD(brute_force, make_brute_force, drift)->Range(64, 4096);
CAROM_BENCH_BROAD(sweep_and_prune, make_sweep_and_prune, rest)->Range(64, 8192);
CAROM_BENCH_BROAD(sweep_and_prune, make_sweep_and_prune, drift)->Range(64, 8192);
CAROM_BENCH_BROAD(sweep_and_prune, make_sweep_and_prune, scatter)->Range(64, 8192);
CAROM_BENCH_BROAD(grid, make_uniform_grid, rest)->Range(64, 8192);
CAROM_BENCH_BROAD(grid, make_uniform_grid, drift)->Range(64, 8192);
CAROM_BENCH_BROAD(grid, make_uniform_grid, scatter)->Range(64, 8192);
CAROM_BENCH_BROAD(tree, make_tree, rest)->Range(64, 8192);
CAROM_BENCH_BROAD(tree, make_tree, drift)->Range(64, 8192);
CAROM_BENCH_BROAD(tree, make_tree, scatter)->Range(64, 8192);

}  // namespace
