// What pushes the bodies of a stage beyond gravity: springs, air, water, fields (carom/force.h).
#include <algorithm>

#include "scenes/scene.h"

namespace carom::tools {

void Stage::add_spring(Bungee bungee) {
  const auto body = [&](std::size_t actor) {
    return actor == Bungee::kWorld ? carom_body(CAROM_NULL_HANDLE) : actors.at(actor).body;
  };
  carom_spring_desc desc;
  Call call;
  call.done(carom_spring_desc_init(&desc, sizeof desc), "making a spring");
  desc.body_a = body(bungee.a), desc.body_b = body(bungee.b);
  std::copy(bungee.at_a.data(), bungee.at_a.data() + 3, desc.anchor_a);
  std::copy(bungee.at_b.data(), bungee.at_b.data() + 3, desc.anchor_b);
  desc.rest = bungee.rest, desc.stiffness = bungee.stiffness, desc.damping = bungee.damping;
  desc.only_pulls = bungee.only_pulls;
  call.done(carom_spring_create(world.get(), &desc, &bungee.spring, call), "making a spring");
  bungees.push_back(bungee);
}

void Stage::set_drag(std::size_t actor, double linear, double quadratic) {
  Call call;
  call.done(carom_body_set_drag(world.get(), actors.at(actor).body, linear, quadratic, call),
            "the drag of '" + actors[actor].name + "'");
}

void Stage::set_wind(const Vec& velocity) {
  Call call;
  call.done(carom_world_set_wind(world.get(), velocity.data(), call), "setting the wind");
}

void Stage::set_water(const carom_water& water) {
  Call call;
  call.done(carom_world_set_water(world.get(), &water, call), "filling in water");
  if (water.normal[1] == 1) water_level = water.level;
}

void Stage::add_field(const carom_force_field_desc& desc) {
  carom_force_field handle = CAROM_NULL_HANDLE;
  Call call;
  call.done(carom_force_field_create(world.get(), &desc, &handle, call), "making a force field");
  fields.push_back(handle);
}

void Stage::set_field_mask(std::size_t actor, std::uint32_t mask) {
  Call call;
  call.done(carom_body_set_force_field_mask(world.get(), actors.at(actor).body, mask, call),
            "which fields '" + actors[actor].name + "' feels");
}

void Stage::set_gravity_factor(std::size_t actor, double factor) {
  Call call;
  call.done(carom_body_set_gravity_factor(world.get(), actors.at(actor).body, factor, call),
            "the gravity factor of '" + actors[actor].name + "'");
}

}  // namespace carom::tools
