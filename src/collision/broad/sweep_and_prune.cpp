// Broad phase by sorted axes that keep their order from step to step: the cost of a step is what changed in it.
//
// Each axis holds the two ends of every box, sorted; closed intervals, so at equal values lower ends stand before upper
// ones, and then by slot: a strict order, the same whatever the history. A step puts the new values in and repairs the
// order by insertion. Insertion exchanges exactly the neighbours whose order changed, each once, and a pair that gains
// or loses its overlap does so on at least one axis through such an exchange:
//   a lower end moves below another box's upper end:   the pair may have met.    It has if the new boxes overlap.
//   an upper end moves below another box's lower end:  the pair has parted.      It was known if the old boxes
//   overlapped.
// The pairs themselves are one sorted array, into which the few that changed are merged. A hash set was the
// alternative: it makes a change cheaper and reading all pairs in order, which every step does, a sort.
//
// Where the order of the last step is worth little (a new scene, a teleport, a crowd of newcomers) all is sorted
// afresh; the exchanges allowed before that are what such a sort costs, so a step costs at most about twice a sort.
#include <algorithm>
#include <array>
#include <bit>
#include <iterator>

#include "collision/broad/bounds.h"
#include "collision/broad/broad_phase.h"
#include "collision/broad/pair_order.h"

namespace carom::collision {
namespace {

constexpr std::size_t kAxes = 3;

class SweepAndPrune final : public BroadPhase {
 public:
  explicit SweepAndPrune(Memory* m)
      : axes_{Array<End>(m), Array<End>(m), Array<End>(m)},
        now_(m),
        before_(m),
        seen_(m),
        member_(m),
        members_(m),
        joined_(m),
        passed_(m),
        met_(m),
        parted_(m),
        known_(m),
        spare_(m),
        active_(m),
        place_(m),
        order_(m) {}

  void find_pairs(const Colliders& table, std::uint64_t, const BroadSettings&, Array<Pair>& pairs) override {
    work_ = {};
    const bool kept = whole_;
    whole_ = false;  // stays so if an allocation fails half-way: the next call starts afresh
    if (!kept) clear();
    const bool left = take_in(table);
    if (!kept || !update(left)) rebuild();
    now_.swap(before_);
    whole_ = true;
    pairs.clear();
    for (const Pair& p : known_)
      if (may_touch(table, p.a, p.b)) pairs.push_back(p);
  }

 private:
  /// An end of a box on an axis. id = 2 slot + (1: upper end), so that box numbers are found at 3 id + axis.
  struct End {
    Real value;  // m
    std::uint32_t id;
    bool upper() const { return id & 1; }
    std::uint32_t slot() const { return id >> 1; }
    /// Lower ends first, then by slot, among equal values.
    std::uint32_t rank() const { return ((id & 1) << 31) | (id >> 1); }
    bool operator<(const End& o) const { return value < o.value || (value == o.value && rank() < o.rank()); }
  };

  void clear() {
    members_.clear();
    std::fill(member_.begin(), member_.end(), std::uint8_t(0));
  }

  /// An end that moved below an end of the other kind.
  struct Passing {
    std::uint32_t id;    // of the end that moved
    std::uint32_t slot;  // of the box whose end it passed
  };

  /// Copy the table's boxes and learn who is there: members are the live slots whose box is not empty. Whether they are
  /// the old ones is asked of the table itself, as it must be looked through anyhow.
  /// @return whether a member left
  bool take_in(const Colliders& table) {
    if (member_.size() < table.slots()) {
      now_.resize(6 * table.slots());
      before_.resize(6 * table.slots());
      seen_.resize(table.slots(), 0);
      place_.resize(table.slots());
      member_.resize(table.slots(), 0);  // last: its size says that all have theirs
    }
    ++calls_;
    joined_.clear();
    std::size_t stayed = 0;
    for (const std::uint32_t slot : table.active) {
      if (is_empty(table.bounds[slot])) continue;
      put_six(table.bounds[slot], &now_[6 * slot]);
      seen_[slot] = calls_;
      if (member_[slot]) {
        ++stayed;
      } else {
        joined_.push_back(slot);
      }
    }
    const bool left = stayed != members_.size();
    if (!left && joined_.empty()) return false;
    for (const std::uint32_t slot : members_) member_[slot] = seen_[slot] == calls_;
    members_.clear();
    for (const std::uint32_t slot : table.active) {
      if (seen_[slot] != calls_) continue;
      member_[slot] = 1;
      members_.push_back(slot);
    }
    return left;
  }

  /// Carry the last step's order over to the new boxes.
  /// @return false if it was worth too little; then axes and pairs are anything
  bool update(bool left) {
    const std::size_t n = members_.size(), log2n = static_cast<std::size_t>(std::bit_width(n)) + 1;
    if (left) {
      for (Array<End>& axis : axes_) std::erase_if(axis, [&](const End& e) { return seen_[e.slot()] != calls_; });
      std::erase_if(known_, [&](const Pair& p) { return seen_[p.a] != calls_ || seen_[p.b] != calls_; });
    }
    // A newcomer starts to the right of all others and has about 2 n exchanges before it on each axis; sorting afresh
    // costs about log2 n exchanges for each of 2 n ends.
    if (joined_.size() > log2n) return false;
    const Real none = std::numeric_limits<Real>::quiet_NaN();  // overlaps nothing: a newcomer had no pairs
    for (const std::uint32_t slot : joined_) {
      std::fill_n(&before_[6 * slot], 6, none);
      for (Array<End>& axis : axes_) axis.push_back({0, 2 * slot}), axis.push_back({0, 2 * slot + 1});
    }
    met_.clear();
    parted_.clear();
    const std::uint64_t budget = 2 * kAxes * n * log2n;
    for (std::size_t k = 0; k < kAxes; ++k)
      if (!insert_in_order(k, budget)) return false;
    merge_changes();
    return true;
  }

  /// Exchanges are noted first and judged afterwards: whether an upper end passed a lower one is a coin toss that a
  /// processor would lose half of the time, so it moves a counter instead of branching.
  bool insert_in_order(std::size_t k, std::uint64_t budget) {
    Array<End>& axis = axes_[k];
    std::size_t count = 0;
    for (std::size_t i = 0; i < axis.size(); ++i) {
      const End moving{now_[3 * axis[i].id + k], axis[i].id};
      axis[i] = moving;
      if (i == 0 || !(moving < axis[i - 1])) continue;
      if (passed_.size() < count + i) passed_.resize(2 * (count + i));
      Passing* next = passed_.data() + count;
      std::size_t j = i;
      do {
        const End other = axis[j - 1];
        *next = {moving.id, other.slot()};
        next += (moving.id ^ other.id) & 1;
        axis[j] = other;
        --j;
      } while (j > 0 && moving < axis[j - 1]);
      axis[j] = moving;
      count = static_cast<std::size_t>(next - passed_.data());
      work_.swaps += i - j;
      if (work_.swaps > budget) return false;
    }
    work_.tests += count;
    for (std::size_t i = 0; i < count; ++i) judge(passed_[i]);
    return true;
  }

  void judge(const Passing& p) {
    const bool parting = p.id & 1;
    const std::uint32_t s = p.id >> 1, t = p.slot;
    const Real* const boxes = (parting ? before_ : now_).data();
    if (overlap(boxes + 6 * s, boxes + 6 * t)) (parting ? parted_ : met_).push_back({std::min(s, t), std::max(s, t)});
  }

  /// A pair may have met, or parted, on up to three axes; never both, as one is judged by the new boxes alone.
  void merge_changes() {
    if (!parted_.empty()) {
      std::sort(parted_.begin(), parted_.end());
      spare_.clear();
      std::set_difference(known_.begin(), known_.end(), parted_.begin(), parted_.end(), std::back_inserter(spare_));
      known_.swap(spare_);
    }
    if (!met_.empty()) {
      std::sort(met_.begin(), met_.end());
      met_.erase(std::unique(met_.begin(), met_.end()), met_.end());
      spare_.clear();
      std::merge(known_.begin(), known_.end(), met_.begin(), met_.end(), std::back_inserter(spare_));
      known_.swap(spare_);
    }
  }

  /// Sort afresh and find all pairs by one sweep along the axis on which the boxes are spread the most.
  void rebuild() {
    work_.rebuilds = 1;
    for (std::size_t k = 0; k < kAxes; ++k) {
      axes_[k].clear();
      for (const std::uint32_t slot : members_)
        for (std::uint32_t id = 2 * slot; id <= 2 * slot + 1; ++id) axes_[k].push_back({now_[3 * id + k], id});
      std::sort(axes_[k].begin(), axes_[k].end());
    }
    known_.clear();
    active_.clear();
    for (const End& end : axes_[widest_axis()]) {
      const std::uint32_t slot = end.slot();
      if (end.upper()) {
        place_[active_.back()] = place_[slot];
        active_[place_[slot]] = active_.back();
        active_.pop_back();
        continue;
      }
      work_.tests += active_.size();
      for (const std::uint32_t other : active_)
        if (overlap(&now_[6 * slot], &now_[6 * other]))
          known_.push_back({std::min(slot, other), std::max(slot, other)});
      place_[slot] = static_cast<std::uint32_t>(active_.size());
      active_.push_back(slot);
    }
    order_.sort(known_, member_.size());
  }

  /// The axis along which the middle half of all ends spans the most: the fewest boxes stand abreast there.
  std::size_t widest_axis() const {
    std::size_t best = 0;
    Real span = -1;
    for (std::size_t k = 0; k < kAxes && !axes_[k].empty(); ++k) {
      // Quartiles, so that a few far-off or unbounded boxes decide nothing (inf - inf is NaN and loses).
      const Real s = axes_[k][axes_[k].size() * 3 / 4].value - axes_[k][axes_[k].size() / 4].value;
      if (s > span) span = s, best = k;
    }
    return best;
  }

  std::array<Array<End>, kAxes> axes_;
  Array<Real> now_, before_;      // [6 slots] m: boxes of this call and the last, lo x y z hi x y z
  Array<std::uint64_t> seen_;     // [slots] the last call in which the slot was a member
  Array<std::uint8_t> member_;    // [slots]
  Array<std::uint32_t> members_;  // ascending
  Array<std::uint32_t> joined_;   // members that were none in the last call
  Array<Passing> passed_;         // on one axis in this call, of which the first `count` mean something
  Array<Pair> met_, parted_;      // of this call
  Array<Pair> known_;             // all pairs of members whose boxes overlap, ascending
  Array<Pair> spare_;
  Array<std::uint32_t> active_;  // boxes that the sweep is inside of
  Array<std::uint32_t> place_;   // [slots] where a box stands in active_
  PairOrder order_;
  std::uint64_t calls_ = 0;
  bool whole_ = false;  // axes, members and pairs are those of before_
};

}  // namespace

Owned<BroadPhase> make_sweep_and_prune(Memory* memory) { return make_owned<BroadPhase, SweepAndPrune>(memory, memory); }

}  // namespace carom::collision
