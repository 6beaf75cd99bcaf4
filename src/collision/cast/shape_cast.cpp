// The difference of two shapes against the line that A's motion draws through it.
#include "collision/cast/shape_cast.h"

#include <algorithm>

#include "collision/cast/line.h"
#include "collision/cast/overlap.h"
#include "collision/cast/rounding.h"
#include "collision/narrow/difference.h"
#include "collision/narrow/pair.h"
#include "collision/support.h"

namespace carom::collision {
namespace {

/// B - A of the cores in the coordinates of a line.
class DifferenceSet {
 public:
  struct Point {
    Vec3 y;
    DifferencePoint d;
  };
  /// @param basis  columns: two perpendiculars of the line, its direction; A's frame
  /// @param from   scaled, along the line: where its coordinate is zero
  DifferenceSet(Difference& difference, const Mat3& basis, Real from)
      : difference_(difference), basis_(basis), from_(0, 0, from) {}

  bool support(const Vec3& n, Point& out) {
    Real value;
    const Vec3 d = basis_ * n;
    if (!difference_.support(d / d.norm(), out.d, value)) return false;
    out.y = basis_.transpose() * out.d.w - from_;
    return true;
  }
  void blame(const Vec3& n, const Point& claimed, const Point& seen) {
    difference_.blame_worse(basis_ * n, claimed.d, seen.d);
  }

 private:
  Difference& difference_;
  Mat3 basis_;
  Vec3 from_;
};

using CastEntry = line::Entry<DifferenceSet::Point>;

void miss(CastResult& result) {
  result.outcome = CastOutcome::miss;
  result.time = result.lower = 1;
  result.upper = kInfinity;
  result.normal.set_zero();
}

/// All that the walks share.
struct Cast {
  const Shape &a, &b;
  const Frame &frame_a, &frame_b;
  const Vec3& motion;
  const CastSettings& settings;
  CastResult& result;
  SupportFault& fault;
  Frame b_in_a;
  Real rounding = 0;           // m
  Real relative_rounding = 0;  // of the size of the pair

  /// Time 0, from the signed distance: overlapping, or touching.
  void at_start(CastOutcome outcome) {
    QuerySettings query;
    query.tolerance = std::max(settings.tolerance, Real(1e-12));
    QueryResult found;
    distance(a, b, b_in_a, query, nullptr, found, fault);
    result.outcome = outcome;
    result.at_start = true;
    result.support_calls += found.support_calls;
    result.time = result.lower = result.upper = 0;
    result.status = found.status;
    result.separation = found.separation;
    result.normal = frame_a.rotate(found.normal);
    result.point_a = frame_a.apply(found.point_a);
    result.point_b = frame_b.apply(found.point_b);
    if (found.status == QueryStatus::fault) result.outcome = CastOutcome::undecided;
  }

  /// One of them is a half-space: the separation falls linearly.
  void at_plane() {
    QueryResult found;
    distance(a, b, b_in_a, QuerySettings(), nullptr, found, fault);
    result.support_calls = found.support_calls;
    const Vec3 n = frame_a.rotate(found.normal);
    const Real rate = -n.dot(motion), gap = found.separation - settings.target;
    const bool along = !(rate < -8 * kUnitRoundoff * motion.norm());  // or away
    result.slack = rounding;
    if (found.status == QueryStatus::fault) {  // of a point, whose size is 0, no bracket is narrow enough; slack tells
      result.status = found.status;
      result.outcome = CastOutcome::undecided;
      return;
    }
    const bool apart = gap >= -rounding && !(gap <= 0 && motion.is_zero());
    if (apart && (along || gap > -rate)) return miss(result);
    result.outcome = apart ? CastOutcome::hit : CastOutcome::overlap;
    result.at_start = gap <= rounding;
    if (apart) {
      result.time = std::max(gap, Real(0)) / -rate;
      result.lower = std::max((gap - rounding) / -rate, Real(0));
      result.upper = std::min((gap + rounding) / -rate, Real(1));
    } else {
      result.upper = 0;
    }
    result.separation = apart ? settings.target : found.separation;
    result.normal = n;
    result.point_a = frame_a.apply(found.point_a) + result.time * motion;
    result.point_b = frame_b.apply(found.point_b);
    if (apart) result.point_b = result.point_a + settings.target * n;
  }

  /// No motion: near enough already, or not.
  void at_rest() {
    const OverlapResult found =
        overlap(a, b, b_in_a, settings.target, relative_rounding, settings.cap, fault);
    result.support_calls = found.support_calls;
    if (found.outcome == Overlap::apart) return miss(result);
    at_start(found.outcome == Overlap::overlapping ? CastOutcome::overlap : CastOutcome::undecided);
  }

  void run() {
    const Real size = (frame_b.p - frame_a.p).norm() + extent(a) + extent(b) + settings.target;
    rounding = kUnitRoundoff * (kCastRounding * size + kPlaceRounding * (frame_a.p.norm() + frame_b.p.norm()));
    relative_rounding = size > 0 ? rounding / size : 0;
    result.slack = 3 * rounding;
    if (!usable(b_in_a)) {
      result.outcome = CastOutcome::undecided;
      result.status = QueryStatus::rounding;
      return;
    }
    if (a.form == Form::half_space || b.form == Form::half_space) return at_plane();
    const Vec3 d = frame_a.rotate_inverse(motion);
    const Real largest = d.abs().max_entry();
    if (!(largest > 0)) return at_rest();
    const Vec3 u = direction_of(d);
    along(u, largest * (d / largest).norm());
  }

  /// @param u  unit, A's frame   @param length  m
  void along(const Vec3& u, Real length) {
    const Real ahead = u.dot(b_in_a.p);
    const Real reach = (1 + 1e-6) * (a.bounding_radius + b.bounding_radius + settings.target) + rounding;
    if (!((b_in_a.p - ahead * u).squared_norm() <= reach * reach) || ahead < -reach || ahead > length + reach)
      return miss(result);

    Difference difference(a, b, b_in_a, settings.target);
    const Mat3 basis = line::axes_along(u);
    line::Request request;
    request.radius = difference.radii();
    request.rounding = difference.to_scaled(rounding);
    request.slack = difference.slack();
    request.start = difference.to_scaled(-ahead);
    request.stop = difference.to_scaled(length - ahead);
    const Real smaller = std::min(a.bounding_radius, b.bounding_radius);
    request.width = difference.to_scaled(settings.tolerance * (smaller > 0 ? smaller : reach));
    request.cap = settings.cap;
    const Vec2 first = (basis.transpose() * difference.centre_offset()).xy();

    const Real from = difference.to_scaled(ahead);
    const auto set_in = [&](const Mat3& axes, Real side) { return DifferenceSet(difference, axes, side * from); };
    CastEntry entry;
    const auto within = [&](Real s) {
      Frame moved = b_in_a;
      moved.p -= (difference.to_metres(s) + ahead) * u;
      const OverlapResult found =
          overlap(a, b, moved, settings.target, relative_rounding, settings.cap, difference.fault);
      return line::Within{found.outcome, found.normal.dot(u), found.capped};
    };
    const line::Contact contact = line::meet(basis, set_in, request, first, line::Graze::misses, within, entry);
    result.support_calls = result.iterations = entry.calls;
    if (contact == line::Contact::misses) return miss(result);
    if (contact == line::Contact::inside) return at_start(CastOutcome::overlap);
    if (contact == line::Contact::goes_in) return at_start(CastOutcome::hit);
    if (contact == line::Contact::fault) {
      fault = difference.fault;
      result.status = QueryStatus::fault;
      result.outcome = CastOutcome::undecided;
      return;
    }
    const bool capped = entry.calls >= settings.cap;
    if (contact == line::Contact::enters) {
      write_hit(difference, basis, entry, length, ahead);
      if (!entry.settled) result.status = capped ? QueryStatus::capped : QueryStatus::rounding;
      return;
    }
    result.outcome = CastOutcome::undecided;
    result.status = capped ? QueryStatus::capped : QueryStatus::rounding;
    result.time = std::clamp(ahead / length, Real(0), Real(1));
  }

  void write_hit(const Difference& difference, const Mat3& basis, const CastEntry& e, Real length, Real ahead) {
    const auto time = [&](Real s) { return std::clamp((difference.to_metres(s) + ahead) / length, Real(0), Real(1)); };
    result.outcome = CastOutcome::hit;
    result.lower = time(e.lower);
    result.upper = std::max(time(e.upper), result.lower);
    result.time = std::clamp(time(e.s), result.lower, result.upper);
    result.separation = settings.target;
    Vec3 on_a = Vec3::zero(), on_b = Vec3::zero();
    for (int i = 0; i < e.count; ++i) {
      on_a += e.weight[i] * e.point[i].d.a;
      on_b += e.weight[i] * e.point[i].d.b;
    }
    const Vec3 n = basis * e.normal;
    result.normal = frame_a.rotate(n);
    result.point_a = frame_a.apply(on_a + a.core_radius * n) + result.time * motion;
    result.point_b = frame_b.apply(on_b - b.core_radius * b_in_a.rotate_inverse(n));
  }
};

}  // namespace

void cast_shape(const Shape& a, const Frame& frame_a, const Vec3& motion, const Shape& b, const Frame& frame_b,
                const CastSettings& settings, CastResult& result, SupportFault& fault) {
  result = CastResult();
  Cast{a, b, frame_a, frame_b, motion, settings, result, fault, relative(frame_a, frame_b)}.run();
  if (settings.ignore_touched && result.at_start) miss(result = CastResult());
}

}  // namespace carom::collision
