// The stages of the page that a solver serves.
#include "dynamics/solver/solver.h"

#include <type_traits>

#include "dynamics/contact/contact.h"
#include "dynamics/contact/mean_motion.h"
#include "dynamics/joint/turns.h"
#include "dynamics/joint/wide_joints.h"

namespace carom::dynamics {
namespace {

/// Rows that are gone through one by one are of one island: of a pass without it there is none to solve.
bool leaves_rows_alone(const World& world) {
  const Contacts& c = *world.contacts;
  return world.plan->in_pass && world.plan->solver->row_by_row && c.contact_pairs.empty() && c.links.empty();
}

template <class To>
void serve(void (*stage)(const World&, To, const StepTime&), const World& world, std::type_identity_t<To> to,
           const StepTime& time) {
  if (stage && !leaves_rows_alone(world)) stage(world, to, time);
}

}  // namespace

void begin_contacts(const World& world, Solver::Begins to, Owned<MeanMotion>& means, const StepTime& time) {
  if (!world.plan->solver->row_by_row || world.wide_joints->any())
    refresh_inertias(world);  // lanes keep those of the step's begin
  serve(world.plan->solver->begin, world, to, time);
  find_bounded(world, time.h);
  find_small_groups(world, means);
}
void solve_velocities(const World& world, Solver::Solves to, const StepTime& time) {
  save_energies(world);
  take_half_kicks(world, to);
  serve(world.plan->solver->velocities, world, to, time);
  bound_moves(world, to);
  aim_joints(world, time.h);
  find_mean_motion(world, time);
}
void solve_positions(const World& world, Solver::Relaxes to, const StepTime& time) {
  give_half_kicks(world, to);
  serve(world.plan->solver->positions, world, to, time);
  bound_energies(world, to, time.h);
}
void end_contacts(const World& world, Poses& poses, Breaking joints, Events& events, const StepTime& time) {
  serve(world.plan->solver->end, world, poses, time);
  end_joints(world, joints, events, time);
}

}  // namespace carom::dynamics
