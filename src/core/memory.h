// Memory: every array of an engine draws from the host's allocator through one resource.
#pragma once

#include <algorithm>
#include <memory>
#include <memory_resource>
#include <utility>
#include <vector>

#include "core/layers.h"

namespace carom::core {

using Memory = std::pmr::memory_resource;

/// A growing array that draws from an engine's memory. Modules that live in a world take a Memory* and build theirs on
/// it.
template <class T>
using Array = std::pmr::vector<T>;

/// Capacity for an array of n elements that may grow on: an eighth more. Doubling would leave a third of it idle.
inline std::size_t with_slack(std::size_t n) { return std::max<std::size_t>(16, n + n / 8); }

/// Resize an array that grows on from step to step.
template <class A, class... Value>
void grow_to(A& array, std::size_t n, const Value&... value) {
  if (n > array.capacity()) array.reserve(with_slack(n));
  array.resize(n, value...);
}

/// Likewise of one that is written anew: where it grows its elements are not kept.
template <class A>
void remake(A& array, std::size_t n) {
  if (n > array.capacity()) array.clear(), array.reserve(with_slack(n));
  array.resize(n);
}

/// Reserve one more element at `slot`, so that the resize after it cannot fail.
template <class... A>
void reserve_slot(std::size_t slot, A&... arrays) {
  const auto grow = [slot](auto& a) {
    if (a.capacity() <= slot) a.reserve(with_slack(slot + 1));
  };
  (grow(arrays), ...);
}

/// Destroys what make_owned() made; remembers the size, since a base class does not know it.
template <class T>
struct OwnedDelete {
  Memory* memory = nullptr;
  std::uint32_t size = 0, alignment = 0;
  void operator()(T* object) const {
    object->~T();
    memory->deallocate(object, size, alignment);
  }
};

/// The one owner of an object on an engine's memory.
template <class T>
using Owned = std::unique_ptr<T, OwnedDelete<T>>;

/// Likewise, of what is part of its owner: const where that is.
template <class T>
class Kept {
 public:
  Kept(Owned<T> owned) : owned_(std::move(owned)) {}
  T& operator*() { return *owned_; }
  T* operator->() { return owned_.get(); }
  const T& operator*() const { return *owned_; }
  const T* operator->() const { return owned_.get(); }

 private:
  Owned<T> owned_;
};

/// Make a T, owned as a T or as its (first) base. Nothing is leaked if its constructor throws.
template <class Base, class T = Base, class... Args>
Owned<Base> make_owned(Memory* memory, Args&&... args) {
  return Owned<Base>(std::pmr::polymorphic_allocator<>(memory).new_object<T>(std::forward<Args>(args)...),
                     {memory, static_cast<std::uint32_t>(sizeof(T)), static_cast<std::uint32_t>(alignof(T))});
}

}  // namespace carom::core
