// Triangles of a hull gathered into faces: the largest first, each taking the neighbours that lie in its plane.
#include "collision/hull_faces.h"

#include <algorithm>
#include <numeric>

#include "collision/hull.h"
#include "collision/shape.h"
#include "core/invalid.h"

namespace carom::collision {
namespace {

constexpr Real kSamePlane = 1e-9;  // of the extent
// Of the largest coordinate: points of a file in single precision are off by half of their last place each, and so are
// the three that name a face's plane; four times that for planes that reach beyond their three.
constexpr Real kSamePlaneInFloats = 8 * 0x1p-24;
constexpr Real kStraight = 1e-6;  // rad
// Of the extent: a triangle lower than this has no normal to speak of (u / 1e-7 is what rounding turns it by), and
// opens no face.
constexpr Real kSliver = 1e-7;

/// An edge of a triangle, sorted so that the two directions of it stand side by side.
struct Edge {
  std::uint32_t lo, hi, triangle, side;
};

/// Whether points hold no more than single precision does.
bool are_floats(std::span<const double> xyz) {
  return std::ranges::all_of(xyz, [](double x) { return static_cast<double>(static_cast<float>(x)) == x; });
}

class Gatherer {
 public:
  Gatherer(std::span<const double> xyz, const Array<std::uint32_t>& triangles, HullFaces& faces)
      : xyz_(xyz),
        tri_(triangles),
        faces_(faces),
        across_(triangles.size(), kInvalid, triangles.get_allocator()),
        face_(triangles.size() / 3, kInvalid, triangles.get_allocator()),
        next_(xyz.size() / 3, kInvalid, triangles.get_allocator()),
        stack_(triangles.get_allocator()) {}

  void run() {
    join();
    Array<std::uint32_t> order(face_.size(), 0, face_.get_allocator());
    std::iota(order.begin(), order.end(), 0u);
    Array<Real> area(face_.size(), 0, face_.get_allocator());
    for (std::uint32_t t = 0; t < area.size(); ++t) area[t] = cross(t).norm();
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t s, std::uint32_t t) { return area[s] > area[t] || (area[s] == area[t] && s < t); });
    Vec3 lo = point(tri_[0]), hi = lo;
    for (const std::uint32_t v : tri_) lo = lo.min(point(v)), hi = hi.max(point(v));
    const Real extent = (hi - lo).max_entry();
    const Real largest = lo.abs().max(hi.abs()).max_entry();
    tolerance_ = std::max(kSamePlane * extent, are_floats(xyz_) ? kSamePlaneInFloats * largest : Real(0));
    faces_.begin.push_back(0);
    for (const std::uint32_t t : order)
      if (face_[t] == kInvalid && area[t] > kSliver * extent * longest(t)) grow(t, cross(t) / area[t]);
  }

 private:
  Vec3 point(std::uint32_t v) const { return Vec3(xyz_[3 * v], xyz_[3 * v + 1], xyz_[3 * v + 2]); }
  Vec3 cross(std::uint32_t t) const {
    const Vec3 a = point(tri_[3 * t]), b = point(tri_[3 * t + 1]), c = point(tri_[3 * t + 2]);
    return (b - a).cross(c - a);
  }

  Real longest(std::uint32_t t) const {
    const Vec3 a = point(tri_[3 * t]), b = point(tri_[3 * t + 1]), c = point(tri_[3 * t + 2]);
    return std::sqrt(std::max({(b - a).squared_norm(), (c - b).squared_norm(), (a - c).squared_norm()}));
  }

  /// Which triangle lies across each edge.
  void join() {
    Array<Edge> edges(tri_.get_allocator());
    edges.reserve(tri_.size());
    for (std::uint32_t e = 0; e < tri_.size(); ++e) {
      const std::uint32_t t = e / 3, u = tri_[e], v = tri_[3 * t + (e + 1) % 3];
      edges.push_back({std::min(u, v), std::max(u, v), t, e});
    }
    std::sort(edges.begin(), edges.end(), [](const Edge& p, const Edge& q) {
      return p.lo != q.lo ? p.lo < q.lo : p.hi != q.hi ? p.hi < q.hi : p.side < q.side;
    });
    for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
      if (edges[i].lo != edges[i + 1].lo || edges[i].hi != edges[i + 1].hi) continue;
      across_[edges[i].side] = edges[i + 1].triangle;
      across_[edges[i + 1].side] = edges[i].triangle;
    }
  }

  /// One face from its largest triangle.
  void grow(std::uint32_t seed, const Vec3& normal) {
    const auto id = static_cast<std::uint32_t>(faces_.count());
    const Vec3 at = point(tri_[3 * seed]);
    const auto in_plane = [&](std::uint32_t t) {
      for (std::uint32_t k = 0; k < 3; ++k)
        if (!(std::fabs(normal.dot(point(tri_[3 * t + k]) - at)) <= tolerance_)) return false;
      return true;
    };
    face_[seed] = id;
    stack_.assign(1, seed);
    for (std::size_t i = 0; i < stack_.size(); ++i)
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t t = across_[3 * stack_[i] + k];
        if (t == kInvalid || face_[t] != kInvalid || !in_plane(t)) continue;
        face_[t] = id;
        stack_.push_back(t);
      }
    if (!outline(id)) return;
    Real twice = 0;
    for (const std::uint32_t t : stack_) twice += cross(t).norm();
    faces_.normal.push_back(normal);
    faces_.area.push_back(twice / 2);
    faces_.begin.push_back(static_cast<std::uint32_t>(faces_.loop.size()));
  }

  /// The boundary of the triangles in stack_, appended to the loops. @return false, and nothing appended, if it is no
  /// loop
  bool outline(std::uint32_t id) {
    std::uint32_t first = kInvalid;
    std::size_t sides = 0;
    bool simple = true;
    for (const std::uint32_t t : stack_)
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t other = across_[3 * t + k];
        if (other != kInvalid && face_[other] == id) continue;
        const std::uint32_t v = tri_[3 * t + k];
        simple &= next_[v] == kInvalid;
        next_[v] = tri_[3 * t + (k + 1) % 3];
        first = v, ++sides;
      }
    const std::size_t start = faces_.loop.size();
    if (simple && sides > 2) {
      std::uint32_t before = first, v = next_[first];
      for (std::size_t i = 0; i < sides && v != kInvalid; ++i) {
        const std::uint32_t after = next_[v];
        if (after == kInvalid) break;
        const Vec3 in = point(v) - point(before), out = point(after) - point(v);
        if (in.cross(out).norm() > kStraight * in.norm() * out.norm()) faces_.loop.push_back(v), before = v;
        v = after;
      }
      simple = v == next_[first];
    }
    for (const std::uint32_t t : stack_)
      for (std::uint32_t k = 0; k < 3; ++k) next_[tri_[3 * t + k]] = kInvalid;
    if (simple && faces_.loop.size() - start > 2) return true;
    faces_.loop.resize(start);
    for (const std::uint32_t t : stack_) face_[t] = kInvalid - 1;  // taken, by no face
    return false;
  }

  std::span<const double> xyz_;
  const Array<std::uint32_t>& tri_;
  HullFaces& faces_;
  Array<std::uint32_t> across_;  // by edge
  Array<std::uint32_t> face_;    // by triangle
  Array<std::uint32_t> next_;    // by vertex: the next one along the boundary
  Array<std::uint32_t> stack_;
  Real tolerance_ = 0;
};

/// Which faces look the same way as another one: of two that do, normals differ by less than kSameWay along x.
void find_alike(HullFaces& faces) {
  const Array<Vec3>& normal = faces.normal;
  Array<std::uint32_t> order(normal.size(), 0, faces.loop.get_allocator());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t i, std::uint32_t k) { return normal[i].x() < normal[k].x(); });
  faces.has_alike.assign(normal.size(), 0);
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t k = i + 1; k < order.size() && normal[order[k]].x() - normal[order[i]].x() <= HullFaces::kSameWay;
         ++k)
      if (faces.look_alike(order[i], order[k])) faces.has_alike[order[i]] = faces.has_alike[order[k]] = true;
}

}  // namespace

void make_hull_faces(std::span<const double> xyz, HullFaces& faces) {
  faces.normal.clear(), faces.area.clear(), faces.begin.clear(), faces.loop.clear(), faces.own.clear();
  Array<std::uint32_t> triangles(faces.loop.get_allocator());
  if (convex_hull(xyz, triangles) && !triangles.empty()) Gatherer(xyz, triangles, faces).run();
  find_alike(faces);
}

void make_box_faces(const Vec3& half, HullFaces& faces) {
  faces.normal.clear(), faces.area.clear(), faces.begin.clear(), faces.loop.clear(), faces.own.clear();
  for (int c = 0; c < 8; ++c)
    for (int k = 0; k < 3; ++k) faces.own.push_back(c >> k & 1 ? half[k] : -half[k]);
  faces.begin.push_back(0);
  for (int k = 0; k < 3; ++k)
    for (const int side : {0, 1}) {
      const int u = 1 << (k + 1) % 3, v = 1 << (k + 2) % 3, base = side << k;
      const int around[4] = {base, base | u, base | u | v, base | v};  // counter-clockwise about +k
      for (int i = 0; i < 4; ++i) faces.loop.push_back(static_cast<std::uint32_t>(around[side ? i : 3 - i]));
      faces.normal.push_back((side ? 1 : -1) * Vec3::unit(k));
      faces.area.push_back(4 * half[(k + 1) % 3] * half[(k + 2) % 3]);
      faces.begin.push_back(static_cast<std::uint32_t>(faces.loop.size()));
    }
  find_alike(faces);
}

void make_faces(Shape& shape) {
  if (shape.form == Form::polytope) make_hull_faces(shape.vertices, shape.faces);
  if (shape.form == Form::box) make_box_faces(shape.half, shape.faces);
}

}  // namespace carom::collision
