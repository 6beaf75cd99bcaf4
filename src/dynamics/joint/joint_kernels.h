// Arithmetic of joints in lanes, compiled once for each width of registers.
#pragma once

#include "dynamics/joint/joint_lanes.h"

namespace carom::dynamics {

/// The same functions for one width; same bits from each.
struct JointKernels {
  const char* name;
  /// Arms, axes, errors and couplings at the present poses.
  void (*place)(const JointRun& run);
  /// How errors will bend away from their tangents within a substep, from the velocities as it begins.
  /// @param h  s
  void (*bend)(const JointRun& run, double h);
  /// Let the impulses kept so far act.
  void (*warm_start)(const JointRun& run);
  /// One sweep: drives, then all equalities of a joint at once, errors undone at the rate of the softness.
  void (*solve)(const JointRun& run, double inv_h);
  /// Let the impulses that have been found before the move act once more after it, where the loads do too: what was
  /// found is recorded, and a start for what is to be found.
  void (*act_again)(const JointRun& run);
  /// The same sweep without the push and without springs, then the impulses are added under the step's.
  void (*relax)(const JointRun& run, double inv_h);
};

/// The widest that this machine has, or the one of that name.
const JointKernels& joint_kernels(const char* name);

}  // namespace carom::dynamics
