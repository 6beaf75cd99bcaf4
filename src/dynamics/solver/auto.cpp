// The solver that chooses: the direct solver for few bodies, and for those of which soft contacts would not hold more.
//
// A group of up to direct_few couplings, joints and pairs that touch, goes to the direct solver, a larger one where
//  - bodies that touch have masses further apart than direct_ratio, or
//  - for two steps a point has borne so much that soft contacts would let it sink by more than direct_sink of its
//    thickness: that is what a tall stack and a heavy load on a light body have in common, and it is known before anything
//    is solved;
// unless something strikes it (an impact sends the direct solver through all of a heap, and passes), it is too large, or
// could not be solved within direct_work lately: then it moves so much that soft contacts will do. So it is with few
// couplings without joints that could not be solved, until something sinks in another by more than tolerable_depth.
// Joints hold either way: velocities that soft contacts leave are led onto them.
#include <algorithm>
#include <array>
#include <numbers>
#include <span>

#include "dynamics/contact/depth.h"
#include "dynamics/force/force.h"
#include "dynamics/integrate/rotation/rotation.h"
#include "dynamics/island.h"
#include "dynamics/joint/wide_joints.h"
#include "dynamics/solver/auto_constants.h"
#include "dynamics/solver/direct.h"
#include "dynamics/solver/far_turns.h"
#include "dynamics/solver/pair_points.h"
#include "dynamics/solver/soft_step.h"
#include "dynamics/solver/solver.h"

namespace carom::dynamics {
namespace {

/// Squared angular frequency of the springs between two bodies that move.
Real stiffness(const Dials& dials, Real h) {
  const Real w = 2 * std::numbers::pi * std::min(dials[Dial::contact_frequency], 0.25 / h);
  return w * w;
}

/// @param row  a contact or a joint
template <class Both>
Real mass_ratio_of(const Scene& scene, const Both& row) {
  if (!row.moves_a || !row.moves_b) return 1;
  const Real a = scene.mass[row.a], b = scene.mass[row.b];
  return std::max(a, b) / std::min(a, b);
}

/// Bodies that move, each at every row it has.
template <class F>
void each_body(const Contacts& c, std::size_t group, F&& f) {
  for (std::uint32_t k = c.group_begin[group]; k < c.group_begin[group + 1]; ++k) {
    const Row& row = c.rows[c.group_rows[k]];
    if (row.moves_a) f(row, row.a);
    if (row.moves_b) f(row, row.b);
  }
}

/// Bodies of a group, each once: those whose load is known.
class Seen {
 public:
  /// @param load  of the body: Contacts::kUnseen where it is new
  void mark(std::uint8_t& load, std::uint32_t body, std::uint8_t as) {
    if (load == Contacts::kUnseen) body_[count_++] = body;
    load = std::max(load, as);
  }
  std::span<const std::uint32_t> all() const { return {body_.data(), count_}; }

 private:
  std::array<std::uint32_t, kMostDirectBodies> body_;
  std::size_t count_ = 0;
};

/// N: all that a group weighs, if it is new and lies still, as what a host has built does: then nothing else is known
/// yet of what its points will bear. Where an accuracy is set it may move: what settles on soft contacts first is off by
/// what they give. Else 0. Marks bodies that it counts as light.
Real weight_if_new(const World& world, std::size_t group, Real h, Seen& seen) {
  Contacts& c = *world.contacts;
  if (c.rows[c.group_rows[c.group_begin[group]]].p != Vec3::zero()) return 0;  // the common case, at once
  const Real gravity = world.scene.gravity.norm();
  const bool may_move = world.scene.dials[Dial::accuracy_place] > 0;
  Real mass = 0;  // kg, as heavy where the world's gravity acts in full
  bool is_new = true;
  each_body(c, group, [&](const Row& row, std::uint32_t body) {
    is_new &= row.p == Vec3::zero();
    if (c.load[body] != Contacts::kUnseen) return;
    seen.mark(c.load[body], body, Contacts::kLight);
    const Real pull = std::fabs(world.scene.gravity_factor_of(body));
    mass += pull * world.scene.mass[body];
    is_new &= may_move || world.state.v[body].norm() <= 2 * (pull * gravity) * h;
  });
  return is_new ? mass * gravity : 0;
}

/// Of bodies that joints hold, the heaviest over the lightest: what hangs on what is light is as hard to hold over some
/// links as over one.
void look_at_joints(const World& world, std::size_t group, GroupView& view) {
  const Contacts& c = *world.contacts;
  if (!c.has_joints(group)) return;
  Real least = kInfinity, most = 0;
  const auto meet = [&](bool moves, std::uint32_t body) {
    if (!moves) return;
    least = std::min(least, world.scene.mass[body]), most = std::max(most, world.scene.mass[body]);
  };
  for (std::uint32_t k = c.group_link_begin[group]; k < c.group_link_begin[group + 1]; ++k) {
    const Link& link = c.links[c.group_links[k]];
    meet(link.moves_a, link.a), meet(link.moves_b, link.b);
  }
  view.mass_ratio = std::max(view.mass_ratio, most / least);
}

/// Whether a body of a row turns farther in a step than its rotation method and its masses go with. What rolls may spin
/// about its axis as fast as it likes.
bool turns_far(const World& world, const Row& row, std::uint32_t body, Real h) {
  if (!turns_by_method(*world.plan, body)) return false;
  const Real dt = world.plan->substeps * h;
  return row.rolls ? turns_too_far(world, body, dt * world.state.omega[body])
                   : turns_far_for_its_shape(world, body, dt);
}

/// What there is to know of a group before it is solved; bodies that bear too much are marked as heavy.
/// @return whether it is under impact: points close fast, or bodies turn far
bool look_at(const World& world, std::size_t group, Real w2, Real h, Real weight, GroupView& view, Seen& seen) {
  Contacts& c = *world.contacts;
  const Scene& scene = world.scene;
  const Real rate = 1 / h, gravity = scene.gravity.norm();
  bool is_under_impact = false;
  const auto sources = [&](const PairRows& pair, PointSources& of) {
    of = point_sources(world, pair);
    const auto put = [&](bool moves, std::uint32_t body, const double*& inv_inertia, double& inv_mass) {
      inv_inertia = moves && rotates(scene, body) ? c.inv_inertia_w[body].data() : kNoMatrix;
      inv_mass = moves ? scene.inv_mass[body] : 0;
    };
    const Row& row = c.rows[pair.row];
    put(row.moves_a, row.a, of.inv_inertia_a, of.inv_mass_a);
    put(row.moves_b, row.b, of.inv_inertia_b, of.inv_mass_b);
    return true;
  };
  const std::uint32_t begin = c.group_begin[group];
  const std::span<const std::uint32_t> rows(c.group_rows.data() + begin, c.group_begin[group + 1] - begin);
  each_pair(c, rows, sources, world.wide->kernels->points.watch, [&](const PairRows& pair, const PointMotions& points) {
    const Row& row = c.rows[pair.row];
    const Real thickness = least_thickness(world, c.geometry[pair.row]);
    const Real pull = pull_on(scene, row, gravity);
    const Real fall = 2 * pull * thickness;                             // (m/s)^2
    const Real thick = 1 / (row.moves_a && row.moves_b ? w2 : 4 * w2);  // s^2
    const Real give = soft_give(thick, pull, thickness) / thickness;    // s^2/m
    const Real share = weight / pair.count;                             // N
    const Real deep = scene.dials[Dial::direct_sink];
    view.mass_ratio = std::max(view.mass_ratio, mass_ratio_of(scene, row));
    Real most = 0;
    for (std::uint32_t k = 0; k < pair.count; ++k) {
      const Real load = std::max(points.p_n[k] * rate, share);
      // How deep soft contacts let the point sink, of the thickness of what touches: P / (m w^2) over that.
      if (load > 0) most = std::max(most, load * points.response[k] * give);
      is_under_impact |= points.closing[k] * points.closing[k] > kImpactShare * fall;
    }
    const auto bears = [&](bool moves, std::uint32_t body) {
      is_under_impact |= moves && turns_far(world, row, body, h);
      if (moves) seen.mark(c.load[body], body, most > deep ? Contacts::kHeavy : Contacts::kLight);
    };
    bears(row.moves_a, row.a), bears(row.moves_b, row.b);
    view.sink = std::max(view.sink, most);
  });
  return is_under_impact;
}

/// In SolverMemory::cooldown_steps, beside the steps that are left: its impulses of the last step are the direct
/// solver's, of joints or of what came nowhere near a solution, and no start for soft contacts.
constexpr std::uint8_t kOfDirect = 0x80;
static_assert(kCooldown < kOfDirect);

bool cools_down(std::uint8_t rest) { return (rest & ~kOfDirect) > 0; }
void count_down(std::uint8_t& rest) {
  if (cools_down(rest)) --rest;
}

struct GroupMemory {
  bool bears = false, cools_down = false;
};

/// What bodies of a group remember, brought up to date. An impact is as heavy as a load, but passes: only what was
/// borne for two steps counts, and then for a while.
/// @param at_once  loads count from the first step on
GroupMemory remember(const World& world, SolverMemory& of, const Seen& seen, bool at_once) {
  Contacts& c = *world.contacts;
  GroupMemory memory;
  for (const std::uint32_t body : seen.all()) {
    std::uint8_t &steps = of.loaded_steps[body], &rest = of.cooldown_steps[body];
    if (c.load[body] == Contacts::kHeavy)
      steps = at_once || steps + 1 >= kBorneFor ? kBearsFor.value : static_cast<std::uint8_t>(steps + 1);
    else if (steps > 0)
      --steps;
    memory.bears |= steps >= kBorneFor;
    memory.cools_down |= cools_down(rest);
    count_down(rest);
    c.load[body] = Contacts::kUnseen;
  }
  return memory;
}

/// Of a group of more than few bodies.
GroupReason reason_for(const GroupView& view, bool is_under_impact, const GroupMemory& memory, bool joined,
                       Real most_ratio) {
  const bool unlike = view.mass_ratio > most_ratio;
  if (!unlike && !memory.bears) return GroupReason::ordinary;
  const bool held_softly = view.sink < kTolerableDepth;  // else they would throw about what is light
  if (memory.cools_down && (!unlike || joined || held_softly)) return GroupReason::too_much;
  if (unlike) return GroupReason::mass_ratio;
  return is_under_impact ? GroupReason::impact : GroupReason::sink;
}

bool is_solved_directly(GroupReason reason) {
  return reason == GroupReason::mass_ratio || reason == GroupReason::sink || reason == GroupReason::few;
}

bool any_cools_down(const World& world, std::size_t group) {
  bool any = false;
  each_body(*world.contacts, group,
            [&](const Row&, std::uint32_t body) { any |= cools_down(world.state.cooldown_steps[body]); });
  return any;
}

/// Whether soft contacts let something of a group sink by more than it may.
bool has_sunk(const World& world, std::size_t group) {
  const Contacts& c = *world.contacts;
  for (std::uint32_t k = c.group_begin[group]; k < c.group_begin[group + 1]; ++k) {
    const RowGeometry& g = c.geometry[c.group_rows[k]];
    if (g.separation < 0 && g.separation < -kTolerableDepth * least_thickness(world, g)) return true;
  }
  return false;
}

std::uint32_t first_body(const Contacts& c, std::size_t group) {
  const auto of = [](const auto& both) { return both.moves_a ? both.a : both.b; };
  const std::uint32_t begin = c.group_begin[group];
  return begin < c.group_begin[group + 1] ? of(c.rows[c.group_rows[begin]])
                                          : of(c.links[c.group_links[c.group_link_begin[group]]]);
}

/// What is to be known of a group, the choice among it. Writes what bodies of the group remember.
GroupView view_of(const World& world, SolverMemory& of, std::size_t group, Real w2, Real h) {
  const Contacts& c = *world.contacts;
  const Real most_ratio = world.scene.dials[Dial::direct_ratio];
  GroupView view;
  view.body = first_body(c, group);
  view.bodies = c.group_size[group].bodies, view.points = c.group_begin[group + 1] - c.group_begin[group];
  if (view.bodies > kMostDirectBodies) {
    view.reason = GroupReason::too_much;
    return view;
  }
  if (is_few(c, group)) {
    const bool rests = !c.has_joints(group) && any_cools_down(world, group) && !has_sunk(world, group);
    view.reason = rests ? GroupReason::too_much : GroupReason::few;
    return view;
  }
  look_at_joints(world, group, view);
  if (view.points == 0) {
    view.reason = view.mass_ratio > most_ratio ? GroupReason::mass_ratio : GroupReason::ordinary;
    return view;
  }
  Seen seen;
  const Real weight = weight_if_new(world, group, h, seen);
  const bool is_under_impact = look_at(world, group, w2, h, weight, view, seen);
  const GroupMemory memory = remember(world, of, seen, weight > 0);
  view.reason = reason_for(view, is_under_impact, memory, c.has_joints(group), most_ratio);
  return view;
}

bool is_looked_at(const Contacts& c, std::size_t group) {
  return !is_few(c, group) && c.group_size[group].bodies <= kMostDirectBodies;
}

/// Bodies of groups that are not looked at: what they remember of another one passes all the same.
void count_down_elsewhere(const World& world, SolverMemory& of) {
  Contacts& c = *world.contacts;
  for (const std::uint32_t body : c.bodies) {
    std::uint8_t &steps = of.loaded_steps[body], &rest = of.cooldown_steps[body];
    if ((steps | rest) == 0 || is_looked_at(c, group_of(c, body))) continue;
    if (steps > 0) --steps;
    count_down(rest);
  }
}

void choose(const World& world, SolverMemory& memory, GroupViews& views, StepReport& report, Real h) {
  constexpr std::size_t kGroupsAPart = 4;
  Contacts& c = *world.contacts;
  const Real w2 = stiffness(world.scene.dials, h);
  c.load.resize(world.scene.bodies.slots(), Contacts::kUnseen);
  c.direct.resize(c.groups());
  views.resize(c.groups());
  in_parallel(world.jobs, c.groups(), kGroupsAPart, [&](std::uint32_t g) {
    GroupView& view = views[g];
    view = view_of(world, memory, g, w2, h);
    c.direct[g] = view.direct = is_solved_directly(view.reason);
  });
  count_down_elsewhere(world, memory);
  for (const GroupView& view : views) report.direct_groups += view.direct;
}

/// What lies still on a solution keeps to it, whatever it weighs: looking whether that still solves it costs next to nothing,
/// and soft contacts would let it sink.
void go_on_lying(const World& world, SolverMemory& memory) {
  const DirectGroups& d = *world.direct;
  for (std::size_t g = 0; g < d.groups(); ++g)
    for (std::uint32_t i = d.begin[g].body; d.rest[g].lies && i < d.begin[g + 1].body; ++i)
      if (std::uint8_t& steps = memory.loaded_steps[d.bodies[i].slot]; steps >= kBorneFor) steps = kBearsFor;
}

/// A group that came nowhere near its solution within its work is left to soft contacts for a while: it moves too much.
/// But not bodies of unlike masses, which soft contacts would throw about.
void start_cooldowns(const World& world, SolverMemory& memory) {
  const DirectGroups& d = *world.direct;
  for (std::size_t g = 0; g < d.groups(); ++g) {
    if (d.rest[g].in_lanes) continue;
    const bool joined = d.is_joined(g);
    const bool few = d.is_few(g), cheap = d.may_yield(g, world.plan->substeps);
    const bool keeps = joined ? few || cheap : few && cheap;
    const bool gives_up = !keeps && !d.rest[g].waits && !d.rest[g].lies && d.rest[g].is_far_off;
    if (!gives_up && !joined) continue;
    const int rest = gives_up ? kCooldown.value : 0;
    for (std::uint32_t i = d.begin[g].body; i < d.begin[g + 1].body; ++i)
      memory.cooldown_steps[d.bodies[i].slot] = static_cast<std::uint8_t>(kOfDirect | rest);
  }
}

/// Of what soft contacts solve now: whether the direct solver solved it in the last step.
bool is_taken_over(const World& world, bool moves, std::uint32_t body) {
  return moves && world.state.cooldown_steps[body] & kOfDirect;
}

/// Rows of what is taken over start from nothing: impulses that all but cancel each other, as where surfaces close on a body, or as
/// joints of a ring bear against each other, would throw it. Others of a group that they have come to be in keep theirs.
void drop_impulses_of_contacts(const World& world) {
  Contacts& c = *world.contacts;
  for (const ContactPair& m : c.contact_pairs) {
    if (!is_taken_over(world, m.moves_a, m.a) && !is_taken_over(world, m.moves_b, m.b)) continue;
    for (std::uint32_t i = m.row; i < m.row + m.count && c.solved_in_lanes(i); ++i) c.rows[i].p.set_zero();
  }
}

/// Likewise of their joints, once those are in lanes.
void drop_impulses_of_joints(const World& world) {
  const Contacts& c = *world.contacts;
  for (std::uint32_t i = 0; i < c.links.size(); ++i) {
    const Link& l = c.links[i];
    if (c.solved_directly(c.link_label[i])) continue;
    if (is_taken_over(world, l.moves_a, l.a) || is_taken_over(world, l.moves_b, l.b))
      drop_impulses(*world.wide_joints, i);
  }
}

/// Whether soft contacts or joints have anything to do: joints stand in lanes whoever solves them.
bool any_in_lanes(const World& world) { return world.wide->rows > 0 || world.wide_joints->any(); }

void auto_begin(const World& world, Solver::Begins to, const StepTime& time) {
  choose(world, to, to, to, time.h);
  drop_impulses_of_contacts(world);
  kSoftStep.begin(world, to, time);
  drop_impulses_of_joints(world);
  SolverMemory& memory = to;
  for (const std::uint32_t body : world.contacts->bodies)
    memory.cooldown_steps[body] &= static_cast<std::uint8_t>(~kOfDirect);
  gather_groups(world, to, time.h, kMostFactor);
}

void auto_velocities(const World& world, Solver::Solves to, const StepTime& time) {
  WideContacts& wide = *world.wide;
  const bool any = any_in_lanes(world);
  if (any) {
    heed_impacts(world, wide);
    begin_far_turns(world, to, wide, time.h);
    solve_softly(world, to, time);
    for (bool again = hold_joints(world, to, time.h, false); again; again = hold_joints(world, to, time.h, true)) {
      sweep_again(world, time.h);
      store_velocities(world, to, wide, time.h);
    }
  }
  const auto work = steps_worth(world) * static_cast<std::uint64_t>(world.scene.dials[Dial::direct_work]);
  solve_groups(world, to, to, time.h, 1 + work, world.plan->substeps);
  if (any) end_far_turns(world, to, wide, time.h);
  start_cooldowns(world, to);
  go_on_lying(world, to);
}

void auto_positions(const World& world, Solver::Relaxes to, const StepTime& time) {
  if (any_in_lanes(world)) kSoftStep.positions(world, to, time);
  if (world.direct->groups() == 0) return;
  part_groups(world, to, to, time.h);
  settle_joints(world, to, to, time.h);
}

void auto_end(const World& world, Poses& to, const StepTime& time) {
  kSoftStep.end(world, to, time);
  if (world.direct->groups() == 0) return;
  return_lanes_to_joints(world, to, time.dt);
  end_groups(world);
}

}  // namespace

extern constexpr Solver kAuto = {"auto", true, false, false, auto_begin, auto_velocities, auto_positions, auto_end};

}  // namespace carom::dynamics
