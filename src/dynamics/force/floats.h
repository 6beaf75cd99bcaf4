// How much of a convex shape is under a plane, and where its middle is.
#pragma once

#include "collision/shape.h"
#include "dynamics/scene.h"

namespace carom::dynamics {

struct Submerged {
  Real volume = 0;             // m^3
  Vec3 moment = Vec3::zero();  // m^4: volume times centroid
};

/// Whether a shape has a volume that floats: bounded, convex, not flat.
bool floats(const Shape& shape);

/// The part of a shape where n . x <= level.
/// @param surface  of it, but of balls and ellipsoids: those have a closed form
/// @param n      unit, shape frame   @param level  m
/// @return       in the shape's frame
/// @accuracy     balls, ellipsoids, boxes and hulls to rounding. Others by 256 support points, blown up to the volume
///               of the shape: all of it to rounding, a part to 1e-2 of the whole at worst
/// @oracle       tests/oracle/test_forces
Submerged under_plane(const Shape& shape, const Float* surface, const Vec3& n, Real level);

/// Surfaces for the shapes of all colliders, where they are not there yet; those of others go.
void make_floats(const Colliders& c, Floats& water, Memory* memory);

}  // namespace carom::dynamics
