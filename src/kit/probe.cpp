// Queries of a world about one shape.
#include "kit/probe.h"

namespace carom::kit {
namespace {

constexpr std::uint64_t kMostMet = 32;  // of one sweep that passes over a body: more are not looked at

Met met_of(const carom_world_hit& hit, const Vec3& motion) {
  Met met;
  met.any = hit.outcome != CAROM_CAST_MISS;
  if (!met.any) return met;
  met.overlap = hit.outcome == CAROM_CAST_OVERLAP;
  met.time = met.overlap ? 0 : smaller(larger(hit.lower, 0.0), 1.0);
  met.separation = hit.separation;
  met.normal = -Vec3::from(hit.normal);
  // What could not be decided, and what misbehaves, is met head-on.
  if (!(met.normal.squared_norm() > 0.5)) met.normal = -motion.normalized();
  met.point = Vec3::from(hit.point);
  met.body = hit.body, met.collider = hit.collider;
  return met;
}

/// As the interface has it.
struct Orientation {
  double xyzw[4];
  explicit Orientation(const Quat& q) : xyzw{q.x(), q.y(), q.z(), q.w()} {}
};

/// A question about one shape. It refers to what it is given.
carom_query_shapes one_shape(const carom_shape& shape, const Vec3& at, const Orientation& orientation) {
  carom_query_shapes query{};
  query.struct_size = sizeof query;
  query.scalar = CAROM_SCALAR_F64;
  query.count = 1;
  query.shapes = &shape;
  query.positions = at.data(), query.orientations = orientation.xyzw;
  return query;
}

}  // namespace

bool Probe::can_follow(const Vec3& v) {
  return v.all_finite() ||
         call_.fail(CAROM_E_OUT_OF_RANGE, argument_, "something moves too far or too fast for numbers");
}

bool Probe::cast(const Vec3& from, const Vec3& motion, Real target, std::uint32_t flags, carom_body skip, Met& met) {
  if (!can_follow(from) || !can_follow(motion)) return false;
  const Orientation orientation(orientation_);
  carom_query_shapes query = one_shape(shape_, from, orientation);
  query.motions = motion.data();
  carom_query_desc desc = desc_;
  desc.target = target, desc.flags = flags;
  carom_error inner = CAROM_ERROR_INIT;
  if (skip == CAROM_NULL_HANDLE || desc.ignore == CAROM_NULL_HANDLE) {
    if (skip != CAROM_NULL_HANDLE) desc.ignore = skip;
    carom_world_hit hit;
    const std::int32_t result =
        carom_world_cast_shapes(world_, &query, CAROM_WANT_FIRST, &desc, &hit, sizeof hit, &inner);
    if (!call_.passed(result, inner, argument_)) return false;
    met = met_of(hit, motion);
    return true;
  }
  carom_world_hit hits[kMostMet];
  std::uint64_t count = 0;
  const std::int32_t result =
      carom_world_cast_shapes_all(world_, &query, &desc, hits, sizeof hits[0], kMostMet, &count, &inner);
  if (!call_.passed(result, inner, argument_)) return false;
  met = Met();
  for (std::uint64_t i = 0; i < smaller(count, kMostMet) && !met.any; ++i)
    if (hits[i].body != skip) met = met_of(hits[i], motion);
  return true;
}

bool Probe::sweep(const Vec3& from, const Vec3& motion, Real gap, carom_body skip, Met& met) {
  const Real along = -1e-9 * motion.norm();  // within rounding of going along
  if (!cast(from, motion, gap, 0, skip, met)) return false;
  // Nearer than the gap to something that it does not go into: a smaller gap keeps the rest in sight.
  for (int i = 0; i < 3 && met.overlap && met.normal.dot(motion) >= along && met.separation > 0; ++i)
    if (!cast(from, motion, 0.5 * met.separation, 0, skip, met)) return false;
  if (met.overlap && met.normal.dot(motion) >= along) return cast(from, motion, 0, CAROM_ASK_IGNORE_TOUCHED, skip, met);
  return true;
}

bool Probe::nearest(const Vec3& at, Real reach, Met& met) {
  if (!can_follow(at)) return false;
  const Orientation orientation(orientation_);
  const carom_query_shapes query = one_shape(shape_, at, orientation);
  carom_world_hit hit;
  carom_error inner = CAROM_ERROR_INIT;
  const std::int32_t result = carom_world_find_nearest(world_, &query, reach, &desc_, &hit, sizeof hit, &inner);
  if (!call_.passed(result, inner, argument_)) return false;
  met = met_of(hit, Vec3::zero());
  return true;
}

bool Probe::ray(const Vec3& from, const Vec3& motion, Met& met) {
  if (!can_follow(from) || !can_follow(motion)) return false;
  carom_world_hit hit;
  carom_error inner = CAROM_ERROR_INIT;
  const std::int32_t result =
      carom_world_cast_ray(world_, from.data(), motion.data(), 1, &desc_, &hit, sizeof hit, &inner);
  if (!call_.passed(result, inner, argument_)) return false;
  met = met_of(hit, motion);
  met.time = hit.time;
  return true;
}

}  // namespace carom::kit
