// Turns a scene's description of a body into calls of the C ABI, and says where it is.
#include <algorithm>

#include "scenes/scene.h"

namespace carom::tools {
namespace {

void put(double (&out)[3], const Vec& v) { std::copy(v.data(), v.data() + 3, out); }
void put(double (&out)[4], const Quat& q) { std::copy(q.coeffs().data(), q.coeffs().data() + 4, out); }  // x, y, z, w

}  // namespace

std::size_t Stage::add(Actor actor) {
  carom_body_desc desc;
  Call call;
  const std::string making = "making body '" + actor.name + "'";
  call.done(carom_body_desc_init(&desc, sizeof desc), making);
  desc.type = actor.type;
  put(desc.position, actor.position);
  put(desc.orientation, actor.orientation);
  put(desc.linear_velocity, actor.linear_velocity);
  put(desc.angular_velocity, actor.angular_velocity);
  if (actor.mass > 0) {
    desc.mass = actor.mass;
    desc.fields |= CAROM_BODY_FIELD_MASS;
    if (actor.center) put(desc.center, *actor.center), desc.fields |= CAROM_BODY_FIELD_CENTER;
    if (actor.inertia) {
      for (int i = 0; i < 9; ++i) desc.inertia[i] = (*actor.inertia)(i / 3, i % 3);
      desc.fields |= CAROM_BODY_FIELD_INERTIA;
    }
  }
  desc.linear_damping = actor.linear_damping;
  desc.angular_damping = actor.angular_damping;
  desc.user = actors.size();
  call.done(carom_body_create(world.get(), &desc, &actor.body, call), making);
  for (Part& part : actor.parts) {
    carom_collider_desc collider;
    call.done(carom_collider_desc_init(&collider, sizeof collider), making);
    collider.shape = part.shape == "half_space"     ? engine_.half_space(part.params.data(), part.params.at(3))
                     : part.shape == "height_field" ? engine_.height_field(part.params)
                     : part.shape == "mesh"         ? engine_.mesh(part.params)
                                                    : engine_.shape(part.shape, part.params);
    carom_material& material = materials_[{part.friction, part.restitution, static_cast<double>(part.friction_mix),
                                           static_cast<double>(part.restitution_mix), part.rolling, part.spinning}];
    if (material == CAROM_NULL_HANDLE) {
      carom_material_desc surface;
      call.done(carom_material_desc_init(&surface, sizeof surface), making);
      surface.friction = part.friction;
      surface.restitution = part.restitution;
      surface.friction_mix = part.friction_mix;
      surface.restitution_mix = part.restitution_mix;
      call.done(carom_material_create(world.get(), &surface, &material, call), making);
      if (part.rolling > 0 || part.spinning > 0)
        call.done(carom_material_set_resistance(world.get(), material, part.rolling, part.spinning, call), making);
    }
    collider.material = material;
    put(collider.position, part.position);
    put(collider.orientation, part.orientation);
    collider.density = part.density;
    call.done(carom_collider_create(world.get(), actor.body, &collider, &part.collider, call), making);
    if (part.surface_velocity != Vec::Zero() || part.surface_spin != Vec::Zero())
      call.done(carom_collider_set_surface_velocity(world.get(), part.collider, part.surface_velocity.data(),
                                                    part.surface_spin.data(), call),
                making);
  }
  actors.push_back(std::move(actor));
  return actors.size() - 1;
}

carom_joint Stage::join(std::uint32_t kind, std::size_t a, std::size_t b, const Vec& at, const Quat& axes) {
  Tie tie{kind, a, b, at, CAROM_NULL_HANDLE};
  carom_joint_desc desc;
  Call call;
  const std::string joining = "joining '" + actors.at(a).name + "' and '" + actors.at(b).name + "'";
  call.done(carom_joint_desc_init(&desc, sizeof desc), joining);
  desc.kind = kind;
  desc.fields = CAROM_JOINT_WORLD_FRAME;
  desc.body_a = actors[a].body, desc.body_b = actors[b].body;
  put(desc.position_a, at);
  put(desc.orientation_a, axes);
  call.done(carom_joint_create(world.get(), &desc, &tie.joint, call), joining);
  ties.push_back(tie);
  return tie.joint;
}

carom_joint Stage::join(const carom_joint_desc& desc, const std::string& joining) {
  carom_joint joint = CAROM_NULL_HANDLE;
  Call call;
  call.done(carom_joint_create(world.get(), &desc, &joint, call), joining);
  std::size_t end[2] = {actors.size(), actors.size()};
  for (std::size_t i = 0; i < actors.size(); ++i)
    for (int k = 0; k < 2; ++k)
      if (actors[i].body != CAROM_NULL_HANDLE && actors[i].body == (k ? desc.body_b : desc.body_a)) end[k] = i;
  if (end[0] < actors.size() && end[1] < actors.size())
    ties.push_back({desc.kind, end[0], end[1], position(end[0]) + orientation(end[0]) * Vec(desc.position_a), joint});
  return joint;
}

std::size_t Stage::add_half_space(const std::string& name, const Vec& normal, const Vec& point, double friction) {
  Actor actor;
  actor.name = name;
  actor.kind = "ground";
  actor.type = CAROM_BODY_STATIC;
  Part part;
  part.shape = "half_space";
  part.params = {normal.x(), normal.y(), normal.z(), normal.dot(point)};
  part.friction = friction;
  actor.parts.push_back(std::move(part));
  return add(std::move(actor));
}

void Stage::add_walled_ground(double half) {
  add_half_space("ground", {0, 1, 0}, {0, 0, 0});
  add_half_space("wall east", {-1, 0, 0}, {half, 0, 0});
  add_half_space("wall west", {1, 0, 0}, {-half, 0, 0});
  add_half_space("wall south", {0, 0, -1}, {0, 0, half});
  add_half_space("wall north", {0, 0, 1}, {0, 0, -half});
  bounds_min = Vec(-half - 1, -1, -half - 1);
  bounds_max = Vec(half + 1, 1e3, half + 1);
  ground_half_width = half;
}

std::size_t Stage::add_particles(std::vector<Actor> start, double mass) {
  const std::string making = "making " + std::to_string(start.size()) + " particles";
  carom_particles_desc desc;
  Call call;
  call.done(carom_particles_desc_init(&desc, sizeof desc), making);
  desc.mass = mass;
  carom_particles set = CAROM_NULL_HANDLE;
  call.done(carom_particles_create(world.get(), &desc, &set, call), making);
  std::vector<double> positions, velocities;
  for (const Actor& actor : start)
    for (int axis = 0; axis < 3; ++axis) {
      positions.push_back(actor.position[axis]);
      velocities.push_back(actor.linear_velocity[axis]);
    }
  call.done(carom_particles_add(world.get(), set, start.size(), CAROM_SCALAR_F64, positions.data(), 0,
                                velocities.data(), 0, call),
            making);
  const std::size_t first = actors.size();
  for (Actor& actor : start) {
    actor.particles = set;
    actor.index = static_cast<std::uint32_t>(actors.size() - first);
    actor.mass = mass;
    actors.push_back(std::move(actor));
  }
  return first;
}

namespace {

/// A field of bodies, of one particle: which of its own fields stands where in it.
struct ParticleField {
  std::uint32_t field;  // CAROM_FIELD_POSITION, LINEAR_VELOCITY or COUNT: none
  int unit_at;          // where the 1 of an orientation stands; -1: nowhere
};
ParticleField particle_field(std::uint32_t field) {
  if (field == CAROM_FIELD_POSITION) return {CAROM_FIELD_POSITION, -1};
  if (field == CAROM_FIELD_POSE) return {CAROM_FIELD_POSITION, 6};
  if (field == CAROM_FIELD_ORIENTATION) return {CAROM_FIELD_COUNT, 3};
  return {CAROM_FIELD_LINEAR_VELOCITY, -1};
}

/// @param n  actors from `first` on, of one set
void read_particles(const World& world, const Actor& first, std::size_t n, std::uint32_t field, double* dst) {
  const std::size_t width = field_width(field);
  const ParticleField own = particle_field(field);
  Call call;
  std::vector<std::uint32_t> indices;
  for (std::size_t i = 0; i < n; ++i) {
    indices.push_back(first.index + static_cast<std::uint32_t>(i));
    if (own.unit_at >= 0) dst[i * width + static_cast<std::size_t>(own.unit_at)] = 1;
  }
  if (own.field != CAROM_FIELD_COUNT)
    call.done(carom_particles_read(world.get(), first.particles, own.field, CAROM_SCALAR_F64, indices.data(), n, dst,
                                   width * sizeof(double), call),
              "reading particles");
}

/// @param dst  [n] records, 0
void read_actors(const World& world, const Actor* actors, std::size_t n, std::uint32_t field, double* dst) {
  const std::size_t width = field_width(field);
  std::vector<carom_body> bodies;
  for (std::size_t first = 0, end = 0; first < n; first = end) {
    bodies.clear();
    for (; end < n && actors[end].particles == actors[first].particles; ++end) bodies.push_back(actors[end].body);
    if (actors[first].particles != CAROM_NULL_HANDLE) {
      read_particles(world, actors[first], end - first, field, dst + first * width);
      continue;
    }
    Call call;
    call.done(carom_world_read(world.get(), field, CAROM_SCALAR_F64, bodies.data(), bodies.size(), dst + first * width,
                               0, call),
              "reading bodies");
  }
}

}  // namespace

Quat turn_between(const Vec& from, const Vec& to) {
  const Vec a = from.normalized(), b = to.normalized();
  const double twice_cosine = std::sqrt(2 * (1 + std::max(b.dot(a), -1.0)));  // of half the angle
  if (twice_cosine > 1e-6) {
    const Vec axis = a.cross(b) / twice_cosine;
    return Quat(twice_cosine / 2, axis.x(), axis.y(), axis.z());
  }
  const Vec across = a.cross(Vec::Unit(std::abs(a.x()) < 0.9 ? 0 : 1)).normalized();
  return Quat(0, across.x(), across.y(), across.z());
}

Vec Stage::position(std::size_t actor) const {
  Vec value = Vec::Zero();
  read_actors(world, &actors[actor], 1, CAROM_FIELD_POSITION, value.data());
  return value;
}

Quat Stage::orientation(std::size_t actor) const {
  Eigen::Vector4d value = Eigen::Vector4d::Zero();
  read_actors(world, &actors[actor], 1, CAROM_FIELD_ORIENTATION, value.data());
  return Quat(value);
}

Vec Stage::velocity(std::size_t actor) const {
  Vec value = Vec::Zero();
  read_actors(world, &actors[actor], 1, CAROM_FIELD_LINEAR_VELOCITY, value.data());
  return value;
}

void Stage::read(std::uint32_t field, std::vector<double>& dst) const {
  dst.assign(actors.size() * field_width(field), 0);
  read_actors(world, actors.data(), actors.size(), field, dst.data());
}

std::size_t Stage::particle_count() const {
  return static_cast<std::size_t>(std::count_if(
      actors.begin(), actors.end(), [](const Actor& actor) { return actor.particles != CAROM_NULL_HANDLE; }));
}

}  // namespace carom::tools
