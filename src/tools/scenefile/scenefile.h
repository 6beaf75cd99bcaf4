// Scenes as files: glTF 2.0 with physics, or a whole snapshot of a world. README.md says what is in them.
#pragma once

#include "scenes/scene.h"

namespace carom::tools {

/// Whether a name is a scene file's: by its ending, .gltf or .glb, or as a snapshot by how it begins.
bool is_scene_file(const std::string& name);

/// A scene whose description is a file: build() it with Settings::mesh_path set to the path.
/// @throws Error: cannot be read, is no glTF
Scene scene_of_file(const std::string& path);

bool is_snapshot_file(const std::string& path);
Scene scene_of_snapshot(const std::string& path);  ///< likewise
/// Make the world of a stage, in which nothing is, the one that was saved.   @throws Error
void read_snapshot(const std::string& path, Stage& stage);

/// Fill a stage from a glTF file. What the library has no counterpart for is left out, and said so in stage.remarks.
/// @throws Error that names the place in the file
void read_scene(const std::string& path, Stage& stage);

/// Write what a stage is made of, as it stands.   @param seconds, dt  s, suggested to who runs it   @throws Error
void write_scene(const std::string& path, Stage& stage, double seconds, double dt);

/// The triangles of a glTF file: of all nodes of its scene, as they stand, or of one mesh in its own frame.
/// @param which  name or index of a mesh; "": all   @throws Error that names the place in the file
Mesh mesh_of_gltf(const std::string& path, const std::string& which = "");

/// Write a scene of one body that is made of hulls.   @param stage  empty   @throws Error
void write_parts_scene(const std::string& path, const std::string& name, const std::vector<Mesh>& hulls, Stage& stage);

}  // namespace carom::tools
