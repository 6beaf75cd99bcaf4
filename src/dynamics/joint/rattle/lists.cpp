// Whom a plan's loops go through: those that are held, and the others.
#include <utility>

#include "dynamics/joint/rattle/rattle.h"

namespace carom::dynamics {

RattleLists::RattleLists(Memory* m) : linear(m), rotating(m), sprung(m), readers(m), of_row(m) {
  of_row.reserve(kEffectCount);
  for (std::size_t row = 0; row < kEffectCount; ++row) of_row.emplace_back(m);
}

Rattle::Rattle(Memory* m)
    : all_active(m),
      island_of(m),
      parent(m),
      body_of(m),
      islands(m),
      bodies(m),
      joints(m),
      rows(m),
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
      x(m),
      v(m),
      omega(m),
      read_v(m),
      read_omega(m),
      accel(m),
      alpha(m),
      q(m),
      held(m),
      others(m),
      scratch(m),
      of_held(m),
      of_all(m),
      active(m),
      left_active(m) {}

namespace rattle {
namespace {

/// Whether a row changes velocities, of bodies or by springs.
bool acts_on_velocities(const Effect& effect) {
  return effect.stage == Stage::integrate && (effect.force || effect.flow) &&
         (effect.customers == CustomerKind::bodies || effect.customers == CustomerKind::springs);
}

template <class F>
void each_list(Plan& plan, RattleLists& lists, F&& f) {
  f(plan.linear, lists.linear), f(plan.rotating, lists.rotating);
  f(plan.sprung, lists.sprung), f(plan.readers, lists.readers);
  for (std::size_t row = 0; row < kEffectCount; ++row)
    if (plan.effects[row].effect->customers == CustomerKind::bodies && acts_on_velocities(*plan.effects[row].effect))
      f(plan.effects[row].customers, lists.of_row[row]);
}

}  // namespace

void exchange_lists(Plan& plan, RattleLists& lists) {
  each_list(plan, lists, [](Customers& one, Customers& other) { std::swap(one, other); });
  std::swap(plan.effects[+EffectId::springs].customers, lists.of_row[+EffectId::springs]);
}

/// Of the plan's lists, `of_held` become those of `held` bodies and `of_all` those of the others. Both ends of a spring
/// are held, or none of them.
void list_held(const World& world, Rattle& r) {
  Plan& plan = *world.plan;
  each_list(plan, r.of_all, [&](Customers& all, Customers& others) { take_out(all, r.held, others); });
  auto other = [&](Customers& all, Customers& held) {
    take_out(all, r.held, r.scratch);
    take_out(all, r.scratch, held);
  };
  each_list(plan, r.of_held, other);
  Customers &held = r.of_held.of_row[+EffectId::springs], &others = r.of_all.of_row[+EffectId::springs];
  held.clear(), others.clear();
  plan.effects[+EffectId::springs].customers.each([&](std::uint32_t k) {
    const SpringDef& def = world.scene.springs.def[k];
    const auto is_held = [&](std::uint32_t body) { return body != kTheWorld && r.held.has(body); };
    (is_held(def.body_a) || is_held(def.body_b) ? held : others).add(k);
  });
  // No torque, but how omega turns with its body: it turns as a free top here (step.cpp).
  r.of_held.of_row[+EffectId::gyroscopic].clear();
}

}  // namespace rattle
}  // namespace carom::dynamics
