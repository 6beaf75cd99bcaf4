/** @file world_query.h
 *  Queries of a world between steps: what rays and moving shapes meet, what overlaps a shape, what is nearest to it;
 *  one by one or many in one call.
 *
 *  All colliders are searched, asleep or awake, static or not, at the poses that bodies have now; not those of bodies
 *  and shapes in quarantine, nor particles, and sensors only with CAROM_ASK_SENSORS. Results do not depend on the broad
 *  phase, on threads or on earlier queries. Each collider's own result is the one of cast.h (or query.h) for it alone,
 *  with the same brackets and proofs; first is what has the least `time` (or separation), of equals the collider in the
 *  lower slot (the low 24 bits of its handle). A collider whose support function misbehaves is reported where its
 *  bounds are, with status CAROM_QUERY_FAULT.
 *
 *  All are readers. The first query after a change brings an index up to date, in time proportional to what moved;
 *  others that come meanwhile wait for it.
 *  @thread world: a call that is named get, is or read is a reader of its world, any other call its writer (world.h).
 */
#ifndef CAROM_WORLD_QUERY_H
#define CAROM_WORLD_QUERY_H

#include <carom/cast.h>
#include <carom/world.h>

#ifdef __cplusplus
extern "C" {
#endif

/* clang-format off */
#define CAROM_WANT_FIRST 0u /* what is met first */
#define CAROM_WANT_ANY 1u   /* whether anything is met: HIT, UNDECIDED (only grazes) or MISS; no collider, times or
                               points */
/* clang-format on */

/** Settings of a query; fill with carom_query_desc_init(). The same for all queries of a call. */
typedef struct carom_query_desc {
  uint32_t struct_size;
  uint32_t flags;      /**< CAROM_ASK_* bits (cast.h), default 0 */
  uint64_t category;   /**< of the query, default all bits: a collider's mask must have a bit of it */
  uint64_t mask;       /**< default all bits: a collider's categories must have a bit of it (by default it has bit 0) */
  carom_body ignore;   /**< its colliders are passed over; default CAROM_NULL_HANDLE: none */
  double tolerance;    /**< as in carom_cast_desc; of distances as in carom_distance_desc; default 1e-6 */
  double target;       /**< m, as in carom_cast_desc: how near counts as contact; default 0 */
  uint32_t iterations; /**< cap, as in carom_cast_desc, default 128 */
  uint32_t reserved;   /**< 0 */
} carom_query_desc;

/** One collider's result. Of casts: as in carom_cast. Of overlaps: outcome OVERLAP with a point in both, or UNDECIDED
 *  within rounding. Of the nearest: separation, lower and upper as in carom_distance, time 0; outcome OVERLAP if it is
 *  negative, else HIT. */
typedef struct carom_world_hit {
  uint32_t outcome;        /**< CAROM_CAST_*; a MISS (or BAD_RAY) has no collider */
  uint32_t status;         /**< CAROM_QUERY_* */
  uint64_t query;          /**< index in the call's arrays */
  carom_collider collider; /**< CAROM_NULL_HANDLE: none; with status FAULT: the query shape misbehaved */
  carom_body body;         /**< the collider's */
  double time;             /**< as in carom_cast */
  double lower;            /**< as in carom_cast; of a distance m */
  double upper;            /**< as in carom_cast; of a distance m */
  double separation;       /**< m */
  double normal[3];        /**< unit, world, from the ray or the query shape to the collider */
  double point[3];         /**< m, world, on the collider's surface */
  double point_own[3];     /**< m, world, on the query shape's surface, or where the ray is */
} carom_world_hit;

/** Query shapes, in the caller's arrays, of float or double, at any stride (0: tightly packed). struct_size and
 *  scalar set by the caller, what is not set zero. */
typedef struct carom_query_shapes {
  uint32_t struct_size;
  uint32_t scalar; /**< CAROM_SCALAR_* of all but shapes */
  uint64_t count;
  const carom_shape *shapes; /**< [count], no half-space; CAROM_NULL_HANDLE: a point. NULL: points all of them */
  const void *positions;     /**< [count] 3 scalars each, m */
  const void *orientations;  /**< [count] 4 scalars each, x, y, z, w; or NULL: identity */
  const void *motions;       /**< [count] 3 scalars each, m, of casts; else NULL */
  uint64_t shape_stride;     /**< bytes */
  uint64_t position_stride;
  uint64_t orientation_stride;
  uint64_t motion_stride;
} carom_query_shapes;

/** Where results of rays go, one each: records, or separate arrays, or both; NULL: not wanted. Strides in bytes, 0:
 *  tightly packed. */
typedef struct carom_world_hits {
  uint32_t struct_size;
  uint32_t scalar;           /**< CAROM_SCALAR_* of times, normals and points */
  carom_world_hit *records;  /**< [count]; a stride shorter than a record gets its prefix */
  uint32_t *outcomes;        /**< [count] */
  carom_collider *colliders; /**< [count] */
  void *times;               /**< [count] 1 scalar; a miss: max; a bad ray: 0 */
  void *normals;             /**< [count] 3 scalars; a miss: 0 */
  void *points;              /**< [count] 3 scalars, `point`; a miss: 0 */
  uint64_t record_stride;
  uint64_t outcome_stride;
  uint64_t collider_stride;
  uint64_t time_stride;
  uint64_t normal_stride;
  uint64_t point_stride;
} carom_world_hits;

/** @status OK; NULL_ARGUMENT; STRUCT_SIZE */
CAROM_API int32_t carom_query_desc_init(carom_query_desc *desc, uint32_t struct_size);

/** What one ray meets first: origin + t direction, 0 <= t <= max.
 *  @param origin [3] m   @param direction [3] m per unit of t, any length   @param max >= 0, may be infinite
 *  @param desc   may be NULL: defaults   @param size sizeof(carom_world_hit) as the caller knows it
 *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; *_HANDLE (desc->ignore); NOT_FINITE; OUT_OF_RANGE;
 *          BUFFER_TOO_SMALL (size); BUSY; OUT_OF_MEMORY   @thread reader */
CAROM_API int32_t carom_world_cast_ray(carom_world *world, const double origin[3], const double direction[3],
                                       double max, const carom_query_desc *desc, carom_world_hit *hit, uint64_t size,
                                       carom_error *error);

/** What each of many rays meets first, or whether it meets anything. A bad ray (not finite, or max negative) spoils no
 *  other: its outcome is CAROM_CAST_BAD_RAY. Nothing is allocated per ray.
 *  @param want   CAROM_WANT_*   @param desc may be NULL: defaults
 *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; UNKNOWN_ENUM; *_HANDLE (desc->ignore); NOT_FINITE;
 *          OUT_OF_RANGE; BUFFER_TOO_SMALL (a stride); BUSY; OUT_OF_MEMORY   @thread reader */
CAROM_API int32_t carom_world_cast_rays(carom_world *world, const carom_rays *rays, uint32_t want,
                                        const carom_query_desc *desc, const carom_world_hits *hits, carom_error *error);

/** All that each of many rays meets: by ray, then by time, then by slot. A bad ray has one record that says so.
 *  @param dst    [capacity] elements `stride` bytes apart; may be NULL if capacity is 0
 *  @param stride sizeof(carom_world_hit) as the caller knows it
 *  @param count  out: how many there are (may exceed capacity; the first `capacity` are written)
 *  @status as carom_world_cast_rays()   @thread reader */
CAROM_API int32_t carom_world_cast_rays_all(carom_world *world, const carom_rays *rays, const carom_query_desc *desc,
                                            carom_world_hit *dst, uint64_t stride, uint64_t capacity, uint64_t *count,
                                            carom_error *error);

/** What each of many shapes meets first as it moves by its motion without turning, or whether it meets anything.
 *  @param shapes every shape, position, orientation and motion must be good, else nothing is written
 *  @param want   CAROM_WANT_*   @param desc may be NULL: defaults
 *  @param dst    [shapes->count] elements `stride` bytes apart   @param stride 0: tightly packed
 *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED (a half-space as query shape); UNKNOWN_ENUM; *_HANDLE;
 *  NOT_FINITE;
 *          NOT_UNIT; OUT_OF_RANGE; BUFFER_TOO_SMALL (a stride); BUSY; OUT_OF_MEMORY   @thread reader */
CAROM_API int32_t carom_world_cast_shapes(carom_world *world, const carom_query_shapes *shapes, uint32_t want,
                                          const carom_query_desc *desc, carom_world_hit *dst, uint64_t stride,
                                          carom_error *error);

/** All that each of many moving shapes meets: by shape, then by time, then by slot; as carom_world_cast_rays_all().
 *  @status as carom_world_cast_rays_all(); NOT_UNIT   @thread reader */
CAROM_API int32_t carom_world_cast_shapes_all(carom_world *world, const carom_query_shapes *shapes,
                                              const carom_query_desc *desc, carom_world_hit *dst, uint64_t stride,
                                              uint64_t capacity, uint64_t *count, carom_error *error);

/** All that overlaps each of many shapes (or is nearer than desc->target): by shape, then by slot; arguments as
 *  carom_world_cast_rays_all().   @status as carom_world_cast_rays_all(); NOT_UNIT   @thread reader */
CAROM_API int32_t carom_world_overlap_shapes(carom_world *world, const carom_query_shapes *shapes,
                                             const carom_query_desc *desc, carom_world_hit *dst, uint64_t stride,
                                             uint64_t capacity, uint64_t *count, carom_error *error);

/** The collider nearest to each of many shapes or points, and where: least signed distance.
 *  @param reach  m, >= 0, may be infinite: farther ones are not looked for (then: MISS)
 *  @param dst    as carom_world_cast_shapes()
 *  @status as carom_world_cast_shapes()   @thread reader */
CAROM_API int32_t carom_world_find_nearest(carom_world *world, const carom_query_shapes *shapes, double reach,
                                           const carom_query_desc *desc, carom_world_hit *dst, uint64_t stride,
                                           carom_error *error);

#ifdef __cplusplus
}
#endif
#endif
