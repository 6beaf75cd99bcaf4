// Where impulses of a contact may lie, in world axes: the nearest impulse there, and how that changes. Coulomb's friction
// cone, K = {p : |p_t| <= mu p_n}, or the half of a cylinder, {p : p_n >= 0, |p_t| <= most}, where friction is known.
#pragma once

#include <algorithm>

#include "core/vec.h"

namespace carom::dynamics {

/// Which part of space an impulse lies in.
struct ConePart {
  enum Kind : std::uint8_t { inside, outside, polar } kind;
  Real n, t, along;  // z.n, |z_t|, length of the projection along the axis where outside
};

inline ConePart part_of(const Vec3& z, const Vec3& n, Real mu) {
  ConePart c{};
  c.n = z.dot(n);
  c.t = (z - c.n * n).norm();
  if (c.n <= -mu * c.t)
    c.kind = ConePart::polar;
  else if (c.t <= mu * c.n)
    c.kind = ConePart::inside;
  else
    c.kind = ConePart::outside, c.along = (c.n + mu * c.t) / (1 + mu * mu);
  return c;
}

/// The point of K nearest to z.
/// @param z  N s, world   @param n  unit, world, axis   @param mu  >= 0
inline Vec3 project_on_cone(const Vec3& z, const Vec3& n, Real mu) {
  const ConePart c = part_of(z, n, mu);
  switch (c.kind) {
    case ConePart::inside:
      return z;
    case ConePart::polar:
      return Vec3::zero();
    default:
      return mu > 0 ? Vec3(c.along * (n + (mu / c.t) * (z - c.n * n))) : Vec3(c.along * n);
  }
}

/// d project_on_cone / dz: symmetric, eigenvalues within [0, 1]; one of its one-sided values where it jumps.
inline Mat3 slope_of_projection(const Vec3& z, const Vec3& n, Real mu) {
  const ConePart c = part_of(z, n, mu);
  switch (c.kind) {
    case ConePart::inside:
      return Mat3::identity();
    case ConePart::polar:
      return Mat3::zero();
    default: {
      if (!(mu > 0)) return outer(n, n);
      const Vec3 t = (z - c.n * n) / c.t, ray = n + mu * t, aside = n.cross(t);
      return outer(ray, ray) / (1 + mu * mu) + outer((mu * c.along / c.t) * aside, aside);
    }
  }
}

/// The point nearest to z of the half of a cylinder.
/// @param most  N s, radius
inline Vec3 project_on_cylinder(const Vec3& z, const Vec3& n, Real most) {
  const Real along = z.dot(n);
  if (most == 0) return std::max(along, Real(0)) * n;
  const Vec3 across = z - along * n;
  const Real size = across.norm();
  if (along >= 0 && size <= most) return z;
  return std::max(along, Real(0)) * n + (size <= most ? across : Vec3((most / size) * across));
}

/// As slope_of_projection().
inline Mat3 slope_of_projection_on_cylinder(const Vec3& z, const Vec3& n, Real most) {
  const Real along = z.dot(n);
  const Vec3 across = z - along * n;
  const Real size = across.norm();
  Mat3 slope = along > 0 ? outer(n, n) : Mat3(Mat3::zero());
  if (size <= most) return slope + (Mat3::identity() - outer(n, n));
  const Vec3 aside = n.cross(across) / size;
  return slope + (most / size) * outer(aside, aside);
}

}  // namespace carom::dynamics
