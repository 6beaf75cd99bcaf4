/** @file record.h
 *  A session as bytes: what a host did with a world, call by call, so that it can be done again elsewhere, and what
 *  differs then can be found: `carom replay FILE` names the first step that differs, the calls before it, and what
 *  of the world differs first.
 *
 *      carom_world_record_begin(world, CAROM_RECORD_HASHES, to_a_file, file, &error);
 *      ... whatever a game does ...
 *      carom_world_record_end(world, &error);
 *
 *  What is written: a whole snapshot (carom/snapshot.h), then each call that changed the world, with all that it was
 *  given, and after each step the hash. Shapes are written when they are first used. A call that failed has changed
 *  nothing and is not written. Calls that read are not written either: they change nothing.
 *
 *  Bytes: "CAROMREC", format and version of the library (4 bytes each), then records: kind and 0 (4 bytes each), size
 *  (8), content, zeros up to a multiple of 8. A step is written before it is taken and its hash after it, so that a
 *  session that never came back from a step ends with that step. `src/tools/replay` reads it all.
 *
 *  A world that is not recorded pays nothing. Recording costs the hash of each step, and writing.
 *  @thread world: a call that is named get, is or read is a reader of its world, any other call its writer (world.h).
 */
#ifndef CAROM_RECORD_H
#define CAROM_RECORD_H

#include <carom/snapshot.h>

#ifdef __cplusplus
extern "C" {
#endif

#define CAROM_RECORD_HASHES 0u /* the hash after each step */
#define CAROM_RECORD_STATES 1u /* and the state (CAROM_SNAPSHOT_STATE), so that a replay can name a body or a pair */

/** Take bytes of a recording, in order. Called on the thread that makes the call which is recorded, before that
 *  returns; no call of this library is allowed in it.
 *  @param user as given to carom_world_record_begin()   @param bytes [size]   @param size number of bytes
 *  @return 0; else recording stops, and carom_world_record_end() says so */
typedef int32_t (*carom_write_fn)(void *user, const void *bytes, uint64_t size);

/** Record a world from now on, until carom_world_record_end() or until it is destroyed.
 *  @param flags CAROM_RECORD_*   @param write is kept, and called with `user`
 *  @status OK; NULL_ARGUMENT; UNSUPPORTED (flags); IN_USE (it is being recorded); WRITE_FAILED; BUSY; REENTRANT;
 *          OUT_OF_MEMORY */
CAROM_API int32_t carom_world_record_begin(carom_world *world, uint32_t flags, carom_write_fn write, void *user,
                                           carom_error *error);

/** Stop recording.
 *  @status OK; NULL_ARGUMENT; NOT_FOUND (it is not being recorded); WRITE_FAILED (`write` said so, now or before: the
 *          recording ends there); OUT_OF_MEMORY (likewise, for lack of memory); BUSY; REENTRANT */
CAROM_API int32_t carom_world_record_end(carom_world *world, carom_error *error);

/** What of a world is not as a snapshot says. */
typedef struct carom_difference {
  uint32_t struct_size;
  uint32_t differs;   /**< 0: it is the same, to the bit */
  uint64_t first;     /**< the body, joint, ... that differs first; of a pair the one collider; 0: none in particular */
  uint64_t second;    /**< of a pair the other collider; else 0 */
  char sections[240]; /**< what differs, most telling first: "bodies, pairs, dials"; zero-terminated */
} carom_difference;

/** Compare a world with a snapshot, between steps; of a world of the same structure. Reads only.
 *  @param difference its struct_size set by the caller
 *  @param bytes [size] of carom_world_save()   @param size number of bytes
 *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; CORRUPT, UNSUPPORTED, MISMATCH (as carom_world_restore()); BUSY; REENTRANT;
 *          OUT_OF_MEMORY   @thread reader */
CAROM_API int32_t carom_world_compare(carom_world *world, const void *bytes, uint64_t size,
                                      carom_difference *difference, carom_error *error);

#ifdef __cplusplus
}
#endif
#endif
