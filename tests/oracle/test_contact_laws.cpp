// One contact at a time against closed forms: friction on a slope, bounces, impacts between two bodies and along a row.
#include <vector>

#include "carom_test.h"
#include "dynamics/contact_views.h"
#include "world_builder.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr Real kG = 9.81;
constexpr Real kSine = 0.5, kCosine = 0.866025403784438647;  // 30 degrees

/// Numbers below are those of the paper's solver at one substep; @see test_solvers, test_direct, test_auto for the
/// others.
void paper(World& world) {
  world.set_dial(Dial::solver, kSeverityChoice);
  world.set_dial(Dial::substeps, 1);
}

/// Ground y <= 0 under gravity tilted by 30 degrees about z: a slope that falls towards +x.
struct Slope : TestWorld {
  std::uint32_t block;
  explicit Slope(Real mu, const Vec3& velocity) : TestWorld(kG * Vec3(kSine, -kCosine, 0)) {
    const std::uint32_t m = material(mu, 0);
    ground(m);
    // Low and wide: the friction couple (mu * half height) stays within the base, so no corner lifts.
    block = add(keep(box(Vec3(0.5, 0.1, 0.5))), Vec3(0, 0.1, 0), BodyType::dynamic, Quat::identity(), m);
    world.set_velocity(block, velocity, Vec3::zero());
    paper(world);
    world.set_dial(Dial::velocity_tolerance, 1e-7);
    world.set_dial(Dial::velocity_iterations, 100);
  }
};

}  // namespace

static void a_block_slides_down_as_coulomb_says(void**) {
  const Real mu = 0.3, a = kG * (kSine - mu * kCosine), T = 1;
  for (int n : {60, 120, 240}) {
    Slope s(mu, Vec3::zero());
    s.run(n, T / n);
    const Vec3& x = s.world.state.x[s.block];
    // Semi-implicit Euler under a constant acceleration: x_n - x = a T h/2; the solver adds its tolerance times T.
    const Real h = T / n, want = a * T * T / 2 + a * T * h / 2;
    assert_true(std::fabs(x.x() - want) < 1e-6);
    assert_true(std::fabs(x.z()) < 1e-6);
    assert_true(std::fabs(s.world.state.v[s.block].x() - a * T) < 1e-6);
  }
}

static void a_block_slides_diagonally_without_a_sideways_pull(void**) {
  // Circular cone: a block pushed along any direction on level ground decelerates straight along it, v^2/(2 mu g) far.
  const Real mu = 0.5, v = 3;
  for (Real turn : {0.0, 0.3, 0.785398163397448, 1.2}) {
    TestWorld t;
    paper(t.world);
    const std::uint32_t m = t.material(mu, 0);
    t.ground(m);
    const std::uint32_t b = t.add(t.keep(sphere(0.5)), Vec3(0, 0.5, 0), BodyType::dynamic, Quat::identity(), m);
    BodyDef def;  // a sphere that cannot roll is a point of friction
    const std::uint32_t skid = handle_slot([&] {
      def.has_mass = def.has_inertia = true;
      def.mass = 2;
      def.pose.p = Vec3(5, 0.5, 5);
      return t.world.add_body(def);
    }());
    t.world.add_collider(skid, t.world.scene.colliders.shape[1], Pose{}, 0, m);
    t.world.remove_body(b);
    const SinCos sc = sin_cos(turn);
    const Vec3 along(sc.cos, 0, sc.sin);
    t.world.set_velocity(skid, v * along, Vec3::zero());
    t.run(120, 1.0 / 60);
    const Vec3 way = t.world.state.x[skid] - Vec3(5, 0.5, 5);
    const Real h = 1.0 / 60;
    // Semi-implicit: v falls by mu g h before each move, so the way is short by v h/2, to one step's way v_last h < mu
    // g h^2.
    assert_true(std::fabs(way.dot(along) - (v * v / (2 * mu * kG) - v * h / 2)) < mu * kG * h * h);
    assert_true((way - way.dot(along) * along).norm() < 1e-3 * h + 1e-12 + 0.5e-3);  // height: position tolerance
    assert_true(t.world.state.v[skid].norm() < 1e-3);
  }
}

static void a_block_sticks_below_the_friction_angle(void**) {
  Slope s(0.6, Vec3::zero());  // tan 30 = 0.577
  s.run(600, 1.0 / 60);
  const Vec3& x = s.world.state.x[s.block];
  assert_true(std::fabs(x.x()) < 1e-7 * 10 && std::fabs(x.z()) < 1e-7 * 10);  // tolerance times time
}

static void a_ball_bounces_to_e_squared_of_its_height(void**) {
  for (const Real e : {0.3, 0.5, 0.8, 1.0}) {
    for (const Real h : {1.0 / 60, 1.0 / 240, 1.0 / 960}) {
      TestWorld t;
      const std::uint32_t m = t.material(0, e);
      t.ground(m);
      const std::uint32_t b = t.add(t.keep(sphere(0.1)), Vec3(0, 1.1, 0), BodyType::dynamic, Quat::identity(), m);
      Real top = 0;
      bool bounced = false;
      for (int i = 0; i < static_cast<int>(1.2 / h); ++i) {
        t.world.step(h);
        bounced |= t.world.state.v[b].y() > 0;
        if (bounced) top = std::max(top, t.world.state.x[b].y() - 0.1);
      }
      // Semi-implicit Euler starts at g h/2 downwards, g h^2/8 of height; and the peak lies up to h/2 beside a step, g
      // h^2/8 lower.
      assert_true(bounced);
      assert_true(std::fabs(top - e * e) < kG * h * h / 8 + 1e-12);
    }
  }
}

static void below_the_restitution_speed_nothing_bounces(void**) {
  TestWorld t;
  const std::uint32_t m = t.material(0.5, 1);
  t.ground(m);
  const std::uint32_t b = t.add(t.keep(sphere(0.5)), Vec3(0, 0.501, 0), BodyType::dynamic, Quat::identity(), m);
  for (int i = 0; i < 60; ++i) {
    t.world.step(1.0 / 60);
    assert_true(t.world.state.v[b].y() <= 1e-3);
  }
}

static void two_balls_exchange_momentum_as_closed_form_says(void**) {
  for (const Real e : {0.0, 0.5, 1.0}) {
    for (const Real ratio : {1.0, 3.0, 1000.0}) {
      TestWorld t(Vec3::zero());
      paper(t.world);
      const std::uint32_t m = t.material(0.5, e);
      const auto ball = [&](Real mass, const Vec3& x, const Vec3& v) {
        BodyDef def;
        def.has_mass = true;
        def.mass = mass;
        def.pose.p = x;
        def.velocity = v;
        const std::uint32_t b = handle_slot(t.world.add_body(def));
        t.world.add_collider(b, t.keep(sphere(0.5)), Pose{}, 0, m);
        return b;
      };
      const std::uint32_t a = ball(ratio, Vec3(0, 0, 0), Vec3(4, 0, 0)), b = ball(1, Vec3(1.3, 0, 0), Vec3(-1, 0, 0));
      t.run(60, 1.0 / 60);
      const Real common = (ratio * 4 - 1) / (ratio + 1);  // velocity of the common centre
      const Vec3 &va = t.world.state.v[a], &vb = t.world.state.v[b];
      // e = 0 stops in two steps: first at the surface, then for good. One contact is solved to rounding.
      assert_true(std::fabs(va.x() - (common - e * 5 / (ratio + 1))) < 1e-12 * ratio);
      assert_true(std::fabs(vb.x() - (common + e * 5 * ratio / (ratio + 1))) < 1e-12 * ratio);
      assert_true(std::fabs(ratio * va.x() + vb.x() - (ratio * 4 - 1)) < 1e-12 * ratio);
    }
  }
}

static void a_row_of_balls_passes_the_blow_on(void**) {
  for (const Real substeps : {1.0, 4.0, 16.0}) {
    TestWorld t(Vec3::zero());
    t.world.set_dial(Dial::substeps, substeps);
    const std::uint32_t m = t.material(0, 1);
    const Shape* ball = t.keep(sphere(0.5));
    std::vector<std::uint32_t> row;
    for (int i = 0; i < 5; ++i)
      row.push_back(t.add(ball, Vec3(i + (i ? 0.0 : -0.5), 0, 0), BodyType::dynamic, Quat::identity(), m));
    t.world.set_velocity(row[0], Vec3(2, 0, 0), Vec3::zero());
    t.run(60, 1.0 / 60);
    for (int i = 0; i < 4; ++i) assert_true(t.world.state.v[row[i]].norm() < 1e-12);
    assert_true((t.world.state.v[row[4]] - Vec3(2, 0, 0)).norm() < 1e-12);
  }
}

static void impulses_reported_carry_the_weight(void**) {
  TestWorld t;
  t.ground();
  const std::uint32_t b = t.add(t.keep(box(Vec3::constant(0.5))), Vec3(0, 0.5, 0));
  t.world.set_dial(Dial::velocity_tolerance, 1e-8);
  for (const Real substeps : {1.0, 4.0}) {
    t.world.set_dial(Dial::substeps, substeps);
    t.run(60, 1.0 / 60);
    Real sum = 0;
    for (const ContactView& view : t.world.contact_views()) {
      assert_true(view.normal.y() == 1 || view.normal.y() == -1);
      assert_true(std::fabs(view.point.y()) < 1e-3 && view.normal_impulse >= 0);
      sum += view.normal_impulse;
    }
    const Real weight = t.world.scene.mass[b] * kG / 60;
    assert_true(std::fabs(sum - weight) < 1e-5 * weight);  // tolerance 1e-8 m/s of 0.16 m/s, for each of 4 points
  }
}

static void a_kinematic_platform_carries_what_lies_on_it(void**) {
  TestWorld t;
  const std::uint32_t platform = t.add(t.keep(box(Vec3(5, 0.5, 5))), Vec3(0, -0.5, 0), BodyType::kinematic);
  const std::uint32_t b = t.add(t.keep(box(Vec3::constant(0.5))), Vec3(0, 0.5, 0));
  t.world.set_velocity(platform, Vec3(0.5, 0.25, 0), Vec3::zero());
  t.run(120, 1.0 / 60);
  assert_true((t.world.state.v[b] - Vec3(0.5, 0.25, 0)).norm() < 4e-3);
  assert_true(std::fabs(t.world.state.x[b].y() - 1) < 2e-3);
  assert_true(t.world.state.v[platform] == Vec3(0.5, 0.25, 0));
}

namespace {

/// The others than the paper's: which velocity moves a body, @see contact/mean_motion.h.
constexpr int kOthers[] = {kSoftChoice, kDirectChoice, kAutoChoice};
void choose(World& world, int solver) {
  world.set_dial(Dial::solver, solver);
  world.set_dial(Dial::velocity_tolerance, 1e-9);
  world.set_dial(Dial::velocity_iterations, 100);
  world.set_dial(Dial::position_tolerance, 1e-6);
  world.set_dial(Dial::hold_angle, 0);
  world.set_dial(Dial::substeps, 4);
}
bool is_soft(int solver) { return solver == kSoftChoice || solver == kAutoChoice; }
/// m: what a spring of 30 Hz sinks under a body on something that does not move.
constexpr Real kSunk = kG / (4 * 30 * 30 * 9.87);

/// rad: a box of height 2 and width 1 that stands on an edge, let go at an angle from where it would stand still:
/// Runge-Kutta of a'' = m g d sin(a) / I, d from the edge to the middle.
Real tipped(Real a, Real seconds) {
  const Real d = std::sqrt(1.25), k = kG * d / (5.0 / 12 + 1.25), h = seconds / 1e4;
  Real w = 0;
  const auto pull = [&](Real x) { return k * std::sin(x); };
  for (int i = 0; i < 10000; ++i) {
    const Real a1 = w, w1 = pull(a), a2 = w + h / 2 * w1, w2 = pull(a + h / 2 * a1), a3 = w + h / 2 * w2,
               w3 = pull(a + h / 2 * a2), a4 = w + h * w3, w4 = pull(a + h * a3);
    a += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4), w += h / 6 * (w1 + 2 * w2 + 2 * w3 + w4);
  }
  return a;
}

/// rad: by how much a box that tips about an edge that sticks is off after 0.6 s.
Real tipping_error(int solver, int n) {
  constexpr Real kTime = 0.6, kStart = 0.1;
  TestWorld t;
  choose(t.world, solver);
  const std::uint32_t m = t.material(2, 0);
  t.ground(m);
  const Real stands = std::atan(0.5), d = std::sqrt(1.25);  // edge below the middle: where it would stand still
  const auto pose = [&](Real a) { return Vec3(d * std::sin(a), d * std::cos(a), 0); };
  const std::uint32_t b =
      t.add(t.keep(box(Vec3(0.5, 1, 0.5))), pose(kStart), BodyType::dynamic, exp_map(Vec3(0, 0, -stands - kStart)), m);
  t.run(n, kTime / n);
  const Quat& q = t.world.state.q[b];
  return std::fabs(-2 * std::atan2(q.z(), q.w()) - stands - tipped(kStart, kTime));
}

}  // namespace

/// A steady acceleration is followed exactly but for the first substep, in which nothing slides yet: that one moves by
/// a h, not by half of it. Soft contacts bear less while they sink, and as long as that tilts the block (2 zeta / w =
/// 0.1 s) it goes by the velocities of substeps' ends.
static void a_block_slides_as_far_as_coulomb_says(void**) {
  const Real mu = 0.3, a = kG * (kSine - mu * kCosine);
  for (const int solver : kOthers)
    for (const int n : {60, 240}) {
      Slope s(mu, Vec3::zero());
      choose(s.world, solver);
      s.run(n, 1.0 / n);
      const Vec3& x = s.world.state.x[s.block];
      print_message("solver %d, n %d: off %.1e\n", solver, n, x.x() - a / 2);
      const Real h = 1.0 / (4 * n), first = a * h * h / 2, settles = 2 * mu * kSunk + a * h / 2 * 0.1;
      assert_true(std::fabs(x.x() - a / 2 - first) < 1e-9 + (is_soft(solver) ? settles : 0) && std::fabs(x.z()) < 1e-6);
    }
}

/// A cart that speeds up, and slows, takes along what sticks to it, and a slab on that. A mean of its velocity and
/// theirs would leave them behind by v h / 2, 4 mm.
static void what_sticks_stays_where_it_is(void**) {
  for (const int solver : kOthers) {
    TestWorld t;
    choose(t.world, solver);
    const std::uint32_t m = t.material(0.8, 0);
    const std::uint32_t cart =
        t.add(t.keep(box(Vec3(2, 0.1, 2))), Vec3(0, -0.1, 0), BodyType::kinematic, Quat::identity(), m);
    const Shape* const slab = t.keep(box(Vec3(0.5, 0.1, 0.5)));
    const std::uint32_t a = t.add(slab, Vec3(0, 0.1, 0), BodyType::dynamic, Quat::identity(), m),
                        b = t.add(slab, Vec3(0, 0.3, 0), BodyType::dynamic, Quat::identity(), m);
    t.run(60, 1.0 / 60);
    const Vec3 from_a = t.world.state.x[a] - t.world.state.x[cart], from_b = t.world.state.x[b] - t.world.state.x[a];
    Real most = 0;
    for (int i = 0; i < 120; ++i) {
      t.world.set_velocity(cart, Vec3(i < 60 ? i / 30.0 : (120 - i) / 30.0, 0, 0), Vec3::zero());
      t.world.step(1.0 / 60);
      most = std::max({most, (t.world.state.x[a] - t.world.state.x[cart] - from_a).norm(),
                       (t.world.state.x[b] - t.world.state.x[a] - from_b).norm()});
    }
    print_message("solver %d: %.1e m\n", solver, most);
    assert_true(most < 4e-4);
  }
}

/// Forces of a substep's beginning and the velocity of its end make up for each other in what tips: by a mean velocity
/// it would be late by some w h / 2 = 6e-4 rad.
static void a_box_tips_as_its_equation_says(void**) {
  for (const int solver : kOthers) {
    const Real coarse = tipping_error(solver, 72), fine = tipping_error(solver, 144);
    print_message("solver %d: %.2e, %.2e rad\n", solver, coarse, fine);
    assert_true(coarse < 1.5e-4 && fine < coarse);
  }
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(a_block_slides_down_as_coulomb_says),
      cmocka_unit_test(a_block_slides_as_far_as_coulomb_says),
      cmocka_unit_test(what_sticks_stays_where_it_is),
      cmocka_unit_test(a_box_tips_as_its_equation_says),
      cmocka_unit_test(a_block_slides_diagonally_without_a_sideways_pull),
      cmocka_unit_test(a_block_sticks_below_the_friction_angle),
      cmocka_unit_test(a_ball_bounces_to_e_squared_of_its_height),
      cmocka_unit_test(below_the_restitution_speed_nothing_bounces),
      cmocka_unit_test(two_balls_exchange_momentum_as_closed_form_says),
      cmocka_unit_test(a_row_of_balls_passes_the_blow_on),
      cmocka_unit_test(impulses_reported_carry_the_weight),
      cmocka_unit_test(a_kinematic_platform_carries_what_lies_on_it),
  };
  return cmocka_run_group_tests_name("oracle/contact_laws", tests, nullptr, nullptr);
}
