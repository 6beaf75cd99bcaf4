// One lane at a time: what contacts and joints put into their lanes, and read from them.
#pragma once

#include <type_traits>

#include "core/wide.h"
#include "dynamics/body_state.h"
#include "dynamics/contact/contact.h"

namespace carom::dynamics {

/// Rounds to what the lanes are.
template <class Lanes>
void set(Lanes& to, int lane, Real x) {
  to[lane] = static_cast<std::remove_cvref_t<decltype(to[lane])>>(x);
}
template <class Number>
void set(LaneVecOf<Number>& to, int lane, const Vec3& v) {
  set(to.x, lane, v.x()), set(to.y, lane, v.y()), set(to.z, lane, v.z());
}

inline Real get(const Lanes& from, std::uint32_t lane) { return from[lane]; }
template <class Number>
Vec3 get(const LaneVecOf<Number>& from, std::uint32_t lane) {
  return Vec3(from.x[lane], from.y[lane], from.z[lane]);
}

/// A body's inverse mass and inertia, world axes, from Contacts::inv_inertia_w; zero where impulses do not move it.
template <class Number>
void set_mass(const World& world, bool moves, std::uint32_t body, LanesOf<Number>& inv_mass,
              LaneSymmetricOf<Number>& inv_inertia, int lane) {
  set(inv_mass, lane, moves ? world.scene.inv_mass[body] : 0);
  const Mat3 m = moves && rotates(world.scene, body) ? world.contacts->inv_inertia_w[body] : Mat3(Mat3::zero());
  set(inv_inertia.xx, lane, m(0, 0)), set(inv_inertia.xy, lane, m(0, 1)), set(inv_inertia.xz, lane, m(0, 2));
  set(inv_inertia.yy, lane, m(1, 1)), set(inv_inertia.yz, lane, m(1, 2)), set(inv_inertia.zz, lane, m(2, 2));
}

/// Which way the two bodies of one lane are free.
/// @param at  where in `all_locks` the four lanes stand, from 1; 0: they have no place yet
template <class Number>
void set_locks(Array<LockLanesOf<Number>>& all_locks, std::uint32_t& at, std::uint32_t lane, Locks a, Locks b) {
  if (!at) {
    const LaneVecOf<Number> free = {all<Number>(1), all<Number>(1), all<Number>(1)};
    all_locks.push_back({free, free});
    at = static_cast<std::uint32_t>(all_locks.size());
  }
  LockLanesOf<Number>& locks = all_locks[at - 1];
  set(locks.free_a, static_cast<int>(lane), free_axes(a));
  set(locks.free_b, static_cast<int>(lane), free_axes(b));
}

}  // namespace carom::dynamics
