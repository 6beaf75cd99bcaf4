// The constants of collision/narrow/rounding.h against arithmetic with eleven bits more: what rounding really did to a
// support point, to a bound and to a pose, in units of u M, stays below what is claimed for every input.
#include <algorithm>
#include <array>
#include <cstdio>
#include <functional>

#include "carom_test.h"
#include "collision/narrow/rounding.h"
#include "random_pairs.h"

using namespace carom;
using namespace carom::test;

namespace {

using Long = long double;  // 64 bits of mantissa: 2^-11 of u
using Long3 = Vector3<Long>;
using LongMat = Matrix3<Long>;

constexpr Long kU = kUnitRoundoff;

/// h(d) of the core, from the closed form.
Long support_value(const Shape& s, const Long3& d) {
  const Long side = std::sqrt(d.x() * d.x() + d.z() * d.z());
  switch (s.form) {
    case Form::sphere:
      return 0;
    case Form::capsule:
      return s.half_height * std::fabs(d.y());
    case Form::cylinder:
      return s.half_height * std::fabs(d.y()) + s.radius * side;
    case Form::cone:
      return std::max(s.half_height * d.y(), s.radius * side - s.half_height * d.y());
    case Form::ellipsoid:
      return d.times(s.half.cast<Long>()).norm();
    case Form::polytope:
      break;
    default:
      return std::fabs(d.x()) * s.params[0] + std::fabs(d.y()) * s.params[1] + std::fabs(d.z()) * s.params[2];
  }
  Long h = -INFINITY;
  for (std::size_t k = 0; k < s.params.size(); k += 3)
    h = std::max(h, d.x() * s.params[k] + d.y() * s.params[k + 1] + d.z() * s.params[k + 2]);
  return h;
}

/// How far x lies outside the core, at most: the largest excess over the support values of directions around it.
Long excess(const Shape& s, const Long3& x, Random& random) {
  Long most = 0;
  for (int i = 0; i < 20; ++i) {
    const Long3 d = i == 0 ? Long3(x.normalized()) : Long3(random.direction().cast<Long>().normalized());
    if (carom::finite(static_cast<Real>(d.x()))) most = std::max(most, d.dot(x) - support_value(s, d));
  }
  return most;
}

Real any_order(Random& random, Real lo, Real hi) { return std::exp2(random.uniform(lo, hi)); }

/// Of any family, of any proportions: a thousandth to a thousand along each axis.
Shape odd_shape(Random& random) {
  const Real x = any_order(random, -10, 10), y = any_order(random, -10, 10), z = any_order(random, -10, 10);
  const int kind = static_cast<int>(random.uniform(0, kFormCount + 1));
  if (kind < kFormCount) return shape_of(kForms[kind], Vec3(x, y, z));
  std::vector<Vec3> points;
  const Vec3 off = random.uniform(0, 1) < 0.5 ? Vec3(Vec3::zero()) : Vec3(random.in_cube(10 * x));
  for (int i = 0; i < 20; ++i) points.push_back(off + Vec3(x, y, z).times(random.direction()));
  return hull(points);
}

/// Directions that meet the shape's own ones: axes, edges, ties, all but for a rounding.
Vec3 odd_direction(Random& random) {
  Vec3 d = random.direction();
  const Real kind = random.uniform(0, 4);
  if (kind < 1) return d;
  for (int i = 0; i < 3; ++i)
    if (random.uniform(0, 1) < 0.5) d[i] *= any_order(random, -60, 0);
  if (kind < 2) d[0] = d[1];
  return d / d.norm();
}

Frame odd_frame(Random& random, Real distance) {
  Quat q = random_rotation(random);
  if (random.uniform(0, 1) < 0.3)
    q = normalized(Quat(1, 1, 1, 1));  // |R| as large as it gets: entries of size 2/3 next
  if (random.uniform(0, 1) < 0.3) q = normalized(Quat(1, 1, 1, 0));
  return Frame(q.matrix(), distance * random.direction());
}

LongMat exact_rotation(const Quat& q) {
  const Long x = q.x(), y = q.y(), z = q.z(), w = q.w(), n = x * x + y * y + z * z + w * w;
  const LongMat r(w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y),  //
                  2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x),  //
                  2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z);
  return r / n;
}

}  // namespace

static void support_points_are_the_best_to_the_roundings_claimed(void**) {
  Random random(1);
  Long short_of = 0, outside = 0;
  for (int i = 0; i < 40000; ++i) {
    const Shape s = odd_shape(random);
    const Vec3 d = odd_direction(random);
    const Long3 x = (support_point(s, d) - s.core_radius * d).cast<Long>();
    const Long unit = kU * s.bounding_radius;
    short_of = std::max(short_of, (support_value(s, d.cast<Long>()) - d.cast<Long>().dot(x)) / unit);
    if (s.core_radius == 0) outside = std::max(outside, excess(s, x, random) / unit);
  }
  std::printf("support points: %.2Lf u short, %.2Lf u outside, of %g\n", short_of, outside, kSupportRounding);
  assert_true(short_of <= kSupportRounding && outside <= kSupportRounding);
}

static void bounds_err_by_less_than_the_bracket_is_widened(void**) {
  Random random(2);
  Long below = 0, above = 0;
  for (int i = 0; i < 20000; ++i) {
    const Shape a = odd_shape(random), b = odd_shape(random);
    const Real reach = a.bounding_radius + b.bounding_radius;
    const Frame b_in_a = odd_frame(random, reach * any_order(random, -6, i % 4 ? 1 : 20));
    const Long size = b_in_a.p.abs().sum() + reach;
    QuerySettings settings;
    settings.tolerance = any_order(random, -45, -3);
    QueryResult r;
    SupportFault fault;
    generic_distance(a, b, b_in_a, settings, nullptr, r, fault);
    if (!carom::finite(r.lower)) continue;
    // What the reported normal proves, had nothing been rounded: n.p - h_B(-R'n) - h_A(n) over |n|, radii off.
    const Long3 n = r.normal.cast<Long>();
    const Long3 n_b = -(b_in_a.r.cast<Long>().transpose() * n);
    const Long radii = static_cast<Long>(a.core_radius) + b.core_radius;
    const Long proved = (n.dot(b_in_a.p.cast<Long>()) - support_value(b, n_b) - support_value(a, n)) / n.norm() - radii;
    below = std::max(below, (r.separation - proved) / (kU * size));
    assert_true(r.upper - proved >= -kU * size);  // s* >= proved, and the bracket holds s*
    // Apart, the witness points are points of the shapes; the distance between them, unrounded, bounds s* from above.
    if (r.separation > 0 && a.core_radius == 0 && b.core_radius == 0) {
      const Long3 gap = b_in_a.r.cast<Long>() * r.point_b.cast<Long>() + b_in_a.p.cast<Long>() - r.point_a.cast<Long>();
      const Long reported = static_cast<Long>(r.upper) - kBracketRounding * kU * size;
      above = std::max(above, (gap.norm() - reported) / (kU * size));
    }
  }
  std::printf("bounds: %.2Lf u M below, %.2Lf u M above, of %g\n", below, above, kBracketRounding);
  assert_true(below > 0 && below <= kBracketRounding && above <= kBracketRounding);
}

static void a_relative_pose_errs_by_less_than_claimed(void**) {
  Random random(3);
  Long most = 0;
  for (int i = 0; i < 100000; ++i) {
    Quat q[2];
    for (Quat& each : q) {
      each = random_rotation(random);
      const Real length = 1 + random.uniform(-1e-6, 1e-6);  // what the interface accepts
      each = Quat(each.w() * length, each.x() * length, each.y() * length, each.z() * length);
      if (random.uniform(0, 1) < 0.2) each = Quat(0, each.x(), any_order(random, -50, 0), 0);  // about 180 degrees
    }
    const Vec3 p[2] = {1e6 * random.direction(), 1e6 * random.direction()};
    const Vec3 x = any_order(random, -10, 24) * random.direction();
    const Frame got = relative(Frame(Pose{normalized(q[0]), p[0]}), Frame(Pose{normalized(q[1]), p[1]}));
    const Long3 apart = p[1].cast<Long>() - p[0].cast<Long>();
    const LongMat turn = exact_rotation(q[0]).transpose();
    const Long3 truth = turn * (exact_rotation(q[1]) * x.cast<Long>() + apart);
    const Long3 moved = got.r.cast<Long>() * x.cast<Long>() + got.p.cast<Long>();
    most = std::max(most, (moved - truth).norm() / (kU * (apart.norm() + x.norm())));
  }
  std::printf("relative pose: %.2Lf u, of %g\n", most, kPoseRounding);
  assert_true(most > 0 && most <= kPoseRounding);
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(support_points_are_the_best_to_the_roundings_claimed),
      cmocka_unit_test(bounds_err_by_less_than_the_bracket_is_widened),
      cmocka_unit_test(a_relative_pose_errs_by_less_than_claimed),
  };
  return cmocka_run_group_tests_name("oracle/rounding", tests, nullptr, nullptr);
}
