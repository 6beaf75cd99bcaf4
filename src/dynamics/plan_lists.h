// Lists of a plan that a step's forces go through, of some of its bodies: to let a part of the step go through these
// alone.
#pragma once

#include "dynamics/effects.h"

namespace carom::dynamics {

struct PlanLists {
  explicit PlanLists(Memory* m);
  Participants linear, rotating, sprung, readers;
  Array<Participants> of_row;  // by row of the table, of those that the integrator serves
};

/// The plan's lists without some bodies; those of some bodies alone. Without springs.
void list_others(const World& world, const Participants& those, PlanLists& others);
/// @param scratch  any
void list_part(const World& world, const Participants& those, Participants& scratch, PlanLists& part);
/// Springs that hang on those bodies, and the others. Both ends of a spring are among the bodies, or none of them.
/// @param others  null: not asked for
void part_springs(const World& world, const Participants& those, PlanLists& part, PlanLists* others);
/// The plan's are these, and these the plan's.
void exchange_lists(Plan& plan, PlanLists& lists);

}  // namespace carom::dynamics
