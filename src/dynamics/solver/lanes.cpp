// How solvers in lanes begin and end a step.
#include "dynamics/solver/wide_contacts.h"

namespace carom {

void begin_lanes(World& world) {
  pack(world, *world.wide);
  const ContactKernels& kernels = *world.wide->kernels;
  in_any_order(world.jobs, everything(*world.wide), kernels.prepare);
}

void end_lanes(World& world) { unpack(world, *world.wide); }

}  // namespace carom
