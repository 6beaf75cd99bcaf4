// Parts of the lists of a plan.
#include "dynamics/plan_lists.h"

#include <utility>

namespace carom::dynamics {
namespace {

template <class F>
void each_list(Plan& plan, PlanLists& lists, F&& f) {
  f(plan.linear, lists.linear), f(plan.rotating, lists.rotating);
  f(plan.sprung, lists.sprung), f(plan.readers, lists.readers);
  for (std::size_t row = 0; row < kEffectCount; ++row)
    if (plan.effects[row].effect->participants == ParticipantKind::bodies &&
        plan.effects[row].effect->stage == Stage::integrate)
      f(plan.effects[row].participants, lists.of_row[row]);
}

}  // namespace

PlanLists::PlanLists(Memory* m) : linear(m), rotating(m), sprung(m), readers(m), of_row(m) {
  of_row.reserve(kEffectCount);
  for (std::size_t row = 0; row < kEffectCount; ++row) of_row.emplace_back(m);
}

void list_others(const World& world, const Participants& those, PlanLists& lists) {
  each_list(*world.plan, lists, [&](Participants& all, Participants& others) { take_out(all, those, others); });
}

void list_part(const World& world, const Participants& those, Participants& scratch, PlanLists& lists) {
  each_list(*world.plan, lists, [&](Participants& all, Participants& part) {
    take_out(all, those, scratch);
    take_out(all, scratch, part);
  });
}

void part_springs(const World& world, const Participants& those, PlanLists& part, PlanLists* rest) {
  Participants& of = part.of_row[+EffectId::springs];
  of.clear();
  if (rest) rest->of_row[+EffectId::springs].clear();
  world.plan->effects[+EffectId::springs].participants.each([&](std::uint32_t k) {
    const SpringDef& def = world.scene.springs.def[k];
    const auto is_part = [&](std::uint32_t body) { return body != kInvalid && those.has(body); };
    if (is_part(def.body_a) || is_part(def.body_b))
      of.add(k);
    else if (rest)
      rest->of_row[+EffectId::springs].add(k);
  });
}

void exchange_lists(Plan& plan, PlanLists& lists) {
  each_list(plan, lists, [](Participants& one, Participants& other) { std::swap(one, other); });
  std::swap(plan.effects[+EffectId::springs].participants, lists.of_row[+EffectId::springs]);
}

}  // namespace carom::dynamics
