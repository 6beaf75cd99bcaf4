/** @file shape.h
 *  Shapes: a plugin plus parameters, immutable, shared by any number of colliders and worlds.
 *  @thread engine: any thread, also while worlds of the engine step (engine.h).
 */
#ifndef CAROM_SHAPE_H
#define CAROM_SHAPE_H

#include <carom/engine.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Make a shape. The parameters are copied. The support function is checked for these parameters (finite, repeatable,
 *  scale-free, samples in convex position), declarations are verified, and AABB and mass properties derived.
 *  @param params [count] doubles, meaning as the plugin documents
 *  @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE (count or a bound; argument says which);
 *          PLUGIN_INVALID; DECLARATION_FALSE; OUT_OF_MEMORY */
CAROM_API int32_t carom_shape_create(carom_engine *engine, carom_plugin plugin, const double *params, uint64_t count,
                                     carom_shape *shape, carom_error *error);

/** Make a shape by the name of its plugin: "box", or "carom.box", or the id of a plugin of yours. Plugins that the
 *  engine has come first, by id, then by the name of the file they were loaded from. Then a file NAME.so is looked for
 *  and loaded: in the folders of $CAROM_PLUGIN_PATH (absolute, separated by ':'; not in programs that run with raised
 *  privileges), beside the library, in the folder where plugins are installed. "half_space" is built in: normal x, y,
 *  z, offset.
 *  @param name 1 to 64 letters, digits, _, - and dots   @param params [count] as carom_shape_create()
 *  @status OK; NULL_ARGUMENT; NOT_FOUND (the message says where it was looked for); NOT_FINITE; OUT_OF_RANGE;
 *          PLUGIN_PATH; PLUGIN_LOAD; PLUGIN_ABI; PLUGIN_INVALID; DECLARATION_FALSE; LIMIT; OUT_OF_MEMORY */
CAROM_API int32_t carom_shape_create_named(carom_engine *engine, const char *name, const double *params, uint64_t count,
                                           carom_shape *shape, carom_error *error);

/** The built-in half-space { x : normal . x <= offset } in the shape's own frame; unbounded, so static bodies only.
 *  @param normal [3] unit (within 1e-6)   @param offset m
 *  @status OK; NULL_ARGUMENT; NOT_FINITE; NOT_UNIT; OUT_OF_MEMORY */
CAROM_API int32_t carom_shape_create_half_space(carom_engine *engine, const double normal[3], double offset,
                                                carom_shape *shape, carom_error *error);

/** Make the convex hull of shapes that the engine has, each placed and scaled, and all of it rounded by a radius. The
 *  same call makes
 *  - the sweep of a shape along a straight line, without turning: the shape at both ends. Where it turns as well, the hull
 *    of both ends leaves out what bulges between them: add poses in between;
 *  - a scaled shape: one part with a scale. A negative scale mirrors it;
 *  - a rounded shape: one part and a radius, by which it grows on all sides.
 *  Where all parts have corners only and the radius is 0, the hull is a polytope with exact mass and faces, and its
 *  corners are its parameters. Else its parameters are none and its mass is derived. A part cannot be destroyed before
 *  the hull.
 *  @param parts         [count] handles of convex shapes, the same one as often as wanted
 *  @param count         1 to 4096
 *  @param positions     [3 * count] m, frame of the hull; NULL: 0
 *  @param orientations  [4 * count] x, y, z, w, unit within 1e-6, part to hull; NULL: identity
 *  @param scales        [3 * count] along the axes of the part, of a size of 1e-6 to 1e6; NULL: 1
 *  @param radius        m, 0 or more
 *  @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; UNSUPPORTED (a part is a half-space or scenery);
 *          PLUGIN_INVALID; LIMIT (hulls of hulls more than 8 deep, or of more than 4096 parts in all); OUT_OF_MEMORY
 *  @since 0.9 */
CAROM_API int32_t carom_shape_create_hull_of(carom_engine *engine, const carom_shape *parts, uint64_t count,
                                             const double *positions, const double *orientations, const double *scales,
                                             double radius, carom_shape *shape, carom_error *error);

/** What a hull of shapes is made of, as it was given. Of any other shape: no parts, radius 0.
 *  @param parts         [*count] or NULL: only count and radius are written
 *  @param positions     [3 * *count] m, or NULL   @param orientations [4 * *count] x, y, z, w, or NULL
 *  @param scales        [3 * *count] or NULL
 *  @param count         in: capacity in parts; out: number of parts
 *  @param radius        m, or NULL
 *  @status OK; NULL_ARGUMENT; *_HANDLE; BUFFER_TOO_SMALL (count says how many are needed)
 *  @since 0.9 */
CAROM_API int32_t carom_shape_get_parts(carom_engine *engine, carom_shape shape, carom_shape *parts, double *positions,
                                        double *orientations, double *scales, uint64_t *count, double *radius,
                                        carom_error *error);

/** @status OK; NULL_ARGUMENT; *_HANDLE; IN_USE (a collider, a hull of shapes, or a query on another thread, refers to
 *          it); REENTRANT */
CAROM_API int32_t carom_shape_destroy(carom_engine *engine, carom_shape shape, carom_error *error);

/** What the engine knows of a shape. Quantities are for unit density (1 kg/m^3) in the shape's own frame; each derived
 *  one comes with a rigorous bracket. A half-space has infinite bounds and volume 0. */
typedef struct carom_shape_info {
  uint32_t struct_size;
  uint32_t form;          /**< CAROM_FORM_*, verified; NONE for a general convex set and the half-space */
  uint32_t is_half_space; /**< 1: the built-in half-space */
  uint32_t mass_exact;    /**< 1: mass properties come from a verified closed form, brackets have zero width */
  carom_plugin plugin;    /**< CAROM_NULL_HANDLE for the half-space */
  uint64_t param_count;   /**< as carom_shape_get_params() gives it */
  double core_radius;     /**< m */
  double bounding_radius; /**< m, about the shape's origin */
  double aabb_min[3];     /**< m, exact to rounding */
  double aabb_max[3];     /**< m */
  double volume;          /**< m^3, best estimate, within [volume_min, volume_max] */
  double volume_min;      /**< m^3, lower bound */
  double volume_max;      /**< m^3, upper bound */
  double centroid[3];     /**< m */
  double centroid_error;  /**< m, upper bound of |error| */
  double inertia[9];      /**< m^5, about the centroid, row-major, symmetric */
  double inertia_error;   /**< m^5, upper bound of the spectral norm of the error */
  uint32_t is_scenery;    /**< 1: a mesh or a height field (scenery.h); it has no volume */
  uint32_t reserved;      /**< 0 */
} carom_shape_info;

/** @status OK; NULL_ARGUMENT; STRUCT_SIZE (set info->struct_size); *_HANDLE */
CAROM_API int32_t carom_shape_get_info(carom_engine *engine, carom_shape shape, carom_shape_info *info,
                                       carom_error *error);

/** Copy out the parameters. @param count in: capacity of params; out: number of parameters.
 *  @param params [count]
 *  @status OK; NULL_ARGUMENT; *_HANDLE; BUFFER_TOO_SMALL (count says how many are needed) */
CAROM_API int32_t carom_shape_get_params(carom_engine *engine, carom_shape shape, double *params, uint64_t *count,
                                         carom_error *error);

/** Support points of the whole shape, core radius included, for n directions at once.
 *  @param dirs [3n] nonzero, any length, shape frame   @param points [3n] m, shape frame
 *  @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE (a zero direction); UNSUPPORTED (half-space,
 *          scenery); PLUGIN_INVALID (the support function failed; the points before are written) */
CAROM_API int32_t carom_shape_support(carom_engine *engine, carom_shape shape, const double *dirs, uint64_t n,
                                      double *points, carom_error *error);

#ifdef __cplusplus
}
#endif
#endif
