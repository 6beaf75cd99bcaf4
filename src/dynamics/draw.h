// What a world looks like, as coloured lines: read from it between steps, without changing it.
#pragma once

#include "dynamics/world.h"

namespace carom::dynamics {

struct DrawLine {
  enum Kind : std::uint32_t { shapes = 1, scenery = 2, bounds = 4, contacts = 8, joints = 16, bodies = 32 };
  Vec3 from, to;         // m, world
  std::uint32_t colour;  // 0xRRGGBBAA
  Kind kind;
  std::uint32_t body;  // slot, or kInvalid
};

struct DrawSettings {
  std::uint32_t what = 0;  // Kind bits
  bool by_island = false;  // else by what a body is
  Real scale = 1;          // m, length of normals and axes
};

/// All lines asked for, kind by kind.
void draw(const World& world, const DrawSettings& settings, Array<DrawLine>& lines);

}  // namespace carom::dynamics
