// Lists of what happened, from what the step left: contact views, sensors' pairs, who sleeps.
#include "dynamics/events/events.h"

#include <algorithm>

#include "collision/narrow/rounding.h"
#include "collision/scenery/ask.h"
#include "dynamics/ccd/continuous.h"
#include "dynamics/contact/contact.h"
#include "dynamics/contact_views.h"
#include "dynamics/joint/wide_joints.h"
#include "dynamics/query/index.h"
#include "dynamics/sleep/sleep.h"

namespace carom::dynamics {
namespace {

Together together(const World& world, const Pair& p) {
  const Scene& s = world.scene;
  const auto body = [&](std::uint32_t slot) { return s.bodies.handle(s.colliders.body[slot]); };
  return {p,         s.collider_slots.handle(p.a), s.collider_slots.handle(p.b), body(p.a),
          body(p.b), s.colliders.is_sensor(p.a)};
}

bool lives(const World& world, const Together& t) {
  const SlotPool& slots = world.scene.collider_slots;
  return slots.check(t.a) == HandleFault::none && slots.check(t.b) == HandleFault::none;
}

bool one_sleeps(const World& world, const Pair& p) {
  const Colliders& c = world.scene.colliders;
  return world.state.sleeps(c.body[p.a]) || world.state.sleeps(c.body[p.b]);
}

ContactEvent event(ContactEvent::Kind kind, const Together& t) {
  return {kind, t.a, t.b, t.body_a, t.body_b, Vec3::zero(), Vec3::zero(), 0, 0};
}

/// A pair's contact views, and the hits that sweeps found.
struct Met {
  Pair pair;
  std::size_t first, last;          // of the views
  std::size_t first_hit, last_hit;  // of the hits
};

/// Contacts of this step (views and swept hits) beside those of the last: lists in the same order.
class Contacting {
 public:
  Contacting(const World& world, Events& e) : world_(world), e_(e), hits_(world.continuous->hits) {}

  void run() {
    const Array<ContactView>& views = world_.contact_views();
    e_.spare.clear();
    std::sort(hits_.begin(), hits_.end(), [](const SweepHit& a, const SweepHit& b) {
      return a.pair == b.pair ? a.order < b.order : a.pair < b.pair;
    });
    std::size_t old = 0;
    for (std::size_t i = 0, j = 0, h = 0, k = 0; i < views.size() || h < hits_.size(); i = j, h = k) {
      const Pair viewed = i < views.size() ? Pair{views[i].collider_a, views[i].collider_b} : kLast;
      const Pair hit = h < hits_.size() ? hits_[h].pair : kLast, pair = std::min(viewed, hit);
      for (j = i; j < views.size() && views[j].collider_a == pair.a && views[j].collider_b == pair.b;) ++j;
      for (k = h; k < hits_.size() && hits_[k].pair == pair;) ++k;
      while (old < e_.touching.size() && e_.touching[old].pair < pair) part(e_.touching[old++]);
      bool known = false;
      if (old < e_.touching.size() && e_.touching[old].pair == pair) {
        known = lives(world_, e_.touching[old]);
        if (!known) part(e_.touching[old]);
        ++old;
      }
      meet({pair, i, j, h, k}, known);
    }
    while (old < e_.touching.size()) part(e_.touching[old++]);
    e_.touching.swap(e_.spare);
  }

 private:
  void meet(const Met& met, bool known) {
    const Array<ContactView>& views = world_.contact_views();
    Real impulse = 0, speed = 0, most = -1;
    Vec3 point = Vec3::zero(), normal = Vec3::zero();
    const auto add = [&](Real p, Real approach, const Vec3& at, const Vec3& n) {
      impulse += p, speed = std::max(speed, approach);
      if (p > most) most = p, point = at, normal = n;
    };
    for (std::size_t k = met.first; k < met.last; ++k)
      add(views[k].normal_impulse, e_.approach[k], views[k].point, views[k].normal);
    for (std::size_t k = met.first_hit; k < met.last_hit; ++k)
      add(hits_[k].impulse, hits_[k].speed, hits_[k].point, hits_[k].normal);
    if (!known && !(impulse > 0)) return;
    const Together t = together(world_, met.pair);
    e_.spare.push_back(t);
    const auto tell = [&](ContactEvent::Kind kind) {
      ContactEvent what = event(kind, t);
      what.point = point, what.normal = normal, what.impulse = impulse, what.speed = speed;
      e_.contacts.push_back(what);
    };
    if (!known) tell(ContactEvent::begin);
    if (impulse > 0 && speed > e_.hit_speed) tell(ContactEvent::hit);
  }

  void part(const Together& t) {
    if (lives(world_, t) && one_sleeps(world_, t.pair))
      e_.spare.push_back(t);
    else
      e_.contacts.push_back(event(ContactEvent::end, t));
  }

  static constexpr Pair kLast{kInvalid, kInvalid};
  const World& world_;
  Events& e_;
  Array<SweepHit>& hits_;
};

/// Whether a sensor's pair overlaps now; within rounding of touching, as before.
bool overlaps(const World& world, const Pair& p, bool before) {
  const Colliders& c = world.scene.colliders;
  if (c.disabled[p.a] | c.disabled[p.b]) return false;
  SupportFault fault;
  constexpr int kCap = 128;
  const OverlapResult r =
      any_shape::overlap(*c.shape[p.a], *c.shape[p.b], relative(collider_frame(world, p.a), collider_frame(world, p.b)),
                         0, kPoseRounding * kUnitRoundoff, kCap, fault);
  return r.outcome == Overlap::overlapping || (before && r.outcome == Overlap::touching);
}

class Sensing {
 public:
  Sensing(const World& world, Events& e) : world_(world), e_(e) {}

  void run() {
    add_passed();
    e_.spare.clear();
    std::size_t old = 0;
    for (const Pair& pair : e_.sensor_pairs) {
      while (old < e_.within.size() && e_.within[old].pair < pair) unasked(e_.within[old++]);
      bool known = false;
      const Together* before = nullptr;
      if (old < e_.within.size() && e_.within[old].pair == pair) {
        before = &e_.within[old++];
        known = lives(world_, *before);
        if (!known) tell(false, *before);
      }
      const bool now = overlaps(world_, pair, known);
      if (now) e_.spare.push_back(together(world_, pair));
      if (now && !known) tell(true, e_.spare.back());
      if (!now && known) tell(false, *before);
      if (!now && !known && passed(pair)) tell(true, together(world_, pair)), tell(false, together(world_, pair));
    }
    while (old < e_.within.size()) unasked(e_.within[old++]);
    e_.within.swap(e_.spare);
  }

 private:
  /// What is swept goes beyond the bounds that it had as the step began.
  void add_passed() {
    Array<Pair>& passed = world_.continuous->passed;
    if (passed.empty()) return;
    std::sort(passed.begin(), passed.end());
    passed.erase(std::unique(passed.begin(), passed.end()), passed.end());
    const std::size_t bounds_met = e_.sensor_pairs.size();
    for (const Pair& pair : passed)
      if (!std::binary_search(e_.sensor_pairs.begin(),
                              e_.sensor_pairs.begin() + static_cast<std::ptrdiff_t>(bounds_met), pair))
        e_.sensor_pairs.push_back(pair);
    std::sort(e_.sensor_pairs.begin(), e_.sensor_pairs.end());
  }
  bool passed(const Pair& pair) const {
    const Array<Pair>& passed = world_.continuous->passed;
    return std::binary_search(passed.begin(), passed.end(), pair);
  }
  /// Bounds do not meet; or one sleeps, and no host asked.
  void unasked(const Together& t) {
    if (lives(world_, t) && one_sleeps(world_, t.pair) && is_sensor(t.pair) && overlaps(world_, t.pair, true))
      e_.spare.push_back(t);
    else
      tell(false, t);
  }
  bool is_sensor(const Pair& p) const {
    const Colliders& c = world_.scene.colliders;
    return c.is_sensor(p.a) != c.is_sensor(p.b);
  }
  void tell(bool entered, const Together& t) {
    e_.sensors.push_back(t.a_senses ? SensorEvent{entered, t.a, t.b, t.body_a, t.body_b}
                                    : SensorEvent{entered, t.b, t.a, t.body_b, t.body_a});
  }

  const World& world_;
  Events& e_;
};

void look_who_sleeps(const World& world, Events& e) {
  for (std::uint32_t i = 0; i < world.scene.bodies.slots(); ++i) {
    const auto now = static_cast<std::uint8_t>(world.state.sleeps(i));
    if (e.slept[i] == now) continue;
    e.slept[i] = now;
    e.sleep.push_back({now == 0, world.scene.bodies.handle(i)});
  }
}

void tell_faults(const World& world, Events& e) {
  const auto named = [](const SlotPool& slots, std::uint32_t slot) {
    return slot == kInvalid ? Handle(0) : slots.handle(slot);
  };
  for (const FaultView& view : world.fault_views) {
    FaultEvent& what = e.faults.emplace_back();
    what.support = view.support;
    what.shape = view.support.shape ? view.support.shape->handle : 0;
    what.support.shape = nullptr;  // which may be gone before the host asks
    what.body = named(world.scene.bodies, view.body);
    what.particles = named(world.particles.slots, view.particles);
    what.particle = view.particle;
    what.step = world.report.steps;
  }
}

}  // namespace

void sensing::find(const Scene& scene, const State&, Participants& participants) {
  const Array<std::uint8_t>& sensor = scene.colliders.sensor;
  for (std::uint32_t slot = 0; slot < sensor.size(); ++slot)
    if (sensor[slot] && scene.collider_slots.alive(slot)) participants.add(slot);
}

void collect(World& world, std::uint32_t asked, Real hit_speed) {
  Events& e = *world.events;
  e.hit_speed = hit_speed;
  const std::uint32_t kinds = world.scene.modes.forbids(+EffectId::events) ? 0 : asked;
  const std::uint32_t gone = e.wanted & ~kinds;
  if (gone & Events::contact) e.touching.clear(), e.contacts.clear();
  if (gone & Events::sensor) e.within.clear(), e.sensors.clear();
  if (gone & Events::sleeping) e.sleep.clear();
  if (gone & Events::joint) e.joints.clear();
  if (gone & Events::fault) e.faults.clear();
  if (kinds & ~e.wanted & Events::sleeping) {
    e.slept.assign(world.scene.bodies.slots(), 0);
    for (std::uint32_t i = 0; i < e.slept.size(); ++i) e.slept[i] = static_cast<std::uint8_t>(world.state.sleeps(i));
  }
  e.asked = asked, e.wanted = kinds;
}

void tell_broken(const World& world, Events& e, std::uint32_t slot) {
  if (!(e.wanted & Events::joint)) return;
  const Joint& joint = world.joints.joint[slot];
  const auto body = [&](std::uint32_t b) { return b == kInvalid ? Handle(0) : world.scene.bodies.handle(b); };
  e.joints.push_back({world.joints.slots.handle(slot), body(joint.def.body_a), body(joint.def.body_b), joint.force,
                      joint.torque, world.report.steps + 1});
}

void set_sensors_aside(const World& world, Events& e, Array<Pair>& pairs) {
  if (world.plan->effects[+EffectId::sensor].participants.count == 0) return;
  const Colliders& c = world.scene.colliders;
  const bool asked = e.wanted & Events::sensor;
  for (const Pair& p : pairs)
    if (asked && c.is_sensor(p.a) != c.is_sensor(p.b)) e.sensor_pairs.push_back(p);
  std::erase_if(pairs, [&](const Pair& p) { return c.is_sensor(p.a) || c.is_sensor(p.b); });
}

void begin_events(const World& world, Events& e, const StepTime&) {
  PlannedEffect& row = world.plan->effects[+EffectId::events];
  row.wanted = e.asked != 0;
  count_participants(world, EffectId::events, e.wanted != 0);
  if (e.wanted == 0) return;
  ++row.evaluations;
  if ((e.wanted & Events::sensor) && !world.plan->runs[static_cast<std::size_t>(Stage::broad)]) {
    // All sleep; what a host moved among them has been asked for all the same.
    const Colliders& c = world.scene.colliders;
    for (const Pair& p : world.sleep->near)
      if (c.is_sensor(p.a) != c.is_sensor(p.b)) e.sensor_pairs.push_back(p);
  }
  const std::size_t passed = world.continuous->passed.capacity();
  e.sensor_pairs.reserve(e.sensor_pairs.size() + passed);
  const bool met = world.plan->runs[static_cast<std::size_t>(Stage::solve)];
  const std::size_t contact_pairs = (e.wanted & Events::contact) && met ? world.contacts->contact_pairs.size() : 0;
  const std::size_t pairs = contact_pairs + (e.wanted & Events::contact ? world.continuous->hits.capacity() : 0);
  e.spare.reserve(std::max(pairs + e.touching.size(), e.sensor_pairs.size() + passed + e.within.size()));
  e.touching.reserve(e.spare.capacity()), e.within.reserve(e.spare.capacity());  // they change places
  e.contacts.reserve(2 * pairs + e.touching.size());
  e.sensors.reserve(2 * (e.sensor_pairs.size() + passed) + e.within.size());
  if (e.wanted & Events::sleeping) {
    e.slept.resize(world.scene.bodies.slots(), 0);
    e.sleep.reserve(world.scene.bodies.slots());
  }
  if (e.wanted & Events::joint) e.joints.reserve(world.wide_joints->active.size());
  if (e.wanted & Events::fault) e.faults.reserve(world.fault_views.capacity());
  if (contact_pairs == 0) return;
  const Contacts& c = *world.contacts;
  e.approach.resize(c.rows.size());
  in_parallel(world.jobs, c.rows.size(), kRowsAPart, [&](std::uint32_t i) {
    const Arms arms(world, c.rows[i], c.geometry[i]);
    e.approach[i] = -relative_velocity(world.state, c.rows[i], arms.a, arms.b).dot(c.rows[i].n);
  });
}

void end_events(const World& world, Events& e, const StepTime&) {
  const std::uint32_t wanted = e.wanted;
  if (wanted & Events::contact) Contacting(world, e).run();
  if (wanted & Events::sensor) Sensing(world, e).run();
  if (wanted & Events::sleeping) look_who_sleeps(world, e);
  if (wanted & Events::fault) tell_faults(world, e);
}

}  // namespace carom::dynamics
