/** @file vehicle.h
 *  A vehicle on wheels: a dynamic body of the host's, the chassis, and wheels that are no bodies. Each wheel looks down
 *  by a ray, or by a shape. Springs, tyres and an engine turn what it finds into forces on the chassis.
 *
 *  All state is in structs of the host's. To save a vehicle, copy them with a snapshot of its world. A frame is two
 *  calls: carom_vehicle_drive(), then carom_world_step() with the same dt. Forces act in opposite directions on what
 *  the wheels stand on, so a dynamic body under a wheel moves.
 *
 *  Within a drive the motion of the chassis is predicted in parts of at most 1 ms. So springs and tyres may be stiff,
 *  and a vehicle behaves alike at 30 and at 240 frames a second. The same input gives the same bits on every platform.
 *  @thread world: a call that is named get, is or read is a reader of its world, any other call its writer (world.h).
 */
#ifndef CAROM_VEHICLE_H
#define CAROM_VEHICLE_H

#include <carom/body.h>

#ifdef __cplusplus
extern "C" {
#endif

/* clang-format off */
#define CAROM_VEHICLE_AUTOMATIC 1u   /* it chooses among forward gears; the input's gear says which way, or neutral */
#define CAROM_VEHICLE_ACKERMANN 2u   /* steered wheels share one centre of turn with those that are not steered */

#define CAROM_VEHICLE_WHEELS 16u     /* the most wheels of a vehicle */
#define CAROM_NO_WHEEL 0xFFFFFFFFu   /* in place of an index: no wheel */
/* clang-format on */

/** Chassis, engine and gears. Fill with carom_vehicle_desc_init(): a car of 1.2 t, whose chassis the host names. */
typedef struct carom_vehicle_desc {
  uint32_t struct_size;
  uint32_t flags;          /**< CAROM_VEHICLE_* bits, default AUTOMATIC and ACKERMANN */
  carom_body chassis;      /**< dynamic. Its own gravity and mass count */
  double up[3];            /**< unit, body frame, default (0, 1, 0): wheels look along -up */
  double forward[3];       /**< unit, body frame, at right angles to up within 1e-6, default (0, 0, 1) */
  uint64_t category;       /**< of wheels' queries, default all bits: as carom_query_desc.category */
  uint64_t mask;           /**< default all bits: as carom_query_desc.mask */
  uint32_t torque_count;   /**< points of the torque curve, 1 to 8, default 4 */
  uint32_t gear_count;     /**< forward gears, 1 to 8, default 5 */
  double torque_speeds[8]; /**< [torque_count] rad/s, [0, 1e5], rising: beyond the ends the torque is that of the end */
  double torques[8];       /**< [torque_count] N m, [0, 1e7]: of the engine at full throttle, linear in between */
  double idle_speed;       /**< rad/s, [1, 1e5], default 90: the engine keeps it by itself */
  double max_speed;        /**< rad/s, above idle_speed, at most 1e5, default 680: at it the engine gives no torque */
  double engine_inertia;   /**< kg m^2, [1e-3, 1e6], default 0.25 */
  double engine_drag;      /**< N m, [0, 1e7], default 25: brakes the engine where the throttle is shut */
  double gears[8];      /**< [gear_count] [1e-3, 1e3], default 3.5, 2.1, 1.4, 1.05, 0.85: turns of the engine for one of
                                the final drive */
  double reverse;       /**< [1e-3, 1e3], default 3.3: likewise */
  double final_drive;   /**< [1e-3, 1e3], default 3.7 */
  double clutch_torque; /**< N m, [0, 1e7], default 600: the most that the clutch takes */
  double shift_up;      /**< rad/s, [0, 1e5], default 600: AUTOMATIC takes the next gear above it */
  double shift_down;    /**< rad/s, [0, 1e5], default 220: and the one before below it */
  double shift_time;    /**< s, [0, 10], default 0.2: the clutch is open for so long */
  double limited_slip; /**< N m, [0, 1e7], default 0: the most by which the differential holds driven wheels together */
} carom_vehicle_desc;

/** One wheel: its place, spring, tyre, and what of engine, brakes and steering reaches it. Fill with
 *  carom_wheel_desc_init(). */
typedef struct carom_wheel_desc {
  uint32_t struct_size;
  uint32_t anti_roll_partner; /**< index of the wheel at the other end of its anti-roll bar, default CAROM_NO_WHEEL */
  carom_shape shape;      /**< convex, looks down in place of a ray, its origin at the wheel's centre; default none */
  double position[3];     /**< m, body frame: of its centre with the spring at rest, nothing under it */
  double radius;          /**< m, [1e-3, 1e3], default 0.33 */
  double inertia;         /**< kg m^2, [1e-9, 1e6], default 1: about its axle */
  double travel;          /**< m, [1e-3, 1e3], default 0.25: up to the bump stop, which is a spring 10 times as stiff */
  double stiffness;       /**< N/m, [0, 1e9], default 30000 */
  double damping_bump;    /**< N s/m, [0, 1e8], default 2500: as the spring is pressed */
  double damping_rebound; /**< N s/m, [0, 1e8], default 3500: as it comes back */
  double anti_roll;       /**< N/m, [0, 1e9], default 0: force on both ends by the difference of their compressions.
                                   One end of a bar says it */
  double max_steer;       /**< rad, [-1.5, 1.5], default 0: at steer 1, to the left */
  double drive;           /**< [0, 1e3], default 0: share of the engine's torque, relative to the other wheels */
  double brake;           /**< N m, [0, 1e7], default 2000: torque of the full brake */
  double handbrake;       /**< N m, [0, 1e7], default 0: likewise */
  double rolling;         /**< [0, 1], default 0.012: rolling resistance over load */
  double grip;            /**< [0, 10], default 1: the most friction over load, along the wheel */
  double side_grip;       /**< [0, 10], default 1: likewise across it */
  double peak_slip;       /**< [1e-3, 1], default 0.1: slip along the wheel at which grip is largest */
  double side_peak_slip;  /**< [1e-3, 1], default 0.12: tangent of the slip angle at which side grip is largest */
  double slide;           /**< [0, 1], default 0.8: friction of a tyre that slides, over the most */
  double slide_slip;      /**< [1.01, 100], default 4: from so many times the peak on it slides */
  double relaxation;      /**< m, [0.01, 10], default 0.3: way in which a tyre builds up its force */
} carom_wheel_desc;

/** What a driver does. Fill with carom_vehicle_input_init(): nothing, in gear 1. */
typedef struct carom_vehicle_input {
  uint32_t struct_size;
  int32_t gear;     /**< forward gear, 0: neutral, -1: reverse. AUTOMATIC takes any above 0 as forward */
  double throttle;  /**< [0, 1] */
  double brake;     /**< [0, 1] */
  double handbrake; /**< [0, 1] */
  double steer;     /**< [-1, 1], 1: to the left as far as wheels go */
} carom_vehicle_input;

/** State of engine and gears. Fill with carom_vehicle_init(). */
typedef struct carom_vehicle {
  uint32_t struct_size;
  int32_t gear;        /**< that is in, or that is being put in */
  double engine_speed; /**< rad/s */
  double shifting;     /**< s, until the clutch closes again */
  double since_shift;  /**< s, since then */
  double speed;        /**< m/s, of the chassis, forward */
} carom_vehicle;

/** State of a wheel. Fill with carom_wheel_init(). */
typedef struct carom_wheel {
  uint32_t struct_size;
  uint32_t touches;        /**< 1: it stands on something */
  carom_body body;         /**< on this, or CAROM_NULL_HANDLE */
  carom_collider collider; /**< of body */
  double point[3];         /**< m, world: where it touches */
  double normal[3];        /**< unit, world, from the ground */
  double position[3];      /**< m, world: of its centre */
  double compression;      /**< m, of its spring; 0: nothing presses */
  double spin;             /**< rad/s, forward */
  double angle;            /**< rad, [-pi, pi], turned so far */
  double steer;            /**< rad, to the left */
  double load;             /**< N, along the normal, mean over the drive */
  double force;            /**< N, along the wheel on the chassis, likewise */
  double side_force;       /**< N, across it, to the left, likewise */
  double slip;             /**< deflection over relaxation, along: at a steady speed the slip */
  double side_slip;        /**< likewise across: at a steady speed the tangent of the slip angle */
} carom_wheel;

/** @status OK; NULL_ARGUMENT; STRUCT_SIZE */
CAROM_API int32_t carom_vehicle_desc_init(carom_vehicle_desc *desc, uint32_t struct_size);
/** @status OK; NULL_ARGUMENT; STRUCT_SIZE */
CAROM_API int32_t carom_wheel_desc_init(carom_wheel_desc *desc, uint32_t struct_size);
/** @status OK; NULL_ARGUMENT; STRUCT_SIZE */
CAROM_API int32_t carom_vehicle_input_init(carom_vehicle_input *input, uint32_t struct_size);
/** At idle speed, at rest.   @status OK; NULL_ARGUMENT; STRUCT_SIZE */
CAROM_API int32_t carom_vehicle_init(carom_vehicle *vehicle, uint32_t struct_size);
/** In the air, at rest.   @status OK; NULL_ARGUMENT; STRUCT_SIZE */
CAROM_API int32_t carom_wheel_init(carom_wheel *wheel, uint32_t struct_size);

/** Look down, turn wheels and engine through dt, and leave the mean forces for the next step, which is to take dt. They
 *  add to forces that are pending. They keep a vehicle awake.
 *  @param desc with a chassis
 *  @param wheel_descs [n] one after another, each of the first one's struct_size
 *  @param n 1 to CAROM_VEHICLE_WHEELS
 *  @param input what the driver does
 *  @param vehicle state, changes
 *  @param wheels [n] states, change: as wheel_descs
 *  @param dt s, [1e-4, 0.1]
 *  @accuracy of the prediction first order in 1 ms; it leaves out what else acts on the chassis but gravity and
 *            pending forces. A chassis that swings on its springs faster than a third of 1 / dt trembles. Of springs
 *            stiffer than (m / 4) / 1 ms^2, m what the chassis weighs at the wheel, so much acts
 *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED (unknown bits; a half-space or scenery as shape); *_HANDLE;
 *          NOT_FINITE; NOT_UNIT; OUT_OF_RANGE (also: a chassis that is not dynamic, a gear that it has not); BUSY;
 *          REENTRANT; OUT_OF_MEMORY */
CAROM_API int32_t carom_vehicle_drive(carom_world *world, const carom_vehicle_desc *desc,
                                      const carom_wheel_desc *wheel_descs, uint64_t n, const carom_vehicle_input *input,
                                      carom_vehicle *vehicle, carom_wheel *wheels, double dt, carom_error *error);

#ifdef __cplusplus
}
#endif
#endif
