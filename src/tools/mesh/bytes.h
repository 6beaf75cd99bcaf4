// Numbers out of the bytes of a mesh file: words of a text, values of a binary part.
#pragma once

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string_view>

namespace carom::tools {

/// Words of a text, and the line that the last one is on.
class Words {
 public:
  explicit Words(std::string_view text) : text_(text) {}
  std::size_t line() const { return line_; }
  /// Empty at the end.
  std::string_view next() {
    while (at_ < text_.size() && is_space(text_[at_])) line_ += text_[at_++] == '\n';
    const std::size_t begin = at_;
    while (at_ < text_.size() && !is_space(text_[at_])) ++at_;
    return text_.substr(begin, at_ - begin);
  }

 private:
  static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }
  std::string_view text_;
  std::size_t at_ = 0, line_ = 1;
};

/// A word as a finite number, whatever the locale.
inline std::optional<double> number_of(std::string_view word) {
  double value = 0;
  if (!word.empty() && word.front() == '+') word.remove_prefix(1);
  const auto [end, failed] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (failed != std::errc() || end != word.data() + word.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

/// A value from bytes that need not be aligned. @pre there are sizeof(T) of them
template <class T>
T value_at(const char* bytes, bool big_endian) {
  char own[sizeof(T)];
  std::memcpy(own, bytes, sizeof(T));
  if (big_endian != (std::endian::native == std::endian::big)) std::reverse(own, own + sizeof(T));
  T value;
  std::memcpy(&value, own, sizeof(T));
  return value;
}

}  // namespace carom::tools
