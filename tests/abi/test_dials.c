/* Dials: one table feeds names, bounds and setters. */
#include "bench.h"
#include "carom_test.h"

static void the_table_agrees_with_itself_and_with_a_new_world(void** state) {
  Bench b;
  uint32_t count = 0, i, found;
  (void)state;
  assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
  assert_int_equal(carom_dial_get_count(&count), CAROM_OK);
  assert_int_equal(count, CAROM_DIAL_COUNT);
  for (i = 0; i < count; ++i) {
    carom_dial_info info;
    double value = -1;
    uint32_t c;
    info.struct_size = sizeof info;
    assert_int_equal(carom_dial_get_info(i, &info, NULL), CAROM_OK);
    assert_int_equal(info.dial, i);
    assert_true(strlen(info.name) > 2 && strlen(info.summary) > 8 && info.unit);
    assert_true(info.min <= info.initial && info.initial <= info.max);
    assert_int_equal(carom_dial_find(info.name, &found, NULL), CAROM_OK);
    assert_int_equal(found, i); /* so no two dials share a name */
    assert_int_equal(carom_world_get_dial(b.world, i, &value, NULL), CAROM_OK);
    assert_true(value == info.initial);
    if (info.kind == CAROM_DIAL_KIND_CHOICE) {
      assert_true(info.choice_count > 0 && info.min == 0 && info.max == info.choice_count - 1.0);
      for (c = 0; c < info.choice_count; ++c) assert_non_null(info.choices[c]);
    } else {
      assert_null(info.choices);
    }
  }
  assert_int_equal(bench_free(&b), CAROM_OK);
}

static void every_dial_takes_its_bounds_and_nothing_beyond(void** state) {
  Bench b;
  uint32_t i;
  (void)state;
  assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
  for (i = 0; i < CAROM_DIAL_COUNT; ++i) {
    carom_dial_info info;
    double value;
    info.struct_size = sizeof info;
    assert_int_equal(carom_dial_get_info(i, &info, NULL), CAROM_OK);
    assert_int_equal(carom_world_set_dial(b.world, i, info.max, NULL), CAROM_OK);
    assert_int_equal(carom_world_set_dial(b.world, i, info.max * 1.5 + 1, NULL), CAROM_E_OUT_OF_RANGE);
    assert_int_equal(carom_world_get_dial(b.world, i, &value, NULL), CAROM_OK);
    assert_true(value == info.max);
    assert_int_equal(carom_world_set_dial(b.world, i, info.min, NULL), CAROM_OK);
    assert_int_equal(carom_world_set_dial(b.world, i, info.min - 1, NULL), CAROM_E_OUT_OF_RANGE);
    assert_int_equal(carom_world_get_dial(b.world, i, &value, NULL), CAROM_OK);
    assert_true(value == info.min);
    if (info.kind != CAROM_DIAL_KIND_NUMBER && info.max > info.min)
      assert_int_equal(carom_world_set_dial(b.world, i, info.min + 0.5, NULL), CAROM_E_OUT_OF_RANGE);
    assert_int_equal(carom_world_set_dial(b.world, i, info.initial, NULL), CAROM_OK);
  }
  assert_int_equal(bench_free(&b), CAROM_OK);
}

/* Presets speak of the same dials, within their bounds; balanced is a new world; a preset undoes what another did. */
static void presets_set_the_dials_they_say(void** state) {
  Bench b;
  uint32_t preset, i;
  (void)state;
  assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
  assert_string_equal(carom_preset_name(CAROM_PRESET_BALANCED), "balanced");
  assert_string_equal(carom_preset_name(CAROM_PRESET_COUNT), "?");
  assert_int_equal(carom_world_set_dial(b.world, CAROM_DIAL_GRID_CELL, 2, NULL), CAROM_OK); /* no preset's business */
  for (preset = 0; preset < CAROM_PRESET_COUNT; ++preset) {
    assert_int_equal(carom_world_set_preset(b.world, preset, NULL), CAROM_OK);
    for (i = 0; i < CAROM_DIAL_COUNT; ++i) {
      carom_dial_info info;
      double says = 0, balanced = 0, is = 0;
      int32_t speaks = carom_preset_get_dial(preset, i, &says, NULL);
      info.struct_size = sizeof info;
      assert_int_equal(carom_dial_get_info(i, &info, NULL), CAROM_OK);
      assert_int_equal(carom_world_get_dial(b.world, i, &is, NULL), CAROM_OK);
      assert_int_equal(carom_preset_get_dial(CAROM_PRESET_BALANCED, i, &balanced, NULL), speaks);
      if (speaks == CAROM_OK) {
        assert_true(is == says && says >= info.min && says <= info.max && balanced == info.initial);
      } else {
        assert_int_equal(speaks, CAROM_E_NOT_FOUND);
        assert_true(is == (i == CAROM_DIAL_GRID_CELL ? 2 : info.initial));
      }
    }
  }
  assert_int_equal(bench_free(&b), CAROM_OK);
}

/* Each choice of each dial, and both ends of each number: the world stays finite and stands on its floor. */
static void a_world_steps_at_every_setting(void** state) {
  uint32_t i;
  (void)state;
  for (i = 0; i < CAROM_DIAL_COUNT; ++i) {
    carom_dial_info info;
    double value;
    info.struct_size = sizeof info;
    assert_int_equal(carom_dial_get_info(i, &info, NULL), CAROM_OK);
    for (value = info.min;; value = info.kind == CAROM_DIAL_KIND_CHOICE ? value + 1 : info.max) {
      Bench b;
      double position[BENCH_BODIES][3];
      int k;
      assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
      assert_int_equal(carom_world_set_dial(b.world, i, value, NULL), CAROM_OK);
      assert_int_equal(bench_steps(b.world, 30, NULL), CAROM_OK);
      assert_int_equal(
          carom_world_read(b.world, CAROM_FIELD_POSITION, CAROM_SCALAR_F64, b.bodies, BENCH_BODIES, position, 0, NULL),
          CAROM_OK);
      for (k = 0; k < BENCH_BODIES; ++k)
        assert_true(isfinite(position[k][0]) && isfinite(position[k][1]) && isfinite(position[k][2]));
      assert_int_equal(bench_free(&b), CAROM_OK);
      if (value >= info.max) break;
    }
  }
}

/* Numbers that nobody sets: each says why, and under no name or number is it a dial. */
static void constants_give_their_reasons_and_are_fixed(void** state) {
  Bench b;
  uint32_t count = 0, dials = 0, i, k;
  (void)state;
  assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
  assert_int_equal(carom_constant_get_count(&count), CAROM_OK);
  assert_int_equal(carom_dial_get_count(&dials), CAROM_OK);
  assert_true(count >= 20);
  for (i = 0; i < count; ++i) {
    carom_constant_info info, other;
    carom_error error = CAROM_ERROR_INIT;
    uint32_t dial = 7;
    info.struct_size = other.struct_size = sizeof info;
    assert_int_equal(carom_constant_get_info(i, &info, NULL), CAROM_OK);
    assert_int_equal(info.constant, i);
    assert_true(strlen(info.name) > 2 && strlen(info.unit) > 0);
    assert_true(strlen(info.reason) > 20 && strlen(info.consequence) > 20);
    assert_true(isfinite(info.value) && info.value > 0);
    assert_int_equal(carom_dial_find(info.name, &dial, &error), CAROM_E_READ_ONLY);
    assert_true(dial == 7 && strstr(error.message, info.name) && strstr(error.remedy, "fixed"));
    for (k = 0; k < i; ++k) {
      assert_int_equal(carom_constant_get_info(k, &other, NULL), CAROM_OK);
      assert_string_not_equal(info.name, other.name);
    }
    assert_int_equal(carom_world_set_dial(b.world, dials + i, info.value, NULL), CAROM_E_UNKNOWN_ENUM);
  }
  assert_int_equal(bench_free(&b), CAROM_OK);
}

static void stages_have_names(void** state) {
  uint32_t i, k;
  (void)state;
  for (i = 0; i < CAROM_STAGE_COUNT; ++i) {
    assert_true(strlen(carom_stage_name(i)) > 2);
    for (k = 0; k < i; ++k) assert_string_not_equal(carom_stage_name(i), carom_stage_name(k));
  }
  assert_string_equal(carom_stage_name(CAROM_STAGE_COUNT), "?");
  assert_string_equal(carom_stage_name(0xFFFFFFFFu), "?");
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(the_table_agrees_with_itself_and_with_a_new_world),
      cmocka_unit_test(presets_set_the_dials_they_say),
      cmocka_unit_test(every_dial_takes_its_bounds_and_nothing_beyond),
      cmocka_unit_test(a_world_steps_at_every_setting),
      cmocka_unit_test(constants_give_their_reasons_and_are_fixed),
      cmocka_unit_test(stages_have_names),
  };
  return cmocka_run_group_tests_name("abi/dials", tests, NULL, NULL);
}
