// Bounds of a shape: in the world (asked for every collider, every step) and in its own frame (asked once).
#include "collision/volume.h"

#include <array>

#include "collision/support.h"

namespace carom::collision {

namespace {

/// Half extents in the world of a centred box, cylinder, capsule or ellipsoid: h_i = support value along world axis i.
Vec3 half_extents(const Shape& s, const Mat3& r) {
  Vec3 h;
  for (int i = 0; i < 3; ++i) {
    switch (s.form) {
      case Form::sphere:
        h[i] = s.radius;
        break;
      case Form::capsule:
        h[i] = s.half_height * std::fabs(r(i, 1)) + s.radius;
        break;
      case Form::box:
        h[i] = std::fabs(r(i, 0)) * s.half[0] + std::fabs(r(i, 1)) * s.half[1] + std::fabs(r(i, 2)) * s.half[2];
        break;
      case Form::cylinder:
        h[i] = s.half_height * std::fabs(r(i, 1)) + s.radius * std::sqrt(r(i, 0) * r(i, 0) + r(i, 2) * r(i, 2));
        break;
      default:
        h[i] = Vec3(r(i, 0) * s.half[0], r(i, 1) * s.half[1], r(i, 2) * s.half[2]).norm();
        break;  // ellipsoid
    }
  }
  return h;
}

/// A cone is the hull of its apex and its base disc.
Aabb cone_bounds(const Shape& s, const Mat3& r, const Vec3& p) {
  Aabb b;
  for (int i = 0; i < 3; ++i) {
    const Real apex = s.half_height * r(i, 1);
    const Real rim = s.radius * std::sqrt(r(i, 0) * r(i, 0) + r(i, 2) * r(i, 2));
    b.lo[i] = p[i] + std::min(apex, -apex - rim);
    b.hi[i] = p[i] + std::max(apex, rim - apex);
  }
  return b;
}

/// Six climbs over many vertices.   @accuracy as FarthestVertex
Aabb climbed_bounds(const Shape& s, const Mat3& r, const Vec3& p) {
  Aabb b;
  const auto along = [&](const Vec3& axis, const Vec3& n) {
    const double* const v = &s.vertices[3 * std::size_t{s.farthest(n)}];
    return axis.x() * v[0] + axis.y() * v[1] + axis.z() * v[2];
  };
  for (int i = 0; i < 3; ++i) {
    const Vec3 axis = r.row(i);
    b.lo[i] = p[i] + along(axis, -axis), b.hi[i] = p[i] + along(axis, axis);
  }
  return b;
}

/// One pass over the verified vertices, two at a time: all six sides at once, where the support function would scan six times.
Aabb polytope_bounds(const Shape& s, const Mat3& r, const Vec3& p) {
  if (s.farthest.climbs()) return climbed_bounds(s, r, p);
  typedef double Both __attribute__((vector_size(16)));
  constexpr Both kMost = {kInfinity, kInfinity};
  Both lo[3] = {kMost, kMost, kMost}, hi[3] = {-kMost, -kMost, -kMost};
  const double *v = s.vertices.data(), *const end = v + s.vertices.size();
  while (v < end) {
    const double* const w = v + 3 < end ? v + 3 : v;
    const Both x = {v[0], w[0]}, y = {v[1], w[1]}, z = {v[2], w[2]};
    for (int i = 0; i < 3; ++i) {
      const Both at = r(i, 0) * x + r(i, 1) * y + r(i, 2) * z;
      lo[i] = at < lo[i] ? at : lo[i];
      hi[i] = at > hi[i] ? at : hi[i];
    }
    v = w + 3;
  }
  Aabb b;
  for (int i = 0; i < 3; ++i)
    b.lo[i] = core::smaller(lo[i][0], lo[i][1]) + p[i], b.hi[i] = core::larger(hi[i][0], hi[i][1]) + p[i];
  return b;
}

/// All of space, unless the plane is square to an axis, as floors and walls mostly are: then it ends at the plane,
/// widened by what rounds off where a distance from it is computed, and only who is near makes a pair with it.
Aabb half_space_bounds(const Shape& s, const Mat3& r, const Vec3& p) {
  Aabb b;
  b.lo = Vec3::constant(-kInfinity);
  b.hi = Vec3::constant(kInfinity);
  const Vec3 n = r * s.normal;
  for (int k = 0; k < 3; ++k) {
    if (std::fabs(n[k]) != 1 || n[(k + 1) % 3] != 0 || n[(k + 2) % 3] != 0) continue;
    const Real end = s.offset + n[k] * p[k];
    const Real outward = end + 4 * kUnitRoundoff * (std::fabs(s.offset) + std::fabs(p[k]));
    (n[k] > 0 ? b.hi : b.lo)[k] = n[k] * outward;
  }
  return b;
}

/// The box about the turned box, which no part leaves.
Aabb scenery_bounds(const Shape& s, const Mat3& r, const Vec3& p) {
  const Vec3 middle = r * ((s.bounds.lo + s.bounds.hi) / 2) + p, half = r.abs() * ((s.bounds.hi - s.bounds.lo) / 2);
  const Vec3 more =
      Vec3::constant(8 * kUnitRoundoff * (s.bounds.lo.abs().max(s.bounds.hi.abs()).sum() + p.abs().sum()));
  Aabb b;
  b.lo = middle - half - more, b.hi = middle + half + more;
  return b;
}

/// Six support calls.
Aabb general_bounds(const Shape& s, const Mat3& r, const Vec3& p, SupportFault& fault) {
  Aabb b;
  // A point this far out was not there when the shape was measured. The bound itself is rigorous up to rounding.
  const Real reach = s.bounding_radius > 0 ? s.bounding_radius * (1 + 1e-9) : kInfinity;
  for (int i = 0; i < 3; ++i) {
    const Vec3 axis = r.row(i);
    Vec3 low, high;
    if (!core_support(s, -axis, low, fault) || !core_support(s, axis, high, fault)) return Aabb{};
    for (const Vec3* out : {&low, &high}) {
      if (out->norm() <= reach) continue;
      fault.kind = SupportFault::outside;
      fault.shape = &s;
      for (int k = 0; k < 3; ++k) fault.dir[k] = out == &low ? -axis[k] : axis[k], fault.out[k] = (*out)[k];
      return Aabb{};
    }
    b.lo[i] = p[i] + axis.dot(low) - s.core_radius;
    b.hi[i] = p[i] + axis.dot(high) + s.core_radius;
  }
  return b;
}

/// Largest distance from the origin of a closed form, core radius included.
Real reach_of_form(const Shape& s) {
  switch (s.form) {
    case Form::sphere:
      return s.radius;
    case Form::capsule:
      return s.half_height + s.radius;
    case Form::box:
      return s.half.norm();
    case Form::cylinder:
    case Form::cone:
      return std::sqrt(s.radius * s.radius + s.half_height * s.half_height);
    case Form::ellipsoid:
      return s.half.max_entry();
    default:
      break;
  }
  Real r2 = 0;
  for (std::size_t k = 0; k + 3 <= s.vertices.size(); k += 3)
    r2 = std::max(r2, Vec3(s.vertices[k], s.vertices[k + 1], s.vertices[k + 2]).squared_norm());
  return std::sqrt(r2);
}

/// Bounding radius from the support values of directions that lie on an octahedron's integer lattice (|i|+|j|+|k| = 8).
///   Any unit u is, up to length, a convex combination of the three lattice directions around it, u = sum(mu_k d_k),
///   and sum(mu_k) <= 1 / c with c the smallest distance of the origin from a plane through three neighbours. So for
///   every point x = |x| u of the set:  |x| = u . x = sum(mu_k d_k . x) <= max_k h(d_k) / c.
/// c is least in the middle of the octant: the plane through (3,3,2), (3,2,3), (2,3,3), each / sqrt 22, c = 8 /
/// sqrt 66.
/// @accuracy  at most 1 / c - 1 = 1.6 % too large
bool reach_of_support(const Shape& s, Real& reach, SupportFault& fault) {
  constexpr int n = 8;
  const Real cover = n / std::sqrt(Real(66));
  Real farthest = 0;
  for (int i = -n; i <= n; ++i) {
    const int rest = n - std::abs(i);
    for (int j = -rest; j <= rest; ++j) {
      const int k = rest - std::abs(j);
      for (int sign = k == 0 ? 1 : -1; sign <= 1; sign += 2) {
        const Vec3 d = direction_of(Vec3(i, j, sign * k));
        Vec3 out;
        if (!core_support(s, d, out, fault)) return false;
        farthest = std::max(farthest, d.dot(out));
      }
    }
  }
  reach = farthest / cover + s.core_radius;
  return true;
}

}  // namespace

Aabb world_bounds(const Shape& shape, const Mat3& r, const Vec3& p, SupportFault& fault) {
  Aabb b;
  switch (shape.form) {
    case Form::half_space:
      return half_space_bounds(shape, r, p);
    case Form::scenery:
      return scenery_bounds(shape, r, p);
    case Form::cone:
      return cone_bounds(shape, r, p);
    case Form::polytope:
      return polytope_bounds(shape, r, p);
    case Form::sphere:
    case Form::capsule:
    case Form::box:
    case Form::cylinder:
    case Form::ellipsoid: {
      const Vec3 half = half_extents(shape, r);
      b.lo = p - half;
      b.hi = p + half;
      return b;
    }
    default:
      return general_bounds(shape, r, p, fault);
  }
}

bool derive_bounds(Shape& shape, SupportFault& fault) {
  shape.bounding_radius = 0;  // not known yet: the run-time check against it sleeps
  if (shape.form == Form::half_space) {
    shape.bounds.lo = Vec3::constant(-kInfinity), shape.bounds.hi = Vec3::constant(kInfinity);
    shape.bounding_radius = kInfinity;
    return true;
  }
  shape.bounds = world_bounds(shape, Mat3::identity(), Vec3::zero(), fault);
  if (!(shape.bounds.lo.x() <= shape.bounds.hi.x())) return false;
  Real reach;
  if (shape.form != Form::none) {
    reach = reach_of_form(shape);
  } else {
    if (!reach_of_support(shape, reach, fault)) return false;
    // The far corner of the bounds is another bound, the better one for shapes with a corner there.
    reach = std::min(reach, shape.bounds.lo.abs().max(shape.bounds.hi.abs()).norm());
  }
  shape.bounding_radius = reach * (1 + 8 * kEpsilon);
  return true;
}

}  // namespace carom::collision
