// The gyroscopic term: why a spinning body that is not round wobbles although nothing touches it.
//   d(omega)/dt = -I^-1 (omega x I omega), I the inertia; nothing for spheres and cubes, so they are no participants.

#include "dynamics/force/force.h"

namespace carom::dynamics::gyroscopic {

void find(const Scene& scene, const State& state, Participants& participants) {
  for (std::uint32_t i = 0; i < scene.bodies.slots(); ++i) {
    if (!responds(scene, state, i) || !rotates(scene, i)) continue;
    if (scene.locks_of(i) & kAngularLocks) continue;  // no free top: @see axis_locks
    const Mat3& inertia = scene.inertia[i];
    const Real mean = inertia.trace() / 3;
    // Rounding of the parallel-axis sums leaves a cube anisotropic by a few eps; 1e-12 turns the momentum of such a
    // body by less than 1e-12 of its spin.
    if ((inertia - mean * Mat3::identity()).abs().max_entry() > 1e-12 * mean) participants.add(i);
  }
}

bool wakes(const Scene&, const State& state, std::uint32_t body) { return state.omega[body] != Vec3::zero(); }

void force(const Scene& scene, const State&, const Participants& participants, const Motion& at,
           const Accelerate& out) {
  participants.each([&](std::uint32_t i) {
    const Quat& q = at.q[i];
    const Vec3 w = q.conjugate() * at.omega[i];
    out.omega[i] -= out.scale * (q * (scene.inv_inertia[i] * w.cross(scene.inertia[i] * w)));
  });
}

/// One Newton step, from w = w0, on the implicit Euler equation in body axes:
///   f(w) = I (w - w0) + h w x I w = 0,   f(w0) = h w0 x I w0,   f'(w0) = I + h ([w0]x I - [I w0]x)
/// Damps energy in place of blowing up; first order.   @source [Catto2015]
void flow(const Scene& scene, const Participants& participants, Real h, const Quat* q, Vec3*, Vec3* omega) {
  participants.each([&](std::uint32_t i) {
    const Mat3& inertia = scene.inertia[i];
    const Vec3 w = q[i].conjugate() * omega[i];
    const Vec3 momentum = inertia * w;
    const Vec3 f = h * w.cross(momentum);
    const Mat3 slope = inertia + h * (cross_matrix(w) * inertia - cross_matrix(momentum));
    const Vec3 step = slope.inverse() * f;
    if (finite(step)) omega[i] = q[i] * (w - step);  // the slope is singular for no physical spin, only for absurd ones
  });
}

}  // namespace carom::dynamics::gyroscopic
