// A whole snapshot as a scene: a world that some host saved, run, planned and tuned without that host.
#include <cstring>
#include <filesystem>
#include <fstream>

#include "host/files.h"
#include "scenefile/scenefile.h"

namespace carom::tools {
namespace {

const char* kind_of(std::uint32_t type) {
  return type == CAROM_BODY_STATIC ? "ground" : type == CAROM_BODY_KINEMATIC ? "kinematic" : "body";
}

/// Bodies under the names of their slots. What a host called them, and what their shapes look like, is not in a snapshot.
void find_bodies(Stage& stage) {
  Call call;
  for (const carom_body body : stage.world.bodies()) {
    carom_body_desc desc;
    call.done(carom_body_desc_init(&desc, sizeof desc), "reading a body");
    call.done(carom_body_get(stage.world.get(), body, &desc, call), "reading a body");
    Actor actor;
    actor.name = "body " + std::to_string(body & 0xFFFFFF), actor.kind = kind_of(desc.type);
    actor.type = desc.type, actor.body = body, actor.mass = desc.mass;
    actor.position = Vec(desc.position), actor.orientation = Quat(desc.orientation);
    actor.linear_velocity = Vec(desc.linear_velocity), actor.angular_velocity = Vec(desc.angular_velocity);
    stage.actors.push_back(std::move(actor));
  }
}

}  // namespace

bool is_snapshot_file(const std::string& path) {
  char magic[8] = {0};
  std::error_code failed;
  if (!std::filesystem::is_regular_file(path, failed)) return false;  // opening a FIFO would wait
  std::ifstream file(path, std::ios::binary);
  return file.read(magic, sizeof magic) && std::memcmp(magic, "CAROMSNP", 8) == 0;
}

void read_snapshot(const std::string& path, Stage& stage) {
  const std::string bytes = read_file(path, "check the path");
  stage.engine().load_all();
  Call call;
  const std::int32_t result = carom_world_restore(stage.world.get(), bytes.data(), bytes.size(), call);
  if (result == CAROM_E_MISMATCH)
    throw Error(path + " is a snapshot of the state alone",
                "name the scene that it is of, and give it with --load; or save it whole", result);
  call.done(result, "building the world of " + path);
  stage.remarks.push_back("built of " + path);
  stage.bounds_min = Vec::Constant(-1e9), stage.bounds_max = Vec::Constant(1e9);  // no file said what is lost
  find_bodies(stage);
}

Scene scene_of_snapshot(const std::string& path) {
  Scene scene;
  scene.name = std::filesystem::path(path).stem().string();
  scene.summary = "The world that was saved in " + path + ".";
  scene.look_for = "what it was saved for";
  scene.seconds = 5;
  scene.dt = 1.0 / 60;
  scene.fill = [](Stage& stage, const std::vector<double>&, const std::string& file) -> std::unique_ptr<Observer> {
    read_snapshot(file, stage);
    return nullptr;
  };
  return scene;
}

}  // namespace carom::tools
