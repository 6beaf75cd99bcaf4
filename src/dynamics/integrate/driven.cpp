// Bodies that a host moves: changes of velocity that go on are spread over a step.
#include "dynamics/integrate/driven.h"

#include <algorithm>
#include <utility>

namespace carom::dynamics {
namespace {

/// Of a change and the one before: what both have, along the later one.
Vec3 lasting(const Vec3& now, const Vec3& before) {
  const Real both = now.dot(before), most = now.squared_norm();
  if (!(both > 0)) return Vec3::zero();
  return both < most ? (both / most) * now : now;
}

bool is_any(const DrivenMemory& m) {
  return m.v != Vec3::zero() || m.omega != Vec3::zero() || m.a != Vec3::zero() || m.alpha != Vec3::zero();
}

/// rad/s, that turns q to `end` in h: by Newton's method from one that nearly does.
Vec3 omega_to(const Quat& q, const Quat& end, Vec3 omega, Real h) {
  for (int i = 0; i < 2; ++i) {
    const Quat left = end * (exp_map(h * omega) * q).conjugate();
    const Vec3 e = (left.w() < 0 ? -2 : 2) * left.vec(), turn = h * omega, side = turn.cross(e);
    omega += 1 / h * (e - 0.5 * side + 1.0 / 12 * turn.cross(side));
  }
  return omega;
}

}  // namespace

void find_led(const World& world, SolverMemory& to, const StepTime& time) {
  Plan& plan = *world.plan;
  const State& s = world.state;
  plan.led.clear(), plan.driven.clear();
  const DrivenMemory* old = to.driven.data();
  const DrivenMemory* const end = old + to.driven.size();
  plan.kinematic.each([&](std::uint32_t i) {
    const Handle handle = world.scene.bodies.handle(i);
    while (old != end && handle_slot(old->body) < i) ++old;
    const bool is_known = old != end && old->body == handle;
    const DrivenMemory before = is_known ? *old : DrivenMemory{handle, time.dt};
    const Real rate = 2 / (time.dt + before.dt);
    DrivenMemory now{handle, time.dt, s.v[i], s.omega[i]};
    now.a = rate * (now.v - before.v), now.alpha = rate * (now.omega - before.omega);
    if (!is_any(now)) return;
    plan.driven.push_back(now);
    const Vec3 a = lasting(now.a, before.a), alpha = lasting(now.alpha, before.alpha);
    if (a == Vec3::zero() && alpha == Vec3::zero()) return;
    plan.led.push_back({i, 0, now.v, now.omega, a, alpha, normalized(exp_map(time.dt * now.omega) * s.q[i])});
  });
  std::swap(to.driven, plan.driven);
}

void begin_leading(const World& world, Velocities& to, const StepTime& time) {
  for (LedBody& b : world.plan->led) {
    b.substeps = 0;
    to.v[b.slot] = b.v_in(1, world.plan->substeps, time.h),
    to.omega[b.slot] = b.omega_in(1, world.plan->substeps, time.h);
  }
}

void lead(const World& world, Velocities& to, const StepTime& time) {
  const int n = world.plan->substeps;
  for (LedBody& b : world.plan->led) {
    ++b.substeps;
    to.v[b.slot] = b.v_in(b.substeps, n, time.h);
    Vec3& omega = to.omega[b.slot] = b.omega_in(b.substeps, n, time.h);
    if (b.substeps < n || b.alpha == Vec3::zero()) continue;
    omega = omega_to(world.state.q[b.slot], b.end, omega, time.h);
  }
}

void stop_leading(const World& world, Velocities& to, const StepTime&) {
  for (const LedBody& b : world.plan->led) to.v[b.slot] = b.v, to.omega[b.slot] = b.omega;
  world.plan->led.clear();
}

const LedBody* led_body(const World& world, std::uint32_t body) {
  const Array<LedBody>& led = world.plan->led;
  const auto is_it = [&](const LedBody& b) { return b.slot == body; };
  const auto at = std::find_if(led.begin(), led.end(), is_it);
  return at == led.end() ? nullptr : &*at;
}

}  // namespace carom::dynamics
