// What two colliders are to each other where they touch.
#include <algorithm>
#include <cmath>
#include <utility>

#include "dynamics/contact/contact.h"

namespace carom::dynamics {

namespace {

const Material& in_slot(const Scene& scene, std::uint32_t slot) {
  static constexpr Material kDefault;
  return slot == Colliders::kNoMaterial ? kDefault : scene.material[slot];
}

}  // namespace

const Material& material_of(const Scene& scene, std::uint32_t collider) {
  return in_slot(scene, scene.colliders.material[collider]);
}

MixedMaterial mixed_materials(const Scene& scene, std::uint32_t slot_a, std::uint32_t slot_b) {
  const auto [first, second] = std::minmax(slot_a, slot_b);
  const auto said = std::lower_bound(
      scene.material_pairs.begin(), scene.material_pairs.end(), std::pair(first, second),
      [](const MaterialPair& p, std::pair<std::uint32_t, std::uint32_t> key) { return std::pair(p.a, p.b) < key; });
  if (said != scene.material_pairs.end() && said->a == first && said->b == second)
    return {said->friction, said->restitution, said->rolling, said->spinning};
  const Material &a = in_slot(scene, slot_a), &b = in_slot(scene, slot_b);
  MixedMaterial m{mix(a.friction_mix, a.friction, b.friction_mix, b.friction),
                  mix(a.restitution_mix, a.restitution, b.restitution_mix, b.restitution), 0, 0};
  if (!scene.resists) return m;
  m.rolling = mix(a.friction_mix, a.rolling, b.friction_mix, b.rolling);
  m.spinning = mix(a.friction_mix, a.spinning, b.friction_mix, b.spinning);
  return m;
}

MixedMaterial mixed(const Scene& scene, std::uint32_t collider_a, std::uint32_t collider_b) {
  MixedMaterial m = mixed_materials(scene, scene.colliders.material[collider_a], scene.colliders.material[collider_b]);
  const EffectModes& modes = scene.modes;
  if (!modes.forbidden_anywhere) return m;
  const auto drop = [&](EffectId effect, Real& value) {
    const auto forbids = [&](std::uint32_t c) { return modes.forbids(+effect, scene.colliders.body[c]); };
    if (value > 0 && (forbids(collider_a) || forbids(collider_b))) value = 0;
  };
  drop(EffectId::friction, m.friction), drop(EffectId::restitution, m.restitution);
  drop(EffectId::rolling_resistance, m.rolling), drop(EffectId::spinning_resistance, m.spinning);
  return m;
}

Real mix(Mix rule_a, Real a, Mix rule_b, Real b) {
  switch (std::max(rule_a, rule_b)) {
    case Mix::maximum:
      return std::max(a, b);
    case Mix::minimum:
      return std::min(a, b);
    case Mix::average:
      return (a + b) / 2;
    case Mix::multiply:
      return a * b;
    default:
      return std::sqrt(a * b);
  }
}

}  // namespace carom::dynamics
