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

/// Whether the ground beside takes the place of a contact: the body's contact with it stays, and no other way is
/// barred by `of` than what that contact bars.
/// @param touch  of the body with `of`    @param its  of the same body with `beside`
/// @accuracy     to `flush`; directions of `touch` and `its` that differ by less than 1e-6 rad are one: false
/// @oracle       tests/unit/collision/scenery/test_seam, tests/oracle/test_seams
bool is_ghost(const Ground& of, const GroundTouch& touch, const Ground& beside, const GroundTouch& its,
              const SeamTerms& terms);

}  // namespace carom::collision
