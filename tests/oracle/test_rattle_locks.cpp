// Bodies with locked axes in islands that joints alone hold: what their equations of motion say, to the order asked
// for.
#include <array>
#include <cmath>

#include "carom_test.h"
#include "rattle_scenes.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr Real kY = 2, kZ = 4, kAboutX = 8, kAboutY = 16, kAboutZ = 32, kAbout = kAboutX + kAboutY + kAboutZ;

void lock(TestWorld& t, std::uint32_t body, Real axes) { t.world.set_attribute(body, AttributeId::locks, {axes}); }

/// A rod on a cart that rolls along x without friction; the joint is a ball's, so that locks alone keep it in its
/// plane.
struct Cart {
  Real mass, rod, length, angle, spin;  // kg, kg, m, rad from hanging down, rad/s
  Vec3 inertia;                         // kg m^2, of the rod, whose y is along it

  std::array<Real, 4> rate(const std::array<Real, 4>& s) const {  // x, angle, x', angle'
    const Real l = length / 2, c = std::cos(s[1]), sine = std::sin(s[1]);
    const Real a = mass + rod, b = rod * l * c, d = inertia.z() + rod * l * l;
    const Real f = rod * l * s[3] * s[3] * sine, g = -rod * kG * l * sine, det = a * d - b * b;
    return {s[2], s[3], (d * f - b * g) / det, (a * g - b * f) / det};
  }
  /// Where the cart and its rod are.
  std::array<Real, 4> truth(Real time) const {
    std::array<Real, 4> s = {0, angle, 0, spin};
    constexpr int kSteps = 20000;
    const Real h = time / kSteps;
    const auto add = [](const std::array<Real, 4>& to, Real scale, const std::array<Real, 4>& what) {
      std::array<Real, 4> sum;
      for (std::size_t i = 0; i < 4; ++i) sum[i] = to[i] + scale * what[i];
      return sum;
    };
    for (int i = 0; i < kSteps; ++i) {
      const auto a = rate(s), b = rate(add(s, h / 2, a)), c = rate(add(s, h / 2, b)), d = rate(add(s, h, c));
      s = add(add(add(add(s, h / 6, a), h / 3, b), h / 3, c), h / 6, d);
    }
    return s;
  }
  /// m: by how far cart and rod are off. @param twist  of the rod about itself, so that its axes are not the world's
  Real error_of(int order, int steps, Real time, Real twist = 0) const {
    TestWorld t;
    by_rattle(t, order);
    const std::uint32_t cart = add_body(t, Vec3(0, 1, 0), mass, Vec3::constant(0.1));
    const Quat turned = exp_map(Vec3(0, 0, angle)) * exp_map(Vec3(0, twist, 0));
    const Vec3 down(std::sin(angle), -std::cos(angle), 0), along(std::cos(angle), std::sin(angle), 0);
    const std::uint32_t body =
        add_body(t, Vec3(0, 1, 0) + (length / 2) * down, rod, inertia, BodyType::dynamic, turned);
    lock(t, cart, kY + kZ + kAbout), lock(t, body, kZ + kAboutX + kAboutY);
    join(t, JointKind::ball, cart, body, Vec3(0, 1, 0));
    t.world.set_velocity(body, (spin * length / 2) * along, Vec3(0, 0, spin));
    for (int i = 0; i < steps; ++i) {
      t.world.step(time / steps);
      assert_int_equal(held(t), 1);
    }
    assert_true(t.world.state.x[cart].y() == 1 && t.world.state.x[cart].z() == 0 && t.world.state.x[body].z() == 0);
    assert_true(t.world.state.omega[body].x() == 0 && t.world.state.omega[body].y() == 0);
    const std::array<Real, 4> s = truth(time);
    const Real off = t.world.state.x[cart].x() - s[0];
    const Vec3 middle(s[0] + length / 2 * std::sin(s[1]), 1 - length / 2 * std::cos(s[1]), 0);
    return std::max(std::fabs(off), (t.world.state.x[body] - middle).norm());
  }
};

/// The order of the dial, for any masses and speeds.
void follows(const Cart& cart, Real time, int steps, Real twist = 0) {
  for (const int order : {2, 4, 6}) {
    const Real coarse = cart.error_of(order, steps, time, twist), fine = cart.error_of(order, 2 * steps, time, twist);
    std::printf("  order %d: %.2e m, halved %.2e m\n", order, coarse, fine);
    assert_true(coarse < (order == 2 ? 2e-2 : 1e-4));
    if (fine > 1e-11) assert_true(std::log2(coarse / fine) > order - 0.5);
  }
}

}  // namespace

static void a_rod_swings_on_a_cart(void**) { follows({2, 1, 1, 1.5, 0, Vec3(1.0 / 12, 1e-3, 1.0 / 12)}, 2, 240); }

/// Other masses, lengths and speeds; axes of inertia that are not the world's, a rod that goes over the top.
static void held_out_carts(void**) {
  follows({0.3, 2, 0.6, 0.4, 3, Vec3(0.07, 1e-3, 0.06)}, 1.3, 240);
  follows({40, 1, 2, 2.9, 0.5, Vec3(0.4, 0.02, 0.3)}, 2.5, 240);
  follows({1, 5, 1.2, -2, -6, Vec3::constant(0.5)}, 1, 200, 0.7);
}

/// A turn about one axis of the world alone, for a body none of whose own axes lies along it, is that on a hinge, whose
/// rows hold the same turns. The two flights between impulses differ, so their ends do by the error of the order.
static void a_crooked_body_turns_as_on_a_hinge(void**) {
  const auto apart = [](int axis, int steps) {
    TestWorld locked, hinged;
    const Vec3 about = Vec3::unit(axis), at(0.3, -0.2, 0.5);
    const Quat q = normalized(exp_map(Vec3(0.5, -0.9, 0.3)));
    for (TestWorld* t : {&locked, &hinged}) {
      by_rattle(*t, 4);
      const std::uint32_t body = add_body(*t, Vec3::zero(), 3, Vec3(0.5, 0.9, 1.2), BodyType::dynamic, q);
      if (t == &locked) lock(*t, body, kAbout - std::ldexp(kAboutX, axis));
      join(*t, t == &locked ? JointKind::ball : JointKind::hinge, kInvalid, body, at, x_along(about));
      t->world.set_velocity(body, (2 * about).cross(-1 * at), 2 * about);
      for (int i = 0; i < steps; ++i) t->world.step(1.5 / steps), assert_int_equal(held(*t), 1);
    }
    return (locked.world.state.x[0] - hinged.world.state.x[0]).norm() +
           (locked.world.state.omega[0] - hinged.world.state.omega[0]).norm();
  };
  for (const int axis : {0, 1, 2}) {
    const Real coarse = apart(axis, 90), fine = apart(axis, 180);
    std::printf("  axis %d: %.2e, halved %.2e\n", axis, coarse, fine);
    assert_true(coarse < 1e-4 && (fine < 1e-12 || std::log2(coarse / fine) > 3.5));
  }
}

/// A body that may turn about two axes of the world is no top: the solver moves it.
static void two_free_turns_are_left_to_the_solver(void**) {
  TestWorld t;
  by_rattle(t, 4);
  const std::uint32_t body = add_body(t, Vec3::zero(), 3, Vec3(0.5, 0.9, 1.2));
  lock(t, body, kAboutX);
  join(t, JointKind::ball, kInvalid, body, Vec3(0.3, 0.4, 0.1));
  t.world.step(1.0 / 60);
  assert_int_equal(held(t), 0);
  lock(t, body, 0);
  t.world.step(1.0 / 60);
  assert_int_equal(held(t), 1);
}

/// Energy of a cart and its rod over 10,000 steps swings and does not drift.
static void energy_stays(void**) {
  TestWorld t;
  by_rattle(t, 2, 2);
  const std::uint32_t cart = add_body(t, Vec3(0, 1, 0), 2, Vec3::constant(0.1));
  const std::uint32_t rod =
      add_body(t, Vec3(0.5, 1, 0), 1, Vec3(1.0 / 12, 1e-3, 1.0 / 12), BodyType::dynamic, exp_map(Vec3(0, 0, kPi / 2)));
  lock(t, cart, kY + kZ + kAbout), lock(t, rod, kZ + kAboutX + kAboutY);
  join(t, JointKind::ball, cart, rod, Vec3(0, 1, 0));
  Real most[2] = {};
  const Real before = energy_of(t);
  for (int i = 0; i < 10000; ++i) {
    t.world.step(1.0 / 60);
    Real& of = most[i >= 5000];
    of = std::max(of, std::fabs(energy_of(t) - before));
  }
  std::printf("  energy off by %.2e J, then %.2e J\n", most[0], most[1]);
  assert_true(most[1] < 1.01 * most[0] && most[0] < 1e-2);
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(a_rod_swings_on_a_cart),
      cmocka_unit_test(held_out_carts),
      cmocka_unit_test(a_crooked_body_turns_as_on_a_hinge),
      cmocka_unit_test(two_free_turns_are_left_to_the_solver),
      cmocka_unit_test(energy_stays),
  };
  return cmocka_run_group_tests_name("oracle/rattle_locks", tests, nullptr, nullptr);
}
