// Writes a recording as an animated glTF 2.0 file that any viewer plays: .gltf (self-contained, base64) or .glb.
#pragma once

#include "visual/recording.h"

namespace carom::tools {

/// @throws Error unless the path ends in .gltf or .glb and can be opened for writing (it is then empty)
void check_gltf_path(const std::string& path);

/// @param path  ends in .gltf or .glb   @throws Error (other ending, file cannot be written)
/// A node per actor that is drawn, a child node per part where there are several; one mesh per distinct shape and kind;
/// translation and rotation samplers (linear) for every dynamic actor; a camera; a floor where a half-space faces up.
void write_gltf(const std::string& path, Stage& stage, const Recording& recording);

}  // namespace carom::tools
