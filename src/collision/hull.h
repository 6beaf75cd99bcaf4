// Convex polyhedra that grow point by point: the mesh under the hull of a point cloud and under the mass of a support
// function.
#pragma once

#include <array>
#include <span>

#include "core/memory.h"
#include "core/vec.h"

namespace carom {

/// A closed, convex (to rounding) triangle mesh. Coordinates of about 1 are assumed (see FitFrame).
class HullMesh {
 public:
  static constexpr std::uint32_t kNoFacet = 0xFFFFFFFFu;

  struct Facet {
    std::uint32_t v[3];     // counter-clockwise seen from outside
    std::uint32_t next[3];  // the facet across the edge v[i] -> v[i + 1]
    Vec3 normal;            // unit, outward; zero for a sliver (an area that rounding cannot tell from none)
    Real area;
    bool alive;
  };

  explicit HullMesh(Memory* memory)
      : points_(memory),
        facets_(memory),
        free_(memory),
        rim_(memory),
        seen_(memory),
        rim_at_(memory),
        seen_at_(memory),
        created_(memory) {}

  /// Begin with a tetrahedron, (b-a) x (c-a) . (d-a) > 0. Vertices are numbered 0 to 3, facets too.
  void start(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

  /// The facets that see p, found from one of them, and the rim around them. Nothing changes yet.
  /// @param p          a point outside facet `seed`
  /// @param tolerance  a facet closer to p than this does not see it
  /// @return           number of edges on the rim, which is how many facets grow() will make; 0 when the rim is no
  /// simple loop or a
  ///                   new facet would turn its back (p is within rounding of the surface): then p cannot be added
  std::size_t look(std::uint32_t seed, const Vec3& p, Real tolerance);
  /// Replace the facets that the last look() found by a fan over its rim. @return the new vertex
  std::uint32_t grow();
  const Array<std::uint32_t>& removed() const { return seen_; }     // by the last grow(); still readable until the next
  const Array<std::uint32_t>& created() const { return created_; }  // by the last grow()

  std::size_t slots() const { return facets_.size(); }
  const Facet& facet(std::uint32_t i) const { return facets_[i]; }
  const Vec3& point(std::uint32_t v) const { return points_[v]; }
  std::size_t points() const { return points_.size(); }
  /// Signed distance of a point from a facet's plane.
  Real height(std::uint32_t facet, const Vec3& p) const {
    return facets_[facet].normal.dot(p - points_[facets_[facet].v[0]]);
  }
  const Vec3& inner() const { return inner_; }  // a point inside, the centre of the first tetrahedron

 private:
  struct Edge {
    std::uint32_t from, to, outside;  // vertices; the facet that stays
  };
  Facet make(std::uint32_t a, std::uint32_t b, const Vec3& p, std::uint32_t v) const;

  Array<Vec3> points_;
  Array<Facet> facets_;
  Array<std::uint32_t> free_;
  Array<Edge> rim_;
  Array<std::uint32_t> seen_;
  Array<std::uint32_t> rim_at_;   // by vertex: its edge on the rim, valid where it points back
  Array<std::uint32_t> seen_at_;  // by facet: its place in seen_, valid where it points back
  Array<std::uint32_t> created_;
  Vec3 next_point_ = Vec3::Zero();
  Vec3 inner_ = Vec3::Zero();
};

/// Convex hull of points.
/// @param xyz        [3n] x, y, z of each; any order, repeated, collinear, coplanar ones too
/// @param triangles  [3m] indices of points, counter-clockwise seen from outside; drawn from the array's own memory
/// @return           false, and no triangles, if the points lie in a plane to rounding
/// @accuracy         no point lies outside by more than some 16 u of the coordinates (needles: times their aspect)
/// @source           incremental insertion with lists of outside points, farthest first [Barber1996]
/// @oracle           tests/unit/collision/test_hull
bool convex_hull(std::span<const double> xyz, Array<std::uint32_t>& triangles);

}  // namespace carom
