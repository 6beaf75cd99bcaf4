// The signed distance of any two convex shapes: GJK on the cores, EPA where they overlap, one bracket for both.
#include <algorithm>

#include "collision/narrow/coaxial.h"
#include "collision/narrow/hybrid.h"

namespace carom::collision {

namespace {

/// What can be said when nothing can be asked: a support function failed, or the pose is not finite.
void give_up(QueryResult& result, QueryStatus status) {
  result.status = status;
  result.separation = 0;
  result.lower = -kInfinity;
  result.upper = kInfinity;
}

void write_points(const Difference& difference, const DifferenceSimplex& simplex, const Shape& a, const Shape& b,
                  const Frame& b_in_a, Real shell, QueryResult& result) {
  Vec3 on_a = Vec3::zero(), on_b = Vec3::zero();
  for (int i = 0; i < simplex.count; ++i) {
    on_a += simplex.weight[i] * simplex.point[i].a;
    on_b += simplex.weight[i] * simplex.point[i].b;
  }
  const Vec3& n = difference.normal();
  result.point_a = on_a + (a.core_radius + 0.5 * shell) * n;
  result.point_b = on_b - (b.core_radius + 0.5 * shell) * b_in_a.rotate_inverse(n);
}

struct Bounds {
  Real lower, upper;
  Vec3 normal;
  explicit Bounds(const Difference& d) : lower(d.lower), upper(d.upper), normal(d.normal()) {}
  void restore(Difference& d) const {
    d.set_lower(lower, normal);
    d.upper = upper;
  }
};

/// EPA, in the half-plane alone where the pair is one of revolution. Where it is one only nearly, and that is not good
/// enough, EPA as for any pair; of two brackets the narrower one, with its own normal and witness.
EpaEnd penetrate(Difference& difference, const Shape& a, const Shape& b, const Frame& b_in_a, Real gap, int cap,
                 DifferenceSimplex& simplex, int& iterations) {
  constexpr Real kNearly = 1e-3;  // scaled: a ring more uneven than this has few equal faces, and EPA does better
  const Axis axis = common_axis(a, b, b_in_a);
  const Real uneven = difference.to_scaled(axis.uneven);
  if (!(uneven <= kNearly)) return epa(difference, gap, cap, simplex, iterations);
  const Bounds before(difference);
  DifferenceSimplex ring;
  const EpaEnd even = coaxial(difference, axis, std::max(gap, 8 * uneven), cap, ring, iterations);
  if (even == EpaEnd::fault || even == EpaEnd::apart) return even;
  const Bounds known(difference);
  if (even == EpaEnd::flat || known.upper - known.lower > gap) {
    before.restore(difference);
    const EpaEnd end = iterations < cap ? epa(difference, gap, cap, simplex, iterations) : EpaEnd::capped;
    const bool narrower = even != EpaEnd::flat && known.upper - known.lower < difference.upper - difference.lower;
    if (!narrower || end == EpaEnd::fault || end == EpaEnd::apart) return end;
    known.restore(difference);
    simplex = ring;
    return end;
  }
  simplex = ring;
  return EpaEnd::narrow;
}

}  // namespace

void generic_distance(const Shape& a, const Shape& b, const Frame& b_in_a, const QuerySettings& settings,
                      QueryMemory* memory, QueryResult& result, SupportFault& fault) {
  result = QueryResult();
  const Real shell = shells(settings);
  Difference difference(a, b, b_in_a, shell);
  if (!difference.usable()) return give_up(result, QueryStatus::rounding);

  const Real rounding = difference.rounding(), radii = difference.radii();
  const Real width = settings.tolerance * size_of_pair(a, b, b_in_a), asked = difference.to_scaled(width);
  GjkRequest request;
  request.solver = simplex_solver(settings.simplex);
  // The bracket is widened by rounding on both sides; a gap far below that can't be told from none.
  request.gap = std::max(asked - 2 * rounding, rounding);
  request.farther = difference.to_scaled(settings.max_distance) + radii + rounding;
  request.cap = std::max(settings.gjk_cap, 1);
  request.guess = GuessPolicy::of(a, b);
  const int epa_cap = std::clamp(settings.epa_cap, 1, kMaxEpaIterations);

  const bool warm = memory && memory->direction.squared_norm() > 0;
  Vec3 first = warm ? memory->direction : difference.centre_offset();
  // Where the last walk ended; what proves its upper bound if that does not; what proved it in the walk before.
  DifferenceSimplex simplex, spare, proof;
  bool deep = false, lowered = false, capped = false, bad = false;
  // EPA is also the judge of GJK's verdict: if it finds a separating direction, GJK goes on from there. Once.
  for (int attempt = 0; attempt < 2; ++attempt) {
    const Real before = difference.upper;
    const GjkEnd end = gjk(difference, request, first, simplex, spare, result.gjk_iterations);
    lowered = difference.upper < before;  // else the walk before came nearer, and proof is of that one
    bad = end == GjkEnd::fault;
    capped = end == GjkEnd::capped;
    result.farther = end == GjkEnd::farther;
    // Stuck or capped without a separating direction: only EPA can tell.
    const bool unknown = (end == GjkEnd::stuck || end == GjkEnd::capped) && difference.lower <= rounding;
    const bool again = end == GjkEnd::stuck && !unknown && difference.upper - difference.lower > request.gap;
    if (!again && end != GjkEnd::overlap && !unknown) break;
    if (lowered) proof = spare.count > 0 ? spare : simplex;
    lowered = false;
    if (again) {
      // Apart, but a degenerate simplex let no walk go on: another one, from the best direction, seldom meets it again.
      first = difference.normal();
      request.solver = nearest_voronoi;
      request.guess.patience = -1;
      continue;
    }
    deep = true;
    const Real proven = difference.upper;
    const EpaEnd judged = penetrate(difference, a, b, b_in_a, request.gap, epa_cap, simplex, result.epa_iterations);
    bad = judged == EpaEnd::fault;
    capped = judged == EpaEnd::capped;
    if (judged != EpaEnd::apart) break;
    deep = false;
    difference.upper = proven;  // EPA may have come nearer on its way, but kept no witness of it
    first = difference.normal();
  }
  result.support_calls = difference.calls;
  if (bad) {
    fault = difference.fault;
    return give_up(result, QueryStatus::fault);
  }

  // An imprecise support function may put the bounds past each other by its own error: the bracket takes in both.
  const Real lower = std::min(difference.lower, difference.upper), upper = std::max(difference.lower, difference.upper);
  result.separation = difference.to_metres(difference.lower - radii);
  result.lower = difference.to_metres(lower - radii - rounding);
  result.upper = difference.to_metres(upper - radii + rounding);
  result.normal = difference.normal();
  const DifferenceSimplex& nearest = lowered ? (spare.count > 0 ? spare : simplex) : proof;
  write_points(difference, deep ? simplex : nearest, a, b, b_in_a, shell, result);
  if (result.upper - result.lower <= width || result.farther)
    result.status = QueryStatus::exact_enough;
  else
    result.status = capped ? QueryStatus::capped : QueryStatus::rounding;
  // A separating direction starts the next walk near its end. The normal of a deep contact would start it at a sliver,
  // which EPA inherits: forget it.
  if (memory) memory->direction = deep ? Vec3(Vec3::zero()) : difference.normal();
}

}  // namespace carom::collision
