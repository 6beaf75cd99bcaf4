// Written by bindings/gen/generate from include/carom; do not edit.
package carom;

import static java.lang.foreign.ValueLayout.*;

import java.lang.foreign.*;
import java.lang.invoke.MethodHandle;
import java.util.function.Consumer;

/** All of include/carom: functions and constants under their own names, structs as classes. A handle is a long. */
public final class Raw {
    private Raw() {}

    public static final String VERSION = "0.9.0";
    public static final String SONAME = "libcarom.so.0.9";
    /** of these headers */
    public static final int CAROM_VERSION_MAJOR = 0;
    /** of these headers */
    public static final int CAROM_VERSION_MINOR = 9;
    /** of these headers */
    public static final int CAROM_VERSION_PATCH = 0;
    /** the call did what it says */
    public static final int CAROM_OK = 0;
    /** a required pointer is NULL */
    public static final int CAROM_E_NULL_ARGUMENT = -1;
    /** a number is NaN or infinite */
    public static final int CAROM_E_NOT_FINITE = -2;
    /** a number is finite but outside its documented bounds */
    public static final int CAROM_E_OUT_OF_RANGE = -3;
    /** a quaternion or normal is further than 1e-6 from unit length */
    public static final int CAROM_E_NOT_UNIT = -4;
    /** an enumeration value this library does not know */
    public static final int CAROM_E_UNKNOWN_ENUM = -5;
    /** struct_size is smaller than the smallest version of the struct */
    public static final int CAROM_E_STRUCT_SIZE = -6;
    /** the request comes from a newer header, or asks for what this build cannot do */
    public static final int CAROM_E_UNSUPPORTED = -7;
    /** the handle was never issued */
    public static final int CAROM_E_INVALID_HANDLE = -8;
    /** the object behind the handle was destroyed */
    public static final int CAROM_E_STALE_HANDLE = -9;
    /** a handle of another kind (a shape where a body is wanted, ...) */
    public static final int CAROM_E_WRONG_KIND = -10;
    /** a handle of another world or engine */
    public static final int CAROM_E_WRONG_WORLD = -11;
    /** another thread is stepping, changing or reading this world */
    public static final int CAROM_E_BUSY = -12;
    /** called from inside a callback (a support function, allocator or log) */
    public static final int CAROM_E_REENTRANT = -13;
    /** the object is still referred to by others */
    public static final int CAROM_E_IN_USE = -14;
    /** the allocator returned NULL */
    public static final int CAROM_E_OUT_OF_MEMORY = -15;
    /** a hard limit of the library is reached */
    public static final int CAROM_E_LIMIT = -16;
    /** stride or capacity does not hold one element */
    public static final int CAROM_E_BUFFER_TOO_SMALL = -17;
    /** the path is not absolute, or nothing readable is there */
    public static final int CAROM_E_PLUGIN_PATH = -18;
    /** the dynamic loader refused the file, or the entry symbol is missing */
    public static final int CAROM_E_PLUGIN_LOAD = -19;
    /** the plugin was built against an incompatible plugin.h */
    public static final int CAROM_E_PLUGIN_ABI = -20;
    /** the support function is not one of a bounded convex set; see the witness */
    public static final int CAROM_E_PLUGIN_INVALID = -21;
    /** a declaration disagrees with the support function; see the witness */
    public static final int CAROM_E_DECLARATION_FALSE = -22;
    /** the body is flat, so no mass follows from a density */
    public static final int CAROM_E_NO_VOLUME = -23;
    /** a plugin with this id is already loaded */
    public static final int CAROM_E_ALREADY_EXISTS = -24;
    /** no object of this name */
    public static final int CAROM_E_NOT_FOUND = -25;
    /** a fault of the library itself; please report it */
    public static final int CAROM_E_INTERNAL = -26;
    /** bytes that are damaged, cut off or no snapshot */
    public static final int CAROM_E_CORRUPT = -27;
    /** a snapshot of a world with other things in it */
    public static final int CAROM_E_MISMATCH = -28;
    /** a function that the host gave to write with said that it failed */
    public static final int CAROM_E_WRITE_FAILED = -29;
    /** a number of the library that is fixed, no dial */
    public static final int CAROM_E_READ_ONLY = -30;
    /** no object: never the handle of one */
    public static final long CAROM_NULL_HANDLE = 0x0L;
    /** float, 4 bytes */
    public static final int CAROM_SCALAR_F32 = 0;
    /** double, 8 bytes */
    public static final int CAROM_SCALAR_F64 = 1;
    /** its error was estimated in this step, else in one before */
    public static final int CAROM_ISLAND_ESTIMATED = 1;
    /** the bound of work was reached: its error is over the tolerance */
    public static final int CAROM_ISLAND_BOUND = 2;
    /** joints alone hold it: its error is of order 2, 4 or 6 */
    public static final int CAROM_ISLAND_JOINTS_ALONE = 4;
    /** more substeps do not lessen its error, which is over the tolerance: contacts, mostly */
    public static final int CAROM_ISLAND_STALLED = 8;
    /** bodies: one CAROM_FIELD_* */
    public static final int CAROM_COLUMN_BODIES = 0;
    /** joints: one CAROM_JOINT_BULK_* */
    public static final int CAROM_COLUMN_JOINTS = 1;
    /** dynamic bodies: 1, kg; writing scales the inertia alike, the centre stays */
    public static final int CAROM_COLUMN_MASSES = 2;
    /** materials: 2, friction and restitution */
    public static final int CAROM_COLUMN_MATERIALS = 3;
    /** the world, n is 1: 3, m/s^2 */
    public static final int CAROM_COLUMN_GRAVITY = 4;
    /** the world, n is 1: 1, s, simulated; read only */
    public static final int CAROM_COLUMN_TIME = 5;
    /** bodies: 3, N, world: normal forces on it, mean of the last step; read only */
    public static final int CAROM_COLUMN_CONTACT_FORCES = 6;
    /** bodies or the world: 1, how far along a ray something is met first, in parts of `direction`, `max` where nothing is; read only */
    public static final int CAROM_COLUMN_RAYS = 7;
    public static final int CAROM_COLUMN_COUNT = 8;
    /** by carom_batch_read() and carom_batch_write() */
    public static final int CAROM_WHEN_ON_CALL = 0;
    /** written before each step, too */
    public static final int CAROM_WHEN_BEFORE_STEP = 1;
    /** read after each step, too, and after calls that change worlds */
    public static final int CAROM_WHEN_AFTER_STEP = 2;
    public static final int CAROM_WHEN_COUNT = 3;
    /** it steps */
    public static final int CAROM_STOPPED_NO = 0;
    /** a step had faults: carom_batch_get_faults() */
    public static final int CAROM_STOPPED_FAULT = 1;
    /** there was no memory for a step: it is as before that */
    public static final int CAROM_STOPPED_MEMORY = 2;
    /** in [0, 1) */
    public static final int CAROM_RANDOM_UNIFORM = 0;
    /** mean 0, deviation 1 */
    public static final int CAROM_RANDOM_NORMAL = 1;
    public static final int CAROM_RANDOM_COUNT = 2;
    /** root of a b */
    public static final int CAROM_MIX_GEOMETRIC_MEAN = 0;
    /** the larger */
    public static final int CAROM_MIX_MAXIMUM = 1;
    /** the smaller */
    public static final int CAROM_MIX_MINIMUM = 2;
    /** (a + b) / 2 */
    public static final int CAROM_MIX_AVERAGE = 3;
    /** a b */
    public static final int CAROM_MIX_MULTIPLY = 4;
    /** never moves */
    public static final int CAROM_BODY_STATIC = 0;
    /** moved by its velocity; infinite mass */
    public static final int CAROM_BODY_KINEMATIC = 1;
    /** moved by forces, contacts and joints */
    public static final int CAROM_BODY_DYNAMIC = 2;
    /** mass given; else from colliders' densities */
    public static final int CAROM_BODY_FIELD_MASS = 1;
    /** center given; else from colliders. needs MASS */
    public static final int CAROM_BODY_FIELD_CENTER = 2;
    /** inertia given; else from colliders, scaled to mass. needs MASS */
    public static final int CAROM_BODY_FIELD_INERTIA = 4;
    /** it never falls asleep, nor does what it touches */
    public static final int CAROM_BODY_STAYS_AWAKE = 8;
    /** it takes no part in steps, see carom_body_set_enabled() */
    public static final int CAROM_BODY_DISABLED = 16;
    /** its centre of mass keeps its world x */
    public static final int CAROM_LOCK_LINEAR_X = 1;
    /** likewise its y */
    public static final int CAROM_LOCK_LINEAR_Y = 2;
    /** likewise its z */
    public static final int CAROM_LOCK_LINEAR_Z = 4;
    /** it does not turn about the world's x axis */
    public static final int CAROM_LOCK_ANGULAR_X = 8;
    /** likewise about y */
    public static final int CAROM_LOCK_ANGULAR_Y = 16;
    /** likewise about z */
    public static final int CAROM_LOCK_ANGULAR_Z = 32;
    /** it keeps its pose */
    public static final int CAROM_LOCK_ALL = 63;
    /** LINEAR_Z, ANGULAR_X, ANGULAR_Y: a body of a flat world, the plane of x and y */
    public static final int CAROM_LOCK_PLANE = 28;
    /** carom_body_set_gravity_factor() */
    public static final int CAROM_ATTRIBUTE_GRAVITY_FACTOR = 0;
    /** carom_body_set_locks(); as the host gave them, whether or not they are forbidden */
    public static final int CAROM_ATTRIBUTE_LOCKS = 1;
    /** carom_body_set_drag(): linear, quadratic */
    public static final int CAROM_ATTRIBUTE_DRAG = 2;
    /** carom_body_set_force_field_mask() */
    public static final int CAROM_ATTRIBUTE_FORCE_FIELD_MASK = 3;
    /** A m^2, axes of the body: magnetic fields turn it, see CAROM_FORCE_FIELD_MAGNETIC */
    public static final int CAROM_ATTRIBUTE_MAGNETIC_MOMENT = 4;
    public static final int CAROM_ATTRIBUTE_COUNT = 5;
    /** the most that an attribute can have */
    public static final int CAROM_ATTRIBUTE_NUMBERS = 4;
    /** in steps in which it is fast for its size (default) */
    public static final int CAROM_CONTINUOUS_AUTO = 0;
    /** in every step */
    public static final int CAROM_CONTINUOUS_ALWAYS = 1;
    /** in none: cheap debris that may pass through walls */
    public static final int CAROM_CONTINUOUS_NEVER = 2;
    /** default category, see carom_collider_set_filter() */
    public static final long CAROM_FILTER_CATEGORY = 0x1L;
    /** default mask */
    public static final long CAROM_FILTER_MASK = 0xffffffffffffffffL;
    /** 3: m, world, origin of the body frame */
    public static final int CAROM_FIELD_POSITION = 0;
    /** 4: x, y, z, w */
    public static final int CAROM_FIELD_ORIENTATION = 1;
    /** 7: position, orientation */
    public static final int CAROM_FIELD_POSE = 2;
    /** 3: m/s, world, of the centre of mass */
    public static final int CAROM_FIELD_LINEAR_VELOCITY = 3;
    /** 3: rad/s, world */
    public static final int CAROM_FIELD_ANGULAR_VELOCITY = 4;
    /** 6: linear, angular */
    public static final int CAROM_FIELD_VELOCITY = 5;
    /** 6: N and N m, world, pending for the next step; writing replaces it */
    public static final int CAROM_FIELD_FORCE = 6;
    /** 3: m, world, centre of mass; read only */
    public static final int CAROM_FIELD_CENTER = 7;
    /** 1: kg; read only */
    public static final int CAROM_FIELD_MASS = 8;
    public static final int CAROM_FIELD_COUNT = 9;
    /** no contact within the motion, proven */
    public static final int CAROM_CAST_MISS = 0;
    /** contact begins within the motion */
    public static final int CAROM_CAST_HIT = 1;
    /** one is in the other already at the start: time 0 */
    public static final int CAROM_CAST_OVERLAP = 2;
    /** the cap came first, or numbers are too large: neither was proven. `lower` holds */
    public static final int CAROM_CAST_UNDECIDED = 3;
    /** of a batch: this ray is not finite, or its max is negative; it was not cast */
    public static final int CAROM_CAST_BAD_RAY = 4;
    /** support functions only, no routine for declared forms */
    public static final int CAROM_ASK_GENERIC = 1;
    /** sensors are found, too; of a world only */
    public static final int CAROM_ASK_SENSORS = 2;
    /** What a ray or a shape touches or overlaps at its start is passed over: that collider. Of a mesh or height field it
     *  is each triangle touched, and for a shape each other one that the motion does not go into. Overlaps and the nearest
     *  do not use it. */
    public static final int CAROM_ASK_IGNORE_TOUCHED = 4;
    /** proven by `normal`: along it the shapes are at least separation_bound apart */
    public static final int CAROM_OVERLAP_APART = 0;
    /** proven by `point`, which is in both */
    public static final int CAROM_OVERLAP_OVERLAPPING = 1;
    /** within rounding (slack) of touching, or the cap came first: neither was proven */
    public static final int CAROM_OVERLAP_TOUCHING = 2;
    /** a support function misbehaved; nothing else is meaningful */
    public static final int CAROM_OVERLAP_FAULT = 3;
    /** in place of an index: no shape */
    public static final int CAROM_NO_SHAPE = 0xffffffff;
    /** nothing is under it: it falls */
    public static final int CAROM_GROUND_AIR = 0;
    /** it touches ground steeper than max_slope: it slides down without friction */
    public static final int CAROM_GROUND_STEEP = 1;
    /** it stands, and can walk and jump */
    public static final int CAROM_GROUND_FIRM = 2;
    /** its orientation turns about `up` with the ground that it rides */
    public static final int CAROM_CHARACTER_TURNS = 1;
    /** no gravity, no steps, no ground: it moves along all of `walk`, as swimmers do */
    public static final int CAROM_CHARACTER_FLIES = 2;
    /** contacts that a move keeps: of more, the first */
    public static final int CAROM_CHARACTER_CONTACTS = 8;
    /** choice: CAROM_INTEGRATOR_* */
    public static final int CAROM_DIAL_INTEGRATOR = 0;
    /** choice: CAROM_ROTATION_*: how bodies with unlike moments of inertia spin */
    public static final int CAROM_DIAL_ROTATION = 1;
    /** integrate-and-solve passes per step */
    public static final int CAROM_DIAL_SUBSTEPS = 2;
    /** choice: CAROM_SOLVER_* */
    public static final int CAROM_DIAL_SOLVER = 3;
    /** severity: at most this many impulses per contact of a group and substep */
    public static final int CAROM_DIAL_VELOCITY_ITERATIONS = 4;
    /** severity: at most this many position corrections per contact of a group and substep; 0: none, under direct, too */
    public static final int CAROM_DIAL_POSITION_ITERATIONS = 5;
    /** m/s: velocity error left unresolved at a contact */
    public static final int CAROM_DIAL_VELOCITY_TOLERANCE = 6;
    /** m: penetration left unresolved; of what is thin at most 2 % of its thickness */
    public static final int CAROM_DIAL_POSITION_TOLERANCE = 7;
    /** m/s: below this approach speed a contact does not bounce */
    public static final int CAROM_DIAL_RESTITUTION_SPEED = 8;
    /** choice: CAROM_SEARCH_* */
    public static final int CAROM_DIAL_SEVERITY_SEARCH = 9;
    /** choice: 0 one group for all contacts, 1 contact groups (islands) */
    public static final int CAROM_DIAL_GROUPS = 10;
    /** choice: CAROM_BROAD_* */
    public static final int CAROM_DIAL_BROAD_PHASE = 11;
    /** m: cell size of the uniform grid; 0: chosen from the scene */
    public static final int CAROM_DIAL_GRID_CELL = 12;
    /** m: pairs nearer than this make contacts */
    public static final int CAROM_DIAL_CONTACT_DISTANCE = 13;
    /** choice: 0 generic path for every pair, 1 specific routines where declared */
    public static final int CAROM_DIAL_PAIR_ROUTINES = 14;
    /** choice: CAROM_NARROW_* for the generic path */
    public static final int CAROM_DIAL_NARROW_PHASE = 15;
    /** choice: CAROM_SIMPLEX_* */
    public static final int CAROM_DIAL_SIMPLEX = 16;
    /** relative width of the bracket at which GJK and EPA stop */
    public static final int CAROM_DIAL_GJK_TOLERANCE = 17;
    /** cap */
    public static final int CAROM_DIAL_GJK_ITERATIONS = 18;
    /** cap */
    public static final int CAROM_DIAL_EPA_ITERATIONS = 19;
    /** m: shell around each shape in CAROM_NARROW_HYBRID */
    public static final int CAROM_DIAL_HYBRID_MARGIN = 20;
    /** choice: 0 start each query afresh, 1 start from the last separating vector */
    public static final int CAROM_DIAL_WARM_SEPARATION = 21;
    /** choice: CAROM_MANIFOLD_* */
    public static final int CAROM_DIAL_MANIFOLD = 22;
    /** m: a cached point is dropped when it drifted further than this */
    public static final int CAROM_DIAL_CACHE_DISTANCE = 23;
    /** choice: 0 solve each step from zero, 1 start from the last step's impulses */
    public static final int CAROM_DIAL_WARM_START = 24;
    /** relative width up to which an earlier bracket, widened by the motion since, stands in for a query of the generic path; 0: off */
    public static final int CAROM_DIAL_CARRY_OVER = 25;
    /** Hz: stiffness of soft contacts; what is thin has stiffer ones, and sinks by 0.1 % of its thickness under its own weight */
    public static final int CAROM_DIAL_CONTACT_FREQUENCY = 26;
    /** damping ratio of soft contacts */
    public static final int CAROM_DIAL_CONTACT_DAMPING = 27;
    /** m/s: overlap of a contact is undone at this speed at most (soft, direct) */
    public static final int CAROM_DIAL_PUSH_SPEED = 28;
    /** choice: 0 everything is simulated, 1 islands that came to rest sleep until something touches them; see carom_body_is_asleep() */
    public static final int CAROM_DIAL_SLEEP = 29;
    /** m/s: no point of a body that falls asleep moves faster */
    public static final int CAROM_DIAL_SLEEP_SPEED = 30;
    /** s: for how long it has been so */
    public static final int CAROM_DIAL_SLEEP_TIME = 31;
    /** CAROM_SOLVER_AUTO solves groups directly that would sink by more of their thickness */
    public static final int CAROM_DIAL_DIRECT_SINK = 32;
    /** or where touching bodies' masses are further apart than this */
    public static final int CAROM_DIAL_DIRECT_RATIO = 33;
    /** unless they take more block products a step than this */
    public static final int CAROM_DIAL_DIRECT_WORK = 34;
    /** rad: arms of contacts turn with a body only when it has turned by this */
    public static final int CAROM_DIAL_HOLD_ANGLE = 35;
    /** Hz: stiffness of joints that the direct solver does not solve */
    public static final int CAROM_DIAL_JOINT_FREQUENCY = 36;
    /** their damping ratio */
    public static final int CAROM_DIAL_JOINT_DAMPING = 37;
    /** choice: CAROM_SWEEP_*: what is swept from pose to pose, so that it passes through nothing; see carom_body_set_continuous() */
    public static final int CAROM_DIAL_CONTINUOUS = 38;
    /** choice: CAROM_PRECISION_*: the numbers in which contacts are solved */
    public static final int CAROM_DIAL_PRECISION = 39;
    /** 2, 4, 6: order of the error of islands that joints alone hold, in 1, 5 or 9 stages a substep, gaps at rounding (odd: the next); above 2 also of bodies that springs, drag and fields alone move; 0: as joints in contact are, under CAROM_INTEGRATOR_RK4 to order 4 */
    public static final int CAROM_DIAL_JOINT_ORDER = 40;
    /** m per second of motion: tolerance of places, see accuracy.h; 0: none */
    public static final int CAROM_DIAL_ACCURACY_PLACE = 41;
    /** rad per second, likewise */
    public static final int CAROM_DIAL_ACCURACY_TURN = 42;
    /** bound of work: substeps of an island in a step */
    public static final int CAROM_DIAL_ACCURACY_SUBSTEPS = 43;
    /** likewise of islands in contact: contact points times substeps */
    public static final int CAROM_DIAL_ACCURACY_WORK = 44;
    /** m: how far two bodies may move before contact points of theirs that lie in flat faces and edges are looked for anew; meanwhile they stay with the bodies, and separations are off by its square over the smaller radius at most; 0: looked for in each step */
    public static final int CAROM_DIAL_KEEP_DISTANCE = 45;
    public static final int CAROM_DIAL_COUNT = 46;
    /** first order */
    public static final int CAROM_INTEGRATOR_EXPLICIT_EULER = 0;
    /** first order, symplectic */
    public static final int CAROM_INTEGRATOR_SEMI_IMPLICIT_EULER = 1;
    /** fourth order, four evaluations of forces */
    public static final int CAROM_INTEGRATOR_RK4 = 2;
    /** exact under constant forces, second order under others */
    public static final int CAROM_INTEGRATOR_VELOCITY_VERLET = 3;
    /** no gyroscopic term: exact for spheres and cubes only */
    public static final int CAROM_ROTATION_NONE = 0;
    /** the term is a torque like any other (RK4 evaluates it four times) */
    public static final int CAROM_ROTATION_EXPLICIT = 1;
    /** one Newton step of the implicit term; under RK4 the same as EXPLICIT */
    public static final int CAROM_ROTATION_IMPLICIT = 2;
    /** Runge-Kutta on the quaternion */
    public static final int CAROM_ROTATION_RK4 = 3;
    /** midpoint rule on the rotation group, order 2 */
    public static final int CAROM_ROTATION_LIE_MIDPOINT = 4;
    /** three exact turns, order 2, symplectic: energy errs by a bounded amount */
    public static final int CAROM_ROTATION_SPLITTING = 5;
    /** five of them (Suzuki) */
    public static final int CAROM_ROTATION_SPLITTING_4 = 6;
    /** seven of them (Yoshida) */
    public static final int CAROM_ROTATION_SPLITTING_6 = 7;
    /** most severe contact first, by group: that of the paper of 2011 */
    public static final int CAROM_SOLVER_SEVERITY = 0;
    /** one sweep a substep over soft contacts, one that relaxes them: needs about 4 substeps */
    public static final int CAROM_SOLVER_SOFT_STEP = 1;
    /** each contact group as one problem, solved to a residual: small hard groups */
    public static final int CAROM_SOLVER_DIRECT = 2;
    /** soft_step, but direct for groups that it would not hold; says which and why */
    public static final int CAROM_SOLVER_AUTO = 3;
    /** the paper's: scan all contacts of the group for the most severe */
    public static final int CAROM_SEARCH_LINEAR = 0;
    /** the same order from a heap */
    public static final int CAROM_SEARCH_HEAP = 1;
    /** every bound with every other */
    public static final int CAROM_BROAD_BRUTE_FORCE = 0;
    /** sorted axes; the paper's */
    public static final int CAROM_BROAD_SWEEP_AND_PRUNE = 1;
    /** cells filled afresh in every step: the same cost however bodies move */
    public static final int CAROM_BROAD_GRID = 2;
    /** a tree of fat boxes: what stays about where it was costs next to nothing */
    public static final int CAROM_BROAD_TREE = 3;
    /** van den Bergen: GJK on shapes with a margin shell, EPA only for deep contact; the shells make every shape larger by the margin */
    public static final int CAROM_NARROW_HYBRID = 0;
    /** GJK on cores, EPA on overlap; exact geometry */
    public static final int CAROM_NARROW_GJK_EPA = 1;
    /** Johnson's sub-algorithm, of determinants */
    public static final int CAROM_SIMPLEX_JOHNSON = 0;
    /** by Voronoi regions, all features */
    public static final int CAROM_SIMPLEX_VORONOI = 1;
    /** only features that touch the newest vertex, all features as a fall-back */
    public static final int CAROM_SIMPLEX_VORONOI_LAST = 2;
    /** the deepest point alone */
    public static final int CAROM_MANIFOLD_SINGLE = 0;
    /** up to 4 points gathered over steps */
    public static final int CAROM_MANIFOLD_CACHE = 1;
    /** up to 4 points of the whole patch at once, probed for by support functions alone */
    public static final int CAROM_MANIFOLD_PATCH = 2;
    /** the same, with declared faces (box, polytope) clipped exactly; others probed for */
    public static final int CAROM_MANIFOLD_CLIP = 3;
    /** bodies that move farther in a step than they are large may pass through things */
    public static final int CAROM_SWEEP_NONE = 0;
    /** bodies of CAROM_CONTINUOUS_ALWAYS */
    public static final int CAROM_SWEEP_FLAGGED = 1;
    /** also what moves far for its size in a step */
    public static final int CAROM_SWEEP_FAST = 2;
    /** floats */
    public static final int CAROM_PRECISION_FLOAT = 0;
    /** floats in steps with 512 pairs in contact or more, where their memory saves time */
    public static final int CAROM_PRECISION_AUTO = 1;
    /** presets accurate and reference have it */
    public static final int CAROM_PRECISION_DOUBLE = 2;
    /** one substep and coarse distances: crowds, debris, what is seen from afar */
    public static final int CAROM_PRESET_FAST = 0;
    /** what a new world has */
    public static final int CAROM_PRESET_BALANCED = 1;
    /** a quarter of its error, at two to four times its cost */
    public static final int CAROM_PRESET_ACCURATE = 2;
    /** to compare others with: as exact as the library is at a given step */
    public static final int CAROM_PRESET_REFERENCE = 3;
    public static final int CAROM_PRESET_COUNT = 4;
    /** any number within its bounds */
    public static final int CAROM_DIAL_KIND_NUMBER = 0;
    /** a whole number within its bounds */
    public static final int CAROM_DIAL_KIND_INTEGER = 1;
    /** one of its named values */
    public static final int CAROM_DIAL_KIND_CHOICE = 2;
    /** outlines of convex shapes: edges of polytopes, three sections' silhouettes of all others */
    public static final int CAROM_DRAW_SHAPES = 1;
    /** sides of a mesh's or height field's triangles */
    public static final int CAROM_DRAW_SCENERY = 2;
    /** boxes about colliders, along the world's axes; none of half-spaces */
    public static final int CAROM_DRAW_BOUNDS = 4;
    /** of the last step: from each point along its normal, `scale` long */
    public static final int CAROM_DRAW_CONTACTS = 8;
    /** frames of both ends (x red, y green, z blue), and what is between them */
    public static final int CAROM_DRAW_JOINTS = 16;
    /** frames of bodies about their centres of mass */
    public static final int CAROM_DRAW_BODIES = 32;
    /** How lines are coloured where their kind does not say: by body type (static grey, kinematic blue, dynamic sand,
     *  asleep dim), or a colour for each island, what hangs together by contacts of the last step and joints. */
    public static final int CAROM_DRAW_BY_TYPE = 0;
    /** one colour an island */
    public static final int CAROM_DRAW_BY_ISLAND = 1;
    /** what happened */
    public static final int CAROM_LOG_INFO = 1;
    /** what may surprise: the call succeeded */
    public static final int CAROM_LOG_WARNING = 2;
    /** not used so far: a call that fails says so by its result */
    public static final int CAROM_LOG_ERROR = 3;
    /** of carom_world_get_contact_events() */
    public static final int CAROM_EVENTS_CONTACT = 1;
    /** of carom_world_get_sensor_events() */
    public static final int CAROM_EVENTS_SENSOR = 2;
    /** of carom_world_get_sleep_events() */
    public static final int CAROM_EVENTS_SLEEP = 4;
    /** of carom_world_get_joint_events() */
    public static final int CAROM_EVENTS_JOINT = 8;
    /** of carom_world_get_fault_events() */
    public static final int CAROM_EVENTS_FAULT = 16;
    /** the first step in which the two press on each other */
    public static final int CAROM_CONTACT_BEGIN = 0;
    /** the first after that in which they are farther apart than the contact distance, or one of them is gone, filtered out, disabled or in quarantine; point, normal, impulse, speed: 0 */
    public static final int CAROM_CONTACT_END = 1;
    /** they press, and approached faster than hit_speed as the step began, or when a sweep met them */
    public static final int CAROM_CONTACT_HIT = 2;
    /** the collider begins to overlap the sensor */
    public static final int CAROM_SENSOR_ENTER = 0;
    /** it overlaps the sensor no longer */
    public static final int CAROM_SENSOR_LEAVE = 1;
    /** the body fell asleep */
    public static final int CAROM_SLEEP_ASLEEP = 0;
    /** the body woke */
    public static final int CAROM_SLEEP_AWAKE = 1;
    /** `vector` within a box about the frame's origin */
    public static final int CAROM_FORCE_FIELD_UNIFORM = 0;
    /** strength (reference / s)^falloff away from the origin; below 0 it attracts */
    public static final int CAROM_FORCE_FIELD_RADIAL = 1;
    /** the same about the frame's y axis (right-handed), `pull` towards it, `lift` along it */
    public static final int CAROM_FORCE_FIELD_VORTEX = 2;
    /** `vector` in teslas within a box, as UNIFORM: pushes nothing, and turns bodies that have a magnetic moment by T = moment x vector. Second order in the step with velocity_verlet, fourth with rk4; oracle: tests/oracle/test_magnetism */
    public static final int CAROM_FORCE_FIELD_MAGNETIC = 3;
    public static final int CAROM_FORCE_FIELD_COUNT = 4;
    /** the points stay together; twist and swing are free */
    public static final int CAROM_JOINT_BALL = 0;
    /** so do the x axes; twist is free */
    public static final int CAROM_JOINT_HINGE = 1;
    /** the frames stay parallel and B's point on A's x axis; slide is free */
    public static final int CAROM_JOINT_SLIDER = 2;
    /** nothing is free */
    public static final int CAROM_JOINT_WELD = 3;
    /** the points stay `length` apart: a rod. With a limit a rope, with a spring a spring */
    public static final int CAROM_JOINT_DISTANCE = 4;
    /** the points stay together, B's z axis at right angles to A's y axis: a cross of two pins */
    public static final int CAROM_JOINT_UNIVERSAL = 5;
    /** a rope from A's point over two anchors to B's, as carom_joint_set_transmission() says; until then it holds nothing. Without a limit the rope neither stretches nor gives way; with one it may be slack */
    public static final int CAROM_JOINT_PULLEY = 6;
    /** A's angle about the x axis of its frame, plus `ratio` times B's about its own, stays what it is; each relative to the world, where bearings of their own hold the wheels. Ratio 1 until carom_joint_set_transmission() says another: they turn against each other */
    public static final int CAROM_JOINT_GEAR = 7;
    /** each axis free, locked, limited, driven and sprung as carom_joint_set_axis() says; until then all are free */
    public static final int CAROM_JOINT_SIX_AXIS = 8;
    /** the coordinate of one joint follows a polynomial of another's, as carom_joint_couple() says, which makes such joints */
    public static final int CAROM_JOINT_COUPLING = 9;
    public static final int CAROM_JOINT_COUNT = 10;
    /** rad, of B about the x axes, whole turns counted: ball, hinge */
    public static final int CAROM_COORDINATE_TWIST = 0;
    /** rad, [0, pi], between the x axes: ball, universal */
    public static final int CAROM_COORDINATE_SWING = 1;
    /** m, of B's point along A's x axis: slider */
    public static final int CAROM_COORDINATE_SLIDE = 2;
    /** m, between the points: distance; of the rope, |a - anchor_a| + ratio |b - anchor_b|: pulley */
    public static final int CAROM_COORDINATE_DISTANCE = 3;
    public static final int CAROM_COORDINATE_COUNT = 4;
    /** m, B's point along A's x axis */
    public static final int CAROM_AXIS_X = 0;
    /** m */
    public static final int CAROM_AXIS_Y = 1;
    /** m */
    public static final int CAROM_AXIS_Z = 2;
    /** rad, whole turns counted */
    public static final int CAROM_AXIS_TURN_X = 3;
    /** rad, likewise */
    public static final int CAROM_AXIS_TURN_Y = 4;
    /** rad, likewise */
    public static final int CAROM_AXIS_TURN_Z = 5;
    public static final int CAROM_AXIS_COUNT = 6;
    /** no bounds */
    public static final int CAROM_AXIS_MODE_FREE = 0;
    /** at `lower` */
    public static final int CAROM_AXIS_MODE_LOCKED = 1;
    /** from `lower` to `upper`; where both are the same and the stops hard, it is locked */
    public static final int CAROM_AXIS_MODE_LIMITED = 2;
    public static final int CAROM_AXIS_MODE_COUNT = 3;
    /** at nothing: no force */
    public static final int CAROM_DRIVE_NONE = 0;
    /** force = stiffness (target - x) + damping (speed - x'), `max_force` at most */
    public static final int CAROM_DRIVE_POSITION = 1;
    /** the speed, by whatever force up to `max_force` */
    public static final int CAROM_DRIVE_VELOCITY = 2;
    /** a force or torque, `max_force` at most, whatever the motion */
    public static final int CAROM_DRIVE_EFFORT = 3;
    public static final int CAROM_DRIVE_COUNT = 4;
    /** Hz and a ratio: force = -m (w^2 x + 2 damping w x'), w = 2 pi stiffness */
    public static final int CAROM_GAINS_FREQUENCY = 0;
    /** N/m and N s/m, or N m/rad and N m s/rad: force = -(stiffness x + damping x') */
    public static final int CAROM_GAINS_FORCE = 1;
    /** 1/s^2 and 1/s: force = -m (stiffness x + damping x') */
    public static final int CAROM_GAINS_ACCELERATION = 2;
    public static final int CAROM_GAINS_COUNT = 3;
    /** position_a and orientation_a are in world coordinates and hold for both bodies as they stand now; those of B are not read */
    public static final int CAROM_JOINT_WORLD_FRAME = 1;
    /** the two bodies may touch each other; else they do not */
    public static final int CAROM_JOINT_COLLIDE = 2;
    /** length is given; else it is the distance of the points as they stand now */
    public static final int CAROM_JOINT_FIELD_LENGTH = 4;
    /** each step measures the joint's accelerations, see: CAROM_JOINT_BULK_ACCELERATION */
    public static final int CAROM_JOINT_ACCELERATIONS = 8;
    /** 4: m or rad, by CAROM_COORDINATE_*, as the bodies stand now; read only */
    public static final int CAROM_JOINT_BULK_COORDINATES = 0;
    /** 4: m/s or rad/s, their rates, from the present velocities; read only */
    public static final int CAROM_JOINT_BULK_SPEEDS = 1;
    /** 6: m and rad, by CAROM_AXIS_*; written: hinge, slider, ball, universal, six-axis */
    public static final int CAROM_JOINT_BULK_AXES = 2;
    /** 6: m/s and rad/s, their rates; written likewise */
    public static final int CAROM_JOINT_BULK_AXIS_SPEEDS = 3;
    /** 3: N, world, as carom_joint_state.force; read only */
    public static final int CAROM_JOINT_BULK_FORCE = 4;
    /** 3: N m, world, as carom_joint_state.torque; read only */
    public static final int CAROM_JOINT_BULK_TORQUE = 5;
    /** 2: m and rad, gap and angle; read only */
    public static final int CAROM_JOINT_BULK_ERROR = 6;
    /** 1: 1 or 0; read only */
    public static final int CAROM_JOINT_BULK_BROKEN = 7;
    /** 1: m or rad, of one motion, whole turns counted; written: hinge, slider */
    public static final int CAROM_JOINT_BULK_POSITION = 8;
    /** 1: m/s or rad/s, of one motion; written likewise */
    public static final int CAROM_JOINT_BULK_VELOCITY = 9;
    /** 1: N or N m, borne along one motion, mean over the last step; read only */
    public static final int CAROM_JOINT_BULK_EFFORT = 10;
    /** 1: m or rad, of one motion: its spring's */
    public static final int CAROM_JOINT_BULK_TARGET = 11;
    /** 1: m/s or rad/s, of one motion: its motor's speed */
    public static final int CAROM_JOINT_BULK_TARGET_VELOCITY = 12;
    /** 1: N or N m, [-1e30, 1e30], of one motion: its motor's force */
    public static final int CAROM_JOINT_BULK_TARGET_EFFORT = 13;
    /** 3: enabled, speed, max_force, as carom_joint_motor; of one motion */
    public static final int CAROM_JOINT_BULK_MOTOR = 14;
    /** 5: enabled, target, frequency, damping, max_force; of one motion */
    public static final int CAROM_JOINT_BULK_SPRING = 15;
    /** 3: enabled, lower, upper; of one motion */
    public static final int CAROM_JOINT_BULK_LIMIT = 16;
    /** 6: N and N m, FORCE and TORQUE in A's frame; of any kind, read only */
    public static final int CAROM_JOINT_BULK_AXIS_EFFORTS = 17;
    /** 6: target of each axis of a six-axis joint, as carom_joint_axis */
    public static final int CAROM_JOINT_BULK_AXIS_TARGETS = 18;
    /** 6: speed, likewise */
    public static final int CAROM_JOINT_BULK_AXIS_TARGET_VELOCITIES = 19;
    /** 6: effort, likewise */
    public static final int CAROM_JOINT_BULK_AXIS_TARGET_EFFORTS = 20;
    /** 6: max_force, likewise */
    public static final int CAROM_JOINT_BULK_AXIS_MAX_FORCES = 21;
    /** 12: drive_stiffness and drive_damping of each axis, in its units */
    public static final int CAROM_JOINT_BULK_AXIS_GAINS = 22;
    /** 12: lower and upper of each axis */
    public static final int CAROM_JOINT_BULK_AXIS_LIMITS = 23;
    /** 4: x, y, z, w, of the drive to an orientation: ball, six-axis */
    public static final int CAROM_JOINT_BULK_ORIENTATION_TARGET = 24;
    /** 3: rad/s, A's frame, likewise */
    public static final int CAROM_JOINT_BULK_ORIENTATION_VELOCITY = 25;
    /** 3: N m, A's frame, likewise */
    public static final int CAROM_JOINT_BULK_ORIENTATION_EFFORT = 26;
    /** 2: stiffness, damping, likewise */
    public static final int CAROM_JOINT_BULK_ORIENTATION_GAINS = 27;
    /** 1: m/s^2 or rad/s^2, of a hinge or slider; read only */
    public static final int CAROM_JOINT_BULK_ACCELERATION = 28;
    /** 6: by CAROM_AXIS_*, of any kind; read only. Both of joints with CAROM_JOINT_ACCELERATIONS */
    public static final int CAROM_JOINT_BULK_AXIS_ACCELERATIONS = 29;
    /** 6: friction of each axis of a six-axis joint, as carom_joint_axis */
    public static final int CAROM_JOINT_BULK_AXIS_FRICTIONS = 30;
    /** 6: armature, likewise */
    public static final int CAROM_JOINT_BULK_AXIS_ARMATURES = 31;
    /** 6: effort_limit, likewise */
    public static final int CAROM_JOINT_BULK_AXIS_EFFORT_LIMITS = 32;
    /** 6: speed_limit, likewise */
    public static final int CAROM_JOINT_BULK_AXIS_SPEED_LIMITS = 33;
    /** 1: friction of the axis of a hinge or slider, as carom_joint_axis */
    public static final int CAROM_JOINT_BULK_FRICTION = 34;
    /** 1: armature, likewise */
    public static final int CAROM_JOINT_BULK_ARMATURE = 35;
    /** 1: effort_limit, likewise */
    public static final int CAROM_JOINT_BULK_EFFORT_LIMIT = 36;
    /** 1: speed_limit, likewise */
    public static final int CAROM_JOINT_BULK_SPEED_LIMIT = 37;
    /** 1: target of the drive of a hinge's or slider's axis, likewise: a servo's */
    public static final int CAROM_JOINT_BULK_DRIVE_TARGET = 38;
    /** 1: speed, likewise */
    public static final int CAROM_JOINT_BULK_DRIVE_VELOCITY = 39;
    /** 1: effort, likewise */
    public static final int CAROM_JOINT_BULK_DRIVE_EFFORT = 40;
    /** 1: max_force, likewise */
    public static final int CAROM_JOINT_BULK_DRIVE_MAX_FORCE = 41;
    /** 2: drive_stiffness and drive_damping, in its units, likewise */
    public static final int CAROM_JOINT_BULK_DRIVE_GAINS = 42;
    public static final int CAROM_JOINT_BULK_COUNT = 43;
    /** gyroscopic term of bodies with unlike moments of inertia */
    public static final int CAROM_EFFECT_GYROSCOPIC = 0;
    /** damping of velocity */
    public static final int CAROM_EFFECT_LINEAR_DAMPING = 1;
    /** damping of rotation */
    public static final int CAROM_EFFECT_ANGULAR_DAMPING = 2;
    /** the world's gravity */
    public static final int CAROM_EFFECT_GRAVITY = 3;
    /** forces of the host, at the centre of mass or elsewhere */
    public static final int CAROM_EFFECT_USER_FORCE = 4;
    /** torques of the host */
    public static final int CAROM_EFFECT_USER_TORQUE = 5;
    /** the search for contacts */
    public static final int CAROM_EFFECT_COLLISION = 6;
    /** friction at contacts */
    public static final int CAROM_EFFECT_FRICTION = 7;
    /** bounces */
    public static final int CAROM_EFFECT_RESTITUTION = 8;
    /** resistance of contacts to rolling */
    public static final int CAROM_EFFECT_ROLLING_RESISTANCE = 9;
    /** resistance of contacts to spinning about the normal */
    public static final int CAROM_EFFECT_SPINNING_RESISTANCE = 10;
    /** islands at rest are not stepped */
    public static final int CAROM_EFFECT_SLEEP = 11;
    /** sets of particles */
    public static final int CAROM_EFFECT_PARTICLES = 12;
    /** categories, masks and groups of colliders */
    public static final int CAROM_EFFECT_FILTER = 13;
    /** colliders that only report what overlaps them */
    public static final int CAROM_EFFECT_SENSOR = 14;
    /** joints: what they lock */
    public static final int CAROM_EFFECT_JOINTS = 15;
    /** meshes and height fields */
    public static final int CAROM_EFFECT_SCENERY = 16;
    /** fast bodies are swept */
    public static final int CAROM_EFFECT_CONTINUOUS = 17;
    /** surfaces that move: conveyors */
    public static final int CAROM_EFFECT_SURFACE_VELOCITY = 18;
    /** locked axes of bodies */
    public static final int CAROM_EFFECT_AXIS_LOCKS = 19;
    /** drag of bodies */
    public static final int CAROM_EFFECT_DRAG = 20;
    /** wind on bodies with drag */
    public static final int CAROM_EFFECT_WIND = 21;
    /** force fields */
    public static final int CAROM_EFFECT_FIELDS = 22;
    /** springs between bodies */
    public static final int CAROM_EFFECT_SPRINGS = 23;
    /** water */
    public static final int CAROM_EFFECT_BUOYANCY = 24;
    /** what contacts do: without it bodies pass through each other, and there are no contact points */
    public static final int CAROM_EFFECT_RESPONSE = 25;
    /** limits of joints */
    public static final int CAROM_EFFECT_JOINT_LIMITS = 26;
    /** motors and springs of joints */
    public static final int CAROM_EFFECT_JOINT_MOTORS = 27;
    /** events that a host collects */
    public static final int CAROM_EFFECT_EVENTS = 28;
    /** accounts of energy and momentum */
    public static final int CAROM_EFFECT_LEDGER = 29;
    /** magnetic moments in magnetic fields */
    public static final int CAROM_EFFECT_MAGNETISM = 30;
    public static final int CAROM_EFFECT_COUNT = 31;
    /** it runs for the bodies that need it (default) */
    public static final int CAROM_MODE_AS_NEEDED = 0;
    /** it does not run */
    public static final int CAROM_MODE_FORBID = 1;
    /** it runs for all bodies that it can act on, whether they need it or not: to see what it costs, and that it changes nothing. It makes no joints, sets, ... where there are none */
    public static final int CAROM_MODE_FORCE = 2;
    /** the line is a stage */
    public static final int CAROM_PLAN_NO_EFFECT = 0xffffffff;
    /** seconds is its own */
    public static final int CAROM_TIME_OWN = 0;
    /** it is done within the loops of its stage, and in the time of that */
    public static final int CAROM_TIME_IN_STAGE = 1;
    /** not measured, see carom_world_time_effects() */
    public static final int CAROM_TIME_OFF = 2;
    /** a plugin with another one is refused */
    public static final int CAROM_PLUGIN_ABI_MAJOR = 1;
    /** grows with additions */
    public static final int CAROM_PLUGIN_ABI_MINOR = 0;
    /** nothing declared */
    public static final int CAROM_FORM_NONE = 0;
    /** centre at the origin; arg[0]: radius */
    public static final int CAROM_FORM_SPHERE = 1;
    /** axis y; arg[0]: radius, arg[1]: half height of the core segment */
    public static final int CAROM_FORM_CAPSULE = 2;
    /** centred, axis-aligned; arg[0..2]: half extents x, y, z */
    public static final int CAROM_FORM_BOX = 3;
    /** hull of points; arg[0]: index of the first coordinate; the rest of params are x,y,z triples */
    public static final int CAROM_FORM_POLYTOPE = 4;
    /** axis y, centred; arg[0]: radius, arg[1]: half height */
    public static final int CAROM_FORM_CYLINDER = 5;
    /** axis y, apex at +half height, base disc at -half height; arg[0]: base radius, arg[1]: half height */
    public static final int CAROM_FORM_CONE = 6;
    /** centred, axis-aligned; arg[0..2]: radii x, y, z */
    public static final int CAROM_FORM_ELLIPSOID = 7;
    /** In place of an index into params: no parameter. A geometry must write it for core_radius_param where there is no
     *  core radius, since 0 there is the first parameter. In form_arg and mass_arg it marks places that the form does not
     *  use; those are not read, so 0 does as well. Where the form needs an index, it is refused (PLUGIN_ABI). */
    public static final int CAROM_NO_PARAM = 0xffffffff;
    /** flags: support may only be called on the thread that steps (scripting hosts) */
    public static final int CAROM_PLUGIN_HOST_THREAD = 1;
    /** The symbol looked up in a shared object. */
    public static final String CAROM_SHAPE_PLUGIN_SYMBOL = "carom_shape_plugin_v1";
    /** the bracket is as narrow as the tolerance wants */
    public static final int CAROM_QUERY_EXACT_ENOUGH = 0;
    /** the iteration cap came first; the bracket still holds */
    public static final int CAROM_QUERY_CAPPED = 1;
    /** rounding stopped it; the bracket still holds */
    public static final int CAROM_QUERY_ROUNDING = 2;
    /** a support function misbehaved; nothing else is meaningful */
    public static final int CAROM_QUERY_FAULT = 3;
    /** the hash after each step */
    public static final int CAROM_RECORD_HASHES = 0;
    /** and the state (CAROM_SNAPSHOT_STATE), so that a replay can name a body or a pair */
    public static final int CAROM_RECORD_STATES = 1;
    /** a bit of flags: met from both sides */
    public static final int CAROM_SCENERY_TWO_SIDED = 1;
    /** all but the structure */
    public static final int CAROM_SNAPSHOT_STATE = 0;
    /** the structure, too */
    public static final int CAROM_SNAPSHOT_WHOLE = 1;
    /** it chooses among forward gears; the input's gear says which way, or neutral */
    public static final int CAROM_VEHICLE_AUTOMATIC = 1;
    /** steered wheels share one centre of turn with those that are not steered */
    public static final int CAROM_VEHICLE_ACKERMANN = 2;
    /** the most wheels of a vehicle */
    public static final int CAROM_VEHICLE_WHEELS = 16;
    /** in place of an index: no wheel */
    public static final int CAROM_NO_WHEEL = 0xffffffff;
    /** which effects have participants; bounds */
    public static final int CAROM_STAGE_REFRESH = 0;
    /** pairs of bounds that overlap */
    public static final int CAROM_STAGE_BROAD = 1;
    /** contacts of pairs */
    public static final int CAROM_STAGE_NARROW = 2;
    /** contact groups */
    public static final int CAROM_STAGE_GROUP = 3;
    /** forces, velocities, positions */
    public static final int CAROM_STAGE_INTEGRATE = 4;
    /** velocities at contacts */
    public static final int CAROM_STAGE_SOLVE = 5;
    /** penetration at contacts */
    public static final int CAROM_STAGE_RELAX = 6;
    /** residuals, events */
    public static final int CAROM_STAGE_OBSERVE = 7;
    public static final int CAROM_STAGE_COUNT = 8;
    /** soft contacts hold it */
    public static final int CAROM_REASON_ORDINARY = 0;
    /** bodies that touch have masses further apart than CAROM_DIAL_DIRECT_RATIO */
    public static final int CAROM_REASON_MASS_RATIO = 1;
    /** soft contacts would let it sink by more than CAROM_DIAL_DIRECT_SINK, or did before it lay still */
    public static final int CAROM_REASON_SINK = 2;
    /** too many bodies for the direct solver, or it exceeded its work limit recently */
    public static final int CAROM_REASON_TOO_MUCH = 3;
    /** it would sink, but is under impact: soft contacts take that */
    public static final int CAROM_REASON_IMPACT = 4;
    /** so few bodies that they are solved directly, whatever they do */
    public static final int CAROM_REASON_FEW = 5;
    /** the support function returned nonzero */
    public static final int CAROM_FAULT_RETURNED = 1;
    /** it gave NaN or infinity */
    public static final int CAROM_FAULT_NOT_FINITE = 2;
    /** a point outside the shape's bounding radius */
    public static final int CAROM_FAULT_OUTSIDE = 3;
    /** a point worse than one it had given before */
    public static final int CAROM_FAULT_NOT_SUPPORT = 4;
    /** a body's state was not finite; the body is quarantined */
    public static final int CAROM_FAULT_BODY_STATE = 5;
    /** likewise particles', see carom_particles_get_quarantined() */
    public static final int CAROM_FAULT_PARTICLE_STATE = 6;
    /** what is met first */
    public static final int CAROM_WANT_FIRST = 0;
    /** whether anything is met: HIT, UNDECIDED (only grazes) or MISS; no collider, times or points */
    public static final int CAROM_WANT_ANY = 1;
    /** Do the parts [begin, end) of a loop. Does not call back, throw or block.
     *  param: context as run got it   param: begin, end range of parts */
    public static final FunctionDescriptor carom_job_fn = FunctionDescriptor.ofVoid(ADDRESS, JAVA_INT, JAVA_INT);
    /** Support function of a bounded convex set: the point of the set farthest along dir, in the shape's own frame.
     *  Contract: pure (same bits in, same bits out), callable from several threads at once; dir is finite and nonzero, of a
     *  length of 5e-324 to 1e308: divide it by its largest component before multiplying or squaring it; ties may be broken
     *  either way, but repeatably; no allocation, lock, I/O, change of the floating-point environment, or carom_* call.
     *  param: user       as the plugin has it: state of a host's function; NULL for a file's
     *  param: params     [param_len] the shape's parameters; owned by the engine, immutable
     *  param: param_len  number of parameters
     *  param: dir        [3] direction, shape frame, any positive length
     *  param: out        [3] m, shape frame: argmax over x in the set of dir . x
     *  return: 0; anything else reports a fault: the pair is skipped and the shape put in quarantine */
    public static final FunctionDescriptor carom_support_fn = FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS);
    /** Take bytes of a recording, in order. Called on the thread that makes the call which is recorded, before that
     *  returns; no call of this library is allowed in it.
     *  param: user as given to carom_world_record_begin()   param: bytes [size]   param: size number of bytes
     *  return: 0; else recording stops, and carom_world_record_end() says so */
    public static final FunctionDescriptor carom_write_fn = FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, JAVA_LONG);

    private static int count(int given, int wanted) {
        if (given != wanted) throw new IllegalArgumentException(wanted + " numbers are wanted, " + given + " given");
        return given;
    }

    /** Details of the last failure of one call. Owned by the caller; start from CAROM_ERROR_INIT.
     *  Written only on failure, never past struct_size. */
    public static final class Error {
        public static final int SIZE = 576;
        public final MemorySegment segment;
        public Error(Arena arena) { segment = arena.allocate(SIZE, 8); segment.set(JAVA_INT, 0, SIZE); }
        public Error(MemorySegment at) { segment = at; }
        /** CAROM_E_*, same as the returned result */
        public int code() { return segment.get(JAVA_INT, 4); }
        public Error code(int it) { segment.set(JAVA_INT, 4, it); return this; }
        /** 1-based index of the argument at fault; 0: none in particular */
        public int argument() { return segment.get(JAVA_INT, 8); }
        public Error argument(int it) { segment.set(JAVA_INT, 8, it); return this; }
        /** 1: witness_dir and witness_out hold the evidence */
        public int hasWitness() { return segment.get(JAVA_INT, 12); }
        public Error hasWitness(int it) { segment.set(JAVA_INT, 12, it); return this; }
        /** direction given to the support function */
        public double[] witnessDir() { return segment.asSlice(16, 24).toArray(JAVA_DOUBLE); }
        public Error witnessDir(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 16, count(it.length, 3)); return this; }
        /** what came back */
        public double[] witnessOut() { return segment.asSlice(40, 24).toArray(JAVA_DOUBLE); }
        public Error witnessOut(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 40, count(it.length, 3)); return this; }
        /** what is wrong, zero-terminated */
        public String message() { return segment.getString(64); }
        /** what to do next, zero-terminated */
        public String remedy() { return segment.getString(320); }
    }

    /** An error tolerance. The three numbers are the dials CAROM_DIAL_ACCURACY_PLACE, _TURN and _SUBSTEPS, so that
     *  snapshots, recordings and scene files have them. The dial CAROM_DIAL_ACCURACY_WORK bounds the work of large islands
     *  in contact further. Fill with carom_accuracy_init(). */
    public static final class Accuracy {
        public static final int SIZE = 24;
        public final MemorySegment segment;
        public Accuracy(Arena arena) { segment = arena.allocate(SIZE, 8); carom_accuracy_init(segment, SIZE); }
        public Accuracy(MemorySegment at) { segment = at; }
        /** bound of work: that an island may take in a step, 2 to 4096, default 256 */
        public int substeps() { return segment.get(JAVA_INT, 4); }
        public Accuracy substeps(int it) { segment.set(JAVA_INT, 4, it); return this; }
        /** m per second of motion, 0 to 1e6, default 1e-3; 0: no tolerance of places */
        public double place() { return segment.get(JAVA_DOUBLE, 8); }
        public Accuracy place(double it) { segment.set(JAVA_DOUBLE, 8, it); return this; }
        /** rad per second of motion, 0 to 1e6, default 1e-3; 0: no tolerance of turns */
        public double turn() { return segment.get(JAVA_DOUBLE, 16); }
        public Accuracy turn(double it) { segment.set(JAVA_DOUBLE, 16, it); return this; }
    }

    /** An island of the last step. Errors are those of its step per second of motion, by the last estimate. */
    public static final class Island {
        public static final int SIZE = 56;
        public final MemorySegment segment;
        public Island(Arena arena) { segment = arena.allocate(SIZE, 8); }
        public Island(MemorySegment at) { segment = at; }
        /** that of its bodies which has the lowest slot; CAROM_NULL_HANDLE if that was destroyed since */
        public long body() { return segment.get(JAVA_LONG, 0); }
        public Island body(long it) { segment.set(JAVA_LONG, 0, it); return this; }
        /** that move */
        public int bodies() { return segment.get(JAVA_INT, 8); }
        public Island bodies(int it) { segment.set(JAVA_INT, 8, it); return this; }
        /** that it took */
        public int substeps() { return segment.get(JAVA_INT, 12); }
        public Island substeps(int it) { segment.set(JAVA_INT, 12, it); return this; }
        /** of the error, as the estimate takes it */
        public int order() { return segment.get(JAVA_INT, 16); }
        public Island order(int it) { segment.set(JAVA_INT, 16, it); return this; }
        /** CAROM_ISLAND_* */
        public int flags() { return segment.get(JAVA_INT, 20); }
        public Island flags(int it) { segment.set(JAVA_INT, 20, it); return this; }
        /** substeps of all runs of the step: those that were compared and those repeated are among them */
        public long work() { return segment.get(JAVA_LONG, 24); }
        public Island work(long it) { segment.set(JAVA_LONG, 24, it); return this; }
        /** m/s; 0 without a tolerance of places */
        public double place() { return segment.get(JAVA_DOUBLE, 32); }
        public Island place(double it) { segment.set(JAVA_DOUBLE, 32, it); return this; }
        /** rad/s; 0 without a tolerance of turns */
        public double turn() { return segment.get(JAVA_DOUBLE, 40); }
        public Island turn(double it) { segment.set(JAVA_DOUBLE, 40, it); return this; }
        /** the larger of the two over its tolerance: above 1 where the bound of work was reached, or where more substeps do not help */
        public double share() { return segment.get(JAVA_DOUBLE, 48); }
        public Island share(double it) { segment.set(JAVA_DOUBLE, 48, it); return this; }
    }

    /** How errors grow by themselves, whatever work a step is given: two motions that begin 1e-9 m/s and rad/s apart. Their
     *  distance is the largest over all bodies of that of places (m), of turns (rad), and of velocities and spins times 1
     *  s. */
    public static final class Growth {
        public static final int SIZE = 40;
        public final MemorySegment segment;
        public Growth(Arena arena) { segment = arena.allocate(SIZE, 8); segment.set(JAVA_INT, 0, SIZE); }
        public Growth(MemorySegment at) { segment = at; }
        /** that were taken: fewer than requested where the distance had grown 1e6-fold before */
        public int steps() { return segment.get(JAVA_INT, 4); }
        public Growth steps(int it) { segment.set(JAVA_INT, 4, it); return this; }
        /** where the two are farthest apart at the end; CAROM_NULL_HANDLE if nothing moves */
        public long body() { return segment.get(JAVA_LONG, 8); }
        public Growth body(long it) { segment.set(JAVA_LONG, 8, it); return this; }
        /** 1: errors grow e-fold, as in chaos. What is held to an accuracy there is the error that each step adds; the place after many e-foldings is no more than a guess */
        public int sensitive() { return segment.get(JAVA_INT, 16); }
        public Growth sensitive(int it) { segment.set(JAVA_INT, 16, it); return this; }
        /** of their distance, from the beginning to the end */
        public double factor() { return segment.get(JAVA_DOUBLE, 24); }
        public Growth factor(double it) { segment.set(JAVA_DOUBLE, 24, it); return this; }
        /** 1/s: ln(factor) over the time; below 0 where errors die out */
        public double rate() { return segment.get(JAVA_DOUBLE, 32); }
        public Growth rate(double it) { segment.set(JAVA_DOUBLE, 32, it); return this; }
    }

    /** What stands in an array of the host's, and when. Fill with carom_batch_column_init(). A row has n records one after
     *  the other, each of as many numbers as the source says; rows are those of the worlds of one structure, in order. */
    public static final class BatchColumn {
        public static final int SIZE = 72;
        public final MemorySegment segment;
        public BatchColumn(Arena arena) { segment = arena.allocate(SIZE, 8); carom_batch_column_init(segment, SIZE); }
        public BatchColumn(MemorySegment at) { segment = at; }
        /** CAROM_COLUMN_BODIES or what follows it */
        public int source() { return segment.get(JAVA_INT, 4); }
        public BatchColumn source(int it) { segment.set(JAVA_INT, 4, it); return this; }
        /** of BODIES CAROM_FIELD_*, of JOINTS CAROM_JOINT_BULK_*, else 0 */
        public int field() { return segment.get(JAVA_INT, 8); }
        public BatchColumn field(int it) { segment.set(JAVA_INT, 8, it); return this; }
        /** CAROM_WHEN_ON_CALL, BEFORE_STEP, AFTER_STEP; default ON_CALL */
        public int when() { return segment.get(JAVA_INT, 12); }
        public BatchColumn when(int it) { segment.set(JAVA_INT, 12, it); return this; }
        /** CAROM_SCALAR_*, default F64 */
        public int scalar() { return segment.get(JAVA_INT, 16); }
        public BatchColumn scalar(int it) { segment.set(JAVA_INT, 16, it); return this; }
        /** one of the structure: the first that carom_batch_add_worlds() gave, or any other */
        public long world() { return segment.get(JAVA_LONG, 24); }
        public BatchColumn world(long it) { segment.set(JAVA_LONG, 24, it); return this; }
        /** how many things, 1 or more; 1 of GRAVITY and TIME */
        public long n() { return segment.get(JAVA_LONG, 32); }
        public BatchColumn n(long it) { segment.set(JAVA_LONG, 32, it); return this; }
        /** [n] of the things; of RAYS bodies that the rays go with, or 0; NULL of GRAVITY and TIME */
        public MemorySegment handles() { return segment.get(ADDRESS, 40); }
        public BatchColumn handles(MemorySegment it) { segment.set(ADDRESS, 40, it); return this; }
        /** [7 n] of RAYS: origin, m, direction, m, and max, in [0, 1e9], in the body's frame or the world's; the body itself is passed over. NULL of others */
        public MemorySegment rays() { return segment.get(ADDRESS, 48); }
        public BatchColumn rays(MemorySegment it) { segment.set(ADDRESS, 48, it); return this; }
        /** the first row; belongs to the host, and stays until the batch is destroyed */
        public MemorySegment data() { return segment.get(ADDRESS, 56); }
        public BatchColumn data(MemorySegment it) { segment.set(ADDRESS, 56, it); return this; }
        /** bytes from one row to the next; 0: tightly packed */
        public long stride() { return segment.get(JAVA_LONG, 64); }
        public BatchColumn stride(long it) { segment.set(JAVA_LONG, 64, it); return this; }
    }

    /** What a batch has, and what it costs. */
    public static final class BatchInfo {
        public static final int SIZE = 48;
        public final MemorySegment segment;
        public BatchInfo(Arena arena) { segment = arena.allocate(SIZE, 8); segment.set(JAVA_INT, 0, SIZE); }
        public BatchInfo(MemorySegment at) { segment = at; }
        /** kinds of worlds */
        public int structures() { return segment.get(JAVA_INT, 4); }
        public BatchInfo structures(int it) { segment.set(JAVA_INT, 4, it); return this; }
        /** in all */
        public long worlds() { return segment.get(JAVA_LONG, 8); }
        public BatchInfo worlds(long it) { segment.set(JAVA_LONG, 8, it); return this; }
        /** of them */
        public long stopped() { return segment.get(JAVA_LONG, 16); }
        public BatchInfo stopped(long it) { segment.set(JAVA_LONG, 16, it); return this; }
        /** that were added */
        public long columns() { return segment.get(JAVA_LONG, 24); }
        public BatchInfo columns(long it) { segment.set(JAVA_LONG, 24, it); return this; }
        /** as many as threads were at work at once, at most, times structures */
        public long realWorlds() { return segment.get(JAVA_LONG, 32); }
        public BatchInfo realWorlds(long it) { segment.set(JAVA_LONG, 32, it); return this; }
        /** of all states: divided by worlds, what one more world takes */
        public long stateBytes() { return segment.get(JAVA_LONG, 40); }
        public BatchInfo stateBytes(long it) { segment.set(JAVA_LONG, 40, it); return this; }
    }

    /** Surface of a collider. Where two materials mix differently, the larger CAROM_MIX_* value decides; of two in particular
     *  carom_material_set_pair() says what they are to each other. */
    public static final class MaterialDesc {
        public static final int SIZE = 32;
        public final MemorySegment segment;
        public MaterialDesc(Arena arena) { segment = arena.allocate(SIZE, 8); carom_material_desc_init(segment, SIZE); }
        public MaterialDesc(MemorySegment at) { segment = at; }
        /** CAROM_MIX_*, default GEOMETRIC_MEAN */
        public int frictionMix() { return segment.get(JAVA_INT, 4); }
        public MaterialDesc frictionMix(int it) { segment.set(JAVA_INT, 4, it); return this; }
        /** CAROM_MIX_*, default MAXIMUM */
        public int restitutionMix() { return segment.get(JAVA_INT, 8); }
        public MaterialDesc restitutionMix(int it) { segment.set(JAVA_INT, 8, it); return this; }
        /** Coulomb coefficient, [0, 1e3], default 0.5 */
        public double friction() { return segment.get(JAVA_DOUBLE, 16); }
        public MaterialDesc friction(double it) { segment.set(JAVA_DOUBLE, 16, it); return this; }
        /** [0, 1], default 0 */
        public double restitution() { return segment.get(JAVA_DOUBLE, 24); }
        public MaterialDesc restitution(double it) { segment.set(JAVA_DOUBLE, 24, it); return this; }
    }

    /** What a body is made from. Fill with carom_body_desc_init(). */
    public static final class BodyDesc {
        public static final int SIZE = 312;
        public final MemorySegment segment;
        public BodyDesc(Arena arena) { segment = arena.allocate(SIZE, 8); carom_body_desc_init(segment, SIZE); }
        public BodyDesc(MemorySegment at) { segment = at; }
        /** CAROM_BODY_FIELD_*, CAROM_BODY_STAYS_AWAKE, CAROM_BODY_DISABLED bits */
        public int fields() { return segment.get(JAVA_INT, 4); }
        public BodyDesc fields(int it) { segment.set(JAVA_INT, 4, it); return this; }
        /** CAROM_BODY_*, default DYNAMIC */
        public int type() { return segment.get(JAVA_INT, 8); }
        public BodyDesc type(int it) { segment.set(JAVA_INT, 8, it); return this; }
        /** m, world: origin of the body frame */
        public double[] position() { return segment.asSlice(16, 24).toArray(JAVA_DOUBLE); }
        public BodyDesc position(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 16, count(it.length, 3)); return this; }
        /** x, y, z, w, unit within 1e-6, body to world; default identity */
        public double[] orientation() { return segment.asSlice(40, 32).toArray(JAVA_DOUBLE); }
        public BodyDesc orientation(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 40, count(it.length, 4)); return this; }
        /** m/s, world, of the centre of mass; 0 for static */
        public double[] linearVelocity() { return segment.asSlice(72, 24).toArray(JAVA_DOUBLE); }
        public BodyDesc linearVelocity(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 72, count(it.length, 3)); return this; }
        /** rad/s, world; 0 for static */
        public double[] angularVelocity() { return segment.asSlice(96, 24).toArray(JAVA_DOUBLE); }
        public BodyDesc angularVelocity(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 96, count(it.length, 3)); return this; }
        /** kg, read where fields has CAROM_BODY_FIELD_MASS, else 0; at least 1e-300 for dynamic. A dynamic body without mass from here or from a collider weighs 1 kg and does not rotate (a particle) */
        public double mass() { return segment.get(JAVA_DOUBLE, 120); }
        public BodyDesc mass(double it) { segment.set(JAVA_DOUBLE, 120, it); return this; }
        /** m, body frame: centre of mass; each within 1e15 */
        public double[] center() { return segment.asSlice(128, 24).toArray(JAVA_DOUBLE); }
        public BodyDesc center(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 128, count(it.length, 3)); return this; }
        /** kg m^2, body frame axes, about the centre, row-major, symmetric, positive definite; all zero: the body does not rotate */
        public double[] inertia() { return segment.asSlice(152, 72).toArray(JAVA_DOUBLE); }
        public BodyDesc inertia(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 152, count(it.length, 9)); return this; }
        /** 1/s, [0, 1e6], default 0: dv/dt = -c v */
        public double linearDamping() { return segment.get(JAVA_DOUBLE, 224); }
        public BodyDesc linearDamping(double it) { segment.set(JAVA_DOUBLE, 224, it); return this; }
        /** 1/s, [0, 1e6], default 0 */
        public double angularDamping() { return segment.get(JAVA_DOUBLE, 232); }
        public BodyDesc angularDamping(double it) { segment.set(JAVA_DOUBLE, 232, it); return this; }
        /** anything; the engine does not look */
        public long user() { return segment.get(JAVA_LONG, 240); }
        public BodyDesc user(long it) { segment.set(JAVA_LONG, 240, it); return this; }
        /** share of the world's gravity that acts on it, default 1: carom_body_set_gravity_factor() */
        public double gravityFactor() { return segment.get(JAVA_DOUBLE, 248); }
        public BodyDesc gravityFactor(double it) { segment.set(JAVA_DOUBLE, 248, it); return this; }
        /** CAROM_LOCK_* bits, of a dynamic body, default 0: carom_body_set_locks() */
        public int locks() { return segment.get(JAVA_INT, 256); }
        public BodyDesc locks(int it) { segment.set(JAVA_INT, 256, it); return this; }
        /** CAROM_CONTINUOUS_*, default AUTO: carom_body_set_continuous() */
        public int continuous() { return segment.get(JAVA_INT, 260); }
        public BodyDesc continuous(int it) { segment.set(JAVA_INT, 260, it); return this; }
        /** kg/s, at least 0, default 0: carom_body_set_drag() */
        public double linearDrag() { return segment.get(JAVA_DOUBLE, 264); }
        public BodyDesc linearDrag(double it) { segment.set(JAVA_DOUBLE, 264, it); return this; }
        /** kg/m, at least 0, default 0 */
        public double quadraticDrag() { return segment.get(JAVA_DOUBLE, 272); }
        public BodyDesc quadraticDrag(double it) { segment.set(JAVA_DOUBLE, 272, it); return this; }
        /** default 1: carom_body_set_force_field_mask() */
        public int forceFieldMask() { return segment.get(JAVA_INT, 280); }
        public BodyDesc forceFieldMask(int it) { segment.set(JAVA_INT, 280, it); return this; }
        /** A m^2, axes of the body, of a dynamic body, default 0 */
        public double[] magneticMoment() { return segment.asSlice(288, 24).toArray(JAVA_DOUBLE); }
        public BodyDesc magneticMoment(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 288, count(it.length, 3)); return this; }
    }

    /** What an attribute is. Strings have static storage. */
    public static final class AttributeInfo {
        public static final int SIZE = 96;
        public final MemorySegment segment;
        public AttributeInfo(Arena arena) { segment = arena.allocate(SIZE, 8); segment.set(JAVA_INT, 0, SIZE); }
        public AttributeInfo(MemorySegment at) { segment = at; }
        /** CAROM_ATTRIBUTE_* */
        public int attribute() { return segment.get(JAVA_INT, 4); }
        public AttributeInfo attribute(int it) { segment.set(JAVA_INT, 4, it); return this; }
        /** how many it has, 1 to 4 */
        public int numbers() { return segment.get(JAVA_INT, 8); }
        public AttributeInfo numbers(int it) { segment.set(JAVA_INT, 8, it); return this; }
        /** 1: whole numbers */
        public int isWhole() { return segment.get(JAVA_INT, 12); }
        public AttributeInfo isWhole(int it) { segment.set(JAVA_INT, 12, it); return this; }
        /** 1: only dynamic bodies may have another value than the usual one */
        public int ofDynamic() { return segment.get(JAVA_INT, 16); }
        public AttributeInfo ofDynamic(int it) { segment.set(JAVA_INT, 16, it); return this; }
        /** CAROM_EFFECT_*, which it makes a body take part in */
        public int effect() { return segment.get(JAVA_INT, 20); }
        public AttributeInfo effect(int it) { segment.set(JAVA_INT, 20, it); return this; }
        /** "gravity_factor" */
        public MemorySegment name() { return segment.get(ADDRESS, 24); }
        public AttributeInfo name(MemorySegment it) { segment.set(ADDRESS, 24, it); return this; }
        /** "kg/s, kg/m": of its numbers in turn; "1" of a share or of bits */
        public MemorySegment unit() { return segment.get(ADDRESS, 32); }
        public AttributeInfo unit(MemorySegment it) { segment.set(ADDRESS, 32, it); return this; }
        /** one line */
        public MemorySegment summary() { return segment.get(ADDRESS, 40); }
        public AttributeInfo summary(MemorySegment it) { segment.set(ADDRESS, 40, it); return this; }
        /** bounds of each number, inclusive */
        public double min() { return segment.get(JAVA_DOUBLE, 48); }
        public AttributeInfo min(double it) { segment.set(JAVA_DOUBLE, 48, it); return this; }
        /** likewise */
        public double max() { return segment.get(JAVA_DOUBLE, 56); }
        public AttributeInfo max(double it) { segment.set(JAVA_DOUBLE, 56, it); return this; }
        /** default, of a body when it is created; numbers that the attribute does not have are 0 */
        public double[] usual() { return segment.asSlice(64, 32).toArray(JAVA_DOUBLE); }
        public AttributeInfo usual(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 64, count(it.length, 4)); return this; }
    }

    /** A shape on a body. Fill with carom_collider_desc_init(). */
    public static final class ColliderDesc {
        public static final int SIZE = 160;
        public final MemorySegment segment;
        public ColliderDesc(Arena arena) { segment = arena.allocate(SIZE, 8); carom_collider_desc_init(segment, SIZE); }
        public ColliderDesc(MemorySegment at) { segment = at; }
        /** of the same engine as the world */
        public long shape() { return segment.get(JAVA_LONG, 8); }
        public ColliderDesc shape(long it) { segment.set(JAVA_LONG, 8, it); return this; }
        /** CAROM_NULL_HANDLE: friction 0.5, restitution 0 */
        public long material() { return segment.get(JAVA_LONG, 16); }
        public ColliderDesc material(long it) { segment.set(JAVA_LONG, 16, it); return this; }
        /** m, body frame: origin of the shape; each within 1e15 */
        public double[] position() { return segment.asSlice(24, 24).toArray(JAVA_DOUBLE); }
        public ColliderDesc position(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 24, count(it.length, 3)); return this; }
        /** x, y, z, w, shape to body; default identity */
        public double[] orientation() { return segment.asSlice(48, 32).toArray(JAVA_DOUBLE); }
        public ColliderDesc orientation(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 48, count(it.length, 4)); return this; }
        /** kg/m^3, [0, 1e9], default 1000; counts unless the body's mass is given */
        public double density() { return segment.get(JAVA_DOUBLE, 80); }
        public ColliderDesc density(double it) { segment.set(JAVA_DOUBLE, 80, it); return this; }
        /** bits, default CAROM_FILTER_CATEGORY: carom_collider_set_filter() */
        public long category() { return segment.get(JAVA_LONG, 88); }
        public ColliderDesc category(long it) { segment.set(JAVA_LONG, 88, it); return this; }
        /** bits, default CAROM_FILTER_MASK */
        public long mask() { return segment.get(JAVA_LONG, 96); }
        public ColliderDesc mask(long it) { segment.set(JAVA_LONG, 96, it); return this; }
        /** default 0: none */
        public int group() { return segment.get(JAVA_INT, 104); }
        public ColliderDesc group(int it) { segment.set(JAVA_INT, 104, it); return this; }
        /** 1: reports what overlaps it and touches nothing; default 0: carom_collider_set_sensor() */
        public int sensor() { return segment.get(JAVA_INT, 108); }
        public ColliderDesc sensor(int it) { segment.set(JAVA_INT, 108, it); return this; }
        /** m/s, axes of the shape, default 0: carom_collider_set_surface_velocity() */
        public double[] surfaceLinear() { return segment.asSlice(112, 24).toArray(JAVA_DOUBLE); }
        public ColliderDesc surfaceLinear(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 112, count(it.length, 3)); return this; }
        /** rad/s, axes of the shape, about its origin, default 0 */
        public double[] surfaceAngular() { return segment.asSlice(136, 24).toArray(JAVA_DOUBLE); }
        public ColliderDesc surfaceAngular(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 136, count(it.length, 3)); return this; }
    }

    /** How to cast; fill with carom_cast_desc_init(). */
    public static final class CastDesc {
        public static final int SIZE = 32;
        public final MemorySegment segment;
        public CastDesc(Arena arena) { segment = arena.allocate(SIZE, 8); carom_cast_desc_init(segment, SIZE); }
        public CastDesc(MemorySegment at) { segment = at; }
        /** cap, 1 to 10000, default 128: support calls of a ray or linear cast, distances of a time of impact */
        public int iterations() { return segment.get(JAVA_INT, 4); }
        public CastDesc iterations(int it) { segment.set(JAVA_INT, 4, it); return this; }
        /** width of the bracket as length of path, relative to the (smaller) bounding radius; of a time of impact: separation that counts as contact, likewise; bounds of the dial gjk_tolerance, default 1e-6 */
        public double tolerance() { return segment.get(JAVA_DOUBLE, 8); }
        public CastDesc tolerance(double it) { segment.set(JAVA_DOUBLE, 8, it); return this; }
        /** m, 0 to 1e9, default 0: separation that counts as contact (a ray becomes a ball of this radius) */
        public double target() { return segment.get(JAVA_DOUBLE, 16); }
        public CastDesc target(double it) { segment.set(JAVA_DOUBLE, 16, it); return this; }
        /** CAROM_ASK_GENERIC, CAROM_ASK_IGNORE_TOUCHED, default 0 */
        public int flags() { return segment.get(JAVA_INT, 24); }
        public CastDesc flags(int it) { segment.set(JAVA_INT, 24, it); return this; }
    }

    /** The result. Numbers of a fault (status CAROM_QUERY_FAULT) mean nothing. */
    public static final class Cast {
        public static final int SIZE = 136;
        public final MemorySegment segment;
        public Cast(Arena arena) { segment = arena.allocate(SIZE, 8); segment.set(JAVA_INT, 0, SIZE); }
        public Cast(MemorySegment at) { segment = at; }
        /** CAROM_CAST_* */
        public int outcome() { return segment.get(JAVA_INT, 4); }
        public Cast outcome(int it) { segment.set(JAVA_INT, 4, it); return this; }
        /** CAROM_QUERY_*: is the bracket as narrow as desc wants */
        public int status() { return segment.get(JAVA_INT, 8); }
        public Cast status(int it) { segment.set(JAVA_INT, 8, it); return this; }
        /** of the search for the time */
        public int iterations() { return segment.get(JAVA_INT, 12); }
        public Cast iterations(int it) { segment.set(JAVA_INT, 12, it); return this; }
        /** in [lower, upper]; fraction of the direction or motion, s for a time of impact */
        public double time() { return segment.get(JAVA_DOUBLE, 16); }
        public Cast time(double it) { segment.set(JAVA_DOUBLE, 16, it); return this; }
        /** a miss: end of the motion */
        public double lower() { return segment.get(JAVA_DOUBLE, 24); }
        public Cast lower(double it) { segment.set(JAVA_DOUBLE, 24, it); return this; }
        /** infinite unless in contact */
        public double upper() { return segment.get(JAVA_DOUBLE, 32); }
        public Cast upper(double it) { segment.set(JAVA_DOUBLE, 32, it); return this; }
        /** m, at `time`; the depth (negative) of shapes that overlap at the start */
        public double separation() { return segment.get(JAVA_DOUBLE, 40); }
        public Cast separation(double it) { segment.set(JAVA_DOUBLE, 40, it); return this; }
        /** m, see above: rounding, or the tolerance where a time of impact found a mere touch */
        public double slack() { return segment.get(JAVA_DOUBLE, 48); }
        public Cast slack(double it) { segment.set(JAVA_DOUBLE, 48, it); return this; }
        /** unit, world, from A (or the ray) to B, so opposed to the surface that a ray meets; a ray that starts inside: its direction; zero for a miss */
        public double[] normal() { return segment.asSlice(56, 24).toArray(JAVA_DOUBLE); }
        public Cast normal(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 56, count(it.length, 3)); return this; }
        /** m, world, at `time`: on the surface of A; of a ray: where it is */
        public double[] pointA() { return segment.asSlice(80, 24).toArray(JAVA_DOUBLE); }
        public Cast pointA(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 80, count(it.length, 3)); return this; }
        /** m, world, at `time`: on the surface of B */
        public double[] pointB() { return segment.asSlice(104, 24).toArray(JAVA_DOUBLE); }
        public Cast pointB(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 104, count(it.length, 3)); return this; }
        /** single calls, A and B together */
        public int supportCalls() { return segment.get(JAVA_INT, 128); }
        public Cast supportCalls(int it) { segment.set(JAVA_INT, 128, it); return this; }
    }

    /** A shape that travels and turns: its centre at constant velocity, the shape about its centre at constant angular
     *  velocity. Fill with carom_motion_init(). */
    public static final class Motion {
        public static final int SIZE = 136;
        public final MemorySegment segment;
        public Motion(Arena arena) { segment = arena.allocate(SIZE, 8); carom_motion_init(segment, SIZE); }
        public Motion(MemorySegment at) { segment = at; }
        /** m, world: origin of the shape at the start */
        public double[] position() { return segment.asSlice(8, 24).toArray(JAVA_DOUBLE); }
        public Motion position(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 8, count(it.length, 3)); return this; }
        /** x, y, z, w; default identity */
        public double[] orientation() { return segment.asSlice(32, 32).toArray(JAVA_DOUBLE); }
        public Motion orientation(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 32, count(it.length, 4)); return this; }
        /** m, in the shape's frame: what it turns about; default its origin */
        public double[] center() { return segment.asSlice(64, 24).toArray(JAVA_DOUBLE); }
        public Motion center(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 64, count(it.length, 3)); return this; }
        /** m/s, world, of the centre */
        public double[] linearVelocity() { return segment.asSlice(88, 24).toArray(JAVA_DOUBLE); }
        public Motion linearVelocity(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 88, count(it.length, 3)); return this; }
        /** rad/s, world */
        public double[] angularVelocity() { return segment.asSlice(112, 24).toArray(JAVA_DOUBLE); }
        public Motion angularVelocity(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 112, count(it.length, 3)); return this; }
    }

    public static final class Overlap {
        public static final int SIZE = 80;
        public final MemorySegment segment;
        public Overlap(Arena arena) { segment = arena.allocate(SIZE, 8); segment.set(JAVA_INT, 0, SIZE); }
        public Overlap(MemorySegment at) { segment = at; }
        /** CAROM_OVERLAP_* */
        public int outcome() { return segment.get(JAVA_INT, 4); }
        public Overlap outcome(int it) { segment.set(JAVA_INT, 4, it); return this; }
        /** m; apart: the separation is at least this */
        public double separationBound() { return segment.get(JAVA_DOUBLE, 8); }
        public Overlap separationBound(double it) { segment.set(JAVA_DOUBLE, 8, it); return this; }
        /** unit, world, from A to B; apart */
        public double[] normal() { return segment.asSlice(16, 24).toArray(JAVA_DOUBLE); }
        public Overlap normal(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 16, count(it.length, 3)); return this; }
        /** m, world; overlapping: in both shapes (between them, if the target is not 0) */
        public double[] point() { return segment.asSlice(40, 24).toArray(JAVA_DOUBLE); }
        public Overlap point(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 40, count(it.length, 3)); return this; }
        /** m, what rounding may have done to the proof */
        public double slack() { return segment.get(JAVA_DOUBLE, 64); }
        public Overlap slack(double it) { segment.set(JAVA_DOUBLE, 64, it); return this; }
        /** single calls, A and B together */
        public int supportCalls() { return segment.get(JAVA_INT, 72); }
        public Overlap supportCalls(int it) { segment.set(JAVA_INT, 72, it); return this; }
    }

    /** Rays in the caller's arrays, of float or double, at any stride (0: tightly packed). struct_size and scalar set by
     *  the caller, what is not set zero. */
    public static final class Rays {
        public static final int SIZE = 64;
        public final MemorySegment segment;
        public Rays(Arena arena) { segment = arena.allocate(SIZE, 8); segment.set(JAVA_INT, 0, SIZE); }
        public Rays(MemorySegment at) { segment = at; }
        /** CAROM_SCALAR_* of all three */
        public int scalar() { return segment.get(JAVA_INT, 4); }
        public Rays scalar(int it) { segment.set(JAVA_INT, 4, it); return this; }
        public long count() { return segment.get(JAVA_LONG, 8); }
        public Rays count(long it) { segment.set(JAVA_LONG, 8, it); return this; }
        /** [count] 3 scalars each, m */
        public MemorySegment origins() { return segment.get(ADDRESS, 16); }
        public Rays origins(MemorySegment it) { segment.set(ADDRESS, 16, it); return this; }
        /** [count] 3 scalars each, any length */
        public MemorySegment directions() { return segment.get(ADDRESS, 24); }
        public Rays directions(MemorySegment it) { segment.set(ADDRESS, 24, it); return this; }
        /** [count] or NULL: 1 each */
        public MemorySegment max() { return segment.get(ADDRESS, 32); }
        public Rays max(MemorySegment it) { segment.set(ADDRESS, 32, it); return this; }
        /** bytes */
        public long originStride() { return segment.get(JAVA_LONG, 40); }
        public Rays originStride(long it) { segment.set(JAVA_LONG, 40, it); return this; }
        public long directionStride() { return segment.get(JAVA_LONG, 48); }
        public Rays directionStride(long it) { segment.set(JAVA_LONG, 48, it); return this; }
        public long maxStride() { return segment.get(JAVA_LONG, 56); }
        public Rays maxStride(long it) { segment.set(JAVA_LONG, 56, it); return this; }
    }

    /** What one ray met. */
    public static final class RayHit {
        public static final int SIZE = 88;
        public final MemorySegment segment;
        public RayHit(Arena arena) { segment = arena.allocate(SIZE, 8); }
        public RayHit(MemorySegment at) { segment = at; }
        /** CAROM_CAST_*, BAD_RAY too */
        public int outcome() { return segment.get(JAVA_INT, 0); }
        public RayHit outcome(int it) { segment.set(JAVA_INT, 0, it); return this; }
        /** CAROM_QUERY_* */
        public int status() { return segment.get(JAVA_INT, 4); }
        public RayHit status(int it) { segment.set(JAVA_INT, 4, it); return this; }
        /** index in the list of shapes; CAROM_NO_SHAPE: none */
        public int shape() { return segment.get(JAVA_INT, 8); }
        public RayHit shape(int it) { segment.set(JAVA_INT, 8, it); return this; }
        /** as in carom_cast */
        public double time() { return segment.get(JAVA_DOUBLE, 16); }
        public RayHit time(double it) { segment.set(JAVA_DOUBLE, 16, it); return this; }
        /** as in carom_cast */
        public double lower() { return segment.get(JAVA_DOUBLE, 24); }
        public RayHit lower(double it) { segment.set(JAVA_DOUBLE, 24, it); return this; }
        /** as in carom_cast */
        public double upper() { return segment.get(JAVA_DOUBLE, 32); }
        public RayHit upper(double it) { segment.set(JAVA_DOUBLE, 32, it); return this; }
        /** unit, world, as in carom_cast */
        public double[] normal() { return segment.asSlice(40, 24).toArray(JAVA_DOUBLE); }
        public RayHit normal(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 40, count(it.length, 3)); return this; }
        /** m, world, on the shape's surface */
        public double[] point() { return segment.asSlice(64, 24).toArray(JAVA_DOUBLE); }
        public RayHit point(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 64, count(it.length, 3)); return this; }
    }

    /** Where results go: records, or separate arrays, or both; NULL: not wanted. Strides in bytes, 0: tightly packed. */
    public static final class RayHits {
        public static final int SIZE = 104;
        public final MemorySegment segment;
        public RayHits(Arena arena) { segment = arena.allocate(SIZE, 8); segment.set(JAVA_INT, 0, SIZE); }
        public RayHits(MemorySegment at) { segment = at; }
        /** CAROM_SCALAR_* of times, normals and points */
        public int scalar() { return segment.get(JAVA_INT, 4); }
        public RayHits scalar(int it) { segment.set(JAVA_INT, 4, it); return this; }
        /** [count]; a stride shorter than a record gets its prefix */
        public MemorySegment records() { return segment.get(ADDRESS, 8); }
        public RayHits records(MemorySegment it) { segment.set(ADDRESS, 8, it); return this; }
        /** [count] */
        public MemorySegment outcomes() { return segment.get(ADDRESS, 16); }
        public RayHits outcomes(MemorySegment it) { segment.set(ADDRESS, 16, it); return this; }
        /** [count] */
        public MemorySegment shapes() { return segment.get(ADDRESS, 24); }
        public RayHits shapes(MemorySegment it) { segment.set(ADDRESS, 24, it); return this; }
        /** [count] 1 scalar; a miss: max; a bad ray: 0 */
        public MemorySegment times() { return segment.get(ADDRESS, 32); }
        public RayHits times(MemorySegment it) { segment.set(ADDRESS, 32, it); return this; }
        /** [count] 3 scalars; a miss: 0 */
        public MemorySegment normals() { return segment.get(ADDRESS, 40); }
        public RayHits normals(MemorySegment it) { segment.set(ADDRESS, 40, it); return this; }
        /** [count] 3 scalars; a miss: 0 */
        public MemorySegment points() { return segment.get(ADDRESS, 48); }
        public RayHits points(MemorySegment it) { segment.set(ADDRESS, 48, it); return this; }
        public long recordStride() { return segment.get(JAVA_LONG, 56); }
        public RayHits recordStride(long it) { segment.set(JAVA_LONG, 56, it); return this; }
        public long outcomeStride() { return segment.get(JAVA_LONG, 64); }
        public RayHits outcomeStride(long it) { segment.set(JAVA_LONG, 64, it); return this; }
        public long shapeStride() { return segment.get(JAVA_LONG, 72); }
        public RayHits shapeStride(long it) { segment.set(JAVA_LONG, 72, it); return this; }
        public long timeStride() { return segment.get(JAVA_LONG, 80); }
        public RayHits timeStride(long it) { segment.set(JAVA_LONG, 80, it); return this; }
        public long normalStride() { return segment.get(JAVA_LONG, 88); }
        public RayHits normalStride(long it) { segment.set(JAVA_LONG, 88, it); return this; }
        public long pointStride() { return segment.get(JAVA_LONG, 96); }
        public RayHits pointStride(long it) { segment.set(JAVA_LONG, 96, it); return this; }
    }

    /** How a character moves. Fill with carom_character_desc_init(). Characters may share one, and it may change between
     *  moves. */
    public static final class CharacterDesc {
        public static final int SIZE = 144;
        public final MemorySegment segment;
        public CharacterDesc(Arena arena) { segment = arena.allocate(SIZE, 8); carom_character_desc_init(segment, SIZE); }
        public CharacterDesc(MemorySegment at) { segment = at; }
        /** CAROM_CHARACTER_* bits, default TURNS */
        public int flags() { return segment.get(JAVA_INT, 4); }
        public CharacterDesc flags(int it) { segment.set(JAVA_INT, 4, it); return this; }
        /** unit within 1e-6, world, default (0, 1, 0): against gravity */
        public double[] up() { return segment.asSlice(8, 24).toArray(JAVA_DOUBLE); }
        public CharacterDesc up(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 8, count(it.length, 3)); return this; }
        /** m/s^2, [0, 1e6], default 9.81: along -up. The world's own gravity is not looked at */
        public double gravity() { return segment.get(JAVA_DOUBLE, 32); }
        public CharacterDesc gravity(double it) { segment.set(JAVA_DOUBLE, 32, it); return this; }
        /** m/s, [0, 1e6], default 100: it falls no faster */
        public double fallSpeed() { return segment.get(JAVA_DOUBLE, 40); }
        public CharacterDesc fallSpeed(double it) { segment.set(JAVA_DOUBLE, 40, it); return this; }
        /** rad, [0, 1.57], default 0.8727 (50 degrees): ground up to this slope is firm */
        public double maxSlope() { return segment.get(JAVA_DOUBLE, 48); }
        public CharacterDesc maxSlope(double it) { segment.set(JAVA_DOUBLE, 48, it); return this; }
        /** m, [0, 1e6], default 0.3: it climbs what is no higher above the ground that it stands on */
        public double stepUp() { return segment.get(JAVA_DOUBLE, 56); }
        public CharacterDesc stepUp(double it) { segment.set(JAVA_DOUBLE, 56, it); return this; }
        /** m, [0, 1e6], default 0.3: it keeps to ground that falls away by no more */
        public double stepDown() { return segment.get(JAVA_DOUBLE, 64); }
        public CharacterDesc stepDown(double it) { segment.set(JAVA_DOUBLE, 64, it); return this; }
        /** m, [1e-6, 1e6], default 0.01: stands this far from what it touches, and 2 % more */
        public double skin() { return segment.get(JAVA_DOUBLE, 72); }
        public CharacterDesc skin(double it) { segment.set(JAVA_DOUBLE, 72, it); return this; }
        /** m/s^2, [0, 1e9], default 1e9: how fast its velocity follows `walk` on firm ground */
        public double acceleration() { return segment.get(JAVA_DOUBLE, 80); }
        public CharacterDesc acceleration(double it) { segment.set(JAVA_DOUBLE, 80, it); return this; }
        /** m/s^2, [0, 1e9], default 10: likewise in the air and on steep ground */
        public double airAcceleration() { return segment.get(JAVA_DOUBLE, 88); }
        public CharacterDesc airAcceleration(double it) { segment.set(JAVA_DOUBLE, 88, it); return this; }
        /** kg, [0, 1e9], default 80: presses on a dynamic body that it stands on */
        public double mass() { return segment.get(JAVA_DOUBLE, 96); }
        public CharacterDesc mass(double it) { segment.set(JAVA_DOUBLE, 96, it); return this; }
        /** N, [0, 1e12], default 500: the most that it pushes a body with, per contact */
        public double pushForce() { return segment.get(JAVA_DOUBLE, 104); }
        public CharacterDesc pushForce(double it) { segment.set(JAVA_DOUBLE, 104, it); return this; }
        /** m/s, [0, 1e6], default 5: how fast it leaves what it overlaps */
        public double recoverSpeed() { return segment.get(JAVA_DOUBLE, 112); }
        public CharacterDesc recoverSpeed(double it) { segment.set(JAVA_DOUBLE, 112, it); return this; }
        /** of its queries, default all bits: as carom_query_desc.category */
        public long category() { return segment.get(JAVA_LONG, 120); }
        public CharacterDesc category(long it) { segment.set(JAVA_LONG, 120, it); return this; }
        /** default all bits: as carom_query_desc.mask */
        public long mask() { return segment.get(JAVA_LONG, 128); }
        public CharacterDesc mask(long it) { segment.set(JAVA_LONG, 128, it); return this; }
        /** a body of its own that it passes over, see carom_character_move_body(); default none */
        public long body() { return segment.get(JAVA_LONG, 136); }
        public CharacterDesc body(long it) { segment.set(JAVA_LONG, 136, it); return this; }
    }

    /** Where a character is, how it moves and what it touches. Fill with carom_character_init(), then set position and
     *  call carom_character_set_shape(). To teleport it, write position, and set ground to CAROM_GROUND_AIR. */
    public static final class Character {
        public static final int SIZE = 784;
        public final MemorySegment segment;
        public Character(Arena arena) { segment = arena.allocate(SIZE, 8); carom_character_init(segment, SIZE); }
        public Character(MemorySegment at) { segment = at; }
        /** CAROM_GROUND_* */
        public int ground() { return segment.get(JAVA_INT, 4); }
        public Character ground(int it) { segment.set(JAVA_INT, 4, it); return this; }
        /** convex, by carom_character_set_shape() */
        public long shape() { return segment.get(JAVA_LONG, 8); }
        public Character shape(long it) { segment.set(JAVA_LONG, 8, it); return this; }
        /** m, world: origin of the shape */
        public double[] position() { return segment.asSlice(16, 24).toArray(JAVA_DOUBLE); }
        public Character position(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 16, count(it.length, 3)); return this; }
        /** x, y, z, w, shape to world; default identity */
        public double[] orientation() { return segment.asSlice(40, 32).toArray(JAVA_DOUBLE); }
        public Character orientation(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 40, count(it.length, 4)); return this; }
        /** m/s: on firm ground along it and relative to it, else in the world */
        public double[] velocity() { return segment.asSlice(72, 24).toArray(JAVA_DOUBLE); }
        public Character velocity(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 72, count(it.length, 3)); return this; }
        /** m, from the origin down to the lowest point of the shape: by set_shape */
        public double foot() { return segment.get(JAVA_DOUBLE, 96); }
        public Character foot(double it) { segment.set(JAVA_DOUBLE, 96, it); return this; }
        /** m, from the origin up to its highest point: likewise */
        public double head() { return segment.get(JAVA_DOUBLE, 104); }
        public Character head(double it) { segment.set(JAVA_DOUBLE, 104, it); return this; }
        /** m, from the origin to its farthest point across `up`: likewise */
        public double reach() { return segment.get(JAVA_DOUBLE, 112); }
        public Character reach(double it) { segment.set(JAVA_DOUBLE, 112, it); return this; }
        /** what it stands on or slides down, or CAROM_NULL_HANDLE */
        public long groundBody() { return segment.get(JAVA_LONG, 120); }
        public Character groundBody(long it) { segment.set(JAVA_LONG, 120, it); return this; }
        /** of ground_body */
        public long groundCollider() { return segment.get(JAVA_LONG, 128); }
        public Character groundCollider(long it) { segment.set(JAVA_LONG, 128, it); return this; }
        /** m, world: where it touches the ground */
        public double[] groundPoint() { return segment.asSlice(136, 24).toArray(JAVA_DOUBLE); }
        public Character groundPoint(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 136, count(it.length, 3)); return this; }
        /** unit, world, from the ground to it; `up` in the air */
        public double[] groundNormal() { return segment.asSlice(160, 24).toArray(JAVA_DOUBLE); }
        public Character groundNormal(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 160, count(it.length, 3)); return this; }
        /** m/s, world, of the ground at ground_point; in the air of the ground that it left */
        public double[] groundVelocity() { return segment.asSlice(184, 24).toArray(JAVA_DOUBLE); }
        public Character groundVelocity(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 184, count(it.length, 3)); return this; }
        /** m, world: where ground_body was at the last move */
        public double[] groundPosition() { return segment.asSlice(208, 24).toArray(JAVA_DOUBLE); }
        public Character groundPosition(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 208, count(it.length, 3)); return this; }
        /** x, y, z, w: likewise */
        public double[] groundOrientation() { return segment.asSlice(232, 32).toArray(JAVA_DOUBLE); }
        public Character groundOrientation(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 232, count(it.length, 4)); return this; }
        /** of the last move, CAROM_CHARACTER_CONTACTS at most */
        public int contactCount() { return segment.get(JAVA_INT, 264); }
        public Character contactCount(int it) { segment.set(JAVA_INT, 264, it); return this; }
        /** [contact_count] what was in its way */
        public long[] contactBodies() { return segment.asSlice(272, 64).toArray(JAVA_LONG); }
        public Character contactBodies(long... it) { MemorySegment.copy(it, 0, segment, JAVA_LONG, 272, count(it.length, 8)); return this; }
        /** [3 contact_count] m, world, on the surface of the body */
        public double[] contactPoints() { return segment.asSlice(336, 192).toArray(JAVA_DOUBLE); }
        public Character contactPoints(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 336, count(it.length, 24)); return this; }
        /** [3 contact_count] unit, world, from the body to the character */
        public double[] contactNormals() { return segment.asSlice(528, 192).toArray(JAVA_DOUBLE); }
        public Character contactNormals(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 528, count(it.length, 24)); return this; }
        /** [contact_count] m/s, at which it would have gone on into the body */
        public double[] contactSpeeds() { return segment.asSlice(720, 64).toArray(JAVA_DOUBLE); }
        public Character contactSpeeds(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 720, count(it.length, 8)); return this; }
    }

    /** What a dial is: documentation and bounds. Strings have static storage. */
    public static final class DialInfo {
        public static final int SIZE = 72;
        public final MemorySegment segment;
        public DialInfo(Arena arena) { segment = arena.allocate(SIZE, 8); segment.set(JAVA_INT, 0, SIZE); }
        public DialInfo(MemorySegment at) { segment = at; }
        /** CAROM_DIAL_* */
        public int dial() { return segment.get(JAVA_INT, 4); }
        public DialInfo dial(int it) { segment.set(JAVA_INT, 4, it); return this; }
        /** CAROM_DIAL_KIND_* */
        public int kind() { return segment.get(JAVA_INT, 8); }
        public DialInfo kind(int it) { segment.set(JAVA_INT, 8, it); return this; }
        /** for a choice: number of values, 0..choice_count-1 */
        public int choiceCount() { return segment.get(JAVA_INT, 12); }
        public DialInfo choiceCount(int it) { segment.set(JAVA_INT, 12, it); return this; }
        /** "broad_phase" */
        public MemorySegment name() { return segment.get(ADDRESS, 16); }
        public DialInfo name(MemorySegment it) { segment.set(ADDRESS, 16, it); return this; }
        /** "m", "m/s", "" */
        public MemorySegment unit() { return segment.get(ADDRESS, 24); }
        public DialInfo unit(MemorySegment it) { segment.set(ADDRESS, 24, it); return this; }
        /** one sentence: what it trades */
        public MemorySegment summary() { return segment.get(ADDRESS, 32); }
        public DialInfo summary(MemorySegment it) { segment.set(ADDRESS, 32, it); return this; }
        /** [choice_count] names in order; NULL unless a choice */
        public MemorySegment choices() { return segment.get(ADDRESS, 40); }
        public DialInfo choices(MemorySegment it) { segment.set(ADDRESS, 40, it); return this; }
        /** inclusive */
        public double min() { return segment.get(JAVA_DOUBLE, 48); }
        public DialInfo min(double it) { segment.set(JAVA_DOUBLE, 48, it); return this; }
        /** inclusive */
        public double max() { return segment.get(JAVA_DOUBLE, 56); }
        public DialInfo max(double it) { segment.set(JAVA_DOUBLE, 56, it); return this; }
        /** value of a new world */
        public double initial() { return segment.get(JAVA_DOUBLE, 64); }
        public DialInfo initial(double it) { segment.set(JAVA_DOUBLE, 64, it); return this; }
    }

    /** What a constant is. Strings have static storage. Names are distinct from those of dials; which constants there are,
     *  and in which order, may change from version to version. */
    public static final class ConstantInfo {
        public static final int SIZE = 48;
        public final MemorySegment segment;
        public ConstantInfo(Arena arena) { segment = arena.allocate(SIZE, 8); segment.set(JAVA_INT, 0, SIZE); }
        public ConstantInfo(MemorySegment at) { segment = at; }
        /** its number, from 0 */
        public int constant() { return segment.get(JAVA_INT, 4); }
        public ConstantInfo constant(int it) { segment.set(JAVA_INT, 4, it); return this; }
        /** "direct_impact_share" */
        public MemorySegment name() { return segment.get(ADDRESS, 8); }
        public ConstantInfo name(MemorySegment it) { segment.set(ADDRESS, 8, it); return this; }
        /** "rad", "steps"; "1" of a share or a ratio */
        public MemorySegment unit() { return segment.get(ADDRESS, 16); }
        public ConstantInfo unit(MemorySegment it) { segment.set(ADDRESS, 16, it); return this; }
        /** what it is, and why it is as large as that */
        public MemorySegment reason() { return segment.get(ADDRESS, 24); }
        public ConstantInfo reason(MemorySegment it) { segment.set(ADDRESS, 24, it); return this; }
        /** what breaks if it moves */
        public MemorySegment consequence() { return segment.get(ADDRESS, 32); }
        public ConstantInfo consequence(MemorySegment it) { segment.set(ADDRESS, 32, it); return this; }
        /** in its unit */
        public double value() { return segment.get(JAVA_DOUBLE, 40); }
        public ConstantInfo value(double it) { segment.set(JAVA_DOUBLE, 40, it); return this; }
    }

    public static final class DrawDesc {
        public static final int SIZE = 24;
        public final MemorySegment segment;
        public DrawDesc(Arena arena) { segment = arena.allocate(SIZE, 8); carom_draw_desc_init(segment, SIZE); }
        public DrawDesc(MemorySegment at) { segment = at; }
        /** CAROM_DRAW_* bits, default SHAPES | CONTACTS | JOINTS */
        public int what() { return segment.get(JAVA_INT, 4); }
        public DrawDesc what(int it) { segment.set(JAVA_INT, 4, it); return this; }
        /** CAROM_DRAW_BY_*, default BY_TYPE */
        public int colouring() { return segment.get(JAVA_INT, 8); }
        public DrawDesc colouring(int it) { segment.set(JAVA_INT, 8, it); return this; }
        /** m, length of normals and axes, default 0.2; &gt; 0 */
        public double scale() { return segment.get(JAVA_DOUBLE, 16); }
        public DrawDesc scale(double it) { segment.set(JAVA_DOUBLE, 16, it); return this; }
    }

    public static final class DrawLine {
        public static final int SIZE = 64;
        public final MemorySegment segment;
        public DrawLine(Arena arena) { segment = arena.allocate(SIZE, 8); }
        public DrawLine(MemorySegment at) { segment = at; }
        /** m, world */
        public double[] from() { return segment.asSlice(0, 24).toArray(JAVA_DOUBLE); }
        public DrawLine from(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 0, count(it.length, 3)); return this; }
        /** m, world */
        public double[] to() { return segment.asSlice(24, 24).toArray(JAVA_DOUBLE); }
        public DrawLine to(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 24, count(it.length, 3)); return this; }
        /** 0xRRGGBBAA */
        public int colour() { return segment.get(JAVA_INT, 48); }
        public DrawLine colour(int it) { segment.set(JAVA_INT, 48, it); return this; }
        /** one CAROM_DRAW_* bit */
        public int kind() { return segment.get(JAVA_INT, 52); }
        public DrawLine kind(int it) { segment.set(JAVA_INT, 52, it); return this; }
        /** that it belongs to; of a contact B; CAROM_NULL_HANDLE: the world's */
        public long body() { return segment.get(JAVA_LONG, 56); }
        public DrawLine body(long it) { segment.set(JAVA_LONG, 56, it); return this; }
    }

    /** What an engine is made from. Fill with carom_engine_desc_init(), then change what you need. */
    public static final class EngineDesc {
        public static final int SIZE = 48;
        public final MemorySegment segment;
        public EngineDesc(Arena arena) { segment = arena.allocate(SIZE, 8); carom_engine_desc_init(segment, SIZE); }
        public EngineDesc(MemorySegment at) { segment = at; }
        /** Host allocator, both or neither; NULL for the C library's. alloc returns NULL when out of memory; alignment is a power of two. Called on whichever threads use the engine and its worlds, at once. */
        public MemorySegment alloc() { return segment.get(ADDRESS, 8); }
        public EngineDesc alloc(MemorySegment it) { segment.set(ADDRESS, 8, it); return this; }
        /** Takes back what alloc gave, with the same size and alignment. */
        public MemorySegment free() { return segment.get(ADDRESS, 16); }
        public EngineDesc free(MemorySegment it) { segment.set(ADDRESS, 16, it); return this; }
        /** handed to alloc and free */
        public MemorySegment allocUser() { return segment.get(ADDRESS, 24); }
        public EngineDesc allocUser(MemorySegment it) { segment.set(ADDRESS, 24, it); return this; }
        /** Host log, or NULL for silence. */
        public MemorySegment log() { return segment.get(ADDRESS, 32); }
        public EngineDesc log(MemorySegment it) { segment.set(ADDRESS, 32, it); return this; }
        /** handed to log */
        public MemorySegment logUser() { return segment.get(ADDRESS, 40); }
        public EngineDesc logUser(MemorySegment it) { segment.set(ADDRESS, 40, it); return this; }
    }

    /** Which threads share the work of a step. The outcome does not depend on it: same bits for any number of threads.
     *  Fill with carom_jobs_desc_init(), then change what you need. */
    public static final class JobsDesc {
        public static final int SIZE = 24;
        public final MemorySegment segment;
        public JobsDesc(Arena arena) { segment = arena.allocate(SIZE, 8); carom_jobs_desc_init(segment, SIZE); }
        public JobsDesc(MemorySegment at) { segment = at; }
        /** Threads in a step, the one that calls carom_world_step() included: 0 or 1, the default, is that one alone; more are a pool that the engine owns, at most 256. Worlds that step at the same time do not wait for it: one of them has it. */
        public int threads() { return segment.get(JAVA_INT, 4); }
        public JobsDesc threads(int it) { segment.set(JAVA_INT, 4, it); return this; }
        /** Or the host's own threads (threads is then 0): see to it that job(context, begin, end) is called for ranges that cover [0, count), on any threads at once, and return when all these calls have returned. Called on the thread that steps, and tens of times a step: waking a thread should not take longer than some microseconds. Parts that are left out are done when it returns, those that come twice are done once. Calls of carom_* from inside a part, or from run itself, are REENTRANT. */
        public MemorySegment run() { return segment.get(ADDRESS, 8); }
        public JobsDesc run(MemorySegment it) { segment.set(ADDRESS, 8, it); return this; }
        /** handed to run */
        public MemorySegment user() { return segment.get(ADDRESS, 16); }
        public JobsDesc user(MemorySegment it) { segment.set(ADDRESS, 16, it); return this; }
    }

    /** Of two colliders; all their contact points together. Sleepers stay in touch. */
    public static final class ContactEvent {
        public static final int SIZE = 104;
        public final MemorySegment segment;
        public ContactEvent(Arena arena) { segment = arena.allocate(SIZE, 8); }
        public ContactEvent(MemorySegment at) { segment = at; }
        /** CAROM_CONTACT_* */
        public int kind() { return segment.get(JAVA_INT, 0); }
        public ContactEvent kind(int it) { segment.set(JAVA_INT, 0, it); return this; }
        /** first of the pair */
        public long colliderA() { return segment.get(JAVA_LONG, 8); }
        public ContactEvent colliderA(long it) { segment.set(JAVA_LONG, 8, it); return this; }
        /** second of the pair */
        public long colliderB() { return segment.get(JAVA_LONG, 16); }
        public ContactEvent colliderB(long it) { segment.set(JAVA_LONG, 16, it); return this; }
        /** of collider_a */
        public long bodyA() { return segment.get(JAVA_LONG, 24); }
        public ContactEvent bodyA(long it) { segment.set(JAVA_LONG, 24, it); return this; }
        /** of collider_b */
        public long bodyB() { return segment.get(JAVA_LONG, 32); }
        public ContactEvent bodyB(long it) { segment.set(JAVA_LONG, 32, it); return this; }
        /** m, world: the point that bore most */
        public double[] point() { return segment.asSlice(40, 24).toArray(JAVA_DOUBLE); }
        public ContactEvent point(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 40, count(it.length, 3)); return this; }
        /** unit, world, from A to B, there */
        public double[] normal() { return segment.asSlice(64, 24).toArray(JAVA_DOUBLE); }
        public ContactEvent normal(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 64, count(it.length, 3)); return this; }
        /** N s, normal, of all points, over the step */
        public double impulse() { return segment.get(JAVA_DOUBLE, 88); }
        public ContactEvent impulse(double it) { segment.set(JAVA_DOUBLE, 88, it); return this; }
        /** m/s, along the normal, of the point that approached fastest as the step began */
        public double approachSpeed() { return segment.get(JAVA_DOUBLE, 96); }
        public ContactEvent approachSpeed(double it) { segment.set(JAVA_DOUBLE, 96, it); return this; }
    }

    /** What a sensor overlaps at the end of the step and did not at the end of the one before, or the reverse. Sleepers are
     *  within what they sleep in. */
    public static final class SensorEvent {
        public static final int SIZE = 40;
        public final MemorySegment segment;
        public SensorEvent(Arena arena) { segment = arena.allocate(SIZE, 8); }
        public SensorEvent(MemorySegment at) { segment = at; }
        /** CAROM_SENSOR_* */
        public int kind() { return segment.get(JAVA_INT, 0); }
        public SensorEvent kind(int it) { segment.set(JAVA_INT, 0, it); return this; }
        /** the collider that is a sensor */
        public long sensor() { return segment.get(JAVA_LONG, 8); }
        public SensorEvent sensor(long it) { segment.set(JAVA_LONG, 8, it); return this; }
        /** the collider that overlaps it */
        public long other() { return segment.get(JAVA_LONG, 16); }
        public SensorEvent other(long it) { segment.set(JAVA_LONG, 16, it); return this; }
        /** of sensor */
        public long sensorBody() { return segment.get(JAVA_LONG, 24); }
        public SensorEvent sensorBody(long it) { segment.set(JAVA_LONG, 24, it); return this; }
        /** of other */
        public long otherBody() { return segment.get(JAVA_LONG, 32); }
        public SensorEvent otherBody(long it) { segment.set(JAVA_LONG, 32, it); return this; }
    }

    /** A body that sleeps at the end of the step and did not at the end of the one before, or the reverse. */
    public static final class SleepEvent {
        public static final int SIZE = 16;
        public final MemorySegment segment;
        public SleepEvent(Arena arena) { segment = arena.allocate(SIZE, 8); }
        public SleepEvent(MemorySegment at) { segment = at; }
        /** CAROM_SLEEP_* */
        public int kind() { return segment.get(JAVA_INT, 0); }
        public SleepEvent kind(int it) { segment.set(JAVA_INT, 0, it); return this; }
        /** that fell asleep or woke */
        public long body() { return segment.get(JAVA_LONG, 8); }
        public SleepEvent body(long it) { segment.set(JAVA_LONG, 8, it); return this; }
    }

    /** A joint that bore more than its break_force or break_torque in this step, and holds nothing any more. It stays until
     *  it is destroyed. */
    public static final class JointEvent {
        public static final int SIZE = 80;
        public final MemorySegment segment;
        public JointEvent(Arena arena) { segment = arena.allocate(SIZE, 8); }
        public JointEvent(MemorySegment at) { segment = at; }
        /** that broke */
        public long joint() { return segment.get(JAVA_LONG, 0); }
        public JointEvent joint(long it) { segment.set(JAVA_LONG, 0, it); return this; }
        /** CAROM_NULL_HANDLE: the world */
        public long bodyA() { return segment.get(JAVA_LONG, 8); }
        public JointEvent bodyA(long it) { segment.set(JAVA_LONG, 8, it); return this; }
        /** as in carom_joint_desc */
        public long bodyB() { return segment.get(JAVA_LONG, 16); }
        public JointEvent bodyB(long it) { segment.set(JAVA_LONG, 16, it); return this; }
        /** N, world, on B: mean over the step in which it broke, as in carom_joint_state */
        public double[] force() { return segment.asSlice(24, 24).toArray(JAVA_DOUBLE); }
        public JointEvent force(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 24, count(it.length, 3)); return this; }
        /** N m, world, on B about its point, likewise */
        public double[] torque() { return segment.asSlice(48, 24).toArray(JAVA_DOUBLE); }
        public JointEvent torque(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 48, count(it.length, 3)); return this; }
        /** which step that was: carom_step_report.steps after it */
        public long step() { return segment.get(JAVA_LONG, 72); }
        public JointEvent step(long it) { segment.set(JAVA_LONG, 72, it); return this; }
    }

    /** A support function that returned a false point: its shape is disabled from the next step on. Or a body or particles
     *  whose state was not finite: they are in quarantine. The same faults as those of carom_world_get_faults(), but by
     *  handles that keep their names when what they name is destroyed. */
    public static final class FaultEvent {
        public static final int SIZE = 96;
        public final MemorySegment segment;
        public FaultEvent(Arena arena) { segment = arena.allocate(SIZE, 8); }
        public FaultEvent(MemorySegment at) { segment = at; }
        /** CAROM_FAULT_* */
        public int kind() { return segment.get(JAVA_INT, 0); }
        public FaultEvent kind(int it) { segment.set(JAVA_INT, 0, it); return this; }
        /** that is disabled, or CAROM_NULL_HANDLE */
        public long shape() { return segment.get(JAVA_LONG, 8); }
        public FaultEvent shape(long it) { segment.set(JAVA_LONG, 8, it); return this; }
        /** a body with this shape, or the one in quarantine, or CAROM_NULL_HANDLE */
        public long body() { return segment.get(JAVA_LONG, 16); }
        public FaultEvent body(long it) { segment.set(JAVA_LONG, 16, it); return this; }
        /** the set, of CAROM_FAULT_PARTICLE_STATE, or CAROM_NULL_HANDLE */
        public long particles() { return segment.get(JAVA_LONG, 24); }
        public FaultEvent particles(long it) { segment.set(JAVA_LONG, 24, it); return this; }
        /** the first of it that was put in quarantine in this step: its index then */
        public long particle() { return segment.get(JAVA_LONG, 32); }
        public FaultEvent particle(long it) { segment.set(JAVA_LONG, 32, it); return this; }
        /** of a support function: the direction given */
        public double[] dir() { return segment.asSlice(40, 24).toArray(JAVA_DOUBLE); }
        public FaultEvent dir(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 40, count(it.length, 3)); return this; }
        /** and what came back */
        public double[] out() { return segment.asSlice(64, 24).toArray(JAVA_DOUBLE); }
        public FaultEvent out(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 64, count(it.length, 3)); return this; }
        /** carom_step_report.steps after the step */
        public long step() { return segment.get(JAVA_LONG, 88); }
        public FaultEvent step(long it) { segment.set(JAVA_LONG, 88, it); return this; }
    }

    /** What acts on every body that shares a bit of its mask, at the centre of mass. Distances d are softened: what the law
     *  reads is s = sqrt(d^2 + core^2), and the direction's length is d / s. Fill with carom_force_field_desc_init(). */
    public static final class ForceFieldDesc {
        public static final int SIZE = 184;
        public final MemorySegment segment;
        public ForceFieldDesc(Arena arena) { segment = arena.allocate(SIZE, 8); carom_force_field_desc_init(segment, SIZE); }
        public ForceFieldDesc(MemorySegment at) { segment = at; }
        /** CAROM_FORCE_FIELD_* */
        public int kind() { return segment.get(JAVA_INT, 4); }
        public ForceFieldDesc kind(int it) { segment.set(JAVA_INT, 4, it); return this; }
        /** 0: m/s^2, all bodies fall alike; 1: N, whatever their mass */
        public int isForce() { return segment.get(JAVA_INT, 8); }
        public ForceFieldDesc isForce(int it) { segment.set(JAVA_INT, 8, it); return this; }
        /** default 1: bodies that share a bit with it feel it, see carom_body_set_force_field_mask() */
        public int mask() { return segment.get(JAVA_INT, 12); }
        public ForceFieldDesc mask(int it) { segment.set(JAVA_INT, 12, it); return this; }
        /** m, world: the frame's origin */
        public double[] position() { return segment.asSlice(16, 24).toArray(JAVA_DOUBLE); }
        public ForceFieldDesc position(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 16, count(it.length, 3)); return this; }
        /** x, y, z, w, frame to world; default identity */
        public double[] orientation() { return segment.asSlice(40, 32).toArray(JAVA_DOUBLE); }
        public ForceFieldDesc orientation(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 40, count(it.length, 4)); return this; }
        /** m, &gt; 0, may be infinite (default): where a uniform field ends along the axes of the frame, and a vortex along its y axis */
        public double[] half() { return segment.asSlice(72, 24).toArray(JAVA_DOUBLE); }
        public ForceFieldDesc half(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 72, count(it.length, 3)); return this; }
        /** m/s^2 or N, world: of a uniform field; T: of a magnetic one */
        public double[] vector() { return segment.asSlice(96, 24).toArray(JAVA_DOUBLE); }
        public ForceFieldDesc vector(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 96, count(it.length, 3)); return this; }
        /** m/s^2 or N at distance `reference`: outward, or of a vortex around the axis */
        public double strength() { return segment.get(JAVA_DOUBLE, 120); }
        public ForceFieldDesc strength(double it) { segment.set(JAVA_DOUBLE, 120, it); return this; }
        /** likewise, of a vortex: towards the axis */
        public double pull() { return segment.get(JAVA_DOUBLE, 128); }
        public ForceFieldDesc pull(double it) { segment.set(JAVA_DOUBLE, 128, it); return this; }
        /** likewise, of a vortex: along the axis */
        public double lift() { return segment.get(JAVA_DOUBLE, 136); }
        public ForceFieldDesc lift(double it) { segment.set(JAVA_DOUBLE, 136, it); return this; }
        /** m, &gt; 0, default 1 */
        public double reference() { return segment.get(JAVA_DOUBLE, 144); }
        public ForceFieldDesc reference(double it) { segment.set(JAVA_DOUBLE, 144, it); return this; }
        /** m, &gt;= 0, default 0: softens the centre */
        public double core() { return segment.get(JAVA_DOUBLE, 152); }
        public ForceFieldDesc core(double it) { segment.set(JAVA_DOUBLE, 152, it); return this; }
        /** m, &gt; 0, may be infinite (default): beyond that distance there is nothing */
        public double reach() { return segment.get(JAVA_DOUBLE, 160); }
        public ForceFieldDesc reach(double it) { segment.set(JAVA_DOUBLE, 160, it); return this; }
        /** [-2, 8]: 0 the same everywhere, 1 a line's, 2 (default) a point's, -1 a spring's */
        public int falloff() { return segment.get(JAVA_INT, 168); }
        public ForceFieldDesc falloff(int it) { segment.set(JAVA_INT, 168, it); return this; }
        /** the host's; the engine does not read it */
        public long user() { return segment.get(JAVA_LONG, 176); }
        public ForceFieldDesc user(long it) { segment.set(JAVA_LONG, 176, it); return this; }
    }

    /** A spring as a force, F = stiffness (length - rest) + damping d(length)/dt along the line between two points: what it
     *  does between two steps is as exact as the integrator. A substep h resolves stiffness only up to where its frequency
     *  w has w h = 1; one that is stiffer is taken to be as stiff as that (carom_world_get_plan() says how many are). For
     *  those, and for rods and ropes, there is CAROM_JOINT_DISTANCE, which solves. Fill with carom_spring_desc_init(). */
    public static final class SpringDesc {
        public static final int SIZE = 104;
        public final MemorySegment segment;
        public SpringDesc(Arena arena) { segment = arena.allocate(SIZE, 8); carom_spring_desc_init(segment, SIZE); }
        public SpringDesc(MemorySegment at) { segment = at; }
        /** 1: a bungee, which neither pushes nor holds back what springs back; 0 */
        public int onlyPulls() { return segment.get(JAVA_INT, 4); }
        public SpringDesc onlyPulls(int it) { segment.set(JAVA_INT, 4, it); return this; }
        /** or CAROM_NULL_HANDLE: the world */
        public long bodyA() { return segment.get(JAVA_LONG, 8); }
        public SpringDesc bodyA(long it) { segment.set(JAVA_LONG, 8, it); return this; }
        /** likewise; not both, and one of the two must be dynamic */
        public long bodyB() { return segment.get(JAVA_LONG, 16); }
        public SpringDesc bodyB(long it) { segment.set(JAVA_LONG, 16, it); return this; }
        /** m, in A's frame, or world */
        public double[] anchorA() { return segment.asSlice(24, 24).toArray(JAVA_DOUBLE); }
        public SpringDesc anchorA(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 24, count(it.length, 3)); return this; }
        /** m, in B's frame, or world */
        public double[] anchorB() { return segment.asSlice(48, 24).toArray(JAVA_DOUBLE); }
        public SpringDesc anchorB(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 48, count(it.length, 3)); return this; }
        /** m, [0, 1e9] */
        public double rest() { return segment.get(JAVA_DOUBLE, 72); }
        public SpringDesc rest(double it) { segment.set(JAVA_DOUBLE, 72, it); return this; }
        /** N/m, [0, 1e30] */
        public double stiffness() { return segment.get(JAVA_DOUBLE, 80); }
        public SpringDesc stiffness(double it) { segment.set(JAVA_DOUBLE, 80, it); return this; }
        /** N s/m, [0, 1e30], default 0 */
        public double damping() { return segment.get(JAVA_DOUBLE, 88); }
        public SpringDesc damping(double it) { segment.set(JAVA_DOUBLE, 88, it); return this; }
        /** the host's; the engine does not read it */
        public long user() { return segment.get(JAVA_LONG, 96); }
        public SpringDesc user(long it) { segment.set(JAVA_LONG, 96, it); return this; }
    }

    /** All of space where normal . x &lt;= level is water. What of a body's colliders is in it (not sensors, not scenery) is
     *  pushed by the weight of what it displaces, at the middle of that part, against the world's gravity, and is taken
     *  along by the current: F = -drag * density * volume * (v - current). Balls, ellipsoids, boxes and hulls displace
     *  exactly what they cover, other shapes what a hull of 256 of their support points covers, scaled to their volume.
     *  Fill with carom_water_init(). */
    public static final class Water {
        public static final int SIZE = 80;
        public final MemorySegment segment;
        public Water(Arena arena) { segment = arena.allocate(SIZE, 8); carom_water_init(segment, SIZE); }
        public Water(MemorySegment at) { segment = at; }
        /** unit, out of the water, default (0, 1, 0) */
        public double[] normal() { return segment.asSlice(8, 24).toArray(JAVA_DOUBLE); }
        public Water normal(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 8, count(it.length, 3)); return this; }
        /** m, default 0 */
        public double level() { return segment.get(JAVA_DOUBLE, 32); }
        public Water level(double it) { segment.set(JAVA_DOUBLE, 32, it); return this; }
        /** kg/m^3, (0, 1e9], default 1000 */
        public double density() { return segment.get(JAVA_DOUBLE, 40); }
        public Water density(double it) { segment.set(JAVA_DOUBLE, 40, it); return this; }
        /** m/s, world, default 0 */
        public double[] current() { return segment.asSlice(48, 24).toArray(JAVA_DOUBLE); }
        public Water current(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 48, count(it.length, 3)); return this; }
        /** 1/s, [0, 1e6], default 1 */
        public double drag() { return segment.get(JAVA_DOUBLE, 72); }
        public Water drag(double it) { segment.set(JAVA_DOUBLE, 72, it); return this; }
    }

    /** Fill with carom_joint_desc_init(): a ball joint, frames at the origins of both bodies, unbreakable. A door on a
     *  hinge that stands upright, the joint's x axis along the world's y:
     *      desc.kind = CAROM_JOINT_HINGE, desc.fields = CAROM_JOINT_WORLD_FRAME, desc.body_b = door;
     *      desc.position_a[0] = 1, desc.orientation_a[2] = desc.orientation_a[3] = 0.70710678118654752; */
    public static final class JointDesc {
        public static final int SIZE = 176;
        public final MemorySegment segment;
        public JointDesc(Arena arena) { segment = arena.allocate(SIZE, 8); carom_joint_desc_init(segment, SIZE); }
        public JointDesc(MemorySegment at) { segment = at; }
        /** CAROM_JOINT_* */
        public int kind() { return segment.get(JAVA_INT, 4); }
        public JointDesc kind(int it) { segment.set(JAVA_INT, 4, it); return this; }
        /** CAROM_JOINT_* bits */
        public int fields() { return segment.get(JAVA_INT, 8); }
        public JointDesc fields(int it) { segment.set(JAVA_INT, 8, it); return this; }
        /** or CAROM_NULL_HANDLE: the world */
        public long bodyA() { return segment.get(JAVA_LONG, 16); }
        public JointDesc bodyA(long it) { segment.set(JAVA_LONG, 16, it); return this; }
        /** likewise; not both, and one of the two must be dynamic */
        public long bodyB() { return segment.get(JAVA_LONG, 24); }
        public JointDesc bodyB(long it) { segment.set(JAVA_LONG, 24, it); return this; }
        /** m, of the frame in A's coordinates */
        public double[] positionA() { return segment.asSlice(32, 24).toArray(JAVA_DOUBLE); }
        public JointDesc positionA(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 32, count(it.length, 3)); return this; }
        /** x, y, z, w: joint -&gt; A */
        public double[] orientationA() { return segment.asSlice(56, 32).toArray(JAVA_DOUBLE); }
        public JointDesc orientationA(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 56, count(it.length, 4)); return this; }
        /** m, in B */
        public double[] positionB() { return segment.asSlice(88, 24).toArray(JAVA_DOUBLE); }
        public JointDesc positionB(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 88, count(it.length, 3)); return this; }
        /** x, y, z, w, in B */
        public double[] orientationB() { return segment.asSlice(112, 32).toArray(JAVA_DOUBLE); }
        public JointDesc orientationB(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 112, count(it.length, 4)); return this; }
        /** m, [0, 1e9]: of a distance joint */
        public double length() { return segment.get(JAVA_DOUBLE, 144); }
        public JointDesc length(double it) { segment.set(JAVA_DOUBLE, 144, it); return this; }
        /** N, mean over a step, above which the joint breaks; 0: never */
        public double breakForce() { return segment.get(JAVA_DOUBLE, 152); }
        public JointDesc breakForce(double it) { segment.set(JAVA_DOUBLE, 152, it); return this; }
        /** N m, likewise */
        public double breakTorque() { return segment.get(JAVA_DOUBLE, 160); }
        public JointDesc breakTorque(double it) { segment.set(JAVA_DOUBLE, 160, it); return this; }
        /** the host's; the engine does not read it */
        public long user() { return segment.get(JAVA_LONG, 168); }
        public JointDesc user(long it) { segment.set(JAVA_LONG, 168, it); return this; }
    }

    /** A coordinate kept within bounds. */
    public static final class JointLimit {
        public static final int SIZE = 24;
        public final MemorySegment segment;
        public JointLimit(Arena arena) { segment = arena.allocate(SIZE, 8); carom_joint_limit_init(segment, SIZE); }
        public JointLimit(MemorySegment at) { segment = at; }
        /** 0 or 1 */
        public int enabled() { return segment.get(JAVA_INT, 4); }
        public JointLimit enabled(int it) { segment.set(JAVA_INT, 4, it); return this; }
        /** m or rad: twist [-1e3, 1e3], swing [0, pi], slide [-1e9, 1e9], distance [0, 1e9] */
        public double lower() { return segment.get(JAVA_DOUBLE, 8); }
        public JointLimit lower(double it) { segment.set(JAVA_DOUBLE, 8, it); return this; }
        /** at least lower */
        public double upper() { return segment.get(JAVA_DOUBLE, 16); }
        public JointLimit upper(double it) { segment.set(JAVA_DOUBLE, 16, it); return this; }
    }

    /** A coordinate driven at a speed. */
    public static final class JointMotor {
        public static final int SIZE = 24;
        public final MemorySegment segment;
        public JointMotor(Arena arena) { segment = arena.allocate(SIZE, 8); carom_joint_motor_init(segment, SIZE); }
        public JointMotor(MemorySegment at) { segment = at; }
        /** 1: on, 0: off */
        public int enabled() { return segment.get(JAVA_INT, 4); }
        public JointMotor enabled(int it) { segment.set(JAVA_INT, 4, it); return this; }
        /** m/s or rad/s, [-1e6, 1e6] */
        public double speed() { return segment.get(JAVA_DOUBLE, 8); }
        public JointMotor speed(double it) { segment.set(JAVA_DOUBLE, 8, it); return this; }
        /** N or N m, [0, 1e30]: how hard it pushes at most */
        public double maxForce() { return segment.get(JAVA_DOUBLE, 16); }
        public JointMotor maxForce(double it) { segment.set(JAVA_DOUBLE, 16, it); return this; }
    }

    /** A coordinate pulled towards a place: a spring, or a motor that holds a position. With x the stretch, w = 2 pi
     *  frequency and m what the joint's bodies weigh along the coordinate were they alone: force = -m (w^2 x + 2 damping w
     *  x'). */
    public static final class JointSpring {
        public static final int SIZE = 40;
        public final MemorySegment segment;
        public JointSpring(Arena arena) { segment = arena.allocate(SIZE, 8); carom_joint_spring_init(segment, SIZE); }
        public JointSpring(MemorySegment at) { segment = at; }
        /** 1: on, 0: off */
        public int enabled() { return segment.get(JAVA_INT, 4); }
        public JointSpring enabled(int it) { segment.set(JAVA_INT, 4, it); return this; }
        /** m or rad, within the bounds of a limit */
        public double target() { return segment.get(JAVA_DOUBLE, 8); }
        public JointSpring target(double it) { segment.set(JAVA_DOUBLE, 8, it); return this; }
        /** Hz, [0, 1e4]; a quarter of the substep rate at most acts */
        public double frequency() { return segment.get(JAVA_DOUBLE, 16); }
        public JointSpring frequency(double it) { segment.set(JAVA_DOUBLE, 16, it); return this; }
        /** ratio, [0, 1e3]; 1: critical */
        public double damping() { return segment.get(JAVA_DOUBLE, 24); }
        public JointSpring damping(double it) { segment.set(JAVA_DOUBLE, 24, it); return this; }
        /** N or N m, [0, 1e30]: how hard it pulls at most */
        public double maxForce() { return segment.get(JAVA_DOUBLE, 32); }
        public JointSpring maxForce(double it) { segment.set(JAVA_DOUBLE, 32, it); return this; }
    }

    /** By what a pulley or a gear turns the motion of A into that of B. Fill with carom_joint_transmission_init(). */
    public static final class JointTransmission {
        public static final int SIZE = 72;
        public final MemorySegment segment;
        public JointTransmission(Arena arena) { segment = arena.allocate(SIZE, 8); carom_joint_transmission_init(segment, SIZE); }
        public JointTransmission(MemorySegment at) { segment = at; }
        /** CAROM_JOINT_FIELD_LENGTH: length is given; else it is that of the rope as the bodies stand now */
        public int fields() { return segment.get(JAVA_INT, 4); }
        public JointTransmission fields(int it) { segment.set(JAVA_INT, 4, it); return this; }
        /** [0.001, 1000]: B's part of the rope counts so many times, as if it ran to and fro so often: B is pulled ratio times as hard as A, and moves 1 / ratio as far. Of a gear B's angle, likewise, of either sign: negative where they turn the same way, as in a ring gear. 1 at first */
        public double ratio() { return segment.get(JAVA_DOUBLE, 8); }
        public JointTransmission ratio(double it) { segment.set(JAVA_DOUBLE, 8, it); return this; }
        /** m, world: the place that A's part of the rope runs over. A gear has neither anchors nor length */
        public double[] anchorA() { return segment.asSlice(16, 24).toArray(JAVA_DOUBLE); }
        public JointTransmission anchorA(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 16, count(it.length, 3)); return this; }
        /** m, world: likewise of B's */
        public double[] anchorB() { return segment.asSlice(40, 24).toArray(JAVA_DOUBLE); }
        public JointTransmission anchorB(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 40, count(it.length, 3)); return this; }
        /** m, [0, 1e9]: |a - anchor_a| + ratio |b - anchor_b| is kept at it, a and b the joint's points. A part of the rope without length pulls nowhere: keep points off anchors */
        public double length() { return segment.get(JAVA_DOUBLE, 64); }
        public JointTransmission length(double it) { segment.set(JAVA_DOUBLE, 64, it); return this; }
    }

    /** What a coupling makes follow what: a gear between two hinges on anything, a finger that closes with another, a rack.
     *  The coordinate of a hinge is its twist, whole turns counted, that of a slider its slide. With x that of the leader,
     *  the follower's is polynomial[0] + polynomial[1] x + ... + polynomial[4] x^4. Each pushes the other: where something
     *  holds the follower, it holds the leader. Fill with carom_joint_coupling_init(). */
    public static final class JointCoupling {
        public static final int SIZE = 72;
        public final MemorySegment segment;
        public JointCoupling(Arena arena) { segment = arena.allocate(SIZE, 8); carom_joint_coupling_init(segment, SIZE); }
        public JointCoupling(MemorySegment at) { segment = at; }
        /** a hinge or slider */
        public long follower() { return segment.get(JAVA_LONG, 8); }
        public JointCoupling follower(long it) { segment.set(JAVA_LONG, 8, it); return this; }
        /** another */
        public long leader() { return segment.get(JAVA_LONG, 16); }
        public JointCoupling leader(long it) { segment.set(JAVA_LONG, 16, it); return this; }
        /** m or rad over powers of m or rad, each [-1e9, 1e9]; 0, 1, 0, 0, 0 at first: as far */
        public double[] polynomial() { return segment.asSlice(24, 40).toArray(JAVA_DOUBLE); }
        public JointCoupling polynomial(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 24, count(it.length, 5)); return this; }
        /** yours */
        public long user() { return segment.get(JAVA_LONG, 64); }
        public JointCoupling user(long it) { segment.set(JAVA_LONG, 64, it); return this; }
    }

    /** What one axis of a six-axis joint does, or that of a hinge or slider beside its own limit, motor and spring: a hinge
     *  has CAROM_AXIS_TURN_X, a slider CAROM_AXIS_X. Fill with carom_joint_axis_init(). A drive, a spring and stops act beside
     *  each other; of what is stiffer than (pi / 2 h)^2 m, h a substep, so much acts, and springs of one axis share it. */
    public static final class JointAxis {
        public static final int SIZE = 160;
        public final MemorySegment segment;
        public JointAxis(Arena arena) { segment = arena.allocate(SIZE, 8); carom_joint_axis_init(segment, SIZE); }
        public JointAxis(MemorySegment at) { segment = at; }
        /** CAROM_AXIS_MODE_* */
        public int mode() { return segment.get(JAVA_INT, 4); }
        public JointAxis mode(int it) { segment.set(JAVA_INT, 4, it); return this; }
        /** m, [-1e9, 1e9], or rad, [-1e3, 1e3] */
        public double lower() { return segment.get(JAVA_DOUBLE, 8); }
        public JointAxis lower(double it) { segment.set(JAVA_DOUBLE, 8, it); return this; }
        /** likewise, at least lower */
        public double upper() { return segment.get(JAVA_DOUBLE, 16); }
        public JointAxis upper(double it) { segment.set(JAVA_DOUBLE, 16, it); return this; }
        /** CAROM_GAINS_*: of the stops of a limit */
        public int stopGains() { return segment.get(JAVA_INT, 24); }
        public JointAxis stopGains(int it) { segment.set(JAVA_INT, 24, it); return this; }
        /** of a drive to a position */
        public int driveGains() { return segment.get(JAVA_INT, 28); }
        public JointAxis driveGains(int it) { segment.set(JAVA_INT, 28, it); return this; }
        /** of the spring beside the drive */
        public int springGains() { return segment.get(JAVA_INT, 32); }
        public JointAxis springGains(int it) { segment.set(JAVA_INT, 32, it); return this; }
        /** CAROM_DRIVE_* */
        public int drive() { return segment.get(JAVA_INT, 36); }
        public JointAxis drive(int it) { segment.set(JAVA_INT, 36, it); return this; }
        /** of a spring that pushes back from beyond a limit; in Hz [0, 1e4], else [0, 1e30]; it and stop_damping 0: the stops are hard */
        public double stopStiffness() { return segment.get(JAVA_DOUBLE, 40); }
        public JointAxis stopStiffness(double it) { segment.set(JAVA_DOUBLE, 40, it); return this; }
        /** beyond a limit; a ratio [0, 1e3], else [0, 1e30] */
        public double stopDamping() { return segment.get(JAVA_DOUBLE, 48); }
        public JointAxis stopDamping(double it) { segment.set(JAVA_DOUBLE, 48, it); return this; }
        /** m or rad, as lower: of a drive to a position */
        public double target() { return segment.get(JAVA_DOUBLE, 56); }
        public JointAxis target(double it) { segment.set(JAVA_DOUBLE, 56, it); return this; }
        /** m/s or rad/s, [-1e6, 1e6]: of a drive to a velocity; of a drive to a position that of its target */
        public double speed() { return segment.get(JAVA_DOUBLE, 64); }
        public JointAxis speed(double it) { segment.set(JAVA_DOUBLE, 64, it); return this; }
        /** N or N m, [-1e30, 1e30]: of a drive by effort */
        public double effort() { return segment.get(JAVA_DOUBLE, 72); }
        public JointAxis effort(double it) { segment.set(JAVA_DOUBLE, 72, it); return this; }
        /** N or N m, [0, 1e30]: how hard the drive pushes at most */
        public double maxForce() { return segment.get(JAVA_DOUBLE, 80); }
        public JointAxis maxForce(double it) { segment.set(JAVA_DOUBLE, 80, it); return this; }
        /** as stop_stiffness */
        public double driveStiffness() { return segment.get(JAVA_DOUBLE, 88); }
        public JointAxis driveStiffness(double it) { segment.set(JAVA_DOUBLE, 88, it); return this; }
        /** as stop_damping */
        public double driveDamping() { return segment.get(JAVA_DOUBLE, 96); }
        public JointAxis driveDamping(double it) { segment.set(JAVA_DOUBLE, 96, it); return this; }
        /** m or rad, as lower: where the spring rests */
        public double rest() { return segment.get(JAVA_DOUBLE, 104); }
        public JointAxis rest(double it) { segment.set(JAVA_DOUBLE, 104, it); return this; }
        /** as stop_stiffness; it and spring_damping 0: there is none */
        public double springStiffness() { return segment.get(JAVA_DOUBLE, 112); }
        public JointAxis springStiffness(double it) { segment.set(JAVA_DOUBLE, 112, it); return this; }
        /** as stop_damping */
        public double springDamping() { return segment.get(JAVA_DOUBLE, 120); }
        public JointAxis springDamping(double it) { segment.set(JAVA_DOUBLE, 120, it); return this; }
        /** N or N m, [0, 1e30]: resists any motion along the axis with at most so much; beside the drive */
        public double friction() { return segment.get(JAVA_DOUBLE, 128); }
        public JointAxis friction(double it) { segment.set(JAVA_DOUBLE, 128, it); return this; }
        /** kg or kg m^2, [0, 1e30]: inertia of a rotor that turns as the axis does, such as a motor's times the square of its gear. It adds armature speed^2 / 2 to the kinetic energy, and gives the bodies no spin of its own. A host that sets velocities sets the rotor's. */
        public double armature() { return segment.get(JAVA_DOUBLE, 136); }
        public JointAxis armature(double it) { segment.set(JAVA_DOUBLE, 136, it); return this; }
        /** N or N m, [0, 1e30]: how hard the drives of the axis push at most, however large their max_force is; of a hinge or slider its motor and spring, too. Several that act have even shares. Springs of axes, stops, friction and locks have no part in it. 1e30: none */
        public double effortLimit() { return segment.get(JAVA_DOUBLE, 144); }
        public JointAxis effortLimit(double it) { segment.set(JAVA_DOUBLE, 144, it); return this; }
        /** m/s or rad/s, [0, 1e30]: the axis goes no faster, either way, whatever that takes. Of effect joint_limits. 1e30: none */
        public double speedLimit() { return segment.get(JAVA_DOUBLE, 152); }
        public JointAxis speedLimit(double it) { segment.set(JAVA_DOUBLE, 152, it); return this; }
    }

    /** A drive of all three turns as one, by the shortest way: of a ball, or of a six-axis joint none of whose turns is
     *  locked (else it rests). With e the rotation vector, in A's frame, of the shortest turn from the target to where B's
     *  frame is, its torque is stiffness (-e) + damping (velocity - omega), about each of A's axes `max_force` at most.
     *  Fill with carom_joint_orientation_drive_init(). */
    public static final class JointOrientationDrive {
        public static final int SIZE = 136;
        public final MemorySegment segment;
        public JointOrientationDrive(Arena arena) { segment = arena.allocate(SIZE, 8); carom_joint_orientation_drive_init(segment, SIZE); }
        public JointOrientationDrive(MemorySegment at) { segment = at; }
        /** CAROM_DRIVE_* */
        public int drive() { return segment.get(JAVA_INT, 4); }
        public JointOrientationDrive drive(int it) { segment.set(JAVA_INT, 4, it); return this; }
        /** CAROM_GAINS_* */
        public int gains() { return segment.get(JAVA_INT, 8); }
        public JointOrientationDrive gains(int it) { segment.set(JAVA_INT, 8, it); return this; }
        /** x, y, z, w: B's frame -&gt; A's; of CAROM_DRIVE_POSITION. Half a turn off there is no shortest way */
        public double[] target() { return segment.asSlice(16, 32).toArray(JAVA_DOUBLE); }
        public JointOrientationDrive target(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 16, count(it.length, 4)); return this; }
        /** rad/s, [-1e6, 1e6], A's frame, of B relative to A */
        public double[] velocity() { return segment.asSlice(48, 24).toArray(JAVA_DOUBLE); }
        public JointOrientationDrive velocity(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 48, count(it.length, 3)); return this; }
        /** N m, [-1e30, 1e30], A's frame: of CAROM_DRIVE_EFFORT */
        public double[] effort() { return segment.asSlice(72, 24).toArray(JAVA_DOUBLE); }
        public JointOrientationDrive effort(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 72, count(it.length, 3)); return this; }
        /** N m, [0, 1e30], about A's x, y, z axis */
        public double[] maxForce() { return segment.asSlice(96, 24).toArray(JAVA_DOUBLE); }
        public JointOrientationDrive maxForce(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 96, count(it.length, 3)); return this; }
        /** Hz [0, 1e4], else [0, 1e30] */
        public double stiffness() { return segment.get(JAVA_DOUBLE, 120); }
        public JointOrientationDrive stiffness(double it) { segment.set(JAVA_DOUBLE, 120, it); return this; }
        /** a ratio [0, 1e3], else [0, 1e30] */
        public double damping() { return segment.get(JAVA_DOUBLE, 128); }
        public JointOrientationDrive damping(double it) { segment.set(JAVA_DOUBLE, 128, it); return this; }
    }

    /** What a joint does and where it is. */
    public static final class JointState {
        public static final int SIZE = 152;
        public final MemorySegment segment;
        public JointState(Arena arena) { segment = arena.allocate(SIZE, 8); segment.set(JAVA_INT, 0, SIZE); }
        public JointState(MemorySegment at) { segment = at; }
        /** 1: it bore too much, and holds nothing any more */
        public int broken() { return segment.get(JAVA_INT, 4); }
        public JointState broken(int it) { segment.set(JAVA_INT, 4, it); return this; }
        /** N, world, on B at its point, of locks, limits, motors and springs, mean over the last step; on A the opposite, but of a pulley 1 / ratio of it, along A's own part of the rope */
        public double[] force() { return segment.asSlice(8, 24).toArray(JAVA_DOUBLE); }
        public JointState force(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 8, count(it.length, 3)); return this; }
        /** N m, world, on B about its point, likewise */
        public double[] torque() { return segment.asSlice(32, 24).toArray(JAVA_DOUBLE); }
        public JointState torque(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 32, count(it.length, 3)); return this; }
        /** m, how far the points are from where they should be, limits included */
        public double gap() { return segment.get(JAVA_DOUBLE, 56); }
        public JointState gap(double it) { segment.set(JAVA_DOUBLE, 56, it); return this; }
        /** rad, how far the axes are, likewise; of a gear how far its wheels have slipped, of A's turns */
        public double angle() { return segment.get(JAVA_DOUBLE, 64); }
        public JointState angle(double it) { segment.set(JAVA_DOUBLE, 64, it); return this; }
        /** By CAROM_COORDINATE_*, as the bodies stand now. A twist of a ball, a hinge or six axes counts whole turns. It begins in (-pi, pi] as the joint is made, and goes on from step to step. Snapshots and forks keep it. A pose that a host sets stands for many angles: taken is the one nearest to the last. Where that lies over 0.1 rad beyond a limit and another does not, that other is taken. A limit that is set over half a turn away makes whole turns be forgotten, too. */
        public double[] coordinate() { return segment.asSlice(72, 32).toArray(JAVA_DOUBLE); }
        public JointState coordinate(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 72, count(it.length, 4)); return this; }
        /** m and rad, by CAROM_AXIS_*, likewise; of any kind */
        public double[] axis() { return segment.asSlice(104, 48).toArray(JAVA_DOUBLE); }
        public JointState axis(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 104, count(it.length, 6)); return this; }
    }

    /** A cause: what it gave in the last step, and since the ledger began. */
    public static final class LedgerEntry {
        public static final int SIZE = 136;
        public final MemorySegment segment;
        public LedgerEntry(Arena arena) { segment = arena.allocate(SIZE, 8); }
        public LedgerEntry(MemorySegment at) { segment = at; }
        /** static, zero-terminated */
        public MemorySegment name() { return segment.get(ADDRESS, 0); }
        public LedgerEntry name(MemorySegment it) { segment.set(ADDRESS, 0, it); return this; }
        /** J, in the last step */
        public double kinetic() { return segment.get(JAVA_DOUBLE, 8); }
        public LedgerEntry kinetic(double it) { segment.set(JAVA_DOUBLE, 8, it); return this; }
        /** J */
        public double potential() { return segment.get(JAVA_DOUBLE, 16); }
        public LedgerEntry potential(double it) { segment.set(JAVA_DOUBLE, 16, it); return this; }
        /** N s, world */
        public double[] linear() { return segment.asSlice(24, 24).toArray(JAVA_DOUBLE); }
        public LedgerEntry linear(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 24, count(it.length, 3)); return this; }
        /** N m s, world, about the origin */
        public double[] angular() { return segment.asSlice(48, 24).toArray(JAVA_DOUBLE); }
        public LedgerEntry angular(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 48, count(it.length, 3)); return this; }
        /** J, since the ledger began, with the last step */
        public double totalKinetic() { return segment.get(JAVA_DOUBLE, 72); }
        public LedgerEntry totalKinetic(double it) { segment.set(JAVA_DOUBLE, 72, it); return this; }
        /** J */
        public double totalPotential() { return segment.get(JAVA_DOUBLE, 80); }
        public LedgerEntry totalPotential(double it) { segment.set(JAVA_DOUBLE, 80, it); return this; }
        /** N s, world */
        public double[] totalLinear() { return segment.asSlice(88, 24).toArray(JAVA_DOUBLE); }
        public LedgerEntry totalLinear(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 88, count(it.length, 3)); return this; }
        /** N m s, world, about the origin */
        public double[] totalAngular() { return segment.asSlice(112, 24).toArray(JAVA_DOUBLE); }
        public LedgerEntry totalAngular(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 112, count(it.length, 3)); return this; }
    }

    /** The state itself, summed apart from the causes. After a step `now` is `before` plus the causes of that step, and
     *  `start` plus their totals, but for rounding: no more than the bounds here. */
    public static final class LedgerState {
        public static final int SIZE = 256;
        public final MemorySegment segment;
        public LedgerState(Arena arena) { segment = arena.allocate(SIZE, 8); segment.set(JAVA_INT, 0, SIZE); }
        public LedgerState(MemorySegment at) { segment = at; }
        /** 0: no ledger, all below is 0 */
        public int isKept() { return segment.get(JAVA_INT, 4); }
        public LedgerState isKept(int it) { segment.set(JAVA_INT, 4, it); return this; }
        /** since the ledger began */
        public long steps() { return segment.get(JAVA_LONG, 8); }
        public LedgerState steps(long it) { segment.set(JAVA_LONG, 8, it); return this; }
        /** J, as the ledger began */
        public double startKinetic() { return segment.get(JAVA_DOUBLE, 16); }
        public LedgerState startKinetic(double it) { segment.set(JAVA_DOUBLE, 16, it); return this; }
        /** J */
        public double startPotential() { return segment.get(JAVA_DOUBLE, 24); }
        public LedgerState startPotential(double it) { segment.set(JAVA_DOUBLE, 24, it); return this; }
        /** N s */
        public double[] startLinear() { return segment.asSlice(32, 24).toArray(JAVA_DOUBLE); }
        public LedgerState startLinear(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 32, count(it.length, 3)); return this; }
        /** N m s */
        public double[] startAngular() { return segment.asSlice(56, 24).toArray(JAVA_DOUBLE); }
        public LedgerState startAngular(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 56, count(it.length, 3)); return this; }
        /** J, after the step before the last */
        public double beforeKinetic() { return segment.get(JAVA_DOUBLE, 80); }
        public LedgerState beforeKinetic(double it) { segment.set(JAVA_DOUBLE, 80, it); return this; }
        /** J */
        public double beforePotential() { return segment.get(JAVA_DOUBLE, 88); }
        public LedgerState beforePotential(double it) { segment.set(JAVA_DOUBLE, 88, it); return this; }
        /** N s */
        public double[] beforeLinear() { return segment.asSlice(96, 24).toArray(JAVA_DOUBLE); }
        public LedgerState beforeLinear(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 96, count(it.length, 3)); return this; }
        /** N m s */
        public double[] beforeAngular() { return segment.asSlice(120, 24).toArray(JAVA_DOUBLE); }
        public LedgerState beforeAngular(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 120, count(it.length, 3)); return this; }
        /** J, after the last step */
        public double nowKinetic() { return segment.get(JAVA_DOUBLE, 144); }
        public LedgerState nowKinetic(double it) { segment.set(JAVA_DOUBLE, 144, it); return this; }
        /** J */
        public double nowPotential() { return segment.get(JAVA_DOUBLE, 152); }
        public LedgerState nowPotential(double it) { segment.set(JAVA_DOUBLE, 152, it); return this; }
        /** N s */
        public double[] nowLinear() { return segment.asSlice(160, 24).toArray(JAVA_DOUBLE); }
        public LedgerState nowLinear(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 160, count(it.length, 3)); return this; }
        /** N m s */
        public double[] nowAngular() { return segment.asSlice(184, 24).toArray(JAVA_DOUBLE); }
        public LedgerState nowAngular(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 184, count(it.length, 3)); return this; }
        /** J, of the last step */
        public double roundingEnergy() { return segment.get(JAVA_DOUBLE, 208); }
        public LedgerState roundingEnergy(double it) { segment.set(JAVA_DOUBLE, 208, it); return this; }
        /** N s */
        public double roundingLinear() { return segment.get(JAVA_DOUBLE, 216); }
        public LedgerState roundingLinear(double it) { segment.set(JAVA_DOUBLE, 216, it); return this; }
        /** N m s */
        public double roundingAngular() { return segment.get(JAVA_DOUBLE, 224); }
        public LedgerState roundingAngular(double it) { segment.set(JAVA_DOUBLE, 224, it); return this; }
        /** J, since the ledger began */
        public double totalRoundingEnergy() { return segment.get(JAVA_DOUBLE, 232); }
        public LedgerState totalRoundingEnergy(double it) { segment.set(JAVA_DOUBLE, 232, it); return this; }
        /** N s */
        public double totalRoundingLinear() { return segment.get(JAVA_DOUBLE, 240); }
        public LedgerState totalRoundingLinear(double it) { segment.set(JAVA_DOUBLE, 240, it); return this; }
        /** N m s */
        public double totalRoundingAngular() { return segment.get(JAVA_DOUBLE, 248); }
        public LedgerState totalRoundingAngular(double it) { segment.set(JAVA_DOUBLE, 248, it); return this; }
    }

    /** Pairs in the caller's arrays, at any stride (0: tightly packed). struct_size set by the caller, what is not set
     *  zero. */
    public static final class Pairs {
        public static final int SIZE = 112;
        public final MemorySegment segment;
        public Pairs(Arena arena) { segment = arena.allocate(SIZE, 8); segment.set(JAVA_INT, 0, SIZE); }
        public Pairs(MemorySegment at) { segment = at; }
        /** pairs, at most 2^24 */
        public long count() { return segment.get(JAVA_LONG, 8); }
        public Pairs count(long it) { segment.set(JAVA_LONG, 8, it); return this; }
        /** one each */
        public MemorySegment shapesA() { return segment.get(ADDRESS, 16); }
        public Pairs shapesA(MemorySegment it) { segment.set(ADDRESS, 16, it); return this; }
        /** likewise */
        public MemorySegment shapesB() { return segment.get(ADDRESS, 24); }
        public Pairs shapesB(MemorySegment it) { segment.set(ADDRESS, 24, it); return this; }
        /** 3 each, m, world */
        public MemorySegment positionsA() { return segment.get(ADDRESS, 32); }
        public Pairs positionsA(MemorySegment it) { segment.set(ADDRESS, 32, it); return this; }
        /** 4 each: x, y, z, w */
        public MemorySegment orientationsA() { return segment.get(ADDRESS, 40); }
        public Pairs orientationsA(MemorySegment it) { segment.set(ADDRESS, 40, it); return this; }
        /** 3 each, m, world */
        public MemorySegment positionsB() { return segment.get(ADDRESS, 48); }
        public Pairs positionsB(MemorySegment it) { segment.set(ADDRESS, 48, it); return this; }
        /** 4 each: x, y, z, w */
        public MemorySegment orientationsB() { return segment.get(ADDRESS, 56); }
        public Pairs orientationsB(MemorySegment it) { segment.set(ADDRESS, 56, it); return this; }
        /** bytes; 0: tightly packed */
        public long shapeAStride() { return segment.get(JAVA_LONG, 64); }
        public Pairs shapeAStride(long it) { segment.set(JAVA_LONG, 64, it); return this; }
        /** likewise */
        public long shapeBStride() { return segment.get(JAVA_LONG, 72); }
        public Pairs shapeBStride(long it) { segment.set(JAVA_LONG, 72, it); return this; }
        /** likewise */
        public long positionAStride() { return segment.get(JAVA_LONG, 80); }
        public Pairs positionAStride(long it) { segment.set(JAVA_LONG, 80, it); return this; }
        /** likewise */
        public long orientationAStride() { return segment.get(JAVA_LONG, 88); }
        public Pairs orientationAStride(long it) { segment.set(JAVA_LONG, 88, it); return this; }
        /** likewise */
        public long positionBStride() { return segment.get(JAVA_LONG, 96); }
        public Pairs positionBStride(long it) { segment.set(JAVA_LONG, 96, it); return this; }
        /** likewise */
        public long orientationBStride() { return segment.get(JAVA_LONG, 104); }
        public Pairs orientationBStride(long it) { segment.set(JAVA_LONG, 104, it); return this; }
    }

    /** A device, and what it has done since it was opened. */
    public static final class DeviceInfo {
        public static final int SIZE = 280;
        public final MemorySegment segment;
        public DeviceInfo(Arena arena) { segment = arena.allocate(SIZE, 8); segment.set(JAVA_INT, 0, SIZE); }
        public DeviceInfo(MemorySegment at) { segment = at; }
        /** as its driver says, zero-terminated */
        public String name() { return segment.getString(8); }
        /** of OpenCL and the driver, zero-terminated */
        public String version() { return segment.getString(136); }
        /** that it was asked for */
        public long pairs() { return segment.get(JAVA_LONG, 264); }
        public DeviceInfo pairs(long it) { segment.set(JAVA_LONG, 264, it); return this; }
        /** of them, left to the host */
        public long hostPairs() { return segment.get(JAVA_LONG, 272); }
        public DeviceInfo hostPairs(long it) { segment.set(JAVA_LONG, 272, it); return this; }
    }

    /** What all particles of a set have in common. Fill with carom_particles_desc_init(). */
    public static final class ParticlesDesc {
        public static final int SIZE = 40;
        public final MemorySegment segment;
        public ParticlesDesc(Arena arena) { segment = arena.allocate(SIZE, 8); carom_particles_desc_init(segment, SIZE); }
        public ParticlesDesc(MemorySegment at) { segment = at; }
        /** of the world's gravity, [-1e3, 1e3], default 1 */
        public double gravityFactor() { return segment.get(JAVA_DOUBLE, 8); }
        public ParticlesDesc gravityFactor(double it) { segment.set(JAVA_DOUBLE, 8, it); return this; }
        /** 1/s, [0, 1e6], default 0: dv/dt = -c v, as a body's */
        public double linearDamping() { return segment.get(JAVA_DOUBLE, 16); }
        public ParticlesDesc linearDamping(double it) { segment.set(JAVA_DOUBLE, 16, it); return this; }
        /** kg, (0, 1e30], default 1: of each particle that is added from now on. It falls and is braked as any other; the mass counts in CAROM_FIELD_MASS and in the energy of the report */
        public double mass() { return segment.get(JAVA_DOUBLE, 24); }
        public ParticlesDesc mass(double it) { segment.set(JAVA_DOUBLE, 24, it); return this; }
        /** particles to reserve memory for; it grows beyond. default 0 */
        public long capacity() { return segment.get(JAVA_LONG, 32); }
        public ParticlesDesc capacity(long it) { segment.set(JAVA_LONG, 32, it); return this; }
    }

    /** A line of the plan: a stage or an effect, as it was in the last step. */
    public static final class PlanLine {
        public static final int SIZE = 248;
        public final MemorySegment segment;
        public PlanLine(Arena arena) { segment = arena.allocate(SIZE, 8); }
        public PlanLine(MemorySegment at) { segment = at; }
        /** CAROM_EFFECT_*, or CAROM_PLAN_NO_EFFECT: a stage */
        public int effect() { return segment.get(JAVA_INT, 0); }
        public PlanLine effect(int it) { segment.set(JAVA_INT, 0, it); return this; }
        /** CAROM_STAGE_* that it is part of */
        public int stage() { return segment.get(JAVA_INT, 4); }
        public PlanLine stage(int it) { segment.set(JAVA_INT, 4, it); return this; }
        /** CAROM_MODE_* for the world */
        public int mode() { return segment.get(JAVA_INT, 8); }
        public PlanLine mode(int it) { segment.set(JAVA_INT, 8, it); return this; }
        /** 1 or 0 */
        public int runs() { return segment.get(JAVA_INT, 12); }
        public PlanLine runs(int it) { segment.set(JAVA_INT, 12, it); return this; }
        /** participants in the last step */
        public long participants() { return segment.get(JAVA_LONG, 16); }
        public PlanLine participants(long it) { segment.set(JAVA_LONG, 16, it); return this; }
        /** participants if nothing were forbidden or forced; of effects within contacts, as `participants` */
        public long wanted() { return segment.get(JAVA_LONG, 24); }
        public PlanLine wanted(long it) { segment.set(JAVA_LONG, 24, it); return this; }
        /** participants of all steps since the world was made, summed */
        public long evaluations() { return segment.get(JAVA_LONG, 32); }
        public PlanLine evaluations(long it) { segment.set(JAVA_LONG, 32, it); return this; }
        /** memory held for it alone */
        public long bytes() { return segment.get(JAVA_LONG, 40); }
        public PlanLine bytes(long it) { segment.set(JAVA_LONG, 40, it); return this; }
        /** s, in the last step */
        public double seconds() { return segment.get(JAVA_DOUBLE, 48); }
        public PlanLine seconds(double it) { segment.set(JAVA_DOUBLE, 48, it); return this; }
        /** CAROM_TIME_* */
        public int timing() { return segment.get(JAVA_INT, 56); }
        public PlanLine timing(int it) { segment.set(JAVA_INT, 56, it); return this; }
        /** as carom_effect_name() */
        public String name() { return segment.getString(64); }
        /** what the participants are: "bodies", "contact points" */
        public String unit() { return segment.getString(96); }
        /** why it runs, or why not */
        public String reason() { return segment.getString(120); }
    }

    /** Documentation and bounds of one parameter; a value outside [min, max] is refused when a shape is made. */
    public static final class Param {
        public static final int SIZE = 32;
        public final MemorySegment segment;
        public Param(Arena arena) { segment = arena.allocate(SIZE, 8); }
        public Param(MemorySegment at) { segment = at; }
        /** "radius" */
        public MemorySegment name() { return segment.get(ADDRESS, 0); }
        public Param name(MemorySegment it) { segment.set(ADDRESS, 0, it); return this; }
        /** "m"; "1" of a number without a dimension. Never empty */
        public MemorySegment unit() { return segment.get(ADDRESS, 8); }
        public Param unit(MemorySegment it) { segment.set(ADDRESS, 8, it); return this; }
        /** smallest legal value, inclusive */
        public double min() { return segment.get(JAVA_DOUBLE, 16); }
        public Param min(double it) { segment.set(JAVA_DOUBLE, 16, it); return this; }
        /** largest legal value, inclusive */
        public double max() { return segment.get(JAVA_DOUBLE, 24); }
        public Param max(double it) { segment.set(JAVA_DOUBLE, 24, it); return this; }
    }

    /** What several parameters fulfil together: the sum of weight[i] * params[param[i]] over its terms is at most `most`.
     *  Parameters that do not are refused when a shape is made (OUT_OF_RANGE, with `text`), and the plugin is not judged by
     *  them. A lens that is thinner than its radius: {"height &lt;= 0.99 radius", 2, {1, 0}, {1, -0.99}, 0}. */
    public static final class ParamRule {
        public static final int SIZE = 72;
        public final MemorySegment segment;
        public ParamRule(Arena arena) { segment = arena.allocate(SIZE, 8); }
        public ParamRule(MemorySegment at) { segment = at; }
        /** for people: "height &lt;= 0.99 radius" */
        public MemorySegment text() { return segment.get(ADDRESS, 0); }
        public ParamRule text(MemorySegment it) { segment.set(ADDRESS, 0, it); return this; }
        /** 1 to 4 */
        public int termCount() { return segment.get(JAVA_INT, 8); }
        public ParamRule termCount(int it) { segment.set(JAVA_INT, 8, it); return this; }
        /** [term_count] indices into params; of a tail, its first group */
        public int[] param() { return segment.asSlice(12, 16).toArray(JAVA_INT); }
        public ParamRule param(int... it) { MemorySegment.copy(it, 0, segment, JAVA_INT, 12, count(it.length, 4)); return this; }
        /** [term_count] finite */
        public double[] weight() { return segment.asSlice(32, 32).toArray(JAVA_DOUBLE); }
        public ParamRule weight(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 32, count(it.length, 4)); return this; }
        /** finite */
        public double most() { return segment.get(JAVA_DOUBLE, 64); }
        public ParamRule most(double it) { segment.set(JAVA_DOUBLE, 64, it); return this; }
    }

    /** What the author knows beyond the support function. Data, not code; verified against the support function when a
     *  shape is made (a false declaration is refused with a witness direction); never trusted. */
    public static final class Geometry {
        public static final int SIZE = 48;
        public final MemorySegment segment;
        public Geometry(Arena arena) { segment = arena.allocate(SIZE, 8); segment.set(JAVA_INT, 0, SIZE); }
        public Geometry(MemorySegment at) { segment = at; }
        /** CAROM_FORM_*: the whole set, core radius included, equals this closed form */
        public int form() { return segment.get(JAVA_INT, 4); }
        public Geometry form(int it) { segment.set(JAVA_INT, 4, it); return this; }
        /** indices into params, as many as the form uses (see CAROM_FORM_*); CAROM_NO_PARAM in the others */
        public int[] formArg() { return segment.asSlice(8, 16).toArray(JAVA_INT); }
        public Geometry formArg(int... it) { MemorySegment.copy(it, 0, segment, JAVA_INT, 8, count(it.length, 4)); return this; }
        /** index into params of the core radius, or CAROM_NO_PARAM: no core radius. With an index, the support function is that of the CORE, and the shape is the core swollen by that radius (a sphere is a point with a radius, a capsule a segment) */
        public int coreRadiusParam() { return segment.get(JAVA_INT, 24); }
        public Geometry coreRadiusParam(int it) { segment.set(JAVA_INT, 24, it); return this; }
        /** CAROM_FORM_*: the shape has its volume, centre and inertia; NONE: derive from support */
        public int massForm() { return segment.get(JAVA_INT, 28); }
        public Geometry massForm(int it) { segment.set(JAVA_INT, 28, it); return this; }
        /** indices into params for mass_form */
        public int[] massArg() { return segment.asSlice(32, 16).toArray(JAVA_INT); }
        public Geometry massArg(int... it) { MemorySegment.copy(it, 0, segment, JAVA_INT, 32, count(it.length, 4)); return this; }
    }

    /** The plugin. Export it as
     *      const carom_shape_plugin carom_shape_plugin_v1 = { ... };
     *  or pass it to carom_plugin_register(). Everything it points to must live as long as the engine. */
    public static final class ShapePlugin {
        public static final int SIZE = 96;
        public final MemorySegment segment;
        public ShapePlugin(Arena arena) { segment = arena.allocate(SIZE, 8); segment.set(JAVA_INT, 0, SIZE); }
        public ShapePlugin(MemorySegment at) { segment = at; }
        /** CAROM_PLUGIN_ABI_MAJOR */
        public int abiMajor() { return segment.get(JAVA_INT, 4); }
        public ShapePlugin abiMajor(int it) { segment.set(JAVA_INT, 4, it); return this; }
        /** CAROM_PLUGIN_ABI_MINOR */
        public int abiMinor() { return segment.get(JAVA_INT, 8); }
        public ShapePlugin abiMinor(int it) { segment.set(JAVA_INT, 8, it); return this; }
        /** CAROM_PLUGIN_HOST_THREAD or 0 */
        public int flags() { return segment.get(JAVA_INT, 12); }
        public ShapePlugin flags(int it) { segment.set(JAVA_INT, 12, it); return this; }
        /** unique, reverse-domain or short: "carom.sphere" */
        public MemorySegment id() { return segment.get(ADDRESS, 16); }
        public ShapePlugin id(MemorySegment it) { segment.set(ADDRESS, 16, it); return this; }
        /** of the shape's meaning: raise it when the same params give another set */
        public int version() { return segment.get(JAVA_INT, 24); }
        public ShapePlugin version(int it) { segment.set(JAVA_INT, 24, it); return this; }
        /** number of entries in params; the parameters every shape of this kind has */
        public int paramCount() { return segment.get(JAVA_INT, 28); }
        public ShapePlugin paramCount(int it) { segment.set(JAVA_INT, 28, it); return this; }
        /** [param_count] */
        public MemorySegment params() { return segment.get(ADDRESS, 32); }
        public ShapePlugin params(MemorySegment it) { segment.set(ADDRESS, 32, it); return this; }
        /** optional declarations, or NULL */
        public MemorySegment geometry() { return segment.get(ADDRESS, 40); }
        public ShapePlugin geometry(MemorySegment it) { segment.set(ADDRESS, 40, it); return this; }
        /** the only code */
        public MemorySegment support() { return segment.get(ADDRESS, 48); }
        public ShapePlugin support(MemorySegment it) { segment.set(ADDRESS, 48, it); return this; }
        /** 0: exactly param_count parameters. k &gt; 0: the last k entries repeat, so a shape has param_count + m*k parameters, m &gt;= 0 (hull: x, y, z repeated) */
        public int paramTailGroup() { return segment.get(JAVA_INT, 56); }
        public ShapePlugin paramTailGroup(int it) { segment.set(JAVA_INT, 56, it); return this; }
        /** smallest number of groups in all, the declared one included (hull: 1) */
        public int paramTailMin() { return segment.get(JAVA_INT, 60); }
        public ShapePlugin paramTailMin(int it) { segment.set(JAVA_INT, 60, it); return this; }
        /** [rule_count] or NULL */
        public MemorySegment rules() { return segment.get(ADDRESS, 64); }
        public ShapePlugin rules(MemorySegment it) { segment.set(ADDRESS, 64, it); return this; }
        /** at most 64 */
        public int ruleCount() { return segment.get(JAVA_INT, 72); }
        public ShapePlugin ruleCount(int it) { segment.set(JAVA_INT, 72, it); return this; }
        /** handed to support: what a closure of the host holds, or NULL. The function must stay pure: same point for the same user, params and dir, as long as the plugin is there */
        public MemorySegment user() { return segment.get(ADDRESS, 80); }
        public ShapePlugin user(MemorySegment it) { segment.set(ADDRESS, 80, it); return this; }
        /** `support_text` of CAROM_SUPPORT_TEXT(), zero-terminated; NULL: devices cannot ask the shape */
        public MemorySegment text() { return segment.get(ADDRESS, 88); }
        public ShapePlugin text(MemorySegment it) { segment.set(ADDRESS, 88, it); return this; }
    }

    /** Settings of a query; fill with carom_distance_desc_init(). Values as the dials of the same name. */
    public static final class DistanceDesc {
        public static final int SIZE = 40;
        public final MemorySegment segment;
        public DistanceDesc(Arena arena) { segment = arena.allocate(SIZE, 8); carom_distance_desc_init(segment, SIZE); }
        public DistanceDesc(MemorySegment at) { segment = at; }
        /** CAROM_SIMPLEX_*, default VORONOI_LAST */
        public int simplex() { return segment.get(JAVA_INT, 4); }
        public DistanceDesc simplex(int it) { segment.set(JAVA_INT, 4, it); return this; }
        /** CAROM_NARROW_*, default GJK_EPA */
        public int narrowPhase() { return segment.get(JAVA_INT, 8); }
        public DistanceDesc narrowPhase(int it) { segment.set(JAVA_INT, 8, it); return this; }
        /** 0: always the generic path; 1: a specific routine where there is one; default 0 */
        public int pairRoutines() { return segment.get(JAVA_INT, 12); }
        public DistanceDesc pairRoutines(int it) { segment.set(JAVA_INT, 12, it); return this; }
        /** relative width of the bracket, default 1e-6 */
        public double tolerance() { return segment.get(JAVA_DOUBLE, 16); }
        public DistanceDesc tolerance(double it) { segment.set(JAVA_DOUBLE, 16, it); return this; }
        /** m, for CAROM_NARROW_HYBRID */
        public double hybridMargin() { return segment.get(JAVA_DOUBLE, 24); }
        public DistanceDesc hybridMargin(double it) { segment.set(JAVA_DOUBLE, 24, it); return this; }
        /** cap, default 128 */
        public int gjkIterations() { return segment.get(JAVA_INT, 32); }
        public DistanceDesc gjkIterations(int it) { segment.set(JAVA_INT, 32, it); return this; }
        /** cap, default 256 */
        public int epaIterations() { return segment.get(JAVA_INT, 36); }
        public DistanceDesc epaIterations(int it) { segment.set(JAVA_INT, 36, it); return this; }
    }

    /** The result: signed distance (negative: depth of the smallest separating translation) and its bracket. */
    public static final class Distance {
        public static final int SIZE = 120;
        public final MemorySegment segment;
        public Distance(Arena arena) { segment = arena.allocate(SIZE, 8); segment.set(JAVA_INT, 0, SIZE); }
        public Distance(MemorySegment at) { segment = at; }
        /** CAROM_QUERY_* */
        public int status() { return segment.get(JAVA_INT, 4); }
        public Distance status(int it) { segment.set(JAVA_INT, 4, it); return this; }
        /** m */
        public double separation() { return segment.get(JAVA_DOUBLE, 8); }
        public Distance separation(double it) { segment.set(JAVA_DOUBLE, 8, it); return this; }
        /** m, separation &gt;= lower */
        public double lower() { return segment.get(JAVA_DOUBLE, 16); }
        public Distance lower(double it) { segment.set(JAVA_DOUBLE, 16, it); return this; }
        /** m, separation &lt;= upper */
        public double upper() { return segment.get(JAVA_DOUBLE, 24); }
        public Distance upper(double it) { segment.set(JAVA_DOUBLE, 24, it); return this; }
        /** unit, world, from A to B */
        public double[] normal() { return segment.asSlice(32, 24).toArray(JAVA_DOUBLE); }
        public Distance normal(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 32, count(it.length, 3)); return this; }
        /** m, world, on the surface of A */
        public double[] pointA() { return segment.asSlice(56, 24).toArray(JAVA_DOUBLE); }
        public Distance pointA(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 56, count(it.length, 3)); return this; }
        /** m, world, on the surface of B */
        public double[] pointB() { return segment.asSlice(80, 24).toArray(JAVA_DOUBLE); }
        public Distance pointB(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 80, count(it.length, 3)); return this; }
        /** taken by GJK */
        public int gjkIterations() { return segment.get(JAVA_INT, 104); }
        public Distance gjkIterations(int it) { segment.set(JAVA_INT, 104, it); return this; }
        /** taken by EPA, of shapes that overlap */
        public int epaIterations() { return segment.get(JAVA_INT, 108); }
        public Distance epaIterations(int it) { segment.set(JAVA_INT, 108, it); return this; }
        /** single calls, A and B together */
        public int supportCalls() { return segment.get(JAVA_INT, 112); }
        public Distance supportCalls(int it) { segment.set(JAVA_INT, 112, it); return this; }
    }

    /** What of a world is not as a snapshot says. */
    public static final class Difference {
        public static final int SIZE = 264;
        public final MemorySegment segment;
        public Difference(Arena arena) { segment = arena.allocate(SIZE, 8); segment.set(JAVA_INT, 0, SIZE); }
        public Difference(MemorySegment at) { segment = at; }
        /** 0: it is the same, to the bit */
        public int differs() { return segment.get(JAVA_INT, 4); }
        public Difference differs(int it) { segment.set(JAVA_INT, 4, it); return this; }
        /** the body, joint, ... that differs first; of a pair the one collider; 0: none in particular */
        public long first() { return segment.get(JAVA_LONG, 8); }
        public Difference first(long it) { segment.set(JAVA_LONG, 8, it); return this; }
        /** of a pair the other collider; else 0 */
        public long second() { return segment.get(JAVA_LONG, 16); }
        public Difference second(long it) { segment.set(JAVA_LONG, 16, it); return this; }
        /** what differs, most telling first: "bodies, pairs, dials"; zero-terminated */
        public String sections() { return segment.getString(24); }
    }

    /** What is left undone. Contacts are those of the last step, with the velocities that it ended with; joints and energy
     *  are those of the present poses and velocities. Violations of Coulomb's law are in m/s: by how much the velocity at
     *  the worst contact would have to be another for its impulse to be right. */
    public static final class Residuals {
        public static final int SIZE = 96;
        public final MemorySegment segment;
        public Residuals(Arena arena) { segment = arena.allocate(SIZE, 8); segment.set(JAVA_INT, 0, SIZE); }
        public Residuals(MemorySegment at) { segment = at; }
        /** 1: energy_drift is known, see carom_world_enable_ledger() */
        public int ledgerIsKept() { return segment.get(JAVA_INT, 4); }
        public Residuals ledgerIsKept(int it) { segment.set(JAVA_INT, 4, it); return this; }
        /** of the last step */
        public long contactPoints() { return segment.get(JAVA_LONG, 8); }
        public Residuals contactPoints(long it) { segment.set(JAVA_LONG, 8, it); return this; }
        /** that are attached to a body that is awake, and are not broken */
        public long joints() { return segment.get(JAVA_LONG, 16); }
        public Residuals joints(long it) { segment.set(JAVA_LONG, 16, it); return this; }
        /** m, 0 if none */
        public double maxPenetration() { return segment.get(JAVA_DOUBLE, 24); }
        public Residuals maxPenetration(double it) { segment.set(JAVA_DOUBLE, 24, it); return this; }
        /** m, over points that overlap */
        public double meanPenetration() { return segment.get(JAVA_DOUBLE, 32); }
        public Residuals meanPenetration(double it) { segment.set(JAVA_DOUBLE, 32, it); return this; }
        /** m, most that what a joint locks of its points is apart */
        public double jointGap() { return segment.get(JAVA_DOUBLE, 40); }
        public Residuals jointGap(double it) { segment.set(JAVA_DOUBLE, 40, it); return this; }
        /** rad, likewise of its axes */
        public double jointAngle() { return segment.get(JAVA_DOUBLE, 48); }
        public Residuals jointAngle(double it) { segment.set(JAVA_DOUBLE, 48, it); return this; }
        /** m/s: a contact that approaches, or pushes while separating, bounces excluded */
        public double complementarity() { return segment.get(JAVA_DOUBLE, 56); }
        public Residuals complementarity(double it) { segment.set(JAVA_DOUBLE, 56, it); return this; }
        /** m/s: friction larger than its coefficient times the load, of a pair */
        public double cone() { return segment.get(JAVA_DOUBLE, 64); }
        public Residuals cone(double it) { segment.set(JAVA_DOUBLE, 64, it); return this; }
        /** m/s: friction that is not against the slip, or a pair that slips with friction to spare */
        public double slip() { return segment.get(JAVA_DOUBLE, 72); }
        public Residuals slip(double it) { segment.set(JAVA_DOUBLE, 72, it); return this; }
        /** J, kinetic and of uniform gravity, of bodies and particles */
        public double energy() { return segment.get(JAVA_DOUBLE, 80); }
        public Residuals energy(double it) { segment.set(JAVA_DOUBLE, 80, it); return this; }
        /** J, in the last step, that nothing accounts for: the ledger's integrator and unassigned; 0 without a ledger */
        public double energyDrift() { return segment.get(JAVA_DOUBLE, 88); }
        public Residuals energyDrift(double it) { segment.set(JAVA_DOUBLE, 88, it); return this; }
    }

    /** A triangle mesh. Corners at the same place are made one, so vertices may be repeated; triangles without area are
     *  dropped (carom_scenery_info counts them). Two triangles that share a side are one surface there; a side of one alone
     *  is a boundary edge, and so is a side of three. Fill with carom_mesh_desc_init(). */
    public static final class MeshDesc {
        public static final int SIZE = 40;
        public final MemorySegment segment;
        public MeshDesc(Arena arena) { segment = arena.allocate(SIZE, 8); carom_mesh_desc_init(segment, SIZE); }
        public MeshDesc(MemorySegment at) { segment = at; }
        /** CAROM_SCENERY_* bits, default 0 */
        public int flags() { return segment.get(JAVA_INT, 4); }
        public MeshDesc flags(int it) { segment.set(JAVA_INT, 4, it); return this; }
        /** [3 vertex_count] m, shape frame; within 1e8 of the origin */
        public MemorySegment vertices() { return segment.get(ADDRESS, 8); }
        public MeshDesc vertices(MemorySegment it) { segment.set(ADDRESS, 8, it); return this; }
        /** at least 3 */
        public long vertexCount() { return segment.get(JAVA_LONG, 16); }
        public MeshDesc vertexCount(long it) { segment.set(JAVA_LONG, 16, it); return this; }
        /** [3 triangle_count] indices of vertices, counter-clockwise seen from outside */
        public MemorySegment triangles() { return segment.get(ADDRESS, 24); }
        public MeshDesc triangles(MemorySegment it) { segment.set(ADDRESS, 24, it); return this; }
        /** 1 to 2^28 */
        public long triangleCount() { return segment.get(JAVA_LONG, 32); }
        public MeshDesc triangleCount(long it) { segment.set(JAVA_LONG, 32, it); return this; }
    }

    /** A height field: vertices at (column spacing[0], height, row spacing[1]) in the shape's frame, met from above (+y).
     *  Each cell is two triangles, divided from its first corner (column, row) to (column + 1, row + 1). What has its
     *  middle in the ground, by no more than its bounding radius, is lifted out. Fill with carom_height_field_desc_init(). */
    public static final class HeightFieldDesc {
        public static final int SIZE = 40;
        public final MemorySegment segment;
        public HeightFieldDesc(Arena arena) { segment = arena.allocate(SIZE, 8); carom_height_field_desc_init(segment, SIZE); }
        public HeightFieldDesc(MemorySegment at) { segment = at; }
        /** 0 */
        public int flags() { return segment.get(JAVA_INT, 4); }
        public HeightFieldDesc flags(int it) { segment.set(JAVA_INT, 4, it); return this; }
        /** along x, 2 to 2^14 */
        public int columns() { return segment.get(JAVA_INT, 8); }
        public HeightFieldDesc columns(int it) { segment.set(JAVA_INT, 8, it); return this; }
        /** along z, 2 to 2^14 */
        public int rows() { return segment.get(JAVA_INT, 12); }
        public HeightFieldDesc rows(int it) { segment.set(JAVA_INT, 12, it); return this; }
        /** [rows][columns] m; NaN: no vertex, the cells around it are a hole */
        public MemorySegment heights() { return segment.get(ADDRESS, 16); }
        public HeightFieldDesc heights(MemorySegment it) { segment.set(ADDRESS, 16, it); return this; }
        /** m, along x and z, default 1 */
        public double[] spacing() { return segment.asSlice(24, 16).toArray(JAVA_DOUBLE); }
        public HeightFieldDesc spacing(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 24, count(it.length, 2)); return this; }
    }

    /** Counts of a surface: what the engine keeps of the arrays that made it. */
    public static final class SceneryInfo {
        public static final int SIZE = 48;
        public final MemorySegment segment;
        public SceneryInfo(Arena arena) { segment = arena.allocate(SIZE, 8); segment.set(JAVA_INT, 0, SIZE); }
        public SceneryInfo(MemorySegment at) { segment = at; }
        /** CAROM_SCENERY_* bits, as given */
        public int flags() { return segment.get(JAVA_INT, 4); }
        public SceneryInfo flags(int it) { segment.set(JAVA_INT, 4, it); return this; }
        /** how many there are: their indices run from 0 to `triangles - 1`. Of a mesh those that are left: triangle_count - dropped. Of a height field 2 (columns - 1) (rows - 1): the two triangles of a cell count whether they are there or a hole */
        public long triangles() { return segment.get(JAVA_LONG, 8); }
        public SceneryInfo triangles(long it) { segment.set(JAVA_LONG, 8, it); return this; }
        /** of a mesh: vertices after equal ones were made one; of a height field columns rows, NaN ones included */
        public long vertices() { return segment.get(JAVA_LONG, 16); }
        public SceneryInfo vertices(long it) { segment.set(JAVA_LONG, 16, it); return this; }
        /** triangles of the mesh that were left out, because they have no area (least height below 1e-12 of the longest side); 0 for a height field */
        public long dropped() { return segment.get(JAVA_LONG, 24); }
        public SceneryInfo dropped(long it) { segment.set(JAVA_LONG, 24, it); return this; }
        /** sides of a triangle with no triangle beyond. 0 for a closed surface. Many in a surface that should be closed: its triangles do not share corners, and bodies will feel the gaps */
        public long boundaryEdges() { return segment.get(JAVA_LONG, 32); }
        public SceneryInfo boundaryEdges(long it) { segment.set(JAVA_LONG, 32, it); return this; }
        /** of memory, about */
        public long bytes() { return segment.get(JAVA_LONG, 40); }
        public SceneryInfo bytes(long it) { segment.set(JAVA_LONG, 40, it); return this; }
    }

    /** What the engine knows of a shape. Quantities are for unit density (1 kg/m^3) in the shape's own frame; each derived
     *  one comes with a rigorous bracket. A half-space has infinite bounds and volume 0. */
    public static final class ShapeInfo {
        public static final int SIZE = 240;
        public final MemorySegment segment;
        public ShapeInfo(Arena arena) { segment = arena.allocate(SIZE, 8); segment.set(JAVA_INT, 0, SIZE); }
        public ShapeInfo(MemorySegment at) { segment = at; }
        /** CAROM_FORM_*, verified; NONE for a general convex set and the half-space */
        public int form() { return segment.get(JAVA_INT, 4); }
        public ShapeInfo form(int it) { segment.set(JAVA_INT, 4, it); return this; }
        /** 1: the built-in half-space */
        public int isHalfSpace() { return segment.get(JAVA_INT, 8); }
        public ShapeInfo isHalfSpace(int it) { segment.set(JAVA_INT, 8, it); return this; }
        /** 1: mass properties come from a verified closed form, brackets have zero width */
        public int massExact() { return segment.get(JAVA_INT, 12); }
        public ShapeInfo massExact(int it) { segment.set(JAVA_INT, 12, it); return this; }
        /** CAROM_NULL_HANDLE for the half-space */
        public long plugin() { return segment.get(JAVA_LONG, 16); }
        public ShapeInfo plugin(long it) { segment.set(JAVA_LONG, 16, it); return this; }
        /** as carom_shape_get_params() gives it */
        public long paramCount() { return segment.get(JAVA_LONG, 24); }
        public ShapeInfo paramCount(long it) { segment.set(JAVA_LONG, 24, it); return this; }
        /** m */
        public double coreRadius() { return segment.get(JAVA_DOUBLE, 32); }
        public ShapeInfo coreRadius(double it) { segment.set(JAVA_DOUBLE, 32, it); return this; }
        /** m, about the shape's origin */
        public double boundingRadius() { return segment.get(JAVA_DOUBLE, 40); }
        public ShapeInfo boundingRadius(double it) { segment.set(JAVA_DOUBLE, 40, it); return this; }
        /** m, exact to rounding */
        public double[] aabbMin() { return segment.asSlice(48, 24).toArray(JAVA_DOUBLE); }
        public ShapeInfo aabbMin(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 48, count(it.length, 3)); return this; }
        /** m */
        public double[] aabbMax() { return segment.asSlice(72, 24).toArray(JAVA_DOUBLE); }
        public ShapeInfo aabbMax(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 72, count(it.length, 3)); return this; }
        /** m^3, best estimate, within [volume_min, volume_max] */
        public double volume() { return segment.get(JAVA_DOUBLE, 96); }
        public ShapeInfo volume(double it) { segment.set(JAVA_DOUBLE, 96, it); return this; }
        /** m^3, lower bound */
        public double volumeMin() { return segment.get(JAVA_DOUBLE, 104); }
        public ShapeInfo volumeMin(double it) { segment.set(JAVA_DOUBLE, 104, it); return this; }
        /** m^3, upper bound */
        public double volumeMax() { return segment.get(JAVA_DOUBLE, 112); }
        public ShapeInfo volumeMax(double it) { segment.set(JAVA_DOUBLE, 112, it); return this; }
        /** m */
        public double[] centroid() { return segment.asSlice(120, 24).toArray(JAVA_DOUBLE); }
        public ShapeInfo centroid(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 120, count(it.length, 3)); return this; }
        /** m, upper bound of |error| */
        public double centroidError() { return segment.get(JAVA_DOUBLE, 144); }
        public ShapeInfo centroidError(double it) { segment.set(JAVA_DOUBLE, 144, it); return this; }
        /** m^5, about the centroid, row-major, symmetric */
        public double[] inertia() { return segment.asSlice(152, 72).toArray(JAVA_DOUBLE); }
        public ShapeInfo inertia(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 152, count(it.length, 9)); return this; }
        /** m^5, upper bound of the spectral norm of the error */
        public double inertiaError() { return segment.get(JAVA_DOUBLE, 224); }
        public ShapeInfo inertiaError(double it) { segment.set(JAVA_DOUBLE, 224, it); return this; }
        /** 1: a mesh or a height field (scenery.h); it has no volume */
        public int isScenery() { return segment.get(JAVA_INT, 232); }
        public ShapeInfo isScenery(int it) { segment.set(JAVA_INT, 232, it); return this; }
    }

    /** What a number of a tree stands for. */
    public static final class TreeCoordinate {
        public static final int SIZE = 24;
        public final MemorySegment segment;
        public TreeCoordinate(Arena arena) { segment = arena.allocate(SIZE, 8); }
        public TreeCoordinate(MemorySegment at) { segment = at; }
        /** or CAROM_NULL_HANDLE: of the base */
        public long joint() { return segment.get(JAVA_LONG, 0); }
        public TreeCoordinate joint(long it) { segment.set(JAVA_LONG, 0, it); return this; }
        /** that it moves: the base, or the body that the joint holds to the rest */
        public long body() { return segment.get(JAVA_LONG, 8); }
        public TreeCoordinate body(long it) { segment.set(JAVA_LONG, 8, it); return this; }
        /** CAROM_AXIS_*; of a base X, Y, Z, TURN_X, TURN_Y, TURN_Z of the world */
        public int axis() { return segment.get(JAVA_INT, 16); }
        public TreeCoordinate axis(int it) { segment.set(JAVA_INT, 16, it); return this; }
    }

    /** Chassis, engine and gears. Fill with carom_vehicle_desc_init(): a car of 1.2 t, whose chassis the host names. */
    public static final class VehicleDesc {
        public static final int SIZE = 368;
        public final MemorySegment segment;
        public VehicleDesc(Arena arena) { segment = arena.allocate(SIZE, 8); carom_vehicle_desc_init(segment, SIZE); }
        public VehicleDesc(MemorySegment at) { segment = at; }
        /** CAROM_VEHICLE_* bits, default AUTOMATIC and ACKERMANN */
        public int flags() { return segment.get(JAVA_INT, 4); }
        public VehicleDesc flags(int it) { segment.set(JAVA_INT, 4, it); return this; }
        /** dynamic. Its own gravity and mass count */
        public long chassis() { return segment.get(JAVA_LONG, 8); }
        public VehicleDesc chassis(long it) { segment.set(JAVA_LONG, 8, it); return this; }
        /** unit, body frame, default (0, 1, 0): wheels look along -up */
        public double[] up() { return segment.asSlice(16, 24).toArray(JAVA_DOUBLE); }
        public VehicleDesc up(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 16, count(it.length, 3)); return this; }
        /** unit, body frame, at right angles to up within 1e-6, default (0, 0, 1) */
        public double[] forward() { return segment.asSlice(40, 24).toArray(JAVA_DOUBLE); }
        public VehicleDesc forward(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 40, count(it.length, 3)); return this; }
        /** of wheels' queries, default all bits: as carom_query_desc.category */
        public long category() { return segment.get(JAVA_LONG, 64); }
        public VehicleDesc category(long it) { segment.set(JAVA_LONG, 64, it); return this; }
        /** default all bits: as carom_query_desc.mask */
        public long mask() { return segment.get(JAVA_LONG, 72); }
        public VehicleDesc mask(long it) { segment.set(JAVA_LONG, 72, it); return this; }
        /** points of the torque curve, 1 to 8, default 4 */
        public int torqueCount() { return segment.get(JAVA_INT, 80); }
        public VehicleDesc torqueCount(int it) { segment.set(JAVA_INT, 80, it); return this; }
        /** forward gears, 1 to 8, default 5 */
        public int gearCount() { return segment.get(JAVA_INT, 84); }
        public VehicleDesc gearCount(int it) { segment.set(JAVA_INT, 84, it); return this; }
        /** [torque_count] rad/s, [0, 1e5], rising: beyond the ends the torque is that of the end */
        public double[] torqueSpeeds() { return segment.asSlice(88, 64).toArray(JAVA_DOUBLE); }
        public VehicleDesc torqueSpeeds(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 88, count(it.length, 8)); return this; }
        /** [torque_count] N m, [0, 1e7]: of the engine at full throttle, linear in between */
        public double[] torques() { return segment.asSlice(152, 64).toArray(JAVA_DOUBLE); }
        public VehicleDesc torques(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 152, count(it.length, 8)); return this; }
        /** rad/s, [1, 1e5], default 90: the engine keeps it by itself */
        public double idleSpeed() { return segment.get(JAVA_DOUBLE, 216); }
        public VehicleDesc idleSpeed(double it) { segment.set(JAVA_DOUBLE, 216, it); return this; }
        /** rad/s, above idle_speed, at most 1e5, default 680: at it the engine gives no torque */
        public double maxSpeed() { return segment.get(JAVA_DOUBLE, 224); }
        public VehicleDesc maxSpeed(double it) { segment.set(JAVA_DOUBLE, 224, it); return this; }
        /** kg m^2, [1e-3, 1e6], default 0.25 */
        public double engineInertia() { return segment.get(JAVA_DOUBLE, 232); }
        public VehicleDesc engineInertia(double it) { segment.set(JAVA_DOUBLE, 232, it); return this; }
        /** N m, [0, 1e7], default 25: brakes the engine where the throttle is shut */
        public double engineDrag() { return segment.get(JAVA_DOUBLE, 240); }
        public VehicleDesc engineDrag(double it) { segment.set(JAVA_DOUBLE, 240, it); return this; }
        /** [gear_count] [1e-3, 1e3], default 3.5, 2.1, 1.4, 1.05, 0.85: turns of the engine for one of the final drive */
        public double[] gears() { return segment.asSlice(248, 64).toArray(JAVA_DOUBLE); }
        public VehicleDesc gears(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 248, count(it.length, 8)); return this; }
        /** [1e-3, 1e3], default 3.3: likewise */
        public double reverse() { return segment.get(JAVA_DOUBLE, 312); }
        public VehicleDesc reverse(double it) { segment.set(JAVA_DOUBLE, 312, it); return this; }
        /** [1e-3, 1e3], default 3.7 */
        public double finalDrive() { return segment.get(JAVA_DOUBLE, 320); }
        public VehicleDesc finalDrive(double it) { segment.set(JAVA_DOUBLE, 320, it); return this; }
        /** N m, [0, 1e7], default 600: the most that the clutch takes */
        public double clutchTorque() { return segment.get(JAVA_DOUBLE, 328); }
        public VehicleDesc clutchTorque(double it) { segment.set(JAVA_DOUBLE, 328, it); return this; }
        /** rad/s, [0, 1e5], default 600: AUTOMATIC takes the next gear above it */
        public double shiftUp() { return segment.get(JAVA_DOUBLE, 336); }
        public VehicleDesc shiftUp(double it) { segment.set(JAVA_DOUBLE, 336, it); return this; }
        /** rad/s, [0, 1e5], default 220: and the one before below it */
        public double shiftDown() { return segment.get(JAVA_DOUBLE, 344); }
        public VehicleDesc shiftDown(double it) { segment.set(JAVA_DOUBLE, 344, it); return this; }
        /** s, [0, 10], default 0.2: the clutch is open for so long */
        public double shiftTime() { return segment.get(JAVA_DOUBLE, 352); }
        public VehicleDesc shiftTime(double it) { segment.set(JAVA_DOUBLE, 352, it); return this; }
        /** N m, [0, 1e7], default 0: the most by which the differential holds driven wheels together */
        public double limitedSlip() { return segment.get(JAVA_DOUBLE, 360); }
        public VehicleDesc limitedSlip(double it) { segment.set(JAVA_DOUBLE, 360, it); return this; }
    }

    /** One wheel: its place, spring, tyre, and what of engine, brakes and steering reaches it. Fill with
     *  carom_wheel_desc_init(). */
    public static final class WheelDesc {
        public static final int SIZE = 192;
        public final MemorySegment segment;
        public WheelDesc(Arena arena) { segment = arena.allocate(SIZE, 8); carom_wheel_desc_init(segment, SIZE); }
        public WheelDesc(MemorySegment at) { segment = at; }
        /** index of the wheel at the other end of its anti-roll bar, default CAROM_NO_WHEEL */
        public int antiRollPartner() { return segment.get(JAVA_INT, 4); }
        public WheelDesc antiRollPartner(int it) { segment.set(JAVA_INT, 4, it); return this; }
        /** convex, looks down in place of a ray, its origin at the wheel's centre; default none */
        public long shape() { return segment.get(JAVA_LONG, 8); }
        public WheelDesc shape(long it) { segment.set(JAVA_LONG, 8, it); return this; }
        /** m, body frame: of its centre with the spring at rest, nothing under it */
        public double[] position() { return segment.asSlice(16, 24).toArray(JAVA_DOUBLE); }
        public WheelDesc position(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 16, count(it.length, 3)); return this; }
        /** m, [1e-3, 1e3], default 0.33 */
        public double radius() { return segment.get(JAVA_DOUBLE, 40); }
        public WheelDesc radius(double it) { segment.set(JAVA_DOUBLE, 40, it); return this; }
        /** kg m^2, [1e-9, 1e6], default 1: about its axle */
        public double inertia() { return segment.get(JAVA_DOUBLE, 48); }
        public WheelDesc inertia(double it) { segment.set(JAVA_DOUBLE, 48, it); return this; }
        /** m, [1e-3, 1e3], default 0.25: up to the bump stop, which is a spring 10 times as stiff */
        public double travel() { return segment.get(JAVA_DOUBLE, 56); }
        public WheelDesc travel(double it) { segment.set(JAVA_DOUBLE, 56, it); return this; }
        /** N/m, [0, 1e9], default 30000 */
        public double stiffness() { return segment.get(JAVA_DOUBLE, 64); }
        public WheelDesc stiffness(double it) { segment.set(JAVA_DOUBLE, 64, it); return this; }
        /** N s/m, [0, 1e8], default 2500: as the spring is pressed */
        public double dampingBump() { return segment.get(JAVA_DOUBLE, 72); }
        public WheelDesc dampingBump(double it) { segment.set(JAVA_DOUBLE, 72, it); return this; }
        /** N s/m, [0, 1e8], default 3500: as it comes back */
        public double dampingRebound() { return segment.get(JAVA_DOUBLE, 80); }
        public WheelDesc dampingRebound(double it) { segment.set(JAVA_DOUBLE, 80, it); return this; }
        /** N/m, [0, 1e9], default 0: force on both ends by the difference of their compressions. One end of a bar says it */
        public double antiRoll() { return segment.get(JAVA_DOUBLE, 88); }
        public WheelDesc antiRoll(double it) { segment.set(JAVA_DOUBLE, 88, it); return this; }
        /** rad, [-1.5, 1.5], default 0: at steer 1, to the left */
        public double maxSteer() { return segment.get(JAVA_DOUBLE, 96); }
        public WheelDesc maxSteer(double it) { segment.set(JAVA_DOUBLE, 96, it); return this; }
        /** [0, 1e3], default 0: share of the engine's torque, relative to the other wheels */
        public double drive() { return segment.get(JAVA_DOUBLE, 104); }
        public WheelDesc drive(double it) { segment.set(JAVA_DOUBLE, 104, it); return this; }
        /** N m, [0, 1e7], default 2000: torque of the full brake */
        public double brake() { return segment.get(JAVA_DOUBLE, 112); }
        public WheelDesc brake(double it) { segment.set(JAVA_DOUBLE, 112, it); return this; }
        /** N m, [0, 1e7], default 0: likewise */
        public double handbrake() { return segment.get(JAVA_DOUBLE, 120); }
        public WheelDesc handbrake(double it) { segment.set(JAVA_DOUBLE, 120, it); return this; }
        /** [0, 1], default 0.012: rolling resistance over load */
        public double rolling() { return segment.get(JAVA_DOUBLE, 128); }
        public WheelDesc rolling(double it) { segment.set(JAVA_DOUBLE, 128, it); return this; }
        /** [0, 10], default 1: the most friction over load, along the wheel */
        public double grip() { return segment.get(JAVA_DOUBLE, 136); }
        public WheelDesc grip(double it) { segment.set(JAVA_DOUBLE, 136, it); return this; }
        /** [0, 10], default 1: likewise across it */
        public double sideGrip() { return segment.get(JAVA_DOUBLE, 144); }
        public WheelDesc sideGrip(double it) { segment.set(JAVA_DOUBLE, 144, it); return this; }
        /** [1e-3, 1], default 0.1: slip along the wheel at which grip is largest */
        public double peakSlip() { return segment.get(JAVA_DOUBLE, 152); }
        public WheelDesc peakSlip(double it) { segment.set(JAVA_DOUBLE, 152, it); return this; }
        /** [1e-3, 1], default 0.12: tangent of the slip angle at which side grip is largest */
        public double sidePeakSlip() { return segment.get(JAVA_DOUBLE, 160); }
        public WheelDesc sidePeakSlip(double it) { segment.set(JAVA_DOUBLE, 160, it); return this; }
        /** [0, 1], default 0.8: friction of a tyre that slides, over the most */
        public double slide() { return segment.get(JAVA_DOUBLE, 168); }
        public WheelDesc slide(double it) { segment.set(JAVA_DOUBLE, 168, it); return this; }
        /** [1.01, 100], default 4: from so many times the peak on it slides */
        public double slideSlip() { return segment.get(JAVA_DOUBLE, 176); }
        public WheelDesc slideSlip(double it) { segment.set(JAVA_DOUBLE, 176, it); return this; }
        /** m, [0.01, 10], default 0.3: way in which a tyre builds up its force */
        public double relaxation() { return segment.get(JAVA_DOUBLE, 184); }
        public WheelDesc relaxation(double it) { segment.set(JAVA_DOUBLE, 184, it); return this; }
    }

    /** What a driver does. Fill with carom_vehicle_input_init(): nothing, in gear 1. */
    public static final class VehicleInput {
        public static final int SIZE = 40;
        public final MemorySegment segment;
        public VehicleInput(Arena arena) { segment = arena.allocate(SIZE, 8); carom_vehicle_input_init(segment, SIZE); }
        public VehicleInput(MemorySegment at) { segment = at; }
        /** forward gear, 0: neutral, -1: reverse. AUTOMATIC takes any above 0 as forward */
        public int gear() { return segment.get(JAVA_INT, 4); }
        public VehicleInput gear(int it) { segment.set(JAVA_INT, 4, it); return this; }
        /** [0, 1] */
        public double throttle() { return segment.get(JAVA_DOUBLE, 8); }
        public VehicleInput throttle(double it) { segment.set(JAVA_DOUBLE, 8, it); return this; }
        /** [0, 1] */
        public double brake() { return segment.get(JAVA_DOUBLE, 16); }
        public VehicleInput brake(double it) { segment.set(JAVA_DOUBLE, 16, it); return this; }
        /** [0, 1] */
        public double handbrake() { return segment.get(JAVA_DOUBLE, 24); }
        public VehicleInput handbrake(double it) { segment.set(JAVA_DOUBLE, 24, it); return this; }
        /** [-1, 1], 1: to the left as far as wheels go */
        public double steer() { return segment.get(JAVA_DOUBLE, 32); }
        public VehicleInput steer(double it) { segment.set(JAVA_DOUBLE, 32, it); return this; }
    }

    /** State of engine and gears. Fill with carom_vehicle_init(). */
    public static final class Vehicle {
        public static final int SIZE = 40;
        public final MemorySegment segment;
        public Vehicle(Arena arena) { segment = arena.allocate(SIZE, 8); carom_vehicle_init(segment, SIZE); }
        public Vehicle(MemorySegment at) { segment = at; }
        /** that is in, or that is being put in */
        public int gear() { return segment.get(JAVA_INT, 4); }
        public Vehicle gear(int it) { segment.set(JAVA_INT, 4, it); return this; }
        /** rad/s */
        public double engineSpeed() { return segment.get(JAVA_DOUBLE, 8); }
        public Vehicle engineSpeed(double it) { segment.set(JAVA_DOUBLE, 8, it); return this; }
        /** s, until the clutch closes again */
        public double shifting() { return segment.get(JAVA_DOUBLE, 16); }
        public Vehicle shifting(double it) { segment.set(JAVA_DOUBLE, 16, it); return this; }
        /** s, since then */
        public double sinceShift() { return segment.get(JAVA_DOUBLE, 24); }
        public Vehicle sinceShift(double it) { segment.set(JAVA_DOUBLE, 24, it); return this; }
        /** m/s, of the chassis, forward */
        public double speed() { return segment.get(JAVA_DOUBLE, 32); }
        public Vehicle speed(double it) { segment.set(JAVA_DOUBLE, 32, it); return this; }
    }

    /** State of a wheel. Fill with carom_wheel_init(). */
    public static final class Wheel {
        public static final int SIZE = 168;
        public final MemorySegment segment;
        public Wheel(Arena arena) { segment = arena.allocate(SIZE, 8); carom_wheel_init(segment, SIZE); }
        public Wheel(MemorySegment at) { segment = at; }
        /** 1: it stands on something */
        public int touches() { return segment.get(JAVA_INT, 4); }
        public Wheel touches(int it) { segment.set(JAVA_INT, 4, it); return this; }
        /** on this, or CAROM_NULL_HANDLE */
        public long body() { return segment.get(JAVA_LONG, 8); }
        public Wheel body(long it) { segment.set(JAVA_LONG, 8, it); return this; }
        /** of body */
        public long collider() { return segment.get(JAVA_LONG, 16); }
        public Wheel collider(long it) { segment.set(JAVA_LONG, 16, it); return this; }
        /** m, world: where it touches */
        public double[] point() { return segment.asSlice(24, 24).toArray(JAVA_DOUBLE); }
        public Wheel point(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 24, count(it.length, 3)); return this; }
        /** unit, world, from the ground */
        public double[] normal() { return segment.asSlice(48, 24).toArray(JAVA_DOUBLE); }
        public Wheel normal(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 48, count(it.length, 3)); return this; }
        /** m, world: of its centre */
        public double[] position() { return segment.asSlice(72, 24).toArray(JAVA_DOUBLE); }
        public Wheel position(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 72, count(it.length, 3)); return this; }
        /** m, of its spring; 0: nothing presses */
        public double compression() { return segment.get(JAVA_DOUBLE, 96); }
        public Wheel compression(double it) { segment.set(JAVA_DOUBLE, 96, it); return this; }
        /** rad/s, forward */
        public double spin() { return segment.get(JAVA_DOUBLE, 104); }
        public Wheel spin(double it) { segment.set(JAVA_DOUBLE, 104, it); return this; }
        /** rad, [-pi, pi], turned so far */
        public double angle() { return segment.get(JAVA_DOUBLE, 112); }
        public Wheel angle(double it) { segment.set(JAVA_DOUBLE, 112, it); return this; }
        /** rad, to the left */
        public double steer() { return segment.get(JAVA_DOUBLE, 120); }
        public Wheel steer(double it) { segment.set(JAVA_DOUBLE, 120, it); return this; }
        /** N, along the normal, mean over the drive */
        public double load() { return segment.get(JAVA_DOUBLE, 128); }
        public Wheel load(double it) { segment.set(JAVA_DOUBLE, 128, it); return this; }
        /** N, along the wheel on the chassis, likewise */
        public double force() { return segment.get(JAVA_DOUBLE, 136); }
        public Wheel force(double it) { segment.set(JAVA_DOUBLE, 136, it); return this; }
        /** N, across it, to the left, likewise */
        public double sideForce() { return segment.get(JAVA_DOUBLE, 144); }
        public Wheel sideForce(double it) { segment.set(JAVA_DOUBLE, 144, it); return this; }
        /** deflection over relaxation, along: at a steady speed the slip */
        public double slip() { return segment.get(JAVA_DOUBLE, 152); }
        public Wheel slip(double it) { segment.set(JAVA_DOUBLE, 152, it); return this; }
        /** likewise across: at a steady speed the tangent of the slip angle */
        public double sideSlip() { return segment.get(JAVA_DOUBLE, 160); }
        public Wheel sideSlip(double it) { segment.set(JAVA_DOUBLE, 160, it); return this; }
    }

    /** What a world is made from. Fill with carom_world_desc_init(). */
    public static final class WorldDesc {
        public static final int SIZE = 40;
        public final MemorySegment segment;
        public WorldDesc(Arena arena) { segment = arena.allocate(SIZE, 8); carom_world_desc_init(segment, SIZE); }
        public WorldDesc(MemorySegment at) { segment = at; }
        /** m/s^2, default (0, -9.81, 0) */
        public double[] gravity() { return segment.asSlice(8, 24).toArray(JAVA_DOUBLE); }
        public WorldDesc gravity(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 8, count(it.length, 3)); return this; }
        /** bodies to reserve memory for; it grows beyond. default 0 */
        public long bodyCapacity() { return segment.get(JAVA_LONG, 32); }
        public WorldDesc bodyCapacity(long it) { segment.set(JAVA_LONG, 32, it); return this; }
    }

    /** Times, counts and residuals of the last step. A stage without participants did not run: its time is 0. */
    public static final class StepReport {
        public static final int SIZE = 416;
        public final MemorySegment segment;
        public StepReport(Arena arena) { segment = arena.allocate(SIZE, 8); segment.set(JAVA_INT, 0, SIZE); }
        public StepReport(MemorySegment at) { segment = at; }
        /** CAROM_STAGE_COUNT of this library */
        public int stageCount() { return segment.get(JAVA_INT, 4); }
        public StepReport stageCount(int it) { segment.set(JAVA_INT, 4, it); return this; }
        /** s, [stage_count] used, index CAROM_STAGE_* */
        public double[] stageSeconds() { return segment.asSlice(8, 128).toArray(JAVA_DOUBLE); }
        public StepReport stageSeconds(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 8, count(it.length, 16)); return this; }
        /** s */
        public double totalSeconds() { return segment.get(JAVA_DOUBLE, 136); }
        public StepReport totalSeconds(double it) { segment.set(JAVA_DOUBLE, 136, it); return this; }
        /** since the world was made */
        public long steps() { return segment.get(JAVA_LONG, 144); }
        public StepReport steps(long it) { segment.set(JAVA_LONG, 144, it); return this; }
        /** s, simulated */
        public double time() { return segment.get(JAVA_DOUBLE, 152); }
        public StepReport time(double it) { segment.set(JAVA_DOUBLE, 152, it); return this; }
        /** all kinds; particles are counted by themselves */
        public long bodies() { return segment.get(JAVA_LONG, 160); }
        public StepReport bodies(long it) { segment.set(JAVA_LONG, 160, it); return this; }
        /** asleep ones too */
        public long dynamicBodies() { return segment.get(JAVA_LONG, 168); }
        public StepReport dynamicBodies(long it) { segment.set(JAVA_LONG, 168, it); return this; }
        /** of all bodies */
        public long colliders() { return segment.get(JAVA_LONG, 176); }
        public StepReport colliders(long it) { segment.set(JAVA_LONG, 176, it); return this; }
        /** pairs that the broad phase reported */
        public long broadPairs() { return segment.get(JAVA_LONG, 184); }
        public StepReport broadPairs(long it) { segment.set(JAVA_LONG, 184, it); return this; }
        /** of them, pairs with at least one contact point */
        public long contactPairs() { return segment.get(JAVA_LONG, 192); }
        public StepReport contactPairs(long it) { segment.set(JAVA_LONG, 192, it); return this; }
        /** of all contact pairs */
        public long contactPoints() { return segment.get(JAVA_LONG, 200); }
        public StepReport contactPoints(long it) { segment.set(JAVA_LONG, 200, it); return this; }
        /** contact groups with at least one contact */
        public long groups() { return segment.get(JAVA_LONG, 208); }
        public StepReport groups(long it) { segment.set(JAVA_LONG, 208, it); return this; }
        /** contact points in it */
        public long largestGroup() { return segment.get(JAVA_LONG, 216); }
        public StepReport largestGroup(long it) { segment.set(JAVA_LONG, 216, it); return this; }
        /** generic queries */
        public long gjkCalls() { return segment.get(JAVA_LONG, 224); }
        public StepReport gjkCalls(long it) { segment.set(JAVA_LONG, 224, it); return this; }
        /** of shapes that overlap */
        public long epaCalls() { return segment.get(JAVA_LONG, 232); }
        public StepReport epaCalls(long it) { segment.set(JAVA_LONG, 232, it); return this; }
        /** single calls of support functions */
        public long supportCalls() { return segment.get(JAVA_LONG, 240); }
        public StepReport supportCalls(long it) { segment.set(JAVA_LONG, 240, it); return this; }
        /** impulses applied by the solver */
        public long velocityImpulses() { return segment.get(JAVA_LONG, 248); }
        public StepReport velocityImpulses(long it) { segment.set(JAVA_LONG, 248, it); return this; }
        /** penetration corrections applied */
        public long positionMoves() { return segment.get(JAVA_LONG, 256); }
        public StepReport positionMoves(long it) { segment.set(JAVA_LONG, 256, it); return this; }
        /** held still since their state was not finite, in all */
        public long quarantinedBodies() { return segment.get(JAVA_LONG, 264); }
        public StepReport quarantinedBodies(long it) { segment.set(JAVA_LONG, 264, it); return this; }
        /** plugin faults in this step */
        public long faults() { return segment.get(JAVA_LONG, 272); }
        public StepReport faults(long it) { segment.set(JAVA_LONG, 272, it); return this; }
        /** m, over all contact points after the step; 0 if none */
        public double maxPenetration() { return segment.get(JAVA_DOUBLE, 280); }
        public StepReport maxPenetration(double it) { segment.set(JAVA_DOUBLE, 280, it); return this; }
        /** m, over contact points that overlap after the step */
        public double meanPenetration() { return segment.get(JAVA_DOUBLE, 288); }
        public StepReport meanPenetration(double it) { segment.set(JAVA_DOUBLE, 288, it); return this; }
        /** m/s left at touching contact points after the step */
        public double maxClosingSpeed() { return segment.get(JAVA_DOUBLE, 296); }
        public StepReport maxClosingSpeed(double it) { segment.set(JAVA_DOUBLE, 296, it); return this; }
        /** J, kinetic, with that of particles */
        public double linearEnergy() { return segment.get(JAVA_DOUBLE, 304); }
        public StepReport linearEnergy(double it) { segment.set(JAVA_DOUBLE, 304, it); return this; }
        /** J, kinetic */
        public double angularEnergy() { return segment.get(JAVA_DOUBLE, 312); }
        public StepReport angularEnergy(double it) { segment.set(JAVA_DOUBLE, 312, it); return this; }
        /** after the step, counted under dynamic_bodies */
        public long asleepBodies() { return segment.get(JAVA_LONG, 320); }
        public StepReport asleepBodies(long it) { segment.set(JAVA_LONG, 320, it); return this; }
        /** of them, in this step */
        public long fellAsleep() { return segment.get(JAVA_LONG, 328); }
        public StepReport fellAsleep(long it) { segment.set(JAVA_LONG, 328, it); return this; }
        /** bodies that woke in this step or since the one before */
        public long wokeUp() { return segment.get(JAVA_LONG, 336); }
        public StepReport wokeUp(long it) { segment.set(JAVA_LONG, 336, it); return this; }
        /** of the groups, those that CAROM_SOLVER_AUTO gave to the direct solver */
        public long directGroups() { return segment.get(JAVA_LONG, 344); }
        public StepReport directGroups(long it) { segment.set(JAVA_LONG, 344, it); return this; }
        /** m/s, how far the direct solver's solution is from Coulomb's law at the worst contact point and substep; 0 where it had nothing to do. Of islands with joints, from that law with friction as bounded by the loads of the substep before */
        public double solverResidual() { return segment.get(JAVA_DOUBLE, 352); }
        public StepReport solverResidual(double it) { segment.set(JAVA_DOUBLE, 352, it); return this; }
        /** in all sets */
        public long particles() { return segment.get(JAVA_LONG, 360); }
        public StepReport particles(long it) { segment.set(JAVA_LONG, 360, it); return this; }
        /** of them, held still since their state left the world */
        public long quarantinedParticles() { return segment.get(JAVA_LONG, 368); }
        public StepReport quarantinedParticles(long it) { segment.set(JAVA_LONG, 368, it); return this; }
        /** swept from pose to pose, see carom_body_set_continuous() */
        public long sweptBodies() { return segment.get(JAVA_LONG, 376); }
        public StepReport sweptBodies(long it) { segment.set(JAVA_LONG, 376, it); return this; }
        /** what they met in the step's substeps, resolved at the time of impact */
        public long sweepHits() { return segment.get(JAVA_LONG, 384); }
        public StepReport sweepHits(long it) { segment.set(JAVA_LONG, 384, it); return this; }
        /** groups of the direct solver, counted a substep, that no velocity could satisfy, as where two surfaces close on a body: their contacts yield */
        public long wedgedGroups() { return segment.get(JAVA_LONG, 392); }
        public StepReport wedgedGroups(long it) { segment.set(JAVA_LONG, 392, it); return this; }
        /** solutions of the direct solver by which contacts would have added energy, counted a substep: contacts yield there, which cannot */
        public long rejectedSolutions() { return segment.get(JAVA_LONG, 400); }
        public StepReport rejectedSolutions(long it) { segment.set(JAVA_LONG, 400, it); return this; }
        /** J, kinetic, that islands with joints and contacts, or whose contacts yield, have beyond what their rows may give, summed over substeps; above 0 only where the work of a step did not suffice to solve one */
        public double excessEnergy() { return segment.get(JAVA_DOUBLE, 408); }
        public StepReport excessEnergy(double it) { segment.set(JAVA_DOUBLE, 408, it); return this; }
    }

    /** A contact point of the last step. */
    public static final class Contact {
        public static final int SIZE = 104;
        public final MemorySegment segment;
        public Contact(Arena arena) { segment = arena.allocate(SIZE, 8); }
        public Contact(MemorySegment at) { segment = at; }
        /** first of the pair */
        public long colliderA() { return segment.get(JAVA_LONG, 0); }
        public Contact colliderA(long it) { segment.set(JAVA_LONG, 0, it); return this; }
        /** second of the pair */
        public long colliderB() { return segment.get(JAVA_LONG, 8); }
        public Contact colliderB(long it) { segment.set(JAVA_LONG, 8, it); return this; }
        /** of collider_a */
        public long bodyA() { return segment.get(JAVA_LONG, 16); }
        public Contact bodyA(long it) { segment.set(JAVA_LONG, 16, it); return this; }
        /** of collider_b */
        public long bodyB() { return segment.get(JAVA_LONG, 24); }
        public Contact bodyB(long it) { segment.set(JAVA_LONG, 24, it); return this; }
        /** m, world, midway between the two surfaces */
        public double[] point() { return segment.asSlice(32, 24).toArray(JAVA_DOUBLE); }
        public Contact point(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 32, count(it.length, 3)); return this; }
        /** unit, world, from A to B */
        public double[] normal() { return segment.asSlice(56, 24).toArray(JAVA_DOUBLE); }
        public Contact normal(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 56, count(it.length, 3)); return this; }
        /** m, negative in overlap */
        public double separation() { return segment.get(JAVA_DOUBLE, 80); }
        public Contact separation(double it) { segment.set(JAVA_DOUBLE, 80, it); return this; }
        /** N s, summed over the step, along the normal on B */
        public double normalImpulse() { return segment.get(JAVA_DOUBLE, 88); }
        public Contact normalImpulse(double it) { segment.set(JAVA_DOUBLE, 88, it); return this; }
        /** N s, magnitude, summed over the step */
        public double frictionImpulse() { return segment.get(JAVA_DOUBLE, 96); }
        public Contact frictionImpulse(double it) { segment.set(JAVA_DOUBLE, 96, it); return this; }
    }

    /** A contact group of the last step, and which solver CAROM_SOLVER_AUTO chose for it. */
    public static final class Group {
        public static final int SIZE = 40;
        public final MemorySegment segment;
        public Group(Arena arena) { segment = arena.allocate(SIZE, 8); }
        public Group(MemorySegment at) { segment = at; }
        /** one of its bodies; CAROM_NULL_HANDLE if that was destroyed since */
        public long body() { return segment.get(JAVA_LONG, 0); }
        public Group body(long it) { segment.set(JAVA_LONG, 0, it); return this; }
        /** that contacts move */
        public int bodies() { return segment.get(JAVA_INT, 8); }
        public Group bodies(int it) { segment.set(JAVA_INT, 8, it); return this; }
        /** contact points */
        public int points() { return segment.get(JAVA_INT, 12); }
        public Group points(int it) { segment.set(JAVA_INT, 12, it); return this; }
        /** CAROM_SOLVER_SOFT_STEP or CAROM_SOLVER_DIRECT */
        public int solver() { return segment.get(JAVA_INT, 16); }
        public Group solver(int it) { segment.set(JAVA_INT, 16, it); return this; }
        /** CAROM_REASON_* */
        public int reason() { return segment.get(JAVA_INT, 20); }
        public Group reason(int it) { segment.set(JAVA_INT, 20, it); return this; }
        /** the most of two bodies that touch; 1 for CAROM_REASON_FEW, which it does not matter to */
        public double massRatio() { return segment.get(JAVA_DOUBLE, 24); }
        public Group massRatio(double it) { segment.set(JAVA_DOUBLE, 24, it); return this; }
        /** how deep soft contacts would let a body sink, over the thickness of the thinner of the two; 0 for CAROM_REASON_FEW */
        public double sink() { return segment.get(JAVA_DOUBLE, 32); }
        public Group sink(double it) { segment.set(JAVA_DOUBLE, 32, it); return this; }
    }

    /** Something misbehaved in the last step; the world stayed finite. */
    public static final class Fault {
        public static final int SIZE = 88;
        public final MemorySegment segment;
        public Fault(Arena arena) { segment = arena.allocate(SIZE, 8); }
        public Fault(MemorySegment at) { segment = at; }
        /** CAROM_FAULT_* */
        public int kind() { return segment.get(JAVA_INT, 0); }
        public Fault kind(int it) { segment.set(JAVA_INT, 0, it); return this; }
        /** shape in quarantine, or CAROM_NULL_HANDLE */
        public long shape() { return segment.get(JAVA_LONG, 8); }
        public Fault shape(long it) { segment.set(JAVA_LONG, 8, it); return this; }
        /** a body with this shape, or the quarantined body */
        public long body() { return segment.get(JAVA_LONG, 16); }
        public Fault body(long it) { segment.set(JAVA_LONG, 16, it); return this; }
        /** bits of the direction given */
        public double[] dir() { return segment.asSlice(24, 24).toArray(JAVA_DOUBLE); }
        public Fault dir(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 24, count(it.length, 3)); return this; }
        /** bits of what came back */
        public double[] out() { return segment.asSlice(48, 24).toArray(JAVA_DOUBLE); }
        public Fault out(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 48, count(it.length, 3)); return this; }
        /** the set, of PARTICLE_STATE, or CAROM_NULL_HANDLE */
        public long particles() { return segment.get(JAVA_LONG, 72); }
        public Fault particles(long it) { segment.set(JAVA_LONG, 72, it); return this; }
        /** the first of it that was put in quarantine in this step: its index then */
        public long particle() { return segment.get(JAVA_LONG, 80); }
        public Fault particle(long it) { segment.set(JAVA_LONG, 80, it); return this; }
    }

    /** Settings of a query; fill with carom_query_desc_init(). The same for all queries of a call. */
    public static final class QueryDesc {
        public static final int SIZE = 56;
        public final MemorySegment segment;
        public QueryDesc(Arena arena) { segment = arena.allocate(SIZE, 8); carom_query_desc_init(segment, SIZE); }
        public QueryDesc(MemorySegment at) { segment = at; }
        /** CAROM_ASK_* bits (cast.h), default 0 */
        public int flags() { return segment.get(JAVA_INT, 4); }
        public QueryDesc flags(int it) { segment.set(JAVA_INT, 4, it); return this; }
        /** of the query, default all bits: a collider's mask must have a bit of it */
        public long category() { return segment.get(JAVA_LONG, 8); }
        public QueryDesc category(long it) { segment.set(JAVA_LONG, 8, it); return this; }
        /** default all bits: a collider's categories must have a bit of it (by default it has bit 0) */
        public long mask() { return segment.get(JAVA_LONG, 16); }
        public QueryDesc mask(long it) { segment.set(JAVA_LONG, 16, it); return this; }
        /** its colliders are passed over; default CAROM_NULL_HANDLE: none */
        public long ignore() { return segment.get(JAVA_LONG, 24); }
        public QueryDesc ignore(long it) { segment.set(JAVA_LONG, 24, it); return this; }
        /** as in carom_cast_desc; of distances as in carom_distance_desc; default 1e-6 */
        public double tolerance() { return segment.get(JAVA_DOUBLE, 32); }
        public QueryDesc tolerance(double it) { segment.set(JAVA_DOUBLE, 32, it); return this; }
        /** m, as in carom_cast_desc: how near counts as contact; default 0 */
        public double target() { return segment.get(JAVA_DOUBLE, 40); }
        public QueryDesc target(double it) { segment.set(JAVA_DOUBLE, 40, it); return this; }
        /** cap, as in carom_cast_desc, default 128 */
        public int iterations() { return segment.get(JAVA_INT, 48); }
        public QueryDesc iterations(int it) { segment.set(JAVA_INT, 48, it); return this; }
    }

    /** One collider's result. Of casts: as in carom_cast. Of overlaps: outcome OVERLAP with a point in both, or UNDECIDED
     *  within rounding. Of the nearest: separation, lower and upper as in carom_distance, time 0; outcome OVERLAP if it is
     *  negative, else HIT. */
    public static final class WorldHit {
        public static final int SIZE = 136;
        public final MemorySegment segment;
        public WorldHit(Arena arena) { segment = arena.allocate(SIZE, 8); }
        public WorldHit(MemorySegment at) { segment = at; }
        /** CAROM_CAST_*; a MISS (or BAD_RAY) has no collider */
        public int outcome() { return segment.get(JAVA_INT, 0); }
        public WorldHit outcome(int it) { segment.set(JAVA_INT, 0, it); return this; }
        /** CAROM_QUERY_* */
        public int status() { return segment.get(JAVA_INT, 4); }
        public WorldHit status(int it) { segment.set(JAVA_INT, 4, it); return this; }
        /** index in the call's arrays */
        public long query() { return segment.get(JAVA_LONG, 8); }
        public WorldHit query(long it) { segment.set(JAVA_LONG, 8, it); return this; }
        /** CAROM_NULL_HANDLE: none; with status FAULT: the query shape misbehaved */
        public long collider() { return segment.get(JAVA_LONG, 16); }
        public WorldHit collider(long it) { segment.set(JAVA_LONG, 16, it); return this; }
        /** the collider's */
        public long body() { return segment.get(JAVA_LONG, 24); }
        public WorldHit body(long it) { segment.set(JAVA_LONG, 24, it); return this; }
        /** as in carom_cast */
        public double time() { return segment.get(JAVA_DOUBLE, 32); }
        public WorldHit time(double it) { segment.set(JAVA_DOUBLE, 32, it); return this; }
        /** as in carom_cast; of a distance m */
        public double lower() { return segment.get(JAVA_DOUBLE, 40); }
        public WorldHit lower(double it) { segment.set(JAVA_DOUBLE, 40, it); return this; }
        /** as in carom_cast; of a distance m */
        public double upper() { return segment.get(JAVA_DOUBLE, 48); }
        public WorldHit upper(double it) { segment.set(JAVA_DOUBLE, 48, it); return this; }
        /** m */
        public double separation() { return segment.get(JAVA_DOUBLE, 56); }
        public WorldHit separation(double it) { segment.set(JAVA_DOUBLE, 56, it); return this; }
        /** unit, world, from the ray or the query shape to the collider */
        public double[] normal() { return segment.asSlice(64, 24).toArray(JAVA_DOUBLE); }
        public WorldHit normal(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 64, count(it.length, 3)); return this; }
        /** m, world, on the collider's surface */
        public double[] point() { return segment.asSlice(88, 24).toArray(JAVA_DOUBLE); }
        public WorldHit point(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 88, count(it.length, 3)); return this; }
        /** m, world, on the query shape's surface, or where the ray is */
        public double[] pointOwn() { return segment.asSlice(112, 24).toArray(JAVA_DOUBLE); }
        public WorldHit pointOwn(double... it) { MemorySegment.copy(it, 0, segment, JAVA_DOUBLE, 112, count(it.length, 3)); return this; }
    }

    /** Query shapes, in the caller's arrays, of float or double, at any stride (0: tightly packed). struct_size and
     *  scalar set by the caller, what is not set zero. */
    public static final class QueryShapes {
        public static final int SIZE = 80;
        public final MemorySegment segment;
        public QueryShapes(Arena arena) { segment = arena.allocate(SIZE, 8); segment.set(JAVA_INT, 0, SIZE); }
        public QueryShapes(MemorySegment at) { segment = at; }
        /** CAROM_SCALAR_* of all but shapes */
        public int scalar() { return segment.get(JAVA_INT, 4); }
        public QueryShapes scalar(int it) { segment.set(JAVA_INT, 4, it); return this; }
        public long count() { return segment.get(JAVA_LONG, 8); }
        public QueryShapes count(long it) { segment.set(JAVA_LONG, 8, it); return this; }
        /** [count], no half-space; CAROM_NULL_HANDLE: a point. NULL: points all of them */
        public MemorySegment shapes() { return segment.get(ADDRESS, 16); }
        public QueryShapes shapes(MemorySegment it) { segment.set(ADDRESS, 16, it); return this; }
        /** [count] 3 scalars each, m */
        public MemorySegment positions() { return segment.get(ADDRESS, 24); }
        public QueryShapes positions(MemorySegment it) { segment.set(ADDRESS, 24, it); return this; }
        /** [count] 4 scalars each, x, y, z, w; or NULL: identity */
        public MemorySegment orientations() { return segment.get(ADDRESS, 32); }
        public QueryShapes orientations(MemorySegment it) { segment.set(ADDRESS, 32, it); return this; }
        /** [count] 3 scalars each, m, of casts; else NULL */
        public MemorySegment motions() { return segment.get(ADDRESS, 40); }
        public QueryShapes motions(MemorySegment it) { segment.set(ADDRESS, 40, it); return this; }
        /** bytes */
        public long shapeStride() { return segment.get(JAVA_LONG, 48); }
        public QueryShapes shapeStride(long it) { segment.set(JAVA_LONG, 48, it); return this; }
        public long positionStride() { return segment.get(JAVA_LONG, 56); }
        public QueryShapes positionStride(long it) { segment.set(JAVA_LONG, 56, it); return this; }
        public long orientationStride() { return segment.get(JAVA_LONG, 64); }
        public QueryShapes orientationStride(long it) { segment.set(JAVA_LONG, 64, it); return this; }
        public long motionStride() { return segment.get(JAVA_LONG, 72); }
        public QueryShapes motionStride(long it) { segment.set(JAVA_LONG, 72, it); return this; }
    }

    /** Where results of rays go, one each: records, or separate arrays, or both; NULL: not wanted. Strides in bytes, 0:
     *  tightly packed. */
    public static final class WorldHits {
        public static final int SIZE = 104;
        public final MemorySegment segment;
        public WorldHits(Arena arena) { segment = arena.allocate(SIZE, 8); segment.set(JAVA_INT, 0, SIZE); }
        public WorldHits(MemorySegment at) { segment = at; }
        /** CAROM_SCALAR_* of times, normals and points */
        public int scalar() { return segment.get(JAVA_INT, 4); }
        public WorldHits scalar(int it) { segment.set(JAVA_INT, 4, it); return this; }
        /** [count]; a stride shorter than a record gets its prefix */
        public MemorySegment records() { return segment.get(ADDRESS, 8); }
        public WorldHits records(MemorySegment it) { segment.set(ADDRESS, 8, it); return this; }
        /** [count] */
        public MemorySegment outcomes() { return segment.get(ADDRESS, 16); }
        public WorldHits outcomes(MemorySegment it) { segment.set(ADDRESS, 16, it); return this; }
        /** [count] */
        public MemorySegment colliders() { return segment.get(ADDRESS, 24); }
        public WorldHits colliders(MemorySegment it) { segment.set(ADDRESS, 24, it); return this; }
        /** [count] 1 scalar; a miss: max; a bad ray: 0 */
        public MemorySegment times() { return segment.get(ADDRESS, 32); }
        public WorldHits times(MemorySegment it) { segment.set(ADDRESS, 32, it); return this; }
        /** [count] 3 scalars; a miss: 0 */
        public MemorySegment normals() { return segment.get(ADDRESS, 40); }
        public WorldHits normals(MemorySegment it) { segment.set(ADDRESS, 40, it); return this; }
        /** [count] 3 scalars, `point`; a miss: 0 */
        public MemorySegment points() { return segment.get(ADDRESS, 48); }
        public WorldHits points(MemorySegment it) { segment.set(ADDRESS, 48, it); return this; }
        public long recordStride() { return segment.get(JAVA_LONG, 56); }
        public WorldHits recordStride(long it) { segment.set(JAVA_LONG, 56, it); return this; }
        public long outcomeStride() { return segment.get(JAVA_LONG, 64); }
        public WorldHits outcomeStride(long it) { segment.set(JAVA_LONG, 64, it); return this; }
        public long colliderStride() { return segment.get(JAVA_LONG, 72); }
        public WorldHits colliderStride(long it) { segment.set(JAVA_LONG, 72, it); return this; }
        public long timeStride() { return segment.get(JAVA_LONG, 80); }
        public WorldHits timeStride(long it) { segment.set(JAVA_LONG, 80, it); return this; }
        public long normalStride() { return segment.get(JAVA_LONG, 88); }
        public WorldHits normalStride(long it) { segment.set(JAVA_LONG, 88, it); return this; }
        public long pointStride() { return segment.get(JAVA_LONG, 96); }
        public WorldHits pointStride(long it) { segment.set(JAVA_LONG, 96, it); return this; }
    }

    private static final class carom_version_ {
        static final MethodHandle CALL = Library.call("carom_version", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, ADDRESS));
    }
    /** Version of the library that is running (the CAROM_VERSION_* macros are the header's).
     *  param: major, minor, patch as CAROM_VERSION_*
     *  status: OK; NULL_ARGUMENT */
    public static int carom_version(MemorySegment major, MemorySegment minor, MemorySegment patch) {
        try { return (int) carom_version_.CALL.invokeExact(major, minor, patch); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_result_name_ {
        static final MethodHandle CALL = Library.call("carom_result_name", FunctionDescriptor.of(ADDRESS, JAVA_INT));
    }
    /** Name of a result code, e.g. "CAROM_E_BUSY"; "CAROM_E_?" for an unknown one. Static storage.
     *  param: result of any call */
    public static String carom_result_name(int result) {
        try { return ((MemorySegment) carom_result_name_.CALL.invokeExact(result)).reinterpret(Long.MAX_VALUE).getString(0); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_result_remedy_ {
        static final MethodHandle CALL = Library.call("carom_result_remedy", FunctionDescriptor.of(ADDRESS, JAVA_INT));
    }
    /** What to do about a result code, in one sentence. Static storage.
     *  param: result of any call */
    public static String carom_result_remedy(int result) {
        try { return ((MemorySegment) carom_result_remedy_.CALL.invokeExact(result)).reinterpret(Long.MAX_VALUE).getString(0); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_abi_manifest_ {
        static final MethodHandle CALL = Library.call("carom_abi_manifest", FunctionDescriptor.of(ADDRESS));
    }
    /** The layout of every struct of this interface, as the compiler that built this library has it: for a binding, which
     *  compares it with its own when it is loaded. Lines of four words, ending in '&#92;n'; first "carom" and the version:
     *      carom 0.9.0
     *      carom_error 0 576 struct              name, offset, size in bytes, kind
     *      carom_error.struct_size 0 4 u32
     *      carom_error.witness_dir 16 24 f64[3]
     *  Kinds: u32, i32, u64 (handles too), f64, char, ptr, fn (pointer to a function), struct; [n] behind it: an array.
     *  Newer libraries have more lines, and a struct may be larger; a field stays as it is.
     *  Static storage. */
    public static String carom_abi_manifest() {
        try { return ((MemorySegment) carom_abi_manifest_.CALL.invokeExact()).reinterpret(Long.MAX_VALUE).getString(0); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_abi_check_ {
        static final MethodHandle CALL = Library.call("carom_abi_check", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS));
    }
    /** Is this library what a client was built for? As bindings ask when they have loaded it: of the same major version and
     *  not older (of the same minor version before 1.0), and with the same structs, some of which may be larger here.
     *  param: layout  of the client: lines of carom_abi_manifest(), the first with its version, zero-terminated
     *  status: OK; NULL_ARGUMENT; OUT_OF_RANGE (no line of a version); UNSUPPORTED (the message names this library's file, and the
     *          first line that differs) */
    public static int carom_abi_check(MemorySegment layout, MemorySegment error) {
        try { return (int) carom_abi_check_.CALL.invokeExact(layout, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_accuracy_init_ {
        static final MethodHandle CALL = Library.call("carom_accuracy_init", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_INT));
    }
    /** status: OK; NULL_ARGUMENT; STRUCT_SIZE */
    public static int carom_accuracy_init(MemorySegment accuracy, int structSize) {
        try { return (int) carom_accuracy_init_.CALL.invokeExact(accuracy, structSize); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_world_set_accuracy_ {
        static final MethodHandle CALL = Library.call("carom_world_set_accuracy", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, ADDRESS));
    }
    /** Set an error tolerance from the next step on.
     *  param: accuracy NULL: none, as a world is created
     *  status: OK; UNSUPPORTED; NULL_ARGUMENT; STRUCT_SIZE; NOT_FINITE; OUT_OF_RANGE (also where both place and turn are
     *  0);
     *          BUSY; REENTRANT */
    public static int carom_world_set_accuracy(MemorySegment world, MemorySegment accuracy, MemorySegment error) {
        try { return (int) carom_world_set_accuracy_.CALL.invokeExact(world, accuracy, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_world_get_accuracy_ {
        static final MethodHandle CALL = Library.call("carom_world_get_accuracy", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, ADDRESS, ADDRESS));
    }
    /** param: accuracy out   param: present out: 1 or 0; if 0, accuracy is filled with defaults
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; BUSY */
    public static int carom_world_get_accuracy(MemorySegment world, MemorySegment accuracy, MemorySegment present, MemorySegment error) {
        try { return (int) carom_world_get_accuracy_.CALL.invokeExact(world, accuracy, present, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_world_get_islands_ {
        static final MethodHandle CALL = Library.call("carom_world_get_islands", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, JAVA_LONG, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** Copy out the islands of the last step, worst first: by share, then by body. None without a tolerance.
     *  Bodies in free flight are in none: nothing acts on them but what is constant, and their step is exact.
     *  param: dst      [capacity] elements `stride` bytes apart; may be NULL if capacity is 0
     *  param: stride   sizeof(carom_island) as the caller knows it
     *  param: count    out: how many there are (may exceed capacity; capacity are written)
     *  status: OK; NULL_ARGUMENT; BUFFER_TOO_SMALL; OUT_OF_RANGE (stride); BUSY */
    public static int carom_world_get_islands(MemorySegment world, MemorySegment dst, long stride, long capacity, MemorySegment count, MemorySegment error) {
        try { return (int) carom_world_get_islands_.CALL.invokeExact(world, dst, stride, capacity, count, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_world_measure_growth_ {
        static final MethodHandle CALL = Library.call("carom_world_measure_growth", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_DOUBLE, JAVA_INT, ADDRESS, ADDRESS));
    }
    /** Measure how errors grow from here. Two copies of the world take the steps, at its dials and accuracy, so it costs a
     *  little over twice as much as they; nothing of the world itself changes. The same world gives the same result.
     *  Errors grow e-fold (`sensitive`) where they grow a hundredfold or more, and a quarter of the time or more goes by
     *  until they have grown to the root of that: half of it in chaos, a tenth where they grow in proportion to time.
     *  param: dt      s, of a step: as for carom_world_step()
     *  param: steps   1 to 1000000: several e-foldings of what is looked for, and more than the longest period
     *  param: growth  out, its struct_size set
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; NOT_FINITE; OUT_OF_RANGE; LIMIT; BUSY; REENTRANT; OUT_OF_MEMORY
     *  thread: reader */
    public static int carom_world_measure_growth(MemorySegment world, double dt, int steps, MemorySegment growth, MemorySegment error) {
        try { return (int) carom_world_measure_growth_.CALL.invokeExact(world, dt, steps, growth, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_batch_column_init_ {
        static final MethodHandle CALL = Library.call("carom_batch_column_init", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_INT));
    }
    /** status: OK; NULL_ARGUMENT; STRUCT_SIZE */
    public static int carom_batch_column_init(MemorySegment column, int structSize) {
        try { return (int) carom_batch_column_init_.CALL.invokeExact(column, structSize); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_batch_create_ {
        static final MethodHandle CALL = Library.call("carom_batch_create", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, ADDRESS));
    }
    /** Make a batch without worlds.
     *  param: batch out: to be destroyed before the engine   owns: the caller: carom_batch_destroy()
     *  status: OK; NULL_ARGUMENT; OUT_OF_MEMORY   thread: engine */
    public static int carom_batch_create(MemorySegment engine, MemorySegment batch, MemorySegment error) {
        try { return (int) carom_batch_create_.CALL.invokeExact(engine, batch, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_batch_destroy_ {
        static final MethodHandle CALL = Library.call("carom_batch_destroy", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS));
    }
    /** status: OK; NULL_ARGUMENT; BUSY; REENTRANT */
    public static int carom_batch_destroy(MemorySegment batch, MemorySegment error) {
        try { return (int) carom_batch_destroy_.CALL.invokeExact(batch, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_batch_add_worlds_ {
        static final MethodHandle CALL = Library.call("carom_batch_add_worlds", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** Add n worlds that are as this one is now. The world itself is read, stays as it is, and may be destroyed. A ledger, a
     *  recording and a budget of time are not copied.
     *  param: batch of the same engine   param: n 1 to 2^24 in all   param: first out: the number of the first of them
     *  status: OK; NULL_ARGUMENT; OUT_OF_RANGE (n); WRONG_WORLD (of another engine); LIMIT (256 structures in all); BUSY;
     *          REENTRANT; OUT_OF_MEMORY */
    public static int carom_batch_add_worlds(MemorySegment batch, MemorySegment world, long n, MemorySegment first, MemorySegment error) {
        try { return (int) carom_batch_add_worlds_.CALL.invokeExact(batch, world, n, first, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_batch_add_column_ {
        static final MethodHandle CALL = Library.call("carom_batch_add_column", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, ADDRESS, ADDRESS));
    }
    /** Say where numbers of worlds stand.
     *  param: column out: its number, from 0 on; may be NULL
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; OUT_OF_RANGE (world, n, a ray); NOT_FINITE; *_HANDLE;
     *          UNSUPPORTED (a joint or body that has no such field; read only: not BEFORE_STEP, nor fields that move
     *          joints); BUFFER_TOO_SMALL (stride); LIMIT (4,096 columns); BUSY; REENTRANT; OUT_OF_MEMORY */
    public static int carom_batch_add_column(MemorySegment batch, MemorySegment desc, MemorySegment column, MemorySegment error) {
        try { return (int) carom_batch_add_column_.CALL.invokeExact(batch, desc, column, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_batch_step_ {
        static final MethodHandle CALL = Library.call("carom_batch_step", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, JAVA_DOUBLE, JAVA_INT, ADDRESS, ADDRESS));
    }
    /** Advance worlds, each by steps of dt. First, all that columns BEFORE_STEP have for them is checked: where something is
     *  refused no world has moved. A world that is stopped stays as it is, and so do its rows.
     *  param: mask     [worlds] or NULL: all
     *  param: dt       s, in [1e-9, 1]
     *  param: steps    1 to 1e6, with the same numbers before each
     *  param: stopped  out: how many worlds are stopped now, in all; may be NULL
     *  status: OK; NULL_ARGUMENT; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; UNSUPPORTED; BUSY; REENTRANT; OUT_OF_MEMORY; INTERNAL (a
     *          callback left its thread: some worlds were stepped) */
    public static int carom_batch_step(MemorySegment batch, MemorySegment mask, double dt, int steps, MemorySegment stopped, MemorySegment error) {
        try { return (int) carom_batch_step_.CALL.invokeExact(batch, mask, dt, steps, stopped, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_batch_read_ {
        static final MethodHandle CALL = Library.call("carom_batch_read", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** Read columns, of worlds as they are now. Contact forces are those of a step: 0 here.
     *  param: columns [count]   param: mask [worlds] or NULL: all
     *  status: OK; NULL_ARGUMENT; OUT_OF_RANGE (a column); BUSY; REENTRANT; OUT_OF_MEMORY */
    public static int carom_batch_read(MemorySegment batch, MemorySegment columns, long count, MemorySegment mask, MemorySegment error) {
        try { return (int) carom_batch_read_.CALL.invokeExact(batch, columns, count, mask, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_batch_write_ {
        static final MethodHandle CALL = Library.call("carom_batch_write", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** Write columns, one after the other: poses, speeds, gains, friction, masses. All worlds or none are changed.
     *  param: columns [count]   param: mask [worlds] or NULL: all
     *  status: OK; NULL_ARGUMENT; OUT_OF_RANGE; NOT_FINITE; NOT_UNIT; UNSUPPORTED (read only, or joints that can't be moved);
     *          BUSY; REENTRANT; OUT_OF_MEMORY */
    public static int carom_batch_write(MemorySegment batch, MemorySegment columns, long count, MemorySegment mask, MemorySegment error) {
        try { return (int) carom_batch_write_.CALL.invokeExact(batch, columns, count, mask, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_batch_add_start_ {
        static final MethodHandle CALL = Library.call("carom_batch_add_start", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** Add a state that worlds of a structure may be reset to.
     *  param: world  one of the structure   param: bytes [size] as carom_world_restore() takes them   param: size of bytes
     *  param: start  out: its number among those of the structure, from 1 on; 0 is the state that its worlds were made with
     *  status: OK; NULL_ARGUMENT; OUT_OF_RANGE (world); CORRUPT; UNSUPPORTED; MISMATCH; BUSY; REENTRANT; OUT_OF_MEMORY */
    public static int carom_batch_add_start(MemorySegment batch, long world, MemorySegment bytes, long size, MemorySegment start, MemorySegment error) {
        try { return (int) carom_batch_add_start_.CALL.invokeExact(batch, world, bytes, size, start, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_batch_reset_ {
        static final MethodHandle CALL = Library.call("carom_batch_reset", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, ADDRESS, ADDRESS));
    }
    /** Put worlds back to where they began. Masses that were written stay; what else was written is as in the start.
     *  A world that is stopped runs again.
     *  param: mask   [worlds] or NULL: all   param: starts [worlds] numbers of starts, or NULL: 0
     *  status: OK; NULL_ARGUMENT; OUT_OF_RANGE (a start); BUSY; REENTRANT; OUT_OF_MEMORY */
    public static int carom_batch_reset(MemorySegment batch, MemorySegment mask, MemorySegment starts, MemorySegment error) {
        try { return (int) carom_batch_reset_.CALL.invokeExact(batch, mask, starts, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_batch_save_ {
        static final MethodHandle CALL = Library.call("carom_batch_save", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** Write a snapshot of one world, as carom_world_save() with CAROM_SNAPSHOT_STATE: it goes into the world that was
     *  copied (unless masses differ), or back by carom_batch_add_start(). Arguments as there.
     *  param: world    its number
     *  param: buffer   [capacity] bytes, or NULL to get the size alone
     *  param: capacity bytes; 0 if buffer is NULL
     *  param: needed   out: bytes of the snapshot; written, too, when the buffer is too small (nothing else is)
     *  status: OK; NULL_ARGUMENT; OUT_OF_RANGE (world); BUFFER_TOO_SMALL; BUSY; REENTRANT; OUT_OF_MEMORY */
    public static int carom_batch_save(MemorySegment batch, long world, MemorySegment buffer, long capacity, MemorySegment needed, MemorySegment error) {
        try { return (int) carom_batch_save_.CALL.invokeExact(batch, world, buffer, capacity, needed, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_batch_get_hashes_ {
        static final MethodHandle CALL = Library.call("carom_batch_get_hashes", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, JAVA_LONG, ADDRESS));
    }
    /** The hash of each world, as carom_world_hash().
     *  param: hashes out, [worlds]   param: n how many worlds there are
     *  status: OK; NULL_ARGUMENT; OUT_OF_RANGE (n); BUSY; REENTRANT; OUT_OF_MEMORY */
    public static int carom_batch_get_hashes(MemorySegment batch, MemorySegment hashes, long n, MemorySegment error) {
        try { return (int) carom_batch_get_hashes_.CALL.invokeExact(batch, hashes, n, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_batch_get_stopped_ {
        static final MethodHandle CALL = Library.call("carom_batch_get_stopped", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, JAVA_LONG, ADDRESS));
    }
    /** Which worlds are stopped, and why.
     *  param: stopped out, [worlds] CAROM_STOPPED_*   param: n how many worlds there are
     *  status: OK; NULL_ARGUMENT; OUT_OF_RANGE (n); BUSY */
    public static int carom_batch_get_stopped(MemorySegment batch, MemorySegment stopped, long n, MemorySegment error) {
        try { return (int) carom_batch_get_stopped_.CALL.invokeExact(batch, stopped, n, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_batch_get_faults_ {
        static final MethodHandle CALL = Library.call("carom_batch_get_faults", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, JAVA_LONG, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** The faults of the step that stopped a world; none where it is not stopped.
     *  param: world    its number
     *  param: dst      [capacity] elements `stride` bytes apart; may be NULL if capacity is 0
     *  param: stride   sizeof(carom_fault) as the caller knows it
     *  param: count    out: how many there are (may exceed capacity; capacity are written)
     *  status: OK; NULL_ARGUMENT; BUFFER_TOO_SMALL; OUT_OF_RANGE (world, stride); BUSY */
    public static int carom_batch_get_faults(MemorySegment batch, long world, MemorySegment dst, long stride, long capacity, MemorySegment count, MemorySegment error) {
        try { return (int) carom_batch_get_faults_.CALL.invokeExact(batch, world, dst, stride, capacity, count, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_batch_get_info_ {
        static final MethodHandle CALL = Library.call("carom_batch_get_info", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, ADDRESS));
    }
    /** status: OK; NULL_ARGUMENT; STRUCT_SIZE; BUSY */
    public static int carom_batch_get_info(MemorySegment batch, MemorySegment info, MemorySegment error) {
        try { return (int) carom_batch_get_info_.CALL.invokeExact(batch, info, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_random_fill_ {
        static final MethodHandle CALL = Library.call("carom_random_fill", FunctionDescriptor.of(JAVA_INT, JAVA_INT, ADDRESS, JAVA_LONG, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** Random numbers that follow from a key alone: n rows, each from its own key. So they do not depend on how many worlds
     *  there are, in which order or on which thread, or machine, they are drawn. Philox4x32-10; the normal ones by Box and
     *  Muller. A row that is longer begins as a shorter one of its key.
     *  param: kind  CAROM_RANDOM_*
     *  param: keys  [3 n]: of each row a seed, the number of a world, a step
     *  param: width numbers in a row
     *  param: dst   out, [n width]
     *  status: OK; NULL_ARGUMENT; UNKNOWN_ENUM; OUT_OF_RANGE (n, width)   thread: any */
    public static int carom_random_fill(int kind, MemorySegment keys, long n, long width, MemorySegment dst, MemorySegment error) {
        try { return (int) carom_random_fill_.CALL.invokeExact(kind, keys, n, width, dst, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_material_desc_init_ {
        static final MethodHandle CALL = Library.call("carom_material_desc_init", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_INT));
    }
    /** status: OK; NULL_ARGUMENT; STRUCT_SIZE */
    public static int carom_material_desc_init(MemorySegment desc, int structSize) {
        try { return (int) carom_material_desc_init_.CALL.invokeExact(desc, structSize); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_material_create_ {
        static final MethodHandle CALL = Library.call("carom_material_create", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, ADDRESS, ADDRESS));
    }
    /** status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; NOT_FINITE; OUT_OF_RANGE; UNKNOWN_ENUM; BUSY; OUT_OF_MEMORY */
    public static int carom_material_create(MemorySegment world, MemorySegment desc, MemorySegment material, MemorySegment error) {
        try { return (int) carom_material_create_.CALL.invokeExact(world, desc, material, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_material_update_ {
        static final MethodHandle CALL = Library.call("carom_material_update", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** Change a material in place; every collider that uses it follows.   status: as carom_material_create(); *_HANDLE */
    public static int carom_material_update(MemorySegment world, long material, MemorySegment desc, MemorySegment error) {
        try { return (int) carom_material_update_.CALL.invokeExact(world, material, desc, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_material_set_resistance_ {
        static final MethodHandle CALL = Library.call("carom_material_set_resistance", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, JAVA_DOUBLE, JAVA_DOUBLE, ADDRESS));
    }
    /** Resistance of a surface to rolling and to spinning about the normal, 0 when it is created. A contact that presses
     *  with a force N bears a moment of up to rolling * N in its plane and of up to spinning * N about its normal. Mixed as
     *  friction is; carom_material_update() leaves it alone.
     *  param: rolling, spinning m, [0, 1e3]
     *  status: OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; OUT_OF_MEMORY */
    public static int carom_material_set_resistance(MemorySegment world, long material, double rolling, double spinning, MemorySegment error) {
        try { return (int) carom_material_set_resistance_.CALL.invokeExact(world, material, rolling, spinning, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_material_get_resistance_ {
        static final MethodHandle CALL = Library.call("carom_material_get_resistance", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS, ADDRESS));
    }
    /** param: rolling, spinning out: m   status: OK; NULL_ARGUMENT; *_HANDLE; BUSY */
    public static int carom_material_get_resistance(MemorySegment world, long material, MemorySegment rolling, MemorySegment spinning, MemorySegment error) {
        try { return (int) carom_material_get_resistance_.CALL.invokeExact(world, material, rolling, spinning, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_material_set_pair_ {
        static final MethodHandle CALL = Library.call("carom_material_set_pair", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** Say what two materials are to each other, instead of mixing them. Wakes what touches so. It ends with either material.
     *  param: material_a, material_b  in any order; the same twice: colliders of that material among themselves
     *  param: surface [4] friction, [0, 1e3]; restitution, [0, 1]; resistance to rolling and to spinning, m, [0, 1e3].
     *                 NULL: they mix again
     *  status: OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; OUT_OF_MEMORY   since: 0.9 */
    public static int carom_material_set_pair(MemorySegment world, long materialA, long materialB, MemorySegment surface, MemorySegment error) {
        try { return (int) carom_material_set_pair_.CALL.invokeExact(world, materialA, materialB, surface, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_material_get_pair_ {
        static final MethodHandle CALL = Library.call("carom_material_get_pair", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** What two materials are to each other: what was said of them, or else what they mix to.
     *  param: surface out, [4]: as carom_material_set_pair() takes it
     *  status: OK; NULL_ARGUMENT; *_HANDLE; BUSY   since: 0.9 */
    public static int carom_material_get_pair(MemorySegment world, long materialA, long materialB, MemorySegment surface, MemorySegment error) {
        try { return (int) carom_material_get_pair_.CALL.invokeExact(world, materialA, materialB, surface, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_material_destroy_ {
        static final MethodHandle CALL = Library.call("carom_material_destroy", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS));
    }
    /** status: OK; NULL_ARGUMENT; *_HANDLE; IN_USE (a collider uses it); BUSY */
    public static int carom_material_destroy(MemorySegment world, long material, MemorySegment error) {
        try { return (int) carom_material_destroy_.CALL.invokeExact(world, material, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_body_desc_init_ {
        static final MethodHandle CALL = Library.call("carom_body_desc_init", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_INT));
    }
    /** status: OK; NULL_ARGUMENT; STRUCT_SIZE */
    public static int carom_body_desc_init(MemorySegment desc, int structSize) {
        try { return (int) carom_body_desc_init_.CALL.invokeExact(desc, structSize); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_body_create_ {
        static final MethodHandle CALL = Library.call("carom_body_create", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, ADDRESS, ADDRESS));
    }
    /** status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; UNKNOWN_ENUM; BUSY;
     *          REENTRANT; LIMIT; OUT_OF_MEMORY */
    public static int carom_body_create(MemorySegment world, MemorySegment desc, MemorySegment body, MemorySegment error) {
        try { return (int) carom_body_create_.CALL.invokeExact(world, desc, body, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_body_destroy_ {
        static final MethodHandle CALL = Library.call("carom_body_destroy", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS));
    }
    /** Destroys its colliders too.   status: OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT */
    public static int carom_body_destroy(MemorySegment world, long body, MemorySegment error) {
        try { return (int) carom_body_destroy_.CALL.invokeExact(world, body, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_body_get_ {
        static final MethodHandle CALL = Library.call("carom_body_get", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** Everything there is to know about a body, with its masses as the engine uses them (fields: all of FIELD_* set; a
     *  body that cannot rotate reports zero inertia; a static or kinematic body reports mass 0).
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; BUSY */
    public static int carom_body_get(MemorySegment world, long body, MemorySegment desc, MemorySegment error) {
        try { return (int) carom_body_get_.CALL.invokeExact(world, body, desc, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_body_set_pose_ {
        static final MethodHandle CALL = Library.call("carom_body_set_pose", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS, ADDRESS));
    }
    /** param: position [3] m   param: orientation [4] x, y, z, w   status: OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE;
     *  NOT_UNIT; BUSY; REENTRANT */
    public static int carom_body_set_pose(MemorySegment world, long body, MemorySegment position, MemorySegment orientation, MemorySegment error) {
        try { return (int) carom_body_set_pose_.CALL.invokeExact(world, body, position, orientation, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_body_set_velocity_ {
        static final MethodHandle CALL = Library.call("carom_body_set_velocity", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS, ADDRESS));
    }
    /** param: linear [3] m/s of the centre of mass   param: angular [3] rad/s, both world frame
     *  status: OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE (a static body must have 0); BUSY; REENTRANT */
    public static int carom_body_set_velocity(MemorySegment world, long body, MemorySegment linear, MemorySegment angular, MemorySegment error) {
        try { return (int) carom_body_set_velocity_.CALL.invokeExact(world, body, linear, angular, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_body_get_pose_ {
        static final MethodHandle CALL = Library.call("carom_body_get_pose", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS, ADDRESS));
    }
    /** param: position [3] out, or NULL: m, world, origin of the body frame   param: orientation [4] out, or NULL: x, y, z,
     *  w, body to world   status: OK; NULL_ARGUMENT; *_HANDLE; BUSY */
    public static int carom_body_get_pose(MemorySegment world, long body, MemorySegment position, MemorySegment orientation, MemorySegment error) {
        try { return (int) carom_body_get_pose_.CALL.invokeExact(world, body, position, orientation, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_body_get_velocity_ {
        static final MethodHandle CALL = Library.call("carom_body_get_velocity", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS, ADDRESS));
    }
    /** param: linear [3] out, or NULL: m/s, world, of the centre of mass   param: angular [3] out, or NULL: rad/s, world
     *  status: OK; NULL_ARGUMENT; *_HANDLE; BUSY */
    public static int carom_body_get_velocity(MemorySegment world, long body, MemorySegment linear, MemorySegment angular, MemorySegment error) {
        try { return (int) carom_body_get_velocity_.CALL.invokeExact(world, body, linear, angular, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_body_set_mass_ {
        static final MethodHandle CALL = Library.call("carom_body_set_mass", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, JAVA_DOUBLE, ADDRESS, ADDRESS, ADDRESS));
    }
    /** Set the mass of a dynamic body, as carom_body_desc would have. Its frame stays; the velocity of its centre is kept
     *  as that of the new centre. Wakes the body and its island. Snapshots of before do not fit any more (MISMATCH).
     *  param: mass kg, at least 1e-300; or 0: from the densities of its colliders, with center and inertia NULL
     *  param: center [3] m, body frame, or NULL: from its colliders
     *  param: inertia [9] kg m^2, body frame axes, about the centre, row-major, symmetric, positive definite or all zero;
     *  or NULL:
     *                 from its colliders, scaled to the mass
     *  status: OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE (also: a body that is not dynamic); NO_VOLUME (mass 0,
     *          and a collider is flat); BUSY; REENTRANT; OUT_OF_MEMORY */
    public static int carom_body_set_mass(MemorySegment world, long body, double mass, MemorySegment center, MemorySegment inertia, MemorySegment error) {
        try { return (int) carom_body_set_mass_.CALL.invokeExact(world, body, mass, center, inertia, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_body_get_mass_ {
        static final MethodHandle CALL = Library.call("carom_body_get_mass", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS, ADDRESS, ADDRESS));
    }
    /** As the engine uses them: mass 0 of a body that is not dynamic, inertia 0 of one that cannot rotate.
     *  param: mass out, or NULL: kg   param: center [3] out, or NULL: m, body frame   param: inertia [9] out, or NULL: kg
     *  m^2, body frame axes, about the centre, row-major   status: OK; NULL_ARGUMENT; *_HANDLE; BUSY */
    public static int carom_body_get_mass(MemorySegment world, long body, MemorySegment mass, MemorySegment center, MemorySegment inertia, MemorySegment error) {
        try { return (int) carom_body_get_mass_.CALL.invokeExact(world, body, mass, center, inertia, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_body_set_type_ {
        static final MethodHandle CALL = Library.call("carom_body_set_type", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, JAVA_INT, ADDRESS));
    }
    /** Make a static, kinematic or dynamic body of one that is there. A body that becomes static stops. One that is dynamic
     *  no longer loses the mass that it was given, pending forces and what only dynamic bodies may have
     *  (carom_attribute_info.of_dynamic). Snapshots of before do not fit any more. What it touches wakes.
     *  param: type CAROM_BODY_*
     *  status: OK; NULL_ARGUMENT; *_HANDLE; UNKNOWN_ENUM; OUT_OF_RANGE (a half-space needs a static body, scenery one that
     *          is not dynamic; a joint or a spring needs a dynamic one); NO_VOLUME; BUSY; REENTRANT; OUT_OF_MEMORY */
    public static int carom_body_set_type(MemorySegment world, long body, int type, MemorySegment error) {
        try { return (int) carom_body_set_type_.CALL.invokeExact(world, body, type, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_body_get_type_ {
        static final MethodHandle CALL = Library.call("carom_body_get_type", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** param: type out: CAROM_BODY_*   status: OK; NULL_ARGUMENT; *_HANDLE; BUSY */
    public static int carom_body_get_type(MemorySegment world, long body, MemorySegment type, MemorySegment error) {
        try { return (int) carom_body_get_type_.CALL.invokeExact(world, body, type, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_body_set_damping_ {
        static final MethodHandle CALL = Library.call("carom_body_set_damping", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, JAVA_DOUBLE, JAVA_DOUBLE, ADDRESS));
    }
    /** param: linear, angular 1/s, [0, 1e6]: dv/dt = -linear v, likewise of spin   status: OK; NULL_ARGUMENT; *_HANDLE;
     *  NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT */
    public static int carom_body_set_damping(MemorySegment world, long body, double linear, double angular, MemorySegment error) {
        try { return (int) carom_body_set_damping_.CALL.invokeExact(world, body, linear, angular, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_body_get_damping_ {
        static final MethodHandle CALL = Library.call("carom_body_get_damping", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS, ADDRESS));
    }
    /** param: linear, angular out: 1/s; either may be NULL   status: OK; NULL_ARGUMENT; *_HANDLE; BUSY */
    public static int carom_body_get_damping(MemorySegment world, long body, MemorySegment linear, MemorySegment angular, MemorySegment error) {
        try { return (int) carom_body_get_damping_.CALL.invokeExact(world, body, linear, angular, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_body_set_user_ {
        static final MethodHandle CALL = Library.call("carom_body_set_user", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, JAVA_LONG, ADDRESS));
    }
    /** param: user anything; the engine does not look   status: OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT */
    public static int carom_body_set_user(MemorySegment world, long body, long user, MemorySegment error) {
        try { return (int) carom_body_set_user_.CALL.invokeExact(world, body, user, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_body_get_user_ {
        static final MethodHandle CALL = Library.call("carom_body_get_user", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** param: user out   status: OK; NULL_ARGUMENT; *_HANDLE; BUSY */
    public static int carom_body_get_user(MemorySegment world, long body, MemorySegment user, MemorySegment error) {
        try { return (int) carom_body_get_user_.CALL.invokeExact(world, body, user, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_body_get_colliders_ {
        static final MethodHandle CALL = Library.call("carom_body_get_colliders", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** Number of a body's colliders, and their handles in the order of the slots.
     *  param: colliders [capacity] or NULL   param: count out: how many there are (may exceed capacity; capacity are
     *  written)
     *  status: OK; NULL_ARGUMENT; *_HANDLE; BUSY */
    public static int carom_body_get_colliders(MemorySegment world, long body, MemorySegment colliders, long capacity, MemorySegment count, MemorySegment error) {
        try { return (int) carom_body_get_colliders_.CALL.invokeExact(world, body, colliders, capacity, count, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_body_add_force_ {
        static final MethodHandle CALL = Library.call("carom_body_add_force", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS, ADDRESS));
    }
    /** Add a force and a torque about the centre of mass, for the next step only.
     *  param: force [3] N, world   param: torque [3] N m, world
     *  status: OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE (the sum would overflow); BUSY; REENTRANT */
    public static int carom_body_add_force(MemorySegment world, long body, MemorySegment force, MemorySegment torque, MemorySegment error) {
        try { return (int) carom_body_add_force_.CALL.invokeExact(world, body, force, torque, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_body_add_impulse_ {
        static final MethodHandle CALL = Library.call("carom_body_add_impulse", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS, ADDRESS));
    }
    /** Change velocities at once. param: impulse [3] N s, world   param: point [3] m, world: where it acts
     *  status: OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE (the velocity would overflow); BUSY; REENTRANT */
    public static int carom_body_add_impulse(MemorySegment world, long body, MemorySegment impulse, MemorySegment point, MemorySegment error) {
        try { return (int) carom_body_add_impulse_.CALL.invokeExact(world, body, impulse, point, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_body_set_gravity_factor_ {
        static final MethodHandle CALL = Library.call("carom_body_set_gravity_factor", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, JAVA_DOUBLE, ADDRESS));
    }
    /** How much of the world's gravity acts on a body: its weight is mass * factor * gravity. With 0 it floats, below 0 it
     *  rises. 1 - c compensates a share c of its gravity, as a counterweight does; inverse dynamics counts it (tree.h). Wakes the body and its island.
     *  param: factor any finite number; 1 when a body is created
     *  status: OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; BUSY; REENTRANT; OUT_OF_MEMORY */
    public static int carom_body_set_gravity_factor(MemorySegment world, long body, double factor, MemorySegment error) {
        try { return (int) carom_body_set_gravity_factor_.CALL.invokeExact(world, body, factor, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_body_get_gravity_factor_ {
        static final MethodHandle CALL = Library.call("carom_body_get_gravity_factor", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** param: factor out   status: OK; NULL_ARGUMENT; *_HANDLE; BUSY */
    public static int carom_body_get_gravity_factor(MemorySegment world, long body, MemorySegment factor, MemorySegment error) {
        try { return (int) carom_body_get_gravity_factor_.CALL.invokeExact(world, body, factor, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_body_set_locks_ {
        static final MethodHandle CALL = Library.call("carom_body_set_locks", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, JAVA_INT, ADDRESS));
    }
    /** Hold the velocity of a dynamic body along and about some world axes at 0, exactly: forces, contacts and joints move
     *  it along the others alone, as heavy there as it is. What it has of such velocity now is gone; what a host writes of
     *  it later is dropped; a pose that a host sets is taken, and kept from then on. Wakes the body and its island.
     *  
     *  Every solver but CAROM_SOLVER_SEVERITY knows locks: a world with that dial refuses them, and a world with a locked
     *  body refuses that dial.
     *  param: locks CAROM_LOCK_* bits, 0 when a body is created
     *  status: OK; NULL_ARGUMENT; *_HANDLE; UNSUPPORTED (unknown bits; or solver severity: set CAROM_DIAL_SOLVER to another
     *          first); OUT_OF_RANGE (a body that is not dynamic: it moves as its velocity says); BUSY; REENTRANT;
     *          OUT_OF_MEMORY */
    public static int carom_body_set_locks(MemorySegment world, long body, int locks, MemorySegment error) {
        try { return (int) carom_body_set_locks_.CALL.invokeExact(world, body, locks, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_body_get_locks_ {
        static final MethodHandle CALL = Library.call("carom_body_get_locks", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** param: locks out: CAROM_LOCK_* bits   status: OK; NULL_ARGUMENT; *_HANDLE; BUSY */
    public static int carom_body_get_locks(MemorySegment world, long body, MemorySegment locks, MemorySegment error) {
        try { return (int) carom_body_get_locks_.CALL.invokeExact(world, body, locks, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_attribute_get_info_ {
        static final MethodHandle CALL = Library.call("carom_attribute_get_info", FunctionDescriptor.of(JAVA_INT, JAVA_INT, ADDRESS, ADDRESS));
    }
    /** param: attribute CAROM_ATTRIBUTE_*   param: info out
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM */
    public static int carom_attribute_get_info(int attribute, MemorySegment info, MemorySegment error) {
        try { return (int) carom_attribute_get_info_.CALL.invokeExact(attribute, info, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_body_set_attribute_ {
        static final MethodHandle CALL = Library.call("carom_body_set_attribute", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, JAVA_INT, ADDRESS, ADDRESS));
    }
    /** Set an attribute. Another value than it has wakes the body and its island.
     *  param: value [4] in the units of carom_attribute_info; numbers that the attribute does not have must be 0
     *  status: OK; NULL_ARGUMENT; UNKNOWN_ENUM; *_HANDLE; NOT_FINITE; OUT_OF_RANGE (also: a fraction where numbers are
     *  whole; a
     *          body that is not dynamic); UNSUPPORTED (locks under solver severity); BUSY; REENTRANT; OUT_OF_MEMORY */
    public static int carom_body_set_attribute(MemorySegment world, long body, int attribute, MemorySegment value, MemorySegment error) {
        try { return (int) carom_body_set_attribute_.CALL.invokeExact(world, body, attribute, value, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_body_get_attribute_ {
        static final MethodHandle CALL = Library.call("carom_body_get_attribute", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, JAVA_INT, ADDRESS, ADDRESS));
    }
    /** param: value [4] out: numbers that the attribute does not have are 0
     *  status: OK; NULL_ARGUMENT; UNKNOWN_ENUM; *_HANDLE; BUSY */
    public static int carom_body_get_attribute(MemorySegment world, long body, int attribute, MemorySegment value, MemorySegment error) {
        try { return (int) carom_body_get_attribute_.CALL.invokeExact(world, body, attribute, value, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_body_is_asleep_ {
        static final MethodHandle CALL = Library.call("carom_body_is_asleep", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** param: asleep out: 1 or 0   status: OK; NULL_ARGUMENT; *_HANDLE; BUSY */
    public static int carom_body_is_asleep(MemorySegment world, long body, MemorySegment asleep, MemorySegment error) {
        try { return (int) carom_body_is_asleep_.CALL.invokeExact(world, body, asleep, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_body_wake_ {
        static final MethodHandle CALL = Library.call("carom_body_wake", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS));
    }
    /** Wake a body and its island; if it is awake, its time of rest starts anew.   status: OK; NULL_ARGUMENT; *_HANDLE;
     *  BUSY; REENTRANT */
    public static int carom_body_wake(MemorySegment world, long body, MemorySegment error) {
        try { return (int) carom_body_wake_.CALL.invokeExact(world, body, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_body_set_continuous_ {
        static final MethodHandle CALL = Library.call("carom_body_set_continuous", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, JAVA_INT, ADDRESS));
    }
    /** Say when a body is swept, from the next step on. Without effect on a static body, and where CAROM_DIAL_CONTINUOUS
     *  says otherwise: under CAROM_SWEEP_NONE no body is swept, under CAROM_SWEEP_FLAGGED only CAROM_CONTINUOUS_ALWAYS.
     *  param: mode CAROM_CONTINUOUS_*
     *  status: OK; NULL_ARGUMENT; *_HANDLE; UNKNOWN_ENUM (mode: pass one of CAROM_CONTINUOUS_*); BUSY; REENTRANT */
    public static int carom_body_set_continuous(MemorySegment world, long body, int mode, MemorySegment error) {
        try { return (int) carom_body_set_continuous_.CALL.invokeExact(world, body, mode, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_body_get_continuous_ {
        static final MethodHandle CALL = Library.call("carom_body_get_continuous", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** param: mode out: CAROM_CONTINUOUS_*   status: OK; NULL_ARGUMENT; *_HANDLE; BUSY */
    public static int carom_body_get_continuous(MemorySegment world, long body, MemorySegment mode, MemorySegment error) {
        try { return (int) carom_body_get_continuous_.CALL.invokeExact(world, body, mode, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_body_set_enabled_ {
        static final MethodHandle CALL = Library.call("carom_body_set_enabled", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, JAVA_INT, ADDRESS));
    }
    /** Take a body out of steps, or back in, from the next step on. A disabled body keeps its pose and velocity. Nothing
     *  moves it, it touches nothing, and its joints and springs hold nothing. Queries do not find it. Bodies that rested on
     *  it wake. It costs a step nothing. A host may still read and write it.
     *  param: enabled 1 or 0
     *  status: OK; NULL_ARGUMENT; *_HANDLE; UNKNOWN_ENUM (enabled: pass 0 or 1); BUSY; REENTRANT; OUT_OF_MEMORY */
    public static int carom_body_set_enabled(MemorySegment world, long body, int enabled, MemorySegment error) {
        try { return (int) carom_body_set_enabled_.CALL.invokeExact(world, body, enabled, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_body_is_enabled_ {
        static final MethodHandle CALL = Library.call("carom_body_is_enabled", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** param: enabled out: 1 or 0   status: OK; NULL_ARGUMENT; *_HANDLE; BUSY */
    public static int carom_body_is_enabled(MemorySegment world, long body, MemorySegment enabled, MemorySegment error) {
        try { return (int) carom_body_is_enabled_.CALL.invokeExact(world, body, enabled, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_collider_desc_init_ {
        static final MethodHandle CALL = Library.call("carom_collider_desc_init", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_INT));
    }
    /** status: OK; NULL_ARGUMENT; STRUCT_SIZE */
    public static int carom_collider_desc_init(MemorySegment desc, int structSize) {
        try { return (int) carom_collider_desc_init_.CALL.invokeExact(desc, structSize); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_collider_create_ {
        static final MethodHandle CALL = Library.call("carom_collider_create", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS, ADDRESS));
    }
    /** Put a shape on a body; the body's mass properties follow. The body's linear velocity is kept as that of its new
     *  centre.
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE (also: a
     *  half-space on a
     *          body that moves); NO_VOLUME (a flat shape needs CAROM_BODY_FIELD_MASS or density 0); BUSY; REENTRANT;
     *          OUT_OF_MEMORY */
    public static int carom_collider_create(MemorySegment world, long body, MemorySegment desc, MemorySegment collider, MemorySegment error) {
        try { return (int) carom_collider_create_.CALL.invokeExact(world, body, desc, collider, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_body_create_named_ {
        static final MethodHandle CALL = Library.call("carom_body_create_named", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_INT, ADDRESS, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS, ADDRESS));
    }
    /** The common case in one call: a shape by name, a body, and a collider of density 1000. A shape of that name with the
     *  same parameters that the engine has is used again; a new one lives as long as the engine, or until it is destroyed.
     *  Where a part of it fails nothing has changed, but for a plugin that was loaded. Its orientation is the identity, its
     *  friction 0.5, its restitution 0. carom_body_get_colliders() gives its collider.
     *  param: type CAROM_BODY_*   param: name as carom_shape_create_named()   param: position [3] m, world
     *  param: params [count] as carom_shape_create_named()   param: count number of params
     *  status: OK; NULL_ARGUMENT; UNKNOWN_ENUM; NOT_FOUND; NOT_FINITE; OUT_OF_RANGE; NO_VOLUME; PLUGIN_PATH; PLUGIN_LOAD;
     *          PLUGIN_ABI; PLUGIN_INVALID; DECLARATION_FALSE; BUSY; REENTRANT; LIMIT; OUT_OF_MEMORY */
    public static int carom_body_create_named(MemorySegment world, int type, MemorySegment name, MemorySegment params, long count, MemorySegment position, MemorySegment body, MemorySegment error) {
        try { return (int) carom_body_create_named_.CALL.invokeExact(world, type, name, params, count, position, body, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_collider_destroy_ {
        static final MethodHandle CALL = Library.call("carom_collider_destroy", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS));
    }
    /** status: OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT */
    public static int carom_collider_destroy(MemorySegment world, long collider, MemorySegment error) {
        try { return (int) carom_collider_destroy_.CALL.invokeExact(world, collider, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_collider_get_ {
        static final MethodHandle CALL = Library.call("carom_collider_get", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS, ADDRESS));
    }
    /** status: OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; BUSY */
    public static int carom_collider_get(MemorySegment world, long collider, MemorySegment desc, MemorySegment body, MemorySegment error) {
        try { return (int) carom_collider_get_.CALL.invokeExact(world, collider, desc, body, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_collider_set_material_ {
        static final MethodHandle CALL = Library.call("carom_collider_set_material", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, JAVA_LONG, ADDRESS));
    }
    /** Give a collider another material. Wakes what its body touches.   param: material or CAROM_NULL_HANDLE: friction 0.5,
     *  restitution 0   status: OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT; OUT_OF_MEMORY */
    public static int carom_collider_set_material(MemorySegment world, long collider, long material, MemorySegment error) {
        try { return (int) carom_collider_set_material_.CALL.invokeExact(world, collider, material, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_collider_set_density_ {
        static final MethodHandle CALL = Library.call("carom_collider_set_density", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, JAVA_DOUBLE, ADDRESS));
    }
    /** The body's mass follows, unless it was given. Wakes the body and its island.   param: density kg/m^3, [0, 1e9]
     *  status: OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE; NO_VOLUME; BUSY; REENTRANT; OUT_OF_MEMORY */
    public static int carom_collider_set_density(MemorySegment world, long collider, double density, MemorySegment error) {
        try { return (int) carom_collider_set_density_.CALL.invokeExact(world, collider, density, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_collider_set_pose_ {
        static final MethodHandle CALL = Library.call("carom_collider_set_pose", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS, ADDRESS));
    }
    /** Move a shape on its body; the body's mass follows. What is remembered of its contacts is dropped.
     *  param: position [3] m, body frame: origin of the shape; each within 1e15   param: orientation [4] x, y, z, w, shape
     *  to body
     *  status: OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; BUSY; REENTRANT; OUT_OF_MEMORY */
    public static int carom_collider_set_pose(MemorySegment world, long collider, MemorySegment position, MemorySegment orientation, MemorySegment error) {
        try { return (int) carom_collider_set_pose_.CALL.invokeExact(world, collider, position, orientation, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_collider_set_surface_velocity_ {
        static final MethodHandle CALL = Library.call("carom_collider_set_surface_velocity", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS, ADDRESS));
    }
    /** Let a collider's surface move though the collider stays: a conveyor belt, a turntable, a track. Friction then brings
     *  what touches it to the velocity of the surface,
     *    v_body(x) + R (linear + angular x (R^T (x - p))),   the part of it in the plane of the contact,
     *  with R the orientation and p the origin of the shape in the world: axes and origin are the shape's own, so that a
     *  belt turns with its body. Nothing moves but by friction: a surface without friction moves nothing. On a body that
     *  moves it drives that body. Wakes what a change of the collider's filter wakes; what touches a surface that moves
     *  does not fall asleep.
     *  param: linear  [3] m/s, axes of the shape; 0 when a collider is created
     *  param: angular [3] rad/s, axes of the shape, about its origin
     *  status: OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE (beyond 1e6 m/s or rad/s); BUSY; REENTRANT;
     *          OUT_OF_MEMORY */
    public static int carom_collider_set_surface_velocity(MemorySegment world, long collider, MemorySegment linear, MemorySegment angular, MemorySegment error) {
        try { return (int) carom_collider_set_surface_velocity_.CALL.invokeExact(world, collider, linear, angular, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_collider_get_surface_velocity_ {
        static final MethodHandle CALL = Library.call("carom_collider_get_surface_velocity", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS, ADDRESS));
    }
    /** param: linear, angular out: [3], as they were set   status: OK; NULL_ARGUMENT; *_HANDLE; BUSY */
    public static int carom_collider_get_surface_velocity(MemorySegment world, long collider, MemorySegment linear, MemorySegment angular, MemorySegment error) {
        try { return (int) carom_collider_get_surface_velocity_.CALL.invokeExact(world, collider, linear, angular, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_world_get_bodies_ {
        static final MethodHandle CALL = Library.call("carom_world_get_bodies", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** Number of bodies, and their handles in creation order of the slots.
     *  param: handles [capacity] or NULL   param: count out: how many there are
     *  status: OK; NULL_ARGUMENT; BUSY */
    public static int carom_world_get_bodies(MemorySegment world, MemorySegment handles, long capacity, MemorySegment count, MemorySegment error) {
        try { return (int) carom_world_get_bodies_.CALL.invokeExact(world, handles, capacity, count, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_world_read_ {
        static final MethodHandle CALL = Library.call("carom_world_read", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_INT, JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, JAVA_LONG, ADDRESS));
    }
    /** Read one field of n bodies.
     *  param: handles [n], or NULL for all bodies in the order of carom_world_get_bodies() (n must be their number)
     *  param: dst     n records of the field's scalars, `stride` bytes apart
     *  param: stride  bytes from one record to the next; 0: tightly packed
     *  param: field   CAROM_FIELD_*
     *  status: OK; NULL_ARGUMENT; UNKNOWN_ENUM; *_HANDLE (nothing is written); OUT_OF_RANGE (n); BUFFER_TOO_SMALL (stride);
     *  BUSY */
    public static int carom_world_read(MemorySegment world, int field, int scalar, MemorySegment handles, long n, MemorySegment dst, long stride, MemorySegment error) {
        try { return (int) carom_world_read_.CALL.invokeExact(world, field, scalar, handles, n, dst, stride, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_world_write_ {
        static final MethodHandle CALL = Library.call("carom_world_write", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_INT, JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, JAVA_LONG, ADDRESS));
    }
    /** Write one field of n bodies; all values are validated before the first is written. Arguments as carom_world_read().
     *  param: src n records of the field's scalars, `stride` bytes apart
     *  status: as carom_world_read(); UNSUPPORTED (read-only field); NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; REENTRANT */
    public static int carom_world_write(MemorySegment world, int field, int scalar, MemorySegment handles, long n, MemorySegment src, long stride, MemorySegment error) {
        try { return (int) carom_world_write_.CALL.invokeExact(world, field, scalar, handles, n, src, stride, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_cast_desc_init_ {
        static final MethodHandle CALL = Library.call("carom_cast_desc_init", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_INT));
    }
    /** status: OK; NULL_ARGUMENT; STRUCT_SIZE */
    public static int carom_cast_desc_init(MemorySegment desc, int structSize) {
        try { return (int) carom_cast_desc_init_.CALL.invokeExact(desc, structSize); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_motion_init_ {
        static final MethodHandle CALL = Library.call("carom_motion_init", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_INT));
    }
    /** status: OK; NULL_ARGUMENT; STRUCT_SIZE */
    public static int carom_motion_init(MemorySegment motion, int structSize) {
        try { return (int) carom_motion_init_.CALL.invokeExact(motion, structSize); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_ray_cast_ {
        static final MethodHandle CALL = Library.call("carom_ray_cast", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS, ADDRESS, ADDRESS, JAVA_DOUBLE, ADDRESS, ADDRESS, ADDRESS));
    }
    /** Cast the ray origin + t direction, 0 &lt;= t &lt;= max, against a shape.
     *  param: position, orientation  of the shape: [3] m, [4] x, y, z, w
     *  param: origin [3] m   param: direction [3] m per unit of t, any length; zero asks whether the origin is inside
     *  param: max    &gt;= 0, may be infinite
     *  param: desc   may be NULL: defaults     param: result struct_size set by the caller
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; UNSUPPORTED */
    public static int carom_ray_cast(MemorySegment engine, long shape, MemorySegment position, MemorySegment orientation, MemorySegment origin, MemorySegment direction, double max, MemorySegment desc, MemorySegment result, MemorySegment error) {
        try { return (int) carom_ray_cast_.CALL.invokeExact(engine, shape, position, orientation, origin, direction, max, desc, result, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_shape_cast_ {
        static final MethodHandle CALL = Library.call("carom_shape_cast", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS, ADDRESS, ADDRESS, ADDRESS));
    }
    /** Move shape A along a straight line, without turning it, until it touches B.
     *  param: motion [3] m, of A; times are fractions of it. If B moves too: the difference of the two
     *  param: desc   may be NULL: defaults     param: result struct_size set by the caller
     *  param: position_* [3] m, world   param: orientation_* [4] x, y, z, w
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; UNSUPPORTED (two
     *          half-spaces) */
    public static int carom_shape_cast(MemorySegment engine, long shapeA, MemorySegment positionA, MemorySegment orientationA, MemorySegment motion, long shapeB, MemorySegment positionB, MemorySegment orientationB, MemorySegment desc, MemorySegment result, MemorySegment error) {
        try { return (int) carom_shape_cast_.CALL.invokeExact(engine, shapeA, positionA, orientationA, motion, shapeB, positionB, orientationB, desc, result, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_shape_time_of_impact_ {
        static final MethodHandle CALL = Library.call("carom_shape_time_of_impact", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, JAVA_LONG, ADDRESS, JAVA_DOUBLE, ADDRESS, ADDRESS, ADDRESS));
    }
    /** First contact of two shapes that both travel and turn, within a duration. UNDECIDED: the cap came first, nothing
     *  touches before `lower`.
     *  param: motion_*  struct_size set by carom_motion_init()   param: duration s, 0 to 1e9
     *  param: desc   may be NULL: defaults     param: result struct_size set by the caller; times in s
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE;
     *          UNSUPPORTED (two half-spaces, or one that turns) */
    public static int carom_shape_time_of_impact(MemorySegment engine, long shapeA, MemorySegment motionA, long shapeB, MemorySegment motionB, double duration, MemorySegment desc, MemorySegment result, MemorySegment error) {
        try { return (int) carom_shape_time_of_impact_.CALL.invokeExact(engine, shapeA, motionA, shapeB, motionB, duration, desc, result, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_shape_overlap_ {
        static final MethodHandle CALL = Library.call("carom_shape_overlap", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS, ADDRESS, ADDRESS, ADDRESS));
    }
    /** Do two shapes overlap (or come nearer than desc-&gt;target)? Cheaper than their distance, with a proof of yes or no.
     *  param: desc   may be NULL: defaults; tolerance is not used   param: result struct_size set by the caller
     *  param: position_* [3] m, world   param: orientation_* [4] x, y, z, w
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; UNSUPPORTED (two
     *          half-spaces) */
    public static int carom_shape_overlap(MemorySegment engine, long shapeA, MemorySegment positionA, MemorySegment orientationA, long shapeB, MemorySegment positionB, MemorySegment orientationB, MemorySegment desc, MemorySegment result, MemorySegment error) {
        try { return (int) carom_shape_overlap_.CALL.invokeExact(engine, shapeA, positionA, orientationA, shapeB, positionB, orientationB, desc, result, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_rays_cast_ {
        static final MethodHandle CALL = Library.call("carom_rays_cast", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, ADDRESS, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS, ADDRESS, ADDRESS));
    }
    /** Cast many rays against one or more shapes: the first hit of each. A bad ray, or one for which a support function
     *  misbehaves (status CAROM_QUERY_FAULT, that of `shape`), spoils no other. Nothing is allocated per ray.
     *  param: shapes [shape_count]   param: positions [3 shape_count] m   param: orientations [4 shape_count] x, y, z, w
     *  param: desc   may be NULL: defaults
     *  param: shape_count number of shapes
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; UNKNOWN_ENUM; UNSUPPORTED;
     *          BUFFER_TOO_SMALL (a stride); LIMIT (2^32 - 1 shapes); OUT_OF_MEMORY */
    public static int carom_rays_cast(MemorySegment engine, MemorySegment shapes, MemorySegment positions, MemorySegment orientations, long shapeCount, MemorySegment rays, MemorySegment desc, MemorySegment hits, MemorySegment error) {
        try { return (int) carom_rays_cast_.CALL.invokeExact(engine, shapes, positions, orientations, shapeCount, rays, desc, hits, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_character_desc_init_ {
        static final MethodHandle CALL = Library.call("carom_character_desc_init", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_INT));
    }
    /** status: OK; NULL_ARGUMENT; STRUCT_SIZE */
    public static int carom_character_desc_init(MemorySegment desc, int structSize) {
        try { return (int) carom_character_desc_init_.CALL.invokeExact(desc, structSize); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_character_init_ {
        static final MethodHandle CALL = Library.call("carom_character_init", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_INT));
    }
    /** At the origin, in the air, without a shape.   status: OK; NULL_ARGUMENT; STRUCT_SIZE */
    public static int carom_character_init(MemorySegment character, int structSize) {
        try { return (int) carom_character_init_.CALL.invokeExact(character, structSize); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_character_set_shape_ {
        static final MethodHandle CALL = Library.call("carom_character_set_shape", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, ADDRESS, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** Give it a shape, or another one: to crouch, to stand up. The lowest point stays where it is, so the origin moves
     *  along `up`. With `fits` the new shape is looked at first. If something is within half the skin of it, `fits` becomes
     *  0 and nothing changes. Call it again after `up` has changed against the shape.
     *  param: shape convex, of the world's engine: most take a capsule
     *  param: desc may be NULL: defaults
     *  param: character its shape, position, foot, head and reach change
     *  param: fits out: 1 or 0; NULL: it is changed whatever is there, and a later move brings it out
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED (a half-space, scenery; unknown bits); UNKNOWN_ENUM; *_HANDLE;
     *          NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; PLUGIN_INVALID; BUSY; REENTRANT; OUT_OF_MEMORY   thread: reader */
    public static int carom_character_set_shape(MemorySegment engine, MemorySegment world, MemorySegment desc, MemorySegment character, long shape, MemorySegment fits, MemorySegment error) {
        try { return (int) carom_character_set_shape_.CALL.invokeExact(engine, world, desc, character, shape, fits, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_character_move_ {
        static final MethodHandle CALL = Library.call("carom_character_move", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, ADDRESS, ADDRESS, JAVA_DOUBLE, JAVA_DOUBLE, ADDRESS));
    }
    /** Move a character by dt. In this order: it follows the ground that it stood on, leaves what it overlaps, then walks,
     *  jumps or falls.
     *  
     *  On firm ground its velocity across `up` follows `walk`, on slopes and steps, too. In the air and on steep ground it
     *  follows `walk` plus the velocity of the ground that it left. Paths in the air are exact parabolas, so where it lands
     *  does not depend on dt beyond one dt's way. On open ground a move takes three queries, in a corner about ten. It
     *  allocates nothing but what queries do.
     *  param: desc may be NULL: defaults
     *  param: character all but shape, foot, head and reach may change
     *  param: walk [3] m/s, world, each within 1e6: what it is to move at, relative to the ground; the part along `up`
     *         counts only with CAROM_CHARACTER_FLIES
     *  param: jump m/s, [0, 1e6], along `up`: on firm ground it takes off at this speed, and takes the velocity of the
     *         ground with it; else, and with 0, it does not
     *  param: dt s, [0, 1]
     *  accuracy: stands `skin` and 2 % from surfaces, within 1e-5 m or 1e-6 of its size
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED (unknown bits, reserved); UNKNOWN_ENUM; *_HANDLE (desc-&gt;body;
     *          character-&gt;shape: call carom_character_set_shape() first); NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; BUSY;
     *          REENTRANT; OUT_OF_MEMORY
     *  thread: reader */
    public static int carom_character_move(MemorySegment world, MemorySegment desc, MemorySegment character, MemorySegment walk, double jump, double dt, MemorySegment error) {
        try { return (int) carom_character_move_.CALL.invokeExact(world, desc, character, walk, jump, dt, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_character_push_ {
        static final MethodHandle CALL = Library.call("carom_character_push", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, ADDRESS, JAVA_DOUBLE, ADDRESS));
    }
    /** Push what the last move met, and press on what the character stands on, as forces of the next step. A dynamic body
     *  in its way gets the force that would bring it to the character's speed within dt, push_force at most. One under
     *  firm feet gets mass * gravity. Bodies that are gone are left out.
     *  param: desc may be NULL: defaults   param: character as the last move left it   param: dt s, [1e-9, 1], of the next
     *  step
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; UNKNOWN_ENUM; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE;
     *          BUSY; REENTRANT; OUT_OF_MEMORY */
    public static int carom_character_push(MemorySegment world, MemorySegment desc, MemorySegment character, double dt, MemorySegment error) {
        try { return (int) carom_character_push_.CALL.invokeExact(world, desc, character, dt, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_character_move_body_ {
        static final MethodHandle CALL = Library.call("carom_character_move_body", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, ADDRESS, JAVA_DOUBLE, ADDRESS));
    }
    /** Let a kinematic body of the host's follow the character, so that other bodies and characters touch it. It gets the
     *  velocity that brings it to the character's place in the next step of dt. Where that is over 1 m away, or the
     *  character has turned, it is placed there at once, at rest. Give the body the character's shape, and name it in
     *  desc-&gt;body.
     *  param: desc with a body   param: dt s, [1e-9, 1], of the next step
     *  param: character as the last move left it
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; UNKNOWN_ENUM; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE
     *          (also: a body that is not kinematic); BUSY; REENTRANT; OUT_OF_MEMORY */
    public static int carom_character_move_body(MemorySegment world, MemorySegment desc, MemorySegment character, double dt, MemorySegment error) {
        try { return (int) carom_character_move_body_.CALL.invokeExact(world, desc, character, dt, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_dial_get_info_ {
        static final MethodHandle CALL = Library.call("carom_dial_get_info", FunctionDescriptor.of(JAVA_INT, JAVA_INT, ADDRESS, ADDRESS));
    }
    /** status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM (dial &gt;= CAROM_DIAL_COUNT of this library) */
    public static int carom_dial_get_info(int dial, MemorySegment info, MemorySegment error) {
        try { return (int) carom_dial_get_info_.CALL.invokeExact(dial, info, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_dial_get_count_ {
        static final MethodHandle CALL = Library.call("carom_dial_get_count", FunctionDescriptor.of(JAVA_INT, ADDRESS));
    }
    /** Number of dials this library has.   status: OK; NULL_ARGUMENT */
    public static int carom_dial_get_count(MemorySegment count) {
        try { return (int) carom_dial_get_count_.CALL.invokeExact(count); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_dial_find_ {
        static final MethodHandle CALL = Library.call("carom_dial_find", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, ADDRESS));
    }
    /** param: name as in carom_dial_info.name
     *  status: OK; NULL_ARGUMENT; NOT_FOUND; READ_ONLY (this is a constant, not a dial) */
    public static int carom_dial_find(MemorySegment name, MemorySegment dial, MemorySegment error) {
        try { return (int) carom_dial_find_.CALL.invokeExact(name, dial, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_constant_get_count_ {
        static final MethodHandle CALL = Library.call("carom_constant_get_count", FunctionDescriptor.of(JAVA_INT, ADDRESS));
    }
    /** Number of constants this library has.   status: OK; NULL_ARGUMENT */
    public static int carom_constant_get_count(MemorySegment count) {
        try { return (int) carom_constant_get_count_.CALL.invokeExact(count); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_constant_get_info_ {
        static final MethodHandle CALL = Library.call("carom_constant_get_info", FunctionDescriptor.of(JAVA_INT, JAVA_INT, ADDRESS, ADDRESS));
    }
    /** param: constant from 0   param: info out
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM (constant &gt;= carom_constant_get_count()) */
    public static int carom_constant_get_info(int constant, MemorySegment info, MemorySegment error) {
        try { return (int) carom_constant_get_info_.CALL.invokeExact(constant, info, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_preset_name_ {
        static final MethodHandle CALL = Library.call("carom_preset_name", FunctionDescriptor.of(ADDRESS, JAVA_INT));
    }
    /** Static name of a preset ("balanced"), or "?".
     *  param: preset CAROM_PRESET_* */
    public static String carom_preset_name(int preset) {
        try { return ((MemorySegment) carom_preset_name_.CALL.invokeExact(preset)).reinterpret(Long.MAX_VALUE).getString(0); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_preset_get_dial_ {
        static final MethodHandle CALL = Library.call("carom_preset_get_dial", FunctionDescriptor.of(JAVA_INT, JAVA_INT, JAVA_INT, ADDRESS, ADDRESS));
    }
    /** What a preset sets a dial to. Presets speak of dials that trade accuracy for time, and all of the same ones; how a
     *  world finds pairs, what sleeps, and what a host chose for its look they leave alone.
     *  param: preset CAROM_PRESET_*   param: dial CAROM_DIAL_*   param: value out
     *  param: value what the preset sets the dial to
     *  status: OK; NULL_ARGUMENT; UNKNOWN_ENUM; NOT_FOUND (presets leave this dial alone) */
    public static int carom_preset_get_dial(int preset, int dial, MemorySegment value, MemorySegment error) {
        try { return (int) carom_preset_get_dial_.CALL.invokeExact(preset, dial, value, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_draw_desc_init_ {
        static final MethodHandle CALL = Library.call("carom_draw_desc_init", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_INT));
    }
    /** status: OK; NULL_ARGUMENT; STRUCT_SIZE */
    public static int carom_draw_desc_init(MemorySegment desc, int structSize) {
        try { return (int) carom_draw_desc_init_.CALL.invokeExact(desc, structSize); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_world_draw_ {
        static final MethodHandle CALL = Library.call("carom_world_draw", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, ADDRESS, JAVA_LONG, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** All lines of the kinds that desc names, kind by kind in the order of the bits. Shapes whose support function fails
     *  are left out, and so are bodies in quarantine. The same world gives the same lines.
     *  param: desc     NULL: defaults
     *  param: dst      [capacity] elements `stride` bytes apart (0: sizeof(carom_draw_line)), or NULL to count
     *  param: count    out: lines there are; more than capacity: the first `capacity` of them were written
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED (a bit of what, reserved); UNKNOWN_ENUM; NOT_FINITE,
     *          OUT_OF_RANGE (scale); BUFFER_TOO_SMALL (stride); BUSY; REENTRANT; OUT_OF_MEMORY
     *  thread: reader */
    public static int carom_world_draw(MemorySegment world, MemorySegment desc, MemorySegment dst, long stride, long capacity, MemorySegment count, MemorySegment error) {
        try { return (int) carom_world_draw_.CALL.invokeExact(world, desc, dst, stride, capacity, count, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_engine_desc_init_ {
        static final MethodHandle CALL = Library.call("carom_engine_desc_init", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_INT));
    }
    /** status: OK; NULL_ARGUMENT; STRUCT_SIZE */
    public static int carom_engine_desc_init(MemorySegment desc, int structSize) {
        try { return (int) carom_engine_desc_init_.CALL.invokeExact(desc, structSize); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_engine_create_ {
        static final MethodHandle CALL = Library.call("carom_engine_create", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, ADDRESS));
    }
    /** Make an engine. param: desc may be NULL: defaults.   owns: the caller: carom_engine_destroy()
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; LIMIT (65,535 engines and worlds in all); OUT_OF_MEMORY */
    public static int carom_engine_create(MemorySegment desc, MemorySegment engine, MemorySegment error) {
        try { return (int) carom_engine_create_.CALL.invokeExact(desc, engine, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_engine_destroy_ {
        static final MethodHandle CALL = Library.call("carom_engine_destroy", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS));
    }
    /** Destroy an engine; its worlds, batches and devices must be gone.   status: OK; NULL_ARGUMENT; IN_USE (destroy its worlds, batches and devices first);
     *  REENTRANT   thread: writer: no other call may use the engine */
    public static int carom_engine_destroy(MemorySegment engine, MemorySegment error) {
        try { return (int) carom_engine_destroy_.CALL.invokeExact(engine, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_jobs_desc_init_ {
        static final MethodHandle CALL = Library.call("carom_jobs_desc_init", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_INT));
    }
    /** status: OK; NULL_ARGUMENT; STRUCT_SIZE */
    public static int carom_jobs_desc_init(MemorySegment desc, int structSize) {
        try { return (int) carom_jobs_desc_init_.CALL.invokeExact(desc, structSize); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_engine_set_jobs_ {
        static final MethodHandle CALL = Library.call("carom_engine_set_jobs", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, ADDRESS));
    }
    /** Say which threads share the work of steps in the engine's worlds, before the first of them is made. Support
     *  functions are then called, and the allocator may be, on those threads; those of HOST_THREAD plugins are still called
     *  on the stepping one.
     *  param: desc may be NULL: the stepping thread alone
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; OUT_OF_RANGE; IN_USE (worlds, batches or devices are
     *  alive, or carom_pairs_distance() is under way); LIMIT (the system has no more threads); OUT_OF_MEMORY; REENTRANT */
    public static int carom_engine_set_jobs(MemorySegment engine, MemorySegment desc, MemorySegment error) {
        try { return (int) carom_engine_set_jobs_.CALL.invokeExact(engine, desc, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_plugin_load_ {
        static final MethodHandle CALL = Library.call("carom_plugin_load", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, ADDRESS, ADDRESS));
    }
    /** Load a shape plugin from a shared object. param: path absolute.
     *  The plugin is checked before anything is called, then by its support points in 256 directions, with parameters that
     *  the bounds allow. Loading the same path twice is ALREADY_EXISTS.
     *  status: OK; NULL_ARGUMENT; PLUGIN_PATH; PLUGIN_LOAD; PLUGIN_ABI; PLUGIN_INVALID; ALREADY_EXISTS; OUT_OF_MEMORY */
    public static int carom_plugin_load(MemorySegment engine, MemorySegment path, MemorySegment plugin, MemorySegment error) {
        try { return (int) carom_plugin_load_.CALL.invokeExact(engine, path, plugin, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_plugin_register_ {
        static final MethodHandle CALL = Library.call("carom_plugin_register", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, ADDRESS, ADDRESS));
    }
    /** Register a plugin by pointer: static linking, WebAssembly, or a shape written in the host's language.
     *  The struct and all it points to must outlive the engine.   status: as carom_plugin_load() */
    public static int carom_plugin_register(MemorySegment engine, MemorySegment description, MemorySegment plugin, MemorySegment error) {
        try { return (int) carom_plugin_register_.CALL.invokeExact(engine, description, plugin, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_plugins_register_standard_ {
        static final MethodHandle CALL = Library.call("carom_plugins_register_standard", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS));
    }
    /** Register the plugins of plugins/ that are linked into the library: in an archive (carom::carom_static), in
     *  WebAssembly, and where it was built with CAROM_LINK_SHAPES. Those that the engine has already are left as they are.
     *  status: OK; NULL_ARGUMENT; UNSUPPORTED (none is linked in: load files, or name shapes); LIMIT; OUT_OF_MEMORY */
    public static int carom_plugins_register_standard(MemorySegment engine, MemorySegment error) {
        try { return (int) carom_plugins_register_standard_.CALL.invokeExact(engine, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_plugin_unload_ {
        static final MethodHandle CALL = Library.call("carom_plugin_unload", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS));
    }
    /** Forget a plugin (logically: the code stays mapped).   status: OK; NULL_ARGUMENT; IN_USE (shapes of it live);
     *  *_HANDLE; REENTRANT */
    public static int carom_plugin_unload(MemorySegment engine, long plugin, MemorySegment error) {
        try { return (int) carom_plugin_unload_.CALL.invokeExact(engine, plugin, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_plugin_find_ {
        static final MethodHandle CALL = Library.call("carom_plugin_find", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, ADDRESS, ADDRESS));
    }
    /** Find a loaded plugin by its id.
     *  param: id as in carom_shape_plugin.id
     *  status: OK; NULL_ARGUMENT; NOT_FOUND (load it first) */
    public static int carom_plugin_find(MemorySegment engine, MemorySegment id, MemorySegment plugin, MemorySegment error) {
        try { return (int) carom_plugin_find_.CALL.invokeExact(engine, id, plugin, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_plugin_describe_ {
        static final MethodHandle CALL = Library.call("carom_plugin_describe", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** The plugin's own description, as its author compiled it: documentation, declarations, function. Only fields within
     *  its struct_size are there. Valid while the engine lives.
     *  status: OK; NULL_ARGUMENT; *_HANDLE */
    public static int carom_plugin_describe(MemorySegment engine, long plugin, MemorySegment description, MemorySegment error) {
        try { return (int) carom_plugin_describe_.CALL.invokeExact(engine, plugin, description, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_world_collect_events_ {
        static final MethodHandle CALL = Library.call("carom_world_collect_events", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_INT, JAVA_DOUBLE, ADDRESS));
    }
    /** Say what to collect from the next step on; nothing at first. Contacts and overlaps that there are already begin in
     *  that step.
     *  param: kinds     CAROM_EVENTS_* bits; 0: nothing
     *  param: hit_speed m/s, [0, 1e9]: contacts that approach faster are hits
     *  status: OK; NULL_ARGUMENT; UNSUPPORTED (kinds); NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT; OUT_OF_MEMORY */
    public static int carom_world_collect_events(MemorySegment world, int kinds, double hitSpeed, MemorySegment error) {
        try { return (int) carom_world_collect_events_.CALL.invokeExact(world, kinds, hitSpeed, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_world_get_contact_events_ {
        static final MethodHandle CALL = Library.call("carom_world_get_contact_events", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, JAVA_LONG, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** Copy them out, by the slots of the two colliders; of one pair END before BEGIN before HIT.
     *  param: dst      [capacity] elements `stride` bytes apart; may be NULL if capacity is 0
     *  param: stride   sizeof(carom_contact_event) as the caller knows it
     *  param: count    out: how many there are (may exceed capacity; capacity are written)
     *  status: OK; NULL_ARGUMENT; BUFFER_TOO_SMALL; OUT_OF_RANGE (stride); BUSY */
    public static int carom_world_get_contact_events(MemorySegment world, MemorySegment dst, long stride, long capacity, MemorySegment count, MemorySegment error) {
        try { return (int) carom_world_get_contact_events_.CALL.invokeExact(world, dst, stride, capacity, count, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_world_get_sensor_events_ {
        static final MethodHandle CALL = Library.call("carom_world_get_sensor_events", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, JAVA_LONG, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** Arguments as carom_world_get_contact_events(). */
    public static int carom_world_get_sensor_events(MemorySegment world, MemorySegment dst, long stride, long capacity, MemorySegment count, MemorySegment error) {
        try { return (int) carom_world_get_sensor_events_.CALL.invokeExact(world, dst, stride, capacity, count, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_world_get_sleep_events_ {
        static final MethodHandle CALL = Library.call("carom_world_get_sleep_events", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, JAVA_LONG, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** By the slots of the bodies; arguments as carom_world_get_contact_events(). */
    public static int carom_world_get_sleep_events(MemorySegment world, MemorySegment dst, long stride, long capacity, MemorySegment count, MemorySegment error) {
        try { return (int) carom_world_get_sleep_events_.CALL.invokeExact(world, dst, stride, capacity, count, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_world_get_joint_events_ {
        static final MethodHandle CALL = Library.call("carom_world_get_joint_events", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, JAVA_LONG, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** By the slots of the joints; arguments as carom_world_get_contact_events(). */
    public static int carom_world_get_joint_events(MemorySegment world, MemorySegment dst, long stride, long capacity, MemorySegment count, MemorySegment error) {
        try { return (int) carom_world_get_joint_events_.CALL.invokeExact(world, dst, stride, capacity, count, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_world_get_fault_events_ {
        static final MethodHandle CALL = Library.call("carom_world_get_fault_events", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, JAVA_LONG, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** As they happened; arguments as carom_world_get_contact_events(). */
    public static int carom_world_get_fault_events(MemorySegment world, MemorySegment dst, long stride, long capacity, MemorySegment count, MemorySegment error) {
        try { return (int) carom_world_get_fault_events_.CALL.invokeExact(world, dst, stride, capacity, count, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_collider_set_filter_ {
        static final MethodHandle CALL = Library.call("carom_collider_set_filter", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_INT, ADDRESS));
    }
    /** Two colliders of different bodies touch if each one's mask has a bit of the other's category; unless both are of one
     *  group other than 0: then they do if it is positive and do not if it is negative, whatever their masks say.
     *  param: category, mask  any bits   param: group 0: none
     *  status: OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT; OUT_OF_MEMORY */
    public static int carom_collider_set_filter(MemorySegment world, long collider, long category, long mask, int group, MemorySegment error) {
        try { return (int) carom_collider_set_filter_.CALL.invokeExact(world, collider, category, mask, group, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_collider_get_filter_ {
        static final MethodHandle CALL = Library.call("carom_collider_get_filter", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS, ADDRESS, ADDRESS));
    }
    /** param: category, mask, group  out   status: OK; NULL_ARGUMENT; *_HANDLE; BUSY */
    public static int carom_collider_get_filter(MemorySegment world, long collider, MemorySegment category, MemorySegment mask, MemorySegment group, MemorySegment error) {
        try { return (int) carom_collider_get_filter_.CALL.invokeExact(world, collider, category, mask, group, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_body_set_filter_ {
        static final MethodHandle CALL = Library.call("carom_body_set_filter", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, JAVA_LONG, JAVA_LONG, JAVA_INT, ADDRESS));
    }
    /** The same for all colliders that a body has now.   status: as carom_collider_set_filter() */
    public static int carom_body_set_filter(MemorySegment world, long body, long category, long mask, int group, MemorySegment error) {
        try { return (int) carom_body_set_filter_.CALL.invokeExact(world, body, category, mask, group, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_body_ignore_collision_ {
        static final MethodHandle CALL = Library.call("carom_body_ignore_collision", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, JAVA_LONG, JAVA_INT, ADDRESS));
    }
    /** Let two bodies make no contacts with each other, whatever their filters say, or restore their contacts. Calls are
     *  counted: undo each one. Undoing more does nothing.
     *  param: ignored 1 or 0
     *  status: OK; NULL_ARGUMENT; *_HANDLE; OUT_OF_RANGE (ignored; a body and itself); BUSY; REENTRANT; OUT_OF_MEMORY */
    public static int carom_body_ignore_collision(MemorySegment world, long bodyA, long bodyB, int ignored, MemorySegment error) {
        try { return (int) carom_body_ignore_collision_.CALL.invokeExact(world, bodyA, bodyB, ignored, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_collider_set_sensor_ {
        static final MethodHandle CALL = Library.call("carom_collider_set_sensor", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, JAVA_INT, ADDRESS));
    }
    /** Make a collider a sensor: it reports what overlaps it (carom_world_get_sensor_events()) and is touched by nothing.
     *  It obeys its filter, does not sense other sensors, and static sensors do not sense static bodies. Its density counts
     *  as before.
     *  param: sensor 1 or 0
     *  status: OK; NULL_ARGUMENT; *_HANDLE; OUT_OF_RANGE (sensor); BUSY; REENTRANT; OUT_OF_MEMORY */
    public static int carom_collider_set_sensor(MemorySegment world, long collider, int sensor, MemorySegment error) {
        try { return (int) carom_collider_set_sensor_.CALL.invokeExact(world, collider, sensor, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_collider_is_sensor_ {
        static final MethodHandle CALL = Library.call("carom_collider_is_sensor", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** param: sensor out: 1 or 0   status: OK; NULL_ARGUMENT; *_HANDLE; BUSY */
    public static int carom_collider_is_sensor(MemorySegment world, long collider, MemorySegment sensor, MemorySegment error) {
        try { return (int) carom_collider_is_sensor_.CALL.invokeExact(world, collider, sensor, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_body_add_force_at_ {
        static final MethodHandle CALL = Library.call("carom_body_add_force_at", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS, ADDRESS));
    }
    /** Add a force that acts at a point, for the next step only: carom_body_add_force() with its torque about the centre of
     *  mass as the body stands now.
     *  param: force [3] N, world   param: point [3] m, world
     *  status: OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE (the sum would overflow); BUSY; REENTRANT */
    public static int carom_body_add_force_at(MemorySegment world, long body, MemorySegment force, MemorySegment point, MemorySegment error) {
        try { return (int) carom_body_add_force_at_.CALL.invokeExact(world, body, force, point, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_body_set_drag_ {
        static final MethodHandle CALL = Library.call("carom_body_set_drag", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, JAVA_DOUBLE, JAVA_DOUBLE, ADDRESS));
    }
    /** How air resists a body: F = -(linear + quadratic |u|) u at its centre, u its velocity relative to the air. Without
     *  other forces speeds follow the closed form at any step. (carom_body_desc.linear_damping is relative to the world,
     *  not to the air, and to mass.)
     *  param: linear    kg/s, [0, 1e12]: slow, small bodies (6 pi eta r of a ball); 0 when a body is created
     *  param: quadratic kg/m, [0, 1e12]: fast, large ones, rho c_d A / 2 (a ball of 0.1 m in air: 0.0087); 0 likewise
     *  status: OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT; OUT_OF_MEMORY */
    public static int carom_body_set_drag(MemorySegment world, long body, double linear, double quadratic, MemorySegment error) {
        try { return (int) carom_body_set_drag_.CALL.invokeExact(world, body, linear, quadratic, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_body_get_drag_ {
        static final MethodHandle CALL = Library.call("carom_body_get_drag", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS, ADDRESS));
    }
    /** param: linear, quadratic out   status: OK; NULL_ARGUMENT; *_HANDLE; BUSY */
    public static int carom_body_get_drag(MemorySegment world, long body, MemorySegment linear, MemorySegment quadratic, MemorySegment error) {
        try { return (int) carom_body_get_drag_.CALL.invokeExact(world, body, linear, quadratic, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_world_set_wind_ {
        static final MethodHandle CALL = Library.call("carom_world_set_wind", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, ADDRESS));
    }
    /** How the air moves; it reaches bodies through their drag alone.
     *  param: velocity [3] m/s, |each| &lt;= 1e6; 0 when a world is created
     *  status: OK; NULL_ARGUMENT; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT */
    public static int carom_world_set_wind(MemorySegment world, MemorySegment velocity, MemorySegment error) {
        try { return (int) carom_world_set_wind_.CALL.invokeExact(world, velocity, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_world_get_wind_ {
        static final MethodHandle CALL = Library.call("carom_world_get_wind", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, ADDRESS));
    }
    /** status: OK; NULL_ARGUMENT; BUSY */
    public static int carom_world_get_wind(MemorySegment world, MemorySegment velocity, MemorySegment error) {
        try { return (int) carom_world_get_wind_.CALL.invokeExact(world, velocity, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_force_field_name_ {
        static final MethodHandle CALL = Library.call("carom_force_field_name", FunctionDescriptor.of(ADDRESS, JAVA_INT));
    }
    /** Static name of a kind of field ("uniform"), or "?".
     *  param: kind CAROM_FORCE_FIELD_* */
    public static String carom_force_field_name(int kind) {
        try { return ((MemorySegment) carom_force_field_name_.CALL.invokeExact(kind)).reinterpret(Long.MAX_VALUE).getString(0); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_force_field_desc_init_ {
        static final MethodHandle CALL = Library.call("carom_force_field_desc_init", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_INT));
    }
    /** status: OK; NULL_ARGUMENT; STRUCT_SIZE */
    public static int carom_force_field_desc_init(MemorySegment desc, int structSize) {
        try { return (int) carom_force_field_desc_init_.CALL.invokeExact(desc, structSize); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_force_field_create_ {
        static final MethodHandle CALL = Library.call("carom_force_field_create", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, ADDRESS, ADDRESS));
    }
    /** status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; UNKNOWN_ENUM; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; BUSY;
     *          REENTRANT; LIMIT; OUT_OF_MEMORY */
    public static int carom_force_field_create(MemorySegment world, MemorySegment desc, MemorySegment field, MemorySegment error) {
        try { return (int) carom_force_field_create_.CALL.invokeExact(world, desc, field, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_force_field_update_ {
        static final MethodHandle CALL = Library.call("carom_force_field_update", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** Change a field in place: move it, turn it up.   status: as carom_force_field_create(); *_HANDLE */
    public static int carom_force_field_update(MemorySegment world, long field, MemorySegment desc, MemorySegment error) {
        try { return (int) carom_force_field_update_.CALL.invokeExact(world, field, desc, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_force_field_get_ {
        static final MethodHandle CALL = Library.call("carom_force_field_get", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** status: OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; BUSY */
    public static int carom_force_field_get(MemorySegment world, long field, MemorySegment desc, MemorySegment error) {
        try { return (int) carom_force_field_get_.CALL.invokeExact(world, field, desc, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_force_field_destroy_ {
        static final MethodHandle CALL = Library.call("carom_force_field_destroy", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS));
    }
    /** status: OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT */
    public static int carom_force_field_destroy(MemorySegment world, long field, MemorySegment error) {
        try { return (int) carom_force_field_destroy_.CALL.invokeExact(world, field, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_body_set_force_field_mask_ {
        static final MethodHandle CALL = Library.call("carom_body_set_force_field_mask", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, JAVA_INT, ADDRESS));
    }
    /** Which fields a body feels. A field with a bit that few bodies have costs those few.
     *  param: mask 1 when a body is created; 0: none
     *  status: OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT; OUT_OF_MEMORY */
    public static int carom_body_set_force_field_mask(MemorySegment world, long body, int mask, MemorySegment error) {
        try { return (int) carom_body_set_force_field_mask_.CALL.invokeExact(world, body, mask, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_body_get_force_field_mask_ {
        static final MethodHandle CALL = Library.call("carom_body_get_force_field_mask", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** status: OK; NULL_ARGUMENT; *_HANDLE; BUSY */
    public static int carom_body_get_force_field_mask(MemorySegment world, long body, MemorySegment mask, MemorySegment error) {
        try { return (int) carom_body_get_force_field_mask_.CALL.invokeExact(world, body, mask, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_spring_desc_init_ {
        static final MethodHandle CALL = Library.call("carom_spring_desc_init", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_INT));
    }
    /** status: OK; NULL_ARGUMENT; STRUCT_SIZE */
    public static int carom_spring_desc_init(MemorySegment desc, int structSize) {
        try { return (int) carom_spring_desc_init_.CALL.invokeExact(desc, structSize); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_spring_create_ {
        static final MethodHandle CALL = Library.call("carom_spring_create", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, ADDRESS, ADDRESS));
    }
    /** status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT; LIMIT;
     *          OUT_OF_MEMORY */
    public static int carom_spring_create(MemorySegment world, MemorySegment desc, MemorySegment spring, MemorySegment error) {
        try { return (int) carom_spring_create_.CALL.invokeExact(world, desc, spring, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_spring_update_ {
        static final MethodHandle CALL = Library.call("carom_spring_update", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, JAVA_DOUBLE, JAVA_DOUBLE, JAVA_DOUBLE, ADDRESS));
    }
    /** Change what a spring is like; its ends stay.
     *  param: rest m   param: stiffness N/m   param: damping N s/m; ranges as in carom_spring_desc
     *  status: OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT */
    public static int carom_spring_update(MemorySegment world, long spring, double rest, double stiffness, double damping, MemorySegment error) {
        try { return (int) carom_spring_update_.CALL.invokeExact(world, spring, rest, stiffness, damping, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_spring_get_ {
        static final MethodHandle CALL = Library.call("carom_spring_get", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** status: OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; BUSY */
    public static int carom_spring_get(MemorySegment world, long spring, MemorySegment desc, MemorySegment error) {
        try { return (int) carom_spring_get_.CALL.invokeExact(world, spring, desc, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_spring_get_state_ {
        static final MethodHandle CALL = Library.call("carom_spring_get_state", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS, ADDRESS));
    }
    /** param: length out: m, as its ends stand   param: force out: N, above 0 it pulls them together, as it is set
     *  status: OK; NULL_ARGUMENT; *_HANDLE; BUSY */
    public static int carom_spring_get_state(MemorySegment world, long spring, MemorySegment length, MemorySegment force, MemorySegment error) {
        try { return (int) carom_spring_get_state_.CALL.invokeExact(world, spring, length, force, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_spring_destroy_ {
        static final MethodHandle CALL = Library.call("carom_spring_destroy", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS));
    }
    /** Goes with its bodies, too.   status: OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT */
    public static int carom_spring_destroy(MemorySegment world, long spring, MemorySegment error) {
        try { return (int) carom_spring_destroy_.CALL.invokeExact(world, spring, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_water_init_ {
        static final MethodHandle CALL = Library.call("carom_water_init", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_INT));
    }
    /** status: OK; NULL_ARGUMENT; STRUCT_SIZE */
    public static int carom_water_init(MemorySegment water, int structSize) {
        try { return (int) carom_water_init_.CALL.invokeExact(water, structSize); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_world_set_water_ {
        static final MethodHandle CALL = Library.call("carom_world_set_water", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, ADDRESS));
    }
    /** param: water NULL: none, as a world is created
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; BUSY; REENTRANT */
    public static int carom_world_set_water(MemorySegment world, MemorySegment water, MemorySegment error) {
        try { return (int) carom_world_set_water_.CALL.invokeExact(world, water, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_world_get_water_ {
        static final MethodHandle CALL = Library.call("carom_world_get_water", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, ADDRESS, ADDRESS));
    }
    /** param: water out   param: present out: 1 or 0; if 0, water is filled with defaults
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; BUSY */
    public static int carom_world_get_water(MemorySegment world, MemorySegment water, MemorySegment present, MemorySegment error) {
        try { return (int) carom_world_get_water_.CALL.invokeExact(world, water, present, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_joint_kind_name_ {
        static final MethodHandle CALL = Library.call("carom_joint_kind_name", FunctionDescriptor.of(ADDRESS, JAVA_INT));
    }
    /** Static name of a kind of joint ("hinge", "six_axis"), or "?". Scene files and bindings have these names.
     *  param: kind CAROM_JOINT_* */
    public static String carom_joint_kind_name(int kind) {
        try { return ((MemorySegment) carom_joint_kind_name_.CALL.invokeExact(kind)).reinterpret(Long.MAX_VALUE).getString(0); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_joint_desc_init_ {
        static final MethodHandle CALL = Library.call("carom_joint_desc_init", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_INT));
    }
    /** status: OK; NULL_ARGUMENT; STRUCT_SIZE */
    public static int carom_joint_desc_init(MemorySegment desc, int structSize) {
        try { return (int) carom_joint_desc_init_.CALL.invokeExact(desc, structSize); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_joint_limit_init_ {
        static final MethodHandle CALL = Library.call("carom_joint_limit_init", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_INT));
    }
    /** Not enabled; a motor with speed 0 and max_force 0, which moves nothing until that is raised.
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE */
    public static int carom_joint_limit_init(MemorySegment limit, int structSize) {
        try { return (int) carom_joint_limit_init_.CALL.invokeExact(limit, structSize); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_joint_motor_init_ {
        static final MethodHandle CALL = Library.call("carom_joint_motor_init", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_INT));
    }
    /** Not enabled; a motor with speed 0 and max_force 0, which moves nothing until that is raised.
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE */
    public static int carom_joint_motor_init(MemorySegment motor, int structSize) {
        try { return (int) carom_joint_motor_init_.CALL.invokeExact(motor, structSize); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_joint_spring_init_ {
        static final MethodHandle CALL = Library.call("carom_joint_spring_init", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_INT));
    }
    /** Not enabled; a motor with speed 0 and max_force 0, which moves nothing until that is raised.
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE */
    public static int carom_joint_spring_init(MemorySegment spring, int structSize) {
        try { return (int) carom_joint_spring_init_.CALL.invokeExact(spring, structSize); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_joint_transmission_init_ {
        static final MethodHandle CALL = Library.call("carom_joint_transmission_init", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_INT));
    }
    /** Ratio 1, anchors at the origin, the rope as long as it is.   status: OK; NULL_ARGUMENT; STRUCT_SIZE */
    public static int carom_joint_transmission_init(MemorySegment transmission, int structSize) {
        try { return (int) carom_joint_transmission_init_.CALL.invokeExact(transmission, structSize); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_joint_coupling_init_ {
        static final MethodHandle CALL = Library.call("carom_joint_coupling_init", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_INT));
    }
    /** The follower goes as far as the leader.   status: OK; NULL_ARGUMENT; STRUCT_SIZE */
    public static int carom_joint_coupling_init(MemorySegment coupling, int structSize) {
        try { return (int) carom_joint_coupling_init_.CALL.invokeExact(coupling, structSize); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_joint_axis_init_ {
        static final MethodHandle CALL = Library.call("carom_joint_axis_init", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_INT));
    }
    /** Free, without drive and spring, `max_force` and limits as large as may be.   status: OK; NULL_ARGUMENT; STRUCT_SIZE */
    public static int carom_joint_axis_init(MemorySegment axis, int structSize) {
        try { return (int) carom_joint_axis_init_.CALL.invokeExact(axis, structSize); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_joint_orientation_drive_init_ {
        static final MethodHandle CALL = Library.call("carom_joint_orientation_drive_init", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_INT));
    }
    /** No drive, the target as the frames are when they agree.   status: OK; NULL_ARGUMENT; STRUCT_SIZE */
    public static int carom_joint_orientation_drive_init(MemorySegment drive, int structSize) {
        try { return (int) carom_joint_orientation_drive_init_.CALL.invokeExact(drive, structSize); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_joint_create_ {
        static final MethodHandle CALL = Library.call("carom_joint_create", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, ADDRESS, ADDRESS));
    }
    /** Join two bodies, or one and the world. Their islands wake. A body that is destroyed takes its joints with it.
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED (a newer field; solver severity; a coupling, which
     *          carom_joint_couple() makes); UNKNOWN_ENUM; *_HANDLE; NOT_UNIT;
     *          NOT_FINITE; OUT_OF_RANGE (also: a body joined to itself, none that is dynamic, or places 1e15 m from a
     *          body's origin or 8e15 m from each other, as of bodies that the next step will quarantine); BUSY; REENTRANT;
     *          LIMIT; OUT_OF_MEMORY */
    public static int carom_joint_create(MemorySegment world, MemorySegment desc, MemorySegment joint, MemorySegment error) {
        try { return (int) carom_joint_create_.CALL.invokeExact(world, desc, joint, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_joint_destroy_ {
        static final MethodHandle CALL = Library.call("carom_joint_destroy", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS));
    }
    /** status: OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT */
    public static int carom_joint_destroy(MemorySegment world, long joint, MemorySegment error) {
        try { return (int) carom_joint_destroy_.CALL.invokeExact(world, joint, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_joint_get_ {
        static final MethodHandle CALL = Library.call("carom_joint_get", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** param: desc out: as it was made, with frames in body coordinates
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; BUSY */
    public static int carom_joint_get(MemorySegment world, long joint, MemorySegment desc, MemorySegment error) {
        try { return (int) carom_joint_get_.CALL.invokeExact(world, joint, desc, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_joint_get_state_ {
        static final MethodHandle CALL = Library.call("carom_joint_get_state", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** status: OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; BUSY */
    public static int carom_joint_get_state(MemorySegment world, long joint, MemorySegment state, MemorySegment error) {
        try { return (int) carom_joint_get_state_.CALL.invokeExact(world, joint, state, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_joint_set_limit_ {
        static final MethodHandle CALL = Library.call("carom_joint_set_limit", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, JAVA_INT, ADDRESS, ADDRESS));
    }
    /** Set a limit, a motor, a spring of a coordinate that the joint's kind leaves free; its bodies wake.
     *  param: coordinate CAROM_COORDINATE_*
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; UNSUPPORTED (the kind has no such coordinate; a swing has a
     *          limit alone); *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT */
    public static int carom_joint_set_limit(MemorySegment world, long joint, int coordinate, MemorySegment limit, MemorySegment error) {
        try { return (int) carom_joint_set_limit_.CALL.invokeExact(world, joint, coordinate, limit, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_joint_set_motor_ {
        static final MethodHandle CALL = Library.call("carom_joint_set_motor", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, JAVA_INT, ADDRESS, ADDRESS));
    }
    /** Set a limit, a motor, a spring of a coordinate that the joint's kind leaves free; its bodies wake.
     *  param: coordinate CAROM_COORDINATE_*
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; UNSUPPORTED (the kind has no such coordinate; a swing has a
     *          limit alone); *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT */
    public static int carom_joint_set_motor(MemorySegment world, long joint, int coordinate, MemorySegment motor, MemorySegment error) {
        try { return (int) carom_joint_set_motor_.CALL.invokeExact(world, joint, coordinate, motor, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_joint_set_spring_ {
        static final MethodHandle CALL = Library.call("carom_joint_set_spring", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, JAVA_INT, ADDRESS, ADDRESS));
    }
    /** Set a limit, a motor, a spring of a coordinate that the joint's kind leaves free; its bodies wake.
     *  param: coordinate CAROM_COORDINATE_*
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; UNSUPPORTED (the kind has no such coordinate; a swing has a
     *          limit alone); *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT */
    public static int carom_joint_set_spring(MemorySegment world, long joint, int coordinate, MemorySegment spring, MemorySegment error) {
        try { return (int) carom_joint_set_spring_.CALL.invokeExact(world, joint, coordinate, spring, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_joint_get_limit_ {
        static final MethodHandle CALL = Library.call("carom_joint_get_limit", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, JAVA_INT, ADDRESS, ADDRESS));
    }
    /** status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; UNSUPPORTED; *_HANDLE; BUSY */
    public static int carom_joint_get_limit(MemorySegment world, long joint, int coordinate, MemorySegment limit, MemorySegment error) {
        try { return (int) carom_joint_get_limit_.CALL.invokeExact(world, joint, coordinate, limit, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_joint_get_motor_ {
        static final MethodHandle CALL = Library.call("carom_joint_get_motor", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, JAVA_INT, ADDRESS, ADDRESS));
    }
    /** status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; UNSUPPORTED; *_HANDLE; BUSY */
    public static int carom_joint_get_motor(MemorySegment world, long joint, int coordinate, MemorySegment motor, MemorySegment error) {
        try { return (int) carom_joint_get_motor_.CALL.invokeExact(world, joint, coordinate, motor, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_joint_get_spring_ {
        static final MethodHandle CALL = Library.call("carom_joint_get_spring", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, JAVA_INT, ADDRESS, ADDRESS));
    }
    /** status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; UNSUPPORTED; *_HANDLE; BUSY */
    public static int carom_joint_get_spring(MemorySegment world, long joint, int coordinate, MemorySegment spring, MemorySegment error) {
        try { return (int) carom_joint_get_spring_.CALL.invokeExact(world, joint, coordinate, spring, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_joint_set_transmission_ {
        static final MethodHandle CALL = Library.call("carom_joint_set_transmission", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** Say what a pulley's rope runs over, or how a gear's wheels turn; the bodies wake. What a limit, motor or spring on a
     *  pulley's distance requires is in metres of the rope. A gear holds from where its wheels stand now, as often as they
     *  may turn: turns are counted while it steps, as long as a wheel's speed changes by less than half a turn a substep in
     *  one; a pose that the host sets between steps is no turn.
     *  Accuracy: second order in the substep, as all joints; the rope's length errs by what joint_frequency leaves, and
     *  under the direct solver by 1e-9 m; a gear's angles err by rounding, a few 1e-16 rad a substep. Oracle:
     *  tests/oracle/test_pulley_gear.
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED (the joint is neither pulley nor gear; a newer field); *_HANDLE;
     *          NOT_FINITE; OUT_OF_RANGE (also: a ratio of 0; 1 is what the init function gives); BUSY; REENTRANT */
    public static int carom_joint_set_transmission(MemorySegment world, long joint, MemorySegment transmission, MemorySegment error) {
        try { return (int) carom_joint_set_transmission_.CALL.invokeExact(world, joint, transmission, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_joint_get_transmission_ {
        static final MethodHandle CALL = Library.call("carom_joint_get_transmission", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** param: transmission out: as it was set, with its length; ratio 0: not yet
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; *_HANDLE; BUSY */
    public static int carom_joint_get_transmission(MemorySegment world, long joint, MemorySegment transmission, MemorySegment error) {
        try { return (int) carom_joint_get_transmission_.CALL.invokeExact(world, joint, transmission, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_joint_couple_ {
        static final MethodHandle CALL = Library.call("carom_joint_couple", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, ADDRESS, ADDRESS));
    }
    /** Couple two joints: makes a joint of kind CAROM_JOINT_COUPLING, whose bodies are one of each joint's. Their islands
     *  wake. It goes with either joint that is destroyed, and holds nothing once one of them is broken. What it is off by,
     *  as it is made or because a host moves joints, is led back. It has no frames and never breaks itself.
     *  carom_joint_state of it: `gap` or `angle` is how far the follower is off; force is 0, torque[0] the N or N m along the
     *  follower's coordinate that it pushes with, mean over the last step.
     *  Accuracy: as of locks: second order in the substep, 1e-9 m or rad under the direct solver, rounding where dial
     *  joint_order moves it. Oracle: tests/oracle/test_couplings.
     *  param: joint out: the coupling
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED (a joint that is neither hinge nor slider; a newer field; a
     *          reserved one; solver severity); *_HANDLE; NOT_FINITE; OUT_OF_RANGE (also: a joint that follows itself); BUSY;
     *          REENTRANT; LIMIT; OUT_OF_MEMORY */
    public static int carom_joint_couple(MemorySegment world, MemorySegment coupling, MemorySegment joint, MemorySegment error) {
        try { return (int) carom_joint_couple_.CALL.invokeExact(world, coupling, joint, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_joint_set_coupling_ {
        static final MethodHandle CALL = Library.call("carom_joint_set_coupling", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** Give a coupling another polynomial; its bodies wake.
     *  param: coupling its follower and leader are CAROM_NULL_HANDLE or as they were, its user is not read
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED (the joint is no coupling; other joints than its own; a newer
     *          field; a reserved one); *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT */
    public static int carom_joint_set_coupling(MemorySegment world, long joint, MemorySegment coupling, MemorySegment error) {
        try { return (int) carom_joint_set_coupling_.CALL.invokeExact(world, joint, coupling, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_joint_get_coupling_ {
        static final MethodHandle CALL = Library.call("carom_joint_get_coupling", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** param: coupling out: as it was made
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; *_HANDLE; BUSY */
    public static int carom_joint_get_coupling(MemorySegment world, long joint, MemorySegment coupling, MemorySegment error) {
        try { return (int) carom_joint_get_coupling_.CALL.invokeExact(world, joint, coupling, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_joint_set_axis_ {
        static final MethodHandle CALL = Library.call("carom_joint_set_axis", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, JAVA_INT, ADDRESS, ADDRESS));
    }
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
     *  param: axis CAROM_AXIS_*
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; UNSUPPORTED (the joint has no such axis of its own; a newer field);
     *          *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT */
    public static int carom_joint_set_axis(MemorySegment world, long joint, int axis, MemorySegment desc, MemorySegment error) {
        try { return (int) carom_joint_set_axis_.CALL.invokeExact(world, joint, axis, desc, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_joint_get_axis_ {
        static final MethodHandle CALL = Library.call("carom_joint_get_axis", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, JAVA_INT, ADDRESS, ADDRESS));
    }
    /** param: axis CAROM_AXIS_*   param: desc out: as it was set
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; UNSUPPORTED; *_HANDLE; BUSY */
    public static int carom_joint_get_axis(MemorySegment world, long joint, int axis, MemorySegment desc, MemorySegment error) {
        try { return (int) carom_joint_get_axis_.CALL.invokeExact(world, joint, axis, desc, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_joint_set_orientation_drive_ {
        static final MethodHandle CALL = Library.call("carom_joint_set_orientation_drive", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** Drive a ball, or a six-axis joint, to an orientation or to an angular velocity; the bodies wake. Of effect
     *  joint_motors. Accuracy: first order in the substep of where it is, as springs with dampers are; where nothing pulls
     *  it ends at the target to rounding. Oracle: tests/oracle/test_six_axis.
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; UNSUPPORTED (the joint is neither ball nor six-axis; a newer
     *          field; a reserved one); *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; BUSY; REENTRANT */
    public static int carom_joint_set_orientation_drive(MemorySegment world, long joint, MemorySegment drive, MemorySegment error) {
        try { return (int) carom_joint_set_orientation_drive_.CALL.invokeExact(world, joint, drive, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_joint_get_orientation_drive_ {
        static final MethodHandle CALL = Library.call("carom_joint_get_orientation_drive", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** param: drive out: as it was set
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; *_HANDLE; BUSY */
    public static int carom_joint_get_orientation_drive(MemorySegment world, long joint, MemorySegment drive, MemorySegment error) {
        try { return (int) carom_joint_get_orientation_drive_.CALL.invokeExact(world, joint, drive, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_joint_bulk_width_ {
        static final MethodHandle CALL = Library.call("carom_joint_bulk_width", FunctionDescriptor.of(JAVA_INT, JAVA_INT, ADDRESS));
    }
    /** How many scalars a record of a field has.
     *  param: field CAROM_JOINT_BULK_*   param: width out: of a record   status: OK; NULL_ARGUMENT; UNKNOWN_ENUM */
    public static int carom_joint_bulk_width(int field, MemorySegment width) {
        try { return (int) carom_joint_bulk_width_.CALL.invokeExact(field, width); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_world_read_joints_ {
        static final MethodHandle CALL = Library.call("carom_world_read_joints", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_INT, JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, JAVA_LONG, ADDRESS));
    }
    /** Read one field of n joints, as carom_world_read() does of bodies.
     *  A rate of what has no direction (points or axes that agree) is the one at which it begins to grow.
     *  Accuracy: rounding of poses and velocities; of a twist times 1 / cos(swing / 2). An effort errs in first order of the
     *  step, by how far the axis turned in it. Oracle: tests/abi/test_joint_bulk.
     *  param: field   CAROM_JOINT_BULK_*   param: scalar CAROM_SCALAR_*
     *  param: joints  [n], or NULL for all in the order of carom_world_get_joints() (n must be their number)
     *  param: dst     n records of the field's scalars, `stride` bytes apart; stride 0: tightly packed
     *  status: OK; NULL_ARGUMENT; UNKNOWN_ENUM; *_HANDLE (nothing is written); UNSUPPORTED (a kind without the field);
     *  OUT_OF_RANGE (n); BUFFER_TOO_SMALL (stride); BUSY */
    public static int carom_world_read_joints(MemorySegment world, int field, int scalar, MemorySegment joints, long n, MemorySegment dst, long stride, MemorySegment error) {
        try { return (int) carom_world_read_joints_.CALL.invokeExact(world, field, scalar, joints, n, dst, stride, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_world_write_joints_ {
        static final MethodHandle CALL = Library.call("carom_world_write_joints", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_INT, JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, JAVA_LONG, ADDRESS));
    }
    /** Write one field of n joints; all values are validated before the first is written, joints of a tree are moved as one.
     *  Accuracy of places: rounding of poses, to 1e-15 of a chain's length a joint. Oracle: tests/oracle/test_joint_moves. Modes, units of gains and what is
     *  enabled stay as they are, where the record does not have them. Bodies of joints that this changes wake. Arguments as carom_world_read_joints().
     *  param: src n records of the field's scalars, `stride` bytes apart; stride 0: tightly packed
     *  status: as carom_world_read_joints(); UNSUPPORTED (also: a field that is read only; a joint of a loop, a broken one,
     *  one between bodies that forces do not move); NOT_FINITE; NOT_UNIT;
     *  OUT_OF_RANGE; REENTRANT */
    public static int carom_world_write_joints(MemorySegment world, int field, int scalar, MemorySegment joints, long n, MemorySegment src, long stride, MemorySegment error) {
        try { return (int) carom_world_write_joints_.CALL.invokeExact(world, field, scalar, joints, n, src, stride, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_world_get_joints_ {
        static final MethodHandle CALL = Library.call("carom_world_get_joints", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** Number of joints, and their handles in creation order of the slots.
     *  param: joints [capacity] or NULL   param: count out: how many there are
     *  status: OK; NULL_ARGUMENT; BUSY */
    public static int carom_world_get_joints(MemorySegment world, MemorySegment joints, long capacity, MemorySegment count, MemorySegment error) {
        try { return (int) carom_world_get_joints_.CALL.invokeExact(world, joints, capacity, count, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_world_enable_ledger_ {
        static final MethodHandle CALL = Library.call("carom_world_enable_ledger", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_INT, ADDRESS));
    }
    /** Keep a ledger from now on, anew if one is kept; or none. Off in a new world.
     *  param: on  0 or 1
     *  status: OK; NULL_ARGUMENT; UNKNOWN_ENUM (on); BUSY; REENTRANT; OUT_OF_MEMORY: as it was */
    public static int carom_world_enable_ledger(MemorySegment world, int on, MemorySegment error) {
        try { return (int) carom_world_enable_ledger_.CALL.invokeExact(world, on, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_world_get_ledger_ {
        static final MethodHandle CALL = Library.call("carom_world_get_ledger", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, JAVA_LONG, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** Copy out all causes, in the order above; none of a world that keeps no ledger.
     *  param: dst      [capacity] elements `stride` bytes apart; may be NULL if capacity is 0
     *  param: stride   sizeof(carom_ledger_entry) as the caller knows it
     *  param: count    out: how many there are (may exceed capacity; capacity are written)
     *  status: OK; NULL_ARGUMENT; BUFFER_TOO_SMALL; OUT_OF_RANGE (stride); BUSY */
    public static int carom_world_get_ledger(MemorySegment world, MemorySegment dst, long stride, long capacity, MemorySegment count, MemorySegment error) {
        try { return (int) carom_world_get_ledger_.CALL.invokeExact(world, dst, stride, capacity, count, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_world_get_ledger_state_ {
        static final MethodHandle CALL = Library.call("carom_world_get_ledger_state", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, ADDRESS));
    }
    /** status: OK; NULL_ARGUMENT; STRUCT_SIZE; BUSY */
    public static int carom_world_get_ledger_state(MemorySegment world, MemorySegment state, MemorySegment error) {
        try { return (int) carom_world_get_ledger_state_.CALL.invokeExact(world, state, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_pairs_distance_ {
        static final MethodHandle CALL = Library.call("carom_pairs_distance", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, ADDRESS, ADDRESS, JAVA_LONG, ADDRESS));
    }
    /** Signed distance of each pair, on the engine's threads (carom_engine_set_jobs()). Each result has the bits that
     *  carom_shape_distance() gives for its pair, for any number of threads. All pairs are checked before the first result
     *  is written, and a message names the pair that is wrong. A pair whose support function misbehaves says so in its
     *  status (CAROM_QUERY_FAULT), and spoils no other. Nothing is allocated per pair.
     *  param: desc   may be NULL: defaults
     *  param: dst    out, [pairs-&gt;count]; no array of pairs
     *  param: stride sizeof(carom_distance) as the caller knows it; an older, shorter one gets its beginning. struct_size is
     *                written, too
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; UNKNOWN_ENUM; UNSUPPORTED (a
     *          pair of half-spaces or sceneries); BUFFER_TOO_SMALL (a stride); OUT_OF_MEMORY; INTERNAL (a callback left its
     *          thread: some results were written)
     *  since: 0.9 */
    public static int carom_pairs_distance(MemorySegment engine, MemorySegment pairs, MemorySegment desc, MemorySegment dst, long stride, MemorySegment error) {
        try { return (int) carom_pairs_distance_.CALL.invokeExact(engine, pairs, desc, dst, stride, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_device_create_ {
        static final MethodHandle CALL = Library.call("carom_device_create", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_INT, ADDRESS, ADDRESS));
    }
    /** Open a device. Its arithmetic is tried, and it is refused where a number is rounded otherwise than on the host.
     *  param: index  among all devices of all platforms, in the order in which the system has them; 0 is the first
     *  param: device out: to be destroyed before the engine   owns: the caller: carom_device_destroy()
     *  status: OK; NULL_ARGUMENT; NOT_FOUND (no OpenCL, or no such device: the message says how many there are); UNSUPPORTED
     *          (it has no double precision, or rounds otherwise); OUT_OF_MEMORY
     *  since: 0.9 */
    public static int carom_device_create(MemorySegment engine, int index, MemorySegment device, MemorySegment error) {
        try { return (int) carom_device_create_.CALL.invokeExact(engine, index, device, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_device_destroy_ {
        static final MethodHandle CALL = Library.call("carom_device_destroy", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS));
    }
    /** param: device from carom_device_create()   status: OK; NULL_ARGUMENT; BUSY; REENTRANT   since: 0.9 */
    public static int carom_device_destroy(MemorySegment device, MemorySegment error) {
        try { return (int) carom_device_destroy_.CALL.invokeExact(device, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_device_get_info_ {
        static final MethodHandle CALL = Library.call("carom_device_get_info", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, ADDRESS));
    }
    /** param: device from carom_device_create()   status: OK; NULL_ARGUMENT; STRUCT_SIZE; BUSY   since: 0.9 */
    public static int carom_device_get_info(MemorySegment device, MemorySegment info, MemorySegment error) {
        try { return (int) carom_device_get_info_.CALL.invokeExact(device, info, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_device_pairs_distance_ {
        static final MethodHandle CALL = Library.call("carom_device_pairs_distance", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, ADDRESS, ADDRESS, JAVA_LONG, ADDRESS));
    }
    /** As carom_pairs_distance(), on a device: each result has the same bits. Shapes are of the device's engine.
     *  param: device from carom_device_create()
     *  param: desc   may be NULL: defaults
     *  param: dst    out, [pairs-&gt;count]; no array of pairs
     *  param: stride as carom_pairs_distance()
     *  status: as carom_pairs_distance(); UNSUPPORTED (a shape that a device cannot ask; CAROM_SIMPLEX_JOHNSON and routines of
     *          pairs, which devices have not; a driver that failed: some results may be written); BUSY; REENTRANT
     *  since: 0.9 */
    public static int carom_device_pairs_distance(MemorySegment device, MemorySegment pairs, MemorySegment desc, MemorySegment dst, long stride, MemorySegment error) {
        try { return (int) carom_device_pairs_distance_.CALL.invokeExact(device, pairs, desc, dst, stride, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_particles_desc_init_ {
        static final MethodHandle CALL = Library.call("carom_particles_desc_init", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_INT));
    }
    /** status: OK; NULL_ARGUMENT; STRUCT_SIZE */
    public static int carom_particles_desc_init(MemorySegment desc, int structSize) {
        try { return (int) carom_particles_desc_init_.CALL.invokeExact(desc, structSize); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_particles_create_ {
        static final MethodHandle CALL = Library.call("carom_particles_create", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, ADDRESS, ADDRESS));
    }
    /** Make an empty set.
     *  param: desc may be NULL: defaults
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT; LIMIT; OUT_OF_MEMORY */
    public static int carom_particles_create(MemorySegment world, MemorySegment desc, MemorySegment set, MemorySegment error) {
        try { return (int) carom_particles_create_.CALL.invokeExact(world, desc, set, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_particles_destroy_ {
        static final MethodHandle CALL = Library.call("carom_particles_destroy", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS));
    }
    /** Its particles too.   status: OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT */
    public static int carom_particles_destroy(MemorySegment world, long set, MemorySegment error) {
        try { return (int) carom_particles_destroy_.CALL.invokeExact(world, set, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_particles_get_ {
        static final MethodHandle CALL = Library.call("carom_particles_get", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** param: desc out: as it was made or updated; capacity: particles there is memory for
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; BUSY */
    public static int carom_particles_get(MemorySegment world, long set, MemorySegment desc, MemorySegment error) {
        try { return (int) carom_particles_get_.CALL.invokeExact(world, set, desc, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_particles_update_ {
        static final MethodHandle CALL = Library.call("carom_particles_update", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** Change what they have in common; particles that are there keep their mass.
     *  param: desc may be NULL: defaults; capacity: memory for so many in all
     *  status: as carom_particles_create(); *_HANDLE */
    public static int carom_particles_update(MemorySegment world, long set, MemorySegment desc, MemorySegment error) {
        try { return (int) carom_particles_update_.CALL.invokeExact(world, set, desc, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_particles_get_count_ {
        static final MethodHandle CALL = Library.call("carom_particles_get_count", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** param: count out: particles in the set   status: OK; NULL_ARGUMENT; *_HANDLE; BUSY */
    public static int carom_particles_get_count(MemorySegment world, long set, MemorySegment count, MemorySegment error) {
        try { return (int) carom_particles_get_count_.CALL.invokeExact(world, set, count, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_particles_add_ {
        static final MethodHandle CALL = Library.call("carom_particles_add", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, JAVA_LONG, JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, JAVA_LONG, ADDRESS));
    }
    /** Add n particles at the end; all values are checked before the first is added.
     *  param: scalar          CAROM_SCALAR_*, of both arrays
     *  param: positions       [n] m, world, three scalars each, within 1e15 m of the origin
     *  param: position_stride bytes from one to the next; 0: tightly packed
     *  param: velocities      [n] m/s, world, likewise, at most 1e9 m/s; NULL: at rest
     *  status: OK; NULL_ARGUMENT; UNKNOWN_ENUM; *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUFFER_TOO_SMALL (stride); LIMIT (2^31
     *          - 1 in a set); BUSY; REENTRANT; OUT_OF_MEMORY */
    public static int carom_particles_add(MemorySegment world, long set, long n, int scalar, MemorySegment positions, long positionStride, MemorySegment velocities, long velocityStride, MemorySegment error) {
        try { return (int) carom_particles_add_.CALL.invokeExact(world, set, n, scalar, positions, positionStride, velocities, velocityStride, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_particles_remove_ {
        static final MethodHandle CALL = Library.call("carom_particles_remove", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, JAVA_LONG, ADDRESS));
    }
    /** Remove n particles. The others keep their order, so each moves up by as many as went before it.
     *  param: indices [n] ascending, each once; NULL: all of them (n must be their number)
     *  status: OK; NULL_ARGUMENT; *_HANDLE; OUT_OF_RANGE (an index, their order, n); BUSY; REENTRANT */
    public static int carom_particles_remove(MemorySegment world, long set, MemorySegment indices, long n, MemorySegment error) {
        try { return (int) carom_particles_remove_.CALL.invokeExact(world, set, indices, n, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_particles_read_ {
        static final MethodHandle CALL = Library.call("carom_particles_read", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, JAVA_INT, JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, JAVA_LONG, ADDRESS));
    }
    /** Read one field of n particles.
     *  param: field   CAROM_FIELD_POSITION, LINEAR_VELOCITY or MASS
     *  param: indices [n] in any order, or NULL: all of them (n must be their number)
     *  param: dst     n records of the field's scalars, `stride` bytes apart
     *  param: stride  bytes from one record to the next; 0: tightly packed
     *  status: OK; NULL_ARGUMENT; UNKNOWN_ENUM; UNSUPPORTED (a field that particles do not have); *_HANDLE; OUT_OF_RANGE
     *          (an index, n); BUFFER_TOO_SMALL (stride); BUSY */
    public static int carom_particles_read(MemorySegment world, long set, int field, int scalar, MemorySegment indices, long n, MemorySegment dst, long stride, MemorySegment error) {
        try { return (int) carom_particles_read_.CALL.invokeExact(world, set, field, scalar, indices, n, dst, stride, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_particles_write_ {
        static final MethodHandle CALL = Library.call("carom_particles_write", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, JAVA_INT, JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, JAVA_LONG, ADDRESS));
    }
    /** Write one field of n particles; all values are checked before the first is written, bounds as carom_particles_add(),
     *  masses as carom_particles_desc. Arguments as carom_particles_read(); where an index comes twice, the last counts.
     *  param: src n records of the field's scalars, `stride` bytes apart
     *  status: as carom_particles_read(); NOT_FINITE; OUT_OF_RANGE; REENTRANT; OUT_OF_MEMORY */
    public static int carom_particles_write(MemorySegment world, long set, int field, int scalar, MemorySegment indices, long n, MemorySegment src, long stride, MemorySegment error) {
        try { return (int) carom_particles_write_.CALL.invokeExact(world, set, field, scalar, indices, n, src, stride, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_particles_get_quarantined_ {
        static final MethodHandle CALL = Library.call("carom_particles_get_quarantined", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** A particle that has come further than 1e15 m or become faster than 1e9 m/s is put in quarantine: it is held still
     *  where it is and counts in no energy, until a host writes its position or removes it. carom_world_get_faults()
     *  reports the first of each set and step (CAROM_FAULT_PARTICLE_STATE), this call all that are held now, ascending.
     *  param: indices [capacity] out; may be NULL if capacity is 0
     *  param: count   out: how many there are (may exceed capacity; capacity are written)
     *  status: OK; NULL_ARGUMENT; *_HANDLE; BUSY */
    public static int carom_particles_get_quarantined(MemorySegment world, long set, MemorySegment indices, long capacity, MemorySegment count, MemorySegment error) {
        try { return (int) carom_particles_get_quarantined_.CALL.invokeExact(world, set, indices, capacity, count, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_world_get_particles_ {
        static final MethodHandle CALL = Library.call("carom_world_get_particles", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** Number of sets, and their handles in creation order of the slots.
     *  param: sets [capacity] or NULL   param: count out: how many there are
     *  status: OK; NULL_ARGUMENT; BUSY */
    public static int carom_world_get_particles(MemorySegment world, MemorySegment sets, long capacity, MemorySegment count, MemorySegment error) {
        try { return (int) carom_world_get_particles_.CALL.invokeExact(world, sets, capacity, count, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_effect_name_ {
        static final MethodHandle CALL = Library.call("carom_effect_name", FunctionDescriptor.of(ADDRESS, JAVA_INT));
    }
    /** Static name of an effect ("gravity"), or "?". */
    public static String carom_effect_name(int effect) {
        try { return ((MemorySegment) carom_effect_name_.CALL.invokeExact(effect)).reinterpret(Long.MAX_VALUE).getString(0); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_world_set_effect_ {
        static final MethodHandle CALL = Library.call("carom_world_set_effect", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_INT, JAVA_INT, ADDRESS));
    }
    /** Forbid or force an effect from the next step on, for all bodies. Wakes all bodies. Forbidding one that the scene
     *  needs is allowed, and carom_world_get_plan() says so.
     *  param: effect CAROM_EFFECT_*   param: mode CAROM_MODE_*
     *  status: OK; NULL_ARGUMENT; UNKNOWN_ENUM; BUSY; REENTRANT */
    public static int carom_world_set_effect(MemorySegment world, int effect, int mode, MemorySegment error) {
        try { return (int) carom_world_set_effect_.CALL.invokeExact(world, effect, mode, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_world_get_effect_ {
        static final MethodHandle CALL = Library.call("carom_world_get_effect", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_INT, ADDRESS, ADDRESS));
    }
    /** param: mode out   status: OK; NULL_ARGUMENT; UNKNOWN_ENUM; BUSY */
    public static int carom_world_get_effect(MemorySegment world, int effect, MemorySegment mode, MemorySegment error) {
        try { return (int) carom_world_get_effect_.CALL.invokeExact(world, effect, mode, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_body_set_effect_ {
        static final MethodHandle CALL = Library.call("carom_body_set_effect", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, JAVA_INT, JAVA_INT, ADDRESS));
    }
    /** The same for one body: its forces, its colliders, the contacts, joints and springs it is in. What is forbidden for
     *  the world is forbidden for it. Particles, events and the ledger are not a body's.
     *  param: mode CAROM_MODE_*
     *  status: OK; NULL_ARGUMENT; *_HANDLE; UNKNOWN_ENUM; UNSUPPORTED (PARTICLES, EVENTS, LEDGER: use
     *          carom_world_set_effect()); BUSY; REENTRANT; OUT_OF_MEMORY */
    public static int carom_body_set_effect(MemorySegment world, long body, int effect, int mode, MemorySegment error) {
        try { return (int) carom_body_set_effect_.CALL.invokeExact(world, body, effect, mode, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_body_get_effect_ {
        static final MethodHandle CALL = Library.call("carom_body_get_effect", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, JAVA_INT, ADDRESS, ADDRESS));
    }
    /** param: mode out: of the body itself   status: OK; NULL_ARGUMENT; *_HANDLE; UNKNOWN_ENUM; BUSY */
    public static int carom_body_get_effect(MemorySegment world, long body, int effect, MemorySegment mode, MemorySegment error) {
        try { return (int) carom_body_get_effect_.CALL.invokeExact(world, body, effect, mode, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_world_time_effects_ {
        static final MethodHandle CALL = Library.call("carom_world_time_effects", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_INT, ADDRESS));
    }
    /** Whether each force effect is timed by itself in carom_world_get_plan(), which costs two looks at the clock for each.
     *  param: on 1 or 0 (as a world is created)
     *  status: OK; NULL_ARGUMENT; OUT_OF_RANGE; BUSY; REENTRANT */
    public static int carom_world_time_effects(MemorySegment world, int on, MemorySegment error) {
        try { return (int) carom_world_time_effects_.CALL.invokeExact(world, on, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_world_get_plan_ {
        static final MethodHandle CALL = Library.call("carom_world_get_plan", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, JAVA_LONG, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** Copy out the plan of the last step: stages first, then effects. Before the first step nothing has run.
     *  param: dst      [capacity] elements `stride` bytes apart; may be NULL if capacity is 0
     *  param: stride   sizeof(carom_plan_line) as the caller knows it
     *  param: count    out: how many there are (may exceed capacity; capacity are written)
     *  status: OK; NULL_ARGUMENT; BUFFER_TOO_SMALL; OUT_OF_RANGE (stride); BUSY */
    public static int carom_world_get_plan(MemorySegment world, MemorySegment dst, long stride, long capacity, MemorySegment count, MemorySegment error) {
        try { return (int) carom_world_get_plan_.CALL.invokeExact(world, dst, stride, capacity, count, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_distance_desc_init_ {
        static final MethodHandle CALL = Library.call("carom_distance_desc_init", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_INT));
    }
    /** status: OK; NULL_ARGUMENT; STRUCT_SIZE */
    public static int carom_distance_desc_init(MemorySegment desc, int structSize) {
        try { return (int) carom_distance_desc_init_.CALL.invokeExact(desc, structSize); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_shape_distance_ {
        static final MethodHandle CALL = Library.call("carom_shape_distance", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS, ADDRESS, ADDRESS, ADDRESS));
    }
    /** Signed distance of two shapes.
     *  param: position_*     [3] m     param: orientation_* [4] x, y, z, w
     *  param: desc   may be NULL: defaults     param: result struct_size set by the caller
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; UNKNOWN_ENUM;
     *          UNSUPPORTED (two half-spaces) */
    public static int carom_shape_distance(MemorySegment engine, long shapeA, MemorySegment positionA, MemorySegment orientationA, long shapeB, MemorySegment positionB, MemorySegment orientationB, MemorySegment desc, MemorySegment result, MemorySegment error) {
        try { return (int) carom_shape_distance_.CALL.invokeExact(engine, shapeA, positionA, orientationA, shapeB, positionB, orientationB, desc, result, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_world_record_begin_ {
        static final MethodHandle CALL = Library.call("carom_world_record_begin", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_INT, ADDRESS, ADDRESS, ADDRESS));
    }
    /** Record a world from now on, until carom_world_record_end() or until it is destroyed.
     *  param: flags CAROM_RECORD_*   param: write is kept, and called with `user`
     *  status: OK; NULL_ARGUMENT; UNSUPPORTED (flags); IN_USE (it is being recorded); WRITE_FAILED; BUSY; REENTRANT;
     *          OUT_OF_MEMORY */
    public static int carom_world_record_begin(MemorySegment world, int flags, MemorySegment write, MemorySegment user, MemorySegment error) {
        try { return (int) carom_world_record_begin_.CALL.invokeExact(world, flags, write, user, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_world_record_end_ {
        static final MethodHandle CALL = Library.call("carom_world_record_end", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS));
    }
    /** Stop recording.
     *  status: OK; NULL_ARGUMENT; NOT_FOUND (it is not being recorded); WRITE_FAILED (`write` said so, now or before: the
     *          recording ends there); OUT_OF_MEMORY (likewise, for lack of memory); BUSY; REENTRANT */
    public static int carom_world_record_end(MemorySegment world, MemorySegment error) {
        try { return (int) carom_world_record_end_.CALL.invokeExact(world, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_world_compare_ {
        static final MethodHandle CALL = Library.call("carom_world_compare", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** Compare a world with a snapshot, between steps; of a world of the same structure. Reads only.
     *  param: difference its struct_size set by the caller
     *  param: bytes [size] of carom_world_save()   param: size number of bytes
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; CORRUPT, UNSUPPORTED, MISMATCH (as carom_world_restore()); BUSY; REENTRANT;
     *          OUT_OF_MEMORY   thread: reader */
    public static int carom_world_compare(MemorySegment world, MemorySegment bytes, long size, MemorySegment difference, MemorySegment error) {
        try { return (int) carom_world_compare_.CALL.invokeExact(world, bytes, size, difference, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_world_get_residuals_ {
        static final MethodHandle CALL = Library.call("carom_world_get_residuals", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, ADDRESS));
    }
    /** param: residuals with its struct_size set; filled. Before the first step, and after a step without contacts, what
     *                   concerns them is 0.
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; BUSY
     *  accuracy: rounding; effective masses are those along the normal
     *  cost: linear in contact points, joints and bodies */
    public static int carom_world_get_residuals(MemorySegment world, MemorySegment residuals, MemorySegment error) {
        try { return (int) carom_world_get_residuals_.CALL.invokeExact(world, residuals, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_world_set_budget_ {
        static final MethodHandle CALL = Library.call("carom_world_set_budget", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_DOUBLE, JAVA_INT, JAVA_INT, ADDRESS));
    }
    /** Choose the dial `substeps` before each step so that steps take about `seconds`. What a substep costs is learnt from
     *  the last steps; if one took too long, substeps drop at once; if there is time left, one is added a step.
     *  Trajectories then depend on the machine's speed: two runs are not the same to the bit. Off (as a world is created)
     *  for lockstep and tests. The steps of a scene that is too expensive even with `fewest` take longer. A budget is the
     *  host's: no snapshot holds it, a copy begins without one, and a record (carom/record.h) has the substeps that it
     *  chose.
     *  param: seconds  s of wall clock a step, 0 &lt; seconds &lt;= 10; 0: off, the dial keeps its value
     *  param: fewest, most  substeps, 1 &lt;= fewest &lt;= most &lt;= the dial's bound; ignored when off
     *  status: OK; NULL_ARGUMENT; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT; OUT_OF_MEMORY */
    public static int carom_world_set_budget(MemorySegment world, double seconds, int fewest, int most, MemorySegment error) {
        try { return (int) carom_world_set_budget_.CALL.invokeExact(world, seconds, fewest, most, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_world_get_budget_ {
        static final MethodHandle CALL = Library.call("carom_world_get_budget", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, ADDRESS, ADDRESS, ADDRESS));
    }
    /** param: seconds, fewest, most  out: as set; 0 when off   status: OK; NULL_ARGUMENT; BUSY */
    public static int carom_world_get_budget(MemorySegment world, MemorySegment seconds, MemorySegment fewest, MemorySegment most, MemorySegment error) {
        try { return (int) carom_world_get_budget_.CALL.invokeExact(world, seconds, fewest, most, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_mesh_desc_init_ {
        static final MethodHandle CALL = Library.call("carom_mesh_desc_init", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_INT));
    }
    /** status: OK; NULL_ARGUMENT; STRUCT_SIZE */
    public static int carom_mesh_desc_init(MemorySegment desc, int structSize) {
        try { return (int) carom_mesh_desc_init_.CALL.invokeExact(desc, structSize); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_shape_create_mesh_ {
        static final MethodHandle CALL = Library.call("carom_shape_create_mesh", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, ADDRESS, ADDRESS));
    }
    /** Make scenery of a mesh. All is copied.
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; NOT_FINITE; OUT_OF_RANGE (a count, an index, a vertex too far
     *          out, no triangle that has an area); LIMIT; OUT_OF_MEMORY */
    public static int carom_shape_create_mesh(MemorySegment engine, MemorySegment desc, MemorySegment shape, MemorySegment error) {
        try { return (int) carom_shape_create_mesh_.CALL.invokeExact(engine, desc, shape, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_height_field_desc_init_ {
        static final MethodHandle CALL = Library.call("carom_height_field_desc_init", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_INT));
    }
    /** status: OK; NULL_ARGUMENT; STRUCT_SIZE */
    public static int carom_height_field_desc_init(MemorySegment desc, int structSize) {
        try { return (int) carom_height_field_desc_init_.CALL.invokeExact(desc, structSize); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_shape_create_height_field_ {
        static final MethodHandle CALL = Library.call("carom_shape_create_height_field", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, ADDRESS, ADDRESS));
    }
    /** Make scenery of a height field. All is copied.
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; NOT_FINITE (an infinite height, a spacing); OUT_OF_RANGE (a
     *          count, a spacing that is not positive, a height too far out, nothing but holes); LIMIT; OUT_OF_MEMORY */
    public static int carom_shape_create_height_field(MemorySegment engine, MemorySegment desc, MemorySegment shape, MemorySegment error) {
        try { return (int) carom_shape_create_height_field_.CALL.invokeExact(engine, desc, shape, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_shape_get_scenery_info_ {
        static final MethodHandle CALL = Library.call("carom_shape_get_scenery_info", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** status: OK; NULL_ARGUMENT; STRUCT_SIZE (set info-&gt;struct_size); *_HANDLE; UNSUPPORTED (a convex shape) */
    public static int carom_shape_get_scenery_info(MemorySegment engine, long shape, MemorySegment info, MemorySegment error) {
        try { return (int) carom_shape_get_scenery_info_.CALL.invokeExact(engine, shape, info, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_shape_get_triangles_ {
        static final MethodHandle CALL = Library.call("carom_shape_get_triangles", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, JAVA_LONG, ADDRESS, ADDRESS, ADDRESS, ADDRESS));
    }
    /** Copy out triangles of scenery, for drawing: each by its three corners, as its surface faces. Holes are left out.
     *  param: first   number of the first triangle wanted
     *  param: corners [9 count] m, shape frame, or NULL to count
     *  param: count   in: how many fit; out: how many were written (with NULL: how many there are from `first` on)
     *  param: next    out: the number of the triangle to go on from; the number of triangles when all have been seen
     *  status: OK; NULL_ARGUMENT; *_HANDLE; OUT_OF_RANGE (first); UNSUPPORTED (a convex shape) */
    public static int carom_shape_get_triangles(MemorySegment engine, long shape, long first, MemorySegment corners, MemorySegment count, MemorySegment next, MemorySegment error) {
        try { return (int) carom_shape_get_triangles_.CALL.invokeExact(engine, shape, first, corners, count, next, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_shape_create_ {
        static final MethodHandle CALL = Library.call("carom_shape_create", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** Make a shape. The parameters are copied. The support function is checked for these parameters (finite, repeatable,
     *  scale-free, samples in convex position), declarations are verified, and AABB and mass properties derived.
     *  param: params [count] doubles, meaning as the plugin documents
     *  status: OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE (count or a bound; argument says which);
     *          PLUGIN_INVALID; DECLARATION_FALSE; OUT_OF_MEMORY */
    public static int carom_shape_create(MemorySegment engine, long plugin, MemorySegment params, long count, MemorySegment shape, MemorySegment error) {
        try { return (int) carom_shape_create_.CALL.invokeExact(engine, plugin, params, count, shape, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_shape_create_named_ {
        static final MethodHandle CALL = Library.call("carom_shape_create_named", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** Make a shape by the name of its plugin: "box", or "carom.box", or the id of a plugin of yours. Plugins that the
     *  engine has come first, by id, then by the name of the file they were loaded from. Then a file NAME.so is looked for
     *  and loaded: in the folders of $CAROM_PLUGIN_PATH (absolute, separated by ':'; not in programs that run with raised
     *  privileges), beside the library, in the folder where plugins are installed. "half_space" is built in: normal x, y,
     *  z, offset.
     *  param: name 1 to 64 letters, digits, _, - and dots   param: params [count] as carom_shape_create()
     *  status: OK; NULL_ARGUMENT; NOT_FOUND (the message says where it was looked for); NOT_FINITE; OUT_OF_RANGE;
     *          PLUGIN_PATH; PLUGIN_LOAD; PLUGIN_ABI; PLUGIN_INVALID; DECLARATION_FALSE; LIMIT; OUT_OF_MEMORY */
    public static int carom_shape_create_named(MemorySegment engine, MemorySegment name, MemorySegment params, long count, MemorySegment shape, MemorySegment error) {
        try { return (int) carom_shape_create_named_.CALL.invokeExact(engine, name, params, count, shape, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_shape_create_half_space_ {
        static final MethodHandle CALL = Library.call("carom_shape_create_half_space", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, JAVA_DOUBLE, ADDRESS, ADDRESS));
    }
    /** The built-in half-space { x : normal . x &lt;= offset } in the shape's own frame; unbounded, so static bodies only.
     *  param: normal [3] unit (within 1e-6)   param: offset m
     *  status: OK; NULL_ARGUMENT; NOT_FINITE; NOT_UNIT; OUT_OF_MEMORY */
    public static int carom_shape_create_half_space(MemorySegment engine, MemorySegment normal, double offset, MemorySegment shape, MemorySegment error) {
        try { return (int) carom_shape_create_half_space_.CALL.invokeExact(engine, normal, offset, shape, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_shape_create_hull_of_ {
        static final MethodHandle CALL = Library.call("carom_shape_create_hull_of", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS, ADDRESS, JAVA_DOUBLE, ADDRESS, ADDRESS));
    }
    /** Make the convex hull of shapes that the engine has, each placed and scaled, and all of it rounded by a radius. The
     *  same call makes
     *  - the sweep of a shape along a straight line, without turning: the shape at both ends. Where it turns as well, the hull
     *    of both ends leaves out what bulges between them: add poses in between;
     *  - a scaled shape: one part with a scale. A negative scale mirrors it;
     *  - a rounded shape: one part and a radius, by which it grows on all sides.
     *  Where all parts have corners only and the radius is 0, the hull is a polytope with exact mass and faces, and its
     *  corners are its parameters. Else its parameters are none and its mass is derived. A part cannot be destroyed before
     *  the hull.
     *  param: parts         [count] handles of convex shapes, the same one as often as wanted
     *  param: count         1 to 4096
     *  param: positions     [3 * count] m, frame of the hull; NULL: 0
     *  param: orientations  [4 * count] x, y, z, w, unit within 1e-6, part to hull; NULL: identity
     *  param: scales        [3 * count] along the axes of the part, of a size of 1e-6 to 1e6; NULL: 1
     *  param: radius        m, 0 or more
     *  status: OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; UNSUPPORTED (a part is a half-space or scenery);
     *          PLUGIN_INVALID; LIMIT (hulls of hulls more than 8 deep, or of more than 4096 parts in all); OUT_OF_MEMORY
     *  since: 0.9 */
    public static int carom_shape_create_hull_of(MemorySegment engine, MemorySegment parts, long count, MemorySegment positions, MemorySegment orientations, MemorySegment scales, double radius, MemorySegment shape, MemorySegment error) {
        try { return (int) carom_shape_create_hull_of_.CALL.invokeExact(engine, parts, count, positions, orientations, scales, radius, shape, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_shape_get_parts_ {
        static final MethodHandle CALL = Library.call("carom_shape_get_parts", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS, ADDRESS, ADDRESS, ADDRESS, ADDRESS, ADDRESS));
    }
    /** What a hull of shapes is made of, as it was given. Of any other shape: no parts, radius 0.
     *  param: parts         [*count] or NULL: only count and radius are written
     *  param: positions     [3 * *count] m, or NULL   param: orientations [4 * *count] x, y, z, w, or NULL
     *  param: scales        [3 * *count] or NULL
     *  param: count         in: capacity in parts; out: number of parts
     *  param: radius        m, or NULL
     *  status: OK; NULL_ARGUMENT; *_HANDLE; BUFFER_TOO_SMALL (count says how many are needed)
     *  since: 0.9 */
    public static int carom_shape_get_parts(MemorySegment engine, long shape, MemorySegment parts, MemorySegment positions, MemorySegment orientations, MemorySegment scales, MemorySegment count, MemorySegment radius, MemorySegment error) {
        try { return (int) carom_shape_get_parts_.CALL.invokeExact(engine, shape, parts, positions, orientations, scales, count, radius, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_shape_destroy_ {
        static final MethodHandle CALL = Library.call("carom_shape_destroy", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS));
    }
    /** status: OK; NULL_ARGUMENT; *_HANDLE; IN_USE (a collider, a hull of shapes, or a query on another thread, refers to
     *          it); REENTRANT */
    public static int carom_shape_destroy(MemorySegment engine, long shape, MemorySegment error) {
        try { return (int) carom_shape_destroy_.CALL.invokeExact(engine, shape, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_shape_get_info_ {
        static final MethodHandle CALL = Library.call("carom_shape_get_info", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** status: OK; NULL_ARGUMENT; STRUCT_SIZE (set info-&gt;struct_size); *_HANDLE */
    public static int carom_shape_get_info(MemorySegment engine, long shape, MemorySegment info, MemorySegment error) {
        try { return (int) carom_shape_get_info_.CALL.invokeExact(engine, shape, info, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_shape_get_params_ {
        static final MethodHandle CALL = Library.call("carom_shape_get_params", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS, ADDRESS));
    }
    /** Copy out the parameters. param: count in: capacity of params; out: number of parameters.
     *  param: params [count]
     *  status: OK; NULL_ARGUMENT; *_HANDLE; BUFFER_TOO_SMALL (count says how many are needed) */
    public static int carom_shape_get_params(MemorySegment engine, long shape, MemorySegment params, MemorySegment count, MemorySegment error) {
        try { return (int) carom_shape_get_params_.CALL.invokeExact(engine, shape, params, count, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_shape_support_ {
        static final MethodHandle CALL = Library.call("carom_shape_support", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** Support points of the whole shape, core radius included, for n directions at once.
     *  param: dirs [3n] nonzero, any length, shape frame   param: points [3n] m, shape frame
     *  status: OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE (a zero direction); UNSUPPORTED (half-space,
     *          scenery); PLUGIN_INVALID (the support function failed; the points before are written) */
    public static int carom_shape_support(MemorySegment engine, long shape, MemorySegment dirs, long n, MemorySegment points, MemorySegment error) {
        try { return (int) carom_shape_support_.CALL.invokeExact(engine, shape, dirs, n, points, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_world_save_ {
        static final MethodHandle CALL = Library.call("carom_world_save", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** Write a snapshot, between steps. Reads only: other readers may be at work.
     *  param: flags    CAROM_SNAPSHOT_*
     *  param: buffer   [capacity] bytes, or NULL to get the size alone
     *  param: capacity bytes; 0 if buffer is NULL
     *  param: needed   out: bytes of the snapshot; written, too, when the buffer is too small (nothing else is)
     *  status: OK; NULL_ARGUMENT; UNSUPPORTED (flags); BUFFER_TOO_SMALL; BUSY; REENTRANT; OUT_OF_MEMORY   thread: reader */
    public static int carom_world_save(MemorySegment world, int flags, MemorySegment buffer, long capacity, MemorySegment needed, MemorySegment error) {
        try { return (int) carom_world_save_.CALL.invokeExact(world, flags, buffer, capacity, needed, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_world_restore_ {
        static final MethodHandle CALL = Library.call("carom_world_restore", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, JAVA_LONG, ADDRESS));
    }
    /** Put a snapshot back, between steps. All of it is read and checked, and all memory that it takes is there, before
     *  anything of the world changes.
     *  An empty world is rebuilt from a snapshot that is whole; `user` values come with it, a ledger
     *  begins anew. Shapes of the same plugin and numbers that the engine has are used, others made; they are the engine's,
     *  as if the host had made them (carom_collider_get() gives their handles). Any other world takes its state, as of one
     *  that is not whole.
     *  param: bytes [size], of any alignment   param: size as carom_world_save() gave it
     *  status: OK; NULL_ARGUMENT; CORRUPT (damaged, cut off, or no snapshot: the message says what); UNSUPPORTED (of a
     *  newer
     *          format); MISMATCH (of a world of another structure: the message names the kind that differs; or a plugin of
     *          that id and version makes other shapes than it did); NOT_FOUND (a shape plugin is not loaded: the message
     *          says id and version); LIMIT; BUSY; REENTRANT; OUT_OF_MEMORY */
    public static int carom_world_restore(MemorySegment world, MemorySegment bytes, long size, MemorySegment error) {
        try { return (int) carom_world_restore_.CALL.invokeExact(world, bytes, size, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_world_fork_ {
        static final MethodHandle CALL = Library.call("carom_world_fork", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, ADDRESS));
    }
    /** Make a world of the same engine that is as this one is, and goes on as it does, bit for bit. Nothing of this one
     *  changes; other readers may be at work. Lists and residuals of its last step, and a ledger, the copy has none of.
     *  param: copy out: to be destroyed as any world
     *  status: OK; NULL_ARGUMENT; LIMIT; BUSY; REENTRANT; OUT_OF_MEMORY   thread: reader */
    public static int carom_world_fork(MemorySegment world, MemorySegment copy, MemorySegment error) {
        try { return (int) carom_world_fork_.CALL.invokeExact(world, copy, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_world_translate_handles_ {
        static final MethodHandle CALL = Library.call("carom_world_translate_handles", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** Handles of another world, as they are in this one: the same slots and generations. For what a host keeps of a world
     *  that it has forked, or of one that was saved whole, in another process too.
     *  param: handles    [n] of bodies, colliders, materials, joints, particles, fields, springs; 0 stays 0
     *  param: translated [n] out; may be `handles`. All of them or, where one is refused, none
     *  status: OK; NULL_ARGUMENT; INVALID_HANDLE; STALE_HANDLE; WRONG_KIND (of an engine: shapes are the same in all its
     *          worlds); BUSY; REENTRANT   thread: reader */
    public static int carom_world_translate_handles(MemorySegment world, MemorySegment handles, long n, MemorySegment translated, MemorySegment error) {
        try { return (int) carom_world_translate_handles_.CALL.invokeExact(world, handles, n, translated, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_tree_get_coordinates_ {
        static final MethodHandle CALL = Library.call("carom_tree_get_coordinates", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, JAVA_LONG, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** Copy out what the coordinates of a tree are.
     *  param: body     any dynamic body of the tree; its base, where nothing holds the tree
     *  param: dst      [capacity] elements `stride` bytes apart; may be NULL if capacity is 0
     *  param: stride   sizeof(carom_tree_coordinate) as the caller knows it
     *  param: count    out: how many there are (may exceed capacity; capacity are written)
     *  status: OK; NULL_ARGUMENT; *_HANDLE; OUT_OF_RANGE (the body is not moved by forces); UNSUPPORTED (no tree);
     *          BUFFER_TOO_SMALL (stride); BUSY; OUT_OF_MEMORY */
    public static int carom_tree_get_coordinates(MemorySegment world, long body, MemorySegment dst, long stride, long capacity, MemorySegment count, MemorySegment error) {
        try { return (int) carom_tree_get_coordinates_.CALL.invokeExact(world, body, dst, stride, capacity, count, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_tree_get_speeds_ {
        static final MethodHandle CALL = Library.call("carom_tree_get_speeds", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, JAVA_LONG, ADDRESS));
    }
    /** The speeds that a tree has now.
     *  Accuracy: rounding of the bodies' velocities. What joints do not leave free of these counts as nothing.
     *  param: speeds out, [n]   param: n how many coordinates there are
     *  status: OK; NULL_ARGUMENT; *_HANDLE; OUT_OF_RANGE (n; the body is not moved by forces); UNSUPPORTED (no tree); BUSY;
     *          OUT_OF_MEMORY */
    public static int carom_tree_get_speeds(MemorySegment world, long body, MemorySegment speeds, long n, MemorySegment error) {
        try { return (int) carom_tree_get_speeds_.CALL.invokeExact(world, body, speeds, n, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_tree_get_forces_ {
        static final MethodHandle CALL = Library.call("carom_tree_get_forces", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS, ADDRESS, JAVA_LONG, ADDRESS));
    }
    /** Inverse dynamics: the forces that give a tree these accelerations, at the present pose.
     *      forces = M accelerations + what gyroscopic and centrifugal terms and gravity ask
     *  With speeds of 0 and no accelerations these hold the tree against gravity.
     *  Accuracy: 1e-14 of the largest term, for chains of tens of bodies. Oracle: tests/oracle/test_joint_tree.
     *  param: speeds        [n] m/s and rad/s, or NULL: those of now
     *  param: accelerations [n] m/s^2 and rad/s^2, rates of the speeds, or NULL: 0
     *  param: forces        out, [n] N and N m
     *  param: n             how many coordinates there are
     *  status: OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE (also: forces that are beyond what numbers hold);
     *          OUT_OF_RANGE (n; the body is not moved by forces); UNSUPPORTED (no tree); BUSY; OUT_OF_MEMORY */
    public static int carom_tree_get_forces(MemorySegment world, long body, MemorySegment speeds, MemorySegment accelerations, MemorySegment forces, long n, MemorySegment error) {
        try { return (int) carom_tree_get_forces_.CALL.invokeExact(world, body, speeds, accelerations, forces, n, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_tree_get_mass_ {
        static final MethodHandle CALL = Library.call("carom_tree_get_mass", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_LONG, ADDRESS, JAVA_LONG, ADDRESS));
    }
    /** The mass matrix of a tree at the present pose, symmetric and positive definite: with speeds v its energy of motion
     *  is v^T M v / 2. Where two axes of one joint agree M is singular.
     *  Accuracy: 1e-14 of the largest entry that a sum has, for chains of tens of bodies. Oracle: tests/oracle/test_joint_tree.
     *  param: mass out, [n n] row by row: kg, kg m and kg m^2   param: n how many coordinates there are
     *  status: OK; NULL_ARGUMENT; *_HANDLE; OUT_OF_RANGE (n; the body is not moved by forces); UNSUPPORTED (no tree);
     *          NOT_FINITE (bodies too far apart or too heavy for numbers); BUSY; OUT_OF_MEMORY */
    public static int carom_tree_get_mass(MemorySegment world, long body, MemorySegment mass, long n, MemorySegment error) {
        try { return (int) carom_tree_get_mass_.CALL.invokeExact(world, body, mass, n, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_vehicle_desc_init_ {
        static final MethodHandle CALL = Library.call("carom_vehicle_desc_init", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_INT));
    }
    /** status: OK; NULL_ARGUMENT; STRUCT_SIZE */
    public static int carom_vehicle_desc_init(MemorySegment desc, int structSize) {
        try { return (int) carom_vehicle_desc_init_.CALL.invokeExact(desc, structSize); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_wheel_desc_init_ {
        static final MethodHandle CALL = Library.call("carom_wheel_desc_init", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_INT));
    }
    /** status: OK; NULL_ARGUMENT; STRUCT_SIZE */
    public static int carom_wheel_desc_init(MemorySegment desc, int structSize) {
        try { return (int) carom_wheel_desc_init_.CALL.invokeExact(desc, structSize); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_vehicle_input_init_ {
        static final MethodHandle CALL = Library.call("carom_vehicle_input_init", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_INT));
    }
    /** status: OK; NULL_ARGUMENT; STRUCT_SIZE */
    public static int carom_vehicle_input_init(MemorySegment input, int structSize) {
        try { return (int) carom_vehicle_input_init_.CALL.invokeExact(input, structSize); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_vehicle_init_ {
        static final MethodHandle CALL = Library.call("carom_vehicle_init", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_INT));
    }
    /** At idle speed, at rest.   status: OK; NULL_ARGUMENT; STRUCT_SIZE */
    public static int carom_vehicle_init(MemorySegment vehicle, int structSize) {
        try { return (int) carom_vehicle_init_.CALL.invokeExact(vehicle, structSize); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_wheel_init_ {
        static final MethodHandle CALL = Library.call("carom_wheel_init", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_INT));
    }
    /** In the air, at rest.   status: OK; NULL_ARGUMENT; STRUCT_SIZE */
    public static int carom_wheel_init(MemorySegment wheel, int structSize) {
        try { return (int) carom_wheel_init_.CALL.invokeExact(wheel, structSize); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_vehicle_drive_ {
        static final MethodHandle CALL = Library.call("carom_vehicle_drive", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, ADDRESS, JAVA_LONG, ADDRESS, ADDRESS, ADDRESS, JAVA_DOUBLE, ADDRESS));
    }
    /** Look down, turn wheels and engine through dt, and leave the mean forces for the next step, which is to take dt. They
     *  add to forces that are pending. They keep a vehicle awake.
     *  param: desc with a chassis
     *  param: wheel_descs [n] one after another, each of the first one's struct_size
     *  param: n 1 to CAROM_VEHICLE_WHEELS
     *  param: input what the driver does
     *  param: vehicle state, changes
     *  param: wheels [n] states, change: as wheel_descs
     *  param: dt s, [1e-4, 0.1]
     *  accuracy: of the prediction first order in 1 ms; it leaves out what else acts on the chassis but gravity and
     *            pending forces. A chassis that swings on its springs faster than a third of 1 / dt trembles. Of springs
     *            stiffer than (m / 4) / 1 ms^2, m what the chassis weighs at the wheel, so much acts
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED (unknown bits; a half-space or scenery as shape); *_HANDLE;
     *          NOT_FINITE; NOT_UNIT; OUT_OF_RANGE (also: a chassis that is not dynamic, a gear that it has not); BUSY;
     *          REENTRANT; OUT_OF_MEMORY */
    public static int carom_vehicle_drive(MemorySegment world, MemorySegment desc, MemorySegment wheelDescs, long n, MemorySegment input, MemorySegment vehicle, MemorySegment wheels, double dt, MemorySegment error) {
        try { return (int) carom_vehicle_drive_.CALL.invokeExact(world, desc, wheelDescs, n, input, vehicle, wheels, dt, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_world_desc_init_ {
        static final MethodHandle CALL = Library.call("carom_world_desc_init", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_INT));
    }
    /** status: OK; NULL_ARGUMENT; STRUCT_SIZE */
    public static int carom_world_desc_init(MemorySegment desc, int structSize) {
        try { return (int) carom_world_desc_init_.CALL.invokeExact(desc, structSize); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_world_create_ {
        static final MethodHandle CALL = Library.call("carom_world_create", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, ADDRESS, ADDRESS));
    }
    /** param: desc may be NULL: defaults   owns: the caller: carom_world_destroy(), before the engine
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; NOT_FINITE; OUT_OF_RANGE; LIMIT (65,535 engines and worlds in
     *          all); OUT_OF_MEMORY   thread: engine */
    public static int carom_world_create(MemorySegment engine, MemorySegment desc, MemorySegment world, MemorySegment error) {
        try { return (int) carom_world_create_.CALL.invokeExact(engine, desc, world, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_world_destroy_ {
        static final MethodHandle CALL = Library.call("carom_world_destroy", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS));
    }
    /** Destroys its bodies, colliders, materials and particles too.   status: OK; NULL_ARGUMENT; BUSY; REENTRANT */
    public static int carom_world_destroy(MemorySegment world, MemorySegment error) {
        try { return (int) carom_world_destroy_.CALL.invokeExact(world, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_world_step_ {
        static final MethodHandle CALL = Library.call("carom_world_step", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_DOUBLE, ADDRESS));
    }
    /** Advance by dt.
     *  param: dt s, in [1e-9, 1]
     *  status: OK; NULL_ARGUMENT; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT; OUT_OF_MEMORY
     *  Out of memory: no body has moved and forces are still pending; contact caches may have been dropped.
     *  A plugin that misbehaves does not fail the step: its pairs are skipped and carom_world_get_faults() reports it. */
    public static int carom_world_step(MemorySegment world, double dt, MemorySegment error) {
        try { return (int) carom_world_step_.CALL.invokeExact(world, dt, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_world_set_dial_ {
        static final MethodHandle CALL = Library.call("carom_world_set_dial", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_INT, JAVA_DOUBLE, ADDRESS));
    }
    /** param: value within the dial's bounds; whole for choices and integers
     *  status: OK; NULL_ARGUMENT; UNKNOWN_ENUM; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT */
    public static int carom_world_set_dial(MemorySegment world, int dial, double value, MemorySegment error) {
        try { return (int) carom_world_set_dial_.CALL.invokeExact(world, dial, value, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_world_get_dial_ {
        static final MethodHandle CALL = Library.call("carom_world_get_dial", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_INT, ADDRESS, ADDRESS));
    }
    /** param: value as carom_world_set_dial() takes it   status: OK; NULL_ARGUMENT; UNKNOWN_ENUM; BUSY */
    public static int carom_world_get_dial(MemorySegment world, int dial, MemorySegment value, MemorySegment error) {
        try { return (int) carom_world_get_dial_.CALL.invokeExact(world, dial, value, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_world_set_preset_ {
        static final MethodHandle CALL = Library.call("carom_world_set_preset", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_INT, ADDRESS));
    }
    /** Set all dials that presets speak of, from the next step on; see carom_preset_get_dial(). Later calls of
     *  carom_world_set_dial() change them one by one.   param: preset CAROM_PRESET_*
     *  status: OK; NULL_ARGUMENT; UNKNOWN_ENUM; BUSY; REENTRANT */
    public static int carom_world_set_preset(MemorySegment world, int preset, MemorySegment error) {
        try { return (int) carom_world_set_preset_.CALL.invokeExact(world, preset, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_world_set_gravity_ {
        static final MethodHandle CALL = Library.call("carom_world_set_gravity", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, ADDRESS));
    }
    /** param: gravity [3] m/s^2, |each| &lt;= 1e6   status: OK; NULL_ARGUMENT; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT */
    public static int carom_world_set_gravity(MemorySegment world, MemorySegment gravity, MemorySegment error) {
        try { return (int) carom_world_set_gravity_.CALL.invokeExact(world, gravity, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_world_get_gravity_ {
        static final MethodHandle CALL = Library.call("carom_world_get_gravity", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, ADDRESS));
    }
    /** status: OK; NULL_ARGUMENT; BUSY */
    public static int carom_world_get_gravity(MemorySegment world, MemorySegment gravity, MemorySegment error) {
        try { return (int) carom_world_get_gravity_.CALL.invokeExact(world, gravity, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_world_get_report_ {
        static final MethodHandle CALL = Library.call("carom_world_get_report", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, ADDRESS));
    }
    /** status: OK; NULL_ARGUMENT; STRUCT_SIZE; BUSY */
    public static int carom_world_get_report(MemorySegment world, MemorySegment report, MemorySegment error) {
        try { return (int) carom_world_get_report_.CALL.invokeExact(world, report, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_stage_name_ {
        static final MethodHandle CALL = Library.call("carom_stage_name", FunctionDescriptor.of(ADDRESS, JAVA_INT));
    }
    /** Static name of a stage ("broad"), or "?".
     *  param: stage CAROM_STAGE_* */
    public static String carom_stage_name(int stage) {
        try { return ((MemorySegment) carom_stage_name_.CALL.invokeExact(stage)).reinterpret(Long.MAX_VALUE).getString(0); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_world_get_contacts_ {
        static final MethodHandle CALL = Library.call("carom_world_get_contacts", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, JAVA_LONG, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** Copy out the contact points of the last step, in a deterministic order; those of colliders destroyed since are gone.
     *  param: dst      [capacity] elements `stride` bytes apart; may be NULL if capacity is 0
     *  param: stride   sizeof(carom_contact) as the caller knows it
     *  param: count    out: how many there are (may exceed capacity; capacity are written)
     *  status: OK; NULL_ARGUMENT; BUFFER_TOO_SMALL; OUT_OF_RANGE (stride); BUSY */
    public static int carom_world_get_contacts(MemorySegment world, MemorySegment dst, long stride, long capacity, MemorySegment count, MemorySegment error) {
        try { return (int) carom_world_get_contacts_.CALL.invokeExact(world, dst, stride, capacity, count, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_world_get_groups_ {
        static final MethodHandle CALL = Library.call("carom_world_get_groups", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, JAVA_LONG, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** Copy out the contact groups of the last step, in a deterministic order. Other solvers than CAROM_SOLVER_AUTO treat
     *  all groups alike: then there are none.
     *  param: dst      [capacity] elements `stride` bytes apart; may be NULL if capacity is 0
     *  param: stride   sizeof(carom_group) as the caller knows it
     *  param: count    out: how many there are (may exceed capacity; capacity are written)
     *  status: OK; NULL_ARGUMENT; BUFFER_TOO_SMALL; OUT_OF_RANGE (stride); BUSY */
    public static int carom_world_get_groups(MemorySegment world, MemorySegment dst, long stride, long capacity, MemorySegment count, MemorySegment error) {
        try { return (int) carom_world_get_groups_.CALL.invokeExact(world, dst, stride, capacity, count, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_world_get_faults_ {
        static final MethodHandle CALL = Library.call("carom_world_get_faults", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, JAVA_LONG, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** Copy out the faults of the last step; arguments as carom_world_get_contacts(). */
    public static int carom_world_get_faults(MemorySegment world, MemorySegment dst, long stride, long capacity, MemorySegment count, MemorySegment error) {
        try { return (int) carom_world_get_faults_.CALL.invokeExact(world, dst, stride, capacity, count, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_world_hash_ {
        static final MethodHandle CALL = Library.call("carom_world_hash", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, ADDRESS));
    }
    /** 64-bit hash of the dynamic state: equal iff (up to collision of the hash) every pose, velocity and cached contact
     *  has the same bits, and every particle's position and velocity.
     *  param: hash of the state
     *  status: OK; NULL_ARGUMENT; BUSY   thread: reader */
    public static int carom_world_hash(MemorySegment world, MemorySegment hash, MemorySegment error) {
        try { return (int) carom_world_hash_.CALL.invokeExact(world, hash, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_query_desc_init_ {
        static final MethodHandle CALL = Library.call("carom_query_desc_init", FunctionDescriptor.of(JAVA_INT, ADDRESS, JAVA_INT));
    }
    /** status: OK; NULL_ARGUMENT; STRUCT_SIZE */
    public static int carom_query_desc_init(MemorySegment desc, int structSize) {
        try { return (int) carom_query_desc_init_.CALL.invokeExact(desc, structSize); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_world_cast_ray_ {
        static final MethodHandle CALL = Library.call("carom_world_cast_ray", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, ADDRESS, JAVA_DOUBLE, ADDRESS, ADDRESS, JAVA_LONG, ADDRESS));
    }
    /** What one ray meets first: origin + t direction, 0 &lt;= t &lt;= max.
     *  param: origin [3] m   param: direction [3] m per unit of t, any length   param: max &gt;= 0, may be infinite
     *  param: desc   may be NULL: defaults   param: size sizeof(carom_world_hit) as the caller knows it
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; *_HANDLE (desc-&gt;ignore); NOT_FINITE; OUT_OF_RANGE;
     *          BUFFER_TOO_SMALL (size); BUSY; OUT_OF_MEMORY   thread: reader */
    public static int carom_world_cast_ray(MemorySegment world, MemorySegment origin, MemorySegment direction, double max, MemorySegment desc, MemorySegment hit, long size, MemorySegment error) {
        try { return (int) carom_world_cast_ray_.CALL.invokeExact(world, origin, direction, max, desc, hit, size, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_world_cast_rays_ {
        static final MethodHandle CALL = Library.call("carom_world_cast_rays", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, JAVA_INT, ADDRESS, ADDRESS, ADDRESS));
    }
    /** What each of many rays meets first, or whether it meets anything. A bad ray (not finite, or max negative) spoils no
     *  other: its outcome is CAROM_CAST_BAD_RAY. Nothing is allocated per ray.
     *  param: want   CAROM_WANT_*   param: desc may be NULL: defaults
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; UNKNOWN_ENUM; *_HANDLE (desc-&gt;ignore); NOT_FINITE;
     *          OUT_OF_RANGE; BUFFER_TOO_SMALL (a stride); BUSY; OUT_OF_MEMORY   thread: reader */
    public static int carom_world_cast_rays(MemorySegment world, MemorySegment rays, int want, MemorySegment desc, MemorySegment hits, MemorySegment error) {
        try { return (int) carom_world_cast_rays_.CALL.invokeExact(world, rays, want, desc, hits, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_world_cast_rays_all_ {
        static final MethodHandle CALL = Library.call("carom_world_cast_rays_all", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, ADDRESS, ADDRESS, JAVA_LONG, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** All that each of many rays meets: by ray, then by time, then by slot. A bad ray has one record that says so.
     *  param: dst    [capacity] elements `stride` bytes apart; may be NULL if capacity is 0
     *  param: stride sizeof(carom_world_hit) as the caller knows it
     *  param: count  out: how many there are (may exceed capacity; the first `capacity` are written)
     *  status: as carom_world_cast_rays()   thread: reader */
    public static int carom_world_cast_rays_all(MemorySegment world, MemorySegment rays, MemorySegment desc, MemorySegment dst, long stride, long capacity, MemorySegment count, MemorySegment error) {
        try { return (int) carom_world_cast_rays_all_.CALL.invokeExact(world, rays, desc, dst, stride, capacity, count, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_world_cast_shapes_ {
        static final MethodHandle CALL = Library.call("carom_world_cast_shapes", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, JAVA_INT, ADDRESS, ADDRESS, JAVA_LONG, ADDRESS));
    }
    /** What each of many shapes meets first as it moves by its motion without turning, or whether it meets anything.
     *  param: shapes every shape, position, orientation and motion must be good, else nothing is written
     *  param: want   CAROM_WANT_*   param: desc may be NULL: defaults
     *  param: dst    [shapes-&gt;count] elements `stride` bytes apart   param: stride 0: tightly packed
     *  status: OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED (a half-space as query shape); UNKNOWN_ENUM; *_HANDLE;
     *  NOT_FINITE;
     *          NOT_UNIT; OUT_OF_RANGE; BUFFER_TOO_SMALL (a stride); BUSY; OUT_OF_MEMORY   thread: reader */
    public static int carom_world_cast_shapes(MemorySegment world, MemorySegment shapes, int want, MemorySegment desc, MemorySegment dst, long stride, MemorySegment error) {
        try { return (int) carom_world_cast_shapes_.CALL.invokeExact(world, shapes, want, desc, dst, stride, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_world_cast_shapes_all_ {
        static final MethodHandle CALL = Library.call("carom_world_cast_shapes_all", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, ADDRESS, ADDRESS, JAVA_LONG, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** All that each of many moving shapes meets: by shape, then by time, then by slot; as carom_world_cast_rays_all().
     *  status: as carom_world_cast_rays_all(); NOT_UNIT   thread: reader */
    public static int carom_world_cast_shapes_all(MemorySegment world, MemorySegment shapes, MemorySegment desc, MemorySegment dst, long stride, long capacity, MemorySegment count, MemorySegment error) {
        try { return (int) carom_world_cast_shapes_all_.CALL.invokeExact(world, shapes, desc, dst, stride, capacity, count, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_world_overlap_shapes_ {
        static final MethodHandle CALL = Library.call("carom_world_overlap_shapes", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, ADDRESS, ADDRESS, JAVA_LONG, JAVA_LONG, ADDRESS, ADDRESS));
    }
    /** All that overlaps each of many shapes (or is nearer than desc-&gt;target): by shape, then by slot; arguments as
     *  carom_world_cast_rays_all().   status: as carom_world_cast_rays_all(); NOT_UNIT   thread: reader */
    public static int carom_world_overlap_shapes(MemorySegment world, MemorySegment shapes, MemorySegment desc, MemorySegment dst, long stride, long capacity, MemorySegment count, MemorySegment error) {
        try { return (int) carom_world_overlap_shapes_.CALL.invokeExact(world, shapes, desc, dst, stride, capacity, count, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    private static final class carom_world_find_nearest_ {
        static final MethodHandle CALL = Library.call("carom_world_find_nearest", FunctionDescriptor.of(JAVA_INT, ADDRESS, ADDRESS, JAVA_DOUBLE, ADDRESS, ADDRESS, JAVA_LONG, ADDRESS));
    }
    /** The collider nearest to each of many shapes or points, and where: least signed distance.
     *  param: reach  m, &gt;= 0, may be infinite: farther ones are not looked for (then: MISS)
     *  param: dst    as carom_world_cast_shapes()
     *  status: as carom_world_cast_shapes()   thread: reader */
    public static int carom_world_find_nearest(MemorySegment world, MemorySegment shapes, double reach, MemorySegment desc, MemorySegment dst, long stride, MemorySegment error) {
        try { return (int) carom_world_find_nearest_.CALL.invokeExact(world, shapes, reach, desc, dst, stride, error); } catch (Throwable problem) { throw Library.thrown(problem); }
    }

    // What C is given of Java's: NULL for null, and never an empty block, since a shape may have no parameters.
    static MemorySegment in(Arena arena, double... it) { return it == null ? MemorySegment.NULL : it.length == 0 ? arena.allocate(8, 8) : arena.allocateFrom(JAVA_DOUBLE, it); }
    static MemorySegment in(Arena arena, long[] it) { return it == null ? MemorySegment.NULL : it.length == 0 ? arena.allocate(8, 8) : arena.allocateFrom(JAVA_LONG, it); }
    static MemorySegment in(Arena arena, int[] it) { return it == null ? MemorySegment.NULL : it.length == 0 ? arena.allocate(8, 8) : arena.allocateFrom(JAVA_INT, it); }
    static MemorySegment in(Arena arena, byte[] it) { return it.length == 0 ? arena.allocate(8, 8) : arena.allocateFrom(JAVA_BYTE, it); }
    static MemorySegment in(Arena arena, Vec3 v) { return v == null ? MemorySegment.NULL : in(arena, v.x(), v.y(), v.z()); }
    static MemorySegment in(Arena arena, Quat q) { return q == null ? MemorySegment.NULL : in(arena, q.x(), q.y(), q.z(), q.w()); }
    static MemorySegment in(Arena arena, String text) { return arena.allocateFrom(text); }

    static void fits(int n, int wanted) {
        if (n != wanted) throw new CaromException(CAROM_E_OUT_OF_RANGE, n + " where " + wanted + " are wanted", "pass arrays of one length");
    }

    interface Ask {
        int of(MemorySegment pointer, MemorySegment dst, long capacity, MemorySegment count, MemorySegment error);
    }

    /** All of a list that says how many there are: asked for none first, then for all. */
    static MemorySegment list(Consumer<EngineCalls.Call> call, Arena arena, long size, Ask ask) {
        MemorySegment count = Arena.ofAuto().allocate(8, 8);
        for (long room = 0;; room = count.get(JAVA_LONG, 0)) {
            MemorySegment dst = room == 0 ? MemorySegment.NULL : arena.allocate(size * room, 8);
            long fits = room;
            call.accept((p, e) -> {
                int result = ask.of(p, dst, fits, count, e);
                return result == CAROM_E_BUFFER_TOO_SMALL && count.get(JAVA_LONG, 0) > fits ? CAROM_OK : result; // so do some say how many
            });
            if (count.get(JAVA_LONG, 0) <= room) return dst.asSlice(0, size * count.get(JAVA_LONG, 0));
        }
    }

    /** What this class was written for, as carom_abi_check() reads it. */
    static final String LAYOUT = """
carom 0.9.0
carom_error 0 576 struct
carom_error.struct_size 0 4 u32
carom_error.code 4 4 i32
carom_error.argument 8 4 i32
carom_error.has_witness 12 4 u32
carom_error.witness_dir 16 24 f64[3]
carom_error.witness_out 40 24 f64[3]
carom_error.message 64 256 char[256]
carom_error.remedy 320 256 char[256]
carom_accuracy 0 24 struct
carom_accuracy.struct_size 0 4 u32
carom_accuracy.substeps 4 4 u32
carom_accuracy.place 8 8 f64
carom_accuracy.turn 16 8 f64
carom_island 0 56 struct
carom_island.body 0 8 u64
carom_island.bodies 8 4 u32
carom_island.substeps 12 4 u32
carom_island.order 16 4 u32
carom_island.flags 20 4 u32
carom_island.work 24 8 u64
carom_island.place 32 8 f64
carom_island.turn 40 8 f64
carom_island.share 48 8 f64
carom_growth 0 40 struct
carom_growth.struct_size 0 4 u32
carom_growth.steps 4 4 u32
carom_growth.body 8 8 u64
carom_growth.sensitive 16 4 u32
carom_growth.reserved 20 4 u32
carom_growth.factor 24 8 f64
carom_growth.rate 32 8 f64
carom_batch_column 0 72 struct
carom_batch_column.struct_size 0 4 u32
carom_batch_column.source 4 4 u32
carom_batch_column.field 8 4 u32
carom_batch_column.when 12 4 u32
carom_batch_column.scalar 16 4 u32
carom_batch_column.reserved 20 4 u32
carom_batch_column.world 24 8 u64
carom_batch_column.n 32 8 u64
carom_batch_column.handles 40 8 ptr
carom_batch_column.rays 48 8 ptr
carom_batch_column.data 56 8 ptr
carom_batch_column.stride 64 8 u64
carom_batch_info 0 48 struct
carom_batch_info.struct_size 0 4 u32
carom_batch_info.structures 4 4 u32
carom_batch_info.worlds 8 8 u64
carom_batch_info.stopped 16 8 u64
carom_batch_info.columns 24 8 u64
carom_batch_info.real_worlds 32 8 u64
carom_batch_info.state_bytes 40 8 u64
carom_material_desc 0 32 struct
carom_material_desc.struct_size 0 4 u32
carom_material_desc.friction_mix 4 4 u32
carom_material_desc.restitution_mix 8 4 u32
carom_material_desc.reserved 12 4 u32
carom_material_desc.friction 16 8 f64
carom_material_desc.restitution 24 8 f64
carom_body_desc 0 312 struct
carom_body_desc.struct_size 0 4 u32
carom_body_desc.fields 4 4 u32
carom_body_desc.type 8 4 u32
carom_body_desc.reserved 12 4 u32
carom_body_desc.position 16 24 f64[3]
carom_body_desc.orientation 40 32 f64[4]
carom_body_desc.linear_velocity 72 24 f64[3]
carom_body_desc.angular_velocity 96 24 f64[3]
carom_body_desc.mass 120 8 f64
carom_body_desc.center 128 24 f64[3]
carom_body_desc.inertia 152 72 f64[9]
carom_body_desc.linear_damping 224 8 f64
carom_body_desc.angular_damping 232 8 f64
carom_body_desc.user 240 8 u64
carom_body_desc.gravity_factor 248 8 f64
carom_body_desc.locks 256 4 u32
carom_body_desc.continuous 260 4 u32
carom_body_desc.linear_drag 264 8 f64
carom_body_desc.quadratic_drag 272 8 f64
carom_body_desc.force_field_mask 280 4 u32
carom_body_desc.reserved2 284 4 u32
carom_body_desc.magnetic_moment 288 24 f64[3]
carom_attribute_info 0 96 struct
carom_attribute_info.struct_size 0 4 u32
carom_attribute_info.attribute 4 4 u32
carom_attribute_info.numbers 8 4 u32
carom_attribute_info.is_whole 12 4 u32
carom_attribute_info.of_dynamic 16 4 u32
carom_attribute_info.effect 20 4 u32
carom_attribute_info.name 24 8 ptr
carom_attribute_info.unit 32 8 ptr
carom_attribute_info.summary 40 8 ptr
carom_attribute_info.min 48 8 f64
carom_attribute_info.max 56 8 f64
carom_attribute_info.usual 64 32 f64[4]
carom_collider_desc 0 160 struct
carom_collider_desc.struct_size 0 4 u32
carom_collider_desc.reserved 4 4 u32
carom_collider_desc.shape 8 8 u64
carom_collider_desc.material 16 8 u64
carom_collider_desc.position 24 24 f64[3]
carom_collider_desc.orientation 48 32 f64[4]
carom_collider_desc.density 80 8 f64
carom_collider_desc.category 88 8 u64
carom_collider_desc.mask 96 8 u64
carom_collider_desc.group 104 4 i32
carom_collider_desc.sensor 108 4 u32
carom_collider_desc.surface_linear 112 24 f64[3]
carom_collider_desc.surface_angular 136 24 f64[3]
carom_cast_desc 0 32 struct
carom_cast_desc.struct_size 0 4 u32
carom_cast_desc.iterations 4 4 u32
carom_cast_desc.tolerance 8 8 f64
carom_cast_desc.target 16 8 f64
carom_cast_desc.flags 24 4 u32
carom_cast_desc.reserved 28 4 u32
carom_cast 0 136 struct
carom_cast.struct_size 0 4 u32
carom_cast.outcome 4 4 u32
carom_cast.status 8 4 u32
carom_cast.iterations 12 4 u32
carom_cast.time 16 8 f64
carom_cast.lower 24 8 f64
carom_cast.upper 32 8 f64
carom_cast.separation 40 8 f64
carom_cast.slack 48 8 f64
carom_cast.normal 56 24 f64[3]
carom_cast.point_a 80 24 f64[3]
carom_cast.point_b 104 24 f64[3]
carom_cast.support_calls 128 4 u32
carom_cast.reserved 132 4 u32
carom_motion 0 136 struct
carom_motion.struct_size 0 4 u32
carom_motion.reserved 4 4 u32
carom_motion.position 8 24 f64[3]
carom_motion.orientation 32 32 f64[4]
carom_motion.center 64 24 f64[3]
carom_motion.linear_velocity 88 24 f64[3]
carom_motion.angular_velocity 112 24 f64[3]
carom_overlap 0 80 struct
carom_overlap.struct_size 0 4 u32
carom_overlap.outcome 4 4 u32
carom_overlap.separation_bound 8 8 f64
carom_overlap.normal 16 24 f64[3]
carom_overlap.point 40 24 f64[3]
carom_overlap.slack 64 8 f64
carom_overlap.support_calls 72 4 u32
carom_overlap.reserved 76 4 u32
carom_rays 0 64 struct
carom_rays.struct_size 0 4 u32
carom_rays.scalar 4 4 u32
carom_rays.count 8 8 u64
carom_rays.origins 16 8 ptr
carom_rays.directions 24 8 ptr
carom_rays.max 32 8 ptr
carom_rays.origin_stride 40 8 u64
carom_rays.direction_stride 48 8 u64
carom_rays.max_stride 56 8 u64
carom_ray_hit 0 88 struct
carom_ray_hit.outcome 0 4 u32
carom_ray_hit.status 4 4 u32
carom_ray_hit.shape 8 4 u32
carom_ray_hit.reserved 12 4 u32
carom_ray_hit.time 16 8 f64
carom_ray_hit.lower 24 8 f64
carom_ray_hit.upper 32 8 f64
carom_ray_hit.normal 40 24 f64[3]
carom_ray_hit.point 64 24 f64[3]
carom_ray_hits 0 104 struct
carom_ray_hits.struct_size 0 4 u32
carom_ray_hits.scalar 4 4 u32
carom_ray_hits.records 8 8 ptr
carom_ray_hits.outcomes 16 8 ptr
carom_ray_hits.shapes 24 8 ptr
carom_ray_hits.times 32 8 ptr
carom_ray_hits.normals 40 8 ptr
carom_ray_hits.points 48 8 ptr
carom_ray_hits.record_stride 56 8 u64
carom_ray_hits.outcome_stride 64 8 u64
carom_ray_hits.shape_stride 72 8 u64
carom_ray_hits.time_stride 80 8 u64
carom_ray_hits.normal_stride 88 8 u64
carom_ray_hits.point_stride 96 8 u64
carom_character_desc 0 144 struct
carom_character_desc.struct_size 0 4 u32
carom_character_desc.flags 4 4 u32
carom_character_desc.up 8 24 f64[3]
carom_character_desc.gravity 32 8 f64
carom_character_desc.fall_speed 40 8 f64
carom_character_desc.max_slope 48 8 f64
carom_character_desc.step_up 56 8 f64
carom_character_desc.step_down 64 8 f64
carom_character_desc.skin 72 8 f64
carom_character_desc.acceleration 80 8 f64
carom_character_desc.air_acceleration 88 8 f64
carom_character_desc.mass 96 8 f64
carom_character_desc.push_force 104 8 f64
carom_character_desc.recover_speed 112 8 f64
carom_character_desc.category 120 8 u64
carom_character_desc.mask 128 8 u64
carom_character_desc.body 136 8 u64
carom_character 0 784 struct
carom_character.struct_size 0 4 u32
carom_character.ground 4 4 u32
carom_character.shape 8 8 u64
carom_character.position 16 24 f64[3]
carom_character.orientation 40 32 f64[4]
carom_character.velocity 72 24 f64[3]
carom_character.foot 96 8 f64
carom_character.head 104 8 f64
carom_character.reach 112 8 f64
carom_character.ground_body 120 8 u64
carom_character.ground_collider 128 8 u64
carom_character.ground_point 136 24 f64[3]
carom_character.ground_normal 160 24 f64[3]
carom_character.ground_velocity 184 24 f64[3]
carom_character.ground_position 208 24 f64[3]
carom_character.ground_orientation 232 32 f64[4]
carom_character.contact_count 264 4 u32
carom_character.reserved 268 4 u32
carom_character.contact_bodies 272 64 u64[8]
carom_character.contact_points 336 192 f64[24]
carom_character.contact_normals 528 192 f64[24]
carom_character.contact_speeds 720 64 f64[8]
carom_dial_info 0 72 struct
carom_dial_info.struct_size 0 4 u32
carom_dial_info.dial 4 4 u32
carom_dial_info.kind 8 4 u32
carom_dial_info.choice_count 12 4 u32
carom_dial_info.name 16 8 ptr
carom_dial_info.unit 24 8 ptr
carom_dial_info.summary 32 8 ptr
carom_dial_info.choices 40 8 ptr
carom_dial_info.min 48 8 f64
carom_dial_info.max 56 8 f64
carom_dial_info.initial 64 8 f64
carom_constant_info 0 48 struct
carom_constant_info.struct_size 0 4 u32
carom_constant_info.constant 4 4 u32
carom_constant_info.name 8 8 ptr
carom_constant_info.unit 16 8 ptr
carom_constant_info.reason 24 8 ptr
carom_constant_info.consequence 32 8 ptr
carom_constant_info.value 40 8 f64
carom_draw_desc 0 24 struct
carom_draw_desc.struct_size 0 4 u32
carom_draw_desc.what 4 4 u32
carom_draw_desc.colouring 8 4 u32
carom_draw_desc.reserved 12 4 u32
carom_draw_desc.scale 16 8 f64
carom_draw_line 0 64 struct
carom_draw_line.from 0 24 f64[3]
carom_draw_line.to 24 24 f64[3]
carom_draw_line.colour 48 4 u32
carom_draw_line.kind 52 4 u32
carom_draw_line.body 56 8 u64
carom_engine_desc 0 48 struct
carom_engine_desc.struct_size 0 4 u32
carom_engine_desc.reserved 4 4 u32
carom_engine_desc.alloc 8 8 fn
carom_engine_desc.free 16 8 fn
carom_engine_desc.alloc_user 24 8 ptr
carom_engine_desc.log 32 8 fn
carom_engine_desc.log_user 40 8 ptr
carom_jobs_desc 0 24 struct
carom_jobs_desc.struct_size 0 4 u32
carom_jobs_desc.threads 4 4 u32
carom_jobs_desc.run 8 8 fn
carom_jobs_desc.user 16 8 ptr
carom_contact_event 0 104 struct
carom_contact_event.kind 0 4 u32
carom_contact_event.reserved 4 4 u32
carom_contact_event.collider_a 8 8 u64
carom_contact_event.collider_b 16 8 u64
carom_contact_event.body_a 24 8 u64
carom_contact_event.body_b 32 8 u64
carom_contact_event.point 40 24 f64[3]
carom_contact_event.normal 64 24 f64[3]
carom_contact_event.impulse 88 8 f64
carom_contact_event.approach_speed 96 8 f64
carom_sensor_event 0 40 struct
carom_sensor_event.kind 0 4 u32
carom_sensor_event.reserved 4 4 u32
carom_sensor_event.sensor 8 8 u64
carom_sensor_event.other 16 8 u64
carom_sensor_event.sensor_body 24 8 u64
carom_sensor_event.other_body 32 8 u64
carom_sleep_event 0 16 struct
carom_sleep_event.kind 0 4 u32
carom_sleep_event.reserved 4 4 u32
carom_sleep_event.body 8 8 u64
carom_joint_event 0 80 struct
carom_joint_event.joint 0 8 u64
carom_joint_event.body_a 8 8 u64
carom_joint_event.body_b 16 8 u64
carom_joint_event.force 24 24 f64[3]
carom_joint_event.torque 48 24 f64[3]
carom_joint_event.step 72 8 u64
carom_fault_event 0 96 struct
carom_fault_event.kind 0 4 u32
carom_fault_event.reserved 4 4 u32
carom_fault_event.shape 8 8 u64
carom_fault_event.body 16 8 u64
carom_fault_event.particles 24 8 u64
carom_fault_event.particle 32 8 u64
carom_fault_event.dir 40 24 f64[3]
carom_fault_event.out 64 24 f64[3]
carom_fault_event.step 88 8 u64
carom_force_field_desc 0 184 struct
carom_force_field_desc.struct_size 0 4 u32
carom_force_field_desc.kind 4 4 u32
carom_force_field_desc.is_force 8 4 u32
carom_force_field_desc.mask 12 4 u32
carom_force_field_desc.position 16 24 f64[3]
carom_force_field_desc.orientation 40 32 f64[4]
carom_force_field_desc.half 72 24 f64[3]
carom_force_field_desc.vector 96 24 f64[3]
carom_force_field_desc.strength 120 8 f64
carom_force_field_desc.pull 128 8 f64
carom_force_field_desc.lift 136 8 f64
carom_force_field_desc.reference 144 8 f64
carom_force_field_desc.core 152 8 f64
carom_force_field_desc.reach 160 8 f64
carom_force_field_desc.falloff 168 4 i32
carom_force_field_desc.reserved 172 4 u32
carom_force_field_desc.user 176 8 u64
carom_spring_desc 0 104 struct
carom_spring_desc.struct_size 0 4 u32
carom_spring_desc.only_pulls 4 4 u32
carom_spring_desc.body_a 8 8 u64
carom_spring_desc.body_b 16 8 u64
carom_spring_desc.anchor_a 24 24 f64[3]
carom_spring_desc.anchor_b 48 24 f64[3]
carom_spring_desc.rest 72 8 f64
carom_spring_desc.stiffness 80 8 f64
carom_spring_desc.damping 88 8 f64
carom_spring_desc.user 96 8 u64
carom_water 0 80 struct
carom_water.struct_size 0 4 u32
carom_water.reserved 4 4 u32
carom_water.normal 8 24 f64[3]
carom_water.level 32 8 f64
carom_water.density 40 8 f64
carom_water.current 48 24 f64[3]
carom_water.drag 72 8 f64
carom_joint_desc 0 176 struct
carom_joint_desc.struct_size 0 4 u32
carom_joint_desc.kind 4 4 u32
carom_joint_desc.fields 8 4 u32
carom_joint_desc.reserved 12 4 u32
carom_joint_desc.body_a 16 8 u64
carom_joint_desc.body_b 24 8 u64
carom_joint_desc.position_a 32 24 f64[3]
carom_joint_desc.orientation_a 56 32 f64[4]
carom_joint_desc.position_b 88 24 f64[3]
carom_joint_desc.orientation_b 112 32 f64[4]
carom_joint_desc.length 144 8 f64
carom_joint_desc.break_force 152 8 f64
carom_joint_desc.break_torque 160 8 f64
carom_joint_desc.user 168 8 u64
carom_joint_limit 0 24 struct
carom_joint_limit.struct_size 0 4 u32
carom_joint_limit.enabled 4 4 u32
carom_joint_limit.lower 8 8 f64
carom_joint_limit.upper 16 8 f64
carom_joint_motor 0 24 struct
carom_joint_motor.struct_size 0 4 u32
carom_joint_motor.enabled 4 4 u32
carom_joint_motor.speed 8 8 f64
carom_joint_motor.max_force 16 8 f64
carom_joint_spring 0 40 struct
carom_joint_spring.struct_size 0 4 u32
carom_joint_spring.enabled 4 4 u32
carom_joint_spring.target 8 8 f64
carom_joint_spring.frequency 16 8 f64
carom_joint_spring.damping 24 8 f64
carom_joint_spring.max_force 32 8 f64
carom_joint_transmission 0 72 struct
carom_joint_transmission.struct_size 0 4 u32
carom_joint_transmission.fields 4 4 u32
carom_joint_transmission.ratio 8 8 f64
carom_joint_transmission.anchor_a 16 24 f64[3]
carom_joint_transmission.anchor_b 40 24 f64[3]
carom_joint_transmission.length 64 8 f64
carom_joint_coupling 0 72 struct
carom_joint_coupling.struct_size 0 4 u32
carom_joint_coupling.reserved 4 4 u32
carom_joint_coupling.follower 8 8 u64
carom_joint_coupling.leader 16 8 u64
carom_joint_coupling.polynomial 24 40 f64[5]
carom_joint_coupling.user 64 8 u64
carom_joint_axis 0 160 struct
carom_joint_axis.struct_size 0 4 u32
carom_joint_axis.mode 4 4 u32
carom_joint_axis.lower 8 8 f64
carom_joint_axis.upper 16 8 f64
carom_joint_axis.stop_gains 24 4 u32
carom_joint_axis.drive_gains 28 4 u32
carom_joint_axis.spring_gains 32 4 u32
carom_joint_axis.drive 36 4 u32
carom_joint_axis.stop_stiffness 40 8 f64
carom_joint_axis.stop_damping 48 8 f64
carom_joint_axis.target 56 8 f64
carom_joint_axis.speed 64 8 f64
carom_joint_axis.effort 72 8 f64
carom_joint_axis.max_force 80 8 f64
carom_joint_axis.drive_stiffness 88 8 f64
carom_joint_axis.drive_damping 96 8 f64
carom_joint_axis.rest 104 8 f64
carom_joint_axis.spring_stiffness 112 8 f64
carom_joint_axis.spring_damping 120 8 f64
carom_joint_axis.friction 128 8 f64
carom_joint_axis.armature 136 8 f64
carom_joint_axis.effort_limit 144 8 f64
carom_joint_axis.speed_limit 152 8 f64
carom_joint_orientation_drive 0 136 struct
carom_joint_orientation_drive.struct_size 0 4 u32
carom_joint_orientation_drive.drive 4 4 u32
carom_joint_orientation_drive.gains 8 4 u32
carom_joint_orientation_drive.reserved 12 4 u32
carom_joint_orientation_drive.target 16 32 f64[4]
carom_joint_orientation_drive.velocity 48 24 f64[3]
carom_joint_orientation_drive.effort 72 24 f64[3]
carom_joint_orientation_drive.max_force 96 24 f64[3]
carom_joint_orientation_drive.stiffness 120 8 f64
carom_joint_orientation_drive.damping 128 8 f64
carom_joint_state 0 152 struct
carom_joint_state.struct_size 0 4 u32
carom_joint_state.broken 4 4 u32
carom_joint_state.force 8 24 f64[3]
carom_joint_state.torque 32 24 f64[3]
carom_joint_state.gap 56 8 f64
carom_joint_state.angle 64 8 f64
carom_joint_state.coordinate 72 32 f64[4]
carom_joint_state.axis 104 48 f64[6]
carom_ledger_entry 0 136 struct
carom_ledger_entry.name 0 8 ptr
carom_ledger_entry.kinetic 8 8 f64
carom_ledger_entry.potential 16 8 f64
carom_ledger_entry.linear 24 24 f64[3]
carom_ledger_entry.angular 48 24 f64[3]
carom_ledger_entry.total_kinetic 72 8 f64
carom_ledger_entry.total_potential 80 8 f64
carom_ledger_entry.total_linear 88 24 f64[3]
carom_ledger_entry.total_angular 112 24 f64[3]
carom_ledger_state 0 256 struct
carom_ledger_state.struct_size 0 4 u32
carom_ledger_state.is_kept 4 4 u32
carom_ledger_state.steps 8 8 u64
carom_ledger_state.start_kinetic 16 8 f64
carom_ledger_state.start_potential 24 8 f64
carom_ledger_state.start_linear 32 24 f64[3]
carom_ledger_state.start_angular 56 24 f64[3]
carom_ledger_state.before_kinetic 80 8 f64
carom_ledger_state.before_potential 88 8 f64
carom_ledger_state.before_linear 96 24 f64[3]
carom_ledger_state.before_angular 120 24 f64[3]
carom_ledger_state.now_kinetic 144 8 f64
carom_ledger_state.now_potential 152 8 f64
carom_ledger_state.now_linear 160 24 f64[3]
carom_ledger_state.now_angular 184 24 f64[3]
carom_ledger_state.rounding_energy 208 8 f64
carom_ledger_state.rounding_linear 216 8 f64
carom_ledger_state.rounding_angular 224 8 f64
carom_ledger_state.total_rounding_energy 232 8 f64
carom_ledger_state.total_rounding_linear 240 8 f64
carom_ledger_state.total_rounding_angular 248 8 f64
carom_pairs 0 112 struct
carom_pairs.struct_size 0 4 u32
carom_pairs.reserved 4 4 u32
carom_pairs.count 8 8 u64
carom_pairs.shapes_a 16 8 ptr
carom_pairs.shapes_b 24 8 ptr
carom_pairs.positions_a 32 8 ptr
carom_pairs.orientations_a 40 8 ptr
carom_pairs.positions_b 48 8 ptr
carom_pairs.orientations_b 56 8 ptr
carom_pairs.shape_a_stride 64 8 u64
carom_pairs.shape_b_stride 72 8 u64
carom_pairs.position_a_stride 80 8 u64
carom_pairs.orientation_a_stride 88 8 u64
carom_pairs.position_b_stride 96 8 u64
carom_pairs.orientation_b_stride 104 8 u64
carom_device_info 0 280 struct
carom_device_info.struct_size 0 4 u32
carom_device_info.reserved 4 4 u32
carom_device_info.name 8 128 char[128]
carom_device_info.version 136 128 char[128]
carom_device_info.pairs 264 8 u64
carom_device_info.host_pairs 272 8 u64
carom_particles_desc 0 40 struct
carom_particles_desc.struct_size 0 4 u32
carom_particles_desc.reserved 4 4 u32
carom_particles_desc.gravity_factor 8 8 f64
carom_particles_desc.linear_damping 16 8 f64
carom_particles_desc.mass 24 8 f64
carom_particles_desc.capacity 32 8 u64
carom_plan_line 0 248 struct
carom_plan_line.effect 0 4 u32
carom_plan_line.stage 4 4 u32
carom_plan_line.mode 8 4 u32
carom_plan_line.runs 12 4 u32
carom_plan_line.participants 16 8 u64
carom_plan_line.wanted 24 8 u64
carom_plan_line.evaluations 32 8 u64
carom_plan_line.bytes 40 8 u64
carom_plan_line.seconds 48 8 f64
carom_plan_line.timing 56 4 u32
carom_plan_line.reserved 60 4 u32
carom_plan_line.name 64 32 char[32]
carom_plan_line.unit 96 24 char[24]
carom_plan_line.reason 120 128 char[128]
carom_param 0 32 struct
carom_param.name 0 8 ptr
carom_param.unit 8 8 ptr
carom_param.min 16 8 f64
carom_param.max 24 8 f64
carom_param_rule 0 72 struct
carom_param_rule.text 0 8 ptr
carom_param_rule.term_count 8 4 u32
carom_param_rule.param 12 16 u32[4]
carom_param_rule.weight 32 32 f64[4]
carom_param_rule.most 64 8 f64
carom_geometry 0 48 struct
carom_geometry.struct_size 0 4 u32
carom_geometry.form 4 4 u32
carom_geometry.form_arg 8 16 u32[4]
carom_geometry.core_radius_param 24 4 u32
carom_geometry.mass_form 28 4 u32
carom_geometry.mass_arg 32 16 u32[4]
carom_shape_plugin 0 96 struct
carom_shape_plugin.struct_size 0 4 u32
carom_shape_plugin.abi_major 4 4 u32
carom_shape_plugin.abi_minor 8 4 u32
carom_shape_plugin.flags 12 4 u32
carom_shape_plugin.id 16 8 ptr
carom_shape_plugin.version 24 4 u32
carom_shape_plugin.param_count 28 4 u32
carom_shape_plugin.params 32 8 ptr
carom_shape_plugin.geometry 40 8 ptr
carom_shape_plugin.support 48 8 fn
carom_shape_plugin.param_tail_group 56 4 u32
carom_shape_plugin.param_tail_min 60 4 u32
carom_shape_plugin.rules 64 8 ptr
carom_shape_plugin.rule_count 72 4 u32
carom_shape_plugin.reserved 76 4 u32
carom_shape_plugin.user 80 8 ptr
carom_shape_plugin.text 88 8 ptr
carom_distance_desc 0 40 struct
carom_distance_desc.struct_size 0 4 u32
carom_distance_desc.simplex 4 4 u32
carom_distance_desc.narrow_phase 8 4 u32
carom_distance_desc.pair_routines 12 4 u32
carom_distance_desc.tolerance 16 8 f64
carom_distance_desc.hybrid_margin 24 8 f64
carom_distance_desc.gjk_iterations 32 4 u32
carom_distance_desc.epa_iterations 36 4 u32
carom_distance 0 120 struct
carom_distance.struct_size 0 4 u32
carom_distance.status 4 4 u32
carom_distance.separation 8 8 f64
carom_distance.lower 16 8 f64
carom_distance.upper 24 8 f64
carom_distance.normal 32 24 f64[3]
carom_distance.point_a 56 24 f64[3]
carom_distance.point_b 80 24 f64[3]
carom_distance.gjk_iterations 104 4 u32
carom_distance.epa_iterations 108 4 u32
carom_distance.support_calls 112 4 u32
carom_distance.reserved 116 4 u32
carom_difference 0 264 struct
carom_difference.struct_size 0 4 u32
carom_difference.differs 4 4 u32
carom_difference.first 8 8 u64
carom_difference.second 16 8 u64
carom_difference.sections 24 240 char[240]
carom_residuals 0 96 struct
carom_residuals.struct_size 0 4 u32
carom_residuals.ledger_is_kept 4 4 u32
carom_residuals.contact_points 8 8 u64
carom_residuals.joints 16 8 u64
carom_residuals.max_penetration 24 8 f64
carom_residuals.mean_penetration 32 8 f64
carom_residuals.joint_gap 40 8 f64
carom_residuals.joint_angle 48 8 f64
carom_residuals.complementarity 56 8 f64
carom_residuals.cone 64 8 f64
carom_residuals.slip 72 8 f64
carom_residuals.energy 80 8 f64
carom_residuals.energy_drift 88 8 f64
carom_mesh_desc 0 40 struct
carom_mesh_desc.struct_size 0 4 u32
carom_mesh_desc.flags 4 4 u32
carom_mesh_desc.vertices 8 8 ptr
carom_mesh_desc.vertex_count 16 8 u64
carom_mesh_desc.triangles 24 8 ptr
carom_mesh_desc.triangle_count 32 8 u64
carom_height_field_desc 0 40 struct
carom_height_field_desc.struct_size 0 4 u32
carom_height_field_desc.flags 4 4 u32
carom_height_field_desc.columns 8 4 u32
carom_height_field_desc.rows 12 4 u32
carom_height_field_desc.heights 16 8 ptr
carom_height_field_desc.spacing 24 16 f64[2]
carom_scenery_info 0 48 struct
carom_scenery_info.struct_size 0 4 u32
carom_scenery_info.flags 4 4 u32
carom_scenery_info.triangles 8 8 u64
carom_scenery_info.vertices 16 8 u64
carom_scenery_info.dropped 24 8 u64
carom_scenery_info.boundary_edges 32 8 u64
carom_scenery_info.bytes 40 8 u64
carom_shape_info 0 240 struct
carom_shape_info.struct_size 0 4 u32
carom_shape_info.form 4 4 u32
carom_shape_info.is_half_space 8 4 u32
carom_shape_info.mass_exact 12 4 u32
carom_shape_info.plugin 16 8 u64
carom_shape_info.param_count 24 8 u64
carom_shape_info.core_radius 32 8 f64
carom_shape_info.bounding_radius 40 8 f64
carom_shape_info.aabb_min 48 24 f64[3]
carom_shape_info.aabb_max 72 24 f64[3]
carom_shape_info.volume 96 8 f64
carom_shape_info.volume_min 104 8 f64
carom_shape_info.volume_max 112 8 f64
carom_shape_info.centroid 120 24 f64[3]
carom_shape_info.centroid_error 144 8 f64
carom_shape_info.inertia 152 72 f64[9]
carom_shape_info.inertia_error 224 8 f64
carom_shape_info.is_scenery 232 4 u32
carom_shape_info.reserved 236 4 u32
carom_tree_coordinate 0 24 struct
carom_tree_coordinate.joint 0 8 u64
carom_tree_coordinate.body 8 8 u64
carom_tree_coordinate.axis 16 4 u32
carom_tree_coordinate.reserved 20 4 u32
carom_vehicle_desc 0 368 struct
carom_vehicle_desc.struct_size 0 4 u32
carom_vehicle_desc.flags 4 4 u32
carom_vehicle_desc.chassis 8 8 u64
carom_vehicle_desc.up 16 24 f64[3]
carom_vehicle_desc.forward 40 24 f64[3]
carom_vehicle_desc.category 64 8 u64
carom_vehicle_desc.mask 72 8 u64
carom_vehicle_desc.torque_count 80 4 u32
carom_vehicle_desc.gear_count 84 4 u32
carom_vehicle_desc.torque_speeds 88 64 f64[8]
carom_vehicle_desc.torques 152 64 f64[8]
carom_vehicle_desc.idle_speed 216 8 f64
carom_vehicle_desc.max_speed 224 8 f64
carom_vehicle_desc.engine_inertia 232 8 f64
carom_vehicle_desc.engine_drag 240 8 f64
carom_vehicle_desc.gears 248 64 f64[8]
carom_vehicle_desc.reverse 312 8 f64
carom_vehicle_desc.final_drive 320 8 f64
carom_vehicle_desc.clutch_torque 328 8 f64
carom_vehicle_desc.shift_up 336 8 f64
carom_vehicle_desc.shift_down 344 8 f64
carom_vehicle_desc.shift_time 352 8 f64
carom_vehicle_desc.limited_slip 360 8 f64
carom_wheel_desc 0 192 struct
carom_wheel_desc.struct_size 0 4 u32
carom_wheel_desc.anti_roll_partner 4 4 u32
carom_wheel_desc.shape 8 8 u64
carom_wheel_desc.position 16 24 f64[3]
carom_wheel_desc.radius 40 8 f64
carom_wheel_desc.inertia 48 8 f64
carom_wheel_desc.travel 56 8 f64
carom_wheel_desc.stiffness 64 8 f64
carom_wheel_desc.damping_bump 72 8 f64
carom_wheel_desc.damping_rebound 80 8 f64
carom_wheel_desc.anti_roll 88 8 f64
carom_wheel_desc.max_steer 96 8 f64
carom_wheel_desc.drive 104 8 f64
carom_wheel_desc.brake 112 8 f64
carom_wheel_desc.handbrake 120 8 f64
carom_wheel_desc.rolling 128 8 f64
carom_wheel_desc.grip 136 8 f64
carom_wheel_desc.side_grip 144 8 f64
carom_wheel_desc.peak_slip 152 8 f64
carom_wheel_desc.side_peak_slip 160 8 f64
carom_wheel_desc.slide 168 8 f64
carom_wheel_desc.slide_slip 176 8 f64
carom_wheel_desc.relaxation 184 8 f64
carom_vehicle_input 0 40 struct
carom_vehicle_input.struct_size 0 4 u32
carom_vehicle_input.gear 4 4 i32
carom_vehicle_input.throttle 8 8 f64
carom_vehicle_input.brake 16 8 f64
carom_vehicle_input.handbrake 24 8 f64
carom_vehicle_input.steer 32 8 f64
carom_vehicle 0 40 struct
carom_vehicle.struct_size 0 4 u32
carom_vehicle.gear 4 4 i32
carom_vehicle.engine_speed 8 8 f64
carom_vehicle.shifting 16 8 f64
carom_vehicle.since_shift 24 8 f64
carom_vehicle.speed 32 8 f64
carom_wheel 0 168 struct
carom_wheel.struct_size 0 4 u32
carom_wheel.touches 4 4 u32
carom_wheel.body 8 8 u64
carom_wheel.collider 16 8 u64
carom_wheel.point 24 24 f64[3]
carom_wheel.normal 48 24 f64[3]
carom_wheel.position 72 24 f64[3]
carom_wheel.compression 96 8 f64
carom_wheel.spin 104 8 f64
carom_wheel.angle 112 8 f64
carom_wheel.steer 120 8 f64
carom_wheel.load 128 8 f64
carom_wheel.force 136 8 f64
carom_wheel.side_force 144 8 f64
carom_wheel.slip 152 8 f64
carom_wheel.side_slip 160 8 f64
carom_world_desc 0 40 struct
carom_world_desc.struct_size 0 4 u32
carom_world_desc.reserved 4 4 u32
carom_world_desc.gravity 8 24 f64[3]
carom_world_desc.body_capacity 32 8 u64
carom_step_report 0 416 struct
carom_step_report.struct_size 0 4 u32
carom_step_report.stage_count 4 4 u32
carom_step_report.stage_seconds 8 128 f64[16]
carom_step_report.total_seconds 136 8 f64
carom_step_report.steps 144 8 u64
carom_step_report.time 152 8 f64
carom_step_report.bodies 160 8 u64
carom_step_report.dynamic_bodies 168 8 u64
carom_step_report.colliders 176 8 u64
carom_step_report.broad_pairs 184 8 u64
carom_step_report.contact_pairs 192 8 u64
carom_step_report.contact_points 200 8 u64
carom_step_report.groups 208 8 u64
carom_step_report.largest_group 216 8 u64
carom_step_report.gjk_calls 224 8 u64
carom_step_report.epa_calls 232 8 u64
carom_step_report.support_calls 240 8 u64
carom_step_report.velocity_impulses 248 8 u64
carom_step_report.position_moves 256 8 u64
carom_step_report.quarantined_bodies 264 8 u64
carom_step_report.faults 272 8 u64
carom_step_report.max_penetration 280 8 f64
carom_step_report.mean_penetration 288 8 f64
carom_step_report.max_closing_speed 296 8 f64
carom_step_report.linear_energy 304 8 f64
carom_step_report.angular_energy 312 8 f64
carom_step_report.asleep_bodies 320 8 u64
carom_step_report.fell_asleep 328 8 u64
carom_step_report.woke_up 336 8 u64
carom_step_report.direct_groups 344 8 u64
carom_step_report.solver_residual 352 8 f64
carom_step_report.particles 360 8 u64
carom_step_report.quarantined_particles 368 8 u64
carom_step_report.swept_bodies 376 8 u64
carom_step_report.sweep_hits 384 8 u64
carom_step_report.wedged_groups 392 8 u64
carom_step_report.rejected_solutions 400 8 u64
carom_step_report.excess_energy 408 8 f64
carom_contact 0 104 struct
carom_contact.collider_a 0 8 u64
carom_contact.collider_b 8 8 u64
carom_contact.body_a 16 8 u64
carom_contact.body_b 24 8 u64
carom_contact.point 32 24 f64[3]
carom_contact.normal 56 24 f64[3]
carom_contact.separation 80 8 f64
carom_contact.normal_impulse 88 8 f64
carom_contact.friction_impulse 96 8 f64
carom_group 0 40 struct
carom_group.body 0 8 u64
carom_group.bodies 8 4 u32
carom_group.points 12 4 u32
carom_group.solver 16 4 u32
carom_group.reason 20 4 u32
carom_group.mass_ratio 24 8 f64
carom_group.sink 32 8 f64
carom_fault 0 88 struct
carom_fault.kind 0 4 u32
carom_fault.reserved 4 4 u32
carom_fault.shape 8 8 u64
carom_fault.body 16 8 u64
carom_fault.dir 24 24 f64[3]
carom_fault.out 48 24 f64[3]
carom_fault.particles 72 8 u64
carom_fault.particle 80 8 u64
carom_query_desc 0 56 struct
carom_query_desc.struct_size 0 4 u32
carom_query_desc.flags 4 4 u32
carom_query_desc.category 8 8 u64
carom_query_desc.mask 16 8 u64
carom_query_desc.ignore 24 8 u64
carom_query_desc.tolerance 32 8 f64
carom_query_desc.target 40 8 f64
carom_query_desc.iterations 48 4 u32
carom_query_desc.reserved 52 4 u32
carom_world_hit 0 136 struct
carom_world_hit.outcome 0 4 u32
carom_world_hit.status 4 4 u32
carom_world_hit.query 8 8 u64
carom_world_hit.collider 16 8 u64
carom_world_hit.body 24 8 u64
carom_world_hit.time 32 8 f64
carom_world_hit.lower 40 8 f64
carom_world_hit.upper 48 8 f64
carom_world_hit.separation 56 8 f64
carom_world_hit.normal 64 24 f64[3]
carom_world_hit.point 88 24 f64[3]
carom_world_hit.point_own 112 24 f64[3]
carom_query_shapes 0 80 struct
carom_query_shapes.struct_size 0 4 u32
carom_query_shapes.scalar 4 4 u32
carom_query_shapes.count 8 8 u64
carom_query_shapes.shapes 16 8 ptr
carom_query_shapes.positions 24 8 ptr
carom_query_shapes.orientations 32 8 ptr
carom_query_shapes.motions 40 8 ptr
carom_query_shapes.shape_stride 48 8 u64
carom_query_shapes.position_stride 56 8 u64
carom_query_shapes.orientation_stride 64 8 u64
carom_query_shapes.motion_stride 72 8 u64
carom_world_hits 0 104 struct
carom_world_hits.struct_size 0 4 u32
carom_world_hits.scalar 4 4 u32
carom_world_hits.records 8 8 ptr
carom_world_hits.outcomes 16 8 ptr
carom_world_hits.colliders 24 8 ptr
carom_world_hits.times 32 8 ptr
carom_world_hits.normals 40 8 ptr
carom_world_hits.points 48 8 ptr
carom_world_hits.record_stride 56 8 u64
carom_world_hits.outcome_stride 64 8 u64
carom_world_hits.collider_stride 72 8 u64
carom_world_hits.time_stride 80 8 u64
carom_world_hits.normal_stride 88 8 u64
carom_world_hits.point_stride 96 8 u64
""";
}
