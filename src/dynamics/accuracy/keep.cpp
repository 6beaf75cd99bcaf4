// What a pass changes, as it was, and as accepted runs leave it.
#include "dynamics/accuracy/accuracy.h"
#include "dynamics/accuracy/passes.h"
#include "dynamics/quarantine.h"

namespace carom::dynamics::accuracy {
namespace {

Passes::Kept kept_of(const State& s, std::uint32_t i) {
  return {s.x[i], s.v[i],      s.omega[i],        s.momentum[i],       s.force[i],   s.torque[i],
          s.q[i], s.held_q[i], s.loaded_steps[i], s.cooldown_steps[i], s.held_out[i]};
}

void put_motion(Passing to, std::uint32_t i, const Passes::Kept& k) {
  Poses& poses = to;
  Velocities& motion = to;
  SolverMemory& memory = to;
  poses.x[i] = k.x, poses.q[i] = k.q;
  motion.v[i] = k.v, motion.omega[i] = k.omega, motion.momentum[i] = k.momentum;
  memory.held_q[i] = k.held_q, memory.loaded_steps[i] = k.loaded_steps, memory.cooldown_steps[i] = k.cooldown_steps;
}

Passes::KeptJoint kept_of(const World& world, std::uint32_t slot) {
  const Joint& j = world.joints.joint[slot];
  return {j.p,     j.drive_p, j.p_h,    j.transmission.phase,     j.turned,
          j.force, j.torque,  j.turn.p, world.joints.axes_of(j).p};
}

void put_joint(Joints& joints, std::uint32_t slot, const Passes::KeptJoint& k) {
  Joint& j = joints.joint[slot];
  j.p = k.p, j.drive_p = k.drive_p, j.p_h = k.p_h, j.transmission.phase = k.phase, j.turned = k.turned;
  j.force = k.force, j.torque = k.torque, j.turn.p = k.turn_p;
  if (JointAxes* const axes = joints.axes_of(j)) axes->p = k.axes_p;
}

}  // namespace

void keep_begun(const World& world, Passes& p) {
  const State& s = world.state;
  const Contacts& c = *world.contacts;
  p.begun.resize(p.movers.size()), p.ended.resize(p.movers.size()), p.coarse.resize(p.movers.size());
  for (std::size_t k = 0; k < p.movers.size(); ++k) p.begun[k] = kept_of(s, p.movers[k]);
  p.driven_begun.clear();
  world.plan->kinematic.each([&](std::uint32_t i) { p.driven_begun.push_back({s.x[i], s.q[i]}); });
  p.all_active = world.wide_joints->active;
  p.joint_begun.resize(p.all_active.size()), p.joint_ended.resize(p.all_active.size());
  for (std::size_t k = 0; k < p.all_active.size(); ++k)
    p.joint_begun[k] = p.joint_ended[k] = kept_of(world, p.all_active[k]);
  p.rows = c.rows, p.geometry = c.geometry;
  p.contact_pairs = c.contact_pairs, p.bouncing = c.bouncing, p.driven = c.driven,
  p.turning_pairs = c.turning_pairs;
  p.resisting = p.resisting_ended = c.resisting;
  p.revision = world.scene.revision, p.collider_revision = world.scene.collider_revision, p.alarm = world.scene.alarm;
  p.quarantined = s.quarantined_count, p.faults = world.fault_views.size();
  p.groups = world.report.groups, p.largest_group = world.report.largest_group;
}

void go_back(const World& world, Passing to) {
  const Passes& p = world.accuracy->passes;
  HostForces& host = to;
  Quarantine& held = to;
  Revisions& scene = to;
  FaultViews& faults = to;
  Poses& poses = to;
  for (std::size_t k = 0; k < p.movers.size(); ++k) {
    const std::uint32_t i = p.movers[k];
    if (!runs(p, i)) continue;
    const Passes::Kept& b = p.begun[k];
    put_motion(to, i, b);
    host.force[i] = b.force, host.torque[i] = b.torque;
    held.held_out[i] = b.held_out;
  }
  held.quarantined_count = p.quarantined;
  scene.revision = p.revision, scene.collider_revision = p.collider_revision, scene.alarm = p.alarm;
  faults.resize(p.faults);
  std::size_t k = 0;
  world.plan->kinematic.each([&](std::uint32_t i) {
    poses.x[i] = p.driven_begun[k].x, poses.q[i] = p.driven_begun[k].q;
    held.held_out[i] = 0;
    ++k;
  });
  for (std::size_t j = 0; j < p.all_active.size(); ++j) put_joint(to, p.all_active[j], p.joint_begun[j]);
}

void keep_ended(const World& world, const Passes::Island& island) {
  Passes& p = world.accuracy->passes;
  each_member(p, island, [&](std::uint32_t k, std::uint32_t i) { p.ended[k] = kept_of(world.state, i); });
}

void keep_joint(const World& world, std::size_t at) {
  Passes& p = world.accuracy->passes;
  p.joint_ended[at] = kept_of(world, p.all_active[at]);
}

void put_ended(const World& world, Passing to) {
  const Passes& p = world.accuracy->passes;
  for (std::size_t k = 0; k < p.movers.size(); ++k) {
    put_motion(to, p.movers[k], p.ended[k]);
    if (p.ended[k].held_out & Quarantine::kNotFinite) quarantine(to, p.movers[k]);
  }
  for (std::size_t j = 0; j < p.all_active.size(); ++j) put_joint(to, p.all_active[j], p.joint_ended[j]);
}

}  // namespace carom::dynamics::accuracy
