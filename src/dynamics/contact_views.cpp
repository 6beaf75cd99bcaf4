// Contact views from rows.
#include "dynamics/contact_views.h"

#include "dynamics/contact/contact.h"

namespace carom::dynamics {

const Array<ContactView>& ContactViews::of(const World& world) {
  std::uint8_t state = state_.load(std::memory_order_acquire);
  if (state == kMade) return list_;
  state = kDue;
  if (!state_.compare_exchange_strong(state, kBeingMade, std::memory_order_acquire)) {
    state_.wait(kBeingMade, std::memory_order_acquire);
    return list_;
  }
  const Contacts& c = *world.contacts;
  const State& s = world.state;
  list_.clear();
  for (std::size_t i = 0; i < c.rows.size(); ++i) {
    const Row& row = c.rows[i];
    const RowGeometry& g = c.geometry[i];
    const Pair& pair = world.pairs.place(g.pair).pair;
    const Real normal_impulse = g.impulse.dot(row.n);
    list_.push_back({pair.a, pair.b, 0.5 * ((s.x[row.a] + arm_a(world, row, g)) + (s.x[row.b] + arm_b(world, row, g))),
                     row.n, g.separation, normal_impulse, (g.impulse - normal_impulse * row.n).norm()});
  }
  state_.store(kMade, std::memory_order_release);
  state_.notify_all();
  return list_;
}

const Array<ContactView>& World::contact_views() const { return views->of(*this); }

}  // namespace carom::dynamics
