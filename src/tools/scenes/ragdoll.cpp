// ragdoll: people of eleven capsules, held together by ball joints and hinges with limits, fall down a flight of
// stairs.
#include <cmath>
#include <cstdio>
#include <numbers>

#include "scenes/scene.h"

namespace carom::tools {
namespace {

constexpr int kSteps = 8;
constexpr double kRise = 0.2, kTread = 0.35, kHalfWidth = 1.8;  // m, of the stairs
constexpr double kDegree = std::numbers::pi / 180;

/// A capsule, where it is as somebody stands at the origin and looks along z.
struct Bone {
  const char* name;
  Vec middle;           // m
  Vec along;            // unit
  double radius, half;  // m
};

struct Limits {
  double twist_from, twist_to, swing;  // degrees; swing of ball joints alone
};
const Vec kDown(0, -1, 0), kRight(1, 0, 0);

class Person {
 public:
  Person(Stage& stage, const Vec& at, const Vec& velocity, int number)
      : stage_(stage), at_(at), velocity_(velocity), number_(number) {
    const std::size_t pelvis = bone({"pelvis", {0, 0.95, 0}, kRight, 0.11, 0.07});
    const std::size_t chest = bone({"chest", {0, 1.28, 0}, kRight, 0.13, 0.09});
    const std::size_t head = bone({"head", {0, 1.58, 0}, kDown, 0.1, 0.04});
    ball(pelvis, chest, {0, 1.1, 0}, {-30, 30, 30});
    ball(chest, head, {0, 1.44, 0}, {-45, 45, 40});
    for (const double side : {-1.0, 1.0}) {
      const std::size_t arm = bone({"upper arm", {0.28 * side, 1.2, 0}, kDown, 0.05, 0.11});
      const std::size_t forearm = bone({"forearm", {0.28 * side, 0.9, 0}, kDown, 0.04, 0.11});
      const std::size_t thigh = bone({"thigh", {0.1 * side, 0.68, 0}, kDown, 0.07, 0.14});
      const std::size_t shin = bone({"shin", {0.1 * side, 0.26, 0}, kDown, 0.055, 0.15});
      ball(chest, arm, {0.28 * side, 1.36, 0}, {-60, 60, 100});
      hinge(arm, forearm, {0.28 * side, 1.05, 0}, {-140, 0, 0});
      ball(pelvis, thigh, {0.1 * side, 0.88, 0}, {-30, 30, 60});
      hinge(thigh, shin, {0.1 * side, 0.47, 0}, {0, 140, 0});
    }
  }

 private:
  std::size_t bone(const Bone& bone) {
    Actor actor;
    actor.kind = "bone";
    actor.name = std::string(bone.name) + " " + std::to_string(number_) + "." + std::to_string(stage_.actors.size());
    actor.position = at_ + bone.middle;
    actor.orientation = turn_between(Vec::UnitY(), bone.along);  // a capsule lies along y
    actor.linear_velocity = velocity_;
    Part part;
    part.shape = "capsule", part.params = {bone.radius, bone.half};
    actor.parts.push_back(std::move(part));
    return stage_.add(std::move(actor));
  }
  void limit(carom_joint joint, std::uint32_t coordinate, double lower, double upper) {
    carom_joint_limit limit;
    Call call;
    call.done(carom_joint_limit_init(&limit, sizeof limit), "limiting a joint");
    limit.enabled = 1, limit.lower = lower * kDegree, limit.upper = upper * kDegree;
    call.done(carom_joint_set_limit(stage_.world.get(), joint, coordinate, &limit, call), "limiting a joint");
  }
  /// Twist about the bone that hangs on it, swing away from straight.
  void ball(std::size_t a, std::size_t b, const Vec& at, const Limits& limits) {
    const carom_joint joint = stage_.join(CAROM_JOINT_BALL, a, b, at_ + at, turn_between(Vec::UnitX(), kDown));
    limit(joint, CAROM_COORDINATE_TWIST, limits.twist_from, limits.twist_to);
    limit(joint, CAROM_COORDINATE_SWING, 0, limits.swing);
  }
  /// About the axis from side to side: what hangs down comes forwards by angles below 0.
  void hinge(std::size_t a, std::size_t b, const Vec& at, const Limits& limits) {
    limit(stage_.join(CAROM_JOINT_HINGE, a, b, at_ + at), CAROM_COORDINATE_TWIST, limits.twist_from, limits.twist_to);
  }

  Stage& stage_;
  Vec at_, velocity_;
  int number_;
};

/// How far joints gape and limits give way. By the direct solver they don't; where `auto` leaves a person who hits the
/// stairs to springs, a joint gapes for a moment.
class RagdollObserver : public Observer {
 public:
  void watch(const Stage& stage, double) override {
    gap_now_ = 0;
    for (const Tie& tie : stage.ties) {
      Call call;
      carom_joint_state state{};
      state.struct_size = sizeof state;
      call.done(carom_joint_get_state(stage.world.get(), tie.joint, &state, call), "reading a joint");
      gap_now_ = std::max(gap_now_, state.gap);
      gap_ = std::max(gap_, state.gap), angle_ = std::max(angle_, state.angle);
    }
  }
  std::vector<std::string> tell(const Stage& stage) const override {
    char text[200];
    std::snprintf(
        text, sizeof text,
        "joints gaped by at most %.2g mm, by %.2g mm at the end; axes and limits gave way by at most %.2g degrees",
        1e3 * gap_, 1e3 * gap_now_, angle_ / kDegree);
    std::vector<std::string> lines{text};
    std::snprintf(text, sizeof text, "the fastest bone moves at %.2g m/s", fastest(stage));
    lines.emplace_back(text);
    return lines;
  }
  bool came_off(const Stage& stage) const override {
    double lowest = INFINITY, highest = 0;
    for (std::size_t i = 0; i < stage.actors.size(); ++i)
      if (stage.actors[i].type == CAROM_BODY_DYNAMIC)
        lowest = std::min(lowest, stage.position(i).y()), highest = std::max(highest, stage.position(i).y());
    return gap_now_ < 1e-3 && fastest(stage) < 0.1 && lowest > 0 && highest < kSteps * kRise + 1;
  }

 private:
  static double fastest(const Stage& stage) {
    double most = 0;
    for (std::size_t i = 0; i < stage.actors.size(); ++i)
      if (stage.actors[i].type == CAROM_BODY_DYNAMIC) most = std::max(most, stage.velocity(i).norm());
    return most;
  }

  double gap_ = 0, gap_now_ = 0, angle_ = 0;
};

std::unique_ptr<Observer> fill(Stage& stage, const std::vector<double>& knobs, const std::string&) {
  stage.add_half_space("ground", {0, 1, 0}, {0, 0, 0});
  for (int i = 0; i < kSteps; ++i) {
    Actor step;
    step.kind = "step", step.name = "step " + std::to_string(i + 1);
    step.type = CAROM_BODY_STATIC;
    const double height = kRise * (i + 1), depth = i + 1 == kSteps ? 4 : kTread;  // the last is a landing
    step.position = Vec(0, height / 2, -kTread * i - depth / 2);
    Part part;
    part.shape = "box", part.params = {kHalfWidth, height / 2, depth / 2};
    step.parts.push_back(std::move(part));
    stage.add(std::move(step));
  }
  const double top = kRise * kSteps, edge = -kTread * (kSteps - 1);
  for (int i = 0; i < static_cast<int>(knobs[0]); ++i) {
    const Vec at(0.9 * (i % 3 - 1), top + 0.05 + 2 * (i / 9), edge - 0.4 - 1.0 * (i / 3 % 3));
    Person(stage, at, Vec(0, 0, knobs[1] + 0.1 * (i % 3)), i + 1);
  }
  stage.bounds_min = Vec(-20, -0.5, -20), stage.bounds_max = Vec(20, 100, 20);
  stage.ground_half_width = 4;
  stage.camera_from = Vec(3.5, 3, 6), stage.camera_to = Vec(0, 0.8, -1);
  return std::make_unique<RagdollObserver>();
}

}  // namespace

Scene ragdoll_scene() {
  return {"ragdoll",
          "People of eleven capsules, ten joints each, tumble down a flight of stairs.",
          "joints that stay shut, knees and elbows that bend one way, and all come to rest",
          {{"n", "", "number of people", 3, 1, 200, true}, {"push", "m/s", "forwards at first", 2, 0, 10}},
          8.0,
          1.0 / 60,
          fill};
}

}  // namespace carom::tools
