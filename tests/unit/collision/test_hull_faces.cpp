// Faces gathered from a hull's triangles: how many, with which corners, and that nothing sticks out of them.
#include <algorithm>
#include <vector>

#include "carom_test.h"
#include "core/pose.h"
#include "shapes.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr Real kPi = 3.14159265358979323846;

Vec3 corner(const Shape& s, std::size_t i) {
  const HullFaces& f = s.faces;
  const double* v = (f.own.empty() ? s.vertices.data() : f.own.data()) + 3 * f.loop[i];
  return Vec3(v[0], v[1], v[2]);
}

/// Outward, in one plane, convex and counter-clockwise, with the whole shape behind. @return total area
Real assert_sound(const Shape& s) {
  const HullFaces& f = s.faces;
  const Real tolerance = 1e-9 * 2 * s.bounding_radius;
  Real total = 0;
  assert_int_equal(f.begin.size(), f.count() + 1);
  for (std::size_t k = 0; k < f.count(); ++k) {
    const Vec3& n = f.normal[k];
    assert_true(std::fabs(n.norm() - 1) < 8 * kEpsilon);
    const std::size_t first = f.begin[k], end = f.begin[k + 1];
    assert_true(end - first >= 3);
    const Real height = n.dot(corner(s, first));
    assert_true(n.dot(support_point(s, n)) - height < 2 * tolerance);
    for (std::size_t i = first; i < end; ++i) {
      const Vec3 a = corner(s, i), b = corner(s, i + 1 < end ? i + 1 : first),
                 c = corner(s, i + 2 < end ? i + 2 : first + i + 2 - end);
      assert_true(std::fabs(n.dot(a) - height) <= tolerance);
      assert_true((b - a).cross(c - b).dot(n) > 0);
      total += a.cross(b).dot(n) / 2;
    }
  }
  return total;
}

}  // namespace

static void a_box_has_six_faces_of_four_corners_either_way(void**) {
  const Vec3 half(0.3, 0.2, 0.4);
  Shape direct = box(half);
  make_faces(direct);
  std::vector<Vec3> points;
  for (int i = 0; i < 8; ++i) points.push_back(Vec3(i & 1 ? 0.3 : -0.3, i & 2 ? 0.2 : -0.2, i & 4 ? 0.4 : -0.4));
  Shape cloud = hull(points);
  make_faces(cloud);
  for (const Shape* s : {&direct, &cloud}) {
    assert_int_equal(s->faces.count(), 6);
    assert_int_equal(s->faces.loop.size(), 24);
    assert_true(std::fabs(assert_sound(*s) - 8 * (0.06 + 0.08 + 0.12)) < 1e-12);
  }
}

static void turned_prisms_of_many_sides_keep_their_faces_whole(void**) {
  // Rotation rounds every vertex, so that no two triangles of a face lie in quite the same plane.
  Random random(1);
  for (const int n : {3, 4, 5, 7, 16, 100})
    for (int trial = 0; trial < 10; ++trial) {
      const Mat3 r = exp_map(3 * random.direction()).matrix();
      const Vec3 off = random.in_cube(1);
      std::vector<Vec3> points;
      for (int i = 0; i < n; ++i) {
        const SinCos c = sin_cos(2 * kPi * i / n);
        for (const Real y : {-0.2, 0.2}) points.push_back(r * Vec3(c.cos, y, c.sin) + off);
      }
      points.push_back(r * Vec3(0.01, 0.2, 0.02) + off);  // within a face: no corner of it
      points.push_back(points.front());                   // twice
      Shape s = hull(points);
      make_faces(s);
      assert_int_equal(s.faces.count(), n + 2);
      assert_int_equal(s.faces.loop.size(), 6 * n);
      assert_sound(s);
    }
}

static void random_clouds_are_closed(void**) {
  // The vector areas of a closed surface cancel.
  Random random(2);
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<Vec3> points;
    for (int i = 0; i < 40; ++i) points.push_back(random.direction());
    Shape s = hull(points);
    make_faces(s);
    assert_sound(s);
    Vec3 sum = Vec3::zero();
    for (std::size_t k = 0; k < s.faces.count(); ++k)
      for (std::size_t i = s.faces.begin[k]; i < s.faces.begin[k + 1]; ++i)
        sum += corner(s, i).cross(corner(s, i + 1 < s.faces.begin[k + 1] ? i + 1 : s.faces.begin[k])) / 2;
    assert_true(sum.norm() < 1e-12);
  }
}

/// A turned cube with points on its sides, rounded to single precision, has six faces; noise of ten times as much takes
/// them apart.
static void points_in_single_precision_lie_in_faces(void**) {
  for (const Real noise : {0.0, 1e-5}) {
    std::vector<Vec3> points;
    const Mat3 turn = exp_map(Vec3(0.3, -0.7, 0.2)).matrix();
    for (int i = 0; i < 27; ++i) {
      if (i == 13) continue;
      Vec3 p = turn * Vec3(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1) + Vec3(0.5, 0.2, 0.1);
      for (int k = 0; k < 3; ++k) p[k] = static_cast<float>(p[k] + noise * ((7 * i + 3 * k) % 5 - 2));
      points.push_back(p);
    }
    Shape s = hull(points);
    make_faces(s);
    assert_int_equal(s.faces.count() == 6, noise == 0);
  }
}

static void flat_clouds_and_curved_shapes_have_no_faces(void**) {
  Shape flat = hull({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(1, 1, 0), Vec3(0.5, 0.5, 0)});
  make_faces(flat);
  assert_true(flat.faces.empty());
  Shape point = hull({Vec3(1, 2, 3)});
  make_faces(point);
  assert_true(point.faces.empty());
  Shape ball = sphere(1);
  make_faces(ball);
  assert_true(ball.faces.empty());
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(a_box_has_six_faces_of_four_corners_either_way),
      cmocka_unit_test(turned_prisms_of_many_sides_keep_their_faces_whole),
      cmocka_unit_test(random_clouds_are_closed),
      cmocka_unit_test(points_in_single_precision_lie_in_faces),
      cmocka_unit_test(flat_clouds_and_curved_shapes_have_no_faces),
  };
  return cmocka_run_group_tests_name("collision/hull_faces", tests, nullptr, nullptr);
}
