// The flat faces of a declared polytope, for exact clipping: made once with the shape.
#pragma once

#include <span>

#include "core/memory.h"
#include "core/vec.h"

namespace carom::collision {

/// Faces with their corners; triangles of the hull that lie in one plane are one face.
struct HullFaces {
  explicit HullFaces(Memory* memory)
      : normal(memory), area(memory), has_alike(memory), begin(memory), loop(memory), own(memory) {}

  /// rad: faces whose normals enclose less look the same way.
  static constexpr Real kSameWay = 0.045;
  bool look_alike(std::size_t i, std::size_t k) const {
    return normal[i].dot(normal[k]) > 1 - 0.5 * kSameWay * kSameWay;
  }

  Array<Vec3> normal;             // unit, outward
  Array<Real> area;               // m^2
  Array<std::uint8_t> has_alike;  // another face looks the same way
  Array<std::uint32_t> begin;     // [faces + 1] into loop
  Array<std::uint32_t> loop;      // corners (indices of vertices), counter-clockwise seen from outside
  Array<double> own;              // a box's corners; a polytope's vertices lie in its shape's params

  std::size_t count() const { return normal.size(); }
  bool empty() const { return normal.empty(); }
};

/// Faces of the convex hull of points.
/// @param xyz     [3n] m; as convex_hull() takes them
/// @param faces   none if the points lie in a plane
/// @accuracy      triangles within 1e-9 of the extent of a face's plane belong to it, so that a plane that rounding has
///                creased is one face; within 5e-7 of the largest coordinate if all coordinates are single precision; corners that turn by less than 1e-6 rad are left out. A face whose outline is no
///                simple loop (never seen but for such creases) is left out: its shape then falls back to probing there
/// @oracle        tests/unit/collision/test_hull_faces
void make_hull_faces(std::span<const double> xyz, HullFaces& faces);

/// The six faces of a box, corners kept in `own`.
void make_box_faces(const Vec3& half, HullFaces& faces);

struct Shape;
/// Give a shape the faces that its verified form has: box and polytope have some, all others none.
void make_faces(Shape& shape);

}  // namespace carom::collision
