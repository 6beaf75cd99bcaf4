// Belts and turntables against closed forms: what is dropped on a belt, a ball on a turntable, opposite belts, tracks.
#include <algorithm>
#include <numbers>

#include "carom_test.h"
#include "dynamics/contact/contact.h"
#include "dynamics/solver/wide_contacts.h"
#include "world_builder.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr Real kG = 9.81;

bool is_soft(std::uint32_t solver) { return solver == kSoftChoice || solver == kAutoChoice; }

std::uint32_t collider_of(const TestWorld& t, std::uint32_t body) { return t.world.scene.first_collider[body]; }
void drive(TestWorld& t, std::uint32_t body, const Vec3& linear, const Vec3& angular = Vec3::zero()) {
  t.world.set_surface_velocity(collider_of(t, body), {linear, angular});
}
void choose(TestWorld& t, std::uint32_t solver, Real substeps) {
  t.world.set_dial(Dial::solver, solver);
  t.world.set_dial(Dial::substeps, substeps);
  t.world.set_dial(Dial::velocity_tolerance, 1e-9);
  t.world.set_dial(Dial::velocity_iterations, 200);
}

/// Low and wide, so that friction lifts no edge of it.
const Vec3 kSlab(0.5, 0.1, 0.5);

constexpr Real kMu = 0.4, kBelt = 2, kTime = 1;
/// m: how far a thing at rest has come after kTime, on a belt that it slips on at first.
constexpr Real way() { return kBelt * kTime - kBelt * kBelt / (2 * kMu * kG); }
/// m: likewise of steps of semi-implicit Euler: sum of h min(k mu g h, belt).
Real way_in_steps(int n) {
  const Real h = kTime / n;
  Real x = 0;
  for (int k = 1; k <= n; ++k) x += h * std::min(k * kMu * kG * h, kBelt);
  return x;
}

struct Ridden {
  Vec3 way, v;
};
/// A slab that is put down on a belt, in n steps.
Ridden ride(std::uint32_t solver, int n, Real substeps, const Vec3& gravity = Vec3(0, -kG, 0)) {
  TestWorld t(gravity);
  choose(t, solver, substeps);
  const std::uint32_t m = t.material(kMu, 0);
  drive(t, t.ground(m), Vec3(kBelt, 0, 0));
  const std::uint32_t slab = t.add(t.keep(box(kSlab)), Vec3(0, 0.1, 0), BodyType::dynamic, Quat::identity(), m);
  t.run(n, kTime / n);
  return {t.world.state.x[slab] - Vec3(0, 0.1, 0), t.world.state.v[slab]};
}

/// A slab with tracks of its own, turned by `angle` about the vertical.
Ridden drive_off(std::uint32_t solver, int n, Real angle) {
  TestWorld t(Vec3(0, -kG, 0));
  choose(t, solver, 1);
  const std::uint32_t m = t.material(kMu, 0);
  t.ground(m);
  const std::uint32_t tank =
      t.add(t.keep(box(kSlab)), Vec3(0, 0.1, 0), BodyType::dynamic, exp_map(Vec3(0, angle, 0)), m);
  drive(t, tank, Vec3(-kBelt, 0, 0));
  t.run(n, kTime / n);
  return {t.world.state.x[tank] - Vec3(0, 0.1, 0), t.world.state.v[tank]};
}

/// m: how far from its circle a ball is that rolls on a turntable for two seconds.
Real off_the_circle(std::uint32_t solver, int n) {
  constexpr Real kSpin = 1.5, kRadius = 0.5, kAll = 2;
  TestWorld t(Vec3(0, -kG, 0));
  choose(t, solver, 1);
  const std::uint32_t m = t.material(1, 0);
  drive(t, t.ground(m), Vec3::zero(), Vec3(0, kSpin, 0));
  const Vec3 x0(1, kRadius, 0.5), v0(0.3, 0, -0.4), up(0, 1, 0);
  const std::uint32_t ball = t.add(t.keep(sphere(kRadius)), x0, BodyType::dynamic, Quat::identity(), m);
  // Without slip v + omega x (-R up) = spin up x x; then v' = 2/7 spin up x v for a solid ball.
  t.world.set_velocity(ball, v0, up.cross(v0 - kSpin * up.cross(x0)) / kRadius);
  t.run(n, kAll / n);
  const Real rate = kSpin * 2 / 7;
  const SinCos sc = sin_cos(rate * kAll);
  // The way is the integral of v0 turned by rate s about up, from 0 to the end.
  const Vec3 want = x0 + (sc.sin / rate) * v0 + ((1 - sc.cos) / rate) * up.cross(v0);
  return (t.world.state.x[ball] - want).norm();
}

}  // namespace

static void what_is_put_on_a_belt_slips_then_rides(void**) {
  for (std::uint32_t solver = 0; solver < kSolverChoices; ++solver)
    for (const int n : {60, 120, 240}) {
      const Ridden r = ride(solver, n, is_soft(solver) ? 4 : 1);
      print_message("solver %u, n %d: off %.2e, of the sum %.2e, v %.2e\n", solver, n, r.way.x() - way(),
                    r.way.x() - way_in_steps(n), r.v.x() - kBelt);
      // A step of mu g h is what a solver may be late by with its friction.
      assert_true(std::fabs(r.way.x() - way()) < kMu * kG * kTime * kTime / n);
      // Springs sink by g / w^2 = 0.3 mm as the slab is put down and swing once or twice; what is left of that after a
      // second is below 1e-4 of it a step of 1/60 s.
      const Real rest = is_soft(solver) ? 1e-4 * (kG / (4 * 30 * 30 * 9.87)) * 60 * 60 : 1e-9;
      assert_true(std::fabs(r.v.x() - kBelt) < rest && std::fabs(r.way.z()) < rest);
    }
}

/// The paper's solver moves bodies by the velocity of a step's end.
static void the_paper_s_solver_does_what_its_integrator_does(void**) {
  for (const int n : {60, 240}) assert_true(std::fabs(ride(kSeverityChoice, n, 1).way.x() - way_in_steps(n)) < 1e-6);
}

/// The others by the mean of a step, which is exact until the belt catches the slab, at some time in a step. That one
/// it moves by the belt's velocity; and the one before, too, if what slips at its end is less than half of mu g h:
/// together mu g h^2 (1/2 + 1/8) too far at most. Springs (of 30 Hz, or a quarter of the step's rate, with ten times
/// the critical damping) let it sink by g / (2 w)^2 meanwhile, under less friction, and as long as they tilt it, 20 /
/// w, it goes by the velocities of steps' ends.
static void what_slips_moves_by_its_mean_velocity(void**) {
  for (std::uint32_t solver = kSoftChoice; solver < kSolverChoices; ++solver)
    for (const int n : {60, 120, 240, 480}) {
      const Real h = kTime / n, off = ride(solver, n, 1).way.x() - way();
      const Real w = 2 * 3.1416 * std::min(30.0, 0.25 / h);
      const Real sinks = is_soft(solver) ? kMu * kG * (1 / (4 * w * w) + h / 2 * 20 / w) : 0;
      print_message("solver %u, n %d: off %.2e\n", solver, n, off);
      assert_true(std::fabs(off) < kMu * kG * h * h * 5 / 8 + sinks + 1e-6);
    }
}

static void a_track_drives_its_body_the_way_it_points(void**) {
  for (std::uint32_t solver = 0; solver < kSolverChoices; ++solver)
    for (const Real angle : {0.0, 0.7, 2.0}) {
      const Ridden r = drive_off(solver, 120, angle);
      const SinCos sc = sin_cos(angle);
      const Vec3 ahead(sc.cos, 0, -sc.sin);
      assert_true(std::fabs(r.way.dot(ahead) - way()) < kMu * kG * kTime * kTime / 120);
      assert_true(std::fabs(r.way.dot(ahead.cross(Vec3(0, 1, 0)))) < 1e-4);
      assert_true((r.v - kBelt * ahead).norm() < 1e-4);
    }
}

static void a_ball_on_a_turntable_goes_in_a_circle(void**) {
  for (std::uint32_t solver = 0; solver < kSolverChoices; ++solver) {
    const Real coarse = off_the_circle(solver, 240), fine = off_the_circle(solver, 480);
    print_message("solver %u: %.2e, %.2e\n", solver, coarse, fine);
    // v' = w x v by Euler's method is off by w h / 2 of the way in each of the w t radians, and the friction of a step
    // knows the table under where the ball was: of first order in h with a factor of the order of 1.
    assert_true(coarse < 1.0 * 2 / 240 && coarse / fine > 1.8 && coarse / fine < 2.2);
  }
}

/// A plank on two rollers that turn towards each other swings to and fro: with c the height of its middle, d half the
/// distance of the rollers and x its place, the loads differ by m g x / (d - mu c), and friction by mu times that. As
/// long as it slips on both, x'' = -mu g x / (d - mu c).
static void a_plank_on_rollers_that_turn_inwards_swings(void**) {
  constexpr Real kAway = 0.2, kApart = 1, kThick = 0.05, kRoller = 0.25;
  const Real w = std::sqrt(kMu * kG / (kApart - kMu * kThick)), T = 2;
  // Not severity: of the many loads on four points it finds one that turns the plank aside.
  for (std::uint32_t solver = kSoftChoice; solver < kSolverChoices; ++solver) {
    const auto off = [&](int n) {
      TestWorld t(Vec3(0, -kG, 0));
      choose(t, solver, 1);
      const std::uint32_t m = t.material(kMu, 0);
      const Shape* roller = t.keep(capsule(kRoller, 1));
      const Quat lies = exp_map(Vec3(std::numbers::pi / 2, 0, 0));  // its axis along z
      for (const Real side : {-1.0, 1.0}) {
        const std::uint32_t r = t.add(roller, Vec3(side * kApart, -kRoller, 0), BodyType::fixed, lies, m);
        // About its own axis, y of the shape, which is the world's z: the left one clockwise.
        drive(t, r, Vec3::zero(), Vec3(0, side * 10, 0));
      }
      const std::uint32_t plank =
          t.add(t.keep(box(Vec3(2, kThick, 0.4))), Vec3(kAway, kThick, 0), BodyType::dynamic, Quat::identity(), m);
      t.run(n, T / n);
      return std::fabs(t.world.state.x[plank].x() - kAway * sin_cos(w * T + std::numbers::pi / 2).sin);
    };
    const Real coarse = off(240), fine = off(480);
    print_message("solver %u: %.2e, %.2e of %.2f m\n", solver, coarse, fine, kAway);
    // Semi-implicit Euler swings with the phase of half a step later, and friction knows the loads of a step before.
    assert_true(coarse < 2 * kAway * w * T / 240 && coarse / fine > 1.6 && coarse / fine < 2.4);
  }
}

static void a_belt_does_not_push_what_stands_at_its_end(void**) {
  const auto end_of = [](std::uint32_t solver, Real speed) {
    TestWorld t(Vec3(0, -kG, 0));
    choose(t, solver, 4);
    const std::uint32_t ice = t.material(0, 0), rubber = t.material(1, 0);
    t.ground(ice);
    const Shape* belt = t.keep(box(Vec3(1, 0.5, 1)));
    drive(t, t.add(belt, Vec3(-1, 0.5, 0), BodyType::fixed, Quat::identity(), rubber), Vec3(speed, 0, 0));
    const Shape* cube = t.keep(box(Vec3::constant(0.5)));
    const std::uint32_t stands = t.add(cube, Vec3(0.5, 0.5, 0), BodyType::dynamic, Quat::identity(), rubber);
    t.run(60, 1.0 / 60);
    return t.world.state.x[stands];
  };
  for (std::uint32_t solver = 0; solver < kSolverChoices; ++solver)
    assert_true((end_of(solver, 3) - end_of(solver, 0)).norm() < 1e-12);
}

static void a_ball_that_bounces_off_a_belt_takes_mu_times_the_blow_along(void**) {
  constexpr Real kHeight = 1, kBounce = 0.5, kRough = 0.1;
  for (std::uint32_t solver = 0; solver < kSolverChoices; ++solver) {
    TestWorld t(Vec3(0, -kG, 0));
    t.world.set_dial(Dial::solver, solver);
    const std::uint32_t m = t.material(kRough, kBounce);
    drive(t, t.ground(m), Vec3(10, 0, 0));
    const std::uint32_t ball =
        t.add(t.keep(sphere(0.1)), Vec3(0, kHeight + 0.1, 0), BodyType::dynamic, Quat::identity(), m);
    t.run(40, 1.0 / 60);  // the first blow is at 0.45 s, the next at 0.9
    const Real want = kRough * (1 + kBounce) * std::sqrt(2 * kG * kHeight);  // below 2/7 of the belt: it slips
    const Real got = t.world.state.v[ball].x();
    print_message("solver %u: %.3e of %.3f m/s\n", solver, got - want, want);
    // The semi-implicit fall has g h / 2 more speed at the top, g h^2 / 8 of height.
    assert_true(std::fabs(got - want) < 1e-3 * want);
  }
}

static void what_resists_spinning_is_spun_up_by_a_turntable(void**) {
  constexpr Real kSpin = 2, kArm = 0.01, kRadius = 0.5;
  for (std::uint32_t solver = 0; solver < kSolverChoices; ++solver) {
    TestWorld t(Vec3(0, -kG, 0));
    choose(t, solver, 4);
    Material rough;
    rough.spinning = kArm;
    const std::uint32_t m = handle_slot(t.world.add_material(rough));
    drive(t, t.ground(m), Vec3::zero(), Vec3(0, kSpin, 0));
    const std::uint32_t ball =
        t.add(t.keep(sphere(kRadius)), Vec3(0, kRadius, 0), BodyType::dynamic, Quat::identity(), m);
    const Real gain = kArm * kG / (0.4 * kRadius * kRadius), dt = 1.0 / 60;  // rad/s^2
    t.run(60, dt);
    // It starts once the load is known, a substep late.
    assert_true(std::fabs(t.world.state.omega[ball].y() - gain) < gain * dt);
    t.run(120, dt);
    assert_true(std::fabs(t.world.state.omega[ball].y() - kSpin) < 1e-6);
  }
}

static void what_moves_no_surface_costs_nothing_and_changes_nothing(void**) {
  std::uint64_t hash[3];
  for (int i = 0; i < 3; ++i) {
    TestWorld t(Vec3(0, -kG, 0));
    const std::uint32_t ground = t.ground();
    if (i > 0) drive(t, ground, Vec3(1, 0, 0));
    if (i == 1) drive(t, ground, Vec3::zero());
    t.add(t.keep(box(kSlab)), Vec3(0, 0.15, 0));
    t.run(60, 1.0 / 60);
    hash[i] = t.world.hash();
    const std::uint64_t participants = t.world.plan->find("surface_velocity")->participants.count;
    assert_int_equal(participants, i == 2 ? t.world.report.contact_points : 0);
    assert_int_equal(t.world.contacts->surface.capacity() > 0, i == 2);
    if (i < 2) assert_int_equal(t.world.wide->in_double.drives.capacity(), 0);
  }
  assert_true(hash[0] == hash[1] && hash[0] != hash[2]);
}

static void what_rides_slower_than_sleepers_move_rides_on(void**) {
  constexpr Real kCrawl = 1e-3;  // m/s
  for (const Real crawl : {0.0, kCrawl}) {
    TestWorld t(Vec3(0, -kG, 0));
    t.world.set_dial(Dial::sleep, 1);
    assert_true(kCrawl < t.world.scene.dials[Dial::sleep_speed]);
    drive(t, t.ground(), Vec3(crawl, 0, 0));
    const std::uint32_t slab = t.add(t.keep(box(kSlab)), Vec3(0, 0.1, 0));
    t.run(600, 1.0 / 60);
    assert_true(t.world.asleep(slab) == (crawl == 0));
    assert_true(std::fabs(t.world.state.x[slab].x() - 10 * crawl) < 0.01 * kCrawl);
  }
}

static void a_sleeper_wakes_when_its_belt_starts(void**) {
  TestWorld t(Vec3(0, -kG, 0));
  t.world.set_dial(Dial::sleep, 1);
  const std::uint32_t ground = t.ground(), slab = t.add(t.keep(box(kSlab)), Vec3(0, 0.1, 0));
  t.run(180, 1.0 / 60);
  assert_true(t.world.asleep(slab));
  drive(t, ground, Vec3(1, 0, 0));
  t.run(60, 1.0 / 60);
  assert_true(std::fabs(t.world.state.v[slab].x() - 1) < 1e-3);
}

static void a_collider_that_comes_into_a_used_slot_stands_still(void**) {
  TestWorld t;
  const Shape* cube = t.keep(box(kSlab));
  const std::uint32_t body = t.add(cube, Vec3::zero()), collider = collider_of(t, body);
  drive(t, body, Vec3(1, 0, 0));
  assert_int_equal(t.world.scene.moving_surfaces, 1);
  t.world.remove_collider(collider);
  assert_int_equal(t.world.scene.moving_surfaces, 0);
  assert_int_equal(handle_slot(t.world.add_collider(body, cube, Pose{}, 1000, Colliders::kNoMaterial)), collider);
  assert_true(!t.world.scene.surface_of(collider).any());
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(what_is_put_on_a_belt_slips_then_rides),
      cmocka_unit_test(the_paper_s_solver_does_what_its_integrator_does),
      cmocka_unit_test(what_slips_moves_by_its_mean_velocity),
      cmocka_unit_test(a_track_drives_its_body_the_way_it_points),
      cmocka_unit_test(a_ball_on_a_turntable_goes_in_a_circle),
      cmocka_unit_test(a_plank_on_rollers_that_turn_inwards_swings),
      cmocka_unit_test(a_belt_does_not_push_what_stands_at_its_end),
      cmocka_unit_test(a_ball_that_bounces_off_a_belt_takes_mu_times_the_blow_along),
      cmocka_unit_test(what_resists_spinning_is_spun_up_by_a_turntable),
      cmocka_unit_test(what_moves_no_surface_costs_nothing_and_changes_nothing),
      cmocka_unit_test(what_rides_slower_than_sleepers_move_rides_on),
      cmocka_unit_test(a_sleeper_wakes_when_its_belt_starts),
      cmocka_unit_test(a_collider_that_comes_into_a_used_slot_stands_still),
  };
  return cmocka_run_group_tests_name("oracle/surface_velocity", tests, nullptr, nullptr);
}
