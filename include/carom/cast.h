/** @file cast.h
 *  Where and when: rays, moving and turning shapes against shapes at given poses, overlap; without a world.
 *
 *  Every result is a bracket. Contact begins at a time in [lower, upper]: before `lower` the separation is proven to
 *  exceed the target, and within the bracket it comes down to target + slack or less. (For the closest points of two
 *  shapes at rest call carom_shape_distance().)
 *
 *  Within slack, which is rounding of the numbers given, these rules decide:
 *    - A ray that grazes a surface or runs in the plane of a side is a HIT. So flush shapes have no gap for it, nor
 *      have triangles of a mesh or height field. Within the plane of a triangle it is a MISS: that has no thickness.
 *    - A shape that moves, a ray with a target too, is not stopped by what it grazes or slides along: MISS.
 *    - What starts in touch and goes in is a HIT at time 0. What goes along or away is a MISS. A triangle is gone into
 *      against its normal. (Not of a time of impact: it reports what touches at time 0.)
 *  @thread engine: any thread, also while worlds of the engine step (engine.h).
 */
#ifndef CAROM_CAST_H
#define CAROM_CAST_H

#include <carom/body.h>
#include <carom/query.h>

#ifdef __cplusplus
extern "C" {
#endif

/* clang-format off */
#define CAROM_CAST_MISS 0u      /* no contact within the motion, proven */
#define CAROM_CAST_HIT 1u       /* contact begins within the motion */
#define CAROM_CAST_OVERLAP 2u   /* one is in the other already at the start: time 0 */
#define CAROM_CAST_UNDECIDED 3u /* the cap came first, or numbers are too large: neither was proven. `lower`
                                   holds */
#define CAROM_CAST_BAD_RAY 4u   /* of a batch: this ray is not finite, or its max is negative; it was not cast */
/* clang-format on */

/* bits of flags, of carom_cast_desc and carom_query_desc */
#define CAROM_ASK_GENERIC 1u /* support functions only, no routine for declared forms */
#define CAROM_ASK_SENSORS 2u /* sensors are found, too; of a world only */
/** What a ray or a shape touches or overlaps at its start is passed over: that collider. Of a mesh or height field it
 *  is each triangle touched, and for a shape each other one that the motion does not go into. Overlaps and the nearest
 *  do not use it. */
#define CAROM_ASK_IGNORE_TOUCHED 4u

/** How to cast; fill with carom_cast_desc_init(). */
typedef struct carom_cast_desc {
  uint32_t struct_size;
  /** cap, 1 to 10000, default 128: support calls of a ray or linear cast, distances of a time of impact */
  uint32_t iterations;
  /** width of the bracket as length of path, relative to the (smaller) bounding radius; of a time of impact: separation
   *  that counts as contact, likewise; bounds of the dial gjk_tolerance, default 1e-6 */
  double tolerance;
  double target; /**< m, 0 to 1e9, default 0: separation that counts as contact (a ray becomes a ball of this radius) */
  uint32_t flags;    /**< CAROM_ASK_GENERIC, CAROM_ASK_IGNORE_TOUCHED, default 0 */
  uint32_t reserved; /**< 0 */
} carom_cast_desc;

/** The result. Numbers of a fault (status CAROM_QUERY_FAULT) mean nothing. */
typedef struct carom_cast {
  uint32_t struct_size;
  uint32_t outcome;    /**< CAROM_CAST_* */
  uint32_t status;     /**< CAROM_QUERY_*: is the bracket as narrow as desc wants */
  uint32_t iterations; /**< of the search for the time */
  double time;         /**< in [lower, upper]; fraction of the direction or motion, s for a time of impact */
  double lower;        /**< a miss: end of the motion */
  double upper;        /**< infinite unless in contact */
  double separation;   /**< m, at `time`; the depth (negative) of shapes that overlap at the start */
  double slack;        /**< m, see above: rounding, or the tolerance where a time of impact found a mere touch */
  double normal[3];  /**< unit, world, from A (or the ray) to B, so opposed to the surface that a ray meets; a ray that
                               starts inside: its direction; zero for a miss */
  double point_a[3]; /**< m, world, at `time`: on the surface of A; of a ray: where it is */
  double point_b[3]; /**< m, world, at `time`: on the surface of B */
  uint32_t support_calls; /**< single calls, A and B together */
  uint32_t reserved;
} carom_cast;

/** A shape that travels and turns: its centre at constant velocity, the shape about its centre at constant angular
 *  velocity. Fill with carom_motion_init(). */
typedef struct carom_motion {
  uint32_t struct_size;
  uint32_t reserved;          /**< 0 */
  double position[3];         /**< m, world: origin of the shape at the start */
  double orientation[4];      /**< x, y, z, w; default identity */
  double center[3];           /**< m, in the shape's frame: what it turns about; default its origin */
  double linear_velocity[3];  /**< m/s, world, of the centre */
  double angular_velocity[3]; /**< rad/s, world */
} carom_motion;

/* clang-format off */
#define CAROM_OVERLAP_APART 0u       /* proven by `normal`: along it the shapes are at least separation_bound apart */
#define CAROM_OVERLAP_OVERLAPPING 1u /* proven by `point`, which is in both */
#define CAROM_OVERLAP_TOUCHING 2u    /* within rounding (slack) of touching, or the cap came first: neither was
                                        proven */
#define CAROM_OVERLAP_FAULT 3u       /* a support function misbehaved; nothing else is meaningful */
/* clang-format on */

typedef struct carom_overlap {
  uint32_t struct_size;
  uint32_t outcome;        /**< CAROM_OVERLAP_* */
  double separation_bound; /**< m; apart: the separation is at least this */
  double normal[3];        /**< unit, world, from A to B; apart */
  double point[3];         /**< m, world; overlapping: in both shapes (between them, if the target is not 0) */
  double slack;            /**< m, what rounding may have done to the proof */
  uint32_t support_calls;  /**< single calls, A and B together */
  uint32_t reserved;
} carom_overlap;

/** @status OK; NULL_ARGUMENT; STRUCT_SIZE */
CAROM_API int32_t carom_cast_desc_init(carom_cast_desc *desc, uint32_t struct_size);
/** @status OK; NULL_ARGUMENT; STRUCT_SIZE */
CAROM_API int32_t carom_motion_init(carom_motion *motion, uint32_t struct_size);

/** Cast the ray origin + t direction, 0 <= t <= max, against a shape.
 *  @param position, orientation  of the shape: [3] m, [4] x, y, z, w
 *  @param origin [3] m   @param direction [3] m per unit of t, any length; zero asks whether the origin is inside
 *  @param max    >= 0, may be infinite
 *  @param desc   may be NULL: defaults     @param result struct_size set by the caller
 *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; UNSUPPORTED */
CAROM_API int32_t carom_ray_cast(carom_engine *engine, carom_shape shape, const double position[3],
                                 const double orientation[4], const double origin[3], const double direction[3],
                                 double max, const carom_cast_desc *desc, carom_cast *result, carom_error *error);

/** Move shape A along a straight line, without turning it, until it touches B.
 *  @param motion [3] m, of A; times are fractions of it. If B moves too: the difference of the two
 *  @param desc   may be NULL: defaults     @param result struct_size set by the caller
 *  @param position_* [3] m, world   @param orientation_* [4] x, y, z, w
 *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; UNSUPPORTED (two
 *          half-spaces) */
CAROM_API int32_t carom_shape_cast(carom_engine *engine, carom_shape shape_a, const double position_a[3],
                                   const double orientation_a[4], const double motion[3], carom_shape shape_b,
                                   const double position_b[3], const double orientation_b[4],
                                   const carom_cast_desc *desc, carom_cast *result, carom_error *error);

/** First contact of two shapes that both travel and turn, within a duration. UNDECIDED: the cap came first, nothing
 *  touches before `lower`.
 *  @param motion_*  struct_size set by carom_motion_init()   @param duration s, 0 to 1e9
 *  @param desc   may be NULL: defaults     @param result struct_size set by the caller; times in s
 *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE;
 *          UNSUPPORTED (two half-spaces, or one that turns) */
CAROM_API int32_t carom_shape_time_of_impact(carom_engine *engine, carom_shape shape_a, const carom_motion *motion_a,
                                             carom_shape shape_b, const carom_motion *motion_b, double duration,
                                             const carom_cast_desc *desc, carom_cast *result, carom_error *error);

/** Do two shapes overlap (or come nearer than desc->target)? Cheaper than their distance, with a proof of yes or no.
 *  @param desc   may be NULL: defaults; tolerance is not used   @param result struct_size set by the caller
 *  @param position_* [3] m, world   @param orientation_* [4] x, y, z, w
 *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; UNSUPPORTED (two
 *          half-spaces) */
CAROM_API int32_t carom_shape_overlap(carom_engine *engine, carom_shape shape_a, const double position_a[3],
                                      const double orientation_a[4], carom_shape shape_b, const double position_b[3],
                                      const double orientation_b[4], const carom_cast_desc *desc, carom_overlap *result,
                                      carom_error *error);

/* ---- many rays ---- */
#define CAROM_NO_SHAPE 0xFFFFFFFFu /* in place of an index: no shape */

/** Rays in the caller's arrays, of float or double, at any stride (0: tightly packed). struct_size and scalar set by
 *  the caller, what is not set zero. */
typedef struct carom_rays {
  uint32_t struct_size;
  uint32_t scalar; /**< CAROM_SCALAR_* of all three */
  uint64_t count;
  const void *origins;    /**< [count] 3 scalars each, m */
  const void *directions; /**< [count] 3 scalars each, any length */
  const void *max;        /**< [count] or NULL: 1 each */
  uint64_t origin_stride; /**< bytes */
  uint64_t direction_stride;
  uint64_t max_stride;
} carom_rays;

/** What one ray met. */
typedef struct carom_ray_hit {
  uint32_t outcome; /**< CAROM_CAST_*, BAD_RAY too */
  uint32_t status;  /**< CAROM_QUERY_* */
  uint32_t shape;   /**< index in the list of shapes; CAROM_NO_SHAPE: none */
  uint32_t reserved;
  double time;      /**< as in carom_cast */
  double lower;     /**< as in carom_cast */
  double upper;     /**< as in carom_cast */
  double normal[3]; /**< unit, world, as in carom_cast */
  double point[3];  /**< m, world, on the shape's surface */
} carom_ray_hit;

/** Where results go: records, or separate arrays, or both; NULL: not wanted. Strides in bytes, 0: tightly packed. */
typedef struct carom_ray_hits {
  uint32_t struct_size;
  uint32_t scalar;        /**< CAROM_SCALAR_* of times, normals and points */
  carom_ray_hit *records; /**< [count]; a stride shorter than a record gets its prefix */
  uint32_t *outcomes;     /**< [count] */
  uint32_t *shapes;       /**< [count] */
  void *times;            /**< [count] 1 scalar; a miss: max; a bad ray: 0 */
  void *normals;          /**< [count] 3 scalars; a miss: 0 */
  void *points;           /**< [count] 3 scalars; a miss: 0 */
  uint64_t record_stride;
  uint64_t outcome_stride;
  uint64_t shape_stride;
  uint64_t time_stride;
  uint64_t normal_stride;
  uint64_t point_stride;
} carom_ray_hits;

/** Cast many rays against one or more shapes: the first hit of each. A bad ray, or one for which a support function
 *  misbehaves (status CAROM_QUERY_FAULT, that of `shape`), spoils no other. Nothing is allocated per ray.
 *  @param shapes [shape_count]   @param positions [3 shape_count] m   @param orientations [4 shape_count] x, y, z, w
 *  @param desc   may be NULL: defaults
 *  @param shape_count number of shapes
 *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; UNKNOWN_ENUM; UNSUPPORTED;
 *          BUFFER_TOO_SMALL (a stride); LIMIT (2^32 - 1 shapes); OUT_OF_MEMORY */
CAROM_API int32_t carom_rays_cast(carom_engine *engine, const carom_shape *shapes, const double *positions,
                                  const double *orientations, uint64_t shape_count, const carom_rays *rays,
                                  const carom_cast_desc *desc, const carom_ray_hits *hits, carom_error *error);

#ifdef __cplusplus
}
#endif
#endif
