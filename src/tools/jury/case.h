// What the jury judges: bodies, joints and where they are after each step, whichever engine moved them.
#pragma once

#include <optional>

#include "scenes/scene.h"

namespace carom::tools::jury {

/// A body as the judge knows it: one shape at the origin of its frame.
struct Member {
  std::string name;
  std::uint32_t type = CAROM_BODY_DYNAMIC;
  carom_shape shape = CAROM_NULL_HANDLE;
  bool is_plane = false;                              ///< a half-space
  bool is_heights = false;                            ///< a height field
  double mass = 0;                                    ///< kg; 0 unless dynamic
  Vec center = Vec::Zero();                           ///< m, body frame
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  ///< kg m^2, body axes, about the centre
  double radius = 0;                                  ///< m, about the origin: all of the shape is within it
  double size = 0;                                    ///< m, largest width
  double thickness = 0;                               ///< m, least width
  bool moves() const { return type == CAROM_BODY_DYNAMIC; }
};

/// A joint with its frames in the axes of its two bodies. Its x axis is the axis of a hinge and of a slider.
struct Link {
  std::uint32_t kind = CAROM_JOINT_BALL;
  std::size_t a = 0, b = 0;
  Vec at_a = Vec::Zero(), at_b = Vec::Zero();  ///< m
  Quat axes_a = Quat::Identity(), axes_b = Quat::Identity();
  bool limited = false;
  double lower = 0, upper = 0;  ///< m or rad
};

/// A kinematic body and how it goes: it spins at one speed, or swings to and fro.
struct Paddle {
  std::size_t member = 0;
  Vec spin = Vec::Zero();                      ///< rad/s, world
  Vec swing = Vec::Zero();                     ///< m, from the middle to either end
  double period = 1;                           ///< s
  Vec velocity(double from, double to) const;  ///< m/s, mean, such that it ends on its path
};

/// Heights over a grid, as CAROM's height fields have them: cells of two triangles.
struct Heights {
  std::size_t columns = 0, rows = 0;
  double spacing = 1;          ///< m
  Vec corner = Vec::Zero();    ///< m, world: of column 0, row 0
  std::vector<double> values;  ///< m, [rows][columns]
  /// Height and unit normal of the surface below or above a place; none beyond the boundary.
  struct At {
    double height;
    Vec normal;
  };
  std::optional<At> at(double x, double z) const;
};

struct State {
  Vec position = Vec::Zero();  ///< m, origin of the body frame
  Quat orientation = Quat::Identity();
  Vec velocity = Vec::Zero();  ///< m/s, of the centre of mass
  Vec omega = Vec::Zero();     ///< rad/s, world
};
using Frame = std::vector<State>;  ///< by member

/// A scene that was drawn, without the world that it stands in.
struct Case {
  std::uint64_t seed = 0;
  std::string summary;    ///< "17 bodies on ramps, 5 joints, a paddle"
  double gravity = 9.81;  ///< m/s^2, down along y
  double seconds = 5;
  double floor = 0;  ///< m: the lowest ground
  std::vector<Member> members;
  std::vector<Link> links;
  std::vector<Paddle> paddles;
  std::optional<Heights> heights;
};

/// A scene out of a seed: the same bits on every platform. Fills the stage and tells the judge what it is made of.
/// @param stage  empty
Case draw(std::uint64_t seed, Stage& stage);

}  // namespace carom::tools::jury
