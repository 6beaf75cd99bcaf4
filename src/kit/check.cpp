// Checks of what a host passes to the kit: what they say when they fail.
#include "kit/check.h"

#include <cmath>
#include <cstdarg>
#include <cstddef>
#include <cstdio>

namespace carom::kit {

namespace {
constexpr double kUnitTolerance = 1e-6;         // as at the boundary: float32 input passes
constexpr std::uint32_t kSmallestStruct = 8;    // struct_size and the word after it
constexpr std::uint32_t kLargestStruct = 4096;  // more is an uninitialised struct_size, not a newer header
constexpr std::uint32_t kSmallestError = kSmallestStruct;
}  // namespace

bool Call::fail(std::int32_t code, std::int32_t argument, const char* format, ...) {
  if (code_ != CAROM_OK) return false;  // the first one stands
  code_ = code, argument_ = argument;
  va_list values;
  va_start(values, format);
  std::vsnprintf(message_, sizeof message_, format, values);
  va_end(values);
  return false;
}

bool Call::passed(std::int32_t result, const carom_error& inner, std::int32_t argument) {
  if (result == CAROM_OK) return true;
  return fail(result, inner.argument ? argument : 0, "%s", inner.message);
}

bool Call::begin() {
  if (!error_ || error_->struct_size >= kSmallestError) return true;
  return fail(CAROM_E_STRUCT_SIZE, 0, "error->struct_size is %u", error_->struct_size);
}

std::int32_t Call::finish() const {
  if (code_ == CAROM_OK || !error_ || error_->struct_size < kSmallestError) return code_;
  carom_error full = CAROM_ERROR_INIT;
  full.code = code_;
  full.argument = argument_;
  std::memcpy(full.message, message_, sizeof message_);
  std::snprintf(full.remedy, sizeof full.remedy, "%s", carom_result_remedy(code_));
  write_struct(full, error_);
  const std::uint32_t size = error_->struct_size;
  if (size > offsetof(carom_error, message) && size < sizeof full) reinterpret_cast<char*>(error_)[size - 1] = '\0';
  return code_;
}

bool present(Call& call, int argument, const char* name, const void* pointer) {
  return pointer || call.fail(CAROM_E_NULL_ARGUMENT, argument, "%s is NULL", name);
}

bool within(Call& call, int argument, const char* name, const double* values, int count, double low, double high) {
  if (!present(call, argument, name, values)) return false;
  for (int i = 0; i < count; ++i) {
    if (!std::isfinite(values[i])) return call.fail(CAROM_E_NOT_FINITE, argument, "%s has %g in it", name, values[i]);
    if (!(values[i] >= low && values[i] <= high))
      return call.fail(CAROM_E_OUT_OF_RANGE, argument, "%s has %.17g in it, outside [%g, %g]", name, values[i], low,
                       high);
  }
  return true;
}

bool unit(Call& call, int argument, const char* name, const double* values, int count) {
  double length2 = 0;
  for (int i = 0; i < count; ++i) {
    if (!std::isfinite(values[i])) return call.fail(CAROM_E_NOT_FINITE, argument, "%s has %g in it", name, values[i]);
    length2 += values[i] * values[i];
  }
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

bool struct_size(Call& call, int argument, const char* name, std::uint32_t size, std::size_t alignment) {
  return (size >= kSmallestStruct && size <= kLargestStruct && size % alignment == 0) ||
         call.fail(CAROM_E_STRUCT_SIZE, argument, "%s->struct_size is %u, which no version of the struct has", name,
                   size);
}

bool zero_tail(Call& call, int argument, const char* name, const void* structure, std::size_t from, std::size_t to) {
  const auto* bytes = static_cast<const unsigned char*>(structure);
  for (std::size_t i = from; i < to; ++i)
    if (bytes[i])
      return call.fail(CAROM_E_UNSUPPORTED, argument, "%s asks for what this library does not know, at byte %zu", name,
                       i);
  return true;
}

}  // namespace carom::kit
