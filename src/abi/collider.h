// What bodies, colliders and bulk calls share.
#pragma once

#include "abi/world.h"

namespace carom::abi {

/// A static body's velocity must be zero.
bool at_rest(Call& call, int argument, const char* name, const double v[3]);

/// Give back the shapes of a body that is about to be removed.
void unuse_shapes_of(carom_engine& engine, const World& world, std::uint32_t body);

}  // namespace carom::abi
