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

/// Does the library do what these headers say?
inline std::int32_t check_library(carom_error *e) {
  char version[48];
  std::snprintf(version, sizeof version, "carom %u.%u.%u", CAROM_VERSION_MAJOR, CAROM_VERSION_MINOR,
                CAROM_VERSION_PATCH);
  return carom_abi_check(version, e);
}

}  // namespace detail
}  // namespace carom
#endif
