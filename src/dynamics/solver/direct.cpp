// Stage functions of the direct solver.
#include "dynamics/solver/direct.h"

#include <algorithm>

#include "dynamics/joint/wide_joints.h"
#include "dynamics/solver/direct/cone_group.h"
#include "dynamics/solver/solver.h"

namespace carom::dynamics {
namespace {

constexpr std::size_t kDirectGroupsAPart = 1;  // a group takes as long as many bodies of other loops

void direct_begin(World& world, const StepTime& time) {
  if (world.wide_joints->any()) {  // their rows are made in lanes, as are numbers of bodies
    world.contacts->direct.assign(world.contacts->groups(), Contacts::kDirectly);
    pack(world, *world.wide, time.h);
    begin_joints(world, time.h);
  }
  gather_groups(world);
}

void direct_velocities(World& world, const StepTime& time) {
  if (world.wide_joints->any()) load_velocities(world, *world.wide);
  bend_joints(world, time.h);
  solve_groups(world, time.h, 0, world.plan->substeps);
}

void direct_positions(World& world, const StepTime& time) {
  part_groups(world, time.h);
  settle_joints(world, time.h);
}

void direct_end(World& world, const StepTime&) {
  refresh_rotations(world);
  end_groups(world);
}

}  // namespace

void solve_groups(World& world, Real h, std::uint64_t work, int substeps) {
  DirectGroups& d = *world.direct;
  for (const Impact& at : world.contacts->impacts)
    if (GroupRest* const rest = at.concerns_solver() ? d.rest_of(world.contacts->rows[at.row]) : nullptr)
      rest->lasts = false;
  in_parallel(world.jobs, d.groups(), kDirectGroupsAPart,
              [&](std::uint32_t g) { ConeGroup(world, g).solve(h, work, substeps); });
  for (std::size_t g = 0; g < d.groups(); ++g) {
    if (d.rest[g].repeats > 0) continue;
    world.report.velocity_impulses += d.answer[g].factorisations;
    world.report.solver_residual = std::max<double>(world.report.solver_residual, d.answer[g].residual);
  }
}

void part_groups(World& world, Real h) {
  DirectGroups& d = *world.direct;
  if (!d.links.empty()) place_joints(world);
  if (std::ranges::all_of(d.rest, [](const GroupRest& rest) { return rest.lasts; })) return;
  refresh_rotations(world);
  in_parallel(world.jobs, d.groups(), kDirectGroupsAPart, [&](std::uint32_t g) { ConeGroup(world, g).part(h); });
  for (const ConeAnswer& answer : d.answer) world.report.position_moves += answer.factorisations;
}

void settle_joints(World& world, Real h) {
  DirectGroups& d = *world.direct;
  if (d.links.empty()) return;
  // Parting follows tangents: a second time, from where the first has led, where that is not close enough.
  constexpr int kTimes = 8;
  for (int k = 0; k < kTimes; ++k) {
    place_joints(world);
    bool any = false;
    for (std::size_t g = 0; g < d.groups() && !any; ++g) any = ConeGroup(world, g).is_apart();
    if (!any) break;
    in_parallel(world.jobs, d.groups(), kDirectGroupsAPart, [&](std::uint32_t g) {
      if (ConeGroup group(world, g); group.is_apart()) group.part(h);
    });
    if (k + 1 == kTimes) place_joints(world);
  }
  in_parallel(world.jobs, d.groups(), kDirectGroupsAPart, [&](std::uint32_t g) { ConeGroup(world, g).settle(h); });
}

void end_groups(World& world) {
  DirectGroups& d = *world.direct;
  in_parallel(world.jobs, d.groups(), kDirectGroupsAPart, [&](std::uint32_t g) { ConeGroup(world, g).end(); });
}

extern constexpr Solver kDirect = {"direct", false, false, true, true, direct_begin, direct_velocities, direct_positions, direct_end};

}  // namespace carom::dynamics
