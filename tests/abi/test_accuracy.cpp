// Accuracy through the boundary: asked for, told, refused; the same bits on any number of threads and after a snapshot;
// and nothing where nothing is asked.
#include "snapshot_stage.h"

namespace {

constexpr double kStep = 1.0 / 60;

carom_accuracy asked(double place, double turn, std::uint32_t most = 256) {
  carom_accuracy a;
  assert_int_equal(carom_accuracy_init(&a, sizeof a), CAROM_OK);
  a.place = place, a.turn = turn, a.substeps = most;
  return a;
}
void ask(carom_world* world, double tolerance, std::uint32_t most = 256) {
  const carom_accuracy a = asked(tolerance, tolerance, most);
  assert_int_equal(carom_world_set_accuracy(world, &a, nullptr), CAROM_OK);
}
void step(carom_world* world, int times) {
  for (int i = 0; i < times; ++i) assert_int_equal(carom_world_step(world, kStep, nullptr), CAROM_OK);
}
std::uint64_t hash_of(carom_world* world) {
  std::uint64_t hash = 0;
  assert_int_equal(carom_world_hash(world, &hash, nullptr), CAROM_OK);
  return hash;
}
std::vector<carom_island> islands(carom_world* world) {
  std::uint64_t count = 0;
  assert_int_equal(carom_world_get_islands(world, nullptr, sizeof(carom_island), 0, &count, nullptr), CAROM_OK);
  std::vector<carom_island> all(count);
  assert_int_equal(carom_world_get_islands(world, all.data(), sizeof(carom_island), count, &count, nullptr), CAROM_OK);
  return all;
}

void what_is_asked_can_be_read_and_taken_back(void**) {
  Bench b;
  assert_int_equal(bench_make(&b, nullptr, nullptr), CAROM_OK);
  carom_accuracy got = asked(1, 1);
  std::uint32_t present = 7;
  assert_int_equal(carom_world_get_accuracy(b.world, &got, &present, nullptr), CAROM_OK);
  assert_int_equal(present, 0);
  assert_true(got.place == 1e-3 && got.turn == 1e-3 && got.substeps == 256);
  const carom_accuracy a = asked(1e-4, 0, 64);
  assert_int_equal(carom_world_set_accuracy(b.world, &a, nullptr), CAROM_OK);
  assert_int_equal(carom_world_get_accuracy(b.world, &got, &present, nullptr), CAROM_OK);
  assert_int_equal(present, 1);
  assert_true(got.place == 1e-4 && got.turn == 0 && got.substeps == 64);
  double dial = 0;
  assert_int_equal(carom_world_get_dial(b.world, CAROM_DIAL_ACCURACY_PLACE, &dial, nullptr), CAROM_OK);
  assert_true(dial == 1e-4);
  step(b.world, 3);
  assert_true(islands(b.world).size() > 0);
  assert_int_equal(carom_world_set_accuracy(b.world, nullptr, nullptr), CAROM_OK);
  step(b.world, 1);
  assert_int_equal(islands(b.world).size(), 0);
  assert_int_equal(bench_free(&b), CAROM_OK);
}

/// A world that was saved, on so many threads.
Bench bench_of(const Bytes& whole, std::uint32_t threads) {
  carom_jobs_desc jobs;
  assert_int_equal(carom_jobs_desc_init(&jobs, sizeof jobs), CAROM_OK);
  jobs.threads = threads;
  Bench b;
  std::memset(&b, 0, sizeof b);
  assert_int_equal(carom_engine_create(nullptr, &b.engine, nullptr), CAROM_OK);
  if (threads > 1) assert_int_equal(carom_engine_set_jobs(b.engine, &jobs, nullptr), CAROM_OK);
  assert_int_equal(bench_shapes(&b, nullptr), CAROM_OK);
  assert_int_equal(carom_world_create(b.engine, nullptr, &b.world, nullptr), CAROM_OK);
  assert_int_equal(restore(b.world, whole), CAROM_OK);
  return b;
}

/// Copies are measured: the world keeps its bits, and the same answer comes again, on any number of threads.
void growth_is_measured_beside_the_world(void**) {
  carom_growth first{};
  Bench made;
  make(made);
  const Bytes whole = save(made.world, CAROM_SNAPSHOT_WHOLE);
  assert_int_equal(bench_free(&made), CAROM_OK);
  for (const std::uint32_t threads : {1u, 2u}) {
    Bench b = bench_of(whole, threads);
    ask(b.world, 1e-3);
    step(b.world, 3);
    const std::uint64_t before = hash_of(b.world);
    for (int k = 0; k < 2; ++k) {
      carom_growth growth{};
      growth.struct_size = sizeof growth;
      assert_int_equal(carom_world_measure_growth(b.world, kStep, 60, &growth, nullptr), CAROM_OK);
      if (first.steps == 0) first = growth;
      assert_true(growth.steps == first.steps && growth.factor == first.factor && growth.rate == first.rate);
      assert_true(growth.steps > 0 && growth.body != CAROM_NULL_HANDLE && growth.factor > 0);
      assert_int_equal(hash_of(b.world), before);
    }
    assert_int_equal(bench_free(&b), CAROM_OK);
  }
}

/// What was asked before still stands.
void what_can_not_be_asked_is_refused_with_a_remedy(void**) {
  Bench b;
  assert_int_equal(bench_make(&b, nullptr, nullptr), CAROM_OK);
  ask(b.world, 1e-4);
  const double nan = std::nan("");
  const struct {
    carom_accuracy a;
    int32_t code;
    const char* names;
  } bad[] = {
      {asked(-1, 1), CAROM_E_OUT_OF_RANGE, "accuracy->place"},
      {asked(1, -1), CAROM_E_OUT_OF_RANGE, "accuracy->turn"},
      {asked(nan, 1), CAROM_E_NOT_FINITE, "accuracy->place"},
      {asked(1, HUGE_VAL), CAROM_E_NOT_FINITE, "accuracy->turn"},
      {asked(0, 0), CAROM_E_OUT_OF_RANGE, "NULL"},
      {asked(1, 1, 0), CAROM_E_OUT_OF_RANGE, "accuracy->substeps"},
      {asked(1, 1, 1), CAROM_E_OUT_OF_RANGE, "accuracy->substeps"},
      {asked(1, 1, 5000), CAROM_E_OUT_OF_RANGE, "accuracy->substeps"},
  };
  for (const auto& row : bad) {
    carom_error error{};
    error.struct_size = sizeof error;
    assert_int_equal(carom_world_set_accuracy(b.world, &row.a, &error), row.code);
    assert_non_null(std::strstr(error.message, row.names));
  }
  carom_accuracy small = asked(1, 1);
  small.struct_size = 3;
  assert_int_equal(carom_world_set_accuracy(b.world, &small, nullptr), CAROM_E_STRUCT_SIZE);
  carom_accuracy got = asked(1, 1);
  std::uint32_t present = 0;
  assert_int_equal(carom_world_get_accuracy(b.world, &got, &present, nullptr), CAROM_OK);
  assert_true(got.place == 1e-4 && got.substeps == 256);
  assert_int_equal(bench_free(&b), CAROM_OK);
}

/// Bodies that fall, roll and swing.
void the_same_bits_come_again_on_any_number_of_threads(void**) {
  Bench made;
  make(made);
  const Bytes whole = save(made.world, CAROM_SNAPSHOT_WHOLE);
  assert_int_equal(bench_free(&made), CAROM_OK);
  std::uint64_t first = 0;
  for (const std::uint32_t threads : {1u, 4u, 1u}) {
    Bench b = bench_of(whole, threads);
    ask(b.world, 1e-4);
    step(b.world, 90);
    const std::uint64_t hash = hash_of(b.world);
    if (first == 0) first = hash;
    assert_true(hash == first);
    assert_int_equal(carom_world_destroy(b.world, nullptr), CAROM_OK);
    assert_int_equal(carom_engine_destroy(b.engine, nullptr), CAROM_OK);
  }
}

/// In the middle of what the islands remember.
void a_snapshot_goes_on_with_the_same_bits(void**) {
  for (const int at : {7, 20, 61}) {
    Bench b;
    make(b);
    ask(b.world, 1e-4);
    step(b.world, at);
    const Bytes state = save(b.world), whole = save(b.world, CAROM_SNAPSHOT_WHOLE);
    step(b.world, 30);
    const std::uint64_t hash = hash_of(b.world);
    assert_int_equal(restore(b.world, state), CAROM_OK);
    step(b.world, 30);
    assert_true(hash_of(b.world) == hash);
    carom_world* fork = nullptr;
    assert_int_equal(restore(b.world, state), CAROM_OK);
    assert_int_equal(carom_world_fork(b.world, &fork, nullptr), CAROM_OK);
    step(fork, 30);
    assert_true(hash_of(fork) == hash);
    assert_int_equal(carom_world_destroy(fork, nullptr), CAROM_OK);
    assert_int_equal(bench_free(&b), CAROM_OK);
  }
}

/// Worst first, and a bound of work that is hit is told.
void islands_are_told_worst_first_and_a_bound_that_is_hit(void**) {
  Bench b;
  make(b);
  ask(b.world, 1e-9, 4);
  bool hit = false;
  for (int k = 0; k < 30; ++k) {
    step(b.world, 1);
    double before = HUGE_VAL;
    for (const carom_island& i : islands(b.world)) {
      assert_true(i.share <= before);
      before = i.share;
      assert_true(i.substeps >= 1 && i.substeps <= 4 && i.work >= i.substeps && i.bodies >= 1 && i.order >= 1);
      assert_true(i.place >= 0 && i.turn >= 0);
      assert_true(!(i.flags & CAROM_ISLAND_BOUND) || i.substeps == 4);
      if (i.flags & CAROM_ISLAND_BOUND && i.flags & CAROM_ISLAND_ESTIMATED) assert_true(i.share > 1), hit = true;
    }
  }
  assert_true(hit);
  assert_int_equal(bench_free(&b), CAROM_OK);
}

/// A world that never asked, and one that asked and took it back before a step.
void who_asks_nothing_gets_the_bits_of_always(void**) {
  Bench one, other;
  make(one), make(other);
  ask(other.world, 1e-4);
  assert_int_equal(carom_world_set_accuracy(other.world, nullptr, nullptr), CAROM_OK);
  step(one.world, 60), step(other.world, 60);
  assert_true(hash_of(one.world) == hash_of(other.world));
  assert_int_equal(islands(one.world).size(), 0);
  assert_int_equal(bench_free(&one), CAROM_OK);
  assert_int_equal(bench_free(&other), CAROM_OK);
}

/// The ledger is told of accepted runs alone: it sums up as ever, and changes no bit.
void a_ledger_sums_up_and_changes_no_bit(void**) {
  Bench one, other;
  make(one), make(other);
  ask(one.world, 1e-4), ask(other.world, 1e-4);
  assert_int_equal(carom_world_enable_ledger(other.world, 1, nullptr), CAROM_OK);
  for (int k = 0; k < 60; ++k) {
    step(one.world, 1), step(other.world, 1);
    assert_true(hash_of(one.world) == hash_of(other.world));
    carom_ledger_state s{};
    s.struct_size = sizeof s;
    assert_int_equal(carom_world_get_ledger_state(other.world, &s, nullptr), CAROM_OK);
    std::uint64_t count = 0;
    carom_ledger_entry entries[64];
    assert_int_equal(carom_world_get_ledger(other.world, entries, sizeof *entries, 64, &count, nullptr), CAROM_OK);
    double gained = 0;
    for (std::uint64_t i = 0; i < count; ++i) gained += entries[i].kinetic + entries[i].potential;
    const double change = s.now_kinetic + s.now_potential - s.before_kinetic - s.before_potential;
    assert_true(std::fabs(gained - change) <= s.rounding_energy);
  }
  assert_int_equal(bench_free(&one), CAROM_OK);
  assert_int_equal(bench_free(&other), CAROM_OK);
}

}  // namespace

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(what_is_asked_can_be_read_and_taken_back),
      cmocka_unit_test(growth_is_measured_beside_the_world),
      cmocka_unit_test(what_can_not_be_asked_is_refused_with_a_remedy),
      cmocka_unit_test(the_same_bits_come_again_on_any_number_of_threads),
      cmocka_unit_test(a_snapshot_goes_on_with_the_same_bits),
      cmocka_unit_test(islands_are_told_worst_first_and_a_bound_that_is_hit),
      cmocka_unit_test(who_asks_nothing_gets_the_bits_of_always),
      cmocka_unit_test(a_ledger_sums_up_and_changes_no_bit),
  };
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
