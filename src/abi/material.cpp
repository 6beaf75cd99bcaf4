// Materials: surfaces that colliders wear.
#include <carom/body.h>

#include <algorithm>

#include "abi/record_calls.h"
#include "abi/world.h"
#include "dynamics/contact/contact.h"

namespace carom::abi {
namespace {

static_assert(static_cast<std::uint32_t>(Mix::geometric_mean) == CAROM_MIX_GEOMETRIC_MEAN &&
              static_cast<std::uint32_t>(Mix::maximum) == CAROM_MIX_MAXIMUM &&
              static_cast<std::uint32_t>(Mix::minimum) == CAROM_MIX_MINIMUM &&
              static_cast<std::uint32_t>(Mix::average) == CAROM_MIX_AVERAGE &&
              static_cast<std::uint32_t>(Mix::multiply) == CAROM_MIX_MULTIPLY &&
              static_cast<std::uint32_t>(Mix::count) == CAROM_MIX_MULTIPLY + 1);

constexpr std::uint32_t kMixes = static_cast<std::uint32_t>(Mix::count);
constexpr double kLargestFriction = 1e3, kLargestResistance = 1e3;  // 1, m

/// @param argument  where desc stands in the C signature
bool read_material(Call& call, int argument, const carom_material_desc* given, Material& material) {
  carom_material_desc d;
  carom_material_desc_init(&d, sizeof d);
  if (!read_struct(call, argument, "desc", given, d) || !only_bits(call, argument, "desc->reserved", d.reserved, 0) ||
      !known(call, argument, "desc->friction_mix", d.friction_mix, kMixes) ||
      !known(call, argument, "desc->restitution_mix", d.restitution_mix, kMixes) ||
      !in_range(call, argument, "desc->friction", d.friction, 0, kLargestFriction) ||
      !in_range(call, argument, "desc->restitution", d.restitution, 0, 1))
    return false;
  material.friction = d.friction;
  material.restitution = d.restitution;
  material.friction_mix = static_cast<Mix>(d.friction_mix);
  material.restitution_mix = static_cast<Mix>(d.restitution_mix);
  return true;
}

bool worn(const Scene& scene, std::uint32_t material) {
  const Colliders& c = scene.colliders;
  return std::any_of(c.live.begin(), c.live.end(), [&](std::uint32_t slot) { return c.material[slot] == material; });
}

}  // namespace
}  // namespace carom::abi

using namespace carom;
using namespace carom::abi;

extern "C" {

int32_t carom_material_desc_init(carom_material_desc* desc, uint32_t struct_size) {
  return init_struct(desc, struct_size, [](carom_material_desc& d) {
    d.friction_mix = CAROM_MIX_GEOMETRIC_MEAN;
    d.restitution_mix = CAROM_MIX_MAXIMUM;
    d.friction = 0.5;
  });
}

int32_t carom_material_create(carom_world* world, const carom_material_desc* desc, carom_material* material,
                              carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::material_create(desc));
    Material m;
    if (!changing || !read_material(call, 2, desc, m) || !present(call, 3, "material", material)) return;
    const Handle handle = changing->add_material(m);
    if (handle)
      *material = handle;
    else
      call.fail(CAROM_E_LIMIT, 0, "this world has issued all %u materials", kMaxSlots);
  });
}

int32_t carom_material_update(carom_world* world, carom_material material, const carom_material_desc* desc,
                              carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::material_update(material, desc));
    Material m;
    if (changing && resolve(call, 2, "material", changing->scene.material_slots, material) &&
        read_material(call, 3, desc, m)) {
      const Material& old = changing->scene.material[handle_slot(material)];
      m.rolling = old.rolling, m.spinning = old.spinning;
      changing->set_material(handle_slot(material), m);
    }
  });
}

int32_t carom_material_set_resistance(carom_world* world, carom_material material, double rolling, double spinning,
                                      carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::material_set_resistance(material, rolling, spinning));
    if (!changing || !resolve(call, 2, "material", changing->scene.material_slots, material) ||
        !in_range(call, 3, "rolling", rolling, 0, kLargestResistance) ||
        !in_range(call, 4, "spinning", spinning, 0, kLargestResistance))
      return;
    Material m = changing->scene.material[handle_slot(material)];
    m.rolling = rolling, m.spinning = spinning;
    changing->set_material(handle_slot(material), m);
  });
}

int32_t carom_material_get_resistance(carom_world* world, carom_material material, double* rolling, double* spinning,
                                      carom_error* error) {
  return glanced(error, [&](Call& call) {
    const Reading reading(call, world);
    if (!reading || !resolve(call, 2, "material", reading->scene.material_slots, material) ||
        !present(call, 3, "rolling", rolling) || !present(call, 4, "spinning", spinning))
      return;
    const Material& m = reading->scene.material[handle_slot(material)];
    *rolling = m.rolling, *spinning = m.spinning;
  });
}

int32_t carom_material_set_pair(carom_world* world, carom_material material_a, carom_material material_b,
                                const double surface[4], carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::material_set_pair(material_a, material_b, surface));
    if (!changing || !resolve(call, 2, "material_a", changing->scene.material_slots, material_a) ||
        !resolve(call, 3, "material_b", changing->scene.material_slots, material_b))
      return;
    const auto [a, b] = std::minmax({handle_slot(material_a), handle_slot(material_b)});
    if (!surface) return changing->remove_material_pair(a, b);
    if (!in_range(call, 4, "surface[0]", surface[0], 0, kLargestFriction) ||
        !in_range(call, 4, "surface[1]", surface[1], 0, 1) ||
        !in_range(call, 4, "surface[2]", surface[2], 0, kLargestResistance) ||
        !in_range(call, 4, "surface[3]", surface[3], 0, kLargestResistance))
      return;
    changing->set_material_pair({a, b, surface[0], surface[1], surface[2], surface[3]});
  });
}

int32_t carom_material_get_pair(carom_world* world, carom_material material_a, carom_material material_b,
                                double surface[4], carom_error* error) {
  return glanced(error, [&](Call& call) {
    const Reading reading(call, world);
    if (!reading || !resolve(call, 2, "material_a", reading->scene.material_slots, material_a) ||
        !resolve(call, 3, "material_b", reading->scene.material_slots, material_b) ||
        !present(call, 4, "surface", surface))
      return;
    const MixedMaterial m = mixed_materials(reading->scene, handle_slot(material_a), handle_slot(material_b));
    surface[0] = m.friction, surface[1] = m.restitution, surface[2] = m.rolling, surface[3] = m.spinning;
  });
}

int32_t carom_material_destroy(carom_world* world, carom_material material, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::material_destroy(material));
    if (!changing || !resolve(call, 2, "material", changing->scene.material_slots, material)) return;
    if (worn(changing->scene, handle_slot(material)))
      call.fail(CAROM_E_IN_USE, 2, "a collider wears this material");
    else
      changing->remove_material(handle_slot(material));
  });
}

}  // extern "C"
