// Counts the bytes an engine holds, as the C library hands them out: an allocator for every engine's hook.
#pragma once

#include <malloc.h>

#include <cstddef>
#include <cstdlib>

namespace carom::bench {

inline std::size_t live_bytes = 0;

inline void* counted(void* block) {
  if (block) live_bytes += malloc_usable_size(block);
  return block;
}
inline void* counted_alloc(std::size_t size) { return counted(std::malloc(size)); }
/// @param alignment  a power of two
inline void* counted_aligned_alloc(std::size_t size, std::size_t alignment) {
  void* block = nullptr;
  if (alignment <= alignof(std::max_align_t)) return counted_alloc(size);
  return posix_memalign(&block, alignment, size) ? nullptr : counted(block);
}
inline void counted_free(void* block) {
  if (block) live_bytes -= malloc_usable_size(block);
  std::free(block);
}
inline void* counted_realloc(void* block, std::size_t size) {
  if (block) live_bytes -= malloc_usable_size(block);
  return counted(std::realloc(block, size));
}

}  // namespace carom::bench
