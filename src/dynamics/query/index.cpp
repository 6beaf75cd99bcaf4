// The index of a world, and what it takes to keep it.
#include "dynamics/query/index.h"

#include <algorithm>

#include "collision/volume.h"

namespace carom::dynamics {

QueryIndex::QueryIndex(Memory* m)
    : tree_(m),
      where_(m),
      seen_as_(m),
      bounds_(m),
      wide_(m),
      loose_(m),
      leaves_(m),
      moved_(m),
      is_moved_(m),
      changed_(m) {}

Frame collider_frame(const World& world, std::uint32_t slot) {
  const Colliders& c = world.scene.colliders;
  return Frame(world.pose(c.body[slot]) * c.local[slot]);
}

bool takes_part(const World& world, std::uint32_t slot) {
  const Colliders& c = world.scene.colliders;
  const Array<const Shape*>& faulty = world.plan->faulty;
  return !world.state.held_out[c.body[slot]] &&
         (faulty.empty() || std::find(faulty.begin(), faulty.end(), c.shape[slot]) == faulty.end());
}

/// Grows with every change of either kind. 0 is never reached: revisions begin with 1.
std::uint64_t QueryIndex::changes(const World& world, std::uint64_t moves) {
  return world.scene.collider_revision + moves;
}

void QueryIndex::mark_moved(std::uint32_t body, bool revised) {
  ++moves_;
  marked_ += revised;
  if (!whole_ || body >= is_moved_.size() || is_moved_[body]) return;  // who is new has its colliders noted
  is_moved_[body] = 1;
  moved_.push_back(body);  // reserved for all bodies
}

void QueryIndex::mark_changed(std::uint32_t slot) {
  if (!whole_ || changed_.size() == changed_.capacity()) return;  // without a note all will be looked at
  changed_.push_back(slot);
  ++marked_;
}

void save_moved_bodies(const World& world, const StepTime&) {
  if (!world.queries->in_use()) return;
  const auto mark = [&](std::uint32_t body) { world.queries->mark_moved(body); };
  world.plan->linear.each(mark);
  world.plan->rotating.each(mark);
  world.plan->kinematic.each(mark);
}

void QueryIndex::bring_up_to_date(const World& world) {
  const std::uint64_t now = changes(world, moves_);
  if (seen_.load(std::memory_order_acquire) == now) return;
  const std::lock_guard lock(mutex_);
  if (seen_.load(std::memory_order_relaxed) == now) return;
  update(world);
  seen_.store(now, std::memory_order_release);
}

void QueryIndex::update(const World& world) {
  const Scene& scene = world.scene;
  const bool all = !whole_ || revision_ + marked_ != scene.collider_revision;
  if (!whole_) {
    tree_.clear();
    std::fill(where_.begin(), where_.end(), Where::nowhere);
    wide_.clear(), loose_.clear(), moved_.clear();
    std::fill(is_moved_.begin(), is_moved_.end(), std::uint8_t(0));
  }
  whole_ = false;  // stays so if memory runs out
  grow(world);
  if (all) {
    look_at_all(world);
  } else {
    for (const std::uint32_t slot : changed_) look_at(world, slot);
    for (const std::uint32_t body : moved_)
      for (std::uint32_t c = scene.first_collider[body]; c != kInvalid; c = scene.colliders.next[c])
        if (where_[c] != Where::nowhere) look_at(world, c);
  }
  for (const std::uint32_t body : moved_) is_moved_[body] = 0;
  moved_.clear(), changed_.clear();
  tree_.refit();
  if (tree_.worn() || loose_.size() > 16 + tree_.size() / 64) rebuild();
  revision_ = scene.collider_revision;
  marked_ = 0;
  whole_ = true;
}

void QueryIndex::grow(const World& world) {
  const std::size_t slots = world.scene.colliders.slots(), bodies = world.scene.bodies.slots();
  if (is_moved_.size() < bodies) {
    moved_.reserve(2 * bodies);
    is_moved_.resize(bodies, 0);
  }
  changed_.reserve(slots / 8 + 64);
  if (where_.size() >= slots) return;
  for (Array<std::uint32_t>* list : {&wide_, &loose_, &leaves_}) list->reserve(2 * slots);
  seen_as_.resize(slots), bounds_.resize(slots);
  where_.resize(slots, Where::nowhere);
}

/// It was not noted which: every slot is compared with what is known of it.
void QueryIndex::look_at_all(const World& world) {
  largest_ = 0;
  for (std::uint32_t slot = 0; slot < where_.size(); ++slot) look_at(world, slot);
}

void QueryIndex::look_at(const World& world, std::uint32_t slot) {
  const Scene& scene = world.scene;
  if (!scene.collider_slots.alive(slot) || !takes_part(world, slot)) return take_out(slot);
  const Shape& shape = *scene.colliders.shape[slot];
  if (shape.form != Form::half_space) largest_ = std::max(largest_, shape.bounding_radius);
  const std::uint32_t body = scene.colliders.body[slot];
  const Handle handle = scene.collider_slots.handle(slot);
  SeenAs& as = seen_as_[slot];
  const bool known = where_[slot] != Where::nowhere && as.handle == handle && as.x == world.state.x[body] &&
                     as.q == world.state.q[body];
  as.handle = handle;
  if (!known) place(world, slot);
}

void QueryIndex::place(const World& world, std::uint32_t slot) {
  const std::uint32_t body = world.scene.colliders.body[slot];
  const Shape& shape = *world.scene.colliders.shape[slot];
  SeenAs& as = seen_as_[slot];
  as.x = world.state.x[body], as.q = world.state.q[body];
  as.frame = collider_frame(world, slot);
  SupportFault fault;
  Aabb& box = bounds_[slot] = world_bounds(shape, as.frame.r, as.frame.p, fault);
  if (shape.form == Form::half_space)
    put(slot, Where::wide);
  else if (is_empty(box))
    take_out(slot);  // its support function failed
  else if (where_[slot] == Where::tree)
    tree_.set(slot, box);
  else
    put(slot, Where::loose);
}

void QueryIndex::put(std::uint32_t slot, Where where) {
  if (where_[slot] == where) return;
  take_out(slot);
  where_[slot] = where;
  (where == Where::wide ? wide_ : loose_).push_back(slot);
}

void QueryIndex::take_out(std::uint32_t slot) {
  if (where_[slot] == Where::tree) tree_.remove(slot);
  if (where_[slot] == Where::wide) std::erase(wide_, slot);
  if (where_[slot] == Where::loose) std::erase(loose_, slot);
  where_[slot] = Where::nowhere;
}

void QueryIndex::rebuild() {
  leaves_.clear();
  for (std::uint32_t slot = 0; slot < where_.size(); ++slot)
    if (where_[slot] == Where::tree || where_[slot] == Where::loose)
      leaves_.push_back(slot), where_[slot] = Where::tree;
  loose_.clear();
  tree_.build(leaves_, bounds_);
}

}  // namespace carom::dynamics
