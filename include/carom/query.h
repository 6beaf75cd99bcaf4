/** @file query.h
 *  Queries about two shapes at given poses, without a world.
 *  @thread engine: any thread, also while worlds of the engine step (engine.h).
 */
#ifndef CAROM_QUERY_H
#define CAROM_QUERY_H

#include <carom/shape.h>

#ifdef __cplusplus
extern "C" {
#endif

#define CAROM_QUERY_EXACT_ENOUGH 0u /* the bracket is as narrow as the tolerance wants */
#define CAROM_QUERY_CAPPED 1u       /* the iteration cap came first; the bracket still holds */
#define CAROM_QUERY_ROUNDING 2u     /* rounding stopped it; the bracket still holds */
#define CAROM_QUERY_FAULT 3u        /* a support function misbehaved; nothing else is meaningful */

/** Settings of a query; fill with carom_distance_desc_init(). Values as the dials of the same name. */
typedef struct carom_distance_desc {
  uint32_t struct_size;
  uint32_t simplex;        /**< CAROM_SIMPLEX_*, default VORONOI_LAST */
  uint32_t narrow_phase;   /**< CAROM_NARROW_*, default GJK_EPA */
  uint32_t pair_routines;  /**< 0: always the generic path; 1: a specific routine where there is one; default 0 */
  double tolerance;        /**< relative width of the bracket, default 1e-6 */
  double hybrid_margin;    /**< m, for CAROM_NARROW_HYBRID */
  uint32_t gjk_iterations; /**< cap, default 128 */
  uint32_t epa_iterations; /**< cap, default 256 */
} carom_distance_desc;

/** The result: signed distance (negative: depth of the smallest separating translation) and its bracket. */
typedef struct carom_distance {
  uint32_t struct_size;
  uint32_t status;         /**< CAROM_QUERY_* */
  double separation;       /**< m */
  double lower;            /**< m, separation >= lower */
  double upper;            /**< m, separation <= upper */
  double normal[3];        /**< unit, world, from A to B */
  double point_a[3];       /**< m, world, on the surface of A */
  double point_b[3];       /**< m, world, on the surface of B */
  uint32_t gjk_iterations; /**< taken by GJK */
  uint32_t epa_iterations; /**< taken by EPA, of shapes that overlap */
  uint32_t support_calls;  /**< single calls, A and B together */
  uint32_t reserved;
} carom_distance;

/** @status OK; NULL_ARGUMENT; STRUCT_SIZE */
CAROM_API int32_t carom_distance_desc_init(carom_distance_desc *desc, uint32_t struct_size);

/** Signed distance of two shapes.
 *  @param position_*     [3] m     @param orientation_* [4] x, y, z, w
 *  @param desc   may be NULL: defaults     @param result struct_size set by the caller
 *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; UNKNOWN_ENUM;
 *          UNSUPPORTED (two half-spaces) */
CAROM_API int32_t carom_shape_distance(carom_engine *engine, carom_shape shape_a, const double position_a[3],
                                       const double orientation_a[4], carom_shape shape_b, const double position_b[3],
                                       const double orientation_b[4], const carom_distance_desc *desc,
                                       carom_distance *result, carom_error *error);

#ifdef __cplusplus
}
#endif
#endif
