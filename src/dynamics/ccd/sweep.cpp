// The events of a substep: every body's first contact, the earliest solved, those whom it concerns asked again.
#include <algorithm>

#include "collision/volume.h"
#include "dynamics/ccd/sweeper.h"
#include "dynamics/detect.h"
#include "dynamics/filter.h"
#include "dynamics/force/force.h"
#include "dynamics/integrate/integrator.h"
#include "dynamics/integrate/rotation/rotation.h"
#include "dynamics/joint/wide_joints.h"
#include "dynamics/quarantine.h"
#include "dynamics/sleep/sleep.h"
#include "dynamics/solver/direct.h"
#include "dynamics/solver/far_turns.h"
#include "dynamics/solver/wide_contacts.h"

namespace carom::dynamics {
namespace {

/// Of lengths that enter a box: far from the origin places are rounded.
constexpr Real kBoxRounding = 64 * kUnitRoundoff;

/// Contacts read places off lanes and rows that were measured before; what rests is taken to rest on.
void tell_contacts(const World& world) {
  if (world.contacts->rows.empty()) return;
  refresh_rotations(world);
  refresh_separations(world);
  if (!world.wide->manifolds.empty()) measure_lanes(world), measure_far_turns(world, *world.wide);
  for (GroupRest& rest : world.direct->rest) rest.lasts = false;
}

}  // namespace

Sweeper::Sweeper(const World& world, Sweeping to, const StepTime& time)
    : world_(world),
      poses_(to),
      motion_(to),
      sleep_(to),
      broad_(to),
      report_(to),
      c_(*world.continuous),
      time_(time),
      lag_(world.plan->integrator->lag * time.h),
      tolerance_(world.scene.dials[Dial::position_tolerance]),
      filtered_(any_held_apart(world)),
      listens_(senses_sweeps(world)) {}

void Sweeper::run() {
  lay_paths();
  box_participants();
  for (std::size_t k = 0; k < c_.bodies.size(); ++k)
    if (c_.bodies[k].swept) look_ahead(c_.bodies[k], 0);
  while (SweptBody* const b = next()) {
    if (b->met_version == version_of(world_.scene.colliders.body[b->other]))
      strike(*b);
    else
      look_ahead(*b, b->when);  // nothing met it until then
  }
  for (std::size_t k = 0; listens_ && k < c_.bodies.size(); ++k) sense(c_.bodies[k], time_.h);
  move_bodies();
}

bool Sweeper::moved_by_hits(std::uint32_t body) const { return responds(world_.scene, world_.state, body); }
bool Sweeper::turns_by_own_method(std::uint32_t body) const {
  if (const SweptBody* const known = c_.find(body); known && known->is_joined()) return false;
  return turns_by_method(*world_.plan, body) && rotates(world_.scene, body);
}

void Sweeper::lay_paths() {
  for (SweptBody& b : c_.bodies) lay_path(b);
}

/// From where the substep began to where it led.
void Sweeper::lay_path(SweptBody& b) {
  const State& s = world_.state;
  const std::uint32_t i = b.body;
  ++b.version;
  b.path.stay();
  b.when = kInfinity;
  if (s.held_out[i]) return;
  b.flies = world_.scene.type[i] == BodyType::dynamic && !world_.plan->touched[i];
  b.path.u = (s.x[i] - b.path.x) / time_.h;
  if (s.q[i] != b.path.q) b.path.w = rotation_vector(s.q[i] * b.path.q.conjugate(), time_.h * s.omega[i]) / time_.h;
}

/// Participants are in each other's way; a hit may lead them anywhere as far as they were to go.
void Sweeper::box_participants() {
  for (std::uint32_t k = 0; k < c_.participants; ++k) {
    SweptBody& b = c_.bodies[k];
    b.loose = false;
    c_.boxes[k] = b.path.swept(0, time_.h, b.radius);
  }
  c_.loose.clear();
  for (std::uint32_t k = static_cast<std::uint32_t>(c_.participants); k < c_.bodies.size(); ++k) {
    c_.bodies[k].loose = c_.bodies[k].swept;
    if (c_.bodies[k].loose) c_.loose.push_back(k);
  }
  c_.build_tree();
}

/// m, world: what a collider sweeps on its body's path until the end. Between two poses less than a radian apart its
/// points leave their chords by no more than an eighth of the angle squared of their arm.
Aabb Sweeper::swept_box(const SweptBody& b, std::uint32_t collider, Real now) {
  const Real turn = b.path.w.norm() * (time_.h - now);
  const Aabb ball = b.path.swept(now, time_.h, b.radius);
  if (!(turn < 1)) return ball;
  const Colliders& table = world_.scene.colliders;
  const Shape& shape = *table.shape[collider];
  const SweptPart whole{&shape, {table.local[collider].q, table.local[collider].p - world_.scene.center[b.body]}};
  SupportFault fault;
  const Frame from = b.path.frame(whole, now), to = b.path.frame(whole, time_.h);
  const Aabb first = world_bounds(shape, from.r, from.p, fault), last = world_bounds(shape, to.r, to.p, fault);
  if (fault.kind != SupportFault::none) return ball;
  const Vec3 sag = Vec3::constant(turn * turn / 8 * b.radius + kBoxRounding * (from.p.norm() + b.radius));
  return {first.lo.min(last.lo) - sag, first.hi.max(last.hi) + sag};
}

/// Colliders that may be in a collider's way, each once, ascending.
void Sweeper::gather(const SweptBody& b, const Aabb& box, Real now) {
  const Colliders& table = world_.scene.colliders;
  c_.found.clear();
  broad_phase(world_, broad_).find_near(table, box, c_.found);
  Sleep& z = sleep_;
  if (z.tree.size() > 0) z.tree.query(box, [&](std::uint32_t slot) { c_.found.push_back(slot); });
  // Bounds were made as the step began, for as far as contacts reach: whoever is swept is elsewhere.
  std::erase_if(c_.found, [&](std::uint32_t slot) {
    const SweptBody* const other = c_.find(table.body[slot]);
    return other && (other->swept || other->loose);
  });
  const auto add = [&](std::uint32_t k) {
    const SweptBody& other = c_.bodies[k];
    if (&other == &b || !other.path.swept(now, time_.h, other.radius).overlaps(box)) return;
    for (std::uint32_t slot = world_.scene.first_collider[other.body]; slot != kInvalid; slot = table.next[slot])
      if (swept_box(other, slot, now).overlaps(box)) c_.found.push_back(slot);
  };
  c_.tree.query(box, [&](std::uint32_t k) {
    if (!c_.bodies[k].loose) add(k);
  });
  for (const std::uint32_t k : c_.loose) add(k);
  std::sort(c_.found.begin(), c_.found.end());
}

/// The first contact of a body from now on.
void Sweeper::look_ahead(SweptBody& b, Real now) {
  b.when = kInfinity;
  const Colliders& table = world_.scene.colliders;
  for (std::uint32_t own = world_.scene.first_collider[b.body]; own != kInvalid; own = table.next[own]) {
    if (table.disabled[own] || table.is_sensor(own) || is_scenery(*table.shape[own])) continue;
    gather(b, swept_box(b, own, now), now);
    for (const std::uint32_t other : c_.found) try_pair(b, now, own, other);
  }
}

void Sweeper::try_pair(SweptBody& b, Real now, std::uint32_t own, std::uint32_t other) {
  const Colliders& table = world_.scene.colliders;
  const std::uint32_t body = table.body[other];
  if (!may_touch(table, own, other) || table.is_sensor(other) || (filtered_ && !lets_touch(world_.scene, own, other)))
    return;
  const EffectModes& modes = world_.scene.modes;
  if (modes.forbids(+EffectId::response, b.body) || modes.forbids(+EffectId::response, body)) return;
  if (!moved_by_hits(b.body) && !moved_by_hits(body)) return;
  const SweptBody* const known = c_.find(body);
  if (!may_meet(b, body)) return;
  // Of hits by what a host moves, the other has to keep watch: its path is the one that changes.
  if (!moved_by_hits(b.body) && known && known->swept) return;
  Side a{b.body, own, {}, b.path, &b}, o{body, other, {}, path_of(body), known};
  const Aabb box = a.path.swept(now, time_.h, b.radius);
  each_swept_part(world_, own, table.bounds[other], [&](const SweptPart& mine) {
    each_swept_part(world_, other, box, [&](const SweptPart& its) {
      a.part = mine, o.part = its;
      const FirstContact m = meet(a, o, now, std::min(b.when, time_.h));
      if (!(m.when < b.when)) return;
      b.when = m.when, b.own = own, b.other = other, b.met_version = version_of(body);
      b.own_part = mine, b.other_part = its;
      b.normal = m.normal, b.point = m.point;
    });
  });
}

/// Who meets something next: the earliest, of equals the lowest pair of slots. Null: no body.
SweptBody* Sweeper::next() {
  SweptBody* first = nullptr;
  const auto pair = [](const SweptBody& b) { return Pair{std::min(b.own, b.other), std::max(b.own, b.other)}; };
  for (SweptBody& b : c_.bodies) {
    if (!(b.when <= time_.h)) continue;
    if (!first || b.when < first->when || (b.when == first->when && pair(b) < pair(*first))) first = &b;
  }
  return first;
}

/// Where a body is that has no path yet: it comes from where its velocity tells. Sleepers lie.
Path Sweeper::path_of(std::uint32_t body) const {
  if (const SweptBody* const known = c_.find(body)) return known->path;
  const State& s = world_.state;
  if (world_.scene.type[body] == BodyType::fixed || s.held_out[body] || s.sleeps(body) || has_its_turn_later(body))
    return {0, s.x[body], s.q[body], Vec3::zero(), Vec3::zero()};
  Path p = path_to(s, body, time_.h);
  p.u = s.v[body], p.w = s.omega[body];
  return p;
}

/// Whether a body that could be hit has its substeps in another part of the step.
bool Sweeper::has_its_turn_later(std::uint32_t body) const {
  const Plan& plan = *world_.plan;
  return plan.in_pass && !c_.find(body) && moved_by_hits(body) && !world_.state.sleeps(body) &&
         !plan.linear.has(body) && !plan.rotating.has(body);
}

std::uint32_t Sweeper::version_of(std::uint32_t body) const {
  const SweptBody* const known = c_.find(body);
  return known ? known->version : 0;
}

/// Who was hit ends where its path leads; all others end where they were going.
void Sweeper::move_bodies() {
  bool any = false;
  for (const SweptBody& b : c_.bodies) {
    if (!b.changed) continue;
    any = true;
    const Vec3 x = b.path.place(time_.h);
    const Quat q = b.path.orientation(time_.h);
    const Real n2 = q.squared_norm();
    if (!sane_position(x) || !(n2 > 0.5 && n2 < 2))
      continue;  // numbers overflowed on the way: it stays where it was going
    poses_.x[b.body] = x;
    if (!rotates(world_.scene, b.body)) continue;
    poses_.q[b.body] = q;
    world_.plan->rotation[b.body] = poses_.q[b.body].matrix();
  }
  if (any) tell_contacts(world_);
}

bool is_led_by_sweep(const World& world, std::uint32_t body) {
  const SweptBody* const known = world.continuous->find(body);
  return known && known->changed;
}

bool any_led_by_sweep(const World& world) { return std::ranges::any_of(world.continuous->bodies, &SweptBody::changed); }

void sweep(const World& world, Sweeping to, const StepTime& time) {
  if (world.continuous->waits) return;
  find_sped_up(world, to, time);
  if (!world.continuous->bodies.empty()) Sweeper(world, to, time).run();
}

}  // namespace carom::dynamics
