// Every attribute that a body has, gone through by its number: none of what follows names one, so that a new one is tested
// where it is added to the table.
#include <cctype>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "attributes.h"
#include "bench.h"
#include "carom_test.h"

namespace {

using Value = std::array<double, CAROM_ATTRIBUTE_NUMBERS>;

Value value_of(const carom_world* world, carom_body body, std::uint32_t attribute) {
  Value value;
  value.fill(-9);
  assert_int_equal(carom_body_get_attribute(const_cast<carom_world*>(world), body, attribute, value.data(), nullptr),
                   CAROM_OK);
  return value;
}
void set(carom_world* world, carom_body body, std::uint32_t attribute, const Value& value) {
  assert_int_equal(carom_body_set_attribute(world, body, attribute, value.data(), nullptr), CAROM_OK);
}
Value usual_of(const carom_attribute_info& info) {
  Value value;
  std::copy(info.usual, info.usual + value.size(), value.begin());
  return value;
}

template <class F>
void each_attribute(F&& f) {
  for (std::uint32_t k = 0; k < CAROM_ATTRIBUTE_COUNT; ++k) f(attribute_info(k));
}

std::vector<unsigned char> saved(carom_world* world, std::uint32_t flags) {
  std::uint64_t size = 0;
  assert_int_equal(carom_world_save(world, flags, nullptr, 0, &size, nullptr), CAROM_OK);
  std::vector<unsigned char> bytes(size);
  assert_int_equal(carom_world_save(world, flags, bytes.data(), bytes.size(), &size, nullptr), CAROM_OK);
  return bytes;
}

struct Stage {
  Stage() { assert_int_equal(bench_make(&b, nullptr, nullptr), CAROM_OK); }
  ~Stage() { bench_free(&b); }
  Bench b;
};

}  // namespace

static void they_say_what_they_are(void**) {
  std::set<std::string> names;
  each_attribute([&](const carom_attribute_info& info) {
    assert_true(info.numbers >= 1 && info.numbers <= CAROM_ATTRIBUTE_NUMBERS && info.min < info.max);
    assert_true(std::strlen(info.name) > 0 && std::strlen(info.unit) > 0 && std::strlen(info.summary) > 10);
    assert_true(info.effect < CAROM_EFFECT_COUNT && names.insert(info.name).second);
    for (std::uint32_t k = 0; k < CAROM_ATTRIBUTE_NUMBERS; ++k)
      assert_true(k < info.numbers ? info.usual[k] >= info.min && info.usual[k] <= info.max : info.usual[k] == 0);
    assert_true(unusual_value(info) != usual_of(info));
  });
}

static void they_are_what_they_were_set_to(void**) {
  Stage stage;
  Bench& b = stage.b;
  each_attribute([&](const carom_attribute_info& info) {
    assert_true(value_of(b.world, b.bodies[2], info.attribute) == usual_of(info));
    set(b.world, b.bodies[2], info.attribute, unusual_value(info));
    assert_true(value_of(b.world, b.bodies[2], info.attribute) == unusual_value(info));
    assert_true(value_of(b.world, b.bodies[1], info.attribute) == usual_of(info));
  });
  each_attribute([&](const carom_attribute_info& info) {  // none changed another
    assert_true(value_of(b.world, b.bodies[2], info.attribute) == unusual_value(info));
  });
}

static void who_gets_the_slot_of_another_has_nothing_of_it(void**) {
  Stage stage;
  Bench& b = stage.b;
  each_attribute(
      [&](const carom_attribute_info& info) { set(b.world, b.bodies[2], info.attribute, unusual_value(info)); });
  assert_int_equal(carom_body_destroy(b.world, b.bodies[2], nullptr), CAROM_OK);
  carom_body_desc desc;
  carom_body_desc_init(&desc, sizeof desc);
  for (int i = 0; i < 4; ++i) {  // one of them gets it
    carom_body body = 0;
    assert_int_equal(carom_body_create(b.world, &desc, &body, nullptr), CAROM_OK);
    each_attribute([&](const carom_attribute_info& info) {
      assert_true(value_of(b.world, body, info.attribute) == usual_of(info));
    });
  }
}

/// Another value wakes; the same one does not.
static void who_gets_another_wakes(void**) {
  each_attribute([&](const carom_attribute_info& info) {
    Stage stage;
    Bench& b = stage.b;
    std::uint32_t asleep = 0;
    assert_int_equal(carom_world_set_dial(b.world, CAROM_DIAL_SLEEP, 1, nullptr), CAROM_OK);
    for (int i = 0; i < 900 && !asleep; ++i) {
      assert_int_equal(bench_steps(b.world, 1, nullptr), CAROM_OK);
      assert_int_equal(carom_body_is_asleep(b.world, b.bodies[3], &asleep, nullptr), CAROM_OK);
    }
    assert_int_equal(asleep, 1);
    set(b.world, b.bodies[3], info.attribute, usual_of(info));
    assert_int_equal(carom_body_is_asleep(b.world, b.bodies[3], &asleep, nullptr), CAROM_OK);
    assert_int_equal(asleep, 1);
    set(b.world, b.bodies[3], info.attribute, unusual_value(info));
    assert_int_equal(carom_body_is_asleep(b.world, b.bodies[3], &asleep, nullptr), CAROM_OK);
    assert_int_equal(asleep, 0);
  });
}

static void a_snapshot_and_a_fork_have_them(void**) {
  each_attribute([&](const carom_attribute_info& info) {
    Stage stage;
    Bench& b = stage.b;
    const auto before = saved(b.world, 0);
    set(b.world, b.bodies[2], info.attribute, unusual_value(info));
    const auto after = saved(b.world, 0);
    assert_true(before != after);
    assert_int_equal(carom_world_restore(b.world, before.data(), before.size(), nullptr), CAROM_OK);
    assert_true(value_of(b.world, b.bodies[2], info.attribute) == usual_of(info));
    assert_int_equal(carom_world_restore(b.world, after.data(), after.size(), nullptr), CAROM_OK);
    assert_true(value_of(b.world, b.bodies[2], info.attribute) == unusual_value(info));
    assert_true(saved(b.world, 0) == after);
    carom_world* fork = nullptr;
    assert_int_equal(carom_world_fork(b.world, &fork, nullptr), CAROM_OK);
    carom_body twin = 0;
    assert_int_equal(carom_world_translate_handles(fork, &b.bodies[2], 1, &twin, nullptr), CAROM_OK);
    assert_true(value_of(fork, twin, info.attribute) == unusual_value(info));
    carom_world_destroy(fork, nullptr);
  });
}

/// All at once: a snapshot has room for each, and says it in the same bytes after a round.
static void all_of_them_fit_into_a_snapshot(void**) {
  Stage stage;
  Bench& b = stage.b;
  const auto before = saved(b.world, 0);
  each_attribute(
      [&](const carom_attribute_info& info) { set(b.world, b.bodies[2], info.attribute, unusual_value(info)); });
  const auto after = saved(b.world, 0);
  assert_int_equal(carom_world_restore(b.world, before.data(), before.size(), nullptr), CAROM_OK);
  assert_int_equal(carom_world_restore(b.world, after.data(), after.size(), nullptr), CAROM_OK);
  assert_true(saved(b.world, 0) == after);
}

/// Names at their numbers: NAME of CAROM_PREFIX_NAME is what the library calls it.
static void names_stand_at_their_numbers(void**) {
  std::ifstream file(CAROM_SOURCE_DIR "/bindings/api.json");
  const nlohmann::json constants = nlohmann::json::parse(file).at("constants");
  const auto number_of = [&](const std::string& prefix, std::string name) {
    for (char& c : name) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    for (const auto& constant : constants)
      if (constant.at("name") == prefix + name) return constant.at("value").get<std::uint32_t>();
    print_error("no %s%s\n", prefix.c_str(), name.c_str());
    return ~std::uint32_t(0);
  };
  each_attribute([&](const carom_attribute_info& info) {
    assert_int_equal(number_of("CAROM_ATTRIBUTE_", info.name), info.attribute);
  });
  for (std::uint32_t k = 0; k < CAROM_FORCE_FIELD_COUNT; ++k)
    assert_int_equal(number_of("CAROM_FORCE_FIELD_", carom_force_field_name(k)), k);
  assert_string_equal(carom_force_field_name(CAROM_FORCE_FIELD_COUNT), "?");
  for (std::uint32_t k = 0; k < CAROM_JOINT_COUNT; ++k)
    assert_int_equal(number_of("CAROM_JOINT_", carom_joint_kind_name(k)), k);
  assert_string_equal(carom_joint_kind_name(CAROM_JOINT_COUNT), "?");
  Stage stage;
  carom_plan_line lines[128];
  std::uint64_t count = 0;
  assert_int_equal(carom_world_get_plan(stage.b.world, lines, sizeof lines[0], 128, &count, nullptr), CAROM_OK);
  std::uint32_t effects = 0;
  for (std::uint64_t k = 0; k < count; ++k)
    if (lines[k].effect != CAROM_PLAN_NO_EFFECT)
      assert_int_equal(number_of("CAROM_EFFECT_", lines[k].name), lines[k].effect), ++effects;
  assert_int_equal(effects, CAROM_EFFECT_COUNT);
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(they_say_what_they_are),
      cmocka_unit_test(they_are_what_they_were_set_to),
      cmocka_unit_test(who_gets_the_slot_of_another_has_nothing_of_it),
      cmocka_unit_test(who_gets_another_wakes),
      cmocka_unit_test(a_snapshot_and_a_fork_have_them),
      cmocka_unit_test(all_of_them_fit_into_a_snapshot),
      cmocka_unit_test(names_stand_at_their_numbers),
  };
  return cmocka_run_group_tests_name("abi/attributes", tests, nullptr, nullptr);
}
