// Lists of the last step into a host's array.
#pragma once

#include "abi/check.h"
#include "dynamics/world.h"

namespace carom::abi {

/// The tail of calls (world, dst, stride, capacity, count): as many as fit, at a stride of the host's; all are counted.
/// @param element  (index) -> an element
template <class Element, class F>
void copy_elements(Call& call, std::uint64_t size, F&& element, void* dst, std::uint64_t stride, std::uint64_t capacity,
                   std::uint64_t* count) {
  if (!present(call, 5, "count", count) || (capacity && !present(call, 2, "dst", dst))) return;
  if (capacity && !element_stride<Element>(call, 3, stride)) return;
  *count = size;
  for (std::uint64_t i = 0; i < std::min(capacity, size); ++i) write_element<Element>(element(i), dst, i, stride);
}

/// A fault as a host sees it.
carom_fault fault_of(const World& world, const FaultView& view);

/// Likewise of a list of the last step.
template <class View, class Element>
void copy_out(Call& call, const World& world, const Array<View>& views, Element (*convert)(const World&, const View&),
              void* dst, std::uint64_t stride, std::uint64_t capacity, std::uint64_t* count) {
  copy_elements<Element>(
      call, views.size(), [&](std::uint64_t i) { return convert(world, views[i]); }, dst, stride, capacity, count);
}

}  // namespace carom::abi
