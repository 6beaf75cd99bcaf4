// Bodies that turn far for their shape within a step: rods, plates, needles.
//
// Lanes keep masses and arms of the step's beginning. A body's inertia turns with it, and what is off by an angle t is
// off in energy by up to (I_most / I_least) t^2: of a brick nothing to speak of, of a rod of 1:1000 that tilts by a
// hundredth of a radian fifty times what it has. So rows of such bodies are made anew for the pose of the moment, and
// their velocities are those of that pose. An impulse of true masses, arms and velocities that starts from nothing and
// fulfils the law of contact takes energy or leaves it, however long the step is.
#pragma once

#include "core/constant.h"
#include "dynamics/solver/wide_contacts.h"

namespace carom::dynamics {

inline constexpr Constant<Real> kFarTurn{
    "far_turn", 0.01, "1",
    "share of its energy by which a body's inertia may be out of date before rows are made anew: the sum of "
    "(I_i - I_j)^2 / (I_i I_j) t^2, t the angle by which it has turned since about the axis across both",
    "larger: thin bodies gain energy where they hit; smaller: time, in heaps of bricks that tumble"};
inline constexpr ConstantRow kFarTurnConstants[] = {kFarTurn};

/// Whether a body's moments of inertia differ, and a rotation method minds that: else nothing below asks for it.
bool may_turn_far(const World& world, std::uint32_t body);
/// Whether the spin of a body with unlike moments takes it too far within some time for masses that stay as they are.
/// @param time  s
bool turns_far_for_its_shape(const World& world, std::uint32_t body, Real time);
/// Likewise a turn.   @param turn  rad, world
bool turns_too_far(const World& world, std::uint32_t body, const Vec3& turn);
/// rad/s, world: a body's omega where a substep begins, of the one to which its rotation method has led it.
Vec3 led_back(const World& world, std::uint32_t body, const Vec3& end);
/// Leads a body's omega on over a substep, from its present pose: what it then has, and its predicted pose.
/// @param scratch  of one participant
void lead_on(const World& world, Velocities& to, std::uint32_t body, Real h, Participants& scratch);
/// Which solver bodies may: those whose moments of inertia differ. Allocates.
void find_far_turners(const World& world, WideContacts& wide);

/// Before a substep's sweeps: rows as bodies are now, from no impulse where they had to be made anew.
/// Velocities that a rotation method has led on to the end of the substep are led back to where it begins.
void begin_far_turns(const World& world, Velocities& to, WideContacts& wide, Real h);
/// After them: bodies that the sweeps moved turn over the substep from where it begins.
void end_far_turns(const World& world, Velocities& to, WideContacts& wide, Real h);
/// Before the sweeps at the end of a substep: rows as bodies are now. What has opened because a body turned gives no
/// impulse back, for that impulse did not act where it would be taken.
void heed_far_turns(const World& world, WideContacts& wide, Real h);
/// After a sweep: gaps that heed_far_turns() holds are none to measure from. Separations are those of the rows.
void measure_far_turns(const World& world, WideContacts& wide);

}  // namespace carom::dynamics
