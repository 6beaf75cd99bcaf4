// Which bodies hang together in a step, and of what order the error of their motion is.
#include <algorithm>

#include "dynamics/accuracy/accuracy.h"
#include "dynamics/accuracy/passes.h"
#include "dynamics/ccd/continuous.h"
#include "dynamics/force/force.h"
#include "dynamics/integrate/free_flight.h"
#include "dynamics/integrate/integrator.h"
#include "dynamics/island.h"
#include "dynamics/solver/table.h"

namespace carom::dynamics::accuracy {
namespace {

/// By contacts, joints and springs. A solver that takes all contacts as one makes one island of them.
void unite(const World& world, Passes& p) {
  const Contacts& c = *world.contacts;
  const auto is_in = [&](std::uint32_t i) { return i != kInvalid && p.island_of[i] != kInvalid; };
  std::uint32_t whole = kInvalid;
  const bool is_one = world.plan->solver->row_by_row || world.scene.dials.choice(Dial::groups) == 0;
  const auto join = [&](std::uint32_t a, std::uint32_t b) {
    const std::uint32_t one = root_of(p.parent, a), other = root_of(p.parent, b);
    p.parent[std::max(one, other)] = std::min(one, other);
  };
  const auto meet = [&](std::uint32_t a, std::uint32_t b) {
    if (is_in(a) && is_in(b)) join(a, b);
    if (!is_one) return;
    for (const std::uint32_t i : {a, b})
      if (is_in(i)) whole == kInvalid ? whole = i : (join(whole, i), whole);
  };
  for (const ContactPair& m : c.contact_pairs) meet(m.a, m.b);
  for (const Link& l : c.links) meet(l.a, l.b);
  world.plan->effects[+EffectId::springs].participants.each([&](std::uint32_t k) {
    const SpringDef& def = world.scene.springs.def[k];
    if (is_in(def.body_a) && is_in(def.body_b)) join(def.body_a, def.body_b);
  });
}

/// Whether nothing acts on a body but what turns it as a top, and what is constant.
bool is_top(const World& world, std::uint32_t body) {
  return only_constant_forces_act(world, body) && !world.plan->effects[+EffectId::user_torque].participants.has(body);
}

/// Whose bodies a sweep may change; and what would fly on but for sweeps, which nothing is known of before.
void find_swept_islands(const World& world, Passes& p) {
  const Continuous& c = *world.continuous;
  if (c.bodies.empty()) return;
  const auto mark = [&](std::uint32_t i) {
    if (p.island_of[i] != kInvalid) p.islands[p.island_of[i]].is_swept = true;
  };
  for (const SweptBody& b : c.bodies) mark(b.body);
  std::ranges::for_each(c.near, mark);
  if (world.plan->flight) world.plan->flight->watched.each(mark);
}

}  // namespace

int order_of(const World& world, const Passes& p, const Passes::Island& island) {
  if (island.rows + island.links > 0) return 1;
  constexpr int kOfIntegrator[] = {1, 1, 4, 2};
  const int order = kOfIntegrator[world.scene.dials.choice(Dial::integrator)];
  const Rotation* const method = world.plan->rotation_method;
  if (!method || !world.plan->integrator->exact_in_flight || island.bodies > 1) return order;
  if (!is_top(world, p.movers[p.members[island.first]])) return order;
  constexpr int kOfRotation[] = {1, 1, 1, 4, 2, 2, 4, 6};
  return kOfRotation[world.scene.dials.choice(Dial::rotation)];
}

void find_islands(const World& world, Passes& p, Real dt) {
  const Contacts& c = *world.contacts;
  p.island_of.assign(world.scene.bodies.slots(), kInvalid);
  p.parent.resize(world.scene.bodies.slots());
  p.movers.clear();
  each_of_both(world.plan->linear, world.plan->rotating, [&](std::uint32_t i) {
    p.movers.push_back(i);
    p.parent[i] = i, p.island_of[i] = 0;
  });
  unite(world, p);
  p.islands.clear();
  for (const std::uint32_t i : p.movers) {  // roots are the lowest of their islands
    const std::uint32_t r = root_of(p.parent, i);
    if (r == i) {
      p.island_of[i] = static_cast<std::uint32_t>(p.islands.size());
      p.islands.push_back({});
    }
    p.island_of[i] = p.island_of[r];
    ++p.islands[p.island_of[i]].bodies;
  }
  std::uint32_t first = 0;
  for (Passes::Island& island : p.islands) {
    island.first = first;
    first += island.bodies;
    island.bodies = 0;
  }
  p.members.resize(p.movers.size());
  for (std::uint32_t k = 0; k < p.movers.size(); ++k) {
    Passes::Island& island = p.islands[p.island_of[p.movers[k]]];
    p.members[island.first + island.bodies++] = k;
  }
  const auto of = [&](bool moves_a, std::uint32_t a, std::uint32_t b) { return p.island_of[moves_a ? a : b]; };
  for (const ContactPair& m : c.contact_pairs)
    if (const std::uint32_t k = of(m.moves_a, m.a, m.b); k != kInvalid) p.islands[k].rows += m.count;
  for (const Link& l : c.links)
    if (const std::uint32_t k = of(l.moves_a, l.a, l.b); k != kInvalid) ++p.islands[k].links;
  find_swept_islands(world, p);
  const Borne borne(world.scene.dials, dt);
  for (Passes::Island& island : p.islands) {
    bool is_first = true;
    each_member(p, island, [&](std::uint32_t, std::uint32_t i) {
      join_memory(island.memory, world.state.accuracy[i], is_first);
      is_first = false;
    });
    if (island.is_swept) continue;
    island.met = number_of(island.bodies, island.rows, island.links, island.memory.softly);
    island.trial.begin(island.memory, island.met, order_of(world, p, island),
                       island.memory.softly && island.rows > 0 ? borne.least_soft : 1,
                       borne.most_of(island.rows, world.plan->substeps));
  }
}

}  // namespace carom::dynamics::accuracy
