// Fat boxes of a broad phase by trees: larger than the bounds by a share of their size, and ahead of what moves.
//
// A fat box is larger on each side by a share of its extent along that axis, so that a plate stays thin. Every body
// learns its share: left within kReview steps, the box was too small, and the share doubles; not left for so long, it
// falls to a third. Larger shares: fewer bodies leave their box; smaller ones: fewer candidates to filter, which are
// twice the pairs at 0.13.
#pragma once

#include <algorithm>
#include <limits>

#include "collision/colliders.h"

namespace carom::collision {

class FatBoxes {
 public:
  static constexpr std::uint64_t kReview = 32;  // calls

  explicit FatBoxes(Memory* m) : of(m), from_(m), share_(m), since_(m), extent_(m) {}

  Array<Aabb> of;  // [slots] m; the bounds themselves unless it can move

  void grow(std::size_t slots) { of.resize(slots), from_.resize(slots), share_.resize(slots), since_.resize(slots); }
  void clear() { std::fill(of.begin(), of.end(), Aabb()); }
  void begin_call() { ++calls_; }
  std::uint64_t calls() const { return calls_; }

  /// @param moves  it is of the tree of what can move   @param known  it was there in the last call, too
  void fatten(const Aabb& box, std::uint32_t slot, bool moves, bool known) {
    if (!moves) {
      of[slot] = box;
    } else if (!known) {
      share_[slot] = kFirst;
      of[slot] = fattened(box, Vec3::zero(), kFirst);
    } else {
      Real& share = share_[slot];
      if (calls_ - since_[slot] < kReview) share = std::min(kMost, 2 * share);
      of[slot] = fattened(box, motion(box, slot), share);
    }
    from_[slot] = 0.5 * box.lo + 0.5 * box.hi;
    since_[slot] = calls_;
  }

  /// Whether a box that was not left for long, or that reaches ahead of a body at rest, should shrink.
  bool bloated(const Aabb& box, std::uint32_t slot) const {
    if (calls_ - since_[slot] < kReview) return false;
    const Aabb wanted = fattened(box, motion(box, slot), calmer(share_[slot]));
    const auto sides = [](const Aabb& x) { return (x.hi - x.lo).sum(); };
    return sides(of[slot]) - sides(box) > kBloated * (sides(wanted) - sides(box));
  }
  /// What its fat box holds on to is known, so that no box needs a test.
  void shrink(const Aabb& box, std::uint32_t slot) {
    const Aabb old = of[slot];
    share_[slot] = calmer(share_[slot]);
    of[slot] = fattened(box, motion(box, slot), share_[slot]);
    of[slot].lo = of[slot].lo.max(old.lo), of[slot].hi = of[slot].hi.min(old.hi);
    from_[slot] = 0.5 * box.lo + 0.5 * box.hi;
    since_[slot] = calls_;
  }

  /// The usual size: mean of the longest sides of what moves, the longest twentieth set aside.
  /// @param slots  of the table
  void measure(const Colliders& table, const Array<std::uint32_t>& slots) {
    extent_.clear();
    for (const std::uint32_t slot : slots)
      if (table.movable[slot] && !is_empty(table.bounds[slot])) {
        const Real extent = (table.bounds[slot].hi - table.bounds[slot].lo).max_entry();
        if (extent < kInfinity) extent_.push_back(extent);
      }
    const auto n = static_cast<std::ptrdiff_t>(extent_.size()), kept = n - n / 20;
    if (kept < n) std::nth_element(extent_.begin(), extent_.begin() + kept, extent_.end());
    usual_ = 0;  // divided first: the sum of finite numbers may not be finite
    for (std::ptrdiff_t i = 0; i < kept; ++i) usual_ += extent_[static_cast<std::size_t>(i)] / static_cast<Real>(kept);
  }

 private:
  static constexpr Real kLeast = 0.01, kMost = 0.08, kFirst = 0.06;
  /// Not more than this share of the usual size: else something huge would have all crumbs near it for candidates.
  static constexpr Real kUsual = 0.25;
  /// How many steps ahead a fat box reaches along the motion, up to its own extent.
  static constexpr Real kAhead = 12;
  /// A smaller fat box is given if it adds to the bounds less than the old one by this factor: for less, no work.
  static constexpr Real kBloated = 1.9;

  static Real calmer(Real share) { return std::max(kLeast, share / 3); }
  /// m a step, in the mean since the fat box was made
  Vec3 motion(const Aabb& box, std::uint32_t slot) const {
    return (0.5 * box.lo + 0.5 * box.hi - from_[slot]) / static_cast<Real>(calls_ - since_[slot]);
  }
  /// @param motion  m a step
  Aabb fattened(const Aabb& box, const Vec3& motion, Real share) const {
    const Vec3 extent = box.hi - box.lo;
    // What crosses its own size in a step leaves any fat box in the next: it gets none.
    if (!motion.abs().all_within(extent)) return box;
    constexpr Real most = std::numeric_limits<Real>::max();
    Aabb fat;
    for (int k = 0; k < 3; ++k) {
      const Real margin = std::min(share * extent[k], kUsual * usual_);
      const Real ahead = std::clamp(kAhead * motion[k], -extent[k], extent[k]);
      fat.lo[k] = std::max(box.lo[k] - margin + std::min(ahead, Real(0)), -most);
      fat.hi[k] = std::min(box.hi[k] + margin + std::max(ahead, Real(0)), most);
    }
    return fat;
  }

  Array<Vec3> from_;            // [slots] m, centre when the fat box was made
  Array<Real> share_;           // [slots] see kLeast
  Array<std::uint64_t> since_;  // [slots] the call in which it was made
  Array<Real> extent_;          // m
  Real usual_ = 0;              // m
  std::uint64_t calls_ = 0;
};

}  // namespace carom::collision
