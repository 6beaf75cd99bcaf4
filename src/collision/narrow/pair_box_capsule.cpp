// Box against capsule: the distance of a box and a segment, exact apart (piecewise linear slope) and overlapping (six
// axes), and a second point where the capsule lies on a face.
#include <algorithm>

#include "collision/narrow/pair.h"

namespace carom::collision {
namespace {

// Cosine above which a normal counts as a face's own (2.5 degrees): the capsule may lie on that face.
constexpr Real kOnFace = 0.999;
// A core nearer to the box than this share of the pair's size has lost the direction of its gap to rounding (16 u /
// 1e-8 = 2e-7 rad); six axes decide instead, whose value differs by no more than the gap.
constexpr Real kCoreTouches = 1e-8;
// Sine of the angle below which an edge runs along the segment, and their cross product is left out as noise. In the
// limit faces alone decide, so leaving it out costs 1e-8 of the size.
constexpr Real kSegmentParallel = 1e-8;

Vec3 inside(const Vec3& x, const Vec3& half) { return x.max(-half).min(half); }

/// The s in [-1, 1] where c + s d is nearest to the box.
/// Half the slope of the squared distance, g(s) = d . (x - clamp(x)), is non-decreasing and linear between the up to
/// six places where a coordinate of x crosses a face: those bracket the root, a straight line ends it.
/// @accuracy a few u times the size in x(s)
Real nearest_on_segment(const Vec3& c, const Vec3& d, const Vec3& half) {
  const auto slope = [&](Real s) {
    const Vec3 x = c + s * d;
    return d.dot(x - inside(x, half));
  };
  Real lo = -1, hi = 1, g_lo = slope(lo), g_hi = slope(hi);
  if (g_lo >= 0) return lo;
  if (g_hi <= 0) return hi;
  for (int k = 0; k < 3; ++k) {
    if (d[k] == 0) continue;
    for (const Real face : {-half[k], half[k]}) {
      const Real s = (face - c[k]) / d[k];
      if (!(s > lo && s < hi)) continue;
      const Real g = slope(s);
      if (g == 0) return s;
      if (g < 0) {
        lo = s, g_lo = g;
      } else {
        hi = s, g_hi = g;
      }
    }
  }
  return lo + (hi - lo) * (g_lo / (g_lo - g_hi));
}

/// The axis that separates box and segment most, and by how much (negative: the overlap along it).
/// The faces of box - segment are the box's faces and those spanned by an edge and the segment: six axes decide
/// exactly.
struct SegmentAxis {
  Vec3 normal;      // unit, from the box to the segment
  Real separation;  // m
  int edge;         // -1: a face's normal; k: across edges along axis k
};

SegmentAxis most_separating(const Vec3& c, const Vec3& d, const Vec3& half) {
  SegmentAxis best{Vec3::unit_x(), -kInfinity, -1};
  for (int k = 0; k < 3; ++k) {
    const Real s = std::fabs(c[k]) - half[k] - std::fabs(d[k]);
    if (s > best.separation) {
      best.separation = s;
      best.normal.set_zero();
      best.normal[k] = std::copysign(Real(1), c[k]);
    }
  }
  // A face holds two points where an edge holds one: at equal depth, up to rounding, it is preferred.
  const Real bias = 1e-12 * half.sum();
  const Real length = d.norm();
  for (int k = 0; k < 3; ++k) {
    Vec3 m = Vec3::unit(k).cross(d);
    const Real l = m.norm();
    if (!(l > kSegmentParallel * length)) continue;
    m *= (m.dot(c) < 0 ? -1 : 1) / l;
    const Real s = m.dot(c) - half.dot(m.abs());
    if (s > best.separation + bias) best = {m, s, k};
  }
  return best;
}

struct Contact {
  const Shape& capsule;
  const Frame& b_in_a;
  Real reach;
  Candidates& found;

  /// A point of the box and the point x of the segment, s its place on it.
  void add(const Vec3& on_box, const Vec3& x, Real s, const Vec3& normal, std::uint32_t feature) const {
    const Vec3 on_b = s * capsule.half_height * Vec3::unit_y() - capsule.radius * b_in_a.rotate_inverse(normal);
    add_contact(found, reach, on_box, on_b, normal, normal.dot(x - on_box) - capsule.radius, feature);
  }
};

/// The stretch of the segment above a face (all of [-1, 1] cut by the face's four sides). @return false if there is
/// none
bool above_face(const Vec3& c, const Vec3& d, const Vec3& half, int face, Real& lo, Real& hi) {
  lo = -1, hi = 1;
  for (int k = 0; k < 3; ++k) {
    if (k == face) continue;
    if (d[k] == 0) {
      if (std::fabs(c[k]) > half[k]) return false;
      continue;
    }
    const Real s0 = (-half[k] - c[k]) / d[k], s1 = (half[k] - c[k]) / d[k];
    lo = std::max(lo, std::min(s0, s1));
    hi = std::min(hi, std::max(s0, s1));
  }
  return lo <= hi;
}

/// The two ends of the stretch above a face, deeper one first, those left out that lie beside `taken`.
void add_ends(const Contact& to, const Vec3& c, const Vec3& d, const Vec3& half, int face, const Vec3& normal,
              Real taken) {
  Real lo, hi;
  if (!above_face(c, d, half, face, lo, hi)) return;
  const Real side = std::copysign(Real(1), normal[face]);
  const bool lo_first = side * d[face] >= 0;
  const Real order[2] = {lo_first ? lo : hi, lo_first ? hi : lo};
  for (const Real s : order) {
    if (std::fabs(s - taken) < 1e-3) continue;
    const Vec3 x = c + s * d;
    Vec3 on_box = inside(x - normal * ((x[face] - side * half[face]) / normal[face]), half);
    on_box[face] = side * half[face];
    to.add(on_box, x, s, normal, s == lo ? 2 : 3);
    taken = s;
  }
}

}  // namespace

void contact_box_capsule(const Shape& a, const Shape& b, const Frame& b_in_a, Real reach, Candidates& found) {
  const Vec3& half = a.half;
  const Vec3& c = b_in_a.p;
  const Vec3 d = b.half_height * b_in_a.r.col(1);
  const Contact to{b, b_in_a, reach, found};
  found.whole = true;

  const Real s = nearest_on_segment(c, d, half);
  const Vec3 x = c + s * d, on_box = inside(x, half);
  const Real gap = (x - on_box).norm();
  if (gap > kCoreTouches * (half.sum() + b.half_height + b.radius)) {
    const Vec3 normal = (x - on_box) / gap;
    to.add(on_box, x, s, normal, 1);
    const int face = normal.abs().max_axis();
    if (std::fabs(normal[face]) > kOnFace) add_ends(to, c, d, half, face, normal, s);
    return;
  }

  const SegmentAxis axis = most_separating(c, d, half);
  if (axis.edge < 0) {
    const int face = axis.normal.abs().max_axis();
    add_ends(to, c, d, half, face, axis.normal, kInfinity);
    if (found.count > 0 || axis.separation - b.radius > reach) return;
    // The deep end lies beside the face by rounding alone: its nearest point of the face stands for it.
    const Real end = axis.normal.dot(d) > 0 ? -1 : 1;
    const Vec3 deep = c + end * d;
    Vec3 on_face = inside(deep, half);
    on_face[face] = std::copysign(half[face], axis.normal[face]);
    to.add(on_face, deep, end, axis.normal, 1);
    return;
  }
  // An edge across the segment: both lines lie in planes across the normal, so their nearest points carry the depth.
  const int k = axis.edge;
  Vec3 on_edge;
  for (int i = 0; i < 3; ++i) on_edge[i] = i == k ? 0 : std::copysign(half[i], axis.normal[i]);
  const Vec3 across = d - d[k] * Vec3::unit(k);  // what moves the segment away from the edge's line
  const Vec3 from = c - on_edge;
  const Real at = std::clamp(-(from.dot(across)) / across.squared_norm(), Real(-1), Real(1));
  const Vec3 deep = c + at * d;
  on_edge[k] = std::clamp(deep[k], -half[k], half[k]);
  to.add(on_edge, deep, at, axis.normal, 8 + static_cast<std::uint32_t>(k));
}

}  // namespace carom::collision
