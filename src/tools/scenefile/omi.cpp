// OMI_physics_body, OMI_physics_shape, OMI_physics_joint and OMI_physics_gravity: bodies and joints have the structure
// of the KHR extension, and are read by what reads that; here is what they say otherwise.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "scenefile/reader.h"

namespace carom::tools::scenefile {
namespace {

void put(double (&out)[3], const Vec& v) { std::copy(v.data(), v.data() + 3, out); }

Vec direction_of(const Value& at) {
  const auto given = at.get("direction");
  const Vec direction = given ? given->vector() : Vec(0, -1, 0);
  if (!(direction.norm() > 0)) given->fail("is no direction", "give a vector of length 1");
  return direction.normalized();
}

/// Words of names of extensions that are about physics.
bool sounds_like_physics(const std::string& name) {
  static constexpr const char* kWords[] = {"physics", "rigid",   "collision", "collider", "joint",
                                           "vehicle", "gravity", "cloth",     "soft_body"};
  return std::ranges::any_of(kWords, [&](const char* word) { return name.find(word) != std::string::npos; });
}

}  // namespace

Maybe Reader::of_document(const Value& of) const {
  const bool joint = of.place().find("/extensions/OMI_physics_joint") != std::string::npos;
  return Document::extension(doc_.root(), joint        ? "OMI_physics_joint"
                                          : is_omi(of) ? "OMI_physics_body"
                                                       : "KHR_physics_rigid_bodies");
}

Maybe Reader::omi_index(const Value& of, const char* key) {
  if (!is_omi(of)) return std::nullopt;
  const auto value = of.get(key);
  return value && value->whole<std::int64_t>(-1) >= 0 ? value : std::nullopt;
}

/// What is said of a shape beyond its type: in an object of that name, or, in an earlier draft, beside it.
Maybe Reader::omi_details(const Value& shape) {
  if (const auto inner = shape.get(shape["type"].text().c_str())) return inner;
  for (const char* key : {"size", "radius", "radiusTop", "radiusBottom", "height", "mesh"})
    if (shape.has(key)) {
      note(shape.place() + "/" + key +
           ": read as in an earlier draft of OMI_physics_shape, that had it beside the type");
      break;
    }
  return shape;
}

/// An earlier draft knew one radius, and the height of a capsule from end to end.
void Reader::read_omi_radius(const Value& shape, double& bottom, double& top, double& height) {
  const auto inner = shape.get(shape["type"].text().c_str());
  const Value of = inner ? *inner : shape;
  if (!of.has("radius")) return;
  bottom = top = of["radius"].number(1e-9, 1e8);
  if (shape["type"].text() != "capsule") return;
  note(of.place() + "/radius: of an earlier draft of OMI_physics_shape; its height counts the caps");
  height = std::max(of.number_or("height", 2, 1e-9, 1e8) - 2 * bottom, 1e-6 * bottom);
}

void Reader::read_omi_shape(const Value& which, const Vec& scale, bool moves, Part& part, Hulls& hulls) {
  const auto all = Document::extension(doc_.root(), "OMI_physics_shape");
  if (!all) which.fail("needs OMI_physics_shape", "add the extension with its shapes");
  const Value shapes = (*all)["shapes"], shape = shapes.at(which.index(shapes.size(), "shapes"));
  const std::string& type = shape["type"].text();
  if (type != "convex" && type != "trimesh") return read_shape(shape, scale, part);
  const auto details = omi_details(shape);
  const auto mesh_index = omi_index(*details, "mesh");
  if (!mesh_index) details->fail("names no mesh", "give 'mesh', an index of meshes");
  Mesh mesh = doc_.mesh(mesh_index->index(doc_.count("meshes"), "meshes"));
  doc_.budget().charge(mesh.points.size() + mesh.faces.size(), 4 * sizeof(Vec), doc_.path() + ": " + which.place());
  for (Vec& x : mesh.points) x = scale.cwiseProduct(x);
  collide_as(std::move(mesh), shape, type == "convex", moves, part, hulls);
}

void Reader::read_omi_gravity() {
  const auto gravity = Document::extension(doc_.root(), "OMI_physics_gravity");
  const auto mine = own(doc_.root());
  if (!gravity || (mine && mine->has("gravity"))) return;
  const Vec g = (*gravity)["gravity"].number(-1e9, 1e9) * direction_of(*gravity);
  Call call;
  call.done(carom_world_set_gravity(stage_.world.get(), g.data(), call), gravity->place());
}

/// Where gravity of its own holds: the one shape of a trigger.
struct Reader::GravityVolume {
  std::size_t node;
  Value gravity;
  Place at{};                                              // of the shape
  Part shape{};                                            // a box or a sphere, or nothing that is known here
  double reach = std::numeric_limits<double>::infinity();  // m, from its middle
};

void Reader::find_volume(GravityVolume& volume) {
  const auto trigger_of = [&](std::size_t n) -> Maybe {
    const auto body = Document::extension(node(n), "OMI_physics_body");
    return body ? body->get("trigger") : body;
  };
  std::size_t n = volume.node;
  auto trigger = trigger_of(n);
  if (trigger && !omi_index(*trigger, "shape"))
    if (const auto several = trigger->get("nodes"); several && several->size() == 1)
      n = several->at(0).index(nodes_.size(), "nodes"), trigger = trigger_of(n);
  const auto which = trigger ? omi_index(*trigger, "shape") : trigger;
  const auto all = Document::extension(doc_.root(), "OMI_physics_shape");
  if (!which || !all) return;
  const Value shapes = (*all)["shapes"], shape = shapes.at(which->index(shapes.size(), "shapes"));
  volume.at = nodes_[n].world;
  const std::string& form = shape["type"].text();
  if (form != "box" && form != "sphere") return;
  read_shape(shape, volume.at.s.cwiseAbs(), volume.shape);
  const std::vector<double>& size = volume.shape.params;
  volume.reach = size.size() == 3 ? Vec(size[0], size[1], size[2]).norm() : size[0];
}

/// Volumes with gravity of their own become force fields, where these do the same.
void Reader::make_gravity_volumes() {
  std::vector<GravityVolume> volumes;
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    if (const auto gravity = Document::extension(node(i), "OMI_physics_gravity");
        gravity && nodes_[i].parent != kNone) {
      constexpr std::size_t kMost = 1000;  // each is compared with each
      if (volumes.size() == kMost) gravity->fail("is one of more than 1000 volumes with gravity", "join some");
      doc_.budget().charge(1, sizeof(GravityVolume), doc_.path() + ": " + gravity->place());
      volumes.push_back({i, *gravity});
      find_volume(volumes.back());
    }
  for (const GravityVolume& v : volumes) {
    const auto flag = [&](const char* key) { return v.gravity.has(key) && v.gravity[key].boolean(); };
    const bool has_say = flag("stop") || flag("replace");  // over others in the same place: let there be none
    const bool meets = has_say && std::ranges::any_of(volumes, [&](const GravityVolume& other) {
                         return other.node != v.node && !((other.at.p - v.at.p).norm() > other.reach + v.reach);
                       });
    if (meets || !make_gravity_volume(v, flag("stop")))
      remark(v.gravity.place() + ": gravity of a volume that no force field does exactly");
  }
}

/// @param stops  the world's gravity does not count in it
bool Reader::make_gravity_volume(const GravityVolume& v, bool stops) {
  Vec world_gravity;
  Call call;
  call.done(carom_world_get_gravity(stage_.world.get(), world_gravity.data(), call), v.gravity.place());
  const Place& origin = nodes_[v.node].world;
  const std::string& type = v.gravity["type"].text();
  const double strength = v.gravity["gravity"].number(-1e9, 1e9);
  const auto details = v.gravity.get(type.c_str());
  carom_force_field_desc d;
  carom_force_field_desc_init(&d, sizeof d);
  put(d.position, v.at.p);
  if (type == "directional" && v.shape.shape == "box") {
    std::copy(v.at.q.coeffs().data(), v.at.q.coeffs().data() + 4, d.orientation);
    std::copy(v.shape.params.begin(), v.shape.params.end(), d.half);
    const Vec own_gravity = strength * (origin.q * (details ? direction_of(*details) : Vec(0, -1, 0)));
    put(d.vector, stops ? Vec(own_gravity - world_gravity) : own_gravity);
    d.kind = CAROM_FORCE_FIELD_UNIFORM;
  } else if (type == "point" && v.shape.shape == "sphere" && origin.p == v.at.p &&
             (!stops || world_gravity.isZero(0))) {
    const double unit = details ? details->number_or("unitDistance", 0, 0, 1e9) : 0;
    d.kind = CAROM_FORCE_FIELD_RADIAL;
    d.strength = -strength, d.reach = v.shape.params[0];
    d.falloff = unit > 0 ? 2 : 0;
    if (unit > 0) d.reference = unit;
  } else {
    return false;
  }
  stage_.add_field(d);
  return true;
}

/// Of two ways to mix the extensions let multiply yield to all others, and Carom lets all others yield to it.
void Reader::name_how_materials_mix() {
  for (const char* extension : {"KHR_physics_rigid_bodies", "OMI_physics_body"}) {
    const auto of = Document::extension(doc_.root(), extension);
    const auto materials = of ? of->get("physicsMaterials") : std::nullopt;
    for (const char* key : {"frictionCombine", "restitutionCombine"}) {
      std::size_t multiplying = 0;
      for (std::size_t k = 0; materials && k < materials->size(); ++k)
        if (const auto rule = materials->at(k).get(key)) multiplying += rule->text() == "multiply";
      if (multiplying > 0 && multiplying < materials->size())
        note(materials->place() + ": some multiply (" + key +
             "), others do not; where two such touch, the two are multiplied");
    }
  }
}

/// What the file holds of physics, and nothing here asks for.
void Reader::name_what_is_not_read() {
  name_how_materials_mix();
  const auto used = doc_.root().get("extensionsUsed");
  for (std::size_t k = 0; used && k < used->size(); ++k) {
    const std::string& name = used->at(k).text();
    if (sounds_like_physics(name) && !is_read(name))
      remark(used->at(k).place() + ": the extension " + name.substr(0, 80));
  }
  for (std::size_t i = 0; i < doc_.count("nodes"); ++i) {
    const auto omi = Document::extension(node(i), "OMI_physics_body");
    if (omi && omi->has("type")) remark(omi->place() + "/type: a body of an earlier draft");
    if (omi && Document::extension(node(i), "KHR_physics_rigid_bodies"))
      remark(omi->place() + ": beside KHR_physics_rigid_bodies, which holds");
    if (const auto old = Document::extension(node(i), "OMI_collider"))
      remark(old->place() + ": a collider of an earlier draft");
    const auto body = khr(node(i));
    const auto trigger = body ? body->get("trigger") : std::nullopt;
    if (trigger && trigger->has("nodes") && (*trigger)["nodes"].size() > 1)
      remark(trigger->place() + "/nodes: a trigger of several is none here; each of them is one");
  }
}

}  // namespace carom::tools::scenefile
