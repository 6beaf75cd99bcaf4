// A plank that rocks on an axle by contact alone: there are no joints, a notch under the plank holds it in place.
#pragma once

#include "scenes/scene.h"

namespace carom::tools {

/// The lever lies along x, its axle along z. Its body frame has the axle's axis as origin, x along the plank.
struct Lever {
  static constexpr double kWall = 0.03;  ///< m, half thickness of the seat's walls
  double left = 2, right = 2;            ///< m, arms from the axle to the ends
  double half_thickness = 0.04;          ///< m
  double half_width = 0.35;              ///< m, along z
  double axle_radius = 0.12;             ///< m
  double density = 500;                  ///< kg/m^3
  double sine = 0.28;                    ///< of the tilt at the start, left end down; cosine follows
  double ledge = 0.2;             ///< m, height of the seat's walls at the left end: one across, one on either side
  double seat_half_width = 0.25;  ///< m, between the side walls; loads sit between them, against the ledge
  double seat_length = 0.5;       ///< m, of the side walls
  Vec axle = Vec::Zero();         ///< m, world; place_on_ground() sets its height

  /// Height of the axle at which the left end's underside just clears the ground.
  void place_on_ground();
  double cosine() const;
  Quat tilt() const;                     ///< lever to world at the start
  Vec to_world(const Vec& local) const;  ///< at the start
  /// @return m, body frame: where a load of half length `half` along x, half height `up`, sits against the ledge
  Vec seat(double half, double up, double z) const { return {-left + 2 * kWall + half + 0.003, top() + up + 0.003, z}; }
  double top() const { return axle_radius + 2 * half_thickness; }  ///< m, body frame: y of the plank's upper face

  /// Adds the plank (dynamic), the axle and its two stands (static).   @return actor index of the plank
  std::size_t add_to(Stage& stage) const;
};

}  // namespace carom::tools
