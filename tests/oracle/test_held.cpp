// What pads hold by friction alone, against closed forms: it stays while friction bears it, and slides as it must where
// friction does not. Written for solutions that go on from step to step (solver/direct/cone_group.cpp).
#include <cmath>
#include <cstdio>
#include <numbers>

#include "carom_test.h"
#include "joint_scenes.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr Real kSettled = 0.5;     // s
constexpr Real kThickness = 0.02;  // m, of a pad

/// Pads on rails of the world around something, each pressed to the middle by a motor.
struct Gripper {
  TestWorld t;
  std::uint32_t held = kInvalid;

  Gripper(int solver, int substeps) { choose(t, solver, substeps); }

  /// @param angle  rad about y, where the pad stands   @param away  m, of its inner face from the middle
  void add_pad(Real angle, Real away, const Vec3& middle, Real force, std::uint32_t material) {
    const Vec3 outwards(std::cos(angle), 0, std::sin(angle));
    const Quat turn = x_along(outwards);
    const Vec3 at = middle + (away + kThickness / 2 + 1e-4) * outwards;
    const std::uint32_t pad =
        t.add(t.keep(box(Vec3(kThickness / 2, 0.04, 0.02))), at, BodyType::dynamic, turn, material);
    const std::uint32_t rail = join(t, JointKind::slider, kInvalid, pad, at, x_along(-outwards));
    set_motor(t, rail, Coordinate::slide, 0.1, force);
  }
  Real mass() const { return t.world.scene.mass[held]; }
  /// m, that it goes in some seconds after it has settled.
  Real creep(Real seconds, Real dt) {
    t.run(static_cast<int>(std::lround(kSettled / dt)), dt);
    const Vec3 from = t.world.state.x[held];
    t.run(static_cast<int>(std::lround(seconds / dt)), dt);
    return (t.world.state.x[held] - from).norm();
  }
};

/// m/s that the solver may leave at a contact, over the time: nothing else creeps.
Real borne_creep(const Gripper& g, Real seconds) { return g.t.world.scene.dials[Dial::velocity_tolerance] * seconds; }

}  // namespace

/// Pads in pairs and threes, on boxes and on round things: friction bears some times the weight.
static void what_friction_bears_stays(void**) {
  struct Case {
    int solver, pads;
    bool round;
    Real friction, times, dt;
  };
  for (const Case& c :
       {Case{kAutoChoice, 2, false, 0.7, 30, 1.0 / 60}, Case{kDirectChoice, 2, true, 0.4, 5, 1.0 / 60},
        Case{kAutoChoice, 3, true, 0.5, 3, 1.0 / 60}, Case{kDirectChoice, 3, true, 1, 100, 1.0 / 240},
        Case{kAutoChoice, 4, false, 0.3, 2, 1.0 / 30}, Case{kDirectChoice, 4, true, 0.9, 1.5, 1.0 / 50}}) {
    Gripper g(c.solver, 4);
    const std::uint32_t material = g.t.material(c.friction, 0);
    const Shape* shape = g.t.keep(c.round ? cylinder(0.03, 0.03) : box(Vec3::constant(0.03)));
    g.held = g.t.add(shape, Vec3(0, 1, 0), BodyType::dynamic, Quat::identity(), material);
    const Real force = c.times * g.mass() * kG / (c.friction * c.pads);
    for (int k = 0; k < c.pads; ++k) g.add_pad(2 * std::numbers::pi * k / c.pads, 0.03, Vec3(0, 1, 0), force, material);
    const Real creep = g.creep(2, c.dt), most = borne_creep(g, 2);
    std::printf("%d pads, %s, solver %d, %g times, %.0f Hz: %.2e of %.2e m\n", c.pads, c.round ? "cylinder" : "box",
                c.solver, c.times, 1 / c.dt, creep, most);
    assert_true(creep <= most);
  }
}

/// Between two pads that bear a share of the weight it falls with the rest of it.
static void what_friction_does_not_bear_slides(void**) {
  for (const Real share : {0.25, 0.5, 0.8, 0.95})
    for (const int solver : {kAutoChoice, kDirectChoice})
      for (const Real dt : {1.0 / 60, 1.0 / 200}) {
        Gripper g(solver, 4);
        const std::uint32_t material = g.t.material(0.5, 0);
        g.held =
            g.t.add(g.t.keep(box(Vec3(0.03, 0.4, 0.03))), Vec3(0, 1, 0), BodyType::dynamic, Quat::identity(), material);
        g.t.world.set_gravity(Vec3::zero());
        const Real force = share * g.mass() * kG / (2 * 0.5);
        for (int k = 0; k < 2; ++k) g.add_pad(std::numbers::pi * k, 0.03, Vec3(0, 1, 0), force, material);
        g.t.run(static_cast<int>(std::lround(kSettled / dt)), dt);  // pads are closed
        g.t.world.set_gravity(Vec3(0, -kG, 0));
        const Real from = g.t.world.state.x[g.held].y(), time = 0.2;
        const int steps = static_cast<int>(std::lround(time / dt));
        g.t.run(steps, dt);
        const Real gone = from - g.t.world.state.x[g.held].y(), a = (1 - share) * kG, want = a * time * time / 2;
        // A step's worth of the way for where in a step friction begins to slide, as one of first order has it.
        const Real most = a * time * dt + 1e-6;
        std::printf("%g of the weight, solver %d, %.0f Hz: %.6f of %.6f m\n", share, solver, 1 / dt, gone, want);
        assert_true(std::fabs(gone - want) <= most);
      }
}

/// A shelf welded to the wall bears what lies on it, and a prop under it bears nothing: loads go where least force does.
static void a_weld_bears_what_a_prop_only_touches(void**) {
  for (const Real mass : {0.5, 5.0, 50.0})
    for (const Real dt : {1.0 / 60, 1.0 / 250}) {
      TestWorld t;
      choose(t, kAutoChoice, 4);
      t.ground();
      const Shape* plank = t.keep(box(Vec3(0.5, 0.05, 0.2)));
      const std::uint32_t shelf = t.add(plank, Vec3(0, 1.05, 0));
      t.add(t.keep(box(Vec3(0.1, 0.5, 0.1))), Vec3(0.4, 0.5, 0), BodyType::fixed);
      BodyDef def;
      def.has_mass = true, def.mass = mass, def.pose.p = Vec3(0.1, 1.2, 0);
      const std::uint32_t load = handle_slot(t.world.add_body(def));
      t.world.add_collider(load, t.keep(box(Vec3::constant(0.1))), Pose{}, 1000, Colliders::kNoMaterial);
      const std::uint32_t weld = join(t, JointKind::weld, kInvalid, shelf, Vec3(-0.5, 1.05, 0));
      t.run(static_cast<int>(std::lround(1 / dt)), dt);
      const Real want = (t.world.scene.mass[shelf] + mass) * kG;
      const Real force = std::fabs(joint(t, weld).force.y());
      std::printf("%g kg, %.0f Hz: %.5f of %.5f N\n", mass, 1 / dt, force, want);
      assert_true(std::fabs(force - want) < 1e-3 * want);
    }
}

/// Pads on rails of an arm that turns about y, across its plane or all round its length, and what they hold at its end.
struct Arm {
  bool driven;
  int pads;
  bool round;
  Real spin, length, size, friction, dt;
};

/// It keeps its place in the hand: a thousandth of the arm in a hundred turns.
static void what_an_arm_takes_round_stays(void**) {
  for (const Arm& c :
       {Arm{false, 2, false, 0.5, 1, 0.05, 0.9, 1.0 / 60}, Arm{true, 2, false, 0.5, 1, 0.05, 0.9, 1.0 / 60},
        Arm{false, 2, true, 2, 1, 0.05, 0.4, 1.0 / 60}, Arm{true, 2, false, 4, 1, 0.05, 0.9, 1.0 / 60},
        Arm{false, 3, true, 3, 0.2, 0.01, 0.6, 1.0 / 60}, Arm{true, 4, false, 1, 3, 0.1, 0.3, 1.0 / 30},
        Arm{false, 4, false, 4, 0.7, 0.04, 0.7, 1.0 / 120}}) {
    constexpr int kSubsteps = 4;
    TestWorld t;
    choose(t, kAutoChoice, kSubsteps);
    t.world.set_gravity(Vec3::zero());
    const std::uint32_t material = t.material(c.friction, 0);
    const Shape* const beam = t.keep(box(Vec3(0.45 * c.length, 0.03 * c.length, 0.03 * c.length)));
    const std::uint32_t arm = t.add(beam, Vec3::zero(), c.driven ? BodyType::dynamic : BodyType::kinematic);
    const Shape* const shape = t.keep(c.round ? cylinder(c.size, c.size) : box(Vec3::constant(c.size)));
    const Quat lies = c.round ? turn_between(Vec3(0, 1, 0), Vec3(1, 0, 0)) : Quat::identity();
    const Vec3 hand(c.length, 0, 0);
    const std::uint32_t held = t.add(shape, hand, BodyType::dynamic, lies, material);
    const Real most = 0.2 * c.friction * c.pads, force = t.world.scene.mass[held] * c.spin * c.spin * c.length / most;
    const Shape* const pad = t.keep(box(Vec3(0.2 * c.size, 0.4 * c.size, 0.8 * c.size)));
    for (int k = 0; k < c.pads; ++k) {
      const Real angle = 2 * std::numbers::pi * k / c.pads;
      const Vec3 outwards(0, std::cos(angle), std::sin(angle)), at = hand + 1.2 * c.size * outwards;
      const std::uint32_t finger = t.add(pad, at, BodyType::dynamic, x_along(outwards), material);
      const std::uint32_t rail = join(t, JointKind::slider, arm, finger, at, x_along(-outwards));
      set_motor(t, rail, Coordinate::slide, 0.5, force);
    }
    std::uint32_t hinge = kInvalid;
    if (c.driven) hinge = join(t, JointKind::hinge, kInvalid, arm, Vec3::zero(), x_along(Vec3(0, 1, 0)));
    constexpr Real kGathers = 2;  // s, to full speed
    const auto seen = [&] { return t.world.state.q[arm].conjugate() * t.world.state.x[held]; };
    const auto drive = [&](Real spin) {
      if (c.driven)
        set_motor(t, hinge, Coordinate::twist, spin, 1e6);
      else
        t.world.set_velocity(arm, Vec3::zero(), Vec3(0, spin, 0));
    };
    const int starts = static_cast<int>(std::lround(kGathers / c.dt));
    for (int i = 0; i < starts; ++i) drive(c.spin * (i + 1) / starts), t.world.step(c.dt);
    const Vec3 from = seen();
    const Real turns = 5, way = 2 * std::numbers::pi * turns;
    t.run(static_cast<int>(std::lround(way / (c.spin * c.dt))), c.dt);
    const Real crept = (seen() - from).norm() / c.length, bar = 1e-3 * turns / 100;
    std::printf("%s arm, %d pads, %s, %g rad/s: %.2e of %.2e\n", c.driven ? "driven" : "kinematic", c.pads,
                c.round ? "cylinder" : "box", c.spin, crept, bar);
    assert_true(crept <= bar);
  }
}

/// Springs below a thin arm, which leans under them, press two pads that stand off the middle of what they hold.
struct WeakArm {
  bool round;
  Real spin, length, size, frequency;
  Vec3 off;  // m, of the pads
  Real dt;
};

/// As above, under gravity. Pads that slide on rails across the arm are flung along these by half (omega h)^2 of their way from
/// its middle in each substep, and pressed back: it is asked to go round with neither.
static void what_weak_springs_hold_stays(void**) {
  constexpr Real kDrop = 0.15,
                 kPress = 0.01;  // m, of the hand below the arm; that springs would go beyond what is held
  for (const WeakArm& c : {WeakArm{false, 2.6, 0.5, 0.04, 30, Vec3::zero(), 1.0 / 60},
                           WeakArm{false, 4, 0.35, 0.04, 30, Vec3::zero(), 1.0 / 60},
                           WeakArm{false, 3.5, 0.45, 0.04, 30, Vec3(0.012, 0.008, 0), 1.0 / 60},
                           WeakArm{true, 3, 0.4, 0.035, 30, Vec3::zero(), 1.0 / 60},
                           WeakArm{false, 4, 0.35, 0.05, 60, Vec3(-0.015, -0.01, 0), 1.0 / 120},
                           WeakArm{true, 1.7, 0.8, 0.06, 40, Vec3(0, 0.01, 0), 1.0 / 90}}) {
    TestWorld t;
    choose(t, kAutoChoice, 4);
    const std::uint32_t material = t.material(0.9, 0);
    const Vec3 hand(c.length, 0, 0), middle(c.length / 2, kDrop, 0);
    const Real mass = 0.8, across = mass * c.length * c.length / 12;
    const std::uint32_t arm = add_body(t, middle, mass, Vec3(2e-4, across, across));
    const std::uint32_t hinge = join(t, JointKind::hinge, kInvalid, arm, Vec3(0, kDrop, 0), x_along(Vec3(0, 1, 0)));
    set_motor(t, hinge, Coordinate::twist, c.spin, 1e4);
    const Shape* const shape = t.keep(c.round ? cylinder(c.size, c.size) : box(Vec3::constant(c.size)));
    const Quat lies = c.round ? x_along(Vec3(0, 1, 0)) : Quat::identity();
    const std::uint32_t held = t.add(shape, hand, BodyType::dynamic, lies, material);
    const Shape* const pad = t.keep(box(Vec3(0.01, 0.05, 0.05)));
    std::vector<std::uint32_t> bodies = {arm, held};
    for (const Real side : {-1.0, 1.0}) {
      const Vec3 outwards(0, 0, side), at = hand + c.off + (c.size + 0.01) * outwards;
      bodies.push_back(t.add(pad, at, BodyType::dynamic, x_along(outwards), material));
      const std::uint32_t rail = join(t, JointKind::slider, arm, bodies.back(), at, x_along(outwards));
      set_spring(t, rail, Coordinate::slide, -kPress, c.frequency, 1);
    }
    const Vec3 spin(0, c.spin, 0);
    for (const std::uint32_t body : bodies) t.world.set_velocity(body, spin.cross(t.world.state.x[body]), spin);
    const auto seen = [&] { return t.world.state.q[arm].conjugate() * (t.world.state.x[held] - t.world.state.x[arm]); };
    t.run(static_cast<int>(std::lround(kSettled / c.dt)), c.dt);
    const Vec3 from = seen();
    const Real turns = 5, bar = 1e-3 * turns / 100;
    t.run(static_cast<int>(std::lround(2 * std::numbers::pi * turns / (c.spin * c.dt))), c.dt);
    const Real crept = (seen() - from).norm() / c.length;
    std::printf("%s, %g rad/s, %g Hz: %.2e of %.2e\n", c.round ? "cylinder" : "box", c.spin, c.frequency, crept, bar);
    assert_true(crept <= bar);
  }
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(what_friction_bears_stays),
      cmocka_unit_test(what_friction_does_not_bear_slides),
      cmocka_unit_test(a_weld_bears_what_a_prop_only_touches),
      cmocka_unit_test(what_an_arm_takes_round_stays),
      cmocka_unit_test(what_weak_springs_hold_stays),
  };
  return cmocka_run_group_tests_name("oracle/held", tests, nullptr, nullptr);
}
