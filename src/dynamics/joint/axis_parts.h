// What the axes of a six-axis joint come to in rows, and where they are.
#pragma once

#include "dynamics/joint/joint.h"
#include "dynamics/joint/joint_lanes.h"

namespace carom::dynamics {

/// Parts that lock a joint's axes: together where a part of the other kinds is the same, else one by one.
struct LockedParts {
  std::uint32_t count = 0;
  JointPart part[kMostParts] = {};
  const JointPart* begin() const { return part; }
  const JointPart* end() const { return part + count; }
  void add(JointPart p) { part[count++] = p; }
};
LockedParts locked_parts(const JointAxes& axes);

/// Where axes are locked.
struct AxisOffsets {
  Vec3 place = Vec3::zero();  // m, A's frame; 0 where free
  Vec3 turn = Vec3::zero();   // rad, likewise
  bool all_turns = false;     // all three are locked, B's frame in A's at
  Quat orientation = Quat::identity();
};
AxisOffsets offsets_of(const JointAxes& axes);

/// Rows of what drives, springs and limits axes, and of a drive to an orientation.
void add_axis_drives(const Joints& joints, const Joint& joint, JointLayout& layout);
/// Parts of layout_key().
inline constexpr std::uint64_t kOwnDrive = std::uint64_t(1)
                                           << 54;  // and the next: motor, spring, limit of a hinge or slider
std::uint64_t axes_key(const Joints& joints, const Joint& joint);
std::uint64_t turn_key(const Joint& joint, const JointAxes& axes);

/// Where the impulse of a drive's row is kept between steps.   @param k  the row, of its layout
Real& impulse_of(JointAxes* axes, Joint& joint, const DriveRow& row, std::uint32_t k);
Real kept_impulse(const JointAxes& axes, const Joint& joint, const DriveRow& row, std::uint32_t k);

/// What pulls an axis, frequencies made into gains.
struct PullGains {
  Real k, c;     // as AxisPull says, per mass or not
  Real fastest;  // rad/s, a quarter of the substep rate: no frequency is higher
};
PullGains gains_of(const AxisPull& pull, Real h);
/// How many pull at an axis, at least 1: together they are no stiffer than a substep carries.
int pulls_on(const JointAxis& axis);

/// N or N m, the most that a drive may give for the limit of its axis: an even share of it.
Real share_of_limit(const JointAxes& axes, const Joint& joint, const DriveRow& row);

struct DrivenAxes {
  bool limited, driven;
};
DrivenAxes driven_axes(const Joints& joints, const Joint& joint);

/// Where B's frame is in A's: m along A's x, y, z; rad, the twist about x and the swing's rotation vector along y, z, of
/// q = swing * twist, whole turns counted.
/// @param turned  counted_angles(), @see turns.h
/// @accuracy  places: rounding of the bodies' positions; angles 1e-15 / cos(swing / 2) rad
std::array<Real, kAxes> axes_at(const JointEnds& ends, const Vec3& turned);

/// How far a six-axis joint is off what it locks, and beyond hard limits.
JointPlace judge_axes(const JointAxes& axes, JointPlace place);

}  // namespace carom::dynamics
