// What a host may say of a body beside its descriptor, one row each: a name, numbers, bounds, what bodies have that no
// host spoke of. CONTRIBUTING.md says how to add one.
//
// The row is all there is to write, with the field of carom_body_desc that it names. A column grows when the first body gets something else; bodies that come have the usual
// value; whoever gets another wakes; snapshots hold it, and with them forks and recordings; the plan counts its memory to its
// effect; carom_body_set_attribute(), scene files and bindings reach it by its row.
#pragma once

#include <array>
#include <limits>
#include <utility>

#include "core/memory.h"
#include "core/vec.h"
#include "dynamics/effect_rows.h"

namespace carom::dynamics {

enum class AttributeId : std::uint32_t {  // as CAROM_ATTRIBUTE_*
  gravity_factor,
  locks,
  drag,
  force_field_mask,
  magnetic_moment,
  count
};
constexpr std::size_t operator+(AttributeId id) { return static_cast<std::size_t>(id); }
inline constexpr std::size_t kAttributeCount = +AttributeId::count;

inline constexpr std::size_t kMostNumbers = 4;          // of an attribute, as CAROM_ATTRIBUTE_NUMBERS
using AttributeValue = std::array<Real, kMostNumbers>;  // those that an attribute does not have are 0

/// How a snapshot holds a number: a double, or a whole number of one byte or four.
enum class StoredAs : std::uint8_t { real, byte, word };

struct AttributeRow {
  AttributeId id{};
  const char* name = nullptr;
  const char* unit = nullptr;  // of its numbers, one after the other
  const char* what = nullptr;
  EffectId effect{};  // its participants have it
  std::uint32_t numbers = 1;
  Real min = 0, max = 0;             // of each
  StoredAs stored = StoredAs::real;  // what is stored as a whole number is one
  bool of_dynamic = false;           // others have the usual value alone
  AttributeValue usual{};
  /// Fields of carom_body_desc that say it: one for all its numbers, or one for each. None: bodies are made with the usual value.
  std::array<const char*, kMostNumbers> fields{};
};

inline constexpr Real kAnyNumber = std::numeric_limits<Real>::max();

// clang-format off
inline constexpr AttributeRow kAttributeTable[] = {
    {.id = AttributeId::gravity_factor, .name = "gravity_factor", .unit = "1",
     .what = "times the world's gravity; below 0 the body rises",
     .effect = EffectId::gravity, .min = -kAnyNumber, .max = kAnyNumber, .usual = {1},
     .fields = {"gravity_factor"}},
    {.id = AttributeId::locks, .name = "locks", .unit = "1",
     .what = "axes of the world along and about which the body does not move: bits CAROM_LOCK_*",
     .effect = EffectId::axis_locks, .max = 63, .stored = StoredAs::byte, .of_dynamic = true,
     .fields = {"locks"}},
    {.id = AttributeId::drag, .name = "drag", .unit = "kg/s, kg/m",
     .what = "what air takes: F = -(linear + quadratic |u|) u, u the velocity relative to the wind",
     .effect = EffectId::drag, .numbers = 2, .max = 1e12,
     .fields = {"linear_drag", "quadratic_drag"}},
    {.id = AttributeId::force_field_mask, .name = "force_field_mask", .unit = "1",
     .what = "fields that share a bit with it act on the body",
     .effect = EffectId::fields, .max = 4294967295.0, .stored = StoredAs::word, .usual = {1},
     .fields = {"force_field_mask"}},
    {.id = AttributeId::magnetic_moment, .name = "magnetic_moment", .unit = "A m^2, A m^2, A m^2",
     .what = "by which magnetic fields turn the body, in its own axes",
     .effect = EffectId::magnetism, .numbers = 3, .min = -1e12, .max = 1e12,
     .fields = {"magnetic_moment"}},
};
// clang-format on
static_assert(std::size(kAttributeTable) == kAttributeCount);
constexpr const AttributeRow& row_of(AttributeId id) { return kAttributeTable[+id]; }

/// Where a value is not one that a body may have.
struct AttributeFault {
  std::uint32_t number = 0;  // which of them
  enum class Kind : std::uint8_t { none, not_finite, out_of_range, not_whole, surplus } kind = Kind::none;
};
AttributeFault fault_of(const AttributeRow& row, const AttributeValue& value);

/// The attributes of all bodies: a column for each, by body slot, its numbers side by side; the first so many bodies, the
/// others have the usual value.
class BodyAttributes {
 public:
  explicit BodyAttributes(Memory* m) : BodyAttributes(m, std::make_index_sequence<kAttributeCount>()) {}

  /// A number of one, as fast as an array. @param k  which of its numbers
  template <AttributeId id>
  Real number(std::uint32_t body, std::size_t k = 0) const {
    static_assert(kAttributeTable[+id].id == id);
    constexpr const AttributeRow& row = kAttributeTable[+id];
    const Array<Real>& all = column_[+id];
    const std::size_t at = row.numbers * std::size_t(body) + k;
    return at < all.size() ? all[at] : row.usual[k];
  }
  AttributeValue of(AttributeId id, std::uint32_t body) const;
  /// How many bodies have a place in its column; the others have the usual value.
  std::uint32_t bodies(AttributeId id) const {
    return static_cast<std::uint32_t>(column_[+id].size() / row_of(id).numbers);
  }
  /// Memory, in bytes, of those of an effect.
  std::uint64_t bytes_of(EffectId effect) const;

  /// A place for so many bodies. May run out of memory; then nothing has changed.
  void reserve(AttributeId id, std::uint32_t bodies);
  /// There is capacity.
  void set(AttributeId id, std::uint32_t body, const AttributeValue& value);
  /// The usual values: of a body that goes, so that whoever gets its slot has them, and of all.
  void reset(std::uint32_t body);
  void reset_all();

 private:
  template <std::size_t... I>
  BodyAttributes(Memory* m, std::index_sequence<I...>) : column_{((void)I, Array<Real>(m))...} {}
  std::array<Array<Real>, kAttributeCount> column_;
};

}  // namespace carom::dynamics
