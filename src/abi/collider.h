// What bodies, colliders and bulk calls share.
#pragma once

#include "abi/world.h"

namespace carom::abi {

/// A static body's velocity must be zero.
bool at_rest(Call& call, int argument, const char* name, const double v[3]);

/// What a shape and its body must fulfil together.
/// @param has_mass  the host gave the body's   @param density  kg/m^3
bool shape_fits(Call& call, int argument, BodyType type, bool has_mass, const Shape& shape, double density);

/// Remove a collider, what the last step reported of it (its slot may soon mean another collider, its shape may be
/// destroyed), and its hold on the shape. Nothing has changed if it throws.
void remove_collider(carom_engine& engine, World& world, std::uint32_t collider);

}  // namespace carom::abi
