// The part of a convex shape under a plane: of balls and ellipsoids in closed form, of all others as a sum of
// tetrahedra from a point of the plane to the triangles of their surface, cut at the plane. The cut itself lies in the
// plane and adds nothing.
#include "dynamics/force/floats.h"

#include <algorithm>
#include <array>
#include <numbers>
#include <utility>

#include "collision/directions.h"
#include "collision/hull.h"
#include "collision/support.h"

namespace carom::dynamics {
namespace {

/// The cap of a unit ball about the origin where n . x <= level, |n| = 1: volume, and how far its centroid is down -n.
/// @source  any table of solids: V = pi h^2 (3 - h) / 3, z = 3 (2 - h)^2 / (4 (3 - h)), h = 1 + level
struct Cap {
  Real volume, down;
};
Cap cap_of(Real level) {
  const Real h = std::clamp<Real>(1 + level, 0, 2);
  return {std::numbers::pi * h * h * (3 - h) / 3, 3 * (2 - h) * (2 - h) / (4 * (3 - h))};
}

/// The one from the origin to a triangle, by the side that it shows.
void add_tetrahedron(Submerged& sum, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Real volume = a.dot(b.cross(c)) / 6;
  sum.volume += volume;
  sum.moment += volume / 4 * (a + b + c);
}

/// Volume and moment of what is on the inner side of triangles and under a plane.
class WettedSum {
 public:
  WettedSum(const Vec3& n, Real level) : n_(n), origin_(level * n) {}

  void triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
    const std::array<Vec3, 3> p = {a - origin_, b - origin_, c - origin_};
    const std::array<Real, 3> height = {n_.dot(p[0]), n_.dot(p[1]), n_.dot(p[2])};
    const int under = (height[0] <= 0) + (height[1] <= 0) + (height[2] <= 0);
    if (under == 0) return;
    if (under == 3) return add_tetrahedron(sum_, p[0], p[1], p[2]);
    const bool lone = under == 1;  // one corner under, or one above: the two edges from it are cut
    for (int i = 0; i < 3; ++i) {
      const std::size_t at = static_cast<std::size_t>(i), next = (at + 1) % 3, last = (at + 2) % 3;
      if ((height[at] <= 0) != lone) continue;
      const Vec3 x = cut(p[at], height[at], p[next], height[next]), y = cut(p[at], height[at], p[last], height[last]);
      if (lone) return add_tetrahedron(sum_, p[at], x, y);
      add_tetrahedron(sum_, p[next], p[last], y);
      return add_tetrahedron(sum_, p[next], y, x);
    }
  }
  Submerged total() const { return {sum_.volume, sum_.moment + sum_.volume * origin_}; }

 private:
  static Vec3 cut(const Vec3& a, Real at_a, const Vec3& b, Real at_b) { return a + at_a / (at_a - at_b) * (b - a); }
  Vec3 n_, origin_;
  Submerged sum_;  // about the origin_
};

Submerged under_ellipsoid(const Vec3& half, const Vec3& n, Real level) {
  const Vec3 stretched = half.times(n);  // the plane's normal where the ellipsoid is the unit ball
  const Real length = stretched.norm();
  const Cap cap = cap_of(level / length);
  const Real volume = half.product() * cap.volume;
  return {volume, -(volume * cap.down / length) * half.times(stretched)};
}

/// Whether its share under a plane has a closed form.
bool floats_by_form(const Shape& shape) { return shape.form == Form::sphere || shape.form == Form::ellipsoid; }

/// s with s^3 = x, for x near 1. The same bits everywhere, as cbrt() has not.
Real cube_root(Real x) {
  Real s = 1 + (x - 1) / 3;
  for (int k = 0; k < 6; ++k) s -= (s * s * s - x) / (3 * s * s);
  return s;
}

/// The shape's surface; nothing if its support function fails, which the narrow phase will find and tell of.
void make_surface(const Shape& shape, Array<Vec3>& corner) {
  Array<double> points(corner.get_allocator());
  const bool flat_faced = (shape.form == Form::polytope || shape.form == Form::box) && shape.core_radius == 0;
  const auto add = [&](const Vec3& x) { points.insert(points.end(), {x.x(), x.y(), x.z()}); };
  if (shape.form == Form::polytope && flat_faced) {
    points.assign(shape.vertices.begin(), shape.vertices.end());
  } else if (flat_faced) {
    for (int c = 0; c < 8; ++c) add(Vec3(c & 1 ? 1 : -1, c & 2 ? 1 : -1, c & 4 ? 1 : -1).times(shape.half));
  } else {
    SupportFault fault;
    Vec3 x;
    for (const Vec3& d : asking_directions()) {
      if (!full_support(shape, d, x, fault)) return;
      add(x);
    }
  }
  Array<std::uint32_t> triangles(corner.get_allocator());
  if (!convex_hull(points, triangles)) return;
  for (const std::uint32_t v : triangles) corner.push_back(Vec3(points[3 * v], points[3 * v + 1], points[3 * v + 2]));
  if (flat_faced) return;
  Submerged whole;
  for (std::size_t t = 0; t < corner.size(); t += 3) add_tetrahedron(whole, corner[t], corner[t + 1], corner[t + 2]);
  if (!(whole.volume > 0)) return corner.clear();
  const Real scale = cube_root(shape.mass.volume / whole.volume);
  const Vec3 middle = whole.moment / whole.volume;
  for (Vec3& v : corner) v = shape.mass.centroid + scale * (v - middle);
}

}  // namespace

bool floats(const Shape& shape) {
  return shape.form != Form::half_space && shape.form != Form::scenery && shape.mass.volume > 0;
}

Submerged under_plane(const Shape& shape, const Float* surface, const Vec3& n, Real level) {
  if (level >= shape.bounding_radius) return {shape.mass.volume, shape.mass.volume * shape.mass.centroid};
  if (shape.form == Form::sphere) return under_ellipsoid(Vec3::constant(shape.radius), n, level);
  if (shape.form == Form::ellipsoid) return under_ellipsoid(shape.half, n, level);
  WettedSum sum(n, level);
  if (surface)
    for (std::size_t t = 0; t + 2 < surface->corner.size(); t += 3)
      sum.triangle(surface->corner[t], surface->corner[t + 1], surface->corner[t + 2]);
  return sum.total();
}

void make_floats(const Colliders& c, Floats& water, Memory* memory) {
  const auto is_of = [&](std::uint32_t at, const Shape& shape) {
    return at < water.floats.size() && water.floats[at].shape == &shape && water.floats[at].handle == shape.handle;
  };
  if (water.floats.size() > 2 * c.live.size() + 16) water.floats.clear();  // most of them are of shapes long gone
  water.float_of.resize(c.slots(), kInvalid);
  for (const std::uint32_t slot : c.live) {
    const Shape& shape = *c.shape[slot];
    std::uint32_t& at = water.float_of[slot];
    if (is_of(at, shape)) continue;
    at = kInvalid;
    if (!c.movable[slot] || !floats(shape) || floats_by_form(shape)) continue;
    for (at = 0; at < water.floats.size() && !is_of(at, shape);) ++at;
    if (at < water.floats.size()) continue;
    Float made(memory);
    made.shape = &shape, made.handle = shape.handle;
    make_surface(shape, made.corner);
    water.floats.push_back(std::move(made));
  }
}

}  // namespace carom::dynamics
