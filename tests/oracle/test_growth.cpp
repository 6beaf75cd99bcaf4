// How fast errors grow: rates that closed forms tell, motions that are regular, and motions that are chaos.
#include <cmath>
#include <functional>

#include "carom_test.h"
#include "dynamics/accuracy/growth.h"
#include "rattle_scenes.h"

using namespace carom;
using namespace carom::test;
using accuracy::Growth;

namespace {

using Fill = std::function<void(TestWorld&)>;

Growth growth_of(const Fill& fill, Real seconds, Real dt = 1.0 / 120) {
  TestWorld one, other;
  for (TestWorld* t : {&one, &other}) by_rattle(*t, 4), fill(*t);
  const Growth g =
      accuracy::measure_growth(one.world, other.world, dt, static_cast<std::uint32_t>(std::lround(seconds / dt)));
  std::printf("  %u steps: %.3g, rate %.3g 1/s, %s\n", g.steps, g.factor, g.rate, g.is_sensitive ? "sensitive" : "not");
  return g;
}

/// A rod of 1 m on a hinge, let go at an angle from straight down.
Fill rod(Real angle, Real damping = 0) {
  return [=](TestWorld& t) {
    const std::uint32_t body = hang_rod(t, angle);
    if (damping > 0) t.world.set_damping(body, 0, damping);
  };
}
Fill two_rods(Real a, Real b) {
  return [=](TestWorld& t) { hang_two(t, a, b, JointKind::hinge); };
}
/// Balls that drop onto a carpet of still ones, too large for its holes: where they go after some impacts depends on
/// everything.
Fill balls(int count, Real restitution) {
  return [=](TestWorld& t) {
    const std::uint32_t bouncy = t.material(0.3, restitution);
    const Shape* const large = t.keep(sphere(0.5));
    for (int i = 0; i < 144; ++i) t.add(large, Vec3(i % 12, 0, i / 12), BodyType::fixed, Quat::identity(), bouncy);
    for (int i = 0; i < count; ++i)
      t.add(t.keep(sphere(0.25)), Vec3(5.7 + 0.11 * i, 3 + 0.6 * i, 5.61 - 0.13 * i), BodyType::dynamic,
            Quat::identity(), bouncy);
  };
}

}  // namespace

/// A rod that stands on its end falls by e^(w t), w^2 = 3 g / 2 l. The distance of velocities begins with what the
/// joint leaves of a push, and soon grows w times that of angles.
static void what_stands_on_its_end_grows_by_its_rate(void**) {
  const Real w = std::sqrt(1.5 * kG);
  const Growth g = growth_of(rod(kPi), 5);
  assert_true(g.is_sensitive && g.factor >= 1e6 && g.steps < 600);
  assert_true(std::fabs(g.rate - w) < 0.15 * w);  // of its ln, 14, what the joint leaves of a push is 1 or 2
}

static void regular_motions_are_not_sensitive(void**) {
  assert_false(growth_of(rod(1), 20).is_sensitive);
  assert_false(growth_of(rod(2.9), 20).is_sensitive);
  assert_false(growth_of(two_rods(0.1, 0.15), 20).is_sensitive);
  assert_false(growth_of([](TestWorld& t) { add_body(t, Vec3::zero(), 1, Vec3(1, 2, 3)); }, 20).is_sensitive);
  const Growth damped = growth_of(rod(1, 2), 20);
  assert_true(!damped.is_sensitive && damped.rate < 0);
}

static void chaos_is_sensitive(void**) {
  const Growth coarse = growth_of(two_rods(2, 2.5), 20), fine = growth_of(two_rods(2, 2.5), 20, 1.0 / 480);
  assert_true(coarse.is_sensitive && fine.is_sensitive);
  assert_true(std::fabs(coarse.rate - fine.rate) < 0.3 * fine.rate);  // the motion's, not the step's
}

/// Not looked at before the rest passed: other angles, an arm that hangs on a spring, balls among balls, a spinning top
/// near its middle axis and about its first, a motion at rest.
static void held_out_motions(void**) {
  assert_true(growth_of(two_rods(3, 0.5), 20).is_sensitive);
  assert_true(growth_of(balls(1, 0.8), 4).is_sensitive);
  assert_true(growth_of(balls(4, 0.9), 4).is_sensitive);
  const auto top = [](const Vec3& omega) {
    return
        [=](TestWorld& t) { t.world.set_velocity(add_body(t, Vec3::zero(), 1, Vec3(1, 2, 3)), Vec3::zero(), omega); };
  };
  assert_false(growth_of(top(Vec3(3, 0.1, 0.1)), 20).is_sensitive);
  assert_true(growth_of(top(Vec3(0, 3, 1e-6)), 8).is_sensitive);  // until it turns over
  const auto at_rest = [](TestWorld& t) {
    t.ground();
    t.add(t.keep(box(Vec3(0.5, 0.5, 0.5))), Vec3(0, 0.5, 0));
  };
  assert_false(growth_of(at_rest, 4).is_sensitive);
  assert_true(growth_of([](TestWorld&) {}, 1).body == kInvalid);
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(what_stands_on_its_end_grows_by_its_rate),
      cmocka_unit_test(regular_motions_are_not_sensitive),
      cmocka_unit_test(chaos_is_sensitive),
      cmocka_unit_test(held_out_motions),
  };
  return cmocka_run_group_tests_name("oracle/growth", tests, nullptr, nullptr);
}
