// Numbers of the rules beside the direct solver's law: least force, no gain.
#pragma once

#include "core/constant.h"

namespace carom::dynamics {

inline constexpr Constant<Real> kGiveOfContacts{
    "direct_give", 1e-3, "1",
    "of a contact's response to an impulse: by so much it yields while it is found how joints and contacts share a "
    "load; far above what rounds anchor impulses by, so that those that no load requires vanish",
    "larger: shares are those of softer contacts, and the exact law is farther away; smaller: what is wedged bears more, "
    "without end at 0"};
inline constexpr Constant<Real> kGoesOn{
    "direct_goes_on", 3, "1",
    "times what is left where contacts have yielded: a group that starts with less to undo goes on as it did, its "
    "contacts stick or slip as before, and its rounds are nearly linear",
    "larger: rounds begin hard where contacts begin or cease to stick, and take more steps; smaller: what is merely held "
    "takes two rounds for one"};
inline constexpr Constant<Real> kWedged{
    "direct_wedged", 1e-10, "1",
    "of the sum of k p^2 of contacts, what they do to bodies: less is impulses that cancel each other; a cube under a "
    "million times its mass has 1e-6, stacks of n cubes n^-2",
    "larger: what bears a heavy load counts as wedged, and starts from nothing in each step; smaller: bodies that "
    "surfaces close on keep impulses that throw them in the next step"};
inline constexpr Constant<Real> kFarMore{
    "direct_far_more", 10, "1",
    "times what contacts bear that yield: where the exact law is not reached by as much more, it has no solution",
    "larger: what is wedged bears more; smaller: an impact that could not be solved in time counts as wedged"};
inline constexpr Constant<Real> kGiveOfSweeps{
    "direct_last_give", 0.06, "1",
    "of a contact's response: softness in the sweeps of last resort, that of solver soft_step at 30 Hz and 1/240 s",
    "larger: bodies sink deeper in such a step; smaller: what is wedged bears more"};
inline constexpr Constant<int> kLastSweeps{
    "direct_last_sweeps", 20, "sweeps",
    "over a group with a solution that added energy; a step later it is solved again",
    "fewer: tall piles sink in such a step; more: it costs as many more"};

inline constexpr Constant<int> kSweepsBetweenJoints{
    "direct_sweeps_between_joints", 5, "sweeps", "of those, after which joints are solved anew, all together",
    "fewer: it costs more solutions of joints; more: heavy bodies on light ones tear their joints in such a step"};
inline constexpr Constant<Real> kHeldByJoints{"direct_held_by_joints", 1e-6, "1",
                                              "of how far joints are off by then: to so much they are solved",
                                              "larger: joints drift apart; smaller: rounding asks for more steps"};
inline constexpr Constant<std::uint32_t> kMostStepsOfJoints{
    "direct_most_steps_of_joints", 10, "steps of Newton", "that such a solution may take",
    "fewer: limits are found one or two a time, and some not; more: it costs as many more"};

inline constexpr ConstantRow kLeastForceConstants[] = {
    kGiveOfContacts,      kGoesOn,       kWedged,           kFarMore, kGiveOfSweeps, kLastSweeps,
    kSweepsBetweenJoints, kHeldByJoints, kMostStepsOfJoints};

}  // namespace carom::dynamics
