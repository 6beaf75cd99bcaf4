// A height field: vertices on a grid, two triangles to a cell, which are made when they are asked for.
#include <algorithm>
#include <numeric>

#include "collision/scenery/scenery.h"

namespace carom::collision {

void make_height_field(std::span<const double> heights, std::uint32_t columns, std::uint32_t rows, Real spacing_x,
                       Real spacing_z, Scenery& s) {
  Memory* const memory = s.vertex.get_allocator().resource();
  s.columns = columns, s.rows = rows;
  s.spacing_x = spacing_x, s.spacing_z = spacing_z;
  s.heights.assign(heights.begin(), heights.end());
  const std::uint32_t across = (columns - 2) / Scenery::kBlock + 1, down = (rows - 2) / Scenery::kBlock + 1;
  Array<Aabb> boxes(std::size_t(across) * down, memory);
  Array<std::uint32_t> leaves(memory);
  leaves.reserve(boxes.size());
  s.bounds = Aabb();
  for (std::uint32_t b = 0; b < boxes.size(); ++b) {
    Aabb& box = boxes[b];
    s.each_of_block(b, [&](std::uint32_t index) {
      const Aabb own = s.field_bounds(index);  // of a hole: nothing
      box.lo = box.lo.min(own.lo), box.hi = box.hi.max(own.hi);
    });
    if (!(box.lo.x() <= box.hi.x())) continue;  // nothing but holes
    leaves.push_back(b);
    s.bounds.lo = s.bounds.lo.min(box.lo), s.bounds.hi = s.bounds.hi.max(box.hi);
  }
  s.tree.build(leaves, boxes);
  s.tree.close();
}

Aabb Scenery::field_bounds(std::uint32_t index) const {
  Aabb box;
  std::array<Vec3, 3> c;
  if (!field_corners(index, c)) return box;
  box.lo = c[0].min(c[1]).min(c[2]), box.hi = c[0].max(c[1]).max(c[2]);
  return box;
}

bool Scenery::field_corners(std::uint32_t index, std::array<Vec3, 3>& c) const {
  const std::uint32_t cell = index / 2, x = cell % (columns - 1), z = cell / (columns - 1);
  // A hole takes the whole cell: a single triangle of it would have a boundary edge that no user drew.
  const double* const h = &heights[std::size_t(z) * columns + x];
  if (!std::isfinite(h[0]) || !std::isfinite(h[1]) || !std::isfinite(h[columns]) || !std::isfinite(h[columns + 1]))
    return false;
  c[0] = place(x, z);
  c[1] = index % 2 == 0 ? place(x, z + 1) : place(x + 1, z + 1);
  c[2] = index % 2 == 0 ? place(x + 1, z + 1) : place(x + 1, z);
  return true;
}

bool Scenery::triangle_over(const Vec3& point, Triangle& out) const {
  const Real u = point.x() / spacing_x, v = point.z() / spacing_z;
  if (!is_field() || !(u >= 0 && v >= 0 && u < columns - 1 && v < rows - 1)) return false;
  const auto x = static_cast<std::uint32_t>(u), z = static_cast<std::uint32_t>(v);
  return triangle(2 * (z * (columns - 1) + x) + (u - x > v - z), out);
}

bool Scenery::is_over(std::uint32_t index, const Vec3& point) const {
  constexpr Real kOnSide = 1e-9;  // of a cell: rounding of a point, and far more
  const std::uint32_t x = index / 2 % (columns - 1), z = index / 2 / (columns - 1);
  const Real u = point.x() / spacing_x - x, v = point.z() / spacing_z - z;
  const Real far = index % 2 == 0 ? v : u, near = index % 2 == 0 ? u : v;
  return near >= -kOnSide && far <= 1 + kOnSide && near <= far + kOnSide;
}

bool Scenery::field_triangle(std::uint32_t index, Triangle& out) const {
  if (!field_corners(index, out.corner)) return false;
  out.normal = (out.corner[1] - out.corner[0]).cross(out.corner[2] - out.corner[0]).normalized();
  const std::int64_t cells = columns - 1;
  const std::int64_t x = index / 2 % cells, z = index / 2 / cells;
  const bool first = index % 2 == 0;
  // Across each side: which cell, whose other half shares the side, and which of its vertices is not on it.
  struct Beyond {
    int cell_x, cell_z, far_x, far_z;  // of this cell
  };
  static constexpr Beyond kOfFirst[3] = {{-1, 0, -1, 0}, {0, 1, 1, 2}, {0, 0, 1, 0}};
  static constexpr Beyond kOfSecond[3] = {{0, 0, 0, 1}, {1, 0, 2, 1}, {0, -1, 0, -1}};
  for (std::size_t k = 0; k < 3; ++k) {
    const Beyond& b = first ? kOfFirst[k] : kOfSecond[k];
    const std::int64_t cx = x + b.cell_x, cz = z + b.cell_z;
    std::array<Vec3, 3> other;
    out.boundary[k] = cx < 0 || cz < 0 || cx >= cells || cz >= std::int64_t(rows) - 1 ||
                      !field_corners(static_cast<std::uint32_t>(2 * (cz * cells + cx)), other);
    out.far[k] = out.boundary[k]
                     ? out.corner[k]
                     : place(static_cast<std::uint32_t>(x + b.far_x), static_cast<std::uint32_t>(z + b.far_z));
  }
  return true;
}

}  // namespace carom::collision
