// What a host may say of a body's mass, checked alike wherever it says it.
#pragma once

#include "abi/check.h"
#include "dynamics/world.h"

namespace carom::abi {

inline constexpr double kLargestDamping = 1e6;  // 1/s

/// Symmetric and positive definite, or zero (does not rotate).   @param inertia  [9] kg m^2, row-major
bool check_inertia(Call& call, int argument, const char* name, const double inertia[9]);
/// Whether a body that is to be made may have an attribute.   @param names  of its numbers in the descriptor, argument 2
bool may_have(Call& call, const dynamics::World& world, BodyType type, dynamics::AttributeId id,
              const dynamics::AttributeValue& value, const char* const* names);
/// Without what rounding makes unlike.
Mat3 symmetric(const double inertia[9]);

}  // namespace carom::abi
