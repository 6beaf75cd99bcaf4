// Forces at a trial: where a method of higher order may have bodies in one of its stages, not where they are.
//
// A force of the table of effects (dynamics/effects.h) is a function of poses and velocities. Methods that follow a
// motion by themselves ask for it there: islands that joints alone hold (joint/rattle/), what touches flat surfaces
// (contact/touching_motion.h). So both are moved by all forces alike, and none of them has a list of its own.
#pragma once

#include "dynamics/effects.h"

namespace carom::dynamics {

/// Bodies at a trial, and what forces do there. By body slot; empty until somebody asks.
struct Trial {
  explicit Trial(Memory* m) : x(m), v(m), omega(m), accel(m), alpha(m), q(m), springs(m), own(m), hanging(m) {}
  void resize(std::size_t slots) {
    for (auto* a : {&x, &v, &omega, &accel, &alpha}) a->resize(slots, Vec3::zero());
    q.resize(slots, Quat::identity());
  }
  /// @param share  s, for which forces will act
  Accelerate to(Real share) { return {1, accel.data(), alpha.data(), share}; }
  Motion at() const { return {x.data(), q.data(), v.data(), omega.data()}; }

  Array<Vec3> x, v, omega;   // m, m/s, rad/s, as Motion has them
  Array<Vec3> accel, alpha;  // m/s^2, rad/s^2, world
  Array<Quat> q;
  Array<std::uint32_t> springs;  // of bodies that are asked for alone
  Participants own, hanging;     // scratch: one of them, and its springs
};

/// Whether a row is such a force. How a body turns by itself is not: who moves it knows its equation of motion.
bool is_asked_at_trials(const Effect& effect);

/// What forces that vary do to one body.
struct ForcesOnOne {
  std::uint32_t body = kInvalid;
  std::uint64_t rows = 0;                 // of the table, as bits
  std::uint32_t spring = 0, springs = 0;  // Trial::springs: the first, how many
  Real rate = 0;                          // 1/s: of all that decays, and how fast springs may swing it

  explicit operator bool() const { return rows != 0 || springs > 0; }
  /// @param accel, alpha  m/s^2, rad/s^2, world: to which it is added
  void add(const World& world, Trial& trial, const Vec3& x, const Quat& q, const Vec3& v, const Vec3& omega,
           Vec3& accel, Vec3& alpha) const;
};
/// Those that are not the same all step long, as a step begins. Allocates.
/// @return false: not all can be told where the body alone is at a trial: a spring's other end goes its own way
bool find_varying(const World& world, std::uint32_t body, Trial& trial, ForcesOnOne& to);

}  // namespace carom::dynamics
