// The world of a scene file, its nodes, its bodies.
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "scenefile/attributes.h"
#include "scenefile/reader.h"
#include "scenefile/scenefile.h"

namespace carom::tools {
namespace scenefile {
namespace {

constexpr std::size_t kSettled = static_cast<std::size_t>(-2);
constexpr std::size_t kDeepest = 1000;  // nodes below each other: more is a mistake, or meant to exhaust us

void put(double (&out)[3], const Vec& v) { std::copy(v.data(), v.data() + 3, out); }

}  // namespace

Place place_of(const Value& node) {
  Place place;
  if (const auto matrix = node.get("matrix")) {
    const std::vector<double> m = matrix->numbers(16);
    Eigen::Matrix3d axes;
    for (int c = 0; c < 3; ++c)
      for (int r = 0; r < 3; ++r) axes(r, c) = m[static_cast<std::size_t>(4 * c + r)];
    if (m[3] != 0 || m[7] != 0 || m[11] != 0 || m[15] != 1)
      matrix->fail("is projective", "write a matrix whose last row is 0, 0, 0, 1");
    place.p = Vec(m[12], m[13], m[14]);
    for (int c = 0; c < 3; ++c) {
      place.s[c] = axes.col(c).norm();
      if (place.s[c] > 0) axes.col(c) /= place.s[c];
    }
    if (axes.determinant() < 0) axes.col(0) *= -1, place.s[0] *= -1;
    if (!(axes.determinant() > 0.999)) matrix->fail("shears or flattens", "write translation, rotation and scale");
    place.q = Quat(axes).normalized();
    return place;
  }
  place.p = node.vector_or("translation", place.p);
  place.q = node.rotation_or("rotation");
  place.s = node.vector_or("scale", place.s);
  return place;
}

void Reader::tell(const std::string& kind, const std::string& text) {
  constexpr std::size_t kOfOne = 4, kMost = 40;  // of one sentence, about several places; of all
  const std::size_t colon = text.find(": ");
  const std::string sentence = colon == std::string::npos ? text : text.substr(colon);
  std::size_t same = 0, mine = 0;
  for (const std::string& r : stage_.remarks)
    same += r.starts_with(kind) && r.ends_with(sentence), mine += r.starts_with(kind);
  ++told_;
  if (std::ranges::find(stage_.remarks, kind + ": " + text) != stage_.remarks.end() || same > kOfOne || mine > kMost)
    return;
  if (mine == kMost)
    stage_.remarks.push_back(kind + ": more of other kinds");
  else
    stage_.remarks.push_back(kind + ": " + (same < kOfOne ? text : "more places" + sentence));
}
void Reader::remark(const std::string& text) { tell("left out", text); }
void Reader::note(const std::string& text) { tell("not quite", text); }

void Reader::run() {
  stage_.remarks.push_back("read from " + doc_.path());
  read_world();
  read_omi_gravity();
  name_what_is_not_read();
  find_nodes();
  make_bodies();
  make_particles();
  make_joints();
  make_gravity_volumes();
  read_fields_and_springs();
  for (const char* section : {"animations", "skins"})
    if (doc_.count(section) > 0) remark(std::string(section) + " are not played");
}

void Reader::read_world() {
  stage_.bounds_min = Vec::Constant(-1e9), stage_.bounds_max = Vec::Constant(1e9);  // where no file said what is lost
  const auto extension = own(doc_.root());
  if (!extension) return;
  Call call;
  carom_world* const world = stage_.world.get();
  if (const auto g = extension->get("gravity")) {
    const Vec gravity = g->vector();
    call.done(carom_world_set_gravity(world, gravity.data(), call), g->place());
  }
  if (const auto dials = extension->get("dials"))
    for (const auto& [name, value] : dials->items()) {
      char text[32];
      if (!value.is_text()) std::snprintf(text, sizeof text, "%.17g", value.number());
      try {
        stage_.world.set_dial(name + "=" + (value.is_text() ? value.text() : text));
      } catch (const Error& e) {
        value.fail(std::string("is wrong: ") + e.what(), e.remedy);
      }
    }
  if (const auto effects = extension->get("effects"))
    for (const auto& [name, value] : effects->items()) {
      if (value.text() != "forbid" && value.text() != "force")
        value.fail("is '" + value.text() + "'", "write \"forbid\" or \"force\"");
      try {
        stage_.world.set_effect(name, value.text() == "forbid" ? CAROM_MODE_FORBID : CAROM_MODE_FORCE);
      } catch (const Error& e) {
        value.fail(std::string("is wrong: ") + e.what(), e.remedy);
      }
    }
  if (const auto wind = extension->get("wind")) stage_.set_wind(wind->vector());
  if (const auto water = extension->get("water")) {
    carom_water w;
    carom_water_init(&w, sizeof w);
    put(w.normal, water->vector_or("normal", Vec::UnitY()));
    put(w.current, water->vector_or("current", Vec::Zero()));
    w.level = water->number_or("level", 0), w.density = water->number_or("density", w.density);
    w.drag = water->number_or("drag", w.drag);
    stage_.set_water(w);
  }
  if (const auto camera = extension->get("camera"))
    stage_.camera_from = (*camera)["from"].vector(), stage_.camera_to = (*camera)["to"].vector();
  stage_.ground_half_width = extension->number_or("floor", stage_.ground_half_width, 0, 1e9);
  if (const auto bounds = extension->get("bounds"))
    stage_.bounds_min = bounds->at(0).vector(), stage_.bounds_max = bounds->at(1).vector();
}

void Reader::find_nodes() {
  doc_.budget().charge(doc_.count("nodes"), 4 * sizeof(Node), "nodes");
  nodes_.resize(doc_.count("nodes"));
  actor_of_node_.assign(nodes_.size(), kNone);
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    nodes_[i].local = place_of(node(i));
    const auto extension = khr(node(i));
    const auto mine = own(node(i));
    nodes_[i].is_body = (extension && extension->has("motion")) || (mine && mine->has("body"));
  }
  demand_trees();
  if (nodes_.empty()) return;
  const auto which = doc_.root().get("scene");
  if (doc_.count("scenes") == 0) doc_.root().fail("has nodes but no scene", "list the root nodes in a scene");
  const Value scene = doc_.section("scenes", which ? which->index(doc_.count("scenes"), "scenes") : 0);
  if (const auto roots = scene.get("nodes"))
    for (std::size_t k = 0; k < roots->size(); ++k) walk(roots->at(k).index(nodes_.size(), "nodes"), kNone, 0);
}

/// Nodes form trees: then what follows from a node to its children ends, and takes no more steps than there are nodes.
void Reader::demand_trees() const {
  std::vector<std::size_t> parent(nodes_.size(), kNone);
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const auto children = node(i).get("children");
    for (std::size_t k = 0; children && k < children->size(); ++k) {
      const std::size_t child = children->at(k).index(nodes_.size(), "nodes");
      if (parent[child] != kNone) children->at(k).fail("has two parents", "make nodes a tree");
      parent[child] = i;
    }
  }
  std::vector<std::size_t> seen(nodes_.size(), kNone);  // on the way up from which node
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    for (std::size_t up = i; up != kNone && seen[up] != kSettled; up = parent[up]) {
      if (seen[up] == i) node(up).fail("is among its own children", "make nodes a tree");
      seen[up] = i;
      if (parent[up] == kNone || seen[parent[up]] == kSettled) {
        for (std::size_t down = i; down != kNone && seen[down] != kSettled; down = parent[down]) seen[down] = kSettled;
        break;
      }
    }
}

void Reader::walk(std::size_t i, std::size_t parent, std::size_t depth) {
  Node& n = nodes_[i];
  if (n.parent != kNone || depth > kDeepest)
    node(i).fail(depth > kDeepest ? "is nested too deep" : "has two parents", "make nodes a tree");
  n.parent = parent == kNone ? i : parent;  // a root is its own: seen
  n.world = parent == kNone ? n.local : n.local.in(nodes_[parent].world);
  if (n.is_body) {
    n.body = i;
    n.in_body.s = n.world.s;
  } else if (parent != kNone && nodes_[parent].body != kNone) {
    n.body = nodes_[parent].body;
    n.in_body = n.local.in(nodes_[parent].in_body);
  }
  if (const auto children = node(i).get("children"))
    for (std::size_t k = 0; k < children->size(); ++k) {
      const std::size_t child = children->at(k).index(nodes_.size(), "nodes");
      if (nodes_[child].parent != kNone) children->at(k).fail("has two parents", "make nodes a tree");
      walk(child, i, depth + 1);
    }
}

Actor Reader::actor_of(std::size_t i) {
  const Value at = node(i);
  Actor actor;
  const auto name = at.get("name");
  actor.name = name ? name->text() : "node " + std::to_string(i);
  if (const int before = names_[actor.name]++) actor.name += " #" + std::to_string(before + 1);
  const auto mine = own(at);
  const auto kind = mine ? mine->get("kind") : std::nullopt;
  actor.kind = kind ? kind->text() : "body";
  actor.type = CAROM_BODY_STATIC;
  actor.position = nodes_[i].world.p;
  actor.orientation = nodes_[i].world.q;
  return actor;
}

void Reader::make_bodies() {
  // Bodies, and colliders that are no body's: each of these a static body of its own.
  std::map<std::size_t, std::vector<std::size_t>> colliders;  // by body node, or the collider's own
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const auto mine = own(node(i));
    if (nodes_[i].parent == kNone) continue;  // of no scene
    if (mine && mine->has("particle")) {
      const Value set = (*mine)["particle"];
      Actor actor = actor_of(i);
      actor.type = CAROM_BODY_DYNAMIC;
      actor.linear_velocity = mine->vector_or("linearVelocity", Vec::Zero());
      particles_.push_back({mine->has("index") ? (*mine)["index"].index(SIZE_MAX, "") : i, set.index(SIZE_MAX, "sets"),
                            mine->number_or("mass", 1, 0, 1e30), std::move(actor)});
      continue;
    }
    if (nodes_[i].is_body) colliders[i];
    if (!colliders_of(node(i)).empty()) colliders[nodes_[i].body == kNone ? i : nodes_[i].body].push_back(i);
  }
  std::vector<std::pair<std::size_t, std::size_t>> order;  // index, node
  for (const auto& [i, list] : colliders) {
    const auto mine = own(node(i));
    order.emplace_back(mine && mine->has("index") ? (*mine)["index"].index(SIZE_MAX, "") : i, i);
  }
  std::stable_sort(order.begin(), order.end());
  for (const auto& [rank, i] : order) {
    Actor actor = actor_of(i);
    if (nodes_[i].is_body) read_motion(node(i), nodes_[i], actor);
    std::vector<std::pair<Value, bool>> made;
    for (const std::size_t c : colliders[i])
      for (const Value& collider : colliders_of(node(c))) {
        Node at = nodes_[c];
        if (!nodes_[i].is_body) at.in_body = {Vec::Zero(), Quat::Identity(), at.world.s};
        for (Part& part : parts_of(collider, at, actor.type == CAROM_BODY_DYNAMIC)) {
          actor.parts.push_back(std::move(part));
          made.emplace_back(collider, collider.place().ends_with("/trigger"));
        }
      }
    std::size_t a = 0;
    try {
      a = stage_.add(std::move(actor));
    } catch (const Error& e) {
      node(i).fail(std::string("cannot be made: ") + e.what(), e.remedy);
    }
    actor_of_node_[i] = a;
    if (nodes_[i].is_body) finish_body(i, a);
    for (std::size_t k = 0; k < made.size(); ++k)
      finish_collider(made[k].first, made[k].second, stage_.actors[a].parts[k]);
  }
  for (Node& n : nodes_)
    if (n.body != kNone && actor_of_node_[n.body] == kNone) n.body = kNone;
}

void Reader::make_particles() {
  std::stable_sort(particles_.begin(), particles_.end(),
                   [](const Particle& a, const Particle& b) { return a.index < b.index; });
  for (std::size_t first = 0, end = 0; first < particles_.size(); first = end) {
    std::vector<Actor> set;
    for (; end < particles_.size() && particles_[end].set == particles_[first].set; ++end)
      set.push_back(std::move(particles_[end].actor));
    stage_.add_particles(std::move(set), particles_[first].mass);
  }
}

void Reader::read_fields_and_springs() {
  const auto extension = own(doc_.root());
  if (!extension) return;
  if (const auto fields = extension->get("fields"))
    for (std::size_t k = 0; k < fields->size(); ++k) {
      const Value f = fields->at(k);
      carom_force_field_desc d;
      carom_force_field_desc_init(&d, sizeof d);
      const std::string& kind = f["kind"].text();
      std::string kinds;
      for (d.kind = 0; d.kind < CAROM_FORCE_FIELD_COUNT && kind != carom_force_field_name(d.kind); ++d.kind)
        kinds += std::string(d.kind ? ", " : "") + carom_force_field_name(d.kind);
      if (d.kind == CAROM_FORCE_FIELD_COUNT) f["kind"].fail("is '" + kind + "'", "write one of " + kinds);
      d.is_force = f.has("isForce") && f["isForce"].boolean();
      if (f.has("mask")) d.mask = f["mask"].bits_as<std::uint32_t>();
      put(d.position, f.vector_or("position", Vec::Zero()));
      const Quat q = f.rotation_or("orientation");
      std::copy(q.coeffs().data(), q.coeffs().data() + 4, d.orientation);
      put(d.vector, f.vector_or("vector", Vec::Zero()));
      if (const auto half = f.get("half"))
        for (std::size_t i = 0; i < 3; ++i)
          if (!half->at(i).is_null()) d.half[i] = half->at(i).number();
      d.strength = f.number_or("strength", d.strength), d.pull = f.number_or("pull", d.pull);
      d.lift = f.number_or("lift", d.lift), d.reference = f.number_or("reference", d.reference);
      d.core = f.number_or("core", d.core), d.reach = f.number_or("reach", d.reach);
      if (f.has("falloff")) d.falloff = f["falloff"].whole<std::int32_t>(-2, 8);
      stage_.add_field(d);
    }
  if (const auto springs = extension->get("springs"))
    for (std::size_t k = 0; k < springs->size(); ++k) {
      const Value s = springs->at(k);
      const auto end = [&](const char* key) {
        const auto which = s.get(key);
        if (!which) return Bungee::kWorld;
        const std::size_t n = which->index(nodes_.size(), "nodes"), body = nodes_[n].body;
        if (body == kNone) which->fail("is of no body", "name a node that is a body, or leave it out: the world");
        return actor_of_node_[body];
      };
      Bungee b;
      b.a = end("nodeA"), b.b = end("nodeB");
      b.at_a = s.vector_or("anchorA", Vec::Zero()), b.at_b = s.vector_or("anchorB", Vec::Zero());
      b.rest = s.number_or("rest", 0, 0, 1e9), b.stiffness = s["stiffness"].number(),
      b.damping = s.number_or("damping", 0);
      b.only_pulls = s.has("onlyPulls") && s["onlyPulls"].boolean();
      stage_.add_spring(b);
    }
}

}  // namespace scenefile

bool is_scene_file(const std::string& name) {
  return name.ends_with(".gltf") || name.ends_with(".glb") || is_snapshot_file(name);
}

void read_scene(const std::string& path, Stage& stage) { scenefile::Reader(path, stage).run(); }

Scene scene_of_file(const std::string& path) {
  if (is_snapshot_file(path)) return scene_of_snapshot(path);
  const scenefile::Document document(path);
  const auto own = scenefile::Document::extension(document.root(), "CAROM_physics");
  Scene scene;
  scene.name = std::filesystem::path(path).stem().string();
  scene.summary = "The scene of " + path + ".";
  scene.look_for = "what the file was made for";
  scene.seconds = own ? own->number_or("seconds", 5, 1e-6, 1e9) : 5;
  scene.dt = own ? own->number_or("dt", 1.0 / 60, 1e-9, 1) : 1.0 / 60;
  scene.fill = [](Stage& stage, const std::vector<double>&, const std::string& file) -> std::unique_ptr<Observer> {
    read_scene(file, stage);
    return nullptr;
  };
  return scene;
}

}  // namespace carom::tools
