// Fast bodies against closed forms: nothing passes through, impacts happen where and when they must, at any phase of
// the step; and what merely passes by is left alone.
#include <functional>
#include <numbers>

#include "carom_test.h"
#include "collision/narrow/query.h"
#include "dynamics/ccd/continuous.h"
#include "dynamics/query/index.h"
#include "world_builder.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr Real kDt = 1.0 / 60;
constexpr int kPhases = 16;

Real energy(const World& w) { return w.report.linear_energy + w.report.angular_energy; }

/// About the origin.
Vec3 angular_momentum(const World& w) {
  Vec3 l = Vec3::zero();
  for (std::uint32_t i = 0; i < w.scene.bodies.slots(); ++i) {
    const Mat3 r = w.state.q[i].matrix();
    l += w.scene.mass[i] * w.state.x[i].cross(w.state.v[i]) +
         r * (w.scene.inertia[i] * (r.transpose() * w.state.omega[i]));
  }
  return l;
}

/// m: distance of two bodies of one collider each, negative in overlap.
Real gap(const World& w, std::uint32_t a, std::uint32_t b) {
  const std::uint32_t ca = w.scene.first_collider[a], cb = w.scene.first_collider[b];
  QueryResult result;
  SupportFault fault;
  QuerySettings settings;
  settings.tolerance = 1e-10;
  distance(*w.scene.colliders.shape[ca], *w.scene.colliders.shape[cb],
           relative(collider_frame(w, ca), collider_frame(w, cb)), settings, nullptr, result, fault);
  return result.separation;
}

/// A wall square to x and something that flies at it along x, from `phase` of a step's way behind 2 m away.
struct Range : TestWorld {
  Range(Shape projectile, Real along_x, Real half_thickness, Real restitution, int phase,
        BodyType wall_type = BodyType::fixed)
      : TestWorld(Vec3::zero()), speed(along_x) {
    const std::uint32_t m = material(0, restitution);
    wall = add(keep(box(Vec3(half_thickness, 5, 5))), Vec3::zero(), wall_type, Quat::identity(), m);
    front = -half_thickness - support_point(projectile, Vec3::unit_x()).x();
    start = front - 2 - speed * kDt * phase / kPhases;
    bullet = add(keep(std::move(projectile)), Vec3(start, 0, 0), BodyType::dynamic, Quat::identity(), m);
    world.set_velocity(bullet, Vec3(speed, 0, 0), Vec3::zero());
  }
  /// A step after the one in which it arrives.
  int steps() const { return static_cast<int>(std::ceil((front - start) / speed / kDt)) + 1; }
  Real x() const { return world.state.x[bullet].x(); }

  Real speed, front, start;
  std::uint32_t wall, bullet;
};

const std::function<Shape()> kProjectiles[] = {[] { return sphere(0.1); }, [] { return box(Vec3(0.1, 0.1, 0.1)); },
                                               [] { return box(Vec3(0.0005, 0.1, 0.1)); },
                                               [] { return capsule(0.05, 0.2); }, [] { return cylinder(0.1, 0.1); }};

}  // namespace

// In one dimension, whatever the phase: at e = 1 it is where its mirror image would be, at e = 0 it lies at the wall.
static void impacts_are_where_and_when_they_must_be(void**) {
  for (const auto& make : kProjectiles)
    for (const Real speed : {50.0, 100.0, 200.0, 400.0, 1000.0})
      for (const Real half : {0.05, 0.0005})
        for (const Real e : {0.0, 0.5, 1.0})
          for (int phase = 0; phase < kPhases; ++phase) {
            Range r(make(), speed, half, e, phase);
            const int n = r.steps();
            r.run(n, kDt);
            const Real time = n * kDt - (r.front - r.start) / speed;  // s, since the impact
            // The narrow phase's bracket, 1e-6 of the shape, tilts normals of what is not round by as much.
            assert_true(std::fabs(r.x() - (r.front - e * speed * time)) < 1e-9 * speed);
            assert_true(r.x() < r.front + 1e-9);
            assert_true(std::fabs(r.world.state.v[r.bullet].x() + e * speed) < 1e-9 * speed);
          }
}

// A wall that can move: momentum and angular momentum to rounding, speeds of the closed form.
static void a_wall_that_moves_takes_its_share(void**) {
  for (const Real e : {0.0, 0.5, 1.0})
    for (int phase = 0; phase < kPhases; ++phase) {
      Range r(sphere(0.1), 200, 0.05, e, phase, BodyType::dynamic);
      const Real m = r.world.scene.mass[r.bullet], heavy = r.world.scene.mass[r.wall];
      const Vec3 p = m * Vec3(200, 0, 0);
      r.run(r.steps(), kDt);
      const Real together = m * 200 / (m + heavy);
      assert_true((momentum(r.world) - p).norm() < 1e-12 * p.norm());
      assert_true(angular_momentum(r.world).norm() < 1e-9 * p.norm());
      assert_true(std::fabs(r.world.state.v[r.wall].x() - together * (1 + e)) < 1e-9 * 200);
      assert_true(gap(r.world, r.bullet, r.wall) > -1e-9);
    }
}

// Off centre and askew, a plank that spins: momentum, angular momentum about the origin, and energy at e = 1.
static void momentum_is_kept_off_centre(void**) {
  for (const Real e : {0.3, 1.0})
    for (int phase = 0; phase < kPhases; ++phase) {
      TestWorld t(Vec3::zero());
      const std::uint32_t m = t.material(0.4, e);
      const std::uint32_t plank =
          t.add(t.keep(box(Vec3(0.02, 1, 0.3))), Vec3::zero(), BodyType::dynamic, Quat::identity(), m);
      const std::uint32_t bullet = t.add(t.keep(sphere(0.1)), Vec3(-2 - 200 * kDt * phase / kPhases, 0.7, 0.1),
                                         BodyType::dynamic, Quat::identity(), m);
      t.world.set_velocity(bullet, Vec3(200, 0, 0), Vec3(3, 4, 5));
      const Vec3 p = momentum(t.world), l = angular_momentum(t.world);
      Real before = 0;
      for (int i = 0; i < 4; ++i) {
        t.world.step(kDt);
        if (i == 0 && t.world.report.sweep_hits == 0) before = energy(t.world);
      }
      assert_true(t.world.state.v[plank].norm() > 1);
      assert_true((momentum(t.world) - p).norm() < 1e-12 * p.norm());
      assert_true((angular_momentum(t.world) - l).norm() < 1e-11 * l.norm());
      if (before > 0) assert_true(energy(t.world) < before * (1 + 1e-9));
    }
}

// Up and down between floor and a thrown height, at any step: energy to rounding.
static void gravity_and_bounces_keep_energy(void**) {
  for (const Real dt : {1.0 / 30, 1.0 / 60, 1.0 / 240}) {
    TestWorld t;
    const std::uint32_t m = t.material(0, 1);
    t.add(t.keep(box(Vec3(5, 0.05, 5))), Vec3(0, -0.05, 0), BodyType::fixed, Quat::identity(), m);
    const std::uint32_t ball = t.add(t.keep(sphere(0.02)), Vec3(0, 20, 0), BodyType::dynamic, Quat::identity(), m);
    const Real mass = t.world.scene.mass[ball];
    const auto all = [&] {
      return mass * (0.5 * t.world.state.v[ball].squared_norm() + 9.81 * t.world.state.x[ball].y());
    };
    const Real before = all();
    std::uint64_t hits = 0;
    for (int i = 0; i < 20 / dt; ++i) {
      t.world.step(dt);
      hits += t.world.report.sweep_hits;
      assert_true(t.world.state.x[ball].y() > 0.02 - 1e-9);
    }
    assert_true(hits >= 3);
    assert_true(std::fabs(all() - before) < 1e-11 * before);
  }
}

// A rod that only turns, and a post near its end, from slow to twice around a step. The face meets the post at the
// angle whose sine is (a + r)/d, a half the rod's thickness, r the post's radius, d its distance; there the rod is
// answered as a rigid body that is hit at the arm s = sqrt(d^2 - (a + r)^2), and goes on for the rest of the step.
// Afterwards it may slide around the post; it never comes out on the other side.
static void a_spinning_rod_does_not_pass_a_post(void**) {
  constexpr Real kHalf = 0.01, kRadius = 0.01, kFar = 0.8;
  const Real stop = std::asin((kHalf + kRadius) / kFar), arm = std::sqrt(kFar * kFar - std::pow(kHalf + kRadius, 2));
  for (const Real omega : {20.0, 60.0, 150.0, 377.0, 500.0, 800.0})
    for (const Real e : {0.0, 1.0})
      for (int phase = 0; phase < kPhases; ++phase) {
        TestWorld t(Vec3::zero());
        const std::uint32_t m = t.material(0, e);
        const std::uint32_t post =
            t.add(t.keep(capsule(kRadius, 1)), Vec3(kFar, 0, 0), BodyType::fixed, Quat::identity(), m);
        const Real angle =
            0.3 + 2.5 * phase / kPhases;  // of its axis from the post; it turns away, and meets it behind
        const std::uint32_t rod =
            t.add(t.keep(box(Vec3(1, kHalf, kHalf))), Vec3::zero(), BodyType::dynamic, exp_map(Vec3(0, angle, 0)), m);
        t.world.set_velocity(rod, Vec3::zero(), Vec3(0, omega, 0));
        const Real mass = t.world.scene.mass[rod], inertia = t.world.scene.inertia[rod](1, 1);
        const Real way = std::numbers::pi - stop - angle, moment = way / omega;  // rad, s: until it meets
        const int first = static_cast<int>(std::ceil(moment / kDt));             // the step in which it does
        Real side = 0;
        for (int i = 1; i <= first + 20; ++i) {
          t.world.step(kDt);
          if (i < first) assert_true(t.world.report.sweep_hits == 0);
          // A slack of a twentieth of its thickness, and what each further touch of the slide around may add.
          const Real hits = static_cast<Real>(t.world.report.sweep_hits);
          if (i <= first) assert_true(gap(t.world, rod, post) > -1e-3 * (1 + 0.1 * hits) - 1e-6);
          if (i == first) {
            assert_true(t.world.report.sweep_hits > 0);
            const Real p = (1 + e) * omega * arm / (1 / mass + arm * arm / inertia), turned = omega - p * arm / inertia;
            const Real rest = i * kDt - moment;
            if (t.world.report.sweep_hits == 1) {
              const Vec3 push = p / mass * Vec3(-std::sin(stop), 0, std::cos(stop));  // square to the face that met
              const Vec3 spin = t.world.state.omega[rod];
              assert_true((spin - Vec3(0, turned, 0)).norm() < 1e-6 * omega);
              assert_true((t.world.state.v[rod] - push).norm() < 1e-6 * omega);
              assert_true((t.world.state.x[rod] - rest * t.world.state.v[rod]).norm() < 1e-7);
              const Quat there = exp_map(Vec3(0, angle + way + rest * turned, 0));
              assert_true((t.world.state.q[rod] * there.conjugate()).vec().norm() < 1e-6);
            }
          }
          // The post in the rod's frame: beside it, and always on the same side, as long as it is near.
          const Vec3 at = t.world.state.q[rod].conjugate() * (Vec3(kFar, 0, 0) - t.world.state.x[rod]);
          if (i < first) continue;
          if (std::fabs(at.x()) > 0.99 || std::fabs(at.z()) > 0.1) break;  // past the end, or thrown off
          const Real now = at.z() > 0 ? 1 : -1;
          assert_true(side == 0 || now == side);
          side = now;
        }
      }
}

// Head on: each takes the other's velocity, where they meet.
static void two_bullets_meet(void**) {
  for (const Real e : {0.0, 1.0})
    for (int phase = 0; phase < kPhases; ++phase) {
      TestWorld t(Vec3::zero());
      const std::uint32_t m = t.material(0, e);
      const Shape* ball = t.keep(sphere(0.05));
      const Real far = 2 + 300 * kDt * phase / kPhases;
      const std::uint32_t a = t.add(ball, Vec3(-far, 0, 0), BodyType::dynamic, Quat::identity(), m);
      const std::uint32_t b = t.add(ball, Vec3(far, 0, 0), BodyType::dynamic, Quat::identity(), m);
      t.world.set_velocity(a, Vec3(200, 0, 0), Vec3::zero());
      t.world.set_velocity(b, Vec3(-400, 0, 0), Vec3::zero());
      const Real moment = (2 * far - 0.1) / 600, where = -far + 200 * moment;
      const int n = static_cast<int>(std::ceil(moment / kDt)) + 1;
      t.run(n, kDt);
      const Real rest = n * kDt - moment, va = e == 1 ? -400 : -100, vb = e == 1 ? 200 : -100;
      assert_true(std::fabs(t.world.state.v[a].x() - va) < 1e-9 * 600);
      assert_true(std::fabs(t.world.state.v[b].x() - vb) < 1e-9 * 600);
      assert_true(std::fabs(t.world.state.x[a].x() - (where + va * rest)) < 1e-9 * 600);
      assert_true(std::fabs(t.world.state.x[b].x() - (where + 0.1 + vb * rest)) < 1e-9 * 600);
    }
}

// Six walls of a centimetre, something inside at 500 m/s for ten seconds.
static void what_is_in_a_box_stays_in_it(void**) {
  const std::function<Shape()> shapes[] = {[] { return sphere(0.1); }, [] { return box(Vec3(0.1, 0.1, 0.1)); }};
  for (const auto& make : shapes)
    for (const Real friction : {0.0, 0.5}) {
      TestWorld t(Vec3::zero());
      const std::uint32_t m = t.material(friction, 1);
      for (int k = 0; k < 6; ++k) {
        Vec3 half = Vec3::constant(1.01), at = Vec3::zero();
        half[k / 2] = 0.005, at[k / 2] = k % 2 ? 1.005 : -1.005;
        t.add(t.keep(box(half)), at, BodyType::fixed, Quat::identity(), m);
      }
      const std::uint32_t body = t.add(t.keep(make()), Vec3(0.1, 0.2, 0.3), BodyType::dynamic, Quat::identity(), m);
      t.world.set_velocity(body, 500 * Vec3(0.6, 0.48, 0.64), Vec3(1, 2, 3));
      t.world.step(kDt);
      const Real first = energy(t.world);
      std::uint64_t hits = 0;
      for (int i = 1; i < 600; ++i) {
        t.world.step(kDt);
        hits += t.world.report.sweep_hits;
        assert_true(t.world.state.x[body].abs().max_entry() < 0.96);
      }
      assert_true(hits > (friction == 0 ? 1000u : 20u));
      assert_true(energy(t.world) < first * (1 + 1e-6));
      if (friction == 0 && t.world.scene.colliders.shape[6]->form == Form::sphere)
        assert_true(energy(t.world) > first * (1 - 1e-9));
    }
}

// By a millimetre, over an edge, past a corner and beside a ball: to the bit as if nothing were there.
static void what_passes_by_is_left_alone(void**) {
  const std::function<Shape()> obstacles[] = {[] { return box(Vec3(0.3, 1, 1)); }, [] { return sphere(1); },
                                              [] { return capsule(0.2, 0.8); }};
  for (const auto& make : obstacles)
    for (const BodyType type : {BodyType::fixed, BodyType::dynamic})
      for (int phase = 0; phase < kPhases; ++phase) {
        const auto fly = [&](bool there) {
          TestWorld t(Vec3::zero());
          const Vec3 from(-2 - 200 * kDt * phase / kPhases, 1.101, 0.02);
          const std::uint32_t bullet = t.add(t.keep(sphere(0.1)), from);
          const Shape* obstacle = t.keep(make());
          t.add(obstacle, there ? Vec3::zero() : Vec3(0, -1000, 0), type);
          t.world.set_velocity(bullet, Vec3(200, 0, 0), Vec3::zero());
          t.run(6, kDt);
          return t.world.state.x[bullet];
        };
        assert_true(fly(true) == fly(false));
      }
}

// On a floor, at 200 m/s: nothing holds it up, friction takes what Coulomb says.
static void what_slides_fast_goes_on(void**) {
  for (const bool wide : {true, false})
    for (const Real mu : {0.0, 0.5}) {
      TestWorld t;
      const std::uint32_t m = t.material(mu, 0);
      if (wide)
        t.ground(m);
      else
        t.add(t.keep(box(Vec3(1000, 1, 10))), Vec3(0, -1, 0), BodyType::fixed, Quat::identity(), m);
      const std::uint32_t block =
          t.add(t.keep(box(Vec3(0.5, 0.25, 0.5))), Vec3(-500, 0.25, 0), BodyType::dynamic, Quat::identity(), m);
      t.world.set_velocity(block, Vec3(200, 0, 0), Vec3::zero());
      t.run(120, kDt);
      const Real v = 200 - mu * 9.81 * 2;
      assert_true(t.world.plan->effects[+EffectId::continuous].evaluations == 120);
      assert_true(std::fabs(t.world.state.v[block].x() - v) < 0.01 * (200 - v) + 1e-6);
      assert_true(std::fabs(t.world.state.x[block].y() - 0.25) < 1e-3);
    }
}

// A ball and a spinning rod, both swept: momentum; and angular momentum where they meet once, and the rod does not
// tumble by radians in a substep from then on (its path is a chord, which then knows little of its momentum).
static void a_bullet_hits_a_spinning_rod(void**) {
  constexpr Real kSubstep = kDt / 4;
  int met = 0, measured = 0;
  for (int phase = 0; phase < kPhases; ++phase) {
    TestWorld t(Vec3::zero());
    const std::uint32_t m = t.material(0.2, 0.5);
    const std::uint32_t rod =
        t.add(t.keep(box(Vec3(1, 0.02, 0.02))), Vec3::zero(), BodyType::dynamic, exp_map(Vec3(0, 0.2 * phase, 0)), m);
    // Along the axis about which it spins.
    const std::uint32_t ball = t.add(t.keep(sphere(0.3)), Vec3(0.35, -1.5, 0), BodyType::dynamic, Quat::identity(), m);
    t.world.set_velocity(rod, Vec3::zero(), Vec3(0, 60, 0));
    t.world.set_velocity(ball, Vec3(0, 20, 0), Vec3::zero());
    const Vec3 p = momentum(t.world), l = angular_momentum(t.world);
    std::uint64_t hits = 0;
    for (int i = 0; i < 10; ++i) {
      t.world.step(kDt);
      hits += t.world.report.sweep_hits;
      assert_true(gap(t.world, rod, ball) > -2e-3);
      assert_true((momentum(t.world) - p).norm() < 1e-12 * p.norm());
      if (hits != 1 || t.world.report.sweep_hits != 1 || t.world.state.omega[rod].norm() * kSubstep > 0.5) continue;
      assert_true((angular_momentum(t.world) - l).norm() < 1e-11 * l.norm());
      ++measured;
    }
    met += hits > 0;
  }
  assert_true(met > kPhases / 2 && measured > 2);
}

/// Two that fly at each other, each on a spring of next to no force, meet between where both began: in the steps before
/// RATTLE moves them, and neither's way comes near where the other is.
static void what_hangs_on_springs_meets_midway(void**) {
  for (const Real speed : {40.0, 90.0, 230.0})
    for (const Real apart : {2.0, 3.1, 7.7}) {
      TestWorld t(Vec3::zero());
      t.world.set_dial(Dial::accuracy_place, 1e-3);  // forces alone move them: by RATTLE
      const std::uint32_t m = t.material(0, 1);
      std::uint32_t ball[2];
      for (int k = 0; k < 2; ++k) {
        const Vec3 at((k == 0 ? -1 : 1) * apart / 2, 0, 0);
        ball[k] = t.add(t.keep(sphere(0.1)), at, BodyType::dynamic, Quat::identity(), m);
        t.world.set_velocity(ball[k], Vec3((k == 0 ? 1 : -1) * speed, 0, 0), Vec3::zero());
        SpringDef spring;
        spring.body_b = ball[k], spring.anchor_a = at, spring.stiffness = 1e-9;
        t.world.add_spring(spring);
      }
      for (int k = 0; k < 40; ++k) {
        t.world.step(kDt);
        assert_true(t.world.state.x[ball[0]].x() < t.world.state.x[ball[1]].x());
      }
      assert_true(std::fabs(t.world.state.v[ball[1]].x() - speed) < 1e-6 * speed);
    }
}

/// What lies aslant and is struck where it stands up turns about its edge within the step, faster than the points that its
/// contacts knew as the step began: it lands flat, and does not turn on through the ground.
static void what_a_blow_turns_does_not_get_through_the_ground(void**) {
  struct Struck {
    Shape shape;
    Vec3 half;  // m
    Real mass;  // kg
  };
  const Struck kinds[] = {{box(Vec3(0.06, 0.0025, 0.04)), Vec3(0.06, 0.0025, 0.04), 0.002},
                          {box(Vec3(0.2, 0.01, 0.05)), Vec3(0.2, 0.01, 0.05), 0.3},
                          {box(Vec3(0.3, 0.004, 0.3)), Vec3(0.3, 0.004, 0.3), 0.05},
                          {ellipsoid(Vec3(0.1, 0.006, 0.03)), Vec3(0.1, 0.006, 0.03), 0.01}};
  int through = 0, blows = 0;
  for (const Struck& kind : kinds)
    for (const Real lean : {0.15, 0.35, 0.7})
      for (const Real speed : {3.0, 8.0, 20.0})
        for (int phase = 0; phase < 4; ++phase) {
          TestWorld t;
          const std::uint32_t m = t.material(0.5, 0.4);
          t.add(t.keep(half_space(Vec3(0, 1, 0), 0)), Vec3::zero(), BodyType::fixed, Quat::identity(), m);
          const Quat turn = exp_map(Vec3(0, 0, lean));
          const Shape* shape = t.keep(kind.shape);
          const Real low =
              support_point(*shape, turn.conjugate() * Vec3(0, -1, 0)).dot(turn.conjugate() * Vec3(0, -1, 0));
          const std::uint32_t board = t.add(shape, Vec3(0, low, 0), BodyType::dynamic, turn, m);
          MassGiven mass;
          mass.mass = kind.mass;
          t.world.set_mass(board, mass);
          const Vec3 end = turn * Vec3(0.7 * kind.half.x(), kind.half.y(), 0);
          const Real radius = 0.1, above = radius + 1.2 * kind.half.y() + speed * kDt * phase / 4;
          const std::uint32_t ball = t.add(t.keep(sphere(radius)), Vec3(end.x(), low + end.y() + above, 0),
                                           BodyType::dynamic, Quat::identity(), m);
          mass.mass = 20;
          t.world.set_mass(ball, mass);
          t.world.set_velocity(ball, Vec3(0, -speed, 0), Vec3::zero());
          Real lowest = 0;
          for (int i = 0; i < 20; ++i) t.world.step(kDt), lowest = std::min(lowest, t.world.state.x[board].y());
          ++blows;
          if (lowest < -1e-3) {
            ++through;
            print_message("half %.3f m, lean %.2f, %.0f m/s, phase %d: %.4f m below\n", kind.half.x(), lean, speed,
                          phase, -lowest);
          }
        }
  print_message("%d of %d got through\n", through, blows);
  assert_int_equal(through, 0);
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(impacts_are_where_and_when_they_must_be),
      cmocka_unit_test(a_wall_that_moves_takes_its_share),
      cmocka_unit_test(momentum_is_kept_off_centre),
      cmocka_unit_test(gravity_and_bounces_keep_energy),
      cmocka_unit_test(a_spinning_rod_does_not_pass_a_post),
      cmocka_unit_test(two_bullets_meet),
      cmocka_unit_test(what_is_in_a_box_stays_in_it),
      cmocka_unit_test(what_passes_by_is_left_alone),
      cmocka_unit_test(what_slides_fast_goes_on),
      cmocka_unit_test(a_bullet_hits_a_spinning_rod),
      cmocka_unit_test(what_hangs_on_springs_meets_midway),
      cmocka_unit_test(what_a_blow_turns_does_not_get_through_the_ground),
  };
  return cmocka_run_group_tests_name("oracle/bullet", tests, nullptr, nullptr);
}
