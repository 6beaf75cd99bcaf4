#include "collision/scenery/triangle_shape.h"

#include <algorithm>
#include <utility>

namespace carom::collision {
namespace {

std::int32_t farthest_corner(void*, const double* xyz, std::uint64_t, const double d[3], double out[3]) {
  int best = 0;
  double most = 0;
  for (int k = 0; k < 3; ++k) {
    const double along = d[0] * xyz[3 * k] + d[1] * xyz[3 * k + 1] + d[2] * xyz[3 * k + 2];
    if (k == 0 || along > most) best = k, most = along;
  }
  for (int i = 0; i < 3; ++i) out[i] = xyz[3 * best + i];
  return 0;
}

}  // namespace

TriangleShape::TriangleShape(Memory* memory) : shape_(memory) {
  shape_.support = farthest_corner;
  shape_.params.assign(9, 0.0);
  shape_.vertices = shape_.params;
  shape_.faces.normal.assign(2, Vec3::unit_y());
  shape_.faces.area.assign(2, 0);
  shape_.faces.has_alike.assign(2, false);
  shape_.faces.begin = {0, 3, 6};
  shape_.faces.loop = {0, 1, 2, 0, 2, 1};  // front, back
}

void TriangleShape::set(const Triangle& triangle) {
  origin_ = (triangle.corner[0] + triangle.corner[1] + triangle.corner[2]) / 3;
  reshape(triangle.corner);
  shape_.faces.normal[0] = triangle.normal, shape_.faces.normal[1] = -triangle.normal;
}

void TriangleShape::reshape(const std::array<Vec3, 3>& corner) {
  shape_.bounds = Aabb();
  Real radius2 = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 x = corner[k] - origin_;
    for (int i = 0; i < 3; ++i) shape_.params[3 * k + static_cast<std::size_t>(i)] = x[i];
    shape_.bounds.lo = shape_.bounds.lo.min(x), shape_.bounds.hi = shape_.bounds.hi.max(x);
    radius2 = std::max(radius2, x.squared_norm());
  }
  shape_.bounding_radius = std::sqrt(radius2);
}

void make_scenery(std::shared_ptr<const Scenery> scenery, Shape& shape) {
  shape.form = Form::scenery;
  shape.bounds = scenery->bounds;
  shape.bounding_radius = scenery->bounds.lo.abs().max(scenery->bounds.hi.abs()).norm();
  shape.mass.exact = true;
  shape.scenery = std::move(scenery);
}

bool face(const Scenery& scenery, const Vec3& point, Triangle& triangle) {
  if ((point - triangle.corner[0]).dot(triangle.normal) >= 0) return true;
  if (!scenery.two_sided) return false;
  std::swap(triangle.corner[1], triangle.corner[2]);
  std::swap(triangle.far[0], triangle.far[2]);
  std::swap(triangle.boundary[0], triangle.boundary[2]);
  triangle.normal = -triangle.normal;
  triangle.turned = !triangle.turned;
  return true;
}

}  // namespace carom::collision
