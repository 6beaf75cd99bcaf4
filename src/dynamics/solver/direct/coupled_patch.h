// A patch whose friction is bounded by what its contacts bear at the same time: Coulomb's cone of a pair.
//
//     least over N, F of  sum R_k (N_k - z_k)^2 / 2 + R |F - z|^2 / 2,    N_k >= 0,    F within the bound for mu sum N_k
//
// That is convex, and where nothing slides it is the whole law: impulses that hold what stands are found if there are any.
// What slides would be lifted by it, so it is for what stands.
#pragma once

#include <array>
#include <span>

#include "dynamics/solver/contact_lanes.h"
#include "dynamics/solver/direct/patch_bound.h"

namespace carom::dynamics {

/// The nearest impulses.
struct CoupledPatch {
  std::array<Real, kPairPoints> normal;  // N_k
  Vec3 friction;                         // F
  Real most = 0;                         // N s, mu sum N_k
  bool is_inside = true;                 // friction has some to spare: nothing is coupled

  /// @param z_n, resistance  of its contacts   @param z, r  of its friction   @param mu  above 0   @param bound  for any load
  CoupledPatch(std::span<const Real> z_n, std::span<const Real> resistance, const Vec3& z, Real r, Real mu,
               PatchBound bound);
};

/// How these change with velocities, where they are coupled: beside what N_k and F would do with a known bound, two
/// squares,
///     - (sum u_k / R_k)^2 / between + weight (q.u / R + share sum u_k / R_k)^2,    sums over contacts that bear.
struct PatchCoupling {
  Real between, weight, share;
  Vec3 q;
  PatchCoupling() = default;
  PatchCoupling(const CoupledPatch& at, std::span<const Real> resistance, const Vec3& z, Real r, Real mu,
                PatchBound bound);
};

}  // namespace carom::dynamics
