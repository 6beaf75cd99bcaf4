// Seams: where two colliders that stand still against each other meet flush, a body is to feel one ground.
//
// The narrow phase knows two shapes at a time. It takes the side of the next tile for a wall, and its edge for a ridge,
// though the tile before covers both. A contact of the second ground is real only if the union of the two lets the body
// be pushed that way: if the union near the place lies below the plane that the contact pushes with, or if the
// ground's face that looks along the normal stands out above the first ground.
#pragma once

#include "collision/cast/overlap.h"
#include "core/pose.h"

namespace carom::collision {

/// What a body touches, where it stands.
struct Ground {
  const Shape& shape;  // convex, half-space or scenery
  const Frame& frame;  // shape -> world
};

/// How a body touches it.
struct GroundTouch {
  Vec3 normal;  // unit, world, from the ground to the body
  Vec3 point;   // m, world, on the ground
};

struct SeamTerms {
  Real size;   // m: what lies farther from the place than this does not matter; the body's bounding radius
  Real flush;  // m: what stands out by less is level, what is less far apart has no gap between
  int cap;     // support evaluations of a query
};

/// What a body's contact is beside another one of the same body with the same ground.
///   real      it bars a way that the other one does not, or looks the same way to 1e-6 rad
///   level     what it pushes from stands out nowhere above the plane of the other: a ghost where a neighbour covers it
///   ghost     likewise, and it bars the way along that plane: it is one whether covered or not
/// @param touch  of the body with `of`   @param plane  of the same body with another collider
/// @accuracy     to `flush`
/// @oracle       tests/oracle/test_seams
enum class Beside { real, level, ghost };
Beside compare(const Ground& of, const GroundTouch& touch, const GroundTouch& plane, const SeamTerms& terms);

/// Whether a neighbour covers the place of a contact and goes on beyond the plane that it pushes with.
bool covers(const Ground& neighbour, const GroundTouch& touch, const SeamTerms& terms);

}  // namespace carom::collision
