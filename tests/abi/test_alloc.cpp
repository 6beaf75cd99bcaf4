// The host's allocator: everything comes from it and goes back to it, with the sizes it was asked for; running out at any
// point is an error that changes nothing; a world at rest in its routine asks for nothing.
#include <cstdlib>
#include <cstring>
#include <map>
#include <vector>

#include "bench.h"
#include "carom_test.h"
#include "sliced.h"

namespace {

/// Counts, checks and, on demand, refuses.
struct Ledger {
  struct Block {
    uint64_t size, alignment;
  };
  std::map<void*, Block> live;
  uint64_t bytes = 0, allocations = 0;
  uint64_t fail_at = ~uint64_t(0);  // the allocation of this number and all later ones fail
  int wrong = 0;                    // frees that do not match what was given

  carom_engine_desc desc() {
    carom_engine_desc d;
    carom_engine_desc_init(&d, sizeof d);
    d.alloc_user = this;
    d.alloc = [](void* user, uint64_t size, uint64_t alignment) -> void* {
      Ledger& l = *static_cast<Ledger*>(user);
      if (l.allocations++ >= l.fail_at) return nullptr;
      if (alignment == 0 || (alignment & (alignment - 1))) ++l.wrong;
      void* p = std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment + (size ? 0 : alignment));
      l.live[p] = {size, alignment};
      l.bytes += size;
      return p;
    };
    d.free = [](void* user, void* p, uint64_t size, uint64_t alignment) {
      Ledger& l = *static_cast<Ledger*>(user);
      const auto it = l.live.find(p);
      if (it == l.live.end() || it->second.size != size || it->second.alignment != alignment) {
        ++l.wrong;
        return;
      }
      l.bytes -= size;
      l.live.erase(it);
      std::free(p);
    };
    return d;
  }
};

void everything_comes_from_the_host_and_goes_back(void**) {
  Ledger ledger;
  const carom_engine_desc desc = ledger.desc();
  Bench b;
  assert_int_equal(bench_make(&b, &desc, nullptr), CAROM_OK);
  assert_int_equal(bench_particles(&b, nullptr), CAROM_OK);
  assert_int_equal(bench_steps(b.world, 100, nullptr), CAROM_OK);
  for (double choice : {CAROM_BROAD_BRUTE_FORCE, CAROM_BROAD_GRID, CAROM_BROAD_TREE}) {
    assert_int_equal(carom_world_set_dial(b.world, CAROM_DIAL_BROAD_PHASE, choice, nullptr), CAROM_OK);
    assert_int_equal(bench_steps(b.world, 10, nullptr), CAROM_OK);
  }
  assert_true(ledger.allocations > 20);
  assert_int_equal(bench_free(&b), CAROM_OK);
  assert_int_equal(ledger.live.size(), 0);
  assert_int_equal(ledger.bytes, 0);
  assert_int_equal(ledger.wrong, 0);
}

void an_empty_world_costs_kilobytes(void**) {
  Ledger ledger;
  const carom_engine_desc desc = ledger.desc();
  carom_engine* engine = nullptr;
  carom_world* world = nullptr;
  assert_int_equal(carom_engine_create(&desc, &engine, nullptr), CAROM_OK);
  const uint64_t before = ledger.bytes;
  assert_int_equal(carom_world_create(engine, nullptr, &world, nullptr), CAROM_OK);
  assert_int_equal(carom_world_step(world, 0.01, nullptr), CAROM_OK);
  print_message("an empty world: %llu bytes\n", static_cast<unsigned long long>(ledger.bytes - before));
  assert_true(ledger.bytes - before > 500 && ledger.bytes - before < 16 * 1024);
  assert_int_equal(carom_world_destroy(world, nullptr), CAROM_OK);
  assert_int_equal(carom_engine_destroy(engine, nullptr), CAROM_OK);
}

void steps_of_a_settled_world_allocate_nothing(void**) {
  Ledger ledger;
  const carom_engine_desc desc = ledger.desc();
  for (double broad : {CAROM_BROAD_BRUTE_FORCE, CAROM_BROAD_SWEEP_AND_PRUNE, CAROM_BROAD_GRID, CAROM_BROAD_TREE})
    for (double routines : {0., 1.}) {
      Bench b;
      assert_int_equal(bench_make(&b, &desc, nullptr), CAROM_OK);
      assert_int_equal(bench_particles(&b, nullptr), CAROM_OK);
      assert_int_equal(carom_world_set_dial(b.world, CAROM_DIAL_BROAD_PHASE, broad, nullptr), CAROM_OK);
      assert_int_equal(carom_world_set_dial(b.world, CAROM_DIAL_PAIR_ROUTINES, routines, nullptr), CAROM_OK);
      assert_int_equal(bench_steps(b.world, 1200, nullptr), CAROM_OK);  // all have landed, and rolled apart
      const uint64_t before = ledger.allocations;
      assert_int_equal(bench_steps(b.world, 200, nullptr), CAROM_OK);
      assert_int_equal(ledger.allocations - before, 0);
      assert_int_equal(bench_free(&b), CAROM_OK);
    }
}

/// Some of each kind of question. @return the first failure
int32_t ask_around(const Bench& b, carom_world_hit hits[2]) {
  const double above[3] = {0, 9, 0}, down[3] = {0, -1, 0};
  carom_query_shapes balls = {};
  balls.struct_size = sizeof balls;
  balls.scalar = CAROM_SCALAR_F64;
  balls.count = 1;
  balls.positions = above;
  balls.motions = down;
  uint64_t count;
  int32_t r = carom_world_cast_ray(b.world, above, down, 20, nullptr, &hits[0], sizeof hits[0], nullptr);
  if (!r) r = carom_world_find_nearest(b.world, &balls, 20, nullptr, &hits[1], 0, nullptr);
  if (!r) r = carom_world_overlap_shapes(b.world, &balls, nullptr, nullptr, 0, 0, &count, nullptr);
  return r;
}

void events_and_rays_of_a_settled_world_allocate_nothing(void**) {
  Ledger ledger;
  const carom_engine_desc desc = ledger.desc();
  Bench b;
  assert_int_equal(bench_make(&b, &desc, nullptr), CAROM_OK);
  assert_int_equal(carom_collider_set_sensor(b.world, b.colliders[2], 1, nullptr), CAROM_OK);
  assert_int_equal(carom_body_ignore_collision(b.world, b.bodies[0], b.bodies[1], 1, nullptr), CAROM_OK);
  assert_int_equal(carom_world_collect_events(b.world, 31, 1, nullptr), CAROM_OK);
  carom_world_hit hits[2];
  assert_int_equal(ask_around(b, hits), CAROM_OK);
  assert_int_equal(bench_steps(b.world, 400, nullptr), CAROM_OK);
  assert_int_equal(ask_around(b, hits), CAROM_OK);
  const double above[3] = {0, 9, 0}, down[3] = {0, -1, 0};
  for (int i = 0; i < 100; ++i) {
    const uint64_t before = ledger.allocations;
    assert_int_equal(bench_steps(b.world, 1, nullptr), CAROM_OK);
    assert_int_equal(carom_world_cast_ray(b.world, above, down, 20, nullptr, hits, sizeof hits[0], nullptr), CAROM_OK);
    assert_int_equal(ledger.allocations - before, 0);
  }
  assert_int_equal(bench_free(&b), CAROM_OK);
  assert_int_equal(ledger.live.size(), 0);
}

/// Ask with the k-th allocation and all later ones failing, then with memory: the same answers as if nothing had been.
void running_out_while_asking_is_an_error_and_no_more(void**) {
  int failed = 0;
  carom_world_hit truth[2] = {}, hits[2];
  for (uint64_t k = 0;; ++k) {
    Ledger ledger;
    const carom_engine_desc desc = ledger.desc();
    Bench b;
    assert_int_equal(bench_make(&b, &desc, nullptr), CAROM_OK);
    assert_int_equal(bench_steps(b.world, 20, nullptr), CAROM_OK);
    ledger.fail_at = ledger.allocations + k;
    std::memset(hits, 0, sizeof hits);
    const int32_t r = ask_around(b, hits);
    if (r != CAROM_OK) {
      ++failed;
      assert_int_equal(r, CAROM_E_OUT_OF_MEMORY);
      ledger.fail_at = ~uint64_t(0);
      assert_int_equal(bench_steps(b.world, 3, nullptr), CAROM_OK);
      assert_int_equal(ask_around(b, hits), CAROM_OK);
      assert_true(hits[0].outcome == CAROM_CAST_HIT && hits[1].outcome == CAROM_CAST_HIT);
    } else {
      std::memcpy(truth, hits, sizeof truth);
    }
    assert_int_equal(bench_free(&b), CAROM_OK);
    assert_int_equal(ledger.live.size(), 0);
    if (r == CAROM_OK) break;
  }
  assert_true(failed > 5 && truth[0].outcome == CAROM_CAST_HIT);
}

/// One more body with its shape and plugin, and steps in which it meets the others.
int32_t enlarge(Bench& b, carom_error* e) {
  static const carom_shape_plugin plugin = bench_plugin("test.more", bench_box_params, 3, nullptr, bench_box);
  const double half[3] = {0.4, 0.3, 0.2};
  carom_plugin handle = 0;
  carom_shape shape = 0;
  carom_body body;
  carom_collider collider;
  if (carom_plugin_find(b.engine, "test.more", &handle, nullptr) != CAROM_OK) {
    const int32_t r = carom_plugin_register(b.engine, &plugin, &handle, e);
    if (r) return r;
  }
  int32_t r = carom_shape_create(b.engine, handle, half, 3, &shape, e);
  if (!r) r = bench_body(b.world, shape, b.material, CAROM_BODY_DYNAMIC, 0.3, 1.6, 0.1, &body, &collider, e);
  return r;
}

/// Builds fail at every allocation in turn: OUT_OF_MEMORY, nothing leaks, and what was there is untouched.
void running_out_at_any_point_of_building_is_an_error_and_no_leak(void**) {
  for (uint64_t k = 0;; ++k) {
    Ledger ledger;
    const carom_engine_desc desc = ledger.desc();
    ledger.fail_at = k;
    Bench b;
    carom_error e = CAROM_ERROR_INIT;
    const int32_t r = bench_make(&b, &desc, &e);
    if (r != CAROM_OK) {
      assert_int_equal(r, CAROM_E_OUT_OF_MEMORY);
      assert_int_equal(e.code, CAROM_E_OUT_OF_MEMORY);
    }
    ledger.fail_at = ~uint64_t(0);
    assert_int_equal(bench_free(&b), CAROM_OK);
    assert_int_equal(ledger.live.size(), 0);
    assert_int_equal(ledger.wrong, 0);
    if (r == CAROM_OK) {
      assert_true(k > 20);
      break;
    }
  }
}

void running_out_while_a_living_world_grows_changes_nothing(void**) {
  for (uint64_t k = 0;; ++k) {
    Ledger ledger;
    const carom_engine_desc desc = ledger.desc();
    Bench b;
    assert_int_equal(bench_make(&b, &desc, nullptr), CAROM_OK);
    assert_int_equal(bench_steps(b.world, 30, nullptr), CAROM_OK);
    const uint64_t hash = bench_hash(b.world);
    uint64_t bodies = 0, after = 0;
    assert_int_equal(carom_world_get_bodies(b.world, nullptr, 0, &bodies, nullptr), CAROM_OK);
    // One call, one body: it is there, or nothing is.
    carom_body_desc d;
    carom_body_desc_init(&d, sizeof d);
    carom_body body = 77;
    ledger.fail_at = ledger.allocations + k;
    const int32_t r = carom_body_create(b.world, &d, &body, nullptr);
    ledger.fail_at = ~uint64_t(0);
    assert_int_equal(carom_world_get_bodies(b.world, nullptr, 0, &after, nullptr), CAROM_OK);
    if (r != CAROM_OK) {
      assert_int_equal(r, CAROM_E_OUT_OF_MEMORY);
      assert_int_equal(body, 77);
      assert_int_equal(after, bodies);
      assert_true(bench_hash(b.world) == hash);
    } else {
      assert_int_equal(after, bodies + 1);
    }
    // And the world goes on.
    assert_int_equal(enlarge(b, nullptr), CAROM_OK);
    assert_int_equal(bench_steps(b.world, 30, nullptr), CAROM_OK);
    assert_int_equal(bench_free(&b), CAROM_OK);
    assert_int_equal(ledger.live.size(), 0);
    if (r == CAROM_OK) break;
  }
}

struct Motion {
  double pose[BENCH_BODIES][7], velocity[BENCH_BODIES][6], force[BENCH_BODIES][6];
};

Motion motion(const Bench& b) {
  Motion m;
  assert_int_equal(carom_world_read(b.world, CAROM_FIELD_POSE, 1, b.bodies, BENCH_BODIES, m.pose, 0, nullptr),
                   CAROM_OK);
  assert_int_equal(carom_world_read(b.world, CAROM_FIELD_VELOCITY, 1, b.bodies, BENCH_BODIES, m.velocity, 0, nullptr),
                   CAROM_OK);
  assert_int_equal(carom_world_read(b.world, CAROM_FIELD_FORCE, 1, b.bodies, BENCH_BODIES, m.force, 0, nullptr),
                   CAROM_OK);
  return m;
}

/// Of the allocations of a step, which fail: odd, so that events are collected in every other case.
const uint64_t kEvery = carom::test::sliced<uint64_t>(1, 3, 11);

/// Step a world with the k-th allocation and all later ones failing: no body has moved, the pending force is still pending,
/// and when memory comes back the world goes on and stands on its floor. (Contact caches may have been dropped.)
void running_out_in_a_step_moves_nothing_and_can_be_taken_up_again(void**) {
  constexpr int kSteps = 60;
  const double push[3] = {0.5, 0, 0}, twist[3] = {0, 0.1, 0};
  int failed_steps = 0;
  for (uint64_t k = 0;; k += kEvery) {
    Ledger ledger;
    const carom_engine_desc desc = ledger.desc();
    Bench b;
    assert_int_equal(bench_make(&b, &desc, nullptr), CAROM_OK);
    assert_int_equal(enlarge(b, nullptr), CAROM_OK);
    assert_int_equal(carom_world_collect_events(b.world, k % 2 ? 7 : 0, 1, nullptr), CAROM_OK);
    assert_int_equal(carom_body_add_force(b.world, b.bodies[0], push, twist, nullptr), CAROM_OK);
    ledger.fail_at = ledger.allocations + k;
    Motion before = motion(b);
    int done = 0;
    int32_t r = CAROM_OK;
    while (done < kSteps && (r = carom_world_step(b.world, 1.0 / 64, nullptr)) == CAROM_OK) {
      ++done;
      before = motion(b);
    }
    if (r != CAROM_OK) {
      ++failed_steps;
      for (int again = 0; again < 2; ++again) {
        assert_int_equal(r, CAROM_E_OUT_OF_MEMORY);
        const Motion after = motion(b);
        assert_memory_equal(&before, &after, sizeof before);
        r = carom_world_step(b.world, 1.0 / 64, nullptr);
      }
      ledger.fail_at = ~uint64_t(0);
      assert_int_equal(bench_steps(b.world, kSteps - done, nullptr), CAROM_OK);
      r = CAROM_E_OUT_OF_MEMORY;
    }
    const Motion end = motion(b);
    for (const auto& p : end.pose)
      assert_true(p[1] > 0.2);  // the smallest half extent is 0.25, the slop 1 mm a contact
    assert_int_equal(bench_free(&b), CAROM_OK);
    assert_int_equal(ledger.live.size(), 0);
    assert_int_equal(ledger.wrong, 0);
    if (r == CAROM_OK && k % 2) break;  // with events and without
  }
  assert_true(failed_steps * kEvery > 5);
}

/// A ball joint between the first two bodies, a hinge between the third and the world.
int32_t join(const Bench& b, carom_joint joints[2]) {
  carom_joint_desc d;
  carom_joint_desc_init(&d, sizeof d);
  d.fields = CAROM_JOINT_WORLD_FRAME;
  d.body_a = b.bodies[0], d.body_b = b.bodies[1];
  int32_t r = carom_joint_create(b.world, &d, &joints[0], nullptr);
  d.kind = CAROM_JOINT_HINGE, d.body_a = CAROM_NULL_HANDLE, d.body_b = b.bodies[2];
  if (!r) r = carom_joint_create(b.world, &d, &joints[1], nullptr);
  return r;
}

/// Two are joined with the k-th allocation failing: they are, or nothing has changed; and the world goes on either way.
void running_out_while_bodies_are_joined_changes_nothing(void**) {
  int failures = 0;
  for (uint64_t k = 0;; ++k) {
    Ledger ledger;
    const carom_engine_desc desc = ledger.desc();
    Bench b;
    assert_int_equal(bench_make(&b, &desc, nullptr), CAROM_OK);
    assert_int_equal(bench_steps(b.world, 30, nullptr), CAROM_OK);
    const uint64_t hash = bench_hash(b.world);
    carom_joint joints[2] = {77, 77};
    uint64_t count = 9;
    ledger.fail_at = ledger.allocations + k;
    const int32_t r = join(b, joints);
    ledger.fail_at = ~uint64_t(0);
    assert_int_equal(carom_world_get_joints(b.world, nullptr, 0, &count, nullptr), CAROM_OK);
    assert_int_equal(count, (joints[0] != 77) + (joints[1] != 77));
    if (r != CAROM_OK) {
      ++failures;
      assert_int_equal(r, CAROM_E_OUT_OF_MEMORY);
      if (count == 0) assert_true(bench_hash(b.world) == hash);
    }
    assert_int_equal(bench_steps(b.world, 30, nullptr), CAROM_OK);
    assert_int_equal(bench_free(&b), CAROM_OK);
    assert_int_equal(ledger.live.size(), 0);
    assert_int_equal(ledger.wrong, 0);
    if (r == CAROM_OK) break;
  }
  assert_true(failures > 2);
}

/// A world with joints, stepped with the k-th allocation and all later ones failing, under each solver that knows them.
void running_out_in_a_step_with_joints_moves_nothing(void**) {
  int failed_steps = 0;
  for (const double solver : {CAROM_SOLVER_SOFT_STEP, CAROM_SOLVER_DIRECT, CAROM_SOLVER_AUTO})
    for (uint64_t k = 0;; k += kEvery) {
      Ledger ledger;
      const carom_engine_desc desc = ledger.desc();
      Bench b;
      carom_joint joints[2];
      assert_int_equal(bench_make(&b, &desc, nullptr), CAROM_OK);
      assert_int_equal(carom_world_set_dial(b.world, CAROM_DIAL_SOLVER, solver, nullptr), CAROM_OK);
      assert_int_equal(join(b, joints), CAROM_OK);
      const Motion before = motion(b);
      ledger.fail_at = ledger.allocations + k;
      const int32_t r = carom_world_step(b.world, 1.0 / 64, nullptr);
      ledger.fail_at = ~uint64_t(0);
      if (r != CAROM_OK) {
        ++failed_steps;
        assert_int_equal(r, CAROM_E_OUT_OF_MEMORY);
        const Motion after = motion(b);
        assert_memory_equal(&before, &after, sizeof before);
      }
      assert_int_equal(bench_steps(b.world, 60, nullptr), CAROM_OK);
      for (const carom_joint joint : joints) {
        carom_joint_state state = {};
        state.struct_size = sizeof state;
        assert_int_equal(carom_joint_get_state(b.world, joint, &state, nullptr), CAROM_OK);
        assert_true(state.gap < 0.01);
      }
      assert_int_equal(bench_free(&b), CAROM_OK);
      assert_int_equal(ledger.live.size(), 0);
      assert_int_equal(ledger.wrong, 0);
      if (r == CAROM_OK) break;
    }
  assert_true(failed_steps * kEvery > 20);
}

/// Each call that adds to a set, with the k-th allocation failing: it is done, or nothing is.
void running_out_while_particles_come_changes_nothing(void**) {
  static const double many[400][3] = {};
  const struct {
    const char* name;
    int32_t (*call)(Bench& b);
    uint64_t count, sets;  // after it
  } calls[] = {
      {"create",
       [](Bench& b) {
         carom_particles s;
         return carom_particles_create(b.world, nullptr, &s, nullptr);
       },
       BENCH_PARTICLES, 2},
      {"add", [](Bench& b) { return carom_particles_add(b.world, b.particles, 400, 1, many, 0, many, 0, nullptr); },
       BENCH_PARTICLES + 400, 1},
      {"masses",
       [](Bench& b) {
         const double kg[BENCH_PARTICLES] = {1, 2, 3, 4, 5};
         return carom_particles_write(b.world, b.particles, CAROM_FIELD_MASS, 1, nullptr, BENCH_PARTICLES, kg, 0,
                                      nullptr);
       },
       BENCH_PARTICLES, 1},
  };
  for (const auto& c : calls)
    for (uint64_t k = 0;; ++k) {
      Ledger ledger;
      const carom_engine_desc desc = ledger.desc();
      Bench b;
      assert_int_equal(bench_make(&b, &desc, nullptr), CAROM_OK);
      assert_int_equal(bench_particles(&b, nullptr), CAROM_OK);
      const uint64_t hash = bench_hash(b.world);
      ledger.fail_at = ledger.allocations + k;
      const int32_t r = c.call(b);
      ledger.fail_at = ~uint64_t(0);
      const bool done = r == CAROM_OK;
      uint64_t count = 0, sets = 0;
      double kg = 0;
      const uint32_t last = BENCH_PARTICLES - 1;
      assert_int_equal(carom_particles_get_count(b.world, b.particles, &count, nullptr), CAROM_OK);
      assert_int_equal(carom_world_get_particles(b.world, nullptr, 0, &sets, nullptr), CAROM_OK);
      assert_int_equal(carom_particles_read(b.world, b.particles, CAROM_FIELD_MASS, 1, &last, 1, &kg, 0, nullptr),
                       CAROM_OK);
      if (!done) assert_int_equal(r, CAROM_E_OUT_OF_MEMORY);
      if (!done) assert_true(bench_hash(b.world) == hash);
      assert_int_equal(count, done ? c.count : BENCH_PARTICLES);
      assert_int_equal(sets, done ? c.sets : 1);
      assert_true(kg == (done && c.name[0] == 'm' ? 5 : 1));
      assert_int_equal(bench_steps(b.world, 3, nullptr), CAROM_OK);
      assert_int_equal(bench_free(&b), CAROM_OK);
      assert_int_equal(ledger.live.size(), 0);
      assert_int_equal(ledger.wrong, 0);
      if (done) {
        assert_true(k > 0);  // the call needed memory, or this proves nothing
        break;
      }
    }
}

/// Destroying may need memory too (a list of what to forget): all of a body goes, or nothing.
void running_out_while_destroying_changes_nothing(void**) {
  for (uint64_t k = 0; k < 4; ++k) {
    Ledger ledger;
    const carom_engine_desc desc = ledger.desc();
    Bench b;
    assert_int_equal(bench_make(&b, &desc, nullptr), CAROM_OK);
    assert_int_equal(bench_steps(b.world, 60, nullptr), CAROM_OK);
    carom_collider_desc second;
    carom_collider_desc_init(&second, sizeof second);
    second.shape = b.crate;
    carom_collider collider;
    assert_int_equal(carom_collider_create(b.world, b.bodies[0], &second, &collider, nullptr), CAROM_OK);
    assert_int_equal(bench_steps(b.world, 2, nullptr), CAROM_OK);
    const uint64_t hash = bench_hash(b.world);
    ledger.fail_at = ledger.allocations + k;
    const int32_t r = carom_body_destroy(b.world, b.bodies[0], nullptr);
    ledger.fail_at = ~uint64_t(0);
    carom_body body;
    const int32_t there = carom_collider_get(b.world, collider, &second, &body, nullptr);
    if (r == CAROM_OK) {
      assert_int_equal(there, CAROM_E_STALE_HANDLE);
    } else {
      assert_int_equal(r, CAROM_E_OUT_OF_MEMORY);
      assert_int_equal(there, CAROM_OK);
      assert_true(bench_hash(b.world) == hash);
    }
    assert_int_equal(bench_steps(b.world, 10, nullptr), CAROM_OK);
    assert_int_equal(bench_free(&b), CAROM_OK);
    assert_int_equal(ledger.live.size(), 0);
  }
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(everything_comes_from_the_host_and_goes_back),
      cmocka_unit_test(an_empty_world_costs_kilobytes),
      cmocka_unit_test(steps_of_a_settled_world_allocate_nothing),
      cmocka_unit_test(events_and_rays_of_a_settled_world_allocate_nothing),
      cmocka_unit_test(running_out_while_asking_is_an_error_and_no_more),
      cmocka_unit_test(running_out_at_any_point_of_building_is_an_error_and_no_leak),
      cmocka_unit_test(running_out_while_a_living_world_grows_changes_nothing),
      cmocka_unit_test(running_out_in_a_step_moves_nothing_and_can_be_taken_up_again),
      cmocka_unit_test(running_out_while_bodies_are_joined_changes_nothing),
      cmocka_unit_test(running_out_in_a_step_with_joints_moves_nothing),
      cmocka_unit_test(running_out_while_particles_come_changes_nothing),
      cmocka_unit_test(running_out_while_destroying_changes_nothing),
  };
  return cmocka_run_group_tests_name("abi/alloc", tests, nullptr, nullptr);
}
