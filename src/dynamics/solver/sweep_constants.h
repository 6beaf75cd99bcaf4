// Numbers of the sweeps over contacts in lanes.
#pragma once

#include "core/constant.h"

namespace carom::dynamics {

inline constexpr Constant<int> kInnerSweeps{
    "inner_sweeps", 2, "sweeps",
    "over the points of one pair, there and back, within each visit of it: they depend on each other so much that one "
    "would leave the bodies rocking",
    "1: what stands on four points rocks; more: time in the innermost loop that the next substep makes good anyway"};
inline constexpr Constant<double> kUnderLoad{"under_load_share", 0.1, "1",
                                             "share of push_speed at which a spring that bears as much as it may push "
                                             "still parts its bodies: it goes on growing under the load, slowly",
                                             "0: what is too heavy for push_speed sinks and never comes up; larger: "
                                             "overlap under a load is undone with a leap when the load goes"};
inline constexpr Constant<double> kSpared{
    "sag_spared", 1.2, "1",
    "times what a spring sinks under its load at rest: so much overlap is left alone when places are corrected, a "
    "little more than all that belongs to the spring",
    "1 or less: places are corrected against the springs, and stacks climb and creak; larger: overlap stays that no "
    "load asks for"};

inline constexpr Constant<double> kSoftSink{
    "soft_sink", 1e-3, "1",
    "of the thickness of the thinner of two that touch, what a soft contact may sink by under the weight of one body: "
    "springs of what is thin are as much stiffer as that takes, whatever contact_frequency says",
    "larger: stacks of coins and dice are visibly lower than they should be; smaller: what is thin rocks and creaks as if "
    "it had no springs"};
inline constexpr Constant<double> kSweptWay{
    "soft_swept_way", 0.005, "1",
    "of the thickness of the thinner of two that touch, the way that gravity gives a body in a substep for which one sweep "
    "over soft contacts will do: for each further such way there is one sweep more",
    "larger: stacks of coins and dice are pressed into each other as they land, and creep; smaller: time for things of "
    "centimetres that one sweep holds as well"};
inline constexpr Constant<int> kMostSweeps{
    "soft_most_sweeps", 64, "sweeps", "that there are at most, however thin a thing is",
    "more: time where things of a tenth of a millimetre meet, in steps that are far too long for them; fewer: coins of half "
    "a millimetre that land on each other end up within each other, at 60 Hz"};

inline constexpr Constant<double> kPatchBend{
    "patch_bend", 0.6, "1",
    "how much less than an ellipsoid the bound of a patch's friction holds where it slides and spins at once: between "
    "what is exact for a disc that hardly slides (0.5) and for one that hardly spins (0.8)",
    "smaller: what slides and spins stops sooner, by an eighth of its way at 0; larger: it goes farther"};

inline constexpr Constant<double> kTouching{
    "friction_touching", 0.01, "1",
    "share of a patch's width by which a point may hang higher than the lowest and still counts where friction acts, "
    "if loads are not known: 0.6 degrees of tilt, more than what rests has, less than a point in the air of a roller",
    "smaller: friction of what has just landed acts at a corner; larger: it acts at points in the air"};

inline constexpr ConstantRow kSweepConstants[] = {kInnerSweeps, kUnderLoad,  kSpared,    kSoftSink,
                                                  kSweptWay,    kMostSweeps, kPatchBend, kTouching};

}  // namespace carom::dynamics
