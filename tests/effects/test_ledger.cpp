// The ledger: causes that have a closed form, and books that close in every step whatever happens in it.
#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "carom_test.h"
#include "core/trig.h"
#include "dynamics/ledger/ledger.h"
#include "joint_scenes.h"
#include "world_builder.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr Real kStep = 1.0 / 64;
enum : int { kExplicitChoice, kSemiImplicitChoice, kRungeKuttaChoice, kVerletChoice, kIntegratorChoices };

const Vec3 kDown(0, -9.81, 0);

Amount total(const TestWorld& t, Cause cause) { return t.world.ledger->since[index_of(cause)].value(); }
Amount total(const TestWorld& t, std::string_view row) {
  for (std::size_t c = kFixedCauses; c < kCauses; ++c)
    if (const char* const name = cause_name(c); name && name == row) return t.world.ledger->since[c].value();
  print_error("no cause %s\n", std::string(row).c_str());
  assert_true(false);
  return {};
}

/// How far a sum of causes is from the change that it should be, over the rounding that it may have.
Real gap(const std::array<Account, kCauses>& causes, const Amount& change, const Rounding& rounding) {
  Account sum;
  for (const Account& cause : causes) sum.add(cause.value());
  const Amount off = sum.value() - change;
  const auto over = [](Real error, Real bound) { return error == 0 ? 0 : error / bound; };
  return std::max({over(std::fabs(off.energy()), rounding.energy), over(off.linear.norm(), rounding.linear),
                   over(off.angular.norm(), rounding.angular)});
}

/// The books of the last step close, and those of all steps.
void assert_closes(const TestWorld& t, const char* where = "") {
  const Ledger& l = *t.world.ledger;
  const Real step = gap(l.step, l.now - l.before, l.step_rounding),
             since = gap(l.since, l.now - l.start, l.since_rounding);
  if (step <= 1 && since <= 1) return;
  print_error("%s step %llu: off by %g of what rounding may leave in the step, %g in all\n", where,
              static_cast<unsigned long long>(l.steps), step, since);
  assert_true(false);
}

void run(TestWorld& t, int steps, Real dt = kStep, const char* where = "") {
  for (int i = 0; i < steps; ++i) t.world.step(dt), assert_closes(t, where);
}

}  // namespace

static void gravity_gives_its_impulse_and_the_integrator_its_error(void**) {
  constexpr int kSteps = 64;
  const Real m = 2, h = kStep, time = kSteps * h;
  const Vec3 x0(3, 4, 5), v0(1, 2, -3);
  for (int integrator = 0; integrator < kIntegratorChoices; ++integrator) {
    TestWorld t;
    t.world.set_dial(Dial::integrator, integrator);
    t.world.set_dial(Dial::substeps, 1);  // laws are of the step
    const std::uint32_t ball = add_body(t, x0, m, Vec3::constant(0.1));
    t.world.set_velocity(ball, v0, Vec3(0, 3, 0));
    t.world.keep_ledger(true);
    run(t, kSteps);
    const Ledger& l = *t.world.ledger;
    const Amount by_gravity = total(t, "gravity"), by_method = total(t, Cause::integrator);
    const Rounding& u = l.since_rounding;
    assert_true((by_gravity.linear - m * time * kDown).norm() <= u.linear);
    assert_true(by_gravity.energy() == 0);
    assert_true(std::fabs(by_gravity.kinetic - m * kDown.dot(t.world.state.x[ball] - x0)) <= u.energy);
    // Euler's way is longer or shorter by h^2/2 g in every step: explicit by a kick too few, semi-implicit one too
    // many.
    const Real per_step = m * h * h / 2 * kDown.squared_norm();
    const Real error = integrator == kExplicitChoice ? per_step : integrator == kSemiImplicitChoice ? -per_step : 0;
    assert_true(std::fabs(by_method.energy() - kSteps * error) <= u.energy);
    assert_true(by_method.linear.norm() <= u.linear);
    // The integral of x x m g over a parabola; what Euler's method makes of it, h^2/2 v x m g a step, see ledger.h.
    const Vec3 exact = (time * x0 + (time * time / 2) * v0).cross(m * kDown);
    if (integrator >= kRungeKuttaChoice) {
      assert_true((by_gravity.angular - exact).norm() <= u.angular);
      assert_true(by_method.angular.norm() <= u.angular);
    } else {
      const Real once = h * time / 2 * m * v0.cross(kDown).norm();
      assert_true((by_gravity.angular + by_method.angular - exact).norm() <= once + u.angular);
      assert_true((by_gravity.angular + by_method.angular - exact).norm() >= once - u.angular);
    }
    assert_true(u.energy < 1e-9 && u.linear < 1e-9 && u.angular < 1e-9);  // of 200 J: the bounds say something
  }
}

static void damping_alone_takes_what_it_takes(void**) {
  for (int integrator = 0; integrator < kIntegratorChoices; ++integrator) {
    TestWorld t(Vec3::zero());
    t.world.set_dial(Dial::integrator, integrator);
    BodyDef def;
    def.has_mass = def.has_inertia = true;
    def.mass = 3, def.inertia = Mat3::identity();
    def.velocity = Vec3(4, 0, 0), def.omega = Vec3(0, 0, 2);
    def.linear_damping = 50, def.angular_damping = 0.25;  // the first too stiff for RK4 as a force
    t.world.add_body(def);
    t.world.keep_ledger(true);
    run(t, 64);
    // Exact as flows; RK4 takes both as forces only if both are slow: then (c h)^5 / 120 a step.
    const Amount linear = total(t, "linear_damping"), angular = total(t, "angular_damping");
    const Real slow = 0.25, step_error = std::pow(slow * kStep, 5) / 120 * 64;
    assert_true(std::fabs(linear.kinetic + 24 * (1 - std::exp(-100.0))) <= 1e-12);
    assert_true(std::fabs(linear.linear[0] + 12 * (1 - std::exp(-50.0))) <= 1e-12);
    assert_true(std::fabs(angular.kinetic + 2 * (1 - std::exp(-2 * slow))) <= 4 * step_error + 1e-12);
    assert_true(std::fabs(angular.angular[2] + 2 * (1 - std::exp(-slow))) <= 2 * step_error + 1e-12);
    const Rounding& u = t.world.ledger->since_rounding;
    // x and v stay parallel, and nothing else acts
    assert_true(std::fabs(total(t, Cause::integrator).energy()) <= u.energy);
    assert_true(total(t, Cause::integrator).angular.norm() <= u.angular);
  }
}

static void a_hosts_force_is_its_own_cause_and_what_it_does_between_steps_is_hosts(void**) {
  TestWorld t(Vec3::zero());
  t.world.set_dial(Dial::integrator, kVerletChoice);
  const std::uint32_t body = add_body(t, Vec3(1, 0, 0), 2, Vec3::constant(0.5));
  t.world.keep_ledger(true);
  t.world.add_force(body, Vec3(0, 6, 0), Vec3(0, 0, 4));
  run(t, 1);
  const Rounding& u = t.world.ledger->since_rounding;
  assert_true((total(t, "user_force").linear - Vec3(0, 6 * kStep, 0)).norm() <= u.linear);
  assert_true((total(t, "user_force").angular - Vec3(0, 0, 6 * kStep)).norm() <= u.angular);
  assert_true((total(t, "user_torque").angular - Vec3(0, 0, 4 * kStep)).norm() <= u.angular);
  assert_true(std::fabs(total(t, "user_force").kinetic - std::pow(6 * kStep, 2) / 4) <= u.energy);
  assert_true(std::fabs(total(t, "user_torque").kinetic - std::pow(4 * kStep, 2)) <= u.energy);
  assert_true(total(t, Cause::host).linear == Vec3::zero());

  t.world.set_velocity(body, Vec3::zero(), Vec3::zero());
  t.world.set_pose(body, {Quat::identity(), Vec3::zero()});
  t.world.add_impulse(body, Vec3(8, 0, 0), Vec3(0, 1, 0));
  run(t, 1);
  const Amount before = t.world.ledger->before, by_host = t.world.ledger->step[index_of(Cause::host)].value();
  assert_true((by_host.linear + before.linear - Vec3(8, 0, 0)).norm() <= u.linear);
  assert_true((by_host.angular + before.angular - Vec3(0, 0, -8)).norm() <= u.angular);
  assert_true(std::fabs(by_host.kinetic + before.kinetic - (16 + 64)) <= u.energy);

  t.world.set_gravity(kDown);  // lifts what is above the origin in potential
  const std::uint32_t other = add_body(t, Vec3(0, 10, 0), 1, Vec3::constant(1));
  run(t, 1);
  assert_true(std::fabs(t.world.ledger->step[index_of(Cause::host)].value().potential - 98.1) <= u.energy);
  t.world.remove_body(other), t.world.remove_body(body);
  run(t, 2);
  assert_true(t.world.ledger->now.kinetic == 0 && t.world.ledger->now.linear == Vec3::zero());
}

static void a_sliding_block_pays_by_friction(void**) {
  const Real mu = 0.4, v0 = 2, m = 1000 * 0.8 * 0.4 * 0.6, g = 9.81;
  for (int solver = 0; solver < kSolverChoices; ++solver) {
    TestWorld t(kDown);
    choose(t, solver, solver == kSeverityChoice ? 1 : 4);
    const std::uint32_t material = t.material(mu, 0);
    t.ground(material);
    const std::uint32_t block =
        t.add(t.keep(box(Vec3(0.4, 0.2, 0.3))), Vec3(0, 0.2, 0), BodyType::dynamic, Quat::identity(), material);
    t.run(30, kStep);  // it settles
    const Real from = t.world.state.x[block][0];
    t.world.set_velocity(block, Vec3(v0, 0, 0), Vec3::zero());
    t.world.keep_ledger(true);
    run(t, 80);
    const Real way = t.world.state.x[block][0] - from;
    const Amount friction = total(t, Cause::friction);
    // All of the momentum and of the energy: within a substep the mean of the velocities times the time is the way,
    // but for half a kick of friction at a time, over which the way is sum h v' and not sum h (v + v')/2.
    const Real h = kStep / (solver == kSeverityChoice ? 1 : 4), late = mu * m * g * h * v0 / 2;
    assert_true(t.world.state.v[block].norm() < 1e-3);
    assert_true(std::fabs(friction.linear[0] + m * v0) < 1e-3 * m * v0);
    assert_true(std::fabs(friction.kinetic + m * v0 * v0 / 2) < 2e-3 * m * v0 * v0);
    assert_true(std::fabs(friction.kinetic + mu * m * g * way) < late + 2e-3 * m * v0 * v0);
    assert_true(std::fabs(total(t, Cause::contact).kinetic) < 2e-3 * m * v0 * v0);
    assert_true(std::fabs(total(t, Cause::unassigned).kinetic) < 1e-4 * m * v0 * v0);
  }
}

static void a_bounce_loses_what_restitution_says(void**) {
  const Real e = 0.8, r = 0.25, fall = 1.5;
  for (int solver = 0; solver < kSolverChoices; ++solver) {
    TestWorld t(kDown);
    choose(t, solver, solver == kSeverityChoice ? 1 : 4);
    t.world.set_dial(Dial::integrator, kVerletChoice);
    const std::uint32_t material = t.material(0.3, e);
    t.ground(material);
    const std::uint32_t ball =
        t.add(t.keep(sphere(r)), Vec3(1, r + fall, 0), BodyType::dynamic, Quat::identity(), material);
    const Real m = t.world.scene.mass[ball];
    t.world.keep_ledger(true);
    run(t, 45);  // it lands after 0.553 s, and once more 0.885 s later
    const Amount bounce = total(t, Cause::restitution);
    const Real had = m * 9.81 * fall;  // 1/2 m v^2
    assert_true(std::fabs(bounce.energy() + (1 - e * e) * had) < 1e-9 * had);
    assert_true((bounce.linear - Vec3(0, (1 + e) * std::sqrt(2 * m * had), 0)).norm() < 1e-9 * m);
    assert_true(std::fabs(total(t, Cause::integrator).energy()) < 1e-9 * had);
    for (const Cause none : {Cause::contact, Cause::friction, Cause::unassigned, Cause::correction})
      assert_true(std::fabs(total(t, none).energy()) < 1e-9 * had);
  }
}

/// What joint, integrator and remainder did to a pendulum of a brick that swings for a second from the horizontal: J.
static Amount swing(Real dt, int solver, Amount* rest) {
  TestWorld t(kDown);
  choose(t, solver, 1), leave_joints_to_solver(t);
  t.world.set_dial(Dial::integrator, kVerletChoice);
  const std::uint32_t bob = add_body(t, Vec3(1, 0, 0), 2, Vec3(0.1, 0.2, 0.15));
  join(t, JointKind::ball, kInvalid, bob, Vec3::zero());
  t.world.keep_ledger(true);
  run(t, static_cast<int>(std::lround(1 / dt)), dt, "pendulum");
  *rest = total(t, Cause::integrator) + total(t, Cause::unassigned) + total(t, Cause::correction);
  return total(t, Cause::joints);
}

static void a_pendulums_joint_does_no_work(void**) {
  for (const int solver : {kSoftChoice, kDirectChoice, kAutoChoice}) {
    Amount rest;
    const Real coarse = std::fabs(swing(1.0 / 128, solver, &rest).kinetic), coarse_rest = std::fabs(rest.energy());
    const Real fine = std::fabs(swing(1.0 / 256, solver, &rest).kinetic), fine_rest = std::fabs(rest.energy());
    // Of 19.62 J that go to and fro: what the chord of a step, h |omega| / 2 off the tangent, leaves of them squared;
    // and at least by half with each halving.
    const Real turn = 6 / (2 * 128.0);  // rad: 6 rad/s at the lowest point
    assert_true(coarse < turn * turn * 19.62 && coarse_rest < turn * turn * 19.62);
    assert_true(fine < 0.55 * coarse && fine_rest < 0.55 * coarse_rest);
  }
}

static void a_free_top_keeps_its_momentum_by_the_integrator(void**) {
  enum { kNone, kExplicit, kImplicit, kFirstMethod, kMethods = 8 };
  for (int method = kFirstMethod; method < kMethods; ++method) {
    TestWorld t(Vec3::zero());
    t.world.set_dial(Dial::integrator, kVerletChoice);
    t.world.set_dial(Dial::rotation, method);
    const std::uint32_t top = add_body(t, Vec3(0.5, 0, 0), 1, Vec3(0.2, 0.3, 0.45));
    t.world.set_velocity(top, Vec3::zero(), Vec3(0.1, 8, 0.2));
    t.world.keep_ledger(true);
    run(t, 256);
    const Amount a = total(t, Cause::integrator);
    assert_true(a.angular.norm() <= t.world.ledger->since_rounding.angular);
    assert_true(t.world.ledger->since_rounding.angular < 1e-9);
    // and what the method makes of the energy is there, to the last joule
    assert_true(std::fabs(a.energy() - (t.world.ledger->now - t.world.ledger->start).energy()) <=
                t.world.ledger->since_rounding.energy);
  }
}

namespace {

struct Melee {
  TestWorld t;
  std::uint32_t pusher = 0, bullet = 0;
  std::vector<std::uint32_t> heap;

  /// All that moves: boxes and balls that bounce, roll and slide into each other, a chain with a motor, a spring and a
  /// limit, a pusher that moves by itself, a swept bullet, a belt, particles; locked ones where the solver knows them.
  Melee(int solver, int integrator, int rotation, bool sleep = false) : t(kDown) {
    const bool knows_all = solver != kSeverityChoice;
    choose(t, solver, knows_all ? 4 : 1);
    t.world.set_dial(Dial::integrator, integrator);
    t.world.set_dial(Dial::rotation, rotation);
    t.world.set_dial(Dial::sleep, sleep);
    Material rough;
    rough.rolling = 0.01, rough.spinning = 0.02;
    const std::uint32_t dull = t.material(0.6, 0), bouncy = t.material(0.4, 0.7),
                        soft = handle_slot(t.world.add_material(rough));
    t.ground(soft);
    const Shape *brick = t.keep(box(Vec3(0.3, 0.2, 0.4))), *ball = t.keep(sphere(0.3)),
                *pill = t.keep(capsule(0.2, 0.3));
    for (int i = 0; i < 15; ++i)
      heap.push_back(t.add(i % 3 == 0   ? ball
                           : i % 3 == 1 ? brick
                                        : pill,
                           Vec3(0.2 * (i % 4), 0.5 + 0.7 * i, 0.1 * (i % 5)), BodyType::dynamic,
                           Quat(1, 0.1 * i, 0.2, 0.05 * i).normalized(),
                           i % 4 == 0   ? bouncy
                           : i % 4 == 1 ? soft
                                        : dull));
    t.world.scene.def[heap[2]].linear_damping = 0.3;
    t.world.scene.def[heap[3]].angular_damping = 0.3;
    t.world.set_attribute(heap[4], AttributeId::gravity_factor, {0.5});
    pusher = t.add(brick, Vec3(-3, 0.3, 0), BodyType::kinematic, Quat::identity(), dull);
    t.world.set_velocity(pusher, Vec3(1, 0, 0), Vec3(0, 0.3, 0));
    bullet = t.add(t.keep(sphere(0.05)), Vec3(-20, 1, 0.1), BodyType::dynamic, Quat::identity(), bouncy);
    t.world.set_velocity(bullet, Vec3(90, 4, 0), Vec3::zero());
    ParticleDef sparks;
    sparks.linear_damping = 0.5, sparks.mass = 0.1;
    const std::uint32_t set = handle_slot(t.world.particles.create(sparks, 3));
    t.world.particles.extend(set, 3);
    for (std::size_t i = 0; i < 3; ++i) {
      t.world.particles.place(set, i, Vec3(1, 2, static_cast<Real>(i)));
      t.world.particles.set_velocity(set, i, Vec3(static_cast<Real>(i), 3, 1));
    }
    if (!knows_all) return;
    std::uint32_t above = kInvalid;
    for (int i = 0; i < 4; ++i) {
      const std::uint32_t link = t.add(brick, Vec3(4 + 0.8 * i, 4, 0));
      const JointKind kinds[] = {JointKind::ball, JointKind::hinge, JointKind::slider, JointKind::hinge};
      const std::uint32_t j = join(t, kinds[i], above, link, Vec3(3.6 + 0.8 * i, 4, 0));
      if (i == 1) set_motor(t, j, Coordinate::twist, 2, 40);
      if (i == 2) set_spring(t, j, Coordinate::slide, 0.1, 2, 0.2), set_limit(t, j, Coordinate::slide, -0.2, 0.3);
      above = link;
    }
    t.world.set_attribute(heap[6], AttributeId::locks, {Real(4 | 8 | 16)});  // flat
    t.world.set_attribute(heap[7], AttributeId::locks, {Real(1 | 8)});       // turns about two axes
    SurfaceVelocity belt;
    belt.linear = Vec3(0.5, 0, 0);
    t.world.set_surface_velocity(t.world.scene.first_collider[heap[0]], belt);
  }

  void disturb(int step) {
    if (step == 20) t.world.add_impulse(heap[1], Vec3(50, 100, 0), Vec3(0, 1, 0));
    if (step == 30) t.world.set_pose(heap[5], {Quat::identity(), Vec3(-1, 6, 0)});
    if (step == 40) t.world.add_force(heap[8], Vec3(0, 3000, 0), Vec3(10, 0, 0));
    if (step == 50) t.world.remove_body(heap[9]);
    if (step == 55) heap[9] = t.add(t.keep(box(Vec3(0.1, 0.2, 0.1))), Vec3(0.3, 8, 0.1));
    if (step == 60) t.world.set_gravity(Vec3(1, -9, 0));
  }
};

}  // namespace

static void the_books_close_whatever_happens(void**) {
  for (int solver = 0; solver < kSolverChoices; ++solver)
    for (int integrator = 0; integrator < kIntegratorChoices; ++integrator) {
      Melee melee(solver, integrator, integrator == kRungeKuttaChoice ? 1 : (solver + 2 * integrator) % 8);
      melee.t.world.keep_ledger(true);
      const std::string where = "solver " + std::to_string(solver) + ", integrator " + std::to_string(integrator);
      for (int i = 0; i < 90; ++i) melee.disturb(i), run(melee.t, 1, kStep, where.c_str());
      const Ledger& l = *melee.t.world.ledger;
      // The bounds are of rounding: far below what goes on.
      assert_true(l.since_rounding.energy < 1e-7 * std::fabs(total(melee.t, "gravity").kinetic));
      assert_true(l.since_rounding.linear < 1e-7 * total(melee.t, "gravity").linear.norm());
      assert_true(total(melee.t, Cause::contact).kinetic < 0 && total(melee.t, Cause::restitution).energy() < 0);
      assert_true(total(melee.t, Cause::friction).linear.norm() > 0 && total(melee.t, Cause::host).kinetic != 0);
      assert_true(total(melee.t, "linear_damping").kinetic < 0 && total(melee.t, "angular_damping").kinetic < 0);
      assert_true(total(melee.t, Cause::resistance).kinetic != 0);
      if (solver != kSeverityChoice) {
        assert_true(total(melee.t, Cause::joints).linear.norm() > 0 && total(melee.t, Cause::drives).kinetic != 0);
        assert_true(total(melee.t, Cause::axis_locks).linear.norm() > 0);
      }
      // What is nobody's: nothing where arms and inertias are those of the moment; else inertias are as old as a step,
      // in which the quickest here (10 rad/s) turn by 0.16 rad, of a tenth of the energy.
      const Real known = std::fabs(total(melee.t, Cause::contact).kinetic);
      const Real nobodys = std::fabs(total(melee.t, Cause::unassigned).kinetic);
      assert_true(solver == kSeverityChoice ? nobodys <= l.since_rounding.energy : nobodys < 0.016 * known);
      assert_true(total(melee.t, Cause::unassigned).linear.norm() <= l.since_rounding.linear);
    }
}

static void sleepers_stay_in_the_books(void**) {
  Melee melee(kSoftChoice, kVerletChoice, 6, true);
  melee.t.world.remove_body(melee.pusher);
  melee.t.world.set_surface_velocity(melee.t.world.scene.first_collider[melee.heap[0]], {});
  melee.t.world.keep_ledger(true);
  std::uint64_t most = 0;
  for (int i = 0; i < 900; ++i) {
    run(melee.t, 1, kStep, "sleep");
    most = std::max(most, melee.t.world.report.asleep_bodies);
  }
  assert_true(most >= 5);
  const Amount slept = total(melee.t, Cause::sleep);
  assert_true(slept.kinetic < 0 && slept.potential == 0);
  // Who lies has potential and nothing else; and is woken by who hits it.
  melee.t.world.add_impulse(melee.heap[1], Vec3(0, 900, 0), Vec3::zero());
  for (int i = 0; i < 200; ++i) run(melee.t, 1, kStep, "woken");
}

static void who_leaves_the_world_leaves_no_hole_in_the_books(void**) {
  for (int solver = 0; solver < kSolverChoices; ++solver) {
    Melee melee(solver, kVerletChoice, 6);
    melee.t.world.keep_ledger(true);
    run(melee.t, 10);
    melee.t.world.add_force(melee.heap[3], Vec3(0, 1e300, 0), Vec3::zero());
    melee.t.world.set_velocity(melee.heap[14], Vec3(kInfinity, 0, 0), Vec3::zero());
    melee.t.world.particles.set_velocity(0, 1, Vec3(1e12, 0, 0));
    for (int i = 0; i < 20; ++i) run(melee.t, 1, kStep, "quarantine");
    assert_true(melee.t.world.state.quarantined_count == 2);
    const Amount now = melee.t.world.ledger->now;
    assert_true(carom::finite(now.energy()) && carom::finite(now.linear) && carom::finite(now.angular));
  }
}

/// A heavy ball meets a light one head-on, both nearly as fast as bodies may be: what comes back is faster.
static void whom_a_hit_drives_out_of_the_world_is_booked_as_lost(void**) {
  for (int solver = 0; solver < kSolverChoices; ++solver)
    for (const Real restitution : {0., 1.}) {
      TestWorld t(Vec3::zero());
      choose(t, solver, 1);
      const std::uint32_t m = t.material(0.5, restitution);
      const std::uint32_t heavy = t.add(t.keep(sphere(1)), Vec3(-1.06, 0, 0), BodyType::dynamic, Quat::identity(), m);
      const std::uint32_t light = t.add(t.keep(sphere(0.02)), Vec3(0, 0, 0), BodyType::dynamic, Quat::identity(), m);
      t.world.set_continuous(light, SweepMode::never), t.world.set_continuous(heavy, SweepMode::never);
      t.world.set_velocity(heavy, Vec3(0.8e9, 0, 0), Vec3::zero());
      t.world.set_velocity(light, Vec3(-0.8e9, 0, 0), Vec3::zero());
      t.world.keep_ledger(true);
      run(t, 20, 1e-11, "driven out");
      assert_true((t.world.state.quarantined_count > 0) == (restitution > 0));
      assert_true((total(t, Cause::quarantine).kinetic < 0) == (restitution > 0));
    }
}

static void a_world_goes_on_the_same_with_a_ledger_and_without(void**) {
  for (int solver = 0; solver < kSolverChoices; ++solver) {
    Melee with(solver, kVerletChoice, 6, true), without(solver, kVerletChoice, 6, true);
    for (int i = 0; i < 120; ++i) {
      if (i % 40 == 10) with.t.world.keep_ledger(true);
      if (i % 40 == 35) with.t.world.keep_ledger(false);
      with.disturb(i), without.disturb(i);
      with.t.world.step(kStep), without.t.world.step(kStep);
      assert_true(with.t.world.hash() == without.t.world.hash());
    }
  }
}

static void only_a_world_that_asked_keeps_a_ledger(void**) {
  Melee melee(kSoftChoice, kVerletChoice, 6);
  melee.t.run(3, kStep);
  const PlannedEffect& row = *melee.t.world.plan->find("ledger");
  assert_true(!melee.t.world.ledger && row.participants.count == 0 && row.evaluations == 0);
  melee.t.world.keep_ledger(true);
  melee.t.run(2, kStep);
  const std::uint64_t movers = melee.t.world.plan->linear.count + melee.t.world.plan->rotating.count;
  assert_true(movers == 20 && row.participants.count == movers && row.evaluations == 2 * movers);
  melee.t.world.keep_ledger(false);
  melee.t.run(2, kStep);
  assert_true(!melee.t.world.ledger && row.participants.count == 0 && row.evaluations == 2 * movers);
}

static void drag_fields_springs_and_water_are_causes_of_their_own(void**) {
  for (int integrator = 0; integrator < kIntegratorChoices; ++integrator) {
    TestWorld t(kDown);
    t.world.set_dial(Dial::integrator, integrator);
    const Shape* crate = t.keep(box(Vec3(0.3, 0.4, 0.5)));
    std::vector<std::uint32_t> bodies;
    for (int i = 0; i < 6; ++i) bodies.push_back(t.add(crate, Vec3(3 * i, 0.5 * i - 1, 0)));
    t.world.set_velocity(bodies[0], Vec3(1, 2, 3), Vec3(3, 2, 1));
    t.world.set_attribute(bodies[5], AttributeId::drag, {20, 30});
    t.world.set_wind(Vec3(5, 0, 1));
    FieldDef vortex;
    vortex.kind = FieldKind::vortex;
    vortex.strength = 3, vortex.pull = 1, vortex.core = 1, vortex.falloff = 1;
    t.world.add_field(vortex);
    for (int i = 0; i < 3; ++i) {
      SpringDef s;
      s.body_a = bodies[i], s.body_b = bodies[i + 1], s.anchor_a = Vec3(0.3, 0.1, 0), s.rest = 2;
      s.stiffness = 500, s.damping = 20;
      t.world.add_spring(s);
    }
    WaterDef water;
    water.drag = 2, water.current = Vec3(0, 0, 1);
    t.world.set_water(&water);
    t.world.set_body_mode(bodies[4], +EffectId::gravity, EffectMode::forbid);
    t.world.keep_ledger(true);
    run(t, 200, kStep, "forces");
    const Rounding& u = t.world.ledger->since_rounding;
    // Springs between bodies give no momentum, and all of these have done something.
    assert_true(total(t, "springs").linear.norm() <= u.linear);
    for (const char* name : {"springs", "drag", "fields", "buoyancy"}) assert_true(total(t, name).kinetic != 0);
    assert_true((total(t, "gravity").linear - 5 * t.world.scene.mass[bodies[0]] * 200 * kStep * kDown).norm() <=
                u.linear);
    assert_true(total(t, Cause::host).linear == Vec3::zero());
    if (integrator == kVerletChoice) {
      // What the steps of a method of second order leave is small beside what forces did.
      Real done = 0;
      for (const char* name : {"springs", "drag", "fields", "buoyancy"}) done += std::fabs(total(t, name).kinetic);
      assert_true(std::fabs(total(t, Cause::integrator).energy()) < 0.02 * done);
    }
    t.world.set_mode(+EffectId::gravity, EffectMode::forbid);  // the potential goes with it, by the host's hand
    run(t, 20, kStep, "without gravity");
    assert_true(t.world.ledger->now.potential == 0);
  }
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(gravity_gives_its_impulse_and_the_integrator_its_error),
      cmocka_unit_test(damping_alone_takes_what_it_takes),
      cmocka_unit_test(a_hosts_force_is_its_own_cause_and_what_it_does_between_steps_is_hosts),
      cmocka_unit_test(a_sliding_block_pays_by_friction),
      cmocka_unit_test(a_bounce_loses_what_restitution_says),
      cmocka_unit_test(a_pendulums_joint_does_no_work),
      cmocka_unit_test(a_free_top_keeps_its_momentum_by_the_integrator),
      cmocka_unit_test(the_books_close_whatever_happens),
      cmocka_unit_test(sleepers_stay_in_the_books),
      cmocka_unit_test(who_leaves_the_world_leaves_no_hole_in_the_books),
      cmocka_unit_test(whom_a_hit_drives_out_of_the_world_is_booked_as_lost),
      cmocka_unit_test(a_world_goes_on_the_same_with_a_ledger_and_without),
      cmocka_unit_test(only_a_world_that_asked_keeps_a_ledger),
      cmocka_unit_test(drag_fields_springs_and_water_are_causes_of_their_own),
  };
  return cmocka_run_group_tests_name("effects/ledger", tests, nullptr, nullptr);
}
