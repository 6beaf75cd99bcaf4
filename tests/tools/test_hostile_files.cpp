// Files of strangers: whatever they hold, they run no code, crash nothing, wait for nobody, and take little. Each hostile one
// is refused with what is wrong, where, and what to do; the same as a program of its own, which may have 512 MiB and 2 s.
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>

#include "carom_command.h"
#include "carom_test.h"
#include "host/files.h"
#include "replay/replay.h"
#include "scenefile/scenefile.h"
#include "scenes/run.h"

#ifdef __has_feature
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define CAROM_SANITIZED 1
#endif
#endif

using namespace carom::tools;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

/// A folder of this process's own, that goes when the test ends.
struct Folder {
  Folder() : path("/tmp/carom_hostile_" + std::to_string(getpid())) {
    fs::remove_all(path);
    fs::create_directories(path);
  }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
  std::string put(const std::string& name, const std::string& bytes) const {
    const std::string file = path + "/" + name;
    fs::create_directories(fs::path(file).parent_path());
    std::ofstream(file, std::ios::binary) << bytes;
    return file;
  }
  std::string path;
};

json minimal() {
  return {{"asset", {{"version", "2.0"}}},
          {"scene", 0},
          {"scenes", json::array({{{"nodes", json::array({0})}}})},
          {"nodes", json::array({json::object()})}};
}
json with(json document, const char* place, json value) {
  document[json::json_pointer(place)] = std::move(value);
  return document;
}
/// A ball on node 0 whose collider is of a shape plugin.
json of_plugin(const std::string& name) {
  json d = minimal();
  d["nodes"][0]["extensions"]["KHR_physics_rigid_bodies"] = {
      {"motion", {{"mass", 1}}}, {"collider", {{"extensions", {{"CAROM_physics", {{"shape", 0}}}}}}}};
  d["extensions"]["CAROM_physics"]["shapes"] = json::array({{{"plugin", name}, {"params", json::array({0.5})}}});
  return d;
}
/// A mesh of one triangle on node 0, in 36 bytes of positions and 3 of indices.
json of_mesh() {
  json d = minimal();
  d["nodes"][0] = {{"mesh", 0},
                   {"extensions", {{"KHR_physics_rigid_bodies", {{"collider", {{"geometry", {{"node", 0}}}}}}}}}};
  d["meshes"] = json::array({{{"primitives", json::array({{{"attributes", {{"POSITION", 0}}}, {"indices", 1}}})}}});
  d["accessors"] = json::array({{{"componentType", 5126}, {"count", 3}, {"type", "VEC3"}, {"bufferView", 0}},
                                {{"componentType", 5121}, {"count", 3}, {"type", "SCALAR"}, {"bufferView", 1}}});
  d["bufferViews"] =
      json::array({{{"buffer", 0}, {"byteLength", 36}}, {{"buffer", 0}, {"byteOffset", 36}, {"byteLength", 3}}});
  d["buffers"] = json::array({{{"byteLength", 39},
                               {"uri",
                                "data:application/octet-stream;base64,"
                                "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAAAAAAIA/AAEC"}}});
  return d;
}

constexpr int kManyTriangles = 300;

struct Case {
  const char* name;
  std::string text;
  std::vector<std::string> says;  // all of these
};
std::vector<Case> cases() {
  std::vector<Case> all;
  const auto add = [&](const char* name, const json& document, std::vector<std::string> says) {
    all.push_back({name, document.dump(), std::move(says)});
  };
  add("a shape of no extension",
      json::parse(R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"extensions":
      {"KHR_physics_rigid_bodies":{"collider":{"extensions":{"CAROM_physics":{"shape":0}}}}}}]})"),
      {"lacks 'extensions'"});
  for (const char* path : {"/tmp/evil", "../../evil", "..", "sub/evil", ".hidden", "", "a b", "evil\nline"})
    add("a plugin by a path", of_plugin(path), {"/shapes/0/plugin", "no name of a plugin"});
  add("a plugin that is not there", of_plugin("no_such_plugin"), {"no_such_plugin"});
  add("an accessor of nothing",
      with(with(of_mesh(), "/accessors/0/count", 100000000), "/accessors/0",
           {{"componentType", 5126}, {"count", 100000000}, {"type", "VEC3"}}),
      {"/accessors/0/count", "MiB"});
  add("a stride of nothing", with(with(of_mesh(), "/accessors/1/count", 300000000), "/bufferViews/1/byteStride", 0),
      {"MiB"});
  add("a small stride of nothing", with(with(of_mesh(), "/accessors/1/count", 3000), "/bufferViews/1/byteStride", 0),
      {"byteStride"});
  add("an enormous stride", with(of_mesh(), "/bufferViews/1/byteStride", 1u << 30), {"byteStride"});
  add("offsets beyond", with(of_mesh(), "/bufferViews/1/byteOffset", 1099511627775), {"goes beyond its buffer"});
  json doubling = of_mesh();
  for (int k = 1; k <= 40; ++k) doubling["nodes"].push_back({{"children", {k + 1, k + 1}}});
  doubling["nodes"].push_back({{"mesh", 0}});
  add("a graph that doubles", with(doubling, "/nodes/0/extensions/KHR_physics_rigid_bodies/collider/geometry/node", 1),
      {"two parents"});
  json ring = of_mesh();
  ring["nodes"].push_back({{"children", {2}}}), ring["nodes"].push_back({{"children", {1}}});
  add("nodes in a ring", ring, {"/nodes/", "among its own children"});
  add("a node that is its own child", with(minimal(), "/nodes/0/children", {0}), {"among its own children"});
  json many = of_mesh();  // each collider takes the same mesh again
  many["buffers"][0] = {{"byteLength", 36 * kManyTriangles}, {"uri", "triangles.bin"}};
  many["bufferViews"] = json::array({{{"buffer", 0}, {"byteLength", 36 * kManyTriangles}}});
  many["accessors"] =
      json::array({{{"componentType", 5126}, {"count", 3 * kManyTriangles}, {"type", "VEC3"}, {"bufferView", 0}}});
  many["meshes"][0]["primitives"][0].erase("indices");
  for (int k = 1; k < 4000; ++k) {
    many["nodes"].push_back(many["nodes"][0]), many["scenes"][0]["nodes"].push_back(k);
    many["nodes"][k]["extensions"]["KHR_physics_rigid_bodies"]["collider"]["geometry"]["node"] = 0;
  }
  add("one mesh, many times", many, {"MiB"});
  json field = of_plugin("height_field");
  field["nodes"][0]["extensions"]["KHR_physics_rigid_bodies"].erase("motion");
  field["extensions"]["CAROM_physics"]["shapes"][0]["params"] = {4294967298.0, 2, 1, 1, 0, 0, 0, 0};
  add("columns that overflow", field, {"4294967298", "2 to 16384"});
  field["extensions"]["CAROM_physics"]["shapes"][0]["params"] = {2.5, 2, 1, 1, 0, 0, 0, 0};
  add("columns in part", field, {"columns", "whole"});
  add("a projective matrix", with(minimal(), "/nodes/0/matrix", {1, 0, 0, 0.5, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}),
      {"/nodes/0/matrix", "projective"});
  json spindle = minimal();
  spindle["nodes"][0]["extensions"]["KHR_physics_rigid_bodies"] = {
      {"motion", {{"mass", 1}, {"inertiaDiagonal", {1, 1, -3}}}}};
  add("a negative inertia", spindle, {"inertiaDiagonal", "negative"});
  add("an inertia that is no number",
      with(spindle, "/nodes/0/extensions/KHR_physics_rigid_bodies/motion/inertiaDiagonal", {1, 1, nullptr}),
      {"inertiaDiagonal/2", "null"});
  json omi = minimal();
  omi["nodes"][0]["extensions"]["OMI_physics_body"] = {{"motion", {{"type", "dynamic"}}}, {"collider", {{"shape", 0}}}};
  add("an OMI shape of no extension", omi,
      {"/nodes/0/extensions/OMI_physics_body/collider/shape", "OMI_physics_shape"});
  omi["extensions"]["OMI_physics_shape"]["shapes"] = json::array({{{"type", "trimesh"}, {"trimesh", {{"mesh", -1}}}}});
  add("an OMI mesh of none", omi, {"/extensions/OMI_physics_shape/shapes/0/trimesh", "names no mesh"});
  add("an OMI mesh beyond", with(omi, "/extensions/OMI_physics_shape/shapes/0/trimesh/mesh", 3),
      {"/trimesh/mesh", "there are 0"});
  add("an OMI index in part", with(omi, "/nodes/0/extensions/OMI_physics_body/collider/shape", 0.5),
      {"/collider/shape", "whole number"});
  add("an OMI body of no type", with(omi, "/nodes/0/extensions/OMI_physics_body/motion/type", "rigid"),
      {"/motion/type", "rigid"});
  add("gravity without direction",
      with(minimal(), "/extensions/OMI_physics_gravity", {{"gravity", 9.8}, {"direction", {0, 0, 0}}}),
      {"/extensions/OMI_physics_gravity/direction", "no direction"});
  json joint = minimal();
  joint["nodes"][0]["extensions"]["OMI_physics_joint"] = {{"joint", 0}, {"connectedNode", 0}};
  add("an OMI joint of no extension", joint, {"/nodes/0/extensions/OMI_physics_joint", "physicsJoints"});
  all.push_back({"a number that no double holds",
                 R"({"asset":{"version":"2.0"},"nodes":[{"translation":[1e309,0,0]}]})",
                 {"1e309"}});
  add("an extension that is required", with(minimal(), "/extensionsRequired", {"ACME_future"}),
      {"/extensionsRequired/0", "ACME_future"});
  add("a mask of too many bits",
      with(minimal(), "/extensions/CAROM_physics/fields", json::array({{{"kind", "uniform"}, {"mask", 4294967296}}})),
      {"/mask", "bits"});
  add("bits that are no number",
      with(minimal(), "/extensions/CAROM_physics/fields", json::array({{{"kind", "uniform"}, {"mask", "-1"}}})),
      {"/mask"});
  add("a falloff in part",
      with(minimal(), "/extensions/CAROM_physics/fields", json::array({{{"kind", "radial"}, {"falloff", 1.5}}})),
      {"/falloff", "whole number"});
  for (const int axis : {0, 2}) {  // what is left of three when it is taken twice
    json twice = minimal();
    twice["nodes"][0]["extensions"]["KHR_physics_rigid_bodies"] = {{"motion", {{"mass", 1}}},
                                                                   {"joint", {{"connectedNode", 1}, {"joint", 0}}}};
    twice["nodes"].push_back(json::object());
    twice["scenes"][0]["nodes"].push_back(1);
    twice["extensions"]["KHR_physics_rigid_bodies"]["physicsJoints"] =
        json::array({{{"limits", json::array({{{"angularAxes", {axis, axis}}, {"min", -1}, {"max", 1}}})}}});
    add("an axis named twice", twice, {"/angularAxes/1", "named twice"});
  }
  for (const char* uri :
       {"/etc/hostname", "../secret.bin", "sub/../../secret.bin", "%2e%2e/secret.bin", "file://secret.bin",
        "bad%zz.bin", "link.bin", "pipe.bin", "sublink/inner.bin", "folder", "missing.bin", ""})
    add("a buffer elsewhere", with(minimal(), "/buffers", json::array({{{"byteLength", 4}, {"uri", uri}}})),
        {"/buffers/0/uri"});
  all.push_back({"nested beyond the stack", std::string(200000, '['), {"nested"}});
  all.push_back({"nothing", "", {"no JSON"}});
  return all;
}

/// What lies beside the scenes.
void put_traps(const Folder& folder) {
  folder.put("secret/secret.bin", "abcd");
  std::vector<float> corner;  // of triangles that lie apart
  for (int k = 0; k < kManyTriangles; ++k)
    for (const float x : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 0.f, 1.f})
      corner.push_back(x + (corner.size() % 3 == 0 ? 2.f * static_cast<float>(k) : 0.f));
  folder.put("scenes/triangles.bin",
             std::string(reinterpret_cast<const char*>(corner.data()), sizeof(float) * corner.size()));
  folder.put("scenes/folder/inner.bin", "abcd");
  assert_int_equal(symlink((folder.path + "/secret/secret.bin").c_str(), (folder.path + "/scenes/link.bin").c_str()),
                   0);
  assert_int_equal(symlink((folder.path + "/secret").c_str(), (folder.path + "/scenes/sublink").c_str()), 0);
  assert_int_equal(mkfifo((folder.path + "/scenes/pipe.bin").c_str(), 0600), 0);
}

/// Exit status and text of `carom ARGUMENTS`, in 512 MiB and 2 s of processor time. The address sanitizer reserves more than
/// that, and takes longer.
command_test::Outcome in_a_cell(const std::string& arguments) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || defined(CAROM_SANITIZED)
  return command_test::run_carom(arguments, true, "timeout 60 ");
#else
  return command_test::run_carom(arguments, true, "ulimit -v 524288; ulimit -t 2; timeout 20 ");
#endif
}

}  // namespace

static void each_is_refused_with_what_is_wrong(void**) {
  const Folder folder;
  folder.put("scenes/x", "");
  put_traps(folder);
  Engine engine(PluginPath({CAROM_PLUGIN_DIR}));
  for (const Case& c : cases()) {
    const std::string file = folder.put("scenes/scene.gltf", c.text);
    const auto start = std::chrono::steady_clock::now();
    Stage stage(engine);
    try {
      read_scene(file, stage);
      print_error("%s: read\n", c.name);
      assert_true(false);
    } catch (const Error& e) {
      for (const std::string& part : c.says)
        if (std::string(e.what()).find(part) == std::string::npos && e.remedy.find(part) == std::string::npos) {
          print_error("%s: says '%s' (%s), and not %s\n", c.name, e.what(), e.remedy.c_str(), part.c_str());
          assert_true(false);
        }
      assert_false(e.remedy.empty());
    }
    if (std::chrono::steady_clock::now() - start > std::chrono::seconds(2)) print_error("%s takes long\n", c.name);
  }
}

/// As a program: exit status 2, a cure, no signal, little memory.
static void none_harms_the_program(void**) {
  const Folder folder;
  folder.put("scenes/x", "");
  put_traps(folder);
  for (const Case& c : cases())
    for (const char* command : {"run ", "plan "}) {
      const auto outcome = in_a_cell(command + folder.put("scenes/scene.gltf", c.text));
      if (outcome.code != 2 || !outcome.says("what to do: ") || outcome.says("please report"))
        print_error("%s%s: exit %d, %s\n", command, c.name, outcome.code, outcome.text.c_str());
      assert_true(outcome.code == 2 && outcome.says("what to do: ") && !outcome.says("please report"));
    }
}

static void what_lies_below_is_read(void**) {
  const Folder folder;
  const char bytes[40] = {};
  for (const auto& [uri, name] :
       {std::pair("a%20b.bin", "a b.bin"), {"folder/inner.bin", "folder/inner.bin"}, {"./plain.bin", "plain.bin"}}) {
    folder.put("scenes/" + std::string(name), std::string(bytes, sizeof bytes));
    const json d = with(minimal(), "/buffers", json::array({{{"byteLength", 40}, {"uri", uri}}}));
    Engine engine(PluginPath({CAROM_PLUGIN_DIR}));
    Stage stage(engine);
    read_scene(folder.put("scenes/scene.gltf", d.dump()), stage);
  }
  Engine engine(PluginPath({CAROM_PLUGIN_DIR}));
  Stage stage(engine);
  read_scene(folder.put("scenes/scene.gltf", with(minimal(), "/extensionsRequired", {"KHR_materials_unlit"}).dump()),
             stage);
}

/// A shared object of the file's own: its constructor would write a file.
static void no_plugin_is_loaded_but_from_a_plugin_folder(void**) {
  const Folder folder;
  fs::create_directories(folder.path + "/plugins");
  fs::copy_file(CAROM_PLUGIN_DIR "/sphere.so", folder.path + "/stranger.so");
  fs::create_symlink(folder.path + "/stranger.so", folder.path + "/plugins/stranger.so");
  fs::copy_file(CAROM_PLUGIN_DIR "/sphere.so", folder.path + "/plugins/own.so");
  Engine engine(PluginPath({folder.path + "/plugins"}));
  for (const auto& [name, loads] : {std::pair("own", true), {"stranger", false}, {"../stranger", false}}) {
    Stage stage(engine);
    bool loaded = true;
    try {
      read_scene(folder.put("scenes/scene.gltf", of_plugin(name).dump()), stage);
    } catch (const Error&) {
      loaded = false;
    }
    assert_int_equal(loaded, loads);
  }
  const auto all = PluginPath({folder.path + "/plugins"}).all();
  assert_true(all.contains("own") && !all.contains("stranger"));
}

static void only_regular_files_of_bounded_size_are_read(void**) {
  const Folder folder;
  mkfifo((folder.path + "/pipe.gltf").c_str(), 0600);
  mkfifo((folder.path + "/pipe.obj").c_str(), 0600);
  for (const std::string& line : std::vector<std::string>{
           "run " + folder.path + "/pipe.gltf", "replay " + folder.path + "/pipe.gltf",
           "import " + folder.path + "/pipe.obj --out /dev/null", "run " + folder.path, "run /dev/zero.gltf"}) {
    const auto outcome = in_a_cell(line);
    if (outcome.code != 2) print_error("%s: exit %d, %s\n", line.c_str(), outcome.code, outcome.text.c_str());
    assert_int_equal(outcome.code, 2);
  }
  const std::string large = folder.put("large.gltf", "{");
  assert_int_equal(truncate(large.c_str(), 3l << 20), 0);
  const auto outcome = in_a_cell("run " + large + " --file-limit 1");
  assert_true(outcome.code == 2 && outcome.says("--file-limit"));
}

/// A recorded call whose count is more than its array holds.
static void recordings_read_nothing_beyond_their_lists(void**) {
  const Folder folder;
  Engine engine(PluginPath({CAROM_PLUGIN_DIR}));
  const std::string path = folder.path + "/session.rec";
  carom_particles set = 0;
  {
    World world(engine);
    assert_int_equal(carom_particles_create(world.get(), nullptr, &set, nullptr), CAROM_OK);
    replay::FileRecorder recorder(world, path, false);
    recorder.end();
  }
  const std::string whole = read_file(path, "");
  const auto number = [](auto x) { return std::string(reinterpret_cast<const char*>(&x), sizeof x); };
  const auto record = [&](std::uint32_t kind, const std::string& content) {
    return number(kind) + number(std::uint32_t(0)) + number(std::uint64_t(content.size())) + content +
           std::string(-content.size() % 8, '\0');
  };
  const auto list = [&](const std::string& raw, std::uint64_t n) { return number(std::uint64_t(1)) + number(n) + raw; };
  const std::string null = number(std::uint64_t(0)), three(24, '\0');
  std::uint64_t size = 0;
  std::memcpy(&size, whole.data() + 24, sizeof size);
  const std::string begin = whole.substr(0, 16 + 16 + (size + 7) / 8 * 8), world = whole.substr(32, size);
  const std::uint32_t position = CAROM_FIELD_POSITION, f64 = CAROM_SCALAR_F64;
  const struct {
    const char* call;
    std::string arguments;
  } calls[] = {
      {"carom_world_write", number(position) + number(f64) + null + number(std::uint64_t(1000)) + list(three, 24)},
      {"carom_world_write",
       number(position) + number(f64) + list("", 0) + number(std::uint64_t(1000)) + list(three, 24)},
      {"carom_world_write",
       number(position) + number(f64) + list(three, 3) + number(std::uint64_t(3)) + list(three, 24)},
      {"carom_world_write",
       number(std::uint32_t(99)) + number(f64) + null + number(~std::uint64_t(0)) + list(three, 24)},
      {"carom_particles_add",
       number(std::uint64_t(set)) + number(std::uint64_t(1000)) + number(f64) + list(three, 24) + null},
      {"carom_particles_remove",
       number(std::uint64_t(set)) + list(std::string(8, '\0'), 1) + number(std::uint64_t(1 << 20))},
      {"carom_world_restore", list(world.substr(0, 64), 64) + number(size)},
      {"carom_world_restore", list(world.substr(0, 64), 64) + number(std::uint64_t(1) << 40)},
  };
  for (const auto& call : calls) {
    const std::string file = begin + record(3, number(std::uint32_t(0)) + call.call) +
                             record(4, number(std::uint32_t(0)) + call.arguments) + record(7, "");
    try {
      const auto* const bytes = reinterpret_cast<const std::byte*>(file.data());
      const auto outcome = replay::play(engine.get(), {bytes, bytes + file.size()});
      assert_true(outcome.parting.has_value());  // refused by the library, at the least
    } catch (const Error& e) {
      if (!std::strstr(e.what(), "damaged")) print_error("%s: %s\n", call.call, e.what());
      assert_non_null(std::strstr(e.what(), "damaged"));
    }
    const auto outcome = in_a_cell("replay " + folder.put("evil.rec", file));
    if (outcome.code != 2 && outcome.code != 1)
      print_error("%s: exit %d, %s\n", call.call, outcome.code, outcome.text.c_str());
    assert_true(outcome.code == 1 || outcome.code == 2);
  }
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(each_is_refused_with_what_is_wrong),
      cmocka_unit_test(none_harms_the_program),
      cmocka_unit_test(what_lies_below_is_read),
      cmocka_unit_test(no_plugin_is_loaded_but_from_a_plugin_folder),
      cmocka_unit_test(only_regular_files_of_bounded_size_are_read),
      cmocka_unit_test(recordings_read_nothing_beyond_their_lists),
  };
  return cmocka_run_group_tests_name("tools/hostile_files", tests, nullptr, nullptr);
}
