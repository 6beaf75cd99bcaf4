// Numbers of the code that are no dials: each with its unit, why it is what it is, and what breaks if it moves.
//
// A dial trades something that a host may want otherwise. These trade nothing: they stand where measurements or an
// argument put them, and a host reads them (carom_constant_get_info()), but can't set them.
#pragma once

#include "core/vec.h"

namespace carom::core {

/// One such number. The code computes with the object itself; what a host reads is made of it.
template <class T>
struct Constant {
  const char* name;
  T value;
  const char* unit;         // "1" of a share, a ratio or a count of things that the reason names
  const char* reason;       // why it is what it is
  const char* consequence;  // what breaks if it moves

  /// At compile time alone: no code is made of it, in files for newer machines neither.
  consteval operator T() const { return value; }
};

/// One as a host reads it, of whatever type.
struct ConstantRow {
  const char *name = "", *unit = "", *reason = "", *consequence = "";
  Real value = 0;

  constexpr ConstantRow() = default;
  template <class T>
  constexpr ConstantRow(const Constant<T>& c)
      : name(c.name), unit(c.unit), reason(c.reason), consequence(c.consequence), value(static_cast<Real>(c.value)) {}
};

}  // namespace carom::core
