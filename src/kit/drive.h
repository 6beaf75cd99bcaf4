// One drive of a vehicle: what its wheels stand on, then its motion through dt in small parts, then the mean forces.
#pragma once

#include <carom/vehicle.h>

#include "core/pose.h"
#include "kit/check.h"
#include "kit/tyre.h"

namespace carom::kit {

/// A vehicle as it was read, its copies of states in and out.
struct Driven {
  carom_vehicle_desc desc;
  carom_vehicle_input input;
  carom_vehicle vehicle;
  carom_wheel_desc wheel_descs[CAROM_VEHICLE_WHEELS];
  carom_wheel wheels[CAROM_VEHICLE_WHEELS];
  std::uint32_t n = 0;
};

/// Checks what needs the world, computes, and writes all forces in one call at the end.
bool drive(Call& call, carom_world* world, Driven& driven, Real dt);

}  // namespace carom::kit
