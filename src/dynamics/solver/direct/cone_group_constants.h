// Numbers of the direct solver: how well a group is solved, and at what work.
#pragma once

#include <cstdint>

#include "core/constant.h"

namespace carom::dynamics {

inline constexpr Constant<Real> kFineShare{
    "direct_fine_share", 1e-3, "1",
    "share of the tolerance to which few bodies that lie still are solved, and what is joined and touches nothing: what "
    "may roll takes each push for good, and velocities along joints add up to gaps",
    "larger: balls at rest creep away, joints gape; smaller: steps of Newton for what rounding undoes"};
inline constexpr Constant<Real> kConeShare{"direct_speed_share", 1e-3, "1",
                                           "share of the fastest contact's speed that is good enough where work is "
                                           "bounded: a thousandth of an impact is not seen",
                                           "larger: bodies leave impacts with velocities that friction and "
                                           "restitution did not make; smaller: impacts take all the work there is"};
inline constexpr Constant<Real> kRest{
    "direct_rest", 10, "1",
    "tolerances below which contacts are at rest, however they move: the next substep then repeats this one",
    "larger: what starts to slide is held until the next step; smaller: what rests is solved in every substep"};
inline constexpr Constant<int> kJerks{
    "direct_jerks", 3, "times",
    "that a group is solved anew because a joint was jerked: each solution gives the loads of joints, and so how much "
    "stiffer their bodies must be taken in the next",
    "fewer: a joint that is jerked throws its bodies; more: a mechanism at a dead point takes so many times the work"};
inline constexpr Constant<Real> kLongestTurn{
    "direct_longest_way", 30, "1",
    "times the largest overlap to be undone: a body is displaced by so much at most, for what is wedged between walls "
    "that nearly face each other would be moved by metres to be pushed apart by millimetres",
    "larger: what is wedged flies out; smaller: long levers are pushed apart too slowly"};
inline constexpr Constant<Real> kJointPush{
    "direct_joint_push", 10, "m/s or rad/s",
    "an error of a joint is undone no faster, and no body is displaced faster for it",
    "larger: what was torn apart is pulled together at once, and what hangs on it is lifted; smaller: it gapes for longer"};
inline constexpr Constant<Real> kGiveOfDisplacements{
    "direct_give_moved", 1e-4, "1",
    "of its response, by which a contact or lock yields while what is joined is moved together and apart: so much of an "
    "error is left to the next pass, and where contacts are in the way none is solved closer",
    "larger: long chains gape for longer; smaller: what contradicts itself takes many steps, and taut chains are thrown"};
inline constexpr Constant<Real> kGap{
    "direct_gap", 1e-9, "m or rad",
    "of a joint that needs no correction: far above rounding (1e-12 m at 4 km from the "
    "origin), far below what is visible",
    "larger: linkages whose joints depend on each other drift apart; smaller: joints "
    "far from the origin are corrected in every step for their rounding"};
inline constexpr Constant<std::uint32_t> kAlways{
    "direct_always", 2, "steps of Newton",
    "of a group and substep, however little work is left: a group over its budget still comes nearer to its solution",
    "fewer: groups over their budget keep the impulses they started from; more: direct_work bounds less"};
inline constexpr Constant<std::uint32_t> kMostSteps{
    "direct_most_steps", 200, "steps of Newton", "of a group and substep: impacts of many bodies take that many",
    "fewer: impacts through many bodies end unsolved; more: a problem that has no solution stalls the step for longer"};
inline constexpr Constant<std::uint32_t> kWorkOfContact{
    "direct_work_of_contact", 3, "block products", "that a contact takes as long as, in a step of Newton's method",
    "more or fewer: budgets of groups with many points to a body are too small or too large"};
inline constexpr Constant<std::uint64_t> kWorkOfPoint{
    "direct_work_of_point", 16, "block products",
    "of a step that a group may take for each of its points: some 2 us, twice what soft contacts take for a point",
    "more: a step in which a heap is solved at once stalls; fewer: heaps that come to rest are given up, and sag"};
inline constexpr Constant<std::uint64_t> kLeastWork{
    "direct_least_work", 4000, "block products",
    "of a step that a group may take, however few its points: half a millisecond",
    "more: small scenes stall, if shortly; fewer: small structures are given up while they move"};
inline constexpr Constant<std::uint32_t> kExpectedOfMoving{
    "direct_expected_moving", 10, "steps of Newton",
    "that a group that moves is expected to take in a step: where all of them together would take more than there is, all "
    "have less",
    "fewer: many groups that move stall the step together; more: what moves is slowed by groups far away"};
inline constexpr Constant<std::uint32_t> kFew{
    "direct_few", 100, "couplings",
    "joints, and pairs that touch, of a group that is tried directly first, whatever it does",
    "more: heaps of so many cost more than sweeps over them; fewer: ragdolls and short chains stretch, few blocks sag"};
inline constexpr Constant<std::uint64_t> kWorkOfFew{
    "direct_work_of_few", 20000, "block products",
    "of a step, for a group of few bodies, whatever the others take: what is cut short there throws bodies",
    "more: ragdolls in a heap stall; fewer: light bodies on joints are thrown"};
inline constexpr Constant<std::uint32_t> kExpectedAtRest{
    "direct_expected_at_rest", 16, "steps of Newton",
    "that a group at rest is expected to take when it is solved anew: of many at once the others wait",
    "fewer: many are solved in one step, which stalls; more: one a step, and walls come late to rest"};
inline constexpr Constant<Real> kUnborne{
    "direct_unborne", 0.1, "1",
    "of what loads do to a body in a substep, that a solution may leave of what stood before it is given up: soft "
    "contacts, which take over then, leave half of it in the first; of what is borne, that sweeps may leave where the work ended",
    "larger: what a solution does not hold sinks on; smaller: towers at rest are thrown down for micrometres"};
inline constexpr Constant<Real> kBends{
    "direct_bends", 0.3, "rad",
    "by which a body that rolls may turn in a substep for its way to be bent within it, to second order in that turn",
    "larger: what spins fast is thrown by the square of it; smaller: coins and wheels lose energy as they go round"};

inline constexpr ConstantRow kConeGroupConstants[] = {
    kFineShare,           kConeShare,      kRest,      kJerks,         kLongestTurn, kJointPush, kGap,
    kGiveOfDisplacements, kAlways,         kMostSteps, kWorkOfContact, kWorkOfPoint, kLeastWork, kExpectedOfMoving,
    kWorkOfFew,           kExpectedAtRest, kUnborne,   kFew,           kBends};

}  // namespace carom::dynamics
