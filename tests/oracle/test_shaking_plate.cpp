// A block on a plate that a spring shakes: it sticks, slides and sticks again, as the fine integration of two masses with
// dry friction between them says. By frame the error is of second order.
#include <cmath>

#include "carom_test.h"
#include "joint_scenes.h"

using namespace carom;
using namespace carom::test;

namespace {

struct Shaken {
  Real plate, block;  // kg
  Real rate;          // rad/s, of the plate alone on its spring
  Real friction, speed, time;

  struct Places {
    Real plate, block;  // m
  };

  /// By halving into the moment at which friction turns; else the exact motion under a constant friction force, in parts
  /// of 1e-5 rad of a swing, by the method of Verlet.
  Places truth() const {
    const Real k = plate * rate * rate, bear = friction * kG, whole = plate + block;
    const int n = static_cast<int>(time * rate * 1e5);
    const Real h = time / n;
    Real x = 0, v = speed, y = 0, w = speed, side = 0;  // of the plate, of the block; side: of its friction, 0: sticks
    for (int i = 0; i < n; ++i) {
      if (side == 0 && std::fabs(k * x / whole) > bear) side = x > 0 ? 1 : -1;  // it runs ahead, or is left behind
      const auto pull = [&](Real at) { return side == 0 ? -k * at / whole : (-k * at + side * block * bear) / plate; };
      const Real v_half = v + h / 2 * pull(x), x_next = x + h * v_half, v_next = v_half + h / 2 * pull(x_next);
      if (side == 0) {
        y += x_next - x, w = v_next;
      } else {
        const Real w_next = w - side * bear * h;
        y += h * (w + w_next) / 2, w = w_next;
        if ((w - v_next) * side < 0) w = v_next, side = 0;
      }
      x = x_next, v = v_next;
    }
    return {x, y};
  }

  Places run(int steps) const {
    TestWorld t;
    const std::uint32_t m = t.material(friction, 0);
    const auto add = [&](const Vec3& half, Real y, Real mass) {
      const std::uint32_t body = t.add(t.keep(box(half)), Vec3(0, y, 0), BodyType::dynamic, Quat::identity(), m);
      MassGiven given;
      given.mass = mass;
      t.world.set_mass(body, given);
      t.world.set_velocity(body, Vec3(speed, 0, 0), Vec3::zero());
      return body;
    };
    const std::uint32_t below = add(Vec3(2, 0.1, 2), -0.1, plate), above = add(Vec3(0.1, 0.1, 0.1), 0.1, block);
    const std::uint32_t rail = join(t, JointKind::slider, kInvalid, below, Vec3(0, -0.1, 0), x_along(Vec3(1, 0, 0)));
    set_spring(t, rail, Coordinate::slide, 0, rate / (2 * std::acos(Real(-1))), 0);
    t.run(steps, time / steps);
    return {t.world.state.x[below].x(), t.world.state.x[above].x()};
  }

  struct Errors {
    Real plate, block;
  };
  Errors errors(int steps) const {
    const Places is = run(steps), ought = truth();
    const Errors e{std::fabs(is.plate - ought.plate), std::fabs(is.block - ought.block)};
    std::printf("  %g and %g kg, %g rad/s, friction %g, %d steps: plate %.2e, block %.2e m of %.3g\n", plate, block,
                rate, friction, steps, e.plate, e.block, ought.block);
    return e;
  }
};

/// Both errors are no more than so much, and a quarter of it at twice the steps, and a quarter of that again. Single
/// runs scatter: when a slide begins or ends within a step is a matter of the step.
void second_order(const Shaken& s, int steps, Real plate, Real block) {
  for (int halvings = 0; halvings < 3; ++halvings, steps *= 2, plate /= 4, block /= 4) {
    const Shaken::Errors e = s.errors(steps);
    assert_true(e.plate < plate && e.block < block);
  }
}

}  // namespace

static void a_block_sticks_and_slides(void**) { second_order({1000, 1, 5, 0.5, 1.5, 3}, 180, 1e-4, 1e-4); }

// ---- held out: not looked at before the rest passed ----

/// Single runs scatter, so of all together: eight times the steps leave less than a twentieth. First order left an eighth,
/// second a 64th.
static void held_out_plates(void**) {
  Real coarse = 0, fine = 0;
  for (const Shaken& s : {Shaken{50, 1, 20, 0.3, 1, 2}, Shaken{20, 5, 8, 0.2, 0.8, 3}, Shaken{3, 2, 4, 0.4, 2, 4},
                          Shaken{1000, 1, 5, 0.9, 1.5, 3}}) {
    const int steps = static_cast<int>(60 * s.time);
    coarse += s.errors(steps).block, fine += s.errors(8 * steps).block;
  }
  assert_true(fine < coarse / 20);
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(a_block_sticks_and_slides),
      cmocka_unit_test(held_out_plates),
  };
  return cmocka_run_group_tests_name("oracle/shaking_plate", tests, nullptr, nullptr);
}
