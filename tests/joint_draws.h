// Numbers, places and turns that tests of joints draw, alike with every compiler.
#pragma once

#include "joint_scenes.h"

namespace carom::test {

inline std::uint64_t g_seed = 0x9E3779B97F4A7C15;
/// From -1 to 1.
inline Real draw() {
  g_seed ^= g_seed << 13, g_seed ^= g_seed >> 7, g_seed ^= g_seed << 17;
  return static_cast<Real>(g_seed >> 11) * 0x1p-52 - 1;
}
inline int below(int n) { return static_cast<int>((draw() + 1) / 2 * n * (1 - 1e-12)); }
inline Vec3 draw3(Real size) {
  const Real x = draw(), y = draw(), z = draw();
  return size * Vec3(x, y, z);
}
inline Quat draw_turn() {
  const Vec3 v = draw3(1);
  return normalized(Quat(draw(), v.x(), v.y(), v.z()));
}

}  // namespace carom::test
