// Who flies: what the plan lists but for who is bound, found from runs of slots, not from each body.
#include "dynamics/integrate/free_flight.h"

#include <bit>
#include <utility>

#include "dynamics/ccd/continuous.h"
#include "dynamics/contact/contact.h"
#include "dynamics/integrate/integrator.h"
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
    if (effect.stage == Stage::integrate && effect.customers == CustomerKind::bodies) movers |= row_bit(row);
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

/// Who is moved by what is not constant. On whom an effect is forced without a call for it, it changes nothing.
void find_bound(const World& world, FreeFlight& flight) {
  Plan& plan = *world.plan;
  flight.tied.clear();
  for (const std::uint32_t i : world.contacts->bodies) flight.tied.add(i);
  const auto tie = [&](const Customers& list) {
    if (list.count == 0) return;
    unite(flight.tied, list, flight.more);
    std::swap(flight.tied, flight.more);
  };
  tie(plan.sprung);
  if (!world.continuous->bodies.empty()) tie(plan.solid);
  each_mover_of_bodies(plan, flight.movers, [&](std::size_t row, const PlannedEffect& effect) {
    if (!is_constant(row)) tie(effect.is_forced ? *effect.calling : effect.customers);
  });
}

void split(const Customers& all, const Customers& tied, Customers& bound, Customers& flying) {
  if (all.count == 0) return bound.clear(), flying.clear();
  take_out(all, tied, flying);
  take_out(all, flying, bound);
}

void exchange(Plan& plan, RowBits movers, FreeFlight::Part& part) {
  std::swap(plan.linear, part.linear);
  std::swap(plan.rotating, part.rotating);
  each_mover_of_bodies(plan, movers, [&](std::size_t row, PlannedEffect& effect) {
    if (effect.customers.count + part.of_row[row].count > 0) std::swap(effect.customers, part.of_row[row]);
  });
}

void exchange_the_rest(Plan& plan, FreeFlight& flight) {
  std::swap(plan.kinematic, flight.kinematic);
  std::swap(plan.effects[+EffectId::springs].customers, flight.springs);
}

}  // namespace

FreeFlight::Part::Part(Memory* m) : linear(m), rotating(m), of_row(m) {
  of_row.reserve(kEffectCount);
  for (std::size_t row = 0; row < kEffectCount; ++row) of_row.emplace_back(m);
}

FreeFlight::FreeFlight(Memory* m) : bound(m), flying(m), kinematic(m), springs(m), tied(m), more(m) {}

void part_with_flyers(const World& world, const StepTime&) {
  Plan& plan = *world.plan;
  if (plan.substeps == 1 || !plan.integrator->exact_in_flight) return;
  if (!plan.flight) plan.flight = make_owned<FreeFlight>(world.memory, world.memory);
  FreeFlight& f = *plan.flight;
  f.movers = movers_of_bodies(plan);
  find_bound(world, f);
  split(plan.linear, f.tied, f.bound.linear, f.flying.linear);
  split(plan.rotating, f.tied, f.bound.rotating, f.flying.rotating);
  if (f.flying.linear.count + f.flying.rotating.count == 0) return;
  each_mover_of_bodies(plan, f.movers, [&](std::size_t row, const PlannedEffect& effect) {
    split(effect.customers, f.tied, f.bound.of_row[row], f.flying.of_row[row]);
  });
  f.any = true;
  exchange(plan, f.movers, f.bound);
}

void fly_free(const World& world, Poses& poses, Quarantining to, const StepTime& time) {
  Plan& plan = *world.plan;
  if (!plan.flight || !std::exchange(plan.flight->any, false)) return;
  FreeFlight& f = *plan.flight;
  exchange(plan, f.movers, f.bound);
  exchange(plan, f.movers, f.flying), exchange_the_rest(plan, f);
  const StepTime whole{time.dt, time.dt};
  const bool is_booked = keeps_books(world);
  integrate_velocity(world, to, whole);
  if (is_booked) book_stage(world, Booking::forces, whole);
  integrate_position(world, poses, to, whole);
  if (is_booked) book_stage(world, Booking::moves, whole);
  exchange(plan, f.movers, f.flying), exchange_the_rest(plan, f);
}

}  // namespace carom::dynamics
