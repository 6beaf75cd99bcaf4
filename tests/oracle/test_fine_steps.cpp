// A step's error falls with the step, down to 1/61440 s: what rolls and slides off something round leaves it as the
// equation of motion says, and what slides over an edge does as it does at far finer tolerances.
#include <cmath>
#include <functional>

#include "carom_test.h"
#include "dynamics/accuracy/accuracy.h"
#include "six_axes.h"
#include "sliced.h"
#include "world_builder.h"

using namespace carom;
using namespace carom::test;

namespace {

/// Something round that begins at rest near the top of something round, of which axes are level.
struct RollsOff {
  const Shape *ground, *body;
  Real ground_radius, radius, shape;  // m, m; moment of inertia about the axis, of m r^2
  Real start, friction;               // rad, from the top
  bool lies;                          // its axis and that of the ground are level

  Real way() const { return ground_radius + radius; }

  /// m/s, to the side, once it has left.
  Real run(
      TestWorld& t, std::uint32_t solver, Real dt, const std::function<void()>& each = [] {}) const {
    t.world.set_dial(Dial::solver, solver);
    const std::uint32_t m = t.material(friction, 0);
    const Quat turn = lies ? Quat(std::sqrt(0.5), std::sqrt(0.5), 0, 0) : Quat::identity();
    t.add(ground, Vec3::zero(), BodyType::fixed, turn, m);
    const SinCos at = sin_cos(start);
    const std::uint32_t b = t.add(body, Vec3(way() * at.sin, way() * at.cos, 0), BodyType::dynamic, turn, m);
    for (int i = 0; i * dt < 5 && t.world.state.x[b].y() > 0; ++i) t.world.step(dt), each();
    return t.world.state.v[b].x();
  }

  /// It rolls, from some angle on it slips, and leaves where nothing presses it on; its speed to the side stays then.
  Real truth() const {
    Real angle = start, rate = 0;
    const Real h = 1e-5;
    const auto pulls = [&](Real a, Real r) {  // 1/s^2
      const SinCos at = sin_cos(a);
      const Real presses = kG * at.cos - way() * r * r;
      const Real rolls = kG * at.sin / (1 + shape);
      const bool slips = shape / (1 + shape) * kG * at.sin > friction * presses;
      return (slips ? kG * at.sin - friction * presses : rolls) / way();
    };
    while (kG * sin_cos(angle).cos > way() * rate * rate) {
      const Real a1 = pulls(angle, rate), a2 = pulls(angle + h / 2 * rate, rate + h / 2 * a1);
      angle += h * (rate + h / 2 * a1), rate += h * a2;
    }
    return rate * way() * sin_cos(angle).cos;
  }
};

/// m/s: steps of first order err by as much, and what is left at the finest.
Real most(Real dt) { return 5 * dt + 7e-4; }

void errs_by(Real error, Real bound, Real dt, std::uint32_t solver) {
  if (!(error <= bound))
    print_message("%s, dt 1/%.0f s: %.2e of %.2e\n", solver == kAutoChoice ? "auto" : "direct", 1 / dt, error, bound);
  assert_true(error <= bound);
}

/// Steps of 1/240, 1/3840 and 1/61440 s, by night those between, too.
template <class F>
void over_steps(const F& f) {
  for (const std::uint32_t solver : {kDirectChoice, kAutoChoice})
    for (int level = 2; level <= 10; level += sliced(1, 4, 8)) f(solver, 1.0 / (60 << level));
}

void falls(const RollsOff& scene) {
  const Real truth = scene.truth();
  over_steps([&](std::uint32_t solver, Real dt) {
    TestWorld t;
    errs_by(std::fabs(scene.run(t, solver, dt) - truth), most(dt), dt, solver);
  });
}

/// An accuracy is got, to ten times what was asked, or an island says that it is not. An error of what leaves is one of its
/// speed: one that is borne for as long as the motion takes.
void is_got_or_told(const RollsOff& scene) {
  const Real truth = scene.truth();
  for (const Real asked : {1e-2, 1e-3, 1e-4}) {
    TestWorld t;
    ask_accuracy(t, asked);
    bool is_told = false;
    Real seconds = 0;
    const Real speed = scene.run(t, kAutoChoice, 1.0 / 60, [&] {
      seconds += 1.0 / 60;
      for (const AccuracyView& island : t.world.accuracy->views)
        is_told |= (island.flags & (AccuracyView::kHitBound | AccuracyView::kStalled)) != 0 || island.share() > 10;
    });
    const Real got = std::fabs(speed - truth) / (asked * seconds);
    print_message("  asked %.0e, got %.2g of it%s\n", asked, got, is_told ? ", told" : "");
    assert_true(got < 10 || is_told);
  }
}

/// Of a capsule: of its cylinder and its two half balls.
Real capsule_shape(Real radius, Real half) {
  const Real rod = 2 * half, balls = 4.0 / 3 * radius;  // over pi r^2
  return (rod / 2 + balls * 2 / 5) / (rod + balls);
}

void a_ball_off_a_ball(void**) {
  TestWorld keep;
  falls({keep.keep(sphere(1.1)), keep.keep(sphere(0.12)), 1.1, 0.12, 0.4, 0.33, 0.8, false});
}

void a_large_ball_off_a_small_one(void**) {
  TestWorld keep;
  falls({keep.keep(sphere(0.3)), keep.keep(sphere(0.4)), 0.3, 0.4, 0.4, 0.25, 0.6, false});
}

void a_ball_without_friction(void**) {
  TestWorld keep;
  falls({keep.keep(sphere(0.7)), keep.keep(sphere(0.08)), 0.7, 0.08, 0.4, 0.37, 0, false});
}

void a_capsule_off_a_cylinder(void**) {
  TestWorld keep;
  falls({keep.keep(cylinder(0.9, 2)), keep.keep(capsule(0.15, 0.3)), 0.9, 0.15, capsule_shape(0.15, 0.3), 0.28, 0.7,
         true});
}

void a_cylinder_off_a_cylinder(void**) {
  TestWorld keep;
  falls({keep.keep(cylinder(0.5, 2)), keep.keep(cylinder(0.2, 0.4)), 0.5, 0.2, 0.5, 0.3, 0.75, true});
}

void what_is_asked_of_round_pairs_is_got_or_told(void**) {
  TestWorld keep;
  is_got_or_told({keep.keep(sphere(0.9)), keep.keep(sphere(0.15)), 0.9, 0.15, 0.4, 0.3, 0, false});
  is_got_or_told({keep.keep(sphere(1.6)), keep.keep(sphere(0.07)), 1.6, 0.07, 0.4, 0.22, 0, false});
  is_got_or_told({keep.keep(cylinder(0.6, 2)), keep.keep(capsule(0.12, 0.25)), 0.6, 0.12, 0, 0.3, 0, true});
}

/// m: height of a box that slid over the edge of a table, and tips as it falls.
Real over_the_edge(std::uint32_t solver, Real dt, Real tolerance) {
  TestWorld t;
  t.world.set_dial(Dial::solver, solver);
  t.world.set_dial(Dial::velocity_tolerance, tolerance);
  const std::uint32_t m = t.material(0.3, 0);
  t.add(t.keep(box(Vec3(1, 0.1, 1))), Vec3(-1, -0.1, 0), BodyType::fixed, Quat::identity(), m);
  const std::uint32_t b =
      t.add(t.keep(box(Vec3(0.25, 0.12, 0.2))), Vec3(-0.3, 0.12, 0), BodyType::dynamic, Quat::identity(), m);
  t.world.set_velocity(b, Vec3(1.7, 0, 0), Vec3::zero());
  const int n = static_cast<int>(0.8 / dt + 0.5);
  for (int i = 0; i < n; ++i) t.world.step(dt);
  return t.world.state.x[b].y();
}

void a_box_over_an_edge(void**) {
  const Real truth = over_the_edge(kDirectChoice, 1.0 / 61440, 1e-9);
  over_steps([&](std::uint32_t solver, Real dt) {
    errs_by(std::fabs(over_the_edge(solver, dt, 1e-4) - truth), most(dt), dt, solver);
  });
}

/// How far a block slides down a slope has a closed form of second order: what a solver leaves over, too, falls with the step.
void a_block_down_a_slope(void**) {
  const Real lean = 0.55, friction = 0.25, seconds = 0.8;
  const SinCos at = sin_cos(lean);
  const Vec3 up(-at.sin, at.cos, 0), down(-at.cos, -at.sin, 0);
  const SinCos half = sin_cos(lean / 2);
  over_steps([&](std::uint32_t solver, Real dt) {
    TestWorld t;
    t.world.set_dial(Dial::solver, solver);
    const std::uint32_t m = t.material(friction, 0);
    const Quat turn(half.cos, 0, 0, half.sin);
    t.add(t.keep(box(Vec3(9, 1, 9))), -1 * up, BodyType::fixed, turn, m);
    const std::uint32_t b = t.add(t.keep(box(Vec3(0.2, 0.1, 0.15))), 0.1 * up, BodyType::dynamic, turn, m);
    const int n = static_cast<int>(seconds / dt + 0.5);
    for (int i = 0; i < n; ++i) t.world.step(dt);
    const Real way = (t.world.state.x[b] - 0.1 * up).dot(down);
    errs_by(std::fabs(way - kG / 2 * (at.sin - friction * at.cos) * seconds * seconds), 2e-3 * dt + 1e-9, dt, solver);
  });
}

/// An arm whose drives push with what a host says anew in each step, or at their bounds.
struct PushedArm {
  int links;
  Real mass, effort, drag;  // kg, N m, 1
  AxisDrive mode;           // effort, or a speed that is out of reach

  Vec3 run(std::uint32_t solver, Real dt) const {
    TestWorld t;
    t.world.set_dial(Dial::solver, solver), t.world.set_dial(Dial::substeps, 1);
    const Real length = 0.4;
    std::uint32_t before = kInvalid;
    for (int i = 0; i < links; ++i) {
      const Real m = mass / (i + 1);
      const std::uint32_t b = add_body(t, Vec3((i + 0.5) * length, 0, 0), m, m * Vec3(0.002, 0.015, 0.016));
      const std::uint32_t j = join_axes(t, before, b, Vec3(i * length, 0, 0), i % 2 ? kOblique : Quat::identity());
      set_all(t, j, 5, locked_at());
      t.world.set_damping(b, 0, drag);
      before = b;
    }
    const int n = static_cast<int>(std::lround(0.05 / dt));
    for (int k = 0; k < n; ++k) {
      for (int i = 0; i < links; ++i) {
        JointAxis a;
        a.drive = mode, a.armature = 0.01;
        const Real now = effort / (i + 1) * (1 + 0.3 * std::cos(40 * k * dt + i));
        if (mode == AxisDrive::effort)
          a.effort = i % 2 ? -now : now;
        else
          a.max_force = now, a.speed = i % 2 ? -1e4 : 1e4;
        t.world.set_joint_axis(static_cast<std::uint32_t>(i), 5, a);
      }
      t.world.step(dt);
    }
    return t.world.state.x[before];
  }
};

/// Steps of half the length err by half as much: what is off is no noise of what a solver leaves.
void arms_that_are_pushed(void**) {
  for (const PushedArm& arm : {PushedArm{3, 2, 4, 0, AxisDrive::effort}, PushedArm{6, 1, 9, 1e-15, AxisDrive::effort},
                               PushedArm{5, 7, 30, 0.3, AxisDrive::velocity}})
    for (const std::uint32_t solver : {kDirectChoice, kAutoChoice}) {
      Vec3 at[4];
      for (int k = 0; k < 4; ++k) at[k] = arm.run(solver, 1.0 / (10000 << k));
      const Real first = (at[1] - at[0]).norm(), second = (at[2] - at[1]).norm(), third = (at[3] - at[2]).norm();
      print_message("%d links: steps differ by %.2e, %.2e, %.2e m\n", arm.links, first, second, third);
      assert_true(second < 0.6 * first + 1e-11 && third < 0.6 * second + 1e-11);
    }
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(a_ball_off_a_ball),
      cmocka_unit_test(a_large_ball_off_a_small_one),
      cmocka_unit_test(a_ball_without_friction),
      cmocka_unit_test(a_capsule_off_a_cylinder),
      cmocka_unit_test(a_cylinder_off_a_cylinder),
      cmocka_unit_test(a_box_over_an_edge),
      cmocka_unit_test(a_block_down_a_slope),
      cmocka_unit_test(arms_that_are_pushed),
      cmocka_unit_test(what_is_asked_of_round_pairs_is_got_or_told),
  };
  return cmocka_run_group_tests_name("oracle/fine_steps", tests, nullptr, nullptr);
}
