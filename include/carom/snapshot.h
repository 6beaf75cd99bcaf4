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
 *  After a restore a world goes on as from the moment it was saved, bit for bit. carom_world_hash() is the same after
 *  every further step, whatever caches, sleepers, joints and solvers there are, on any number of threads.
 *
 *  A whole snapshot (CAROM_SNAPSHOT_WHOLE) has the structure, too. It turns an empty world of any engine, in any
 *  process, into the world that was saved. Handles have the same slots and generations (carom_world_translate_handles()
 *  says which). carom_world_fork() does so at once. Shapes of plugins are named, by id, version and parameters; the
 *  plugin must be loaded. Meshes, height fields and half-spaces are in the snapshot.
 *
 *  What any snapshot has: all that a step changes, and all that a host can set. That is dials, gravity, filters,
 *  motors, materials, modes of effects, what sleeps, pending forces, which events are collected. A snapshot of the
 *  state alone lacks the structure: which bodies, colliders, materials, joints, sets, fields and springs there are,
 *  with their masses and shapes. It belongs to a world of the same structure. That is the world itself while nothing in
 *  it is created or destroyed, or another one that was made by the same calls, also in another process. Handles and
 *  `user` values stay as they are. Contacts, groups, faults, events and residuals of the last step are empty until the
 *  next one. A ledger counts what a restore changes as the host's.
 *
 *  Size in bytes, at most:
 *    body with one collider  230, a further collider 9, a pending force 48, settings of its own 47,
 *                            while it is slow but awake 64
 *    pair of bounds          45, each contact point 88, a patch that is kept 120, each impulse 57 to 81
 *    joint                   137, each coordinate with a limit, drive or spring 65
 *    particle                48, a mass of its own 8
 *
 *  Bytes are little-endian: sections with tags and sizes, and a checksum over all. Sections that this library does not
 *  know are skipped, and what is absent is as in a new world. Bytes that are damaged, cut off or made up are refused,
 *  and the world stays as it was.
 *  @thread world: a call that is named get, is or read is a reader of its world, any other call its writer (world.h).
 */
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
 *  @param buffer   [capacity] bytes, or NULL to get the size alone
 *  @param capacity bytes; 0 if buffer is NULL
 *  @param needed   out: bytes of the snapshot; written, too, when the buffer is too small (nothing else is)
 *  @status OK; NULL_ARGUMENT; UNSUPPORTED (flags); BUFFER_TOO_SMALL; BUSY; REENTRANT; OUT_OF_MEMORY   @thread reader */
CAROM_API int32_t carom_world_save(carom_world *world, uint32_t flags, void *buffer, uint64_t capacity,
                                   uint64_t *needed, carom_error *error);

/** Put a snapshot back, between steps. All of it is read and checked, and all memory that it takes is there, before
 *  anything of the world changes.
 *  An empty world is rebuilt from a snapshot that is whole; `user` values come with it, a ledger
 *  begins anew. Shapes of the same plugin and numbers that the engine has are used, others made; they are the engine's,
 *  as if the host had made them (carom_collider_get() gives their handles). Any other world takes its state, as of one
 *  that is not whole.
 *  @param bytes [size], of any alignment   @param size as carom_world_save() gave it
 *  @status OK; NULL_ARGUMENT; CORRUPT (damaged, cut off, or no snapshot: the message says what); UNSUPPORTED (of a
 *  newer
 *          format); MISMATCH (of a world of another structure: the message names the kind that differs; or a plugin of
 *          that id and version makes other shapes than it did); NOT_FOUND (a shape plugin is not loaded: the message
 *          says id and version); LIMIT; BUSY; REENTRANT; OUT_OF_MEMORY */
CAROM_API int32_t carom_world_restore(carom_world *world, const void *bytes, uint64_t size, carom_error *error);

/** Make a world of the same engine that is as this one is, and goes on as it does, bit for bit. Nothing of this one
 *  changes; other readers may be at work. Lists and residuals of its last step, and a ledger, the copy has none of.
 *  @param copy out: to be destroyed as any world
 *  @status OK; NULL_ARGUMENT; LIMIT; BUSY; REENTRANT; OUT_OF_MEMORY   @thread reader */
CAROM_API int32_t carom_world_fork(carom_world *world, carom_world **copy, carom_error *error);

/** Handles of another world, as they are in this one: the same slots and generations. For what a host keeps of a world
 *  that it has forked, or of one that was saved whole, in another process too.
 *  @param handles    [n] of bodies, colliders, materials, joints, particles, fields, springs; 0 stays 0
 *  @param translated [n] out; may be `handles`. All of them or, where one is refused, none
 *  @status OK; NULL_ARGUMENT; INVALID_HANDLE; STALE_HANDLE; WRONG_KIND (of an engine: shapes are the same in all its
 *          worlds); BUSY; REENTRANT   @thread reader */
CAROM_API int32_t carom_world_translate_handles(carom_world *world, const uint64_t *handles, uint64_t n,
                                                uint64_t *translated, carom_error *error);

#ifdef __cplusplus
}
#endif
#endif
