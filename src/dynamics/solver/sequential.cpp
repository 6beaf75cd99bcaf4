// Stage functions of the sequential solver.
#include "dynamics/solver/sequential.h"

#include <algorithm>

#include "dynamics/solver/wide_contacts.h"

namespace carom {
namespace {

/// Of the penetration, per substep: all at once would overshoot where contacts depend on each other.
constexpr Real kShare = 0.2;

void begin(World& world, const StepTime&) {
  begin_lanes(world);
  world.wide->displacement.resize(world.wide->velocity.size());
}

void velocities(World& world, const StepTime& time) {
  WideContacts& wide = *world.wide;
  const ContactKernels& kernels = *wide.kernels;
  const LaneRun run = everything(wide);
  load_velocities(world, wide);
  kernels.warm_start(run);
  const int sweeps = world.scene.dials.whole(Dial::velocity_iterations);
  for (int k = 0; k < sweeps; ++k) kernels.sweep(run, 1 / time.h);
  kernels.book(run);
  store_velocities(world, wide);
  world.report.velocity_impulses += static_cast<std::uint64_t>(sweeps) * world.contacts->rows.size();
}

void positions(World& world, const StepTime&) {
  WideContacts& wide = *world.wide;
  const ContactKernels& kernels = *wide.kernels;
  load_shifts(world, wide);
  LaneRun run = everything(wide);
  kernels.measure(run);
  std::fill(wide.displacement.begin(), wide.displacement.end(), BodyVelocity{});
  run.velocity = wide.displacement.data();
  const int sweeps = world.scene.dials.whole(Dial::position_iterations);
  const Real slop = world.scene.dials[Dial::position_tolerance] / 2;  // so that a body at rest keeps in touch
  for (int k = 0; k < sweeps; ++k) kernels.part(run, kShare, slop);
  displace(world, wide);
  world.report.position_moves += static_cast<std::uint64_t>(sweeps) * world.contacts->rows.size();
}

void end(World& world, const StepTime&) { end_lanes(world); }

}  // namespace

extern constexpr Solver kSequential = {"sequential", true, begin, nullptr, velocities, positions, end};

}  // namespace carom
