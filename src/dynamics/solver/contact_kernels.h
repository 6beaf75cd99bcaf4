// Arithmetic of contacts in lanes, compiled once for each width of registers.
#pragma once

#include <cstddef>

#include "dynamics/solver/wide_contacts.h"

namespace carom {

/// A run of pairs with their points and all bodies.
struct LaneRun {
  PairLanes* pairs;
  std::size_t count;
  PointLanes* points;
  BodyVelocity* velocity;
  const BodyShift* shift;
};

inline LaneRun everything(WideContacts& wide) {
  return {wide.pairs.data(), wide.pairs.size(), wide.points.data(), wide.velocity.data(), wide.shift.data()};
}

/// The same functions for one width; same bits from each.
struct ContactKernels {
  const char* name;
  /// Masses at each point, from arms and inertias.
  void (*prepare)(const LaneRun& run);
  /// Let the impulses kept so far act.
  void (*warm_start)(const LaneRun& run);
  /// One sweep: friction, then normals. Contacts that are open may close by their separation within inv_h;
  /// penetration is undone at the rate of the softness, at push_speed at most.
  /// @param inv_h  1/s   @param push_speed  m/s
  void (*solve)(const LaneRun& run, double inv_h, double push_speed);
  /// Separations at the present poses, then the same sweep without the push: what it gave to velocities is taken back.
  void (*relax)(const LaneRun& run, double inv_h);
  /// One sweep without a spring: friction, then normals, which undo no penetration.
  void (*sweep)(const LaneRun& run, double inv_h);
  /// Book this substep's impulses under the step's.
  void (*book)(const LaneRun& run);
  /// One sweep over displacements instead of velocities: what lies deeper than `slop` is moved apart by `share` of
  /// that.
  /// @param run  velocities of this run are displacements, m and rad
  void (*part)(const LaneRun& run, double share, double slop);
  /// Separations at the present poses; displacements asked for by part() are forgotten.
  void (*measure)(const LaneRun& run);
  /// Once a step: points that were hit harder than `speed` part at restitution times that.
  void (*bounce)(const LaneRun& run, double speed);
};

/// The widest that this machine has.
const ContactKernels& contact_kernels();

/// What solvers in lanes begin and end a step with: rows into lanes and their masses; bounces, and impulses back.
void begin_lanes(World& world);
void end_lanes(World& world);

}  // namespace carom
