// Joints of a world: two bodies (or one and the world), a frame on each, and what of their relative motion is locked,
// limited, driven or sprung.
//
// A kind of joint is a list of parts (parts.h). The frame's x axis is the axis of a hinge or a slider, and the one that
// swing and twist are told by. Signs: coordinates, forces and torques are those of B relative to A.
#pragma once

#include <array>

#include "core/pool.h"
#include "dynamics/joint/axes.h"

namespace carom::dynamics {

enum class JointKind : std::uint8_t {
  ball,
  hinge,
  slider,
  weld,
  distance,
  universal,
  pulley,
  gear,
  six_axis,
  coupling,
  count  // CAROM_JOINT_*
};

/// Whether a kind turns one motion into another.
inline bool has_transmission(JointKind kind) { return kind == JointKind::pulley || kind == JointKind::gear; }

/// Whether it holds the coordinates of two other joints to each other, and no bodies of its own.
inline bool is_coupling(JointKind kind) { return kind == JointKind::coupling; }

/// What may be limited, driven or sprung of a joint; as CAROM_COORDINATE_*.
enum class Coordinate : std::uint8_t {
  twist,     // rad, of B about the x axes, whole turns counted
  swing,     // rad, between the x axes, [0, pi]
  slide,     // m, of B's point along A's x axis
  distance,  // m, between the points; of a pulley, of its ropes: that of A and ratio times that of B
  count
};
inline constexpr std::size_t kCoordinates = static_cast<std::size_t>(Coordinate::count);

struct JointLimit {
  bool on = false;
  Real lower = 0, upper = 0;  // m or rad
  bool operator==(const JointLimit&) const = default;
};
struct JointMotor {
  bool on = false;
  Real speed = 0;      // m/s or rad/s
  Real max_force = 0;  // N or N m
  bool operator==(const JointMotor&) const = default;
};
struct JointSpring {
  bool on = false;
  Real target = 0;             // m or rad
  Real frequency = 1;          // Hz, of the joint's bodies were they alone
  Real damping = 1;            // ratio; 1: critical
  Real max_force = kInfinity;  // N or N m
  bool operator==(const JointSpring&) const = default;
};

/// What acts on one coordinate.
struct JointDrive {
  JointLimit limit;
  JointMotor motor;
  JointSpring spring;
  bool on() const { return limit.on || motor.on || spring.on; }
  bool operator==(const JointDrive&) const = default;
};

/// What a host says about a joint (ABI: carom_joint_desc), already validated.
struct JointDef {
  JointKind kind = JointKind::ball;
  std::uint32_t body_a = kInvalid, body_b = kInvalid;      // slots; the world's frame is the world
  Pose frame_a, frame_b;                                   // joint -> body frame (origin as the host gave it)
  Real length = 0;                                         // m, of a distance joint
  bool collide = false;                                    // its bodies may touch each other
  bool measured = false;                                   // each step notes its accelerations
  Real break_force = kInfinity, break_torque = kInfinity;  // N, N m, mean over a step
  std::uint64_t user = 0;
};

/// By what a joint turns the motion of one body into that of the other.
struct Transmission {
  Real ratio = 0;  // how often B's rope or turn counts; 0: of a pulley, none is strung
  Vec3 anchor_a = Vec3::zero(), anchor_b = Vec3::zero();  // m, world: what the ropes run over
  Real length = 0;                                        // m, of the ropes: that of A and ratio times that of B
  // Of a gear: angle of A + ratio * angle of B, about their x axes, each relative to the world, as they have turned since
  // the gear was set. No pose says how often a body has turned: this is kept along.
  Real phase = 0;  // rad
};

/// What makes the coordinate of one joint follow that of another: the twist of a hinge, the slide of a slider.
struct Coupling {
  static constexpr int kTerms = 5;
  std::uint32_t follower = kInvalid, leader = kInvalid;  // slots of joints
  std::array<Real, kTerms> polynomial{};                 // follower = sum of polynomial[k] leader^k; m and rad
  std::uint32_t owner = 0;                               // slot of its joint
};

using AxisRates = std::array<Real, kAxes>;  // m/s and rad/s, by axis, or how fast those change

inline constexpr int kMostEqualities = 6;
inline constexpr int kMostDrives = 4;  // rows that limit, drive or spring, of one joint

/// A joint as it lives. Impulses are of a substep and in its own rows; the next step starts from them.
struct Joint {
  JointDef def;
  std::array<JointDrive, kCoordinates> drive;
  Transmission transmission;
  bool broken = false;
  bool without_limits = false, without_motors = false;  // a host forbids them, as of the last plan

  std::array<Real, kMostEqualities> p{};               // N s, N m s
  std::array<Real, kMostDrives> drive_p{};             // likewise, by row of the layout
  Real p_h = 0;                                        // s, the substep that made them; 0: there are none
  Vec3 force = Vec3::zero();                           // N, world, on B, mean over the last step
  Vec3 torque = Vec3::zero();                          // N m, world, on B about its point, likewise
  std::uint32_t next_a = kInvalid, next_b = kInvalid;  // the next joint of each body
  std::uint32_t axes = 0;                              // in Joints::axes, from 1; 0: no axis has properties of its own
  std::uint32_t coupling = 0;                          // in Joints::couplings, from 1; 0: it is none
  TurnDrive turn;                                      // of a ball, or of a six-axis joint that may turn any way
  Vec3 turned = Vec3::zero();  // rad: twist, and swing about y and z of six axes, as counted last, @see turns.h
  AxisRates acceleration{};  // m/s^2 and rad/s^2, if it is measured: what the last step did to its rates, over its time
};

/// The axis along or about which a hinge or slider moves, and what acts there apart from it; of other kinds X, and nothing.
inline std::uint32_t own_axis(JointKind kind) { return kind == JointKind::hinge ? kPlaces : 0; }
inline const JointDrive& own_drive(const Joint& joint) {
  static constexpr JointDrive kNone{};
  const bool turns = joint.def.kind == JointKind::hinge;
  return turns || joint.def.kind == JointKind::slider
             ? joint.drive[static_cast<std::size_t>(turns ? Coordinate::twist : Coordinate::slide)]
             : kNone;
}

/// Of a joint that has none: all are free.
inline constexpr JointAxes kFreeAxes{};

struct Joints {
  Joints(std::uint32_t tag, Memory* m) : slots(Kind::joint, tag, m), joint(m), axes(m), couplings(m), first(m) {}

  SlotPool slots;
  Array<Joint> joint;          // by slot
  Array<JointAxes> axes;       // of six-axis joints, and of hinges and sliders whose axis a host has set; in no order
  Array<Coupling> couplings;   // in no order
  Array<std::uint32_t> first;  // by body slot: its first joint, or kInvalid; empty until there is a joint
  std::uint32_t measured = 0;  // joints whose accelerations steps note

  bool alive(std::uint32_t slot) const { return slots.alive(slot); }
  const JointAxes& axes_of(const Joint& j) const { return j.axes ? axes[j.axes - 1] : kFreeAxes; }
  const Coupling& coupling_of(const Joint& j) const { return couplings[j.coupling - 1]; }
  JointAxes* axes_of(Joint& j) { return j.axes ? &axes[j.axes - 1] : nullptr; }
  /// No impulses any more: rows stand for something else now.
  void clear_impulses(Joint& j) {
    j.p.fill(0), j.drive_p.fill(0), j.turn.p.set_zero();
    if (JointAxes* const a = axes_of(j)) a->p = {};
  }
  /// f(slot, other body or kInvalid) for the joints of a body.
  template <class F>
  void each_of(std::uint32_t body, F&& f) const {
    if (body >= first.size()) return;
    for (std::uint32_t j = first[body]; j != kInvalid;) {
      const Joint& joint_j = joint[j];
      const bool is_a = joint_j.def.body_a == body;
      const std::uint32_t next = is_a ? joint_j.next_a : joint_j.next_b;
      f(j, is_a ? joint_j.def.body_b : joint_j.def.body_a);
      j = next;
    }
  }
  bool any_of(std::uint32_t body) const { return body < first.size() && first[body] != kInvalid; }
};

/// Where a joint's frames are.
struct JointEnds {
  Pose a, b;          // joint -> world
  Vec3 arm_a, arm_b;  // m, world axes, from the centres of mass; zero at the world's end
  Vec3 apart;         // m, world, from A's point to B's
};
/// And how far it is from what it locks.
struct JointPlace : JointEnds {
  std::array<Real, kCoordinates> at;  // m or rad
  Vec3 turned = Vec3::zero();         // rad, as Joint::turned
  Real gap = 0;                       // m, of what is locked of the points
  Real angle = 0;                     // rad, of what is locked of the axes
};

}  // namespace carom::dynamics
