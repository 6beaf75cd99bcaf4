// Arithmetic of contacts in lanes, compiled once for each width of registers.
#pragma once

#include <span>

#include "dynamics/solver/contact_lanes.h"

namespace carom::dynamics {

/// What is done to rows of doubles, or of floats.
template <class Number>
struct ContactSweeps {
  using Run = LaneRunOf<Number>;
  /// Lanes from rows, but for masses and softness.   @param sources  [pairs of the run]
  void (*lay_out)(const Run& run, const LaneSources* sources);
  /// Back into rows: impulses, and from the present state relative velocities and separations.
  /// @param targets  [pairs of the run]
  void (*read_back)(const Run& run, const LaneTargets* targets);
  /// Masses at each point, from arms and inertias. False: some number is beyond what floats can bear, @see
  /// float_range.h
  bool (*prepare)(const Run& run);
  /// What ground that turns does in this substep: drives of pairs, and friction that goes round with it.
  /// @param bodies  by solver body   @param h  s, substep
  void (*lead)(const Run& run, const BodyTurn* bodies, double h);
  /// Let the impulses kept so far act.
  void (*warm_start)(const Run& run);
  /// One sweep: friction, then normals. Contacts that are open may close by their separation within inv_h;
  /// penetration is undone at the rate of the softness, at push_speed at most beyond what holds the load.
  /// @param inv_h  1/s   @param push_speed  m/s
  void (*solve)(const Run& run, double inv_h, double push_speed);
  /// The same sweep over those pairs alone that gravity moves by more than a share of their thickness within a substep.
  void (*solve_thin)(const Run& run, double inv_h, double push_speed, double share);
  /// Likewise over those of which a body is marked.   @param bodies  [solver bodies], 1 or 0; that of none is 0
  void (*solve_of)(const Run& run, double inv_h, double push_speed, const std::uint8_t* bodies);
  /// Separations at the present poses, then the same sweep without the push: what it gave to velocities is taken back.
  void (*relax)(const Run& run, double inv_h);
  /// Likewise, but what will bounce in the next substep is not slowed down now.
  void (*relax_sparing)(const Run& run, double inv_h);
  /// One sweep over displacements instead of velocities: what lies deeper than `slop`, or than a share of the thickness
  /// if that is less, and than its spring lets sink what it bears, is moved apart by `share` of that.
  /// @param run  velocities of this run are displacements, m and rad
  /// @param slop  m   @param slop_of_thin  1, of the thickness of the thinner of the two
  void (*part)(const Run& run, double share, double slop, double slop_of_thin);
  /// Separations at the present poses.
  void (*measure)(const Run& run);
};

/// What solvers ask that go pair by pair.   @param sources  [pairs]
struct PointKernels {
  void (*place)(const PointSources* sources, std::size_t pairs, PointPlaces* places);
  void (*watch)(const PointSources* sources, std::size_t pairs, PointMotions* motions);
};

/// The same functions for one width; same bits from each.
struct ContactKernels {
  const char* name;
  PointKernels points;
  ContactSweeps<double> in_double;
  ContactSweeps<float> in_float;
};

/// The widest that this machine has: what a world starts with. A test gives WideContacts::kernels another.
const ContactKernels& contact_kernels();
/// All that this machine can run, the baseline first.
std::span<const ContactKernels* const> all_contact_kernels();

}  // namespace carom::dynamics
