// Who is swept in a step: whom a host asked for, and who outruns its contacts. Who stands in their way.
#include <algorithm>
#include <bit>
#include <utility>

#include "dynamics/ccd/continuous.h"
#include "dynamics/contact/contact.h"
#include "dynamics/detect.h"
#include "dynamics/filter.h"
#include "dynamics/force/force.h"
#include "dynamics/integrate/driven.h"
#include "dynamics/joint/wide_joints.h"
#include "dynamics/sleep/sleep.h"

namespace carom::dynamics {
namespace {

// Contacts turn with a body, but not about it: by a quarter of a radian they have come an eighth of their arm astray
// along the normal's plane, and what they know is no longer where the body is.
constexpr Real kSpin = 0.25;  // rad a step

// Reserved for bodies that are hit in a step, and for what events tell of. Beyond it hits are solved all the same: a
// body that is hit then is not swept itself, and events do not tell of it.
constexpr std::size_t kHit = 64, kHitEach = 4, kHitsEach = 16, kPassedEach = 64;

bool can_sweep(const World& world, std::uint32_t body) {
  return world.scene.type[body] != BodyType::fixed && !world.state.held_out[body] && !world.state.sleeps(body);
}

/// Whether a body moves farther in a step than any of its contacts reaches ahead, or turns its ends by more than its
/// thickness and more than contacts can follow.
bool is_fast(const World& world, std::uint32_t body, Real dt) {
  const Colliders& c = world.scene.colliders;
  const State& s = world.state;
  // What is let go falls within the step: things of a millimetre by more than their size.
  const Real falls = world.scene.type[body] == BodyType::dynamic ? dt * dt * world.scene.gravity.norm() : 0;
  const Real way = dt * s.v[body].norm() + falls, turn = dt * s.omega[body].norm();
  Real reach = 0;
  bool spins = false;
  for (std::uint32_t slot = world.scene.first_collider[body]; slot != kInvalid; slot = c.next[slot]) {
    if (c.disabled[slot] || c.is_sensor(slot)) continue;
    const Shape& shape = *c.shape[slot];
    reach = std::max(reach, shape.bounding_radius);
    const Real arm = world.plan->local[slot].p.norm() + std::max(shape.bounding_radius - shape.core_radius, Real(0));
    const Real thickness = (shape.bounds.hi - shape.bounds.lo).min_entry();
    spins |= turn > kSpin && turn * arm > thickness;
  }
  return reach > 0 && (way > reach || spins);
}

/// Whether some collider of a body is so, of those that contacts are for and that are no scenery.   @param is  (collider)
template <class Is>
bool any_convex(const World& world, std::uint32_t body, const Is& is) {
  const Colliders& c = world.scene.colliders;
  for (std::uint32_t slot = world.scene.first_collider[body]; slot != kInvalid; slot = c.next[slot])
    if (!c.disabled[slot] && !c.is_sensor(slot) && !is_scenery(*c.shape[slot]) && is(slot)) return true;
  return false;
}

/// Whether an end that touches first may send the other one through something: the way of a step is more than its thickness,
/// and no small share of its size. What is as thick as it is long outruns its contacts first.
bool may_tip_over(const World& world, std::uint32_t body, Real dt) {
  const Real way = dt * world.state.v[body].norm();
  return any_convex(world, body, [&](std::uint32_t slot) {
    const Shape& shape = *world.scene.colliders.shape[slot];
    return std::max(thickness(shape), shape.bounding_radius / 4) < way;
  });
}

/// Whether what a host moves comes far for its thinnest collider: what lies still in its way may be on either side of
/// that after a step.
bool sweeps_others(const World& world, std::uint32_t body, Real dt) {
  if (world.scene.type[body] != BodyType::kinematic) return false;
  return any_convex(world, body, [&](std::uint32_t slot) { return comes_far(world, slot, dt); });
}

bool may_be_swept(const World& world, std::uint32_t body) {
  return world.scene.def[body].continuous != SweepMode::never &&
         !world.scene.modes.forbids(+EffectId::continuous, body) && can_sweep(world, body);
}

/// Whether a body moves by a quarter of its size in a step, or by more: what moves by less has no need to be looked at.
bool may_outrun(const World& world, std::uint32_t body, Real dt) {
  const State& s = world.state;
  const Real r = radius_of_body(world, body);
  return 32 * dt * dt * (s.v[body].squared_norm() + r * r * s.omega[body].squared_norm()) > r * r;
}

/// For what the substeps of a step may do.   @param known  bodies whose paths are
void reserve_sweeps(const World& world, std::size_t known, std::size_t participants) {
  Continuous& c = *world.continuous;
  const std::size_t most = known + kHit + kHitEach * participants;
  c.most_bodies = std::max(known, std::min<std::size_t>(world.scene.bodies.slots(), most));
  c.most_hits = kHitsEach * (participants + 1);
  c.index.resize(world.scene.bodies.slots(), kInvalid);
  c.bodies.reserve(c.most_bodies), c.loose.reserve(c.most_bodies), c.found.reserve(2 * world.scene.colliders.slots());
  c.planes.clear(known);
  c.hits.reserve(c.most_hits);
  if (senses_sweeps(world)) c.passed.reserve(kPassedEach * participants);
  c.one.clear(), c.one.add(0);
}

void clear(Continuous& c) {
  for (const SweptBody& b : c.bodies) c.index[b.body] = kInvalid;
  c.bodies.clear(), c.loose.clear(), c.hits.clear(), c.passed.clear();
  c.participants = 0;
  c.fault = {};
}

/// Everybody that may be a participant, once, ascending.
void list_candidates(const World& world) {
  Continuous& c = *world.continuous;
  const PlannedEffect& row = world.plan->effects[+EffectId::continuous];
  if (std::exchange(c.too_many_seen, false)) {
    // There was no capacity to note them, and there is to be: this happens once, or where more come than ever before.
    const Colliders& table = world.scene.colliders;
    c.seen.clear();
    c.seen.reserve(world.plan->colliders.size());
    for (const std::uint32_t slot : world.plan->colliders)
      if (table.movable[slot]) c.seen.push_back(table.body[slot]);
  }
  c.seen.reserve(c.seen.size() + row.candidates.count);
  row.candidates.each([&](std::uint32_t i) { c.seen.push_back(i); });
  std::sort(c.seen.begin(), c.seen.end());
  c.seen.erase(std::unique(c.seen.begin(), c.seen.end()), c.seen.end());
}

/// m, world: where a body goes if nothing stops it, with what forces may add in a step.
Aabb straight_way(const World& world, std::uint32_t body, Real radius, Real dt) {
  const State& s = world.state;
  const Path path{0, s.x[body], s.q[body], s.v[body], s.omega[body]};
  const LedBody* const led = led_body(world, body);
  const Real gained = dt * (world.scene.gravity.norm() + (led ? led->a.norm() : 0));
  return path.swept(0, dt, radius + dt * gained);
}

/// Bodies that a participant may come to within the step, whichever way hits turn it.
void find_near(const World& world, BroadPhases& broad, Real dt) {
  Continuous& c = *world.continuous;
  const Colliders& table = world.scene.colliders;
  c.near.clear(), c.found.clear();
  for (std::size_t k = 0; k < c.participants; ++k) {
    const SweptBody& b = c.bodies[k];
    const Real reach = b.radius + dt * (world.state.v[b.body].norm() + dt * world.scene.gravity.norm());
    const Vec3 &x = world.state.x[b.body], all = Vec3::constant(reach);
    broad_phase(world, broad).find_near(table, {x - all, x + all}, c.found);
  }
  for (const std::uint32_t slot : c.found)
    if (table.movable[slot]) c.near.push_back(table.body[slot]);
}

/// Who lies still needs no rotation method, but may be hit and does then: the method carries all that are known.
void carry_all_known(const World& world) {
  Plan& plan = *world.plan;
  if (!plan.rotation_method) return;
  Continuous& c = *world.continuous;
  PlannedEffect& row = plan.effects[+EffectId::gyroscopic];
  c.found.clear(), c.more.clear(), c.merged.clear();
  for (const SweptBody& b : c.bodies)
    if (!plan.turns_by_method[b.body] && row.candidates.has(b.body)) c.found.push_back(b.body);
  if (c.found.empty()) return;
  std::sort(c.found.begin(), c.found.end());
  for (const std::uint32_t i : c.found) c.more.add(i);
  each_of_both(row.participants, c.more, [&](std::uint32_t i) { c.merged.add(i); });
  std::swap(row.participants, c.merged);
  for (const std::uint32_t i : c.found) plan.turns_by_method[i] = 1;
}

}  // namespace

Continuous::Continuous(Memory* m)
    : seen(m),
      index(m),
      bodies(m),
      tree(m),
      boxes(m),
      loose(m),
      hits(m),
      passed(m),
      planes(m),
      near(m),
      found(m),
      one(m),
      more(m),
      merged(m) {}

void PartingPlanes::clear(std::size_t bodies) {
  constexpr std::size_t kOfEach = 8;
  planes_.assign(std::bit_ceil(kOfEach * bodies), {{kInvalid, kInvalid}, Vec3::zero()});
}

std::size_t PartingPlanes::place(const Pair& pair) const {
  return (pair.a * 0x9E3779B1u ^ pair.b * 0x85EBCA77u) >> 7 & (planes_.size() - 1);
}

Vec3 PartingPlanes::find(std::uint32_t a, std::uint32_t b) const {
  const Pair pair{std::min(a, b), std::max(a, b)};
  const Plane& known = planes_[place(pair)];
  if (!(known.pair == pair)) return Vec3::zero();
  return a < b ? known.normal : -known.normal;
}

void PartingPlanes::keep(std::uint32_t a, std::uint32_t b, const Vec3& normal) {
  const Pair pair{std::min(a, b), std::max(a, b)};
  planes_[place(pair)] = {pair, a < b ? normal : -normal};
}

SweptBody& know(const World& world, std::uint32_t body) {
  Continuous& c = *world.continuous;
  SweptBody& b = c.bodies.emplace_back();
  b.body = body;
  b.radius = radius_of_body(world, body);
  c.index[body] = static_cast<std::uint32_t>(c.bodies.size() - 1);
  return b;
}

void continuous::find(const Scene& scene, const State& state, Participants& participants) {
  if (scene.dials.choice(Dial::continuous) == kSweepNone) return;
  for (std::uint32_t i = 0; i < scene.bodies.slots(); ++i)
    if (scene.bodies.alive(i) && scene.def[i].continuous == SweepMode::always && scene.type[i] != BodyType::fixed &&
        !state.held_out[i])
      participants.add(i);
}

bool comes_far(const World& world, std::uint32_t collider, Real dt) {
  const Shape& shape = *world.scene.colliders.shape[collider];
  const std::uint32_t body = world.scene.colliders.body[collider];
  const Real arm = shape.bounding_radius + world.plan->local[collider].p.norm();
  const Real way = dt * (world.state.v[body].norm() + arm * world.state.omega[body].norm());
  return 4 * way > (shape.bounds.hi - shape.bounds.lo).min_entry();
}

void find_swept(const World& world, Colliders& table, Real dt) {
  Continuous& c = *world.continuous;
  PlannedEffect& row = world.plan->effects[+EffectId::continuous];
  clear(c);
  row.participants.clear();
  if (c.seen.empty() && !c.too_many_seen && row.candidates.count == 0) return;
  list_candidates(world);
  for (const std::uint32_t i : c.seen) {
    const SweepMode mode = world.scene.def[i].continuous;
    const EffectModes& modes = world.scene.modes;
    if (modes.forbids(+EffectId::continuous, i)) continue;
    const bool is_watched = world.plan->watches_speed && mode != SweepMode::never;
    const bool outruns = is_watched && is_fast(world, i, dt);
    const bool is_swept = is_watched && (outruns || may_tip_over(world, i, dt) || sweeps_others(world, i, dt));
    const bool is_asked = mode == SweepMode::always || modes.forces(+EffectId::continuous, i);
    if (!can_sweep(world, i) || !(is_swept || is_asked)) continue;
    c.index.resize(world.scene.bodies.slots(), kInvalid);
    SweptBody& b = know(world, i);
    b.swept = true, b.outruns = outruns;
    row.participants.add(i);
  }
  c.seen.clear();
  c.participants = c.bodies.size();
  for (const SweptBody& b : c.bodies) {
    if (!b.outruns) continue;  // it is met by contacts as well, as far as they reach
    for (std::uint32_t slot = world.scene.first_collider[b.body]; slot != kInvalid; slot = table.next[slot])
      table.reach[slot] = 0;
  }
}

Aabb swept_bounds(const World& world, std::uint32_t collider, Real dt) {
  const Colliders& table = world.scene.colliders;
  Aabb box = table.bounds[collider];
  const SweptBody* const b = world.continuous->find(table.body[collider]);
  if (!b || !b->swept) return box;
  const Aabb way = straight_way(world, b->body, b->radius, dt);
  return {box.lo.min(way.lo), box.hi.max(way.hi)};
}

bool sweeps_into(const World& world, std::uint32_t collider, std::uint32_t sleeper, Real dt) {
  const Colliders& table = world.scene.colliders;
  const SweptBody* const b = world.continuous->find(table.body[collider]);
  if (!b || !b->swept) return false;
  const State& s = world.state;
  const std::uint32_t other = table.body[sleeper];
  const Path way{0, s.x[b->body], s.q[b->body], s.v[b->body], s.omega[b->body]};
  const Path rest{0, s.x[other], s.q[other], Vec3::zero(), Vec3::zero()};
  CastSettings settings;
  settings.target = world.scene.dials[Dial::contact_distance];
  const Aabb box = swept_bounds(world, collider, dt), own = table.bounds[sleeper];
  bool meets = false;
  each_swept_part(world, collider, own, [&](const SweptPart& mine) {
    each_swept_part(world, sleeper, box, [&](const SweptPart& its) {
      CastResult result;
      SupportFault fault;
      if (meets) return;
      any_shape::time_of_impact(*mine.shape, way.motion(mine, 0), *its.shape, rest.motion(its, 0), dt, settings, result,
                                fault);
      meets = result.outcome != CastOutcome::miss;
    });
  });
  return meets;
}

void leave_to_sweep(const World& world, BroadPhases& broad, PairTable& pairs, const StepTime& time) {
  Continuous& c = *world.continuous;
  if (c.bodies.empty()) return;
  const Colliders& table = world.scene.colliders;
  const State& s = world.state;
  const Real reach = world.scene.dials[Dial::contact_distance], tolerance = world.scene.dials[Dial::position_tolerance];
  const auto closes_fast = [&](const Pair& pair, const PairRecord& r) {
    const std::uint32_t a = table.body[pair.a], b = table.body[pair.b];
    bool fast = false;
    for (int k = 0; k < r.manifold.count; ++k) {
      const ContactPoint& p = r.manifold.point[k];
      if (!(p.separation > -tolerance)) return false;
      const Vec3 arm_a = table.frame[pair.a].apply(p.on_a) - s.x[a];
      const Vec3 arm_b = table.frame[pair.b].apply(p.on_b) - s.x[b];
      const Vec3 u = s.v[b] + s.omega[b].cross(arm_b) - s.v[a] - s.omega[a].cross(arm_a);
      fast |= -u.dot(p.normal) * time.dt > std::max(p.separation, reach);
    }
    return fast;
  };
  const auto look_at = [&](std::uint32_t own, std::uint32_t other) {
    const Pair pair{std::min(own, other), std::max(own, other)};
    std::size_t lo = 0, hi = pairs.size();
    while (lo < hi) {
      const std::size_t mid = (lo + hi) / 2;
      if (pairs.place(mid).pair < pair)
        lo = mid + 1;
      else
        hi = mid;
    }
    for (; lo < pairs.size() && pairs.place(lo).pair == pair; ++lo) {
      PairRecord& r = pairs[lo];
      if (pairs.place(lo).points == 0 || !closes_fast(pair, r)) continue;
      r.manifold.count = 0;
      r.patch.firm = false;
      pairs.place(lo).points = 0;
      pairs.place(lo).horizon = -kInfinity;
    }
  };
  for (std::size_t k = 0; k < c.participants; ++k) {
    if (!c.bodies[k].outruns) continue;
    for (std::uint32_t slot = world.scene.first_collider[c.bodies[k].body]; slot != kInvalid; slot = table.next[slot]) {
      c.found.clear();
      broad_phase(world, broad).find_near(table, table.bounds[slot], c.found);
      for (const std::uint32_t other : c.found) look_at(slot, other);
    }
  }
}

void begin_sweeps(const World& world, BroadPhases& broad, StepReport& report, const StepTime& time) {
  Continuous& c = *world.continuous;
  if (c.bodies.empty()) return;
  const Colliders& table = world.scene.colliders;
  c.found.reserve(2 * table.slots());
  for (std::size_t k = 0; k < c.participants; ++k) {
    c.found.clear();
    broad_phase(world, broad)
        .find_near(table, straight_way(world, c.bodies[k].body, c.bodies[k].radius, time.dt), c.found);
    std::sort(c.found.begin(), c.found.end());  // the order in which it finds them is of the past
    const bool is_driven = world.scene.type[c.bodies[k].body] == BodyType::kinematic;
    for (const std::uint32_t slot : c.found) {
      const std::uint32_t body = table.body[slot];
      if (!table.movable[slot] || !can_sweep(world, body)) continue;
      SweptBody* known = c.find(body);
      if (!known) known = &know(world, body);
      known->swept |= is_driven && world.scene.type[body] == BodyType::dynamic;  // it looks out for what comes
    }
  }
  reserve_sweeps(world, c.bodies.size(), c.participants);
  c.boxes.resize(c.participants), c.tree.grow(c.participants);
  for (std::uint32_t k = 0; k < c.participants; ++k)
    c.boxes[k] = straight_way(world, c.bodies[k].body, c.bodies[k].radius, time.dt);
  c.build_tree();
  carry_all_known(world);
  world.plan->effects[+EffectId::continuous].evaluations += c.participants;
  report.swept_bodies = c.participants;
  if (world.accuracy) find_near(world, broad, time.dt);
}

void find_sped_up(const World& world, StepReport& report, const StepTime& time) {
  if (!world.plan->watches_speed || world.contacts->rows.empty()) return;
  Continuous& c = *world.continuous;
  const auto is_one = [&](std::uint32_t i) {
    if (!may_outrun(world, i, time.dt) || !may_be_swept(world, i)) return false;
    const SweptBody* const known = c.find(i);
    return !(known && known->swept) && (is_fast(world, i, time.dt) || may_tip_over(world, i, time.dt));
  };
  try {
    c.found.clear();
    const auto look_at = [&](std::uint32_t i) {
      if (is_one(i)) c.found.push_back(i);
    };
    world.plan->linear.each(look_at), world.plan->rotating.each(look_at);
    if (c.found.empty()) return;
    world.plan->begun.resize(world.scene.bodies.slots());
    const auto swept = static_cast<std::size_t>(std::ranges::count_if(c.bodies, &SweptBody::swept));
    reserve_sweeps(world, c.bodies.size() + c.found.size(), swept + c.found.size());
  } catch (const std::bad_alloc&) {
    return;  // contacts have to do
  }
  for (const std::uint32_t i : c.found) {
    SweptBody* known = c.find(i);
    if (!known) known = &know(world, i), known->path = path_to(world.state, i, time.h);
    known->swept = true;
  }
  world.plan->effects[+EffectId::continuous].evaluations += c.found.size();
  report.swept_bodies += c.found.size();
}

void begin_paths(const World& world) {
  const State& s = world.state;
  for (SweptBody& b : world.continuous->bodies) {
    b.path.t = 0, b.path.x = s.x[b.body], b.path.q = s.q[b.body];
    b.changed = false, b.hits = 0, b.sensed = 0;
    b.next_as_one = b.carrier = kInvalid;
  }
}

void save_accelerations(const World& world, const StepTime& time) {
  if (world.continuous->waits) return;
  for (SweptBody& b : world.continuous->bodies)
    b.accel = (world.state.v[b.body] - world.plan->begun[b.body].v) / time.h;
}

void end_sweeps(const World& world, Revisions& scene, FaultViews& views, const StepTime&) {
  const SupportFault& fault = world.continuous->fault;
  if (fault.kind != SupportFault::none) disable(world, scene, views, fault);
}

}  // namespace carom::dynamics
