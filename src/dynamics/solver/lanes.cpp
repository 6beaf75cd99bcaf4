// How solvers in lanes begin and end a step, and part what overlaps.
#include <algorithm>

#include "dynamics/solver/wide_contacts.h"

namespace carom {

void begin_lanes(World& world) {
  pack(world, *world.wide);
  const ContactKernels& kernels = *world.wide->kernels;
  in_any_order(world.jobs, everything(*world.wide), kernels.prepare);
  world.wide->displacement.resize(world.wide->velocity.size());
}

void measure_lanes(World& world) {
  WideContacts& wide = *world.wide;
  load_shifts(world, wide);
  in_any_order(world.jobs, everything(wide), wide.kernels->measure);
}

void part_lanes(World& world, int sweeps, Real share, Real slop) {
  WideContacts& wide = *world.wide;
  std::fill(wide.displacement.begin(), wide.displacement.end(), BodyVelocity{});
  LaneRun all = everything(wide);
  all.velocity = wide.displacement.data();
  for (int k = 0; k < sweeps; ++k)
    by_colour(world.jobs, wide, all, [&](const LaneRun& run) { wide.kernels->part(run, share, slop); });
  displace(world, wide);
}

void end_lanes(World& world) { unpack(world, *world.wide); }

}  // namespace carom
