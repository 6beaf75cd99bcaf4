// Numbers of the convex problem in which contacts yield, and of what may stand beside it.
#pragma once

#include "core/constant.h"

namespace carom::dynamics {

inline constexpr Constant<Real> kGiveOfContacts{
    "direct_give", 1e-3, "1",
    "of a contact's response to an impulse: by so much it yields while it is found how joints and contacts share a "
    "load; far above what locks are anchored by, so that impulses that no load requires vanish",
    "larger: shares are those of softer contacts, and the exact law is farther away; smaller: what is wedged bears more, "
    "without end at 0"};
inline constexpr Constant<Real> kForgets{
    "direct_forgets", 0.1, "1",
    "of what contacts bore in the last substep, by which they yield while it is found how joints and contacts share a load: "
    "in so many substeps what the law leaves undetermined goes to its least",
    "larger: what stands yields more, and is solved closer in rounds; smaller: what is wedged bears more and more"};
inline constexpr Constant<Real> kGiveOfSweeps{
    "direct_last_give", 0.06, "1",
    "of a contact's response: softness in sweeps, and the most that contacts of a pinch yield; that of solver soft_step "
    "at 30 Hz and 1/240 s",
    "larger: bodies sink deeper in such a step; smaller: what is wedged bears more"};
inline constexpr Constant<std::uint32_t> kStepsOfYielding{
    "direct_steps_of_yielding", 10, "steps of Newton",
    "in which displacements are found at most, and that a group may take, whatever its work, where it bears nothing yet",
    "fewer: overlaps last for longer, tracks gape; more: what is built overlapping stalls its first step"};
inline constexpr Constant<std::uint32_t> kRoundsCloser{
    "direct_rounds_closer", 3, "rounds", "after the solution in which contacts of what is joined yield",
    "fewer: grippers let slip by what contacts give; more: steps of Newton for what the next substep finds anew"};
inline constexpr Constant<int> kSweepsInstead{
    "direct_sweeps_instead", 20, "sweeps", "over few bodies, in a substep for which the work did not suffice",
    "fewer: a wave through a row of blocks runs too fast; more: time for nothing"};
inline constexpr Constant<Real> kWedged{
    "direct_wedged", 1e-10, "1",
    "of the sum of k p^2 of contacts, what they do to bodies: less is impulses that cancel each other; a cube under a "
    "million times its mass has 1e-6, stacks of n cubes n^-2",
    "larger: what bears a heavy load counts as wedged, and starts from nothing in each step; smaller: bodies that "
    "surfaces close on keep impulses that throw them in the next step"};
inline constexpr ConstantRow kYieldingConstants[] = {kGiveOfContacts, kForgets,       kGiveOfSweeps, kStepsOfYielding,
                                                     kRoundsCloser,   kSweepsInstead, kWedged};

}  // namespace carom::dynamics
