// Mass properties of a body from its colliders and from what the host said.
#pragma once

#include "dynamics/scene.h"

namespace carom::dynamics {

/// kg: of less the reciprocal is no number. What weighs less weighs nothing.
inline constexpr Real kLeastMass = 1e-300;

struct BodyMass {
  Real mass = 0, inv_mass = 0;  // kg, 1/kg; 0 unless dynamic
  Vec3 center = Vec3::zero();   // m, body frame
  Mat3 inertia = Mat3::zero();  // kg m^2, body axes, about center; zero: does not rotate
  Mat3 inv_inertia = Mat3::zero();
};

/// Sum of the colliders by the parallel-axis theorem, then the host's overrides:
///   - mass given: the colliders' inertia is scaled to it. If all their densities are 0, they weigh by volume.
///   - center given: the body's centre of mass; the inertia about it is the colliders' about their own common centre,
///   since a
///     centre elsewhere says that the mass is not spread as the densities tell.
///   - inertia given: taken as it is; all zero, or not positive definite: the body does not rotate.
///   - a dynamic body with no mass from anywhere weighs 1 kg and does not rotate (a particle).
///   - static and kinematic bodies have no mass; their centre is the origin of their frame unless given.
/// @param skip  a collider slot to leave out (one about to be removed), or Colliders::kNoMaterial for none
/// @accuracy    rounding of the sums, n eps relative to the largest term
/// @oracle      tests/unit/dynamics/test_mass
BodyMass mass_of_body(const Scene& scene, std::uint32_t body, std::uint32_t skip = Colliders::kNoMaterial);

}  // namespace carom::dynamics
