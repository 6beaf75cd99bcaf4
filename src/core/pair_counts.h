// A small set of unordered pairs of slots, each counted: who is in it more than once stays until all have let go.
#pragma once

#include <algorithm>
#include <cstdint>

#include "core/memory.h"

namespace carom::core {

/// Open addressing over a power of two, at most half full. An empty one owns no memory and decides with one comparison.
class PairCounts {
 public:
  explicit PairCounts(Memory* m) : entries_(m) {}

  bool empty() const { return size_ == 0; }
  std::size_t size() const { return size_; }
  bool has(std::uint32_t a, std::uint32_t b) const { return size_ > 0 && entries_[find(key(a, b))].count > 0; }

  /// Reserve so many pairs more, so that add() cannot fail.
  void reserve(std::size_t more = 1) {
    std::size_t size = std::max<std::size_t>(16, entries_.size());
    while (size < 2 * (size_ + more)) size *= 2;
    if (size == entries_.size()) return;
    Array<Entry> old(size, Entry{}, entries_.get_allocator());
    old.swap(entries_);
    for (const Entry& e : old)
      if (e.count > 0) entries_[find(e.key)] = e;
  }
  void add(std::uint32_t a, std::uint32_t b) {
    Entry& e = entries_[find(key(a, b))];
    size_ += e.count == 0;
    e.key = key(a, b);
    ++e.count;
  }
  void remove(std::uint32_t a, std::uint32_t b) {
    if (!has(a, b)) return;
    const std::size_t at = find(key(a, b));
    if (--entries_[at].count == 0) close(at);
  }
  /// All pairs that one is in.
  void remove(std::uint32_t slot) {
    for (std::size_t i = 0; size_ > 0 && i < entries_.size();) {
      const Entry& e = entries_[i];
      if (e.count > 0 && (e.key >> 32 == slot || (e.key & 0xFFFFFFFFu) == slot))
        close(i);  // another may have moved in here
      else
        ++i;
    }
  }

  struct Entry {
    std::uint64_t key = 0;    // lower slot, higher slot
    std::uint32_t count = 0;  // 0: free
  };
  /// The entries one after the other, in an order that means nothing. @param at  0 for the first; moved on
  const Entry& next(std::size_t& at) const {
    while (entries_[at].count == 0) ++at;
    return entries_[at++];
  }
  /// There is capacity. @param key  of an entry
  void put(std::uint64_t key, std::uint32_t count) {
    Entry& e = entries_[find(key)];
    size_ += e.count == 0;
    e = {key, count};
  }
  void clear() {
    for (Entry& e : entries_) e.count = 0;
    size_ = 0;
  }

 private:
  static std::uint64_t key(std::uint32_t a, std::uint32_t b) {
    return static_cast<std::uint64_t>(std::min(a, b)) << 32 | std::max(a, b);
  }
  std::size_t home(std::uint64_t key) const {
    return static_cast<std::size_t>((key ^ key >> 29) * 0x9E3779B97F4A7C15ull >> 20) & (entries_.size() - 1);
  }
  /// Where a key is, or where it would go.
  std::size_t find(std::uint64_t key) const {
    std::size_t at = home(key);
    while (entries_[at].count > 0 && entries_[at].key != key) at = (at + 1) & (entries_.size() - 1);
    return at;
  }
  /// Free a place, and move those up that were turned away from it.
  void close(std::size_t hole) {
    const std::size_t mask = entries_.size() - 1;
    --size_;
    entries_[hole].count = 0;
    for (std::size_t at = (hole + 1) & mask; entries_[at].count > 0; at = (at + 1) & mask) {
      const std::size_t wanted = home(entries_[at].key);
      if (((at - wanted) & mask) < ((at - hole) & mask)) continue;  // it stands between its home and the hole's end
      entries_[hole] = entries_[at];
      entries_[at].count = 0;
      hole = at;
    }
  }

  Array<Entry> entries_;
  std::size_t size_ = 0;
};

}  // namespace carom::core
