// Checks of what a host passes to the kit, in the manner of the boundary: each notes the first failure and returns false,
// so that they chain with &&. They see the public interface alone.
#pragma once

#include <carom/base.h>

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "core/float_scope.h"

namespace carom::kit {

/// One call, and what went wrong in it.
class Call {
 public:
  explicit Call(carom_error* error) : error_(error) {}
  Call(const Call&) = delete;
  Call& operator=(const Call&) = delete;

  /// @param argument  1-based position in the C signature, 0: none in particular   @return false
  bool fail(std::int32_t code, std::int32_t argument, const char* format, ...) __attribute__((format(printf, 4, 5)));
  /// A call of the library that this one made. @param argument  of ours, that its failure is due to; world calls that say
  ///                                                            nothing of an argument keep 0
  bool passed(std::int32_t result, const carom_error& inner, std::int32_t argument);
  /// The error struct is one; before all else.
  bool begin();
  /// Hand the failure over. @return the result of the call
  std::int32_t finish() const;

 private:
  carom_error* error_;
  std::int32_t code_ = CAROM_OK;
  std::int32_t argument_ = 0;
  char message_[sizeof carom_error::message] = {0};
};

/// Run the body of one C call: work(call), in the default floating-point environment.
template <class Work>
std::int32_t run_call(carom_error* error, Work&& work) {
  Call call(error);
  if (call.begin()) {
    const FloatScope scope;
    work(call);
  }
  return call.finish();
}

bool present(Call& call, int argument, const char* name, const void* pointer);
/// Finite, and each within [low, high].
bool within(Call& call, int argument, const char* name, const double* values, int count, double low, double high);
inline bool within(Call& call, int argument, const char* name, double value, double low, double high) {
  return within(call, argument, name, &value, 1, low, high);
}
/// Finite and of unit length within 1e-6.
bool unit(Call& call, int argument, const char* name, const double* values, int count);
bool known(Call& call, int argument, const char* name, std::uint32_t value, std::uint32_t count);
bool only_bits(Call& call, int argument, const char* name, std::uint32_t value, std::uint32_t bits);
bool struct_size(Call& call, int argument, const char* name, std::uint32_t size, std::size_t alignment);
bool zero_tail(Call& call, int argument, const char* name, const void* structure, std::size_t from, std::size_t to);

/// Take in a struct: what the caller's version lacks keeps its default, what it has beyond ours must be zero.
template <class T>
bool read_struct(Call& call, int argument, const char* name, const T* given, T& known) {
  if (!present(call, argument, name, given) || !struct_size(call, argument, name, given->struct_size, alignof(T)) ||
      !zero_tail(call, argument, name, given, sizeof(T), given->struct_size))
    return false;
  std::memcpy(static_cast<void*>(&known), given, std::min<std::size_t>(given->struct_size, sizeof(T)));
  known.struct_size = sizeof(T);
  return true;
}

/// What an *_init() does: `full` into as much of the caller's struct as there is.
template <class T>
std::int32_t init_struct(T* to, std::uint32_t size, T full) {
  if (!to) return CAROM_E_NULL_ARGUMENT;
  Call none(nullptr);
  if (!struct_size(none, 0, "size", size, alignof(T))) return CAROM_E_STRUCT_SIZE;
  full.struct_size = size;
  std::memset(static_cast<void*>(to), 0, size);
  std::memcpy(static_cast<void*>(to), &full, std::min<std::size_t>(size, sizeof full));
  return CAROM_OK;
}

/// Into as much of a struct as the caller's version has; its struct_size stays.
template <class T>
void write_struct(const T& full, T* wanted) {
  constexpr std::size_t skip = sizeof wanted->struct_size;
  const std::size_t size = std::min<std::size_t>(wanted->struct_size, sizeof(T));
  std::memcpy(reinterpret_cast<char*>(wanted) + skip, reinterpret_cast<const char*>(&full) + skip, size - skip);
}

}  // namespace carom::kit
