// Rays in closed form: sphere, capsule, box, cylinder, cone, ellipsoid. Each routine says where a line enters and
// leaves the form swollen by some more, and is asked three times: swollen and shrunk by all that rounding can have
// done, which gives the bracket, and as it is.
#include <type_traits>

#include "collision/cast/local_ray.h"

namespace carom::collision {
namespace {

/// Where a line is in a convex set, m along it from the ray's origin.
struct Chord {
  bool met = false;
  Real in = 0, out = 0;  // m
};

/// From the foot of the centre: half of the chord is the root of (radius - off) (radius + off).
Chord through_ball(Real off, Real foot, Real radius) {
  if (!(off <= radius)) return {};
  const Real half = std::sqrt((radius - off) * (radius + off));
  return {true, foot - half, foot + half};
}

class Sphere {
 public:
  Sphere(const Shape& shape, const LocalRay& r, Real target)
      : radius_(shape.radius + target), foot_(-r.start), off_((r.o - r.start * r.u).norm()) {}
  bool usable(const LocalRay& r) const { return radius_ > 4 * r.rounding; }
  Chord chord(Real more) const { return through_ball(off_, foot_, radius_ + more); }
  /// Unit, out of the surface at a point of it.
  static Vec3 outward(const LocalRay& r, Real s) { return (r.o + s * r.u).normalized(); }

 private:
  Real radius_, foot_, off_;
};

/// A line as what is round about y sees it.
class AboutAxis {
 protected:
  explicit AboutAxis(const LocalRay& r) : u_(r.u), foot_(r.o - r.start * r.u), from_(-r.start) {
    flat2_ = u_.x() * u_.x() + u_.z() * u_.z();
    along_ = flat2_ < 1e-30;  // strays from the axis by less than 1e-15 of its length
    if (along_) {
      off_ = std::sqrt(foot_.x() * foot_.x() + foot_.z() * foot_.z());
      return;
    }
    flat_ = std::sqrt(flat2_);
    off_ = std::fabs(foot_.x() * u_.z() - foot_.z() * u_.x()) / flat_;
    pass_ = -(foot_.x() * u_.x() + foot_.z() * u_.z()) / flat2_;
    blur_ = 16 * kUnitRoundoff * foot_.norm() / flat_;
  }
  /// Nearly along the axis, where the line passes it is known too badly.
  bool is_known() const { return along_ || flat2_ > 1.0 / 4096; }
  /// m, that where the line passes the axis may be off, outwards.
  Real blur_of(Real more) const { return more > 0 ? blur_ : more < 0 ? -blur_ : 0; }

  Vec3 u_, foot_;  // m, the line's nearest point to the origin
  Real from_;      // m, where that is
  bool along_ = false;
  Real flat2_ = 0, flat_ = 0, off_ = 0, pass_ = 0, blur_ = 0;
};

/// The ball swept along a segment of y: a line first enters the endless cylinder, and where that is beyond the
/// segment's end, the ball there.
class Capsule : AboutAxis {
 public:
  Capsule(const Shape& shape, const LocalRay& r, Real target)
      : AboutAxis(r), radius_(shape.radius + target), half_(shape.half_height) {}
  bool usable(const LocalRay& r) const { return radius_ > 4 * r.rounding && is_known(); }

  Chord chord(Real more) const {
    const Real radius = radius_ + more;
    if (!(off_ <= radius)) return {};
    const Real back = std::sqrt((radius - off_) * (radius + off_));
    if (along_) return {true, from_ - foot_.y() * sign() - half_ - back, from_ - foot_.y() * sign() + half_ + back};
    const Real blur = blur_of(more);
    Chord c{true, 0, 0};
    const Real in = pass_ - back / flat_, out = pass_ + back / flat_;
    const Real y_in = foot_.y() + in * u_.y(), y_out = foot_.y() + out * u_.y();
    c.in = from_ + in - blur, c.out = from_ + out + blur;
    if (std::fabs(y_in) > half_) {
      const Chord cap = at_end(y_in, radius);
      if (!cap.met) return {};
      c.in = cap.in;
    }
    if (std::fabs(y_out) > half_) {
      const Chord cap = at_end(y_out, radius);
      if (!cap.met) return {};
      c.out = cap.out;
    }
    return c;
  }
  Vec3 outward(const LocalRay& r, Real s) const {
    Vec3 p = r.o + s * r.u;
    p.y() -= std::clamp(p.y(), -half_, half_);
    return p.normalized();
  }

 private:
  Real sign() const { return u_.y() < 0 ? -1 : 1; }
  Chord at_end(Real y, Real radius) const {
    const Vec3 q = foot_ - Vec3(0, std::copysign(half_, y), 0);
    const Real foot = -q.dot(u_);
    return through_ball((q + foot * u_).norm(), from_ + foot, radius);
  }

  Real radius_, half_;
};

/// Between three pairs of planes.
class Box {
 public:
  Box(const Shape& shape, const LocalRay& r, Real) : half_(shape.half), o_(r.o), u_(r.u), blur_(4 * r.rounding) {
    for (int i = 0; i < 3; ++i) by_[i] = 1 / u_[i];
  }
  bool usable(const LocalRay& r) const { return half_.min_entry() > 4 * r.rounding; }
  Chord chord(Real more) const {
    Chord c{true, -kInfinity, kInfinity};
    for (int i = 0; i < 3; ++i) {
      const Real h = half_[i] + more;
      if (u_[i] == 0) {
        if (std::fabs(o_[i]) > h) return {};
        continue;
      }
      const Real a = (-h - o_[i]) * by_[i], b = (h - o_[i]) * by_[i];
      c.in = std::max(c.in, std::min(a, b));
      c.out = std::min(c.out, std::max(a, b));
    }
    c.met = c.in <= c.out;
    return c;
  }
  Vec3 outward(const LocalRay& r, Real s) const {
    const Vec3 p = r.o + s * r.u, out = p.abs() - half_;
    const Real most = out.max_entry();
    // Of the sides that it is on, the one that faces the ray most.
    int axis = out.max_axis();
    for (int i = 0; i < 3; ++i)
      if (out[i] >= most - blur_ && facing(p, i) > facing(p, axis)) axis = i;
    Vec3 n = Vec3::zero();
    n[axis] = p[axis] < 0 ? -1 : 1;
    return n;
  }

 private:
  Real facing(const Vec3& p, int i) const { return p[i] < 0 ? u_[i] : -u_[i]; }

  Vec3 half_, o_, u_, by_;
  Real blur_;  // m
};

/// Where a line is between two parallel planes across y, as a part of a chord.
/// @param lo, hi  m, of the planes
/// @param y, u    m and 1: the line's height at the foot, and what it rises   @param from  m, at the foot
void cut_by_planes(Real lo, Real hi, Real y, Real u, Real from, Chord& c) {
  if (u == 0) {
    c.met &= lo <= y && y <= hi;
    return;
  }
  const Real a = (lo - y) / u, b = (hi - y) / u;
  c.in = std::max(c.in, from + std::min(a, b)), c.out = std::min(c.out, from + std::max(a, b));
}

/// What is inside an endless cylinder about y and between two planes.
class Cylinder : AboutAxis {
 public:
  Cylinder(const Shape& shape, const LocalRay& r, Real)
      : AboutAxis(r), radius_(shape.radius), half_(shape.half_height) {}
  bool usable(const LocalRay& r) const { return std::min(radius_, half_) > 4 * r.rounding && is_known(); }
  Chord chord(Real more) const {
    const Real radius = radius_ + more;
    if (!(off_ <= radius)) return {};
    Chord c{true, -kInfinity, kInfinity};
    if (!along_) {
      const Real half = std::sqrt((radius - off_) * (radius + off_)) / flat_;
      const Real blur = blur_of(more);
      c.in = from_ + pass_ - half - blur, c.out = from_ + pass_ + half + blur;
    }
    cut_by_planes(-half_ - more, half_ + more, foot_.y(), u_.y(), from_, c);
    c.met &= c.in <= c.out;
    return c;
  }
  Vec3 outward(const LocalRay& r, Real s) const {
    const Vec3 p = r.o + s * r.u;
    const Real off = std::sqrt(p.x() * p.x() + p.z() * p.z());
    const Vec3 end(0, p.y() < 0 ? -1 : 1, 0);
    if (off == 0) return end;
    // On the border it is the one that faces the ray more.
    const Vec3 side(p.x() / off, 0, p.z() / off);
    const Real beyond = std::fabs(p.y()) - half_ - (off - radius_);
    return beyond > 4 * r.rounding || (beyond > -4 * r.rounding && end.dot(r.u) < side.dot(r.u)) ? end : side;
  }

 private:
  Real radius_, half_;
};

/// What is under the surface of an endless cone, apex up, and above its base. With p and v the line's place and
/// direction across y, W and V how wide the cone is there and by how much it widens along the line, the line is on the
/// surface, or on that of the cone mirrored at the apex, where |p + t v| = |W + t V|:
///
///     a t^2 + 2 b t + c = 0,   a = v.v - V V,  b = p.v - W V,  b b - a c = |W v - V p|^2 - (p x v)^2
///
/// The last form keeps its digits where the line grazes.
class Cone {
 public:
  Cone(const Shape& shape, const LocalRay& r, Real)
      : half_(shape.half_height),
        slope_(shape.radius / (2 * shape.half_height)),
        secant_(std::sqrt(1 + slope_ * slope_)),
        u_(r.u),
        foot_(r.o - r.start * r.u),
        from_(-r.start),
        size_(std::min(shape.radius, shape.half_height)) {
    widens_ = -slope_ * u_.y();
    const Real flat2 = u_.x() * u_.x() + u_.z() * u_.z();
    a_ = flat2 - widens_ * widens_;
    is_steep_ = std::fabs(a_) < (flat2 + widens_ * widens_) / 64;
    cross_ = foot_.x() * u_.z() - foot_.z() * u_.x();
  }
  /// Not what runs along the surface, where it passes that is known too badly; nor cones like plates or needles.
  bool usable(const LocalRay& r) const {
    return size_ > 4 * r.rounding && !is_steep_ && slope_ > 1.0 / 64 && slope_ < 64;
  }
  Chord chord(Real more) const {
    const Real apex = half_ + more * secant_ / slope_, above = apex - foot_.y(), wide = slope_ * above;
    const Real x = wide * u_.x() - widens_ * foot_.x(), z = wide * u_.z() - widens_ * foot_.z();
    const Real reach = std::sqrt(x * x + z * z), off = std::fabs(cross_);
    if (off > reach && a_ > 0) return {};  // a line steeper than the flank passes through, whatever rounding says
    const Real b = foot_.x() * u_.x() + foot_.z() * u_.z() - wide * widens_;
    const Real root = std::sqrt(std::max(reach - off, Real(0)) * (reach + off)), length = std::fabs(b) + root;
    const Real blur = (more > 0 ? 32 : more < 0 ? -32 : 0) * kUnitRoundoff * length / std::fabs(a_);
    Chord c{true, -kInfinity, kInfinity};
    if (a_ > 0) {
      if (!(above + b / a_ * u_.y() >= 0)) return {};  // the mirrored one
      c.in = from_ + (-b - root) / a_ - blur, c.out = from_ + (-b + root) / a_ + blur;
    } else if (u_.y() > 0) {
      c.out = from_ + (-b + root) / a_ + blur;  // a < 0: the smaller one
    } else {
      c.in = from_ + (-b - root) / a_ - blur;
    }
    cut_by_planes(-half_ - more, kInfinity, foot_.y(), u_.y(), from_, c);
    c.met &= c.in <= c.out;
    return c;
  }
  Vec3 outward(const LocalRay& r, Real s) const {
    const Vec3 p = r.o + s * r.u;
    const Real off = std::sqrt(p.x() * p.x() + p.z() * p.z());
    if (off == 0) return p.y() < 0 ? Vec3(0, -1, 0) : Vec3(0, 1, 0);
    // On the border it is the one that faces the ray more.
    const Vec3 base(0, -1, 0), flank = Vec3(p.x() / off, slope_, p.z() / off) / secant_;
    const Real beyond = -half_ - p.y() - (off - slope_ * (half_ - p.y())) / secant_;
    return beyond > 4 * r.rounding || (beyond > -4 * r.rounding && base.dot(r.u) < flank.dot(r.u)) ? base : flank;
  }

 private:
  Real half_, slope_, secant_;
  Vec3 u_, foot_;  // m, the line's nearest point to the origin
  Real from_;      // m, where that is
  Real size_;
  Real widens_ = 0, a_ = 0, cross_ = 0;
  bool is_steep_ = false;
};

/// A ball in coordinates divided by its radii. Scaled by 1 + more / the least of them it holds all that is within more.
class Ellipsoid {
 public:
  Ellipsoid(const Shape& shape, const LocalRay& r, Real) : radii_(shape.half), from_(-r.start) {
    const Vec3 foot = r.o - r.start * r.u;
    Vec3 at, along;
    for (int i = 0; i < 3; ++i) at[i] = foot[i] / radii_[i], along[i] = r.u[i] / radii_[i];
    length_ = along.norm();
    along /= length_;
    foot_ = -along.dot(at);
    off_ = (at + foot_ * along).norm();
  }
  /// Not what is much longer than it is thin: brackets would be too wide.
  bool usable(const LocalRay& r) const {
    return radii_.min_entry() > 4 * r.rounding && radii_.max_entry() < 64 * radii_.min_entry();
  }
  Chord chord(Real more) const {
    Chord c = through_ball(off_, foot_, 1 + more / radii_.min_entry());
    c.in = from_ + c.in / length_, c.out = from_ + c.out / length_;
    return c;
  }
  Vec3 outward(const LocalRay& r, Real s) const {
    Vec3 n = r.o + s * r.u;
    for (int i = 0; i < 3; ++i) n[i] /= radii_[i] * radii_[i];
    return n.normalized();
  }

 private:
  Vec3 radii_;
  Real from_;                             // m, where the line is nearest to the origin
  Real length_ = 0, foot_ = 0, off_ = 0;  // 1/m, and 1, in radii
};

/// What a line that grazes meets first: the form swollen by as little as it takes.
/// @param enough  m, swollen by which the line meets it
template <class Form>
Chord least_chord(const Form& form, Real enough) {
  Real less = 0;
  Chord c = form.chord(enough);
  for (int i = 0; i < 24; ++i) {
    const Real more = 0.5 * (less + enough);
    const Chord between = form.chord(more);
    (between.met ? enough : less) = more;
    if (between.met) c = between;
  }
  return c;
}

template <class Form>
bool cast_form(const Ray& ray, const Shape& shape, const Frame& frame, const LocalRay& r, const CastSettings& settings,
               CastResult& result) {
  const Form form(shape, r, settings.target);
  if (!form.usable(r)) return false;
  const Real length = r.speed * ray.max;
  const Chord outer = form.chord(r.rounding);
  if (!outer.met || outer.in > length || outer.out < 0) return miss(ray, result), true;
  const Chord inner = form.chord(-r.rounding), middle = form.chord(0);
  const auto time = [&](Real s) { return std::clamp(s / r.speed, Real(0), ray.max); };
  result.at_start = outer.in <= 0;
  if (inner.met && inner.in <= 0 && inner.out >= 0) {
    result.outcome = CastOutcome::overlap;
    result.upper = 0;
    result.normal = frame.rotate(r.u);
    result.point_a = result.point_b = ray.origin;
    return true;
  }
  const bool goes_in = inner.met && inner.in > 0;
  // Swollen, a tip goes farther than it swells: whether that is a graze the walk says.
  if (!goes_in && std::is_same_v<Form, Cone>) {
    result.at_start = false;
    return false;
  }
  const Chord chord = middle.met ? middle : least_chord(form, r.rounding);
  const Real in = chord.in, hair = 16 * r.rounding;
  // From an edge within the plane of a side: it would be met from farther off, too.
  const bool begins = in >= -hair && chord.out > in + hair && chord.out > hair;
  if (!goes_in && (settings.target > 0 || (result.at_start && !begins))) {  // along the surface, or leaving it
    result.at_start = false;
    return miss(ray, result), true;
  }
  const Real upper = goes_in ? inner.in : in;
  result.outcome = CastOutcome::hit;
  result.lower = time(outer.in);
  result.upper = std::max(time(upper), result.lower);
  result.time = std::clamp(time(in), result.lower, result.upper);
  if (!(upper - outer.in <= settings.tolerance * shape.bounding_radius)) result.status = QueryStatus::rounding;
  result.separation = settings.target;
  Vec3 n = -form.outward(r, in);
  const Real facing = n.dot(r.u);
  if (facing < 0) {  // at a border or tip, within rounding: one square to the ray is among the normals there
    n -= facing * r.u;
    n = n.squared_norm() > 1e-12 ? n.normalized() : r.u;
  }
  result.normal = frame.rotate(n);
  result.point_b = frame.apply(r.o + in * r.u + settings.target * n);
  result.point_a = ray.origin + result.time * ray.direction;
  return true;
}

}  // namespace

bool cast_at_form(const Ray& ray, const Shape& shape, const Frame& frame, const LocalRay& r,
                  const CastSettings& settings, CastResult& result) {
  if (!(r.speed * ray.max > 0)) return false;
  switch (shape.form) {
    case Form::sphere:
      return cast_form<Sphere>(ray, shape, frame, r, settings, result);
    case Form::capsule:
      return cast_form<Capsule>(ray, shape, frame, r, settings, result);
    case Form::box:
      return settings.target == 0 && cast_form<Box>(ray, shape, frame, r, settings, result);
    case Form::cylinder:
      return settings.target == 0 && cast_form<Cylinder>(ray, shape, frame, r, settings, result);
    case Form::cone:
      return settings.target == 0 && cast_form<Cone>(ray, shape, frame, r, settings, result);
    case Form::ellipsoid:
      return settings.target == 0 && cast_form<Ellipsoid>(ray, shape, frame, r, settings, result);
    default:
      return false;
  }
}

}  // namespace carom::collision
