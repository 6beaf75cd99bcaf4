// The effects on velocities, one file each: who are the participants, and what is done to them.
//
// Signatures as the table wants them (dynamics/effects.h): a force adds scale * acceleration to its target and reads
// the motion it is given, never the state's; a flow maps velocities over h exactly or stably where a force could not.
#pragma once

#include "dynamics/body_state.h"
#include "dynamics/effects.h"

namespace carom::dynamics {

/// Whether what an effect does to a body is the same all step long, in body or world axes: gravity, the host's force
/// and torque, and how a body turns by itself.
bool is_constant_in_a_step(const Effect& effect);
/// Whether nothing but such effects acts on a body.
bool only_constant_forces_act(const World& world, std::uint32_t body);

namespace gravity {
void find(const Scene&, const State&, Participants&);
void force(const Scene&, const State&, const Participants&, const Motion& at, const Accelerate& out);
}  // namespace gravity

namespace linear_damping {
void find(const Scene&, const State&, Participants&);
void force(const Scene&, const State&, const Participants&, const Motion& at, const Accelerate& out);
void flow(const Scene&, const Participants&, Real h, const Quat* q, Vec3* v, Vec3* omega);
Real rate(const Scene&, const State&, std::uint32_t body);
}  // namespace linear_damping

namespace angular_damping {
void find(const Scene&, const State&, Participants&);
void force(const Scene&, const State&, const Participants&, const Motion& at, const Accelerate& out);
void flow(const Scene&, const Participants&, Real h, const Quat* q, Vec3* v, Vec3* omega);
Real rate(const Scene&, const State&, std::uint32_t body);
}  // namespace angular_damping

namespace gyroscopic {
void find(const Scene&, const State&, Participants&);
bool wakes(const Scene&, const State&, std::uint32_t body);
void force(const Scene&, const State&, const Participants&, const Motion& at, const Accelerate& out);
void flow(const Scene&, const Participants&, Real h, const Quat* q, Vec3* v, Vec3* omega);
}  // namespace gyroscopic

namespace user_force {
void find(const Scene&, const State&, Participants&);
void force(const Scene&, const State&, const Participants&, const Motion& at, const Accelerate& out);
}  // namespace user_force

namespace user_torque {
void find(const Scene&, const State&, Participants&);
void force(const Scene&, const State&, const Participants&, const Motion& at, const Accelerate& out);
}  // namespace user_torque

/// rad/s^2, world, that a torque about the centre of mass gives a body, with the axes that are locked.
/// @param torque  N m, world
Vec3 angular_acceleration(const Scene& scene, std::uint32_t body, const Quat& q, const Vec3& torque);

/// Drag of air; and wind, which is the motion of that air: it serves drag's participants and does nothing by itself.
/// @oracle tests/oracle/test_forces
namespace drag {
void find(const Scene&, const State&, Participants&);
void force(const Scene&, const State&, const Participants&, const Motion& at, const Accelerate& out);
void flow(const Scene&, const Participants&, Real h, const Quat* q, Vec3* v, Vec3* omega);
Real rate(const Scene&, const State&, std::uint32_t body);
}  // namespace drag
namespace wind {
void find(const Scene&, const State&, Participants&);
}
/// m/s, world: of the air as a body meets it.
Vec3 air_velocity(const Scene& scene, std::uint32_t body);

/// Fields of acceleration or force.   @oracle tests/oracle/test_forces
namespace fields {
void find(const Scene&, const State&, Participants&);
void force(const Scene&, const State&, const Participants&, const Motion& at, const Accelerate& out);
}  // namespace fields
/// m/s^2 or N, world, at a place.   @param x  m, world
Vec3 field_at(const FieldDef& field, const Vec3& x);

/// Magnetic moments in magnetic fields.   @oracle tests/oracle/test_magnetism
namespace magnetism {
void find(const Scene&, const State&, Participants&);
void force(const Scene&, const State&, const Participants&, const Motion& at, const Accelerate& out);
}  // namespace magnetism

/// Springs as forces. Participants are springs, by slot.   @oracle tests/oracle/test_forces
namespace springs {
void find(const Scene&, const State&, Participants&);
void force(const Scene&, const State&, const Participants&, const Motion& at, const Accelerate& out);
}  // namespace springs
/// Before a body goes.
void remove_springs_of(World& world, std::uint32_t body);
/// Which of them act: neither forbidden, nor both ends asleep or immovable.
void plan_springs(const World& world);
/// How stiff they may be in substeps of h.
void carry_springs(const World& world, SpringLoads& to, Real h);
/// Wake who hangs on something that moves.
void wake_sprung(const World& world, Sleepers to);
struct SpringReading {
  Real length;  // m
  Real pull;    // N, above 0 it pulls its ends together; as it was set, whatever a substep can carry
};
SpringReading read_spring(const World& world, std::uint32_t slot);

/// Buoyancy and drag of water.   @oracle tests/oracle/test_forces
namespace buoyancy {
void find(const Scene&, const State&, Participants&);
bool wakes(const Scene&, const State&, std::uint32_t body);
void force(const Scene&, const State&, const Participants&, const Motion& at, const Accelerate& out);
}  // namespace buoyancy

/// Velocities along and about world axes that are held at 0. Whatever moves a body respects it: impulses and torques
/// have no effect along a locked axis, and turn a body as one that cannot turn about it, E (E^T I E)^-1 E^T in place of
/// I^-1 with E the axes that are free. What other forces did along a locked axis is taken off here: that is what
/// constraint forces do. Nothing is solved for, nothing drifts: a locked velocity is 0 to the bit.
///
/// Who may turn about two axes keeps the momentum about them, not that of a free top: this module has its gyroscopic
/// term, by the implicit midpoint rule, in place of the dial's method. With one axis or none there is no such term.
/// @oracle tests/oracle/test_axis_locks
namespace axis_locks {
void find(const Scene&, const State&, Participants&);
/// After the forces of a substep: velocities, and what integrators propose.
void hold(const World& world, Velocities& to, Real h);
}  // namespace axis_locks

/// A body's locks hold where they are not forbidden: to be called where either has changed.
void settle_locks(Scene& scene, std::uint32_t body);
/// What of velocities locks leave. Not of a body without locks.
/// @param v, omega  m/s, rad/s, world
void hold_velocity(const Scene& scene, std::uint32_t body, const Quat& q, Vec3& v, Vec3& omega);

/// e^-x with the same bits on every platform.
/// @param x   x >= 0
/// @accuracy  2 eps relative for x < 700; 0 beyond
/// @oracle    tests/unit/dynamics/test_forces
Real decay(Real x);

}  // namespace carom::dynamics
