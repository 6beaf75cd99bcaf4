// What wakes sleepers between steps. Only flags change here, and no body's pose or cache; the arrays follow when the
// next step settles.
#include <algorithm>

#include "dynamics/sleep/sleep.h"

namespace carom::dynamics {
namespace {

/// Call f(pair, record) for the record of every pair that a sleeper may be in. Those who fell asleep in the last step
/// are not inactive yet.
template <class F>
void each_record(const World& world, F&& f) {
  world.pairs.each_inactive(f);
  for (std::size_t i = 0; i < world.pairs.size(); ++i) f(world.pairs.place(i).pair, world.pairs[i]);
}

void wake_both(World& world, const Pair& pair) {
  wake(world, world.scene.colliders.body[pair.a]);
  wake(world, world.scene.colliders.body[pair.b]);
}

}  // namespace

void wake(const World& world, Sleepers to, std::uint32_t body) {
  Sleep& z = to;
  SleepFlags& flags = to;
  if (body >= z.sleep_timer.size()) return;
  z.sleep_timer[body] = 0;
  for (std::uint32_t i = body; world.state.asleep[i]; i = z.ring[i]) {
    flags.asleep[i] = 0;
    z.sleep_timer[i] = 0;
    z.anchor_x[i] = world.state.x[i], z.anchor_q[i] = world.state.q[i];
    if (z.inactive[i]) z.woken.push_back(i);  // reserved for every body
    --z.count, ++z.woke;
  }
}

void wake_all(const World& world, Sleepers to) {
  for (std::uint32_t i = 0; i < world.state.asleep.size(); ++i) wake(world, to, i);
}

void wake_touching(World& world, std::uint32_t collider) {
  if (world.sleep->count == 0) return;
  each_record(world, [&](const Pair& pair, const PairRecord& r) {
    if ((pair.a == collider || pair.b == collider) && r.manifold.count > 0) wake_both(world, pair);
  });
}

void wake_joined(const World& world, Sleepers to, std::uint32_t body) {
  world.joints.each_of(body, [&](std::uint32_t joint, std::uint32_t other) {
    if (other != kInvalid && !world.joints.joint[joint].broken) wake(world, to, other);
  });
  const Springs& springs = world.scene.springs;
  if (!springs.hang_on(body)) return;
  springs.each([&](std::uint32_t, const SpringDef& def) {
    if (def.hangs_on(body)) def.each_end([&](std::uint32_t end, const Vec3&) { wake(world, to, end); });
  });
}

void wake_wearing(World& world, std::uint32_t material) {
  if (world.sleep->count == 0) return;
  const Colliders& c = world.scene.colliders;
  each_record(world, [&](const Pair& pair, const PairRecord&) {
    if (c.material[pair.a] == material || c.material[pair.b] == material) wake_both(world, pair);
  });
}

void mark_touched_by_host(World& world, std::uint32_t body) {
  const Scene& scene = world.scene;
  if (scene.type[body] == BodyType::dynamic) return wake(world, body);
  if (world.sleep->count == 0) return;
  wake_joined(world, Sleepers(world), body);
  world.sleep->touched_by_host.push_back(body);
  for (std::uint32_t c = scene.first_collider[body]; c != kInvalid; c = scene.colliders.next[c])
    wake_touching(world, c);
}

void unlist_collider(World& world, std::uint32_t collider) {
  Sleep& z = *world.sleep;
  if (collider < z.in_tree.size() && z.in_tree[collider]) z.tree.remove(collider), z.in_tree[collider] = 0;
  const auto names = [&](const OldImpulse& o) { return o.pair.a == collider || o.pair.b == collider; };
  for (KeptImpulse& k : z.kept)
    if (names(k.impulse)) k.impulse.pair = {kInvalid, kInvalid};
  std::erase_if(world.impulses.old, names);
  std::erase_if(z.near, [&](const Pair& p) { return p.a == collider || p.b == collider; });
  std::erase(z.rejoined, collider);
}

void unlist_body(World& world, std::uint32_t body) {
  Sleep& z = *world.sleep;
  for (Array<std::uint32_t>* list : {&z.fallen, &z.woken, &z.touched_by_host}) std::erase(*list, body);
  if (body >= z.inactive.size()) return;
  z.inactive[body] = 0, z.ring[body] = kInvalid, z.sleep_timer[body] = 0;  // as of a slot that has not lived yet
  z.anchor_x[body] = Vec3::zero(), z.anchor_q[body] = Quat::identity();
  while (z.kept_first[body] != kInvalid) {
    const std::uint32_t k = z.kept_first[body];
    z.kept_first[body] = z.kept[k].next;
    z.kept_free.push_back(k);  // reserved for all
  }
}

}  // namespace carom::dynamics
