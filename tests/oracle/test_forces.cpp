// Drag, wind, fields, springs and buoyancy, each alone, against its closed form and the order of its integrator.
#include <functional>
#include <numbers>
#include <random>

#include "carom_test.h"
#include "dynamics/force/floats.h"
#include "dynamics/force/force.h"
#include "world_builder.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr Real kExplicit = 0, kSemiImplicit = 1, kRk4 = 2, kVerlet = 3;

std::uint32_t mass_point(TestWorld& t, Real mass, const Vec3& x, const Vec3& v) {
  BodyDef def;
  def.has_mass = true, def.mass = mass;
  def.pose.p = x, def.velocity = v;
  return handle_slot(t.world.add_body(def));
}

/// Error after time T in n steps, as it shrinks from n to 2n: the order.
Real order_of(const std::function<Real(int steps)>& error, int n) { return std::log2(error(n) / error(2 * n)); }

/// m/s after T of drag alone.
Vec3 dragged(Real integrator, const Drag& drag, Real mass, const Vec3& v0, const Vec3& wind, Real T, int steps) {
  TestWorld t(Vec3::zero());
  t.world.set_dial(Dial::integrator, integrator);
  const std::uint32_t body = mass_point(t, mass, Vec3::zero(), v0);
  t.world.set_attribute(body, AttributeId::drag, {drag.linear, drag.quadratic});
  t.world.set_wind(wind);
  t.run(steps, T / steps);
  return t.world.state.v[body];
}

Vec3 drag_law(const Drag& drag, Real mass, const Vec3& v0, const Vec3& wind, Real T) {
  const Vec3 u = v0 - wind;
  const Real a = drag.linear / mass, b = drag.quadratic / mass;
  const Real left = std::exp(-a * T), spent = a > 0 ? -std::expm1(-a * T) / a : T;
  return wind + left / (1 + b * u.norm() * spent) * u;
}

}  // namespace

static void drag_alone_is_exact_at_any_step(void**) {
  const Vec3 v0(30, -4, 2), winds[] = {Vec3::zero(), Vec3(-7, 1, 3)};
  const Drag drags[] = {{0.3, 0}, {0, 0.02}, {0.3, 0.02}, {1e-9, 0.02}, {0.3, 1e-9}, {900, 50}};
  for (const Vec3& wind : winds)
    for (const Drag& drag : drags)
      for (const int steps : {2, 7, 60})
        for (const Real integrator : {kExplicit, kSemiImplicit, kVerlet}) {
          const Vec3 want = drag_law(drag, 0.7, v0, wind, 2), got = dragged(integrator, drag, 0.7, v0, wind, 2, steps);
          // A few roundings for each flow, two of which stand in a step.
          assert_true((got - want).norm() <= 2 * steps * 64 * kEpsilon * (v0.norm() + wind.norm()));
        }
}

static void runge_kutta_takes_drag_to_its_order(void**) {
  const Vec3 v0(30, -4, 2), wind(-7, 1, 3);
  const Drag drag{0.3, 0.02};
  const auto error = [&](Real integrator) {
    return [=](int n) {
      return (dragged(integrator, drag, 0.7, v0, wind, 1, n) - drag_law(drag, 0.7, v0, wind, 1)).norm();
    };
  };
  assert_true(std::fabs(order_of(error(kRk4), 20) - 4) < 0.3);
  // What it could not step is a flow; in the end, slow, it is a force again, and at rate * dt = 1 good to a percent.
  const Drag stiff{0.3, 1e6};
  const Vec3 want = drag_law(stiff, 0.7, v0, wind, 1);
  assert_true((dragged(kRk4, stiff, 0.7, v0, wind, 1, 10) - want).norm() < 0.01 * (want - wind).norm());
}

static void what_falls_through_air_reaches_its_terminal_speed(void**) {
  // v = vt tanh(g t / vt), vt = sqrt(m g / c)
  const Real m = 2, c = 0.05, g = 9.81, T = 3, vt = std::sqrt(m * g / c);
  const auto error = [&](int n) {
    TestWorld t(Vec3(0, -g, 0));
    t.world.set_dial(Dial::integrator, kVerlet);
    const std::uint32_t body = mass_point(t, m, Vec3::zero(), Vec3::zero());
    t.world.set_attribute(body, AttributeId::drag, {0, c});
    t.run(n, T / n);
    return std::fabs(t.world.state.v[body].y() + vt * std::tanh(g * T / vt));
  };
  assert_true(std::fabs(order_of(error, 60) - 2) < 0.1);
}

static void wind_takes_along_what_has_drag_and_nothing_else(void**) {
  TestWorld t(Vec3::zero());
  const std::uint32_t leaf = mass_point(t, 0.01, Vec3::zero(), Vec3::zero());
  const std::uint32_t stone = mass_point(t, 1, Vec3(5, 0, 0), Vec3(0, 1, 0));
  t.world.set_attribute(leaf, AttributeId::drag, {0.1, 0.01});
  t.world.set_wind(Vec3(4, 0, -2));
  t.run(120, 1.0 / 60);
  assert_true((t.world.state.v[leaf] - Vec3(4, 0, -2)).norm() < 1e-6);
  assert_true(t.world.state.v[stone] == Vec3(0, 1, 0));
  assert_int_equal(t.world.plan->find("wind")->participants.count, 1);
}

static void a_uniform_field_ends_where_its_box_does(void**) {
  TestWorld t(Vec3::zero());
  t.world.set_dial(Dial::integrator, kVerlet);
  FieldDef f;
  f.vector = Vec3(0, 3, 0);
  f.half = Vec3(1, 10, 10);
  f.pose = {exp_map(std::numbers::pi / 2 * Vec3::unit_y()), Vec3(0, 0, 5)};
  t.world.add_field(f);  // turned: |z - 5| <= 1, |x| <= 10
  const std::uint32_t in = mass_point(t, 2, Vec3(8, 0, 5), Vec3(0.5, 0, 0)),
                      out = mass_point(t, 2, Vec3(0, 0, 6.5), Vec3::zero());
  t.run(60, 1.0 / 60);
  assert_true((t.world.state.x[in] - Vec3(8.5, 1.5, 5)).norm() < 1e-13);
  assert_true(t.world.state.v[out] == Vec3::zero());
  f.is_force = true;
  t.world.set_field(0, f);
  const Vec3 v = t.world.state.v[in];
  t.run(60, 1.0 / 60);
  assert_true((t.world.state.v[in] - v - Vec3(0, 1.5, 0)).norm() < 1e-13);
}

static void planets_go_round(void**) {
  // mu = strength * reference^2; a circle of radius r takes 2 pi sqrt(r^3 / mu).
  const Real r = 2, mu = 5, period = 2 * std::numbers::pi * std::sqrt(r * r * r / mu);
  const auto after = [&](Real integrator, int n) {
    TestWorld t(Vec3::zero());
    t.world.set_dial(Dial::integrator, integrator);
    FieldDef f;
    f.kind = FieldKind::radial;
    f.pose.p = Vec3(1, 2, 3);
    f.reference = 0.5, f.strength = -mu / 0.25, f.falloff = 2;
    t.world.add_field(f);
    const std::uint32_t body = mass_point(t, 3, Vec3(1 + r, 2, 3), Vec3(0, 0, std::sqrt(mu / r)));
    t.run(n, period / n);
    return (t.world.state.x[body] - Vec3(1 + r, 2, 3)).norm();
  };
  assert_true(std::fabs(order_of([&](int n) { return after(kVerlet, n); }, 200) - 2) < 0.05);
  assert_true(std::fabs(order_of([&](int n) { return after(kRk4, n); }, 200) - 4) < 0.15);
}

static void fields_are_what_they_say(void**) {
  FieldDef f;
  f.kind = FieldKind::radial;
  f.strength = 6, f.reference = 2, f.reach = 10;
  const Vec3 d = Vec3(2, -1, 2);  // 3 m
  for (const int falloff : {-2, -1, 0, 1, 2, 5}) {
    f.falloff = falloff;
    assert_true((field_at(f, d) - 6 * std::pow(2.0 / 3, falloff) * d / 3).norm() < 1e-13);
  }
  f.falloff = 2, f.core = 4;  // s = 5
  assert_true((field_at(f, d) - 6 * (2.0 / 5) * (2.0 / 5) * d / 5).norm() < 1e-14);
  assert_true(field_at(f, Vec3(0, 0, 0)) == Vec3::zero());
  f.core = 0;
  assert_true(field_at(f, Vec3(0, 0, 0)) == Vec3::zero());
  assert_true(field_at(f, Vec3(0, 10.001, 0)) == Vec3::zero());

  FieldDef v;
  v.kind = FieldKind::vortex;
  v.strength = 6, v.pull = 2, v.lift = 1, v.reference = 2, v.falloff = 1, v.half.y() = 4, v.reach = 20;
  // At 3 m on the x axis, right-handed about y: around is -z.
  assert_true((field_at(v, Vec3(3, -1, 0)) - 2.0 / 3 * Vec3(-2, 1, -6)).norm() < 1e-14);
  assert_true(field_at(v, Vec3(3, 4.001, 0)) == Vec3::zero());
  v.pose.q = exp_map(std::numbers::pi / 2 * Vec3::unit_x());  // its axis along z
  assert_true((field_at(v, Vec3(3, 0, 0)) - 2.0 / 3 * Vec3(-2, 6, 1)).norm() < 1e-13);
}

static void who_feels_a_field_is_who_shares_its_mask(void**) {
  TestWorld t(Vec3::zero());
  std::vector<std::uint32_t> bodies;
  for (int i = 0; i < 100; ++i) bodies.push_back(mass_point(t, 1, Vec3(i, 0, 0), Vec3::zero()));
  FieldDef f;
  f.vector = Vec3(0, 1, 0), f.mask = 8;
  t.world.add_field(f);
  t.world.set_attribute(bodies[7], AttributeId::force_field_mask, {Real(9)});
  t.run(10, 0.1);
  for (const std::uint32_t i : bodies) assert_true((t.world.state.v[i] != Vec3::zero()) == (i == bodies[7]));
  assert_int_equal(t.world.plan->find("fields")->participants.count, 1);
}

static void springs_swing_as_they_should(void**) {
  // Two bodies: x = x0 e^(-d t) cos(w t) + ..., of their reduced mass.
  const Real m1 = 2, m2 = 3, k = 40, rest = 1, T = 2, mu = m1 * m2 / (m1 + m2);
  for (const Real c : {0.0, 1.5}) {
    const Real d = c / (2 * mu), w = std::sqrt(k / mu - d * d), x0 = 0.3;
    const Real want = rest + x0 * std::exp(-d * T) * (std::cos(w * T) + d / w * std::sin(w * T));
    const auto error = [&](Real integrator) {
      return [=](int n) {
        TestWorld t(Vec3::zero());
        t.world.set_dial(Dial::integrator, integrator);
        SpringDef s;
        s.body_a = mass_point(t, m1, Vec3(0, 0, 0), Vec3(0, 1, 0));
        s.body_b = mass_point(t, m2, Vec3(0, 0, rest + x0), Vec3(0, 1, 0));
        s.rest = rest, s.stiffness = k, s.damping = c;
        t.world.add_spring(s);
        t.run(n, T / n);
        const State& st = t.world.state;
        const Vec3 mean = (m1 * st.v[s.body_a] + m2 * st.v[s.body_b]) / (m1 + m2);
        assert_true((mean - Vec3(0, 1, 0)).norm() < 1e-13);  // momentum stays
        return std::fabs((st.x[s.body_b] - st.x[s.body_a]).norm() - want);
      };
    };
    assert_true(std::fabs(order_of(error(kVerlet), 120) - 2) < 0.15);
    assert_true(std::fabs(order_of(error(kRk4), 40) - 4) < 0.3);
  }
}

static void a_spring_off_the_middle_turns_a_body(void**) {
  // A dumbbell's end tied straight below: small swings of a physical pendulum driven by the spring, checked by energy.
  TestWorld t(Vec3::zero());
  t.world.set_dial(Dial::integrator, kVerlet);
  BodyDef def;
  def.has_mass = def.has_inertia = true;
  def.mass = 1, def.inertia = Mat3::diagonal(Vec3(0.2, 0.1, 0.3));
  SpringDef s;
  s.body_a = handle_slot(t.world.add_body(def));
  s.anchor_a = Vec3(0.5, 0.1, 0), s.anchor_b = Vec3(1.5, 0.4, 0.3);
  s.rest = 0.2, s.stiffness = 25;
  t.world.add_spring(s);
  const auto energy = [&] {
    const State& st = t.world.state;
    const Vec3 w = st.q[s.body_a].conjugate() * st.omega[s.body_a];
    const SpringReading r = read_spring(t.world, 0);
    return 0.5 * st.v[s.body_a].squared_norm() + 0.5 * w.dot(def.inertia * w) + r.pull * r.pull / (2 * s.stiffness);
  };
  const Real start = energy();
  Real worst = 0;
  for (int i = 0; i < 2000; ++i) {
    t.world.step(1e-3);
    worst = std::max(worst, std::fabs(energy() - start));
  }
  // Symplectic in translation, and nearly so in rotation: (w h)^2 / 24 of the energy and some, w = 11 rad/s.
  assert_true(worst < 2e-4 * start);
}

static void a_bungee_only_pulls(void**) {
  TestWorld t(Vec3::zero());
  SpringDef s;
  s.body_a = mass_point(t, 1, Vec3(0.5, 0, 0), Vec3(-0.1, 0, 0));
  s.rest = 1, s.stiffness = 100, s.damping = 5, s.only_pulls = true;
  t.world.add_spring(s);
  t.run(60, 1.0 / 60);
  assert_true(t.world.state.v[0] == Vec3(-0.1, 0, 0));
  t.world.set_pose(0, {Quat::identity(), Vec3(1.5, 0, 0)});
  t.run(1, 1.0 / 60);
  assert_true(t.world.state.v[0].x() < -0.1);
}

static void stiff_springs_stay_bounded(void**) {
  // A net of springs a million times too stiff for the step, pulled at; heavy and light bodies.
  for (const Real integrator : {kSemiImplicit, kRk4, kVerlet}) {
    TestWorld t(Vec3(0, -9.81, 0));
    t.world.set_dial(Dial::integrator, integrator);
    constexpr int n = 6;
    std::vector<std::uint32_t> body;
    for (int i = 0; i < n * n; ++i)
      body.push_back(mass_point(t, i % 5 == 0 ? 1000 : 1, Vec3(i % n, 0, i / n), Vec3::zero()));
    const auto tie = [&](std::uint32_t a, std::uint32_t b, const Vec3& anchor) {
      SpringDef s;
      s.body_a = a, s.body_b = b, s.anchor_b = anchor, s.rest = 1, s.stiffness = 1e10, s.damping = 1e3;
      t.world.add_spring(s);
    };
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        if (j + 1 < n) tie(body[i * n + j], body[i * n + j + 1], Vec3::zero());
        if (i + 1 < n) tie(body[i * n + j], body[(i + 1) * n + j], Vec3::zero());
      }
    tie(body[0], 0xFFFFFFFFu, Vec3(0, 1, 0));
    tie(body[n - 1], 0xFFFFFFFFu, Vec3(n - 1, 1, 0));
    t.run(600, 1.0 / 60);
    assert_int_equal(t.world.state.quarantined_count, 0);
    for (const std::uint32_t i : body) assert_true(t.world.state.x[i].norm() < 1e5);
    assert_true(t.world.scene.springs.softened == t.world.plan->find("springs")->participants.count);
  }
}

// ---- water ----

static void shares_under_water_add_up(void**) {
  // What is under a plane and what is above it are the whole, and a random point cloud agrees with each.
  std::mt19937_64 random(7);
  std::uniform_real_distribution<Real> unit(-1, 1);
  const Vec3 half(0.4, 0.7, 1.1);
  std::list<Shape> shapes;
  const auto keep = [&](Shape s) -> const Shape& {
    shapes.push_back(std::move(s));
    Shape& k = shapes.back();
    k.mass = mass_from_form(k.form, k.radius, k.half_height, k.half, k.vertices);
    return k;
  };
  struct Case {
    const Shape& shape;
    std::function<bool(const Vec3&)> has;
    Vec3 box;
    Real tolerance;  // of the volume: rounding, or what a hull of 256 points leaves
  };
  const auto in_box = [&](const Vec3& x) { return (x.abs() - half).max_entry() <= 0; };
  const std::vector<Case> cases = {
      {keep(sphere(0.8)), [](const Vec3& x) { return x.norm() <= 0.8; }, Vec3::constant(0.8), 1e-14},
      {keep(ellipsoid(half)), [&](const Vec3& x) { return x.over(half).norm() <= 1; }, half, 1e-14},
      {keep(box(half)), in_box, half, 1e-13},
      {keep(cylinder(0.5, 0.9)),
       [](const Vec3& x) { return std::hypot(x.x(), x.z()) <= 0.5 && std::fabs(x.y()) <= 0.9; }, Vec3(0.5, 0.9, 0.5),
       0.01},
      {keep(capsule(0.5, 0.9)),
       [](const Vec3& x) { return (x - Vec3(0, std::clamp<Real>(x.y(), -0.9, 0.9), 0)).norm() <= 0.5; },
       Vec3(0.5, 1.4, 0.5), 0.01},
  };
  for (const Case& c : cases) {
    Scene scene(1, std::pmr::new_delete_resource());
    TestWorld t;
    const std::uint32_t body = t.add(&c.shape, Vec3::zero());
    WaterDef water;
    t.world.set_water(&water);
    t.run(1, 1e-3);
    const std::uint32_t at = t.world.scene.water.float_of[t.world.scene.first_collider[body]];
    const Float* surface = at == kInvalid ? nullptr : &t.world.scene.water.floats[at];
    constexpr int kPlanes = 200, kPoints = 4000;
    std::vector<Vec3> cloud;
    while (cloud.size() < kPoints) {
      const Vec3 x = c.box.times(Vec3(unit(random), unit(random), unit(random)));
      if (c.has(x)) cloud.push_back(x);
    }
    for (int p = 0; p < kPlanes; ++p) {
      const Vec3 n = Vec3(unit(random), unit(random), unit(random)).normalized();
      const Real level = 1.5 * unit(random), V = c.shape.mass.volume;
      const Submerged under = under_plane(c.shape, surface, n, level),
                      above = under_plane(c.shape, surface, -n, -level);
      assert_true(std::fabs(under.volume + above.volume - V) <= 1e-13 * V);
      assert_true((under.moment + above.moment - V * c.shape.mass.centroid).norm() <= 1e-13 * V);
      Real inside = 0;
      Vec3 sum = Vec3::zero();
      for (const Vec3& x : cloud)
        if (n.dot(x) <= level) inside += 1, sum += x;
      // Five standard deviations of a binomial share: 0.04; of its middle likewise.
      const Real noise = 5 * std::sqrt(0.25 / kPoints);
      assert_true(std::fabs(under.volume / V - inside / kPoints) <= noise + c.tolerance);
      assert_true((under.moment / V - sum / kPoints).norm() <= 2 * (noise + c.tolerance) * c.box.norm());
    }
  }
}

static void hulls_of_points_displace_nearly_what_they_should(void**) {
  // Closed forms of what 256 points stand in for: a cylinder and a capsule half under, a cone up to a height.
  TestWorld t;
  const Shape* shapes[] = {t.keep(cylinder(0.5, 0.9)), t.keep(capsule(0.5, 0.9)), t.keep(cone(0.5, 0.9))};
  for (const Shape* s : shapes) t.add(s, Vec3(0, 100, 0));
  WaterDef water;
  t.world.set_water(&water);
  t.run(1, 1e-3);
  const auto share = [&](int k, const Vec3& n, Real level) {
    const Float& f = t.world.scene.water.floats[t.world.scene.water.float_of[static_cast<std::uint32_t>(k)]];
    return under_plane(*shapes[k], &f, n, level).volume / shapes[k]->mass.volume;
  };
  Real worst = 0;
  for (int i = -9; i <= 9; ++i) {
    const Real y = i * 0.1;
    worst = std::max(worst, std::fabs(share(0, Vec3::unit_y(), y) - (y + 0.9) / 1.8));
    const Real up = (0.9 - y) / 1.8;  // of the cone's height, above the plane; its apex is on top
    worst = std::max(worst, std::fabs(share(2, Vec3::unit_y(), y) - (1 - up * up * up)));
    const Real x = i * 0.05, segment = std::acos(x / 0.5) - x / 0.5 * std::sqrt(1 - x * x / 0.25);
    worst = std::max(worst, std::fabs(share(0, Vec3::unit_x(), x) - (1 - segment / std::numbers::pi)));
    const Real cap = std::numbers::pi * (0.5 + x) * (0.5 + x) * (1 - x) / 3;  // ends of the capsule, together a ball
    const Real tube = (std::numbers::pi - segment) * 0.25 * 1.8;
    worst = std::max(worst, std::fabs(share(1, Vec3::unit_x(), x) - (cap + tube) / shapes[1]->mass.volume));
  }
  assert_true(worst < 0.01);
}

static void what_floats_floats_at_its_density(void**) {
  TestWorld t(Vec3(0, -9.81, 0));
  const Shape *cube = t.keep(box(Vec3(0.5, 0.3, 0.5))), *ball = t.keep(sphere(0.5));
  const auto put = [&](const Shape* s, const Vec3& x, Real density) {
    BodyDef def;
    def.pose.p = x;
    const std::uint32_t body = handle_slot(t.world.add_body(def));
    t.world.add_collider(body, s, Pose{}, density, Colliders::kNoMaterial);
    return body;
  };
  const std::uint32_t wood = put(cube, Vec3(0, 0.5, 0), 600), cork = put(ball, Vec3(5, 0.5, 0), 500),
                      stone = put(ball, Vec3(10, 0.5, 0), 2500);
  WaterDef water;
  water.drag = 3;
  t.world.set_water(&water);
  t.run(1200, 1.0 / 60);
  // 0.6 of the box is under, half of the ball; the stone sinks at the speed at which drag bears its weight:
  // (2500 - 1000) g = 3 * 1000 v.
  assert_true(std::fabs(t.world.state.x[wood].y() - (0.3 - 0.36)) < 1e-9);
  assert_true(std::fabs(t.world.state.x[cork].y()) < 1e-9);
  assert_true(std::fabs(t.world.state.v[stone].y() + 1500 * 9.81 / 3000) < 1e-9);
  assert_true(t.world.state.x[stone].y() < -50);
}

static void a_box_bobs_at_its_frequency(void**) {
  // Upright, m y'' = -rho A g y while its faces are not under: a harmonic oscillator.
  const Real rho = 1000, g = 9.81, y0 = 0.1, T = 2;
  const Real w = std::sqrt(rho * 1.0 * g / (500 * 0.6));
  const auto error = [&](Real integrator) {
    return [=](int n) {
      TestWorld t(Vec3(0, -g, 0));
      t.world.set_dial(Dial::integrator, integrator);
      BodyDef def;
      def.pose.p = Vec3(0, y0, 0);
      const std::uint32_t body = handle_slot(t.world.add_body(def));
      t.world.add_collider(body, t.keep(box(Vec3(0.5, 0.3, 0.5))), Pose{}, 500, Colliders::kNoMaterial);
      WaterDef water;
      water.drag = 0;
      t.world.set_water(&water);
      t.run(n, T / n);
      return std::fabs(t.world.state.x[body].y() - y0 * std::cos(w * T));
    };
  };
  assert_true(std::fabs(order_of(error(kVerlet), 120) - 2) < 0.1);
  assert_true(std::fabs(order_of(error(kRk4), 40) - 4) < 0.3);
}

static void a_current_takes_along_and_a_plank_rights_itself(void**) {
  TestWorld t(Vec3(0, -9.81, 0));
  BodyDef def;
  def.pose = {exp_map(0.6 * Vec3::unit_x()), Vec3(0, 0.2, 0)};
  const std::uint32_t plank = handle_slot(t.world.add_body(def));
  t.world.add_collider(plank, t.keep(box(Vec3(0.5, 0.05, 1))), Pose{}, 500, Colliders::kNoMaterial);
  WaterDef water;
  water.drag = 2, water.current = Vec3(1.5, 0, 0);
  t.world.set_water(&water);
  t.run(3600, 1.0 / 60);
  const State& s = t.world.state;
  assert_true((s.v[plank] - Vec3(1.5, 0, 0)).norm() < 1e-6);
  assert_true((s.q[plank] * Vec3::unit_y() - Vec3::unit_y()).norm() < 1e-6);
  assert_true(std::fabs(s.x[plank].y()) < 1e-6);
}

static void who_hangs_together_sleeps_and_wakes_together(void**) {
  TestWorld t(Vec3(0, -9.81, 0));
  t.world.set_dial(Dial::sleep, 1);
  t.ground();
  const Shape* cube = t.keep(box(Vec3::constant(0.5)));
  const std::uint32_t a = t.add(cube, Vec3(0, 0.5, 0)), b = t.add(cube, Vec3(5, 0.5, 0));
  SpringDef s;
  s.body_a = a, s.body_b = b, s.rest = 5, s.stiffness = 20000, s.damping = 50;
  t.world.add_spring(s);
  t.run(240, 1.0 / 60);
  assert_true(t.world.asleep(a) && t.world.asleep(b));
  t.run(1, 1.0 / 60);
  assert_int_equal(t.world.plan->find("springs")->participants.count, 0);
  t.world.set_velocity(a, Vec3(-4, 0, 0), Vec3::zero());
  assert_true(!t.world.asleep(a) && !t.world.asleep(b));
  t.run(30, 1.0 / 60);
  assert_true(t.world.state.v[b].x() < -1);  // friction could bear 0.25 m of such a spring, and it is stretched by more
  t.run(600, 1.0 / 60);
  assert_true(t.world.asleep(a) && t.world.asleep(b));
  // What hangs on a kinematic body wakes when that moves.
  const std::uint32_t post = t.add(nullptr, Vec3(0, 3, 0), BodyType::kinematic);
  s.body_a = post, s.body_b = b, s.rest = 1;
  t.world.add_spring(s);
  t.run(1200, 1.0 / 60);
  t.world.set_velocity(post, Vec3(0, 0, 1), Vec3::zero());
  t.run(2, 1.0 / 60);
  assert_true(!t.world.asleep(b));
  t.world.remove_body(b);  // its springs go with it
  assert_int_equal(t.world.scene.springs.slots.alive_count(), 0);
  t.run(2, 1.0 / 60);
}

int main(void) {
  const CMUnitTest tests[] = {
      cmocka_unit_test(drag_alone_is_exact_at_any_step),
      cmocka_unit_test(runge_kutta_takes_drag_to_its_order),
      cmocka_unit_test(what_falls_through_air_reaches_its_terminal_speed),
      cmocka_unit_test(wind_takes_along_what_has_drag_and_nothing_else),
      cmocka_unit_test(a_uniform_field_ends_where_its_box_does),
      cmocka_unit_test(planets_go_round),
      cmocka_unit_test(fields_are_what_they_say),
      cmocka_unit_test(who_feels_a_field_is_who_shares_its_mask),
      cmocka_unit_test(springs_swing_as_they_should),
      cmocka_unit_test(a_spring_off_the_middle_turns_a_body),
      cmocka_unit_test(a_bungee_only_pulls),
      cmocka_unit_test(stiff_springs_stay_bounded),
      cmocka_unit_test(shares_under_water_add_up),
      cmocka_unit_test(hulls_of_points_displace_nearly_what_they_should),
      cmocka_unit_test(what_floats_floats_at_its_density),
      cmocka_unit_test(a_box_bobs_at_its_frequency),
      cmocka_unit_test(a_current_takes_along_and_a_plank_rights_itself),
      cmocka_unit_test(who_hangs_together_sleeps_and_wakes_together),
  };
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
