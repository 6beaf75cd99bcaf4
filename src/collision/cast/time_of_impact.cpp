// Conservative advancement: ask for a separating plane, go as far as the motion cannot close its gap, ask again.
#include "collision/cast/time_of_impact.h"

#include <algorithm>

#include "collision/cast/overlap.h"
#include "collision/cast/rounding.h"
#include "collision/core.h"

namespace carom::collision {
namespace {

// A turn by an angle phi is computed to 4 u, its angle to 2 u phi: what that moves, in units of u of the arm.
constexpr Real kTurnRounding = 8;

// Support evaluations that a proof of overlap is worth: pairs that cross by a tolerance take some 20 at 1e-6.
constexpr int kProofCap = 200;

// Tolerances that a bracket may be long, as a way: what crosses later than that grazes.
constexpr Real kGraze = 1e3;

bool flat(const Shape& s) { return s.form == Form::half_space; }

/// The farthest that the core reaches from the centre of rotation. The radius around the core turns into itself.
Real arm(const Shape& s, const RigidMotion& m) {
  return flat(s) ? 0 : (m.at.p - m.centre).norm() + std::max(s.bounding_radius - s.core_radius, Real(0));
}

class Advance {
 public:
  Advance(const Shape& a, const RigidMotion& motion_a, const Shape& b, const RigidMotion& motion_b, Real duration,
          const CastSettings& settings, CastResult& result, SupportFault& fault)
      : a_(a),
        b_(b),
        ma_(motion_a),
        mb_(motion_b),
        duration_(duration),
        settings_(settings),
        result_(result),
        fault_(fault) {
    // Seen from where A starts, moving along with its centre: far from the origin nothing is lost.
    origin_ = motion_a.at.p;
    ma_.at.p.set_zero();
    ma_.centre -= origin_;
    mb_.at.p -= origin_;
    mb_.centre -= origin_;
    mb_.velocity -= ma_.velocity;
    drift_ = ma_.velocity;
    ma_.velocity.set_zero();
    arm_a_ = arm(a, ma_);
    arm_b_ = arm(b, mb_);
    const Real size = flat(a)   ? b.bounding_radius
                      : flat(b) ? a.bounding_radius
                                : std::min(a.bounding_radius, b.bounding_radius);
    tolerance_ = settings.tolerance * (size > 0 ? size : arm_a_ + arm_b_);
  }

  void run() {
    Real t = 0, gap = kInfinity;
    if (!(rounding_at(duration_) < 1e80)) {  // squares of what poses hold would overflow
      result_.outcome = CastOutcome::undecided;
      result_.status = QueryStatus::rounding;
      return;
    }
    for (int i = 0; i < std::max(settings_.cap, 1); ++i) {
      const Real finest = 0.25 * tolerance_;
      if (!look(t, std::max(finest, std::min(0.1 * gap, 0.1 * size())))) return;
      // Too coarse to tell near from touching.
      if (seen_.found.lower - seen_.rounding <= settings_.target + finest && !look(t, finest)) return;
      gap = seen_.found.lower - seen_.rounding - settings_.target;
      if (t == 0 && seen_.found.separation <= settings_.target) {
        write(CastOutcome::overlap, 0, 0, 0, seen_.found.separation);
        // The separation is the bracket's lower end: how much farther apart they may be.
        result_.slack += std::max(seen_.found.upper - settings_.target, Real(0));
        return;
      }
      if (gap > 0 && !clear_until(t, gap, result_.lower)) return;
      until_ = result_.lower;
      if (gap > 0 && result_.lower >= duration_) return miss();
      if (seen_.found.upper + seen_.rounding <= settings_.target + near_enough()) return finish(t);
      if (!(result_.lower > t)) break;  // a bracket that rounding keeps wider than the tolerance
      t = result_.lower;
    }
    result_.outcome = CastOutcome::undecided;
    result_.status = result_.iterations >= settings_.cap ? QueryStatus::capped : QueryStatus::rounding;
    result_.time = result_.lower;
    write_points();
  }

 private:
  Real size() const { return (flat(a_) ? 0 : a_.bounding_radius) + (flat(b_) ? 0 : b_.bounding_radius); }

  /// The signed distance at time t. @return false if a support function misbehaved
  bool look(Real t, Real width) {
    seen_.t = t;
    seen_.frame_a = Frame(ma_.after(t));
    seen_.frame_b = Frame(mb_.after(t));
    const Frame b_in_a = relative(seen_.frame_a, seen_.frame_b);
    const Real smaller = std::min(a_.bounding_radius, b_.bounding_radius);
    QuerySettings query;
    query.tolerance = finite(smaller) && smaller > 0 ? width / smaller : Real(1e-12);
    const Vec3 before = memory_.direction;
    memory_.direction = seen_.frame_a.rotate_inverse(before);  // kept in world axes
    distance(a_, b_, b_in_a, query, &memory_, seen_.found, fault_);
    memory_.direction = seen_.frame_a.rotate(memory_.direction);
    ++result_.iterations;
    result_.support_calls += seen_.found.support_calls;
    seen_.normal = seen_.frame_a.rotate(seen_.found.normal);
    seen_.rounding = rounding_at(t);
    return seen_.found.status != QueryStatus::fault || fail();
  }

  /// m, of what is read off poses at time t.
  Real rounding_at(Real t) const {
    const Real turn = (ma_.omega.norm() * arm_a_ + mb_.omega.norm() * arm_b_) * t;
    const Real travel = mb_.velocity.norm() * t + mb_.at.p.norm() + ma_.centre.norm() + mb_.centre.norm();
    return kUnitRoundoff *
           ((kPoseRounding + kTurnRounding) * (travel + size() + arm_a_ + arm_b_) + kTurnRounding * turn);
  }

  /// What the gap along the normal can lose per second, at most, at any later time.
  Real closing_bound() const {
    const Real exact = -seen_.normal.dot(mb_.velocity) + seen_.normal.cross(ma_.omega).norm() * arm_a_ +
                       seen_.normal.cross(mb_.omega).norm() * arm_b_;
    return exact + 16 * kUnitRoundoff * (mb_.velocity.norm() + ma_.omega.norm() * arm_a_ + mb_.omega.norm() * arm_b_);
  }

  /// How long the plane found at time t, of a gap beyond the target, keeps its gap: by the bound on its speed, or by
  /// the gap that it has a little later, and the sag in between.
  ///
  /// Seen from a body that turns by theta, the normal n = n1 + n2 (along and across its axis) sweeps a cone. Between
  /// two instants alpha apart, by sines, n(t) = l n(0) + m n(alpha) - (l + m - 1) n1 with l + m - 1 <= sec(alpha/2) -
  /// 1, and a support function h is sublinear: h(n(t)) <= l h(n(0)) + m h(n(alpha)) + (l + m - 1) h(-n1). So the gap
  /// lies no lower than the chord between its two values by more than 2 r (sec(alpha/2) - 1) a body, which for alpha <=
  /// 1 is less than 0.28 r alpha^2: of second order, where the bound on speed is of first.
  /// @return false if a support function misbehaved
  bool clear_until(Real t, Real gap, Real& until) {
    const Real fastest = closing_bound();
    until = fastest > 0 ? std::min(t + gap / fastest, duration_) : duration_;
    const Real wa = ma_.omega.norm(), wb = mb_.omega.norm();
    const Real bend = 0.28 * (arm_a_ * wa * wa + arm_b_ * wb * wb);  // m/s^2
    if (until >= duration_ || !(bend > 0)) return true;
    Real step = std::min({std::sqrt(gap / (2 * bend)), 1 / std::max(wa, wb), duration_ - t});
    for (int i = 0; i < 2 && t + step > until; ++i) {
      Real later;
      if (!plane_gap(t + step, later)) return false;
      const Real sag = bend * step * step, fall = gap - later;
      if (later > sag) {  // as the gap itself is: clear all along
        until = std::max(until, t + step);
        return true;
      }
      until = std::max(until, std::min(t + step * std::max((gap - sag) / fall, Real(0)), t + step));
      step = std::min(step, 1.25 * step * gap / fall);  // about where the chord meets the target: less sag
    }
    return true;
  }

  /// Gap beyond the target that the plane of the last look has at another time, rounding taken off.
  bool plane_gap(Real t, Real& gap) {
    const auto farthest = [&](Core core, const RigidMotion& m, const Vec3& n, Real& value) {
      const Shape& s = core.shape();
      const Frame frame(m.after(t));
      Vec3 p = s.offset * s.normal;
      const Vec3 d = frame.rotate_inverse(n);
      if (!flat(s) && !core.support(d, p)) return core.blame(d, p, fault_);
      value = n.dot(frame.apply(p)) + s.core_radius;
      return true;
    };
    Real of_a = 0, of_b = 0;
    ++result_.support_calls;
    if (!farthest(Core(a_), ma_, seen_.normal, of_a) || !farthest(Core(b_), mb_, -seen_.normal, of_b)) return fail();
    gap = -of_b - of_a - settings_.target - rounding_at(t) - kBracketRounding * kUnitRoundoff * size();
    return true;
  }

  bool fail() {
    result_.status = QueryStatus::fault;
    result_.outcome = CastOutcome::undecided;
    return false;
  }

  /// What it loses now: the approach of the two nearest points.
  Real closing_speed() const {
    const Vec3 on_a = seen_.frame_a.apply(seen_.found.point_a), on_b = seen_.frame_b.apply(seen_.found.point_b);
    const Vec3 va = ma_.omega.cross(on_a - ma_.centre);
    const Vec3 vb = mb_.velocity + mb_.omega.cross(on_b - mb_.centre - mb_.velocity * seen_.t);
    return seen_.normal.dot(va - vb);
  }

  /// What counts as contact: the tolerance, or rounding where that is more.
  Real near_enough() const {
    return std::max(tolerance_, 4 * (seen_.rounding + kBracketRounding * kUnitRoundoff * size()));
  }

  /// In contact at time t: look for a time by which the target is crossed, else the tolerance is all there is.
  void finish(Real t) {
    const Real left = seen_.found.separation - settings_.target, speed = closing_speed(), contact = near_enough();
    const bool crossed = seen_.found.upper + seen_.rounding <= settings_.target;
    write(CastOutcome::hit, std::min(result_.lower, t), t, t, seen_.found.separation);
    if (crossed) return;
    result_.slack = contact;
    if (contact > tolerance_) result_.status = QueryStatus::rounding;
    if (!(speed > 0) || settings_.target < 0) return;  // of an overlap no depth is proven by a yes or no
    const Real safe = until_;
    Real step = (std::max(left, Real(0)) + 0.5 * contact) / speed;
    if (!(closing_bound() * step <= kGraze * contact))
      return;  // it slides along: where it crosses says nothing of when
    for (int i = 0; i < 4; ++i, step *= 2) {
      const Real later = std::min(t + step, duration_);
      if (!(later > t)) return;
      const Overlap found = overlap_at(later);
      if (found == Overlap::fault) return static_cast<void>(fail());
      if (found == Overlap::overlapping) {
        write(CastOutcome::hit, std::min(safe, later), later,
              std::clamp(t + left / speed, std::min(safe, later), later), settings_.target);
        return;
      }
    }
  }

  /// Is the target crossed at a time? A yes or no is cheaper than the depth of a slight overlap.
  Overlap overlap_at(Real t) {
    const Frame frame_a(ma_.after(t)), frame_b(mb_.after(t));
    const Frame b_in_a = relative(frame_a, frame_b);
    const Real reach = b_in_a.p.norm() + size() + settings_.target;
    const OverlapResult found =
        overlap(a_, b_, b_in_a, settings_.target, reach > 0 ? rounding_at(t) / reach : 0, kProofCap, fault_);
    result_.support_calls += found.support_calls;
    return found.outcome;
  }

  void write(CastOutcome outcome, Real lower, Real upper, Real time, Real separation) {
    result_.outcome = outcome;
    result_.lower = lower;
    result_.upper = upper;
    result_.time = time;
    result_.separation = separation;
    result_.slack = seen_.rounding;
    result_.status = QueryStatus::exact_enough;
    write_points();
  }

  void write_points() {
    const Vec3 from = origin_ + drift_ * seen_.t;
    result_.normal = seen_.normal;
    result_.point_a = from + seen_.frame_a.apply(seen_.found.point_a);
    result_.point_b = from + seen_.frame_b.apply(seen_.found.point_b);
  }

  void miss() {
    result_.outcome = CastOutcome::miss;
    result_.time = result_.lower = duration_;
    result_.upper = kInfinity;
    result_.slack = seen_.rounding;
  }

  const Shape &a_, &b_;
  RigidMotion ma_, mb_;
  Vec3 origin_, drift_;
  Real duration_;
  const CastSettings& settings_;
  CastResult& result_;
  SupportFault& fault_;
  Real arm_a_, arm_b_, tolerance_;  // m
  Real until_ = 0;                  // s: nothing touches before
  /// What a look saw.
  struct Seen {
    Real t = 0, rounding = 0;  // s; m, of the poses
    Frame frame_a, frame_b;
    Vec3 normal = Vec3::unit_x();  // world
    QueryResult found;
  } seen_;
  QueryMemory memory_;
};

}  // namespace

void time_of_impact(const Shape& a, const RigidMotion& motion_a, const Shape& b, const RigidMotion& motion_b,
                    Real duration, const CastSettings& settings, CastResult& result, SupportFault& fault) {
  result = CastResult();
  Advance(a, motion_a, b, motion_b, duration, settings, result, fault).run();
  result.at_start = result.outcome == CastOutcome::overlap || (result.outcome == CastOutcome::hit && result.time == 0);
  if (!settings.ignore_touched || !result.at_start) return;
  result = CastResult();
  result.time = result.lower = duration;
}

}  // namespace carom::collision
