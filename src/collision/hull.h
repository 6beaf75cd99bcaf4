// Convex polyhedra that grow point by point: the mesh under the hull of a point cloud and under the mass of a support
// function.
#pragma once

#include <array>
#include <span>

#include "collision/fit_frame.h"
#include "core/memory.h"

namespace carom::collision {

/// A closed, convex triangle mesh whose vertices lie on a grid, so that "does this facet see that point?" has an exact
/// result. With rounded results, a cluster of nearly equal points makes facets that tilt anywhere, and then points far
/// away are lost.
class HullMesh {
 public:
  static constexpr std::uint32_t kNoFacet = 0xFFFFFFFFu;

  struct Facet {
    std::uint32_t v[3];     // counter-clockwise seen from outside
    std::uint32_t next[3];  // the facet across the edge v[i] -> v[i + 1]
    Vec3 cross;             // outward, twice the area long, to rounding
    Vec3 normal;            // the same, unit; zero for a sliver, whose direction is lost in that rounding
    Real noise;             // rounding of cross . x is below noise * max|x_i|
    bool alive;
  };
  static constexpr Real kRange = 4;       // coordinates are smaller than this (see FitFrame)
  static constexpr Real kGrid = 0x1p-51;  // and multiples of this: 53 bits, differences exact in a double

  static Vec3 snap(const Vec3& p) {
    return {kGrid * std::round(p.x() / kGrid), kGrid * std::round(p.y() / kGrid), kGrid * std::round(p.z() / kGrid)};
  }
  /// Sign of (q - p) x (r - p) . (x - p), exactly, for points of the grid whose coordinates differ by less than 4.
  static int orientation(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& x);
  static bool in_range(const Vec3& p) { return p.abs().max_entry() < kRange && finite(p); }

  explicit HullMesh(Memory* memory)
      : points_(memory),
        facets_(memory),
        free_(memory),
        horizon_(memory),
        seen_(memory),
        horizon_at_(memory),
        seen_at_(memory),
        created_(memory) {}

  /// Begin with a tetrahedron of either handedness, no flatter than 1e-6. Vertices and facets are numbered 0 to 3.
  void start(Vec3 a, Vec3 b, Vec3 c, Vec3 d);

  /// Whether p lies strictly on the outer side of a facet's plane; exact for the snapped p.
  bool sees(std::uint32_t facet, const Vec3& p) const;

  /// The facets that see p, found from one of them, and the horizon around them. Nothing changes yet.
  /// @param p          in range, seen by facet `seed`
  /// @param tolerance  0: exact. More: facets closer to p than this do not see it, so that a face that is flat but for
  /// rounding is
  ///                   left in peace when a vertex joins it; the mesh is then convex to that tolerance only
  /// @return           number of edges on the horizon, which is how many facets grow() will make; 0 (never if all calls
  /// were exact): the
  ///                   horizon is no simple loop, or a new facet would face the inner point
  std::size_t look(std::uint32_t seed, const Vec3& p, Real tolerance = 0);
  /// Replace the facets that the last look() found by a fan over its horizon. @return the new vertex
  std::uint32_t grow();
  const Array<std::uint32_t>& removed() const { return seen_; }     // by the last grow(); still readable until the next
  const Array<std::uint32_t>& created() const { return created_; }  // by the last grow()

  std::size_t slots() const { return facets_.size(); }
  const Facet& facet(std::uint32_t i) const { return facets_[i]; }
  const Vec3& point(std::uint32_t v) const { return points_[v]; }
  std::size_t points() const { return points_.size(); }
  /// Signed distance of a point from a facet's plane; 0 for a sliver.
  Real height(std::uint32_t facet, const Vec3& p) const {
    return facets_[facet].normal.dot(p - points_[facets_[facet].v[0]]);
  }
  const Vec3& inner() const { return inner_; }  // a point inside, the centre of the first tetrahedron

 private:
  struct Edge {
    std::uint32_t from, to, outside;  // vertices; the facet that stays
  };
  bool horizon_is_sound(const Vec3& p) const;
  Facet make(std::uint32_t a, std::uint32_t b, std::uint32_t c) const;

  Array<Vec3> points_;
  Array<Facet> facets_;
  Array<std::uint32_t> free_;
  Array<Edge> horizon_;
  Array<std::uint32_t> seen_;
  Array<std::uint32_t> horizon_at_;  // by vertex: its edge on the horizon, valid where it points back
  Array<std::uint32_t> seen_at_;     // by facet: its place in seen_, valid where it points back
  Array<std::uint32_t> created_;
  Vec3 next_point_ = Vec3::zero();
  Vec3 inner_ = Vec3::zero();
};

/// Convex hull of points.
/// @param xyz        [3n] x, y, z of each; any order, repeated, collinear, coplanar ones too
/// @param triangles  [3m] indices of points, counter-clockwise seen from outside; drawn from the array's own memory
/// @param frame      if not null: the affine frame in which it was computed, for integrals that must not cancel either
/// @return           false, and no triangles, if the points lie in a plane to rounding or are not finite
/// @accuracy         exact for the points as snapped to a grid of 2^-51 in their fitted frame
/// @source           incremental insertion with lists of outside points, farthest first [Barber1996]
/// @oracle           tests/unit/collision/test_hull
bool convex_hull(std::span<const double> xyz, Array<std::uint32_t>& triangles, FitFrame* frame = nullptr);

/// The frame in which convex_hull works: of any points, flat ones too.
FitFrame fit_frame_of_points(std::span<const double> xyz);

/// Convex hull of points that lie on the mesh's grid already, exactly.
/// @param y          [n] multiples of HullMesh::kGrid, all differences of coordinates below 4
/// @param start      indices of four of them that span as much as they can
/// @param triangles  as above; points within a flat face or a straight edge may be among the vertices
/// @return           false, and no triangles, if the four lie in a plane
bool convex_hull_on_grid(std::span<const Vec3> y, const std::uint32_t start[4], Array<std::uint32_t>& triangles);

}  // namespace carom::collision
