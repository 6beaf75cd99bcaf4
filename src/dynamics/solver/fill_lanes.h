// One lane at a time: what contacts and joints put into their lanes, and read from them.
#pragma once

#include <bit>

#include "core/wide.h"
#include "dynamics/contact/contact.h"
#include "dynamics/force/force.h"

namespace carom {

inline void set(LaneVec& to, int lane, const Vec3& v) { to.x[lane] = v.x(), to.y[lane] = v.y(), to.z[lane] = v.z(); }

inline Vec3 get(const LaneVec& from, std::uint32_t lane) { return Vec3(from.x[lane], from.y[lane], from.z[lane]); }

/// A body's inverse mass and inertia, world axes, from Contacts::inv_inertia_w; zero where impulses do not move it.
inline void set_mass(const World& world, bool moves, std::uint32_t body, Lanes& inv_mass, LaneSymmetric& inv_inertia,
                     int lane) {
  inv_mass[lane] = moves ? world.scene.inv_mass[body] : 0;
  const Mat3 m = moves && rotates(world.scene, body) ? world.contacts->inv_inertia_w[body] : Mat3(Mat3::Zero());
  inv_inertia.xx[lane] = m(0, 0), inv_inertia.xy[lane] = m(0, 1), inv_inertia.xz[lane] = m(0, 2);
  inv_inertia.yy[lane] = m(1, 1), inv_inertia.yz[lane] = m(1, 2), inv_inertia.zz[lane] = m(2, 2);
}

/// Which way the two bodies of one lane are free.
/// @param at  where in `all_locks` the four lanes stand, from 1; 0: they have no place yet
inline void set_locks(Array<LockLanes>& all_locks, std::uint32_t& at, std::uint32_t lane, Locks a, Locks b) {
  if (!at) {
    const LaneVec free = {all(1), all(1), all(1)};
    all_locks.push_back({free, free});
    at = static_cast<std::uint32_t>(all_locks.size());
  }
  LockLanes& locks = all_locks[at - 1];
  set(locks.free_a, static_cast<int>(lane), free_axes(a));
  set(locks.free_b, static_cast<int>(lane), free_axes(b));
}

/// The first colour, of 64, that neither of two bodies has yet, and has from now on; 64: none is left.
/// @param taken  by solver body, bit c: it has colour c
inline std::uint32_t take_colour(Array<std::uint64_t>& taken, bool moves_a, std::uint32_t a, bool moves_b,
                                 std::uint32_t b) {
  std::uint64_t nobody = 0;
  std::uint64_t &of_a = moves_a ? taken[a] : nobody, &of_b = moves_b ? taken[b] : nobody;
  const auto colour = static_cast<std::uint32_t>(std::countr_one(of_a | of_b));
  if (colour < 64) of_a |= std::uint64_t{1} << colour, of_b |= std::uint64_t{1} << colour;
  return colour;
}

}  // namespace carom
