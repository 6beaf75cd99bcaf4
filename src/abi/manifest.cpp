// The layout of every public struct, as text, and whether that of a client fits.
#include <carom/carom.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>
#include <string>
#include <string_view>

#include "abi/check.h"
#include "abi/layout.h"
#include "abi/loader.h"

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

/// Up to `end`, which goes with it; the rest stays.
std::string_view cut(std::string_view& text, char end) {
  const std::string_view first = text.substr(0, text.find(end));
  text.remove_prefix(std::min(text.size(), first.size() + 1));
  return first;
}

/// A number and nothing else, or -1.
long number(std::string_view text) {
  long n = -1;
  const auto [end, fault] = std::from_chars(text.begin(), text.end(), n);
  return fault == std::errc() && end == text.end() ? n : -1;
}

struct Version {
  std::string_view text;  // "0.9.0"
  std::array<long, 3> numbers{-1, -1, -1};

  /// @param line  "carom 0.9.0"
  explicit Version(std::string_view line) {
    if (cut(line, ' ') != "carom") return;
    text = line;
    const long major = number(cut(line, '.')), minor = number(cut(line, '.'));
    numbers = {major, minor, number(line)};
  }
  bool is_one() const { return std::ranges::min(numbers) >= 0; }
  /// Before 1.0 a minor version may break clients.
  bool serves(const Version& client) const {
    return is_one() && numbers[0] == client.numbers[0] && (numbers[0] > 0 || numbers[1] == client.numbers[1]) &&
           numbers >= client.numbers;
  }
};

/// Alike, or a struct that has grown: its tail is not the client's.
/// @param ours, theirs  what stands behind a name: offset, size, kind
bool same_place(std::string_view ours, std::string_view theirs) {
  if (ours == theirs) return true;
  cut(ours, ' '), cut(theirs, ' ');
  const long here = number(cut(ours, ' ')), there = number(cut(theirs, ' '));
  return ours == "struct" && theirs == "struct" && there >= 0 && here > there;
}

void check_layout(carom::abi::Call& call, std::string_view theirs) {
  const std::string_view ours = carom_abi_manifest();
  std::string_view rows = ours;
  const Version here(cut(rows, '\n')), there(cut(theirs, '\n'));
  if (!there.is_one()) {
    call.fail(CAROM_E_OUT_OF_RANGE, 1, "layout does not begin with \"carom\" and a version");
    return;
  }
  char path[1024];
  carom::abi::system::own_file(path, sizeof path);
  const std::size_t length = std::strlen(path);
  const char* const file = length == 0 ? "this library" : path + (length > 90 ? length - 90 : 0);
  const auto refuse = [&](const std::string& what) {
    call.fail(CAROM_E_UNSUPPORTED, 1, "%s %s", file, what.c_str());
    call.advise("install a libcarom and what calls it of one version, or build the caller against that library anew");
  };
  const auto quoted = [](std::string_view text) { return std::string(text.substr(0, 60)); };
  if (!here.serves(there)) refuse("is of version " + quoted(here.text) + ", its caller of " + quoted(there.text));
  std::size_t at = 0;  // where the last one was: both are in one order, but for what is new
  while (call.ok() && !theirs.empty()) {
    std::string_view place = cut(theirs, '\n');
    const std::string_view name = cut(place, ' ');
    const std::string line = "\n" + std::string(name) + " ";
    std::size_t found = ours.find(line, at);
    if (found == ours.npos) found = ours.find(line);
    if (found == ours.npos) {
      refuse("has no " + quoted(name));
      return;
    }
    at = found;
    rows = ours.substr(at + line.size());
    const std::string_view own = cut(rows, '\n');
    if (!same_place(own, place))
      refuse("has " + quoted(name) + " as " + quoted(own) + " (offset, bytes, kind), its caller as " + quoted(place));
  }
}

}  // namespace

extern "C" {

const char* carom_abi_manifest(void) { return kManifest.data(); }

int32_t carom_abi_check(const char* layout, carom_error* error) {
  return carom::abi::guarded(error, [&](carom::abi::Call& call) {
    if (carom::abi::present(call, 1, "layout", layout)) check_layout(call, layout);
  });
}

}  // extern "C"
