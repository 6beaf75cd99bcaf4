// Whom something that moves comes near, and whom it touches: those wake before the step makes contacts.
#include <algorithm>

#include "dynamics/ccd/continuous.h"
#include "dynamics/detect.h"
#include "dynamics/filter.h"
#include "dynamics/force/force.h"
#include "dynamics/scenery.h"
#include "dynamics/sleep/sleep.h"

namespace carom::dynamics {
namespace {

void ask_for(const World& world, Sleep& z, std::uint32_t body) {
  const Colliders& c = world.scene.colliders;
  for (std::uint32_t slot = world.scene.first_collider[body]; slot != kInvalid; slot = c.next[slot])
    z.asking.push_back(slot);
}

/// Colliders of what moves, by itself or by a host's hand.
void gather_movers(const World& world, Sleep& z) {
  const Scene& scene = world.scene;
  const State& s = world.state;
  const Colliders& c = scene.colliders;
  z.asking.clear();
  for (const std::uint32_t slot : world.plan->colliders) {
    const std::uint32_t i = c.body[slot];
    if (scene.type[i] == BodyType::dynamic || s.v[i] != Vec3::zero() || s.omega[i] != Vec3::zero())
      z.asking.push_back(slot);
  }
  for (const std::uint32_t i : z.touched_by_host) ask_for(world, z, i);
  z.touched_by_host.clear();
}

/// Who hangs on a kinematic body that moves; of those woken, the colliders ask like other movers'.
void wake_drawn(const World& world, Sleepers to) {
  if (world.joints.slots.alive_count() == 0) return;
  Sleep& z = to;
  const State& s = world.state;
  const std::size_t before = z.woken.size();
  world.plan->kinematic.each([&](std::uint32_t i) {
    if (s.v[i] != Vec3::zero() || s.omega[i] != Vec3::zero()) wake_joined(world, to, i);
  });
  for (std::size_t k = before; k < z.woken.size(); ++k) ask_for(world, z, z.woken[k]);
}

/// Whether the narrow phase would find a contact. Asked with a copy of what the pair remembers, so that the result is
/// the narrow phase's own, and what is remembered stays as it was.
bool touches(const World& world, NarrowReport& report, const NarrowSettings& settings, const Pair& pair) {
  const Colliders& c = world.scene.colliders;
  if (is_scenery(*c.shape[pair.a]) || is_scenery(*c.shape[pair.b]))
    return touches_scenery(world, report, settings, pair);
  NarrowSettings own = settings;
  own.manifold.contact_distance += c.reach[pair.a] + c.reach[pair.b];
  const PairTable::Found kept = world.pairs.find(pair);
  QueryMemory memory = kept.record ? kept.record->memory : QueryMemory{};
  Certificate certificate = kept.certificate ? *kept.certificate : Certificate{};
  Candidates found;
  SupportFault fault;
  collide(*c.shape[pair.a], c.frame[pair.a], *c.shape[pair.b], c.frame[pair.b], own, memory, &certificate, found,
          report, fault);
  return found.count > 0 || fault.kind != SupportFault::none;  // a fault is the narrow phase's to tell
}

/// Ask what one collider touches. Whom it wakes asks in turn: what slept apart may have come to rest in touch.
void ask(const World& world, Sleepers to, NarrowReport& report, const NarrowSettings& settings, std::uint32_t slot,
         Real dt) {
  Sleep& z = to;
  const Colliders& c = world.scene.colliders;
  if (!(c.bounds[slot].lo.x() <= c.bounds[slot].hi.x())) return;
  const Aabb box = swept_bounds(world, slot, dt);
  const bool filtered = any_held_apart(world);
  z.hits.clear();
  z.tree.query(box, [&](std::uint32_t other) { z.hits.push_back(other); });
  std::sort(z.hits.begin(), z.hits.end());  // the tree's order means nothing
  for (const std::uint32_t other : z.hits) {
    const std::uint32_t body = c.body[other];
    if (!world.state.asleep[body] || !may_touch(c, slot, other) || (filtered && !lets_touch(world.scene, slot, other)))
      continue;
    const Pair pair{std::min(slot, other), std::max(slot, other)};
    const bool meets = !c.is_sensor(slot) && !c.is_sensor(other) &&
                       (touches(world, report, settings, pair) || sweeps_into(world, slot, other, dt));
    if (!meets) {
      z.near.push_back(pair);
      continue;
    }
    const std::size_t before = z.woken.size();
    wake(world, to, body);
    for (std::size_t k = before; k < z.woken.size(); ++k) ask_for(world, z, z.woken[k]);
  }
}

}  // namespace

void wake_touched(const World& world, Settling to, SpringLoads& springs, StepReport& report, const StepTime& time) {
  Sleep& z = to;
  z.near.clear();
  if (z.count == 0) return z.touched_by_host.clear();
  const NarrowSettings settings = narrow_settings(world.scene.dials);
  try {
    gather_movers(world, z);
    wake_drawn(world, to);
    for (std::size_t k = 0; k < z.asking.size(); ++k) ask(world, to, report.narrow, settings, z.asking[k], time.dt);
    if (!z.woken.empty()) rejoin(world, to);
  } catch (...) {
    clear_sleepers(world, to);  // whom a host's hand stirred, and whom it touched, is lost otherwise
    throw;
  }
  carry_springs(world, springs, time.h);
  find_participants(world, time.h);
  // Between two that are awake by now, the broad phase finds the pair. What does not move makes none with a sleeper.
  const Colliders& c = world.scene.colliders;
  const auto void_pair = [&](const Pair& p) {
    return world.state.asleep[c.body[p.a]] == world.state.asleep[c.body[p.b]];
  };
  std::erase_if(z.near, void_pair);
  std::sort(z.near.begin(), z.near.end());
  z.near.erase(std::unique(z.near.begin(), z.near.end()), z.near.end());
}

}  // namespace carom::dynamics
