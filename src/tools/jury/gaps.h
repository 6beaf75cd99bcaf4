// How far joints are from being fulfilled.
#pragma once

#include "jury/case.h"

namespace carom::tools::jury {

/// m: how far the points are from where they should be, limits included; or how far the axes' error moves the surface
/// of the smaller body, if that is more.
double gap_of(const Case& the_case, const Link& link, const Frame& frame);
double gap_limit(const Case& the_case, const Link& link);  ///< m

}  // namespace carom::tools::jury
