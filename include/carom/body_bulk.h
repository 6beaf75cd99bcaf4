/** @file body_bulk.h
 *  One call for n bodies: their handles, and one field of each, as arrays of the caller's.
 *
 *  @thread world: a call that is named get, is or read is a reader of its world, any other call its writer (world.h).
 */
#ifndef CAROM_BODY_BULK_H
#define CAROM_BODY_BULK_H

#include <carom/body.h>

#ifdef __cplusplus
extern "C" {
#endif

#define CAROM_FIELD_POSITION 0u         /* 3: m, world, origin of the body frame */
#define CAROM_FIELD_ORIENTATION 1u      /* 4: x, y, z, w */
#define CAROM_FIELD_POSE 2u             /* 7: position, orientation */
#define CAROM_FIELD_LINEAR_VELOCITY 3u  /* 3: m/s, world, of the centre of mass */
#define CAROM_FIELD_ANGULAR_VELOCITY 4u /* 3: rad/s, world */
#define CAROM_FIELD_VELOCITY 5u         /* 6: linear, angular */
#define CAROM_FIELD_FORCE 6u            /* 6: N and N m, world, pending for the next step; writing replaces it */
#define CAROM_FIELD_CENTER 7u           /* 3: m, world, centre of mass; read only */
#define CAROM_FIELD_MASS 8u             /* 1: kg; read only */
#define CAROM_FIELD_COUNT 9u

/** Number of bodies, and their handles in creation order of the slots.
 *  @param handles [capacity] or NULL   @param count out: how many there are
 *  @status OK; NULL_ARGUMENT; BUSY */
CAROM_API int32_t carom_world_get_bodies(carom_world *world, carom_body *handles, uint64_t capacity, uint64_t *count,
                                         carom_error *error);

/** Read one field of n bodies.
 *  @param handles [n], or NULL for all bodies in the order of carom_world_get_bodies() (n must be their number)
 *  @param dst     n records of the field's scalars, `stride` bytes apart
 *  @param stride  bytes from one record to the next; 0: tightly packed
 *  @param field   CAROM_FIELD_*
 *  @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; *_HANDLE (nothing is written); OUT_OF_RANGE (n); BUFFER_TOO_SMALL (stride);
 *  BUSY */
CAROM_API int32_t carom_world_read(carom_world *world, uint32_t field, uint32_t scalar, const carom_body *handles,
                                   uint64_t n, void *dst, uint64_t stride, carom_error *error);
/** Write one field of n bodies; all values are validated before the first is written. Arguments as carom_world_read().
 *  @param src n records of the field's scalars, `stride` bytes apart
 *  @status as carom_world_read(); UNSUPPORTED (read-only field); NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; REENTRANT */
CAROM_API int32_t carom_world_write(carom_world *world, uint32_t field, uint32_t scalar, const carom_body *handles,
                                    uint64_t n, const void *src, uint64_t stride, carom_error *error);

#ifdef __cplusplus
}
#endif
#endif
