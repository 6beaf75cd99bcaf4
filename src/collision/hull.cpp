// Growing a convex mesh: which facets see a point, the horizon around them, and the fan that replaces them.
#include "collision/hull.h"

#include <algorithm>

#include "core/int128.h"

namespace carom::collision {

// Differences of grid points are 54-bit integers, their 2 x 2 minors fit 110 bits, and a row times the minors is summed
// in two halves of 64 bits.
int HullMesh::orientation(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& x) {
  const auto whole = [&p](const Vec3& v, int i) { return static_cast<std::int64_t>((v[i] - p[i]) / kGrid); };
  Int128 high = 0, low = 0;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const Int128 minor =
        static_cast<Int128>(whole(q, j)) * whole(r, k) - static_cast<Int128>(whole(q, k)) * whole(r, j);
    const std::int64_t along = whole(x, i);
    high += (minor >> 64) * along;
    low += static_cast<Int128>(static_cast<std::uint64_t>(minor)) * along;
  }
  high += low >> 64;
  return high > 0 || (high == 0 && static_cast<std::uint64_t>(low) != 0) ? 1 : high < 0 ? -1 : 0;
}

HullMesh::Facet HullMesh::make(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
  const Vec3 u = points_[b] - points_[a], v = points_[c] - points_[a];  // exact
  Facet f{{a, b, c}, {kNoFacet, kNoFacet, kNoFacet}, u.cross(v), Vec3::zero(), 0, true};
  // Each component of the cross product is two products and a difference, of terms no larger than |u_j v_k| + |u_k
  // v_j|; three more products and sums follow in cross . x: 3 u + 3 u of all terms together, doubled for safety.
  const Vec3 s = u.abs(), t = v.abs();
  const Real terms = s.x() * (t.y() + t.z()) + s.y() * (t.z() + t.x()) + s.z() * (t.x() + t.y());
  f.noise = 12 * kUnitRoundoff * terms;
  const Real twice = f.cross.norm();
  if (twice > 16 * f.noise) f.normal = f.cross / twice;
  return f;
}

void HullMesh::start(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  for (Vec3* p : {&a, &b, &c, &d}) *p = snap(*p);
  if (orientation(a, b, c, d) < 0) std::swap(a, b);
  points_.assign({a, b, c, d});
  horizon_at_.assign(4, 0);
  seen_at_.assign(4, 0);
  facets_.assign({make(0, 2, 1), make(0, 1, 3), make(1, 2, 3), make(2, 0, 3)});
  constexpr std::uint32_t kAcross[4][3] = {{3, 2, 1}, {0, 2, 3}, {0, 3, 1}, {0, 1, 2}};
  for (int i = 0; i < 4; ++i) std::copy_n(kAcross[i], 3, facets_[i].next);
  free_.clear();
  seen_.clear();
  inner_ = snap((a + b + c + d) / 4);
}

bool HullMesh::sees(std::uint32_t facet, const Vec3& p) const {
  const Facet& f = facets_[facet];
  const Vec3 x = snap(p) - points_[f.v[0]];
  const Real volume = f.cross.dot(x);
  if (std::fabs(volume) > f.noise * x.abs().max_entry()) return volume > 0;
  return orientation(points_[f.v[0]], points_[f.v[1]], points_[f.v[2]], snap(p)) > 0;
}

std::size_t HullMesh::look(std::uint32_t seed, const Vec3& p, Real tolerance) {
  for (const std::uint32_t s : seen_)  // slots of the last removal may be used again from now on
    if (!facets_[s].alive) free_.push_back(s);
  seen_.clear();
  horizon_.clear();
  next_point_ = snap(p);
  const auto known = [&](std::uint32_t f) { return seen_at_[f] < seen_.size() && seen_[seen_at_[f]] == f; };
  const auto add = [&](std::uint32_t f) {
    seen_at_[f] = static_cast<std::uint32_t>(seen_.size());
    seen_.push_back(f);
  };
  const auto in_sight = [&](std::uint32_t f) {
    if (tolerance == 0) return sees(f, next_point_);
    return facets_[f].normal.is_zero() || height(f, next_point_) > tolerance;  // a sliver goes with its neighbour
  };
  add(seed);
  for (std::size_t k = 0; k < seen_.size(); ++k)
    for (const std::uint32_t g : facets_[seen_[k]].next)
      if (!known(g) && in_sight(g)) add(g);
  for (const std::uint32_t s : seen_)
    for (int i = 0; i < 3; ++i)
      if (!known(facets_[s].next[i]))
        horizon_.push_back({facets_[s].v[i], facets_[s].v[(i + 1) % 3], facets_[s].next[i]});
  for (std::uint32_t i = 0; i < horizon_.size(); ++i) horizon_at_[horizon_[i].from] = i;
  if (tolerance > 0 && !horizon_is_sound(next_point_)) {
    seen_.clear();
    horizon_.clear();
  }
  return horizon_.size();
}

/// One loop, in which every vertex starts one edge, and no new facet that faces the inner point. Exact calls give
/// nothing else. (A point coplanar with a facet that stays makes a neighbour in its plane; never one without area, for
/// it would have to lie on an edge of a facet that sees it.)
bool HullMesh::horizon_is_sound(const Vec3& p) const {
  const auto n = static_cast<std::uint32_t>(horizon_.size());
  for (std::uint32_t i = 0; i < n; ++i)
    if (horizon_at_[horizon_[i].from] != i ||
        orientation(points_[horizon_[i].from], points_[horizon_[i].to], p, inner_) >= 0)
      return false;
  std::uint32_t walked = 0, i = 0;
  do {
    const std::uint32_t on = horizon_at_[horizon_[i].to];
    if (on >= n || horizon_[on].from != horizon_[i].to) return false;
    i = on;
    ++walked;
  } while (i != 0 && walked < n);
  return i == 0 && walked == n;
}

std::uint32_t HullMesh::grow() {
  const auto vertex = static_cast<std::uint32_t>(points_.size());
  points_.push_back(next_point_);
  horizon_at_.push_back(0);
  created_.clear();
  for (const Edge& e : horizon_) {
    std::uint32_t slot;
    if (free_.empty()) {
      slot = static_cast<std::uint32_t>(facets_.size());
      facets_.emplace_back();
      seen_at_.push_back(0);
    } else {
      slot = free_.back();
      free_.pop_back();
    }
    facets_[slot] = make(e.from, e.to, vertex);
    facets_[slot].next[0] = e.outside;
    Facet& outside = facets_[e.outside];
    for (int i = 0; i < 3; ++i)
      if (outside.v[i] == e.to && outside.v[(i + 1) % 3] == e.from) outside.next[i] = slot;
    created_.push_back(slot);
  }
  for (std::size_t i = 0; i < horizon_.size(); ++i) {
    const std::uint32_t after = horizon_at_[horizon_[i].to];
    facets_[created_[i]].next[1] = created_[after];
    facets_[created_[after]].next[2] = created_[i];
  }
  for (const std::uint32_t s : seen_) facets_[s].alive = false;
  return vertex;
}

namespace {

/// The points outside each facet, in linked lists, the farthest of each known.
class OutsideLists {
 public:
  OutsideLists(std::size_t points, Memory* memory) : next_(points, kEnd, memory), lists_(memory) {}
  static constexpr std::uint32_t kEnd = 0xFFFFFFFFu;

  struct List {
    std::uint32_t head = kEnd, farthest = kEnd;
    Real height = 0;
  };
  List& of(std::uint32_t facet) {
    if (lists_.size() <= facet) lists_.resize(facet + 1);
    return lists_[facet];
  }
  std::uint32_t next(std::uint32_t point) const { return next_[point]; }
  void push(std::uint32_t facet, std::uint32_t point, Real height) {
    List& l = of(facet);
    next_[point] = l.head;
    l.head = point;
    if (l.farthest == kEnd || height > l.height) l.height = height, l.farthest = point;
  }

 private:
  Array<std::uint32_t> next_;
  Array<List> lists_;
};

}  // namespace

bool convex_hull_on_grid(std::span<const Vec3> y, const std::uint32_t start[4], Array<std::uint32_t>& triangles) {
  Memory* memory = triangles.get_allocator().resource();
  const auto n = static_cast<std::uint32_t>(y.size());
  triangles.clear();
  if (HullMesh::orientation(y[start[0]], y[start[1]], y[start[2]], y[start[3]]) == 0) return false;
  HullMesh mesh(memory);
  mesh.start(y[start[0]], y[start[1]], y[start[2]], y[start[3]]);
  Array<std::uint32_t> index(4, memory);  // mesh vertex -> point
  for (std::uint32_t v = 0; v < 4; ++v)
    for (int k = 0; k < 4; ++k)
      if (mesh.point(v) == y[start[k]]) index[v] = start[k];
  Array<std::uint32_t> waiting({0, 1, 2, 3}, memory);  // facets that may have points outside
  OutsideLists lists(n, memory);
  const auto file = [&](std::uint32_t p, const Array<std::uint32_t>& facets) {
    for (const std::uint32_t f : facets)
      if (mesh.sees(f, y[p])) return lists.push(f, p, mesh.height(f, y[p]));
  };
  for (std::uint32_t i = 0; i < n; ++i) file(i, waiting);
  Array<std::uint32_t> loose(memory);  // points whose facet has gone
  for (std::size_t k = 0; k < waiting.size(); ++k) {
    const std::uint32_t f = waiting[k];
    if (!mesh.facet(f).alive || lists.of(f).farthest == OutsideLists::kEnd) continue;
    const std::uint32_t p = lists.of(f).farthest;
    mesh.look(f, y[p]);
    mesh.grow();
    index.push_back(p);
    loose.clear();
    for (const std::uint32_t r : mesh.removed()) {
      for (std::uint32_t q = lists.of(r).head; q != OutsideLists::kEnd; q = lists.next(q))
        if (q != p) loose.push_back(q);
      lists.of(r) = {};
    }
    for (const std::uint32_t q : loose) file(q, mesh.created());
    for (const std::uint32_t c : mesh.created())
      if (lists.of(c).farthest != OutsideLists::kEnd) waiting.push_back(c);
  }
  for (std::uint32_t f = 0; f < mesh.slots(); ++f)
    if (mesh.facet(f).alive)
      for (const std::uint32_t v : mesh.facet(f).v) triangles.push_back(index[v]);
  return true;
}

FitFrame fit_frame_of_points(std::span<const double> xyz) {
  const auto far = [&](const Vec3& d, Vec3& x) {
    std::size_t best = 0;
    for (std::size_t k = 3; k + 3 <= xyz.size(); k += 3)
      if (d.dot(Vec3(xyz[k], xyz[k + 1], xyz[k + 2])) > d.dot(Vec3(xyz[best], xyz[best + 1], xyz[best + 2]))) best = k;
    x = Vec3(xyz[best], xyz[best + 1], xyz[best + 2]);
    return true;
  };
  FitFrame frame;
  fit_frame(far, frame);
  return frame;
}

bool convex_hull(std::span<const double> xyz, Array<std::uint32_t>& triangles, FitFrame* frame_out) {
  const auto n = static_cast<std::uint32_t>(xyz.size() / 3);
  const auto point = [&](std::uint32_t i) { return Vec3(xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]); };
  triangles.clear();
  if (n < 4) return false;
  const FitFrame frame = fit_frame_of_points(xyz);
  if (frame.flat) return false;
  if (frame_out != nullptr) *frame_out = frame;
  std::uint32_t start[4] = {0, 0, 0, 0};
  Array<Vec3> y(n, triangles.get_allocator().resource());
  for (std::uint32_t i = 0; i < n; ++i) {
    y[i] = frame.map(point(i));
    if (!HullMesh::in_range(y[i])) return false;  // not finite
    y[i] = HullMesh::snap(y[i]);
    for (int k = 0; k < 4; ++k)
      if (point(i) == frame.start[k]) start[k] = i;
  }
  return convex_hull_on_grid(y, start, triangles);
}

}  // namespace carom::collision
