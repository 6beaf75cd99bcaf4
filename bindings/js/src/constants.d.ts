// Written by bindings/gen/generate from include/carom; do not edit.
/** of these headers */
export const CAROM_VERSION_MAJOR: 0;
/** of these headers */
export const CAROM_VERSION_MINOR: 9;
/** of these headers */
export const CAROM_VERSION_PATCH: 0;
/** the call did what it says */
export const CAROM_OK: 0;
/** a required pointer is NULL */
export const CAROM_E_NULL_ARGUMENT: -1;
/** a number is NaN or infinite */
export const CAROM_E_NOT_FINITE: -2;
/** a number is finite but outside its documented bounds */
export const CAROM_E_OUT_OF_RANGE: -3;
/** a quaternion or normal is further than 1e-6 from unit length */
export const CAROM_E_NOT_UNIT: -4;
/** an enumeration value this library does not know */
export const CAROM_E_UNKNOWN_ENUM: -5;
/** struct_size is smaller than the smallest version of the struct */
export const CAROM_E_STRUCT_SIZE: -6;
/** the request comes from a newer header, or asks for what this build cannot do */
export const CAROM_E_UNSUPPORTED: -7;
/** the handle was never issued */
export const CAROM_E_INVALID_HANDLE: -8;
/** the object behind the handle was destroyed */
export const CAROM_E_STALE_HANDLE: -9;
/** a handle of another kind (a shape where a body is wanted, ...) */
export const CAROM_E_WRONG_KIND: -10;
/** a handle of another world or engine */
export const CAROM_E_WRONG_WORLD: -11;
/** another thread is stepping, changing or reading this world */
export const CAROM_E_BUSY: -12;
/** called from inside a callback (a support function, allocator or log) */
export const CAROM_E_REENTRANT: -13;
/** the object is still referred to by others */
export const CAROM_E_IN_USE: -14;
/** the allocator returned NULL */
export const CAROM_E_OUT_OF_MEMORY: -15;
/** a hard limit of the library is reached */
export const CAROM_E_LIMIT: -16;
/** stride or capacity does not hold one element */
export const CAROM_E_BUFFER_TOO_SMALL: -17;
/** the path is not absolute, or nothing readable is there */
export const CAROM_E_PLUGIN_PATH: -18;
/** the dynamic loader refused the file, or the entry symbol is missing */
export const CAROM_E_PLUGIN_LOAD: -19;
/** the plugin was built against an incompatible plugin.h */
export const CAROM_E_PLUGIN_ABI: -20;
/** the support function is not one of a bounded convex set; see the witness */
export const CAROM_E_PLUGIN_INVALID: -21;
/** a declaration disagrees with the support function; see the witness */
export const CAROM_E_DECLARATION_FALSE: -22;
/** the body is flat, so no mass follows from a density */
export const CAROM_E_NO_VOLUME: -23;
/** a plugin with this id is already loaded */
export const CAROM_E_ALREADY_EXISTS: -24;
/** no object of this name */
export const CAROM_E_NOT_FOUND: -25;
/** a fault of the library itself; please report it */
export const CAROM_E_INTERNAL: -26;
/** bytes that are damaged, cut off or no snapshot */
export const CAROM_E_CORRUPT: -27;
/** a snapshot of a world with other things in it */
export const CAROM_E_MISMATCH: -28;
/** a function that the host gave to write with said that it failed */
export const CAROM_E_WRITE_FAILED: -29;
/** a number of the library that is fixed, no dial */
export const CAROM_E_READ_ONLY: -30;
/** no object: never the handle of one */
export const CAROM_NULL_HANDLE: 0n;
/** float, 4 bytes */
export const CAROM_SCALAR_F32: 0;
/** double, 8 bytes */
export const CAROM_SCALAR_F64: 1;
/** its error was estimated in this step, else in one before */
export const CAROM_ISLAND_ESTIMATED: 1;
/** the bound of work was reached: its error is over the tolerance */
export const CAROM_ISLAND_BOUND: 2;
/** joints alone hold it: its error is of order 2, 4 or 6 */
export const CAROM_ISLAND_JOINTS_ALONE: 4;
/** more substeps do not lessen its error, which is over the tolerance: contacts, mostly */
export const CAROM_ISLAND_STALLED: 8;
/** bodies: one CAROM_FIELD_* */
export const CAROM_COLUMN_BODIES: 0;
/** joints: one CAROM_JOINT_BULK_* */
export const CAROM_COLUMN_JOINTS: 1;
/** dynamic bodies: 1, kg; writing scales the inertia alike, the centre stays */
export const CAROM_COLUMN_MASSES: 2;
/** materials: 2, friction and restitution */
export const CAROM_COLUMN_MATERIALS: 3;
/** the world, n is 1: 3, m/s^2 */
export const CAROM_COLUMN_GRAVITY: 4;
/** the world, n is 1: 1, s, simulated; read only */
export const CAROM_COLUMN_TIME: 5;
/** bodies: 3, N, world: normal forces on it, mean of the last step; read only */
export const CAROM_COLUMN_CONTACT_FORCES: 6;
/** bodies or the world: 1, how far along a ray something is met first, in parts of `direction`, `max` where nothing is; read only */
export const CAROM_COLUMN_RAYS: 7;
export const CAROM_COLUMN_COUNT: 8;
/** by carom_batch_read() and carom_batch_write() */
export const CAROM_WHEN_ON_CALL: 0;
/** written before each step, too */
export const CAROM_WHEN_BEFORE_STEP: 1;
/** read after each step, too, and after calls that change worlds */
export const CAROM_WHEN_AFTER_STEP: 2;
export const CAROM_WHEN_COUNT: 3;
/** it steps */
export const CAROM_STOPPED_NO: 0;
/** a step had faults: carom_batch_get_faults() */
export const CAROM_STOPPED_FAULT: 1;
/** there was no memory for a step: it is as before that */
export const CAROM_STOPPED_MEMORY: 2;
/** in [0, 1) */
export const CAROM_RANDOM_UNIFORM: 0;
/** mean 0, deviation 1 */
export const CAROM_RANDOM_NORMAL: 1;
export const CAROM_RANDOM_COUNT: 2;
/** root of a b */
export const CAROM_MIX_GEOMETRIC_MEAN: 0;
/** the larger */
export const CAROM_MIX_MAXIMUM: 1;
/** the smaller */
export const CAROM_MIX_MINIMUM: 2;
/** (a + b) / 2 */
export const CAROM_MIX_AVERAGE: 3;
/** a b */
export const CAROM_MIX_MULTIPLY: 4;
/** never moves */
export const CAROM_BODY_STATIC: 0;
/** moved by its velocity; infinite mass */
export const CAROM_BODY_KINEMATIC: 1;
/** moved by forces, contacts and joints */
export const CAROM_BODY_DYNAMIC: 2;
/** mass given; else from colliders' densities */
export const CAROM_BODY_FIELD_MASS: 1;
/** center given; else from colliders. needs MASS */
export const CAROM_BODY_FIELD_CENTER: 2;
/** inertia given; else from colliders, scaled to mass. needs MASS */
export const CAROM_BODY_FIELD_INERTIA: 4;
/** it never falls asleep, nor does what it touches */
export const CAROM_BODY_STAYS_AWAKE: 8;
/** it takes no part in steps, see carom_body_set_enabled() */
export const CAROM_BODY_DISABLED: 16;
/** its centre of mass keeps its world x */
export const CAROM_LOCK_LINEAR_X: 1;
/** likewise its y */
export const CAROM_LOCK_LINEAR_Y: 2;
/** likewise its z */
export const CAROM_LOCK_LINEAR_Z: 4;
/** it does not turn about the world's x axis */
export const CAROM_LOCK_ANGULAR_X: 8;
/** likewise about y */
export const CAROM_LOCK_ANGULAR_Y: 16;
/** likewise about z */
export const CAROM_LOCK_ANGULAR_Z: 32;
/** it keeps its pose */
export const CAROM_LOCK_ALL: 63;
/** LINEAR_Z, ANGULAR_X, ANGULAR_Y: a body of a flat world, the plane of x and y */
export const CAROM_LOCK_PLANE: 28;
/** carom_body_set_gravity_factor() */
export const CAROM_ATTRIBUTE_GRAVITY_FACTOR: 0;
/** carom_body_set_locks(); as the host gave them, whether or not they are forbidden */
export const CAROM_ATTRIBUTE_LOCKS: 1;
/** carom_body_set_drag(): linear, quadratic */
export const CAROM_ATTRIBUTE_DRAG: 2;
/** carom_body_set_force_field_mask() */
export const CAROM_ATTRIBUTE_FORCE_FIELD_MASK: 3;
/** A m^2, axes of the body: magnetic fields turn it, see CAROM_FORCE_FIELD_MAGNETIC */
export const CAROM_ATTRIBUTE_MAGNETIC_MOMENT: 4;
export const CAROM_ATTRIBUTE_COUNT: 5;
/** the most that an attribute can have */
export const CAROM_ATTRIBUTE_NUMBERS: 4;
/** in steps in which it is fast for its size (default) */
export const CAROM_CONTINUOUS_AUTO: 0;
/** in every step */
export const CAROM_CONTINUOUS_ALWAYS: 1;
/** in none: cheap debris that may pass through walls */
export const CAROM_CONTINUOUS_NEVER: 2;
/** default category, see carom_collider_set_filter() */
export const CAROM_FILTER_CATEGORY: 1n;
/** default mask */
export const CAROM_FILTER_MASK: 18446744073709551615n;
/** 3: m, world, origin of the body frame */
export const CAROM_FIELD_POSITION: 0;
/** 4: x, y, z, w */
export const CAROM_FIELD_ORIENTATION: 1;
/** 7: position, orientation */
export const CAROM_FIELD_POSE: 2;
/** 3: m/s, world, of the centre of mass */
export const CAROM_FIELD_LINEAR_VELOCITY: 3;
/** 3: rad/s, world */
export const CAROM_FIELD_ANGULAR_VELOCITY: 4;
/** 6: linear, angular */
export const CAROM_FIELD_VELOCITY: 5;
/** 6: N and N m, world, pending for the next step; writing replaces it */
export const CAROM_FIELD_FORCE: 6;
/** 3: m, world, centre of mass; read only */
export const CAROM_FIELD_CENTER: 7;
/** 1: kg; read only */
export const CAROM_FIELD_MASS: 8;
export const CAROM_FIELD_COUNT: 9;
/** no contact within the motion, proven */
export const CAROM_CAST_MISS: 0;
/** contact begins within the motion */
export const CAROM_CAST_HIT: 1;
/** one is in the other already at the start: time 0 */
export const CAROM_CAST_OVERLAP: 2;
/** the cap came first, or numbers are too large: neither was proven. `lower` holds */
export const CAROM_CAST_UNDECIDED: 3;
/** of a batch: this ray is not finite, or its max is negative; it was not cast */
export const CAROM_CAST_BAD_RAY: 4;
/** support functions only, no routine for declared forms */
export const CAROM_ASK_GENERIC: 1;
/** sensors are found, too; of a world only */
export const CAROM_ASK_SENSORS: 2;
/** What a ray or a shape touches or overlaps at its start is passed over: that collider. Of a mesh or height field it
 *  is each triangle touched, and for a shape each other one that the motion does not go into. Overlaps and the nearest
 *  do not use it. */
export const CAROM_ASK_IGNORE_TOUCHED: 4;
/** proven by `normal`: along it the shapes are at least separation_bound apart */
export const CAROM_OVERLAP_APART: 0;
/** proven by `point`, which is in both */
export const CAROM_OVERLAP_OVERLAPPING: 1;
/** within rounding (slack) of touching, or the cap came first: neither was proven */
export const CAROM_OVERLAP_TOUCHING: 2;
/** a support function misbehaved; nothing else is meaningful */
export const CAROM_OVERLAP_FAULT: 3;
/** in place of an index: no shape */
export const CAROM_NO_SHAPE: 4294967295;
/** nothing is under it: it falls */
export const CAROM_GROUND_AIR: 0;
/** it touches ground steeper than max_slope: it slides down without friction */
export const CAROM_GROUND_STEEP: 1;
/** it stands, and can walk and jump */
export const CAROM_GROUND_FIRM: 2;
/** its orientation turns about `up` with the ground that it rides */
export const CAROM_CHARACTER_TURNS: 1;
/** no gravity, no steps, no ground: it moves along all of `walk`, as swimmers do */
export const CAROM_CHARACTER_FLIES: 2;
/** contacts that a move keeps: of more, the first */
export const CAROM_CHARACTER_CONTACTS: 8;
/** choice: CAROM_INTEGRATOR_* */
export const CAROM_DIAL_INTEGRATOR: 0;
/** choice: CAROM_ROTATION_*: how bodies with unlike moments of inertia spin */
export const CAROM_DIAL_ROTATION: 1;
/** integrate-and-solve passes per step */
export const CAROM_DIAL_SUBSTEPS: 2;
/** choice: CAROM_SOLVER_* */
export const CAROM_DIAL_SOLVER: 3;
/** severity: at most this many impulses per contact of a group and substep */
export const CAROM_DIAL_VELOCITY_ITERATIONS: 4;
/** severity: at most this many position corrections per contact of a group and substep; 0: none, under direct, too */
export const CAROM_DIAL_POSITION_ITERATIONS: 5;
/** m/s: velocity error left unresolved at a contact */
export const CAROM_DIAL_VELOCITY_TOLERANCE: 6;
/** m: penetration left unresolved; of what is thin at most 2 % of its thickness */
export const CAROM_DIAL_POSITION_TOLERANCE: 7;
/** m/s: below this approach speed a contact does not bounce */
export const CAROM_DIAL_RESTITUTION_SPEED: 8;
/** choice: CAROM_SEARCH_* */
export const CAROM_DIAL_SEVERITY_SEARCH: 9;
/** choice: 0 one group for all contacts, 1 contact groups (islands) */
export const CAROM_DIAL_GROUPS: 10;
/** choice: CAROM_BROAD_* */
export const CAROM_DIAL_BROAD_PHASE: 11;
/** m: cell size of the uniform grid; 0: chosen from the scene */
export const CAROM_DIAL_GRID_CELL: 12;
/** m: pairs nearer than this make contacts */
export const CAROM_DIAL_CONTACT_DISTANCE: 13;
/** choice: 0 generic path for every pair, 1 specific routines where declared */
export const CAROM_DIAL_PAIR_ROUTINES: 14;
/** choice: CAROM_NARROW_* for the generic path */
export const CAROM_DIAL_NARROW_PHASE: 15;
/** choice: CAROM_SIMPLEX_* */
export const CAROM_DIAL_SIMPLEX: 16;
/** relative width of the bracket at which GJK and EPA stop */
export const CAROM_DIAL_GJK_TOLERANCE: 17;
/** cap */
export const CAROM_DIAL_GJK_ITERATIONS: 18;
/** cap */
export const CAROM_DIAL_EPA_ITERATIONS: 19;
/** m: shell around each shape in CAROM_NARROW_HYBRID */
export const CAROM_DIAL_HYBRID_MARGIN: 20;
/** choice: 0 start each query afresh, 1 start from the last separating vector */
export const CAROM_DIAL_WARM_SEPARATION: 21;
/** choice: CAROM_MANIFOLD_* */
export const CAROM_DIAL_MANIFOLD: 22;
/** m: a cached point is dropped when it drifted further than this */
export const CAROM_DIAL_CACHE_DISTANCE: 23;
/** choice: 0 solve each step from zero, 1 start from the last step's impulses */
export const CAROM_DIAL_WARM_START: 24;
/** relative width up to which an earlier bracket, widened by the motion since, stands in for a query of the generic path; 0: off */
export const CAROM_DIAL_CARRY_OVER: 25;
/** Hz: stiffness of soft contacts; what is thin has stiffer ones, and sinks by 0.1 % of its thickness under its own weight */
export const CAROM_DIAL_CONTACT_FREQUENCY: 26;
/** damping ratio of soft contacts */
export const CAROM_DIAL_CONTACT_DAMPING: 27;
/** m/s: overlap of a contact is undone at this speed at most (soft, direct) */
export const CAROM_DIAL_PUSH_SPEED: 28;
/** choice: 0 everything is simulated, 1 islands that came to rest sleep until something touches them; see carom_body_is_asleep() */
export const CAROM_DIAL_SLEEP: 29;
/** m/s: no point of a body that falls asleep moves faster */
export const CAROM_DIAL_SLEEP_SPEED: 30;
/** s: for how long it has been so */
export const CAROM_DIAL_SLEEP_TIME: 31;
/** CAROM_SOLVER_AUTO solves groups directly that would sink by more of their thickness */
export const CAROM_DIAL_DIRECT_SINK: 32;
/** or where touching bodies' masses are further apart than this */
export const CAROM_DIAL_DIRECT_RATIO: 33;
/** unless they take more block products a step than this */
export const CAROM_DIAL_DIRECT_WORK: 34;
/** rad: arms of contacts turn with a body only when it has turned by this */
export const CAROM_DIAL_HOLD_ANGLE: 35;
/** Hz: stiffness of joints that the direct solver does not solve */
export const CAROM_DIAL_JOINT_FREQUENCY: 36;
/** their damping ratio */
export const CAROM_DIAL_JOINT_DAMPING: 37;
/** choice: CAROM_SWEEP_*: what is swept from pose to pose, so that it passes through nothing; see carom_body_set_continuous() */
export const CAROM_DIAL_CONTINUOUS: 38;
/** choice: CAROM_PRECISION_*: the numbers in which contacts are solved */
export const CAROM_DIAL_PRECISION: 39;
/** 2, 4, 6: order of the error of islands that joints alone hold, in 1, 5 or 9 stages a substep, gaps at rounding (odd: the next); above 2 also of bodies that springs, drag and fields alone move; 0: as joints in contact are, under CAROM_INTEGRATOR_RK4 to order 4 */
export const CAROM_DIAL_JOINT_ORDER: 40;
/** m per second of motion: tolerance of places, see accuracy.h; 0: none */
export const CAROM_DIAL_ACCURACY_PLACE: 41;
/** rad per second, likewise */
export const CAROM_DIAL_ACCURACY_TURN: 42;
/** bound of work: substeps of an island in a step */
export const CAROM_DIAL_ACCURACY_SUBSTEPS: 43;
/** likewise of islands in contact: contact points times substeps */
export const CAROM_DIAL_ACCURACY_WORK: 44;
/** m: how far two bodies may move before contact points of theirs that lie in flat faces and edges are looked for anew; meanwhile they stay with the bodies, and separations are off by its square over the smaller radius at most; 0: looked for in each step */
export const CAROM_DIAL_KEEP_DISTANCE: 45;
export const CAROM_DIAL_COUNT: 46;
/** first order */
export const CAROM_INTEGRATOR_EXPLICIT_EULER: 0;
/** first order, symplectic */
export const CAROM_INTEGRATOR_SEMI_IMPLICIT_EULER: 1;
/** fourth order, four evaluations of forces */
export const CAROM_INTEGRATOR_RK4: 2;
/** exact under constant forces, second order under others */
export const CAROM_INTEGRATOR_VELOCITY_VERLET: 3;
/** no gyroscopic term: exact for spheres and cubes only */
export const CAROM_ROTATION_NONE: 0;
/** the term is a torque like any other (RK4 evaluates it four times) */
export const CAROM_ROTATION_EXPLICIT: 1;
/** one Newton step of the implicit term; under RK4 the same as EXPLICIT */
export const CAROM_ROTATION_IMPLICIT: 2;
/** Runge-Kutta on the quaternion */
export const CAROM_ROTATION_RK4: 3;
/** midpoint rule on the rotation group, order 2 */
export const CAROM_ROTATION_LIE_MIDPOINT: 4;
/** three exact turns, order 2, symplectic: energy errs by a bounded amount */
export const CAROM_ROTATION_SPLITTING: 5;
/** five of them (Suzuki) */
export const CAROM_ROTATION_SPLITTING_4: 6;
/** seven of them (Yoshida) */
export const CAROM_ROTATION_SPLITTING_6: 7;
/** most severe contact first, by group: that of the paper of 2011 */
export const CAROM_SOLVER_SEVERITY: 0;
/** one sweep a substep over soft contacts, one that relaxes them: needs about 4 substeps */
export const CAROM_SOLVER_SOFT_STEP: 1;
/** each contact group as one problem, solved to a residual: small hard groups */
export const CAROM_SOLVER_DIRECT: 2;
/** soft_step, but direct for groups that it would not hold; says which and why */
export const CAROM_SOLVER_AUTO: 3;
/** the paper's: scan all contacts of the group for the most severe */
export const CAROM_SEARCH_LINEAR: 0;
/** the same order from a heap */
export const CAROM_SEARCH_HEAP: 1;
/** every bound with every other */
export const CAROM_BROAD_BRUTE_FORCE: 0;
/** sorted axes; the paper's */
export const CAROM_BROAD_SWEEP_AND_PRUNE: 1;
/** cells filled afresh in every step: the same cost however bodies move */
export const CAROM_BROAD_GRID: 2;
/** a tree of fat boxes: what stays about where it was costs next to nothing */
export const CAROM_BROAD_TREE: 3;
/** van den Bergen: GJK on shapes with a margin shell, EPA only for deep contact; the shells make every shape larger by the margin */
export const CAROM_NARROW_HYBRID: 0;
/** GJK on cores, EPA on overlap; exact geometry */
export const CAROM_NARROW_GJK_EPA: 1;
/** Johnson's sub-algorithm, of determinants */
export const CAROM_SIMPLEX_JOHNSON: 0;
/** by Voronoi regions, all features */
export const CAROM_SIMPLEX_VORONOI: 1;
/** only features that touch the newest vertex, all features as a fall-back */
export const CAROM_SIMPLEX_VORONOI_LAST: 2;
/** the deepest point alone */
export const CAROM_MANIFOLD_SINGLE: 0;
/** up to 4 points gathered over steps */
export const CAROM_MANIFOLD_CACHE: 1;
/** up to 4 points of the whole patch at once, probed for by support functions alone */
export const CAROM_MANIFOLD_PATCH: 2;
/** the same, with declared faces (box, polytope) clipped exactly; others probed for */
export const CAROM_MANIFOLD_CLIP: 3;
/** bodies that move farther in a step than they are large may pass through things */
export const CAROM_SWEEP_NONE: 0;
/** bodies of CAROM_CONTINUOUS_ALWAYS */
export const CAROM_SWEEP_FLAGGED: 1;
/** also what moves far for its size in a step */
export const CAROM_SWEEP_FAST: 2;
/** floats */
export const CAROM_PRECISION_FLOAT: 0;
/** floats in steps with 512 pairs in contact or more, where their memory saves time */
export const CAROM_PRECISION_AUTO: 1;
/** presets accurate and reference have it */
export const CAROM_PRECISION_DOUBLE: 2;
/** one substep and coarse distances: crowds, debris, what is seen from afar */
export const CAROM_PRESET_FAST: 0;
/** what a new world has */
export const CAROM_PRESET_BALANCED: 1;
/** a quarter of its error, at two to four times its cost */
export const CAROM_PRESET_ACCURATE: 2;
/** to compare others with: as exact as the library is at a given step */
export const CAROM_PRESET_REFERENCE: 3;
export const CAROM_PRESET_COUNT: 4;
/** any number within its bounds */
export const CAROM_DIAL_KIND_NUMBER: 0;
/** a whole number within its bounds */
export const CAROM_DIAL_KIND_INTEGER: 1;
/** one of its named values */
export const CAROM_DIAL_KIND_CHOICE: 2;
/** outlines of convex shapes: edges of polytopes, three sections' silhouettes of all others */
export const CAROM_DRAW_SHAPES: 1;
/** sides of a mesh's or height field's triangles */
export const CAROM_DRAW_SCENERY: 2;
/** boxes about colliders, along the world's axes; none of half-spaces */
export const CAROM_DRAW_BOUNDS: 4;
/** of the last step: from each point along its normal, `scale` long */
export const CAROM_DRAW_CONTACTS: 8;
/** frames of both ends (x red, y green, z blue), and what is between them */
export const CAROM_DRAW_JOINTS: 16;
/** frames of bodies about their centres of mass */
export const CAROM_DRAW_BODIES: 32;
/** How lines are coloured where their kind does not say: by body type (static grey, kinematic blue, dynamic sand,
 *  asleep dim), or a colour for each island, what hangs together by contacts of the last step and joints. */
export const CAROM_DRAW_BY_TYPE: 0;
/** one colour an island */
export const CAROM_DRAW_BY_ISLAND: 1;
/** what happened */
export const CAROM_LOG_INFO: 1;
/** what may surprise: the call succeeded */
export const CAROM_LOG_WARNING: 2;
/** not used so far: a call that fails says so by its result */
export const CAROM_LOG_ERROR: 3;
/** of carom_world_get_contact_events() */
export const CAROM_EVENTS_CONTACT: 1;
/** of carom_world_get_sensor_events() */
export const CAROM_EVENTS_SENSOR: 2;
/** of carom_world_get_sleep_events() */
export const CAROM_EVENTS_SLEEP: 4;
/** of carom_world_get_joint_events() */
export const CAROM_EVENTS_JOINT: 8;
/** of carom_world_get_fault_events() */
export const CAROM_EVENTS_FAULT: 16;
/** the first step in which the two press on each other */
export const CAROM_CONTACT_BEGIN: 0;
/** the first after that in which they are farther apart than the contact distance, or one of them is gone, filtered out, disabled or in quarantine; point, normal, impulse, speed: 0 */
export const CAROM_CONTACT_END: 1;
/** they press, and approached faster than hit_speed as the step began, or when a sweep met them */
export const CAROM_CONTACT_HIT: 2;
/** the collider begins to overlap the sensor */
export const CAROM_SENSOR_ENTER: 0;
/** it overlaps the sensor no longer */
export const CAROM_SENSOR_LEAVE: 1;
/** the body fell asleep */
export const CAROM_SLEEP_ASLEEP: 0;
/** the body woke */
export const CAROM_SLEEP_AWAKE: 1;
/** `vector` within a box about the frame's origin */
export const CAROM_FORCE_FIELD_UNIFORM: 0;
/** strength (reference / s)^falloff away from the origin; below 0 it attracts */
export const CAROM_FORCE_FIELD_RADIAL: 1;
/** the same about the frame's y axis (right-handed), `pull` towards it, `lift` along it */
export const CAROM_FORCE_FIELD_VORTEX: 2;
/** `vector` in teslas within a box, as UNIFORM: pushes nothing, and turns bodies that have a magnetic moment by T = moment x vector. Second order in the step with velocity_verlet, fourth with rk4; oracle: tests/oracle/test_magnetism */
export const CAROM_FORCE_FIELD_MAGNETIC: 3;
export const CAROM_FORCE_FIELD_COUNT: 4;
/** the points stay together; twist and swing are free */
export const CAROM_JOINT_BALL: 0;
/** so do the x axes; twist is free */
export const CAROM_JOINT_HINGE: 1;
/** the frames stay parallel and B's point on A's x axis; slide is free */
export const CAROM_JOINT_SLIDER: 2;
/** nothing is free */
export const CAROM_JOINT_WELD: 3;
/** the points stay `length` apart: a rod. With a limit a rope, with a spring a spring */
export const CAROM_JOINT_DISTANCE: 4;
/** the points stay together, B's z axis at right angles to A's y axis: a cross of two pins */
export const CAROM_JOINT_UNIVERSAL: 5;
/** a rope from A's point over two anchors to B's, as carom_joint_set_transmission() says; until then it holds nothing. Without a limit the rope neither stretches nor gives way; with one it may be slack */
export const CAROM_JOINT_PULLEY: 6;
/** A's angle about the x axis of its frame, plus `ratio` times B's about its own, stays what it is; each relative to the world, where bearings of their own hold the wheels. Ratio 1 until carom_joint_set_transmission() says another: they turn against each other */
export const CAROM_JOINT_GEAR: 7;
/** each axis free, locked, limited, driven and sprung as carom_joint_set_axis() says; until then all are free */
export const CAROM_JOINT_SIX_AXIS: 8;
/** the coordinate of one joint follows a polynomial of another's, as carom_joint_couple() says, which makes such joints */
export const CAROM_JOINT_COUPLING: 9;
export const CAROM_JOINT_COUNT: 10;
/** rad, of B about the x axes, whole turns counted: ball, hinge */
export const CAROM_COORDINATE_TWIST: 0;
/** rad, [0, pi], between the x axes: ball, universal */
export const CAROM_COORDINATE_SWING: 1;
/** m, of B's point along A's x axis: slider */
export const CAROM_COORDINATE_SLIDE: 2;
/** m, between the points: distance; of the rope, |a - anchor_a| + ratio |b - anchor_b|: pulley */
export const CAROM_COORDINATE_DISTANCE: 3;
export const CAROM_COORDINATE_COUNT: 4;
/** m, B's point along A's x axis */
export const CAROM_AXIS_X: 0;
/** m */
export const CAROM_AXIS_Y: 1;
/** m */
export const CAROM_AXIS_Z: 2;
/** rad, whole turns counted */
export const CAROM_AXIS_TURN_X: 3;
/** rad, likewise */
export const CAROM_AXIS_TURN_Y: 4;
/** rad, likewise */
export const CAROM_AXIS_TURN_Z: 5;
export const CAROM_AXIS_COUNT: 6;
/** no bounds */
export const CAROM_AXIS_MODE_FREE: 0;
/** at `lower` */
export const CAROM_AXIS_MODE_LOCKED: 1;
/** from `lower` to `upper`; where both are the same and the stops hard, it is locked */
export const CAROM_AXIS_MODE_LIMITED: 2;
export const CAROM_AXIS_MODE_COUNT: 3;
/** at nothing: no force */
export const CAROM_DRIVE_NONE: 0;
/** force = stiffness (target - x) + damping (speed - x'), `max_force` at most */
export const CAROM_DRIVE_POSITION: 1;
/** the speed, by whatever force up to `max_force` */
export const CAROM_DRIVE_VELOCITY: 2;
/** a force or torque, `max_force` at most, whatever the motion */
export const CAROM_DRIVE_EFFORT: 3;
export const CAROM_DRIVE_COUNT: 4;
/** Hz and a ratio: force = -m (w^2 x + 2 damping w x'), w = 2 pi stiffness */
export const CAROM_GAINS_FREQUENCY: 0;
/** N/m and N s/m, or N m/rad and N m s/rad: force = -(stiffness x + damping x') */
export const CAROM_GAINS_FORCE: 1;
/** 1/s^2 and 1/s: force = -m (stiffness x + damping x') */
export const CAROM_GAINS_ACCELERATION: 2;
export const CAROM_GAINS_COUNT: 3;
/** position_a and orientation_a are in world coordinates and hold for both bodies as they stand now; those of B are not read */
export const CAROM_JOINT_WORLD_FRAME: 1;
/** the two bodies may touch each other; else they do not */
export const CAROM_JOINT_COLLIDE: 2;
/** length is given; else it is the distance of the points as they stand now */
export const CAROM_JOINT_FIELD_LENGTH: 4;
/** each step measures the joint's accelerations, @see CAROM_JOINT_BULK_ACCELERATION */
export const CAROM_JOINT_ACCELERATIONS: 8;
/** 4: m or rad, by CAROM_COORDINATE_*, as the bodies stand now; read only */
export const CAROM_JOINT_BULK_COORDINATES: 0;
/** 4: m/s or rad/s, their rates, from the present velocities; read only */
export const CAROM_JOINT_BULK_SPEEDS: 1;
/** 6: m and rad, by CAROM_AXIS_*; written: hinge, slider, ball, universal, six-axis */
export const CAROM_JOINT_BULK_AXES: 2;
/** 6: m/s and rad/s, their rates; written likewise */
export const CAROM_JOINT_BULK_AXIS_SPEEDS: 3;
/** 3: N, world, as carom_joint_state.force; read only */
export const CAROM_JOINT_BULK_FORCE: 4;
/** 3: N m, world, as carom_joint_state.torque; read only */
export const CAROM_JOINT_BULK_TORQUE: 5;
/** 2: m and rad, gap and angle; read only */
export const CAROM_JOINT_BULK_ERROR: 6;
/** 1: 1 or 0; read only */
export const CAROM_JOINT_BULK_BROKEN: 7;
/** 1: m or rad, of one motion, whole turns counted; written: hinge, slider */
export const CAROM_JOINT_BULK_POSITION: 8;
/** 1: m/s or rad/s, of one motion; written likewise */
export const CAROM_JOINT_BULK_VELOCITY: 9;
/** 1: N or N m, borne along one motion, mean over the last step; read only */
export const CAROM_JOINT_BULK_EFFORT: 10;
/** 1: m or rad, of one motion: its spring's */
export const CAROM_JOINT_BULK_TARGET: 11;
/** 1: m/s or rad/s, of one motion: its motor's speed */
export const CAROM_JOINT_BULK_TARGET_VELOCITY: 12;
/** 1: N or N m, [-1e30, 1e30], of one motion: its motor's force */
export const CAROM_JOINT_BULK_TARGET_EFFORT: 13;
/** 3: enabled, speed, max_force, as carom_joint_motor; of one motion */
export const CAROM_JOINT_BULK_MOTOR: 14;
/** 5: enabled, target, frequency, damping, max_force; of one motion */
export const CAROM_JOINT_BULK_SPRING: 15;
/** 3: enabled, lower, upper; of one motion */
export const CAROM_JOINT_BULK_LIMIT: 16;
/** 6: N and N m, FORCE and TORQUE in A's frame; of any kind, read only */
export const CAROM_JOINT_BULK_AXIS_EFFORTS: 17;
/** 6: target of each axis of a six-axis joint, as carom_joint_axis */
export const CAROM_JOINT_BULK_AXIS_TARGETS: 18;
/** 6: speed, likewise */
export const CAROM_JOINT_BULK_AXIS_TARGET_VELOCITIES: 19;
/** 6: effort, likewise */
export const CAROM_JOINT_BULK_AXIS_TARGET_EFFORTS: 20;
/** 6: max_force, likewise */
export const CAROM_JOINT_BULK_AXIS_MAX_FORCES: 21;
/** 12: drive_stiffness and drive_damping of each axis, in its units */
export const CAROM_JOINT_BULK_AXIS_GAINS: 22;
/** 12: lower and upper of each axis */
export const CAROM_JOINT_BULK_AXIS_LIMITS: 23;
/** 4: x, y, z, w, of the drive to an orientation: ball, six-axis */
export const CAROM_JOINT_BULK_ORIENTATION_TARGET: 24;
/** 3: rad/s, A's frame, likewise */
export const CAROM_JOINT_BULK_ORIENTATION_VELOCITY: 25;
/** 3: N m, A's frame, likewise */
export const CAROM_JOINT_BULK_ORIENTATION_EFFORT: 26;
/** 2: stiffness, damping, likewise */
export const CAROM_JOINT_BULK_ORIENTATION_GAINS: 27;
/** 1: m/s^2 or rad/s^2, of a hinge or slider; read only */
export const CAROM_JOINT_BULK_ACCELERATION: 28;
/** 6: by CAROM_AXIS_*, of any kind; read only. Both of joints with CAROM_JOINT_ACCELERATIONS */
export const CAROM_JOINT_BULK_AXIS_ACCELERATIONS: 29;
/** 6: friction of each axis of a six-axis joint, as carom_joint_axis */
export const CAROM_JOINT_BULK_AXIS_FRICTIONS: 30;
/** 6: armature, likewise */
export const CAROM_JOINT_BULK_AXIS_ARMATURES: 31;
/** 6: effort_limit, likewise */
export const CAROM_JOINT_BULK_AXIS_EFFORT_LIMITS: 32;
/** 6: speed_limit, likewise */
export const CAROM_JOINT_BULK_AXIS_SPEED_LIMITS: 33;
/** 1: friction of the axis of a hinge or slider, as carom_joint_axis */
export const CAROM_JOINT_BULK_FRICTION: 34;
/** 1: armature, likewise */
export const CAROM_JOINT_BULK_ARMATURE: 35;
/** 1: effort_limit, likewise */
export const CAROM_JOINT_BULK_EFFORT_LIMIT: 36;
/** 1: speed_limit, likewise */
export const CAROM_JOINT_BULK_SPEED_LIMIT: 37;
/** 1: target of the drive of a hinge's or slider's axis, likewise: a servo's */
export const CAROM_JOINT_BULK_DRIVE_TARGET: 38;
/** 1: speed, likewise */
export const CAROM_JOINT_BULK_DRIVE_VELOCITY: 39;
/** 1: effort, likewise */
export const CAROM_JOINT_BULK_DRIVE_EFFORT: 40;
/** 1: max_force, likewise */
export const CAROM_JOINT_BULK_DRIVE_MAX_FORCE: 41;
/** 2: drive_stiffness and drive_damping, in its units, likewise */
export const CAROM_JOINT_BULK_DRIVE_GAINS: 42;
export const CAROM_JOINT_BULK_COUNT: 43;
/** gyroscopic term of bodies with unlike moments of inertia */
export const CAROM_EFFECT_GYROSCOPIC: 0;
/** damping of velocity */
export const CAROM_EFFECT_LINEAR_DAMPING: 1;
/** damping of rotation */
export const CAROM_EFFECT_ANGULAR_DAMPING: 2;
/** the world's gravity */
export const CAROM_EFFECT_GRAVITY: 3;
/** forces of the host, at the centre of mass or elsewhere */
export const CAROM_EFFECT_USER_FORCE: 4;
/** torques of the host */
export const CAROM_EFFECT_USER_TORQUE: 5;
/** the search for contacts */
export const CAROM_EFFECT_COLLISION: 6;
/** friction at contacts */
export const CAROM_EFFECT_FRICTION: 7;
/** bounces */
export const CAROM_EFFECT_RESTITUTION: 8;
/** resistance of contacts to rolling */
export const CAROM_EFFECT_ROLLING_RESISTANCE: 9;
/** resistance of contacts to spinning about the normal */
export const CAROM_EFFECT_SPINNING_RESISTANCE: 10;
/** islands at rest are not stepped */
export const CAROM_EFFECT_SLEEP: 11;
/** sets of particles */
export const CAROM_EFFECT_PARTICLES: 12;
/** categories, masks and groups of colliders */
export const CAROM_EFFECT_FILTER: 13;
/** colliders that only report what overlaps them */
export const CAROM_EFFECT_SENSOR: 14;
/** joints: what they lock */
export const CAROM_EFFECT_JOINTS: 15;
/** meshes and height fields */
export const CAROM_EFFECT_SCENERY: 16;
/** fast bodies are swept */
export const CAROM_EFFECT_CONTINUOUS: 17;
/** surfaces that move: conveyors */
export const CAROM_EFFECT_SURFACE_VELOCITY: 18;
/** locked axes of bodies */
export const CAROM_EFFECT_AXIS_LOCKS: 19;
/** drag of bodies */
export const CAROM_EFFECT_DRAG: 20;
/** wind on bodies with drag */
export const CAROM_EFFECT_WIND: 21;
/** force fields */
export const CAROM_EFFECT_FIELDS: 22;
/** springs between bodies */
export const CAROM_EFFECT_SPRINGS: 23;
/** water */
export const CAROM_EFFECT_BUOYANCY: 24;
/** what contacts do: without it bodies pass through each other, and there are no contact points */
export const CAROM_EFFECT_RESPONSE: 25;
/** limits of joints */
export const CAROM_EFFECT_JOINT_LIMITS: 26;
/** motors and springs of joints */
export const CAROM_EFFECT_JOINT_MOTORS: 27;
/** events that a host collects */
export const CAROM_EFFECT_EVENTS: 28;
/** accounts of energy and momentum */
export const CAROM_EFFECT_LEDGER: 29;
/** magnetic moments in magnetic fields */
export const CAROM_EFFECT_MAGNETISM: 30;
export const CAROM_EFFECT_COUNT: 31;
/** it runs for the bodies that need it (default) */
export const CAROM_MODE_AS_NEEDED: 0;
/** it does not run */
export const CAROM_MODE_FORBID: 1;
/** it runs for all bodies that it can act on, whether they need it or not: to see what it costs, and that it changes nothing. It makes no joints, sets, ... where there are none */
export const CAROM_MODE_FORCE: 2;
/** the line is a stage */
export const CAROM_PLAN_NO_EFFECT: 4294967295;
/** seconds is its own */
export const CAROM_TIME_OWN: 0;
/** it is done within the loops of its stage, and in the time of that */
export const CAROM_TIME_IN_STAGE: 1;
/** not measured, see carom_world_time_effects() */
export const CAROM_TIME_OFF: 2;
/** a plugin with another one is refused */
export const CAROM_PLUGIN_ABI_MAJOR: 1;
/** grows with additions */
export const CAROM_PLUGIN_ABI_MINOR: 0;
/** nothing declared */
export const CAROM_FORM_NONE: 0;
/** centre at the origin; arg[0]: radius */
export const CAROM_FORM_SPHERE: 1;
/** axis y; arg[0]: radius, arg[1]: half height of the core segment */
export const CAROM_FORM_CAPSULE: 2;
/** centred, axis-aligned; arg[0..2]: half extents x, y, z */
export const CAROM_FORM_BOX: 3;
/** hull of points; arg[0]: index of the first coordinate; the rest of params are x,y,z triples */
export const CAROM_FORM_POLYTOPE: 4;
/** axis y, centred; arg[0]: radius, arg[1]: half height */
export const CAROM_FORM_CYLINDER: 5;
/** axis y, apex at +half height, base disc at -half height; arg[0]: base radius, arg[1]: half height */
export const CAROM_FORM_CONE: 6;
/** centred, axis-aligned; arg[0..2]: radii x, y, z */
export const CAROM_FORM_ELLIPSOID: 7;
/** In place of an index into params: no parameter. A geometry must write it for core_radius_param where there is no
 *  core radius, since 0 there is the first parameter. In form_arg and mass_arg it marks places that the form does not
 *  use; those are not read, so 0 does as well. Where the form needs an index, it is refused (PLUGIN_ABI). */
export const CAROM_NO_PARAM: 4294967295;
/** flags: support may only be called on the thread that steps (scripting hosts) */
export const CAROM_PLUGIN_HOST_THREAD: 1;
/** The symbol looked up in a shared object. */
export const CAROM_SHAPE_PLUGIN_SYMBOL: "carom_shape_plugin_v1";
/** the bracket is as narrow as the tolerance wants */
export const CAROM_QUERY_EXACT_ENOUGH: 0;
/** the iteration cap came first; the bracket still holds */
export const CAROM_QUERY_CAPPED: 1;
/** rounding stopped it; the bracket still holds */
export const CAROM_QUERY_ROUNDING: 2;
/** a support function misbehaved; nothing else is meaningful */
export const CAROM_QUERY_FAULT: 3;
/** the hash after each step */
export const CAROM_RECORD_HASHES: 0;
/** and the state (CAROM_SNAPSHOT_STATE), so that a replay can name a body or a pair */
export const CAROM_RECORD_STATES: 1;
/** a bit of flags: met from both sides */
export const CAROM_SCENERY_TWO_SIDED: 1;
/** all but the structure */
export const CAROM_SNAPSHOT_STATE: 0;
/** the structure, too */
export const CAROM_SNAPSHOT_WHOLE: 1;
/** it chooses among forward gears; the input's gear says which way, or neutral */
export const CAROM_VEHICLE_AUTOMATIC: 1;
/** steered wheels share one centre of turn with those that are not steered */
export const CAROM_VEHICLE_ACKERMANN: 2;
/** the most wheels of a vehicle */
export const CAROM_VEHICLE_WHEELS: 16;
/** in place of an index: no wheel */
export const CAROM_NO_WHEEL: 4294967295;
/** which effects have participants; bounds */
export const CAROM_STAGE_REFRESH: 0;
/** pairs of bounds that overlap */
export const CAROM_STAGE_BROAD: 1;
/** contacts of pairs */
export const CAROM_STAGE_NARROW: 2;
/** contact groups */
export const CAROM_STAGE_GROUP: 3;
/** forces, velocities, positions */
export const CAROM_STAGE_INTEGRATE: 4;
/** velocities at contacts */
export const CAROM_STAGE_SOLVE: 5;
/** penetration at contacts */
export const CAROM_STAGE_RELAX: 6;
/** residuals, events */
export const CAROM_STAGE_OBSERVE: 7;
export const CAROM_STAGE_COUNT: 8;
/** soft contacts hold it */
export const CAROM_REASON_ORDINARY: 0;
/** bodies that touch have masses further apart than CAROM_DIAL_DIRECT_RATIO */
export const CAROM_REASON_MASS_RATIO: 1;
/** soft contacts would let it sink by more than CAROM_DIAL_DIRECT_SINK, or did before it lay still */
export const CAROM_REASON_SINK: 2;
/** too many bodies for the direct solver, or it exceeded its work limit recently */
export const CAROM_REASON_TOO_MUCH: 3;
/** it would sink, but is under impact: soft contacts take that */
export const CAROM_REASON_IMPACT: 4;
/** so few bodies that they are solved directly, whatever they do */
export const CAROM_REASON_FEW: 5;
/** the support function returned nonzero */
export const CAROM_FAULT_RETURNED: 1;
/** it gave NaN or infinity */
export const CAROM_FAULT_NOT_FINITE: 2;
/** a point outside the shape's bounding radius */
export const CAROM_FAULT_OUTSIDE: 3;
/** a point worse than one it had given before */
export const CAROM_FAULT_NOT_SUPPORT: 4;
/** a body's state was not finite; the body is quarantined */
export const CAROM_FAULT_BODY_STATE: 5;
/** likewise particles', see carom_particles_get_quarantined() */
export const CAROM_FAULT_PARTICLE_STATE: 6;
/** what is met first */
export const CAROM_WANT_FIRST: 0;
/** whether anything is met: HIT, UNDECIDED (only grazes) or MISS; no collider, times or points */
export const CAROM_WANT_ANY: 1;
/** Kinds of joints by name. */
export const JOINTS: { ball: 0, hinge: 1, slider: 2, weld: 3, distance: 4, universal: 5, pulley: 6, gear: 7, six_axis: 8, coupling: 9 };
