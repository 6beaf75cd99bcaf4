// Conservative advancement: ask for a separating plane, go as far as the motion cannot close its gap, ask again.
#include "collision/cast/time_of_impact.h"

#include <algorithm>
#include <optional>

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

  /// @see collision::is_kept_apart()
  bool is_apart(const Vec3& normal, Vec3& point) {
    seen_.t = 0, seen_.normal = normal;
    Real gap, until;
    if (!plane_gap(0, normal, gap)) return false;
    point = origin_ + (flat(b_) || (!flat(a_) && a_.bounding_radius < b_.bounding_radius) ? reach_a_ : reach_b_);
    return gap > 0 && clear_until(0, gap, until) && until >= duration_;
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
    result_.plane = seen_.normal = seen_.frame_a.rotate(seen_.found.normal);
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

  /// What the gap along a normal can lose per second, at most, at any later time.
  Real closing_bound(const Vec3& n) const {
    const Real exact = -n.dot(mb_.velocity) + n.cross(ma_.omega).norm() * arm_a_ + n.cross(mb_.omega).norm() * arm_b_;
    return exact + 16 * kUnitRoundoff * (mb_.velocity.norm() + ma_.omega.norm() * arm_a_ + mb_.omega.norm() * arm_b_);
  }

  /// Until when a plane that stays as it is keeps its gap, by the bound on its speed.
  Real clear_until_bound(Real t, Real gap, const Vec3& n) const {
    const Real fastest = closing_bound(n);
    return fastest > 0 ? std::min(t + gap / fastest, duration_) : duration_;
  }

  /// A plane stays as it is, or turns along with A or B, as that of a face does.
  enum class Along { none, a, b };

  /// A plane on its way: what it keeps apart at time t, and how far it looks next.
  struct March {
    Along along;
    Real bend;  // m/s^2
    Real t, gap, step;
    Vec3 n;
    int shorter = 0;  // looks in a row that did not find it clear
  };

  /// m/s^2: by how much the gap may lie below the chord between its values at two instants, over the square of the time
  /// between them. With n = n(t), of unit length, and m = -n as B sees it, gap(t) = n.d - g_B(m) - g_A(-m'), d from centre to
  /// centre, g support functions about these: convex, and no steeper than the arms. So the deviation is that of d.n and m
  /// from their chords, an eighth of their second derivatives. Of the body that the plane goes along with g is constant.
  Real bend_of(Along along, Real t) const {
    const Real wa = ma_.omega.norm(), wb = mb_.omega.norm();
    if (along == Along::none) return (arm_a_ * wa * wa + arm_b_ * wb * wb) / 8;
    const Real w = along == Along::a ? wa : wb, arm = along == Along::a ? arm_b_ : arm_a_;
    const auto apart = [&](Real at) { return (mb_.centre + at * mb_.velocity - ma_.centre).norm(); };
    const Real turns = (ma_.omega - mb_.omega).norm() * (wa + wb);
    return (w * w * std::max(apart(t), apart(duration_)) + 2 * w * mb_.velocity.norm() + arm * turns) / 8;
  }

  /// As far as its bend takes half of the gap.
  Real longest_step(const March& m) const {
    const Real left = duration_ - m.t;
    return 2 * m.bend * left * left > m.gap ? std::sqrt(m.gap / (2 * m.bend)) : left;
  }

  /// Just short of where a gap that falls at a speed, and bends, is used up.
  static Real step_to_end(const March& m, Real speed) {
    constexpr Real kShort = 0.98;
    return kShort * 2 * m.gap / (speed + std::sqrt(speed * speed + 4 * m.bend * m.gap));
  }

  /// One look ahead along the way of a plane.   @return false if a support function misbehaved
  bool march(March& m, Real& until) {
    const Vec3 axis = m.along == Along::a ? ma_.omega : m.along == Along::b ? mb_.omega : Vec3::zero();
    const Vec3 turned = m.along == Along::none ? m.n : exp_map(m.step * axis) * m.n;
    const Vec3 n = turned / turned.norm();
    Real later;
    if (!plane_gap(m.t + m.step, n, later)) return false;
    const Real sag = m.bend * m.step * m.step, speed = (m.gap - later) / m.step;
    if (later > sag) {  // as the gap itself is: clear all along
      m.t += m.step, m.gap = later, m.n = n, m.shorter = 0;
      until = std::max(until, std::max(m.t, clear_until_bound(m.t, m.gap, m.n)));
      m.step = std::min(longest_step(m), speed > 0 ? step_to_end(m, speed) : kInfinity);
      return true;
    }
    until = std::max(until, std::min(m.t + std::max(m.gap - sag, Real(0)) / speed, m.t + m.step));
    m.step = std::min(m.step / 2, step_to_end(m, speed)), ++m.shorter;
    return true;
  }

  /// How long the plane found at time t, of a gap beyond the target, keeps its gap: by the bound on its speed, or by
  /// the gap that it has a little later, and the sag in between. The latter is of second order. Which way it goes is tried; the
  /// best one goes on, at a tenth of the cost of a distance query, as long as it comes farther.
  /// @return false if a support function misbehaved
  bool clear_until(Real t, Real gap, Real& until) {
    constexpr int kLooks = 16, kShorter = 2;
    until = clear_until_bound(t, gap, seen_.normal);
    if (ma_.omega == Vec3::zero() && mb_.omega == Vec3::zero()) return true;
    const bool any_flat = flat(a_) || flat(b_);
    const Real enough = 0.25 * tolerance_;
    std::optional<March> best;
    Real best_until = 0;
    for (const Along along : {Along::a, Along::b, Along::none}) {
      if (until >= duration_) return true;
      const Vec3& omega = along == Along::a ? ma_.omega : mb_.omega;
      if (along != Along::none && (any_flat || omega == Vec3::zero())) continue;
      March m{along, bend_of(along, t), t, gap, 0, seen_.normal};
      m.step = longest_step(m);
      Real found = 0;
      if (!march(m, found)) return false;
      until = std::max(until, found);
      if (!best || found > best_until) best = m, best_until = found;
    }
    for (int i = 0; i < kLooks && until < duration_ && best->shorter < kShorter && best->gap > enough; ++i)
      if (!march(*best, until)) return false;
    return true;
  }

  /// Gap beyond the target that a plane has at a time, rounding taken off.   @param n  unit
  bool plane_gap(Real t, const Vec3& normal, Real& gap) {
    const auto farthest = [&](Core core, const RigidMotion& m, const Vec3& n, Real& value, Vec3& reach) {
      const Shape& s = core.shape();
      const Frame frame(m.after(t));
      Vec3 p = s.offset * s.normal;
      const Vec3 d = frame.rotate_inverse(n);
      if (!flat(s) && !core.support(d, p)) return core.blame(d, p, fault_);
      reach = frame.apply(p);
      value = n.dot(reach) + s.core_radius;
      return true;
    };
    Real of_a = 0, of_b = 0;
    ++result_.support_calls;
    if (!farthest(Core(a_), ma_, normal, of_a, reach_a_) || !farthest(Core(b_), mb_, -normal, of_b, reach_b_))
      return fail();
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
    if (!(closing_bound(seen_.normal) * step <= kGraze * contact))
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
  Real arm_a_, arm_b_, tolerance_;                        // m
  Real until_ = 0;                                        // s: nothing touches before
  Vec3 reach_a_ = Vec3::zero(), reach_b_ = Vec3::zero();  // m: of cores, towards the last plane
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

bool is_kept_apart(const Shape& a, const RigidMotion& motion_a, const Shape& b, const RigidMotion& motion_b,
                   Real duration, const CastSettings& settings, const Vec3& normal, Vec3& point) {
  CastResult unused;
  SupportFault fault;
  return Advance(a, motion_a, b, motion_b, duration, settings, unused, fault).is_apart(normal, point);
}

}  // namespace carom::collision
