// How solvers in lanes begin and end a step, and part what overlaps.
#include <algorithm>

#include "dynamics/solver/wide_contacts.h"

namespace carom::dynamics {

void begin_lanes(World& world, Real h) {
  pack(world, *world.wide, h);
  world.wide->displacement.resize(world.wide->velocity.size());
}

void measure_lanes(World& world) {
  load_shifts(world, *world.wide);
  over_contacts(world, [](const auto& sweeps, const auto& run) { sweeps.measure(run); });
}

void part_lanes(World& world, int sweeps, Real share, Real slop) {
  WideContacts& wide = *world.wide;
  std::fill(wide.displacement.begin(), wide.displacement.end(), BodyVelocity{});
  for (int k = 0; k < sweeps; ++k)
    sweep_bodies(world, wide.displacement.data(),
                 [&](const auto& s, const auto& run) { s.part(run, share, slop); });
  displace(world, wide);
}

void end_lanes(World& world) { unpack(world, *world.wide); }

}  // namespace carom::dynamics
