// The calls of carom/vehicle.h: what they take and check. drive.h drives.
#include "kit/drive.h"

#include <iterator>
#include <type_traits>

namespace carom::kit {
namespace {

constexpr double kHalfTurn = 3.1415926535897932;

carom_vehicle_desc usual_vehicle_desc() {
  carom_vehicle_desc d{};
  d.struct_size = sizeof d;
  d.flags = CAROM_VEHICLE_AUTOMATIC | CAROM_VEHICLE_ACKERMANN;
  d.up[1] = 1, d.forward[2] = 1;
  d.category = d.mask = ~std::uint64_t(0);
  d.torque_count = 4, d.gear_count = 5;
  constexpr double kSpeeds[] = {100, 300, 500, 680}, kTorques[] = {120, 200, 210, 160},
                   kGears[] = {3.5, 2.1, 1.4, 1.05, 0.85};
  std::copy(std::begin(kSpeeds), std::end(kSpeeds), d.torque_speeds);
  std::copy(std::begin(kTorques), std::end(kTorques), d.torques);
  std::copy(std::begin(kGears), std::end(kGears), d.gears);
  d.idle_speed = 90, d.max_speed = 680, d.engine_inertia = 0.25, d.engine_drag = 25;
  d.reverse = 3.3, d.final_drive = 3.7;
  d.clutch_torque = 600;
  d.shift_up = 600, d.shift_down = 220, d.shift_time = 0.2;
  return d;
}

carom_wheel_desc usual_wheel_desc() {
  carom_wheel_desc d{};
  d.struct_size = sizeof d;
  d.anti_roll_partner = CAROM_NO_WHEEL;
  d.radius = 0.33, d.inertia = 1;
  d.travel = 0.25, d.stiffness = 30000, d.damping_bump = 2500, d.damping_rebound = 3500;
  d.brake = 2000, d.rolling = 0.012;
  d.grip = d.side_grip = 1;
  d.peak_slip = 0.1, d.side_peak_slip = 0.12;
  d.slide = 0.8, d.slide_slip = 4;
  d.relaxation = 0.3;
  return d;
}

carom_vehicle_input usual_input() {
  carom_vehicle_input input{};
  input.struct_size = sizeof input;
  input.gear = 1;
  return input;
}

carom_vehicle usual_vehicle() {
  carom_vehicle v{};
  v.struct_size = sizeof v;
  v.engine_speed = 90;
  return v;
}

carom_wheel usual_wheel() {
  carom_wheel w{};
  w.struct_size = sizeof w;
  w.normal[1] = 1;
  return w;
}

/// A gear that the vehicle has.
bool has_gear(Call& call, int argument, const char* name, const carom_vehicle_desc& d, std::int32_t gear) {
  const auto most = static_cast<std::int32_t>(d.gear_count);
  return (gear >= -1 && gear <= most) ||
         call.fail(CAROM_E_OUT_OF_RANGE, argument, "%s is %d, outside [-1, %d]", name, gear, most);
}

bool counted(Call& call, const char* name, std::uint32_t count) {
  return (count >= 1 && count <= 8) || call.fail(CAROM_E_OUT_OF_RANGE, 2, "%s is %u, outside [1, 8]", name, count);
}

bool read_vehicle_desc(Call& call, const carom_vehicle_desc* given, carom_vehicle_desc& d) {
  d = usual_vehicle_desc();
  if (!read_struct(call, 2, "desc", given, d) ||
      !only_bits(call, 2, "desc->flags", d.flags, CAROM_VEHICLE_AUTOMATIC | CAROM_VEHICLE_ACKERMANN) ||
      !unit(call, 2, "desc->up", d.up, 3) || !unit(call, 2, "desc->forward", d.forward, 3) ||
      !counted(call, "desc->torque_count", d.torque_count) || !counted(call, "desc->gear_count", d.gear_count) ||
      !within(call, 2, "desc->torque_speeds", d.torque_speeds, static_cast<int>(d.torque_count), 0, 1e5) ||
      !within(call, 2, "desc->torques", d.torques, static_cast<int>(d.torque_count), 0, 1e7) ||
      !within(call, 2, "desc->idle_speed", d.idle_speed, 1, 1e5) ||
      !within(call, 2, "desc->max_speed", d.max_speed, d.idle_speed, 1e5) ||
      !within(call, 2, "desc->engine_inertia", d.engine_inertia, 1e-3, 1e6) ||
      !within(call, 2, "desc->engine_drag", d.engine_drag, 0, 1e7) ||
      !within(call, 2, "desc->gears", d.gears, static_cast<int>(d.gear_count), 1e-3, 1e3) ||
      !within(call, 2, "desc->reverse", d.reverse, 1e-3, 1e3) ||
      !within(call, 2, "desc->final_drive", d.final_drive, 1e-3, 1e3) ||
      !within(call, 2, "desc->clutch_torque", d.clutch_torque, 0, 1e7) ||
      !within(call, 2, "desc->shift_up", d.shift_up, 0, 1e5) ||
      !within(call, 2, "desc->shift_down", d.shift_down, 0, 1e5) ||
      !within(call, 2, "desc->shift_time", d.shift_time, 0, 10) ||
      !within(call, 2, "desc->limited_slip", d.limited_slip, 0, 1e7))
    return false;
  for (std::uint32_t i = 1; i < d.torque_count; ++i)
    if (!(d.torque_speeds[i] > d.torque_speeds[i - 1]))
      return call.fail(CAROM_E_OUT_OF_RANGE, 2, "desc->torque_speeds[%u] is %g, not above the one before", i,
                       d.torque_speeds[i]);
  const double along = Vec3::from(d.up).dot(Vec3::from(d.forward));
  return std::fabs(along) <= 1e-6 ||
         call.fail(CAROM_E_OUT_OF_RANGE, 2, "desc->forward is not at right angles to desc->up: their product is %g",
                   along);
}

bool read_wheel_desc(Call& call, const carom_wheel_desc* given, std::uint64_t n, carom_wheel_desc& d) {
  d = usual_wheel_desc();
  if (!read_struct(call, 3, "wheel_descs", given, d)) return false;
  if (d.anti_roll_partner != CAROM_NO_WHEEL && d.anti_roll_partner >= n)
    return call.fail(CAROM_E_OUT_OF_RANGE, 3, "wheel_descs has anti_roll_partner %u of %llu wheels",
                     d.anti_roll_partner, static_cast<unsigned long long>(n));
  const auto in = [&](const char* name, double x, double low, double high) {
    return within(call, 3, name, x, low, high);
  };
  return within(call, 3, "wheel_descs->position", d.position, 3, -1e6, 1e6) &&
         in("wheel_descs->radius", d.radius, 1e-3, 1e3) && in("wheel_descs->inertia", d.inertia, 1e-9, 1e6) &&
         in("wheel_descs->travel", d.travel, 1e-3, 1e3) && in("wheel_descs->stiffness", d.stiffness, 0, 1e9) &&
         in("wheel_descs->damping_bump", d.damping_bump, 0, 1e8) &&
         in("wheel_descs->damping_rebound", d.damping_rebound, 0, 1e8) &&
         in("wheel_descs->anti_roll", d.anti_roll, 0, 1e9) && in("wheel_descs->max_steer", d.max_steer, -1.5, 1.5) &&
         in("wheel_descs->drive", d.drive, 0, 1e3) && in("wheel_descs->brake", d.brake, 0, 1e7) &&
         in("wheel_descs->handbrake", d.handbrake, 0, 1e7) && in("wheel_descs->rolling", d.rolling, 0, 1) &&
         in("wheel_descs->grip", d.grip, 0, 10) && in("wheel_descs->side_grip", d.side_grip, 0, 10) &&
         in("wheel_descs->peak_slip", d.peak_slip, 1e-3, 1) &&
         in("wheel_descs->side_peak_slip", d.side_peak_slip, 1e-3, 1) && in("wheel_descs->slide", d.slide, 0, 1) &&
         in("wheel_descs->slide_slip", d.slide_slip, 1.01, 100) &&
         in("wheel_descs->relaxation", d.relaxation, 0.01, 10);
}

bool read_input(Call& call, const carom_vehicle_input* given, const carom_vehicle_desc& desc,
                carom_vehicle_input& input) {
  input = usual_input();
  return read_struct(call, 5, "input", given, input) && has_gear(call, 5, "input->gear", desc, input.gear) &&
         within(call, 5, "input->throttle", input.throttle, 0, 1) &&
         within(call, 5, "input->brake", input.brake, 0, 1) &&
         within(call, 5, "input->handbrake", input.handbrake, 0, 1) &&
         within(call, 5, "input->steer", input.steer, -1, 1);
}

bool read_vehicle(Call& call, const carom_vehicle* given, const carom_vehicle_desc& desc, carom_vehicle& v) {
  v = usual_vehicle();
  return read_struct(call, 6, "vehicle", given, v) && has_gear(call, 6, "vehicle->gear", desc, v.gear) &&
         within(call, 6, "vehicle->engine_speed", v.engine_speed, 0, 1e6) &&
         within(call, 6, "vehicle->shifting", v.shifting, 0, 10) &&
         within(call, 6, "vehicle->since_shift", v.since_shift, 0, 1e3);
}

bool read_wheel(Call& call, const carom_wheel* given, carom_wheel& w) {
  w = usual_wheel();
  return read_struct(call, 7, "wheels", given, w) && within(call, 7, "wheels->spin", w.spin, -1e5, 1e5) &&
         within(call, 7, "wheels->angle", w.angle, -kHalfTurn, kHalfTurn) &&
         within(call, 7, "wheels->slip", w.slip, -1e3, 1e3) &&
         within(call, 7, "wheels->side_slip", w.side_slip, -1e3, 1e3);
}

/// The i-th of structs that stand one after another.
template <class T>
T* at(T* first, std::uint64_t i) {
  using Byte = std::conditional_t<std::is_const_v<T>, const char, char>;
  return reinterpret_cast<T*>(reinterpret_cast<Byte*>(first) + i * first->struct_size);
}

template <class T>
bool same_size(Call& call, int argument, const char* name, const T* first, std::uint64_t i) {
  return at(first, i)->struct_size == first->struct_size ||
         call.fail(CAROM_E_STRUCT_SIZE, argument, "%s[%llu] has another struct_size than the first", name,
                   static_cast<unsigned long long>(i));
}

bool read_wheels(Call& call, const carom_wheel_desc* descs, std::uint64_t n, const carom_wheel* wheels,
                 Driven& driven) {
  if (n < 1 || n > CAROM_VEHICLE_WHEELS)
    return call.fail(CAROM_E_OUT_OF_RANGE, 4, "n is %llu, outside [1, %u]", static_cast<unsigned long long>(n),
                     CAROM_VEHICLE_WHEELS);
  if (!present(call, 3, "wheel_descs", descs) || !present(call, 7, "wheels", wheels)) return false;
  driven.n = static_cast<std::uint32_t>(n);
  for (std::uint32_t i = 0; i < driven.n; ++i)
    if (!same_size(call, 3, "wheel_descs", descs, i) || !same_size(call, 7, "wheels", wheels, i) ||
        !read_wheel_desc(call, at(descs, i), n, driven.wheel_descs[i]) ||
        !read_wheel(call, at(wheels, i), driven.wheels[i]))
      return false;
  return true;
}

}  // namespace
}  // namespace carom::kit

using namespace carom::kit;

extern "C" {

int32_t carom_vehicle_desc_init(carom_vehicle_desc* desc, uint32_t struct_size) {
  return init_struct(desc, struct_size, usual_vehicle_desc());
}
int32_t carom_wheel_desc_init(carom_wheel_desc* desc, uint32_t struct_size) {
  return init_struct(desc, struct_size, usual_wheel_desc());
}
int32_t carom_vehicle_input_init(carom_vehicle_input* input, uint32_t struct_size) {
  return init_struct(input, struct_size, usual_input());
}
int32_t carom_vehicle_init(carom_vehicle* vehicle, uint32_t struct_size) {
  return init_struct(vehicle, struct_size, usual_vehicle());
}
int32_t carom_wheel_init(carom_wheel* wheel, uint32_t struct_size) {
  return init_struct(wheel, struct_size, usual_wheel());
}

int32_t carom_vehicle_drive(carom_world* world, const carom_vehicle_desc* desc, const carom_wheel_desc* wheel_descs,
                            uint64_t n, const carom_vehicle_input* input, carom_vehicle* vehicle, carom_wheel* wheels,
                            double dt, carom_error* error) {
  return run_call(error, [&](Call& call) {
    Driven driven;
    if (!present(call, 1, "world", world) || !read_vehicle_desc(call, desc, driven.desc) ||
        !read_wheels(call, wheel_descs, n, wheels, driven) || !read_input(call, input, driven.desc, driven.input) ||
        !read_vehicle(call, vehicle, driven.desc, driven.vehicle) || !within(call, 8, "dt", dt, 1e-4, 0.1) ||
        !drive(call, world, driven, dt))
      return;
    write_struct(driven.vehicle, vehicle);
    for (std::uint64_t i = 0; i < n; ++i) write_struct(driven.wheels[i], at(wheels, i));
  });
}

}  // extern "C"
