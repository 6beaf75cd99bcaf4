// A mesh made ready: corners at one place made one, neighbours found by their sides, a tree of all triangles.
#include <algorithm>
#include <numeric>

#include "collision/scenery/scenery.h"

namespace carom::collision {
namespace {

constexpr int kNextCorner[3] = {1, 2, 0};
// A triangle whose least height is below this share of its longest side has no normal to speak of: rounding of its
// corners alone turns it by a tenth of a milliradian.
constexpr Real kThin = 1e-12;
// Triangles around a corner that are walked: a fan of more is taken for one that falls away nowhere.
constexpr int kMostAround = 256;

/// Corners at the same place become one. @return by the host's index: which of scenery.vertex it is
Array<std::uint32_t> weld(std::span<const double> xyz, Array<Vec3>& vertex, Memory* memory) {
  const std::size_t n = xyz.size() / 3;
  Array<Vec3> at(memory);
  at.reserve(n);
  for (std::size_t i = 0; i < n; ++i)  // -0 becomes 0
    at.emplace_back(xyz[3 * i] + 0.0, xyz[3 * i + 1] + 0.0, xyz[3 * i + 2] + 0.0);
  Array<std::uint32_t> order(n, memory), name(n, memory);
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    for (int k = 0; k < 3; ++k)
      if (at[i][k] != at[j][k]) return at[i][k] < at[j][k];
    return i < j;
  });
  Array<std::uint32_t> first(n, memory);  // the host's first index of that place
  for (std::size_t i = 0; i < n; ++i) {
    const bool same = i > 0 && at[order[i]] == at[order[i - 1]];
    first[order[i]] = same ? first[order[i - 1]] : order[i];
  }
  vertex.clear();
  for (std::uint32_t i = 0; i < n; ++i) {  // in the host's order: near ones stay near
    if (first[i] != i) continue;
    name[i] = static_cast<std::uint32_t>(vertex.size());
    vertex.push_back(at[i]);
  }
  for (std::uint32_t i = 0; i < n; ++i) name[i] = name[first[i]];
  return name;
}

bool has_area(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Real longest2 = std::max({(b - a).squared_norm(), (c - b).squared_norm(), (a - c).squared_norm()});
  return (b - a).cross(c - a).norm() > kThin * longest2;
}

/// Two triangles that have a side in common know each other; where three or more do, none does.
void find_neighbours(Scenery& s, Memory* memory) {
  struct Side {
    std::uint32_t low, high, at;
    bool operator<(const Side& o) const {
      return low != o.low ? low < o.low : high != o.high ? high < o.high : at < o.at;
    }
  };
  Array<Side> sides(memory);
  sides.reserve(s.corner.size());
  for (std::uint32_t at = 0; at < s.corner.size(); ++at) {
    const std::uint32_t a = s.corner[at], b = s.corner[at - at % 3 + static_cast<std::uint32_t>(kNextCorner[at % 3])];
    sides.push_back({std::min(a, b), std::max(a, b), at});
  }
  std::sort(sides.begin(), sides.end());
  s.beyond.assign(s.corner.size(), kInvalid);
  for (std::size_t i = 0, j; i < sides.size(); i = j) {
    for (j = i; j < sides.size() && sides[j].low == sides[i].low && sides[j].high == sides[i].high;) ++j;
    if (j - i != 2) continue;
    s.beyond[sides[i].at] = sides[i + 1].at / 3;
    s.beyond[sides[i + 1].at] = sides[i].at / 3;
  }
}

}  // namespace

void make_mesh(std::span<const double> xyz, std::span<const std::uint32_t> triangles, bool two_sided, Scenery& s) {
  Memory* const memory = s.vertex.get_allocator().resource();
  s.two_sided = two_sided;
  const Array<std::uint32_t> name = weld(xyz, s.vertex, memory);
  s.corner.clear();
  s.corner.reserve(triangles.size());
  for (std::size_t t = 0; t + 3 <= triangles.size(); t += 3) {
    const std::uint32_t a = name[triangles[t]], b = name[triangles[t + 1]], c = name[triangles[t + 2]];
    if (has_area(s.vertex[a], s.vertex[b], s.vertex[c]))
      s.corner.insert(s.corner.end(), {a, b, c});
    else
      ++s.dropped;
  }
  find_neighbours(s, memory);
  const std::uint32_t n = s.triangles();
  Array<Aabb> boxes(n, memory);
  Array<std::uint32_t> leaves(n, memory);
  std::iota(leaves.begin(), leaves.end(), 0u);
  s.bounds = Aabb();
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const Vec3& x = s.vertex[s.corner[3 * i + k]];
      boxes[i].lo = boxes[i].lo.min(x), boxes[i].hi = boxes[i].hi.max(x);
    }
    s.bounds.lo = s.bounds.lo.min(boxes[i].lo), s.bounds.hi = s.bounds.hi.max(boxes[i].hi);
  }
  s.tree.build(leaves, boxes);
  s.tree.close();
}

bool Scenery::triangle(std::uint32_t index, Triangle& out) const {
  out.index = index;
  if (is_field()) return field_triangle(index, out);
  const std::uint32_t* const c = &corner[3 * std::size_t(index)];
  for (std::size_t k = 0; k < 3; ++k) out.corner[k] = vertex[c[k]];
  out.normal = (out.corner[1] - out.corner[0]).cross(out.corner[2] - out.corner[0]).normalized();
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t other = beyond[3 * std::size_t(index) + k];
    out.boundary[k] = other == kInvalid;
    out.far[k] = out.corner[k];
    if (out.boundary[k]) continue;
    const std::uint32_t from = c[k], to = c[kNextCorner[k]];
    for (std::size_t m = 0; m < 3; ++m) {
      const std::uint32_t v = corner[3 * std::size_t(other) + m];
      if (v != from && v != to) out.far[k] = vertex[v];
    }
  }
  return true;
}

template <class F>
bool Scenery::all_around(const Triangle& p, int k, F&& f) const {
  std::array<Vec3, 3> c;
  if (is_field()) {
    const Vec3& centre = p.corner[static_cast<std::size_t>(p.turned ? (3 - k) % 3 : k)];
    // The vertex in steps, from its place; of the cells around it those triangles that have it for a corner.
    const auto column = static_cast<std::int64_t>(std::llround(centre.x() / spacing_x));
    const auto row = static_cast<std::int64_t>(std::llround(centre.z() / spacing_z));
    const std::int64_t cells = columns - 1;
    for (std::int64_t z = std::max<std::int64_t>(row - 1, 0); z <= std::min<std::int64_t>(row, rows - 2); ++z)
      for (std::int64_t x = std::max<std::int64_t>(column - 1, 0); x <= std::min(column, cells - 1); ++x)
        for (std::int64_t half = 0; half < 2; ++half)
          if (field_corners(static_cast<std::uint32_t>(2 * (z * cells + x) + half), c) &&
              std::find(c.begin(), c.end(), centre) != c.end() && !f(c))
            return false;
    return true;
  }
  const std::uint32_t v = corner[3 * std::size_t(p.index) + static_cast<std::size_t>(k)];
  // Both ways around, until a boundary edge or back at the start.
  for (int way = 0; way < 2; ++way) {
    std::uint32_t at = p.index, came_by = 3;  // side
    for (int steps = 0;; ++steps) {
      const std::uint32_t* const name = &corner[3 * std::size_t(at)];
      for (std::size_t m = 0; m < 3; ++m) c[m] = vertex[name[m]];
      if (!f(c)) return false;
      std::uint32_t j = 0;
      while (name[j] != v) ++j;
      const std::uint32_t sides[2] = {j, (j + 2) % 3};
      const std::uint32_t leave = came_by == 3 ? sides[way] : sides[0] == came_by ? sides[1] : sides[0];
      const std::uint32_t next = beyond[3 * std::size_t(at) + leave];
      if (next == kInvalid || steps == kMostAround) break;
      if (next == p.index) return true;
      const std::uint32_t a = name[leave], b = name[kNextCorner[leave]];
      const std::uint32_t* const d = &corner[3 * std::size_t(next)];
      came_by = 0;
      while (!((d[came_by] == a && d[kNextCorner[came_by]] == b) || (d[came_by] == b && d[kNextCorner[came_by]] == a)))
        ++came_by;
      at = next;
    }
  }
  return true;
}

bool Scenery::falls_away_around(const Triangle& p, int k, const Vec3& n) const {
  constexpr Real kLevel = 1e-7;  // of the length of a side: what rounding of a normal lifts its end by, and far more
  const Vec3& centre = p.corner[static_cast<std::size_t>(p.turned ? (3 - k) % 3 : k)];
  return all_around(p, k, [&](const std::array<Vec3, 3>& c) {
    return std::none_of(c.begin(), c.end(),
                        [&](const Vec3& x) { return (x - centre).dot(n) > kLevel * (x - centre).norm(); });
  });
}

bool Scenery::is_before_all_around(const Triangle& p, int k, const Vec3& point) const {
  return all_around(p, k, [&](const std::array<Vec3, 3>& c) {
    const Real height = (c[1] - c[0]).cross(c[2] - c[0]).dot(point - c[0]);
    return p.turned ? height <= 0 : height >= 0;
  });
}

}  // namespace carom::collision
