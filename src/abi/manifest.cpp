// The layout of every public struct, as text.
#include <carom/carom.h>

#include <array>

#include "abi/layout.h"

namespace {

/// Writes, or with nowhere to write to counts, characters.
struct Writer {
  char* to;
  std::size_t count = 0;

  constexpr void put(std::string_view text) {
    for (const char c : text) {
      if (to) to[count] = c;
      ++count;
    }
  }
  constexpr void put(std::size_t number) {
    char digits[20] = {};
    std::size_t n = 0;
    do digits[n++] = static_cast<char>('0' + number % 10);
    while (number /= 10);
    while (n) put(std::string_view(&digits[--n], 1));
  }
};

constexpr std::size_t write_all(char* to) {
  Writer out{to};
  out.put("carom ");
  out.put(std::size_t{CAROM_VERSION_MAJOR}), out.put(".");
  out.put(std::size_t{CAROM_VERSION_MINOR}), out.put(".");
  out.put(std::size_t{CAROM_VERSION_PATCH}), out.put("\n");
  for (const carom::abi::LayoutRow& row : carom::abi::kLayout) {
    out.put(row.name), out.put(" "), out.put(row.offset), out.put(" "), out.put(row.size), out.put(" "),
        out.put(row.kind);
    if (row.count) out.put("["), out.put(row.count), out.put("]");
    out.put("\n");
  }
  return out.count;
}

// Done by the compiler: no code runs for it when the library is loaded, and nothing can fail when it is asked for.
constexpr auto kManifest = [] {
  std::array<char, write_all(nullptr) + 1> text{};
  write_all(text.data());
  return text;
}();

}  // namespace

extern "C" const char* carom_abi_manifest(void) { return kManifest.data(); }
