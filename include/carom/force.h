/** @file force.h
 *  Forces beyond gravity: drag and wind, fields, springs, buoyancy. Each is an effect (carom/plan.h) with participants
 *  of its own, and costs nothing where it has none. They are functions of the state, so an integrator of higher order
 *  takes them to its order. All wake the bodies that they change.
 *  @thread world: a call that is named get, is or read is a reader of its world, any other call its writer (world.h).
 */
#ifndef CAROM_FORCE_H
#define CAROM_FORCE_H

#include <carom/body.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Add a force that acts at a point, for the next step only: carom_body_add_force() with its torque about the centre of
 *  mass as the body stands now.
 *  @param force [3] N, world   @param point [3] m, world
 *  @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE (the sum would overflow); BUSY; REENTRANT */
CAROM_API int32_t carom_body_add_force_at(carom_world *world, carom_body body, const double force[3],
                                          const double point[3], carom_error *error);

/* ---- drag and wind ---- */

/** How air resists a body: F = -(linear + quadratic |u|) u at its centre, u its velocity relative to the air. Without
 *  other forces speeds follow the closed form at any step. (carom_body_desc.linear_damping is relative to the world,
 *  not to the air, and to mass.)
 *  @param linear    kg/s, [0, 1e12]: slow, small bodies (6 pi eta r of a ball); 0 when a body is created
 *  @param quadratic kg/m, [0, 1e12]: fast, large ones, rho c_d A / 2 (a ball of 0.1 m in air: 0.0087); 0 likewise
 *  @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT; OUT_OF_MEMORY */
CAROM_API int32_t carom_body_set_drag(carom_world *world, carom_body body, double linear, double quadratic,
                                      carom_error *error);
/** @param linear, quadratic out   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY */
CAROM_API int32_t carom_body_get_drag(carom_world *world, carom_body body, double *linear, double *quadratic,
                                      carom_error *error);
/** How the air moves; it reaches bodies through their drag alone.
 *  @param velocity [3] m/s, |each| <= 1e6; 0 when a world is created
 *  @status OK; NULL_ARGUMENT; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT */
CAROM_API int32_t carom_world_set_wind(carom_world *world, const double velocity[3], carom_error *error);
/** @status OK; NULL_ARGUMENT; BUSY */
CAROM_API int32_t carom_world_get_wind(carom_world *world, double velocity[3], carom_error *error);

/* ---- fields ---- */

/* clang-format off */
#define CAROM_FORCE_FIELD_UNIFORM 0u  /* `vector` within a box about the frame's origin */
#define CAROM_FORCE_FIELD_RADIAL 1u   /* strength (reference / s)^falloff away from the origin; below 0 it attracts */
#define CAROM_FORCE_FIELD_VORTEX 2u   /* the same about the frame's y axis (right-handed), `pull` towards it, `lift`
                                         along it */
#define CAROM_FORCE_FIELD_MAGNETIC 3u /* `vector` in teslas within a box, as UNIFORM: pushes nothing, and turns bodies
                                         that have a magnetic moment by T = moment x vector. Second order in the step
                                         with velocity_verlet, fourth with rk4; oracle: tests/oracle/test_magnetism */
#define CAROM_FORCE_FIELD_COUNT 4u
/* clang-format on */

/** Static name of a kind of field ("uniform"), or "?".
 *  @param kind CAROM_FORCE_FIELD_* */
CAROM_API const char *carom_force_field_name(uint32_t kind);

/** What acts on every body that shares a bit of its mask, at the centre of mass. Distances d are softened: what the law
 *  reads is s = sqrt(d^2 + core^2), and the direction's length is d / s. Fill with carom_force_field_desc_init(). */
typedef struct carom_force_field_desc {
  uint32_t struct_size;
  uint32_t kind;      /**< CAROM_FORCE_FIELD_* */
  uint32_t is_force;  /**< 0: m/s^2, all bodies fall alike; 1: N, whatever their mass */
  uint32_t mask;      /**< default 1: bodies that share a bit with it feel it, see carom_body_set_force_field_mask() */
  double position[3]; /**< m, world: the frame's origin */
  double orientation[4]; /**< x, y, z, w, frame to world; default identity */
  double half[3];        /**< m, > 0, may be infinite (default): where a uniform field ends along the axes of the frame,
                              and a vortex along its y axis */
  double vector[3];      /**< m/s^2 or N, world: of a uniform field; T: of a magnetic one */
  double strength;       /**< m/s^2 or N at distance `reference`: outward, or of a vortex around the axis */
  double pull;           /**< likewise, of a vortex: towards the axis */
  double lift;           /**< likewise, of a vortex: along the axis */
  double reference;      /**< m, > 0, default 1 */
  double core;           /**< m, >= 0, default 0: softens the centre */
  double reach;          /**< m, > 0, may be infinite (default): beyond that distance there is nothing */
  int32_t falloff;       /**< [-2, 8]: 0 the same everywhere, 1 a line's, 2 (default) a point's, -1 a spring's */
  uint32_t reserved;     /**< 0 */
  uint64_t user;         /**< the host's; the engine does not read it */
} carom_force_field_desc;

/** @status OK; NULL_ARGUMENT; STRUCT_SIZE */
CAROM_API int32_t carom_force_field_desc_init(carom_force_field_desc *desc, uint32_t struct_size);
/** @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; UNKNOWN_ENUM; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; BUSY;
 *          REENTRANT; LIMIT; OUT_OF_MEMORY */
CAROM_API int32_t carom_force_field_create(carom_world *world, const carom_force_field_desc *desc,
                                           carom_force_field *field, carom_error *error);
/** Change a field in place: move it, turn it up.   @status as carom_force_field_create(); *_HANDLE */
CAROM_API int32_t carom_force_field_update(carom_world *world, carom_force_field field,
                                           const carom_force_field_desc *desc, carom_error *error);
/** @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; BUSY */
CAROM_API int32_t carom_force_field_get(carom_world *world, carom_force_field field, carom_force_field_desc *desc,
                                        carom_error *error);
/** @status OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT */
CAROM_API int32_t carom_force_field_destroy(carom_world *world, carom_force_field field, carom_error *error);
/** Which fields a body feels. A field with a bit that few bodies have costs those few.
 *  @param mask 1 when a body is created; 0: none
 *  @status OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT; OUT_OF_MEMORY */
CAROM_API int32_t carom_body_set_force_field_mask(carom_world *world, carom_body body, uint32_t mask,
                                                  carom_error *error);
/** @status OK; NULL_ARGUMENT; *_HANDLE; BUSY */
CAROM_API int32_t carom_body_get_force_field_mask(carom_world *world, carom_body body, uint32_t *mask,
                                                  carom_error *error);

/* ---- springs ---- */

/** A spring as a force, F = stiffness (length - rest) + damping d(length)/dt along the line between two points: what it
 *  does between two steps is as exact as the integrator. A substep h resolves stiffness only up to where its frequency
 *  w has w h = 1; one that is stiffer is taken to be as stiff as that (carom_world_get_plan() says how many are). For
 *  those, and for rods and ropes, there is CAROM_JOINT_DISTANCE, which solves. Fill with carom_spring_desc_init(). */
typedef struct carom_spring_desc {
  uint32_t struct_size;
  uint32_t only_pulls; /**< 1: a bungee, which neither pushes nor holds back what springs back; 0 */
  carom_body body_a;   /**< or CAROM_NULL_HANDLE: the world */
  carom_body body_b;   /**< likewise; not both, and one of the two must be dynamic */
  double anchor_a[3];  /**< m, in A's frame, or world */
  double anchor_b[3];  /**< m, in B's frame, or world */
  double rest;         /**< m, [0, 1e9] */
  double stiffness;    /**< N/m, [0, 1e30] */
  double damping;      /**< N s/m, [0, 1e30], default 0 */
  uint64_t user;       /**< the host's; the engine does not read it */
} carom_spring_desc;

/** @status OK; NULL_ARGUMENT; STRUCT_SIZE */
CAROM_API int32_t carom_spring_desc_init(carom_spring_desc *desc, uint32_t struct_size);
/** @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT; LIMIT;
 *          OUT_OF_MEMORY */
CAROM_API int32_t carom_spring_create(carom_world *world, const carom_spring_desc *desc, carom_spring *spring,
                                      carom_error *error);
/** Change what a spring is like; its ends stay.
 *  @param rest m   @param stiffness N/m   @param damping N s/m; ranges as in carom_spring_desc
 *  @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT */
CAROM_API int32_t carom_spring_update(carom_world *world, carom_spring spring, double rest, double stiffness,
                                      double damping, carom_error *error);
/** @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; BUSY */
CAROM_API int32_t carom_spring_get(carom_world *world, carom_spring spring, carom_spring_desc *desc,
                                   carom_error *error);
/** @param length out: m, as its ends stand   @param force out: N, above 0 it pulls them together, as it is set
 *  @status OK; NULL_ARGUMENT; *_HANDLE; BUSY */
CAROM_API int32_t carom_spring_get_state(carom_world *world, carom_spring spring, double *length, double *force,
                                         carom_error *error);
/** Goes with its bodies, too.   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT */
CAROM_API int32_t carom_spring_destroy(carom_world *world, carom_spring spring, carom_error *error);

/* ---- water ---- */

/** All of space where normal . x <= level is water. What of a body's colliders is in it (not sensors, not scenery) is
 *  pushed by the weight of what it displaces, at the middle of that part, against the world's gravity, and is taken
 *  along by the current: F = -drag * density * volume * (v - current). Balls, ellipsoids, boxes and hulls displace
 *  exactly what they cover, other shapes what a hull of 256 of their support points covers, scaled to their volume.
 *  Fill with carom_water_init(). */
typedef struct carom_water {
  uint32_t struct_size;
  uint32_t reserved; /**< 0 */
  double normal[3];  /**< unit, out of the water, default (0, 1, 0) */
  double level;      /**< m, default 0 */
  double density;    /**< kg/m^3, (0, 1e9], default 1000 */
  double current[3]; /**< m/s, world, default 0 */
  double drag;       /**< 1/s, [0, 1e6], default 1 */
} carom_water;

/** @status OK; NULL_ARGUMENT; STRUCT_SIZE */
CAROM_API int32_t carom_water_init(carom_water *water, uint32_t struct_size);
/** @param water NULL: none, as a world is created
 *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; BUSY; REENTRANT */
CAROM_API int32_t carom_world_set_water(carom_world *world, const carom_water *water, carom_error *error);
/** @param water out   @param present out: 1 or 0; if 0, water is filled with defaults
 *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; BUSY */
CAROM_API int32_t carom_world_get_water(carom_world *world, carom_water *water, uint32_t *present, carom_error *error);

#ifdef __cplusplus
}
#endif
#endif
