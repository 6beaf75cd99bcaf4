// What a step changes. Structure of arrays, indexed by body slot.
#pragma once

#include "core/memory.h"
#include "core/pose.h"

namespace carom {

struct State {
  explicit State(Memory* m) : x(m), q(m), v(m), omega(m), momentum(m), force(m), torque(m), quarantined(m) {}

  Array<Vec3> x;         // m, world: centre of mass (NOT the origin of the body frame)
  Array<Quat> q;         // body axes -> world
  Array<Vec3> v;         // m/s, world, of the centre of mass
  Array<Vec3> omega;     // rad/s, world
  Array<Vec3> momentum;  // kg m^2/s, world, about the centre: what omega was last made from, where a rotation
                         // method keeps it (integrate/rotation/top.h); it counts only while omega agrees
  Array<Vec3> force;     // N, world, from the host, for the next step only
  Array<Vec3> torque;    // N m, world, about the centre of mass, likewise
  Array<std::uint8_t> quarantined;  // 1: state was not finite; held still, makes no contacts

  std::uint64_t quarantined_count = 0;

  /// Raised by whoever writes to these arrays between steps (World's editing functions do): the next step then checks
  /// every body and looks for pending forces; otherwise it need not read what nobody wrote.
  bool written = true;
};

}  // namespace carom
