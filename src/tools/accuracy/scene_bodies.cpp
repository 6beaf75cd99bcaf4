// What accuracy scenes are built of.
#include "accuracy/scene_bodies.h"

namespace carom::tools::accuracy {

std::size_t add_solid(Stage& stage, const std::string& shape, std::vector<double> params, const Vec& position,
                      double mass, const Surface& surface, const Vec& velocity, const Quat& orientation) {
  Actor actor;
  actor.kind = shape;
  actor.name = shape + " " + std::to_string(stage.actors.size());
  actor.position = position;
  actor.orientation = orientation;
  actor.linear_velocity = velocity;
  actor.mass = mass;
  Part part;
  part.shape = shape;
  part.params = std::move(params);
  part.friction = surface.friction;
  part.restitution = surface.restitution;
  actor.parts.push_back(std::move(part));
  return stage.add(std::move(actor));
}

std::size_t add_ball(Stage& stage, const Vec& position, double radius, double mass, const Surface& surface,
                     const Vec& velocity) {
  return add_solid(stage, "sphere", {radius}, position, mass, surface, velocity, Quat::Identity());
}

std::size_t add_box(Stage& stage, const Vec& position, const Vec& half_extents, double mass, const Surface& surface,
                    const Vec& velocity, const Quat& orientation) {
  return add_solid(stage, "box", {half_extents.x(), half_extents.y(), half_extents.z()}, position, mass, surface,
                   velocity, orientation);
}

void set_moving(Stage& stage, std::size_t actor, const Vec& velocity, const Vec& spin) {
  Call call;
  call.done(carom_body_set_velocity(stage.world.get(), stage.actors[actor].body, velocity.data(), spin.data(), call),
            "moving " + stage.actors[actor].name);
}

void set_gravity(Stage& stage, double g) {
  const double down[3] = {0, -g, 0};
  Call call;
  call.done(carom_world_set_gravity(stage.world.get(), down, call), "setting gravity");
}

void add_plank_tower(Stage& stage, int layers) {
  constexpr double kMass = 0.012;                        // kg: pine
  constexpr double kQuarter = 0.707106781186547524;      // cosine and sine of half a right angle
  const double apart = kPlankHalf.x() - kPlankHalf.z();  // the outer ones end flush with the layer below
  for (int layer = 0; layer < layers; ++layer)
    for (int i : {-1, 0, 1}) {
      const double height = kPlankHalf.y() * (2 * layer + 1);
      const bool across = layer % 2 != 0;
      add_box(stage, across ? Vec(i * apart, height, 0) : Vec(0, height, i * apart), kPlankHalf, kMass, {0.5, 0},
              Vec::Zero(), across ? Quat(kQuarter, 0, kQuarter, 0) : Quat::Identity());
    }
}

void add_ground(Stage& stage, double friction) { stage.add_half_space("ground", {0, 1, 0}, {0, 0, 0}, friction); }

Crowd::Crowd(const Stage& stage) {
  for (const Actor& actor : stage.actors)
    if (actor.type == CAROM_BODY_DYNAMIC) handles_.push_back(actor.body);
  look(stage);
  homes_ = Eigen::Map<const Eigen::VectorXd>(positions_.data(), static_cast<Eigen::Index>(positions_.size()));
}

void Crowd::look(const Stage& stage) {
  stage.world.read(CAROM_FIELD_POSITION, handles_, positions_);
  stage.world.read(CAROM_FIELD_VELOCITY, handles_, velocities_);
}

}  // namespace carom::tools::accuracy
