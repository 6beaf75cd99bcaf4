// Principal axes: they rebuild the inertia they came from, stand in the promised order, and cost a diagonal one
// nothing.
#include <array>

#include "carom_test.h"
#include "dynamics/integrate/rotation/principal.h"
#include "world_builder.h"

using namespace carom;
using namespace carom::test;

namespace {

Mat3 rebuilt(const Principal& p) {
  const Mat3 diagonal = Mat3::diagonal(p.moment);
  if (!p.aligned) {
    const Mat3 r = p.frame.matrix();
    return r * diagonal * r.transpose();
  }
  Mat3 m = Mat3::zero();
  for (int k = 0; k < 3; ++k) m(p.axis[k], p.axis[k]) = p.moment[k];
  return m;
}

void stands_in_order(const Principal& p) {
  const Vec3& i = p.moment;
  assert_true((i.x() >= i.y() && i.x() <= i.z()) || (i.x() <= i.y() && i.x() >= i.z()));
  assert_true(std::fabs(p.dy) <= std::fabs(p.dz) && p.dy * p.dz <= 0);
}

}  // namespace

static void a_diagonal_inertia_is_sorted_and_not_rounded(void**) {
  for (const auto& k : {std::array{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}) {
    const Vec3 values(0.7, 1.1, 1.3);
    const Vec3 moment(values[k[0]], values[k[1]], values[k[2]]);
    const Principal p = principal_axes(Mat3::diagonal(moment));
    assert_true(p.aligned && rebuilt(p) == Mat3::diagonal(moment));
    stands_in_order(p);
    // Sorting is a map of rotations: products, and turned vectors, stay what they were; and back is back.
    const Quat a = exp_map(Vec3(0.3, -1, 0.2)), b = exp_map(Vec3(2, 0.1, -0.4));
    const Vec3 v(1, 2, 3);
    assert_true(((p.sorted(a) * p.sorted(b)) - p.sorted(Quat(a * b))).norm() < 8 * kEpsilon);
    assert_true((p.sorted(a) * p.sorted(v) - p.sorted(Vec3(a * v))).norm() < 32 * kEpsilon);
    assert_true(p.unsorted(p.sorted(v)) == v && p.unsorted(p.sorted(a)) == a);
  }
}

static void any_inertia_is_rebuilt_from_its_axes(void**) {
  Random random(11);
  for (int n = 0; n < 2000; ++n) {
    const Mat3 r = exp_map(random.in_cube(2)).matrix();
    const Real ratio = std::pow(10, random.uniform(-6, 0));
    Vec3 moment(1, random.uniform(0.5, 1), ratio);
    if (n % 3 == 0) moment.y() = n % 2 ? 1 : ratio;  // two alike
    Mat3 inertia = r * Mat3::diagonal(moment) * r.transpose();
    inertia = Mat3(0.5 * (inertia + inertia.transpose()));
    const Principal p = principal_axes(inertia);
    stands_in_order(p);
    // Each of some 12 rotations rounds every element by 4 u of the largest; so does the rebuilding.
    assert_true((rebuilt(p) - inertia).abs().max_entry() < 64 * kEpsilon);
    assert_true(std::fabs(p.frame.squared_norm() - 1) < 4 * kEpsilon);
  }
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(a_diagonal_inertia_is_sorted_and_not_rounded),
      cmocka_unit_test(any_inertia_is_rebuilt_from_its_axes),
  };
  return cmocka_run_group_tests_name("dynamics/principal", tests, nullptr, nullptr);
}
