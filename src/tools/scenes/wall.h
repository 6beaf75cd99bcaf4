// A wall of bricks, one thick: what scenes throw things at.
#pragma once

#include "scenes/scene.h"

namespace carom::tools {

/// The wall lies along z. Rows stand in half bond, as bricks are laid: every second one has a block less.
struct Wall {
  Vec half = Vec(0.15, 0.15, 0.3);  ///< m, half extents of a block
  double joint = 0.005;             ///< m, gap between blocks of a row
  double density = 60;              ///< kg/m^3
  int columns = 6, rows = 8;
  Vec foot = Vec::Zero();  ///< m, world: middle of its foot

  /// @return actor indices of the blocks, row by row from the foot
  std::vector<std::size_t> add_to(Stage& stage) const;
};

}  // namespace carom::tools
