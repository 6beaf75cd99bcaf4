// One step of all islands that joints alone hold, side by side: README.md.
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "dynamics/joint/axis_parts.h"
#include "dynamics/joint/parts.h"
#include "dynamics/joint/rattle/mover.h"
#include "dynamics/joint/turns.h"
#include "dynamics/ledger/ledger.h"

namespace carom::dynamics::rattle {
namespace {

/// Of a step, in order; the sum is 1. @source [Hairer2006 §V.3.2]: Suzuki's five stages; Kahan and Li's nine.
constexpr Real kOuter9 = 0.39216144400731413928, kSecond9 = 0.33259913678935943860, kBack9 = -0.70624617255763935981,
               kFourth9 = 0.082213596293550800230, kMiddle9 = 0.79854399093482996340;
constexpr Real kKahanLi6[] = {kOuter9, kSecond9, kBack9, kFourth9, kMiddle9, kFourth9, kBack9, kSecond9, kOuter9};
std::span<const Real> shares_of(int order) {
  if (order == 6) return kKahanLi6;
  if (order == 4) return kSuzuki4;
  return kOne;
}

/// f(mover) of an island: as many rows a joint as it needs.
template <class F>
bool with_mover(const World& world, Rattle& r, RattleIsland& island, F&& f) {
  switch (island.block) {
    case 1:
      return f(Mover<1>(world, r, island));
    case 2:
      return f(Mover<2>(world, r, island));
    case 3:
      return f(Mover<3>(world, r, island));
    case 4:
      return f(Mover<4>(world, r, island));
    case 5:
      return f(Mover<5>(world, r, island));
    default:
      return f(Mover<6>(world, r, island));
  }
}

/// f(mover) of each island that is going well so far, which then does, or not.
template <class F>
void over_islands(const World& world, Rattle& r, F&& f) {
  in_parallel(world.jobs, r.islands.size(), 1, [&](std::uint32_t i) {
    RattleIsland& island = r.islands[i];
    if (island.is_moving) island.is_moving = with_mover(world, r, island, f);
  });
}

template <class F>
void each_mover(Rattle& r, F&& f) {
  for (const RattleIsland& island : r.islands)
    if (island.is_moving)
      for (std::uint32_t i = island.body; i < island.body + island.movers; ++i) f(r.bodies[i]);
}

void show(Rattle& r) {
  each_mover(r, [&](const RattleBody& b) {
    r.trial.x[b.slot] = b.x, r.trial.q[b.slot] = b.q;
  });
}

/// Accelerations where bodies are. What reads velocities is given those of the trial.
/// @param h  s, a substep   @param share  s, for which they will act
void find_accelerations(const World& world, Rattle& r, Real h, Real share) {
  each_mover(r, [&](const RattleBody& b) { r.trial.accel[b.slot] = r.trial.alpha[b.slot] = Vec3::zero(); });
  const Motion at = r.trial.at();
  const Accelerate to = r.trial.to(share);
  for (PlannedEffect& row : world.plan->effects) {
    if (!is_asked_at_trials(*row.effect) || row.participants.count == 0) continue;
    const AccountForRow account(world, row, to.v, to.omega, share);
    row.effect->force(world.scene, world.state, row.participants, at, to);
    row.evaluations += row.participants.count;
  }
  over_islands(world, r, [&](const auto& mover) { return mover.pull(h, share); });
}

/// Velocities that forces read: of now.
void read_now(Rattle& r) {
  each_mover(r, [&](const RattleBody& b) { r.trial.v[b.slot] = b.v, r.trial.omega[b.slot] = b.omega; });
}
/// Of a stage's end, from those of its beginning and its middle: to first order, without knowing its last impulses.
void read_ahead(Rattle& r) {
  each_mover(r, [&](const RattleBody& b) {
    r.trial.v[b.slot] = 2 * b.v - r.trial.v[b.slot], r.trial.omega[b.slot] = 2 * b.omega - r.trial.omega[b.slot];
  });
}

JointEnds ends_at(const World& world, const Joint& joint, const RattleBody& a, const RattleBody& b) {
  JointEnds ends;
  const auto end = [&](std::uint32_t slot, const Pose& frame, const RattleBody& body, Pose& to, Vec3& arm) {
    arm = slot == kInvalid ? Vec3(Vec3::zero()) : Vec3(body.r * (frame.p - world.scene.center[slot]));
    to = slot == kInvalid ? frame : Pose{body.q * frame.q, body.x + arm};
    return slot == kInvalid ? frame.p : body.x;
  };
  const Vec3 x_a = end(joint.def.body_a, joint.def.frame_a, a, ends.a, ends.arm_a),
             x_b = end(joint.def.body_b, joint.def.frame_b, b, ends.b, ends.arm_b);
  ends.apart = (x_b - x_a) + (ends.arm_b - ends.arm_a);
  return ends;
}

}  // namespace

void count_turns(const World& world, RattleJoint& j, const RattleBody& a, const RattleBody& b, Real h) {
  const Joint& joint = world.joints.joint[j.slot];
  if (!counts_turns(joint.def.kind)) return;
  const JointEnds ends = ends_at(world, joint, a, b);
  const Vec3 w = b.omega - a.omega;
  j.turned = h == 0 ? counted_angles(world, joint, ends) : led_angles(world, joint, ends, j.turned, w, h);
}

bool is_within_limits(const World& world, const RattleJoint& j, const RattleBody& a, const RattleBody& b) {
  const Joint& joint = world.joints.joint[j.slot];
  const JointEnds ends = ends_at(world, joint, a, b);
  const auto within = [](Real x, Real lower, Real upper) { return x >= lower && x <= upper; };
  if (joint.def.kind == JointKind::six_axis) {
    const std::array<Real, kAxes> at = axes_at(ends, j.turned);
    const JointAxes& axes = world.joints.axes_of(joint);
    for (std::uint32_t k = 0; k < kAxes; ++k)
      if (axes.axis[k].is_limited() && !within(at[k], axes.axis[k].lower, axes.axis[k].upper)) return false;
    return true;
  }
  std::array<Real, kCoordinates> at = coordinates_of(ends);
  at[0] = j.turned.x();
  for (std::size_t c = 0; c < kCoordinates; ++c) {
    const JointLimit& limit = joint.drive[c].limit;
    if (!limit.on || !has(joint.def.kind, static_cast<Coordinate>(c))) continue;
    if (!within(at[c], limit.lower, limit.upper)) return false;
  }
  return true;
}

void move_islands(const World& world, Rattle& r, Real dt, int substeps, int order) {
  const std::span<const Real> shares = shares_of(order);
  const int stages = substeps * static_cast<int>(shares.size());
  const Real h = dt / substeps;
  Real longest = 0;
  for (const Real s : shares) longest = std::max(longest, std::fabs(s) * h);
  over_islands(world, r, [&](const auto& mover) { return mover.begin(longest); });
  show(r), read_now(r);
  const auto share = [&](int k) {
    return k < stages ? h * shares[static_cast<std::size_t>(k) % shares.size()] : Real(0);
  };
  find_accelerations(world, r, h, share(0) / 2);
  Real t = 0;
  for (int k = 0; k < stages; ++k) {
    const Real step = share(k);
    t += step;
    if (k > 0 && r.reads_velocities) {
      read_now(r);
      find_accelerations(world, r, h, step / 2);
    }
    over_islands(world, r, [&](const auto& mover) { return mover.go(step, step / 2, t); });
    show(r);
    if (r.reads_velocities) read_ahead(r);
    find_accelerations(world, r, h, r.reads_velocities ? step / 2 : (step + share(k + 1)) / 2);
    over_islands(world, r, [&](const auto& mover) { return mover.stop(step); });
    show(r);
  }
}

}  // namespace carom::dynamics::rattle
