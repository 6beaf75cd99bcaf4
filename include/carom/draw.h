/** @file draw.h
 *  Debug draw as data: what a world looks like and what happens in it, as coloured lines in one array, for any
 *  renderer. Looking changes nothing: a world that is drawn goes on with the same bits.
 *  @thread world: a call that is named get, is or read is a reader of its world, any other call its writer (world.h).
 */
#ifndef CAROM_DRAW_H
#define CAROM_DRAW_H

#include <carom/world.h>

#ifdef __cplusplus
extern "C" {
#endif

/* What to draw: bits of carom_draw_desc.what, and the kind of a line. */
/* clang-format off */
#define CAROM_DRAW_SHAPES 1u   /* outlines of convex shapes: edges of polytopes, three sections' silhouettes of all
                                  others */
#define CAROM_DRAW_SCENERY 2u  /* sides of a mesh's or height field's triangles */
#define CAROM_DRAW_BOUNDS 4u   /* boxes about colliders, along the world's axes; none of half-spaces */
#define CAROM_DRAW_CONTACTS 8u /* of the last step: from each point along its normal, `scale` long */
#define CAROM_DRAW_JOINTS 16u  /* frames of both ends (x red, y green, z blue), and what is between them */
#define CAROM_DRAW_BODIES 32u  /* frames of bodies about their centres of mass */
/* clang-format on */

/** How lines are coloured where their kind does not say: by body type (static grey, kinematic blue, dynamic sand,
 *  asleep dim), or a colour for each island, what hangs together by contacts of the last step and joints. */
#define CAROM_DRAW_BY_TYPE 0u
#define CAROM_DRAW_BY_ISLAND 1u /* one colour an island */

typedef struct carom_draw_desc {
  uint32_t struct_size;
  uint32_t what;      /**< CAROM_DRAW_* bits, default SHAPES | CONTACTS | JOINTS */
  uint32_t colouring; /**< CAROM_DRAW_BY_*, default BY_TYPE */
  uint32_t reserved;  /**< 0 */
  double scale;       /**< m, length of normals and axes, default 0.2; > 0 */
} carom_draw_desc;

/** @status OK; NULL_ARGUMENT; STRUCT_SIZE */
CAROM_API int32_t carom_draw_desc_init(carom_draw_desc *desc, uint32_t struct_size);

typedef struct carom_draw_line {
  double from[3], to[3]; /**< m, world */
  uint32_t colour;       /**< 0xRRGGBBAA */
  uint32_t kind;         /**< one CAROM_DRAW_* bit */
  carom_body body;       /**< that it belongs to; of a contact B; CAROM_NULL_HANDLE: the world's */
} carom_draw_line;

/** All lines of the kinds that desc names, kind by kind in the order of the bits. Shapes whose support function fails
 *  are left out, and so are bodies in quarantine. The same world gives the same lines.
 *  @param desc     NULL: defaults
 *  @param dst      [capacity] elements `stride` bytes apart (0: sizeof(carom_draw_line)), or NULL to count
 *  @param count    out: lines there are; more than capacity: the first `capacity` of them were written
 *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED (a bit of what, reserved); UNKNOWN_ENUM; NOT_FINITE,
 *          OUT_OF_RANGE (scale); BUFFER_TOO_SMALL (stride); BUSY; REENTRANT; OUT_OF_MEMORY
 *  @thread reader */
CAROM_API int32_t carom_world_draw(carom_world *world, const carom_draw_desc *desc, carom_draw_line *dst,
                                   uint64_t stride, uint64_t capacity, uint64_t *count, carom_error *error);

#ifdef __cplusplus
}
#endif
#endif
