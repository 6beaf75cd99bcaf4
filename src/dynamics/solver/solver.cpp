// The stages of the page that a solver serves.
#include "dynamics/solver/solver.h"

#include "dynamics/contact/contact.h"
#include "dynamics/contact/mean_motion.h"
#include "dynamics/joint/wide_joints.h"

namespace carom::dynamics {
namespace {

void serve(void (*room)(World&, const StepTime&), World& world, const StepTime& time) {
  if (room) room(world, time);
}

}  // namespace

void begin_contacts(World& world, const StepTime& time) {
  if (!world.plan->solver->row_by_row || world.wide_joints->any())
    refresh_inertias(world);  // lanes keep those of the step's begin
  serve(world.plan->solver->begin, world, time);
  find_small_groups(world);
}
void solve_velocities(World& world, const StepTime& time) {
  take_half_kicks(world);
  serve(world.plan->solver->velocities, world, time);
  find_mean_motion(world, time);
}
void solve_positions(World& world, const StepTime& time) {
  give_half_kicks(world);
  serve(world.plan->solver->positions, world, time);
}
void end_contacts(World& world, const StepTime& time) {
  serve(world.plan->solver->end, world, time);
  end_joints(world, time);
}

}  // namespace carom::dynamics
