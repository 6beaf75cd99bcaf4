/** @file particles.h
 *  Point masses by the thousand: position, velocity, a mass, gravity and drag, and nothing else. They touch nothing,
 *  do not rotate and have no handle each: a set has one, and each particle is known by its index in it. A step
 *  takes a nanosecond or a few for each; one is 48 bytes, where a body without a shape is 730.
 *  @thread world: a call that is named get, is or read is a reader of its world, any other call its writer (world.h).
 */
#ifndef CAROM_PARTICLES_H
#define CAROM_PARTICLES_H

#include <carom/body_bulk.h>

#ifdef __cplusplus
extern "C" {
#endif

/** What all particles of a set have in common. Fill with carom_particles_desc_init(). */
typedef struct carom_particles_desc {
  uint32_t struct_size;
  uint32_t reserved;     /**< 0 */
  double gravity_factor; /**< of the world's gravity, [-1e3, 1e3], default 1 */
  double linear_damping; /**< 1/s, [0, 1e6], default 0: dv/dt = -c v, as a body's */
  double mass;       /**< kg, (0, 1e30], default 1: of each particle that is added from now on. It falls and is braked
                              as any other; the mass counts in CAROM_FIELD_MASS and in the energy of the report */
  uint64_t capacity; /**< particles to reserve memory for; it grows beyond. default 0 */
} carom_particles_desc;

/** @status OK; NULL_ARGUMENT; STRUCT_SIZE */
CAROM_API int32_t carom_particles_desc_init(carom_particles_desc *desc, uint32_t struct_size);

/** Make an empty set.
 *  @param desc may be NULL: defaults
 *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT; LIMIT; OUT_OF_MEMORY
 *  */
CAROM_API int32_t carom_particles_create(carom_world *world, const carom_particles_desc *desc, carom_particles *set,
                                         carom_error *error);
/** Its particles too.   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT */
CAROM_API int32_t carom_particles_destroy(carom_world *world, carom_particles set, carom_error *error);
/** @param desc out: as it was made or updated; capacity: particles there is memory for
 *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; BUSY */
CAROM_API int32_t carom_particles_get(carom_world *world, carom_particles set, carom_particles_desc *desc,
                                      carom_error *error);
/** Change what they have in common; particles that are there keep their mass.
 *  @param desc may be NULL: defaults; capacity: memory for so many in all
 *  @status as carom_particles_create(); *_HANDLE */
CAROM_API int32_t carom_particles_update(carom_world *world, carom_particles set, const carom_particles_desc *desc,
                                         carom_error *error);

/** @param count out: particles in the set   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY */
CAROM_API int32_t carom_particles_get_count(carom_world *world, carom_particles set, uint64_t *count,
                                            carom_error *error);

/** Add n particles at the end; all values are checked before the first is added.
 *  @param scalar          CAROM_SCALAR_*, of both arrays
 *  @param positions       [n] m, world, three scalars each, within 1e15 m of the origin
 *  @param position_stride bytes from one to the next; 0: tightly packed
 *  @param velocities      [n] m/s, world, likewise, at most 1e9 m/s; NULL: at rest
 *  @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUFFER_TOO_SMALL (stride); LIMIT (2^31
 *          - 1 in a set); BUSY; REENTRANT; OUT_OF_MEMORY */
CAROM_API int32_t carom_particles_add(carom_world *world, carom_particles set, uint64_t n, uint32_t scalar,
                                      const void *positions, uint64_t position_stride, const void *velocities,
                                      uint64_t velocity_stride, carom_error *error);
/** Remove n particles. The others keep their order, so each moves up by as many as went before it.
 *  @param indices [n] ascending, each once; NULL: all of them (n must be their number)
 *  @status OK; NULL_ARGUMENT; *_HANDLE; OUT_OF_RANGE (an index, their order, n); BUSY; REENTRANT */
CAROM_API int32_t carom_particles_remove(carom_world *world, carom_particles set, const uint32_t *indices, uint64_t n,
                                         carom_error *error);

/** Read one field of n particles.
 *  @param field   CAROM_FIELD_POSITION, LINEAR_VELOCITY or MASS
 *  @param indices [n] in any order, or NULL: all of them (n must be their number)
 *  @param dst     n records of the field's scalars, `stride` bytes apart
 *  @param stride  bytes from one record to the next; 0: tightly packed
 *  @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; UNSUPPORTED (a field that particles do not have); *_HANDLE; OUT_OF_RANGE
 *          (an index, n); BUFFER_TOO_SMALL (stride); BUSY */
CAROM_API int32_t carom_particles_read(carom_world *world, carom_particles set, uint32_t field, uint32_t scalar,
                                       const uint32_t *indices, uint64_t n, void *dst, uint64_t stride,
                                       carom_error *error);
/** Write one field of n particles; all values are checked before the first is written, bounds as carom_particles_add(),
 *  masses as carom_particles_desc. Arguments as carom_particles_read(); where an index comes twice, the last counts.
 *  @param src n records of the field's scalars, `stride` bytes apart
 *  @status as carom_particles_read(); NOT_FINITE; OUT_OF_RANGE; REENTRANT; OUT_OF_MEMORY */
CAROM_API int32_t carom_particles_write(carom_world *world, carom_particles set, uint32_t field, uint32_t scalar,
                                        const uint32_t *indices, uint64_t n, const void *src, uint64_t stride,
                                        carom_error *error);

/** A particle that has come further than 1e15 m or become faster than 1e9 m/s is put in quarantine: it is held still
 *  where it is and counts in no energy, until a host writes its position or removes it. carom_world_get_faults()
 *  reports the first of each set and step (CAROM_FAULT_PARTICLE_STATE), this call all that are held now, ascending.
 *  @param indices [capacity] out; may be NULL if capacity is 0
 *  @param count   out: how many there are (may exceed capacity; capacity are written)
 *  @status OK; NULL_ARGUMENT; *_HANDLE; BUSY */
CAROM_API int32_t carom_particles_get_quarantined(carom_world *world, carom_particles set, uint32_t *indices,
                                                  uint64_t capacity, uint64_t *count, carom_error *error);

/** Number of sets, and their handles in creation order of the slots.
 *  @param sets [capacity] or NULL   @param count out: how many there are
 *  @status OK; NULL_ARGUMENT; BUSY */
CAROM_API int32_t carom_world_get_particles(carom_world *world, carom_particles *sets, uint64_t capacity,
                                            uint64_t *count, carom_error *error);

#ifdef __cplusplus
}
#endif
#endif
