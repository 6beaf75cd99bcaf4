// Stage functions: islands are tried to the side, hidden, and put in their places.
#include <algorithm>
#include <cmath>
#include <utility>

#include "dynamics/events/events.h"
#include "dynamics/integrate/integrator.h"
#include "dynamics/joint/axis_parts.h"
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

namespace {

void move_some(const World& world, Rattle& r, Real from, Real dt, int substeps, int order) {
  using namespace rattle;
  list_bodies(r, &RattleIsland::is_moving);
  list_held(world, r);
  exchange_lists(*world.plan, r.of_held);
  r.reads_velocities = std::ranges::any_of(world.plan->effects, [&](const auto& row) { return is_read(world, row); }) ||
                       std::ranges::any_of(r.drives, [](const RattleDrive& d) { return d.c > 0; });
  move_islands(world, r, from, dt, substeps, order);
  exchange_lists(*world.plan, r.of_held);
}

/// An island as a part of its step begins, so that it can be done again.
void save_part(const World& world, Rattle& r, const RattleIsland& island) {
  const auto bodies = r.bodies.begin() + island.body;
  const auto joints = r.joints.begin() + island.joint;
  r.part_bodies.assign(bodies, bodies + island.bodies), r.part_joints.assign(joints, joints + island.joints);
  rattle::save_kicks(world, r, r.part_kicks);
}
void restore_part(const World& world, Rattle& r, const RattleIsland& island) {
  std::ranges::copy(r.part_bodies, r.bodies.begin() + island.body);
  std::ranges::copy(r.part_joints, r.joints.begin() + island.joint);
  rattle::restore_kicks(world, r, r.part_kicks);
}

/// A step in which a motor is overcome or reaches its speed, or a limit is met or let go: again with what was found, in parts
/// that end where that happens.   @return whether it went well
bool move_in_parts(const World& world, Rattle& r, RattleIsland& island, Real dt, int substeps, int order) {
  // Of the step as it was asked for, in all that is done again; where it is taken in halves, of these as far as there is work.
  constexpr int kMostTries = 8, kLooks = 5;
  const auto as_many = [&](int parts) { return kMostTries * parts * rattle::stages_of(order); };
  const int halved = std::min(as_many(substeps), static_cast<int>(kRattleParts / std::max(island.joints, 1u)));
  const int most = world.accuracy ? as_many(substeps) : std::max(as_many(world.plan->substeps), halved);
  const Real there = order == 2 ? 1e-4 : order == 4 ? 1e-7 : 1e-10;  // of a part of a step, about where it ends
  Real from = 0, until = 1;
  int looks = 0;
  while (island.work < most) {
    if (island.event > 0)
      until = from + island.event * (until - from), island.takes_events = false, looks = 0;
    else if (until == 1)
      island.takes_events = true;
    island.is_changed = false, island.is_moving = true, island.event = island.late = 0;
    if (from > 0)
      restore_part(world, r, island);
    else if (keeps_ledger(world))
      for (std::uint32_t i = island.body; i < island.body + island.movers; ++i)
        clear_kicks(ledger_of(world), r.bodies[i].slot);
    const bool is_stiff = order > 2 && island.is_stiff;
    const auto stages_in = [&](Real part) {  // none is longer than those of the step
      return std::max(1, static_cast<int>(std::ceil(substeps * part))) * (is_stiff ? rattle::stages_of(order) : 1) *
             island.finer;
    };
    const int stages = stages_in(until - from);
    island.work += stages * (is_stiff ? 1 : rattle::stages_of(order));
    move_some(world, r, from * dt, (until - from) * dt, stages, is_stiff ? 2 : order);
    if (!island.is_moving && !island.is_changed) return false;
    if (!island.is_moving) continue;
    if (until == 1) return true;
    if (std::fabs(island.late) > there && ++looks <= kLooks) {  // nearer to where it happens
      until = from + std::clamp(1 + island.late, Real(0.5), Real(2)) * (until - from);
      if (until < 1) continue;
      until = 1;
      continue;
    }
    from = until, until = 1;
    island.goes_on = true, island.is_decided = false;
    for (int looked = 0; looked < kLooks; ++looked) {  // what meets a limit stops there, whatever becomes of it then
      save_part(world, r, island);
      island.is_changed = false, island.is_moving = true;
      rattle::begin_islands(world, r, (1 - from) * dt, stages_in(1 - from), is_stiff ? 2 : order);
      if (island.is_moving || !island.is_changed) break;
      restore_part(world, r, island);
    }
    if (!island.is_moving) return false;
    save_part(world, r, island);
  }
  return island.is_barred = true, false;
}

}  // namespace

void rattle::move_tried(const World& world, Rattle& r, Real dt, int substeps, int order) {
  if (!r.drives.empty()) read_drives(world, r, dt / substeps);
  for (RattleIsland& island : r.islands) {
    island.is_decided = island.is_changed = island.goes_on = false, island.takes_events = true, island.event = 0;
    island.is_stiff = order == 2, island.finer = 1;
    if (world.accuracy) island.work = 0;
  }
  move_some(world, r, 0, dt, substeps, order);
  if (std::ranges::none_of(r.islands, &RattleIsland::is_changed)) return;
  r.in_parts = true;
  for (RattleIsland& island : r.islands) island.was_well = std::exchange(island.is_moving, false);
  for (RattleIsland& island : r.islands) {
    if (!island.is_changed) continue;
    island.was_well = move_in_parts(world, r, island, dt, substeps, order);
    island.is_changed = island.is_moving = false;
  }
  for (RattleIsland& island : r.islands) island.is_moving = island.was_well;
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
  for (RattleIsland& island : r.islands) island.went_well = island.gave_up = island.is_barred = false, island.work = 0;
  const int order = order_of(world);
  if (order == 0) return;
  constexpr int kWorkOfAccuracy = 4;  // an order whose bound of work holds for all that islands choose
  rattle::make_islands(world, r, world.accuracy ? std::max(order, kWorkOfAccuracy) : order);
  rattle::find_met(world, r, time);
  for (RattleIsland& island : r.islands) {
    island.halvings = island.is_held && !island.is_met ? 0 : kNoTry;
    const auto substeps = static_cast<std::uint64_t>(world.plan->substeps);
    // Where drives act the solver that takes over from a whip is right, too.
    island.most_halvings = island.has_drives ? kRattleHalvings.value : most_halvings(island.joints, substeps);
  }
  int tries = 0;
  r.in_parts = false;
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
  if (tries > 1 || r.in_parts || r.held.count != tried) rattle::list_held(world, r);  // else they are listed
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
      for (std::uint32_t k = 0; k < j.locks; ++k) joint.p[k] = r.rows[j.row + k].load * (time.h / 2);
      for (std::uint32_t k = 0; k < j.drives; ++k) {
        const RattleDrive& drive = r.drives[j.drive + k];
        impulse_of(joints.axes_of(joint), joint, drive.row, k) = drive.load * rattle::kept_for(drive.row.kind, time.h);
      }
      joint.p_h = time.h;
      if (j.is_gear) joint.transmission.phase = j.over.phase;
      joint.force = j.force / time.dt, joint.torque = j.torque / time.dt;
      count_angles(world, joint, j.is_counted ? &j.turned : nullptr, time.dt);
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
