// The hybrid: every shape wears a thin shell, so that resting contact is a matter of distances between cores that stay
// apart.
#pragma once

#include "collision/narrow/query.h"

namespace carom::collision {

/// Thickness of shell that a method adds to both shapes together.
///
/// Cores apart: GJK gives their distance, and what is left of it after radii and shells is the result. Only where the
/// shapes themselves overlap, shells pierced, does EPA run. Under Method::hybrid the shapes are thus `margin` larger
/// all around, with rounded edges: the separation is 2 margin smaller than the truth and the witness points lie on the
/// shells. That inflation is the dial's error; the bracket is of the shapes with their shells.
/// @return m, >= 0
/// @source [vdBergen2003 §4.3.8]
inline Real shells(const QuerySettings& settings) {
  return settings.method == Method::hybrid && settings.margin > 0 ? 2 * settings.margin : 0;
}

}  // namespace carom::collision
