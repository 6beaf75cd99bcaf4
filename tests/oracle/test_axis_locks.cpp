// Bodies that do not move along, or turn about, some world axes: against closed forms, against the same scene in which
// nothing would move there anyway, and a flat world that stands.
#include <array>
#include <numbers>

#include "carom_test.h"
#include "dynamics/contact/contact.h"
#include "dynamics/contact_views.h"
#include "dynamics/force/force.h"
#include "joint_scenes.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr Locks kX = 1, kZ = 4, kAboutX = 8, kAboutY = 16, kAboutZ = 32, kPlane = kZ | kAboutX | kAboutY;
constexpr std::array kSolvers = {kSoftChoice, kDirectChoice, kAutoChoice};
constexpr int kIntegrators = 4;

void exact(TestWorld& t, int solver) {
  choose(t, solver);
  t.world.set_dial(Dial::velocity_tolerance, 1e-9);
  t.world.set_dial(Dial::velocity_iterations, 50);
}

/// A half-space that rises by `angle` towards +x.
std::uint32_t slope(TestWorld& t, Real angle, std::uint32_t material) {
  const std::uint32_t ground = t.ground(material);
  t.world.set_pose(ground, {exp_map(Vec3(0, 0, angle)), Vec3::zero()});
  return ground;
}

Real pressed(const World& world) {
  Real sum = 0;
  for (const ContactView& view : world.contact_views()) sum += view.normal_impulse;
  return sum;
}

bool stays_flat(const World& world, std::uint32_t body, Real z) {
  const State& s = world.state;
  return s.x[body].z() == z && s.v[body].z() == 0 && s.q[body].x() == 0 && s.q[body].y() == 0 &&
         s.omega[body].x() == 0 && s.omega[body].y() == 0;
}

/// A body 1 x 2 x 3 m askew, so that its inertia has no zero in world axes.
std::uint32_t askew(TestWorld& t) {
  return t.add(t.keep(box(Vec3(0.5, 1, 1.5))), Vec3(0.1, 0.2, 0.3), BodyType::dynamic, exp_map(Vec3(0.5, -0.3, 0.8)));
}
Mat3 inertia_of(const World& world, std::uint32_t body) {
  const Mat3 r = world.state.q[body].matrix();
  return r * world.scene.inertia[body] * r.transpose();
}

}  // namespace

static void what_flies_keeps_what_is_locked_to_the_bit_and_the_rest_as_it_was(void**) {
  for (int integrator = 0; integrator < kIntegrators; ++integrator) {
    TestWorld t(Vec3(1, -9.81, 2));
    t.world.set_dial(Dial::integrator, integrator);
    BodyDef def;
    def.velocity = Vec3(3, 4, 5);
    def.linear_damping = 0.3;
    const std::uint32_t free = handle_slot(t.world.add_body(def)), held = handle_slot(t.world.add_body(def));
    t.world.set_attribute(held, AttributeId::locks, {Real(kX)});
    for (int i = 0; i < 100; ++i) {
      t.world.add_force(held, Vec3(1, 2, 3), Vec3::zero()), t.world.add_force(free, Vec3(1, 2, 3), Vec3::zero());
      t.world.step(1.0 / 60);
      const State& s = t.world.state;
      assert_true(s.x[held].x() == 0 && s.v[held].x() == 0);
      const auto yz = [](const Vec3& v) { return Vec2(v.y(), v.z()); };
      assert_true(yz(s.x[held]) == yz(s.x[free]) && yz(s.v[held]) == yz(s.v[free]));
    }
  }
}

// About one axis a body has one moment of inertia: what its tensor in world axes says in that corner.
static void a_torque_turns_about_what_is_free(void**) {
  for (int integrator = 0; integrator < kIntegrators; ++integrator) {
    TestWorld t(Vec3::zero());
    t.world.set_dial(Dial::integrator, integrator);
    const std::uint32_t body = askew(t);
    t.world.set_attribute(body, AttributeId::locks, {Real(kAboutX | kAboutY)});
    const Vec3 torque(300, -200, 500);
    const Real alpha = torque.z() / inertia_of(t.world, body)(2, 2), dt = 1.0 / 120;
    const Quat q0 = t.world.state.q[body];
    constexpr int kSteps = 120;
    for (int i = 0; i < kSteps; ++i) t.world.add_force(body, Vec3::zero(), torque), t.world.step(dt);
    const State& s = t.world.state;
    assert_true(s.omega[body].x() == 0 && s.omega[body].y() == 0);
    assert_true(std::fabs(s.omega[body].z() - alpha) < 1e-12 * alpha);
    const Quat turn = s.q[body] * q0.conjugate();
    const Real sine = turn.z(), want = sin_cos(alpha / 4).sin;  // of half of it
    // It has turned by alpha t^2 / 2, give or take half a step of it (nothing for rk4 and velocity_verlet).
    assert_true(std::fabs(turn.x()) < 1e-13 && std::fabs(turn.y()) < 1e-13);
    assert_true(std::fabs(sine - want) < (integrator < 2 ? alpha * dt / 2 : 1e-9));
  }
}

/// Free about two axes: no torque acts about them, so momentum about them stays, and no work is done, so energy does.
static void what_turns_about_two_axes_keeps_energy_and_their_momentum(void**) {
  struct Left {
    Real energy, momentum;
  };
  const auto left = [](int integrator, int n) {
    TestWorld t(Vec3::zero());
    t.world.set_dial(Dial::integrator, integrator);
    const std::uint32_t body = askew(t);
    t.world.set_attribute(body, AttributeId::locks, {Real(kAboutY)});
    t.world.set_velocity(body, Vec3::zero(), Vec3(1, 5, -2));
    const auto momentum = [&] { return Vec3(inertia_of(t.world, body) * t.world.state.omega[body]); };
    const auto energy = [&] { return momentum().dot(t.world.state.omega[body]) / 2; };
    const Vec3 l0 = momentum();
    const Real e0 = energy();
    for (int i = 0; i < n; ++i) {
      t.world.step(2.0 / n);
      assert_true(t.world.state.omega[body].y() == 0);
    }
    const Vec3 l = momentum() - l0;
    return Left{std::fabs(energy() / e0 - 1), std::hypot(l.x(), l.z()) / l0.norm()};
  };
  for (int integrator = 0; integrator < kIntegrators; ++integrator) {
    const Left coarse = left(integrator, 240), fine = left(integrator, 480);
    print_message("integrator %d: energy %.2e, %.2e; momentum %.2e, %.2e\n", integrator, coarse.energy, fine.energy,
                  coarse.momentum, fine.momentum);
    // Of first order; where the body turns by the spin that the midpoint rule found, energy is kept to its sweeps.
    assert_true(fine.momentum < 0.6 * coarse.momentum && coarse.momentum < 0.1);
    assert_true(coarse.energy < (integrator == 1 ? 1e-9 : 0.1));
  }
}

static void what_is_not_free_to_tumble_has_no_gyroscopic_term(void**) {
  TestWorld t(Vec3::zero());
  const std::uint32_t held = askew(t), free = askew(t);
  t.world.set_pose(free, {Quat::identity(), Vec3(10, 0, 0)});
  t.world.set_attribute(held, AttributeId::locks, {Real(kAboutY)});
  for (const std::uint32_t b : {held, free}) t.world.set_velocity(b, Vec3::zero(), Vec3(1, 2, 3));
  t.run(10, 1.0 / 60);
  assert_int_equal(t.world.plan->find("gyroscopic")->participants.count, 1);
  assert_int_equal(t.world.plan->find("axis_locks")->participants.count, 1);
}

// Held upright, it is borne by the upward part of what presses on it: N cos = m g. The rest of N the lock bears.
static void a_box_on_a_slope_that_cannot_slide_presses_as_it_must(void**) {
  for (const int solver : kSolvers)
    for (const Real angle : {0.2, 0.6, 1.0})
      for (const Real mu : {0.0, 0.5}) {
        TestWorld t(Vec3(0, -kG, 0));
        exact(t, solver);
        const std::uint32_t m = t.material(mu, 0);
        slope(t, angle, m);
        const SinCos sc = sin_cos(angle);
        const std::uint32_t body = t.add(t.keep(box(Vec3::constant(0.5))), 0.5 * Vec3(-sc.sin, sc.cos, 0),
                                         BodyType::dynamic, exp_map(Vec3(0, 0, angle)), m);
        t.world.set_attribute(body, AttributeId::locks, {Real(kX | kPlane)});
        const Vec3 x0 = t.world.state.x[body];
        t.run(120, 1.0 / 60);
        const Real weight = t.world.scene.mass[body] * kG / 60, want = weight / sc.cos;
        Real up = 0;  // friction bears a part of the weight where there is any
        for (std::uint32_t i = 0; i < t.world.contacts->rows.size(); ++i) {
          const Row& row = t.world.contacts->rows[i];
          up += (row.b == body ? 1 : -1) * t.world.contacts->geometry[i].impulse.y();
        }
        print_message("solver %d, slope %.1f, mu %.1f: pressed %.6f, up %.8f of the weight, sank %.1e\n", solver, angle,
                      mu, pressed(t.world) / want, up / weight, x0.y() - t.world.state.x[body].y());
        assert_true(t.world.state.x[body].x() == x0.x() && t.world.state.x[body].z() == 0);
        assert_true(std::fabs(up - weight) < 1e-5 * weight);
        if (mu == 0) assert_true(std::fabs(pressed(t.world) - want) < 1e-5 * want);
      }
}

/// Along a vertical line, off a slope without loss: it goes back up as fast as it came.
static void a_ball_in_a_pipe_bounces_off_a_slope_to_its_height(void**) {
  for (const int solver : kSolvers) {
    TestWorld t(Vec3(0, -kG, 0));
    choose(t, solver, 1);
    const std::uint32_t m = t.material(0, 1);
    slope(t, 0.5, m);
    const Real high = 0.1 / sin_cos(0.5).cos, dt = 1.0 / 240;
    const std::uint32_t ball = t.add(t.keep(sphere(0.1)), Vec3(0, high + 1, 0), BodyType::dynamic, Quat::identity(), m);
    t.world.set_attribute(ball, AttributeId::locks, {Real(kX | kZ)});
    Real top = 0;
    bool bounced = false;
    for (int i = 0; i < 240; ++i) {
      t.world.step(dt);
      bounced |= t.world.state.v[ball].y() > 0;
      if (bounced) top = std::max(top, t.world.state.x[ball].y() - high);
    }
    // As of a ball that falls on level ground: @see test_contact_laws; and what an impact gives way beyond its locks.
    assert_true(bounced && std::fabs(top - 1) < kG * dt * dt / 8 + 1e-6);
    assert_true(t.world.state.x[ball].x() == 0);
  }
}

/// m and rad: how far two worlds are from each other after half a second, that differ in locks alone which hold what
/// would not move without them.
static void a_scene_that_is_flat_by_itself_does_not_feel_its_locks(void**) {
  for (const int solver : kSolvers)
    for (const Real mu : {0.0, 0.6}) {
      std::array<std::array<Vec3, 3>, 2> x;
      std::array<std::array<Quat, 3>, 2> q;
      for (std::size_t locked = 0; locked < 2; ++locked) {
        TestWorld t(Vec3(0, -kG, 0));
        exact(t, solver);
        // A body without locks that tips on its edge would move by its equation of motion, far nearer to the truth than
        // the solver that is asked here. What resists rolling on a line does not, however little. @see lone_rollers.h
        Material resists;
        resists.friction = mu, resists.rolling = 1e-14;
        const std::uint32_t m = handle_slot(t.world.add_material(resists));
        t.ground(m);
        const Shape* cube = t.keep(box(Vec3::constant(0.5)));
        const std::uint32_t tumbles = t.add(cube, Vec3(0, 0.9, 0), BodyType::dynamic, exp_map(Vec3(0, 0, 0.3)), m);
        const std::uint32_t slides = t.add(cube, Vec3(3, 0.5, 0), BodyType::dynamic, Quat::identity(), m);
        const std::uint32_t rolls =
            t.add(t.keep(sphere(0.4)), Vec3(-3, 0.4, 0), BodyType::dynamic, Quat::identity(), m);
        t.world.set_velocity(slides, Vec3(2, 0, 0), Vec3::zero());
        t.world.set_velocity(rolls, Vec3(-2, 0, 0), Vec3::zero());
        for (const std::uint32_t body : {tumbles, slides, rolls})
          if (locked) t.world.set_attribute(body, AttributeId::locks, {Real(kPlane)});
        t.run(30, 1.0 / 60);
        std::size_t i = 0;
        for (const std::uint32_t body : {tumbles, slides, rolls}) {
          x[locked][i] = t.world.state.x[body], q[locked][i++] = t.world.state.q[body];
          if (locked) assert_true(stays_flat(t.world, body, 0));
        }
      }
      for (std::size_t i = 0; i < 3; ++i) {
        const Real apart = (x[0][i] - x[1][i]).norm() + 2 * (q[0][i] * q[1][i].conjugate()).vec().norm();
        print_message("solver %d, mu %.1f, body %zu: %.1e apart\n", solver, mu, i, apart);
        // Points at z and -z are two of one kind once nothing turns about x: the direct solver finds the same motion to
        // its tolerance, sweeps share loads otherwise on the way, within what a spring sinks: g / (2 w)^2 = 0.07 mm,
        // twice.
        assert_true(apart < (solver == kDirectChoice ? 1e-9 : 2e-4));
      }
    }
}

static void a_flat_pyramid_stands_and_stays_flat(void**) {
  constexpr int kBase = 8;
  for (const int solver : kSolvers) {
    TestWorld t(Vec3(0, -kG, 0));
    choose(t, solver);
    t.ground();
    const Shape* cube = t.keep(box(Vec3::constant(0.5)));
    std::vector<std::uint32_t> bodies;
    std::vector<Vec3> start;
    for (int i = 0; i < kBase; ++i)
      for (int k = 0; k < kBase - i; ++k) {
        start.push_back(Vec3(k + 0.5 * i, 0.5 + i, 0.125));
        bodies.push_back(t.add(cube, start.back()));
        t.world.set_attribute(bodies.back(), AttributeId::locks, {Real(kPlane)});
      }
    t.run(600, 1.0 / 60);
    Real strayed = 0;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      assert_true(stays_flat(t.world, bodies[i], 0.125));
      strayed = std::max(strayed, std::fabs(t.world.state.x[bodies[i]].x() - start[i].x()));
    }
    print_message("solver %d: strayed %.2e m, %.1e J left\n", solver, strayed,
                  t.world.report.linear_energy + t.world.report.angular_energy);
    assert_true(strayed < 1e-3);
    assert_int_equal(t.world.plan->find("axis_locks")->participants.count, bodies.size());
  }
}

/// A weight that slides up and down a wall, on a rod that leans: the rod bears m g / cos along itself.
static void a_rod_that_leans_bears_its_share(void**) {
  for (const int solver : kSolvers) {
    TestWorld t(Vec3(0, -kG, 0));
    exact(t, solver);
    const std::uint32_t weight = add_body(t, Vec3(0.6, -0.8, 0), 2, Vec3::constant(0.1));
    t.world.set_attribute(weight, AttributeId::locks, {Real(kX | kZ | kAboutX | kAboutY | kAboutZ)});
    JointDef def = joint_at(t, JointKind::distance, kInvalid, weight, Vec3::zero());
    def.frame_b = Pose{};
    def.length = 1;
    const std::uint32_t rod = handle_slot(t.world.add_joint(def));
    t.run(240, 1.0 / 60);
    const Vec3 want = 2 * kG / 0.8 * Vec3(-0.6, 0.8, 0);
    const Vec3& x = t.world.state.x[weight];
    print_message("solver %d: %.2e of the force, %.2e m\n", solver, (joint(t, rod).force - want).norm() / want.norm(),
                  x.y() + 0.8);
    assert_true((joint(t, rod).force - want).norm() < 1e-4 * want.norm());
    assert_true(x.x() == 0.6 && x.z() == 0 && std::fabs(x.y() + 0.8) < 1e-3);
  }
}

/// Two links on hinges about z, with and without locks that hold what the hinges hold anyway.
static void a_flat_double_pendulum_does_not_feel_its_locks(void**) {
  for (const int solver : kSolvers)
    for (const JointKind kind : {JointKind::hinge, JointKind::ball}) {
      std::array<Vec3, 2> end;
      for (std::size_t locked = 0; locked < 2; ++locked) {
        TestWorld t(Vec3(0, -kG, 0));
        exact(t, solver);
        leave_joints_to_solver(t);                                        // as those with locks are
        const Quat along_z = exp_map(Vec3(0, -std::numbers::pi / 2, 0));  // joints turn about their x axes
        const std::uint32_t one = add_body(t, Vec3(0.5, 0, 0), 1, Vec3(0.01, 0.1, 0.1)),
                            two = add_body(t, Vec3(1.5, 0, 0), 1, Vec3(0.01, 0.1, 0.1));
        join(t, kind, kInvalid, one, Vec3::zero(), along_z);
        join(t, kind, one, two, Vec3(1, 0, 0), along_z);
        for (const std::uint32_t body : {one, two})
          if (locked) t.world.set_attribute(body, AttributeId::locks, {Real(kPlane)});
        t.run(60, 1.0 / 60);
        end[locked] = t.world.state.x[two];
        if (locked) assert_true(stays_flat(t.world, two, 0) && stays_flat(t.world, one, 0));
      }
      print_message("solver %d: %.1e m apart\n", solver, (end[0] - end[1]).norm());
      assert_true((end[0] - end[1]).norm() < 1e-6);
    }
}

/// Pendulums that turn about all axes, beside others that are locked or not: joints of both share lanes.
static void who_is_locked_is_nothing_to_its_neighbours(void**) {
  for (const int solver : kSolvers) {
    std::array<std::uint64_t, 2> unlike{};
    std::array<Vec3, 2> x;
    std::array<Quat, 2> q;
    for (std::size_t locked = 0; locked < 2; ++locked) {
      TestWorld t(Vec3(0, -kG, 0));
      choose(t, solver);
      std::uint32_t bodies[3];
      for (int i = 0; i < 3; ++i) {
        bodies[i] = add_body(t, Vec3(0.5, 0, 3 * i), 1, Vec3(0.02, 0.1, 0.05));
        join(t, JointKind::ball, kInvalid, bodies[i], Vec3(0, 0, 3 * i));
        t.world.set_velocity(bodies[i], Vec3::zero(), Vec3(1, 2, 0.5));
      }
      if (locked)
        t.world.set_attribute(bodies[1], AttributeId::locks, {Real(kPlane)}),
            t.world.set_attribute(bodies[2], AttributeId::locks, {Real(kAboutY)});
      t.run(60, 1.0 / 60);
      x[locked] = t.world.state.x[bodies[0]], q[locked] = t.world.state.q[bodies[0]];
      unlike[locked] = t.world.hash();
    }
    assert_true(x[0] == x[1] && q[0] == q[1] && unlike[0] != unlike[1]);
  }
}

static void what_is_locked_altogether_stands_like_a_rock(void**) {
  for (const int solver : kSolvers) {
    std::array<Vec3, 2> x;
    for (std::size_t locked = 0; locked < 2; ++locked) {
      TestWorld t(Vec3(0, -kG, 0));
      choose(t, solver);
      const Shape* cube = t.keep(box(Vec3::constant(0.5)));
      const std::uint32_t rock = t.add(cube, Vec3(0, 5, 0), locked ? BodyType::dynamic : BodyType::fixed);
      if (locked) t.world.set_attribute(rock, AttributeId::locks, {Real(kAllLocks)});
      const std::uint32_t falls = t.add(cube, Vec3(0.1, 6.3, 0.1));
      t.run(240, 1.0 / 60);  // to rest: on the way a corner's gap of 3e-16 m decides when a soft contact lets it sink
      x[locked] = t.world.state.x[falls];
      assert_true(t.world.state.x[rock] == Vec3(0, 5, 0) && t.world.state.v[rock] == Vec3::zero());
    }
    assert_true((x[0] - x[1]).norm() < 1e-12);
  }
}

/// The disc of a flat world rolls out as a ball does: resistance bears what it can about the one axis that is free.
static void rolling_resistance_stops_a_ball_that_is_locked_to_a_plane(void**) {
  for (const int solver : kSolvers) {
    std::array<Real, 2> way;
    for (std::size_t locked = 0; locked < 2; ++locked) {
      TestWorld t(Vec3(0, -kG, 0));
      exact(t, solver);
      Material rough;
      rough.rolling = 0.02, rough.spinning = 0.01;
      const std::uint32_t m = handle_slot(t.world.add_material(rough));
      t.ground(m);
      const std::uint32_t ball = t.add(t.keep(sphere(0.5)), Vec3(0, 0.5, 0), BodyType::dynamic, Quat::identity(), m);
      if (locked) t.world.set_attribute(ball, AttributeId::locks, {Real(kPlane)});
      t.world.set_velocity(ball, Vec3(1, 0, 0), Vec3(0, 0, -2));
      t.run(360, 1.0 / 60);
      assert_true(t.world.state.v[ball].norm() < 1e-3);
      way[locked] = t.world.state.x[ball].x();
    }
    print_message("solver %d: %.6f m, %.1e apart\n", solver, way[0], way[1] - way[0]);
    assert_true(way[0] > 1 && std::fabs(way[1] - way[0]) < 1e-5);
  }
}

/// Nothing can give way where it is pushed: a wheel on a fixed axle, with a piston coming at it, sideways and onto it.
static void what_cannot_give_way_stays_finite(void**) {
  for (const int solver : kSolvers)
    for (const Real bounce : {0.0, 0.9}) {
      TestWorld t(Vec3(0, -kG, 0));
      choose(t, solver);
      const std::uint32_t m = t.material(0.5, bounce);
      const std::uint32_t wheel = t.add(t.keep(sphere(0.5)), Vec3(0, 0, 0), BodyType::dynamic, Quat::identity(), m);
      t.world.set_attribute(wheel, AttributeId::locks, {Real(kLinearLocks | kAboutX | kAboutY)});
      const std::uint32_t lift =
          t.add(t.keep(box(Vec3(1, 0.1, 1))), Vec3(0, -0.7, 0), BodyType::kinematic, Quat::identity(), m);
      t.world.set_velocity(lift, Vec3(0.5, 0.2, 0.3), Vec3::zero());
      t.add(t.keep(box(Vec3(0.2, 0.2, 0.2))), Vec3(0.05, 0.9, 0.02), BodyType::dynamic, Quat::identity(), m);
      t.run(120, 1.0 / 60);
      assert_true(t.world.state.x[wheel] == Vec3::zero() && t.world.state.v[wheel] == Vec3::zero());
      assert_true(std::fabs(t.world.state.omega[wheel].z()) < 20);
      assert_int_equal(t.world.report.quarantined_bodies, 0);
    }
}

static void a_world_without_locks_keeps_no_list_of_them(void**) {
  for (const int solver : kSolvers) {
    TestWorld t;
    choose(t, solver);
    t.ground();
    t.add(t.keep(box(Vec3::constant(0.5))), Vec3(0, 0.6, 0));
    t.run(30, 1.0 / 60);
    const PlannedEffect* row = t.world.plan->find("axis_locks");
    assert_true(row->evaluations == 0 && row->participants.count == 0);
    assert_true(t.world.scene.locks.capacity() == 0 && t.world.wide->in_double.locks.capacity() == 0 &&
                t.world.wide_joints->locks.capacity() == 0);
  }
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(what_flies_keeps_what_is_locked_to_the_bit_and_the_rest_as_it_was),
      cmocka_unit_test(a_torque_turns_about_what_is_free),
      cmocka_unit_test(what_turns_about_two_axes_keeps_energy_and_their_momentum),
      cmocka_unit_test(what_is_not_free_to_tumble_has_no_gyroscopic_term),
      cmocka_unit_test(a_box_on_a_slope_that_cannot_slide_presses_as_it_must),
      cmocka_unit_test(a_ball_in_a_pipe_bounces_off_a_slope_to_its_height),
      cmocka_unit_test(a_scene_that_is_flat_by_itself_does_not_feel_its_locks),
      cmocka_unit_test(a_flat_pyramid_stands_and_stays_flat),
      cmocka_unit_test(a_rod_that_leans_bears_its_share),
      cmocka_unit_test(a_flat_double_pendulum_does_not_feel_its_locks),
      cmocka_unit_test(who_is_locked_is_nothing_to_its_neighbours),
      cmocka_unit_test(what_is_locked_altogether_stands_like_a_rock),
      cmocka_unit_test(rolling_resistance_stops_a_ball_that_is_locked_to_a_plane),
      cmocka_unit_test(what_cannot_give_way_stays_finite),
      cmocka_unit_test(a_world_without_locks_keeps_no_list_of_them),
  };
  return cmocka_run_group_tests_name("oracle/axis_locks", tests, nullptr, nullptr);
}
