// What bodies, colliders and bulk calls share.
#pragma once

#include "abi/world.h"

namespace carom::abi {

/// A static body's velocity must be zero.
bool at_rest(Call& call, int argument, const char* name, const double v[3]);

/// A collider is about to be removed: drop what the last step reported of it (its slot may soon mean another collider,
/// its shape may be destroyed) and give back its shape.
void release_collider(carom_engine& engine, World& world, std::uint32_t collider);

}  // namespace carom::abi
