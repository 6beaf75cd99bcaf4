// Box against box: fifteen axes decide how far they overlap and along which; a face then gives its whole patch, a pair
// of edges one point.
#include <algorithm>

#include "collision/manifold/clip.h"
#include "collision/manifold/patch_constants.h"
#include "collision/narrow/pair.h"

namespace carom::collision {
namespace {

// Two edges that enclose a smaller angle (rad) count as parallel. Their cross product has rounding noise u / angle in
// its direction; leaving it out moves the depth by at most angle * size, since with parallel edges the faces decide.
// Here the two are equal: 1e-8 of the size.
constexpr Real kEdgesParallel = 1e-8;
// How much better another axis must be than the one preferred (faces of A, faces of B, edges, in this order): a part of
// the depth, and of the smallest half extent. Resting boxes have several axes equal up to the tilt of a jitter; without
// a preference the patch would change from step to step. The price is a normal that is not the one of least depth where
// the depths differ by less than this. Smaller: flicker. Larger: edges sink in before they are seen as edges.
constexpr Real kPreferAbsolute = 1e-3;  // and kPatchPreferRelative
// The same where the depth itself is asked for (reach is infinite): rounding only.
constexpr Real kBoxRounding = 1e-13;

constexpr int next(int i) { return i == 2 ? 0 : i + 1; }

struct BoxAxis {
  int face = 0;  // 0..2: face of A; 3..5: face of B
  Real face_separation = -kInfinity;
  int i = -1, j = -1;  // edges of A and B, where they separate better
  Real edge_separation = -kInfinity;
  bool apart = false;  // farther apart than asked
  Real gap = 0;        // m: then, by this at least
};

/// The preferred axis of largest separation, over the three faces of each box and the nine pairs of edges.
/// For unit axis n: separation(n) = |n . t| - sum_k ha_k |n . e_k| - sum_k hb_k |n . R_k|, a bound of the distance from
/// below, and the (negative) depth itself at the best of the fifteen when the boxes overlap.
/// With reach infinite, the depth being asked for, any axis that separates ends it.
/// @source [Gottschalk1996 §5]
BoxAxis best_axis(const Mat3& r, const Vec3& t, const Vec3& ha, const Vec3& hb, Real reach) {
  const bool exact = reach == kInfinity;
  if (exact) reach = 0;
  const Mat3 abs_r = r.abs();
  const Real size = ha.sum() + hb.sum();
  const Real absolute = exact ? kBoxRounding * size : kPreferAbsolute * std::min(ha.min_entry(), hb.min_entry());
  const Real relative = exact ? 0 : kPatchPreferRelative.value;
  BoxAxis best;
  for (int i = 0; i < 3; ++i) {
    const Real s = std::fabs(t[i]) - ha[i] - (abs_r(i, 0) * hb[0] + abs_r(i, 1) * hb[1] + abs_r(i, 2) * hb[2]);
    if (s > best.face_separation) best.face_separation = s, best.face = i;
  }
  if (best.face_separation > reach) return best.apart = true, best.gap = best.face_separation, best;
  Real to_beat = best.face_separation + relative * std::fabs(best.face_separation) + absolute;
  for (int j = 0; j < 3; ++j) {
    const Real t_j = t[0] * r(0, j) + t[1] * r(1, j) + t[2] * r(2, j);
    const Real s = std::fabs(t_j) - hb[j] - (abs_r(0, j) * ha[0] + abs_r(1, j) * ha[1] + abs_r(2, j) * ha[2]);
    if (s > reach) return best.apart = true, best.gap = s, best;
    if (s > to_beat) to_beat = best.face_separation = s, best.face = 3 + j;
  }
  to_beat = best.face_separation + relative * std::fabs(best.face_separation) + absolute;
  for (int i = 0; i < 3; ++i) {
    const int i1 = next(i), i2 = next(i1);
    for (int j = 0; j < 3; ++j) {
      const int j1 = next(j), j2 = next(j1);
      // L = e_i x R_j, not of unit length; L . R_j1 = R(i, j2) and L . R_j2 = -R(i, j1).
      const Real over = std::fabs(t[i2] * r(i1, j) - t[i1] * r(i2, j)) - ha[i1] * abs_r(i2, j) - ha[i2] * abs_r(i1, j) -
                        hb[j1] * abs_r(i, j2) - hb[j2] * abs_r(i, j1);
      // |L| <= 1, so dividing by it lowers what is negative: most axes are out without a root.
      if (!(over > std::min(to_beat, Real(0)))) continue;
      const Real length2 = r(i1, j) * r(i1, j) + r(i2, j) * r(i2, j);
      if (length2 < kEdgesParallel * kEdgesParallel) continue;
      const Real s = over / std::sqrt(length2);
      if (s > reach) return best.apart = true, best.gap = s, best;
      if (s > to_beat) to_beat = best.edge_separation = s, best.i = i, best.j = j;
    }
  }
  return best;
}

/// A box seen from the one whose face is the reference.
struct View {
  Mat3 r;  // other box -> reference box
  Vec3 t;  // m, centre of the other
  Vec3 half, other;
};

/// Patch of a reference face: the other box's most opposed face, cut to the reference face's outline.
/// Its points are written into `found` with on_a on the reference face, normal out of it (reference frame).
void face_patch(const View& v, int face, Real reach, std::uint32_t label, Candidates& found) {
  const int iu = next(face), iv = next(iu);
  const Real side = v.t[face] < 0 ? -1 : 1;
  int j = 0;
  for (int k = 1; k < 3; ++k)
    if (std::fabs(v.r(face, k)) > std::fabs(v.r(face, j))) j = k;
  const int k = next(j), l = next(k);
  const Real towards = side * v.r(face, j) > 0 ? -1 : 1;  // which of the two faces across axis j looks back at us
  const Vec3 centre = v.t + towards * v.other[j] * v.r.col(j);
  const Vec3 ek = v.other[k] * v.r.col(k), el = v.other[l] * v.r.col(l);

  Polygon patch;
  patch.count = 4;
  constexpr Real kSign[4][2] = {{1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
  for (int c = 0; c < 4; ++c) {
    const Real a = kSign[c][0], b = kSign[c][1];
    patch.corner[c] = {centre[iu] + a * ek[iu] + b * el[iu], centre[iv] + a * ek[iv] + b * el[iv],
                       side * (centre[face] + a * ek[face] + b * el[face]) - v.half[face],
                       static_cast<std::uint32_t>(c)};
  }
  clip_to_rectangle(patch, v.half[iu], v.half[iv]);

  Vec3 normal = Vec3::zero();
  normal[face] = side;
  const std::uint32_t faces = (label * 8 + static_cast<std::uint32_t>(2 * j) + (towards > 0)) * 64;
  std::uint32_t arrives = patch.count ? patch.corner[patch.count - 1].side : 0;
  for (int c = 0; c < patch.count; ++c) {
    const Corner& p = patch.corner[c];
    const std::uint32_t feature = faces + arrives * 8 + p.side + 1;
    arrives = p.side;
    if (!(p.z <= reach)) continue;
    Vec3 x;
    x[iu] = p.x, x[iv] = p.y, x[face] = side * v.half[face];
    Vec3 on_other = x;
    on_other[face] += side * p.z;
    add_contact(found, reach, x, v.r.transpose() * (on_other - v.t), normal, p.z, feature);
  }
}

/// The other box's deepest corner against a reference face.
/// @param before_it  only if it lies before the face, not beside it
void face_corner(const View& v, int face, bool before_it, Real reach, std::uint32_t label, Candidates& found) {
  const Real side = v.t[face] < 0 ? -1 : 1;
  Vec3 corner;
  for (int k = 0; k < 3; ++k) corner[k] = side * v.r(face, k) > 0 ? -v.other[k] : v.other[k];
  const Vec3 x = v.r * corner + v.t;
  Vec3 on_face = x.max(-v.half).min(v.half), normal = Vec3::zero();
  normal[face] = side;
  on_face[face] = side * v.half[face];
  if (before_it && !(on_face[next(face)] == x[next(face)] && on_face[next(next(face))] == x[next(next(face))])) return;
  add_contact(found, reach, on_face, corner, normal, side * x[face] - v.half[face], (label + 1) << 12);
}

View from_a(const Shape& a, const Shape& b, const Frame& b_in_a) { return {b_in_a.r, b_in_a.p, a.half, b.half}; }
View from_b(const Shape& a, const Shape& b, const Frame& b_in_a) {
  return {b_in_a.r.transpose(), -(b_in_a.r.transpose() * b_in_a.p), b.half, a.half};
}

/// Points found from B's side as points between A and B.
void turn_over(const Frame& b_in_a, ContactPoint* first, ContactPoint* end) {
  for (ContactPoint* p = first; p < end; ++p) {
    std::swap(p->on_a, p->on_b);
    p->normal = -(b_in_a.r * p->normal);
  }
}

/// Boxes apart by a face: where the other's nearest corner lies before it, and not beside it, it is the nearest point
/// of all, since the face's plane says that nothing is nearer. Else others know the distance.
void corner_before_face(const Shape& a, const Shape& b, const Frame& b_in_a, Candidates& found) {
  const auto gaps = [](const View& v) { return v.t.abs() - v.half - v.r.abs() * v.other; };
  const View side_a = from_a(a, b, b_in_a), side_b = from_b(a, b, b_in_a);
  const Vec3 gaps_a = gaps(side_a), gaps_b = gaps(side_b);
  const int face_a = gaps_a.max_axis(), face_b = gaps_b.max_axis();
  const Real gap_a = gaps_a[face_a], gap_b = gaps_b[face_b];
  const bool of_b = gap_b > gap_a;
  face_corner(of_b ? side_b : side_a, of_b ? face_b : face_a, true, kInfinity, 0, found);
  if (of_b) turn_over(b_in_a, found.point, found.point + found.count);
}

void face_contact(const Shape& a, const Shape& b, const Frame& b_in_a, int face, bool apart, Real reach,
                  Candidates& found) {
  const auto label = static_cast<std::uint32_t>(face);
  const bool of_b = face >= 3;
  const int first = found.count, axis = of_b ? face - 3 : face;
  const View v = of_b ? from_b(a, b, b_in_a) : from_a(a, b, b_in_a);
  face_patch(v, axis, reach, label, found);
  // Apart, an empty patch means that the boxes pass by each other. In overlap there is always a point of least depth;
  // rounding, or the preferred axis not being the best, may have cut it away.
  if (found.count == first && !apart) face_corner(v, axis, false, reach, label, found);
  if (of_b) turn_over(b_in_a, found.point + first, found.point + found.count);
}

/// One point where two edges cross: the nearest points of their lines, held to the edges.
void edge_contact(const Vec3& ha, const Vec3& hb, const Frame& b_in_a, int i, int j, Real reach, Candidates& found) {
  const Mat3& r = b_in_a.r;
  Vec3 normal = Vec3::unit(i).cross(r.col(j));
  const Real length2 = normal.squared_norm();
  normal *= (normal.dot(b_in_a.p) < 0 ? -1 : 1) / std::sqrt(length2);
  Vec3 on_a, on_b;
  std::uint32_t which = 0;  // which of the four edges along each axis
  for (int k = 0; k < 3; ++k) {
    const Real out_a = normal[k], out_b = normal.dot(r.col(k));
    on_a[k] = k == i ? 0 : std::copysign(ha[k], out_a);
    on_b[k] = k == j ? 0 : -std::copysign(hb[k], out_b);
    which = which * 4 + (k != i && out_a < 0) * 2u + (k != j && out_b < 0);
  }
  const Vec3 between = b_in_a.apply(on_b) - on_a;
  const Real along_a = between[i], along_b = between.dot(r.col(j)), cosine = r(i, j);
  on_a[i] = std::clamp((along_a - cosine * along_b) / length2, -ha[i], ha[i]);
  on_b[j] = std::clamp((cosine * along_a - along_b) / length2, -hb[j], hb[j]);
  const Vec3 gap = b_in_a.apply(on_b) - on_a;
  const Real separation = normal.dot(gap);
  // Edges that pass by each other outside their ends do not meet; two that cross do.
  if (separation > 0 && (gap - separation * normal).squared_norm() > reach * reach) return;
  add_contact(found, reach, on_a, on_b, normal, separation,
              (1u << 16) + (static_cast<std::uint32_t>(3 * i + j) << 8) + which);
}

}  // namespace

void contact_box_box(const Shape& a, const Shape& b, const Frame& b_in_a, Real reach, Candidates& found) {
  const BoxAxis axis = best_axis(b_in_a.r, b_in_a.p, a.half, b.half, reach);
  found.whole = true;
  if (axis.apart) {
    found.gap = axis.gap;
    if (reach == kInfinity) corner_before_face(a, b, b_in_a, found);
    return;
  }
  if (axis.i >= 0) {
    // A box that rests on a face with some tilt may have an edge pair ahead for a step: older points stay.
    found.whole = false;
    edge_contact(a.half, b.half, b_in_a, axis.i, axis.j, reach, found);
    return;
  }
  face_contact(a, b, b_in_a, axis.face, axis.face_separation > 0, reach, found);
}

}  // namespace carom::collision
