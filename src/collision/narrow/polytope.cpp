// Faces, heap and horizon of the polytope that EPA grows.
#include "collision/narrow/polytope.h"

#include <algorithm>

#include "collision/narrow/simplex_geometry.h"

namespace carom {

namespace {

constexpr int kNext[3] = {1, 2, 0};

constexpr Polytope::Link link_to(int face, int edge) { return 4 * face + edge; }
constexpr int face_of(Polytope::Link link) { return link >> 2; }
constexpr int edge_of(Polytope::Link link) { return link & 3; }

}  // namespace

/// Normal and offset of a face. From two edges at one vertex if they enclose a wide angle; the offset, taken at the
/// vertices, is a proof whatever the normal.
void Polytope::place(Face& f) const {
  const Vec3 &a = points_[f.vertex[0]].w, &b = points_[f.vertex[1]].w, &c = points_[f.vertex[2]].w;
  const Vec3 ab = b - a, ac = c - a, n = ab.cross(ac);
  const Real n2 = n.squaredNorm(), ab2 = ab.squaredNorm(), ac2 = ac.squaredNorm();
  // Twice the area over the longest edge, which is below sqrt(2 (ab2 + ac2)), is the height.
  if (n2 > kWideAngle2 * (ab2 * ac2) && n2 > rounding_ * rounding_ * (ab2 + ac2)) {
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
  int slot = faces_used_;
  if (free_used_ > 0) {
    slot = free_[--free_used_];
  } else {
    ++faces_used_;
    faces_[slot].stamp = 0;
  }
  Face& f = faces_[slot];
  f.vertex[0] = i;
  f.vertex[1] = j;
  f.vertex[2] = k;
  ++f.stamp;
  return slot;
}

inline void Polytope::remove(int face) {
  ++faces_[face].stamp;
  free_[free_used_++] = face;
}

inline void Polytope::join(Link one, Link other) {
  faces_[face_of(one)].across[edge_of(one)] = other;
  faces_[face_of(other)].across[edge_of(other)] = one;
}

void Polytope::sift_down(int at) {
  const Entry moving = heap_[at];
  heap_[heap_used_].offset = kInfinity;  // the second child of a parent of one
  for (int child; (child = 2 * at + 1) < heap_used_; at = child) {
    child += heap_[child + 1].offset < heap_[child].offset;  // no branch: which child is anybody's guess
    if (!(heap_[child].offset < moving.offset)) break;
    heap_[at] = heap_[child];
  }
  heap_[at] = moving;
}

/// Entries of faces long gone fill the heap: keep those alive.
void Polytope::refill() {
  heap_used_ = static_cast<int>(
      std::remove_if(heap_, heap_ + heap_used_, [this](const Entry& e) { return faces_[e.face].stamp != e.stamp; }) -
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
    if (faces_[top.face].stamp == top.stamp) return top.face;
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
  for (const int f : {abc, adb, bdc, cda}) place(faces_[f]);
  join(link_to(abc, 0), link_to(adb, 2));
  join(link_to(abc, 1), link_to(bdc, 2));
  join(link_to(abc, 2), link_to(cda, 2));
  join(link_to(adb, 1), link_to(bdc, 0));
  join(link_to(bdc, 1), link_to(cda, 0));
  join(link_to(cda, 1), link_to(adb, 0));
  for (const int f : {abc, adb, bdc, cda})
    if (faces_[f].offset <= keep_below) push(f);
}

/// Remove the faces that a point beyond a face sees, and find the horizon around them: from a face that goes, over its
/// edges, to more that go or to the horizon, whose edges come out in the order of the loop.
bool Polytope::open(int face, const Vec3& w) {
  horizon_used_ = 0;
  // Edges still to be crossed, the next one on top. Each face that goes leaves one more than it took.
  Link waiting[kFaces + 3];
  int count = 0;
  remove(face);
  for (const int e : {2, 1, 0}) waiting[count++] = faces_[face].across[e];
  while (count > 0) {
    const Link link = waiting[--count];
    const Face& f = faces_[face_of(link)];
    if (!f.alive()) continue;
    if (f.normal.dot(w) - f.offset > rounding_) {
      remove(face_of(link));
      const int left = kNext[edge_of(link)];
      waiting[count++] = f.across[kNext[left]];
      waiting[count++] = f.across[left];
      continue;
    }
    if (horizon_used_ == kFaces) return false;
    // Every edge must start where the one before it ends (seen from the removed side).
    const int start = f.vertex[kNext[edge_of(link)]];
    if (horizon_used_ > 0 && rim_[horizon_used_] != start) return false;
    rim_[horizon_used_] = start;
    horizon_[horizon_used_++] = link;
    rim_[horizon_used_] = f.vertex[edge_of(link)];
  }
  return horizon_used_ >= 3 && horizon_used_ <= free_used_ + (kFaces - faces_used_) && rim_[horizon_used_] == rim_[0];
}

/// The planes of the next faces around a new point, from the horizon's edge `from` on.
inline void Polytope::unfold(int from, const Vec3& apex, Fan& fan) const {
  const int edges = std::min(Fan::kFaces, horizon_used_ - from);
  for (int i = 0; i <= edges; ++i) fan.set(i, points_[rim_[from + i]].w);
  for (int i = edges + 1; i <= Fan::kFaces; ++i) fan.set(i, points_[rim_[from + edges]].w);
  fan.unfold(apex, kWideAngle2, rounding_);
}

bool Polytope::add(int face, const DifferencePoint& point, Real keep_below) {
  if (points_used_ == kPoints) return false;
  const int free_before = free_used_;
  if (!open(face, point.w)) {
    for (; free_used_ > free_before; --free_used_) --faces_[free_[free_used_ - 1]].stamp;
    return false;
  }
  const int apex = points_used_++;
  points_[apex] = point;
  newest_ = -1;
  Real least = kInfinity;
  int first = -1, last = -1;
  Fan fan;
  for (int i = 0; i < horizon_used_; ++i) {
    const int at = i % Fan::kFaces;
    if (at == 0) unfold(i, point.w, fan);
    const Link link = horizon_[i];
    const int slot = new_face(rim_[i], rim_[i + 1], apex);
    Face& f = faces_[slot];
    if (fan.clear[at] > 0) {
      f.normal = Vec3(fan.nx[at], fan.ny[at], fan.nz[at]);
      f.offset = fan.offset[at];
    } else {
      place(f);
    }
    f.across[0] = link;
    faces_[face_of(link)].across[edge_of(link)] = link_to(slot, 0);
    if (last < 0)
      first = slot;
    else
      join(link_to(last, 1), link_to(slot, 2));
    last = slot;
    if (f.offset < least) {
      least = f.offset;
      newest_ = slot;
    }
    if (f.offset <= keep_below) push(slot);
  }
  join(link_to(last, 1), link_to(first, 2));
  return true;
}

}  // namespace carom
