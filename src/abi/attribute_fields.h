// Attributes in a body's descriptor: which field says which, as the rows of kAttributeTable name them, and where it lies.
#pragma once

#include <algorithm>
#include <array>
#include <cstring>

#include "abi/layout.h"
#include "dynamics/body_attributes.h"

namespace carom::abi {

using dynamics::AttributeRow;
using dynamics::AttributeValue;

/// Where a descriptor has the numbers of an attribute, as its row says.
struct AttributeField {
  struct Number {
    std::size_t offset = 0;
    std::array<char, 48> name{};  // as a host knows it
  };
  std::array<Number, dynamics::kMostNumbers> number{};
};
/// At compile time: what it throws is what the compiler says.
constexpr AttributeField field_of(const AttributeRow& row) {
  AttributeField found{};
  const std::string_view first = row.fields[0] ? row.fields[0] : "";
  for (std::uint32_t k = 0; k < row.numbers && !first.empty(); ++k) {
    const bool of_its_own = row.fields[1] != nullptr;  // each number a field, not an array of them
    const std::string_view name = of_its_own ? row.fields[k] : first;
    constexpr std::string_view kStruct = "carom_body_desc.", kArgument = "desc->";
    std::array<char, 64> path{};
    std::copy(name.begin(), name.end(), std::copy(kStruct.begin(), kStruct.end(), path.begin()));
    const LayoutRow* const there = find_in_layout(path.data());
    if (!there) throw "a row of kAttributeTable names a field that carom_body_desc does not have";
    if (there->kind != (row.stored == dynamics::StoredAs::real ? "f64" : "u32"))
      throw "a field of carom_body_desc is a double where its row of kAttributeTable stores a real number, else a uint32_t";
    if (std::max<std::size_t>(there->count, 1) != (of_its_own ? 1 : row.numbers))
      throw "a field of carom_body_desc has not as many numbers as its row of kAttributeTable";
    AttributeField::Number& number = found.number[k];
    number.offset = there->offset + (of_its_own ? 0 : k * sizeof(double));
    std::copy(name.begin(), name.end(), std::copy(kArgument.begin(), kArgument.end(), number.name.begin()));
  }
  return found;
}
inline constexpr std::array<AttributeField, dynamics::kAttributeCount> kAttributeFields = [] {
  std::array<AttributeField, dynamics::kAttributeCount> fields{};
  for (std::size_t k = 0; k < dynamics::kAttributeCount; ++k) fields[k] = field_of(dynamics::kAttributeTable[k]);
  return fields;
}();

/// Not of an attribute that no field says.
inline AttributeValue value_in(const carom_body_desc& d, const AttributeRow& row) {
  AttributeValue value{};
  for (std::size_t k = 0; k < std::min<std::size_t>(row.numbers, dynamics::kMostNumbers); ++k) {
    const char* const from = reinterpret_cast<const char*>(&d) + kAttributeFields[+row.id].number[k].offset;
    std::uint32_t word = 0;
    if (row.stored == dynamics::StoredAs::real)
      std::memcpy(&value[k], from, sizeof value[k]);
    else
      std::memcpy(&word, from, sizeof word), value[k] = word;
  }
  return value;
}
inline void put_value(const AttributeValue& value, const AttributeRow& row, carom_body_desc& d) {
  for (std::size_t k = 0; k < std::min<std::size_t>(row.numbers, dynamics::kMostNumbers); ++k) {
    char* const to = reinterpret_cast<char*>(&d) + kAttributeFields[+row.id].number[k].offset;
    const auto word = static_cast<std::uint32_t>(row.stored == dynamics::StoredAs::real ? 0 : value[k]);
    if (row.stored == dynamics::StoredAs::real)
      std::memcpy(to, &value[k], sizeof value[k]);
    else
      std::memcpy(to, &word, sizeof word);
  }
}

/// f(row) for each attribute that a descriptor says.
template <class F>
void each_field(F&& f) {
  for (const AttributeRow& row : dynamics::kAttributeTable)
    if (row.fields[0]) f(row);
}

}  // namespace carom::abi
