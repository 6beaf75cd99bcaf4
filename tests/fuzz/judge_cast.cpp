// Answers about a motion against distance queries along it, whose brackets have a judge of their own.
//
//   - before `lower` the pair is farther apart than the target: no query there may prove it nearer;
//   - somewhere in [lower, upper] it is as near as the target and the slack: the query at the bracket's ends may not
//     prove it farther than that and what the motion covers in between;
//   - a miss is farther than the target everywhere, an overlap not farther at the start.
// Where a query stands on poses of its own, their rounding is allowed for (collision/cast/rounding.h).
#include <algorithm>
#include <cstdio>

#include "cast_case.h"
#include "collision/cast/overlap.h"
#include "collision/cast/ray.h"
#include "collision/cast/rounding.h"
#include "collision/cast/shape_cast.h"
#include "collision/cast/time_of_impact.h"
#include "collision/narrow/pair.h"
#include "collision/support.h"

namespace carom::fuzz {
namespace {

class Motions {
 public:
  explicit Motions(const CastCase& c) : c_(c), a_(make(c.pair.a)), b_(make(c.pair.b)) {
    if (c.kind == CastKind::ray) a_ = test_point();
    quat_b_ = normalized(Quat(c.pair.b_in_a.r));
    const auto extent = [](const Shape& s) {
      return s.form == Form::half_space ? std::fabs(s.offset) : s.bounding_radius;
    };
    reach_ = extent(a_) + extent(b_);
    speed_ = c.motion.norm();
    if (c.kind == CastKind::turning) speed_ += c.turn_a.norm() * extent(a_) + c.turn_b.norm() * extent(b_);
    size_ = c.pair.b_in_a.p.norm() + c.motion.norm() + reach_ + c.target;
  }

  Verdict judge() {
    if (!(reach_ < kMaxReach)) return verdict_;  // no shape that could be made
    CastSettings settings;
    settings.tolerance = c_.tolerance;
    settings.target = c_.target;
    settings.cap = c_.cap;
    SupportFault fault;
    const Frame frame_b = c_.kind == CastKind::turning ? Frame(Pose{quat_b_, c_.pair.b_in_a.p}) : c_.pair.b_in_a;
    switch (c_.kind) {
      case CastKind::linear:
        cast_shape(a_, Frame(), c_.motion, b_, frame_b, settings, r_, fault);
        break;
      case CastKind::ray:
        cast_ray(Ray{Vec3::zero(), c_.motion, 1}, b_, frame_b, settings, r_, fault);
        break;
      case CastKind::turning: {
        const RigidMotion moves_a{Pose(), Vec3::zero(), c_.motion, c_.turn_a};
        const RigidMotion moves_b{Pose{quat_b_, c_.pair.b_in_a.p}, c_.pair.b_in_a.p, Vec3::zero(), c_.turn_b};
        time_of_impact(a_, moves_a, b_, moves_b, 1, settings, r_, fault);
        break;
      }
      default:
        return overlap_answer();
    }
    if (fault.kind != SupportFault::none) return bad("a valid function was blamed"), verdict_;
    form();
    if (verdict_.good) truth();
    return verdict_;
  }

 private:
  /// The ray's point: a body of one vertex.
  static Shape test_point() {
    ShapeSpec point;
    point.kind = Kind::hull;
    point.params = {0, 0, 0};
    return make(point);
  }

  void bad(const char* what, Real t = 0, Real x = 0, Real y = 0) {
    if (!verdict_.good) return;
    verdict_.good = false;
    std::snprintf(verdict_.reason, sizeof verdict_.reason,
                  "%s at %.17g: %.17g, %.17g (kind %d, outcome %u, status %u, [%.17g, %.17g], slack %.3g, target %.9g)",
                  what, t, x, y, static_cast<int>(c_.kind), static_cast<unsigned>(r_.outcome),
                  static_cast<unsigned>(r_.status), r_.lower, r_.upper, r_.slack, c_.target);
  }

  /// The pair's separation at a time, as a bracket.
  QueryResult at(Real t) const {
    Frame a, b = c_.pair.b_in_a;
    if (c_.kind == CastKind::turning) {
      a = Frame(RigidMotion{Pose(), Vec3::zero(), c_.motion, c_.turn_a}.after(t));
      b = Frame(RigidMotion{Pose{quat_b_, b.p}, b.p, Vec3::zero(), c_.turn_b}.after(t));
    } else {
      a.p = t * c_.motion;
    }
    QuerySettings settings;
    settings.routines = false;
    settings.tolerance = 1e-8;
    QueryResult found;
    SupportFault fault;
    distance(a_, b_, relative(a, b), settings, nullptr, found, fault);
    return found;
  }

  void form() {
    const bool numbers = finite(r_.time) && finite(r_.lower) && finite(r_.separation) && finite(r_.slack) &&
                         finite(r_.normal) && finite(r_.point_a) && finite(r_.point_b);
    if (!numbers) return bad("not finite");
    if (!(r_.lower <= r_.time && r_.time <= r_.upper && r_.slack >= 0)) bad("time outside its bracket", r_.time);
    if (!(r_.lower >= 0 && r_.lower <= 1)) bad("lower end outside the motion", r_.lower);
    if ((r_.outcome == CastOutcome::miss) != (r_.upper == kInfinity) && r_.outcome != CastOutcome::undecided)
      bad("upper end");
    if (r_.outcome == CastOutcome::hit && !(std::fabs(r_.normal.norm() - 1) < 1e-12)) bad("normal", r_.normal.norm());
  }

  void truth() {
    const Real rounding = (kCastRounding + kBracketRounding + kPoseRounding) * kUnitRoundoff * size_;
    if (r_.outcome == CastOutcome::overlap) {
      const QueryResult now = at(0);
      if (now.lower > c_.target + r_.slack + rounding) bad("overlap, but apart", 0, now.lower);
      return;
    }
    // Times before which nothing is near, the last ones all but there.
    const Real end = r_.outcome == CastOutcome::miss ? 1 : r_.lower;
    for (const Real share : {0.0, 0.31, 0.62, 0.9, 0.999, 0.999999}) {
      if (!(end > 0)) break;
      const QueryResult before = at(share * end);
      if (before.upper < c_.target - rounding) bad("touches before", share * end, before.upper);
    }
    if (r_.outcome == CastOutcome::miss && c_.kind != CastKind::turning) nearest_of_line(rounding);
    if (r_.outcome != CastOutcome::hit) return;
    Real nearest = kInfinity;
    for (const Real t : {r_.lower, r_.time, std::min(r_.upper, Real(1))}) nearest = std::min(nearest, at(t).lower);
    const Real covered = speed_ * (r_.upper - r_.lower);
    if (nearest > c_.target + r_.slack + covered + rounding) bad("hit, but apart", r_.time, nearest, covered);
  }

  /// Along a line the separation is convex while it is positive: the way down leads to its least.
  void nearest_of_line(Real rounding) {
    Real lo = 0, hi = 1;
    for (int i = 0; i < 10; ++i) {
      const Real left = lo + 0.4 * (hi - lo), right = lo + 0.6 * (hi - lo);
      const QueryResult l = at(left), r = at(right);
      for (const auto& [t, q] : {std::pair(left, l), std::pair(right, r)})
        if (q.upper < c_.target - rounding) return bad("missed", t, q.upper);
      (l.separation < r.separation ? hi : lo) = l.separation < r.separation ? right : left;
    }
  }

  Verdict overlap_answer() {
    SupportFault fault;
    const bool flat = a_.form == Form::half_space || b_.form == Form::half_space;
    if (flat) return verdict_;
    const OverlapResult o = overlap(a_, b_, c_.pair.b_in_a, c_.target, 0, c_.cap, fault);
    if (fault.kind != SupportFault::none || o.outcome == Overlap::fault)
      return bad("a valid function was blamed"), verdict_;
    if (!finite(o.normal) || !finite(o.point)) return bad("not finite"), verdict_;
    const QueryResult now = at(0);
    const Real rounding = 2 * kBracketRounding * kUnitRoundoff * size_;
    if (o.outcome == Overlap::apart &&
        (now.upper < o.separation_bound - rounding || !(o.separation_bound >= c_.target)))
      bad("apart, but nearer", 0, now.upper, o.separation_bound);
    if (o.outcome == Overlap::overlapping && now.lower > c_.target + o.slack + rounding)
      bad("overlapping, but apart", 0, now.lower);
    return verdict_;
  }

  const CastCase& c_;
  Shape a_, b_;
  Quat quat_b_;
  Real reach_ = 0, speed_ = 0, size_ = 0;
  CastResult r_;
  Verdict verdict_;
};

}  // namespace

Verdict judge(const CastCase& c) { return Motions(c).judge(); }

}  // namespace carom::fuzz
