// Carom under test: each simplex sub-algorithm, the hybrid, the tolerance dial, the early-out, the memory of a pair.
#include <algorithm>
#include <string>

#include "collision/narrow/query.h"
#include "solid.h"

namespace carom::bench {

namespace {

class Carom final : public Peer {
 public:
  Carom(std::string name, const QuerySettings& settings, bool warm = false)
      : name_("Carom " + std::move(name)), settings_(settings), warm_(warm) {}

  const char* name() const override { return name_.c_str(); }
  bool remembers() const override { return warm_; }

  void prepare(const Query* queries, std::size_t count) override {
    pairs_.clear();
    memories_.clear();
    for (const Query* q = queries; q < queries + count; ++q) {
      pairs_.push_back({q->a->shape, q->b->shape, frame_of(q->at_a), frame_of(q->at_b), q->track});
      memories_.resize(std::max(memories_.size(), static_cast<std::size_t>(q->track + 1)));
    }
  }

  void ask(std::size_t i, Answer& answer) override {
    const Pair& p = pairs_[i];
    QueryResult result;
    SupportFault fault;
    QueryMemory* const memory = warm_ ? &memories_[static_cast<std::size_t>(p.track)] : nullptr;
    distance(*p.a, *p.b, relative(p.frame_a, p.frame_b), settings_, memory, result, fault);
    answer.calls = result.support_calls;
    if (settings_.max_distance == 0) {  // yes or no: apart is what a plane proves
      answer.overlap = !(result.lower > 0);
      return;
    }
    // The shells of the hybrid are its own affair: a host adds them again.
    const Real shells = settings_.method == Method::hybrid ? 2 * settings_.margin : 0;
    answer.separation = result.separation + shells;
    answer.overlap = answer.separation <= 0;
    const Vec3 n = p.frame_a.rotate(result.normal);
    for (int k = 0; k < 3; ++k) answer.normal[k] = n[k];
  }

 private:
  struct Pair {
    const Shape *a, *b;
    Frame frame_a, frame_b;
    int track;
  };

  std::string name_;
  QuerySettings settings_;
  bool warm_;
  std::vector<Pair> pairs_;
  std::vector<QueryMemory> memories_;
};

/// Default dials but for the routines that know pairs of boxes and of capsules: what is compared is the convex core.
QuerySettings core_alone() {
  QuerySettings settings;
  settings.routines = false;
  return settings;
}

}  // namespace

std::unique_ptr<Peer> make_carom(std::uint32_t simplex, double tolerance) {
  QuerySettings settings = core_alone();
  settings.simplex = static_cast<Simplex>(simplex);
  settings.tolerance = tolerance;
  return std::make_unique<Carom>("", settings);
}

void add_carom(Peers& peers) {
  const auto add = [&](const std::string& name, auto change, bool warm = false) {
    QuerySettings settings = core_alone();
    change(settings);
    peers.push_back(std::make_unique<Carom>(name, settings, warm));
  };
  add("with its routines", [](QuerySettings& s) { s.routines = true; });
  add("johnson", [](QuerySettings& s) { s.simplex = Simplex::johnson; });
  add("voronoi", [](QuerySettings& s) { s.simplex = Simplex::voronoi; });
  add("voronoi_last", [](QuerySettings&) {});
  add(
      "voronoi_last, warm", [](QuerySettings&) {}, true);
  add("hybrid", [](QuerySettings& s) { s.method = Method::hybrid; });
  add("voronoi_last at 1e-12", [](QuerySettings& s) { s.tolerance = 1e-12; });
  // What others' 1e-6 comes to: many err by 2e-6 and more at it, so these are compared at errors as large as theirs.
  add("voronoi_last at 2e-6", [](QuerySettings& s) { s.tolerance = 2e-6; });
  add("voronoi_last at 5e-6", [](QuerySettings& s) { s.tolerance = 5e-6; });
  add("yes/no", [](QuerySettings& s) { s.max_distance = 0; });
}

}  // namespace carom::bench
