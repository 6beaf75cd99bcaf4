// Couplings: what they ask of their joints.
#include "dynamics/joint/coupling.h"

namespace carom::dynamics {

PolynomialAt polynomial_at(const Coupling& coupling, Real leader) {
  PolynomialAt f = {0, 0, 0};
  for (std::size_t k = Coupling::kTerms; k-- > 0;) {
    f.bend = f.bend * leader + 2 * f.slope;
    f.slope = f.slope * leader + f.value;
    f.value = f.value * leader + coupling.polynomial[k];
  }
  return f;
}

bool is_slide(const World& world, std::uint32_t joint) {
  return world.joints.joint[joint].def.kind == JointKind::slider;
}

bool couples(const World& world, const Joint& joint) {
  const Coupling& coupling = world.joints.coupling_of(joint);
  return !world.joints.joint[coupling.follower].broken && !world.joints.joint[coupling.leader].broken;
}

}  // namespace carom::dynamics
