// Queries of a world about one shape, by the public interface: what it meets first, what is nearest, what a ray meets.
#pragma once

#include <carom/world_query.h>

#include "core/pose.h"
#include "kit/check.h"

namespace carom::kit {

/// What was met.
struct Met {
  bool any = false;
  bool overlap = false;        // the start is within the target distance already
  Real time = 0;               // share of the motion that is free, proven
  Real separation = 0;         // m; of an overlap at the start
  Vec3 normal = Vec3::zero();  // unit, world, from what was met to the shape
  Vec3 point = Vec3::zero();   // m, world, on what was met
  carom_body body = CAROM_NULL_HANDLE;
  carom_collider collider = CAROM_NULL_HANDLE;
};

/// A shape at an orientation, and what its queries see. All functions return false after a failure, which `call` has.
class Probe {
 public:
  /// @param argument  of our caller, which a refused shape is due to
  Probe(Call& call, carom_world* world, int argument) : call_(call), world_(world), argument_(argument) {
    carom_query_desc_init(&desc_, sizeof desc_);
    desc_.tolerance = 1e-7;
  }
  void look_for(std::uint64_t category, std::uint64_t mask, carom_body ignore) {
    desc_.category = category, desc_.mask = mask, desc_.ignore = ignore;
  }
  void set_shape(carom_shape shape, const Quat& orientation) { shape_ = shape, orientation_ = orientation; }

  /// Move the shape from `from` by `motion`, `gap` clear of all.
  /// Within that gap of something at the start, what it moves away from or along does not stop it.
  /// @param skip  a body that is passed over
  bool sweep(const Vec3& from, const Vec3& motion, Real gap, carom_body skip, Met& met);
  /// What is nearest within `reach`.   @param met  separation, normal; point
  bool nearest(const Vec3& at, Real reach, Met& met);
  bool ray(const Vec3& from, const Vec3& motion, Met& met);

 private:
  /// Bodies may have numbers that are legal and too large all the same.
  bool can_follow(const Vec3& v);
  bool cast(const Vec3& from, const Vec3& motion, Real target, std::uint32_t flags, carom_body skip, Met& met);

  Call& call_;
  carom_world* world_;
  int argument_;
  carom_query_desc desc_;
  carom_shape shape_ = CAROM_NULL_HANDLE;
  Quat orientation_ = Quat::identity();
};

}  // namespace carom::kit
