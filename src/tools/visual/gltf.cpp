// Writes a recording as animated glTF 2.0. Layout: one buffer; every view aligned to 4 bytes; positions and times with
// min and max, as the specification asks [glTF2 §3.6.2, §3.11].
#include "visual/gltf.h"

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <tuple>

#include "visual/tessellate.h"

namespace carom::tools {
namespace {

using nlohmann::json;

constexpr int kFloat = 5126, kUnsignedInt = 5125, kVertexData = 34962, kIndexData = 34963;

const std::map<std::string, std::array<double, 3>>& palette() {
  static const std::map<std::string, std::array<double, 3>> colours = {
      {"bunny", {0.80, 0.62, 0.45}},  {"domino", {0.85, 0.85, 0.80}}, {"plank", {0.45, 0.28, 0.13}},
      {"axle", {0.30, 0.30, 0.34}},   {"weight", {0.16, 0.18, 0.24}}, {"box", {0.20, 0.42, 0.66}},
      {"sphere", {0.80, 0.30, 0.20}}, {"block", {0.62, 0.24, 0.16}},  {"particle", {0.95, 0.75, 0.20}},
      {"ground", {0.42, 0.48, 0.42}}};
  return colours;
}

class Writer {
 public:
  Writer(Stage& stage, const Recording& recording) : stage_(stage), recording_(recording) {
    json asset = {{"version", "2.0"}, {"generator", "carom"}};
    for (const std::string& remark : stage.remarks)
      if (remark.find("Stanford Computer Graphics Laboratory") != std::string::npos)
        asset["copyright"] = "bunny mesh: Stanford Computer Graphics Laboratory";
    document_ = {{"asset", asset}, {"scene", 0}, {"nodes", json::array()}};
    for (std::size_t a = 0; a < stage.actors.size(); ++a) add_actor(a);
    add_floor();
    add_camera();
    document_["scenes"] = json::array({{{"nodes", roots_}}});
    if (!channels_.empty())
      document_["animations"] = json::array({{{"name", "run"}, {"channels", channels_}, {"samplers", samplers_}}});
  }

  GltfDrawing take() { return {std::move(document_), std::move(bytes_), std::move(node_), std::move(part_node_)}; }

 private:
  static json numbers(const float* values, int n) {
    json list = json::array();
    for (int i = 0; i < n; ++i) list.push_back(static_cast<double>(values[i]));
    return list;
  }

  std::size_t append(const char* section, json entry) {
    json& list = document_[section];
    list.push_back(std::move(entry));
    return list.size() - 1;
  }

  /// Copy data into the buffer and describe it.   @return index of the accessor
  std::size_t accessor(const void* data, std::size_t count, int width, int component, const char* type, int target,
                       bool with_range) {
    const std::size_t length = count * static_cast<std::size_t>(width) * 4;
    json view = {{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", length}};
    if (target) view["target"] = target;
    bytes_.append(static_cast<const char*>(data), length);  // every element is 4 bytes, so views stay aligned
    json entry = {{"bufferView", append("bufferViews", std::move(view))},
                  {"componentType", component},
                  {"count", count},
                  {"type", type}};
    if (with_range) {
      const float* values = static_cast<const float*>(data);
      std::vector<float> low(values, values + width), high = low;
      for (std::size_t i = 0; i < count * static_cast<std::size_t>(width); ++i) {
        const std::size_t k = i % static_cast<std::size_t>(width);
        low[k] = std::min(low[k], values[i]);
        high[k] = std::max(high[k], values[i]);
      }
      entry["min"] = numbers(low.data(), width);
      entry["max"] = numbers(high.data(), width);
    }
    return append("accessors", std::move(entry));
  }

  std::size_t material(const std::string& kind) {
    if (const auto found = materials_.find(kind); found != materials_.end()) return found->second;
    const auto colour = palette().find(kind);
    const std::array<double, 3> rgb = colour == palette().end() ? std::array<double, 3>{0.6, 0.6, 0.6} : colour->second;
    const std::size_t id = append(
        "materials",
        {{"name", kind},
         {"pbrMetallicRoughness",
          {{"baseColorFactor", {rgb[0], rgb[1], rgb[2], 1.0}}, {"metallicFactor", 0.0}, {"roughnessFactor", 0.8}}}});
    return materials_[kind] = id;
  }

  struct Triangles {
    std::size_t positions, normals, indices;
  };

  Triangles triangles(const Mesh& mesh, double crease_cosine) {
    const ShadedMesh shaded = shade(mesh, crease_cosine);
    static_assert(sizeof(Eigen::Vector3f) == 12 && sizeof(std::array<std::uint32_t, 3>) == 12);
    return {accessor(shaded.points.data(), shaded.points.size(), 3, kFloat, "VEC3", kVertexData, true),
            accessor(shaded.normals.data(), shaded.normals.size(), 3, kFloat, "VEC3", kVertexData, false),
            accessor(shaded.faces.data(), shaded.faces.size() * 3, 1, kUnsignedInt, "SCALAR", kIndexData, false)};
  }

  std::size_t mesh_of(const Triangles& t, const std::string& name, const std::string& kind) {
    return append("meshes", {{"name", name},
                             {"primitives",
                              {{{"attributes", {{"POSITION", t.positions}, {"NORMAL", t.normals}}},
                                {"indices", t.indices},
                                {"material", material(kind)}}}}});
  }

  /// The mesh of a part in the colour of a kind, made on first use.
  std::size_t mesh(const Part& part, const std::string& kind) {
    const auto shape_key = std::make_tuple(part.shape, part.params, part.mesh);
    const auto key = std::make_pair(shape_key, kind);
    if (const auto found = meshes_.find(key); found != meshes_.end()) return found->second;
    auto known = shapes_.find(shape_key);
    if (known == shapes_.end()) {
      const double smooth = -1,
                   creased = 0.8;  // a scanned mesh is smooth all over; solids keep edges sharper than 37 deg
      known =
          shapes_
              .emplace(shape_key, part.mesh >= 0 ? triangles(stage_.meshes[static_cast<std::size_t>(part.mesh)], smooth)
                                                 : triangles(tessellate(stage_.engine(), part), creased))
              .first;
    }
    return meshes_[key] = mesh_of(known->second, kind + " " + part.shape, kind);
  }

  /// A particle has no shape; a small octahedron marks it.
  std::size_t particle_mesh(const std::string& kind) {
    const auto key = std::make_pair(std::make_tuple(std::string("particle"), std::vector<double>(), -1), kind);
    if (const auto found = meshes_.find(key); found != meshes_.end()) return found->second;
    std::vector<Vec> corners;
    for (int axis = 0; axis < 3; ++axis)
      for (double side : {-0.04, 0.04}) corners.push_back(side * Vec::Unit(axis));  // m
    return meshes_[key] = mesh_of(triangles(convex_hull(corners), 0.9), "particle", kind);
  }

  void add_actor(std::size_t a) {
    const Actor& actor = stage_.actors[a];
    node_.push_back(GltfDrawing::kNone);
    part_node_.emplace_back();
    json node = {{"name", actor.name},
                 {"translation", numbers(recording_.pose(0, a), 3)},
                 {"rotation", unit(recording_.pose(0, a) + 3)}};
    json children = json::array();
    if (actor.parts.empty()) node["mesh"] = particle_mesh(actor.kind);
    for (const Part& part : actor.parts) {
      if (part.shape == "half_space") return;  // drawn by add_floor()
      const std::size_t drawn = mesh(part, actor.kind);
      if (actor.parts.size() == 1 && part.position.isZero() && part.orientation.isApprox(Quat::Identity())) {
        node["mesh"] = drawn;
        part_node_[a] = {GltfDrawing::kNone};
        continue;
      }
      const Eigen::Vector3f at = part.position.cast<float>();
      const Eigen::Vector4f turned = part.orientation.coeffs().cast<float>();
      children.push_back(append(
          "nodes", {{"mesh", drawn}, {"translation", numbers(at.data(), 3)}, {"rotation", unit(turned.data())}}));
      part_node_[a].push_back(children.back());
    }
    if (!children.empty()) node["children"] = children;
    const std::size_t id = append("nodes", std::move(node));
    roots_.push_back(id);
    node_[a] = id;
    if (part_node_[a].size() == 1 && part_node_[a][0] == GltfDrawing::kNone) part_node_[a][0] = id;
    if (actor.type != CAROM_BODY_STATIC && recording_.frame_count() > 1) animate(id, a, !actor.parts.empty());
  }

  /// A float quaternion, unit as closely as floats allow.
  static json unit(const float* q) {
    Eigen::Vector4f v(q[0], q[1], q[2], q[3]);
    v.normalize();
    return numbers(v.data(), 4);
  }

  void animate(std::size_t node, std::size_t actor, bool turns) {
    const std::size_t frames = recording_.frame_count();
    if (!times_made_) {
      times_ = accessor(recording_.times().data(), frames, 1, kFloat, "SCALAR", 0, true);
      times_made_ = true;
    }
    std::vector<float> moves, rotations;
    for (std::size_t f = 0; f < frames; ++f) {
      const float* pose = recording_.pose(f, actor);
      moves.insert(moves.end(), pose, pose + 3);
      Eigen::Vector4f q(pose[3], pose[4], pose[5], pose[6]);
      q.normalize();
      rotations.insert(rotations.end(), q.data(), q.data() + 4);
    }
    auto channel = [&](std::size_t output, const char* path) {
      samplers_.push_back({{"input", times_}, {"output", output}, {"interpolation", "LINEAR"}});
      channels_.push_back({{"sampler", samplers_.size() - 1}, {"target", {{"node", node}, {"path", path}}}});
    };
    channel(accessor(moves.data(), frames, 3, kFloat, "VEC3", 0, false), "translation");
    if (turns) channel(accessor(rotations.data(), frames, 4, kFloat, "VEC4", 0, false), "rotation");
  }

  void add_floor() {
    bool faces_up = false;
    for (const Actor& actor : stage_.actors)
      for (const Part& part : actor.parts)
        faces_up = faces_up || (part.shape == "half_space" && part.params[1] > 0.99 && part.params[3] == 0);
    const double w = stage_.ground_half_width;
    if (!faces_up || !(w > 0)) return;
    const Mesh floor{{{-w, 0, -w}, {w, 0, -w}, {w, 0, w}, {-w, 0, w}}, {{0, 2, 1}, {0, 3, 2}}};
    roots_.push_back(append("nodes", {{"name", "floor"}, {"mesh", mesh_of(triangles(floor, 0.9), "floor", "ground")}}));
  }

  void add_camera() {
    // A glTF camera looks along its own -z, with +y up.
    const Vec back = (stage_.camera_from - stage_.camera_to).normalized();
    const Vec right = Vec::UnitY().cross(back).normalized();
    Eigen::Matrix3d frame;
    frame << right, back.cross(right), back;
    const Eigen::Vector4f turn = Quat(frame).normalized().coeffs().cast<float>();
    const Eigen::Vector3f from = stage_.camera_from.cast<float>();
    append("cameras", {{"type", "perspective"},
                       {"perspective", {{"yfov", 0.8}, {"aspectRatio", 16.0 / 9}, {"znear", 0.05}, {"zfar", 1000.0}}}});
    roots_.push_back(append("nodes", {{"name", "camera"},
                                      {"camera", 0},
                                      {"translation", numbers(from.data(), 3)},
                                      {"rotation", unit(turn.data())}}));
  }

  Stage& stage_;
  const Recording& recording_;
  json document_, roots_ = json::array(), channels_ = json::array(), samplers_ = json::array();
  std::string bytes_;
  std::vector<std::size_t> node_;
  std::vector<std::vector<std::size_t>> part_node_;
  std::map<std::string, std::size_t> materials_;
  std::map<std::tuple<std::string, std::vector<double>, int>, Triangles> shapes_;
  std::map<std::pair<std::tuple<std::string, std::vector<double>, int>, std::string>, std::size_t> meshes_;
  std::size_t times_ = 0;
  bool times_made_ = false;
};

std::string base64(const std::string& bytes) {
  static const char kLetters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t n = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) group = group << 8 | (k < n ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k) text += k <= n ? kLetters[group >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

void put32(std::string& out, std::size_t value) {  // little-endian, as the container asks
  for (int shift = 0; shift < 32; shift += 8) out += static_cast<char>(value >> shift & 255);
}

/// The binary container: header, JSON chunk padded with spaces, binary chunk padded with zeros [glTF2 §4.4].
std::string container(std::string text, std::string bytes) {
  text.append((4 - text.size() % 4) % 4, ' ');
  bytes.append((4 - bytes.size() % 4) % 4, '\0');
  const std::size_t total = 12 + 8 + text.size() + 8 + bytes.size();
  if (total > UINT32_MAX) throw Error("the recording does not fit a .glb file (4 GiB)", "record fewer frames: --fps");
  std::string out = "glTF";
  put32(out, 2);
  put32(out, total);
  put32(out, text.size());
  out += "JSON" + text;
  put32(out, bytes.size());
  out.append("BIN\0", 4);
  return out + bytes;
}

}  // namespace

void check_gltf_path(const std::string& path) {
  const std::string ending = std::filesystem::path(path).extension().string();
  if (ending != ".gltf" && ending != ".glb")
    throw Error("'" + path + "' does not say which kind of glTF to write", "end the name in .gltf or .glb");
  if (!std::ofstream(path, std::ios::binary))
    throw Error("cannot write " + path, "choose a folder that exists and may be written to");
}

GltfDrawing draw_gltf(Stage& stage, const Recording& recording) { return Writer(stage, recording).take(); }

void save_gltf(const std::string& path, GltfDrawing drawing) {
  check_gltf_path(path);
  drawing.document["buffers"] = json::array({{{"byteLength", drawing.bytes.size()}}});
  std::string out;
  if (path.ends_with(".glb")) {
    out = container(drawing.document.dump(), std::move(drawing.bytes));
  } else {
    drawing.document["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64(drawing.bytes);
    out = drawing.document.dump();
  }
  std::ofstream file(path, std::ios::binary);
  if (!file.write(out.data(), static_cast<std::streamsize>(out.size())).flush())
    throw Error("writing " + path + " failed", "free space on the disk");
}

void write_gltf(const std::string& path, Stage& stage, const Recording& recording) {
  save_gltf(path, draw_gltf(stage, recording));
}

}  // namespace carom::tools
