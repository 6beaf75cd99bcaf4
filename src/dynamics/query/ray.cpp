// Rays through a world, and shapes that move along a line: what they meet first, whether they meet anything, all that
// they meet.
#include "collision/scenery/ask.h"
#include "dynamics/query/search.h"

namespace carom::dynamics {
namespace {

Aabb ball_hits(Real radius) {
  Aabb b;
  b.lo = Vec3::constant(-radius), b.hi = Vec3::constant(radius);
  return b;
}

Way way_of(const Ray& ray, const CastSettings& settings) {
  return Way(ray.origin, ray.direction, ray.max, ball_hits(settings.target));
}

/// About the query shape's origin; empty if its support function fails.
Aabb extent_of(const QueryShape& query_shape, const CastSettings& settings) {
  SupportFault fault;
  Aabb b = world_bounds(*query_shape.shape, query_shape.frame.r, Vec3::zero(), fault);
  if (is_empty(b)) return b;
  b.lo -= Vec3::constant(settings.target), b.hi += Vec3::constant(settings.target);
  return b;
}

/// The query shape's own support function failed.
CastResult failed() {
  CastResult r;
  r.outcome = CastOutcome::undecided;
  r.status = QueryStatus::fault;
  return r;
}

/// One(slot) is a collider's result; a miss says nothing.
template <class One>
WorldHit first(const World& world, const Way& way, Real max, const QueryOptions& options, One&& one) {
  const QueryIndex& index = *world.queries;
  WorldHit best;
  best.cast.time = best.cast.lower = max;
  const Real width = width_of_brackets(index, options.cast);
  Real limit = kInfinity;
  along(index, way, [&](std::uint32_t slot) {
    if (!passes(world, options.filter, slot)) return limit;
    const WorldHit hit = one(slot);
    if (hit.cast.outcome == CastOutcome::miss || (best.collider != kInvalid && !by_time(hit, best))) return limit;
    best = hit;
    return limit = way.speed * best.cast.time + width;
  });
  return best;
}

template <class One>
CastResult any(const World& world, const Way& way, Real max, const QueryOptions& options, One&& one) {
  bool met = false, unsure = false, bad = false;
  along(*world.queries, way, [&](std::uint32_t slot) -> Real {
    if (met || !passes(world, options.filter, slot)) return met ? -1 : kInfinity;
    const CastResult r = one(slot).cast;
    met = r.outcome == CastOutcome::hit || r.outcome == CastOutcome::overlap;
    bad |= r.status == QueryStatus::fault;
    unsure |= r.outcome == CastOutcome::undecided && r.status != QueryStatus::fault;
    return met ? -1 : kInfinity;
  });
  CastResult r;
  r.outcome = met ? CastOutcome::hit : unsure ? CastOutcome::undecided : CastOutcome::miss;
  if (!met && bad) r.status = QueryStatus::fault;
  r.time = r.lower = met || unsure ? 0 : max;
  return r;
}

template <class One>
void all_hits(const World& world, const Way& way, const QueryOptions& options, Array<WorldHit>& hits, One&& one) {
  const auto begin = static_cast<std::ptrdiff_t>(hits.size());
  along(*world.queries, way, [&](std::uint32_t slot) {
    if (!passes(world, options.filter, slot)) return kInfinity;
    const WorldHit hit = one(slot);
    if (hit.cast.outcome != CastOutcome::miss) hits.push_back(hit);
    return kInfinity;
  });
  std::sort(hits.begin() + begin, hits.end(), by_time);
}

WorldHit ray_on(const World& world, std::uint32_t slot, const Ray& ray, const Way& way, const CastSettings& settings) {
  WorldHit hit;
  SupportFault fault;
  hit.collider = slot;
  any_shape::cast_ray(ray, *world.scene.colliders.shape[slot], world.queries->frame(slot), settings, hit.cast, fault);
  keep_within(way, ray.max, world.queries->bounds(slot), hit.cast);
  return hit;
}

WorldHit shape_on(const World& world, std::uint32_t slot, const QueryShape& query_shape, const Vec3& motion,
                  const Way& way, const CastSettings& settings) {
  WorldHit hit;
  SupportFault fault;
  hit.collider = slot;
  any_shape::cast_shape(*query_shape.shape, query_shape.frame, motion, *world.scene.colliders.shape[slot],
                        world.queries->frame(slot), settings, hit.cast, fault);
  keep_within(way, 1, world.queries->bounds(slot), hit.cast);
  return hit;
}

}  // namespace

bool passes(const World& world, const QueryFilter& filter, std::uint32_t slot) {
  const Colliders& c = world.scene.colliders;
  if (c.body[slot] == filter.ignore || (c.is_sensor(slot) && !filter.sensors)) return false;
  const Filter own = c.filter_of(slot);
  return (own.category & filter.mask) && (own.mask & filter.category);
}

WorldHit ray_against(const World& world, std::uint32_t slot, const Ray& ray, const CastSettings& settings) {
  return ray_on(world, slot, ray, way_of(ray, settings), settings);
}

WorldHit shape_against(const World& world, std::uint32_t slot, const QueryShape& query_shape, const Vec3& motion,
                       const CastSettings& settings) {
  return shape_on(world, slot, query_shape, motion,
                  Way(query_shape.frame.p, motion, 1, extent_of(query_shape, settings)), settings);
}

WorldHit cast_ray(const World& world, const Ray& ray, const QueryOptions& options) {
  world.queries->bring_up_to_date(world);
  const Way way = way_of(ray, options.cast);
  return first(world, way, ray.max, options,
               [&](std::uint32_t slot) { return ray_on(world, slot, ray, way, options.cast); });
}

CastResult any_on_ray(const World& world, const Ray& ray, const QueryOptions& options) {
  world.queries->bring_up_to_date(world);
  const Way way = way_of(ray, options.cast);
  return any(world, way, ray.max, options,
             [&](std::uint32_t slot) { return ray_on(world, slot, ray, way, options.cast); });
}

void cast_ray_all(const World& world, const Ray& ray, const QueryOptions& options, Array<WorldHit>& hits) {
  world.queries->bring_up_to_date(world);
  const Way way = way_of(ray, options.cast);
  all_hits(world, way, options, hits, [&](std::uint32_t slot) { return ray_on(world, slot, ray, way, options.cast); });
}

WorldHit cast_shape(const World& world, const QueryShape& query_shape, const Vec3& motion,
                    const QueryOptions& options) {
  world.queries->bring_up_to_date(world);
  const Aabb extent = extent_of(query_shape, options.cast);
  if (is_empty(extent)) return {kInvalid, failed()};
  const Way way(query_shape.frame.p, motion, 1, extent);
  return first(world, way, 1, options,
               [&](std::uint32_t slot) { return shape_on(world, slot, query_shape, motion, way, options.cast); });
}

CastResult any_on_way(const World& world, const QueryShape& query_shape, const Vec3& motion,
                      const QueryOptions& options) {
  world.queries->bring_up_to_date(world);
  const Aabb extent = extent_of(query_shape, options.cast);
  if (is_empty(extent)) return failed();
  const Way way(query_shape.frame.p, motion, 1, extent);
  return any(world, way, 1, options,
             [&](std::uint32_t slot) { return shape_on(world, slot, query_shape, motion, way, options.cast); });
}

void cast_shape_all(const World& world, const QueryShape& query_shape, const Vec3& motion, const QueryOptions& options,
                    Array<WorldHit>& hits) {
  world.queries->bring_up_to_date(world);
  const Aabb extent = extent_of(query_shape, options.cast);
  if (is_empty(extent)) return hits.push_back({kInvalid, failed()});
  const Way way(query_shape.frame.p, motion, 1, extent);
  all_hits(world, way, options, hits,
           [&](std::uint32_t slot) { return shape_on(world, slot, query_shape, motion, way, options.cast); });
}

}  // namespace carom::dynamics
