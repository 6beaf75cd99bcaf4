// Rotation methods against closed forms: the free top (Jacobi's elliptic functions), the flip of a plank about its
// middle axis, tops under torque, and what each method promises to keep.
//
// Pose errors are angles between orientations. A method of order p halves h to divide them by 2^p; slopes are read
// where the next term, of relative size (h |omega|)^2 for a symmetric method and h |omega| for others, is small, and
// where rounding is smaller still.
#include "carom_test.h"
#include "dynamics/effects.h"
#include "eigen.h"
#include "fine_top.h"
#include "tools/accuracy/free_top.h"
#include "world_builder.h"

using namespace carom;
using namespace carom::test;
using tools::accuracy::FreeTop;

namespace {

constexpr Real kSemiImplicit = 1, kRk4 = 2, kVerlet = 3;  // integrators
enum Choice { none, explicit_torque, implicit_step, rk4, lie_midpoint, splitting, splitting_4, splitting_6 };
constexpr Choice kCarrying[] = {rk4, lie_midpoint, splitting, splitting_4, splitting_6};
int order(Choice m) { return m == splitting_6 ? 6 : m == rk4 || m == splitting_4 ? 4 : 2; }

Real slope(Real coarse, Real fine) { return std::log2(coarse / fine); }
Real angle(const Quat& a, const Quat& b) { return 2 * (a.conjugate() * b).vec().norm(); }
Real relative(const Vec3& got, const Vec3& want) { return (got - want).norm() / want.norm(); }

/// A box of full sides, alone in the world.
struct Spinning {
  Spinning(const Vec3& sides, const Vec3& omega, Real integrator, Real rotation, const Vec3& gravity = Vec3::zero())
      : t(gravity) {
    t.world.set_dial(Dial::integrator, integrator);
    t.world.set_dial(Dial::rotation, rotation);
    t.world.set_dial(Dial::substeps, 1);  // laws are of the step
    b = t.add(t.keep(box(sides / 2)), Vec3::zero());
    t.world.set_velocity(b, Vec3::zero(), omega);
  }
  const Quat& q() const { return t.world.state.q[b]; }
  const Mat3& inertia() const { return t.world.scene.inertia[b]; }
  Vec3 omega_b() const { return q().conjugate() * t.world.state.omega[b]; }
  Vec3 momentum() const { return q() * (inertia() * omega_b()); }
  Real energy() const { return 0.5 * omega_b().dot(inertia() * omega_b()); }

  TestWorld t;
  std::uint32_t b;
};

struct Errors {
  Real pose, momentum, energy;  // rad, relative, relative
};

Errors fly(const Vec3& sides, const Vec3& omega, Real integrator, Choice method, Real seconds, int steps) {
  Spinning s(sides, omega, integrator, method);
  const Vec3 l0 = s.momentum();
  const Real e0 = s.energy();
  const FreeTop exact(eigen(s.inertia().diagonal()), eigen(omega));
  s.t.run(steps, seconds / steps);
  return {angle(s.q(), plain(exact.orientation(seconds))), relative(s.momentum(), l0), std::fabs(s.energy() / e0 - 1)};
}

const Vec3 kTopSides(1, 2, 3), kTopSpin(4, 1, 2);      // scene 4 of the accuracy suite
const Vec3 kBoxSides(1, 4, 9), kBoxSpin(0.1, 5, 0.1);  // scene 3

}  // namespace

static void the_closed_form_is_what_tiny_runge_kutta_steps_end_at(void**) {
  // Both kinds of motion: L circles the axis of the largest moment, and that of the smallest; spins of all signs.
  const Vec3 cases[] = {kTopSpin, Vec3(-4, 1, 2), Vec3(1, -1, 4), Vec3(1, 2, -6), Vec3(0.01, 5, 0.01)};
  for (const Vec3& w0 : cases) {
    const Vec3 inertia(6500, 5000, 2500);
    const FreeTop top(eigen(inertia), eigen(w0));
    const auto rate = [&](const Vec3& w) { return Vec3(-w.cross(inertia.times(w)).over(inertia)); };
    Vec3 w = w0;
    Quat q = Quat::identity();
    const auto turn = [](const Quat& at, const Vec3& v) { return at * Quat(0, v.x() / 2, v.y() / 2, v.z() / 2); };
    const int n = 20000;
    const Real T = 3, h = T / n;
    for (int i = 0; i < n; ++i) {
      const Vec3 w1 = rate(w), w2 = rate(w + h / 2 * w1), w3 = rate(w + h / 2 * w2), w4 = rate(w + h * w3);
      const Quat q1 = turn(q, w), q2 = turn(q + h / 2 * q1, w + h / 2 * w1), q3 = turn(q + h / 2 * q2, w + h / 2 * w2),
                 q4 = turn(q + h * q3, w + h * w3);
      w += h / 6 * (w1 + 2 * w2 + 2 * w3 + w4);
      q += h / 6 * (q1 + 2 * q2 + 2 * q3 + q4);
    }
    // (h |omega|)^4 |omega| T / 120 of either, and n u of rounding.
    const Real method = std::pow(h * w0.norm(), 4) * w0.norm() * T, rounding = n * kEpsilon;
    assert_true((plain(top.omega(0)) - w0).norm() < 1e-13 * w0.norm());
    assert_true((plain(top.omega(T)) - w).norm() < (method + rounding + 1e-12) * w0.norm());
    assert_true(angle(plain(top.orientation(T)), q) < method + rounding + 1e-11);
  }
}

static void the_suite_s_thrown_box_flies_and_turns_within_its_bounds(void**) {
  // Scene 3: gravity -9.8, v0 (-2, 2, 8), 10 s. omega near the middle axis, so that errors grow with the flips.
  const Vec3 g(0, -9.8, 0), v0(-2, 2, 8);
  for (const Choice m : kCarrying) {
    Errors e[3];
    const int n = m == splitting_6 ? 300 : 1200;  // splitting_6 reaches rounding soon
    for (int k = 0; k < 3; ++k) e[k] = fly(kBoxSides, kBoxSpin, kVerlet, m, 10, n << k);
    // h |omega| is 0.02, or 0.08: squared, and times constants of the composition, well within 0.1.
    for (int k = 0; k + (m == rk4 || order(m) > 3 ? 1 : 0) < 2; ++k)
      assert_true(slope(e[k].pose, e[k + 1].pose) > order(m) - 0.1);
  }
  for (const Choice m : {splitting_4, splitting_6}) {
    Spinning s(kBoxSides, kBoxSpin, kVerlet, m, g);
    s.t.world.set_velocity(s.b, v0, kBoxSpin);
    const Vec3 l0 = s.momentum();
    const Real e0 = s.energy();
    const FreeTop exact(eigen(s.inertia().diagonal()), eigen(kBoxSpin));
    s.t.run(2400, 1.0 / 240);
    assert_true((s.t.world.state.x[s.b] - (v0 * 10 + g * 50)).norm() < 1e-9);
    assert_true((s.t.world.state.v[s.b] - (v0 + g * 10)).norm() < 1e-9);
    assert_true(angle(s.q(), plain(exact.orientation(10))) < 1e-6);
    assert_true(relative(s.momentum(), l0) < 1e-14);
    assert_true(std::fabs(s.energy() / e0 - 1) < 1e-9);
  }
}

static void the_suite_s_top_keeps_momentum_to_1e_14_and_converges_with_the_order_of_each_method(void**) {
  for (const Choice m : kCarrying) {
    Errors e[3];
    const int hertz = m == splitting_6 ? 20 : 60;
    for (int k = 0; k < 3; ++k) {
      e[k] = fly(kTopSides, kTopSpin, kSemiImplicit, m, 60, 60 * (hertz << k));
      assert_true(e[k].momentum < 1e-14);
    }
    for (int k = 0; k < 2; ++k) {
      const Real got = slope(e[k].pose, e[k + 1].pose);
      // Runge-Kutta's energy drifts by h^5, which in a minute turns the body by more than its h^4 does.
      assert_true(got > order(m) - 0.2 && got < order(m) + (m == rk4 ? 1.2 : 0.2));
    }
    // Symplectic methods: energy errs with the order of the pose. Others: no worse.
    assert_true(slope(e[1].energy, e[2].energy) > order(m) - 0.3 || e[2].energy < 1e-13);
  }
  assert_true(fly(kTopSides, kTopSpin, kSemiImplicit, splitting, 60, 3600).pose < 0.005);
  assert_true(fly(kTopSides, kTopSpin, kSemiImplicit, splitting_4, 60, 3600).pose < 1e-6);
  assert_true(fly(kTopSides, kTopSpin, kSemiImplicit, splitting_6, 60, 3600).pose < 1e-8);
}

static void energy_of_the_splittings_errs_by_a_bounded_amount(void**) {
  // The energy that they keep exactly differs from T by a function of the state, of size h^p: its swing in the first
  // ten seconds is its swing in ten minutes.
  for (const Choice m : {splitting, splitting_4}) {
    Spinning s(kTopSides, kTopSpin, kSemiImplicit, m);
    const Real e0 = s.energy();
    Real early = 0, late = 0;
    for (int i = 0; i < 20 * 600; ++i) {
      s.t.world.step(1.0 / 20);
      Real& swing = i < 200 ? early : late;
      swing = std::max(swing, std::fabs(s.energy() / e0 - 1));
    }
    assert_true(early > 0 && late < 1.1 * early + 1e-12);
  }
}

static void a_body_with_two_equal_moments_is_split_without_error(void**) {
  // A rod and a plate, steps of 1/6 s, a turn and more each. q(t) = exp(t L/I_x) exp(t dz L_z e_z): the closed form.
  for (const Vec3& sides : {Vec3(1, 1, 6), Vec3(4, 4, 1), Vec3(6, 1, 1), Vec3(1, 5, 1)}) {
    for (const Choice m : {splitting, splitting_4, splitting_6}) {
      const Vec3 omega(5, 3, 9);
      Spinning s(sides, omega, kSemiImplicit, m);
      const Vec3 moment = s.inertia().diagonal(), l = moment.times(omega);
      int odd = 0;
      for (int k = 1; k < 3; ++k)
        if (std::fabs(sides[k] - sides[(k + 1) % 3]) > 0.5 && std::fabs(sides[k] - sides[(k + 2) % 3]) > 0.5) odd = k;
      const Real same = moment[(odd + 1) % 3];
      Vec3 inner = Vec3::zero();
      inner[odd] = 10 * (1 / moment[odd] - 1 / same) * l[odd];
      s.t.run(60, 1.0 / 6);
      // At most 15 turns a step, 20 u each: products of quaternions, and angles whose rates carry a few u.
      assert_true(angle(s.q(), exp_map(10 / same * l) * exp_map(inner)) < 60 * 15 * 20 * kUnitRoundoff);
    }
  }
}

static void a_plank_flips_when_the_elliptic_period_says(void**) {
  // Scene 5. When the spin about the middle axis passes through zero, five times in 35 s, at 60 Hz.
  const Vec3 omega(0.01, 5, 0.01);
  const FreeTop exact({6500, 5000, 2500}, eigen(omega));
  assert_int_equal(exact.middle(), 1);
  for (const Choice m : {splitting_4, splitting_6}) {
    Spinning s(kTopSides, omega, kSemiImplicit, m);
    int n = 0;
    Real before = omega.y();
    for (int i = 1; i <= 35 * 60; ++i) {
      s.t.world.step(1.0 / 60);
      const Real now = s.omega_b().y();
      if ((now > 0) != (before > 0)) {
        // The chord of a curve whose second derivative vanishes where it crosses: h^3 times the rate cubed, 1e-5 s.
        const Real t = (i - 1 + before / (before - now)) / 60;
        assert_true(std::fabs(t - exact.zero(n++)) < 1e-3);
      }
      before = now;
    }
    assert_int_equal(n, 5);
    assert_true(std::fabs(exact.zero(2) - exact.zero(0) - exact.period()) < 1e-12);
  }
}

static void a_constant_torque_adds_to_momentum_exactly_and_verlet_turns_with_second_order(void**) {
  const Vec3 torque(4000, -2000, 3000), moment(6500, 5000, 2500);
  const Quat exact = fine_top(moment, kTopSpin, 2, 20000, [&](Real, const Quat&) { return torque; });
  for (const Choice m : kCarrying) {
    Real error[2][2];
    for (int k = 0; k < 2; ++k) {
      for (const Real integrator : {kSemiImplicit, kVerlet}) {
        Spinning s(kTopSides, kTopSpin, integrator, m);
        const Vec3 l = s.momentum() + 2 * torque;
        const int n = 200 << k;
        for (int i = 0; i < n; ++i) {
          s.t.world.add_force(s.b, Vec3::zero(), torque);
          s.t.world.step(2.0 / n);
        }
        if (integrator == kVerlet && m >= splitting)
          // The kick is made of omega and at the orientation of its time: 20 u a step.
          assert_true(relative(s.momentum(), l) < n * 20 * kEpsilon);
        error[integrator == kVerlet][k] = angle(s.q(), exact);
      }
    }
    assert_true(std::fabs(slope(error[0][0], error[0][1]) - 1) < 0.1);
    assert_true(std::fabs(slope(error[1][0], error[1][1]) - 2) < 0.1);
  }
}

namespace {

/// m: how far the centre of the suite's heavy top (scene 6) is off after 10 s, n steps. Without a joint: the body
/// stands for the top about its fixed point (moments by the parallel axes), and its host asks for the torque of the
/// weight in mid-step, as far as the axis' present motion tells.
///   Reduced equation, theta from the upward vertical, momenta p_phi and p_psi kept:
///     I theta'' = (p_phi - p_psi c) (p_phi c - p_psi) / (I s^3) + m g l s,   phi' = (p_phi - p_psi c) / (I s^2)
Real heavy_top_error(Choice m, int n) {
  const Real r = 0.5, thick = 0.1, l = 0.5, g = 9.8, spin = 40, mass = 1, T = 10;
  const Real axial = mass * r * r / 2, across = mass * (3 * r * r + thick * thick) / 12 + mass * l * l;
  // Starts level, along x, spinning about its axis alone: p_phi = 0.
  Real theta = M_PI / 2, rate = 0, phi = 0;
  const Real p_psi = axial * spin, p_phi = 0;
  const auto accelerate = [&](Real at) {
    const Real c = std::cos(at), s = std::sin(at);
    return ((p_phi - p_psi * c) * (p_phi * c - p_psi) / (across * s * s * s) + mass * g * l * s) / across;
  };
  const auto precess = [&](Real at) { return (p_phi - p_psi * std::cos(at)) / (across * std::sin(at) * std::sin(at)); };
  const int fine = 100000;
  const Real f = T / fine;
  for (int i = 0; i < fine; ++i) {
    const Real r1 = rate, a1 = accelerate(theta), p1 = precess(theta);
    const Real r2 = rate + f / 2 * a1, a2 = accelerate(theta + f / 2 * r1), p2 = precess(theta + f / 2 * r1);
    const Real r3 = rate + f / 2 * a2, a3 = accelerate(theta + f / 2 * r2), p3 = precess(theta + f / 2 * r2);
    const Real r4 = rate + f * a3, a4 = accelerate(theta + f * r3), p4 = precess(theta + f * r3);
    theta += f / 6 * (r1 + 2 * r2 + 2 * r3 + r4);
    rate += f / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    phi += f / 6 * (p1 + 2 * p2 + 2 * p3 + p4);
  }
  const Vec3 want = l * Vec3(std::sin(theta) * std::cos(phi), std::cos(theta), -std::sin(theta) * std::sin(phi));

  TestWorld t(Vec3::zero());
  t.world.set_dial(Dial::integrator, kVerlet);
  t.world.set_dial(Dial::rotation, m);
  BodyDef def;
  def.has_mass = def.has_inertia = true;
  def.mass = mass;
  def.inertia = Mat3::diagonal(Vec3(axial, across, across));
  def.omega = Vec3(spin, 0, 0);
  const std::uint32_t b = handle_slot(t.world.add_body(def));
  const Real h = T / n;
  for (int i = 0; i < n; ++i) {
    const Vec3 axis = t.world.state.q[b] * Vec3::unit_x();
    const Vec3 ahead = axis + h / 2 * t.world.state.omega[b].cross(axis);
    t.world.add_force(b, Vec3::zero(), (l * ahead).cross(Vec3(0, -mass * g, 0)));
    t.world.step(h);
  }
  return (l * (t.world.state.q[b] * Vec3::unit_x()) - want).norm();
}

}  // namespace

static void a_heavy_top_under_its_host_s_torque_converges_with_second_order(void**) {
  for (const Choice m : {splitting, splitting_6}) {
    // The suite's bound at 240 Hz. Terms of second and third order are of one size until far finer steps.
    const Real coarse = heavy_top_error(m, 2400), fine = heavy_top_error(m, 4800), finest = heavy_top_error(m, 9600);
    assert_true(coarse < 1e-4);
    assert_true(slope(coarse, fine) > 1.9 && slope(fine, finest) > 1.9);
  }
}

static void drag_under_verlet_is_of_second_order_and_free_fall_exact(void**) {
  // Scenes 1 and 2.
  const Vec3 g(0, -9.8, 0), v0(3, 1, 4);
  const auto error = [&](Real integrator, Real c, int n) {
    TestWorld t(g);
    t.world.set_dial(Dial::integrator, integrator);
    BodyDef def;
    def.velocity = v0;
    def.linear_damping = c;
    const std::uint32_t b = handle_slot(t.world.add_body(def));
    t.run(n, 10.0 / n);
    const Vec3 want = c > 0 ? Vec3(g / c * 10 + (v0 - g / c) * ((1 - std::exp(-c * 10)) / c)) : Vec3(v0 * 10 + g * 50);
    return (t.world.state.x[b] - want).norm();
  };
  for (const int n : {300, 600, 2400}) assert_true(error(kVerlet, 0, n) < 500 * n * kEpsilon);  // a sum up to 490 m
  for (const int n : {300, 600})
    assert_true(std::fabs(slope(error(kVerlet, 0.1, n), error(kVerlet, 0.1, 2 * n)) - 2) < 0.05);
  assert_true(error(kVerlet, 0.1, 2400) < 1e-6 * 490 && error(kRk4, 0.1, 2400) < 1e-9);
}

static void round_bodies_are_nobody_s_participants(void**) {
  for (const Choice m : kCarrying) {
    TestWorld t(Vec3::zero());
    t.world.set_dial(Dial::rotation, m);
    const std::uint32_t ball = t.add(t.keep(sphere(0.5)), Vec3::zero());
    const std::uint32_t die = t.add(t.keep(box(Vec3::constant(0.5))), Vec3(5, 0, 0));
    for (const std::uint32_t b : {ball, die}) t.world.set_velocity(b, Vec3::zero(), Vec3(1, 2, 3));
    t.run(60, 1.0 / 60);
    assert_int_equal(t.world.plan->find("gyroscopic")->evaluations, 0);
    for (const std::uint32_t b : {ball, die}) {
      assert_true(t.world.state.omega[b] == Vec3(1, 2, 3));
      assert_true(angle(t.world.state.q[b], exp_map(Vec3(1, 2, 3))) < 60 * 8 * kEpsilon);
    }
  }
}

static void a_skew_inertia_spins_as_its_principal_axes_do(void**) {
  // The same top, described in axes turned by some rotation.
  const Quat frame = exp_map(Vec3(0.3, -1.1, 0.7));
  for (const Choice m : kCarrying) {
    Quat end[2];
    for (const bool skew : {false, true}) {
      TestWorld t(Vec3::zero());
      t.world.set_dial(Dial::rotation, m);
      BodyDef def;
      def.has_mass = def.has_inertia = true;
      def.mass = 6000;
      const Mat3 r = frame.matrix(), diagonal = Mat3::diagonal(Vec3(6500, 5000, 2500));
      def.inertia = skew ? Mat3(r * diagonal * r.transpose()) : diagonal;
      def.inertia = Mat3(0.5 * (def.inertia + def.inertia.transpose()));
      def.pose.q = skew ? frame.conjugate() : Quat::identity();
      def.omega = kTopSpin;
      const std::uint32_t b = handle_slot(t.world.add_body(def));
      t.run(240, 1.0 / 60);
      end[skew] = t.world.state.q[b];
      if (skew) end[skew] = end[skew] * frame;
    }
    assert_true(angle(end[0], end[1]) < 240 * 100 * kEpsilon);
  }
}

static void a_touched_body_that_nothing_pushes_turns_like_a_free_one(void**) {
  // A contact that gives no impulse must not change the motion. exp(h omega) from the old orientation would: it adds
  // 2 % to this top's energy in a second.
  for (const Choice m : kCarrying) {
    Spinning free(kTopSides, kTopSpin, kSemiImplicit, m), touched(kTopSides, kTopSpin, kSemiImplicit, m);
    free.t.run(60, 1.0 / 60);
    touched.t.world.step(1.0 / 60);
    touched.t.world.plan->touched[touched.b] = 1;  // nobody takes it back: without colliders, no solver runs
    touched.t.run(59, 1.0 / 60);
    // The predicted pose is normalised once more in each step.
    assert_true(angle(free.q(), touched.q()) < 60 * 4 * kEpsilon);
    assert_true(relative(touched.momentum(), free.momentum()) < 60 * 8 * kEpsilon);
  }
}

static void a_plank_that_tumbles_on_ice_gains_no_energy(void**) {
  // Touched bodies: contacts without friction and bounce only take energy, and a rotation method, symplectic or not,
  // lets it swing by (h |omega|)^2 = 0.04 of the spin. Growth would show in ten seconds as a multiple of that.
  for (const Choice m : kCarrying) {
    TestWorld t;
    t.world.set_dial(Dial::rotation, m);
    const std::uint32_t ice = t.material(0, 0);
    t.ground(ice);
    const std::uint32_t b =
        t.add(t.keep(box(Vec3(0.5, 0.1, 1))), Vec3(0, 0.6, 0), BodyType::dynamic, exp_map(Vec3(0.4, 0, 0.3)), ice);
    t.world.set_velocity(b, Vec3::zero(), Vec3(0, 12, 4));
    Real first = 0, most = 0;
    std::uint64_t touching = 0;
    for (int i = 0; i < 600; ++i) {
      t.world.step(1.0 / 60);
      const Real e = t.world.report.linear_energy + t.world.report.angular_energy +
                     t.world.scene.mass[b] * 9.81 * t.world.state.x[b].y();
      if (i == 0) first = e;
      most = std::max(most, e / first);
      touching += t.world.report.contact_points > 0;
    }
    assert_true(most < 1.04 && touching > 300);
  }
}

static void absurd_spins_stay_finite(void**) {
  for (const Choice m : kCarrying) {
    for (const Real w : {1e-200, 1e-9, 1e3, 1e6, 9e8}) {
      for (const Vec3& sides : {Vec3(1e-3, 1, 1.1), Vec3(1e3, 1, 1e-3)}) {
        Spinning s(sides, w * Vec3(0.6, 0.5, -0.6), kVerlet, m);
        s.t.run(100, 1.0 / 60);
        assert_true(finite(s.t.world.state.omega[s.b]) && std::fabs(s.q().norm() - 1) < 8 * kEpsilon);
      }
    }
  }
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(the_closed_form_is_what_tiny_runge_kutta_steps_end_at),
      cmocka_unit_test(the_suite_s_thrown_box_flies_and_turns_within_its_bounds),
      cmocka_unit_test(the_suite_s_top_keeps_momentum_to_1e_14_and_converges_with_the_order_of_each_method),
      cmocka_unit_test(energy_of_the_splittings_errs_by_a_bounded_amount),
      cmocka_unit_test(a_body_with_two_equal_moments_is_split_without_error),
      cmocka_unit_test(a_plank_flips_when_the_elliptic_period_says),
      cmocka_unit_test(a_constant_torque_adds_to_momentum_exactly_and_verlet_turns_with_second_order),
      cmocka_unit_test(a_heavy_top_under_its_host_s_torque_converges_with_second_order),
      cmocka_unit_test(drag_under_verlet_is_of_second_order_and_free_fall_exact),
      cmocka_unit_test(round_bodies_are_nobody_s_participants),
      cmocka_unit_test(a_skew_inertia_spins_as_its_principal_axes_do),
      cmocka_unit_test(a_touched_body_that_nothing_pushes_turns_like_a_free_one),
      cmocka_unit_test(a_plank_that_tumbles_on_ice_gains_no_energy),
      cmocka_unit_test(absurd_spins_stay_finite),
  };
  return cmocka_run_group_tests_name("oracle/rotation", tests, nullptr, nullptr);
}
