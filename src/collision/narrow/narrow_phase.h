// Narrow phase: from pairs of bounds to contact points, remembering each pair from step to step.
#pragma once

#include <cstddef>

#include "collision/colliders.h"
#include "collision/manifold/patch.h"
#include "collision/narrow/query.h"
#include "core/block_array.h"
#include "core/jobs.h"

namespace carom::dynamics::snapshot {
class PairTableImage;  // dynamics/snapshot/pairs.cpp: to bytes and back
}

namespace carom::collision {

struct NarrowSettings {
  QuerySettings query;
  ManifoldSettings manifold;
  bool warm_separation = true;  // start a query from the pair's last separating direction
  Real carry_over = 0;          // bracket width, relative to the pair's size, up to which an earlier result is reused
};

/// All that is kept of a pair whose bounds overlap, but for certificates. What a pair at rest is asked for stands
/// first,
/// @see PairTable::fetch
struct alignas(64) PairRecord {
  QueryMemory memory;
  PatchMemory patch;
  Manifold manifold;

  /// As of a pair that nothing is known of. What says so is all that is written: the rest is not read.
  void clear() { memory = {}, patch.firm = false, manifold.count = 0, manifold.has_more_corners = false; }
};
static_assert(sizeof(PairRecord) == 512, "eight cache lines");

/// Records of the pairs of the current step, in ascending order of pair; a record survives as long as its bounds
/// overlap. Those of pairs that lie still can be inactive: kept, each by one or both of its colliders, but not gone
/// through. A pair has one record, or, where scenery touches on several sides, a run of them.
class PairTable {
 public:
  explicit PairTable(Memory* memory)
      : order_(memory),
        next_(memory),
        records_(memory),
        certificates_(memory),
        free_(memory),
        blocks_(memory),
        dropped_(memory),
        inactive_(memory),
        head_(memory) {}

  /// Keep records of pairs still there, take back inactive ones, start new ones, drop the rest. `pairs` ascending.
  /// Linear: both lists are sorted.
  void update(const Array<Pair>& pairs, Jobs* jobs = nullptr);
  /// A run of records of one pair, which is to have as many as wanted (at least one).
  struct Run {
    std::uint32_t first, count, wanted;
  };
  /// Records at the end of a run go, new ones come there. `runs` ascending; places before the first stay as they are.
  void resize_runs(const Array<Run>& runs);
  /// Forget everything that involves a collider (it was destroyed or its shape changed).
  void remove(std::uint32_t collider);
  void clear();
  /// Memory of lists that are longer than they need be. What is known of pairs stays.
  void give_back();

  enum Holder : std::uint8_t { none = 0, by_a = 1, by_b = 2 };
  /// Deactivate records of the current step until update() is asked for their pair again, or all their holders let go.
  /// @param holders  [size()] Holder bits: which of its colliders a record is inactive by; none: it is not
  /// @param slots    of colliders
  void deactivate(const Array<std::uint8_t>& holders, std::size_t slots);
  /// Drop what is still inactive by a collider.
  void release(std::uint32_t collider);
  std::size_t inactive_count() const { return inactive_count_; }
  /// Call f(pair, record) for every inactive record, in an order that follows from the history alone.
  template <class F>
  void each_inactive(F&& f) const {
    for (std::size_t r = 0; inactive_count_ > 0 && r < inactive_.size(); ++r)
      if (inactive_[r].holders != none) f(inactive_[r].pair, records_[r]);
  }
  struct Found {
    const PairRecord* record;
    const Certificate* certificate;
  };
  /// What is kept of a pair, inactive or not; null if there is nothing.
  Found find(const Pair& pair) const;

  std::size_t size() const { return order_.size(); }
  PairRecord& operator[](std::size_t i) { return records_[order_[i].record]; }
  const PairRecord& operator[](std::size_t i) const { return records_[order_[i].record]; }

  /// Certificates take memory from here on.
  void keep_certificates() {
    if (certificates_.size() < records_.size()) core::grow_to(certificates_, records_.size());
  }
  /// Null until keep_certificates().
  Certificate* certificate(std::size_t i) { return certificate_of(order_[i].record); }

  /// What a step asks of every pair, side by side: records are large, and most pairs do not touch.
  struct Place {
    Pair pair;
    std::uint32_t record;
    std::uint32_t points = 0;   // of the record's manifold
    Real horizon = -kInfinity;  // m: out of reach while travels and reach of both are below, @see narrow_phase()
  };
  Place& place(std::size_t i) { return order_[i]; }
  const Place& place(std::size_t i) const { return order_[i]; }
  /// Bring the patch and the points of a pair that touches nearer: records of a step are more than the second cache
  /// holds.
  /// @param i  may be past the end
  void fetch(std::size_t i) const {
    if (i >= order_.size() || order_[i].points == 0) return;
    const auto* const record = reinterpret_cast<const char*>(&records_[order_[i].record]);
    const std::size_t end =
        offsetof(PairRecord, manifold) + offsetof(Manifold, point) + order_[i].points * sizeof(ContactPoint);
    for (std::size_t at = 0; at < end; at += 64) __builtin_prefetch(record + at);
  }
  /// No pair is to be taken for out of reach before it is asked once more: how pairs are asked may have changed.
  void ask_all() {
    for (Place& p : order_) p.horizon = -kInfinity;
  }

 private:
  friend class dynamics::snapshot::PairTableImage;
  static constexpr std::uint32_t kNew = 0xFFFFFFFFu;
  /// An inactive record stands in a list of each collider that holds it.
  struct Inactive {
    Pair pair{};
    std::uint32_t next[2] = {kNew, kNew};  // record after this one in the list of A, of B
    std::uint32_t at = 0;                  // its place when it was inactive: orders the records of a run
    std::uint8_t holders = none;
  };
  std::uint32_t& next_in_list(std::uint32_t record, std::uint32_t collider) {
    return inactive_[record].next[inactive_[record].pair.b == collider];
  }
  std::uint32_t find_inactive(const Pair& pair) const;
  void unpark(std::uint32_t record);
  bool take_back(const Pair& pair);
  std::uint32_t fresh_record();
  /// Pairs of this step, and old places beside them, that one thread has to itself.
  struct Block {
    std::size_t first, last, old, old_end;  // of pairs, of order_
    std::size_t dropped;                    // of those old places, how many go
    bool has_new, has_run;                  // pairs without an old place; with several
  };
  void update_runs(const Array<Pair>& pairs);
  void update_block(const Array<Pair>& pairs, Block& block);
  Certificate* certificate_of(std::uint32_t record) {
    return record < certificates_.size() ? &certificates_[record] : nullptr;
  }
  const Certificate* certificate_of(std::uint32_t record) const {
    return record < certificates_.size() ? &certificates_[record] : nullptr;
  }

  Array<Place> order_, next_;  // by ascending pair
  core::BlockArray<PairRecord, 4> records_;
  Array<Certificate> certificates_;  // by record; empty until results are reused
  Array<std::uint32_t> free_;
  Array<Block> blocks_;
  Array<std::uint32_t> dropped_;  // records, by block from its first old place on: scratch
  bool has_runs_ = false;         // some pair had several records, when all were last gone through
  Array<Inactive> inactive_;      // by record; empty until the first is inactive
  Array<std::uint32_t> head_;     // by collider: the first record that it deactivates, or kNew
  std::size_t inactive_count_ = 0;
};

struct NarrowReport {
  std::uint64_t gjk_calls = 0, epa_calls = 0, support_calls = 0, reused = 0;
  std::uint64_t kept_patches = 0;  // pairs that moved too little to be asked again

  NarrowReport& operator+=(const NarrowReport& other) {
    gjk_calls += other.gjk_calls, epa_calls += other.epa_calls, support_calls += other.support_calls;
    reused += other.reused, kept_patches += other.kept_patches;
    return *this;
  }
};

/// Bring every record's manifold up to date with the colliders' frames. A pair whose support function misbehaves gets
/// no points, and its fault is appended.
///
/// A pair that was found apart by a gap g is not asked again before its colliders can have closed it:
///   g - (travels now - travels then) > reach   <=>   travels now + reach < horizon,  horizon = g + travels then
/// It would be found without points again. What it leaves out is where a generic query would have moved its start to.
/// @param jobs  null, or who shares the loop; shapes of the host's thread are still asked on the calling one
void narrow_phase(const Colliders& table, const NarrowSettings& settings, PairTable& pairs, NarrowReport& report,
                  Array<SupportFault>& faults, Jobs* jobs = nullptr);

/// Candidates of one pair: double dispatch over the two forms, the generic path where no specific routine fits.
/// @param certificate  null: no result is reused
void collide(const Shape& a, const Frame& frame_a, const Shape& b, const Frame& frame_b, const NarrowSettings& settings,
             QueryMemory& memory, Certificate* certificate, Candidates& found, NarrowReport& report,
             SupportFault& fault);

}  // namespace carom::collision
