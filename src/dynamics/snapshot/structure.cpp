#include <algorithm>
#include <mutex>

#include "collision/hull_of.h"
#include "collision/scenery/scenery.h"
#include "core/hash.h"
#include "dynamics/snapshot/structure_cache.h"
#include "dynamics/world.h"

namespace carom::dynamics {
namespace snapshot {
namespace {

template <class M>
void add(Hash& h, const M& m) {
  for (const Real x : m.at) h.add(double(x));
}
void add(Hash& h, const Pose& p) { add(h, p.q), add(h, p.p); }

/// What tells a shape from others: its numbers, and what was derived from its support function.
std::uint64_t print_of(const Shape& s) {
  Hash h;
  h.add(static_cast<std::uint64_t>(s.form));
  for (const double p : s.params) h.add(p);
  h.add(s.core_radius), h.add(s.bounding_radius), h.add(s.mass.volume), h.add(s.offset);
  add(h, s.bounds.lo), add(h, s.bounds.hi), add(h, s.mass.inertia), add(h, s.normal);
  if (s.hull_of) {
    for (const double x : s.hull_of->numbers) h.add(x);
    for (const HullOf::Part& part : s.hull_of->parts) h.add(print_of(*part.shape));
  }
  if (!s.scenery) return h.value();
  const Scenery& g = *s.scenery;
  h.add(std::uint64_t(g.two_sided)), h.add((std::uint64_t(g.columns) << 32) | g.rows);
  h.add(g.spacing_x), h.add(g.spacing_z);
  for (const Vec3& v : g.vertex) add(h, v);
  for (const std::uint32_t c : g.corner) h.add(std::uint64_t(c));
  for (const double y : g.heights) h.add(y);
  return h.value();
}

/// Of shapes that were met already. Colliders are many, shapes few.
class ShapePrints {
 public:
  explicit ShapePrints(Memory* m) : known_(m) {}
  std::uint64_t of(const Shape* shape) {
    const auto before = [](const Known& k, const Shape* s) { return std::less<>()(k.shape, s); };
    const auto at = std::lower_bound(known_.begin(), known_.end(), shape, before);
    if (at != known_.end() && at->shape == shape) return at->print;
    return known_.insert(at, {shape, print_of(*shape)})->print;
  }

 private:
  struct Known {
    const Shape* shape;
    std::uint64_t print;
  };
  Array<Known> known_;
};

/// @param each  f(hash, slot) for those alive
template <class F>
KindPrint print_of(const SlotPool& pool, F&& each) {
  Hash h;
  pool.add_to(h);
  for (std::uint32_t i = 0; i < pool.slots(); ++i)
    if (pool.alive(i)) each(h, i);
  return {pool.slots(), pool.alive_count(), h.value()};
}

Structure structure_of(const World& world, Memory* memory) {
  const Scene& s = world.scene;
  const auto nothing_else = [](Hash&, std::uint32_t) {};
  ShapePrints shapes(memory);
  return {print_of(s.bodies,
                   [&](Hash& h, std::uint32_t i) {
                     const BodySettings& d = s.def[i];
                     h.add(static_cast<std::uint64_t>(d.type) | (d.stays_awake ? 256u : 0u));
                     h.add(s.mass[i]), h.add(d.linear_damping), h.add(d.angular_damping);
                     add(h, s.center[i]), add(h, s.inertia[i]);
                   }),
          print_of(s.collider_slots,
                   [&](Hash& h, std::uint32_t i) {
                     const Colliders& c = s.colliders;
                     h.add((std::uint64_t(c.body[i]) << 32) | c.material[i]);
                     h.add(shapes.of(c.shape[i])), h.add(c.density[i]);
                     add(h, c.local[i]);
                   }),
          print_of(s.material_slots, nothing_else),
          print_of(world.joints.slots,
                   [&](Hash& h, std::uint32_t i) {
                     const JointDef& d = world.joints.joint[i].def;
                     h.add((static_cast<std::uint64_t>(d.kind) << 1) | d.collide);
                     h.add((std::uint64_t(d.body_a) << 32) | d.body_b);
                     add(h, d.frame_a), add(h, d.frame_b);
                     h.add(d.length), h.add(d.break_force), h.add(d.break_torque);
                     if (!is_coupling(d.kind)) return;
                     const Coupling& c = world.joints.coupling_of(world.joints.joint[i]);
                     h.add((std::uint64_t(c.follower) << 32) | c.leader);
                   }),
          print_of(world.particles.slots, nothing_else),
          print_of(s.fields.slots, nothing_else),
          print_of(s.springs.slots, [&](Hash& h, std::uint32_t i) {
            const SpringDef& d = s.springs.def[i];
            h.add((std::uint64_t(d.body_a) << 32) | d.body_b);
            add(h, d.anchor_a), add(h, d.anchor_b);
            h.add(std::uint64_t(d.only_pulls));
          })};
}

}  // namespace
}  // namespace snapshot

struct StructureCache::Known {
  std::mutex mutex;
  std::uint64_t changes = ~std::uint64_t(0);  // of slots, that it is up to date with
  snapshot::Structure structure;
};

snapshot::Structure StructureCache::of(const World& world) const {
  const Scene& s = world.scene;
  std::uint64_t changes = 0;
  for (const SlotPool* pool : {&s.bodies, &s.collider_slots, &s.material_slots, &world.joints.slots,
                               &world.particles.slots, &s.fields.slots, &s.springs.slots})
    changes += pool->changes();
  Known* known = known_.load(std::memory_order_acquire);
  if (!known) {
    std::pmr::polymorphic_allocator<> memory(world.memory);
    Known* const own = memory.new_object<Known>();
    if (known_.compare_exchange_strong(known, own, std::memory_order_acq_rel))
      known = own;
    else
      memory.delete_object(own);  // another reader was first
  }
  const std::lock_guard lock(known->mutex);
  if (changes != known->changes)
    known->structure = snapshot::structure_of(world, world.memory), known->changes = changes;
  return known->structure;
}

void StructureCache::forget(Memory* memory) {
  if (Known* const known = known_.exchange(nullptr)) std::pmr::polymorphic_allocator<>(memory).delete_object(known);
}

}  // namespace carom::dynamics
