// Triangle meshes for scenes: read, scale, reduce to a convex hull. The physics gets the hull, the eye the mesh.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace carom::tools {

struct Mesh {
  std::vector<Eigen::Vector3d> points;              ///< m
  std::vector<std::array<std::uint32_t, 3>> faces;  ///< counter-clockwise seen from outside
};

/// Read the positions and faces of a Wavefront OBJ file (`v` and `f` lines; polygons are fanned; the rest is skipped).
/// @throws Error with the line at fault: a bad number, an index out of range, no vertices
Mesh read_obj(const std::string& path);

/// Centre the bounding box on the origin and scale uniformly until it is `height` tall along y.
void fit_to_height(Mesh& mesh, double height);

/// The mesh with one corner for all that lie in a cell of a grid, at their mean; faces that shrink to a line are gone.
/// @param cell  m, > 0
Mesh thinned(const Mesh& mesh, double cell);

/// Convex hull by qhull: hull vertices and triangulated facets, outward.
/// @param points  at least 4, not all in one plane
/// @throws Error with qhull's reason
Mesh convex_hull(const std::vector<Eigen::Vector3d>& points);

/// A hull with at most `limit` vertices inside a given hull, and what it lost.
struct ReducedHull {
  Mesh hull;
  double loss =
      0;  ///< m, largest distance from a vertex of the full hull to the reduced one (their Hausdorff distance)
};

/// Keep vertices greedily: from the extremes along the axes, look along the facet normals of what is kept and take the
/// vertices that stick out most, until `limit` are kept or nothing sticks out.
/// @param limit  >= 8
ReducedHull reduce_hull(const Mesh& hull, std::size_t limit);

/// x, y, z of every point: parameters of the hull plugin.
std::vector<double> hull_params(const Mesh& hull);

/// The bunny of a scene: what is drawn, what collides, and where it is from.
struct Bunny {
  Mesh mesh;                             ///< for the eye; bounding box centred on the origin
  ReducedHull hull;                      ///< same frame
  Eigen::Vector3d half_extents() const;  ///< m, of the mesh's bounding box
  std::vector<std::string> remarks;      ///< credit or stand-in notice, sizes, loss
};

/// @param mesh_path  an OBJ, STL or PLY file; "" takes the one that Debian's glmark2-data installs, else a procedural
/// body
/// @param height     m   @param hull_vertices  at most this many, >= 8
/// @throws Error if mesh_path is given and cannot be read
Bunny load_bunny(const std::string& mesh_path, double height, std::size_t hull_vertices);

}  // namespace carom::tools
