// The loop of EPA, and the tetrahedron that it starts from.
#include "collision/narrow/epa.h"

#include <algorithm>
#include <tuple>

#include "collision/narrow/polytope.h"
#include "collision/narrow/simplex_geometry.h"

namespace carom::collision {

namespace {

enum class Build { solid, flat, fault };

/// Looks along n and -n and keeps the point with the larger |measure|.
template <class Measure>
bool look_both_ways(Difference& difference, const Vec3& n, const Measure& measure, DifferencePoint& best, Real& most) {
  for (const Real sign : {1.0, -1.0}) {
    DifferencePoint found;
    Real value = 0;
    if (!difference.support(sign * n, found, value)) return false;
    const Real m = std::fabs(measure(found.w));
    if (m > most) {
      most = m;
      best = found;
    }
  }
  return true;
}

/// A tetrahedron without volume keeps its feature nearest to the origin; the upper bound is what that feature's weights
/// prove, those of the tetrahedron being u over its thickness off.
void drop_to_feature(Difference& difference, DifferenceSimplex& simplex) {
  Vec3 w[4];
  for (int i = 0; i < 4; ++i) w[i] = simplex.point[i].w;
  Nearest nearest;
  offer_face(w, 0, 1, 2, nearest);
  offer_face(w, 0, 1, 3, nearest);
  offer_face(w, 0, 2, 3, nearest);
  offer_face(w, 1, 2, 3, nearest);
  const DifferenceSimplex all = simplex;
  Vec3 v = Vec3::zero();
  simplex.count = nearest.count;
  for (int i = 0; i < nearest.count; ++i) {
    simplex.point[i] = all.point[nearest.index[i]];
    simplex.weight[i] = nearest.weight[i];
    v += nearest.weight[i] * simplex.point[i].w;
  }
  difference.upper = std::min(difference.upper, v.norm());
}

/// Add points to whatever GJK left until there is a tetrahedron: each the farthest to be found from the point, line or
/// plane of those before it. If the farthest is within rounding the difference is flat, and looking along its normal
/// both ways has already closed the bracket.
Build build_tetrahedron(Difference& difference, DifferenceSimplex& simplex) {
  DifferencePoint* p = simplex.point;
  const Real flat = difference.rounding();
  if (simplex.count == 4) {
    const Vec3 ab = p[1].w - p[0].w, ac = p[2].w - p[0].w, ad = p[3].w - p[0].w;
    const Vec3 n = ab.cross(ac);
    // Thinner than rounding over its base: its faces would not know their sides.
    if (std::fabs(n.dot(ad)) > flat * n.norm()) return Build::solid;
    drop_to_feature(difference, simplex);
  }
  if (simplex.count == 3) {
    const Vec3 n = triangle_normal(p[0].w, p[1].w, p[2].w);
    if (!(n.squared_norm() > flat * flat * (p[1].w - p[0].w).squared_norm())) simplex.count = 2;
  }
  if (simplex.count == 2 && !((p[1].w - p[0].w).norm() > flat)) simplex.count = 1;
  if (simplex.count == 1) {
    Real most = 0;
    for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)})
      if (!look_both_ways(
              difference, axis, [&](const Vec3& w) { return (w - p[0].w).norm(); }, p[1], most))
        return Build::fault;
    if (!(most > flat)) return Build::flat;
    simplex.count = 2;
  }
  if (simplex.count == 2) {
    const Vec3 along = (p[1].w - p[0].w).normalized();
    const Vec3 u = any_perpendicular(along), v = along.cross(u);
    Real most = 0;
    // Three directions 60 degrees apart (-1/2 and sqrt(3)/2), both ways: six sectors around the line.
    for (const Vec3& n : {Vec3(u.normalized()), Vec3((-0.5 * u + 0.8660254037844386 * v).normalized()),
                          Vec3((-0.5 * u - 0.8660254037844386 * v).normalized())})
      if (!look_both_ways(
              difference, n, [&](const Vec3& w) { return along.cross(w - p[0].w).norm(); }, p[2], most))
        return Build::fault;
    if (!(most > flat)) return Build::flat;
    simplex.count = 3;
  }
  const Vec3 n = triangle_normal(p[0].w, p[1].w, p[2].w).normalized();
  Real most = 0;
  if (!look_both_ways(
          difference, n, [&](const Vec3& w) { return n.dot(w - p[0].w); }, p[3], most))
    return Build::fault;
  if (!(most > flat)) return Build::flat;
  simplex.count = 4;
  return Build::solid;
}

constexpr Real kEpaNear = 4;  // roundings: the way to a feature that is there

/// How near a feature comes to a target: as its geometry says; then, since the weights of a sliver may name a point
/// anywhere along it, how far off the plane through the target that point is, and how far off the target. The first two
/// in steps of what rounding can tell.
struct Nearness {
  Real claimed2 = kInfinity, height = kInfinity, given2 = kInfinity;
  bool operator<(const Nearness& o) const {
    return std::tie(claimed2, height, given2) < std::tie(o.claimed2, o.height, o.given2);
  }
};

/// The point of a triangle, edge or vertex nearest to a target, as weights of its vertices, if it is nearer than
/// `best`.
void report_nearest(const DifferencePoint* p, int count, const Vec3& target, const Difference& difference,
                    DifferenceSimplex& simplex, Nearness& best) {
  Vec3 w[3];
  for (int i = 0; i < count; ++i) w[i] = p[i].w - target;
  Nearest nearest;
  nearest_voronoi(w, count, nearest);
  Vec3 v = Vec3::zero();
  for (int i = 0; i < nearest.count; ++i) v += nearest.weight[i] * w[nearest.index[i]];
  const Real rounding = difference.rounding(), near = kEpaNear * rounding;
  const Nearness here{std::max(nearest.distance2, near * near),
                      std::max(std::fabs(difference.normal().dot(v)), rounding), v.squared_norm()};
  if (!(here < best)) return;
  best = here;
  simplex.count = nearest.count;
  for (int i = 0; i < nearest.count; ++i) {
    simplex.point[i] = p[nearest.index[i]];
    simplex.weight[i] = nearest.weight[i];
  }
}

/// The witness: the point of the surface where the shortest way out of the difference ends, lower * normal. That way
/// may have been known before a face lay across it (GJK looked along it, a start point was sought there), so it is the
/// mesh that is asked, not the face looked along last. Of a face of a polytope that is cut into several, one holds the
/// point.
/// @param likely  the face that probably holds it: looked at first, it spares the others; -1: none
void report_witness(const Polytope& polytope, int likely, const Difference& difference, DifferenceSimplex& simplex) {
  const Vec3 out = difference.lower * difference.normal();
  const Real near = kEpaNear * difference.rounding();
  Nearness best;
  const auto look_at = [&](int f) {
    const Polytope::Face& face = polytope.face(f);
    // All of a face lies at its offset or beyond, whatever rounding did to its normal.
    const Real before = face.offset - face.normal.dot(out);
    if (!face.alive || (before > near && before * before >= best.claimed2)) return;
    DifferencePoint p[3];
    for (int i = 0; i < 3; ++i) p[i] = polytope.point(face.vertex[i]);
    report_nearest(p, 3, out, difference, simplex, best);
  };
  if (likely >= 0) look_at(likely);
  const auto there = [&] { return best.height <= difference.rounding() && best.given2 <= near * near; };
  for (int f = polytope.faces() - 1; f >= 0 && !there(); --f) look_at(f);
}

/// The same where the difference is flat: its triangle, edge or point is all there is.
void report_flat(const Difference& difference, DifferenceSimplex& simplex) {
  const DifferenceSimplex all = simplex;
  Nearness best;
  report_nearest(all.point, std::min(all.count, 3), difference.lower * difference.normal(), difference, simplex, best);
}

}  // namespace

EpaEnd epa(Difference& difference, Real gap, int cap, DifferenceSimplex& simplex, int& iterations) {
  const Build built = build_tetrahedron(difference, simplex);
  if (built == Build::fault) return EpaEnd::fault;
  if (difference.lower > difference.rounding()) return EpaEnd::apart;
  if (built == Build::flat) {
    report_flat(difference, simplex);
    return EpaEnd::flat;
  }

  Polytope polytope(difference.rounding());
  polytope.start(simplex.point);
  EpaEnd end = EpaEnd::stuck;
  int at = -1;
  for (;;) {
    // A ring of equal minimisers (a cone on its axis) would be refined all around to the cap. The last quarter of the
    // iterations therefore follows one branch down: the bound from below, which one direction can attain, gets exact.
    const bool follow = iterations >= cap - cap / 4 && polytope.newest() >= 0;
    at = follow ? polytope.newest() : polytope.nearest();
    const Polytope::Face& face = polytope.face(at);
    const Vec3 normal = face.normal;
    const Real offset = face.offset;
    // Nearer than rounding, or behind the origin: the mesh may not hold the origin yet, and proves nothing. Farther out
    // than the best supporting plane: nothing lies between.
    if (!follow && offset > difference.rounding())
      difference.upper = std::min(difference.upper, std::max(-offset, difference.lower));
    if (difference.upper - difference.lower <= gap) {
      end = EpaEnd::narrow;
      break;
    }
    if (iterations >= cap) {
      end = EpaEnd::capped;
      break;
    }
    ++iterations;
    DifferencePoint& fresh = polytope.next();
    Real value = 0;
    if (!difference.support(-normal, fresh, value)) return EpaEnd::fault;
    if (-value < offset - difference.slack()) {
      difference.blame_worse(-normal, fresh, polytope.point(face.vertex[0]));
      return EpaEnd::fault;
    }
    if (follow && -value - offset <= gap) {
      end = EpaEnd::capped;
      break;
    }
    if (difference.lower > difference.rounding()) return EpaEnd::apart;
    if (difference.upper - difference.lower <= gap) {
      end = EpaEnd::narrow;
      break;
    }
    // A point of the mesh lies above no face by more than rounding: only there can it come back.
    if (-value - offset <= 4 * difference.rounding() && polytope.has(fresh.w)) break;
    if (!polytope.add(at)) break;
  }
  report_witness(polytope, at, difference, simplex);
  return end;
}

}  // namespace carom::collision
