// Checks of what a host passes in: what they say when they fail.
#include "abi/check.h"

#include <cmath>

namespace carom::abi {
namespace {

const char* kind_name(std::uint32_t kind) {
  constexpr const char* kNames[] = {"nothing",  "plugin",           "shape", "material",    "body",
                                    "collider", "set of particles", "joint", "force field", "spring"};
  return kind < std::size(kNames) ? kNames[kind] : "nothing";
}

}  // namespace

bool present(Call& call, int argument, const char* name, const void* pointer) {
  return pointer || call.fail(CAROM_E_NULL_ARGUMENT, argument, "%s is NULL", name);
}

bool finite(Call& call, int argument, const char* name, const double* values, int count) {
  if (!present(call, argument, name, values)) return false;
  for (int i = 0; i < count; ++i)
    if (!std::isfinite(values[i])) {
      if (count == 1) return call.fail(CAROM_E_NOT_FINITE, argument, "%s is %g", name, values[0]);
      return call.fail(CAROM_E_NOT_FINITE, argument, "%s[%d] is %g", name, i, values[i]);
    }
  return true;
}

bool in_range(Call& call, int argument, const char* name, double value, double low, double high) {
  if (!finite(call, argument, name, &value, 1)) return false;
  return (value >= low && value <= high) ||
         call.fail(CAROM_E_OUT_OF_RANGE, argument, "%s is %.17g, outside [%g, %g]", name, value, low, high);
}

bool vector_in_range(Call& call, int argument, const char* name, const double v[3], double most) {
  if (!finite(call, argument, name, v, 3)) return false;
  for (int k = 0; k < 3; ++k)
    if (std::fabs(v[k]) > most)
      return call.fail(CAROM_E_OUT_OF_RANGE, argument, "%s[%d] is %g, must be within +-%g", name, k, v[k], most);
  return true;
}

int larger_of(int argument, const double a[3], const double b[3]) {
  double of_a = 0, of_b = 0;
  for (int k = 0; k < 3; ++k) of_a = std::fmax(of_a, std::fabs(a[k])), of_b = std::fmax(of_b, std::fabs(b[k]));
  return of_a >= of_b ? argument : argument + 1;
}

bool not_negative(Call& call, int argument, const char* name, double value) {
  return value >= 0 ||
         call.fail(value < 0 ? CAROM_E_OUT_OF_RANGE : CAROM_E_NOT_FINITE, argument, "%s is %g", name, value);
}

bool unit(Call& call, int argument, const char* name, const double* values, int count) {
  if (!finite(call, argument, name, values, count)) return false;
  double length2 = 0;
  for (int i = 0; i < count; ++i) length2 += values[i] * values[i];
  const double length = std::sqrt(length2);
  return std::fabs(length - 1) <= kUnitTolerance ||
         call.fail(CAROM_E_NOT_UNIT, argument, "%s has length %.9g, further than %g from 1", name, length,
                   kUnitTolerance);
}

bool known(Call& call, int argument, const char* name, std::uint32_t value, std::uint32_t count) {
  return value < count ||
         call.fail(CAROM_E_UNKNOWN_ENUM, argument, "%s is %u; this library knows 0 to %u", name, value, count - 1);
}

bool only_bits(Call& call, int argument, const char* name, std::uint32_t value, std::uint32_t bits) {
  return !(value & ~bits) ||
         call.fail(CAROM_E_UNSUPPORTED, argument, "%s is 0x%x; this library knows bits 0x%x", name, value, bits);
}

bool resolve(Call& call, int argument, const char* name, const SlotPool& pool, Handle handle) {
  const auto shown = static_cast<unsigned long long>(handle);
  switch (pool.check(handle)) {
    case HandleFault::none:
      return true;
    case HandleFault::wrong_kind:
      return call.fail(CAROM_E_WRONG_KIND, argument, "%s 0x%016llx is a handle of a %s", name, shown,
                       kind_name(static_cast<std::uint32_t>(handle >> 60)));
    case HandleFault::wrong_owner:
      return call.fail(CAROM_E_WRONG_WORLD, argument, "%s 0x%016llx was issued by another world or engine (number %u)",
                       name, shown, static_cast<unsigned>(handle >> 44) & 0xFFFFu);
    case HandleFault::stale:
      return call.fail(CAROM_E_STALE_HANDLE, argument, "%s 0x%016llx names an object that was destroyed", name, shown);
    case HandleFault::invalid:
      break;
  }
  return call.fail(CAROM_E_INVALID_HANDLE, argument, "%s 0x%016llx was never issued", name, shown);
}

bool struct_size(Call& call, int argument, const char* name, std::uint32_t size, std::size_t alignment) {
  return is_struct_size(size, alignment) ||
         call.fail(CAROM_E_STRUCT_SIZE, argument, "%s->struct_size is %u; no version of the struct has that size", name,
                   size);
}

bool zero_tail(Call& call, int argument, const char* name, const void* structure, std::size_t from, std::size_t to) {
  const auto* bytes = static_cast<const unsigned char*>(structure);
  for (std::size_t i = from; i < to; ++i)
    if (bytes[i])
      return call.fail(CAROM_E_UNSUPPORTED, argument,
                       "%s sets a field at byte %zu of %zu, but this library's version ends at %zu", name, i, to, from);
  return true;
}

bool spans(Call& call, int argument, int count_argument, std::uint64_t n, std::uint64_t stride, std::uint64_t size) {
  if (stride > kLargestStride)
    return call.fail(CAROM_E_OUT_OF_RANGE, argument, "a stride is %llu, must be at most %llu bytes",
                     static_cast<unsigned long long>(stride), static_cast<unsigned long long>(kLargestStride));
  constexpr std::uint64_t kMost = PTRDIFF_MAX;
  return n <= 1 || (n - 1 <= (kMost - size) / std::max<std::uint64_t>(stride, 1)) ||
         call.fail(CAROM_E_OUT_OF_RANGE, count_argument, "%llu elements, %llu bytes apart, are more than memory holds",
                   static_cast<unsigned long long>(n), static_cast<unsigned long long>(stride));
}

}  // namespace carom::abi
