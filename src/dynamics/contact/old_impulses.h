// Impulses of contacts that the next step starts from.
#pragma once

#include "collision/narrow/narrow_phase.h"
#include "core/memory.h"

namespace carom::dynamics {

/// What the next step knows of an impulse of this one.
struct OldImpulse {
  Pair pair;
  Vec3 place;   // m, where it acted: on A, in the frame of its shape, or on B, @see placed_on_b()
  Vec3 p;       // N s per substep, world
  Vec3 moment;  // N m s per substep, world, on B: of the pair's first point that is remembered; else zero

  /// As if a substep that much longer had made it; of what would overflow nothing is left.
  void stretch(Real by) {
    p *= by, moment *= by;
    if (!finite(p)) p.set_zero();
    if (!finite(moment)) moment.set_zero();
  }
};

struct Impulses {
  explicit Impulses(Memory* m) : old(m) {}
  Array<OldImpulse> old;  // of the last step, ascending by pair
  Real old_h = 0;         // s, the substep that made them
};

}  // namespace carom::dynamics
