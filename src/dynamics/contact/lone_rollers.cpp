#include "dynamics/contact/lone_rollers.h"

#include <algorithm>

#include "collision/support.h"
#include "dynamics/body_state.h"
#include "dynamics/ccd/continuous.h"
#include "dynamics/force/force.h"
#include "dynamics/integrate/driven.h"
#include "dynamics/ledger/accounts.h"

namespace carom::dynamics {
namespace {

using collision::Form;
using collision::Shape;

const Shape& shape_of(const World& world, std::uint32_t collider) { return *world.scene.colliders.shape[collider]; }

/// Whether the surface below is flat as far as a step may lead, about a point of it.   @param n  unit, world, out of it
bool is_flat(const World& world, std::uint32_t collider, const Vec3& n, const Vec3& at, Real far) {
  const Shape& shape = shape_of(world, collider);
  if (shape.form == Form::half_space) return true;
  if (shape.form == Form::scenery || shape.core_radius > 0) return false;
  constexpr Real kTilt = 1e-4;  // rad: a face has its far corner there, a round surface the point itself
  const std::uint32_t body = world.scene.colliders.body[collider];
  const Frame frame = Frame(world.state.q[body].matrix(), world.state.x[body]) * world.plan->local[collider];
  const Vec3 t = (std::fabs(n.x()) < 0.7 ? Vec3::unit(0) : Vec3::unit(1)).cross(n),
             along[2] = {t / t.norm(), n.cross(t / t.norm())};
  for (const Vec3& a : along)
    for (const Real sign : {1.0, -1.0}) {
      Vec3 corner;
      collision::SupportFault fault;
      if (!full_support(shape, frame.rotate_inverse(n + sign * kTilt * a), corner, fault)) return false;
      const Vec3 off = frame.apply(corner) - at;
      if (!(sign * off.dot(a) > far) || !(std::fabs(off.dot(n)) < kTilt * off.norm())) return false;
    }
  return true;
}

bool is_centred_ball(const World& world, std::uint32_t collider) {
  return shape_of(world, collider).form == Form::sphere && world.plan->local[collider].p.is_zero();
}

/// Whether the line on which it lies is known all step long as it is: about a core, or about an axis.
bool keeps_its_line(const Shape& shape) { return shape.core_radius > 0 || shape.form == Form::cylinder; }

using Grip = TouchingMotion::Grip;

/// Of what resists turns: whether the body turns about, so that it is at an end.
bool turns_back(const FlatTouch& touch, const Vec3& then_w, const Vec3& now_w) {
  const Vec3 then = then_w - touch.surface_spin, now = now_w - touch.surface_spin;
  const Real spin_then = then.dot(touch.n), spin_now = now.dot(touch.n);
  return (touch.rolling > 0 && !((then - spin_then * touch.n).dot(now - spin_now * touch.n) > 0)) ||
         (touch.spinning > 0 && !(spin_then * spin_now > 0));
}

/// The steps of the method that make up a step.
bool advance(TouchingMotion& motion, TouchingMotion::At& at, Real dt, int steps, Real settled) {
  const auto is_last = [&](int touch) { return motion.touches() == 1 || motion.grip(1 - touch) == Grip::opened; };
  for (int k = 0; k < steps; ++k) {
    const Real h = dt / steps;
    int opened = -1;
    auto outcome = motion.advance(at, h, opened);
    if (outcome == TouchingMotion::Outcome::opens) {
      Real until = h;
      if (is_last(opened) || !motion.advance_to_opening(at, until, opened)) return false;
      motion.grip(opened, Grip::opened);
      outcome = motion.advance(at, h - until, opened);
    }
    if (outcome != TouchingMotion::Outcome::moved || !motion.settle(at, settled)) return false;
  }
  return true;
}

/// What a step asks of a body's touches.
struct Asked {
  Real pull = 0;      // m/s^2, the most along a normal
  Real friction = 1;  // the least of what is held, 1 at most
  bool slides = false, surfaces_rest = true;
};
Asked asked_of(const TouchingBody& of, const TouchingMotion& motion, const TouchingMotion::At& at) {
  Asked to;
  const Vec3 accel = motion.accel(at);
  for (int k = 0; k < of.count; ++k) {
    const FlatTouch& touch = of.touches[k];
    to.pull = std::max(to.pull, std::fabs(accel.dot(touch.n)));
    to.surfaces_rest = to.surfaces_rest && touch.surface_spin.is_zero() && touch.surface_v.is_zero();
    if (motion.grip(k) == Grip::holds)
      to.friction = std::min(to.friction, touch.friction);
    else
      to.slides = true;
  }
  return to;
}

bool gains_energy(const TouchingMotion& motion, const TouchingMotion::At& begun, const TouchingMotion::At& ended) {
  const Real had = motion.energy(begun), work = motion.work();
  return motion.energy(ended) - had - work > kRollGain * (had + std::fabs(work));
}

/// m: how far ends are to be from their surfaces: as they were, or as the solver left them if that is nearer.
/// @return false: it turns back, is through a surface that it came off, or the solver's pose touches elsewhere
bool find_gaps(const World& world, const TouchingBody& of, Real dt, const TouchingMotion& motion,
               const TouchingMotion::At& begun, const TouchingMotion::At& ended, Real gaps[TouchingMotion::kMostEnds]) {
  const State& s = world.state;
  Vec3 r_begun[TouchingMotion::kMostEnds], r_solved[TouchingMotion::kMostEnds];
  if (!motion.ends(begun.q, r_begun)) return false;
  const bool is_solved = motion.ends(s.q[of.body], r_solved);
  if (!is_solved && of.count == 1 && !of.touches[0].is_line()) return false;
  for (int k = 0; k < of.count; ++k) {
    const FlatTouch& touch = of.touches[k];
    if (turns_back(touch, begun.omega, ended.omega)) return false;
    if (motion.grip(k) == Grip::opened) {
      Real gap = 0, before = 0;
      if (!motion.clearance(begun, k, 0, before) || !motion.clearance(ended, k, dt, gap) ||
          !(gap >= std::min(Real(0), before)))
        return false;
      continue;
    }
    for (int i = 2 * k; i < 2 * k + (touch.is_line() ? 2 : 1); ++i) {
      const Real before = motion.gap(begun.x, r_begun[i], k, 0);
      const Real solved = is_solved ? motion.gap(s.x[of.body], r_solved[i], k, dt) : before;
      gaps[i] = std::fabs(before) < std::fabs(solved) ? before : solved;
    }
  }
  return true;
}

/// A body's step, as its touches grip. @return false: it is the solver's
bool roll(const World& world, const TouchingBody& of, Real dt, TouchingMotion& motion, TouchingMotion::At& at) {
  at = {of.x, of.v, of.omega, of.q};
  const Asked asked = asked_of(of, motion, at);
  const Real least_slip = kRollSettle * asked.pull * dt, settled = least_slip * motion.mass();
  if (asked.slides && !motion.note_slips(at, least_slip)) return false;
  if (of.count > 1) motion.open_what_parts(at);
  if (!motion.touches_anything()) return false;
  if (!motion.settle(at, asked.friction * settled) || (asked.slides && !motion.note_slips(at, least_slip)))
    return false;
  Real pace = 0;
  if (!motion.pace(at, dt, pace)) return false;
  const Real wanted = std::ceil(dt / (kRollStep * pace));
  if (!(wanted <= kRollSteps)) return false;
  const TouchingMotion::At begun = at;
  Real gaps[TouchingMotion::kMostEnds] = {};
  return advance(motion, at, dt, std::max(1, static_cast<int>(wanted)), settled) &&
         !(asked.surfaces_rest && gains_energy(motion, begun, at)) &&
         find_gaps(world, of, dt, motion, begun, at, gaps) && motion.correct(at, dt, gaps);
}

/// Whether the solver met it: what came off in the step before is near, and moves away.
bool presses(const World& world, const FlatTouch& touch) {
  for (std::uint32_t i = touch.row; i < touch.row + touch.rows; ++i)
    if (!world.contacts->geometry[i].impulse.is_zero()) return true;
  return false;
}

bool may_hold(const TouchingBody& of) {
  int touching = 0;
  for (int k = 0; k < of.count; ++k) touching += of.touches[k].is_open ? 0 : of.touches[k].friction > 0 ? 1 : 2;
  return touching == 1;
}

/// By one surface it is held, or it slides on it; on two it slides.
bool roll(const World& world, const TouchingBody& of, Real dt, TouchingMotion::At& at, Vec3 impulse[]) {
  for (const Grip grip : {Grip::holds, Grip::slides}) {
    if (grip == Grip::holds && !may_hold(of)) continue;
    TouchingMotion motion(world, of, world.lone_rollers->trial);
    for (int k = 0; k < of.count; ++k)
      motion.grip(k, of.touches[k].is_open || (of.count > 1 && !presses(world, of.touches[k])) ? Grip::opened : grip);
    if (!roll(world, of, dt, motion, at)) continue;
    for (int i = 0; i < TouchingMotion::kMostEnds; ++i) impulse[i] = motion.impulse(i);
    return true;
  }
  return false;
}

/// The collider of a body that impulses move, of a pair with one that they do not.
std::uint32_t collider_of(const World& world, const ContactPair& m) {
  const collision::Pair pair = world.pairs.place(world.contacts->geometry[m.row].pair).pair;
  return m.moves_a ? pair.a : pair.b;
}

/// Whether a body in touch with one that impulses do not move is such that its motion may be done once more.
bool may_roll_alone(const World& world, const ContactPair& m) {
  const Scene& scene = world.scene;
  const std::uint32_t body = m.moves_a ? m.a : m.b, other = m.moves_a ? m.b : m.a;
  if (scene.type[other] == BodyType::dynamic) return false;
  if (scene.locks_of(body) || !rotates(scene, body)) return false;
  const Vec3& spin = world.state.omega[other];  // about the normal, which then stays what it is
  return spin.is_zero() || spin.cross(world.contacts->rows[m.row].n).squared_norm() <= 1e-24 * spin.squared_norm();
}

/// Where a body stands on a surface: at one point, or along a line.
struct Stand {
  std::uint32_t deepest, other_end;
  bool is_point, is_line;
};
Stand stand_of(const Contacts& c, const ContactPair& m) {
  constexpr Real kAside = 0.01;  // of a line's length, that its other points may be beside it
  Stand to{m.row, m.row, false, false};
  for (std::uint32_t i = m.row + 1; i < m.row + m.count; ++i)
    if (c.geometry[i].separation < c.geometry[to.deepest].separation) to.deepest = i;
  const auto offset = [&](std::uint32_t i) {
    return m.moves_a ? c.geometry[i].l_a - c.geometry[to.deepest].l_a : c.geometry[i].l_b - c.geometry[to.deepest].l_b;
  };
  Vec3 line = Vec3::zero();
  Real length = 0;  // m^2
  for (std::uint32_t i = m.row; i < m.row + m.count; ++i) {
    const Vec3 apart = offset(i);
    const Real far = apart.squared_norm(), higher = c.geometry[i].separation - c.geometry[to.deepest].separation;
    if (!(far > 0) || higher * higher > kRollApart * kRollApart * far)
      continue;  // the same point again: @see rolling.h
    if (length > 0 && apart.cross(line).squared_norm() > kAside * kAside * far * length) return to;  // a face
    if (far > length) length = far, line = apart, to.other_end = i;
  }
  to.is_point = !(length > 0), to.is_line = length > 0;
  // Of a line that lies level rounding says which end is deeper; friction along it counts from the same all the time.
  if (to.other_end < to.deepest) std::swap(to.deepest, to.other_end);
  return to;
}

FlatTouch as_begun(const World& world, const ContactPair& m, const Stand& stand) {
  const Contacts& c = *world.contacts;
  const State& s = world.state;
  const Row& row = c.rows[stand.deepest];
  const RowGeometry& g = c.geometry[stand.deepest];
  const collision::Pair pair = world.pairs.place(g.pair).pair;
  const std::uint32_t body = m.moves_a ? m.a : m.b, other = m.moves_a ? m.b : m.a;
  FlatTouch to;
  to.row = m.row, to.rows = m.count, to.deepest = stand.deepest, to.other_end = stand.other_end;
  to.collider = m.moves_a ? pair.a : pair.b, to.surface = m.moves_a ? pair.b : pair.a;
  to.n = m.moves_a ? Vec3(-1 * row.n) : row.n;
  to.on_plane =
      s.x[other] + (m.moves_a ? s.q[other] * g.l_b - g.radius_b * row.n : s.q[other] * g.l_a + g.radius_a * row.n);
  to.along = Vec3::zero();
  if (stand.is_line) {
    const RowGeometry& far = c.geometry[stand.other_end];
    const Vec3 line = s.q[body] * (m.moves_a ? far.l_a - g.l_a : far.l_b - g.l_b), level = line - line.dot(to.n) * to.n;
    to.along = level / level.norm();
  }
  to.friction = row.friction;
  to.is_open = g.separation > kRollApart * shape_of(world, to.collider).bounding_radius;
  const LedBody* const led = led_body(world, other);
  to.surface_x = s.x[other];
  to.surface_v = led ? led->v : s.v[other], to.surface_spin = led ? led->omega : s.omega[other];
  return to;
}

TouchingBody as_begun(const World& world, std::uint32_t body) {
  const State& s = world.state;
  TouchingBody of;
  of.body = body;
  of.x = s.x[body], of.v = s.v[body], of.omega = s.omega[body], of.q = s.q[body];
  of.accel = pull_on(world, body), of.torque = Vec3::zero();
  if (!world.scene.modes.forbids(+EffectId::user_force, body)) of.accel += world.scene.inv_mass[body] * s.force[body];
  if (!world.scene.modes.forbids(+EffectId::user_torque, body)) of.torque = s.torque[body];
  return of;
}

constexpr std::uint8_t kMany = 255;  // touches: of a body that something else binds as well

/// By how many pairs each body is bound.
void count_touches(const World& world, LoneRollers& l) {
  const Contacts& c = *world.contacts;
  l.touches.assign(world.scene.bodies.slots(), 0);
  const auto touch = [&](std::uint32_t body, int times) {
    if (body != kInvalid) l.touches[body] = static_cast<std::uint8_t>(std::min(255, l.touches[body] + times));
  };
  for (const ContactPair& m : c.contact_pairs) touch(m.a, 1), touch(m.b, 1);
  for (const Link& link : c.links) touch(link.a, kMany), touch(link.b, kMany);
  for (const Driven& d : c.driven) touch(c.rows[d.row].a, kMany), touch(c.rows[d.row].b, kMany);
}

/// Whether a pair is of a body that may roll alone and stands on a point or a line.
bool may_be_a_touch(const World& world, const ContactPair& m) {
  if (m.moves_a == m.moves_b || !m.one_normal) return false;
  const Stand stand = stand_of(*world.contacts, m);
  if (!stand.is_point && !stand.is_line) return false;  // most lie on a face
  const std::uint32_t other = m.moves_a ? m.b : m.a;
  return may_roll_alone(world, m) &&
         (world.scene.type[other] == BodyType::kinematic || !is_centred_ball(world, collider_of(world, m)));
}

/// Its bodies, each with all of its touches.
void gather(const World& world, LoneRollers& l) {
  l.place.assign(world.scene.bodies.slots(), kInvalid);
  for (const std::uint32_t pair : l.pairs) {
    const ContactPair& m = world.contacts->contact_pairs[pair];
    const std::uint32_t body = m.moves_a ? m.a : m.b, other = m.moves_a ? m.b : m.a;
    const Stand stand = stand_of(*world.contacts, m);
    if (l.touches[body] > TouchingBody::kMost ||
        (l.touches[body] == 1 && stand.is_line && world.scene.type[other] != BodyType::kinematic &&
         keeps_its_line(shape_of(world, collider_of(world, m)))))
      continue;
    if (l.place[body] == kInvalid) {
      l.place[body] = static_cast<std::uint32_t>(l.bodies.size());
      l.bodies.push_back(as_begun(world, body));
    }
    TouchingBody& of = l.bodies[l.place[body]];
    of.touches[of.count++] = as_begun(world, m, stand);
  }
}

/// Whether a sweep found anything in its way but what it touches anyway.
bool is_hit_elsewhere(const World& world, const TouchingBody& of) {
  const SweptBody* const swept = world.continuous->find(of.body);
  if (!swept || !swept->is_hit) return false;
  return swept->is_hit_elsewhere || std::none_of(of.touches, of.touches + of.count, [&](const FlatTouch& touch) {
           return swept->hit ==
                  collision::Pair{std::min(touch.collider, touch.surface), std::max(touch.collider, touch.surface)};
         });
}

/// Of the whole step, where it touches.
void tell_impulses(const World& world, const TouchingBody& of, const Vec3 impulse[]) {
  Contacts& c = *world.contacts;
  for (int k = 0; k < of.count; ++k) {
    const FlatTouch& touch = of.touches[k];
    for (std::uint32_t i = touch.row; i < touch.row + touch.rows; ++i) c.geometry[i].impulse = Vec3::zero();
    const Real sign = c.rows[touch.deepest].b == of.body ? 1 : -1;
    c.geometry[touch.deepest].impulse += sign * impulse[2 * k];
    if (touch.is_line()) c.geometry[touch.other_end].impulse += sign * impulse[2 * k + 1];
  }
}

}  // namespace

void find_lone_rollers(const World& world, const StepTime& time) {
  if (!world.lone_rollers) return;
  LoneRollers& l = *world.lone_rollers;
  l.bodies.clear();
  l.pairs.clear(), l.place.clear(), l.trial.springs.clear();
  const auto& pairs = world.contacts->contact_pairs;
  for (std::uint32_t i = 0; i < pairs.size(); ++i)
    if (may_be_a_touch(world, pairs[i])) l.pairs.push_back(i);
  if (l.pairs.empty()) return;
  count_touches(world, l);
  gather(world, l);
  if (l.bodies.empty()) return;
  for (const Resistance& r : world.contacts->resisting)
    for (const std::uint32_t body : {world.contacts->rows[r.row].a, world.contacts->rows[r.row].b}) {
      if (body == kInvalid || l.place[body] == kInvalid) continue;
      TouchingBody& of = l.bodies[l.place[body]];
      for (int k = 0; k < of.count; ++k)
        if (of.touches[k].row == r.row) of.touches[k].rolling = r.rolling, of.touches[k].spinning = r.spinning;
    }
  for (TouchingBody& of : l.bodies)
    if (l.touches[of.body] != of.count || !find_varying(world, of.body, l.trial, of.varying)) of.count = 0;
  std::erase_if(l.bodies, [&](const TouchingBody& of) {
    bool touches = false;
    for (int k = 0; k < of.count; ++k) {
      const FlatTouch& touch = of.touches[k];
      const Real size = shape_of(world, touch.collider).bounding_radius + world.plan->local[touch.collider].p.norm();
      touches = touches || !touch.is_open;
      const Vec3 past = of.v - touch.surface_v - touch.surface_spin.cross(of.x - touch.surface_x);
      if ((touch.is_line() && (touch.rolling > 0 || touch.spinning > 0)) ||
          !is_flat(world, touch.surface, touch.n, touch.on_plane, time.dt * (past.norm() + of.omega.norm() * size)))
        return true;
    }
    return !touches;
  });
  std::ranges::fill(l.place, kInvalid);
  for (std::uint32_t i = 0; i < l.bodies.size(); ++i) l.place[l.bodies[i].body] = i;
}

bool ends_alone(const World& world, std::uint32_t body, Real dt, TouchingMotion::At& at) {
  if (!world.lone_rollers || world.lone_rollers->place.empty()) return false;
  const std::uint32_t place = world.lone_rollers->place[body];
  Vec3 impulse[TouchingMotion::kMostEnds];
  return place != kInvalid && roll(world, world.lone_rollers->bodies[place], dt, at, impulse);
}

void roll_alone(const World& world, Poses& poses, Velocities& motion, const StepTime& time) {
  if (!world.lone_rollers) return;
  for (const TouchingBody& of : world.lone_rollers->bodies) {
    if (world.state.held_out[of.body] || is_hit_elsewhere(world, of)) continue;
    TouchingMotion::At at;
    Vec3 impulse[TouchingMotion::kMostEnds];
    if (!roll(world, of, time.dt, at, impulse)) continue;
    poses.x[of.body] = at.x, poses.q[of.body] = at.q;
    motion.v[of.body] = at.v, motion.omega[of.body] = at.omega;
    motion.momentum[of.body] = inertia_at(world.scene, of.body, at.q) * at.omega;
    tell_impulses(world, of, impulse);
  }
}

}  // namespace carom::dynamics
