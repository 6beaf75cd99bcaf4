// The bodies of a stage as every other engine is given them, and the way back from their frames to the stage's.
#pragma once

#include <deque>
#include <map>
#include <vector>

#include "peer.h"
#include "scenes/scene.h"

namespace carom::bench {

using tools::Quat;
using tools::Vec;

inline Eigen::Map<const Vec> vec(const double (&x)[3]) { return Eigen::Map<const Vec>(x); }
inline Quat quat(const double (&q)[4]) { return Quat(q); }  // x, y, z, w

/// An actor of a stage, with its masses as Carom uses them.
struct Member {
  Solid solid = Solid::none;
  carom_shape shape = CAROM_NULL_HANDLE;  // null: a particle
  bool is_static = false;
  double radius = 0;                                  // m, about the body's origin
  double mass = 0;                                    // kg
  Vec center = Vec::Zero();                           // m, body frame
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  // kg m^2, body frame, about the centre
  Quat axes = Quat::Identity();                       // principal axes to body frame
};

/// Bodies have at most one part each, at the body's origin: a shape that a module knows, or none.
class Plan {
 public:
  /// @param as_given  with the stage's restitution and gravity, and its world's joints, the stage knowing of them or not;
  ///                  else as the S-table has it: no restitution, 9.81 m/s^2, the stage's own ties
  /// @throws Error if an actor has several parts, or a shape or a joint that no engine is asked for
  explicit Plan(tools::Stage& stage, bool as_given = false);

  /// For another engine; lives as long as this plan.
  WorldPlan world(bool sleeping) const;
  /// The same bodies, somewhere else and at rest.
  /// @param states  [actors] the stage's body frames
  void start_at(const std::vector<BodyState>& states);
  /// Principal frames about the centres of mass, as other engines answer, to the stage's body frames.
  /// @param states  [actors]
  void to_body_frames(std::vector<BodyState>& states) const;

  tools::Stage& stage() const { return stage_; }
  const std::vector<Member>& members() const { return members_; }
  const std::vector<JointPlan>& joints() const { return joints_; }

 private:
  struct Hull {
    std::vector<double> xyz;
    std::vector<std::uint32_t> triangles;
  };

  void add(const tools::Actor& actor);
  void add(const tools::Tie& tie);
  void add(carom_joint joint);
  void place_slider(const carom_joint_desc& joint, JointPlan& plan) const;
  void drive_slider(carom_joint joint, JointPlan& plan) const;
  void describe_shape(const tools::Part& part, const Member& member, BodyPlan& plan);

  tools::Stage& stage_;
  bool as_given_;
  double gravity_[3] = {0, -9.81, 0};  // m/s^2
  std::vector<Member> members_;        // [actors]
  std::vector<BodyPlan> plans_;        // [actors]
  std::vector<JointPlan> joints_;
  std::map<carom_shape, Hull> hulls_;
  std::map<carom_shape, const double*> params_;  // shared by bodies of equal shape
};

}  // namespace carom::bench
