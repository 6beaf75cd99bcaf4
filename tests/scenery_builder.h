// Surfaces for tests: meshes and height fields as shapes, without the ABI.
#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <vector>

#include "collision/scenery/triangle_shape.h"

namespace carom::test {

struct Triangles {
  std::vector<double> xyz;
  std::vector<std::uint32_t> index;

  std::uint32_t vertex(double x, double y, double z) {
    xyz.insert(xyz.end(), {x, y, z});
    return static_cast<std::uint32_t>(xyz.size() / 3 - 1);
  }
  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) { index.insert(index.end(), {a, b, c}); }
};

/// A grid over x and z, two triangles to a cell, met from above.
/// @param side  m, of a cell   @param height  m, of a place
inline Triangles grid(int columns, int rows, double side, double x0, double z0,
                      const std::function<double(double, double)>& height) {
  Triangles t;
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i) {
      const double x = x0 + side * i, z = z0 + side * j;
      t.vertex(x, height(x, z), z);
    }
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const auto a = static_cast<std::uint32_t>(j * (columns + 1) + i), b = a + 1;
      const auto c = a + static_cast<std::uint32_t>(columns) + 1, d = c + 1;
      t.triangle(a, c, d), t.triangle(a, d, b);
    }
  return t;
}

/// A box's twelve triangles, outward.
inline Triangles box_surface(const Vec3& half) {
  Triangles t;
  for (int c = 0; c < 8; ++c)
    t.vertex(c & 1 ? half.x() : -half.x(), c & 2 ? half.y() : -half.y(), c & 4 ? half.z() : -half.z());
  static constexpr std::uint32_t kFaces[6][4] = {{1, 3, 7, 5}, {0, 4, 6, 2}, {2, 6, 7, 3},
                                                 {0, 1, 5, 4}, {4, 5, 7, 6}, {0, 2, 3, 1}};
  for (const auto& f : kFaces) t.triangle(f[0], f[1], f[2]), t.triangle(f[0], f[2], f[3]);
  return t;
}

inline Shape mesh(const Triangles& t, bool two_sided = false) {
  Shape shape(std::pmr::new_delete_resource());
  auto scenery = std::make_shared<Scenery>(std::pmr::new_delete_resource());
  make_mesh(t.xyz, t.index, two_sided, *scenery);
  make_scenery(scenery, shape);
  return shape;
}

/// @param height  m, of a vertex (column, row)
inline Shape height_field(std::uint32_t columns, std::uint32_t rows, double spacing_x, double spacing_z,
                          const std::function<double(std::uint32_t, std::uint32_t)>& height) {
  std::vector<double> h;
  for (std::uint32_t j = 0; j < rows; ++j)
    for (std::uint32_t i = 0; i < columns; ++i) h.push_back(height(i, j));
  Shape shape(std::pmr::new_delete_resource());
  auto scenery = std::make_shared<Scenery>(std::pmr::new_delete_resource());
  make_height_field(h, columns, rows, spacing_x, spacing_z, *scenery);
  make_scenery(scenery, shape);
  return shape;
}

}  // namespace carom::test
