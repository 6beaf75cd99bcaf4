// Editing joints between steps: they come, go, are set and break.
#include <algorithm>

#include "dynamics/events/events.h"
#include "dynamics/joint/parts.h"
#include "dynamics/joint/tree/joint_moves.h"
#include "dynamics/joint/turns.h"
#include "dynamics/joint/wide_joints.h"
#include "dynamics/sleep/sleep.h"

namespace carom::dynamics {
namespace {

/// Whether a joint keeps its bodies' colliders from touching.
bool parts(const JointDef& def) { return !def.collide && def.body_a != kInvalid && def.body_b != kInvalid; }

void unpart(PairCounts& joined, const JointDef& def) {
  if (parts(def)) joined.remove(def.body_a, def.body_b);
}

void wake_both(World& world, const JointDef& def) {
  for (const std::uint32_t body : {def.body_a, def.body_b})
    if (body != kInvalid) wake(world, body);
}

std::uint32_t& link_of(Joints& joints, std::uint32_t body, std::uint32_t slot) {
  std::uint32_t* link = &joints.first[body];
  while (*link != slot && *link != kInvalid) {
    Joint& j = joints.joint[*link];
    link = j.def.body_a == body ? &j.next_a : &j.next_b;
  }
  return *link;
}

/// What a host sets of a hinge or slider is an axis of it. Its others are locked, so its rows are those of its kind.
void give_axes(Joints& joints, std::uint32_t slot) {
  Joint& joint = joints.joint[slot];
  JointAxes& axes = joints.axes.emplace_back();
  axes.owner = slot;
  if (joint.def.kind != JointKind::six_axis)
    for (std::uint32_t k = 0; k < kAxes; ++k)
      if (k != own_axis(joint.def.kind)) axes.axis[k].mode = AxisMode::locked;
  joint.axes = static_cast<std::uint32_t>(joints.axes.size());
}
void take_axes(Joints& joints, Joint& joint) {
  JointAxes* const axes = joints.axes_of(joint);
  if (!axes) return;
  *axes = joints.axes.back();  // the last takes its place
  joints.joint[axes->owner].axes = joint.axes;
  joints.axes.pop_back();
  joint.axes = 0;
}

void take_coupling(Joints& joints, Joint& joint) {
  if (!joint.coupling) return;
  Coupling& coupling = joints.couplings[joint.coupling - 1] = joints.couplings.back();  // the last takes its place
  joints.joint[coupling.owner].coupling = joint.coupling;
  joints.couplings.pop_back();
  joint.coupling = 0;
}

/// @param before  the key of its layout, as it was
void mark_layout(World& world, Joint& joint, std::uint64_t before) {
  if (layout_key(world.joints, joint) == before) return;
  world.joints.clear_impulses(joint);
  ++world.scene.revision;
}

}  // namespace

Handle World::add_joint(const JointDef& def) {
  reserve_slot(joints.slots.slots(), joints.joint);
  if (joints.first.size() < scene.bodies.slots()) joints.first.resize(scene.bodies.slots(), kInvalid);
  if (parts(def)) scene.joined.reserve();
  if (def.kind == JointKind::six_axis) reserve_slot(joints.axes.size(), joints.axes);
  wake_both(*this, def);  // may run out of memory, as all so far: nothing has changed yet
  const Handle handle = joints.slots.take();
  if (handle == 0) return 0;
  const std::uint32_t slot = handle_slot(handle);
  if (slot == joints.joint.size()) joints.joint.emplace_back();
  fill_joint(slot, def);
  Joint& joint = joints.joint[slot];
  start_count(*this, joint);
  if (def.body_a != kInvalid) joint.next_a = joints.first[def.body_a], joints.first[def.body_a] = slot;
  if (def.body_b != kInvalid) joint.next_b = joints.first[def.body_b], joints.first[def.body_b] = slot;
  ++scene.revision;
  return handle;
}

void World::fill_joint(std::uint32_t slot, const JointDef& def) {
  Joint& joint = joints.joint[slot] = Joint{};
  joint.def = def;
  if (def.kind == JointKind::gear) joint.transmission.ratio = 1;
  joints.measured += def.measured;
  if (def.kind == JointKind::six_axis) give_axes(joints, slot);
  joint.def.frame_a.q = oriented(def.frame_a.q), joint.def.frame_b.q = oriented(def.frame_b.q);
  if (parts(def)) scene.joined.add(def.body_a, def.body_b);
}

void World::move_joints(const JointMoves& moves) {
  moves.each_body(*this, [&](std::uint32_t body, const Pose& pose, const Vec3& v, const Vec3& omega, bool turns) {
    if (turns) set_pose(body, pose);
    set_velocity(body, v, omega);
  });
  moves.each_count([&](std::uint32_t j, const Vec3& turned) { joints.joint[j].turned = turned; });
}

/// The body by which a coupling hangs on a joint: one that moves, so that the two are of one island.
static std::uint32_t body_to_couple(const World& world, const JointDef& def, std::uint32_t other) {
  for (const std::uint32_t body : {def.body_b, def.body_a})
    if (body != kInvalid && body != other && world.scene.type[body] == BodyType::dynamic) return body;
  return kInvalid;
}

JointDef World::coupling_def(const Coupling& coupling) const {
  JointDef def;
  def.kind = JointKind::coupling, def.collide = true;
  def.body_a = body_to_couple(*this, joints.joint[coupling.follower].def, kInvalid);
  def.body_b = body_to_couple(*this, joints.joint[coupling.leader].def, def.body_a);
  return def;
}

Handle World::add_coupling(const Coupling& coupling, std::uint64_t user) {
  reserve_slot(joints.couplings.size(), joints.couplings);
  JointDef def = coupling_def(coupling);
  def.user = user;
  const Handle handle = add_joint(def);
  if (handle) fill_coupling(handle_slot(handle), coupling);
  return handle;
}

void World::fill_coupling(std::uint32_t slot, const Coupling& coupling) {
  Coupling& own = joints.couplings.emplace_back(coupling);
  own.owner = slot;
  joints.joint[slot].coupling = static_cast<std::uint32_t>(joints.couplings.size());
}

void World::set_polynomial(std::uint32_t slot, const std::array<Real, Coupling::kTerms>& polynomial) {
  Joint& joint = joints.joint[slot];
  wake_both(*this, joint.def);
  joints.couplings[joint.coupling - 1].polynomial = polynomial;
  joints.clear_impulses(joint);
  ++scene.revision;
}

void World::remove_joint(std::uint32_t slot) {
  for (std::size_t k = joints.couplings.size(); k-- > 0;) {  // a coupling goes with either of its joints
    if (k >= joints.couplings.size()) continue;
    const Coupling& coupling = joints.couplings[k];
    if (coupling.follower == slot || coupling.leader == slot) remove_joint(coupling.owner);
  }
  Joint& joint = joints.joint[slot];
  wake_both(*this, joint.def);
  if (joint.def.body_a != kInvalid) link_of(joints, joint.def.body_a, slot) = joint.next_a;
  if (joint.def.body_b != kInvalid) link_of(joints, joint.def.body_b, slot) = joint.next_b;
  if (!joint.broken) unpart(scene.joined, joint.def);
  joints.measured -= joint.def.measured;
  take_axes(joints, joint), take_coupling(joints, joint);
  joints.slots.release(slot);
  ++scene.revision;
}

void World::set_joint_drive(std::uint32_t slot, Coordinate c, const JointDrive& drive) {
  Joint& joint = joints.joint[slot];
  const std::uint64_t before = layout_key(joints, joint);
  wake_both(*this, joint.def);
  joint.drive[static_cast<std::size_t>(c)] = drive;
  recount(*this, joint);
  mark_layout(*this, joint, before);
}

void World::set_joint_axis(std::uint32_t slot, std::uint32_t axis, const JointAxis& to) {
  Joint& joint = joints.joint[slot];
  const std::uint64_t before = layout_key(joints, joint);
  const bool has_own = joint.def.kind == JointKind::six_axis || !(to == JointAxis());
  if (has_own && !joint.axes) reserve_slot(joints.axes.size(), joints.axes);
  wake_both(*this, joint.def);
  keep_axes(slot, has_own);
  if (has_own) joints.axes_of(joint)->axis[axis] = to;
  recount(*this, joint);
  mark_layout(*this, joint, before);
}

void World::keep_axes(std::uint32_t slot, bool any) {
  Joint& joint = joints.joint[slot];
  if (any && !joint.axes) give_axes(joints, slot);
  if (!any) take_axes(joints, joint);
}

void World::set_joint_turn(std::uint32_t slot, const TurnDrive& to) {
  Joint& joint = joints.joint[slot];
  const std::uint64_t before = layout_key(joints, joint);
  wake_both(*this, joint.def);
  const Vec3 p = joint.turn.p;
  joint.turn = to, joint.turn.p = p;
  mark_layout(*this, joint, before);
}

void World::set_transmission(std::uint32_t slot, const Transmission& transmission) {
  Joint& joint = joints.joint[slot];
  wake_both(*this, joint.def);
  joint.transmission = transmission;
  joints.clear_impulses(joint);
  ++scene.revision;
}

void World::break_joint(std::uint32_t slot) { dynamics::break_joint(Breaking(*this), slot); }

void break_joint(Breaking to, std::uint32_t slot) {
  Joints& joints = to;
  Joint& joint = joints.joint[slot];
  joint.broken = true;
  unpart(to, joint.def);
  Revisions& scene = to;
  ++scene.revision;
}

void break_overloaded(const World& world, Breaking to, Events& events) {
  const Joints& joints = world.joints;
  for (const std::uint32_t j : world.wide_joints->active) {
    const Joint& joint = joints.joint[j];
    if (joint.force.norm() <= joint.def.break_force && joint.torque.norm() <= joint.def.break_torque) continue;
    tell_broken(world, events, j);
    break_joint(to, j);
  }
}

}  // namespace carom::dynamics
