// What happened in the last step, for hosts that asked.
#include "dynamics/events/events.h"

#include <carom/events.h>

#include "abi/copy_out.h"
#include "abi/record_calls.h"
#include "abi/world.h"

namespace carom::abi {
namespace {

static_assert(ContactEvent::begin == CAROM_CONTACT_BEGIN && ContactEvent::end == CAROM_CONTACT_END &&
              ContactEvent::hit == CAROM_CONTACT_HIT);
static_assert(Events::contact == CAROM_EVENTS_CONTACT && Events::sensor == CAROM_EVENTS_SENSOR &&
              Events::sleeping == CAROM_EVENTS_SLEEP && Events::joint == CAROM_EVENTS_JOINT &&
              Events::fault == CAROM_EVENTS_FAULT);

constexpr double kFastestImpact = 1e9;  // m/s

carom_contact_event contact_event(const World&, const ContactEvent& e) {
  carom_contact_event out{};
  out.kind = e.kind;
  out.collider_a = e.collider_a, out.collider_b = e.collider_b;
  out.body_a = e.body_a, out.body_b = e.body_b;
  from_vec3(e.point, out.point);
  from_vec3(e.normal, out.normal);
  out.impulse = e.impulse;
  out.approach_speed = e.speed;
  return out;
}

carom_sensor_event sensor_event(const World&, const SensorEvent& e) {
  carom_sensor_event out{};
  out.kind = e.entered ? CAROM_SENSOR_ENTER : CAROM_SENSOR_LEAVE;
  out.sensor = e.sensor, out.other = e.other;
  out.sensor_body = e.sensor_body, out.other_body = e.other_body;
  return out;
}

carom_sleep_event sleep_event(const World&, const SleepEvent& e) {
  carom_sleep_event out{};
  out.kind = e.woke ? CAROM_SLEEP_AWAKE : CAROM_SLEEP_ASLEEP;
  out.body = e.body;
  return out;
}

carom_joint_event joint_event(const World&, const JointEvent& e) {
  carom_joint_event out{};
  out.joint = e.joint;
  out.body_a = e.body_a, out.body_b = e.body_b;
  from_vec3(e.force, out.force);
  from_vec3(e.torque, out.torque);
  out.step = e.step;
  return out;
}

carom_fault_event fault_event(const World&, const FaultEvent& e) {
  carom_fault_event out{};
  out.kind = e.support.kind != SupportFault::none ? static_cast<std::uint32_t>(e.support.kind)
             : e.particles                        ? CAROM_FAULT_PARTICLE_STATE
                                                  : CAROM_FAULT_BODY_STATE;
  out.shape = e.shape, out.body = e.body, out.particles = e.particles;
  out.particle = e.particle;
  for (int i = 0; i < 3; ++i) out.dir[i] = e.support.dir[i], out.out[i] = e.support.out[i];
  out.step = e.step;
  return out;
}

}  // namespace
}  // namespace carom::abi

using namespace carom;
using namespace carom::abi;

extern "C" {

int32_t carom_world_collect_events(carom_world* world, uint32_t kinds, double hit_speed, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::world_collect_events(kinds, hit_speed));
    if (changing && only_bits(call, 2, "kinds", kinds, Events::every) &&
        in_range(call, 3, "hit_speed", hit_speed, 0, kFastestImpact))
      collect(*changing, kinds, hit_speed);
  });
}

int32_t carom_world_get_contact_events(carom_world* world, carom_contact_event* dst, uint64_t stride, uint64_t capacity,
                                       uint64_t* count, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Reading reading(call, world);
    if (reading) copy_out(call, *reading, reading->events->contacts, contact_event, dst, stride, capacity, count);
  });
}

int32_t carom_world_get_sensor_events(carom_world* world, carom_sensor_event* dst, uint64_t stride, uint64_t capacity,
                                      uint64_t* count, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Reading reading(call, world);
    if (reading) copy_out(call, *reading, reading->events->sensors, sensor_event, dst, stride, capacity, count);
  });
}

int32_t carom_world_get_sleep_events(carom_world* world, carom_sleep_event* dst, uint64_t stride, uint64_t capacity,
                                     uint64_t* count, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Reading reading(call, world);
    if (reading) copy_out(call, *reading, reading->events->sleep, sleep_event, dst, stride, capacity, count);
  });
}

int32_t carom_world_get_joint_events(carom_world* world, carom_joint_event* dst, uint64_t stride, uint64_t capacity,
                                     uint64_t* count, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Reading reading(call, world);
    if (reading) copy_out(call, *reading, reading->events->joints, joint_event, dst, stride, capacity, count);
  });
}

int32_t carom_world_get_fault_events(carom_world* world, carom_fault_event* dst, uint64_t stride, uint64_t capacity,
                                     uint64_t* count, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Reading reading(call, world);
    if (reading) copy_out(call, *reading, reading->events->faults, fault_event, dst, stride, capacity, count);
  });
}

}  // extern "C"
