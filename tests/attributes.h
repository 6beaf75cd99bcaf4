// Values of attributes that no body has of itself, for tests that go through all attributes there are.
#pragma once

#include <carom/carom.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>

inline carom_attribute_info attribute_info(std::uint32_t attribute) {
  carom_attribute_info info{};
  info.struct_size = sizeof info;
  if (carom_attribute_get_info(attribute, &info, nullptr) != CAROM_OK) std::abort();
  return info;
}

/// Within the bounds, none of its numbers as usual, no two of them alike.
inline std::array<double, CAROM_ATTRIBUTE_NUMBERS> unusual_value(const carom_attribute_info& info) {
  std::array<double, CAROM_ATTRIBUTE_NUMBERS> value{};
  for (std::uint32_t k = 0; k < info.numbers; ++k)
    value[k] = info.is_whole ? std::min(info.usual[k] + 2 + k, info.max)
                             : std::clamp(info.usual[k] + 0.375 + k, info.min, info.max);
  return value;
}
