// Many pairs in one call: the bits of the single call, for any number of threads, strides and settings; brackets around
// closed forms; and what is wrong with a pair is said with its number, before anything is written.
#include <atomic>
#include <limits>
#include <thread>

#include "bench.h"
#include "pair_draws.h"

namespace {

using namespace pair_draws;

std::vector<carom_distance> at_once(carom_engine* engine, const Pairs& pairs, const carom_distance_desc* desc) {
  std::vector<carom_distance> out(pairs.size());
  const carom_pairs view = pairs.view();
  carom_error e = CAROM_ERROR_INIT;
  if (carom_pairs_distance(engine, &view, desc, out.data(), sizeof out[0], &e) != CAROM_OK)
    print_error("%s", e.message), assert_true(false);
  return out;
}

/// Random ones near, at 1e-3 m and 1e4 m, and those that no draw finds.
Pairs all_pairs(carom_engine* engine, std::size_t n) {
  Pairs pairs;
  const auto usual = shapes_of_all_kinds(engine, 1, 1);
  draw(pairs, usual, 2, n, 3, 1.6);
  draw(pairs, shapes_of_all_kinds(engine, 3, 1e-3), 4, n / 10, 3, 2e-3);
  draw(pairs, shapes_of_all_kinds(engine, 5, 1e4), 6, n / 10, 1, 3e4);
  add_degenerate(pairs, usual);
  return pairs;
}

void the_bits_are_those_of_the_single_call_on_one_two_and_three_threads(void**) {
  for (const uint32_t threads : {1u, 2u, 3u}) {
    carom_engine* engine = engine_of(threads);
    const Pairs pairs = all_pairs(engine, 20000);
    const auto single = one_by_one(engine, pairs, nullptr);
    std::size_t apart = 0, deep = 0;
    for (const carom_distance& d : single) {
      assert_true(d.status != CAROM_QUERY_FAULT);
      apart += d.separation > 0, deep += d.epa_iterations > 0;
    }
    assert_true(apart > 5000 && deep > 2000);
    assert_same(at_once(engine, pairs, nullptr), single);
    assert_int_equal(carom_engine_destroy(engine, nullptr), CAROM_OK);
  }
}

void so_they_are_for_every_way_to_ask(void**) {
  carom_engine* engine = engine_of(2);
  const Pairs pairs = all_pairs(engine, 500);
  for (uint32_t i = 0; i < 12; ++i) {
    carom_distance_desc d;
    carom_distance_desc_init(&d, sizeof d);
    d.simplex = i % 3, d.narrow_phase = i / 3 % 2, d.pair_routines = i / 6;
    d.tolerance = i % 2 ? 1e-3 : 1e-8, d.gjk_iterations = i == 5 ? 4 : 128;
    assert_same(at_once(engine, pairs, &d), one_by_one(engine, pairs, &d));
  }
  assert_int_equal(carom_engine_destroy(engine, nullptr), CAROM_OK);
}

/// Deals parts out twice, backwards, and leaves every third to the engine.
void deal(void*, carom_job_fn job, void* context, uint32_t count) {
  std::thread other([=] {
    for (uint32_t i = count; i-- > 0;)
      if (i % 3) job(context, i, i + 1);
  });
  job(context, 0, count / 4);
  other.join();
}

void a_host_may_lend_its_threads(void**) {
  carom_engine* engine = nullptr;
  setenv("CAROM_PLUGIN_PATH", CAROM_PLUGIN_DIR, 1);
  assert_int_equal(carom_engine_create(nullptr, &engine, nullptr), CAROM_OK);
  carom_jobs_desc jobs;
  carom_jobs_desc_init(&jobs, sizeof jobs);
  jobs.run = deal;
  assert_int_equal(carom_engine_set_jobs(engine, &jobs, nullptr), CAROM_OK);
  const Pairs pairs = all_pairs(engine, 2000);
  assert_same(at_once(engine, pairs, nullptr), one_by_one(engine, pairs, nullptr));
  assert_int_equal(carom_engine_destroy(engine, nullptr), CAROM_OK);
}

void numbers_may_stand_anywhere(void**) {
  carom_engine* engine = engine_of(2);
  const Pairs pairs = all_pairs(engine, 300);
  // Everything of a pair in one record of odd length, results among it.
  constexpr std::size_t kRecord = 2 * 8 + 14 * 8 + 5;
  std::vector<char> bytes(pairs.size() * kRecord);
  for (std::size_t i = 0; i < pairs.size(); ++i)
    for (int side = 0; side < 2; ++side) {
      char* at = &bytes[i * kRecord + 64u * static_cast<unsigned>(side)];
      std::memcpy(at, &pairs.shapes[side][i], 8);
      std::memcpy(at + 8, &pairs.positions[side][3 * i], 24);
      std::memcpy(at + 32, &pairs.orientations[side][4 * i], 32);
    }
  carom_pairs p = {};
  p.struct_size = sizeof p, p.count = pairs.size();
  const auto at = [&](std::size_t offset) { return static_cast<const void*>(bytes.data() + offset); };
  p.shapes_a = static_cast<const carom_shape*>(at(0)), p.shapes_b = static_cast<const carom_shape*>(at(64));
  p.positions_a = static_cast<const double*>(at(8)), p.positions_b = static_cast<const double*>(at(72));
  p.orientations_a = static_cast<const double*>(at(32)), p.orientations_b = static_cast<const double*>(at(96));
  p.shape_a_stride = p.shape_b_stride = p.position_a_stride = p.position_b_stride = kRecord;
  p.orientation_a_stride = p.orientation_b_stride = kRecord;
  const auto single = one_by_one(engine, pairs, nullptr);
  const std::size_t stride = 32;  // up to `upper`: a header that knew no more
  std::vector<char> out(pairs.size() * stride, 0x55);
  assert_int_equal(
      carom_pairs_distance(engine, &p, nullptr, reinterpret_cast<carom_distance*>(out.data()), stride, nullptr),
      CAROM_OK);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    uint32_t size = 0;
    std::memcpy(&size, &out[i * stride], sizeof size);
    assert_int_equal(size, 32);
    assert_memory_equal(&out[i * stride + 4], reinterpret_cast<const char*>(&single[i]) + 4, 28);
  }
  assert_int_equal(carom_engine_destroy(engine, nullptr), CAROM_OK);
}

void brackets_hold_the_closed_forms(void**) {
  carom_engine* engine = engine_of(2);
  Pairs pairs;
  std::vector<double> truth;
  uint64_t state = 9;
  for (int i = 0; i < 3000; ++i) {
    const double r = uniform(state, 0.1, 2), s = uniform(state, 0.1, 2), h = uniform(state, 0, 2);
    const double hx = uniform(state, 0.1, 2), hy = uniform(state, 0.1, 2), hz = uniform(state, 0.1, 2);
    const carom_shape ball = named(engine, "sphere", {r}), other = named(engine, "sphere", {s});
    double zero[3] = {0, 0, 0}, upright[4] = {0, 0, 0, 1}, q[4], p[3];
    turn(state, q);
    for (double& x : p) x = uniform(state, -4, 4);
    const double length = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
    pairs.add(ball, zero, q, other, p, q);
    truth.push_back(length - r - s);
    // Of a point to an upright box and capsule, less a radius; only apart from the box, where the nearest point is known.
    const double out[3] = {std::fmax(std::fabs(p[0]) - hx, 0), std::fmax(std::fabs(p[1]) - hy, 0),
                           std::fmax(std::fabs(p[2]) - hz, 0)};
    const double gap = std::sqrt(out[0] * out[0] + out[1] * out[1] + out[2] * out[2]);
    if (gap > 0) pairs.add(named(engine, "box", {hx, hy, hz}), zero, upright, ball, p, q), truth.push_back(gap - r);
    const double up = std::fmax(std::fabs(p[1]) - h, 0);
    pairs.add(named(engine, "capsule", {s, h}), zero, upright, ball, p, q);
    truth.push_back(std::sqrt(p[0] * p[0] + up * up + p[2] * p[2]) - r - s);
    if (pairs.size() > 900) break;
  }
  const auto found = at_once(engine, pairs, nullptr);
  for (std::size_t i = 0; i < found.size(); ++i) {
    const double rounding = 1e-14;  // of `truth`, a handful of operations on lengths below 8 m
    assert_true(found[i].lower <= truth[i] + rounding && truth[i] <= found[i].upper + rounding);
    assert_int_equal(found[i].status, CAROM_QUERY_EXACT_ENOUGH);
  }
  assert_int_equal(carom_engine_destroy(engine, nullptr), CAROM_OK);
}

void what_is_wrong_is_said_of_its_pair_and_nothing_is_written(void**) {
  carom_engine *engine = engine_of(2), *others = engine_of(1);
  const auto shapes = shapes_of_all_kinds(engine, 1, 1);
  const double up[3] = {0, 1, 0};
  carom_shape ground = 0, foreign = named(others, "sphere", {1}), gone = named(engine, "sphere", {1});
  assert_int_equal(carom_shape_create_half_space(engine, up, 0, &ground, nullptr), CAROM_OK);
  assert_int_equal(carom_shape_destroy(engine, gone, nullptr), CAROM_OK);
  Pairs good;
  draw(good, shapes, 2, 500, 3, 3);
  struct Case {
    int32_t code;
    const char* what;
    void (*spoil)(Pairs&, carom_shape);
    carom_shape with;
  };
  const Case cases[] = {
      {CAROM_E_INVALID_HANDLE, "shape_a of pair 317", [](Pairs& p, carom_shape) { p.shapes[0][317] = 0; }, 0},
      {CAROM_E_STALE_HANDLE, "shape_b of pair 499", [](Pairs& p, carom_shape s) { p.shapes[1][499] = s; }, gone},
      {CAROM_E_WRONG_WORLD, "shape_b of pair 0", [](Pairs& p, carom_shape s) { p.shapes[1][0] = s; }, foreign},
      {CAROM_E_NOT_FINITE, "position_a of pair 7[2]",
       [](Pairs& p, carom_shape) { p.positions[0][23] = std::numeric_limits<double>::quiet_NaN(); }, 0},
      {CAROM_E_NOT_FINITE, "position_b of pair 499[0]",
       [](Pairs& p, carom_shape) { p.positions[1][3 * 499] = std::numeric_limits<double>::infinity(); }, 0},
      {CAROM_E_NOT_FINITE, "orientation_a of pair 12[3]",
       [](Pairs& p, carom_shape) { p.orientations[0][51] = std::numeric_limits<double>::quiet_NaN(); }, 0},
      {CAROM_E_NOT_UNIT, "orientation_b of pair 30 has length",
       [](Pairs& p, carom_shape) { p.orientations[1][4 * 30] += 0.5; }, 0},
      {CAROM_E_UNSUPPORTED, "two half-spaces of pair 88",
       [](Pairs& p, carom_shape s) { p.shapes[0][88] = p.shapes[1][88] = s; }, ground},
  };
  for (const Case& c : cases) {
    Pairs bad = good;
    c.spoil(bad, c.with);
    const carom_pairs view = bad.view();
    std::vector<carom_distance> out(bad.size());
    std::memset(out.data(), 0x55, out.size() * sizeof out[0]);
    const auto before = out;
    carom_error e = CAROM_ERROR_INIT;
    assert_int_equal(carom_pairs_distance(engine, &view, nullptr, out.data(), sizeof out[0], &e), c.code);
    assert_int_equal(e.argument, 2);
    if (!std::strstr(e.message, c.what)) print_error("\"%s\" lacks \"%s\"", e.message, c.what), assert_true(false);
    assert_memory_equal(out.data(), before.data(), out.size() * sizeof out[0]);
  }
  // No shape stays in use, whatever happened.
  for (const carom_shape s : shapes) assert_int_equal(carom_shape_destroy(engine, s, nullptr), CAROM_OK);
  assert_int_equal(carom_engine_destroy(engine, nullptr), CAROM_OK);
  assert_int_equal(carom_engine_destroy(others, nullptr), CAROM_OK);
}

std::atomic<bool> lies{false};
thread_local bool is_caller = false;
std::atomic<int> elsewhere{0};

int32_t lying_box(void*, const double* p, uint64_t, const double dir[3], double out[3]) {
  if (!is_caller) ++elsewhere;
  for (int i = 0; i < 3; ++i) out[i] = dir[i] < 0 ? -p[i] : p[i];
  if (lies && dir[0] < -0.1) out[1] = std::numeric_limits<double>::quiet_NaN();
  return 0;
}

void a_support_function_that_misbehaves_spoils_its_own_pairs(void**) {
  carom_engine* engine = engine_of(3);
  carom_shape_plugin plugin = bench_plugin("test.liar", bench_box_params, 3, nullptr, lying_box);
  plugin.flags = CAROM_PLUGIN_HOST_THREAD;
  carom_plugin handle;
  assert_int_equal(carom_plugin_register(engine, &plugin, &handle, nullptr), CAROM_OK);
  const double half[3] = {0.5, 0.6, 0.7};
  carom_shape liar;
  assert_int_equal(carom_shape_create(engine, handle, half, 3, &liar, nullptr), CAROM_OK);
  auto shapes = shapes_of_all_kinds(engine, 1, 1);
  Pairs pairs;
  shapes.push_back(liar);
  draw(pairs, shapes, 11, 4000, 3, 3);
  lies = true, is_caller = true, elsewhere = 0;
  const auto found = at_once(engine, pairs, nullptr);
  const auto single = one_by_one(engine, pairs, nullptr);
  lies = false;
  assert_int_equal(elsewhere, 0);  // a function of the host's thread is asked there alone
  std::size_t faults = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const bool lied = found[i].status == CAROM_QUERY_FAULT;
    faults += lied;
    assert_true(!lied || pairs.shapes[0][i] == liar || pairs.shapes[1][i] == liar);
  }
  assert_true(faults > 50);
  assert_same(found, single);
  assert_int_equal(carom_engine_destroy(engine, nullptr), CAROM_OK);
}

void no_pairs_are_no_error(void**) {
  carom_engine* engine = engine_of(1);
  carom_pairs none = {};
  none.struct_size = sizeof none;
  assert_int_equal(carom_pairs_distance(engine, &none, nullptr, nullptr, sizeof(carom_distance), nullptr), CAROM_OK);
  assert_int_equal(carom_engine_destroy(engine, nullptr), CAROM_OK);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(the_bits_are_those_of_the_single_call_on_one_two_and_three_threads),
      cmocka_unit_test(so_they_are_for_every_way_to_ask),
      cmocka_unit_test(a_host_may_lend_its_threads),
      cmocka_unit_test(numbers_may_stand_anywhere),
      cmocka_unit_test(brackets_hold_the_closed_forms),
      cmocka_unit_test(what_is_wrong_is_said_of_its_pair_and_nothing_is_written),
      cmocka_unit_test(a_support_function_that_misbehaves_spoils_its_own_pairs),
      cmocka_unit_test(no_pairs_are_no_error),
  };
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
