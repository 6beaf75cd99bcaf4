// What is remembered of sleepers beside their bodies; and what hosts that want events are to be told of.
#include "dynamics/sleep/sleep.h"

#include "dynamics/events/events.h"
#include "dynamics/snapshot/impulse.h"

namespace carom::dynamics::snapshot {
namespace {

/// A list of slots of something.
template <class Io, class List, class Good>
void slots(Io& io, List& list, std::size_t& need, std::size_t most, Good&& good) {
  const std::uint64_t n = io.count(list.size(), 4);
  io.demand(n <= most);
  if constexpr (Io::checks) need = n;
  if constexpr (Io::loads) list.resize(n);
  for (std::uint64_t k = 0; k < n && !io.bad(); ++k) {
    const std::uint32_t slot = io.value(Io::saves ? list[k] : 0u);
    io.demand(good(slot));
    if constexpr (Io::loads) list[k] = slot;
  }
}

/// Kept impulses of one body, in the order of their list.
template <class Io, class W>
void kept(Io& io, W& world, std::uint32_t body, std::uint32_t n) {
  auto& z = *world.sleep;
  std::uint32_t at = Io::saves ? z.kept_first[body] : kInvalid;
  for (std::uint32_t k = 0; k < n && !io.bad(); ++k) {
    const KeptImpulse now = Io::saves ? z.kept[at] : KeptImpulse{};
    KeptImpulse i{impulse(io, now.impulse), io.real(now.h), io.value(now.order), kInvalid};
    if constexpr (Io::checks) {
      const Pair& p = i.impulse.pair;
      const bool gone = p.a == kInvalid && p.b == kInvalid;
      io.demand((gone || (p.a < p.b && p.b < world.scene.colliders.slots())) && i.h > 0);
      ++io.needs.kept;
    }
    if constexpr (Io::saves) at = now.next;
    if constexpr (Io::loads) {
      const auto own = static_cast<std::uint32_t>(z.kept.size());
      (k == 0 ? z.kept_first[body] : z.kept[own - 1].next) = own;
      z.kept.push_back(i);
    }
  }
}

template <class W>
std::uint32_t kept_by(const W& world, std::uint32_t body) {
  const Sleep& z = *world.sleep;
  std::uint32_t n = 0;
  for (std::uint32_t k = z.kept_first[body]; k != kInvalid; k = z.kept[k].next) ++n;
  return n;
}

struct Sleepers {
  template <class Io, class W>
  static void go(Io& io, W& world) {
    auto& z = *world.sleep;
    const auto alarm = yes_or_no(io, world.scene.alarm);
    const std::uint64_t woke = io.value(z.woke);
    keep(io, world.scene.alarm, alarm), keep(io, z.woke, woke);
    Needs none(world.memory), &needs = needs_of(io, none);
    const auto body = [&](std::uint32_t i) { return world.scene.bodies.alive(i); };
    const auto sleeper = [&](std::uint32_t i) { return body(i) && i < needs.sleepers; };
    const auto collider = [&](std::uint32_t i) { return world.scene.collider_slots.alive(i); };
    const std::size_t bodies = world.scene.bodies.slots();
    slots(io, z.fallen, needs.fallen, bodies, sleeper), slots(io, z.woken, needs.woken, bodies, sleeper);
    slots(io, z.touched_by_host, needs.touched_by_host, kMaxSlots, body),
        slots(io, z.rejoined, needs.rejoined, kMaxSlots, collider);
    if constexpr (Io::loads) z.kept.clear(), z.kept_free.clear(), z.near.clear();
    const auto keeps = [&](std::uint32_t i) { return z.kept_first[i] != kInvalid; };
    std::uint64_t keepers = 0;
    if constexpr (Io::saves)
      for (std::uint32_t i = 0; i < z.kept_first.size(); ++i) keepers += keeps(i);
    keepers = io.count(keepers, 8);
    std::uint32_t i = 0;
    for (std::uint64_t k = 0; k < keepers && !io.bad(); ++k, ++i) {
      if constexpr (Io::saves)
        while (!keeps(i)) ++i;
      const std::uint32_t least = i;
      i = io.value(i);
      io.demand(i >= least && sleeper(i));
      std::uint32_t n = 0;
      if constexpr (Io::saves) n = kept_by(world, i);
      n = io.value(n);
      if (!io.bad()) kept(io, world, i, n);
    }
    if constexpr (Io::loads) {
      // The tree of boxes is planted anew, from the poses: which of them a question finds does not depend on how.
      z.tree.clear();
      z.in_tree.clear();
      z.replant = true;
    }
  }

 private:
  template <class Io>
  static Needs& needs_of(Io& io, Needs& none) {
    if constexpr (Io::checks)
      return io.needs;
    else
      return none;
  }
};

constexpr std::uint64_t kTagMask = std::uint64_t(0xFFFF) << 44;

template <class Io>
Handle name(Io& io, Handle now, std::uint32_t tag) {
  return (io.value(now & ~kTagMask) & ~kTagMask) | static_cast<std::uint64_t>(tag) << 44;
}

template <class Io, class W, class List>
void together(Io& io, W& world, List& list, std::size_t& need) {
  const std::uint32_t tag = world.scene.bodies.tag();
  const std::uint64_t n = io.count(list.size(), 41);
  need = n;
  if constexpr (Io::loads) list.resize(n);
  Pair last{0, 0};
  for (std::uint64_t k = 0; k < n && !io.bad(); ++k) {
    const Together now = Io::checks ? Together{} : list[k];
    Together t;
    t.pair.a = io.value(now.pair.a), t.pair.b = io.value(now.pair.b);
    t.a = name(io, now.a, tag), t.b = name(io, now.b, tag);
    t.body_a = name(io, now.body_a, tag), t.body_b = name(io, now.body_b, tag);
    t.a_senses = yes_or_no(io, now.a_senses);
    io.demand(t.pair.a < t.pair.b && t.pair.b < world.scene.colliders.slots() && (k == 0 || last < t.pair));
    last = t.pair;
    if constexpr (Io::loads) list[k] = t;
  }
}

struct Happenings {
  template <class Io, class W>
  static void go(Io& io, W& world) {
    auto& e = *world.events;
    const auto asked = io.value(e.asked), wanted = io.value(e.wanted);
    const Real speed = io.real(e.asked ? e.hit_speed : 0);
    io.demand((asked & ~std::uint32_t(Events::every)) == 0 && (wanted & ~asked) == 0 && speed >= 0);
    keep(io, e.asked, asked), keep(io, e.wanted, wanted), keep(io, e.hit_speed, asked ? speed : Real(1));
    std::size_t touching = 0, within = 0;
    together(io, world, e.touching, touching), together(io, world, e.within, within);
    const auto slept = io.value(static_cast<std::uint32_t>(e.slept.size()));
    io.demand(slept <= world.scene.bodies.slots());
    if constexpr (Io::checks) io.needs.touching = touching, io.needs.within = within, io.needs.slept = slept;
    if constexpr (Io::loads) e.slept.assign(slept, 0);  // bodies say who did
  }
};

}  // namespace

constinit const Section kSleepers = section<Sleepers>("SLEE", "sleepers");
constinit const Section kHappenings = section<Happenings>("EVEN", "events");

}  // namespace carom::dynamics::snapshot
