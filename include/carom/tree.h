/** @file tree.h
 *  Trees of joints, as robots are made of: their coordinates, the forces that given accelerations take (inverse
 *  dynamics), their mass matrix. A tree is what joints hold together without a loop. It is named by any dynamic body of
 *  it.
 *
 *  Coordinates are speeds, in this order. Where nothing holds the tree, six of its base, the body that names it: the
 *  velocity of its centre of mass, m/s, then its angular velocity, rad/s, both in world axes. Then those of its joints,
 *  in the order of carom_world_get_joints(), each of B relative to A:
 *    hinge      TURN_X, rad/s, about the x axis
 *    slider     X, m/s, along A's x axis
 *    ball       TURN_X, TURN_Y, TURN_Z: the angular velocity in A's frame
 *    universal  TURN_Y about A's y axis, then TURN_Z about B's z axis
 *    weld       none
 *    six-axis   those of X, Y, Z that are not locked: the rates of B's point in A's frame. Then, where no turn is
 *               locked, as a ball; else the rates of the turns that are not, as CAROM_JOINT_BULK_AXIS_SPEEDS
 *  Forces are in the same order: what does work at each speed. A base has the force and the torque about its centre.
 *
 *  The world, and static, kinematic and disabled bodies, may hold a tree, at one of its bodies; kinematic ones move on
 *  at the speed they have. Broken joints hold nothing. Sleeping bodies count as the others.
 *
 *  What else acts is left out: contacts, limits, drives and springs of joints, drag, fields, water, forces of the host.
 *  Gravity counts, by each body's gravity factor and where it is not forbidden. The armature of an axis counts as
 *  inertia along it; where a joint turns as a ball, about A's axes.
 *
 *  A loop is refused (the world counts as one body), and so are distance joints, pulleys and gears, bodies with locked
 *  axes, and bodies that can't turn: UNSUPPORTED says which joint or body it is.
 *
 *  Each call finds the tree anew, and changes nothing of the world: forces and masses take time in proportion to its
 *  bodies, the matrix to bodies times their depth.
 *  @thread world: a call that is named get, is or read is a reader of its world, any other call its writer (world.h).
 */
#ifndef CAROM_TREE_H
#define CAROM_TREE_H

#include <carom/joint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** What a number of a tree stands for. */
typedef struct carom_tree_coordinate {
  carom_joint joint; /**< or CAROM_NULL_HANDLE: of the base */
  carom_body body;   /**< that it moves: the base, or the body that the joint holds to the rest */
  uint32_t axis;     /**< CAROM_AXIS_*; of a base X, Y, Z, TURN_X, TURN_Y, TURN_Z of the world */
  uint32_t reserved; /**< 0 */
} carom_tree_coordinate;

/** Copy out what the coordinates of a tree are.
 *  @param body     any dynamic body of the tree; its base, where nothing holds the tree
 *  @param dst      [capacity] elements `stride` bytes apart; may be NULL if capacity is 0
 *  @param stride   sizeof(carom_tree_coordinate) as the caller knows it
 *  @param count    out: how many there are (may exceed capacity; capacity are written)
 *  @status OK; NULL_ARGUMENT; *_HANDLE; OUT_OF_RANGE (the body is not moved by forces); UNSUPPORTED (no tree);
 *          BUFFER_TOO_SMALL (stride); BUSY; OUT_OF_MEMORY */
CAROM_API int32_t carom_tree_get_coordinates(carom_world *world, carom_body body, carom_tree_coordinate *dst,
                                             uint64_t stride, uint64_t capacity, uint64_t *count, carom_error *error);

/** The speeds that a tree has now.
 *  Accuracy: rounding of the bodies' velocities. What joints do not leave free of these counts as nothing.
 *  @param speeds out, [n]   @param n how many coordinates there are
 *  @status OK; NULL_ARGUMENT; *_HANDLE; OUT_OF_RANGE (n; the body is not moved by forces); UNSUPPORTED (no tree); BUSY;
 *          OUT_OF_MEMORY */
CAROM_API int32_t carom_tree_get_speeds(carom_world *world, carom_body body, double *speeds, uint64_t n,
                                        carom_error *error);

/** Inverse dynamics: the forces that give a tree these accelerations, at the present pose.
 *      forces = M accelerations + what gyroscopic and centrifugal terms and gravity ask
 *  With speeds of 0 and no accelerations these hold the tree against gravity.
 *  Accuracy: 1e-14 of the largest term, for chains of tens of bodies. Oracle: tests/oracle/test_joint_tree.
 *  @param speeds        [n] m/s and rad/s, or NULL: those of now
 *  @param accelerations [n] m/s^2 and rad/s^2, rates of the speeds, or NULL: 0
 *  @param forces        out, [n] N and N m
 *  @param n             how many coordinates there are
 *  @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE (also: forces that are beyond what numbers hold);
 *          OUT_OF_RANGE (n; the body is not moved by forces); UNSUPPORTED (no tree); BUSY; OUT_OF_MEMORY */
CAROM_API int32_t carom_tree_get_forces(carom_world *world, carom_body body, const double *speeds,
                                        const double *accelerations, double *forces, uint64_t n, carom_error *error);

/** The mass matrix of a tree at the present pose, symmetric and positive definite: with speeds v its energy of motion
 *  is v^T M v / 2. Where two axes of one joint agree M is singular.
 *  Accuracy: 1e-14 of the largest entry that a sum has, for chains of tens of bodies. Oracle: tests/oracle/test_joint_tree.
 *  @param mass out, [n n] row by row: kg, kg m and kg m^2   @param n how many coordinates there are
 *  @status OK; NULL_ARGUMENT; *_HANDLE; OUT_OF_RANGE (n; the body is not moved by forces); UNSUPPORTED (no tree);
 *          NOT_FINITE (bodies too far apart or too heavy for numbers); BUSY; OUT_OF_MEMORY */
CAROM_API int32_t carom_tree_get_mass(carom_world *world, carom_body body, double *mass, uint64_t n,
                                      carom_error *error);

#ifdef __cplusplus
}
#endif
#endif
