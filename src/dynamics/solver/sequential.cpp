// Stage functions of the sequential solver.
#include "dynamics/solver/sequential.h"

#include "dynamics/joint/coupled_rows.h"
#include "dynamics/joint/wide_joints.h"
#include "dynamics/solver/far_turns.h"
#include "dynamics/solver/soft_step.h"
#include "dynamics/solver/wide_contacts.h"

namespace carom::dynamics {
namespace {

/// Of the penetration, per substep: all at once would overshoot where contacts depend on each other.
constexpr Real kSequentialShare = 0.2;

void sequential_begin(const World& world, Solver::Begins to, const StepTime& time) {
  begin_lanes(world, to, time.h);
  begin_joints(world, time.h);
}

void sequential_velocities(const World& world, Solver::Solves to, const StepTime& time) {
  StepReport& report = to;
  WideContacts& wide = *world.wide;
  const Real inv_h = 1 / time.h;
  heed_impacts(world, wide);
  begin_far_turns(world, to, wide, time.h);
  start_sweeps(world, time.h);
  const JointKernels* const joints = world.wide_joints->kernels;
  const int sweeps = world.scene.dials.whole(Dial::velocity_iterations);
  for (int k = 0; k < sweeps; ++k) {
    sweep_rows(
        world, [&](const JointRun& run) { joints->solve(run, inv_h); },
        [&](const auto& s, const auto& run) { s.sweep(run, inv_h); });
    solve_couplings(world);
  }
  over_contacts(world, [](const auto& s, const auto& run) { s.accumulate(run); });
  store_velocities(world, to, wide, time.h);
  end_far_turns(world, to, wide, time.h);
  report.velocity_impulses += static_cast<std::uint64_t>(sweeps) * world.wide->rows;
}

void sequential_positions(const World& world, Solver::Relaxes to, const StepTime& time) {
  StepReport& report = to;
  const int sweeps = world.scene.dials.whole(Dial::position_iterations);
  const Real slop = world.scene.dials[Dial::position_tolerance] / 2;  // so that a body at rest keeps in touch
  measure_lanes(world);
  part_lanes(world, to, sweeps, kSequentialShare, slop);
  if (world.wide_joints->any()) {
    load_shifts(world, *world.wide);
    return_to_joints(world);
    sweep_joints(
        world, [&, inv_h = 1 / time.h](const JointRun& run) { world.wide_joints->kernels->relax(run, inv_h); },
        [](std::uint32_t) {});
    relax_couplings(world);
    store_velocities(world, to, *world.wide, time.h);
  }
  report.position_moves += static_cast<std::uint64_t>(sweeps) * world.contacts->rows.size();
}

void sequential_end(const World& world, Poses&, const StepTime&) { end_lanes(world); }

}  // namespace

extern constexpr Solver kSequential = {
    "sequential",         true,          false, false, true, sequential_begin, sequential_velocities,
    sequential_positions, sequential_end};

}  // namespace carom::dynamics
