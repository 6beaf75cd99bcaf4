/** @file world.h
 *  The second root: a world owns materials, bodies and colliders, and steps them.
 *  @thread world: a call that is named get, is or read is a reader of its world, any other call its writer. Readers
 *  may run at the same time. A writer is BUSY while another thread reads, changes or steps the world, and a reader
 *  while one changes or steps it. Neither waits for the other. Different worlds are independent of each other.
 */
#ifndef CAROM_WORLD_H
#define CAROM_WORLD_H

#include <carom/dial.h>
#include <carom/shape.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct carom_world carom_world;

/** What a world is made from. Fill with carom_world_desc_init(). */
typedef struct carom_world_desc {
  uint32_t struct_size;
  uint32_t reserved;      /**< 0 */
  double gravity[3];      /**< m/s^2, default (0, -9.81, 0) */
  uint64_t body_capacity; /**< bodies to reserve memory for; it grows beyond. default 0 */
} carom_world_desc;

/** @status OK; NULL_ARGUMENT; STRUCT_SIZE */
CAROM_API int32_t carom_world_desc_init(carom_world_desc *desc, uint32_t struct_size);

/** @param desc may be NULL: defaults   @owns the caller: carom_world_destroy(), before the engine
 *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; NOT_FINITE; OUT_OF_RANGE; LIMIT (65,535 engines and worlds in
 *          all); OUT_OF_MEMORY   @thread engine */
CAROM_API int32_t carom_world_create(carom_engine *engine, const carom_world_desc *desc, carom_world **world,
                                     carom_error *error);

/** Destroys its bodies, colliders, materials and particles too.   @status OK; NULL_ARGUMENT; BUSY; REENTRANT */
CAROM_API int32_t carom_world_destroy(carom_world *world, carom_error *error);

/** Advance by dt.
 *  @param dt s, in [1e-9, 1]
 *  @status OK; NULL_ARGUMENT; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT; OUT_OF_MEMORY
 *  Out of memory: no body has moved and forces are still pending; contact caches may have been dropped.
 *  A plugin that misbehaves does not fail the step: its pairs are skipped and carom_world_get_faults() reports it. */
CAROM_API int32_t carom_world_step(carom_world *world, double dt, carom_error *error);

/** @param value within the dial's bounds; whole for choices and integers
 *  @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT */
CAROM_API int32_t carom_world_set_dial(carom_world *world, uint32_t dial, double value, carom_error *error);
/** @param value as carom_world_set_dial() takes it   @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; BUSY */
CAROM_API int32_t carom_world_get_dial(carom_world *world, uint32_t dial, double *value, carom_error *error);

/** Set all dials that presets speak of, from the next step on; see carom_preset_get_dial(). Later calls of
 *  carom_world_set_dial() change them one by one.   @param preset CAROM_PRESET_*
 *  @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; BUSY; REENTRANT */
CAROM_API int32_t carom_world_set_preset(carom_world *world, uint32_t preset, carom_error *error);

/** @param gravity [3] m/s^2, |each| <= 1e6   @status OK; NULL_ARGUMENT; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT */
CAROM_API int32_t carom_world_set_gravity(carom_world *world, const double gravity[3], carom_error *error);
/** @status OK; NULL_ARGUMENT; BUSY */
CAROM_API int32_t carom_world_get_gravity(carom_world *world, double gravity[3], carom_error *error);

/* ---- what the last step did ---- */

#define CAROM_STAGE_REFRESH 0u   /* which effects have participants; bounds */
#define CAROM_STAGE_BROAD 1u     /* pairs of bounds that overlap */
#define CAROM_STAGE_NARROW 2u    /* contacts of pairs */
#define CAROM_STAGE_GROUP 3u     /* contact groups */
#define CAROM_STAGE_INTEGRATE 4u /* forces, velocities, positions */
#define CAROM_STAGE_SOLVE 5u     /* velocities at contacts */
#define CAROM_STAGE_RELAX 6u     /* penetration at contacts */
#define CAROM_STAGE_OBSERVE 7u   /* residuals, events */
#define CAROM_STAGE_COUNT 8u

/** Times, counts and residuals of the last step. A stage without participants did not run: its time is 0. */
typedef struct carom_step_report {
  uint32_t struct_size;
  uint32_t stage_count;        /**< CAROM_STAGE_COUNT of this library */
  double stage_seconds[16];    /**< s, [stage_count] used, index CAROM_STAGE_* */
  double total_seconds;        /**< s */
  uint64_t steps;              /**< since the world was made */
  double time;                 /**< s, simulated */
  uint64_t bodies;             /**< all kinds; particles are counted by themselves */
  uint64_t dynamic_bodies;     /**< asleep ones too */
  uint64_t colliders;          /**< of all bodies */
  uint64_t broad_pairs;        /**< pairs that the broad phase reported */
  uint64_t contact_pairs;      /**< of them, pairs with at least one contact point */
  uint64_t contact_points;     /**< of all contact pairs */
  uint64_t groups;             /**< contact groups with at least one contact */
  uint64_t largest_group;      /**< contact points in it */
  uint64_t gjk_calls;          /**< generic queries */
  uint64_t epa_calls;          /**< of shapes that overlap */
  uint64_t support_calls;      /**< single calls of support functions */
  uint64_t velocity_impulses;  /**< impulses applied by the solver */
  uint64_t position_moves;     /**< penetration corrections applied */
  uint64_t quarantined_bodies; /**< held still since their state was not finite, in all */
  uint64_t faults;             /**< plugin faults in this step */
  double max_penetration;      /**< m, over all contact points after the step; 0 if none */
  double mean_penetration;     /**< m, over contact points that overlap after the step */
  double max_closing_speed;    /**< m/s left at touching contact points after the step */
  double linear_energy;        /**< J, kinetic, with that of particles */
  double angular_energy;       /**< J, kinetic */
  uint64_t asleep_bodies;      /**< after the step, counted under dynamic_bodies */
  uint64_t fell_asleep;        /**< of them, in this step */
  uint64_t woke_up;            /**< bodies that woke in this step or since the one before */
  uint64_t direct_groups;      /**< of the groups, those that CAROM_SOLVER_AUTO gave to the direct solver */
  double solver_residual;      /**< m/s, how far the direct solver's solution is from Coulomb's law at the worst contact
                                    point and substep; 0 where it had nothing to do. Of islands with joints, from that
                                    law with friction as bounded by the loads of the substep before */
  uint64_t particles;          /**< in all sets */
  uint64_t quarantined_particles; /**< of them, held still since their state left the world */
  uint64_t swept_bodies;          /**< swept from pose to pose, see carom_body_set_continuous() */
  uint64_t sweep_hits;            /**< what they met in the step's substeps, resolved at the time of impact */
  uint64_t wedged_groups;      /**< groups of the direct solver, counted a substep, that no velocity could satisfy, as
                                    where two surfaces close on a body: their contacts yield */
  uint64_t rejected_solutions; /**< solutions of the direct solver by which contacts would have added energy, counted a
                                    substep: contacts yield there, which cannot */
  double excess_energy; /**< J, kinetic, that islands with joints and contacts, or whose contacts yield, have beyond
                                    what their rows may give, summed over substeps; above 0 only where the work of a
                                    step did not suffice to solve one */
} carom_step_report;

/** @status OK; NULL_ARGUMENT; STRUCT_SIZE; BUSY */
CAROM_API int32_t carom_world_get_report(carom_world *world, carom_step_report *report, carom_error *error);

/** Static name of a stage ("broad"), or "?".
 *  @param stage CAROM_STAGE_* */
CAROM_API const char *carom_stage_name(uint32_t stage);

/** A contact point of the last step. */
typedef struct carom_contact {
  carom_collider collider_a; /**< first of the pair */
  carom_collider collider_b; /**< second of the pair */
  carom_body body_a;         /**< of collider_a */
  carom_body body_b;         /**< of collider_b */
  double point[3];           /**< m, world, midway between the two surfaces */
  double normal[3];          /**< unit, world, from A to B */
  double separation;         /**< m, negative in overlap */
  double normal_impulse;     /**< N s, summed over the step, along the normal on B */
  double friction_impulse;   /**< N s, magnitude, summed over the step */
} carom_contact;

/** Copy out the contact points of the last step, in a deterministic order; those of colliders destroyed since are gone.
 *  @param dst      [capacity] elements `stride` bytes apart; may be NULL if capacity is 0
 *  @param stride   sizeof(carom_contact) as the caller knows it
 *  @param count    out: how many there are (may exceed capacity; capacity are written)
 *  @status OK; NULL_ARGUMENT; BUFFER_TOO_SMALL; OUT_OF_RANGE (stride); BUSY */
CAROM_API int32_t carom_world_get_contacts(carom_world *world, carom_contact *dst, uint64_t stride, uint64_t capacity,
                                           uint64_t *count, carom_error *error);

#define CAROM_REASON_ORDINARY 0u   /* soft contacts hold it */
#define CAROM_REASON_MASS_RATIO 1u /* bodies that touch have masses further apart than CAROM_DIAL_DIRECT_RATIO */
#define CAROM_REASON_SINK \
  2u                             /* soft contacts would let it sink by more than CAROM_DIAL_DIRECT_SINK, or did
                                   before it lay still */
#define CAROM_REASON_TOO_MUCH 3u /* too many bodies for the direct solver, or it exceeded its work limit recently */
#define CAROM_REASON_IMPACT 4u   /* it would sink, but is under impact: soft contacts take that */
#define CAROM_REASON_FEW 5u      /* so few bodies that they are solved directly, whatever they do */

/** A contact group of the last step, and which solver CAROM_SOLVER_AUTO chose for it. */
typedef struct carom_group {
  carom_body body;   /**< one of its bodies; CAROM_NULL_HANDLE if that was destroyed since */
  uint32_t bodies;   /**< that contacts move */
  uint32_t points;   /**< contact points */
  uint32_t solver;   /**< CAROM_SOLVER_SOFT_STEP or CAROM_SOLVER_DIRECT */
  uint32_t reason;   /**< CAROM_REASON_* */
  double mass_ratio; /**< the most of two bodies that touch; 1 for CAROM_REASON_FEW, which it does not matter to */
  double sink;       /**< how deep soft contacts would let a body sink, over the thickness of the thinner of the two;
                          0 for CAROM_REASON_FEW */
} carom_group;

/** Copy out the contact groups of the last step, in a deterministic order. Other solvers than CAROM_SOLVER_AUTO treat
 *  all groups alike: then there are none.
 *  @param dst      [capacity] elements `stride` bytes apart; may be NULL if capacity is 0
 *  @param stride   sizeof(carom_group) as the caller knows it
 *  @param count    out: how many there are (may exceed capacity; capacity are written)
 *  @status OK; NULL_ARGUMENT; BUFFER_TOO_SMALL; OUT_OF_RANGE (stride); BUSY */
CAROM_API int32_t carom_world_get_groups(carom_world *world, carom_group *dst, uint64_t stride, uint64_t capacity,
                                         uint64_t *count, carom_error *error);

#define CAROM_FAULT_RETURNED 1u       /* the support function returned nonzero */
#define CAROM_FAULT_NOT_FINITE 2u     /* it gave NaN or infinity */
#define CAROM_FAULT_OUTSIDE 3u        /* a point outside the shape's bounding radius */
#define CAROM_FAULT_NOT_SUPPORT 4u    /* a point worse than one it had given before */
#define CAROM_FAULT_BODY_STATE 5u     /* a body's state was not finite; the body is quarantined */
#define CAROM_FAULT_PARTICLE_STATE 6u /* likewise particles', see carom_particles_get_quarantined() */

/** Something misbehaved in the last step; the world stayed finite. */
typedef struct carom_fault {
  uint32_t kind; /**< CAROM_FAULT_* */
  uint32_t reserved;
  carom_shape shape;         /**< shape in quarantine, or CAROM_NULL_HANDLE */
  carom_body body;           /**< a body with this shape, or the quarantined body */
  double dir[3];             /**< bits of the direction given */
  double out[3];             /**< bits of what came back */
  carom_particles particles; /**< the set, of PARTICLE_STATE, or CAROM_NULL_HANDLE */
  uint64_t particle;         /**< the first of it that was put in quarantine in this step: its index then */
} carom_fault;

/** Copy out the faults of the last step; arguments as carom_world_get_contacts(). */
CAROM_API int32_t carom_world_get_faults(carom_world *world, carom_fault *dst, uint64_t stride, uint64_t capacity,
                                         uint64_t *count, carom_error *error);

/** 64-bit hash of the dynamic state: equal iff (up to collision of the hash) every pose, velocity and cached contact
 *  has the same bits, and every particle's position and velocity.
 *  @param hash of the state
 *  @status OK; NULL_ARGUMENT; BUSY   @thread reader */
CAROM_API int32_t carom_world_hash(carom_world *world, uint64_t *hash, carom_error *error);

#ifdef __cplusplus
}
#endif
#endif
