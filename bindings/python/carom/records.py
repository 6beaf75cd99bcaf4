"""What structs say, what keywords set, and the words of enumerations.

Written by bindings/gen/generate from include/carom; do not edit."""
from __future__ import annotations

from enum import IntFlag
from typing import TYPE_CHECKING, Literal, TypedDict

from ._values import Record

if TYPE_CHECKING:
    from ._values import Rows, Vector
    from .body import Body, Collider, Material
    from .joint import Joint
    from .particles import Particles
    from .shape import Shape

# Words: each is a constant without its prefix, CAROM_BODY_STATIC "static". Numbers pass, too.
ScalarWord = Literal["f32", "f64"]
IslandFlagsWord = Literal["estimated", "bound", "joints_alone", "stalled"]
ColumnWord = Literal["bodies", "joints", "masses", "materials", "gravity", "time", "contact_forces", "rays"]
WhenWord = Literal["on_call", "before_step", "after_step"]
StoppedWord = Literal["no", "fault", "memory"]
RandomWord = Literal["uniform", "normal"]
MixWord = Literal["geometric_mean", "maximum", "minimum", "average", "multiply"]
BodyTypeWord = Literal["static", "kinematic", "dynamic"]
BodyFieldsWord = Literal["mass", "center", "inertia"]
LocksWord = Literal["linear_x", "linear_y", "linear_z", "angular_x", "angular_y", "angular_z", "all", "plane"]
AttributeWord = Literal["gravity_factor", "locks", "drag", "force_field_mask", "magnetic_moment"]
ContinuousWord = Literal["auto", "always", "never"]
FieldWord = Literal["position", "orientation", "pose", "linear_velocity", "angular_velocity", "velocity", "force",
    "center", "mass"]
CastWord = Literal["miss", "hit", "overlap", "undecided", "bad_ray"]
QueryFlagsWord = Literal["generic", "sensors", "ignore_touched"]
OverlapWord = Literal["apart", "overlapping", "touching", "fault"]
GroundWord = Literal["air", "steep", "firm"]
DialWord = Literal["integrator", "rotation", "substeps", "solver", "velocity_iterations", "position_iterations",
    "velocity_tolerance", "position_tolerance", "restitution_speed", "severity_search", "groups", "broad_phase",
    "grid_cell", "contact_distance", "pair_routines", "narrow_phase", "simplex", "gjk_tolerance", "gjk_iterations",
    "epa_iterations", "hybrid_margin", "warm_separation", "manifold", "cache_distance", "warm_start", "carry_over",
    "contact_frequency", "contact_damping", "push_speed", "sleep", "sleep_speed", "sleep_time", "direct_sink",
    "direct_ratio", "direct_work", "hold_angle", "joint_frequency", "joint_damping", "continuous", "precision",
    "joint_order", "accuracy_place", "accuracy_turn", "accuracy_substeps", "accuracy_work", "keep_distance"]
IntegratorWord = Literal["explicit_euler", "semi_implicit_euler", "rk4", "velocity_verlet"]
RotationWord = Literal["none", "explicit", "implicit", "rk4", "lie_midpoint", "splitting", "splitting_4",
    "splitting_6"]
SolverWord = Literal["severity", "soft_step", "direct", "auto"]
SearchWord = Literal["linear", "heap"]
BroadWord = Literal["brute_force", "sweep_and_prune", "grid", "tree"]
NarrowWord = Literal["hybrid", "gjk_epa"]
SimplexWord = Literal["johnson", "voronoi", "voronoi_last"]
ManifoldWord = Literal["single", "cache", "patch", "clip"]
SweepWord = Literal["none", "flagged", "fast"]
PrecisionWord = Literal["float", "auto", "double"]
PresetWord = Literal["fast", "balanced", "accurate", "reference"]
DialKindWord = Literal["number", "integer", "choice"]
DrawWord = Literal["shapes", "scenery", "bounds", "contacts", "joints", "bodies"]
DrawByWord = Literal["type", "island"]
LogWord = Literal["info", "warning", "error"]
EventsWord = Literal["contact", "sensor", "sleep", "joint", "fault"]
ContactWord = Literal["begin", "end", "hit"]
SensorWord = Literal["enter", "leave"]
SleepWord = Literal["asleep", "awake"]
ForceFieldWord = Literal["uniform", "radial", "vortex", "magnetic"]
JointWord = Literal["ball", "hinge", "slider", "weld", "distance", "universal", "pulley", "gear", "six_axis",
    "coupling"]
CoordinateWord = Literal["twist", "swing", "slide", "distance"]
AxisWord = Literal["x", "y", "z", "turn_x", "turn_y", "turn_z"]
AxisModeWord = Literal["free", "locked", "limited"]
DriveWord = Literal["none", "position", "velocity", "effort"]
GainsWord = Literal["frequency", "force", "acceleration"]
JointFieldsWord = Literal["length"]
JointBulkWord = Literal["coordinates", "speeds", "axes", "axis_speeds", "force", "torque", "error", "broken",
    "position", "velocity", "effort", "target", "target_velocity", "target_effort", "motor", "spring", "limit",
    "axis_efforts", "axis_targets", "axis_target_velocities", "axis_target_efforts", "axis_max_forces", "axis_gains",
    "axis_limits", "orientation_target", "orientation_velocity", "orientation_effort", "orientation_gains",
    "acceleration", "axis_accelerations", "axis_frictions", "axis_armatures", "axis_effort_limits",
    "axis_speed_limits", "friction", "armature", "effort_limit", "speed_limit", "drive_target", "drive_velocity",
    "drive_effort", "drive_max_force", "drive_gains"]
EffectWord = Literal["gyroscopic", "linear_damping", "angular_damping", "gravity", "user_force", "user_torque",
    "collision", "friction", "restitution", "rolling_resistance", "spinning_resistance", "sleep", "particles",
    "filter", "sensor", "joints", "scenery", "continuous", "surface_velocity", "axis_locks", "drag", "wind", "fields",
    "springs", "buoyancy", "response", "joint_limits", "joint_motors", "events", "ledger", "magnetism"]
ModeWord = Literal["as_needed", "forbid", "force"]
TimeWord = Literal["own", "in_stage", "off"]
FormWord = Literal["none", "sphere", "capsule", "box", "polytope", "cylinder", "cone", "ellipsoid"]
QueryWord = Literal["exact_enough", "capped", "rounding", "fault"]
RecordWord = Literal["hashes", "states"]
SceneryFlagsWord = Literal["two_sided"]
SnapshotWord = Literal["state", "whole"]
StageWord = Literal["refresh", "broad", "narrow", "group", "integrate", "solve", "relax", "observe"]
ReasonWord = Literal["ordinary", "mass_ratio", "sink", "too_much", "impact", "few"]
FaultWord = Literal["returned", "not_finite", "outside", "not_support", "body_state", "particle_state"]
WantWord = Literal["first", "any"]


class IslandFlags(IntFlag):
    """CAROM_ISLAND_*: bits; `IslandFlags.ESTIMATED in flags`"""
    ESTIMATED = 1
    """its error was estimated in this step, else in one before"""
    BOUND = 2
    """the bound of work was reached: its error is over the tolerance"""
    JOINTS_ALONE = 4
    """joints alone hold it: its error is of order 2, 4 or 6"""
    STALLED = 8
    """more substeps do not lessen its error, which is over the tolerance: contacts, mostly"""


class BodyRecord(Record):
    """What a body is made from"""
    fields: int
    type: str
    position: tuple[float, float, float]
    orientation: tuple[float, float, float, float]
    linear_velocity: tuple[float, float, float]
    angular_velocity: tuple[float, float, float]
    mass: float
    center: tuple[float, float, float]
    inertia: tuple[float, ...]
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
    magnetic_moment: tuple[float, float, float]


class ColliderRecord(Record):
    """A shape on a body"""
    shape: Shape | None
    material: Material | None
    position: tuple[float, float, float]
    orientation: tuple[float, float, float, float]
    density: float
    category: int
    mask: int
    group: int
    sensor: int
    surface_linear: tuple[float, float, float]
    surface_angular: tuple[float, float, float]
    body: Body


class ForceFieldRecord(Record):
    """What acts on every body that shares a bit of its mask"""
    kind: str
    is_force: int
    mask: int
    position: tuple[float, float, float]
    orientation: tuple[float, float, float, float]
    half: tuple[float, float, float]
    vector: tuple[float, float, float]
    strength: float
    pull: float
    lift: float
    reference: float
    core: float
    reach: float
    falloff: int
    user: int


class SpringRecord(Record):
    """A spring as a force"""
    only_pulls: int
    body_a: Body | None
    body_b: Body | None
    anchor_a: tuple[float, float, float]
    anchor_b: tuple[float, float, float]
    rest: float
    stiffness: float
    damping: float
    user: int


class JointRecord(Record):
    """Fill with carom_joint_desc_init()"""
    kind: str
    fields: int
    body_a: Body | None
    body_b: Body | None
    position_a: tuple[float, float, float]
    orientation_a: tuple[float, float, float, float]
    position_b: tuple[float, float, float]
    orientation_b: tuple[float, float, float, float]
    length: float
    break_force: float
    break_torque: float
    user: int


class JointStateRecord(Record):
    """What a joint does and where it is"""
    broken: bool
    force: tuple[float, float, float]
    torque: tuple[float, float, float]
    gap: float
    angle: float
    coordinate: dict[str, float]
    axis: dict[str, float]


class JointTransmissionRecord(Record):
    """By what a pulley or a gear turns the motion of A into that of B"""
    fields: int
    ratio: float
    anchor_a: tuple[float, float, float]
    anchor_b: tuple[float, float, float]
    length: float


class JointCouplingRecord(Record):
    """What a coupling makes follow what"""
    follower: Joint | None
    leader: Joint | None
    polynomial: tuple[float, ...]
    user: int


class JointAxisRecord(Record):
    """What one axis of a six-axis joint does"""
    mode: str
    lower: float
    upper: float
    stop_gains: str
    drive_gains: str
    spring_gains: str
    drive: str
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


class JointOrientationDriveRecord(Record):
    """A drive of all three turns as one"""
    drive: str
    gains: str
    target: tuple[float, float, float, float]
    velocity: tuple[float, float, float]
    effort: tuple[float, float, float]
    max_force: tuple[float, float, float]
    stiffness: float
    damping: float


class JointLimitRecord(Record):
    """A coordinate kept within bounds"""
    enabled: bool
    lower: float
    upper: float


class JointMotorRecord(Record):
    """A coordinate driven at a speed"""
    enabled: bool
    speed: float
    max_force: float


class JointSpringRecord(Record):
    """A coordinate pulled towards a place"""
    enabled: bool
    target: float
    frequency: float
    damping: float
    max_force: float


class ShapeInfoRecord(Record):
    """What the engine knows of a shape"""
    form: int
    is_half_space: int
    mass_exact: int
    plugin: int
    param_count: int
    core_radius: float
    bounding_radius: float
    aabb_min: tuple[float, float, float]
    aabb_max: tuple[float, float, float]
    volume: float
    volume_min: float
    volume_max: float
    centroid: tuple[float, float, float]
    centroid_error: float
    inertia: tuple[float, ...]
    inertia_error: float
    is_scenery: int


class DistanceRecord(Record):
    """The result"""
    status: int
    separation: float
    lower: float
    upper: float
    normal: tuple[float, float, float]
    point_a: tuple[float, float, float]
    point_b: tuple[float, float, float]
    gjk_iterations: int
    epa_iterations: int
    support_calls: int


class CastRecord(Record):
    """The result"""
    outcome: str
    status: int
    iterations: int
    time: float
    lower: float
    upper: float
    separation: float
    slack: float
    normal: tuple[float, float, float]
    point_a: tuple[float, float, float]
    point_b: tuple[float, float, float]
    support_calls: int


class OverlapRecord(Record):
    """carom_overlap"""
    outcome: str
    separation_bound: float
    normal: tuple[float, float, float]
    point: tuple[float, float, float]
    slack: float
    support_calls: int


class WorldHitRecord(Record):
    """One collider's result"""
    outcome: str
    status: int
    query: int
    collider: Collider | None
    body: Body | None
    time: float
    lower: float
    upper: float
    separation: float
    normal: tuple[float, float, float]
    point: tuple[float, float, float]
    point_own: tuple[float, float, float]


class StepReportRecord(Record):
    """Times"""
    stage_count: int
    stage_seconds: dict[str, float]
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


class ContactRecord(Record):
    """A contact point of the last step"""
    collider_a: Collider | None
    collider_b: Collider | None
    body_a: Body | None
    body_b: Body | None
    point: tuple[float, float, float]
    normal: tuple[float, float, float]
    separation: float
    normal_impulse: float
    friction_impulse: float


class GroupRecord(Record):
    """A contact group of the last step"""
    body: Body | None
    bodies: int
    points: int
    solver: int
    reason: int
    mass_ratio: float
    sink: float


class AccuracyRecord(Record):
    """An error tolerance"""
    substeps: int
    place: float
    turn: float


class IslandRecord(Record):
    """An island of the last step"""
    body: Body | None
    bodies: int
    substeps: int
    order: int
    flags: IslandFlags
    work: int
    place: float
    turn: float
    share: float


class GrowthRecord(Record):
    """How errors grow by themselves"""
    steps: int
    body: Body | None
    sensitive: bool
    factor: float
    rate: float


class FaultRecord(Record):
    """Something misbehaved in the last step"""
    kind: str
    shape: Shape | None
    body: Body | None
    dir: tuple[float, float, float]
    out: tuple[float, float, float]
    particles: Particles | None
    particle: int


class ContactEventRecord(Record):
    """Of two colliders"""
    kind: str
    collider_a: Collider | None
    collider_b: Collider | None
    body_a: Body | None
    body_b: Body | None
    point: tuple[float, float, float]
    normal: tuple[float, float, float]
    impulse: float
    approach_speed: float


class SensorEventRecord(Record):
    """What a sensor overlaps at the end of the step and did not at the end of the one before"""
    kind: str
    sensor: Collider | None
    other: Collider | None
    sensor_body: Body | None
    other_body: Body | None


class SleepEventRecord(Record):
    """A body that sleeps at the end of the step and did not at the end of the one before"""
    kind: str
    body: Body | None


class JointEventRecord(Record):
    """A joint that bore more than its break_force or break_torque in this step"""
    joint: Joint | None
    body_a: Body | None
    body_b: Body | None
    force: tuple[float, float, float]
    torque: tuple[float, float, float]
    step: int


class TreeCoordinateRecord(Record):
    """What a number of a tree stands for"""
    joint: Joint | None
    body: Body | None
    axis: str


class VehicleRecord(Record):
    """State of engine and gears"""
    gear: int
    engine_speed: float
    shifting: float
    since_shift: float
    speed: float


class WheelRecord(Record):
    """State of a wheel"""
    touches: bool
    body: Body | None
    collider: Collider | None
    point: tuple[float, float, float]
    normal: tuple[float, float, float]
    position: tuple[float, float, float]
    compression: float
    spin: float
    angle: float
    steer: float
    load: float
    force: float
    side_force: float
    slip: float
    side_slip: float


class FaultEventRecord(Record):
    """A support function that returned a false point"""
    kind: str
    shape: Shape | None
    body: Body | None
    particles: Particles | None
    particle: int
    dir: tuple[float, float, float]
    out: tuple[float, float, float]
    step: int


class PlanLineRecord(Record):
    """A line of the plan"""
    effect: int | None
    stage: int
    mode: str
    runs: bool
    participants: int
    wanted: int
    evaluations: int
    bytes: int
    seconds: float
    timing: int
    name: str
    unit: str
    reason: str


class LedgerEntryRecord(Record):
    """A cause"""
    name: str
    kinetic: float
    potential: float
    linear: tuple[float, float, float]
    angular: tuple[float, float, float]
    total_kinetic: float
    total_potential: float
    total_linear: tuple[float, float, float]
    total_angular: tuple[float, float, float]


class LedgerStateRecord(Record):
    """The state itself"""
    is_kept: bool
    steps: int
    start_kinetic: float
    start_potential: float
    start_linear: tuple[float, float, float]
    start_angular: tuple[float, float, float]
    before_kinetic: float
    before_potential: float
    before_linear: tuple[float, float, float]
    before_angular: tuple[float, float, float]
    now_kinetic: float
    now_potential: float
    now_linear: tuple[float, float, float]
    now_angular: tuple[float, float, float]
    rounding_energy: float
    rounding_linear: float
    rounding_angular: float
    total_rounding_energy: float
    total_rounding_linear: float
    total_rounding_angular: float


class ResidualsRecord(Record):
    """What is left undone"""
    ledger_is_kept: bool
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
    energy_drift: float | None


class DrawLineRecord(Record):
    """carom_draw_line"""
    from_: tuple[float, float, float]
    to: tuple[float, float, float]
    colour: int
    kind: int
    body: Body | None


class BatchInfoRecord(Record):
    """What a batch has"""
    structures: int
    worlds: int
    stopped: int
    columns: int
    real_worlds: int
    state_bytes: int


class MaterialKeywords(TypedDict, total=False):
    friction_mix: MixWord | int
    restitution_mix: MixWord | int
    friction: float | None
    restitution: float | None


class ForceFieldKeywords(TypedDict, total=False):
    is_force: int | None
    mask: int | None
    position: Vector | None
    orientation: Vector | None
    half: Vector | None
    vector: Vector | None
    strength: float | None
    pull: float | None
    lift: float | None
    reference: float | None
    core: float | None
    reach: float | None
    falloff: int | None
    user: int | None


class ParticlesKeywords(TypedDict, total=False):
    gravity_factor: float | None
    linear_damping: float | None
    mass: float | None
    capacity: int | None


class AccuracyKeywords(TypedDict, total=False):
    substeps: int | None
    place: float | None
    turn: float | None


class JointKeywords(TypedDict, total=False):
    position_a: Vector | None
    orientation_a: Vector | None
    position_b: Vector | None
    orientation_b: Vector | None
    length: float | None
    break_force: float | None
    break_torque: float | None
    user: int | None
    collide: bool
    accelerations: bool


class JointTransmissionKeywords(TypedDict, total=False):
    fields: int | None
    ratio: float | None
    anchor_a: Vector | None
    anchor_b: Vector | None
    length: float | None


class JointAxisKeywords(TypedDict, total=False):
    mode: AxisModeWord | int
    lower: float | None
    upper: float | None
    stop_gains: GainsWord | int
    drive_gains: GainsWord | int
    spring_gains: GainsWord | int
    drive: DriveWord | int
    stop_stiffness: float | None
    stop_damping: float | None
    target: float | None
    speed: float | None
    effort: float | None
    max_force: float | None
    drive_stiffness: float | None
    drive_damping: float | None
    rest: float | None
    spring_stiffness: float | None
    spring_damping: float | None
    friction: float | None
    armature: float | None
    effort_limit: float | None
    speed_limit: float | None


class JointOrientationDriveKeywords(TypedDict, total=False):
    drive: DriveWord | int
    gains: GainsWord | int
    target: Vector | None
    velocity: Vector | None
    effort: Vector | None
    max_force: Vector | None
    stiffness: float | None
    damping: float | None


class JointLimitKeywords(TypedDict, total=False):
    enabled: bool
    lower: float | None
    upper: float | None


class JointMotorKeywords(TypedDict, total=False):
    enabled: bool
    speed: float | None
    max_force: float | None


class JointSpringKeywords(TypedDict, total=False):
    enabled: bool
    target: float | None
    frequency: float | None
    damping: float | None
    max_force: float | None


class CastKeywords(TypedDict, total=False):
    iterations: int | None
    tolerance: float | None
    target: float | None
    flags: int | None


class DistanceKeywords(TypedDict, total=False):
    simplex: int | None
    narrow_phase: int | None
    pair_routines: int | None
    tolerance: float | None
    hybrid_margin: float | None
    gjk_iterations: int | None
    epa_iterations: int | None


class MotionKeywords(TypedDict, total=False):
    position: Vector | None
    orientation: Vector | None
    center: Vector | None
    linear_velocity: Vector | None
    angular_velocity: Vector | None


class QueryKeywords(TypedDict, total=False):
    flags: int | None
    category: int | None
    mask: int | None
    ignore: Body | int | None
    tolerance: float | None
    target: float | None
    iterations: int | None


class DrawKeywords(TypedDict, total=False):
    colouring: DrawByWord | int
    scale: float | None


class CharacterKeywords(TypedDict, total=False):
    up: Vector | None
    gravity: float | None
    fall_speed: float | None
    max_slope: float | None
    step_up: float | None
    step_down: float | None
    skin: float | None
    acceleration: float | None
    air_acceleration: float | None
    mass: float | None
    push_force: float | None
    recover_speed: float | None
    category: int | None
    mask: int | None
    body: Body | int | None
    turns: bool
    flies: bool


class VehicleKeywords(TypedDict, total=False):
    up: Vector | None
    forward: Vector | None
    category: int | None
    mask: int | None
    idle_speed: float | None
    max_speed: float | None
    engine_inertia: float | None
    engine_drag: float | None
    gears: Vector | None
    reverse: float | None
    final_drive: float | None
    clutch_torque: float | None
    shift_up: float | None
    shift_down: float | None
    shift_time: float | None
    limited_slip: float | None
    torque_curve: Rows | None
    automatic: bool
    ackermann: bool


class WheelKeywords(TypedDict, total=False):
    anti_roll_partner: int | None
    shape: Shape | int | None
    position: Vector | None
    radius: float | None
    inertia: float | None
    travel: float | None
    stiffness: float | None
    damping_bump: float | None
    damping_rebound: float | None
    anti_roll: float | None
    max_steer: float | None
    drive: float | None
    brake: float | None
    handbrake: float | None
    rolling: float | None
    grip: float | None
    side_grip: float | None
    peak_slip: float | None
    side_peak_slip: float | None
    slide: float | None
    slide_slip: float | None
    relaxation: float | None


class DialKeywords(TypedDict, total=False):
    integrator: float | str
    rotation: float | str
    substeps: float | str
    solver: float | str
    velocity_iterations: float | str
    position_iterations: float | str
    velocity_tolerance: float | str
    position_tolerance: float | str
    restitution_speed: float | str
    severity_search: float | str
    groups: float | str
    broad_phase: float | str
    grid_cell: float | str
    contact_distance: float | str
    pair_routines: float | str
    narrow_phase: float | str
    simplex: float | str
    gjk_tolerance: float | str
    gjk_iterations: float | str
    epa_iterations: float | str
    hybrid_margin: float | str
    warm_separation: float | str
    manifold: float | str
    cache_distance: float | str
    warm_start: float | str
    carry_over: float | str
    contact_frequency: float | str
    contact_damping: float | str
    push_speed: float | str
    sleep: float | str
    sleep_speed: float | str
    sleep_time: float | str
    direct_sink: float | str
    direct_ratio: float | str
    direct_work: float | str
    hold_angle: float | str
    joint_frequency: float | str
    joint_damping: float | str
    continuous: float | str
    precision: float | str
    joint_order: float | str
    accuracy_place: float | str
    accuracy_turn: float | str
    accuracy_substeps: float | str
    accuracy_work: float | str
    keep_distance: float | str
