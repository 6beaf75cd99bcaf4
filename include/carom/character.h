/** @file character.h
 *  A character: a shape that a player or a program walks through a world. It is no body. It moves by queries, so it
 *  stops exactly where it should, and costs a step nothing.
 *
 *  It slides along walls, climbs steps, keeps to the ground, rides what moves under it, and crouches. It pushes dynamic
 *  bodies with a bounded force. A shape with a round end also rolls over edges, up and down, by its radius times
 *  (1 - cos max_slope). All of its state is the struct carom_character, which belongs to the host. To save a
 *  character, or to go back in time, copy the struct.
 *
 *  A frame is three calls, in this order: carom_world_step(), carom_character_move(), carom_character_push(). The first
 *  moves the ground, the second follows it and walks, the third leaves forces for the next step. Moves only read the
 *  world. So characters may be moved on any threads at once, and their order does not matter.
 *
 *  The same input gives the same bits on every platform.
 *  @thread world: a call that is named get, is or read is a reader of its world, any other call its writer (world.h).
 */
#ifndef CAROM_CHARACTER_H
#define CAROM_CHARACTER_H

#include <carom/body.h>

#ifdef __cplusplus
extern "C" {
#endif

/* clang-format off */
#define CAROM_GROUND_AIR 0u   /* nothing is under it: it falls */
#define CAROM_GROUND_STEEP 1u /* it touches ground steeper than max_slope: it slides down without friction */
#define CAROM_GROUND_FIRM 2u  /* it stands, and can walk and jump */

#define CAROM_CHARACTER_TURNS 1u /* its orientation turns about `up` with the ground that it rides */
#define CAROM_CHARACTER_FLIES 2u /* no gravity, no steps, no ground: it moves along all of `walk`, as swimmers do */

#define CAROM_CHARACTER_CONTACTS 8u /* contacts that a move keeps: of more, the first */
/* clang-format on */

/** How a character moves. Fill with carom_character_desc_init(). Characters may share one, and it may change between
 *  moves. */
typedef struct carom_character_desc {
  uint32_t struct_size;
  uint32_t flags;      /**< CAROM_CHARACTER_* bits, default TURNS */
  double up[3];        /**< unit within 1e-6, world, default (0, 1, 0): against gravity */
  double gravity;      /**< m/s^2, [0, 1e6], default 9.81: along -up. The world's own gravity is not looked at */
  double fall_speed;   /**< m/s, [0, 1e6], default 100: it falls no faster */
  double max_slope;    /**< rad, [0, 1.57], default 0.8727 (50 degrees): ground up to this slope is firm */
  double step_up;      /**< m, [0, 1e6], default 0.3: it climbs what is no higher above the ground that it stands on */
  double step_down;    /**< m, [0, 1e6], default 0.3: it keeps to ground that falls away by no more */
  double skin;         /**< m, [1e-6, 1e6], default 0.01: stands this far from what it touches, and 2 % more */
  double acceleration; /**< m/s^2, [0, 1e9], default 1e9: how fast its velocity follows `walk` on firm ground */
  double air_acceleration; /**< m/s^2, [0, 1e9], default 10: likewise in the air and on steep ground */
  double mass;             /**< kg, [0, 1e9], default 80: presses on a dynamic body that it stands on */
  double push_force;       /**< N, [0, 1e12], default 500: the most that it pushes a body with, per contact */
  double recover_speed;    /**< m/s, [0, 1e6], default 5: how fast it leaves what it overlaps */
  uint64_t category;       /**< of its queries, default all bits: as carom_query_desc.category */
  uint64_t mask;           /**< default all bits: as carom_query_desc.mask */
  carom_body body;         /**< a body of its own that it passes over, see carom_character_move_body(); default none */
} carom_character_desc;

/** Where a character is, how it moves and what it touches. Fill with carom_character_init(), then set position and
 *  call carom_character_set_shape(). To teleport it, write position, and set ground to CAROM_GROUND_AIR. */
typedef struct carom_character {
  uint32_t struct_size;
  uint32_t ground;                /**< CAROM_GROUND_* */
  carom_shape shape;              /**< convex, by carom_character_set_shape() */
  double position[3];             /**< m, world: origin of the shape */
  double orientation[4];          /**< x, y, z, w, shape to world; default identity */
  double velocity[3];             /**< m/s: on firm ground along it and relative to it, else in the world */
  double foot;                    /**< m, from the origin down to the lowest point of the shape: by set_shape */
  double head;                    /**< m, from the origin up to its highest point: likewise */
  double reach;                   /**< m, from the origin to its farthest point across `up`: likewise */
  carom_body ground_body;         /**< what it stands on or slides down, or CAROM_NULL_HANDLE */
  carom_collider ground_collider; /**< of ground_body */
  double ground_point[3];         /**< m, world: where it touches the ground */
  double ground_normal[3];        /**< unit, world, from the ground to it; `up` in the air */
  double ground_velocity[3];    /**< m/s, world, of the ground at ground_point; in the air of the ground that it left */
  double ground_position[3];    /**< m, world: where ground_body was at the last move */
  double ground_orientation[4]; /**< x, y, z, w: likewise */
  uint32_t contact_count;       /**< of the last move, CAROM_CHARACTER_CONTACTS at most */
  uint32_t reserved;            /**< 0 */
  carom_body contact_bodies[8]; /**< [contact_count] what was in its way */
  double contact_points[24];    /**< [3 contact_count] m, world, on the surface of the body */
  double contact_normals[24];   /**< [3 contact_count] unit, world, from the body to the character */
  double contact_speeds[8];     /**< [contact_count] m/s, at which it would have gone on into the body */
} carom_character;

/** @status OK; NULL_ARGUMENT; STRUCT_SIZE */
CAROM_API int32_t carom_character_desc_init(carom_character_desc *desc, uint32_t struct_size);
/** At the origin, in the air, without a shape.   @status OK; NULL_ARGUMENT; STRUCT_SIZE */
CAROM_API int32_t carom_character_init(carom_character *character, uint32_t struct_size);

/** Give it a shape, or another one: to crouch, to stand up. The lowest point stays where it is, so the origin moves
 *  along `up`. With `fits` the new shape is looked at first. If something is within half the skin of it, `fits` becomes
 *  0 and nothing changes. Call it again after `up` has changed against the shape.
 *  @param shape convex, of the world's engine: most take a capsule
 *  @param desc may be NULL: defaults
 *  @param character its shape, position, foot, head and reach change
 *  @param fits out: 1 or 0; NULL: it is changed whatever is there, and a later move brings it out
 *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED (a half-space, scenery; unknown bits); UNKNOWN_ENUM; *_HANDLE;
 *          NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; PLUGIN_INVALID; BUSY; REENTRANT; OUT_OF_MEMORY   @thread reader */
CAROM_API int32_t carom_character_set_shape(carom_engine *engine, carom_world *world, const carom_character_desc *desc,
                                            carom_character *character, carom_shape shape, uint32_t *fits,
                                            carom_error *error);

/** Move a character by dt. In this order: it follows the ground that it stood on, leaves what it overlaps, then walks,
 *  jumps or falls.
 *
 *  On firm ground its velocity across `up` follows `walk`, on slopes and steps, too. In the air and on steep ground it
 *  follows `walk` plus the velocity of the ground that it left. Paths in the air are exact parabolas, so where it lands
 *  does not depend on dt beyond one dt's way. On open ground a move takes three queries, in a corner about ten. It
 *  allocates nothing but what queries do.
 *  @param desc may be NULL: defaults
 *  @param character all but shape, foot, head and reach may change
 *  @param walk [3] m/s, world, each within 1e6: what it is to move at, relative to the ground; the part along `up`
 *         counts only with CAROM_CHARACTER_FLIES
 *  @param jump m/s, [0, 1e6], along `up`: on firm ground it takes off at this speed, and takes the velocity of the
 *         ground with it; else, and with 0, it does not
 *  @param dt s, [0, 1]
 *  @accuracy stands `skin` and 2 % from surfaces, within 1e-5 m or 1e-6 of its size
 *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED (unknown bits, reserved); UNKNOWN_ENUM; *_HANDLE (desc->body;
 *          character->shape: call carom_character_set_shape() first); NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; BUSY;
 *          REENTRANT; OUT_OF_MEMORY
 *  @thread reader */
CAROM_API int32_t carom_character_move(carom_world *world, const carom_character_desc *desc, carom_character *character,
                                       const double walk[3], double jump, double dt, carom_error *error);

/** Push what the last move met, and press on what the character stands on, as forces of the next step. A dynamic body
 *  in its way gets the force that would bring it to the character's speed within dt, push_force at most. One under
 *  firm feet gets mass * gravity. Bodies that are gone are left out.
 *  @param desc may be NULL: defaults   @param character as the last move left it   @param dt s, [1e-9, 1], of the next
 *  step
 *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; UNKNOWN_ENUM; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE;
 *          BUSY; REENTRANT; OUT_OF_MEMORY */
CAROM_API int32_t carom_character_push(carom_world *world, const carom_character_desc *desc,
                                       const carom_character *character, double dt, carom_error *error);

/** Let a kinematic body of the host's follow the character, so that other bodies and characters touch it. It gets the
 *  velocity that brings it to the character's place in the next step of dt. Where that is over 1 m away, or the
 *  character has turned, it is placed there at once, at rest. Give the body the character's shape, and name it in
 *  desc->body.
 *  @param desc with a body   @param dt s, [1e-9, 1], of the next step
 *  @param character as the last move left it
 *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; UNKNOWN_ENUM; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE
 *          (also: a body that is not kinematic); BUSY; REENTRANT; OUT_OF_MEMORY */
CAROM_API int32_t carom_character_move_body(carom_world *world, const carom_character_desc *desc,
                                            const carom_character *character, double dt, carom_error *error);

#ifdef __cplusplus
}
#endif
#endif
