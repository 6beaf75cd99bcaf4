// The layout of every public struct, as text: offsets, sizes and kinds are what this compiler makes of the headers.
// Which rows there are stands in manifest_rows.inc, which bindings/gen writes from the headers.
#include <carom/carom.h>

#include <array>
#include <cstddef>
#include <string_view>
#include <type_traits>

namespace {

template <typename T>
constexpr std::string_view kind() {
  static_assert(sizeof(T) == 0, "a field of a type that the boundary does not know: see ABI.md, conventions");
  return "";
}
template <>
constexpr std::string_view kind<char>() {
  return "char";
}
template <>
constexpr std::string_view kind<std::int32_t>() {
  return "i32";
}
template <>
constexpr std::string_view kind<std::uint32_t>() {
  return "u32";
}
template <>
constexpr std::string_view kind<std::uint64_t>() {
  return "u64";
}
template <>
constexpr std::string_view kind<double>() {
  return "f64";
}

struct Row {
  std::string_view name;
  std::size_t offset, size;
  std::string_view kind;
  std::size_t count;  // of an array, else 0
};

template <typename T>
constexpr Row row(std::string_view name, std::size_t offset) {
  if constexpr (std::is_array_v<T>) {
    static_assert(std::rank_v<T> == 1);
    return {name, offset, sizeof(T), kind<std::remove_extent_t<T>>(), std::extent_v<T>};
  } else if constexpr (std::is_pointer_v<T>) {
    return {name, offset, sizeof(T), std::is_function_v<std::remove_pointer_t<T>> ? "fn" : "ptr", 0};
  } else if constexpr (std::is_class_v<T>) {
    return {name, offset, sizeof(T), "struct", 0};
  } else {
    return {name, offset, sizeof(T), kind<T>(), 0};
  }
}

#define CAROM_STRUCT(type) row<type>(#type, 0),
#define CAROM_FIELD(type, field) row<decltype(type::field)>(#type "." #field, offsetof(type, field)),
constexpr Row kRows[] = {
#include "manifest_rows.inc"
};
#undef CAROM_STRUCT
#undef CAROM_FIELD

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
  for (const Row& row : kRows) {
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
