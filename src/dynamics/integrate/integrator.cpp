// The two integration stages of the page: one kick, one move, with a stop for what left the finite world.
#include "dynamics/integrate/integrator.h"

#include <atomic>

#include "dynamics/body_state.h"
#include "dynamics/contact/mean_motion.h"
#include "dynamics/force/force.h"
#include "dynamics/integrate/turn_kernels.h"
#include "dynamics/ledger/ledger.h"
#include "dynamics/quarantine.h"

namespace carom::dynamics {
namespace {

/// Bodies that left the finite world: marked by whichever thread sees it, put in quarantine by the stepping one.
class Outliers {
 public:
  explicit Outliers(Quarantining to) : to_(to) {}

  void add(std::uint32_t body) {
    held().held_out[body] |= kMark;
    any_.store(true, std::memory_order_relaxed);
  }
  void quarantine_all(const Plan& plan) {
    if (!any_.load(std::memory_order_relaxed)) return;
    const auto take = [&](std::uint32_t i) {
      std::uint8_t& mark = held().held_out[i];
      if (!(mark & kMark)) return;
      mark &= static_cast<std::uint8_t>(~kMark);
      quarantine(to_, i);
    };
    plan.linear.each(take), plan.rotating.each(take), plan.kinematic.each(take);
  }

 private:
  static constexpr std::uint8_t kMark = 2;  // beside the bits of Quarantine::Why
  Quarantine& held() const { return to_; }
  Quarantining to_;
  std::atomic<bool> any_{false};
};

void stop_listed(const World& world, Quarantining to) {
  Plan& plan = *world.plan;
  Outliers outliers(to);
  plan.linear.each(world.jobs, [&](std::uint32_t i) {
    if (!sane_velocity(world.state, i)) outliers.add(i);
  });
  plan.rotating.each(world.jobs, [&](std::uint32_t i) {
    if (!sane_velocity(world.state, i) || !sane_spin(world.state, i)) outliers.add(i);
  });
  outliers.quarantine_all(plan);
}

}  // namespace

Motions motions_of(const World& world, Array<Vec3>& to_x, Array<Quat>& to_q) {
  const State& s = world.state;
  const Plan& plan = *world.plan;
  return {.x = s.x.data()->data(),
          .v = s.v.data()->data(),
          .q = s.q.data()->data(),
          .omega = s.omega.data()->data(),
          .turned = plan.rotation_method ? plan.turns_by_method.data() : nullptr,
          .turned_q = plan.predicted.q.data()->data(),
          .turned_omega = plan.predicted.omega.data()->data(),
          .to_x = to_x.data()->data(),
          .to_q = to_q.data()->data(),
          .most_x = kMaxPosition};
}

void integrate_velocity(const World& world, Quarantining to, const StepTime& time) {
  Plan& plan = *world.plan;
  plan.integrator->velocity(world, to, time.h);
  if (keeps_ledger(world)) account_turns(world);
  axis_locks::hold(world, to, time.h);
  // Before any contact reads them, so that one body's infinity does not become its neighbours'.
  stop_listed(world, to);
}

void quarantine_outliers(const World& world, Quarantining to, const StepTime&) {
  if (!world.plan->idle) stop_listed(world, to);  // else no body has moved yet
}

void integrate_position(const World& world, Poses& poses, Quarantining to, const StepTime& time) {
  const State& s = world.state;
  Plan& plan = *world.plan;
  const Real h = time.h;

  const MeanVelocities means(world, to);
  Outliers outliers(to);
  const auto place = [&](std::uint32_t i, const Vec3& x) {
    if (sane_position(x))
      poses.x[i] = x;
    else
      outliers.add(i);  // stays at its last good place
  };
  const auto move = [&](std::uint32_t i) { place(i, poses.x[i] + h * s.v[i]); };
  // What a solver made of omega since the kick may be anything: no turn can be told by numbers whose squares overflow.
  const auto face = [&](std::uint32_t i, const Quat& q) {
    const Real n2 = q.squared_norm();
    if (n2 > 0.5 && n2 < 2)
      poses.q[i] = q;
    else
      outliers.add(i);
  };
  const auto spin = [&](std::uint32_t i) { face(i, normalized(exp_map(h * s.omega[i]) * poses.q[i])); };
  const auto turn = [&](std::uint32_t i) {
    if (s.held_out[i]) return;
    Quat q = plan.predicted.q[i];
    if (plan.touched[i]) q = normalized(exp_map(h * (s.omega[i] - plan.predicted.omega[i])) * q);
    face(i, q);
  };
  const bool carries = plan.rotation_method != nullptr;
  const auto orient = [&](std::uint32_t i) { (carries && plan.turns_by_method[i]) ? turn(i) : spin(i); };

  if (!plan.integrator->proposes) {
    plan.linear.each(world.jobs, move);
    plan.rotating.each(world.jobs, [&](std::uint32_t i) { move(i), orient(i); });
  } else {
    const auto free = [&](std::uint32_t i) { return !plan.touched[i] && !s.held_out[i]; };
    plan.linear.each(world.jobs, [&](std::uint32_t i) { free(i) ? place(i, plan.predicted.x[i]) : move(i); });
    const Motions motions = motions_of(world, poses.x, poses.q);
    const auto in_lanes = turn_kernels().move;
    const auto is_moved = [&](std::uint32_t i) {
      if (free(i)) place(i, plan.predicted.x[i]), face(i, plan.predicted.q[i]);
      return !free(i);
    };
    plan.rotating.each_four(world.jobs, is_moved, [&](const std::uint32_t* body, std::uint32_t count) {
      const auto is_held = [&](std::uint32_t i) { return s.held_out[i] != 0; };
      if (count == 4 && std::none_of(body, body + 4, is_held) && in_lanes(motions, body, h)) return;
      for (std::uint32_t k = 0; k < count; ++k) move(body[k]), orient(body[k]);
    });
  }
  plan.kinematic.each([&](std::uint32_t i) { move(i), spin(i); });
  outliers.quarantine_all(plan);
}

void drive_kinematics(const World& world, Poses& poses, Quarantining to, const StepTime& time) {
  const State& s = world.state;
  Plan& plan = *world.plan;
  Outliers outliers(to);
  plan.kinematic.each([&](std::uint32_t i) {
    const Vec3 way = time.h * s.v[i];
    const Quat turn = exp_map(time.h * s.omega[i]);
    for (int k = 0; k < plan.substeps; ++k) {
      const Vec3 x = poses.x[i] + way;
      const Quat q = normalized(turn * poses.q[i]);
      const Real n2 = q.squared_norm();
      if (!sane_position(x) || !(n2 > 0.5 && n2 < 2)) return outliers.add(i);
      poses.x[i] = x, poses.q[i] = q;
    }
  });
  outliers.quarantine_all(plan);
}

}  // namespace carom::dynamics
