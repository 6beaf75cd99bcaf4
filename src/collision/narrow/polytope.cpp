// Faces and horizon of the polytope that EPA grows.
#include "collision/narrow/polytope.h"

#include <algorithm>
#include <cstring>

#include "collision/narrow/simplex_geometry.h"

namespace carom::collision {

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
  const Real n2 = n.squared_norm(), ab2 = ab.squared_norm(), ac2 = ac.squared_norm();
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
  const Real n2 = n.squared_norm();
  if (n2 > rounding_ * rounding_ * longest2 / 16) return n * (1 / std::sqrt(n2));
  const Vec3 w[3] = {a, b, c};
  Nearest nearest;
  if ((b - a).squared_norm() == longest2) {
    offer_edge(w, 0, 1, nearest);
  } else if ((c - b).squared_norm() == longest2) {
    offer_edge(w, 1, 2, nearest);
  } else {
    offer_edge(w, 2, 0, nearest);
  }
  const Real d2 = nearest.direction.squared_norm();
  return d2 > 0 ? Vec3(nearest.direction / std::sqrt(d2)) : (n2 > 0 ? Vec3(n / std::sqrt(n2)) : Vec3(Vec3::unit_x()));
}

inline void Polytope::set(int slot, int i, int j, int k) {
  Face& f = faces_[slot];
  f.vertex[0] = i;
  f.vertex[1] = j;
  f.vertex[2] = k;
  f.alive = true;
}

inline void Polytope::remove(int face) {
  faces_[face].alive = false;
  offset_[face] = kInfinity;
  free_[free_used_++] = face;
}

inline void Polytope::join(Link one, Link other) {
  faces_[face_of(one)].across[edge_of(one)] = other;
  faces_[face_of(other)].across[edge_of(other)] = one;
}

/// Every slot is looked at. A heap, which would look at a few only, branches unpredictably at each of its levels:
/// with one EPA took a fifth longer on curved pairs, at 16 iterations as at 54. Its four lanes keep their best each, as
/// in FarthestVertex::scan.
int Polytope::nearest() const {
  typedef double Lanes __attribute__((vector_size(16)));
  typedef std::int64_t Which __attribute__((vector_size(16)));
  Lanes best = {kInfinity, kInfinity}, other = best;
  Which at = {0, 1}, which = at, which_other = at;
  for (int i = 0; i < faces_used_; i += kLanes, at += kLanes) {
    Lanes h, g;
    std::memcpy(&h, offset_ + i, sizeof h);
    std::memcpy(&g, offset_ + i + 2, sizeof g);
    const Which nearer = h < best, nearer_other = g < other;
    best = nearer ? h : best;
    which = nearer ? at : which;
    other = nearer_other ? g : other;
    which_other = nearer_other ? at : which_other;
  }
  const Which nearer = other < best;
  best = nearer ? other : best;
  which = nearer ? which_other + 2 : which;
  return static_cast<int>(which[best[1] < best[0]]);
}

int Polytope::newest() const {
  if (fan_ < 0) return -1;
  int best = fan_;
  for (int f = face_of(faces_[fan_].across[1]); f != fan_; f = face_of(faces_[f].across[1]))
    if (faces_[f].offset < faces_[best].offset) best = f;
  return best;
}

bool Polytope::has(const Vec3& w) const {
  for (int i = 0; i < points_used_; ++i)
    if (points_[i].w == w) return true;
  return false;
}

void Polytope::start(const DifferencePoint* four) {
  for (int i = 0; i < 4; ++i) points_[i] = four[i];
  points_used_ = 4;
  const Vec3 &a = four[0].w, &b = four[1].w, &c = four[2].w, &d = four[3].w;
  if (triangle_normal(a, b, c).dot(d - a) > 0) std::swap(points_[1], points_[2]);
  // d is now below abc seen from outside.
  constexpr int abc = 0, adb = 1, bdc = 2, cda = 3;
  set(abc, 0, 1, 2);
  set(adb, 0, 3, 1);
  set(bdc, 1, 3, 2);
  set(cda, 2, 3, 0);
  faces_used_ = 4;
  for (int f = 0; f < faces_used_; ++f) {
    place(faces_[f]);
    offset_[f] = faces_[f].offset;
  }
  join(link_to(abc, 0), link_to(adb, 2));
  join(link_to(abc, 1), link_to(bdc, 2));
  join(link_to(abc, 2), link_to(cda, 2));
  join(link_to(adb, 1), link_to(bdc, 0));
  join(link_to(bdc, 1), link_to(cda, 0));
  join(link_to(cda, 1), link_to(adb, 0));
}

/// Remove the faces that a point beyond a face sees, and find the horizon around them: from a face that goes, over its
/// edges, to more that go or to the horizon, whose edges come out in the order of the loop.
bool Polytope::open(int face, const Vec3& w) {
  int used = 0;
  // Edges still to be crossed, the next one on top. Each face that goes leaves one more than it took.
  Link waiting[kFaces + 3];
  int count = 0;
  remove(face);
  for (const int e : {2, 1, 0}) waiting[count++] = faces_[face].across[e];
  while (count > 0) {
    const Link link = waiting[--count];
    const Face& f = faces_[face_of(link)];
    if (!f.alive) continue;
    if (f.normal.dot(w) - f.offset > rounding_) {
      remove(face_of(link));
      const int left = kNext[edge_of(link)];
      waiting[count++] = f.across[kNext[left]];
      waiting[count++] = f.across[left];
      continue;
    }
    if (used == kFaces) return false;
    // Every edge must start where the one before it ends (seen from the removed side).
    const int start = f.vertex[kNext[edge_of(link)]];
    if (used > 0 && loop_[used] != start) return false;
    loop_[used] = start;
    loop_at_.set(used, points_[start].w);
    horizon_[used++] = link;
    loop_[used] = f.vertex[edge_of(link)];
  }
  horizon_used_ = used;
  return used >= 3 && used <= free_used_ + (kFaces - faces_used_) && loop_[used] == loop_[0];
}

bool Polytope::add(int face) {
  if (points_used_ == kPoints) return false;
  const int free_before = free_used_;
  const Vec3 w = points_[points_used_].w;
  if (!open(face, w)) {
    for (; free_used_ > free_before; --free_used_) {
      const int back = free_[free_used_ - 1];
      faces_[back].alive = true;
      offset_[back] = faces_[back].offset;
    }
    return false;
  }
  const int apex = points_used_++, count = horizon_used_;
  const Vec3& closing = points_[loop_[0]].w;
  for (int i = 0; i < Fan::kFaces; ++i)
    loop_at_.set(count + i, closing);  // more than once, for lanes with nothing to do
  while (free_used_ < count) free_[free_used_++] = faces_used_++;
  for (int i = 0; i < kLanes - 1; ++i) offset_[faces_used_ + i] = kInfinity;
  free_[free_used_] = free_[free_used_ - count];  // around the fan, the first is the next of the last
  free_used_ -= count;
  const std::int32_t* slot = free_ + free_used_;
  int before = slot[count - 1];
  for (int from = 0; from < count; from += Fan::kFaces) {
    Fan fan;
    fan.unfold(loop_at_.x + from, loop_at_.y + from, loop_at_.z + from, w, kWideAngle2, rounding_);
    const int end = std::min(from + Fan::kFaces, count);
    for (int i = from; i < end; ++i) {
      const int here = slot[i], at = i - from;
      const Link link = horizon_[i];
      Face& f = faces_[here];
      set(here, loop_[i], loop_[i + 1], apex);
      f.across[0] = link;
      f.across[1] = link_to(slot[i + 1], 2);
      f.across[2] = link_to(before, 1);
      faces_[face_of(link)].across[edge_of(link)] = link_to(here, 0);
      before = here;
      f.normal = Vec3(fan.nx[at], fan.ny[at], fan.nz[at]);
      f.offset = fan.offset[at];
      if (!(fan.clear[at] > 0)) place(f);
      offset_[here] = f.offset;
    }
  }
  fan_ = before;
  return true;
}

}  // namespace carom::collision
