// Scene files do what the extensions ask: one scene for each feature, judged by what bodies do. The table of them is
// src/tools/scenefile/CONFORMANCE.md.
#include <unistd.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>

#include "carom_command.h"
#include "carom_test.h"
#include "mesh/solid.h"
#include "scenefile/scenefile.h"
#include "scenes/run.h"

using namespace carom::tools;
using nlohmann::json;

namespace {

constexpr double kG = 9.81;

std::string base_name() { return "/tmp/carom_conformance_" + std::to_string(getpid()); }

/// A list of one element is an array for gcc and that element for clang (CWG 2311).
json list(std::vector<json> items) { return json(std::move(items)); }
json khr(json what) { return {{"KHR_physics_rigid_bodies", std::move(what)}}; }
json omi(json what) { return {{"OMI_physics_body", std::move(what)}}; }
json of_shape(int k) { return {{"geometry", {{"shape", k}}}}; }

/// All nodes that are nobody's children are the scene's; shapes are given to both families of extensions.
json document(json nodes, json shapes, json joints = json::array()) {
  std::vector<bool> is_child(nodes.size(), false);
  json roots = json::array();
  for (const json& node : nodes)
    for (const json& child : node.value("children", json::array())) is_child[child.get<std::size_t>()] = true;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (!is_child[i]) roots.push_back(i);
  json d = {{"asset", {{"version", "2.0"}}}, {"scene", 0}, {"nodes", std::move(nodes)}};
  d["scenes"] = json::array({json::object({{"nodes", roots}})});
  d["extensions"] = {{"KHR_implicit_shapes", {{"shapes", shapes}}},
                     {"OMI_physics_shape", {{"shapes", shapes}}},
                     {"KHR_physics_rigid_bodies", {{"physicsJoints", joints}}},
                     {"OMI_physics_joint", {{"physicsJoints", joints}}}};
  return d;
}
json box(double x, double y, double z) { return {{"type", "box"}, {"box", {{"size", {x, y, z}}}}}; }
json ball(double r) { return {{"type", "sphere"}, {"sphere", {{"radius", r}}}}; }
json limit(const char* axes, json which, double lower, double upper) {
  return {{axes, std::move(which)}, {"min", lower}, {"max", upper}};
}
json locks(json linear, json angular) {
  return list({limit("linearAxes", std::move(linear), 0, 0), limit("angularAxes", std::move(angular), 0, 0)});
}

struct Scenery {
  std::vector<float> points;
  std::vector<std::uint16_t> corners;
  void add_box(const Vec& low, const Vec& high) {
    const auto first = static_cast<std::uint16_t>(points.size() / 3);
    for (int k = 0; k < 8; ++k)
      for (int i = 0; i < 3; ++i) points.push_back(static_cast<float>(k >> i & 1 ? high[i] : low[i]));
    for (const int c :
         {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5})
      corners.push_back(static_cast<std::uint16_t>(first + c));
  }
  /// As mesh `index` of a document, in a file of its own.
  void put_into(json& d) const {
    const std::size_t n = d.value("meshes", json::array()).size();
    const std::string name = base_name() + "_" + std::to_string(n) + ".bin";
    std::ofstream out(name, std::ios::binary);
    out.write(reinterpret_cast<const char*>(points.data()), static_cast<std::streamsize>(4 * points.size()));
    out.write(reinterpret_cast<const char*>(corners.data()), static_cast<std::streamsize>(2 * corners.size()));
    d["buffers"].push_back(
        {{"byteLength", 4 * points.size() + 2 * corners.size()}, {"uri", name.substr(name.rfind('/') + 1)}});
    d["bufferViews"].push_back({{"buffer", n}, {"byteLength", 4 * points.size()}});
    d["bufferViews"].push_back({{"buffer", n}, {"byteOffset", 4 * points.size()}, {"byteLength", 2 * corners.size()}});
    d["accessors"].push_back(
        {{"bufferView", 2 * n}, {"componentType", 5126}, {"type", "VEC3"}, {"count", points.size() / 3}});
    d["accessors"].push_back(
        {{"bufferView", 2 * n + 1}, {"componentType", 5123}, {"type", "SCALAR"}, {"count", corners.size()}});
    json primitive = {{"attributes", {{"POSITION", 2 * n}}}, {"indices", 2 * n + 1}};
    d["meshes"].push_back({{"name", "mesh " + std::to_string(n)}, {"primitives", json::array({primitive})}});
  }
};
/// A trough along z: 2 m wide, its hollow 1.5 m wide and 1 m deep.
Scenery trough() {
  Scenery s;
  s.add_box({-1, 0, -1}, {1, 0.25, 1}), s.add_box({-1, 0.25, -1}, {-0.75, 1.25, 1}),
      s.add_box({0.75, 0.25, -1}, {1, 1.25, 1});
  return s;
}

struct ReadScene {
  explicit ReadScene(const json& d)
      : path(base_name() + ".gltf"), engine(PluginPath({CAROM_PLUGIN_DIR})), stage(engine) {
    std::ofstream(path) << d.dump();
    read_scene(path, stage);
    stage.world.set_dial("sleep=off");
  }
  ~ReadScene() {
    std::remove(path.c_str());
    for (const char* k : {"_0.bin", "_1.bin"}) std::remove((base_name() + k).c_str());
  }
  std::size_t index(const std::string& name) const {
    for (std::size_t a = 0; a < stage.actors.size(); ++a)
      if (stage.actors[a].name == name) return a;
    print_error("no actor %s\n", name.c_str());
    assert_true(false);
    return 0;
  }
  Vec at(const std::string& name) const { return stage.position(index(name)); }
  Vec velocity(const std::string& name) const { return stage.velocity(index(name)); }
  Vec spin(const std::string& name) { return Vec(Eigen::Map<const Eigen::Vector3d>(body(name).angular_velocity)); }
  carom_body_desc body(const std::string& name) {
    carom_body_desc d;
    carom_body_desc_init(&d, sizeof d);
    assert_int_equal(carom_body_get(stage.world.get(), stage.actors[index(name)].body, &d, nullptr), CAROM_OK);
    return d;
  }
  std::uint32_t lock_bits(const std::string& name) {
    std::uint32_t bits = 0;
    assert_int_equal(carom_body_get_locks(stage.world.get(), stage.actors[index(name)].body, &bits, nullptr), CAROM_OK);
    return bits;
  }
  bool says(const std::string& what) const {
    for (const std::string& r : stage.remarks)
      if (r.find(what) != std::string::npos) return true;
    return false;
  }
  void says_nothing_else() const {
    for (std::size_t k = 1; k < stage.remarks.size(); ++k) print_error("%s\n", stage.remarks[k].c_str());
    assert_int_equal(stage.remarks.size(), 1);  // where it was read from
  }
  void run(double seconds) { simulate(stage, nullptr, seconds, 1.0 / 240); }
  std::string path;
  Engine engine;
  Stage stage;
};

void is_near(double a, double b, double most) {
  if (!(std::fabs(a - b) <= most)) print_error("%.9g, not %.9g within %g\n", a, b, most), assert_true(false);
}

/// A body on a joint to the world: node 0 is the body, 1 its end of the joint, 2 the world's, turned alike.
json jointed(const json& motion, const json& joint, const Vec& body_at, const json& turn, bool is_omi) {
  json from = {{"translation", {0, 0, 0}}, {"rotation", turn}};
  json body = {
      {"name", "body"}, {"translation", {body_at.x(), body_at.y(), body_at.z()}}, {"children", json::array({1})}};
  body["extensions"] = is_omi ? omi({{"motion", motion}, {"collider", {{"shape", 0}}}})
                              : khr({{"motion", motion}, {"collider", of_shape(0)}});
  const json ends = {{"connectedNode", 1}, {"joint", 0}};
  from["extensions"] = is_omi ? json{{"OMI_physics_joint", ends}} : khr({{"joint", ends}});
  return document(json::array({body, json::object({{"rotation", turn}}), from}), json::array({box(0.2, 0.2, 0.2)}),
                  json::array({joint}));
}
const json kStraight = {0, 0, 0, 1};
const json kXUp = {0, 0, std::sqrt(0.5), std::sqrt(0.5)};

}  // namespace

static void a_lock_at_an_offset_holds_there(void**) {
  json limits = locks({1, 2}, {1, 2});
  limits.push_back(limit("linearAxes", {0}, 1, 1));
  ReadScene w(jointed({{"mass", 2}}, {{"limits", limits}}, Vec(0, 1, 0), kXUp, false));
  w.says_nothing_else();
  w.run(2);
  is_near((w.at("body") - Vec(0, 1, 0)).norm(), 0, 1e-3);
}

static void a_soft_limit_sinks_by_load_over_stiffness(void**) {
  for (const bool is_omi : {false, true}) {
    json limits = locks({0, 2}, {0, 1, 2});
    limits.push_back({{"linearAxes", {1}}, {"min", 0}, {"stiffness", 500}, {"damping", 60}});
    json motion = {{"mass", 2}, {"type", "dynamic"}};
    ReadScene w(jointed(motion, {{"limits", limits}}, Vec::Zero(), kStraight, is_omi));
    w.says_nothing_else();
    w.run(4);
    is_near(w.at("body").y(), -2 * kG / 500, 1e-4);
  }
  // A spring to a point, as one limit of three axes.
  ReadScene w(jointed(
      {{"mass", 1}, {"type", "dynamic"}},
      {{"limits", json::array({json::object(
                      {{"linearAxes", {0, 1, 2}}, {"min", 0}, {"max", 0}, {"stiffness", 300}, {"damping", 30}})})}},
      Vec(0.1, 0, 0), kStraight, true));
  w.says_nothing_else();
  w.run(6);
  is_near((w.at("body") - Vec(0, -kG / 300, 0)).norm(), 0, 1e-3);
}

/// A soft range of a distance: within it nothing, beyond it a spring.
static void a_soft_distance_is_a_spring(void**) {
  const json rope = {
      {"limits", json::array({json::object(
                     {{"linearAxes", {0, 1, 2}}, {"min", 0}, {"max", 1}, {"stiffness", 200}, {"damping", 20}})})}};
  ReadScene w(jointed({{"mass", 1}}, rope, Vec(0, -0.5, 0), kStraight, false));
  assert_true(w.says("a soft distance is a spring"));
  w.run(0.1);
  is_near(w.velocity("body").y(), -kG * 0.1, 1e-6);  // still slack
  w.run(6);
  is_near(w.at("body").y(), -1 - kG / 200, 1e-3);
}

static void materials_that_mix_in_another_order_are_named(void**) {
  json d = document(json::array(), json::array());
  d["extensions"]["KHR_physics_rigid_bodies"]["physicsMaterials"] =
      list({json{{"frictionCombine", "multiply"}}, json{{"frictionCombine", "minimum"}}});
  ReadScene w(d);
  assert_true(w.says("some multiply (frictionCombine)"));
}

static void a_limit_of_no_stiffness_holds_nothing_and_is_named(void**) {
  json limits = locks({0, 2}, {0, 1, 2});
  limits.push_back({{"linearAxes", {1}}, {"min", 0}, {"max", 0}, {"stiffness", 0}});
  ReadScene w(jointed({{"mass", 2}}, {{"limits", limits}}, Vec::Zero(), kStraight, false));
  assert_true(w.says("limits/2: a limit of no stiffness"));
  w.run(1);
  is_near(w.at("body").y(), -kG / 2, 0.03);
}

static void a_drive_reaches_its_velocity_with_its_force(void**) {
  json drive = {{"type", "angular"},   {"mode", "force"}, {"axis", 1},
                {"velocityTarget", 3}, {"damping", 50},   {"maxForce", 2}};
  ReadScene w(jointed({{"mass", 1}, {"inertiaDiagonal", {1, 1, 1}}},
                      {{"limits", locks({0, 1, 2}, {0, 2})}, {"drives", json::array({drive})}}, Vec::Zero(), kStraight,
                      false));
  w.says_nothing_else();
  w.run(1);
  is_near(w.spin("body").y(), 2, 0.02);  // rad/s: as fast as 2 N m make it
  w.run(4);
  is_near(w.spin("body").y(), 3, 1e-3);
}

static void what_is_negative_has_no_bound_in_omi(void**) {
  json limits = locks({0, 2}, {0, 1, 2});
  limits.push_back({{"linearAxes", {1}}, {"min", 0}, {"stiffness", -1}});
  ReadScene w(jointed({{"mass", 2}, {"type", "dynamic"}}, {{"limits", limits}}, Vec::Zero(), kStraight, true));
  w.says_nothing_else();
  w.run(1);
  is_near(w.at("body").y(), 0, 1e-3);
  json drive = {{"type", "linear"}, {"mode", "force"}, {"axis", 1},
                {"stiffness", 100}, {"damping", 10},   {"maxForce", -1}};
  ReadScene no_target(jointed({{"mass", 1}, {"type", "dynamic"}},
                              {{"limits", locks({0, 2}, {0, 1, 2})}, {"drives", json::array({drive})}}, Vec::Zero(),
                              kStraight, true));
  no_target.run(3);
  is_near(no_target.velocity("body").y(), -kG / 10,
          0.01);  // m/s: no spring without a target, so damping alone bears it
}

static void moments_are_taken_as_given(void**) {
  ReadScene w(jointed({{"mass", 1}, {"inertiaDiagonal", {0.4, 0.1, 0.1}}, {"angularVelocity", {2, 0, 0}}},
                      {{"limits", locks({0, 1, 2}, {1, 2})}}, Vec::Zero(), kStraight, false));
  assert_true(w.says("as given") && w.says("/nodes/0/extensions/KHR_physics_rigid_bodies/motion/inertiaDiagonal"));
  is_near(w.body("body").inertia[0], 0.4, 1e-12);
  w.run(1);
  is_near(w.spin("body").x(), 2, 1e-6);
}

/// Two infinite moments are locks where the third lies along an axis of the world; one is a very large number.
static void infinite_moments(void**) {
  const auto spinner = [](json moments, json rotation) {
    json motion = {
        {"mass", 1}, {"inertiaDiagonal", std::move(moments)}, {"angularVelocity", {0, 2, 0}}, {"gravityFactor", 0}};
    json node = {{"name", "body"}, {"rotation", std::move(rotation)}};
    node["extensions"] = khr({{"motion", motion}, {"collider", of_shape(0)}});
    json bullet = {{"name", "bullet"}, {"translation", {0.4, 2, 0}}};
    bullet["extensions"] = khr(
        {{"motion", {{"mass", 1}, {"linearVelocity", {0, -3, 0}}, {"gravityFactor", 0}}}, {"collider", of_shape(1)}});
    return document(json::array({node, bullet}), json::array({box(1, 1, 1), ball(0.1)}));
  };
  ReadScene exact(spinner({0, 1, 0}, kStraight));
  exact.says_nothing_else();
  assert_int_equal(exact.lock_bits("body"), CAROM_LOCK_ANGULAR_X | CAROM_LOCK_ANGULAR_Z);
  exact.run(1);
  assert_true(exact.velocity("body").y() < -0.1);  // it was hit off its middle
  assert_true(exact.spin("body").x() == 0 && exact.spin("body").z() == 0);
  is_near(exact.spin("body").y(), 2, 0.5);
  ReadScene oblique(spinner({0, 1, 0}, {0, 0, std::sin(0.3), std::cos(0.3)}));
  assert_true(oblique.says("infinite about some axes") && oblique.lock_bits("body") == 0);
  ReadScene one(spinner({1, 1, 0}, kStraight));
  assert_true(one.says("infinite about some axes"));
  one.run(1);
  assert_true(one.velocity("body").y() < -0.1);
  is_near((one.stage.orientation(one.index("body")).conjugate() * one.spin("body")).z(), 0, 0.005);  // rad/s, of 2
}

static void a_mesh_that_moves_is_hollow_where_it_is(void**) {
  json carrier = {{"name", "trough"}, {"mesh", 0}};
  carrier["extensions"] = khr({{"motion", {{"mass", 50}}}, {"collider", {{"geometry", {{"node", 0}}}}}});
  json in = {{"name", "ball"}, {"translation", {0, 1.6, 0}}};
  in["extensions"] = khr({{"motion", {{"mass", 1}}}, {"collider", of_shape(0)}});
  json floor = {{"name", "floor"}, {"translation", {0, -0.5, 0}}};
  floor["extensions"] = khr({{"collider", of_shape(1)}});
  json d = document(json::array({carrier, in, floor}), json::array({ball(0.2), box(20, 1, 20)}));
  trough().put_into(d);
  ReadScene w(d);
  const std::size_t parts = w.stage.actors[w.index("trough")].parts.size();
  assert_true(parts >= 3 && parts <= 8 && w.says(std::to_string(parts) + " convex parts that stand out of it by"));
  w.run(3);
  // In the hollow, and not on its hull, at 1.45: parts may stand out by a tenth of the mesh's length of 2 m.
  is_near(w.at("ball").y(), 0.45, 0.2);
  json brick = d;
  for (const char* key : {"meshes", "buffers", "bufferViews", "accessors"}) brick.erase(key);
  Scenery solid;
  solid.add_box({-1, 0, -1}, {1, 1.25, 1});
  solid.put_into(brick);
  ReadScene convex(brick);
  convex.says_nothing_else();
  assert_int_equal(convex.stage.actors[convex.index("trough")].parts.size(), 1);
}

static void omi_bodies_fall_with_their_gravity(void**) {
  const auto node = [](const char* name, double x, json what, json children = json::array()) {
    json n = {{"name", name}, {"translation", {x, 0, 0}}, {"extensions", omi(std::move(what))}};
    if (!children.empty()) n["children"] = std::move(children);
    return n;
  };
  const json collider = {{"shape", 0}};
  json d = document(
      json::array({node("falls", 0, {{"motion", {{"type", "dynamic"}, {"linearVelocity", {0, 1, 0}}}}}, {4, 5}),
                   node("stays", 10, {{"motion", {{"type", "static"}, {"mass", 7}}}, {"collider", collider}}),
                   node("moves", 20,
                        {{"motion", {{"type", "kinematic"}, {"linearVelocity", {0, 0, 2}}}}, {"collider", collider}}),
                   node("alone", 30, {{"collider", collider}, {"trigger", {{"shape", -1}}}}),
                   node("half", 1, {{"collider", {{"shape", 1}}}}), node("sensor", 0, {{"trigger", collider}})}),
      json::array({box(1, 1, 1), json::object({{"type", "capsule"}})}));
  d["extensions"]["OMI_physics_gravity"] = {{"gravity", 1.6}, {"direction", {1, 0, 0}}};
  ReadScene w(d);
  w.says_nothing_else();
  assert_int_equal(w.stage.actors.size(), 4);
  const Actor& falls = w.stage.actors[w.index("falls")];
  assert_true(falls.parts.size() == 2 && falls.parts[0].shape == "capsule" &&
              falls.parts[0].params == std::vector<double>({0.5, 0.5}));
  is_near(w.body("falls").mass, 1, 1e-12);
  is_near(w.body("falls").center[0], 0, 1e-12);  // where the extension has it if nothing is said
  w.run(1);
  is_near(w.at("falls").x(), 0.8, 0.01);
  is_near(w.at("falls").y(), 1, 1e-6);
  assert_true(w.at("stays") == Vec(10, 0, 0) && w.at("alone") == Vec(30, 0, 0));
  is_near(w.at("moves").z(), 2, 1e-6);
}

static void omi_meshes_and_earlier_drafts(void**) {
  json bodies = json::array();
  for (int k = 0; k < 3; ++k) {
    bodies.push_back({{"name", "body " + std::to_string(k)}, {"translation", {5 * k, 0, 0}}});
    bodies.back()["extensions"] =
        omi({{"motion", {{"type", k == 1 ? "static" : "dynamic"}}}, {"collider", {{"shape", k}}}});
  }
  bodies.push_back({{"extensions", omi({{"type", "rigid"}, {"mass", 1}})}});
  bodies.push_back({{"extensions", {{"OMI_collider", {{"collider", 0}}}}}});
  json d = document(bodies, json::array({json{{"type", "convex"}, {"convex", {{"mesh", 0}}}},
                                         json{{"type", "trimesh"}, {"trimesh", {{"mesh", 0}}}},
                                         json{{"type", "capsule"}, {"capsule", {{"height", 1}, {"radius", 0.2}}}}}));
  d["extensionsUsed"] = {"OMI_physics_body", "OMI_vehicle_body", "KHR_materials_unlit"};
  trough().put_into(d);
  ReadScene w(d);
  assert_true(w.stage.actors[0].parts.size() == 1 && w.stage.actors[0].parts[0].shape == "hull" &&
              w.stage.actors[1].parts[0].shape == "mesh");
  is_near(w.stage.actors[2].parts[0].params[1], 0.3, 1e-12);  // m: half of 1, less a cap
  for (const char* what : {"its height counts the caps", "a body of an earlier draft", "a collider of an earlier draft",
                           "OMI_vehicle_body"})
    assert_true(w.says(what));
  assert_false(w.says("KHR_materials_unlit"));
}

static void gravity_of_a_volume_is_a_field_or_named(void**) {
  const auto volume = [](json gravity, json at, int shape) {
    json node = {{"translation", std::move(at)}};
    node["extensions"] = {{"OMI_physics_body", {{"trigger", {{"shape", shape}}}}},
                          {"OMI_physics_gravity", std::move(gravity)}};
    return node;
  };
  const auto body = [](const char* name, json at) {
    json node = {{"name", name}, {"translation", std::move(at)}};
    node["extensions"] = omi({{"motion", {{"type", "dynamic"}}}, {"collider", {{"shape", 0}}}});
    return node;
  };
  const json shapes = list({ball(0.1), box(10, 10, 10), ball(40)});
  // Weightless in a room: the volume stops the world's gravity.
  ReadScene room(document(list({volume({{"type", "directional"}, {"gravity", 0}, {"stop", true}}, {0, 0, 0}, 1),
                                body("in", {1, 0, 0}), body("out", {20, 0, 0})}),
                          shapes));
  room.says_nothing_else();
  room.run(1);
  is_near(room.at("in").y(), 0, 1e-9);
  is_near(room.at("out").y(), -kG / 2, 0.03);
  // Two rooms apart are two fields; two that meet have to be weighed by priority, and are named.
  const json up = {{"type", "directional"}, {"gravity", -1}, {"stop", true}};
  ReadScene apart(
      document(list({volume(up, {0, 0, 0}, 1), volume(up, {30, 0, 0}, 1), body("in", {30, 0, 0})}), shapes));
  apart.says_nothing_else();
  apart.run(1);
  is_near(apart.at("in").y(), 0.5, 0.01);
  ReadScene meeting(
      document(list({volume(up, {0, 0, 0}, 1), volume(up, {4, 0, 0}, 1), body("in", {0, 0, 0})}), shapes));
  assert_true(meeting.says("/nodes/0/extensions/OMI_physics_gravity: gravity") &&
              meeting.says("/nodes/1/extensions/OMI_physics_gravity: gravity"));
  // A planet: a quarter of its surface's gravity at twice its radius.
  json planet =
      document(list({volume({{"type", "point"}, {"gravity", 8}, {"point", {{"unitDistance", 5}}}}, {0, 0, 0}, 2),
                     body("in", {10, 0, 0}), body("out", {0, 50, 0})}),
               shapes);
  planet["extensions"]["OMI_physics_gravity"] = {{"gravity", 0}};
  ReadScene space(planet);
  space.says_nothing_else();
  space.run(0.5);
  is_near(space.at("in").x(), 10 - 0.25, 0.01);
  assert_true(space.at("out") == Vec(0, 50, 0));
  ReadScene torus(
      document(list({volume({{"type", "torus"}, {"gravity", 8}}, {0, 0, 0}, 2), body("in", {10, 0, 0})}), shapes));
  assert_true(torus.says("/nodes/0/extensions/OMI_physics_gravity: gravity of a volume"));
}

static void import_reads_gltf_and_writes_a_scene(void**) {
  json node = {{"mesh", 0}, {"scale", {2, 2, 2}}};
  json d = document(json::array({node, json::object({{"mesh", 1}, {"translation", {0, 10, 0}}})}), json::array());
  trough().put_into(d);
  Scenery brick;
  brick.add_box({0, 0, 0}, {1, 1, 1});
  brick.put_into(d);
  ReadScene w(d);
  is_near(std::fabs(volume_of(mesh_of_gltf(w.path))), 8 * 2 + 1, 1e-5);
  is_near(std::fabs(volume_of(mesh_of_gltf(w.path, "1"))), 1, 1e-6);
  is_near(std::fabs(volume_of(mesh_of_gltf(w.path, "mesh 0"))), 2, 1e-6);
  const std::string out = base_name() + "_out.glb";
  const auto made = command_test::run_carom("import " + w.path + " --mesh 0 --out " + out);
  if (made.code != 0) print_error("%s\n", made.text.c_str());
  assert_true(made.code == 0 && made.says("carom run"));
  Engine engine(PluginPath({CAROM_PLUGIN_DIR}));
  Stage stage(engine);
  read_scene(out, stage);
  assert_true(stage.actors.size() == 1 && stage.actors[0].parts.size() >= 3);
  assert_int_equal(command_test::run_carom("run " + out + " --seconds 0.5").code, 0);
  const auto none = command_test::run_carom("import " + w.path + " --mesh nothing");
  assert_true(none.code == 2 && none.says("mesh 0") && none.says("what to do: "));
  std::remove(out.c_str());
}

/// Khronos' validator finds no error, where it is installed.
static void what_is_written_is_valid(void**) {
  if (std::system("command -v gltf_validator >/dev/null 2>&1") != 0) skip();
  for (const char* name : {"seesaw", "ragdoll", "terrain"}) {
    const std::string file = base_name() + "_valid.gltf";
    assert_int_equal(command_test::run_carom(std::string("export ") + name + " " + file).code, 0);
    assert_int_equal(std::system(("gltf_validator -o " + file + " >/dev/null 2>&1").c_str()), 0);
    std::remove(file.c_str());
  }
}

int main(void) {
  const CMUnitTest tests[] = {
      cmocka_unit_test(a_lock_at_an_offset_holds_there),
      cmocka_unit_test(a_soft_limit_sinks_by_load_over_stiffness),
      cmocka_unit_test(a_soft_distance_is_a_spring),
      cmocka_unit_test(materials_that_mix_in_another_order_are_named),
      cmocka_unit_test(a_limit_of_no_stiffness_holds_nothing_and_is_named),
      cmocka_unit_test(a_drive_reaches_its_velocity_with_its_force),
      cmocka_unit_test(what_is_negative_has_no_bound_in_omi),
      cmocka_unit_test(moments_are_taken_as_given),
      cmocka_unit_test(infinite_moments),
      cmocka_unit_test(a_mesh_that_moves_is_hollow_where_it_is),
      cmocka_unit_test(omi_bodies_fall_with_their_gravity),
      cmocka_unit_test(omi_meshes_and_earlier_drafts),
      cmocka_unit_test(gravity_of_a_volume_is_a_field_or_named),
      cmocka_unit_test(import_reads_gltf_and_writes_a_scene),
      cmocka_unit_test(what_is_written_is_valid),
  };
  return cmocka_run_group_tests_name("tools/conformance", tests, nullptr, nullptr);
}
