/** @file accuracy.h
 *  Accuracy in, steps out: a host sets an error tolerance, and each island takes the substeps that its own error
 *  estimate calls for. An island is a set of bodies connected by contacts, joints and springs. A resting one takes one
 *  substep, a fast one many.
 *
 *  The error is that of a step: of poses at its end, and of velocities there, as far as they become an error of poses
 *  within a second. It is given per second of motion, so that a motion of T seconds is off by about T times the
 *  tolerance, where errors do not grow by themselves. In a chaotic scene they do; there it is what each step adds that
 *  is held. The estimate is the difference between the step taken and the same step with half its substeps. An error
 *  over the tolerance repeats the step with more. Islands without contacts choose the order of their errors, too: 2, 4
 *  or 6, CAROM_DIAL_JOINT_ORDER at least. Contacts are searched for once a step, whatever the tolerance. A step in
 *  which something is swept (carom_body_set_continuous()) takes the substeps of CAROM_DIAL_SUBSTEPS.
 *
 *  No clock decides anything: the same bits come out again, on any number of threads. What bodies remember of their
 *  errors is in snapshots and hashes. A world without a tolerance pays nothing.
 *  @thread world: a call that is named get, is or read is a reader of its world, any other call its writer (world.h).
 */
#ifndef CAROM_ACCURACY_H
#define CAROM_ACCURACY_H

#include <carom/world.h>

#ifdef __cplusplus
extern "C" {
#endif

/** An error tolerance. The three numbers are the dials CAROM_DIAL_ACCURACY_PLACE, _TURN and _SUBSTEPS, so that
 *  snapshots, recordings and scene files have them. The dial CAROM_DIAL_ACCURACY_WORK bounds the work of large islands
 *  in contact further. Fill with carom_accuracy_init(). */
typedef struct carom_accuracy {
  uint32_t struct_size;
  uint32_t substeps; /**< bound of work: that an island may take in a step, 2 to 4096, default 256 */
  double place;      /**< m per second of motion, 0 to 1e6, default 1e-3; 0: no tolerance of places */
  double turn;       /**< rad per second of motion, 0 to 1e6, default 1e-3; 0: no tolerance of turns */
} carom_accuracy;

#define CAROM_ISLAND_ESTIMATED 1u    /* its error was estimated in this step, else in one before */
#define CAROM_ISLAND_BOUND 2u        /* the bound of work was reached: its error is over the tolerance */
#define CAROM_ISLAND_JOINTS_ALONE 4u /* joints alone hold it: its error is of order 2, 4 or 6 */

/* clang-format off */
#define CAROM_ISLAND_STALLED 8u /* more substeps do not lessen its error, which is over the tolerance: contacts,
                                   mostly */
/* clang-format on */

/** An island of the last step. Errors are those of its step per second of motion, by the last estimate. */
typedef struct carom_island {
  carom_body body;   /**< that of its bodies which has the lowest slot; CAROM_NULL_HANDLE if that was destroyed since */
  uint32_t bodies;   /**< that move */
  uint32_t substeps; /**< that it took */
  uint32_t order;    /**< of the error, as the estimate takes it */
  uint32_t flags;    /**< CAROM_ISLAND_* */
  uint64_t work; /**< substeps of all runs of the step: those that were compared and those repeated are among them */
  double place;  /**< m/s; 0 without a tolerance of places */
  double turn;   /**< rad/s; 0 without a tolerance of turns */
  double share;  /**< the larger of the two over its tolerance: above 1 where the bound of work was reached,
                             or where more substeps do not help */
} carom_island;

/** How errors grow by themselves, whatever work a step is given: two motions that begin 1e-9 m/s and rad/s apart. Their
 *  distance is the largest over all bodies of that of places (m), of turns (rad), and of velocities and spins times 1
 *  s. */
typedef struct carom_growth {
  uint32_t struct_size;
  uint32_t steps;  /**< that were taken: fewer than requested where the distance had grown 1e6-fold before */
  carom_body body; /**< where the two are farthest apart at the end; CAROM_NULL_HANDLE if nothing moves */
  /** 1: errors grow e-fold, as in chaos. What is held to an accuracy there is the error that each step adds; the place
   *  after many e-foldings is no more than a guess */
  uint32_t sensitive;
  uint32_t reserved; /**< 0 */
  double factor;     /**< of their distance, from the beginning to the end */
  double rate;       /**< 1/s: ln(factor) over the time; below 0 where errors die out */
} carom_growth;

/** @status OK; NULL_ARGUMENT; STRUCT_SIZE */
CAROM_API int32_t carom_accuracy_init(carom_accuracy *accuracy, uint32_t struct_size);

/** Set an error tolerance from the next step on.
 *  @param accuracy NULL: none, as a world is created
 *  @status OK; UNSUPPORTED; NULL_ARGUMENT; STRUCT_SIZE; NOT_FINITE; OUT_OF_RANGE (also where both place and turn are
 *  0);
 *          BUSY; REENTRANT */
CAROM_API int32_t carom_world_set_accuracy(carom_world *world, const carom_accuracy *accuracy, carom_error *error);

/** @param accuracy out   @param present out: 1 or 0; if 0, accuracy is filled with defaults
 *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; BUSY */
CAROM_API int32_t carom_world_get_accuracy(carom_world *world, carom_accuracy *accuracy, uint32_t *present,
                                           carom_error *error);

/** Copy out the islands of the last step, worst first: by share, then by body. None without a tolerance.
 *  Bodies in free flight are in none: nothing acts on them but what is constant, and their step is exact.
 *  @param dst      [capacity] elements `stride` bytes apart; may be NULL if capacity is 0
 *  @param stride   sizeof(carom_island) as the caller knows it
 *  @param count    out: how many there are (may exceed capacity; capacity are written)
 *  @status OK; NULL_ARGUMENT; BUFFER_TOO_SMALL; OUT_OF_RANGE (stride); BUSY */
CAROM_API int32_t carom_world_get_islands(carom_world *world, carom_island *dst, uint64_t stride, uint64_t capacity,
                                          uint64_t *count, carom_error *error);

/** Measure how errors grow from here. Two copies of the world take the steps, at its dials and accuracy, so it costs a
 *  little over twice as much as they; nothing of the world itself changes. The same world gives the same result.
 *  Errors grow e-fold (`sensitive`) where they grow a hundredfold or more, and a quarter of the time or more goes by
 *  until they have grown to the root of that: half of it in chaos, a tenth where they grow in proportion to time.
 *  @param dt      s, of a step: as for carom_world_step()
 *  @param steps   1 to 1000000: several e-foldings of what is looked for, and more than the longest period
 *  @param growth  out, its struct_size set
 *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; NOT_FINITE; OUT_OF_RANGE; LIMIT; BUSY; REENTRANT; OUT_OF_MEMORY
 *  @thread reader */
CAROM_API int32_t carom_world_measure_growth(carom_world *world, double dt, uint32_t steps, carom_growth *growth,
                                             carom_error *error);

#ifdef __cplusplus
}
#endif
#endif
