// Counts the bytes an engine holds, as the C library hands them out: an allocator for every engine's hook.
#pragma once

#include <malloc.h>

#include <atomic>
#include <cstddef>
#include <cstdlib>

namespace carom::bench {

inline std::atomic<std::size_t> live_bytes = 0;  // engines with threads allocate from all of them

inline void* counted(void* block) {
  if (block) live_bytes.fetch_add(malloc_usable_size(block), std::memory_order_relaxed);
  return block;
}
inline void uncounted(void* block) {
  if (block) live_bytes.fetch_sub(malloc_usable_size(block), std::memory_order_relaxed);
}
inline void* counted_alloc(std::size_t size) { return counted(std::malloc(size)); }
/// @param alignment  a power of two
inline void* counted_aligned_alloc(std::size_t size, std::size_t alignment) {
  void* block = nullptr;
  if (alignment <= alignof(std::max_align_t)) return counted_alloc(size);
  return posix_memalign(&block, alignment, size) ? nullptr : counted(block);
}
inline void counted_free(void* block) {
  uncounted(block);
  std::free(block);
}
inline void* counted_realloc(void* block, std::size_t size) {
  uncounted(block);
  return counted(std::realloc(block, size));
}

}  // namespace carom::bench
