// Growing a convex mesh: which facets see a point, the rim around them, and the fan that replaces them.
#include "collision/hull.h"

#include <algorithm>

#include "collision/fit_frame.h"

namespace carom {

HullMesh::Facet HullMesh::make(std::uint32_t a, std::uint32_t b, const Vec3& p, std::uint32_t v) const {
  Facet f{{a, b, v}, {kNoFacet, kNoFacet, kNoFacet}, Vec3::Zero(), 0, true};
  // The normal from the two shorter edges: the long ones of a thin triangle cancel.
  const Vec3 &pa = points_[a], &pb = points_[b];
  const Vec3 ab = pb - pa, bp = p - pb, pa_edge = pa - p;
  const Real l1 = ab.squaredNorm(), l2 = bp.squaredNorm(), l3 = pa_edge.squaredNorm();
  const Vec3 cross = l1 >= l2 && l1 >= l3 ? bp.cross(pa_edge) : l2 >= l3 ? pa_edge.cross(ab) : ab.cross(bp);
  const Real twice = cross.norm();
  f.area = twice / 2;
  // Rounding of the cross product is a few u times the product of the edges: below that its direction means nothing.
  if (twice > 64 * kUnitRoundoff * std::max({l1, l2, l3})) f.normal = cross / twice;
  return f;
}

void HullMesh::start(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  points_.assign({a, b, c, d});
  rim_at_.assign(4, 0);
  facets_.clear();
  free_.clear();
  seen_.clear();
  inner_ = (a + b + c + d) / 4;
  facets_.push_back(make(0, 2, points_[1], 1));
  facets_.push_back(make(0, 1, points_[3], 3));
  facets_.push_back(make(1, 2, points_[3], 3));
  facets_.push_back(make(2, 0, points_[3], 3));
  constexpr std::uint32_t kAcross[4][3] = {{3, 2, 1}, {0, 2, 3}, {0, 3, 1}, {0, 1, 2}};
  for (int i = 0; i < 4; ++i) std::copy_n(kAcross[i], 3, facets_[i].next);
  seen_at_.assign(4, 0);
}

std::size_t HullMesh::look(std::uint32_t seed, const Vec3& p, Real tolerance) {
  for (const std::uint32_t s : seen_)  // slots of the last removal may be used again from now on
    if (!facets_[s].alive) free_.push_back(s);
  seen_.clear();
  rim_.clear();
  next_point_ = p;
  const auto seen = [&](std::uint32_t f) { return seen_at_[f] < seen_.size() && seen_[seen_at_[f]] == f; };
  const auto add = [&](std::uint32_t f) {
    seen_at_[f] = static_cast<std::uint32_t>(seen_.size());
    seen_.push_back(f);
  };
  add(seed);
  for (std::size_t k = 0; k < seen_.size(); ++k) {
    const Facet& f = facets_[seen_[k]];
    for (const std::uint32_t g : f.next)
      // A sliver has no plane to be above or below of: it goes with its neighbour.
      if (!seen(g) && (height(g, p) > tolerance || facets_[g].normal.isZero(0))) add(g);
  }
  for (const std::uint32_t s : seen_) {
    const Facet& f = facets_[s];
    for (int i = 0; i < 3; ++i)
      if (!seen(f.next[i])) rim_.push_back({f.v[i], f.v[(i + 1) % 3], f.next[i]});
  }
  // The rim must be one loop: every vertex starts one edge, and walking comes back after all of them.
  bool simple = rim_.size() >= 3;
  for (std::uint32_t i = 0; simple && i < rim_.size(); ++i) rim_at_[rim_[i].from] = i;
  for (std::uint32_t i = 0; simple && i < rim_.size(); ++i) simple = rim_at_[rim_[i].from] == i;
  std::size_t walked = 0;
  for (std::uint32_t i = 0; simple && walked < rim_.size();) {
    ++walked;
    const std::uint32_t on = rim_at_[rim_[i].to];
    simple = on < rim_.size() && rim_[on].from == rim_[i].to;
    i = on;
    if (i == 0) break;
  }
  simple = simple && walked == rim_.size();
  const auto vertex = static_cast<std::uint32_t>(points_.size());
  for (std::size_t i = 0; simple && i < rim_.size(); ++i) {
    const Facet f = make(rim_[i].from, rim_[i].to, p, vertex);
    simple = f.normal.isZero(0) || f.normal.dot(p - inner_) > 0;
  }
  if (!simple) {
    seen_.clear();
    rim_.clear();
  }
  return rim_.size();
}

std::uint32_t HullMesh::grow() {
  const auto vertex = static_cast<std::uint32_t>(points_.size());
  points_.push_back(next_point_);
  rim_at_.push_back(0);
  created_.clear();
  for (const Edge& e : rim_) {
    std::uint32_t slot;
    if (free_.empty()) {
      slot = static_cast<std::uint32_t>(facets_.size());
      facets_.emplace_back();
      seen_at_.push_back(0);
    } else {
      slot = free_.back();
      free_.pop_back();
    }
    facets_[slot] = make(e.from, e.to, next_point_, vertex);
    facets_[slot].next[0] = e.outside;
    Facet& outside = facets_[e.outside];
    for (int i = 0; i < 3; ++i)
      if (outside.v[i] == e.to && outside.v[(i + 1) % 3] == e.from) outside.next[i] = slot;
    created_.push_back(slot);
  }
  for (std::size_t i = 0; i < rim_.size(); ++i) {
    const std::uint32_t after = rim_at_[rim_[i].to];
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
    if (height > l.height) l.height = height, l.farthest = point;
  }

 private:
  Array<std::uint32_t> next_;
  Array<List> lists_;
};

}  // namespace

bool convex_hull(std::span<const double> xyz, Array<std::uint32_t>& triangles) {
  Memory* memory = triangles.get_allocator().resource();
  const auto n = static_cast<std::uint32_t>(xyz.size() / 3);
  const auto point = [&](std::uint32_t i) { return Vec3(xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]); };
  triangles.clear();
  if (n < 4) return false;
  std::uint32_t start[4] = {0, 0, 0, 0};
  const auto far = [&](const Vec3& d, Vec3& x) {
    std::uint32_t best = 0;
    for (std::uint32_t i = 1; i < n; ++i)
      if (d.dot(point(i)) > d.dot(point(best))) best = i;
    x = point(best);
    return true;
  };
  FitFrame frame;
  if (!fit_frame(far, frame) || frame.flat) return false;
  Array<Vec3> y(n, memory);
  for (std::uint32_t i = 0; i < n; ++i) {
    y[i] = frame.map(point(i));
    for (int k = 0; k < 4; ++k)
      if (point(i) == frame.start[k]) start[k] = i;
  }
  HullMesh mesh(memory);
  mesh.start(y[start[0]], y[start[1]], y[start[2]], y[start[3]]);
  Array<std::uint32_t> index(start, start + 4, memory);  // mesh vertex -> point
  Array<std::uint32_t> waiting(memory);                  // facets that may have points outside
  OutsideLists lists(n, memory);
  const Real tolerance = std::max(frame.slack, 16 * kUnitRoundoff);
  const auto file = [&](std::uint32_t p, const Array<std::uint32_t>& facets) {
    for (const std::uint32_t f : facets) {
      const Real h = mesh.height(f, y[p]);
      if (h > tolerance) return lists.push(f, p, h);
    }
  };
  waiting.assign({0, 1, 2, 3});
  for (std::uint32_t i = 0; i < n; ++i) file(i, waiting);
  Array<std::uint32_t> loose(memory);  // points whose facet has gone
  for (std::size_t k = 0; k < waiting.size(); ++k) {
    const std::uint32_t f = waiting[k];
    while (mesh.facet(f).alive && lists.of(f).farthest != OutsideLists::kEnd) {
      const std::uint32_t p = lists.of(f).farthest;
      if (mesh.look(f, y[p], tolerance) == 0) {  // p is on the surface to rounding: strike it off and take the next
        OutsideLists::List old = lists.of(f);
        lists.of(f) = {};
        for (std::uint32_t q = old.head, after; q != OutsideLists::kEnd; q = after) {
          after = lists.next(q);
          if (q != p) lists.push(f, q, mesh.height(f, y[q]));
        }
        continue;
      }
      mesh.grow();
      index.push_back(p);
      loose.clear();
      for (const std::uint32_t r : mesh.removed()) {
        for (std::uint32_t q = lists.of(r).head; q != OutsideLists::kEnd; q = lists.next(q))
          if (q != p) loose.push_back(q);
        lists.of(r) = {};
      }
      for (const std::uint32_t c : mesh.created()) lists.of(c) = {};
      for (const std::uint32_t q : loose) file(q, mesh.created());
      for (const std::uint32_t c : mesh.created())
        if (lists.of(c).farthest != OutsideLists::kEnd) waiting.push_back(c);
    }
  }
  for (std::uint32_t f = 0; f < mesh.slots(); ++f)
    if (mesh.facet(f).alive)
      for (const std::uint32_t v : mesh.facet(f).v) triangles.push_back(index[v]);
  return true;
}

}  // namespace carom
