// Sliders of a plan: frames, motors, springs.
#include <cmath>
#include <utility>

#include "plan.h"

namespace carom::bench {
namespace {

/// A joint's frame in the world.
struct Frame {
  Vec at;
  Quat axes;
};

Frame frame_of(const BodyState* body, const double (&on)[3], const double (&axes)[4]) {
  if (!body) return {vec(on), quat(axes)};
  return {vec(body->position) + quat(body->orientation) * vec(on), quat(body->orientation) * quat(axes)};
}

}  // namespace

/// A and B change over where B does not move: B is the body that moves. What stands without a shape is the world.
void Plan::place_slider(const carom_joint_desc& joint, JointPlan& plan) const {
  plan.kind = JointKind::slider;
  const auto turn = [&](std::size_t i, const double(&axes)[4], double(&on)[4]) {
    const Quat inward = i == kWorldBody ? Quat::Identity() : members_[i].axes.conjugate();
    Eigen::Vector4d::Map(on) = (inward * quat(axes)).coeffs();
  };
  turn(plan.a, joint.orientation_a, plan.axes_on_a), turn(plan.b, joint.orientation_b, plan.axes_on_b);
  const auto to_world = [&](std::size_t& i, double(&on)[3], double(&axes)[4]) {
    if (i == kWorldBody || !plans_[i].is_static || plans_[i].solid != Solid::none) return;
    const Frame frame = frame_of(&plans_[i].start, on, axes);
    Vec::Map(on) = frame.at, Eigen::Vector4d::Map(axes) = frame.axes.coeffs();
    i = kWorldBody;
  };
  to_world(plan.a, plan.on_a, plan.axes_on_a), to_world(plan.b, plan.on_b, plan.axes_on_b);
  if (plan.b == kWorldBody || plans_[plan.b].is_static) {
    std::swap(plan.a, plan.b), std::swap(plan.on_a, plan.on_b), std::swap(plan.axes_on_a, plan.axes_on_b);
    const Quat about_y(0, 0, 1, 0);  // half a turn: what the one goes along x, the other goes along -x
    for (double(*axes)[4] : {&plan.axes_on_a, &plan.axes_on_b})
      Eigen::Vector4d::Map(*axes) = (quat(*axes) * about_y).coeffs();
  }
  const auto start_of = [&](std::size_t i) { return i == kWorldBody ? nullptr : &plans_[i].start; };
  const Frame a = frame_of(start_of(plan.a), plan.on_a, plan.axes_on_a);
  const Frame b = frame_of(start_of(plan.b), plan.on_b, plan.axes_on_b);
  if ((a.at - b.at).norm() > 1e-9 || a.axes.angularDistance(b.axes) > 1e-7)
    throw tools::Error("the frames of a slider are apart at the start", "choose a scene whose sliders start at 0");
}

void Plan::drive_slider(carom_joint handle, JointPlan& plan) const {
  tools::Call call;
  carom_joint_limit limit;
  carom_joint_motor motor;
  carom_joint_spring spring;
  carom_joint_limit_init(&limit, sizeof limit), carom_joint_motor_init(&motor, sizeof motor);
  carom_joint_spring_init(&spring, sizeof spring);
  carom_world* const world = stage_.world.get();
  call.done(carom_joint_get_limit(world, handle, CAROM_COORDINATE_SLIDE, &limit, call), "asking for a limit");
  call.done(carom_joint_get_motor(world, handle, CAROM_COORDINATE_SLIDE, &motor, call), "asking for a motor");
  call.done(carom_joint_get_spring(world, handle, CAROM_COORDINATE_SLIDE, &spring, call), "asking for a spring");
  if (limit.enabled || (motor.enabled && motor.speed == 0) || (motor.enabled && spring.enabled))
    throw tools::Error("a slider has a limit, a brake, or both a motor and a spring",
                       "choose a scene whose sliders have one motor or one spring");
  if (motor.enabled) plan.motor_speed = motor.speed, plan.motor_force = motor.max_force;
  if (!spring.enabled) return;
  const auto one_over_mass = [&](std::size_t i) {
    return i == kWorldBody || plans_[i].is_static ? 0.0 : 1 / members_[i].mass;
  };
  const double mass = 1 / (one_over_mass(plan.a) + one_over_mass(plan.b));  // kg
  const double rate = 2 * M_PI * spring.frequency;                          // rad/s
  plan.stiffness = mass * rate * rate, plan.damping = 2 * mass * spring.damping * rate, plan.target = spring.target;
}

}  // namespace carom::bench
