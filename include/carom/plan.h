/** @file plan.h
 *  The plan of a step: which effects run, for which participants, why, and what they cost; what was left out, and why.
 *  And what a host overrides: an effect is forbidden, or forced.
 *
 *  An effect runs for its participants alone. Without participants it executes nothing and allocates nothing, and the
 *  world has the bits of a world in which it is forbidden.
 *  @thread world: a call that is named get, is or read is a reader of its world, any other call its writer (world.h).
 */
#ifndef CAROM_PLAN_H
#define CAROM_PLAN_H

#include <carom/world.h>

#ifdef __cplusplus
extern "C" {
#endif

#define CAROM_EFFECT_GYROSCOPIC 0u           /* gyroscopic term of bodies with unlike moments of inertia */
#define CAROM_EFFECT_LINEAR_DAMPING 1u       /* damping of velocity */
#define CAROM_EFFECT_ANGULAR_DAMPING 2u      /* damping of rotation */
#define CAROM_EFFECT_GRAVITY 3u              /* the world's gravity */
#define CAROM_EFFECT_USER_FORCE 4u           /* forces of the host, at the centre of mass or elsewhere */
#define CAROM_EFFECT_USER_TORQUE 5u          /* torques of the host */
#define CAROM_EFFECT_COLLISION 6u            /* the search for contacts */
#define CAROM_EFFECT_FRICTION 7u             /* friction at contacts */
#define CAROM_EFFECT_RESTITUTION 8u          /* bounces */
#define CAROM_EFFECT_ROLLING_RESISTANCE 9u   /* resistance of contacts to rolling */
#define CAROM_EFFECT_SPINNING_RESISTANCE 10u /* resistance of contacts to spinning about the normal */
#define CAROM_EFFECT_SLEEP 11u               /* islands at rest are not stepped */
#define CAROM_EFFECT_PARTICLES 12u           /* sets of particles */
#define CAROM_EFFECT_FILTER 13u              /* categories, masks and groups of colliders */
#define CAROM_EFFECT_SENSOR 14u              /* colliders that only report what overlaps them */
#define CAROM_EFFECT_JOINTS 15u              /* joints: what they lock */
#define CAROM_EFFECT_SCENERY 16u             /* meshes and height fields */
#define CAROM_EFFECT_CONTINUOUS 17u          /* fast bodies are swept */
#define CAROM_EFFECT_SURFACE_VELOCITY 18u    /* surfaces that move: conveyors */
#define CAROM_EFFECT_AXIS_LOCKS 19u          /* locked axes of bodies */
#define CAROM_EFFECT_DRAG 20u                /* drag of bodies */
#define CAROM_EFFECT_WIND 21u                /* wind on bodies with drag */
#define CAROM_EFFECT_FIELDS 22u              /* force fields */
#define CAROM_EFFECT_SPRINGS 23u             /* springs between bodies */
#define CAROM_EFFECT_BUOYANCY 24u            /* water */
/* clang-format off */
#define CAROM_EFFECT_RESPONSE 25u /* what contacts do: without it bodies pass through each other, and there are no
                                     contact points */
#define CAROM_EFFECT_JOINT_LIMITS 26u /* limits of joints */
#define CAROM_EFFECT_JOINT_MOTORS 27u /* motors and springs of joints */
#define CAROM_EFFECT_EVENTS 28u       /* events that a host collects */
#define CAROM_EFFECT_LEDGER 29u       /* accounts of energy and momentum */
#define CAROM_EFFECT_MAGNETISM 30u    /* magnetic moments in magnetic fields */
#define CAROM_EFFECT_COUNT 31u
/* clang-format on */

/* clang-format off */
#define CAROM_MODE_AS_NEEDED 0u /* it runs for the bodies that need it (default) */
#define CAROM_MODE_FORBID 1u    /* it does not run */
#define CAROM_MODE_FORCE 2u     /* it runs for all bodies that it can act on, whether they need it or not: to see what
                                   it costs, and that it changes nothing. It makes no joints, sets, ... where there
                                   are none */
/* clang-format on */

/** Static name of an effect ("gravity"), or "?". */
CAROM_API const char *carom_effect_name(uint32_t effect);

/** Forbid or force an effect from the next step on, for all bodies. Wakes all bodies. Forbidding one that the scene
 *  needs is allowed, and carom_world_get_plan() says so.
 *  @param effect CAROM_EFFECT_*   @param mode CAROM_MODE_*
 *  @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; BUSY; REENTRANT */
CAROM_API int32_t carom_world_set_effect(carom_world *world, uint32_t effect, uint32_t mode, carom_error *error);
/** @param mode out   @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; BUSY */
CAROM_API int32_t carom_world_get_effect(carom_world *world, uint32_t effect, uint32_t *mode, carom_error *error);

/** The same for one body: its forces, its colliders, the contacts, joints and springs it is in. What is forbidden for
 *  the world is forbidden for it. Particles, events and the ledger are not a body's.
 *  @param mode CAROM_MODE_*
 *  @status OK; NULL_ARGUMENT; *_HANDLE; UNKNOWN_ENUM; UNSUPPORTED (PARTICLES, EVENTS, LEDGER: use
 *          carom_world_set_effect()); BUSY; REENTRANT; OUT_OF_MEMORY */
CAROM_API int32_t carom_body_set_effect(carom_world *world, carom_body body, uint32_t effect, uint32_t mode,
                                        carom_error *error);
/** @param mode out: of the body itself   @status OK; NULL_ARGUMENT; *_HANDLE; UNKNOWN_ENUM; BUSY */
CAROM_API int32_t carom_body_get_effect(carom_world *world, carom_body body, uint32_t effect, uint32_t *mode,
                                        carom_error *error);

/** Whether each force effect is timed by itself in carom_world_get_plan(), which costs two looks at the clock for each.
 *  @param on 1 or 0 (as a world is created)
 *  @status OK; NULL_ARGUMENT; OUT_OF_RANGE; BUSY; REENTRANT */
CAROM_API int32_t carom_world_time_effects(carom_world *world, uint32_t on, carom_error *error);

#define CAROM_PLAN_NO_EFFECT 0xffffffffu /* the line is a stage */

#define CAROM_TIME_OWN 0u      /* seconds is its own */
#define CAROM_TIME_IN_STAGE 1u /* it is done within the loops of its stage, and in the time of that */
#define CAROM_TIME_OFF 2u      /* not measured, see carom_world_time_effects() */

/** A line of the plan: a stage or an effect, as it was in the last step. */
typedef struct carom_plan_line {
  uint32_t effect;       /**< CAROM_EFFECT_*, or CAROM_PLAN_NO_EFFECT: a stage */
  uint32_t stage;        /**< CAROM_STAGE_* that it is part of */
  uint32_t mode;         /**< CAROM_MODE_* for the world */
  uint32_t runs;         /**< 1 or 0 */
  uint64_t participants; /**< participants in the last step */
  uint64_t
      wanted; /**< participants if nothing were forbidden or forced; of effects within contacts, as `participants` */
  uint64_t evaluations; /**< participants of all steps since the world was made, summed */
  uint64_t bytes;       /**< memory held for it alone */
  double seconds;       /**< s, in the last step */
  uint32_t timing;      /**< CAROM_TIME_* */
  uint32_t reserved;
  char name[32];    /**< as carom_effect_name() */
  char unit[24];    /**< what the participants are: "bodies", "contact points" */
  char reason[128]; /**< why it runs, or why not */
} carom_plan_line;

/** Copy out the plan of the last step: stages first, then effects. Before the first step nothing has run.
 *  @param dst      [capacity] elements `stride` bytes apart; may be NULL if capacity is 0
 *  @param stride   sizeof(carom_plan_line) as the caller knows it
 *  @param count    out: how many there are (may exceed capacity; capacity are written)
 *  @status OK; NULL_ARGUMENT; BUFFER_TOO_SMALL; OUT_OF_RANGE (stride); BUSY */
CAROM_API int32_t carom_world_get_plan(carom_world *world, carom_plan_line *dst, uint64_t stride, uint64_t capacity,
                                       uint64_t *count, carom_error *error);

#ifdef __cplusplus
}
#endif
#endif
