"""Written by bindings/gen/generate from include/carom; do not edit."""
import builtins
import ctypes
from typing import Any

VERSION: str
FILE: str
LIBRARY: str
lib: ctypes.CDLL
STRUCTS: dict[str, type[ctypes.Structure]]
HANDLES: dict[str, dict[str, str]]
FUNCTIONS: dict[str, tuple[str, Any, tuple[Any, ...]]]
def layout() -> dict[str, tuple[int, int, str]]: ...
def check_layout(manifest: str, ours: dict[str, tuple[int, int, str]] | None = ...) -> None: ...
CAROM_VERSION_MAJOR: int
CAROM_VERSION_MINOR: int
CAROM_VERSION_PATCH: int
CAROM_OK: int
CAROM_E_NULL_ARGUMENT: int
CAROM_E_NOT_FINITE: int
CAROM_E_OUT_OF_RANGE: int
CAROM_E_NOT_UNIT: int
CAROM_E_UNKNOWN_ENUM: int
CAROM_E_STRUCT_SIZE: int
CAROM_E_UNSUPPORTED: int
CAROM_E_INVALID_HANDLE: int
CAROM_E_STALE_HANDLE: int
CAROM_E_WRONG_KIND: int
CAROM_E_WRONG_WORLD: int
CAROM_E_BUSY: int
CAROM_E_REENTRANT: int
CAROM_E_IN_USE: int
CAROM_E_OUT_OF_MEMORY: int
CAROM_E_LIMIT: int
CAROM_E_BUFFER_TOO_SMALL: int
CAROM_E_PLUGIN_PATH: int
CAROM_E_PLUGIN_LOAD: int
CAROM_E_PLUGIN_ABI: int
CAROM_E_PLUGIN_INVALID: int
CAROM_E_DECLARATION_FALSE: int
CAROM_E_NO_VOLUME: int
CAROM_E_ALREADY_EXISTS: int
CAROM_E_NOT_FOUND: int
CAROM_E_INTERNAL: int
CAROM_E_CORRUPT: int
CAROM_E_MISMATCH: int
CAROM_E_WRITE_FAILED: int
CAROM_E_READ_ONLY: int
CAROM_NULL_HANDLE: int
CAROM_SCALAR_F32: int
CAROM_SCALAR_F64: int
CAROM_ISLAND_ESTIMATED: int
CAROM_ISLAND_BOUND: int
CAROM_ISLAND_JOINTS_ALONE: int
CAROM_ISLAND_STALLED: int
CAROM_COLUMN_BODIES: int
CAROM_COLUMN_JOINTS: int
CAROM_COLUMN_MASSES: int
CAROM_COLUMN_MATERIALS: int
CAROM_COLUMN_GRAVITY: int
CAROM_COLUMN_TIME: int
CAROM_COLUMN_CONTACT_FORCES: int
CAROM_COLUMN_RAYS: int
CAROM_COLUMN_COUNT: int
CAROM_WHEN_ON_CALL: int
CAROM_WHEN_BEFORE_STEP: int
CAROM_WHEN_AFTER_STEP: int
CAROM_WHEN_COUNT: int
CAROM_STOPPED_NO: int
CAROM_STOPPED_FAULT: int
CAROM_STOPPED_MEMORY: int
CAROM_RANDOM_UNIFORM: int
CAROM_RANDOM_NORMAL: int
CAROM_RANDOM_COUNT: int
CAROM_MIX_GEOMETRIC_MEAN: int
CAROM_MIX_MAXIMUM: int
CAROM_MIX_MINIMUM: int
CAROM_MIX_AVERAGE: int
CAROM_MIX_MULTIPLY: int
CAROM_BODY_STATIC: int
CAROM_BODY_KINEMATIC: int
CAROM_BODY_DYNAMIC: int
CAROM_BODY_FIELD_MASS: int
CAROM_BODY_FIELD_CENTER: int
CAROM_BODY_FIELD_INERTIA: int
CAROM_BODY_STAYS_AWAKE: int
CAROM_BODY_DISABLED: int
CAROM_LOCK_LINEAR_X: int
CAROM_LOCK_LINEAR_Y: int
CAROM_LOCK_LINEAR_Z: int
CAROM_LOCK_ANGULAR_X: int
CAROM_LOCK_ANGULAR_Y: int
CAROM_LOCK_ANGULAR_Z: int
CAROM_LOCK_ALL: int
CAROM_LOCK_PLANE: int
CAROM_ATTRIBUTE_GRAVITY_FACTOR: int
CAROM_ATTRIBUTE_LOCKS: int
CAROM_ATTRIBUTE_DRAG: int
CAROM_ATTRIBUTE_FORCE_FIELD_MASK: int
CAROM_ATTRIBUTE_MAGNETIC_MOMENT: int
CAROM_ATTRIBUTE_COUNT: int
CAROM_ATTRIBUTE_NUMBERS: int
CAROM_CONTINUOUS_AUTO: int
CAROM_CONTINUOUS_ALWAYS: int
CAROM_CONTINUOUS_NEVER: int
CAROM_FILTER_CATEGORY: int
CAROM_FILTER_MASK: int
CAROM_FIELD_POSITION: int
CAROM_FIELD_ORIENTATION: int
CAROM_FIELD_POSE: int
CAROM_FIELD_LINEAR_VELOCITY: int
CAROM_FIELD_ANGULAR_VELOCITY: int
CAROM_FIELD_VELOCITY: int
CAROM_FIELD_FORCE: int
CAROM_FIELD_CENTER: int
CAROM_FIELD_MASS: int
CAROM_FIELD_COUNT: int
CAROM_CAST_MISS: int
CAROM_CAST_HIT: int
CAROM_CAST_OVERLAP: int
CAROM_CAST_UNDECIDED: int
CAROM_CAST_BAD_RAY: int
CAROM_ASK_GENERIC: int
CAROM_ASK_SENSORS: int
CAROM_ASK_IGNORE_TOUCHED: int
CAROM_OVERLAP_APART: int
CAROM_OVERLAP_OVERLAPPING: int
CAROM_OVERLAP_TOUCHING: int
CAROM_OVERLAP_FAULT: int
CAROM_NO_SHAPE: int
CAROM_GROUND_AIR: int
CAROM_GROUND_STEEP: int
CAROM_GROUND_FIRM: int
CAROM_CHARACTER_TURNS: int
CAROM_CHARACTER_FLIES: int
CAROM_CHARACTER_CONTACTS: int
CAROM_DIAL_INTEGRATOR: int
CAROM_DIAL_ROTATION: int
CAROM_DIAL_SUBSTEPS: int
CAROM_DIAL_SOLVER: int
CAROM_DIAL_VELOCITY_ITERATIONS: int
CAROM_DIAL_POSITION_ITERATIONS: int
CAROM_DIAL_VELOCITY_TOLERANCE: int
CAROM_DIAL_POSITION_TOLERANCE: int
CAROM_DIAL_RESTITUTION_SPEED: int
CAROM_DIAL_SEVERITY_SEARCH: int
CAROM_DIAL_GROUPS: int
CAROM_DIAL_BROAD_PHASE: int
CAROM_DIAL_GRID_CELL: int
CAROM_DIAL_CONTACT_DISTANCE: int
CAROM_DIAL_PAIR_ROUTINES: int
CAROM_DIAL_NARROW_PHASE: int
CAROM_DIAL_SIMPLEX: int
CAROM_DIAL_GJK_TOLERANCE: int
CAROM_DIAL_GJK_ITERATIONS: int
CAROM_DIAL_EPA_ITERATIONS: int
CAROM_DIAL_HYBRID_MARGIN: int
CAROM_DIAL_WARM_SEPARATION: int
CAROM_DIAL_MANIFOLD: int
CAROM_DIAL_CACHE_DISTANCE: int
CAROM_DIAL_WARM_START: int
CAROM_DIAL_CARRY_OVER: int
CAROM_DIAL_CONTACT_FREQUENCY: int
CAROM_DIAL_CONTACT_DAMPING: int
CAROM_DIAL_PUSH_SPEED: int
CAROM_DIAL_SLEEP: int
CAROM_DIAL_SLEEP_SPEED: int
CAROM_DIAL_SLEEP_TIME: int
CAROM_DIAL_DIRECT_SINK: int
CAROM_DIAL_DIRECT_RATIO: int
CAROM_DIAL_DIRECT_WORK: int
CAROM_DIAL_HOLD_ANGLE: int
CAROM_DIAL_JOINT_FREQUENCY: int
CAROM_DIAL_JOINT_DAMPING: int
CAROM_DIAL_CONTINUOUS: int
CAROM_DIAL_PRECISION: int
CAROM_DIAL_JOINT_ORDER: int
CAROM_DIAL_ACCURACY_PLACE: int
CAROM_DIAL_ACCURACY_TURN: int
CAROM_DIAL_ACCURACY_SUBSTEPS: int
CAROM_DIAL_ACCURACY_WORK: int
CAROM_DIAL_KEEP_DISTANCE: int
CAROM_DIAL_COUNT: int
CAROM_INTEGRATOR_EXPLICIT_EULER: int
CAROM_INTEGRATOR_SEMI_IMPLICIT_EULER: int
CAROM_INTEGRATOR_RK4: int
CAROM_INTEGRATOR_VELOCITY_VERLET: int
CAROM_ROTATION_NONE: int
CAROM_ROTATION_EXPLICIT: int
CAROM_ROTATION_IMPLICIT: int
CAROM_ROTATION_RK4: int
CAROM_ROTATION_LIE_MIDPOINT: int
CAROM_ROTATION_SPLITTING: int
CAROM_ROTATION_SPLITTING_4: int
CAROM_ROTATION_SPLITTING_6: int
CAROM_SOLVER_SEVERITY: int
CAROM_SOLVER_SOFT_STEP: int
CAROM_SOLVER_DIRECT: int
CAROM_SOLVER_AUTO: int
CAROM_SEARCH_LINEAR: int
CAROM_SEARCH_HEAP: int
CAROM_BROAD_BRUTE_FORCE: int
CAROM_BROAD_SWEEP_AND_PRUNE: int
CAROM_BROAD_GRID: int
CAROM_BROAD_TREE: int
CAROM_NARROW_HYBRID: int
CAROM_NARROW_GJK_EPA: int
CAROM_SIMPLEX_JOHNSON: int
CAROM_SIMPLEX_VORONOI: int
CAROM_SIMPLEX_VORONOI_LAST: int
CAROM_MANIFOLD_SINGLE: int
CAROM_MANIFOLD_CACHE: int
CAROM_MANIFOLD_PATCH: int
CAROM_MANIFOLD_CLIP: int
CAROM_SWEEP_NONE: int
CAROM_SWEEP_FLAGGED: int
CAROM_SWEEP_FAST: int
CAROM_PRECISION_FLOAT: int
CAROM_PRECISION_AUTO: int
CAROM_PRECISION_DOUBLE: int
CAROM_PRESET_FAST: int
CAROM_PRESET_BALANCED: int
CAROM_PRESET_ACCURATE: int
CAROM_PRESET_REFERENCE: int
CAROM_PRESET_COUNT: int
CAROM_DIAL_KIND_NUMBER: int
CAROM_DIAL_KIND_INTEGER: int
CAROM_DIAL_KIND_CHOICE: int
CAROM_DRAW_SHAPES: int
CAROM_DRAW_SCENERY: int
CAROM_DRAW_BOUNDS: int
CAROM_DRAW_CONTACTS: int
CAROM_DRAW_JOINTS: int
CAROM_DRAW_BODIES: int
CAROM_DRAW_BY_TYPE: int
CAROM_DRAW_BY_ISLAND: int
CAROM_LOG_INFO: int
CAROM_LOG_WARNING: int
CAROM_LOG_ERROR: int
CAROM_EVENTS_CONTACT: int
CAROM_EVENTS_SENSOR: int
CAROM_EVENTS_SLEEP: int
CAROM_EVENTS_JOINT: int
CAROM_EVENTS_FAULT: int
CAROM_CONTACT_BEGIN: int
CAROM_CONTACT_END: int
CAROM_CONTACT_HIT: int
CAROM_SENSOR_ENTER: int
CAROM_SENSOR_LEAVE: int
CAROM_SLEEP_ASLEEP: int
CAROM_SLEEP_AWAKE: int
CAROM_FORCE_FIELD_UNIFORM: int
CAROM_FORCE_FIELD_RADIAL: int
CAROM_FORCE_FIELD_VORTEX: int
CAROM_FORCE_FIELD_MAGNETIC: int
CAROM_FORCE_FIELD_COUNT: int
CAROM_JOINT_BALL: int
CAROM_JOINT_HINGE: int
CAROM_JOINT_SLIDER: int
CAROM_JOINT_WELD: int
CAROM_JOINT_DISTANCE: int
CAROM_JOINT_UNIVERSAL: int
CAROM_JOINT_PULLEY: int
CAROM_JOINT_GEAR: int
CAROM_JOINT_SIX_AXIS: int
CAROM_JOINT_COUPLING: int
CAROM_JOINT_COUNT: int
CAROM_COORDINATE_TWIST: int
CAROM_COORDINATE_SWING: int
CAROM_COORDINATE_SLIDE: int
CAROM_COORDINATE_DISTANCE: int
CAROM_COORDINATE_COUNT: int
CAROM_AXIS_X: int
CAROM_AXIS_Y: int
CAROM_AXIS_Z: int
CAROM_AXIS_TURN_X: int
CAROM_AXIS_TURN_Y: int
CAROM_AXIS_TURN_Z: int
CAROM_AXIS_COUNT: int
CAROM_AXIS_MODE_FREE: int
CAROM_AXIS_MODE_LOCKED: int
CAROM_AXIS_MODE_LIMITED: int
CAROM_AXIS_MODE_COUNT: int
CAROM_DRIVE_NONE: int
CAROM_DRIVE_POSITION: int
CAROM_DRIVE_VELOCITY: int
CAROM_DRIVE_EFFORT: int
CAROM_DRIVE_COUNT: int
CAROM_GAINS_FREQUENCY: int
CAROM_GAINS_FORCE: int
CAROM_GAINS_ACCELERATION: int
CAROM_GAINS_COUNT: int
CAROM_JOINT_WORLD_FRAME: int
CAROM_JOINT_COLLIDE: int
CAROM_JOINT_FIELD_LENGTH: int
CAROM_JOINT_ACCELERATIONS: int
CAROM_JOINT_BULK_COORDINATES: int
CAROM_JOINT_BULK_SPEEDS: int
CAROM_JOINT_BULK_AXES: int
CAROM_JOINT_BULK_AXIS_SPEEDS: int
CAROM_JOINT_BULK_FORCE: int
CAROM_JOINT_BULK_TORQUE: int
CAROM_JOINT_BULK_ERROR: int
CAROM_JOINT_BULK_BROKEN: int
CAROM_JOINT_BULK_POSITION: int
CAROM_JOINT_BULK_VELOCITY: int
CAROM_JOINT_BULK_EFFORT: int
CAROM_JOINT_BULK_TARGET: int
CAROM_JOINT_BULK_TARGET_VELOCITY: int
CAROM_JOINT_BULK_TARGET_EFFORT: int
CAROM_JOINT_BULK_MOTOR: int
CAROM_JOINT_BULK_SPRING: int
CAROM_JOINT_BULK_LIMIT: int
CAROM_JOINT_BULK_AXIS_EFFORTS: int
CAROM_JOINT_BULK_AXIS_TARGETS: int
CAROM_JOINT_BULK_AXIS_TARGET_VELOCITIES: int
CAROM_JOINT_BULK_AXIS_TARGET_EFFORTS: int
CAROM_JOINT_BULK_AXIS_MAX_FORCES: int
CAROM_JOINT_BULK_AXIS_GAINS: int
CAROM_JOINT_BULK_AXIS_LIMITS: int
CAROM_JOINT_BULK_ORIENTATION_TARGET: int
CAROM_JOINT_BULK_ORIENTATION_VELOCITY: int
CAROM_JOINT_BULK_ORIENTATION_EFFORT: int
CAROM_JOINT_BULK_ORIENTATION_GAINS: int
CAROM_JOINT_BULK_ACCELERATION: int
CAROM_JOINT_BULK_AXIS_ACCELERATIONS: int
CAROM_JOINT_BULK_AXIS_FRICTIONS: int
CAROM_JOINT_BULK_AXIS_ARMATURES: int
CAROM_JOINT_BULK_AXIS_EFFORT_LIMITS: int
CAROM_JOINT_BULK_AXIS_SPEED_LIMITS: int
CAROM_JOINT_BULK_FRICTION: int
CAROM_JOINT_BULK_ARMATURE: int
CAROM_JOINT_BULK_EFFORT_LIMIT: int
CAROM_JOINT_BULK_SPEED_LIMIT: int
CAROM_JOINT_BULK_DRIVE_TARGET: int
CAROM_JOINT_BULK_DRIVE_VELOCITY: int
CAROM_JOINT_BULK_DRIVE_EFFORT: int
CAROM_JOINT_BULK_DRIVE_MAX_FORCE: int
CAROM_JOINT_BULK_DRIVE_GAINS: int
CAROM_JOINT_BULK_COUNT: int
CAROM_EFFECT_GYROSCOPIC: int
CAROM_EFFECT_LINEAR_DAMPING: int
CAROM_EFFECT_ANGULAR_DAMPING: int
CAROM_EFFECT_GRAVITY: int
CAROM_EFFECT_USER_FORCE: int
CAROM_EFFECT_USER_TORQUE: int
CAROM_EFFECT_COLLISION: int
CAROM_EFFECT_FRICTION: int
CAROM_EFFECT_RESTITUTION: int
CAROM_EFFECT_ROLLING_RESISTANCE: int
CAROM_EFFECT_SPINNING_RESISTANCE: int
CAROM_EFFECT_SLEEP: int
CAROM_EFFECT_PARTICLES: int
CAROM_EFFECT_FILTER: int
CAROM_EFFECT_SENSOR: int
CAROM_EFFECT_JOINTS: int
CAROM_EFFECT_SCENERY: int
CAROM_EFFECT_CONTINUOUS: int
CAROM_EFFECT_SURFACE_VELOCITY: int
CAROM_EFFECT_AXIS_LOCKS: int
CAROM_EFFECT_DRAG: int
CAROM_EFFECT_WIND: int
CAROM_EFFECT_FIELDS: int
CAROM_EFFECT_SPRINGS: int
CAROM_EFFECT_BUOYANCY: int
CAROM_EFFECT_RESPONSE: int
CAROM_EFFECT_JOINT_LIMITS: int
CAROM_EFFECT_JOINT_MOTORS: int
CAROM_EFFECT_EVENTS: int
CAROM_EFFECT_LEDGER: int
CAROM_EFFECT_MAGNETISM: int
CAROM_EFFECT_COUNT: int
CAROM_MODE_AS_NEEDED: int
CAROM_MODE_FORBID: int
CAROM_MODE_FORCE: int
CAROM_PLAN_NO_EFFECT: int
CAROM_TIME_OWN: int
CAROM_TIME_IN_STAGE: int
CAROM_TIME_OFF: int
CAROM_PLUGIN_ABI_MAJOR: int
CAROM_PLUGIN_ABI_MINOR: int
CAROM_FORM_NONE: int
CAROM_FORM_SPHERE: int
CAROM_FORM_CAPSULE: int
CAROM_FORM_BOX: int
CAROM_FORM_POLYTOPE: int
CAROM_FORM_CYLINDER: int
CAROM_FORM_CONE: int
CAROM_FORM_ELLIPSOID: int
CAROM_NO_PARAM: int
CAROM_PLUGIN_HOST_THREAD: int
CAROM_SHAPE_PLUGIN_SYMBOL: str
CAROM_QUERY_EXACT_ENOUGH: int
CAROM_QUERY_CAPPED: int
CAROM_QUERY_ROUNDING: int
CAROM_QUERY_FAULT: int
CAROM_RECORD_HASHES: int
CAROM_RECORD_STATES: int
CAROM_SCENERY_TWO_SIDED: int
CAROM_SNAPSHOT_STATE: int
CAROM_SNAPSHOT_WHOLE: int
CAROM_VEHICLE_AUTOMATIC: int
CAROM_VEHICLE_ACKERMANN: int
CAROM_VEHICLE_WHEELS: int
CAROM_NO_WHEEL: int
CAROM_STAGE_REFRESH: int
CAROM_STAGE_BROAD: int
CAROM_STAGE_NARROW: int
CAROM_STAGE_GROUP: int
CAROM_STAGE_INTEGRATE: int
CAROM_STAGE_SOLVE: int
CAROM_STAGE_RELAX: int
CAROM_STAGE_OBSERVE: int
CAROM_STAGE_COUNT: int
CAROM_REASON_ORDINARY: int
CAROM_REASON_MASS_RATIO: int
CAROM_REASON_SINK: int
CAROM_REASON_TOO_MUCH: int
CAROM_REASON_IMPACT: int
CAROM_REASON_FEW: int
CAROM_FAULT_RETURNED: int
CAROM_FAULT_NOT_FINITE: int
CAROM_FAULT_OUTSIDE: int
CAROM_FAULT_NOT_SUPPORT: int
CAROM_FAULT_BODY_STATE: int
CAROM_FAULT_PARTICLE_STATE: int
CAROM_WANT_FIRST: int
CAROM_WANT_ANY: int
carom_plugin = ctypes.c_uint64
carom_shape = ctypes.c_uint64
carom_material = ctypes.c_uint64
carom_body = ctypes.c_uint64
carom_collider = ctypes.c_uint64
carom_particles = ctypes.c_uint64
carom_joint = ctypes.c_uint64
carom_force_field = ctypes.c_uint64
carom_spring = ctypes.c_uint64
carom_job_fn: Any
carom_support_fn: Any
carom_write_fn: Any
class carom_error(ctypes.Structure):
    """Details of the last failure of one call. Owned by the caller; start from CAROM_ERROR_INIT.
    Written only on failure, never past struct_size."""
    struct_size: int
    code: int
    argument: int
    has_witness: int
    witness_dir: Any
    witness_out: Any
    message: builtins.bytes
    remedy: builtins.bytes
class carom_accuracy(ctypes.Structure):
    """An error tolerance. The three numbers are the dials CAROM_DIAL_ACCURACY_PLACE, _TURN and _SUBSTEPS, so that
    snapshots, recordings and scene files have them. The dial CAROM_DIAL_ACCURACY_WORK bounds the work of large islands
    in contact further. Fill with carom_accuracy_init()."""
    struct_size: int
    substeps: int
    place: float
    turn: float
class carom_island(ctypes.Structure):
    """An island of the last step. Errors are those of its step per second of motion, by the last estimate."""
    body: int
    bodies: int
    substeps: int
    order: int
    flags: int
    work: int
    place: float
    turn: float
    share: float
class carom_growth(ctypes.Structure):
    """How errors grow by themselves, whatever work a step is given: two motions that begin 1e-9 m/s and rad/s apart. Their
    distance is the largest over all bodies of that of places (m), of turns (rad), and of velocities and spins times 1
    s."""
    struct_size: int
    steps: int
    body: int
    sensitive: int
    reserved: int
    factor: float
    rate: float
class carom_batch_column(ctypes.Structure):
    """What stands in an array of the host's, and when. Fill with carom_batch_column_init(). A row has n records one after
    the other, each of as many numbers as the source says; rows are those of the worlds of one structure, in order."""
    struct_size: int
    source: int
    field: int
    when: int
    scalar: int
    reserved: int
    world: int
    n: int
    handles: Any
    rays: Any
    data: Any
    stride: int
class carom_batch_info(ctypes.Structure):
    """What a batch has, and what it costs."""
    struct_size: int
    structures: int
    worlds: int
    stopped: int
    columns: int
    real_worlds: int
    state_bytes: int
class carom_material_desc(ctypes.Structure):
    """Surface of a collider. Where two materials mix differently, the larger CAROM_MIX_* value decides; of two in particular
    carom_material_set_pair() says what they are to each other."""
    struct_size: int
    friction_mix: int
    restitution_mix: int
    reserved: int
    friction: float
    restitution: float
class carom_body_desc(ctypes.Structure):
    """What a body is made from. Fill with carom_body_desc_init()."""
    struct_size: int
    fields: int
    type: int
    reserved: int
    position: Any
    orientation: Any
    linear_velocity: Any
    angular_velocity: Any
    mass: float
    center: Any
    inertia: Any
    linear_damping: float
    angular_damping: float
    user: int
    gravity_factor: float
    locks: int
    continuous: int
    linear_drag: float
    quadratic_drag: float
    force_field_mask: int
    reserved2: int
    magnetic_moment: Any
class carom_attribute_info(ctypes.Structure):
    """What an attribute is. Strings have static storage."""
    struct_size: int
    attribute: int
    numbers: int
    is_whole: int
    of_dynamic: int
    effect: int
    name: Any
    unit: Any
    summary: Any
    min: float
    max: float
    usual: Any
class carom_collider_desc(ctypes.Structure):
    """A shape on a body. Fill with carom_collider_desc_init()."""
    struct_size: int
    reserved: int
    shape: int
    material: int
    position: Any
    orientation: Any
    density: float
    category: int
    mask: int
    group: int
    sensor: int
    surface_linear: Any
    surface_angular: Any
class carom_cast_desc(ctypes.Structure):
    """How to cast; fill with carom_cast_desc_init()."""
    struct_size: int
    iterations: int
    tolerance: float
    target: float
    flags: int
    reserved: int
class carom_cast(ctypes.Structure):
    """The result. Numbers of a fault (status CAROM_QUERY_FAULT) mean nothing."""
    struct_size: int
    outcome: int
    status: int
    iterations: int
    time: float
    lower: float
    upper: float
    separation: float
    slack: float
    normal: Any
    point_a: Any
    point_b: Any
    support_calls: int
    reserved: int
class carom_motion(ctypes.Structure):
    """A shape that travels and turns: its centre at constant velocity, the shape about its centre at constant angular
    velocity. Fill with carom_motion_init()."""
    struct_size: int
    reserved: int
    position: Any
    orientation: Any
    center: Any
    linear_velocity: Any
    angular_velocity: Any
class carom_overlap(ctypes.Structure):
    struct_size: int
    outcome: int
    separation_bound: float
    normal: Any
    point: Any
    slack: float
    support_calls: int
    reserved: int
class carom_rays(ctypes.Structure):
    """Rays in the caller's arrays, of float or double, at any stride (0: tightly packed). struct_size and scalar set by
    the caller, what is not set zero."""
    struct_size: int
    scalar: int
    count: int
    origins: Any
    directions: Any
    max: Any
    origin_stride: int
    direction_stride: int
    max_stride: int
class carom_ray_hit(ctypes.Structure):
    """What one ray met."""
    outcome: int
    status: int
    shape: int
    reserved: int
    time: float
    lower: float
    upper: float
    normal: Any
    point: Any
class carom_ray_hits(ctypes.Structure):
    """Where results go: records, or separate arrays, or both; NULL: not wanted. Strides in bytes, 0: tightly packed."""
    struct_size: int
    scalar: int
    records: Any
    outcomes: Any
    shapes: Any
    times: Any
    normals: Any
    points: Any
    record_stride: int
    outcome_stride: int
    shape_stride: int
    time_stride: int
    normal_stride: int
    point_stride: int
class carom_character_desc(ctypes.Structure):
    """How a character moves. Fill with carom_character_desc_init(). Characters may share one, and it may change between
    moves."""
    struct_size: int
    flags: int
    up: Any
    gravity: float
    fall_speed: float
    max_slope: float
    step_up: float
    step_down: float
    skin: float
    acceleration: float
    air_acceleration: float
    mass: float
    push_force: float
    recover_speed: float
    category: int
    mask: int
    body: int
class carom_character(ctypes.Structure):
    """Where a character is, how it moves and what it touches. Fill with carom_character_init(), then set position and
    call carom_character_set_shape(). To teleport it, write position, and set ground to CAROM_GROUND_AIR."""
    struct_size: int
    ground: int
    shape: int
    position: Any
    orientation: Any
    velocity: Any
    foot: float
    head: float
    reach: float
    ground_body: int
    ground_collider: int
    ground_point: Any
    ground_normal: Any
    ground_velocity: Any
    ground_position: Any
    ground_orientation: Any
    contact_count: int
    reserved: int
    contact_bodies: int
    contact_points: Any
    contact_normals: Any
    contact_speeds: Any
class carom_dial_info(ctypes.Structure):
    """What a dial is: documentation and bounds. Strings have static storage."""
    struct_size: int
    dial: int
    kind: int
    choice_count: int
    name: Any
    unit: Any
    summary: Any
    choices: Any
    min: float
    max: float
    initial: float
class carom_constant_info(ctypes.Structure):
    """What a constant is. Strings have static storage. Names are distinct from those of dials; which constants there are,
    and in which order, may change from version to version."""
    struct_size: int
    constant: int
    name: Any
    unit: Any
    reason: Any
    consequence: Any
    value: float
class carom_draw_desc(ctypes.Structure):
    struct_size: int
    what: int
    colouring: int
    reserved: int
    scale: float
class carom_draw_line(ctypes.Structure):
    to: Any
    colour: int
    kind: int
    body: int
class carom_engine_desc(ctypes.Structure):
    """What an engine is made from. Fill with carom_engine_desc_init(), then change what you need."""
    struct_size: int
    reserved: int
    alloc: Any
    free: Any
    alloc_user: Any
    log: Any
    log_user: Any
class carom_jobs_desc(ctypes.Structure):
    """Which threads share the work of a step. The outcome does not depend on it: same bits for any number of threads.
    Fill with carom_jobs_desc_init(), then change what you need."""
    struct_size: int
    threads: int
    run: Any
    user: Any
class carom_contact_event(ctypes.Structure):
    """Of two colliders; all their contact points together. Sleepers stay in touch."""
    kind: int
    reserved: int
    collider_a: int
    collider_b: int
    body_a: int
    body_b: int
    point: Any
    normal: Any
    impulse: float
    approach_speed: float
class carom_sensor_event(ctypes.Structure):
    """What a sensor overlaps at the end of the step and did not at the end of the one before, or the reverse. Sleepers are
    within what they sleep in."""
    kind: int
    reserved: int
    sensor: int
    other: int
    sensor_body: int
    other_body: int
class carom_sleep_event(ctypes.Structure):
    """A body that sleeps at the end of the step and did not at the end of the one before, or the reverse."""
    kind: int
    reserved: int
    body: int
class carom_joint_event(ctypes.Structure):
    """A joint that bore more than its break_force or break_torque in this step, and holds nothing any more. It stays until
    it is destroyed."""
    joint: int
    body_a: int
    body_b: int
    force: Any
    torque: Any
    step: int
class carom_fault_event(ctypes.Structure):
    """A support function that returned a false point: its shape is disabled from the next step on. Or a body or particles
    whose state was not finite: they are in quarantine. The same faults as those of carom_world_get_faults(), but by
    handles that keep their names when what they name is destroyed."""
    kind: int
    reserved: int
    shape: int
    body: int
    particles: int
    particle: int
    dir: Any
    out: Any
    step: int
class carom_force_field_desc(ctypes.Structure):
    """What acts on every body that shares a bit of its mask, at the centre of mass. Distances d are softened: what the law
    reads is s = sqrt(d^2 + core^2), and the direction's length is d / s. Fill with carom_force_field_desc_init()."""
    struct_size: int
    kind: int
    is_force: int
    mask: int
    position: Any
    orientation: Any
    half: Any
    vector: Any
    strength: float
    pull: float
    lift: float
    reference: float
    core: float
    reach: float
    falloff: int
    reserved: int
    user: int
class carom_spring_desc(ctypes.Structure):
    """A spring as a force, F = stiffness (length - rest) + damping d(length)/dt along the line between two points: what it
    does between two steps is as exact as the integrator. A substep h resolves stiffness only up to where its frequency
    w has w h = 1; one that is stiffer is taken to be as stiff as that (carom_world_get_plan() says how many are). For
    those, and for rods and ropes, there is CAROM_JOINT_DISTANCE, which solves. Fill with carom_spring_desc_init()."""
    struct_size: int
    only_pulls: int
    body_a: int
    body_b: int
    anchor_a: Any
    anchor_b: Any
    rest: float
    stiffness: float
    damping: float
    user: int
class carom_water(ctypes.Structure):
    """All of space where normal . x <= level is water. What of a body's colliders is in it (not sensors, not scenery) is
    pushed by the weight of what it displaces, at the middle of that part, against the world's gravity, and is taken
    along by the current: F = -drag * density * volume * (v - current). Balls, ellipsoids, boxes and hulls displace
    exactly what they cover, other shapes what a hull of 256 of their support points covers, scaled to their volume.
    Fill with carom_water_init()."""
    struct_size: int
    reserved: int
    normal: Any
    level: float
    density: float
    current: Any
    drag: float
class carom_joint_desc(ctypes.Structure):
    """Fill with carom_joint_desc_init(): a ball joint, frames at the origins of both bodies, unbreakable. A door on a
    hinge that stands upright, the joint's x axis along the world's y:
        desc.kind = CAROM_JOINT_HINGE, desc.fields = CAROM_JOINT_WORLD_FRAME, desc.body_b = door;
        desc.position_a[0] = 1, desc.orientation_a[2] = desc.orientation_a[3] = 0.70710678118654752;"""
    struct_size: int
    kind: int
    fields: int
    reserved: int
    body_a: int
    body_b: int
    position_a: Any
    orientation_a: Any
    position_b: Any
    orientation_b: Any
    length: float
    break_force: float
    break_torque: float
    user: int
class carom_joint_limit(ctypes.Structure):
    """A coordinate kept within bounds."""
    struct_size: int
    enabled: int
    lower: float
    upper: float
class carom_joint_motor(ctypes.Structure):
    """A coordinate driven at a speed."""
    struct_size: int
    enabled: int
    speed: float
    max_force: float
class carom_joint_spring(ctypes.Structure):
    """A coordinate pulled towards a place: a spring, or a motor that holds a position. With x the stretch, w = 2 pi
    frequency and m what the joint's bodies weigh along the coordinate were they alone: force = -m (w^2 x + 2 damping w
    x')."""
    struct_size: int
    enabled: int
    target: float
    frequency: float
    damping: float
    max_force: float
class carom_joint_transmission(ctypes.Structure):
    """By what a pulley or a gear turns the motion of A into that of B. Fill with carom_joint_transmission_init()."""
    struct_size: int
    fields: int
    ratio: float
    anchor_a: Any
    anchor_b: Any
    length: float
class carom_joint_coupling(ctypes.Structure):
    """What a coupling makes follow what: a gear between two hinges on anything, a finger that closes with another, a rack.
    The coordinate of a hinge is its twist, whole turns counted, that of a slider its slide. With x that of the leader,
    the follower's is polynomial[0] + polynomial[1] x + ... + polynomial[4] x^4. Each pushes the other: where something
    holds the follower, it holds the leader. Fill with carom_joint_coupling_init()."""
    struct_size: int
    reserved: int
    follower: int
    leader: int
    polynomial: Any
    user: int
class carom_joint_axis(ctypes.Structure):
    """What one axis of a six-axis joint does, or that of a hinge or slider beside its own limit, motor and spring: a hinge
    has CAROM_AXIS_TURN_X, a slider CAROM_AXIS_X. Fill with carom_joint_axis_init(). A drive, a spring and stops act beside
    each other; of what is stiffer than (pi / 2 h)^2 m, h a substep, so much acts, and springs of one axis share it."""
    struct_size: int
    mode: int
    lower: float
    upper: float
    stop_gains: int
    drive_gains: int
    spring_gains: int
    drive: int
    stop_stiffness: float
    stop_damping: float
    target: float
    speed: float
    effort: float
    max_force: float
    drive_stiffness: float
    drive_damping: float
    rest: float
    spring_stiffness: float
    spring_damping: float
    friction: float
    armature: float
    effort_limit: float
    speed_limit: float
class carom_joint_orientation_drive(ctypes.Structure):
    """A drive of all three turns as one, by the shortest way: of a ball, or of a six-axis joint none of whose turns is
    locked (else it rests). With e the rotation vector, in A's frame, of the shortest turn from the target to where B's
    frame is, its torque is stiffness (-e) + damping (velocity - omega), about each of A's axes `max_force` at most.
    Fill with carom_joint_orientation_drive_init()."""
    struct_size: int
    drive: int
    gains: int
    reserved: int
    target: Any
    velocity: Any
    effort: Any
    max_force: Any
    stiffness: float
    damping: float
class carom_joint_state(ctypes.Structure):
    """What a joint does and where it is."""
    struct_size: int
    broken: int
    force: Any
    torque: Any
    gap: float
    angle: float
    coordinate: Any
    axis: Any
class carom_ledger_entry(ctypes.Structure):
    """A cause: what it gave in the last step, and since the ledger began."""
    name: Any
    kinetic: float
    potential: float
    linear: Any
    angular: Any
    total_kinetic: float
    total_potential: float
    total_linear: Any
    total_angular: Any
class carom_ledger_state(ctypes.Structure):
    """The state itself, summed apart from the causes. After a step `now` is `before` plus the causes of that step, and
    `start` plus their totals, but for rounding: no more than the bounds here."""
    struct_size: int
    is_kept: int
    steps: int
    start_kinetic: float
    start_potential: float
    start_linear: Any
    start_angular: Any
    before_kinetic: float
    before_potential: float
    before_linear: Any
    before_angular: Any
    now_kinetic: float
    now_potential: float
    now_linear: Any
    now_angular: Any
    rounding_energy: float
    rounding_linear: float
    rounding_angular: float
    total_rounding_energy: float
    total_rounding_linear: float
    total_rounding_angular: float
class carom_pairs(ctypes.Structure):
    """Pairs in the caller's arrays, at any stride (0: tightly packed). struct_size set by the caller, what is not set
    zero."""
    struct_size: int
    reserved: int
    count: int
    shapes_a: Any
    shapes_b: Any
    positions_a: Any
    orientations_a: Any
    positions_b: Any
    orientations_b: Any
    shape_a_stride: int
    shape_b_stride: int
    position_a_stride: int
    orientation_a_stride: int
    position_b_stride: int
    orientation_b_stride: int
class carom_device_info(ctypes.Structure):
    """A device, and what it has done since it was opened."""
    struct_size: int
    reserved: int
    name: builtins.bytes
    version: builtins.bytes
    pairs: int
    host_pairs: int
class carom_particles_desc(ctypes.Structure):
    """What all particles of a set have in common. Fill with carom_particles_desc_init()."""
    struct_size: int
    reserved: int
    gravity_factor: float
    linear_damping: float
    mass: float
    capacity: int
class carom_plan_line(ctypes.Structure):
    """A line of the plan: a stage or an effect, as it was in the last step."""
    effect: int
    stage: int
    mode: int
    runs: int
    participants: int
    wanted: int
    evaluations: int
    bytes: int
    seconds: float
    timing: int
    reserved: int
    name: builtins.bytes
    unit: builtins.bytes
    reason: builtins.bytes
class carom_param(ctypes.Structure):
    """Documentation and bounds of one parameter; a value outside [min, max] is refused when a shape is made."""
    name: Any
    unit: Any
    min: float
    max: float
class carom_param_rule(ctypes.Structure):
    """What several parameters fulfil together: the sum of weight[i] * params[param[i]] over its terms is at most `most`.
    Parameters that do not are refused when a shape is made (OUT_OF_RANGE, with `text`), and the plugin is not judged by
    them. A lens that is thinner than its radius: {"height <= 0.99 radius", 2, {1, 0}, {1, -0.99}, 0}."""
    text: Any
    term_count: int
    param: Any
    weight: Any
    most: float
class carom_geometry(ctypes.Structure):
    """What the author knows beyond the support function. Data, not code; verified against the support function when a
    shape is made (a false declaration is refused with a witness direction); never trusted."""
    struct_size: int
    form: int
    form_arg: Any
    core_radius_param: int
    mass_form: int
    mass_arg: Any
class carom_shape_plugin(ctypes.Structure):
    """The plugin. Export it as
        const carom_shape_plugin carom_shape_plugin_v1 = { ... };
    or pass it to carom_plugin_register(). Everything it points to must live as long as the engine."""
    struct_size: int
    abi_major: int
    abi_minor: int
    flags: int
    id: Any
    version: int
    param_count: int
    params: Any
    geometry: Any
    support: Any
    param_tail_group: int
    param_tail_min: int
    rules: Any
    rule_count: int
    reserved: int
    user: Any
    text: Any
class carom_distance_desc(ctypes.Structure):
    """Settings of a query; fill with carom_distance_desc_init(). Values as the dials of the same name."""
    struct_size: int
    simplex: int
    narrow_phase: int
    pair_routines: int
    tolerance: float
    hybrid_margin: float
    gjk_iterations: int
    epa_iterations: int
class carom_distance(ctypes.Structure):
    """The result: signed distance (negative: depth of the smallest separating translation) and its bracket."""
    struct_size: int
    status: int
    separation: float
    lower: float
    upper: float
    normal: Any
    point_a: Any
    point_b: Any
    gjk_iterations: int
    epa_iterations: int
    support_calls: int
    reserved: int
class carom_difference(ctypes.Structure):
    """What of a world is not as a snapshot says."""
    struct_size: int
    differs: int
    first: int
    second: int
    sections: builtins.bytes
class carom_residuals(ctypes.Structure):
    """What is left undone. Contacts are those of the last step, with the velocities that it ended with; joints and energy
    are those of the present poses and velocities. Violations of Coulomb's law are in m/s: by how much the velocity at
    the worst contact would have to be another for its impulse to be right."""
    struct_size: int
    ledger_is_kept: int
    contact_points: int
    joints: int
    max_penetration: float
    mean_penetration: float
    joint_gap: float
    joint_angle: float
    complementarity: float
    cone: float
    slip: float
    energy: float
    energy_drift: float
class carom_mesh_desc(ctypes.Structure):
    """A triangle mesh. Corners at the same place are made one, so vertices may be repeated; triangles without area are
    dropped (carom_scenery_info counts them). Two triangles that share a side are one surface there; a side of one alone
    is a boundary edge, and so is a side of three. Fill with carom_mesh_desc_init()."""
    struct_size: int
    flags: int
    vertices: Any
    vertex_count: int
    triangles: Any
    triangle_count: int
class carom_height_field_desc(ctypes.Structure):
    """A height field: vertices at (column spacing[0], height, row spacing[1]) in the shape's frame, met from above (+y).
    Each cell is two triangles, divided from its first corner (column, row) to (column + 1, row + 1). What has its
    middle in the ground, by no more than its bounding radius, is lifted out. Fill with carom_height_field_desc_init()."""
    struct_size: int
    flags: int
    columns: int
    rows: int
    heights: Any
    spacing: Any
class carom_scenery_info(ctypes.Structure):
    """Counts of a surface: what the engine keeps of the arrays that made it."""
    struct_size: int
    flags: int
    triangles: int
    vertices: int
    dropped: int
    boundary_edges: int
    bytes: int
class carom_shape_info(ctypes.Structure):
    """What the engine knows of a shape. Quantities are for unit density (1 kg/m^3) in the shape's own frame; each derived
    one comes with a rigorous bracket. A half-space has infinite bounds and volume 0."""
    struct_size: int
    form: int
    is_half_space: int
    mass_exact: int
    plugin: int
    param_count: int
    core_radius: float
    bounding_radius: float
    aabb_min: Any
    aabb_max: Any
    volume: float
    volume_min: float
    volume_max: float
    centroid: Any
    centroid_error: float
    inertia: Any
    inertia_error: float
    is_scenery: int
    reserved: int
class carom_tree_coordinate(ctypes.Structure):
    """What a number of a tree stands for."""
    joint: int
    body: int
    axis: int
    reserved: int
class carom_vehicle_desc(ctypes.Structure):
    """Chassis, engine and gears. Fill with carom_vehicle_desc_init(): a car of 1.2 t, whose chassis the host names."""
    struct_size: int
    flags: int
    chassis: int
    up: Any
    forward: Any
    category: int
    mask: int
    torque_count: int
    gear_count: int
    torque_speeds: Any
    torques: Any
    idle_speed: float
    max_speed: float
    engine_inertia: float
    engine_drag: float
    gears: Any
    reverse: float
    final_drive: float
    clutch_torque: float
    shift_up: float
    shift_down: float
    shift_time: float
    limited_slip: float
class carom_wheel_desc(ctypes.Structure):
    """One wheel: its place, spring, tyre, and what of engine, brakes and steering reaches it. Fill with
    carom_wheel_desc_init()."""
    struct_size: int
    anti_roll_partner: int
    shape: int
    position: Any
    radius: float
    inertia: float
    travel: float
    stiffness: float
    damping_bump: float
    damping_rebound: float
    anti_roll: float
    max_steer: float
    drive: float
    brake: float
    handbrake: float
    rolling: float
    grip: float
    side_grip: float
    peak_slip: float
    side_peak_slip: float
    slide: float
    slide_slip: float
    relaxation: float
class carom_vehicle_input(ctypes.Structure):
    """What a driver does. Fill with carom_vehicle_input_init(): nothing, in gear 1."""
    struct_size: int
    gear: int
    throttle: float
    brake: float
    handbrake: float
    steer: float
class carom_vehicle(ctypes.Structure):
    """State of engine and gears. Fill with carom_vehicle_init()."""
    struct_size: int
    gear: int
    engine_speed: float
    shifting: float
    since_shift: float
    speed: float
class carom_wheel(ctypes.Structure):
    """State of a wheel. Fill with carom_wheel_init()."""
    struct_size: int
    touches: int
    body: int
    collider: int
    point: Any
    normal: Any
    position: Any
    compression: float
    spin: float
    angle: float
    steer: float
    load: float
    force: float
    side_force: float
    slip: float
    side_slip: float
class carom_world_desc(ctypes.Structure):
    """What a world is made from. Fill with carom_world_desc_init()."""
    struct_size: int
    reserved: int
    gravity: Any
    body_capacity: int
class carom_step_report(ctypes.Structure):
    """Times, counts and residuals of the last step. A stage without participants did not run: its time is 0."""
    struct_size: int
    stage_count: int
    stage_seconds: Any
    total_seconds: float
    steps: int
    time: float
    bodies: int
    dynamic_bodies: int
    colliders: int
    broad_pairs: int
    contact_pairs: int
    contact_points: int
    groups: int
    largest_group: int
    gjk_calls: int
    epa_calls: int
    support_calls: int
    velocity_impulses: int
    position_moves: int
    quarantined_bodies: int
    faults: int
    max_penetration: float
    mean_penetration: float
    max_closing_speed: float
    linear_energy: float
    angular_energy: float
    asleep_bodies: int
    fell_asleep: int
    woke_up: int
    direct_groups: int
    solver_residual: float
    particles: int
    quarantined_particles: int
    swept_bodies: int
    sweep_hits: int
    wedged_groups: int
    rejected_solutions: int
    excess_energy: float
class carom_contact(ctypes.Structure):
    """A contact point of the last step."""
    collider_a: int
    collider_b: int
    body_a: int
    body_b: int
    point: Any
    normal: Any
    separation: float
    normal_impulse: float
    friction_impulse: float
class carom_group(ctypes.Structure):
    """A contact group of the last step, and which solver CAROM_SOLVER_AUTO chose for it."""
    body: int
    bodies: int
    points: int
    solver: int
    reason: int
    mass_ratio: float
    sink: float
class carom_fault(ctypes.Structure):
    """Something misbehaved in the last step; the world stayed finite."""
    kind: int
    reserved: int
    shape: int
    body: int
    dir: Any
    out: Any
    particles: int
    particle: int
class carom_query_desc(ctypes.Structure):
    """Settings of a query; fill with carom_query_desc_init(). The same for all queries of a call."""
    struct_size: int
    flags: int
    category: int
    mask: int
    ignore: int
    tolerance: float
    target: float
    iterations: int
    reserved: int
class carom_world_hit(ctypes.Structure):
    """One collider's result. Of casts: as in carom_cast. Of overlaps: outcome OVERLAP with a point in both, or UNDECIDED
    within rounding. Of the nearest: separation, lower and upper as in carom_distance, time 0; outcome OVERLAP if it is
    negative, else HIT."""
    outcome: int
    status: int
    query: int
    collider: int
    body: int
    time: float
    lower: float
    upper: float
    separation: float
    normal: Any
    point: Any
    point_own: Any
class carom_query_shapes(ctypes.Structure):
    """Query shapes, in the caller's arrays, of float or double, at any stride (0: tightly packed). struct_size and
    scalar set by the caller, what is not set zero."""
    struct_size: int
    scalar: int
    count: int
    shapes: Any
    positions: Any
    orientations: Any
    motions: Any
    shape_stride: int
    position_stride: int
    orientation_stride: int
    motion_stride: int
class carom_world_hits(ctypes.Structure):
    """Where results of rays go, one each: records, or separate arrays, or both; NULL: not wanted. Strides in bytes, 0:
    tightly packed."""
    struct_size: int
    scalar: int
    records: Any
    outcomes: Any
    colliders: Any
    times: Any
    normals: Any
    points: Any
    record_stride: int
    outcome_stride: int
    collider_stride: int
    time_stride: int
    normal_stride: int
    point_stride: int
def carom_version(major: Any, minor: Any, patch: Any) -> int:
    """Version of the library that is running (the CAROM_VERSION_* macros are the header's).
    @param major, minor, patch as CAROM_VERSION_*
    @status OK; NULL_ARGUMENT"""
    ...
def carom_result_name(result: Any) -> bytes:
    """Name of a result code, e.g. "CAROM_E_BUSY"; "CAROM_E_?" for an unknown one. Static storage.
    @param result of any call"""
    ...
def carom_result_remedy(result: Any) -> bytes:
    """What to do about a result code, in one sentence. Static storage.
    @param result of any call"""
    ...
def carom_abi_manifest() -> bytes:
    """The layout of every struct of this interface, as the compiler that built this library has it: for a binding, which
    compares it with its own when it is loaded. Lines of four words, ending in '\\n'; first "carom" and the version:
        carom 0.9.0
        carom_error 0 576 struct              name, offset, size in bytes, kind
        carom_error.struct_size 0 4 u32
        carom_error.witness_dir 16 24 f64[3]
    Kinds: u32, i32, u64 (handles too), f64, char, ptr, fn (pointer to a function), struct; [n] behind it: an array.
    Newer libraries have more lines, and a struct may be larger; a field stays as it is.
    Static storage."""
    ...
def carom_abi_check(layout: Any, error: Any) -> int:
    """Is this library what a client was built for? As bindings ask when they have loaded it: of the same major version and
    not older (of the same minor version before 1.0), and with the same structs, some of which may be larger here.
    @param layout  of the client: lines of carom_abi_manifest(), the first with its version, zero-terminated
    @status OK; NULL_ARGUMENT; OUT_OF_RANGE (no line of a version); UNSUPPORTED (the message names this library's file, and the
            first line that differs)"""
    ...
def carom_accuracy_init(accuracy: Any, struct_size: Any) -> int:
    """@status OK; NULL_ARGUMENT; STRUCT_SIZE"""
    ...
def carom_world_set_accuracy(world: Any, accuracy: Any, error: Any) -> int:
    """Set an error tolerance from the next step on.
    @param accuracy NULL: none, as a world is created
    @status OK; UNSUPPORTED; NULL_ARGUMENT; STRUCT_SIZE; NOT_FINITE; OUT_OF_RANGE (also where both place and turn are
    0);
            BUSY; REENTRANT"""
    ...
def carom_world_get_accuracy(world: Any, accuracy: Any, present: Any, error: Any) -> int:
    """@param accuracy out   @param present out: 1 or 0; if 0, accuracy is filled with defaults
    @status OK; NULL_ARGUMENT; STRUCT_SIZE; BUSY"""
    ...
def carom_world_get_islands(world: Any, dst: Any, stride: Any, capacity: Any, count: Any, error: Any) -> int:
    """Copy out the islands of the last step, worst first: by share, then by body. None without a tolerance.
    Bodies in free flight are in none: nothing acts on them but what is constant, and their step is exact.
    @param dst      [capacity] elements `stride` bytes apart; may be NULL if capacity is 0
    @param stride   sizeof(carom_island) as the caller knows it
    @param count    out: how many there are (may exceed capacity; capacity are written)
    @status OK; NULL_ARGUMENT; BUFFER_TOO_SMALL; OUT_OF_RANGE (stride); BUSY"""
    ...
def carom_world_measure_growth(world: Any, dt: Any, steps: Any, growth: Any, error: Any) -> int:
    """Measure how errors grow from here. Two copies of the world take the steps, at its dials and accuracy, so it costs a
    little over twice as much as they; nothing of the world itself changes. The same world gives the same result.
    Errors grow e-fold (`sensitive`) where they grow a hundredfold or more, and a quarter of the time or more goes by
    until they have grown to the root of that: half of it in chaos, a tenth where they grow in proportion to time.
    @param dt      s, of a step: as for carom_world_step()
    @param steps   1 to 1000000: several e-foldings of what is looked for, and more than the longest period
    @param growth  out, its struct_size set
    @status OK; NULL_ARGUMENT; STRUCT_SIZE; NOT_FINITE; OUT_OF_RANGE; LIMIT; BUSY; REENTRANT; OUT_OF_MEMORY
    @thread reader"""
    ...
def carom_batch_column_init(column: Any, struct_size: Any) -> int:
    """@status OK; NULL_ARGUMENT; STRUCT_SIZE"""
    ...
def carom_batch_create(engine: Any, batch: Any, error: Any) -> int:
    """Make a batch without worlds.
    @param batch out: to be destroyed before the engine   @owns the caller: carom_batch_destroy()
    @status OK; NULL_ARGUMENT; OUT_OF_MEMORY   @thread engine"""
    ...
def carom_batch_destroy(batch: Any, error: Any) -> int:
    """@status OK; NULL_ARGUMENT; BUSY; REENTRANT"""
    ...
def carom_batch_add_worlds(batch: Any, world: Any, n: Any, first: Any, error: Any) -> int:
    """Add n worlds that are as this one is now. The world itself is read, stays as it is, and may be destroyed. A ledger, a
    recording and a budget of time are not copied.
    @param batch of the same engine   @param n 1 to 2^24 in all   @param first out: the number of the first of them
    @status OK; NULL_ARGUMENT; OUT_OF_RANGE (n); WRONG_WORLD (of another engine); LIMIT (256 structures in all); BUSY;
            REENTRANT; OUT_OF_MEMORY"""
    ...
def carom_batch_add_column(batch: Any, desc: Any, column: Any, error: Any) -> int:
    """Say where numbers of worlds stand.
    @param column out: its number, from 0 on; may be NULL
    @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; OUT_OF_RANGE (world, n, a ray); NOT_FINITE; *_HANDLE;
            UNSUPPORTED (a joint or body that has no such field; read only: not BEFORE_STEP, nor fields that move
            joints); BUFFER_TOO_SMALL (stride); LIMIT (4,096 columns); BUSY; REENTRANT; OUT_OF_MEMORY"""
    ...
def carom_batch_step(batch: Any, mask: Any, dt: Any, steps: Any, stopped: Any, error: Any) -> int:
    """Advance worlds, each by steps of dt. First, all that columns BEFORE_STEP have for them is checked: where something is
    refused no world has moved. A world that is stopped stays as it is, and so do its rows.
    @param mask     [worlds] or NULL: all
    @param dt       s, in [1e-9, 1]
    @param steps    1 to 1e6, with the same numbers before each
    @param stopped  out: how many worlds are stopped now, in all; may be NULL
    @status OK; NULL_ARGUMENT; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; UNSUPPORTED; BUSY; REENTRANT; OUT_OF_MEMORY; INTERNAL (a
            callback left its thread: some worlds were stepped)"""
    ...
def carom_batch_read(batch: Any, columns: Any, count: Any, mask: Any, error: Any) -> int:
    """Read columns, of worlds as they are now. Contact forces are those of a step: 0 here.
    @param columns [count]   @param mask [worlds] or NULL: all
    @status OK; NULL_ARGUMENT; OUT_OF_RANGE (a column); BUSY; REENTRANT; OUT_OF_MEMORY"""
    ...
def carom_batch_write(batch: Any, columns: Any, count: Any, mask: Any, error: Any) -> int:
    """Write columns, one after the other: poses, speeds, gains, friction, masses. All worlds or none are changed.
    @param columns [count]   @param mask [worlds] or NULL: all
    @status OK; NULL_ARGUMENT; OUT_OF_RANGE; NOT_FINITE; NOT_UNIT; UNSUPPORTED (read only, or joints that can't be moved);
            BUSY; REENTRANT; OUT_OF_MEMORY"""
    ...
def carom_batch_add_start(batch: Any, world: Any, bytes: Any, size: Any, start: Any, error: Any) -> int:
    """Add a state that worlds of a structure may be reset to.
    @param world  one of the structure   @param bytes [size] as carom_world_restore() takes them   @param size of bytes
    @param start  out: its number among those of the structure, from 1 on; 0 is the state that its worlds were made with
    @status OK; NULL_ARGUMENT; OUT_OF_RANGE (world); CORRUPT; UNSUPPORTED; MISMATCH; BUSY; REENTRANT; OUT_OF_MEMORY"""
    ...
def carom_batch_reset(batch: Any, mask: Any, starts: Any, error: Any) -> int:
    """Put worlds back to where they began. Masses that were written stay; what else was written is as in the start.
    A world that is stopped runs again.
    @param mask   [worlds] or NULL: all   @param starts [worlds] numbers of starts, or NULL: 0
    @status OK; NULL_ARGUMENT; OUT_OF_RANGE (a start); BUSY; REENTRANT; OUT_OF_MEMORY"""
    ...
def carom_batch_save(batch: Any, world: Any, buffer: Any, capacity: Any, needed: Any, error: Any) -> int:
    """Write a snapshot of one world, as carom_world_save() with CAROM_SNAPSHOT_STATE: it goes into the world that was
    copied (unless masses differ), or back by carom_batch_add_start(). Arguments as there.
    @param world    its number
    @param buffer   [capacity] bytes, or NULL to get the size alone
    @param capacity bytes; 0 if buffer is NULL
    @param needed   out: bytes of the snapshot; written, too, when the buffer is too small (nothing else is)
    @status OK; NULL_ARGUMENT; OUT_OF_RANGE (world); BUFFER_TOO_SMALL; BUSY; REENTRANT; OUT_OF_MEMORY"""
    ...
def carom_batch_get_hashes(batch: Any, hashes: Any, n: Any, error: Any) -> int:
    """The hash of each world, as carom_world_hash().
    @param hashes out, [worlds]   @param n how many worlds there are
    @status OK; NULL_ARGUMENT; OUT_OF_RANGE (n); BUSY; REENTRANT; OUT_OF_MEMORY"""
    ...
def carom_batch_get_stopped(batch: Any, stopped: Any, n: Any, error: Any) -> int:
    """Which worlds are stopped, and why.
    @param stopped out, [worlds] CAROM_STOPPED_*   @param n how many worlds there are
    @status OK; NULL_ARGUMENT; OUT_OF_RANGE (n); BUSY"""
    ...
def carom_batch_get_faults(batch: Any, world: Any, dst: Any, stride: Any, capacity: Any, count: Any, error: Any) -> int:
    """The faults of the step that stopped a world; none where it is not stopped.
    @param world    its number
    @param dst      [capacity] elements `stride` bytes apart; may be NULL if capacity is 0
    @param stride   sizeof(carom_fault) as the caller knows it
    @param count    out: how many there are (may exceed capacity; capacity are written)
    @status OK; NULL_ARGUMENT; BUFFER_TOO_SMALL; OUT_OF_RANGE (world, stride); BUSY"""
    ...
def carom_batch_get_info(batch: Any, info: Any, error: Any) -> int:
    """@status OK; NULL_ARGUMENT; STRUCT_SIZE; BUSY"""
    ...
def carom_random_fill(kind: Any, keys: Any, n: Any, width: Any, dst: Any, error: Any) -> int:
    """Random numbers that follow from a key alone: n rows, each from its own key. So they do not depend on how many worlds
    there are, in which order or on which thread, or machine, they are drawn. Philox4x32-10; the normal ones by Box and
    Muller. A row that is longer begins as a shorter one of its key.
    @param kind  CAROM_RANDOM_*
    @param keys  [3 n]: of each row a seed, the number of a world, a step
    @param width numbers in a row
    @param dst   out, [n width]
    @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; OUT_OF_RANGE (n, width)   @thread any"""
    ...
def carom_material_desc_init(desc: Any, struct_size: Any) -> int:
    """@status OK; NULL_ARGUMENT; STRUCT_SIZE"""
    ...
def carom_material_create(world: Any, desc: Any, material: Any, error: Any) -> int:
    """@status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; NOT_FINITE; OUT_OF_RANGE; UNKNOWN_ENUM; BUSY; OUT_OF_MEMORY"""
    ...
def carom_material_update(world: Any, material: Any, desc: Any, error: Any) -> int:
    """Change a material in place; every collider that uses it follows.   @status as carom_material_create(); *_HANDLE"""
    ...
def carom_material_set_resistance(world: Any, material: Any, rolling: Any, spinning: Any, error: Any) -> int:
    """Resistance of a surface to rolling and to spinning about the normal, 0 when it is created. A contact that presses
    with a force N bears a moment of up to rolling * N in its plane and of up to spinning * N about its normal. Mixed as
    friction is; carom_material_update() leaves it alone.
    @param rolling, spinning m, [0, 1e3]
    @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; OUT_OF_MEMORY"""
    ...
def carom_material_get_resistance(world: Any, material: Any, rolling: Any, spinning: Any, error: Any) -> int:
    """@param rolling, spinning out: m   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY"""
    ...
def carom_material_set_pair(world: Any, material_a: Any, material_b: Any, surface: Any, error: Any) -> int:
    """Say what two materials are to each other, instead of mixing them. Wakes what touches so. It ends with either material.
    @param material_a, material_b  in any order; the same twice: colliders of that material among themselves
    @param surface [4] friction, [0, 1e3]; restitution, [0, 1]; resistance to rolling and to spinning, m, [0, 1e3].
                   NULL: they mix again
    @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; OUT_OF_MEMORY   @since 0.9"""
    ...
def carom_material_get_pair(world: Any, material_a: Any, material_b: Any, surface: Any, error: Any) -> int:
    """What two materials are to each other: what was said of them, or else what they mix to.
    @param surface out, [4]: as carom_material_set_pair() takes it
    @status OK; NULL_ARGUMENT; *_HANDLE; BUSY   @since 0.9"""
    ...
def carom_material_destroy(world: Any, material: Any, error: Any) -> int:
    """@status OK; NULL_ARGUMENT; *_HANDLE; IN_USE (a collider uses it); BUSY"""
    ...
def carom_body_desc_init(desc: Any, struct_size: Any) -> int:
    """@status OK; NULL_ARGUMENT; STRUCT_SIZE"""
    ...
def carom_body_create(world: Any, desc: Any, body: Any, error: Any) -> int:
    """@status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; UNKNOWN_ENUM; BUSY;
            REENTRANT; LIMIT; OUT_OF_MEMORY"""
    ...
def carom_body_destroy(world: Any, body: Any, error: Any) -> int:
    """Destroys its colliders too.   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT"""
    ...
def carom_body_get(world: Any, body: Any, desc: Any, error: Any) -> int:
    """Everything there is to know about a body, with its masses as the engine uses them (fields: all of FIELD_* set; a
    body that cannot rotate reports zero inertia; a static or kinematic body reports mass 0).
    @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; BUSY"""
    ...
def carom_body_set_pose(world: Any, body: Any, position: Any, orientation: Any, error: Any) -> int:
    """@param position [3] m   @param orientation [4] x, y, z, w   @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE;
    NOT_UNIT; BUSY; REENTRANT"""
    ...
def carom_body_set_velocity(world: Any, body: Any, linear: Any, angular: Any, error: Any) -> int:
    """@param linear [3] m/s of the centre of mass   @param angular [3] rad/s, both world frame
    @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE (a static body must have 0); BUSY; REENTRANT"""
    ...
def carom_body_get_pose(world: Any, body: Any, position: Any, orientation: Any, error: Any) -> int:
    """@param position [3] out, or NULL: m, world, origin of the body frame   @param orientation [4] out, or NULL: x, y, z,
    w, body to world   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY"""
    ...
def carom_body_get_velocity(world: Any, body: Any, linear: Any, angular: Any, error: Any) -> int:
    """@param linear [3] out, or NULL: m/s, world, of the centre of mass   @param angular [3] out, or NULL: rad/s, world
    @status OK; NULL_ARGUMENT; *_HANDLE; BUSY"""
    ...
def carom_body_set_mass(world: Any, body: Any, mass: Any, center: Any, inertia: Any, error: Any) -> int:
    """Set the mass of a dynamic body, as carom_body_desc would have. Its frame stays; the velocity of its centre is kept
    as that of the new centre. Wakes the body and its island. Snapshots of before do not fit any more (MISMATCH).
    @param mass kg, at least 1e-300; or 0: from the densities of its colliders, with center and inertia NULL
    @param center [3] m, body frame, or NULL: from its colliders
    @param inertia [9] kg m^2, body frame axes, about the centre, row-major, symmetric, positive definite or all zero;
    or NULL:
                   from its colliders, scaled to the mass
    @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE (also: a body that is not dynamic); NO_VOLUME (mass 0,
            and a collider is flat); BUSY; REENTRANT; OUT_OF_MEMORY"""
    ...
def carom_body_get_mass(world: Any, body: Any, mass: Any, center: Any, inertia: Any, error: Any) -> int:
    """As the engine uses them: mass 0 of a body that is not dynamic, inertia 0 of one that cannot rotate.
    @param mass out, or NULL: kg   @param center [3] out, or NULL: m, body frame   @param inertia [9] out, or NULL: kg
    m^2, body frame axes, about the centre, row-major   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY"""
    ...
def carom_body_set_type(world: Any, body: Any, type: Any, error: Any) -> int:
    """Make a static, kinematic or dynamic body of one that is there. A body that becomes static stops. One that is dynamic
    no longer loses the mass that it was given, pending forces and what only dynamic bodies may have
    (carom_attribute_info.of_dynamic). Snapshots of before do not fit any more. What it touches wakes.
    @param type CAROM_BODY_*
    @status OK; NULL_ARGUMENT; *_HANDLE; UNKNOWN_ENUM; OUT_OF_RANGE (a half-space needs a static body, scenery one that
            is not dynamic; a joint or a spring needs a dynamic one); NO_VOLUME; BUSY; REENTRANT; OUT_OF_MEMORY"""
    ...
def carom_body_get_type(world: Any, body: Any, type: Any, error: Any) -> int:
    """@param type out: CAROM_BODY_*   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY"""
    ...
def carom_body_set_damping(world: Any, body: Any, linear: Any, angular: Any, error: Any) -> int:
    """@param linear, angular 1/s, [0, 1e6]: dv/dt = -linear v, likewise of spin   @status OK; NULL_ARGUMENT; *_HANDLE;
    NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT"""
    ...
def carom_body_get_damping(world: Any, body: Any, linear: Any, angular: Any, error: Any) -> int:
    """@param linear, angular out: 1/s; either may be NULL   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY"""
    ...
def carom_body_set_user(world: Any, body: Any, user: Any, error: Any) -> int:
    """@param user anything; the engine does not look   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT"""
    ...
def carom_body_get_user(world: Any, body: Any, user: Any, error: Any) -> int:
    """@param user out   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY"""
    ...
def carom_body_get_colliders(world: Any, body: Any, colliders: Any, capacity: Any, count: Any, error: Any) -> int:
    """Number of a body's colliders, and their handles in the order of the slots.
    @param colliders [capacity] or NULL   @param count out: how many there are (may exceed capacity; capacity are
    written)
    @status OK; NULL_ARGUMENT; *_HANDLE; BUSY"""
    ...
def carom_body_add_force(world: Any, body: Any, force: Any, torque: Any, error: Any) -> int:
    """Add a force and a torque about the centre of mass, for the next step only.
    @param force [3] N, world   @param torque [3] N m, world
    @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE (the sum would overflow); BUSY; REENTRANT"""
    ...
def carom_body_add_impulse(world: Any, body: Any, impulse: Any, point: Any, error: Any) -> int:
    """Change velocities at once. @param impulse [3] N s, world   @param point [3] m, world: where it acts
    @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE (the velocity would overflow); BUSY; REENTRANT"""
    ...
def carom_body_set_gravity_factor(world: Any, body: Any, factor: Any, error: Any) -> int:
    """How much of the world's gravity acts on a body: its weight is mass * factor * gravity. With 0 it floats, below 0 it
    rises. 1 - c compensates a share c of its gravity, as a counterweight does; inverse dynamics counts it (tree.h). Wakes the body and its island.
    @param factor any finite number; 1 when a body is created
    @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; BUSY; REENTRANT; OUT_OF_MEMORY"""
    ...
def carom_body_get_gravity_factor(world: Any, body: Any, factor: Any, error: Any) -> int:
    """@param factor out   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY"""
    ...
def carom_body_set_locks(world: Any, body: Any, locks: Any, error: Any) -> int:
    """Hold the velocity of a dynamic body along and about some world axes at 0, exactly: forces, contacts and joints move
    it along the others alone, as heavy there as it is. What it has of such velocity now is gone; what a host writes of
    it later is dropped; a pose that a host sets is taken, and kept from then on. Wakes the body and its island.
    
    Every solver but CAROM_SOLVER_SEVERITY knows locks: a world with that dial refuses them, and a world with a locked
    body refuses that dial.
    @param locks CAROM_LOCK_* bits, 0 when a body is created
    @status OK; NULL_ARGUMENT; *_HANDLE; UNSUPPORTED (unknown bits; or solver severity: set CAROM_DIAL_SOLVER to another
            first); OUT_OF_RANGE (a body that is not dynamic: it moves as its velocity says); BUSY; REENTRANT;
            OUT_OF_MEMORY"""
    ...
def carom_body_get_locks(world: Any, body: Any, locks: Any, error: Any) -> int:
    """@param locks out: CAROM_LOCK_* bits   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY"""
    ...
def carom_attribute_get_info(attribute: Any, info: Any, error: Any) -> int:
    """@param attribute CAROM_ATTRIBUTE_*   @param info out
    @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM"""
    ...
def carom_body_set_attribute(world: Any, body: Any, attribute: Any, value: Any, error: Any) -> int:
    """Set an attribute. Another value than it has wakes the body and its island.
    @param value [4] in the units of carom_attribute_info; numbers that the attribute does not have must be 0
    @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; *_HANDLE; NOT_FINITE; OUT_OF_RANGE (also: a fraction where numbers are
    whole; a
            body that is not dynamic); UNSUPPORTED (locks under solver severity); BUSY; REENTRANT; OUT_OF_MEMORY"""
    ...
def carom_body_get_attribute(world: Any, body: Any, attribute: Any, value: Any, error: Any) -> int:
    """@param value [4] out: numbers that the attribute does not have are 0
    @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; *_HANDLE; BUSY"""
    ...
def carom_body_is_asleep(world: Any, body: Any, asleep: Any, error: Any) -> int:
    """@param asleep out: 1 or 0   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY"""
    ...
def carom_body_wake(world: Any, body: Any, error: Any) -> int:
    """Wake a body and its island; if it is awake, its time of rest starts anew.   @status OK; NULL_ARGUMENT; *_HANDLE;
    BUSY; REENTRANT"""
    ...
def carom_body_set_continuous(world: Any, body: Any, mode: Any, error: Any) -> int:
    """Say when a body is swept, from the next step on. Without effect on a static body, and where CAROM_DIAL_CONTINUOUS
    says otherwise: under CAROM_SWEEP_NONE no body is swept, under CAROM_SWEEP_FLAGGED only CAROM_CONTINUOUS_ALWAYS.
    @param mode CAROM_CONTINUOUS_*
    @status OK; NULL_ARGUMENT; *_HANDLE; UNKNOWN_ENUM (mode: pass one of CAROM_CONTINUOUS_*); BUSY; REENTRANT"""
    ...
def carom_body_get_continuous(world: Any, body: Any, mode: Any, error: Any) -> int:
    """@param mode out: CAROM_CONTINUOUS_*   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY"""
    ...
def carom_body_set_enabled(world: Any, body: Any, enabled: Any, error: Any) -> int:
    """Take a body out of steps, or back in, from the next step on. A disabled body keeps its pose and velocity. Nothing
    moves it, it touches nothing, and its joints and springs hold nothing. Queries do not find it. Bodies that rested on
    it wake. It costs a step nothing. A host may still read and write it.
    @param enabled 1 or 0
    @status OK; NULL_ARGUMENT; *_HANDLE; UNKNOWN_ENUM (enabled: pass 0 or 1); BUSY; REENTRANT; OUT_OF_MEMORY"""
    ...
def carom_body_is_enabled(world: Any, body: Any, enabled: Any, error: Any) -> int:
    """@param enabled out: 1 or 0   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY"""
    ...
def carom_collider_desc_init(desc: Any, struct_size: Any) -> int:
    """@status OK; NULL_ARGUMENT; STRUCT_SIZE"""
    ...
def carom_collider_create(world: Any, body: Any, desc: Any, collider: Any, error: Any) -> int:
    """Put a shape on a body; the body's mass properties follow. The body's linear velocity is kept as that of its new
    centre.
    @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE (also: a
    half-space on a
            body that moves); NO_VOLUME (a flat shape needs CAROM_BODY_FIELD_MASS or density 0); BUSY; REENTRANT;
            OUT_OF_MEMORY"""
    ...
def carom_body_create_named(world: Any, type: Any, name: Any, params: Any, count: Any, position: Any, body: Any, error: Any) -> int:
    """The common case in one call: a shape by name, a body, and a collider of density 1000. A shape of that name with the
    same parameters that the engine has is used again; a new one lives as long as the engine, or until it is destroyed.
    Where a part of it fails nothing has changed, but for a plugin that was loaded. Its orientation is the identity, its
    friction 0.5, its restitution 0. carom_body_get_colliders() gives its collider.
    @param type CAROM_BODY_*   @param name as carom_shape_create_named()   @param position [3] m, world
    @param params [count] as carom_shape_create_named()   @param count number of params
    @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; NOT_FOUND; NOT_FINITE; OUT_OF_RANGE; NO_VOLUME; PLUGIN_PATH; PLUGIN_LOAD;
            PLUGIN_ABI; PLUGIN_INVALID; DECLARATION_FALSE; BUSY; REENTRANT; LIMIT; OUT_OF_MEMORY"""
    ...
def carom_collider_destroy(world: Any, collider: Any, error: Any) -> int:
    """@status OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT"""
    ...
def carom_collider_get(world: Any, collider: Any, desc: Any, body: Any, error: Any) -> int:
    """@status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; BUSY"""
    ...
def carom_collider_set_material(world: Any, collider: Any, material: Any, error: Any) -> int:
    """Give a collider another material. Wakes what its body touches.   @param material or CAROM_NULL_HANDLE: friction 0.5,
    restitution 0   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT; OUT_OF_MEMORY"""
    ...
def carom_collider_set_density(world: Any, collider: Any, density: Any, error: Any) -> int:
    """The body's mass follows, unless it was given. Wakes the body and its island.   @param density kg/m^3, [0, 1e9]
    @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE; NO_VOLUME; BUSY; REENTRANT; OUT_OF_MEMORY"""
    ...
def carom_collider_set_pose(world: Any, collider: Any, position: Any, orientation: Any, error: Any) -> int:
    """Move a shape on its body; the body's mass follows. What is remembered of its contacts is dropped.
    @param position [3] m, body frame: origin of the shape; each within 1e15   @param orientation [4] x, y, z, w, shape
    to body
    @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; BUSY; REENTRANT; OUT_OF_MEMORY"""
    ...
def carom_collider_set_surface_velocity(world: Any, collider: Any, linear: Any, angular: Any, error: Any) -> int:
    """Let a collider's surface move though the collider stays: a conveyor belt, a turntable, a track. Friction then brings
    what touches it to the velocity of the surface,
      v_body(x) + R (linear + angular x (R^T (x - p))),   the part of it in the plane of the contact,
    with R the orientation and p the origin of the shape in the world: axes and origin are the shape's own, so that a
    belt turns with its body. Nothing moves but by friction: a surface without friction moves nothing. On a body that
    moves it drives that body. Wakes what a change of the collider's filter wakes; what touches a surface that moves
    does not fall asleep.
    @param linear  [3] m/s, axes of the shape; 0 when a collider is created
    @param angular [3] rad/s, axes of the shape, about its origin
    @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE (beyond 1e6 m/s or rad/s); BUSY; REENTRANT;
            OUT_OF_MEMORY"""
    ...
def carom_collider_get_surface_velocity(world: Any, collider: Any, linear: Any, angular: Any, error: Any) -> int:
    """@param linear, angular out: [3], as they were set   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY"""
    ...
def carom_world_get_bodies(world: Any, handles: Any, capacity: Any, count: Any, error: Any) -> int:
    """Number of bodies, and their handles in creation order of the slots.
    @param handles [capacity] or NULL   @param count out: how many there are
    @status OK; NULL_ARGUMENT; BUSY"""
    ...
def carom_world_read(world: Any, field: Any, scalar: Any, handles: Any, n: Any, dst: Any, stride: Any, error: Any) -> int:
    """Read one field of n bodies.
    @param handles [n], or NULL for all bodies in the order of carom_world_get_bodies() (n must be their number)
    @param dst     n records of the field's scalars, `stride` bytes apart
    @param stride  bytes from one record to the next; 0: tightly packed
    @param field   CAROM_FIELD_*
    @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; *_HANDLE (nothing is written); OUT_OF_RANGE (n); BUFFER_TOO_SMALL (stride);
    BUSY"""
    ...
def carom_world_write(world: Any, field: Any, scalar: Any, handles: Any, n: Any, src: Any, stride: Any, error: Any) -> int:
    """Write one field of n bodies; all values are validated before the first is written. Arguments as carom_world_read().
    @param src n records of the field's scalars, `stride` bytes apart
    @status as carom_world_read(); UNSUPPORTED (read-only field); NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; REENTRANT"""
    ...
def carom_cast_desc_init(desc: Any, struct_size: Any) -> int:
    """@status OK; NULL_ARGUMENT; STRUCT_SIZE"""
    ...
def carom_motion_init(motion: Any, struct_size: Any) -> int:
    """@status OK; NULL_ARGUMENT; STRUCT_SIZE"""
    ...
def carom_ray_cast(engine: Any, shape: Any, position: Any, orientation: Any, origin: Any, direction: Any, max: Any, desc: Any, result: Any, error: Any) -> int:
    """Cast the ray origin + t direction, 0 <= t <= max, against a shape.
    @param position, orientation  of the shape: [3] m, [4] x, y, z, w
    @param origin [3] m   @param direction [3] m per unit of t, any length; zero asks whether the origin is inside
    @param max    >= 0, may be infinite
    @param desc   may be NULL: defaults     @param result struct_size set by the caller
    @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; UNSUPPORTED"""
    ...
def carom_shape_cast(engine: Any, shape_a: Any, position_a: Any, orientation_a: Any, motion: Any, shape_b: Any, position_b: Any, orientation_b: Any, desc: Any, result: Any, error: Any) -> int:
    """Move shape A along a straight line, without turning it, until it touches B.
    @param motion [3] m, of A; times are fractions of it. If B moves too: the difference of the two
    @param desc   may be NULL: defaults     @param result struct_size set by the caller
    @param position_* [3] m, world   @param orientation_* [4] x, y, z, w
    @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; UNSUPPORTED (two
            half-spaces)"""
    ...
def carom_shape_time_of_impact(engine: Any, shape_a: Any, motion_a: Any, shape_b: Any, motion_b: Any, duration: Any, desc: Any, result: Any, error: Any) -> int:
    """First contact of two shapes that both travel and turn, within a duration. UNDECIDED: the cap came first, nothing
    touches before `lower`.
    @param motion_*  struct_size set by carom_motion_init()   @param duration s, 0 to 1e9
    @param desc   may be NULL: defaults     @param result struct_size set by the caller; times in s
    @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE;
            UNSUPPORTED (two half-spaces, or one that turns)"""
    ...
def carom_shape_overlap(engine: Any, shape_a: Any, position_a: Any, orientation_a: Any, shape_b: Any, position_b: Any, orientation_b: Any, desc: Any, result: Any, error: Any) -> int:
    """Do two shapes overlap (or come nearer than desc->target)? Cheaper than their distance, with a proof of yes or no.
    @param desc   may be NULL: defaults; tolerance is not used   @param result struct_size set by the caller
    @param position_* [3] m, world   @param orientation_* [4] x, y, z, w
    @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; UNSUPPORTED (two
            half-spaces)"""
    ...
def carom_rays_cast(engine: Any, shapes: Any, positions: Any, orientations: Any, shape_count: Any, rays: Any, desc: Any, hits: Any, error: Any) -> int:
    """Cast many rays against one or more shapes: the first hit of each. A bad ray, or one for which a support function
    misbehaves (status CAROM_QUERY_FAULT, that of `shape`), spoils no other. Nothing is allocated per ray.
    @param shapes [shape_count]   @param positions [3 shape_count] m   @param orientations [4 shape_count] x, y, z, w
    @param desc   may be NULL: defaults
    @param shape_count number of shapes
    @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; UNKNOWN_ENUM; UNSUPPORTED;
            BUFFER_TOO_SMALL (a stride); LIMIT (2^32 - 1 shapes); OUT_OF_MEMORY"""
    ...
def carom_character_desc_init(desc: Any, struct_size: Any) -> int:
    """@status OK; NULL_ARGUMENT; STRUCT_SIZE"""
    ...
def carom_character_init(character: Any, struct_size: Any) -> int:
    """At the origin, in the air, without a shape.   @status OK; NULL_ARGUMENT; STRUCT_SIZE"""
    ...
def carom_character_set_shape(engine: Any, world: Any, desc: Any, character: Any, shape: Any, fits: Any, error: Any) -> int:
    """Give it a shape, or another one: to crouch, to stand up. The lowest point stays where it is, so the origin moves
    along `up`. With `fits` the new shape is looked at first. If something is within half the skin of it, `fits` becomes
    0 and nothing changes. Call it again after `up` has changed against the shape.
    @param shape convex, of the world's engine: most take a capsule
    @param desc may be NULL: defaults
    @param character its shape, position, foot, head and reach change
    @param fits out: 1 or 0; NULL: it is changed whatever is there, and a later move brings it out
    @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED (a half-space, scenery; unknown bits); UNKNOWN_ENUM; *_HANDLE;
            NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; PLUGIN_INVALID; BUSY; REENTRANT; OUT_OF_MEMORY   @thread reader"""
    ...
def carom_character_move(world: Any, desc: Any, character: Any, walk: Any, jump: Any, dt: Any, error: Any) -> int:
    """Move a character by dt. In this order: it follows the ground that it stood on, leaves what it overlaps, then walks,
    jumps or falls.
    
    On firm ground its velocity across `up` follows `walk`, on slopes and steps, too. In the air and on steep ground it
    follows `walk` plus the velocity of the ground that it left. Paths in the air are exact parabolas, so where it lands
    does not depend on dt beyond one dt's way. On open ground a move takes three queries, in a corner about ten. It
    allocates nothing but what queries do.
    @param desc may be NULL: defaults
    @param character all but shape, foot, head and reach may change
    @param walk [3] m/s, world, each within 1e6: what it is to move at, relative to the ground; the part along `up`
           counts only with CAROM_CHARACTER_FLIES
    @param jump m/s, [0, 1e6], along `up`: on firm ground it takes off at this speed, and takes the velocity of the
           ground with it; else, and with 0, it does not
    @param dt s, [0, 1]
    @accuracy stands `skin` and 2 % from surfaces, within 1e-5 m or 1e-6 of its size
    @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED (unknown bits, reserved); UNKNOWN_ENUM; *_HANDLE (desc->body;
            character->shape: call carom_character_set_shape() first); NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; BUSY;
            REENTRANT; OUT_OF_MEMORY
    @thread reader"""
    ...
def carom_character_push(world: Any, desc: Any, character: Any, dt: Any, error: Any) -> int:
    """Push what the last move met, and press on what the character stands on, as forces of the next step. A dynamic body
    in its way gets the force that would bring it to the character's speed within dt, push_force at most. One under
    firm feet gets mass * gravity. Bodies that are gone are left out.
    @param desc may be NULL: defaults   @param character as the last move left it   @param dt s, [1e-9, 1], of the next
    step
    @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; UNKNOWN_ENUM; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE;
            BUSY; REENTRANT; OUT_OF_MEMORY"""
    ...
def carom_character_move_body(world: Any, desc: Any, character: Any, dt: Any, error: Any) -> int:
    """Let a kinematic body of the host's follow the character, so that other bodies and characters touch it. It gets the
    velocity that brings it to the character's place in the next step of dt. Where that is over 1 m away, or the
    character has turned, it is placed there at once, at rest. Give the body the character's shape, and name it in
    desc->body.
    @param desc with a body   @param dt s, [1e-9, 1], of the next step
    @param character as the last move left it
    @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; UNKNOWN_ENUM; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE
            (also: a body that is not kinematic); BUSY; REENTRANT; OUT_OF_MEMORY"""
    ...
def carom_dial_get_info(dial: Any, info: Any, error: Any) -> int:
    """@status OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM (dial >= CAROM_DIAL_COUNT of this library)"""
    ...
def carom_dial_get_count(count: Any) -> int:
    """Number of dials this library has.   @status OK; NULL_ARGUMENT"""
    ...
def carom_dial_find(name: Any, dial: Any, error: Any) -> int:
    """@param name as in carom_dial_info.name
    @status OK; NULL_ARGUMENT; NOT_FOUND; READ_ONLY (this is a constant, not a dial)"""
    ...
def carom_constant_get_count(count: Any) -> int:
    """Number of constants this library has.   @status OK; NULL_ARGUMENT"""
    ...
def carom_constant_get_info(constant: Any, info: Any, error: Any) -> int:
    """@param constant from 0   @param info out
    @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM (constant >= carom_constant_get_count())"""
    ...
def carom_preset_name(preset: Any) -> bytes:
    """Static name of a preset ("balanced"), or "?".
    @param preset CAROM_PRESET_*"""
    ...
def carom_preset_get_dial(preset: Any, dial: Any, value: Any, error: Any) -> int:
    """What a preset sets a dial to. Presets speak of dials that trade accuracy for time, and all of the same ones; how a
    world finds pairs, what sleeps, and what a host chose for its look they leave alone.
    @param preset CAROM_PRESET_*   @param dial CAROM_DIAL_*   @param value out
    @param value what the preset sets the dial to
    @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; NOT_FOUND (presets leave this dial alone)"""
    ...
def carom_draw_desc_init(desc: Any, struct_size: Any) -> int:
    """@status OK; NULL_ARGUMENT; STRUCT_SIZE"""
    ...
def carom_world_draw(world: Any, desc: Any, dst: Any, stride: Any, capacity: Any, count: Any, error: Any) -> int:
    """All lines of the kinds that desc names, kind by kind in the order of the bits. Shapes whose support function fails
    are left out, and so are bodies in quarantine. The same world gives the same lines.
    @param desc     NULL: defaults
    @param dst      [capacity] elements `stride` bytes apart (0: sizeof(carom_draw_line)), or NULL to count
    @param count    out: lines there are; more than capacity: the first `capacity` of them were written
    @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED (a bit of what, reserved); UNKNOWN_ENUM; NOT_FINITE,
            OUT_OF_RANGE (scale); BUFFER_TOO_SMALL (stride); BUSY; REENTRANT; OUT_OF_MEMORY
    @thread reader"""
    ...
def carom_engine_desc_init(desc: Any, struct_size: Any) -> int:
    """@status OK; NULL_ARGUMENT; STRUCT_SIZE"""
    ...
def carom_engine_create(desc: Any, engine: Any, error: Any) -> int:
    """Make an engine. @param desc may be NULL: defaults.   @owns the caller: carom_engine_destroy()
    @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; LIMIT (65,535 engines and worlds in all); OUT_OF_MEMORY"""
    ...
def carom_engine_destroy(engine: Any, error: Any) -> int:
    """Destroy an engine; its worlds, batches and devices must be gone.   @status OK; NULL_ARGUMENT; IN_USE (destroy its worlds, batches and devices first);
    REENTRANT   @thread writer: no other call may use the engine"""
    ...
def carom_jobs_desc_init(desc: Any, struct_size: Any) -> int:
    """@status OK; NULL_ARGUMENT; STRUCT_SIZE"""
    ...
def carom_engine_set_jobs(engine: Any, desc: Any, error: Any) -> int:
    """Say which threads share the work of steps in the engine's worlds, before the first of them is made. Support
    functions are then called, and the allocator may be, on those threads; those of HOST_THREAD plugins are still called
    on the stepping one.
    @param desc may be NULL: the stepping thread alone
    @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; OUT_OF_RANGE; IN_USE (worlds, batches or devices are
    alive, or carom_pairs_distance() is under way); LIMIT (the system has no more threads); OUT_OF_MEMORY; REENTRANT"""
    ...
def carom_plugin_load(engine: Any, path: Any, plugin: Any, error: Any) -> int:
    """Load a shape plugin from a shared object. @param path absolute.
    The plugin is checked before anything is called, then by its support points in 256 directions, with parameters that
    the bounds allow. Loading the same path twice is ALREADY_EXISTS.
    @status OK; NULL_ARGUMENT; PLUGIN_PATH; PLUGIN_LOAD; PLUGIN_ABI; PLUGIN_INVALID; ALREADY_EXISTS; OUT_OF_MEMORY"""
    ...
def carom_plugin_register(engine: Any, description: Any, plugin: Any, error: Any) -> int:
    """Register a plugin by pointer: static linking, WebAssembly, or a shape written in the host's language.
    The struct and all it points to must outlive the engine.   @status as carom_plugin_load()"""
    ...
def carom_plugins_register_standard(engine: Any, error: Any) -> int:
    """Register the plugins of plugins/ that are linked into the library: in an archive (carom::carom_static), in
    WebAssembly, and where it was built with CAROM_LINK_SHAPES. Those that the engine has already are left as they are.
    @status OK; NULL_ARGUMENT; UNSUPPORTED (none is linked in: load files, or name shapes); LIMIT; OUT_OF_MEMORY"""
    ...
def carom_plugin_unload(engine: Any, plugin: Any, error: Any) -> int:
    """Forget a plugin (logically: the code stays mapped).   @status OK; NULL_ARGUMENT; IN_USE (shapes of it live);
    *_HANDLE; REENTRANT"""
    ...
def carom_plugin_find(engine: Any, id: Any, plugin: Any, error: Any) -> int:
    """Find a loaded plugin by its id.
    @param id as in carom_shape_plugin.id
    @status OK; NULL_ARGUMENT; NOT_FOUND (load it first)"""
    ...
def carom_plugin_describe(engine: Any, plugin: Any, description: Any, error: Any) -> int:
    """The plugin's own description, as its author compiled it: documentation, declarations, function. Only fields within
    its struct_size are there. Valid while the engine lives.
    @status OK; NULL_ARGUMENT; *_HANDLE"""
    ...
def carom_world_collect_events(world: Any, kinds: Any, hit_speed: Any, error: Any) -> int:
    """Say what to collect from the next step on; nothing at first. Contacts and overlaps that there are already begin in
    that step.
    @param kinds     CAROM_EVENTS_* bits; 0: nothing
    @param hit_speed m/s, [0, 1e9]: contacts that approach faster are hits
    @status OK; NULL_ARGUMENT; UNSUPPORTED (kinds); NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT; OUT_OF_MEMORY"""
    ...
def carom_world_get_contact_events(world: Any, dst: Any, stride: Any, capacity: Any, count: Any, error: Any) -> int:
    """Copy them out, by the slots of the two colliders; of one pair END before BEGIN before HIT.
    @param dst      [capacity] elements `stride` bytes apart; may be NULL if capacity is 0
    @param stride   sizeof(carom_contact_event) as the caller knows it
    @param count    out: how many there are (may exceed capacity; capacity are written)
    @status OK; NULL_ARGUMENT; BUFFER_TOO_SMALL; OUT_OF_RANGE (stride); BUSY"""
    ...
def carom_world_get_sensor_events(world: Any, dst: Any, stride: Any, capacity: Any, count: Any, error: Any) -> int:
    """Arguments as carom_world_get_contact_events()."""
    ...
def carom_world_get_sleep_events(world: Any, dst: Any, stride: Any, capacity: Any, count: Any, error: Any) -> int:
    """By the slots of the bodies; arguments as carom_world_get_contact_events()."""
    ...
def carom_world_get_joint_events(world: Any, dst: Any, stride: Any, capacity: Any, count: Any, error: Any) -> int:
    """By the slots of the joints; arguments as carom_world_get_contact_events()."""
    ...
def carom_world_get_fault_events(world: Any, dst: Any, stride: Any, capacity: Any, count: Any, error: Any) -> int:
    """As they happened; arguments as carom_world_get_contact_events()."""
    ...
def carom_collider_set_filter(world: Any, collider: Any, category: Any, mask: Any, group: Any, error: Any) -> int:
    """Two colliders of different bodies touch if each one's mask has a bit of the other's category; unless both are of one
    group other than 0: then they do if it is positive and do not if it is negative, whatever their masks say.
    @param category, mask  any bits   @param group 0: none
    @status OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT; OUT_OF_MEMORY"""
    ...
def carom_collider_get_filter(world: Any, collider: Any, category: Any, mask: Any, group: Any, error: Any) -> int:
    """@param category, mask, group  out   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY"""
    ...
def carom_body_set_filter(world: Any, body: Any, category: Any, mask: Any, group: Any, error: Any) -> int:
    """The same for all colliders that a body has now.   @status as carom_collider_set_filter()"""
    ...
def carom_body_ignore_collision(world: Any, body_a: Any, body_b: Any, ignored: Any, error: Any) -> int:
    """Let two bodies make no contacts with each other, whatever their filters say, or restore their contacts. Calls are
    counted: undo each one. Undoing more does nothing.
    @param ignored 1 or 0
    @status OK; NULL_ARGUMENT; *_HANDLE; OUT_OF_RANGE (ignored; a body and itself); BUSY; REENTRANT; OUT_OF_MEMORY"""
    ...
def carom_collider_set_sensor(world: Any, collider: Any, sensor: Any, error: Any) -> int:
    """Make a collider a sensor: it reports what overlaps it (carom_world_get_sensor_events()) and is touched by nothing.
    It obeys its filter, does not sense other sensors, and static sensors do not sense static bodies. Its density counts
    as before.
    @param sensor 1 or 0
    @status OK; NULL_ARGUMENT; *_HANDLE; OUT_OF_RANGE (sensor); BUSY; REENTRANT; OUT_OF_MEMORY"""
    ...
def carom_collider_is_sensor(world: Any, collider: Any, sensor: Any, error: Any) -> int:
    """@param sensor out: 1 or 0   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY"""
    ...
def carom_body_add_force_at(world: Any, body: Any, force: Any, point: Any, error: Any) -> int:
    """Add a force that acts at a point, for the next step only: carom_body_add_force() with its torque about the centre of
    mass as the body stands now.
    @param force [3] N, world   @param point [3] m, world
    @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE (the sum would overflow); BUSY; REENTRANT"""
    ...
def carom_body_set_drag(world: Any, body: Any, linear: Any, quadratic: Any, error: Any) -> int:
    """How air resists a body: F = -(linear + quadratic |u|) u at its centre, u its velocity relative to the air. Without
    other forces speeds follow the closed form at any step. (carom_body_desc.linear_damping is relative to the world,
    not to the air, and to mass.)
    @param linear    kg/s, [0, 1e12]: slow, small bodies (6 pi eta r of a ball); 0 when a body is created
    @param quadratic kg/m, [0, 1e12]: fast, large ones, rho c_d A / 2 (a ball of 0.1 m in air: 0.0087); 0 likewise
    @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT; OUT_OF_MEMORY"""
    ...
def carom_body_get_drag(world: Any, body: Any, linear: Any, quadratic: Any, error: Any) -> int:
    """@param linear, quadratic out   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY"""
    ...
def carom_world_set_wind(world: Any, velocity: Any, error: Any) -> int:
    """How the air moves; it reaches bodies through their drag alone.
    @param velocity [3] m/s, |each| <= 1e6; 0 when a world is created
    @status OK; NULL_ARGUMENT; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT"""
    ...
def carom_world_get_wind(world: Any, velocity: Any, error: Any) -> int:
    """@status OK; NULL_ARGUMENT; BUSY"""
    ...
def carom_force_field_name(kind: Any) -> bytes:
    """Static name of a kind of field ("uniform"), or "?".
    @param kind CAROM_FORCE_FIELD_*"""
    ...
def carom_force_field_desc_init(desc: Any, struct_size: Any) -> int:
    """@status OK; NULL_ARGUMENT; STRUCT_SIZE"""
    ...
def carom_force_field_create(world: Any, desc: Any, field: Any, error: Any) -> int:
    """@status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; UNKNOWN_ENUM; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; BUSY;
            REENTRANT; LIMIT; OUT_OF_MEMORY"""
    ...
def carom_force_field_update(world: Any, field: Any, desc: Any, error: Any) -> int:
    """Change a field in place: move it, turn it up.   @status as carom_force_field_create(); *_HANDLE"""
    ...
def carom_force_field_get(world: Any, field: Any, desc: Any, error: Any) -> int:
    """@status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; BUSY"""
    ...
def carom_force_field_destroy(world: Any, field: Any, error: Any) -> int:
    """@status OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT"""
    ...
def carom_body_set_force_field_mask(world: Any, body: Any, mask: Any, error: Any) -> int:
    """Which fields a body feels. A field with a bit that few bodies have costs those few.
    @param mask 1 when a body is created; 0: none
    @status OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT; OUT_OF_MEMORY"""
    ...
def carom_body_get_force_field_mask(world: Any, body: Any, mask: Any, error: Any) -> int:
    """@status OK; NULL_ARGUMENT; *_HANDLE; BUSY"""
    ...
def carom_spring_desc_init(desc: Any, struct_size: Any) -> int:
    """@status OK; NULL_ARGUMENT; STRUCT_SIZE"""
    ...
def carom_spring_create(world: Any, desc: Any, spring: Any, error: Any) -> int:
    """@status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT; LIMIT;
            OUT_OF_MEMORY"""
    ...
def carom_spring_update(world: Any, spring: Any, rest: Any, stiffness: Any, damping: Any, error: Any) -> int:
    """Change what a spring is like; its ends stay.
    @param rest m   @param stiffness N/m   @param damping N s/m; ranges as in carom_spring_desc
    @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT"""
    ...
def carom_spring_get(world: Any, spring: Any, desc: Any, error: Any) -> int:
    """@status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; BUSY"""
    ...
def carom_spring_get_state(world: Any, spring: Any, length: Any, force: Any, error: Any) -> int:
    """@param length out: m, as its ends stand   @param force out: N, above 0 it pulls them together, as it is set
    @status OK; NULL_ARGUMENT; *_HANDLE; BUSY"""
    ...
def carom_spring_destroy(world: Any, spring: Any, error: Any) -> int:
    """Goes with its bodies, too.   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT"""
    ...
def carom_water_init(water: Any, struct_size: Any) -> int:
    """@status OK; NULL_ARGUMENT; STRUCT_SIZE"""
    ...
def carom_world_set_water(world: Any, water: Any, error: Any) -> int:
    """@param water NULL: none, as a world is created
    @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; BUSY; REENTRANT"""
    ...
def carom_world_get_water(world: Any, water: Any, present: Any, error: Any) -> int:
    """@param water out   @param present out: 1 or 0; if 0, water is filled with defaults
    @status OK; NULL_ARGUMENT; STRUCT_SIZE; BUSY"""
    ...
def carom_joint_kind_name(kind: Any) -> bytes:
    """Static name of a kind of joint ("hinge", "six_axis"), or "?". Scene files and bindings have these names.
    @param kind CAROM_JOINT_*"""
    ...
def carom_joint_desc_init(desc: Any, struct_size: Any) -> int:
    """@status OK; NULL_ARGUMENT; STRUCT_SIZE"""
    ...
def carom_joint_limit_init(limit: Any, struct_size: Any) -> int:
    """Not enabled; a motor with speed 0 and max_force 0, which moves nothing until that is raised.
    @status OK; NULL_ARGUMENT; STRUCT_SIZE"""
    ...
def carom_joint_motor_init(motor: Any, struct_size: Any) -> int:
    """Not enabled; a motor with speed 0 and max_force 0, which moves nothing until that is raised.
    @status OK; NULL_ARGUMENT; STRUCT_SIZE"""
    ...
def carom_joint_spring_init(spring: Any, struct_size: Any) -> int:
    """Not enabled; a motor with speed 0 and max_force 0, which moves nothing until that is raised.
    @status OK; NULL_ARGUMENT; STRUCT_SIZE"""
    ...
def carom_joint_transmission_init(transmission: Any, struct_size: Any) -> int:
    """Ratio 1, anchors at the origin, the rope as long as it is.   @status OK; NULL_ARGUMENT; STRUCT_SIZE"""
    ...
def carom_joint_coupling_init(coupling: Any, struct_size: Any) -> int:
    """The follower goes as far as the leader.   @status OK; NULL_ARGUMENT; STRUCT_SIZE"""
    ...
def carom_joint_axis_init(axis: Any, struct_size: Any) -> int:
    """Free, without drive and spring, `max_force` and limits as large as may be.   @status OK; NULL_ARGUMENT; STRUCT_SIZE"""
    ...
def carom_joint_orientation_drive_init(drive: Any, struct_size: Any) -> int:
    """No drive, the target as the frames are when they agree.   @status OK; NULL_ARGUMENT; STRUCT_SIZE"""
    ...
def carom_joint_create(world: Any, desc: Any, joint: Any, error: Any) -> int:
    """Join two bodies, or one and the world. Their islands wake. A body that is destroyed takes its joints with it.
    @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED (a newer field; solver severity; a coupling, which
            carom_joint_couple() makes); UNKNOWN_ENUM; *_HANDLE; NOT_UNIT;
            NOT_FINITE; OUT_OF_RANGE (also: a body joined to itself, none that is dynamic, or places 1e15 m from a
            body's origin or 8e15 m from each other, as of bodies that the next step will quarantine); BUSY; REENTRANT;
            LIMIT; OUT_OF_MEMORY"""
    ...
def carom_joint_destroy(world: Any, joint: Any, error: Any) -> int:
    """@status OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT"""
    ...
def carom_joint_get(world: Any, joint: Any, desc: Any, error: Any) -> int:
    """@param desc out: as it was made, with frames in body coordinates
    @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; BUSY"""
    ...
def carom_joint_get_state(world: Any, joint: Any, state: Any, error: Any) -> int:
    """@status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; BUSY"""
    ...
def carom_joint_set_limit(world: Any, joint: Any, coordinate: Any, limit: Any, error: Any) -> int:
    """Set a limit, a motor, a spring of a coordinate that the joint's kind leaves free; its bodies wake.
    @param coordinate CAROM_COORDINATE_*
    @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; UNSUPPORTED (the kind has no such coordinate; a swing has a
            limit alone); *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT"""
    ...
def carom_joint_set_motor(world: Any, joint: Any, coordinate: Any, motor: Any, error: Any) -> int:
    """Set a limit, a motor, a spring of a coordinate that the joint's kind leaves free; its bodies wake.
    @param coordinate CAROM_COORDINATE_*
    @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; UNSUPPORTED (the kind has no such coordinate; a swing has a
            limit alone); *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT"""
    ...
def carom_joint_set_spring(world: Any, joint: Any, coordinate: Any, spring: Any, error: Any) -> int:
    """Set a limit, a motor, a spring of a coordinate that the joint's kind leaves free; its bodies wake.
    @param coordinate CAROM_COORDINATE_*
    @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; UNSUPPORTED (the kind has no such coordinate; a swing has a
            limit alone); *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT"""
    ...
def carom_joint_get_limit(world: Any, joint: Any, coordinate: Any, limit: Any, error: Any) -> int:
    """@status OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; UNSUPPORTED; *_HANDLE; BUSY"""
    ...
def carom_joint_get_motor(world: Any, joint: Any, coordinate: Any, motor: Any, error: Any) -> int:
    """@status OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; UNSUPPORTED; *_HANDLE; BUSY"""
    ...
def carom_joint_get_spring(world: Any, joint: Any, coordinate: Any, spring: Any, error: Any) -> int:
    """@status OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; UNSUPPORTED; *_HANDLE; BUSY"""
    ...
def carom_joint_set_transmission(world: Any, joint: Any, transmission: Any, error: Any) -> int:
    """Say what a pulley's rope runs over, or how a gear's wheels turn; the bodies wake. What a limit, motor or spring on a
    pulley's distance requires is in metres of the rope. A gear holds from where its wheels stand now, as often as they
    may turn: turns are counted while it steps, as long as a wheel's speed changes by less than half a turn a substep in
    one; a pose that the host sets between steps is no turn.
    Accuracy: second order in the substep, as all joints; the rope's length errs by what joint_frequency leaves, and
    under the direct solver by 1e-9 m; a gear's angles err by rounding, a few 1e-16 rad a substep. Oracle:
    tests/oracle/test_pulley_gear.
    @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED (the joint is neither pulley nor gear; a newer field); *_HANDLE;
            NOT_FINITE; OUT_OF_RANGE (also: a ratio of 0; 1 is what the init function gives); BUSY; REENTRANT"""
    ...
def carom_joint_get_transmission(world: Any, joint: Any, transmission: Any, error: Any) -> int:
    """@param transmission out: as it was set, with its length; ratio 0: not yet
    @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; *_HANDLE; BUSY"""
    ...
def carom_joint_couple(world: Any, coupling: Any, joint: Any, error: Any) -> int:
    """Couple two joints: makes a joint of kind CAROM_JOINT_COUPLING, whose bodies are one of each joint's. Their islands
    wake. It goes with either joint that is destroyed, and holds nothing once one of them is broken. What it is off by,
    as it is made or because a host moves joints, is led back. It has no frames and never breaks itself.
    carom_joint_state of it: `gap` or `angle` is how far the follower is off; force is 0, torque[0] the N or N m along the
    follower's coordinate that it pushes with, mean over the last step.
    Accuracy: as of locks: second order in the substep, 1e-9 m or rad under the direct solver, rounding where dial
    joint_order moves it. Oracle: tests/oracle/test_couplings.
    @param joint out: the coupling
    @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED (a joint that is neither hinge nor slider; a newer field; a
            reserved one; solver severity); *_HANDLE; NOT_FINITE; OUT_OF_RANGE (also: a joint that follows itself); BUSY;
            REENTRANT; LIMIT; OUT_OF_MEMORY"""
    ...
def carom_joint_set_coupling(world: Any, joint: Any, coupling: Any, error: Any) -> int:
    """Give a coupling another polynomial; its bodies wake.
    @param coupling its follower and leader are CAROM_NULL_HANDLE or as they were, its user is not read
    @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED (the joint is no coupling; other joints than its own; a newer
            field; a reserved one); *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT"""
    ...
def carom_joint_get_coupling(world: Any, joint: Any, coupling: Any, error: Any) -> int:
    """@param coupling out: as it was made
    @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; *_HANDLE; BUSY"""
    ...
def carom_joint_set_axis(world: Any, joint: Any, axis: Any, desc: Any, error: Any) -> int:
    """Say what one axis of a six-axis joint, a hinge or a slider does; the bodies wake. Effect joint_limits has its limits, joint_motors its
    drives; springs and locks are of the joint. A target, a lock's place or a limit may be set anew before each step.
    Accuracy: what is locked errs in second order of the substep h, under the direct solver by 1e-9 m or rad. With w the
    frequency and b half the damping per mass: springs, stops and drives to a position swing late by w h / 2 of their
    amplitude and fade slower by b h of their rate; at rest they sag by load / stiffness, to rounding where one joint
    bears all, in first order where soft_step sweeps over several. A drive to a velocity holds that of the middle of a
    substep under the direct solver, and one with a damping alone does under any: what a step ends with differs by what
    the load does in h / 2. Forces of drives are met to rounding. A speed limit holds to 1e-9 under the
    direct solver, where one joint bears all to rounding under others. Oracle: tests/oracle/test_six_axis, test_six_axis_scenes, test_armature,
    test_axis_limits.
    @param axis CAROM_AXIS_*
    @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; UNSUPPORTED (the joint has no such axis of its own; a newer field);
            *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT"""
    ...
def carom_joint_get_axis(world: Any, joint: Any, axis: Any, desc: Any, error: Any) -> int:
    """@param axis CAROM_AXIS_*   @param desc out: as it was set
    @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; UNSUPPORTED; *_HANDLE; BUSY"""
    ...
def carom_joint_set_orientation_drive(world: Any, joint: Any, drive: Any, error: Any) -> int:
    """Drive a ball, or a six-axis joint, to an orientation or to an angular velocity; the bodies wake. Of effect
    joint_motors. Accuracy: first order in the substep of where it is, as springs with dampers are; where nothing pulls
    it ends at the target to rounding. Oracle: tests/oracle/test_six_axis.
    @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNKNOWN_ENUM; UNSUPPORTED (the joint is neither ball nor six-axis; a newer
            field; a reserved one); *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; BUSY; REENTRANT"""
    ...
def carom_joint_get_orientation_drive(world: Any, joint: Any, drive: Any, error: Any) -> int:
    """@param drive out: as it was set
    @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; *_HANDLE; BUSY"""
    ...
def carom_joint_bulk_width(field: Any, width: Any) -> int:
    """How many scalars a record of a field has.
    @param field CAROM_JOINT_BULK_*   @param width out: of a record   @status OK; NULL_ARGUMENT; UNKNOWN_ENUM"""
    ...
def carom_world_read_joints(world: Any, field: Any, scalar: Any, joints: Any, n: Any, dst: Any, stride: Any, error: Any) -> int:
    """Read one field of n joints, as carom_world_read() does of bodies.
    A rate of what has no direction (points or axes that agree) is the one at which it begins to grow.
    Accuracy: rounding of poses and velocities; of a twist times 1 / cos(swing / 2). An effort errs in first order of the
    step, by how far the axis turned in it. Oracle: tests/abi/test_joint_bulk.
    @param field   CAROM_JOINT_BULK_*   @param scalar CAROM_SCALAR_*
    @param joints  [n], or NULL for all in the order of carom_world_get_joints() (n must be their number)
    @param dst     n records of the field's scalars, `stride` bytes apart; stride 0: tightly packed
    @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; *_HANDLE (nothing is written); UNSUPPORTED (a kind without the field);
    OUT_OF_RANGE (n); BUFFER_TOO_SMALL (stride); BUSY"""
    ...
def carom_world_write_joints(world: Any, field: Any, scalar: Any, joints: Any, n: Any, src: Any, stride: Any, error: Any) -> int:
    """Write one field of n joints; all values are validated before the first is written, joints of a tree are moved as one.
    Accuracy of places: rounding of poses, to 1e-15 of a chain's length a joint. Oracle: tests/oracle/test_joint_moves. Modes, units of gains and what is
    enabled stay as they are, where the record does not have them. Bodies of joints that this changes wake. Arguments as carom_world_read_joints().
    @param src n records of the field's scalars, `stride` bytes apart; stride 0: tightly packed
    @status as carom_world_read_joints(); UNSUPPORTED (also: a field that is read only; a joint of a loop, a broken one,
    one between bodies that forces do not move); NOT_FINITE; NOT_UNIT;
    OUT_OF_RANGE; REENTRANT"""
    ...
def carom_world_get_joints(world: Any, joints: Any, capacity: Any, count: Any, error: Any) -> int:
    """Number of joints, and their handles in creation order of the slots.
    @param joints [capacity] or NULL   @param count out: how many there are
    @status OK; NULL_ARGUMENT; BUSY"""
    ...
def carom_world_enable_ledger(world: Any, on: Any, error: Any) -> int:
    """Keep a ledger from now on, anew if one is kept; or none. Off in a new world.
    @param on  0 or 1
    @status OK; NULL_ARGUMENT; UNKNOWN_ENUM (on); BUSY; REENTRANT; OUT_OF_MEMORY: as it was"""
    ...
def carom_world_get_ledger(world: Any, dst: Any, stride: Any, capacity: Any, count: Any, error: Any) -> int:
    """Copy out all causes, in the order above; none of a world that keeps no ledger.
    @param dst      [capacity] elements `stride` bytes apart; may be NULL if capacity is 0
    @param stride   sizeof(carom_ledger_entry) as the caller knows it
    @param count    out: how many there are (may exceed capacity; capacity are written)
    @status OK; NULL_ARGUMENT; BUFFER_TOO_SMALL; OUT_OF_RANGE (stride); BUSY"""
    ...
def carom_world_get_ledger_state(world: Any, state: Any, error: Any) -> int:
    """@status OK; NULL_ARGUMENT; STRUCT_SIZE; BUSY"""
    ...
def carom_pairs_distance(engine: Any, pairs: Any, desc: Any, dst: Any, stride: Any, error: Any) -> int:
    """Signed distance of each pair, on the engine's threads (carom_engine_set_jobs()). Each result has the bits that
    carom_shape_distance() gives for its pair, for any number of threads. All pairs are checked before the first result
    is written, and a message names the pair that is wrong. A pair whose support function misbehaves says so in its
    status (CAROM_QUERY_FAULT), and spoils no other. Nothing is allocated per pair.
    @param desc   may be NULL: defaults
    @param dst    out, [pairs->count]; no array of pairs
    @param stride sizeof(carom_distance) as the caller knows it; an older, shorter one gets its beginning. struct_size is
                  written, too
    @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; UNKNOWN_ENUM; UNSUPPORTED (a
            pair of half-spaces or sceneries); BUFFER_TOO_SMALL (a stride); OUT_OF_MEMORY; INTERNAL (a callback left its
            thread: some results were written)
    @since 0.9"""
    ...
def carom_device_create(engine: Any, index: Any, device: Any, error: Any) -> int:
    """Open a device. Its arithmetic is tried, and it is refused where a number is rounded otherwise than on the host.
    @param index  among all devices of all platforms, in the order in which the system has them; 0 is the first
    @param device out: to be destroyed before the engine   @owns the caller: carom_device_destroy()
    @status OK; NULL_ARGUMENT; NOT_FOUND (no OpenCL, or no such device: the message says how many there are); UNSUPPORTED
            (it has no double precision, or rounds otherwise); OUT_OF_MEMORY
    @since 0.9"""
    ...
def carom_device_destroy(device: Any, error: Any) -> int:
    """@param device from carom_device_create()   @status OK; NULL_ARGUMENT; BUSY; REENTRANT   @since 0.9"""
    ...
def carom_device_get_info(device: Any, info: Any, error: Any) -> int:
    """@param device from carom_device_create()   @status OK; NULL_ARGUMENT; STRUCT_SIZE; BUSY   @since 0.9"""
    ...
def carom_device_pairs_distance(device: Any, pairs: Any, desc: Any, dst: Any, stride: Any, error: Any) -> int:
    """As carom_pairs_distance(), on a device: each result has the same bits. Shapes are of the device's engine.
    @param device from carom_device_create()
    @param desc   may be NULL: defaults
    @param dst    out, [pairs->count]; no array of pairs
    @param stride as carom_pairs_distance()
    @status as carom_pairs_distance(); UNSUPPORTED (a shape that a device cannot ask; CAROM_SIMPLEX_JOHNSON and routines of
            pairs, which devices have not; a driver that failed: some results may be written); BUSY; REENTRANT
    @since 0.9"""
    ...
def carom_particles_desc_init(desc: Any, struct_size: Any) -> int:
    """@status OK; NULL_ARGUMENT; STRUCT_SIZE"""
    ...
def carom_particles_create(world: Any, desc: Any, set: Any, error: Any) -> int:
    """Make an empty set.
    @param desc may be NULL: defaults
    @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT; LIMIT; OUT_OF_MEMORY"""
    ...
def carom_particles_destroy(world: Any, set: Any, error: Any) -> int:
    """Its particles too.   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY; REENTRANT"""
    ...
def carom_particles_get(world: Any, set: Any, desc: Any, error: Any) -> int:
    """@param desc out: as it was made or updated; capacity: particles there is memory for
    @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; BUSY"""
    ...
def carom_particles_update(world: Any, set: Any, desc: Any, error: Any) -> int:
    """Change what they have in common; particles that are there keep their mass.
    @param desc may be NULL: defaults; capacity: memory for so many in all
    @status as carom_particles_create(); *_HANDLE"""
    ...
def carom_particles_get_count(world: Any, set: Any, count: Any, error: Any) -> int:
    """@param count out: particles in the set   @status OK; NULL_ARGUMENT; *_HANDLE; BUSY"""
    ...
def carom_particles_add(world: Any, set: Any, n: Any, scalar: Any, positions: Any, position_stride: Any, velocities: Any, velocity_stride: Any, error: Any) -> int:
    """Add n particles at the end; all values are checked before the first is added.
    @param scalar          CAROM_SCALAR_*, of both arrays
    @param positions       [n] m, world, three scalars each, within 1e15 m of the origin
    @param position_stride bytes from one to the next; 0: tightly packed
    @param velocities      [n] m/s, world, likewise, at most 1e9 m/s; NULL: at rest
    @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; *_HANDLE; NOT_FINITE; OUT_OF_RANGE; BUFFER_TOO_SMALL (stride); LIMIT (2^31
            - 1 in a set); BUSY; REENTRANT; OUT_OF_MEMORY"""
    ...
def carom_particles_remove(world: Any, set: Any, indices: Any, n: Any, error: Any) -> int:
    """Remove n particles. The others keep their order, so each moves up by as many as went before it.
    @param indices [n] ascending, each once; NULL: all of them (n must be their number)
    @status OK; NULL_ARGUMENT; *_HANDLE; OUT_OF_RANGE (an index, their order, n); BUSY; REENTRANT"""
    ...
def carom_particles_read(world: Any, set: Any, field: Any, scalar: Any, indices: Any, n: Any, dst: Any, stride: Any, error: Any) -> int:
    """Read one field of n particles.
    @param field   CAROM_FIELD_POSITION, LINEAR_VELOCITY or MASS
    @param indices [n] in any order, or NULL: all of them (n must be their number)
    @param dst     n records of the field's scalars, `stride` bytes apart
    @param stride  bytes from one record to the next; 0: tightly packed
    @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; UNSUPPORTED (a field that particles do not have); *_HANDLE; OUT_OF_RANGE
            (an index, n); BUFFER_TOO_SMALL (stride); BUSY"""
    ...
def carom_particles_write(world: Any, set: Any, field: Any, scalar: Any, indices: Any, n: Any, src: Any, stride: Any, error: Any) -> int:
    """Write one field of n particles; all values are checked before the first is written, bounds as carom_particles_add(),
    masses as carom_particles_desc. Arguments as carom_particles_read(); where an index comes twice, the last counts.
    @param src n records of the field's scalars, `stride` bytes apart
    @status as carom_particles_read(); NOT_FINITE; OUT_OF_RANGE; REENTRANT; OUT_OF_MEMORY"""
    ...
def carom_particles_get_quarantined(world: Any, set: Any, indices: Any, capacity: Any, count: Any, error: Any) -> int:
    """A particle that has come further than 1e15 m or become faster than 1e9 m/s is put in quarantine: it is held still
    where it is and counts in no energy, until a host writes its position or removes it. carom_world_get_faults()
    reports the first of each set and step (CAROM_FAULT_PARTICLE_STATE), this call all that are held now, ascending.
    @param indices [capacity] out; may be NULL if capacity is 0
    @param count   out: how many there are (may exceed capacity; capacity are written)
    @status OK; NULL_ARGUMENT; *_HANDLE; BUSY"""
    ...
def carom_world_get_particles(world: Any, sets: Any, capacity: Any, count: Any, error: Any) -> int:
    """Number of sets, and their handles in creation order of the slots.
    @param sets [capacity] or NULL   @param count out: how many there are
    @status OK; NULL_ARGUMENT; BUSY"""
    ...
def carom_effect_name(effect: Any) -> bytes:
    """Static name of an effect ("gravity"), or "?"."""
    ...
def carom_world_set_effect(world: Any, effect: Any, mode: Any, error: Any) -> int:
    """Forbid or force an effect from the next step on, for all bodies. Wakes all bodies. Forbidding one that the scene
    needs is allowed, and carom_world_get_plan() says so.
    @param effect CAROM_EFFECT_*   @param mode CAROM_MODE_*
    @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; BUSY; REENTRANT"""
    ...
def carom_world_get_effect(world: Any, effect: Any, mode: Any, error: Any) -> int:
    """@param mode out   @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; BUSY"""
    ...
def carom_body_set_effect(world: Any, body: Any, effect: Any, mode: Any, error: Any) -> int:
    """The same for one body: its forces, its colliders, the contacts, joints and springs it is in. What is forbidden for
    the world is forbidden for it. Particles, events and the ledger are not a body's.
    @param mode CAROM_MODE_*
    @status OK; NULL_ARGUMENT; *_HANDLE; UNKNOWN_ENUM; UNSUPPORTED (PARTICLES, EVENTS, LEDGER: use
            carom_world_set_effect()); BUSY; REENTRANT; OUT_OF_MEMORY"""
    ...
def carom_body_get_effect(world: Any, body: Any, effect: Any, mode: Any, error: Any) -> int:
    """@param mode out: of the body itself   @status OK; NULL_ARGUMENT; *_HANDLE; UNKNOWN_ENUM; BUSY"""
    ...
def carom_world_time_effects(world: Any, on: Any, error: Any) -> int:
    """Whether each force effect is timed by itself in carom_world_get_plan(), which costs two looks at the clock for each.
    @param on 1 or 0 (as a world is created)
    @status OK; NULL_ARGUMENT; OUT_OF_RANGE; BUSY; REENTRANT"""
    ...
def carom_world_get_plan(world: Any, dst: Any, stride: Any, capacity: Any, count: Any, error: Any) -> int:
    """Copy out the plan of the last step: stages first, then effects. Before the first step nothing has run.
    @param dst      [capacity] elements `stride` bytes apart; may be NULL if capacity is 0
    @param stride   sizeof(carom_plan_line) as the caller knows it
    @param count    out: how many there are (may exceed capacity; capacity are written)
    @status OK; NULL_ARGUMENT; BUFFER_TOO_SMALL; OUT_OF_RANGE (stride); BUSY"""
    ...
def carom_distance_desc_init(desc: Any, struct_size: Any) -> int:
    """@status OK; NULL_ARGUMENT; STRUCT_SIZE"""
    ...
def carom_shape_distance(engine: Any, shape_a: Any, position_a: Any, orientation_a: Any, shape_b: Any, position_b: Any, orientation_b: Any, desc: Any, result: Any, error: Any) -> int:
    """Signed distance of two shapes.
    @param position_*     [3] m     @param orientation_* [4] x, y, z, w
    @param desc   may be NULL: defaults     @param result struct_size set by the caller
    @status OK; NULL_ARGUMENT; STRUCT_SIZE; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; UNKNOWN_ENUM;
            UNSUPPORTED (two half-spaces)"""
    ...
def carom_world_record_begin(world: Any, flags: Any, write: Any, user: Any, error: Any) -> int:
    """Record a world from now on, until carom_world_record_end() or until it is destroyed.
    @param flags CAROM_RECORD_*   @param write is kept, and called with `user`
    @status OK; NULL_ARGUMENT; UNSUPPORTED (flags); IN_USE (it is being recorded); WRITE_FAILED; BUSY; REENTRANT;
            OUT_OF_MEMORY"""
    ...
def carom_world_record_end(world: Any, error: Any) -> int:
    """Stop recording.
    @status OK; NULL_ARGUMENT; NOT_FOUND (it is not being recorded); WRITE_FAILED (`write` said so, now or before: the
            recording ends there); OUT_OF_MEMORY (likewise, for lack of memory); BUSY; REENTRANT"""
    ...
def carom_world_compare(world: Any, bytes: Any, size: Any, difference: Any, error: Any) -> int:
    """Compare a world with a snapshot, between steps; of a world of the same structure. Reads only.
    @param difference its struct_size set by the caller
    @param bytes [size] of carom_world_save()   @param size number of bytes
    @status OK; NULL_ARGUMENT; STRUCT_SIZE; CORRUPT, UNSUPPORTED, MISMATCH (as carom_world_restore()); BUSY; REENTRANT;
            OUT_OF_MEMORY   @thread reader"""
    ...
def carom_world_get_residuals(world: Any, residuals: Any, error: Any) -> int:
    """@param residuals with its struct_size set; filled. Before the first step, and after a step without contacts, what
                     concerns them is 0.
    @status OK; NULL_ARGUMENT; STRUCT_SIZE; BUSY
    @accuracy rounding; effective masses are those along the normal
    @cost linear in contact points, joints and bodies"""
    ...
def carom_world_set_budget(world: Any, seconds: Any, fewest: Any, most: Any, error: Any) -> int:
    """Choose the dial `substeps` before each step so that steps take about `seconds`. What a substep costs is learnt from
    the last steps; if one took too long, substeps drop at once; if there is time left, one is added a step.
    Trajectories then depend on the machine's speed: two runs are not the same to the bit. Off (as a world is created)
    for lockstep and tests. The steps of a scene that is too expensive even with `fewest` take longer. A budget is the
    host's: no snapshot holds it, a copy begins without one, and a record (carom/record.h) has the substeps that it
    chose.
    @param seconds  s of wall clock a step, 0 < seconds <= 10; 0: off, the dial keeps its value
    @param fewest, most  substeps, 1 <= fewest <= most <= the dial's bound; ignored when off
    @status OK; NULL_ARGUMENT; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT; OUT_OF_MEMORY"""
    ...
def carom_world_get_budget(world: Any, seconds: Any, fewest: Any, most: Any, error: Any) -> int:
    """@param seconds, fewest, most  out: as set; 0 when off   @status OK; NULL_ARGUMENT; BUSY"""
    ...
def carom_mesh_desc_init(desc: Any, struct_size: Any) -> int:
    """@status OK; NULL_ARGUMENT; STRUCT_SIZE"""
    ...
def carom_shape_create_mesh(engine: Any, desc: Any, shape: Any, error: Any) -> int:
    """Make scenery of a mesh. All is copied.
    @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; NOT_FINITE; OUT_OF_RANGE (a count, an index, a vertex too far
            out, no triangle that has an area); LIMIT; OUT_OF_MEMORY"""
    ...
def carom_height_field_desc_init(desc: Any, struct_size: Any) -> int:
    """@status OK; NULL_ARGUMENT; STRUCT_SIZE"""
    ...
def carom_shape_create_height_field(engine: Any, desc: Any, shape: Any, error: Any) -> int:
    """Make scenery of a height field. All is copied.
    @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; NOT_FINITE (an infinite height, a spacing); OUT_OF_RANGE (a
            count, a spacing that is not positive, a height too far out, nothing but holes); LIMIT; OUT_OF_MEMORY"""
    ...
def carom_shape_get_scenery_info(engine: Any, shape: Any, info: Any, error: Any) -> int:
    """@status OK; NULL_ARGUMENT; STRUCT_SIZE (set info->struct_size); *_HANDLE; UNSUPPORTED (a convex shape)"""
    ...
def carom_shape_get_triangles(engine: Any, shape: Any, first: Any, corners: Any, count: Any, next: Any, error: Any) -> int:
    """Copy out triangles of scenery, for drawing: each by its three corners, as its surface faces. Holes are left out.
    @param first   number of the first triangle wanted
    @param corners [9 count] m, shape frame, or NULL to count
    @param count   in: how many fit; out: how many were written (with NULL: how many there are from `first` on)
    @param next    out: the number of the triangle to go on from; the number of triangles when all have been seen
    @status OK; NULL_ARGUMENT; *_HANDLE; OUT_OF_RANGE (first); UNSUPPORTED (a convex shape)"""
    ...
def carom_shape_create(engine: Any, plugin: Any, params: Any, count: Any, shape: Any, error: Any) -> int:
    """Make a shape. The parameters are copied. The support function is checked for these parameters (finite, repeatable,
    scale-free, samples in convex position), declarations are verified, and AABB and mass properties derived.
    @param params [count] doubles, meaning as the plugin documents
    @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE (count or a bound; argument says which);
            PLUGIN_INVALID; DECLARATION_FALSE; OUT_OF_MEMORY"""
    ...
def carom_shape_create_named(engine: Any, name: Any, params: Any, count: Any, shape: Any, error: Any) -> int:
    """Make a shape by the name of its plugin: "box", or "carom.box", or the id of a plugin of yours. Plugins that the
    engine has come first, by id, then by the name of the file they were loaded from. Then a file NAME.so is looked for
    and loaded: in the folders of $CAROM_PLUGIN_PATH (absolute, separated by ':'; not in programs that run with raised
    privileges), beside the library, in the folder where plugins are installed. "half_space" is built in: normal x, y,
    z, offset.
    @param name 1 to 64 letters, digits, _, - and dots   @param params [count] as carom_shape_create()
    @status OK; NULL_ARGUMENT; NOT_FOUND (the message says where it was looked for); NOT_FINITE; OUT_OF_RANGE;
            PLUGIN_PATH; PLUGIN_LOAD; PLUGIN_ABI; PLUGIN_INVALID; DECLARATION_FALSE; LIMIT; OUT_OF_MEMORY"""
    ...
def carom_shape_create_half_space(engine: Any, normal: Any, offset: Any, shape: Any, error: Any) -> int:
    """The built-in half-space { x : normal . x <= offset } in the shape's own frame; unbounded, so static bodies only.
    @param normal [3] unit (within 1e-6)   @param offset m
    @status OK; NULL_ARGUMENT; NOT_FINITE; NOT_UNIT; OUT_OF_MEMORY"""
    ...
def carom_shape_create_hull_of(engine: Any, parts: Any, count: Any, positions: Any, orientations: Any, scales: Any, radius: Any, shape: Any, error: Any) -> int:
    """Make the convex hull of shapes that the engine has, each placed and scaled, and all of it rounded by a radius. The
    same call makes
    - the sweep of a shape along a straight line, without turning: the shape at both ends. Where it turns as well, the hull
      of both ends leaves out what bulges between them: add poses in between;
    - a scaled shape: one part with a scale. A negative scale mirrors it;
    - a rounded shape: one part and a radius, by which it grows on all sides.
    Where all parts have corners only and the radius is 0, the hull is a polytope with exact mass and faces, and its
    corners are its parameters. Else its parameters are none and its mass is derived. A part cannot be destroyed before
    the hull.
    @param parts         [count] handles of convex shapes, the same one as often as wanted
    @param count         1 to 4096
    @param positions     [3 * count] m, frame of the hull; NULL: 0
    @param orientations  [4 * count] x, y, z, w, unit within 1e-6, part to hull; NULL: identity
    @param scales        [3 * count] along the axes of the part, of a size of 1e-6 to 1e6; NULL: 1
    @param radius        m, 0 or more
    @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; NOT_UNIT; OUT_OF_RANGE; UNSUPPORTED (a part is a half-space or scenery);
            PLUGIN_INVALID; LIMIT (hulls of hulls more than 8 deep, or of more than 4096 parts in all); OUT_OF_MEMORY
    @since 0.9"""
    ...
def carom_shape_get_parts(engine: Any, shape: Any, parts: Any, positions: Any, orientations: Any, scales: Any, count: Any, radius: Any, error: Any) -> int:
    """What a hull of shapes is made of, as it was given. Of any other shape: no parts, radius 0.
    @param parts         [*count] or NULL: only count and radius are written
    @param positions     [3 * *count] m, or NULL   @param orientations [4 * *count] x, y, z, w, or NULL
    @param scales        [3 * *count] or NULL
    @param count         in: capacity in parts; out: number of parts
    @param radius        m, or NULL
    @status OK; NULL_ARGUMENT; *_HANDLE; BUFFER_TOO_SMALL (count says how many are needed)
    @since 0.9"""
    ...
def carom_shape_destroy(engine: Any, shape: Any, error: Any) -> int:
    """@status OK; NULL_ARGUMENT; *_HANDLE; IN_USE (a collider, a hull of shapes, or a query on another thread, refers to
            it); REENTRANT"""
    ...
def carom_shape_get_info(engine: Any, shape: Any, info: Any, error: Any) -> int:
    """@status OK; NULL_ARGUMENT; STRUCT_SIZE (set info->struct_size); *_HANDLE"""
    ...
def carom_shape_get_params(engine: Any, shape: Any, params: Any, count: Any, error: Any) -> int:
    """Copy out the parameters. @param count in: capacity of params; out: number of parameters.
    @param params [count]
    @status OK; NULL_ARGUMENT; *_HANDLE; BUFFER_TOO_SMALL (count says how many are needed)"""
    ...
def carom_shape_support(engine: Any, shape: Any, dirs: Any, n: Any, points: Any, error: Any) -> int:
    """Support points of the whole shape, core radius included, for n directions at once.
    @param dirs [3n] nonzero, any length, shape frame   @param points [3n] m, shape frame
    @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE; OUT_OF_RANGE (a zero direction); UNSUPPORTED (half-space,
            scenery); PLUGIN_INVALID (the support function failed; the points before are written)"""
    ...
def carom_world_save(world: Any, flags: Any, buffer: Any, capacity: Any, needed: Any, error: Any) -> int:
    """Write a snapshot, between steps. Reads only: other readers may be at work.
    @param flags    CAROM_SNAPSHOT_*
    @param buffer   [capacity] bytes, or NULL to get the size alone
    @param capacity bytes; 0 if buffer is NULL
    @param needed   out: bytes of the snapshot; written, too, when the buffer is too small (nothing else is)
    @status OK; NULL_ARGUMENT; UNSUPPORTED (flags); BUFFER_TOO_SMALL; BUSY; REENTRANT; OUT_OF_MEMORY   @thread reader"""
    ...
def carom_world_restore(world: Any, bytes: Any, size: Any, error: Any) -> int:
    """Put a snapshot back, between steps. All of it is read and checked, and all memory that it takes is there, before
    anything of the world changes.
    An empty world is rebuilt from a snapshot that is whole; `user` values come with it, a ledger
    begins anew. Shapes of the same plugin and numbers that the engine has are used, others made; they are the engine's,
    as if the host had made them (carom_collider_get() gives their handles). Any other world takes its state, as of one
    that is not whole.
    @param bytes [size], of any alignment   @param size as carom_world_save() gave it
    @status OK; NULL_ARGUMENT; CORRUPT (damaged, cut off, or no snapshot: the message says what); UNSUPPORTED (of a
    newer
            format); MISMATCH (of a world of another structure: the message names the kind that differs; or a plugin of
            that id and version makes other shapes than it did); NOT_FOUND (a shape plugin is not loaded: the message
            says id and version); LIMIT; BUSY; REENTRANT; OUT_OF_MEMORY"""
    ...
def carom_world_fork(world: Any, copy: Any, error: Any) -> int:
    """Make a world of the same engine that is as this one is, and goes on as it does, bit for bit. Nothing of this one
    changes; other readers may be at work. Lists and residuals of its last step, and a ledger, the copy has none of.
    @param copy out: to be destroyed as any world
    @status OK; NULL_ARGUMENT; LIMIT; BUSY; REENTRANT; OUT_OF_MEMORY   @thread reader"""
    ...
def carom_world_translate_handles(world: Any, handles: Any, n: Any, translated: Any, error: Any) -> int:
    """Handles of another world, as they are in this one: the same slots and generations. For what a host keeps of a world
    that it has forked, or of one that was saved whole, in another process too.
    @param handles    [n] of bodies, colliders, materials, joints, particles, fields, springs; 0 stays 0
    @param translated [n] out; may be `handles`. All of them or, where one is refused, none
    @status OK; NULL_ARGUMENT; INVALID_HANDLE; STALE_HANDLE; WRONG_KIND (of an engine: shapes are the same in all its
            worlds); BUSY; REENTRANT   @thread reader"""
    ...
def carom_tree_get_coordinates(world: Any, body: Any, dst: Any, stride: Any, capacity: Any, count: Any, error: Any) -> int:
    """Copy out what the coordinates of a tree are.
    @param body     any dynamic body of the tree; its base, where nothing holds the tree
    @param dst      [capacity] elements `stride` bytes apart; may be NULL if capacity is 0
    @param stride   sizeof(carom_tree_coordinate) as the caller knows it
    @param count    out: how many there are (may exceed capacity; capacity are written)
    @status OK; NULL_ARGUMENT; *_HANDLE; OUT_OF_RANGE (the body is not moved by forces); UNSUPPORTED (no tree);
            BUFFER_TOO_SMALL (stride); BUSY; OUT_OF_MEMORY"""
    ...
def carom_tree_get_speeds(world: Any, body: Any, speeds: Any, n: Any, error: Any) -> int:
    """The speeds that a tree has now.
    Accuracy: rounding of the bodies' velocities. What joints do not leave free of these counts as nothing.
    @param speeds out, [n]   @param n how many coordinates there are
    @status OK; NULL_ARGUMENT; *_HANDLE; OUT_OF_RANGE (n; the body is not moved by forces); UNSUPPORTED (no tree); BUSY;
            OUT_OF_MEMORY"""
    ...
def carom_tree_get_forces(world: Any, body: Any, speeds: Any, accelerations: Any, forces: Any, n: Any, error: Any) -> int:
    """Inverse dynamics: the forces that give a tree these accelerations, at the present pose.
        forces = M accelerations + what gyroscopic and centrifugal terms and gravity ask
    With speeds of 0 and no accelerations these hold the tree against gravity.
    Accuracy: 1e-14 of the largest term, for chains of tens of bodies. Oracle: tests/oracle/test_joint_tree.
    @param speeds        [n] m/s and rad/s, or NULL: those of now
    @param accelerations [n] m/s^2 and rad/s^2, rates of the speeds, or NULL: 0
    @param forces        out, [n] N and N m
    @param n             how many coordinates there are
    @status OK; NULL_ARGUMENT; *_HANDLE; NOT_FINITE (also: forces that are beyond what numbers hold);
            OUT_OF_RANGE (n; the body is not moved by forces); UNSUPPORTED (no tree); BUSY; OUT_OF_MEMORY"""
    ...
def carom_tree_get_mass(world: Any, body: Any, mass: Any, n: Any, error: Any) -> int:
    """The mass matrix of a tree at the present pose, symmetric and positive definite: with speeds v its energy of motion
    is v^T M v / 2. Where two axes of one joint agree M is singular.
    Accuracy: 1e-14 of the largest entry that a sum has, for chains of tens of bodies. Oracle: tests/oracle/test_joint_tree.
    @param mass out, [n n] row by row: kg, kg m and kg m^2   @param n how many coordinates there are
    @status OK; NULL_ARGUMENT; *_HANDLE; OUT_OF_RANGE (n; the body is not moved by forces); UNSUPPORTED (no tree);
            NOT_FINITE (bodies too far apart or too heavy for numbers); BUSY; OUT_OF_MEMORY"""
    ...
def carom_vehicle_desc_init(desc: Any, struct_size: Any) -> int:
    """@status OK; NULL_ARGUMENT; STRUCT_SIZE"""
    ...
def carom_wheel_desc_init(desc: Any, struct_size: Any) -> int:
    """@status OK; NULL_ARGUMENT; STRUCT_SIZE"""
    ...
def carom_vehicle_input_init(input: Any, struct_size: Any) -> int:
    """@status OK; NULL_ARGUMENT; STRUCT_SIZE"""
    ...
def carom_vehicle_init(vehicle: Any, struct_size: Any) -> int:
    """At idle speed, at rest.   @status OK; NULL_ARGUMENT; STRUCT_SIZE"""
    ...
def carom_wheel_init(wheel: Any, struct_size: Any) -> int:
    """In the air, at rest.   @status OK; NULL_ARGUMENT; STRUCT_SIZE"""
    ...
def carom_vehicle_drive(world: Any, desc: Any, wheel_descs: Any, n: Any, input: Any, vehicle: Any, wheels: Any, dt: Any, error: Any) -> int:
    """Look down, turn wheels and engine through dt, and leave the mean forces for the next step, which is to take dt. They
    add to forces that are pending. They keep a vehicle awake.
    @param desc with a chassis
    @param wheel_descs [n] one after another, each of the first one's struct_size
    @param n 1 to CAROM_VEHICLE_WHEELS
    @param input what the driver does
    @param vehicle state, changes
    @param wheels [n] states, change: as wheel_descs
    @param dt s, [1e-4, 0.1]
    @accuracy of the prediction first order in 1 ms; it leaves out what else acts on the chassis but gravity and
              pending forces. A chassis that swings on its springs faster than a third of 1 / dt trembles. Of springs
              stiffer than (m / 4) / 1 ms^2, m what the chassis weighs at the wheel, so much acts
    @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED (unknown bits; a half-space or scenery as shape); *_HANDLE;
            NOT_FINITE; NOT_UNIT; OUT_OF_RANGE (also: a chassis that is not dynamic, a gear that it has not); BUSY;
            REENTRANT; OUT_OF_MEMORY"""
    ...
def carom_world_desc_init(desc: Any, struct_size: Any) -> int:
    """@status OK; NULL_ARGUMENT; STRUCT_SIZE"""
    ...
def carom_world_create(engine: Any, desc: Any, world: Any, error: Any) -> int:
    """@param desc may be NULL: defaults   @owns the caller: carom_world_destroy(), before the engine
    @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; NOT_FINITE; OUT_OF_RANGE; LIMIT (65,535 engines and worlds in
            all); OUT_OF_MEMORY   @thread engine"""
    ...
def carom_world_destroy(world: Any, error: Any) -> int:
    """Destroys its bodies, colliders, materials and particles too.   @status OK; NULL_ARGUMENT; BUSY; REENTRANT"""
    ...
def carom_world_step(world: Any, dt: Any, error: Any) -> int:
    """Advance by dt.
    @param dt s, in [1e-9, 1]
    @status OK; NULL_ARGUMENT; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT; OUT_OF_MEMORY
    Out of memory: no body has moved and forces are still pending; contact caches may have been dropped.
    A plugin that misbehaves does not fail the step: its pairs are skipped and carom_world_get_faults() reports it."""
    ...
def carom_world_set_dial(world: Any, dial: Any, value: Any, error: Any) -> int:
    """@param value within the dial's bounds; whole for choices and integers
    @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT"""
    ...
def carom_world_get_dial(world: Any, dial: Any, value: Any, error: Any) -> int:
    """@param value as carom_world_set_dial() takes it   @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; BUSY"""
    ...
def carom_world_set_preset(world: Any, preset: Any, error: Any) -> int:
    """Set all dials that presets speak of, from the next step on; see carom_preset_get_dial(). Later calls of
    carom_world_set_dial() change them one by one.   @param preset CAROM_PRESET_*
    @status OK; NULL_ARGUMENT; UNKNOWN_ENUM; BUSY; REENTRANT"""
    ...
def carom_world_set_gravity(world: Any, gravity: Any, error: Any) -> int:
    """@param gravity [3] m/s^2, |each| <= 1e6   @status OK; NULL_ARGUMENT; NOT_FINITE; OUT_OF_RANGE; BUSY; REENTRANT"""
    ...
def carom_world_get_gravity(world: Any, gravity: Any, error: Any) -> int:
    """@status OK; NULL_ARGUMENT; BUSY"""
    ...
def carom_world_get_report(world: Any, report: Any, error: Any) -> int:
    """@status OK; NULL_ARGUMENT; STRUCT_SIZE; BUSY"""
    ...
def carom_stage_name(stage: Any) -> bytes:
    """Static name of a stage ("broad"), or "?".
    @param stage CAROM_STAGE_*"""
    ...
def carom_world_get_contacts(world: Any, dst: Any, stride: Any, capacity: Any, count: Any, error: Any) -> int:
    """Copy out the contact points of the last step, in a deterministic order; those of colliders destroyed since are gone.
    @param dst      [capacity] elements `stride` bytes apart; may be NULL if capacity is 0
    @param stride   sizeof(carom_contact) as the caller knows it
    @param count    out: how many there are (may exceed capacity; capacity are written)
    @status OK; NULL_ARGUMENT; BUFFER_TOO_SMALL; OUT_OF_RANGE (stride); BUSY"""
    ...
def carom_world_get_groups(world: Any, dst: Any, stride: Any, capacity: Any, count: Any, error: Any) -> int:
    """Copy out the contact groups of the last step, in a deterministic order. Other solvers than CAROM_SOLVER_AUTO treat
    all groups alike: then there are none.
    @param dst      [capacity] elements `stride` bytes apart; may be NULL if capacity is 0
    @param stride   sizeof(carom_group) as the caller knows it
    @param count    out: how many there are (may exceed capacity; capacity are written)
    @status OK; NULL_ARGUMENT; BUFFER_TOO_SMALL; OUT_OF_RANGE (stride); BUSY"""
    ...
def carom_world_get_faults(world: Any, dst: Any, stride: Any, capacity: Any, count: Any, error: Any) -> int:
    """Copy out the faults of the last step; arguments as carom_world_get_contacts()."""
    ...
def carom_world_hash(world: Any, hash: Any, error: Any) -> int:
    """64-bit hash of the dynamic state: equal iff (up to collision of the hash) every pose, velocity and cached contact
    has the same bits, and every particle's position and velocity.
    @param hash of the state
    @status OK; NULL_ARGUMENT; BUSY   @thread reader"""
    ...
def carom_query_desc_init(desc: Any, struct_size: Any) -> int:
    """@status OK; NULL_ARGUMENT; STRUCT_SIZE"""
    ...
def carom_world_cast_ray(world: Any, origin: Any, direction: Any, max: Any, desc: Any, hit: Any, size: Any, error: Any) -> int:
    """What one ray meets first: origin + t direction, 0 <= t <= max.
    @param origin [3] m   @param direction [3] m per unit of t, any length   @param max >= 0, may be infinite
    @param desc   may be NULL: defaults   @param size sizeof(carom_world_hit) as the caller knows it
    @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; *_HANDLE (desc->ignore); NOT_FINITE; OUT_OF_RANGE;
            BUFFER_TOO_SMALL (size); BUSY; OUT_OF_MEMORY   @thread reader"""
    ...
def carom_world_cast_rays(world: Any, rays: Any, want: Any, desc: Any, hits: Any, error: Any) -> int:
    """What each of many rays meets first, or whether it meets anything. A bad ray (not finite, or max negative) spoils no
    other: its outcome is CAROM_CAST_BAD_RAY. Nothing is allocated per ray.
    @param want   CAROM_WANT_*   @param desc may be NULL: defaults
    @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED; UNKNOWN_ENUM; *_HANDLE (desc->ignore); NOT_FINITE;
            OUT_OF_RANGE; BUFFER_TOO_SMALL (a stride); BUSY; OUT_OF_MEMORY   @thread reader"""
    ...
def carom_world_cast_rays_all(world: Any, rays: Any, desc: Any, dst: Any, stride: Any, capacity: Any, count: Any, error: Any) -> int:
    """All that each of many rays meets: by ray, then by time, then by slot. A bad ray has one record that says so.
    @param dst    [capacity] elements `stride` bytes apart; may be NULL if capacity is 0
    @param stride sizeof(carom_world_hit) as the caller knows it
    @param count  out: how many there are (may exceed capacity; the first `capacity` are written)
    @status as carom_world_cast_rays()   @thread reader"""
    ...
def carom_world_cast_shapes(world: Any, shapes: Any, want: Any, desc: Any, dst: Any, stride: Any, error: Any) -> int:
    """What each of many shapes meets first as it moves by its motion without turning, or whether it meets anything.
    @param shapes every shape, position, orientation and motion must be good, else nothing is written
    @param want   CAROM_WANT_*   @param desc may be NULL: defaults
    @param dst    [shapes->count] elements `stride` bytes apart   @param stride 0: tightly packed
    @status OK; NULL_ARGUMENT; STRUCT_SIZE; UNSUPPORTED (a half-space as query shape); UNKNOWN_ENUM; *_HANDLE;
    NOT_FINITE;
            NOT_UNIT; OUT_OF_RANGE; BUFFER_TOO_SMALL (a stride); BUSY; OUT_OF_MEMORY   @thread reader"""
    ...
def carom_world_cast_shapes_all(world: Any, shapes: Any, desc: Any, dst: Any, stride: Any, capacity: Any, count: Any, error: Any) -> int:
    """All that each of many moving shapes meets: by shape, then by time, then by slot; as carom_world_cast_rays_all().
    @status as carom_world_cast_rays_all(); NOT_UNIT   @thread reader"""
    ...
def carom_world_overlap_shapes(world: Any, shapes: Any, desc: Any, dst: Any, stride: Any, capacity: Any, count: Any, error: Any) -> int:
    """All that overlaps each of many shapes (or is nearer than desc->target): by shape, then by slot; arguments as
    carom_world_cast_rays_all().   @status as carom_world_cast_rays_all(); NOT_UNIT   @thread reader"""
    ...
def carom_world_find_nearest(world: Any, shapes: Any, reach: Any, desc: Any, dst: Any, stride: Any, error: Any) -> int:
    """The collider nearest to each of many shapes or points, and where: least signed distance.
    @param reach  m, >= 0, may be infinite: farther ones are not looked for (then: MISS)
    @param dst    as carom_world_cast_shapes()
    @status as carom_world_cast_shapes()   @thread reader"""
    ...
