// Springs as forces: F = -(k (l - l0) + c dl/dt) along the line between two points. A function of state, so that an
// integrator of higher order may evaluate it as often as it likes; joints of kind distance are the ones that solve for
// it.
//
// A substep h carries a spring of angular frequency w only for w h below 2. All springs that hang on a body pull it
// together, so that no mode of them is faster than
//   w^2 <= (sum of k on a) K_a + (sum of k on b) K_b,      K = 1/m + |r|^2 tr(I^-1), what a newton at the anchor moves
// (Gershgorin). Where w h would exceed 1, or damping likewise, the spring is as stiff as makes it 1 in this step, and
// is counted in `softened`.
#include <algorithm>

#include "dynamics/effects.h"
#include "dynamics/force/force.h"
#include "dynamics/sleep/sleep.h"

namespace carom::dynamics {
namespace {

/// One end of a spring.
struct End {
  Vec3 x = Vec3::zero(), v = Vec3::zero();  // m, m/s, world, of the anchor
  Vec3 arm = Vec3::zero();                  // m, world axes, from the centre of mass
  bool moves = false;                       // forces move it
};

End end_of(const Scene& scene, const State& s, const Motion& at, std::uint32_t body, const Vec3& anchor) {
  if (body == kInvalid) return {anchor, Vec3::zero(), Vec3::zero(), false};
  End e;
  e.moves = responds(scene, s, body);
  const bool held = s.held_out[body] != 0;
  const Vec3* const x = e.moves ? at.x : s.x.data();
  const Quat* const q = e.moves && rotates(scene, body) ? at.q : s.q.data();
  const Vec3* const v = e.moves ? at.v : s.v.data();
  const Vec3* const omega = e.moves && rotates(scene, body) ? at.omega : s.omega.data();
  e.arm = q[body] * (anchor - scene.center[body]);
  e.x = x[body] + e.arm;
  if (!held) e.v = v[body] + omega[body].cross(e.arm);
  return e;
}

/// N, along the unit vector from A's anchor to B's: above 0 it pulls them together.
struct Pull {
  Vec3 along;
  Real size;
};
Pull pull_of(const SpringDef& def, Real stiffness, Real damping, const End& a, const End& b) {
  const Vec3 d = b.x - a.x;
  const Real length = d.norm();
  if (!(length > 0)) return {Vec3::unit_y(), 0};  // no direction
  const Vec3 n = d / length;
  const Real size = stiffness * (length - def.rest) + damping * n.dot(b.v - a.v);
  return {n, def.only_pulls && (length < def.rest || size < 0) ? 0 : size};
}

bool acts(const World& world, const SpringDef& def) {
  const auto disabled = [&](std::uint32_t body) { return body != kInvalid && world.state.is_disabled(body); };
  if (disabled(def.body_a) || disabled(def.body_b)) return false;
  const auto awake = [&](std::uint32_t body) {
    return body != kInvalid && responds(world.scene, world.state, body) && !world.state.sleeps(body);
  };
  const auto forbids = [&](std::uint32_t body) {
    return body != kInvalid && world.scene.modes.forbids(+EffectId::springs, body);
  };
  return (awake(def.body_a) || awake(def.body_b)) && !forbids(def.body_a) && !forbids(def.body_b) &&
         !world.scene.modes.forbids(+EffectId::springs);
}

/// m/(N s^2): what a newton at the anchor accelerates it by, at most.
Real mobility(const Scene& scene, const State& state, std::uint32_t body, const Vec3& anchor) {
  if (body == kInvalid || !responds(scene, state, body)) return 0;
  const Real arm2 = rotates(scene, body) ? (anchor - scene.center[body]).squared_norm() : 0;
  return scene.inv_mass[body] + arm2 * scene.inv_inertia[body].trace();
}

bool is_moved(const World& world, std::uint32_t body) {
  if (body == kInvalid || world.scene.type[body] == BodyType::fixed) return false;
  if (world.scene.type[body] == BodyType::dynamic) return !world.state.sleeps(body);
  return world.state.v[body] != Vec3::zero() || world.state.omega[body] != Vec3::zero();
}

}  // namespace

void springs::find(const Scene&, const State&, Participants&) {}  // by plan_springs(): they are springs, not bodies

void plan_springs(const World& world) {
  const Springs& all = world.scene.springs;
  PlannedEffect& row = world.plan->effects[+EffectId::springs];
  row.participants.clear();
  row.wanted = all.slots.alive_count();
  all.each([&](std::uint32_t k, const SpringDef& def) {
    if (acts(world, def)) row.participants.add(k);
  });
}

void carry_springs(const World& world, SpringLoads& to, Real h) {
  const Springs& all = world.scene.springs;
  const Scene& scene = world.scene;
  const PlannedEffect& row = world.plan->effects[+EffectId::springs];
  to.softened = 0;
  if (row.participants.count == 0) return;
  row.participants.each(
      [&](std::uint32_t k) { all.def[k].each_end([&](std::uint32_t body, const Vec3&) { to.load[body] = {}; }); });
  row.participants.each([&](std::uint32_t k) {
    all.def[k].each_end([&](std::uint32_t body, const Vec3&) {
      to.load[body].stiffness += all.def[k].stiffness;
      to.load[body].damping += all.def[k].damping;
    });
  });
  row.participants.each([&](std::uint32_t k) {
    const SpringDef& def = all.def[k];
    Real stiff = 0, damp = 0;  // 1/s^2, 1/s
    def.each_end([&](std::uint32_t body, const Vec3& anchor) {
      const Real most = mobility(scene, world.state, body, anchor);
      stiff += most * all.load[body].stiffness, damp += most * all.load[body].damping;
    });
    const Real of_stiffness = stiff * h * h > 1 ? 1 / (stiff * h * h) : 1,
               of_damping = damp * h > 1 ? 1 / (damp * h) : 1;
    to.stiffness[k] = of_stiffness * def.stiffness, to.damping[k] = of_damping * def.damping;
    to.softened += of_stiffness < 1 || of_damping < 1;
  });
}

void wake_sprung(const World& world, Sleepers to) {
  const Springs& all = world.scene.springs;
  if (all.slots.alive_count() == 0 || world.sleep->count == 0) return;
  all.each([&](std::uint32_t, const SpringDef& def) {
    if (def.body_a != kInvalid && is_moved(world, def.body_b)) wake(world, to, def.body_a);
    if (def.body_b != kInvalid && is_moved(world, def.body_a)) wake(world, to, def.body_b);
  });
}

void springs::force(const Scene& scene, const State& state, const Participants& participants, const Motion& at,
                    const Accelerate& out) {
  const Springs& all = scene.springs;
  participants.each([&](std::uint32_t k) {
    const SpringDef& def = all.def[k];
    const End a = end_of(scene, state, at, def.body_a, def.anchor_a);
    const End b = end_of(scene, state, at, def.body_b, def.anchor_b);
    const Pull pull = pull_of(def, all.stiffness[k], all.damping[k], a, b);
    if (pull.size == 0) return;
    const Vec3 f = pull.size * pull.along;  // N, on A
    const auto push = [&](std::uint32_t i, const End& e, const Vec3& force) {
      if (!e.moves) return;
      out.v[i] += out.scale * scene.inv_mass[i] * force;
      if (rotates(scene, i)) out.omega[i] += out.scale * angular_acceleration(scene, i, at.q[i], e.arm.cross(force));
    };
    push(def.body_a, a, f);
    push(def.body_b, b, -f);
  });
}

SpringReading read_spring(const World& world, std::uint32_t slot) {
  const State& s = world.state;
  const SpringDef& def = world.scene.springs.def[slot];
  const Motion at{s.x.data(), s.q.data(), s.v.data(), s.omega.data()};
  const End a = end_of(world.scene, s, at, def.body_a, def.anchor_a);
  const End b = end_of(world.scene, s, at, def.body_b, def.anchor_b);
  return {(b.x - a.x).norm(), pull_of(def, def.stiffness, def.damping, a, b).size};
}

}  // namespace carom::dynamics
