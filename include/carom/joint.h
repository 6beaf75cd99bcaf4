/** @file joint.h
 *  Joints: what holds two bodies together, or one to the world. A kind says what of their relative motion is locked;
 *  what is left may be limited, driven by a motor and pulled by a spring.
 *
 *  A joint has a frame on each body. Its x axis is the axis of a hinge and of a slider, and the one that twist and
 *  swing are measured by. Coordinates, forces and torques are those of B relative to A.
 *
 *  Solver CAROM_SOLVER_SEVERITY knows no joints: a world with that dial refuses them, and a world with joints refuses
 *  that dial (CAROM_E_UNSUPPORTED).
 *  @thread world: a call that is named get, is or read is a reader of its world, any other call its writer (world.h).
 */
#ifndef CAROM_JOINT_H
#define CAROM_JOINT_H

#include <carom/body.h>

#ifdef __cplusplus
extern "C" {
#endif

/* clang-format off */
#define CAROM_JOINT_BALL 0u      /* the points stay together; twist and swing are free */
#define CAROM_JOINT_HINGE 1u     /* so do the x axes; twist is free */
#define CAROM_JOINT_SLIDER 2u    /* the frames stay parallel and B's point on A's x axis; slide is free */
#define CAROM_JOINT_WELD 3u      /* nothing is free */
#define CAROM_JOINT_DISTANCE 4u  /* the points stay `length` apart: a rod. With a limit a rope, with a spring a
                                    spring */
#define CAROM_JOINT_UNIVERSAL 5u /* the points stay together, B's z axis at right angles to A's y axis: a cross of two
                                    pins */
#define CAROM_JOINT_PULLEY 6u    /* a rope from A's point over two anchors to B's, as carom_joint_set_transmission()
                                    says; until then it holds nothing. Without a limit the rope neither stretches nor
                                    gives way; with one it may be slack */
#define CAROM_JOINT_GEAR 7u      /* A's angle about the x axis of its frame, plus `ratio` times B's about its own,
                                    stays what it is; each relative to the world, where bearings of their own hold the
                                    wheels. Ratio 1 until carom_joint_set_transmission() says another: they turn
                                    against each other */
#define CAROM_JOINT_SIX_AXIS 8u  /* each axis free, locked, limited, driven and sprung as carom_joint_set_axis() says;
                                    until then all are free */
#define CAROM_JOINT_COUPLING 9u  /* the coordinate of one joint follows a polynomial of another's, as
                                    carom_joint_couple() says, which makes such joints */
#define CAROM_JOINT_COUNT 10u
/* clang-format on */

/** Static name of a kind of joint ("hinge", "six_axis"), or "?". Scene files and bindings have these names.
 *  @param kind CAROM_JOINT_* */
CAROM_API const char *carom_joint_kind_name(uint32_t kind);

/** What may be limited, driven or sprung. */
/* clang-format off */
#define CAROM_COORDINATE_TWIST 0u    /* rad, of B about the x axes, whole turns counted: ball, hinge */
#define CAROM_COORDINATE_SWING 1u    /* rad, [0, pi], between the x axes: ball, universal */
#define CAROM_COORDINATE_SLIDE 2u    /* m, of B's point along A's x axis: slider */
#define CAROM_COORDINATE_DISTANCE 3u /* m, between the points: distance; of the rope, |a - anchor_a| + ratio |b -
                                        anchor_b|: pulley */
#define CAROM_COORDINATE_COUNT 4u
/* clang-format on */

/** @name Axes of a six-axis joint: where B's frame is in A's
 *  B's orientation in A's frame is a twist about x, then a swing about an axis across x, q = swing * twist. TURN_X is
 *  the twist, 2 atan2(q.x, q.w). TURN_Y and TURN_Z are the components of the swing's rotation vector: axis times angle.
 *  Where TURN_Y or TURN_Z is locked at 0, the other is the angle about its axis. Where both are free, near a swing of pi
 *  the three are no coordinates any more: keep limits and drives off it by 0.01 rad. All three turns together may be
 *  locked anywhere. Whole turns are counted, @see carom_joint_state.coordinate.
 *  @{ */
/* clang-format off */
#define CAROM_AXIS_X 0u            /* m, B's point along A's x axis */
#define CAROM_AXIS_Y 1u            /* m */
#define CAROM_AXIS_Z 2u            /* m */
#define CAROM_AXIS_TURN_X 3u       /* rad, whole turns counted */
#define CAROM_AXIS_TURN_Y 4u       /* rad, likewise */
#define CAROM_AXIS_TURN_Z 5u       /* rad, likewise */
#define CAROM_AXIS_COUNT 6u
#define CAROM_AXIS_MODE_FREE 0u    /* no bounds */
#define CAROM_AXIS_MODE_LOCKED 1u  /* at `lower` */
#define CAROM_AXIS_MODE_LIMITED 2u /* from `lower` to `upper`; where both are the same and the stops hard, it is
                                      locked */
#define CAROM_AXIS_MODE_COUNT 3u
/* clang-format on */
/** @} */

/** @name What a drive aims at
 *  @{ */
#define CAROM_DRIVE_NONE 0u     /* at nothing: no force */
#define CAROM_DRIVE_POSITION 1u /* force = stiffness (target - x) + damping (speed - x'), `max_force` at most */
#define CAROM_DRIVE_VELOCITY 2u /* the speed, by whatever force up to `max_force` */
#define CAROM_DRIVE_EFFORT 3u   /* a force or torque, `max_force` at most, whatever the motion */
#define CAROM_DRIVE_COUNT 4u
/** @} */

/** @name In what a stiffness and a damping are given. m: what the joint's bodies weigh along the axis, were they alone
 *  and what is locked staying so
 *  @{ */
#define CAROM_GAINS_FREQUENCY 0u    /* Hz and a ratio: force = -m (w^2 x + 2 damping w x'), w = 2 pi stiffness */
#define CAROM_GAINS_FORCE 1u        /* N/m and N s/m, or N m/rad and N m s/rad: force = -(stiffness x + damping x') */
#define CAROM_GAINS_ACCELERATION 2u /* 1/s^2 and 1/s: force = -m (stiffness x + damping x') */
#define CAROM_GAINS_COUNT 3u
/** @} */

/** @name Bits of carom_joint_desc.fields
 *  @{ */
/* clang-format off */
#define CAROM_JOINT_WORLD_FRAME 0x1u  /**< position_a and orientation_a are in world coordinates and hold for both
                                           bodies as they stand now; those of B are not read */
#define CAROM_JOINT_COLLIDE 0x2u      /**< the two bodies may touch each other; else they do not */
#define CAROM_JOINT_FIELD_LENGTH 0x4u /**< length is given; else it is the distance of the points as they stand now */
#define CAROM_JOINT_ACCELERATIONS 0x8u /**< each step measures the joint's accelerations, @see
                                            CAROM_JOINT_BULK_ACCELERATION */
/* clang-format on */
/** @} */

/** Fill with carom_joint_desc_init(): a ball joint, frames at the origins of both bodies, unbreakable. A door on a
 *  hinge that stands upright, the joint's x axis along the world's y:
 *      desc.kind = CAROM_JOINT_HINGE, desc.fields = CAROM_JOINT_WORLD_FRAME, desc.body_b = door;
 *      desc.position_a[0] = 1, desc.orientation_a[2] = desc.orientation_a[3] = 0.70710678118654752; */
typedef struct carom_joint_desc {
  uint32_t struct_size;
  uint32_t kind;           /**< CAROM_JOINT_* */
  uint32_t fields;         /**< CAROM_JOINT_* bits */
  uint32_t reserved;       /**< 0 */
  carom_body body_a;       /**< or CAROM_NULL_HANDLE: the world */
  carom_body body_b;       /**< likewise; not both, and one of the two must be dynamic */
  double position_a[3];    /**< m, of the frame in A's coordinates */
  double orientation_a[4]; /**< x, y, z, w: joint -> A */
  double position_b[3];    /**< m, in B */
  double orientation_b[4]; /**< x, y, z, w, in B */
  double length;           /**< m, [0, 1e9]: of a distance joint */
  double break_force;      /**< N, mean over a step, above which the joint breaks; 0: never */
  double break_torque;     /**< N m, likewise */
  uint64_t user;           /**< the host's; the engine does not read it */
} carom_joint_desc;

/** A coordinate kept within bounds. */
typedef struct carom_joint_limit {
  uint32_t struct_size;
  uint32_t enabled; /**< 0 or 1 */
  double lower;     /**< m or rad: twist [-1e3, 1e3], swing [0, pi], slide [-1e9, 1e9], distance [0, 1e9] */
  double upper;     /**< at least lower */
} carom_joint_limit;

/** A coordinate driven at a speed. */
typedef struct carom_joint_motor {
  uint32_t struct_size;
  uint32_t enabled; /**< 1: on, 0: off */
  double speed;     /**< m/s or rad/s, [-1e6, 1e6] */
  double max_force; /**< N or N m, [0, 1e30]: how hard it pushes at most */
} carom_joint_motor;

/** A coordinate pulled towards a place: a spring, or a motor that holds a position. With x the stretch, w = 2 pi
 *  frequency and m what the joint's bodies weigh along the coordinate were they alone: force = -m (w^2 x + 2 damping w
 *  x'). */
typedef struct carom_joint_spring {
  uint32_t struct_size;
  uint32_t enabled; /**< 1: on, 0: off */
  double target;    /**< m or rad, within the bounds of a limit */
  double frequency; /**< Hz, [0, 1e4]; a quarter of the substep rate at most acts */
  double damping;   /**< ratio, [0, 1e3]; 1: critical */
  double max_force; /**< N or N m, [0, 1e30]: how hard it pulls at most */
} carom_joint_spring;

/** By what a pulley or a gear turns the motion of A into that of B. Fill with carom_joint_transmission_init(). */
typedef struct carom_joint_transmission {
  uint32_t struct_size;
  /** CAROM_JOINT_FIELD_LENGTH: length is given; else it is that of the rope as the bodies stand now */
  uint32_t fields;
  /** [0.001, 1000]: B's part of the rope counts so many times, as if it ran to and fro so often: B is pulled ratio
   *  times as hard as A, and moves 1 / ratio as far. Of a gear B's angle, likewise, of either sign: negative where they
   *  turn the same way, as in a ring gear. 1 at first */
  double ratio;
  double anchor_a
      [3]; /**< m, world: the place that A's part of the rope runs over. A gear has neither anchors nor length */
  double anchor_b[3]; /**< m, world: likewise of B's */
  double length;      /**< m, [0, 1e9]: |a - anchor_a| + ratio |b - anchor_b| is kept at it, a and b the joint's points.
                           A part of the rope without length pulls nowhere: keep points off anchors */
} carom_joint_transmission;

/** What a coupling makes follow what: a gear between two hinges on anything, a finger that closes with another, a rack.
 *  The coordinate of a hinge is its twist, whole turns counted, that of a slider its slide. With x that of the leader,
 *  the follower's is polynomial[0] + polynomial[1] x + ... + polynomial[4] x^4. Each pushes the other: where something
 *  holds the follower, it holds the leader. Fill with carom_joint_coupling_init(). */
typedef struct carom_joint_coupling {
  uint32_t struct_size;
  uint32_t reserved;    /**< 0 */
  carom_joint follower; /**< a hinge or slider */
  carom_joint leader;   /**< another */
  double polynomial[5]; /**< m or rad over powers of m or rad, each [-1e9, 1e9]; 0, 1, 0, 0, 0 at first: as far */
  uint64_t user;        /**< yours */
} carom_joint_coupling;

/** What one axis of a six-axis joint does, or that of a hinge or slider beside its own limit, motor and spring: a hinge
 *  has CAROM_AXIS_TURN_X, a slider CAROM_AXIS_X. Fill with carom_joint_axis_init(). A drive, a spring and stops act beside
 *  each other; of what is stiffer than (pi / 2 h)^2 m, h a substep, so much acts, and springs of one axis share it. */
typedef struct carom_joint_axis {
  uint32_t struct_size;
  uint32_t mode;         /**< CAROM_AXIS_MODE_* */
  double lower;          /**< m, [-1e9, 1e9], or rad, [-1e3, 1e3] */
  double upper;          /**< likewise, at least lower */
  uint32_t stop_gains;   /**< CAROM_GAINS_*: of the stops of a limit */
  uint32_t drive_gains;  /**< of a drive to a position */
  uint32_t spring_gains; /**< of the spring beside the drive */
  uint32_t drive;        /**< CAROM_DRIVE_* */
  double stop_stiffness; /**< of a spring that pushes back from beyond a limit; in Hz [0, 1e4], else [0, 1e30]; it and
                                stop_damping 0: the stops are hard */
  double stop_damping;   /**< beyond a limit; a ratio [0, 1e3], else [0, 1e30] */
  double target;         /**< m or rad, as lower: of a drive to a position */
  double speed; /**< m/s or rad/s, [-1e6, 1e6]: of a drive to a velocity; of a drive to a position that of its target */
  double effort;           /**< N or N m, [-1e30, 1e30]: of a drive by effort */
  double max_force;        /**< N or N m, [0, 1e30]: how hard the drive pushes at most */
  double drive_stiffness;  /**< as stop_stiffness */
  double drive_damping;    /**< as stop_damping */
  double rest;             /**< m or rad, as lower: where the spring rests */
  double spring_stiffness; /**< as stop_stiffness; it and spring_damping 0: there is none */
  double spring_damping;   /**< as stop_damping */
  double friction; /**< N or N m, [0, 1e30]: resists any motion along the axis with at most so much; beside the drive */
  double armature; /**< kg or kg m^2, [0, 1e30]: inertia of a rotor that turns as the axis does, such as a motor's times
                                the square of its gear. It adds armature speed^2 / 2 to the kinetic energy, and gives the bodies
                                no spin of its own. A host that sets velocities sets the rotor's. */
  double
      effort_limit; /**< N or N m, [0, 1e30]: how hard the drives of the axis push at most, however large their max_force
                            is; of a hinge or slider its motor and spring, too. Several that act have even shares. Springs
                            of axes, stops, friction and locks have no part in it. 1e30: none */
  double speed_limit; /**< m/s or rad/s, [0, 1e30]: the axis goes no faster, either way, whatever that takes. Of effect
                            joint_limits. 1e30: none */
} carom_joint_axis;

/** A drive of all three turns as one, by the shortest way: of a ball, or of a six-axis joint none of whose turns is
 *  locked (else it rests). With e the rotation vector, in A's frame, of the shortest turn from the target to where B's
 *  frame is, its torque is stiffness (-e) + damping (velocity - omega), about each of A's axes `max_force` at most.
 *  Fill with carom_joint_orientation_drive_init(). */
typedef struct carom_joint_orientation_drive {
  uint32_t struct_size;
  uint32_t drive;    /**< CAROM_DRIVE_* */
  uint32_t gains;    /**< CAROM_GAINS_* */
  uint32_t reserved; /**< 0 */
  double
      target[4]; /**< x, y, z, w: B's frame -> A's; of CAROM_DRIVE_POSITION. Half a turn off there is no shortest way */
  double velocity[3];  /**< rad/s, [-1e6, 1e6], A's frame, of B relative to A */
  double effort[3];    /**< N m, [-1e30, 1e30], A's frame: of CAROM_DRIVE_EFFORT */
  double max_force[3]; /**< N m, [0, 1e30], about A's x, y, z axis */
  double stiffness;    /**< Hz [0, 1e4], else [0, 1e30] */
  double damping;      /**< a ratio [0, 1e3], else [0, 1e30] */
} carom_joint_orientation_drive;

/** What a joint does and where it is. */
typedef struct carom_joint_state {
  uint32_t struct_size;
  uint32_t broken; /**< 1: it bore too much, and holds nothing any more */
  /** N, world, on B at its point, of locks, limits, motors and springs, mean over the last step; on A the opposite, but
   *  of a pulley 1 / ratio of it, along A's own part of the rope */
  double force[3];
  double torque[3]; /**< N m, world, on B about its point, likewise */
  double gap;       /**< m, how far the points are from where they should be, limits included */
  double angle;     /**< rad, how far the axes are, likewise; of a gear how far its wheels have slipped, of A's turns */
  /** By CAROM_COORDINATE_*, as the bodies stand now. A twist of a ball, a hinge or six axes counts whole turns. It
   *  begins in (-pi, pi] as the joint is made, and goes on from step to step. Snapshots and forks keep it. A pose that a
   *  host sets stands for many angles: taken is the one nearest to the last. Where that lies over 0.1 rad beyond a limit
   *  and another does not, that other is taken. A limit that is set over half a turn away makes whole turns be
   *  forgotten, too. */
  double coordinate[4];
  double axis[6]; /**< m and rad, by CAROM_AXIS_*, likewise; of any kind */
} carom_joint_state;

/** @status OK; NULL_ARGUMENT; STRUCT_SIZE */
CAROM_API int32_t carom_joint_desc_init(carom_joint_desc *desc, uint32_t struct_size);
/** Not enabled; a motor with speed 0 and max_force 0, which moves nothing until that is raised.
 *  @status OK; NULL_ARGUMENT; STRUCT_SIZE */
CAROM_API int32_t carom_joint_limit_init(carom_joint_limit *limit, uint32_t struct_size);
CAROM_API int32_t carom_joint_motor_init(carom_joint_motor *motor, uint32_t struct_size);
CAROM_API int32_t carom_joint_spring_init(carom_joint_spring *spring, uint32_t struct_size);
/** Ratio 1, anchors at the origin, the rope as long as it is.   @status OK; NULL_ARGUMENT; STRUCT_SIZE */
CAROM_API int32_t carom_joint_transmission_init(carom_joint_transmission *transmission, uint32_t struct_size);

/** The follower goes as far as the leader.   @status OK; NULL_ARGUMENT; STRUCT_SIZE */
CAROM_API int32_t carom_joint_coupling_init(carom_joint_coupling *coupling, uint32_t struct_size);

/** Free, without drive and spring, `max_force` and limits as large as may be.   @status OK; NULL_ARGUMENT; STRUCT_SIZE */
CAROM_API int32_t carom_joint_axis_init(carom_joint_axis *axis, uint32_t struct_size);
/** No drive, the target as the frames are when they agree.   @status OK; NULL_ARGUMENT; STRUCT_SIZE */
CAROM_API int32_t carom_joint_orientation_drive_init(carom_joint_orientation_drive *drive, uint32_t struct_size);

/** Join two bodies, or one and the world. Their islands wake. A body that is destroyed takes its joints with it.
 *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED (a newer field; solver severity; a coupling, which
 *          carom_joint_couple() makes); UNKNOWN_ENUM; *_HANDLE; NOT_UNIT;
 *          NOT_FINITE; OUT_OF_RANGE (also: a body joined to itself, none that is dynamic, or places 1e15 m from a
 *          body's origin or 8e15 m from each other, as of bodies that the next step will quarantine); BUSY; REENTRANT;
 *          LIMIT; OUT_OF_MEMORY */
CAROM_API int32_t carom_joint_create(carom_world *world, const carom_joint_desc *desc, carom_joint *joint,
                                     carom_error *error);
/** @status OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT */
CAROM_API int32_t carom_joint_destroy(carom_world *world, carom_joint joint, carom_error *error);
/** @param desc out: as it was made, with frames in body coordinates
 *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; BUSY */
CAROM_API int32_t carom_joint_get(carom_world *world, carom_joint joint, carom_joint_desc *desc, carom_error *error);
/** @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; BUSY */
CAROM_API int32_t carom_joint_get_state(carom_world *world, carom_joint joint, carom_joint_state *state,
                                        carom_error *error);

/** Set a limit, a motor, a spring of a coordinate that the joint's kind leaves free; its bodies wake.
 *  @param coordinate CAROM_COORDINATE_*
 *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; UNSUPPORTED (the kind has no such coordinate; a swing has a
 *          limit alone); *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT */
CAROM_API int32_t carom_joint_set_limit(carom_world *world, carom_joint joint, uint32_t coordinate,
                                        const carom_joint_limit *limit, carom_error *error);
CAROM_API int32_t carom_joint_set_motor(carom_world *world, carom_joint joint, uint32_t coordinate,
                                        const carom_joint_motor *motor, carom_error *error);
CAROM_API int32_t carom_joint_set_spring(carom_world *world, carom_joint joint, uint32_t coordinate,
                                         const carom_joint_spring *spring, carom_error *error);
/** @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; UNSUPPORTED; *_HANDLE; BUSY */
CAROM_API int32_t carom_joint_get_limit(carom_world *world, carom_joint joint, uint32_t coordinate,
                                        carom_joint_limit *limit, carom_error *error);
CAROM_API int32_t carom_joint_get_motor(carom_world *world, carom_joint joint, uint32_t coordinate,
                                        carom_joint_motor *motor, carom_error *error);
CAROM_API int32_t carom_joint_get_spring(carom_world *world, carom_joint joint, uint32_t coordinate,
                                         carom_joint_spring *spring, carom_error *error);

/** Say what a pulley's rope runs over, or how a gear's wheels turn; the bodies wake. What a limit, motor or spring on a
 *  pulley's distance requires is in metres of the rope. A gear holds from where its wheels stand now, as often as they
 *  may turn: turns are counted while it steps, as long as a wheel's speed changes by less than half a turn a substep in
 *  one; a pose that the host sets between steps is no turn.
 *  Accuracy: second order in the substep, as all joints; the rope's length errs by what joint_frequency leaves, and
 *  under the direct solver by 1e-9 m; a gear's angles err by rounding, a few 1e-16 rad a substep. Oracle:
 *  tests/oracle/test_pulley_gear.
 *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED (the joint is neither pulley nor gear; a newer field); *_HANDLE;
 *          NOT_FINITE; OUT_OF_RANGE (also: a ratio of 0; 1 is what the init function gives); BUSY; REENTRANT */
CAROM_API int32_t carom_joint_set_transmission(carom_world *world, carom_joint joint,
                                               const carom_joint_transmission *transmission, carom_error *error);
/** @param transmission out: as it was set, with its length; ratio 0: not yet
 *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; *_HANDLE; BUSY */
CAROM_API int32_t carom_joint_get_transmission(carom_world *world, carom_joint joint,
                                               carom_joint_transmission *transmission, carom_error *error);

/** Couple two joints: makes a joint of kind CAROM_JOINT_COUPLING, whose bodies are one of each joint's. Their islands
 *  wake. It goes with either joint that is destroyed, and holds nothing once one of them is broken. What it is off by,
 *  as it is made or because a host moves joints, is led back. It has no frames and never breaks itself.
 *  carom_joint_state of it: `gap` or `angle` is how far the follower is off; force is 0, torque[0] the N or N m along the
 *  follower's coordinate that it pushes with, mean over the last step.
 *  Accuracy: as of locks: second order in the substep, 1e-9 m or rad under the direct solver, rounding where dial
 *  joint_order moves it. Oracle: tests/oracle/test_couplings.
 *  @param joint out: the coupling
 *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED (a joint that is neither hinge nor slider; a newer field; a
 *          reserved one; solver severity); *_HANDLE; NOT_FINITE; OUT_OF_RANGE (also: a joint that follows itself); BUSY;
 *          REENTRANT; LIMIT; OUT_OF_MEMORY */
CAROM_API int32_t carom_joint_couple(carom_world *world, const carom_joint_coupling *coupling, carom_joint *joint,
                                     carom_error *error);
/** Give a coupling another polynomial; its bodies wake.
 *  @param coupling its follower and leader are CAROM_NULL_HANDLE or as they were, its user is not read
 *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED (the joint is no coupling; other joints than its own; a newer
 *          field; a reserved one); *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT */
CAROM_API int32_t carom_joint_set_coupling(carom_world *world, carom_joint joint, const carom_joint_coupling *coupling,
                                           carom_error *error);
/** @param coupling out: as it was made
 *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; *_HANDLE; BUSY */
CAROM_API int32_t carom_joint_get_coupling(carom_world *world, carom_joint joint, carom_joint_coupling *coupling,
                                           carom_error *error);

/** Say what one axis of a six-axis joint, a hinge or a slider does; the bodies wake. Effect joint_limits has its limits, joint_motors its
 *  drives; springs and locks are of the joint. A target, a lock's place or a limit may be set anew before each step.
 *  Accuracy: what is locked errs in second order of the substep h, under the direct solver by 1e-9 m or rad. With w the
 *  frequency and b half the damping per mass: springs, stops and drives to a position swing late by w h / 2 of their
 *  amplitude and fade slower by b h of their rate; at rest they sag by load / stiffness, to rounding where one joint
 *  bears all, in first order where soft_step sweeps over several. A drive to a velocity holds that of the middle of a
 *  substep under the direct solver, and one with a damping alone does under any: what a step ends with differs by what
 *  the load does in h / 2. Forces of drives are met to rounding. A speed limit holds to 1e-9 under the
 *  direct solver, where one joint bears all to rounding under others. Oracle: tests/oracle/test_six_axis, test_six_axis_scenes, test_armature,
 *  test_axis_limits.
 *  @param axis CAROM_AXIS_*
 *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; UNSUPPORTED (the joint has no such axis of its own; a newer field);
 *          *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT */
CAROM_API int32_t carom_joint_set_axis(carom_world *world, carom_joint joint, uint32_t axis,
                                       const carom_joint_axis *desc, carom_error *error);
/** @param axis CAROM_AXIS_*   @param desc out: as it was set
 *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; UNSUPPORTED; *_HANDLE; BUSY */
CAROM_API int32_t carom_joint_get_axis(carom_world *world, carom_joint joint, uint32_t axis, carom_joint_axis *desc,
                                       carom_error *error);
/** Drive a ball, or a six-axis joint, to an orientation or to an angular velocity; the bodies wake. Of effect
 *  joint_motors. Accuracy: first order in the substep of where it is, as springs with dampers are; where nothing pulls
 *  it ends at the target to rounding. Oracle: tests/oracle/test_six_axis.
 *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; UNSUPPORTED (the joint is neither ball nor six-axis; a newer
 *          field; a reserved one); *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; BUSY; REENTRANT */
CAROM_API int32_t carom_joint_set_orientation_drive(carom_world *world, carom_joint joint,
                                                    const carom_joint_orientation_drive *drive, carom_error *error);
/** @param drive out: as it was set
 *  @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; *_HANDLE; BUSY */
CAROM_API int32_t carom_joint_get_orientation_drive(carom_world *world, carom_joint joint,
                                                    carom_joint_orientation_drive *drive, carom_error *error);

/** @name What carom_world_read_joints() reads, and carom_world_write_joints() writes
 *  The number before the colon is how many scalars a record has. A joint of one motion is a hinge (its motion is the
 *  twist), a slider (slide), a distance joint or a pulley (distance). Six numbers are by CAROM_AXIS_*. What is set has
 *  the bounds of the call that sets it for one joint.
 *
 *  POSITION, VELOCITY, AXES and AXIS_SPEEDS move bodies. A joint moves that side of it which nothing holds, and all that
 *  hangs there goes along: other joints keep where they are and how fast they go. Where nothing holds a tree, its base
 *  stays: the body that is B of no joint, of several the first in the order of carom_world_get_bodies(). POSITION and
 *  AXES leave rates as they are, of turns that are all free the angular velocity in A's frame; VELOCITY and AXIS_SPEEDS
 *  leave places. Numbers are within 1e9. Those of AXES and AXIS_SPEEDS along what is locked are not used: there the joint
 *  is without a gap afterwards. Whole turns count. Places beyond limits are taken: what is beyond is led back. A joint
 *  that has what is written already stays as it is, to the bit. So what was read may be written back, of loops, too; else
 *  a joint of a loop is UNSUPPORTED. Of a universal joint TURN_Y and TURN_Z are used, its twist follows. Of what is not a joint's only gears go on from where they are: distance joints
 *  and pulleys hold, springs and contacts do not.
 *
 *  ACCELERATION is (rate as the last step ended - rate as it began) / step, finite, and 0 before the first step.
 *  Snapshots keep it. It is that of the mean force over a step, contacts and joints included.
 *
 *  TARGET_EFFORT is a motor of speed 1e6, of its sign, whose max_force it is. Of any other motor it is read as 0.
 *  @{ */
/* clang-format off */
#define CAROM_JOINT_BULK_COORDINATES 0u /* 4: m or rad, by CAROM_COORDINATE_*, as the bodies stand now; read only */
#define CAROM_JOINT_BULK_SPEEDS 1u      /* 4: m/s or rad/s, their rates, from the present velocities; read only */
#define CAROM_JOINT_BULK_AXES 2u        /* 6: m and rad, by CAROM_AXIS_*; written: hinge, slider, ball, universal,
                                           six-axis */
#define CAROM_JOINT_BULK_AXIS_SPEEDS 3u /* 6: m/s and rad/s, their rates; written likewise */
#define CAROM_JOINT_BULK_FORCE 4u       /* 3: N, world, as carom_joint_state.force; read only */
#define CAROM_JOINT_BULK_TORQUE 5u      /* 3: N m, world, as carom_joint_state.torque; read only */
#define CAROM_JOINT_BULK_ERROR 6u       /* 2: m and rad, gap and angle; read only */
#define CAROM_JOINT_BULK_BROKEN 7u      /* 1: 1 or 0; read only */
#define CAROM_JOINT_BULK_POSITION 8u    /* 1: m or rad, of one motion, whole turns counted; written: hinge, slider */
#define CAROM_JOINT_BULK_VELOCITY 9u    /* 1: m/s or rad/s, of one motion; written likewise */
#define CAROM_JOINT_BULK_EFFORT 10u     /* 1: N or N m, borne along one motion, mean over the last step; read only */
#define CAROM_JOINT_BULK_TARGET 11u          /* 1: m or rad, of one motion: its spring's */
#define CAROM_JOINT_BULK_TARGET_VELOCITY 12u /* 1: m/s or rad/s, of one motion: its motor's speed */
#define CAROM_JOINT_BULK_TARGET_EFFORT 13u   /* 1: N or N m, [-1e30, 1e30], of one motion: its motor's force */
#define CAROM_JOINT_BULK_MOTOR 14u           /* 3: enabled, speed, max_force, as carom_joint_motor; of one motion */
#define CAROM_JOINT_BULK_SPRING 15u          /* 5: enabled, target, frequency, damping, max_force; of one motion */
#define CAROM_JOINT_BULK_LIMIT 16u           /* 3: enabled, lower, upper; of one motion */
#define CAROM_JOINT_BULK_AXIS_EFFORTS 17u    /* 6: N and N m, FORCE and TORQUE in A's frame; of any kind, read only */
#define CAROM_JOINT_BULK_AXIS_TARGETS 18u    /* 6: target of each axis of a six-axis joint, as carom_joint_axis */
#define CAROM_JOINT_BULK_AXIS_TARGET_VELOCITIES 19u /* 6: speed, likewise */
#define CAROM_JOINT_BULK_AXIS_TARGET_EFFORTS 20u    /* 6: effort, likewise */
#define CAROM_JOINT_BULK_AXIS_MAX_FORCES 21u        /* 6: max_force, likewise */
#define CAROM_JOINT_BULK_AXIS_GAINS 22u      /* 12: drive_stiffness and drive_damping of each axis, in its units */
#define CAROM_JOINT_BULK_AXIS_LIMITS 23u     /* 12: lower and upper of each axis */
#define CAROM_JOINT_BULK_ORIENTATION_TARGET 24u   /* 4: x, y, z, w, of the drive to an orientation: ball, six-axis */
#define CAROM_JOINT_BULK_ORIENTATION_VELOCITY 25u /* 3: rad/s, A's frame, likewise */
#define CAROM_JOINT_BULK_ORIENTATION_EFFORT 26u   /* 3: N m, A's frame, likewise */
#define CAROM_JOINT_BULK_ORIENTATION_GAINS 27u    /* 2: stiffness, damping, likewise */
#define CAROM_JOINT_BULK_ACCELERATION 28u       /* 1: m/s^2 or rad/s^2, of a hinge or slider; read only */
#define CAROM_JOINT_BULK_AXIS_ACCELERATIONS 29u /* 6: by CAROM_AXIS_*, of any kind; read only. Both of joints with
                                                   CAROM_JOINT_ACCELERATIONS */
#define CAROM_JOINT_BULK_AXIS_FRICTIONS 30u     /* 6: friction of each axis of a six-axis joint, as carom_joint_axis */
#define CAROM_JOINT_BULK_AXIS_ARMATURES 31u     /* 6: armature, likewise */
#define CAROM_JOINT_BULK_AXIS_EFFORT_LIMITS 32u /* 6: effort_limit, likewise */
#define CAROM_JOINT_BULK_AXIS_SPEED_LIMITS 33u  /* 6: speed_limit, likewise */
#define CAROM_JOINT_BULK_FRICTION 34u           /* 1: friction of the axis of a hinge or slider, as carom_joint_axis */
#define CAROM_JOINT_BULK_ARMATURE 35u           /* 1: armature, likewise */
#define CAROM_JOINT_BULK_EFFORT_LIMIT 36u       /* 1: effort_limit, likewise */
#define CAROM_JOINT_BULK_SPEED_LIMIT 37u        /* 1: speed_limit, likewise */
#define CAROM_JOINT_BULK_DRIVE_TARGET 38u       /* 1: target of the drive of a hinge's or slider's axis, likewise: a servo's */
#define CAROM_JOINT_BULK_DRIVE_VELOCITY 39u     /* 1: speed, likewise */
#define CAROM_JOINT_BULK_DRIVE_EFFORT 40u       /* 1: effort, likewise */
#define CAROM_JOINT_BULK_DRIVE_MAX_FORCE 41u    /* 1: max_force, likewise */
#define CAROM_JOINT_BULK_DRIVE_GAINS 42u        /* 2: drive_stiffness and drive_damping, in its units, likewise */
#define CAROM_JOINT_BULK_COUNT 43u
/* clang-format on */
/** @} */

/** How many scalars a record of a field has.
 *  @param field CAROM_JOINT_BULK_*   @param width out: of a record   @status OK; NULL_ARGUMENT; UNKNOWN_ENUM */
CAROM_API int32_t carom_joint_bulk_width(uint32_t field, uint32_t *width);

/** Read one field of n joints, as carom_world_read() does of bodies.
 *  A rate of what has no direction (points or axes that agree) is the one at which it begins to grow.
 *  Accuracy: rounding of poses and velocities; of a twist times 1 / cos(swing / 2). An effort errs in first order of the
 *  step, by how far the axis turned in it. Oracle: tests/abi/test_joint_bulk.
 *  @param field   CAROM_JOINT_BULK_*   @param scalar CAROM_SCALAR_*
 *  @param joints  [n], or NULL for all in the order of carom_world_get_joints() (n must be their number)
 *  @param dst     n records of the field's scalars, `stride` bytes apart; stride 0: tightly packed
 *  @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; *_HANDLE (nothing is written); UNSUPPORTED (a kind without the field);
 *  OUT_OF_RANGE (n); BUFFER_TOO_SMALL (stride); BUSY */
CAROM_API int32_t carom_world_read_joints(carom_world *world, uint32_t field, uint32_t scalar,
                                          const carom_joint *joints, uint64_t n, void *dst, uint64_t stride,
                                          carom_error *error);

/** Write one field of n joints; all values are validated before the first is written, joints of a tree are moved as one.
 *  Accuracy of places: rounding of poses, to 1e-15 of a chain's length a joint. Oracle: tests/oracle/test_joint_moves. Modes, units of gains and what is
 *  enabled stay as they are, where the record does not have them. Bodies of joints that this changes wake. Arguments as carom_world_read_joints().
 *  @param src n records of the field's scalars, `stride` bytes apart; stride 0: tightly packed
 *  @status as carom_world_read_joints(); UNSUPPORTED (also: a field that is read only; a joint of a loop, a broken one,
 *  one between bodies that forces do not move); NOT_FINITE; NOT_UNIT;
 *  OUT_OF_RANGE; REENTRANT */
CAROM_API int32_t carom_world_write_joints(carom_world *world, uint32_t field, uint32_t scalar,
                                           const carom_joint *joints, uint64_t n, const void *src, uint64_t stride,
                                           carom_error *error);

/** Number of joints, and their handles in creation order of the slots.
 *  @param joints [capacity] or NULL   @param count out: how many there are
 *  @status OK; NULL_ARGUMENT; BUSY */
CAROM_API int32_t carom_world_get_joints(carom_world *world, carom_joint *joints, uint64_t capacity, uint64_t *count,
                                         carom_error *error);

#ifdef __cplusplus
}
#endif
#endif
