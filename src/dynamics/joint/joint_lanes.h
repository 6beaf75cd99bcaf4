// Joints of four pairs side by side, as the kernels see them: plain data. What contact_lanes.h says of files compiled
// for newer machines holds here.
#pragma once

#include "dynamics/solver/contact_lanes.h"

namespace carom::dynamics {

struct LaneQuat {
  Lanes x, y, z, w;
};

/// What locks relative motion: rows that are solved together.
enum class JointPart : std::uint8_t {
  point,        // 3: B's point stays at A's
  line,         // 2: it stays on A's x axis
  rod,          // 1: it stays at a distance
  orientation,  // 3: the frames stay parallel
  direction,    // 2: the x axes do
  pins,         // 1: B's z axis stays at right angles to A's y axis
  ropes,        // 1: the lengths of two ropes have a sum
  gears,        // 1: the angles of both bodies about their x axes have a sum
  place_x,      // 1: B's point stays in the plane across A's x axis
  place_y,      // 1
  place_z,      // 1
  turn_x,       // 1: the twist stays
  turn_y,       // 1: so does one component of the swing
  turn_z,       // 1
  across_y,     // 1: B's x axis stays at right angles to A's y axis: no swing about z
  across_z      // 1: to A's z axis: no swing about y
};
/// How many of them.
CAROM_LANES_INLINE constexpr std::uint32_t rows_of(JointPart part) {
  switch (part) {
    case JointPart::point:
    case JointPart::orientation:
      return 3;
    case JointPart::line:
    case JointPart::direction:
      return 2;
    case JointPart::rod:
    case JointPart::pins:
    case JointPart::ropes:
    case JointPart::gears:
    case JointPart::place_x:
    case JointPart::place_y:
    case JointPart::place_z:
    case JointPart::turn_x:
    case JointPart::turn_y:
    case JointPart::turn_z:
    case JointPart::across_y:
    case JointPart::across_z:
      return 1;
  }
  return 0;
}
enum class DriveKind : std::uint8_t {
  motor,
  spring,
  limit,
  stop,
  rotor,
  pace
};  // in the order in which they are visited
/// Whether a row is of a place; others are of a speed alone.
CAROM_LANES_INLINE bool has_place(DriveKind kind) {
  return kind == DriveKind::spring || kind == DriveKind::limit || kind == DriveKind::stop;
}
/// Whether all of what a row does in a substep is done at once, by a law of where that began.
CAROM_LANES_INLINE bool acts_once(DriveKind kind) {
  return kind == DriveKind::spring || kind == DriveKind::stop || kind == DriveKind::rotor;
}
struct DriveRow {
  std::uint8_t coordinate;  // as Coordinate; from kFirstAxis, kFirstTurn
  DriveKind kind;
  std::uint8_t source = 0;  // of an axis: as AxisSource
};
inline constexpr int kFirstAxis = 4;   // coordinates of rows: six axes, then
inline constexpr int kFirstTurn = 10;  // the three components of what is left of a turn to an orientation

inline constexpr int kMostParts = 6, kMostRows = 6, kMostDriveRows = 39;

/// The rows of a joint: those of its parts, then its drives. Joints that share lanes have the same.
struct JointLayout {
  std::uint32_t parts = 0, equalities = 0, drives = 0;
  bool two_ways = false;  // A is pulled another way than B, @see PullLanes
  bool axed = false;      // it has AxesLanes
  bool counts = false;    // some drive reads an angle that counts turns
  JointPart part[kMostParts] = {};
  DriveRow drive[kMostDriveRows] = {};
};

/// One row of each of four joints: u = d.(v_b - v_a) + w_b.omega_b - w_a.omega_a, the rate of `error`. Where A is
/// pulled another way than B, u = d.v_b - d_a.v_a + ..., @see PullLanes.
struct JointRowLanes {
  LaneVec d;         // world; unit or zero
  LaneVec w_a, w_b;  // m or 1, world
  Lanes error;       // m or rad, from what is locked; of a drive: the coordinate
  Lanes curve;       // m/s or rad/s: half a substep of the second derivative of `error` at constant velocities
  Lanes p;           // N s or N m s, of the present substep
};

/// A limit, a motor or a spring.
struct JointDriveLanes {
  JointRowLanes row;
  Lanes m;             // kg or kg m^2: impulse per change of u, what is locked staying so
  Lanes lower, upper;  // m or rad: of a limit; of a spring both are its target
  Lanes speed;         // m/s or rad/s, of a motor, of a rotor
  Lanes max_impulse;   // N s or N m s, a substep
  Lanes pull, drag;  // 1/s, 1: a spring's impulse is that of -m (pull x + drag u) - (1 - drag) p = 0, @see spring_of()
};

/// Joints whose rows act one way at A and another at B: all rows of a joint have the same. Apart from the rows, so that
/// joints of one direction are as small as they were.
struct PullLanes {
  LaneVec d_a;                         // world, at A
  LaneVec start_rope_a, start_rope_b;  // m, world, from the anchors to the points, as the step began
  LaneVec rope_a, rope_b;              // as bodies are placed now
  Lanes ratio;                         // of B's rope
};

/// What gears have beside.
struct GearLanes {
  Lanes ratio, phase;        // rad: as the step began
  Lanes turned_a, turned_b;  // rad, about the x axes, since then
  Lanes ahead_a, ahead_b;    // rad, how far they go on in the move to come: which of many turns a pose stands for
};

/// What joints have beside whose axes, or whose turns as one, are locked, driven and sprung.
struct AxesLanes {
  LaneVec turn;     // rad: where turns are locked that are locked alone
  LaneQuat target;  // of a drive to an orientation: B's frame in A's
  struct Pull {
    Lanes stiffness, damping;  // N, N s at 1 m or rad; per mass m/s and 1: all times a substep
    Lanes stiffest;            // m/s at 1 m or rad, per mass, likewise: stiffer is not stable
    Lanes per_mass;            // 1: times the row's mass; else 0
  } pull[kMostDriveRows];      // by row: of springs and stops
  Lanes swing_y, swing_z;      // rad, as counted
  Lanes ahead_y, ahead_z;      // rad, as JointLanes::twist_ahead
};

inline constexpr int kFactor = kMostRows * (kMostRows + 1) / 2;

/// Four joints of one colour with one layout.
struct JointLanes {
  std::uint32_t a[kLanes], b[kLanes];  // solver bodies; 0: none, or none that moves
  std::uint32_t occupied;              // lanes in use, from the first
  std::uint32_t first, first_drive;    // in WideJoints::rows and drives
  std::uint32_t locked;                // in JointRun::locks, from 1; 0: no body of the four is
  std::uint32_t pulled;                // in JointRun::pulls, from 1; 0: rows have one direction
  std::uint32_t geared;                // in JointRun::gears, from 1; 0: it is none
  std::uint32_t axed;                  // in JointRun::axes, from 1; 0: it has none
  JointLayout layout;
  Lanes inv_mass_a, inv_mass_b;                    // 1/kg
  LaneSymmetric start_inertia_a, start_inertia_b;  // inverse, 1/(kg m^2), world, as the step began
  LaneVec start_a, start_b;                        // m, world axes, from the centres of mass to the points, likewise
  LaneVec start_gap;                               // m, world, from A's point to B's, likewise
  LaneQuat start_frame_a, start_frame_b;           // joint -> world, likewise
  Lanes length;                                    // m, of a rod
  Lanes bias_rate, mass_scale, impulse_scale;      // softness, @see soft_step.h
  Lanes again;                                     // 1: half a substep's load comes before the move, half after; else 0

  // as bodies are placed now
  LaneSymmetric inv_inertia_a, inv_inertia_b;
  LaneVec r_a, r_b, gap;
  LaneVec x_a;            // world, A's x axis
  Lanes twist;            // rad, as counted, where the layout counts or has axes
  Lanes twist_ahead;      // rad, how far it goes on in the move to come: which of many turns a pose will stand for
  Lanes factor[kFactor];  // L D L^T of the coupling of the equalities: rows of L, 1/D in its diagonal

  LaneVec force, torque;  // N s, N m s: on B, about its point, since the step began
};

/// A run of joints with their rows and all bodies.
struct JointRun {
  JointLanes* joints;
  std::size_t count;
  JointRowLanes* rows;
  JointDriveLanes* drives;
  BodyVelocity* velocity;
  const BodyShift* shift;
  std::uint32_t first_moved;  // bodies below are not written
  const LockLanes* locks;
  const BodyVelocity* gyro;  // omega: rad/s^2, of bodies that a rotation method carries; null: of none
  PullLanes* pulls;
  GearLanes* gears;
  AxesLanes* axes;
};

}  // namespace carom::dynamics
