// How much of a long test runs: this header alone decides it.
#pragma once

#include <cstddef>
#include <cstdlib>

namespace carom::test {

/// `all` in the preset `nightly`, `slice` in CI, `sanitized` in CI under a sanitizer, where a step takes up to ten times as long.
/// Under a sanitizer the night has CI's slice. CAROM_NIGHTLY=1 in the environment says that it is night.
template <class Number>
Number sliced(Number all, Number slice, Number sanitized) {
  static const bool kNight = std::getenv("CAROM_NIGHTLY") != nullptr;
#ifdef CAROM_SANITIZED
  static_cast<void>(all);
  return kNight ? slice : sanitized;
#else
  static_cast<void>(sanitized);
  return kNight ? all : slice;
#endif
}

/// Of a family of scenes, asked for one after the other: whether the next is run. One of `slice` in CI, one of `sanitized` under a
/// sanitizer, all by night. Primes: so every value of each loop comes up.
class OneOf {
 public:
  OneOf(std::size_t slice, std::size_t sanitized) : count_(sliced<std::size_t>(1, slice, sanitized)) {}
  bool next() { return at_++ % count_ == 0; }

 private:
  std::size_t count_, at_ = 0;
};

}  // namespace carom::test
