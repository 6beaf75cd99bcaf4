// Declarations of plugins: from indices into parameters to the numbers of a closed form, and what is asked of them.
#pragma once

#include <span>

#include "abi/guard.h"
#include "collision/shape.h"

namespace carom::abi {

/// The numbers of a closed form, as in carom::Shape.
struct FormNumbers {
  Form form = Form::none;
  Real radius = 0;                   // m
  Real half_height = 0;              // m
  Vec3 half = Vec3::zero();          // m
  std::span<const double> vertices;  // [3k] m
};

/// The form is known and each index that it needs is one of `count` declared parameters.
/// @param what  "form" or "mass", for the message
bool form_args_exist(Call& call, const char* id, const char* what, std::uint32_t form, const std::uint32_t arg[4],
                     std::uint32_t count);

/// Read the numbers of a declared form out of a shape's parameters.
/// @errors DECLARATION_FALSE: a negative size, or a polytope whose coordinates are not triples
bool read_form(Call& call, const char* id, std::uint32_t form, const std::uint32_t arg[4],
               std::span<const double> params, FormNumbers& numbers);

/// Ask the support function in 256 directions.
/// @errors PLUGIN_INVALID with the witness, also where it changed the floating-point environment
bool ask_valid(Call& call, const char* id, int argument, const Shape& shape);

}  // namespace carom::abi
