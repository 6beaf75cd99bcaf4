// Engine, clutch and gears: from a throttle and the speed of the driven wheels to a torque on them.
#pragma once

#include <carom/vehicle.h>

#include "core/vec.h"

namespace carom::kit {

/// N m, of the engine at full throttle: linear between the points of its curve.
Real full_torque(const carom_vehicle_desc& desc, Real speed);

/// The ratio of engine to wheels that is in: negative in reverse, 0 in neutral.
Real ratio_of(const carom_vehicle_desc& desc, std::int32_t gear);

/// Choose a gear for this drive. A change opens the clutch for desc.shift_time.
void choose_gear(const carom_vehicle_desc& desc, const carom_vehicle_input& input, carom_vehicle& vehicle, Real dt);

/// Move engine and clutch on by h.
/// @param wheel_speed  rad/s, mean of driven wheels by their shares   @param wheel_inertia  kg m^2, all driven wheels
/// @return             N m, on all driven wheels together
Real move_engine(const carom_vehicle_desc& desc, Real throttle, carom_vehicle& vehicle, Real wheel_speed,
                 Real wheel_inertia, Real h);

}  // namespace carom::kit
