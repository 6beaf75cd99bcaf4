// Records of pairs, matched to the broad phase's list by merging two sorted lists.
#include "collision/narrow/narrow_phase.h"

namespace carom {

void PairTable::update(const Array<Pair>& pairs) {
  next_.clear();
  next_.reserve(pairs.size());
  free_.reserve(records_.size() + pairs.size());
  std::size_t old = 0;
  for (const Pair& p : pairs) {
    while (old < order_.size() && records_[order_[old]].pair < p) free_.push_back(order_[old++]);
    if (old < order_.size() && records_[order_[old]].pair == p) {
      next_.push_back(order_[old++]);
      continue;
    }
    next_.push_back(kNew);
  }
  while (old < order_.size()) free_.push_back(order_[old++]);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (next_[i] != kNew) continue;
    if (free_.empty()) {
      next_[i] = static_cast<std::uint32_t>(records_.size());
      records_.emplace_back();
    } else {
      next_[i] = free_.back();
      free_.pop_back();
      records_[next_[i]] = PairRecord{};
    }
    records_[next_[i]].pair = pairs[i];
  }
  order_.swap(next_);
}

void PairTable::forget(std::uint32_t collider) {
  free_.reserve(records_.size());
  std::size_t kept = 0;
  for (const std::uint32_t r : order_) {
    if (records_[r].pair.a == collider || records_[r].pair.b == collider)
      free_.push_back(r);
    else
      order_[kept++] = r;
  }
  order_.resize(kept);
}

void PairTable::clear() {
  order_.clear();
  records_.clear();
  free_.clear();
}

}  // namespace carom
