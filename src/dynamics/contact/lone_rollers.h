// Bodies that touch one flat surface at one point and nothing else: wheels, coins, tops, balls on a turntable.
//
// While friction holds its point such a body is a smooth mechanical system: the point of the body that touches keeps
// the velocity of what it touches. Solvers answer contacts where a substep begins, which leaves a wheel in a leaning
// turn metres off. So its step is done once more by its equation of motion, from where the step began, and takes the
// solver's place if friction bears it all the way. What slides, parts, tips onto an edge or meets another is left to
// the solver. How deep the point is stays, unless the solver has brought it nearer to a touch.
//
//   m a = F + f,   I w' + w x I w = T + r x f,   a + w' x r + w x r' = s'
//
// r: from the centre of mass to the point that touches, which the support function tells of any orientation; r' its
// change as the body turns, by which the point travels over the body; s: velocity of the surface where it is.
//
// @oracle tests/oracle/test_lone_rollers: closed forms of steady turns, a ball on a turntable, energy, slopes
#pragma once

#include "core/constant.h"
#include "dynamics/contact/contact.h"

namespace carom::dynamics {

inline constexpr Constant<Real> kRollStep{
    "roll_step", 0.1, "rad",
    "by which a lone roller turns, or its point travels around it, in a step of the fourth-order method",
    "larger: spinning coins gain or lose energy; smaller: they cost more"};
inline constexpr Constant<int> kRollSteps{"roll_steps", 128, "1",
                                          "of that method in a step before a roller is left to the solver",
                                          "larger: coins about to lie down take 100 us; smaller: they lie down early"};
inline constexpr Constant<Real> kRollProbe{"roll_probe", 1e-4, "rad",
                                           "of the two turns whose support points tell how the touching point travels",
                                           "larger: their difference errs by its square; smaller: by rounding"};
inline constexpr Constant<Real> kRollTravel{
    "roll_travel", 1000, "1",
    "times the body's size that its point may travel for a radian: the rim of a coin that leans by 0.001 travels as "
    "far",
    "larger: what lies flat is taken to roll; smaller: coins are left to the solver before they lie down"};
inline constexpr Constant<Real> kRollBend{
    "roll_bend", 0.1, "1",
    "by which the ways of the point for the two probing turns may differ: at an edge one of them jumps",
    "larger: what tips from corner to corner is taken to roll; smaller: coins that spin fast are left to the solver"};
inline constexpr Constant<Real> kRollJump{
    "roll_jump", 0.25, "1",
    "of the way of the point in a step of the method, and of what its body's size turns by, that it may be elsewhere",
    "larger: what tips over is taken to roll; smaller: coins that spin fast are left to the solver"};
inline constexpr Constant<Real> kRollApart{
    "roll_apart", 0.003, "1",
    "of the way between two points, by which the other is to be farther off: else it stands on a line or a face",
    "larger: coins are left to the solver before they lie down; smaller: what stands on its end is taken for a point"};
inline constexpr Constant<Real> kRollSettle{
    "roll_settle", 0.25, "1",
    "of what it weighs in a step, as the impulse that brings a slipping point to rest at first",
    "larger: what still slides is stopped; smaller: rolling sets in later"};
inline constexpr Constant<Real> kRollGain{
    "roll_gain", 1e-4, "1", "of its kinetic energy that a roller may gain beyond the work of forces in a step",
    "larger: errors feed what spins fast; smaller: rounding leaves it to the solver"};
inline constexpr ConstantRow kLoneRollerConstants[] = {kRollStep, kRollSteps, kRollProbe,  kRollTravel, kRollBend,
                                                       kRollJump, kRollApart, kRollSettle, kRollGain};

/// A body that may roll alone, as its step began.
struct LoneRoller {
  std::uint32_t body;
  std::uint32_t row, rows, deepest;          // of its pair: the first, how many; where it stands
  std::uint32_t collider, surface;           // colliders: its own, the other
  Vec3 n;                                    // unit, world, from the surface into the body
  Vec3 on_plane;                             // m, a point of the surface
  Real friction, rolling = 0, spinning = 0;  // coefficients; m, of what resists
  Vec3 x, v, omega;
  Quat q;
  Vec3 accel, torque;                       // m/s^2 of forces; N m, world
  Vec3 surface_x, surface_v, surface_spin;  // of the body below: its centre, m/s, rad/s
};

struct LoneRollers {
  explicit LoneRollers(Memory* m) : bodies(m), touches(m) {}
  Array<LoneRoller> bodies;
  Array<std::uint8_t> touches;  // by slot: pairs, scratch
};

/// Stage functions of the page. Who may, as a step begins; allocates.
void find_lone_rollers(const World& world, const StepTime& time);
/// Their steps once more, where friction bears them.
void roll_alone(const World& world, Poses& poses, Velocities& motion, const StepTime& time);

}  // namespace carom::dynamics
