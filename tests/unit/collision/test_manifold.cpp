// Contact points kept from step to step: what is refreshed, dropped, replaced and chosen.
#include <algorithm>
#include <vector>

#include "carom_test.h"
#include "collision/manifold/manifold.h"
#include "shapes.h"

using namespace carom;
using namespace carom::test;

namespace {

const ManifoldSettings kSettings{ManifoldKind::cache, 0.02, 0.01};

/// A point on the plane y = 0 of A, touching B (same frame) with a separation along +y.
ContactPoint touch(Real x, Real z, Real separation, std::uint32_t feature = 0) {
  ContactPoint p;
  p.on_a = Vec3(x, 0, z);
  p.on_b = Vec3(x, separation, z);
  p.normal = Vec3::unit_y();
  p.separation = separation;
  p.feature = feature;
  return p;
}

Candidates found_of(const std::vector<ContactPoint>& points, bool whole = false) {
  Candidates c;
  c.whole = whole;
  for (const ContactPoint& p : points) c.add() = p;
  return c;
}

bool holds(const Manifold& m, Real x, Real z) {
  return std::any_of(m.point, m.point + m.count,
                     [&](const ContactPoint& p) { return (p.on_a - Vec3(x, 0, z)).norm() < 1e-12; });
}

Real cross(const ContactPoint& o, const ContactPoint& p, const ContactPoint& q) {
  return (p.on_a.z() - o.on_a.z()) * (q.on_a.x() - o.on_a.x()) - (p.on_a.x() - o.on_a.x()) * (q.on_a.z() - o.on_a.z());
}

/// Area of the hull of up to four points: the largest of its three ways to be two triangles, or one triangle.
Real area(const std::vector<ContactPoint>& p) {
  if (p.size() < 3) return 0;
  if (p.size() == 3) return std::fabs(cross(p[0], p[1], p[2])) / 2;
  Real best = 0;
  const int order[3][4] = {{0, 1, 2, 3}, {0, 2, 1, 3}, {0, 1, 3, 2}};
  for (const auto& o : order)  // |cross product of the diagonals| / 2
    best = std::max(best, std::fabs((p[o[2]].on_a - p[o[0]].on_a).cross(p[o[3]].on_a - p[o[1]].on_a).y()) / 2);
  return best;
}

}  // namespace

static void the_single_manifold_holds_the_deepest_point_and_counts_its_steps(void**) {
  Manifold m;
  for (std::uint32_t step = 0; step < 3; ++step) {
    keep_deepest(found_of({touch(0, 0, 0.002), touch(1, 0, -0.003), touch(2, 0, 0)}), kSettings, m);
    assert_int_equal(m.count, 1);
    assert_true(m.point[0].separation == -0.003);
    assert_int_equal(m.point[0].age, step);
  }
  keep_deepest(found_of({touch(0, 0, -0.004)}), kSettings, m);  // another point
  assert_int_equal(m.point[0].age, 0);
  keep_deepest(found_of({touch(0, 0, 0.0101)}), kSettings, m);  // beyond the contact distance
  assert_int_equal(m.count, 0);
}

static void one_point_a_step_gathers_to_four(void**) {
  const Frame at;
  Manifold m;
  const Real corner[4][2] = {{-1, -1}, {1, 1}, {-1, 1}, {1, -1}};
  for (int step = 0; step < 8; ++step) {
    update_cache(at, at, found_of({touch(corner[step % 4][0], corner[step % 4][1], -1e-4)}), kSettings, m);
    assert_int_equal(m.count, std::min(step + 1, 4));
  }
  for (int k = 0; k < 4; ++k) {
    assert_true(holds(m, corner[k][0], corner[k][1]));
    assert_true(m.point[k].age >= 4);  // the first four, still the same points
  }
}

static void a_kept_point_is_measured_again_at_the_new_poses(void**) {
  const Frame at;
  Manifold m;
  update_cache(at, at, found_of({touch(-1, 0, -1e-3)}), kSettings, m);
  Frame b;
  b.p.y() = 0.004;  // B rose by 4 mm
  update_cache(at, b, found_of({touch(1, 0, 0.003)}), kSettings, m);
  assert_int_equal(m.count, 2);
  const ContactPoint& old = m.point[0].on_a.x() < 0 ? m.point[0] : m.point[1];
  assert_true(std::fabs(old.separation - 0.003) < 4 * kEpsilon);
  assert_int_equal(old.age, 1);
}

static void a_point_that_opens_slides_or_turns_is_dropped(void**) {
  const Frame at;
  const Candidates far_away = found_of({touch(5, 0, -1e-3)});
  const auto left = [&](const Frame& b, const Candidates& found) {
    Manifold m;
    update_cache(at, at, found_of({touch(-1, 0, 0)}), kSettings, m);
    update_cache(at, b, found, kSettings, m);
    return m.count;
  };
  Frame b;
  assert_int_equal(left(b, far_away), 2);
  b.p = Vec3(0, 0.0099, 0);
  assert_int_equal(left(b, far_away), 2);
  b.p = Vec3(0, 0.0101, 0);  // opened past the contact distance
  assert_int_equal(left(b, far_away), 1);
  b.p = Vec3(0.0199, 0, 0);
  assert_int_equal(left(b, far_away), 2);
  b.p = Vec3(0.0201, 0, 0);  // slid past the cache distance
  assert_int_equal(left(b, far_away), 1);
  b.p.set_zero();
  Candidates turned = far_away;
  turned.point[0].normal = Vec3(0.5, std::sqrt(0.75), 0);  // 30 degrees
  assert_int_equal(left(b, turned), 1);
  assert_int_equal(left(b, Candidates{}), 0);  // nothing within reach at all
}

static void a_near_duplicate_replaces_and_inherits_the_age(void**) {
  const Frame at;
  Manifold m;
  update_cache(at, at, found_of({touch(0, 0, -1e-3)}), kSettings, m);
  for (int step = 1; step <= 3; ++step) {
    update_cache(at, at, found_of({touch(0.004 * step, 0, -2e-3)}), kSettings, m);
    assert_int_equal(m.count, 1);
    assert_true(m.point[0].separation == -2e-3);
    assert_int_equal(m.point[0].age, step);
  }
}

static void a_whole_patch_replaces_everything_but_keeps_ages(void**) {
  const Frame at;
  Manifold m;
  update_cache(at, at, found_of({touch(-1, 0, 0), touch(3, 3, 0)}), kSettings, m);
  for (std::uint32_t step = 1; step <= 3; ++step) {
    const Real slide = 0.1 * step;  // too far to be near, so features tell
    update_cache(at, at, found_of({touch(slide, 0, 0, 7), touch(slide, 1, 0, 8), touch(slide, 2, 0.011, 9)}, true),
                 kSettings, m);
    assert_int_equal(m.count, 2);
    assert_int_equal(m.point[0].age, step - 1);
    assert_int_equal(m.point[1].age, step - 1);
  }
}

static void points_that_hover_do_not_displace_points_that_touch(void**) {
  const Frame at;
  Manifold m;
  // A thin plate: its four lower corners touch, the four upper ones lie within reach straight above them.
  std::vector<ContactPoint> points;
  for (const Real height : {0.009, 0.0})
    for (const Real x : {-1.0, 1.0})
      for (const Real z : {-1.0, 1.0}) points.push_back(touch(x, z, height));
  update_cache(at, at, found_of(points, true), kSettings, m);
  assert_int_equal(m.count, 4);
  for (int k = 0; k < 4; ++k) assert_true(m.point[k].separation == 0);
}

static void four_of_many_hold_the_deepest_and_an_eighth_of_the_best_area(void**) {
  // Farthest point q from the deepest p, then the one that lies h beside the line: all points lie within |pq| of p, and
  // within h of the line, so no quadrilateral is larger than 4 |pq| h; the triangle alone has |pq| h / 2.
  Random random(1);
  for (int trial = 0; trial < 300; ++trial) {
    std::vector<ContactPoint> points;
    const Real length = random.uniform(0.01, 10), aspect = random.uniform(0.001, 1);
    for (int i = 0; i < 8; ++i)
      points.push_back(
          touch(length * random.uniform(-1, 1), length * aspect * random.uniform(-1, 1), i == 5 ? -2e-4 : 0));
    Manifold m;
    update_cache(Frame(), Frame(), found_of(points, true), {ManifoldKind::cache, 1e-6, 0.01}, m);
    assert_int_equal(m.count, 4);
    assert_true(std::any_of(m.point, m.point + 4, [](const ContactPoint& p) { return p.separation == -2e-4; }));
    // Weighed by their height, 2e-4 m over the deepest is worth 4 mm of extent.
    Real best = 0;
    for (int mask = 0; mask < 256; ++mask) {
      std::vector<ContactPoint> some;
      for (int i = 0; i < 8; ++i)
        if (mask >> i & 1) some.push_back(points[static_cast<std::size_t>(i)]);
      if (some.size() == 4) best = std::max(best, area(some));
    }
    assert_true(area({m.point, m.point + 4}) >= best / 8);
  }
}

static void the_choice_does_not_depend_on_noise_in_the_depths(void**) {
  // An octagon of equal depths, each with a jitter of a micrometre: the four stay the same points, and age.
  Random random(2);
  Manifold m;
  for (int step = 0; step < 100; ++step) {
    std::vector<ContactPoint> points;
    for (int i = 0; i < 8; ++i) {
      const SinCos at = sin_cos(0.1 + i * 0.78539816339744830962);
      points.push_back(touch(at.cos, at.sin, random.uniform(-1e-6, 1e-6), static_cast<std::uint32_t>(i + 1)));
    }
    update_cache(Frame(), Frame(), found_of(points, true), kSettings, m);
    assert_int_equal(m.count, 4);
    for (int k = 0; k < 4; ++k) assert_int_equal(m.point[k].age, step);
  }
}

static void coincident_points_are_no_trouble(void**) {
  Manifold m;
  update_cache(Frame(), Frame(), found_of(std::vector<ContactPoint>(8, touch(1, 1, 0)), true), kSettings, m);
  assert_int_equal(m.count, 4);
  for (int k = 0; k < 4; ++k) assert_true(holds(m, 1, 1));
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(the_single_manifold_holds_the_deepest_point_and_counts_its_steps),
      cmocka_unit_test(one_point_a_step_gathers_to_four),
      cmocka_unit_test(a_kept_point_is_measured_again_at_the_new_poses),
      cmocka_unit_test(a_point_that_opens_slides_or_turns_is_dropped),
      cmocka_unit_test(a_near_duplicate_replaces_and_inherits_the_age),
      cmocka_unit_test(a_whole_patch_replaces_everything_but_keeps_ages),
      cmocka_unit_test(points_that_hover_do_not_displace_points_that_touch),
      cmocka_unit_test(four_of_many_hold_the_deepest_and_an_eighth_of_the_best_area),
      cmocka_unit_test(the_choice_does_not_depend_on_noise_in_the_depths),
      cmocka_unit_test(coincident_points_are_no_trouble),
  };
  return cmocka_run_group_tests_name("collision/manifold", tests, nullptr, nullptr);
}
