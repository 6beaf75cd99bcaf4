// A stage as a scene file: what visual/ draws, with physics hung on its nodes.
#include <nlohmann/json.hpp>

#include "scenefile/attributes.h"
#include "scenefile/axes.h"
#include "scenefile/scenefile.h"
#include "visual/gltf.h"

namespace carom::tools {
namespace {

using nlohmann::json;

json numbers(const double* x, int n) { return json(std::vector<double>(x, x + n)); }
json numbers(const Vec& x) { return numbers(x.data(), 3); }
json numbers(const Quat& q) { return numbers(q.coeffs().data(), 4); }

/// 64 bits, which JSON numbers do not hold in every reader.
json hex(std::uint64_t bits) {
  char text[24];
  std::snprintf(text, sizeof text, "0x%llx", static_cast<unsigned long long>(bits));
  return text;
}

class PhysicsWriter {
 public:
  PhysicsWriter(Stage& stage, GltfDrawing& drawing) : stage_(stage), drawing_(drawing), doc_(drawing.document) {}

  void write(double seconds, double dt) {
    const bool moved = stage_.world.report().steps > 0;
    for (std::size_t a = 0; a < stage_.actors.size(); ++a) write_actor(a, moved);
    write_joints();
    write_world(seconds, dt);
    json& extensions = doc_["extensions"];
    extensions["KHR_implicit_shapes"]["shapes"] = std::move(khr_shapes_);
    json& khr = extensions["KHR_physics_rigid_bodies"];
    khr = json::object();
    if (!materials_.empty()) khr["physicsMaterials"] = std::move(materials_);
    if (!joints_.empty()) khr["physicsJoints"] = std::move(joints_);
    if (khr.empty()) extensions.erase("KHR_physics_rigid_bodies");
    if (extensions["KHR_implicit_shapes"]["shapes"].empty()) extensions.erase("KHR_implicit_shapes");
    if (!shapes_.empty()) own_["shapes"] = std::move(shapes_);
    extensions["CAROM_physics"] = std::move(own_);
    doc_["extensionsUsed"] = {"KHR_implicit_shapes", "KHR_physics_rigid_bodies", "CAROM_physics"};
  }

 private:
  std::size_t new_node(json node, std::size_t parent) {
    json& nodes = doc_["nodes"];
    nodes.push_back(std::move(node));
    const std::size_t id = nodes.size() - 1;
    (parent == GltfDrawing::kNone ? doc_["scenes"][0]["nodes"] : nodes[parent]["children"]).push_back(id);
    return id;
  }
  json& node(std::size_t id) { return doc_["nodes"][id]; }

  void write_actor(std::size_t a, bool moved) {
    const Actor& actor = stage_.actors[a];
    std::size_t id = drawing_.node[a];
    if (id == GltfDrawing::kNone) id = drawing_.node[a] = new_node({{"name", actor.name}}, GltfDrawing::kNone);
    const Vec position = moved ? stage_.position(a) : actor.position;
    const Quat orientation = moved ? stage_.orientation(a) : actor.orientation;
    node(id)["translation"] = numbers(position);
    node(id)["rotation"] = numbers(orientation);
    json own = {{"kind", actor.kind}, {"index", a}};
    if (actor.particles != CAROM_NULL_HANDLE) {
      if (actor.index == 0) ++sets_;
      own["particle"] = sets_ - 1;
      own["mass"] = actor.mass;
      own["linearVelocity"] = numbers(moved ? stage_.velocity(a) : actor.linear_velocity);
      node(id)["extensions"]["CAROM_physics"] = std::move(own);
      return;
    }
    carom_body_desc now;
    Call call;
    carom_body_desc_init(&now, sizeof now);
    call.done(carom_body_get(stage_.world.get(), actor.body, &now, call), "reading '" + actor.name + "'");
    if (!moved) {
      std::copy(actor.linear_velocity.data(), actor.linear_velocity.data() + 3, now.linear_velocity);
      std::copy(actor.angular_velocity.data(), actor.angular_velocity.data() + 3, now.angular_velocity);
    }
    write_body(id, actor, now, orientation, own);
    for (std::size_t p = 0; p < actor.parts.size(); ++p) write_part(a, p, id);
    node(id)["extensions"]["CAROM_physics"] = std::move(own);
  }

  void write_body(std::size_t id, const Actor& actor, const carom_body_desc& now, const Quat& orientation, json& own) {
    static constexpr const char* kTypes[] = {"static", "kinematic", "dynamic"};
    carom_world* const world = stage_.world.get();
    own["body"] = kTypes[actor.type];
    if (actor.type == CAROM_BODY_STATIC) return;
    Call call;
    const Vec v(now.linear_velocity), w(now.angular_velocity);
    json motion = json::object();
    if (actor.type == CAROM_BODY_KINEMATIC) motion["isKinematic"] = true;
    if (!v.isZero(0))
      motion["linearVelocity"] = numbers(Vec(orientation.conjugate() * v)), own["linearVelocity"] = numbers(v);
    if (!w.isZero(0))
      motion["angularVelocity"] = numbers(Vec(orientation.conjugate() * w)), own["angularVelocity"] = numbers(w);
    if (actor.type == CAROM_BODY_DYNAMIC) {
      motion["mass"] = now.mass;
      if (actor.mass > 0) own["mass"] = actor.mass;
      if (actor.center) motion["centerOfMass"] = own["center"] = numbers(*actor.center);
      if (actor.inertia) own["inertia"] = numbers(actor.inertia->data(), 9);  // symmetric
      if (actor.linear_damping > 0 || actor.angular_damping > 0)
        own["damping"] = {actor.linear_damping, actor.angular_damping};
      json attributes = scenefile::attributes_of(world, actor.body);
      if (attributes.contains("gravity_factor")) motion["gravityFactor"] = attributes["gravity_factor"];
      if (!attributes.empty()) own["attributes"] = std::move(attributes);
    }
    std::uint32_t continuous = CAROM_CONTINUOUS_AUTO;
    call.done(carom_body_get_continuous(world, actor.body, &continuous, call), "reading a body");
    if (continuous != CAROM_CONTINUOUS_AUTO) own["continuous"] = continuous;
    node(id)["extensions"]["KHR_physics_rigid_bodies"]["motion"] = std::move(motion);
  }

  /// Index of a KHR shape that says exactly what a part is, or kNone.
  std::size_t khr_shape(const Part& part) {
    const std::vector<double>& p = part.params;
    json shape;
    if (part.shape == "sphere")
      shape = {{"type", "sphere"}, {"sphere", {{"radius", p[0]}}}};
    else if (part.shape == "box")
      shape = {{"type", "box"}, {"box", {{"size", {2 * p[0], 2 * p[1], 2 * p[2]}}}}};
    else if (part.shape == "tapered_capsule")
      shape = {{"type", "capsule"}, {"capsule", {{"height", 2 * p[2]}, {"radiusBottom", p[0]}, {"radiusTop", p[1]}}}};
    else if (part.shape == "capsule" && p[1] > 0)
      shape = {{"type", "capsule"}, {"capsule", {{"height", 2 * p[1]}, {"radiusBottom", p[0]}, {"radiusTop", p[0]}}}};
    else if (part.shape == "cylinder" || part.shape == "cone")
      shape = {{"type", "cylinder"},
               {"cylinder",
                {{"height", 2 * p[1]}, {"radiusBottom", p[0]}, {"radiusTop", part.shape == "cone" ? 0.0 : p[0]}}}};
    else
      return GltfDrawing::kNone;
    return entry(khr_shapes_, std::move(shape));
  }

  /// Index of an entry, which is added if it is new.
  std::size_t entry(json& list, json what) {
    const auto [at, fresh] = known_.try_emplace({&list, what.dump()}, list.size());
    if (fresh) list.push_back(std::move(what));
    return at->second;
  }

  /// Index of a shape of CAROM_physics: any plugin's, or a hull of others, which stand before it.
  std::size_t own_shape(const std::string& name, const std::vector<double>& params) {
    if (name != "hull_of") return entry(shapes_, {{"plugin", name}, {"params", params}});
    const HullOf& hull = stage_.engine().hull_of(params);
    json parts = json::array();
    for (const HullPart& part : hull.parts) {
      json to = {{"shape", own_shape(part.shape, part.params)}};
      if (part.position != HullPart().position) to["position"] = part.position;
      if (part.orientation != HullPart().orientation) to["orientation"] = part.orientation;
      if (part.scale != HullPart().scale) to["scale"] = part.scale;
      parts.push_back(std::move(to));
    }
    return entry(shapes_, {{"parts", std::move(parts)}, {"radius", hull.radius}});
  }

  void write_part(std::size_t a, std::size_t p, std::size_t body) {
    const Actor& actor = stage_.actors[a];
    const Part& part = actor.parts[p];
    std::size_t id = p < drawing_.part_node[a].size() ? drawing_.part_node[a][p] : GltfDrawing::kNone;
    const bool alone =
        actor.parts.size() == 1 && part.position.isZero(0) && part.orientation.coeffs() == Quat::Identity().coeffs();
    json own = {{"density", part.density}}, collider = json::object();
    if (part.shape == "half_space") {
      const Vec normal(part.params[0], part.params[1], part.params[2]);
      const Quat turn = part.orientation * turn_between(Vec::UnitY(), normal);
      id = new_node({{"translation", numbers(Vec(part.position + part.orientation * (part.params[3] * normal)))},
                     {"rotation", numbers(turn)}},
                    body);
      own["position"] = numbers(part.position), own["orientation"] = numbers(part.orientation);
      collider["geometry"]["shape"] = entry(khr_shapes_, {{"type", "plane"}, {"plane", json::object()}});
    } else {
      if (id == GltfDrawing::kNone) id = alone ? body : new_node(json::object(), body);
      if (id != body)
        node(id)["translation"] = numbers(part.position), node(id)["rotation"] = numbers(part.orientation);
      if (id == body && !alone)
        own["position"] = numbers(part.position), own["orientation"] = numbers(part.orientation);
    }
    if (const std::size_t shape = part.is_ground() ? GltfDrawing::kNone : khr_shape(part);
        shape != GltfDrawing::kNone) {
      collider["geometry"]["shape"] = shape;
    } else {
      own["shape"] = own_shape(part.shape, part.params);
      if (part.shape != "half_space") {
        collider["geometry"]["node"] = id;
        if (!part.is_ground()) collider["geometry"]["convexHull"] = true;
      }
    }
    write_surface(part, collider, own);
    const bool sensor = is_sensor(part.collider);
    if (sensor) collider.erase("physicsMaterial");
    collider["extensions"]["CAROM_physics"] = std::move(own);
    node(id)["extensions"]["KHR_physics_rigid_bodies"][sensor ? "trigger" : "collider"] = std::move(collider);
  }

  bool is_sensor(carom_collider collider) {
    std::uint32_t sensor = 0;
    Call call;
    call.done(carom_collider_is_sensor(stage_.world.get(), collider, &sensor, call), "reading a collider");
    return sensor != 0;
  }

  void write_surface(const Part& part, json& collider, json& own) {
    json material = {
        {"staticFriction", part.friction}, {"dynamicFriction", part.friction}, {"restitution", part.restitution}};
    static constexpr const char* kMixes[] = {nullptr, "maximum", "minimum", "average", "multiply"};
    if (kMixes[part.friction_mix]) material["frictionCombine"] = kMixes[part.friction_mix];
    if (kMixes[part.restitution_mix]) material["restitutionCombine"] = kMixes[part.restitution_mix];
    json extra = {{"frictionMix", part.friction_mix}, {"restitutionMix", part.restitution_mix}};
    if (part.rolling > 0) extra["rolling"] = part.rolling;
    if (part.spinning > 0) extra["spinning"] = part.spinning;
    material["extensions"]["CAROM_physics"] = std::move(extra);
    collider["physicsMaterial"] = entry(materials_, std::move(material));
    if (!part.surface_velocity.isZero(0)) own["surfaceVelocity"] = numbers(part.surface_velocity);
    if (!part.surface_spin.isZero(0)) own["surfaceSpin"] = numbers(part.surface_spin);
    std::uint64_t category = 0, mask = 0;
    std::int32_t group = 0;
    Call call;
    call.done(carom_collider_get_filter(stage_.world.get(), part.collider, &category, &mask, &group, call),
              "reading a filter");
    if (category != default_category() || mask != ~std::uint64_t(0) || group != 0)
      own["filter"] = {{"category", hex(category)}, {"mask", hex(mask)}, {"group", group}};
  }
  static std::uint64_t default_category() { return 1; }

  std::size_t node_of(carom_body body) {
    if (body != CAROM_NULL_HANDLE)
      for (std::size_t a = 0; a < stage_.actors.size(); ++a)
        if (stage_.actors[a].body == body) return drawing_.node[a];
    return GltfDrawing::kNone;
  }

  void write_joints() {
    carom_world* const world = stage_.world.get();
    Call call;
    std::uint64_t count = 0;
    call.done(carom_world_get_joints(world, nullptr, 0, &count, call), "counting joints");
    std::vector<carom_joint> handles(count);
    call.done(carom_world_get_joints(world, handles.data(), count, &count, call), "listing joints");
    for (const carom_joint joint : handles) {
      carom_joint_desc d;
      carom_joint_desc_init(&d, sizeof d);
      call.done(carom_joint_get(world, joint, &d, call), "reading a joint");
      const auto frame = [&](const double* position, const double* orientation, carom_body body) {
        return new_node({{"translation", numbers(position, 3)}, {"rotation", numbers(orientation, 4)}}, node_of(body));
      };
      const std::size_t on_a = frame(d.position_a, d.orientation_a, d.body_a);
      const std::size_t on_b = frame(d.position_b, d.orientation_b, d.body_b);
      json entry = {{"connectedNode", on_b}, {"joint", joints_.size()}};
      if (d.fields & CAROM_JOINT_COLLIDE) entry["enableCollision"] = true;
      node(on_a)["extensions"]["KHR_physics_rigid_bodies"]["joint"] = std::move(entry);
      joints_.push_back(scenefile::joint_json(stage_.world.get(), joint, d, handles));
    }
  }

  void write_world(double seconds, double dt) {
    carom_world* const world = stage_.world.get();
    Call call;
    double x[3];
    call.done(carom_world_get_gravity(world, x, call), "reading gravity");
    own_["gravity"] = numbers(x, 3);
    own_["seconds"] = seconds, own_["dt"] = dt;
    for (const carom_dial_info& dial : all_dials()) {
      std::uint32_t index = 0;
      call.done(carom_dial_find(dial.name, &index, call), "finding a dial");
      const double value = stage_.world.dial(index);
      if (value == dial.initial) continue;
      if (dial.choice_count > 0)
        own_["dials"][dial.name] = dial.choices[static_cast<std::size_t>(value)];
      else
        own_["dials"][dial.name] = value;
    }
    for (std::uint32_t e = 0; e < CAROM_EFFECT_COUNT; ++e) {
      std::uint32_t mode = 0;
      call.done(carom_world_get_effect(world, e, &mode, call), "reading an effect");
      if (mode != CAROM_MODE_AS_NEEDED)
        own_["effects"][carom_effect_name(e)] = mode == CAROM_MODE_FORBID ? "forbid" : "force";
    }
    call.done(carom_world_get_wind(world, x, call), "reading the wind");
    if (x[0] != 0 || x[1] != 0 || x[2] != 0) own_["wind"] = numbers(x, 3);
    write_water();
    for (const carom_force_field field : stage_.fields) write_field(field);
    for (const Bungee& bungee : stage_.bungees) write_spring(bungee);
    own_["camera"] = {{"from", numbers(stage_.camera_from)}, {"to", numbers(stage_.camera_to)}};
    own_["floor"] = stage_.ground_half_width;
    own_["bounds"] = {numbers(stage_.bounds_min), numbers(stage_.bounds_max)};
  }

  void write_water() {
    carom_water water;
    std::uint32_t present = 0;
    Call call;
    carom_water_init(&water, sizeof water);
    call.done(carom_world_get_water(stage_.world.get(), &water, &present, call), "reading the water");
    if (present)
      own_["water"] = {{"normal", numbers(water.normal, 3)},
                       {"level", water.level},
                       {"density", water.density},
                       {"current", numbers(water.current, 3)},
                       {"drag", water.drag}};
  }

  void write_field(carom_force_field handle) {
    carom_force_field_desc f;
    Call call;
    carom_force_field_desc_init(&f, sizeof f);
    call.done(carom_force_field_get(stage_.world.get(), handle, &f, call), "reading a field");
    json field = {{"kind", carom_force_field_name(f.kind)},
                  {"isForce", f.is_force != 0},
                  {"mask", f.mask},
                  {"position", numbers(f.position, 3)},
                  {"orientation", numbers(f.orientation, 4)},
                  {"vector", numbers(f.vector, 3)},
                  {"strength", f.strength},
                  {"pull", f.pull},
                  {"lift", f.lift},
                  {"reference", f.reference},
                  {"core", f.core},
                  {"falloff", f.falloff}};
    json half = json::array();  // JSON has no infinity: null
    for (const double h : f.half) half.push_back(std::isfinite(h) ? json(h) : json());
    field["half"] = std::move(half);
    if (std::isfinite(f.reach)) field["reach"] = f.reach;
    own_["fields"].push_back(std::move(field));
  }

  void write_spring(const Bungee& bungee) {
    carom_spring_desc s;
    Call call;
    carom_spring_desc_init(&s, sizeof s);
    call.done(carom_spring_get(stage_.world.get(), bungee.spring, &s, call), "reading a spring");
    json spring = {{"anchorA", numbers(s.anchor_a, 3)},
                   {"anchorB", numbers(s.anchor_b, 3)},
                   {"rest", s.rest},
                   {"stiffness", s.stiffness},
                   {"damping", s.damping},
                   {"onlyPulls", s.only_pulls != 0}};
    if (s.body_a != CAROM_NULL_HANDLE) spring["nodeA"] = node_of(s.body_a);
    if (s.body_b != CAROM_NULL_HANDLE) spring["nodeB"] = node_of(s.body_b);
    own_["springs"].push_back(std::move(spring));
  }

  Stage& stage_;
  GltfDrawing& drawing_;
  json& doc_;
  json khr_shapes_ = json::array(), materials_ = json::array(), joints_ = json::array(), shapes_ = json::array();
  json own_ = json::object();
  std::map<std::pair<const json*, std::string>, std::size_t> known_;
  std::size_t sets_ = 0;
};

}  // namespace

void write_scene(const std::string& path, Stage& stage, double seconds, double dt) {
  check_gltf_path(path);
  const Recording still(stage, dt, 1 / dt);
  GltfDrawing drawing = draw_gltf(stage, still);
  PhysicsWriter(stage, drawing).write(seconds, dt);
  save_gltf(path, std::move(drawing));
}

}  // namespace carom::tools
