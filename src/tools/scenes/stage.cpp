// Turns a scene's description of a body into calls of the C ABI, and answers where it is.
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
  call.done(carom_body_desc_init(&desc), making);
  desc.type = actor.type;
  put(desc.position, actor.position);
  put(desc.orientation, actor.orientation);
  put(desc.linear_velocity, actor.linear_velocity);
  put(desc.angular_velocity, actor.angular_velocity);
  if (actor.mass > 0) {
    desc.mass = actor.mass;
    desc.fields |= CAROM_BODY_FIELD_MASS;
  }
  desc.user = actors.size();
  call.done(carom_body_create(world.get(), &desc, &actor.body, call), making);
  for (const Part& part : actor.parts) {
    carom_collider_desc collider;
    call.done(carom_collider_desc_init(&collider), making);
    collider.shape = part.shape == "half_space" ? engine_.half_space(part.params.data(), part.params.at(3))
                                                : engine_.shape(part.shape, part.params);
    carom_material& material = materials_[{part.friction, part.restitution}];
    if (material == CAROM_NULL_HANDLE) {
      carom_material_desc surface;
      call.done(carom_material_desc_init(&surface), making);
      surface.friction = part.friction;
      surface.restitution = part.restitution;
      call.done(carom_material_create(world.get(), &surface, &material, call), making);
    }
    collider.material = material;
    put(collider.position, part.position);
    put(collider.orientation, part.orientation);
    collider.density = part.density;
    carom_collider handle = CAROM_NULL_HANDLE;
    call.done(carom_collider_create(world.get(), actor.body, &collider, &handle, call), making);
  }
  actors.push_back(std::move(actor));
  return actors.size() - 1;
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

namespace {

template <int N>
Eigen::Matrix<double, N, 1> read_one(const World& world, std::uint32_t field, carom_body body) {
  Eigen::Matrix<double, N, 1> value;
  Call call;
  call.done(carom_world_read(world.get(), field, CAROM_SCALAR_F64, &body, 1, value.data(), 0, call), "reading a body");
  return value;
}

}  // namespace

Vec Stage::position(std::size_t actor) const { return read_one<3>(world, CAROM_FIELD_POSITION, actors[actor].body); }

Quat Stage::orientation(std::size_t actor) const {
  return Quat(read_one<4>(world, CAROM_FIELD_ORIENTATION, actors[actor].body));
}

Vec Stage::velocity(std::size_t actor) const {
  return read_one<3>(world, CAROM_FIELD_LINEAR_VELOCITY, actors[actor].body);
}

}  // namespace carom::tools
