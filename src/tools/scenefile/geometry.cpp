// What the colliders of a scene file are made of: shapes, surfaces, filters.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "scenefile/reader.h"

namespace carom::tools::scenefile {
namespace {

constexpr int kDeepestHull = 8;  // as carom_shape_create_hull_of() has it; a shape that is its own part ends there
constexpr std::uint64_t kEverybody = std::uint64_t(1) << 63;  // a bit that every filter of a file lets touch it

/// A shape about y that is round but of two radii: the hull of its rims, and of the caps of a capsule.
std::vector<double> round_hull(double height, double bottom, double top, bool capped) {
  constexpr int kAround = 24, kBands = 6;
  std::vector<double> points;
  const auto ring = [&](double y, double r) {
    for (int k = 0; k < (r > 0 ? kAround : 1); ++k) {
      const double turn = 2 * std::numbers::pi * k / kAround;
      points.insert(points.end(), {r * std::cos(turn), y, r * std::sin(turn)});
    }
  };
  for (const int side : {-1, 1}) {
    const double r = side < 0 ? bottom : top, y = side * height / 2;
    ring(y, r);
    for (int band = 1; capped && r > 0 && band <= kBands; ++band) {
      const double up = std::numbers::pi / 2 * band / kBands;
      ring(y + side * r * std::sin(up), band == kBands ? 0 : r * std::cos(up));
    }
  }
  return points;
}

bool is_uniform(const Vec& s) { return s.maxCoeff() - s.minCoeff() <= 1e-6 * s.maxCoeff(); }

std::uint32_t mix_of(const Value& rule) {
  static constexpr const char* kRules[] = {"maximum", "minimum", "average", "multiply"};
  for (std::uint32_t k = 0; k < 4; ++k)
    if (rule.text() == kRules[k]) return CAROM_MIX_MAXIMUM + k;
  rule.fail("is '" + rule.text() + "'", "write average, minimum, maximum or multiply");
}

}  // namespace

std::vector<Value> Reader::colliders_of(const Value& at) const {
  std::vector<Value> list;
  const auto extension = khr(at);
  if (!extension) return list;
  for (const char* key : {"collider", "trigger"})
    if (const auto value = extension->get(key);
        value && (value->has("geometry") || own(*value) || omi_index(*value, "shape")))
      list.push_back(*value);
  return list;
}

/// One, but for a mesh that moves.
std::vector<Part> Reader::parts_of(const Value& collider, const Node& at, bool moves) {
  Part part;
  Hulls hulls;
  const auto mine = own(collider);
  part.position = at.in_body.p, part.orientation = at.in_body.q;
  if (mine) {
    part.density = mine->number_or("density", part.density, 0, 1e9);
    part.position = mine->vector_or("position", part.position);
    if (mine->has("orientation")) part.orientation = (*mine)["orientation"].rotation();
    part.surface_velocity = mine->vector_or("surfaceVelocity", part.surface_velocity);
    part.surface_spin = mine->vector_or("surfaceSpin", part.surface_spin);
  }
  const Vec scale = at.in_body.s.cwiseAbs();
  if (const auto which = mine ? mine->get("shape") : std::nullopt) {
    const Value shapes = (*own(doc_.root()))["shapes"];  // which says so where the document has none
    read_own_shape(shapes, which->index(shapes.size(), "shapes of CAROM_physics"), 0, part.shape, part.params);
  } else if (!(scale.minCoeff() > 0)) {
    collider.fail("has a scale of 0", "leave the collider out");
  } else if (const auto omi = omi_index(collider, "shape")) {
    read_omi_shape(*omi, scale, moves, part, hulls);
  } else {
    const Value geometry = collider["geometry"];
    if (const auto shape = geometry.get("shape")) {
      const auto all = Document::extension(doc_.root(), "KHR_implicit_shapes");
      if (!all) geometry.fail("needs KHR_implicit_shapes", "add the extension with its shapes");
      const Value shapes = (*all)["shapes"];
      read_shape(shapes.at(shape->index(shapes.size(), "shapes")), scale, part);
    } else {
      const bool convex = geometry.has("convexHull") && geometry["convexHull"].boolean();
      collide_as(mesh_of(geometry, scale), geometry, convex, moves, part, hulls);
    }
  }
  if (part.shape == "half_space" && moves) collider.fail("is a plane on a body that moves", "planes are static");
  read_surface(collider, part);
  std::vector<Part> parts{part};
  for (std::size_t k = 1; k < hulls.size(); ++k) {
    parts.push_back(part);
    parts.back().params = hulls[k];
  }
  return parts;
}

/// One of the shapes of CAROM_physics.
void Reader::read_own_shape(const Value& shapes, std::size_t which, int depth, std::string& name,
                            std::vector<double>& params) {
  const Value shape = shapes.at(which);
  if (shape.has("parts")) {
    name = "hull_of";
    if (depth == kDeepestHull) shape["parts"].fail("are hulls of hulls, too deep", "list the parts of the inner ones");
    HullOf hull;
    hull.radius = shape.number_or("radius", 0, 0, 1e8);
    const Value parts = shape["parts"];
    if (parts.size() == 0) parts.fail("is empty", "list the shapes that the hull is of");
    doc_.budget().charge(parts.size(), sizeof(HullPart), doc_.path() + ": " + shape.place() + "/parts");
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const Value from = parts.at(k);
      HullPart part;
      const std::size_t inner = from["shape"].index(shapes.size(), "shapes of CAROM_physics");
      read_own_shape(shapes, inner, depth + 1, part.shape, part.params);
      if (part.shape == "half_space" || part.shape == "height_field" || part.shape == "mesh")
        from["shape"].fail("is a " + part.shape, "hulls are of convex, bounded shapes");
      const Vec position = from.vector_or("position", Vec::Zero()), scale = from.vector_or("scale", Vec::Ones());
      const Quat q = from.rotation_or("orientation");
      std::copy_n(position.data(), 3, part.position.begin());
      std::copy_n(q.coeffs().data(), 4, part.orientation.begin());  // x, y, z, w
      std::copy_n(scale.data(), 3, part.scale.begin());
      hull.parts.push_back(std::move(part));
    }
    params = stage_.engine().add(std::move(hull));
    return;
  }
  name = shape["plugin"].text();
  if (!is_plugin_name(name) || name == "hull_of")
    shape["plugin"].fail("is '" + name.substr(0, 80) + "', which is no name of a plugin",
                         "write its id alone: up to 64 letters, digits, _, - or dots, no path");
  doc_.budget().charge(shape["params"].size(), 8 * sizeof(double), doc_.path() + ": " + shape.place() + "/params");
  params = shape["params"].numbers();
  if (name == "half_space" && params.size() != 4) shape["params"].fail("are not four", "give normal and offset");
  if (name == "height_field" && params.size() < 4)
    shape["params"].fail("are too few", "give columns, rows, spacings, heights");
}

void Reader::read_shape(const Value& shape, const Vec& scale, Part& part) {
  constexpr double kMost = 1e8;
  const std::string& type = shape["type"].text();
  const Maybe given = is_omi(shape) ? omi_details(shape) : shape.get(type.c_str());
  if (type == "sphere") {
    const double r = given ? given->number_or("radius", 0.5, 1e-9, kMost) : 0.5;
    part.shape = is_uniform(scale) ? "sphere" : "ellipsoid";
    if (is_uniform(scale))
      part.params = {r * scale.x()};
    else
      part.params = {r * scale.x(), r * scale.y(), r * scale.z()};
  } else if (type == "box") {
    const Vec size = given ? given->vector_or("size", Vec::Ones()) : Vec(Vec::Ones());
    if (!(size.minCoeff() > 0)) shape.fail("is a box without volume", "give sizes above 0");
    part.shape = "box";
    part.params = {size.x() / 2 * scale.x(), size.y() / 2 * scale.y(), size.z() / 2 * scale.z()};
  } else if (type == "capsule" || type == "cylinder") {
    const bool capsule = type == "capsule";
    // m, where nothing is said: each extension has its own.
    const double usual = is_omi(shape) ? 0.5 : 0.25, tall = !is_omi(shape) ? 0.5 : capsule ? 1 : 2;
    const auto value = [&](const char* key, double otherwise, double least) {
      return given ? given->number_or(key, otherwise, least, kMost) : otherwise;
    };
    double bottom = value("radiusBottom", usual, 0), top = value("radiusTop", usual, 0),
           mid = value("height", tall, 1e-9);
    if (is_omi(shape)) read_omi_radius(shape, bottom, top, mid);
    const double height = mid * scale.y();
    if (!(bottom > 0 || top > 0)) shape.fail("has no radius", "give radiusBottom or radiusTop above 0");
    const bool round = std::fabs(scale.x() - scale.z()) <= 1e-6 * scale.x() && (!capsule || is_uniform(scale));
    if (round && bottom == top) {
      part.shape = capsule ? "capsule" : "cylinder";
      part.params = {bottom * scale.x(), height / 2};
    } else if (round && !capsule && (top == 0 || bottom == 0)) {
      part.shape = "cone";
      part.params = {std::max(top, bottom) * scale.x(), height / 2};
      if (bottom == 0) part.orientation = part.orientation * Quat(0, 1, 0, 0);  // its apex looks down
    } else if (round && capsule) {
      part.shape = "tapered_capsule";
      part.params = {bottom * scale.x(), top * scale.x(), height / 2};
    } else {
      part.shape = "hull";
      part.params = round_hull(height / scale.y(), bottom, top, capsule);
      for (std::size_t i = 0; i < part.params.size(); ++i) part.params[i] *= scale[static_cast<int>(i % 3)];
    }
  } else if (type == "plane") {
    const Vec normal = part.orientation * Vec::UnitY();
    if (given && (given->has("sizeX") || given->has("sizeZ"))) {
      // A sheet: thin, below its plane, so that its upper side is where it should be.
      constexpr double kThick = 0.01, kFar = 1e4;  // m
      part.shape = "box";
      part.params = {given->number_or("sizeX", kFar, 1e-9, kMost) / 2 * scale.x(), kThick,
                     given->number_or("sizeZ", kFar, 1e-9, kMost) / 2 * scale.z()};
      part.position -= kThick * normal;
    } else {
      part.shape = "half_space";
      part.params = {normal.x(), normal.y(), normal.z(), normal.dot(part.position)};
      part.position = Vec::Zero(), part.orientation = Quat::Identity();
    }
  } else {
    shape["type"].fail("is '" + type + "', which is not known here",
                       "use sphere, box, capsule, cylinder, plane or a mesh");
  }
}

void Reader::read_surface(const Value& collider, Part& part) {
  const auto which = is_omi(collider) ? omi_index(collider, "physicsMaterial") : collider.get("physicsMaterial");
  if (!which) return;
  const auto extension = of_document(*which);
  if (!extension) which->fail("needs its extension in the document", "add the extension with physicsMaterials");
  const Value materials = (*extension)["physicsMaterials"];
  const Value material = materials.at(which->index(materials.size(), "physicsMaterials"));
  part.friction = material.number_or("dynamicFriction", 0.6, 0, 1e3);
  part.restitution = material.number_or("restitution", 0, 0, 1);
  part.friction_mix = part.restitution_mix = CAROM_MIX_AVERAGE;
  if (const auto rule = material.get("frictionCombine")) part.friction_mix = mix_of(*rule);
  if (const auto rule = material.get("restitutionCombine")) part.restitution_mix = mix_of(*rule);
  const double still = material.number_or("staticFriction", part.friction, 0, 1e3);
  if (still != part.friction) remark(material.place() + ": friction at rest; the dynamic one holds throughout");
  const auto mine = own(material);
  if (!mine) return;
  const auto rule = [&](const char* key, std::uint32_t otherwise) {
    const auto value = mine->get(key);
    return value ? checked<std::uint32_t>(value->index(5, "ways to mix")) : otherwise;
  };
  part.friction_mix = rule("frictionMix", part.friction_mix);
  part.restitution_mix = rule("restitutionMix", part.restitution_mix);
  part.rolling = mine->number_or("rolling", 0, 0, 1e3), part.spinning = mine->number_or("spinning", 0, 0, 1e3);
}

std::uint64_t Reader::system_bit(const Value& name) {
  constexpr std::size_t kMost = 62;
  const auto [at, fresh] = systems_.try_emplace(name.text(), 0);
  if (fresh) {
    if (systems_.size() > kMost) name.fail("is the 63rd collision system", "use at most 62");
    at->second = std::uint64_t(1) << (systems_.size() - 1);
  }
  return at->second;
}

void Reader::finish_collider(const Value& collider, bool sensor, const Part& part) {
  carom_world* const world = stage_.world.get();
  Call call;
  if (sensor) call.done(carom_collider_set_sensor(world, part.collider, 1, call), collider.place());
  const auto mine = own(collider);
  if (const auto filter = mine ? mine->get("filter") : std::nullopt) {
    const auto group = filter->has("group") ? (*filter)["group"].whole<std::int32_t>() : 0;
    call.done(carom_collider_set_filter(world, part.collider, (*filter)["category"].bits(), (*filter)["mask"].bits(),
                                        group, call),
              filter->place());
    return;
  }
  const auto extension = of_document(collider);
  const auto filters = extension ? extension->get("collisionFilters") : std::nullopt;
  if (!filters) return;
  std::uint64_t category = kEverybody, mask = ~std::uint64_t(0);
  if (const auto which = is_omi(collider) ? omi_index(collider, "collisionFilter") : collider.get("collisionFilter")) {
    const Value filter = filters->at(which->index(filters->size(), "collisionFilters"));
    const auto all_of = [&](const char* key) {
      std::uint64_t bits = 0;
      if (const auto names = filter.get(key))
        for (std::size_t k = 0; k < names->size(); ++k) bits |= system_bit(names->at(k));
      return bits;
    };
    if (const std::uint64_t systems = all_of("collisionSystems")) category = systems;
    if (filter.has("collideWithSystems"))
      mask = all_of("collideWithSystems") | kEverybody;
    else
      mask = ~all_of("notCollideWithSystems");
  }
  call.done(carom_collider_set_filter(world, part.collider, category, mask, 0, call), collider.place());
}

}  // namespace carom::tools::scenefile
