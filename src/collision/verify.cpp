// Questions that a support function cannot fail without being caught, and their tolerances.
#include "collision/verify.h"

#include <Eigen/Eigenvalues>
#include <bit>

#include "collision/directions.h"
#include "collision/support.h"
#include "collision/volume.h"

namespace carom::collision {

namespace {

constexpr Real kSupportRounding = 64 * kUnitRoundoff;  // of the largest coordinate: a few dozen operations in double

Verdict lie(const char* reason, const Vec3& dir, const Vec3& out) {
  Verdict v{false, reason, {dir.x(), dir.y(), dir.z()}, {out.x(), out.y(), out.z()}};
  return v;
}

Verdict lie(const SupportFault& f) {
  const char* reason = f.kind == SupportFault::returned     ? "returned a nonzero status"
                       : f.kind == SupportFault::not_finite ? "not finite"
                       : f.kind == SupportFault::outside    ? "farther than 1e9 m from its origin"
                                                         : "a known point of the set lies farther along the direction";
  return {false, reason, {f.dir[0], f.dir[1], f.dir[2]}, {f.out[0], f.out[1], f.out[2]}};
}

bool same_bits(const Vec3& a, const Vec3& b) {
  for (int i = 0; i < 3; ++i)
    if (std::bit_cast<std::uint64_t>(a[i]) != std::bit_cast<std::uint64_t>(b[i])) return false;
  return true;
}

/// Smallest error of a support value worth calling a lie, for a set that lies within these bounds.
Real tolerance_of(const Vec3& lo, const Vec3& hi) {
  return kSloppiness * (hi - lo).max_entry() + kSupportRounding * lo.abs().max(hi.abs()).max_entry();
}

/// h(d) = max over x in the form of d . x, for unit d.
Real form_support_value(const Shape& s, Form form, const Vec3& d) {
  const Real side = std::sqrt(d.x() * d.x() + d.z() * d.z());
  switch (form) {
    case Form::sphere:
      return s.radius;
    case Form::capsule:
      return s.half_height * std::fabs(d.y()) + s.radius;
    case Form::box:
      return d.abs().dot(s.half);
    case Form::cylinder:
      return s.half_height * std::fabs(d.y()) + s.radius * side;
    case Form::cone:
      return std::max(s.half_height * d.y(), s.radius * side - s.half_height * d.y());
    case Form::ellipsoid:
      return d.times(s.half).norm();
    default:
      break;
  }
  Real h = -kInfinity;
  for (std::size_t k = 0; k + 3 <= s.vertices.size(); k += 3)
    h = std::max(h, d.x() * s.vertices[k] + d.y() * s.vertices[k + 1] + d.z() * s.vertices[k + 2]);
  return h;
}

Real spectral_norm(const Mat3& symmetric) {
  if (!symmetric.all_finite()) return kInfinity;
  using Matrix = Eigen::Matrix<Real, 3, 3>;
  const Matrix m = Eigen::Map<const Matrix>(symmetric.data());
  return Eigen::SelfAdjointEigenSolver<Matrix>(m, Eigen::EigenvaluesOnly).eigenvalues().cwiseAbs().maxCoeff();
}

}  // namespace

Verdict verify_support(const Shape& shape) {
  if (shape.support == nullptr) return lie("no support function", Vec3::zero(), Vec3::zero());
  const auto dirs = asking_directions();
  std::array<Vec3, kDirections> points;
  SupportFault fault;
  Vec3 lo = Vec3::constant(kInfinity), hi = -lo;
  for (int i = 0; i < kDirections; ++i) {
    if (!core_support(shape, dirs[i], points[i], fault)) return lie(fault);
    lo = lo.min(points[i]);
    hi = hi.max(points[i]);
  }
  // Backwards: the second result must not depend on what was asked before it either.
  for (int i = kDirections - 1; i >= 0; --i) {
    Vec3 again;
    if (!core_support(shape, dirs[i], again, fault)) return lie(fault);
    if (!same_bits(points[i], again)) return lie("not bitwise repeatable", dirs[i], again);
  }
  // From here on one number decides: by how much a point of the set is farther along d than the result for d.
  const Real tolerance = tolerance_of(lo, hi);
  for (int i = 0; i < kDirections; ++i) {
    // 2^-996 and 2^996 are about 1e-300 and 1e300; with 3 the mantissa changes too.
    for (const Real scale : {0x1p-996, 0x1p-40, 3.0, 0x1p40, 0x1p996}) {
      Vec3 scaled;
      const Vec3 d = scale * dirs[i];
      if (!core_support(shape, d, scaled, fault)) return lie(fault);
      if (!(std::fabs(dirs[i].dot(scaled - points[i])) <= tolerance))
        return lie("depends on the length of the direction", d, scaled);
    }
  }
  for (int i = 0; i < kDirections; ++i)
    for (int j = 0; j < kDirections; ++j)
      if (!(dirs[i].dot(points[j] - points[i]) <= tolerance))
        return lie("not the support of a convex set: another support point lies farther along the direction", dirs[i],
                   points[i]);
  return {};
}

Verdict verify_form(const Shape& shape, Form form) {
  if (form == Form::none || form >= Form::half_space) return lie("no such closed form", Vec3::zero(), Vec3::zero());
  const auto dirs = asking_directions();
  std::array<Vec3, kDirections> points;
  SupportFault fault;
  Vec3 lo = Vec3::constant(kInfinity), hi = -lo;
  for (int i = 0; i < kDirections; ++i) {
    if (!full_support(shape, dirs[i], points[i], fault)) return lie(fault);
    lo = lo.min(points[i]);
    hi = hi.max(points[i]);
  }
  const Real tolerance = tolerance_of(lo, hi);
  for (int i = 0; i < kDirections; ++i)
    if (!(std::fabs(form_support_value(shape, form, dirs[i]) - dirs[i].dot(points[i])) <= tolerance))
      return lie("the declared closed form has another support value", dirs[i], points[i]);
  return {};
}

Verdict verify_mass(const Shape& shape, const MassProperties& declared) {
  // 512 supports bracket a polytope of some dozens of faces to rounding, a sphere to about 3 %.
  SupportFault fault;
  const MassProperties known = mass_from_support(shape, 1e-9, 512, fault);
  if (fault.kind != SupportFault::none) return lie(fault);
  const auto no = [](const char* reason) { return lie(reason, Vec3::zero(), Vec3::zero()); };
  // The bracket trusts every support point to rounding, but the function may be as sloppy as verify_support lets it:
  // each of three widths off by kSloppiness (five, for the inertia), on both sides.
  constexpr Real kSlack = 10 * kSloppiness;
  if (!(declared.volume >= known.volume_min * (1 - kSlack) && declared.volume <= known.volume_max * (1 + kSlack)))
    return no("the declared volume lies outside the bracket that the support function gives");
  if (known.volume_min <= 0) return {};  // flat: no centre or inertia to compare
  const Real size = known.centroid.abs().max_entry() + std::sqrt(known.inertia.trace() / known.volume);
  if (!((declared.centroid - known.centroid).norm() <= known.centroid_error + kSlack * size))
    return no("the declared centre of mass lies outside the bracket that the support function gives");
  if (!(spectral_norm(declared.inertia - known.inertia) <= known.inertia_error + kSlack * known.inertia.trace()))
    return no("the declared inertia lies outside the bracket that the support function gives");
  return {};
}

}  // namespace carom::collision
