// The distance of two shapes at given poses, as carom_shape_distance() gives it: for one pair, and for many.
#pragma once

#include <carom/query.h>

#include "abi/check.h"
#include "collision/narrow/query.h"

namespace carom::abi {

/// Take in how to ask; null: defaults. Within the bounds of the dials of the same names.
bool read_distance_desc(Call& call, int argument, const carom_distance_desc* given, carom_distance_desc& known);

/// What a checked descriptor asks for.
QuerySettings query_settings(const carom_distance_desc& desc);

/// Whether two shapes have a distance.   @param what  "" or " of pair 7"
bool has_distance(Call& call, int argument, const char* what, const Shape& a, const Shape& b);

/// @param frame_*  of the shapes in the world
carom_distance measure_distance(const Shape& a, const Frame& frame_a, const Shape& b, const Frame& frame_b,
                                const QuerySettings& settings);

}  // namespace carom::abi
