// The same rays for all: from above a heap to points within it.
#include "rays.h"

#include <algorithm>
#include <cmath>

namespace carom::bench {
namespace {

/// Repeatable numbers, uniform in [0, 1).
class Numbers {
 public:
  double next() {
    state_ = state_ * 6364136223846793005ull + 1442695040888963407ull;
    const std::uint64_t mixed = (state_ ^ (state_ >> 29)) * 0xBF58476D1CE4E5B9ull;
    return static_cast<double>(mixed >> 11) * 0x1p-53;
  }
  double between(double lo, double hi) { return lo + (hi - lo) * next(); }

 private:
  std::uint64_t state_ = 10;
};

/// From above the heap, within its walls (a ray that starts in a wall is an overlap to some and nothing to others), to
/// a point of its box.
std::vector<double> rays_into(const std::vector<BodyState>& states, const Plan& plan, std::size_t n) {
  Vec lo = Vec::Constant(1e300), hi = -lo;
  for (std::size_t i = 0; i < states.size(); ++i)
    if (!plan.members()[i].is_static)
      lo = lo.cwiseMin(vec(states[i].position)), hi = hi.cwiseMax(vec(states[i].position));
  Numbers numbers;
  std::vector<double> ends(6 * n);
  for (std::size_t i = 0; i < n; ++i)
    for (int k = 0; k < 3; ++k) {
      const double up = k == 1 ? hi.y() - lo.y() + 1 : 0;
      ends[6 * i + static_cast<std::size_t>(k)] = numbers.between(lo[k] + up, hi[k] + up);
      ends[6 * i + 3 + static_cast<std::size_t>(k)] = numbers.between(lo[k], hi[k]);
    }
  return ends;
}

/// The same world, asked by support functions alone: another way to the same answers.
class ByWalk final : public PeerWorld {
 public:
  explicit ByWalk(CaromWorld& world) : world_(world) {}
  void step(double dt) override { world_.step(dt); }
  void read(BodyState* states) const override { world_.read(states); }
  std::size_t contact_points() const override { return world_.contact_points(); }
  bool cast_rays(const double* ends, std::size_t n, double* fractions) override {
    world_.cast_rays(ends, n, fractions, CAROM_ASK_GENERIC);
    return true;
  }

 private:
  CaromWorld& world_;
};

}  // namespace

std::vector<RayRecord> measure_rays(const Row& row, const Options& options, std::size_t count) {
  SceneChoice choice = row.choice;
  double seconds = options.seconds > 0 ? options.seconds : row.seconds;
  if (options.quick) {
    seconds = std::min(seconds, 0.5);
    count = std::min<std::size_t>(count, 2000);
    for (auto& [name, value] : choice.settings.values)
      if (name == "n" && row.quick_n > 0) value = row.quick_n;
  }
  const carom_engine_desc desc = counted_engine();
  tools::Engine engine(tools::PluginPath(options.plugins), &desc);
  tools::Stage stage(engine);
  tools::build(find_scene(choice.scene), choice.settings, stage);
  Plan plan(stage);

  std::vector<std::unique_ptr<PeerWorld>> worlds;
  std::vector<RayRecord> records;
  auto carom = std::make_unique<CaromWorld>(engine, choice, options.dials);
  const auto steps = static_cast<std::size_t>(std::max(1l, std::lround(seconds / kDt)));
  for (std::size_t i = 0; i < steps; ++i) carom->step(kDt);
  std::vector<BodyState> states(plan.members().size());
  carom->read(states.data());
  plan.start_at(states);
  const std::vector<double> ends = rays_into(states, plan, count);
  records.emplace_back().engine = "Carom (double)";
  records.back().is_carom = records.back().is_own = true;
  records.emplace_back().engine = "Carom, support functions only";
  records.back().is_own = true;
  worlds.push_back(std::move(carom));
  worlds.push_back(std::make_unique<ByWalk>(static_cast<CaromWorld&>(*worlds[0])));
  for (const PeerEngine& peer : options.peers) {
    worlds.emplace_back(peer.make(plan.world(row.sleeping)));
    records.emplace_back().engine = peer.name;
  }

  std::vector<std::vector<double>> fractions(worlds.size(), std::vector<double>(count));
  std::vector<bool> asked(worlds.size(), true);
  for (int repeat = 0; repeat < options.repeats; ++repeat)
    for (std::size_t i = 0; i < worlds.size(); ++i) {
      if (!asked[i]) continue;
      const double start = seconds_now(1);
      asked[i] = worlds[i]->cast_rays(ends.data(), count, fractions[i].data());
      const double took = seconds_now(1) - start;
      if (repeat == 0) records[i].first = took;
      records[i].best = repeat == 0 ? took : std::min(records[i].best, took);
    }
  std::vector<RayRecord> done;
  for (std::size_t i = 0; i < worlds.size(); ++i) {
    if (!asked[i]) continue;
    RayRecord& r = records[i];
    for (std::size_t k = 0; k < count; ++k) {
      const double own = fractions[i][k], ours = fractions[0][k];
      r.hits += own <= 1;
      r.unlike += (own <= 1) != (ours <= 1);
      if (own > 1 || ours > 1) continue;
      const double apart = std::fabs(own - ours) * (Vec(&ends[6 * k + 3]) - Vec(&ends[6 * k])).norm();
      r.farthest = std::max(r.farthest, apart);
      r.apart += apart > 1e-3;
    }
    done.push_back(r);
  }
  return done;
}

}  // namespace carom::bench
