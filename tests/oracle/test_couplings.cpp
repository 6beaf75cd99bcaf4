// Couplings of joints against closed forms and conserved quantities, under every solver that knows joints.
#include <algorithm>
#include <array>
#include <cmath>

#include "carom_test.h"
#include "joint_scenes.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr int kJointSolvers[] = {kSoftChoice, kDirectChoice, kAutoChoice};
constexpr Real kDt = 1.0 / 60;
using Polynomial = std::array<Real, Coupling::kTerms>;

std::uint32_t couple(TestWorld& t, std::uint32_t follower, std::uint32_t leader, const Polynomial& polynomial) {
  return handle_slot(t.world.add_coupling({follower, leader, polynomial}, 0));
}
Real value_of(const Polynomial& f, Real x) { return (((f[4] * x + f[3]) * x + f[2]) * x + f[1]) * x + f[0]; }
Real slope_of(const Polynomial& f, Real x) { return ((4 * f[4] * x + 3 * f[3]) * x + 2 * f[2]) * x + f[1]; }
Real bend_of(const Polynomial& f, Real x) { return (12 * f[4] * x + 6 * f[3]) * x + 2 * f[2]; }

/// A rod of length l, its end hung at a place, turned by an angle about z from hanging straight down.
struct Pendulum {
  Real mass, length, across;
  Real about_end() const { return across + mass * length * length / 4; }
  /// J, above where it hangs down
  Real lift(Real angle) const { return mass * kG * length / 2 * (1 - std::cos(angle)); }
};
constexpr Pendulum kLong = {2, 0.8, 0.11}, kShort = {1.3, 0.5, 0.03};

std::uint32_t hang(TestWorld& t, const Pendulum& p, const Vec3& at, Real angle, std::uint32_t& hinge,
                   std::uint32_t from = kInvalid) {
  const Quat turn = exp_map(Vec3(0, 0, angle));
  const std::uint32_t body = add_body(t, at + turn * Vec3(0, -p.length / 2, 0), p.mass,
                                      Vec3(p.across, p.across / 50, p.across), BodyType::dynamic, turn);
  JointDef def = joint_at(t, JointKind::hinge, from, body, at, x_along(Vec3(0, 0, 1)));
  def.frame_b.q = x_along(Vec3(0, 0, 1));  // 0 where it hangs down beside the world
  hinge = handle_slot(t.world.add_joint(def));
  return body;
}

/// Two pendulums of which one follows the other.
struct CoupledPair {
  TestWorld t;
  Polynomial f;
  std::uint32_t follower = 0, leader = 0, coupling = 0;
  explicit CoupledPair(const Polynomial& polynomial, Real leads = 0.9) : f(polynomial) {
    hang(t, kShort, Vec3(0, 0, 0), value_of(f, leads), follower);
    hang(t, kLong, Vec3(3, 0, 0), leads, leader);
    coupling = couple(t, follower, leader, f);
  }
  Real at(std::uint32_t hinge) const { return coordinate(t, hinge, Coordinate::twist); }
  Real off() const { return std::fabs(at(follower) - value_of(f, at(leader))); }
};

/// The one degree of freedom that is left, by Runge and Kutta's method in steps that err by rounding:
///   (I_l + f'^2 I_f) x'' = -V_l' - f' V_f' - f' f'' I_f x'^2
std::array<Real, 2> solved(const Polynomial& f, Real x, Real time) {
  const auto rate = [&](const std::array<Real, 2>& s) {
    const Real slope = slope_of(f, s[0]), push_l = kLong.mass * kG * kLong.length / 2 * std::sin(s[0]),
               push_f = kShort.mass * kG * kShort.length / 2 * std::sin(value_of(f, s[0])), i = kShort.about_end();
    return std::array<Real, 2>{s[1], -(push_l + slope * push_f + slope * bend_of(f, s[0]) * i * s[1] * s[1]) /
                                         (kLong.about_end() + slope * slope * i)};
  };
  std::array<Real, 2> s = {x, 0};
  const int steps = 20000;
  const Real h = time / steps;
  const auto add = [](const std::array<Real, 2>& a, Real by, const std::array<Real, 2>& b) {
    return std::array<Real, 2>{a[0] + by * b[0], a[1] + by * b[1]};
  };
  for (int i = 0; i < steps; ++i) {
    const auto k1 = rate(s), k2 = rate(add(s, h / 2, k1)), k3 = rate(add(s, h / 2, k2)), k4 = rate(add(s, h, k3));
    for (std::size_t k = 0; k < 2; ++k) s[k] += h / 6 * (k1[k] + 2 * k2[k] + 2 * k3[k] + k4[k]);
  }
  return s;
}

constexpr Polynomial kQuadratic = {0.2, -0.7, 0.4, 0, 0}, kQuartic = {-0.1, 0.9, 0.3, -0.25, 0.15},
                     kLinear = {0, 2, 0, 0, 0};

}  // namespace

/// By RATTLE at order 6 the two pendulums go as their one degree of freedom does: coordinate and energy to 1e-10.
static void pendulums_on_a_polynomial_keep_to_it(void**) {
  for (const Polynomial& f : {kQuadratic, kQuartic, kLinear}) {
    CoupledPair p(f);
    p.t.world.set_dial(Dial::joint_order, 6);
    p.t.world.set_dial(Dial::substeps, 16);
    const Real before = energy_of(p.t);
    Real energy = 0, off = 0;
    for (int i = 0; i < 60; ++i) {
      p.t.world.step(kDt);
      energy = std::max(energy, std::fabs(energy_of(p.t) - before)), off = std::max(off, p.off());
    }
    const auto truth = solved(f, 0.9, 60 * kDt);
    assert_true(energy < 1e-10);
    assert_true(off < 1e-10);
    assert_true(std::fabs(p.at(p.leader) - truth[0]) < 1e-10);
  }
}

/// Solvers are of second order: half the substep, a quarter of the error, a tenth of leeway.
static void solvers_are_of_second_order(void**) {
  for (const Polynomial& f : {kQuadratic, kQuartic}) {
    const auto truth = solved(f, 0.9, 1);
    for (const int solver : kJointSolvers) {
      Real error[2], off[2];
      for (int k = 0; k < 2; ++k) {
        CoupledPair p(f);
        leave_joints_to_solver(p.t), choose(p.t, solver, 8 << k);
        off[k] = 0;
        for (int i = 0; i < 60; ++i) p.t.world.step(kDt), off[k] = std::max(off[k], p.off());
        error[k] = std::fabs(p.at(p.leader) - truth[0]);
      }
      assert_true(error[1] < error[0] / 3.5 && error[0] < 0.01);
      if (solver >= kDirectChoice)
        assert_true(off[0] < 2e-9 && off[1] < 2e-9);
      else
        assert_true(off[1] < off[0] / 3.5);
    }
  }
}

namespace {

/// A body in free flight that bears two arms, one hanging on by a hinge, the other by a slider: the slide follows the turn.
struct Floating {
  TestWorld t{Vec3(0, 0, 0)};
  std::uint32_t hinge = 0, slider = 0, coupling = 0;
  explicit Floating(const Polynomial& f, bool serial) {
    const std::uint32_t base = add_body(t, Vec3(0, 0, 0), 3, Vec3(0.3, 0.4, 0.5));
    const std::uint32_t arm = add_body(t, Vec3(0.7, 0, 0), 1, Vec3(0.02, 0.06, 0.07));
    hinge = join(t, JointKind::hinge, base, arm, Vec3(0.4, 0, 0), x_along(Vec3(0, 0, 1)));
    const std::uint32_t cart = add_body(t, Vec3(0, 0.6, 0.1), 0.8, Vec3(0.03, 0.02, 0.04));
    slider = join(t, JointKind::slider, serial ? arm : base, cart, Vec3(0, 0.6, 0.1), x_along(Vec3(0.6, 0.8, 0)));
    coupling = couple(t, slider, hinge, f);
    // Velocities on the joints: the arm turns at w, so the cart goes at f' w along its axis, beside what the base does.
    const Vec3 spin(0.3, -0.2, 0.5), v(0.1, 0.2, -0.3);
    const Real w = 1.1;
    const auto carried = [&](const Vec3& at) { return Vec3(v + spin.cross(at)); };
    t.world.set_velocity(base, v, spin);
    const Vec3 turned = spin + Vec3(0, 0, w), pin(0.4, 0, 0);
    t.world.set_velocity(arm, carried(pin) + turned.cross(Vec3(0.7, 0, 0) - pin), turned);
    const Vec3 slides = slope_of(f, 0) * w * Vec3(0.6, 0.8, 0), at(0, 0.6, 0.1);
    if (serial)
      t.world.set_velocity(cart, carried(pin) + turned.cross(at - pin) + slides, turned);
    else
      t.world.set_velocity(cart, carried(at) + slides, spin);
  }
  Vec3 momentum() const {
    Vec3 p = Vec3::zero();
    for (std::uint32_t i = 0; i < 3; ++i) p += t.world.scene.mass[i] * t.world.state.v[i];
    return p;
  }
  Vec3 angular_momentum() const {
    Vec3 l = Vec3::zero();
    for (std::uint32_t i = 0; i < 3; ++i) {
      const State& s = t.world.state;
      l += t.world.scene.mass[i] * s.x[i].cross(s.v[i]) +
           s.q[i] * (t.world.scene.inertia[i] * (s.q[i].conjugate() * s.omega[i]));
    }
    return l;
  }
};
constexpr Polynomial kSlide = {0, 0.3, 0.1, -0.02, 0};

}  // namespace

/// Three bodies in free flight keep energy, momentum and spin, whether the two joints share a body as brothers or in a row.
static void what_floats_keeps_all_that_it_has(void**) {
  for (const bool serial : {false, true}) {
    {
      Floating f(kSlide, serial);
      f.t.world.set_dial(Dial::joint_order, 6), f.t.world.set_dial(Dial::substeps, 8);
      const Real before = energy_of(f.t);
      const Vec3 p = f.momentum(), l = f.angular_momentum();
      f.t.run(60, kDt);
      assert_true(std::fabs(energy_of(f.t) - before) < 1e-10);
      assert_true((f.momentum() - p).norm() < 1e-11 && (f.angular_momentum() - l).norm() < 1e-10);
      assert_true(worst_gap(f.t) < 1e-10);
    }
    for (const int solver : kJointSolvers) {
      Real drift[2];
      for (int k = 0; k < 2; ++k) {
        Floating f(kSlide, serial);
        leave_joints_to_solver(f.t), choose(f.t, solver, 8 << k);
        const Real before = energy_of(f.t);
        const Vec3 p = f.momentum();
        drift[k] = 0;
        for (int i = 0; i < 30; ++i) {
          f.t.world.step(kDt);
          drift[k] = std::max(drift[k], std::fabs(energy_of(f.t) - before));
          assert_true((f.momentum() - p).norm() < 1e-9);
        }
        if (solver >= kDirectChoice) assert_true(worst_gap(f.t) < 3e-9);
      }
      // A tree with a slider that turns freely is of first order under the direct solver, without a coupling as with one.
      assert_true(drift[1] < drift[0] / (solver >= kDirectChoice ? 1.8 : 3.6));
    }
  }
}

/// A weight on a rack turns a wheel, x = r q: a = m g / (m + I / r^2), and the coupling bears m (g - a).
static void a_rack_falls_in_closed_form(void**) {
  constexpr Real kMass = 2, kInertia = 0.3, kRadius = 0.25;
  for (const int solver : kJointSolvers)
    for (const int order : {0, 2}) {
      TestWorld t;
      choose(t, solver), t.world.set_dial(Dial::joint_order, order);
      const std::uint32_t wheel = add_body(t, Vec3(0, 0, 0), 1, Vec3::constant(kInertia));
      const std::uint32_t weight = add_body(t, Vec3(1, 0, 0), kMass, Vec3::constant(0.1));
      const std::uint32_t hinge = join(t, JointKind::hinge, kInvalid, wheel, Vec3(0, 0, 0), x_along(Vec3(0, 0, 1)));
      const std::uint32_t rack = join(t, JointKind::slider, kInvalid, weight, Vec3(1, 0, 0), x_along(Vec3(0, 1, 0)));
      const std::uint32_t coupling = couple(t, rack, hinge, {0, kRadius, 0, 0, 0});
      t.run(60, kDt);
      const Real a = kMass * kG / (kMass + kInertia / (kRadius * kRadius));
      const Real lag =
          solver >= kDirectChoice || order > 0 ? 1e-8 : 0.01;  // softness gives way as the rope of a pulley
      assert_true(std::fabs(t.world.state.v[weight].y() + a) < lag);
      assert_true(std::fabs(joint(t, coupling).torque.x() - kMass * (kG - a)) < 20 * lag);
      assert_true(coordinate(t, hinge, Coordinate::twist) < -3.2);  // more than half a turn: counted
    }
}

/// A motor that holds the leader bears what hangs on the follower, and a limit of the follower stops the leader.
static void drives_and_limits_act_through_it(void**) {
  for (const int solver : kJointSolvers) {
    CoupledPair p({0, 0.5, 0, 0, 0}, 0.8);
    choose(p.t, solver, 8);
    set_motor(p.t, p.leader, Coordinate::twist, 0, 1e3);
    p.t.run(30, kDt);
    assert_true(std::fabs(p.at(p.leader) - 0.8) < 1e-3);
    const Real load = kShort.mass * kG * kShort.length / 2 * std::sin(0.4);
    assert_true(std::fabs(std::fabs(joint(p.t, p.coupling).torque.x()) - load) < 0.01 * load);
    set_motor(p.t, p.leader, Coordinate::twist, 1, 50);
    set_limit(p.t, p.follower, Coordinate::twist, -3, 0.6);
    p.t.run(120, kDt);
    assert_true(std::fabs(p.at(p.leader) - 1.2) < 0.01);
  }
}

/// A hair beside: a term of 1e-15 moves nothing by more than rounding; nor does a coupling to what weighs all but nothing
/// move its leader.
static void a_hair_beside_is_as_good(void**) {
  for (const int order : {0, 6}) {
    CoupledPair a(kQuadratic), b({0.2, -0.7, 0.4, 1e-15, 1e-15});
    for (CoupledPair* const p : {&a, &b}) p->t.world.set_dial(Dial::joint_order, order), p->t.run(60, kDt);
    assert_true(std::fabs(a.at(a.leader) - b.at(b.leader)) < (order ? 1e-12 : 1e-9));
    TestWorld alone, with;
    std::uint32_t hinge = 0, follower = 0, leader = 0;
    hang(alone, kLong, Vec3(3, 0, 0), 0.9, hinge);
    hang(with, {1e-15 * kShort.mass, kShort.length, 1e-15 * kShort.across}, Vec3(0, 0, 0), 0, follower);
    hang(with, kLong, Vec3(3, 0, 0), 0.9, leader);
    couple(with, follower, leader, {0, 1e-15, 0, 0, 0});
    for (TestWorld* const t : {&alone, &with}) t->world.set_dial(Dial::joint_order, order), t->run(60, kDt);
    assert_true(std::fabs(coordinate(alone, hinge, Coordinate::twist) - coordinate(with, leader, Coordinate::twist)) <
                (order ? 1e-10 : 1e-6));
  }
}

/// One that is made while it is off is led back, without more energy than its springs of correction may give.
static void one_that_is_off_is_led_back(void**) {
  for (const int solver : kJointSolvers) {
    CoupledPair p({0.3, 1, 0, 0, 0}, 0);
    choose(p.t, solver, 8);
    p.t.world.set_polynomial(p.coupling, {0.1, 1, 0, 0, 0});
    p.t.run(60, kDt);
    assert_true(p.t.world.state.v[0].norm() < 5);
    assert_true(std::fabs(p.at(p.follower) - p.at(p.leader) - 0.1) < (solver >= kDirectChoice ? 1e-8 : 1e-3));
  }
}

/// Three scenes of other kinds: a train of three couplings, a gripper on an arm that swings, a wheel on a cam.
static void others_keep_their_energy(void**) {
  const auto drift_of = [](auto&& build) {
    TestWorld t;
    t.world.set_dial(Dial::joint_order, 6), t.world.set_dial(Dial::substeps, 16);
    build(t);
    const Real before = energy_of(t);
    Real worst = 0;
    for (int i = 0; i < 60; ++i) t.world.step(kDt), worst = std::max(worst, std::fabs(energy_of(t) - before));
    assert_true(worst_gap(t) < 1e-9);
    return worst;
  };
  assert_true(drift_of([](TestWorld& t) {
                std::uint32_t before = 0, hinge = 0;
                for (int i = 0; i < 4; ++i, before = hinge) {
                  hang(t, kShort, Vec3(i, 0, 0), 0.5 + 0.1 * i, hinge);
                  if (i > 0) couple(t, hinge, before, {0.1, 1, 0, 0, 0});
                }
              }) < 1e-8);
  assert_true(drift_of([](TestWorld& t) {
                std::uint32_t arm = 0, left = 0, right = 0;
                const std::uint32_t hand = hang(t, kLong, Vec3(0, 0, 0), 1.2, arm);
                const Vec3 tip = t.world.state.x[hand] + t.world.state.q[hand] * Vec3(0, -0.4, 0);
                hang(t, kShort, tip, 1.2 + 0.4, left, hand), hang(t, kShort, tip, 1.2 - 0.4, right, hand);
                const Real l = coordinate(t, left, Coordinate::twist), r = coordinate(t, right, Coordinate::twist);
                couple(t, right, left, {r + l, -1, 0, 0, 0});
              }) < 1e-7);
  assert_true(drift_of([](TestWorld& t) {
                std::uint32_t hinge = 0;
                hang(t, kLong, Vec3(0, 0, 0), 1, hinge);
                const std::uint32_t cart = add_body(t, Vec3(2, 0, 0), 0.7, Vec3::constant(0.01));
                const std::uint32_t slider =
                    join(t, JointKind::slider, kInvalid, cart, Vec3(2, 0, 0), x_along(Vec3(0, 1, 0)));
                const Polynomial cam = {0, 0.1, -0.2, 0.05, 0.02};
                couple(t, slider, hinge, {-value_of(cam, 1), cam[1], cam[2], cam[3], cam[4]});
              }) < 1e-8);
}

/// A coupling goes with either of its joints, and the rest goes on.
static void a_coupling_goes_with_its_joints(void**) {
  for (const bool first : {false, true}) {
    CoupledPair p(kQuadratic);
    p.t.run(2, kDt);
    p.t.world.remove_joint(first ? p.follower : p.leader);
    assert_false(p.t.world.joints.alive(p.coupling));
    assert_int_equal(p.t.world.joints.couplings.size(), 0);
    p.t.run(2, kDt);
  }
  CoupledPair p(kQuadratic);
  p.t.world.remove_body(0);  // with it the follower
  assert_int_equal(p.t.world.joints.slots.alive_count(), 1);
  p.t.run(2, kDt);
  CoupledPair q(kQuadratic);
  q.t.world.break_joint(q.follower);
  q.t.run(2, kDt);
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(pendulums_on_a_polynomial_keep_to_it), cmocka_unit_test(solvers_are_of_second_order),
      cmocka_unit_test(what_floats_keeps_all_that_it_has),    cmocka_unit_test(a_rack_falls_in_closed_form),
      cmocka_unit_test(drives_and_limits_act_through_it),     cmocka_unit_test(a_hair_beside_is_as_good),
      cmocka_unit_test(one_that_is_off_is_led_back),          cmocka_unit_test(others_keep_their_energy),
      cmocka_unit_test(a_coupling_goes_with_its_joints),
  };
  return cmocka_run_group_tests_name("oracle/couplings", tests, nullptr, nullptr);
}
