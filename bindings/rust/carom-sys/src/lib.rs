//! All of include/carom under its own names. Written by bindings/gen/generate from include/carom; do not edit.
#![no_std]
#![allow(non_camel_case_types, rustdoc::broken_intra_doc_links, rustdoc::invalid_html_tags)]
use core::ffi::{c_char, c_void};
use core::mem::{offset_of, size_of, zeroed};

pub const VERSION: &str = "0.9.0";
pub const SONAME: &str = "libcarom.so.0.9";
/// of these headers
pub const CAROM_VERSION_MAJOR: u32 = 0;
/// of these headers
pub const CAROM_VERSION_MINOR: u32 = 9;
/// of these headers
pub const CAROM_VERSION_PATCH: u32 = 0;
/// the call did what it says
pub const CAROM_OK: i32 = 0;
/// a required pointer is NULL
pub const CAROM_E_NULL_ARGUMENT: i32 = -1;
/// a number is NaN or infinite
pub const CAROM_E_NOT_FINITE: i32 = -2;
/// a number is finite but outside its documented bounds
pub const CAROM_E_OUT_OF_RANGE: i32 = -3;
/// a quaternion or normal is further than 1e-6 from unit length
pub const CAROM_E_NOT_UNIT: i32 = -4;
/// an enumeration value this library does not know
pub const CAROM_E_UNKNOWN_ENUM: i32 = -5;
/// struct_size is smaller than the smallest version of the struct
pub const CAROM_E_STRUCT_SIZE: i32 = -6;
/// the request comes from a newer header, or asks for what this build cannot do
pub const CAROM_E_UNSUPPORTED: i32 = -7;
/// the handle was never issued
pub const CAROM_E_INVALID_HANDLE: i32 = -8;
/// the object behind the handle was destroyed
pub const CAROM_E_STALE_HANDLE: i32 = -9;
/// a handle of another kind (a shape where a body is wanted, ...)
pub const CAROM_E_WRONG_KIND: i32 = -10;
/// a handle of another world or engine
pub const CAROM_E_WRONG_WORLD: i32 = -11;
/// another thread is stepping, changing or reading this world
pub const CAROM_E_BUSY: i32 = -12;
/// called from inside a callback (a support function, allocator or log)
pub const CAROM_E_REENTRANT: i32 = -13;
/// the object is still referred to by others
pub const CAROM_E_IN_USE: i32 = -14;
/// the allocator returned NULL
pub const CAROM_E_OUT_OF_MEMORY: i32 = -15;
/// a hard limit of the library is reached
pub const CAROM_E_LIMIT: i32 = -16;
/// stride or capacity does not hold one element
pub const CAROM_E_BUFFER_TOO_SMALL: i32 = -17;
/// the path is not absolute, or nothing readable is there
pub const CAROM_E_PLUGIN_PATH: i32 = -18;
/// the dynamic loader refused the file, or the entry symbol is missing
pub const CAROM_E_PLUGIN_LOAD: i32 = -19;
/// the plugin was built against an incompatible plugin.h
pub const CAROM_E_PLUGIN_ABI: i32 = -20;
/// the support function is not one of a bounded convex set; see the witness
pub const CAROM_E_PLUGIN_INVALID: i32 = -21;
/// a declaration disagrees with the support function; see the witness
pub const CAROM_E_DECLARATION_FALSE: i32 = -22;
/// the body is flat, so no mass follows from a density
pub const CAROM_E_NO_VOLUME: i32 = -23;
/// a plugin with this id is already loaded
pub const CAROM_E_ALREADY_EXISTS: i32 = -24;
/// no object of this name
pub const CAROM_E_NOT_FOUND: i32 = -25;
/// a fault of the library itself; please report it
pub const CAROM_E_INTERNAL: i32 = -26;
/// bytes that are damaged, cut off or no snapshot
pub const CAROM_E_CORRUPT: i32 = -27;
/// a snapshot of a world with other things in it
pub const CAROM_E_MISMATCH: i32 = -28;
/// a function that the host gave to write with said that it failed
pub const CAROM_E_WRITE_FAILED: i32 = -29;
/// a number of the library that is fixed, no dial
pub const CAROM_E_READ_ONLY: i32 = -30;
/// no object: never the handle of one
pub const CAROM_NULL_HANDLE: u64 = 0;
/// float, 4 bytes
pub const CAROM_SCALAR_F32: u32 = 0;
/// double, 8 bytes
pub const CAROM_SCALAR_F64: u32 = 1;
/// its error was estimated in this step, else in one before
pub const CAROM_ISLAND_ESTIMATED: u32 = 1;
/// the bound of work was reached: its error is over the tolerance
pub const CAROM_ISLAND_BOUND: u32 = 2;
/// joints alone hold it: its error is of order 2, 4 or 6
pub const CAROM_ISLAND_JOINTS_ALONE: u32 = 4;
/// more substeps do not lessen its error, which is over the tolerance: contacts, mostly
pub const CAROM_ISLAND_STALLED: u32 = 8;
/// bodies: one CAROM_FIELD_*
pub const CAROM_COLUMN_BODIES: u32 = 0;
/// joints: one CAROM_JOINT_BULK_*
pub const CAROM_COLUMN_JOINTS: u32 = 1;
/// dynamic bodies: 1, kg; writing scales the inertia alike, the centre stays
pub const CAROM_COLUMN_MASSES: u32 = 2;
/// materials: 2, friction and restitution
pub const CAROM_COLUMN_MATERIALS: u32 = 3;
/// the world, n is 1: 3, m/s^2
pub const CAROM_COLUMN_GRAVITY: u32 = 4;
/// the world, n is 1: 1, s, simulated; read only
pub const CAROM_COLUMN_TIME: u32 = 5;
/// bodies: 3, N, world: normal forces on it, mean of the last step; read only
pub const CAROM_COLUMN_CONTACT_FORCES: u32 = 6;
/// bodies or the world: 1, how far along a ray something is met first, in parts of `direction`, `max` where nothing is; read only
pub const CAROM_COLUMN_RAYS: u32 = 7;
pub const CAROM_COLUMN_COUNT: u32 = 8;
/// by carom_batch_read() and carom_batch_write()
pub const CAROM_WHEN_ON_CALL: u32 = 0;
/// written before each step, too
pub const CAROM_WHEN_BEFORE_STEP: u32 = 1;
/// read after each step, too, and after calls that change worlds
pub const CAROM_WHEN_AFTER_STEP: u32 = 2;
pub const CAROM_WHEN_COUNT: u32 = 3;
/// it steps
pub const CAROM_STOPPED_NO: u32 = 0;
/// a step had faults: carom_batch_get_faults()
pub const CAROM_STOPPED_FAULT: u32 = 1;
/// there was no memory for a step: it is as before that
pub const CAROM_STOPPED_MEMORY: u32 = 2;
/// in [0, 1)
pub const CAROM_RANDOM_UNIFORM: u32 = 0;
/// mean 0, deviation 1
pub const CAROM_RANDOM_NORMAL: u32 = 1;
pub const CAROM_RANDOM_COUNT: u32 = 2;
/// root of a b
pub const CAROM_MIX_GEOMETRIC_MEAN: u32 = 0;
/// the larger
pub const CAROM_MIX_MAXIMUM: u32 = 1;
/// the smaller
pub const CAROM_MIX_MINIMUM: u32 = 2;
/// (a + b) / 2
pub const CAROM_MIX_AVERAGE: u32 = 3;
/// a b
pub const CAROM_MIX_MULTIPLY: u32 = 4;
/// never moves
pub const CAROM_BODY_STATIC: u32 = 0;
/// moved by its velocity; infinite mass
pub const CAROM_BODY_KINEMATIC: u32 = 1;
/// moved by forces, contacts and joints
pub const CAROM_BODY_DYNAMIC: u32 = 2;
/// mass given; else from colliders' densities
pub const CAROM_BODY_FIELD_MASS: u32 = 1;
/// center given; else from colliders. needs MASS
pub const CAROM_BODY_FIELD_CENTER: u32 = 2;
/// inertia given; else from colliders, scaled to mass. needs MASS
pub const CAROM_BODY_FIELD_INERTIA: u32 = 4;
/// it never falls asleep, nor does what it touches
pub const CAROM_BODY_STAYS_AWAKE: u32 = 8;
/// it takes no part in steps, see carom_body_set_enabled()
pub const CAROM_BODY_DISABLED: u32 = 16;
/// its centre of mass keeps its world x
pub const CAROM_LOCK_LINEAR_X: u32 = 1;
/// likewise its y
pub const CAROM_LOCK_LINEAR_Y: u32 = 2;
/// likewise its z
pub const CAROM_LOCK_LINEAR_Z: u32 = 4;
/// it does not turn about the world's x axis
pub const CAROM_LOCK_ANGULAR_X: u32 = 8;
/// likewise about y
pub const CAROM_LOCK_ANGULAR_Y: u32 = 16;
/// likewise about z
pub const CAROM_LOCK_ANGULAR_Z: u32 = 32;
/// it keeps its pose
pub const CAROM_LOCK_ALL: u32 = 63;
/// LINEAR_Z, ANGULAR_X, ANGULAR_Y: a body of a flat world, the plane of x and y
pub const CAROM_LOCK_PLANE: u32 = 28;
/// carom_body_set_gravity_factor()
pub const CAROM_ATTRIBUTE_GRAVITY_FACTOR: u32 = 0;
/// carom_body_set_locks(); as the host gave them, whether or not they are forbidden
pub const CAROM_ATTRIBUTE_LOCKS: u32 = 1;
/// carom_body_set_drag(): linear, quadratic
pub const CAROM_ATTRIBUTE_DRAG: u32 = 2;
/// carom_body_set_force_field_mask()
pub const CAROM_ATTRIBUTE_FORCE_FIELD_MASK: u32 = 3;
/// A m^2, axes of the body: magnetic fields turn it, see CAROM_FORCE_FIELD_MAGNETIC
pub const CAROM_ATTRIBUTE_MAGNETIC_MOMENT: u32 = 4;
pub const CAROM_ATTRIBUTE_COUNT: u32 = 5;
/// the most that an attribute can have
pub const CAROM_ATTRIBUTE_NUMBERS: u32 = 4;
/// in steps in which it is fast for its size (default)
pub const CAROM_CONTINUOUS_AUTO: u32 = 0;
/// in every step
pub const CAROM_CONTINUOUS_ALWAYS: u32 = 1;
/// in none: cheap debris that may pass through walls
pub const CAROM_CONTINUOUS_NEVER: u32 = 2;
/// default category, see carom_collider_set_filter()
pub const CAROM_FILTER_CATEGORY: u64 = 1;
/// default mask
pub const CAROM_FILTER_MASK: u64 = 18446744073709551615;
/// 3: m, world, origin of the body frame
pub const CAROM_FIELD_POSITION: u32 = 0;
/// 4: x, y, z, w
pub const CAROM_FIELD_ORIENTATION: u32 = 1;
/// 7: position, orientation
pub const CAROM_FIELD_POSE: u32 = 2;
/// 3: m/s, world, of the centre of mass
pub const CAROM_FIELD_LINEAR_VELOCITY: u32 = 3;
/// 3: rad/s, world
pub const CAROM_FIELD_ANGULAR_VELOCITY: u32 = 4;
/// 6: linear, angular
pub const CAROM_FIELD_VELOCITY: u32 = 5;
/// 6: N and N m, world, pending for the next step; writing replaces it
pub const CAROM_FIELD_FORCE: u32 = 6;
/// 3: m, world, centre of mass; read only
pub const CAROM_FIELD_CENTER: u32 = 7;
/// 1: kg; read only
pub const CAROM_FIELD_MASS: u32 = 8;
pub const CAROM_FIELD_COUNT: u32 = 9;
/// no contact within the motion, proven
pub const CAROM_CAST_MISS: u32 = 0;
/// contact begins within the motion
pub const CAROM_CAST_HIT: u32 = 1;
/// one is in the other already at the start: time 0
pub const CAROM_CAST_OVERLAP: u32 = 2;
/// the cap came first, or numbers are too large: neither was proven. `lower` holds
pub const CAROM_CAST_UNDECIDED: u32 = 3;
/// of a batch: this ray is not finite, or its max is negative; it was not cast
pub const CAROM_CAST_BAD_RAY: u32 = 4;
/// support functions only, no routine for declared forms
pub const CAROM_ASK_GENERIC: u32 = 1;
/// sensors are found, too; of a world only
pub const CAROM_ASK_SENSORS: u32 = 2;
/// What a ray or a shape touches or overlaps at its start is passed over: that collider. Of a mesh or height field it
/// is each triangle touched, and for a shape each other one that the motion does not go into. Overlaps and the nearest
/// do not use it.
pub const CAROM_ASK_IGNORE_TOUCHED: u32 = 4;
/// proven by `normal`: along it the shapes are at least separation_bound apart
pub const CAROM_OVERLAP_APART: u32 = 0;
/// proven by `point`, which is in both
pub const CAROM_OVERLAP_OVERLAPPING: u32 = 1;
/// within rounding (slack) of touching, or the cap came first: neither was proven
pub const CAROM_OVERLAP_TOUCHING: u32 = 2;
/// a support function misbehaved; nothing else is meaningful
pub const CAROM_OVERLAP_FAULT: u32 = 3;
/// in place of an index: no shape
pub const CAROM_NO_SHAPE: u32 = 4294967295;
/// nothing is under it: it falls
pub const CAROM_GROUND_AIR: u32 = 0;
/// it touches ground steeper than max_slope: it slides down without friction
pub const CAROM_GROUND_STEEP: u32 = 1;
/// it stands, and can walk and jump
pub const CAROM_GROUND_FIRM: u32 = 2;
/// its orientation turns about `up` with the ground that it rides
pub const CAROM_CHARACTER_TURNS: u32 = 1;
/// no gravity, no steps, no ground: it moves along all of `walk`, as swimmers do
pub const CAROM_CHARACTER_FLIES: u32 = 2;
/// contacts that a move keeps: of more, the first
pub const CAROM_CHARACTER_CONTACTS: u32 = 8;
/// choice: CAROM_INTEGRATOR_*
pub const CAROM_DIAL_INTEGRATOR: u32 = 0;
/// choice: CAROM_ROTATION_*: how bodies with unlike moments of inertia spin
pub const CAROM_DIAL_ROTATION: u32 = 1;
/// integrate-and-solve passes per step
pub const CAROM_DIAL_SUBSTEPS: u32 = 2;
/// choice: CAROM_SOLVER_*
pub const CAROM_DIAL_SOLVER: u32 = 3;
/// severity: at most this many impulses per contact of a group and substep
pub const CAROM_DIAL_VELOCITY_ITERATIONS: u32 = 4;
/// severity: at most this many position corrections per contact of a group and substep; 0: none, under direct, too
pub const CAROM_DIAL_POSITION_ITERATIONS: u32 = 5;
/// m/s: velocity error left unresolved at a contact
pub const CAROM_DIAL_VELOCITY_TOLERANCE: u32 = 6;
/// m: penetration left unresolved; of what is thin at most 2 % of its thickness
pub const CAROM_DIAL_POSITION_TOLERANCE: u32 = 7;
/// m/s: below this approach speed a contact does not bounce
pub const CAROM_DIAL_RESTITUTION_SPEED: u32 = 8;
/// choice: CAROM_SEARCH_*
pub const CAROM_DIAL_SEVERITY_SEARCH: u32 = 9;
/// choice: 0 one group for all contacts, 1 contact groups (islands)
pub const CAROM_DIAL_GROUPS: u32 = 10;
/// choice: CAROM_BROAD_*
pub const CAROM_DIAL_BROAD_PHASE: u32 = 11;
/// m: cell size of the uniform grid; 0: chosen from the scene
pub const CAROM_DIAL_GRID_CELL: u32 = 12;
/// m: pairs nearer than this make contacts
pub const CAROM_DIAL_CONTACT_DISTANCE: u32 = 13;
/// choice: 0 generic path for every pair, 1 specific routines where declared
pub const CAROM_DIAL_PAIR_ROUTINES: u32 = 14;
/// choice: CAROM_NARROW_* for the generic path
pub const CAROM_DIAL_NARROW_PHASE: u32 = 15;
/// choice: CAROM_SIMPLEX_*
pub const CAROM_DIAL_SIMPLEX: u32 = 16;
/// relative width of the bracket at which GJK and EPA stop
pub const CAROM_DIAL_GJK_TOLERANCE: u32 = 17;
/// cap
pub const CAROM_DIAL_GJK_ITERATIONS: u32 = 18;
/// cap
pub const CAROM_DIAL_EPA_ITERATIONS: u32 = 19;
/// m: shell around each shape in CAROM_NARROW_HYBRID
pub const CAROM_DIAL_HYBRID_MARGIN: u32 = 20;
/// choice: 0 start each query afresh, 1 start from the last separating vector
pub const CAROM_DIAL_WARM_SEPARATION: u32 = 21;
/// choice: CAROM_MANIFOLD_*
pub const CAROM_DIAL_MANIFOLD: u32 = 22;
/// m: a cached point is dropped when it drifted further than this
pub const CAROM_DIAL_CACHE_DISTANCE: u32 = 23;
/// choice: 0 solve each step from zero, 1 start from the last step's impulses
pub const CAROM_DIAL_WARM_START: u32 = 24;
/// relative width up to which an earlier bracket, widened by the motion since, stands in for a query of the generic path; 0: off
pub const CAROM_DIAL_CARRY_OVER: u32 = 25;
/// Hz: stiffness of soft contacts; what is thin has stiffer ones, and sinks by 0.1 % of its thickness under its own weight
pub const CAROM_DIAL_CONTACT_FREQUENCY: u32 = 26;
/// damping ratio of soft contacts
pub const CAROM_DIAL_CONTACT_DAMPING: u32 = 27;
/// m/s: overlap of a contact is undone at this speed at most (soft, direct)
pub const CAROM_DIAL_PUSH_SPEED: u32 = 28;
/// choice: 0 everything is simulated, 1 islands that came to rest sleep until something touches them; see carom_body_is_asleep()
pub const CAROM_DIAL_SLEEP: u32 = 29;
/// m/s: no point of a body that falls asleep moves faster
pub const CAROM_DIAL_SLEEP_SPEED: u32 = 30;
/// s: for how long it has been so
pub const CAROM_DIAL_SLEEP_TIME: u32 = 31;
/// CAROM_SOLVER_AUTO solves groups directly that would sink by more of their thickness
pub const CAROM_DIAL_DIRECT_SINK: u32 = 32;
/// or where touching bodies' masses are further apart than this
pub const CAROM_DIAL_DIRECT_RATIO: u32 = 33;
/// unless they take more block products a step than this
pub const CAROM_DIAL_DIRECT_WORK: u32 = 34;
/// rad: arms of contacts turn with a body only when it has turned by this
pub const CAROM_DIAL_HOLD_ANGLE: u32 = 35;
/// Hz: stiffness of joints that the direct solver does not solve
pub const CAROM_DIAL_JOINT_FREQUENCY: u32 = 36;
/// their damping ratio
pub const CAROM_DIAL_JOINT_DAMPING: u32 = 37;
/// choice: CAROM_SWEEP_*: what is swept from pose to pose, so that it passes through nothing; see carom_body_set_continuous()
pub const CAROM_DIAL_CONTINUOUS: u32 = 38;
/// choice: CAROM_PRECISION_*: the numbers in which contacts are solved
pub const CAROM_DIAL_PRECISION: u32 = 39;
/// 2, 4, 6: order of the error of islands that joints alone hold, in 1, 5 or 9 stages a substep, gaps at rounding (odd: the next); above 2 also of bodies that springs, drag and fields alone move; 0: as joints in contact are, under CAROM_INTEGRATOR_RK4 to order 4
pub const CAROM_DIAL_JOINT_ORDER: u32 = 40;
/// m per second of motion: tolerance of places, see accuracy.h; 0: none
pub const CAROM_DIAL_ACCURACY_PLACE: u32 = 41;
/// rad per second, likewise
pub const CAROM_DIAL_ACCURACY_TURN: u32 = 42;
/// bound of work: substeps of an island in a step
pub const CAROM_DIAL_ACCURACY_SUBSTEPS: u32 = 43;
/// likewise of islands in contact: contact points times substeps
pub const CAROM_DIAL_ACCURACY_WORK: u32 = 44;
/// m: how far two bodies may move before contact points of theirs that lie in flat faces and edges are looked for anew; meanwhile they stay with the bodies, and separations are off by its square over the smaller radius at most; 0: looked for in each step
pub const CAROM_DIAL_KEEP_DISTANCE: u32 = 45;
pub const CAROM_DIAL_COUNT: u32 = 46;
/// first order
pub const CAROM_INTEGRATOR_EXPLICIT_EULER: u32 = 0;
/// first order, symplectic
pub const CAROM_INTEGRATOR_SEMI_IMPLICIT_EULER: u32 = 1;
/// fourth order, four evaluations of forces
pub const CAROM_INTEGRATOR_RK4: u32 = 2;
/// exact under constant forces, second order under others
pub const CAROM_INTEGRATOR_VELOCITY_VERLET: u32 = 3;
/// no gyroscopic term: exact for spheres and cubes only
pub const CAROM_ROTATION_NONE: u32 = 0;
/// the term is a torque like any other (RK4 evaluates it four times)
pub const CAROM_ROTATION_EXPLICIT: u32 = 1;
/// one Newton step of the implicit term; under RK4 the same as EXPLICIT
pub const CAROM_ROTATION_IMPLICIT: u32 = 2;
/// Runge-Kutta on the quaternion
pub const CAROM_ROTATION_RK4: u32 = 3;
/// midpoint rule on the rotation group, order 2
pub const CAROM_ROTATION_LIE_MIDPOINT: u32 = 4;
/// three exact turns, order 2, symplectic: energy errs by a bounded amount
pub const CAROM_ROTATION_SPLITTING: u32 = 5;
/// five of them (Suzuki)
pub const CAROM_ROTATION_SPLITTING_4: u32 = 6;
/// seven of them (Yoshida)
pub const CAROM_ROTATION_SPLITTING_6: u32 = 7;
/// most severe contact first, by group: that of the paper of 2011
pub const CAROM_SOLVER_SEVERITY: u32 = 0;
/// one sweep a substep over soft contacts, one that relaxes them: needs about 4 substeps
pub const CAROM_SOLVER_SOFT_STEP: u32 = 1;
/// each contact group as one problem, solved to a residual: small hard groups
pub const CAROM_SOLVER_DIRECT: u32 = 2;
/// soft_step, but direct for groups that it would not hold; says which and why
pub const CAROM_SOLVER_AUTO: u32 = 3;
/// the paper's: scan all contacts of the group for the most severe
pub const CAROM_SEARCH_LINEAR: u32 = 0;
/// the same order from a heap
pub const CAROM_SEARCH_HEAP: u32 = 1;
/// every bound with every other
pub const CAROM_BROAD_BRUTE_FORCE: u32 = 0;
/// sorted axes; the paper's
pub const CAROM_BROAD_SWEEP_AND_PRUNE: u32 = 1;
/// cells filled afresh in every step: the same cost however bodies move
pub const CAROM_BROAD_GRID: u32 = 2;
/// a tree of fat boxes: what stays about where it was costs next to nothing
pub const CAROM_BROAD_TREE: u32 = 3;
/// van den Bergen: GJK on shapes with a margin shell, EPA only for deep contact; the shells make every shape larger by the margin
pub const CAROM_NARROW_HYBRID: u32 = 0;
/// GJK on cores, EPA on overlap; exact geometry
pub const CAROM_NARROW_GJK_EPA: u32 = 1;
/// Johnson's sub-algorithm, of determinants
pub const CAROM_SIMPLEX_JOHNSON: u32 = 0;
/// by Voronoi regions, all features
pub const CAROM_SIMPLEX_VORONOI: u32 = 1;
/// only features that touch the newest vertex, all features as a fall-back
pub const CAROM_SIMPLEX_VORONOI_LAST: u32 = 2;
/// the deepest point alone
pub const CAROM_MANIFOLD_SINGLE: u32 = 0;
/// up to 4 points gathered over steps
pub const CAROM_MANIFOLD_CACHE: u32 = 1;
/// up to 4 points of the whole patch at once, probed for by support functions alone
pub const CAROM_MANIFOLD_PATCH: u32 = 2;
/// the same, with declared faces (box, polytope) clipped exactly; others probed for
pub const CAROM_MANIFOLD_CLIP: u32 = 3;
/// bodies that move farther in a step than they are large may pass through things
pub const CAROM_SWEEP_NONE: u32 = 0;
/// bodies of CAROM_CONTINUOUS_ALWAYS
pub const CAROM_SWEEP_FLAGGED: u32 = 1;
/// also what moves far for its size in a step
pub const CAROM_SWEEP_FAST: u32 = 2;
/// floats
pub const CAROM_PRECISION_FLOAT: u32 = 0;
/// floats in steps with 512 pairs in contact or more, where their memory saves time
pub const CAROM_PRECISION_AUTO: u32 = 1;
/// presets accurate and reference have it
pub const CAROM_PRECISION_DOUBLE: u32 = 2;
/// one substep and coarse distances: crowds, debris, what is seen from afar
pub const CAROM_PRESET_FAST: u32 = 0;
/// what a new world has
pub const CAROM_PRESET_BALANCED: u32 = 1;
/// a quarter of its error, at two to four times its cost
pub const CAROM_PRESET_ACCURATE: u32 = 2;
/// to compare others with: as exact as the library is at a given step
pub const CAROM_PRESET_REFERENCE: u32 = 3;
pub const CAROM_PRESET_COUNT: u32 = 4;
/// any number within its bounds
pub const CAROM_DIAL_KIND_NUMBER: u32 = 0;
/// a whole number within its bounds
pub const CAROM_DIAL_KIND_INTEGER: u32 = 1;
/// one of its named values
pub const CAROM_DIAL_KIND_CHOICE: u32 = 2;
/// outlines of convex shapes: edges of polytopes, three sections' silhouettes of all others
pub const CAROM_DRAW_SHAPES: u32 = 1;
/// sides of a mesh's or height field's triangles
pub const CAROM_DRAW_SCENERY: u32 = 2;
/// boxes about colliders, along the world's axes; none of half-spaces
pub const CAROM_DRAW_BOUNDS: u32 = 4;
/// of the last step: from each point along its normal, `scale` long
pub const CAROM_DRAW_CONTACTS: u32 = 8;
/// frames of both ends (x red, y green, z blue), and what is between them
pub const CAROM_DRAW_JOINTS: u32 = 16;
/// frames of bodies about their centres of mass
pub const CAROM_DRAW_BODIES: u32 = 32;
/// How lines are coloured where their kind does not say: by body type (static grey, kinematic blue, dynamic sand,
/// asleep dim), or a colour for each island, what hangs together by contacts of the last step and joints.
pub const CAROM_DRAW_BY_TYPE: u32 = 0;
/// one colour an island
pub const CAROM_DRAW_BY_ISLAND: u32 = 1;
/// what happened
pub const CAROM_LOG_INFO: u32 = 1;
/// what may surprise: the call succeeded
pub const CAROM_LOG_WARNING: u32 = 2;
/// not used so far: a call that fails says so by its result
pub const CAROM_LOG_ERROR: u32 = 3;
/// of carom_world_get_contact_events()
pub const CAROM_EVENTS_CONTACT: u32 = 1;
/// of carom_world_get_sensor_events()
pub const CAROM_EVENTS_SENSOR: u32 = 2;
/// of carom_world_get_sleep_events()
pub const CAROM_EVENTS_SLEEP: u32 = 4;
/// of carom_world_get_joint_events()
pub const CAROM_EVENTS_JOINT: u32 = 8;
/// of carom_world_get_fault_events()
pub const CAROM_EVENTS_FAULT: u32 = 16;
/// the first step in which the two press on each other
pub const CAROM_CONTACT_BEGIN: u32 = 0;
/// the first after that in which they are farther apart than the contact distance, or one of them is gone, filtered out, disabled or in quarantine; point, normal, impulse, speed: 0
pub const CAROM_CONTACT_END: u32 = 1;
/// they press, and approached faster than hit_speed as the step began, or when a sweep met them
pub const CAROM_CONTACT_HIT: u32 = 2;
/// the collider begins to overlap the sensor
pub const CAROM_SENSOR_ENTER: u32 = 0;
/// it overlaps the sensor no longer
pub const CAROM_SENSOR_LEAVE: u32 = 1;
/// the body fell asleep
pub const CAROM_SLEEP_ASLEEP: u32 = 0;
/// the body woke
pub const CAROM_SLEEP_AWAKE: u32 = 1;
/// `vector` within a box about the frame's origin
pub const CAROM_FORCE_FIELD_UNIFORM: u32 = 0;
/// strength (reference / s)^falloff away from the origin; below 0 it attracts
pub const CAROM_FORCE_FIELD_RADIAL: u32 = 1;
/// the same about the frame's y axis (right-handed), `pull` towards it, `lift` along it
pub const CAROM_FORCE_FIELD_VORTEX: u32 = 2;
/// `vector` in teslas within a box, as UNIFORM: pushes nothing, and turns bodies that have a magnetic moment by T = moment x vector. Second order in the step with velocity_verlet, fourth with rk4; oracle: tests/oracle/test_magnetism
pub const CAROM_FORCE_FIELD_MAGNETIC: u32 = 3;
pub const CAROM_FORCE_FIELD_COUNT: u32 = 4;
/// the points stay together; twist and swing are free
pub const CAROM_JOINT_BALL: u32 = 0;
/// so do the x axes; twist is free
pub const CAROM_JOINT_HINGE: u32 = 1;
/// the frames stay parallel and B's point on A's x axis; slide is free
pub const CAROM_JOINT_SLIDER: u32 = 2;
/// nothing is free
pub const CAROM_JOINT_WELD: u32 = 3;
/// the points stay `length` apart: a rod. With a limit a rope, with a spring a spring
pub const CAROM_JOINT_DISTANCE: u32 = 4;
/// the points stay together, B's z axis at right angles to A's y axis: a cross of two pins
pub const CAROM_JOINT_UNIVERSAL: u32 = 5;
/// a rope from A's point over two anchors to B's, as carom_joint_set_transmission() says; until then it holds nothing. Without a limit the rope neither stretches nor gives way; with one it may be slack
pub const CAROM_JOINT_PULLEY: u32 = 6;
/// A's angle about the x axis of its frame, plus `ratio` times B's about its own, stays what it is; each relative to the world, where bearings of their own hold the wheels. Ratio 1 until carom_joint_set_transmission() says another: they turn against each other
pub const CAROM_JOINT_GEAR: u32 = 7;
/// each axis free, locked, limited, driven and sprung as carom_joint_set_axis() says; until then all are free
pub const CAROM_JOINT_SIX_AXIS: u32 = 8;
/// the coordinate of one joint follows a polynomial of another's, as carom_joint_couple() says, which makes such joints
pub const CAROM_JOINT_COUPLING: u32 = 9;
pub const CAROM_JOINT_COUNT: u32 = 10;
/// rad, of B about the x axes, whole turns counted: ball, hinge
pub const CAROM_COORDINATE_TWIST: u32 = 0;
/// rad, [0, pi], between the x axes: ball, universal
pub const CAROM_COORDINATE_SWING: u32 = 1;
/// m, of B's point along A's x axis: slider
pub const CAROM_COORDINATE_SLIDE: u32 = 2;
/// m, between the points: distance; of the rope, |a - anchor_a| + ratio |b - anchor_b|: pulley
pub const CAROM_COORDINATE_DISTANCE: u32 = 3;
pub const CAROM_COORDINATE_COUNT: u32 = 4;
/// m, B's point along A's x axis
pub const CAROM_AXIS_X: u32 = 0;
/// m
pub const CAROM_AXIS_Y: u32 = 1;
/// m
pub const CAROM_AXIS_Z: u32 = 2;
/// rad, whole turns counted
pub const CAROM_AXIS_TURN_X: u32 = 3;
/// rad, likewise
pub const CAROM_AXIS_TURN_Y: u32 = 4;
/// rad, likewise
pub const CAROM_AXIS_TURN_Z: u32 = 5;
pub const CAROM_AXIS_COUNT: u32 = 6;
/// no bounds
pub const CAROM_AXIS_MODE_FREE: u32 = 0;
/// at `lower`
pub const CAROM_AXIS_MODE_LOCKED: u32 = 1;
/// from `lower` to `upper`; where both are the same and the stops hard, it is locked
pub const CAROM_AXIS_MODE_LIMITED: u32 = 2;
pub const CAROM_AXIS_MODE_COUNT: u32 = 3;
/// at nothing: no force
pub const CAROM_DRIVE_NONE: u32 = 0;
/// force = stiffness (target - x) + damping (speed - x'), `max_force` at most
pub const CAROM_DRIVE_POSITION: u32 = 1;
/// the speed, by whatever force up to `max_force`
pub const CAROM_DRIVE_VELOCITY: u32 = 2;
/// a force or torque, `max_force` at most, whatever the motion
pub const CAROM_DRIVE_EFFORT: u32 = 3;
pub const CAROM_DRIVE_COUNT: u32 = 4;
/// Hz and a ratio: force = -m (w^2 x + 2 damping w x'), w = 2 pi stiffness
pub const CAROM_GAINS_FREQUENCY: u32 = 0;
/// N/m and N s/m, or N m/rad and N m s/rad: force = -(stiffness x + damping x')
pub const CAROM_GAINS_FORCE: u32 = 1;
/// 1/s^2 and 1/s: force = -m (stiffness x + damping x')
pub const CAROM_GAINS_ACCELERATION: u32 = 2;
pub const CAROM_GAINS_COUNT: u32 = 3;
/// position_a and orientation_a are in world coordinates and hold for both bodies as they stand now; those of B are not read
pub const CAROM_JOINT_WORLD_FRAME: u32 = 1;
/// the two bodies may touch each other; else they do not
pub const CAROM_JOINT_COLLIDE: u32 = 2;
/// length is given; else it is the distance of the points as they stand now
pub const CAROM_JOINT_FIELD_LENGTH: u32 = 4;
/// each step measures the joint's accelerations, @see CAROM_JOINT_BULK_ACCELERATION
pub const CAROM_JOINT_ACCELERATIONS: u32 = 8;
/// 4: m or rad, by CAROM_COORDINATE_*, as the bodies stand now; read only
pub const CAROM_JOINT_BULK_COORDINATES: u32 = 0;
/// 4: m/s or rad/s, their rates, from the present velocities; read only
pub const CAROM_JOINT_BULK_SPEEDS: u32 = 1;
/// 6: m and rad, by CAROM_AXIS_*; written: hinge, slider, ball, universal, six-axis
pub const CAROM_JOINT_BULK_AXES: u32 = 2;
/// 6: m/s and rad/s, their rates; written likewise
pub const CAROM_JOINT_BULK_AXIS_SPEEDS: u32 = 3;
/// 3: N, world, as carom_joint_state.force; read only
pub const CAROM_JOINT_BULK_FORCE: u32 = 4;
/// 3: N m, world, as carom_joint_state.torque; read only
pub const CAROM_JOINT_BULK_TORQUE: u32 = 5;
/// 2: m and rad, gap and angle; read only
pub const CAROM_JOINT_BULK_ERROR: u32 = 6;
/// 1: 1 or 0; read only
pub const CAROM_JOINT_BULK_BROKEN: u32 = 7;
/// 1: m or rad, of one motion, whole turns counted; written: hinge, slider
pub const CAROM_JOINT_BULK_POSITION: u32 = 8;
/// 1: m/s or rad/s, of one motion; written likewise
pub const CAROM_JOINT_BULK_VELOCITY: u32 = 9;
/// 1: N or N m, borne along one motion, mean over the last step; read only
pub const CAROM_JOINT_BULK_EFFORT: u32 = 10;
/// 1: m or rad, of one motion: its spring's
pub const CAROM_JOINT_BULK_TARGET: u32 = 11;
/// 1: m/s or rad/s, of one motion: its motor's speed
pub const CAROM_JOINT_BULK_TARGET_VELOCITY: u32 = 12;
/// 1: N or N m, [-1e30, 1e30], of one motion: its motor's force
pub const CAROM_JOINT_BULK_TARGET_EFFORT: u32 = 13;
/// 3: enabled, speed, max_force, as carom_joint_motor; of one motion
pub const CAROM_JOINT_BULK_MOTOR: u32 = 14;
/// 5: enabled, target, frequency, damping, max_force; of one motion
pub const CAROM_JOINT_BULK_SPRING: u32 = 15;
/// 3: enabled, lower, upper; of one motion
pub const CAROM_JOINT_BULK_LIMIT: u32 = 16;
/// 6: N and N m, FORCE and TORQUE in A's frame; of any kind, read only
pub const CAROM_JOINT_BULK_AXIS_EFFORTS: u32 = 17;
/// 6: target of each axis of a six-axis joint, as carom_joint_axis
pub const CAROM_JOINT_BULK_AXIS_TARGETS: u32 = 18;
/// 6: speed, likewise
pub const CAROM_JOINT_BULK_AXIS_TARGET_VELOCITIES: u32 = 19;
/// 6: effort, likewise
pub const CAROM_JOINT_BULK_AXIS_TARGET_EFFORTS: u32 = 20;
/// 6: max_force, likewise
pub const CAROM_JOINT_BULK_AXIS_MAX_FORCES: u32 = 21;
/// 12: drive_stiffness and drive_damping of each axis, in its units
pub const CAROM_JOINT_BULK_AXIS_GAINS: u32 = 22;
/// 12: lower and upper of each axis
pub const CAROM_JOINT_BULK_AXIS_LIMITS: u32 = 23;
/// 4: x, y, z, w, of the drive to an orientation: ball, six-axis
pub const CAROM_JOINT_BULK_ORIENTATION_TARGET: u32 = 24;
/// 3: rad/s, A's frame, likewise
pub const CAROM_JOINT_BULK_ORIENTATION_VELOCITY: u32 = 25;
/// 3: N m, A's frame, likewise
pub const CAROM_JOINT_BULK_ORIENTATION_EFFORT: u32 = 26;
/// 2: stiffness, damping, likewise
pub const CAROM_JOINT_BULK_ORIENTATION_GAINS: u32 = 27;
/// 1: m/s^2 or rad/s^2, of a hinge or slider; read only
pub const CAROM_JOINT_BULK_ACCELERATION: u32 = 28;
/// 6: by CAROM_AXIS_*, of any kind; read only. Both of joints with CAROM_JOINT_ACCELERATIONS
pub const CAROM_JOINT_BULK_AXIS_ACCELERATIONS: u32 = 29;
/// 6: friction of each axis of a six-axis joint, as carom_joint_axis
pub const CAROM_JOINT_BULK_AXIS_FRICTIONS: u32 = 30;
/// 6: armature, likewise
pub const CAROM_JOINT_BULK_AXIS_ARMATURES: u32 = 31;
/// 6: effort_limit, likewise
pub const CAROM_JOINT_BULK_AXIS_EFFORT_LIMITS: u32 = 32;
/// 6: speed_limit, likewise
pub const CAROM_JOINT_BULK_AXIS_SPEED_LIMITS: u32 = 33;
/// 1: friction of the axis of a hinge or slider, as carom_joint_axis
pub const CAROM_JOINT_BULK_FRICTION: u32 = 34;
/// 1: armature, likewise
pub const CAROM_JOINT_BULK_ARMATURE: u32 = 35;
/// 1: effort_limit, likewise
pub const CAROM_JOINT_BULK_EFFORT_LIMIT: u32 = 36;
/// 1: speed_limit, likewise
pub const CAROM_JOINT_BULK_SPEED_LIMIT: u32 = 37;
/// 1: target of the drive of a hinge's or slider's axis, likewise: a servo's
pub const CAROM_JOINT_BULK_DRIVE_TARGET: u32 = 38;
/// 1: speed, likewise
pub const CAROM_JOINT_BULK_DRIVE_VELOCITY: u32 = 39;
/// 1: effort, likewise
pub const CAROM_JOINT_BULK_DRIVE_EFFORT: u32 = 40;
/// 1: max_force, likewise
pub const CAROM_JOINT_BULK_DRIVE_MAX_FORCE: u32 = 41;
/// 2: drive_stiffness and drive_damping, in its units, likewise
pub const CAROM_JOINT_BULK_DRIVE_GAINS: u32 = 42;
pub const CAROM_JOINT_BULK_COUNT: u32 = 43;
/// gyroscopic term of bodies with unlike moments of inertia
pub const CAROM_EFFECT_GYROSCOPIC: u32 = 0;
/// damping of velocity
pub const CAROM_EFFECT_LINEAR_DAMPING: u32 = 1;
/// damping of rotation
pub const CAROM_EFFECT_ANGULAR_DAMPING: u32 = 2;
/// the world's gravity
pub const CAROM_EFFECT_GRAVITY: u32 = 3;
/// forces of the host, at the centre of mass or elsewhere
pub const CAROM_EFFECT_USER_FORCE: u32 = 4;
/// torques of the host
pub const CAROM_EFFECT_USER_TORQUE: u32 = 5;
/// the search for contacts
pub const CAROM_EFFECT_COLLISION: u32 = 6;
/// friction at contacts
pub const CAROM_EFFECT_FRICTION: u32 = 7;
/// bounces
pub const CAROM_EFFECT_RESTITUTION: u32 = 8;
/// resistance of contacts to rolling
pub const CAROM_EFFECT_ROLLING_RESISTANCE: u32 = 9;
/// resistance of contacts to spinning about the normal
pub const CAROM_EFFECT_SPINNING_RESISTANCE: u32 = 10;
/// islands at rest are not stepped
pub const CAROM_EFFECT_SLEEP: u32 = 11;
/// sets of particles
pub const CAROM_EFFECT_PARTICLES: u32 = 12;
/// categories, masks and groups of colliders
pub const CAROM_EFFECT_FILTER: u32 = 13;
/// colliders that only report what overlaps them
pub const CAROM_EFFECT_SENSOR: u32 = 14;
/// joints: what they lock
pub const CAROM_EFFECT_JOINTS: u32 = 15;
/// meshes and height fields
pub const CAROM_EFFECT_SCENERY: u32 = 16;
/// fast bodies are swept
pub const CAROM_EFFECT_CONTINUOUS: u32 = 17;
/// surfaces that move: conveyors
pub const CAROM_EFFECT_SURFACE_VELOCITY: u32 = 18;
/// locked axes of bodies
pub const CAROM_EFFECT_AXIS_LOCKS: u32 = 19;
/// drag of bodies
pub const CAROM_EFFECT_DRAG: u32 = 20;
/// wind on bodies with drag
pub const CAROM_EFFECT_WIND: u32 = 21;
/// force fields
pub const CAROM_EFFECT_FIELDS: u32 = 22;
/// springs between bodies
pub const CAROM_EFFECT_SPRINGS: u32 = 23;
/// water
pub const CAROM_EFFECT_BUOYANCY: u32 = 24;
/// what contacts do: without it bodies pass through each other, and there are no contact points
pub const CAROM_EFFECT_RESPONSE: u32 = 25;
/// limits of joints
pub const CAROM_EFFECT_JOINT_LIMITS: u32 = 26;
/// motors and springs of joints
pub const CAROM_EFFECT_JOINT_MOTORS: u32 = 27;
/// events that a host collects
pub const CAROM_EFFECT_EVENTS: u32 = 28;
/// accounts of energy and momentum
pub const CAROM_EFFECT_LEDGER: u32 = 29;
/// magnetic moments in magnetic fields
pub const CAROM_EFFECT_MAGNETISM: u32 = 30;
pub const CAROM_EFFECT_COUNT: u32 = 31;
/// it runs for the bodies that need it (default)
pub const CAROM_MODE_AS_NEEDED: u32 = 0;
/// it does not run
pub const CAROM_MODE_FORBID: u32 = 1;
/// it runs for all bodies that it can act on, whether they need it or not: to see what it costs, and that it changes nothing. It makes no joints, sets, ... where there are none
pub const CAROM_MODE_FORCE: u32 = 2;
/// the line is a stage
pub const CAROM_PLAN_NO_EFFECT: u32 = 4294967295;
/// seconds is its own
pub const CAROM_TIME_OWN: u32 = 0;
/// it is done within the loops of its stage, and in the time of that
pub const CAROM_TIME_IN_STAGE: u32 = 1;
/// not measured, see carom_world_time_effects()
pub const CAROM_TIME_OFF: u32 = 2;
/// a plugin with another one is refused
pub const CAROM_PLUGIN_ABI_MAJOR: u32 = 1;
/// grows with additions
pub const CAROM_PLUGIN_ABI_MINOR: u32 = 0;
/// nothing declared
pub const CAROM_FORM_NONE: u32 = 0;
/// centre at the origin; arg[0]: radius
pub const CAROM_FORM_SPHERE: u32 = 1;
/// axis y; arg[0]: radius, arg[1]: half height of the core segment
pub const CAROM_FORM_CAPSULE: u32 = 2;
/// centred, axis-aligned; arg[0..2]: half extents x, y, z
pub const CAROM_FORM_BOX: u32 = 3;
/// hull of points; arg[0]: index of the first coordinate; the rest of params are x,y,z triples
pub const CAROM_FORM_POLYTOPE: u32 = 4;
/// axis y, centred; arg[0]: radius, arg[1]: half height
pub const CAROM_FORM_CYLINDER: u32 = 5;
/// axis y, apex at +half height, base disc at -half height; arg[0]: base radius, arg[1]: half height
pub const CAROM_FORM_CONE: u32 = 6;
/// centred, axis-aligned; arg[0..2]: radii x, y, z
pub const CAROM_FORM_ELLIPSOID: u32 = 7;
/// In place of an index into params: no parameter. A geometry must write it for core_radius_param where there is no
/// core radius, since 0 there is the first parameter. In form_arg and mass_arg it marks places that the form does not
/// use; those are not read, so 0 does as well. Where the form needs an index, it is refused (PLUGIN_ABI).
pub const CAROM_NO_PARAM: u32 = 4294967295;
/// flags: support may only be called on the thread that steps (scripting hosts)
pub const CAROM_PLUGIN_HOST_THREAD: u32 = 1;
/// The symbol looked up in a shared object.
pub const CAROM_SHAPE_PLUGIN_SYMBOL: &str = "carom_shape_plugin_v1";
/// the bracket is as narrow as the tolerance wants
pub const CAROM_QUERY_EXACT_ENOUGH: u32 = 0;
/// the iteration cap came first; the bracket still holds
pub const CAROM_QUERY_CAPPED: u32 = 1;
/// rounding stopped it; the bracket still holds
pub const CAROM_QUERY_ROUNDING: u32 = 2;
/// a support function misbehaved; nothing else is meaningful
pub const CAROM_QUERY_FAULT: u32 = 3;
/// the hash after each step
pub const CAROM_RECORD_HASHES: u32 = 0;
/// and the state (CAROM_SNAPSHOT_STATE), so that a replay can name a body or a pair
pub const CAROM_RECORD_STATES: u32 = 1;
/// a bit of flags: met from both sides
pub const CAROM_SCENERY_TWO_SIDED: u32 = 1;
/// all but the structure
pub const CAROM_SNAPSHOT_STATE: u32 = 0;
/// the structure, too
pub const CAROM_SNAPSHOT_WHOLE: u32 = 1;
/// it chooses among forward gears; the input's gear says which way, or neutral
pub const CAROM_VEHICLE_AUTOMATIC: u32 = 1;
/// steered wheels share one centre of turn with those that are not steered
pub const CAROM_VEHICLE_ACKERMANN: u32 = 2;
/// the most wheels of a vehicle
pub const CAROM_VEHICLE_WHEELS: u32 = 16;
/// in place of an index: no wheel
pub const CAROM_NO_WHEEL: u32 = 4294967295;
/// which effects have participants; bounds
pub const CAROM_STAGE_REFRESH: u32 = 0;
/// pairs of bounds that overlap
pub const CAROM_STAGE_BROAD: u32 = 1;
/// contacts of pairs
pub const CAROM_STAGE_NARROW: u32 = 2;
/// contact groups
pub const CAROM_STAGE_GROUP: u32 = 3;
/// forces, velocities, positions
pub const CAROM_STAGE_INTEGRATE: u32 = 4;
/// velocities at contacts
pub const CAROM_STAGE_SOLVE: u32 = 5;
/// penetration at contacts
pub const CAROM_STAGE_RELAX: u32 = 6;
/// residuals, events
pub const CAROM_STAGE_OBSERVE: u32 = 7;
pub const CAROM_STAGE_COUNT: u32 = 8;
/// soft contacts hold it
pub const CAROM_REASON_ORDINARY: u32 = 0;
/// bodies that touch have masses further apart than CAROM_DIAL_DIRECT_RATIO
pub const CAROM_REASON_MASS_RATIO: u32 = 1;
/// soft contacts would let it sink by more than CAROM_DIAL_DIRECT_SINK, or did before it lay still
pub const CAROM_REASON_SINK: u32 = 2;
/// too many bodies for the direct solver, or it exceeded its work limit recently
pub const CAROM_REASON_TOO_MUCH: u32 = 3;
/// it would sink, but is under impact: soft contacts take that
pub const CAROM_REASON_IMPACT: u32 = 4;
/// so few bodies that they are solved directly, whatever they do
pub const CAROM_REASON_FEW: u32 = 5;
/// the support function returned nonzero
pub const CAROM_FAULT_RETURNED: u32 = 1;
/// it gave NaN or infinity
pub const CAROM_FAULT_NOT_FINITE: u32 = 2;
/// a point outside the shape's bounding radius
pub const CAROM_FAULT_OUTSIDE: u32 = 3;
/// a point worse than one it had given before
pub const CAROM_FAULT_NOT_SUPPORT: u32 = 4;
/// a body's state was not finite; the body is quarantined
pub const CAROM_FAULT_BODY_STATE: u32 = 5;
/// likewise particles', see carom_particles_get_quarantined()
pub const CAROM_FAULT_PARTICLE_STATE: u32 = 6;
/// what is met first
pub const CAROM_WANT_FIRST: u32 = 0;
/// whether anything is met: HIT, UNDECIDED (only grazes) or MISS; no collider, times or points
pub const CAROM_WANT_ANY: u32 = 1;
#[repr(C)]
pub struct carom_batch {
    _opaque: [u8; 0],
}
#[repr(C)]
pub struct carom_engine {
    _opaque: [u8; 0],
}
/// What computes beside the host: a processor of OpenCL, which is loaded when the first is asked for. One call at a time
/// uses it: a call on a device that another call uses is BUSY.
#[repr(C)]
pub struct carom_device {
    _opaque: [u8; 0],
}
#[repr(C)]
pub struct carom_world {
    _opaque: [u8; 0],
}
#[repr(transparent)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct carom_plugin(pub u64);
#[repr(transparent)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct carom_shape(pub u64);
#[repr(transparent)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct carom_material(pub u64);
#[repr(transparent)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct carom_body(pub u64);
#[repr(transparent)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct carom_collider(pub u64);
/// a set of them
#[repr(transparent)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct carom_particles(pub u64);
/// a set of them
#[repr(transparent)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct carom_joint(pub u64);
/// a set of them
#[repr(transparent)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct carom_force_field(pub u64);
/// a set of them
#[repr(transparent)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct carom_spring(pub u64);
/// Do the parts [begin, end) of a loop. Does not call back, throw or block.
/// @param context as run got it   @param begin, end range of parts
pub type carom_job_fn = Option<unsafe extern "C" fn(*mut c_void, u32, u32)>;
/// Support function of a bounded convex set: the point of the set farthest along dir, in the shape's own frame.
/// Contract: pure (same bits in, same bits out), callable from several threads at once; dir is finite and nonzero, of a
/// length of 5e-324 to 1e308: divide it by its largest component before multiplying or squaring it; ties may be broken
/// either way, but repeatably; no allocation, lock, I/O, change of the floating-point environment, or carom_* call.
/// @param user       as the plugin has it: state of a host's function; NULL for a file's
/// @param params     [param_len] the shape's parameters; owned by the engine, immutable
/// @param param_len  number of parameters
/// @param dir        [3] direction, shape frame, any positive length
/// @param out        [3] m, shape frame: argmax over x in the set of dir . x
/// @return 0; anything else reports a fault: the pair is skipped and the shape put in quarantine
pub type carom_support_fn = Option<unsafe extern "C" fn(*mut c_void, *const f64, u64, *const f64, *mut f64) -> i32>;
/// Take bytes of a recording, in order. Called on the thread that makes the call which is recorded, before that
/// returns; no call of this library is allowed in it.
/// @param user as given to carom_world_record_begin()   @param bytes [size]   @param size number of bytes
/// @return 0; else recording stops, and carom_world_record_end() says so
pub type carom_write_fn = Option<unsafe extern "C" fn(*mut c_void, *const c_void, u64) -> i32>;
/// Details of the last failure of one call. Owned by the caller; start from CAROM_ERROR_INIT.
/// Written only on failure, never past struct_size.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_error {
    /// sizeof(carom_error) as the caller knows it
    pub struct_size: u32,
    /// CAROM_E_*, same as the returned result
    pub code: i32,
    /// 1-based index of the argument at fault; 0: none in particular
    pub argument: i32,
    /// 1: witness_dir and witness_out hold the evidence
    pub has_witness: u32,
    /// direction given to the support function
    pub witness_dir: [f64; 3],
    /// what came back
    pub witness_out: [f64; 3],
    /// what is wrong, zero-terminated
    pub message: [c_char; 256],
    /// what to do next, zero-terminated
    pub remedy: [c_char; 256],
}
impl Default for carom_error {
    fn default() -> Self {
        unsafe {
            let mut it: Self = zeroed();
            it.struct_size = size_of::<carom_error>() as u32;
            it
        }
    }
}
/// An error tolerance. The three numbers are the dials CAROM_DIAL_ACCURACY_PLACE, _TURN and _SUBSTEPS, so that
/// snapshots, recordings and scene files have them. The dial CAROM_DIAL_ACCURACY_WORK bounds the work of large islands
/// in contact further. Fill with carom_accuracy_init().
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_accuracy {
    pub struct_size: u32,
    /// bound of work: that an island may take in a step, 2 to 4096, default 256
    pub substeps: u32,
    /// m per second of motion, 0 to 1e6, default 1e-3; 0: no tolerance of places
    pub place: f64,
    /// rad per second of motion, 0 to 1e6, default 1e-3; 0: no tolerance of turns
    pub turn: f64,
}
impl Default for carom_accuracy {
    fn default() -> Self {
        unsafe {
            let mut it: Self = zeroed();
            carom_accuracy_init(&mut it, size_of::<carom_accuracy>() as u32);
            it
        }
    }
}
/// An island of the last step. Errors are those of its step per second of motion, by the last estimate.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_island {
    /// that of its bodies which has the lowest slot; CAROM_NULL_HANDLE if that was destroyed since
    pub body: carom_body,
    /// that move
    pub bodies: u32,
    /// that it took
    pub substeps: u32,
    /// of the error, as the estimate takes it
    pub order: u32,
    /// CAROM_ISLAND_*
    pub flags: u32,
    /// substeps of all runs of the step: those that were compared and those repeated are among them
    pub work: u64,
    /// m/s; 0 without a tolerance of places
    pub place: f64,
    /// rad/s; 0 without a tolerance of turns
    pub turn: f64,
    /// the larger of the two over its tolerance: above 1 where the bound of work was reached, or where more substeps do not help
    pub share: f64,
}
impl Default for carom_island {
    fn default() -> Self {
        unsafe {
            let it: Self = zeroed();
            it
        }
    }
}
/// How errors grow by themselves, whatever work a step is given: two motions that begin 1e-9 m/s and rad/s apart. Their
/// distance is the largest over all bodies of that of places (m), of turns (rad), and of velocities and spins times 1
/// s.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_growth {
    pub struct_size: u32,
    /// that were taken: fewer than requested where the distance had grown 1e6-fold before
    pub steps: u32,
    /// where the two are farthest apart at the end; CAROM_NULL_HANDLE if nothing moves
    pub body: carom_body,
    /// 1: errors grow e-fold, as in chaos. What is held to an accuracy there is the error that each step adds; the place after many e-foldings is no more than a guess
    pub sensitive: u32,
    /// 0
    pub reserved: u32,
    /// of their distance, from the beginning to the end
    pub factor: f64,
    /// 1/s: ln(factor) over the time; below 0 where errors die out
    pub rate: f64,
}
impl Default for carom_growth {
    fn default() -> Self {
        unsafe {
            let mut it: Self = zeroed();
            it.struct_size = size_of::<carom_growth>() as u32;
            it
        }
    }
}
/// What stands in an array of the host's, and when. Fill with carom_batch_column_init(). A row has n records one after
/// the other, each of as many numbers as the source says; rows are those of the worlds of one structure, in order.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_batch_column {
    pub struct_size: u32,
    /// CAROM_COLUMN_BODIES or what follows it
    pub source: u32,
    /// of BODIES CAROM_FIELD_*, of JOINTS CAROM_JOINT_BULK_*, else 0
    pub field: u32,
    /// CAROM_WHEN_ON_CALL, BEFORE_STEP, AFTER_STEP; default ON_CALL
    pub when: u32,
    /// CAROM_SCALAR_*, default F64
    pub scalar: u32,
    /// 0
    pub reserved: u32,
    /// one of the structure: the first that carom_batch_add_worlds() gave, or any other
    pub world: u64,
    /// how many things, 1 or more; 1 of GRAVITY and TIME
    pub n: u64,
    /// [n] of the things; of RAYS bodies that the rays go with, or 0; NULL of GRAVITY and TIME
    pub handles: *const u64,
    /// [7 n] of RAYS: origin, m, direction, m, and max, in [0, 1e9], in the body's frame or the world's; the body itself is passed over. NULL of others
    pub rays: *const f64,
    /// the first row; belongs to the host, and stays until the batch is destroyed
    pub data: *mut c_void,
    /// bytes from one row to the next; 0: tightly packed
    pub stride: u64,
}
impl Default for carom_batch_column {
    fn default() -> Self {
        unsafe {
            let mut it: Self = zeroed();
            carom_batch_column_init(&mut it, size_of::<carom_batch_column>() as u32);
            it
        }
    }
}
/// What a batch has, and what it costs.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_batch_info {
    pub struct_size: u32,
    /// kinds of worlds
    pub structures: u32,
    /// in all
    pub worlds: u64,
    /// of them
    pub stopped: u64,
    /// that were added
    pub columns: u64,
    /// as many as threads were at work at once, at most, times structures
    pub real_worlds: u64,
    /// of all states: divided by worlds, what one more world takes
    pub state_bytes: u64,
}
impl Default for carom_batch_info {
    fn default() -> Self {
        unsafe {
            let mut it: Self = zeroed();
            it.struct_size = size_of::<carom_batch_info>() as u32;
            it
        }
    }
}
/// Surface of a collider. Where two materials mix differently, the larger CAROM_MIX_* value decides; of two in particular
/// carom_material_set_pair() says what they are to each other.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_material_desc {
    pub struct_size: u32,
    /// CAROM_MIX_*, default GEOMETRIC_MEAN
    pub friction_mix: u32,
    /// CAROM_MIX_*, default MAXIMUM
    pub restitution_mix: u32,
    /// 0
    pub reserved: u32,
    /// Coulomb coefficient, [0, 1e3], default 0.5
    pub friction: f64,
    /// [0, 1], default 0
    pub restitution: f64,
}
impl Default for carom_material_desc {
    fn default() -> Self {
        unsafe {
            let mut it: Self = zeroed();
            carom_material_desc_init(&mut it, size_of::<carom_material_desc>() as u32);
            it
        }
    }
}
/// What a body is made from. Fill with carom_body_desc_init().
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_body_desc {
    pub struct_size: u32,
    /// CAROM_BODY_FIELD_*, CAROM_BODY_STAYS_AWAKE, CAROM_BODY_DISABLED bits
    pub fields: u32,
    /// CAROM_BODY_*, default DYNAMIC
    pub r#type: u32,
    /// 0
    pub reserved: u32,
    /// m, world: origin of the body frame
    pub position: [f64; 3],
    /// x, y, z, w, unit within 1e-6, body to world; default identity
    pub orientation: [f64; 4],
    /// m/s, world, of the centre of mass; 0 for static
    pub linear_velocity: [f64; 3],
    /// rad/s, world; 0 for static
    pub angular_velocity: [f64; 3],
    /// kg, read where fields has CAROM_BODY_FIELD_MASS, else 0; at least 1e-300 for dynamic. A dynamic body without mass from here or from a collider weighs 1 kg and does not rotate (a particle)
    pub mass: f64,
    /// m, body frame: centre of mass; each within 1e15
    pub center: [f64; 3],
    /// kg m^2, body frame axes, about the centre, row-major, symmetric, positive definite; all zero: the body does not rotate
    pub inertia: [f64; 9],
    /// 1/s, [0, 1e6], default 0: dv/dt = -c v
    pub linear_damping: f64,
    /// 1/s, [0, 1e6], default 0
    pub angular_damping: f64,
    /// anything; the engine does not look
    pub user: u64,
    /// share of the world's gravity that acts on it, default 1: carom_body_set_gravity_factor()
    pub gravity_factor: f64,
    /// CAROM_LOCK_* bits, of a dynamic body, default 0: carom_body_set_locks()
    pub locks: u32,
    /// CAROM_CONTINUOUS_*, default AUTO: carom_body_set_continuous()
    pub continuous: u32,
    /// kg/s, at least 0, default 0: carom_body_set_drag()
    pub linear_drag: f64,
    /// kg/m, at least 0, default 0
    pub quadratic_drag: f64,
    /// default 1: carom_body_set_force_field_mask()
    pub force_field_mask: u32,
    /// 0
    pub reserved2: u32,
    /// A m^2, axes of the body, of a dynamic body, default 0
    pub magnetic_moment: [f64; 3],
}
impl Default for carom_body_desc {
    fn default() -> Self {
        unsafe {
            let mut it: Self = zeroed();
            carom_body_desc_init(&mut it, size_of::<carom_body_desc>() as u32);
            it
        }
    }
}
/// What an attribute is. Strings have static storage.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_attribute_info {
    pub struct_size: u32,
    /// CAROM_ATTRIBUTE_*
    pub attribute: u32,
    /// how many it has, 1 to 4
    pub numbers: u32,
    /// 1: whole numbers
    pub is_whole: u32,
    /// 1: only dynamic bodies may have another value than the usual one
    pub of_dynamic: u32,
    /// CAROM_EFFECT_*, which it makes a body take part in
    pub effect: u32,
    /// "gravity_factor"
    pub name: *const c_char,
    /// "kg/s, kg/m": of its numbers in turn; "1" of a share or of bits
    pub unit: *const c_char,
    /// one line
    pub summary: *const c_char,
    /// bounds of each number, inclusive
    pub min: f64,
    /// likewise
    pub max: f64,
    /// default, of a body when it is created; numbers that the attribute does not have are 0
    pub usual: [f64; 4],
}
impl Default for carom_attribute_info {
    fn default() -> Self {
        unsafe {
            let mut it: Self = zeroed();
            it.struct_size = size_of::<carom_attribute_info>() as u32;
            it
        }
    }
}
/// A shape on a body. Fill with carom_collider_desc_init().
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_collider_desc {
    pub struct_size: u32,
    /// 0
    pub reserved: u32,
    /// of the same engine as the world
    pub shape: carom_shape,
    /// CAROM_NULL_HANDLE: friction 0.5, restitution 0
    pub material: carom_material,
    /// m, body frame: origin of the shape; each within 1e15
    pub position: [f64; 3],
    /// x, y, z, w, shape to body; default identity
    pub orientation: [f64; 4],
    /// kg/m^3, [0, 1e9], default 1000; counts unless the body's mass is given
    pub density: f64,
    /// bits, default CAROM_FILTER_CATEGORY: carom_collider_set_filter()
    pub category: u64,
    /// bits, default CAROM_FILTER_MASK
    pub mask: u64,
    /// default 0: none
    pub group: i32,
    /// 1: reports what overlaps it and touches nothing; default 0: carom_collider_set_sensor()
    pub sensor: u32,
    /// m/s, axes of the shape, default 0: carom_collider_set_surface_velocity()
    pub surface_linear: [f64; 3],
    /// rad/s, axes of the shape, about its origin, default 0
    pub surface_angular: [f64; 3],
}
impl Default for carom_collider_desc {
    fn default() -> Self {
        unsafe {
            let mut it: Self = zeroed();
            carom_collider_desc_init(&mut it, size_of::<carom_collider_desc>() as u32);
            it
        }
    }
}
/// How to cast; fill with carom_cast_desc_init().
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_cast_desc {
    pub struct_size: u32,
    /// cap, 1 to 10000, default 128: support calls of a ray or linear cast, distances of a time of impact
    pub iterations: u32,
    /// width of the bracket as length of path, relative to the (smaller) bounding radius; of a time of impact: separation that counts as contact, likewise; bounds of the dial gjk_tolerance, default 1e-6
    pub tolerance: f64,
    /// m, 0 to 1e9, default 0: separation that counts as contact (a ray becomes a ball of this radius)
    pub target: f64,
    /// CAROM_ASK_GENERIC, CAROM_ASK_IGNORE_TOUCHED, default 0
    pub flags: u32,
    /// 0
    pub reserved: u32,
}
impl Default for carom_cast_desc {
    fn default() -> Self {
        unsafe {
            let mut it: Self = zeroed();
            carom_cast_desc_init(&mut it, size_of::<carom_cast_desc>() as u32);
            it
        }
    }
}
/// The result. Numbers of a fault (status CAROM_QUERY_FAULT) mean nothing.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_cast {
    pub struct_size: u32,
    /// CAROM_CAST_*
    pub outcome: u32,
    /// CAROM_QUERY_*: is the bracket as narrow as desc wants
    pub status: u32,
    /// of the search for the time
    pub iterations: u32,
    /// in [lower, upper]; fraction of the direction or motion, s for a time of impact
    pub time: f64,
    /// a miss: end of the motion
    pub lower: f64,
    /// infinite unless in contact
    pub upper: f64,
    /// m, at `time`; the depth (negative) of shapes that overlap at the start
    pub separation: f64,
    /// m, see above: rounding, or the tolerance where a time of impact found a mere touch
    pub slack: f64,
    /// unit, world, from A (or the ray) to B, so opposed to the surface that a ray meets; a ray that starts inside: its direction; zero for a miss
    pub normal: [f64; 3],
    /// m, world, at `time`: on the surface of A; of a ray: where it is
    pub point_a: [f64; 3],
    /// m, world, at `time`: on the surface of B
    pub point_b: [f64; 3],
    /// single calls, A and B together
    pub support_calls: u32,
    pub reserved: u32,
}
impl Default for carom_cast {
    fn default() -> Self {
        unsafe {
            let mut it: Self = zeroed();
            it.struct_size = size_of::<carom_cast>() as u32;
            it
        }
    }
}
/// A shape that travels and turns: its centre at constant velocity, the shape about its centre at constant angular
/// velocity. Fill with carom_motion_init().
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_motion {
    pub struct_size: u32,
    /// 0
    pub reserved: u32,
    /// m, world: origin of the shape at the start
    pub position: [f64; 3],
    /// x, y, z, w; default identity
    pub orientation: [f64; 4],
    /// m, in the shape's frame: what it turns about; default its origin
    pub center: [f64; 3],
    /// m/s, world, of the centre
    pub linear_velocity: [f64; 3],
    /// rad/s, world
    pub angular_velocity: [f64; 3],
}
impl Default for carom_motion {
    fn default() -> Self {
        unsafe {
            let mut it: Self = zeroed();
            carom_motion_init(&mut it, size_of::<carom_motion>() as u32);
            it
        }
    }
}
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_overlap {
    pub struct_size: u32,
    /// CAROM_OVERLAP_*
    pub outcome: u32,
    /// m; apart: the separation is at least this
    pub separation_bound: f64,
    /// unit, world, from A to B; apart
    pub normal: [f64; 3],
    /// m, world; overlapping: in both shapes (between them, if the target is not 0)
    pub point: [f64; 3],
    /// m, what rounding may have done to the proof
    pub slack: f64,
    /// single calls, A and B together
    pub support_calls: u32,
    pub reserved: u32,
}
impl Default for carom_overlap {
    fn default() -> Self {
        unsafe {
            let mut it: Self = zeroed();
            it.struct_size = size_of::<carom_overlap>() as u32;
            it
        }
    }
}
/// Rays in the caller's arrays, of float or double, at any stride (0: tightly packed). struct_size and scalar set by
/// the caller, what is not set zero.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_rays {
    pub struct_size: u32,
    /// CAROM_SCALAR_* of all three
    pub scalar: u32,
    pub count: u64,
    /// [count] 3 scalars each, m
    pub origins: *const c_void,
    /// [count] 3 scalars each, any length
    pub directions: *const c_void,
    /// [count] or NULL: 1 each
    pub max: *const c_void,
    /// bytes
    pub origin_stride: u64,
    pub direction_stride: u64,
    pub max_stride: u64,
}
impl Default for carom_rays {
    fn default() -> Self {
        unsafe {
            let mut it: Self = zeroed();
            it.struct_size = size_of::<carom_rays>() as u32;
            it
        }
    }
}
/// What one ray met.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_ray_hit {
    /// CAROM_CAST_*, BAD_RAY too
    pub outcome: u32,
    /// CAROM_QUERY_*
    pub status: u32,
    /// index in the list of shapes; CAROM_NO_SHAPE: none
    pub shape: u32,
    pub reserved: u32,
    /// as in carom_cast
    pub time: f64,
    /// as in carom_cast
    pub lower: f64,
    /// as in carom_cast
    pub upper: f64,
    /// unit, world, as in carom_cast
    pub normal: [f64; 3],
    /// m, world, on the shape's surface
    pub point: [f64; 3],
}
impl Default for carom_ray_hit {
    fn default() -> Self {
        unsafe {
            let it: Self = zeroed();
            it
        }
    }
}
/// Where results go: records, or separate arrays, or both; NULL: not wanted. Strides in bytes, 0: tightly packed.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_ray_hits {
    pub struct_size: u32,
    /// CAROM_SCALAR_* of times, normals and points
    pub scalar: u32,
    /// [count]; a stride shorter than a record gets its prefix
    pub records: *mut carom_ray_hit,
    /// [count]
    pub outcomes: *mut u32,
    /// [count]
    pub shapes: *mut u32,
    /// [count] 1 scalar; a miss: max; a bad ray: 0
    pub times: *mut c_void,
    /// [count] 3 scalars; a miss: 0
    pub normals: *mut c_void,
    /// [count] 3 scalars; a miss: 0
    pub points: *mut c_void,
    pub record_stride: u64,
    pub outcome_stride: u64,
    pub shape_stride: u64,
    pub time_stride: u64,
    pub normal_stride: u64,
    pub point_stride: u64,
}
impl Default for carom_ray_hits {
    fn default() -> Self {
        unsafe {
            let mut it: Self = zeroed();
            it.struct_size = size_of::<carom_ray_hits>() as u32;
            it
        }
    }
}
/// How a character moves. Fill with carom_character_desc_init(). Characters may share one, and it may change between
/// moves.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_character_desc {
    pub struct_size: u32,
    /// CAROM_CHARACTER_* bits, default TURNS
    pub flags: u32,
    /// unit within 1e-6, world, default (0, 1, 0): against gravity
    pub up: [f64; 3],
    /// m/s^2, [0, 1e6], default 9.81: along -up. The world's own gravity is not looked at
    pub gravity: f64,
    /// m/s, [0, 1e6], default 100: it falls no faster
    pub fall_speed: f64,
    /// rad, [0, 1.57], default 0.8727 (50 degrees): ground up to this slope is firm
    pub max_slope: f64,
    /// m, [0, 1e6], default 0.3: it climbs what is no higher above the ground that it stands on
    pub step_up: f64,
    /// m, [0, 1e6], default 0.3: it keeps to ground that falls away by no more
    pub step_down: f64,
    /// m, [1e-6, 1e6], default 0.01: stands this far from what it touches, and 2 % more
    pub skin: f64,
    /// m/s^2, [0, 1e9], default 1e9: how fast its velocity follows `walk` on firm ground
    pub acceleration: f64,
    /// m/s^2, [0, 1e9], default 10: likewise in the air and on steep ground
    pub air_acceleration: f64,
    /// kg, [0, 1e9], default 80: presses on a dynamic body that it stands on
    pub mass: f64,
    /// N, [0, 1e12], default 500: the most that it pushes a body with, per contact
    pub push_force: f64,
    /// m/s, [0, 1e6], default 5: how fast it leaves what it overlaps
    pub recover_speed: f64,
    /// of its queries, default all bits: as carom_query_desc.category
    pub category: u64,
    /// default all bits: as carom_query_desc.mask
    pub mask: u64,
    /// a body of its own that it passes over, see carom_character_move_body(); default none
    pub body: carom_body,
}
impl Default for carom_character_desc {
    fn default() -> Self {
        unsafe {
            let mut it: Self = zeroed();
            carom_character_desc_init(&mut it, size_of::<carom_character_desc>() as u32);
            it
        }
    }
}
/// Where a character is, how it moves and what it touches. Fill with carom_character_init(), then set position and
/// call carom_character_set_shape(). To teleport it, write position, and set ground to CAROM_GROUND_AIR.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_character {
    pub struct_size: u32,
    /// CAROM_GROUND_*
    pub ground: u32,
    /// convex, by carom_character_set_shape()
    pub shape: carom_shape,
    /// m, world: origin of the shape
    pub position: [f64; 3],
    /// x, y, z, w, shape to world; default identity
    pub orientation: [f64; 4],
    /// m/s: on firm ground along it and relative to it, else in the world
    pub velocity: [f64; 3],
    /// m, from the origin down to the lowest point of the shape: by set_shape
    pub foot: f64,
    /// m, from the origin up to its highest point: likewise
    pub head: f64,
    /// m, from the origin to its farthest point across `up`: likewise
    pub reach: f64,
    /// what it stands on or slides down, or CAROM_NULL_HANDLE
    pub ground_body: carom_body,
    /// of ground_body
    pub ground_collider: carom_collider,
    /// m, world: where it touches the ground
    pub ground_point: [f64; 3],
    /// unit, world, from the ground to it; `up` in the air
    pub ground_normal: [f64; 3],
    /// m/s, world, of the ground at ground_point; in the air of the ground that it left
    pub ground_velocity: [f64; 3],
    /// m, world: where ground_body was at the last move
    pub ground_position: [f64; 3],
    /// x, y, z, w: likewise
    pub ground_orientation: [f64; 4],
    /// of the last move, CAROM_CHARACTER_CONTACTS at most
    pub contact_count: u32,
    /// 0
    pub reserved: u32,
    /// [contact_count] what was in its way
    pub contact_bodies: [carom_body; 8],
    /// [3 contact_count] m, world, on the surface of the body
    pub contact_points: [f64; 24],
    /// [3 contact_count] unit, world, from the body to the character
    pub contact_normals: [f64; 24],
    /// [contact_count] m/s, at which it would have gone on into the body
    pub contact_speeds: [f64; 8],
}
impl Default for carom_character {
    fn default() -> Self {
        unsafe {
            let mut it: Self = zeroed();
            carom_character_init(&mut it, size_of::<carom_character>() as u32);
            it
        }
    }
}
/// What a dial is: documentation and bounds. Strings have static storage.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_dial_info {
    pub struct_size: u32,
    /// CAROM_DIAL_*
    pub dial: u32,
    /// CAROM_DIAL_KIND_*
    pub kind: u32,
    /// for a choice: number of values, 0..choice_count-1
    pub choice_count: u32,
    /// "broad_phase"
    pub name: *const c_char,
    /// "m", "m/s", ""
    pub unit: *const c_char,
    /// one sentence: what it trades
    pub summary: *const c_char,
    /// [choice_count] names in order; NULL unless a choice
    pub choices: *const *const c_char,
    /// inclusive
    pub min: f64,
    /// inclusive
    pub max: f64,
    /// value of a new world
    pub initial: f64,
}
impl Default for carom_dial_info {
    fn default() -> Self {
        unsafe {
            let mut it: Self = zeroed();
            it.struct_size = size_of::<carom_dial_info>() as u32;
            it
        }
    }
}
/// What a constant is. Strings have static storage. Names are distinct from those of dials; which constants there are,
/// and in which order, may change from version to version.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_constant_info {
    pub struct_size: u32,
    /// its number, from 0
    pub constant: u32,
    /// "direct_impact_share"
    pub name: *const c_char,
    /// "rad", "steps"; "1" of a share or a ratio
    pub unit: *const c_char,
    /// what it is, and why it is as large as that
    pub reason: *const c_char,
    /// what breaks if it moves
    pub consequence: *const c_char,
    /// in its unit
    pub value: f64,
}
impl Default for carom_constant_info {
    fn default() -> Self {
        unsafe {
            let mut it: Self = zeroed();
            it.struct_size = size_of::<carom_constant_info>() as u32;
            it
        }
    }
}
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_draw_desc {
    pub struct_size: u32,
    /// CAROM_DRAW_* bits, default SHAPES | CONTACTS | JOINTS
    pub what: u32,
    /// CAROM_DRAW_BY_*, default BY_TYPE
    pub colouring: u32,
    /// 0
    pub reserved: u32,
    /// m, length of normals and axes, default 0.2; > 0
    pub scale: f64,
}
impl Default for carom_draw_desc {
    fn default() -> Self {
        unsafe {
            let mut it: Self = zeroed();
            carom_draw_desc_init(&mut it, size_of::<carom_draw_desc>() as u32);
            it
        }
    }
}
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_draw_line {
    /// m, world
    pub from: [f64; 3],
    /// m, world
    pub to: [f64; 3],
    /// 0xRRGGBBAA
    pub colour: u32,
    /// one CAROM_DRAW_* bit
    pub kind: u32,
    /// that it belongs to; of a contact B; CAROM_NULL_HANDLE: the world's
    pub body: carom_body,
}
impl Default for carom_draw_line {
    fn default() -> Self {
        unsafe {
            let it: Self = zeroed();
            it
        }
    }
}
/// What an engine is made from. Fill with carom_engine_desc_init(), then change what you need.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_engine_desc {
    pub struct_size: u32,
    /// 0
    pub reserved: u32,
    /// Host allocator, both or neither; NULL for the C library's. alloc returns NULL when out of memory; alignment is a power of two. Called on whichever threads use the engine and its worlds, at once.
    pub alloc: Option<unsafe extern "C" fn(*mut c_void, u64, u64) -> *mut c_void>,
    /// Takes back what alloc gave, with the same size and alignment.
    pub free: Option<unsafe extern "C" fn(*mut c_void, *mut c_void, u64, u64)>,
    /// handed to alloc and free
    pub alloc_user: *mut c_void,
    /// Host log, or NULL for silence.
    pub log: Option<unsafe extern "C" fn(*mut c_void, u32, *const c_char)>,
    /// handed to log
    pub log_user: *mut c_void,
}
impl Default for carom_engine_desc {
    fn default() -> Self {
        unsafe {
            let mut it: Self = zeroed();
            carom_engine_desc_init(&mut it, size_of::<carom_engine_desc>() as u32);
            it
        }
    }
}
/// Which threads share the work of a step. The outcome does not depend on it: same bits for any number of threads.
/// Fill with carom_jobs_desc_init(), then change what you need.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_jobs_desc {
    pub struct_size: u32,
    /// Threads in a step, the one that calls carom_world_step() included: 0 or 1, the default, is that one alone; more are a pool that the engine owns, at most 256. Worlds that step at the same time do not wait for it: one of them has it.
    pub threads: u32,
    /// Or the host's own threads (threads is then 0): see to it that job(context, begin, end) is called for ranges that cover [0, count), on any threads at once, and return when all these calls have returned. Called on the thread that steps, and tens of times a step: waking a thread should not take longer than some microseconds. Parts that are left out are done when it returns, those that come twice are done once. Calls of carom_* from inside a part, or from run itself, are REENTRANT.
    pub run: Option<unsafe extern "C" fn(*mut c_void, carom_job_fn, *mut c_void, u32)>,
    /// handed to run
    pub user: *mut c_void,
}
impl Default for carom_jobs_desc {
    fn default() -> Self {
        unsafe {
            let mut it: Self = zeroed();
            carom_jobs_desc_init(&mut it, size_of::<carom_jobs_desc>() as u32);
            it
        }
    }
}
/// Of two colliders; all their contact points together. Sleepers stay in touch.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_contact_event {
    /// CAROM_CONTACT_*
    pub kind: u32,
    pub reserved: u32,
    /// first of the pair
    pub collider_a: carom_collider,
    /// second of the pair
    pub collider_b: carom_collider,
    /// of collider_a
    pub body_a: carom_body,
    /// of collider_b
    pub body_b: carom_body,
    /// m, world: the point that bore most
    pub point: [f64; 3],
    /// unit, world, from A to B, there
    pub normal: [f64; 3],
    /// N s, normal, of all points, over the step
    pub impulse: f64,
    /// m/s, along the normal, of the point that approached fastest as the step began
    pub approach_speed: f64,
}
impl Default for carom_contact_event {
    fn default() -> Self {
        unsafe {
            let it: Self = zeroed();
            it
        }
    }
}
/// What a sensor overlaps at the end of the step and did not at the end of the one before, or the reverse. Sleepers are
/// within what they sleep in.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_sensor_event {
    /// CAROM_SENSOR_*
    pub kind: u32,
    pub reserved: u32,
    /// the collider that is a sensor
    pub sensor: carom_collider,
    /// the collider that overlaps it
    pub other: carom_collider,
    /// of sensor
    pub sensor_body: carom_body,
    /// of other
    pub other_body: carom_body,
}
impl Default for carom_sensor_event {
    fn default() -> Self {
        unsafe {
            let it: Self = zeroed();
            it
        }
    }
}
/// A body that sleeps at the end of the step and did not at the end of the one before, or the reverse.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_sleep_event {
    /// CAROM_SLEEP_*
    pub kind: u32,
    pub reserved: u32,
    /// that fell asleep or woke
    pub body: carom_body,
}
impl Default for carom_sleep_event {
    fn default() -> Self {
        unsafe {
            let it: Self = zeroed();
            it
        }
    }
}
/// A joint that bore more than its break_force or break_torque in this step, and holds nothing any more. It stays until
/// it is destroyed.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_joint_event {
    /// that broke
    pub joint: carom_joint,
    /// CAROM_NULL_HANDLE: the world
    pub body_a: carom_body,
    /// as in carom_joint_desc
    pub body_b: carom_body,
    /// N, world, on B: mean over the step in which it broke, as in carom_joint_state
    pub force: [f64; 3],
    /// N m, world, on B about its point, likewise
    pub torque: [f64; 3],
    /// which step that was: carom_step_report.steps after it
    pub step: u64,
}
impl Default for carom_joint_event {
    fn default() -> Self {
        unsafe {
            let it: Self = zeroed();
            it
        }
    }
}
/// A support function that returned a false point: its shape is disabled from the next step on. Or a body or particles
/// whose state was not finite: they are in quarantine. The same faults as those of carom_world_get_faults(), but by
/// handles that keep their names when what they name is destroyed.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_fault_event {
    /// CAROM_FAULT_*
    pub kind: u32,
    pub reserved: u32,
    /// that is disabled, or CAROM_NULL_HANDLE
    pub shape: carom_shape,
    /// a body with this shape, or the one in quarantine, or CAROM_NULL_HANDLE
    pub body: carom_body,
    /// the set, of CAROM_FAULT_PARTICLE_STATE, or CAROM_NULL_HANDLE
    pub particles: carom_particles,
    /// the first of it that was put in quarantine in this step: its index then
    pub particle: u64,
    /// of a support function: the direction given
    pub dir: [f64; 3],
    /// and what came back
    pub out: [f64; 3],
    /// carom_step_report.steps after the step
    pub step: u64,
}
impl Default for carom_fault_event {
    fn default() -> Self {
        unsafe {
            let it: Self = zeroed();
            it
        }
    }
}
/// What acts on every body that shares a bit of its mask, at the centre of mass. Distances d are softened: what the law
/// reads is s = sqrt(d^2 + core^2), and the direction's length is d / s. Fill with carom_force_field_desc_init().
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_force_field_desc {
    pub struct_size: u32,
    /// CAROM_FORCE_FIELD_*
    pub kind: u32,
    /// 0: m/s^2, all bodies fall alike; 1: N, whatever their mass
    pub is_force: u32,
    /// default 1: bodies that share a bit with it feel it, see carom_body_set_force_field_mask()
    pub mask: u32,
    /// m, world: the frame's origin
    pub position: [f64; 3],
    /// x, y, z, w, frame to world; default identity
    pub orientation: [f64; 4],
    /// m, > 0, may be infinite (default): where a uniform field ends along the axes of the frame, and a vortex along its y axis
    pub half: [f64; 3],
    /// m/s^2 or N, world: of a uniform field; T: of a magnetic one
    pub vector: [f64; 3],
    /// m/s^2 or N at distance `reference`: outward, or of a vortex around the axis
    pub strength: f64,
    /// likewise, of a vortex: towards the axis
    pub pull: f64,
    /// likewise, of a vortex: along the axis
    pub lift: f64,
    /// m, > 0, default 1
    pub reference: f64,
    /// m, >= 0, default 0: softens the centre
    pub core: f64,
    /// m, > 0, may be infinite (default): beyond that distance there is nothing
    pub reach: f64,
    /// [-2, 8]: 0 the same everywhere, 1 a line's, 2 (default) a point's, -1 a spring's
    pub falloff: i32,
    /// 0
    pub reserved: u32,
    /// the host's; the engine does not read it
    pub user: u64,
}
impl Default for carom_force_field_desc {
    fn default() -> Self {
        unsafe {
            let mut it: Self = zeroed();
            carom_force_field_desc_init(&mut it, size_of::<carom_force_field_desc>() as u32);
            it
        }
    }
}
/// A spring as a force, F = stiffness (length - rest) + damping d(length)/dt along the line between two points: what it
/// does between two steps is as exact as the integrator. A substep h resolves stiffness only up to where its frequency
/// w has w h = 1; one that is stiffer is taken to be as stiff as that (carom_world_get_plan() says how many are). For
/// those, and for rods and ropes, there is CAROM_JOINT_DISTANCE, which solves. Fill with carom_spring_desc_init().
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_spring_desc {
    pub struct_size: u32,
    /// 1: a bungee, which neither pushes nor holds back what springs back; 0
    pub only_pulls: u32,
    /// or CAROM_NULL_HANDLE: the world
    pub body_a: carom_body,
    /// likewise; not both, and one of the two must be dynamic
    pub body_b: carom_body,
    /// m, in A's frame, or world
    pub anchor_a: [f64; 3],
    /// m, in B's frame, or world
    pub anchor_b: [f64; 3],
    /// m, [0, 1e9]
    pub rest: f64,
    /// N/m, [0, 1e30]
    pub stiffness: f64,
    /// N s/m, [0, 1e30], default 0
    pub damping: f64,
    /// the host's; the engine does not read it
    pub user: u64,
}
impl Default for carom_spring_desc {
    fn default() -> Self {
        unsafe {
            let mut it: Self = zeroed();
            carom_spring_desc_init(&mut it, size_of::<carom_spring_desc>() as u32);
            it
        }
    }
}
/// All of space where normal . x <= level is water. What of a body's colliders is in it (not sensors, not scenery) is
/// pushed by the weight of what it displaces, at the middle of that part, against the world's gravity, and is taken
/// along by the current: F = -drag * density * volume * (v - current). Balls, ellipsoids, boxes and hulls displace
/// exactly what they cover, other shapes what a hull of 256 of their support points covers, scaled to their volume.
/// Fill with carom_water_init().
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_water {
    pub struct_size: u32,
    /// 0
    pub reserved: u32,
    /// unit, out of the water, default (0, 1, 0)
    pub normal: [f64; 3],
    /// m, default 0
    pub level: f64,
    /// kg/m^3, (0, 1e9], default 1000
    pub density: f64,
    /// m/s, world, default 0
    pub current: [f64; 3],
    /// 1/s, [0, 1e6], default 1
    pub drag: f64,
}
impl Default for carom_water {
    fn default() -> Self {
        unsafe {
            let mut it: Self = zeroed();
            carom_water_init(&mut it, size_of::<carom_water>() as u32);
            it
        }
    }
}
/// Fill with carom_joint_desc_init(): a ball joint, frames at the origins of both bodies, unbreakable. A door on a
/// hinge that stands upright, the joint's x axis along the world's y:
///     desc.kind = CAROM_JOINT_HINGE, desc.fields = CAROM_JOINT_WORLD_FRAME, desc.body_b = door;
///     desc.position_a[0] = 1, desc.orientation_a[2] = desc.orientation_a[3] = 0.70710678118654752;
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_joint_desc {
    pub struct_size: u32,
    /// CAROM_JOINT_*
    pub kind: u32,
    /// CAROM_JOINT_* bits
    pub fields: u32,
    /// 0
    pub reserved: u32,
    /// or CAROM_NULL_HANDLE: the world
    pub body_a: carom_body,
    /// likewise; not both, and one of the two must be dynamic
    pub body_b: carom_body,
    /// m, of the frame in A's coordinates
    pub position_a: [f64; 3],
    /// x, y, z, w: joint -> A
    pub orientation_a: [f64; 4],
    /// m, in B
    pub position_b: [f64; 3],
    /// x, y, z, w, in B
    pub orientation_b: [f64; 4],
    /// m, [0, 1e9]: of a distance joint
    pub length: f64,
    /// N, mean over a step, above which the joint breaks; 0: never
    pub break_force: f64,
    /// N m, likewise
    pub break_torque: f64,
    /// the host's; the engine does not read it
    pub user: u64,
}
impl Default for carom_joint_desc {
    fn default() -> Self {
        unsafe {
            let mut it: Self = zeroed();
            carom_joint_desc_init(&mut it, size_of::<carom_joint_desc>() as u32);
            it
        }
    }
}
/// A coordinate kept within bounds.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_joint_limit {
    pub struct_size: u32,
    /// 0 or 1
    pub enabled: u32,
    /// m or rad: twist [-1e3, 1e3], swing [0, pi], slide [-1e9, 1e9], distance [0, 1e9]
    pub lower: f64,
    /// at least lower
    pub upper: f64,
}
impl Default for carom_joint_limit {
    fn default() -> Self {
        unsafe {
            let mut it: Self = zeroed();
            carom_joint_limit_init(&mut it, size_of::<carom_joint_limit>() as u32);
            it
        }
    }
}
/// A coordinate driven at a speed.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_joint_motor {
    pub struct_size: u32,
    /// 1: on, 0: off
    pub enabled: u32,
    /// m/s or rad/s, [-1e6, 1e6]
    pub speed: f64,
    /// N or N m, [0, 1e30]: how hard it pushes at most
    pub max_force: f64,
}
impl Default for carom_joint_motor {
    fn default() -> Self {
        unsafe {
            let mut it: Self = zeroed();
            carom_joint_motor_init(&mut it, size_of::<carom_joint_motor>() as u32);
            it
        }
    }
}
/// A coordinate pulled towards a place: a spring, or a motor that holds a position. With x the stretch, w = 2 pi
/// frequency and m what the joint's bodies weigh along the coordinate were they alone: force = -m (w^2 x + 2 damping w
/// x').
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_joint_spring {
    pub struct_size: u32,
    /// 1: on, 0: off
    pub enabled: u32,
    /// m or rad, within the bounds of a limit
    pub target: f64,
    /// Hz, [0, 1e4]; a quarter of the substep rate at most acts
    pub frequency: f64,
    /// ratio, [0, 1e3]; 1: critical
    pub damping: f64,
    /// N or N m, [0, 1e30]: how hard it pulls at most
    pub max_force: f64,
}
impl Default for carom_joint_spring {
    fn default() -> Self {
        unsafe {
            let mut it: Self = zeroed();
            carom_joint_spring_init(&mut it, size_of::<carom_joint_spring>() as u32);
            it
        }
    }
}
/// By what a pulley or a gear turns the motion of A into that of B. Fill with carom_joint_transmission_init().
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_joint_transmission {
    pub struct_size: u32,
    /// CAROM_JOINT_FIELD_LENGTH: length is given; else it is that of the rope as the bodies stand now
    pub fields: u32,
    /// [0.001, 1000]: B's part of the rope counts so many times, as if it ran to and fro so often: B is pulled ratio times as hard as A, and moves 1 / ratio as far. Of a gear B's angle, likewise, of either sign: negative where they turn the same way, as in a ring gear. 1 at first
    pub ratio: f64,
    /// m, world: the place that A's part of the rope runs over. A gear has neither anchors nor length
    pub anchor_a: [f64; 3],
    /// m, world: likewise of B's
    pub anchor_b: [f64; 3],
    /// m, [0, 1e9]: |a - anchor_a| + ratio |b - anchor_b| is kept at it, a and b the joint's points. A part of the rope without length pulls nowhere: keep points off anchors
    pub length: f64,
}
impl Default for carom_joint_transmission {
    fn default() -> Self {
        unsafe {
            let mut it: Self = zeroed();
            carom_joint_transmission_init(&mut it, size_of::<carom_joint_transmission>() as u32);
            it
        }
    }
}
/// What a coupling makes follow what: a gear between two hinges on anything, a finger that closes with another, a rack.
/// The coordinate of a hinge is its twist, whole turns counted, that of a slider its slide. With x that of the leader,
/// the follower's is polynomial[0] + polynomial[1] x + ... + polynomial[4] x^4. Each pushes the other: where something
/// holds the follower, it holds the leader. Fill with carom_joint_coupling_init().
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_joint_coupling {
    pub struct_size: u32,
    /// 0
    pub reserved: u32,
    /// a hinge or slider
    pub follower: carom_joint,
    /// another
    pub leader: carom_joint,
    /// m or rad over powers of m or rad, each [-1e9, 1e9]; 0, 1, 0, 0, 0 at first: as far
    pub polynomial: [f64; 5],
    /// yours
    pub user: u64,
}
impl Default for carom_joint_coupling {
    fn default() -> Self {
        unsafe {
            let mut it: Self = zeroed();
            carom_joint_coupling_init(&mut it, size_of::<carom_joint_coupling>() as u32);
            it
        }
    }
}
/// What one axis of a six-axis joint does, or that of a hinge or slider beside its own limit, motor and spring: a hinge
/// has CAROM_AXIS_TURN_X, a slider CAROM_AXIS_X. Fill with carom_joint_axis_init(). A drive, a spring and stops act beside
/// each other; of what is stiffer than (pi / 2 h)^2 m, h a substep, so much acts, and springs of one axis share it.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_joint_axis {
    pub struct_size: u32,
    /// CAROM_AXIS_MODE_*
    pub mode: u32,
    /// m, [-1e9, 1e9], or rad, [-1e3, 1e3]
    pub lower: f64,
    /// likewise, at least lower
    pub upper: f64,
    /// CAROM_GAINS_*: of the stops of a limit
    pub stop_gains: u32,
    /// of a drive to a position
    pub drive_gains: u32,
    /// of the spring beside the drive
    pub spring_gains: u32,
    /// CAROM_DRIVE_*
    pub drive: u32,
    /// of a spring that pushes back from beyond a limit; in Hz [0, 1e4], else [0, 1e30]; it and stop_damping 0: the stops are hard
    pub stop_stiffness: f64,
    /// beyond a limit; a ratio [0, 1e3], else [0, 1e30]
    pub stop_damping: f64,
    /// m or rad, as lower: of a drive to a position
    pub target: f64,
    /// m/s or rad/s, [-1e6, 1e6]: of a drive to a velocity; of a drive to a position that of its target
    pub speed: f64,
    /// N or N m, [-1e30, 1e30]: of a drive by effort
    pub effort: f64,
    /// N or N m, [0, 1e30]: how hard the drive pushes at most
    pub max_force: f64,
    /// as stop_stiffness
    pub drive_stiffness: f64,
    /// as stop_damping
    pub drive_damping: f64,
    /// m or rad, as lower: where the spring rests
    pub rest: f64,
    /// as stop_stiffness; it and spring_damping 0: there is none
    pub spring_stiffness: f64,
    /// as stop_damping
    pub spring_damping: f64,
    /// N or N m, [0, 1e30]: resists any motion along the axis with at most so much; beside the drive
    pub friction: f64,
    /// kg or kg m^2, [0, 1e30]: inertia of a rotor that turns as the axis does, such as a motor's times the square of its gear. It adds armature speed^2 / 2 to the kinetic energy, and gives the bodies no spin of its own. A host that sets velocities sets the rotor's.
    pub armature: f64,
    /// N or N m, [0, 1e30]: how hard the drives of the axis push at most, however large their max_force is; of a hinge or slider its motor and spring, too. Several that act have even shares. Springs of axes, stops, friction and locks have no part in it. 1e30: none
    pub effort_limit: f64,
    /// m/s or rad/s, [0, 1e30]: the axis goes no faster, either way, whatever that takes. Of effect joint_limits. 1e30: none
    pub speed_limit: f64,
}
impl Default for carom_joint_axis {
    fn default() -> Self {
        unsafe {
            let mut it: Self = zeroed();
            carom_joint_axis_init(&mut it, size_of::<carom_joint_axis>() as u32);
            it
        }
    }
}
/// A drive of all three turns as one, by the shortest way: of a ball, or of a six-axis joint none of whose turns is
/// locked (else it rests). With e the rotation vector, in A's frame, of the shortest turn from the target to where B's
/// frame is, its torque is stiffness (-e) + damping (velocity - omega), about each of A's axes `max_force` at most.
/// Fill with carom_joint_orientation_drive_init().
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_joint_orientation_drive {
    pub struct_size: u32,
    /// CAROM_DRIVE_*
    pub drive: u32,
    /// CAROM_GAINS_*
    pub gains: u32,
    /// 0
    pub reserved: u32,
    /// x, y, z, w: B's frame -> A's; of CAROM_DRIVE_POSITION. Half a turn off there is no shortest way
    pub target: [f64; 4],
    /// rad/s, [-1e6, 1e6], A's frame, of B relative to A
    pub velocity: [f64; 3],
    /// N m, [-1e30, 1e30], A's frame: of CAROM_DRIVE_EFFORT
    pub effort: [f64; 3],
    /// N m, [0, 1e30], about A's x, y, z axis
    pub max_force: [f64; 3],
    /// Hz [0, 1e4], else [0, 1e30]
    pub stiffness: f64,
    /// a ratio [0, 1e3], else [0, 1e30]
    pub damping: f64,
}
impl Default for carom_joint_orientation_drive {
    fn default() -> Self {
        unsafe {
            let mut it: Self = zeroed();
            carom_joint_orientation_drive_init(&mut it, size_of::<carom_joint_orientation_drive>() as u32);
            it
        }
    }
}
/// What a joint does and where it is.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_joint_state {
    pub struct_size: u32,
    /// 1: it bore too much, and holds nothing any more
    pub broken: u32,
    /// N, world, on B at its point, of locks, limits, motors and springs, mean over the last step; on A the opposite, but of a pulley 1 / ratio of it, along A's own part of the rope
    pub force: [f64; 3],
    /// N m, world, on B about its point, likewise
    pub torque: [f64; 3],
    /// m, how far the points are from where they should be, limits included
    pub gap: f64,
    /// rad, how far the axes are, likewise; of a gear how far its wheels have slipped, of A's turns
    pub angle: f64,
    /// By CAROM_COORDINATE_*, as the bodies stand now. A twist of a ball, a hinge or six axes counts whole turns. It begins in (-pi, pi] as the joint is made, and goes on from step to step. Snapshots and forks keep it. A pose that a host sets stands for many angles: taken is the one nearest to the last. Where that lies over 0.1 rad beyond a limit and another does not, that other is taken. A limit that is set over half a turn away makes whole turns be forgotten, too.
    pub coordinate: [f64; 4],
    /// m and rad, by CAROM_AXIS_*, likewise; of any kind
    pub axis: [f64; 6],
}
impl Default for carom_joint_state {
    fn default() -> Self {
        unsafe {
            let mut it: Self = zeroed();
            it.struct_size = size_of::<carom_joint_state>() as u32;
            it
        }
    }
}
/// A cause: what it gave in the last step, and since the ledger began.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_ledger_entry {
    /// static, zero-terminated
    pub name: *const c_char,
    /// J, in the last step
    pub kinetic: f64,
    /// J
    pub potential: f64,
    /// N s, world
    pub linear: [f64; 3],
    /// N m s, world, about the origin
    pub angular: [f64; 3],
    /// J, since the ledger began, with the last step
    pub total_kinetic: f64,
    /// J
    pub total_potential: f64,
    /// N s, world
    pub total_linear: [f64; 3],
    /// N m s, world, about the origin
    pub total_angular: [f64; 3],
}
impl Default for carom_ledger_entry {
    fn default() -> Self {
        unsafe {
            let it: Self = zeroed();
            it
        }
    }
}
/// The state itself, summed apart from the causes. After a step `now` is `before` plus the causes of that step, and
/// `start` plus their totals, but for rounding: no more than the bounds here.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_ledger_state {
    pub struct_size: u32,
    /// 0: no ledger, all below is 0
    pub is_kept: u32,
    /// since the ledger began
    pub steps: u64,
    /// J, as the ledger began
    pub start_kinetic: f64,
    /// J
    pub start_potential: f64,
    /// N s
    pub start_linear: [f64; 3],
    /// N m s
    pub start_angular: [f64; 3],
    /// J, after the step before the last
    pub before_kinetic: f64,
    /// J
    pub before_potential: f64,
    /// N s
    pub before_linear: [f64; 3],
    /// N m s
    pub before_angular: [f64; 3],
    /// J, after the last step
    pub now_kinetic: f64,
    /// J
    pub now_potential: f64,
    /// N s
    pub now_linear: [f64; 3],
    /// N m s
    pub now_angular: [f64; 3],
    /// J, of the last step
    pub rounding_energy: f64,
    /// N s
    pub rounding_linear: f64,
    /// N m s
    pub rounding_angular: f64,
    /// J, since the ledger began
    pub total_rounding_energy: f64,
    /// N s
    pub total_rounding_linear: f64,
    /// N m s
    pub total_rounding_angular: f64,
}
impl Default for carom_ledger_state {
    fn default() -> Self {
        unsafe {
            let mut it: Self = zeroed();
            it.struct_size = size_of::<carom_ledger_state>() as u32;
            it
        }
    }
}
/// Pairs in the caller's arrays, at any stride (0: tightly packed). struct_size set by the caller, what is not set
/// zero.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_pairs {
    pub struct_size: u32,
    /// 0
    pub reserved: u32,
    /// pairs, at most 2^24
    pub count: u64,
    /// one each
    pub shapes_a: *const carom_shape,
    /// likewise
    pub shapes_b: *const carom_shape,
    /// 3 each, m, world
    pub positions_a: *const f64,
    /// 4 each: x, y, z, w
    pub orientations_a: *const f64,
    /// 3 each, m, world
    pub positions_b: *const f64,
    /// 4 each: x, y, z, w
    pub orientations_b: *const f64,
    /// bytes; 0: tightly packed
    pub shape_a_stride: u64,
    /// likewise
    pub shape_b_stride: u64,
    /// likewise
    pub position_a_stride: u64,
    /// likewise
    pub orientation_a_stride: u64,
    /// likewise
    pub position_b_stride: u64,
    /// likewise
    pub orientation_b_stride: u64,
}
impl Default for carom_pairs {
    fn default() -> Self {
        unsafe {
            let mut it: Self = zeroed();
            it.struct_size = size_of::<carom_pairs>() as u32;
            it
        }
    }
}
/// A device, and what it has done since it was opened.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_device_info {
    pub struct_size: u32,
    pub reserved: u32,
    /// as its driver says, zero-terminated
    pub name: [c_char; 128],
    /// of OpenCL and the driver, zero-terminated
    pub version: [c_char; 128],
    /// that it was asked for
    pub pairs: u64,
    /// of them, left to the host
    pub host_pairs: u64,
}
impl Default for carom_device_info {
    fn default() -> Self {
        unsafe {
            let mut it: Self = zeroed();
            it.struct_size = size_of::<carom_device_info>() as u32;
            it
        }
    }
}
/// What all particles of a set have in common. Fill with carom_particles_desc_init().
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_particles_desc {
    pub struct_size: u32,
    /// 0
    pub reserved: u32,
    /// of the world's gravity, [-1e3, 1e3], default 1
    pub gravity_factor: f64,
    /// 1/s, [0, 1e6], default 0: dv/dt = -c v, as a body's
    pub linear_damping: f64,
    /// kg, (0, 1e30], default 1: of each particle that is added from now on. It falls and is braked as any other; the mass counts in CAROM_FIELD_MASS and in the energy of the report
    pub mass: f64,
    /// particles to reserve memory for; it grows beyond. default 0
    pub capacity: u64,
}
impl Default for carom_particles_desc {
    fn default() -> Self {
        unsafe {
            let mut it: Self = zeroed();
            carom_particles_desc_init(&mut it, size_of::<carom_particles_desc>() as u32);
            it
        }
    }
}
/// A line of the plan: a stage or an effect, as it was in the last step.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_plan_line {
    /// CAROM_EFFECT_*, or CAROM_PLAN_NO_EFFECT: a stage
    pub effect: u32,
    /// CAROM_STAGE_* that it is part of
    pub stage: u32,
    /// CAROM_MODE_* for the world
    pub mode: u32,
    /// 1 or 0
    pub runs: u32,
    /// participants in the last step
    pub participants: u64,
    /// participants if nothing were forbidden or forced; of effects within contacts, as `participants`
    pub wanted: u64,
    /// participants of all steps since the world was made, summed
    pub evaluations: u64,
    /// memory held for it alone
    pub bytes: u64,
    /// s, in the last step
    pub seconds: f64,
    /// CAROM_TIME_*
    pub timing: u32,
    pub reserved: u32,
    /// as carom_effect_name()
    pub name: [c_char; 32],
    /// what the participants are: "bodies", "contact points"
    pub unit: [c_char; 24],
    /// why it runs, or why not
    pub reason: [c_char; 128],
}
impl Default for carom_plan_line {
    fn default() -> Self {
        unsafe {
            let it: Self = zeroed();
            it
        }
    }
}
/// Documentation and bounds of one parameter; a value outside [min, max] is refused when a shape is made.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_param {
    /// "radius"
    pub name: *const c_char,
    /// "m"; "1" of a number without a dimension. Never empty
    pub unit: *const c_char,
    /// smallest legal value, inclusive
    pub min: f64,
    /// largest legal value, inclusive
    pub max: f64,
}
impl Default for carom_param {
    fn default() -> Self {
        unsafe {
            let it: Self = zeroed();
            it
        }
    }
}
/// What several parameters fulfil together: the sum of weight[i] * params[param[i]] over its terms is at most `most`.
/// Parameters that do not are refused when a shape is made (OUT_OF_RANGE, with `text`), and the plugin is not judged by
/// them. A lens that is thinner than its radius: {"height <= 0.99 radius", 2, {1, 0}, {1, -0.99}, 0}.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_param_rule {
    /// for people: "height <= 0.99 radius"
    pub text: *const c_char,
    /// 1 to 4
    pub term_count: u32,
    /// [term_count] indices into params; of a tail, its first group
    pub param: [u32; 4],
    /// [term_count] finite
    pub weight: [f64; 4],
    /// finite
    pub most: f64,
}
impl Default for carom_param_rule {
    fn default() -> Self {
        unsafe {
            let it: Self = zeroed();
            it
        }
    }
}
/// What the author knows beyond the support function. Data, not code; verified against the support function when a
/// shape is made (a false declaration is refused with a witness direction); never trusted.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_geometry {
    /// sizeof(carom_geometry)
    pub struct_size: u32,
    /// CAROM_FORM_*: the whole set, core radius included, equals this closed form
    pub form: u32,
    /// indices into params, as many as the form uses (see CAROM_FORM_*); CAROM_NO_PARAM in the others
    pub form_arg: [u32; 4],
    /// index into params of the core radius, or CAROM_NO_PARAM: no core radius. With an index, the support function is that of the CORE, and the shape is the core swollen by that radius (a sphere is a point with a radius, a capsule a segment)
    pub core_radius_param: u32,
    /// CAROM_FORM_*: the shape has its volume, centre and inertia; NONE: derive from support
    pub mass_form: u32,
    /// indices into params for mass_form
    pub mass_arg: [u32; 4],
}
impl Default for carom_geometry {
    fn default() -> Self {
        unsafe {
            let mut it: Self = zeroed();
            it.struct_size = size_of::<carom_geometry>() as u32;
            it
        }
    }
}
/// The plugin. Export it as
///     const carom_shape_plugin carom_shape_plugin_v1 = { ... };
/// or pass it to carom_plugin_register(). Everything it points to must live as long as the engine.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_shape_plugin {
    /// sizeof(carom_shape_plugin)
    pub struct_size: u32,
    /// CAROM_PLUGIN_ABI_MAJOR
    pub abi_major: u32,
    /// CAROM_PLUGIN_ABI_MINOR
    pub abi_minor: u32,
    /// CAROM_PLUGIN_HOST_THREAD or 0
    pub flags: u32,
    /// unique, reverse-domain or short: "carom.sphere"
    pub id: *const c_char,
    /// of the shape's meaning: raise it when the same params give another set
    pub version: u32,
    /// number of entries in params; the parameters every shape of this kind has
    pub param_count: u32,
    /// [param_count]
    pub params: *const carom_param,
    /// optional declarations, or NULL
    pub geometry: *const carom_geometry,
    /// the only code
    pub support: carom_support_fn,
    /// 0: exactly param_count parameters. k > 0: the last k entries repeat, so a shape has param_count + m*k parameters, m >= 0 (hull: x, y, z repeated)
    pub param_tail_group: u32,
    /// smallest number of groups in all, the declared one included (hull: 1)
    pub param_tail_min: u32,
    /// [rule_count] or NULL
    pub rules: *const carom_param_rule,
    /// at most 64
    pub rule_count: u32,
    /// 0
    pub reserved: u32,
    /// handed to support: what a closure of the host holds, or NULL. The function must stay pure: same point for the same user, params and dir, as long as the plugin is there
    pub user: *mut c_void,
    /// `support_text` of CAROM_SUPPORT_TEXT(), zero-terminated; NULL: devices cannot ask the shape
    pub text: *const c_char,
}
impl Default for carom_shape_plugin {
    fn default() -> Self {
        unsafe {
            let mut it: Self = zeroed();
            it.struct_size = size_of::<carom_shape_plugin>() as u32;
            it
        }
    }
}
/// Settings of a query; fill with carom_distance_desc_init(). Values as the dials of the same name.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_distance_desc {
    pub struct_size: u32,
    /// CAROM_SIMPLEX_*, default VORONOI_LAST
    pub simplex: u32,
    /// CAROM_NARROW_*, default GJK_EPA
    pub narrow_phase: u32,
    /// 0: always the generic path; 1: a specific routine where there is one; default 0
    pub pair_routines: u32,
    /// relative width of the bracket, default 1e-6
    pub tolerance: f64,
    /// m, for CAROM_NARROW_HYBRID
    pub hybrid_margin: f64,
    /// cap, default 128
    pub gjk_iterations: u32,
    /// cap, default 256
    pub epa_iterations: u32,
}
impl Default for carom_distance_desc {
    fn default() -> Self {
        unsafe {
            let mut it: Self = zeroed();
            carom_distance_desc_init(&mut it, size_of::<carom_distance_desc>() as u32);
            it
        }
    }
}
/// The result: signed distance (negative: depth of the smallest separating translation) and its bracket.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_distance {
    pub struct_size: u32,
    /// CAROM_QUERY_*
    pub status: u32,
    /// m
    pub separation: f64,
    /// m, separation >= lower
    pub lower: f64,
    /// m, separation <= upper
    pub upper: f64,
    /// unit, world, from A to B
    pub normal: [f64; 3],
    /// m, world, on the surface of A
    pub point_a: [f64; 3],
    /// m, world, on the surface of B
    pub point_b: [f64; 3],
    /// taken by GJK
    pub gjk_iterations: u32,
    /// taken by EPA, of shapes that overlap
    pub epa_iterations: u32,
    /// single calls, A and B together
    pub support_calls: u32,
    pub reserved: u32,
}
impl Default for carom_distance {
    fn default() -> Self {
        unsafe {
            let mut it: Self = zeroed();
            it.struct_size = size_of::<carom_distance>() as u32;
            it
        }
    }
}
/// What of a world is not as a snapshot says.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_difference {
    pub struct_size: u32,
    /// 0: it is the same, to the bit
    pub differs: u32,
    /// the body, joint, ... that differs first; of a pair the one collider; 0: none in particular
    pub first: u64,
    /// of a pair the other collider; else 0
    pub second: u64,
    /// what differs, most telling first: "bodies, pairs, dials"; zero-terminated
    pub sections: [c_char; 240],
}
impl Default for carom_difference {
    fn default() -> Self {
        unsafe {
            let mut it: Self = zeroed();
            it.struct_size = size_of::<carom_difference>() as u32;
            it
        }
    }
}
/// What is left undone. Contacts are those of the last step, with the velocities that it ended with; joints and energy
/// are those of the present poses and velocities. Violations of Coulomb's law are in m/s: by how much the velocity at
/// the worst contact would have to be another for its impulse to be right.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_residuals {
    pub struct_size: u32,
    /// 1: energy_drift is known, see carom_world_enable_ledger()
    pub ledger_is_kept: u32,
    /// of the last step
    pub contact_points: u64,
    /// that are attached to a body that is awake, and are not broken
    pub joints: u64,
    /// m, 0 if none
    pub max_penetration: f64,
    /// m, over points that overlap
    pub mean_penetration: f64,
    /// m, most that what a joint locks of its points is apart
    pub joint_gap: f64,
    /// rad, likewise of its axes
    pub joint_angle: f64,
    /// m/s: a contact that approaches, or pushes while separating, bounces excluded
    pub complementarity: f64,
    /// m/s: friction larger than its coefficient times the load, of a pair
    pub cone: f64,
    /// m/s: friction that is not against the slip, or a pair that slips with friction to spare
    pub slip: f64,
    /// J, kinetic and of uniform gravity, of bodies and particles
    pub energy: f64,
    /// J, in the last step, that nothing accounts for: the ledger's integrator and unassigned; 0 without a ledger
    pub energy_drift: f64,
}
impl Default for carom_residuals {
    fn default() -> Self {
        unsafe {
            let mut it: Self = zeroed();
            it.struct_size = size_of::<carom_residuals>() as u32;
            it
        }
    }
}
/// A triangle mesh. Corners at the same place are made one, so vertices may be repeated; triangles without area are
/// dropped (carom_scenery_info counts them). Two triangles that share a side are one surface there; a side of one alone
/// is a boundary edge, and so is a side of three. Fill with carom_mesh_desc_init().
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_mesh_desc {
    pub struct_size: u32,
    /// CAROM_SCENERY_* bits, default 0
    pub flags: u32,
    /// [3 vertex_count] m, shape frame; within 1e8 of the origin
    pub vertices: *const f64,
    /// at least 3
    pub vertex_count: u64,
    /// [3 triangle_count] indices of vertices, counter-clockwise seen from outside
    pub triangles: *const u32,
    /// 1 to 2^28
    pub triangle_count: u64,
}
impl Default for carom_mesh_desc {
    fn default() -> Self {
        unsafe {
            let mut it: Self = zeroed();
            carom_mesh_desc_init(&mut it, size_of::<carom_mesh_desc>() as u32);
            it
        }
    }
}
/// A height field: vertices at (column spacing[0], height, row spacing[1]) in the shape's frame, met from above (+y).
/// Each cell is two triangles, divided from its first corner (column, row) to (column + 1, row + 1). What has its
/// middle in the ground, by no more than its bounding radius, is lifted out. Fill with carom_height_field_desc_init().
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_height_field_desc {
    pub struct_size: u32,
    /// 0
    pub flags: u32,
    /// along x, 2 to 2^14
    pub columns: u32,
    /// along z, 2 to 2^14
    pub rows: u32,
    /// [rows][columns] m; NaN: no vertex, the cells around it are a hole
    pub heights: *const f64,
    /// m, along x and z, default 1
    pub spacing: [f64; 2],
}
impl Default for carom_height_field_desc {
    fn default() -> Self {
        unsafe {
            let mut it: Self = zeroed();
            carom_height_field_desc_init(&mut it, size_of::<carom_height_field_desc>() as u32);
            it
        }
    }
}
/// Counts of a surface: what the engine keeps of the arrays that made it.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_scenery_info {
    /// sizeof(carom_scenery_info), set by the caller
    pub struct_size: u32,
    /// CAROM_SCENERY_* bits, as given
    pub flags: u32,
    /// how many there are: their indices run from 0 to `triangles - 1`. Of a mesh those that are left: triangle_count - dropped. Of a height field 2 (columns - 1) (rows - 1): the two triangles of a cell count whether they are there or a hole
    pub triangles: u64,
    /// of a mesh: vertices after equal ones were made one; of a height field columns rows, NaN ones included
    pub vertices: u64,
    /// triangles of the mesh that were left out, because they have no area (least height below 1e-12 of the longest side); 0 for a height field
    pub dropped: u64,
    /// sides of a triangle with no triangle beyond. 0 for a closed surface. Many in a surface that should be closed: its triangles do not share corners, and bodies will feel the gaps
    pub boundary_edges: u64,
    /// of memory, about
    pub bytes: u64,
}
impl Default for carom_scenery_info {
    fn default() -> Self {
        unsafe {
            let mut it: Self = zeroed();
            it.struct_size = size_of::<carom_scenery_info>() as u32;
            it
        }
    }
}
/// What the engine knows of a shape. Quantities are for unit density (1 kg/m^3) in the shape's own frame; each derived
/// one comes with a rigorous bracket. A half-space has infinite bounds and volume 0.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_shape_info {
    pub struct_size: u32,
    /// CAROM_FORM_*, verified; NONE for a general convex set and the half-space
    pub form: u32,
    /// 1: the built-in half-space
    pub is_half_space: u32,
    /// 1: mass properties come from a verified closed form, brackets have zero width
    pub mass_exact: u32,
    /// CAROM_NULL_HANDLE for the half-space
    pub plugin: carom_plugin,
    /// as carom_shape_get_params() gives it
    pub param_count: u64,
    /// m
    pub core_radius: f64,
    /// m, about the shape's origin
    pub bounding_radius: f64,
    /// m, exact to rounding
    pub aabb_min: [f64; 3],
    /// m
    pub aabb_max: [f64; 3],
    /// m^3, best estimate, within [volume_min, volume_max]
    pub volume: f64,
    /// m^3, lower bound
    pub volume_min: f64,
    /// m^3, upper bound
    pub volume_max: f64,
    /// m
    pub centroid: [f64; 3],
    /// m, upper bound of |error|
    pub centroid_error: f64,
    /// m^5, about the centroid, row-major, symmetric
    pub inertia: [f64; 9],
    /// m^5, upper bound of the spectral norm of the error
    pub inertia_error: f64,
    /// 1: a mesh or a height field (scenery.h); it has no volume
    pub is_scenery: u32,
    /// 0
    pub reserved: u32,
}
impl Default for carom_shape_info {
    fn default() -> Self {
        unsafe {
            let mut it: Self = zeroed();
            it.struct_size = size_of::<carom_shape_info>() as u32;
            it
        }
    }
}
/// What a number of a tree stands for.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_tree_coordinate {
    /// or CAROM_NULL_HANDLE: of the base
    pub joint: carom_joint,
    /// that it moves: the base, or the body that the joint holds to the rest
    pub body: carom_body,
    /// CAROM_AXIS_*; of a base X, Y, Z, TURN_X, TURN_Y, TURN_Z of the world
    pub axis: u32,
    /// 0
    pub reserved: u32,
}
impl Default for carom_tree_coordinate {
    fn default() -> Self {
        unsafe {
            let it: Self = zeroed();
            it
        }
    }
}
/// Chassis, engine and gears. Fill with carom_vehicle_desc_init(): a car of 1.2 t, whose chassis the host names.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_vehicle_desc {
    pub struct_size: u32,
    /// CAROM_VEHICLE_* bits, default AUTOMATIC and ACKERMANN
    pub flags: u32,
    /// dynamic. Its own gravity and mass count
    pub chassis: carom_body,
    /// unit, body frame, default (0, 1, 0): wheels look along -up
    pub up: [f64; 3],
    /// unit, body frame, at right angles to up within 1e-6, default (0, 0, 1)
    pub forward: [f64; 3],
    /// of wheels' queries, default all bits: as carom_query_desc.category
    pub category: u64,
    /// default all bits: as carom_query_desc.mask
    pub mask: u64,
    /// points of the torque curve, 1 to 8, default 4
    pub torque_count: u32,
    /// forward gears, 1 to 8, default 5
    pub gear_count: u32,
    /// [torque_count] rad/s, [0, 1e5], rising: beyond the ends the torque is that of the end
    pub torque_speeds: [f64; 8],
    /// [torque_count] N m, [0, 1e7]: of the engine at full throttle, linear in between
    pub torques: [f64; 8],
    /// rad/s, [1, 1e5], default 90: the engine keeps it by itself
    pub idle_speed: f64,
    /// rad/s, above idle_speed, at most 1e5, default 680: at it the engine gives no torque
    pub max_speed: f64,
    /// kg m^2, [1e-3, 1e6], default 0.25
    pub engine_inertia: f64,
    /// N m, [0, 1e7], default 25: brakes the engine where the throttle is shut
    pub engine_drag: f64,
    /// [gear_count] [1e-3, 1e3], default 3.5, 2.1, 1.4, 1.05, 0.85: turns of the engine for one of the final drive
    pub gears: [f64; 8],
    /// [1e-3, 1e3], default 3.3: likewise
    pub reverse: f64,
    /// [1e-3, 1e3], default 3.7
    pub final_drive: f64,
    /// N m, [0, 1e7], default 600: the most that the clutch takes
    pub clutch_torque: f64,
    /// rad/s, [0, 1e5], default 600: AUTOMATIC takes the next gear above it
    pub shift_up: f64,
    /// rad/s, [0, 1e5], default 220: and the one before below it
    pub shift_down: f64,
    /// s, [0, 10], default 0.2: the clutch is open for so long
    pub shift_time: f64,
    /// N m, [0, 1e7], default 0: the most by which the differential holds driven wheels together
    pub limited_slip: f64,
}
impl Default for carom_vehicle_desc {
    fn default() -> Self {
        unsafe {
            let mut it: Self = zeroed();
            carom_vehicle_desc_init(&mut it, size_of::<carom_vehicle_desc>() as u32);
            it
        }
    }
}
/// One wheel: its place, spring, tyre, and what of engine, brakes and steering reaches it. Fill with
/// carom_wheel_desc_init().
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_wheel_desc {
    pub struct_size: u32,
    /// index of the wheel at the other end of its anti-roll bar, default CAROM_NO_WHEEL
    pub anti_roll_partner: u32,
    /// convex, looks down in place of a ray, its origin at the wheel's centre; default none
    pub shape: carom_shape,
    /// m, body frame: of its centre with the spring at rest, nothing under it
    pub position: [f64; 3],
    /// m, [1e-3, 1e3], default 0.33
    pub radius: f64,
    /// kg m^2, [1e-9, 1e6], default 1: about its axle
    pub inertia: f64,
    /// m, [1e-3, 1e3], default 0.25: up to the bump stop, which is a spring 10 times as stiff
    pub travel: f64,
    /// N/m, [0, 1e9], default 30000
    pub stiffness: f64,
    /// N s/m, [0, 1e8], default 2500: as the spring is pressed
    pub damping_bump: f64,
    /// N s/m, [0, 1e8], default 3500: as it comes back
    pub damping_rebound: f64,
    /// N/m, [0, 1e9], default 0: force on both ends by the difference of their compressions. One end of a bar says it
    pub anti_roll: f64,
    /// rad, [-1.5, 1.5], default 0: at steer 1, to the left
    pub max_steer: f64,
    /// [0, 1e3], default 0: share of the engine's torque, relative to the other wheels
    pub drive: f64,
    /// N m, [0, 1e7], default 2000: torque of the full brake
    pub brake: f64,
    /// N m, [0, 1e7], default 0: likewise
    pub handbrake: f64,
    /// [0, 1], default 0.012: rolling resistance over load
    pub rolling: f64,
    /// [0, 10], default 1: the most friction over load, along the wheel
    pub grip: f64,
    /// [0, 10], default 1: likewise across it
    pub side_grip: f64,
    /// [1e-3, 1], default 0.1: slip along the wheel at which grip is largest
    pub peak_slip: f64,
    /// [1e-3, 1], default 0.12: tangent of the slip angle at which side grip is largest
    pub side_peak_slip: f64,
    /// [0, 1], default 0.8: friction of a tyre that slides, over the most
    pub slide: f64,
    /// [1.01, 100], default 4: from so many times the peak on it slides
    pub slide_slip: f64,
    /// m, [0.01, 10], default 0.3: way in which a tyre builds up its force
    pub relaxation: f64,
}
impl Default for carom_wheel_desc {
    fn default() -> Self {
        unsafe {
            let mut it: Self = zeroed();
            carom_wheel_desc_init(&mut it, size_of::<carom_wheel_desc>() as u32);
            it
        }
    }
}
/// What a driver does. Fill with carom_vehicle_input_init(): nothing, in gear 1.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_vehicle_input {
    pub struct_size: u32,
    /// forward gear, 0: neutral, -1: reverse. AUTOMATIC takes any above 0 as forward
    pub gear: i32,
    /// [0, 1]
    pub throttle: f64,
    /// [0, 1]
    pub brake: f64,
    /// [0, 1]
    pub handbrake: f64,
    /// [-1, 1], 1: to the left as far as wheels go
    pub steer: f64,
}
impl Default for carom_vehicle_input {
    fn default() -> Self {
        unsafe {
            let mut it: Self = zeroed();
            carom_vehicle_input_init(&mut it, size_of::<carom_vehicle_input>() as u32);
            it
        }
    }
}
/// State of engine and gears. Fill with carom_vehicle_init().
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_vehicle {
    pub struct_size: u32,
    /// that is in, or that is being put in
    pub gear: i32,
    /// rad/s
    pub engine_speed: f64,
    /// s, until the clutch closes again
    pub shifting: f64,
    /// s, since then
    pub since_shift: f64,
    /// m/s, of the chassis, forward
    pub speed: f64,
}
impl Default for carom_vehicle {
    fn default() -> Self {
        unsafe {
            let mut it: Self = zeroed();
            carom_vehicle_init(&mut it, size_of::<carom_vehicle>() as u32);
            it
        }
    }
}
/// State of a wheel. Fill with carom_wheel_init().
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_wheel {
    pub struct_size: u32,
    /// 1: it stands on something
    pub touches: u32,
    /// on this, or CAROM_NULL_HANDLE
    pub body: carom_body,
    /// of body
    pub collider: carom_collider,
    /// m, world: where it touches
    pub point: [f64; 3],
    /// unit, world, from the ground
    pub normal: [f64; 3],
    /// m, world: of its centre
    pub position: [f64; 3],
    /// m, of its spring; 0: nothing presses
    pub compression: f64,
    /// rad/s, forward
    pub spin: f64,
    /// rad, [-pi, pi], turned so far
    pub angle: f64,
    /// rad, to the left
    pub steer: f64,
    /// N, along the normal, mean over the drive
    pub load: f64,
    /// N, along the wheel on the chassis, likewise
    pub force: f64,
    /// N, across it, to the left, likewise
    pub side_force: f64,
    /// deflection over relaxation, along: at a steady speed the slip
    pub slip: f64,
    /// likewise across: at a steady speed the tangent of the slip angle
    pub side_slip: f64,
}
impl Default for carom_wheel {
    fn default() -> Self {
        unsafe {
            let mut it: Self = zeroed();
            carom_wheel_init(&mut it, size_of::<carom_wheel>() as u32);
            it
        }
    }
}
/// What a world is made from. Fill with carom_world_desc_init().
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_world_desc {
    pub struct_size: u32,
    /// 0
    pub reserved: u32,
    /// m/s^2, default (0, -9.81, 0)
    pub gravity: [f64; 3],
    /// bodies to reserve memory for; it grows beyond. default 0
    pub body_capacity: u64,
}
impl Default for carom_world_desc {
    fn default() -> Self {
        unsafe {
            let mut it: Self = zeroed();
            carom_world_desc_init(&mut it, size_of::<carom_world_desc>() as u32);
            it
        }
    }
}
/// Times, counts and residuals of the last step. A stage without participants did not run: its time is 0.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_step_report {
    pub struct_size: u32,
    /// CAROM_STAGE_COUNT of this library
    pub stage_count: u32,
    /// s, [stage_count] used, index CAROM_STAGE_*
    pub stage_seconds: [f64; 16],
    /// s
    pub total_seconds: f64,
    /// since the world was made
    pub steps: u64,
    /// s, simulated
    pub time: f64,
    /// all kinds; particles are counted by themselves
    pub bodies: u64,
    /// asleep ones too
    pub dynamic_bodies: u64,
    /// of all bodies
    pub colliders: u64,
    /// pairs that the broad phase reported
    pub broad_pairs: u64,
    /// of them, pairs with at least one contact point
    pub contact_pairs: u64,
    /// of all contact pairs
    pub contact_points: u64,
    /// contact groups with at least one contact
    pub groups: u64,
    /// contact points in it
    pub largest_group: u64,
    /// generic queries
    pub gjk_calls: u64,
    /// of shapes that overlap
    pub epa_calls: u64,
    /// single calls of support functions
    pub support_calls: u64,
    /// impulses applied by the solver
    pub velocity_impulses: u64,
    /// penetration corrections applied
    pub position_moves: u64,
    /// held still since their state was not finite, in all
    pub quarantined_bodies: u64,
    /// plugin faults in this step
    pub faults: u64,
    /// m, over all contact points after the step; 0 if none
    pub max_penetration: f64,
    /// m, over contact points that overlap after the step
    pub mean_penetration: f64,
    /// m/s left at touching contact points after the step
    pub max_closing_speed: f64,
    /// J, kinetic, with that of particles
    pub linear_energy: f64,
    /// J, kinetic
    pub angular_energy: f64,
    /// after the step, counted under dynamic_bodies
    pub asleep_bodies: u64,
    /// of them, in this step
    pub fell_asleep: u64,
    /// bodies that woke in this step or since the one before
    pub woke_up: u64,
    /// of the groups, those that CAROM_SOLVER_AUTO gave to the direct solver
    pub direct_groups: u64,
    /// m/s, how far the direct solver's solution is from Coulomb's law at the worst contact point and substep; 0 where it had nothing to do. Of islands with joints, from that law with friction as bounded by the loads of the substep before
    pub solver_residual: f64,
    /// in all sets
    pub particles: u64,
    /// of them, held still since their state left the world
    pub quarantined_particles: u64,
    /// swept from pose to pose, see carom_body_set_continuous()
    pub swept_bodies: u64,
    /// what they met in the step's substeps, resolved at the time of impact
    pub sweep_hits: u64,
    /// groups of the direct solver, counted a substep, that no velocity could satisfy, as where two surfaces close on a body: their contacts yield
    pub wedged_groups: u64,
    /// solutions of the direct solver by which contacts would have added energy, counted a substep: contacts yield there, which cannot
    pub rejected_solutions: u64,
    /// J, kinetic, that islands with joints and contacts, or whose contacts yield, have beyond what their rows may give, summed over substeps; above 0 only where the work of a step did not suffice to solve one
    pub excess_energy: f64,
}
impl Default for carom_step_report {
    fn default() -> Self {
        unsafe {
            let mut it: Self = zeroed();
            it.struct_size = size_of::<carom_step_report>() as u32;
            it
        }
    }
}
/// A contact point of the last step.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_contact {
    /// first of the pair
    pub collider_a: carom_collider,
    /// second of the pair
    pub collider_b: carom_collider,
    /// of collider_a
    pub body_a: carom_body,
    /// of collider_b
    pub body_b: carom_body,
    /// m, world, midway between the two surfaces
    pub point: [f64; 3],
    /// unit, world, from A to B
    pub normal: [f64; 3],
    /// m, negative in overlap
    pub separation: f64,
    /// N s, summed over the step, along the normal on B
    pub normal_impulse: f64,
    /// N s, magnitude, summed over the step
    pub friction_impulse: f64,
}
impl Default for carom_contact {
    fn default() -> Self {
        unsafe {
            let it: Self = zeroed();
            it
        }
    }
}
/// A contact group of the last step, and which solver CAROM_SOLVER_AUTO chose for it.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_group {
    /// one of its bodies; CAROM_NULL_HANDLE if that was destroyed since
    pub body: carom_body,
    /// that contacts move
    pub bodies: u32,
    /// contact points
    pub points: u32,
    /// CAROM_SOLVER_SOFT_STEP or CAROM_SOLVER_DIRECT
    pub solver: u32,
    /// CAROM_REASON_*
    pub reason: u32,
    /// the most of two bodies that touch; 1 for CAROM_REASON_FEW, which it does not matter to
    pub mass_ratio: f64,
    /// how deep soft contacts would let a body sink, over the thickness of the thinner of the two; 0 for CAROM_REASON_FEW
    pub sink: f64,
}
impl Default for carom_group {
    fn default() -> Self {
        unsafe {
            let it: Self = zeroed();
            it
        }
    }
}
/// Something misbehaved in the last step; the world stayed finite.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_fault {
    /// CAROM_FAULT_*
    pub kind: u32,
    pub reserved: u32,
    /// shape in quarantine, or CAROM_NULL_HANDLE
    pub shape: carom_shape,
    /// a body with this shape, or the quarantined body
    pub body: carom_body,
    /// bits of the direction given
    pub dir: [f64; 3],
    /// bits of what came back
    pub out: [f64; 3],
    /// the set, of PARTICLE_STATE, or CAROM_NULL_HANDLE
    pub particles: carom_particles,
    /// the first of it that was put in quarantine in this step: its index then
    pub particle: u64,
}
impl Default for carom_fault {
    fn default() -> Self {
        unsafe {
            let it: Self = zeroed();
            it
        }
    }
}
/// Settings of a query; fill with carom_query_desc_init(). The same for all queries of a call.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_query_desc {
    pub struct_size: u32,
    /// CAROM_ASK_* bits (cast.h), default 0
    pub flags: u32,
    /// of the query, default all bits: a collider's mask must have a bit of it
    pub category: u64,
    /// default all bits: a collider's categories must have a bit of it (by default it has bit 0)
    pub mask: u64,
    /// its colliders are passed over; default CAROM_NULL_HANDLE: none
    pub ignore: carom_body,
    /// as in carom_cast_desc; of distances as in carom_distance_desc; default 1e-6
    pub tolerance: f64,
    /// m, as in carom_cast_desc: how near counts as contact; default 0
    pub target: f64,
    /// cap, as in carom_cast_desc, default 128
    pub iterations: u32,
    /// 0
    pub reserved: u32,
}
impl Default for carom_query_desc {
    fn default() -> Self {
        unsafe {
            let mut it: Self = zeroed();
            carom_query_desc_init(&mut it, size_of::<carom_query_desc>() as u32);
            it
        }
    }
}
/// One collider's result. Of casts: as in carom_cast. Of overlaps: outcome OVERLAP with a point in both, or UNDECIDED
/// within rounding. Of the nearest: separation, lower and upper as in carom_distance, time 0; outcome OVERLAP if it is
/// negative, else HIT.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_world_hit {
    /// CAROM_CAST_*; a MISS (or BAD_RAY) has no collider
    pub outcome: u32,
    /// CAROM_QUERY_*
    pub status: u32,
    /// index in the call's arrays
    pub query: u64,
    /// CAROM_NULL_HANDLE: none; with status FAULT: the query shape misbehaved
    pub collider: carom_collider,
    /// the collider's
    pub body: carom_body,
    /// as in carom_cast
    pub time: f64,
    /// as in carom_cast; of a distance m
    pub lower: f64,
    /// as in carom_cast; of a distance m
    pub upper: f64,
    /// m
    pub separation: f64,
    /// unit, world, from the ray or the query shape to the collider
    pub normal: [f64; 3],
    /// m, world, on the collider's surface
    pub point: [f64; 3],
    /// m, world, on the query shape's surface, or where the ray is
    pub point_own: [f64; 3],
}
impl Default for carom_world_hit {
    fn default() -> Self {
        unsafe {
            let it: Self = zeroed();
            it
        }
    }
}
/// Query shapes, in the caller's arrays, of float or double, at any stride (0: tightly packed). struct_size and
/// scalar set by the caller, what is not set zero.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_query_shapes {
    pub struct_size: u32,
    /// CAROM_SCALAR_* of all but shapes
    pub scalar: u32,
    pub count: u64,
    /// [count], no half-space; CAROM_NULL_HANDLE: a point. NULL: points all of them
    pub shapes: *const carom_shape,
    /// [count] 3 scalars each, m
    pub positions: *const c_void,
    /// [count] 4 scalars each, x, y, z, w; or NULL: identity
    pub orientations: *const c_void,
    /// [count] 3 scalars each, m, of casts; else NULL
    pub motions: *const c_void,
    /// bytes
    pub shape_stride: u64,
    pub position_stride: u64,
    pub orientation_stride: u64,
    pub motion_stride: u64,
}
impl Default for carom_query_shapes {
    fn default() -> Self {
        unsafe {
            let mut it: Self = zeroed();
            it.struct_size = size_of::<carom_query_shapes>() as u32;
            it
        }
    }
}
/// Where results of rays go, one each: records, or separate arrays, or both; NULL: not wanted. Strides in bytes, 0:
/// tightly packed.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_world_hits {
    pub struct_size: u32,
    /// CAROM_SCALAR_* of times, normals and points
    pub scalar: u32,
    /// [count]; a stride shorter than a record gets its prefix
    pub records: *mut carom_world_hit,
    /// [count]
    pub outcomes: *mut u32,
    /// [count]
    pub colliders: *mut carom_collider,
    /// [count] 1 scalar; a miss: max; a bad ray: 0
    pub times: *mut c_void,
    /// [count] 3 scalars; a miss: 0
    pub normals: *mut c_void,
    /// [count] 3 scalars, `point`; a miss: 0
    pub points: *mut c_void,
    pub record_stride: u64,
    pub outcome_stride: u64,
    pub collider_stride: u64,
    pub time_stride: u64,
    pub normal_stride: u64,
    pub point_stride: u64,
}
impl Default for carom_world_hits {
    fn default() -> Self {
        unsafe {
            let mut it: Self = zeroed();
            it.struct_size = size_of::<carom_world_hits>() as u32;
            it
        }
    }
}
extern "C" {
    /// Version of the library that is running (the CAROM_VERSION_* macros are the header's).
    /// @param major, minor, patch as CAROM_VERSION_*
    /// @status OK; NULL_ARGUMENT
    pub fn carom_version(major: *mut u32, minor: *mut u32, patch: *mut u32) -> i32;
    /// Name of a result code, e.g. "CAROM_E_BUSY"; "CAROM_E_?" for an unknown one. Static storage.
    /// @param result of any call
    pub fn carom_result_name(result: i32) -> *const c_char;
    /// What to do about a result code, in one sentence. Static storage.
    /// @param result of any call
    pub fn carom_result_remedy(result: i32) -> *const c_char;
    /// The layout of every struct of this interface, as the compiler that built this library has it: for a binding, which
    /// compares it with its own when it is loaded. Lines of four words, ending in '\n'; first "carom" and the version:
    ///     carom 0.9.0
    ///     carom_error 0 576 struct              name, offset, size in bytes, kind
    ///     carom_error.struct_size 0 4 u32
    ///     carom_error.witness_dir 16 24 f64[3]
    /// Kinds: u32, i32, u64 (handles too), f64, char, ptr, fn (pointer to a function), struct; [n] behind it: an array.
    /// Newer libraries have more lines, and a struct may be larger; a field stays as it is.
    /// Static storage.
    pub fn carom_abi_manifest() -> *const c_char;
    /// Is this library what a client was built for? As bindings ask when they have loaded it: of the same major version and
    /// not older (of the same minor version before 1.0), and with the same structs, some of which may be larger here.
    /// @param layout  of the client: lines of carom_abi_manifest(), the first with its version, zero-terminated
    /// @status OK; NULL_ARGUMENT; OUT_OF_RANGE (no line of a version); UNSUPPORTED (the message names this library's file, and the
    ///         first line that differs)
    pub fn carom_abi_check(layout: *const c_char, error: *mut carom_error) -> i32;
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE
    pub fn carom_accuracy_init(accuracy: *mut carom_accuracy, struct_size: u32) -> i32;
    /// Set an error tolerance from the next step on.
    /// @param accuracy NULL: none, as a world is created
    /// @status OK; UNSUPPORTED; NULL_ARGUMENT; STRUCT_SIZE; NOT_FINITE; OUT_OF_RANGE (also where both place and turn are
    /// 0);
    ///         BUSY; REENTRANT
    pub fn carom_world_set_accuracy(world: *mut carom_world, accuracy: *const carom_accuracy, error: *mut carom_error) -> i32;
    /// @param accuracy out   @param present out: 1 or 0; if 0, accuracy is filled with defaults
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; BUSY
    pub fn carom_world_get_accuracy(world: *mut carom_world, accuracy: *mut carom_accuracy, present: *mut u32, error: *mut carom_error) -> i32;
    /// Copy out the islands of the last step, worst first: by share, then by body. None without a tolerance.
    /// Bodies in free flight are in none: nothing acts on them but what is constant, and their step is exact.
    /// @param dst      [capacity] elements `stride` bytes apart; may be NULL if capacity is 0
    /// @param stride   sizeof(carom_island) as the caller knows it
    /// @param count    out: how many there are (may exceed capacity; capacity are written)
    /// @status OK; NULL_ARGUMENT; BUFFER_TOO_SMALL; OUT_OF_RANGE (stride); BUSY
    pub fn carom_world_get_islands(world: *mut carom_world, dst: *mut carom_island, stride: u64, capacity: u64, count: *mut u64, error: *mut carom_error) -> i32;
    /// Measure how errors grow from here. Two copies of the world take the steps, at its dials and accuracy, so it costs a
    /// little over twice as much as they; nothing of the world itself changes. The same world gives the same result.
    /// Errors grow e-fold (`sensitive`) where they grow a hundredfold or more, and a quarter of the time or more goes by
    /// until they have grown to the root of that: half of it in chaos, a tenth where they grow in proportion to time.
    /// @param dt      s, of a step: as for carom_world_step()
    /// @param steps   1 to 1000000: several e-foldings of what is looked for, and more than the longest period
    /// @param growth  out, its struct_size set
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; NOT_FINITE; OUT_OF_RANGE; LIMIT; BUSY; REENTRANT; OUT_OF_MEMORY
    /// @thread reader
    pub fn carom_world_measure_growth(world: *mut carom_world, dt: f64, steps: u32, growth: *mut carom_growth, error: *mut carom_error) -> i32;
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE
    pub fn carom_batch_column_init(column: *mut carom_batch_column, struct_size: u32) -> i32;
    /// Make a batch without worlds.
    /// @param batch out: to be destroyed before the engine   @owns the caller: carom_batch_destroy()
    /// @status OK; NULL_ARGUMENT; OUT_OF_MEMORY   @thread engine
    pub fn carom_batch_create(engine: *mut carom_engine, batch: *mut *mut carom_batch, error: *mut carom_error) -> i32;
    /// @status OK; NULL_ARGUMENT; BUSY; REENTRANT
    pub fn carom_batch_destroy(batch: *mut carom_batch, error: *mut carom_error) -> i32;
    /// Add n worlds that are as this one is now. The world itself is read, stays as it is, and may be destroyed. A ledger, a
    /// recording and a budget of time are not copied.
    /// @param batch of the same engine   @param n 1 to 2^24 in all   @param first out: the number of the first of them
    /// @status OK; NULL_ARGUMENT; OUT_OF_RANGE (n); WRONG_WORLD (of another engine); LIMIT (256 structures in all); BUSY;
    ///         REENTRANT; OUT_OF_MEMORY
    pub fn carom_batch_add_worlds(batch: *mut carom_batch, world: *mut carom_world, n: u64, first: *mut u64, error: *mut carom_error) -> i32;
    /// Say where numbers of worlds stand.
    /// @param column out: its number, from 0 on; may be NULL
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; OUT_OF_RANGE (world, n, a ray); NOT_FINITE; *_HANDLE;
    ///         UNSUPPORTED (a joint or body that has no such field; read only: not BEFORE_STEP, nor fields that move
    ///         joints); BUFFER_TOO_SMALL (stride); LIMIT (4,096 columns); BUSY; REENTRANT; OUT_OF_MEMORY
    pub fn carom_batch_add_column(batch: *mut carom_batch, desc: *const carom_batch_column, column: *mut u32, error: *mut carom_error) -> i32;
    /// Advance worlds, each by steps of dt. First, all that columns BEFORE_STEP have for them is checked: where something is
    /// refused no world has moved. A world that is stopped stays as it is, and so do its rows.
    /// @param mask     [worlds] or NULL: all
    /// @param dt       s, in [1e-9, 1]
    /// @param steps    1 to 1e6, with the same numbers before each
    /// @param stopped  out: how many worlds are stopped now, in all; may be NULL
    /// @status OK; NULL_ARGUMENT; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; UNSUPPORTED; BUSY; REENTRANT; OUT_OF_MEMORY; INTERNAL (a
    ///         callback left its thread: some worlds were stepped)
    pub fn carom_batch_step(batch: *mut carom_batch, mask: *const u8, dt: f64, steps: u32, stopped: *mut u64, error: *mut carom_error) -> i32;
    /// Read columns, of worlds as they are now. Contact forces are those of a step: 0 here.
    /// @param columns [count]   @param mask [worlds] or NULL: all
    /// @status OK; NULL_ARGUMENT; OUT_OF_RANGE (a column); BUSY; REENTRANT; OUT_OF_MEMORY
    pub fn carom_batch_read(batch: *mut carom_batch, columns: *const u32, count: u64, mask: *const u8, error: *mut carom_error) -> i32;
    /// Write columns, one after the other: poses, speeds, gains, friction, masses. All worlds or none are changed.
    /// @param columns [count]   @param mask [worlds] or NULL: all
    /// @status OK; NULL_ARGUMENT; OUT_OF_RANGE; NOT_FINITE; NOT_UNIT; UNSUPPORTED (read only, or joints that can't be moved);
    ///         BUSY; REENTRANT; OUT_OF_MEMORY
    pub fn carom_batch_write(batch: *mut carom_batch, columns: *const u32, count: u64, mask: *const u8, error: *mut carom_error) -> i32;
    /// Add a state that worlds of a structure may be reset to.
    /// @param world  one of the structure   @param bytes [size] as carom_world_restore() takes them   @param size of bytes
    /// @param start  out: its number among those of the structure, from 1 on; 0 is the state that its worlds were made with
    /// @status OK; NULL_ARGUMENT; OUT_OF_RANGE (world); CORRUPT; UNSUPPORTED; MISMATCH; BUSY; REENTRANT; OUT_OF_MEMORY
    pub fn carom_batch_add_start(batch: *mut carom_batch, world: u64, bytes: *const c_void, size: u64, start: *mut u32, error: *mut carom_error) -> i32;
    /// Put worlds back to where they began. Masses that were written stay; what else was written is as in the start.
    /// A world that is stopped runs again.
    /// @param mask   [worlds] or NULL: all   @param starts [worlds] numbers of starts, or NULL: 0
    /// @status OK; NULL_ARGUMENT; OUT_OF_RANGE (a start); BUSY; REENTRANT; OUT_OF_MEMORY
    pub fn carom_batch_reset(batch: *mut carom_batch, mask: *const u8, starts: *const u32, error: *mut carom_error) -> i32;
    /// Write a snapshot of one world, as carom_world_save() with CAROM_SNAPSHOT_STATE: it goes into the world that was
    /// copied (unless masses differ), or back by carom_batch_add_start(). Arguments as there.
    /// @param world    its number
    /// @param buffer   [capacity] bytes, or NULL to get the size alone
    /// @param capacity bytes; 0 if buffer is NULL
    /// @param needed   out: bytes of the snapshot; written, too, when the buffer is too small (nothing else is)
    /// @status OK; NULL_ARGUMENT; OUT_OF_RANGE (world); BUFFER_TOO_SMALL; BUSY; REENTRANT; OUT_OF_MEMORY
    pub fn carom_batch_save(batch: *mut carom_batch, world: u64, buffer: *mut c_void, capacity: u64, needed: *mut u64, error: *mut carom_error) -> i32;
    /// The hash of each world, as carom_world_hash().
    /// @param hashes out, [worlds]   @param n how many worlds there are
    /// @status OK; NULL_ARGUMENT; OUT_OF_RANGE (n); BUSY; REENTRANT; OUT_OF_MEMORY
    pub fn carom_batch_get_hashes(batch: *mut carom_batch, hashes: *mut u64, n: u64, error: *mut carom_error) -> i32;
    /// Which worlds are stopped, and why.
    /// @param stopped out, [worlds] CAROM_STOPPED_*   @param n how many worlds there are
    /// @status OK; NULL_ARGUMENT; OUT_OF_RANGE (n); BUSY
    pub fn carom_batch_get_stopped(batch: *mut carom_batch, stopped: *mut u32, n: u64, error: *mut carom_error) -> i32;
    /// The faults of the step that stopped a world; none where it is not stopped.
    /// @param world    its number
    /// @param dst      [capacity] elements `stride` bytes apart; may be NULL if capacity is 0
    /// @param stride   sizeof(carom_fault) as the caller knows it
    /// @param count    out: how many there are (may exceed capacity; capacity are written)
    /// @status OK; NULL_ARGUMENT; BUFFER_TOO_SMALL; OUT_OF_RANGE (world, stride); BUSY
    pub fn carom_batch_get_faults(batch: *mut carom_batch, world: u64, dst: *mut carom_fault, stride: u64, capacity: u64, count: *mut u64, error: *mut carom_error) -> i32;
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; BUSY
    pub fn carom_batch_get_info(batch: *mut carom_batch, info: *mut carom_batch_info, error: *mut carom_error) -> i32;
    /// Random numbers that follow from a key alone: n rows, each from its own key. So they do not depend on how many worlds
    /// there are, in which order or on which thread, or machine, they are drawn. Philox4x32-10; the normal ones by Box and
    /// Muller. A row that is longer begins as a shorter one of its key.
    /// @param kind  CAROM_RANDOM_*
    /// @param keys  [3 n]: of each row a seed, the number of a world, a step
    /// @param width numbers in a row
    /// @param dst   out, [n width]
    /// @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; OUT_OF_RANGE (n, width)   @thread any
    pub fn carom_random_fill(kind: u32, keys: *const u64, n: u64, width: u64, dst: *mut f64, error: *mut carom_error) -> i32;
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE
    pub fn carom_material_desc_init(desc: *mut carom_material_desc, struct_size: u32) -> i32;
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; NOT_FINITE; OUT_OF_RANGE; UNKNOWN_ENUM; BUSY; OUT_OF_MEMORY
    pub fn carom_material_create(world: *mut carom_world, desc: *const carom_material_desc, material: *mut carom_material, error: *mut carom_error) -> i32;
    /// Change a material in place; every collider that uses it follows.   @status as carom_material_create(); *_HANDLE
    pub fn carom_material_update(world: *mut carom_world, material: carom_material, desc: *const carom_material_desc, error: *mut carom_error) -> i32;
    /// Resistance of a surface to rolling and to spinning about the normal, 0 when it is created. A contact that presses
    /// with a force N bears a moment of up to rolling * N in its plane and of up to spinning * N about its normal. Mixed as
    /// friction is; carom_material_update() leaves it alone.
    /// @param rolling, spinning m, [0, 1e3]
    /// @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; OUT_OF_MEMORY
    pub fn carom_material_set_resistance(world: *mut carom_world, material: carom_material, rolling: f64, spinning: f64, error: *mut carom_error) -> i32;
    /// @param rolling, spinning out: m   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY
    pub fn carom_material_get_resistance(world: *mut carom_world, material: carom_material, rolling: *mut f64, spinning: *mut f64, error: *mut carom_error) -> i32;
    /// Say what two materials are to each other, instead of mixing them. Wakes what touches so. It ends with either material.
    /// @param material_a, material_b  in any order; the same twice: colliders of that material among themselves
    /// @param surface [4] friction, [0, 1e3]; restitution, [0, 1]; resistance to rolling and to spinning, m, [0, 1e3].
    ///                NULL: they mix again
    /// @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; OUT_OF_MEMORY   @since 0.9
    pub fn carom_material_set_pair(world: *mut carom_world, material_a: carom_material, material_b: carom_material, surface: *const f64, error: *mut carom_error) -> i32;
    /// What two materials are to each other: what was said of them, or else what they mix to.
    /// @param surface out, [4]: as carom_material_set_pair() takes it
    /// @status OK; NULL_ARGUMENT; *_HANDLE; BUSY   @since 0.9
    pub fn carom_material_get_pair(world: *mut carom_world, material_a: carom_material, material_b: carom_material, surface: *mut f64, error: *mut carom_error) -> i32;
    /// @status OK; NULL_ARGUMENT; *_HANDLE; IN_USE (a collider uses it); BUSY
    pub fn carom_material_destroy(world: *mut carom_world, material: carom_material, error: *mut carom_error) -> i32;
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE
    pub fn carom_body_desc_init(desc: *mut carom_body_desc, struct_size: u32) -> i32;
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; UNKNOWN_ENUM; BUSY;
    ///         REENTRANT; LIMIT; OUT_OF_MEMORY
    pub fn carom_body_create(world: *mut carom_world, desc: *const carom_body_desc, body: *mut carom_body, error: *mut carom_error) -> i32;
    /// Destroys its colliders too.   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT
    pub fn carom_body_destroy(world: *mut carom_world, body: carom_body, error: *mut carom_error) -> i32;
    /// Everything there is to know about a body, with its masses as the engine uses them (fields: all of FIELD_* set; a
    /// body that cannot rotate reports zero inertia; a static or kinematic body reports mass 0).
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; BUSY
    pub fn carom_body_get(world: *mut carom_world, body: carom_body, desc: *mut carom_body_desc, error: *mut carom_error) -> i32;
    /// @param position [3] m   @param orientation [4] x, y, z, w   @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE;
    /// NOT_UNIT; BUSY; REENTRANT
    pub fn carom_body_set_pose(world: *mut carom_world, body: carom_body, position: *const f64, orientation: *const f64, error: *mut carom_error) -> i32;
    /// @param linear [3] m/s of the centre of mass   @param angular [3] rad/s, both world frame
    /// @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE (a static body must have 0); BUSY; REENTRANT
    pub fn carom_body_set_velocity(world: *mut carom_world, body: carom_body, linear: *const f64, angular: *const f64, error: *mut carom_error) -> i32;
    /// @param position [3] out, or NULL: m, world, origin of the body frame   @param orientation [4] out, or NULL: x, y, z,
    /// w, body to world   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY
    pub fn carom_body_get_pose(world: *mut carom_world, body: carom_body, position: *mut f64, orientation: *mut f64, error: *mut carom_error) -> i32;
    /// @param linear [3] out, or NULL: m/s, world, of the centre of mass   @param angular [3] out, or NULL: rad/s, world
    /// @status OK; NULL_ARGUMENT; *_HANDLE; BUSY
    pub fn carom_body_get_velocity(world: *mut carom_world, body: carom_body, linear: *mut f64, angular: *mut f64, error: *mut carom_error) -> i32;
    /// Set the mass of a dynamic body, as carom_body_desc would have. Its frame stays; the velocity of its centre is kept
    /// as that of the new centre. Wakes the body and its island. Snapshots of before do not fit any more (MISMATCH).
    /// @param mass kg, at least 1e-300; or 0: from the densities of its colliders, with center and inertia NULL
    /// @param center [3] m, body frame, or NULL: from its colliders
    /// @param inertia [9] kg m^2, body frame axes, about the centre, row-major, symmetric, positive definite or all zero;
    /// or NULL:
    ///                from its colliders, scaled to the mass
    /// @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE (also: a body that is not dynamic); NO_VOLUME (mass 0,
    ///         and a collider is flat); BUSY; REENTRANT; OUT_OF_MEMORY
    pub fn carom_body_set_mass(world: *mut carom_world, body: carom_body, mass: f64, center: *const f64, inertia: *const f64, error: *mut carom_error) -> i32;
    /// As the engine uses them: mass 0 of a body that is not dynamic, inertia 0 of one that cannot rotate.
    /// @param mass out, or NULL: kg   @param center [3] out, or NULL: m, body frame   @param inertia [9] out, or NULL: kg
    /// m^2, body frame axes, about the centre, row-major   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY
    pub fn carom_body_get_mass(world: *mut carom_world, body: carom_body, mass: *mut f64, center: *mut f64, inertia: *mut f64, error: *mut carom_error) -> i32;
    /// Make a static, kinematic or dynamic body of one that is there. A body that becomes static stops. One that is dynamic
    /// no longer loses the mass that it was given, pending forces and what only dynamic bodies may have
    /// (carom_attribute_info.of_dynamic). Snapshots of before do not fit any more. What it touches wakes.
    /// @param type CAROM_BODY_*
    /// @status OK; NULL_ARGUMENT; *_HANDLE; UNKNOWN_ENUM; OUT_OF_RANGE (a half-space needs a static body, scenery one that
    ///         is not dynamic; a joint or a spring needs a dynamic one); NO_VOLUME; BUSY; REENTRANT; OUT_OF_MEMORY
    pub fn carom_body_set_type(world: *mut carom_world, body: carom_body, r#type: u32, error: *mut carom_error) -> i32;
    /// @param type out: CAROM_BODY_*   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY
    pub fn carom_body_get_type(world: *mut carom_world, body: carom_body, r#type: *mut u32, error: *mut carom_error) -> i32;
    /// @param linear, angular 1/s, [0, 1e6]: dv/dt = -linear v, likewise of spin   @status OK; NULL_ARGUMENT; *_HANDLE;
    /// NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT
    pub fn carom_body_set_damping(world: *mut carom_world, body: carom_body, linear: f64, angular: f64, error: *mut carom_error) -> i32;
    /// @param linear, angular out: 1/s; either may be NULL   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY
    pub fn carom_body_get_damping(world: *mut carom_world, body: carom_body, linear: *mut f64, angular: *mut f64, error: *mut carom_error) -> i32;
    /// @param user anything; the engine does not look   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT
    pub fn carom_body_set_user(world: *mut carom_world, body: carom_body, user: u64, error: *mut carom_error) -> i32;
    /// @param user out   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY
    pub fn carom_body_get_user(world: *mut carom_world, body: carom_body, user: *mut u64, error: *mut carom_error) -> i32;
    /// Number of a body's colliders, and their handles in the order of the slots.
    /// @param colliders [capacity] or NULL   @param count out: how many there are (may exceed capacity; capacity are
    /// written)
    /// @status OK; NULL_ARGUMENT; *_HANDLE; BUSY
    pub fn carom_body_get_colliders(world: *mut carom_world, body: carom_body, colliders: *mut carom_collider, capacity: u64, count: *mut u64, error: *mut carom_error) -> i32;
    /// Add a force and a torque about the centre of mass, for the next step only.
    /// @param force [3] N, world   @param torque [3] N m, world
    /// @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE (the sum would overflow); BUSY; REENTRANT
    pub fn carom_body_add_force(world: *mut carom_world, body: carom_body, force: *const f64, torque: *const f64, error: *mut carom_error) -> i32;
    /// Change velocities at once. @param impulse [3] N s, world   @param point [3] m, world: where it acts
    /// @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE (the velocity would overflow); BUSY; REENTRANT
    pub fn carom_body_add_impulse(world: *mut carom_world, body: carom_body, impulse: *const f64, point: *const f64, error: *mut carom_error) -> i32;
    /// How much of the world's gravity acts on a body: its weight is mass * factor * gravity. With 0 it floats, below 0 it
    /// rises. 1 - c compensates a share c of its gravity, as a counterweight does; inverse dynamics counts it (tree.h). Wakes the body and its island.
    /// @param factor any finite number; 1 when a body is created
    /// @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; BUSY; REENTRANT; OUT_OF_MEMORY
    pub fn carom_body_set_gravity_factor(world: *mut carom_world, body: carom_body, factor: f64, error: *mut carom_error) -> i32;
    /// @param factor out   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY
    pub fn carom_body_get_gravity_factor(world: *mut carom_world, body: carom_body, factor: *mut f64, error: *mut carom_error) -> i32;
    /// Hold the velocity of a dynamic body along and about some world axes at 0, exactly: forces, contacts and joints move
    /// it along the others alone, as heavy there as it is. What it has of such velocity now is gone; what a host writes of
    /// it later is dropped; a pose that a host sets is taken, and kept from then on. Wakes the body and its island.
    ///
    /// Every solver but CAROM_SOLVER_SEVERITY knows locks: a world with that dial refuses them, and a world with a locked
    /// body refuses that dial.
    /// @param locks CAROM_LOCK_* bits, 0 when a body is created
    /// @status OK; NULL_ARGUMENT; *_HANDLE; UNSUPPORTED (unknown bits; or solver severity: set CAROM_DIAL_SOLVER to another
    ///         first); OUT_OF_RANGE (a body that is not dynamic: it moves as its velocity says); BUSY; REENTRANT;
    ///         OUT_OF_MEMORY
    pub fn carom_body_set_locks(world: *mut carom_world, body: carom_body, locks: u32, error: *mut carom_error) -> i32;
    /// @param locks out: CAROM_LOCK_* bits   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY
    pub fn carom_body_get_locks(world: *mut carom_world, body: carom_body, locks: *mut u32, error: *mut carom_error) -> i32;
    /// @param attribute CAROM_ATTRIBUTE_*   @param info out
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM
    pub fn carom_attribute_get_info(attribute: u32, info: *mut carom_attribute_info, error: *mut carom_error) -> i32;
    /// Set an attribute. Another value than it has wakes the body and its island.
    /// @param value [4] in the units of carom_attribute_info; numbers that the attribute does not have must be 0
    /// @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; *_HANDLE; NOT_FINITE; OUT_OF_RANGE (also: a fraction where numbers are
    /// whole; a
    ///         body that is not dynamic); UNSUPPORTED (locks under solver severity); BUSY; REENTRANT; OUT_OF_MEMORY
    pub fn carom_body_set_attribute(world: *mut carom_world, body: carom_body, attribute: u32, value: *const f64, error: *mut carom_error) -> i32;
    /// @param value [4] out: numbers that the attribute does not have are 0
    /// @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; *_HANDLE; BUSY
    pub fn carom_body_get_attribute(world: *mut carom_world, body: carom_body, attribute: u32, value: *mut f64, error: *mut carom_error) -> i32;
    /// @param asleep out: 1 or 0   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY
    pub fn carom_body_is_asleep(world: *mut carom_world, body: carom_body, asleep: *mut u32, error: *mut carom_error) -> i32;
    /// Wake a body and its island; if it is awake, its time of rest starts anew.   @status OK; NULL_ARGUMENT; *_HANDLE;
    /// BUSY; REENTRANT
    pub fn carom_body_wake(world: *mut carom_world, body: carom_body, error: *mut carom_error) -> i32;
    /// Say when a body is swept, from the next step on. Without effect on a static body, and where CAROM_DIAL_CONTINUOUS
    /// says otherwise: under CAROM_SWEEP_NONE no body is swept, under CAROM_SWEEP_FLAGGED only CAROM_CONTINUOUS_ALWAYS.
    /// @param mode CAROM_CONTINUOUS_*
    /// @status OK; NULL_ARGUMENT; *_HANDLE; UNKNOWN_ENUM (mode: pass one of CAROM_CONTINUOUS_*); BUSY; REENTRANT
    pub fn carom_body_set_continuous(world: *mut carom_world, body: carom_body, mode: u32, error: *mut carom_error) -> i32;
    /// @param mode out: CAROM_CONTINUOUS_*   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY
    pub fn carom_body_get_continuous(world: *mut carom_world, body: carom_body, mode: *mut u32, error: *mut carom_error) -> i32;
    /// Take a body out of steps, or back in, from the next step on. A disabled body keeps its pose and velocity. Nothing
    /// moves it, it touches nothing, and its joints and springs hold nothing. Queries do not find it. Bodies that rested on
    /// it wake. It costs a step nothing. A host may still read and write it.
    /// @param enabled 1 or 0
    /// @status OK; NULL_ARGUMENT; *_HANDLE; UNKNOWN_ENUM (enabled: pass 0 or 1); BUSY; REENTRANT; OUT_OF_MEMORY
    pub fn carom_body_set_enabled(world: *mut carom_world, body: carom_body, enabled: u32, error: *mut carom_error) -> i32;
    /// @param enabled out: 1 or 0   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY
    pub fn carom_body_is_enabled(world: *mut carom_world, body: carom_body, enabled: *mut u32, error: *mut carom_error) -> i32;
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE
    pub fn carom_collider_desc_init(desc: *mut carom_collider_desc, struct_size: u32) -> i32;
    /// Put a shape on a body; the body's mass properties follow. The body's linear velocity is kept as that of its new
    /// centre.
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE (also: a
    /// half-space on a
    ///         body that moves); NO_VOLUME (a flat shape needs CAROM_BODY_FIELD_MASS or density 0); BUSY; REENTRANT;
    ///         OUT_OF_MEMORY
    pub fn carom_collider_create(world: *mut carom_world, body: carom_body, desc: *const carom_collider_desc, collider: *mut carom_collider, error: *mut carom_error) -> i32;
    /// The common case in one call: a shape by name, a body, and a collider of density 1000. A shape of that name with the
    /// same parameters that the engine has is used again; a new one lives as long as the engine, or until it is destroyed.
    /// Where a part of it fails nothing has changed, but for a plugin that was loaded. Its orientation is the identity, its
    /// friction 0.5, its restitution 0. carom_body_get_colliders() gives its collider.
    /// @param type CAROM_BODY_*   @param name as carom_shape_create_named()   @param position [3] m, world
    /// @param params [count] as carom_shape_create_named()   @param count number of params
    /// @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; NOT_FOUND; NOT_FINITE; OUT_OF_RANGE; NO_VOLUME; PLUGIN_PATH; PLUGIN_LOAD;
    ///         PLUGIN_ABI; PLUGIN_INVALID; DECLARATION_FALSE; BUSY; REENTRANT; LIMIT; OUT_OF_MEMORY
    pub fn carom_body_create_named(world: *mut carom_world, r#type: u32, name: *const c_char, params: *const f64, count: u64, position: *const f64, body: *mut carom_body, error: *mut carom_error) -> i32;
    /// @status OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT
    pub fn carom_collider_destroy(world: *mut carom_world, collider: carom_collider, error: *mut carom_error) -> i32;
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; BUSY
    pub fn carom_collider_get(world: *mut carom_world, collider: carom_collider, desc: *mut carom_collider_desc, body: *mut carom_body, error: *mut carom_error) -> i32;
    /// Give a collider another material. Wakes what its body touches.   @param material or CAROM_NULL_HANDLE: friction 0.5,
    /// restitution 0   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT; OUT_OF_MEMORY
    pub fn carom_collider_set_material(world: *mut carom_world, collider: carom_collider, material: carom_material, error: *mut carom_error) -> i32;
    /// The body's mass follows, unless it was given. Wakes the body and its island.   @param density kg/m^3, [0, 1e9]
    /// @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE; NO_VOLUME; BUSY; REENTRANT; OUT_OF_MEMORY
    pub fn carom_collider_set_density(world: *mut carom_world, collider: carom_collider, density: f64, error: *mut carom_error) -> i32;
    /// Move a shape on its body; the body's mass follows. What is remembered of its contacts is dropped.
    /// @param position [3] m, body frame: origin of the shape; each within 1e15   @param orientation [4] x, y, z, w, shape
    /// to body
    /// @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; BUSY; REENTRANT; OUT_OF_MEMORY
    pub fn carom_collider_set_pose(world: *mut carom_world, collider: carom_collider, position: *const f64, orientation: *const f64, error: *mut carom_error) -> i32;
    /// Let a collider's surface move though the collider stays: a conveyor belt, a turntable, a track. Friction then brings
    /// what touches it to the velocity of the surface,
    ///   v_body(x) + R (linear + angular x (R^T (x - p))),   the part of it in the plane of the contact,
    /// with R the orientation and p the origin of the shape in the world: axes and origin are the shape's own, so that a
    /// belt turns with its body. Nothing moves but by friction: a surface without friction moves nothing. On a body that
    /// moves it drives that body. Wakes what a change of the collider's filter wakes; what touches a surface that moves
    /// does not fall asleep.
    /// @param linear  [3] m/s, axes of the shape; 0 when a collider is created
    /// @param angular [3] rad/s, axes of the shape, about its origin
    /// @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE (beyond 1e6 m/s or rad/s); BUSY; REENTRANT;
    ///         OUT_OF_MEMORY
    pub fn carom_collider_set_surface_velocity(world: *mut carom_world, collider: carom_collider, linear: *const f64, angular: *const f64, error: *mut carom_error) -> i32;
    /// @param linear, angular out: [3], as they were set   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY
    pub fn carom_collider_get_surface_velocity(world: *mut carom_world, collider: carom_collider, linear: *mut f64, angular: *mut f64, error: *mut carom_error) -> i32;
    /// Number of bodies, and their handles in creation order of the slots.
    /// @param handles [capacity] or NULL   @param count out: how many there are
    /// @status OK; NULL_ARGUMENT; BUSY
    pub fn carom_world_get_bodies(world: *mut carom_world, handles: *mut carom_body, capacity: u64, count: *mut u64, error: *mut carom_error) -> i32;
    /// Read one field of n bodies.
    /// @param handles [n], or NULL for all bodies in the order of carom_world_get_bodies() (n must be their number)
    /// @param dst     n records of the field's scalars, `stride` bytes apart
    /// @param stride  bytes from one record to the next; 0: tightly packed
    /// @param field   CAROM_FIELD_*
    /// @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; *_HANDLE (nothing is written); OUT_OF_RANGE (n); BUFFER_TOO_SMALL (stride);
    /// BUSY
    pub fn carom_world_read(world: *mut carom_world, field: u32, scalar: u32, handles: *const carom_body, n: u64, dst: *mut c_void, stride: u64, error: *mut carom_error) -> i32;
    /// Write one field of n bodies; all values are validated before the first is written. Arguments as carom_world_read().
    /// @param src n records of the field's scalars, `stride` bytes apart
    /// @status as carom_world_read(); UNSUPPORTED (read-only field); NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; REENTRANT
    pub fn carom_world_write(world: *mut carom_world, field: u32, scalar: u32, handles: *const carom_body, n: u64, src: *const c_void, stride: u64, error: *mut carom_error) -> i32;
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE
    pub fn carom_cast_desc_init(desc: *mut carom_cast_desc, struct_size: u32) -> i32;
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE
    pub fn carom_motion_init(motion: *mut carom_motion, struct_size: u32) -> i32;
    /// Cast the ray origin + t direction, 0 <= t <= max, against a shape.
    /// @param position, orientation  of the shape: [3] m, [4] x, y, z, w
    /// @param origin [3] m   @param direction [3] m per unit of t, any length; zero asks whether the origin is inside
    /// @param max    >= 0, may be infinite
    /// @param desc   may be NULL: defaults     @param result struct_size set by the caller
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; UNSUPPORTED
    pub fn carom_ray_cast(engine: *mut carom_engine, shape: carom_shape, position: *const f64, orientation: *const f64, origin: *const f64, direction: *const f64, max: f64, desc: *const carom_cast_desc, result: *mut carom_cast, error: *mut carom_error) -> i32;
    /// Move shape A along a straight line, without turning it, until it touches B.
    /// @param motion [3] m, of A; times are fractions of it. If B moves too: the difference of the two
    /// @param desc   may be NULL: defaults     @param result struct_size set by the caller
    /// @param position_* [3] m, world   @param orientation_* [4] x, y, z, w
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; UNSUPPORTED (two
    ///         half-spaces)
    pub fn carom_shape_cast(engine: *mut carom_engine, shape_a: carom_shape, position_a: *const f64, orientation_a: *const f64, motion: *const f64, shape_b: carom_shape, position_b: *const f64, orientation_b: *const f64, desc: *const carom_cast_desc, result: *mut carom_cast, error: *mut carom_error) -> i32;
    /// First contact of two shapes that both travel and turn, within a duration. UNDECIDED: the cap came first, nothing
    /// touches before `lower`.
    /// @param motion_*  struct_size set by carom_motion_init()   @param duration s, 0 to 1e9
    /// @param desc   may be NULL: defaults     @param result struct_size set by the caller; times in s
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE;
    ///         UNSUPPORTED (two half-spaces, or one that turns)
    pub fn carom_shape_time_of_impact(engine: *mut carom_engine, shape_a: carom_shape, motion_a: *const carom_motion, shape_b: carom_shape, motion_b: *const carom_motion, duration: f64, desc: *const carom_cast_desc, result: *mut carom_cast, error: *mut carom_error) -> i32;
    /// Do two shapes overlap (or come nearer than desc->target)? Cheaper than their distance, with a proof of yes or no.
    /// @param desc   may be NULL: defaults; tolerance is not used   @param result struct_size set by the caller
    /// @param position_* [3] m, world   @param orientation_* [4] x, y, z, w
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; UNSUPPORTED (two
    ///         half-spaces)
    pub fn carom_shape_overlap(engine: *mut carom_engine, shape_a: carom_shape, position_a: *const f64, orientation_a: *const f64, shape_b: carom_shape, position_b: *const f64, orientation_b: *const f64, desc: *const carom_cast_desc, result: *mut carom_overlap, error: *mut carom_error) -> i32;
    /// Cast many rays against one or more shapes: the first hit of each. A bad ray, or one for which a support function
    /// misbehaves (status CAROM_QUERY_FAULT, that of `shape`), spoils no other. Nothing is allocated per ray.
    /// @param shapes [shape_count]   @param positions [3 shape_count] m   @param orientations [4 shape_count] x, y, z, w
    /// @param desc   may be NULL: defaults
    /// @param shape_count number of shapes
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; UNKNOWN_ENUM; UNSUPPORTED;
    ///         BUFFER_TOO_SMALL (a stride); LIMIT (2^32 - 1 shapes); OUT_OF_MEMORY
    pub fn carom_rays_cast(engine: *mut carom_engine, shapes: *const carom_shape, positions: *const f64, orientations: *const f64, shape_count: u64, rays: *const carom_rays, desc: *const carom_cast_desc, hits: *const carom_ray_hits, error: *mut carom_error) -> i32;
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE
    pub fn carom_character_desc_init(desc: *mut carom_character_desc, struct_size: u32) -> i32;
    /// At the origin, in the air, without a shape.   @status OK; NULL_ARGUMENT; STRUCT_SIZE
    pub fn carom_character_init(character: *mut carom_character, struct_size: u32) -> i32;
    /// Give it a shape, or another one: to crouch, to stand up. The lowest point stays where it is, so the origin moves
    /// along `up`. With `fits` the new shape is looked at first. If something is within half the skin of it, `fits` becomes
    /// 0 and nothing changes. Call it again after `up` has changed against the shape.
    /// @param shape convex, of the world's engine: most take a capsule
    /// @param desc may be NULL: defaults
    /// @param character its shape, position, foot, head and reach change
    /// @param fits out: 1 or 0; NULL: it is changed whatever is there, and a later move brings it out
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED (a half-space, scenery; unknown bits); UNKNOWN_ENUM; *_HANDLE;
    ///         NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; PLUGIN_INVALID; BUSY; REENTRANT; OUT_OF_MEMORY   @thread reader
    pub fn carom_character_set_shape(engine: *mut carom_engine, world: *mut carom_world, desc: *const carom_character_desc, character: *mut carom_character, shape: carom_shape, fits: *mut u32, error: *mut carom_error) -> i32;
    /// Move a character by dt. In this order: it follows the ground that it stood on, leaves what it overlaps, then walks,
    /// jumps or falls.
    ///
    /// On firm ground its velocity across `up` follows `walk`, on slopes and steps, too. In the air and on steep ground it
    /// follows `walk` plus the velocity of the ground that it left. Paths in the air are exact parabolas, so where it lands
    /// does not depend on dt beyond one dt's way. On open ground a move takes three queries, in a corner about ten. It
    /// allocates nothing but what queries do.
    /// @param desc may be NULL: defaults
    /// @param character all but shape, foot, head and reach may change
    /// @param walk [3] m/s, world, each within 1e6: what it is to move at, relative to the ground; the part along `up`
    ///        counts only with CAROM_CHARACTER_FLIES
    /// @param jump m/s, [0, 1e6], along `up`: on firm ground it takes off at this speed, and takes the velocity of the
    ///        ground with it; else, and with 0, it does not
    /// @param dt s, [0, 1]
    /// @accuracy stands `skin` and 2 % from surfaces, within 1e-5 m or 1e-6 of its size
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED (unknown bits, reserved); UNKNOWN_ENUM; *_HANDLE (desc->body;
    ///         character->shape: call carom_character_set_shape() first); NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; BUSY;
    ///         REENTRANT; OUT_OF_MEMORY
    /// @thread reader
    pub fn carom_character_move(world: *mut carom_world, desc: *const carom_character_desc, character: *mut carom_character, walk: *const f64, jump: f64, dt: f64, error: *mut carom_error) -> i32;
    /// Push what the last move met, and press on what the character stands on, as forces of the next step. A dynamic body
    /// in its way gets the force that would bring it to the character's speed within dt, push_force at most. One under
    /// firm feet gets mass * gravity. Bodies that are gone are left out.
    /// @param desc may be NULL: defaults   @param character as the last move left it   @param dt s, [1e-9, 1], of the next
    /// step
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; UNKNOWN_ENUM; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE;
    ///         BUSY; REENTRANT; OUT_OF_MEMORY
    pub fn carom_character_push(world: *mut carom_world, desc: *const carom_character_desc, character: *const carom_character, dt: f64, error: *mut carom_error) -> i32;
    /// Let a kinematic body of the host's follow the character, so that other bodies and characters touch it. It gets the
    /// velocity that brings it to the character's place in the next step of dt. Where that is over 1 m away, or the
    /// character has turned, it is placed there at once, at rest. Give the body the character's shape, and name it in
    /// desc->body.
    /// @param desc with a body   @param dt s, [1e-9, 1], of the next step
    /// @param character as the last move left it
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; UNKNOWN_ENUM; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE
    ///         (also: a body that is not kinematic); BUSY; REENTRANT; OUT_OF_MEMORY
    pub fn carom_character_move_body(world: *mut carom_world, desc: *const carom_character_desc, character: *const carom_character, dt: f64, error: *mut carom_error) -> i32;
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM (dial >= CAROM_DIAL_COUNT of this library)
    pub fn carom_dial_get_info(dial: u32, info: *mut carom_dial_info, error: *mut carom_error) -> i32;
    /// Number of dials this library has.   @status OK; NULL_ARGUMENT
    pub fn carom_dial_get_count(count: *mut u32) -> i32;
    /// @param name as in carom_dial_info.name
    /// @status OK; NULL_ARGUMENT; NOT_FOUND; READ_ONLY (this is a constant, not a dial)
    pub fn carom_dial_find(name: *const c_char, dial: *mut u32, error: *mut carom_error) -> i32;
    /// Number of constants this library has.   @status OK; NULL_ARGUMENT
    pub fn carom_constant_get_count(count: *mut u32) -> i32;
    /// @param constant from 0   @param info out
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM (constant >= carom_constant_get_count())
    pub fn carom_constant_get_info(constant: u32, info: *mut carom_constant_info, error: *mut carom_error) -> i32;
    /// Static name of a preset ("balanced"), or "?".
    /// @param preset CAROM_PRESET_*
    pub fn carom_preset_name(preset: u32) -> *const c_char;
    /// What a preset sets a dial to. Presets speak of dials that trade accuracy for time, and all of the same ones; how a
    /// world finds pairs, what sleeps, and what a host chose for its look they leave alone.
    /// @param preset CAROM_PRESET_*   @param dial CAROM_DIAL_*   @param value out
    /// @param value what the preset sets the dial to
    /// @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; NOT_FOUND (presets leave this dial alone)
    pub fn carom_preset_get_dial(preset: u32, dial: u32, value: *mut f64, error: *mut carom_error) -> i32;
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE
    pub fn carom_draw_desc_init(desc: *mut carom_draw_desc, struct_size: u32) -> i32;
    /// All lines of the kinds that desc names, kind by kind in the order of the bits. Shapes whose support function fails
    /// are left out, and so are bodies in quarantine. The same world gives the same lines.
    /// @param desc     NULL: defaults
    /// @param dst      [capacity] elements `stride` bytes apart (0: sizeof(carom_draw_line)), or NULL to count
    /// @param count    out: lines there are; more than capacity: the first `capacity` of them were written
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED (a bit of what, reserved); UNKNOWN_ENUM; NOT_FINITE,
    ///         OUT_OF_RANGE (scale); BUFFER_TOO_SMALL (stride); BUSY; REENTRANT; OUT_OF_MEMORY
    /// @thread reader
    pub fn carom_world_draw(world: *mut carom_world, desc: *const carom_draw_desc, dst: *mut carom_draw_line, stride: u64, capacity: u64, count: *mut u64, error: *mut carom_error) -> i32;
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE
    pub fn carom_engine_desc_init(desc: *mut carom_engine_desc, struct_size: u32) -> i32;
    /// Make an engine. @param desc may be NULL: defaults.   @owns the caller: carom_engine_destroy()
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; LIMIT (65,535 engines and worlds in all); OUT_OF_MEMORY
    pub fn carom_engine_create(desc: *const carom_engine_desc, engine: *mut *mut carom_engine, error: *mut carom_error) -> i32;
    /// Destroy an engine; its worlds, batches and devices must be gone.   @status OK; NULL_ARGUMENT; IN_USE (destroy its worlds, batches and devices first);
    /// REENTRANT   @thread writer: no other call may use the engine
    pub fn carom_engine_destroy(engine: *mut carom_engine, error: *mut carom_error) -> i32;
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE
    pub fn carom_jobs_desc_init(desc: *mut carom_jobs_desc, struct_size: u32) -> i32;
    /// Say which threads share the work of steps in the engine's worlds, before the first of them is made. Support
    /// functions are then called, and the allocator may be, on those threads; those of HOST_THREAD plugins are still called
    /// on the stepping one.
    /// @param desc may be NULL: the stepping thread alone
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; OUT_OF_RANGE; IN_USE (worlds, batches or devices are
    /// alive, or carom_pairs_distance() is under way); LIMIT (the system has no more threads); OUT_OF_MEMORY; REENTRANT
    pub fn carom_engine_set_jobs(engine: *mut carom_engine, desc: *const carom_jobs_desc, error: *mut carom_error) -> i32;
    /// Load a shape plugin from a shared object. @param path absolute.
    /// The plugin is checked before anything is called, then by its support points in 256 directions, with parameters that
    /// the bounds allow. Loading the same path twice is ALREADY_EXISTS.
    /// @status OK; NULL_ARGUMENT; PLUGIN_PATH; PLUGIN_LOAD; PLUGIN_ABI; PLUGIN_INVALID; ALREADY_EXISTS; OUT_OF_MEMORY
    pub fn carom_plugin_load(engine: *mut carom_engine, path: *const c_char, plugin: *mut carom_plugin, error: *mut carom_error) -> i32;
    /// Register a plugin by pointer: static linking, WebAssembly, or a shape written in the host's language.
    /// The struct and all it points to must outlive the engine.   @status as carom_plugin_load()
    pub fn carom_plugin_register(engine: *mut carom_engine, description: *const carom_shape_plugin, plugin: *mut carom_plugin, error: *mut carom_error) -> i32;
    /// Register the plugins of plugins/ that are linked into the library: in an archive (carom::carom_static), in
    /// WebAssembly, and where it was built with CAROM_LINK_SHAPES. Those that the engine has already are left as they are.
    /// @status OK; NULL_ARGUMENT; UNSUPPORTED (none is linked in: load files, or name shapes); LIMIT; OUT_OF_MEMORY
    pub fn carom_plugins_register_standard(engine: *mut carom_engine, error: *mut carom_error) -> i32;
    /// Forget a plugin (logically: the code stays mapped).   @status OK; NULL_ARGUMENT; IN_USE (shapes of it live);
    /// *_HANDLE; REENTRANT
    pub fn carom_plugin_unload(engine: *mut carom_engine, plugin: carom_plugin, error: *mut carom_error) -> i32;
    /// Find a loaded plugin by its id.
    /// @param id as in carom_shape_plugin.id
    /// @status OK; NULL_ARGUMENT; NOT_FOUND (load it first)
    pub fn carom_plugin_find(engine: *mut carom_engine, id: *const c_char, plugin: *mut carom_plugin, error: *mut carom_error) -> i32;
    /// The plugin's own description, as its author compiled it: documentation, declarations, function. Only fields within
    /// its struct_size are there. Valid while the engine lives.
    /// @status OK; NULL_ARGUMENT; *_HANDLE
    pub fn carom_plugin_describe(engine: *mut carom_engine, plugin: carom_plugin, description: *mut *const carom_shape_plugin, error: *mut carom_error) -> i32;
    /// Say what to collect from the next step on; nothing at first. Contacts and overlaps that there are already begin in
    /// that step.
    /// @param kinds     CAROM_EVENTS_* bits; 0: nothing
    /// @param hit_speed m/s, [0, 1e9]: contacts that approach faster are hits
    /// @status OK; NULL_ARGUMENT; UNSUPPORTED (kinds); NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT; OUT_OF_MEMORY
    pub fn carom_world_collect_events(world: *mut carom_world, kinds: u32, hit_speed: f64, error: *mut carom_error) -> i32;
    /// Copy them out, by the slots of the two colliders; of one pair END before BEGIN before HIT.
    /// @param dst      [capacity] elements `stride` bytes apart; may be NULL if capacity is 0
    /// @param stride   sizeof(carom_contact_event) as the caller knows it
    /// @param count    out: how many there are (may exceed capacity; capacity are written)
    /// @status OK; NULL_ARGUMENT; BUFFER_TOO_SMALL; OUT_OF_RANGE (stride); BUSY
    pub fn carom_world_get_contact_events(world: *mut carom_world, dst: *mut carom_contact_event, stride: u64, capacity: u64, count: *mut u64, error: *mut carom_error) -> i32;
    /// Arguments as carom_world_get_contact_events().
    pub fn carom_world_get_sensor_events(world: *mut carom_world, dst: *mut carom_sensor_event, stride: u64, capacity: u64, count: *mut u64, error: *mut carom_error) -> i32;
    /// By the slots of the bodies; arguments as carom_world_get_contact_events().
    pub fn carom_world_get_sleep_events(world: *mut carom_world, dst: *mut carom_sleep_event, stride: u64, capacity: u64, count: *mut u64, error: *mut carom_error) -> i32;
    /// By the slots of the joints; arguments as carom_world_get_contact_events().
    pub fn carom_world_get_joint_events(world: *mut carom_world, dst: *mut carom_joint_event, stride: u64, capacity: u64, count: *mut u64, error: *mut carom_error) -> i32;
    /// As they happened; arguments as carom_world_get_contact_events().
    pub fn carom_world_get_fault_events(world: *mut carom_world, dst: *mut carom_fault_event, stride: u64, capacity: u64, count: *mut u64, error: *mut carom_error) -> i32;
    /// Two colliders of different bodies touch if each one's mask has a bit of the other's category; unless both are of one
    /// group other than 0: then they do if it is positive and do not if it is negative, whatever their masks say.
    /// @param category, mask  any bits   @param group 0: none
    /// @status OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT; OUT_OF_MEMORY
    pub fn carom_collider_set_filter(world: *mut carom_world, collider: carom_collider, category: u64, mask: u64, group: i32, error: *mut carom_error) -> i32;
    /// @param category, mask, group  out   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY
    pub fn carom_collider_get_filter(world: *mut carom_world, collider: carom_collider, category: *mut u64, mask: *mut u64, group: *mut i32, error: *mut carom_error) -> i32;
    /// The same for all colliders that a body has now.   @status as carom_collider_set_filter()
    pub fn carom_body_set_filter(world: *mut carom_world, body: carom_body, category: u64, mask: u64, group: i32, error: *mut carom_error) -> i32;
    /// Let two bodies make no contacts with each other, whatever their filters say, or restore their contacts. Calls are
    /// counted: undo each one. Undoing more does nothing.
    /// @param ignored 1 or 0
    /// @status OK; NULL_ARGUMENT; *_HANDLE; OUT_OF_RANGE (ignored; a body and itself); BUSY; REENTRANT; OUT_OF_MEMORY
    pub fn carom_body_ignore_collision(world: *mut carom_world, body_a: carom_body, body_b: carom_body, ignored: u32, error: *mut carom_error) -> i32;
    /// Make a collider a sensor: it reports what overlaps it (carom_world_get_sensor_events()) and is touched by nothing.
    /// It obeys its filter, does not sense other sensors, and static sensors do not sense static bodies. Its density counts
    /// as before.
    /// @param sensor 1 or 0
    /// @status OK; NULL_ARGUMENT; *_HANDLE; OUT_OF_RANGE (sensor); BUSY; REENTRANT; OUT_OF_MEMORY
    pub fn carom_collider_set_sensor(world: *mut carom_world, collider: carom_collider, sensor: u32, error: *mut carom_error) -> i32;
    /// @param sensor out: 1 or 0   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY
    pub fn carom_collider_is_sensor(world: *mut carom_world, collider: carom_collider, sensor: *mut u32, error: *mut carom_error) -> i32;
    /// Add a force that acts at a point, for the next step only: carom_body_add_force() with its torque about the centre of
    /// mass as the body stands now.
    /// @param force [3] N, world   @param point [3] m, world
    /// @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE (the sum would overflow); BUSY; REENTRANT
    pub fn carom_body_add_force_at(world: *mut carom_world, body: carom_body, force: *const f64, point: *const f64, error: *mut carom_error) -> i32;
    /// How air resists a body: F = -(linear + quadratic |u|) u at its centre, u its velocity relative to the air. Without
    /// other forces speeds follow the closed form at any step. (carom_body_desc.linear_damping is relative to the world,
    /// not to the air, and to mass.)
    /// @param linear    kg/s, [0, 1e12]: slow, small bodies (6 pi eta r of a ball); 0 when a body is created
    /// @param quadratic kg/m, [0, 1e12]: fast, large ones, rho c_d A / 2 (a ball of 0.1 m in air: 0.0087); 0 likewise
    /// @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT; OUT_OF_MEMORY
    pub fn carom_body_set_drag(world: *mut carom_world, body: carom_body, linear: f64, quadratic: f64, error: *mut carom_error) -> i32;
    /// @param linear, quadratic out   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY
    pub fn carom_body_get_drag(world: *mut carom_world, body: carom_body, linear: *mut f64, quadratic: *mut f64, error: *mut carom_error) -> i32;
    /// How the air moves; it reaches bodies through their drag alone.
    /// @param velocity [3] m/s, |each| <= 1e6; 0 when a world is created
    /// @status OK; NULL_ARGUMENT; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT
    pub fn carom_world_set_wind(world: *mut carom_world, velocity: *const f64, error: *mut carom_error) -> i32;
    /// @status OK; NULL_ARGUMENT; BUSY
    pub fn carom_world_get_wind(world: *mut carom_world, velocity: *mut f64, error: *mut carom_error) -> i32;
    /// Static name of a kind of field ("uniform"), or "?".
    /// @param kind CAROM_FORCE_FIELD_*
    pub fn carom_force_field_name(kind: u32) -> *const c_char;
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE
    pub fn carom_force_field_desc_init(desc: *mut carom_force_field_desc, struct_size: u32) -> i32;
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; UNKNOWN_ENUM; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; BUSY;
    ///         REENTRANT; LIMIT; OUT_OF_MEMORY
    pub fn carom_force_field_create(world: *mut carom_world, desc: *const carom_force_field_desc, field: *mut carom_force_field, error: *mut carom_error) -> i32;
    /// Change a field in place: move it, turn it up.   @status as carom_force_field_create(); *_HANDLE
    pub fn carom_force_field_update(world: *mut carom_world, field: carom_force_field, desc: *const carom_force_field_desc, error: *mut carom_error) -> i32;
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; BUSY
    pub fn carom_force_field_get(world: *mut carom_world, field: carom_force_field, desc: *mut carom_force_field_desc, error: *mut carom_error) -> i32;
    /// @status OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT
    pub fn carom_force_field_destroy(world: *mut carom_world, field: carom_force_field, error: *mut carom_error) -> i32;
    /// Which fields a body feels. A field with a bit that few bodies have costs those few.
    /// @param mask 1 when a body is created; 0: none
    /// @status OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT; OUT_OF_MEMORY
    pub fn carom_body_set_force_field_mask(world: *mut carom_world, body: carom_body, mask: u32, error: *mut carom_error) -> i32;
    /// @status OK; NULL_ARGUMENT; *_HANDLE; BUSY
    pub fn carom_body_get_force_field_mask(world: *mut carom_world, body: carom_body, mask: *mut u32, error: *mut carom_error) -> i32;
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE
    pub fn carom_spring_desc_init(desc: *mut carom_spring_desc, struct_size: u32) -> i32;
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT; LIMIT;
    ///         OUT_OF_MEMORY
    pub fn carom_spring_create(world: *mut carom_world, desc: *const carom_spring_desc, spring: *mut carom_spring, error: *mut carom_error) -> i32;
    /// Change what a spring is like; its ends stay.
    /// @param rest m   @param stiffness N/m   @param damping N s/m; ranges as in carom_spring_desc
    /// @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT
    pub fn carom_spring_update(world: *mut carom_world, spring: carom_spring, rest: f64, stiffness: f64, damping: f64, error: *mut carom_error) -> i32;
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; BUSY
    pub fn carom_spring_get(world: *mut carom_world, spring: carom_spring, desc: *mut carom_spring_desc, error: *mut carom_error) -> i32;
    /// @param length out: m, as its ends stand   @param force out: N, above 0 it pulls them together, as it is set
    /// @status OK; NULL_ARGUMENT; *_HANDLE; BUSY
    pub fn carom_spring_get_state(world: *mut carom_world, spring: carom_spring, length: *mut f64, force: *mut f64, error: *mut carom_error) -> i32;
    /// Goes with its bodies, too.   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT
    pub fn carom_spring_destroy(world: *mut carom_world, spring: carom_spring, error: *mut carom_error) -> i32;
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE
    pub fn carom_water_init(water: *mut carom_water, struct_size: u32) -> i32;
    /// @param water NULL: none, as a world is created
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; BUSY; REENTRANT
    pub fn carom_world_set_water(world: *mut carom_world, water: *const carom_water, error: *mut carom_error) -> i32;
    /// @param water out   @param present out: 1 or 0; if 0, water is filled with defaults
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; BUSY
    pub fn carom_world_get_water(world: *mut carom_world, water: *mut carom_water, present: *mut u32, error: *mut carom_error) -> i32;
    /// Static name of a kind of joint ("hinge", "six_axis"), or "?". Scene files and bindings have these names.
    /// @param kind CAROM_JOINT_*
    pub fn carom_joint_kind_name(kind: u32) -> *const c_char;
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE
    pub fn carom_joint_desc_init(desc: *mut carom_joint_desc, struct_size: u32) -> i32;
    /// Not enabled; a motor with speed 0 and max_force 0, which moves nothing until that is raised.
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE
    pub fn carom_joint_limit_init(limit: *mut carom_joint_limit, struct_size: u32) -> i32;
    /// Not enabled; a motor with speed 0 and max_force 0, which moves nothing until that is raised.
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE
    pub fn carom_joint_motor_init(motor: *mut carom_joint_motor, struct_size: u32) -> i32;
    /// Not enabled; a motor with speed 0 and max_force 0, which moves nothing until that is raised.
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE
    pub fn carom_joint_spring_init(spring: *mut carom_joint_spring, struct_size: u32) -> i32;
    /// Ratio 1, anchors at the origin, the rope as long as it is.   @status OK; NULL_ARGUMENT; STRUCT_SIZE
    pub fn carom_joint_transmission_init(transmission: *mut carom_joint_transmission, struct_size: u32) -> i32;
    /// The follower goes as far as the leader.   @status OK; NULL_ARGUMENT; STRUCT_SIZE
    pub fn carom_joint_coupling_init(coupling: *mut carom_joint_coupling, struct_size: u32) -> i32;
    /// Free, without drive and spring, `max_force` and limits as large as may be.   @status OK; NULL_ARGUMENT; STRUCT_SIZE
    pub fn carom_joint_axis_init(axis: *mut carom_joint_axis, struct_size: u32) -> i32;
    /// No drive, the target as the frames are when they agree.   @status OK; NULL_ARGUMENT; STRUCT_SIZE
    pub fn carom_joint_orientation_drive_init(drive: *mut carom_joint_orientation_drive, struct_size: u32) -> i32;
    /// Join two bodies, or one and the world. Their islands wake. A body that is destroyed takes its joints with it.
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED (a newer field; solver severity; a coupling, which
    ///         carom_joint_couple() makes); UNKNOWN_ENUM; *_HANDLE; NOT_UNIT;
    ///         NOT_FINITE; OUT_OF_RANGE (also: a body joined to itself, none that is dynamic, or places 1e15 m from a
    ///         body's origin or 8e15 m from each other, as of bodies that the next step will quarantine); BUSY; REENTRANT;
    ///         LIMIT; OUT_OF_MEMORY
    pub fn carom_joint_create(world: *mut carom_world, desc: *const carom_joint_desc, joint: *mut carom_joint, error: *mut carom_error) -> i32;
    /// @status OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT
    pub fn carom_joint_destroy(world: *mut carom_world, joint: carom_joint, error: *mut carom_error) -> i32;
    /// @param desc out: as it was made, with frames in body coordinates
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; BUSY
    pub fn carom_joint_get(world: *mut carom_world, joint: carom_joint, desc: *mut carom_joint_desc, error: *mut carom_error) -> i32;
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; BUSY
    pub fn carom_joint_get_state(world: *mut carom_world, joint: carom_joint, state: *mut carom_joint_state, error: *mut carom_error) -> i32;
    /// Set a limit, a motor, a spring of a coordinate that the joint's kind leaves free; its bodies wake.
    /// @param coordinate CAROM_COORDINATE_*
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; UNSUPPORTED (the kind has no such coordinate; a swing has a
    ///         limit alone); *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT
    pub fn carom_joint_set_limit(world: *mut carom_world, joint: carom_joint, coordinate: u32, limit: *const carom_joint_limit, error: *mut carom_error) -> i32;
    /// Set a limit, a motor, a spring of a coordinate that the joint's kind leaves free; its bodies wake.
    /// @param coordinate CAROM_COORDINATE_*
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; UNSUPPORTED (the kind has no such coordinate; a swing has a
    ///         limit alone); *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT
    pub fn carom_joint_set_motor(world: *mut carom_world, joint: carom_joint, coordinate: u32, motor: *const carom_joint_motor, error: *mut carom_error) -> i32;
    /// Set a limit, a motor, a spring of a coordinate that the joint's kind leaves free; its bodies wake.
    /// @param coordinate CAROM_COORDINATE_*
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; UNSUPPORTED (the kind has no such coordinate; a swing has a
    ///         limit alone); *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT
    pub fn carom_joint_set_spring(world: *mut carom_world, joint: carom_joint, coordinate: u32, spring: *const carom_joint_spring, error: *mut carom_error) -> i32;
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; UNSUPPORTED; *_HANDLE; BUSY
    pub fn carom_joint_get_limit(world: *mut carom_world, joint: carom_joint, coordinate: u32, limit: *mut carom_joint_limit, error: *mut carom_error) -> i32;
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; UNSUPPORTED; *_HANDLE; BUSY
    pub fn carom_joint_get_motor(world: *mut carom_world, joint: carom_joint, coordinate: u32, motor: *mut carom_joint_motor, error: *mut carom_error) -> i32;
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; UNSUPPORTED; *_HANDLE; BUSY
    pub fn carom_joint_get_spring(world: *mut carom_world, joint: carom_joint, coordinate: u32, spring: *mut carom_joint_spring, error: *mut carom_error) -> i32;
    /// Say what a pulley's rope runs over, or how a gear's wheels turn; the bodies wake. What a limit, motor or spring on a
    /// pulley's distance requires is in metres of the rope. A gear holds from where its wheels stand now, as often as they
    /// may turn: turns are counted while it steps, as long as a wheel's speed changes by less than half a turn a substep in
    /// one; a pose that the host sets between steps is no turn.
    /// Accuracy: second order in the substep, as all joints; the rope's length errs by what joint_frequency leaves, and
    /// under the direct solver by 1e-9 m; a gear's angles err by rounding, a few 1e-16 rad a substep. Oracle:
    /// tests/oracle/test_pulley_gear.
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED (the joint is neither pulley nor gear; a newer field); *_HANDLE;
    ///         NOT_FINITE; OUT_OF_RANGE (also: a ratio of 0; 1 is what the init function gives); BUSY; REENTRANT
    pub fn carom_joint_set_transmission(world: *mut carom_world, joint: carom_joint, transmission: *const carom_joint_transmission, error: *mut carom_error) -> i32;
    /// @param transmission out: as it was set, with its length; ratio 0: not yet
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; *_HANDLE; BUSY
    pub fn carom_joint_get_transmission(world: *mut carom_world, joint: carom_joint, transmission: *mut carom_joint_transmission, error: *mut carom_error) -> i32;
    /// Couple two joints: makes a joint of kind CAROM_JOINT_COUPLING, whose bodies are one of each joint's. Their islands
    /// wake. It goes with either joint that is destroyed, and holds nothing once one of them is broken. What it is off by,
    /// as it is made or because a host moves joints, is led back. It has no frames and never breaks itself.
    /// carom_joint_state of it: `gap` or `angle` is how far the follower is off; force is 0, torque[0] the N or N m along the
    /// follower's coordinate that it pushes with, mean over the last step.
    /// Accuracy: as of locks: second order in the substep, 1e-9 m or rad under the direct solver, rounding where dial
    /// joint_order moves it. Oracle: tests/oracle/test_couplings.
    /// @param joint out: the coupling
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED (a joint that is neither hinge nor slider; a newer field; a
    ///         reserved one; solver severity); *_HANDLE; NOT_FINITE; OUT_OF_RANGE (also: a joint that follows itself); BUSY;
    ///         REENTRANT; LIMIT; OUT_OF_MEMORY
    pub fn carom_joint_couple(world: *mut carom_world, coupling: *const carom_joint_coupling, joint: *mut carom_joint, error: *mut carom_error) -> i32;
    /// Give a coupling another polynomial; its bodies wake.
    /// @param coupling its follower and leader are CAROM_NULL_HANDLE or as they were, its user is not read
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED (the joint is no coupling; other joints than its own; a newer
    ///         field; a reserved one); *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT
    pub fn carom_joint_set_coupling(world: *mut carom_world, joint: carom_joint, coupling: *const carom_joint_coupling, error: *mut carom_error) -> i32;
    /// @param coupling out: as it was made
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; *_HANDLE; BUSY
    pub fn carom_joint_get_coupling(world: *mut carom_world, joint: carom_joint, coupling: *mut carom_joint_coupling, error: *mut carom_error) -> i32;
    /// Say what one axis of a six-axis joint, a hinge or a slider does; the bodies wake. Effect joint_limits has its limits, joint_motors its
    /// drives; springs and locks are of the joint. A target, a lock's place or a limit may be set anew before each step.
    /// Accuracy: what is locked errs in second order of the substep h, under the direct solver by 1e-9 m or rad. With w the
    /// frequency and b half the damping per mass: springs, stops and drives to a position swing late by w h / 2 of their
    /// amplitude and fade slower by b h of their rate; at rest they sag by load / stiffness, to rounding where one joint
    /// bears all, in first order where soft_step sweeps over several. A drive to a velocity holds that of the middle of a
    /// substep under the direct solver, and one with a damping alone does under any: what a step ends with differs by what
    /// the load does in h / 2. Forces of drives are met to rounding. A speed limit holds to 1e-9 under the
    /// direct solver, where one joint bears all to rounding under others. Oracle: tests/oracle/test_six_axis, test_six_axis_scenes, test_armature,
    /// test_axis_limits.
    /// @param axis CAROM_AXIS_*
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; UNSUPPORTED (the joint has no such axis of its own; a newer field);
    ///         *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT
    pub fn carom_joint_set_axis(world: *mut carom_world, joint: carom_joint, axis: u32, desc: *const carom_joint_axis, error: *mut carom_error) -> i32;
    /// @param axis CAROM_AXIS_*   @param desc out: as it was set
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; UNSUPPORTED; *_HANDLE; BUSY
    pub fn carom_joint_get_axis(world: *mut carom_world, joint: carom_joint, axis: u32, desc: *mut carom_joint_axis, error: *mut carom_error) -> i32;
    /// Drive a ball, or a six-axis joint, to an orientation or to an angular velocity; the bodies wake. Of effect
    /// joint_motors. Accuracy: first order in the substep of where it is, as springs with dampers are; where nothing pulls
    /// it ends at the target to rounding. Oracle: tests/oracle/test_six_axis.
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; UNSUPPORTED (the joint is neither ball nor six-axis; a newer
    ///         field; a reserved one); *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; BUSY; REENTRANT
    pub fn carom_joint_set_orientation_drive(world: *mut carom_world, joint: carom_joint, drive: *const carom_joint_orientation_drive, error: *mut carom_error) -> i32;
    /// @param drive out: as it was set
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; *_HANDLE; BUSY
    pub fn carom_joint_get_orientation_drive(world: *mut carom_world, joint: carom_joint, drive: *mut carom_joint_orientation_drive, error: *mut carom_error) -> i32;
    /// How many scalars a record of a field has.
    /// @param field CAROM_JOINT_BULK_*   @param width out: of a record   @status OK; NULL_ARGUMENT; UNKNOWN_ENUM
    pub fn carom_joint_bulk_width(field: u32, width: *mut u32) -> i32;
    /// Read one field of n joints, as carom_world_read() does of bodies.
    /// A rate of what has no direction (points or axes that agree) is the one at which it begins to grow.
    /// Accuracy: rounding of poses and velocities; of a twist times 1 / cos(swing / 2). An effort errs in first order of the
    /// step, by how far the axis turned in it. Oracle: tests/abi/test_joint_bulk.
    /// @param field   CAROM_JOINT_BULK_*   @param scalar CAROM_SCALAR_*
    /// @param joints  [n], or NULL for all in the order of carom_world_get_joints() (n must be their number)
    /// @param dst     n records of the field's scalars, `stride` bytes apart; stride 0: tightly packed
    /// @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; *_HANDLE (nothing is written); UNSUPPORTED (a kind without the field);
    /// OUT_OF_RANGE (n); BUFFER_TOO_SMALL (stride); BUSY
    pub fn carom_world_read_joints(world: *mut carom_world, field: u32, scalar: u32, joints: *const carom_joint, n: u64, dst: *mut c_void, stride: u64, error: *mut carom_error) -> i32;
    /// Write one field of n joints; all values are validated before the first is written, joints of a tree are moved as one.
    /// Accuracy of places: rounding of poses, to 1e-15 of a chain's length a joint. Oracle: tests/oracle/test_joint_moves. Modes, units of gains and what is
    /// enabled stay as they are, where the record does not have them. Bodies of joints that this changes wake. Arguments as carom_world_read_joints().
    /// @param src n records of the field's scalars, `stride` bytes apart; stride 0: tightly packed
    /// @status as carom_world_read_joints(); UNSUPPORTED (also: a field that is read only; a joint of a loop, a broken one,
    /// one between bodies that forces do not move); NOT_FINITE; NOT_UNIT;
    /// OUT_OF_RANGE; REENTRANT
    pub fn carom_world_write_joints(world: *mut carom_world, field: u32, scalar: u32, joints: *const carom_joint, n: u64, src: *const c_void, stride: u64, error: *mut carom_error) -> i32;
    /// Number of joints, and their handles in creation order of the slots.
    /// @param joints [capacity] or NULL   @param count out: how many there are
    /// @status OK; NULL_ARGUMENT; BUSY
    pub fn carom_world_get_joints(world: *mut carom_world, joints: *mut carom_joint, capacity: u64, count: *mut u64, error: *mut carom_error) -> i32;
    /// Keep a ledger from now on, anew if one is kept; or none. Off in a new world.
    /// @param on  0 or 1
    /// @status OK; NULL_ARGUMENT; UNKNOWN_ENUM (on); BUSY; REENTRANT; OUT_OF_MEMORY: as it was
    pub fn carom_world_enable_ledger(world: *mut carom_world, on: u32, error: *mut carom_error) -> i32;
    /// Copy out all causes, in the order above; none of a world that keeps no ledger.
    /// @param dst      [capacity] elements `stride` bytes apart; may be NULL if capacity is 0
    /// @param stride   sizeof(carom_ledger_entry) as the caller knows it
    /// @param count    out: how many there are (may exceed capacity; capacity are written)
    /// @status OK; NULL_ARGUMENT; BUFFER_TOO_SMALL; OUT_OF_RANGE (stride); BUSY
    pub fn carom_world_get_ledger(world: *mut carom_world, dst: *mut carom_ledger_entry, stride: u64, capacity: u64, count: *mut u64, error: *mut carom_error) -> i32;
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; BUSY
    pub fn carom_world_get_ledger_state(world: *mut carom_world, state: *mut carom_ledger_state, error: *mut carom_error) -> i32;
    /// Signed distance of each pair, on the engine's threads (carom_engine_set_jobs()). Each result has the bits that
    /// carom_shape_distance() gives for its pair, for any number of threads. All pairs are checked before the first result
    /// is written, and a message names the pair that is wrong. A pair whose support function misbehaves says so in its
    /// status (CAROM_QUERY_FAULT), and spoils no other. Nothing is allocated per pair.
    /// @param desc   may be NULL: defaults
    /// @param dst    out, [pairs->count]; no array of pairs
    /// @param stride sizeof(carom_distance) as the caller knows it; an older, shorter one gets its beginning. struct_size is
    ///               written, too
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; UNKNOWN_ENUM; UNSUPPORTED (a
    ///         pair of half-spaces or sceneries); BUFFER_TOO_SMALL (a stride); OUT_OF_MEMORY; INTERNAL (a callback left its
    ///         thread: some results were written)
    /// @since 0.9
    pub fn carom_pairs_distance(engine: *mut carom_engine, pairs: *const carom_pairs, desc: *const carom_distance_desc, dst: *mut carom_distance, stride: u64, error: *mut carom_error) -> i32;
    /// Open a device. Its arithmetic is tried, and it is refused where a number is rounded otherwise than on the host.
    /// @param index  among all devices of all platforms, in the order in which the system has them; 0 is the first
    /// @param device out: to be destroyed before the engine   @owns the caller: carom_device_destroy()
    /// @status OK; NULL_ARGUMENT; NOT_FOUND (no OpenCL, or no such device: the message says how many there are); UNSUPPORTED
    ///         (it has no double precision, or rounds otherwise); OUT_OF_MEMORY
    /// @since 0.9
    pub fn carom_device_create(engine: *mut carom_engine, index: u32, device: *mut *mut carom_device, error: *mut carom_error) -> i32;
    /// @param device from carom_device_create()   @status OK; NULL_ARGUMENT; BUSY; REENTRANT   @since 0.9
    pub fn carom_device_destroy(device: *mut carom_device, error: *mut carom_error) -> i32;
    /// @param device from carom_device_create()   @status OK; NULL_ARGUMENT; STRUCT_SIZE; BUSY   @since 0.9
    pub fn carom_device_get_info(device: *mut carom_device, info: *mut carom_device_info, error: *mut carom_error) -> i32;
    /// As carom_pairs_distance(), on a device: each result has the same bits. Shapes are of the device's engine.
    /// @param device from carom_device_create()
    /// @param desc   may be NULL: defaults
    /// @param dst    out, [pairs->count]; no array of pairs
    /// @param stride as carom_pairs_distance()
    /// @status as carom_pairs_distance(); UNSUPPORTED (a shape that a device cannot ask; CAROM_SIMPLEX_JOHNSON and routines of
    ///         pairs, which devices have not; a driver that failed: some results may be written); BUSY; REENTRANT
    /// @since 0.9
    pub fn carom_device_pairs_distance(device: *mut carom_device, pairs: *const carom_pairs, desc: *const carom_distance_desc, dst: *mut carom_distance, stride: u64, error: *mut carom_error) -> i32;
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE
    pub fn carom_particles_desc_init(desc: *mut carom_particles_desc, struct_size: u32) -> i32;
    /// Make an empty set.
    /// @param desc may be NULL: defaults
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT; LIMIT; OUT_OF_MEMORY
    pub fn carom_particles_create(world: *mut carom_world, desc: *const carom_particles_desc, set: *mut carom_particles, error: *mut carom_error) -> i32;
    /// Its particles too.   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT
    pub fn carom_particles_destroy(world: *mut carom_world, set: carom_particles, error: *mut carom_error) -> i32;
    /// @param desc out: as it was made or updated; capacity: particles there is memory for
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; BUSY
    pub fn carom_particles_get(world: *mut carom_world, set: carom_particles, desc: *mut carom_particles_desc, error: *mut carom_error) -> i32;
    /// Change what they have in common; particles that are there keep their mass.
    /// @param desc may be NULL: defaults; capacity: memory for so many in all
    /// @status as carom_particles_create(); *_HANDLE
    pub fn carom_particles_update(world: *mut carom_world, set: carom_particles, desc: *const carom_particles_desc, error: *mut carom_error) -> i32;
    /// @param count out: particles in the set   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY
    pub fn carom_particles_get_count(world: *mut carom_world, set: carom_particles, count: *mut u64, error: *mut carom_error) -> i32;
    /// Add n particles at the end; all values are checked before the first is added.
    /// @param scalar          CAROM_SCALAR_*, of both arrays
    /// @param positions       [n] m, world, three scalars each, within 1e15 m of the origin
    /// @param position_stride bytes from one to the next; 0: tightly packed
    /// @param velocities      [n] m/s, world, likewise, at most 1e9 m/s; NULL: at rest
    /// @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUFFER_TOO_SMALL (stride); LIMIT (2^31
    ///         - 1 in a set); BUSY; REENTRANT; OUT_OF_MEMORY
    pub fn carom_particles_add(world: *mut carom_world, set: carom_particles, n: u64, scalar: u32, positions: *const c_void, position_stride: u64, velocities: *const c_void, velocity_stride: u64, error: *mut carom_error) -> i32;
    /// Remove n particles. The others keep their order, so each moves up by as many as went before it.
    /// @param indices [n] ascending, each once; NULL: all of them (n must be their number)
    /// @status OK; NULL_ARGUMENT; *_HANDLE; OUT_OF_RANGE (an index, their order, n); BUSY; REENTRANT
    pub fn carom_particles_remove(world: *mut carom_world, set: carom_particles, indices: *const u32, n: u64, error: *mut carom_error) -> i32;
    /// Read one field of n particles.
    /// @param field   CAROM_FIELD_POSITION, LINEAR_VELOCITY or MASS
    /// @param indices [n] in any order, or NULL: all of them (n must be their number)
    /// @param dst     n records of the field's scalars, `stride` bytes apart
    /// @param stride  bytes from one record to the next; 0: tightly packed
    /// @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; UNSUPPORTED (a field that particles do not have); *_HANDLE; OUT_OF_RANGE
    ///         (an index, n); BUFFER_TOO_SMALL (stride); BUSY
    pub fn carom_particles_read(world: *mut carom_world, set: carom_particles, field: u32, scalar: u32, indices: *const u32, n: u64, dst: *mut c_void, stride: u64, error: *mut carom_error) -> i32;
    /// Write one field of n particles; all values are checked before the first is written, bounds as carom_particles_add(),
    /// masses as carom_particles_desc. Arguments as carom_particles_read(); where an index comes twice, the last counts.
    /// @param src n records of the field's scalars, `stride` bytes apart
    /// @status as carom_particles_read(); NOT_FINITE; OUT_OF_RANGE; REENTRANT; OUT_OF_MEMORY
    pub fn carom_particles_write(world: *mut carom_world, set: carom_particles, field: u32, scalar: u32, indices: *const u32, n: u64, src: *const c_void, stride: u64, error: *mut carom_error) -> i32;
    /// A particle that has come further than 1e15 m or become faster than 1e9 m/s is put in quarantine: it is held still
    /// where it is and counts in no energy, until a host writes its position or removes it. carom_world_get_faults()
    /// reports the first of each set and step (CAROM_FAULT_PARTICLE_STATE), this call all that are held now, ascending.
    /// @param indices [capacity] out; may be NULL if capacity is 0
    /// @param count   out: how many there are (may exceed capacity; capacity are written)
    /// @status OK; NULL_ARGUMENT; *_HANDLE; BUSY
    pub fn carom_particles_get_quarantined(world: *mut carom_world, set: carom_particles, indices: *mut u32, capacity: u64, count: *mut u64, error: *mut carom_error) -> i32;
    /// Number of sets, and their handles in creation order of the slots.
    /// @param sets [capacity] or NULL   @param count out: how many there are
    /// @status OK; NULL_ARGUMENT; BUSY
    pub fn carom_world_get_particles(world: *mut carom_world, sets: *mut carom_particles, capacity: u64, count: *mut u64, error: *mut carom_error) -> i32;
    /// Static name of an effect ("gravity"), or "?".
    pub fn carom_effect_name(effect: u32) -> *const c_char;
    /// Forbid or force an effect from the next step on, for all bodies. Wakes all bodies. Forbidding one that the scene
    /// needs is allowed, and carom_world_get_plan() says so.
    /// @param effect CAROM_EFFECT_*   @param mode CAROM_MODE_*
    /// @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; BUSY; REENTRANT
    pub fn carom_world_set_effect(world: *mut carom_world, effect: u32, mode: u32, error: *mut carom_error) -> i32;
    /// @param mode out   @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; BUSY
    pub fn carom_world_get_effect(world: *mut carom_world, effect: u32, mode: *mut u32, error: *mut carom_error) -> i32;
    /// The same for one body: its forces, its colliders, the contacts, joints and springs it is in. What is forbidden for
    /// the world is forbidden for it. Particles, events and the ledger are not a body's.
    /// @param mode CAROM_MODE_*
    /// @status OK; NULL_ARGUMENT; *_HANDLE; UNKNOWN_ENUM; UNSUPPORTED (PARTICLES, EVENTS, LEDGER: use
    ///         carom_world_set_effect()); BUSY; REENTRANT; OUT_OF_MEMORY
    pub fn carom_body_set_effect(world: *mut carom_world, body: carom_body, effect: u32, mode: u32, error: *mut carom_error) -> i32;
    /// @param mode out: of the body itself   @status OK; NULL_ARGUMENT; *_HANDLE; UNKNOWN_ENUM; BUSY
    pub fn carom_body_get_effect(world: *mut carom_world, body: carom_body, effect: u32, mode: *mut u32, error: *mut carom_error) -> i32;
    /// Whether each force effect is timed by itself in carom_world_get_plan(), which costs two looks at the clock for each.
    /// @param on 1 or 0 (as a world is created)
    /// @status OK; NULL_ARGUMENT; OUT_OF_RANGE; BUSY; REENTRANT
    pub fn carom_world_time_effects(world: *mut carom_world, on: u32, error: *mut carom_error) -> i32;
    /// Copy out the plan of the last step: stages first, then effects. Before the first step nothing has run.
    /// @param dst      [capacity] elements `stride` bytes apart; may be NULL if capacity is 0
    /// @param stride   sizeof(carom_plan_line) as the caller knows it
    /// @param count    out: how many there are (may exceed capacity; capacity are written)
    /// @status OK; NULL_ARGUMENT; BUFFER_TOO_SMALL; OUT_OF_RANGE (stride); BUSY
    pub fn carom_world_get_plan(world: *mut carom_world, dst: *mut carom_plan_line, stride: u64, capacity: u64, count: *mut u64, error: *mut carom_error) -> i32;
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE
    pub fn carom_distance_desc_init(desc: *mut carom_distance_desc, struct_size: u32) -> i32;
    /// Signed distance of two shapes.
    /// @param position_*     [3] m     @param orientation_* [4] x, y, z, w
    /// @param desc   may be NULL: defaults     @param result struct_size set by the caller
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; UNKNOWN_ENUM;
    ///         UNSUPPORTED (two half-spaces)
    pub fn carom_shape_distance(engine: *mut carom_engine, shape_a: carom_shape, position_a: *const f64, orientation_a: *const f64, shape_b: carom_shape, position_b: *const f64, orientation_b: *const f64, desc: *const carom_distance_desc, result: *mut carom_distance, error: *mut carom_error) -> i32;
    /// Record a world from now on, until carom_world_record_end() or until it is destroyed.
    /// @param flags CAROM_RECORD_*   @param write is kept, and called with `user`
    /// @status OK; NULL_ARGUMENT; UNSUPPORTED (flags); IN_USE (it is being recorded); WRITE_FAILED; BUSY; REENTRANT;
    ///         OUT_OF_MEMORY
    pub fn carom_world_record_begin(world: *mut carom_world, flags: u32, write: carom_write_fn, user: *mut c_void, error: *mut carom_error) -> i32;
    /// Stop recording.
    /// @status OK; NULL_ARGUMENT; NOT_FOUND (it is not being recorded); WRITE_FAILED (`write` said so, now or before: the
    ///         recording ends there); OUT_OF_MEMORY (likewise, for lack of memory); BUSY; REENTRANT
    pub fn carom_world_record_end(world: *mut carom_world, error: *mut carom_error) -> i32;
    /// Compare a world with a snapshot, between steps; of a world of the same structure. Reads only.
    /// @param difference its struct_size set by the caller
    /// @param bytes [size] of carom_world_save()   @param size number of bytes
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; CORRUPT, UNSUPPORTED, MISMATCH (as carom_world_restore()); BUSY; REENTRANT;
    ///         OUT_OF_MEMORY   @thread reader
    pub fn carom_world_compare(world: *mut carom_world, bytes: *const c_void, size: u64, difference: *mut carom_difference, error: *mut carom_error) -> i32;
    /// @param residuals with its struct_size set; filled. Before the first step, and after a step without contacts, what
    ///                  concerns them is 0.
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; BUSY
    /// @accuracy rounding; effective masses are those along the normal
    /// @cost linear in contact points, joints and bodies
    pub fn carom_world_get_residuals(world: *mut carom_world, residuals: *mut carom_residuals, error: *mut carom_error) -> i32;
    /// Choose the dial `substeps` before each step so that steps take about `seconds`. What a substep costs is learnt from
    /// the last steps; if one took too long, substeps drop at once; if there is time left, one is added a step.
    /// Trajectories then depend on the machine's speed: two runs are not the same to the bit. Off (as a world is created)
    /// for lockstep and tests. The steps of a scene that is too expensive even with `fewest` take longer. A budget is the
    /// host's: no snapshot holds it, a copy begins without one, and a record (carom/record.h) has the substeps that it
    /// chose.
    /// @param seconds  s of wall clock a step, 0 < seconds <= 10; 0: off, the dial keeps its value
    /// @param fewest, most  substeps, 1 <= fewest <= most <= the dial's bound; ignored when off
    /// @status OK; NULL_ARGUMENT; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT; OUT_OF_MEMORY
    pub fn carom_world_set_budget(world: *mut carom_world, seconds: f64, fewest: u32, most: u32, error: *mut carom_error) -> i32;
    /// @param seconds, fewest, most  out: as set; 0 when off   @status OK; NULL_ARGUMENT; BUSY
    pub fn carom_world_get_budget(world: *mut carom_world, seconds: *mut f64, fewest: *mut u32, most: *mut u32, error: *mut carom_error) -> i32;
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE
    pub fn carom_mesh_desc_init(desc: *mut carom_mesh_desc, struct_size: u32) -> i32;
    /// Make scenery of a mesh. All is copied.
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; NOT_FINITE; OUT_OF_RANGE (a count, an index, a vertex too far
    ///         out, no triangle that has an area); LIMIT; OUT_OF_MEMORY
    pub fn carom_shape_create_mesh(engine: *mut carom_engine, desc: *const carom_mesh_desc, shape: *mut carom_shape, error: *mut carom_error) -> i32;
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE
    pub fn carom_height_field_desc_init(desc: *mut carom_height_field_desc, struct_size: u32) -> i32;
    /// Make scenery of a height field. All is copied.
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; NOT_FINITE (an infinite height, a spacing); OUT_OF_RANGE (a
    ///         count, a spacing that is not positive, a height too far out, nothing but holes); LIMIT; OUT_OF_MEMORY
    pub fn carom_shape_create_height_field(engine: *mut carom_engine, desc: *const carom_height_field_desc, shape: *mut carom_shape, error: *mut carom_error) -> i32;
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE (set info->struct_size); *_HANDLE; UNSUPPORTED (a convex shape)
    pub fn carom_shape_get_scenery_info(engine: *mut carom_engine, shape: carom_shape, info: *mut carom_scenery_info, error: *mut carom_error) -> i32;
    /// Copy out triangles of scenery, for drawing: each by its three corners, as its surface faces. Holes are left out.
    /// @param first   number of the first triangle wanted
    /// @param corners [9 count] m, shape frame, or NULL to count
    /// @param count   in: how many fit; out: how many were written (with NULL: how many there are from `first` on)
    /// @param next    out: the number of the triangle to go on from; the number of triangles when all have been seen
    /// @status OK; NULL_ARGUMENT; *_HANDLE; OUT_OF_RANGE (first); UNSUPPORTED (a convex shape)
    pub fn carom_shape_get_triangles(engine: *mut carom_engine, shape: carom_shape, first: u64, corners: *mut f64, count: *mut u64, next: *mut u64, error: *mut carom_error) -> i32;
    /// Make a shape. The parameters are copied. The support function is checked for these parameters (finite, repeatable,
    /// scale-free, samples in convex position), declarations are verified, and AABB and mass properties derived.
    /// @param params [count] doubles, meaning as the plugin documents
    /// @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE (count or a bound; argument says which);
    ///         PLUGIN_INVALID; DECLARATION_FALSE; OUT_OF_MEMORY
    pub fn carom_shape_create(engine: *mut carom_engine, plugin: carom_plugin, params: *const f64, count: u64, shape: *mut carom_shape, error: *mut carom_error) -> i32;
    /// Make a shape by the name of its plugin: "box", or "carom.box", or the id of a plugin of yours. Plugins that the
    /// engine has come first, by id, then by the name of the file they were loaded from. Then a file NAME.so is looked for
    /// and loaded: in the folders of $CAROM_PLUGIN_PATH (absolute, separated by ':'; not in programs that run with raised
    /// privileges), beside the library, in the folder where plugins are installed. "half_space" is built in: normal x, y,
    /// z, offset.
    /// @param name 1 to 64 letters, digits, _, - and dots   @param params [count] as carom_shape_create()
    /// @status OK; NULL_ARGUMENT; NOT_FOUND (the message says where it was looked for); NOT_FINITE; OUT_OF_RANGE;
    ///         PLUGIN_PATH; PLUGIN_LOAD; PLUGIN_ABI; PLUGIN_INVALID; DECLARATION_FALSE; LIMIT; OUT_OF_MEMORY
    pub fn carom_shape_create_named(engine: *mut carom_engine, name: *const c_char, params: *const f64, count: u64, shape: *mut carom_shape, error: *mut carom_error) -> i32;
    /// The built-in half-space { x : normal . x <= offset } in the shape's own frame; unbounded, so static bodies only.
    /// @param normal [3] unit (within 1e-6)   @param offset m
    /// @status OK; NULL_ARGUMENT; NOT_FINITE; NOT_UNIT; OUT_OF_MEMORY
    pub fn carom_shape_create_half_space(engine: *mut carom_engine, normal: *const f64, offset: f64, shape: *mut carom_shape, error: *mut carom_error) -> i32;
    /// Make the convex hull of shapes that the engine has, each placed and scaled, and all of it rounded by a radius. The
    /// same call makes
    /// - the sweep of a shape along a straight line, without turning: the shape at both ends. Where it turns as well, the hull
    ///   of both ends leaves out what bulges between them: add poses in between;
    /// - a scaled shape: one part with a scale. A negative scale mirrors it;
    /// - a rounded shape: one part and a radius, by which it grows on all sides.
    /// Where all parts have corners only and the radius is 0, the hull is a polytope with exact mass and faces, and its
    /// corners are its parameters. Else its parameters are none and its mass is derived. A part cannot be destroyed before
    /// the hull.
    /// @param parts         [count] handles of convex shapes, the same one as often as wanted
    /// @param count         1 to 4096
    /// @param positions     [3 * count] m, frame of the hull; NULL: 0
    /// @param orientations  [4 * count] x, y, z, w, unit within 1e-6, part to hull; NULL: identity
    /// @param scales        [3 * count] along the axes of the part, of a size of 1e-6 to 1e6; NULL: 1
    /// @param radius        m, 0 or more
    /// @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; UNSUPPORTED (a part is a half-space or scenery);
    ///         PLUGIN_INVALID; LIMIT (hulls of hulls more than 8 deep, or of more than 4096 parts in all); OUT_OF_MEMORY
    /// @since 0.9
    pub fn carom_shape_create_hull_of(engine: *mut carom_engine, parts: *const carom_shape, count: u64, positions: *const f64, orientations: *const f64, scales: *const f64, radius: f64, shape: *mut carom_shape, error: *mut carom_error) -> i32;
    /// What a hull of shapes is made of, as it was given. Of any other shape: no parts, radius 0.
    /// @param parts         [*count] or NULL: only count and radius are written
    /// @param positions     [3 * *count] m, or NULL   @param orientations [4 * *count] x, y, z, w, or NULL
    /// @param scales        [3 * *count] or NULL
    /// @param count         in: capacity in parts; out: number of parts
    /// @param radius        m, or NULL
    /// @status OK; NULL_ARGUMENT; *_HANDLE; BUFFER_TOO_SMALL (count says how many are needed)
    /// @since 0.9
    pub fn carom_shape_get_parts(engine: *mut carom_engine, shape: carom_shape, parts: *mut carom_shape, positions: *mut f64, orientations: *mut f64, scales: *mut f64, count: *mut u64, radius: *mut f64, error: *mut carom_error) -> i32;
    /// @status OK; NULL_ARGUMENT; *_HANDLE; IN_USE (a collider, a hull of shapes, or a query on another thread, refers to
    ///         it); REENTRANT
    pub fn carom_shape_destroy(engine: *mut carom_engine, shape: carom_shape, error: *mut carom_error) -> i32;
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE (set info->struct_size); *_HANDLE
    pub fn carom_shape_get_info(engine: *mut carom_engine, shape: carom_shape, info: *mut carom_shape_info, error: *mut carom_error) -> i32;
    /// Copy out the parameters. @param count in: capacity of params; out: number of parameters.
    /// @param params [count]
    /// @status OK; NULL_ARGUMENT; *_HANDLE; BUFFER_TOO_SMALL (count says how many are needed)
    pub fn carom_shape_get_params(engine: *mut carom_engine, shape: carom_shape, params: *mut f64, count: *mut u64, error: *mut carom_error) -> i32;
    /// Support points of the whole shape, core radius included, for n directions at once.
    /// @param dirs [3n] nonzero, any length, shape frame   @param points [3n] m, shape frame
    /// @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE (a zero direction); UNSUPPORTED (half-space,
    ///         scenery); PLUGIN_INVALID (the support function failed; the points before are written)
    pub fn carom_shape_support(engine: *mut carom_engine, shape: carom_shape, dirs: *const f64, n: u64, points: *mut f64, error: *mut carom_error) -> i32;
    /// Write a snapshot, between steps. Reads only: other readers may be at work.
    /// @param flags    CAROM_SNAPSHOT_*
    /// @param buffer   [capacity] bytes, or NULL to get the size alone
    /// @param capacity bytes; 0 if buffer is NULL
    /// @param needed   out: bytes of the snapshot; written, too, when the buffer is too small (nothing else is)
    /// @status OK; NULL_ARGUMENT; UNSUPPORTED (flags); BUFFER_TOO_SMALL; BUSY; REENTRANT; OUT_OF_MEMORY   @thread reader
    pub fn carom_world_save(world: *mut carom_world, flags: u32, buffer: *mut c_void, capacity: u64, needed: *mut u64, error: *mut carom_error) -> i32;
    /// Put a snapshot back, between steps. All of it is read and checked, and all memory that it takes is there, before
    /// anything of the world changes.
    /// An empty world is rebuilt from a snapshot that is whole; `user` values come with it, a ledger
    /// begins anew. Shapes of the same plugin and numbers that the engine has are used, others made; they are the engine's,
    /// as if the host had made them (carom_collider_get() gives their handles). Any other world takes its state, as of one
    /// that is not whole.
    /// @param bytes [size], of any alignment   @param size as carom_world_save() gave it
    /// @status OK; NULL_ARGUMENT; CORRUPT (damaged, cut off, or no snapshot: the message says what); UNSUPPORTED (of a
    /// newer
    ///         format); MISMATCH (of a world of another structure: the message names the kind that differs; or a plugin of
    ///         that id and version makes other shapes than it did); NOT_FOUND (a shape plugin is not loaded: the message
    ///         says id and version); LIMIT; BUSY; REENTRANT; OUT_OF_MEMORY
    pub fn carom_world_restore(world: *mut carom_world, bytes: *const c_void, size: u64, error: *mut carom_error) -> i32;
    /// Make a world of the same engine that is as this one is, and goes on as it does, bit for bit. Nothing of this one
    /// changes; other readers may be at work. Lists and residuals of its last step, and a ledger, the copy has none of.
    /// @param copy out: to be destroyed as any world
    /// @status OK; NULL_ARGUMENT; LIMIT; BUSY; REENTRANT; OUT_OF_MEMORY   @thread reader
    pub fn carom_world_fork(world: *mut carom_world, copy: *mut *mut carom_world, error: *mut carom_error) -> i32;
    /// Handles of another world, as they are in this one: the same slots and generations. For what a host keeps of a world
    /// that it has forked, or of one that was saved whole, in another process too.
    /// @param handles    [n] of bodies, colliders, materials, joints, particles, fields, springs; 0 stays 0
    /// @param translated [n] out; may be `handles`. All of them or, where one is refused, none
    /// @status OK; NULL_ARGUMENT; INVALID_HANDLE; STALE_HANDLE; WRONG_KIND (of an engine: shapes are the same in all its
    ///         worlds); BUSY; REENTRANT   @thread reader
    pub fn carom_world_translate_handles(world: *mut carom_world, handles: *const u64, n: u64, translated: *mut u64, error: *mut carom_error) -> i32;
    /// Copy out what the coordinates of a tree are.
    /// @param body     any dynamic body of the tree; its base, where nothing holds the tree
    /// @param dst      [capacity] elements `stride` bytes apart; may be NULL if capacity is 0
    /// @param stride   sizeof(carom_tree_coordinate) as the caller knows it
    /// @param count    out: how many there are (may exceed capacity; capacity are written)
    /// @status OK; NULL_ARGUMENT; *_HANDLE; OUT_OF_RANGE (the body is not moved by forces); UNSUPPORTED (no tree);
    ///         BUFFER_TOO_SMALL (stride); BUSY; OUT_OF_MEMORY
    pub fn carom_tree_get_coordinates(world: *mut carom_world, body: carom_body, dst: *mut carom_tree_coordinate, stride: u64, capacity: u64, count: *mut u64, error: *mut carom_error) -> i32;
    /// The speeds that a tree has now.
    /// Accuracy: rounding of the bodies' velocities. What joints do not leave free of these counts as nothing.
    /// @param speeds out, [n]   @param n how many coordinates there are
    /// @status OK; NULL_ARGUMENT; *_HANDLE; OUT_OF_RANGE (n; the body is not moved by forces); UNSUPPORTED (no tree); BUSY;
    ///         OUT_OF_MEMORY
    pub fn carom_tree_get_speeds(world: *mut carom_world, body: carom_body, speeds: *mut f64, n: u64, error: *mut carom_error) -> i32;
    /// Inverse dynamics: the forces that give a tree these accelerations, at the present pose.
    ///     forces = M accelerations + what gyroscopic and centrifugal terms and gravity ask
    /// With speeds of 0 and no accelerations these hold the tree against gravity.
    /// Accuracy: 1e-14 of the largest term, for chains of tens of bodies. Oracle: tests/oracle/test_joint_tree.
    /// @param speeds        [n] m/s and rad/s, or NULL: those of now
    /// @param accelerations [n] m/s^2 and rad/s^2, rates of the speeds, or NULL: 0
    /// @param forces        out, [n] N and N m
    /// @param n             how many coordinates there are
    /// @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE (also: forces that are beyond what numbers hold);
    ///         OUT_OF_RANGE (n; the body is not moved by forces); UNSUPPORTED (no tree); BUSY; OUT_OF_MEMORY
    pub fn carom_tree_get_forces(world: *mut carom_world, body: carom_body, speeds: *const f64, accelerations: *const f64, forces: *mut f64, n: u64, error: *mut carom_error) -> i32;
    /// The mass matrix of a tree at the present pose, symmetric and positive definite: with speeds v its energy of motion
    /// is v^T M v / 2. Where two axes of one joint agree M is singular.
    /// Accuracy: 1e-14 of the largest entry that a sum has, for chains of tens of bodies. Oracle: tests/oracle/test_joint_tree.
    /// @param mass out, [n n] row by row: kg, kg m and kg m^2   @param n how many coordinates there are
    /// @status OK; NULL_ARGUMENT; *_HANDLE; OUT_OF_RANGE (n; the body is not moved by forces); UNSUPPORTED (no tree);
    ///         NOT_FINITE (bodies too far apart or too heavy for numbers); BUSY; OUT_OF_MEMORY
    pub fn carom_tree_get_mass(world: *mut carom_world, body: carom_body, mass: *mut f64, n: u64, error: *mut carom_error) -> i32;
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE
    pub fn carom_vehicle_desc_init(desc: *mut carom_vehicle_desc, struct_size: u32) -> i32;
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE
    pub fn carom_wheel_desc_init(desc: *mut carom_wheel_desc, struct_size: u32) -> i32;
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE
    pub fn carom_vehicle_input_init(input: *mut carom_vehicle_input, struct_size: u32) -> i32;
    /// At idle speed, at rest.   @status OK; NULL_ARGUMENT; STRUCT_SIZE
    pub fn carom_vehicle_init(vehicle: *mut carom_vehicle, struct_size: u32) -> i32;
    /// In the air, at rest.   @status OK; NULL_ARGUMENT; STRUCT_SIZE
    pub fn carom_wheel_init(wheel: *mut carom_wheel, struct_size: u32) -> i32;
    /// Look down, turn wheels and engine through dt, and leave the mean forces for the next step, which is to take dt. They
    /// add to forces that are pending. They keep a vehicle awake.
    /// @param desc with a chassis
    /// @param wheel_descs [n] one after another, each of the first one's struct_size
    /// @param n 1 to CAROM_VEHICLE_WHEELS
    /// @param input what the driver does
    /// @param vehicle state, changes
    /// @param wheels [n] states, change: as wheel_descs
    /// @param dt s, [1e-4, 0.1]
    /// @accuracy of the prediction first order in 1 ms; it leaves out what else acts on the chassis but gravity and
    ///           pending forces. A chassis that swings on its springs faster than a third of 1 / dt trembles. Of springs
    ///           stiffer than (m / 4) / 1 ms^2, m what the chassis weighs at the wheel, so much acts
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED (unknown bits; a half-space or scenery as shape); *_HANDLE;
    ///         NOT_FINITE; NOT_UNIT; OUT_OF_RANGE (also: a chassis that is not dynamic, a gear that it has not); BUSY;
    ///         REENTRANT; OUT_OF_MEMORY
    pub fn carom_vehicle_drive(world: *mut carom_world, desc: *const carom_vehicle_desc, wheel_descs: *const carom_wheel_desc, n: u64, input: *const carom_vehicle_input, vehicle: *mut carom_vehicle, wheels: *mut carom_wheel, dt: f64, error: *mut carom_error) -> i32;
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE
    pub fn carom_world_desc_init(desc: *mut carom_world_desc, struct_size: u32) -> i32;
    /// @param desc may be NULL: defaults   @owns the caller: carom_world_destroy(), before the engine
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; NOT_FINITE; OUT_OF_RANGE; LIMIT (65,535 engines and worlds in
    ///         all); OUT_OF_MEMORY   @thread engine
    pub fn carom_world_create(engine: *mut carom_engine, desc: *const carom_world_desc, world: *mut *mut carom_world, error: *mut carom_error) -> i32;
    /// Destroys its bodies, colliders, materials and particles too.   @status OK; NULL_ARGUMENT; BUSY; REENTRANT
    pub fn carom_world_destroy(world: *mut carom_world, error: *mut carom_error) -> i32;
    /// Advance by dt.
    /// @param dt s, in [1e-9, 1]
    /// @status OK; NULL_ARGUMENT; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT; OUT_OF_MEMORY
    /// Out of memory: no body has moved and forces are still pending; contact caches may have been dropped.
    /// A plugin that misbehaves does not fail the step: its pairs are skipped and carom_world_get_faults() reports it.
    pub fn carom_world_step(world: *mut carom_world, dt: f64, error: *mut carom_error) -> i32;
    /// @param value within the dial's bounds; whole for choices and integers
    /// @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT
    pub fn carom_world_set_dial(world: *mut carom_world, dial: u32, value: f64, error: *mut carom_error) -> i32;
    /// @param value as carom_world_set_dial() takes it   @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; BUSY
    pub fn carom_world_get_dial(world: *mut carom_world, dial: u32, value: *mut f64, error: *mut carom_error) -> i32;
    /// Set all dials that presets speak of, from the next step on; see carom_preset_get_dial(). Later calls of
    /// carom_world_set_dial() change them one by one.   @param preset CAROM_PRESET_*
    /// @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; BUSY; REENTRANT
    pub fn carom_world_set_preset(world: *mut carom_world, preset: u32, error: *mut carom_error) -> i32;
    /// @param gravity [3] m/s^2, |each| <= 1e6   @status OK; NULL_ARGUMENT; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT
    pub fn carom_world_set_gravity(world: *mut carom_world, gravity: *const f64, error: *mut carom_error) -> i32;
    /// @status OK; NULL_ARGUMENT; BUSY
    pub fn carom_world_get_gravity(world: *mut carom_world, gravity: *mut f64, error: *mut carom_error) -> i32;
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; BUSY
    pub fn carom_world_get_report(world: *mut carom_world, report: *mut carom_step_report, error: *mut carom_error) -> i32;
    /// Static name of a stage ("broad"), or "?".
    /// @param stage CAROM_STAGE_*
    pub fn carom_stage_name(stage: u32) -> *const c_char;
    /// Copy out the contact points of the last step, in a deterministic order; those of colliders destroyed since are gone.
    /// @param dst      [capacity] elements `stride` bytes apart; may be NULL if capacity is 0
    /// @param stride   sizeof(carom_contact) as the caller knows it
    /// @param count    out: how many there are (may exceed capacity; capacity are written)
    /// @status OK; NULL_ARGUMENT; BUFFER_TOO_SMALL; OUT_OF_RANGE (stride); BUSY
    pub fn carom_world_get_contacts(world: *mut carom_world, dst: *mut carom_contact, stride: u64, capacity: u64, count: *mut u64, error: *mut carom_error) -> i32;
    /// Copy out the contact groups of the last step, in a deterministic order. Other solvers than CAROM_SOLVER_AUTO treat
    /// all groups alike: then there are none.
    /// @param dst      [capacity] elements `stride` bytes apart; may be NULL if capacity is 0
    /// @param stride   sizeof(carom_group) as the caller knows it
    /// @param count    out: how many there are (may exceed capacity; capacity are written)
    /// @status OK; NULL_ARGUMENT; BUFFER_TOO_SMALL; OUT_OF_RANGE (stride); BUSY
    pub fn carom_world_get_groups(world: *mut carom_world, dst: *mut carom_group, stride: u64, capacity: u64, count: *mut u64, error: *mut carom_error) -> i32;
    /// Copy out the faults of the last step; arguments as carom_world_get_contacts().
    pub fn carom_world_get_faults(world: *mut carom_world, dst: *mut carom_fault, stride: u64, capacity: u64, count: *mut u64, error: *mut carom_error) -> i32;
    /// 64-bit hash of the dynamic state: equal iff (up to collision of the hash) every pose, velocity and cached contact
    /// has the same bits, and every particle's position and velocity.
    /// @param hash of the state
    /// @status OK; NULL_ARGUMENT; BUSY   @thread reader
    pub fn carom_world_hash(world: *mut carom_world, hash: *mut u64, error: *mut carom_error) -> i32;
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE
    pub fn carom_query_desc_init(desc: *mut carom_query_desc, struct_size: u32) -> i32;
    /// What one ray meets first: origin + t direction, 0 <= t <= max.
    /// @param origin [3] m   @param direction [3] m per unit of t, any length   @param max >= 0, may be infinite
    /// @param desc   may be NULL: defaults   @param size sizeof(carom_world_hit) as the caller knows it
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; *_HANDLE (desc->ignore); NOT_FINITE; OUT_OF_RANGE;
    ///         BUFFER_TOO_SMALL (size); BUSY; OUT_OF_MEMORY   @thread reader
    pub fn carom_world_cast_ray(world: *mut carom_world, origin: *const f64, direction: *const f64, max: f64, desc: *const carom_query_desc, hit: *mut carom_world_hit, size: u64, error: *mut carom_error) -> i32;
    /// What each of many rays meets first, or whether it meets anything. A bad ray (not finite, or max negative) spoils no
    /// other: its outcome is CAROM_CAST_BAD_RAY. Nothing is allocated per ray.
    /// @param want   CAROM_WANT_*   @param desc may be NULL: defaults
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; UNKNOWN_ENUM; *_HANDLE (desc->ignore); NOT_FINITE;
    ///         OUT_OF_RANGE; BUFFER_TOO_SMALL (a stride); BUSY; OUT_OF_MEMORY   @thread reader
    pub fn carom_world_cast_rays(world: *mut carom_world, rays: *const carom_rays, want: u32, desc: *const carom_query_desc, hits: *const carom_world_hits, error: *mut carom_error) -> i32;
    /// All that each of many rays meets: by ray, then by time, then by slot. A bad ray has one record that says so.
    /// @param dst    [capacity] elements `stride` bytes apart; may be NULL if capacity is 0
    /// @param stride sizeof(carom_world_hit) as the caller knows it
    /// @param count  out: how many there are (may exceed capacity; the first `capacity` are written)
    /// @status as carom_world_cast_rays()   @thread reader
    pub fn carom_world_cast_rays_all(world: *mut carom_world, rays: *const carom_rays, desc: *const carom_query_desc, dst: *mut carom_world_hit, stride: u64, capacity: u64, count: *mut u64, error: *mut carom_error) -> i32;
    /// What each of many shapes meets first as it moves by its motion without turning, or whether it meets anything.
    /// @param shapes every shape, position, orientation and motion must be good, else nothing is written
    /// @param want   CAROM_WANT_*   @param desc may be NULL: defaults
    /// @param dst    [shapes->count] elements `stride` bytes apart   @param stride 0: tightly packed
    /// @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED (a half-space as query shape); UNKNOWN_ENUM; *_HANDLE;
    /// NOT_FINITE;
    ///         NOT_UNIT; OUT_OF_RANGE; BUFFER_TOO_SMALL (a stride); BUSY; OUT_OF_MEMORY   @thread reader
    pub fn carom_world_cast_shapes(world: *mut carom_world, shapes: *const carom_query_shapes, want: u32, desc: *const carom_query_desc, dst: *mut carom_world_hit, stride: u64, error: *mut carom_error) -> i32;
    /// All that each of many moving shapes meets: by shape, then by time, then by slot; as carom_world_cast_rays_all().
    /// @status as carom_world_cast_rays_all(); NOT_UNIT   @thread reader
    pub fn carom_world_cast_shapes_all(world: *mut carom_world, shapes: *const carom_query_shapes, desc: *const carom_query_desc, dst: *mut carom_world_hit, stride: u64, capacity: u64, count: *mut u64, error: *mut carom_error) -> i32;
    /// All that overlaps each of many shapes (or is nearer than desc->target): by shape, then by slot; arguments as
    /// carom_world_cast_rays_all().   @status as carom_world_cast_rays_all(); NOT_UNIT   @thread reader
    pub fn carom_world_overlap_shapes(world: *mut carom_world, shapes: *const carom_query_shapes, desc: *const carom_query_desc, dst: *mut carom_world_hit, stride: u64, capacity: u64, count: *mut u64, error: *mut carom_error) -> i32;
    /// The collider nearest to each of many shapes or points, and where: least signed distance.
    /// @param reach  m, >= 0, may be infinite: farther ones are not looked for (then: MISS)
    /// @param dst    as carom_world_cast_shapes()
    /// @status as carom_world_cast_shapes()   @thread reader
    pub fn carom_world_find_nearest(world: *mut carom_world, shapes: *const carom_query_shapes, reach: f64, desc: *const carom_query_desc, dst: *mut carom_world_hit, stride: u64, error: *mut carom_error) -> i32;
}
/// Name, offset, size and kind of each struct and field, as the lines of carom_abi_manifest().
pub static LAYOUT: &[(&str, usize, usize, &str)] = &[
    ("carom_error", 0, size_of::<carom_error>(), "struct"),
    ("carom_error.struct_size", offset_of!(carom_error, struct_size), size_of::<u32>(), "u32"),
    ("carom_error.code", offset_of!(carom_error, code), size_of::<i32>(), "i32"),
    ("carom_error.argument", offset_of!(carom_error, argument), size_of::<i32>(), "i32"),
    ("carom_error.has_witness", offset_of!(carom_error, has_witness), size_of::<u32>(), "u32"),
    ("carom_error.witness_dir", offset_of!(carom_error, witness_dir), size_of::<f64>() * 3, "f64[3]"),
    ("carom_error.witness_out", offset_of!(carom_error, witness_out), size_of::<f64>() * 3, "f64[3]"),
    ("carom_error.message", offset_of!(carom_error, message), size_of::<c_char>() * 256, "char[256]"),
    ("carom_error.remedy", offset_of!(carom_error, remedy), size_of::<c_char>() * 256, "char[256]"),
    ("carom_accuracy", 0, size_of::<carom_accuracy>(), "struct"),
    ("carom_accuracy.struct_size", offset_of!(carom_accuracy, struct_size), size_of::<u32>(), "u32"),
    ("carom_accuracy.substeps", offset_of!(carom_accuracy, substeps), size_of::<u32>(), "u32"),
    ("carom_accuracy.place", offset_of!(carom_accuracy, place), size_of::<f64>(), "f64"),
    ("carom_accuracy.turn", offset_of!(carom_accuracy, turn), size_of::<f64>(), "f64"),
    ("carom_island", 0, size_of::<carom_island>(), "struct"),
    ("carom_island.body", offset_of!(carom_island, body), size_of::<carom_body>(), "u64"),
    ("carom_island.bodies", offset_of!(carom_island, bodies), size_of::<u32>(), "u32"),
    ("carom_island.substeps", offset_of!(carom_island, substeps), size_of::<u32>(), "u32"),
    ("carom_island.order", offset_of!(carom_island, order), size_of::<u32>(), "u32"),
    ("carom_island.flags", offset_of!(carom_island, flags), size_of::<u32>(), "u32"),
    ("carom_island.work", offset_of!(carom_island, work), size_of::<u64>(), "u64"),
    ("carom_island.place", offset_of!(carom_island, place), size_of::<f64>(), "f64"),
    ("carom_island.turn", offset_of!(carom_island, turn), size_of::<f64>(), "f64"),
    ("carom_island.share", offset_of!(carom_island, share), size_of::<f64>(), "f64"),
    ("carom_growth", 0, size_of::<carom_growth>(), "struct"),
    ("carom_growth.struct_size", offset_of!(carom_growth, struct_size), size_of::<u32>(), "u32"),
    ("carom_growth.steps", offset_of!(carom_growth, steps), size_of::<u32>(), "u32"),
    ("carom_growth.body", offset_of!(carom_growth, body), size_of::<carom_body>(), "u64"),
    ("carom_growth.sensitive", offset_of!(carom_growth, sensitive), size_of::<u32>(), "u32"),
    ("carom_growth.reserved", offset_of!(carom_growth, reserved), size_of::<u32>(), "u32"),
    ("carom_growth.factor", offset_of!(carom_growth, factor), size_of::<f64>(), "f64"),
    ("carom_growth.rate", offset_of!(carom_growth, rate), size_of::<f64>(), "f64"),
    ("carom_batch_column", 0, size_of::<carom_batch_column>(), "struct"),
    ("carom_batch_column.struct_size", offset_of!(carom_batch_column, struct_size), size_of::<u32>(), "u32"),
    ("carom_batch_column.source", offset_of!(carom_batch_column, source), size_of::<u32>(), "u32"),
    ("carom_batch_column.field", offset_of!(carom_batch_column, field), size_of::<u32>(), "u32"),
    ("carom_batch_column.when", offset_of!(carom_batch_column, when), size_of::<u32>(), "u32"),
    ("carom_batch_column.scalar", offset_of!(carom_batch_column, scalar), size_of::<u32>(), "u32"),
    ("carom_batch_column.reserved", offset_of!(carom_batch_column, reserved), size_of::<u32>(), "u32"),
    ("carom_batch_column.world", offset_of!(carom_batch_column, world), size_of::<u64>(), "u64"),
    ("carom_batch_column.n", offset_of!(carom_batch_column, n), size_of::<u64>(), "u64"),
    ("carom_batch_column.handles", offset_of!(carom_batch_column, handles), size_of::<*const u64>(), "ptr"),
    ("carom_batch_column.rays", offset_of!(carom_batch_column, rays), size_of::<*const f64>(), "ptr"),
    ("carom_batch_column.data", offset_of!(carom_batch_column, data), size_of::<*mut c_void>(), "ptr"),
    ("carom_batch_column.stride", offset_of!(carom_batch_column, stride), size_of::<u64>(), "u64"),
    ("carom_batch_info", 0, size_of::<carom_batch_info>(), "struct"),
    ("carom_batch_info.struct_size", offset_of!(carom_batch_info, struct_size), size_of::<u32>(), "u32"),
    ("carom_batch_info.structures", offset_of!(carom_batch_info, structures), size_of::<u32>(), "u32"),
    ("carom_batch_info.worlds", offset_of!(carom_batch_info, worlds), size_of::<u64>(), "u64"),
    ("carom_batch_info.stopped", offset_of!(carom_batch_info, stopped), size_of::<u64>(), "u64"),
    ("carom_batch_info.columns", offset_of!(carom_batch_info, columns), size_of::<u64>(), "u64"),
    ("carom_batch_info.real_worlds", offset_of!(carom_batch_info, real_worlds), size_of::<u64>(), "u64"),
    ("carom_batch_info.state_bytes", offset_of!(carom_batch_info, state_bytes), size_of::<u64>(), "u64"),
    ("carom_material_desc", 0, size_of::<carom_material_desc>(), "struct"),
    ("carom_material_desc.struct_size", offset_of!(carom_material_desc, struct_size), size_of::<u32>(), "u32"),
    ("carom_material_desc.friction_mix", offset_of!(carom_material_desc, friction_mix), size_of::<u32>(), "u32"),
    ("carom_material_desc.restitution_mix", offset_of!(carom_material_desc, restitution_mix), size_of::<u32>(), "u32"),
    ("carom_material_desc.reserved", offset_of!(carom_material_desc, reserved), size_of::<u32>(), "u32"),
    ("carom_material_desc.friction", offset_of!(carom_material_desc, friction), size_of::<f64>(), "f64"),
    ("carom_material_desc.restitution", offset_of!(carom_material_desc, restitution), size_of::<f64>(), "f64"),
    ("carom_body_desc", 0, size_of::<carom_body_desc>(), "struct"),
    ("carom_body_desc.struct_size", offset_of!(carom_body_desc, struct_size), size_of::<u32>(), "u32"),
    ("carom_body_desc.fields", offset_of!(carom_body_desc, fields), size_of::<u32>(), "u32"),
    ("carom_body_desc.type", offset_of!(carom_body_desc, r#type), size_of::<u32>(), "u32"),
    ("carom_body_desc.reserved", offset_of!(carom_body_desc, reserved), size_of::<u32>(), "u32"),
    ("carom_body_desc.position", offset_of!(carom_body_desc, position), size_of::<f64>() * 3, "f64[3]"),
    ("carom_body_desc.orientation", offset_of!(carom_body_desc, orientation), size_of::<f64>() * 4, "f64[4]"),
    ("carom_body_desc.linear_velocity", offset_of!(carom_body_desc, linear_velocity), size_of::<f64>() * 3, "f64[3]"),
    ("carom_body_desc.angular_velocity", offset_of!(carom_body_desc, angular_velocity), size_of::<f64>() * 3, "f64[3]"),
    ("carom_body_desc.mass", offset_of!(carom_body_desc, mass), size_of::<f64>(), "f64"),
    ("carom_body_desc.center", offset_of!(carom_body_desc, center), size_of::<f64>() * 3, "f64[3]"),
    ("carom_body_desc.inertia", offset_of!(carom_body_desc, inertia), size_of::<f64>() * 9, "f64[9]"),
    ("carom_body_desc.linear_damping", offset_of!(carom_body_desc, linear_damping), size_of::<f64>(), "f64"),
    ("carom_body_desc.angular_damping", offset_of!(carom_body_desc, angular_damping), size_of::<f64>(), "f64"),
    ("carom_body_desc.user", offset_of!(carom_body_desc, user), size_of::<u64>(), "u64"),
    ("carom_body_desc.gravity_factor", offset_of!(carom_body_desc, gravity_factor), size_of::<f64>(), "f64"),
    ("carom_body_desc.locks", offset_of!(carom_body_desc, locks), size_of::<u32>(), "u32"),
    ("carom_body_desc.continuous", offset_of!(carom_body_desc, continuous), size_of::<u32>(), "u32"),
    ("carom_body_desc.linear_drag", offset_of!(carom_body_desc, linear_drag), size_of::<f64>(), "f64"),
    ("carom_body_desc.quadratic_drag", offset_of!(carom_body_desc, quadratic_drag), size_of::<f64>(), "f64"),
    ("carom_body_desc.force_field_mask", offset_of!(carom_body_desc, force_field_mask), size_of::<u32>(), "u32"),
    ("carom_body_desc.reserved2", offset_of!(carom_body_desc, reserved2), size_of::<u32>(), "u32"),
    ("carom_body_desc.magnetic_moment", offset_of!(carom_body_desc, magnetic_moment), size_of::<f64>() * 3, "f64[3]"),
    ("carom_attribute_info", 0, size_of::<carom_attribute_info>(), "struct"),
    ("carom_attribute_info.struct_size", offset_of!(carom_attribute_info, struct_size), size_of::<u32>(), "u32"),
    ("carom_attribute_info.attribute", offset_of!(carom_attribute_info, attribute), size_of::<u32>(), "u32"),
    ("carom_attribute_info.numbers", offset_of!(carom_attribute_info, numbers), size_of::<u32>(), "u32"),
    ("carom_attribute_info.is_whole", offset_of!(carom_attribute_info, is_whole), size_of::<u32>(), "u32"),
    ("carom_attribute_info.of_dynamic", offset_of!(carom_attribute_info, of_dynamic), size_of::<u32>(), "u32"),
    ("carom_attribute_info.effect", offset_of!(carom_attribute_info, effect), size_of::<u32>(), "u32"),
    ("carom_attribute_info.name", offset_of!(carom_attribute_info, name), size_of::<*const c_char>(), "ptr"),
    ("carom_attribute_info.unit", offset_of!(carom_attribute_info, unit), size_of::<*const c_char>(), "ptr"),
    ("carom_attribute_info.summary", offset_of!(carom_attribute_info, summary), size_of::<*const c_char>(), "ptr"),
    ("carom_attribute_info.min", offset_of!(carom_attribute_info, min), size_of::<f64>(), "f64"),
    ("carom_attribute_info.max", offset_of!(carom_attribute_info, max), size_of::<f64>(), "f64"),
    ("carom_attribute_info.usual", offset_of!(carom_attribute_info, usual), size_of::<f64>() * 4, "f64[4]"),
    ("carom_collider_desc", 0, size_of::<carom_collider_desc>(), "struct"),
    ("carom_collider_desc.struct_size", offset_of!(carom_collider_desc, struct_size), size_of::<u32>(), "u32"),
    ("carom_collider_desc.reserved", offset_of!(carom_collider_desc, reserved), size_of::<u32>(), "u32"),
    ("carom_collider_desc.shape", offset_of!(carom_collider_desc, shape), size_of::<carom_shape>(), "u64"),
    ("carom_collider_desc.material", offset_of!(carom_collider_desc, material), size_of::<carom_material>(), "u64"),
    ("carom_collider_desc.position", offset_of!(carom_collider_desc, position), size_of::<f64>() * 3, "f64[3]"),
    ("carom_collider_desc.orientation", offset_of!(carom_collider_desc, orientation), size_of::<f64>() * 4, "f64[4]"),
    ("carom_collider_desc.density", offset_of!(carom_collider_desc, density), size_of::<f64>(), "f64"),
    ("carom_collider_desc.category", offset_of!(carom_collider_desc, category), size_of::<u64>(), "u64"),
    ("carom_collider_desc.mask", offset_of!(carom_collider_desc, mask), size_of::<u64>(), "u64"),
    ("carom_collider_desc.group", offset_of!(carom_collider_desc, group), size_of::<i32>(), "i32"),
    ("carom_collider_desc.sensor", offset_of!(carom_collider_desc, sensor), size_of::<u32>(), "u32"),
    ("carom_collider_desc.surface_linear", offset_of!(carom_collider_desc, surface_linear), size_of::<f64>() * 3, "f64[3]"),
    ("carom_collider_desc.surface_angular", offset_of!(carom_collider_desc, surface_angular), size_of::<f64>() * 3, "f64[3]"),
    ("carom_cast_desc", 0, size_of::<carom_cast_desc>(), "struct"),
    ("carom_cast_desc.struct_size", offset_of!(carom_cast_desc, struct_size), size_of::<u32>(), "u32"),
    ("carom_cast_desc.iterations", offset_of!(carom_cast_desc, iterations), size_of::<u32>(), "u32"),
    ("carom_cast_desc.tolerance", offset_of!(carom_cast_desc, tolerance), size_of::<f64>(), "f64"),
    ("carom_cast_desc.target", offset_of!(carom_cast_desc, target), size_of::<f64>(), "f64"),
    ("carom_cast_desc.flags", offset_of!(carom_cast_desc, flags), size_of::<u32>(), "u32"),
    ("carom_cast_desc.reserved", offset_of!(carom_cast_desc, reserved), size_of::<u32>(), "u32"),
    ("carom_cast", 0, size_of::<carom_cast>(), "struct"),
    ("carom_cast.struct_size", offset_of!(carom_cast, struct_size), size_of::<u32>(), "u32"),
    ("carom_cast.outcome", offset_of!(carom_cast, outcome), size_of::<u32>(), "u32"),
    ("carom_cast.status", offset_of!(carom_cast, status), size_of::<u32>(), "u32"),
    ("carom_cast.iterations", offset_of!(carom_cast, iterations), size_of::<u32>(), "u32"),
    ("carom_cast.time", offset_of!(carom_cast, time), size_of::<f64>(), "f64"),
    ("carom_cast.lower", offset_of!(carom_cast, lower), size_of::<f64>(), "f64"),
    ("carom_cast.upper", offset_of!(carom_cast, upper), size_of::<f64>(), "f64"),
    ("carom_cast.separation", offset_of!(carom_cast, separation), size_of::<f64>(), "f64"),
    ("carom_cast.slack", offset_of!(carom_cast, slack), size_of::<f64>(), "f64"),
    ("carom_cast.normal", offset_of!(carom_cast, normal), size_of::<f64>() * 3, "f64[3]"),
    ("carom_cast.point_a", offset_of!(carom_cast, point_a), size_of::<f64>() * 3, "f64[3]"),
    ("carom_cast.point_b", offset_of!(carom_cast, point_b), size_of::<f64>() * 3, "f64[3]"),
    ("carom_cast.support_calls", offset_of!(carom_cast, support_calls), size_of::<u32>(), "u32"),
    ("carom_cast.reserved", offset_of!(carom_cast, reserved), size_of::<u32>(), "u32"),
    ("carom_motion", 0, size_of::<carom_motion>(), "struct"),
    ("carom_motion.struct_size", offset_of!(carom_motion, struct_size), size_of::<u32>(), "u32"),
    ("carom_motion.reserved", offset_of!(carom_motion, reserved), size_of::<u32>(), "u32"),
    ("carom_motion.position", offset_of!(carom_motion, position), size_of::<f64>() * 3, "f64[3]"),
    ("carom_motion.orientation", offset_of!(carom_motion, orientation), size_of::<f64>() * 4, "f64[4]"),
    ("carom_motion.center", offset_of!(carom_motion, center), size_of::<f64>() * 3, "f64[3]"),
    ("carom_motion.linear_velocity", offset_of!(carom_motion, linear_velocity), size_of::<f64>() * 3, "f64[3]"),
    ("carom_motion.angular_velocity", offset_of!(carom_motion, angular_velocity), size_of::<f64>() * 3, "f64[3]"),
    ("carom_overlap", 0, size_of::<carom_overlap>(), "struct"),
    ("carom_overlap.struct_size", offset_of!(carom_overlap, struct_size), size_of::<u32>(), "u32"),
    ("carom_overlap.outcome", offset_of!(carom_overlap, outcome), size_of::<u32>(), "u32"),
    ("carom_overlap.separation_bound", offset_of!(carom_overlap, separation_bound), size_of::<f64>(), "f64"),
    ("carom_overlap.normal", offset_of!(carom_overlap, normal), size_of::<f64>() * 3, "f64[3]"),
    ("carom_overlap.point", offset_of!(carom_overlap, point), size_of::<f64>() * 3, "f64[3]"),
    ("carom_overlap.slack", offset_of!(carom_overlap, slack), size_of::<f64>(), "f64"),
    ("carom_overlap.support_calls", offset_of!(carom_overlap, support_calls), size_of::<u32>(), "u32"),
    ("carom_overlap.reserved", offset_of!(carom_overlap, reserved), size_of::<u32>(), "u32"),
    ("carom_rays", 0, size_of::<carom_rays>(), "struct"),
    ("carom_rays.struct_size", offset_of!(carom_rays, struct_size), size_of::<u32>(), "u32"),
    ("carom_rays.scalar", offset_of!(carom_rays, scalar), size_of::<u32>(), "u32"),
    ("carom_rays.count", offset_of!(carom_rays, count), size_of::<u64>(), "u64"),
    ("carom_rays.origins", offset_of!(carom_rays, origins), size_of::<*const c_void>(), "ptr"),
    ("carom_rays.directions", offset_of!(carom_rays, directions), size_of::<*const c_void>(), "ptr"),
    ("carom_rays.max", offset_of!(carom_rays, max), size_of::<*const c_void>(), "ptr"),
    ("carom_rays.origin_stride", offset_of!(carom_rays, origin_stride), size_of::<u64>(), "u64"),
    ("carom_rays.direction_stride", offset_of!(carom_rays, direction_stride), size_of::<u64>(), "u64"),
    ("carom_rays.max_stride", offset_of!(carom_rays, max_stride), size_of::<u64>(), "u64"),
    ("carom_ray_hit", 0, size_of::<carom_ray_hit>(), "struct"),
    ("carom_ray_hit.outcome", offset_of!(carom_ray_hit, outcome), size_of::<u32>(), "u32"),
    ("carom_ray_hit.status", offset_of!(carom_ray_hit, status), size_of::<u32>(), "u32"),
    ("carom_ray_hit.shape", offset_of!(carom_ray_hit, shape), size_of::<u32>(), "u32"),
    ("carom_ray_hit.reserved", offset_of!(carom_ray_hit, reserved), size_of::<u32>(), "u32"),
    ("carom_ray_hit.time", offset_of!(carom_ray_hit, time), size_of::<f64>(), "f64"),
    ("carom_ray_hit.lower", offset_of!(carom_ray_hit, lower), size_of::<f64>(), "f64"),
    ("carom_ray_hit.upper", offset_of!(carom_ray_hit, upper), size_of::<f64>(), "f64"),
    ("carom_ray_hit.normal", offset_of!(carom_ray_hit, normal), size_of::<f64>() * 3, "f64[3]"),
    ("carom_ray_hit.point", offset_of!(carom_ray_hit, point), size_of::<f64>() * 3, "f64[3]"),
    ("carom_ray_hits", 0, size_of::<carom_ray_hits>(), "struct"),
    ("carom_ray_hits.struct_size", offset_of!(carom_ray_hits, struct_size), size_of::<u32>(), "u32"),
    ("carom_ray_hits.scalar", offset_of!(carom_ray_hits, scalar), size_of::<u32>(), "u32"),
    ("carom_ray_hits.records", offset_of!(carom_ray_hits, records), size_of::<*mut carom_ray_hit>(), "ptr"),
    ("carom_ray_hits.outcomes", offset_of!(carom_ray_hits, outcomes), size_of::<*mut u32>(), "ptr"),
    ("carom_ray_hits.shapes", offset_of!(carom_ray_hits, shapes), size_of::<*mut u32>(), "ptr"),
    ("carom_ray_hits.times", offset_of!(carom_ray_hits, times), size_of::<*mut c_void>(), "ptr"),
    ("carom_ray_hits.normals", offset_of!(carom_ray_hits, normals), size_of::<*mut c_void>(), "ptr"),
    ("carom_ray_hits.points", offset_of!(carom_ray_hits, points), size_of::<*mut c_void>(), "ptr"),
    ("carom_ray_hits.record_stride", offset_of!(carom_ray_hits, record_stride), size_of::<u64>(), "u64"),
    ("carom_ray_hits.outcome_stride", offset_of!(carom_ray_hits, outcome_stride), size_of::<u64>(), "u64"),
    ("carom_ray_hits.shape_stride", offset_of!(carom_ray_hits, shape_stride), size_of::<u64>(), "u64"),
    ("carom_ray_hits.time_stride", offset_of!(carom_ray_hits, time_stride), size_of::<u64>(), "u64"),
    ("carom_ray_hits.normal_stride", offset_of!(carom_ray_hits, normal_stride), size_of::<u64>(), "u64"),
    ("carom_ray_hits.point_stride", offset_of!(carom_ray_hits, point_stride), size_of::<u64>(), "u64"),
    ("carom_character_desc", 0, size_of::<carom_character_desc>(), "struct"),
    ("carom_character_desc.struct_size", offset_of!(carom_character_desc, struct_size), size_of::<u32>(), "u32"),
    ("carom_character_desc.flags", offset_of!(carom_character_desc, flags), size_of::<u32>(), "u32"),
    ("carom_character_desc.up", offset_of!(carom_character_desc, up), size_of::<f64>() * 3, "f64[3]"),
    ("carom_character_desc.gravity", offset_of!(carom_character_desc, gravity), size_of::<f64>(), "f64"),
    ("carom_character_desc.fall_speed", offset_of!(carom_character_desc, fall_speed), size_of::<f64>(), "f64"),
    ("carom_character_desc.max_slope", offset_of!(carom_character_desc, max_slope), size_of::<f64>(), "f64"),
    ("carom_character_desc.step_up", offset_of!(carom_character_desc, step_up), size_of::<f64>(), "f64"),
    ("carom_character_desc.step_down", offset_of!(carom_character_desc, step_down), size_of::<f64>(), "f64"),
    ("carom_character_desc.skin", offset_of!(carom_character_desc, skin), size_of::<f64>(), "f64"),
    ("carom_character_desc.acceleration", offset_of!(carom_character_desc, acceleration), size_of::<f64>(), "f64"),
    ("carom_character_desc.air_acceleration", offset_of!(carom_character_desc, air_acceleration), size_of::<f64>(), "f64"),
    ("carom_character_desc.mass", offset_of!(carom_character_desc, mass), size_of::<f64>(), "f64"),
    ("carom_character_desc.push_force", offset_of!(carom_character_desc, push_force), size_of::<f64>(), "f64"),
    ("carom_character_desc.recover_speed", offset_of!(carom_character_desc, recover_speed), size_of::<f64>(), "f64"),
    ("carom_character_desc.category", offset_of!(carom_character_desc, category), size_of::<u64>(), "u64"),
    ("carom_character_desc.mask", offset_of!(carom_character_desc, mask), size_of::<u64>(), "u64"),
    ("carom_character_desc.body", offset_of!(carom_character_desc, body), size_of::<carom_body>(), "u64"),
    ("carom_character", 0, size_of::<carom_character>(), "struct"),
    ("carom_character.struct_size", offset_of!(carom_character, struct_size), size_of::<u32>(), "u32"),
    ("carom_character.ground", offset_of!(carom_character, ground), size_of::<u32>(), "u32"),
    ("carom_character.shape", offset_of!(carom_character, shape), size_of::<carom_shape>(), "u64"),
    ("carom_character.position", offset_of!(carom_character, position), size_of::<f64>() * 3, "f64[3]"),
    ("carom_character.orientation", offset_of!(carom_character, orientation), size_of::<f64>() * 4, "f64[4]"),
    ("carom_character.velocity", offset_of!(carom_character, velocity), size_of::<f64>() * 3, "f64[3]"),
    ("carom_character.foot", offset_of!(carom_character, foot), size_of::<f64>(), "f64"),
    ("carom_character.head", offset_of!(carom_character, head), size_of::<f64>(), "f64"),
    ("carom_character.reach", offset_of!(carom_character, reach), size_of::<f64>(), "f64"),
    ("carom_character.ground_body", offset_of!(carom_character, ground_body), size_of::<carom_body>(), "u64"),
    ("carom_character.ground_collider", offset_of!(carom_character, ground_collider), size_of::<carom_collider>(), "u64"),
    ("carom_character.ground_point", offset_of!(carom_character, ground_point), size_of::<f64>() * 3, "f64[3]"),
    ("carom_character.ground_normal", offset_of!(carom_character, ground_normal), size_of::<f64>() * 3, "f64[3]"),
    ("carom_character.ground_velocity", offset_of!(carom_character, ground_velocity), size_of::<f64>() * 3, "f64[3]"),
    ("carom_character.ground_position", offset_of!(carom_character, ground_position), size_of::<f64>() * 3, "f64[3]"),
    ("carom_character.ground_orientation", offset_of!(carom_character, ground_orientation), size_of::<f64>() * 4, "f64[4]"),
    ("carom_character.contact_count", offset_of!(carom_character, contact_count), size_of::<u32>(), "u32"),
    ("carom_character.reserved", offset_of!(carom_character, reserved), size_of::<u32>(), "u32"),
    ("carom_character.contact_bodies", offset_of!(carom_character, contact_bodies), size_of::<carom_body>() * 8, "u64[8]"),
    ("carom_character.contact_points", offset_of!(carom_character, contact_points), size_of::<f64>() * 24, "f64[24]"),
    ("carom_character.contact_normals", offset_of!(carom_character, contact_normals), size_of::<f64>() * 24, "f64[24]"),
    ("carom_character.contact_speeds", offset_of!(carom_character, contact_speeds), size_of::<f64>() * 8, "f64[8]"),
    ("carom_dial_info", 0, size_of::<carom_dial_info>(), "struct"),
    ("carom_dial_info.struct_size", offset_of!(carom_dial_info, struct_size), size_of::<u32>(), "u32"),
    ("carom_dial_info.dial", offset_of!(carom_dial_info, dial), size_of::<u32>(), "u32"),
    ("carom_dial_info.kind", offset_of!(carom_dial_info, kind), size_of::<u32>(), "u32"),
    ("carom_dial_info.choice_count", offset_of!(carom_dial_info, choice_count), size_of::<u32>(), "u32"),
    ("carom_dial_info.name", offset_of!(carom_dial_info, name), size_of::<*const c_char>(), "ptr"),
    ("carom_dial_info.unit", offset_of!(carom_dial_info, unit), size_of::<*const c_char>(), "ptr"),
    ("carom_dial_info.summary", offset_of!(carom_dial_info, summary), size_of::<*const c_char>(), "ptr"),
    ("carom_dial_info.choices", offset_of!(carom_dial_info, choices), size_of::<*const *const c_char>(), "ptr"),
    ("carom_dial_info.min", offset_of!(carom_dial_info, min), size_of::<f64>(), "f64"),
    ("carom_dial_info.max", offset_of!(carom_dial_info, max), size_of::<f64>(), "f64"),
    ("carom_dial_info.initial", offset_of!(carom_dial_info, initial), size_of::<f64>(), "f64"),
    ("carom_constant_info", 0, size_of::<carom_constant_info>(), "struct"),
    ("carom_constant_info.struct_size", offset_of!(carom_constant_info, struct_size), size_of::<u32>(), "u32"),
    ("carom_constant_info.constant", offset_of!(carom_constant_info, constant), size_of::<u32>(), "u32"),
    ("carom_constant_info.name", offset_of!(carom_constant_info, name), size_of::<*const c_char>(), "ptr"),
    ("carom_constant_info.unit", offset_of!(carom_constant_info, unit), size_of::<*const c_char>(), "ptr"),
    ("carom_constant_info.reason", offset_of!(carom_constant_info, reason), size_of::<*const c_char>(), "ptr"),
    ("carom_constant_info.consequence", offset_of!(carom_constant_info, consequence), size_of::<*const c_char>(), "ptr"),
    ("carom_constant_info.value", offset_of!(carom_constant_info, value), size_of::<f64>(), "f64"),
    ("carom_draw_desc", 0, size_of::<carom_draw_desc>(), "struct"),
    ("carom_draw_desc.struct_size", offset_of!(carom_draw_desc, struct_size), size_of::<u32>(), "u32"),
    ("carom_draw_desc.what", offset_of!(carom_draw_desc, what), size_of::<u32>(), "u32"),
    ("carom_draw_desc.colouring", offset_of!(carom_draw_desc, colouring), size_of::<u32>(), "u32"),
    ("carom_draw_desc.reserved", offset_of!(carom_draw_desc, reserved), size_of::<u32>(), "u32"),
    ("carom_draw_desc.scale", offset_of!(carom_draw_desc, scale), size_of::<f64>(), "f64"),
    ("carom_draw_line", 0, size_of::<carom_draw_line>(), "struct"),
    ("carom_draw_line.from", offset_of!(carom_draw_line, from), size_of::<f64>() * 3, "f64[3]"),
    ("carom_draw_line.to", offset_of!(carom_draw_line, to), size_of::<f64>() * 3, "f64[3]"),
    ("carom_draw_line.colour", offset_of!(carom_draw_line, colour), size_of::<u32>(), "u32"),
    ("carom_draw_line.kind", offset_of!(carom_draw_line, kind), size_of::<u32>(), "u32"),
    ("carom_draw_line.body", offset_of!(carom_draw_line, body), size_of::<carom_body>(), "u64"),
    ("carom_engine_desc", 0, size_of::<carom_engine_desc>(), "struct"),
    ("carom_engine_desc.struct_size", offset_of!(carom_engine_desc, struct_size), size_of::<u32>(), "u32"),
    ("carom_engine_desc.reserved", offset_of!(carom_engine_desc, reserved), size_of::<u32>(), "u32"),
    ("carom_engine_desc.alloc", offset_of!(carom_engine_desc, alloc), size_of::<Option<unsafe extern "C" fn(*mut c_void, u64, u64) -> *mut c_void>>(), "fn"),
    ("carom_engine_desc.free", offset_of!(carom_engine_desc, free), size_of::<Option<unsafe extern "C" fn(*mut c_void, *mut c_void, u64, u64)>>(), "fn"),
    ("carom_engine_desc.alloc_user", offset_of!(carom_engine_desc, alloc_user), size_of::<*mut c_void>(), "ptr"),
    ("carom_engine_desc.log", offset_of!(carom_engine_desc, log), size_of::<Option<unsafe extern "C" fn(*mut c_void, u32, *const c_char)>>(), "fn"),
    ("carom_engine_desc.log_user", offset_of!(carom_engine_desc, log_user), size_of::<*mut c_void>(), "ptr"),
    ("carom_jobs_desc", 0, size_of::<carom_jobs_desc>(), "struct"),
    ("carom_jobs_desc.struct_size", offset_of!(carom_jobs_desc, struct_size), size_of::<u32>(), "u32"),
    ("carom_jobs_desc.threads", offset_of!(carom_jobs_desc, threads), size_of::<u32>(), "u32"),
    ("carom_jobs_desc.run", offset_of!(carom_jobs_desc, run), size_of::<Option<unsafe extern "C" fn(*mut c_void, carom_job_fn, *mut c_void, u32)>>(), "fn"),
    ("carom_jobs_desc.user", offset_of!(carom_jobs_desc, user), size_of::<*mut c_void>(), "ptr"),
    ("carom_contact_event", 0, size_of::<carom_contact_event>(), "struct"),
    ("carom_contact_event.kind", offset_of!(carom_contact_event, kind), size_of::<u32>(), "u32"),
    ("carom_contact_event.reserved", offset_of!(carom_contact_event, reserved), size_of::<u32>(), "u32"),
    ("carom_contact_event.collider_a", offset_of!(carom_contact_event, collider_a), size_of::<carom_collider>(), "u64"),
    ("carom_contact_event.collider_b", offset_of!(carom_contact_event, collider_b), size_of::<carom_collider>(), "u64"),
    ("carom_contact_event.body_a", offset_of!(carom_contact_event, body_a), size_of::<carom_body>(), "u64"),
    ("carom_contact_event.body_b", offset_of!(carom_contact_event, body_b), size_of::<carom_body>(), "u64"),
    ("carom_contact_event.point", offset_of!(carom_contact_event, point), size_of::<f64>() * 3, "f64[3]"),
    ("carom_contact_event.normal", offset_of!(carom_contact_event, normal), size_of::<f64>() * 3, "f64[3]"),
    ("carom_contact_event.impulse", offset_of!(carom_contact_event, impulse), size_of::<f64>(), "f64"),
    ("carom_contact_event.approach_speed", offset_of!(carom_contact_event, approach_speed), size_of::<f64>(), "f64"),
    ("carom_sensor_event", 0, size_of::<carom_sensor_event>(), "struct"),
    ("carom_sensor_event.kind", offset_of!(carom_sensor_event, kind), size_of::<u32>(), "u32"),
    ("carom_sensor_event.reserved", offset_of!(carom_sensor_event, reserved), size_of::<u32>(), "u32"),
    ("carom_sensor_event.sensor", offset_of!(carom_sensor_event, sensor), size_of::<carom_collider>(), "u64"),
    ("carom_sensor_event.other", offset_of!(carom_sensor_event, other), size_of::<carom_collider>(), "u64"),
    ("carom_sensor_event.sensor_body", offset_of!(carom_sensor_event, sensor_body), size_of::<carom_body>(), "u64"),
    ("carom_sensor_event.other_body", offset_of!(carom_sensor_event, other_body), size_of::<carom_body>(), "u64"),
    ("carom_sleep_event", 0, size_of::<carom_sleep_event>(), "struct"),
    ("carom_sleep_event.kind", offset_of!(carom_sleep_event, kind), size_of::<u32>(), "u32"),
    ("carom_sleep_event.reserved", offset_of!(carom_sleep_event, reserved), size_of::<u32>(), "u32"),
    ("carom_sleep_event.body", offset_of!(carom_sleep_event, body), size_of::<carom_body>(), "u64"),
    ("carom_joint_event", 0, size_of::<carom_joint_event>(), "struct"),
    ("carom_joint_event.joint", offset_of!(carom_joint_event, joint), size_of::<carom_joint>(), "u64"),
    ("carom_joint_event.body_a", offset_of!(carom_joint_event, body_a), size_of::<carom_body>(), "u64"),
    ("carom_joint_event.body_b", offset_of!(carom_joint_event, body_b), size_of::<carom_body>(), "u64"),
    ("carom_joint_event.force", offset_of!(carom_joint_event, force), size_of::<f64>() * 3, "f64[3]"),
    ("carom_joint_event.torque", offset_of!(carom_joint_event, torque), size_of::<f64>() * 3, "f64[3]"),
    ("carom_joint_event.step", offset_of!(carom_joint_event, step), size_of::<u64>(), "u64"),
    ("carom_fault_event", 0, size_of::<carom_fault_event>(), "struct"),
    ("carom_fault_event.kind", offset_of!(carom_fault_event, kind), size_of::<u32>(), "u32"),
    ("carom_fault_event.reserved", offset_of!(carom_fault_event, reserved), size_of::<u32>(), "u32"),
    ("carom_fault_event.shape", offset_of!(carom_fault_event, shape), size_of::<carom_shape>(), "u64"),
    ("carom_fault_event.body", offset_of!(carom_fault_event, body), size_of::<carom_body>(), "u64"),
    ("carom_fault_event.particles", offset_of!(carom_fault_event, particles), size_of::<carom_particles>(), "u64"),
    ("carom_fault_event.particle", offset_of!(carom_fault_event, particle), size_of::<u64>(), "u64"),
    ("carom_fault_event.dir", offset_of!(carom_fault_event, dir), size_of::<f64>() * 3, "f64[3]"),
    ("carom_fault_event.out", offset_of!(carom_fault_event, out), size_of::<f64>() * 3, "f64[3]"),
    ("carom_fault_event.step", offset_of!(carom_fault_event, step), size_of::<u64>(), "u64"),
    ("carom_force_field_desc", 0, size_of::<carom_force_field_desc>(), "struct"),
    ("carom_force_field_desc.struct_size", offset_of!(carom_force_field_desc, struct_size), size_of::<u32>(), "u32"),
    ("carom_force_field_desc.kind", offset_of!(carom_force_field_desc, kind), size_of::<u32>(), "u32"),
    ("carom_force_field_desc.is_force", offset_of!(carom_force_field_desc, is_force), size_of::<u32>(), "u32"),
    ("carom_force_field_desc.mask", offset_of!(carom_force_field_desc, mask), size_of::<u32>(), "u32"),
    ("carom_force_field_desc.position", offset_of!(carom_force_field_desc, position), size_of::<f64>() * 3, "f64[3]"),
    ("carom_force_field_desc.orientation", offset_of!(carom_force_field_desc, orientation), size_of::<f64>() * 4, "f64[4]"),
    ("carom_force_field_desc.half", offset_of!(carom_force_field_desc, half), size_of::<f64>() * 3, "f64[3]"),
    ("carom_force_field_desc.vector", offset_of!(carom_force_field_desc, vector), size_of::<f64>() * 3, "f64[3]"),
    ("carom_force_field_desc.strength", offset_of!(carom_force_field_desc, strength), size_of::<f64>(), "f64"),
    ("carom_force_field_desc.pull", offset_of!(carom_force_field_desc, pull), size_of::<f64>(), "f64"),
    ("carom_force_field_desc.lift", offset_of!(carom_force_field_desc, lift), size_of::<f64>(), "f64"),
    ("carom_force_field_desc.reference", offset_of!(carom_force_field_desc, reference), size_of::<f64>(), "f64"),
    ("carom_force_field_desc.core", offset_of!(carom_force_field_desc, core), size_of::<f64>(), "f64"),
    ("carom_force_field_desc.reach", offset_of!(carom_force_field_desc, reach), size_of::<f64>(), "f64"),
    ("carom_force_field_desc.falloff", offset_of!(carom_force_field_desc, falloff), size_of::<i32>(), "i32"),
    ("carom_force_field_desc.reserved", offset_of!(carom_force_field_desc, reserved), size_of::<u32>(), "u32"),
    ("carom_force_field_desc.user", offset_of!(carom_force_field_desc, user), size_of::<u64>(), "u64"),
    ("carom_spring_desc", 0, size_of::<carom_spring_desc>(), "struct"),
    ("carom_spring_desc.struct_size", offset_of!(carom_spring_desc, struct_size), size_of::<u32>(), "u32"),
    ("carom_spring_desc.only_pulls", offset_of!(carom_spring_desc, only_pulls), size_of::<u32>(), "u32"),
    ("carom_spring_desc.body_a", offset_of!(carom_spring_desc, body_a), size_of::<carom_body>(), "u64"),
    ("carom_spring_desc.body_b", offset_of!(carom_spring_desc, body_b), size_of::<carom_body>(), "u64"),
    ("carom_spring_desc.anchor_a", offset_of!(carom_spring_desc, anchor_a), size_of::<f64>() * 3, "f64[3]"),
    ("carom_spring_desc.anchor_b", offset_of!(carom_spring_desc, anchor_b), size_of::<f64>() * 3, "f64[3]"),
    ("carom_spring_desc.rest", offset_of!(carom_spring_desc, rest), size_of::<f64>(), "f64"),
    ("carom_spring_desc.stiffness", offset_of!(carom_spring_desc, stiffness), size_of::<f64>(), "f64"),
    ("carom_spring_desc.damping", offset_of!(carom_spring_desc, damping), size_of::<f64>(), "f64"),
    ("carom_spring_desc.user", offset_of!(carom_spring_desc, user), size_of::<u64>(), "u64"),
    ("carom_water", 0, size_of::<carom_water>(), "struct"),
    ("carom_water.struct_size", offset_of!(carom_water, struct_size), size_of::<u32>(), "u32"),
    ("carom_water.reserved", offset_of!(carom_water, reserved), size_of::<u32>(), "u32"),
    ("carom_water.normal", offset_of!(carom_water, normal), size_of::<f64>() * 3, "f64[3]"),
    ("carom_water.level", offset_of!(carom_water, level), size_of::<f64>(), "f64"),
    ("carom_water.density", offset_of!(carom_water, density), size_of::<f64>(), "f64"),
    ("carom_water.current", offset_of!(carom_water, current), size_of::<f64>() * 3, "f64[3]"),
    ("carom_water.drag", offset_of!(carom_water, drag), size_of::<f64>(), "f64"),
    ("carom_joint_desc", 0, size_of::<carom_joint_desc>(), "struct"),
    ("carom_joint_desc.struct_size", offset_of!(carom_joint_desc, struct_size), size_of::<u32>(), "u32"),
    ("carom_joint_desc.kind", offset_of!(carom_joint_desc, kind), size_of::<u32>(), "u32"),
    ("carom_joint_desc.fields", offset_of!(carom_joint_desc, fields), size_of::<u32>(), "u32"),
    ("carom_joint_desc.reserved", offset_of!(carom_joint_desc, reserved), size_of::<u32>(), "u32"),
    ("carom_joint_desc.body_a", offset_of!(carom_joint_desc, body_a), size_of::<carom_body>(), "u64"),
    ("carom_joint_desc.body_b", offset_of!(carom_joint_desc, body_b), size_of::<carom_body>(), "u64"),
    ("carom_joint_desc.position_a", offset_of!(carom_joint_desc, position_a), size_of::<f64>() * 3, "f64[3]"),
    ("carom_joint_desc.orientation_a", offset_of!(carom_joint_desc, orientation_a), size_of::<f64>() * 4, "f64[4]"),
    ("carom_joint_desc.position_b", offset_of!(carom_joint_desc, position_b), size_of::<f64>() * 3, "f64[3]"),
    ("carom_joint_desc.orientation_b", offset_of!(carom_joint_desc, orientation_b), size_of::<f64>() * 4, "f64[4]"),
    ("carom_joint_desc.length", offset_of!(carom_joint_desc, length), size_of::<f64>(), "f64"),
    ("carom_joint_desc.break_force", offset_of!(carom_joint_desc, break_force), size_of::<f64>(), "f64"),
    ("carom_joint_desc.break_torque", offset_of!(carom_joint_desc, break_torque), size_of::<f64>(), "f64"),
    ("carom_joint_desc.user", offset_of!(carom_joint_desc, user), size_of::<u64>(), "u64"),
    ("carom_joint_limit", 0, size_of::<carom_joint_limit>(), "struct"),
    ("carom_joint_limit.struct_size", offset_of!(carom_joint_limit, struct_size), size_of::<u32>(), "u32"),
    ("carom_joint_limit.enabled", offset_of!(carom_joint_limit, enabled), size_of::<u32>(), "u32"),
    ("carom_joint_limit.lower", offset_of!(carom_joint_limit, lower), size_of::<f64>(), "f64"),
    ("carom_joint_limit.upper", offset_of!(carom_joint_limit, upper), size_of::<f64>(), "f64"),
    ("carom_joint_motor", 0, size_of::<carom_joint_motor>(), "struct"),
    ("carom_joint_motor.struct_size", offset_of!(carom_joint_motor, struct_size), size_of::<u32>(), "u32"),
    ("carom_joint_motor.enabled", offset_of!(carom_joint_motor, enabled), size_of::<u32>(), "u32"),
    ("carom_joint_motor.speed", offset_of!(carom_joint_motor, speed), size_of::<f64>(), "f64"),
    ("carom_joint_motor.max_force", offset_of!(carom_joint_motor, max_force), size_of::<f64>(), "f64"),
    ("carom_joint_spring", 0, size_of::<carom_joint_spring>(), "struct"),
    ("carom_joint_spring.struct_size", offset_of!(carom_joint_spring, struct_size), size_of::<u32>(), "u32"),
    ("carom_joint_spring.enabled", offset_of!(carom_joint_spring, enabled), size_of::<u32>(), "u32"),
    ("carom_joint_spring.target", offset_of!(carom_joint_spring, target), size_of::<f64>(), "f64"),
    ("carom_joint_spring.frequency", offset_of!(carom_joint_spring, frequency), size_of::<f64>(), "f64"),
    ("carom_joint_spring.damping", offset_of!(carom_joint_spring, damping), size_of::<f64>(), "f64"),
    ("carom_joint_spring.max_force", offset_of!(carom_joint_spring, max_force), size_of::<f64>(), "f64"),
    ("carom_joint_transmission", 0, size_of::<carom_joint_transmission>(), "struct"),
    ("carom_joint_transmission.struct_size", offset_of!(carom_joint_transmission, struct_size), size_of::<u32>(), "u32"),
    ("carom_joint_transmission.fields", offset_of!(carom_joint_transmission, fields), size_of::<u32>(), "u32"),
    ("carom_joint_transmission.ratio", offset_of!(carom_joint_transmission, ratio), size_of::<f64>(), "f64"),
    ("carom_joint_transmission.anchor_a", offset_of!(carom_joint_transmission, anchor_a), size_of::<f64>() * 3, "f64[3]"),
    ("carom_joint_transmission.anchor_b", offset_of!(carom_joint_transmission, anchor_b), size_of::<f64>() * 3, "f64[3]"),
    ("carom_joint_transmission.length", offset_of!(carom_joint_transmission, length), size_of::<f64>(), "f64"),
    ("carom_joint_coupling", 0, size_of::<carom_joint_coupling>(), "struct"),
    ("carom_joint_coupling.struct_size", offset_of!(carom_joint_coupling, struct_size), size_of::<u32>(), "u32"),
    ("carom_joint_coupling.reserved", offset_of!(carom_joint_coupling, reserved), size_of::<u32>(), "u32"),
    ("carom_joint_coupling.follower", offset_of!(carom_joint_coupling, follower), size_of::<carom_joint>(), "u64"),
    ("carom_joint_coupling.leader", offset_of!(carom_joint_coupling, leader), size_of::<carom_joint>(), "u64"),
    ("carom_joint_coupling.polynomial", offset_of!(carom_joint_coupling, polynomial), size_of::<f64>() * 5, "f64[5]"),
    ("carom_joint_coupling.user", offset_of!(carom_joint_coupling, user), size_of::<u64>(), "u64"),
    ("carom_joint_axis", 0, size_of::<carom_joint_axis>(), "struct"),
    ("carom_joint_axis.struct_size", offset_of!(carom_joint_axis, struct_size), size_of::<u32>(), "u32"),
    ("carom_joint_axis.mode", offset_of!(carom_joint_axis, mode), size_of::<u32>(), "u32"),
    ("carom_joint_axis.lower", offset_of!(carom_joint_axis, lower), size_of::<f64>(), "f64"),
    ("carom_joint_axis.upper", offset_of!(carom_joint_axis, upper), size_of::<f64>(), "f64"),
    ("carom_joint_axis.stop_gains", offset_of!(carom_joint_axis, stop_gains), size_of::<u32>(), "u32"),
    ("carom_joint_axis.drive_gains", offset_of!(carom_joint_axis, drive_gains), size_of::<u32>(), "u32"),
    ("carom_joint_axis.spring_gains", offset_of!(carom_joint_axis, spring_gains), size_of::<u32>(), "u32"),
    ("carom_joint_axis.drive", offset_of!(carom_joint_axis, drive), size_of::<u32>(), "u32"),
    ("carom_joint_axis.stop_stiffness", offset_of!(carom_joint_axis, stop_stiffness), size_of::<f64>(), "f64"),
    ("carom_joint_axis.stop_damping", offset_of!(carom_joint_axis, stop_damping), size_of::<f64>(), "f64"),
    ("carom_joint_axis.target", offset_of!(carom_joint_axis, target), size_of::<f64>(), "f64"),
    ("carom_joint_axis.speed", offset_of!(carom_joint_axis, speed), size_of::<f64>(), "f64"),
    ("carom_joint_axis.effort", offset_of!(carom_joint_axis, effort), size_of::<f64>(), "f64"),
    ("carom_joint_axis.max_force", offset_of!(carom_joint_axis, max_force), size_of::<f64>(), "f64"),
    ("carom_joint_axis.drive_stiffness", offset_of!(carom_joint_axis, drive_stiffness), size_of::<f64>(), "f64"),
    ("carom_joint_axis.drive_damping", offset_of!(carom_joint_axis, drive_damping), size_of::<f64>(), "f64"),
    ("carom_joint_axis.rest", offset_of!(carom_joint_axis, rest), size_of::<f64>(), "f64"),
    ("carom_joint_axis.spring_stiffness", offset_of!(carom_joint_axis, spring_stiffness), size_of::<f64>(), "f64"),
    ("carom_joint_axis.spring_damping", offset_of!(carom_joint_axis, spring_damping), size_of::<f64>(), "f64"),
    ("carom_joint_axis.friction", offset_of!(carom_joint_axis, friction), size_of::<f64>(), "f64"),
    ("carom_joint_axis.armature", offset_of!(carom_joint_axis, armature), size_of::<f64>(), "f64"),
    ("carom_joint_axis.effort_limit", offset_of!(carom_joint_axis, effort_limit), size_of::<f64>(), "f64"),
    ("carom_joint_axis.speed_limit", offset_of!(carom_joint_axis, speed_limit), size_of::<f64>(), "f64"),
    ("carom_joint_orientation_drive", 0, size_of::<carom_joint_orientation_drive>(), "struct"),
    ("carom_joint_orientation_drive.struct_size", offset_of!(carom_joint_orientation_drive, struct_size), size_of::<u32>(), "u32"),
    ("carom_joint_orientation_drive.drive", offset_of!(carom_joint_orientation_drive, drive), size_of::<u32>(), "u32"),
    ("carom_joint_orientation_drive.gains", offset_of!(carom_joint_orientation_drive, gains), size_of::<u32>(), "u32"),
    ("carom_joint_orientation_drive.reserved", offset_of!(carom_joint_orientation_drive, reserved), size_of::<u32>(), "u32"),
    ("carom_joint_orientation_drive.target", offset_of!(carom_joint_orientation_drive, target), size_of::<f64>() * 4, "f64[4]"),
    ("carom_joint_orientation_drive.velocity", offset_of!(carom_joint_orientation_drive, velocity), size_of::<f64>() * 3, "f64[3]"),
    ("carom_joint_orientation_drive.effort", offset_of!(carom_joint_orientation_drive, effort), size_of::<f64>() * 3, "f64[3]"),
    ("carom_joint_orientation_drive.max_force", offset_of!(carom_joint_orientation_drive, max_force), size_of::<f64>() * 3, "f64[3]"),
    ("carom_joint_orientation_drive.stiffness", offset_of!(carom_joint_orientation_drive, stiffness), size_of::<f64>(), "f64"),
    ("carom_joint_orientation_drive.damping", offset_of!(carom_joint_orientation_drive, damping), size_of::<f64>(), "f64"),
    ("carom_joint_state", 0, size_of::<carom_joint_state>(), "struct"),
    ("carom_joint_state.struct_size", offset_of!(carom_joint_state, struct_size), size_of::<u32>(), "u32"),
    ("carom_joint_state.broken", offset_of!(carom_joint_state, broken), size_of::<u32>(), "u32"),
    ("carom_joint_state.force", offset_of!(carom_joint_state, force), size_of::<f64>() * 3, "f64[3]"),
    ("carom_joint_state.torque", offset_of!(carom_joint_state, torque), size_of::<f64>() * 3, "f64[3]"),
    ("carom_joint_state.gap", offset_of!(carom_joint_state, gap), size_of::<f64>(), "f64"),
    ("carom_joint_state.angle", offset_of!(carom_joint_state, angle), size_of::<f64>(), "f64"),
    ("carom_joint_state.coordinate", offset_of!(carom_joint_state, coordinate), size_of::<f64>() * 4, "f64[4]"),
    ("carom_joint_state.axis", offset_of!(carom_joint_state, axis), size_of::<f64>() * 6, "f64[6]"),
    ("carom_ledger_entry", 0, size_of::<carom_ledger_entry>(), "struct"),
    ("carom_ledger_entry.name", offset_of!(carom_ledger_entry, name), size_of::<*const c_char>(), "ptr"),
    ("carom_ledger_entry.kinetic", offset_of!(carom_ledger_entry, kinetic), size_of::<f64>(), "f64"),
    ("carom_ledger_entry.potential", offset_of!(carom_ledger_entry, potential), size_of::<f64>(), "f64"),
    ("carom_ledger_entry.linear", offset_of!(carom_ledger_entry, linear), size_of::<f64>() * 3, "f64[3]"),
    ("carom_ledger_entry.angular", offset_of!(carom_ledger_entry, angular), size_of::<f64>() * 3, "f64[3]"),
    ("carom_ledger_entry.total_kinetic", offset_of!(carom_ledger_entry, total_kinetic), size_of::<f64>(), "f64"),
    ("carom_ledger_entry.total_potential", offset_of!(carom_ledger_entry, total_potential), size_of::<f64>(), "f64"),
    ("carom_ledger_entry.total_linear", offset_of!(carom_ledger_entry, total_linear), size_of::<f64>() * 3, "f64[3]"),
    ("carom_ledger_entry.total_angular", offset_of!(carom_ledger_entry, total_angular), size_of::<f64>() * 3, "f64[3]"),
    ("carom_ledger_state", 0, size_of::<carom_ledger_state>(), "struct"),
    ("carom_ledger_state.struct_size", offset_of!(carom_ledger_state, struct_size), size_of::<u32>(), "u32"),
    ("carom_ledger_state.is_kept", offset_of!(carom_ledger_state, is_kept), size_of::<u32>(), "u32"),
    ("carom_ledger_state.steps", offset_of!(carom_ledger_state, steps), size_of::<u64>(), "u64"),
    ("carom_ledger_state.start_kinetic", offset_of!(carom_ledger_state, start_kinetic), size_of::<f64>(), "f64"),
    ("carom_ledger_state.start_potential", offset_of!(carom_ledger_state, start_potential), size_of::<f64>(), "f64"),
    ("carom_ledger_state.start_linear", offset_of!(carom_ledger_state, start_linear), size_of::<f64>() * 3, "f64[3]"),
    ("carom_ledger_state.start_angular", offset_of!(carom_ledger_state, start_angular), size_of::<f64>() * 3, "f64[3]"),
    ("carom_ledger_state.before_kinetic", offset_of!(carom_ledger_state, before_kinetic), size_of::<f64>(), "f64"),
    ("carom_ledger_state.before_potential", offset_of!(carom_ledger_state, before_potential), size_of::<f64>(), "f64"),
    ("carom_ledger_state.before_linear", offset_of!(carom_ledger_state, before_linear), size_of::<f64>() * 3, "f64[3]"),
    ("carom_ledger_state.before_angular", offset_of!(carom_ledger_state, before_angular), size_of::<f64>() * 3, "f64[3]"),
    ("carom_ledger_state.now_kinetic", offset_of!(carom_ledger_state, now_kinetic), size_of::<f64>(), "f64"),
    ("carom_ledger_state.now_potential", offset_of!(carom_ledger_state, now_potential), size_of::<f64>(), "f64"),
    ("carom_ledger_state.now_linear", offset_of!(carom_ledger_state, now_linear), size_of::<f64>() * 3, "f64[3]"),
    ("carom_ledger_state.now_angular", offset_of!(carom_ledger_state, now_angular), size_of::<f64>() * 3, "f64[3]"),
    ("carom_ledger_state.rounding_energy", offset_of!(carom_ledger_state, rounding_energy), size_of::<f64>(), "f64"),
    ("carom_ledger_state.rounding_linear", offset_of!(carom_ledger_state, rounding_linear), size_of::<f64>(), "f64"),
    ("carom_ledger_state.rounding_angular", offset_of!(carom_ledger_state, rounding_angular), size_of::<f64>(), "f64"),
    ("carom_ledger_state.total_rounding_energy", offset_of!(carom_ledger_state, total_rounding_energy), size_of::<f64>(), "f64"),
    ("carom_ledger_state.total_rounding_linear", offset_of!(carom_ledger_state, total_rounding_linear), size_of::<f64>(), "f64"),
    ("carom_ledger_state.total_rounding_angular", offset_of!(carom_ledger_state, total_rounding_angular), size_of::<f64>(), "f64"),
    ("carom_pairs", 0, size_of::<carom_pairs>(), "struct"),
    ("carom_pairs.struct_size", offset_of!(carom_pairs, struct_size), size_of::<u32>(), "u32"),
    ("carom_pairs.reserved", offset_of!(carom_pairs, reserved), size_of::<u32>(), "u32"),
    ("carom_pairs.count", offset_of!(carom_pairs, count), size_of::<u64>(), "u64"),
    ("carom_pairs.shapes_a", offset_of!(carom_pairs, shapes_a), size_of::<*const carom_shape>(), "ptr"),
    ("carom_pairs.shapes_b", offset_of!(carom_pairs, shapes_b), size_of::<*const carom_shape>(), "ptr"),
    ("carom_pairs.positions_a", offset_of!(carom_pairs, positions_a), size_of::<*const f64>(), "ptr"),
    ("carom_pairs.orientations_a", offset_of!(carom_pairs, orientations_a), size_of::<*const f64>(), "ptr"),
    ("carom_pairs.positions_b", offset_of!(carom_pairs, positions_b), size_of::<*const f64>(), "ptr"),
    ("carom_pairs.orientations_b", offset_of!(carom_pairs, orientations_b), size_of::<*const f64>(), "ptr"),
    ("carom_pairs.shape_a_stride", offset_of!(carom_pairs, shape_a_stride), size_of::<u64>(), "u64"),
    ("carom_pairs.shape_b_stride", offset_of!(carom_pairs, shape_b_stride), size_of::<u64>(), "u64"),
    ("carom_pairs.position_a_stride", offset_of!(carom_pairs, position_a_stride), size_of::<u64>(), "u64"),
    ("carom_pairs.orientation_a_stride", offset_of!(carom_pairs, orientation_a_stride), size_of::<u64>(), "u64"),
    ("carom_pairs.position_b_stride", offset_of!(carom_pairs, position_b_stride), size_of::<u64>(), "u64"),
    ("carom_pairs.orientation_b_stride", offset_of!(carom_pairs, orientation_b_stride), size_of::<u64>(), "u64"),
    ("carom_device_info", 0, size_of::<carom_device_info>(), "struct"),
    ("carom_device_info.struct_size", offset_of!(carom_device_info, struct_size), size_of::<u32>(), "u32"),
    ("carom_device_info.reserved", offset_of!(carom_device_info, reserved), size_of::<u32>(), "u32"),
    ("carom_device_info.name", offset_of!(carom_device_info, name), size_of::<c_char>() * 128, "char[128]"),
    ("carom_device_info.version", offset_of!(carom_device_info, version), size_of::<c_char>() * 128, "char[128]"),
    ("carom_device_info.pairs", offset_of!(carom_device_info, pairs), size_of::<u64>(), "u64"),
    ("carom_device_info.host_pairs", offset_of!(carom_device_info, host_pairs), size_of::<u64>(), "u64"),
    ("carom_particles_desc", 0, size_of::<carom_particles_desc>(), "struct"),
    ("carom_particles_desc.struct_size", offset_of!(carom_particles_desc, struct_size), size_of::<u32>(), "u32"),
    ("carom_particles_desc.reserved", offset_of!(carom_particles_desc, reserved), size_of::<u32>(), "u32"),
    ("carom_particles_desc.gravity_factor", offset_of!(carom_particles_desc, gravity_factor), size_of::<f64>(), "f64"),
    ("carom_particles_desc.linear_damping", offset_of!(carom_particles_desc, linear_damping), size_of::<f64>(), "f64"),
    ("carom_particles_desc.mass", offset_of!(carom_particles_desc, mass), size_of::<f64>(), "f64"),
    ("carom_particles_desc.capacity", offset_of!(carom_particles_desc, capacity), size_of::<u64>(), "u64"),
    ("carom_plan_line", 0, size_of::<carom_plan_line>(), "struct"),
    ("carom_plan_line.effect", offset_of!(carom_plan_line, effect), size_of::<u32>(), "u32"),
    ("carom_plan_line.stage", offset_of!(carom_plan_line, stage), size_of::<u32>(), "u32"),
    ("carom_plan_line.mode", offset_of!(carom_plan_line, mode), size_of::<u32>(), "u32"),
    ("carom_plan_line.runs", offset_of!(carom_plan_line, runs), size_of::<u32>(), "u32"),
    ("carom_plan_line.participants", offset_of!(carom_plan_line, participants), size_of::<u64>(), "u64"),
    ("carom_plan_line.wanted", offset_of!(carom_plan_line, wanted), size_of::<u64>(), "u64"),
    ("carom_plan_line.evaluations", offset_of!(carom_plan_line, evaluations), size_of::<u64>(), "u64"),
    ("carom_plan_line.bytes", offset_of!(carom_plan_line, bytes), size_of::<u64>(), "u64"),
    ("carom_plan_line.seconds", offset_of!(carom_plan_line, seconds), size_of::<f64>(), "f64"),
    ("carom_plan_line.timing", offset_of!(carom_plan_line, timing), size_of::<u32>(), "u32"),
    ("carom_plan_line.reserved", offset_of!(carom_plan_line, reserved), size_of::<u32>(), "u32"),
    ("carom_plan_line.name", offset_of!(carom_plan_line, name), size_of::<c_char>() * 32, "char[32]"),
    ("carom_plan_line.unit", offset_of!(carom_plan_line, unit), size_of::<c_char>() * 24, "char[24]"),
    ("carom_plan_line.reason", offset_of!(carom_plan_line, reason), size_of::<c_char>() * 128, "char[128]"),
    ("carom_param", 0, size_of::<carom_param>(), "struct"),
    ("carom_param.name", offset_of!(carom_param, name), size_of::<*const c_char>(), "ptr"),
    ("carom_param.unit", offset_of!(carom_param, unit), size_of::<*const c_char>(), "ptr"),
    ("carom_param.min", offset_of!(carom_param, min), size_of::<f64>(), "f64"),
    ("carom_param.max", offset_of!(carom_param, max), size_of::<f64>(), "f64"),
    ("carom_param_rule", 0, size_of::<carom_param_rule>(), "struct"),
    ("carom_param_rule.text", offset_of!(carom_param_rule, text), size_of::<*const c_char>(), "ptr"),
    ("carom_param_rule.term_count", offset_of!(carom_param_rule, term_count), size_of::<u32>(), "u32"),
    ("carom_param_rule.param", offset_of!(carom_param_rule, param), size_of::<u32>() * 4, "u32[4]"),
    ("carom_param_rule.weight", offset_of!(carom_param_rule, weight), size_of::<f64>() * 4, "f64[4]"),
    ("carom_param_rule.most", offset_of!(carom_param_rule, most), size_of::<f64>(), "f64"),
    ("carom_geometry", 0, size_of::<carom_geometry>(), "struct"),
    ("carom_geometry.struct_size", offset_of!(carom_geometry, struct_size), size_of::<u32>(), "u32"),
    ("carom_geometry.form", offset_of!(carom_geometry, form), size_of::<u32>(), "u32"),
    ("carom_geometry.form_arg", offset_of!(carom_geometry, form_arg), size_of::<u32>() * 4, "u32[4]"),
    ("carom_geometry.core_radius_param", offset_of!(carom_geometry, core_radius_param), size_of::<u32>(), "u32"),
    ("carom_geometry.mass_form", offset_of!(carom_geometry, mass_form), size_of::<u32>(), "u32"),
    ("carom_geometry.mass_arg", offset_of!(carom_geometry, mass_arg), size_of::<u32>() * 4, "u32[4]"),
    ("carom_shape_plugin", 0, size_of::<carom_shape_plugin>(), "struct"),
    ("carom_shape_plugin.struct_size", offset_of!(carom_shape_plugin, struct_size), size_of::<u32>(), "u32"),
    ("carom_shape_plugin.abi_major", offset_of!(carom_shape_plugin, abi_major), size_of::<u32>(), "u32"),
    ("carom_shape_plugin.abi_minor", offset_of!(carom_shape_plugin, abi_minor), size_of::<u32>(), "u32"),
    ("carom_shape_plugin.flags", offset_of!(carom_shape_plugin, flags), size_of::<u32>(), "u32"),
    ("carom_shape_plugin.id", offset_of!(carom_shape_plugin, id), size_of::<*const c_char>(), "ptr"),
    ("carom_shape_plugin.version", offset_of!(carom_shape_plugin, version), size_of::<u32>(), "u32"),
    ("carom_shape_plugin.param_count", offset_of!(carom_shape_plugin, param_count), size_of::<u32>(), "u32"),
    ("carom_shape_plugin.params", offset_of!(carom_shape_plugin, params), size_of::<*const carom_param>(), "ptr"),
    ("carom_shape_plugin.geometry", offset_of!(carom_shape_plugin, geometry), size_of::<*const carom_geometry>(), "ptr"),
    ("carom_shape_plugin.support", offset_of!(carom_shape_plugin, support), size_of::<carom_support_fn>(), "fn"),
    ("carom_shape_plugin.param_tail_group", offset_of!(carom_shape_plugin, param_tail_group), size_of::<u32>(), "u32"),
    ("carom_shape_plugin.param_tail_min", offset_of!(carom_shape_plugin, param_tail_min), size_of::<u32>(), "u32"),
    ("carom_shape_plugin.rules", offset_of!(carom_shape_plugin, rules), size_of::<*const carom_param_rule>(), "ptr"),
    ("carom_shape_plugin.rule_count", offset_of!(carom_shape_plugin, rule_count), size_of::<u32>(), "u32"),
    ("carom_shape_plugin.reserved", offset_of!(carom_shape_plugin, reserved), size_of::<u32>(), "u32"),
    ("carom_shape_plugin.user", offset_of!(carom_shape_plugin, user), size_of::<*mut c_void>(), "ptr"),
    ("carom_shape_plugin.text", offset_of!(carom_shape_plugin, text), size_of::<*const c_char>(), "ptr"),
    ("carom_distance_desc", 0, size_of::<carom_distance_desc>(), "struct"),
    ("carom_distance_desc.struct_size", offset_of!(carom_distance_desc, struct_size), size_of::<u32>(), "u32"),
    ("carom_distance_desc.simplex", offset_of!(carom_distance_desc, simplex), size_of::<u32>(), "u32"),
    ("carom_distance_desc.narrow_phase", offset_of!(carom_distance_desc, narrow_phase), size_of::<u32>(), "u32"),
    ("carom_distance_desc.pair_routines", offset_of!(carom_distance_desc, pair_routines), size_of::<u32>(), "u32"),
    ("carom_distance_desc.tolerance", offset_of!(carom_distance_desc, tolerance), size_of::<f64>(), "f64"),
    ("carom_distance_desc.hybrid_margin", offset_of!(carom_distance_desc, hybrid_margin), size_of::<f64>(), "f64"),
    ("carom_distance_desc.gjk_iterations", offset_of!(carom_distance_desc, gjk_iterations), size_of::<u32>(), "u32"),
    ("carom_distance_desc.epa_iterations", offset_of!(carom_distance_desc, epa_iterations), size_of::<u32>(), "u32"),
    ("carom_distance", 0, size_of::<carom_distance>(), "struct"),
    ("carom_distance.struct_size", offset_of!(carom_distance, struct_size), size_of::<u32>(), "u32"),
    ("carom_distance.status", offset_of!(carom_distance, status), size_of::<u32>(), "u32"),
    ("carom_distance.separation", offset_of!(carom_distance, separation), size_of::<f64>(), "f64"),
    ("carom_distance.lower", offset_of!(carom_distance, lower), size_of::<f64>(), "f64"),
    ("carom_distance.upper", offset_of!(carom_distance, upper), size_of::<f64>(), "f64"),
    ("carom_distance.normal", offset_of!(carom_distance, normal), size_of::<f64>() * 3, "f64[3]"),
    ("carom_distance.point_a", offset_of!(carom_distance, point_a), size_of::<f64>() * 3, "f64[3]"),
    ("carom_distance.point_b", offset_of!(carom_distance, point_b), size_of::<f64>() * 3, "f64[3]"),
    ("carom_distance.gjk_iterations", offset_of!(carom_distance, gjk_iterations), size_of::<u32>(), "u32"),
    ("carom_distance.epa_iterations", offset_of!(carom_distance, epa_iterations), size_of::<u32>(), "u32"),
    ("carom_distance.support_calls", offset_of!(carom_distance, support_calls), size_of::<u32>(), "u32"),
    ("carom_distance.reserved", offset_of!(carom_distance, reserved), size_of::<u32>(), "u32"),
    ("carom_difference", 0, size_of::<carom_difference>(), "struct"),
    ("carom_difference.struct_size", offset_of!(carom_difference, struct_size), size_of::<u32>(), "u32"),
    ("carom_difference.differs", offset_of!(carom_difference, differs), size_of::<u32>(), "u32"),
    ("carom_difference.first", offset_of!(carom_difference, first), size_of::<u64>(), "u64"),
    ("carom_difference.second", offset_of!(carom_difference, second), size_of::<u64>(), "u64"),
    ("carom_difference.sections", offset_of!(carom_difference, sections), size_of::<c_char>() * 240, "char[240]"),
    ("carom_residuals", 0, size_of::<carom_residuals>(), "struct"),
    ("carom_residuals.struct_size", offset_of!(carom_residuals, struct_size), size_of::<u32>(), "u32"),
    ("carom_residuals.ledger_is_kept", offset_of!(carom_residuals, ledger_is_kept), size_of::<u32>(), "u32"),
    ("carom_residuals.contact_points", offset_of!(carom_residuals, contact_points), size_of::<u64>(), "u64"),
    ("carom_residuals.joints", offset_of!(carom_residuals, joints), size_of::<u64>(), "u64"),
    ("carom_residuals.max_penetration", offset_of!(carom_residuals, max_penetration), size_of::<f64>(), "f64"),
    ("carom_residuals.mean_penetration", offset_of!(carom_residuals, mean_penetration), size_of::<f64>(), "f64"),
    ("carom_residuals.joint_gap", offset_of!(carom_residuals, joint_gap), size_of::<f64>(), "f64"),
    ("carom_residuals.joint_angle", offset_of!(carom_residuals, joint_angle), size_of::<f64>(), "f64"),
    ("carom_residuals.complementarity", offset_of!(carom_residuals, complementarity), size_of::<f64>(), "f64"),
    ("carom_residuals.cone", offset_of!(carom_residuals, cone), size_of::<f64>(), "f64"),
    ("carom_residuals.slip", offset_of!(carom_residuals, slip), size_of::<f64>(), "f64"),
    ("carom_residuals.energy", offset_of!(carom_residuals, energy), size_of::<f64>(), "f64"),
    ("carom_residuals.energy_drift", offset_of!(carom_residuals, energy_drift), size_of::<f64>(), "f64"),
    ("carom_mesh_desc", 0, size_of::<carom_mesh_desc>(), "struct"),
    ("carom_mesh_desc.struct_size", offset_of!(carom_mesh_desc, struct_size), size_of::<u32>(), "u32"),
    ("carom_mesh_desc.flags", offset_of!(carom_mesh_desc, flags), size_of::<u32>(), "u32"),
    ("carom_mesh_desc.vertices", offset_of!(carom_mesh_desc, vertices), size_of::<*const f64>(), "ptr"),
    ("carom_mesh_desc.vertex_count", offset_of!(carom_mesh_desc, vertex_count), size_of::<u64>(), "u64"),
    ("carom_mesh_desc.triangles", offset_of!(carom_mesh_desc, triangles), size_of::<*const u32>(), "ptr"),
    ("carom_mesh_desc.triangle_count", offset_of!(carom_mesh_desc, triangle_count), size_of::<u64>(), "u64"),
    ("carom_height_field_desc", 0, size_of::<carom_height_field_desc>(), "struct"),
    ("carom_height_field_desc.struct_size", offset_of!(carom_height_field_desc, struct_size), size_of::<u32>(), "u32"),
    ("carom_height_field_desc.flags", offset_of!(carom_height_field_desc, flags), size_of::<u32>(), "u32"),
    ("carom_height_field_desc.columns", offset_of!(carom_height_field_desc, columns), size_of::<u32>(), "u32"),
    ("carom_height_field_desc.rows", offset_of!(carom_height_field_desc, rows), size_of::<u32>(), "u32"),
    ("carom_height_field_desc.heights", offset_of!(carom_height_field_desc, heights), size_of::<*const f64>(), "ptr"),
    ("carom_height_field_desc.spacing", offset_of!(carom_height_field_desc, spacing), size_of::<f64>() * 2, "f64[2]"),
    ("carom_scenery_info", 0, size_of::<carom_scenery_info>(), "struct"),
    ("carom_scenery_info.struct_size", offset_of!(carom_scenery_info, struct_size), size_of::<u32>(), "u32"),
    ("carom_scenery_info.flags", offset_of!(carom_scenery_info, flags), size_of::<u32>(), "u32"),
    ("carom_scenery_info.triangles", offset_of!(carom_scenery_info, triangles), size_of::<u64>(), "u64"),
    ("carom_scenery_info.vertices", offset_of!(carom_scenery_info, vertices), size_of::<u64>(), "u64"),
    ("carom_scenery_info.dropped", offset_of!(carom_scenery_info, dropped), size_of::<u64>(), "u64"),
    ("carom_scenery_info.boundary_edges", offset_of!(carom_scenery_info, boundary_edges), size_of::<u64>(), "u64"),
    ("carom_scenery_info.bytes", offset_of!(carom_scenery_info, bytes), size_of::<u64>(), "u64"),
    ("carom_shape_info", 0, size_of::<carom_shape_info>(), "struct"),
    ("carom_shape_info.struct_size", offset_of!(carom_shape_info, struct_size), size_of::<u32>(), "u32"),
    ("carom_shape_info.form", offset_of!(carom_shape_info, form), size_of::<u32>(), "u32"),
    ("carom_shape_info.is_half_space", offset_of!(carom_shape_info, is_half_space), size_of::<u32>(), "u32"),
    ("carom_shape_info.mass_exact", offset_of!(carom_shape_info, mass_exact), size_of::<u32>(), "u32"),
    ("carom_shape_info.plugin", offset_of!(carom_shape_info, plugin), size_of::<carom_plugin>(), "u64"),
    ("carom_shape_info.param_count", offset_of!(carom_shape_info, param_count), size_of::<u64>(), "u64"),
    ("carom_shape_info.core_radius", offset_of!(carom_shape_info, core_radius), size_of::<f64>(), "f64"),
    ("carom_shape_info.bounding_radius", offset_of!(carom_shape_info, bounding_radius), size_of::<f64>(), "f64"),
    ("carom_shape_info.aabb_min", offset_of!(carom_shape_info, aabb_min), size_of::<f64>() * 3, "f64[3]"),
    ("carom_shape_info.aabb_max", offset_of!(carom_shape_info, aabb_max), size_of::<f64>() * 3, "f64[3]"),
    ("carom_shape_info.volume", offset_of!(carom_shape_info, volume), size_of::<f64>(), "f64"),
    ("carom_shape_info.volume_min", offset_of!(carom_shape_info, volume_min), size_of::<f64>(), "f64"),
    ("carom_shape_info.volume_max", offset_of!(carom_shape_info, volume_max), size_of::<f64>(), "f64"),
    ("carom_shape_info.centroid", offset_of!(carom_shape_info, centroid), size_of::<f64>() * 3, "f64[3]"),
    ("carom_shape_info.centroid_error", offset_of!(carom_shape_info, centroid_error), size_of::<f64>(), "f64"),
    ("carom_shape_info.inertia", offset_of!(carom_shape_info, inertia), size_of::<f64>() * 9, "f64[9]"),
    ("carom_shape_info.inertia_error", offset_of!(carom_shape_info, inertia_error), size_of::<f64>(), "f64"),
    ("carom_shape_info.is_scenery", offset_of!(carom_shape_info, is_scenery), size_of::<u32>(), "u32"),
    ("carom_shape_info.reserved", offset_of!(carom_shape_info, reserved), size_of::<u32>(), "u32"),
    ("carom_tree_coordinate", 0, size_of::<carom_tree_coordinate>(), "struct"),
    ("carom_tree_coordinate.joint", offset_of!(carom_tree_coordinate, joint), size_of::<carom_joint>(), "u64"),
    ("carom_tree_coordinate.body", offset_of!(carom_tree_coordinate, body), size_of::<carom_body>(), "u64"),
    ("carom_tree_coordinate.axis", offset_of!(carom_tree_coordinate, axis), size_of::<u32>(), "u32"),
    ("carom_tree_coordinate.reserved", offset_of!(carom_tree_coordinate, reserved), size_of::<u32>(), "u32"),
    ("carom_vehicle_desc", 0, size_of::<carom_vehicle_desc>(), "struct"),
    ("carom_vehicle_desc.struct_size", offset_of!(carom_vehicle_desc, struct_size), size_of::<u32>(), "u32"),
    ("carom_vehicle_desc.flags", offset_of!(carom_vehicle_desc, flags), size_of::<u32>(), "u32"),
    ("carom_vehicle_desc.chassis", offset_of!(carom_vehicle_desc, chassis), size_of::<carom_body>(), "u64"),
    ("carom_vehicle_desc.up", offset_of!(carom_vehicle_desc, up), size_of::<f64>() * 3, "f64[3]"),
    ("carom_vehicle_desc.forward", offset_of!(carom_vehicle_desc, forward), size_of::<f64>() * 3, "f64[3]"),
    ("carom_vehicle_desc.category", offset_of!(carom_vehicle_desc, category), size_of::<u64>(), "u64"),
    ("carom_vehicle_desc.mask", offset_of!(carom_vehicle_desc, mask), size_of::<u64>(), "u64"),
    ("carom_vehicle_desc.torque_count", offset_of!(carom_vehicle_desc, torque_count), size_of::<u32>(), "u32"),
    ("carom_vehicle_desc.gear_count", offset_of!(carom_vehicle_desc, gear_count), size_of::<u32>(), "u32"),
    ("carom_vehicle_desc.torque_speeds", offset_of!(carom_vehicle_desc, torque_speeds), size_of::<f64>() * 8, "f64[8]"),
    ("carom_vehicle_desc.torques", offset_of!(carom_vehicle_desc, torques), size_of::<f64>() * 8, "f64[8]"),
    ("carom_vehicle_desc.idle_speed", offset_of!(carom_vehicle_desc, idle_speed), size_of::<f64>(), "f64"),
    ("carom_vehicle_desc.max_speed", offset_of!(carom_vehicle_desc, max_speed), size_of::<f64>(), "f64"),
    ("carom_vehicle_desc.engine_inertia", offset_of!(carom_vehicle_desc, engine_inertia), size_of::<f64>(), "f64"),
    ("carom_vehicle_desc.engine_drag", offset_of!(carom_vehicle_desc, engine_drag), size_of::<f64>(), "f64"),
    ("carom_vehicle_desc.gears", offset_of!(carom_vehicle_desc, gears), size_of::<f64>() * 8, "f64[8]"),
    ("carom_vehicle_desc.reverse", offset_of!(carom_vehicle_desc, reverse), size_of::<f64>(), "f64"),
    ("carom_vehicle_desc.final_drive", offset_of!(carom_vehicle_desc, final_drive), size_of::<f64>(), "f64"),
    ("carom_vehicle_desc.clutch_torque", offset_of!(carom_vehicle_desc, clutch_torque), size_of::<f64>(), "f64"),
    ("carom_vehicle_desc.shift_up", offset_of!(carom_vehicle_desc, shift_up), size_of::<f64>(), "f64"),
    ("carom_vehicle_desc.shift_down", offset_of!(carom_vehicle_desc, shift_down), size_of::<f64>(), "f64"),
    ("carom_vehicle_desc.shift_time", offset_of!(carom_vehicle_desc, shift_time), size_of::<f64>(), "f64"),
    ("carom_vehicle_desc.limited_slip", offset_of!(carom_vehicle_desc, limited_slip), size_of::<f64>(), "f64"),
    ("carom_wheel_desc", 0, size_of::<carom_wheel_desc>(), "struct"),
    ("carom_wheel_desc.struct_size", offset_of!(carom_wheel_desc, struct_size), size_of::<u32>(), "u32"),
    ("carom_wheel_desc.anti_roll_partner", offset_of!(carom_wheel_desc, anti_roll_partner), size_of::<u32>(), "u32"),
    ("carom_wheel_desc.shape", offset_of!(carom_wheel_desc, shape), size_of::<carom_shape>(), "u64"),
    ("carom_wheel_desc.position", offset_of!(carom_wheel_desc, position), size_of::<f64>() * 3, "f64[3]"),
    ("carom_wheel_desc.radius", offset_of!(carom_wheel_desc, radius), size_of::<f64>(), "f64"),
    ("carom_wheel_desc.inertia", offset_of!(carom_wheel_desc, inertia), size_of::<f64>(), "f64"),
    ("carom_wheel_desc.travel", offset_of!(carom_wheel_desc, travel), size_of::<f64>(), "f64"),
    ("carom_wheel_desc.stiffness", offset_of!(carom_wheel_desc, stiffness), size_of::<f64>(), "f64"),
    ("carom_wheel_desc.damping_bump", offset_of!(carom_wheel_desc, damping_bump), size_of::<f64>(), "f64"),
    ("carom_wheel_desc.damping_rebound", offset_of!(carom_wheel_desc, damping_rebound), size_of::<f64>(), "f64"),
    ("carom_wheel_desc.anti_roll", offset_of!(carom_wheel_desc, anti_roll), size_of::<f64>(), "f64"),
    ("carom_wheel_desc.max_steer", offset_of!(carom_wheel_desc, max_steer), size_of::<f64>(), "f64"),
    ("carom_wheel_desc.drive", offset_of!(carom_wheel_desc, drive), size_of::<f64>(), "f64"),
    ("carom_wheel_desc.brake", offset_of!(carom_wheel_desc, brake), size_of::<f64>(), "f64"),
    ("carom_wheel_desc.handbrake", offset_of!(carom_wheel_desc, handbrake), size_of::<f64>(), "f64"),
    ("carom_wheel_desc.rolling", offset_of!(carom_wheel_desc, rolling), size_of::<f64>(), "f64"),
    ("carom_wheel_desc.grip", offset_of!(carom_wheel_desc, grip), size_of::<f64>(), "f64"),
    ("carom_wheel_desc.side_grip", offset_of!(carom_wheel_desc, side_grip), size_of::<f64>(), "f64"),
    ("carom_wheel_desc.peak_slip", offset_of!(carom_wheel_desc, peak_slip), size_of::<f64>(), "f64"),
    ("carom_wheel_desc.side_peak_slip", offset_of!(carom_wheel_desc, side_peak_slip), size_of::<f64>(), "f64"),
    ("carom_wheel_desc.slide", offset_of!(carom_wheel_desc, slide), size_of::<f64>(), "f64"),
    ("carom_wheel_desc.slide_slip", offset_of!(carom_wheel_desc, slide_slip), size_of::<f64>(), "f64"),
    ("carom_wheel_desc.relaxation", offset_of!(carom_wheel_desc, relaxation), size_of::<f64>(), "f64"),
    ("carom_vehicle_input", 0, size_of::<carom_vehicle_input>(), "struct"),
    ("carom_vehicle_input.struct_size", offset_of!(carom_vehicle_input, struct_size), size_of::<u32>(), "u32"),
    ("carom_vehicle_input.gear", offset_of!(carom_vehicle_input, gear), size_of::<i32>(), "i32"),
    ("carom_vehicle_input.throttle", offset_of!(carom_vehicle_input, throttle), size_of::<f64>(), "f64"),
    ("carom_vehicle_input.brake", offset_of!(carom_vehicle_input, brake), size_of::<f64>(), "f64"),
    ("carom_vehicle_input.handbrake", offset_of!(carom_vehicle_input, handbrake), size_of::<f64>(), "f64"),
    ("carom_vehicle_input.steer", offset_of!(carom_vehicle_input, steer), size_of::<f64>(), "f64"),
    ("carom_vehicle", 0, size_of::<carom_vehicle>(), "struct"),
    ("carom_vehicle.struct_size", offset_of!(carom_vehicle, struct_size), size_of::<u32>(), "u32"),
    ("carom_vehicle.gear", offset_of!(carom_vehicle, gear), size_of::<i32>(), "i32"),
    ("carom_vehicle.engine_speed", offset_of!(carom_vehicle, engine_speed), size_of::<f64>(), "f64"),
    ("carom_vehicle.shifting", offset_of!(carom_vehicle, shifting), size_of::<f64>(), "f64"),
    ("carom_vehicle.since_shift", offset_of!(carom_vehicle, since_shift), size_of::<f64>(), "f64"),
    ("carom_vehicle.speed", offset_of!(carom_vehicle, speed), size_of::<f64>(), "f64"),
    ("carom_wheel", 0, size_of::<carom_wheel>(), "struct"),
    ("carom_wheel.struct_size", offset_of!(carom_wheel, struct_size), size_of::<u32>(), "u32"),
    ("carom_wheel.touches", offset_of!(carom_wheel, touches), size_of::<u32>(), "u32"),
    ("carom_wheel.body", offset_of!(carom_wheel, body), size_of::<carom_body>(), "u64"),
    ("carom_wheel.collider", offset_of!(carom_wheel, collider), size_of::<carom_collider>(), "u64"),
    ("carom_wheel.point", offset_of!(carom_wheel, point), size_of::<f64>() * 3, "f64[3]"),
    ("carom_wheel.normal", offset_of!(carom_wheel, normal), size_of::<f64>() * 3, "f64[3]"),
    ("carom_wheel.position", offset_of!(carom_wheel, position), size_of::<f64>() * 3, "f64[3]"),
    ("carom_wheel.compression", offset_of!(carom_wheel, compression), size_of::<f64>(), "f64"),
    ("carom_wheel.spin", offset_of!(carom_wheel, spin), size_of::<f64>(), "f64"),
    ("carom_wheel.angle", offset_of!(carom_wheel, angle), size_of::<f64>(), "f64"),
    ("carom_wheel.steer", offset_of!(carom_wheel, steer), size_of::<f64>(), "f64"),
    ("carom_wheel.load", offset_of!(carom_wheel, load), size_of::<f64>(), "f64"),
    ("carom_wheel.force", offset_of!(carom_wheel, force), size_of::<f64>(), "f64"),
    ("carom_wheel.side_force", offset_of!(carom_wheel, side_force), size_of::<f64>(), "f64"),
    ("carom_wheel.slip", offset_of!(carom_wheel, slip), size_of::<f64>(), "f64"),
    ("carom_wheel.side_slip", offset_of!(carom_wheel, side_slip), size_of::<f64>(), "f64"),
    ("carom_world_desc", 0, size_of::<carom_world_desc>(), "struct"),
    ("carom_world_desc.struct_size", offset_of!(carom_world_desc, struct_size), size_of::<u32>(), "u32"),
    ("carom_world_desc.reserved", offset_of!(carom_world_desc, reserved), size_of::<u32>(), "u32"),
    ("carom_world_desc.gravity", offset_of!(carom_world_desc, gravity), size_of::<f64>() * 3, "f64[3]"),
    ("carom_world_desc.body_capacity", offset_of!(carom_world_desc, body_capacity), size_of::<u64>(), "u64"),
    ("carom_step_report", 0, size_of::<carom_step_report>(), "struct"),
    ("carom_step_report.struct_size", offset_of!(carom_step_report, struct_size), size_of::<u32>(), "u32"),
    ("carom_step_report.stage_count", offset_of!(carom_step_report, stage_count), size_of::<u32>(), "u32"),
    ("carom_step_report.stage_seconds", offset_of!(carom_step_report, stage_seconds), size_of::<f64>() * 16, "f64[16]"),
    ("carom_step_report.total_seconds", offset_of!(carom_step_report, total_seconds), size_of::<f64>(), "f64"),
    ("carom_step_report.steps", offset_of!(carom_step_report, steps), size_of::<u64>(), "u64"),
    ("carom_step_report.time", offset_of!(carom_step_report, time), size_of::<f64>(), "f64"),
    ("carom_step_report.bodies", offset_of!(carom_step_report, bodies), size_of::<u64>(), "u64"),
    ("carom_step_report.dynamic_bodies", offset_of!(carom_step_report, dynamic_bodies), size_of::<u64>(), "u64"),
    ("carom_step_report.colliders", offset_of!(carom_step_report, colliders), size_of::<u64>(), "u64"),
    ("carom_step_report.broad_pairs", offset_of!(carom_step_report, broad_pairs), size_of::<u64>(), "u64"),
    ("carom_step_report.contact_pairs", offset_of!(carom_step_report, contact_pairs), size_of::<u64>(), "u64"),
    ("carom_step_report.contact_points", offset_of!(carom_step_report, contact_points), size_of::<u64>(), "u64"),
    ("carom_step_report.groups", offset_of!(carom_step_report, groups), size_of::<u64>(), "u64"),
    ("carom_step_report.largest_group", offset_of!(carom_step_report, largest_group), size_of::<u64>(), "u64"),
    ("carom_step_report.gjk_calls", offset_of!(carom_step_report, gjk_calls), size_of::<u64>(), "u64"),
    ("carom_step_report.epa_calls", offset_of!(carom_step_report, epa_calls), size_of::<u64>(), "u64"),
    ("carom_step_report.support_calls", offset_of!(carom_step_report, support_calls), size_of::<u64>(), "u64"),
    ("carom_step_report.velocity_impulses", offset_of!(carom_step_report, velocity_impulses), size_of::<u64>(), "u64"),
    ("carom_step_report.position_moves", offset_of!(carom_step_report, position_moves), size_of::<u64>(), "u64"),
    ("carom_step_report.quarantined_bodies", offset_of!(carom_step_report, quarantined_bodies), size_of::<u64>(), "u64"),
    ("carom_step_report.faults", offset_of!(carom_step_report, faults), size_of::<u64>(), "u64"),
    ("carom_step_report.max_penetration", offset_of!(carom_step_report, max_penetration), size_of::<f64>(), "f64"),
    ("carom_step_report.mean_penetration", offset_of!(carom_step_report, mean_penetration), size_of::<f64>(), "f64"),
    ("carom_step_report.max_closing_speed", offset_of!(carom_step_report, max_closing_speed), size_of::<f64>(), "f64"),
    ("carom_step_report.linear_energy", offset_of!(carom_step_report, linear_energy), size_of::<f64>(), "f64"),
    ("carom_step_report.angular_energy", offset_of!(carom_step_report, angular_energy), size_of::<f64>(), "f64"),
    ("carom_step_report.asleep_bodies", offset_of!(carom_step_report, asleep_bodies), size_of::<u64>(), "u64"),
    ("carom_step_report.fell_asleep", offset_of!(carom_step_report, fell_asleep), size_of::<u64>(), "u64"),
    ("carom_step_report.woke_up", offset_of!(carom_step_report, woke_up), size_of::<u64>(), "u64"),
    ("carom_step_report.direct_groups", offset_of!(carom_step_report, direct_groups), size_of::<u64>(), "u64"),
    ("carom_step_report.solver_residual", offset_of!(carom_step_report, solver_residual), size_of::<f64>(), "f64"),
    ("carom_step_report.particles", offset_of!(carom_step_report, particles), size_of::<u64>(), "u64"),
    ("carom_step_report.quarantined_particles", offset_of!(carom_step_report, quarantined_particles), size_of::<u64>(), "u64"),
    ("carom_step_report.swept_bodies", offset_of!(carom_step_report, swept_bodies), size_of::<u64>(), "u64"),
    ("carom_step_report.sweep_hits", offset_of!(carom_step_report, sweep_hits), size_of::<u64>(), "u64"),
    ("carom_step_report.wedged_groups", offset_of!(carom_step_report, wedged_groups), size_of::<u64>(), "u64"),
    ("carom_step_report.rejected_solutions", offset_of!(carom_step_report, rejected_solutions), size_of::<u64>(), "u64"),
    ("carom_step_report.excess_energy", offset_of!(carom_step_report, excess_energy), size_of::<f64>(), "f64"),
    ("carom_contact", 0, size_of::<carom_contact>(), "struct"),
    ("carom_contact.collider_a", offset_of!(carom_contact, collider_a), size_of::<carom_collider>(), "u64"),
    ("carom_contact.collider_b", offset_of!(carom_contact, collider_b), size_of::<carom_collider>(), "u64"),
    ("carom_contact.body_a", offset_of!(carom_contact, body_a), size_of::<carom_body>(), "u64"),
    ("carom_contact.body_b", offset_of!(carom_contact, body_b), size_of::<carom_body>(), "u64"),
    ("carom_contact.point", offset_of!(carom_contact, point), size_of::<f64>() * 3, "f64[3]"),
    ("carom_contact.normal", offset_of!(carom_contact, normal), size_of::<f64>() * 3, "f64[3]"),
    ("carom_contact.separation", offset_of!(carom_contact, separation), size_of::<f64>(), "f64"),
    ("carom_contact.normal_impulse", offset_of!(carom_contact, normal_impulse), size_of::<f64>(), "f64"),
    ("carom_contact.friction_impulse", offset_of!(carom_contact, friction_impulse), size_of::<f64>(), "f64"),
    ("carom_group", 0, size_of::<carom_group>(), "struct"),
    ("carom_group.body", offset_of!(carom_group, body), size_of::<carom_body>(), "u64"),
    ("carom_group.bodies", offset_of!(carom_group, bodies), size_of::<u32>(), "u32"),
    ("carom_group.points", offset_of!(carom_group, points), size_of::<u32>(), "u32"),
    ("carom_group.solver", offset_of!(carom_group, solver), size_of::<u32>(), "u32"),
    ("carom_group.reason", offset_of!(carom_group, reason), size_of::<u32>(), "u32"),
    ("carom_group.mass_ratio", offset_of!(carom_group, mass_ratio), size_of::<f64>(), "f64"),
    ("carom_group.sink", offset_of!(carom_group, sink), size_of::<f64>(), "f64"),
    ("carom_fault", 0, size_of::<carom_fault>(), "struct"),
    ("carom_fault.kind", offset_of!(carom_fault, kind), size_of::<u32>(), "u32"),
    ("carom_fault.reserved", offset_of!(carom_fault, reserved), size_of::<u32>(), "u32"),
    ("carom_fault.shape", offset_of!(carom_fault, shape), size_of::<carom_shape>(), "u64"),
    ("carom_fault.body", offset_of!(carom_fault, body), size_of::<carom_body>(), "u64"),
    ("carom_fault.dir", offset_of!(carom_fault, dir), size_of::<f64>() * 3, "f64[3]"),
    ("carom_fault.out", offset_of!(carom_fault, out), size_of::<f64>() * 3, "f64[3]"),
    ("carom_fault.particles", offset_of!(carom_fault, particles), size_of::<carom_particles>(), "u64"),
    ("carom_fault.particle", offset_of!(carom_fault, particle), size_of::<u64>(), "u64"),
    ("carom_query_desc", 0, size_of::<carom_query_desc>(), "struct"),
    ("carom_query_desc.struct_size", offset_of!(carom_query_desc, struct_size), size_of::<u32>(), "u32"),
    ("carom_query_desc.flags", offset_of!(carom_query_desc, flags), size_of::<u32>(), "u32"),
    ("carom_query_desc.category", offset_of!(carom_query_desc, category), size_of::<u64>(), "u64"),
    ("carom_query_desc.mask", offset_of!(carom_query_desc, mask), size_of::<u64>(), "u64"),
    ("carom_query_desc.ignore", offset_of!(carom_query_desc, ignore), size_of::<carom_body>(), "u64"),
    ("carom_query_desc.tolerance", offset_of!(carom_query_desc, tolerance), size_of::<f64>(), "f64"),
    ("carom_query_desc.target", offset_of!(carom_query_desc, target), size_of::<f64>(), "f64"),
    ("carom_query_desc.iterations", offset_of!(carom_query_desc, iterations), size_of::<u32>(), "u32"),
    ("carom_query_desc.reserved", offset_of!(carom_query_desc, reserved), size_of::<u32>(), "u32"),
    ("carom_world_hit", 0, size_of::<carom_world_hit>(), "struct"),
    ("carom_world_hit.outcome", offset_of!(carom_world_hit, outcome), size_of::<u32>(), "u32"),
    ("carom_world_hit.status", offset_of!(carom_world_hit, status), size_of::<u32>(), "u32"),
    ("carom_world_hit.query", offset_of!(carom_world_hit, query), size_of::<u64>(), "u64"),
    ("carom_world_hit.collider", offset_of!(carom_world_hit, collider), size_of::<carom_collider>(), "u64"),
    ("carom_world_hit.body", offset_of!(carom_world_hit, body), size_of::<carom_body>(), "u64"),
    ("carom_world_hit.time", offset_of!(carom_world_hit, time), size_of::<f64>(), "f64"),
    ("carom_world_hit.lower", offset_of!(carom_world_hit, lower), size_of::<f64>(), "f64"),
    ("carom_world_hit.upper", offset_of!(carom_world_hit, upper), size_of::<f64>(), "f64"),
    ("carom_world_hit.separation", offset_of!(carom_world_hit, separation), size_of::<f64>(), "f64"),
    ("carom_world_hit.normal", offset_of!(carom_world_hit, normal), size_of::<f64>() * 3, "f64[3]"),
    ("carom_world_hit.point", offset_of!(carom_world_hit, point), size_of::<f64>() * 3, "f64[3]"),
    ("carom_world_hit.point_own", offset_of!(carom_world_hit, point_own), size_of::<f64>() * 3, "f64[3]"),
    ("carom_query_shapes", 0, size_of::<carom_query_shapes>(), "struct"),
    ("carom_query_shapes.struct_size", offset_of!(carom_query_shapes, struct_size), size_of::<u32>(), "u32"),
    ("carom_query_shapes.scalar", offset_of!(carom_query_shapes, scalar), size_of::<u32>(), "u32"),
    ("carom_query_shapes.count", offset_of!(carom_query_shapes, count), size_of::<u64>(), "u64"),
    ("carom_query_shapes.shapes", offset_of!(carom_query_shapes, shapes), size_of::<*const carom_shape>(), "ptr"),
    ("carom_query_shapes.positions", offset_of!(carom_query_shapes, positions), size_of::<*const c_void>(), "ptr"),
    ("carom_query_shapes.orientations", offset_of!(carom_query_shapes, orientations), size_of::<*const c_void>(), "ptr"),
    ("carom_query_shapes.motions", offset_of!(carom_query_shapes, motions), size_of::<*const c_void>(), "ptr"),
    ("carom_query_shapes.shape_stride", offset_of!(carom_query_shapes, shape_stride), size_of::<u64>(), "u64"),
    ("carom_query_shapes.position_stride", offset_of!(carom_query_shapes, position_stride), size_of::<u64>(), "u64"),
    ("carom_query_shapes.orientation_stride", offset_of!(carom_query_shapes, orientation_stride), size_of::<u64>(), "u64"),
    ("carom_query_shapes.motion_stride", offset_of!(carom_query_shapes, motion_stride), size_of::<u64>(), "u64"),
    ("carom_world_hits", 0, size_of::<carom_world_hits>(), "struct"),
    ("carom_world_hits.struct_size", offset_of!(carom_world_hits, struct_size), size_of::<u32>(), "u32"),
    ("carom_world_hits.scalar", offset_of!(carom_world_hits, scalar), size_of::<u32>(), "u32"),
    ("carom_world_hits.records", offset_of!(carom_world_hits, records), size_of::<*mut carom_world_hit>(), "ptr"),
    ("carom_world_hits.outcomes", offset_of!(carom_world_hits, outcomes), size_of::<*mut u32>(), "ptr"),
    ("carom_world_hits.colliders", offset_of!(carom_world_hits, colliders), size_of::<*mut carom_collider>(), "ptr"),
    ("carom_world_hits.times", offset_of!(carom_world_hits, times), size_of::<*mut c_void>(), "ptr"),
    ("carom_world_hits.normals", offset_of!(carom_world_hits, normals), size_of::<*mut c_void>(), "ptr"),
    ("carom_world_hits.points", offset_of!(carom_world_hits, points), size_of::<*mut c_void>(), "ptr"),
    ("carom_world_hits.record_stride", offset_of!(carom_world_hits, record_stride), size_of::<u64>(), "u64"),
    ("carom_world_hits.outcome_stride", offset_of!(carom_world_hits, outcome_stride), size_of::<u64>(), "u64"),
    ("carom_world_hits.collider_stride", offset_of!(carom_world_hits, collider_stride), size_of::<u64>(), "u64"),
    ("carom_world_hits.time_stride", offset_of!(carom_world_hits, time_stride), size_of::<u64>(), "u64"),
    ("carom_world_hits.normal_stride", offset_of!(carom_world_hits, normal_stride), size_of::<u64>(), "u64"),
    ("carom_world_hits.point_stride", offset_of!(carom_world_hits, point_stride), size_of::<u64>(), "u64"),
];
