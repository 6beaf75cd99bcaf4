// std::sort in a tenth of libc++'s code: the module has sorts of twenty types, 90,000 bytes of them as they come.
// Shell's sort, from far to near. Nothing of ours depends on the order of what is equal: native libraries differ there.
//
// libc++'s own sort() and ranges::sort() end in std::__sort(); the overload for pointers, declared before it, is taken.
#pragma once

#include <__algorithm/comp_ref_type.h>
#include <__utility/move.h>
#include <__config>

_LIBCPP_BEGIN_NAMESPACE_STD
template <class Wrapped, class Item>
void __sort(Item* first, Item* last, Wrapped wrapped);
_LIBCPP_END_NAMESPACE_STD

#include_next <__algorithm/sort.h>

_LIBCPP_BEGIN_NAMESPACE_STD
template <class Wrapped, class Item>
void __sort(Item* first, Item* last, Wrapped wrapped) {
  auto&& less = _UnwrapAlgPolicy<Wrapped>::__get_comp(wrapped);
  const auto count = static_cast<size_t>(last - first);
  size_t far = 1;
  while (far < count / 5) far = far * 9 / 4 + 1;
  for (;; far = far * 4 / 9) {
    if (far < 1) far = 1;
    for (size_t i = far; i < count; ++i) {
      if (!less(first[i], first[i - far])) continue;
      Item item = std::move(first[i]);
      size_t to = i;
      do {
        first[to] = std::move(first[to - far]);
        to -= far;
      } while (to >= far && less(item, first[to - far]));
      first[to] = std::move(item);
    }
    if (far == 1) return;
  }
}
_LIBCPP_END_NAMESPACE_STD
