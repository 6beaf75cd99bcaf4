// What a triangle mesh encloses: winding numbers and distances by a tree of its faces, and a grid of cells in and out.
#pragma once

#include <vector>

#include "mesh/mesh.h"

namespace carom::tools {

/// The faces of a mesh in a tree.
class FaceTree {
 public:
  /// @param mesh  outlives the tree; at least one face
  explicit FaceTree(const Mesh& mesh);
  /// How often the faces go round a point: 1 inside what is closed, 0 outside, in between near a hole; so meshes with
  /// small holes have an inside, too.   @accuracy  some 0.05: clusters seen from afar count as dipoles
  double winding(const Eigen::Vector3d& p) const;
  /// m, to the nearest point of a face.
  double distance(const Eigen::Vector3d& p) const;

 private:
  struct Node {
    Eigen::Vector3d middle, area;  // m; m^2, sum of the faces' vectors
    double radius;                 // m, about the middle
    std::uint32_t first, last;     // of order_
    std::uint32_t left, right;     // 0: a leaf
  };
  std::uint32_t build(std::uint32_t first, std::uint32_t last);
  void nearest(std::uint32_t node, const Eigen::Vector3d& p, double& best2) const;

  const Mesh& mesh_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

/// Cells of a grid around a mesh, a cell's width wider on every side.
struct Solid {
  static constexpr std::uint8_t kOutside = 0, kSurface = 1, kInside = 2;

  Eigen::Vector3d low = Eigen::Vector3d::Zero();  ///< m, corner of the grid
  double cell = 0;                                ///< m, its side
  Eigen::Vector3i n = Eigen::Vector3i::Zero();
  std::vector<std::uint8_t> kind;  ///< x fastest
  std::vector<float> away;         ///< m, from a cell's middle to that of the nearest cell that is not outside

  double most_winding = 0;  ///< of cells that no face crosses: beside an open sheet a half

  std::size_t at(int x, int y, int z) const {
    return static_cast<std::size_t>(x) +
           static_cast<std::size_t>(n.x()) *
               (static_cast<std::size_t>(y) + static_cast<std::size_t>(n.y()) * static_cast<std::size_t>(z));
  }
  Eigen::Vector3d middle(int x, int y, int z) const { return low + cell * Eigen::Vector3d(x + 0.5, y + 0.5, z + 0.5); }
  std::size_t inside() const;  ///< number of cells
};

/// @param across  cells along the longest side of the bounding box
Solid fill_solid(const Mesh& mesh, const FaceTree& tree, int across);

/// m^2, squared distance from a point to the triangle a, b, c.
double distance_squared(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                        const Eigen::Vector3d& c);

/// m^3, by the divergence theorem: of what is closed and looks outwards.
double volume_of(const Mesh& mesh);

}  // namespace carom::tools
