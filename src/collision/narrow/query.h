// One question: the signed distance of two shapes, with a bracket that is true whatever happens.
#pragma once

#include <algorithm>

#include "collision/shape.h"
#include "core/pose.h"

namespace carom::collision {

enum class Simplex : std::uint32_t { johnson, voronoi, voronoi_last };
enum class Method : std::uint32_t { hybrid, gjk_epa };

struct QuerySettings {
  Simplex simplex = Simplex::voronoi_last;
  Method method = Method::gjk_epa;
  bool routines = true;           // use a specific routine where both shapes declare a closed form
  Real tolerance = 1e-6;          // stop when upper - lower <= tolerance * size_of_pair()
  Real margin = 1e-3;             // m, shell around each shape under Method::hybrid
  Real max_distance = kInfinity;  // m: farther apart than this, "farther" is enough (lower > max_distance)
  int gjk_cap = 128;
  int epa_cap = 256;
};

enum class QueryStatus : std::uint32_t { exact_enough, capped, rounding, fault };

/// Signed distance: positive apart, negative the length of the smallest translation that separates.
struct QueryResult {
  QueryStatus status = QueryStatus::exact_enough;
  bool farther = false;       // stopped early: lower > max_distance; separation, normal and points are then estimates
  Real separation = 0;        // m, in [lower, upper]
  Real lower = 0, upper = 0;  // m
  Vec3 normal = Vec3::unit_x();  // unit, A's frame, from A to B
  Vec3 point_a = Vec3::zero();   // m, A's frame, on A's surface
  Vec3 point_b = Vec3::zero();   // m, B's frame, on B's surface
  int gjk_iterations = 0, epa_iterations = 0, support_calls = 0;
};

/// What a query proved, and the pose that it proved it for.
struct Certificate {
  bool known = false;
  Real shell = 0;                // m: thickness of shells it was computed with
  Real lower = 0, upper = 0;     // m, signed distance
  Vec3 normal = Vec3::unit_x();  // unit, A's frame, attains the lower bound
  Vec3 point_a = Vec3::zero();   // m, A's frame
  Vec3 point_b = Vec3::zero();   // m, B's frame
  Frame b_in_a;                  // B's frame in A's
};

/// What one query leaves for the next one of the same pair.
struct QueryMemory {
  Vec3 direction = Vec3::zero();  // A's frame: last separating direction (A to B); zero: none yet
};

/// The length that tolerances are relative to: the smaller bounding radius. A point has none; against a point it is the
/// other shape's, and between two points their distance, so that a result exact to rounding is exact enough. Against a
/// half-space it is the other shape's, whatever that is.
/// @return m, 0 for two points in one place, whose bracket has no width either
inline Real size_of_pair(const Shape& a, const Shape& b, const Frame& b_in_a) {
  if (a.form == Form::half_space) return b.bounding_radius;
  if (b.form == Form::half_space) return a.bounding_radius;
  const Real least = std::min(a.bounding_radius, b.bounding_radius),
             most = std::max(a.bounding_radius, b.bounding_radius);
  return least > 0 ? least : (most > 0 ? most : b_in_a.p.norm());
}

/// Signed distance of two convex shapes by the generic path (GJK, EPA, hybrid). Neither may be a half-space.
/// @param b_in_a  pose of B in A's frame
/// @param memory  may be null: no warm start
/// @param fault   filled when a support function misbehaves; result.status is then fault
void generic_distance(const Shape& a, const Shape& b, const Frame& b_in_a, const QuerySettings& settings,
                      QueryMemory* memory, QueryResult& result, SupportFault& fault);

/// Signed distance of any two shapes, by a specific routine if settings.routines and there is one, else generic. One of them may be a
/// half-space (solved with one support call), not both.
void distance(const Shape& a, const Shape& b, const Frame& b_in_a, const QuerySettings& settings, QueryMemory* memory,
              QueryResult& result, SupportFault& fault);

}  // namespace carom::collision
