/** @file body.h
 *  Materials, bodies, and colliders (a shape on a body at a local pose); body_bulk.h reads and writes
 *  many bodies at once.
 *  @thread world: a call that is named get, is or read is a reader of its world, any other call its writer (world.h).
 */
#ifndef CAROM_BODY_H
#define CAROM_BODY_H

#include <carom/world.h>

#ifdef __cplusplus
extern "C" {
#endif

/* ---- materials ---- */
#define CAROM_MIX_GEOMETRIC_MEAN 0u /* root of a b */
#define CAROM_MIX_MAXIMUM 1u        /* the larger */
#define CAROM_MIX_MINIMUM 2u        /* the smaller */
#define CAROM_MIX_AVERAGE 3u        /* (a + b) / 2 */
#define CAROM_MIX_MULTIPLY 4u       /* a b */

/** Surface of a collider. Where two materials mix differently, the larger CAROM_MIX_* value decides; of two in particular
 *  carom_material_set_pair() says what they are to each other. */
typedef struct carom_material_desc {
  uint32_t struct_size;
  uint32_t friction_mix;    /**< CAROM_MIX_*, default GEOMETRIC_MEAN */
  uint32_t restitution_mix; /**< CAROM_MIX_*, default MAXIMUM */
  uint32_t reserved;        /**< 0 */
  double friction;          /**< Coulomb coefficient, [0, 1e3], default 0.5 */
  double restitution;       /**< [0, 1], default 0 */
} carom_material_desc;

/** @status OK; NULL_ARGUMENT; STRUCT_SIZE */
CAROM_API int32_t carom_material_desc_init(carom_material_desc *desc, uint32_t struct_size);
/** @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; NOT_FINITE; OUT_OF_RANGE; UNKNOWN_ENUM; BUSY; OUT_OF_MEMORY */
CAROM_API int32_t carom_material_create(carom_world *world, const carom_material_desc *desc, carom_material *material,
                                        carom_error *error);
/** Change a material in place; every collider that uses it follows.   @status as carom_material_create(); *_HANDLE */
CAROM_API int32_t carom_material_update(carom_world *world, carom_material material, const carom_material_desc *desc,
                                        carom_error *error);
/** Resistance of a surface to rolling and to spinning about the normal, 0 when it is created. A contact that presses
 *  with a force N bears a moment of up to rolling * N in its plane and of up to spinning * N about its normal. Mixed as
 *  friction is; carom_material_update() leaves it alone.
 *  @param rolling, spinning m, [0, 1e3]
 *  @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; OUT_OF_MEMORY */
CAROM_API int32_t carom_material_set_resistance(carom_world *world, carom_material material, double rolling,
                                                double spinning, carom_error *error);
/** @param rolling, spinning out: m   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY */
CAROM_API int32_t carom_material_get_resistance(carom_world *world, carom_material material, double *rolling,
                                                double *spinning, carom_error *error);
/** Say what two materials are to each other, instead of mixing them. Wakes what touches so. It ends with either material.
 *  @param material_a, material_b  in any order; the same twice: colliders of that material among themselves
 *  @param surface [4] friction, [0, 1e3]; restitution, [0, 1]; resistance to rolling and to spinning, m, [0, 1e3].
 *                 NULL: they mix again
 *  @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; OUT_OF_MEMORY   @since 0.9 */
CAROM_API int32_t carom_material_set_pair(carom_world *world, carom_material material_a, carom_material material_b,
                                          const double surface[4], carom_error *error);
/** What two materials are to each other: what was said of them, or else what they mix to.
 *  @param surface out, [4]: as carom_material_set_pair() takes it
 *  @status OK; NULL_ARGUMENT; *_HANDLE; BUSY   @since 0.9 */
CAROM_API int32_t carom_material_get_pair(carom_world *world, carom_material material_a, carom_material material_b,
                                          double surface[4], carom_error *error);
/** @status OK; NULL_ARGUMENT; *_HANDLE; IN_USE (a collider uses it); BUSY */
CAROM_API int32_t carom_material_destroy(carom_world *world, carom_material material, carom_error *error);

/* ---- bodies ---- */
#define CAROM_BODY_STATIC 0u    /* never moves */
#define CAROM_BODY_KINEMATIC 1u /* moved by its velocity; infinite mass */
#define CAROM_BODY_DYNAMIC 2u   /* moved by forces, contacts and joints */

/* bits of carom_body_desc.fields: where 0 is a legal value, a bit says "set" */
#define CAROM_BODY_FIELD_MASS 1u    /* mass given; else from colliders' densities */
#define CAROM_BODY_FIELD_CENTER 2u  /* center given; else from colliders. needs MASS */
#define CAROM_BODY_FIELD_INERTIA 4u /* inertia given; else from colliders, scaled to mass. needs MASS */
#define CAROM_BODY_STAYS_AWAKE 8u   /* it never falls asleep, nor does what it touches */
#define CAROM_BODY_DISABLED 16u     /* it takes no part in steps, see carom_body_set_enabled() */

/** What a body is made from. Fill with carom_body_desc_init(). */
typedef struct carom_body_desc {
  uint32_t struct_size;
  uint32_t fields;            /**< CAROM_BODY_FIELD_*, CAROM_BODY_STAYS_AWAKE, CAROM_BODY_DISABLED bits */
  uint32_t type;              /**< CAROM_BODY_*, default DYNAMIC */
  uint32_t reserved;          /**< 0 */
  double position[3];         /**< m, world: origin of the body frame */
  double orientation[4];      /**< x, y, z, w, unit within 1e-6, body to world; default identity */
  double linear_velocity[3];  /**< m/s, world, of the centre of mass; 0 for static */
  double angular_velocity[3]; /**< rad/s, world; 0 for static */
  double mass;                /**< kg, read where fields has CAROM_BODY_FIELD_MASS, else 0; at least
                                   1e-300 for dynamic. A dynamic body without mass from here or from a
                                   collider weighs 1 kg and does not rotate (a particle) */
  double center[3];           /**< m, body frame: centre of mass; each within 1e15 */
  double inertia[9];          /**< kg m^2, body frame axes, about the centre, row-major, symmetric, positive definite;
                                   all zero: the body does not rotate */
  double linear_damping;      /**< 1/s, [0, 1e6], default 0: dv/dt = -c v */
  double angular_damping;     /**< 1/s, [0, 1e6], default 0 */
  uint64_t user;              /**< anything; the engine does not look */
  double
      gravity_factor;  /**< share of the world's gravity that acts on it, default 1: carom_body_set_gravity_factor() */
  uint32_t locks;      /**< CAROM_LOCK_* bits, of a dynamic body, default 0: carom_body_set_locks() */
  uint32_t continuous; /**< CAROM_CONTINUOUS_*, default AUTO: carom_body_set_continuous() */
  double linear_drag;  /**< kg/s, at least 0, default 0: carom_body_set_drag() */
  double quadratic_drag;     /**< kg/m, at least 0, default 0 */
  uint32_t force_field_mask; /**< default 1: carom_body_set_force_field_mask() */
  uint32_t reserved2;        /**< 0 */
  double magnetic_moment[3]; /**< A m^2, axes of the body, of a dynamic body, default 0 */
} carom_body_desc;

/** @status OK; NULL_ARGUMENT; STRUCT_SIZE */
CAROM_API int32_t carom_body_desc_init(carom_body_desc *desc, uint32_t struct_size);
/** @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; UNKNOWN_ENUM; BUSY;
 *          REENTRANT; LIMIT; OUT_OF_MEMORY */
CAROM_API int32_t carom_body_create(carom_world *world, const carom_body_desc *desc, carom_body *body,
                                    carom_error *error);
/** Destroys its colliders too.   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT */
CAROM_API int32_t carom_body_destroy(carom_world *world, carom_body body, carom_error *error);

/** Everything there is to know about a body, with its masses as the engine uses them (fields: all of FIELD_* set; a
 *  body that cannot rotate reports zero inertia; a static or kinematic body reports mass 0).
 *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; BUSY */
CAROM_API int32_t carom_body_get(carom_world *world, carom_body body, carom_body_desc *desc, carom_error *error);

/** @param position [3] m   @param orientation [4] x, y, z, w   @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE;
 *  NOT_UNIT; BUSY; REENTRANT */
CAROM_API int32_t carom_body_set_pose(carom_world *world, carom_body body, const double position[3],
                                      const double orientation[4], carom_error *error);
/** @param linear [3] m/s of the centre of mass   @param angular [3] rad/s, both world frame
 *  @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE (a static body must have 0); BUSY; REENTRANT */
CAROM_API int32_t carom_body_set_velocity(carom_world *world, carom_body body, const double linear[3],
                                          const double angular[3], carom_error *error);
/** @param position [3] out, or NULL: m, world, origin of the body frame   @param orientation [4] out, or NULL: x, y, z,
 *  w, body to world   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY */
CAROM_API int32_t carom_body_get_pose(carom_world *world, carom_body body, double position[3], double orientation[4],
                                      carom_error *error);
/** @param linear [3] out, or NULL: m/s, world, of the centre of mass   @param angular [3] out, or NULL: rad/s, world
 *  @status OK; NULL_ARGUMENT; *_HANDLE; BUSY */
CAROM_API int32_t carom_body_get_velocity(carom_world *world, carom_body body, double linear[3], double angular[3],
                                          carom_error *error);
/** Set the mass of a dynamic body, as carom_body_desc would have. Its frame stays; the velocity of its centre is kept
 *  as that of the new centre. Wakes the body and its island. Snapshots of before do not fit any more (MISMATCH).
 *  @param mass kg, at least 1e-300; or 0: from the densities of its colliders, with center and inertia NULL
 *  @param center [3] m, body frame, or NULL: from its colliders
 *  @param inertia [9] kg m^2, body frame axes, about the centre, row-major, symmetric, positive definite or all zero;
 *  or NULL:
 *                 from its colliders, scaled to the mass
 *  @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE (also: a body that is not dynamic); NO_VOLUME (mass 0,
 *          and a collider is flat); BUSY; REENTRANT; OUT_OF_MEMORY */
CAROM_API int32_t carom_body_set_mass(carom_world *world, carom_body body, double mass, const double center[3],
                                      const double inertia[9], carom_error *error);
/** As the engine uses them: mass 0 of a body that is not dynamic, inertia 0 of one that cannot rotate.
 *  @param mass out, or NULL: kg   @param center [3] out, or NULL: m, body frame   @param inertia [9] out, or NULL: kg
 *  m^2, body frame axes, about the centre, row-major   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY */
CAROM_API int32_t carom_body_get_mass(carom_world *world, carom_body body, double *mass, double center[3],
                                      double inertia[9], carom_error *error);
/** Make a static, kinematic or dynamic body of one that is there. A body that becomes static stops. One that is dynamic
 *  no longer loses the mass that it was given, pending forces and what only dynamic bodies may have
 *  (carom_attribute_info.of_dynamic). Snapshots of before do not fit any more. What it touches wakes.
 *  @param type CAROM_BODY_*
 *  @status OK; NULL_ARGUMENT; *_HANDLE; UNKNOWN_ENUM; OUT_OF_RANGE (a half-space needs a static body, scenery one that
 *          is not dynamic; a joint or a spring needs a dynamic one); NO_VOLUME; BUSY; REENTRANT; OUT_OF_MEMORY */
CAROM_API int32_t carom_body_set_type(carom_world *world, carom_body body, uint32_t type, carom_error *error);
/** @param type out: CAROM_BODY_*   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY */
CAROM_API int32_t carom_body_get_type(carom_world *world, carom_body body, uint32_t *type, carom_error *error);
/** @param linear, angular 1/s, [0, 1e6]: dv/dt = -linear v, likewise of spin   @status OK; NULL_ARGUMENT; *_HANDLE;
 *  NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT */
CAROM_API int32_t carom_body_set_damping(carom_world *world, carom_body body, double linear, double angular,
                                         carom_error *error);
/** @param linear, angular out: 1/s; either may be NULL   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY */
CAROM_API int32_t carom_body_get_damping(carom_world *world, carom_body body, double *linear, double *angular,
                                         carom_error *error);
/** @param user anything; the engine does not look   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT */
CAROM_API int32_t carom_body_set_user(carom_world *world, carom_body body, uint64_t user, carom_error *error);
/** @param user out   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY */
CAROM_API int32_t carom_body_get_user(carom_world *world, carom_body body, uint64_t *user, carom_error *error);
/** Number of a body's colliders, and their handles in the order of the slots.
 *  @param colliders [capacity] or NULL   @param count out: how many there are (may exceed capacity; capacity are
 *  written)
 *  @status OK; NULL_ARGUMENT; *_HANDLE; BUSY */
CAROM_API int32_t carom_body_get_colliders(carom_world *world, carom_body body, carom_collider *colliders,
                                           uint64_t capacity, uint64_t *count, carom_error *error);

/** Add a force and a torque about the centre of mass, for the next step only.
 *  @param force [3] N, world   @param torque [3] N m, world
 *  @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE (the sum would overflow); BUSY; REENTRANT */
CAROM_API int32_t carom_body_add_force(carom_world *world, carom_body body, const double force[3],
                                       const double torque[3], carom_error *error);
/** Change velocities at once. @param impulse [3] N s, world   @param point [3] m, world: where it acts
 *  @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE (the velocity would overflow); BUSY; REENTRANT */
CAROM_API int32_t carom_body_add_impulse(carom_world *world, carom_body body, const double impulse[3],
                                         const double point[3], carom_error *error);

/** How much of the world's gravity acts on a body: its weight is mass * factor * gravity. With 0 it floats, below 0 it
 *  rises. 1 - c compensates a share c of its gravity, as a counterweight does; inverse dynamics counts it (tree.h). Wakes the body and its island.
 *  @param factor any finite number; 1 when a body is created
 *  @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; BUSY; REENTRANT; OUT_OF_MEMORY */
CAROM_API int32_t carom_body_set_gravity_factor(carom_world *world, carom_body body, double factor, carom_error *error);
/** @param factor out   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY */
CAROM_API int32_t carom_body_get_gravity_factor(carom_world *world, carom_body body, double *factor,
                                                carom_error *error);

/* ---- axes on which a body does not move ---- */
#define CAROM_LOCK_LINEAR_X 0x1u   /* its centre of mass keeps its world x */
#define CAROM_LOCK_LINEAR_Y 0x2u   /* likewise its y */
#define CAROM_LOCK_LINEAR_Z 0x4u   /* likewise its z */
#define CAROM_LOCK_ANGULAR_X 0x8u  /* it does not turn about the world's x axis */
#define CAROM_LOCK_ANGULAR_Y 0x10u /* likewise about y */
#define CAROM_LOCK_ANGULAR_Z 0x20u /* likewise about z */
#define CAROM_LOCK_ALL 0x3fu       /* it keeps its pose */
#define CAROM_LOCK_PLANE 0x1cu     /* LINEAR_Z, ANGULAR_X, ANGULAR_Y: a body of a flat world, the plane of x and y */

/** Hold the velocity of a dynamic body along and about some world axes at 0, exactly: forces, contacts and joints move
 *  it along the others alone, as heavy there as it is. What it has of such velocity now is gone; what a host writes of
 *  it later is dropped; a pose that a host sets is taken, and kept from then on. Wakes the body and its island.
 *
 *  Every solver but CAROM_SOLVER_SEVERITY knows locks: a world with that dial refuses them, and a world with a locked
 *  body refuses that dial.
 *  @param locks CAROM_LOCK_* bits, 0 when a body is created
 *  @status OK; NULL_ARGUMENT; *_HANDLE; UNSUPPORTED (unknown bits; or solver severity: set CAROM_DIAL_SOLVER to another
 *          first); OUT_OF_RANGE (a body that is not dynamic: it moves as its velocity says); BUSY; REENTRANT;
 *          OUT_OF_MEMORY */
CAROM_API int32_t carom_body_set_locks(carom_world *world, carom_body body, uint32_t locks, carom_error *error);
/** @param locks out: CAROM_LOCK_* bits   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY */
CAROM_API int32_t carom_body_get_locks(carom_world *world, carom_body body, uint32_t *locks, carom_error *error);

/* ---- attributes: what may be said of a body beside its descriptor, each by its number ----
 * The calls above and those of force.h set the same numbers. These here serve programs that go through all attributes,
 * as scene files and editors do, and attributes that have no call of their own. */

/* clang-format off */
#define CAROM_ATTRIBUTE_GRAVITY_FACTOR 0u   /* carom_body_set_gravity_factor() */
#define CAROM_ATTRIBUTE_LOCKS 1u            /* carom_body_set_locks(); as the host gave them, whether or not they are
                                               forbidden */
#define CAROM_ATTRIBUTE_DRAG 2u             /* carom_body_set_drag(): linear, quadratic */
#define CAROM_ATTRIBUTE_FORCE_FIELD_MASK 3u /* carom_body_set_force_field_mask() */
#define CAROM_ATTRIBUTE_MAGNETIC_MOMENT 4u  /* A m^2, axes of the body: magnetic fields turn it, see
                                               CAROM_FORCE_FIELD_MAGNETIC */
#define CAROM_ATTRIBUTE_COUNT 5u
#define CAROM_ATTRIBUTE_NUMBERS 4u          /* the most that an attribute can have */
/* clang-format on */

/** What an attribute is. Strings have static storage. */
typedef struct carom_attribute_info {
  uint32_t struct_size;
  uint32_t attribute;  /**< CAROM_ATTRIBUTE_* */
  uint32_t numbers;    /**< how many it has, 1 to 4 */
  uint32_t is_whole;   /**< 1: whole numbers */
  uint32_t of_dynamic; /**< 1: only dynamic bodies may have another value than the usual one */
  uint32_t effect;     /**< CAROM_EFFECT_*, which it makes a body take part in */
  const char *name;    /**< "gravity_factor" */
  const char *unit;    /**< "kg/s, kg/m": of its numbers in turn; "1" of a share or of bits */
  const char *summary; /**< one line */
  double min;          /**< bounds of each number, inclusive */
  double max;          /**< likewise */
  double usual[4];     /**< default, of a body when it is created; numbers that the attribute does not have are 0 */
} carom_attribute_info;

/** @param attribute CAROM_ATTRIBUTE_*   @param info out
 *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM */
CAROM_API int32_t carom_attribute_get_info(uint32_t attribute, carom_attribute_info *info, carom_error *error);
/** Set an attribute. Another value than it has wakes the body and its island.
 *  @param value [4] in the units of carom_attribute_info; numbers that the attribute does not have must be 0
 *  @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; *_HANDLE; NOT_FINITE; OUT_OF_RANGE (also: a fraction where numbers are
 *  whole; a
 *          body that is not dynamic); UNSUPPORTED (locks under solver severity); BUSY; REENTRANT; OUT_OF_MEMORY */
CAROM_API int32_t carom_body_set_attribute(carom_world *world, carom_body body, uint32_t attribute,
                                           const double value[4], carom_error *error);
/** @param value [4] out: numbers that the attribute does not have are 0
 *  @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; *_HANDLE; BUSY */
CAROM_API int32_t carom_body_get_attribute(carom_world *world, carom_body body, uint32_t attribute, double value[4],
                                           carom_error *error);

/* ---- sleep, if CAROM_DIAL_SLEEP is on (by default it is off) ----
 * An island (dynamic bodies connected by contacts, or one by itself) whose bodies were all slower than
 * CAROM_DIAL_SLEEP_SPEED for CAROM_DIAL_SLEEP_TIME falls asleep at the end of a step: its velocities become 0, and from
 * then on it costs nothing. Its poses and all that is remembered of its contacts are kept to the bit, so that when it
 * wakes it goes on as if no time had passed. The whole island wakes
 *  - in the step in which a body that moves touches it (comes within the contact distance), before contacts are made;
 *  - when a host writes to one of its bodies (create or destroy a collider, pose, and velocity, force or impulse other
 *    than 0), or calls carom_body_wake();
 *  - when the material of it or of what it touches is updated, or a static or kinematic body that it touches is moved
 *    by the host, changed or destroyed;
 *  - with all others when gravity or a dial but CAROM_DIAL_SUBSTEPS changes, a shape is disabled, or a body is
 *    quarantined.
 * Its contacts are not among those of carom_world_get_contacts(), nor in the residuals of the report. */

/** @param asleep out: 1 or 0   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY */
CAROM_API int32_t carom_body_is_asleep(carom_world *world, carom_body body, uint32_t *asleep, carom_error *error);
/** Wake a body and its island; if it is awake, its time of rest starts anew.   @status OK; NULL_ARGUMENT; *_HANDLE;
 *  BUSY; REENTRANT */
CAROM_API int32_t carom_body_wake(carom_world *world, carom_body body, carom_error *error);

/* ---- continuous collision ----
 * A step looks at where bodies stand, and ahead as far as they move in it, but no farther than their size. What moves
 * farther would pass through what is thin. Such bodies are swept instead: from pose to pose in every substep, by their
 * shape, along a straight line and about an axis. CAROM_DIAL_CONTINUOUS says which bodies are. By default a body is
 * swept if
 *  - it moves farther in a step than the bounding radius of its largest collider, or
 *  - it turns by more than a quarter of a radian, and thereby the ends of a collider by more than its thickness, or
 *  - a host names it here.
 * A swept body stops at the first thing in its way. The impact is solved there with the restitution and friction of the
 * two materials, and the body goes on. Other bodies cost nothing. Sensors are not swept. A swept body that meets a body
 * asleep wakes it. Contact events report such impacts. */

#define CAROM_CONTINUOUS_AUTO 0u   /* in steps in which it is fast for its size (default) */
#define CAROM_CONTINUOUS_ALWAYS 1u /* in every step */
#define CAROM_CONTINUOUS_NEVER 2u  /* in none: cheap debris that may pass through walls */

/** Say when a body is swept, from the next step on. Without effect on a static body, and where CAROM_DIAL_CONTINUOUS
 *  says otherwise: under CAROM_SWEEP_NONE no body is swept, under CAROM_SWEEP_FLAGGED only CAROM_CONTINUOUS_ALWAYS.
 *  @param mode CAROM_CONTINUOUS_*
 *  @status OK; NULL_ARGUMENT; *_HANDLE; UNKNOWN_ENUM (mode: pass one of CAROM_CONTINUOUS_*); BUSY; REENTRANT */
CAROM_API int32_t carom_body_set_continuous(carom_world *world, carom_body body, uint32_t mode, carom_error *error);
/** @param mode out: CAROM_CONTINUOUS_*   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY */
CAROM_API int32_t carom_body_get_continuous(carom_world *world, carom_body body, uint32_t *mode, carom_error *error);

/** Take a body out of steps, or back in, from the next step on. A disabled body keeps its pose and velocity. Nothing
 *  moves it, it touches nothing, and its joints and springs hold nothing. Queries do not find it. Bodies that rested on
 *  it wake. It costs a step nothing. A host may still read and write it.
 *  @param enabled 1 or 0
 *  @status OK; NULL_ARGUMENT; *_HANDLE; UNKNOWN_ENUM (enabled: pass 0 or 1); BUSY; REENTRANT; OUT_OF_MEMORY */
CAROM_API int32_t carom_body_set_enabled(carom_world *world, carom_body body, uint32_t enabled, carom_error *error);
/** @param enabled out: 1 or 0   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY */
CAROM_API int32_t carom_body_is_enabled(carom_world *world, carom_body body, uint32_t *enabled, carom_error *error);

/* ---- colliders ---- */
#define CAROM_FILTER_CATEGORY ((uint64_t)1) /* default category, see carom_collider_set_filter() */
#define CAROM_FILTER_MASK (~(uint64_t)0)    /* default mask */

/** A shape on a body. Fill with carom_collider_desc_init(). */
typedef struct carom_collider_desc {
  uint32_t struct_size;
  uint32_t reserved;       /**< 0 */
  carom_shape shape;       /**< of the same engine as the world */
  carom_material material; /**< CAROM_NULL_HANDLE: friction 0.5, restitution 0 */
  double position[3];      /**< m, body frame: origin of the shape; each within 1e15 */
  double orientation[4];   /**< x, y, z, w, shape to body; default identity */
  double density;          /**< kg/m^3, [0, 1e9], default 1000; counts unless the body's mass is given */
  uint64_t category;       /**< bits, default CAROM_FILTER_CATEGORY: carom_collider_set_filter() */
  uint64_t mask;           /**< bits, default CAROM_FILTER_MASK */
  int32_t group;           /**< default 0: none */
  uint32_t sensor; /**< 1: reports what overlaps it and touches nothing; default 0: carom_collider_set_sensor() */
  double surface_linear[3];  /**< m/s, axes of the shape, default 0: carom_collider_set_surface_velocity() */
  double surface_angular[3]; /**< rad/s, axes of the shape, about its origin, default 0 */
} carom_collider_desc;

/** @status OK; NULL_ARGUMENT; STRUCT_SIZE */
CAROM_API int32_t carom_collider_desc_init(carom_collider_desc *desc, uint32_t struct_size);
/** Put a shape on a body; the body's mass properties follow. The body's linear velocity is kept as that of its new
 *  centre.
 *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE (also: a
 *  half-space on a
 *          body that moves); NO_VOLUME (a flat shape needs CAROM_BODY_FIELD_MASS or density 0); BUSY; REENTRANT;
 *          OUT_OF_MEMORY */
CAROM_API int32_t carom_collider_create(carom_world *world, carom_body body, const carom_collider_desc *desc,
                                        carom_collider *collider, carom_error *error);
/** The common case in one call: a shape by name, a body, and a collider of density 1000. A shape of that name with the
 *  same parameters that the engine has is used again; a new one lives as long as the engine, or until it is destroyed.
 *  Where a part of it fails nothing has changed, but for a plugin that was loaded. Its orientation is the identity, its
 *  friction 0.5, its restitution 0. carom_body_get_colliders() gives its collider.
 *  @param type CAROM_BODY_*   @param name as carom_shape_create_named()   @param position [3] m, world
 *  @param params [count] as carom_shape_create_named()   @param count number of params
 *  @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; NOT_FOUND; NOT_FINITE; OUT_OF_RANGE; NO_VOLUME; PLUGIN_PATH; PLUGIN_LOAD;
 *          PLUGIN_ABI; PLUGIN_INVALID; DECLARATION_FALSE; BUSY; REENTRANT; LIMIT; OUT_OF_MEMORY */
CAROM_API int32_t carom_body_create_named(carom_world *world, uint32_t type, const char *name, const double *params,
                                          uint64_t count, const double position[3], carom_body *body,
                                          carom_error *error);
/** @status OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT */
CAROM_API int32_t carom_collider_destroy(carom_world *world, carom_collider collider, carom_error *error);
/** @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; BUSY */
CAROM_API int32_t carom_collider_get(carom_world *world, carom_collider collider, carom_collider_desc *desc,
                                     carom_body *body, carom_error *error);

/** Give a collider another material. Wakes what its body touches.   @param material or CAROM_NULL_HANDLE: friction 0.5,
 *  restitution 0   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT; OUT_OF_MEMORY */
CAROM_API int32_t carom_collider_set_material(carom_world *world, carom_collider collider, carom_material material,
                                              carom_error *error);
/** The body's mass follows, unless it was given. Wakes the body and its island.   @param density kg/m^3, [0, 1e9]
 *  @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE; NO_VOLUME; BUSY; REENTRANT; OUT_OF_MEMORY */
CAROM_API int32_t carom_collider_set_density(carom_world *world, carom_collider collider, double density,
                                             carom_error *error);
/** Move a shape on its body; the body's mass follows. What is remembered of its contacts is dropped.
 *  @param position [3] m, body frame: origin of the shape; each within 1e15   @param orientation [4] x, y, z, w, shape
 *  to body
 *  @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; BUSY; REENTRANT; OUT_OF_MEMORY */
CAROM_API int32_t carom_collider_set_pose(carom_world *world, carom_collider collider, const double position[3],
                                          const double orientation[4], carom_error *error);

/** Let a collider's surface move though the collider stays: a conveyor belt, a turntable, a track. Friction then brings
 *  what touches it to the velocity of the surface,
 *    v_body(x) + R (linear + angular x (R^T (x - p))),   the part of it in the plane of the contact,
 *  with R the orientation and p the origin of the shape in the world: axes and origin are the shape's own, so that a
 *  belt turns with its body. Nothing moves but by friction: a surface without friction moves nothing. On a body that
 *  moves it drives that body. Wakes what a change of the collider's filter wakes; what touches a surface that moves
 *  does not fall asleep.
 *  @param linear  [3] m/s, axes of the shape; 0 when a collider is created
 *  @param angular [3] rad/s, axes of the shape, about its origin
 *  @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE (beyond 1e6 m/s or rad/s); BUSY; REENTRANT;
 *          OUT_OF_MEMORY */
CAROM_API int32_t carom_collider_set_surface_velocity(carom_world *world, carom_collider collider,
                                                      const double linear[3], const double angular[3],
                                                      carom_error *error);
/** @param linear, angular out: [3], as they were set   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY */
CAROM_API int32_t carom_collider_get_surface_velocity(carom_world *world, carom_collider collider, double linear[3],
                                                      double angular[3], carom_error *error);

#ifdef __cplusplus
}
#endif
#endif
