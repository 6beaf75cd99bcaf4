// Scenes as files: glTF 2.0 with physics. README.md says what is in them.
#pragma once

#include "scenes/scene.h"

namespace carom::tools {

/// Whether a name is a scene file's, by its ending: .gltf, .glb.
bool is_scene_file(const std::string& name);

/// A scene whose description is a file: build() it with Settings::mesh_path set to the path.
/// @throws Error: cannot be read, is no glTF
Scene scene_of_file(const std::string& path);

/// Fill a stage from a file. What the library has no counterpart for is left out, and said so in stage.remarks.
/// @throws Error that names the place in the file
void read_scene(const std::string& path, Stage& stage);

/// Write what a stage is made of, as it stands.   @param seconds, dt  s, suggested to who runs it   @throws Error
void write_scene(const std::string& path, Stage& stage, double seconds, double dt);

}  // namespace carom::tools
