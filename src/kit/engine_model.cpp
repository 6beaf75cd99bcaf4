// Engine, clutch and gears.
#include "kit/engine_model.h"

namespace carom::kit {
namespace {

constexpr Real kLimiter = 0.98;  // of max_speed: from here to it the torque goes to 0
constexpr Real kClutch = 100;    // N m s/rad: of a closed clutch per kg m^2 / ms; so stiff that it slips by 1 % at most
constexpr Real kTakesUp = 0.25;  // of idle_speed: from idle to so much above it an automatic clutch closes
constexpr Real kIdleGain = 5;    // N m s/rad: by which an engine keeps its idle speed
constexpr Real kFastestEngine = 1e6;  // rad/s: no engine turns faster, whatever its numbers say
constexpr Real kStaysInGear = 2;      // times shift_time: at least so long between two changes

}  // namespace

Real full_torque(const carom_vehicle_desc& d, Real speed) {
  const std::uint32_t n = d.torque_count;
  if (speed <= d.torque_speeds[0]) return d.torques[0];
  for (std::uint32_t i = 1; i < n; ++i)
    if (speed < d.torque_speeds[i]) {
      const Real t = (speed - d.torque_speeds[i - 1]) / (d.torque_speeds[i] - d.torque_speeds[i - 1]);
      return d.torques[i - 1] + t * (d.torques[i] - d.torques[i - 1]);
    }
  return d.torques[n - 1];
}

Real ratio_of(const carom_vehicle_desc& d, std::int32_t gear) {
  return gear == 0 ? 0 : d.final_drive * (gear < 0 ? -d.reverse : d.gears[gear - 1]);
}

void choose_gear(const carom_vehicle_desc& d, const carom_vehicle_input& input, carom_vehicle& v, Real dt) {
  v.shifting = larger(v.shifting - dt, 0.0);
  v.since_shift = v.shifting > 0 ? 0 : smaller(v.since_shift + dt, 1e3);
  std::int32_t wanted = input.gear;
  if (d.flags & CAROM_VEHICLE_AUTOMATIC && input.gear > 0) {
    wanted = v.gear > 0 ? v.gear : 1;
    if (v.gear > 0 && v.shifting == 0 && v.since_shift >= kStaysInGear * d.shift_time) {
      const auto last = static_cast<std::int32_t>(d.gear_count);
      // Not where the other gear would ask for the change back.
      if (v.engine_speed > d.shift_up && v.gear < last &&
          v.engine_speed * d.gears[v.gear] / d.gears[v.gear - 1] > d.shift_down)
        ++wanted;
      else if (v.engine_speed < d.shift_down && v.gear > 1 &&
               v.engine_speed * d.gears[v.gear - 2] / d.gears[v.gear - 1] < d.shift_up)
        --wanted;
    }
  }
  if (wanted == v.gear) return;
  v.shifting = v.gear == 0 || wanted == 0 ? 0 : d.shift_time;
  v.since_shift = 0;
  v.gear = wanted;
}

Real move_engine(const carom_vehicle_desc& d, Real throttle, carom_vehicle& v, Real wheel_speed, Real wheel_inertia,
                 Real h) {
  const Real limiter = larger(smaller((d.max_speed - v.engine_speed) / ((1 - kLimiter) * d.max_speed), 1.0), 0.0);
  Real torque = throttle * limiter * full_torque(d, v.engine_speed);
  torque -= (1 - throttle) * d.engine_drag;
  if (v.engine_speed >= d.max_speed) torque -= d.engine_drag;
  if (v.engine_speed < 1.05 * d.idle_speed) torque = larger(torque, kIdleGain * (d.idle_speed - v.engine_speed));
  const Real ratio = v.shifting > 0 ? 0 : ratio_of(d, v.gear);
  Real clutch = 0;
  if (ratio != 0 && wheel_inertia > 0) {
    const Real input = ratio * wheel_speed;  // rad/s, of the clutch's other side
    const Real closed = (larger(v.engine_speed, input) - d.idle_speed) / (kTakesUp * d.idle_speed);
    const Real most = d.clutch_torque * larger(smaller(closed, 1.0), 0.0);
    // Implicit: the two sides meet within the part, however stiff the clutch.
    const Real stiffness = kClutch * d.engine_inertia * 10;
    const Real both = 1 / d.engine_inertia + ratio * ratio / wheel_inertia;
    clutch = stiffness * (v.engine_speed - input + h * torque / d.engine_inertia) / (1 + h * stiffness * both);
    clutch = larger(smaller(clutch, most), -most);
  }
  v.engine_speed = smaller(larger(v.engine_speed + h * (torque - clutch) / d.engine_inertia, 0.0), kFastestEngine);
  return clutch * ratio;
}

}  // namespace carom::kit
