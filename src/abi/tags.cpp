// The only state of the process: which of 65,535 owner numbers are taken. Without it two engines could issue the same
// handle, and a handle of the wrong world would pass for a good one.
#include "abi/tags.h"

#include <atomic>

namespace carom::abi {
namespace {

constexpr std::uint32_t kTags = 1u << 16, kBits = 64, kWords = kTags / kBits;
constinit std::atomic<std::uint64_t> taken[kWords] = {};
// Where to look first: numbers are reused as late as possible, so that handles of a dead world stay foreign for long.
constinit std::atomic<std::uint32_t> next{1};

}  // namespace

std::uint32_t take_tag() {
  const std::uint32_t start = next.fetch_add(1, std::memory_order_relaxed);
  for (std::uint32_t i = 0; i < kTags; ++i) {
    const std::uint32_t tag = (start + i) % kTags;
    const std::uint64_t bit = std::uint64_t(1) << (tag % kBits);
    if (tag == 0 || (taken[tag / kBits].load(std::memory_order_relaxed) & bit)) continue;
    if (!(taken[tag / kBits].fetch_or(bit, std::memory_order_relaxed) & bit)) return tag;
  }
  return 0;
}

void release_tag(std::uint32_t tag) {
  if (tag) taken[tag / kBits].fetch_and(~(std::uint64_t(1) << (tag % kBits)), std::memory_order_relaxed);
}

}  // namespace carom::abi
