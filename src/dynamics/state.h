// What a step changes, in parts. Structure of arrays, indexed by body slot.
#pragma once

#include "core/memory.h"
#include "core/pool.h"
#include "core/pose.h"

namespace carom::dynamics {

/// Where bodies are.
struct Poses {
  explicit Poses(Memory* m) : x(m), q(m) {}
  Array<Vec3> x;  // m, world: centre of mass (NOT the origin of the body frame)
  Array<Quat> q;  // body axes -> world
};

/// The poses as which colliders were last placed: their frames follow from them.
struct PlacedPoses {
  explicit PlacedPoses(Memory* m) : placed_x(m), placed_q(m) {}
  Array<Vec3> placed_x;  // m
  Array<Quat> placed_q;
};

struct Velocities {
  explicit Velocities(Memory* m) : v(m), omega(m), momentum(m) {}
  Array<Vec3> v;         // m/s, world, of the centre of mass
  Array<Vec3> omega;     // rad/s, world
  Array<Vec3> momentum;  // kg m^2/s, world, about the centre: what omega was last made from, where a rotation
                         // method keeps it (integrate/rotation/top.h); it counts only while omega agrees
};

/// What a host asks for the next step, and to whom it wrote.
struct HostForces {
  explicit HostForces(Memory* m) : force(m), torque(m), written(m), is_written(m) {}
  Array<Vec3> force;   // N, world
  Array<Vec3> torque;  // N m, world, about the centre of mass

  /// Bodies that a host wrote to since the last step, each once, in any order until a step begins: it checks them, and
  /// looks among them for pending forces. What no host wrote it need not read.
  Array<std::uint32_t> written;
  Array<std::uint8_t> is_written;

  /// To be called by whoever writes to a body between steps (World's editing functions do). There is capacity.
  void mark_written(std::uint32_t body) {
    if (is_written[body]) return;
    is_written[body] = 1;
    written.push_back(body);
  }
};

/// Who takes no part in steps, is held still and makes no contacts.
struct Quarantine {
  explicit Quarantine(Memory* m) : held_out(m) {}
  enum Why : std::uint8_t { kNotFinite = 1, kDisabled = 4 };  // its state left the finite world; a host says so
  Array<std::uint8_t> held_out;                               // bits
  std::uint64_t quarantined_count = 0;                        // of those that are not finite

  bool is_lost(std::uint32_t body) const { return held_out[body] & kNotFinite; }
  bool is_disabled(std::uint32_t body) const { return held_out[body] & kDisabled; }
};

struct SleepFlags {
  explicit SleepFlags(Memory* m) : asleep(m) {}
  Array<std::uint8_t> asleep;  // 1: its island rests and takes no part in steps; empty until a step with the dial on
  bool sleeps(std::uint32_t body) const { return body < asleep.size() && asleep[body]; }
};

/// What is remembered of a body where a host asks for an accuracy, @see accuracy/control.h
struct AccuracyMemory {
  std::uint8_t level = 0;     // of substeps
  std::uint8_t wait = 0;      // steps until the next estimate
  std::uint8_t met = 0;       // whom its island consisted of
  bool softly = false;        // contacts of it were springs
  bool stalled = false;       // more substeps did not lessen its error
  std::uint8_t order = 0;     // that it moves with by joints alone; 0: not chosen yet
  std::uint8_t patience = 0;  // estimates until another order is tried again
  float place = 0, turn = 0;  // errors over tolerances, of the last estimate
  bool operator==(const AccuracyMemory&) const = default;
};

/// How a body that a host moves went in the last step, @see integrate/driven.h
struct DrivenMemory {
  Handle body = 0;
  Real dt = 0;                                  // s
  Vec3 v = Vec3::zero(), omega = Vec3::zero();  // m/s, rad/s, world
  Vec3 a = Vec3::zero(), alpha = Vec3::zero();  // m/s^2, rad/s^2, from the step before
};

/// What steps remember of bodies.
struct SolverMemory {
  explicit SolverMemory(Memory* m) : held_q(m), loaded_steps(m), cooldown_steps(m), accuracy(m), driven(m) {}
  Array<Quat> held_q;  // a recent q, by which solvers in lanes turn the arms of contacts, @see Dial::hold_angle
  // Of a solver that chooses: for how long a body has borne too much, and for how long its group is not to be given to
  // the direct solver, for which it was too much.
  Array<std::uint8_t> loaded_steps, cooldown_steps;
  Array<AccuracyMemory> accuracy;
  Array<DrivenMemory> driven;  // of those that moved, ascending
};

/// All of it. A stage gets the parts that it writes, @see part.h
struct State : Poses, PlacedPoses, Velocities, HostForces, Quarantine, SleepFlags, SolverMemory {
  explicit State(Memory* m)
      : Poses(m), PlacedPoses(m), Velocities(m), HostForces(m), Quarantine(m), SleepFlags(m), SolverMemory(m) {}
};

}  // namespace carom::dynamics
