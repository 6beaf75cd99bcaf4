// Checks of what a host passes in. Each notes the failure in the call (code, argument, a message with the numbers) and
// returns false, so that they chain with &&. The same in every build.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>

#include "abi/guard.h"
#include "core/pool.h"
#include "core/pose.h"

namespace carom::abi {

inline constexpr Real kUnitTolerance = 1e-6;           // of a quaternion's or a normal's length; float32 input passes
inline constexpr std::uint32_t kSmallestStruct = 8;    // struct_size and the word after it
inline constexpr std::uint32_t kLargestStruct = 4096;  // more is an uninitialised struct_size, not a newer header

bool present(Call& call, int argument, const char* name, const void* pointer);
bool finite(Call& call, int argument, const char* name, const double* values, int count);
/// Finite and within [low, high].
bool in_range(Call& call, int argument, const char* name, double value, double low, double high);
/// Three numbers, finite, and each within [-most, most].
bool vector_in_range(Call& call, int argument, const char* name, const double v[3], double most);
/// Which of two vectors, arguments number `argument` and the next, is to blame for a product or sum that overflowed.
int larger_of(int argument, const double a[3], const double b[3]);
/// At least 0; may be infinite.
bool not_negative(Call& call, int argument, const char* name, double value);
/// Present, finite and of unit length. @param count 3: normal, 4: quaternion
bool unit(Call& call, int argument, const char* name, const double* values, int count);
bool known(Call& call, int argument, const char* name, std::uint32_t value, std::uint32_t count);
/// @param bits  value & bits are known; the rest must be 0
bool only_bits(Call& call, int argument, const char* name, std::uint32_t value, std::uint32_t bits);
/// The handle names a living object of the pool.
bool resolve(Call& call, int argument, const char* name, const SlotPool& pool, Handle handle);

/// Whether some version of a struct may have this size.
constexpr bool is_struct_size(std::uint32_t size, std::size_t alignment) {
  return size >= kSmallestStruct && size <= kLargestStruct && size % alignment == 0;
}
/// struct_size is one that some version of a struct may have.
bool struct_size(Call& call, int argument, const char* name, std::uint32_t size, std::size_t alignment);
/// All bytes of [from, to) are zero: no caller asks for what this library does not know.
bool zero_tail(Call& call, int argument, const char* name, const void* structure, std::size_t from, std::size_t to);

/// Take in a descriptor: what the caller's version lacks keeps its default, what it has beyond ours must be zero.
/// @param known  in: defaults; out: the caller's values
template <class T>
bool read_struct(Call& call, int argument, const char* name, const T* given, T& known) {
  if (!present(call, argument, name, given) || !struct_size(call, argument, name, given->struct_size, alignof(T)) ||
      !zero_tail(call, argument, name, given, sizeof(T), given->struct_size))
    return false;
  std::memcpy(static_cast<void*>(&known), given, std::min<std::size_t>(given->struct_size, sizeof(T)));
  known.struct_size = sizeof(T);
  return true;
}

/// Whether a struct that is to be filled in says a size that some version of it has.
template <class T>
bool fillable(Call& call, int argument, const char* name, const T* wanted) {
  return present(call, argument, name, wanted) && struct_size(call, argument, name, wanted->struct_size, alignof(T));
}

/// What every *_init() does: defaults in as much of the caller's struct as there is.
/// @param size  bytes, of the struct as the caller knows it; what is beyond ours becomes 0
/// @param set   sets what is not 0
template <class T, class F>
std::int32_t init_struct(T* to, std::uint32_t size, const F& set) {
  if (!to) return CAROM_E_NULL_ARGUMENT;
  if (!is_struct_size(size, alignof(T))) return CAROM_E_STRUCT_SIZE;
  T full{};
  set(full);
  full.struct_size = size;
  std::memset(static_cast<void*>(to), 0, size);
  std::memcpy(static_cast<void*>(to), &full, std::min<std::size_t>(size, sizeof full));
  return CAROM_OK;
}
template <class T>
std::int32_t init_struct(T* to, std::uint32_t size) {
  return init_struct(to, size, [](T&) {});
}

/// Fill in as much of a struct as the caller's version has; its struct_size stays.
template <class T>
void write_struct(const T& full, T* wanted) {
  constexpr std::size_t skip = sizeof wanted->struct_size;
  const std::size_t size = std::min<std::size_t>(wanted->struct_size, sizeof(T));
  std::memcpy(reinterpret_cast<char*>(wanted) + skip, reinterpret_cast<const char*>(&full) + skip, size - skip);
}

inline constexpr std::uint64_t kLargestStride = 0x7FFFFFFF;  // more is a negative number, or none at all

/// n elements of `size` bytes at a stride, which is at least that, lie within what can be addressed.
/// @param argument, count_argument  of the stride, and of n
bool spans(Call& call, int argument, int count_argument, std::uint64_t n, std::uint64_t stride, std::uint64_t size);

/// A stride that elements of some version of T may have.
template <class T>
bool element_stride(Call& call, int argument, std::uint64_t stride) {
  if (stride > kLargestStride) return spans(call, argument, argument, 1, stride, 1);
  return (stride >= kSmallestStruct && stride % alignof(T) == 0) ||
         call.fail(CAROM_E_BUFFER_TOO_SMALL, argument, "stride is %llu, one element has %zu bytes",
                   static_cast<unsigned long long>(stride), sizeof(T));
}

/// Copy one element of an array whose stride the caller chose: a shorter element of an older header gets its prefix.
template <class T>
void write_element(const T& full, void* array, std::uint64_t index, std::uint64_t stride) {
  std::memcpy(static_cast<char*>(array) + index * stride, &full, std::min<std::size_t>(stride, sizeof(T)));
}

inline Vec3 to_vec3(const double v[3]) { return Vec3(v[0], v[1], v[2]); }
/// From x, y, z, w within kUnitTolerance of unit length.
inline Quat to_quat(const double q[4]) { return oriented(Quat(q[3], q[0], q[1], q[2])); }
inline void from_vec3(const Vec3& v, double out[3]) { out[0] = v.x(), out[1] = v.y(), out[2] = v.z(); }
inline void from_quat(const Quat& q, double out[4]) { out[0] = q.x(), out[1] = q.y(), out[2] = q.z(), out[3] = q.w(); }

}  // namespace carom::abi
