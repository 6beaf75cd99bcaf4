// Faces, heap and horizon of the polytope that EPA grows.
#include "collision/narrow/polytope.h"

#include <algorithm>

#include "collision/narrow/simplex_geometry.h"

namespace carom {

namespace {

constexpr int kNext[3] = {1, 2, 0};

}  // namespace

/// Normal and offset of a face. From two edges at one vertex if they enclose an angle whose sine is above 1/32: the
/// normal then errs by 32 u at most, and the offset, taken at the vertices, is a proof whatever the normal.
inline void Polytope::place(Face& f) const {
  constexpr Real kWide2 = 0x1p-10;
  const Vec3 &a = points_[f.vertex[0]].w, &b = points_[f.vertex[1]].w, &c = points_[f.vertex[2]].w;
  const Vec3 ab = b - a, ac = c - a, n = ab.cross(ac);
  const Real n2 = n.squaredNorm(), ab2 = ab.squaredNorm(), ac2 = ac.squaredNorm();
  // Twice the area over the longest edge, which is below sqrt(2 (ab2 + ac2)), is the height.
  if (n2 > kWide2 * (ab2 * ac2) && n2 > rounding_ * rounding_ * (ab2 + ac2)) {
    f.normal = n * (1 / std::sqrt(n2));
  } else {
    f.normal = careful_normal(a, b, c);
  }
  f.offset = std::min(std::min(f.normal.dot(a), f.normal.dot(b)), f.normal.dot(c));
}

/// A thin face's. One without area (its normal is not known to the sense) looks along the point of its longest edge
/// that is nearest to the origin: a rounding's width from the truth.
[[gnu::noinline]] Vec3 Polytope::careful_normal(const Vec3& a, const Vec3& b, const Vec3& c) const {
  Real longest2;
  const Vec3 n = triangle_normal(a, b, c, longest2);
  const Real n2 = n.squaredNorm();
  if (n2 > rounding_ * rounding_ * longest2 / 16) return n * (1 / std::sqrt(n2));
  const Vec3 w[3] = {a, b, c};
  Nearest nearest;
  if ((b - a).squaredNorm() == longest2) {
    offer_edge(w, 0, 1, nearest);
  } else if ((c - b).squaredNorm() == longest2) {
    offer_edge(w, 1, 2, nearest);
  } else {
    offer_edge(w, 2, 0, nearest);
  }
  const Real d2 = nearest.direction.squaredNorm();
  return d2 > 0 ? Vec3(nearest.direction / std::sqrt(d2)) : (n2 > 0 ? Vec3(n / std::sqrt(n2)) : Vec3(Vec3::UnitX()));
}

inline int Polytope::new_face(int i, int j, int k) {
  const bool fresh = free_used_ == 0;
  const int slot = fresh ? faces_used_++ : free_[--free_used_];
  Face& f = faces_[slot];
  if (fresh) f.stamp = 0;
  f.vertex[0] = static_cast<Index>(i);
  f.vertex[1] = static_cast<Index>(j);
  f.vertex[2] = static_cast<Index>(k);
  f.alive = true;
  place(f);
  return slot;
}

void Polytope::remove(int face) {
  faces_[face].alive = false;
  ++faces_[face].stamp;
  free_[free_used_++] = static_cast<Index>(face);
}

void Polytope::link(int f, int e, int g, int h) {
  faces_[f].next[e] = static_cast<Index>(g);
  faces_[f].back[e] = static_cast<signed char>(h);
  faces_[g].next[h] = static_cast<Index>(f);
  faces_[g].back[h] = static_cast<signed char>(e);
}

void Polytope::sift_down(int at) {
  const Entry moving = heap_[at];
  for (int child; (child = 2 * at + 1) < heap_used_; at = child) {
    if (child + 1 < heap_used_ && heap_[child + 1].offset < heap_[child].offset) ++child;
    if (!(heap_[child].offset < moving.offset)) break;
    heap_[at] = heap_[child];
  }
  heap_[at] = moving;
}

/// Entries of faces long gone fill the heap: keep those alive.
void Polytope::refill() {
  heap_used_ = static_cast<int>(
      std::remove_if(heap_, heap_ + heap_used_,
                     [this](const Entry& e) { return !faces_[e.face].alive || faces_[e.face].stamp != e.stamp; }) -
      heap_);
  for (int i = heap_used_ / 2 - 1; i >= 0; --i) sift_down(i);
}

void Polytope::push(int face) {
  if (heap_used_ == kHeap) refill();
  const Entry entry{faces_[face].offset, face, faces_[face].stamp};
  int at = heap_used_++;
  for (int parent; at > 0 && entry.offset < heap_[parent = (at - 1) / 2].offset; at = parent) heap_[at] = heap_[parent];
  heap_[at] = entry;
}

int Polytope::pop() {
  while (heap_used_ > 0) {
    const Entry top = heap_[0];
    heap_[0] = heap_[--heap_used_];
    if (heap_used_ > 1) sift_down(0);
    if (faces_[top.face].alive && faces_[top.face].stamp == top.stamp) return top.face;
  }
  return -1;
}

bool Polytope::has(const Vec3& w) const {
  for (int i = 0; i < points_used_; ++i)
    if (points_[i].w == w) return true;
  return false;
}

void Polytope::start(const DifferencePoint* four, Real keep_below) {
  for (int i = 0; i < 4; ++i) points_[i] = four[i];
  points_used_ = 4;
  const Vec3 &a = four[0].w, &b = four[1].w, &c = four[2].w, &d = four[3].w;
  if (triangle_normal(a, b, c).dot(d - a) > 0) std::swap(points_[1], points_[2]);
  // d is now below abc seen from outside.
  const int abc = new_face(0, 1, 2), adb = new_face(0, 3, 1), bdc = new_face(1, 3, 2), cda = new_face(2, 3, 0);
  link(abc, 0, adb, 2);
  link(abc, 1, bdc, 2);
  link(abc, 2, cda, 2);
  link(adb, 1, bdc, 0);
  link(bdc, 1, cda, 0);
  link(cda, 1, adb, 0);
  for (const int f : {abc, adb, bdc, cda})
    if (faces_[f].offset <= keep_below) push(f);
}

/// Remove a face that w sees and go on over its other two edges; an edge to a face that w does not see is the horizon.
/// Edges come out in the order of the loop. Depth is at most the number of faces.
bool Polytope::walk(int face, int edge, const Vec3& w) {
  const Face& f = faces_[face];
  if (!f.alive) return true;
  if (f.normal.dot(w) - f.offset <= rounding_) {
    if (horizon_used_ == kFaces) return false;
    horizon_[horizon_used_++] = {static_cast<Index>(face), static_cast<Index>(edge)};
    return true;
  }
  remove(face);
  const int left = kNext[edge], right = kNext[left];
  return walk(f.next[left], f.back[left], w) && walk(f.next[right], f.back[right], w);
}

/// Remove the faces that a point beyond a face sees, and find the horizon around them.
bool Polytope::open(int face, const Vec3& w) {
  horizon_used_ = 0;
  const Face seen = faces_[face];
  remove(face);
  for (int e = 0; e < 3; ++e)
    if (!walk(seen.next[e], seen.back[e], w)) return false;
  if (horizon_used_ < 3 || horizon_used_ > free_used_ + (kFaces - faces_used_)) return false;
  // Every edge must start where the one before it ends (seen from the removed side).
  for (int i = 0; i < horizon_used_; ++i) {
    const Edge here = horizon_[i], after = horizon_[i + 1 == horizon_used_ ? 0 : i + 1];
    if (faces_[here.face].vertex[here.edge] != faces_[after.face].vertex[kNext[after.edge]]) return false;
  }
  return true;
}

bool Polytope::add(int face, const DifferencePoint& point, Real keep_below) {
  if (points_used_ == kPoints) return false;
  const int free_before = free_used_;
  if (!open(face, point.w)) {
    for (; free_used_ > free_before; --free_used_) faces_[free_[free_used_ - 1]].alive = true;
    return false;
  }
  const int apex = points_used_++;
  points_[apex] = point;
  int first = -1, last = -1;
  newest_ = -1;
  Real least = kInfinity;
  for (int i = 0; i < horizon_used_; ++i) {
    const Edge e = horizon_[i];
    Face& outside = faces_[e.face];
    const int slot = new_face(outside.vertex[kNext[e.edge]], outside.vertex[e.edge], apex);
    Face& f = faces_[slot];
    f.next[0] = e.face;
    f.back[0] = static_cast<signed char>(e.edge);
    outside.next[e.edge] = static_cast<Index>(slot);
    outside.back[e.edge] = 0;
    f.next[2] = static_cast<Index>(last);
    f.back[1] = 2;
    f.back[2] = 1;
    if (last >= 0)
      faces_[last].next[1] = static_cast<Index>(slot);
    else
      first = slot;
    last = slot;
    if (f.offset < least) {
      least = f.offset;
      newest_ = slot;
    }
    if (f.offset <= keep_below) push(slot);
  }
  faces_[last].next[1] = static_cast<Index>(first);
  faces_[first].next[2] = static_cast<Index>(last);
  return true;
}

}  // namespace carom
