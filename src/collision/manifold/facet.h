// The part of a shape's core that faces a direction: a flat face, an edge or a point, found by support calls alone.
#pragma once

#include "collision/shape.h"
#include "core/pose.h"

namespace carom::collision {

/// What of a core meets another shape that comes along `normal`, in the shape's own frame.
struct Facet {
  enum Rank : std::uint32_t { point, edge, face, plane };  // plane: a half-space's, without corners
  static constexpr int kAzimuths = 8;

  Rank rank = point;
  bool round =
      false;     // across its flat directions the core is curved: where it lies depends on the normal (see settle)
  int ring = 0;  // of an edge: which ring found it
  int count = 0;
  Vec3 corner[kAzimuths];        // m; of a face counter-clockwise about `normal`, of an edge its two ends
  Vec3 normal = Vec3::unit_y();  // unit; of a face its outward normal, else the direction asked for
  Vec3 along = Vec3::unit_x();   // unit; of an edge
  Vec3 tip = Vec3::zero();       // m: a support point along the direction asked for

  // Corners of a declared polytope's face (clip): vertices[3 loop[i]], in place of `corner`
  const HullFaces* faces = nullptr;
  const double* vertices = nullptr;
  const std::uint32_t* loop = nullptr;
  // Of several faces that look the same way but for a little, all corners, ascending, in place of the loop of one
  static constexpr std::size_t kMostUnited = 64, kMostCorners = 192;
  std::size_t united = 0;  // faces; 0: it is one
  std::uint32_t united_face[kMostUnited], united_corner[kMostCorners];

  std::uint32_t vertex(int i) const { return united > 0 ? united_corner[i] : loop[i]; }
  Vec3 at(int i) const {
    if (!loop) return corner[i];
    const double* v = vertices + 3 * static_cast<std::size_t>(vertex(i));
    return Vec3(v[0], v[1], v[2]);
  }
  /// Which corner it is, for matching points between steps; 0 where only support points are known.
  std::uint32_t name(int i) const { return loop ? vertex(i) + 1 : 0; }
};

/// Asks one core, and counts.
struct Prober {
  const Shape& shape;
  std::uint64_t& calls;
  SupportFault& fault;
  bool operator()(const Vec3& d, Vec3& out) const;
};

/// A unit vector at right angles to n that depends on n alone and jumps only where |n.x| or |n.y| is 0.58: no face that
/// is built along axes, or square to a diagonal, sits on that seam, so azimuths measured from it stay put in a body.
Vec3 steady_perpendicular(const Vec3& n);

/// Fit the facet that faces along n.
/// @param n   unit, shape frame, within 0.02 rad of the normal of the facet that is meant
/// @param reach  m: of a body that falls fast, or is small, a face is found that leans by more (see leaning), since its
///            far corners, too, may touch within the step
/// @return    false if the support function misbehaved
/// @accuracy  9 support calls where one ring is enough, 17 or 23 else. Normal of a face of corners: 4 u size / width.
///            Of a rim or a rounded face, and `along` of an edge of one: third order in the last ring's tilt (1e-8)
/// @oracle    tests/unit/collision/test_patch
bool fit_facet(const Prober& probe, const Vec3& n, Real reach, Facet& facet);

/// How far a face may lean for its far side to lie within reach, rad: one that leans more is an edge or a corner.
Real leaning(const Shape& shape, Real reach);

/// Put a round facet where it lies for a contact along n (unit, within 0.05 rad of the facet's own). At most 4
/// calls, and 25 with those of fit_facet. An edge that is not there any more becomes a point.
bool settle_facet(const Prober& probe, const Vec3& n, Facet& facet);

}  // namespace carom::collision
