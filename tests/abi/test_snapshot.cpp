// Snapshots at the boundary: what they carry, what they refuse and that nothing has changed then; bytes that were cut,
// flipped and spliced, with the checksum put right again; memory that runs out.
#include "snapshot_stage.h"

namespace {

void settings_come_back_with_the_state(void**) {
  Bench b;
  make(b);
  assert_int_equal(bench_steps(b.world, 30, nullptr), CAROM_OK);
  const Bytes bytes = save(b.world);
  const std::uint64_t then = seen(b);
  const double up[3] = {0, 3, 0}, side[3] = {1, 0, 0};
  carom_joint_motor motor;
  carom_joint_motor_init(&motor, sizeof motor);
  motor.speed = -1, motor.max_force = 50;
  assert_int_equal(carom_world_set_gravity(b.world, up, nullptr), CAROM_OK);
  assert_int_equal(carom_world_set_wind(b.world, side, nullptr), CAROM_OK);
  assert_int_equal(carom_world_set_dial(b.world, CAROM_DIAL_SUBSTEPS, 7, nullptr), CAROM_OK);
  assert_int_equal(carom_body_set_gravity_factor(b.world, b.bodies[3], 2, nullptr), CAROM_OK);
  assert_int_equal(carom_body_set_locks(b.world, b.bodies[2], CAROM_LOCK_PLANE, nullptr), CAROM_OK);
  assert_int_equal(carom_body_set_drag(b.world, b.bodies[1], 3, 3, nullptr), CAROM_OK);
  assert_int_equal(carom_body_ignore_collision(b.world, b.bodies[2], b.bodies[1], 1, nullptr), CAROM_OK);
  assert_int_equal(carom_joint_set_motor(b.world, b.joint, CAROM_COORDINATE_TWIST, &motor, nullptr), CAROM_OK);
  assert_int_equal(carom_collider_set_surface_velocity(b.world, b.ground_collider, side, up, nullptr), CAROM_OK);
  assert_int_equal(carom_collider_set_sensor(b.world, b.colliders[0], 1, nullptr), CAROM_OK);
  assert_int_equal(carom_world_set_effect(b.world, CAROM_EFFECT_FRICTION, CAROM_MODE_FORBID, nullptr), CAROM_OK);
  assert_int_equal(carom_body_add_force(b.world, b.bodies[0], up, side, nullptr), CAROM_OK);
  const uint32_t gone[] = {1, 3};
  assert_int_equal(carom_particles_remove(b.world, b.particles, gone, 2, nullptr), CAROM_OK);
  assert_int_equal(bench_steps(b.world, 10, nullptr), CAROM_OK);
  assert_true(seen(b) != then);
  assert_int_equal(restore(b.world, bytes), CAROM_OK);
  assert_true(seen(b) == then);
  double factor = 0;
  assert_int_equal(carom_body_get_gravity_factor(b.world, b.bodies[3], &factor, nullptr), CAROM_OK);
  assert_true(factor == 1);
  std::uint32_t locks = 9;
  assert_int_equal(carom_body_get_locks(b.world, b.bodies[2], &locks, nullptr), CAROM_OK);
  assert_int_equal(locks, 0);
  bench_free(&b);
}

/// What one solver keeps of its last step is not read by another: a fork has none of it.
void who_changes_its_solver_steps_as_its_fork(void**) {
  const double solvers[] = {CAROM_SOLVER_SOFT_STEP, CAROM_SOLVER_DIRECT, CAROM_SOLVER_AUTO};
  for (const double before : solvers)
    for (const double after : solvers)
      for (const double dt : {1.0 / 60, 0.1, 0.5}) {
        Bench b;
        make(b);
        assert_int_equal(carom_world_set_dial(b.world, CAROM_DIAL_SOLVER, before, nullptr), CAROM_OK);
        assert_int_equal(bench_steps(b.world, 40, nullptr), CAROM_OK);
        assert_int_equal(carom_world_set_dial(b.world, CAROM_DIAL_SOLVER, after, nullptr), CAROM_OK);
        carom_world* fork = nullptr;
        assert_int_equal(carom_world_fork(b.world, &fork, nullptr), CAROM_OK);
        const double v[3] = {0, -30, 0}, still[3] = {0, 0, 0};  // so fast that it is swept
        std::uint64_t body[2] = {b.bodies[3], b.bodies[3]}, of_fork = 0;
        assert_int_equal(carom_world_translate_handles(fork, body, 1, body, nullptr), CAROM_OK);
        assert_int_equal(carom_body_set_velocity(b.world, body[1], v, still, nullptr), CAROM_OK);
        assert_int_equal(carom_body_set_velocity(fork, body[0], v, still, nullptr), CAROM_OK);
        for (int i = 0; i < 4; ++i) {
          assert_int_equal(carom_world_step(b.world, dt, nullptr), CAROM_OK);
          assert_int_equal(carom_world_step(fork, dt, nullptr), CAROM_OK);
        }
        assert_int_equal(carom_world_hash(fork, &of_fork, nullptr), CAROM_OK);
        assert_true(of_fork == bench_hash(b.world));
        assert_int_equal(carom_world_destroy(fork, nullptr), CAROM_OK);
        bench_free(&b);
      }
}

void pending_forces_go_on(void**) {
  Bench b;
  make(b);
  const double f[3] = {10, 20, 5}, t[3] = {1, 2, 3};
  assert_int_equal(bench_steps(b.world, 5, nullptr), CAROM_OK);
  assert_int_equal(carom_body_add_force(b.world, b.bodies[3], f, t, nullptr), CAROM_OK);
  const Bytes bytes = save(b.world);
  assert_int_equal(bench_steps(b.world, 20, nullptr), CAROM_OK);
  const std::uint64_t onward = bench_hash(b.world);
  assert_int_equal(restore(b.world, bytes), CAROM_OK);
  assert_int_equal(bench_steps(b.world, 20, nullptr), CAROM_OK);
  assert_true(bench_hash(b.world) == onward);
  bench_free(&b);
}

/// Who rolls back and applies other inputs ends where who never rolled back does.
void edits_after_a_restore_do_what_they_do_without(void**) {
  for (int edit = 0; edit < 7; ++edit) {
    std::uint64_t end[2];
    for (int rolls_back = 0; rolls_back < 2; ++rolls_back) {
      Bench b;
      make(b);
      assert_int_equal(bench_steps(b.world, 60, nullptr), CAROM_OK);
      double stood[3] = {0.25, 4, 0};
      if (edit == 6) {  // a slot that is free when the world is saved, and used again for one that stands in its place
        assert_int_equal(
            carom_world_read(b.world, CAROM_FIELD_POSITION, CAROM_SCALAR_F64, &b.bodies[3], 1, stood, 0, nullptr),
            CAROM_OK);
        assert_int_equal(carom_body_destroy(b.world, b.bodies[3], nullptr), CAROM_OK);
      }
      const Bytes bytes = save(b.world);
      if (rolls_back) {
        assert_int_equal(bench_steps(b.world, 25, nullptr), CAROM_OK);
        assert_int_equal(restore(b.world, bytes), CAROM_OK);
      }
      const double here[3] = {0.5, 2, 0.25}, turn[4] = {0, 0.6, 0, 0.8}, v[3] = {1, 2, 0}, w[3] = {0, 1, 0};
      if (edit == 1) carom_body_set_pose(b.world, b.bodies[3], here, turn, nullptr);
      if (edit == 2) carom_body_set_velocity(b.world, b.bodies[2], v, w, nullptr);
      if (edit == 3) carom_world_set_gravity(b.world, v, nullptr);
      if (edit == 4) carom_body_destroy(b.world, b.bodies[1], nullptr);
      carom_body body;
      carom_collider collider;
      if (edit >= 5)
        bench_body(b.world, edit == 6 ? b.crate : b.ball, b.material, CAROM_BODY_DYNAMIC, stood[0], stood[1], stood[2],
                   &body, &collider, nullptr);
      assert_int_equal(bench_steps(b.world, 100, nullptr), CAROM_OK);
      end[rolls_back] = bench_hash(b.world);
      bench_free(&b);
    }
    if (end[0] != end[1]) print_error("edit %d\n", edit);
    assert_true(end[0] == end[1]);
  }
}

void events_go_on(void**) {
  std::vector<std::uint64_t> lists[2];
  Bench b;
  make(b);
  assert_int_equal(bench_steps(b.world, 20, nullptr), CAROM_OK);
  const Bytes bytes = save(b.world);
  for (auto& list : lists) {
    for (int k = 0; k < 200; ++k) {
      assert_int_equal(bench_steps(b.world, 1, nullptr), CAROM_OK);
      std::uint64_t n[3];
      carom_world_get_contact_events(b.world, nullptr, 0, 0, &n[0], nullptr);
      carom_world_get_sleep_events(b.world, nullptr, 0, 0, &n[1], nullptr);
      carom_world_get_sensor_events(b.world, nullptr, 0, 0, &n[2], nullptr);
      list.insert(list.end(), n, n + 3);
    }
    assert_int_equal(restore(b.world, bytes), CAROM_OK);
  }
  assert_true(lists[0] == lists[1]);
  std::uint64_t any = 0;
  for (const std::uint64_t n : lists[0]) any += n;
  assert_true(any > 4);
  bench_free(&b);
}

/// Bodies and shapes in quarantine, and a joint that broke.
int32_t fails_at_will(void*, const double*, uint64_t, const double dir[3], double out[3]);
bool fails = false;
int32_t fails_at_will(void*, const double* p, uint64_t n, const double dir[3], double out[3]) {
  return fails ? 1 : bench_box(nullptr, p, n, dir, out);
}

void quarantine_and_breaks_go_on(void**) {
  for (int late = 0; late < 2; ++late) {
    Bench b;
    make(b);
    carom_shape_plugin plugin = bench_plugin("test.fails", bench_box_params, 3, nullptr, fails_at_will);
    carom_plugin own;
    carom_shape shape;
    carom_body body;
    carom_collider collider;
    const double half[3] = {0.5, 0.5, 0.5};
    fails = false;
    assert_int_equal(carom_plugin_register(b.engine, &plugin, &own, nullptr), CAROM_OK);
    assert_int_equal(carom_shape_create(b.engine, own, half, 3, &shape, nullptr), CAROM_OK);
    assert_int_equal(bench_body(b.world, shape, b.material, CAROM_BODY_DYNAMIC, 5, 0.4, 0, &body, &collider, nullptr),
                     CAROM_OK);
    carom_joint_desc d;
    carom_joint_desc_init(&d, sizeof d);
    d.kind = CAROM_JOINT_BALL, d.fields = CAROM_JOINT_WORLD_FRAME, d.break_force = 1e-3;
    d.body_a = b.bodies[1], d.body_b = b.bodies[3];
    carom_joint weak;
    assert_int_equal(carom_joint_create(b.world, &d, &weak, nullptr), CAROM_OK);
    assert_int_equal(bench_steps(b.world, 3, nullptr), CAROM_OK);
    const Bytes whole = save(b.world);
    const double fast[3] = {1e200, 0, 0}, none[3] = {0, 0, 0};
    assert_int_equal(carom_body_set_velocity(b.world, b.bodies[2], fast, none, nullptr), CAROM_OK);
    fails = true;
    assert_int_equal(bench_steps(b.world, late ? 30 : 1, nullptr), CAROM_OK);
    carom_step_report report = {};
    report.struct_size = sizeof report;
    assert_int_equal(carom_world_get_report(b.world, &report, nullptr), CAROM_OK);
    assert_int_equal(report.quarantined_bodies, 1);
    const Bytes bytes = save(b.world);
    assert_int_equal(bench_steps(b.world, 50, nullptr), CAROM_OK);
    const std::uint64_t onward = bench_hash(b.world);
    fails = false;
    assert_int_equal(restore(b.world, whole), CAROM_OK);  // there they are well
    assert_int_equal(bench_steps(b.world, 30, nullptr), CAROM_OK);
    assert_int_equal(carom_world_get_report(b.world, &report, nullptr), CAROM_OK);
    assert_int_equal(report.quarantined_bodies, 0);
    fails = true;
    assert_int_equal(restore(b.world, bytes), CAROM_OK);
    assert_int_equal(bench_steps(b.world, 50, nullptr), CAROM_OK);
    assert_true(bench_hash(b.world) == onward);
    assert_int_equal(carom_world_get_report(b.world, &report, nullptr), CAROM_OK);
    assert_int_equal(report.quarantined_bodies, 1);
    fails = false;
    bench_free(&b);
  }
}

void questions_and_books_follow(void**) {
  Bench b;
  make(b);
  assert_int_equal(carom_world_enable_ledger(b.world, 1, nullptr), CAROM_OK);
  assert_int_equal(bench_steps(b.world, 20, nullptr), CAROM_OK);
  const double from[3] = {1.5, 9, 0.25}, down[3] = {0, -1, 0};
  carom_world_hit then = {}, now = {};
  assert_int_equal(carom_world_cast_ray(b.world, from, down, 100, nullptr, &then, sizeof then, nullptr), CAROM_OK);
  const Bytes bytes = save(b.world);
  assert_int_equal(bench_steps(b.world, 60, nullptr), CAROM_OK);
  assert_int_equal(carom_world_cast_ray(b.world, from, down, 100, nullptr, &now, sizeof now, nullptr), CAROM_OK);
  assert_true(std::memcmp(&then, &now, sizeof now) != 0);
  assert_int_equal(restore(b.world, bytes), CAROM_OK);
  assert_int_equal(carom_world_cast_ray(b.world, from, down, 100, nullptr, &now, sizeof now, nullptr), CAROM_OK);
  assert_true(std::memcmp(&then, &now, sizeof now) == 0);
  assert_int_equal(bench_steps(b.world, 1, nullptr), CAROM_OK);
  carom_ledger_state books = {};
  books.struct_size = sizeof books;
  assert_int_equal(carom_world_get_ledger_state(b.world, &books, nullptr), CAROM_OK);
  std::vector<carom_ledger_entry> causes(64);
  std::uint64_t count = 0;
  assert_int_equal(carom_world_get_ledger(b.world, causes.data(), sizeof causes[0], causes.size(), &count, nullptr),
                   CAROM_OK);
  double sum = 0;
  for (std::uint64_t k = 0; k < count; ++k) sum += causes[k].kinetic + causes[k].potential;
  const double change = books.now_kinetic + books.now_potential - books.before_kinetic - books.before_potential;
  assert_true(std::fabs(sum - change) <= books.rounding_energy);
  bench_free(&b);
}

void another_structure_is_refused_by_name(void**) {
  Bench b;
  make(b);
  assert_int_equal(bench_steps(b.world, 10, nullptr), CAROM_OK);
  const Bytes bytes = save(b.world);
  const struct {
    const char* name;
    void (*edit)(Bench&);
  } edits[] = {
      {"bodies", [](Bench& x) { carom_body_destroy(x.world, x.bodies[3], nullptr); }},
      {"colliders", [](Bench& x) { carom_collider_destroy(x.world, x.colliders[3], nullptr); }},
      {"joints", [](Bench& x) { carom_joint_destroy(x.world, x.joint, nullptr); }},
      {"particle sets", [](Bench& x) { carom_particles_destroy(x.world, x.particles, nullptr); }},
      {"materials",
       [](Bench& x) {
         carom_material m;
         carom_material_create(x.world, nullptr, &m, nullptr);
         carom_material_desc d;
         carom_material_desc_init(&d, sizeof d);
         carom_material_create(x.world, &d, &m, nullptr);
       }},
      {"colliders",
       [](Bench& x) {  // as many, but another one
         carom_collider_desc d;
         carom_collider_desc_init(&d, sizeof d);
         d.shape = x.ball;
         carom_collider_destroy(x.world, x.colliders[3], nullptr);
         carom_collider_create(x.world, x.bodies[3], &d, &x.colliders[3], nullptr);
       }},
  };
  for (const auto& e : edits) {
    Bench other;
    make(other);
    e.edit(other);
    const std::uint64_t before = seen(other);
    carom_error error = CAROM_ERROR_INIT;
    assert_int_equal(restore(other.world, bytes, &error), CAROM_E_MISMATCH);
    const bool named = std::strstr(error.message, e.name) != nullptr ||
                       (std::strcmp(e.name, "colliders") == 0 && std::strstr(error.message, "bodies"));
    if (!named) print_error("%s: %s\n", e.name, error.message);
    assert_true(named && std::strlen(error.remedy) > 8);
    assert_true(seen(other) == before);
    bench_free(&other);
  }
  bench_free(&b);
}

void what_is_no_snapshot_is_refused(void**) {
  Bench b;
  make(b);
  assert_int_equal(bench_steps(b.world, 40, nullptr), CAROM_OK);
  const Bytes good = save(b.world);
  const std::uint64_t before = seen(b);
  carom_error error = CAROM_ERROR_INIT;
  assert_int_equal(carom_world_restore(b.world, good.data(), 0, &error), CAROM_E_CORRUPT);
  for (std::size_t n = 1; n < good.size(); n += n < 200 ? 1 : 37) {  // cut off, anywhere
    const Bytes cut(good.begin(), good.begin() + static_cast<std::ptrdiff_t>(n));
    assert_int_equal(restore(b.world, cut, &error), CAROM_E_CORRUPT);
  }
  Bytes longer = good;
  longer.push_back(0);
  assert_int_equal(restore(b.world, longer, &error), CAROM_E_CORRUPT);
  for (std::size_t k = 0; k < good.size(); k += 11) {  // one bit
    Bytes bad = good;
    bad[k] ^= static_cast<unsigned char>(1u << (k % 8));
    const int32_t result = restore(b.world, bad, &error);
    if (k >= 8 && k < 12)
      assert_true(result == CAROM_E_CORRUPT || result == CAROM_E_UNSUPPORTED);
    else
      assert_int_equal(result, CAROM_E_CORRUPT);
  }
  Bytes newer = good;
  newer[8] = 2;
  mend(newer);
  assert_int_equal(restore(b.world, newer, &error), CAROM_E_UNSUPPORTED);
  assert_true(seen(b) == before);
  std::uint64_t needed = 0;
  Bytes small(good.size() - 1, 0xAB);
  assert_int_equal(carom_world_save(b.world, 0, small.data(), small.size(), &needed, &error), CAROM_E_BUFFER_TOO_SMALL);
  assert_true(needed == good.size());
  bench_free(&b);
}

/// A reader skips sections that it does not know.
void sections_of_the_future_are_skipped(void**) {
  Bench b;
  make(b);
  assert_int_equal(bench_steps(b.world, 40, nullptr), CAROM_OK);
  const std::uint64_t then = seen(b);
  Bytes bytes = save(b.world);
  const unsigned char section[] = {'F', 'U', 'T', 'R', 0, 0, 0, 0, 5, 0, 0, 0, 0, 0, 0, 0, 1, 2, 3, 4, 5, 0, 0, 0};
  bytes.insert(bytes.begin() + kHeader, section, section + sizeof section);
  mend(bytes);
  assert_int_equal(bench_steps(b.world, 10, nullptr), CAROM_OK);
  assert_int_equal(restore(b.world, bytes), CAROM_OK);
  assert_true(seen(b) == then);
  bench_free(&b);
}

/// Mutations of good snapshots, most with a checksum that is right: whatever comes of them, nobody crashes; what is
/// refused changes nothing; what is taken is a world that steps on.
void fuzz(std::uint64_t seed, int rounds) {
  Random random{seed * 0x9E3779B97F4A7C15ull + 1};
  Bench b;
  make(b);
  std::vector<Bytes> good;
  for (int k = 0; k < 6; ++k) {
    assert_int_equal(bench_steps(b.world, 5 + 40 * (k % 3), nullptr), CAROM_OK);
    good.push_back(save(b.world));
  }
  int taken = 0, refused = 0;
  std::uint64_t before = seen(b);
  for (int round = 0; round < rounds; ++round) {
    Bytes bytes = mutated(good, random);
    if (random.below(16)) mend(bytes);
    carom_error error = CAROM_ERROR_INIT;
    const int32_t result = restore(b.world, bytes, &error);
    if (result != CAROM_OK) {
      ++refused;
      assert_true(result == CAROM_E_CORRUPT || result == CAROM_E_MISMATCH || result == CAROM_E_UNSUPPORTED);
      if (round % 16 == 0) assert_true(seen(b) == before);
      continue;
    }
    ++taken;
    for (int k = 0; k < 3; ++k) {
      const int32_t step = carom_world_step(b.world, 1.0 / 64, nullptr);
      assert_true(step == CAROM_OK || step == CAROM_E_OUT_OF_MEMORY);
    }
    // Nothing stays behind in the world of what was wrong with it.
    assert_int_equal(restore(b.world, good[0]), CAROM_OK);
    before = seen(b);
    if (taken % 64 == 1) {
      assert_int_equal(bench_steps(b.world, 20, nullptr), CAROM_OK);
      const std::uint64_t onward = bench_hash(b.world);
      Bench fresh;
      make(fresh);
      assert_int_equal(restore(fresh.world, good[0]), CAROM_OK);
      assert_int_equal(bench_steps(fresh.world, 20, nullptr), CAROM_OK);
      assert_true(bench_hash(fresh.world) == onward);
      bench_free(&fresh);
      assert_int_equal(restore(b.world, good[0]), CAROM_OK);
    }
  }
  std::printf("  %d rounds: %d refused, %d taken\n", rounds, refused, taken);
  assert_true(refused > 0 && taken > 0);
  bench_free(&b);
}

int rounds = 3000;
std::uint64_t seed = 1;
void mutations_do_no_harm(void**) { fuzz(seed, rounds); }

void a_restore_that_runs_out_of_memory_changes_nothing(void**) {
  Bench source;
  make(source);
  assert_int_equal(bench_steps(source.world, 100, nullptr), CAROM_OK);
  const Bytes bytes = save(source.world);
  const std::uint64_t then = seen(source);
  Meter meter{-1, 0};
  carom_engine_desc desc;
  carom_engine_desc_init(&desc, sizeof desc);
  desc.alloc = metered_alloc, desc.free = metered_free, desc.alloc_user = &meter;
  int failures = 0;
  for (std::int64_t k = 0;; ++k) {
    Bench b;
    meter.left = -1;
    make(b, &desc);
    const std::uint64_t before = seen(b);
    meter.left = k;
    carom_error error = CAROM_ERROR_INIT;
    const int32_t result = restore(b.world, bytes, &error);
    meter.left = -1;
    if (result == CAROM_OK) {
      assert_true(seen(b) == then);
      bench_free(&b);
      break;
    }
    ++failures;
    assert_int_equal(result, CAROM_E_OUT_OF_MEMORY);
    assert_true(seen(b) == before);
    assert_int_equal(restore(b.world, bytes), CAROM_OK);
    assert_true(seen(b) == then);
    bench_free(&b);
  }
  assert_true(failures > 10);
  assert_true(meter.alive == 0);
  bench_free(&source);
}

}  // namespace

/// Arguments: rounds of mutations, and a seed.
int main(int argc, char** argv) {
  if (argc > 1) rounds = std::atoi(argv[1]);
  if (argc > 2) seed = static_cast<std::uint64_t>(std::atoll(argv[2]));
  const CMUnitTest tests[] = {
      cmocka_unit_test(settings_come_back_with_the_state),
      cmocka_unit_test(who_changes_its_solver_steps_as_its_fork),
      cmocka_unit_test(pending_forces_go_on),
      cmocka_unit_test(edits_after_a_restore_do_what_they_do_without),
      cmocka_unit_test(events_go_on),
      cmocka_unit_test(quarantine_and_breaks_go_on),
      cmocka_unit_test(questions_and_books_follow),
      cmocka_unit_test(another_structure_is_refused_by_name),
      cmocka_unit_test(what_is_no_snapshot_is_refused),
      cmocka_unit_test(sections_of_the_future_are_skipped),
      cmocka_unit_test(mutations_do_no_harm),
      cmocka_unit_test(a_restore_that_runs_out_of_memory_changes_nothing),
  };
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
