// Classical fourth-order Runge-Kutta on position, orientation and both velocities together.
//
//   y = (x, q, v, omega),  y' = (v, 1/2 omega q, a(y), alpha(y)),  omega in the world frame as a pure quaternion
//   k1 = f(y0), k2 = f(y0 + h/2 k1), k3 = f(y0 + h/2 k2), k4 = f(y0 + h k3),  y1 = y0 + h/6 (k1 + 2 k2 + 2 k3 + k4)
//
// f reads q only through q/|q|: that field leaves |q| constant and agrees with the rigid body's on unit quaternions, so
// renormalising the intermediate orientations costs no order.   @source [Hairer1993 §II.1]
#include "dynamics/integrate/integrator.h"

namespace carom::dynamics {
namespace {

Quat spin_rate(const Vec3& omega, const Quat& q) {
  const Quat dq = Quat(0, omega.x(), omega.y(), omega.z()) * q;
  return Quat(0.5 * dq.w(), 0.5 * dq.x(), 0.5 * dq.y(), 0.5 * dq.z());
}

/// Scratch by body slot: the intermediate state, the derivative there, and the weighted sum of derivatives.
struct Scratch {
  Vec3 *x, *v, *omega, *dv, *domega, *sum_v, *sum_dv, *sum_domega;
  Quat *q, *sum_dq;
  static constexpr std::size_t kVectors = 8, kRotations = 2;

  Scratch(Plan& plan, std::size_t n) {
    Vec3** vectors[kVectors] = {&x, &v, &omega, &dv, &domega, &sum_v, &sum_dv, &sum_domega};
    for (std::size_t k = 0; k < kVectors; ++k) *vectors[k] = plan.scratch_vectors.data() + k * n;
    q = plan.scratch_rotations.data();
    sum_dq = plan.scratch_rotations.data() + n;
  }
};

void velocity_by_rk4(const World& world, Velocities& to, Real h) {
  const State& s = world.state;
  Plan& plan = *world.plan;
  const Scratch t(plan, s.x.size());

  const auto start = [&](std::uint32_t i) {
    t.x[i] = s.x[i], t.v[i] = s.v[i], t.q[i] = s.q[i], t.omega[i] = s.omega[i];
    t.sum_v[i] = t.sum_dv[i] = Vec3::zero();
  };
  plan.linear.each(start);
  plan.rotating.each([&](std::uint32_t i) {
    start(i);
    t.sum_dq[i] = Quat::zero();
    t.sum_domega[i] = Vec3::zero();
  });

  constexpr Real kWeight[4] = {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6};
  const Real next[4] = {h / 2, h / 2, h, 0};  // how far along this derivative the next evaluation stands
  for (int k = 0; k < 4; ++k) {
    plan.linear.each([&](std::uint32_t i) { t.dv[i] = Vec3::zero(); });
    plan.rotating.each([&](std::uint32_t i) { t.dv[i] = t.domega[i] = Vec3::zero(); });
    evaluate_forces(world, {t.x, t.q, t.v, t.omega}, {1, t.dv, t.domega, h * kWeight[k]});
    const auto advance = [&](std::uint32_t i) {
      t.sum_v[i] += kWeight[k] * t.v[i];
      t.sum_dv[i] += kWeight[k] * t.dv[i];
      t.x[i] = s.x[i] + next[k] * t.v[i];
      t.v[i] = s.v[i] + next[k] * t.dv[i];
    };
    plan.linear.each(advance);
    plan.rotating.each([&](std::uint32_t i) {
      advance(i);
      const Quat dq = spin_rate(t.omega[i], t.q[i]);
      t.sum_dq[i] += kWeight[k] * dq;
      t.sum_domega[i] += kWeight[k] * t.domega[i];
      t.q[i] = s.q[i] + next[k] * dq;
      t.q[i] = normalized(t.q[i]);
      t.omega[i] = s.omega[i] + next[k] * t.domega[i];
    });
  }

  const auto finish = [&](std::uint32_t i) {
    plan.predicted.x[i] = s.x[i] + h * t.sum_v[i];
    to.v[i] += h * t.sum_dv[i];
  };
  plan.linear.each(finish);
  plan.rotating.each([&](std::uint32_t i) {
    finish(i);
    plan.predicted.q[i] = s.q[i] + h * t.sum_dq[i];
    plan.predicted.q[i] = normalized(plan.predicted.q[i]);
    to.omega[i] += h * t.sum_domega[i];
  });
  evaluate_flows(world, to, h, s.q.data());  // only effects too stiff for an explicit method are flows here
}

}  // namespace

const Integrator kRungeKutta4 = {"rk4", true, true, false, 1, Scratch::kVectors, Scratch::kRotations, velocity_by_rk4};

}  // namespace carom::dynamics
