// What accuracy scenes are built of: balls, boxes, and a look at many bodies at once.
#pragma once

#include "accuracy/challenge.h"

namespace carom::tools::accuracy {

struct Surface {
  double friction = 0, restitution = 0;
};

/// A body of one shape.   @return index into stage.actors; likewise below
std::size_t add_solid(Stage& stage, const std::string& shape, std::vector<double> params, const Vec& position,
                      double mass, const Surface& surface, const Vec& velocity = Vec::Zero(),
                      const Quat& orientation = Quat::Identity());
std::size_t add_ball(Stage& stage, const Vec& position, double radius, double mass, const Surface& surface,
                     const Vec& velocity = Vec::Zero());
std::size_t add_box(Stage& stage, const Vec& position, const Vec& half_extents, double mass, const Surface& surface,
                    const Vec& velocity = Vec::Zero(), const Quat& orientation = Quat::Identity());
/// Spin a body about its centre, which moves with `velocity`.   @param spin  rad/s, world
void set_moving(Stage& stage, std::size_t actor, const Vec& velocity, const Vec& spin);
/// @param g  m/s^2, along -y; 9.81 in a new world
void set_gravity(Stage& stage, double g);
/// Planks of 117 x 7.8 x 23.4 mm on the ground at the origin, three to a layer, each layer across the one below.
void add_plank_tower(Stage& stage, int layers);
inline const Vec kPlankHalf(0.0585, 0.0039, 0.0117);  // m
/// Level ground at y = 0. A contact's friction is the geometric mean of both sides', its restitution the larger one.
void add_ground(Stage& stage, double friction);

/// Positions and velocities of all dynamic bodies of a stage, in its order, read in bulk.
class Crowd {
 public:
  /// Of the bodies that the stage has now; where they are now is home.
  explicit Crowd(const Stage& stage);
  void look(const Stage& stage);

  std::size_t size() const { return handles_.size(); }
  Vec home(std::size_t i) const { return homes_.segment<3>(3 * static_cast<Eigen::Index>(i)); }
  Vec position(std::size_t i) const { return Eigen::Map<const Vec>(positions_.data() + 3 * i); }
  Vec velocity(std::size_t i) const { return Eigen::Map<const Vec>(velocities_.data() + 6 * i); }
  Vec spin(std::size_t i) const { return Eigen::Map<const Vec>(velocities_.data() + 6 * i + 3); }

 private:
  std::vector<carom_body> handles_;
  std::vector<double> positions_, velocities_;
  Eigen::VectorXd homes_;
};

}  // namespace carom::tools::accuracy
