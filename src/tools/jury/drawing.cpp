// Shapes at random, what the judge has to know of a body, and whether a place is free.
#include "jury/drawing.h"

#include <algorithm>
#include <cmath>

namespace carom::tools::jury {
namespace {

/// Full widths of a solid: its length first.
struct Widths {
  double length, across, thin;
  std::string form;
};

Widths widths(Drawing& d) {
  const double length = 0.05 * octaves(4 * d.random.unit());
  const double ratio = 2 * octaves(3.875 * d.random.unit());  // 2 to 30
  const double a = d.random.between(0.5, 1), b = d.random.between(0.5, 1);
  const bool thin = d.chance(d.thin), rod = d.chance(0.5);
  if (!thin) return {length, length * a, length * b, "lump"};
  if (rod) return {length, length / ratio, length / ratio, "rod"};
  return {length, length * a, length / ratio, "plate"};
}

std::vector<double> hull_points(Drawing& d, const Widths& w) {
  const std::size_t count = 8 + d.pick(13);
  std::vector<double> points;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec on = d.random.direction();
    points.insert(points.end(), {on.x() * w.length / 2, on.y() * w.across / 2, on.z() * w.thin / 2});
  }
  return points;
}

/// Of what is round about its y axis: radius and half height.
std::vector<double> round_params(const Widths& w) {
  if (w.form == "plate") return {w.length / 2, w.thin / 2};
  return {w.across / 2, w.length / 2};
}

/// What the world made of a body's mass.
void read_mass(Stage& stage, carom_body body, Member& member) {
  carom_body_desc desc;
  Call call;
  call.done(carom_body_desc_init(&desc, sizeof desc), "asking for a mass");
  call.done(carom_body_get(stage.world.get(), body, &desc, call), "asking for a mass");
  member.mass = desc.mass;
  member.center = Vec(desc.center);
  for (int i = 0; i < 9; ++i) member.inertia(i / 3, i % 3) = desc.inertia[i];
}

/// Widths along many directions: the largest, and the least.
void read_widths(Stage& stage, Member& member) {
  Random directions(1);
  member.size = 0, member.thickness = HUGE_VAL;
  for (int i = 0; i < 400; ++i) {
    const Vec d = i < 3 ? Vec(Vec::Unit(i)) : Vec(directions.direction());
    const double both[6] = {d.x(), d.y(), d.z(), -d.x(), -d.y(), -d.z()};
    double points[6];
    Call call;
    call.done(carom_shape_support(stage.engine().get(), member.shape, both, 2, points, call), "measuring a shape");
    const double width = d.dot(Vec(points) - Vec(points + 3));
    member.size = std::max(member.size, width);
    member.thickness = std::min(member.thickness, width);
  }
}

}  // namespace

double octaves(double x) {
  const double whole = std::floor(x);
  return std::ldexp(1 + (x - whole), static_cast<int>(whole));
}

Solid Drawing::solid() {
  static constexpr const char* kPlugins[] = {"sphere", "box",       "capsule", "cylinder",
                                             "cone",   "ellipsoid", "hull",    "template"};
  const std::size_t kind = pick(8);
  const Widths w = widths(*this);
  Solid solid{kPlugins[kind], {}, w.form};
  if (kind == 0) {
    solid.params = {w.length / 2};
    solid.form = "lump";
  } else if (kind == 1 || kind == 5) {
    solid.params = {w.length / 2, w.across / 2, w.thin / 2};
  } else if (kind == 2) {
    solid.params = {std::min(w.thin, 0.9 * w.length) / 2, (w.length - std::min(w.thin, 0.9 * w.length)) / 2};
    if (w.form == "plate") solid.form = "rod";
  } else if (kind == 6) {
    solid.params = hull_points(*this, w);
  } else {
    solid.params = round_params(w);
  }
  return solid;
}

Part Drawing::part(const Solid& solid) {
  Part part;
  part.shape = solid.plugin;
  part.params = solid.params;
  part.density = 100 * octaves(5.5625 * random.unit());  // to 5,000
  part.friction = random.between(0.1, 0.9);
  const bool bounces = chance(0.4);
  part.restitution = bounces ? random.between(0.05, 0.6) : 0;
  return part;
}

carom_shape Drawing::shape_of(const Part& part) { return stage_.engine().shape(part.shape, part.params); }

Vec Drawing::support(const Part& part, const Quat& turned, const Vec& direction) {
  const Vec local = turned.conjugate() * direction;
  Vec point;
  Call call;
  call.done(carom_shape_support(stage_.engine().get(), shape_of(part), local.data(), 1, point.data(), call),
            "placing a body");
  return turned * point;
}

double Drawing::radius(const Part& part) { return stage_.engine().info(shape_of(part)).bounding_radius; }

bool Drawing::is_free(const Part& part, const Vec& position, const Quat& turned, double gap,
                      const std::vector<std::size_t>& but) {
  const double reach = radius(part);
  for (std::size_t i = 0; i < scene.members.size(); ++i) {
    const Member& other = scene.members[i];
    if (std::find(but.begin(), but.end(), i) != but.end()) continue;
    if (other.is_heights) {
      const auto under = scene.heights->at(position.x(), position.z());
      if (!under) return false;
      double highest = -HUGE_VAL;
      for (const double h : scene.heights->values) highest = std::max(highest, h);
      if (position.y() - reach < std::min(highest + scene.heights->corner.y(), under->height + reach) + gap)
        return false;
      continue;
    }
    const Actor& actor = stage_.actors[i];
    if (!other.is_plane && (actor.position - position).norm() > reach + other.radius + gap) continue;
    carom_distance result;
    result.struct_size = sizeof result;
    Call call;
    call.done(carom_shape_distance(stage_.engine().get(), shape_of(part), position.data(), turned.coeffs().data(),
                                   other.shape, actor.position.data(), actor.orientation.coeffs().data(), nullptr,
                                   &result, call),
              "placing a body");
    if (result.lower < gap) return false;
  }
  return true;
}

std::size_t Drawing::add(Actor actor) {
  const std::size_t index = stage_.add(std::move(actor));
  const Actor& made = stage_.actors[index];
  const Part& shown = made.parts.at(0);
  Member member;
  member.name = made.name;
  member.type = made.type;
  member.is_plane = shown.shape == "half_space";
  member.is_heights = shown.shape == "height_field";
  member.shape = member.is_plane     ? stage_.engine().half_space(shown.params.data(), shown.params.at(3))
                 : member.is_heights ? stage_.engine().height_field(shown.params)
                                     : shape_of(shown);
  member.size = member.thickness = member.radius = HUGE_VAL;
  if (!shown.is_ground()) {
    read_widths(stage_, member);
    member.radius = radius(shown);
  }
  if (member.moves()) read_mass(stage_, made.body, member);
  scene.members.push_back(std::move(member));
  return index;
}

}  // namespace carom::tools::jury
