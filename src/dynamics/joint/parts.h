// The table of kinds: which parts a joint is made of, and which of its coordinates can be limited, driven and sprung.
#pragma once

#include "dynamics/joint/joint.h"
#include "dynamics/joint/joint_lanes.h"
#include "dynamics/world.h"

namespace carom::dynamics {

/// What a kind of joint is made of.
struct KindRow {
  const char* name;
  std::uint32_t part_count;
  std::array<JointPart, kMostParts> part;
  std::uint32_t coordinates;  // bit k: Coordinate k is free, and can be limited, driven and sprung
};
const KindRow& row_of(JointKind kind);
inline bool has(JointKind kind, Coordinate c) {
  return (row_of(kind).coordinates >> static_cast<std::uint32_t>(c) & 1) != 0;
}

/// The rows of a joint as it is set up now. A distance joint that is limited or sprung is no rod.
JointLayout layout_of(const Joints& joints, const Joint& joint);
/// A number for a layout: joints with the same one may share lanes.
std::uint64_t layout_key(const Joints& joints, const Joint& joint);

/// Where a joint's frames are now.
/// @accuracy  apart: the difference of the centres is formed first, so far from the origin it loses no digits of its
/// own
JointEnds ends_of(const World& world, const JointDef& def);
/// m or rad, by Coordinate; of a pulley the last means nothing.   @accuracy  as of place_of()
std::array<Real, kCoordinates> coordinates_of(const JointEnds& ends);
/// m or rad: the coordinate of a joint that is coupled, as counted.   @accuracy  as of place_of()
Real coupled_coordinate(const World& world, std::uint32_t joint);
/// Where a joint is, and how far from what it locks and limits.
/// @accuracy  gap: rounding of the bodies' positions; angle: 1e-8 rad near 0, where it is the root of a sum of squares
JointPlace place_of(const World& world, const Joint& joint);

/// The ropes of a pulley, from what they run over to the bodies' points. m, world
struct Ropes {
  Vec3 a, b;
};
/// @accuracy  as of JointEnds::apart
Ropes ropes_of(const World& world, const Joint& joint, const JointEnds& ends);

/// Coefficients of a spring of one row: with x the stretch as a substep begins and u the velocity as it ends, its
/// impulse is p = -m (h w^2 x + 2 zeta w h u), m the row's effective mass, w = 2 pi frequency.
///   pull = h w^2 / (1 + 2 zeta w h),   drag = 2 zeta w h / (1 + 2 zeta w h)
/// So it neither gains nor loses energy undamped, sags by what it is loaded with over m w^2, and creeps as it should
/// when damped beyond measure.
/// @param frequency  Hz, taken to be a quarter of the substep rate at most   @param h  s
/// @accuracy   frequency: 1 + (w h)^2 / 24; rate of decay: 1 - zeta w h     @oracle  tests/oracle/test_joints
struct Spring {
  Real pull, drag;  // 1/s, 1
};
Spring spring_of(Real frequency, Real damping, Real h);

}  // namespace carom::dynamics
