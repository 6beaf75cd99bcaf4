// Support functions that are valid until they have been called N times, and turn bad in mid-run: the world stays finite, the
// shape is disabled or goes on as what it now says, and bodies elsewhere go on bit for bit as beside a valid one.
#include <array>
#include <cfenv>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>
#include <vector>

#include "carom_test.h"
#include "hostile/stage.h"

namespace {

using namespace hostile;

enum Vice {
  kNone,
  kNan,
  kInf,
  kHuge,
  kRandom,
  kGrows,
  kDented,
  kConstant,
  kUnsteady,
  kRefuses,
  kReenters,
  kRounds,
  kVices
};
const char* const kNames[] = {"valid",  "NaN",      "infinity", "1e300",   "random",    "growing",
                              "dented", "constant", "unsteady", "refuses", "re-enters", "changes the rounding mode"};

struct InvalidPlugin {
  Vice vice = kNone;
  long calls = 0, valid_calls = 0, lies = 0;
  uint64_t random = 1;
  carom_world* world = nullptr;
  carom_engine* engine = nullptr;
  int32_t answer = CAROM_OK;  // of the call from inside
} invalid_plugin;             // a support function has no user data

double any_number() {
  invalid_plugin.random = invalid_plugin.random * 6364136223846793005ull + 1442695040888963407ull;
  return static_cast<double>(static_cast<int64_t>(invalid_plugin.random)) * 0x1p-62;
}

int32_t turns_bad(void*, const double* p, uint64_t n, const double dir[3], double out[3]) {
  const int32_t r = box(nullptr, p, n, dir, out);
  if (invalid_plugin.calls++ < invalid_plugin.valid_calls) return r;
  ++invalid_plugin.lies;
  switch (invalid_plugin.vice) {
    case kNone:
    case kVices:
      break;
    case kNan:
      out[1] = std::numeric_limits<double>::quiet_NaN();
      break;
    case kInf:
      out[0] = -std::numeric_limits<double>::infinity();
      break;
    case kHuge:
      out[2] = 1e300;
      break;
    case kRandom:
      for (int i = 0; i < 3; ++i) out[i] = any_number();
      break;
    case kGrows:
      for (int i = 0; i < 3; ++i) out[i] *= 1 + 1e-3 * static_cast<double>(invalid_plugin.lies);
      break;
    case kDented:
      if (dir[1] < 0) out[1] *= 0.8;
      break;
    case kConstant:
      for (int i = 0; i < 3; ++i) out[i] = p[i];
      break;
    case kUnsteady:
      out[0] *= invalid_plugin.lies % 2 ? 1 : 1 - 1e-3;
      break;
    case kRefuses:
      return 7;
    case kReenters:
      invalid_plugin.answer = carom_world_step(invalid_plugin.world, 0.01, nullptr);
      break;
    case kRounds:
      std::fesetround(FE_UPWARD);
      break;
  }
  return r;
}

const carom_shape_plugin kTurncoat = plugin_of("hostile.turncoat", kHalf, 3, nullptr, turns_bad);

constexpr int kFar = 5, kSteps = 90;
using States = std::vector<std::array<double, 13>>;

/// A stack of valid bodies 100 m away from two crates of the turncoat that lie on each other and one valid ball on them.
/// @return the states of the valid ones after every step
States run(Stage& s, Vice vice, long valid_calls, double solver, long* calls_before = nullptr) {
  invalid_plugin = InvalidPlugin();
  carom_plugin plugin = 0;
  carom_shape shape = 0;
  const double half[3] = {0.5, 0.25, 0.75};
  assert_int_equal(carom_plugin_register(s.engine, &kTurncoat, &plugin, nullptr), CAROM_OK);
  invalid_plugin.valid_calls = std::numeric_limits<long>::max();
  assert_int_equal(carom_shape_create(s.engine, plugin, half, 3, &shape, nullptr), CAROM_OK);
  s.live[kShape].push_back({shape, {0, 0}});
  const int bad = static_cast<int>(s.live[kShape].size()) - 1;
  assert_int_equal(carom_world_create(s.engine, nullptr, &s.world, nullptr), CAROM_OK);
  assert_int_equal(carom_world_set_dial(s.world, CAROM_DIAL_SOLVER, solver, nullptr), CAROM_OK);
  std::vector<carom_body> far, all;
  add_body(s, CAROM_BODY_STATIC, 4, 0, 0, 0);
  for (int i = 0; i < kFar; ++i)
    far.push_back(add_body(s, CAROM_BODY_DYNAMIC, i % 4, 100 + 0.1 * i, 0.4 + 0.75 * i, 0.05 * i));
  add_body(s, CAROM_BODY_DYNAMIC, bad, 0, 0.3, 0);
  add_body(s, CAROM_BODY_DYNAMIC, bad, 0.1, 0.9, 0);
  add_body(s, CAROM_BODY_DYNAMIC, 0, 0.1, 1.8, 0);
  invalid_plugin.vice = vice, invalid_plugin.calls = 0, invalid_plugin.valid_calls = valid_calls,
  invalid_plugin.world = s.world, invalid_plugin.engine = s.engine;
  States states;
  for (int step = 0; step < kSteps; ++step) {
    const int32_t r = carom_world_step(s.world, 1. / 64, nullptr);
    assert_int_equal(std::fegetround(), FE_TONEAREST);
    assert_int_equal(r, CAROM_OK);
    const std::string wrong = not_finite(s.world);
    if (!wrong.empty()) print_error("%s after %ld calls: %s\n", kNames[vice], valid_calls, wrong.c_str());
    assert_true(wrong.empty());
    std::array<double, 13> state;
    for (const carom_body b : far) {
      assert_int_equal(carom_world_read(s.world, CAROM_FIELD_POSE, CAROM_SCALAR_F64, &b, 1, state.data(), 0, nullptr),
                       CAROM_OK);
      assert_int_equal(
          carom_world_read(s.world, CAROM_FIELD_VELOCITY, CAROM_SCALAR_F64, &b, 1, state.data() + 7, 0, nullptr),
          CAROM_OK);
      states.push_back(state);
    }
  }
  if (calls_before) *calls_before = invalid_plugin.calls;
  const long lies = invalid_plugin.lies;
  invalid_plugin.valid_calls = std::numeric_limits<long>::max();
  assert_int_equal(carom_world_destroy(s.world, nullptr), CAROM_OK);
  for (const int k : {kBody, kCollider}) s.live[k].clear();
  s.live[kShape].pop_back();
  assert_int_equal(carom_shape_destroy(s.engine, shape, nullptr), CAROM_OK);
  assert_int_equal(carom_plugin_unload(s.engine, plugin, nullptr), CAROM_OK);
  if (vice != kNone) assert_true(lies > 0);  // or nothing was tried
  return states;
}

void others_go_on_bit_for_bit(void**) {
  Stage s;
  assert_true(make_engine(s));
  for (const double solver : {CAROM_SOLVER_SOFT_STEP, CAROM_SOLVER_DIRECT, CAROM_SOLVER_AUTO}) {
    long calls = 0;
    const States beside_a_valid_one = run(s, kNone, 0, solver, &calls);
    assert_true(calls > 1000);
    for (int vice = kNone + 1; vice < kVices; ++vice)
      for (const long after : {0l, 100l, calls / 2}) {
        const States beside = run(s, static_cast<Vice>(vice), after, solver);
        const bool same = std::memcmp(beside.data(), beside_a_valid_one.data(), sizeof(beside[0]) * beside.size()) == 0;
        if (!same)
          print_error("solver %g: %s after %ld calls changes bodies 100 m away\n", solver, kNames[vice], after);
        assert_true(same);
        if (vice == kReenters) assert_int_equal(invalid_plugin.answer, CAROM_E_REENTRANT);
      }
  }
  assert_int_equal(carom_engine_destroy(s.engine, nullptr), CAROM_OK);
}

/// What can be told from one answer is told: the shape is disabled, with the evidence.
void what_cannot_be_a_support_function_is_disabled(void**) {
  for (const Vice vice : {kNan, kInf, kHuge, kRefuses}) {
    Stage s;
    assert_true(make_engine(s));
    invalid_plugin = InvalidPlugin();
    invalid_plugin.valid_calls = std::numeric_limits<long>::max();
    carom_plugin plugin = 0;
    carom_shape shape = 0;
    const double half[3] = {0.5, 0.25, 0.75};
    assert_int_equal(carom_plugin_register(s.engine, &kTurncoat, &plugin, nullptr), CAROM_OK);
    assert_int_equal(carom_shape_create(s.engine, plugin, half, 3, &shape, nullptr), CAROM_OK);
    s.live[kShape].push_back({shape, {0, 0}});
    assert_int_equal(carom_world_create(s.engine, nullptr, &s.world, nullptr), CAROM_OK);
    add_body(s, CAROM_BODY_STATIC, 4, 0, 0, 0);
    add_body(s, CAROM_BODY_DYNAMIC, static_cast<int>(s.live[kShape].size()) - 1, 0, 0.25, 0);
    for (int i = 0; i < 5; ++i) assert_int_equal(carom_world_step(s.world, 1. / 64, nullptr), CAROM_OK);
    invalid_plugin.vice = vice, invalid_plugin.valid_calls = 0;
    assert_int_equal(carom_world_step(s.world, 1. / 64, nullptr), CAROM_OK);
    carom_fault faults[4];
    uint64_t n = 0;
    assert_int_equal(carom_world_get_faults(s.world, faults, sizeof *faults, 4, &n, nullptr), CAROM_OK);
    assert_int_equal(n, 1);
    assert_true(faults[0].shape == shape);
    const long lies = invalid_plugin.lies;
    for (int i = 0; i < 30; ++i) assert_int_equal(carom_world_step(s.world, 1. / 64, nullptr), CAROM_OK);
    assert_int_equal(invalid_plugin.lies, lies);  // in quarantine it is asked no more
    assert_true(not_finite(s.world).empty());
    assert_int_equal(carom_world_destroy(s.world, nullptr), CAROM_OK);
    assert_int_equal(carom_engine_destroy(s.engine, nullptr), CAROM_OK);
  }
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(others_go_on_bit_for_bit),
      cmocka_unit_test(what_cannot_be_a_support_function_is_disabled),
  };
  return cmocka_run_group_tests_name("abi/hostile_plugins", tests, nullptr, nullptr);
}
