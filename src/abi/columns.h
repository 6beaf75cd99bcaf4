// Arrays of the host's that batches of questions read and fill, and what all questions are asked alike.
#pragma once

#include <carom/body.h>
#include <carom/cast.h>

#include "abi/check.h"
#include "collision/cast/ray.h"

namespace carom::abi {

/// Elements of an array of the host's, at any stride and alignment.
struct Column {
  char* at = nullptr;  // null: not wanted
  std::uint64_t stride = 0;

  void put(std::uint64_t i, const void* element, std::size_t size) const {
    if (at) std::memcpy(at + i * stride, element, size);
  }
};

/// @param n  elements
inline bool make_column(Call& call, int argument, const char* name, const void* data, std::uint64_t stride,
                        std::uint64_t size, std::uint64_t n, Column& column) {
  column.at = static_cast<char*>(const_cast<void*>(data));
  column.stride = stride ? stride : size;
  if (column.at && !spans(call, argument, argument, n, column.stride, size)) return false;
  return column.stride >= size ||
         call.fail(CAROM_E_BUFFER_TOO_SMALL, argument, "%s: stride %llu, an element has %llu", name,
                   static_cast<unsigned long long>(stride), static_cast<unsigned long long>(size));
}

inline std::uint64_t bytes(std::uint32_t scalar) { return scalar == CAROM_SCALAR_F32 ? 4 : 8; }

template <int kCount>
void load(const Column& column, std::uint32_t scalar, std::uint64_t i, double out[]) {
  if (scalar == CAROM_SCALAR_F64) {
    std::memcpy(out, column.at + i * column.stride, kCount * sizeof(double));
    return;
  }
  float given[kCount];
  std::memcpy(given, column.at + i * column.stride, sizeof given);
  for (int k = 0; k < kCount; ++k) out[k] = given[k];
}

template <int kCount>
void store(const Column& column, std::uint32_t scalar, std::uint64_t i, const double values[]) {
  if (scalar == CAROM_SCALAR_F64) return column.put(i, values, kCount * sizeof(double));
  float converted[kCount];
  for (int k = 0; k < kCount; ++k) converted[k] = static_cast<float>(values[k]);
  column.put(i, converted, sizeof converted);
}

/// The rays of a batch.
struct RayColumns {
  std::uint64_t count = 0;
  std::uint32_t scalar = 0;
  Column origins, directions, max;

  bool read(Call& call, int argument, const carom_rays* given);
  /// @return false for a ray that is none
  bool get(std::uint64_t i, Ray& ray) const;
};

inline constexpr double kMostIterations = 10000;
inline constexpr double kLongest = 1e9;  // m of target, s of duration

/// Numbers of a descriptor, within their bounds.
bool take_settings(Call& call, int argument, std::uint32_t iterations, double tolerance, double target,
                   CastSettings& settings);

/// Zero, not NaN, in place of numbers that the input was too large for.
inline void write_finite(const Vec3& v, double out[3]) { from_vec3(carom::finite(v) ? v : Vec3(Vec3::zero()), out); }

}  // namespace carom::abi
