// The effects on velocities, one file each: who are the customers, and what is done to them.
//
// Signatures as the table wants them (dynamics/effects.h): a force adds scale * acceleration to its target and reads
// the motion it is given, never the state's; a flow maps velocities over h exactly or stably where a force could not.
#pragma once

#include "dynamics/effects.h"

namespace carom {

/// Whether forces act on a body at all: dynamic, there, and not in quarantine.
inline bool responds(const Scene& scene, const State& state, std::uint32_t i) {
  return scene.inv_mass[i] > 0 && !state.quarantined[i];
}
inline bool rotates(const Scene& scene, std::uint32_t i) { return scene.inv_inertia[i](0, 0) > 0; }

namespace gravity {
void find(const Scene&, const State&, Customers&);
void force(const Scene&, const State&, const Customers&, const Motion& at, const Accelerate& out);
}  // namespace gravity

namespace linear_damping {
void find(const Scene&, const State&, Customers&);
void force(const Scene&, const State&, const Customers&, const Motion& at, const Accelerate& out);
void flow(const Scene&, const Customers&, Real h, const Quat* q, Vec3* v, Vec3* omega);
Real rate(const Scene&, const Customers&);
}  // namespace linear_damping

namespace angular_damping {
void find(const Scene&, const State&, Customers&);
void force(const Scene&, const State&, const Customers&, const Motion& at, const Accelerate& out);
void flow(const Scene&, const Customers&, Real h, const Quat* q, Vec3* v, Vec3* omega);
Real rate(const Scene&, const Customers&);
}  // namespace angular_damping

namespace gyroscopic {
void find(const Scene&, const State&, Customers&);
bool wakes(const Scene&, const State&, std::uint32_t body);
void force(const Scene&, const State&, const Customers&, const Motion& at, const Accelerate& out);
void flow(const Scene&, const Customers&, Real h, const Quat* q, Vec3* v, Vec3* omega);
}  // namespace gyroscopic

namespace user_force {
void find(const Scene&, const State&, Customers&);
void force(const Scene&, const State&, const Customers&, const Motion& at, const Accelerate& out);
}  // namespace user_force

namespace user_torque {
void find(const Scene&, const State&, Customers&);
void force(const Scene&, const State&, const Customers&, const Motion& at, const Accelerate& out);
}  // namespace user_torque

/// e^-x with the same bits on every platform.
/// @param x   x >= 0
/// @accuracy  2 eps relative for x < 700; 0 beyond
/// @oracle    tests/unit/dynamics/test_forces
Real decay(Real x);

}  // namespace carom
