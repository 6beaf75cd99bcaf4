// Bodies that do not move along, or turn about, some world axes.
#include <bit>

#include "dynamics/force/force.h"
#include "dynamics/integrate/integrator.h"

namespace carom::dynamics {
namespace {

bool holds_turns(const Scene& scene, std::uint32_t body, Locks locks) {
  return (locks & kAngularLocks) && rotates(scene, body);
}

/// What of a rotation is free: P = E (E^T I E)^-1 E^T I. The free part is taken as it is, so that what turns freely
/// does not round.
Vec3 project_turn(const Vec3& omega, const Mat3& inertia, const Mat3& inverse, Locks locks) {
  const Vec3 free = free_turns(locks).times(omega), held = omega - free;
  return held == Vec3::zero() ? free : Vec3(free + inverse * (inertia * held));
}

/// The implicit midpoint rule on E^T (I w' + w x I w) = 0, which keeps the energy. Each sweep gains a factor of
/// h |w| / 2.
Vec3 midpoint(const Vec3& omega, const Mat3& inertia, const Mat3& inverse, Real h) {
  constexpr int kSweeps = 4;
  Vec3 next = omega;
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    const Vec3 mean = 0.5 * (omega + next);
    next = omega - h * (inverse * mean.cross(inertia * mean));
  }
  return finite(next) ? next : omega;
}

}  // namespace

void settle_locks(Scene& scene, std::uint32_t body) {
  if (body >= scene.locks.size()) return;
  scene.locks[body] = scene.modes.forbids(+EffectId::axis_locks, body) ? Locks(0) : scene.given_locks_of(body);
}

void hold_velocity(const Scene& scene, std::uint32_t body, const Quat& q, Vec3& v, Vec3& omega) {
  const Locks locks = scene.locks_of(body);
  v = free_axes(locks).times(v);
  if (!holds_turns(scene, body, locks)) return;
  const Mat3 inertia = inertia_at(scene, body, q);
  const Vec3 held = project_turn(omega, inertia, inverse_of_free(inertia, locks), locks);
  if (finite(held)) omega = held;  // else it is beyond all bounds, and the next step stops it
}

Vec3 angular_acceleration(const Scene& scene, std::uint32_t body, const Quat& q, const Vec3& torque) {
  if (const Locks locks = scene.locks_of(body); locks & kAngularLocks)
    return inverse_of_free(inertia_at(scene, body, q), locks) * torque;
  return q * (scene.inv_inertia[body] * (q.conjugate() * torque));
}

void axis_locks::find(const Scene& scene, const State& state, Participants& participants) {
  for (std::uint32_t i = 0; i < scene.attributes.bodies(AttributeId::locks); ++i)
    if (scene.given_locks_of(i) && responds(scene, state, i)) participants.add(i);
}

void axis_locks::hold(const World& world, Velocities& motion, Real h) {
  PlannedEffect& row = world.plan->effects[+EffectId::axis_locks];
  if (row.participants.count == 0) return;
  const Scene& scene = world.scene;
  const State& s = world.state;
  PredictedPose& to = world.plan->predicted;
  const bool proposes = world.plan->integrator->proposes, gyroscopic = scene.dials.choice(Dial::rotation) != 0;
  row.participants.each(world.jobs, [&](std::uint32_t i) {
    const Locks locks = scene.locks_of(i);
    const Vec3 free = free_axes(locks);
    motion.v[i] = free.times(s.v[i]);
    for (int k = 0; proposes && k < 3; ++k)
      if (free[k] == 0) to.x[i][k] = s.x[i][k];
    if (!holds_turns(scene, i, locks)) return;
    const Mat3 inertia = inertia_at(scene, i, s.q[i]), inverse = inverse_of_free(inertia, locks);
    motion.omega[i] =
        project_turn(s.omega[i], inertia, inverse, locks);  // no stage of today's leaves anything to take off
    if (!gyroscopic || std::popcount(static_cast<unsigned>(locks & kAngularLocks)) != 1) return;
    const Vec3 before = s.omega[i];
    motion.omega[i] = midpoint(before, inertia, inverse, h);
    if (proposes) to.q[i] = normalized(exp_map((h / 2) * (s.omega[i] - before)) * to.q[i]);
  });
  row.evaluations += row.participants.count;
}

}  // namespace carom::dynamics
