// What floats can bear of bodies.
#include "dynamics/solver/float_range.h"

#include <algorithm>

#include "dynamics/body_state.h"

namespace carom::dynamics {
namespace {

constexpr Real kLightest = 1e-9, kHeaviest = 1e9;        // kg
constexpr Real kShortest = 1e-9, kLongestInFloat = 1e9;  // s
constexpr Real kLeastTurn = 1e-25;                       // 1/(kg m^2), of the axis that turns most easily

bool weighs_enough(const Scene& scene, std::uint32_t body) {
  const Real inv_mass = scene.inv_mass[body];
  if (!(inv_mass >= 1 / kHeaviest && inv_mass <= 1 / kLightest)) return false;
  if (!rotates(scene, body)) return true;
  const Real most = scene.inv_inertia[body].diagonal().max_entry();
  return most >= kLeastTurn && most <= 1 / kLeastTurn;
}

}  // namespace

bool bears_floats(const World& world, const WideContacts& wide, Real h) {
  const auto asked = Precision(world.scene.dials.choice(Dial::precision));
  if (asked == Precision::in_double) return false;
  if (asked == Precision::by_size && wide.manifolds.size() < kFloatsFrom) return false;
  if (!(h >= kShortest && h <= kLongestInFloat)) return false;
  for (std::size_t i = wide.first_moved; i < wide.slot.size(); ++i)
    if (!weighs_enough(world.scene, wide.slot[i])) return false;
  return std::ranges::all_of(world.contacts->surface, is_slow) &&
         std::ranges::all_of(world.contacts->driven, [](const Driven& d) { return is_slow(d.spin); });
}

void cap(BodyVelocity& velocity) {
  const auto within = [](double& x) {
    x = x > kFastestInFloat ? kFastestInFloat : x < -kFastestInFloat ? -kFastestInFloat : x == x ? x : 0;
  };
  for (int k = 0; k < 3; ++k) within(velocity.v[k]), within(velocity.omega[k]);
}

}  // namespace carom::dynamics
