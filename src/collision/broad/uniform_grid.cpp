// Broad phase by cells of one size, filled afresh in every step: cost in proportion to the boxes, whatever their
// motion.
//
// A box enters every cell that it reaches into; pairs are looked for within a cell. Two boxes may share several cells:
// the pair is reported in the one that holds the lower corner of their overlap, max(lo_a, lo_b), which both reach.
// That cell is the larger of their first cells, axis by axis, so the test is in whole numbers and no pair is lost or
// doubled by rounding. Boxes that reach into many cells, or are unbounded, are compared with all others instead.
#include <algorithm>
#include <array>

#include "collision/broad/bounds.h"
#include "collision/broad/broad_phase.h"
#include "collision/broad/pair_order.h"

namespace carom::collision {
namespace {

/// A box in more cells than this is "large". 4 x 4 x 4: boxes up to 3 cells long, six times the usual size, always fit.
constexpr std::int64_t kMostCells = 64;

/// Cells are numbered modulo 2^21 an axis, so that three numbers make one key whatever the distance from the origin.
/// Two cells of one box never share a key (it has at most 64); cells 2^21 apart do, which costs a test and changes
/// nothing.
constexpr std::uint64_t kWrap = (1u << 21) - 1;

/// Beyond this a cell number is clamped (numbers of doubles are apart by more than a cell long before).
constexpr Real kFarthest = 0x1p60;

class UniformGrid final : public BroadPhase {
 public:
  explicit UniformGrid(Memory* m)
      : six_(m), first_(m), extent_(m), small_(m), large_(m), entries_(m), sorted_(m), start_(m), order_(m) {}

  void find_pairs(const Colliders& table, std::uint64_t, const BroadSettings& settings, Array<Pair>& pairs) override {
    work_ = {};
    pairs.clear();
    take_in(table);
    cell_ = settings.grid_cell > 0 ? settings.grid_cell : usual_cell();
    fill();
    for (std::size_t i = 0; i < large_.size(); ++i) {
      for (std::size_t j = i + 1; j < large_.size(); ++j) compare(table, large_[i], large_[j], pairs);
      for (const std::uint32_t other : small_) compare(table, large_[i], other, pairs);
    }
    for (std::size_t bucket = 0; bucket + 2 < start_.size(); ++bucket) look_in(table, bucket, pairs);
    order_.sort(pairs, table.slots());
  }

 private:
  using Cell = std::array<std::int64_t, 3>;
  struct Entry {
    std::uint64_t key;
    std::uint32_t slot;
  };

  /// Boxes that are there go to small_ for now, unbounded ones to large_.
  void take_in(const Colliders& table) {
    six_.resize(6 * table.slots());
    first_.resize(table.slots());
    small_.clear();
    large_.clear();
    extent_.clear();
    for (const std::uint32_t slot : table.active) {
      const Aabb& box = table.bounds[slot];
      if (is_empty(box)) continue;
      put_six(box, &six_[6 * slot]);
      const Real extent = (box.hi - box.lo).max_entry();
      if (extent < kInfinity) {
        small_.push_back(slot);
        extent_.push_back(extent);
      } else {
        large_.push_back(slot);
      }
    }
  }

  /// Twice the mean of the boxes' longest sides, when the longest twentieth is set aside (a floor must not decide).
  /// A box then enters about (1 + 1/2)^3 = 3.4 cells. A median would let a crowd of crumbs choose cells so small that
  /// all else is "large".
  Real usual_cell() {
    const auto n = static_cast<std::ptrdiff_t>(extent_.size()), kept = n - n / 20;
    if (kept < n) std::nth_element(extent_.begin(), extent_.begin() + kept, extent_.end());
    Real mean = 0;  // divided first: the sum of finite numbers may not be
    for (std::ptrdiff_t i = 0; i < kept; ++i) mean += extent_[static_cast<std::size_t>(i)] / static_cast<Real>(kept);
    return mean > 0 ? std::min(2 * mean, Real(1e300)) : 1;  // points enter one cell of any size
  }

  /// floor(x / cell), by conversion: floor() of the baseline instruction set is a call.
  std::int64_t number(Real x) const {
    const Real cells = std::clamp(x / cell_, -kFarthest, kFarthest);
    const auto toward_zero = static_cast<std::int64_t>(cells);
    return toward_zero - (static_cast<Real>(toward_zero) > cells);
  }

  static std::uint64_t key(const Cell& c) {
    const auto wrapped = [](std::int64_t i) { return static_cast<std::uint64_t>(i) & kWrap; };
    return (wrapped(c[0]) << 42) | (wrapped(c[1]) << 21) | wrapped(c[2]);
  }

  std::size_t bucket_of(std::uint64_t k) const {
    k *= 0x9E3779B97F4A7C15ull;  // Fibonacci hashing: the high bits depend on all bits of the key
    return static_cast<std::size_t>(k >> shift_);
  }

  /// Enter the boxes into cells; those with too many join large_. Then bring entries of one bucket together.
  void fill() {
    entries_.clear();
    std::size_t stay = 0;
    for (const std::uint32_t slot : small_) {
      const Real* box = &six_[6 * slot];
      Cell lo, hi;
      for (std::size_t k = 0; k < 3; ++k) lo[k] = number(box[k]), hi[k] = number(box[3 + k]);
      // Axis by axis: the product of three large counts need not fit.
      std::int64_t count = 1;
      for (std::size_t k = 0; k < 3 && count <= kMostCells; ++k)
        count = hi[k] - lo[k] >= kMostCells ? kMostCells + 1 : count * (hi[k] - lo[k] + 1);
      if (count > kMostCells) {
        large_.push_back(slot);
        continue;
      }
      small_[stay++] = slot;
      first_[slot] = lo;
      Cell c;
      for (c[0] = lo[0]; c[0] <= hi[0]; ++c[0])
        for (c[1] = lo[1]; c[1] <= hi[1]; ++c[1])
          for (c[2] = lo[2]; c[2] <= hi[2]; ++c[2]) entries_.push_back({key(c), slot});
    }
    small_.resize(stay);
    work_.entries = entries_.size();
    work_.large = large_.size();

    int bits = 4;
    while ((std::size_t(1) << bits) < 2 * entries_.size()) ++bits;
    shift_ = 64 - bits;
    // Counted two places late and summed, start_[b + 1] is where bucket b begins; filling moves it on to where it ends.
    start_.assign((std::size_t(1) << bits) + 2, 0);
    for (const Entry& e : entries_) ++start_[bucket_of(e.key) + 2];
    for (std::size_t i = 2; i < start_.size(); ++i) start_[i] += start_[i - 1];
    sorted_.resize(entries_.size());
    for (const Entry& e : entries_) sorted_[start_[bucket_of(e.key) + 1]++] = e;
  }

  void look_in(const Colliders& table, std::size_t bucket, Array<Pair>& pairs) {
    const Real* const six = six_.data();
    const Entry* const end = sorted_.data() + start_[bucket + 1];
    std::uint64_t tests = 0;
    for (const Entry* a = sorted_.data() + start_[bucket]; a < end; ++a) {
      const Real* const box = six + 6 * a->slot;
      for (const Entry* b = a + 1; b < end; ++b) {
        if (a->key != b->key) continue;
        ++tests;
        if (!overlap(box, six + 6 * b->slot)) continue;
        Cell shared;
        for (std::size_t k = 0; k < 3; ++k) shared[k] = std::max(first_[a->slot][k], first_[b->slot][k]);
        if (key(shared) == a->key) report(table, a->slot, b->slot, pairs);
      }
    }
    work_.tests += tests;
  }

  void compare(const Colliders& table, std::uint32_t a, std::uint32_t b, Array<Pair>& pairs) {
    ++work_.tests;
    if (overlap(&six_[6 * a], &six_[6 * b])) report(table, a, b, pairs);
  }

  static void report(const Colliders& table, std::uint32_t a, std::uint32_t b, Array<Pair>& pairs) {
    if (may_touch(table, a, b)) pairs.push_back({std::min(a, b), std::max(a, b)});
  }

  Real cell_ = 1;                       // m
  int shift_ = 60;                      // 64 - log2 of the number of buckets
  Array<Real> six_;                     // [6 slots] m: boxes, lo x y z hi x y z
  Array<Cell> first_;                   // [slots] the cell of the lower corner, small boxes only
  Array<Real> extent_;                  // m, longest sides of bounded boxes
  Array<std::uint32_t> small_, large_;  // slots
  Array<Entry> entries_, sorted_;       // a box in a cell; by slot, by bucket
  Array<std::uint32_t> start_;          // [buckets + 2] where a bucket begins in sorted_; the next one is its end
  PairOrder order_;
};

}  // namespace

Owned<BroadPhase> make_uniform_grid(Memory* memory) { return make_owned<BroadPhase, UniformGrid>(memory, memory); }

}  // namespace carom::collision
