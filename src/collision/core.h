// A shape's core as the narrow phase asks it: in the engine's own words where a form was verified, else in the
// plugin's.
#pragma once

#include "collision/shape.h"

namespace carom::collision {

/// Support points of one core, for directions of about unit length.
///
/// The engine's words give what the plugin's would (the plugins stay the oracle), without a call through a pointer, and
/// without doubt: they are finite and in bounds. What a plugin's function gives is checked each time.
class Core {
 public:
  explicit Core(const Shape& shape) : shape_(&shape), form_(own_form(shape)) {}

  /// The point farthest along n.
  /// @param n    [3] of length 0.9 to 2 (who has no unit direction need not make one), shape frame
  /// @param out  [3] m, shape frame
  /// @return     false if the plugin's function misbehaved; blame() says how
  /// @accuracy   n . out is below the largest by at most 8 u |n| times the shape's size (closed forms: two roundings a
  ///             component; polytopes: FarthestVertex)
  /// @oracle     tests/unit/collision/test_core
  bool support(const Vec3& n, Vec3& out);

  /// What the last support() that returned false met. @return false
  bool blame(const Vec3& n, const Vec3& out, SupportFault& fault) const;
  const Shape& shape() const { return *shape_; }

  /// The form to speak for, none where the plugin must: a declared form is that of the whole shape, and the core is
  /// smaller by the core radius.
  static Form own_form(const Shape& s) {
    const bool round = s.form == Form::sphere || s.form == Form::capsule;
    const bool known = s.core_radius == (round ? s.radius : 0) && (s.form != Form::polytope || !s.farthest.empty());
    return known ? s.form : Form::none;
  }
  /// m^2: a plugin's support point that is farther from the origin is none.
  static Real limit2(const Shape& s);

 private:
  bool ask(const Vec3& n, Vec3& out);

  const Shape* shape_;
  Form form_;
  std::int32_t returned_ = 0;
};

namespace core_detail {

/// h with the sign of d; zero, of either sign, counts as positive.
inline Real toward(Real d, Real h) { return std::copysign(h, d + Real(0)); }

inline constexpr Real kSquare = 1e-280;  // a sum of squares below this has lost digits to underflow

/// The rim point of a disc around y; its centre where the direction is square to it but for 1e-140, which adds nothing.
inline Vec3 on_rim(const Vec3& n, Real radius, Real y) {
  const Real side2 = n.x() * n.x() + n.z() * n.z();
  const Real scale = side2 > kSquare ? radius / std::sqrt(side2) : 0;
  return Vec3(n.x() * scale, y, n.z() * scale);
}

}  // namespace core_detail

inline bool Core::support(const Vec3& n, Vec3& out) {
  using core_detail::kSquare, core_detail::on_rim, core_detail::toward;
  const Shape& s = *shape_;
  switch (form_) {
    case Form::sphere:
      out = Vec3::zero();
      return true;
    case Form::capsule:
      out = Vec3(0, toward(n.y(), s.half_height), 0);
      return true;
    case Form::box:
      out = Vec3(toward(n.x(), s.half.x()), toward(n.y(), s.half.y()), toward(n.z(), s.half.z()));
      return true;
    case Form::polytope: {
      const double* v = s.vertices.data() + 3 * static_cast<std::size_t>(s.farthest(n));
      out = Vec3(v[0], v[1], v[2]);
      return true;
    }
    case Form::cylinder:
      out = on_rim(n, s.radius, toward(n.y(), s.half_height));
      return true;
    case Form::cone:
      out = 2 * s.half_height * n.y() > s.radius * std::sqrt(n.x() * n.x() + n.z() * n.z())
                ? Vec3(0, s.half_height, 0)
                : on_rim(n, s.radius, -s.half_height);
      return true;
    case Form::ellipsoid: {
      const Vec3 stretched = s.half.times(n);
      const Real length2 = stretched.squared_norm();
      if (!(length2 > kSquare)) return ask(n, out);
      out = s.half.times(stretched * (1 / std::sqrt(length2)));
      return true;
    }
    default:
      return ask(n, out);
  }
}

}  // namespace carom::collision
