// reach: a robot's arm with a load in its hand is driven to a mark.
#include <cmath>
#include <numbers>

#include "accuracy/joints/links.h"
#include "accuracy/linkages.h"

namespace carom::tools::accuracy {
namespace {

constexpr double kSeconds = 4, kPart = 1e-4;  // s; of the steps in which the truth is integrated
const Quat kAboutZ(Eigen::AngleAxisd(-std::numbers::pi / 2, Vec::UnitY()));  // a hinge turns about its x

Quat turned(double angle) { return Quat(Eigen::AngleAxisd(angle, Vec::UnitZ())); }

/// The hand against the equations of motion, which are integrated by the classical fourth-order method.
class ReachTrial : public Trial {
 public:
  /// @param upper  the upper arm; the forearm and the load are next
  ReachTrial(std::size_t upper, const ReachingArm& arm, Mechanism hinges)
      : upper_(upper), arm_(arm), hinges_(std::move(hinges)) {}

  void watch(const Stage& stage, double time) override {
    const int parts = std::max(1, static_cast<int>(std::ceil((time - time_) / kPart)));
    for (int i = 0; i < parts; ++i)
      state_ = runge_kutta(state_, (time - time_) / parts, [&](const Eigen::Vector4d& s) { return arm_.rate(s); });
    time_ = time;
    const Vec hand = stage.position(upper_ + 2);
    worst_ = std::max(worst_, (hand - ReachingArm::hand(state_[0], state_[1])).norm());
    off_ = (hand - ReachingArm::hand(ReachingArm::kAtMark[0], ReachingArm::kAtMark[1])).norm();
    gap_ = std::max(gap_, hinges_.worst_gap(stage));
  }
  std::vector<double> errors(const Stage&) const override { return {worst_, off_, gap_}; }
  std::vector<TruePose> truth(double) const override {
    const Vec shoulder(0, ReachingArm::kShoulder, 0), elbow = ReachingArm::elbow(state_[0]),
                                                      hand = ReachingArm::hand(state_[0], state_[1]);
    return {{upper_, (shoulder + elbow) / 2, turned(state_[0])},
            {upper_ + 1, (elbow + hand) / 2, turned(state_[1])},
            {upper_ + 2, hand, turned(state_[1])}};
  }

 private:
  std::size_t upper_;
  ReachingArm arm_;
  Mechanism hinges_;
  Eigen::Vector4d state_ = Eigen::Vector4d::Zero();
  double time_ = 0, worst_ = 0, off_ = 0, gap_ = 0;
};

/// A drive of fixed gains.   @param joint  a hinge
void drive(Stage& stage, carom_joint joint, double target, double stiff, double damp) {
  Call call;
  carom_joint_axis axis;
  call.done(carom_joint_axis_init(&axis, sizeof axis), "driving a hinge");
  axis.drive = CAROM_DRIVE_POSITION, axis.drive_gains = CAROM_GAINS_FORCE;
  axis.target = target, axis.drive_stiffness = stiff, axis.drive_damping = damp;
  call.done(carom_joint_set_axis(stage.world.get(), joint, CAROM_AXIS_TURN_X, &axis, call), "driving a hinge");
}

/// What stands and is only looked at.
void stand(Stage& stage, const std::string& kind, const Vec& position, Part looks) {
  Actor actor;
  actor.kind = actor.name = kind, actor.type = CAROM_BODY_STATIC, actor.position = position;
  stage.actors[stage.add(std::move(actor))].parts.push_back(std::move(looks));
}

Part drawn(const std::string& shape, std::vector<double> params) {
  Part looks;
  looks.shape = shape, looks.params = std::move(params);
  return looks;
}

std::unique_ptr<Observer> fill(Stage& stage, const std::vector<double>& knobs, const std::string&) {
  using A = ReachingArm;
  const A arm{knobs[0]};
  const Vec shoulder(0, A::kShoulder, 0), elbow = A::elbow(0), hand = A::hand(0, 0);
  // Along the rod alone the arm never turns.
  const auto rod = [](double mass, double length) -> Vec { return Vec(0.02, 1, 1) * (mass * length * length / 12); };
  stand(stage, "foot", Vec(0, A::kShoulder / 2, 0), drawn("cylinder", {0.1, A::kShoulder / 2}));
  const Vec mark = A::hand(A::kAtMark[0], A::kAtMark[1]);
  const double post = (mark.y() - A::kRadius) / 2;  // the load is to rest on its end
  stand(stage, "mark", Vec(mark.x(), post, 0), drawn("cylinder", {0.04, post}));
  const std::size_t upper = add_link(stage, "upper arm", (shoulder + elbow) / 2, A::kUpperMass,
                                     rod(A::kUpperMass, A::kUpper), drawn("box", {A::kUpper / 2, 0.05, 0.05}));
  const std::size_t fore = add_link(stage, "forearm", (elbow + hand) / 2, A::kForeMass, rod(A::kForeMass, A::kFore),
                                    drawn("box", {A::kFore / 2, 0.035, 0.035}));
  const std::size_t load =
      add_link(stage, "load", hand, arm.load, inertia_of_ball(A::kRadius, arm.load), drawn("sphere", {A::kRadius}));
  const auto body = [&](std::size_t actor) { return stage.actors[actor].body; };
  const carom_joint joints[] = {join(stage, CAROM_JOINT_HINGE, CAROM_NULL_HANDLE, body(upper), shoulder, kAboutZ),
                                join(stage, CAROM_JOINT_HINGE, body(upper), body(fore), elbow, kAboutZ),
                                join(stage, CAROM_JOINT_WELD, body(fore), body(load), hand)};
  const auto targets = arm.targets();
  for (std::size_t i = 0; i < 2; ++i) drive(stage, joints[i], targets[i], A::kStiff[i], A::kDamp[i]);
  Mechanism hinges;
  for (const carom_joint joint : joints) hinges.add(joint);
  stage.camera_from = Vec(0.9, 1.4, 4.5), stage.camera_to = Vec(0.9, 1.1, 0);
  return std::make_unique<ReachTrial>(upper, arm, std::move(hinges));
}

}  // namespace

Challenge reach_challenge() {
  return {53,
          {"reach",
           "A robot's arm that carries 15 kg in its hand is driven to a mark.",
           "a hand that goes the way it should, and ends at the mark",
           {{"load", "kg", "in the hand", 15, 0.1, 60}},
           kSeconds,
           1.0 / 60,
           fill},
          "the equations of motion",
          {{"hand, at worst", "m", 1e-3}, {"hand off the mark at the end", "m", 1e-3}, {"gap, at worst", "m", 1e-6}},
          {},
          {}};
}

}  // namespace carom::tools::accuracy
