// Bodies that touch one or two flat surfaces and nothing else: wheels, coins, tops, cones that roll on their side, balls
// on a turntable, ladders that slide off a wall.
//
// Contacts are solved where a substep begins, which leaves a wheel in a leaning turn metres off. So the step of such
// a body is done once more by its equation of motion (touching_motion.h), from where the step began, and takes the
// solver's place. One surface holds by its friction, if that bears it all the way, or the body slides on it all the
// way. On two surfaces it slides, and may come off one. Whatever else acts on it, drag, fields, springs, water, magnets, is
// a force of that equation, and colliders of it that touch nothing are nothing. What is stopped by friction, comes off its only surface, tips
// onto an edge or meets another is left to the solver. How deep it is stays, unless the solver has brought it nearer
// to a touch.
//
// @oracle tests/oracle/test_lone_rollers: closed forms of steady turns, a ball on a turntable, energy, slopes
// @oracle tests/oracle/test_lone_leaners: lines, two surfaces, what slides and what comes off
#pragma once

#include "dynamics/contact/contact.h"
#include "dynamics/contact/touching_motion.h"

namespace carom::dynamics {

inline constexpr Constant<int> kRollSteps{"roll_steps", 128, "1",
                                          "of that method in a step before a roller is left to the solver",
                                          "larger: coins about to lie down take 100 us; smaller: they lie down early"};
inline constexpr Constant<Real> kRollApart{
    "roll_apart", 0.003, "1",
    "of the way to another point, or of the body's size, from a surface, beyond which a point does not touch it",
    "larger: coins are left to the solver before they lie down, what falls onto a surface is held above it for a step; "
    "smaller: what stands on its end is taken for a point, what soft contacts let spring is left out"};
inline constexpr Constant<Real> kRollSettle{
    "roll_settle", 0.25, "1",
    "of what it weighs in a step, as the impulse that brings a slipping point to rest at first",
    "larger: what still slides is stopped; smaller: rolling sets in later"};
inline constexpr Constant<Real> kRollGain{
    "roll_gain", 1e-4, "1", "of its kinetic energy that a roller may gain beyond the work of forces in a step",
    "larger: errors feed what spins fast; smaller: rounding leaves it to the solver"};
inline constexpr ConstantRow kLoneRollerConstants[] = {kRollSteps, kRollApart, kRollSettle, kRollGain};

struct LoneRollers {
  explicit LoneRollers(Memory* m) : bodies(m), pairs(m), touches(m), place(m), trial(m) {}
  Array<TouchingBody> bodies;
  Array<std::uint32_t> pairs;   // scratch: pairs in contact that may be their touches
  Array<std::uint8_t> touches;  // by slot, scratch: how many pairs
  Array<std::uint32_t> place;   // by slot: in `bodies`, or kInvalid; empty where there are none
  Trial trial;                  // of those on which varying forces act
};

/// Stage functions of the page. Who may, as a step begins; allocates.
void find_lone_rollers(const World& world, const StepTime& time);
/// Where a body is at the end of a step that it takes once more. The state is that of the solver's step.
/// @return false: it is the solver's, or no such body
bool ends_alone(const World& world, std::uint32_t body, Real dt, TouchingMotion::At& at);
/// Their steps once more.
void roll_alone(const World& world, Poses& poses, Velocities& motion, const StepTime& time);

}  // namespace carom::dynamics
