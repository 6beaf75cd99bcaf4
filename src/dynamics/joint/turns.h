// Angles of joints that count whole turns. A pose tells an angle only up to whole turns; the count is state.
//
// A joint remembers its angles as they were counted last (Joint::turned). Each substep takes, of all angles that a pose
// stands for, the one nearest to where the joint was and to what its velocity leads to. So what turns by many radians a
// substep is counted, too.
#pragma once

#include <numbers>

#include "dynamics/joint/joint.h"
#include "dynamics/world.h"

namespace carom::dynamics {

inline constexpr Real kWholeTurn = 2 * std::numbers::pi;  // rad

/// Of all angles that differ from one by whole turns, the nearest to another. rad
/// @accuracy  rounding of the larger
inline Real nearest_turn(Real angle, Real near) {
  return angle + kWholeTurn * std::nearbyint((near - angle) / kWholeTurn);
}

/// About which axis a six-axis joint swings, where the other swing is locked at 0: that swing is then an angle, and the
/// twist is told about the axis that it has turned. Else the two are a rotation vector.
enum class SwingPlane : std::uint8_t { none, about_y, about_z };
SwingPlane swing_plane(const JointAxes& axes);

/// rad, as a pose alone tells them: the twist in (-pi, pi] and the swing about y and z, at most pi long.
/// @param q  B's frame in A's
/// @accuracy  1e-15 / cos(swing / 2); in a plane 1e-15
Vec3 told_angles(const Quat& q, SwingPlane plane);

/// Of all that stand for the same pose, the nearest to another.
/// @param told  told_angles()
Vec3 nearest_angles(const Vec3& told, const Vec3& near, SwingPlane plane);

/// How fast those change. rad/s   @param w  of B relative to A, A's frame   @param at  the angles, as counted
/// @accuracy  rounding of w, times 1 / cos(swing / 2) of a twist; 0 along what has no direction
Vec3 rates_of_angles(const Quat& q, SwingPlane plane, const Vec3& at, const Vec3& w);

/// Whether a kind leaves such an angle free. Those of others are what their pose tells.
inline bool counts_turns(JointKind kind) {
  return kind == JointKind::ball || kind == JointKind::hinge || kind == JointKind::six_axis;
}

/// The angles of a joint, as counted. Between steps a host may have moved its bodies, by a way that is not known. So that
/// counts the shorter way; where this ends far beyond limits and another angle of the same pose lies within, it is that.
Vec3 counted_angles(const World& world, const Joint& joint, const JointEnds& ends);

/// The angles of a pose that a motion led to in a time.   @param w  rad/s, of B relative to A, world
Vec3 led_angles(const World& world, const Joint& joint, const JointEnds& ends, const Vec3& from, const Vec3& w, Real t);

/// After a step: of the pose, the nearest to what the joint was led to.
/// @param near  rad, by the last rows; null: no row looked at its angles
void count_angles(const World& world, Joint& joint, const Vec3* near, Real dt);

/// A joint is new: its angles are those that its pose tells.
void start_count(const World& world, Joint& joint);
/// Its limits are new: where they lie more than half a turn away, whole turns are forgotten.
void recount(const World& world, Joint& joint);

/// rad, by pose alone.
Vec3 told_angles(const World& world, const Joint& joint);
inline constexpr Real kMostCounted = 1e15;  // rad: beyond, whole turns are less than rounding

/// By how much the angles of a joint change in a time, by the velocities there are, where that is too much to be seen by
/// poses; else 0. rad   @param at  the angles, as counted
Vec3 turns_ahead(const World& world, const Joint& joint, const Vec3& at, Real t);
inline constexpr Real kNearby = 1;  // rad: what turns less in a substep is seen by its poses

}  // namespace carom::dynamics
