// Writes a recording as an animated glTF 2.0 file that any viewer plays: .gltf (self-contained, base64) or .glb.
#pragma once

#include <nlohmann/json.hpp>

#include "visual/recording.h"

namespace carom::tools {

/// @throws Error unless the path ends in .gltf or .glb and can be opened for writing (it is then empty)
void check_gltf_path(const std::string& path);

/// A stage drawn, not written yet.
struct GltfDrawing {
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  nlohmann::json document;
  std::string bytes;                                ///< of its one buffer
  std::vector<std::size_t> node;                    ///< by actor, or kNone: not drawn
  std::vector<std::vector<std::size_t>> part_node;  ///< by actor and part; the actor's own where it is its one part
};
GltfDrawing draw_gltf(Stage& stage, const Recording& recording);
/// @throws Error as below
void save_gltf(const std::string& path, GltfDrawing drawing);

/// @param path  ends in .gltf or .glb   @throws Error (other ending, file cannot be written)
/// A node per actor that is drawn, a child node per part where there are several; one mesh per distinct shape and kind;
/// translation and rotation samplers (linear) for every dynamic actor; a camera; a floor where a half-space faces up.
void write_gltf(const std::string& path, Stage& stage, const Recording& recording);

}  // namespace carom::tools
