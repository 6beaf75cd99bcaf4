// `carom pack`: a scene's file, loaded by a program that knows no scene, goes through the states whose hashes stand
// beside it.
#include <carom/carom.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "carom_command.h"
#include "host/host.h"

using command_test::Outcome;
using command_test::run_carom;
namespace fs = std::filesystem;

static std::vector<char> bytes_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return std::vector<char>(std::istreambuf_iterator<char>(file), {});
}

static void packed_scenes_go_on_as_told(void**) {
  const fs::path own = fs::temp_directory_path() / ("carom_pack_" + std::to_string(getpid()));
  const fs::path folder = own / "scenes";  // neither is there before
  const Outcome packed =
      run_carom("pack " + folder.string() + " stacks ragdoll weather falling:n=8,layers=2 --steps 12");
  assert_int_equal(packed.code, 0);
  const nlohmann::json index = nlohmann::json::parse(bytes_of(folder / "index.json"));
  assert_int_equal(index.size(), 4);
  assert_string_equal(index[3]["name"].get<std::string>().c_str(), "falling_n_8_layers_2");
  for (const auto& row : index) {
    carom::tools::Engine engine{carom::tools::PluginPath({CAROM_PLUGIN_DIR})};
    engine.load_all();
    carom::tools::World world(engine);
    world.restore(bytes_of(folder / row["world"].get<std::string>()), row["name"]);
    assert_int_equal(world.bodies().size(), row["bodies"].size());
    for (int step = 0; step <= 12; ++step) {
      char hash[17];
      std::snprintf(hash, sizeof hash, "%016llx", static_cast<unsigned long long>(world.hash()));
      assert_string_equal(hash, row["hashes"][std::to_string(step)].get<std::string>().c_str());
      world.step(row["dt"]);
    }
  }
  fs::remove_all(own);
}

/// What is drawn in place of the shape that collides stands in a file of its own: corners within the scene's size.
static void meshes_are_packed(void**) {
  const fs::path folder = fs::temp_directory_path() / ("carom_meshes_" + std::to_string(getpid()));
  assert_int_equal(run_carom("pack " + folder.string() + " seesaw wall:columns=4 stacks --steps 1").code, 0);
  const nlohmann::json index = nlohmann::json::parse(bytes_of(folder / "index.json"));
  const double heights[] = {0.5, 0.8};  // of the bunnies, m
  for (std::size_t i = 0; i < 2; ++i) {
    const nlohmann::json& row = index[i];
    const nlohmann::json meshes = nlohmann::json::parse(bytes_of(folder / row["meshes"].get<std::string>()));
    assert_int_equal(meshes.size(), 1);
    const nlohmann::json &points = meshes[0]["points"], &faces = meshes[0]["faces"];
    long low = 0, high = 0;
    for (std::size_t k = 1; k < points.size(); k += 3) {
      low = std::min(low, points[k].get<long>());
      high = std::max(high, points[k].get<long>());
    }
    const double tall = static_cast<double>(high - low) * meshes[0]["unit"].get<double>();
    assert_true(tall <= heights[i] && tall > 0.85 * heights[i]);  // a cell is a 25th of the longest edge
    for (const auto& corner : faces) assert_true(corner.get<std::size_t>() < points.size() / 3);
    assert_true(faces.size() / 3 > 500);
    std::size_t drawn = 0;
    for (const auto& look : row["looks"]) drawn += look.contains("mesh") && look["mesh"] == 0;
    assert_int_equal(drawn, i == 0 ? 1 : 3);
  }
  assert_false(index[2].contains("meshes"));
  fs::remove_all(folder);
}

/// True poses stand in a file of their own. Freefall is exact to rounding, so its world is where its truth is.
static void truths_are_packed(void**) {
  const fs::path folder = fs::temp_directory_path() / ("carom_truth_" + std::to_string(getpid()));
  assert_int_equal(run_carom("pack " + folder.string() + " accuracy/freefall accuracy/stack10 accuracy/coin").code, 0);
  const nlohmann::json index = nlohmann::json::parse(bytes_of(folder / "index.json"));
  const nlohmann::json &fall = index[0]["truth"], &stack = index[1]["truth"];
  assert_int_equal(fall["frames"], 601);  // 10 s at 60 Hz, and the start
  assert_int_equal(stack["frames"], 1);   // it stands
  assert_int_equal(stack["bodies"].size(), 10);
  assert_false(index[2].contains("truth"));  // the coin's is a time
  const std::vector<char> poses = bytes_of(folder / fall["file"].get<std::string>());
  assert_int_equal(poses.size(), 601 * 7 * sizeof(double));
  carom::tools::Engine engine{carom::tools::PluginPath({CAROM_PLUGIN_DIR})};
  engine.load_all();
  carom::tools::World world(engine);
  world.restore(bytes_of(folder / index[0]["world"].get<std::string>()), "freefall");
  for (std::size_t step = 0; step <= 600; ++step) {
    double truth[7];
    std::memcpy(truth, poses.data() + step * sizeof truth, sizeof truth);
    std::vector<double> place;
    world.read(CAROM_FIELD_POSITION, {world.bodies().at(0)}, place);
    for (int k = 0; k < 3; ++k) assert_true(std::fabs(place[k] - truth[k]) < 1e-9);
    assert_true(std::isnan(truth[3]));  // a ball's turn says nothing
    world.step(1.0 / 60);
  }
  fs::remove_all(folder);
}

static void what_cannot_be_packed_is_told(void**) {
  const Outcome unknown =
      run_carom("pack " + (fs::temp_directory_path() / "carom_pack_none").string() + " no_such_scene");
  assert_int_equal(unknown.code, 2);
  assert_true(unknown.says("what to do"));
  // How far it is stands on stderr, a line a scene where that is no terminal.
  const std::string folder = (fs::temp_directory_path() / "carom_pack_share").string();
  const Outcome both = run_carom("pack " + folder + " stacks:n=1,height=2 pyramid:n=2 --steps 1");
  fs::remove_all(folder);
  assert_true(both.code == 0 && both.says("  0 %: stacks") && both.says(" 50 %: pyramid"));
  const Outcome nowhere = run_carom("pack /proc/no/such/folder stacks");
  assert_int_equal(nowhere.code, 2);
  assert_true(nowhere.says("what to do"));
}

int main() {
  const struct CMUnitTest tests[] = {cmocka_unit_test(packed_scenes_go_on_as_told), cmocka_unit_test(meshes_are_packed),
                                     cmocka_unit_test(truths_are_packed),
                                     cmocka_unit_test(what_cannot_be_packed_is_told)};
  return cmocka_run_group_tests_name("tools/pack", tests, nullptr, nullptr);
}
