// Narrow phase: from pairs of bounds to contact points, remembering each pair from step to step.
#pragma once

#include "collision/colliders.h"
#include "collision/manifold/patch.h"
#include "collision/narrow/query.h"

namespace carom {

struct NarrowSettings {
  QuerySettings query;
  ManifoldSettings manifold;
  bool warm_separation = true;  // start a query from the pair's last separating direction
  Real carry_over = 0;          // bracket width, relative to the pair's size, up to which an earlier answer is carried over
};

/// All that is kept of a pair whose bounds overlap.
struct PairRecord {
  Pair pair{};
  QueryMemory memory;
  Manifold manifold;
  PatchMemory patch;
};

/// Records of the pairs of the current step, in ascending order of pair; a record survives as long as its bounds overlap.
class PairTable {
 public:
  explicit PairTable(Memory* memory) : order_(memory), next_(memory), records_(memory), free_(memory) {}

  /// Keep records of pairs still there, start new ones, drop the rest. `pairs` ascending. Linear: both lists are sorted.
  void update(const Array<Pair>& pairs);
  /// Forget everything that involves a collider (it was destroyed or its shape changed).
  void forget(std::uint32_t collider);
  void clear();

  std::size_t size() const { return order_.size(); }
  PairRecord& operator[](std::size_t i) { return records_[order_[i]]; }
  const PairRecord& operator[](std::size_t i) const { return records_[order_[i]]; }

 private:
  static constexpr std::uint32_t kNew = 0xFFFFFFFFu;
  Array<std::uint32_t> order_, next_;  // record indices, by ascending pair
  Array<PairRecord> records_;
  Array<std::uint32_t> free_;
};

struct NarrowReport {
  std::uint64_t gjk_calls = 0, epa_calls = 0, support_calls = 0, carried = 0;
  std::uint64_t kept_patches = 0;  // pairs that moved too little to be asked again
};

/// Bring every record's manifold up to date with the colliders' frames. A pair whose support function misbehaves gets no points, and
/// its fault is appended.
void narrow_phase(const Colliders& table, const NarrowSettings& settings, PairTable& pairs, NarrowReport& report,
                  Array<SupportFault>& faults);

/// Candidates of one pair: double dispatch over the two forms, the generic path where no specific routine fits.
void collide(const Shape& a, const Frame& frame_a, const Shape& b, const Frame& frame_b, const NarrowSettings& settings,
             QueryMemory& memory, Candidates& found, NarrowReport& report, SupportFault& fault);

}  // namespace carom
