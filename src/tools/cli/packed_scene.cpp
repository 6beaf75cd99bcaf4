#include "cli/packed_scene.h"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>

#include "cli/packed_truth.h"
#include "host/files.h"
#include "scenefile/scenefile.h"
#include "visual/tessellate.h"

namespace carom::tools {
namespace {

std::string hex(std::uint64_t hash) {
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
  return text;
}

nlohmann::json three(const Vec& v) { return {v.x(), v.y(), v.z()}; }

/// Of letters that need no escaping in an address.
std::string plain(std::string name) {
  for (char& c : name)
    if (!((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-')) c = '_';
  return name.empty() ? "scene" : name;
}
std::string stem_of(const std::string& path) { return std::filesystem::path(path).stem().string(); }

nlohmann::json hashes_of(World& world, double dt, const HashedSteps& steps) {
  using Clock = std::chrono::steady_clock;
  nlohmann::json hashes = {{"0", hex(world.hash())}};
  const Clock::time_point start = Clock::now();
  for (std::uint64_t step = 1; step <= steps.most; ++step) {
    if (std::chrono::duration<double>(Clock::now() - start).count() > steps.seconds) break;
    world.step(dt);
    hashes[std::to_string(step)] = hex(world.hash());
  }
  return hashes;
}

/// What a page cannot find by asking for colliders: a body that touches nothing, and a mesh that is drawn in place of
/// the shape that collides.
nlohmann::json looks_of(Engine& engine, std::size_t body, const Part& part) {
  const auto& turn = part.orientation.coeffs();
  nlohmann::json look = {
      {"body", body}, {"position", three(part.position)}, {"orientation", {turn.x(), turn.y(), turn.z(), turn.w()}}};
  if (part.mesh >= 0) return look["mesh"] = part.mesh, look;
  if (part.shape == "hull_of") {
    std::vector<double> corners;
    for (const Vec& p : tessellate(engine, part).points) corners.insert(corners.end(), p.data(), p.data() + 3);
    return look["shape"] = "hull", look["params"] = corners, look;
  }
  look["shape"] = part.shape, look["params"] = part.params;
  return look;
}

/// A mesh for the eye, in whole numbers of `unit`.
nlohmann::json drawn_mesh(const Mesh& mesh) {
  constexpr double kCells = 25;    // along the longest edge: more is not seen of a body among others
  constexpr double kUnits = 4000;  // likewise
  Vec half = Vec::Zero();          // the bounding box is centred on the origin
  for (const Vec& p : mesh.points) half = half.cwiseMax(p.cwiseAbs());
  const double size = 2 * half.maxCoeff(), unit = size / kUnits;
  const Mesh thin = thinned(mesh, size / kCells);
  nlohmann::json points = nlohmann::json::array(), faces = nlohmann::json::array();
  for (const Vec& p : thin.points)
    for (int k = 0; k < 3; ++k) points.push_back(std::lround(p[k] / unit));
  for (const auto& face : thin.faces)
    for (const std::uint32_t corner : face) faces.push_back(corner);
  return {{"unit", unit}, {"points", std::move(points)}, {"faces", std::move(faces)}};
}

/// The scene's own numbers, with the values that it was made of.
nlohmann::json knobs_of(const Scene& scene, const SceneChoice& choice) {
  nlohmann::json knobs = nlohmann::json::array();
  const auto values = values_from(choice.sets);
  for (const Knob& knob : scene.knobs) {
    double value = knob.name == "n" && choice.n ? *choice.n : knob.initial;
    for (const auto& [name, given] : values)
      if (name == knob.name) value = given;
    knobs.push_back({{"name", knob.name},
                     {"unit", knob.unit},
                     {"help", knob.help},
                     {"min", knob.min},
                     {"max", knob.max},
                     {"whole", knob.whole},
                     {"value", value}});
  }
  return knobs;
}

}  // namespace

void PackedScene::rename(const std::string& name) {
  row["name"] = plain(name);
  row["world"] = file = plain(name) + (content.starts_with("CAROMREC") ? ".rec" : ".world");
  if (!truth.empty()) row["truth"]["file"] = plain(name) + ".truth";
}

PackedScene packed_scene(const SceneChoice& choice, const HashedSteps& steps, Context& context) {
  const bool has_truth = is_accuracy_scene(choice.scene);
  const Scene& scene = has_truth ? accuracy_scene(choice.scene) : chosen_scene(choice.scene);
  const double dt = choice.dt.value_or(scene.dt);
  Engine engine(context.plugins());
  engine.set_threads(choice.threads);
  Stage stage(engine);
  const std::unique_ptr<Observer> observer = set_up(choice, scene, stage);
  const std::vector<char> bytes = stage.world.save(CAROM_SNAPSHOT_WHOLE);
  PackedScene packed;
  packed.content.assign(bytes.begin(), bytes.end());
  packed.row = {{"summary", scene.summary},
                {"look_for", scene.look_for},
                {"dt", dt},
                {"seconds", choice.seconds.value_or(scene.seconds)},
                {"remarks", stage.remarks},
                {"camera", {{"from", three(stage.camera_from)}, {"to", three(stage.camera_to)}}},
                {"ground", stage.ground_half_width}};
  if (stage.water_level) packed.row["water"] = *stage.water_level;
  for (const Actor& actor : stage.actors)
    if (actor.particles == CAROM_NULL_HANDLE) packed.row["bodies"].push_back({actor.name, actor.kind});
  for (std::size_t i = 0; i < stage.actors.size(); ++i)
    for (const Part& part : stage.actors[i].parts)
      if (part.collider == CAROM_NULL_HANDLE || part.mesh >= 0)
        packed.row["looks"].push_back(looks_of(stage.engine(), i, part));
  for (const Mesh& mesh : stage.meshes) packed.row["meshes"].push_back(drawn_mesh(mesh));
  if (has_truth) {
    PackedTruth truth = packed_truth(stage, *observer, dt, packed.row["seconds"]);
    packed.truth = std::move(truth.content);
    if (!packed.truth.empty()) packed.row["truth"] = std::move(truth.row);
  }
  packed.row["particles"] = stage.particle_count();
  packed.row["knobs"] = knobs_of(scene, choice);
  packed.row["hashes"] = hashes_of(stage.world, dt, steps);
  packed.rename(is_scene_file(choice.scene) ? stem_of(choice.scene) : choice.scene);
  return packed;
}

bool is_recording(const std::string& path) {
  char magic[8] = {0};
  std::error_code failed;
  if (!std::filesystem::is_regular_file(path, failed)) return false;  // opening a FIFO would wait
  std::ifstream file(path, std::ios::binary);
  return file.read(magic, sizeof magic) && std::memcmp(magic, "CAROMREC", sizeof magic) == 0;
}

PackedScene packed_recording(const std::string& path) {
  PackedScene packed;
  packed.content = read_file(path, "check the path");
  packed.row = {{"summary", "A recorded session."}, {"look_for", "what it was recorded for"}, {"particles", 0}};
  packed.rename(stem_of(path));
  return packed;
}

}  // namespace carom::tools
