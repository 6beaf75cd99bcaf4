// What calls about joints share: the joint they are about, and bounds of numbers.
#pragma once

#include <carom/joint.h>

#include <numbers>

#include "abi/world.h"

namespace carom::abi {

inline constexpr double kLongestJoint = 1e9, kFastestMotor = 1e6, kStrongestMotor = 1e30, kStiffest = 1e4,
                        kMostDamping = 1e3;
inline constexpr double kMostTurned = 1e3;  // rad, of limits and targets of angles that count turns

/// What a limit or a target of a coordinate may be; by CAROM_COORDINATE_*. m or rad
struct CoordinateBounds {
  double low, high;
};
inline CoordinateBounds bounds_of(std::uint32_t coordinate) {
  switch (coordinate) {
    case CAROM_COORDINATE_TWIST:
      return {-kMostTurned, kMostTurned};
    case CAROM_COORDINATE_SWING:
      return {0, std::numbers::pi};
    case CAROM_COORDINATE_SLIDE:
      return {-kLongestJoint, kLongestJoint};
    default:
      return {0, kLongestJoint};
  }
}

/// Argument 2 of a call.
inline bool resolve_joint(Call& call, const World& world, carom_joint joint) {
  return resolve(call, 2, "joint", world.joints.slots, joint);
}

}  // namespace carom::abi
