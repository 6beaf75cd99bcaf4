// What a signed distance costs: three simplex sub-algorithms and two methods on random pairs of each family, libccd
// beside them.
//
// Arguments of a name: family/apart|deep/who. Counters: supports (pairs of support calls), gjk, epa (iterations), per
// query.
#include <benchmark/benchmark.h>
#include <ccd/ccd.h>

#include <string>

#include "random_pairs.h"

namespace {

using namespace carom;
using namespace carom::test;

constexpr int kPairs = 500;

/// 500 pairs of a family, gaps uniform in (0, 1) m if apart, in (-0.3, 0) m if deep.
const std::vector<ShapePair>& pairs_of(int family, bool deep) {
  static std::vector<ShapePair> made[kFamilyCount][2];
  std::vector<ShapePair>& pairs = made[family][deep];
  if (pairs.empty()) {
    Random random(1000 + 2 * family + deep);
    for (int i = 0; i < kPairs; ++i)
      pairs.push_back(random_pair(random, family, family, deep ? random.uniform(-0.3, 0) : random.uniform(0, 1)));
  }
  return pairs;
}

void run_carom(benchmark::State& state, int family, bool deep, QuerySettings settings) {
  const std::vector<ShapePair>& pairs = pairs_of(family, deep);
  std::size_t i = 0, queries = 0, supports = 0, gjk = 0, epa = 0;
  for (auto _ : state) {
    const ShapePair& p = pairs[i];
    QueryResult result;
    SupportFault fault;
    generic_distance(p.a, p.b, p.b_in_a, settings, nullptr, result, fault);
    benchmark::DoNotOptimize(result);
    if (++i == pairs.size()) i = 0;
    ++queries;
    supports += result.support_calls;
    gjk += result.gjk_iterations;
    epa += result.epa_iterations;
  }
  const double n = static_cast<double>(queries);
  state.counters["supports"] = static_cast<double>(supports) / n;
  state.counters["gjk"] = static_cast<double>(gjk) / n;
  state.counters["epa"] = static_cast<double>(epa) / n;
}

struct CcdBody {
  const Shape* shape;
  Frame frame;
};

void ccd_support(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* out) {
  const CcdBody& body = *static_cast<const CcdBody*>(object);
  const Vec3 d = body.frame.rotate_inverse(Vec3(direction->v[0], direction->v[1], direction->v[2])).normalized();
  const Vec3 p = body.frame.apply(support_point(*body.shape, d));
  for (int i = 0; i < 3; ++i) out->v[i] = p[i];
}

/// Apart: libccd's yes or no (it has no distance). Deep: its GJK with EPA.
void run_ccd(benchmark::State& state, int family, bool deep) {
  const std::vector<ShapePair>& pairs = pairs_of(family, deep);
  ccd_t ccd;
  CCD_INIT(&ccd);
  ccd.support1 = ccd.support2 = ccd_support;
  ccd.max_iterations = 200;
  ccd.epa_tolerance = 1e-6;
  std::size_t i = 0;
  for (auto _ : state) {
    const CcdBody a{&pairs[i].a, Frame()}, b{&pairs[i].b, pairs[i].b_in_a};
    ccd_real_t depth = 0;
    ccd_vec3_t direction, position;
    benchmark::DoNotOptimize(deep ? ccdGJKPenetration(&a, &b, &ccd, &depth, &direction, &position)
                                  : ccdGJKIntersect(&a, &b, &ccd));
    if (++i == pairs.size()) i = 0;
  }
}

void add(const std::string& name, int family, bool deep, const QuerySettings& settings) {
  benchmark::RegisterBenchmark(name.c_str(), run_carom, family, deep, settings);
}

const int registered = [] {
  const char* const simplices[] = {"johnson", "voronoi", "voronoi_last"};
  for (int family = 0; family < kFamilyCount; ++family) {
    for (const bool deep : {false, true}) {
      const std::string start = std::string(kFamilies[family]) + (deep ? "/deep/" : "/apart/");
      for (int s = 0; s < 3; ++s) {
        QuerySettings settings;
        settings.simplex = static_cast<Simplex>(s);
        add(start + simplices[s], family, deep, settings);
      }
      QuerySettings hybrid;
      hybrid.method = Method::hybrid;
      add(start + "hybrid", family, deep, hybrid);
      benchmark::RegisterBenchmark((start + "libccd").c_str(), run_ccd, family, deep);
    }
  }
  // What accuracy costs: the tolerance dial on the family that converges slowest.
  for (const bool deep : {false, true}) {
    for (int digits = 2; digits <= 12; digits += 2) {
      for (int s = 0; s < 3; ++s) {
        QuerySettings settings;
        settings.simplex = static_cast<Simplex>(s);
        settings.tolerance = std::pow(10.0, -digits);
        add("tolerance/ellipsoid" + std::string(deep ? "/deep/" : "/apart/") + simplices[s] + "/1e-" +
                std::to_string(digits),
            7, deep, settings);
      }
    }
  }
  return 0;
}();

}  // namespace
