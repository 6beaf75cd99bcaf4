// How solvers in lanes begin and end a step.
#include "dynamics/solver/wide_contacts.h"

namespace carom {

void begin_lanes(World& world) {
  pack(world, *world.wide);
  world.wide->kernels->prepare(everything(*world.wide));
}

void end_lanes(World& world) {
  WideContacts& wide = *world.wide;
  if (!world.contacts->bouncing.empty()) {
    wide.kernels->bounce(everything(wide), world.scene.dials[Dial::restitution_speed]);
    store_velocities(world, wide);
  }
  unpack(world, wide);
}

}  // namespace carom
