// Records of pairs, matched to the broad phase's list by merging two sorted lists; and the lists of inactive ones.
#include <algorithm>
#include <utility>

#include "collision/narrow/narrow_phase.h"

namespace carom::collision {

void PairTable::update(const Array<Pair>& pairs, Jobs* jobs) {
  constexpr std::size_t kKeptAPart = 2048;
  if (!jobs || pairs.size() <= kKeptAPart || has_runs_ || inactive_count_ > 0) return update_runs(pairs);
  const std::size_t n = pairs.size();
  next_.resize(n), free_.reserve(records_.size() + n), dropped_.resize(order_.size());
  blocks_.resize((n + kKeptAPart - 1) / kKeptAPart);
  std::size_t old = 0;
  for (std::size_t i = 0; i < blocks_.size(); ++i) {
    const std::size_t first = i * kKeptAPart, last = std::min(first + kKeptAPart, n);
    const auto before = [](const Place& place, const Pair& p) { return place.pair < p; };
    const auto end = last < n ? std::lower_bound(order_.begin(), order_.end(), pairs[last], before) : order_.end();
    blocks_[i] = {first, last, old, static_cast<std::size_t>(end - order_.begin()), 0, false, false};
    old = blocks_[i].old_end;
  }
  core::in_parallel(jobs, blocks_.size(), 1, [&](std::uint32_t i) { update_block(pairs, blocks_[i]); });
  if (std::ranges::any_of(blocks_, &Block::has_run)) return update_runs(pairs);
  for (const Block& b : blocks_)
    free_.insert(free_.end(), dropped_.begin() + static_cast<std::ptrdiff_t>(b.old),
                 dropped_.begin() + static_cast<std::ptrdiff_t>(b.old + b.dropped));
  for (const Block& b : blocks_)
    for (std::size_t i = b.first; b.has_new && i < b.last; ++i)
      if (next_[i].record == kNew) next_[i].record = fresh_record();
  order_.swap(next_);
}

void PairTable::update_block(const Array<Pair>& pairs, Block& block) {
  std::size_t old = block.old;
  std::uint32_t* dropped = dropped_.data() + block.old;
  for (std::size_t i = block.first; i < block.last; ++i) {
    while (old < block.old_end && order_[old].pair < pairs[i]) *dropped++ = order_[old++].record;
    const bool is_new = old == block.old_end || !(order_[old].pair == pairs[i]);
    next_[i] = is_new ? Place{pairs[i], kNew} : order_[old++];
    block.has_new |= is_new;
    block.has_run |= !is_new && old < block.old_end && order_[old].pair == pairs[i];
  }
  while (old < block.old_end) *dropped++ = order_[old++].record;
  block.dropped = static_cast<std::size_t>(dropped - (dropped_.data() + block.old));
}

/// Likewise where a pair may have several records, or inactive ones that are taken back.
void PairTable::update_runs(const Array<Pair>& pairs) {
  next_.clear();
  next_.reserve(pairs.size());
  free_.reserve(records_.size() + pairs.size());
  has_runs_ = false;
  std::size_t old = 0;
  for (const Pair& p : pairs) {
    while (old < order_.size() && order_[old].pair < p) free_.push_back(order_[old++].record);
    if (old == order_.size() || !(order_[old].pair == p)) {
      if (!take_back(p)) next_.push_back({p, kNew});
      continue;
    }
    do next_.push_back(order_[old++]);
    while (old < order_.size() && order_[old].pair == p);
  }
  while (old < order_.size()) free_.push_back(order_[old++].record);
  has_runs_ = next_.size() > pairs.size();
  for (Place& place : next_)
    if (place.record == kNew) place.record = fresh_record();
  order_.swap(next_);
}

/// Inactive records of a pair, into next_ in the order that they had.
bool PairTable::take_back(const Pair& pair) {
  const std::size_t before = next_.size();
  for (std::uint32_t inactive; (inactive = find_inactive(pair)) != kNew;) {
    unpark(inactive);
    next_.push_back({pair, inactive, static_cast<std::uint32_t>(records_[inactive].manifold.count)});
  }
  if (next_.size() - before > 1)
    std::sort(next_.begin() + static_cast<std::ptrdiff_t>(before), next_.end(),
              [&](const Place& a, const Place& b) { return inactive_[a.record].at < inactive_[b.record].at; });
  return next_.size() > before;
}

std::uint32_t PairTable::fresh_record() {
  std::uint32_t r;
  if (free_.empty()) {
    r = static_cast<std::uint32_t>(records_.size());
    records_.resize(r + std::size_t(1));
  } else {
    r = free_.back();
    free_.pop_back();
    records_[r].clear();
    if (Certificate* const old = certificate_of(r)) *old = Certificate{};
  }
  return r;
}

void PairTable::resize_runs(const Array<Run>& runs) {
  next_.clear();
  std::size_t come = 0, from = 0;
  for (const Run& run : runs) come += run.wanted;
  next_.reserve(order_.size() + come);
  free_.reserve(records_.size() + come);
  records_.reserve(records_.size() + come);
  const auto copy_up_to = [&](std::size_t end) {
    next_.insert(next_.end(), order_.begin() + static_cast<std::ptrdiff_t>(from),
                 order_.begin() + static_cast<std::ptrdiff_t>(end));
    from = end;
  };
  for (const Run& run : runs) {
    copy_up_to(run.first + std::min(run.count, run.wanted));
    for (; from < run.first + run.count; ++from) free_.push_back(order_[from].record);
    const Pair pair = order_[run.first].pair;
    for (std::uint32_t k = run.count; k < run.wanted; ++k) next_.push_back({pair, fresh_record()});
  }
  copy_up_to(order_.size());
  order_.swap(next_);
}

void PairTable::remove(std::uint32_t collider) {
  free_.reserve(records_.size());
  std::size_t kept = 0;
  for (const Place& place : order_) {
    if (place.pair.a == collider || place.pair.b == collider)
      free_.push_back(place.record);
    else
      order_[kept++] = place;
  }
  order_.resize(kept);
  release(collider);
  for (std::uint32_t r = 0; inactive_count_ > 0 && r < inactive_.size(); ++r)  // those that only the other one holds
    if (inactive_[r].holders != none && (inactive_[r].pair.a == collider || inactive_[r].pair.b == collider)) {
      unpark(r);
      free_.push_back(r);
    }
}

void PairTable::deactivate(const Array<std::uint8_t>& holders, std::size_t slots) {
  inactive_.resize(records_.size());
  if (head_.size() < slots) head_.resize(slots, kNew);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < order_.size(); ++i) {
    const std::uint32_t r = order_[i].record;
    inactive_[r].holders = holders[i];
    inactive_[r].pair = order_[i].pair;
    inactive_[r].at = static_cast<std::uint32_t>(i);
    if (holders[i] == none) {
      order_[kept++] = order_[i];
      continue;
    }
    ++inactive_count_;
    const Pair& p = order_[i].pair;
    if (holders[i] & by_a) inactive_[r].next[0] = std::exchange(head_[p.a], r);
    if (holders[i] & by_b) inactive_[r].next[1] = std::exchange(head_[p.b], r);
  }
  order_.resize(kept);
}

/// Lists are short: a collider has few neighbours, and what lies still under many (a floor) holds none of them.
void PairTable::unpark(std::uint32_t record) {
  const Pair p = inactive_[record].pair;
  const auto leave = [&](std::uint32_t collider) {
    std::uint32_t* link = &head_[collider];
    while (*link != record) link = &next_in_list(*link, collider);
    *link = next_in_list(record, collider);
  };
  if (inactive_[record].holders & by_a) leave(p.a);
  if (inactive_[record].holders & by_b) leave(p.b);
  inactive_[record].holders = none;
  inactive_[record].next[0] = inactive_[record].next[1] = kNew;
  --inactive_count_;
}

std::uint32_t PairTable::find_inactive(const Pair& pair) const {
  if (inactive_count_ == 0) return kNew;
  for (const std::uint32_t collider : {pair.a, pair.b}) {
    std::uint32_t r = collider < head_.size() ? head_[collider] : kNew;
    while (r != kNew && !(inactive_[r].pair == pair)) r = inactive_[r].next[inactive_[r].pair.b == collider];
    if (r != kNew) return r;
  }
  return kNew;
}

void PairTable::release(std::uint32_t collider) {
  if (collider >= head_.size()) return;
  free_.reserve(records_.size());
  while (head_[collider] != kNew) {
    const std::uint32_t r = head_[collider];
    unpark(r);
    free_.push_back(r);
  }
}

PairTable::Found PairTable::find(const Pair& pair) const {
  const auto found = [&](std::uint32_t record) -> Found { return {&records_[record], certificate_of(record)}; };
  const auto before = [](const Place& place, const Pair& p) { return place.pair < p; };
  const auto at = std::lower_bound(order_.begin(), order_.end(), pair, before);
  if (at != order_.end() && at->pair == pair) return found(at->record);
  const std::uint32_t inactive = find_inactive(pair);
  return inactive == kNew ? Found{nullptr, nullptr} : found(inactive);
}

void PairTable::clear() {
  order_.clear();
  records_.clear();
  certificates_.clear();
  free_.clear();
  inactive_.clear();
  head_.clear();
  inactive_count_ = 0;
}

void PairTable::give_back() {
  next_.clear(), dropped_.clear(), blocks_.clear();
  order_.shrink_to_fit(), next_.shrink_to_fit(), dropped_.shrink_to_fit(), blocks_.shrink_to_fit();
}

}  // namespace carom::collision
