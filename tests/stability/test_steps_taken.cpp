// What joints ask of the direct solver takes the steps that it needs, and no more where it is exact but for rounding.
#include <algorithm>
#include <vector>

#include "carom_test.h"
#include "joint_scenes.h"

using namespace carom;
using namespace carom::test;
using dynamics::Coordinate;
using dynamics::JointKind;

namespace {

/// A rope that a motor winds round its upper end.
struct Rope {
  int rods;
  Real length, load, speed, hz;  // m, of a rod's mass, rad/s, 1/s
};

/// @return steps of Newton's method in the worst step, of a substep
double worst_of(const Rope& of) {
  constexpr int kSubsteps = 4;
  TestWorld t;
  choose(t, kDirectChoice, kSubsteps);
  leave_joints_to_solver(t);
  chain(t, of.rods, of.length, 1, of.load);
  const std::uint32_t drum = add_body(t, Vec3::zero(), 5, Vec3::constant(1));
  const std::uint32_t axle = join(t, JointKind::hinge, kInvalid, drum, Vec3::zero());
  set_motor(t, axle, Coordinate::twist, of.speed, 50);
  join(t, JointKind::hinge, drum, 0, Vec3(of.length / 2, 0, 0));
  std::uint64_t worst = 0;
  for (int i = 0; i < 2 * of.hz; ++i) {
    t.world.step(1 / of.hz);
    worst = std::max<std::uint64_t>(worst, t.world.report.velocity_impulses);
  }
  return static_cast<double>(worst) / kSubsteps;
}

}  // namespace

/// But for a motor a rope is linear: two steps of Newton's method solve it, and some more where the motor is at its bound.
/// It went on at rounding, 60 to 210 steps a substep. Ten steps, and four solutions where a rope is jerked (kJerks).
static void ropes_take_few_steps(void**) {
  for (const Rope& rope : {Rope{5, 0.4, 60, 0.3, 30}, Rope{9, 0.3, 150, -0.5, 60}, Rope{12, 0.25, 20, 0.2, 50},
                           Rope{3, 1, 1000, 1, 120}, Rope{20, 0.1, 5, 2, 60}}) {
    const double worst = worst_of(rope);
    print_message("%d rods, load %g, %g Hz: %g steps of Newton's method in a substep at worst\n", rope.rods,
                  double(rope.load), double(rope.hz), worst);
    assert_true(worst <= 40);
  }
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(ropes_take_few_steps),
  };
  return cmocka_run_group_tests_name("stability/steps_taken", tests, nullptr, nullptr);
}
