// Restoring: look at all, reserve memory, then change.
#include "dynamics/snapshot/snapshot.h"

#include <algorithm>

#include "collision/broad/broad_phase.h"
#include "dynamics/contact/contact.h"
#include "dynamics/contact/lone_rollers.h"
#include "dynamics/contact_views.h"
#include "dynamics/events/events.h"
#include "dynamics/integrate/driven.h"
#include "dynamics/sleep/sleep.h"
#include "dynamics/snapshot/frame.h"

namespace carom::dynamics {
namespace snapshot {
namespace {

/// Solver severity knows no joints and no locks; the boundary refuses them, and so do snapshots.
bool check_solver(const World& world, Found& found, std::size_t dials, const Needs& needs, SnapshotFault& fault) {
  Needs none(world.memory);
  Checker io(found.begin[dials], found.end[dials], found.begin[dials] == nullptr, none);
  const std::uint64_t n = io.count(0, sizeof(Real));
  Real solver = Dials()[Dial::solver];
  for (std::uint64_t k = 0; k < n; ++k) {
    const Real value = io.value(Real(0));
    if (k == static_cast<std::uint64_t>(Dial::solver)) solver = value;
  }
  const bool knows =
      solver != 0 || (!(needs.attributes >> +AttributeId::locks & 1) && world.joints.slots.alive_count() == 0);
  return knows || refuse(fault, SnapshotFault::corrupt, "solver severity knows no joints and no locks");
}

/// Sparse arrays that begin to be used get an entry for all: what they stand for stays the same.
template <class T>
void widen(Array<T>& a, std::size_t n, const T& value, bool used) {
  if (used && a.size() < n) a.resize(n, value);
}

/// All that may run out of memory. What the world holds stays as it is.
void reserve_for(World& world, const Needs& n) {
  Scene& s = world.scene;
  Sleep& z = *world.sleep;
  Events& e = *world.events;
  const std::size_t bodies = s.bodies.slots(), colliders = s.colliders.slots();
  for (const AttributeRow& row : kAttributeTable)
    if (n.attributes >> +row.id & 1) s.attributes.reserve(row.id, s.bodies.slots());
  widen(s.locks, bodies, Locks(0), n.attributes >> +AttributeId::locks & 1);
  widen(s.modes.forbidden_of, bodies, RowBits(0), n.modes), widen(s.modes.forced_of, bodies, RowBits(0), n.modes);
  widen(s.colliders.filter, colliders, Filter(), n.filter);
  widen(s.colliders.sensor, colliders, std::uint8_t(0), n.sensor);
  widen(s.surface, colliders, SurfaceVelocity{}, n.surface);
  reserve_pairs(world, n);
  world.impulses.old.reserve(n.old), world.state.driven.reserve(n.driven);
  const std::size_t sleepers = n.sleepers;
  world.state.asleep.reserve(sleepers), z.inactive.reserve(sleepers), z.ring.reserve(sleepers),
      z.sleep_timer.reserve(sleepers);
  z.anchor_x.reserve(sleepers), z.anchor_q.reserve(sleepers), z.radius.reserve(sleepers), z.rows.reserve(sleepers);
  z.kept_first.reserve(sleepers), z.root.reserve(sleepers), z.restless.reserve(sleepers);
  if (sleepers > 0) z.fallen.reserve(std::max(bodies, n.fallen)), z.woken.reserve(std::max(bodies, n.woken));
  z.touched_by_host.reserve(n.touched_by_host), z.rejoined.reserve(n.rejoined);
  z.kept.reserve(n.kept), z.kept_free.reserve(z.kept.capacity());
  e.touching.reserve(n.touching), e.within.reserve(n.within), e.slept.reserve(std::max(e.slept.size(), n.slept));
  world.plan->faulty.reserve(n.faulty);
  s.material_pairs.reserve(n.material_pairs);
  s.apart.reserve(n.apart), s.joined.reserve(n.unbroken);
  world.joints.axes.reserve(world.joints.axes.size() + n.axes);
  for (const Needs::Set& need : n.sets) {
    ParticleSet& p = world.particles.set[need.slot];
    world.particles.reserve(need.slot, need.particles);
    if (need.weighed) p.mass.reserve(need.particles);
  }
}

/// What the last step left for who asks is not of the state that is put back.
void clear_last_step(World& world) {
  Contacts& c = *world.contacts;
  world.views->clear(), world.group_views.clear(), world.fault_views.clear();
  world.events->clear();
  c.rows.clear(), c.geometry.clear(), c.contact_pairs.clear(), c.bouncing.clear(), c.impacts.clear(),
      c.resisting.clear();
  c.driven.clear(), c.turning_pairs.clear(), c.surface.clear(), c.group_begin.clear(), c.group_rows.clear(),
      c.direct.clear();
}

/// Look at the state that is in the bytes, and reserve memory for it.
bool check_state(World& world, Found& found, SnapshotFault& fault) {
  std::size_t count = 0;
  const Section* const* const all = sections(count);
  Needs needs(world.memory);
  std::size_t dials = 0;
  for (std::size_t k = 0; k < count; ++k) {
    if (is_structure(*all[k])) continue;
    if (all[k] == &kDials) dials = k;
    Checker io(found.begin[k], found.end[k], found.begin[k] == nullptr, needs);
    all[k]->check(io, world);
    if (io.bad()) return refuse(fault, SnapshotFault::corrupt, "section %s holds what no world does", all[k]->name);
  }
  if (!check_solver(world, found, dials, needs, fault)) return false;
  reserve_for(world, needs);
  return true;
}

/// What check_state() has looked at. Does not fail.
void load_state(World& world, Found& found) {
  std::size_t count = 0;
  const Section* const* const all = sections(count);
  for (std::size_t k = 0; k < count; ++k) {
    Loader io(found.begin[k], found.end[k], found.begin[k] == nullptr);
    all[k]->load(io, world);
  }
  clear_last_step(world);
}

}  // namespace
}  // namespace snapshot

void World::abandon_step() {
  stop_leading(*this, state, {});
  for (auto& phase : broad) phase.reset();
  clear_sleepers(*this, ClearingSleepers(*this));
  snapshot::clear_last_step(*this);
  lone_rollers.reset();
  ++scene.collider_revision;
}

bool restore_state(World& world, const std::byte* bytes, std::uint64_t n, SnapshotFault& fault, Origin origin) {
  using namespace snapshot;
  Found found;
  if (!find_sections(bytes, n, found, fault, origin) || !check_structure_of(world, found, false, fault) ||
      !check_state(world, found, fault))
    return false;
  load_state(world, found);
  return true;
}

bool build_world(World& world, const std::byte* bytes, std::uint64_t n, ShapeMaker& shapes, SnapshotFault& fault) {
  using namespace snapshot;
  Found found;
  if (!find_sections(bytes, n, found, fault)) return false;
  Builder builder(world, shapes, fault);
  for (std::size_t k = 0; k < kWholeSections; ++k) {
    Needs none(world.memory);
    Checker io(found.whole_begin[k], found.whole_end[k], found.whole_begin[k] == nullptr, none);
    if (build_whole(k, io, builder)) continue;
    if (fault.kind != SnapshotFault::none) return false;
    return refuse(fault, SnapshotFault::corrupt, "section %s holds what no world does", kWhole[k].name);
  }
  // Where it is another, a shape is not what it was: its plugin has other code.
  if (!check_structure_of(world, found, true, fault) || !check_state(world, found, fault)) return false;
  load_state(world, found);
  return true;
}

}  // namespace carom::dynamics
