// The content of one recorded call, read argument by argument: handles and shapes become those of the world in which the
// call is made again, and what was read can be shown.
#pragma once

#include <cstddef>
#include <cstring>
#include <deque>
#include <map>
#include <string>
#include <type_traits>
#include <vector>

#include "host/host.h"

namespace carom::tools::replay {

using Bytes = std::vector<std::byte>;

class Script {
 public:
  Script(carom_world* world, const std::map<std::uint64_t, carom_shape>& shapes, const std::byte* from,
         std::uint64_t size)
      : world_(world), shapes_(shapes), at_(from), end_(from + size) {}

  carom_world* world() const { return world_; }
  carom_error* error() { return &error_; }
  const carom_error& heard() const { return error_; }
  /// "body=body 3, position=(1, 2, 3)"
  const std::string& text() const { return text_; }

  // Each reads what comes next; the name is for whoever reads text().   @throws Error: the recording is damaged
  template <class T>
  T number(const char* name) {
    T value;
    take(&value, sizeof value);
    char shown[40];
    std::snprintf(shown, sizeof shown, "%.9g", static_cast<double>(value));
    say(name, shown);
    return value;
  }
  std::uint64_t handle(const char* name) {
    std::uint64_t value;
    take(&value, sizeof value);
    return own_handle(name, value);
  }
  std::uint64_t shape(const char* name) {
    std::uint64_t value;
    take(&value, sizeof value);
    return own_shape(name, value);
  }
  /// @param wanted  how many there must be, where it is known   @return null where null was given
  template <class T>
  const T* list(const char* name, std::uint64_t wanted = 0) {
    std::uint64_t n = 0;
    const Bytes* const bytes = block(sizeof(T), n);
    if (!bytes) return say(name, "NULL"), nullptr;
    if (wanted && n != wanted) damaged();
    const T* const values = reinterpret_cast<const T*>(bytes->data());
    lengths_[name] = n;
    show_list(name, values, n);
    return values;
  }
  const std::uint64_t* handles(const char* name);
  template <class T>
  T* structure(const char* name) {
    std::uint64_t n = 0;
    Bytes* const bytes = block(1, n);
    if (!bytes) return say(name, "NULL"), nullptr;
    if (n < sizeof(std::uint32_t)) damaged();
    bytes->resize(std::max<std::size_t>(n, sizeof(T)));  // where ours is longer, its tail is not looked at
    T* const given = reinterpret_cast<T*>(bytes->data());
    if (given->struct_size != n) damaged();
    say(name, "{...}");
    return given;
  }
  std::uint64_t own_handle(const char* name, std::uint64_t recorded);
  std::uint64_t own_shape(const char* name, std::uint64_t recorded);

  /// A list that was read must have so many elements, as another argument says; null may stand for any number.
  /// @throws Error: the recording is damaged
  void demand(const char* name, std::uint64_t elements) const;
  /// Of n elements of `width` numbers each.   @return more than any list has, where that is no number of bytes
  static std::uint64_t bytes_of(std::uint64_t n, std::uint64_t width, std::uint32_t scalar);

 private:
  [[noreturn]] static void damaged();
  void take(void* to, std::uint64_t n);
  Bytes* block(std::uint64_t element, std::uint64_t& n);
  void say(const std::string& name, const std::string& value);
  template <class T>
  void show_list(const char* name, const T* values, std::uint64_t n) {
    std::string shown;
    if constexpr (std::is_arithmetic_v<T>)
      for (std::uint64_t i = 0; i < n && i < 4; ++i) {
        char one[40];
        std::snprintf(one, sizeof one, "%s%.9g", i ? ", " : "", static_cast<double>(values[i]));
        shown += one;
      }
    if (shown.empty() || n > 4) shown += (shown.empty() ? "" : ", ... ") + std::to_string(n) + " in all";
    say(name, "(" + shown + ")");
  }

  carom_world* world_;
  const std::map<std::uint64_t, carom_shape>& shapes_;
  const std::byte *at_, *end_;
  std::deque<Bytes> kept_;
  std::map<std::string, std::uint64_t> lengths_;  // of lists, by name
  std::string text_;
  carom_error error_ = CAROM_ERROR_INIT;
};

/// "body 3": kind and slot.
std::string name_of_handle(std::uint64_t handle);

}  // namespace carom::tools::replay
