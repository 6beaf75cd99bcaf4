// Questions to a world: what a ray or a moving shape meets, what overlaps a shape, what is nearest to it.
//
// All functions may be called by several threads at once, while nothing changes the world. They allocate nothing but
// the space of the lists they fill. A half-space can be met, but asks no questions.
#pragma once

#include "collision/cast/cast.h"
#include "collision/cast/overlap.h"
#include "collision/cast/ray.h"
#include "dynamics/world.h"

namespace carom::dynamics {

/// Which colliders are asked.
struct QueryFilter {
  std::uint64_t category = ~std::uint64_t(0);  // of the question: a collider's mask must have a bit of it
  std::uint64_t mask = ~std::uint64_t(0);      // a collider's categories must have a bit of it
  std::uint32_t ignore = kInvalid;             // a body's slot: its colliders are passed over
  bool sensors = false;                        // sensors are asked, too
};

struct QueryOptions {
  QueryFilter filter;
  CastSettings cast;
};

/// One collider's result. `cast` is that of collision/cast/ for this collider alone; one whose support function
/// misbehaves has status fault, at the time (or distance) at which its bounds are met.
struct WorldHit {
  std::uint32_t collider = kInvalid;  // slot; kInvalid: nothing is met
  CastResult cast;
};

/// A shape at a place, that asks.
struct QueryShape {
  const Shape* shape;  // not a half-space
  Frame frame;         // shape -> world
};

/// What is met first: least time, of equals the lowest slot.
WorldHit cast_ray(const World& world, const Ray& ray, const QueryOptions& options);
WorldHit cast_shape(const World& world, const QueryShape& query_shape, const Vec3& motion, const QueryOptions& options);

/// Whether anything is met: outcome hit; undecided where nothing is but neither is a graze ruled out; else miss, with
/// status fault if a support function misbehaved. No collider, no time.
CastResult any_on_ray(const World& world, const Ray& ray, const QueryOptions& options);
CastResult any_on_way(const World& world, const QueryShape& query_shape, const Vec3& motion,
                      const QueryOptions& options);

/// All that is met, appended by time, of equals by slot.
void cast_ray_all(const World& world, const Ray& ray, const QueryOptions& options, Array<WorldHit>& hits);
void cast_shape_all(const World& world, const QueryShape& query_shape, const Vec3& motion, const QueryOptions& options,
                    Array<WorldHit>& hits);

/// What overlaps (or comes nearer than options.cast.target), appended by slot: outcome overlap, or undecided within
/// rounding; point_a = point_b: in both.
void find_overlaps(const World& world, const QueryShape& query_shape, const QueryOptions& options,
                   Array<WorldHit>& hits);

/// What is nearest: least signed distance, of equals the lowest slot.
/// @param reach  m, >= 0: what is farther is not looked for
/// @return       cast: outcome overlap if that is negative, else hit; separation in [lower, upper] (m, not times),
///               normal, points
WorldHit find_nearest(const World& world, const QueryShape& query_shape, Real reach, const QueryOptions& options);

// The result of one collider for each, as the index has it: what the twins of the tests are made of.
bool passes(const World& world, const QueryFilter& filter, std::uint32_t slot);
WorldHit ray_against(const World& world, std::uint32_t slot, const Ray& ray, const CastSettings& settings);
WorldHit shape_against(const World& world, std::uint32_t slot, const QueryShape& query_shape, const Vec3& motion,
                       const CastSettings& settings);
WorldHit overlap_against(const World& world, std::uint32_t slot, const QueryShape& query_shape,
                         const CastSettings& settings);
WorldHit nearest_against(const World& world, std::uint32_t slot, const QueryShape& query_shape, Real reach,
                         const CastSettings& settings);

}  // namespace carom::dynamics
