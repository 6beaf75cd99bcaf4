// What two colliders are to each other where they touch.
#include <algorithm>
#include <cmath>

#include "dynamics/contact/contact.h"

namespace carom::dynamics {

const Material& material_of(const Scene& scene, std::uint32_t collider) {
  static constexpr Material kDefault;
  const std::uint32_t slot = scene.colliders.material[collider];
  return slot == Colliders::kNoMaterial ? kDefault : scene.material[slot];
}

MixedMaterial mixed(const Scene& scene, std::uint32_t collider_a, std::uint32_t collider_b) {
  const Material &a = material_of(scene, collider_a), &b = material_of(scene, collider_b);
  const EffectModes& modes = scene.modes;
  const auto allowed = [&](std::size_t row, Real value) {
    const auto forbids = [&](std::uint32_t c) { return modes.forbids(row, scene.colliders.body[c]); };
    return value > 0 && modes.forbidden_anywhere && (forbids(collider_a) || forbids(collider_b)) ? Real(0) : value;
  };
  MixedMaterial m{
      allowed(+EffectId::friction, mix(a.friction_mix, a.friction, b.friction_mix, b.friction)),
      allowed(+EffectId::restitution, mix(a.restitution_mix, a.restitution, b.restitution_mix, b.restitution)), 0, 0};
  if (!scene.resists) return m;
  m.rolling = allowed(+EffectId::rolling_resistance, mix(a.friction_mix, a.rolling, b.friction_mix, b.rolling));
  m.spinning = allowed(+EffectId::spinning_resistance, mix(a.friction_mix, a.spinning, b.friction_mix, b.spinning));
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
