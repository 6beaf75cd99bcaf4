// Hulls whose faces are flat but for the noise of their points come to rest within a second and stay: no facet of a lid
// lets its body rock to the next one, and no leaning normal pushes it aside.
//
// Noise of 1e-7 of the size is that of files in single precision, 1e-4 that of coarse scans. The bound of 0.1 mm is a
// tenth of `position_tolerance`; a body of 1 m that walked was off by millimetres within seconds. Lids that lie on
// three points may tip once from one three to another, within the first second.
#include <vector>

#include "carom_test.h"
#include "sliced.h"
#include "world_builder.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr Real kStep = 1.0 / 60, kStays = 1e-4;
const int kSteps = sliced(600, 600, 120);

/// Points moved by up to `noise` along each axis and rounded to single precision.
Shape noisy_hull(std::vector<Vec3> points, Real noise, std::uint64_t seed) {
  Random random(seed);
  for (Vec3& p : points)
    for (int k = 0; k < 3; ++k) p[k] = static_cast<float>(p[k] + random.uniform(-noise, noise));
  Shape s = hull(points);
  make_faces(s);
  return s;
}

/// Rings of n points around y.   @param rings  radius and height, m
std::vector<Vec3> rings_of(int n, std::initializer_list<std::pair<Real, Real>> rings) {
  std::vector<Vec3> points;
  for (const auto& [radius, y] : rings)
    for (int k = 0; k < n; ++k) {
      const Real angle = 2 * 3.14159265358979323846 * k / n;
      points.push_back(Vec3(radius * std::cos(angle), y, radius * std::sin(angle)));
    }
  return points;
}

std::vector<Vec3> barrel(int n) {
  return rings_of(n, {{0.35, -0.5}, {0.38, -0.45}, {0.44, -0.2}, {0.45, 0}, {0.44, 0.2}, {0.38, 0.45}, {0.35, 0.5}});
}
/// Lids with points within them.
std::vector<Vec3> drum(int n) {
  return rings_of(n, {{0.15, -0.4}, {0.3, -0.4}, {0.4, -0.4}, {0.15, 0.4}, {0.3, 0.4}, {0.4, 0.4}});
}
/// A cube with n by n points on each side.
std::vector<Vec3> crate(int n) {
  std::vector<Vec3> points;
  const auto at = [&](int i) { return Real(i) / (n - 1) - 0.5; };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n; ++k)
        if (i % (n - 1) == 0 || j % (n - 1) == 0 || k % (n - 1) == 0) points.push_back(Vec3(at(i), at(j), at(k)));
  return points;
}

enum class Ground { plane, slab, lid };

void lay(TestWorld& t, Ground ground) {
  if (ground == Ground::plane) {
    t.ground();
    return;
  }
  Shape s = ground == Ground::slab ? box(Vec3(1, 0.5, 1)) : noisy_hull(drum(24), 1e-6, 5);
  make_faces(s);
  const Real top = s.bounds.hi.y();
  t.add(t.keep(std::move(s)), Vec3(0, -top, 0), BodyType::fixed);
}

/// Bodies of one shape on each other, a little turned, stay after a second where they are, stacks after four.
void assert_stays(Shape made, Ground ground, int high) {
  TestWorld t;
  lay(t, ground);
  const Shape* s = t.keep(std::move(made));
  std::vector<std::uint32_t> bodies;
  for (int i = 0; i < high; ++i)
    bodies.push_back(t.add(s, Vec3(0.013, i * (s->bounds.hi.y() - s->bounds.lo.y()) - s->bounds.lo.y(), 0.007),
                           BodyType::dynamic, exp_map(0.6 * i * Vec3::unit_y())));
  t.run(high == 1 ? 60 : 240, kStep);
  const auto x = t.world.state.x;
  const auto q = t.world.state.q;
  for (int i = 0; i < kSteps; ++i) {
    t.world.step(kStep);
    for (const std::uint32_t b : bodies) {
      assert_true((t.world.state.x[b] - x[b]).norm() < kStays);
      assert_true(2 * (t.world.state.q[b] * q[b].conjugate()).vec().norm() * s->bounding_radius < kStays);
    }
  }
}

}  // namespace

static void barrels_stand(void**) {
  for (const int n : {6, 12, 24, 64})
    for (const Real noise : {0.0, 1e-7, 1e-6, 1e-5})
      for (const Ground ground : {Ground::plane, Ground::slab, Ground::lid})
        assert_stays(noisy_hull(barrel(n), noise, static_cast<std::uint64_t>(n)), ground, 1);
}

static void crates_and_drums_stand(void**) {
  for (const Real noise : {1e-7, 1e-6, 1e-5, 1e-4})
    for (const Ground ground : {Ground::slab, Ground::lid}) {
      assert_stays(noisy_hull(crate(2), noise, 1), ground, 1);
      assert_stays(noisy_hull(crate(5), noise, 2), ground, 1);
      assert_stays(noisy_hull(drum(12), noise, 3), ground, 1);
    }
}

/// Stacks take up to three seconds: a crate that is balanced over the middle of its bottom tips by a tenth of a
/// milliradian, as slowly as the solver's tolerance of velocities lets it. At noise of 1e-5 one of fifty moves longer.
static void they_stand_on_each_other(void**) {
  for (const Real noise : {1e-7, 1e-6}) {
    assert_stays(noisy_hull(crate(3), noise, 7), Ground::plane, 3);
    assert_stays(noisy_hull(barrel(16), noise, 8), Ground::slab, 3);
    assert_stays(noisy_hull(drum(9), noise, 9), Ground::lid, 3);
  }
}

static void they_fall_asleep(void**) {
  for (const Real noise : {1e-7, 1e-5, 1e-4}) {
    TestWorld t;
    t.world.set_dial(Dial::sleep, 1);
    lay(t, Ground::slab);
    const Shape* s = t.keep(noisy_hull(barrel(20), noise, 4));
    const std::uint32_t b = t.add(s, Vec3(0, -s->bounds.lo.y(), 0));
    t.run(180, kStep);
    assert_true(t.world.state.sleeps(b));
  }
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(barrels_stand),
      cmocka_unit_test(crates_and_drums_stand),
      cmocka_unit_test(they_stand_on_each_other),
      cmocka_unit_test(they_fall_asleep),
  };
  return cmocka_run_group_tests_name("stability/hull_lids", tests, nullptr, nullptr);
}
