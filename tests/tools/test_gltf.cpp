// Our own glTF, read back and judged by the specification's rules and by where the bodies really ended.
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "carom_test.h"
#include "scenes/run.h"
#include "visual/gltf.h"

using namespace carom::tools;
using nlohmann::json;

namespace {

std::string from_base64(const std::string& text) {
  std::string bytes;
  std::uint32_t group = 0;
  int bits = 0;
  for (char c : text) {
    if (c == '=') break;
    const int value = c >= 'A' && c <= 'Z'   ? c - 'A'
                      : c >= 'a' && c <= 'z' ? c - 'a' + 26
                      : c >= '0' && c <= '9' ? c - '0' + 52
                      : c == '+'             ? 62
                                             : 63;
    group = group << 6 | static_cast<std::uint32_t>(value);
    bits += 6;
    if (bits >= 8) bytes += static_cast<char>(group >> (bits -= 8) & 255);
  }
  return bytes;
}

std::uint32_t little32(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
  return value;
}

struct Document {
  json root;
  std::string bytes;

  int width(const json& accessor) const {
    const std::string type = accessor.at("type");
    return type == "SCALAR" ? 1 : type == "VEC3" ? 3 : type == "VEC4" ? 4 : 0;
  }
  std::vector<float> floats(std::size_t index) const {
    const json& accessor = root.at("accessors").at(index);
    const json& view = root.at("bufferViews").at(accessor.at("bufferView").get<std::size_t>());
    std::vector<float> values(accessor.at("count").get<std::size_t>() * static_cast<std::size_t>(width(accessor)));
    std::memcpy(values.data(), bytes.data() + view.at("byteOffset").get<std::size_t>(), values.size() * 4);
    return values;
  }
};

std::string slurp(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

Document read_back(const std::string& path) {
  Document d;
  const std::string file = slurp(path);
  if (path.ends_with(".glb")) {
    assert_true(file.substr(0, 4) == "glTF" && little32(file, 4) == 2 && little32(file, 8) == file.size());
    const std::size_t text = little32(file, 12);
    assert_true(text % 4 == 0 && file.substr(16, 4) == "JSON");
    d.root = json::parse(file.substr(20, text));
    assert_true(file.substr(24 + text, 4) == std::string("BIN\0", 4));
    d.bytes = file.substr(28 + text);
    assert_true(little32(file, 20 + text) == d.bytes.size() && d.bytes.size() % 4 == 0);
  } else {
    d.root = json::parse(file);
    const std::string uri = d.root.at("buffers").at(0).at("uri"), head = "data:application/octet-stream;base64,";
    assert_true(uri.starts_with(head));
    d.bytes = from_base64(uri.substr(head.size()));
  }
  assert_true(d.bytes.size() >= d.root.at("buffers").at(0).at("byteLength").get<std::size_t>());
  return d;
}

/// Bounds, alignment, min and max, indices in range, unit normals and rotations: what any viewer relies on.
void judge(const Document& d) {
  const std::size_t length = d.root.at("buffers").at(0).at("byteLength");
  for (const json& view : d.root.at("bufferViews"))
    assert_true(view.at("byteOffset").get<std::size_t>() % 4 == 0 &&
                view.at("byteOffset").get<std::size_t>() + view.at("byteLength").get<std::size_t>() <= length);
  for (std::size_t i = 0; i < d.root.at("accessors").size(); ++i) {
    const json& a = d.root.at("accessors").at(i);
    const json& view = d.root.at("bufferViews").at(a.at("bufferView").get<std::size_t>());
    const auto n = static_cast<std::size_t>(d.width(a));
    assert_true(n > 0 && a.at("count").get<std::size_t>() > 0);
    assert_int_equal(a.at("count").get<std::size_t>() * n * 4, view.at("byteLength").get<std::size_t>());
    if (!a.contains("min")) continue;
    const std::vector<float> values = d.floats(i);
    for (std::size_t k = 0; k < n; ++k) {
      float low = values[k], high = values[k];
      for (std::size_t j = k; j < values.size(); j += n) {
        low = std::min(low, values[j]);
        high = std::max(high, values[j]);
      }
      assert_true(a.at("min").at(k).get<float>() == low && a.at("max").at(k).get<float>() == high);
    }
  }
  for (const json& mesh : d.root.at("meshes"))
    for (const json& primitive : mesh.at("primitives")) {
      const std::size_t position = primitive.at("attributes").at("POSITION"),
                        normal = primitive.at("attributes").at("NORMAL");
      assert_true(d.root.at("accessors").at(position).contains("min"));
      const std::size_t count = d.root.at("accessors").at(position).at("count");
      const std::vector<float> normals = d.floats(normal);
      assert_int_equal(normals.size(), 3 * count);
      for (std::size_t j = 0; j < normals.size(); j += 3)
        assert_true(std::fabs(std::hypot(normals[j], normals[j + 1], normals[j + 2]) - 1) < 1e-6f);
      for (float raw : d.floats(primitive.at("indices"))) {
        std::uint32_t index;
        std::memcpy(&index, &raw, 4);
        assert_true(index < count);
      }
      assert_true(primitive.at("material").get<std::size_t>() < d.root.at("materials").size());
    }
}

struct Written {
  Document document;
  std::vector<Vec> ends;  // of the actors
  std::vector<Quat> turns;
  std::vector<std::string> names;
  std::vector<bool> moves;
};

Written write_and_read(const char* scene_name, const Settings& settings, const std::string& path) {
  const Scene& scene = find_scene(scene_name);
  Engine engine(PluginPath({CAROM_PLUGIN_DIR}));
  Stage stage(engine);
  const auto observer = build(scene, settings, stage);
  Recording recording(stage, scene.dt, 30);
  const RunSummary run = simulate(stage, nullptr, 0.52, scene.dt, [&](const carom_step_report& report) {
    recording.after_step(report.steps, report.time);
    return true;
  });
  recording.finish(run.simulated);
  write_gltf(path, stage, recording);
  Written w{read_back(path), {}, {}, {}, {}};
  for (std::size_t a = 0; a < stage.actors.size(); ++a) {
    w.ends.push_back(stage.position(a));
    w.turns.push_back(stage.orientation(a));
    w.names.push_back(stage.actors[a].name);
    w.moves.push_back(stage.actors[a].type == CAROM_BODY_DYNAMIC);
  }
  std::remove(path.c_str());
  return w;
}

/// Times increase; quaternions are unit and never jump to the other sign; the last key is where the body is.
void judge_motion(const Written& w, bool turning) {
  const json& animation = w.document.root.at("animations").at(0);
  std::size_t judged = 0;
  for (const json& channel : animation.at("channels")) {
    const json& sampler = animation.at("samplers").at(channel.at("sampler").get<std::size_t>());
    const std::vector<float> times = w.document.floats(sampler.at("input")),
                             values = w.document.floats(sampler.at("output"));
    assert_true(times.size() > 2 && times.front() == 0);
    for (std::size_t i = 1; i < times.size(); ++i) assert_true(times[i] > times[i - 1]);
    const std::string name =
        w.document.root.at("nodes").at(channel.at("target").at("node").get<std::size_t>()).at("name");
    const auto actor = static_cast<std::size_t>(std::find(w.names.begin(), w.names.end(), name) - w.names.begin());
    assert_true(actor < w.names.size() && w.moves[actor]);
    if (channel.at("target").at("path") == "translation") {
      assert_int_equal(values.size(), 3 * times.size());
      for (int k = 0; k < 3; ++k)
        assert_true(values[values.size() - 3 + static_cast<std::size_t>(k)] == static_cast<float>(w.ends[actor][k]));
      ++judged;
    } else {
      assert_int_equal(values.size(), 4 * times.size());
      for (std::size_t j = 0; j < values.size(); j += 4) {
        float length = 0, with_last = 0;
        for (std::size_t k = 0; k < 4; ++k) {
          length += values[j + k] * values[j + k];
          if (j) with_last += values[j + k] * values[j + k - 4];
        }
        assert_true(std::fabs(std::sqrt(length) - 1) < 1e-6f);  // a few roundings of a float
        assert_true(j == 0 || with_last >= 0);
      }
      const float* q = &values[values.size() - 4];
      const Eigen::Vector4d& real = w.turns[actor].coeffs();
      assert_true(std::fabs(std::fabs(q[0] * real[0] + q[1] * real[1] + q[2] * real[2] + q[3] * real[3]) - 1) < 1e-6);
    }
  }
  std::size_t moving = 0;
  for (bool moves : w.moves) moving += moves;
  assert_int_equal(judged, moving);
  assert_int_equal(animation.at("channels").size(), moving * (turning ? 2 : 1));
}

}  // namespace

static void a_gltf_of_the_seesaw_keeps_the_rules_and_the_motion(void**) {
  const Written w = write_and_read("seesaw", {{{"hull_vertices", 32}, {"dominoes", 3}}, ""}, "gltf_test.gltf");
  judge(w.document);
  judge_motion(w, true);
  assert_int_equal(w.document.root.at("cameras").size(), 1);
  bool floor = false;
  for (const json& node : w.document.root.at("nodes")) floor = floor || node.value("name", "") == "floor";
  assert_true(floor);
}

static void a_glb_shares_one_mesh_among_equal_shapes(void**) {
  const Written w = write_and_read("falling", {{{"n", 40}}, ""}, "gltf_test.glb");
  judge(w.document);
  judge_motion(w, true);
  assert_true(w.document.root.at("meshes").size() <= 17);  // 8 sizes of each kind, and the floor
}

static void particles_move_without_turning(void**) {
  const Written w = write_and_read("particles", {{{"n", 25}}, ""}, "gltf_particles.glb");
  judge(w.document);
  judge_motion(w, false);
  assert_int_equal(w.document.root.at("meshes").size(), 1);
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(a_gltf_of_the_seesaw_keeps_the_rules_and_the_motion),
      cmocka_unit_test(a_glb_shares_one_mesh_among_equal_shapes),
      cmocka_unit_test(particles_move_without_turning),
  };
  return cmocka_run_group_tests_name("tools/gltf", tests, nullptr, nullptr);
}
