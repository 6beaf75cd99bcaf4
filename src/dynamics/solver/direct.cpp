// Stage functions of the direct solver.
#include "dynamics/solver/direct.h"

#include <algorithm>

#include "dynamics/ccd/continuous.h"
#include "dynamics/joint/wide_joints.h"
#include "dynamics/solver/direct/cone_group.h"
#include "dynamics/solver/direct/cone_group_constants.h"
#include "dynamics/solver/far_turns.h"
#include "dynamics/solver/solver.h"

namespace carom::dynamics {
namespace {

constexpr std::size_t kDirectGroupsAPart = 1;  // a group takes as long as many bodies of other loops

void direct_begin(const World& world, Solver::Begins to, const StepTime& time) {
  if (world.wide_joints->any()) {  // their rows are made in lanes, as are numbers of bodies
    world.contacts->direct.assign(world.contacts->groups(), true);
    pack(world, to, *world.wide, time.h);
    begin_joints(world, time.h);
  }
  gather_groups(world, to, time.h);
}

void direct_velocities(const World& world, Solver::Solves to, const StepTime& time) {
  WideContacts& wide = *world.wide;
  const bool joined = world.wide_joints->any();
  if (joined) begin_far_turns(world, to, wide, time.h), load_velocities(world, wide);
  bend_joints(world, time.h);
  solve_groups(world, to, to, time.h, 0, world.plan->substeps);
  if (joined) end_far_turns(world, to, wide, time.h);
}

void direct_positions(const World& world, Solver::Relaxes to, const StepTime& time) {
  part_groups(world, to, to, time.h);
  settle_joints(world, to, to, time.h);
}

void direct_end(const World& world, Poses&, const StepTime&) {
  refresh_rotations(world);
  end_groups(world);
}

}  // namespace

/// What those groups may take that ask for a solve in the first substep: each its own, unless all that move would take
/// more than there is, then all as much less; those at rest one after the other, the worst first, until there is none
/// left. What is left out goes on as it is: it takes a while until anybody sees that.
static void share_out(DirectGroups& d, std::uint64_t work) {
  const auto shares = [&](std::uint32_t g) { return d.rest[g].asks && d.rest[g].is_bounded && !d.is_joined(g); };
  Array<std::uint32_t>& urgent = d.elimination.scratch().member;
  urgent.clear();
  std::uint64_t expected = 0;
  for (std::uint32_t g = 0; g < d.groups(); ++g) {
    if (!shares(g)) continue;
    GroupRest& rest = d.rest[g];
    if (rest.lies) urgent.push_back(g);
    if (rest.at_once)
      rest.work = rest.share = std::max(rest.share, kExpectedAtRest * d.newton_work(g));
    else
      expected += std::min(rest.share, kExpectedOfMoving * d.newton_work(g));
  }
  for (std::uint32_t g = 0; g < d.groups() && expected > work; ++g) {
    GroupRest& rest = d.rest[g];
    if (shares(g) && !rest.at_once) rest.work = rest.share = rest.share * work / expected;
  }
  std::ranges::sort(urgent, [&](std::uint32_t a, std::uint32_t b) {
    const Real of_a = d.rest[a].solution.residual, of_b = d.rest[b].solution.residual;
    return of_a != of_b ? of_a > of_b : a < b;
  });
  std::uint64_t taken = 0;
  for (const std::uint32_t g : urgent) {
    d.rest[g].waits = taken > work;
    taken += kExpectedAtRest * d.newton_work(g);
  }
}

void solve_groups(const World& world, Velocities& to, StepReport& report, Real h, std::uint64_t work, int substeps) {
  DirectGroups& d = *world.direct;
  for (const Impact& at : world.contacts->impacts)
    if (GroupRest* const rest = at.concerns_solver() ? d.rest_of(world.contacts->rows[at.row]) : nullptr)
      rest->lasts = false;
  in_parallel(world.jobs, d.groups(), kDirectGroupsAPart, [&](std::uint32_t g) {
    if (!d.rest[g].in_lanes) ConeGroup(world, g).begin(to, h, work);
  });
  if (work > 0 && std::ranges::any_of(d.rest, [](const GroupRest& rest) { return rest.is_first && rest.asks; }))
    share_out(d, work);
  in_parallel(world.jobs, d.groups(), kDirectGroupsAPart, [&](std::uint32_t g) {
    if (d.rest[g].asks) ConeGroup(world, g).solve(to, h, substeps);
  });
  if (world.plan->rotation_method) {
    Participants& one = world.wide->one_turner;
    for (std::size_t g = 0; g < d.groups(); ++g) ConeGroup(world, g).lead_on(to, h, one);
  }
  for (std::size_t g = 0; g < d.groups(); ++g) {
    if (d.rest[g].repeats > 0 || d.rest[g].in_lanes) continue;
    const ConeSolution& solution = d.rest[g].solution;
    report.velocity_impulses += solution.factorisations;
    report.wedged_groups += solution.is_wedged, report.rejected_solutions += solution.is_rejected;
    report.excess_energy += solution.excess_energy;
    report.solver_residual = std::max<double>(report.solver_residual, solution.residual);
  }
}

bool hold_joints(const World& world, Velocities& to, Real h, bool again) {
  DirectGroups& d = *world.direct;
  in_parallel(world.jobs, d.groups(), kDirectGroupsAPart, [&](std::uint32_t g) {
    GroupRest& rest = d.rest[g];
    if (!rest.in_lanes || rest.is_too_large || (again && !rest.is_swept_again)) return;
    const bool has_loops = d.begin[g].link < d.begin[g].lock;
    if (!again) rest.waits = has_loops && static_cast<int>(++rest.substeps) < world.plan->substeps;
    if (!rest.is_dear || !rest.waits) ConeGroup(world, g).follow_lanes(to, h, again);
  });
  return std::ranges::any_of(d.rest, &GroupRest::is_swept_again);
}

void part_groups(const World& world, Poses& to, StepReport& report, Real h) {
  DirectGroups& d = *world.direct;
  if (std::ranges::none_of(d.rest, &GroupRest::parts_now)) return;
  if (!d.links.empty()) place_joints(world);
  for (GroupRest& rest : d.rest) rest.has_parted = false;
  if (std::ranges::all_of(d.rest, &GroupRest::lasts)) return;
  world.plan->kinematic.each([&](std::uint32_t i) { world.plan->rotation[i] = world.state.q[i].matrix(); });
  in_parallel(world.jobs, d.groups(), kDirectGroupsAPart, [&](std::uint32_t g) {
    if (d.rest[g].parts_now()) ConeGroup(world, g).part(to, h);
  });
  for (const GroupRest& rest : d.rest) report.position_moves += rest.solution.factorisations;
}

/// Joints where they are by now, if any group has parted since they were placed.
static void place_parted(const World& world) {
  Array<GroupRest>& rest = world.direct->rest;
  if (std::ranges::none_of(rest, &GroupRest::has_parted)) return;
  place_joints(world);
  for (GroupRest& of : rest) of.has_parted = false;
}

constexpr int kPasses = 8, kPassesAfterSweep = 16;

/// Groups that part, pass by pass: parting follows tangents, so that a second pass begins where the first has led.
/// @param group  (index) -> ConeGroup   @param part  (group): a pass
template <class Group, class Part>
static void part_again(const World& world, const Group& group, const Part& part, int passes = kPasses) {
  DirectGroups& d = *world.direct;
  for (int k = 0; k < passes; ++k) {
    place_parted(world);
    bool any = false;
    for (std::size_t g = 0; g < d.groups(); ++g) any |= d.rest[g].parts = d.rest[g].parts && group(g).is_nearer();
    if (!any) return;
    in_parallel(world.jobs, d.groups(), kDirectGroupsAPart, [&](std::uint32_t g) {
      if (d.rest[g].parts) part(group(g));
    });
  }
  place_parted(world);
}

/// Joints of some groups closed, heeding contacts; then what these hinder by joints alone, whatever that does to contacts.
/// @param which  (group): whether it is to be
template <class Which, class Part>
static void close(const World& world, const Which& which, const Part& part, int passes = kPasses) {
  DirectGroups& d = *world.direct;
  const auto whole = [&](std::size_t g) { return ConeGroup(world, g); };
  const auto alone = [&](std::size_t g) { return ConeGroup::joints_of(world, g); };
  for (std::size_t g = 0; g < d.groups(); ++g) d.rest[g].parts = d.is_joined(g) && which(whole(g));
  part_again(world, whole, part, passes);
  for (std::size_t g = 0; g < d.groups(); ++g) {
    GroupRest& rest = d.rest[g];
    rest.parts = d.is_joined(g) && which(whole(g)) && whole(g).gapes();
    if (rest.parts) rest.gap = kInfinity, rest.has_moved = true;
  }
  if (std::ranges::any_of(d.rest, &GroupRest::parts)) part_again(world, alone, part, passes);
}

void settle_joints(const World& world, Poses& poses, Velocities& motion, Real h) {
  DirectGroups& d = *world.direct;
  if (d.links.empty()) return;
  close(
      world, [](const ConeGroup& group) { return group.parts_now(); },
      [&](ConeGroup group) { group.part_again(poses, h); });
  in_parallel(world.jobs, d.groups(), kDirectGroupsAPart,
              [&](std::uint32_t g) { ConeGroup(world, g).settle(motion, h); });
}

void return_lanes_to_joints(const World& world, Poses& poses, Real h) {
  for (GroupRest& rest : world.direct->rest)
    rest.gap = kInfinity, rest.parts = rest.has_parted = rest.in_lanes && !rest.is_too_large;
  part_again(
      world, [&](std::size_t g) { return ConeGroup(world, g); }, [&](ConeGroup group) { group.part_again(poses, h); });
}

void close_joints(const World& world, Poses& poses, const StepTime& time) {
  DirectGroups& d = *world.direct;
  if (d.links.empty() || !any_led_by_sweep(world)) return;
  for (GroupRest& rest : d.rest) rest.gap = kInfinity, rest.has_parted = true;
  close(
      world, [](const ConeGroup& group) { return group.is_swept(); },
      [&](ConeGroup group) { group.follow_swept(poses, time.h); }, kPassesAfterSweep);
}

void end_groups(const World& world) {
  DirectGroups& d = *world.direct;
  in_parallel(world.jobs, d.groups(), kDirectGroupsAPart, [&](std::uint32_t g) { ConeGroup(world, g).end(); });
}

extern constexpr Solver kDirect = {"direct",         false,     false, true, direct_begin, direct_velocities,
                                   direct_positions, direct_end};

}  // namespace carom::dynamics
