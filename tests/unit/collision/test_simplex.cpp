// Three sub-algorithms against a slow one: every subset of the points, solved in long double.
#include <cstdio>

#include "carom_test.h"
#include "collision/narrow/simplex.h"
#include "shapes.h"

using namespace carom;
using namespace carom::test;

namespace {

using Long = long double;
using LongVec = Vector3<Long>;

/// Distance of the origin from the hull of some points: the nearest point of every subset's affine hull, kept where its
/// weights are not negative. Dependent subsets are left out: a smaller one has their nearest point.
Long slow_distance(const Vec3* w, int count) {
  Long best = std::numeric_limits<Long>::infinity();
  for (int subset = 1; subset < 1 << count; ++subset) {
    int member[4] = {0, 0, 0, 0}, n = 0;
    for (int i = 0; i < count; ++i)
      if (subset >> i & 1) member[n++] = i;
    const LongVec base = w[member[0]].cast<Long>();
    LongVec e[3];
    for (int i = 1; i < n; ++i) e[i - 1] = w[member[i]].cast<Long>() - base;
    // Least squares base + sum(t e) = 0 by Gram-Schmidt, so that long double's digits are not squared away.
    LongVec q[3];
    Long r[3][3] = {}, t[3] = {};
    bool independent = true;
    for (int i = 0; i < n - 1 && independent; ++i) {
      q[i] = e[i];
      for (int pass = 0; pass < 2; ++pass)
        for (int j = 0; j < i; ++j) {
          const Long projection = q[j].dot(q[i]);
          r[j][i] += projection;
          q[i] -= projection * q[j];
        }
      r[i][i] = q[i].norm();
      independent = r[i][i] > 1e-17L * e[i].norm();
      if (independent) q[i] /= r[i][i];
    }
    if (!independent) continue;
    LongVec v = base;
    for (int i = n - 2; i >= 0; --i) {
      t[i] = -q[i].dot(base);
      for (int j = i + 1; j < n - 1; ++j) t[i] -= r[i][j] * t[j];
      t[i] /= r[i][i];
    }
    Long first = 1;
    bool inside = true;
    for (int i = 0; i < n - 1; ++i) {
      inside = inside && t[i] >= 0;
      first -= t[i];
      v += t[i] * e[i];
    }
    if (inside && first >= 0) best = std::min(best, v.norm());
  }
  return best;
}

struct Case {
  Vec3 w[4];
  int count;
};

Real size_of(const Case& c) {
  Real size = 0;
  for (int i = 0; i < c.count; ++i) size = std::max(size, c.w[i].norm());
  return size;
}

/// |sum(weight w)| of an answer, and that its weights are weights. "Inside" is a verdict, 0: the weights of a thin
/// tetrahedron err by u over its thickness, and whoever takes a bound from them computes |v| himself.
Real length_of(const Case& c, const Nearest& nearest) {
  Vec3 v = Vec3::zero();
  Real sum = 0;
  for (int i = 0; i < nearest.count; ++i) {
    assert_true(nearest.weight[i] >= 0);
    assert_in_range(nearest.index[i], 0, c.count - 1);
    v += nearest.weight[i] * c.w[nearest.index[i]];
    sum += nearest.weight[i];
  }
  assert_true(std::fabs(sum - 1) <= 4 * kEpsilon);
  return nearest.inside ? 0 : v.norm();
}

/// Random points, then spoiled: 0 as they are, 1 nearly flat, 2 nearly a line, 3 a point twice, 4 on a line, 5 in a
/// plane with the origin, 6 far from the origin.
Case random_case(Random& random, int spoil) {
  Case c;
  c.count = 1 + static_cast<int>(random.uniform(0, 4));
  const Vec3 shift = random.in_cube(0.7);
  const Vec3 along = random.direction(), across = any_perpendicular(along);
  for (int i = 0; i < c.count; ++i) {
    Vec3 p = random.in_cube(1);
    if (spoil == 1) p -= (1 - 1e-9) * along * along.dot(p);
    if (spoil == 2) p = along * along.dot(p) + 1e-9 * p;
    if (spoil == 3 && i == 3) p = c.w[1] - shift;
    if (spoil == 4) p = along * p.x();
    if (spoil == 5) p -= across * across.dot(p);
    c.w[i] = p + (spoil == 5 ? Vec3(shift - across * across.dot(shift)) : shift);
    if (spoil == 6) c.w[i] += 1000 * along;
  }
  return c;
}

constexpr int kSpoils = 7;

}  // namespace

static void all_features_agree_with_the_slow_search(void**) {
  for (const SimplexSolver solver : {nearest_johnson, nearest_voronoi}) {
    for (int spoil = 0; spoil < kSpoils; ++spoil) {
      Random random(11 + spoil);
      for (int i = 0; i < 3000; ++i) {
        const Case c = random_case(random, spoil);
        Nearest nearest;
        solver(c.w, c.count, nearest);
        const Real error = length_of(c, nearest) - static_cast<Real>(slow_distance(c.w, c.count));
        // Never nearer than the truth by more than the weights' own rounding; never farther by more than the rounding
        // term of a query (16 u size), which is what the bracket is widened by.
        const Real allowed = 16 * kUnitRoundoff;
        if (!(error >= -8 * kUnitRoundoff * size_of(c) && error <= allowed * size_of(c)))
          std::printf("spoil %d case %d, %d points: %g u\n", spoil, i, c.count, error / (kUnitRoundoff * size_of(c)));
        assert_true(error >= -8 * kUnitRoundoff * size_of(c));
        assert_true(error <= allowed * size_of(c));
      }
    }
  }
}

static void the_newest_features_are_enough_in_a_walk(void**) {
  // As in GJK: the older points are a feature that holds its own nearest point v, and the newest lies nearer along v.
  for (int spoil = 0; spoil < kSpoils; ++spoil) {
    Random random(77 + spoil);
    for (int i = 0; i < 3000; ++i) {
      Case c = random_case(random, spoil);
      Nearest old;
      nearest_voronoi(c.w, c.count, old);
      if (old.count > 3 || !(old.direction.squared_norm() > 0)) continue;
      Case walk;
      for (int k = 0; k < old.count; ++k) walk.w[k] = c.w[old.index[k]];
      walk.count = old.count + 1;
      const Vec3 n = old.direction.normalized();
      Vec3 fresh = random.in_cube(1);
      // Well below the plane through v, so that rounding leaves no doubt that it is.
      fresh += (std::sqrt(old.distance2) - 0.1 - n.dot(fresh)) * n;
      walk.w[walk.count - 1] = fresh;
      Nearest all, last;
      nearest_voronoi(walk.w, walk.count, all);
      nearest_voronoi_last(walk.w, walk.count, last);
      // Each is within 16 u above and 8 u below the truth.
      const Real difference = length_of(walk, last) - length_of(walk, all);
      if (!(std::fabs(difference) <= 24 * kUnitRoundoff * size_of(walk)))
        std::printf("spoil %d case %d, %d points: %g u\n", spoil, i, walk.count,
                    difference / (kUnitRoundoff * size_of(walk)));
      assert_true(std::fabs(difference) <= 24 * kUnitRoundoff * size_of(walk));
    }
  }
}

static void the_direction_supports_the_whole_feature(void**) {
  // n keeps right angles to the edge or face: all of its points have the same n . w, the distance.
  Random random(5);
  for (int i = 0; i < 5000; ++i) {
    const Case c = random_case(random, i % 3);
    Nearest nearest;
    nearest_voronoi(c.w, c.count, nearest);
    if (nearest.inside || !(nearest.direction.squared_norm() > 0)) continue;
    const Vec3 n = nearest.direction.normalized();
    for (int k = 0; k < nearest.count; ++k)
      assert_true(std::fabs(n.dot(c.w[nearest.index[k]]) - std::sqrt(nearest.distance2)) <=
                  16 * kUnitRoundoff * size_of(c));
  }
}

static void a_tetrahedron_around_the_origin_holds_it(void**) {
  const Vec3 w[4] = {Vec3(1, 1, 1), Vec3(-1, -1, 1), Vec3(-1, 1, -1), Vec3(1, -1, -1)};
  for (const SimplexSolver solver : {nearest_johnson, nearest_voronoi, nearest_voronoi_last}) {
    Nearest nearest;
    solver(w, 4, nearest);
    assert_true(nearest.inside);
    for (const Real weight : nearest.weight) assert_true(weight == 0.25);
  }
}

static void one_point_four_times_is_that_point(void**) {
  const Vec3 p(0.3, -0.2, 0.5), w[4] = {p, p, p, p};
  for (const SimplexSolver solver : {nearest_johnson, nearest_voronoi, nearest_voronoi_last}) {
    for (int count = 1; count <= 4; ++count) {
      Nearest nearest;
      solver(w, count, nearest);
      assert_int_equal(nearest.count, 1);
      assert_false(nearest.inside);
      assert_true(nearest.distance2 == p.squared_norm());
    }
  }
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(all_features_agree_with_the_slow_search),
      cmocka_unit_test(the_newest_features_are_enough_in_a_walk),
      cmocka_unit_test(the_direction_supports_the_whole_feature),
      cmocka_unit_test(a_tetrahedron_around_the_origin_holds_it),
      cmocka_unit_test(one_point_four_times_is_that_point),
  };
  return cmocka_run_group_tests_name("collision/simplex", tests, nullptr, nullptr);
}
