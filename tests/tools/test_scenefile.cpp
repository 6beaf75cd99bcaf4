// Scene files: what is written is read back to the bit; what other tools write is read as they mean it; what is wrong
// is refused with its place in the file.
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>

#include "attributes.h"
#include "carom_test.h"
#include "scenefile/scenefile.h"
#include "scenes/run.h"

using namespace carom::tools;
using nlohmann::json;

namespace {

template <class... A>
void wrong_with(const char* form, A... values) {
  print_error(form, values...);
  print_error("\n");
  assert_true(false);
}

struct File {
  explicit File(const char* ending) : path("/tmp/carom_scene_" + std::to_string(getpid()) + ending) {}
  File(const json& document, const char* ending = ".gltf") : File(ending) { std::ofstream(path) << document.dump(); }
  ~File() { std::remove(path.c_str()); }
  std::string path;
};

std::uint64_t bits_after(Stage& stage, double seconds, double dt) { return simulate(stage, nullptr, seconds, dt).hash; }

/// A document of nodes, with what belongs into the two KHR extensions.
json scene(json nodes, json shapes = json::array(), json physics = json::object()) {
  json roots = json::array();
  std::vector<bool> is_child(nodes.size(), false);
  for (const json& node : nodes)
    for (const json& child : node.value("children", json::array())) is_child[child.get<std::size_t>()] = true;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (!is_child[i]) roots.push_back(i);
  return {{"asset", {{"version", "2.0"}}},
          {"scene", 0},
          {"scenes", {{{"nodes", roots}}}},
          {"nodes", nodes},
          {"extensions", {{"KHR_implicit_shapes", {{"shapes", shapes}}}, {"KHR_physics_rigid_bodies", physics}}}};
}
// A list of one element is an array for gcc and that element for clang (CWG 2311): below such arrays are called arrays.
json physics(json what) { return {{"KHR_physics_rigid_bodies", std::move(what)}}; }
json with_shape(int shape) { return {{"geometry", {{"shape", shape}}}}; }

json sphere(double r) { return {{"type", "sphere"}, {"sphere", {{"radius", r}}}}; }
json box(double x, double y, double z) { return {{"type", "box"}, {"box", {{"size", {x, y, z}}}}}; }

struct Read {
  explicit Read(const json& document) : file(document), engine(PluginPath({CAROM_PLUGIN_DIR})), stage(engine) {
    read_scene(file.path, stage);
  }
  const Actor& actor(const std::string& name) const {
    for (const Actor& a : stage.actors)
      if (a.name == name) return a;
    wrong_with("no actor %s", name.c_str());
    return stage.actors[0];
  }
  carom_body_desc body(const std::string& name) {
    carom_body_desc d;
    carom_body_desc_init(&d, sizeof d);
    assert_int_equal(carom_body_get(stage.world.get(), actor(name).body, &d, nullptr), CAROM_OK);
    return d;
  }
  File file;
  Engine engine;
  Stage stage;
};

bool near(double a, double b, double most = 1e-12) { return std::fabs(a - b) <= most; }

}  // namespace

static void scenes_that_are_written_and_read_step_the_same_bits(void**) {
  for (const char* name :
       {"seesaw", "falling", "net", "conveyor", "terrain", "quoits", "ragdoll", "weather", "bullet"}) {
    const Scene& given = find_scene(name);
    Engine engine(PluginPath({CAROM_PLUGIN_DIR}));
    Stage stage(engine);
    Settings settings;
    for (const Knob& knob : given.knobs)
      if (knob.name == "n") settings.values = {{"n", std::string(name) == "net" ? 8 : std::min(knob.initial, 40.0)}};
    build(given, settings, stage);
    const File file(std::string(name) == "terrain" ? ".glb" : ".gltf");
    write_scene(file.path, stage, given.seconds, given.dt);
    const Scene read = scene_of_file(file.path);
    assert_true(read.seconds == given.seconds && read.dt == given.dt);
    Engine other(PluginPath({CAROM_PLUGIN_DIR}));
    Stage again(other);
    build(read, {{}, file.path}, again);
    assert_int_equal(again.actors.size(), stage.actors.size());
    for (std::size_t a = 0; a < stage.actors.size(); ++a) assert_true(again.actors[a].kind == stage.actors[a].kind);
    const double seconds = 20 * given.dt;
    if (bits_after(stage, seconds, given.dt) != bits_after(again, seconds, given.dt))
      wrong_with("%s: other bits", name);
  }
}

static void dials_and_effects_travel_too(void**) {
  Engine engine(PluginPath({CAROM_PLUGIN_DIR}));
  Stage stage(engine), again(engine);
  build(find_scene("falling"), {{{"n", 8}}, ""}, stage);
  stage.world.set_dial("solver=direct"), stage.world.set_dial("substeps=7");
  stage.world.set_effect("friction", CAROM_MODE_FORBID);
  const File file(".gltf");
  write_scene(file.path, stage, 1, 0.01);
  read_scene(file.path, again);
  for (const carom_dial_info& dial : all_dials()) {
    std::uint32_t index = 0;
    assert_int_equal(carom_dial_find(dial.name, &index, nullptr), CAROM_OK);
    assert_true(stage.world.dial(index) == again.world.dial(index));
  }
  assert_true(bits_after(stage, 1, 0.01) == bits_after(again, 1, 0.01));
}

/// None is named here: one that a scene file forgets fails this.
static void every_attribute_of_a_body_travels_too(void**) {
  Engine engine(PluginPath({CAROM_PLUGIN_DIR}));
  Stage stage(engine), again(engine);
  build(find_scene("falling"), {{{"n", 8}}, ""}, stage);
  const auto value_of = [](Stage& s, std::uint32_t attribute, std::size_t actor) {
    std::array<double, CAROM_ATTRIBUTE_NUMBERS> value{};
    Call call;
    call.done(carom_body_get_attribute(s.world.get(), s.actors[actor].body, attribute, value.data(), call), "reading");
    return value;
  };
  Call call;
  std::vector<std::size_t> falls;
  for (std::size_t a = 0; a < stage.actors.size(); ++a)
    if (stage.actors[a].type == CAROM_BODY_DYNAMIC) falls.push_back(a);
  for (std::uint32_t k = 0; k < CAROM_ATTRIBUTE_COUNT; ++k)  // each on a body of its own, and all on one
    for (const std::size_t actor : {falls[0], falls.at(1 + k % 6)})
      call.done(carom_body_set_attribute(stage.world.get(), stage.actors[actor].body, k,
                                         unusual_value(attribute_info(k)).data(), call),
                "setting");
  const File file(".gltf");
  write_scene(file.path, stage, 1, 0.01);
  read_scene(file.path, again);
  for (std::size_t actor = 0; actor < stage.actors.size(); ++actor)
    for (std::uint32_t k = 0; k < CAROM_ATTRIBUTE_COUNT; ++k)
      assert_true(value_of(stage, k, actor) == value_of(again, k, actor));
  assert_true(value_of(again, 0, falls[0]) == unusual_value(attribute_info(0)));
}

/// How many joints of a kind a stage has.
static std::size_t joints_of(Stage& stage, std::uint32_t kind) {
  std::uint64_t count = 0;
  assert_int_equal(carom_world_get_joints(stage.world.get(), nullptr, 0, &count, nullptr), CAROM_OK);
  std::vector<carom_joint> joints(count);
  assert_int_equal(carom_world_get_joints(stage.world.get(), joints.data(), count, &count, nullptr), CAROM_OK);
  return static_cast<std::size_t>(std::count_if(joints.begin(), joints.end(), [&](carom_joint joint) {
    carom_joint_desc d;
    carom_joint_desc_init(&d, sizeof d);
    assert_int_equal(carom_joint_get(stage.world.get(), joint, &d, nullptr), CAROM_OK);
    return d.kind == kind;
  }));
}

/// Two bodies on a rope that may be slack, two on one that is not strung, and two wheels that mesh.
static void pulleys_and_gears_travel_too(void**) {
  Engine engine(PluginPath({CAROM_PLUGIN_DIR}));
  Stage stage(engine), again(engine);
  build(find_scene("falling"), {{{"n", 8}}, ""}, stage);
  std::vector<carom_body> falls;
  for (const Actor& actor : stage.actors)
    if (actor.type == CAROM_BODY_DYNAMIC) falls.push_back(actor.body);
  carom_world* const world = stage.world.get();
  Call call;
  const auto join = [&](std::uint32_t kind, carom_body a, carom_body b, bool in_world) {
    carom_joint_desc d;
    carom_joint_desc_init(&d, sizeof d);
    d.kind = kind, d.body_a = a, d.body_b = b;
    if (in_world) {
      d.fields = CAROM_JOINT_WORLD_FRAME;
      call.done(carom_body_get_pose(world, b, d.position_a, nullptr, call), "a place");
    }
    return stage.join(d, "a test");
  };
  const auto drive = [&](carom_joint joint, double ratio, const Vec& a, const Vec& b) {
    carom_joint_transmission t;
    carom_joint_transmission_init(&t, sizeof t);
    t.ratio = ratio;
    std::copy(a.data(), a.data() + 3, t.anchor_a), std::copy(b.data(), b.data() + 3, t.anchor_b);
    call.done(carom_joint_set_transmission(world, joint, &t, call), "a transmission");
  };
  const carom_joint rope = join(CAROM_JOINT_PULLEY, falls[0], falls[1], false);
  drive(rope, 2.5, Vec(0.1, 9, 1. / 3), Vec(-1, 8.7, 0));
  carom_joint_limit slack;
  carom_joint_limit_init(&slack, sizeof slack);
  slack.enabled = 1, slack.upper = 30;
  call.done(carom_joint_set_limit(world, rope, CAROM_COORDINATE_DISTANCE, &slack, call), "a limit");
  join(CAROM_JOINT_PULLEY, falls[2], falls[3], false);
  for (const carom_body wheel : {falls[4], falls[5]}) {
    const carom_joint axle = join(CAROM_JOINT_HINGE, CAROM_NULL_HANDLE, wheel, true);
    carom_joint_axis axis;
    carom_joint_axis_init(&axis, sizeof axis);
    axis.friction = 0.01, axis.armature = 0.1, axis.effort_limit = 5, axis.speed_limit = wheel == falls[4] ? 3.5 : 7;
    call.done(carom_joint_set_axis(world, axle, CAROM_AXIS_TURN_X, &axis, call), "an axis");
  }
  drive(join(CAROM_JOINT_GEAR, falls[4], falls[5], false), -3, Vec::Zero(), Vec::Zero());
  carom_joint_coupling coupling;
  carom_joint_coupling_init(&coupling, sizeof coupling);
  coupling.follower = join(CAROM_JOINT_HINGE, CAROM_NULL_HANDLE, falls[6], true);
  coupling.leader = join(CAROM_JOINT_SLIDER, CAROM_NULL_HANDLE, falls[7], true);
  coupling.polynomial[0] = 0.1, coupling.polynomial[1] = -2, coupling.polynomial[4] = 1. / 3;
  carom_joint coupled;
  call.done(carom_joint_couple(world, &coupling, &coupled, call), "a coupling");
  const double spin[3] = {4, 0, 0}, still[3] = {0, 0, 0};
  call.done(carom_body_set_velocity(world, falls[4], still, spin, call), "a spin");
  for (Actor& actor : stage.actors)
    if (actor.body == falls[4]) actor.angular_velocity = Vec(spin);
  const File file(".gltf");
  write_scene(file.path, stage, 1, 0.01);
  read_scene(file.path, again);
  assert_int_equal(joints_of(again, CAROM_JOINT_PULLEY), 2);
  assert_int_equal(joints_of(again, CAROM_JOINT_GEAR), 1);
  assert_int_equal(joints_of(again, CAROM_JOINT_COUPLING), 1);
  assert_true(bits_after(stage, 1, 0.01) == bits_after(again, 1, 0.01));
}

/// Hulls of shapes, one within another, stand in the document as parts; a tapered capsule is the extension's own.
static void hulls_of_shapes_travel_too(void**) {
  Engine engine(PluginPath({CAROM_PLUGIN_DIR})), other(PluginPath({CAROM_PLUGIN_DIR}));
  Stage stage(engine), again(other);
  const HullPart ball{"sphere", {0.3}, {0, 0.5, 0}, {0, 0, 0, 1}, {1, 1, 1}};
  const HullPart crate{"box", {0.5, 0.25, 0.4}, {0, -0.25, 0}, {0, 0.6, 0, 0.8}, {1, -0.5, 1}};
  const std::vector<double> bell = engine.add({{ball, crate}, 0.05});
  const HullPart whole{"hull_of", bell, {0, 0, 0}, {0, 0, 0, 1}, {1, 1, 1}},
      capsule{"tapered_capsule", {0.2, 0.1, 0.3}, {1, 0, 0}, {0, 0, 0, 1}, {1, 1, 1}};
  assert_true(engine.add({{ball, crate}, 0.05}) == bell);
  const std::vector<std::pair<std::string, std::vector<double>>> shapes = {
      {"hull_of", bell},
      {"hull_of", engine.add({{whole, capsule}, 0})},
      {"hull_of", engine.add({{crate, crate}, 0})},
      {"tapered_capsule", {0.5, 0.2, 0.75}}};
  Part ground;
  ground.shape = "half_space", ground.params = {0, 1, 0, 0};
  Actor floor;
  floor.name = "floor", floor.kind = "ground", floor.type = CAROM_BODY_STATIC, floor.parts = {ground};
  stage.add(floor);
  for (std::size_t i = 0; i < 2 * shapes.size(); ++i) {
    Part part;
    part.shape = shapes[i % shapes.size()].first, part.params = shapes[i % shapes.size()].second;
    Actor actor;
    actor.name = "body " + std::to_string(i), actor.kind = "body",
    actor.position = Vec(0.7 * double(i % 3), 1.5 + double(i), 0);
    actor.parts = {part};
    stage.add(actor);
  }
  const File file(".gltf");
  write_scene(file.path, stage, 1, 0.01);
  const json document = json::parse(std::ifstream(file.path));
  assert_true(document.dump().find("\"parts\"") != std::string::npos);
  read_scene(file.path, again);
  assert_true(again.actors[4].parts[0].shape == "tapered_capsule");
  assert_true(other.hull_of(again.actors[2].parts[0].params).parts[0].shape == "hull_of");
  assert_true(bits_after(stage, 1, 0.01) == bits_after(again, 1, 0.01));
}

static void hulls_that_are_none_are_refused(void**) {
  json nodes = {{{"name", "ball"}, {"extensions", physics({{"collider", json::object()}})}}};
  nodes[0]["extensions"]["KHR_physics_rigid_bodies"]["collider"]["extensions"]["CAROM_physics"]["shape"] = 0;
  const auto with = [&](json shapes) {
    json document = scene(nodes);
    document["extensions"]["CAROM_physics"]["shapes"] = std::move(shapes);
    return document;
  };
  const json ball = {{"plugin", "sphere"}, {"params", json::array({1})}};
  const auto hull = [](json part) {
    json parts = json::array();
    parts.push_back(std::move(part));
    return json{{"parts", std::move(parts)}};
  };
  const auto list = [](json a, json b) {
    json both = json::array();
    both.push_back(std::move(a)), both.push_back(std::move(b));
    return both;
  };
  { Read fine(with(list(hull({{"shape", 1}}), ball))); }
  const std::pair<json, const char*> wrongs[] = {
      {list(hull({{"shape", 0}}), ball), "too deep"},  // its own part
      {list(hull({{"shape", 2}}), ball), "there are 2 shapes"},
      {list(hull({{"shape", 1}, {"scale", {1, 0, 1}}}), ball), "scale"},
      {list(hull({{"shape", 1}}), {{"plugin", "half_space"}, {"params", {0, 1, 0, 0}}}), "half_space"},
      {list({{"parts", json::array()}}, ball), "/parts is empty"},
      {list({{"plugin", "hull_of"}, {"params", json::array({0})}}, ball), "no name of a plugin"}};
  for (const auto& [shapes, says] : wrongs) try {
      Read r(with(shapes));
      wrong_with("%s was read", shapes.dump().c_str());
    } catch (const Error& e) {
      if (!std::strstr(e.what(), says) || e.remedy.empty()) wrong_with("not '%s': '%s'", says, e.what());
    }
}

static void a_scene_can_be_written_in_mid_run(void**) {
  Engine engine(PluginPath({CAROM_PLUGIN_DIR}));
  Stage stage(engine), again(engine);
  build(find_scene("falling"), {{{"n", 8}}, ""}, stage);
  simulate(stage, nullptr, 0.25, 1.0 / 64);
  const File file(".gltf");
  write_scene(file.path, stage, 1, 1.0 / 64);
  read_scene(file.path, again);
  for (std::size_t a = 0; a < stage.actors.size(); ++a) {
    assert_true((stage.position(a) - again.position(a)).norm() < 1e-15 * (1 + stage.position(a).norm()));
    assert_true((stage.velocity(a) - again.velocity(a)).norm() < 1e-14 * (1 + stage.velocity(a).norm()));
  }
}

static void motion_is_read_as_the_extension_says(void**) {
  const double s = std::sqrt(0.5);
  Read r(scene({{{"name", "turned"},
                 {"translation", {1, 2, 3}},
                 {"rotation", {0, 0, s, s}},  // a quarter about z: the node's x is the world's y
                 {"extensions", physics({{"motion",
                                          {{"mass", 3},
                                           {"linearVelocity", {2, 0, 0}},
                                           {"angularVelocity", {0, 5, 0}},
                                           {"centerOfMass", {0.25, 0, 0}},
                                           {"inertiaDiagonal", {1, 2, 3}},
                                           {"inertiaOrientation", {0, 0, s, s}},
                                           {"gravityFactor", 0.5}}},
                                         {"collider", with_shape(0)}})}},
                {{"name", "heavy"},
                 {"translation", {9, 0, 0}},
                 {"extensions", physics({{"motion", {{"mass", 0}}}, {"collider", with_shape(0)}})}},
                {{"name", "moved"},
                 {"translation", {-9, 0, 0}},
                 {"extensions", physics({{"motion", {{"isKinematic", true}, {"linearVelocity", {0, 1, 0}}}}})}}},
               json::array({sphere(0.5)})));
  const carom_body_desc d = r.body("turned");
  assert_true(d.type == CAROM_BODY_DYNAMIC && d.mass == 3);
  assert_true(near(d.linear_velocity[0], 0) && near(d.linear_velocity[1], 2));
  assert_true(near(d.angular_velocity[0], -5) && near(d.angular_velocity[1], 0));
  assert_true(near(d.center[0], 0.25));
  assert_true(near(d.inertia[0], 2) && near(d.inertia[4], 1) &&
              near(d.inertia[8], 3));  // its first axis is the node's y
  double factor = 0;
  assert_int_equal(carom_body_get_gravity_factor(r.stage.world.get(), r.actor("turned").body, &factor, nullptr),
                   CAROM_OK);
  assert_true(factor == 0.5);
  std::uint32_t locks = 0;
  assert_int_equal(carom_body_get_locks(r.stage.world.get(), r.actor("heavy").body, &locks, nullptr), CAROM_OK);
  assert_int_equal(locks, 7);  // infinite mass: nothing moves it along, it may turn
  assert_int_equal(r.body("moved").type, CAROM_BODY_KINEMATIC);
  simulate(r.stage, nullptr, 1, 1.0 / 64);
  assert_true(near(r.stage.position(2).y(), 1, 1e-9));
}

static void colliders_are_where_and_what_their_nodes_say(void**) {
  const json shapes = {
      sphere(0.5),
      box(1, 2, 3),
      {{"type", "capsule"}, {"capsule", {{"height", 2}, {"radiusBottom", 0.25}, {"radiusTop", 0.25}}}},
      {{"type", "cylinder"}, {"cylinder", {{"height", 2}, {"radiusBottom", 0.5}, {"radiusTop", 0}}}},
      {{"type", "cylinder"}, {"cylinder", {{"height", 2}, {"radiusBottom", 0.5}, {"radiusTop", 0.25}}}},
      {{"type", "plane"}}};
  json nodes = {{{"name", "body"}, {"children", {1, 2, 3, 4}}, {"extensions", physics({{"motion", json::object()}})}}};
  for (int k = 0; k < 4; ++k)
    nodes.push_back({{"translation", {3.0 * k, 0, 0}},
                     {"scale", {2, 2, 2}},
                     {"extensions", physics({{"collider", with_shape(k)}})}});
  nodes.push_back({{"name", "flattened"},
                   {"scale", {1, 2, 1}},
                   {"extensions", physics({{"motion", json::object()}, {"collider", with_shape(0)}})}});
  nodes.push_back({{"name", "tub"}, {"extensions", physics({{"collider", with_shape(4)}})}});
  nodes.push_back({{"name", "slope"},
                   {"translation", {0, -2, 0}},
                   {"rotation", {0, 0, 0.6, 0.8}},
                   {"extensions", physics({{"collider", with_shape(5)}})}});
  Read r(scene(nodes, shapes));
  const Actor& body = r.actor("body");
  assert_int_equal(body.parts.size(), 4);  // one body of four
  assert_true(body.parts[0].shape == "sphere" && body.parts[0].params == std::vector<double>{1});
  assert_true(body.parts[1].shape == "box" && body.parts[1].params == (std::vector<double>{1, 2, 3}));
  assert_true(body.parts[2].shape == "capsule" && body.parts[2].params == (std::vector<double>{0.5, 2}));
  assert_true(body.parts[3].shape == "cone" && body.parts[3].params == (std::vector<double>{1, 2}));
  assert_true(body.parts[3].position == Vec(9, 0, 0));
  assert_true(r.actor("flattened").parts[0].shape == "ellipsoid");
  assert_true(r.actor("tub").parts[0].shape == "hull" && r.actor("tub").type == CAROM_BODY_STATIC);
  const Part& slope = r.actor("slope").parts[0];
  assert_true(slope.shape == "half_space");
  const Vec normal(-0.96, 0.28, 0);  // y turned by twice atan(0.6 / 0.8)
  carom_shape_info info = r.engine.info(r.engine.half_space(slope.params.data(), slope.params[3]));
  assert_true(info.is_half_space);
  // In the world it is the plane through the node, whose normal is the node's y.
  const Actor& actor = r.actor("slope");
  const Vec in_world = actor.orientation * Vec(slope.params[0], slope.params[1], slope.params[2]);
  assert_true((in_world - normal).norm() < 1e-12);
  assert_true(near(slope.params[3], 0));
}

static void meshes_are_hulls_or_scenery(void**) {
  Engine engine(PluginPath({CAROM_PLUGIN_DIR}));
  Stage stage(engine);
  Actor cube;
  cube.name = cube.kind = "cube";
  Part part;
  part.shape = "box", part.params = {0.5, 0.5, 0.5};
  cube.parts = {part};
  stage.add(cube);
  const File drawn(".gltf");
  write_scene(drawn.path, stage, 1, 0.01);
  std::ifstream in(drawn.path);
  json document = json::parse(in);
  // The drawn mesh as geometry: convex and moving; as it is and static.
  json& nodes = document["nodes"];
  for (json& node : nodes) node.erase("extensions");
  nodes[0]["extensions"] =
      physics({{"motion", json::object()}, {"collider", {{"geometry", {{"node", 0}, {"convexHull", true}}}}}});
  nodes.push_back({{"name", "floor"},
                   {"translation", {0, -3, 0}},
                   {"scale", {4, 1, 4}},
                   {"extensions", physics({{"collider", {{"geometry", {{"node", 0}}}}}})}});
  document["scenes"][0]["nodes"].push_back(nodes.size() - 1);
  document.erase("extensions");
  Read r(document);
  const Actor& hull = r.actor("cube");
  assert_true(hull.parts[0].shape == "hull" && hull.parts[0].params.size() == 24);
  assert_true(r.actor("floor").parts[0].shape == "mesh");
  simulate(r.stage, nullptr, 3, 1.0 / 60);
  assert_true(near(r.stage.position(0).y(), -2, 2e-3));  // it fell by a metre, on to the mesh's upper side at -2.5
}

static void materials_filters_and_triggers(void**) {
  const json at = {{"collider", {{"geometry", {{"shape", 0}}}, {"physicsMaterial", 0}, {"collisionFilter", 0}}}};
  const auto moving = [](json what) {
    what["motion"] = json::object();
    return what;
  };
  json other = at;
  other["collider"]["collisionFilter"] = 1;
  json trigger = {{"trigger", {{"geometry", {{"shape", 0}}}}}};
  Read r(
      scene({{{"name", "a"}, {"extensions", physics(moving(at))}},
             {{"name", "b"}, {"translation", {0, 0.9, 0}}, {"extensions", physics(moving(at))}},
             {{"name", "c"}, {"translation", {0, 0, 0.9}}, {"extensions", physics(moving(other))}},
             {{"name", "t"}, {"translation", {0.5, 0, 0}}, {"extensions", physics(trigger)}}},
            json::array({sphere(0.5)}),
            {{"physicsMaterials", {{{"dynamicFriction", 0.25}, {"restitution", 0.5}, {"frictionCombine", "minimum"}}}},
             {"collisionFilters",
              {{{"collisionSystems", {"x"}}, {"notCollideWithSystems", {"x"}}}, {{"collisionSystems", {"y"}}}}}}));
  const Part& part = r.actor("a").parts[0];
  assert_true(part.friction == 0.25 && part.restitution == 0.5);
  assert_true(part.friction_mix == CAROM_MIX_MINIMUM && part.restitution_mix == CAROM_MIX_AVERAGE);
  r.stage.world.step(1.0 / 60);
  bool a_c = false;
  for (const carom_contact& c : r.stage.world.contacts()) {
    const auto is = [&](const char* one, const char* two) {
      const carom_body x = r.actor(one).body, y = r.actor(two).body;
      return (c.body_a == x && c.body_b == y) || (c.body_a == y && c.body_b == x);
    };
    assert_false(is("a", "b"));  // x does not collide with x
    assert_false(is("a", "t") || is("b", "t") || is("c", "t"));
    a_c |= is("a", "c");
  }
  assert_true(a_c);
}

static void joints_are_told_by_their_limits(void**) {
  const auto lock = [](const char* what, std::vector<int> axes) { return json{{what, axes}, {"min", 0}, {"max", 0}}; };
  const json all = lock("linearAxes", {0, 1, 2});
  const json joints = {
      {{"limits", {all}}},
      {{"limits",
        {all,
         lock("angularAxes", {0}),
         lock("angularAxes", {1}),
         {{"angularAxes", {2}}, {"min", -0.5}, {"max", 0.75}}}},
       {"drives",
        {{{"type", "angular"},
          {"mode", "acceleration"},
          {"axis", 2},
          {"positionTarget", 0.5},
          {"stiffness", 400},
          {"damping", 20}}}}},
      {{"limits", {all, lock("angularAxes", {0, 1, 2})}}},
      {{"limits",
        {lock("linearAxes", {0, 2}), lock("angularAxes", {0, 1, 2}), {{"linearAxes", {1}}, {"min", -1}, {"max", 2}}}}},
      {{"limits", {{{"linearAxes", {0, 1, 2}}, {"min", 0}, {"max", 1.5}}}}},
      {{"limits", {all, {{"angularAxes", {1, 2}}, {"min", 0}, {"max", 0.5}}}}},
      {{"limits", {{{"linearAxes", {0, 2}}, {"min", 0}, {"max", 1}}}}}};  // a tube: no kind, and no axis
  const std::uint32_t kinds[] = {CAROM_JOINT_BALL,   CAROM_JOINT_HINGE,    CAROM_JOINT_WELD,
                                 CAROM_JOINT_SLIDER, CAROM_JOINT_DISTANCE, CAROM_JOINT_BALL};
  json nodes = json::array();
  for (std::size_t k = 0; k < joints.size(); ++k) {
    const double x = 10.0 * static_cast<double>(k);
    nodes.push_back({{"name", "body " + std::to_string(k)},
                     {"translation", {x, 0, 0}},
                     {"children", {3 * k + 1}},
                     {"extensions", physics({{"motion", json::object()}, {"collider", with_shape(0)}})}});
    nodes.push_back({{"translation", {0, 1, 0}}});
    nodes.push_back({{"translation", {x, 1, 0}},
                     {"extensions", physics({{"joint", {{"connectedNode", 3 * k + 1}, {"joint", k}}}})}});
  }
  Read r(scene(nodes, json::array({box(0.5, 0.5, 0.5)}), json::object({{"physicsJoints", joints}})));
  carom_world* const world = r.stage.world.get();
  std::uint64_t count = 0;
  carom_joint handles[16];
  assert_int_equal(carom_world_get_joints(world, handles, 16, &count, nullptr), CAROM_OK);
  assert_int_equal(count, 6);  // the last is none of ours, and is said to be left out
  bool said = false;
  for (const std::string& remark : r.stage.remarks) said |= remark.find("physicsJoints/6") != std::string::npos;
  assert_true(said);
  for (std::size_t k = 0; k < 6; ++k) {
    carom_joint_desc d;
    carom_joint_desc_init(&d, sizeof d);
    assert_int_equal(carom_joint_get(world, handles[k], &d, nullptr), CAROM_OK);
    assert_int_equal(d.kind, kinds[k]);
    assert_true(d.body_a == CAROM_NULL_HANDLE && d.body_b == r.actor("body " + std::to_string(k)).body);
  }
  const auto limit_of = [&](std::size_t k, std::uint32_t coordinate) {
    carom_joint_limit limit;
    carom_joint_limit_init(&limit, sizeof limit);
    assert_int_equal(carom_joint_get_limit(world, handles[k], coordinate, &limit, nullptr), CAROM_OK);
    assert_true(limit.enabled);
    return std::pair(limit.lower, limit.upper);
  };
  assert_true(limit_of(1, CAROM_COORDINATE_TWIST) == std::pair(-0.5, 0.75));
  assert_true(limit_of(3, CAROM_COORDINATE_SLIDE) == std::pair(-1.0, 2.0));
  assert_true(limit_of(4, CAROM_COORDINATE_DISTANCE) == std::pair(0.0, 1.5));
  assert_true(limit_of(5, CAROM_COORDINATE_SWING) == std::pair(0.0, 0.5));
  carom_joint_spring spring;
  carom_joint_spring_init(&spring, sizeof spring);
  assert_int_equal(carom_joint_get_spring(world, handles[1], CAROM_COORDINATE_TWIST, &spring, nullptr), CAROM_OK);
  assert_true(near(spring.frequency, 20 / (8 * std::atan(1.0))) && near(spring.damping, 0.5) && spring.target == 0.5);
  simulate(r.stage, nullptr, 3, 1.0 / 120);
  for (std::size_t k = 0; k < 4; ++k) {  // each where its joint lets it be, under its own weight
    const Vec at = r.stage.position(k);
    if (k == 3)
      assert_true(near(at.y(), -1, 5e-3) && near(at.x(), 30, 5e-3));  // down to its limit
    else
      assert_true(near((at - Vec(10.0 * static_cast<double>(k), 1, 0)).norm(), 1, 5e-3));
  }
}

/// What no other kind has comes to six-axis joints: part of the axes locked, at offsets, soft limits, drives along several axes and to
/// velocities. Angles and places are those of the file's axes.
static void other_joints_are_told_by_their_axes(void**) {
  const json joints = {
      {{"limits",
        {{{"linearAxes", {0}}, {"min", 0.25}, {"max", 0.25}}, {{"angularAxes", {0, 1, 2}}, {"min", 0}, {"max", 0}}}}},
      {{"limits",
        {{{"linearAxes", {0, 2}}, {"min", 0}, {"max", 0}},
         {{"linearAxes", {1}}, {"min", -0.5}, {"stiffness", 400}, {"damping", 30}},
         {{"angularAxes", {2}}, {"min", -0.5}, {"max", 0.75}}}},
       {"drives",
        {{{"type", "angular"}, {"axis", 1}, {"velocityTarget", 2}, {"damping", 5}, {"maxForce", 7}},
         {{"type", "linear"},
          {"mode", "acceleration"},
          {"axis", 1},
          {"positionTarget", 1},
          {"stiffness", 100},
          {"damping", 8}}}}}};
  json nodes = json::array();
  for (std::size_t k = 0; k < joints.size(); ++k) {
    const double x = 10.0 * static_cast<double>(k);
    nodes.push_back({{"name", "body " + std::to_string(k)},
                     {"translation", {x, 0, 0}},
                     {"extensions", physics({{"motion", json::object()}, {"collider", with_shape(0)}})}});
    nodes.push_back(
        {{"translation", {x, 0, 0}}, {"extensions", physics({{"joint", {{"connectedNode", 2 * k}, {"joint", k}}}})}});
  }
  Read r(scene(nodes, json::array({box(0.5, 0.5, 0.5)}), json::object({{"physicsJoints", joints}})));
  for (const std::string& remark : r.stage.remarks) assert_true(remark.find("left out") == std::string::npos);
  carom_world* const world = r.stage.world.get();
  std::uint64_t count = 0;
  carom_joint handles[4];
  assert_int_equal(carom_world_get_joints(world, handles, 4, &count, nullptr), CAROM_OK);
  assert_int_equal(count, 2);
  const auto axis = [&](std::size_t k, std::uint32_t which) {
    carom_joint_axis d;
    carom_joint_axis_init(&d, sizeof d);
    assert_int_equal(carom_joint_get_axis(world, handles[k], which, &d, nullptr), CAROM_OK);
    return d;
  };
  assert_true(axis(0, CAROM_AXIS_X).mode == CAROM_AXIS_MODE_LOCKED && axis(0, CAROM_AXIS_X).lower == 0.25);
  assert_true(axis(0, CAROM_AXIS_Y).mode == CAROM_AXIS_MODE_FREE &&
              axis(0, CAROM_AXIS_TURN_Z).mode == CAROM_AXIS_MODE_LOCKED);
  const carom_joint_axis soft = axis(1, CAROM_AXIS_Y), turn = axis(1, CAROM_AXIS_TURN_Y),
                         hard = axis(1, CAROM_AXIS_TURN_Z);
  assert_true(soft.lower == -0.5 && soft.upper == 1e9 && soft.stop_stiffness == 400 && soft.stop_damping == 30);
  assert_true(soft.drive == CAROM_DRIVE_POSITION && soft.drive_gains == CAROM_GAINS_ACCELERATION && soft.target == 1);
  assert_true(turn.drive_gains == CAROM_GAINS_FORCE && turn.speed == 2 && turn.drive_damping == 5 &&
              turn.max_force == 7);
  assert_true(hard.lower == -0.5 && hard.upper == 0.75 && hard.stop_stiffness == 0);
  const File file(".gltf");  // and so they are written, and read back to the same bits
  write_scene(file.path, r.stage, 1, 0.01);
  Engine other(PluginPath({CAROM_PLUGIN_DIR}));
  Stage again(other);
  read_scene(file.path, again);
  assert_true(bits_after(r.stage, 0.5, 0.01) == bits_after(again, 0.5, 0.01));
  carom_joint_state s = {};
  s.struct_size = sizeof s;
  assert_int_equal(carom_joint_get_state(world, handles[0], &s, nullptr), CAROM_OK);
  assert_true(near(s.axis[CAROM_AXIS_X], 0.25, 1e-3) && s.axis[CAROM_AXIS_Y] < -1);
}

static void what_is_wrong_is_refused_with_its_place(void**) {
  const json good = scene(
      json::array(
          {{{"name", "ball"}, {"extensions", physics({{"motion", {{"mass", 1}}}, {"collider", with_shape(0)}})}}}),
      json::array({sphere(0.5)}));
  { Read fine(good); }
  const struct {
    const char* where;  // JSON pointer of what is replaced
    json with;
    const char* says;
  } wrongs[] = {
      {"/asset/version", "1.0", "/asset/version is '1.0'"},
      {"/nodes/0/extensions/KHR_physics_rigid_bodies/motion/mass", -1, "/motion/mass is -1"},
      {"/nodes/0/extensions/KHR_physics_rigid_bodies/motion/mass", "heavy", "/motion/mass is a string"},
      {"/nodes/0/extensions/KHR_physics_rigid_bodies/collider/geometry/shape", 7,
       "/collider/geometry/shape is 7, but there are 1 shapes"},
      {"/nodes/0/extensions/KHR_physics_rigid_bodies/collider/geometry/shape", 0.5, "is not an index"},
      {"/extensions/KHR_implicit_shapes/shapes/0/sphere/radius", 0, "/shapes/0/sphere/radius is 0"},
      {"/extensions/KHR_implicit_shapes/shapes/0/type", "torus", "/shapes/0/type is 'torus'"},
      {"/scenes/0/nodes", {0, 0}, "two parents"},
      {"/nodes/0/children", {0}, "among its own children"},
      {"/nodes/0/rotation", {0, 0, 0, 2}, "/nodes/0/rotation is no unit quaternion"},
      {"/nodes/0/translation", {0, 1}, "/nodes/0/translation has 2 elements"},
      {"/nodes/0/translation", {0, nullptr, 0}, "/nodes/0/translation/1 is a null"},
      {"/scene", 3, "/scene is 3"},
      {"/extensions/CAROM_physics", {{"dials", {{"solvr", "direct"}}}}, "/dials/solvr"},
      {"/extensions/CAROM_physics", {{"effects", {{"friction", "off"}}}}, "/effects/friction"},
      {"/extensions/CAROM_physics", {{"springs", {{{"nodeA", 0}}}}}, "lacks 'stiffness'"},
      {"/extensionsRequired", {"KHR_draco_mesh_compression"}, "/extensionsRequired/0"},
  };
  for (const auto& wrong : wrongs) {
    json document = good;
    document[json::json_pointer(wrong.where)] = wrong.with;
    try {
      Read r(document);
      wrong_with("%s = %s was read", wrong.where, wrong.with.dump().c_str());
    } catch (const Error& e) {
      if (!std::strstr(e.what(), wrong.says) || e.remedy.empty()) wrong_with("%s: says '%s'", wrong.where, e.what());
    }
  }
  const File no_json(".gltf");
  std::ofstream(no_json.path) << "{\n\"asset\": oops}";
  Engine engine(PluginPath({CAROM_PLUGIN_DIR}));
  Stage stage(engine);
  try {
    read_scene(no_json.path, stage);
    wrong_with("no JSON was read%s", "");
  } catch (const Error& e) {
    assert_non_null(std::strstr(e.what(), "line 2"));
  }
}

/// Cut and flipped files end as an error or a scene, never otherwise.
static void damaged_files_do_no_harm(void**) {
  Engine engine(PluginPath({CAROM_PLUGIN_DIR}));
  std::string whole;
  {
    Stage stage(engine);
    build(find_scene("quoits"), {}, stage);
    const File file(".glb");
    write_scene(file.path, stage, 1, 0.01);
    std::ifstream in(file.path, std::ios::binary);
    whole.assign(std::istreambuf_iterator<char>(in), {});
  }
  std::uint32_t random = 1;
  const auto next = [&](std::size_t below) { return (random = random * 1664525u + 1013904223u) / 65536u % below; };
  int refused = 0;
  for (int round = 0; round < 60; ++round) {
    std::string damaged = whole;
    if (round % 3 == 0) damaged.resize(next(whole.size()));
    for (std::size_t k = next(4); round % 3 && k < 4; ++k)
      damaged[next(round % 2 ? 4000 : whole.size())] ^= static_cast<char>(1 + next(255));
    const File file(".glb");
    std::ofstream(file.path, std::ios::binary) << damaged;
    Stage stage(engine);
    try {
      read_scene(file.path, stage);
    } catch (const Error& e) {
      assert_true(!e.remedy.empty());
      ++refused;
    }
  }
  assert_true(refused > 20);
}

int main(void) {
  const CMUnitTest tests[] = {
      cmocka_unit_test(scenes_that_are_written_and_read_step_the_same_bits),
      cmocka_unit_test(dials_and_effects_travel_too),
      cmocka_unit_test(every_attribute_of_a_body_travels_too),
      cmocka_unit_test(hulls_of_shapes_travel_too),
      cmocka_unit_test(hulls_that_are_none_are_refused),
      cmocka_unit_test(a_scene_can_be_written_in_mid_run),
      cmocka_unit_test(motion_is_read_as_the_extension_says),
      cmocka_unit_test(colliders_are_where_and_what_their_nodes_say),
      cmocka_unit_test(meshes_are_hulls_or_scenery),
      cmocka_unit_test(materials_filters_and_triggers),
      cmocka_unit_test(joints_are_told_by_their_limits),
      cmocka_unit_test(other_joints_are_told_by_their_axes),
      cmocka_unit_test(pulleys_and_gears_travel_too),
      cmocka_unit_test(what_is_wrong_is_refused_with_its_place),
      cmocka_unit_test(damaged_files_do_no_harm),
  };
  return cmocka_run_group_tests_name("tools/scenefile", tests, nullptr, nullptr);
}
