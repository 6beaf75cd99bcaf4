#include "dynamics/body_attributes.h"

#include <algorithm>
#include <cmath>

namespace carom::dynamics {
namespace {

constexpr bool attributes_stand_in_order() {
  for (std::size_t k = 0; k < kAttributeCount; ++k) {
    const AttributeRow& row = kAttributeTable[k];
    if (+row.id != k || row.numbers < 1 || row.numbers > kMostNumbers || !row.name || !row.unit || !row.what)
      return false;
    if (row.min > row.max) return false;
  }
  return true;
}
static_assert(attributes_stand_in_order());

}  // namespace

AttributeFault fault_of(const AttributeRow& row, const AttributeValue& value) {
  using enum AttributeFault::Kind;
  for (std::uint32_t k = 0; k < kMostNumbers; ++k) {
    const Real x = value[k];
    if (!std::isfinite(x)) return {k, not_finite};
    if (k >= row.numbers && x != 0) return {k, surplus};
    if (k < row.numbers && (x < row.min || x > row.max)) return {k, out_of_range};
    if (row.stored != StoredAs::real && x != std::floor(x)) return {k, not_whole};
  }
  return {};
}

AttributeValue BodyAttributes::of(AttributeId id, std::uint32_t body) const {
  const AttributeRow& row = row_of(id);
  if (body >= bodies(id)) return row.usual;
  AttributeValue value{};
  std::copy_n(column_[+id].begin() + std::ptrdiff_t(row.numbers) * body, row.numbers, value.begin());
  return value;
}

std::uint64_t BodyAttributes::bytes_of(EffectId effect) const {
  std::uint64_t sum = 0;
  for (const AttributeRow& row : kAttributeTable)
    if (row.effect == effect) sum += column_[+row.id].capacity() * sizeof(Real);
  return sum;
}

void BodyAttributes::reserve(AttributeId id, std::uint32_t bodies) {
  Array<Real>& all = column_[+id];
  const AttributeRow& row = row_of(id);
  const std::size_t wanted = row.numbers * std::size_t(bodies);
  if (all.size() >= wanted) return;
  all.reserve(wanted);
  while (all.size() < wanted) all.push_back(row.usual[all.size() % row.numbers]);
}

void BodyAttributes::set(AttributeId id, std::uint32_t body, const AttributeValue& value) {
  const AttributeRow& row = row_of(id);
  std::copy_n(value.begin(), row.numbers, column_[+id].begin() + std::ptrdiff_t(row.numbers) * body);
}

void BodyAttributes::reset(std::uint32_t body) {
  for (const AttributeRow& row : kAttributeTable)
    if (body < bodies(row.id)) set(row.id, body, row.usual);
}

void BodyAttributes::reset_all() {
  for (const AttributeRow& row : kAttributeTable)
    for (std::uint32_t i = 0; i < bodies(row.id); ++i) set(row.id, i, row.usual);
}

}  // namespace carom::dynamics
