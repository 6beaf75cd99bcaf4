// What a stage looks like, in perspective and shaded, as a drawing: a frame of a run that needs no display.
#pragma once

#include <string>

#include "scenes/scene.h"

namespace carom::report {

/// Draw the convex shapes of a stage (what collides, not the meshes that viewers draw) as its world stands now, from
/// its own camera (Stage::camera_from). Faces are flat, shaded by their normals and painted from far to near, so two
/// that pass through each other are not cut at the line where they meet.
/// @param caption  below the picture
/// @return         an SVG document, 900 px wide
std::string perspective(tools::Stage& stage, const std::string& title, const std::string& caption);

}  // namespace carom::report
