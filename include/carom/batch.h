/** @file batch.h
 *  Many worlds at once: N copies of one world, or of several, that step on the engine's threads; what goes in and comes
 *  out are arrays of the host's, a row for each world. For reinforcement learning, sweeps and planning.
 *
 *      double effort[256][1], place[256][2];
 *      uint64_t first;
 *      carom_batch_create(engine, &batch, &error);
 *      carom_batch_add_worlds(batch, world, 256, &first, &error);
 *      ... a column of JOINTS, TARGET_EFFORT, BEFORE_STEP at `effort`; one of POSITION, AFTER_STEP at `place` ...
 *      for (;;) {
 *        ... fill effort ...
 *        carom_batch_step(batch, NULL, 0.02, 1, &stopped, &error);
 *        ... read place ...
 *      }
 *
 *  A world of a batch is its state in few bytes: what differs from the world that it is a copy of. There are as many
 *  real worlds as threads work at once. Every step goes on from the bits of the step before, so a world does what it
 *  would do alone, to the bit, whatever its number, its neighbours, the number of worlds and of threads. Its hash is
 *  that of carom_world_hash().
 *
 *  Rows are read and written where the host has them: columns alias the memory of its arrays, which stays until the
 *  batch is destroyed. A row of a world that a call does not touch stays as it is.
 *
 *  A fault (carom_world_get_faults()) stops its world and no other. It keeps the state in which the step left it until
 *  it is reset; carom_batch_get_stopped() and carom_batch_get_faults() say what happened.
 *
 *  Numbers of worlds begin with 0. Masks have a byte for each world of the batch: not 0 is yes; NULL is all.
 *  Handles are those of the world that was copied, also after it has been destroyed. Shapes stay in use.
 *  Support functions of HOST_THREAD plugins are called on the calling thread alone: such worlds share no threads.
 *  @thread batch: one call at a time: a call on a batch that another call uses is BUSY. Batches are independent of each
 *  other and of all worlds.
 */
#ifndef CAROM_BATCH_H
#define CAROM_BATCH_H

#include <carom/body_bulk.h>
#include <carom/joint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct carom_batch carom_batch;

/* What a column has of each thing that it lists. */
#define CAROM_COLUMN_BODIES 0u         /* bodies: one CAROM_FIELD_* */
#define CAROM_COLUMN_JOINTS 1u         /* joints: one CAROM_JOINT_BULK_* */
#define CAROM_COLUMN_MASSES 2u         /* dynamic bodies: 1, kg; writing scales the inertia alike, the centre stays */
#define CAROM_COLUMN_MATERIALS 3u      /* materials: 2, friction and restitution */
#define CAROM_COLUMN_GRAVITY 4u        /* the world, n is 1: 3, m/s^2 */
#define CAROM_COLUMN_TIME 5u           /* the world, n is 1: 1, s, simulated; read only */
#define CAROM_COLUMN_CONTACT_FORCES 6u /* bodies: 3, N, world: normal forces on it, mean of the last step; read only */
#define CAROM_COLUMN_RAYS \
  7u /* bodies or the world: 1, how far along a ray something is met first, in parts of `direction`, `max` where nothing
        is; read only */
#define CAROM_COLUMN_COUNT 8u

#define CAROM_WHEN_ON_CALL 0u     /* by carom_batch_read() and carom_batch_write() */
#define CAROM_WHEN_BEFORE_STEP 1u /* written before each step, too */
#define CAROM_WHEN_AFTER_STEP 2u  /* read after each step, too, and after calls that change worlds */
#define CAROM_WHEN_COUNT 3u

/** What stands in an array of the host's, and when. Fill with carom_batch_column_init(). A row has n records one after
 *  the other, each of as many numbers as the source says; rows are those of the worlds of one structure, in order. */
typedef struct carom_batch_column {
  uint32_t struct_size;
  uint32_t source;   /**< CAROM_COLUMN_BODIES or what follows it */
  uint32_t field;    /**< of BODIES CAROM_FIELD_*, of JOINTS CAROM_JOINT_BULK_*, else 0 */
  uint32_t when;     /**< CAROM_WHEN_ON_CALL, BEFORE_STEP, AFTER_STEP; default ON_CALL */
  uint32_t scalar;   /**< CAROM_SCALAR_*, default F64 */
  uint32_t reserved; /**< 0 */
  uint64_t world;    /**< one of the structure: the first that carom_batch_add_worlds() gave, or any other */
  uint64_t n;        /**< how many things, 1 or more; 1 of GRAVITY and TIME */
  const uint64_t
      *handles;       /**< [n] of the things; of RAYS bodies that the rays go with, or 0; NULL of GRAVITY and TIME */
  const double *rays; /**< [7 n] of RAYS: origin, m, direction, m, and max, in [0, 1e9], in the body's frame or the
                                world's; the body itself is passed over. NULL of others */
  void *data;         /**< the first row; belongs to the host, and stays until the batch is destroyed */
  uint64_t stride;    /**< bytes from one row to the next; 0: tightly packed */
} carom_batch_column;

/** @status OK; NULL_ARGUMENT; STRUCT_SIZE */
CAROM_API int32_t carom_batch_column_init(carom_batch_column *column, uint32_t struct_size);

/** Make a batch without worlds.
 *  @param batch out: to be destroyed before the engine   @owns the caller: carom_batch_destroy()
 *  @status OK; NULL_ARGUMENT; OUT_OF_MEMORY   @thread engine */
CAROM_API int32_t carom_batch_create(carom_engine *engine, carom_batch **batch, carom_error *error);

/** @status OK; NULL_ARGUMENT; BUSY; REENTRANT */
CAROM_API int32_t carom_batch_destroy(carom_batch *batch, carom_error *error);

/** Add n worlds that are as this one is now. The world itself is read, stays as it is, and may be destroyed. A ledger, a
 *  recording and a budget of time are not copied.
 *  @param batch of the same engine   @param n 1 to 2^24 in all   @param first out: the number of the first of them
 *  @status OK; NULL_ARGUMENT; OUT_OF_RANGE (n); WRONG_WORLD (of another engine); LIMIT (256 structures in all); BUSY;
 *          REENTRANT; OUT_OF_MEMORY */
CAROM_API int32_t carom_batch_add_worlds(carom_batch *batch, carom_world *world, uint64_t n, uint64_t *first,
                                         carom_error *error);

/** Say where numbers of worlds stand.
 *  @param column out: its number, from 0 on; may be NULL
 *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; OUT_OF_RANGE (world, n, a ray); NOT_FINITE; *_HANDLE;
 *          UNSUPPORTED (a joint or body that has no such field; read only: not BEFORE_STEP, nor fields that move
 *          joints); BUFFER_TOO_SMALL (stride); LIMIT (4,096 columns); BUSY; REENTRANT; OUT_OF_MEMORY */
CAROM_API int32_t carom_batch_add_column(carom_batch *batch, const carom_batch_column *desc, uint32_t *column,
                                         carom_error *error);

/** Advance worlds, each by steps of dt. First, all that columns BEFORE_STEP have for them is checked: where something is
 *  refused no world has moved. A world that is stopped stays as it is, and so do its rows.
 *  @param mask     [worlds] or NULL: all
 *  @param dt       s, in [1e-9, 1]
 *  @param steps    1 to 1e6, with the same numbers before each
 *  @param stopped  out: how many worlds are stopped now, in all; may be NULL
 *  @status OK; NULL_ARGUMENT; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; UNSUPPORTED; BUSY; REENTRANT; OUT_OF_MEMORY; INTERNAL (a
 *          callback left its thread: some worlds were stepped)
 *        */
CAROM_API int32_t carom_batch_step(carom_batch *batch, const uint8_t *mask, double dt, uint32_t steps,
                                   uint64_t *stopped, carom_error *error);

/** Read columns, of worlds as they are now. Contact forces are those of a step: 0 here.
 *  @param columns [count]   @param mask [worlds] or NULL: all
 *  @status OK; NULL_ARGUMENT; OUT_OF_RANGE (a column); BUSY; REENTRANT; OUT_OF_MEMORY */
CAROM_API int32_t carom_batch_read(carom_batch *batch, const uint32_t *columns, uint64_t count, const uint8_t *mask,
                                   carom_error *error);

/** Write columns, one after the other: poses, speeds, gains, friction, masses. All worlds or none are changed.
 *  @param columns [count]   @param mask [worlds] or NULL: all
 *  @status OK; NULL_ARGUMENT; OUT_OF_RANGE; NOT_FINITE; NOT_UNIT; UNSUPPORTED (read only, or joints that can't be moved);
 *          BUSY; REENTRANT; OUT_OF_MEMORY */
CAROM_API int32_t carom_batch_write(carom_batch *batch, const uint32_t *columns, uint64_t count, const uint8_t *mask,
                                    carom_error *error);

/** Add a state that worlds of a structure may be reset to.
 *  @param world  one of the structure   @param bytes [size] as carom_world_restore() takes them   @param size of bytes
 *  @param start  out: its number among those of the structure, from 1 on; 0 is the state that its worlds were made with
 *  @status OK; NULL_ARGUMENT; OUT_OF_RANGE (world); CORRUPT; UNSUPPORTED; MISMATCH; BUSY; REENTRANT; OUT_OF_MEMORY
 *        */
CAROM_API int32_t carom_batch_add_start(carom_batch *batch, uint64_t world, const void *bytes, uint64_t size,
                                        uint32_t *start, carom_error *error);

/** Put worlds back to where they began. Masses that were written stay; what else was written is as in the start.
 *  A world that is stopped runs again.
 *  @param mask   [worlds] or NULL: all   @param starts [worlds] numbers of starts, or NULL: 0
 *  @status OK; NULL_ARGUMENT; OUT_OF_RANGE (a start); BUSY; REENTRANT; OUT_OF_MEMORY */
CAROM_API int32_t carom_batch_reset(carom_batch *batch, const uint8_t *mask, const uint32_t *starts,
                                    carom_error *error);

/** Write a snapshot of one world, as carom_world_save() with CAROM_SNAPSHOT_STATE: it goes into the world that was
 *  copied (unless masses differ), or back by carom_batch_add_start(). Arguments as there.
 *  @param world    its number
 *  @param buffer   [capacity] bytes, or NULL to get the size alone
 *  @param capacity bytes; 0 if buffer is NULL
 *  @param needed   out: bytes of the snapshot; written, too, when the buffer is too small (nothing else is)
 *  @status OK; NULL_ARGUMENT; OUT_OF_RANGE (world); BUFFER_TOO_SMALL; BUSY; REENTRANT; OUT_OF_MEMORY */
CAROM_API int32_t carom_batch_save(carom_batch *batch, uint64_t world, void *buffer, uint64_t capacity,
                                   uint64_t *needed, carom_error *error);

/** The hash of each world, as carom_world_hash().
 *  @param hashes out, [worlds]   @param n how many worlds there are
 *  @status OK; NULL_ARGUMENT; OUT_OF_RANGE (n); BUSY; REENTRANT; OUT_OF_MEMORY */
CAROM_API int32_t carom_batch_get_hashes(carom_batch *batch, uint64_t *hashes, uint64_t n, carom_error *error);

#define CAROM_STOPPED_NO 0u     /* it steps */
#define CAROM_STOPPED_FAULT 1u  /* a step had faults: carom_batch_get_faults() */
#define CAROM_STOPPED_MEMORY 2u /* there was no memory for a step: it is as before that */

/** Which worlds are stopped, and why.
 *  @param stopped out, [worlds] CAROM_STOPPED_*   @param n how many worlds there are
 *  @status OK; NULL_ARGUMENT; OUT_OF_RANGE (n); BUSY */
CAROM_API int32_t carom_batch_get_stopped(carom_batch *batch, uint32_t *stopped, uint64_t n, carom_error *error);

/** The faults of the step that stopped a world; none where it is not stopped.
 *  @param world    its number
 *  @param dst      [capacity] elements `stride` bytes apart; may be NULL if capacity is 0
 *  @param stride   sizeof(carom_fault) as the caller knows it
 *  @param count    out: how many there are (may exceed capacity; capacity are written)
 *  @status OK; NULL_ARGUMENT; BUFFER_TOO_SMALL; OUT_OF_RANGE (world, stride); BUSY */
CAROM_API int32_t carom_batch_get_faults(carom_batch *batch, uint64_t world, carom_fault *dst, uint64_t stride,
                                         uint64_t capacity, uint64_t *count, carom_error *error);

/** What a batch has, and what it costs. */
typedef struct carom_batch_info {
  uint32_t struct_size;
  uint32_t structures;  /**< kinds of worlds */
  uint64_t worlds;      /**< in all */
  uint64_t stopped;     /**< of them */
  uint64_t columns;     /**< that were added */
  uint64_t real_worlds; /**< as many as threads were at work at once, at most, times structures */
  uint64_t state_bytes; /**< of all states: divided by worlds, what one more world takes */
} carom_batch_info;

/** @status OK; NULL_ARGUMENT; STRUCT_SIZE; BUSY */
CAROM_API int32_t carom_batch_get_info(carom_batch *batch, carom_batch_info *info, carom_error *error);

#define CAROM_RANDOM_UNIFORM 0u /* in [0, 1) */
#define CAROM_RANDOM_NORMAL 1u  /* mean 0, deviation 1 */
#define CAROM_RANDOM_COUNT 2u

/** Random numbers that follow from a key alone: n rows, each from its own key. So they do not depend on how many worlds
 *  there are, in which order or on which thread, or machine, they are drawn. Philox4x32-10; the normal ones by Box and
 *  Muller. A row that is longer begins as a shorter one of its key.
 *  @param kind  CAROM_RANDOM_*
 *  @param keys  [3 n]: of each row a seed, the number of a world, a step
 *  @param width numbers in a row
 *  @param dst   out, [n width]
 *  @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; OUT_OF_RANGE (n, width)   @thread any */
CAROM_API int32_t carom_random_fill(uint32_t kind, const uint64_t *keys, uint64_t n, uint64_t width, double *dst,
                                    carom_error *error);

#ifdef __cplusplus
}
#endif
#endif
