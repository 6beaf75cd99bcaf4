// Filters applied to the pairs of a step.
#include "dynamics/filter.h"

#include <algorithm>

namespace carom::dynamics {

void filtering::find(const Scene& scene, const State&, Participants& participants) {
  const Array<Filter>& filter = scene.colliders.filter;
  for (std::uint32_t slot = 0; slot < filter.size(); ++slot)
    if (scene.collider_slots.alive(slot) && !(filter[slot] == Filter())) participants.add(slot);
}

bool lets_touch(const Scene& scene, std::uint32_t a, std::uint32_t b) {
  const Colliders& c = scene.colliders;
  const std::uint32_t body_a = c.body[a], body_b = c.body[b];
  const auto filter = [&](std::uint32_t collider, std::uint32_t body) {
    return scene.modes.forbids(+EffectId::filter, body) ? Filter() : c.filter_of(collider);
  };
  return let_touch(filter(a, body_a), filter(b, body_b)) && !scene.apart.has(body_a, body_b) &&
         !scene.joined.has(body_a, body_b);
}

bool any_held_apart(const World& world) {
  return world.plan->effects[+EffectId::filter].participants.count > 0 || !world.scene.apart.empty() ||
         !world.scene.joined.empty();
}

void drop_filtered(const World& world, Array<Pair>& pairs) {
  if (!any_held_apart(world)) return;
  std::erase_if(pairs, [&](const Pair& p) { return !lets_touch(world.scene, p.a, p.b); });
}

}  // namespace carom::dynamics
