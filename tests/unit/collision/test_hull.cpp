// The hull of a point cloud: closed, convex, complete, on clouds chosen to hurt (coplanar, collinear, repeated,
// needles).
#include <map>
#include <set>

#include "carom_test.h"
#include "collision/hull.h"
#include "collision/volume.h"
#include "core/pose.h"
#include "shapes.h"

using namespace carom;
using namespace carom::test;

namespace {

using Cloud = std::vector<Vec3>;

struct Hull {
  bool solid = false;
  std::vector<double> xyz;
  Array<std::uint32_t> triangles;
};

Hull hull_of(const Cloud& cloud) {
  Hull h;
  for (const Vec3& p : cloud) h.xyz.insert(h.xyz.end(), {p.x(), p.y(), p.z()});
  h.solid = convex_hull(h.xyz, h.triangles);
  return h;
}

std::size_t vertices_of(const Hull& h) {
  return std::set<std::uint32_t>(h.triangles.begin(), h.triangles.end()).size();
}

Real volume_of(const Cloud& cloud) {
  const Shape s = hull(cloud);
  return mass_from_form(Form::polytope, 0, 0, Vec3::zero(), s.vertices).volume;
}

/// Every directed edge once and its reverse once, and V - E + F = 2: one closed surface without handles.
void assert_closed(const Hull& h) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (std::size_t t = 0; t < h.triangles.size(); t += 3)
    for (int i = 0; i < 3; ++i) ++edges[{h.triangles[t + i], h.triangles[t + (i + 1) % 3]}];
  for (const auto& [edge, count] : edges) {
    assert_int_equal(count, 1);
    assert_int_equal(edges.count({edge.second, edge.first}), 1);
  }
  const auto v = static_cast<long>(vertices_of(h)), e = static_cast<long>(edges.size() / 2),
             f = static_cast<long>(h.triangles.size() / 3);
  assert_int_equal(v - e + f, 2);
}

/// The deepest that any point lies outside any face whose plane is known, in units of the cloud's size. A face whose
/// height is below 1e-3 of its longest edge leaves its plane to rounding (u / 1e-3 per unit of length), so it is not
/// asked.
Real worst_outside(const Cloud& cloud, const Hull& h) {
  Real size = 0, worst = 0;
  for (const Vec3& p : cloud) size = std::max(size, (p - cloud[0]).norm());
  for (std::size_t t = 0; t < h.triangles.size(); t += 3) {
    const Vec3 &a = cloud[h.triangles[t]], &b = cloud[h.triangles[t + 1]], &c = cloud[h.triangles[t + 2]];
    const Vec3 cross = (b - a).cross(c - a);
    const Real longest = std::max({(b - a).squared_norm(), (c - a).squared_norm(), (c - b).squared_norm()});
    if (cross.norm() < 1e-3 * longest) continue;
    const Vec3 n = cross / cross.norm();
    for (const Vec3& p : cloud) worst = std::max(worst, n.dot(p - a));
  }
  return worst / size;
}

Mat3 some_rotation(Random& random) { return exp_map(2 * random.direction()).matrix(); }

Cloud grid(int n) {
  Cloud cloud;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j)
      for (int k = 0; k <= n; ++k) cloud.push_back(Vec3(i, j, k));
  return cloud;
}

Cloud moved(const Cloud& cloud, const Mat3& a, const Vec3& p) {
  Cloud out;
  for (const Vec3& x : cloud) out.push_back(a * x + p);
  return out;
}

Cloud on_sphere(Random& random, int n) {
  Cloud cloud;
  for (int i = 0; i < n; ++i) cloud.push_back(random.direction());
  return cloud;
}

/// Two rims of n points: caps with n coplanar, cocircular points, and n planar quadrilaterals.
Cloud prism(int n) {
  Cloud cloud;
  for (int i = 0; i < n; ++i) {
    const SinCos a = sin_cos(2 * 3.14159265358979323846 * i / n);
    cloud.push_back(Vec3(a.cos, 1, a.sin));
    cloud.push_back(Vec3(a.cos, -1, a.sin));
  }
  return cloud;
}

}  // namespace

// The hull is exact for points snapped to 2^-51 = 4 u of a frame in which the cloud is up to 3.5 wide; the planes here
// come from triangles no thinner than 1e-3 of their length, which magnifies that by 1e3 across the cloud.
static const Real kOutside = 4 * 3.5 * kUnitRoundoff * 1e3;

static void hulls_of_difficult_clouds_are_closed_and_leave_no_point_out(void**) {
  Random random(1);
  for (int trial = 0; trial < 12; ++trial) {
    const Mat3 r = trial == 0 ? Mat3(Mat3::identity()) : some_rotation(random);
    Cloud twice = on_sphere(random, 100);
    twice.insert(twice.end(), twice.begin(), twice.begin() + 50);
    Cloud nearly = on_sphere(random, 300);  // pairs 1e-14 apart
    for (int i = 0; i < 100; ++i) nearly.push_back(nearly[i] + 1e-14 * random.direction());
    Cloud ball;
    for (int i = 0; i < 500; ++i) ball.push_back(random.in_cube(1));
    for (const Cloud& cloud : {grid(4), prism(200), twice, nearly, ball, on_sphere(random, 700)}) {
      const Cloud turned = moved(cloud, r, trial % 2 ? Vec3(100, -50, 3) : Vec3(0, 0, 0));
      const Hull h = hull_of(turned);
      assert_true(h.solid);
      assert_closed(h);
      assert_true(worst_outside(turned, h) <= kOutside * (trial % 2 ? 100 : 1));
    }
  }
}

static void a_grid_of_points_has_the_volume_of_its_cube(void**) {
  for (const int n : {1, 2, 5, 12}) {
    const Cloud cloud = grid(n);
    // Integer points, mapped to a frame and back: a few roundings in each of three coordinates.
    assert_true(std::fabs(volume_of(cloud) - n * n * n) <= 16 * kEpsilon * n * n * n);
    assert_closed(hull_of(cloud));
  }
}

static void a_prism_has_its_volume_and_uses_every_corner(void**) {
  for (const int n : {3, 17, 1000}) {
    const Hull h = hull_of(prism(n));
    assert_closed(h);
    assert_int_equal(vertices_of(h), 2 * n);
    assert_int_equal(h.triangles.size() / 3, 2 * (2 * n) - 4);
    const Real exact = n * std::sin(2 * 3.14159265358979323846 / n);  // right relatively, which sin_cos is not
    assert_true(std::fabs(volume_of(prism(n)) - exact) <= 32 * kEpsilon * exact);  // corners and sums to some ten u
  }
}

static void every_point_on_a_sphere_is_a_vertex_and_none_inside_is(void**) {
  Random random(2);
  for (const int n : {10, 100, 3000}) {
    Cloud cloud = on_sphere(random, n);
    const Hull outer = hull_of(cloud);
    assert_closed(outer);
    assert_int_equal(vertices_of(outer), n);
    Real least = 1;  // distance of the nearest face from the centre: points within are inside
    for (std::size_t t = 0; t < outer.triangles.size(); t += 3) {
      const Vec3 &a = cloud[outer.triangles[t]], &b = cloud[outer.triangles[t + 1]], &c = cloud[outer.triangles[t + 2]];
      least = std::min(least, (b - a).cross(c - a).normalized().dot(a));
    }
    if (least <= 0) continue;
    for (int i = 0; i < n; ++i) cloud.push_back(0.999 * least * random.direction());
    const Hull h = hull_of(cloud);
    assert_int_equal(vertices_of(h), n);
    for (const std::uint32_t v : h.triangles) assert_true(v < static_cast<std::uint32_t>(n));
  }
}

static void the_order_of_the_points_does_not_change_the_hull(void**) {
  Random random(3);
  Cloud cloud = on_sphere(random, 500);
  const Real volume = volume_of(cloud);
  for (int trial = 0; trial < 5; ++trial) {
    for (std::size_t i = cloud.size() - 1; i > 0; --i)
      std::swap(cloud[i], cloud[static_cast<std::size_t>(random.uniform(0, static_cast<Real>(i + 1)))]);
    assert_true(std::fabs(volume_of(cloud) - volume) <=
                16 * kEpsilon * volume);  // same triangles, summed in another order
  }
}

static void needles_and_plates_of_aspect_1e8_keep_their_volume(void**) {
  Random random(4);
  const Cloud ball = on_sphere(random, 300);
  const Real volume = volume_of(ball);
  for (const Vec3& stretch : {Vec3(1, 1e-8, 1e-8), Vec3(1e8, 1, 1), Vec3(1e4, 1e-4, 1), Vec3(1e-6, 1e-6, 1e-6)}) {
    const Mat3 a = Mat3::diagonal(stretch);
    const Hull h = hull_of(moved(ball, a, Vec3::zero()));
    assert_closed(h);
    assert_int_equal(vertices_of(h), 300);
    // Scaling the axes rounds each coordinate once.
    assert_true(std::fabs(volume_of(moved(ball, a, Vec3::zero())) - volume * stretch.product()) <=
                32 * kEpsilon * volume * stretch.product());
    // Turned out of the axes, a coordinate of 1 is rounded to u against a width of 1 / aspect.
    const Real aspect = stretch.max_entry() / stretch.min_entry();
    const Cloud turned = moved(ball, some_rotation(random) * a, Vec3::zero());
    assert_closed(hull_of(turned));
    assert_true(std::fabs(volume_of(turned) - volume * stretch.product()) <=
                32 * kEpsilon * aspect * volume * stretch.product());
  }
}

static void a_flat_cloud_has_no_hull(void**) {
  Random random(5);
  assert_false(hull_of({}).solid);
  assert_false(hull_of({Vec3(1, 2, 3)}).solid);
  assert_false(hull_of(Cloud(100, Vec3(1, 2, 3))).solid);
  for (int trial = 0; trial < 50; ++trial) {
    Cloud plane, line;
    const Mat3 r = some_rotation(random);
    for (int i = 0; i < 30; ++i) {
      plane.push_back(r * Vec3{random.uniform(-1, 1), random.uniform(-1, 1), 0} + Vec3(5, 0, 1));
      line.push_back(r * Vec3(random.uniform(-1, 1), 0, 0) + Vec3(5, 0, 1));
    }
    for (const Cloud& cloud : {plane, line}) {
      const Hull h = hull_of(cloud);
      assert_false(h.solid);
      assert_true(h.triangles.empty());
    }
  }
}

static void numbers_that_are_none_do_not_hang_or_crash(void**) {
  Random random(6);
  for (const Real bad : {Real(NAN), kInfinity, -kInfinity, 1e300, 1e-300}) {
    Cloud cloud = on_sphere(random, 50);
    cloud[7].y() = bad;
    cloud[0].x() = bad;
    hull_of(cloud);
    volume_of(cloud);
  }
}

static void thirty_five_thousand_points_are_a_hull_too(void**) {
  Random random(7);
  const Cloud cloud = on_sphere(random, 35000);
  const Hull h = hull_of(cloud);
  assert_closed(h);
  assert_int_equal(vertices_of(h), 35000);
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(hulls_of_difficult_clouds_are_closed_and_leave_no_point_out),
      cmocka_unit_test(a_grid_of_points_has_the_volume_of_its_cube),
      cmocka_unit_test(a_prism_has_its_volume_and_uses_every_corner),
      cmocka_unit_test(every_point_on_a_sphere_is_a_vertex_and_none_inside_is),
      cmocka_unit_test(the_order_of_the_points_does_not_change_the_hull),
      cmocka_unit_test(needles_and_plates_of_aspect_1e8_keep_their_volume),
      cmocka_unit_test(a_flat_cloud_has_no_hull),
      cmocka_unit_test(numbers_that_are_none_do_not_hang_or_crash),
      cmocka_unit_test(thirty_five_thousand_points_are_a_hull_too),
  };
  return cmocka_run_group_tests_name("collision/hull", tests, nullptr, nullptr);
}
