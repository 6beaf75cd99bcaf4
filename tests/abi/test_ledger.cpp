// The ledger as a host reads it: causes and sums, the same bits for any number of threads, memory asked for and refused.
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "bench.h"
#include "carom_test.h"

namespace {

std::vector<carom_ledger_entry> causes_of(carom_world* world) {
  uint64_t count = 0;
  assert_int_equal(carom_world_get_ledger(world, nullptr, 0, 0, &count, nullptr), CAROM_OK);
  std::vector<carom_ledger_entry> list(count);  // all zero
  assert_int_equal(carom_world_get_ledger(world, list.data(), sizeof(carom_ledger_entry), count, &count, nullptr),
                   CAROM_OK);
  return list;
}

carom_ledger_state state_of(carom_world* world) {
  carom_ledger_state state;
  std::memset(&state, 0, sizeof state);
  state.struct_size = sizeof state;
  assert_int_equal(carom_world_get_ledger_state(world, &state, nullptr), CAROM_OK);
  return state;
}

/// Sums of the causes against the state, in the last step and since the ledger began.
void assert_closes(carom_world* world) {
  const carom_ledger_state s = state_of(world);
  double step[8] = {}, since[8] = {};
  for (const carom_ledger_entry& e : causes_of(world)) {
    step[0] += e.kinetic + e.potential, since[0] += e.total_kinetic + e.total_potential;
    for (int i = 0; i < 3; ++i) {
      step[1 + i] += e.linear[i], since[1 + i] += e.total_linear[i];
      step[4 + i] += e.angular[i], since[4 + i] += e.total_angular[i];
    }
  }
  const auto near = [](double sum, double change, double bound) { assert_true(std::fabs(sum - change) <= bound); };
  near(step[0], s.now_kinetic + s.now_potential - (s.before_kinetic + s.before_potential), s.rounding_energy);
  near(since[0], s.now_kinetic + s.now_potential - (s.start_kinetic + s.start_potential), s.total_rounding_energy);
  for (int i = 0; i < 3; ++i) {
    near(step[1 + i], s.now_linear[i] - s.before_linear[i], s.rounding_linear);
    near(since[1 + i], s.now_linear[i] - s.start_linear[i], s.total_rounding_linear);
    near(step[4 + i], s.now_angular[i] - s.before_angular[i], s.rounding_angular);
    near(since[4 + i], s.now_angular[i] - s.start_angular[i], s.total_rounding_angular);
  }
}

void a_host_reads_causes_by_name(void**) {
  Bench b;
  assert_int_equal(bench_make(&b, nullptr, nullptr), CAROM_OK);
  assert_true(causes_of(b.world).empty() && state_of(b.world).is_kept == 0);
  assert_int_equal(carom_world_enable_ledger(b.world, 1, nullptr), CAROM_OK);
  const carom_ledger_state first = state_of(b.world);
  assert_true(first.is_kept == 1 && first.steps == 0 && first.now_potential > 0 &&
              first.now_potential == first.start_potential);
  for (int i = 0; i < 100; ++i) assert_int_equal(bench_steps(b.world, 1, nullptr), CAROM_OK), assert_closes(b.world);
  std::string names;
  for (const carom_ledger_entry& e : causes_of(b.world)) names += std::string(e.name) + ' ';
  for (const char* name :
       {"host ", "contact ", "friction ", "restitution ", "resistance ", "joints ", "drives ", "continuous ",
        "axis_locks ", "correction ", "sleep ", "quarantine ", "integrator ", "unassigned ", "linear_damping ",
        "angular_damping ", "gravity ", "user_force ", "user_torque "})
    assert_non_null(std::strstr(names.c_str(), name));
  assert_null(std::strstr(names.c_str(), "gyroscopic"));
  // As many as fit, at a stride of the host's.
  struct Wide {
    carom_ledger_entry entry;
    double mine;
  } some[2] = {{{}, 7}, {{}, 7}};
  uint64_t count = 0;
  assert_int_equal(carom_world_get_ledger(b.world, &some[0].entry, sizeof(Wide), 2, &count, nullptr), CAROM_OK);
  assert_true(count == causes_of(b.world).size() && some[0].mine == 7 && some[1].mine == 7);
  assert_string_equal(some[1].entry.name, "contact");
  // Anew, and not any more.
  assert_int_equal(carom_world_enable_ledger(b.world, 1, nullptr), CAROM_OK);
  assert_true(state_of(b.world).steps == 0 && state_of(b.world).total_rounding_energy == 0);
  assert_int_equal(carom_world_enable_ledger(b.world, 0, nullptr), CAROM_OK);
  assert_true(causes_of(b.world).empty());
  assert_int_equal(bench_free(&b), CAROM_OK);
}

/// A crowd: the bench many times over, falling into a heap.
struct Heap {
  Bench b{};

  Heap(uint32_t solver, uint32_t threads, bool keeps) {
    carom_jobs_desc jobs;
    carom_jobs_desc_init(&jobs, sizeof jobs);
    jobs.threads = threads;
    assert_int_equal(carom_engine_create(nullptr, &b.engine, nullptr), CAROM_OK);
    assert_int_equal(carom_engine_set_jobs(b.engine, threads > 1 ? &jobs : nullptr, nullptr), CAROM_OK);
    assert_int_equal(bench_shapes(&b, nullptr), CAROM_OK);
    assert_int_equal(carom_world_create(b.engine, nullptr, &b.world, nullptr), CAROM_OK);
    assert_int_equal(bench_bodies(&b, nullptr), CAROM_OK);
    carom_body body;
    carom_collider collider;
    for (int i = 0; i < (solver == CAROM_SOLVER_SOFT_STEP ? 200 : 40); ++i)  // the others take long over crowds
      assert_int_equal(bench_body(b.world, i % 3 ? b.crate : b.ball, b.material, CAROM_BODY_DYNAMIC, i % 5 * 0.9,
                                  3 + 0.8 * (i / 25), i / 5 % 5 * 1.3 + 0.01 * i, &body, &collider, nullptr),
                       CAROM_OK);
    assert_int_equal(bench_particles(&b, nullptr), CAROM_OK);
    assert_int_equal(carom_world_set_dial(b.world, CAROM_DIAL_SOLVER, solver, nullptr), CAROM_OK);
    if (solver != CAROM_SOLVER_SEVERITY) assert_int_equal(bench_joint(&b, nullptr), CAROM_OK);
    if (keeps) assert_int_equal(carom_world_enable_ledger(b.world, 1, nullptr), CAROM_OK);
  }
  ~Heap() { assert_int_equal(bench_free(&b), CAROM_OK); }
};

void the_number_of_threads_changes_no_bit_of_it(void**) {
  for (uint32_t solver = 0; solver <= CAROM_SOLVER_AUTO; ++solver) {
    const int steps = 16;
    Heap without(solver, 1, false), alone(solver, 1, true);
    assert_int_equal(bench_steps(without.b.world, steps, nullptr), CAROM_OK);
    for (int i = 0; i < steps; ++i)
      assert_int_equal(bench_steps(alone.b.world, 1, nullptr), CAROM_OK), assert_closes(alone.b.world);
    assert_true(bench_hash(without.b.world) == bench_hash(alone.b.world));
    const std::vector<carom_ledger_entry> truth = causes_of(alone.b.world);
    for (const uint32_t threads : {2u, 4u}) {
      Heap shared(solver, threads, true);
      assert_int_equal(bench_steps(shared.b.world, steps, nullptr), CAROM_OK);
      const std::vector<carom_ledger_entry> causes = causes_of(shared.b.world);
      assert_true(causes.size() == truth.size() &&
                  std::memcmp(causes.data(), truth.data(), truth.size() * sizeof truth[0]) == 0);
    }
  }
}

/// Counts, and refuses from a call on.
struct Purse {
  uint64_t calls = 0, refuse_from = ~uint64_t(0);
  carom_engine_desc desc() {
    carom_engine_desc d;
    carom_engine_desc_init(&d, sizeof d);
    d.alloc_user = this;
    d.alloc = [](void* user, uint64_t size, uint64_t alignment) -> void* {
      Purse& p = *static_cast<Purse*>(user);
      return p.calls++ >= p.refuse_from ? nullptr : std::aligned_alloc(alignment, (size / alignment + 1) * alignment);
    };
    d.free = [](void*, void* p, uint64_t, uint64_t) { std::free(p); };
    return d;
  }
};

void a_settled_world_books_without_allocating(void**) {
  Purse purse;
  const carom_engine_desc desc = purse.desc();
  Bench b;
  assert_int_equal(bench_make(&b, &desc, nullptr), CAROM_OK);
  assert_int_equal(bench_particles(&b, nullptr), CAROM_OK);
  assert_int_equal(bench_steps(b.world, 800, nullptr), CAROM_OK);
  const uint64_t before = purse.calls;
  assert_int_equal(carom_world_enable_ledger(b.world, 0, nullptr), CAROM_OK);  // off: nothing, not even once
  assert_int_equal(bench_steps(b.world, 10, nullptr), CAROM_OK);
  assert_int_equal(purse.calls, before);
  assert_int_equal(carom_world_enable_ledger(b.world, 1, nullptr), CAROM_OK);
  assert_int_equal(bench_steps(b.world, 2, nullptr), CAROM_OK);
  assert_true(purse.calls > before);
  const uint64_t kept = purse.calls;
  assert_int_equal(bench_steps(b.world, 100, nullptr), CAROM_OK);
  assert_int_equal(purse.calls, kept);
  assert_int_equal(bench_free(&b), CAROM_OK);
}

void running_out_of_memory_leaves_the_books_in_order(void**) {
  int refused = 0, refused_steps = 0;
  for (const double solver : {CAROM_SOLVER_SEVERITY, CAROM_SOLVER_SOFT_STEP, CAROM_SOLVER_AUTO})
    for (uint64_t k = 0;; ++k) {
      Purse purse;
      const carom_engine_desc desc = purse.desc();
      Bench b;
      const double push[3] = {1, 2, 0}, at[3] = {0, 1, 0};
      assert_int_equal(bench_make(&b, &desc, nullptr), CAROM_OK);
      assert_int_equal(bench_particles(&b, nullptr), CAROM_OK);
      assert_int_equal(carom_world_set_dial(b.world, CAROM_DIAL_SOLVER, solver, nullptr), CAROM_OK);
      purse.refuse_from = purse.calls + k;
      const int32_t on = carom_world_enable_ledger(b.world, 1, nullptr);
      int32_t step = CAROM_OK;
      if (on == CAROM_OK) {
        assert_int_equal(carom_body_add_impulse(b.world, b.bodies[0], push, at, nullptr), CAROM_OK);
        step = bench_steps(b.world, 30, nullptr);
        if (step != CAROM_OK) assert_int_equal(carom_world_step(b.world, 1.0 / 64, nullptr), CAROM_E_OUT_OF_MEMORY);
        assert_int_equal(carom_body_add_impulse(b.world, b.bodies[1], push, at, nullptr), CAROM_OK);
      } else {
        assert_int_equal(on, CAROM_E_OUT_OF_MEMORY);
        assert_true(state_of(b.world).is_kept == 0);
        ++refused;
      }
      purse.refuse_from = ~uint64_t(0);
      if (on != CAROM_OK) assert_int_equal(carom_world_enable_ledger(b.world, 1, nullptr), CAROM_OK);
      refused_steps += step != CAROM_OK;
      for (int i = 0; i < 40; ++i) assert_int_equal(bench_steps(b.world, 1, nullptr), CAROM_OK), assert_closes(b.world);
      const double host = causes_of(b.world)[0].total_linear[0];
      assert_true(std::fabs(host - (on == CAROM_OK ? 2 : 0)) < 1e-12);  // each push once
      assert_int_equal(bench_free(&b), CAROM_OK);
      if (on == CAROM_OK && step == CAROM_OK) break;
    }
  assert_true(refused > 5 && refused_steps > 30);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(a_host_reads_causes_by_name),
      cmocka_unit_test(the_number_of_threads_changes_no_bit_of_it),
      cmocka_unit_test(a_settled_world_books_without_allocating),
      cmocka_unit_test(running_out_of_memory_leaves_the_books_in_order),
  };
  return cmocka_run_group_tests_name("abi/ledger", tests, nullptr, nullptr);
}
