// A mesh as several convex parts: what collides where one hull would fill what is hollow.
#pragma once

#include <functional>

#include "mesh/mesh.h"

namespace carom::tools {

/// How finely a mesh is to be taken apart.
struct PartsWanted {
  std::size_t most = 16;  ///< parts, 1 to 256
  double concavity = 0;   ///< m: how far parts may stand out of the mesh, if so many do; 0: a fiftieth of its length
  std::size_t vertices = 64;                           ///< of a part at most, 8 to 2000
  std::function<void(const std::string&)> progress{};  ///< told a line now and then; may be empty
};

/// Convex parts that together hold a mesh, and what they are off by.
struct Parts {
  std::vector<Mesh> hulls;      ///< by volume, largest first
  double outside = 0;           ///< m: how far their surface stands out of the mesh at worst
  double lost = 0;              ///< m: how far the mesh stands out of them at worst; 0 but for what fewer vertices cost
  double mesh_volume = 0;       ///< m^3
  double hull_volume = 0;       ///< m^3, of its one hull
  std::vector<double> volumes;  ///< m^3, of the parts
};

/// Cuts along the axes where that leaves the least between hulls and mesh, then puts together again what may be.
///
/// The mesh is cut where its parts' hulls stand out the farthest, until none does by more than wanted; of neighbours
/// those are joined whose common hull still does not. Hulls are those of the mesh's own faces within boxes that leave
/// no gap between them, so nothing of the mesh or of what it encloses lies outside of all (but for `lost`).
/// @accuracy outside: sampled at a half of a grid's cell, a hundredth of the mesh's length at most
/// @throws Error: no faces, flat, nothing inside, or numbers out of range
Parts take_apart(const Mesh& mesh, const PartsWanted& wanted);

/// @throws Error: cannot be written
void write_parts(const std::string& path, const std::vector<Mesh>& hulls);
/// Objects and groups (`o` and `g` lines) of an OBJ file, each a mesh of its own; one without any is one mesh.
/// @throws Error as read_obj()
std::vector<Mesh> read_parts(const std::string& path);

}  // namespace carom::tools
