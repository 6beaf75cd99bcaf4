// How the rows of joints in lanes are coupled, and what that leaves of a drive's mass. Part of joint_sweeps.h.
#pragma once

#include "dynamics/joint/joint_kernels.h"
#include "dynamics/solver/lane_sides.h"

namespace carom::dynamics {
namespace {

/// x <- K^-1 x.
template <int n>
CAROM_LANES_INLINE void solve_coupled(const Lanes* factor, Lanes* x) {
  for (int k = 1; k < n; ++k)
    for (int l = 0; l < k; ++l) x[k] -= factor[k * (k + 1) / 2 + l] * x[l];
  for (int k = n - 1; k >= 0; --k) {
    x[k] = x[k] * factor[k * (k + 1) / 2 + k];
    for (int l = k + 1; l < n; ++l) x[k] -= factor[l * (l + 1) / 2 + k] * x[l];
  }
}

/// The inverse of what is left of a number, or 0 where that is but rounding: a row that others imply bears nothing.
CAROM_LANES_INLINE Lanes inverse_of_rest(Lanes rest, Lanes whole) {
  return inverse_or_zero(rest > 1e-11 * whole ? rest : all(0));
}

/// Velocity at one row per impulse at another.
/// @tparam kTwoWays  A is pulled another way than B
template <bool kTwoWays>
struct RowResponse {
  LaneVec d, i_a, i_b;  // of the impulse, over the masses
  Lanes at_a;           // of two ways: what the impulse does at A, along the way all rows have there
  CAROM_LANES_INLINE void set(const JointLanes& joint, const LockLanes* locks, const JointRowLanes& r,
                              const PullLanes* pull) {
    if constexpr (kTwoWays) {
      d = joint.inv_mass_b * (locks ? each(locks->free_b, r.d) : r.d);
      at_a = joint.inv_mass_a * dot(locks ? each(locks->free_a, pull->d_a) : pull->d_a, pull->d_a);
    } else {
      d = locks ? each(joint.inv_mass_a * locks->free_a + joint.inv_mass_b * locks->free_b, r.d)
                : (joint.inv_mass_a + joint.inv_mass_b) * r.d;
    }
    i_a = joint.inv_inertia_a * r.w_a;
    i_b = joint.inv_inertia_b * r.w_b;
  }
  CAROM_LANES_INLINE Lanes at(const JointRowLanes& r) const {
    const Lanes rest = dot(d, r.d) + (dot(i_a, r.w_a) + dot(i_b, r.w_b));
    if constexpr (kTwoWays) return at_a + rest;
    return rest;
  }
};

CAROM_LANES_INLINE PullLanes* pull_of(const JointRun& run, const JointLanes& joint) {
  return joint.pulled ? run.pulls + (joint.pulled - 1) : nullptr;
}

CAROM_LANES_INLINE const LockLanes* locks_of(const JointRun& run, const JointLanes& joint) {
  return joint.locked ? run.locks + (joint.locked - 1) : nullptr;
}

/// What a row's response is measured by: of its own size, but where bodies are locked of what it would be if they were
/// not, to within the unlikeness of a body's moments: what is left of a locked direction is rounding.
template <bool kTwoWays>
CAROM_LANES_INLINE Lanes whole_of(const JointLanes& joint, const LockLanes* locks, const JointRowLanes& r,
                                  const PullLanes* pull, Lanes own) {
  if (!locks) return own;
  const LaneSymmetric &i_a = joint.inv_inertia_a, &i_b = joint.inv_inertia_b;
  Lanes moved = (joint.inv_mass_a + joint.inv_mass_b) * dot(r.d, r.d);
  if constexpr (kTwoWays) moved = joint.inv_mass_a * dot(pull->d_a, pull->d_a) + joint.inv_mass_b * dot(r.d, r.d);
  return 1e2 *
         (moved + dot(r.w_a, r.w_a) * (i_a.xx + i_a.yy + i_a.zz) + dot(r.w_b, r.w_b) * (i_b.xx + i_b.yy + i_b.zz));
}

/// L D L^T of the coupling of n rows.
template <bool kTwoWays>
CAROM_SHARED_PART void factor_rows(JointLanes& joint, const LockLanes* locks, const PullLanes* pull,
                                   const JointRowLanes* rows) {
  const int n = static_cast<int>(joint.layout.equalities);
  Lanes* const f = joint.factor;
  for (int k = 0; k < n; ++k) {
    RowResponse<kTwoWays> response;
    response.set(joint, locks, rows[k], pull);
    Lanes v[kMostRows];
    Lanes* const row = f + k * (k + 1) / 2;
    const Lanes own = response.at(rows[k]), whole = whole_of<kTwoWays>(joint, locks, rows[k], pull, own);
    Lanes rest = own;
    for (int l = 0; l < k; ++l) {
      v[l] = response.at(rows[l]);
      const Lanes* const other = f + l * (l + 1) / 2;
      for (int m = 0; m < l; ++m) v[l] -= other[m] * v[m];
      row[l] = v[l] * other[l];
    }
    for (int l = 0; l < k; ++l) rest -= row[l] * v[l];
    row[k] = inverse_of_rest(rest, whole);
  }
}

CAROM_SHARED_PART void solve_any(const JointLanes& joint, Lanes* x) {
  switch (joint.layout.equalities) {
    case 1:
      return solve_coupled<1>(joint.factor, x);
    case 2:
      return solve_coupled<2>(joint.factor, x);
    case 3:
      return solve_coupled<3>(joint.factor, x);
    case 4:
      return solve_coupled<4>(joint.factor, x);
    case 5:
      return solve_coupled<5>(joint.factor, x);
    case 6:
      return solve_coupled<6>(joint.factor, x);
    default:
      return;
  }
}

/// Effective mass of a drive, what is locked staying so.
template <bool kTwoWays>
CAROM_SHARED_PART void weigh(const JointLanes& joint, const LockLanes* locks, const PullLanes* pull,
                             const JointRowLanes* rows, JointDriveLanes& drive) {
  RowResponse<kTwoWays> response;
  response.set(joint, locks, drive.row, pull);
  Lanes coupled[kMostRows], x[kMostRows];
  const int n = static_cast<int>(joint.layout.equalities);
  for (int k = 0; k < n; ++k) x[k] = coupled[k] = response.at(rows[k]);
  solve_any(joint, x);
  const Lanes own = response.at(drive.row);
  Lanes rest = own;
  for (int k = 0; k < n; ++k) rest -= coupled[k] * x[k];
  drive.m = inverse_of_rest(rest, whole_of<kTwoWays>(joint, locks, drive.row, pull, own));
}

}  // namespace
}  // namespace carom::dynamics
