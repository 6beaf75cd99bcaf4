// Who flies: what the plan lists but for who is bound, found from runs of slots, not from each body.
#include "dynamics/integrate/free_flight.h"

#include <bit>
#include <utility>

#include "dynamics/ccd/continuous.h"
#include "dynamics/contact/contact.h"
#include "dynamics/integrate/integrator.h"
#include "dynamics/joint/rattle/rattle.h"
#include "dynamics/ledger/accounts.h"
#include "dynamics/ledger/ledger.h"

namespace carom::dynamics {
namespace {

bool is_constant(std::size_t row) { return row == +EffectId::gravity || row == +EffectId::user_force; }

/// Rows of the integrator that bodies of the scene call for.
RowBits movers_of_bodies(const Plan& plan) {
  RowBits movers = 0;
  for (std::size_t row = 0; row < kEffectCount; ++row) {
    if (plan.effects[row].candidates.count == 0) continue;  // all step long
    const Effect& effect = *plan.effects[row].effect;
    if (effect.stage == Stage::integrate && effect.participants == ParticipantKind::bodies) movers |= row_bit(row);
  }
  return movers;
}

/// Call f(row, effect) for each of them.
template <class F>
void each_mover_of_bodies(Plan& plan, RowBits movers, F&& f) {
  for (RowBits left = movers; left != 0; left &= left - 1) {
    const auto row = static_cast<std::size_t>(std::countr_zero(left));
    f(row, plan.effects[row]);
  }
}

/// Who is swept itself is so whoever else there is, and keeps its substeps.
void find_watched(const World& world, FreeFlight& f) {
  const Continuous& c = *world.continuous;
  take_out(world.plan->solid, f.tied, f.more);
  f.again.linear.clear();
  for (std::size_t k = 0; k < c.participants; ++k) f.again.linear.add(c.bodies[k].body);
  take_out(f.more, f.again.linear, f.watched);
}

/// Who is moved by what is not constant. On whom an effect is forced without a call for it, it changes nothing.
void find_bound(const World& world, FreeFlight& flight) {
  Plan& plan = *world.plan;
  flight.tied.clear();
  if (plan.runs[static_cast<std::size_t>(Stage::group)])
    for (const std::uint32_t i : world.contacts->bodies) flight.tied.add(i);
  const auto tie = [&](const Participants& list) {
    if (list.count == 0) return;
    unite(flight.tied, list, flight.more);
    std::swap(flight.tied, flight.more);
  };
  tie(plan.sprung);
  each_mover_of_bodies(plan, flight.movers, [&](std::size_t row, const PlannedEffect& effect) {
    if (!is_constant(row)) tie(effect.is_forced ? *effect.calling : effect.participants);
  });
  flight.watched.clear();
  if (world.continuous->bodies.empty()) return;
  if (world.rattle && world.rattle->is_hidden) tie(world.rattle->held);  // whom no list has, but `solid`
  find_watched(world, flight);
  tie(plan.solid);
}

/// Who would fly but for the sweeps of others, and how it begins the step. Allocates for fly_again(), too.
void save_watched(const World& world, FreeFlight& f) {
  const State& s = world.state;
  f.begun.clear();
  f.begun.reserve(f.watched.count);
  f.watched.each([&](std::uint32_t i) { f.begun.push_back({s.x[i], s.v[i], s.omega[i], s.q[i]}); });
  f.again.linear.runs.reserve(f.watched.count), f.again.rotating.runs.reserve(f.watched.count);
  each_mover_of_bodies(*world.plan, f.movers, [&](std::size_t row, const PlannedEffect&) {
    f.again.of_row[row].runs.reserve(f.watched.count);
  });
}

void split(const Participants& all, const Participants& tied, Participants& bound, Participants& flying) {
  if (all.count == 0) return bound.clear(), flying.clear();
  take_out(all, tied, flying);
  take_out(all, flying, bound);
}

void exchange(Plan& plan, RowBits movers, FreeFlight::Part& part) {
  std::swap(plan.linear, part.linear);
  std::swap(plan.rotating, part.rotating);
  each_mover_of_bodies(plan, movers, [&](std::size_t row, PlannedEffect& effect) {
    if (effect.participants.count + part.of_row[row].count > 0) std::swap(effect.participants, part.of_row[row]);
  });
}

/// Whether rows of the solver or sweeps ask for substeps.
bool is_solved(const World& world) {
  if (!world.continuous->bodies.empty()) return true;
  if (!world.plan->runs[static_cast<std::size_t>(Stage::group)]) return false;
  return !world.contacts->rows.empty() || !world.contacts->links.empty();
}

/// Who flies, where not everybody does.
void part(const World& world, FreeFlight& f) {
  Plan& plan = *world.plan;
  split(plan.linear, f.tied, f.bound.linear, f.flying.linear);
  split(plan.rotating, f.tied, f.bound.rotating, f.flying.rotating);
  if (f.flying.linear.count + f.flying.rotating.count == 0) return;
  each_mover_of_bodies(plan, f.movers, [&](std::size_t row, const PlannedEffect& effect) {
    split(effect.participants, f.tied, f.bound.of_row[row], f.flying.of_row[row]);
  });
  f.any = true;
  exchange(plan, f.movers, f.bound);
}

void exchange_the_rest(Plan& plan, FreeFlight& flight) {
  std::swap(plan.kinematic, flight.kinematic);
  std::swap(plan.effects[+EffectId::springs].participants, flight.springs);
}

/// Back to where the watched began, but for those that something hit; and lists of them.
void take_back(const World& world, Poses& poses, Velocities& motion, FreeFlight& f) {
  Plan& plan = *world.plan;
  f.again.linear.clear(), f.again.rotating.clear();
  each_mover_of_bodies(plan, f.movers, [&](std::size_t row, const PlannedEffect&) { f.again.of_row[row].clear(); });
  const FreeFlight::Begun* begun = f.begun.data();
  f.watched.each([&](std::uint32_t i) {
    const FreeFlight::Begun& b = *begun++;
    const SweptBody* const known = world.continuous->find(i);
    if ((known && known->is_hit) || world.state.held_out[i]) return;
    poses.x[i] = b.x, poses.q[i] = b.q;
    motion.v[i] = b.v, motion.omega[i] = b.omega;
    (rotates(world.scene, i) ? f.again.rotating : f.again.linear).add(i);
    each_mover_of_bodies(plan, f.movers, [&](std::size_t row, const PlannedEffect& effect) {
      if (effect.participants.has(i)) f.again.of_row[row].add(i);
    });
  });
}

/// The watched that met no body take the step in one go after all: substeps were for what might have met them. Records
/// have it already.
void fly_again(const World& world, Poses& poses, Quarantining to, FreeFlight& f, const StepTime& whole) {
  Plan& plan = *world.plan;
  const Continuous& c = *world.continuous;
  if (f.watched.count == 0 || c.bodies.size() >= c.most_bodies) return;  // which were hit then is not known
  take_back(world, poses, to, f);
  exchange(plan, f.movers, f.again), exchange_the_rest(plan, f);
  integrate_velocity(world, to, whole);
  integrate_position(world, poses, to, whole);
  if (keeps_ledger(world))
    each_of_both(plan.linear, plan.rotating,
                 [&](std::uint32_t i) { clear_kicks(ledger_of(world), i), open_phase(world, i); });
  exchange(plan, f.movers, f.again), exchange_the_rest(plan, f);
}

}  // namespace

FreeFlight::Part::Part(Memory* m) : linear(m), rotating(m), of_row(m) {
  of_row.reserve(kEffectCount);
  for (std::size_t row = 0; row < kEffectCount; ++row) of_row.emplace_back(m);
}

FreeFlight::FreeFlight(Memory* m)
    : bound(m), flying(m), again(m), kinematic(m), springs(m), tied(m), more(m), watched(m), begun(m) {}

void defer_free_bodies(const World& world, const StepTime&) {
  Plan& plan = *world.plan;
  if (plan.flight) plan.flight->watched.clear();
  if (plan.substeps == 1 && !world.accuracy) return;
  const bool anybody = plan.linear.count + plan.rotating.count > 0;
  if (!anybody || !plan.integrator->exact_in_flight) {
    plan.idle = !anybody && !is_solved(world);
    return;
  }
  if (!plan.flight) plan.flight = make_owned<FreeFlight>(world.memory, world.memory);
  FreeFlight& f = *plan.flight;
  f.movers = movers_of_bodies(plan);
  find_bound(world, f);
  plan.idle = f.tied.count == 0 && !is_solved(world);
  if (f.watched.count > 0) save_watched(world, f);
  if (!plan.idle) part(world, f);
}

void integrate_free_bodies(const World& world, Poses& poses, Quarantining to, const StepTime& time) {
  Plan& plan = *world.plan;
  if (plan.idle) drive_kinematics(world, poses, to, time);
  if (!plan.flight || plan.linear.count + plan.rotating.count + plan.flight->any == 0) return;
  FreeFlight& f = *plan.flight;
  const StepTime whole{time.dt, time.dt};
  if (f.any) exchange(plan, f.movers, f.bound);
  if (!plan.idle) fly_again(world, poses, to, f, whole);
  if (!plan.idle && !f.any) return;
  if (f.any) exchange(plan, f.movers, f.flying);
  exchange_the_rest(plan, f);
  const bool is_accounted = keeps_ledger(world);
  integrate_velocity(world, to, whole);
  if (is_accounted) account_stage(world, LedgerAccount::forces, whole);
  integrate_position(world, poses, to, whole);
  if (is_accounted) account_stage(world, LedgerAccount::moves, whole);
  exchange_the_rest(plan, f);
  if (std::exchange(f.any, false)) exchange(plan, f.movers, f.flying);
}

}  // namespace carom::dynamics
