// A triangle of scenery as a shape of its own, for whom only knows convex shapes.
#pragma once

#include "collision/scenery/scenery.h"
#include "collision/shape.h"

namespace carom::collision {

/// One triangle after another as a flat polytope about its middle. Allocates when it is made and never again.
class TriangleShape {
 public:
  explicit TriangleShape(Memory* memory);

  /// @param triangle  as it faces
  void set(const Triangle& triangle);
  /// Other corners in the same plane, about the same origin.
  void reshape(const std::array<Vec3, 3>& corner);
  const Shape& shape() const { return shape_; }
  const Vec3& origin() const { return origin_; }  // m, scenery's frame: where the shape's own origin lies

 private:
  Shape shape_;
  Vec3 origin_ = Vec3::zero();
};

/// Make a shape one of scenery: form, bounds, no volume.
void make_scenery(std::shared_ptr<const Scenery> scenery, Shape& shape);

/// Turn a triangle towards a point: a two-sided one is turned over if the point lies behind it.
/// @param point  m, scenery's frame
/// @return       false: the surface has one side, and the point is behind it
bool face(const Scenery& scenery, const Vec3& point, Triangle& triangle);

/// Corner of a turned triangle as Scenery counts it.
inline int own_corner(const Triangle& triangle, int k) { return triangle.turned ? (3 - k) % 3 : k; }

}  // namespace carom::collision
