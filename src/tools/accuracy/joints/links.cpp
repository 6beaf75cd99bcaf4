// Bodies made through the C ABI with a mass and an inertia of their own.
#include "accuracy/joints/links.h"

#include <algorithm>

#include "accuracy/reference.h"

namespace carom::tools::accuracy {

Vec inertia_of_rod(double length, double mass) {
  const double thick = 0.02 * length, across = length * length + thick * thick;
  return mass / 12 * Vec(2 * thick * thick, across, across);
}

Vec inertia_of_ball(double radius, double mass) { return Vec::Constant(0.4 * mass * radius * radius); }

std::size_t add_link(Stage& stage, const std::string& kind, const Vec& position, double mass, const Vec& inertia,
                     const Part& looks, const Quat& orientation) {
  Actor actor;
  actor.kind = kind;
  actor.name = kind + " " + std::to_string(stage.actors.size() + 1);
  actor.position = position, actor.orientation = orientation, actor.mass = mass;
  Call call;
  carom_body_desc desc;
  call.done(carom_body_desc_init(&desc, sizeof desc), "making " + actor.name);
  for (int k = 0; k < 3; ++k) desc.position[k] = position[k], desc.inertia[4 * k] = inertia[k];
  for (int k = 0; k < 4; ++k) desc.orientation[k] = orientation.coeffs()[k];
  desc.mass = mass;
  desc.user = stage.actors.size();
  desc.fields = CAROM_BODY_FIELD_MASS | CAROM_BODY_FIELD_INERTIA;
  call.done(carom_body_create(stage.world.get(), &desc, &actor.body, call), "making " + actor.name);
  actor.parts.push_back(looks);
  stage.actors.push_back(std::move(actor));
  return stage.actors.size() - 1;
}

std::size_t add_rod(Stage& stage, const Vec& position, double length, double mass) {
  Part looks;
  looks.shape = "box";
  looks.params = {length / 2, 0.01 * length, 0.01 * length};
  return add_link(stage, "rod", position, mass, inertia_of_rod(length, mass), looks);
}

std::size_t add_bob(Stage& stage, const Vec& position, double radius, double mass) {
  Part looks;
  looks.shape = "sphere";
  looks.params = {radius};
  return add_link(stage, "bob", position, mass, inertia_of_ball(radius, mass), looks);
}

carom_joint join(Stage& stage, std::uint32_t kind, carom_body a, carom_body b, const Vec& at, const Quat& axes) {
  Call call;
  carom_joint_desc desc;
  carom_joint joint = CAROM_NULL_HANDLE;
  call.done(carom_joint_desc_init(&desc, sizeof desc), "joining");
  desc.kind = kind, desc.body_a = a, desc.body_b = b;
  desc.fields = CAROM_JOINT_WORLD_FRAME;
  for (int k = 0; k < 3; ++k) desc.position_a[k] = at[k];
  for (int k = 0; k < 4; ++k) desc.orientation_a[k] = axes.coeffs()[k];
  call.done(carom_joint_create(stage.world.get(), &desc, &joint, call), "joining");
  return joint;
}

double Mechanism::energy(const Stage& stage) const {
  std::vector<double> velocity;
  stage.read(CAROM_FIELD_VELOCITY, velocity);
  double e = 0;
  for (const Member& m : members_) {
    const Eigen::Map<const Vec> v(velocity.data() + 6 * m.actor), w(velocity.data() + 6 * m.actor + 3);
    const Vec spin = stage.orientation(m.actor).conjugate() * w;
    e += m.mass * (0.5 * v.squaredNorm() + kGravity * stage.position(m.actor).y()) +
         0.5 * spin.dot(m.inertia.cwiseProduct(spin));
  }
  return e;
}

double Mechanism::worst_gap(const Stage& stage) const {
  double worst = 0;
  for (const carom_joint joint : joints_) {
    Call call;
    carom_joint_state state{};
    state.struct_size = sizeof state;
    call.done(carom_joint_get_state(stage.world.get(), joint, &state, call), "reading a joint");
    worst = std::max(worst, state.gap);
  }
  return worst;
}

}  // namespace carom::tools::accuracy
