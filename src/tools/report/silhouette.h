// What a stage looks like from the side: convex parts by their support functions, meshes by their shadow.
#pragma once

#include <vector>

#include "report/filmstrip.h"
#include "visual/recording.h"

namespace carom::report {

/// Outer boundary of the shadow that a mesh throws along z, counter-clockwise, true to half a cell of a raster that is
/// `cells` wide along its longer side. Of several parts, the one with the longest boundary; empty for an empty mesh.
/// @param mesh  m, world; sides of its faces do not matter   @param cells  >= 8
std::vector<Point> shadow(const tools::Mesh& mesh, int cells = 128);

/// Outlines of all parts in a frame, seen along z, far ones first; a colour for each kind of actor. Half-spaces and
/// particles have none.
std::vector<Outline> side_view(tools::Stage& stage, const tools::Recording& recording, std::size_t frame);

/// Frames spread evenly over a recording, the first and the last among them, in a window that shows all that moves.
/// @param panels  >= 1
Filmstrip filmstrip_of(tools::Stage& stage, const tools::Recording& recording, int panels);

}  // namespace carom::report
