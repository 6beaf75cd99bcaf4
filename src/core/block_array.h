// An array that grows by blocks: what is in it stays where it is, so that growing copies nothing and leaves no more
// than a block idle.
#pragma once

#include <memory>
#include <type_traits>

#include "core/memory.h"

namespace carom::core {

/// @tparam kShift  2^kShift elements to a block
template <class T, int kShift>
class BlockArray {
  static_assert(std::is_trivially_destructible_v<T>);
  static constexpr std::size_t kBlock = std::size_t(1) << kShift;

 public:
  explicit BlockArray(Memory* memory) : blocks_(memory) {}
  BlockArray(const BlockArray&) = delete;
  BlockArray& operator=(const BlockArray&) = delete;
  ~BlockArray() {
    for (T* const block : blocks_) memory()->deallocate(block, kBlock * sizeof(T), alignof(T));
  }

  std::size_t size() const { return size_; }
  std::size_t capacity() const { return blocks_.size() * kBlock; }
  T& operator[](std::size_t i) { return blocks_[i >> kShift][i & (kBlock - 1)]; }
  const T& operator[](std::size_t i) const { return blocks_[i >> kShift][i & (kBlock - 1)]; }

  void reserve(std::size_t n) {
    while (capacity() < n) {
      reserve_slot(blocks_.size(), blocks_);
      blocks_.push_back(static_cast<T*>(memory()->allocate(kBlock * sizeof(T), alignof(T))));
    }
  }
  /// Those that are new are T().
  void resize(std::size_t n) {
    reserve(n);
    for (; size_ < n; ++size_) std::construct_at(&(*this)[size_]);
    size_ = n;
  }
  /// Its blocks stay.
  void clear() { size_ = 0; }

 private:
  Memory* memory() const { return blocks_.get_allocator().resource(); }

  Array<T*> blocks_;
  std::size_t size_ = 0;
};

}  // namespace carom::core
