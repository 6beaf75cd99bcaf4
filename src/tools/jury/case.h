// What the jury judges: bodies, joints and where they are after each step, whichever engine moved them.
#pragma once

#include <functional>
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
  Vec surface = Vec::Zero();                          ///< m/s, body axes: of its surface, while it stays (a belt)
  bool is_late = false;                               ///< not there until a deed adds it
  bool moves() const { return type == CAROM_BODY_DYNAMIC; }
  /// Whether its surface may give energy to what it touches.
  bool stirs() const { return type == CAROM_BODY_KINEMATIC || surface != Vec::Zero(); }
};

/// What drives a joint along the coordinate that its kind leaves free: a hinge's twist, a slider's slide.
struct Drive {
  enum class Aim { none, speed, place };
  Aim aim = Aim::none;
  double goal = 0;  ///< rad/s or m/s; rad or m
  double most = 0;  ///< N m or N
  /// Hz and a ratio, as CAROM_GAINS_FREQUENCY has them: of a place.
  double frequency = 0, damping = 1;
};

/// A joint with its frames in the axes of its two bodies. Its x axis is the axis of a hinge and of a slider.
struct Link {
  std::uint32_t kind = CAROM_JOINT_BALL;
  std::size_t a = 0, b = 0;
  Vec at_a = Vec::Zero(), at_b = Vec::Zero();  ///< m
  Quat axes_a = Quat::Identity(), axes_b = Quat::Identity();
  bool limited = false;
  double lower = 0, upper = 0;  ///< m or rad
  double swing = 0;             ///< rad: how far a ball's axes may part; 0: as far as they like
  Drive drive;
  carom_joint joint = CAROM_NULL_HANDLE;
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
  bool is_there = true;        ///< false: not yet, or no more
};
using Frame = std::vector<State>;  ///< by member

/// What a host does between two steps.
struct Deed {
  enum class What {
    put,     ///< a member to a pose, with velocities
    throws,  ///< a member: its velocities alone
    add,     ///< a member that is late
    remove,  ///< a member, and its joints with it
    pace,    ///< the step is `value` s from now on
    drive    ///< the goal of a link's drive is `value` from now on
  };
  double time = 0;  ///< s: before the first step that begins then or later
  What what = What::put;
  std::size_t who = 0;  ///< member, or link
  State state;
  double value = 0;
};

/// What a scene was built to do.
struct Goal {
  std::string what;            ///< "the gripper holds the box"
  double from = 0, until = 0;  ///< s
  bool once = false;           ///< at some time then; else at all times
  /// By how much it is missed, beyond what is borne; 0 or less: met.
  std::function<double(const Frame& start, const Frame& now)> missed_by;
  double plain = 0;  ///< from what miss on anybody sees it
  const char* unit = "m";
};

/// A scene that was drawn, without the world that it stands in.
struct Case {
  std::uint64_t seed = 0;
  std::string summary;    ///< "17 bodies on ramps, 5 joints, a paddle"
  double gravity = 9.81;  ///< m/s^2, down along y
  double seconds = 5;
  double dt = 1.0 / 60;        ///< s, of a step
  double least_stall = 0.002;  ///< s: no step that takes less is a stall
  bool built = false;          ///< people build such: jitter is judged
  double grace = 0;            ///< s from the start in which depths and gaps are not judged: it is made overlapped
  double stored = 0;           ///< J that the start holds beside what bodies weigh and how they move
  double floor = 0;            ///< m: the lowest ground
  std::vector<Member> members;
  std::vector<Link> links;
  std::vector<Paddle> paddles;
  std::optional<Heights> heights;
  std::vector<Deed> deeds;  ///< by time
  std::vector<Goal> goals;
  std::string family;  ///< of what is built
};

/// A scene out of a seed: the same bits on every platform. Fills the stage and tells the judge what it is made of.
/// @param stage  empty
Case draw(std::uint64_t seed, Stage& stage);

}  // namespace carom::tools::jury
