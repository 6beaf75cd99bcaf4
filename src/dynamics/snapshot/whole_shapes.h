// Shapes of a whole snapshot: a plugin's name and parameters, or what scenery and hulls of shapes are made of.
#pragma once

#include "dynamics/snapshot/whole.h"

namespace carom::dynamics::snapshot {

/// So many numbers, and how many they are.
template <class Io, class List>
void list(Io& io, List& values) {
  using T = std::remove_cvref_t<decltype(values[0])>;
  const std::uint64_t n = io.count(values.size(), sizeof(T));
  if constexpr (Io::checks) values.resize(n);
  for (std::uint64_t k = 0; k < n; ++k) {
    const T v = io.value(values[k]);
    if constexpr (Io::checks) values[k] = v;
  }
}

/// @param before  those that have lower numbers
void save_shape(Saver& io, const Shape& shape, std::span<const Shape* const> before, const ShapeNames& names);
/// Into builder.shape.
void build_shape(Checker& io, Builder& builder);

}  // namespace carom::dynamics::snapshot
