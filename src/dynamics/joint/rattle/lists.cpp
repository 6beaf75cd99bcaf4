// Whom a plan's loops go through: those that are held, and the others.
#include "dynamics/joint/rattle/rattle.h"

namespace carom::dynamics {

Rattle::Rattle(Memory* m)
    : all_active(m),
      island_of(m),
      parent(m),
      body_of(m),
      islands(m),
      bodies(m),
      joints(m),
      rows(m),
      couplings(m),
      drives(m),
      pairs(m),
      by_slot(m),
      elimination(m),
      edges(m),
      seats(m),
      diagonal(m),
      below(m),
      above(m),
      left(m),
      right(m),
      trial(m),
      middle_v(m),
      middle_l(m),
      kicks(m),
      part_bodies(m),
      part_joints(m),
      part_kicks(m),
      trials(m),
      coarse(m),
      held(m),
      others(m),
      scratch(m),
      of_held(m),
      of_all(m),
      active(m),
      left_active(m) {}

/// Of the plan's lists, `of_held` become those of `held` bodies and `of_all` those of the others.
void rattle::list_held(const World& world, Rattle& r) {
  list_others(world, r.held, r.of_all);
  list_part(world, r.held, r.scratch, r.of_held);
  part_springs(world, r.held, r.of_held, &r.of_all);
  // No torque, but how omega turns with its body: it turns as a free top here (step.cpp).
  r.of_held.of_row[+EffectId::gyroscopic].clear();
}

}  // namespace carom::dynamics
