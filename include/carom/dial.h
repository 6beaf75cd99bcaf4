/** @file dial.h
 *  Dials: every approximation is one number with a name, bounds and an order from cheap to exact.
 *  One table inside the engine feeds these calls, the command line and the docs.
 *  @thread any: no call here takes an engine or a world.
 */
#ifndef CAROM_DIAL_H
#define CAROM_DIAL_H

#include <carom/base.h>

#ifdef __cplusplus
extern "C" {
#endif

/* ---- dials of a world; values are doubles, choices are whole numbers ---- */
/* clang-format off */
#define CAROM_DIAL_INTEGRATOR 0u          /* choice: CAROM_INTEGRATOR_* */
#define CAROM_DIAL_ROTATION 1u            /* choice: CAROM_ROTATION_*: how bodies with unlike moments of inertia
                                             spin */
#define CAROM_DIAL_SUBSTEPS 2u            /* integrate-and-solve passes per step */
#define CAROM_DIAL_SOLVER 3u              /* choice: CAROM_SOLVER_* */
#define CAROM_DIAL_VELOCITY_ITERATIONS 4u /* severity: at most this many impulses per contact of a group and substep */
#define CAROM_DIAL_POSITION_ITERATIONS 5u /* severity: at most this many position corrections per contact of a group
                                             and substep; 0: none, under direct, too */
#define CAROM_DIAL_VELOCITY_TOLERANCE 6u  /* m/s: velocity error left unresolved at a contact */
#define CAROM_DIAL_POSITION_TOLERANCE 7u  /* m: penetration left unresolved; of what is thin at most 2 % of its
                                             thickness */
#define CAROM_DIAL_RESTITUTION_SPEED 8u   /* m/s: below this approach speed a contact does not bounce */
#define CAROM_DIAL_SEVERITY_SEARCH 9u     /* choice: CAROM_SEARCH_* */
#define CAROM_DIAL_GROUPS 10u             /* choice: 0 one group for all contacts, 1 contact groups (islands) */
#define CAROM_DIAL_BROAD_PHASE 11u        /* choice: CAROM_BROAD_* */
#define CAROM_DIAL_GRID_CELL 12u          /* m: cell size of the uniform grid; 0: chosen from the scene */
#define CAROM_DIAL_CONTACT_DISTANCE 13u   /* m: pairs nearer than this make contacts */
#define CAROM_DIAL_PAIR_ROUTINES 14u      /* choice: 0 generic path for every pair, 1 specific routines where
                                             declared */
#define CAROM_DIAL_NARROW_PHASE 15u       /* choice: CAROM_NARROW_* for the generic path */
#define CAROM_DIAL_SIMPLEX 16u            /* choice: CAROM_SIMPLEX_* */
#define CAROM_DIAL_GJK_TOLERANCE 17u      /* relative width of the bracket at which GJK and EPA stop */
#define CAROM_DIAL_GJK_ITERATIONS 18u     /* cap */
#define CAROM_DIAL_EPA_ITERATIONS 19u     /* cap */
#define CAROM_DIAL_HYBRID_MARGIN 20u      /* m: shell around each shape in CAROM_NARROW_HYBRID */
#define CAROM_DIAL_WARM_SEPARATION 21u    /* choice: 0 start each query afresh, 1 start from the last separating
                                             vector */
#define CAROM_DIAL_MANIFOLD 22u           /* choice: CAROM_MANIFOLD_* */
#define CAROM_DIAL_CACHE_DISTANCE 23u     /* m: a cached point is dropped when it drifted further than this */
#define CAROM_DIAL_WARM_START 24u         /* choice: 0 solve each step from zero, 1 start from the last step's
                                             impulses */
#define CAROM_DIAL_CARRY_OVER 25u         /* relative width up to which an earlier bracket, widened by the motion
                                             since, stands in for a query of the generic path; 0: off */
#define CAROM_DIAL_CONTACT_FREQUENCY 26u  /* Hz: stiffness of soft contacts; what is thin has stiffer ones, and sinks by
                                             0.1 % of its thickness under its own weight */
#define CAROM_DIAL_CONTACT_DAMPING 27u    /* damping ratio of soft contacts */
#define CAROM_DIAL_PUSH_SPEED 28u         /* m/s: overlap of a contact is undone at this speed at most (soft,
                                             direct) */
#define CAROM_DIAL_SLEEP 29u              /* choice: 0 everything is simulated, 1 islands that came to rest sleep
                                             until something touches them; see carom_body_is_asleep() */
#define CAROM_DIAL_SLEEP_SPEED 30u        /* m/s: no point of a body that falls asleep moves faster */
#define CAROM_DIAL_SLEEP_TIME 31u         /* s: for how long it has been so */
#define CAROM_DIAL_DIRECT_SINK 32u        /* CAROM_SOLVER_AUTO solves groups directly that would sink by more of their
                                             thickness */
#define CAROM_DIAL_DIRECT_RATIO 33u       /* or where touching bodies' masses are further apart than this */
#define CAROM_DIAL_DIRECT_WORK 34u        /* unless they take more block products a step than this */
#define CAROM_DIAL_HOLD_ANGLE 35u         /* rad: arms of contacts turn with a body only when it has turned by this */
#define CAROM_DIAL_JOINT_FREQUENCY 36u    /* Hz: stiffness of joints that the direct solver does not solve */
#define CAROM_DIAL_JOINT_DAMPING 37u      /* their damping ratio */
#define CAROM_DIAL_CONTINUOUS 38u         /* choice: CAROM_SWEEP_*: what is swept from pose to pose, so that it passes
                                             through nothing; see carom_body_set_continuous() */
#define CAROM_DIAL_PRECISION 39u          /* choice: CAROM_PRECISION_*: the numbers in which contacts are solved */
#define CAROM_DIAL_JOINT_ORDER 40u        /* 2, 4, 6: order of the error of islands that joints alone hold, in 1, 5 or
                                             9 stages a substep, gaps at rounding (odd: the next); above 2 also of
                                             bodies that springs, drag and fields alone move; 0: as joints in contact
                                             are, under CAROM_INTEGRATOR_RK4 to order 4 */
#define CAROM_DIAL_ACCURACY_PLACE 41u     /* m per second of motion: tolerance of places, see accuracy.h;
                                             0: none */
#define CAROM_DIAL_ACCURACY_TURN 42u      /* rad per second, likewise */
#define CAROM_DIAL_ACCURACY_SUBSTEPS 43u  /* bound of work: substeps of an island in a step */
#define CAROM_DIAL_ACCURACY_WORK 44u      /* likewise of islands in contact: contact points times substeps */
#define CAROM_DIAL_KEEP_DISTANCE 45u      /* m: how far two bodies may move before contact points of theirs that lie
                                             in flat faces and edges are looked for anew; meanwhile they stay with the
                                             bodies, and separations are off by its square over the smaller
                                             radius at most; 0: looked for in each step */
#define CAROM_DIAL_COUNT 46u
/* clang-format on */

#define CAROM_INTEGRATOR_EXPLICIT_EULER 0u      /* first order */
#define CAROM_INTEGRATOR_SEMI_IMPLICIT_EULER 1u /* first order, symplectic */
#define CAROM_INTEGRATOR_RK4 2u                 /* fourth order, four evaluations of forces */
#define CAROM_INTEGRATOR_VELOCITY_VERLET 3u     /* exact under constant forces, second order under others */

#define CAROM_ROTATION_NONE 0u     /* no gyroscopic term: exact for spheres and cubes only */
#define CAROM_ROTATION_EXPLICIT 1u /* the term is a torque like any other (RK4 evaluates it four times) */
#define CAROM_ROTATION_IMPLICIT 2u /* one Newton step of the implicit term; under RK4 the same as EXPLICIT */
/* These keep the angular momentum of a body that nothing acts on; under CAROM_INTEGRATOR_RK4 they are the same as
 * EXPLICIT. The number is the order of the error. */
#define CAROM_ROTATION_RK4 3u          /* Runge-Kutta on the quaternion */
#define CAROM_ROTATION_LIE_MIDPOINT 4u /* midpoint rule on the rotation group, order 2 */
#define CAROM_ROTATION_SPLITTING 5u    /* three exact turns, order 2, symplectic: energy errs by a bounded amount */
#define CAROM_ROTATION_SPLITTING_4 6u  /* five of them (Suzuki) */
#define CAROM_ROTATION_SPLITTING_6 7u  /* seven of them (Yoshida) */

/* clang-format off */
#define CAROM_SOLVER_SEVERITY 0u  /* most severe contact first, by group: that of the paper of 2011 */
#define CAROM_SOLVER_SOFT_STEP 1u /* one sweep a substep over soft contacts, one that relaxes them: needs about 4
                                     substeps */
#define CAROM_SOLVER_DIRECT 2u    /* each contact group as one problem, solved to a residual: small hard groups */
#define CAROM_SOLVER_AUTO 3u      /* soft_step, but direct for groups that it would not hold; says which and why */
/* clang-format on */

#define CAROM_SEARCH_LINEAR 0u /* the paper's: scan all contacts of the group for the most severe */
#define CAROM_SEARCH_HEAP 1u   /* the same order from a heap */

#define CAROM_BROAD_BRUTE_FORCE 0u     /* every bound with every other */
#define CAROM_BROAD_SWEEP_AND_PRUNE 1u /* sorted axes; the paper's */
#define CAROM_BROAD_GRID 2u            /* cells filled afresh in every step: the same cost however bodies move */
#define CAROM_BROAD_TREE 3u            /* a tree of fat boxes: what stays about where it was costs next to nothing */

/* clang-format off */
#define CAROM_NARROW_HYBRID 0u  /* van den Bergen: GJK on shapes with a margin shell, EPA only for deep contact; the
                                   shells make every shape larger by the margin */
#define CAROM_NARROW_GJK_EPA 1u /* GJK on cores, EPA on overlap; exact geometry */
/* clang-format on */

#define CAROM_SIMPLEX_JOHNSON 0u      /* Johnson's sub-algorithm, of determinants */
#define CAROM_SIMPLEX_VORONOI 1u      /* by Voronoi regions, all features */
#define CAROM_SIMPLEX_VORONOI_LAST 2u /* only features that touch the newest vertex, all features as a fall-back */

/* clang-format off */
#define CAROM_MANIFOLD_SINGLE 0u /* the deepest point alone */
#define CAROM_MANIFOLD_CACHE 1u  /* up to 4 points gathered over steps */
#define CAROM_MANIFOLD_PATCH 2u  /* up to 4 points of the whole patch at once, probed for by support functions
                                    alone */
#define CAROM_MANIFOLD_CLIP 3u   /* the same, with declared faces (box, polytope) clipped exactly; others probed
                                    for */
/* clang-format on */

#define CAROM_SWEEP_NONE 0u    /* bodies that move farther in a step than they are large may pass through things */
#define CAROM_SWEEP_FLAGGED 1u /* bodies of CAROM_CONTINUOUS_ALWAYS */
#define CAROM_SWEEP_FAST 2u    /* also what moves far for its size in a step */

/* In soft_step, and in what auto gives to it, the rows of contacts (arms, masses, impulses) are floats or doubles.
 * Poses, velocities, the search for contacts, joints and the direct solver are doubles in any case. A step with
 * contacts that floats can't bear is solved in doubles: masses outside 1e-9 to 1e9 kg, places more than 10 km from a
 * body's centre of mass, friction beyond 1e6, needles thinner than 1 : 700, substeps below 1e-9 s. */
#define CAROM_PRECISION_FLOAT 0u /* floats */
/* clang-format off */
#define CAROM_PRECISION_AUTO 1u   /* floats in steps with 512 pairs in contact or more, where their memory saves
                                     time */
#define CAROM_PRECISION_DOUBLE 2u /* presets accurate and reference have it */
/* clang-format on */

#define CAROM_PRESET_FAST 0u      /* one substep and coarse distances: crowds, debris, what is seen from afar */
#define CAROM_PRESET_BALANCED 1u  /* what a new world has */
#define CAROM_PRESET_ACCURATE 2u  /* a quarter of its error, at two to four times its cost */
#define CAROM_PRESET_REFERENCE 3u /* to compare others with: as exact as the library is at a given step */
#define CAROM_PRESET_COUNT 4u

#define CAROM_DIAL_KIND_NUMBER 0u  /* any number within its bounds */
#define CAROM_DIAL_KIND_INTEGER 1u /* a whole number within its bounds */
#define CAROM_DIAL_KIND_CHOICE 2u  /* one of its named values */

/** What a dial is: documentation and bounds. Strings have static storage. */
typedef struct carom_dial_info {
  uint32_t struct_size;
  uint32_t dial;              /**< CAROM_DIAL_* */
  uint32_t kind;              /**< CAROM_DIAL_KIND_* */
  uint32_t choice_count;      /**< for a choice: number of values, 0..choice_count-1 */
  const char *name;           /**< "broad_phase" */
  const char *unit;           /**< "m", "m/s", "" */
  const char *summary;        /**< one sentence: what it trades */
  const char *const *choices; /**< [choice_count] names in order; NULL unless a choice */
  double min;                 /**< inclusive */
  double max;                 /**< inclusive */
  double initial;             /**< value of a new world */
} carom_dial_info;

/** @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM (dial >= CAROM_DIAL_COUNT of this library) */
CAROM_API int32_t carom_dial_get_info(uint32_t dial, carom_dial_info *info, carom_error *error);

/** Number of dials this library has.   @status OK; NULL_ARGUMENT */
CAROM_API int32_t carom_dial_get_count(uint32_t *count);

/** @param name as in carom_dial_info.name
 *  @status OK; NULL_ARGUMENT; NOT_FOUND; READ_ONLY (this is a constant, not a dial) */
CAROM_API int32_t carom_dial_find(const char *name, uint32_t *dial, carom_error *error);

/* ---- constants: numbers of the library that trade nothing, so that none can be set; read them to know why ---- */

/** What a constant is. Strings have static storage. Names are distinct from those of dials; which constants there are,
 *  and in which order, may change from version to version. */
typedef struct carom_constant_info {
  uint32_t struct_size;
  uint32_t constant;       /**< its number, from 0 */
  const char *name;        /**< "direct_impact_share" */
  const char *unit;        /**< "rad", "steps"; "1" of a share or a ratio */
  const char *reason;      /**< what it is, and why it is as large as that */
  const char *consequence; /**< what breaks if it moves */
  double value;            /**< in its unit */
} carom_constant_info;

/** Number of constants this library has.   @status OK; NULL_ARGUMENT */
CAROM_API int32_t carom_constant_get_count(uint32_t *count);

/** @param constant from 0   @param info out
 *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM (constant >= carom_constant_get_count()) */
CAROM_API int32_t carom_constant_get_info(uint32_t constant, carom_constant_info *info, carom_error *error);

/* ---- presets: points on the measured front of error against time, from cheap to exact ---- */

/** Static name of a preset ("balanced"), or "?".
 *  @param preset CAROM_PRESET_* */
CAROM_API const char *carom_preset_name(uint32_t preset);

/** What a preset sets a dial to. Presets speak of dials that trade accuracy for time, and all of the same ones; how a
 *  world finds pairs, what sleeps, and what a host chose for its look they leave alone.
 *  @param preset CAROM_PRESET_*   @param dial CAROM_DIAL_*   @param value out
 *  @param value what the preset sets the dial to
 *  @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; NOT_FOUND (presets leave this dial alone) */
CAROM_API int32_t carom_preset_get_dial(uint32_t preset, uint32_t dial, double *value, carom_error *error);

#ifdef __cplusplus
}
#endif
#endif
