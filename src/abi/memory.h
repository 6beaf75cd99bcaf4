// The host's allocator as a resource that the arrays of an engine and its worlds draw from.
#pragma once

#include <carom/engine.h>

#include <new>

#include "abi/guard.h"
#include "core/memory.h"

namespace carom::abi {

/// Throws std::bad_alloc where the host returns NULL. As thread-safe as the host's functions are.
class HostMemory final : public Memory {
 public:
  explicit HostMemory(const carom_engine_desc& desc) : alloc_(desc.alloc), free_(desc.free), user_(desc.alloc_user) {}

 private:
  void* do_allocate(std::size_t size, std::size_t alignment) override {
    void* p = alloc_ ? call_host([&] { return alloc_(user_, size, alignment); })
                     : ::operator new(size, std::align_val_t(alignment));
    if (!p) throw std::bad_alloc();
    return p;
  }
  void do_deallocate(void* p, std::size_t size, std::size_t alignment) override {
    if (free_)
      free_(user_, p, size, alignment);
    else
      ::operator delete(p, std::align_val_t(alignment));
  }
  bool do_is_equal(const Memory& other) const noexcept override { return this == &other; }

  void* (*alloc_)(void*, std::uint64_t, std::uint64_t);
  void (*free_)(void*, void*, std::uint64_t, std::uint64_t);
  void* user_;
};

/// An object on an engine's memory. Nothing is leaked if its constructor throws.
template <class T, class... Args>
T* make_on(Memory* memory, Args&&... args) {
  return std::pmr::polymorphic_allocator<>(memory).new_object<T>(static_cast<Args&&>(args)...);
}

template <class T>
void destroy_on(Memory* memory, T* object) {
  if (object) std::pmr::polymorphic_allocator<>(memory).delete_object(object);
}

}  // namespace carom::abi
