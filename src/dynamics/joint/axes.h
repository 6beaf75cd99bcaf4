// What a six-axis joint does along and about each of its axes, and how a ball is driven as one rotation.
#pragma once

#include <array>

#include "core/pose.h"

namespace carom::dynamics {

inline constexpr std::uint32_t kAxes = 6;    // CAROM_AXIS_*: B's point along A's x, y, z; turns about them
inline constexpr std::uint32_t kPlaces = 3;  // those of them that are places

enum class AxisMode : std::uint8_t { free, locked, limited, count };              // CAROM_AXIS_FREE ...
enum class AxisDrive : std::uint8_t { none, position, velocity, effort, count };  // CAROM_DRIVE_*

/// In what stiffness and damping are told; CAROM_GAINS_*. m: what the joint's bodies weigh along the axis.
enum class Gains : std::uint8_t {
  frequency,     // Hz and a ratio: m (2 pi f)^2, 2 ratio m 2 pi f
  force,         // N/m and N s/m, or N m/rad and N m s/rad
  acceleration,  // 1/s^2 and 1/s: times m
  count
};

/// A spring with its damper.
struct AxisPull {
  Gains gains = Gains::frequency;
  Real stiffness = 0, damping = 0;
  bool on() const { return stiffness > 0 || (gains != Gains::frequency && damping > 0); }
  bool operator==(const AxisPull&) const = default;
};

struct JointAxis {
  AxisMode mode = AxisMode::free;
  Real lower = 0, upper = 0;  // m or rad; locked at lower
  AxisPull stop;              // of a limit; off: it is hard
  AxisDrive drive = AxisDrive::none;
  AxisPull gains;                 // of a drive to a position
  Real target = 0;                // m or rad
  Real speed = 0;                 // m/s or rad/s: of a drive to a velocity, and of a target that moves
  Real effort = 0;                // N or N m
  Real max_force = kInfinity;     // N or N m: of the drive
  AxisPull spring;                // beside the drive
  Real rest = 0;                  // m or rad
  Real friction = 0;              // N or N m, against any motion along the axis
  Real armature = 0;              // kg or kg m^2, of a rotor that turns as the axis does
  Real effort_limit = kInfinity;  // N or N m: of all drives of the axis together
  Real speed_limit = kInfinity;   // m/s or rad/s: of the axis itself, either way, whatever it takes

  bool is_locked() const {
    return mode == AxisMode::locked || (mode == AxisMode::limited && lower == upper && !stop.on());
  }
  bool is_paced() const { return speed_limit < kInfinity && !is_locked(); }
  bool is_limited() const { return mode == AxisMode::limited && !is_locked(); }
  bool operator==(const JointAxis&) const = default;
};

/// What acts along an axis.
enum AxisSource : std::uint8_t { kOfDrive, kOfSpring, kOfLimit, kOfFriction, kOfRotor, kOfSpeed, kAllAxisSources };
inline constexpr int kAxisSources = kOfSpeed;  // whose impulses are kept

struct JointAxes {
  std::array<JointAxis, kAxes> axis;
  // N s, N m s: impulses, by what made them. Of a rotor: m/s or rad/s, by how much it is ahead of its axis as a step ends,
  // for it is slowed and sped up by impulses alone.
  std::array<std::array<Real, kAxisSources>, kAxes> p{};
  std::uint32_t owner = 0;  // slot of its joint

  bool turns_are_free() const { return !axis[3].is_locked() && !axis[4].is_locked() && !axis[5].is_locked(); }
};

/// A drive of all three turns as one: along the shortest way to an orientation.
struct TurnDrive {
  AxisDrive mode = AxisDrive::none;
  AxisPull gains;
  Quat target = Quat::identity();              // B's frame in A's
  Vec3 velocity = Vec3::zero();                // rad/s, A's frame
  Vec3 effort = Vec3::zero();                  // N m, A's frame
  Vec3 max_force = Vec3::constant(kInfinity);  // N m, about each axis of A's frame
  Vec3 p = Vec3::zero();                       // N m s, of a substep, likewise
};

/// Whether such a drive acts at all.
inline bool acts(const TurnDrive& d) {
  return d.mode == AxisDrive::velocity || d.mode == AxisDrive::effort ||
         (d.mode == AxisDrive::position && d.gains.on());
}

}  // namespace carom::dynamics
