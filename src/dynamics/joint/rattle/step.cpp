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

}  // namespace

int stages_of(int order) { return static_cast<int>(shares_of(order).size()); }

namespace {

/// f(mover) of each island that is going well so far, which then does, or not.
template <class F>
void over_islands(const World& world, Rattle& r, F&& f) {
  in_parallel(world.jobs, r.islands.size(), 1, [&](std::uint32_t i) {
    RattleIsland& island = r.islands[i];
    if (island.is_moving) island.is_moving = f(Mover(world, r, island));
  });
}

template <class F>
void each_mover(const Rattle& r, F&& f) {
  for (const RattleIsland& island : r.islands)
    if (island.is_moving)
      for (std::uint32_t i = island.body; i < island.body + island.movers; ++i) f(r.bodies[i]);
}

void show(Rattle& r) {
  each_mover(r, [&](const RattleBody& b) { r.trial.x[b.slot] = b.x, r.trial.q[b.slot] = b.q; });
}

/// Accelerations where bodies are. What reads velocities is given those of the trial.
/// @param share  s, for which they will act   @param ends  a stage does
void find_accelerations(const World& world, Rattle& r, Real share, bool ends) {
  each_mover(r, [&](const RattleBody& b) { r.trial.accel[b.slot] = r.trial.alpha[b.slot] = Vec3::zero(); });
  const Motion at = r.trial.at();
  const Accelerate to = r.trial.to(share);
  for (PlannedEffect& row : world.plan->effects) {
    if (!is_asked_at_trials(*row.effect) || row.participants.count == 0) continue;
    const AccountForRow account(world, row, to.v, to.omega, share);
    row.effect->force(world.scene, world.state, row.participants, at, to);
    row.evaluations += row.participants.count;
  }
  over_islands(world, r, [&](const Mover& mover) { return mover.pull(ends); });
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

void save_kicks(const World& world, const Rattle& r, Array<Vec3>& kicks) {
  kicks.clear();
  if (!keeps_ledger(world)) return;
  each_mover(r, [&](const RattleBody& b) {
    for (const Ledger::Kick& kick : world.ledger->kicks_of(b.slot))
      kicks.push_back(kick.v), kicks.push_back(kick.omega);
  });
}
void restore_kicks(const World& world, const Rattle& r, const Array<Vec3>& kicks) {
  if (!keeps_ledger(world)) return;
  std::size_t k = 0;
  each_mover(r, [&](const RattleBody& b) {
    for (Ledger::Kick& kick : world.ledger->kicks_of(b.slot)) kick.v = kicks[k++], kick.omega = kicks[k++];
  });
}

namespace {
/// s, the longest stage.
Real longest_of(std::span<const Real> shares, Real h) {
  Real longest = 0;
  for (const Real s : shares) longest = std::max(longest, std::fabs(s) * h);
  return longest;
}
}  // namespace

void begin_islands(const World& world, Rattle& r, Real dt, int substeps, int order) {
  const Real longest = longest_of(shares_of(order), dt / substeps);
  for (RattleIsland& island : r.islands)
    if (island.is_moving) island.block = island.least_block, island.is_first = true, island.agrees = false;
  over_islands(world, r, [&](const Mover& mover) { return mover.begin(longest); });
  over_islands(world, r, [&](const Mover& mover) { return mover.ready(longest); });
}

void move_islands(const World& world, Rattle& r, Real from, Real dt, int substeps, int order) {
  constexpr int kMostTries = 16;  // of a stage's end, until velocities agree
  const std::span<const Real> shares = shares_of(order);
  const int stages = substeps * static_cast<int>(shares.size());
  const Real h = dt / substeps;
  begin_islands(world, r, dt, substeps, order);
  show(r), read_now(r);
  const auto share = [&](int k) {
    return k < stages ? h * shares[static_cast<std::size_t>(k) % shares.size()] : Real(0);
  };
  const auto tell = [&](Real kick) {
    if (!r.drives.empty()) over_islands(world, r, [&](const Mover& mover) { return mover.tell_drives(kick); });
  };
  find_accelerations(world, r, share(0) / 2, false);
  tell(share(0) / 2);
  Real t = from;
  const int of_substep = static_cast<int>(shares.size());
  for (int k = 0; k < stages; ++k) {
    const Real step = share(k);
    t += step;
    if (k > 0 && r.reads_velocities) {
      read_now(r);
      over_islands(world, r, [&](const Mover& mover) { return mover.save_middle(); });
      find_accelerations(world, r, step / 2, false);
      tell(step / 2);
    }
    over_islands(world, r, [&](const Mover& mover) { return mover.go(step, step / 2, t); });
    over_islands(world, r, [&](const Mover& mover) { return mover.save_middle(); });
    show(r);
    const Real kick = r.reads_velocities ? step / 2 : (step + share(k + 1)) / 2;
    if (r.reads_velocities) read_ahead(r), save_kicks(world, r, r.kicks);
    for (int tries = 0; tries < (r.reads_velocities ? kMostTries : 1); ++tries) {
      if (tries > 0) restore_kicks(world, r, r.kicks);
      find_accelerations(world, r, kick, true);
      over_islands(world, r, [&](const Mover& mover) { return mover.try_stop(step); });
      if (std::ranges::none_of(r.islands, [](const RattleIsland& i) { return i.is_moving && !i.agrees; })) break;
    }
    tell(kick);
    const bool ends = (k + 1) % of_substep == 0;  // a substep does; where stages go back limits may be passed
    const Real begun = static_cast<Real>(k / of_substep) / substeps, whole = ends ? Real(1) / substeps : 0;
    over_islands(world, r, [&](const Mover& mover) { return mover.stop(step, begun, whole); });
    show(r);
  }
}

}  // namespace carom::dynamics::rattle
