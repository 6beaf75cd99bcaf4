// What friction holds on ground that turns: discs by every solver, steps and shapes, stacks, a disc of its own bearings,
// belts that bend, and a disc that hardly turns.
#include <algorithm>
#include <array>

#include "carom_test.h"
#include "dynamics/force/force.h"
#include "sliced.h"
#include "world_builder.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr Real kTau = 6.283185307179586;

/// A body that stands on a disc at some place, and goes along with it.
struct Ride {
  Real spin = 1, radius = 0.5, dt = 1.0 / 60;
  Real substeps = 4;
  std::uint32_t solver = kAutoChoice;
  Vec3 half = Vec3::constant(0.1);
  bool is_round = false;
  int bodies = 1;

  /// How far from its circle, of the radius, and how far from its angle, rad; of the worst body, at any time.
  /// And by how much its foot sinks or rises at a corner, m.
  struct Off {
    Real radius = 0, angle = 0, foot = 0;
  };
  enum class Ground { disc, belt, bearings };

  Off run(Ground ground, Real turns) const {
    TestWorld t;
    t.world.set_dial(Dial::solver, solver);
    t.world.set_dial(Dial::substeps, substeps);
    const std::uint32_t m = t.material(1, 0);
    const Vec3 omega(0, spin, 0);
    const Shape* const disc = t.keep(box(Vec3(1.5, 0.1, 1.5)));
    if (ground == Ground::belt) {
      const std::uint32_t belt = t.add(disc, Vec3(0, -0.1, 0), BodyType::fixed, Quat::identity(), m);
      t.world.set_surface_velocity(t.world.scene.first_collider[belt], {Vec3::zero(), omega});
    } else {
      const BodyType type = ground == Ground::disc ? BodyType::kinematic : BodyType::dynamic;
      const std::uint32_t body = t.add(disc, Vec3(0, -0.1, 0), type, Quat::identity(), m);
      t.world.set_velocity(body, Vec3::zero(), omega);
      if (ground == Ground::bearings)  // all but about y
        t.world.set_attribute(body, AttributeId::locks, {Real(kAllLocks & ~16)});
    }
    const Shape* const shape = t.keep(is_round ? cylinder(half.x(), half.y()) : box(half));
    std::vector<std::uint32_t> riders;
    for (int i = 0; i < bodies; ++i) {
      riders.push_back(t.add(shape, Vec3(radius, (2 * i + 1) * half.y(), 0), BodyType::dynamic, Quat::identity(), m));
      t.world.set_velocity(riders.back(), Vec3(0, 0, -spin * radius), omega);
    }
    Off worst;
    Real turned = 0;
    const int n = static_cast<int>(turns * kTau / (std::fabs(spin) * dt));
    for (int i = 0; i < n; ++i) {
      t.world.step(dt);
      turned += dt * (ground == Ground::bearings ? t.world.state.omega[0].y() : spin);
      const SinCos at = sin_cos(turned);
      for (const std::uint32_t body : riders) {
        const Vec3& x = t.world.state.x[body];
        const Vec3 up = t.world.state.q[body].conjugate() * Vec3(0, 1, 0);
        const Real over = x.y() - (2 * (body - riders[0]) + 1) * half.y();
        worst.foot =
            std::max(worst.foot, std::fabs(over) + std::fabs(up.x()) * half.x() + std::fabs(up.z()) * half.z());
        const Real r = std::sqrt(x.x() * x.x() + x.z() * x.z());
        worst.radius = std::max(worst.radius, std::fabs(r - radius) / radius);
        worst.angle = std::max(worst.angle, std::fabs(-x.z() * at.cos - x.x() * at.sin) / r);
      }
    }
    return worst;
  }
};

/// Of the radius. What a hundred turns may be off by; what comes to its loads over some steps has slipped until then.
constexpr Real kBar = 1e-3;
const Real kTurns = sliced<Real>(4, 4, 1);

bool is_exact(std::uint32_t solver) { return solver >= kDirectChoice; }

}  // namespace

static void what_stands_on_a_disc_keeps_its_circle(void**) {
  for (std::uint32_t solver = 0; solver < kSolverChoices; ++solver)
    for (const Real spin : {0.5, 1.0, 2.0})
      for (const bool is_round : {false, true}) {
        Ride ride;
        ride.solver = solver, ride.spin = spin, ride.is_round = is_round;
        const Ride::Off off = ride.run(Ride::Ground::disc, kTurns);
        print_message("solver %u, %.1f rad/s, %s: off %.2e of the radius, %.2e rad\n", solver, spin,
                      is_round ? "cylinder" : "box", off.radius, off.angle);
        assert_true(off.radius < (is_exact(solver) ? kBar * kTurns / 100 : kBar));
        assert_true(off.angle < kBar);
      }
}

/// A round base bears a load that would tip a square one within its rim: it finds the point of its rim that it tips over.
static void a_can_leans_on_its_rim(void**) {
  struct Can {
    Real spin, radius, width, half;  // rad/s, m
  };
  // The load to the side is 0.82, 0.78, 0.73 and 0.79 of what tips it. Of a rim eight points are known, of which four bear:
  // beyond 0.83 the four may take turns, and the can creeps by millimetres.
  for (const Can& can :
       {Can{4, 0.5, 0.1, 0.1}, Can{3.2, 0.6, 0.16, 0.2}, Can{3, 0.8, 0.13, 0.13}, Can{2.1, 1.35, 0.05, 0.065}})
    for (const std::uint32_t solver : {kDirectChoice, kAutoChoice}) {
      Ride ride;
      ride.solver = solver, ride.spin = can.spin, ride.radius = can.radius, ride.is_round = true;
      ride.half = Vec3(can.width, can.half, can.width);
      const Ride::Off off = ride.run(Ride::Ground::disc, 2 * kTurns);
      print_message("solver %u, %.1f rad/s at %.2f m: off %.2e, %.2e rad\n", solver, can.spin, can.radius, off.radius,
                    off.angle);
      assert_true(off.radius < kBar && off.angle < kBar);
    }
}

/// A load that goes round with the ground is borne in every substep: what each left over would tip a slender box by and by.
static void nor_does_it_lean(void**) {
  struct Rider {
    Real spin, radius, dt;
    Vec3 half;
    int bodies;
  };
  for (const Rider& r :
       {Rider{0.9, 0.21, 1.0 / 60, Vec3(0.06, 0.11, 0.08), 1}, Rider{0.5, 0.21, 1.0 / 240, Vec3(0.06, 0.11, 0.08), 1},
        Rider{0.7, 0.33, 1.0 / 60, Vec3(0.05, 0.02, 0.09), 1}, Rider{1.4, 0.4, 1.0 / 30, Vec3(0.1, 0.17, 0.07), 1},
        Rider{0.6, 1.2, 1.0 / 60, Vec3(0.3, 0.25, 0.2), 2}}) {
    Ride ride;
    ride.spin = r.spin, ride.radius = r.radius, ride.dt = r.dt, ride.half = r.half, ride.bodies = r.bodies;
    const Ride::Off off = ride.run(Ride::Ground::disc, 2 * kTurns);
    // A solution leaves a thousandth of the fastest contact: of how far the ground's way bends in a substep, over it.
    const Real left = 1e-3 * r.spin * r.spin * r.radius * r.dt / ride.substeps / 2;
    const Real bar = left * 2 * kTurns * kTau / r.spin;
    print_message("%.1f rad/s at %.2f m, 1/%.0f s: a foot off by %.2e m of %.2e\n", r.spin, r.radius, 1 / r.dt,
                  off.foot, bar);
    assert_true(off.foot < bar);
  }
}

static void nor_does_it_leave_it_at_other_steps(void**) {
  for (const Real dt : {1.0 / 30, 1.0 / 120, 1.0 / 240})
    for (const Real substeps : {1.0, 8.0})
      for (const std::uint32_t solver : {kDirectChoice, kAutoChoice}) {
        Ride ride;
        ride.dt = dt, ride.substeps = substeps, ride.solver = solver, ride.spin = 1.7, ride.radius = 0.83;
        const Ride::Off off = ride.run(Ride::Ground::disc, kTurns);
        print_message("solver %u, 1/%.0f s, %.0f substeps: off %.2e, %.2e rad\n", solver, 1 / dt, substeps, off.radius,
                      off.angle);
        assert_true(off.radius < kBar && off.angle < kBar);
      }
}

static void a_stack_stays_on_it(void**) {
  for (const std::uint32_t solver : {kDirectChoice, kAutoChoice}) {
    Ride ride;
    ride.solver = solver, ride.bodies = 3, ride.half = Vec3(0.2, 0.1, 0.15), ride.spin = 1.3, ride.radius = 0.7;
    const Ride::Off off = ride.run(Ride::Ground::disc, kTurns);
    print_message("solver %u, three: off %.2e, %.2e rad\n", solver, off.radius, off.angle);
    assert_true(off.radius < kBar && off.angle < kBar);
  }
}

static void so_does_what_stands_on_a_disc_of_its_own_bearings(void**) {
  for (std::uint32_t solver = kSoftChoice; solver < kSolverChoices; ++solver) {  // severity knows no locks
    Ride ride;
    ride.solver = solver, ride.spin = 1.5, ride.radius = 0.6;
    const Ride::Off off = ride.run(Ride::Ground::bearings, kTurns);
    print_message("solver %u, bearings: off %.2e, %.2e rad\n", solver, off.radius, off.angle);
    assert_true(off.radius < kBar);
  }
}

static void and_what_a_belt_takes_round_a_bend(void**) {
  for (std::uint32_t solver = 0; solver < kSolverChoices; ++solver) {
    Ride ride;
    ride.solver = solver, ride.spin = 0.8, ride.radius = 1.1;
    if (solver == kSeverityChoice) ride.substeps = 1;  // its points, one by one, have the belt of the step's beginning
    const Ride::Off off = ride.run(Ride::Ground::belt, kTurns);
    print_message("solver %u, belt: off %.2e, %.2e rad\n", solver, off.radius, off.angle);
    assert_true(off.radius < kBar && off.angle < kBar);
  }
}

/// Near its middle too, where its corners go by other ways than its middle does.
static void nor_near_the_middle_of_a_bend(void**) {
  struct Rider {
    Real spin, radius;
    Vec3 half;
  };
  for (const Rider& r : {Rider{1.6, 0.6, Vec3(0.09, 0.05, 0.06)}, Rider{-2.4, 0.45, Vec3(0.09, 0.05, 0.06)},
                         Rider{1.1, 0.3, Vec3(0.2, 0.1, 0.15)}, Rider{2, 0.25, Vec3(0.03, 0.04, 0.08)}})
    for (const std::uint32_t solver : {kSoftChoice, kDirectChoice, kAutoChoice}) {
      Ride ride;
      ride.solver = solver, ride.spin = r.spin, ride.radius = r.radius, ride.half = r.half;
      const Ride::Off off = ride.run(Ride::Ground::belt, kTurns);
      print_message("solver %u, belt %.1f rad/s at %.2f m: off %.2e, %.2e rad\n", solver, r.spin, r.radius, off.radius,
                    off.angle);
      assert_true(off.radius < (is_exact(solver) ? kBar * kTurns / 100 : kBar) && off.angle < kBar);
    }
}

/// A disc that turns by a motor of 1e-15 rad/s is one that stands, but for rounding.
static void a_disc_that_hardly_turns_is_one_that_stands(void**) {
  const auto slides = [](Real spin) {
    TestWorld t;
    const std::uint32_t m = t.material(0.5, 0);
    const std::uint32_t disc =
        t.add(t.keep(box(Vec3(4, 0.1, 4))), Vec3(0, -0.1, 0), BodyType::kinematic, Quat::identity(), m);
    t.world.set_velocity(disc, Vec3::zero(), Vec3(0, spin, 0));
    const std::uint32_t body =
        t.add(t.keep(box(Vec3(0.2, 0.1, 0.1))), Vec3(1, 0.1, 0.5), BodyType::dynamic, Quat::identity(), m);
    t.world.set_velocity(body, Vec3(1, 0, 0.5), Vec3(0, 3, 0));
    t.run(60, 1.0 / 60);
    return t.world.state.x[body];
  };
  const Real apart = (slides(1e-15) - slides(0)).norm();
  print_message("apart by %.2e m\n", apart);
  assert_true(apart < 1e-6 / 60);  // what the direct solver leaves of a velocity, in a step
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(what_stands_on_a_disc_keeps_its_circle),
      cmocka_unit_test(a_can_leans_on_its_rim),
      cmocka_unit_test(nor_does_it_lean),
      cmocka_unit_test(nor_does_it_leave_it_at_other_steps),
      cmocka_unit_test(a_stack_stays_on_it),
      cmocka_unit_test(so_does_what_stands_on_a_disc_of_its_own_bearings),
      cmocka_unit_test(and_what_a_belt_takes_round_a_bend),
      cmocka_unit_test(nor_near_the_middle_of_a_bend),
      cmocka_unit_test(a_disc_that_hardly_turns_is_one_that_stands),
  };
  return cmocka_run_group_tests_name("oracle/turning_ground", tests, nullptr, nullptr);
}
