// What is left of a motion that surfaces forbid: the nearest motion that goes into none of them. In closed form, so that
// nothing is sent to and fro between the sides of a corner.
#pragma once

#include "core/vec.h"

namespace carom::kit {

inline constexpr int kMostPlanes = 8;

/// Normals of surfaces that a motion must not go into.
struct Planes {
  Vec3 normals[kMostPlanes];  // unit
  int count = 0;

  /// A normal that is known already is not added again. @return whether it is new, and there was space
  bool add(const Vec3& normal) {
    for (int i = 0; i < count; ++i)
      if (normals[i].dot(normal) > 1 - 1e-12) return false;
    if (count == kMostPlanes) return false;
    normals[count++] = normal;
    return true;
  }
  /// Within rounding of a motion of length `size`.
  bool allow(const Vec3& motion, Real size) const {
    for (int i = 0; i < count; ++i)
      if (motion.dot(normals[i]) < -1e-12 * size) return false;
    return true;
  }
};

/// The longest vector of those offered that planes allow.
class Longest {
 public:
  Longest(const Planes& planes, Real size) : planes_(planes), size_(size) {}
  void offer(const Vec3& v) {
    const Real n2 = v.squared_norm();
    if (n2 > most_ && planes_.allow(v, size_)) best_ = v, most_ = n2;
  }
  bool any() const { return most_ > 0; }
  const Vec3& best() const { return best_; }

 private:
  const Planes& planes_;
  Real size_, most_ = 0;
  Vec3 best_ = Vec3::zero();
};

/// The longest projection of a motion on one of the planes that all allow; none where the motion has to follow a crease.
inline Longest slide_along_one(const Vec3& motion, const Planes& planes, Real size) {
  Longest longest(planes, size);
  for (int i = 0; i < planes.count; ++i) longest.offer(motion - motion.dot(planes.normals[i]) * planes.normals[i]);
  return longest;
}

/// The nearest vector to `motion` with v . n >= 0 for all planes: the projection on a cone. It is the longest of the
/// projections on faces of the cone (itself, a plane, a crease) that all planes allow.
/// @param motion  any; result of the same unit
/// @accuracy      1e-12 of its length
inline Vec3 slide(const Vec3& motion, const Planes& planes) {
  const Real size = motion.norm();
  if (planes.allow(motion, size)) return motion;
  Longest longest = slide_along_one(motion, planes, size);
  if (longest.any()) return longest.best();
  for (int i = 0; i < planes.count; ++i)
    for (int j = 0; j < i; ++j) {
      const Vec3 crease = planes.normals[i].cross(planes.normals[j]);
      const Real n2 = crease.squared_norm();
      if (n2 > 1e-12) longest.offer((motion.dot(crease) / n2) * crease);
    }
  return longest.best();
}

/// Likewise of a motion across `up`, where walls stand upright: their normals are across `up`, too. In a plane a crease
/// is a point.
inline Vec3 slide_across(const Vec3& motion, const Planes& walls) {
  const Real size = motion.norm();
  return walls.allow(motion, size) ? motion : slide_along_one(motion, walls, size).best();
}

}  // namespace carom::kit
