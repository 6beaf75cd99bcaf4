// How far joints are from being fulfilled.
#pragma once

#include "jury/case.h"

namespace carom::tools::jury {

/// m: how far the points are from where they should be, limits included; or how far the axes' error moves the surface
/// of the smaller body, if that is more.
double gap_of(const Case& the_case, const Link& link, const Frame& frame);
double gap_limit(const Case& the_case, const Link& link);  ///< m
/// rad in (-pi, pi] or m: a hinge's twist, a slider's slide, as limits and drives count it.
double coordinate_of(const Link& link, const Frame& frame);
/// kg or kg m^2: what a joint's bodies weigh along that coordinate, were they alone and what is locked staying so.
double weight_along(const Case& the_case, const Link& link, const Frame& frame);
/// Energy that a drive can have given within a step: its force by the way that it went to its goal.
/// @param drive  as it was during the step
double most_work(const Link& link, const Drive& drive, const Frame& before, const Frame& now, double dt);

}  // namespace carom::tools::jury
