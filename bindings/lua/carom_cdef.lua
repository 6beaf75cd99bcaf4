-- Written by bindings/gen/generate from include/carom; do not edit.
require("ffi").cdef [[
typedef struct carom_batch carom_batch;
typedef struct carom_engine carom_engine;
typedef struct carom_device carom_device;
typedef struct carom_world carom_world;
typedef struct carom_error carom_error;
typedef struct carom_accuracy carom_accuracy;
typedef struct carom_island carom_island;
typedef struct carom_growth carom_growth;
typedef struct carom_batch_column carom_batch_column;
typedef struct carom_batch_info carom_batch_info;
typedef struct carom_material_desc carom_material_desc;
typedef struct carom_body_desc carom_body_desc;
typedef struct carom_attribute_info carom_attribute_info;
typedef struct carom_collider_desc carom_collider_desc;
typedef struct carom_cast_desc carom_cast_desc;
typedef struct carom_cast carom_cast;
typedef struct carom_motion carom_motion;
typedef struct carom_overlap carom_overlap;
typedef struct carom_rays carom_rays;
typedef struct carom_ray_hit carom_ray_hit;
typedef struct carom_ray_hits carom_ray_hits;
typedef struct carom_character_desc carom_character_desc;
typedef struct carom_character carom_character;
typedef struct carom_dial_info carom_dial_info;
typedef struct carom_constant_info carom_constant_info;
typedef struct carom_draw_desc carom_draw_desc;
typedef struct carom_draw_line carom_draw_line;
typedef struct carom_engine_desc carom_engine_desc;
typedef struct carom_jobs_desc carom_jobs_desc;
typedef struct carom_contact_event carom_contact_event;
typedef struct carom_sensor_event carom_sensor_event;
typedef struct carom_sleep_event carom_sleep_event;
typedef struct carom_joint_event carom_joint_event;
typedef struct carom_fault_event carom_fault_event;
typedef struct carom_force_field_desc carom_force_field_desc;
typedef struct carom_spring_desc carom_spring_desc;
typedef struct carom_water carom_water;
typedef struct carom_joint_desc carom_joint_desc;
typedef struct carom_joint_limit carom_joint_limit;
typedef struct carom_joint_motor carom_joint_motor;
typedef struct carom_joint_spring carom_joint_spring;
typedef struct carom_joint_transmission carom_joint_transmission;
typedef struct carom_joint_coupling carom_joint_coupling;
typedef struct carom_joint_axis carom_joint_axis;
typedef struct carom_joint_orientation_drive carom_joint_orientation_drive;
typedef struct carom_joint_state carom_joint_state;
typedef struct carom_ledger_entry carom_ledger_entry;
typedef struct carom_ledger_state carom_ledger_state;
typedef struct carom_pairs carom_pairs;
typedef struct carom_device_info carom_device_info;
typedef struct carom_particles_desc carom_particles_desc;
typedef struct carom_plan_line carom_plan_line;
typedef struct carom_param carom_param;
typedef struct carom_param_rule carom_param_rule;
typedef struct carom_geometry carom_geometry;
typedef struct carom_shape_plugin carom_shape_plugin;
typedef struct carom_distance_desc carom_distance_desc;
typedef struct carom_distance carom_distance;
typedef struct carom_difference carom_difference;
typedef struct carom_residuals carom_residuals;
typedef struct carom_mesh_desc carom_mesh_desc;
typedef struct carom_height_field_desc carom_height_field_desc;
typedef struct carom_scenery_info carom_scenery_info;
typedef struct carom_shape_info carom_shape_info;
typedef struct carom_tree_coordinate carom_tree_coordinate;
typedef struct carom_vehicle_desc carom_vehicle_desc;
typedef struct carom_wheel_desc carom_wheel_desc;
typedef struct carom_vehicle_input carom_vehicle_input;
typedef struct carom_vehicle carom_vehicle;
typedef struct carom_wheel carom_wheel;
typedef struct carom_world_desc carom_world_desc;
typedef struct carom_step_report carom_step_report;
typedef struct carom_contact carom_contact;
typedef struct carom_group carom_group;
typedef struct carom_fault carom_fault;
typedef struct carom_query_desc carom_query_desc;
typedef struct carom_world_hit carom_world_hit;
typedef struct carom_query_shapes carom_query_shapes;
typedef struct carom_world_hits carom_world_hits;
typedef uint64_t carom_plugin;
typedef uint64_t carom_shape;
typedef uint64_t carom_material;
typedef uint64_t carom_body;
typedef uint64_t carom_collider;
typedef uint64_t carom_particles;
typedef uint64_t carom_joint;
typedef uint64_t carom_force_field;
typedef uint64_t carom_spring;
typedef void (*carom_job_fn)(void *context, uint32_t begin, uint32_t end);
typedef int32_t (*carom_support_fn)(void *user, const double *params, uint64_t param_len, const double *dir, double *out);
typedef int32_t (*carom_write_fn)(void *user, const void *bytes, uint64_t size);
struct carom_error { uint32_t struct_size; int32_t code; int32_t argument; uint32_t has_witness; double witness_dir[3]; double witness_out[3]; char message[256]; char remedy[256]; };
struct carom_accuracy { uint32_t struct_size; uint32_t substeps; double place; double turn; };
struct carom_island { carom_body body; uint32_t bodies; uint32_t substeps; uint32_t order; uint32_t flags; uint64_t work; double place; double turn; double share; };
struct carom_growth { uint32_t struct_size; uint32_t steps; carom_body body; uint32_t sensitive; uint32_t reserved; double factor; double rate; };
struct carom_batch_column { uint32_t struct_size; uint32_t source; uint32_t field; uint32_t when; uint32_t scalar; uint32_t reserved; uint64_t world; uint64_t n; const uint64_t *handles; const double *rays; void *data; uint64_t stride; };
struct carom_batch_info { uint32_t struct_size; uint32_t structures; uint64_t worlds; uint64_t stopped; uint64_t columns; uint64_t real_worlds; uint64_t state_bytes; };
struct carom_material_desc { uint32_t struct_size; uint32_t friction_mix; uint32_t restitution_mix; uint32_t reserved; double friction; double restitution; };
struct carom_body_desc { uint32_t struct_size; uint32_t fields; uint32_t type; uint32_t reserved; double position[3]; double orientation[4]; double linear_velocity[3]; double angular_velocity[3]; double mass; double center[3]; double inertia[9]; double linear_damping; double angular_damping; uint64_t user; double gravity_factor; uint32_t locks; uint32_t continuous; double linear_drag; double quadratic_drag; uint32_t force_field_mask; uint32_t reserved2; double magnetic_moment[3]; };
struct carom_attribute_info { uint32_t struct_size; uint32_t attribute; uint32_t numbers; uint32_t is_whole; uint32_t of_dynamic; uint32_t effect; const char *name; const char *unit; const char *summary; double min; double max; double usual[4]; };
struct carom_collider_desc { uint32_t struct_size; uint32_t reserved; carom_shape shape; carom_material material; double position[3]; double orientation[4]; double density; uint64_t category; uint64_t mask; int32_t group; uint32_t sensor; double surface_linear[3]; double surface_angular[3]; };
struct carom_cast_desc { uint32_t struct_size; uint32_t iterations; double tolerance; double target; uint32_t flags; uint32_t reserved; };
struct carom_cast { uint32_t struct_size; uint32_t outcome; uint32_t status; uint32_t iterations; double time; double lower; double upper; double separation; double slack; double normal[3]; double point_a[3]; double point_b[3]; uint32_t support_calls; uint32_t reserved; };
struct carom_motion { uint32_t struct_size; uint32_t reserved; double position[3]; double orientation[4]; double center[3]; double linear_velocity[3]; double angular_velocity[3]; };
struct carom_overlap { uint32_t struct_size; uint32_t outcome; double separation_bound; double normal[3]; double point[3]; double slack; uint32_t support_calls; uint32_t reserved; };
struct carom_rays { uint32_t struct_size; uint32_t scalar; uint64_t count; const void *origins; const void *directions; const void *max; uint64_t origin_stride; uint64_t direction_stride; uint64_t max_stride; };
struct carom_ray_hit { uint32_t outcome; uint32_t status; uint32_t shape; uint32_t reserved; double time; double lower; double upper; double normal[3]; double point[3]; };
struct carom_ray_hits { uint32_t struct_size; uint32_t scalar; carom_ray_hit *records; uint32_t *outcomes; uint32_t *shapes; void *times; void *normals; void *points; uint64_t record_stride; uint64_t outcome_stride; uint64_t shape_stride; uint64_t time_stride; uint64_t normal_stride; uint64_t point_stride; };
struct carom_character_desc { uint32_t struct_size; uint32_t flags; double up[3]; double gravity; double fall_speed; double max_slope; double step_up; double step_down; double skin; double acceleration; double air_acceleration; double mass; double push_force; double recover_speed; uint64_t category; uint64_t mask; carom_body body; };
struct carom_character { uint32_t struct_size; uint32_t ground; carom_shape shape; double position[3]; double orientation[4]; double velocity[3]; double foot; double head; double reach; carom_body ground_body; carom_collider ground_collider; double ground_point[3]; double ground_normal[3]; double ground_velocity[3]; double ground_position[3]; double ground_orientation[4]; uint32_t contact_count; uint32_t reserved; carom_body contact_bodies[8]; double contact_points[24]; double contact_normals[24]; double contact_speeds[8]; };
struct carom_dial_info { uint32_t struct_size; uint32_t dial; uint32_t kind; uint32_t choice_count; const char *name; const char *unit; const char *summary; const char *const *choices; double min; double max; double initial; };
struct carom_constant_info { uint32_t struct_size; uint32_t constant; const char *name; const char *unit; const char *reason; const char *consequence; double value; };
struct carom_draw_desc { uint32_t struct_size; uint32_t what; uint32_t colouring; uint32_t reserved; double scale; };
struct carom_draw_line { double from[3]; double to[3]; uint32_t colour; uint32_t kind; carom_body body; };
struct carom_engine_desc { uint32_t struct_size; uint32_t reserved; void * (*alloc)(void *, uint64_t, uint64_t); void (*free)(void *, void *, uint64_t, uint64_t); void *alloc_user; void (*log)(void *, uint32_t, const char *); void *log_user; };
struct carom_jobs_desc { uint32_t struct_size; uint32_t threads; void (*run)(void *, carom_job_fn, void *, uint32_t); void *user; };
struct carom_contact_event { uint32_t kind; uint32_t reserved; carom_collider collider_a; carom_collider collider_b; carom_body body_a; carom_body body_b; double point[3]; double normal[3]; double impulse; double approach_speed; };
struct carom_sensor_event { uint32_t kind; uint32_t reserved; carom_collider sensor; carom_collider other; carom_body sensor_body; carom_body other_body; };
struct carom_sleep_event { uint32_t kind; uint32_t reserved; carom_body body; };
struct carom_joint_event { carom_joint joint; carom_body body_a; carom_body body_b; double force[3]; double torque[3]; uint64_t step; };
struct carom_fault_event { uint32_t kind; uint32_t reserved; carom_shape shape; carom_body body; carom_particles particles; uint64_t particle; double dir[3]; double out[3]; uint64_t step; };
struct carom_force_field_desc { uint32_t struct_size; uint32_t kind; uint32_t is_force; uint32_t mask; double position[3]; double orientation[4]; double half[3]; double vector[3]; double strength; double pull; double lift; double reference; double core; double reach; int32_t falloff; uint32_t reserved; uint64_t user; };
struct carom_spring_desc { uint32_t struct_size; uint32_t only_pulls; carom_body body_a; carom_body body_b; double anchor_a[3]; double anchor_b[3]; double rest; double stiffness; double damping; uint64_t user; };
struct carom_water { uint32_t struct_size; uint32_t reserved; double normal[3]; double level; double density; double current[3]; double drag; };
struct carom_joint_desc { uint32_t struct_size; uint32_t kind; uint32_t fields; uint32_t reserved; carom_body body_a; carom_body body_b; double position_a[3]; double orientation_a[4]; double position_b[3]; double orientation_b[4]; double length; double break_force; double break_torque; uint64_t user; };
struct carom_joint_limit { uint32_t struct_size; uint32_t enabled; double lower; double upper; };
struct carom_joint_motor { uint32_t struct_size; uint32_t enabled; double speed; double max_force; };
struct carom_joint_spring { uint32_t struct_size; uint32_t enabled; double target; double frequency; double damping; double max_force; };
struct carom_joint_transmission { uint32_t struct_size; uint32_t fields; double ratio; double anchor_a[3]; double anchor_b[3]; double length; };
struct carom_joint_coupling { uint32_t struct_size; uint32_t reserved; carom_joint follower; carom_joint leader; double polynomial[5]; uint64_t user; };
struct carom_joint_axis { uint32_t struct_size; uint32_t mode; double lower; double upper; uint32_t stop_gains; uint32_t drive_gains; uint32_t spring_gains; uint32_t drive; double stop_stiffness; double stop_damping; double target; double speed; double effort; double max_force; double drive_stiffness; double drive_damping; double rest; double spring_stiffness; double spring_damping; double friction; double armature; double effort_limit; double speed_limit; };
struct carom_joint_orientation_drive { uint32_t struct_size; uint32_t drive; uint32_t gains; uint32_t reserved; double target[4]; double velocity[3]; double effort[3]; double max_force[3]; double stiffness; double damping; };
struct carom_joint_state { uint32_t struct_size; uint32_t broken; double force[3]; double torque[3]; double gap; double angle; double coordinate[4]; double axis[6]; };
struct carom_ledger_entry { const char *name; double kinetic; double potential; double linear[3]; double angular[3]; double total_kinetic; double total_potential; double total_linear[3]; double total_angular[3]; };
struct carom_ledger_state { uint32_t struct_size; uint32_t is_kept; uint64_t steps; double start_kinetic; double start_potential; double start_linear[3]; double start_angular[3]; double before_kinetic; double before_potential; double before_linear[3]; double before_angular[3]; double now_kinetic; double now_potential; double now_linear[3]; double now_angular[3]; double rounding_energy; double rounding_linear; double rounding_angular; double total_rounding_energy; double total_rounding_linear; double total_rounding_angular; };
struct carom_pairs { uint32_t struct_size; uint32_t reserved; uint64_t count; const carom_shape *shapes_a; const carom_shape *shapes_b; const double *positions_a; const double *orientations_a; const double *positions_b; const double *orientations_b; uint64_t shape_a_stride; uint64_t shape_b_stride; uint64_t position_a_stride; uint64_t orientation_a_stride; uint64_t position_b_stride; uint64_t orientation_b_stride; };
struct carom_device_info { uint32_t struct_size; uint32_t reserved; char name[128]; char version[128]; uint64_t pairs; uint64_t host_pairs; };
struct carom_particles_desc { uint32_t struct_size; uint32_t reserved; double gravity_factor; double linear_damping; double mass; uint64_t capacity; };
struct carom_plan_line { uint32_t effect; uint32_t stage; uint32_t mode; uint32_t runs; uint64_t participants; uint64_t wanted; uint64_t evaluations; uint64_t bytes; double seconds; uint32_t timing; uint32_t reserved; char name[32]; char unit[24]; char reason[128]; };
struct carom_param { const char *name; const char *unit; double min; double max; };
struct carom_param_rule { const char *text; uint32_t term_count; uint32_t param[4]; double weight[4]; double most; };
struct carom_geometry { uint32_t struct_size; uint32_t form; uint32_t form_arg[4]; uint32_t core_radius_param; uint32_t mass_form; uint32_t mass_arg[4]; };
struct carom_shape_plugin { uint32_t struct_size; uint32_t abi_major; uint32_t abi_minor; uint32_t flags; const char *id; uint32_t version; uint32_t param_count; const carom_param *params; const carom_geometry *geometry; carom_support_fn support; uint32_t param_tail_group; uint32_t param_tail_min; const carom_param_rule *rules; uint32_t rule_count; uint32_t reserved; void *user; const char *text; };
struct carom_distance_desc { uint32_t struct_size; uint32_t simplex; uint32_t narrow_phase; uint32_t pair_routines; double tolerance; double hybrid_margin; uint32_t gjk_iterations; uint32_t epa_iterations; };
struct carom_distance { uint32_t struct_size; uint32_t status; double separation; double lower; double upper; double normal[3]; double point_a[3]; double point_b[3]; uint32_t gjk_iterations; uint32_t epa_iterations; uint32_t support_calls; uint32_t reserved; };
struct carom_difference { uint32_t struct_size; uint32_t differs; uint64_t first; uint64_t second; char sections[240]; };
struct carom_residuals { uint32_t struct_size; uint32_t ledger_is_kept; uint64_t contact_points; uint64_t joints; double max_penetration; double mean_penetration; double joint_gap; double joint_angle; double complementarity; double cone; double slip; double energy; double energy_drift; };
struct carom_mesh_desc { uint32_t struct_size; uint32_t flags; const double *vertices; uint64_t vertex_count; const uint32_t *triangles; uint64_t triangle_count; };
struct carom_height_field_desc { uint32_t struct_size; uint32_t flags; uint32_t columns; uint32_t rows; const double *heights; double spacing[2]; };
struct carom_scenery_info { uint32_t struct_size; uint32_t flags; uint64_t triangles; uint64_t vertices; uint64_t dropped; uint64_t boundary_edges; uint64_t bytes; };
struct carom_shape_info { uint32_t struct_size; uint32_t form; uint32_t is_half_space; uint32_t mass_exact; carom_plugin plugin; uint64_t param_count; double core_radius; double bounding_radius; double aabb_min[3]; double aabb_max[3]; double volume; double volume_min; double volume_max; double centroid[3]; double centroid_error; double inertia[9]; double inertia_error; uint32_t is_scenery; uint32_t reserved; };
struct carom_tree_coordinate { carom_joint joint; carom_body body; uint32_t axis; uint32_t reserved; };
struct carom_vehicle_desc { uint32_t struct_size; uint32_t flags; carom_body chassis; double up[3]; double forward[3]; uint64_t category; uint64_t mask; uint32_t torque_count; uint32_t gear_count; double torque_speeds[8]; double torques[8]; double idle_speed; double max_speed; double engine_inertia; double engine_drag; double gears[8]; double reverse; double final_drive; double clutch_torque; double shift_up; double shift_down; double shift_time; double limited_slip; };
struct carom_wheel_desc { uint32_t struct_size; uint32_t anti_roll_partner; carom_shape shape; double position[3]; double radius; double inertia; double travel; double stiffness; double damping_bump; double damping_rebound; double anti_roll; double max_steer; double drive; double brake; double handbrake; double rolling; double grip; double side_grip; double peak_slip; double side_peak_slip; double slide; double slide_slip; double relaxation; };
struct carom_vehicle_input { uint32_t struct_size; int32_t gear; double throttle; double brake; double handbrake; double steer; };
struct carom_vehicle { uint32_t struct_size; int32_t gear; double engine_speed; double shifting; double since_shift; double speed; };
struct carom_wheel { uint32_t struct_size; uint32_t touches; carom_body body; carom_collider collider; double point[3]; double normal[3]; double position[3]; double compression; double spin; double angle; double steer; double load; double force; double side_force; double slip; double side_slip; };
struct carom_world_desc { uint32_t struct_size; uint32_t reserved; double gravity[3]; uint64_t body_capacity; };
struct carom_step_report { uint32_t struct_size; uint32_t stage_count; double stage_seconds[16]; double total_seconds; uint64_t steps; double time; uint64_t bodies; uint64_t dynamic_bodies; uint64_t colliders; uint64_t broad_pairs; uint64_t contact_pairs; uint64_t contact_points; uint64_t groups; uint64_t largest_group; uint64_t gjk_calls; uint64_t epa_calls; uint64_t support_calls; uint64_t velocity_impulses; uint64_t position_moves; uint64_t quarantined_bodies; uint64_t faults; double max_penetration; double mean_penetration; double max_closing_speed; double linear_energy; double angular_energy; uint64_t asleep_bodies; uint64_t fell_asleep; uint64_t woke_up; uint64_t direct_groups; double solver_residual; uint64_t particles; uint64_t quarantined_particles; uint64_t swept_bodies; uint64_t sweep_hits; uint64_t wedged_groups; uint64_t rejected_solutions; double excess_energy; };
struct carom_contact { carom_collider collider_a; carom_collider collider_b; carom_body body_a; carom_body body_b; double point[3]; double normal[3]; double separation; double normal_impulse; double friction_impulse; };
struct carom_group { carom_body body; uint32_t bodies; uint32_t points; uint32_t solver; uint32_t reason; double mass_ratio; double sink; };
struct carom_fault { uint32_t kind; uint32_t reserved; carom_shape shape; carom_body body; double dir[3]; double out[3]; carom_particles particles; uint64_t particle; };
struct carom_query_desc { uint32_t struct_size; uint32_t flags; uint64_t category; uint64_t mask; carom_body ignore; double tolerance; double target; uint32_t iterations; uint32_t reserved; };
struct carom_world_hit { uint32_t outcome; uint32_t status; uint64_t query; carom_collider collider; carom_body body; double time; double lower; double upper; double separation; double normal[3]; double point[3]; double point_own[3]; };
struct carom_query_shapes { uint32_t struct_size; uint32_t scalar; uint64_t count; const carom_shape *shapes; const void *positions; const void *orientations; const void *motions; uint64_t shape_stride; uint64_t position_stride; uint64_t orientation_stride; uint64_t motion_stride; };
struct carom_world_hits { uint32_t struct_size; uint32_t scalar; carom_world_hit *records; uint32_t *outcomes; carom_collider *colliders; void *times; void *normals; void *points; uint64_t record_stride; uint64_t outcome_stride; uint64_t collider_stride; uint64_t time_stride; uint64_t normal_stride; uint64_t point_stride; };
int32_t carom_version(uint32_t *major, uint32_t *minor, uint32_t *patch);
const char *carom_result_name(int32_t result);
const char *carom_result_remedy(int32_t result);
const char *carom_abi_manifest(void);
int32_t carom_abi_check(const char *layout, carom_error *error);
int32_t carom_accuracy_init(carom_accuracy *accuracy, uint32_t struct_size);
int32_t carom_world_set_accuracy(carom_world *world, const carom_accuracy *accuracy, carom_error *error);
int32_t carom_world_get_accuracy(carom_world *world, carom_accuracy *accuracy, uint32_t *present, carom_error *error);
int32_t carom_world_get_islands(carom_world *world, carom_island *dst, uint64_t stride, uint64_t capacity, uint64_t *count, carom_error *error);
int32_t carom_world_measure_growth(carom_world *world, double dt, uint32_t steps, carom_growth *growth, carom_error *error);
int32_t carom_batch_column_init(carom_batch_column *column, uint32_t struct_size);
int32_t carom_batch_create(carom_engine *engine, carom_batch **batch, carom_error *error);
int32_t carom_batch_destroy(carom_batch *batch, carom_error *error);
int32_t carom_batch_add_worlds(carom_batch *batch, carom_world *world, uint64_t n, uint64_t *first, carom_error *error);
int32_t carom_batch_add_column(carom_batch *batch, const carom_batch_column *desc, uint32_t *column, carom_error *error);
int32_t carom_batch_step(carom_batch *batch, const uint8_t *mask, double dt, uint32_t steps, uint64_t *stopped, carom_error *error);
int32_t carom_batch_read(carom_batch *batch, const uint32_t *columns, uint64_t count, const uint8_t *mask, carom_error *error);
int32_t carom_batch_write(carom_batch *batch, const uint32_t *columns, uint64_t count, const uint8_t *mask, carom_error *error);
int32_t carom_batch_add_start(carom_batch *batch, uint64_t world, const void *bytes, uint64_t size, uint32_t *start, carom_error *error);
int32_t carom_batch_reset(carom_batch *batch, const uint8_t *mask, const uint32_t *starts, carom_error *error);
int32_t carom_batch_save(carom_batch *batch, uint64_t world, void *buffer, uint64_t capacity, uint64_t *needed, carom_error *error);
int32_t carom_batch_get_hashes(carom_batch *batch, uint64_t *hashes, uint64_t n, carom_error *error);
int32_t carom_batch_get_stopped(carom_batch *batch, uint32_t *stopped, uint64_t n, carom_error *error);
int32_t carom_batch_get_faults(carom_batch *batch, uint64_t world, carom_fault *dst, uint64_t stride, uint64_t capacity, uint64_t *count, carom_error *error);
int32_t carom_batch_get_info(carom_batch *batch, carom_batch_info *info, carom_error *error);
int32_t carom_random_fill(uint32_t kind, const uint64_t *keys, uint64_t n, uint64_t width, double *dst, carom_error *error);
int32_t carom_material_desc_init(carom_material_desc *desc, uint32_t struct_size);
int32_t carom_material_create(carom_world *world, const carom_material_desc *desc, carom_material *material, carom_error *error);
int32_t carom_material_update(carom_world *world, carom_material material, const carom_material_desc *desc, carom_error *error);
int32_t carom_material_set_resistance(carom_world *world, carom_material material, double rolling, double spinning, carom_error *error);
int32_t carom_material_get_resistance(carom_world *world, carom_material material, double *rolling, double *spinning, carom_error *error);
int32_t carom_material_set_pair(carom_world *world, carom_material material_a, carom_material material_b, const double *surface, carom_error *error);
int32_t carom_material_get_pair(carom_world *world, carom_material material_a, carom_material material_b, double *surface, carom_error *error);
int32_t carom_material_destroy(carom_world *world, carom_material material, carom_error *error);
int32_t carom_body_desc_init(carom_body_desc *desc, uint32_t struct_size);
int32_t carom_body_create(carom_world *world, const carom_body_desc *desc, carom_body *body, carom_error *error);
int32_t carom_body_destroy(carom_world *world, carom_body body, carom_error *error);
int32_t carom_body_get(carom_world *world, carom_body body, carom_body_desc *desc, carom_error *error);
int32_t carom_body_set_pose(carom_world *world, carom_body body, const double *position, const double *orientation, carom_error *error);
int32_t carom_body_set_velocity(carom_world *world, carom_body body, const double *linear, const double *angular, carom_error *error);
int32_t carom_body_get_pose(carom_world *world, carom_body body, double *position, double *orientation, carom_error *error);
int32_t carom_body_get_velocity(carom_world *world, carom_body body, double *linear, double *angular, carom_error *error);
int32_t carom_body_set_mass(carom_world *world, carom_body body, double mass, const double *center, const double *inertia, carom_error *error);
int32_t carom_body_get_mass(carom_world *world, carom_body body, double *mass, double *center, double *inertia, carom_error *error);
int32_t carom_body_set_type(carom_world *world, carom_body body, uint32_t type, carom_error *error);
int32_t carom_body_get_type(carom_world *world, carom_body body, uint32_t *type, carom_error *error);
int32_t carom_body_set_damping(carom_world *world, carom_body body, double linear, double angular, carom_error *error);
int32_t carom_body_get_damping(carom_world *world, carom_body body, double *linear, double *angular, carom_error *error);
int32_t carom_body_set_user(carom_world *world, carom_body body, uint64_t user, carom_error *error);
int32_t carom_body_get_user(carom_world *world, carom_body body, uint64_t *user, carom_error *error);
int32_t carom_body_get_colliders(carom_world *world, carom_body body, carom_collider *colliders, uint64_t capacity, uint64_t *count, carom_error *error);
int32_t carom_body_add_force(carom_world *world, carom_body body, const double *force, const double *torque, carom_error *error);
int32_t carom_body_add_impulse(carom_world *world, carom_body body, const double *impulse, const double *point, carom_error *error);
int32_t carom_body_set_gravity_factor(carom_world *world, carom_body body, double factor, carom_error *error);
int32_t carom_body_get_gravity_factor(carom_world *world, carom_body body, double *factor, carom_error *error);
int32_t carom_body_set_locks(carom_world *world, carom_body body, uint32_t locks, carom_error *error);
int32_t carom_body_get_locks(carom_world *world, carom_body body, uint32_t *locks, carom_error *error);
int32_t carom_attribute_get_info(uint32_t attribute, carom_attribute_info *info, carom_error *error);
int32_t carom_body_set_attribute(carom_world *world, carom_body body, uint32_t attribute, const double *value, carom_error *error);
int32_t carom_body_get_attribute(carom_world *world, carom_body body, uint32_t attribute, double *value, carom_error *error);
int32_t carom_body_is_asleep(carom_world *world, carom_body body, uint32_t *asleep, carom_error *error);
int32_t carom_body_wake(carom_world *world, carom_body body, carom_error *error);
int32_t carom_body_set_continuous(carom_world *world, carom_body body, uint32_t mode, carom_error *error);
int32_t carom_body_get_continuous(carom_world *world, carom_body body, uint32_t *mode, carom_error *error);
int32_t carom_body_set_enabled(carom_world *world, carom_body body, uint32_t enabled, carom_error *error);
int32_t carom_body_is_enabled(carom_world *world, carom_body body, uint32_t *enabled, carom_error *error);
int32_t carom_collider_desc_init(carom_collider_desc *desc, uint32_t struct_size);
int32_t carom_collider_create(carom_world *world, carom_body body, const carom_collider_desc *desc, carom_collider *collider, carom_error *error);
int32_t carom_body_create_named(carom_world *world, uint32_t type, const char *name, const double *params, uint64_t count, const double *position, carom_body *body, carom_error *error);
int32_t carom_collider_destroy(carom_world *world, carom_collider collider, carom_error *error);
int32_t carom_collider_get(carom_world *world, carom_collider collider, carom_collider_desc *desc, carom_body *body, carom_error *error);
int32_t carom_collider_set_material(carom_world *world, carom_collider collider, carom_material material, carom_error *error);
int32_t carom_collider_set_density(carom_world *world, carom_collider collider, double density, carom_error *error);
int32_t carom_collider_set_pose(carom_world *world, carom_collider collider, const double *position, const double *orientation, carom_error *error);
int32_t carom_collider_set_surface_velocity(carom_world *world, carom_collider collider, const double *linear, const double *angular, carom_error *error);
int32_t carom_collider_get_surface_velocity(carom_world *world, carom_collider collider, double *linear, double *angular, carom_error *error);
int32_t carom_world_get_bodies(carom_world *world, carom_body *handles, uint64_t capacity, uint64_t *count, carom_error *error);
int32_t carom_world_read(carom_world *world, uint32_t field, uint32_t scalar, const carom_body *handles, uint64_t n, void *dst, uint64_t stride, carom_error *error);
int32_t carom_world_write(carom_world *world, uint32_t field, uint32_t scalar, const carom_body *handles, uint64_t n, const void *src, uint64_t stride, carom_error *error);
int32_t carom_cast_desc_init(carom_cast_desc *desc, uint32_t struct_size);
int32_t carom_motion_init(carom_motion *motion, uint32_t struct_size);
int32_t carom_ray_cast(carom_engine *engine, carom_shape shape, const double *position, const double *orientation, const double *origin, const double *direction, double max, const carom_cast_desc *desc, carom_cast *result, carom_error *error);
int32_t carom_shape_cast(carom_engine *engine, carom_shape shape_a, const double *position_a, const double *orientation_a, const double *motion, carom_shape shape_b, const double *position_b, const double *orientation_b, const carom_cast_desc *desc, carom_cast *result, carom_error *error);
int32_t carom_shape_time_of_impact(carom_engine *engine, carom_shape shape_a, const carom_motion *motion_a, carom_shape shape_b, const carom_motion *motion_b, double duration, const carom_cast_desc *desc, carom_cast *result, carom_error *error);
int32_t carom_shape_overlap(carom_engine *engine, carom_shape shape_a, const double *position_a, const double *orientation_a, carom_shape shape_b, const double *position_b, const double *orientation_b, const carom_cast_desc *desc, carom_overlap *result, carom_error *error);
int32_t carom_rays_cast(carom_engine *engine, const carom_shape *shapes, const double *positions, const double *orientations, uint64_t shape_count, const carom_rays *rays, const carom_cast_desc *desc, const carom_ray_hits *hits, carom_error *error);
int32_t carom_character_desc_init(carom_character_desc *desc, uint32_t struct_size);
int32_t carom_character_init(carom_character *character, uint32_t struct_size);
int32_t carom_character_set_shape(carom_engine *engine, carom_world *world, const carom_character_desc *desc, carom_character *character, carom_shape shape, uint32_t *fits, carom_error *error);
int32_t carom_character_move(carom_world *world, const carom_character_desc *desc, carom_character *character, const double *walk, double jump, double dt, carom_error *error);
int32_t carom_character_push(carom_world *world, const carom_character_desc *desc, const carom_character *character, double dt, carom_error *error);
int32_t carom_character_move_body(carom_world *world, const carom_character_desc *desc, const carom_character *character, double dt, carom_error *error);
int32_t carom_dial_get_info(uint32_t dial, carom_dial_info *info, carom_error *error);
int32_t carom_dial_get_count(uint32_t *count);
int32_t carom_dial_find(const char *name, uint32_t *dial, carom_error *error);
int32_t carom_constant_get_count(uint32_t *count);
int32_t carom_constant_get_info(uint32_t constant, carom_constant_info *info, carom_error *error);
const char *carom_preset_name(uint32_t preset);
int32_t carom_preset_get_dial(uint32_t preset, uint32_t dial, double *value, carom_error *error);
int32_t carom_draw_desc_init(carom_draw_desc *desc, uint32_t struct_size);
int32_t carom_world_draw(carom_world *world, const carom_draw_desc *desc, carom_draw_line *dst, uint64_t stride, uint64_t capacity, uint64_t *count, carom_error *error);
int32_t carom_engine_desc_init(carom_engine_desc *desc, uint32_t struct_size);
int32_t carom_engine_create(const carom_engine_desc *desc, carom_engine **engine, carom_error *error);
int32_t carom_engine_destroy(carom_engine *engine, carom_error *error);
int32_t carom_jobs_desc_init(carom_jobs_desc *desc, uint32_t struct_size);
int32_t carom_engine_set_jobs(carom_engine *engine, const carom_jobs_desc *desc, carom_error *error);
int32_t carom_plugin_load(carom_engine *engine, const char *path, carom_plugin *plugin, carom_error *error);
int32_t carom_plugin_register(carom_engine *engine, const carom_shape_plugin *description, carom_plugin *plugin, carom_error *error);
int32_t carom_plugins_register_standard(carom_engine *engine, carom_error *error);
int32_t carom_plugin_unload(carom_engine *engine, carom_plugin plugin, carom_error *error);
int32_t carom_plugin_find(carom_engine *engine, const char *id, carom_plugin *plugin, carom_error *error);
int32_t carom_plugin_describe(carom_engine *engine, carom_plugin plugin, const carom_shape_plugin **description, carom_error *error);
int32_t carom_world_collect_events(carom_world *world, uint32_t kinds, double hit_speed, carom_error *error);
int32_t carom_world_get_contact_events(carom_world *world, carom_contact_event *dst, uint64_t stride, uint64_t capacity, uint64_t *count, carom_error *error);
int32_t carom_world_get_sensor_events(carom_world *world, carom_sensor_event *dst, uint64_t stride, uint64_t capacity, uint64_t *count, carom_error *error);
int32_t carom_world_get_sleep_events(carom_world *world, carom_sleep_event *dst, uint64_t stride, uint64_t capacity, uint64_t *count, carom_error *error);
int32_t carom_world_get_joint_events(carom_world *world, carom_joint_event *dst, uint64_t stride, uint64_t capacity, uint64_t *count, carom_error *error);
int32_t carom_world_get_fault_events(carom_world *world, carom_fault_event *dst, uint64_t stride, uint64_t capacity, uint64_t *count, carom_error *error);
int32_t carom_collider_set_filter(carom_world *world, carom_collider collider, uint64_t category, uint64_t mask, int32_t group, carom_error *error);
int32_t carom_collider_get_filter(carom_world *world, carom_collider collider, uint64_t *category, uint64_t *mask, int32_t *group, carom_error *error);
int32_t carom_body_set_filter(carom_world *world, carom_body body, uint64_t category, uint64_t mask, int32_t group, carom_error *error);
int32_t carom_body_ignore_collision(carom_world *world, carom_body body_a, carom_body body_b, uint32_t ignored, carom_error *error);
int32_t carom_collider_set_sensor(carom_world *world, carom_collider collider, uint32_t sensor, carom_error *error);
int32_t carom_collider_is_sensor(carom_world *world, carom_collider collider, uint32_t *sensor, carom_error *error);
int32_t carom_body_add_force_at(carom_world *world, carom_body body, const double *force, const double *point, carom_error *error);
int32_t carom_body_set_drag(carom_world *world, carom_body body, double linear, double quadratic, carom_error *error);
int32_t carom_body_get_drag(carom_world *world, carom_body body, double *linear, double *quadratic, carom_error *error);
int32_t carom_world_set_wind(carom_world *world, const double *velocity, carom_error *error);
int32_t carom_world_get_wind(carom_world *world, double *velocity, carom_error *error);
const char *carom_force_field_name(uint32_t kind);
int32_t carom_force_field_desc_init(carom_force_field_desc *desc, uint32_t struct_size);
int32_t carom_force_field_create(carom_world *world, const carom_force_field_desc *desc, carom_force_field *field, carom_error *error);
int32_t carom_force_field_update(carom_world *world, carom_force_field field, const carom_force_field_desc *desc, carom_error *error);
int32_t carom_force_field_get(carom_world *world, carom_force_field field, carom_force_field_desc *desc, carom_error *error);
int32_t carom_force_field_destroy(carom_world *world, carom_force_field field, carom_error *error);
int32_t carom_body_set_force_field_mask(carom_world *world, carom_body body, uint32_t mask, carom_error *error);
int32_t carom_body_get_force_field_mask(carom_world *world, carom_body body, uint32_t *mask, carom_error *error);
int32_t carom_spring_desc_init(carom_spring_desc *desc, uint32_t struct_size);
int32_t carom_spring_create(carom_world *world, const carom_spring_desc *desc, carom_spring *spring, carom_error *error);
int32_t carom_spring_update(carom_world *world, carom_spring spring, double rest, double stiffness, double damping, carom_error *error);
int32_t carom_spring_get(carom_world *world, carom_spring spring, carom_spring_desc *desc, carom_error *error);
int32_t carom_spring_get_state(carom_world *world, carom_spring spring, double *length, double *force, carom_error *error);
int32_t carom_spring_destroy(carom_world *world, carom_spring spring, carom_error *error);
int32_t carom_water_init(carom_water *water, uint32_t struct_size);
int32_t carom_world_set_water(carom_world *world, const carom_water *water, carom_error *error);
int32_t carom_world_get_water(carom_world *world, carom_water *water, uint32_t *present, carom_error *error);
const char *carom_joint_kind_name(uint32_t kind);
int32_t carom_joint_desc_init(carom_joint_desc *desc, uint32_t struct_size);
int32_t carom_joint_limit_init(carom_joint_limit *limit, uint32_t struct_size);
int32_t carom_joint_motor_init(carom_joint_motor *motor, uint32_t struct_size);
int32_t carom_joint_spring_init(carom_joint_spring *spring, uint32_t struct_size);
int32_t carom_joint_transmission_init(carom_joint_transmission *transmission, uint32_t struct_size);
int32_t carom_joint_coupling_init(carom_joint_coupling *coupling, uint32_t struct_size);
int32_t carom_joint_axis_init(carom_joint_axis *axis, uint32_t struct_size);
int32_t carom_joint_orientation_drive_init(carom_joint_orientation_drive *drive, uint32_t struct_size);
int32_t carom_joint_create(carom_world *world, const carom_joint_desc *desc, carom_joint *joint, carom_error *error);
int32_t carom_joint_destroy(carom_world *world, carom_joint joint, carom_error *error);
int32_t carom_joint_get(carom_world *world, carom_joint joint, carom_joint_desc *desc, carom_error *error);
int32_t carom_joint_get_state(carom_world *world, carom_joint joint, carom_joint_state *state, carom_error *error);
int32_t carom_joint_set_limit(carom_world *world, carom_joint joint, uint32_t coordinate, const carom_joint_limit *limit, carom_error *error);
int32_t carom_joint_set_motor(carom_world *world, carom_joint joint, uint32_t coordinate, const carom_joint_motor *motor, carom_error *error);
int32_t carom_joint_set_spring(carom_world *world, carom_joint joint, uint32_t coordinate, const carom_joint_spring *spring, carom_error *error);
int32_t carom_joint_get_limit(carom_world *world, carom_joint joint, uint32_t coordinate, carom_joint_limit *limit, carom_error *error);
int32_t carom_joint_get_motor(carom_world *world, carom_joint joint, uint32_t coordinate, carom_joint_motor *motor, carom_error *error);
int32_t carom_joint_get_spring(carom_world *world, carom_joint joint, uint32_t coordinate, carom_joint_spring *spring, carom_error *error);
int32_t carom_joint_set_transmission(carom_world *world, carom_joint joint, const carom_joint_transmission *transmission, carom_error *error);
int32_t carom_joint_get_transmission(carom_world *world, carom_joint joint, carom_joint_transmission *transmission, carom_error *error);
int32_t carom_joint_couple(carom_world *world, const carom_joint_coupling *coupling, carom_joint *joint, carom_error *error);
int32_t carom_joint_set_coupling(carom_world *world, carom_joint joint, const carom_joint_coupling *coupling, carom_error *error);
int32_t carom_joint_get_coupling(carom_world *world, carom_joint joint, carom_joint_coupling *coupling, carom_error *error);
int32_t carom_joint_set_axis(carom_world *world, carom_joint joint, uint32_t axis, const carom_joint_axis *desc, carom_error *error);
int32_t carom_joint_get_axis(carom_world *world, carom_joint joint, uint32_t axis, carom_joint_axis *desc, carom_error *error);
int32_t carom_joint_set_orientation_drive(carom_world *world, carom_joint joint, const carom_joint_orientation_drive *drive, carom_error *error);
int32_t carom_joint_get_orientation_drive(carom_world *world, carom_joint joint, carom_joint_orientation_drive *drive, carom_error *error);
int32_t carom_joint_bulk_width(uint32_t field, uint32_t *width);
int32_t carom_world_read_joints(carom_world *world, uint32_t field, uint32_t scalar, const carom_joint *joints, uint64_t n, void *dst, uint64_t stride, carom_error *error);
int32_t carom_world_write_joints(carom_world *world, uint32_t field, uint32_t scalar, const carom_joint *joints, uint64_t n, const void *src, uint64_t stride, carom_error *error);
int32_t carom_world_get_joints(carom_world *world, carom_joint *joints, uint64_t capacity, uint64_t *count, carom_error *error);
int32_t carom_world_enable_ledger(carom_world *world, uint32_t on, carom_error *error);
int32_t carom_world_get_ledger(carom_world *world, carom_ledger_entry *dst, uint64_t stride, uint64_t capacity, uint64_t *count, carom_error *error);
int32_t carom_world_get_ledger_state(carom_world *world, carom_ledger_state *state, carom_error *error);
int32_t carom_pairs_distance(carom_engine *engine, const carom_pairs *pairs, const carom_distance_desc *desc, carom_distance *dst, uint64_t stride, carom_error *error);
int32_t carom_device_create(carom_engine *engine, uint32_t index, carom_device **device, carom_error *error);
int32_t carom_device_destroy(carom_device *device, carom_error *error);
int32_t carom_device_get_info(carom_device *device, carom_device_info *info, carom_error *error);
int32_t carom_device_pairs_distance(carom_device *device, const carom_pairs *pairs, const carom_distance_desc *desc, carom_distance *dst, uint64_t stride, carom_error *error);
int32_t carom_particles_desc_init(carom_particles_desc *desc, uint32_t struct_size);
int32_t carom_particles_create(carom_world *world, const carom_particles_desc *desc, carom_particles *set, carom_error *error);
int32_t carom_particles_destroy(carom_world *world, carom_particles set, carom_error *error);
int32_t carom_particles_get(carom_world *world, carom_particles set, carom_particles_desc *desc, carom_error *error);
int32_t carom_particles_update(carom_world *world, carom_particles set, const carom_particles_desc *desc, carom_error *error);
int32_t carom_particles_get_count(carom_world *world, carom_particles set, uint64_t *count, carom_error *error);
int32_t carom_particles_add(carom_world *world, carom_particles set, uint64_t n, uint32_t scalar, const void *positions, uint64_t position_stride, const void *velocities, uint64_t velocity_stride, carom_error *error);
int32_t carom_particles_remove(carom_world *world, carom_particles set, const uint32_t *indices, uint64_t n, carom_error *error);
int32_t carom_particles_read(carom_world *world, carom_particles set, uint32_t field, uint32_t scalar, const uint32_t *indices, uint64_t n, void *dst, uint64_t stride, carom_error *error);
int32_t carom_particles_write(carom_world *world, carom_particles set, uint32_t field, uint32_t scalar, const uint32_t *indices, uint64_t n, const void *src, uint64_t stride, carom_error *error);
int32_t carom_particles_get_quarantined(carom_world *world, carom_particles set, uint32_t *indices, uint64_t capacity, uint64_t *count, carom_error *error);
int32_t carom_world_get_particles(carom_world *world, carom_particles *sets, uint64_t capacity, uint64_t *count, carom_error *error);
const char *carom_effect_name(uint32_t effect);
int32_t carom_world_set_effect(carom_world *world, uint32_t effect, uint32_t mode, carom_error *error);
int32_t carom_world_get_effect(carom_world *world, uint32_t effect, uint32_t *mode, carom_error *error);
int32_t carom_body_set_effect(carom_world *world, carom_body body, uint32_t effect, uint32_t mode, carom_error *error);
int32_t carom_body_get_effect(carom_world *world, carom_body body, uint32_t effect, uint32_t *mode, carom_error *error);
int32_t carom_world_time_effects(carom_world *world, uint32_t on, carom_error *error);
int32_t carom_world_get_plan(carom_world *world, carom_plan_line *dst, uint64_t stride, uint64_t capacity, uint64_t *count, carom_error *error);
int32_t carom_distance_desc_init(carom_distance_desc *desc, uint32_t struct_size);
int32_t carom_shape_distance(carom_engine *engine, carom_shape shape_a, const double *position_a, const double *orientation_a, carom_shape shape_b, const double *position_b, const double *orientation_b, const carom_distance_desc *desc, carom_distance *result, carom_error *error);
int32_t carom_world_record_begin(carom_world *world, uint32_t flags, carom_write_fn write, void *user, carom_error *error);
int32_t carom_world_record_end(carom_world *world, carom_error *error);
int32_t carom_world_compare(carom_world *world, const void *bytes, uint64_t size, carom_difference *difference, carom_error *error);
int32_t carom_world_get_residuals(carom_world *world, carom_residuals *residuals, carom_error *error);
int32_t carom_world_set_budget(carom_world *world, double seconds, uint32_t fewest, uint32_t most, carom_error *error);
int32_t carom_world_get_budget(carom_world *world, double *seconds, uint32_t *fewest, uint32_t *most, carom_error *error);
int32_t carom_mesh_desc_init(carom_mesh_desc *desc, uint32_t struct_size);
int32_t carom_shape_create_mesh(carom_engine *engine, const carom_mesh_desc *desc, carom_shape *shape, carom_error *error);
int32_t carom_height_field_desc_init(carom_height_field_desc *desc, uint32_t struct_size);
int32_t carom_shape_create_height_field(carom_engine *engine, const carom_height_field_desc *desc, carom_shape *shape, carom_error *error);
int32_t carom_shape_get_scenery_info(carom_engine *engine, carom_shape shape, carom_scenery_info *info, carom_error *error);
int32_t carom_shape_get_triangles(carom_engine *engine, carom_shape shape, uint64_t first, double *corners, uint64_t *count, uint64_t *next, carom_error *error);
int32_t carom_shape_create(carom_engine *engine, carom_plugin plugin, const double *params, uint64_t count, carom_shape *shape, carom_error *error);
int32_t carom_shape_create_named(carom_engine *engine, const char *name, const double *params, uint64_t count, carom_shape *shape, carom_error *error);
int32_t carom_shape_create_half_space(carom_engine *engine, const double *normal, double offset, carom_shape *shape, carom_error *error);
int32_t carom_shape_create_hull_of(carom_engine *engine, const carom_shape *parts, uint64_t count, const double *positions, const double *orientations, const double *scales, double radius, carom_shape *shape, carom_error *error);
int32_t carom_shape_get_parts(carom_engine *engine, carom_shape shape, carom_shape *parts, double *positions, double *orientations, double *scales, uint64_t *count, double *radius, carom_error *error);
int32_t carom_shape_destroy(carom_engine *engine, carom_shape shape, carom_error *error);
int32_t carom_shape_get_info(carom_engine *engine, carom_shape shape, carom_shape_info *info, carom_error *error);
int32_t carom_shape_get_params(carom_engine *engine, carom_shape shape, double *params, uint64_t *count, carom_error *error);
int32_t carom_shape_support(carom_engine *engine, carom_shape shape, const double *dirs, uint64_t n, double *points, carom_error *error);
int32_t carom_world_save(carom_world *world, uint32_t flags, void *buffer, uint64_t capacity, uint64_t *needed, carom_error *error);
int32_t carom_world_restore(carom_world *world, const void *bytes, uint64_t size, carom_error *error);
int32_t carom_world_fork(carom_world *world, carom_world **copy, carom_error *error);
int32_t carom_world_translate_handles(carom_world *world, const uint64_t *handles, uint64_t n, uint64_t *translated, carom_error *error);
int32_t carom_tree_get_coordinates(carom_world *world, carom_body body, carom_tree_coordinate *dst, uint64_t stride, uint64_t capacity, uint64_t *count, carom_error *error);
int32_t carom_tree_get_speeds(carom_world *world, carom_body body, double *speeds, uint64_t n, carom_error *error);
int32_t carom_tree_get_forces(carom_world *world, carom_body body, const double *speeds, const double *accelerations, double *forces, uint64_t n, carom_error *error);
int32_t carom_tree_get_mass(carom_world *world, carom_body body, double *mass, uint64_t n, carom_error *error);
int32_t carom_vehicle_desc_init(carom_vehicle_desc *desc, uint32_t struct_size);
int32_t carom_wheel_desc_init(carom_wheel_desc *desc, uint32_t struct_size);
int32_t carom_vehicle_input_init(carom_vehicle_input *input, uint32_t struct_size);
int32_t carom_vehicle_init(carom_vehicle *vehicle, uint32_t struct_size);
int32_t carom_wheel_init(carom_wheel *wheel, uint32_t struct_size);
int32_t carom_vehicle_drive(carom_world *world, const carom_vehicle_desc *desc, const carom_wheel_desc *wheel_descs, uint64_t n, const carom_vehicle_input *input, carom_vehicle *vehicle, carom_wheel *wheels, double dt, carom_error *error);
int32_t carom_world_desc_init(carom_world_desc *desc, uint32_t struct_size);
int32_t carom_world_create(carom_engine *engine, const carom_world_desc *desc, carom_world **world, carom_error *error);
int32_t carom_world_destroy(carom_world *world, carom_error *error);
int32_t carom_world_step(carom_world *world, double dt, carom_error *error);
int32_t carom_world_set_dial(carom_world *world, uint32_t dial, double value, carom_error *error);
int32_t carom_world_get_dial(carom_world *world, uint32_t dial, double *value, carom_error *error);
int32_t carom_world_set_preset(carom_world *world, uint32_t preset, carom_error *error);
int32_t carom_world_set_gravity(carom_world *world, const double *gravity, carom_error *error);
int32_t carom_world_get_gravity(carom_world *world, double *gravity, carom_error *error);
int32_t carom_world_get_report(carom_world *world, carom_step_report *report, carom_error *error);
const char *carom_stage_name(uint32_t stage);
int32_t carom_world_get_contacts(carom_world *world, carom_contact *dst, uint64_t stride, uint64_t capacity, uint64_t *count, carom_error *error);
int32_t carom_world_get_groups(carom_world *world, carom_group *dst, uint64_t stride, uint64_t capacity, uint64_t *count, carom_error *error);
int32_t carom_world_get_faults(carom_world *world, carom_fault *dst, uint64_t stride, uint64_t capacity, uint64_t *count, carom_error *error);
int32_t carom_world_hash(carom_world *world, uint64_t *hash, carom_error *error);
int32_t carom_query_desc_init(carom_query_desc *desc, uint32_t struct_size);
int32_t carom_world_cast_ray(carom_world *world, const double *origin, const double *direction, double max, const carom_query_desc *desc, carom_world_hit *hit, uint64_t size, carom_error *error);
int32_t carom_world_cast_rays(carom_world *world, const carom_rays *rays, uint32_t want, const carom_query_desc *desc, const carom_world_hits *hits, carom_error *error);
int32_t carom_world_cast_rays_all(carom_world *world, const carom_rays *rays, const carom_query_desc *desc, carom_world_hit *dst, uint64_t stride, uint64_t capacity, uint64_t *count, carom_error *error);
int32_t carom_world_cast_shapes(carom_world *world, const carom_query_shapes *shapes, uint32_t want, const carom_query_desc *desc, carom_world_hit *dst, uint64_t stride, carom_error *error);
int32_t carom_world_cast_shapes_all(carom_world *world, const carom_query_shapes *shapes, const carom_query_desc *desc, carom_world_hit *dst, uint64_t stride, uint64_t capacity, uint64_t *count, carom_error *error);
int32_t carom_world_overlap_shapes(carom_world *world, const carom_query_shapes *shapes, const carom_query_desc *desc, carom_world_hit *dst, uint64_t stride, uint64_t capacity, uint64_t *count, carom_error *error);
int32_t carom_world_find_nearest(carom_world *world, const carom_query_shapes *shapes, double reach, const carom_query_desc *desc, carom_world_hit *dst, uint64_t stride, carom_error *error);
]]
return {
  CAROM_VERSION_MAJOR = 0,
  CAROM_VERSION_MINOR = 9,
  CAROM_VERSION_PATCH = 0,
  CAROM_OK = 0,
  CAROM_E_NULL_ARGUMENT = -1,
  CAROM_E_NOT_FINITE = -2,
  CAROM_E_OUT_OF_RANGE = -3,
  CAROM_E_NOT_UNIT = -4,
  CAROM_E_UNKNOWN_ENUM = -5,
  CAROM_E_STRUCT_SIZE = -6,
  CAROM_E_UNSUPPORTED = -7,
  CAROM_E_INVALID_HANDLE = -8,
  CAROM_E_STALE_HANDLE = -9,
  CAROM_E_WRONG_KIND = -10,
  CAROM_E_WRONG_WORLD = -11,
  CAROM_E_BUSY = -12,
  CAROM_E_REENTRANT = -13,
  CAROM_E_IN_USE = -14,
  CAROM_E_OUT_OF_MEMORY = -15,
  CAROM_E_LIMIT = -16,
  CAROM_E_BUFFER_TOO_SMALL = -17,
  CAROM_E_PLUGIN_PATH = -18,
  CAROM_E_PLUGIN_LOAD = -19,
  CAROM_E_PLUGIN_ABI = -20,
  CAROM_E_PLUGIN_INVALID = -21,
  CAROM_E_DECLARATION_FALSE = -22,
  CAROM_E_NO_VOLUME = -23,
  CAROM_E_ALREADY_EXISTS = -24,
  CAROM_E_NOT_FOUND = -25,
  CAROM_E_INTERNAL = -26,
  CAROM_E_CORRUPT = -27,
  CAROM_E_MISMATCH = -28,
  CAROM_E_WRITE_FAILED = -29,
  CAROM_E_READ_ONLY = -30,
  CAROM_NULL_HANDLE = 0x0ULL,
  CAROM_SCALAR_F32 = 0,
  CAROM_SCALAR_F64 = 1,
  CAROM_ISLAND_ESTIMATED = 1,
  CAROM_ISLAND_BOUND = 2,
  CAROM_ISLAND_JOINTS_ALONE = 4,
  CAROM_ISLAND_STALLED = 8,
  CAROM_COLUMN_BODIES = 0,
  CAROM_COLUMN_JOINTS = 1,
  CAROM_COLUMN_MASSES = 2,
  CAROM_COLUMN_MATERIALS = 3,
  CAROM_COLUMN_GRAVITY = 4,
  CAROM_COLUMN_TIME = 5,
  CAROM_COLUMN_CONTACT_FORCES = 6,
  CAROM_COLUMN_RAYS = 7,
  CAROM_COLUMN_COUNT = 8,
  CAROM_WHEN_ON_CALL = 0,
  CAROM_WHEN_BEFORE_STEP = 1,
  CAROM_WHEN_AFTER_STEP = 2,
  CAROM_WHEN_COUNT = 3,
  CAROM_STOPPED_NO = 0,
  CAROM_STOPPED_FAULT = 1,
  CAROM_STOPPED_MEMORY = 2,
  CAROM_RANDOM_UNIFORM = 0,
  CAROM_RANDOM_NORMAL = 1,
  CAROM_RANDOM_COUNT = 2,
  CAROM_MIX_GEOMETRIC_MEAN = 0,
  CAROM_MIX_MAXIMUM = 1,
  CAROM_MIX_MINIMUM = 2,
  CAROM_MIX_AVERAGE = 3,
  CAROM_MIX_MULTIPLY = 4,
  CAROM_BODY_STATIC = 0,
  CAROM_BODY_KINEMATIC = 1,
  CAROM_BODY_DYNAMIC = 2,
  CAROM_BODY_FIELD_MASS = 1,
  CAROM_BODY_FIELD_CENTER = 2,
  CAROM_BODY_FIELD_INERTIA = 4,
  CAROM_BODY_STAYS_AWAKE = 8,
  CAROM_BODY_DISABLED = 16,
  CAROM_LOCK_LINEAR_X = 1,
  CAROM_LOCK_LINEAR_Y = 2,
  CAROM_LOCK_LINEAR_Z = 4,
  CAROM_LOCK_ANGULAR_X = 8,
  CAROM_LOCK_ANGULAR_Y = 16,
  CAROM_LOCK_ANGULAR_Z = 32,
  CAROM_LOCK_ALL = 63,
  CAROM_LOCK_PLANE = 28,
  CAROM_ATTRIBUTE_GRAVITY_FACTOR = 0,
  CAROM_ATTRIBUTE_LOCKS = 1,
  CAROM_ATTRIBUTE_DRAG = 2,
  CAROM_ATTRIBUTE_FORCE_FIELD_MASK = 3,
  CAROM_ATTRIBUTE_MAGNETIC_MOMENT = 4,
  CAROM_ATTRIBUTE_COUNT = 5,
  CAROM_ATTRIBUTE_NUMBERS = 4,
  CAROM_CONTINUOUS_AUTO = 0,
  CAROM_CONTINUOUS_ALWAYS = 1,
  CAROM_CONTINUOUS_NEVER = 2,
  CAROM_FILTER_CATEGORY = 0x1ULL,
  CAROM_FILTER_MASK = 0xffffffffffffffffULL,
  CAROM_FIELD_POSITION = 0,
  CAROM_FIELD_ORIENTATION = 1,
  CAROM_FIELD_POSE = 2,
  CAROM_FIELD_LINEAR_VELOCITY = 3,
  CAROM_FIELD_ANGULAR_VELOCITY = 4,
  CAROM_FIELD_VELOCITY = 5,
  CAROM_FIELD_FORCE = 6,
  CAROM_FIELD_CENTER = 7,
  CAROM_FIELD_MASS = 8,
  CAROM_FIELD_COUNT = 9,
  CAROM_CAST_MISS = 0,
  CAROM_CAST_HIT = 1,
  CAROM_CAST_OVERLAP = 2,
  CAROM_CAST_UNDECIDED = 3,
  CAROM_CAST_BAD_RAY = 4,
  CAROM_ASK_GENERIC = 1,
  CAROM_ASK_SENSORS = 2,
  CAROM_ASK_IGNORE_TOUCHED = 4,
  CAROM_OVERLAP_APART = 0,
  CAROM_OVERLAP_OVERLAPPING = 1,
  CAROM_OVERLAP_TOUCHING = 2,
  CAROM_OVERLAP_FAULT = 3,
  CAROM_NO_SHAPE = 4294967295,
  CAROM_GROUND_AIR = 0,
  CAROM_GROUND_STEEP = 1,
  CAROM_GROUND_FIRM = 2,
  CAROM_CHARACTER_TURNS = 1,
  CAROM_CHARACTER_FLIES = 2,
  CAROM_CHARACTER_CONTACTS = 8,
  CAROM_DIAL_INTEGRATOR = 0,
  CAROM_DIAL_ROTATION = 1,
  CAROM_DIAL_SUBSTEPS = 2,
  CAROM_DIAL_SOLVER = 3,
  CAROM_DIAL_VELOCITY_ITERATIONS = 4,
  CAROM_DIAL_POSITION_ITERATIONS = 5,
  CAROM_DIAL_VELOCITY_TOLERANCE = 6,
  CAROM_DIAL_POSITION_TOLERANCE = 7,
  CAROM_DIAL_RESTITUTION_SPEED = 8,
  CAROM_DIAL_SEVERITY_SEARCH = 9,
  CAROM_DIAL_GROUPS = 10,
  CAROM_DIAL_BROAD_PHASE = 11,
  CAROM_DIAL_GRID_CELL = 12,
  CAROM_DIAL_CONTACT_DISTANCE = 13,
  CAROM_DIAL_PAIR_ROUTINES = 14,
  CAROM_DIAL_NARROW_PHASE = 15,
  CAROM_DIAL_SIMPLEX = 16,
  CAROM_DIAL_GJK_TOLERANCE = 17,
  CAROM_DIAL_GJK_ITERATIONS = 18,
  CAROM_DIAL_EPA_ITERATIONS = 19,
  CAROM_DIAL_HYBRID_MARGIN = 20,
  CAROM_DIAL_WARM_SEPARATION = 21,
  CAROM_DIAL_MANIFOLD = 22,
  CAROM_DIAL_CACHE_DISTANCE = 23,
  CAROM_DIAL_WARM_START = 24,
  CAROM_DIAL_CARRY_OVER = 25,
  CAROM_DIAL_CONTACT_FREQUENCY = 26,
  CAROM_DIAL_CONTACT_DAMPING = 27,
  CAROM_DIAL_PUSH_SPEED = 28,
  CAROM_DIAL_SLEEP = 29,
  CAROM_DIAL_SLEEP_SPEED = 30,
  CAROM_DIAL_SLEEP_TIME = 31,
  CAROM_DIAL_DIRECT_SINK = 32,
  CAROM_DIAL_DIRECT_RATIO = 33,
  CAROM_DIAL_DIRECT_WORK = 34,
  CAROM_DIAL_HOLD_ANGLE = 35,
  CAROM_DIAL_JOINT_FREQUENCY = 36,
  CAROM_DIAL_JOINT_DAMPING = 37,
  CAROM_DIAL_CONTINUOUS = 38,
  CAROM_DIAL_PRECISION = 39,
  CAROM_DIAL_JOINT_ORDER = 40,
  CAROM_DIAL_ACCURACY_PLACE = 41,
  CAROM_DIAL_ACCURACY_TURN = 42,
  CAROM_DIAL_ACCURACY_SUBSTEPS = 43,
  CAROM_DIAL_ACCURACY_WORK = 44,
  CAROM_DIAL_KEEP_DISTANCE = 45,
  CAROM_DIAL_COUNT = 46,
  CAROM_INTEGRATOR_EXPLICIT_EULER = 0,
  CAROM_INTEGRATOR_SEMI_IMPLICIT_EULER = 1,
  CAROM_INTEGRATOR_RK4 = 2,
  CAROM_INTEGRATOR_VELOCITY_VERLET = 3,
  CAROM_ROTATION_NONE = 0,
  CAROM_ROTATION_EXPLICIT = 1,
  CAROM_ROTATION_IMPLICIT = 2,
  CAROM_ROTATION_RK4 = 3,
  CAROM_ROTATION_LIE_MIDPOINT = 4,
  CAROM_ROTATION_SPLITTING = 5,
  CAROM_ROTATION_SPLITTING_4 = 6,
  CAROM_ROTATION_SPLITTING_6 = 7,
  CAROM_SOLVER_SEVERITY = 0,
  CAROM_SOLVER_SOFT_STEP = 1,
  CAROM_SOLVER_DIRECT = 2,
  CAROM_SOLVER_AUTO = 3,
  CAROM_SEARCH_LINEAR = 0,
  CAROM_SEARCH_HEAP = 1,
  CAROM_BROAD_BRUTE_FORCE = 0,
  CAROM_BROAD_SWEEP_AND_PRUNE = 1,
  CAROM_BROAD_GRID = 2,
  CAROM_BROAD_TREE = 3,
  CAROM_NARROW_HYBRID = 0,
  CAROM_NARROW_GJK_EPA = 1,
  CAROM_SIMPLEX_JOHNSON = 0,
  CAROM_SIMPLEX_VORONOI = 1,
  CAROM_SIMPLEX_VORONOI_LAST = 2,
  CAROM_MANIFOLD_SINGLE = 0,
  CAROM_MANIFOLD_CACHE = 1,
  CAROM_MANIFOLD_PATCH = 2,
  CAROM_MANIFOLD_CLIP = 3,
  CAROM_SWEEP_NONE = 0,
  CAROM_SWEEP_FLAGGED = 1,
  CAROM_SWEEP_FAST = 2,
  CAROM_PRECISION_FLOAT = 0,
  CAROM_PRECISION_AUTO = 1,
  CAROM_PRECISION_DOUBLE = 2,
  CAROM_PRESET_FAST = 0,
  CAROM_PRESET_BALANCED = 1,
  CAROM_PRESET_ACCURATE = 2,
  CAROM_PRESET_REFERENCE = 3,
  CAROM_PRESET_COUNT = 4,
  CAROM_DIAL_KIND_NUMBER = 0,
  CAROM_DIAL_KIND_INTEGER = 1,
  CAROM_DIAL_KIND_CHOICE = 2,
  CAROM_DRAW_SHAPES = 1,
  CAROM_DRAW_SCENERY = 2,
  CAROM_DRAW_BOUNDS = 4,
  CAROM_DRAW_CONTACTS = 8,
  CAROM_DRAW_JOINTS = 16,
  CAROM_DRAW_BODIES = 32,
  CAROM_DRAW_BY_TYPE = 0,
  CAROM_DRAW_BY_ISLAND = 1,
  CAROM_LOG_INFO = 1,
  CAROM_LOG_WARNING = 2,
  CAROM_LOG_ERROR = 3,
  CAROM_EVENTS_CONTACT = 1,
  CAROM_EVENTS_SENSOR = 2,
  CAROM_EVENTS_SLEEP = 4,
  CAROM_EVENTS_JOINT = 8,
  CAROM_EVENTS_FAULT = 16,
  CAROM_CONTACT_BEGIN = 0,
  CAROM_CONTACT_END = 1,
  CAROM_CONTACT_HIT = 2,
  CAROM_SENSOR_ENTER = 0,
  CAROM_SENSOR_LEAVE = 1,
  CAROM_SLEEP_ASLEEP = 0,
  CAROM_SLEEP_AWAKE = 1,
  CAROM_FORCE_FIELD_UNIFORM = 0,
  CAROM_FORCE_FIELD_RADIAL = 1,
  CAROM_FORCE_FIELD_VORTEX = 2,
  CAROM_FORCE_FIELD_MAGNETIC = 3,
  CAROM_FORCE_FIELD_COUNT = 4,
  CAROM_JOINT_BALL = 0,
  CAROM_JOINT_HINGE = 1,
  CAROM_JOINT_SLIDER = 2,
  CAROM_JOINT_WELD = 3,
  CAROM_JOINT_DISTANCE = 4,
  CAROM_JOINT_UNIVERSAL = 5,
  CAROM_JOINT_PULLEY = 6,
  CAROM_JOINT_GEAR = 7,
  CAROM_JOINT_SIX_AXIS = 8,
  CAROM_JOINT_COUPLING = 9,
  CAROM_JOINT_COUNT = 10,
  CAROM_COORDINATE_TWIST = 0,
  CAROM_COORDINATE_SWING = 1,
  CAROM_COORDINATE_SLIDE = 2,
  CAROM_COORDINATE_DISTANCE = 3,
  CAROM_COORDINATE_COUNT = 4,
  CAROM_AXIS_X = 0,
  CAROM_AXIS_Y = 1,
  CAROM_AXIS_Z = 2,
  CAROM_AXIS_TURN_X = 3,
  CAROM_AXIS_TURN_Y = 4,
  CAROM_AXIS_TURN_Z = 5,
  CAROM_AXIS_COUNT = 6,
  CAROM_AXIS_MODE_FREE = 0,
  CAROM_AXIS_MODE_LOCKED = 1,
  CAROM_AXIS_MODE_LIMITED = 2,
  CAROM_AXIS_MODE_COUNT = 3,
  CAROM_DRIVE_NONE = 0,
  CAROM_DRIVE_POSITION = 1,
  CAROM_DRIVE_VELOCITY = 2,
  CAROM_DRIVE_EFFORT = 3,
  CAROM_DRIVE_COUNT = 4,
  CAROM_GAINS_FREQUENCY = 0,
  CAROM_GAINS_FORCE = 1,
  CAROM_GAINS_ACCELERATION = 2,
  CAROM_GAINS_COUNT = 3,
  CAROM_JOINT_WORLD_FRAME = 1,
  CAROM_JOINT_COLLIDE = 2,
  CAROM_JOINT_FIELD_LENGTH = 4,
  CAROM_JOINT_ACCELERATIONS = 8,
  CAROM_JOINT_BULK_COORDINATES = 0,
  CAROM_JOINT_BULK_SPEEDS = 1,
  CAROM_JOINT_BULK_AXES = 2,
  CAROM_JOINT_BULK_AXIS_SPEEDS = 3,
  CAROM_JOINT_BULK_FORCE = 4,
  CAROM_JOINT_BULK_TORQUE = 5,
  CAROM_JOINT_BULK_ERROR = 6,
  CAROM_JOINT_BULK_BROKEN = 7,
  CAROM_JOINT_BULK_POSITION = 8,
  CAROM_JOINT_BULK_VELOCITY = 9,
  CAROM_JOINT_BULK_EFFORT = 10,
  CAROM_JOINT_BULK_TARGET = 11,
  CAROM_JOINT_BULK_TARGET_VELOCITY = 12,
  CAROM_JOINT_BULK_TARGET_EFFORT = 13,
  CAROM_JOINT_BULK_MOTOR = 14,
  CAROM_JOINT_BULK_SPRING = 15,
  CAROM_JOINT_BULK_LIMIT = 16,
  CAROM_JOINT_BULK_AXIS_EFFORTS = 17,
  CAROM_JOINT_BULK_AXIS_TARGETS = 18,
  CAROM_JOINT_BULK_AXIS_TARGET_VELOCITIES = 19,
  CAROM_JOINT_BULK_AXIS_TARGET_EFFORTS = 20,
  CAROM_JOINT_BULK_AXIS_MAX_FORCES = 21,
  CAROM_JOINT_BULK_AXIS_GAINS = 22,
  CAROM_JOINT_BULK_AXIS_LIMITS = 23,
  CAROM_JOINT_BULK_ORIENTATION_TARGET = 24,
  CAROM_JOINT_BULK_ORIENTATION_VELOCITY = 25,
  CAROM_JOINT_BULK_ORIENTATION_EFFORT = 26,
  CAROM_JOINT_BULK_ORIENTATION_GAINS = 27,
  CAROM_JOINT_BULK_ACCELERATION = 28,
  CAROM_JOINT_BULK_AXIS_ACCELERATIONS = 29,
  CAROM_JOINT_BULK_AXIS_FRICTIONS = 30,
  CAROM_JOINT_BULK_AXIS_ARMATURES = 31,
  CAROM_JOINT_BULK_AXIS_EFFORT_LIMITS = 32,
  CAROM_JOINT_BULK_AXIS_SPEED_LIMITS = 33,
  CAROM_JOINT_BULK_FRICTION = 34,
  CAROM_JOINT_BULK_ARMATURE = 35,
  CAROM_JOINT_BULK_EFFORT_LIMIT = 36,
  CAROM_JOINT_BULK_SPEED_LIMIT = 37,
  CAROM_JOINT_BULK_DRIVE_TARGET = 38,
  CAROM_JOINT_BULK_DRIVE_VELOCITY = 39,
  CAROM_JOINT_BULK_DRIVE_EFFORT = 40,
  CAROM_JOINT_BULK_DRIVE_MAX_FORCE = 41,
  CAROM_JOINT_BULK_DRIVE_GAINS = 42,
  CAROM_JOINT_BULK_COUNT = 43,
  CAROM_EFFECT_GYROSCOPIC = 0,
  CAROM_EFFECT_LINEAR_DAMPING = 1,
  CAROM_EFFECT_ANGULAR_DAMPING = 2,
  CAROM_EFFECT_GRAVITY = 3,
  CAROM_EFFECT_USER_FORCE = 4,
  CAROM_EFFECT_USER_TORQUE = 5,
  CAROM_EFFECT_COLLISION = 6,
  CAROM_EFFECT_FRICTION = 7,
  CAROM_EFFECT_RESTITUTION = 8,
  CAROM_EFFECT_ROLLING_RESISTANCE = 9,
  CAROM_EFFECT_SPINNING_RESISTANCE = 10,
  CAROM_EFFECT_SLEEP = 11,
  CAROM_EFFECT_PARTICLES = 12,
  CAROM_EFFECT_FILTER = 13,
  CAROM_EFFECT_SENSOR = 14,
  CAROM_EFFECT_JOINTS = 15,
  CAROM_EFFECT_SCENERY = 16,
  CAROM_EFFECT_CONTINUOUS = 17,
  CAROM_EFFECT_SURFACE_VELOCITY = 18,
  CAROM_EFFECT_AXIS_LOCKS = 19,
  CAROM_EFFECT_DRAG = 20,
  CAROM_EFFECT_WIND = 21,
  CAROM_EFFECT_FIELDS = 22,
  CAROM_EFFECT_SPRINGS = 23,
  CAROM_EFFECT_BUOYANCY = 24,
  CAROM_EFFECT_RESPONSE = 25,
  CAROM_EFFECT_JOINT_LIMITS = 26,
  CAROM_EFFECT_JOINT_MOTORS = 27,
  CAROM_EFFECT_EVENTS = 28,
  CAROM_EFFECT_LEDGER = 29,
  CAROM_EFFECT_MAGNETISM = 30,
  CAROM_EFFECT_COUNT = 31,
  CAROM_MODE_AS_NEEDED = 0,
  CAROM_MODE_FORBID = 1,
  CAROM_MODE_FORCE = 2,
  CAROM_PLAN_NO_EFFECT = 4294967295,
  CAROM_TIME_OWN = 0,
  CAROM_TIME_IN_STAGE = 1,
  CAROM_TIME_OFF = 2,
  CAROM_PLUGIN_ABI_MAJOR = 1,
  CAROM_PLUGIN_ABI_MINOR = 0,
  CAROM_FORM_NONE = 0,
  CAROM_FORM_SPHERE = 1,
  CAROM_FORM_CAPSULE = 2,
  CAROM_FORM_BOX = 3,
  CAROM_FORM_POLYTOPE = 4,
  CAROM_FORM_CYLINDER = 5,
  CAROM_FORM_CONE = 6,
  CAROM_FORM_ELLIPSOID = 7,
  CAROM_NO_PARAM = 4294967295,
  CAROM_PLUGIN_HOST_THREAD = 1,
  CAROM_SHAPE_PLUGIN_SYMBOL = "carom_shape_plugin_v1",
  CAROM_QUERY_EXACT_ENOUGH = 0,
  CAROM_QUERY_CAPPED = 1,
  CAROM_QUERY_ROUNDING = 2,
  CAROM_QUERY_FAULT = 3,
  CAROM_RECORD_HASHES = 0,
  CAROM_RECORD_STATES = 1,
  CAROM_SCENERY_TWO_SIDED = 1,
  CAROM_SNAPSHOT_STATE = 0,
  CAROM_SNAPSHOT_WHOLE = 1,
  CAROM_VEHICLE_AUTOMATIC = 1,
  CAROM_VEHICLE_ACKERMANN = 2,
  CAROM_VEHICLE_WHEELS = 16,
  CAROM_NO_WHEEL = 4294967295,
  CAROM_STAGE_REFRESH = 0,
  CAROM_STAGE_BROAD = 1,
  CAROM_STAGE_NARROW = 2,
  CAROM_STAGE_GROUP = 3,
  CAROM_STAGE_INTEGRATE = 4,
  CAROM_STAGE_SOLVE = 5,
  CAROM_STAGE_RELAX = 6,
  CAROM_STAGE_OBSERVE = 7,
  CAROM_STAGE_COUNT = 8,
  CAROM_REASON_ORDINARY = 0,
  CAROM_REASON_MASS_RATIO = 1,
  CAROM_REASON_SINK = 2,
  CAROM_REASON_TOO_MUCH = 3,
  CAROM_REASON_IMPACT = 4,
  CAROM_REASON_FEW = 5,
  CAROM_FAULT_RETURNED = 1,
  CAROM_FAULT_NOT_FINITE = 2,
  CAROM_FAULT_OUTSIDE = 3,
  CAROM_FAULT_NOT_SUPPORT = 4,
  CAROM_FAULT_BODY_STATE = 5,
  CAROM_FAULT_PARTICLE_STATE = 6,
  CAROM_WANT_FIRST = 0,
  CAROM_WANT_ANY = 1,
  VERSION = "0.9.0",
  ROWS = 838, -- of the layout manifest
}
