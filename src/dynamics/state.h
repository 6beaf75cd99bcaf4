// What a step changes. Structure of arrays, indexed by body slot.
#pragma once

#include "core/memory.h"
#include "core/pose.h"

namespace carom::dynamics {

struct State {
  explicit State(Memory* m)
      : x(m),
        q(m),
        held_q(m),
        placed_x(m),
        placed_q(m),
        v(m),
        omega(m),
        momentum(m),
        force(m),
        torque(m),
        quarantined(m),
        asleep(m),
        loaded_steps(m),
        tired_steps(m),
        written(m),
        is_written(m) {}

  Array<Vec3> x;         // m, world: centre of mass (NOT the origin of the body frame)
  Array<Quat> q;         // body axes -> world
  Array<Quat> held_q;    // a recent q, by which solvers in lanes turn the arms of contacts, @see Dial::hold_angle
  Array<Vec3> placed_x;  // m, and the pose as which its colliders were last placed: their frames follow from it
  Array<Quat> placed_q;
  Array<Vec3> v;         // m/s, world, of the centre of mass
  Array<Vec3> omega;     // rad/s, world
  Array<Vec3> momentum;  // kg m^2/s, world, about the centre: what omega was last made from, where a rotation
                         // method keeps it (integrate/rotation/top.h); it counts only while omega agrees
  Array<Vec3> force;     // N, world, from the host, for the next step only
  Array<Vec3> torque;    // N m, world, about the centre of mass, likewise
  Array<std::uint8_t> quarantined;  // 1: state was not finite; held still, makes no contacts

  Array<std::uint8_t> asleep;  // 1: its island rests and takes no part in steps; empty until a step with the dial on

  // What a solver that chooses remembers: for how long a body has borne too much, and for how long its group is not
  // to be given to the direct solver, for which it was too much.
  Array<std::uint8_t> loaded_steps, tired_steps;

  std::uint64_t quarantined_count = 0;

  bool sleeps(std::uint32_t body) const { return body < asleep.size() && asleep[body]; }

  /// Bodies that a host wrote to since the last step, each once, in any order until a step begins: it checks them, and
  /// looks among them for pending forces. What nobody wrote it need not read.
  Array<std::uint32_t> written;
  Array<std::uint8_t> is_written;

  /// To be called by whoever writes to these arrays between steps (World's editing functions do). There is room.
  void mark_written(std::uint32_t body) {
    if (is_written[body]) return;
    is_written[body] = 1;
    written.push_back(body);
  }
};

}  // namespace carom::dynamics
