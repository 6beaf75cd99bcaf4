// Surfaces of many triangles: a mesh, or a height field. What is kept, and one triangle with its surroundings.
#pragma once

#include <array>
#include <span>

#include "collision/broad/query_tree.h"
#include "core/invalid.h"
#include "core/pose.h"

namespace carom::collision {

/// One triangle of a surface, in the scenery's frame.
struct Triangle {
  std::uint32_t index = kInvalid;
  std::array<Vec3, 3> corner;  // m, counter-clockwise as seen from where `normal` points
  Vec3 normal;                 // unit
  std::array<Vec3, 3>
      far;  // m: the corner beyond side i (from corner i to the next); that of the triangle that shares it
  std::array<bool, 3> boundary;  // side i has nothing beyond
  bool turned = false;           // corners 1 and 2 have changed places, so that the normal points the other way
};

/// Immutable once made; belongs to a Shape.
struct Scenery {
  explicit Scenery(Memory* memory) : vertex(memory), corner(memory), beyond(memory), heights(memory), tree(memory) {}

  bool two_sided = false;
  Aabb bounds;  // m

  // A mesh:
  Array<Vec3> vertex;           // m, each place once
  Array<std::uint32_t> corner;  // [3 triangles] vertices
  Array<std::uint32_t> beyond;  // [3 triangles] the triangle beyond each side, or kInvalid
  std::uint32_t dropped = 0;    // triangles of the host's that have no area

  // A height field: vertices (column * spacing_x, height, row * spacing_z), two triangles to a cell, met from above.
  std::uint32_t columns = 0, rows = 0;
  Real spacing_x = 1, spacing_z = 1;  // m
  Array<double> heights;              // [rows][columns] m; a cell with a corner that is no number is a hole

  QueryTree tree;  // of triangles; of a height field, of blocks of kBlock x kBlock cells
  static constexpr std::uint32_t kBlock = 8;

  std::size_t bytes() const {
    return sizeof *this + vertex.size() * sizeof(Vec3) + (corner.size() + beyond.size()) * sizeof(std::uint32_t) +
           heights.size() * sizeof(double) + tree.bytes();
  }
  bool is_field() const { return columns > 0; }
  std::uint32_t triangles() const {
    return is_field() ? 2 * (columns - 1) * (rows - 1) : static_cast<std::uint32_t>(corner.size() / 3);
  }
  /// @return  false: a hole
  bool triangle(std::uint32_t index, Triangle& out) const;

  /// Of a height field: the triangle that stands over or under a point, by x and z alone. @return  false: none does
  bool triangle_over(const Vec3& point, Triangle& out) const;
  /// Whether a triangle of a height field stands over or under a point; on a side of two, both do.
  bool is_over(std::uint32_t index, const Vec3& point) const;

  /// Call f(index) for triangles whose bounds may overlap a box in the scenery's frame, in an order that follows from
  /// the box and the scenery alone.
  template <class F>
  void each_near(const Aabb& box, F&& f) const {
    if (!QueryTree::reaches(box)) return each(f);
    float limit = 0;
    tree.search(QueryTree::Box(tree, box), limit, [&](std::uint32_t leaf) {
      if (is_field())
        each_of_block(leaf, [&](std::uint32_t index) {
          if (field_bounds(index).overlaps(box)) f(index);
        });
      else
        f(leaf);
    });
  }
  /// Call f(index) for triangles that a box swept along a line may meet, roughly near ones first; f says up to which
  /// way (m) others are still of interest.
  /// @param extent  m, what is swept: a box about the point that goes along the line
  template <class F>
  void each_along(const Vec3& from, const Vec3& unit, const Aabb& extent, Real length, F&& f) const {
    if (!QueryTree::reaches(from) || !QueryTree::reaches(extent)) return each(f);
    float limit = QueryTree::above(length);
    const QueryTree::Line line(tree, from, unit, extent);
    tree.search(line, limit, [&](std::uint32_t leaf) {
      const auto ask = [&](std::uint32_t index) { limit = std::min(limit, QueryTree::above(f(index))); };
      if (is_field())
        each_of_block(leaf, ask);
      else
        ask(leaf);
    });
  }
  /// Likewise for triangles within a distance of a box, which f may lower.
  template <class F>
  void each_around(const Aabb& box, Real distance, F&& f) const {
    if (!QueryTree::reaches(box)) return each(f);
    const auto limited = [](Real d) { return d > 0 ? QueryTree::above(d * d) : QueryTree::above(0); };
    float limit = limited(distance);
    tree.search(QueryTree::Box(tree, box), limit, [&](std::uint32_t leaf) {
      const auto ask = [&](std::uint32_t index) { limit = std::min(limit, limited(f(index))); };
      if (is_field())
        each_of_block(leaf, ask);
      else
        ask(leaf);
    });
  }

  /// Whether the surface falls away from a corner of a triangle on all hands, as seen along n.
  /// @param k  of an unturned triangle
  bool falls_away_around(const Triangle& triangle, int k, const Vec3& n) const;
  /// Whether a point lies in front of all triangles around a corner (behind all, for a turned triangle).
  bool is_before_all_around(const Triangle& triangle, int k, const Vec3& point) const;

 private:
  friend void make_height_field(std::span<const double>, std::uint32_t, std::uint32_t, Real, Real, Scenery&);
  /// Call f(corners) for the triangles around a corner of one of them, counter-clockwise each, until it says no.
  template <class F>
  bool all_around(const Triangle& triangle, int k, F&& f) const;
  /// All triangles: for who asks from beyond the tree's reach.
  template <class F>
  void each(F&& f) const {
    for (std::uint32_t index = 0; index < triangles(); ++index) f(index);
  }
  template <class F>
  void each_of_block(std::uint32_t block, F&& f) const {
    const std::uint32_t across = (columns - 2) / kBlock + 1, cells = columns - 1;
    const std::uint32_t row = block / across * kBlock, column = block % across * kBlock;
    for (std::uint32_t z = row; z < std::min(row + kBlock, rows - 1); ++z)
      for (std::uint32_t x = column; x < std::min(column + kBlock, cells); ++x)
        for (std::uint32_t half = 0; half < 2; ++half) f(2 * (z * cells + x) + half);
  }
  Vec3 place(std::uint32_t column, std::uint32_t row) const {
    return Vec3(spacing_x * column, heights[std::size_t(row) * columns + column], spacing_z * row);
  }
  Aabb field_bounds(std::uint32_t index) const;
  bool field_triangle(std::uint32_t index, Triangle& out) const;
  bool field_corners(std::uint32_t index, std::array<Vec3, 3>& corner) const;
};

/// Fill a mesh: corners at the same place become one, neighbours are found, the tree is built.
/// @param xyz        [3n] m, finite
/// @param triangles  [3k] indices of vertices, all below n
/// Triangles without area (their least height below 1e-12 of their longest side) are dropped and counted.
void make_mesh(std::span<const double> xyz, std::span<const std::uint32_t> triangles, bool two_sided, Scenery& scenery);

/// Fill a height field. @param heights  [rows][columns] m; not a number: no vertex, the cells around it are holes
void make_height_field(std::span<const double> heights, std::uint32_t columns, std::uint32_t rows, Real spacing_x,
                       Real spacing_z, Scenery& scenery);

}  // namespace carom::collision
