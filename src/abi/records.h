// Records of a few scalars in a host's memory, float or double, at any stride. Copied byte by byte: a stride need not
// keep them aligned.
#pragma once

#include <cstdint>
#include <cstring>

#include "abi/check.h"

namespace carom::abi {

inline constexpr int kMostScalars = 12;

template <class Scalar>
void store(const double record[], int scalars, char* to) {
  Scalar converted[kMostScalars];
  for (int k = 0; k < scalars; ++k) converted[k] = static_cast<Scalar>(record[k]);
  std::memcpy(to, converted, static_cast<std::size_t>(scalars) * sizeof(Scalar));
}
template <class Scalar>
void load(const char* from, int scalars, double record[]) {
  Scalar given[kMostScalars];
  std::memcpy(given, from, static_cast<std::size_t>(scalars) * sizeof(Scalar));
  for (int k = 0; k < scalars; ++k) record[k] = given[k];
}

/// A stride of 0 becomes the record's size; it must not be shorter.
/// @param scalar  CAROM_SCALAR_*, known   @param what  "position"
/// @param count_argument  of n, how many records there are
bool check_stride(Call& call, int argument, const char* what, int scalars, std::uint32_t scalar, std::uint64_t& stride,
                  std::uint64_t n, int count_argument);

}  // namespace carom::abi
