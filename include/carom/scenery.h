/** @file scenery.h
 *  Scenery: surfaces of many triangles (a mesh, a height field) as one shape, for static and kinematic bodies.
 *
 *  Scenery collides only at its surface: bodies slide over sides between triangles as over one surface, and a sharp
 *  edge or a boundary edge is an edge. A one-sided surface is met from the side from which its triangles' corners run
 *  counter-clockwise, by bodies whose centre is on that side; from behind it is passed through, by rays too. A
 *  two-sided one is met from both.
 *
 *  All queries of a world support scenery (world_query.h). carom_ray_cast, carom_shape_cast,
 *  carom_shape_time_of_impact, carom_shape_overlap and carom_shape_distance do too, with the scenery as the second
 *  shape where one moves. Functions that need convex shapes (carom_shape_support, carom_rays_cast; query shapes of a
 *  world) say UNSUPPORTED.
 *  @thread engine: any thread, also while worlds of the engine step (engine.h).
 */
#ifndef CAROM_SCENERY_H
#define CAROM_SCENERY_H

#include <carom/shape.h>

#ifdef __cplusplus
extern "C" {
#endif

#define CAROM_SCENERY_TWO_SIDED 1u /* a bit of flags: met from both sides */

/** A triangle mesh. Corners at the same place are made one, so vertices may be repeated; triangles without area are
 *  dropped (carom_scenery_info counts them). Two triangles that share a side are one surface there; a side of one alone
 *  is a boundary edge, and so is a side of three. Fill with carom_mesh_desc_init(). */
typedef struct carom_mesh_desc {
  uint32_t struct_size;
  uint32_t flags;            /**< CAROM_SCENERY_* bits, default 0 */
  const double *vertices;    /**< [3 vertex_count] m, shape frame; within 1e8 of the origin */
  uint64_t vertex_count;     /**< at least 3 */
  const uint32_t *triangles; /**< [3 triangle_count] indices of vertices, counter-clockwise seen from outside */
  uint64_t triangle_count;   /**< 1 to 2^28 */
} carom_mesh_desc;

/** @status OK; NULL_ARGUMENT; STRUCT_SIZE */
CAROM_API int32_t carom_mesh_desc_init(carom_mesh_desc *desc, uint32_t struct_size);

/** Make scenery of a mesh. All is copied.
 *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; NOT_FINITE; OUT_OF_RANGE (a count, an index, a vertex too far
 *          out, no triangle that has an area); LIMIT; OUT_OF_MEMORY */
CAROM_API int32_t carom_shape_create_mesh(carom_engine *engine, const carom_mesh_desc *desc, carom_shape *shape,
                                          carom_error *error);

/** A height field: vertices at (column spacing[0], height, row spacing[1]) in the shape's frame, met from above (+y).
 *  Each cell is two triangles, divided from its first corner (column, row) to (column + 1, row + 1). What has its
 *  middle in the ground, by no more than its bounding radius, is lifted out. Fill with carom_height_field_desc_init().
 *  */
typedef struct carom_height_field_desc {
  uint32_t struct_size;
  uint32_t flags;        /**< 0 */
  uint32_t columns;      /**< along x, 2 to 2^14 */
  uint32_t rows;         /**< along z, 2 to 2^14 */
  const double *heights; /**< [rows][columns] m; NaN: no vertex, the cells around it are a hole */
  double spacing[2];     /**< m, along x and z, default 1 */
} carom_height_field_desc;

/** @status OK; NULL_ARGUMENT; STRUCT_SIZE */
CAROM_API int32_t carom_height_field_desc_init(carom_height_field_desc *desc, uint32_t struct_size);

/** Make scenery of a height field. All is copied.
 *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; NOT_FINITE (an infinite height, a spacing); OUT_OF_RANGE (a
 *          count, a spacing that is not positive, a height too far out, nothing but holes); LIMIT; OUT_OF_MEMORY */
CAROM_API int32_t carom_shape_create_height_field(carom_engine *engine, const carom_height_field_desc *desc,
                                                  carom_shape *shape, carom_error *error);

/** Counts of a surface: what the engine keeps of the arrays that made it. */
typedef struct carom_scenery_info {
  uint32_t struct_size;    /**< sizeof(carom_scenery_info), set by the caller */
  uint32_t flags;          /**< CAROM_SCENERY_* bits, as given */
  uint64_t triangles;      /**< how many there are: their indices run from 0 to `triangles - 1`. Of a mesh those that
                             are left: triangle_count - dropped. Of a height field 2 (columns - 1) (rows - 1): the two
                             triangles of a cell count whether they are there or a hole */
  uint64_t vertices;       /**< of a mesh: vertices after equal ones were made one; of a height field columns rows, NaN
                             ones included */
  uint64_t dropped;        /**< triangles of the mesh that were left out, because they have no area (least height below
                             1e-12 of the longest side); 0 for a height field */
  uint64_t boundary_edges; /**< sides of a triangle with no triangle beyond. 0 for a closed surface. Many
                             in a surface that should be closed: its triangles do not share corners, and bodies will
                             feel the gaps */
  uint64_t bytes;          /**< of memory, about */
} carom_scenery_info;

/** @status OK; NULL_ARGUMENT; STRUCT_SIZE (set info->struct_size); *_HANDLE; UNSUPPORTED (a convex shape) */
CAROM_API int32_t carom_shape_get_scenery_info(carom_engine *engine, carom_shape shape, carom_scenery_info *info,
                                               carom_error *error);

/** Copy out triangles of scenery, for drawing: each by its three corners, as its surface faces. Holes are left out.
 *  @param first   number of the first triangle wanted
 *  @param corners [9 count] m, shape frame, or NULL to count
 *  @param count   in: how many fit; out: how many were written (with NULL: how many there are from `first` on)
 *  @param next    out: the number of the triangle to go on from; the number of triangles when all have been seen
 *  @status OK; NULL_ARGUMENT; *_HANDLE; OUT_OF_RANGE (first); UNSUPPORTED (a convex shape) */
CAROM_API int32_t carom_shape_get_triangles(carom_engine *engine, carom_shape shape, uint64_t first, double *corners,
                                            uint64_t *count, uint64_t *next, carom_error *error);

#ifdef __cplusplus
}
#endif
#endif
