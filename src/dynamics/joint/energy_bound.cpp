// Groups that joints may give no energy.
#include "dynamics/joint/energy_bound.h"

#include <algorithm>
#include <atomic>

#include "dynamics/contact/contact.h"
#include "dynamics/force/force.h"
#include "dynamics/integrate/rotation/rotation.h"
#include "dynamics/island.h"
#include "dynamics/joint/rattle/rattle.h"
#include "dynamics/joint/wide_joints.h"
#include "dynamics/solver/fill_lanes.h"

namespace carom::dynamics {
namespace {

using Bounded = WideJoints::Bounded;
using GroupBound = WideJoints::GroupBound;

/// m/s: how fast the points of a body are within a distance.
Real speed_of(const State& s, std::uint32_t body, Real arm) {
  return body == kInvalid ? 0 : s.v[body].norm() + s.omega[body].norm() * arm;
}

void find_drives(const World& world, WideJoints& w) {
  const Contacts& c = *world.contacts;
  const auto meet = [&](GroupBound& group, std::uint32_t body, Real arm) {
    group.is_held = true;
    group.surface = std::max(group.surface, speed_of(world.state, body, arm));
  };
  for (std::uint32_t i = 0; i < w.active.size(); ++i) {
    GroupBound& group = w.bounds[c.link_label[i]];
    const Link& link = c.links[i];
    const JointLanes& joint = w.joints[w.place[i].lanes];
    if (!link.moves_a) meet(group, link.a, get(joint.start_a, w.place[i].lane).norm());
    if (!link.moves_b) meet(group, link.b, get(joint.start_b, w.place[i].lane).norm());
    for (std::uint32_t k = 0; k < joint.layout.drives; ++k)
      group.is_driven |=
          joint.layout.drive[k].kind != DriveKind::limit && joint.layout.drive[k].kind != DriveKind::pace;
  }
  for (const ContactPair& m : c.contact_pairs) {
    GroupBound& group = w.bounds[c.label[m.row]];
    const RowGeometry& g = c.geometry[m.row];
    if (!m.moves_a) meet(group, m.a, g.l_a.norm() + g.radius_a);
    if (!m.moves_b) meet(group, m.b, g.l_b.norm() + g.radius_b);
  }
}

/// J, of motion: with the moments of the pose to which omega belongs.
Real energy(const World& world, std::uint32_t body, const Vec3& v, const Vec3& omega, const Quat& q) {
  const Vec3 spin = q.conjugate() * omega;
  return (world.scene.mass[body] * v.squared_norm() + spin.dot(world.scene.inertia[body] * spin)) / 2;
}

bool gapes(const JointLanes& joint, std::uint32_t lane, const JointRowLanes& row, Real by, Real slack) {
  if (!(by > 0)) return false;
  if (get(row.d, lane) == Vec3::zero()) return by > kUnresolvedGap;
  return by > slack + kUnresolvedGap * std::max(get(joint.r_a, lane).norm(), get(joint.r_b, lane).norm());
}

/// Whether a joint is far from where it should be.
bool gapes(const WideJoints& w, const WideJoints::Place& at, Real slack) {
  const JointLanes& joint = w.joints[at.lanes];
  bool any = false;
  for (std::uint32_t k = 0; k < joint.layout.equalities; ++k) {
    const JointRowLanes& row = w.rows[joint.first + k];
    any |= gapes(joint, at.lane, row, std::fabs(get(row.error, at.lane)), slack);
  }
  for (std::uint32_t k = 0; k < joint.layout.drives; ++k) {
    const JointDriveLanes& drive = w.drives[joint.first_drive + k];
    if (joint.layout.drive[k].kind != DriveKind::limit) continue;
    const Real x = get(drive.row.error, at.lane);
    any |=
        gapes(joint, at.lane, drive.row, std::max(get(drive.lower, at.lane) - x, x - get(drive.upper, at.lane)), slack);
  }
  return any;
}

/// Which groups have joints that are not resolved, of those that nothing drives.
bool find_unresolved(const World& world, WideJoints& w, Real h) {
  const Real slack = 4 * world.scene.dials[Dial::position_tolerance];
  bool any = false;
  for (GroupBound& group : w.bounds) {
    group.is_unresolved = group.turns_far = false;
  }
  for (std::uint32_t i = 0; i < w.active.size(); ++i) {
    GroupBound& group = w.bounds[world.contacts->link_label[i]];
    if (group.is_driven || group.is_unresolved) continue;
    any |= group.is_unresolved = gapes(w, w.place[i], slack);
  }
  if (w.linked.empty()) return any;
  for (const Bounded& b : w.bounded) {
    GroupBound& group = w.bounds[b.group];
    if (group.is_driven || group.turns_far || !w.linked[b.body]) continue;
    if (turns_by_method(*world.plan, b.body)) {
      const Real omega2 =
          std::max(world.state.omega[b.body].squared_norm(), b.omega.squared_norm());  // and as it began
      group.turns_far = h * h * omega2 > kUnresolvedTurn * kUnresolvedTurn;
    }
    if (world.rattle) group.turns_far |= rattle::is_given_up(world, b.body);
    any |= group.turns_far, group.is_unresolved |= group.turns_far;
  }
  return any;
}

/// Energies of groups before the solver and now.
/// @param bounds      (group) -> whether that matters
/// @param facing      (bounded body) -> the pose to which its omega belongs now
template <class Bounds, class Facing>
void sum_up(const World& world, WideJoints& w, const Bounds& bounds, const Facing& facing) {
  const State& s = world.state;
  for (GroupBound& group : w.bounds) group.before = group.after = group.mass = 0, group.momentum.set_zero();
  in_parallel(world.jobs, w.bounded.size(), kBodiesAPart, [&](std::uint32_t i) {
    Bounded& b = w.bounded[i];
    if (!bounds(w.bounds[b.group])) return;
    b.before = energy(world, b.body, b.v, b.omega, b.q);
    b.after = energy(world, b.body, s.v[b.body], s.omega[b.body], facing(b));
  });
  for (const Bounded& b : w.bounded) {
    GroupBound& group = w.bounds[b.group];
    if (!bounds(group)) continue;
    group.before += b.before, group.after += b.after;
    group.mass += world.scene.mass[b.body];
    group.momentum += world.scene.mass[b.body] * s.v[b.body];
  }
  for (GroupBound& group : w.bounds) {
    const Real thrown = kThrow * group.surface;
    group.before = std::max(group.before, group.mass * thrown * thrown / 2);
  }
}

/// What bodies of such groups do relative to each other, slowed to the energy that they had.
template <class Bounds>
void slow_down(const World& world, Velocities& to, const WideJoints& w, const Bounds& bounds) {
  const State& s = world.state;
  in_parallel(world.jobs, w.bounded.size(), kBodiesAPart, [&](std::uint32_t i) {
    const Bounded& b = w.bounded[i];
    const GroupBound& group = w.bounds[b.group];
    if (!bounds(group) || !(group.after > group.before) || s.held_out[b.body]) return;
    const Vec3 common = group.is_held ? Vec3(Vec3::zero()) : Vec3(group.momentum / group.mass);
    const Real kept = group.mass * common.squared_norm() / 2, own = group.after - kept;
    const Real share = own > 0 ? std::sqrt(std::clamp((group.before - kept) / own, Real(0), Real(1))) : 0;
    to.v[b.body] = common + share * (s.v[b.body] - common);
    to.omega[b.body] = share * s.omega[b.body];
  });
}

/// Groups that the impulses of the last substep gave energy. Among those that are not resolved.
bool find_gains(const World& world, WideJoints& w) {
  const WideContacts& wide = *world.wide;
  for (GroupBound& group : w.bounds) group.before = group.after = 0;
  for (const Bounded& b : w.bounded) {
    GroupBound& group = w.bounds[b.group];
    if (!group.is_unresolved) continue;
    const std::uint32_t i = wide.body[b.body];
    const BodyVelocity& u = wide.velocity[i];
    const bool led_back = wide.far_turners && wide.far_turn[i].led_back;
    group.before += energy(world, b.body, b.v, b.omega, b.q);
    group.after += energy(world, b.body, {u.v[0], u.v[1], u.v[2]}, {u.omega[0], u.omega[1], u.omega[2]},
                          led_back ? world.state.q[b.body] : b.q);
  }
  bool any = false;
  for (GroupBound& group : w.bounds) any |= group.gains = group.after > group.before;
  return any;
}

}  // namespace

void find_bounded(const World& world, Real h) {
  WideJoints& w = *world.wide_joints;
  Contacts& c = *world.contacts;
  w.bounded.clear(), w.bounds.clear();
  if (!c.is_grouped || !c.surface.empty()) return;
  if (!w.any()) return;
  w.bounds.resize(c.groups());
  find_drives(world, w);
  for (const std::uint32_t body : c.bodies) {
    const std::uint32_t group = group_of(c, body);
    if (w.bounds[group].is_driven || !c.has_joints(group)) continue;
    w.bounded.push_back({body, group, Vec3::zero(), world.state.omega[body], Quat::identity(), 0, 0});
  }
  if (!w.bounded.empty()) find_unresolved(world, w, h);
}

void save_energies(const World& world) {
  const State& s = world.state;
  const Plan& plan = *world.plan;
  Array<Bounded>& bounded = world.wide_joints->bounded;
  in_parallel(world.jobs, bounded.size(), kBodiesAPart, [&](std::uint32_t i) {
    Bounded& b = bounded[i];
    b.v = s.v[b.body], b.omega = s.omega[b.body];
    b.q = turns_by_method(plan, b.body) ? plan.predicted.q[b.body] : s.q[b.body];
  });
}

void refuse_start(const World& world) {
  WideJoints& w = *world.wide_joints;
  WideContacts& wide = *world.wide;
  const Contacts& c = *world.contacts;
  const State& s = world.state;
  if (std::ranges::none_of(w.bounds, &GroupBound::is_unresolved) || !find_gains(world, w)) return;
  for (const Bounded& b : w.bounded) {
    if (!w.bounds[b.group].gains) continue;
    BodyVelocity& u = wide.velocity[wide.body[b.body]];
    for (int k = 0; k < 3; ++k) u.v[k] = s.v[b.body][k], u.omega[k] = s.omega[b.body][k];
  }
  for (std::uint32_t i = 0; i < w.active.size(); ++i)
    if (w.bounds[c.link_label[i]].gains && w.is_swept(i)) drop_impulses(w, i);
  with_lanes(wide, [&](auto& lanes, const auto&) {
    for (const WideContacts::Manifold& m : wide.manifolds) {
      if (!w.bounds[c.label[m.row]].gains) continue;
      auto& pair = lanes.pairs[m.pair];
      for (std::uint32_t k = 0; k < m.points; ++k) lanes.points[pair.first + k].p_n[m.lane] = 0;
      pair.p_t[m.lane] = pair.p_s[m.lane] = pair.p_w[m.lane] = 0;
    }
  });
}

void bound_moves(const World& world, Velocities& to) {
  WideJoints& w = *world.wide_joints;
  if (w.bounded.empty() || std::ranges::none_of(w.bounds, &GroupBound::turns_far)) return;
  const auto turns_far = [](const GroupBound& group) { return group.turns_far; };
  sum_up(world, w, turns_far, [](const Bounded& b) { return b.q; });
  slow_down(world, to, w, turns_far);
  for (const Bounded& b : w.bounded)  // or they would move as their integrator predicted
    if (w.bounds[b.group].turns_far && w.bounds[b.group].after > w.bounds[b.group].before)
      world.plan->touched[b.body] = true;
}

void bound_energies(const World& world, Velocities& to, Real h) {
  WideJoints& w = *world.wide_joints;
  if (w.bounded.empty() || !find_unresolved(world, w, h)) return;
  const auto is_unresolved = [](const GroupBound& group) { return group.is_unresolved; };
  sum_up(world, w, is_unresolved, [&](const Bounded& b) { return world.state.q[b.body]; });
  slow_down(world, to, w, is_unresolved);
}

}  // namespace carom::dynamics
