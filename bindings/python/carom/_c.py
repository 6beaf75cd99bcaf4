"""ctypes declarations of include/carom. Written by bindings/gen/generate from include/carom; do not edit."""
from ctypes import CFUNCTYPE, POINTER, Structure, c_char, c_char_p, c_double, c_int32, c_uint8, c_uint32, c_uint64, c_void_p

VERSION = '0.9.0'
SONAME = 'libcarom.so.0.9'

# constants
CAROM_VERSION_MAJOR = 0
CAROM_VERSION_MINOR = 9
CAROM_VERSION_PATCH = 0
CAROM_OK = 0
CAROM_E_NULL_ARGUMENT = -1
CAROM_E_NOT_FINITE = -2
CAROM_E_OUT_OF_RANGE = -3
CAROM_E_NOT_UNIT = -4
CAROM_E_UNKNOWN_ENUM = -5
CAROM_E_STRUCT_SIZE = -6
CAROM_E_UNSUPPORTED = -7
CAROM_E_INVALID_HANDLE = -8
CAROM_E_STALE_HANDLE = -9
CAROM_E_WRONG_KIND = -10
CAROM_E_WRONG_WORLD = -11
CAROM_E_BUSY = -12
CAROM_E_REENTRANT = -13
CAROM_E_IN_USE = -14
CAROM_E_OUT_OF_MEMORY = -15
CAROM_E_LIMIT = -16
CAROM_E_BUFFER_TOO_SMALL = -17
CAROM_E_PLUGIN_PATH = -18
CAROM_E_PLUGIN_LOAD = -19
CAROM_E_PLUGIN_ABI = -20
CAROM_E_PLUGIN_INVALID = -21
CAROM_E_DECLARATION_FALSE = -22
CAROM_E_NO_VOLUME = -23
CAROM_E_ALREADY_EXISTS = -24
CAROM_E_NOT_FOUND = -25
CAROM_E_INTERNAL = -26
CAROM_E_CORRUPT = -27
CAROM_E_MISMATCH = -28
CAROM_E_WRITE_FAILED = -29
CAROM_E_READ_ONLY = -30
CAROM_NULL_HANDLE = 0
CAROM_SCALAR_F32 = 0
CAROM_SCALAR_F64 = 1
CAROM_ISLAND_ESTIMATED = 1
CAROM_ISLAND_BOUND = 2
CAROM_ISLAND_JOINTS_ALONE = 4
CAROM_ISLAND_STALLED = 8
CAROM_COLUMN_BODIES = 0
CAROM_COLUMN_JOINTS = 1
CAROM_COLUMN_MASSES = 2
CAROM_COLUMN_MATERIALS = 3
CAROM_COLUMN_GRAVITY = 4
CAROM_COLUMN_TIME = 5
CAROM_COLUMN_CONTACT_FORCES = 6
CAROM_COLUMN_RAYS = 7
CAROM_COLUMN_COUNT = 8
CAROM_WHEN_ON_CALL = 0
CAROM_WHEN_BEFORE_STEP = 1
CAROM_WHEN_AFTER_STEP = 2
CAROM_WHEN_COUNT = 3
CAROM_STOPPED_NO = 0
CAROM_STOPPED_FAULT = 1
CAROM_STOPPED_MEMORY = 2
CAROM_RANDOM_UNIFORM = 0
CAROM_RANDOM_NORMAL = 1
CAROM_RANDOM_COUNT = 2
CAROM_MIX_GEOMETRIC_MEAN = 0
CAROM_MIX_MAXIMUM = 1
CAROM_MIX_MINIMUM = 2
CAROM_MIX_AVERAGE = 3
CAROM_MIX_MULTIPLY = 4
CAROM_BODY_STATIC = 0
CAROM_BODY_KINEMATIC = 1
CAROM_BODY_DYNAMIC = 2
CAROM_BODY_FIELD_MASS = 1
CAROM_BODY_FIELD_CENTER = 2
CAROM_BODY_FIELD_INERTIA = 4
CAROM_BODY_STAYS_AWAKE = 8
CAROM_BODY_DISABLED = 16
CAROM_LOCK_LINEAR_X = 1
CAROM_LOCK_LINEAR_Y = 2
CAROM_LOCK_LINEAR_Z = 4
CAROM_LOCK_ANGULAR_X = 8
CAROM_LOCK_ANGULAR_Y = 16
CAROM_LOCK_ANGULAR_Z = 32
CAROM_LOCK_ALL = 63
CAROM_LOCK_PLANE = 28
CAROM_ATTRIBUTE_GRAVITY_FACTOR = 0
CAROM_ATTRIBUTE_LOCKS = 1
CAROM_ATTRIBUTE_DRAG = 2
CAROM_ATTRIBUTE_FORCE_FIELD_MASK = 3
CAROM_ATTRIBUTE_MAGNETIC_MOMENT = 4
CAROM_ATTRIBUTE_COUNT = 5
CAROM_ATTRIBUTE_NUMBERS = 4
CAROM_CONTINUOUS_AUTO = 0
CAROM_CONTINUOUS_ALWAYS = 1
CAROM_CONTINUOUS_NEVER = 2
CAROM_FILTER_CATEGORY = 1
CAROM_FILTER_MASK = 18446744073709551615
CAROM_FIELD_POSITION = 0
CAROM_FIELD_ORIENTATION = 1
CAROM_FIELD_POSE = 2
CAROM_FIELD_LINEAR_VELOCITY = 3
CAROM_FIELD_ANGULAR_VELOCITY = 4
CAROM_FIELD_VELOCITY = 5
CAROM_FIELD_FORCE = 6
CAROM_FIELD_CENTER = 7
CAROM_FIELD_MASS = 8
CAROM_FIELD_COUNT = 9
CAROM_CAST_MISS = 0
CAROM_CAST_HIT = 1
CAROM_CAST_OVERLAP = 2
CAROM_CAST_UNDECIDED = 3
CAROM_CAST_BAD_RAY = 4
CAROM_ASK_GENERIC = 1
CAROM_ASK_SENSORS = 2
CAROM_ASK_IGNORE_TOUCHED = 4
CAROM_OVERLAP_APART = 0
CAROM_OVERLAP_OVERLAPPING = 1
CAROM_OVERLAP_TOUCHING = 2
CAROM_OVERLAP_FAULT = 3
CAROM_NO_SHAPE = 4294967295
CAROM_GROUND_AIR = 0
CAROM_GROUND_STEEP = 1
CAROM_GROUND_FIRM = 2
CAROM_CHARACTER_TURNS = 1
CAROM_CHARACTER_FLIES = 2
CAROM_CHARACTER_CONTACTS = 8
CAROM_DIAL_INTEGRATOR = 0
CAROM_DIAL_ROTATION = 1
CAROM_DIAL_SUBSTEPS = 2
CAROM_DIAL_SOLVER = 3
CAROM_DIAL_VELOCITY_ITERATIONS = 4
CAROM_DIAL_POSITION_ITERATIONS = 5
CAROM_DIAL_VELOCITY_TOLERANCE = 6
CAROM_DIAL_POSITION_TOLERANCE = 7
CAROM_DIAL_RESTITUTION_SPEED = 8
CAROM_DIAL_SEVERITY_SEARCH = 9
CAROM_DIAL_GROUPS = 10
CAROM_DIAL_BROAD_PHASE = 11
CAROM_DIAL_GRID_CELL = 12
CAROM_DIAL_CONTACT_DISTANCE = 13
CAROM_DIAL_PAIR_ROUTINES = 14
CAROM_DIAL_NARROW_PHASE = 15
CAROM_DIAL_SIMPLEX = 16
CAROM_DIAL_GJK_TOLERANCE = 17
CAROM_DIAL_GJK_ITERATIONS = 18
CAROM_DIAL_EPA_ITERATIONS = 19
CAROM_DIAL_HYBRID_MARGIN = 20
CAROM_DIAL_WARM_SEPARATION = 21
CAROM_DIAL_MANIFOLD = 22
CAROM_DIAL_CACHE_DISTANCE = 23
CAROM_DIAL_WARM_START = 24
CAROM_DIAL_CARRY_OVER = 25
CAROM_DIAL_CONTACT_FREQUENCY = 26
CAROM_DIAL_CONTACT_DAMPING = 27
CAROM_DIAL_PUSH_SPEED = 28
CAROM_DIAL_SLEEP = 29
CAROM_DIAL_SLEEP_SPEED = 30
CAROM_DIAL_SLEEP_TIME = 31
CAROM_DIAL_DIRECT_SINK = 32
CAROM_DIAL_DIRECT_RATIO = 33
CAROM_DIAL_DIRECT_WORK = 34
CAROM_DIAL_HOLD_ANGLE = 35
CAROM_DIAL_JOINT_FREQUENCY = 36
CAROM_DIAL_JOINT_DAMPING = 37
CAROM_DIAL_CONTINUOUS = 38
CAROM_DIAL_PRECISION = 39
CAROM_DIAL_JOINT_ORDER = 40
CAROM_DIAL_ACCURACY_PLACE = 41
CAROM_DIAL_ACCURACY_TURN = 42
CAROM_DIAL_ACCURACY_SUBSTEPS = 43
CAROM_DIAL_ACCURACY_WORK = 44
CAROM_DIAL_KEEP_DISTANCE = 45
CAROM_DIAL_COUNT = 46
CAROM_INTEGRATOR_EXPLICIT_EULER = 0
CAROM_INTEGRATOR_SEMI_IMPLICIT_EULER = 1
CAROM_INTEGRATOR_RK4 = 2
CAROM_INTEGRATOR_VELOCITY_VERLET = 3
CAROM_ROTATION_NONE = 0
CAROM_ROTATION_EXPLICIT = 1
CAROM_ROTATION_IMPLICIT = 2
CAROM_ROTATION_RK4 = 3
CAROM_ROTATION_LIE_MIDPOINT = 4
CAROM_ROTATION_SPLITTING = 5
CAROM_ROTATION_SPLITTING_4 = 6
CAROM_ROTATION_SPLITTING_6 = 7
CAROM_SOLVER_SEVERITY = 0
CAROM_SOLVER_SOFT_STEP = 1
CAROM_SOLVER_DIRECT = 2
CAROM_SOLVER_AUTO = 3
CAROM_SEARCH_LINEAR = 0
CAROM_SEARCH_HEAP = 1
CAROM_BROAD_BRUTE_FORCE = 0
CAROM_BROAD_SWEEP_AND_PRUNE = 1
CAROM_BROAD_GRID = 2
CAROM_BROAD_TREE = 3
CAROM_NARROW_HYBRID = 0
CAROM_NARROW_GJK_EPA = 1
CAROM_SIMPLEX_JOHNSON = 0
CAROM_SIMPLEX_VORONOI = 1
CAROM_SIMPLEX_VORONOI_LAST = 2
CAROM_MANIFOLD_SINGLE = 0
CAROM_MANIFOLD_CACHE = 1
CAROM_MANIFOLD_PATCH = 2
CAROM_MANIFOLD_CLIP = 3
CAROM_SWEEP_NONE = 0
CAROM_SWEEP_FLAGGED = 1
CAROM_SWEEP_FAST = 2
CAROM_PRECISION_FLOAT = 0
CAROM_PRECISION_AUTO = 1
CAROM_PRECISION_DOUBLE = 2
CAROM_PRESET_FAST = 0
CAROM_PRESET_BALANCED = 1
CAROM_PRESET_ACCURATE = 2
CAROM_PRESET_REFERENCE = 3
CAROM_PRESET_COUNT = 4
CAROM_DIAL_KIND_NUMBER = 0
CAROM_DIAL_KIND_INTEGER = 1
CAROM_DIAL_KIND_CHOICE = 2
CAROM_DRAW_SHAPES = 1
CAROM_DRAW_SCENERY = 2
CAROM_DRAW_BOUNDS = 4
CAROM_DRAW_CONTACTS = 8
CAROM_DRAW_JOINTS = 16
CAROM_DRAW_BODIES = 32
CAROM_DRAW_BY_TYPE = 0
CAROM_DRAW_BY_ISLAND = 1
CAROM_LOG_INFO = 1
CAROM_LOG_WARNING = 2
CAROM_LOG_ERROR = 3
CAROM_EVENTS_CONTACT = 1
CAROM_EVENTS_SENSOR = 2
CAROM_EVENTS_SLEEP = 4
CAROM_EVENTS_JOINT = 8
CAROM_EVENTS_FAULT = 16
CAROM_CONTACT_BEGIN = 0
CAROM_CONTACT_END = 1
CAROM_CONTACT_HIT = 2
CAROM_SENSOR_ENTER = 0
CAROM_SENSOR_LEAVE = 1
CAROM_SLEEP_ASLEEP = 0
CAROM_SLEEP_AWAKE = 1
CAROM_FORCE_FIELD_UNIFORM = 0
CAROM_FORCE_FIELD_RADIAL = 1
CAROM_FORCE_FIELD_VORTEX = 2
CAROM_FORCE_FIELD_MAGNETIC = 3
CAROM_FORCE_FIELD_COUNT = 4
CAROM_JOINT_BALL = 0
CAROM_JOINT_HINGE = 1
CAROM_JOINT_SLIDER = 2
CAROM_JOINT_WELD = 3
CAROM_JOINT_DISTANCE = 4
CAROM_JOINT_UNIVERSAL = 5
CAROM_JOINT_PULLEY = 6
CAROM_JOINT_GEAR = 7
CAROM_JOINT_SIX_AXIS = 8
CAROM_JOINT_COUPLING = 9
CAROM_JOINT_COUNT = 10
CAROM_COORDINATE_TWIST = 0
CAROM_COORDINATE_SWING = 1
CAROM_COORDINATE_SLIDE = 2
CAROM_COORDINATE_DISTANCE = 3
CAROM_COORDINATE_COUNT = 4
CAROM_AXIS_X = 0
CAROM_AXIS_Y = 1
CAROM_AXIS_Z = 2
CAROM_AXIS_TURN_X = 3
CAROM_AXIS_TURN_Y = 4
CAROM_AXIS_TURN_Z = 5
CAROM_AXIS_COUNT = 6
CAROM_AXIS_MODE_FREE = 0
CAROM_AXIS_MODE_LOCKED = 1
CAROM_AXIS_MODE_LIMITED = 2
CAROM_AXIS_MODE_COUNT = 3
CAROM_DRIVE_NONE = 0
CAROM_DRIVE_POSITION = 1
CAROM_DRIVE_VELOCITY = 2
CAROM_DRIVE_EFFORT = 3
CAROM_DRIVE_COUNT = 4
CAROM_GAINS_FREQUENCY = 0
CAROM_GAINS_FORCE = 1
CAROM_GAINS_ACCELERATION = 2
CAROM_GAINS_COUNT = 3
CAROM_JOINT_WORLD_FRAME = 1
CAROM_JOINT_COLLIDE = 2
CAROM_JOINT_FIELD_LENGTH = 4
CAROM_JOINT_ACCELERATIONS = 8
CAROM_JOINT_BULK_COORDINATES = 0
CAROM_JOINT_BULK_SPEEDS = 1
CAROM_JOINT_BULK_AXES = 2
CAROM_JOINT_BULK_AXIS_SPEEDS = 3
CAROM_JOINT_BULK_FORCE = 4
CAROM_JOINT_BULK_TORQUE = 5
CAROM_JOINT_BULK_ERROR = 6
CAROM_JOINT_BULK_BROKEN = 7
CAROM_JOINT_BULK_POSITION = 8
CAROM_JOINT_BULK_VELOCITY = 9
CAROM_JOINT_BULK_EFFORT = 10
CAROM_JOINT_BULK_TARGET = 11
CAROM_JOINT_BULK_TARGET_VELOCITY = 12
CAROM_JOINT_BULK_TARGET_EFFORT = 13
CAROM_JOINT_BULK_MOTOR = 14
CAROM_JOINT_BULK_SPRING = 15
CAROM_JOINT_BULK_LIMIT = 16
CAROM_JOINT_BULK_AXIS_EFFORTS = 17
CAROM_JOINT_BULK_AXIS_TARGETS = 18
CAROM_JOINT_BULK_AXIS_TARGET_VELOCITIES = 19
CAROM_JOINT_BULK_AXIS_TARGET_EFFORTS = 20
CAROM_JOINT_BULK_AXIS_MAX_FORCES = 21
CAROM_JOINT_BULK_AXIS_GAINS = 22
CAROM_JOINT_BULK_AXIS_LIMITS = 23
CAROM_JOINT_BULK_ORIENTATION_TARGET = 24
CAROM_JOINT_BULK_ORIENTATION_VELOCITY = 25
CAROM_JOINT_BULK_ORIENTATION_EFFORT = 26
CAROM_JOINT_BULK_ORIENTATION_GAINS = 27
CAROM_JOINT_BULK_ACCELERATION = 28
CAROM_JOINT_BULK_AXIS_ACCELERATIONS = 29
CAROM_JOINT_BULK_AXIS_FRICTIONS = 30
CAROM_JOINT_BULK_AXIS_ARMATURES = 31
CAROM_JOINT_BULK_AXIS_EFFORT_LIMITS = 32
CAROM_JOINT_BULK_AXIS_SPEED_LIMITS = 33
CAROM_JOINT_BULK_FRICTION = 34
CAROM_JOINT_BULK_ARMATURE = 35
CAROM_JOINT_BULK_EFFORT_LIMIT = 36
CAROM_JOINT_BULK_SPEED_LIMIT = 37
CAROM_JOINT_BULK_DRIVE_TARGET = 38
CAROM_JOINT_BULK_DRIVE_VELOCITY = 39
CAROM_JOINT_BULK_DRIVE_EFFORT = 40
CAROM_JOINT_BULK_DRIVE_MAX_FORCE = 41
CAROM_JOINT_BULK_DRIVE_GAINS = 42
CAROM_JOINT_BULK_COUNT = 43
CAROM_EFFECT_GYROSCOPIC = 0
CAROM_EFFECT_LINEAR_DAMPING = 1
CAROM_EFFECT_ANGULAR_DAMPING = 2
CAROM_EFFECT_GRAVITY = 3
CAROM_EFFECT_USER_FORCE = 4
CAROM_EFFECT_USER_TORQUE = 5
CAROM_EFFECT_COLLISION = 6
CAROM_EFFECT_FRICTION = 7
CAROM_EFFECT_RESTITUTION = 8
CAROM_EFFECT_ROLLING_RESISTANCE = 9
CAROM_EFFECT_SPINNING_RESISTANCE = 10
CAROM_EFFECT_SLEEP = 11
CAROM_EFFECT_PARTICLES = 12
CAROM_EFFECT_FILTER = 13
CAROM_EFFECT_SENSOR = 14
CAROM_EFFECT_JOINTS = 15
CAROM_EFFECT_SCENERY = 16
CAROM_EFFECT_CONTINUOUS = 17
CAROM_EFFECT_SURFACE_VELOCITY = 18
CAROM_EFFECT_AXIS_LOCKS = 19
CAROM_EFFECT_DRAG = 20
CAROM_EFFECT_WIND = 21
CAROM_EFFECT_FIELDS = 22
CAROM_EFFECT_SPRINGS = 23
CAROM_EFFECT_BUOYANCY = 24
CAROM_EFFECT_RESPONSE = 25
CAROM_EFFECT_JOINT_LIMITS = 26
CAROM_EFFECT_JOINT_MOTORS = 27
CAROM_EFFECT_EVENTS = 28
CAROM_EFFECT_LEDGER = 29
CAROM_EFFECT_MAGNETISM = 30
CAROM_EFFECT_COUNT = 31
CAROM_MODE_AS_NEEDED = 0
CAROM_MODE_FORBID = 1
CAROM_MODE_FORCE = 2
CAROM_PLAN_NO_EFFECT = 4294967295
CAROM_TIME_OWN = 0
CAROM_TIME_IN_STAGE = 1
CAROM_TIME_OFF = 2
CAROM_PLUGIN_ABI_MAJOR = 1
CAROM_PLUGIN_ABI_MINOR = 0
CAROM_FORM_NONE = 0
CAROM_FORM_SPHERE = 1
CAROM_FORM_CAPSULE = 2
CAROM_FORM_BOX = 3
CAROM_FORM_POLYTOPE = 4
CAROM_FORM_CYLINDER = 5
CAROM_FORM_CONE = 6
CAROM_FORM_ELLIPSOID = 7
CAROM_NO_PARAM = 4294967295
CAROM_PLUGIN_HOST_THREAD = 1
CAROM_SHAPE_PLUGIN_SYMBOL = 'carom_shape_plugin_v1'
CAROM_QUERY_EXACT_ENOUGH = 0
CAROM_QUERY_CAPPED = 1
CAROM_QUERY_ROUNDING = 2
CAROM_QUERY_FAULT = 3
CAROM_RECORD_HASHES = 0
CAROM_RECORD_STATES = 1
CAROM_SCENERY_TWO_SIDED = 1
CAROM_SNAPSHOT_STATE = 0
CAROM_SNAPSHOT_WHOLE = 1
CAROM_VEHICLE_AUTOMATIC = 1
CAROM_VEHICLE_ACKERMANN = 2
CAROM_VEHICLE_WHEELS = 16
CAROM_NO_WHEEL = 4294967295
CAROM_STAGE_REFRESH = 0
CAROM_STAGE_BROAD = 1
CAROM_STAGE_NARROW = 2
CAROM_STAGE_GROUP = 3
CAROM_STAGE_INTEGRATE = 4
CAROM_STAGE_SOLVE = 5
CAROM_STAGE_RELAX = 6
CAROM_STAGE_OBSERVE = 7
CAROM_STAGE_COUNT = 8
CAROM_REASON_ORDINARY = 0
CAROM_REASON_MASS_RATIO = 1
CAROM_REASON_SINK = 2
CAROM_REASON_TOO_MUCH = 3
CAROM_REASON_IMPACT = 4
CAROM_REASON_FEW = 5
CAROM_FAULT_RETURNED = 1
CAROM_FAULT_NOT_FINITE = 2
CAROM_FAULT_OUTSIDE = 3
CAROM_FAULT_NOT_SUPPORT = 4
CAROM_FAULT_BODY_STATE = 5
CAROM_FAULT_PARTICLE_STATE = 6
CAROM_WANT_FIRST = 0
CAROM_WANT_ANY = 1

# handles
carom_plugin = c_uint64
carom_shape = c_uint64
carom_material = c_uint64
carom_body = c_uint64
carom_collider = c_uint64
carom_particles = c_uint64
carom_joint = c_uint64
carom_force_field = c_uint64
carom_spring = c_uint64

# callbacks
carom_job_fn = CFUNCTYPE(None, c_void_p, c_uint32, c_uint32)
carom_support_fn = CFUNCTYPE(c_int32, c_void_p, POINTER(c_double), c_uint64, POINTER(c_double), POINTER(c_double))
carom_write_fn = CFUNCTYPE(c_int32, c_void_p, c_void_p, c_uint64)

# structs
class carom_error(Structure):
    _fields_ = [("struct_size", c_uint32), ("code", c_int32), ("argument", c_int32), ("has_witness", c_uint32), ("witness_dir", c_double * 3), ("witness_out", c_double * 3), ("message", c_char * 256), ("remedy", c_char * 256)]
class carom_accuracy(Structure):
    _fields_ = [("struct_size", c_uint32), ("substeps", c_uint32), ("place", c_double), ("turn", c_double)]
class carom_island(Structure):
    _fields_ = [("body", carom_body), ("bodies", c_uint32), ("substeps", c_uint32), ("order", c_uint32), ("flags", c_uint32), ("work", c_uint64), ("place", c_double), ("turn", c_double), ("share", c_double)]
class carom_growth(Structure):
    _fields_ = [("struct_size", c_uint32), ("steps", c_uint32), ("body", carom_body), ("sensitive", c_uint32), ("reserved", c_uint32), ("factor", c_double), ("rate", c_double)]
class carom_batch_column(Structure):
    _fields_ = [("struct_size", c_uint32), ("source", c_uint32), ("field", c_uint32), ("when", c_uint32), ("scalar", c_uint32), ("reserved", c_uint32), ("world", c_uint64), ("n", c_uint64), ("handles", POINTER(c_uint64)), ("rays", POINTER(c_double)), ("data", c_void_p), ("stride", c_uint64)]
class carom_batch_info(Structure):
    _fields_ = [("struct_size", c_uint32), ("structures", c_uint32), ("worlds", c_uint64), ("stopped", c_uint64), ("columns", c_uint64), ("real_worlds", c_uint64), ("state_bytes", c_uint64)]
class carom_material_desc(Structure):
    _fields_ = [("struct_size", c_uint32), ("friction_mix", c_uint32), ("restitution_mix", c_uint32), ("reserved", c_uint32), ("friction", c_double), ("restitution", c_double)]
class carom_body_desc(Structure):
    _fields_ = [("struct_size", c_uint32), ("fields", c_uint32), ("type", c_uint32), ("reserved", c_uint32), ("position", c_double * 3), ("orientation", c_double * 4), ("linear_velocity", c_double * 3), ("angular_velocity", c_double * 3), ("mass", c_double), ("center", c_double * 3), ("inertia", c_double * 9), ("linear_damping", c_double), ("angular_damping", c_double), ("user", c_uint64), ("gravity_factor", c_double), ("locks", c_uint32), ("continuous", c_uint32), ("linear_drag", c_double), ("quadratic_drag", c_double), ("force_field_mask", c_uint32), ("reserved2", c_uint32), ("magnetic_moment", c_double * 3)]
class carom_attribute_info(Structure):
    _fields_ = [("struct_size", c_uint32), ("attribute", c_uint32), ("numbers", c_uint32), ("is_whole", c_uint32), ("of_dynamic", c_uint32), ("effect", c_uint32), ("name", c_char_p), ("unit", c_char_p), ("summary", c_char_p), ("min", c_double), ("max", c_double), ("usual", c_double * 4)]
class carom_collider_desc(Structure):
    _fields_ = [("struct_size", c_uint32), ("reserved", c_uint32), ("shape", carom_shape), ("material", carom_material), ("position", c_double * 3), ("orientation", c_double * 4), ("density", c_double), ("category", c_uint64), ("mask", c_uint64), ("group", c_int32), ("sensor", c_uint32), ("surface_linear", c_double * 3), ("surface_angular", c_double * 3)]
class carom_cast_desc(Structure):
    _fields_ = [("struct_size", c_uint32), ("iterations", c_uint32), ("tolerance", c_double), ("target", c_double), ("flags", c_uint32), ("reserved", c_uint32)]
class carom_cast(Structure):
    _fields_ = [("struct_size", c_uint32), ("outcome", c_uint32), ("status", c_uint32), ("iterations", c_uint32), ("time", c_double), ("lower", c_double), ("upper", c_double), ("separation", c_double), ("slack", c_double), ("normal", c_double * 3), ("point_a", c_double * 3), ("point_b", c_double * 3), ("support_calls", c_uint32), ("reserved", c_uint32)]
class carom_motion(Structure):
    _fields_ = [("struct_size", c_uint32), ("reserved", c_uint32), ("position", c_double * 3), ("orientation", c_double * 4), ("center", c_double * 3), ("linear_velocity", c_double * 3), ("angular_velocity", c_double * 3)]
class carom_overlap(Structure):
    _fields_ = [("struct_size", c_uint32), ("outcome", c_uint32), ("separation_bound", c_double), ("normal", c_double * 3), ("point", c_double * 3), ("slack", c_double), ("support_calls", c_uint32), ("reserved", c_uint32)]
class carom_rays(Structure):
    _fields_ = [("struct_size", c_uint32), ("scalar", c_uint32), ("count", c_uint64), ("origins", c_void_p), ("directions", c_void_p), ("max", c_void_p), ("origin_stride", c_uint64), ("direction_stride", c_uint64), ("max_stride", c_uint64)]
class carom_ray_hit(Structure):
    _fields_ = [("outcome", c_uint32), ("status", c_uint32), ("shape", c_uint32), ("reserved", c_uint32), ("time", c_double), ("lower", c_double), ("upper", c_double), ("normal", c_double * 3), ("point", c_double * 3)]
class carom_ray_hits(Structure):
    _fields_ = [("struct_size", c_uint32), ("scalar", c_uint32), ("records", POINTER(carom_ray_hit)), ("outcomes", POINTER(c_uint32)), ("shapes", POINTER(c_uint32)), ("times", c_void_p), ("normals", c_void_p), ("points", c_void_p), ("record_stride", c_uint64), ("outcome_stride", c_uint64), ("shape_stride", c_uint64), ("time_stride", c_uint64), ("normal_stride", c_uint64), ("point_stride", c_uint64)]
class carom_character_desc(Structure):
    _fields_ = [("struct_size", c_uint32), ("flags", c_uint32), ("up", c_double * 3), ("gravity", c_double), ("fall_speed", c_double), ("max_slope", c_double), ("step_up", c_double), ("step_down", c_double), ("skin", c_double), ("acceleration", c_double), ("air_acceleration", c_double), ("mass", c_double), ("push_force", c_double), ("recover_speed", c_double), ("category", c_uint64), ("mask", c_uint64), ("body", carom_body)]
class carom_character(Structure):
    _fields_ = [("struct_size", c_uint32), ("ground", c_uint32), ("shape", carom_shape), ("position", c_double * 3), ("orientation", c_double * 4), ("velocity", c_double * 3), ("foot", c_double), ("head", c_double), ("reach", c_double), ("ground_body", carom_body), ("ground_collider", carom_collider), ("ground_point", c_double * 3), ("ground_normal", c_double * 3), ("ground_velocity", c_double * 3), ("ground_position", c_double * 3), ("ground_orientation", c_double * 4), ("contact_count", c_uint32), ("reserved", c_uint32), ("contact_bodies", carom_body * 8), ("contact_points", c_double * 24), ("contact_normals", c_double * 24), ("contact_speeds", c_double * 8)]
class carom_dial_info(Structure):
    _fields_ = [("struct_size", c_uint32), ("dial", c_uint32), ("kind", c_uint32), ("choice_count", c_uint32), ("name", c_char_p), ("unit", c_char_p), ("summary", c_char_p), ("choices", POINTER(c_char_p)), ("min", c_double), ("max", c_double), ("initial", c_double)]
class carom_constant_info(Structure):
    _fields_ = [("struct_size", c_uint32), ("constant", c_uint32), ("name", c_char_p), ("unit", c_char_p), ("reason", c_char_p), ("consequence", c_char_p), ("value", c_double)]
class carom_draw_desc(Structure):
    _fields_ = [("struct_size", c_uint32), ("what", c_uint32), ("colouring", c_uint32), ("reserved", c_uint32), ("scale", c_double)]
class carom_draw_line(Structure):
    _fields_ = [("from", c_double * 3), ("to", c_double * 3), ("colour", c_uint32), ("kind", c_uint32), ("body", carom_body)]
class carom_engine_desc(Structure):
    _fields_ = [("struct_size", c_uint32), ("reserved", c_uint32), ("alloc", CFUNCTYPE(c_void_p, c_void_p, c_uint64, c_uint64)), ("free", CFUNCTYPE(None, c_void_p, c_void_p, c_uint64, c_uint64)), ("alloc_user", c_void_p), ("log", CFUNCTYPE(None, c_void_p, c_uint32, c_char_p)), ("log_user", c_void_p)]
class carom_jobs_desc(Structure):
    _fields_ = [("struct_size", c_uint32), ("threads", c_uint32), ("run", CFUNCTYPE(None, c_void_p, carom_job_fn, c_void_p, c_uint32)), ("user", c_void_p)]
class carom_contact_event(Structure):
    _fields_ = [("kind", c_uint32), ("reserved", c_uint32), ("collider_a", carom_collider), ("collider_b", carom_collider), ("body_a", carom_body), ("body_b", carom_body), ("point", c_double * 3), ("normal", c_double * 3), ("impulse", c_double), ("approach_speed", c_double)]
class carom_sensor_event(Structure):
    _fields_ = [("kind", c_uint32), ("reserved", c_uint32), ("sensor", carom_collider), ("other", carom_collider), ("sensor_body", carom_body), ("other_body", carom_body)]
class carom_sleep_event(Structure):
    _fields_ = [("kind", c_uint32), ("reserved", c_uint32), ("body", carom_body)]
class carom_joint_event(Structure):
    _fields_ = [("joint", carom_joint), ("body_a", carom_body), ("body_b", carom_body), ("force", c_double * 3), ("torque", c_double * 3), ("step", c_uint64)]
class carom_fault_event(Structure):
    _fields_ = [("kind", c_uint32), ("reserved", c_uint32), ("shape", carom_shape), ("body", carom_body), ("particles", carom_particles), ("particle", c_uint64), ("dir", c_double * 3), ("out", c_double * 3), ("step", c_uint64)]
class carom_force_field_desc(Structure):
    _fields_ = [("struct_size", c_uint32), ("kind", c_uint32), ("is_force", c_uint32), ("mask", c_uint32), ("position", c_double * 3), ("orientation", c_double * 4), ("half", c_double * 3), ("vector", c_double * 3), ("strength", c_double), ("pull", c_double), ("lift", c_double), ("reference", c_double), ("core", c_double), ("reach", c_double), ("falloff", c_int32), ("reserved", c_uint32), ("user", c_uint64)]
class carom_spring_desc(Structure):
    _fields_ = [("struct_size", c_uint32), ("only_pulls", c_uint32), ("body_a", carom_body), ("body_b", carom_body), ("anchor_a", c_double * 3), ("anchor_b", c_double * 3), ("rest", c_double), ("stiffness", c_double), ("damping", c_double), ("user", c_uint64)]
class carom_water(Structure):
    _fields_ = [("struct_size", c_uint32), ("reserved", c_uint32), ("normal", c_double * 3), ("level", c_double), ("density", c_double), ("current", c_double * 3), ("drag", c_double)]
class carom_joint_desc(Structure):
    _fields_ = [("struct_size", c_uint32), ("kind", c_uint32), ("fields", c_uint32), ("reserved", c_uint32), ("body_a", carom_body), ("body_b", carom_body), ("position_a", c_double * 3), ("orientation_a", c_double * 4), ("position_b", c_double * 3), ("orientation_b", c_double * 4), ("length", c_double), ("break_force", c_double), ("break_torque", c_double), ("user", c_uint64)]
class carom_joint_limit(Structure):
    _fields_ = [("struct_size", c_uint32), ("enabled", c_uint32), ("lower", c_double), ("upper", c_double)]
class carom_joint_motor(Structure):
    _fields_ = [("struct_size", c_uint32), ("enabled", c_uint32), ("speed", c_double), ("max_force", c_double)]
class carom_joint_spring(Structure):
    _fields_ = [("struct_size", c_uint32), ("enabled", c_uint32), ("target", c_double), ("frequency", c_double), ("damping", c_double), ("max_force", c_double)]
class carom_joint_transmission(Structure):
    _fields_ = [("struct_size", c_uint32), ("fields", c_uint32), ("ratio", c_double), ("anchor_a", c_double * 3), ("anchor_b", c_double * 3), ("length", c_double)]
class carom_joint_coupling(Structure):
    _fields_ = [("struct_size", c_uint32), ("reserved", c_uint32), ("follower", carom_joint), ("leader", carom_joint), ("polynomial", c_double * 5), ("user", c_uint64)]
class carom_joint_axis(Structure):
    _fields_ = [("struct_size", c_uint32), ("mode", c_uint32), ("lower", c_double), ("upper", c_double), ("stop_gains", c_uint32), ("drive_gains", c_uint32), ("spring_gains", c_uint32), ("drive", c_uint32), ("stop_stiffness", c_double), ("stop_damping", c_double), ("target", c_double), ("speed", c_double), ("effort", c_double), ("max_force", c_double), ("drive_stiffness", c_double), ("drive_damping", c_double), ("rest", c_double), ("spring_stiffness", c_double), ("spring_damping", c_double), ("friction", c_double), ("armature", c_double), ("effort_limit", c_double), ("speed_limit", c_double)]
class carom_joint_orientation_drive(Structure):
    _fields_ = [("struct_size", c_uint32), ("drive", c_uint32), ("gains", c_uint32), ("reserved", c_uint32), ("target", c_double * 4), ("velocity", c_double * 3), ("effort", c_double * 3), ("max_force", c_double * 3), ("stiffness", c_double), ("damping", c_double)]
class carom_joint_state(Structure):
    _fields_ = [("struct_size", c_uint32), ("broken", c_uint32), ("force", c_double * 3), ("torque", c_double * 3), ("gap", c_double), ("angle", c_double), ("coordinate", c_double * 4), ("axis", c_double * 6)]
class carom_ledger_entry(Structure):
    _fields_ = [("name", c_char_p), ("kinetic", c_double), ("potential", c_double), ("linear", c_double * 3), ("angular", c_double * 3), ("total_kinetic", c_double), ("total_potential", c_double), ("total_linear", c_double * 3), ("total_angular", c_double * 3)]
class carom_ledger_state(Structure):
    _fields_ = [("struct_size", c_uint32), ("is_kept", c_uint32), ("steps", c_uint64), ("start_kinetic", c_double), ("start_potential", c_double), ("start_linear", c_double * 3), ("start_angular", c_double * 3), ("before_kinetic", c_double), ("before_potential", c_double), ("before_linear", c_double * 3), ("before_angular", c_double * 3), ("now_kinetic", c_double), ("now_potential", c_double), ("now_linear", c_double * 3), ("now_angular", c_double * 3), ("rounding_energy", c_double), ("rounding_linear", c_double), ("rounding_angular", c_double), ("total_rounding_energy", c_double), ("total_rounding_linear", c_double), ("total_rounding_angular", c_double)]
class carom_pairs(Structure):
    _fields_ = [("struct_size", c_uint32), ("reserved", c_uint32), ("count", c_uint64), ("shapes_a", POINTER(carom_shape)), ("shapes_b", POINTER(carom_shape)), ("positions_a", POINTER(c_double)), ("orientations_a", POINTER(c_double)), ("positions_b", POINTER(c_double)), ("orientations_b", POINTER(c_double)), ("shape_a_stride", c_uint64), ("shape_b_stride", c_uint64), ("position_a_stride", c_uint64), ("orientation_a_stride", c_uint64), ("position_b_stride", c_uint64), ("orientation_b_stride", c_uint64)]
class carom_device_info(Structure):
    _fields_ = [("struct_size", c_uint32), ("reserved", c_uint32), ("name", c_char * 128), ("version", c_char * 128), ("pairs", c_uint64), ("host_pairs", c_uint64)]
class carom_particles_desc(Structure):
    _fields_ = [("struct_size", c_uint32), ("reserved", c_uint32), ("gravity_factor", c_double), ("linear_damping", c_double), ("mass", c_double), ("capacity", c_uint64)]
class carom_plan_line(Structure):
    _fields_ = [("effect", c_uint32), ("stage", c_uint32), ("mode", c_uint32), ("runs", c_uint32), ("participants", c_uint64), ("wanted", c_uint64), ("evaluations", c_uint64), ("bytes", c_uint64), ("seconds", c_double), ("timing", c_uint32), ("reserved", c_uint32), ("name", c_char * 32), ("unit", c_char * 24), ("reason", c_char * 128)]
class carom_param(Structure):
    _fields_ = [("name", c_char_p), ("unit", c_char_p), ("min", c_double), ("max", c_double)]
class carom_param_rule(Structure):
    _fields_ = [("text", c_char_p), ("term_count", c_uint32), ("param", c_uint32 * 4), ("weight", c_double * 4), ("most", c_double)]
class carom_geometry(Structure):
    _fields_ = [("struct_size", c_uint32), ("form", c_uint32), ("form_arg", c_uint32 * 4), ("core_radius_param", c_uint32), ("mass_form", c_uint32), ("mass_arg", c_uint32 * 4)]
class carom_shape_plugin(Structure):
    _fields_ = [("struct_size", c_uint32), ("abi_major", c_uint32), ("abi_minor", c_uint32), ("flags", c_uint32), ("id", c_char_p), ("version", c_uint32), ("param_count", c_uint32), ("params", POINTER(carom_param)), ("geometry", POINTER(carom_geometry)), ("support", carom_support_fn), ("param_tail_group", c_uint32), ("param_tail_min", c_uint32), ("rules", POINTER(carom_param_rule)), ("rule_count", c_uint32), ("reserved", c_uint32), ("user", c_void_p), ("text", c_char_p)]
class carom_distance_desc(Structure):
    _fields_ = [("struct_size", c_uint32), ("simplex", c_uint32), ("narrow_phase", c_uint32), ("pair_routines", c_uint32), ("tolerance", c_double), ("hybrid_margin", c_double), ("gjk_iterations", c_uint32), ("epa_iterations", c_uint32)]
class carom_distance(Structure):
    _fields_ = [("struct_size", c_uint32), ("status", c_uint32), ("separation", c_double), ("lower", c_double), ("upper", c_double), ("normal", c_double * 3), ("point_a", c_double * 3), ("point_b", c_double * 3), ("gjk_iterations", c_uint32), ("epa_iterations", c_uint32), ("support_calls", c_uint32), ("reserved", c_uint32)]
class carom_difference(Structure):
    _fields_ = [("struct_size", c_uint32), ("differs", c_uint32), ("first", c_uint64), ("second", c_uint64), ("sections", c_char * 240)]
class carom_residuals(Structure):
    _fields_ = [("struct_size", c_uint32), ("ledger_is_kept", c_uint32), ("contact_points", c_uint64), ("joints", c_uint64), ("max_penetration", c_double), ("mean_penetration", c_double), ("joint_gap", c_double), ("joint_angle", c_double), ("complementarity", c_double), ("cone", c_double), ("slip", c_double), ("energy", c_double), ("energy_drift", c_double)]
class carom_mesh_desc(Structure):
    _fields_ = [("struct_size", c_uint32), ("flags", c_uint32), ("vertices", POINTER(c_double)), ("vertex_count", c_uint64), ("triangles", POINTER(c_uint32)), ("triangle_count", c_uint64)]
class carom_height_field_desc(Structure):
    _fields_ = [("struct_size", c_uint32), ("flags", c_uint32), ("columns", c_uint32), ("rows", c_uint32), ("heights", POINTER(c_double)), ("spacing", c_double * 2)]
class carom_scenery_info(Structure):
    _fields_ = [("struct_size", c_uint32), ("flags", c_uint32), ("triangles", c_uint64), ("vertices", c_uint64), ("dropped", c_uint64), ("boundary_edges", c_uint64), ("bytes", c_uint64)]
class carom_shape_info(Structure):
    _fields_ = [("struct_size", c_uint32), ("form", c_uint32), ("is_half_space", c_uint32), ("mass_exact", c_uint32), ("plugin", carom_plugin), ("param_count", c_uint64), ("core_radius", c_double), ("bounding_radius", c_double), ("aabb_min", c_double * 3), ("aabb_max", c_double * 3), ("volume", c_double), ("volume_min", c_double), ("volume_max", c_double), ("centroid", c_double * 3), ("centroid_error", c_double), ("inertia", c_double * 9), ("inertia_error", c_double), ("is_scenery", c_uint32), ("reserved", c_uint32)]
class carom_tree_coordinate(Structure):
    _fields_ = [("joint", carom_joint), ("body", carom_body), ("axis", c_uint32), ("reserved", c_uint32)]
class carom_vehicle_desc(Structure):
    _fields_ = [("struct_size", c_uint32), ("flags", c_uint32), ("chassis", carom_body), ("up", c_double * 3), ("forward", c_double * 3), ("category", c_uint64), ("mask", c_uint64), ("torque_count", c_uint32), ("gear_count", c_uint32), ("torque_speeds", c_double * 8), ("torques", c_double * 8), ("idle_speed", c_double), ("max_speed", c_double), ("engine_inertia", c_double), ("engine_drag", c_double), ("gears", c_double * 8), ("reverse", c_double), ("final_drive", c_double), ("clutch_torque", c_double), ("shift_up", c_double), ("shift_down", c_double), ("shift_time", c_double), ("limited_slip", c_double)]
class carom_wheel_desc(Structure):
    _fields_ = [("struct_size", c_uint32), ("anti_roll_partner", c_uint32), ("shape", carom_shape), ("position", c_double * 3), ("radius", c_double), ("inertia", c_double), ("travel", c_double), ("stiffness", c_double), ("damping_bump", c_double), ("damping_rebound", c_double), ("anti_roll", c_double), ("max_steer", c_double), ("drive", c_double), ("brake", c_double), ("handbrake", c_double), ("rolling", c_double), ("grip", c_double), ("side_grip", c_double), ("peak_slip", c_double), ("side_peak_slip", c_double), ("slide", c_double), ("slide_slip", c_double), ("relaxation", c_double)]
class carom_vehicle_input(Structure):
    _fields_ = [("struct_size", c_uint32), ("gear", c_int32), ("throttle", c_double), ("brake", c_double), ("handbrake", c_double), ("steer", c_double)]
class carom_vehicle(Structure):
    _fields_ = [("struct_size", c_uint32), ("gear", c_int32), ("engine_speed", c_double), ("shifting", c_double), ("since_shift", c_double), ("speed", c_double)]
class carom_wheel(Structure):
    _fields_ = [("struct_size", c_uint32), ("touches", c_uint32), ("body", carom_body), ("collider", carom_collider), ("point", c_double * 3), ("normal", c_double * 3), ("position", c_double * 3), ("compression", c_double), ("spin", c_double), ("angle", c_double), ("steer", c_double), ("load", c_double), ("force", c_double), ("side_force", c_double), ("slip", c_double), ("side_slip", c_double)]
class carom_world_desc(Structure):
    _fields_ = [("struct_size", c_uint32), ("reserved", c_uint32), ("gravity", c_double * 3), ("body_capacity", c_uint64)]
class carom_step_report(Structure):
    _fields_ = [("struct_size", c_uint32), ("stage_count", c_uint32), ("stage_seconds", c_double * 16), ("total_seconds", c_double), ("steps", c_uint64), ("time", c_double), ("bodies", c_uint64), ("dynamic_bodies", c_uint64), ("colliders", c_uint64), ("broad_pairs", c_uint64), ("contact_pairs", c_uint64), ("contact_points", c_uint64), ("groups", c_uint64), ("largest_group", c_uint64), ("gjk_calls", c_uint64), ("epa_calls", c_uint64), ("support_calls", c_uint64), ("velocity_impulses", c_uint64), ("position_moves", c_uint64), ("quarantined_bodies", c_uint64), ("faults", c_uint64), ("max_penetration", c_double), ("mean_penetration", c_double), ("max_closing_speed", c_double), ("linear_energy", c_double), ("angular_energy", c_double), ("asleep_bodies", c_uint64), ("fell_asleep", c_uint64), ("woke_up", c_uint64), ("direct_groups", c_uint64), ("solver_residual", c_double), ("particles", c_uint64), ("quarantined_particles", c_uint64), ("swept_bodies", c_uint64), ("sweep_hits", c_uint64), ("wedged_groups", c_uint64), ("rejected_solutions", c_uint64), ("excess_energy", c_double)]
class carom_contact(Structure):
    _fields_ = [("collider_a", carom_collider), ("collider_b", carom_collider), ("body_a", carom_body), ("body_b", carom_body), ("point", c_double * 3), ("normal", c_double * 3), ("separation", c_double), ("normal_impulse", c_double), ("friction_impulse", c_double)]
class carom_group(Structure):
    _fields_ = [("body", carom_body), ("bodies", c_uint32), ("points", c_uint32), ("solver", c_uint32), ("reason", c_uint32), ("mass_ratio", c_double), ("sink", c_double)]
class carom_fault(Structure):
    _fields_ = [("kind", c_uint32), ("reserved", c_uint32), ("shape", carom_shape), ("body", carom_body), ("dir", c_double * 3), ("out", c_double * 3), ("particles", carom_particles), ("particle", c_uint64)]
class carom_query_desc(Structure):
    _fields_ = [("struct_size", c_uint32), ("flags", c_uint32), ("category", c_uint64), ("mask", c_uint64), ("ignore", carom_body), ("tolerance", c_double), ("target", c_double), ("iterations", c_uint32), ("reserved", c_uint32)]
class carom_world_hit(Structure):
    _fields_ = [("outcome", c_uint32), ("status", c_uint32), ("query", c_uint64), ("collider", carom_collider), ("body", carom_body), ("time", c_double), ("lower", c_double), ("upper", c_double), ("separation", c_double), ("normal", c_double * 3), ("point", c_double * 3), ("point_own", c_double * 3)]
class carom_query_shapes(Structure):
    _fields_ = [("struct_size", c_uint32), ("scalar", c_uint32), ("count", c_uint64), ("shapes", POINTER(carom_shape)), ("positions", c_void_p), ("orientations", c_void_p), ("motions", c_void_p), ("shape_stride", c_uint64), ("position_stride", c_uint64), ("orientation_stride", c_uint64), ("motion_stride", c_uint64)]
class carom_world_hits(Structure):
    _fields_ = [("struct_size", c_uint32), ("scalar", c_uint32), ("records", POINTER(carom_world_hit)), ("outcomes", POINTER(c_uint32)), ("colliders", POINTER(carom_collider)), ("times", c_void_p), ("normals", c_void_p), ("points", c_void_p), ("record_stride", c_uint64), ("outcome_stride", c_uint64), ("collider_stride", c_uint64), ("time_stride", c_uint64), ("normal_stride", c_uint64), ("point_stride", c_uint64)]

STRUCTS = {
    "carom_error": carom_error,
    "carom_accuracy": carom_accuracy,
    "carom_island": carom_island,
    "carom_growth": carom_growth,
    "carom_batch_column": carom_batch_column,
    "carom_batch_info": carom_batch_info,
    "carom_material_desc": carom_material_desc,
    "carom_body_desc": carom_body_desc,
    "carom_attribute_info": carom_attribute_info,
    "carom_collider_desc": carom_collider_desc,
    "carom_cast_desc": carom_cast_desc,
    "carom_cast": carom_cast,
    "carom_motion": carom_motion,
    "carom_overlap": carom_overlap,
    "carom_rays": carom_rays,
    "carom_ray_hit": carom_ray_hit,
    "carom_ray_hits": carom_ray_hits,
    "carom_character_desc": carom_character_desc,
    "carom_character": carom_character,
    "carom_dial_info": carom_dial_info,
    "carom_constant_info": carom_constant_info,
    "carom_draw_desc": carom_draw_desc,
    "carom_draw_line": carom_draw_line,
    "carom_engine_desc": carom_engine_desc,
    "carom_jobs_desc": carom_jobs_desc,
    "carom_contact_event": carom_contact_event,
    "carom_sensor_event": carom_sensor_event,
    "carom_sleep_event": carom_sleep_event,
    "carom_joint_event": carom_joint_event,
    "carom_fault_event": carom_fault_event,
    "carom_force_field_desc": carom_force_field_desc,
    "carom_spring_desc": carom_spring_desc,
    "carom_water": carom_water,
    "carom_joint_desc": carom_joint_desc,
    "carom_joint_limit": carom_joint_limit,
    "carom_joint_motor": carom_joint_motor,
    "carom_joint_spring": carom_joint_spring,
    "carom_joint_transmission": carom_joint_transmission,
    "carom_joint_coupling": carom_joint_coupling,
    "carom_joint_axis": carom_joint_axis,
    "carom_joint_orientation_drive": carom_joint_orientation_drive,
    "carom_joint_state": carom_joint_state,
    "carom_ledger_entry": carom_ledger_entry,
    "carom_ledger_state": carom_ledger_state,
    "carom_pairs": carom_pairs,
    "carom_device_info": carom_device_info,
    "carom_particles_desc": carom_particles_desc,
    "carom_plan_line": carom_plan_line,
    "carom_param": carom_param,
    "carom_param_rule": carom_param_rule,
    "carom_geometry": carom_geometry,
    "carom_shape_plugin": carom_shape_plugin,
    "carom_distance_desc": carom_distance_desc,
    "carom_distance": carom_distance,
    "carom_difference": carom_difference,
    "carom_residuals": carom_residuals,
    "carom_mesh_desc": carom_mesh_desc,
    "carom_height_field_desc": carom_height_field_desc,
    "carom_scenery_info": carom_scenery_info,
    "carom_shape_info": carom_shape_info,
    "carom_tree_coordinate": carom_tree_coordinate,
    "carom_vehicle_desc": carom_vehicle_desc,
    "carom_wheel_desc": carom_wheel_desc,
    "carom_vehicle_input": carom_vehicle_input,
    "carom_vehicle": carom_vehicle,
    "carom_wheel": carom_wheel,
    "carom_world_desc": carom_world_desc,
    "carom_step_report": carom_step_report,
    "carom_contact": carom_contact,
    "carom_group": carom_group,
    "carom_fault": carom_fault,
    "carom_query_desc": carom_query_desc,
    "carom_world_hit": carom_world_hit,
    "carom_query_shapes": carom_query_shapes,
    "carom_world_hits": carom_world_hits,
}

# which fields are handles, and of what
HANDLES = {
    "carom_island": {'body': 'carom_body'},
    "carom_growth": {'body': 'carom_body'},
    "carom_collider_desc": {'shape': 'carom_shape', 'material': 'carom_material'},
    "carom_character_desc": {'body': 'carom_body'},
    "carom_character": {'shape': 'carom_shape', 'ground_body': 'carom_body', 'ground_collider': 'carom_collider', 'contact_bodies': 'carom_body'},
    "carom_draw_line": {'body': 'carom_body'},
    "carom_contact_event": {'collider_a': 'carom_collider', 'collider_b': 'carom_collider', 'body_a': 'carom_body', 'body_b': 'carom_body'},
    "carom_sensor_event": {'sensor': 'carom_collider', 'other': 'carom_collider', 'sensor_body': 'carom_body', 'other_body': 'carom_body'},
    "carom_sleep_event": {'body': 'carom_body'},
    "carom_joint_event": {'joint': 'carom_joint', 'body_a': 'carom_body', 'body_b': 'carom_body'},
    "carom_fault_event": {'shape': 'carom_shape', 'body': 'carom_body', 'particles': 'carom_particles'},
    "carom_spring_desc": {'body_a': 'carom_body', 'body_b': 'carom_body'},
    "carom_joint_desc": {'body_a': 'carom_body', 'body_b': 'carom_body'},
    "carom_joint_coupling": {'follower': 'carom_joint', 'leader': 'carom_joint'},
    "carom_shape_info": {'plugin': 'carom_plugin'},
    "carom_tree_coordinate": {'joint': 'carom_joint', 'body': 'carom_body'},
    "carom_vehicle_desc": {'chassis': 'carom_body'},
    "carom_wheel_desc": {'shape': 'carom_shape'},
    "carom_wheel": {'body': 'carom_body', 'collider': 'carom_collider'},
    "carom_contact": {'collider_a': 'carom_collider', 'collider_b': 'carom_collider', 'body_a': 'carom_body', 'body_b': 'carom_body'},
    "carom_group": {'body': 'carom_body'},
    "carom_fault": {'shape': 'carom_shape', 'body': 'carom_body', 'particles': 'carom_particles'},
    "carom_query_desc": {'ignore': 'carom_body'},
    "carom_world_hit": {'collider': 'carom_collider', 'body': 'carom_body'},
}

# name: (since, restype, argtypes)
FUNCTIONS = {
    "carom_version": ("0.9", c_int32, (POINTER(c_uint32), POINTER(c_uint32), POINTER(c_uint32),)),
    "carom_result_name": ("0.9", c_char_p, (c_int32,)),
    "carom_result_remedy": ("0.9", c_char_p, (c_int32,)),
    "carom_abi_manifest": ("0.9", c_char_p, ()),
    "carom_abi_check": ("0.9", c_int32, (c_char_p, POINTER(carom_error),)),
    "carom_accuracy_init": ("0.9", c_int32, (POINTER(carom_accuracy), c_uint32,)),
    "carom_world_set_accuracy": ("0.9", c_int32, (c_void_p, POINTER(carom_accuracy), POINTER(carom_error),)),
    "carom_world_get_accuracy": ("0.9", c_int32, (c_void_p, POINTER(carom_accuracy), POINTER(c_uint32), POINTER(carom_error),)),
    "carom_world_get_islands": ("0.9", c_int32, (c_void_p, POINTER(carom_island), c_uint64, c_uint64, POINTER(c_uint64), POINTER(carom_error),)),
    "carom_world_measure_growth": ("0.9", c_int32, (c_void_p, c_double, c_uint32, POINTER(carom_growth), POINTER(carom_error),)),
    "carom_batch_column_init": ("0.9", c_int32, (POINTER(carom_batch_column), c_uint32,)),
    "carom_batch_create": ("0.9", c_int32, (c_void_p, POINTER(c_void_p), POINTER(carom_error),)),
    "carom_batch_destroy": ("0.9", c_int32, (c_void_p, POINTER(carom_error),)),
    "carom_batch_add_worlds": ("0.9", c_int32, (c_void_p, c_void_p, c_uint64, POINTER(c_uint64), POINTER(carom_error),)),
    "carom_batch_add_column": ("0.9", c_int32, (c_void_p, POINTER(carom_batch_column), POINTER(c_uint32), POINTER(carom_error),)),
    "carom_batch_step": ("0.9", c_int32, (c_void_p, POINTER(c_uint8), c_double, c_uint32, POINTER(c_uint64), POINTER(carom_error),)),
    "carom_batch_read": ("0.9", c_int32, (c_void_p, POINTER(c_uint32), c_uint64, POINTER(c_uint8), POINTER(carom_error),)),
    "carom_batch_write": ("0.9", c_int32, (c_void_p, POINTER(c_uint32), c_uint64, POINTER(c_uint8), POINTER(carom_error),)),
    "carom_batch_add_start": ("0.9", c_int32, (c_void_p, c_uint64, c_void_p, c_uint64, POINTER(c_uint32), POINTER(carom_error),)),
    "carom_batch_reset": ("0.9", c_int32, (c_void_p, POINTER(c_uint8), POINTER(c_uint32), POINTER(carom_error),)),
    "carom_batch_save": ("0.9", c_int32, (c_void_p, c_uint64, c_void_p, c_uint64, POINTER(c_uint64), POINTER(carom_error),)),
    "carom_batch_get_hashes": ("0.9", c_int32, (c_void_p, POINTER(c_uint64), c_uint64, POINTER(carom_error),)),
    "carom_batch_get_stopped": ("0.9", c_int32, (c_void_p, POINTER(c_uint32), c_uint64, POINTER(carom_error),)),
    "carom_batch_get_faults": ("0.9", c_int32, (c_void_p, c_uint64, POINTER(carom_fault), c_uint64, c_uint64, POINTER(c_uint64), POINTER(carom_error),)),
    "carom_batch_get_info": ("0.9", c_int32, (c_void_p, POINTER(carom_batch_info), POINTER(carom_error),)),
    "carom_random_fill": ("0.9", c_int32, (c_uint32, POINTER(c_uint64), c_uint64, c_uint64, POINTER(c_double), POINTER(carom_error),)),
    "carom_material_desc_init": ("0.9", c_int32, (POINTER(carom_material_desc), c_uint32,)),
    "carom_material_create": ("0.9", c_int32, (c_void_p, POINTER(carom_material_desc), POINTER(carom_material), POINTER(carom_error),)),
    "carom_material_update": ("0.9", c_int32, (c_void_p, carom_material, POINTER(carom_material_desc), POINTER(carom_error),)),
    "carom_material_set_resistance": ("0.9", c_int32, (c_void_p, carom_material, c_double, c_double, POINTER(carom_error),)),
    "carom_material_get_resistance": ("0.9", c_int32, (c_void_p, carom_material, POINTER(c_double), POINTER(c_double), POINTER(carom_error),)),
    "carom_material_set_pair": ("0.9", c_int32, (c_void_p, carom_material, carom_material, POINTER(c_double), POINTER(carom_error),)),
    "carom_material_get_pair": ("0.9", c_int32, (c_void_p, carom_material, carom_material, POINTER(c_double), POINTER(carom_error),)),
    "carom_material_destroy": ("0.9", c_int32, (c_void_p, carom_material, POINTER(carom_error),)),
    "carom_body_desc_init": ("0.9", c_int32, (POINTER(carom_body_desc), c_uint32,)),
    "carom_body_create": ("0.9", c_int32, (c_void_p, POINTER(carom_body_desc), POINTER(carom_body), POINTER(carom_error),)),
    "carom_body_destroy": ("0.9", c_int32, (c_void_p, carom_body, POINTER(carom_error),)),
    "carom_body_get": ("0.9", c_int32, (c_void_p, carom_body, POINTER(carom_body_desc), POINTER(carom_error),)),
    "carom_body_set_pose": ("0.9", c_int32, (c_void_p, carom_body, POINTER(c_double), POINTER(c_double), POINTER(carom_error),)),
    "carom_body_set_velocity": ("0.9", c_int32, (c_void_p, carom_body, POINTER(c_double), POINTER(c_double), POINTER(carom_error),)),
    "carom_body_get_pose": ("0.9", c_int32, (c_void_p, carom_body, POINTER(c_double), POINTER(c_double), POINTER(carom_error),)),
    "carom_body_get_velocity": ("0.9", c_int32, (c_void_p, carom_body, POINTER(c_double), POINTER(c_double), POINTER(carom_error),)),
    "carom_body_set_mass": ("0.9", c_int32, (c_void_p, carom_body, c_double, POINTER(c_double), POINTER(c_double), POINTER(carom_error),)),
    "carom_body_get_mass": ("0.9", c_int32, (c_void_p, carom_body, POINTER(c_double), POINTER(c_double), POINTER(c_double), POINTER(carom_error),)),
    "carom_body_set_type": ("0.9", c_int32, (c_void_p, carom_body, c_uint32, POINTER(carom_error),)),
    "carom_body_get_type": ("0.9", c_int32, (c_void_p, carom_body, POINTER(c_uint32), POINTER(carom_error),)),
    "carom_body_set_damping": ("0.9", c_int32, (c_void_p, carom_body, c_double, c_double, POINTER(carom_error),)),
    "carom_body_get_damping": ("0.9", c_int32, (c_void_p, carom_body, POINTER(c_double), POINTER(c_double), POINTER(carom_error),)),
    "carom_body_set_user": ("0.9", c_int32, (c_void_p, carom_body, c_uint64, POINTER(carom_error),)),
    "carom_body_get_user": ("0.9", c_int32, (c_void_p, carom_body, POINTER(c_uint64), POINTER(carom_error),)),
    "carom_body_get_colliders": ("0.9", c_int32, (c_void_p, carom_body, POINTER(carom_collider), c_uint64, POINTER(c_uint64), POINTER(carom_error),)),
    "carom_body_add_force": ("0.9", c_int32, (c_void_p, carom_body, POINTER(c_double), POINTER(c_double), POINTER(carom_error),)),
    "carom_body_add_impulse": ("0.9", c_int32, (c_void_p, carom_body, POINTER(c_double), POINTER(c_double), POINTER(carom_error),)),
    "carom_body_set_gravity_factor": ("0.9", c_int32, (c_void_p, carom_body, c_double, POINTER(carom_error),)),
    "carom_body_get_gravity_factor": ("0.9", c_int32, (c_void_p, carom_body, POINTER(c_double), POINTER(carom_error),)),
    "carom_body_set_locks": ("0.9", c_int32, (c_void_p, carom_body, c_uint32, POINTER(carom_error),)),
    "carom_body_get_locks": ("0.9", c_int32, (c_void_p, carom_body, POINTER(c_uint32), POINTER(carom_error),)),
    "carom_attribute_get_info": ("0.9", c_int32, (c_uint32, POINTER(carom_attribute_info), POINTER(carom_error),)),
    "carom_body_set_attribute": ("0.9", c_int32, (c_void_p, carom_body, c_uint32, POINTER(c_double), POINTER(carom_error),)),
    "carom_body_get_attribute": ("0.9", c_int32, (c_void_p, carom_body, c_uint32, POINTER(c_double), POINTER(carom_error),)),
    "carom_body_is_asleep": ("0.9", c_int32, (c_void_p, carom_body, POINTER(c_uint32), POINTER(carom_error),)),
    "carom_body_wake": ("0.9", c_int32, (c_void_p, carom_body, POINTER(carom_error),)),
    "carom_body_set_continuous": ("0.9", c_int32, (c_void_p, carom_body, c_uint32, POINTER(carom_error),)),
    "carom_body_get_continuous": ("0.9", c_int32, (c_void_p, carom_body, POINTER(c_uint32), POINTER(carom_error),)),
    "carom_body_set_enabled": ("0.9", c_int32, (c_void_p, carom_body, c_uint32, POINTER(carom_error),)),
    "carom_body_is_enabled": ("0.9", c_int32, (c_void_p, carom_body, POINTER(c_uint32), POINTER(carom_error),)),
    "carom_collider_desc_init": ("0.9", c_int32, (POINTER(carom_collider_desc), c_uint32,)),
    "carom_collider_create": ("0.9", c_int32, (c_void_p, carom_body, POINTER(carom_collider_desc), POINTER(carom_collider), POINTER(carom_error),)),
    "carom_body_create_named": ("0.9", c_int32, (c_void_p, c_uint32, c_char_p, POINTER(c_double), c_uint64, POINTER(c_double), POINTER(carom_body), POINTER(carom_error),)),
    "carom_collider_destroy": ("0.9", c_int32, (c_void_p, carom_collider, POINTER(carom_error),)),
    "carom_collider_get": ("0.9", c_int32, (c_void_p, carom_collider, POINTER(carom_collider_desc), POINTER(carom_body), POINTER(carom_error),)),
    "carom_collider_set_material": ("0.9", c_int32, (c_void_p, carom_collider, carom_material, POINTER(carom_error),)),
    "carom_collider_set_density": ("0.9", c_int32, (c_void_p, carom_collider, c_double, POINTER(carom_error),)),
    "carom_collider_set_pose": ("0.9", c_int32, (c_void_p, carom_collider, POINTER(c_double), POINTER(c_double), POINTER(carom_error),)),
    "carom_collider_set_surface_velocity": ("0.9", c_int32, (c_void_p, carom_collider, POINTER(c_double), POINTER(c_double), POINTER(carom_error),)),
    "carom_collider_get_surface_velocity": ("0.9", c_int32, (c_void_p, carom_collider, POINTER(c_double), POINTER(c_double), POINTER(carom_error),)),
    "carom_world_get_bodies": ("0.9", c_int32, (c_void_p, POINTER(carom_body), c_uint64, POINTER(c_uint64), POINTER(carom_error),)),
    "carom_world_read": ("0.9", c_int32, (c_void_p, c_uint32, c_uint32, POINTER(carom_body), c_uint64, c_void_p, c_uint64, POINTER(carom_error),)),
    "carom_world_write": ("0.9", c_int32, (c_void_p, c_uint32, c_uint32, POINTER(carom_body), c_uint64, c_void_p, c_uint64, POINTER(carom_error),)),
    "carom_cast_desc_init": ("0.9", c_int32, (POINTER(carom_cast_desc), c_uint32,)),
    "carom_motion_init": ("0.9", c_int32, (POINTER(carom_motion), c_uint32,)),
    "carom_ray_cast": ("0.9", c_int32, (c_void_p, carom_shape, POINTER(c_double), POINTER(c_double), POINTER(c_double), POINTER(c_double), c_double, POINTER(carom_cast_desc), POINTER(carom_cast), POINTER(carom_error),)),
    "carom_shape_cast": ("0.9", c_int32, (c_void_p, carom_shape, POINTER(c_double), POINTER(c_double), POINTER(c_double), carom_shape, POINTER(c_double), POINTER(c_double), POINTER(carom_cast_desc), POINTER(carom_cast), POINTER(carom_error),)),
    "carom_shape_time_of_impact": ("0.9", c_int32, (c_void_p, carom_shape, POINTER(carom_motion), carom_shape, POINTER(carom_motion), c_double, POINTER(carom_cast_desc), POINTER(carom_cast), POINTER(carom_error),)),
    "carom_shape_overlap": ("0.9", c_int32, (c_void_p, carom_shape, POINTER(c_double), POINTER(c_double), carom_shape, POINTER(c_double), POINTER(c_double), POINTER(carom_cast_desc), POINTER(carom_overlap), POINTER(carom_error),)),
    "carom_rays_cast": ("0.9", c_int32, (c_void_p, POINTER(carom_shape), POINTER(c_double), POINTER(c_double), c_uint64, POINTER(carom_rays), POINTER(carom_cast_desc), POINTER(carom_ray_hits), POINTER(carom_error),)),
    "carom_character_desc_init": ("0.9", c_int32, (POINTER(carom_character_desc), c_uint32,)),
    "carom_character_init": ("0.9", c_int32, (POINTER(carom_character), c_uint32,)),
    "carom_character_set_shape": ("0.9", c_int32, (c_void_p, c_void_p, POINTER(carom_character_desc), POINTER(carom_character), carom_shape, POINTER(c_uint32), POINTER(carom_error),)),
    "carom_character_move": ("0.9", c_int32, (c_void_p, POINTER(carom_character_desc), POINTER(carom_character), POINTER(c_double), c_double, c_double, POINTER(carom_error),)),
    "carom_character_push": ("0.9", c_int32, (c_void_p, POINTER(carom_character_desc), POINTER(carom_character), c_double, POINTER(carom_error),)),
    "carom_character_move_body": ("0.9", c_int32, (c_void_p, POINTER(carom_character_desc), POINTER(carom_character), c_double, POINTER(carom_error),)),
    "carom_dial_get_info": ("0.9", c_int32, (c_uint32, POINTER(carom_dial_info), POINTER(carom_error),)),
    "carom_dial_get_count": ("0.9", c_int32, (POINTER(c_uint32),)),
    "carom_dial_find": ("0.9", c_int32, (c_char_p, POINTER(c_uint32), POINTER(carom_error),)),
    "carom_constant_get_count": ("0.9", c_int32, (POINTER(c_uint32),)),
    "carom_constant_get_info": ("0.9", c_int32, (c_uint32, POINTER(carom_constant_info), POINTER(carom_error),)),
    "carom_preset_name": ("0.9", c_char_p, (c_uint32,)),
    "carom_preset_get_dial": ("0.9", c_int32, (c_uint32, c_uint32, POINTER(c_double), POINTER(carom_error),)),
    "carom_draw_desc_init": ("0.9", c_int32, (POINTER(carom_draw_desc), c_uint32,)),
    "carom_world_draw": ("0.9", c_int32, (c_void_p, POINTER(carom_draw_desc), POINTER(carom_draw_line), c_uint64, c_uint64, POINTER(c_uint64), POINTER(carom_error),)),
    "carom_engine_desc_init": ("0.9", c_int32, (POINTER(carom_engine_desc), c_uint32,)),
    "carom_engine_create": ("0.9", c_int32, (POINTER(carom_engine_desc), POINTER(c_void_p), POINTER(carom_error),)),
    "carom_engine_destroy": ("0.9", c_int32, (c_void_p, POINTER(carom_error),)),
    "carom_jobs_desc_init": ("0.9", c_int32, (POINTER(carom_jobs_desc), c_uint32,)),
    "carom_engine_set_jobs": ("0.9", c_int32, (c_void_p, POINTER(carom_jobs_desc), POINTER(carom_error),)),
    "carom_plugin_load": ("0.9", c_int32, (c_void_p, c_char_p, POINTER(carom_plugin), POINTER(carom_error),)),
    "carom_plugin_register": ("0.9", c_int32, (c_void_p, POINTER(carom_shape_plugin), POINTER(carom_plugin), POINTER(carom_error),)),
    "carom_plugins_register_standard": ("0.9", c_int32, (c_void_p, POINTER(carom_error),)),
    "carom_plugin_unload": ("0.9", c_int32, (c_void_p, carom_plugin, POINTER(carom_error),)),
    "carom_plugin_find": ("0.9", c_int32, (c_void_p, c_char_p, POINTER(carom_plugin), POINTER(carom_error),)),
    "carom_plugin_describe": ("0.9", c_int32, (c_void_p, carom_plugin, POINTER(POINTER(carom_shape_plugin)), POINTER(carom_error),)),
    "carom_world_collect_events": ("0.9", c_int32, (c_void_p, c_uint32, c_double, POINTER(carom_error),)),
    "carom_world_get_contact_events": ("0.9", c_int32, (c_void_p, POINTER(carom_contact_event), c_uint64, c_uint64, POINTER(c_uint64), POINTER(carom_error),)),
    "carom_world_get_sensor_events": ("0.9", c_int32, (c_void_p, POINTER(carom_sensor_event), c_uint64, c_uint64, POINTER(c_uint64), POINTER(carom_error),)),
    "carom_world_get_sleep_events": ("0.9", c_int32, (c_void_p, POINTER(carom_sleep_event), c_uint64, c_uint64, POINTER(c_uint64), POINTER(carom_error),)),
    "carom_world_get_joint_events": ("0.9", c_int32, (c_void_p, POINTER(carom_joint_event), c_uint64, c_uint64, POINTER(c_uint64), POINTER(carom_error),)),
    "carom_world_get_fault_events": ("0.9", c_int32, (c_void_p, POINTER(carom_fault_event), c_uint64, c_uint64, POINTER(c_uint64), POINTER(carom_error),)),
    "carom_collider_set_filter": ("0.9", c_int32, (c_void_p, carom_collider, c_uint64, c_uint64, c_int32, POINTER(carom_error),)),
    "carom_collider_get_filter": ("0.9", c_int32, (c_void_p, carom_collider, POINTER(c_uint64), POINTER(c_uint64), POINTER(c_int32), POINTER(carom_error),)),
    "carom_body_set_filter": ("0.9", c_int32, (c_void_p, carom_body, c_uint64, c_uint64, c_int32, POINTER(carom_error),)),
    "carom_body_ignore_collision": ("0.9", c_int32, (c_void_p, carom_body, carom_body, c_uint32, POINTER(carom_error),)),
    "carom_collider_set_sensor": ("0.9", c_int32, (c_void_p, carom_collider, c_uint32, POINTER(carom_error),)),
    "carom_collider_is_sensor": ("0.9", c_int32, (c_void_p, carom_collider, POINTER(c_uint32), POINTER(carom_error),)),
    "carom_body_add_force_at": ("0.9", c_int32, (c_void_p, carom_body, POINTER(c_double), POINTER(c_double), POINTER(carom_error),)),
    "carom_body_set_drag": ("0.9", c_int32, (c_void_p, carom_body, c_double, c_double, POINTER(carom_error),)),
    "carom_body_get_drag": ("0.9", c_int32, (c_void_p, carom_body, POINTER(c_double), POINTER(c_double), POINTER(carom_error),)),
    "carom_world_set_wind": ("0.9", c_int32, (c_void_p, POINTER(c_double), POINTER(carom_error),)),
    "carom_world_get_wind": ("0.9", c_int32, (c_void_p, POINTER(c_double), POINTER(carom_error),)),
    "carom_force_field_name": ("0.9", c_char_p, (c_uint32,)),
    "carom_force_field_desc_init": ("0.9", c_int32, (POINTER(carom_force_field_desc), c_uint32,)),
    "carom_force_field_create": ("0.9", c_int32, (c_void_p, POINTER(carom_force_field_desc), POINTER(carom_force_field), POINTER(carom_error),)),
    "carom_force_field_update": ("0.9", c_int32, (c_void_p, carom_force_field, POINTER(carom_force_field_desc), POINTER(carom_error),)),
    "carom_force_field_get": ("0.9", c_int32, (c_void_p, carom_force_field, POINTER(carom_force_field_desc), POINTER(carom_error),)),
    "carom_force_field_destroy": ("0.9", c_int32, (c_void_p, carom_force_field, POINTER(carom_error),)),
    "carom_body_set_force_field_mask": ("0.9", c_int32, (c_void_p, carom_body, c_uint32, POINTER(carom_error),)),
    "carom_body_get_force_field_mask": ("0.9", c_int32, (c_void_p, carom_body, POINTER(c_uint32), POINTER(carom_error),)),
    "carom_spring_desc_init": ("0.9", c_int32, (POINTER(carom_spring_desc), c_uint32,)),
    "carom_spring_create": ("0.9", c_int32, (c_void_p, POINTER(carom_spring_desc), POINTER(carom_spring), POINTER(carom_error),)),
    "carom_spring_update": ("0.9", c_int32, (c_void_p, carom_spring, c_double, c_double, c_double, POINTER(carom_error),)),
    "carom_spring_get": ("0.9", c_int32, (c_void_p, carom_spring, POINTER(carom_spring_desc), POINTER(carom_error),)),
    "carom_spring_get_state": ("0.9", c_int32, (c_void_p, carom_spring, POINTER(c_double), POINTER(c_double), POINTER(carom_error),)),
    "carom_spring_destroy": ("0.9", c_int32, (c_void_p, carom_spring, POINTER(carom_error),)),
    "carom_water_init": ("0.9", c_int32, (POINTER(carom_water), c_uint32,)),
    "carom_world_set_water": ("0.9", c_int32, (c_void_p, POINTER(carom_water), POINTER(carom_error),)),
    "carom_world_get_water": ("0.9", c_int32, (c_void_p, POINTER(carom_water), POINTER(c_uint32), POINTER(carom_error),)),
    "carom_joint_kind_name": ("0.9", c_char_p, (c_uint32,)),
    "carom_joint_desc_init": ("0.9", c_int32, (POINTER(carom_joint_desc), c_uint32,)),
    "carom_joint_limit_init": ("0.9", c_int32, (POINTER(carom_joint_limit), c_uint32,)),
    "carom_joint_motor_init": ("0.9", c_int32, (POINTER(carom_joint_motor), c_uint32,)),
    "carom_joint_spring_init": ("0.9", c_int32, (POINTER(carom_joint_spring), c_uint32,)),
    "carom_joint_transmission_init": ("0.9", c_int32, (POINTER(carom_joint_transmission), c_uint32,)),
    "carom_joint_coupling_init": ("0.9", c_int32, (POINTER(carom_joint_coupling), c_uint32,)),
    "carom_joint_axis_init": ("0.9", c_int32, (POINTER(carom_joint_axis), c_uint32,)),
    "carom_joint_orientation_drive_init": ("0.9", c_int32, (POINTER(carom_joint_orientation_drive), c_uint32,)),
    "carom_joint_create": ("0.9", c_int32, (c_void_p, POINTER(carom_joint_desc), POINTER(carom_joint), POINTER(carom_error),)),
    "carom_joint_destroy": ("0.9", c_int32, (c_void_p, carom_joint, POINTER(carom_error),)),
    "carom_joint_get": ("0.9", c_int32, (c_void_p, carom_joint, POINTER(carom_joint_desc), POINTER(carom_error),)),
    "carom_joint_get_state": ("0.9", c_int32, (c_void_p, carom_joint, POINTER(carom_joint_state), POINTER(carom_error),)),
    "carom_joint_set_limit": ("0.9", c_int32, (c_void_p, carom_joint, c_uint32, POINTER(carom_joint_limit), POINTER(carom_error),)),
    "carom_joint_set_motor": ("0.9", c_int32, (c_void_p, carom_joint, c_uint32, POINTER(carom_joint_motor), POINTER(carom_error),)),
    "carom_joint_set_spring": ("0.9", c_int32, (c_void_p, carom_joint, c_uint32, POINTER(carom_joint_spring), POINTER(carom_error),)),
    "carom_joint_get_limit": ("0.9", c_int32, (c_void_p, carom_joint, c_uint32, POINTER(carom_joint_limit), POINTER(carom_error),)),
    "carom_joint_get_motor": ("0.9", c_int32, (c_void_p, carom_joint, c_uint32, POINTER(carom_joint_motor), POINTER(carom_error),)),
    "carom_joint_get_spring": ("0.9", c_int32, (c_void_p, carom_joint, c_uint32, POINTER(carom_joint_spring), POINTER(carom_error),)),
    "carom_joint_set_transmission": ("0.9", c_int32, (c_void_p, carom_joint, POINTER(carom_joint_transmission), POINTER(carom_error),)),
    "carom_joint_get_transmission": ("0.9", c_int32, (c_void_p, carom_joint, POINTER(carom_joint_transmission), POINTER(carom_error),)),
    "carom_joint_couple": ("0.9", c_int32, (c_void_p, POINTER(carom_joint_coupling), POINTER(carom_joint), POINTER(carom_error),)),
    "carom_joint_set_coupling": ("0.9", c_int32, (c_void_p, carom_joint, POINTER(carom_joint_coupling), POINTER(carom_error),)),
    "carom_joint_get_coupling": ("0.9", c_int32, (c_void_p, carom_joint, POINTER(carom_joint_coupling), POINTER(carom_error),)),
    "carom_joint_set_axis": ("0.9", c_int32, (c_void_p, carom_joint, c_uint32, POINTER(carom_joint_axis), POINTER(carom_error),)),
    "carom_joint_get_axis": ("0.9", c_int32, (c_void_p, carom_joint, c_uint32, POINTER(carom_joint_axis), POINTER(carom_error),)),
    "carom_joint_set_orientation_drive": ("0.9", c_int32, (c_void_p, carom_joint, POINTER(carom_joint_orientation_drive), POINTER(carom_error),)),
    "carom_joint_get_orientation_drive": ("0.9", c_int32, (c_void_p, carom_joint, POINTER(carom_joint_orientation_drive), POINTER(carom_error),)),
    "carom_joint_bulk_width": ("0.9", c_int32, (c_uint32, POINTER(c_uint32),)),
    "carom_world_read_joints": ("0.9", c_int32, (c_void_p, c_uint32, c_uint32, POINTER(carom_joint), c_uint64, c_void_p, c_uint64, POINTER(carom_error),)),
    "carom_world_write_joints": ("0.9", c_int32, (c_void_p, c_uint32, c_uint32, POINTER(carom_joint), c_uint64, c_void_p, c_uint64, POINTER(carom_error),)),
    "carom_world_get_joints": ("0.9", c_int32, (c_void_p, POINTER(carom_joint), c_uint64, POINTER(c_uint64), POINTER(carom_error),)),
    "carom_world_enable_ledger": ("0.9", c_int32, (c_void_p, c_uint32, POINTER(carom_error),)),
    "carom_world_get_ledger": ("0.9", c_int32, (c_void_p, POINTER(carom_ledger_entry), c_uint64, c_uint64, POINTER(c_uint64), POINTER(carom_error),)),
    "carom_world_get_ledger_state": ("0.9", c_int32, (c_void_p, POINTER(carom_ledger_state), POINTER(carom_error),)),
    "carom_pairs_distance": ("0.9", c_int32, (c_void_p, POINTER(carom_pairs), POINTER(carom_distance_desc), POINTER(carom_distance), c_uint64, POINTER(carom_error),)),
    "carom_device_create": ("0.9", c_int32, (c_void_p, c_uint32, POINTER(c_void_p), POINTER(carom_error),)),
    "carom_device_destroy": ("0.9", c_int32, (c_void_p, POINTER(carom_error),)),
    "carom_device_get_info": ("0.9", c_int32, (c_void_p, POINTER(carom_device_info), POINTER(carom_error),)),
    "carom_device_pairs_distance": ("0.9", c_int32, (c_void_p, POINTER(carom_pairs), POINTER(carom_distance_desc), POINTER(carom_distance), c_uint64, POINTER(carom_error),)),
    "carom_particles_desc_init": ("0.9", c_int32, (POINTER(carom_particles_desc), c_uint32,)),
    "carom_particles_create": ("0.9", c_int32, (c_void_p, POINTER(carom_particles_desc), POINTER(carom_particles), POINTER(carom_error),)),
    "carom_particles_destroy": ("0.9", c_int32, (c_void_p, carom_particles, POINTER(carom_error),)),
    "carom_particles_get": ("0.9", c_int32, (c_void_p, carom_particles, POINTER(carom_particles_desc), POINTER(carom_error),)),
    "carom_particles_update": ("0.9", c_int32, (c_void_p, carom_particles, POINTER(carom_particles_desc), POINTER(carom_error),)),
    "carom_particles_get_count": ("0.9", c_int32, (c_void_p, carom_particles, POINTER(c_uint64), POINTER(carom_error),)),
    "carom_particles_add": ("0.9", c_int32, (c_void_p, carom_particles, c_uint64, c_uint32, c_void_p, c_uint64, c_void_p, c_uint64, POINTER(carom_error),)),
    "carom_particles_remove": ("0.9", c_int32, (c_void_p, carom_particles, POINTER(c_uint32), c_uint64, POINTER(carom_error),)),
    "carom_particles_read": ("0.9", c_int32, (c_void_p, carom_particles, c_uint32, c_uint32, POINTER(c_uint32), c_uint64, c_void_p, c_uint64, POINTER(carom_error),)),
    "carom_particles_write": ("0.9", c_int32, (c_void_p, carom_particles, c_uint32, c_uint32, POINTER(c_uint32), c_uint64, c_void_p, c_uint64, POINTER(carom_error),)),
    "carom_particles_get_quarantined": ("0.9", c_int32, (c_void_p, carom_particles, POINTER(c_uint32), c_uint64, POINTER(c_uint64), POINTER(carom_error),)),
    "carom_world_get_particles": ("0.9", c_int32, (c_void_p, POINTER(carom_particles), c_uint64, POINTER(c_uint64), POINTER(carom_error),)),
    "carom_effect_name": ("0.9", c_char_p, (c_uint32,)),
    "carom_world_set_effect": ("0.9", c_int32, (c_void_p, c_uint32, c_uint32, POINTER(carom_error),)),
    "carom_world_get_effect": ("0.9", c_int32, (c_void_p, c_uint32, POINTER(c_uint32), POINTER(carom_error),)),
    "carom_body_set_effect": ("0.9", c_int32, (c_void_p, carom_body, c_uint32, c_uint32, POINTER(carom_error),)),
    "carom_body_get_effect": ("0.9", c_int32, (c_void_p, carom_body, c_uint32, POINTER(c_uint32), POINTER(carom_error),)),
    "carom_world_time_effects": ("0.9", c_int32, (c_void_p, c_uint32, POINTER(carom_error),)),
    "carom_world_get_plan": ("0.9", c_int32, (c_void_p, POINTER(carom_plan_line), c_uint64, c_uint64, POINTER(c_uint64), POINTER(carom_error),)),
    "carom_distance_desc_init": ("0.9", c_int32, (POINTER(carom_distance_desc), c_uint32,)),
    "carom_shape_distance": ("0.9", c_int32, (c_void_p, carom_shape, POINTER(c_double), POINTER(c_double), carom_shape, POINTER(c_double), POINTER(c_double), POINTER(carom_distance_desc), POINTER(carom_distance), POINTER(carom_error),)),
    "carom_world_record_begin": ("0.9", c_int32, (c_void_p, c_uint32, carom_write_fn, c_void_p, POINTER(carom_error),)),
    "carom_world_record_end": ("0.9", c_int32, (c_void_p, POINTER(carom_error),)),
    "carom_world_compare": ("0.9", c_int32, (c_void_p, c_void_p, c_uint64, POINTER(carom_difference), POINTER(carom_error),)),
    "carom_world_get_residuals": ("0.9", c_int32, (c_void_p, POINTER(carom_residuals), POINTER(carom_error),)),
    "carom_world_set_budget": ("0.9", c_int32, (c_void_p, c_double, c_uint32, c_uint32, POINTER(carom_error),)),
    "carom_world_get_budget": ("0.9", c_int32, (c_void_p, POINTER(c_double), POINTER(c_uint32), POINTER(c_uint32), POINTER(carom_error),)),
    "carom_mesh_desc_init": ("0.9", c_int32, (POINTER(carom_mesh_desc), c_uint32,)),
    "carom_shape_create_mesh": ("0.9", c_int32, (c_void_p, POINTER(carom_mesh_desc), POINTER(carom_shape), POINTER(carom_error),)),
    "carom_height_field_desc_init": ("0.9", c_int32, (POINTER(carom_height_field_desc), c_uint32,)),
    "carom_shape_create_height_field": ("0.9", c_int32, (c_void_p, POINTER(carom_height_field_desc), POINTER(carom_shape), POINTER(carom_error),)),
    "carom_shape_get_scenery_info": ("0.9", c_int32, (c_void_p, carom_shape, POINTER(carom_scenery_info), POINTER(carom_error),)),
    "carom_shape_get_triangles": ("0.9", c_int32, (c_void_p, carom_shape, c_uint64, POINTER(c_double), POINTER(c_uint64), POINTER(c_uint64), POINTER(carom_error),)),
    "carom_shape_create": ("0.9", c_int32, (c_void_p, carom_plugin, POINTER(c_double), c_uint64, POINTER(carom_shape), POINTER(carom_error),)),
    "carom_shape_create_named": ("0.9", c_int32, (c_void_p, c_char_p, POINTER(c_double), c_uint64, POINTER(carom_shape), POINTER(carom_error),)),
    "carom_shape_create_half_space": ("0.9", c_int32, (c_void_p, POINTER(c_double), c_double, POINTER(carom_shape), POINTER(carom_error),)),
    "carom_shape_create_hull_of": ("0.9", c_int32, (c_void_p, POINTER(carom_shape), c_uint64, POINTER(c_double), POINTER(c_double), POINTER(c_double), c_double, POINTER(carom_shape), POINTER(carom_error),)),
    "carom_shape_get_parts": ("0.9", c_int32, (c_void_p, carom_shape, POINTER(carom_shape), POINTER(c_double), POINTER(c_double), POINTER(c_double), POINTER(c_uint64), POINTER(c_double), POINTER(carom_error),)),
    "carom_shape_destroy": ("0.9", c_int32, (c_void_p, carom_shape, POINTER(carom_error),)),
    "carom_shape_get_info": ("0.9", c_int32, (c_void_p, carom_shape, POINTER(carom_shape_info), POINTER(carom_error),)),
    "carom_shape_get_params": ("0.9", c_int32, (c_void_p, carom_shape, POINTER(c_double), POINTER(c_uint64), POINTER(carom_error),)),
    "carom_shape_support": ("0.9", c_int32, (c_void_p, carom_shape, POINTER(c_double), c_uint64, POINTER(c_double), POINTER(carom_error),)),
    "carom_world_save": ("0.9", c_int32, (c_void_p, c_uint32, c_void_p, c_uint64, POINTER(c_uint64), POINTER(carom_error),)),
    "carom_world_restore": ("0.9", c_int32, (c_void_p, c_void_p, c_uint64, POINTER(carom_error),)),
    "carom_world_fork": ("0.9", c_int32, (c_void_p, POINTER(c_void_p), POINTER(carom_error),)),
    "carom_world_translate_handles": ("0.9", c_int32, (c_void_p, POINTER(c_uint64), c_uint64, POINTER(c_uint64), POINTER(carom_error),)),
    "carom_tree_get_coordinates": ("0.9", c_int32, (c_void_p, carom_body, POINTER(carom_tree_coordinate), c_uint64, c_uint64, POINTER(c_uint64), POINTER(carom_error),)),
    "carom_tree_get_speeds": ("0.9", c_int32, (c_void_p, carom_body, POINTER(c_double), c_uint64, POINTER(carom_error),)),
    "carom_tree_get_forces": ("0.9", c_int32, (c_void_p, carom_body, POINTER(c_double), POINTER(c_double), POINTER(c_double), c_uint64, POINTER(carom_error),)),
    "carom_tree_get_mass": ("0.9", c_int32, (c_void_p, carom_body, POINTER(c_double), c_uint64, POINTER(carom_error),)),
    "carom_vehicle_desc_init": ("0.9", c_int32, (POINTER(carom_vehicle_desc), c_uint32,)),
    "carom_wheel_desc_init": ("0.9", c_int32, (POINTER(carom_wheel_desc), c_uint32,)),
    "carom_vehicle_input_init": ("0.9", c_int32, (POINTER(carom_vehicle_input), c_uint32,)),
    "carom_vehicle_init": ("0.9", c_int32, (POINTER(carom_vehicle), c_uint32,)),
    "carom_wheel_init": ("0.9", c_int32, (POINTER(carom_wheel), c_uint32,)),
    "carom_vehicle_drive": ("0.9", c_int32, (c_void_p, POINTER(carom_vehicle_desc), POINTER(carom_wheel_desc), c_uint64, POINTER(carom_vehicle_input), POINTER(carom_vehicle), POINTER(carom_wheel), c_double, POINTER(carom_error),)),
    "carom_world_desc_init": ("0.9", c_int32, (POINTER(carom_world_desc), c_uint32,)),
    "carom_world_create": ("0.9", c_int32, (c_void_p, POINTER(carom_world_desc), POINTER(c_void_p), POINTER(carom_error),)),
    "carom_world_destroy": ("0.9", c_int32, (c_void_p, POINTER(carom_error),)),
    "carom_world_step": ("0.9", c_int32, (c_void_p, c_double, POINTER(carom_error),)),
    "carom_world_set_dial": ("0.9", c_int32, (c_void_p, c_uint32, c_double, POINTER(carom_error),)),
    "carom_world_get_dial": ("0.9", c_int32, (c_void_p, c_uint32, POINTER(c_double), POINTER(carom_error),)),
    "carom_world_set_preset": ("0.9", c_int32, (c_void_p, c_uint32, POINTER(carom_error),)),
    "carom_world_set_gravity": ("0.9", c_int32, (c_void_p, POINTER(c_double), POINTER(carom_error),)),
    "carom_world_get_gravity": ("0.9", c_int32, (c_void_p, POINTER(c_double), POINTER(carom_error),)),
    "carom_world_get_report": ("0.9", c_int32, (c_void_p, POINTER(carom_step_report), POINTER(carom_error),)),
    "carom_stage_name": ("0.9", c_char_p, (c_uint32,)),
    "carom_world_get_contacts": ("0.9", c_int32, (c_void_p, POINTER(carom_contact), c_uint64, c_uint64, POINTER(c_uint64), POINTER(carom_error),)),
    "carom_world_get_groups": ("0.9", c_int32, (c_void_p, POINTER(carom_group), c_uint64, c_uint64, POINTER(c_uint64), POINTER(carom_error),)),
    "carom_world_get_faults": ("0.9", c_int32, (c_void_p, POINTER(carom_fault), c_uint64, c_uint64, POINTER(c_uint64), POINTER(carom_error),)),
    "carom_world_hash": ("0.9", c_int32, (c_void_p, POINTER(c_uint64), POINTER(carom_error),)),
    "carom_query_desc_init": ("0.9", c_int32, (POINTER(carom_query_desc), c_uint32,)),
    "carom_world_cast_ray": ("0.9", c_int32, (c_void_p, POINTER(c_double), POINTER(c_double), c_double, POINTER(carom_query_desc), POINTER(carom_world_hit), c_uint64, POINTER(carom_error),)),
    "carom_world_cast_rays": ("0.9", c_int32, (c_void_p, POINTER(carom_rays), c_uint32, POINTER(carom_query_desc), POINTER(carom_world_hits), POINTER(carom_error),)),
    "carom_world_cast_rays_all": ("0.9", c_int32, (c_void_p, POINTER(carom_rays), POINTER(carom_query_desc), POINTER(carom_world_hit), c_uint64, c_uint64, POINTER(c_uint64), POINTER(carom_error),)),
    "carom_world_cast_shapes": ("0.9", c_int32, (c_void_p, POINTER(carom_query_shapes), c_uint32, POINTER(carom_query_desc), POINTER(carom_world_hit), c_uint64, POINTER(carom_error),)),
    "carom_world_cast_shapes_all": ("0.9", c_int32, (c_void_p, POINTER(carom_query_shapes), POINTER(carom_query_desc), POINTER(carom_world_hit), c_uint64, c_uint64, POINTER(c_uint64), POINTER(carom_error),)),
    "carom_world_overlap_shapes": ("0.9", c_int32, (c_void_p, POINTER(carom_query_shapes), POINTER(carom_query_desc), POINTER(carom_world_hit), c_uint64, c_uint64, POINTER(c_uint64), POINTER(carom_error),)),
    "carom_world_find_nearest": ("0.9", c_int32, (c_void_p, POINTER(carom_query_shapes), c_double, POINTER(carom_query_desc), POINTER(carom_world_hit), c_uint64, POINTER(carom_error),)),
}
