// What was hit too often in a substep goes on as one with what it hits next.
#include "dynamics/body_state.h"
#include "dynamics/ccd/sweeper.h"
#include "dynamics/force/force.h"

namespace carom::dynamics {

/// Whether a hit changes its velocity now: nothing carries it.
bool Sweeper::is_movable(std::uint32_t body) const {
  if (!moved_by_hits(body)) return false;
  const SweptBody* const known = c_.find(body);
  return !known || !known->is_held();
}

bool Sweeper::is_one_with(SweptBody& b, const SweptBody& other) {
  bool found = false;
  each_as_one(b, [&](const SweptBody& one) { found |= &one == &other; });
  return found;
}

/// Whether two may hit each other: one of them has to give way. What something carries may be taken up by something
/// else that impulses do not move; but what is pressed between two such things is crushed.
bool Sweeper::may_meet(SweptBody& b, std::uint32_t other) {
  SweptBody* const known = c_.find(other);
  if (b.is_joined() && known && is_one_with(b, *known)) return false;
  const bool gives = is_movable(b.body), other_gives = is_movable(other) && !has_its_turn_later(other);
  if (gives || other_gives) return true;
  const auto changes = [](const SweptBody& held, std::uint32_t to) {
    return held.is_held() && held.carrier != to && held.hits < 2 * SweptBody::kMostHits;
  };
  if (moved_by_hits(b.body) && !moved_by_hits(other)) return changes(b, other);
  return !moved_by_hits(b.body) && known && changes(*known, b.body);
}

/// Together they weigh, and at this moment they move, as one body with their momentum.
Sweeper::Whole Sweeper::whole_of(SweptBody& b, Real now) {
  Whole to;
  Vec3 push = Vec3::zero(), at = Vec3::zero(), turn = Vec3::zero();
  each_as_one(b, [&](const SweptBody& one) {
    const Real mass = world_.scene.mass[one.body];
    to.mass += mass, at += mass * one.path.place(now), push += mass * motion_.v[one.body];
  });
  to.centre = at / to.mass, to.v = push / to.mass;
  each_as_one(b, [&](const SweptBody& one) {
    const Mat3 r = one.path.orientation(now).matrix(), own = r * world_.scene.inertia[one.body] * r.transpose();
    const Real mass = world_.scene.mass[one.body];
    const Vec3 arm = one.path.place(now) - to.centre;
    const Mat3 cross = cross_matrix(arm);
    to.inertia += own - mass * (cross * cross);
    turn += own * motion_.omega[one.body] + mass * arm.cross(motion_.v[one.body] - to.v);
  });
  to.omega = to.inertia.inverse() * turn;
  return to;
}

/// From now on they move so.
void Sweeper::lay_whole(SweptBody& b, const Whole& whole, Real now) {
  const Real rest = time_.h - now;
  const Mat3 turn = exp_map(rest * whole.omega).matrix();
  each_as_one(b, [&](SweptBody& one) {
    one.path.go_on_from(now);
    const Vec3 arm = one.path.x - whole.centre;
    motion_.v[one.body] = whole.v + whole.omega.cross(arm), motion_.omega[one.body] = whole.omega;
    one.path.u = whole.v, one.path.w = whole.omega;
    if (rest > 0) one.path.u += (turn * arm - arm) / rest;
    one.changed = true, one.flies = false;
  });
}

/// Locks would not bear the velocities of one body.
bool Sweeper::can_join(std::uint32_t body) const {
  return is_movable(body) && !world_.scene.locks_of(body) && rotates(world_.scene, body);
}

/// If either was hit too often, they are one from the hit on; with what impulses do not move, by being held to that.
void Sweeper::join(std::uint32_t other, SweptBody& b, SweptBody* partner, Real now) {
  const bool moves = moved_by_hits(b.body), other_moves = moved_by_hits(other);
  if (!moves || !other_moves) {
    SweptBody* const hit = moves ? &b : partner;
    if (hit && hit->is_spent()) hold(*hit, moves ? other : b.body, now);
    return;
  }
  if (!is_movable(b.body) || !is_movable(other)) {
    SweptBody* const loose = is_movable(b.body) ? &b : partner;
    const SweptBody* const held = loose == &b ? partner : &b;
    if (loose && loose->is_spent()) hold(*loose, held->carrier == held->body ? loose->body : held->carrier, now);
    return;
  }
  if (!b.may_join() && !(partner && partner->may_join())) return;
  if (!partner || !can_join(b.body) || !can_join(other)) {
    for (SweptBody* const p : {&b, partner})
      if (p && p->is_spent()) hold(*p, p->body, now);
    return;
  }
  for (SweptBody* const p : {&b, partner})
    if (!p->is_joined()) {
      // What a rotation method carries has its spin of the moment.
      const Side side{p->body, 0, {}, p->path, p};
      motion_.omega[p->body] = velocity(side, now, now).omega;
      p->next_as_one = static_cast<std::uint32_t>(p - c_.bodies.data());
    }
  std::swap(b.next_as_one, partner->next_as_one);
  const Whole whole = whole_of(b, now);
  lay_whole(b, whole, now);
}

/// It goes on with a body that impulses do not move; with itself: it stays where it is. So do those that are one with
/// it. Forces do not speed it up.
void Sweeper::hold(SweptBody& b, std::uint32_t carrier, Real now) {
  const Path path = path_of(carrier);
  const Real rest = time_.h - now;
  const bool stays = carrier == b.body;
  std::uint32_t next = kInvalid;
  for (SweptBody* one = &b;; one = &c_.bodies[next]) {
    if (!one->is_held() && !one->is_joined()) {
      const Side side{one->body, 0, {}, one->path, one};
      const Velocity u = velocity(side, now, now);
      motion_.v[one->body] = u.v, motion_.omega[one->body] = u.omega;
    }
    next = one->next_as_one;
    one->next_as_one = kInvalid, one->carrier = stays ? one->body : carrier;
    one->path.go_on_from(now), one->path.stay(), one->changed = true, one->flies = false;
    if (!stays) {
      const Vec3 arm = one->path.x - path.place(now);
      one->path.u = path.u, one->path.w = path.w;
      if (rest > 0 && path.w != Vec3::zero()) one->path.u += (exp_map(rest * path.w) * arm - arm) / rest;
      const Locks locks = world_.scene.locks_of(one->body);
      one->path.u = free_axes(locks).times(one->path.u), one->path.w = free_turns(locks).times(one->path.w);
    }
    if (one != &b) {
      go_on(*one);
      if (one->swept) look_ahead(*one, now);
    }
    if (next == kInvalid || &c_.bodies[next] == &b) return;
  }
}

}  // namespace carom::dynamics
