// The walk of GJK: look along the feature nearest to the origin, add what is found, keep the feature that is nearest
// now.
#include "collision/narrow/gjk.h"

#include <algorithm>
#include <bit>
#include <type_traits>

namespace carom::collision {

namespace {

/// Keep the points of a feature, oldest first, and the upper bound that its weights prove.
/// @param w      [4][3] of the simplex' points, kept with them
/// @param spare  the simplex that proves the upper bound, where this one does not (a thin one's weights are inexact)
void keep(DifferenceSimplex& simplex, Vec3* w, const Nearest& nearest, Difference& difference,
          DifferenceSimplex& spare) {
  Real weight[4] = {-1, -1, -1, -1};
  Vec3 v = Vec3::zero();
  for (int i = 0; i < nearest.count; ++i) {
    weight[nearest.index[i]] = nearest.weight[i];
    v += nearest.weight[i] * w[nearest.index[i]];
  }
  // Whatever rounding did to the feature, v is a point of the difference: its length is a valid bound.
  const Real length = v.norm();
  if (length <= difference.upper) {
    difference.upper = length;
    spare.count = 0;
  } else if (spare.count == 0) {
    spare = simplex;
  }
  const int known = simplex.count + 1;
  simplex.count = 0;
  for (int i = 0; i < known; ++i) {
    if (weight[i] < 0) continue;
    const int to = simplex.count++;
    if (to != i) {
      simplex.point[to] = simplex.point[i];
      w[to] = w[i];
    }
    simplex.weight[to] = weight[i];
  }
}

bool repeated(const Vec3* w, int count) {
  for (int i = 0; i < count; ++i)
    if (w[i] == w[count]) return true;
  return false;
}

/// The bounds have passed each other, so some point of the simplex lies below the supporting plane: which is none then.
GjkEnd contradiction(Difference& difference, const DifferenceSimplex& simplex) {
  const Vec3 n = difference.normal();
  DifferencePoint claimed;
  Real value = 0;
  if (!difference.support(n, claimed, value)) return GjkEnd::fault;
  int lowest = 0;
  for (int i = 1; i < simplex.count; ++i)
    if (n.dot(simplex.point[i].w) < n.dot(simplex.point[lowest].w)) lowest = i;
  difference.blame_worse(n, claimed, simplex.point[lowest]);
  return GjkEnd::fault;
}

/// The bracket is narrow, or far enough out; far past narrow, it is no bracket.
GjkEnd close(Difference& difference, const DifferenceSimplex& simplex, GjkEnd end) {
  return difference.lower > difference.upper + difference.slack() ? contradiction(difference, simplex) : end;
}

/// The nearest feature of the points, nearer than `before`; false if there is none.
bool descend(const GjkRequest& request, const Difference& difference, const Vec3* w, int count, Real before,
             Nearest& nearest) {
  request.solver(w, count, nearest);
  // "Inside" contradicts a separating direction already found: only a degenerate tetrahedron says so.
  const auto good = [&] {
    return nearest.inside ? difference.lower <= difference.rounding() : nearest.distance2 < before;
  };
  if (good()) return true;
  nearest_voronoi(w, count, nearest);
  return good();
}

/// The same way, at a length in [1, 2): scaled by a power of two, which takes no root and no division and costs no bit.
/// @param length2  squared length, > 0
Vec3 about_unit(const Vec3& v, Real length2) {
  constexpr std::uint64_t kFraction = 52, kBias = 1023;  // bits of a double's fraction; the exponent field of 1
  // Of length2 the field is 1023 + 2 k or one more where the length is 2^k to 2^(k + 1): scaled by 2^-k.
  const std::uint64_t half_field = ((std::bit_cast<std::uint64_t>(length2) >> kFraction) + 1) / 2;
  return std::bit_cast<Real>((kBias + (kBias + 1) / 2 - half_field) << kFraction) * v;
}

struct NoGuess {
  void remember(const Vec3&, const Vec3&, Real) {}
  bool guess(bool, Vec3&) const { return false; }
};

/// @tparam kGuess  false: never, and nothing is kept for it
template <bool kGuess>
GjkEnd walk(Difference& difference, const GjkRequest& request, const Vec3& first, DifferenceSimplex& simplex,
            DifferenceSimplex& spare, int& iterations) {
  Vec3 n = Vec3::unit_x(), way = n;
  const Real length2 = first.squared_norm();
  if (length2 > 1e-200) {  // below, squares have lost their digits: any direction will do
    way = about_unit(first, length2);
    n = first / std::sqrt(length2);
  }

  Real value = 0;
  ++iterations;
  if (!difference.support(way, n, simplex.point[0], value)) return GjkEnd::fault;
  Vec3 w[4] = {simplex.point[0].w};  // of the simplex' points, side by side for the solver
  Nearest nearest;
  nearest_voronoi(w, 1, nearest);
  keep(simplex, w, nearest, difference, spare);

  std::conditional_t<kGuess, Secant, NoGuess> secant;
  secant.remember(n, w[0], value);
  Vec3 towards = nearest.direction;  // of the feature kept, as its distance is
  Real distance2 = nearest.distance2;
  int plain = request.guess.patience;  // steps to go before the next guess
  for (;;) {
    if (difference.lower > request.farther) return close(difference, simplex, GjkEnd::farther);
    if (difference.upper - difference.lower <= request.gap) return close(difference, simplex, GjkEnd::narrow);
    if (difference.upper <= difference.rounding()) return GjkEnd::overlap;
    if (iterations >= request.cap) return GjkEnd::capped;

    const Real d2 = towards.squared_norm();
    if (!(d2 > 0)) return GjkEnd::overlap;  // the origin is on the vertex or edge itself
    const Real best = difference.lower;
    const bool guessed = kGuess && --plain < 0 && best > difference.rounding() && secant.guess(request.guess.watch, n);
    way = guessed ? n : about_unit(towards, d2);
    if (!guessed) n = towards * (1 / std::sqrt(d2));
    DifferencePoint& fresh = simplex.point[simplex.count];
    ++iterations;
    if (!difference.support(way, n, fresh, value)) return GjkEnd::fault;
    secant.remember(n, fresh.w, value);
    if (guessed && !(difference.lower > best)) plain = request.guess.patience;
    if (difference.lower > request.farther) return close(difference, simplex, GjkEnd::farther);
    if (difference.upper - difference.lower <= request.gap) return close(difference, simplex, GjkEnd::narrow);
    w[simplex.count] = fresh.w;
    const bool known = repeated(w, simplex.count);
    if (known && !guessed) return GjkEnd::stuck;

    if (known) nearest.clear();
    if (known || !descend(request, difference, w, simplex.count + 1, distance2, nearest)) {
      if (guessed && !(nearest.inside && difference.lower > difference.slack())) {
        plain = request.guess.patience;  // no point to go down to, which only a plain step may take for the end
        continue;
      }
      if (!nearest.inside || difference.lower <= difference.slack()) return GjkEnd::stuck;
      // A tetrahedron around the origin, and a plane between them: no degenerate one errs by that much.
      ++simplex.count;
      return contradiction(difference, simplex);
    }
    towards = nearest.direction;
    distance2 = nearest.distance2;
    keep(simplex, w, nearest, difference, spare);
    if (nearest.inside && difference.upper - difference.lower > request.gap) return GjkEnd::overlap;
  }
}

}  // namespace

GjkEnd gjk(Difference& difference, const GjkRequest& request, const Vec3& first, DifferenceSimplex& simplex,
           DifferenceSimplex& spare, int& iterations) {
  simplex.count = spare.count = 0;
  if (request.guess.patience < 0) return walk<false>(difference, request, first, simplex, spare, iterations);
  return walk<true>(difference, request, first, simplex, spare, iterations);
}

}  // namespace carom::collision
