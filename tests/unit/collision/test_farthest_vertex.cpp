// The farthest vertex of any cloud, along any direction, attains the maximum to a few u: climbed or scanned.
#include "carom_test.h"
#include "collision/farthest_vertex.h"
#include "collision/hull.h"
#include "collision/scan_kernels.h"
#include "core/pose.h"
#include "random_pairs.h"

using namespace carom;
using namespace carom::test;

namespace {

using Cloud = std::vector<Vec3>;

std::vector<double> flat_list(const Cloud& cloud) {
  std::vector<double> xyz;
  for (const Vec3& p : cloud) xyz.insert(xyz.end(), {p.x(), p.y(), p.z()});
  return xyz;
}

/// Directions that are hard for this cloud: normals of facets, across edges, both, and a hair's breadth beside each.
std::vector<Vec3> directions(Random& random, const Cloud& cloud, int count) {
  std::vector<Vec3> d;
  for (int i = 0; i < 3; ++i) d.insert(d.end(), {Vec3::unit(i), -Vec3::unit(i)});
  for (int i = 0; i < count; ++i) d.push_back(random.direction());
  Array<std::uint32_t> triangles;
  const std::vector<double> xyz = flat_list(cloud);
  convex_hull(xyz, triangles);
  const std::size_t facets = triangles.size() / 3;
  for (int i = 0; facets > 0 && i < count; ++i) {
    const std::uint32_t* t = &triangles[3 * static_cast<std::size_t>(random.uniform(0, static_cast<Real>(facets)))];
    const Vec3 edge = cloud[t[1]] - cloud[t[0]], other = cloud[t[2]] - cloud[t[0]];
    for (const Vec3& v : {Vec3(edge.cross(other)), Vec3(edge.cross(random.direction())), edge}) {
      if (!(v.norm() > 0)) continue;
      const Vec3 n = v.normalized();
      for (const Real off : {0.0, 1e-16, 1e-12, 1e-6}) {
        const Vec3 beside = (n + off * random.direction()).normalized();
        d.insert(d.end(), {beside, -beside});
      }
    }
  }
  return d;
}

/// Largest shortfall over directions, in units of what the header claims.
Real worst_share(const FarthestVertex& farthest, const Cloud& cloud, const std::vector<Vec3>& dirs) {
  Vec3 lo = cloud[0], hi = lo;
  Real reach = 0;
  for (const Vec3& p : cloud) lo = lo.min(p), hi = hi.max(p), reach = std::max(reach, p.norm());
  const Real claim = kUnitRoundoff * (farthest.climbs() ? 11 * 0.5 * (hi - lo).max_entry() : 6 * reach);
  // The oracle's own rounding: 2^-64 for each of five operations and for each of the two values.
  const Real oracle = 10 * 0x1p-64 * reach;
  Real worst = 0;
  for (const Vec3& n : dirs) {
    const auto along = [&](const Vec3& p) {
      return static_cast<long double>(n.x()) * p.x() + static_cast<long double>(n.y()) * p.y() +
             static_cast<long double>(n.z()) * p.z();
    };
    const std::uint32_t found = farthest(n);
    assert_true(found < cloud.size());
    long double most = along(cloud[0]);
    for (const Vec3& p : cloud) most = std::max(most, along(p));
    const Real shortfall = static_cast<Real>(most - along(cloud[found]));
    if (shortfall > oracle) worst = std::max(worst, (shortfall - oracle) / claim);
  }
  return worst;
}

void check(Random& random, const Cloud& cloud, int dirs = 60) {
  FarthestVertex farthest(std::pmr::get_default_resource());
  assert_true(farthest.empty());
  farthest.build(flat_list(cloud));
  assert_false(farthest.empty());
  const Real worst = worst_share(farthest, cloud, directions(random, cloud, dirs));
  if (worst > 1) print_error("%zu points, climbs %d: %g of the bound\n", cloud.size(), farthest.climbs(), worst);
  assert_true(worst <= 1);
}

Cloud on_ellipsoid(Random& random, int count, const Vec3& radii) {
  Cloud c;
  for (int i = 0; i < count; ++i) c.push_back(random.direction().times(radii));
  return c;
}

Cloud in_ball(Random& random, int count) {
  Cloud c;
  for (int i = 0; i < count; ++i) c.push_back(random.uniform(0, 1) * random.direction());
  return c;
}

/// A box with every face cut into squares: corners that no direction needs, on edges and within faces.
Cloud grid(int n) {
  Cloud c;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j)
      for (int k = 0; k <= n; ++k)
        if (i % n == 0 || j % n == 0 || k % n == 0) c.push_back(Vec3(i, j, k) / n - Vec3::constant(0.3));
  return c;
}

Cloud prism(int sides, Real height) {
  Cloud c;
  for (int i = 0; i < sides; ++i)
    for (const Real y : {-height, height})
      c.push_back(Vec3(std::cos(2 * M_PI * i / sides), y, std::sin(2 * M_PI * i / sides)));
  return c;
}

/// Points crowded around the corners of a cube.
Cloud crowds(Random& random, int each, Real spread) {
  Cloud c;
  for (int corner = 0; corner < 8; ++corner)
    for (int i = 0; i < each; ++i)
      c.push_back(Vec3(corner & 1, corner >> 1 & 1, corner >> 2 & 1) + spread * random.direction());
  return c;
}

Cloud moved(const Cloud& cloud, const Mat3& a, const Vec3& b) {
  Cloud c;
  for (const Vec3& p : cloud) c.push_back(a * p + b);
  return c;
}

}  // namespace

static void round_clouds_are_climbed_to_the_best(void**) {
  Random random(1);
  for (const int count : {4, 5, 20, 95, 96, 97, 300, 2000}) {
    check(random, on_ellipsoid(random, count, Vec3(1, 0.7, 0.4)));
    check(random, in_ball(random, count));
  }
  check(random, on_ellipsoid(random, 20000, Vec3(1, 1, 1)), 10);
}

static void flat_faces_of_many_corners_do_not_stop_the_climb(void**) {
  Random random(2);
  for (const int n : {2, 4, 9}) {
    check(random, grid(n));
    for (int i = 0; i < 8; ++i)  // turned, the faces are flat but for rounding
      check(random, moved(grid(n), random_rotation(random).matrix(), random.in_cube(2)), 30);
  }
  for (const int sides : {3, 60, 200, 1000}) {
    check(random, prism(sides, 1));
    check(random, moved(prism(sides, 0.01), random_rotation(random).matrix(), Vec3::zero()));
  }
}

static void crowds_of_nearly_equal_points_do_not_either(void**) {
  Random random(3);
  for (const Real spread : {1e-16, 1e-15, 3e-15, 1e-14, 1e-12, 1e-9, 1e-3})
    check(random, crowds(random, 40, spread), 30);
  Cloud twice = on_ellipsoid(random, 200, Vec3(1, 1, 1));
  twice.insert(twice.end(), twice.begin(), twice.end());
  check(random, twice);
}

static void thin_and_long_clouds_are_right_at_every_size(void**) {
  Random random(4);
  for (const Real size : {1e-6, 1e-3, 1.0, 1e3, 1e6}) {
    for (const Real thin : {1e-1, 1e-4, 1e-8, 1e-12, 1e-14, 1e-15, 1e-16}) {
      const Mat3 r = size * random_rotation(random).matrix();
      check(random, moved(on_ellipsoid(random, 300, Vec3(1, thin, 1)), r, Vec3::zero()), 20);
      check(random, moved(on_ellipsoid(random, 300, Vec3(thin, 1, thin)), r, 100 * size * random.direction()), 20);
      check(random, moved(prism(150, thin), r, Vec3::zero()), 20);
    }
  }
}

static void clouds_without_a_hull_are_scanned(void**) {
  Random random(5);
  Cloud sheet, line;
  for (int i = 0; i < 300; ++i) {
    sheet.push_back(Vec3{random.uniform(-1, 1), 0, random.uniform(-1, 1)});
    line.push_back(Vec3(0, random.uniform(-1, 1), 0));
  }
  check(random, sheet);
  check(random, line);
  for (const Cloud& few : {Cloud{Vec3(1, 2, 3)}, Cloud(7, Vec3(1, 2, 3)), Cloud{Vec3(1, 0, 0), Vec3(-1, 0, 0)},
                           Cloud{Vec3(1, 0, 0), Vec3(0, 0, 0), Vec3(0, 1, 0)}, Cloud{Vec3::zero()}})
    check(random, few);
}

static void a_direction_that_is_no_number_gives_some_vertex(void**) {
  Random random(6);
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  for (const int count : {5, 500}) {
    FarthestVertex farthest(std::pmr::get_default_resource());
    farthest.build(flat_list(on_ellipsoid(random, count, Vec3(1, 1, 1))));
    for (const Vec3& n :
         {Vec3(nan, 0, 0), Vec3(0, kInfinity, 1), Vec3(0, 0, 0), Vec3(1e300, 1, 1), Vec3(0, -1e-300, 0)})
      assert_true(farthest(n) < static_cast<std::uint32_t>(count));
  }
}

static void the_same_cloud_gives_the_same_vertices(void**) {
  Random random(7);
  const std::vector<double> xyz = flat_list(grid(9));
  FarthestVertex one(std::pmr::get_default_resource()), two(std::pmr::get_default_resource());
  one.build(xyz);
  two.build(xyz);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 n = i < 6 ? Vec3((i % 2 ? 1 : -1) * Vec3::unit(i / 2)) : random.direction();
    assert_int_equal(one(n), two(n));
    assert_int_equal(one(n), one(n));
  }
}

/// Of equals too, as those of a grid are.
static void scans_of_every_width_find_the_same_vertex(void**) {
  Random random(8);
  for (const std::size_t count : {4, 8, 44, 92}) {
    std::vector<double> scattered(3 * count), level(3 * count);
    for (double& x : scattered) x = random.uniform(-1, 1);
    for (double& x : level) x = std::round(random.uniform(-1, 1));
    for (const std::vector<double>& coordinates : {scattered, level}) {
      for (int i = 0; i < 300; ++i) {
        const Vec3 n = i < 6 ? Vec3((i % 2 ? 1 : -1) * Vec3::unit(i / 2)) : random.direction();
        const std::size_t first = all_scan_kernels()[0]->farthest(coordinates.data(), count, n.data());
        assert_true(first < count);
        for (const ScanKernel* kernel : all_scan_kernels())
          assert_int_equal(kernel->farthest(coordinates.data(), count, n.data()), first);
      }
    }
  }
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(round_clouds_are_climbed_to_the_best),
      cmocka_unit_test(flat_faces_of_many_corners_do_not_stop_the_climb),
      cmocka_unit_test(crowds_of_nearly_equal_points_do_not_either),
      cmocka_unit_test(thin_and_long_clouds_are_right_at_every_size),
      cmocka_unit_test(clouds_without_a_hull_are_scanned),
      cmocka_unit_test(a_direction_that_is_no_number_gives_some_vertex),
      cmocka_unit_test(the_same_cloud_gives_the_same_vertices),
      cmocka_unit_test(scans_of_every_width_find_the_same_vertex),
  };
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
