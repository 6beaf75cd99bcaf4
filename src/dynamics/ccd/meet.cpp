// When two that move first meet, and whether that is a hit or a touch.
#include <algorithm>

#include "dynamics/ccd/sweeper.h"
#include "dynamics/contact/seams.h"
#include "dynamics/detect.h"
#include "dynamics/filter.h"
#include "dynamics/integrate/rotation/rotation.h"

namespace carom::dynamics {
namespace {

// Width of the bracket of a time of impact, as length, relative to the smaller of the two: rounding begins a hundred
// times below.
constexpr Real kTolerance = 1e-9;
// Likewise where two that touch may sink on, of what they may: to that they are asked whether they do.
constexpr Real kDepthTolerance = 0.01;
constexpr int kMeetCap = 256;  // distance queries; a rod takes some ten for each quarter turn
// Of the thickness of the thinner, that two may sink without a hit.
constexpr Real kMostSlack = 0.05, kLeastSlack = 1e-5;

}  // namespace

/// m: what two that touch and come less far than half of it can't pass through.
Real Sweeper::thinner(const Side& a, const Side& b) const {
  return std::min(thickness(*a.part.shape), thickness(*b.part.shape));
}

/// m: how deep two may sink in a substep without a hit.
Real Sweeper::slack(const Side& a, const Side& b) const {
  const Real thin = thinner(a, b);
  return std::clamp(tolerance_, kLeastSlack * thin, kMostSlack * thin);
}

/// What is stored is the velocity of the moment `lag` after the substep began; a solver's holds all along. Where a
/// rotation method carries a body, it is asked back from the end of the path.
Sweeper::Velocity Sweeper::velocity(const Side& side, Real moment, Real now) {
  const State& s = world_.state;
  Velocity u{s.v[side.body], s.omega[side.body]};
  if (!side.known) return u;
  if (side.known->flies) u.v -= (lag_ - moment) * side.known->accel;
  if (turns_by_own_method(side.body)) u.omega = turned(side, time_.h, now - time_.h, s.omega[side.body]);
  return u;
}

/// omega after (or before) some time of free rotation from an orientation of the path, which the rotation method
/// carries: as the body sees it, in the orientation that the path has then. Of a thin rod the method's own orientation
/// differs from that of the path by enough to take a spin about its axis for one of its ends, or the other way round.
Vec3 Sweeper::turned(const Side& side, Real from, Real by, const Vec3& omega) {
  if (by == 0) return omega;
  const std::uint32_t i = side.body;
  Quat& q = poses_.q[i];
  Vec3 &spin = motion_.omega[i], &momentum = motion_.momentum[i];
  const Quat kept_q = q;
  const Vec3 kept_omega = spin, kept_momentum = momentum;
  q = side.path.orientation(from), spin = omega;
  c_.one.runs[0] = {i, i + 1};
  world_.plan->rotation_method->advance(world_, motion_, c_.one, by);
  const Vec3 seen = world_.plan->predicted.q[i].conjugate() * spin;
  q = kept_q, spin = kept_omega, momentum = kept_momentum;
  return side.path.orientation(from + by) * seen;
}

/// Whether they would sink by no more than the slack, whichever of velocity and path is asked: the solver's business.
bool Sweeper::is_slow(const Side& a, const Side& b, const FirstContact& m) {
  const Vec3 arm_a = m.point - a.path.place(m.when), arm_b = m.point - b.path.place(m.when);
  const Velocity stored_a = velocity(a, m.when, m.when), stored_b = velocity(b, m.when, m.when);
  const Velocity path_a{a.path.u, a.path.w}, path_b{b.path.u, b.path.w};
  const Real closing = m.normal.dot(stored_a.at(arm_a) - stored_b.at(arm_b));
  const Real nearing = m.normal.dot(path_a.at(arm_a) - path_b.at(arm_b));
  const Real most = slack(a, b);
  return closing * time_.h <= most && nearing * (time_.h - m.when) <= most;
}

/// Whether a body meets a collider where it already lies on another one of the same ground, which goes on flush there:
/// @see contact/seams.h. Of scenery, on another of its triangles.
bool Sweeper::is_at_seam(const Side& a, const Side& b, const FirstContact& m) {
  const std::uint32_t ground = ground_of(world_, b.collider);
  if (ground == kNoGround) return false;
  const Colliders& table = world_.scene.colliders;
  const Frame frame_a = a.path.frame(a.part, m.when), frame_b = b.path.frame(b.part, m.when);
  const SeamTerms terms = seam_terms(world_.scene.dials, *a.part.shape, *b.part.shape);
  QuerySettings query = narrow_settings(world_.scene.dials).query;
  query.max_distance += slack(a, b);
  const GroundTouch touch{-m.normal, m.point};
  bool is_level = false, is_covered = false;
  for (const std::uint32_t other : c_.found) {
    const std::uint32_t body = table.body[other];
    if ((other == b.collider && !is_scenery(*b.part.shape)) || body == a.body || table.is_sensor(other) ||
        ground_of(world_, other) != ground || !may_touch(table, a.collider, other) ||
        (filtered_ && !lets_touch(world_.scene, a.collider, other)) ||
        world_.scene.modes.forbids(+EffectId::response, body) ||
        !moves_alike(world_, b.collider, other, m.point, terms.flush, time_.dt))
      continue;
    const Path path = path_of(body);
    each_swept_part(world_, other, table.bounds[other], [&](const SweptPart& part) {
      const Frame frame = path.frame(part, m.when);
      QueryResult found;
      SupportFault fault;
      any_shape::distance(*a.part.shape, *part.shape, relative(frame_a, frame), query, nullptr, found, fault);
      if (fault.kind != SupportFault::none || found.farther || !(found.separation <= query.max_distance)) return;
      const GroundTouch plane{-frame_a.rotate(found.normal), frame.apply(found.point_b)};
      const Beside beside = compare({*b.part.shape, frame_b}, touch, plane, terms);
      is_covered = is_covered || beside == Beside::ghost || covers({*part.shape, frame}, touch, terms);
      is_level |= beside != Beside::real;
    });
    if (is_level && is_covered) return true;
  }
  return false;
}

/// Whether the plane that was last found between two keeps them from meeting, or, where they touch and are slow, from sinking
/// by more than the slack.
bool Sweeper::is_parted(const Side& a, const Side& b, Real from, Real to) {
  const Vec3 normal = is_scenery(*b.part.shape) ? Vec3::zero() : c_.planes.find(a.collider, b.collider);
  if (normal == Vec3::zero()) return false;
  const RigidMotion motion_a = a.path.motion(a.part, from), motion_b = b.path.motion(b.part, from);
  CastSettings settings;
  Vec3 point;
  const auto by_more_than = [&](Real target) {
    settings.target = target;
    return is_kept_apart(*a.part.shape, motion_a, *b.part.shape, motion_b, to - from, settings, normal, point);
  };
  return by_more_than(0) || (by_more_than(-slack(a, b)) && is_slow(a, b, {from, normal, point}));
}

/// Whether at a time they are no deeper in each other than they may be.   @param allowed  m
bool Sweeper::ends_above(const Side& a, const Side& b, Real time, Real allowed) {
  const Frame frame_a = a.path.frame(a.part, time), frame_b = b.path.frame(b.part, time);
  QuerySettings query;
  query.tolerance =
      kDepthTolerance * slack(a, b) / std::min(a.part.shape->bounding_radius, b.part.shape->bounding_radius);
  QueryResult found;
  SupportFault fault;
  any_shape::distance(*a.part.shape, *b.part.shape, relative(frame_a, frame_b), query, nullptr, found, fault);
  return fault.kind == SupportFault::none && found.lower > allowed;
}

Sweeper::FirstContact Sweeper::meet(const Side& a, const Side& b, Real from, Real to) {
  // What comes no nearer than two may sink is the solver's, wherever it is.
  const auto arm = [](const Side& s) { return s.part.local.p.norm() + s.part.shape->bounding_radius; };
  const Real a_turns = a.path.w == Vec3::zero() ? 0 : a.path.w.norm() * arm(a),
             b_turns = b.path.w == Vec3::zero() ? 0 : b.path.w.norm() * arm(b);
  const Real speed = (a.path.u - b.path.u).norm() + a_turns + b_turns;  // m/s, at most
  if (speed * (to - from) <= kDeeper * slack(a, b)) return {};
  if (is_parted(a, b, from, to)) return {};
  CastSettings settings;
  settings.tolerance = kTolerance;
  settings.cap = kMeetCap;
  CastResult r;
  Real start = from, allowed = 0;
  const auto look = [&]() -> FirstContact {
    SupportFault fault;
    settings.target = allowed;
    any_shape::time_of_impact(*a.part.shape, a.path.motion(a.part, start), *b.part.shape, b.path.motion(b.part, start),
                              to - start, settings, r, fault);
    if (fault.kind != SupportFault::none && c_.fault.kind == SupportFault::none) c_.fault = fault;
    if (r.plane != Vec3::zero()) c_.planes.keep(a.collider, b.collider, r.plane);
    if (r.outcome == CastOutcome::miss || r.status == QueryStatus::fault || r.normal == Vec3::zero()) return {};
    // What could not be decided is as good as touching: nothing touches before.
    return {start + r.time, r.normal, (r.point_a + r.point_b) / 2};
  };
  const FirstContact first = look();
  if (!(first.when <= to) || !(is_slow(a, b, first) || is_at_seam(a, b, first))) return first;
  // They touch, or a neighbour bears the body there, and are left to that; but not to sink.
  const Real most = slack(a, b), depth = r.outcome == CastOutcome::overlap ? std::min(r.separation, Real(0)) : 0;
  allowed = std::min(-most, depth - kDeeper * most);
  start = first.when;
  const bool is_convex = !is_scenery(*b.part.shape);  // a distance to all triangles costs more than the sweep
  if (is_convex && speed * (to - start) < thinner(a, b) / 2 && ends_above(a, b, to, allowed)) return {};
  const Real smaller = std::min(a.part.shape->bounding_radius, b.part.shape->bounding_radius);  // m
  settings.tolerance = std::max(kTolerance, kDepthTolerance * most / smaller);
  const FirstContact second = look();
  return r.outcome == CastOutcome::overlap ? FirstContact{} : second;
}

}  // namespace carom::dynamics
