// How solvers in lanes begin and end a step, and part what overlaps.
#include <algorithm>

#include "dynamics/contact/depth.h"
#include "dynamics/solver/wide_contacts.h"

namespace carom::dynamics {

void begin_lanes(const World& world, SolverMemory& memory, Real h) {
  pack(world, memory, *world.wide, h);
  world.wide->displacement.resize(world.wide->velocity.size());
}

void measure_lanes(const World& world) {
  load_shifts(world, *world.wide);
  over_contacts(world, [](const auto& sweeps, const auto& run) { sweeps.measure(run); });
}

void part_lanes(const World& world, Poses& to, int sweeps, Real share, Real slop) {
  WideContacts& wide = *world.wide;
  std::fill(wide.displacement.begin(), wide.displacement.end(), BodyVelocity{});
  for (int k = 0; k < sweeps; ++k)
    sweep_bodies(world, wide.displacement.data(),
                 [&](const auto& s, const auto& run) { s.part(run, share, slop, kTolerableDepth / 2); });
  displace(world, to, wide);
}

void end_lanes(const World& world) { unpack(world, *world.wide); }

}  // namespace carom::dynamics
