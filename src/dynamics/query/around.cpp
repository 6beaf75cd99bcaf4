// What overlaps a shape in a world, and what is nearest to it.
#include "collision/narrow/rounding.h"
#include "collision/scenery/ask.h"
#include "dynamics/query/search.h"

namespace carom::dynamics {
namespace {

Aabb bounds_of(const QueryShape& query_shape) {
  SupportFault fault;
  return world_bounds(*query_shape.shape, query_shape.frame.r, query_shape.frame.p, fault);
}

WorldHit failed(std::uint32_t slot) {
  WorldHit hit;
  hit.collider = slot;
  hit.cast.outcome = CastOutcome::undecided;
  hit.cast.status = QueryStatus::fault;
  return hit;
}

/// m, from below.
Real between(const Aabb& a, const Aabb& b) { return (a.lo - b.hi).max(b.lo - a.hi).max(Vec3::zero()).norm(); }

}  // namespace

WorldHit overlap_against(const World& world, std::uint32_t slot, const QueryShape& query_shape,
                         const CastSettings& settings) {
  const Frame& frame = world.queries->frame(slot);
  SupportFault fault;
  const OverlapResult found =
      any_shape::overlap(*query_shape.shape, *world.scene.colliders.shape[slot], relative(query_shape.frame, frame),
                         settings.target, kPoseRounding * kUnitRoundoff, settings.cap, fault);
  WorldHit hit;
  hit.collider = slot;
  CastResult& r = hit.cast;
  r.slack = found.slack;
  r.support_calls = r.iterations = found.support_calls;
  if (found.outcome == Overlap::fault)  // found where its bounds say
    return between(bounds_of(query_shape), world.queries->bounds(slot)) <= settings.target ? failed(slot) : hit;
  if (found.outcome == Overlap::apart) return hit;
  r.outcome = found.outcome == Overlap::overlapping ? CastOutcome::overlap : CastOutcome::undecided;
  if (r.outcome == CastOutcome::undecided) r.status = QueryStatus::rounding;
  r.point_a = r.point_b = query_shape.frame.apply(found.point);
  return hit;
}

void find_overlaps(const World& world, const QueryShape& query_shape, const QueryOptions& options,
                   Array<WorldHit>& hits) {
  world.queries->bring_up_to_date(world);
  const Aabb box = bounds_of(query_shape);
  if (is_empty(box)) return hits.push_back(failed(kInvalid));
  const auto begin = static_cast<std::ptrdiff_t>(hits.size());
  const Real reach = options.cast.target * (1 + 1e-6);
  around(*world.queries, box, reach, [&](std::uint32_t slot) {
    if (!passes(world, options.filter, slot)) return reach;
    const WorldHit hit = overlap_against(world, slot, query_shape, options.cast);
    if (hit.cast.outcome != CastOutcome::miss) hits.push_back(hit);
    return reach;
  });
  std::sort(hits.begin() + begin, hits.end(),
            [](const WorldHit& a, const WorldHit& b) { return a.collider < b.collider; });
}

WorldHit nearest_against(const World& world, std::uint32_t slot, const QueryShape& query_shape, Real reach,
                         const CastSettings& settings) {
  const Frame& frame = world.queries->frame(slot);
  const Shape &a = *query_shape.shape, &b = *world.scene.colliders.shape[slot];
  QuerySettings query;
  query.routines = settings.routines;
  query.tolerance = settings.tolerance;
  query.max_distance = reach;
  query.gjk_cap = settings.cap;
  query.epa_cap = 2 * settings.cap;
  const Frame b_in_a = relative(query_shape.frame, frame);
  QueryResult found;
  SupportFault fault;
  any_shape::distance(a, b, b_in_a, query, nullptr, found, fault);
  WorldHit hit;
  hit.collider = slot;
  CastResult& r = hit.cast;
  if (found.status == QueryStatus::fault) {
    const Real apart = between(bounds_of(query_shape), world.queries->bounds(slot));
    if (!(apart <= reach)) return hit;
    hit = failed(slot);
    r.separation = r.lower = apart;
    return hit;
  }
  if (found.farther || !(found.separation <= reach)) return hit;
  r.outcome = found.separation < 0 ? CastOutcome::overlap : CastOutcome::hit;
  r.status = found.status;
  r.separation = found.separation;
  r.slack = kPoseRounding * kUnitRoundoff * (b_in_a.p.norm() + extent(a) + extent(b));
  r.lower = found.lower - r.slack;
  r.upper = found.upper + r.slack;
  r.normal = query_shape.frame.rotate(found.normal);
  r.point_a = query_shape.frame.apply(found.point_a);
  r.point_b = frame.apply(found.point_b);
  r.support_calls = found.support_calls;
  r.iterations = found.gjk_iterations + found.epa_iterations;
  return hit;
}

WorldHit find_nearest(const World& world, const QueryShape& query_shape, Real reach, const QueryOptions& options) {
  const QueryIndex& index = *world.queries;
  world.queries->bring_up_to_date(world);
  const Aabb box = bounds_of(query_shape);
  if (is_empty(box)) return failed(kInvalid);
  WorldHit best;
  // Of a distance a bracket is known, as wide as the tolerance times the smaller of both; of a point, the other.
  const Real width = 2 * width_of_brackets(index, options.cast);
  around(index, box, reach + width, [&](std::uint32_t slot) {
    if (passes(world, options.filter, slot)) {
      const WorldHit hit = nearest_against(world, slot, query_shape, reach, options.cast);
      if (hit.cast.outcome != CastOutcome::miss &&
          (best.collider == kInvalid || before(hit.cast.separation, slot, best.cast.separation, best.collider)))
        best = hit;
    }
    return (best.collider == kInvalid ? reach : best.cast.separation) + width;
  });
  return best;
}

}  // namespace carom::dynamics
