// A sphere against a sphere, a box, a capsule: one contact point, in closed form.
#include <algorithm>

#include "collision/narrow/pair.h"

namespace carom::collision {
namespace {

// m^2: a squared gap below this is no gap. Its root keeps its digits only above 1e-290, where doubles stop being dense.
constexpr Real kNoGap2 = 1e-280;

/// The point of a swollen core (nearest to the sphere's centre) and the sphere, when the unit normal is known.
/// @param core  [3] m, A's frame: nearest point of A's core   @param gap  m: centre - core = gap * normal
void add_sphere(const Vec3& core, Real core_radius, const Vec3& normal, Real gap, const Shape& sphere,
                const Frame& b_in_a, Real reach, Candidates& found) {
  found.gap = gap - core_radius - sphere.radius;
  if (found.gap <= reach)
    add_contact(found, reach, core + core_radius * normal, -sphere.radius * b_in_a.rotate_inverse(normal), normal,
                found.gap, 1);
  found.whole = true;
}

}  // namespace

void contact_sphere_sphere(const Shape& a, const Shape& b, const Frame& b_in_a, Real reach, Candidates& found) {
  const Real gap2 = b_in_a.p.squared_norm(), gap = gap2 > kNoGap2 ? std::sqrt(gap2) : 0;
  // Concentric: every direction is a normal of least depth; the axis is as good as any, and the same every time.
  const Vec3 normal = gap > 0 ? Vec3(b_in_a.p / gap) : Vec3(Vec3::unit_y());
  add_sphere(Vec3::zero(), a.radius, normal, gap, b, b_in_a, reach, found);
}

void contact_box_sphere(const Shape& a, const Shape& b, const Frame& b_in_a, Real reach, Candidates& found) {
  const Vec3& c = b_in_a.p;
  const Vec3 nearest = c.max(-a.half).min(a.half);
  const Vec3 out = c - nearest;
  const Real gap2 = out.squared_norm();
  if (gap2 > kNoGap2) {
    const Real gap = std::sqrt(gap2);
    add_sphere(nearest, 0, out / gap, gap, b, b_in_a, reach, found);
    return;
  }
  // The centre is inside: out through the nearest face, the first of equal ones.
  int axis = 0;
  Real depth = a.half[0] - std::fabs(c[0]);
  for (int i = 1; i < 3; ++i) {
    const Real d = a.half[i] - std::fabs(c[i]);
    if (d < depth) depth = d, axis = i;
  }
  Vec3 normal = Vec3::zero(), on_face = c;
  normal[axis] = std::copysign(Real(1), c[axis]);
  on_face[axis] = std::copysign(a.half[axis], c[axis]);
  add_sphere(on_face, 0, normal, -depth, b, b_in_a, reach, found);
}

void contact_capsule_sphere(const Shape& a, const Shape& b, const Frame& b_in_a, Real reach, Candidates& found) {
  const Vec3& c = b_in_a.p;
  const Vec3 nearest(0, std::clamp(c.y(), -a.half_height, a.half_height), 0);
  const Vec3 out = c - nearest;
  const Real gap2 = out.squared_norm(), gap = gap2 > kNoGap2 ? std::sqrt(gap2) : 0;
  // On the core segment every direction across it is a normal of least depth.
  const Vec3 normal = gap > 0 ? Vec3(out / gap) : Vec3(Vec3::unit_x());
  add_sphere(nearest, a.radius, normal, gap, b, b_in_a, reach, found);
}

}  // namespace carom::collision
