// Every folder under plugins/, found by itself: it loads, says what its parameters are, makes a shape, and a body of it
// lies on the ground. A new shape needs no line here.
#include <carom/carom.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "carom_test.h"

namespace {

namespace fs = std::filesystem;

std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const auto& entry : fs::directory_iterator(CAROM_SOURCE_DIR "/plugins"))
    if (entry.is_directory()) all.push_back(entry.path().filename().string());
  std::ranges::sort(all);
  return all;
}

struct Made {
  carom_engine* engine = nullptr;
  carom_plugin plugin = 0;
  const carom_shape_plugin* description = nullptr;

  explicit Made(const std::string& name) {
    const std::string path = std::string(CAROM_PLUGIN_DIR) + "/" + name + ".so";
    carom_error error = CAROM_ERROR_INIT;
    assert_int_equal(carom_engine_create(nullptr, &engine, nullptr), CAROM_OK);
    const std::int32_t loaded = carom_plugin_load(engine, path.c_str(), &plugin, &error);
    if (loaded != CAROM_OK) print_error("%s: %s\n", path.c_str(), error.message);
    assert_int_equal(loaded, CAROM_OK);
    assert_int_equal(carom_plugin_describe(engine, plugin, &description, nullptr), CAROM_OK);
  }
  Made(const Made&) = delete;
  ~Made() { carom_engine_destroy(engine, nullptr); }

  /// Something of about a metre: half of one for each parameter, as far as its bounds allow. What takes any number of
  /// points gets the corners of a tetrahedron.
  std::vector<double> some_params() const {
    if (description->param_tail_group == 3) return {-0.5, -0.5, -0.5, 0.5, -0.5, -0.5, 0, -0.5, 0.5, 0, 0.5, 0};
    std::vector<double> params;
    for (std::uint32_t i = 0; i < description->param_count; ++i)
      params.push_back(std::clamp(0.5, description->params[i].min, description->params[i].max));
    return params;
  }
  carom_shape shape() const {
    const std::vector<double> params = some_params();
    carom_shape made = 0;
    carom_error error = CAROM_ERROR_INIT;
    const std::int32_t result = carom_shape_create(engine, plugin, params.data(), params.size(), &made, &error);
    if (result != CAROM_OK) print_error("%s: %s\n", description->id, error.message);
    assert_int_equal(result, CAROM_OK);
    return made;
  }
};

void there_are_some(void**) { assert_true(names().size() >= 8); }

void each_is_one_file_of_its_name(void**) {
  for (const std::string& name : names()) {
    const fs::path folder = fs::path(CAROM_SOURCE_DIR "/plugins") / name;
    assert_true(fs::exists(folder / (name + ".c")));
    std::size_t sources = 0;
    for (const auto& file : fs::directory_iterator(folder)) sources += file.path().extension() == ".c";
    assert_int_equal(sources, 1);
  }
}

void each_says_what_its_parameters_are(void**) {
  for (const std::string& name : names()) {
    const Made made(name);
    assert_true(std::string(made.description->id).ends_with(name));
    assert_true(made.description->param_count > 0);
    for (std::uint32_t i = 0; i < made.description->param_count; ++i) {
      const carom_param& p = made.description->params[i];
      assert_true(p.name[0] != 0 && p.unit[0] != 0 && p.min < p.max);
    }
  }
}

void each_makes_a_shape_within_its_bounds(void**) {
  for (const std::string& name : names()) {
    const Made made(name);
    carom_shape_info info;
    info.struct_size = sizeof info;
    assert_int_equal(carom_shape_get_info(made.engine, made.shape(), &info, nullptr), CAROM_OK);
    assert_true(info.volume_min > 0 && info.volume_min <= info.volume && info.volume <= info.volume_max);
    for (int axis = 0; axis < 3; ++axis) assert_true(info.aabb_min[axis] < info.aabb_max[axis]);
  }
}

void a_body_of_each_lies_on_the_ground(void**) {
  for (const std::string& name : names()) {
    const Made made(name);
    carom_world* world = nullptr;
    carom_body ground = 0, body = 0;
    carom_collider collider = 0;
    carom_body_desc desc;
    carom_collider_desc part;
    const double up[4] = {0, 1, 0, 0}, origin[3] = {0, 0, 0};
    assert_int_equal(carom_world_create(made.engine, nullptr, &world, nullptr), CAROM_OK);
    assert_int_equal(carom_body_create_named(world, CAROM_BODY_STATIC, "half_space", up, 4, origin, &ground, nullptr),
                     CAROM_OK);
    carom_body_desc_init(&desc, sizeof desc);
    desc.position[1] = 1;
    assert_int_equal(carom_body_create(world, &desc, &body, nullptr), CAROM_OK);
    carom_collider_desc_init(&part, sizeof part);
    part.shape = made.shape();
    assert_int_equal(carom_collider_create(world, body, &part, &collider, nullptr), CAROM_OK);
    double position[3], orientation[4], down[3] = {0, -1, 0}, lowest[3], velocity[3];
    for (int step = 0; step < 240; ++step) assert_int_equal(carom_world_step(world, 1.0 / 60, nullptr), CAROM_OK);
    assert_int_equal(carom_body_get_pose(world, body, position, orientation, nullptr), CAROM_OK);
    assert_int_equal(carom_body_get_velocity(world, body, velocity, nullptr, nullptr), CAROM_OK);
    // The world's down in the frame of the shape: row y of its rotation matrix.
    const double x = orientation[0], y = orientation[1], z = orientation[2], w = orientation[3];
    const double row[3] = {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)};
    for (int i = 0; i < 3; ++i) down[i] = -row[i];
    assert_int_equal(carom_shape_support(made.engine, part.shape, down, 1, lowest, nullptr), CAROM_OK);
    const double height = position[1] + row[0] * lowest[0] + row[1] * lowest[1] + row[2] * lowest[2];
    if (!(std::fabs(height) < 2e-3)) print_error("%s: its lowest point is at %g m\n", name.c_str(), height);
    assert_true(std::fabs(height) < 2e-3);
    assert_true(std::fabs(velocity[1]) < 0.01);
    assert_int_equal(carom_world_destroy(world, nullptr), CAROM_OK);
  }
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(there_are_some),
      cmocka_unit_test(each_is_one_file_of_its_name),
      cmocka_unit_test(each_says_what_its_parameters_are),
      cmocka_unit_test(each_makes_a_shape_within_its_bounds),
      cmocka_unit_test(a_body_of_each_lies_on_the_ground),
  };
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
