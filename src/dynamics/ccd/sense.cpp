// What a swept body passes that senses: asked along the path that it takes, between one hit and the next.
#include <utility>

#include "collision/scenery/ask.h"
#include "dynamics/ccd/sweeper.h"
#include "dynamics/events/events.h"
#include "dynamics/filter.h"

namespace carom::dynamics {
namespace {

constexpr Real kPassTolerance = 1e-9;  // of the smaller of the two, @see meet.cpp
constexpr int kPassCap = 256;          // distance queries

}  // namespace

bool senses_sweeps(const World& world) {
  return (world.events->wanted & Events::sensor) && world.plan->effects[+EffectId::sensor].participants.count > 0;
}

/// Sensors on the path of a body since they were last asked; and what its own sensors pass.
void Sweeper::sense(SweptBody& b, Real to) {
  const Real from = std::exchange(b.sensed, to);
  if (!listens_ || !b.swept || !(from < to)) return;
  const Colliders& table = world_.scene.colliders;
  for (std::uint32_t own = world_.scene.first_collider[b.body]; own != kInvalid; own = table.next[own]) {
    if (table.disabled[own] || is_scenery(*table.shape[own])) continue;
    gather(b, swept_box(b, own, from), from);
    for (const std::uint32_t other : c_.found) {
      if (table.is_sensor(own) == table.is_sensor(other) || !may_touch(table, own, other)) continue;
      if (filtered_ && !lets_touch(world_.scene, own, other)) continue;
      if (c_.passed.size() < c_.passed.capacity() && passes(b, own, other, from, to))
        c_.passed.push_back({std::min(own, other), std::max(own, other)});
    }
  }
}

bool Sweeper::passes(const SweptBody& b, std::uint32_t own, std::uint32_t other, Real from, Real to) {
  const Colliders& table = world_.scene.colliders;
  const Path other_path = path_of(table.body[other]);
  CastSettings settings;
  settings.tolerance = kPassTolerance;
  settings.cap = kPassCap;
  bool any = false;
  const Aabb box = b.path.swept(from, to, b.radius);
  each_swept_part(world_, own, table.bounds[other], [&](const SweptPart& mine) {
    each_swept_part(world_, other, box, [&](const SweptPart& its) {
      CastResult r;
      SupportFault fault;
      any_shape::time_of_impact(*mine.shape, b.path.motion(mine, from), *its.shape, other_path.motion(its, from),
                                to - from, settings, r, fault);
      if (fault.kind != SupportFault::none && c_.fault.kind == SupportFault::none) c_.fault = fault;
      any |= fault.kind == SupportFault::none && r.outcome != CastOutcome::miss && r.status != QueryStatus::fault;
    });
  });
  return any;
}

}  // namespace carom::dynamics
