// Whole snapshots and forks at the boundary: what of a world they carry, where they may go, which plugins they ask for,
// handles of one world in another; bytes that were mutated, memory that runs out.
#include <algorithm>

#include "sliced.h"
#include "snapshot_stage.h"

namespace {

constexpr std::uint64_t kTag = std::uint64_t(0xFFFF) << 44;

/// The stage of the other tests, and what only a whole snapshot has to bring along: free slots, lists of joints in an
/// order of their own, frames, scenery, mass given by hand, user values.
void make_more(Bench& b, const carom_engine_desc* desc = nullptr) {
  make(b, desc);
  carom_mesh_desc mesh;
  carom_mesh_desc_init(&mesh, sizeof mesh);
  const double xyz[] = {-9, 0, -9, 9, 0, -9, 9, 0, 9, -9, 0, 9, 9, 0, 9, 0, 1, 0};  // one place twice
  const std::uint32_t corners[] = {0, 2, 1, 0, 3, 4, 0, 2, 4, 1, 5, 2};             // one without an area
  mesh.vertices = xyz, mesh.vertex_count = 6, mesh.triangles = corners, mesh.triangle_count = 4;
  carom_height_field_desc field;
  carom_height_field_desc_init(&field, sizeof field);
  double heights[12];
  for (int i = 0; i < 12; ++i) heights[i] = 0.125 * (i % 5);
  heights[7] = std::nan("");
  field.columns = 4, field.rows = 3, field.heights = heights, field.spacing[1] = 2;
  carom_shape level, hills;
  carom_body body;
  carom_collider collider;
  assert_int_equal(carom_shape_create_mesh(b.engine, &mesh, &level, nullptr), CAROM_OK);
  assert_int_equal(carom_shape_create_height_field(b.engine, &field, &hills, nullptr), CAROM_OK);
  assert_int_equal(bench_body(b.world, level, b.material, CAROM_BODY_STATIC, 0, -1, 0, &body, &collider, nullptr),
                   CAROM_OK);
  assert_int_equal(bench_body(b.world, hills, 0, CAROM_BODY_KINEMATIC, 20, 0, 0, &body, &collider, nullptr), CAROM_OK);
  carom_body made[4];
  for (int i = 0; i < 4; ++i) {
    carom_body_desc d;
    carom_body_desc_init(&d, sizeof d);
    d.fields = CAROM_BODY_FIELD_MASS | CAROM_BODY_FIELD_INERTIA | CAROM_BODY_FIELD_CENTER;
    d.mass = 2 + i, d.inertia[0] = d.inertia[4] = 1, d.inertia[8] = 1.5, d.center[0] = 0.125;
    d.position[0] = 30 + i, d.position[1] = 4, d.user = 77u + static_cast<unsigned>(i);
    d.linear_damping = 0.25;
    assert_int_equal(carom_body_create(b.world, &d, &made[i], nullptr), CAROM_OK);
    carom_collider_desc part;
    carom_collider_desc_init(&part, sizeof part);
    part.shape = b.crate, part.material = b.material, part.position[1] = 0.5;
    part.orientation[0] = 0.6, part.orientation[3] = 0.8;
    assert_int_equal(carom_collider_create(b.world, made[i], &part, &collider, nullptr), CAROM_OK);
  }
  // A joint in a slot that another had, so that lists are not in the order of slots.
  carom_joint joints[4];
  for (int i = 0; i < 4; ++i) {
    carom_joint_desc d;
    carom_joint_desc_init(&d, sizeof d);
    d.kind = i % 2 ? CAROM_JOINT_BALL : CAROM_JOINT_DISTANCE;
    d.fields = i % 2 ? CAROM_JOINT_COLLIDE : 0;
    d.body_a = made[0], d.body_b = i < 3 ? made[i + 1] : CAROM_NULL_HANDLE;
    d.position_a[0] = 0.5, d.position_b[0] = i < 3 ? -0.5 : 30, d.user = 5u + static_cast<unsigned>(i);
    assert_int_equal(carom_joint_create(b.world, &d, &joints[i], nullptr), CAROM_OK);
  }
  carom_joint_desc again;
  carom_joint_desc_init(&again, sizeof again);
  again.body_a = made[2], again.body_b = made[0], again.position_a[1] = 1;
  assert_int_equal(carom_joint_destroy(b.world, joints[1], nullptr), CAROM_OK);
  assert_int_equal(carom_joint_create(b.world, &again, &joints[1], nullptr), CAROM_OK);
  assert_int_equal(carom_body_destroy(b.world, made[3], nullptr), CAROM_OK);
  assert_int_equal(carom_body_destroy(b.world, made[1], nullptr), CAROM_OK);
}

/// An engine with the plugins of the stage and a world in which nothing is.
struct Empty {
  explicit Empty(const carom_engine_desc* desc = nullptr, bool plugins = true) {
    sphere = bench_sphere_plugin(), box = bench_box_plugin();
    assert_int_equal(carom_engine_create(desc, &engine, nullptr), CAROM_OK);
    carom_plugin handle;
    if (plugins) {
      assert_int_equal(carom_plugin_register(engine, &sphere, &handle, nullptr), CAROM_OK);
      assert_int_equal(carom_plugin_register(engine, &box, &handle, nullptr), CAROM_OK);
    }
    assert_int_equal(carom_world_create(engine, nullptr, &world, nullptr), CAROM_OK);
  }
  ~Empty() {
    assert_int_equal(carom_world_destroy(world, nullptr), CAROM_OK);
    assert_int_equal(carom_engine_destroy(engine, nullptr), CAROM_OK);
  }
  carom_shape_plugin sphere, box;
  carom_engine* engine = nullptr;
  carom_world* world = nullptr;
};

std::vector<std::uint64_t> onward(carom_world* world, int steps) {
  std::vector<std::uint64_t> hashes;
  for (int k = 0; k < steps; ++k) {
    assert_int_equal(carom_world_step(world, 1.0 / 64, nullptr), CAROM_OK);
    hashes.push_back(bench_hash(world));
  }
  return hashes;
}

/// A host goes on in a world: what comes and goes there has the handles that it would have had.
std::vector<std::uint64_t> edits(carom_world* world, const std::vector<std::uint64_t>& handles, carom_shape shape) {
  std::vector<std::uint64_t> made;
  carom_body body;
  carom_collider collider;
  for (int k = 0; k < 3; ++k) {
    assert_int_equal(bench_body(world, shape, 0, CAROM_BODY_DYNAMIC, 3.5 * k, 6, 1, &body, &collider, nullptr),
                     CAROM_OK);
    made.push_back(body), made.push_back(collider);
  }
  assert_int_equal(carom_joint_destroy(world, handles[1], nullptr), CAROM_OK);
  assert_int_equal(carom_body_destroy(world, handles[0], nullptr), CAROM_OK);
  carom_joint_desc d;
  carom_joint_desc_init(&d, sizeof d);
  d.body_a = made[0], d.position_b[1] = 8;
  carom_joint joint;
  assert_int_equal(carom_joint_create(world, &d, &joint, nullptr), CAROM_OK);
  made.push_back(joint);
  for (std::uint64_t& h : made) h &= ~kTag;
  for (const std::uint64_t h : onward(world, 60)) made.push_back(h);
  return made;
}

void a_world_is_built_elsewhere(void**) {
  Bench b;
  make_more(b);
  assert_int_equal(bench_steps(b.world, 50, nullptr), CAROM_OK);
  const Bytes whole = save(b.world, CAROM_SNAPSHOT_WHOLE), state = save(b.world);
  Empty other;
  carom_error error = CAROM_ERROR_INIT;
  const int32_t result = restore(other.world, whole, &error);
  if (result) print_error("%s\n", error.message);
  assert_int_equal(result, CAROM_OK);
  assert_true(save(other.world) == state && save(other.world, CAROM_SNAPSHOT_WHOLE) == whole);
  // The same names, the same descriptions, whatever a host can ask about bodies.
  std::uint64_t n = 0, m = 0;
  std::vector<carom_body> ours(64), theirs(64);
  assert_int_equal(carom_world_get_bodies(b.world, ours.data(), ours.size(), &n, nullptr), CAROM_OK);
  assert_int_equal(carom_world_get_bodies(other.world, theirs.data(), theirs.size(), &m, nullptr), CAROM_OK);
  assert_true(n == m && n > 8);
  for (std::uint64_t i = 0; i < n; ++i) {
    assert_true((ours[i] & ~kTag) == (theirs[i] & ~kTag) && ours[i] != theirs[i]);
    carom_body_desc x, y;
    carom_body_desc_init(&x, sizeof x), carom_body_desc_init(&y, sizeof y);
    assert_int_equal(carom_body_get(b.world, ours[i], &x, nullptr), CAROM_OK);
    assert_int_equal(carom_body_get(other.world, theirs[i], &y, nullptr), CAROM_OK);
    assert_memory_equal(&x, &y, sizeof x);
  }
  carom_joint_desc x, y;
  carom_joint_desc_init(&x, sizeof x), carom_joint_desc_init(&y, sizeof y);
  std::uint64_t joint = b.joint;
  assert_int_equal(carom_joint_get(b.world, b.joint, &x, nullptr), CAROM_OK);
  assert_int_equal(carom_world_translate_handles(other.world, &joint, 1, &joint, nullptr), CAROM_OK);
  assert_int_equal(carom_joint_get(other.world, joint, &y, nullptr), CAROM_OK);
  x.body_a &= ~kTag, x.body_b &= ~kTag, y.body_a &= ~kTag, y.body_b &= ~kTag;
  assert_memory_equal(&x, &y, sizeof x);
  // The hosts of both go on alike.
  std::vector<std::uint64_t> names = {b.bodies[1], b.joint}, there(2);
  assert_int_equal(carom_world_translate_handles(other.world, names.data(), 2, there.data(), nullptr), CAROM_OK);
  carom_collider collider = b.colliders[0];
  carom_collider_desc part;
  carom_collider_desc_init(&part, sizeof part);
  carom_body body;
  assert_int_equal(carom_world_translate_handles(other.world, &collider, 1, &collider, nullptr), CAROM_OK);
  assert_int_equal(carom_collider_get(other.world, collider, &part, &body, nullptr), CAROM_OK);
  assert_true(edits(b.world, names, b.ball) == edits(other.world, there, part.shape));
  bench_free(&b);
}

void a_fork_goes_its_own_way(void**) {
  Bench b;
  make_more(b);
  assert_int_equal(bench_steps(b.world, 50, nullptr), CAROM_OK);
  const std::uint64_t before = seen(b);
  carom_world *copy = nullptr, *second = nullptr;
  assert_int_equal(carom_world_fork(b.world, &copy, nullptr), CAROM_OK);
  assert_int_equal(carom_world_fork(copy, &second, nullptr), CAROM_OK);  // of the copy, which never stepped
  std::vector<std::uint64_t> names = {b.bodies[1], b.joint}, there(2);
  assert_int_equal(carom_body_wake(copy, b.bodies[1], nullptr), CAROM_E_WRONG_WORLD);
  assert_int_equal(carom_world_translate_handles(copy, names.data(), 2, there.data(), nullptr), CAROM_OK);
  const auto theirs = edits(copy, there, b.ball);
  assert_true(seen(b) == before);
  assert_int_equal(carom_shape_destroy(b.engine, b.crate, nullptr), CAROM_E_IN_USE);
  assert_true(edits(b.world, names, b.ball) == theirs);
  // The copies keep their shapes when the world that they are of goes.
  assert_int_equal(carom_world_destroy(b.world, nullptr), CAROM_OK);
  assert_int_equal(carom_shape_destroy(b.engine, b.crate, nullptr), CAROM_E_IN_USE);
  assert_int_equal(carom_world_destroy(copy, nullptr), CAROM_OK);
  assert_int_equal(carom_world_translate_handles(second, names.data(), 2, there.data(), nullptr), CAROM_OK);
  assert_true(edits(second, there, b.ball) == theirs);
  assert_int_equal(carom_world_destroy(second, nullptr), CAROM_OK);
  assert_int_equal(carom_shape_destroy(b.engine, b.crate, nullptr), CAROM_OK);
  assert_int_equal(carom_engine_destroy(b.engine, nullptr), CAROM_OK);
}

void assert_steps_as_a_copy(carom_world* original, int steps) {
  carom_world* copy;
  assert_int_equal(carom_world_fork(original, &copy, nullptr), CAROM_OK);
  std::uint64_t hashes[2];
  int i = 0;
  for (carom_world* world : {original, copy}) {
    assert_int_equal(bench_steps(world, steps, nullptr), CAROM_OK);
    assert_int_equal(carom_world_hash(world, &hashes[i++], nullptr), CAROM_OK);
  }
  assert_true(hashes[0] == hashes[1]);
  assert_int_equal(carom_world_destroy(copy, nullptr), CAROM_OK);
}

// A copy has never stepped, its original has. Springs and water are softened to what a substep of this step can carry: stiff
// ones tell how long it was taken to be.
void what_is_stiff_is_stiff_from_the_first_step(void**) {
  for (const bool wet : {false, true}) {
    Bench b;
    assert_int_equal(bench_make(&b, nullptr, nullptr), CAROM_OK);
    carom_body body, ground;
    carom_collider collider;
    assert_int_equal(bench_body(b.world, b.crate, 0, CAROM_BODY_STATIC, 0, -1, 0, &ground, &collider, nullptr),
                     CAROM_OK);
    assert_int_equal(bench_body(b.world, b.ball, 0, CAROM_BODY_DYNAMIC, 0, 0.5, 0, &body, &collider, nullptr),
                     CAROM_OK);
    assert_int_equal(bench_steps(b.world, 3, nullptr), CAROM_OK);
    if (wet) {
      carom_water water;
      carom_water_init(&water, sizeof water);
      water.level = 10, water.density = 1e6, water.drag = 10;
      assert_int_equal(carom_world_set_water(b.world, &water, nullptr), CAROM_OK);
    } else {
      carom_spring_desc spring;
      carom_spring_desc_init(&spring, sizeof spring);
      spring.body_a = body, spring.body_b = ground, spring.rest = 1, spring.stiffness = 1e10, spring.damping = 1e6;
      carom_spring made;
      assert_int_equal(carom_spring_create(b.world, &spring, &made, nullptr), CAROM_OK);
    }
    assert_steps_as_a_copy(b.world, 1);
    assert_int_equal(bench_free(&b), CAROM_OK);
  }
}

// Whose last joint has gone moves as a body does that never had one: so does it in a copy.
void joints_leave_nothing_behind(void**) {
  Bench b;
  assert_int_equal(bench_make(&b, nullptr, nullptr), CAROM_OK);
  carom_body bodies[2], rolls;
  carom_collider collider;
  for (int i = 0; i < 2; ++i)
    assert_int_equal(
        bench_body(b.world, b.ball, 0, CAROM_BODY_DYNAMIC, 0, 5 + 2 * i, 0, &bodies[i], &collider, nullptr), CAROM_OK);
  assert_int_equal(bench_body(b.world, b.crate, 0, CAROM_BODY_STATIC, 0, -1, 0, &rolls, &collider, nullptr), CAROM_OK);
  assert_int_equal(bench_body(b.world, b.ball, 0, CAROM_BODY_DYNAMIC, 0, 0, 0, &rolls, &collider, nullptr), CAROM_OK);
  carom_force_field_desc field;
  carom_force_field_desc_init(&field, sizeof field);
  field.kind = CAROM_FORCE_FIELD_RADIAL, field.strength = 3, field.position[0] = 0.7;
  carom_force_field made;
  assert_int_equal(carom_force_field_create(b.world, &field, &made, nullptr), CAROM_OK);
  carom_joint_desc joint;
  carom_joint_desc_init(&joint, sizeof joint);
  joint.kind = CAROM_JOINT_BALL, joint.body_a = bodies[0], joint.body_b = bodies[1], joint.position_a[1] = 2;
  carom_joint joined;
  assert_int_equal(carom_joint_create(b.world, &joint, &joined, nullptr), CAROM_OK);
  assert_int_equal(bench_steps(b.world, 3, nullptr), CAROM_OK);
  assert_int_equal(carom_joint_destroy(b.world, joined, nullptr), CAROM_OK);
  assert_steps_as_a_copy(b.world, 20);
  assert_int_equal(bench_free(&b), CAROM_OK);
}

// What a host may write is taken back by a restore and a fork, though the next step stops it; what could not be is
// refused when it is said.
void the_edge_of_numbers_is_carried_too(void**) {
  Bench b;
  assert_int_equal(bench_make(&b, nullptr, nullptr), CAROM_OK);
  const auto copies = [&b] {
    carom_world* copy = nullptr;
    assert_int_equal(carom_world_fork(b.world, &copy, nullptr), CAROM_OK);
    assert_int_equal(carom_world_destroy(copy, nullptr), CAROM_OK);
  };
  carom_body_desc d;
  carom_body_desc_init(&d, sizeof d);
  d.fields = CAROM_BODY_FIELD_MASS | CAROM_BODY_FIELD_INERTIA;
  carom_body body[2], none = 77;
  for (const double mass : {4e-310, 5e-324}) {
    d.mass = mass;
    assert_int_equal(carom_body_create(b.world, &d, &none, nullptr), CAROM_E_OUT_OF_RANGE);
    assert_int_equal(none, 77);
  }
  for (int i = 0; i < 2; ++i) {
    d.mass = i ? 1e-300 : 1.7e308;
    for (int k = 0; k < 9; ++k) d.inertia[k] = k % 4 ? 1 : 2 + k;
    assert_int_equal(carom_body_create(b.world, &d, &body[i], nullptr), CAROM_OK);
    copies();
  }
  carom_collider_desc light;
  carom_collider_desc_init(&light, sizeof light);
  carom_collider collider;
  carom_body feather;
  light.shape = b.ball, light.density = 1e-310;  // weighs nothing: its body 1 kg
  d.fields = 0, d.mass = 0, d.position[0] = 50;
  assert_int_equal(carom_body_create(b.world, &d, &feather, nullptr), CAROM_OK);
  assert_int_equal(carom_collider_create(b.world, feather, &light, &collider, nullptr), CAROM_OK);
  copies();
  for (const std::uint32_t locks : {CAROM_LOCK_ANGULAR_X, CAROM_LOCK_ANGULAR_X | CAROM_LOCK_ANGULAR_Z}) {
    const double fast[] = {1.7e308, -1.7e308, 1.7e308};
    assert_int_equal(carom_body_set_locks(b.world, body[1], locks, nullptr), CAROM_OK);
    assert_int_equal(carom_body_set_velocity(b.world, body[1], fast, fast, nullptr), CAROM_OK);
    copies();
  }
  const double far[] = {1.7e308, -1.7e308, 1.7e308}, upright[] = {0, 0, 0, 1};
  assert_int_equal(carom_body_set_pose(b.world, body[0], far, upright, nullptr), CAROM_OK);
  copies();
  for (const std::uint32_t fields : {0u, CAROM_JOINT_WORLD_FRAME}) {
    carom_joint_desc j;
    carom_joint_desc_init(&j, sizeof j);
    j.kind = CAROM_JOINT_DISTANCE, j.fields = fields;
    j.body_a = body[0], j.body_b = body[1];
    carom_joint joint = 77;
    carom_error error = {};
    error.struct_size = sizeof error;
    assert_int_equal(carom_joint_create(b.world, &j, &joint, &error), CAROM_E_OUT_OF_RANGE);
    assert_true(joint == 77 && std::strstr(error.message, "give"));
  }
  copies();
  assert_int_equal(carom_world_step(b.world, 0.01, nullptr), CAROM_OK);
  copies();
  // A body at the bound, and a collider that takes its centre beyond.
  const double bound[] = {1e15, 0, 0};
  assert_int_equal(carom_body_set_pose(b.world, feather, bound, upright, nullptr), CAROM_OK);
  assert_int_equal(carom_world_step(b.world, 0.01, nullptr), CAROM_OK);
  light.density = 1000, light.position[0] = 1e15;
  assert_int_equal(carom_collider_create(b.world, feather, &light, &collider, nullptr), CAROM_OK);
  copies();
  assert_int_equal(carom_world_step(b.world, 0.01, nullptr), CAROM_OK);
  copies();
  assert_int_equal(bench_free(&b), CAROM_OK);
}

/// A body whose impulses overflow goes into quarantine. The world can still be copied, and the body starts anew.
void impulses_that_overflow_are_forgotten(void**) {
  const struct {
    const char* name;
    double mass, speed, dt, rolling;
    bool carries;  // a ball stands on it
  } scenes[] = {
      {"as fuzz found it", 1.79769e308, 1, 1e-3, 0, true},
      {"alone", 1.7e308, 100, 1e-2, 0, false},
      {"tiny steps", 1e308, 1e9, 1e-9, 0, true},
      {"it resists rolling", 1e306, 1e4, 1e-2, 1e3, true},
      {"heavy, and yet in the world", 1e290, 1e5, 1e-2, 10, true},
  };
  int lost = 0;
  for (const auto& scene : scenes)
    for (std::uint32_t solver = CAROM_SOLVER_SEVERITY; solver <= CAROM_SOLVER_AUTO; ++solver) {
      Bench b;
      assert_int_equal(bench_make(&b, nullptr, nullptr), CAROM_OK);
      assert_int_equal(carom_world_set_dial(b.world, CAROM_DIAL_SOLVER, solver, nullptr), CAROM_OK);
      assert_int_equal(carom_material_set_resistance(b.world, b.material, scene.rolling, scene.rolling, nullptr),
                       CAROM_OK);
      const double low[] = {0, 0.4995, 0}, above[] = {0.05, 1.498, 0}, upright[] = {0, 0, 0, 1}, none[] = {0, 0, 0};
      const double down[] = {0.25 * scene.speed, -scene.speed, 0}, spin[] = {3, 2, 1};
      const carom_body body = b.bodies[0];
      assert_int_equal(carom_body_set_mass(b.world, body, scene.mass, nullptr, nullptr, nullptr), CAROM_OK);
      assert_int_equal(carom_body_set_pose(b.world, body, low, upright, nullptr), CAROM_OK);
      assert_int_equal(carom_body_set_velocity(b.world, body, down, spin, nullptr), CAROM_OK);
      if (scene.carries) assert_int_equal(carom_body_set_pose(b.world, b.bodies[1], above, upright, nullptr), CAROM_OK);
      for (int step = 0; step < 4; ++step) {
        assert_int_equal(carom_world_step(b.world, scene.dt, nullptr), CAROM_OK);
        carom_step_report report = {};
        report.struct_size = sizeof report;
        assert_int_equal(carom_world_get_report(b.world, &report, nullptr), CAROM_OK);
        carom_world* copy = nullptr;
        carom_growth growth{};
        growth.struct_size = sizeof growth;
        carom_error error = {};
        error.struct_size = sizeof error;
        const int32_t copied = carom_world_fork(b.world, &copy, &error);
        if (copied != CAROM_OK) print_error("%s, solver %u: %s\n", scene.name, solver, error.message);
        assert_int_equal(copied, CAROM_OK);
        assert_int_equal(carom_world_destroy(copy, nullptr), CAROM_OK);
        assert_int_equal(carom_world_measure_growth(b.world, scene.dt, 2, &growth, nullptr), CAROM_OK);
        assert_int_equal(restore(b.world, save(b.world)), CAROM_OK);
        if (report.quarantined_bodies == 0) continue;
        ++lost;
        assert_int_equal(carom_body_set_mass(b.world, body, 1, nullptr, nullptr, nullptr), CAROM_OK);
        for (const carom_body back : {body, b.bodies[1]}) {
          assert_int_equal(carom_body_set_pose(b.world, back, back == body ? low : above, upright, nullptr), CAROM_OK);
          assert_int_equal(carom_body_set_velocity(b.world, back, none, none, nullptr), CAROM_OK);
        }
        assert_int_equal(carom_world_step(b.world, 1e-2, nullptr), CAROM_OK);
        assert_int_equal(carom_world_get_report(b.world, &report, nullptr), CAROM_OK);
        assert_int_equal(report.quarantined_bodies, 0);
        break;
      }
      bench_free(&b);
    }
  assert_true(lost > 0);
}

void handles_are_translated_or_refused(void**) {
  Bench b;
  make_more(b);
  carom_world* copy = nullptr;
  const carom_body gone = b.bodies[2];
  assert_int_equal(carom_body_destroy(b.world, gone, nullptr), CAROM_OK);
  assert_int_equal(carom_world_fork(b.world, &copy, nullptr), CAROM_OK);
  const std::uint64_t good[] = {b.bodies[0], 0, b.material, b.colliders[1], b.particles};
  std::uint64_t out[5] = {9, 9, 9, 9, 9};
  assert_int_equal(carom_world_translate_handles(copy, good, 5, out, nullptr), CAROM_OK);
  for (int i = 0; i < 5; ++i) assert_true((out[i] & ~kTag) == (good[i] & ~kTag) && (out[i] == 0) == (good[i] == 0));
  assert_int_equal(carom_world_translate_handles(b.world, out, 5, out, nullptr), CAROM_OK);  // and back
  assert_memory_equal(out, good, sizeof good);
  const struct {
    std::uint64_t handle;
    int32_t code;
  } bad[] = {{gone, CAROM_E_STALE_HANDLE},
             {b.crate, CAROM_E_WRONG_KIND},
             {b.sphere, CAROM_E_WRONG_KIND},
             {~std::uint64_t(0), CAROM_E_WRONG_KIND},
             {b.bodies[0] + 1000, CAROM_E_INVALID_HANDLE},
             {1, CAROM_E_WRONG_KIND}};
  for (const auto& wrong : bad) {
    const std::uint64_t two[] = {b.bodies[0], wrong.handle};
    std::uint64_t kept[] = {7, 7};
    carom_error error = CAROM_ERROR_INIT;
    assert_int_equal(carom_world_translate_handles(copy, two, 2, kept, &error), wrong.code);
    assert_true(error.argument == 2 && kept[0] == 7 && kept[1] == 7);
  }
  assert_int_equal(carom_world_translate_handles(copy, nullptr, 0, nullptr, nullptr), CAROM_OK);
  assert_int_equal(carom_world_destroy(copy, nullptr), CAROM_OK);
  bench_free(&b);
}

int32_t no_box(void*, const double* p, uint64_t n, const double dir[3], double out[3]) {
  bench_box(nullptr, p, n, dir, out);
  out[1] *= 0.5;
  return 0;
}

void plugins_are_asked_for_by_name(void**) {
  Bench b;
  make_more(b);
  const Bytes whole = save(b.world, CAROM_SNAPSHOT_WHOLE);
  carom_error error = CAROM_ERROR_INIT;
  carom_plugin handle;
  Empty other(nullptr, false);
  const Bytes before = save(other.world, CAROM_SNAPSHOT_WHOLE);
  assert_int_equal(carom_plugin_register(other.engine, &other.sphere, &handle, nullptr), CAROM_OK);
  assert_int_equal(restore(other.world, whole, &error), CAROM_E_NOT_FOUND);
  assert_true(std::strstr(error.message, "test.box version 1"));
  carom_shape_plugin box = bench_box_plugin();
  box.version = 2;  // another version may be another shape
  assert_int_equal(carom_plugin_register(other.engine, &box, &handle, nullptr), CAROM_OK);
  assert_int_equal(restore(other.world, whole, &error), CAROM_E_NOT_FOUND);
  assert_true(std::strstr(error.message, "test.box version 1") && std::strstr(error.message, "version 2"));
  assert_int_equal(carom_plugin_unload(other.engine, handle, nullptr), CAROM_OK);
  // One that says it is that version, and is not: its shapes are no longer those that were saved.
  box = bench_plugin("test.box", bench_box_params, 3, nullptr, no_box);
  assert_int_equal(carom_plugin_register(other.engine, &box, &handle, nullptr), CAROM_OK);
  assert_int_equal(restore(other.world, whole, &error), CAROM_E_MISMATCH);
  assert_int_equal(carom_plugin_unload(other.engine, handle, nullptr), CAROM_OK);  // no shape of it is left
  static const carom_param narrow[] = {{"half_x", "m", 0, 0.1}, {"half_y", "m", 0, 1e3}, {"half_z", "m", 0, 1e3}};
  box = bench_plugin("test.box", narrow, 3, &bench_box_geometry, bench_box);
  assert_int_equal(carom_plugin_register(other.engine, &box, &handle, nullptr), CAROM_OK);
  assert_int_equal(restore(other.world, whole, &error), CAROM_E_CORRUPT);
  assert_true(std::strstr(error.message, "test.box version 1") && std::strstr(error.message, "half_x"));
  assert_int_equal(carom_plugin_unload(other.engine, handle, nullptr), CAROM_OK);
  assert_true(save(other.world, CAROM_SNAPSHOT_WHOLE) == before);
  assert_int_equal(carom_plugin_register(other.engine, &other.box, &handle, nullptr), CAROM_OK);
  assert_int_equal(restore(other.world, whole, &error), CAROM_OK);
  bench_free(&b);
}

/// Shapes that the engine has are used, each once; two that are alike stay two.
void shapes_are_found_again(void**) {
  Bench b;
  make(b);
  carom_shape twin;
  carom_body body;
  carom_collider collider;
  const double radius = 0.5;
  assert_int_equal(carom_shape_create(b.engine, b.sphere, &radius, 1, &twin, nullptr), CAROM_OK);
  assert_int_equal(bench_body(b.world, twin, b.material, CAROM_BODY_DYNAMIC, 9, 2, 0, &body, &collider, nullptr),
                   CAROM_OK);
  const Bytes whole = save(b.world, CAROM_SNAPSHOT_WHOLE);
  carom_world* world = nullptr;
  assert_int_equal(carom_world_create(b.engine, nullptr, &world, nullptr), CAROM_OK);
  assert_int_equal(restore(world, whole), CAROM_OK);
  std::uint64_t names[] = {b.colliders[0], b.colliders[3], collider};
  carom_shape shapes[3];
  assert_int_equal(carom_world_translate_handles(world, names, 3, names, nullptr), CAROM_OK);
  for (int i = 0; i < 3; ++i) {
    carom_collider_desc d;
    carom_collider_desc_init(&d, sizeof d);
    assert_int_equal(carom_collider_get(world, names[i], &d, &body, nullptr), CAROM_OK);
    shapes[i] = d.shape;
  }
  assert_true(shapes[0] == b.ball && shapes[1] == b.crate && shapes[2] == twin);
  assert_int_equal(carom_world_destroy(world, nullptr), CAROM_OK);
  bench_free(&b);
}

/// Where handles are about, nothing is built: they might come to mean something else.
void only_a_new_world_is_built(void**) {
  Bench b;
  make_more(b);
  const Bytes whole = save(b.world, CAROM_SNAPSHOT_WHOLE);
  const std::uint64_t then = seen(b);
  assert_int_equal(bench_steps(b.world, 20, nullptr), CAROM_OK);
  assert_int_equal(restore(b.world, whole), CAROM_OK);  // of its own structure: the state
  assert_true(seen(b) == then);
  Empty other;
  carom_material_desc d;
  carom_material_desc_init(&d, sizeof d);
  carom_material material;
  carom_error error = CAROM_ERROR_INIT;
  assert_int_equal(carom_material_create(other.world, &d, &material, nullptr), CAROM_OK);
  assert_int_equal(carom_material_destroy(other.world, material, nullptr), CAROM_OK);
  assert_int_equal(restore(other.world, whole, &error), CAROM_E_MISMATCH);
  assert_true(std::strstr(error.message, "new world") && std::strstr(error.message, "bodies"));
  // What a new world was told stays, unless the snapshot says otherwise: a ledger goes on.
  Empty fresh;
  assert_int_equal(carom_world_enable_ledger(fresh.world, 1, nullptr), CAROM_OK);
  assert_int_equal(restore(fresh.world, whole), CAROM_OK);
  assert_int_equal(bench_steps(fresh.world, 1, nullptr), CAROM_OK);
  carom_ledger_state books = {};
  books.struct_size = sizeof books;
  assert_int_equal(carom_world_get_ledger_state(fresh.world, &books, nullptr), CAROM_OK);
  assert_true(books.now_kinetic > 0);
  bench_free(&b);
}

// ---- bytes that nobody vouches for ----

/// Without the section that says once more what the others add up to; so these are all that stand between bytes and a world.
Bytes without_print(const Bytes& bytes) {
  Bytes out(bytes.begin(), bytes.begin() + kHeader);
  for (std::size_t at = kHeader; at + 16 <= bytes.size();) {
    std::uint64_t size;
    std::memcpy(&size, &bytes[at + 8], 8);
    const std::size_t end = at + 16 + (size + 7) / 8 * 8;
    if (std::memcmp(&bytes[at], "STRU", 4) != 0)
      out.insert(out.end(), bytes.begin() + static_cast<std::ptrdiff_t>(at),
                 bytes.begin() + static_cast<std::ptrdiff_t>(end));
    at = end;
  }
  mend(out);
  return out;
}

void fuzz(std::uint64_t seed, int rounds) {
  Random random{seed * 0x9E3779B97F4A7C15ull + 1};
  std::vector<Bytes> good;
  {
    Bench b;
    make_more(b);
    for (int k = 0; k < 4; ++k) {
      assert_int_equal(bench_steps(b.world, 5 + 30 * (k % 3), nullptr), CAROM_OK);
      good.push_back(without_print(save(b.world, CAROM_SNAPSHOT_WHOLE)));
    }
    bench_free(&b);
  }
  Empty fixed;
  const Bytes empty = save(fixed.world, CAROM_SNAPSHOT_WHOLE);
  int taken = 0, refused = 0;
  for (int round = 0; round < rounds; ++round) {
    Bytes bytes = mutated(good, random);
    if (random.below(4)) {  // most of a snapshot is state, which has a test of its own: structure comes first
      bytes = good[random.below(good.size())];
      for (std::uint64_t edits = 1 + random.below(3); edits > 0; --edits)
        bytes[kHeader + random.below(2400)] ^=
            static_cast<unsigned char>(random.below(2) ? random() : 1u << random.below(8));
    }
    if (random.below(16)) mend(bytes);
    carom_world* world = nullptr;
    assert_int_equal(carom_world_create(fixed.engine, nullptr, &world, nullptr), CAROM_OK);
    carom_error error = CAROM_ERROR_INIT;
    const int32_t result = restore(world, bytes, &error);
    if (result == CAROM_OK) {
      ++taken;
      for (int k = 0; k < 3; ++k) {
        const int32_t step = carom_world_step(world, 1.0 / 64, nullptr);
        assert_true(step == CAROM_OK || step == CAROM_E_OUT_OF_MEMORY);
      }
      // And what was taken can be told again: nothing in it is what no world has.
      const Bytes again = save(world, CAROM_SNAPSHOT_WHOLE);
      carom_world* copy = nullptr;
      assert_int_equal(carom_world_fork(world, &copy, nullptr), CAROM_OK);
      assert_true(save(copy, CAROM_SNAPSHOT_WHOLE) == again);
      assert_int_equal(carom_world_destroy(copy, nullptr), CAROM_OK);
    } else {
      ++refused;
      assert_true(result == CAROM_E_CORRUPT || result == CAROM_E_MISMATCH || result == CAROM_E_UNSUPPORTED ||
                  result == CAROM_E_NOT_FOUND);
      assert_true(save(world, CAROM_SNAPSHOT_WHOLE) == empty);
    }
    assert_int_equal(carom_world_destroy(world, nullptr), CAROM_OK);
  }
  std::printf("  %d rounds: %d refused, %d taken\n", rounds, refused, taken);
  assert_true(refused > 0 && taken > 0);
}

int rounds = carom::test::sliced(20000, 8000, 2000);
std::uint64_t seed = 1;
void mutations_do_no_harm(void**) { fuzz(seed, rounds); }

// ---- memory that runs out ----
void building_that_runs_out_of_memory_changes_nothing(void**) {
  Bench source;
  make_more(source);
  assert_int_equal(bench_steps(source.world, 60, nullptr), CAROM_OK);
  const Bytes bytes = save(source.world, CAROM_SNAPSHOT_WHOLE);
  Meter meter{-1, 0};
  carom_engine_desc desc;
  carom_engine_desc_init(&desc, sizeof desc);
  desc.alloc = metered_alloc, desc.free = metered_free, desc.alloc_user = &meter;
  int failures = 0;
  for (std::int64_t k = 0;; ++k) {
    meter.left = -1;
    Empty other(&desc);
    const Bytes before = save(other.world, CAROM_SNAPSHOT_WHOLE);
    meter.left = k;
    const int32_t result = restore(other.world, bytes);
    meter.left = -1;
    if (result == CAROM_OK) break;
    ++failures;
    assert_int_equal(result, CAROM_E_OUT_OF_MEMORY);
    assert_true(save(other.world, CAROM_SNAPSHOT_WHOLE) == before);
    if (k % 8) continue;
    assert_int_equal(restore(other.world, bytes), CAROM_OK);
    assert_true(save(other.world, CAROM_SNAPSHOT_WHOLE) == bytes);
  }
  assert_true(failures > 50);
  assert_true(meter.alive == 0);
  std::printf("  building: %d allocations, each failed once\n", failures);
  bench_free(&source);
}

void so_does_a_fork(void**) {
  Meter meter{-1, 0};
  carom_engine_desc desc;
  carom_engine_desc_init(&desc, sizeof desc);
  desc.alloc = metered_alloc, desc.free = metered_free, desc.alloc_user = &meter;
  Bench b;
  make_more(b, &desc);
  assert_int_equal(bench_steps(b.world, 60, nullptr), CAROM_OK);
  const std::uint64_t before = seen(b);
  int failures = 0;
  for (std::int64_t k = 0;; ++k) {
    const std::int64_t alive = meter.alive;
    carom_world* copy = nullptr;
    meter.left = k;
    const int32_t result = carom_world_fork(b.world, &copy, nullptr);
    meter.left = -1;
    if (result == CAROM_OK) {
      assert_int_equal(carom_world_destroy(copy, nullptr), CAROM_OK);
      break;
    }
    ++failures;
    assert_int_equal(result, CAROM_E_OUT_OF_MEMORY);
    assert_true(!copy && meter.alive == alive && seen(b) == before);
  }
  std::printf("  a fork: %d allocations, each failed once\n", failures);
  assert_true(failures > 50);
  bench_free(&b);
  assert_true(meter.alive == 0);
}

}  // namespace

/// Arguments: rounds of mutations, and a seed.
int main(int argc, char** argv) {
  if (argc > 1) rounds = std::atoi(argv[1]);
  if (argc > 2) seed = static_cast<std::uint64_t>(std::atoll(argv[2]));
  const CMUnitTest tests[] = {
      cmocka_unit_test(a_world_is_built_elsewhere),
      cmocka_unit_test(a_fork_goes_its_own_way),
      cmocka_unit_test(what_is_stiff_is_stiff_from_the_first_step),
      cmocka_unit_test(joints_leave_nothing_behind),
      cmocka_unit_test(the_edge_of_numbers_is_carried_too),
      cmocka_unit_test(impulses_that_overflow_are_forgotten),
      cmocka_unit_test(handles_are_translated_or_refused),
      cmocka_unit_test(plugins_are_asked_for_by_name),
      cmocka_unit_test(shapes_are_found_again),
      cmocka_unit_test(only_a_new_world_is_built),
      cmocka_unit_test(mutations_do_no_harm),
      cmocka_unit_test(building_that_runs_out_of_memory_changes_nothing),
      cmocka_unit_test(so_does_a_fork),
  };
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
