/** @file snapshot.h
 *  The state of a world as bytes, and back: to take a game back by some frames, to begin a thousand trials from one
 *  moment, to store a game, to hand over the moment at which something went wrong.
 *
 *      uint64_t size;
 *      carom_world_save(world, CAROM_SNAPSHOT_STATE, NULL, 0, &size, &error);
 *      void *bytes = malloc(size);
 *      carom_world_save(world, CAROM_SNAPSHOT_STATE, bytes, size, &size, &error);
 *      ... steps ...
 *      carom_world_restore(world, bytes, size, &error);
 *
 *  From a restore on, a world goes on as from the moment it was saved, bit for bit: carom_world_hash() is the same after
 *  every further step, whatever caches, sleepers, joints and solvers there are, on any number of threads.
 *
 *  A snapshot that is whole (CAROM_SNAPSHOT_WHOLE) has the structure, too: it makes an empty world of any engine, in any
 *  process, the world that was saved, with handles of the same slots and generations (carom_world_translate_handles()
 *  says which). carom_world_fork() does so at once. What is of an engine is named, not carried: of a shape the id and
 *  version of its plugin, which must be loaded, and its parameters; but meshes, height fields and half-spaces are in it.
 *
 *  What any snapshot has: all that a step changes, and all that a host can set (dials, gravity, filters, motors, materials,
 *  modes of effects, who sleeps, forces that are pending, which events are collected). What one of the state alone has
 *  not: the structure, that is which bodies, colliders, materials, joints, sets, fields and springs there are and with what masses and
 *  shapes; a snapshot belongs to a world of the same. That is the world itself as long as nothing in it was created or
 *  destroyed, or another one, also in another process, that was made by the same calls. Handles stay as they are. `user`
 *  values stay as they are. Contacts, groups, faults, events and residuals of the last step are empty until the next
 *  one; a ledger books what a restore changes as the host's.
 *
 *  Size: at most 230 bytes for a body with one collider (+ 9 for a further one), + 48 with a force pending, + 64 while
 *  the dial `sleep` is on and the body is slow but not asleep, + 47 with settings of its own; 45 for a pair of bounds
 *  that overlap, + 88 for each contact point and 120 for a pair whose patch is kept, + 57 to 81 for each impulse; 137 for
 *  a joint, + 65 for each coordinate that is limited, driven or sprung; 48 for a particle, + 8 if it has a mass of its
 *  own. Both ways take some 0.1 us a body that falls, 0.5 us a body in a heap.
 *
 *  Bytes: little-endian, sections with tags and sizes and a checksum over all. A newer library's sections that this one does not
 *  know are skipped, and what is absent is as in a new world. Bytes that are damaged, cut off or made up are refused, and
 *  the world is as it was. */
#ifndef CAROM_SNAPSHOT_H
#define CAROM_SNAPSHOT_H

#include <carom/world.h>

#ifdef __cplusplus
extern "C" {
#endif

#define CAROM_SNAPSHOT_STATE 0u /* all but the structure */
#define CAROM_SNAPSHOT_WHOLE 1u /* the structure, too */

/** Write a snapshot, between steps. Reads only: other readers may be at work.
 *  @param flags    CAROM_SNAPSHOT_*
 *  @param buffer   [capacity] bytes, or NULL to ask for the size
 *  @param capacity bytes; 0 if buffer is NULL
 *  @param needed   out: bytes of the snapshot; written, too, when the buffer is too small (nothing else is)
 *  @status OK; NULL_ARGUMENT; UNSUPPORTED (flags); BUFFER_TOO_SMALL; BUSY; REENTRANT; OUT_OF_MEMORY   @since 1.8 */
CAROM_API int32_t carom_world_save(carom_world *world, uint32_t flags, void *buffer, uint64_t capacity,
                                   uint64_t *needed, carom_error *error);

/** Put a snapshot back, between steps. All of it is read and checked, and all memory that it takes is there, before
 *  anything of the world changes.
 *  A world in which nothing was ever made is built anew of a snapshot that is whole; `user` values come with it, a ledger
 *  begins anew. Shapes of the same plugin and numbers that the engine has are used, others made; they are the engine's, as
 *  if the host had made them (carom_collider_get() tells their handles). Any other world takes its state, as of one that
 *  is not whole.
 *  @param bytes [size], of any alignment   @param size as carom_world_save() told
 *  @status OK; NULL_ARGUMENT; CORRUPT (damaged, cut off, or no snapshot: the message says what); UNSUPPORTED (of a newer
 *          format); MISMATCH (of a world of another structure: the message names the kind that differs; or a plugin of that
 *          id and version makes other shapes than it did); NOT_FOUND (a shape plugin is not loaded: the message says id and
 *          version); LIMIT; BUSY; REENTRANT; OUT_OF_MEMORY   @since 1.8 */
CAROM_API int32_t carom_world_restore(carom_world *world, const void *bytes, uint64_t size, carom_error *error);

/** Make a world of the same engine that is as this one is, and goes on as it does, bit for bit. Nothing of this one
 *  changes; other readers may be at work. Lists and residuals of its last step, and a ledger, the copy has none of.
 *  @param copy out: to be destroyed as any world
 *  @status OK; NULL_ARGUMENT; LIMIT; BUSY; REENTRANT; OUT_OF_MEMORY   @since 1.8 */
CAROM_API int32_t carom_world_fork(carom_world *world, carom_world **copy, carom_error *error);

/** Handles of another world, as they are in this one: the same slots and generations. For what a host keeps of a world that
 *  it has forked, or of one that was saved whole, in another process too.
 *  @param handles    [n] of bodies, colliders, materials, joints, particles, fields, springs; 0 stays 0
 *  @param translated [n] out; may be `handles`. All of them or, where one is refused, none
 *  @status OK; NULL_ARGUMENT; INVALID_HANDLE; STALE_HANDLE; WRONG_KIND (of an engine: shapes are the same in all its
 *          worlds); BUSY; REENTRANT   @since 1.8 */
CAROM_API int32_t carom_world_translate_handles(carom_world *world, const uint64_t *handles, uint64_t n,
                                                uint64_t *translated, carom_error *error);

#ifdef __cplusplus
}
#endif
#endif
