/** @file ledger.h
 *  The ledger of a world: where energy, momentum and angular momentum come from and go to, by cause. The causes sum to
 *  the change of the state within rounding, in every step, whatever solver, integrator or threads. Keeping it changes
 *  nothing: the world steps the same bits. A world that keeps none has none: it costs no time and no memory.
 *
 *  What counts: dynamic bodies, asleep and in quarantine too, and particles.
 *    kinetic    J, of motion and rotation               linear   N s, world
 *    potential  J, -m f g.x of the world's gravity      angular  N m s, world, about the origin
 *  Kinematic bodies have none of it: what they push is in the account of what they push by.
 *
 *  Causes, in this order:
 *    host        what was done between steps: bodies made, removed, placed, pushed; gravity set
 *    contact     normal impulses of the solver: a landing without a bounce
 *    friction    also that of surfaces that move, and of impacts
 *    restitution impacts that are solved before the solver runs, at the moment of the step at which they happen
 *    resistance  to rolling and spinning
 *    joints      what joints lock
 *    drives      motors, springs and limits of joints
 *    continuous  hits of bodies that are swept
 *    axis_locks  what locked axes take off, and how bodies with one locked axis turn
 *    correction  poses put right apart from velocities
 *    sleep       velocities of what falls asleep
 *    quarantine  of bodies and particles that leave the finite world
 *    integrator  the integrator's error: what is left in free motion beyond the forces below
 *    unassigned  what solvers did beyond their impulses: arms and inertias that they keep while bodies turn
 *    then each effect that acts on velocities, by its name: linear_damping, angular_damping, gravity, user_force, ...
 *
 *  A force gives its impulse, and its power over the mean of the velocities before and after the phase of the substep
 *  in which it acts; so do the impulses of contacts and joints, at their points. So what gravity does to a body at rest
 *  is nothing, and not the work of gravity against that of the floor. Gravity gives the work along the way that a body
 *  went and takes as much potential: its energy is 0, and what the steps of an integrator do beyond that is the
 *  integrator's: nothing in free flight under CAROM_INTEGRATOR_VELOCITY_VERLET, -m g^2 h^2 / 2 a substep of length h
 *  under semi-implicit Euler. The gyroscopic term is no force: what it and the turn of a body do together is the
 *  integrator's, and sums to no angular momentum under the methods that keep it.
 *  @thread world: a call that is named get, is or read is a reader of its world, any other call its writer (world.h).
 */
#ifndef CAROM_LEDGER_H
#define CAROM_LEDGER_H

#include <carom/world.h>

#ifdef __cplusplus
extern "C" {
#endif

/** A cause: what it gave in the last step, and since the ledger began. */
typedef struct carom_ledger_entry {
  const char *name;        /**< static, zero-terminated */
  double kinetic;          /**< J, in the last step */
  double potential;        /**< J */
  double linear[3];        /**< N s, world */
  double angular[3];       /**< N m s, world, about the origin */
  double total_kinetic;    /**< J, since the ledger began, with the last step */
  double total_potential;  /**< J */
  double total_linear[3];  /**< N s, world */
  double total_angular[3]; /**< N m s, world, about the origin */
} carom_ledger_entry;

/** The state itself, summed apart from the causes. After a step `now` is `before` plus the causes of that step, and
 *  `start` plus their totals, but for rounding: no more than the bounds here. */
typedef struct carom_ledger_state {
  uint32_t struct_size;
  uint32_t is_kept;              /**< 0: no ledger, all below is 0 */
  uint64_t steps;                /**< since the ledger began */
  double start_kinetic;          /**< J, as the ledger began */
  double start_potential;        /**< J */
  double start_linear[3];        /**< N s */
  double start_angular[3];       /**< N m s */
  double before_kinetic;         /**< J, after the step before the last */
  double before_potential;       /**< J */
  double before_linear[3];       /**< N s */
  double before_angular[3];      /**< N m s */
  double now_kinetic;            /**< J, after the last step */
  double now_potential;          /**< J */
  double now_linear[3];          /**< N s */
  double now_angular[3];         /**< N m s */
  double rounding_energy;        /**< J, of the last step */
  double rounding_linear;        /**< N s */
  double rounding_angular;       /**< N m s */
  double total_rounding_energy;  /**< J, since the ledger began */
  double total_rounding_linear;  /**< N s */
  double total_rounding_angular; /**< N m s */
} carom_ledger_state;

/** Keep a ledger from now on, anew if one is kept; or none. Off in a new world.
 *  @param on  0 or 1
 *  @status OK; NULL_ARGUMENT; UNKNOWN_ENUM (on); BUSY; REENTRANT; OUT_OF_MEMORY: as it was */
CAROM_API int32_t carom_world_enable_ledger(carom_world *world, uint32_t on, carom_error *error);

/** Copy out all causes, in the order above; none of a world that keeps no ledger.
 *  @param dst      [capacity] elements `stride` bytes apart; may be NULL if capacity is 0
 *  @param stride   sizeof(carom_ledger_entry) as the caller knows it
 *  @param count    out: how many there are (may exceed capacity; capacity are written)
 *  @status OK; NULL_ARGUMENT; BUFFER_TOO_SMALL; OUT_OF_RANGE (stride); BUSY */
CAROM_API int32_t carom_world_get_ledger(carom_world *world, carom_ledger_entry *dst, uint64_t stride,
                                         uint64_t capacity, uint64_t *count, carom_error *error);

/** @status OK; NULL_ARGUMENT; STRUCT_SIZE; BUSY */
CAROM_API int32_t carom_world_get_ledger_state(carom_world *world, carom_ledger_state *state, carom_error *error);

#ifdef __cplusplus
}
#endif
#endif
