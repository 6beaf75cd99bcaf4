// The layout of every public struct: offsets, sizes and kinds are what this compiler makes of the headers.
// Which rows there are stands in manifest_rows.inc, which bindings/gen writes from the headers.
#pragma once

#include <carom/carom.h>

#include <cstddef>
#include <string_view>
#include <type_traits>

namespace carom::abi {

/// A public struct, or a field of one.
struct LayoutRow {
  std::string_view name;
  std::size_t offset, size;
  std::string_view kind;
  std::size_t count;  // of an array, else 0
};

namespace layout {
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

template <typename T>
constexpr LayoutRow row(std::string_view name, std::size_t offset) {
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

}  // namespace layout

#define CAROM_STRUCT(type) layout::row<type>(#type, 0),
#define CAROM_FIELD(type, field) layout::row<decltype(type::field)>(#type "." #field, offsetof(type, field)),
inline constexpr LayoutRow kLayout[] = {
#include "manifest_rows.inc"
};
#undef CAROM_STRUCT
#undef CAROM_FIELD

/// By name, "carom_body_desc.locks"; null: there is none.
constexpr const LayoutRow* find_in_layout(std::string_view name) {
  for (const LayoutRow& row : kLayout)
    if (row.name == name) return &row;
  return nullptr;
}

}  // namespace carom::abi
