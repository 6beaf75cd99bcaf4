// Makes the random pairs: the same ones on any machine and in any version, but for the last digits of a gap.
#include "sets.h"

#include <algorithm>
#include <stdexcept>

#include "collision/narrow/query.h"
#include "random_pairs.h"

namespace carom::bench {

namespace {

using carom::test::Random;

constexpr int kSolids = 64;  // hulls of 1,000 vertices then fill a second-level cache, and no more
constexpr int kTracks = 50, kFrames = 400;

/// A pair on its way to its place.
struct Draft {
  const OwnedSolid *a, *b;
  Frame at_a, at_b;
  Query query(int track = 0) const { return {&a->solid, &b->solid, placement(at_a), placement(at_b), track}; }
};

Real gap_of(const Draft& d) {
  QuerySettings settings;
  settings.tolerance = 1e-3;
  QueryResult result;
  SupportFault fault;
  generic_distance(d.a->shape, d.b->shape, relative(d.at_a, d.at_b), settings, nullptr, result, fault);
  return result.separation;
}

/// B on a random line through A's origin, both at random attitudes, A within a metre of the world's origin.
Query random_query(Random& random, const std::deque<OwnedSolid>& solids, Real gap) {
  const auto any = [&] { return &solids[static_cast<std::size_t>(random.uniform(0, kSolids))]; };
  const auto rotation = [&] { return test::random_rotation(random).matrix(); };
  Draft d;
  d.a = any(), d.b = any();
  d.at_a.r = rotation(), d.at_b.r = rotation();
  d.at_a.p = random.in_cube(1);
  const Vec3 line = random.direction();
  Real lo = 0, hi = 10;
  for (int i = 0; i < 12; ++i) {
    const Real middle = 0.5 * (lo + hi);
    d.at_b.p = d.at_a.p + middle * line;
    (gap_of(d) < gap ? lo : hi) = middle;
  }
  d.at_b.p = d.at_a.p + (gap < 0 ? lo : hi) * line;
  return d.query();
}

}  // namespace

Family::Family(const std::string& name, int pairs) {
  const auto family = std::find(std::begin(test::kFamilies), std::end(test::kFamilies), name);
  if (family == std::end(test::kFamilies)) throw std::runtime_error("no family is called " + name);
  const int index = static_cast<int>(family - std::begin(test::kFamilies));
  Random random(static_cast<std::uint64_t>(2000 + index));
  for (int i = 0; i < kSolids; ++i) solids_.emplace_back(test::random_shape(random, index));
  apart = {name, "apart", {}};
  deep = {name, "deep", {}};
  for (int i = 0; i < pairs; ++i) {
    apart.queries.push_back(random_query(random, solids_, random.uniform(0, 1)));
    deep.queries.push_back(random_query(random, solids_, random.uniform(-0.3, 0)));
  }
}

Set Family::coherent(bool in_overlap) const {
  const std::vector<Query>& from = (in_overlap ? deep : apart).queries;
  Set set{apart.family, in_overlap ? "coherent deep" : "coherent apart", {}};
  const int tracks = std::min(kTracks, static_cast<int>(from.size()));
  Random random(3000);
  std::vector<Query> now(from.begin(), from.begin() + tracks);
  std::vector<Vec3> turn, slide;
  for (int t = 0; t < tracks; ++t) {
    now[static_cast<std::size_t>(t)].track = t;
    turn.push_back(random.uniform(0.25e-3, 1e-3) * random.direction());
    slide.push_back(0.2e-3 * random.direction());
  }
  for (int i = 0; i < kFrames; ++i)
    for (std::size_t t = 0; t < now.size(); ++t) {
      set.queries.push_back(now[t]);
      Frame frame = frame_of(now[t].at_b);
      frame.r = exp_map(turn[t]).matrix() * frame.r;
      frame.p += slide[t];
      now[t].at_b = placement(frame);
    }
  return set;
}

}  // namespace carom::bench
