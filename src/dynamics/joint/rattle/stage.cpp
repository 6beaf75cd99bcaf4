// Stage functions: islands are tried to the side, hidden, and put in their places.
#include <algorithm>
#include <utility>

#include "dynamics/events/events.h"
#include "dynamics/integrate/integrator.h"
#include "dynamics/joint/rattle/motion.h"
#include "dynamics/joint/rattle/rattle.h"
#include "dynamics/joint/turns.h"
#include "dynamics/ledger/accounts.h"
#include "dynamics/quarantine.h"

namespace carom::dynamics {
namespace {

/// The dial's; of odd ones the next. Under rk4, which knows nothing of joints and would leave them at first order, at
/// least that integrator's. Where an accuracy is asked for it is the least of what islands choose.
int order_of(const World& world) {
  const int asked = (world.scene.dials.whole(Dial::joint_order) + 1) / 2 * 2;
  const int least = world.plan->integrator == &kRungeKutta4 ? 4 : world.accuracy ? 2 : 0;
  return std::max(asked, least);
}

constexpr int kNoTry = kMostHalvings + 1;  // of RattleIsland::halvings

int most_halvings(std::uint64_t joints, std::uint64_t substeps) {
  int most = kRattleHalvings;
  while (most < kMostHalvings && joints * (substeps << (most + 1)) <= kRattleParts) ++most;
  return most;
}

void list_bodies(Rattle& r, bool RattleIsland::*flag) {
  r.held.clear();
  for (const std::uint32_t i : r.by_slot)
    if (r.islands[r.island_of[i]].*flag) r.held.add(i);
}

bool is_damped(const World& world, const RattleJoint& j) {
  for (std::uint32_t c = 0; c < kCoordinates; ++c)
    if ((j.springs >> c & 1) && world.joints.joint[j.slot].drive[c].spring.damping > 0) return true;
  return false;
}
bool is_read(const World& world, const PlannedEffect& row) {
  if (row.participants.count == 0) return false;
  if (row.effect->id == EffectId::springs) {
    bool damped = false;
    row.participants.each([&](std::uint32_t k) { damped |= world.scene.springs.def[k].damping > 0; });
    return damped;
  }
  return row.effect->rate || row.effect->reads_velocities;
}

/// Rattled islands and their joints leave the lists that the rest of the step goes through.
void hide(const World& world, Rattle& r) {
  WideJoints& w = *world.wide_joints;
  r.active.clear();
  for (const std::uint32_t j : w.active) {
    const JointDef& def = world.joints.joint[j].def;
    const auto is_held = [&](std::uint32_t body) {
      return body != kInvalid && r.island_of[body] < r.islands.size() && r.islands[r.island_of[body]].went_well;
    };
    if (!is_held(def.body_a) && !is_held(def.body_b)) r.active.push_back(j);
  }
  if (r.active != r.left_active) w.is_packed = false, r.left_active = r.active;
  std::swap(w.active, r.active);
  exchange_lists(*world.plan, r.of_all);
  r.is_hidden = true;
}

/// Islands that want so many halvings of their substeps are moved, to the side. Who can't be wants more, or nothing.
/// @return whether there were any
bool try_all(const World& world, Rattle& r, Real dt, int halvings, int order) {
  bool any = false;
  for (RattleIsland& island : r.islands) any |= island.is_moving = island.was_tried = island.halvings == halvings;
  if (!any) return false;
  rattle::move_tried(world, r, dt, world.plan->substeps << halvings, order);
  for (RattleIsland& island : r.islands) {
    if (!island.was_tried) continue;
    if (island.is_moving || island.halvings == halvings || island.halvings > island.most_halvings)
      island.halvings = kNoTry;
    island.went_well = island.is_moving;
    if (island.went_well || !keeps_ledger(world)) continue;
    for (std::uint32_t i = island.body; i < island.body + island.movers; ++i)
      clear_kicks(ledger_of(world), r.bodies[i].slot);
  }
  return true;
}

}  // namespace

void rattle::move_tried(const World& world, Rattle& r, Real dt, int substeps, int order) {
  list_bodies(r, &RattleIsland::is_moving);
  list_held(world, r);
  exchange_lists(*world.plan, r.of_held);
  r.reads_velocities = std::ranges::any_of(world.plan->effects, [&](const auto& row) { return is_read(world, row); }) ||
                       std::ranges::any_of(r.joints, [&](const RattleJoint& j) { return is_damped(world, j); });
  move_islands(world, r, dt, substeps, order);
  exchange_lists(*world.plan, r.of_held);
}

bool rattle::moves_by_forces(const World& world) {
  return accuracy::is_on(world.scene.dials) || world.scene.dials.whole(Dial::joint_order) > 2;
}

bool rattle::is_asked(const World& world) {
  constexpr std::uint32_t kByRk4 = 2;  // of the dial integrator
  const Dials& dials = world.scene.dials;
  if (moves_by_forces(world)) return true;
  return world.joints.slots.alive_count() > 0 &&
         (dials.whole(Dial::joint_order) > 0 || static_cast<std::uint32_t>(dials.choice(Dial::integrator)) == kByRk4);
}

bool rattle::is_given_up(const World& world, std::uint32_t body) {
  if (!world.rattle || body >= world.rattle->island_of.size()) return false;
  const std::uint32_t island = world.rattle->island_of[body];
  return island < world.rattle->islands.size() && world.rattle->islands[island].gave_up;
}

void rattle::come_back(const World& world) {
  if (!world.rattle) return;
  Rattle& r = *world.rattle;
  if (!std::exchange(r.is_hidden, false)) return;
  exchange_lists(*world.plan, r.of_all);
  std::swap(world.wide_joints->active, r.active);
}

void try_rattle(const World& world, const StepTime& time) {
  if (!world.rattle) return;
  Rattle& r = *world.rattle;
  for (RattleIsland& island : r.islands) island.went_well = island.gave_up = island.is_barred = false;
  const int order = order_of(world);
  if (order == 0) return;
  constexpr int kWorkOfAccuracy = 4;  // an order whose bound of work holds for all that islands choose
  rattle::make_islands(world, r, world.accuracy ? std::max(order, kWorkOfAccuracy) : order);
  rattle::find_met(world, r, time);
  for (RattleIsland& island : r.islands) {
    island.halvings = island.is_held && !island.is_met ? 0 : kNoTry;
    island.most_halvings = most_halvings(island.joints, static_cast<std::uint64_t>(world.plan->substeps));
  }
  int tries = 0;
  if (world.accuracy)
    tries = 2, rattle::try_accurately(world, r, time.dt, order);
  else
    for (int halvings = 0; halvings <= kMostHalvings; ++halvings) tries += try_all(world, r, time.dt, halvings, order);
  for (RattleIsland& island : r.islands)
    island.gave_up = island.is_held && !island.is_met && !island.is_barred && !island.went_well;
  const std::uint64_t tried = r.held.count;
  list_bodies(r, &RattleIsland::went_well);
  if (r.held.count == 0) {
    // Lanes are those of all joints, or have to be.
    if (r.left_active != world.wide_joints->active) world.wide_joints->is_packed = false;
    r.left_active = world.wide_joints->active;
    return;
  }
  if (tries > 1 || r.held.count != tried) rattle::list_held(world, r);  // else they are listed
  hide(world, r);
}

void take_rattle(const World& world, Poses& poses, Velocities& motion, Breaking to, Events& events,
                 const StepTime& time) {
  if (!world.rattle || !world.rattle->is_hidden) return;
  Rattle& r = *world.rattle;
  rattle::come_back(world);
  Joints& joints = to;
  rattle::each_held(r, [&](const RattleIsland& island) {
    for (std::uint32_t i = island.body; i < island.body + island.movers; ++i) {
      const RattleBody& b = r.bodies[i];
      poses.x[b.slot] = b.x, motion.v[b.slot] = b.v;
      if (!b.turns) continue;
      poses.q[b.slot] = b.q;
      motion.omega[b.slot] = b.locks ? b.omega : rattle::spin_of_body(b, b.q, b.l);
      motion.momentum[b.slot] = b.locks ? Vec3(rattle::turned(b.inertia, b.r) * b.omega) : b.l;
    }
    for (std::uint32_t i = island.joint; i < island.joint + island.joints; ++i) {
      const RattleJoint& j = r.joints[i];
      Joint& joint = joints.joint[j.slot];
      for (std::uint32_t k = 0; k < j.rows; ++k) joint.p[k] = r.rows[j.row + k].load * (time.h / 2);
      joint.p_h = time.h;
      joint.force = j.force / time.dt, joint.torque = j.torque / time.dt;
      count_angles(world, joint, j.is_limited || j.springs ? &j.turned : nullptr, time.dt);
    }
  });
  if (keeps_ledger(world)) rattle::account(world, r);
  rattle::each_held(r, [&](const RattleIsland& island) {
    for (std::uint32_t i = island.joint; i < island.joint + island.joints; ++i) {
      const Joint& joint = world.joints.joint[r.joints[i].slot];
      if (joint.force.norm() <= joint.def.break_force && joint.torque.norm() <= joint.def.break_torque) continue;
      tell_broken(world, events, r.joints[i].slot);
      break_joint(to, r.joints[i].slot);
    }
  });
}

}  // namespace carom::dynamics
