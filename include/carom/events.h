/** @file events.h
 *  What happened in the last step, as arrays: contacts that began, ended or were hit, sensors entered and left, bodies
 *  that fell asleep or woke, joints that broke, faults. A world collects only the kinds that a host chose.
 *
 *  Arrays are replaced by the next step. Their order is that of slots, and the same for any number of threads. What was
 *  destroyed keeps its handle in them, which is stale by then. Where it takes memory, a step asks for it before it
 *  moves anything.
 *  @thread world: a call that is named get, is or read is a reader of its world, any other call its writer (world.h).
 */
#ifndef CAROM_EVENTS_H
#define CAROM_EVENTS_H

#include <carom/body.h>

#ifdef __cplusplus
extern "C" {
#endif

#define CAROM_EVENTS_CONTACT 1u /* of carom_world_get_contact_events() */
#define CAROM_EVENTS_SENSOR 2u  /* of carom_world_get_sensor_events() */
#define CAROM_EVENTS_SLEEP 4u   /* of carom_world_get_sleep_events() */
#define CAROM_EVENTS_JOINT 8u   /* of carom_world_get_joint_events() */
#define CAROM_EVENTS_FAULT 16u  /* of carom_world_get_fault_events() */

/** Say what to collect from the next step on; nothing at first. Contacts and overlaps that there are already begin in
 *  that step.
 *  @param kinds     CAROM_EVENTS_* bits; 0: nothing
 *  @param hit_speed m/s, [0, 1e9]: contacts that approach faster are hits
 *  @status OK; NULL_ARGUMENT; UNSUPPORTED (kinds); NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT; OUT_OF_MEMORY */
CAROM_API int32_t carom_world_collect_events(carom_world *world, uint32_t kinds, double hit_speed, carom_error *error);

/* clang-format off */
#define CAROM_CONTACT_BEGIN 0u /* the first step in which the two press on each other */
#define CAROM_CONTACT_END 1u   /* the first after that in which they are farther apart than the contact distance, or
                                  one of them is gone, filtered out, disabled or in quarantine; point, normal,
                                  impulse, speed: 0 */
#define CAROM_CONTACT_HIT 2u   /* they press, and approached faster than hit_speed as the step began, or when a sweep
                                  met them */
/* clang-format on */

/** Of two colliders; all their contact points together. Sleepers stay in touch. */
typedef struct carom_contact_event {
  uint32_t kind; /**< CAROM_CONTACT_* */
  uint32_t reserved;
  carom_collider collider_a; /**< first of the pair */
  carom_collider collider_b; /**< second of the pair */
  carom_body body_a;         /**< of collider_a */
  carom_body body_b;         /**< of collider_b */
  double point[3];           /**< m, world: the point that bore most */
  double normal[3];          /**< unit, world, from A to B, there */
  double impulse;            /**< N s, normal, of all points, over the step */
  double approach_speed;     /**< m/s, along the normal, of the point that approached fastest as the step began */
} carom_contact_event;

/** Copy them out, by the slots of the two colliders; of one pair END before BEGIN before HIT.
 *  @param dst      [capacity] elements `stride` bytes apart; may be NULL if capacity is 0
 *  @param stride   sizeof(carom_contact_event) as the caller knows it
 *  @param count    out: how many there are (may exceed capacity; capacity are written)
 *  @status OK; NULL_ARGUMENT; BUFFER_TOO_SMALL; OUT_OF_RANGE (stride); BUSY */
CAROM_API int32_t carom_world_get_contact_events(carom_world *world, carom_contact_event *dst, uint64_t stride,
                                                 uint64_t capacity, uint64_t *count, carom_error *error);

#define CAROM_SENSOR_ENTER 0u /* the collider begins to overlap the sensor */
#define CAROM_SENSOR_LEAVE 1u /* it overlaps the sensor no longer */

/** What a sensor overlaps at the end of the step and did not at the end of the one before, or the reverse. Sleepers are
 *  within what they sleep in. */
typedef struct carom_sensor_event {
  uint32_t kind; /**< CAROM_SENSOR_* */
  uint32_t reserved;
  carom_collider sensor;  /**< the collider that is a sensor */
  carom_collider other;   /**< the collider that overlaps it */
  carom_body sensor_body; /**< of sensor */
  carom_body other_body;  /**< of other */
} carom_sensor_event;

/** Arguments as carom_world_get_contact_events(). */
CAROM_API int32_t carom_world_get_sensor_events(carom_world *world, carom_sensor_event *dst, uint64_t stride,
                                                uint64_t capacity, uint64_t *count, carom_error *error);

#define CAROM_SLEEP_ASLEEP 0u /* the body fell asleep */
#define CAROM_SLEEP_AWAKE 1u  /* the body woke */

/** A body that sleeps at the end of the step and did not at the end of the one before, or the reverse. */
typedef struct carom_sleep_event {
  uint32_t kind; /**< CAROM_SLEEP_* */
  uint32_t reserved;
  carom_body body; /**< that fell asleep or woke */
} carom_sleep_event;

/** By the slots of the bodies; arguments as carom_world_get_contact_events(). */
CAROM_API int32_t carom_world_get_sleep_events(carom_world *world, carom_sleep_event *dst, uint64_t stride,
                                               uint64_t capacity, uint64_t *count, carom_error *error);

/** A joint that bore more than its break_force or break_torque in this step, and holds nothing any more. It stays until
 *  it is destroyed. */
typedef struct carom_joint_event {
  carom_joint joint; /**< that broke */
  carom_body body_a; /**< CAROM_NULL_HANDLE: the world */
  carom_body body_b; /**< as in carom_joint_desc */
  double force[3];   /**< N, world, on B: mean over the step in which it broke, as in carom_joint_state */
  double torque[3];  /**< N m, world, on B about its point, likewise */
  uint64_t step;     /**< which step that was: carom_step_report.steps after it */
} carom_joint_event;

/** By the slots of the joints; arguments as carom_world_get_contact_events(). */
CAROM_API int32_t carom_world_get_joint_events(carom_world *world, carom_joint_event *dst, uint64_t stride,
                                               uint64_t capacity, uint64_t *count, carom_error *error);

/** A support function that returned a false point: its shape is disabled from the next step on. Or a body or particles
 *  whose state was not finite: they are in quarantine. The same faults as those of carom_world_get_faults(), but by
 *  handles that keep their names when what they name is destroyed. */
typedef struct carom_fault_event {
  uint32_t kind; /**< CAROM_FAULT_* */
  uint32_t reserved;
  carom_shape shape;         /**< that is disabled, or CAROM_NULL_HANDLE */
  carom_body body;           /**< a body with this shape, or the one in quarantine, or CAROM_NULL_HANDLE */
  carom_particles particles; /**< the set, of CAROM_FAULT_PARTICLE_STATE, or CAROM_NULL_HANDLE */
  uint64_t particle;         /**< the first of it that was put in quarantine in this step: its index then */
  double dir[3];             /**< of a support function: the direction given */
  double out[3];             /**< and what came back */
  uint64_t step;             /**< carom_step_report.steps after the step */
} carom_fault_event;

/** As they happened; arguments as carom_world_get_contact_events(). */
CAROM_API int32_t carom_world_get_fault_events(carom_world *world, carom_fault_event *dst, uint64_t stride,
                                               uint64_t capacity, uint64_t *count, carom_error *error);

#ifdef __cplusplus
}
#endif
#endif
