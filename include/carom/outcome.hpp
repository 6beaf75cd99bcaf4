/** @file outcome.hpp
 *  How calls of carom.hpp end: a value, or what was wrong as an exception (Throws) or as a value of its own (Returns).
 */
#ifndef CAROM_OUTCOME_HPP
#define CAROM_OUTCOME_HPP

#include <carom/carom.h>
#include <carom/fill.hpp>

#include <cstdio>
#include <exception>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#if __has_include(<dlfcn.h>)
#include <dlfcn.h>
#endif

namespace carom {

/// A struct of carom.h with its defaults: `auto hinge = carom::make<carom_joint_desc>();`
template <class T>
T make() noexcept {
  T it;
  raw::fill(it);
  return it;
}

/// What was wrong, and what to do. Nothing has changed.
class Error : public std::exception {
 public:
  explicit Error(const carom_error &e) : details(e), what_(std::string(e.message) + ". Remedy: " + e.remedy) {}
  const char *what() const noexcept override { return what_.c_str(); }
  carom_error details;  ///< code, argument, message, remedy, witness

 private:
  std::string what_;
};

/// A value, or why there is none. Look before you take: `if (!r) ... r.error()`, then `*r`.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
  Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}
  explicit operator bool() const noexcept { return state_.index() == 0; }
  T &operator*() & { return std::get<0>(state_); }
  T &&operator*() && { return std::get<0>(std::move(state_)); }
  T *operator->() { return &std::get<0>(state_); }
  const Error &error() const { return std::get<1>(state_); }

 private:
  std::variant<T, Error> state_;
};

/// Failures as values: nothing throws.
struct Returns {
  template <class T>
  using Out = Result<std::conditional_t<std::is_void_v<T>, std::monostate, T>>;
  template <class T>
  static Result<T> end(std::int32_t result, const carom_error &e, T &value) {
    if (result == CAROM_OK) [[likely]]
      return std::move(value);
    return Error(e);
  }
};

#if defined(__cpp_exceptions)
/// Failures as exceptions of class Error.
struct Throws {
  template <class T>
  using Out = T;
  template <class T>
  static std::conditional_t<std::is_same_v<T, std::monostate>, void, T> end(std::int32_t result, const carom_error &e,
                                                                            T &value) {
    if (result != CAROM_OK) [[unlikely]]
      throw Error(e);
    if constexpr (!std::is_same_v<T, std::monostate>) return std::move(value);
  }
};
#endif

namespace detail {

/// f(value, error) fills the value: T, or no value at all.
template <class P, class T, class F>
typename P::template Out<T> run(F f) {
  std::conditional_t<std::is_void_v<T>, std::monostate, T> value{};
  carom_error e;
  e.struct_size = sizeof e;
  std::int32_t result;
  if constexpr (std::is_void_v<T>)
    result = f(&e);
  else
    result = f(value, &e);
  return P::end(result, e, value);
}

inline std::int32_t refuse(carom_error *e, std::int32_t code, const std::string &message, const std::string &remedy) {
  *e = CAROM_ERROR_INIT;
  e->code = code;
  std::snprintf(e->message, sizeof e->message, "%s", message.c_str());
  std::snprintf(e->remedy, sizeof e->remedy, "%s", remedy.c_str());
  return code;
}

/// Does a library whose carom_abi_manifest() this is do what these headers say?
inline std::int32_t check_library(const char *manifest, carom_error *e) {
  unsigned major = 0, minor = 0, patch = 0;
  const int read = std::sscanf(manifest, "carom %u.%u.%u\n", &major, &minor, &patch);
  const bool same =
      major == CAROM_VERSION_MAJOR && (major > 0 || minor == CAROM_VERSION_MINOR);  // 0.10 differs from 0.9
  if (read == 3 && same && std::pair(minor, patch) >= std::pair(CAROM_VERSION_MINOR, CAROM_VERSION_PATCH))
    return CAROM_OK;
  const char *file = "the library";
#if __has_include(<dlfcn.h>)
  Dl_info info;
  if (dladdr(manifest, &info) && info.dli_fname) file = info.dli_fname;
#endif
  const auto dotted = [](unsigned a, unsigned b, unsigned c) {
    return std::to_string(a) + "." + std::to_string(b) + "." + std::to_string(c);
  };
  const std::string here = dotted(CAROM_VERSION_MAJOR, CAROM_VERSION_MINOR, CAROM_VERSION_PATCH);
  return refuse(e, CAROM_E_UNSUPPORTED,
                std::string(file) + " is of version " + dotted(major, minor, patch) + ", this program of " + here,
                "install libcarom " + here + ", or compile with the headers of that library");
}

}  // namespace detail
}  // namespace carom
#endif
