// Is a support function valid, and are the declarations that came with it true? Asked when a shape is made.
#pragma once

#include "collision/shape.h"

namespace carom::collision {

/// The verdict, with evidence: the direction that shows the lie and what came back for it.
struct Verdict {
  bool valid = true;
  const char* reason = "";  // static text: "not bitwise repeatable", "depends on the length of the direction", ...
  double dir[3] = {0, 0, 0};
  double out[3] = {0, 0, 0};
};

/// 256 directions: returns 0, finite, bitwise repeatable, independent of the direction's length, within 1e9 m, and
/// pairwise d_i . (p_j - p_i) <= tol, which is exactly the condition that the samples come from a convex set. Needs
/// support, params; reads nothing derived.
Verdict verify_support(const Shape& shape);

/// The declared form (shape.form with radius, half_height, half, vertices, core_radius filled in) has the same support
/// values h(d) as the support function (core radius included) in 256 directions, to 1e-9 of the shape's size.
Verdict verify_form(const Shape& shape, Form form);

/// The declared mass lies inside the bracket that the support function gives.
Verdict verify_mass(const Shape& shape, const MassProperties& declared);

}  // namespace carom::collision
