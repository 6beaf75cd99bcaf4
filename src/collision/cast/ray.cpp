// The ray in the shape's frame: quick ways out, then the walk along the line.
#include "collision/cast/ray.h"

#include "collision/cast/line.h"
#include "collision/cast/local_ray.h"
#include "collision/cast/overlap.h"
#include "collision/core.h"
#include "collision/support.h"

namespace carom::collision {
namespace {

/// The core of one shape in the coordinates of a line.
class RaySet {
 public:
  struct Point {
    Vec3 y;
  };

  /// @param basis  columns: two perpendiculars of the line, its direction; shape frame
  /// @param offset of the line across itself, scaled
  RaySet(const Shape& shape, const Mat3& basis, const Vec2& offset, Real scale, SupportFault& fault)
      : core_(shape),
        basis_(basis),
        scaled_(scale * basis.transpose()),
        offset_(offset.x(), offset.y(), 0),
        fault_(fault) {}

  bool support(const Vec3& n, Point& out) {
    const Vec3 d = -(basis_ * n);
    Vec3 p = Vec3::zero();
    if (!core_.support(d, p)) return core_.blame(d, p, fault_);
    out.y = scaled_ * p - offset_;
    return true;
  }

  void blame(const Vec3& n, const Point& claimed, const Point&) {
    const Vec3 d = -(basis_ * n), p = at(claimed.y);
    fault_.kind = SupportFault::not_support;
    fault_.shape = &core_.shape();
    for (int i = 0; i < 3; ++i) fault_.dir[i] = d[i], fault_.out[i] = p[i];
  }

  /// A point in the shape's frame.
  Vec3 at(const Vec3& y) const {
    const Vec3 p = scaled_.transpose() * (y + offset_);
    const Real scale = scaled_.row(0).norm();
    return p / (scale * scale);
  }

 private:
  Core core_;
  Mat3 basis_, scaled_;
  Vec3 offset_;
  SupportFault& fault_;
};

/// Whether the stretch of the line passes outside a box that holds the shape, swollen. For flat and long shapes, which
/// a ball fits badly.
bool passes_box(const Shape& shape, const LocalRay& r, Real target) {
  const Real more = target + r.rounding + kSloppiness * shape.bounding_radius;
  Real in = 0, out = r.stop - r.start;
  for (int i = 0; i < 3; ++i) {
    const Real lo = shape.bounds.lo[i] - more - r.o[i], hi = shape.bounds.hi[i] + more - r.o[i];
    if (r.u[i] == 0) {
      if (lo > 0 || hi < 0) return true;
      continue;
    }
    const Real by = 1 / r.u[i];
    const Real a = lo * by, b = hi * by;
    in = std::max(in, std::min(a, b));
    out = std::min(out, std::max(a, b));
  }
  return in > out;
}

/// A plane is met at one time, known in closed form.
void cast_at_plane(const Ray& ray, const Shape& shape, const Frame& frame, Real target, CastResult& result) {
  const Vec3 n = frame.rotate(shape.normal), from = ray.origin - frame.p;
  if (!(from.abs().sum() < 1e100 && ray.direction.abs().sum() < 1e100)) {
    result.outcome = CastOutcome::undecided;
    result.status = QueryStatus::rounding;
    return;
  }
  const Real height = n.dot(from) - shape.offset, rate = n.dot(ray.direction);
  const Real rounding =
      kUnitRoundoff * (kCastRounding * (from.norm() + std::fabs(shape.offset) + target) +
                       kPlaceRounding * (frame.p.norm() + ray.origin.norm()));
  const Real gap = height - target;
  const bool along = !(rate < -8 * kUnitRoundoff * ray.direction.norm());  // or away
  result.normal = -n;
  result.slack = rounding;
  result.at_start = gap <= rounding;
  if (gap < -rounding || (gap <= 0 && !(ray.max > 0 && !ray.direction.is_zero()))) {
    result.outcome = CastOutcome::overlap;
    result.upper = 0;
    result.separation = height;
  } else if (along || gap > -rate * ray.max) {
    result.normal.set_zero();
    result.at_start = false;
    return miss(ray, result);
  } else {
    result.outcome = CastOutcome::hit;
    result.time = std::max(gap, Real(0)) / -rate;
    result.lower = std::max((gap - rounding) / -rate, Real(0));
    result.upper = std::min((gap + rounding) / -rate, ray.max);
    result.separation = target;
  }
  result.point_a = ray.origin + result.time * ray.direction;
  result.point_b = result.point_a - result.separation * n;
}

/// No motion: in the shape or not.
void ask_point(const Ray& ray, const Shape& shape, const Frame& frame, const CastSettings& settings, CastResult& result,
               SupportFault& fault) {
  const OverlapResult found = overlap_with_point(shape, frame.apply_inverse(ray.origin), settings.target,
                                                 kCastRounding * kUnitRoundoff, settings.cap, fault);
  result.support_calls = result.iterations = found.support_calls;
  result.point_a = result.point_b = ray.origin;
  result.slack = found.slack;
  if (found.outcome == Overlap::apart) return miss(ray, result);
  result.outcome = found.outcome == Overlap::overlapping ? CastOutcome::overlap : CastOutcome::undecided;
  result.upper = 0;
  result.at_start = true;
  result.status = found.outcome == Overlap::fault ? QueryStatus::fault : QueryStatus::exact_enough;
  result.normal = frame.rotate(found.normal);
}

using RayEntry = line::Entry<RaySet::Point>;

/// The result of a walk that found where the line enters, in the ray's own terms.
void write_hit(const Ray& ray, const Frame& frame, const LocalRay& r, const Mat3& basis, const RayEntry& e, Real scale,
               Real target, CastResult& result) {
  const auto time = [&](Real s) { return std::clamp((s / scale - r.start) / r.speed, Real(0), ray.max); };
  result.outcome = CastOutcome::hit;
  result.lower = time(e.lower);
  result.upper = std::max(time(e.upper), result.lower);
  result.time = std::clamp(time(e.s), result.lower, result.upper);
  result.status = e.settled ? QueryStatus::exact_enough : QueryStatus::rounding;
  result.separation = target;
  const Vec3 n = basis * e.normal;
  result.normal = frame.rotate(n);
  // Where the ray is, not where the weights of a sliver of a triangle say.
  result.point_b = frame.apply(r.o + (e.s / scale - r.start) * r.u + target * n);
  result.point_a = ray.origin + result.time * ray.direction;
}

void cast_whole(const Ray& ray, const Shape& shape, const Frame& frame, const CastSettings& settings,
                CastResult& result, SupportFault& fault) {
  result = CastResult();
  const Real target = settings.target;
  if (shape.form == Form::half_space) return cast_at_plane(ray, shape, frame, target, result);
  const LocalRay r(ray, shape, frame, target);
  if (!(r.reach < 1e80 && r.speed < 1e100)) {  // squares would overflow
    result.outcome = CastOutcome::undecided;
    result.status = QueryStatus::rounding;
    return;
  }
  result.slack = 3 * r.rounding;
  if (settings.routines && cast_at_form(ray, shape, frame, r, settings, result)) return;
  const Vec3 off = r.o - r.start * r.u;
  if (!(off.squared_norm() <= r.reach * r.reach) || r.start > r.reach || r.stop < -r.reach) return miss(ray, result);
  if (!(r.speed * ray.max > 0)) return ask_point(ray, shape, frame, settings, result, fault);
  if (passes_box(shape, r, target)) return miss(ray, result);

  int exponent = 0;
  std::frexp(r.reach, &exponent);
  const Real scale = std::ldexp(Real(1), -std::clamp(exponent, -1000, 1000));
  const Mat3 basis = line::axes_along(r.u);
  const Vec2 offset = scale * (basis.transpose() * off).xy();
  line::Request request;
  request.radius = scale * (shape.core_radius + target);
  request.rounding = scale * r.rounding;
  request.slack = 1e-6 * scale * r.reach;
  request.start = scale * r.start;
  request.stop = scale * r.stop;
  request.width = scale * settings.tolerance * shape.bounding_radius;
  request.cap = settings.cap;

  const auto set_in = [&](const Mat3& axes, Real) { return RaySet(shape, axes, offset, scale, fault); };
  RayEntry entry;
  const Vec3 centre = 0.5 * (shape.bounds.lo + shape.bounds.hi);
  const Vec2 first = scale * (basis.transpose() * centre).xy() - offset;
  const auto within = [&](Real s) {
    const OverlapResult found = overlap_with_point(shape, off + (s / scale) * r.u, target, r.rounding / r.size,
                                                   settings.cap, fault);
    return line::Within{found.outcome, found.normal.dot(r.u), found.capped};
  };
  const line::Graze graze = target > 0 ? line::Graze::misses : line::Graze::enters;
  const line::Contact contact = line::meet(basis, set_in, request, first, graze, within, entry);
  result.support_calls = result.iterations = entry.calls;
  const bool capped = entry.calls >= settings.cap, inside = contact == line::Contact::inside;
  if (contact == line::Contact::misses) return miss(ray, result);
  if (contact == line::Contact::fault) {
    result.status = QueryStatus::fault;
    result.outcome = CastOutcome::undecided;
    return;
  }
  result.at_start = inside || contact == line::Contact::goes_in;
  if (inside) {
    result.outcome = CastOutcome::overlap;
    result.upper = 0;
    result.normal = frame.rotate(r.u);
    result.point_a = result.point_b = ray.origin;
    return;
  }
  if (result.at_start || contact == line::Contact::enters) {
    write_hit(ray, frame, r, basis, entry, scale, target, result);
    if (!entry.settled && capped) result.status = QueryStatus::capped;
    return;
  }
  // It ends as it touches, or the cap came first: the nearest it comes is an estimate of when.
  result.outcome = CastOutcome::undecided;
  result.status = capped ? QueryStatus::capped : QueryStatus::rounding;
  result.time = std::clamp(-r.start / r.speed, Real(0), ray.max);
  result.point_a = result.point_b = ray.origin + result.time * ray.direction;
}

}  // namespace

void cast_ray(const Ray& ray, const Shape& shape, const Frame& frame, const CastSettings& settings, CastResult& result,
              SupportFault& fault) {
  cast_whole(ray, shape, frame, settings, result, fault);
  if (settings.ignore_touched && result.at_start) miss(ray, result = CastResult());
}

int cast_ray(const Ray& ray, std::span<const Placed> shapes, const CastSettings& settings, CastResult& result,
             SupportFault& fault) {
  int first = -1;
  miss(ray, result = CastResult());
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    CastResult one;
    cast_ray(ray, *shapes[i].shape, shapes[i].frame, settings, one, fault);
    const bool bad = one.status == QueryStatus::fault;
    if (one.outcome == CastOutcome::miss || (first >= 0 && !bad && !(one.time < result.time))) continue;
    result = one;
    first = static_cast<int>(i);
    if (bad) return first;
  }
  return first;
}

}  // namespace carom::collision
