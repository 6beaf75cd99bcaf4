// Which islands joints alone hold: their bodies and joints side by side, and in which order joints are eliminated.
#include <algorithm>
#include <bit>
#include <numbers>
#include <span>

#include "dynamics/ccd/continuous.h"
#include "dynamics/force/force.h"
#include "dynamics/joint/axis_parts.h"
#include "dynamics/joint/parts.h"
#include "dynamics/joint/rattle/rattle.h"

namespace carom::dynamics::rattle {
namespace {

constexpr std::uint32_t kNoIsland = 0xFFFFFFFFu;
/// Joints on one body: each pair of them is a block, whatever order they are eliminated in.
constexpr std::size_t kMostSeats = 256;

std::uint32_t root(Array<std::uint32_t>& parent, std::uint32_t i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

bool is_moved(const World& world, std::uint32_t body) {
  return body != kInvalid && responds(world.scene, world.state, body);
}

/// Whether a body's locks leave it the turns of a body without, about one axis of the world alone, or none. About two
/// it would turn as no top does.
bool locks_are_holdable(Locks locks) { return std::popcount(static_cast<unsigned>(locks & kAngularLocks)) != 1; }

/// Whether a joint can be held exactly, with all that it does.
bool is_holdable(const World& world, const Joint& joint, const JointLayout& layout) {
  for (std::uint32_t k = 0; k < layout.drives; ++k)
    if (layout.drive[k].kind == DriveKind::rotor || layout.drive[k].kind == DriveKind::pace) return false;
  for (std::uint32_t k = 0; k < layout.parts; ++k)
    if (layout.part[k] == JointPart::turn_y || layout.part[k] == JointPart::turn_z ||
        (layout.part[k] == JointPart::turn_x && swing_plane(world.joints.axes_of(joint)) == SwingPlane::none))
      return false;
  for (const std::uint32_t body : {joint.def.body_a, joint.def.body_b}) {
    if (body == kInvalid) continue;
    if (!locks_are_holdable(world.scene.locks_of(body)) || world.state.held_out[body]) return false;
  }
  return true;
}

/// Bodies that hang together by joints and by springs: each its island's lowest slot.
void unite_bodies(const World& world, Rattle& r) {
  Array<std::uint32_t>& parent = r.parent;
  parent.resize(world.scene.bodies.slots());
  for (std::uint32_t i = 0; i < parent.size(); ++i) parent[i] = i;
  const auto join = [&](std::uint32_t a, std::uint32_t b) {
    if (!is_moved(world, a) || !is_moved(world, b)) return;
    const std::uint32_t one = root(parent, a), other = root(parent, b);
    parent[std::max(one, other)] = std::min(one, other);
  };
  for (const std::uint32_t j : r.all_active) join(world.joints.joint[j].def.body_a, world.joints.joint[j].def.body_b);
  world.plan->effects[+EffectId::springs].participants.each(
      [&](std::uint32_t k) { join(world.scene.springs.def[k].body_a, world.scene.springs.def[k].body_b); });
}

/// f(body) that forces move which are not constant: springs, drag, fields, magnets, water.
template <class F>
void each_forced(const World& world, F&& f) {
  for (const PlannedEffect& row : world.plan->effects) {
    const Effect& e = *row.effect;
    if (!e.force || e.stage != Stage::integrate || is_constant_in_a_step(e) || row.participants.count == 0) continue;
    if (e.participants == ParticipantKind::bodies) row.participants.each(f);
    if (e.id == EffectId::springs)
      row.participants.each([&](std::uint32_t k) {
        const SpringDef& def = world.scene.springs.def[k];
        for (const std::uint32_t i : {def.body_a, def.body_b})
          if (i != kInvalid) f(i);
      });
  }
}

/// Islands by their lowest slot, those that nothing forbids to hold.
void number_islands(const World& world, Rattle& r) {
  r.islands.clear();
  r.island_of.assign(world.scene.bodies.slots(), kNoIsland);
  const auto of = [&](const JointDef& def) -> std::uint32_t& {
    return r.island_of[root(r.parent, is_moved(world, def.body_a) ? def.body_a : def.body_b)];
  };
  for (const std::uint32_t j : r.all_active) of(world.joints.joint[j].def) = 0;
  if (moves_by_forces(world))
    each_forced(world, [&](std::uint32_t i) {
      if (is_moved(world, i)) r.island_of[root(r.parent, i)] = 0;
    });
  std::uint32_t count = 0;
  for (std::uint32_t& island : r.island_of)  // only roots are marked yet, and they are ascending
    if (island == 0) island = count++;
  r.islands.resize(count);
  for (RattleIsland& island : r.islands) island = {}, island.is_held = true;
  for (std::uint32_t i = 0; i < r.island_of.size(); ++i)
    if (is_moved(world, i)) r.island_of[i] = r.island_of[root(r.parent, i)];
  for (const std::uint32_t j : r.all_active) {
    const Joint& joint = world.joints.joint[j];
    RattleIsland& island = r.islands[of(joint.def)];
    const JointLayout layout = layout_of(world.joints, joint);
    if (!is_holdable(world, joint, layout)) island.is_held = false;
    ++island.joints;
  }
  for (std::uint32_t i = 0; i < r.island_of.size(); ++i) {
    if (r.island_of[i] == kNoIsland) continue;
    RattleIsland& island = r.islands[r.island_of[i]];
    ++island.movers;
    if (!locks_are_holdable(world.scene.locks_of(i))) island.is_held = false;
  }
  world.plan->effects[+EffectId::springs].participants.each([&](std::uint32_t k) {  // whose other end goes its own way
    const SpringDef& def = world.scene.springs.def[k];
    for (const auto& [own, other] : {std::pair(def.body_a, def.body_b), std::pair(def.body_b, def.body_a)})
      if (is_moved(world, own) && r.island_of[own] != kNoIsland && other != kInvalid && !is_moved(world, other) &&
          world.scene.type[other] != BodyType::fixed)
        r.islands[r.island_of[own]].is_held = false;
  });
}

RattleBody body_at(const World& world, std::uint32_t slot) {
  RattleBody b;
  b.slot = slot;
  b.travels = slot != kInvalid && world.scene.type[slot] == BodyType::kinematic;
  if (!is_moved(world, slot)) return b;
  b.inv_mass = world.scene.inv_mass[slot];
  b.locks = world.scene.locks_of(slot);
  b.turns = rotates(world.scene, slot) && (b.locks & kAngularLocks) != kAngularLocks;
  if (!b.turns) return b;
  b.inertia = world.scene.inertia[slot], b.inv_inertia = world.scene.inv_inertia[slot];
  b.top = principal_axes(b.inertia);
  return b;
}

/// Where a joint sits on its bodies: of what is locked, where the host has it locked now.
void place_frames(const World& world, RattleJoint& j) {
  const Joint& joint = world.joints.joint[j.slot];
  j.over = joint.transmission;
  const auto arm = [&](std::uint32_t body, const Pose& frame) {
    return body == kInvalid ? frame.p : frame.p - world.scene.center[body];
  };
  j.arm_a = arm(joint.def.body_a, joint.def.frame_a), j.arm_b = arm(joint.def.body_b, joint.def.frame_b);
  j.frame_a = joint.def.frame_a.q, j.frame_b = joint.def.frame_b.q;
  if (joint.axes) {
    const AxisOffsets off = offsets_of(world.joints.axes_of(joint));
    j.arm_a += j.frame_a * off.place;
    if (off.all_turns) j.frame_b = j.frame_b * off.orientation.conjugate();
    j.twist = off.turn.x();
  }
  j.axes_a = j.frame_a.matrix(), j.axes_b = j.frame_b.matrix();
}

/// A joint, its drives behind those of others.
RattleJoint joint_at(const World& world, std::uint32_t slot, Array<RattleDrive>& drives) {
  const Joint& joint = world.joints.joint[slot];
  const JointLayout layout = layout_of(world.joints, joint);
  RattleJoint j{};
  j.slot = slot;
  j.locks = j.rows = j.most_rows = layout.equalities, j.parts = layout.parts;
  std::copy_n(layout.part, layout.parts, j.part);
  j.drive = static_cast<std::uint32_t>(drives.size()), j.drives = layout.drives;
  std::uint32_t held = 0;
  for (std::uint32_t k = 0; k < layout.drives; ++k) {
    RattleDrive drive{};
    drive.row = layout.drive[k];
    held |= 1u << drive.row.coordinate;
    drives.push_back(drive);
  }
  j.most_rows = std::min<std::uint32_t>(kMostRows, j.most_rows + static_cast<std::uint32_t>(std::popcount(held)));
  j.plane = joint.def.kind == JointKind::six_axis ? swing_plane(world.joints.axes_of(joint)) : SwingPlane::none;
  j.is_counted = layout.drives > 0 || j.plane != SwingPlane::none;
  j.length = joint.def.length;
  j.two_ways = layout.two_ways, j.is_gear = joint.def.kind == JointKind::gear;
  place_frames(world, j);
  return j;
}

/// Which joints couplings couple, and on which bodies they act: all are of their island.
void find_coupled(const World& world, Rattle& r, const RattleIsland& island) {
  const auto begin = r.joints.begin() + island.joint, end = begin + island.joints;
  for (auto j = begin; j != end; ++j) {
    const Joint& joint = world.joints.joint[j->slot];
    if (!joint.coupling) continue;
    const Coupling& coupling = world.joints.coupling_of(joint);
    RattleCoupling& c = r.couplings.emplace_back();
    c = {};
    j->coupling = static_cast<std::uint32_t>(r.couplings.size());
    const auto find = [&](std::uint32_t slot) {
      const auto at =
          std::lower_bound(begin, end, slot, [](const RattleJoint& i, std::uint32_t s) { return i.slot < s; });
      at->is_counted = true;
      for (const std::uint32_t body : {at->a, at->b})
        if (body != 0 && std::find(c.body, c.body + c.count, body) == c.body + c.count) c.body[c.count++] = body;
      return static_cast<std::uint32_t>(at - r.joints.begin());
    };
    c.follower = find(coupling.follower), c.leader = find(coupling.leader);
  }
}

/// Bodies and joints of the islands, side by side; who does not move stands behind those who do, once for each joint.
void lay_out(const World& world, Rattle& r) {
  r.couplings.clear();
  r.bodies.clear(), r.joints.clear(), r.rows.clear(), r.drives.clear(), r.by_slot.clear();
  r.bodies.push_back(body_at(world, kInvalid));
  std::uint32_t body = 1, joint = 0;
  for (RattleIsland& island : r.islands) {
    if (!island.is_held) island.movers = island.joints = 0;
    island.body = body, island.joint = joint;
    body += island.movers + island.joints, joint += island.joints;  // reserved; what is left over is no body
    island.bodies = 0, island.joints = 0;
  }
  r.bodies.resize(body), r.joints.resize(joint);
  r.body_of.resize(world.scene.bodies.slots());
  for (std::uint32_t i = 0; i < r.island_of.size(); ++i) {
    if (r.island_of[i] == kNoIsland || !r.islands[r.island_of[i]].is_held) continue;
    RattleIsland& island = r.islands[r.island_of[i]];
    r.body_of[i] = island.body + island.bodies++;
    r.bodies[r.body_of[i]] = body_at(world, i);
    r.by_slot.push_back(i);
  }
  for (const std::uint32_t slot : r.all_active) {
    const JointDef& def = world.joints.joint[slot].def;
    RattleIsland& island = r.islands[r.island_of[is_moved(world, def.body_a) ? def.body_a : def.body_b]];
    if (!island.is_held) continue;
    RattleJoint& j = r.joints[island.joint + island.joints++] = joint_at(world, slot, r.drives);
    island.has_drives |= j.drives > 0;
    const auto end = [&](std::uint32_t at) {
      if (at == kInvalid) return std::uint32_t(0);
      if (is_moved(world, at)) return r.body_of[at];
      r.bodies[island.body + island.bodies] = body_at(world, at);
      return island.body + island.bodies++;
    };
    if (world.joints.joint[slot].coupling)
      j.a = j.b = 0, j.locks = j.rows = j.most_rows = 1;
    else
      j.a = end(def.body_a), j.b = end(def.body_b);
    island.reach = std::max({island.reach, j.arm_a.norm(), j.arm_b.norm()});
    island.least_block =
        std::max({island.least_block, 1, static_cast<int>(j.rows)});  // a spring alone holds nothing: 1
    island.block = std::max({island.block, 1, static_cast<int>(j.most_rows)});
  }
  if (!world.joints.couplings.empty())
    for (const RattleIsland& island : r.islands)
      if (island.is_held) find_coupled(world, r, island);
  for (RattleJoint& j : r.joints) {
    j.row = static_cast<std::uint32_t>(r.rows.size());
    r.rows.resize(r.rows.size() + j.most_rows);
  }
}

bool locks_turns(const RattleJoint& j) {
  return std::any_of(j.part, j.part + j.parts, [](JointPart part) { return part == JointPart::orientation; });
}

/// How fast joints that pull swing a body about the middle of those: that is how links of a chain swing against each
/// other, and one link about its joint.
///   w^2 = sum of F |r - c| / (I + m |c|^2),   c the mean of the arms r; of one joint F |r| / (I + m |r|^2)
/// A joint that locks all turns swings nothing: its bodies turn as one.
void weigh_swings(Rattle& r, std::span<const Rattle::Seat> seats) {
  for (std::size_t i = 0, end; i < seats.size(); i = end) {
    const auto arm = [&](const Rattle::Seat& s) { return s.is_a ? r.joints[s.joint].arm_a : r.joints[s.joint].arm_b; };
    Vec3 mean = Vec3::zero();
    for (end = i; end < seats.size() && seats[end].body == seats[i].body; ++end) mean += arm(seats[end]);
    mean = mean / static_cast<Real>(end - i);
    const RattleBody& b = r.bodies[seats[i].body];
    const Real inertia = b.top.moment.x() + mean.squared_norm() / b.inv_mass;  // the middle moment
    for (std::size_t k = i; k < end; ++k) {
      const Real far = (end - i == 1 ? mean : arm(seats[k]) - mean).norm();
      (seats[k].is_a ? r.joints[seats[k].joint].swing_a : r.joints[seats[k].joint].swing_b) =
          b.turns && inertia > 0 && !locks_turns(r.joints[seats[k].joint]) ? far / inertia : 0;
    }
  }
}

/// Block products that a factorisation of an island may take.
std::uint64_t allowed_work(std::uint32_t joints, int order) {
  const std::uint64_t less = order <= 2 ? kRattleLessAtOrder2.value : 1;
  return std::max(kRattleWork / less * joints, kRattleWorkOfFew / less);
}

/// Who sits on whom, and the order of elimination.
void couple(Rattle& r) {
  Elimination& order = r.elimination;
  order.clear();
  r.pairs.clear();
  std::size_t diagonal = 0, beside = 0;
  for (RattleIsland& island : r.islands) {
    island.pair = static_cast<std::uint32_t>(r.pairs.size());
    if (!island.is_held) continue;
    r.seats.clear(), r.edges.clear();
    for (std::uint32_t j = island.joint; j < island.joint + island.joints; ++j) {
      const RattleJoint& joint = r.joints[j];
      if (r.bodies[joint.a].inv_mass > 0) r.seats.push_back({joint.a, j, true});
      if (r.bodies[joint.b].inv_mass > 0) r.seats.push_back({joint.b, j, false});
    }
    std::sort(r.seats.begin(), r.seats.end());
    weigh_swings(r, r.seats);
    for (std::uint32_t j = island.joint; j < island.joint + island.joints; ++j) {
      if (!r.joints[j].coupling) continue;
      const RattleCoupling& c = r.couplings[r.joints[j].coupling - 1];
      for (std::uint32_t k = 0; k < c.count; ++k)
        if (r.bodies[c.body[k]].inv_mass > 0) r.seats.push_back({c.body[k], j, false, static_cast<std::uint8_t>(k)});
    }
    std::sort(r.seats.begin(), r.seats.end());
    std::size_t most = 0;
    for (std::size_t i = 0, end; i < r.seats.size(); i = end) {
      for (end = i + 1; end < r.seats.size() && r.seats[end].body == r.seats[i].body;) ++end;
      most = std::max(most, end - i);
    }
    // A system has its run of nodes, tried or not: places of later ones count from there.
    const bool is_dense = most > kMostSeats;
    for (std::size_t i = 0; !is_dense && i < r.seats.size(); ++i)
      for (std::size_t k = i + 1; k < r.seats.size() && r.seats[k].body == r.seats[i].body; ++k)
        if (r.seats[i].joint != r.seats[k].joint) r.edges.push_back({r.seats[i].joint, r.seats[k].joint});
    const std::uint64_t allowed = allowed_work(island.joints, r.order);
    const std::uint64_t work = eliminate(island.joint, island.joints, r.edges, {}, allowed, order);
    if (is_dense || work > allowed) {
      island.is_held = false;
      continue;
    }
    for (std::size_t i = 0; i < r.seats.size(); ++i)
      for (std::size_t k = i + 1; k < r.seats.size() && r.seats[k].body == r.seats[i].body; ++k) {
        const Rattle::Seat &one = r.seats[i], &other = r.seats[k];
        if (one.joint == other.joint) continue;
        const bool swap = order.place[one.joint] > order.place[other.joint];
        const Rattle::Seat &low = swap ? other : one, &high = swap ? one : other;
        const auto begin = order.rows.begin() + order.column[order.place[low.joint]],
                   end = order.rows.begin() + order.column[order.place[low.joint] + 1];
        const auto at = std::lower_bound(begin, end, order.place[high.joint]) - order.rows.begin();
        r.pairs.push_back(
            {high.joint, low.joint, static_cast<std::uint32_t>(at), one.body, high.is_a, low.is_a, high.end, low.end});
      }
    island.pairs = static_cast<std::uint32_t>(r.pairs.size()) - island.pair;
    island.diagonal = diagonal, island.beside = beside;
    const auto size = static_cast<std::size_t>(island.block * island.block);
    diagonal += size * island.joints;
    beside += size * (order.column[island.joint + island.joints] - order.column[island.joint]);
  }
  r.diagonal.resize(diagonal), r.below.resize(beside), r.above.resize(beside);
  r.left.resize(kMostRows * r.joints.size()), r.right.resize(kMostRows * r.joints.size());
}

}  // namespace

void make_islands(const World& world, Rattle& r, int order) {
  const Array<std::uint32_t>& active = world.wide_joints->active;
  if (r.revision == world.plan->revision && r.order == order && std::ranges::equal(r.all_active, active)) {
    for (RattleJoint& j : r.joints)  // a host moves locks without a change of the scene
      if (world.joints.joint[j.slot].axes || j.two_ways || j.is_gear) place_frames(world, j);
    return;
  }
  r.revision = 0, r.order = order;
  r.all_active = active;
  unite_bodies(world, r);
  number_islands(world, r);
  lay_out(world, r);
  couple(r);
  const std::uint32_t slots = world.scene.bodies.slots();
  r.trial.resize(slots);
  r.middle_v.resize(r.bodies.size()), r.middle_l.resize(r.bodies.size());
  r.revision = world.plan->revision;
}

void find_met(const World& world, Rattle& r, const StepTime& time) {
  const Real dt = time.dt, h = time.dt / world.plan->substeps;
  for (RattleIsland& island : r.islands) island.is_met = false;
  const auto meet = [&](std::uint32_t body) {
    if (body < r.island_of.size() && r.island_of[body] != kNoIsland) r.islands[r.island_of[body]].is_met = true;
  };
  for (const ContactPair& m : world.contacts->contact_pairs) meet(m.a), meet(m.b);
  if (!world.state.asleep.empty())
    for (const std::uint32_t i : r.by_slot)
      if (world.state.sleeps(i)) meet(i);
  // Decay that no force can follow, which the integrator knows in closed form.
  for (const PlannedEffect& row : world.plan->effects)
    if (row.effect->rate && row.effect->stage == Stage::integrate)
      row.participants.each([&](std::uint32_t i) {
        if (i < r.island_of.size() && row.effect->rate(world.scene, world.state, i) * h > 1) meet(i);
      });
  // What is swept may be anywhere on its way.
  const Colliders& c = world.scene.colliders;
  for (const SweptBody& swept : world.continuous->bodies) {
    if (!swept.swept) continue;
    const std::uint32_t own = swept.body < r.island_of.size() ? r.island_of[swept.body] : kNoIsland;
    for (std::uint32_t k = world.scene.first_collider[swept.body]; k != kInvalid; k = c.next[k]) {
      const Aabb way = swept_bounds(world, k, dt);
      for (const std::uint32_t other : c.live) {
        const std::uint32_t body = c.body[other];
        if (body == swept.body || (own != kNoIsland && r.island_of[body] == own)) continue;
        if (way.overlaps(swept_bounds(world, other, dt))) meet(swept.body), meet(body);
      }
    }
  }
}

}  // namespace carom::dynamics::rattle
