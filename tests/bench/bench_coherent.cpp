// What memory of a pair saves while it moves a little from frame to frame: a query asked afresh, started from the last
// separating direction, or not asked at all because the last bracket, widened by the motion, still says enough.
//
// Names: family/slow|fast/how. Counters per frame: supports (pairs of support calls), epa (share of frames in which EPA
// ran), carried (share answered by carry-over), violations (carried brackets that miss a fresh one; must be 0).
#include <benchmark/benchmark.h>

#include <string>

#include "coherent_pairs.h"
#include "collision/narrow/carry_over.h"

namespace {

using namespace carom;
using namespace carom::test;

constexpr int kPairs = 50, kFrames = 400;

/// 50 pairs of a family that start in overlap, from -0.15 to -0.02 m.
const std::vector<CoherentPair>& sequences(int family, bool fast) {
  static std::vector<CoherentPair> made[kFamilyCount][2];
  std::vector<CoherentPair>& pairs = made[family][fast];
  if (pairs.empty()) {
    Random random(static_cast<std::uint64_t>(2000 + family));
    for (int i = 0; i < kPairs; ++i)
      pairs.push_back(coherent_pair(random, family, family, random.uniform(-0.15, -0.02), fast ? 20 : 1, kFrames));
  }
  return pairs;
}

enum class How { cold, warm, carried };

struct Memory {
  QueryMemory query;
  Certificate certificate;
};

void run(benchmark::State& state, int family, bool fast, How how, Real share) {
  const std::vector<CoherentPair>& pairs = sequences(family, fast);
  const QuerySettings settings;
  std::size_t frames = 0, supports = 0, epa = 0, carried = 0, violations = 0;
  const auto step = [&](const CoherentPair& p, const Frame& pose, Memory& memory, QueryResult& r) {
    SupportFault fault;
    const Real width = share * std::min(p.a.bounding_radius, p.b.bounding_radius);
    if (how == How::carried && carry_over(p.a, p.b, pose, width, 0, memory.certificate, r)) return true;
    generic_distance(p.a, p.b, pose, settings, how == How::cold ? nullptr : &memory.query, r, fault);
    if (how == How::carried) certify(r, pose, 0, memory.certificate);
    return false;
  };
  for (const CoherentPair& p : pairs) {  // counted and judged once, outside the clock
    Memory memory;
    for (const Frame& pose : p.b_in_a) {
      QueryResult r, truth;
      SupportFault fault;
      const bool kept = step(p, pose, memory, r);
      ++frames;
      supports += static_cast<std::size_t>(r.support_calls);
      epa += r.epa_iterations > 0;
      carried += kept;
      if (!kept) continue;
      generic_distance(p.a, p.b, pose, settings, nullptr, truth, fault);
      violations += !(r.lower <= truth.upper && truth.lower <= r.upper);
    }
  }
  std::size_t i = 0, frame = 0;
  Memory memory;
  for (auto _ : state) {
    QueryResult r;
    step(pairs[i], pairs[i].b_in_a[frame], memory, r);
    benchmark::DoNotOptimize(r);
    if (++frame < kFrames) continue;
    frame = 0;
    memory = Memory();
    if (++i == pairs.size()) i = 0;
  }
  const double n = static_cast<double>(frames);
  state.counters["supports"] = static_cast<double>(supports) / n;
  state.counters["epa"] = static_cast<double>(epa) / n;
  state.counters["carried"] = static_cast<double>(carried) / n;
  state.counters["violations"] = static_cast<double>(violations);
}

const int registered = [] {
  for (const int family : {1, 2, 3, 4, 5, 6, 7}) {
    for (const bool fast : {false, true}) {
      const std::string start = std::string(kFamilies[family]) + (fast ? "/fast/" : "/slow/");
      const auto add = [&](const std::string& how, How kind, Real share) {
        benchmark::RegisterBenchmark((start + how).c_str(), run, family, fast, kind, share);
      };
      add("cold", How::cold, 0);
      add("warm", How::warm, 0);
      for (const Real share : {1e-3, 5e-3, 2e-2})
        add("carried/" + std::to_string(share).substr(0, 5), How::carried, share);
    }
  }
  return 0;
}();

}  // namespace
