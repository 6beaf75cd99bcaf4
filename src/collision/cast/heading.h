// A motion of any length as a direction and a speed.
#pragma once

#include "core/pose.h"

namespace carom::collision {

/// Scaled before it is turned or measured: squares of the largest would overflow.
struct Heading {
  Vec3 unit = Vec3::unit_x();
  Real speed = 0;  // m per unit of time, may be infinite; 0 of no motion

  explicit Heading(const Vec3& motion) : Heading(motion, [](const Vec3& v) { return v; }) {}
  /// As seen from a frame.
  Heading(const Frame& frame, const Vec3& motion)
      : Heading(motion, [&](const Vec3& v) { return frame.rotate_inverse(v); }) {}

 private:
  template <class Turn>
  Heading(const Vec3& motion, const Turn& turn) {
    const Real largest = motion.abs().max_entry();
    if (!(largest > 0)) return;
    const Vec3 scaled = turn(motion / largest);
    unit = scaled / scaled.norm();
    speed = largest * scaled.norm();
  }
};

}  // namespace carom::collision
