// Out of the arrays of the step, and back: boxes into the tree, records of pairs and impulses aside, lists of the plan
// cut down to who is awake.
#include <algorithm>
#include <tuple>
#include <utility>

#include "dynamics/force/force.h"
#include "dynamics/joint/wide_joints.h"
#include "dynamics/sleep/sleep.h"

namespace carom::dynamics {
namespace {

template <class F>
void each_collider(const Scene& scene, std::uint32_t body, F&& f) {
  for (std::uint32_t c = scene.first_collider[body]; c != kInvalid; c = scene.colliders.next[c]) f(c);
}

/// Rows of the table whose participants are bodies.
bool of_bodies(const PlannedEffect& row) {
  return row.effect->stage == Stage::integrate || row.effect->stage == Stage::observe;
}

/// Put boxes into the tree: one by one, or, where they are many, all afresh.
void plant(const World& world, Sleep& z, const Array<std::uint32_t>& colliders) {
  const Colliders& c = world.scene.colliders;
  bool afresh = 8 * colliders.size() > z.tree.size();
  z.tree.grow(c.slots());
  for (const std::uint32_t slot : colliders) {
    const Aabb& box = c.bounds[slot];
    if (!(box.lo.x() <= box.hi.x())) continue;  // of a support function that failed: it touches nothing
    z.in_tree[slot] = 1;
    if (afresh) continue;
    const std::size_t depth = z.tree.insert(slot, box);
    afresh = depth > 64;  // long before a walk down costs more than halving all of them would
  }
  if (!afresh) return;
  z.hits.clear();
  for (std::uint32_t slot = 0; slot < z.in_tree.size(); ++slot)
    if (z.in_tree[slot]) z.hits.push_back(slot);
  z.tree.build(z.hits, c.bounds);
}

/// Records between two that do not move, one of them asleep.
void deactivate_pairs(const World& world, Sleep& z, PairTable& pairs) {
  const Scene& scene = world.scene;
  const State& s = world.state;
  const auto still = [&](std::uint32_t body) {
    return z.inactive[body] || scene.type[body] == BodyType::fixed ||
           (scene.type[body] == BodyType::kinematic && s.v[body] == Vec3::zero() && s.omega[body] == Vec3::zero());
  };
  z.holders.assign(world.pairs.size(), PairTable::none);
  for (std::size_t i = 0; i < world.pairs.size(); ++i) {
    const Pair& p = world.pairs.place(i).pair;
    const std::uint32_t a = scene.colliders.body[p.a], b = scene.colliders.body[p.b];
    if (!still(a) || !still(b)) continue;
    if (z.inactive[a]) z.holders[i] |= PairTable::by_a;
    if (z.inactive[b]) z.holders[i] |= PairTable::by_b;
  }
  pairs.deactivate(z.holders, scene.colliders.slots());
}

void keep_impulse(Sleep& z, std::uint32_t body, const KeptImpulse& impulse) {
  std::uint32_t k;
  if (z.kept_free.empty()) {
    k = static_cast<std::uint32_t>(z.kept.size());
    z.kept.push_back(impulse);
  } else {
    k = z.kept_free.back();
    z.kept_free.pop_back();
    z.kept[k] = impulse;
  }
  z.kept[k].next = std::exchange(z.kept_first[body], k);
}

/// Impulses of pairs that a sleeper is in: all its contacts are with its island or with what does not move.
void deactivate_impulses(const World& world, Sleep& z, Impulses& from) {
  const Array<std::uint32_t>& body = world.scene.colliders.body;
  z.kept.reserve(z.kept.size() + from.old.size());
  z.kept_free.reserve(z.kept.capacity());
  std::size_t stay = 0;
  std::uint32_t order = 0;
  for (std::size_t i = 0; i < from.old.size(); ++i) {
    order = i > 0 && from.old[i].pair == from.old[i - 1].pair ? order + 1 : 0;
    const std::uint32_t a = body[from.old[i].pair.a], b = body[from.old[i].pair.b];
    if (z.inactive[a] || z.inactive[b])
      keep_impulse(z, z.inactive[a] ? a : b, {from.old[i], from.old_h, order, kInvalid});
    else
      from.old[stay++] = from.old[i];
  }
  from.old.resize(stay);
}

/// Impulses of woken bodies, back among those that the step starts from.
void return_impulses(Sleep& z, Impulses& back_to, const Array<std::uint32_t>& bodies) {
  z.returning.clear();
  for (const std::uint32_t body : bodies)
    for (std::uint32_t k = z.kept_first[body]; k != kInvalid; k = z.kept[k].next)
      if (z.kept[k].impulse.pair.a != kInvalid) z.returning.push_back(z.kept[k]);
  std::sort(z.returning.begin(), z.returning.end(), [](const KeptImpulse& x, const KeptImpulse& y) {
    return std::tuple(x.impulse.pair.key(), x.order) < std::tuple(y.impulse.pair.key(), y.order);
  });
  std::size_t to = back_to.old.size() + z.returning.size(), i = back_to.old.size(), k = z.returning.size();
  back_to.old.resize(to);
  while (k > 0) {  // merged from behind; no pair is on both sides
    if (i > 0 && z.returning[k - 1].impulse.pair < back_to.old[i - 1].pair) {
      back_to.old[--to] = back_to.old[--i];
      continue;
    }
    KeptImpulse& back = z.returning[--k];
    if (!(back_to.old_h > 0)) back_to.old_h = back.h;
    if (back.h != back_to.old_h) back.impulse.stretch(back_to.old_h / back.h);  // as if the others' substep had made it
    back_to.old[--to] = back.impulse;
  }
  for (const std::uint32_t body : bodies)
    while (z.kept_first[body] != kInvalid) {
      const std::uint32_t at = z.kept_first[body];
      z.kept_first[body] = z.kept[at].next;
      z.kept_free.push_back(at);
    }
}

void deactivate(const World& world, Settling to) {
  Sleep& z = to;
  const Scene& scene = world.scene;
  z.colliders.clear();
  z.in_tree.resize(scene.colliders.slots(), 0);
  for (const std::uint32_t i : z.fallen) {
    if (!world.state.asleep[i] || z.inactive[i]) continue;
    z.inactive[i] = 1;
    if (scene.first_collider[i] != kInvalid) world.plan->rotation[i] = world.state.q[i].matrix();
    each_collider(scene, i, [&](std::uint32_t c) {
      place_collider(world, to, to, *world.plan, c, 0);
      z.colliders.push_back(c);
    });
  }
  z.fallen.clear();
  plant(world, z, z.colliders);
  deactivate_pairs(world, z, to);
  deactivate_impulses(world, z, to);
}

void take_back(const World& world, Sleep& z, Impulses& to) {
  z.bodies.clear();
  for (const std::uint32_t i : z.woken)
    if (!world.state.asleep[i] && z.inactive[i]) z.bodies.push_back(i), z.inactive[i] = 0;
  z.woken.clear();
  std::sort(z.bodies.begin(), z.bodies.end());
  for (const std::uint32_t i : z.bodies)
    each_collider(world.scene, i, [&](std::uint32_t c) {
      if (c < z.in_tree.size() && z.in_tree[c]) z.tree.remove(c), z.in_tree[c] = 0;
      z.rejoined.push_back(c);
    });
  return_impulses(z, to, z.bodies);
}

/// Who of an ascending list is awake, and the woken bodies (ascending) among them.
void relist(const World& world, Sleep& z, const Array<std::uint32_t>& woken, Participants& list) {
  z.spare.clear();
  std::size_t k = 0;
  list.each([&](std::uint32_t i) {
    while (k < woken.size() && woken[k] < i) z.spare.add(woken[k++]);
    if (k < woken.size() && woken[k] == i) ++k;
    if (!world.state.asleep[i]) z.spare.add(i);
  });
  while (k < woken.size()) z.spare.add(woken[k++]);
  std::swap(list, z.spare);
}

void relist_colliders(const World& world, Sleep& z, Colliders& c, const Array<std::uint32_t>& woken) {
  z.colliders.clear();
  for (const std::uint32_t i : woken)
    each_collider(world.scene, i, [&](std::uint32_t slot) { z.colliders.push_back(slot); });
  std::sort(z.colliders.begin(), z.colliders.end());
  std::erase_if(z.colliders,
                [&](std::uint32_t slot) { return std::binary_search(c.active.begin(), c.active.end(), slot); });
  std::erase_if(c.active, [&](std::uint32_t slot) { return world.state.sleeps(c.body[slot]); });
  const std::size_t before = c.active.size();
  c.active.insert(c.active.end(), z.colliders.begin(), z.colliders.end());
  std::size_t to = c.active.size(), i = before, k = z.colliders.size();
  while (k > 0) c.active[--to] = i > 0 && z.colliders[k - 1] < c.active[i - 1] ? c.active[--i] : z.colliders[--k];
  world.plan->colliders.clear();
  for (const std::uint32_t slot : c.active)
    if (c.movable[slot]) world.plan->colliders.push_back(slot);
}

/// Everybody's rows and lists, for those who are awake.
void list_awake(const World& world, Sleep& z, Colliders& colliders, Joints& joints, const Array<std::uint32_t>& woken) {
  Plan& plan = *world.plan;
  relist(world, z, woken, plan.effects[+EffectId::sleep].candidates);
  relist_colliders(world, z, colliders, woken);
  const Participants& awake = plan.effects[+EffectId::sleep].candidates;
  plan.linear.clear(), plan.rotating.clear();
  awake.each([&](std::uint32_t i) { (rotates(world.scene, i) ? plan.rotating : plan.linear).add(i); });
  for (std::size_t k = 0; k < plan.effects.size(); ++k) {
    PlannedEffect& row = plan.effects[k];
    if (of_bodies(row) && k != +EffectId::sleep && !from_host(*row.effect)) {
      row.candidates.clear();
      awake.each([&](std::uint32_t i) {
        if (z.rows[i] & row_bit(k)) row.candidates.add(i);
      });
    }
    if (row.effect->stage == Stage::broad) {
      find_candidates(world, row);
    }
    if (row.effect->stage != Stage::solve && k != +EffectId::springs && !row.effect->wakes)
      row.participants = row.candidates;
  }
  plan_joints(world, joints);
  plan_springs(world);
  plan_stages(world, plan);
}

}  // namespace

Sleep::Sleep(Memory* m)
    : inactive(m),
      ring(m),
      sleep_timer(m),
      anchor_x(m),
      anchor_q(m),
      radius(m),
      rows(m),
      kept_first(m),
      root(m),
      restless(m),
      fallen(m),
      woken(m),
      touched_by_host(m),
      rejoined(m),
      tree(m),
      in_tree(m),
      kept(m),
      kept_free(m),
      near(m),
      bodies(m),
      colliders(m),
      asking(m),
      hits(m),
      holders(m),
      returning(m),
      spare(m) {}

/// All that is inactive, into an empty tree.
static void replant(const World& world, Sleep& z, Colliders& table, PlacedPoses& placed) {
  z.colliders.clear();
  z.tree.clear();
  z.in_tree.assign(world.scene.colliders.slots(), 0);
  for (std::uint32_t i = 0; i < z.inactive.size(); ++i) {
    if (!z.inactive[i]) continue;
    if (world.scene.first_collider[i] != kInvalid) world.plan->rotation[i] = world.state.q[i].matrix();
    each_collider(world.scene, i, [&](std::uint32_t c) {
      place_collider(world, table, placed, *world.plan, c, 0);
      z.colliders.push_back(c);
    });
  }
  plant(world, z, z.colliders);
  z.replant = false;
}

void plan_sleep(const World& world, Settling to, Plan& plan) {
  if (plan.effects[+EffectId::sleep].candidates.count == 0) return;  // the dial is off: no body sleeps
  Sleep& z = to;
  const Scene& scene = world.scene;
  const std::uint32_t slots = scene.bodies.slots();
  SleepFlags& flags = to;
  z.fallen.reserve(slots), z.woken.reserve(slots);
  z.inactive.resize(slots, 0), z.ring.resize(slots, kInvalid), z.anchor_x.resize(slots, Vec3::zero());
  z.anchor_q.resize(slots, Quat::identity()), z.radius.resize(slots, 0), z.kept_first.resize(slots, kInvalid);
  z.root.resize(slots, 0), z.restless.resize(slots, 0), flags.asleep.resize(slots, 0);
  z.sleep_timer.resize(slots, 0);  // last: its size says that all have theirs
  z.rows.assign(slots, 0);
  for (std::size_t k = 0; k < plan.effects.size(); ++k)
    if (of_bodies(plan.effects[k]) && !from_host(*plan.effects[k].effect))
      plan.effects[k].candidates.each([&](std::uint32_t i) { z.rows[i] |= row_bit(k); });
  plan.effects[+EffectId::sleep].candidates.each([&](std::uint32_t i) { z.radius[i] = radius_of_body(world, i); });
  z.bodies.clear();
  if (z.count > 0) list_awake(world, z, to, to, z.bodies);
}

void clear_sleepers(const World& world, ClearingSleepers to) {
  Sleep& z = to;
  wake_all(world, to);
  z.tree.clear();
  z.replant = false;
  std::fill(z.in_tree.begin(), z.in_tree.end(), std::uint8_t(0));
  std::fill(z.inactive.begin(), z.inactive.end(), std::uint8_t(0));
  std::fill(z.kept_first.begin(), z.kept_first.end(), kInvalid);
  z.kept.clear(), z.kept_free.clear(), z.fallen.clear(), z.woken.clear(), z.rejoined.clear(), z.near.clear();
  Impulses& impulses = to;
  PairTable& pairs = to;
  Revisions& scene = to;
  impulses.old.clear();
  pairs.clear();
  ++scene.revision;
}

bool settle_sleepers(const World& world, Settling to) {
  Revisions& scene = to;
  Sleep& z = to;
  if (z.replant) replant(world, z, to, to);
  if (std::exchange(scene.alarm, false)) wake_all(world, to);
  if (z.fallen.empty() && z.woken.empty()) return false;
  rejoin(world, to);
  return true;
}

void rejoin(const World& world, Settling to) {
  Sleep& z = to;
  try {
    take_back(world, z, to);
    if (!z.fallen.empty()) deactivate(world, to);
    if (!anyone_sleeps(world.scene)) return;  // the plan is everybody's
    std::erase_if(z.bodies, [&](std::uint32_t i) { return !responds(world.scene, world.state, i); });
    list_awake(world, z, to, to, z.bodies);
  } catch (...) {
    clear_sleepers(world, to);
    throw;
  }
}

}  // namespace carom::dynamics
