// governor: arms on a spinning shaft that lift a slider by stiff springs and dampers (the benchmark A05 of the IFToMM
// library of multibody problems; a shaft that spins freely).
#include <cmath>
#include <numbers>

#include "accuracy/joints/links.h"
#include "accuracy/linkages.h"
#include "accuracy/reference.h"

namespace carom::tools::accuracy {
namespace {

using G = Governor;

constexpr double kArm = G::kRod + G::kBall;                    // kg
constexpr double kMiddle = (0.5 * G::kRod + G::kBall) / kArm;  // m, of an arm with its ball, from the hinge
const Vec kUp = Vec::UnitY();

/// Two ends of a spring: an arm's middle and a side of the slider.
struct Coupler {
  std::size_t arm;
  double side;  // 1 or -1
  carom_joint spring;
};

Vec arm_inertia() {
  const double across =
      G::rod_inertia().y() + G::kRod * (kMiddle - 0.5) * (kMiddle - 0.5) + G::kBall * (1 - kMiddle) * (1 - kMiddle);
  return {G::rod_inertia().x(), across, across};
}

/// 1/kg: how a unit impulse along n at `arm` from the middle of a body moves that point.
double softness(double mass, const Vec& inertia, const Quat& q, const Vec& arm, const Vec& n) {
  const Vec lever = q.conjugate() * arm.cross(n);
  return 1 / mass + lever.dot(lever.cwiseQuotient(inertia));
}

class GovernorTrial : public Trial {
 public:
  GovernorTrial(std::size_t slider, std::array<Coupler, 2> couplers, Mechanism hinges, const Stage& stage)
      : slider_(slider), couplers_(couplers), hinges_(std::move(hinges)) {
    set_springs(stage);
  }

  void watch(const Stage& stage, double time) override {
    const int steps = std::max(1, static_cast<int>(std::ceil((time - time_) / 2e-5)));  // its stiffest rate: 6e4 / s
    for (int i = 0; i < steps; ++i) truth_ = runge_kutta(truth_, (time - time_) / steps, G::rate);
    time_ = time;
    height_ = std::max(height_, std::fabs(stage.position(slider_).y() - truth_[2]));
    gap_ = std::max(gap_, hinges_.worst_gap(stage));
    set_springs(stage);
  }
  std::vector<double> errors(const Stage&) const override { return {height_, gap_}; }

 private:
  /// A joint's spring is told in hertz of what it pulls, so newtons a metre are told anew as that turns.
  void set_springs(const Stage& stage) const {
    const double cube = G::kSlider * 0.01 / 6;
    for (const Coupler& c : couplers_) {
      const Quat turned = stage.orientation(c.arm), level = stage.orientation(slider_);
      const Vec arm = turned * Vec(0.5 - kMiddle, 0, 0), lug = level * Vec(c.side * G::kOff, 0, 0);
      const Vec n = (stage.position(c.arm) + arm - stage.position(slider_) - lug).normalized();
      const double mass = 1 / (softness(kArm, arm_inertia(), turned, arm, n) +
                               softness(G::kSlider, Vec::Constant(cube), level, lug, n));
      const double rate = std::sqrt(G::kStiff / mass);
      Call call;
      carom_joint_spring spring;
      call.done(carom_joint_spring_init(&spring, sizeof spring), "a spring");
      spring.enabled = 1, spring.target = G::kRest, spring.frequency = rate / (2 * std::numbers::pi);
      spring.damping = G::kDamp / (2 * mass * rate), spring.max_force = 1e30;
      call.done(carom_joint_set_spring(stage.world.get(), c.spring, CAROM_COORDINATE_DISTANCE, &spring, call),
                "a spring");
    }
  }

  std::size_t slider_;
  std::array<Coupler, 2> couplers_;
  Mechanism hinges_;
  Eigen::Vector4d truth_ = G::start();
  double time_ = 0, height_ = 0, gap_ = 0;
};

std::unique_ptr<Observer> fill(Stage& stage, const std::vector<double>&, const std::string&) {
  const auto spin = [&](std::size_t link) {
    const Vec v = G::kSpin * kUp.cross(stage.position(link)), w = G::kSpin * kUp;
    Call call;
    call.done(carom_body_set_velocity(stage.world.get(), stage.actors[link].body, v.data(), w.data(), call),
              "spinning");
    return stage.actors[link].body;
  };
  const auto box = [](double x, double y, double z) {
    Part looks;
    looks.shape = "box";
    looks.params = {x, y, z};
    return looks;
  };
  const Quat upwards = turn_between(Vec::UnitX(), kUp), sideways = turn_between(Vec::UnitX(), Vec::UnitZ());
  Mechanism hinges;
  const double thin = 1e-4 * G::kShaft / 12, tall = (1 + 1e-4) * G::kShaft / 12;
  const std::size_t shaft_link =
      add_link(stage, "shaft", kUp / 2, G::kShaft, Vec(tall, 2 * thin, tall), box(0.005, 0.5, 0.005));
  const std::size_t slider_link =
      add_link(stage, "slider", kUp / 2, G::kSlider, Vec::Constant(G::kSlider * 0.01 / 6), box(0.05, 0.05, 0.05));
  const carom_body shaft = spin(shaft_link), slider = spin(slider_link);
  hinges.add(join(stage, CAROM_JOINT_HINGE, CAROM_NULL_HANDLE, shaft, Vec::Zero(), upwards));
  hinges.add(join(stage, CAROM_JOINT_SLIDER, shaft, slider, kUp / 2, upwards));
  std::array<Coupler, 2> couplers{};
  for (int i = 0; i < 2; ++i) {
    const double side = i == 0 ? 1 : -1;
    const Vec along(side * std::cos(G::kAngle), -std::sin(G::kAngle), 0), head(side * G::kOff, G::kHead, 0);
    const std::size_t link = add_link(stage, "arm", head + kMiddle * along, kArm, arm_inertia(), box(0.5, 0.005, 0.005),
                                      turn_between(Vec::UnitX(), along));
    const carom_body arm = spin(link);
    hinges.add(join(stage, CAROM_JOINT_HINGE, shaft, arm, head, sideways));
    carom_joint_desc desc;
    Call call;
    couplers[i] = {link, side, CAROM_NULL_HANDLE};
    call.done(carom_joint_desc_init(&desc, sizeof desc), "a coupler");
    desc.kind = CAROM_JOINT_DISTANCE, desc.body_a = slider, desc.body_b = arm;
    desc.position_a[0] = side * G::kOff, desc.position_b[0] = 0.5 - kMiddle;
    call.done(carom_joint_create(stage.world.get(), &desc, &couplers[i].spring, call), "a coupler");
  }
  stage.bounds_min = Vec::Constant(-1e3);
  stage.ground_half_width = 0;
  stage.camera_from = Vec(0, 0.8, 3.5), stage.camera_to = Vec(0, 0.5, 0);
  return std::make_unique<GovernorTrial>(slider_link, couplers, std::move(hinges), stage);
}

}  // namespace

Challenge governor_challenge() {
  return {9,
          {"governor",
           "Arms on a spinning shaft lift a slider by springs of 800 kN/m with dampers of 40 kN s/m.",
           "a stiff slider that follows the arms",
           {},
           10,
           1.0 / 60,
           fill},
          "the equations of motion of arm and slider",
          {{"height of the slider, at worst", "m", 1e-3}, {"gap, at worst", "m", 1e-4}},
          {},
          {}};
}

}  // namespace carom::tools::accuracy
