// The hand that builds: bodies by kind, place and stuff; joints with limits and drives; what a host does, what is asked for.
#pragma once

#include "jury/drawing.h"

namespace carom::tools::jury {

struct Stuff {
  double density = 1000;  ///< kg/m^3
  double friction = 0.6, restitution = 0;
};

/// Cosine and sine of an angle, from -pi to pi, by a series: alike on every platform, to 2e-15.
struct Turned {
  double cos, sin;
};
Turned turned_by(double angle);
Quat about(const Vec& axis, double angle);  ///< from -pi to pi   @param axis  unit

/// Set in the world what a link's drive says.
void set_drive(Stage& stage, const Link& link);

class Builder {
 public:
  Builder(std::uint64_t seed, Stage& stage) : drawing_(seed, stage), random(drawing_.random), scene(drawing_.scene) {
    scene.built = true, scene.least_stall = 0.016;
  }

 private:
  Drawing drawing_;

 public:
  Random& random;
  Case& scene;

  double between(double low, double high) { return random.between(low, high); }
  int count(int low, int high) {
    return low + static_cast<int>(drawing_.pick(static_cast<std::size_t>(high - low + 1)));
  }
  bool chance(double share) { return drawing_.chance(share); }
  /// From low to high, each doubling as likely as another.
  double scale(double low, double high);

  /// Where what follows is built: places, turns and velocities are relative to it.
  void stand(const Vec& origin, const Quat& turned = Quat::Identity(), const Vec& velocity = Vec::Zero());

  std::size_t ground(double friction);
  /// @param kind  its name, with a number behind it   @param shape  of a plugin
  std::size_t add(const std::string& kind, const std::string& shape, const std::vector<double>& params, const Vec& at,
                  const Stuff& stuff, const Quat& turned = Quat::Identity(), std::uint32_t type = CAROM_BODY_DYNAMIC);
  std::size_t box(const std::string& kind, const Vec& half, const Vec& at, const Stuff& stuff,
                  const Quat& turned = Quat::Identity()) {
    return add(kind, "box", {half.x(), half.y(), half.z()}, at, stuff, turned);
  }
  std::size_t fixed(const std::string& kind, const Vec& half, const Vec& at, const Stuff& stuff = {},
                    const Quat& turned = Quat::Identity()) {
    return add(kind, "box", {half.x(), half.y(), half.z()}, at, stuff, turned, CAROM_BODY_STATIC);
  }
  std::size_t ball(const std::string& kind, double radius, const Vec& at, const Stuff& stuff) {
    return add(kind, "sphere", {radius}, at, stuff);
  }
  /// A capsule whose ends are round about two points.
  std::size_t rod(const std::string& kind, double radius, const Vec& from, const Vec& to, const Stuff& stuff);
  /// A cylinder that turns about z, or about another axis.
  std::size_t wheel(const std::string& kind, double radius, double half_width, const Vec& at, const Stuff& stuff,
                    const Vec& axis = Vec::UnitZ(), std::uint32_t type = CAROM_BODY_DYNAMIC);
  /// A surface that moves though its body stays.
  std::size_t belt(const Vec& half, const Vec& at, const Vec& speed, double friction, const Quat& turned);

  /// @param axis  x of the joint   @return the link's index
  std::size_t join(std::uint32_t kind, std::size_t a, std::size_t b, const Vec& at, const Vec& axis = Vec::UnitX());
  std::size_t hinge(std::size_t a, std::size_t b, const Vec& at, const Vec& axis = Vec::UnitZ()) {
    return join(CAROM_JOINT_HINGE, a, b, at, axis);
  }
  std::size_t slider(std::size_t a, std::size_t b, const Vec& at, const Vec& axis) {
    return join(CAROM_JOINT_SLIDER, a, b, at, axis);
  }
  std::size_t socket(std::size_t a, std::size_t b, const Vec& at, const Vec& axis = Vec::UnitX()) {
    return join(CAROM_JOINT_BALL, a, b, at, axis);
  }
  void limit(std::size_t link, double lower, double upper);
  void limit_swing(std::size_t link, double most);
  void run(std::size_t link, double speed, double most);  ///< rad/s or m/s, N m or N
  /// To a place, by a spring; no stiffer than 30 Hz of its two bodies alone, which is what a substep of 8 ms bears.
  /// @param stiffness  N/m or N m/rad   @param damping  1: critical   @param most  N or N m
  void aim(std::size_t link, double place, double stiffness, double damping, double most);

  void deed(double time, Deed::What what, std::size_t who, double value);
  void deed(double time, Deed::What what, std::size_t who, const State& state);
  /// From one goal of a drive to another, slowly at both ends, in steps of a sixtieth of a second.
  void lead(std::size_t link, double from, double to, double begin, double end);
  void ask(Goal goal) { scene.goals.push_back(std::move(goal)); }
  /// What was built stays where it is, to the end.   @param borne, plain  m
  void ask_to_stay(const std::string& what, const std::vector<std::size_t>& members, double borne, double plain);
  /// A body that is there only from a deed on.
  void make_late(std::size_t member, double time, const State& state);

  double mass(std::size_t member) const { return scene.members[member].mass; }
  const Actor& actor(std::size_t member) { return drawing_.stage().actors[member]; }
  std::size_t members() const { return scene.members.size(); }
  std::vector<std::size_t> since(std::size_t first) const;  ///< members that move, from one on

 private:
  std::size_t place(Actor actor);

  Vec origin_ = Vec::Zero(), velocity_ = Vec::Zero();
  Quat turned_ = Quat::Identity();
};

// The families. Each fills the scene, says what is asked of it and gives it a summary.
void draw_vehicle(Builder& b);
void draw_track(Builder& b);
void draw_bridge(Builder& b);
void draw_net(Builder& b);
void draw_doll(Builder& b);
void draw_walker(Builder& b);
void draw_gripper(Builder& b);
void draw_door(Builder& b);
void draw_cards(Builder& b);
void draw_stack(Builder& b);
void draw_overlap(Builder& b);
void draw_cradle(Builder& b);
void draw_crane(Builder& b);
void draw_linkage(Builder& b);
void draw_conveyor(Builder& b);
void draw_meddler(Builder& b);

}  // namespace carom::tools::jury
