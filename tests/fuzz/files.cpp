#include "files.h"

#include <carom/carom.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "accuracy/sweep/rows.h"
#include "host/files.h"
#include "mesh/parts.h"
#include "mesh/read_mesh.h"
#include "replay/replay.h"
#include "scenefile/scenefile.h"
#include "scenes/run.h"

namespace carom::fuzz {
namespace {

using namespace carom::tools;
using nlohmann::json;

/// A file without a place: what is read of it is read by its descriptor.
class MemoryFile {
 public:
  explicit MemoryFile(const std::string& bytes) : fd_(memfd_create("carom_fuzz", MFD_CLOEXEC)) {
    if (fd_ < 0 || ftruncate(fd_, 0) != 0) std::abort();
    for (std::size_t at = 0; at < bytes.size();) {
      const ssize_t n = write(fd_, bytes.data() + at, bytes.size() - at);
      if (n <= 0) std::abort();
      at += static_cast<std::size_t>(n);
    }
  }
  ~MemoryFile() { close(fd_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  std::string path() const { return "/proc/self/fd/" + std::to_string(fd_); }

 private:
  int fd_;
};

/// Shapes stay with their engine: a new one now and then, or memory grows.
Engine& engine_of_now() {
  constexpr int kFiles = 256;
  static std::unique_ptr<Engine> engine;
  static int files = 0;
  if (!engine || files++ % kFiles == 0) {
    engine = std::make_unique<Engine>(PluginPath({CAROM_PLUGIN_DIR}));
    engine->load_all();
  }
  return *engine;
}

/// As src/dynamics/snapshot/frame.cpp computes it: a file that any bit flip refuses would test the checksum alone.
void mend_checksum(std::string& bytes) {
  if (bytes.size() < 32) return;
  const std::uint64_t n = bytes.size() - 32, size = bytes.size();
  std::uint64_t chain[4] = {n, ~n, 0x9E3779B97F4A7C15ull, 0xBF58476D1CE4E5B9ull}, at = 0;
  const auto mix = [](std::uint64_t h, std::uint64_t word) {
    h = (h ^ word) * 0x9E3779B97F4A7C15ull;
    return h ^ h >> 32;
  };
  const char* const from = bytes.data() + 32;
  for (; at + 32 <= n; at += 32)
    for (std::uint64_t k = 0; k < 4; ++k) {
      std::uint64_t word;
      std::memcpy(&word, from + at + 8 * k, 8);
      chain[k] = mix(chain[k], word);
    }
  for (; at < n; ++at) chain[0] = mix(chain[0], static_cast<unsigned char>(from[at]));
  const std::uint64_t sum = mix(mix(mix(chain[0], chain[1]), chain[2]), chain[3]);
  std::memcpy(bytes.data() + 16, &size, 8), std::memcpy(bytes.data() + 24, &sum, 8);
}

void read_scene_bytes(const std::string& bytes) {
  const MemoryFile file(bytes);
  Stage stage(engine_of_now());
  read_scene(file.path(), stage);
  stage.world.step(1.0 / 60);  // what was taken can be stepped
}

void read_snapshot_bytes(const std::string& bytes) {
  Engine& engine = engine_of_now();
  carom::tools::World world(engine);
  Call call;
  call.done(carom_world_restore(world.get(), bytes.data(), bytes.size(), call), "restoring");
  world.step(1.0 / 60);
}

void read(FileFormat format, const std::string& bytes) {
  switch (format) {
    case FileFormat::gltf:
    case FileFormat::glb:
      return read_scene_bytes(bytes);
    case FileFormat::obj: {
      const MemoryFile file(bytes);
      read_obj(file.path());
      return;
    }
    case FileFormat::stl:
      parse_stl(bytes, "a.stl");
      return;
    case FileFormat::ply:
      parse_ply(bytes, "a.ply");
      return;
    case FileFormat::snapshot:
      return read_snapshot_bytes(bytes);
    case FileFormat::recording: {
      const auto* const from = reinterpret_cast<const std::byte*>(bytes.data());
      replay::play(engine_of_now().get(), {from, from + bytes.size()});
      return;
    }
    case FileFormat::sweep: {
      const MemoryFile file(bytes);
      accuracy::read_json(file.path());
      return;
    }
    case FileFormat::count:
      return;
  }
}

std::string stage_as(const char* scene, std::vector<std::pair<std::string, double>> values, FileFormat format) {
  Engine engine(PluginPath({CAROM_PLUGIN_DIR}));
  Stage stage(engine);
  build(find_scene(scene), {std::move(values), ""}, stage);
  const std::string path = "/tmp/carom_seed_" + std::to_string(getpid()) + ".gltf";
  std::string bytes;
  if (format == FileFormat::gltf) {
    write_scene(path, stage, 1, 1.0 / 60);
    bytes = read_file(path, "");
  } else if (format == FileFormat::snapshot) {
    simulate(stage, nullptr, 0.2, 1.0 / 60);
    const std::vector<char> state = stage.world.save(CAROM_SNAPSHOT_WHOLE);
    bytes.assign(state.begin(), state.end());
  } else {
    replay::FileRecorder recorder(stage.world, path, true);
    simulate(stage, nullptr, 0.1, 1.0 / 60);
    recorder.end();
    bytes = read_file(path, "");
  }
  std::filesystem::remove(path);
  return bytes;
}

/// A .glb of a document whose buffers stand in it.
std::string as_glb(std::string text, std::string chunk) {
  text.resize((text.size() + 3) / 4 * 4, ' '), chunk.resize((chunk.size() + 3) / 4 * 4, '\0');
  const auto number = [](std::size_t x) {
    const auto n = static_cast<std::uint32_t>(x);
    return std::string(reinterpret_cast<const char*>(&n), 4);
  };
  const std::string body = number(text.size()) + "JSON" + text + number(chunk.size()) + std::string("BIN\0", 4) + chunk;
  return "glTF" + number(2) + number(12 + body.size()) + body;
}

/// By hand: a mesh, a joint, materials, filters, a force field, fields that `carom export` does not write.
std::string by_hand(bool binary) {
  static constexpr const char* kText = R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0,1,3]}],
"nodes":[{"mesh":0,"extensions":{"KHR_physics_rigid_bodies":{"collider":{"geometry":{"node":0},"collisionFilter":0}}}},
{"name":"ball","translation":[0,2,0],"scale":[1,1,1],"children":[2],"extensions":{"KHR_physics_rigid_bodies":{"motion":{"mass":1,
"inertiaDiagonal":[1,1,1],"gravityFactor":0.5},"collider":{"geometry":{"shape":0},"physicsMaterial":0},"joint":{"connectedNode":2,"joint":0}}}},
{"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]},{"translation":[3,3,0],"extensions":{"KHR_physics_rigid_bodies":{"motion":{},
"trigger":{"geometry":{"node":0,"convexHull":true}}}}}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],
"accessors":[{"componentType":5126,"count":4,"type":"VEC3","bufferView":0},{"componentType":5123,"count":12,"type":"SCALAR","bufferView":1}],
"bufferViews":[{"buffer":0,"byteLength":48,"byteStride":12},{"buffer":0,"byteOffset":48,"byteLength":24}],
"buffers":[{"byteLength":72BUFFER}],
"extensionsRequired":["KHR_physics_rigid_bodies"],
"extensions":{"KHR_implicit_shapes":{"shapes":[{"type":"sphere","sphere":{"radius":0.5}},{"type":"capsule","capsule":{"height":1,
"radiusBottom":0.2,"radiusTop":0.1}}]},"KHR_physics_rigid_bodies":{"physicsMaterials":[{"dynamicFriction":0.5,"frictionCombine":"average"}],
"collisionFilters":[{"collisionSystems":["a"],"collideWithSystems":["b"]}],"physicsJoints":[{"limits":[{"linearAxes":[0,1,2],"min":0,
"max":0},{"angularAxes":[1,2],"min":-0.5,"max":0.5,"stiffness":3,"damping":0.1}],"drives":[{"type":"angular","mode":"force","axis":0,
"maxForce":3,"velocityTarget":1,"damping":2,"stiffness":1,"positionTarget":0.5}]}]},"CAROM_physics":{"gravity":[0,-9.81,0],"dials":{"substeps":4},
"wind":[1,0,0],"water":{"level":-1},"fields":[{"kind":"vortex","strength":3,"mask":"0x3"}],
"springs":[{"nodeA":1,"stiffness":30,"rest":1,"anchorB":[0,5,0]}]}}})";
  const float x[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  const std::uint16_t corner[] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
  std::string data(reinterpret_cast<const char*>(x), sizeof x);
  data.append(reinterpret_cast<const char*>(corner), sizeof corner);
  std::string text = kText;
  std::string uri;
  if (!binary) {
    static constexpr const char* kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    uri = ",\"uri\":\"data:application/octet-stream;base64,";
    for (std::size_t i = 0; i + 2 < data.size(); i += 3) {
      const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(data[i + k]); };
      const unsigned group = unsigned(byte(0)) << 16 | unsigned(byte(1)) << 8 | byte(2);
      for (int shift = 18; shift >= 0; shift -= 6) uri += kDigits[group >> shift & 63];
    }
    uri += "\"";
  }
  text.replace(text.find("BUFFER"), 6, uri);
  return binary ? as_glb(text, data) : text;
}

/// The other family of extensions: bodies, shapes of all kinds, a joint, gravity of the world and of a volume, a mesh that moves.
std::string omi_by_hand() {
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0,1,3,4]}],"extensionsUsed":["OMI_physics_body"],
"nodes":[{"extensions":{"OMI_physics_body":{"motion":{"type":"dynamic","mass":2,"inertiaDiagonal":[1,2,0],"centerOfMass":[0,0.1,0],
"linearVelocity":[1,0,0]},"collider":{"shape":3,"physicsMaterial":0,"collisionFilter":-1}}}},
{"name":"b","translation":[0,2,0],"children":[2],"extensions":{"OMI_physics_body":{"motion":{"type":"dynamic","gravityFactor":0.5},"collider":{"shape":1}}}},
{"extensions":{"OMI_physics_joint":{"joint":0,"connectedNode":0,"enableCollision":true}}},
{"extensions":{"OMI_physics_body":{"trigger":{"shape":0,"nodes":[3,4]}},"OMI_physics_gravity":{"type":"directional","gravity":3,"stop":true,
"directional":{"direction":[0,1,0]}}}},
{"translation":[5,0,0],"extensions":{"OMI_physics_body":{"motion":{"type":"static"},"collider":{"shape":2}}}}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
"accessors":[{"componentType":5126,"count":3,"type":"VEC3","bufferView":0}],"bufferViews":[{"buffer":0,"byteLength":36}],
"buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}],
"extensions":{"OMI_physics_shape":{"shapes":[{"type":"box","box":{"size":[1,1,1]}},{"type":"capsule","capsule":{"height":1,"radius":0.1}},
{"type":"trimesh","trimesh":{"mesh":0}},{"type":"sphere","radius":0.3}]},"OMI_physics_body":{"physicsMaterials":[{"dynamicFriction":0.5}],
"collisionFilters":[{"collisionSystems":["a"]}]},"OMI_physics_gravity":{"gravity":9.8,"direction":[0,-1,0]},
"OMI_physics_joint":{"physicsJoints":[{"limits":[{"linearAxes":[0,1,2],"min":0,"max":0,"stiffness":-1},{"angularAxes":[1],"min":-0.5,"stiffness":3}],
"drives":[{"type":"angular","mode":"force","axis":0,"maxForce":-1,"velocityTarget":1,"damping":2}]}]}}})";
}

std::string stl_of(bool binary) {
  const float facet[12] = {0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0};
  if (!binary)
    return "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n";
  std::string bytes(80, '\0');
  const std::uint32_t n = 2;
  bytes.append(reinterpret_cast<const char*>(&n), 4);
  for (std::uint32_t k = 0; k < n; ++k)
    bytes.append(reinterpret_cast<const char*>(facet), sizeof facet).append(2, '\0');
  return bytes;
}

std::string ply_of(bool binary) {
  const std::string header = std::string("ply\nformat ") + (binary ? "binary_little_endian" : "ascii") +
                             " 1.0\ncomment c\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                             "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  if (!binary) return header + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  const float x[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  const std::int32_t corner[3] = {0, 1, 2};
  return header + std::string(reinterpret_cast<const char*>(x), sizeof x) + '\x03' +
         std::string(reinterpret_cast<const char*>(corner), sizeof corner);
}

std::vector<std::string> make_seeds(FileFormat format) {
  switch (format) {
    case FileFormat::gltf:
      return {by_hand(false), omi_by_hand(), stage_as("falling", {{"n", 6}}, format),
              stage_as("ragdoll", {{"n", 1}}, format)};
    case FileFormat::glb:
      return {by_hand(true)};
    case FileFormat::obj:
      return {"# c\no a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1/1 2//1 3\ng b\nf -1 -2 -3\n"};
    case FileFormat::stl:
      return {stl_of(false), stl_of(true)};
    case FileFormat::ply:
      return {ply_of(false), ply_of(true)};
    case FileFormat::snapshot:
      return {stage_as("falling", {{"n", 6}}, format), stage_as("ragdoll", {{"n", 1}}, format)};
    case FileFormat::recording:
      return {stage_as("falling", {{"n", 4}}, format)};
    case FileFormat::sweep: {
      accuracy::Sweep sweep;
      sweep.machine = "m", sweep.date = "d";
      sweep.engines.push_back({"carom", "1", "n"});
      const std::string path = "/tmp/carom_seed_" + std::to_string(getpid()) + ".json";
      accuracy::write_json(path, sweep);
      std::string bytes = read_file(path, "");
      std::filesystem::remove(path);
      return {bytes};
    }
    case FileFormat::count:
      break;
  }
  return {};
}

const std::vector<std::string> kNumbers = {
    "0",   "-1",    "1",      "255",    "256", "65536",      "2147483647",    "4294967295",
    "1e3", "1e308", "-1e308", "1e-320", "0.5", "4294967298", "1099511627776", "1e309"};

std::vector<std::string> make_words(FileFormat format) {
  std::vector<std::string> words = kNumbers;
  const auto add = [&](std::initializer_list<const char*> more) {
    words.insert(words.end(), more.begin(), more.end());
  };
  if (format == FileFormat::gltf || format == FileFormat::glb)
    add({"\"nodes\"",
         "\"children\"",
         "\"mesh\"",
         "\"matrix\"",
         "\"scale\"",
         "\"count\"",
         "\"byteStride\"",
         "\"byteOffset\"",
         "\"bufferView\"",
         "\"shape\"",
         "\"collider\"",
         "\"trigger\"",
         "\"geometry\"",
         "\"convexHull\"",
         "\"limits\"",
         "\"drives\"",
         "\"linearAxes\"",
         "\"angularAxes\"",
         "\"plugin\"",
         "\"params\"",
         "\"height_field\"",
         "\"half_space\"",
         "\"hull\"",
         "\"mesh\"",
         "\"particle\"",
         "\"attributes\"",
         "[0,0,0]",
         "[]",
         "{}",
         "null",
         "true",
         "\"\"",
         "\"../x\"",
         "\"a%20b.bin\"",
         "[0,1,2]"});
  if (format == FileFormat::obj) add({"v ", "f ", "g ", "/", "//", "\n", "nan", "inf"});
  if (format == FileFormat::stl) add({"vertex ", "facet", "endfacet", "nan", "inf"});
  if (format == FileFormat::ply)
    add({"property list uchar int vertex_indices\n", "element face ", "property double x\n", "binary_big_endian",
         "end_header\n"});
  return words;
}

}  // namespace

const char* name_of(FileFormat format) {
  static constexpr const char* kNames[] = {"gltf", "glb", "obj", "stl", "ply", "snapshot", "recording", "sweep"};
  return kNames[static_cast<std::size_t>(format)];
}

FileHeard read_as(FileFormat format, std::string bytes) {
  if (format == FileFormat::snapshot) mend_checksum(bytes);
  FileHeard heard;
  try {
    read(format, bytes);
    heard.read = true;
  } catch (const Error& e) {
    heard.complaint = e.what();
    if (e.remedy.empty()) heard.violation = "no cure: " + heard.complaint;
    if (heard.complaint.empty()) heard.violation = "no complaint";
    if (e.code == CAROM_E_INTERNAL) heard.violation = "internal: " + heard.complaint;
  } catch (const std::exception& e) {
    heard.violation = std::string("another exception: ") + e.what();
  }
  return heard;
}

const std::vector<std::string>& seeds_of(FileFormat format) {
  static std::vector<std::string> all[kFileFormats];
  std::vector<std::string>& seeds = all[static_cast<std::size_t>(format)];
  if (seeds.empty()) seeds = make_seeds(format);
  return seeds;
}

const std::vector<std::string>& words_of(FileFormat format) {
  static std::vector<std::string> all[kFileFormats];
  std::vector<std::string>& words = all[static_cast<std::size_t>(format)];
  if (words.empty()) words = make_words(format);
  return words;
}

}  // namespace carom::fuzz
