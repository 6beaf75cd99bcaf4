// Several threads at once: worlds stepped side by side over shared shapes while others make and destroy shapes, plugins,
// engines and worlds. Same bits as alone. (The thread sanitizer's run of this test is the point of it.)
#include <atomic>
#include <cstdio>
#include <thread>
#include <vector>

#include "bench.h"
#include "carom_test.h"

namespace {

constexpr int kThreads = 4, kSteps = 120;

/// A world of its own over the shapes of `shared`, stepped; its hash.
uint64_t run_world(const Bench& shared) {
  Bench own = shared;
  int32_t r = carom_world_create(shared.engine, nullptr, &own.world, nullptr);
  if (!r) r = bench_bodies(&own, nullptr);
  if (!r) r = bench_steps(own.world, kSteps, nullptr);
  const uint64_t hash = r ? 0 : bench_hash(own.world);
  if (own.world && carom_world_destroy(own.world, nullptr) != CAROM_OK) return 0;
  return hash;
}

/// What a host may do at any time on any thread. @return whether all went as it should
bool make_and_destroy(const Bench& shared, int seed) {
  char id[32];
  std::snprintf(id, sizeof id, "test.box%d", seed);
  const carom_shape_plugin plugin = bench_plugin(id, bench_box_params, 3, &bench_box_geometry, bench_box);
  carom_plugin handle, found;
  carom_shape shape;
  const double half[3] = {1, 2, 3}, zero[3] = {0, 0, 0}, far[3] = {0, 9, 0}, upright[4] = {0, 0, 0, 1};
  carom_distance distance = {};
  distance.struct_size = sizeof distance;
  carom_engine* engine = nullptr;
  return carom_plugin_register(shared.engine, &plugin, &handle, nullptr) == CAROM_OK &&
         carom_plugin_find(shared.engine, "test.sphere", &found, nullptr) == CAROM_OK &&
         carom_shape_create(shared.engine, handle, half, 3, &shape, nullptr) == CAROM_OK &&
         carom_shape_distance(shared.engine, shape, zero, upright, shared.ball, far, upright, nullptr, &distance,
                              nullptr) == CAROM_OK &&
         std::fabs(distance.separation - 6.5) < 1e-5 &&  // 9 - 2 - 0.5, to the default tolerance of the smaller radius
         carom_shape_destroy(shared.engine, shape, nullptr) == CAROM_OK &&
         carom_plugin_unload(shared.engine, handle, nullptr) == CAROM_OK &&
         carom_engine_create(nullptr, &engine, nullptr) == CAROM_OK &&
         carom_engine_destroy(engine, nullptr) == CAROM_OK;
}

void worlds_on_threads_get_the_same_bits_as_alone(void**) {
  Bench shared;
  assert_int_equal(bench_make(&shared, nullptr, nullptr), CAROM_OK);
  const uint64_t alone = run_world(shared);
  assert_true(alone != 0);
  std::atomic<int> wrong{0}, running{kThreads};
  std::vector<std::thread> threads;
  for (int t = 0; t < kThreads; ++t)
    threads.emplace_back([&] {
      for (int i = 0; i < 3; ++i) wrong += run_world(shared) != alone;
      --running;
    });
  for (int t = 0; t < 2; ++t)
    threads.emplace_back([&, t] {
      while (running > 0) wrong += !make_and_destroy(shared, t);
    });
  for (std::thread& t : threads) t.join();
  assert_int_equal(wrong, 0);
  assert_int_equal(bench_free(&shared), CAROM_OK);
}

void readers_run_side_by_side_and_a_writer_among_them_is_busy_or_done(void**) {
  Bench b;
  assert_int_equal(bench_make(&b, nullptr, nullptr), CAROM_OK);
  std::atomic<int> wrong{0}, reads{0};
  std::atomic<bool> stop{false};
  std::vector<std::thread> threads;
  for (int t = 0; t < 3; ++t)
    threads.emplace_back([&] {
      while (!stop) {
        double pose[BENCH_BODIES][7];
        const int32_t r =
            carom_world_read(b.world, CAROM_FIELD_POSE, CAROM_SCALAR_F64, b.bodies, BENCH_BODIES, pose, 0, nullptr);
        if (r == CAROM_OK) {
          ++reads;
          for (const auto& p : pose) {  // never a half-written one
            const double length2 = p[3] * p[3] + p[4] * p[4] + p[5] * p[5] + p[6] * p[6];
            wrong += !(std::fabs(length2 - 1) < 1e-9);
          }
        } else {
          wrong += r != CAROM_E_BUSY;
        }
        std::this_thread::yield();
      }
    });
  int done = 0;
  for (int i = 0; i < 200000 && (done < 50 || reads < 50); ++i) {
    const int32_t r = carom_world_step(b.world, 1.0 / 256, nullptr);
    done += r == CAROM_OK;
    wrong += r != CAROM_OK && r != CAROM_E_BUSY;
    if (i % 8 == 0) std::this_thread::yield();
  }
  stop = true;
  for (std::thread& t : threads) t.join();
  assert_int_equal(wrong, 0);
  assert_true(done >= 50 && reads >= 50);
  assert_int_equal(bench_free(&b), CAROM_OK);
}

void two_readers_at_once_are_both_served(void**) {
  Bench b;
  assert_int_equal(bench_make(&b, nullptr, nullptr), CAROM_OK);
  std::atomic<int> wrong{0};
  std::vector<std::thread> threads;
  for (int t = 0; t < kThreads; ++t)
    threads.emplace_back([&] {
      for (int i = 0; i < 500; ++i) {
        uint64_t hash;
        double gravity[3];
        wrong += carom_world_hash(b.world, &hash, nullptr) != CAROM_OK;
        wrong += carom_world_get_gravity(b.world, gravity, nullptr) != CAROM_OK;
      }
    });
  for (std::thread& t : threads) t.join();
  assert_int_equal(wrong, 0);
  assert_int_equal(bench_free(&b), CAROM_OK);
}

void questions_side_by_side_get_the_answers_of_one(void**) {
  // Each round a body is moved, then all ask at once: one of them brings the index up to date.
  Bench b;
  assert_int_equal(bench_make(&b, nullptr, nullptr), CAROM_OK);
  constexpr int kRounds = 60, kRays = 64;
  std::vector<double> ends(3 * kRays);
  for (int i = 0; i < kRays; ++i) ends[3 * i] = -1 + 0.07 * i, ends[3 * i + 1] = 9, ends[3 * i + 2] = 0.01 * i;
  const double down[3] = {0, -1, 0};
  std::vector<double> ways(3 * kRays);
  for (int i = 0; i < kRays; ++i) ways[3 * i + 1] = down[1];
  const auto ask = [&](double times[kRays]) {
    carom_rays rays = {};
    rays.struct_size = sizeof rays;
    rays.scalar = CAROM_SCALAR_F64;
    rays.count = kRays;
    rays.origins = ends.data();
    rays.directions = ways.data();
    std::vector<double> max(kRays, 100);
    rays.max = max.data();
    carom_world_hits hits = {};
    hits.struct_size = sizeof hits;
    hits.scalar = CAROM_SCALAR_F64;
    hits.times = times;
    carom_query_shapes ball = {};
    ball.struct_size = sizeof ball;
    ball.scalar = CAROM_SCALAR_F64;
    ball.count = 1;
    ball.shapes = &b.ball;
    ball.positions = ends.data();
    carom_world_hit hit;
    return carom_world_cast_rays(b.world, &rays, CAROM_WANT_FIRST, nullptr, &hits, nullptr) == CAROM_OK &&
           carom_world_find_nearest(b.world, &ball, 100, nullptr, &hit, 0, nullptr) == CAROM_OK;
  };
  for (int round = 0; round < kRounds; ++round) {
    const double place[3] = {0.05 * round, 2, 0}, upright[4] = {0, 0, 0, 1};
    if (round % 3 == 2)
      assert_int_equal(bench_steps(b.world, 1, nullptr), CAROM_OK);
    else
      assert_int_equal(carom_body_set_pose(b.world, b.bodies[round % 4], place, upright, nullptr), CAROM_OK);
    double told[kThreads][kRays];
    std::atomic<int> wrong{0}, ready{0};
    std::vector<std::thread> threads;
    for (int t = 0; t < kThreads; ++t)
      threads.emplace_back([&, t] {
        ++ready;
        while (ready < kThreads) std::this_thread::yield();
        wrong += !ask(told[t]);
      });
    for (std::thread& t : threads) t.join();
    assert_int_equal(wrong, 0);
    double alone[kRays];
    assert_true(ask(alone));
    for (const auto& times : told) assert_memory_equal(times, alone, sizeof alone);
  }
  assert_int_equal(bench_free(&b), CAROM_OK);
}

void tags_of_the_dead_are_given_out_again(void**) {
  // More lives than there are numbers: 65,535 at once, but any number in a row.
  carom_engine* engine = nullptr;
  assert_int_equal(carom_engine_create(nullptr, &engine, nullptr), CAROM_OK);
  for (int i = 0; i < 70000; ++i) {
    carom_engine* other = nullptr;
    assert_int_equal(carom_engine_create(nullptr, &other, nullptr), CAROM_OK);
    assert_int_equal(carom_engine_destroy(other, nullptr), CAROM_OK);
  }
  assert_int_equal(carom_engine_destroy(engine, nullptr), CAROM_OK);
}

void the_sixty_five_thousandth_engine_is_refused_and_recovers(void**) {
  std::vector<carom_engine*> engines;
  carom_engine* engine = nullptr;
  int32_t r;
  while ((r = carom_engine_create(nullptr, &engine, nullptr)) == CAROM_OK) engines.push_back(engine);
  assert_int_equal(r, CAROM_E_LIMIT);
  assert_int_equal(engines.size(), 65535);
  assert_int_equal(carom_engine_destroy(engines.back(), nullptr), CAROM_OK);
  assert_int_equal(carom_engine_create(nullptr, &engines.back(), nullptr), CAROM_OK);
  for (carom_engine* e : engines) assert_int_equal(carom_engine_destroy(e, nullptr), CAROM_OK);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(worlds_on_threads_get_the_same_bits_as_alone),
      cmocka_unit_test(readers_run_side_by_side_and_a_writer_among_them_is_busy_or_done),
      cmocka_unit_test(two_readers_at_once_are_both_served),
      cmocka_unit_test(questions_side_by_side_get_the_answers_of_one),
      cmocka_unit_test(tags_of_the_dead_are_given_out_again),
      cmocka_unit_test(the_sixty_five_thousandth_engine_is_refused_and_recovers),
  };
  return cmocka_run_group_tests_name("abi/threads", tests, nullptr, nullptr);
}
