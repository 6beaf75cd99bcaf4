// What happened in a step, as lists that a host reads after it: contacts that began, ended or were hit, sensors entered
// and left, bodies that fell asleep or woke, joints that broke, faults. Nothing is collected that no host asked for.
//
// A pair touches from the step in which its contacts first bear an impulse to the one in which it makes no contact
// points any more (farther apart than the contact distance): what rests does not flicker. Sleepers touch whom they
// touched. What a sensor overlaps is asked at the poses in which a step ends, of pairs whose bounds met as it began;
// what is swept enters and leaves in the step in which it passes a sensor. Sleepers stay within while they sleep. Lists are ordered by slots and do not depend on threads.
//
// @oracle tests/unit/dynamics/test_events
#pragma once

#include "dynamics/effects.h"

namespace carom::dynamics {

struct ContactEvent {
  enum Kind : std::uint32_t { begin, end, hit };
  Kind kind;
  Handle collider_a, collider_b, body_a, body_b;  // what is gone keeps its name
  Vec3 point = Vec3::zero();                      // m, world: where the largest impulse acted
  Vec3 normal = Vec3::zero();                     // unit, world, A to B
  Real impulse = 0;                               // N s, along the normals, of all points in the step
  Real speed = 0;                                 // m/s, at which the fastest point approached as the step began
};

struct SensorEvent {
  bool entered;  // else left
  Handle sensor, other, sensor_body, other_body;
};

struct SleepEvent {
  bool woke;  // else fell asleep
  Handle body;
};

/// A joint that bore more than it was made for, and holds nothing from now on.
struct JointEvent {
  Handle joint, body_a, body_b;  // 0: the world
  Vec3 force, torque;            // N, N m, world, on B: as JointState, mean over the step in which it broke
  std::uint64_t step;            // as StepReport::steps after it
};

/// As FaultView, by name.
struct FaultEvent {
  SupportFault support;  // kind none: of a state
  Handle shape, body, particles;
  std::uint64_t particle;
  std::uint64_t step;
};

/// A pair that touches or overlaps, by slots and by name: a slot may come to mean another collider.
struct Together {
  Pair pair;
  Handle a, b, body_a, body_b;
  bool a_senses;  // of a sensor's pair: A is it
};

struct Events {
  explicit Events(Memory* m)
      : contacts(m),
        sensors(m),
        sleep(m),
        joints(m),
        faults(m),
        touching(m),
        within(m),
        spare(m),
        approach(m),
        sensor_pairs(m),
        slept(m) {}

  enum Kinds : std::uint32_t { contact = 1, sensor = 2, sleeping = 4, joint = 8, fault = 16, every = 31 };
  std::uint32_t asked = 0;   // Kinds, by the host
  std::uint32_t wanted = 0;  // of them, those that are collected: all, or none where effect `events` is forbidden
  Real hit_speed = 1;        // m/s, above which an approach is a hit

  // of the last step
  Array<ContactEvent> contacts;  // by pair; of one: end, begin, hit
  Array<SensorEvent> sensors;    // by pair
  Array<SleepEvent> sleep;       // by body
  Array<JointEvent> joints;      // by joint
  Array<FaultEvent> faults;      // as they happened

  // from step to step, ascending by pair
  Array<Together> touching, within;
  // of a step
  Array<Together> spare;
  Array<Real> approach;       // m/s, by row
  Array<Pair> sensor_pairs;   // whose bounds meet, ascending
  Array<std::uint8_t> slept;  // by body slot, as of the last step

  void clear() {
    contacts.clear(), sensors.clear(), sleep.clear(), joints.clear(), faults.clear(), sensor_pairs.clear();
  }
};

/// Row of the table: colliders that are sensors.
namespace sensing {
void find(const Scene&, const State&, Participants&);
}

/// A host wants other kinds than before, from the next step on.
void collect(World& world, std::uint32_t kinds, Real hit_speed);

/// A joint breaks in this step, under what it now says that it bears.
void tell_broken(const World& world, Events& e, std::uint32_t joint);

/// Take the pairs with a sensor out of those that make contacts.
void set_sensors_aside(const World& world, Events& e, Array<Pair>& pairs);

/// Stage observe, before the first substep: reserve for all that may happen, and see how fast who approaches.
void begin_events(const World& world, Events& e, const StepTime& time);
/// Stage observe, at the end: what happened.
void end_events(const World& world, Events& e, const StepTime& time);

}  // namespace carom::dynamics
