// Triangles for the eye from any shape: asked of its support function through the ABI, so that a plugin that no host
// has seen before is drawn as well as a box.
#pragma once

#include "scenes/scene.h"

namespace carom::tools {

/// Outward triangles of a part in its own frame: polytopes exactly, curved shapes by the hull of support points in 24
/// meridians and 12 bands (a sphere's chord error is below 1 % of its radius), scenery as it is.
/// @throws Error for a half-space
Mesh tessellate(Engine& engine, const Part& part);

/// Corners with normals: faces that meet at less than `crease` share a smooth normal, others keep an edge.
struct ShadedMesh {
  std::vector<Eigen::Vector3f> points, normals;  ///< same length; normals unit
  std::vector<std::array<std::uint32_t, 3>> faces;
};

/// @param crease_cosine  cosine of the largest angle that is smoothed over. Faces of no area are dropped.
ShadedMesh shade(const Mesh& mesh, double crease_cosine);

}  // namespace carom::tools
