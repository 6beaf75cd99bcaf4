// Joints into lanes: who is active, colours, what a step starts from; and back.
#include "dynamics/joint/wide_joints.h"

#include <algorithm>

#include "dynamics/events/events.h"
#include "dynamics/integrate/integrator.h"
#include "dynamics/integrate/rotation/rotation.h"
#include "dynamics/island.h"
#include "dynamics/joint/axis_parts.h"
#include "dynamics/joint/coupled_rows.h"
#include "dynamics/joint/parts.h"
#include "dynamics/joint/turns.h"
#include "dynamics/solver/fill_lanes.h"
#include "dynamics/solver/soft_step.h"
#include "dynamics/warm_scale.h"

namespace carom::dynamics {
namespace {

constexpr std::uint32_t kNoPlace = 0xFFFFFFFFu, kSolvedDirectly = kColours + 1;

bool moves(const World& world, std::uint32_t body) {
  return body != kInvalid && yields(world.scene, world.state, body);
}
/// Whether a host forbids an effect to a joint: altogether, or to one of its bodies.
bool forbids(const World& world, std::size_t row, const JointDef& def) {
  const EffectModes& modes = world.scene.modes;
  const auto to = [&](std::uint32_t body) { return body != kInvalid && modes.forbids(row, body); };
  return modes.forbids(row) || to(def.body_a) || to(def.body_b);
}

/// Note what is forbidden to a joint, and whom of the table it calls for.
void count_parts(const World& world, Joints& joints, Joint& joint) {
  const std::uint64_t before = layout_key(joints, joint);
  joint.without_limits = forbids(world, +EffectId::joint_limits, joint.def);
  joint.without_motors = forbids(world, +EffectId::joint_motors, joint.def);
  if (layout_key(joints, joint) != before) joints.clear_impulses(joint);
  const auto any = [&](auto&& has) { return std::any_of(joint.drive.begin(), joint.drive.end(), has); };
  const DrivenAxes axes = driven_axes(joints, joint);
  const auto count = [&](std::size_t row, bool has, bool without) {
    world.plan->effects[row].wanted += has;
    world.plan->effects[row].participants.count += has && !without;
  };
  count(+EffectId::joint_limits, any([](const JointDrive& d) { return d.limit.on; }) || axes.limited,
        joint.without_limits);
  count(+EffectId::joint_motors, any([](const JointDrive& d) { return d.motor.on; }) || axes.driven,
        joint.without_motors);
}

/// Whether it takes part in the step. One end may sleep while the other is awake in a snapshot that somebody has changed.
bool is_awake(const World& world, std::uint32_t body) { return moves(world, body) && !world.state.sleeps(body); }

bool is_disabled(const World& world, std::uint32_t body) { return body != kInvalid && world.state.is_disabled(body); }

bool is_active(const World& world, const Joint& joint) {
  if (is_disabled(world, joint.def.body_a) || is_disabled(world, joint.def.body_b)) return false;
  if (joint.broken || forbids(world, +EffectId::joints, joint.def)) return false;
  if (joint.coupling) {
    const Coupling& coupling = world.joints.coupling_of(joint);
    const auto acts = [&](std::uint32_t j) { return is_active(world, world.joints.joint[j]); };
    return acts(coupling.follower) && acts(coupling.leader);
  }
  return is_awake(world, joint.def.body_a) || is_awake(world, joint.def.body_b);
}

std::uint32_t solver_body(const World& world, std::uint32_t body) {
  return body == kInvalid ? 0 : world.wide->body[body];
}

BothColours colours_of(const World& world, const Joint& joint) {
  const std::uint32_t a = joint.def.body_a, b = joint.def.body_b;
  return {world.wide->placing->taken.data(), moves(world, a), solver_body(world, a), moves(world, b),
          solver_body(world, b)};
}

bool is_gear(const JointLayout& layout) { return layout.parts == 1 && layout.part[0] == JointPart::gears; }

/// A place for each: four of one colour and layout share lanes; beyond the colours each has its own.
void place_lanes(const World& world, WideJoints& w) {
  w.place.resize(w.active.size());
  w.occupant.clear(), w.colours.clear(), w.joints.clear(), w.pulls.clear(), w.gears.clear(), w.axes.clear();
  std::uint32_t rows = 0, drives = 0;
  w.swept = 0;
  for (std::size_t k = 0; k < w.order.size(); ++k) {
    const WideJoints::Order& o = w.order[k];
    const bool first = k == 0, shares = !first && o.colour != kColours && o.colour == w.order[k - 1].colour &&
                                        o.key == w.order[k - 1].key && w.joints.back().occupied < kLanes;
    if (!first && o.colour != w.order[k - 1].colour && w.order[k - 1].colour < kColours)
      w.colours.push_back(static_cast<std::uint32_t>(w.joints.size()));
    if (!shares) {
      JointLanes& joint = w.joints.emplace_back();
      joint.layout = layout_of(world.joints, world.joints.joint[w.active[o.index]]);
      joint.first = rows, joint.first_drive = drives;
      rows += joint.layout.equalities, drives += joint.layout.drives;
      if (joint.layout.two_ways) {
        w.pulls.emplace_back();
        joint.pulled = static_cast<std::uint32_t>(w.pulls.size());
      }
      if (joint.layout.axed) {
        w.axes.emplace_back();
        joint.axed = static_cast<std::uint32_t>(w.axes.size());
      }
      if (is_gear(joint.layout)) {
        w.gears.emplace_back();
        joint.geared = static_cast<std::uint32_t>(w.gears.size());
      }
      w.occupant.insert(w.occupant.end(), kLanes, kNoPlace);
      if (o.colour != kSolvedDirectly) w.swept = static_cast<std::uint32_t>(w.joints.size());
    }
    JointLanes& joint = w.joints.back();
    w.place[o.index] = {static_cast<std::uint32_t>(w.joints.size() - 1), joint.occupied};
    w.occupant[kLanes * (w.joints.size() - 1) + joint.occupied++] = o.index;
  }
  if (!w.order.empty() && w.order.back().colour < kColours)
    w.colours.push_back(static_cast<std::uint32_t>(w.joints.size()));
  w.rows.resize(rows), w.drives.resize(drives);
}

void set_quat(LaneQuat& to, int lane, const Quat& q) {
  to.x[lane] = q.x(), to.y[lane] = q.y(), to.z[lane] = q.z(), to.w[lane] = q.w();
}

/// One joint, with poses and impulses of the present.
void fill(const World& world, std::uint32_t index, const Softness& soft, Real h, WideJoints& w, JointLanes& lanes,
          int lane) {
  const Joint& joint = world.joints.joint[w.active[index]];
  const Scene& scene = world.scene;
  const JointDef& def = joint.def;
  const JointEnds ends = ends_of(world, def);
  const bool warm = joint.p_h > 0 && scene.dials.choice(Dial::warm_start) != 0;
  const Real scale = warm ? warm_scale(h, joint.p_h) : 0;
  const auto side = [&](std::uint32_t body, std::uint32_t& solver, Lanes& inv_mass, LaneSymmetric& inertia) {
    solver = solver_body(world, body);
    set_mass(world, moves(world, body), body, inv_mass, inertia, lane);
  };
  side(def.body_a, lanes.a[lane], lanes.inv_mass_a, lanes.start_inertia_a);
  side(def.body_b, lanes.b[lane], lanes.inv_mass_b, lanes.start_inertia_b);
  set(lanes.start_a, lane, ends.arm_a), set(lanes.start_b, lane, ends.arm_b);
  set_quat(lanes.start_frame_a, lane, ends.a.q), set_quat(lanes.start_frame_b, lane, ends.b.q);
  set(lanes.start_gap, lane, ends.apart);
  lanes.length[lane] = joint.def.length;
  lanes.twist_ahead[lane] = 0;
  if (lanes.layout.counts || lanes.axed) {
    const Vec3 turned = counted_angles(world, joint, ends);
    set(lanes.twist, lane, turned.x());
    if (lanes.axed) {
      AxesLanes& axes = w.axes[lanes.axed - 1];
      set(axes.swing_y, lane, turned.y()), set(axes.swing_z, lane, turned.z());
      set(axes.ahead_y, lane, 0), set(axes.ahead_z, lane, 0);
    }
  }
  fill_transmission(world, joint, ends, w, lanes, lane);
  if (lanes.axed) fill_axes(world, joint, w.axes[lanes.axed - 1], lanes, lane);
  lanes.bias_rate[lane] = soft.bias_rate;
  lanes.mass_scale[lane] = soft.mass_scale;
  lanes.impulse_scale[lane] = soft.impulse_scale;
  const bool again = w.is_swept(index) && (is_kicked(w, def.body_a) || is_kicked(w, def.body_b));
  lanes.again[lane] = again ? 1 : 0;
  for (std::uint32_t k = 0; k < lanes.layout.equalities; ++k) w.rows[lanes.first + k].p[lane] = scale * joint.p[k];
  fill_drives(world, joint, {scale, h, again}, w, lanes, lane);
}

/// Empty lanes.
void empty(WideJoints& w, JointLanes& joint) {
  const JointLanes was = joint;
  joint = JointLanes{};
  joint.occupied = was.occupied, joint.first = was.first, joint.first_drive = was.first_drive;
  joint.layout = was.layout, joint.pulled = was.pulled, joint.geared = was.geared, joint.axed = was.axed;
  if (joint.pulled) w.pulls[joint.pulled - 1] = PullLanes{};
  if (joint.geared) w.gears[joint.geared - 1] = GearLanes{}, w.gears[joint.geared - 1].ratio = all(1);
  if (joint.axed) w.axes[joint.axed - 1] = AxesLanes{}, w.axes[joint.axed - 1].target.w = all(1);
  joint.start_frame_a.w = joint.start_frame_b.w = all(1);
  std::fill_n(w.rows.data() + joint.first, joint.layout.equalities, JointRowLanes{});
  std::fill_n(w.drives.data() + joint.first_drive, joint.layout.drives, JointDriveLanes{});
}

/// Bodies that hang on joints and on no contact.
void find_kicked(const World& world, WideJoints& w) {
  Contacts& c = *world.contacts;
  w.kicked.clear();
  if (world.plan->integrator != &kVelocityVerlet || !world.plan->runs[static_cast<std::size_t>(Stage::relax)]) return;
  for (const std::uint32_t i : c.bodies) {
    const std::uint32_t group = group_of(c, i);
    if (c.group_begin[group] == c.group_begin[group + 1]) w.kicked.emplace_back().body = i;
  }
}

/// Whether a rotation method carries a body, which is free to turn as it does.
bool turns_freely(const World& world, std::uint32_t body) {
  return turns_by_method(*world.plan, body) && !(world.scene.locks_of(body) & kAngularLocks);
}
/// Who moves on from a rotation method's predicted pose by what a solver changed, @see integrator.h.
bool is_turned_on(const World& world, std::uint32_t body) {
  const WideContacts& wide = *world.wide;
  if (wide.far_turners && wide.far_turn[wide.body[body]].led_on) return false;
  return turns_freely(world, body) && world.plan->touched[body] && !world.state.held_out[body];
}

/// rad/s, of an angular momentum.
Vec3 spin_at(const World& world, std::uint32_t body, const Quat& q, const Vec3& momentum) {
  return q * (world.scene.inv_inertia[body] * (q.conjugate() * momentum));
}

/// What a body's omega is where it now faces, if it keeps over the move the momentum of its rotation method's predicted pose
/// and of what the solver gave it, at the facing from which it moved.
Vec3 kept_spin(const World& world, const WideJoints::Kicked& k) {
  const State& s = world.state;
  const Vec3 momentum = inertia_at(world.scene, k.body, world.plan->predicted.q[k.body]) * k.omega +
                        inertia_at(world.scene, k.body, k.facing) * (s.omega[k.body] - k.omega);
  return spin_at(world, k.body, s.q[k.body], momentum);
}

/// How omega changes while nothing acts, of bodies that a rotation method carries. Not of those that turn by more than
/// a radian a substep: there nothing bends like a parabola.
void find_gyro(const World& world, Real h, WideJoints& w) {
  const WideContacts& wide = *world.wide;
  w.gyro.clear();
  if (!world.plan->rotation_method) return;
  w.gyro.resize(wide.slot.size());
  for (std::uint32_t i = wide.first_moved; i < wide.slot.size(); ++i) {
    const std::uint32_t body = wide.slot[i];
    const Vec3& omega = world.state.omega[body];
    if (!w.linked[body] || !turns_freely(world, body) || !(h * h * omega.squared_norm() < 1)) continue;
    const Quat& q = world.state.q[body];
    const Vec3 momentum = inertia_at(world.scene, body, q) * omega, a = spin_at(world, body, q, momentum.cross(omega));
    std::copy_n(a.data(), 3, w.gyro[i].omega);
  }
}

/// Poses as the step begins, where contacts may come to count from later ones.
void save_starts(const World& world, WideJoints& w) {
  const WideContacts& wide = *world.wide;
  w.start.clear(), w.shift.clear();
  if (!wide.far_turners) return;
  w.start.resize(wide.slot.size()), w.shift.resize(wide.slot.size());
  w.shift[0].w = 1;
  for (std::uint32_t i = 1; i < wide.slot.size(); ++i) {
    w.start[i] = {wide.start_q[i], wide.start_x[i]};
    w.shift[i].w = 1;
  }
}

/// Which way bodies are free, of joints some of whose bodies are locked.
void fill_locks(const World& world, WideJoints& w) {
  w.locks.clear();
  for (JointLanes& joint : w.joints) joint.locked = 0;
  if (world.plan->effects[+EffectId::axis_locks].candidates.count == 0) return;
  const auto locks_of = [&](std::uint32_t body) { return body == kInvalid ? Locks(0) : world.scene.locks_of(body); };
  for (std::uint32_t i = 0; i < w.active.size(); ++i) {
    const JointDef& def = world.joints.joint[w.active[i]].def;
    const Locks a = locks_of(def.body_a), b = locks_of(def.body_b);
    if (a | b) set_locks(w.locks, w.joints[w.place[i].lanes].locked, w.place[i].lane, a, b);
  }
}

/// How far bodies have come since the step began: contacts count from later where they were made anew.
void load_own_shifts(const World& world) {
  WideJoints& w = *world.wide_joints;
  if (!world.wide->far_turners) return;
  for (std::uint32_t i = 1; i < w.start.size(); ++i)
    w.shift[i] = shift_since(world.state, world.wide->slot[i], w.start[i]);
}

void place_rows(const World& world, const WideJoints& w) {
  over_joints(world, w.kernels->place);
  place_couplings(world);
}

}  // namespace

void plan_joints(const World& world, Joints& joints) {
  WideJoints& w = *world.wide_joints;
  w.active.clear(), w.linked.clear(), w.kicked.clear(), w.bounded.clear();
  w.is_packed = false;
  for (const std::size_t row : {+EffectId::joint_limits, +EffectId::joint_motors})
    world.plan->effects[row].wanted = world.plan->effects[row].participants.count = 0;
  world.plan->effects[+EffectId::joints].wanted = world.joints.slots.alive_count();
  if (world.joints.slots.alive_count() == 0) return;
  for (std::uint32_t j = 0; j < world.joints.slots.slots(); ++j)
    if (world.joints.alive(j) && is_active(world, world.joints.joint[j])) w.active.push_back(j);
  if (!w.any()) return;
  for (const std::uint32_t j : w.active) count_parts(world, joints, joints.joint[j]);
  w.linked.assign(world.scene.bodies.slots(), 0);
  for (const std::uint32_t j : w.active) {
    const JointDef& def = world.joints.joint[j].def;
    for (const std::uint32_t body : {def.body_a, def.body_b})
      if (body != kInvalid) w.linked[body] = 1;
  }
}

void link_joints(const World& world, const StepTime&) {
  Contacts& c = *world.contacts;
  c.links.clear();
  for (const std::uint32_t j : world.wide_joints->active) {
    const JointDef& def = world.joints.joint[j].def;
    c.links.push_back({def.body_a, def.body_b, is_awake(world, def.body_a), is_awake(world, def.body_b)});
  }
}

void colour_joints(const World& world) {
  WideJoints& w = *world.wide_joints;
  if (!w.any()) return;
  const Contacts& c = *world.contacts;
  const auto directly = [&](std::uint32_t link) { return !c.direct.empty() && c.direct[c.link_label[link]]; };
  bool all_swept = true;
  for (std::uint32_t i = 0; i < w.active.size() && all_swept; ++i) all_swept = !directly(i);
  if (w.is_packed && all_swept) {
    for (const WideJoints::Order& o : w.order) colours_of(world, world.joints.joint[w.active[o.index]]).take(o.colour);
    return;
  }
  w.order.clear();
  for (std::uint32_t i = 0; i < w.active.size(); ++i) {
    const Joint& joint = world.joints.joint[w.active[i]];
    const std::uint32_t colour = directly(i) ? kSolvedDirectly : colours_of(world, joint).take_lowest();
    w.order.push_back({layout_key(world.joints, joint), colour, i});
  }
  std::sort(w.order.begin(), w.order.end());
  place_lanes(world, w);
  w.is_packed = all_swept;
}

void begin_joints(const World& world, Real h) {
  WideJoints& w = *world.wide_joints;
  if (!w.any()) return;
  w.kernels = &joint_kernels(world.wide->kernels->name);
  find_kicked(world, w);
  save_starts(world, w);
  w.gyro.reserve(world.plan->rotation_method ? world.wide->slot.size() : 0);
  const Dials& dials = world.scene.dials;
  const Softness soft = softness(std::min(dials[Dial::joint_frequency], 0.25 / h), dials[Dial::joint_damping], h);
  in_parallel(world.jobs, w.joints.size(), kJointsAPart, [&](std::uint32_t i) {
    JointLanes& joint = w.joints[i];
    if (joint.occupied < kLanes) empty(w, joint);
    joint.force = joint.torque = {all(0), all(0), all(0)};
    for (std::uint32_t lane = 0; lane < joint.occupied; ++lane)
      fill(world, w.occupant[kLanes * i + lane], soft, h, w, joint, static_cast<int>(lane));
  });
  fill_locks(world, w);
  begin_couplings(world, h);
  place_rows(world, w);
}

void drop_impulses(WideJoints& w, std::uint32_t link) {
  const WideJoints::Place at = w.place[link];
  const JointLanes& joint = w.joints[at.lanes];
  const auto drop = [&](JointRowLanes& row) { set(row.p, static_cast<int>(at.lane), 0); };
  for (std::uint32_t r = 0; r < joint.layout.equalities; ++r) drop(w.rows[joint.first + r]);
  for (std::uint32_t r = 0; r < joint.layout.drives; ++r) drop(w.drives[joint.first_drive + r].row);
  for (CoupledRow& row : w.coupled())
    if (row.link == link) row.p = 0;
}

bool is_kicked(const WideJoints& w, std::uint32_t body) {
  return body != kInvalid && std::ranges::binary_search(w.kicked, body, {}, &WideJoints::Kicked::body);
}

void take_half_kicks(const World& world, Velocities& to) {
  const State& s = world.state;
  for (WideJoints::Kicked& k : world.wide_joints->kicked) {
    k.half = 0.5 * (s.v[k.body] - world.plan->begun[k.body].v);
    to.v[k.body] -= k.half;
    k.facing = s.q[k.body], k.omega = s.omega[k.body];
  }
}

void give_half_kicks(const World& world, Velocities& to) {
  const State& s = world.state;
  for (WideJoints::Kicked& k : world.wide_joints->kicked) {
    k.spun.set_zero();
    if (s.held_out[k.body]) k.half.set_zero();
    to.v[k.body] += k.half;
    if (!is_turned_on(world, k.body)) continue;
    const Vec3 omega = kept_spin(world, k);
    k.spun = omega - s.omega[k.body];
    to.omega[k.body] = omega;
  }
}

void place_joints(const World& world) {
  load_shifts(world, *world.wide);
  load_own_shifts(world);
  place_rows(world, *world.wide_joints);
}

void bend_joints(const World& world, Real h) {
  WideJoints& w = *world.wide_joints;
  if (!w.any()) return;
  find_gyro(world, h, w);
  over_joints(world, [&](const JointRun& run) { w.kernels->bend(run, h); });
  bend_couplings(world, h);
}

void return_to_joints(const World& world) {
  const WideJoints& w = *world.wide_joints;
  if (!w.any()) return;
  load_velocities(world, *world.wide);  // half kicks, and the direct solver's solutions
  load_own_shifts(world);
  place_rows(world, w);
  if (w.kicked.empty()) return;
  sweep_joints(world, w.kernels->act_again, [](std::uint32_t) {});
  act_again_by_couplings(world);
}

void end_joints(const World& world, Breaking to, Events& events, const StepTime& time) {
  WideJoints& w = *world.wide_joints;
  if (!w.any()) return;
  Joints& joints = to;
  in_parallel(world.jobs, w.active.size(), kLanes * kJointsAPart, [&](std::uint32_t i) {
    Joint& joint = joints.joint[w.active[i]];
    const JointLanes& lanes = w.joints[w.place[i].lanes];
    const std::uint32_t lane = w.place[i].lane;
    for (std::uint32_t k = 0; k < lanes.layout.equalities; ++k) joint.p[k] = w.rows[lanes.first + k].p[lane];
    keep_drives(world, joints, joint, w, lanes, lane);
    joint.p_h = time.h;
    if (lanes.geared) joint.transmission.phase = phase_of(world, joint, w, lanes, lane);
    const AxesLanes* const axes = lanes.axed ? &w.axes[lanes.axed - 1] : nullptr;
    const Vec3 led(lanes.twist[lane], axes ? axes->swing_y[lane] : 0, axes ? axes->swing_z[lane] : 0);
    count_angles(world, joint, lanes.layout.counts ? &led : nullptr, time.dt);
    joint.force = get(lanes.force, lane) / time.dt;
    joint.torque = get(lanes.torque, lane) / time.dt;
    if (!has_sane_impulses(joints, joint)) start_cold(joints, joint);
  });
  end_couplings(world, joints, time.dt);
  if (!world.plan->in_pass) break_overloaded(world, to, events);
}

namespace {

void aim(const World& world, const Joint& of, WideJoints& w, JointLanes& joint, std::uint32_t lane, Real h) {
  const int k = static_cast<int>(lane);
  AxesLanes* const axes = joint.axed ? &w.axes[joint.axed - 1] : nullptr;
  const Vec3 at(joint.twist[lane], axes ? axes->swing_y[lane] : 0, axes ? axes->swing_z[lane] : 0);
  const Vec3 ahead = turns_ahead(world, of, at, h);
  set(joint.twist_ahead, k, ahead.x());
  if (axes) set(axes->ahead_y, k, ahead.y()), set(axes->ahead_z, k, ahead.z());
}

/// Of wheels, each relative to the world.
void aim_gear(const World& world, const Joint& of, GearLanes& gear, std::uint32_t lane, Real h) {
  const auto turns = [&](std::uint32_t body, const Pose& frame) {
    if (body == kInvalid) return Real(0);
    const Real turn = h * world.state.omega[body].dot(world.state.q[body] * (frame.q * Vec3::unit_x()));
    return std::fabs(turn) > kNearby ? turn : Real(0);
  };
  set(gear.ahead_a, static_cast<int>(lane), turns(of.def.body_a, of.def.frame_a));
  set(gear.ahead_b, static_cast<int>(lane), turns(of.def.body_b, of.def.frame_b));
}

}  // namespace

void aim_joints(const World& world, Real h) {
  WideJoints& w = *world.wide_joints;
  if (!w.any()) return;
  in_parallel(world.jobs, w.joints.size(), kJointsAPart, [&](std::uint32_t i) {
    JointLanes& joint = w.joints[i];
    if (!joint.layout.counts && !joint.geared) return;
    for (std::uint32_t lane = 0; lane < joint.occupied; ++lane) {
      const Joint& of = world.joints.joint[w.active[w.occupant[kLanes * i + lane]]];
      joint.geared ? aim_gear(world, of, w.gears[joint.geared - 1], lane, h) : aim(world, of, w, joint, lane, h);
    }
  });
  aim_couplings(world, h);
}

}  // namespace carom::dynamics
