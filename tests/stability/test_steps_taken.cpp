// What joints ask of the direct solver takes the steps that it needs, and no more where it is exact but for rounding.
#include <algorithm>
#include <vector>

#include "carom_test.h"
#include "random_pairs.h"
#include "six_axes.h"

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

namespace {

/// A trunk on legs of hinges that servos hold, each with dry friction and a rotor. Hips turn about three axes, with next to nothing
/// between them, so that inertias of bodies say nothing of what a hinge turns.
struct Legged {
  int legs;
  Real height, mass, friction, armature, hz;  // m, kg of the trunk, N m, kg m^2, 1/s
  std::uint64_t seed;
};

/// @return steps of Newton's method in a substep, in the mean of half a second from where it is set down
double mean_of(const Legged& of) {
  Random random(of.seed);
  TestWorld t;
  choose(t, kAutoChoice, 1);
  t.ground();
  const Real leg = of.height / 2, nothing = 1e-7 * of.mass;
  const Shape* const sole = t.keep(box(Vec3(0.15, 0.02, 0.08) * of.height));
  const std::uint32_t trunk =
      add_body(t, Vec3(0, of.height + 0.04 * of.height, 0), of.mass, Vec3::constant(0.02 * of.mass * of.height));
  JointAxis servo;
  servo.friction = of.friction, servo.armature = of.armature;
  servo.drive = AxisDrive::position, servo.gains = {Gains::force, 20 * of.mass * of.height, 0.5 * of.mass * of.height};
  servo.mode = AxisMode::limited, servo.lower = -1.5, servo.upper = 1.5;
  const auto hinge = [&](std::uint32_t a, std::uint32_t b, const Vec3& at, const Vec3& axis) {
    const std::uint32_t j = join_axes(t, a, b, at, x_along(axis));
    set_all(t, j, 3, locked_at());
    servo.target = 0.02 * random.uniform(-1, 1);
    t.world.set_joint_axis(j, 3, servo);
  };
  const Real least = 1e-4;
  for (int i = 0; i < of.legs; ++i) {
    const Real turn = 6.283185307179586 * i / of.legs;
    const Vec3 out(of.height * std::cos(turn) / 2, 0, of.height * std::sin(turn) / 2);
    const Vec3 hip = out + Vec3(0, of.height + 0.04 * of.height, 0), knee = hip - Vec3(0, leg, 0),
               ankle = knee - Vec3(0, leg, 0);
    const Real own = 0.05 * of.mass, across = own * leg * leg / 12;
    const std::uint32_t one = add_body(t, hip, nothing, Vec3::constant(nothing * least));
    const std::uint32_t two = add_body(t, hip, nothing, Vec3::constant(nothing * least));
    const std::uint32_t thigh = add_body(t, (hip + knee) / 2, own, Vec3(across, across / 20, across));
    const std::uint32_t shin = add_body(t, (knee + ankle) / 2, own, Vec3(across, across / 20, across));
    const std::uint32_t foot = t.add(sole, ankle - Vec3(0, 0.02 * of.height, 0));
    MassGiven given;
    given.mass = own / 4;
    t.world.set_mass(foot, given);
    hinge(trunk, one, hip, Vec3::unit(1)), hinge(one, two, hip, Vec3::unit(0)), hinge(two, thigh, hip, Vec3::unit(2));
    hinge(thigh, shin, knee, Vec3::unit(2));
    hinge(shin, foot, ankle, Vec3::unit(i % 2 ? 0 : 2));
  }
  std::uint64_t steps = 0;
  const int count = static_cast<int>(of.hz / 2);
  for (int i = 0; i < count; ++i) {
    t.world.step(1 / of.hz);
    steps += newton_steps(t);
  }
  assert_true(t.world.state.x[trunk].y() > 0.9 * of.height);
  return static_cast<double>(steps) / count;
}

}  // namespace

/// Each hinge sticks or slides, so which do is to be found. With hinges that resist by a share of what turns they are found in a
/// few steps, and that is undone in rounds; by a share of what the bodies at the hinge weigh alone it took 40.
static void robots_whose_hinges_rub_take_few_steps(void**) {
  for (const Legged& robot : {Legged{2, 0.8, 30, 0.3, 0.01, 500, 1}, Legged{4, 0.4, 12, 0.1, 0.005, 400, 2},
                              Legged{4, 2, 400, 20, 2, 250, 3}, Legged{6, 0.3, 4, 0.05, 0, 500, 4},
                              Legged{8, 1, 100, 1e-3, 0.1, 1000, 5}, Legged{3, 0.1, 0.5, 1e-3, 1e-6, 1000, 6}}) {
    const double mean = mean_of(robot);
    print_message("%d legs, %g m, %g kg, friction %g N m, %g Hz: %g steps of Newton's method in a substep\n",
                  robot.legs, double(robot.height), double(robot.mass), double(robot.friction), double(robot.hz), mean);
    assert_true(mean <= 25);
  }
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(robots_whose_hinges_rub_take_few_steps),
      cmocka_unit_test(ropes_take_few_steps),
  };
  return cmocka_run_group_tests_name("stability/steps_taken", tests, nullptr, nullptr);
}
