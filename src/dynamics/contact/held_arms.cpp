#include "dynamics/contact/held_arms.h"

#include "dynamics/world.h"

namespace carom::dynamics {
namespace {

constexpr Real kSlow = 0.1;  // rad/s: what turns faster is on its way, not leaning

}  // namespace

void hold_orientation(const World& world, SolverMemory& to, std::uint32_t body) {
  const State& s = world.state;
  const Quat& q = s.q[body];
  Quat& held = to.held_q[body];
  const Real turned = 2 * (q * held.conjugate()).vec().norm();
  if (turned > world.scene.dials[Dial::hold_angle] || s.omega[body].squared_norm() > kSlow * kSlow) held = q;
}

Mat3 held_back(const World& world, std::uint32_t body) {
  const Quat& held = world.state.held_q[body];
  if (held == world.state.q[body]) return Mat3::zero();
  return held.matrix() - world.plan->rotation[body];
}

}  // namespace carom::dynamics
