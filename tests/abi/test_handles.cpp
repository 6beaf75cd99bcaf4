// Handles are told apart in every build: never issued, destroyed, of another kind, of another world. A handle of a
// destroyed object never reaches the object that took its place.
#include <cstring>
#include <vector>

#include "bench.h"
#include "carom_test.h"

namespace {

enum Kind { kPlugin, kShape, kMaterial, kBody, kCollider, kParticles, kJoint, kKinds };

/// One handle argument of one call.
struct Place {
  const char* what;
  Kind kind;
  int32_t argument;
  int32_t (*call)(Bench& b, uint64_t handle, carom_error* e);
};

const double kZero[3] = {0, 0, 0}, kUp[3] = {0, 1, 0}, kUpright[4] = {0, 0, 0, 1};

int32_t measure(Bench& b, carom_shape s, carom_shape t, carom_error* e) {
  carom_distance r = {};
  r.struct_size = sizeof r;
  return carom_shape_distance(b.engine, s, kZero, kUpright, t, kZero, kUpright, nullptr, &r, e);
}

int32_t measure_pair(Bench& b, carom_shape s, carom_shape t, carom_error* e) {
  carom_distance r = {};
  carom_pairs p = {};
  p.struct_size = sizeof p;
  p.count = 1;
  p.shapes_a = &s, p.shapes_b = &t;
  p.positions_a = p.positions_b = kZero, p.orientations_a = p.orientations_b = kUpright;
  return carom_pairs_distance(b.engine, &p, nullptr, &r, sizeof r, e);
}

int32_t cast(Bench& b, carom_shape s, carom_shape t, carom_error* e) {
  carom_cast r = {};
  r.struct_size = sizeof r;
  return carom_shape_cast(b.engine, s, kZero, kUpright, kUp, t, kZero, kUpright, nullptr, &r, e);
}
int32_t impact(Bench& b, carom_shape s, carom_shape t, carom_error* e) {
  carom_cast r = {};
  r.struct_size = sizeof r;
  carom_motion m;
  carom_motion_init(&m, sizeof m);
  return carom_shape_time_of_impact(b.engine, s, &m, t, &m, 1, nullptr, &r, e);
}
int32_t overlap(Bench& b, carom_shape s, carom_shape t, carom_error* e) {
  carom_overlap r = {};
  r.struct_size = sizeof r;
  return carom_shape_overlap(b.engine, s, kZero, kUpright, t, kZero, kUpright, nullptr, &r, e);
}
int32_t cast_rays(Bench& b, carom_shape s, carom_error* e) {
  const carom_shape two[2] = {b.ball, s};
  const double positions[6] = {0}, orientations[8] = {0, 0, 0, 1, 0, 0, 0, 1};
  carom_rays rays = {};
  rays.struct_size = sizeof rays;
  carom_ray_hits hits = {};
  hits.struct_size = sizeof hits;
  return carom_rays_cast(b.engine, two, positions, orientations, 2, &rays, nullptr, &hits, e);
}

int32_t put_on(Bench& b, carom_body body, carom_shape shape, carom_material material, carom_error* e) {
  carom_collider_desc d;
  carom_collider_desc_init(&d, sizeof d);
  d.shape = shape;
  d.material = material;
  carom_collider out;
  return carom_collider_create(b.world, body, &d, &out, e);
}

/// A hinge.
int32_t join(Bench& b, carom_body body_a, carom_body body_b, carom_error* e, carom_joint* out = nullptr) {
  carom_joint_desc d;
  carom_joint_desc_init(&d, sizeof d);
  d.kind = CAROM_JOINT_HINGE;
  d.body_a = body_a, d.body_b = body_b;
  carom_joint joint;
  return carom_joint_create(b.world, &d, out ? out : &joint, e);
}

int32_t ask_without(Bench& b, uint64_t body, carom_error* e) {
  if (!body) return CAROM_E_INVALID_HANDLE;  // nobody is ignored
  carom_query_desc d;
  carom_query_desc_init(&d, sizeof d);
  d.ignore = body;
  carom_world_hit hit;
  return carom_world_cast_ray(b.world, kZero, kUp, 1, &d, &hit, sizeof hit, e);
}
int32_t ask_with(Bench& b, uint64_t shape, carom_error* e) {
  if (!shape) return CAROM_E_INVALID_HANDLE;  // a point
  carom_query_shapes s = {};
  s.struct_size = sizeof s;
  s.scalar = CAROM_SCALAR_F64;
  s.count = 1;
  s.shapes = &shape;
  s.positions = kZero;
  uint64_t count;
  return carom_world_overlap_shapes(b.world, &s, nullptr, nullptr, 0, 0, &count, e);
}

/// A hinge has no transmission, but its handle is good.
int32_t of_a_hinge(int32_t result) { return result == CAROM_E_UNSUPPORTED ? CAROM_OK : result; }

const Place kPlaces[] = {
    {"collider_set_surface_velocity", kCollider, 2, [](Bench& b, uint64_t h, carom_error* e) { return carom_collider_set_surface_velocity(b.world, h, kUp, kUp, e); }},
    {"collider_get_surface_velocity", kCollider, 2, [](Bench& b, uint64_t h, carom_error* e) { double v[3], w[3]; return carom_collider_get_surface_velocity(b.world, h, v, w, e); }},
    {"body_set_gravity_factor", kBody, 2, [](Bench& b, uint64_t h, carom_error* e) { return carom_body_set_gravity_factor(b.world, h, 2, e); }},
    {"body_get_gravity_factor", kBody, 2, [](Bench& b, uint64_t h, carom_error* e) { double f; return carom_body_get_gravity_factor(b.world, h, &f, e); }},
    {"body_set_locks", kBody, 2, [](Bench& b, uint64_t h, carom_error* e) { return carom_body_set_locks(b.world, h, 1, e); }},
    {"body_set_attribute", kBody, 2, [](Bench& b, uint64_t h, carom_error* e) { const double v[4] = {2}; return carom_body_set_attribute(b.world, h, 0, v, e); }},
    {"body_get_attribute", kBody, 2, [](Bench& b, uint64_t h, carom_error* e) { double v[4]; return carom_body_get_attribute(b.world, h, 0, v, e); }},
    {"body_get_locks", kBody, 2, [](Bench& b, uint64_t h, carom_error* e) { uint32_t m; return carom_body_get_locks(b.world, h, &m, e); }},
    {"collider_set_filter", kCollider, 2, [](Bench& b, uint64_t h, carom_error* e) { return carom_collider_set_filter(b.world, h, 1, 1, 0, e); }},
    {"collider_get_filter", kCollider, 2, [](Bench& b, uint64_t h, carom_error* e) { uint64_t c, m; int32_t g; return carom_collider_get_filter(b.world, h, &c, &m, &g, e); }},
    {"collider_set_sensor", kCollider, 2, [](Bench& b, uint64_t h, carom_error* e) { return carom_collider_set_sensor(b.world, h, 1, e); }},
    {"collider_is_sensor", kCollider, 2, [](Bench& b, uint64_t h, carom_error* e) { uint32_t s; return carom_collider_is_sensor(b.world, h, &s, e); }},
    {"body_set_filter", kBody, 2, [](Bench& b, uint64_t h, carom_error* e) { return carom_body_set_filter(b.world, h, 1, 1, 0, e); }},
    {"body_ignore_collision a", kBody, 2, [](Bench& b, uint64_t h, carom_error* e) { return carom_body_ignore_collision(b.world, h, b.ground, 0, e); }},
    {"body_ignore_collision b", kBody, 3, [](Bench& b, uint64_t h, carom_error* e) { return carom_body_ignore_collision(b.world, b.ground, h, 0, e); }},
    {"world_cast_ray ignore", kBody, 5, ask_without},
    {"world_overlap_shapes shape", kShape, 2, ask_with},
    {"plugin_unload", kPlugin, 2, [](Bench& b, uint64_t h, carom_error* e) { return carom_plugin_unload(b.engine, h, e); }},
    {"plugin_describe", kPlugin, 2, [](Bench& b, uint64_t h, carom_error* e) { const carom_shape_plugin* p; return carom_plugin_describe(b.engine, h, &p, e); }},
    {"shape_create", kPlugin, 2, [](Bench& b, uint64_t h, carom_error* e) { double r = 1; carom_shape s; return carom_shape_create(b.engine, h, &r, 1, &s, e); }},
    {"shape_create_hull_of", kShape, 2, [](Bench& b, uint64_t h, carom_error* e) { carom_shape s; return carom_shape_create_hull_of(b.engine, &h, 1, nullptr, nullptr, nullptr, 0, &s, e); }},
    {"shape_get_parts", kShape, 2, [](Bench& b, uint64_t h, carom_error* e) { uint64_t n = 0; return carom_shape_get_parts(b.engine, h, nullptr, nullptr, nullptr, nullptr, &n, nullptr, e); }},
    {"shape_destroy", kShape, 2, [](Bench& b, uint64_t h, carom_error* e) { return carom_shape_destroy(b.engine, h, e); }},
    {"shape_get_info", kShape, 2, [](Bench& b, uint64_t h, carom_error* e) { carom_shape_info i = {}; i.struct_size = sizeof i; return carom_shape_get_info(b.engine, h, &i, e); }},
    {"shape_get_params", kShape, 2, [](Bench& b, uint64_t h, carom_error* e) { double p[3]; uint64_t n = 3; return carom_shape_get_params(b.engine, h, p, &n, e); }},
    {"shape_support", kShape, 2, [](Bench& b, uint64_t h, carom_error* e) { double p[3]; return carom_shape_support(b.engine, h, kUp, 1, p, e); }},
    {"shape_distance a", kShape, 2, [](Bench& b, uint64_t h, carom_error* e) { return measure(b, h, b.ball, e); }},
    {"shape_distance b", kShape, 5, [](Bench& b, uint64_t h, carom_error* e) { return measure(b, b.ball, h, e); }},
    {"pairs_distance a", kShape, 2, [](Bench& b, uint64_t h, carom_error* e) { return measure_pair(b, h, b.ball, e); }},
    {"pairs_distance b", kShape, 2, [](Bench& b, uint64_t h, carom_error* e) { return measure_pair(b, b.ball, h, e); }},
    {"ray_cast", kShape, 2, [](Bench& b, uint64_t h, carom_error* e) { carom_cast r = {}; r.struct_size = sizeof r; return carom_ray_cast(b.engine, h, kZero, kUpright, kUp, kUp, 1, nullptr, &r, e); }},
    {"shape_cast a", kShape, 2, [](Bench& b, uint64_t h, carom_error* e) { return cast(b, h, b.ball, e); }},
    {"shape_cast b", kShape, 6, [](Bench& b, uint64_t h, carom_error* e) { return cast(b, b.ball, h, e); }},
    {"shape_time_of_impact a", kShape, 2, [](Bench& b, uint64_t h, carom_error* e) { return impact(b, h, b.ball, e); }},
    {"shape_time_of_impact b", kShape, 4, [](Bench& b, uint64_t h, carom_error* e) { return impact(b, b.ball, h, e); }},
    {"shape_overlap a", kShape, 2, [](Bench& b, uint64_t h, carom_error* e) { return overlap(b, h, b.ball, e); }},
    {"shape_overlap b", kShape, 5, [](Bench& b, uint64_t h, carom_error* e) { return overlap(b, b.ball, h, e); }},
    {"rays_cast", kShape, 2, [](Bench& b, uint64_t h, carom_error* e) { return cast_rays(b, h, e); }},
    {"material_update", kMaterial, 2, [](Bench& b, uint64_t h, carom_error* e) { carom_material_desc d; carom_material_desc_init(&d, sizeof d); return carom_material_update(b.world, h, &d, e); }},
    {"material_destroy", kMaterial, 2, [](Bench& b, uint64_t h, carom_error* e) { return carom_material_destroy(b.world, h, e); }},
    {"collider_create shape", kShape, 3, [](Bench& b, uint64_t h, carom_error* e) { return put_on(b, b.bodies[0], h, CAROM_NULL_HANDLE, e); }},
    {"collider_create material", kMaterial, 3, [](Bench& b, uint64_t h, carom_error* e) { return h ? put_on(b, b.bodies[0], b.ball, h, e) : CAROM_E_INVALID_HANDLE; }},
    {"collider_create body", kBody, 2, [](Bench& b, uint64_t h, carom_error* e) { return put_on(b, h, b.ball, CAROM_NULL_HANDLE, e); }},
    {"collider_destroy", kCollider, 2, [](Bench& b, uint64_t h, carom_error* e) { return carom_collider_destroy(b.world, h, e); }},
    {"collider_get", kCollider, 2, [](Bench& b, uint64_t h, carom_error* e) { carom_collider_desc d; carom_collider_desc_init(&d, sizeof d); carom_body o; return carom_collider_get(b.world, h, &d, &o, e); }},
    {"body_destroy", kBody, 2, [](Bench& b, uint64_t h, carom_error* e) { return carom_body_destroy(b.world, h, e); }},
    {"body_get", kBody, 2, [](Bench& b, uint64_t h, carom_error* e) { carom_body_desc d; carom_body_desc_init(&d, sizeof d); return carom_body_get(b.world, h, &d, e); }},
    {"body_set_pose", kBody, 2, [](Bench& b, uint64_t h, carom_error* e) { return carom_body_set_pose(b.world, h, kZero, kUpright, e); }},
    {"body_set_velocity", kBody, 2, [](Bench& b, uint64_t h, carom_error* e) { return carom_body_set_velocity(b.world, h, kUp, kUp, e); }},
    {"body_is_asleep", kBody, 2, [](Bench& b, uint64_t h, carom_error* e) { uint32_t a; return carom_body_is_asleep(b.world, h, &a, e); }},
    {"body_wake", kBody, 2, [](Bench& b, uint64_t h, carom_error* e) { return carom_body_wake(b.world, h, e); }},
    {"body_add_force", kBody, 2, [](Bench& b, uint64_t h, carom_error* e) { return carom_body_add_force(b.world, h, kUp, kUp, e); }},
    {"body_add_impulse", kBody, 2, [](Bench& b, uint64_t h, carom_error* e) { return carom_body_add_impulse(b.world, h, kUp, kUp, e); }},
    {"world_read", kBody, 4, [](Bench& b, uint64_t h, carom_error* e) { const carom_body two[2] = {b.bodies[0], h}; double p[6]; return carom_world_read(b.world, CAROM_FIELD_POSITION, CAROM_SCALAR_F64, two, 2, p, 0, e); }},
    {"world_write", kBody, 4, [](Bench& b, uint64_t h, carom_error* e) { const carom_body two[2] = {b.bodies[0], h}; const double p[6] = {7, 7, 7, 7, 7, 7}; return carom_world_write(b.world, CAROM_FIELD_POSITION, CAROM_SCALAR_F64, two, 2, p, 0, e); }},
    {"particles_get", kParticles, 2, [](Bench& b, uint64_t h, carom_error* e) { carom_particles_desc d; carom_particles_desc_init(&d, sizeof d); return carom_particles_get(b.world, h, &d, e); }},
    {"particles_update", kParticles, 2, [](Bench& b, uint64_t h, carom_error* e) { return carom_particles_update(b.world, h, nullptr, e); }},
    {"particles_get_count", kParticles, 2, [](Bench& b, uint64_t h, carom_error* e) { uint64_t n; return carom_particles_get_count(b.world, h, &n, e); }},
    {"particles_add", kParticles, 2, [](Bench& b, uint64_t h, carom_error* e) { return carom_particles_add(b.world, h, 1, CAROM_SCALAR_F64, kUp, 0, nullptr, 0, e); }},
    {"particles_remove", kParticles, 2, [](Bench& b, uint64_t h, carom_error* e) { const uint32_t i = 1; return carom_particles_remove(b.world, h, &i, 1, e); }},
    {"particles_read", kParticles, 2, [](Bench& b, uint64_t h, carom_error* e) { const uint32_t i = 1; double p[3]; return carom_particles_read(b.world, h, CAROM_FIELD_POSITION, CAROM_SCALAR_F64, &i, 1, p, 0, e); }},
    {"particles_write", kParticles, 2, [](Bench& b, uint64_t h, carom_error* e) { const uint32_t i = 1; return carom_particles_write(b.world, h, CAROM_FIELD_POSITION, CAROM_SCALAR_F64, &i, 1, kUp, 0, e); }},
    {"particles_get_quarantined", kParticles, 2, [](Bench& b, uint64_t h, carom_error* e) { uint64_t n; return carom_particles_get_quarantined(b.world, h, nullptr, 0, &n, e); }},
    {"joint_create a", kBody, 2, [](Bench& b, uint64_t h, carom_error* e) { return h ? join(b, h, b.bodies[2], e) : int32_t(CAROM_E_INVALID_HANDLE); }},
    {"joint_create b", kBody, 2, [](Bench& b, uint64_t h, carom_error* e) { return h ? join(b, b.bodies[2], h, e) : int32_t(CAROM_E_INVALID_HANDLE); }},
    {"joint_get", kJoint, 2, [](Bench& b, uint64_t h, carom_error* e) { carom_joint_desc d; carom_joint_desc_init(&d, sizeof d); return carom_joint_get(b.world, h, &d, e); }},
    {"joint_get_state", kJoint, 2, [](Bench& b, uint64_t h, carom_error* e) { carom_joint_state s = {}; s.struct_size = sizeof s; return carom_joint_get_state(b.world, h, &s, e); }},
    {"joint_set_limit", kJoint, 2, [](Bench& b, uint64_t h, carom_error* e) { carom_joint_limit d; carom_joint_limit_init(&d, sizeof d); return carom_joint_set_limit(b.world, h, CAROM_COORDINATE_TWIST, &d, e); }},
    {"joint_set_motor", kJoint, 2, [](Bench& b, uint64_t h, carom_error* e) { carom_joint_motor d; carom_joint_motor_init(&d, sizeof d); return carom_joint_set_motor(b.world, h, CAROM_COORDINATE_TWIST, &d, e); }},
    {"joint_set_spring", kJoint, 2, [](Bench& b, uint64_t h, carom_error* e) { carom_joint_spring d; carom_joint_spring_init(&d, sizeof d); return carom_joint_set_spring(b.world, h, CAROM_COORDINATE_TWIST, &d, e); }},
    {"joint_get_limit", kJoint, 2, [](Bench& b, uint64_t h, carom_error* e) { carom_joint_limit d; carom_joint_limit_init(&d, sizeof d); return carom_joint_get_limit(b.world, h, CAROM_COORDINATE_TWIST, &d, e); }},
    {"joint_get_motor", kJoint, 2, [](Bench& b, uint64_t h, carom_error* e) { carom_joint_motor d; carom_joint_motor_init(&d, sizeof d); return carom_joint_get_motor(b.world, h, CAROM_COORDINATE_TWIST, &d, e); }},
    {"joint_get_spring", kJoint, 2, [](Bench& b, uint64_t h, carom_error* e) { carom_joint_spring d; carom_joint_spring_init(&d, sizeof d); return carom_joint_get_spring(b.world, h, CAROM_COORDINATE_TWIST, &d, e); }},
    {"joint_set_transmission", kJoint, 2, [](Bench& b, uint64_t h, carom_error* e) { carom_joint_transmission d; carom_joint_transmission_init(&d, sizeof d); return of_a_hinge(carom_joint_set_transmission(b.world, h, &d, e)); }},
    {"joint_get_transmission", kJoint, 2, [](Bench& b, uint64_t h, carom_error* e) { carom_joint_transmission d; carom_joint_transmission_init(&d, sizeof d); return of_a_hinge(carom_joint_get_transmission(b.world, h, &d, e)); }},
    {"joint_set_coupling", kJoint, 2, [](Bench& b, uint64_t h, carom_error* e) { carom_joint_coupling d; carom_joint_coupling_init(&d, sizeof d); return of_a_hinge(carom_joint_set_coupling(b.world, h, &d, e)); }},
    {"joint_get_coupling", kJoint, 2, [](Bench& b, uint64_t h, carom_error* e) { carom_joint_coupling d; carom_joint_coupling_init(&d, sizeof d); return of_a_hinge(carom_joint_get_coupling(b.world, h, &d, e)); }},
    {"joint_set_axis", kJoint, 2, [](Bench& b, uint64_t h, carom_error* e) { carom_joint_axis d; carom_joint_axis_init(&d, sizeof d); return of_a_hinge(carom_joint_set_axis(b.world, h, 0, &d, e)); }},
    {"joint_get_axis", kJoint, 2, [](Bench& b, uint64_t h, carom_error* e) { carom_joint_axis d; carom_joint_axis_init(&d, sizeof d); return of_a_hinge(carom_joint_get_axis(b.world, h, 0, &d, e)); }},
    {"joint_set_orientation_drive", kJoint, 2, [](Bench& b, uint64_t h, carom_error* e) { carom_joint_orientation_drive d; carom_joint_orientation_drive_init(&d, sizeof d); return of_a_hinge(carom_joint_set_orientation_drive(b.world, h, &d, e)); }},
    {"joint_get_orientation_drive", kJoint, 2, [](Bench& b, uint64_t h, carom_error* e) { carom_joint_orientation_drive d; carom_joint_orientation_drive_init(&d, sizeof d); return of_a_hinge(carom_joint_get_orientation_drive(b.world, h, &d, e)); }},
    {"joint_destroy", kJoint, 2, [](Bench& b, uint64_t h, carom_error* e) { return carom_joint_destroy(b.world, h, e); }},
    {"particles_destroy", kParticles, 2, [](Bench& b, uint64_t h, carom_error* e) { return carom_particles_destroy(b.world, h, e); }},
};

/// A good handle of a kind.
uint64_t good(const Bench& b, int kind) {
  const uint64_t handles[kKinds] = {b.sphere, b.ball, b.material, b.bodies[1], b.colliders[1], b.particles, b.joint};
  return handles[kind];
}

struct Stage {
  Bench own, other;     // other: another engine and another world
  carom_world* second;  // another world of the same engine
  carom_body second_body;
  carom_collider second_collider;
  carom_particles second_particles;
  carom_joint second_joint;
  uint64_t stale[kKinds];      // of `own`, destroyed, the slot taken again
  uint64_t successor[kKinds];  // what took the slot
};

/// Make, destroy, make again: the second takes the place of the first.
void replace(Stage& s) {
  Bench& b = s.own;
  static carom_shape_plugin spare = bench_plugin("test.spare", bench_radius_params, 1, nullptr, bench_point);
  for (uint64_t* out : {s.stale, s.successor}) {
    const double radius = 2;
    carom_material_desc material;
    carom_material_desc_init(&material, sizeof material);
    assert_int_equal(carom_plugin_register(b.engine, &spare, &out[kPlugin], nullptr), CAROM_OK);
    assert_int_equal(carom_shape_create(b.engine, b.sphere, &radius, 1, &out[kShape], nullptr), CAROM_OK);
    assert_int_equal(carom_material_create(b.world, &material, &out[kMaterial], nullptr), CAROM_OK);
    assert_int_equal(
        bench_body(b.world, b.ball, 0, CAROM_BODY_DYNAMIC, 50, 50, 50, &out[kBody], &out[kCollider], nullptr),
        CAROM_OK);
    assert_int_equal(carom_particles_create(b.world, nullptr, &out[kParticles], nullptr), CAROM_OK);
    assert_int_equal(join(b, CAROM_NULL_HANDLE, out[kBody], nullptr, &out[kJoint]), CAROM_OK);
    if (out == s.successor) break;
    assert_int_equal(carom_joint_destroy(b.world, out[kJoint], nullptr), CAROM_OK);
    assert_int_equal(carom_particles_destroy(b.world, out[kParticles], nullptr), CAROM_OK);
    assert_int_equal(carom_collider_destroy(b.world, out[kCollider], nullptr), CAROM_OK);
    assert_int_equal(carom_body_destroy(b.world, out[kBody], nullptr), CAROM_OK);
    assert_int_equal(carom_material_destroy(b.world, out[kMaterial], nullptr), CAROM_OK);
    assert_int_equal(carom_shape_destroy(b.engine, out[kShape], nullptr), CAROM_OK);
    assert_int_equal(carom_plugin_unload(b.engine, out[kPlugin], nullptr), CAROM_OK);
  }
  for (int k = 0; k < kKinds; ++k) {
    assert_true(s.stale[k] != s.successor[k]);
    assert_true((s.stale[k] & 0xFFFFFF) == (s.successor[k] & 0xFFFFFF));  // the same slot, or this test proves nothing
  }
}

int make(void** state) {
  static Stage s;
  s = Stage();
  assert_int_equal(bench_make(&s.own, nullptr, nullptr), CAROM_OK);
  assert_int_equal(bench_make(&s.other, nullptr, nullptr), CAROM_OK);
  assert_int_equal(bench_particles(&s.own, nullptr), CAROM_OK);
  assert_int_equal(bench_particles(&s.other, nullptr), CAROM_OK);
  assert_int_equal(bench_joint(&s.own, nullptr), CAROM_OK);
  assert_int_equal(bench_joint(&s.other, nullptr), CAROM_OK);
  assert_int_equal(carom_world_create(s.own.engine, nullptr, &s.second, nullptr), CAROM_OK);
  assert_int_equal(carom_particles_create(s.second, nullptr, &s.second_particles, nullptr), CAROM_OK);
  assert_int_equal(
      bench_body(s.second, s.own.ball, 0, CAROM_BODY_DYNAMIC, 0, 0, 0, &s.second_body, &s.second_collider, nullptr),
      CAROM_OK);
  Bench second = s.own;
  second.world = s.second;
  assert_int_equal(join(second, CAROM_NULL_HANDLE, s.second_body, nullptr, &s.second_joint), CAROM_OK);
  replace(s);
  assert_int_equal(bench_steps(s.own.world, 40, nullptr), CAROM_OK);
  *state = &s;
  return 0;
}

int clear(void** state) {
  Stage& s = *static_cast<Stage*>(*state);
  assert_int_equal(carom_world_destroy(s.second, nullptr), CAROM_OK);
  assert_int_equal(bench_free(&s.other), CAROM_OK);
  assert_int_equal(bench_free(&s.own), CAROM_OK);
  return 0;
}

void expect(Stage& s, const Place& place, uint64_t handle, int32_t code) {
  const uint64_t hash = bench_hash(s.own.world);
  carom_error e = CAROM_ERROR_INIT;
  const int32_t result = place.call(s.own, handle, &e);
  if (result != code)
    print_error("%s of 0x%016llx: %s, wanted %s\n", place.what, static_cast<unsigned long long>(handle),
                carom_result_name(result), carom_result_name(code));
  assert_int_equal(result, code);
  if (handle) assert_int_equal(e.argument, place.argument);
  assert_true(bench_hash(s.own.world) == hash);
}

void a_destroyed_object_is_stale_and_its_successor_untouched(void** state) {
  Stage& s = *static_cast<Stage*>(*state);
  carom_body_desc before = {}, after = {};
  before.struct_size = after.struct_size = sizeof before;
  assert_int_equal(carom_body_get(s.own.world, s.successor[kBody], &before, nullptr), CAROM_OK);
  for (const Place& place : kPlaces) expect(s, place, s.stale[place.kind], CAROM_E_STALE_HANDLE);
  assert_int_equal(carom_body_get(s.own.world, s.successor[kBody], &after, nullptr), CAROM_OK);
  assert_memory_equal(&before, &after, sizeof before);
}

void a_handle_never_issued_is_invalid(void** state) {
  Stage& s = *static_cast<Stage*>(*state);
  for (const Place& place : kPlaces) {
    const uint64_t h = good(s.own, place.kind);
    const uint64_t wrong[] = {0,
                              1,
                              h & ~(uint64_t(15) << 60),       // kind 0
                              h | (uint64_t(15) << 60),        // kind 15
                              h | 0xFFFFFF,                    // a slot beyond all
                              h | (uint64_t(0xFFFFF) << 24),   // a generation yet to come
                              h & ~(uint64_t(0xFFFFF) << 24),  // generation 0
                              0x5555555555555555ull & ~(uint64_t(15) << 60)};
    for (uint64_t w : wrong) expect(s, place, w, CAROM_E_INVALID_HANDLE);
  }
}

void a_handle_of_another_kind_is_told_so(void** state) {
  Stage& s = *static_cast<Stage*>(*state);
  for (const Place& place : kPlaces)
    for (int kind = 0; kind < kKinds; ++kind)
      if (kind != place.kind) {
        expect(s, place, good(s.own, kind), CAROM_E_WRONG_KIND);
        expect(s, place, good(s.other, kind), CAROM_E_WRONG_KIND);
      }
}

void a_handle_of_another_world_or_engine_is_told_so(void** state) {
  Stage& s = *static_cast<Stage*>(*state);
  for (const Place& place : kPlaces) {
    expect(s, place, good(s.other, place.kind), CAROM_E_WRONG_WORLD);
    if (place.kind == kBody) expect(s, place, s.second_body, CAROM_E_WRONG_WORLD);
    if (place.kind == kCollider) expect(s, place, s.second_collider, CAROM_E_WRONG_WORLD);
    if (place.kind == kParticles) expect(s, place, s.second_particles, CAROM_E_WRONG_WORLD);
    if (place.kind == kJoint) expect(s, place, s.second_joint, CAROM_E_WRONG_WORLD);
  }
}

void good_handles_work(void** state) {
  Stage& s = *static_cast<Stage*>(*state);
  for (const Place& place : kPlaces) {
    carom_error e = CAROM_ERROR_INIT;
    const int32_t result = place.call(s.own, good(s.own, place.kind), &e);
    if (result != CAROM_OK && result != CAROM_E_IN_USE) print_error("%s: %s\n", place.what, e.message);
    assert_true(result == CAROM_OK || result == CAROM_E_IN_USE);
    // What the table destroyed leaves the rest of it something to work on.
    if (std::strcmp(place.what, "collider_destroy") == 0) {
      assert_int_equal(place.call(s.own, s.own.colliders[1], nullptr), CAROM_E_STALE_HANDLE);
      s.own.colliders[1] = s.own.colliders[2];
    }
    if (std::strcmp(place.what, "body_destroy") == 0) {
      assert_int_equal(place.call(s.own, s.own.bodies[1], nullptr), CAROM_E_STALE_HANDLE);
      s.own.bodies[1] = s.own.bodies[3];
    }
  }
}

void colliders_of_a_destroyed_body_are_stale(void**) {
  Bench b;
  assert_int_equal(bench_make(&b, nullptr, nullptr), CAROM_OK);
  assert_int_equal(carom_body_destroy(b.world, b.bodies[0], nullptr), CAROM_OK);
  carom_collider_desc d;
  carom_collider_desc_init(&d, sizeof d);
  carom_body body;
  assert_int_equal(carom_collider_get(b.world, b.colliders[0], &d, &body, nullptr), CAROM_E_STALE_HANDLE);
  assert_int_equal(bench_free(&b), CAROM_OK);
}

void a_slot_reused_a_thousand_times_never_gives_the_same_handle(void**) {
  Bench b;
  assert_int_equal(bench_make(&b, nullptr, nullptr), CAROM_OK);
  std::vector<carom_body> seen;
  carom_body_desc d;
  carom_body_desc_init(&d, sizeof d);
  for (int i = 0; i < 1000; ++i) {
    carom_body body;
    assert_int_equal(carom_body_create(b.world, &d, &body, nullptr), CAROM_OK);
    for (carom_body other : seen) assert_true(other != body);
    seen.push_back(body);
    assert_int_equal(carom_body_destroy(b.world, body, nullptr), CAROM_OK);
  }
  for (carom_body old : seen) assert_int_equal(carom_body_destroy(b.world, old, nullptr), CAROM_E_STALE_HANDLE);
  assert_int_equal(bench_free(&b), CAROM_OK);
}

// After as many lives as generations tell apart a slot is retired, in copies of the world, too: no handle comes again.
void a_slot_that_has_lived_its_lives_is_retired(void**) {
  constexpr int kLives = (1 << 19) - 1;
  Bench b;
  assert_int_equal(bench_make(&b, nullptr, nullptr), CAROM_OK);
  carom_material_desc d;
  carom_material_desc_init(&d, sizeof d);
  const auto slot_of = [](carom_material m) { return m & 0xFFFFFF; };
  carom_material first = 0, last = 0, next = 0;
  for (int i = 0; i < kLives; ++i) {
    carom_material now;
    assert_int_equal(carom_material_create(b.world, &d, &now, nullptr), CAROM_OK);
    if (i == 0) first = now;
    assert_true(slot_of(now) == slot_of(first) && now > last);
    last = now;
    assert_int_equal(carom_material_destroy(b.world, now, nullptr), CAROM_OK);
  }
  carom_world* copy;
  assert_int_equal(carom_world_fork(b.world, &copy, nullptr), CAROM_OK);
  for (carom_world* world : {b.world, copy}) {
    assert_int_equal(carom_material_create(world, &d, &next, nullptr), CAROM_OK);
    assert_true(slot_of(next) != slot_of(first));
  }
  for (const carom_material old : {first, last})
    assert_int_equal(carom_material_update(b.world, old, &d, nullptr), CAROM_E_STALE_HANDLE);
  assert_int_equal(carom_world_destroy(copy, nullptr), CAROM_OK);
  assert_int_equal(bench_free(&b), CAROM_OK);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(a_destroyed_object_is_stale_and_its_successor_untouched, make, clear),
      cmocka_unit_test_setup_teardown(a_handle_never_issued_is_invalid, make, clear),
      cmocka_unit_test_setup_teardown(a_handle_of_another_kind_is_told_so, make, clear),
      cmocka_unit_test_setup_teardown(a_handle_of_another_world_or_engine_is_told_so, make, clear),
      cmocka_unit_test_setup_teardown(good_handles_work, make, clear),
      cmocka_unit_test(colliders_of_a_destroyed_body_are_stale),
      cmocka_unit_test(a_slot_reused_a_thousand_times_never_gives_the_same_handle),
      cmocka_unit_test(a_slot_that_has_lived_its_lives_is_retired),
  };
  return cmocka_run_group_tests_name("abi/handles", tests, nullptr, nullptr);
}
