// What touches a flat surface along a line, or two surfaces, or slides on a point: closed forms and fine integrations of
// their equations of motion.
#include <cmath>
#include <functional>

#include "carom_test.h"
#include "dynamics/body_state.h"
#include "dynamics/contact/lone_rollers.h"
#include "joint_scenes.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr Real kPi = 3.14159265358979323846;

/// A motion with one angle: th'' = f(th, th'), by the classical method in steps so fine that rounding is left.
struct Angle {
  Real th, rate;
  void run(const std::function<Real(Real, Real)>& f, Real time) {
    const int n = std::max(1, static_cast<int>(time / 1e-4));
    const Real h = time / n;
    for (int i = 0; i < n; ++i) {
      const Real a1 = f(th, rate), b1 = rate, a2 = f(th + h / 2 * b1, rate + h / 2 * a1), b2 = rate + h / 2 * a1;
      const Real a3 = f(th + h / 2 * b2, rate + h / 2 * a2), b3 = rate + h / 2 * a2, a4 = f(th + h * b3, rate + h * a3),
                 b4 = rate + h * a3;
      th += h / 6 * (b1 + 2 * (b2 + b3) + b4), rate += h / 6 * (a1 + 2 * (a2 + a3) + a4);
    }
  }
};

MassGiven given(Real mass, const Vec3& inertia) {
  MassGiven m;
  m.has_inertia = m.has_center = true;
  m.mass = mass, m.inertia = Mat3::diagonal(inertia), m.center = Vec3::zero();
  return m;
}

/// A cone that lies on a slope swings about its apex as a pendulum.
/// @return rad, at worst
Real cone_on_slope(Real height, Real half_angle, Real slope, Real from, Real time, int steps) {
  TestWorld t;
  const std::uint32_t rough = t.material(2, 0);
  t.world.scene.gravity = kG * Vec3(std::sin(slope), -std::cos(slope), 0);
  t.ground(rough);
  const Real radius = height * std::tan(half_angle), c = std::cos(half_angle);
  const Vec3 axis(c * std::cos(from), std::sin(half_angle), c * std::sin(from));  // from the apex to the base
  const std::uint32_t body = t.add(t.keep(cone(radius, height / 2)), height / 2 * axis, BodyType::dynamic,
                                   turn_between(Vec3(0, 1, 0), -1 * axis), rough);
  const Real k = kG * std::sin(slope) * 0.75 * height * c / (0.15 * height * height * (1 + 5 * c * c));
  Angle truth{from, 0};
  Real worst = 0;
  for (int i = 0; i < steps; ++i) {
    t.world.step(time / steps);
    truth.run([&](Real th, Real) { return -k * std::sin(th); }, time / steps);
    const Vec3 now = t.world.state.q[body] * Vec3(0, -1, 0);
    worst = std::max(worst, std::fabs(std::atan2(now.z(), now.x()) - truth.th));
  }
  std::printf("  cone of %.2g m, %.2g rad, on %.2g rad, %d steps: %.2e rad\n", height, half_angle, slope, steps, worst);
  return worst;
}

/// A rod with round ends slides down a wall and a floor, friction that of both, leaves the wall by itself, and slides on.
/// @return m, of its middle, at worst
Real ladder(Real half, Real radius, Real from, Real friction, Real until, Real dt) {
  TestWorld t;
  const std::uint32_t smooth = t.material(friction, 0);
  t.ground(smooth);
  t.add(t.keep(half_space(Vec3(1, 0, 0), 0)), Vec3::zero(), BodyType::fixed, Quat::identity(), smooth);
  const Vec3 up(-std::cos(from), std::sin(from), 0);  // towards the wall
  const std::uint32_t body =
      t.add(t.keep(capsule(radius, half)), Vec3(radius + half * std::cos(from), radius + half * std::sin(from), 0),
            BodyType::dynamic, turn_between(Vec3(0, 1, 0), up), smooth);
  const Real inertia = half * half / 3;
  t.world.set_mass(body, given(1, Vec3(inertia, 1e-3, inertia)));
  // x = r + a cos th, y = r + a sin th until the load of the wall is 0; then the floor alone holds the lower end.
  const Real a = half, mu = friction;
  struct Loads {
    Real wall, floor, turn;  // N, N, rad/s^2
  };
  const auto on_both = [&](Real th, Real w) {
    // Ends slide along +x and -y: friction -mu N along the floor, +mu W up the wall. th'' = p is looked for:
    //   m x'' = W - mu N, m y'' = N + mu W - m g; torque about the middle, from the ends' arms
    const Real c = std::cos(th), s = std::sin(th), xdd0 = -a * c * w * w, ydd0 = -a * s * w * w;
    const auto loads = [&](Real p) {
      const Real fx = xdd0 - a * s * p, fy = ydd0 + a * c * p + kG;
      const Real floor = (fy - mu * fx) / (1 + mu * mu), wall = fx + mu * floor;
      return Loads{wall, floor, 0};
    };
    const auto torque = [&](Real p) {  // about z by the angle th, which turns the other way
      const Loads l = loads(p);
      // lower end (+a c, -a s) + the radius down, upper end (-a c, +a s) + the radius to the wall
      const Real lower = (a * c) * l.floor - (-a * s - radius) * (-mu * l.floor);
      const Real upper = (-a * c - radius) * (mu * l.wall) - (a * s) * l.wall;
      return -(lower + upper) - inertia * p;
    };
    const Real p = -torque(0) / (torque(1) - torque(0));
    Loads l = loads(p);
    l.turn = p;
    return l;
  };
  const auto on_floor = [&](Real th, Real w) {
    const Real c = std::cos(th), s = std::sin(th);
    const auto torque = [&](Real p) {
      const Real floor = -a * s * w * w + a * c * p + kG;
      return -((a * c) * floor - (-a * s - radius) * (-mu * floor)) - inertia * p;
    };
    return -torque(0) / (torque(1) - torque(0));
  };
  Angle truth{from, 0};
  Real x = radius + a * std::cos(from), vx = 0, worst = 0;
  bool is_off = false;
  const int parts = 100;
  while (truth.th > until) {
    t.world.step(dt);
    for (int i = 0; i < parts; ++i) {
      const Real h = dt / parts;
      if (!is_off && !(on_both(truth.th, truth.rate).wall > 0)) is_off = true;
      if (is_off) {
        const Real c = std::cos(truth.th), s = std::sin(truth.th), w = truth.rate;
        const Real floor = -a * s * w * w + a * c * on_floor(truth.th, w) + kG;
        x += h * vx - h * h / 2 * mu * floor, vx -= h * mu * floor;
        truth.run(on_floor, h);
      } else {
        truth.run([&](Real th, Real w) { return on_both(th, w).turn; }, h);
        x = radius + a * std::cos(truth.th), vx = -a * std::sin(truth.th) * truth.rate;
      }
    }
    const Vec3 p = t.world.state.x[body];
    if (truth.th > until) worst = std::max(worst, std::hypot(p.x() - x, p.y() - (radius + a * std::sin(truth.th))));
  }
  std::printf("  ladder of %g m from %.2g rad, friction %g, steps of 1/%.0f s: %.2e m%s\n", 2 * half, from, friction,
              1 / dt, worst, is_off ? "" : ", never off the wall");
  return worst;
}

/// A box that tips about an edge, which friction holds: a pendulum upside down.
/// @return rad, at worst
Real tipping(const Vec3& half, Real lean, Real time, int steps) {
  TestWorld t;
  const std::uint32_t rough = t.material(3, 0);
  t.ground(rough);
  const Real arm = std::hypot(half.x(), half.y()), rest = std::atan2(half.x(), half.y());
  const Quat q = exp_map(lean * Vec3(0, 0, 1));  // about its left edge, to the left
  const Vec3 to_edge = q * Vec3(-half.x(), -half.y(), 0);
  const std::uint32_t body = t.add(t.keep(box(half)), -1 * to_edge, BodyType::dynamic, q, rough);
  const Real inertia = arm * arm * 4 / 3;  // about the edge, of 1 kg
  Angle truth{lean, 0};
  Real worst = 0;
  for (int i = 0; i < steps; ++i) {
    t.world.step(time / steps);
    truth.run([&](Real th, Real) { return kG * arm * std::sin(th - rest) / inertia; }, time / steps);
    const Vec3 x = t.world.state.q[body] * Vec3(1, 0, 0);
    worst = std::max(worst, std::fabs(std::atan2(x.y(), x.x()) - truth.th));
  }
  std::printf("  box %g x %g m tips from %.2g to %.2g rad, %d steps: %.2e rad\n", half.x(), half.y(), lean, truth.th,
              steps, worst);
  return worst;
}

}  // namespace

static void a_cone_swings_on_a_slope(void**) {
  const Real coarse = cone_on_slope(1, 25 * kPi / 180, 10 * kPi / 180, 0.5, 4, 240);
  assert_true(coarse < 1e-5);
}
static void a_ladder_slides_down(void**) { assert_true(ladder(1, 0.02, kPi / 3, 0, 0.1, 1.0 / 60) < 1e-4); }
static void a_box_tips_about_its_edge(void**) { assert_true(tipping(Vec3(0.2, 0.5, 0.3), 0.45, 0.7, 42) < 1e-6); }

// ---- held out: not looked at before the rest passed ----

static void held_out_cones(void**) {
  assert_true(cone_on_slope(0.3, 40 * kPi / 180, 0.05, -1, 3, 180) < 1e-5);
  assert_true(cone_on_slope(2, 10 * kPi / 180, 0.2, 2, 5, 150) < 1e-4);
  assert_true(cone_on_slope(1, 55 * kPi / 180, 0.1, 0.3, 4, 480) < 1e-5);
}
static void held_out_ladders(void**) {
  assert_true(ladder(0.2, 0.01, 1.2, 0, 0.2, 1.0 / 120) < 1e-4);
  assert_true(ladder(3, 0.1, 0.8, 0.1, 0.1, 1.0 / 60) < 1e-3);
  assert_true(ladder(1, 0.05, 1.0, 0.2, 0.15, 1.0 / 240) < 1e-3);
}
static void held_out_boxes(void**) {
  assert_true(tipping(Vec3(0.5, 0.5, 0.5), 0.8, 0.6, 60) < 1e-5);
  assert_true(tipping(Vec3(0.05, 0.3, 0.1), 0.1, 0.25, 15) < 1e-5);
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(a_cone_swings_on_a_slope),  cmocka_unit_test(a_ladder_slides_down),
      cmocka_unit_test(a_box_tips_about_its_edge), cmocka_unit_test(held_out_cones),
      cmocka_unit_test(held_out_ladders),          cmocka_unit_test(held_out_boxes),
  };
  return cmocka_run_group_tests_name("oracle/lone_leaners", tests, nullptr, nullptr);
}
