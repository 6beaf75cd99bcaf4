/** @file filter.h
 *  Which colliders may touch: categories, masks and groups, ignored pairs of bodies, and sensors, which nothing
 *  touches.
 *
 *  All may be set at any time between steps and hold from the next step on, for what is in touch, too. They cost
 *  nothing in a world in which none of them is set.
 *  @thread world: a call that is named get, is or read is a reader of its world, any other call its writer (world.h).
 */
#ifndef CAROM_FILTER_H
#define CAROM_FILTER_H

#include <carom/body.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Two colliders of different bodies touch if each one's mask has a bit of the other's category; unless both are of one
 *  group other than 0: then they do if it is positive and do not if it is negative, whatever their masks say.
 *  @param category, mask  any bits   @param group 0: none
 *  @status OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT; OUT_OF_MEMORY */
CAROM_API int32_t carom_collider_set_filter(carom_world *world, carom_collider collider, uint64_t category,
                                            uint64_t mask, int32_t group, carom_error *error);
/** @param category, mask, group  out   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY */
CAROM_API int32_t carom_collider_get_filter(carom_world *world, carom_collider collider, uint64_t *category,
                                            uint64_t *mask, int32_t *group, carom_error *error);
/** The same for all colliders that a body has now.   @status as carom_collider_set_filter() */
CAROM_API int32_t carom_body_set_filter(carom_world *world, carom_body body, uint64_t category, uint64_t mask,
                                        int32_t group, carom_error *error);

/** Let two bodies make no contacts with each other, whatever their filters say, or restore their contacts. Calls are
 *  counted: undo each one. Undoing more does nothing.
 *  @param ignored 1 or 0
 *  @status OK; NULL_ARGUMENT; *_HANDLE; OUT_OF_RANGE (ignored; a body and itself); BUSY; REENTRANT; OUT_OF_MEMORY */
CAROM_API int32_t carom_body_ignore_collision(carom_world *world, carom_body body_a, carom_body body_b,
                                              uint32_t ignored, carom_error *error);

/** Make a collider a sensor: it reports what overlaps it (carom_world_get_sensor_events()) and is touched by nothing.
 *  It obeys its filter, does not sense other sensors, and static sensors do not sense static bodies. Its density counts
 *  as before.
 *  @param sensor 1 or 0
 *  @status OK; NULL_ARGUMENT; *_HANDLE; OUT_OF_RANGE (sensor); BUSY; REENTRANT; OUT_OF_MEMORY */
CAROM_API int32_t carom_collider_set_sensor(carom_world *world, carom_collider collider, uint32_t sensor,
                                            carom_error *error);
/** @param sensor out: 1 or 0   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY */
CAROM_API int32_t carom_collider_is_sensor(carom_world *world, carom_collider collider, uint32_t *sensor,
                                           carom_error *error);

#ifdef __cplusplus
}
#endif
#endif
