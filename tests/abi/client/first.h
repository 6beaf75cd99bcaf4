/* The interface of version 0.9, as a header of it declared it that had shorter structs: descriptors without what came to their
 * ends. This follows the headers until 1.0 is frozen. From then on
 * it is never edited: a program that was compiled against it runs for ever. */
#ifndef FIRST_H
#define FIRST_H
#include <stdint.h>

#define CAROM_VERSION_MAJOR 0u
#define CAROM_VERSION_MINOR 9u
#define CAROM_VERSION_PATCH 0u
#define CAROM_OK 0
#define CAROM_E_NULL_ARGUMENT (-1)
#define CAROM_E_NOT_FINITE (-2)
#define CAROM_E_OUT_OF_RANGE (-3)
#define CAROM_E_NOT_UNIT (-4)
#define CAROM_E_UNKNOWN_ENUM (-5)
#define CAROM_E_STRUCT_SIZE (-6)
#define CAROM_E_UNSUPPORTED (-7)
#define CAROM_E_INVALID_HANDLE (-8)
#define CAROM_E_STALE_HANDLE (-9)
#define CAROM_E_WRONG_KIND (-10)
#define CAROM_E_WRONG_WORLD (-11)
#define CAROM_E_BUSY (-12)
#define CAROM_E_REENTRANT (-13)
#define CAROM_E_IN_USE (-14)
#define CAROM_E_OUT_OF_MEMORY (-15)
#define CAROM_E_LIMIT (-16)
#define CAROM_E_BUFFER_TOO_SMALL (-17)
#define CAROM_E_PLUGIN_PATH (-18)
#define CAROM_E_PLUGIN_LOAD (-19)
#define CAROM_E_PLUGIN_ABI (-20)
#define CAROM_E_PLUGIN_INVALID (-21)
#define CAROM_E_DECLARATION_FALSE (-22)
#define CAROM_E_NO_VOLUME (-23)
#define CAROM_E_ALREADY_EXISTS (-24)
#define CAROM_E_NOT_FOUND (-25)
#define CAROM_E_INTERNAL (-26)
typedef struct carom_error {
  uint32_t struct_size;
  int32_t code;
  int32_t argument;
  uint32_t has_witness;
  double witness_dir[3];
  double witness_out[3];
  char message[256];
  char remedy[256];
} carom_error;
#define CAROM_ERROR_INIT                                           \
  {                                                                \
    sizeof(carom_error), 0, 0, 0, {0, 0, 0}, {0, 0, 0}, {0}, { 0 } \
  }
typedef uint64_t carom_plugin;
typedef uint64_t carom_shape;
typedef uint64_t carom_material;
typedef uint64_t carom_body;
typedef uint64_t carom_collider;
#define CAROM_NULL_HANDLE ((uint64_t)0)
int32_t carom_version(uint32_t* major, uint32_t* minor, uint32_t* patch);
const char* carom_result_name(int32_t result);
const char* carom_result_remedy(int32_t result);
#define CAROM_PLUGIN_ABI_MAJOR 1u
#define CAROM_PLUGIN_ABI_MINOR 0u
typedef int32_t (*carom_support_fn)(void* user, const double* params, uint64_t param_len, const double dir[3],
                                    double out[3]);
typedef struct carom_param {
  const char* name;
  const char* unit;
  double min;
  double max;
} carom_param;
#define CAROM_FORM_NONE 0u
#define CAROM_FORM_SPHERE 1u
#define CAROM_FORM_CAPSULE 2u
#define CAROM_FORM_BOX 3u
#define CAROM_FORM_POLYTOPE 4u
#define CAROM_FORM_CYLINDER 5u
#define CAROM_FORM_CONE 6u
#define CAROM_FORM_ELLIPSOID 7u
#define CAROM_NO_PARAM 0xFFFFFFFFu
typedef struct carom_geometry {
  uint32_t struct_size;
  uint32_t form;
  uint32_t form_arg[4];
  uint32_t core_radius_param;
  uint32_t mass_form;
  uint32_t mass_arg[4];
} carom_geometry;
#define CAROM_PLUGIN_HOST_THREAD 1u
typedef struct carom_shape_plugin {
  uint32_t struct_size;
  uint32_t abi_major;
  uint32_t abi_minor;
  uint32_t flags;
  const char* id;
  uint32_t version;
  uint32_t param_count;
  const carom_param* params;
  const carom_geometry* geometry;
  carom_support_fn support;
  uint32_t param_tail_group;
  uint32_t param_tail_min;
} carom_shape_plugin;
#define CAROM_SHAPE_PLUGIN_SYMBOL "carom_shape_plugin_v1"
typedef struct carom_engine carom_engine;
#define CAROM_LOG_INFO 1u
#define CAROM_LOG_WARNING 2u
#define CAROM_LOG_ERROR 3u
typedef struct carom_engine_desc {
  uint32_t struct_size;
  uint32_t reserved;
  void* (*alloc)(void* user, uint64_t size, uint64_t alignment);
  void (*free)(void* user, void* pointer, uint64_t size, uint64_t alignment);
  void* alloc_user;
  void (*log)(void* user, uint32_t level, const char* text);
  void* log_user;
} carom_engine_desc;
int32_t carom_engine_desc_init(carom_engine_desc* desc, uint32_t struct_size);
int32_t carom_engine_create(const carom_engine_desc* desc, carom_engine** engine, carom_error* error);
int32_t carom_engine_destroy(carom_engine* engine, carom_error* error);
int32_t carom_plugin_load(carom_engine* engine, const char* path, carom_plugin* plugin, carom_error* error);
int32_t carom_plugin_register(carom_engine* engine, const carom_shape_plugin* description, carom_plugin* plugin,
                              carom_error* error);
int32_t carom_plugin_unload(carom_engine* engine, carom_plugin plugin, carom_error* error);
int32_t carom_plugin_find(carom_engine* engine, const char* id, carom_plugin* plugin, carom_error* error);
int32_t carom_plugin_describe(carom_engine* engine, carom_plugin plugin, const carom_shape_plugin** description,
                              carom_error* error);
int32_t carom_shape_create(carom_engine* engine, carom_plugin plugin, const double* params, uint64_t count,
                           carom_shape* shape, carom_error* error);
int32_t carom_shape_create_half_space(carom_engine* engine, const double normal[3], double offset, carom_shape* shape,
                                      carom_error* error);
int32_t carom_shape_destroy(carom_engine* engine, carom_shape shape, carom_error* error);
typedef struct carom_shape_info {
  uint32_t struct_size;
  uint32_t form;
  uint32_t is_half_space;
  uint32_t mass_exact;
  carom_plugin plugin;
  uint64_t param_count;
  double core_radius;
  double bounding_radius;
  double aabb_min[3];
  double aabb_max[3];
  double volume;
  double volume_min;
  double volume_max;
  double centroid[3];
  double centroid_error;
  double inertia[9];
  double inertia_error;
} carom_shape_info;
int32_t carom_shape_get_info(carom_engine* engine, carom_shape shape, carom_shape_info* info, carom_error* error);
int32_t carom_shape_get_params(carom_engine* engine, carom_shape shape, double* params, uint64_t* count,
                               carom_error* error);
int32_t carom_shape_support(carom_engine* engine, carom_shape shape, const double* dirs, uint64_t n, double* points,
                            carom_error* error);
#define CAROM_DIAL_INTEGRATOR 0u
#define CAROM_DIAL_ROTATION 1u
#define CAROM_DIAL_SUBSTEPS 2u
#define CAROM_DIAL_SOLVER 3u
#define CAROM_DIAL_VELOCITY_ITERATIONS 4u
#define CAROM_DIAL_POSITION_ITERATIONS 5u
#define CAROM_DIAL_VELOCITY_TOLERANCE 6u
#define CAROM_DIAL_POSITION_TOLERANCE 7u
#define CAROM_DIAL_RESTITUTION_SPEED 8u
#define CAROM_DIAL_SEVERITY_SEARCH 9u
#define CAROM_DIAL_GROUPS 10u
#define CAROM_DIAL_BROAD_PHASE 11u
#define CAROM_DIAL_GRID_CELL 12u
#define CAROM_DIAL_CONTACT_DISTANCE 13u
#define CAROM_DIAL_PAIR_ROUTINES 14u
#define CAROM_DIAL_NARROW_PHASE 15u
#define CAROM_DIAL_SIMPLEX 16u
#define CAROM_DIAL_GJK_TOLERANCE 17u
#define CAROM_DIAL_GJK_ITERATIONS 18u
#define CAROM_DIAL_EPA_ITERATIONS 19u
#define CAROM_DIAL_HYBRID_MARGIN 20u
#define CAROM_DIAL_WARM_SEPARATION 21u
#define CAROM_DIAL_MANIFOLD 22u
#define CAROM_DIAL_CACHE_DISTANCE 23u
#define CAROM_DIAL_WARM_START 24u
#define CAROM_DIAL_CARRY_OVER 25u
#define CAROM_DIAL_COUNT 26u
#define CAROM_INTEGRATOR_EXPLICIT_EULER 0u
#define CAROM_INTEGRATOR_SEMI_IMPLICIT_EULER 1u
#define CAROM_INTEGRATOR_RK4 2u
#define CAROM_ROTATION_NONE 0u
#define CAROM_ROTATION_EXPLICIT 1u
#define CAROM_ROTATION_IMPLICIT 2u
#define CAROM_SOLVER_SEVERITY 0u
#define CAROM_SEARCH_LINEAR 0u
#define CAROM_SEARCH_HEAP 1u
#define CAROM_BROAD_BRUTE_FORCE 0u
#define CAROM_BROAD_SWEEP_AND_PRUNE 1u
#define CAROM_BROAD_GRID 2u
#define CAROM_NARROW_HYBRID 0u
#define CAROM_NARROW_GJK_EPA 1u
#define CAROM_SIMPLEX_JOHNSON 0u
#define CAROM_SIMPLEX_VORONOI 1u
#define CAROM_SIMPLEX_VORONOI_LAST 2u
#define CAROM_MANIFOLD_SINGLE 0u
#define CAROM_MANIFOLD_CACHE 1u
#define CAROM_MANIFOLD_PATCH 2u
#define CAROM_MANIFOLD_CLIP 3u
#define CAROM_DIAL_KIND_NUMBER 0u
#define CAROM_DIAL_KIND_INTEGER 1u
#define CAROM_DIAL_KIND_CHOICE 2u
typedef struct carom_dial_info {
  uint32_t struct_size;
  uint32_t dial;
  uint32_t kind;
  uint32_t choice_count;
  const char* name;
  const char* unit;
  const char* summary;
  const char* const* choices;
  double min;
  double max;
  double initial;
} carom_dial_info;
int32_t carom_dial_get_info(uint32_t dial, carom_dial_info* info, carom_error* error);
int32_t carom_dial_get_count(uint32_t* count);
int32_t carom_dial_find(const char* name, uint32_t* dial, carom_error* error);
typedef struct carom_world carom_world;
typedef struct carom_world_desc {
  uint32_t struct_size;
  uint32_t reserved;
  double gravity[3];
  uint64_t body_capacity;
} carom_world_desc;
int32_t carom_world_desc_init(carom_world_desc* desc, uint32_t struct_size);
int32_t carom_world_create(carom_engine* engine, const carom_world_desc* desc, carom_world** world, carom_error* error);
int32_t carom_world_destroy(carom_world* world, carom_error* error);
int32_t carom_world_step(carom_world* world, double dt, carom_error* error);
int32_t carom_world_set_dial(carom_world* world, uint32_t dial, double value, carom_error* error);
int32_t carom_world_get_dial(carom_world* world, uint32_t dial, double* value, carom_error* error);
int32_t carom_world_set_gravity(carom_world* world, const double gravity[3], carom_error* error);
int32_t carom_world_get_gravity(carom_world* world, double gravity[3], carom_error* error);
#define CAROM_STAGE_REFRESH 0u
#define CAROM_STAGE_BROAD 1u
#define CAROM_STAGE_NARROW 2u
#define CAROM_STAGE_GROUP 3u
#define CAROM_STAGE_INTEGRATE 4u
#define CAROM_STAGE_SOLVE 5u
#define CAROM_STAGE_RELAX 6u
#define CAROM_STAGE_OBSERVE 7u
#define CAROM_STAGE_COUNT 8u
typedef struct carom_step_report {
  uint32_t struct_size;
  uint32_t stage_count;
  double stage_seconds[16];
  double total_seconds;
  uint64_t steps;
  double time;
  uint64_t bodies;
  uint64_t dynamic_bodies;
  uint64_t colliders;
  uint64_t broad_pairs;
  uint64_t contact_pairs;
  uint64_t contact_points;
  uint64_t groups;
  uint64_t largest_group;
  uint64_t gjk_calls;
  uint64_t epa_calls;
  uint64_t support_calls;
  uint64_t velocity_impulses;
  uint64_t position_moves;
  uint64_t quarantined_bodies;
  uint64_t faults;
  double max_penetration;
  double mean_penetration;
  double max_closing_speed;
  double linear_energy;
  double angular_energy;
} carom_step_report;
int32_t carom_world_get_report(carom_world* world, carom_step_report* report, carom_error* error);
const char* carom_stage_name(uint32_t stage);
typedef struct carom_contact {
  carom_collider collider_a;
  carom_collider collider_b;
  carom_body body_a;
  carom_body body_b;
  double point[3];
  double normal[3];
  double separation;
  double normal_impulse;
  double friction_impulse;
} carom_contact;
int32_t carom_world_get_contacts(carom_world* world, carom_contact* dst, uint64_t stride, uint64_t capacity,
                                 uint64_t* count, carom_error* error);
#define CAROM_FAULT_RETURNED 1u
#define CAROM_FAULT_NOT_FINITE 2u
#define CAROM_FAULT_OUTSIDE 3u
#define CAROM_FAULT_NOT_SUPPORT 4u
#define CAROM_FAULT_BODY_STATE 5u
typedef struct carom_fault {
  uint32_t kind;
  uint32_t reserved;
  carom_shape shape;
  carom_body body;
  double dir[3];
  double out[3];
} carom_fault;
int32_t carom_world_get_faults(carom_world* world, carom_fault* dst, uint64_t stride, uint64_t capacity,
                               uint64_t* count, carom_error* error);
int32_t carom_world_hash(carom_world* world, uint64_t* hash, carom_error* error);
#define CAROM_MIX_GEOMETRIC_MEAN 0u
#define CAROM_MIX_MAXIMUM 1u
#define CAROM_MIX_MINIMUM 2u
#define CAROM_MIX_AVERAGE 3u
#define CAROM_MIX_MULTIPLY 4u
typedef struct carom_material_desc {
  uint32_t struct_size;
  uint32_t friction_mix;
  uint32_t restitution_mix;
  uint32_t reserved;
  double friction;
  double restitution;
} carom_material_desc;
int32_t carom_material_desc_init(carom_material_desc* desc, uint32_t struct_size);
int32_t carom_material_create(carom_world* world, const carom_material_desc* desc, carom_material* material,
                              carom_error* error);
int32_t carom_material_update(carom_world* world, carom_material material, const carom_material_desc* desc,
                              carom_error* error);
int32_t carom_material_destroy(carom_world* world, carom_material material, carom_error* error);
#define CAROM_BODY_STATIC 0u
#define CAROM_BODY_KINEMATIC 1u
#define CAROM_BODY_DYNAMIC 2u
#define CAROM_BODY_FIELD_MASS 1u
#define CAROM_BODY_FIELD_CENTER 2u
#define CAROM_BODY_FIELD_INERTIA 4u
typedef struct carom_body_desc {
  uint32_t struct_size;
  uint32_t fields;
  uint32_t type;
  uint32_t reserved;
  double position[3];
  double orientation[4];
  double linear_velocity[3];
  double angular_velocity[3];
  double mass;
  double center[3];
  double inertia[9];
  double linear_damping;
  double angular_damping;
  uint64_t user;
} carom_body_desc;
int32_t carom_body_desc_init(carom_body_desc* desc, uint32_t struct_size);
int32_t carom_body_create(carom_world* world, const carom_body_desc* desc, carom_body* body, carom_error* error);
int32_t carom_body_destroy(carom_world* world, carom_body body, carom_error* error);
int32_t carom_body_get(carom_world* world, carom_body body, carom_body_desc* desc, carom_error* error);
int32_t carom_body_set_pose(carom_world* world, carom_body body, const double position[3], const double orientation[4],
                            carom_error* error);
int32_t carom_body_set_velocity(carom_world* world, carom_body body, const double linear[3], const double angular[3],
                                carom_error* error);
int32_t carom_body_add_force(carom_world* world, carom_body body, const double force[3], const double torque[3],
                             carom_error* error);
int32_t carom_body_add_impulse(carom_world* world, carom_body body, const double impulse[3], const double point[3],
                               carom_error* error);
typedef struct carom_collider_desc {
  uint32_t struct_size;
  uint32_t reserved;
  carom_shape shape;
  carom_material material;
  double position[3];
  double orientation[4];
  double density;
} carom_collider_desc;
int32_t carom_collider_desc_init(carom_collider_desc* desc, uint32_t struct_size);
int32_t carom_collider_create(carom_world* world, carom_body body, const carom_collider_desc* desc,
                              carom_collider* collider, carom_error* error);
int32_t carom_collider_destroy(carom_world* world, carom_collider collider, carom_error* error);
int32_t carom_collider_get(carom_world* world, carom_collider collider, carom_collider_desc* desc, carom_body* body,
                           carom_error* error);
#define CAROM_FIELD_POSITION 0u
#define CAROM_FIELD_ORIENTATION 1u
#define CAROM_FIELD_POSE 2u
#define CAROM_FIELD_LINEAR_VELOCITY 3u
#define CAROM_FIELD_ANGULAR_VELOCITY 4u
#define CAROM_FIELD_VELOCITY 5u
#define CAROM_FIELD_FORCE 6u
#define CAROM_FIELD_CENTER 7u
#define CAROM_FIELD_MASS 8u
#define CAROM_FIELD_COUNT 9u
#define CAROM_SCALAR_F32 0u
#define CAROM_SCALAR_F64 1u
int32_t carom_world_get_bodies(carom_world* world, carom_body* handles, uint64_t capacity, uint64_t* count,
                               carom_error* error);
int32_t carom_world_read(carom_world* world, uint32_t field, uint32_t scalar, const carom_body* handles, uint64_t n,
                         void* dst, uint64_t stride, carom_error* error);
int32_t carom_world_write(carom_world* world, uint32_t field, uint32_t scalar, const carom_body* handles, uint64_t n,
                          const void* src, uint64_t stride, carom_error* error);
#define CAROM_QUERY_EXACT_ENOUGH 0u
#define CAROM_QUERY_CAPPED 1u
#define CAROM_QUERY_ROUNDING 2u
#define CAROM_QUERY_FAULT 3u
typedef struct carom_distance_desc {
  uint32_t struct_size;
  uint32_t simplex;
  uint32_t narrow_phase;
  uint32_t pair_routines;
  double tolerance;
  double hybrid_margin;
  uint32_t gjk_iterations;
  uint32_t epa_iterations;
} carom_distance_desc;
typedef struct carom_distance {
  uint32_t struct_size;
  uint32_t status;
  double separation;
  double lower;
  double upper;
  double normal[3];
  double point_a[3];
  double point_b[3];
  uint32_t gjk_iterations;
  uint32_t epa_iterations;
  uint32_t support_calls;
  uint32_t reserved;
} carom_distance;
int32_t carom_distance_desc_init(carom_distance_desc* desc, uint32_t struct_size);
int32_t carom_shape_distance(carom_engine* engine, carom_shape shape_a, const double position_a[3],
                             const double orientation_a[4], carom_shape shape_b, const double position_b[3],
                             const double orientation_b[4], const carom_distance_desc* desc, carom_distance* result,
                             carom_error* error);

#endif
