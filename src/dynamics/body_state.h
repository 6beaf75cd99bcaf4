// What can be said of one body from its scene and state alone.
#pragma once

#include "dynamics/scene.h"
#include "dynamics/state.h"

namespace carom::dynamics {

/// Whether forces act on a body at all: dynamic, there, not disabled and not in quarantine.
inline bool responds(const Scene& scene, const State& state, std::uint32_t i) {
  return scene.inv_mass[i] > 0 && !state.held_out[i];
}
/// Whether an impulse can move it.
inline bool yields(const Scene& scene, const State& state, std::uint32_t i) {
  return responds(scene, state, i) && scene.locks_of(i) != kAllLocks;
}
inline bool rotates(const Scene& scene, std::uint32_t i) { return scene.inv_inertia[i](0, 0) > 0; }
/// kg m^2, world, of a body that faces like q.
inline Mat3 inertia_at(const Scene& scene, std::uint32_t i, const Quat& q) {
  const Mat3 r = q.matrix();
  return r * scene.inertia[i] * r.transpose();
}
/// 1 along world axes on which a body may move, or about which it may turn, else 0.
inline Vec3 free_axes(Locks locks) { return Vec3((locks & 1) == 0, (locks & 2) == 0, (locks & 4) == 0); }
inline Vec3 free_turns(Locks locks) { return free_axes(static_cast<Locks>(locks >> 3)); }
/// E (E^T I E)^-1 E^T, E the world axes about which a body may turn: its inverse inertia where it cannot about others.
/// @param inertia  kg m^2, world   @return 1/(kg m^2), world; rows and columns of locked axes are 0 to the bit
Mat3 inverse_of_free(const Mat3& inertia, Locks locks);

}  // namespace carom::dynamics
