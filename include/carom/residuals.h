/** @file residuals.h
 *  How far the last step is from the laws it should obey, and a budget of time that substeps are chosen within.
 *
 *  Computing them costs time only when you call carom_world_get_residuals().
 *  @thread world: a call that is named get, is or read is a reader of its world, any other call its writer (world.h).
 */
#ifndef CAROM_RESIDUALS_H
#define CAROM_RESIDUALS_H

#include <carom/world.h>

#ifdef __cplusplus
extern "C" {
#endif

/** What is left undone. Contacts are those of the last step, with the velocities that it ended with; joints and energy
 *  are those of the present poses and velocities. Violations of Coulomb's law are in m/s: by how much the velocity at
 *  the worst contact would have to be another for its impulse to be right. */
typedef struct carom_residuals {
  uint32_t struct_size;
  uint32_t ledger_is_kept; /**< 1: energy_drift is known, see carom_world_enable_ledger() */
  uint64_t contact_points; /**< of the last step */
  uint64_t joints;         /**< that are attached to a body that is awake, and are not broken */
  double max_penetration;  /**< m, 0 if none */
  double mean_penetration; /**< m, over points that overlap */
  double joint_gap;        /**< m, most that what a joint locks of its points is apart */
  double joint_angle;      /**< rad, likewise of its axes */
  double complementarity;  /**< m/s: a contact that approaches, or pushes while separating, bounces excluded */
  double cone;             /**< m/s: friction larger than its coefficient times the load, of a pair */
  double slip;         /**< m/s: friction that is not against the slip, or a pair that slips with friction to spare */
  double energy;       /**< J, kinetic and of uniform gravity, of bodies and particles */
  double energy_drift; /**< J, in the last step, that nothing accounts for: the ledger's integrator and unassigned; 0
                                 without a ledger */
} carom_residuals;

/** @param residuals with its struct_size set; filled. Before the first step, and after a step without contacts, what
 *                   concerns them is 0.
 *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; BUSY
 *  @accuracy rounding; effective masses are those along the normal
 *  @cost linear in contact points, joints and bodies */
CAROM_API int32_t carom_world_get_residuals(carom_world *world, carom_residuals *residuals, carom_error *error);

/** Choose the dial `substeps` before each step so that steps take about `seconds`. What a substep costs is learnt from
 *  the last steps; if one took too long, substeps drop at once; if there is time left, one is added a step.
 *  Trajectories then depend on the machine's speed: two runs are not the same to the bit. Off (as a world is created)
 *  for lockstep and tests. The steps of a scene that is too expensive even with `fewest` take longer. A budget is the
 *  host's: no snapshot holds it, a copy begins without one, and a record (carom/record.h) has the substeps that it
 *  chose.
 *  @param seconds  s of wall clock a step, 0 < seconds <= 10; 0: off, the dial keeps its value
 *  @param fewest, most  substeps, 1 <= fewest <= most <= the dial's bound; ignored when off
 *  @status OK; NULL_ARGUMENT; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT; OUT_OF_MEMORY */
CAROM_API int32_t carom_world_set_budget(carom_world *world, double seconds, uint32_t fewest, uint32_t most,
                                         carom_error *error);
/** @param seconds, fewest, most  out: as set; 0 when off   @status OK; NULL_ARGUMENT; BUSY */
CAROM_API int32_t carom_world_get_budget(carom_world *world, double *seconds, uint32_t *fewest, uint32_t *most,
                                         carom_error *error);

#ifdef __cplusplus
}
#endif
#endif
