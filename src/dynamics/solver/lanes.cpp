// How solvers in lanes begin and end a step.
#include "dynamics/solver/wide_contacts.h"

namespace carom {

void begin_lanes(World& world) {
  pack(world, *world.wide);
  const ContactKernels& kernels = *world.wide->kernels;
  in_any_order(world.jobs, everything(*world.wide), kernels.prepare);
}

void end_lanes(World& world) {
  WideContacts& wide = *world.wide;
  if (!world.contacts->bouncing.empty()) {
    const Real speed = world.scene.dials[Dial::restitution_speed];
    by_colour(world.jobs, wide, everything(wide), [&](const LaneRun& run) { wide.kernels->bounce(run, speed); });
    store_velocities(world, wide);
  }
  unpack(world, wide);
}

}  // namespace carom
