#include "dynamics/give_back.h"

#include "dynamics/contact/mean_motion.h"
#include "dynamics/contact_views.h"
#include "dynamics/joint/wide_joints.h"
#include "dynamics/solver/direct.h"
#include "dynamics/solver/wide_contacts.h"

namespace carom::dynamics {
namespace {

constexpr std::size_t kFew = 4;  // of so many that are reserved, one is in use

/// Whether the last step had few contacts beside what is reserved, and no joints: those know who is where in
/// lanes.
bool has_spare_capacity(const World& world) {
  const Contacts& c = *world.contacts;
  if (world.plan->runs[static_cast<std::size_t>(Stage::group)] && !c.links.empty()) return false;
  const std::size_t rows = world.plan->runs[static_cast<std::size_t>(Stage::group)] ? c.rows.size() : 0;
  return c.rows.capacity() > kFew * rows + kRowsKept;
}

}  // namespace

void give_back(const World& world, Impulses& impulses, PairTable& pairs, Owned<MeanMotion>& means) {
  Contacts& c = *world.contacts;
  c.steps_with_spare = has_spare_capacity(world) ? c.steps_with_spare + 1 : 0;
  if (c.steps_with_spare < kStepsBeforeGivingBack) return;
  for (const std::uint32_t body : c.bodies) world.plan->touched[body] = 0;
  *world.contacts = Contacts(world.memory);
  *world.direct = DirectGroups(world.memory);
  *world.wide = WideContacts(world.memory);
  world.wide_joints->is_packed = false;  // its lanes name bodies of those
  means.reset();
  impulses.old.shrink_to_fit();
  world.views->give_back();
  pairs.give_back();
  world.plan->pairs = Array<Pair>(world.memory);
}

}  // namespace carom::dynamics
