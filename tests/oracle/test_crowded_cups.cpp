// Crowds of fast bodies: nothing gets out of a closed cup that a host moves fast, however often it is hit. Hits of a
// step are bounded, keep momentum and add no energy.
#include <functional>
#include <numbers>
#include <vector>

#include "carom_test.h"
#include "dynamics/body_state.h"
#include "dynamics/ccd/continuous.h"
#include "sliced.h"
#include "world_builder.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr Real kPi = std::numbers::pi;
const Real kShare = sliced<Real>(1, 0.5, 0.2);  // of the time that is run

/// Velocities of the cup, of a time in s.
struct Way {
  std::function<Vec3(Real)> v;                                          // m/s
  std::function<Vec3(Real)> omega = [](Real) { return Vec3::zero(); };  // rad/s
};

enum class Content { balls_and_dice, dice, hulls, slabs };

struct Scene {
  int sides;                       // of a prism about y, between two plates
  Real radius, half_height, wall;  // m, inside; half of its thickness
  int count;
  Real size;  // m
  Content content;
  Way way;
  int rate, substeps;  // Hz
  const char* solver = "auto";
};

struct Cup : TestWorld {
  explicit Cup(const Scene& scene, BodyType type = BodyType::kinematic, Real density = 1000) : s(scene) {
    world.set_dial(Dial::substeps, s.substeps);
    world.set_dial(Dial::solver, s.solver[0] == 's' ? kSoftChoice : kAutoChoice);
    const std::uint32_t m = material(0.4, 0);
    BodyDef def;
    def.type = type;
    def.pose.p = Vec3(0, 2, 0);
    body = handle_slot(world.add_body(def));
    const auto add_wall = [&](const Vec3& half, const Pose& at) {
      world.add_collider(body, keep(box(half)), at, density, m);
    };
    for (const int up : {-1, 1})
      add_wall(Vec3(s.radius, s.wall, s.radius), {Quat::identity(), Vec3(0, up * (s.half_height + s.wall), 0)});
    for (int k = 0; k < s.sides; ++k) {
      const Quat turn = exp_map(Vec3(0, -2 * kPi * k / s.sides, 0));
      add_wall(Vec3(s.wall, s.half_height, s.radius * std::tan(kPi / s.sides) + s.wall),
               {turn, turn * Vec3(s.radius - s.wall, 0, 0)});
    }
    fill(m);
  }
  void fill(std::uint32_t m) {
    const Real r = s.size;
    std::vector<Vec3> corners;
    for (int i = 0; i < 14; ++i) {
      const Real z = -1 + (2 * i + 1) / 14.0, a = 2.4 * i;
      const Vec3 level = exp_map(Vec3(0, 0, a)) * Vec3(std::sqrt(1 - z * z), 0, 0);
      corners.push_back(r * (level + Vec3(0, 0, z)));
    }
    const Shape* const ball = keep(sphere(r));
    const Shape* const die = keep(box(Vec3(r, r, r)));
    const Shape* const pebble = keep(hull(corners));
    const Shape* const slab = keep(box(Vec3(r, 0.45 * r, 0.9 * r)));
    const Shape* const disc = keep(cylinder(r, r));
    const Real low = 2 - s.half_height + 1.3 * r;
    for (int k = 0; k < s.count; ++k) {
      const Vec3 at(k % 3 - 1, k / 9, k / 3 % 3 - 1);
      const Shape* const shape = s.content == Content::slabs                ? (k % 3 == 2 ? disc : slab)
                                 : s.content == Content::hulls              ? pebble
                                 : s.content == Content::dice || k % 2 == 0 ? die
                                                                            : ball;
      held.push_back(add(shape, Vec3(0, low, 0) + (2.3 * r) * at, BodyType::dynamic, Quat::identity(), m));
    }
  }
  /// How many have their centre beyond the middle of a wall.
  int lost() const {
    int n = 0;
    const Pose cup = world.pose(body);
    for (const std::uint32_t i : held) {
      const Vec3 x = cup.q.conjugate() * (world.state.x[i] - cup.p);
      Real out = std::fabs(x.y()) - s.half_height - s.wall;
      for (int k = 0; k < s.sides; ++k)
        out = std::max(out, (exp_map(Vec3(0, -2 * kPi * k / s.sides, 0)) * Vec3::unit_x()).dot(x) - s.radius + s.wall);
      n += out > 0;
    }
    return n;
  }
  int lost_on_its_way(Real seconds) {
    const Real dt = 1.0 / s.rate;
    const int steps = static_cast<int>(kShare * seconds * s.rate);
    for (int i = 0; i < steps; ++i) {
      world.set_velocity(body, s.way.v(i * dt), s.way.omega(i * dt));
      world.step(dt);
    }
    return lost();
  }

  Scene s;
  std::uint32_t body;
  std::vector<std::uint32_t> held;
};

Vec3 along_x(Real v) { return Vec3(v, 0, 0); }
Way swept() {
  return {[](Real t) { return along_x(5 * std::sin(6 * t)); }};
}
Way shaken(Real speed) {
  return {[speed](Real t) { return Vec3(0, speed * std::sin(25 * t), 0); }};
}
Way circled() {
  return {[](Real t) { return Vec3(2 * std::cos(9 * t), 0, 2 * std::sin(9 * t)); }};
}
Way jerked(Real speed) {
  return {[speed](Real t) { return along_x(t > 0.3 && t < 0.4 ? speed : t >= 0.4 && t < 0.5 ? -speed : 0); }};
}
Way reversed(Real speed) {
  return {[speed](Real t) { return along_x(std::fmod(t, 0.2) < 0.1 ? speed : -speed); }};
}
Way slanted() {
  return {[](Real t) { return std::sin(17 * t) * Vec3(5, 2.5, -1.5); },
          [](Real t) { return Vec3(3 * std::sin(5 * t), 0, 2); }};
}
Way rocked() {
  return {[](Real) { return Vec3::zero(); }, [](Real t) { return Vec3(0, 0, 15 * std::sin(12 * t)); }};
}

void nothing_gets_out_of_a_cup(void**) {
  for (const Way& way : {swept(), shaken(3), circled(), jerked(20)})
    for (const Real size : {0.03, 0.008}) {
      Cup cup({12, 0.2, 0.15, 0.004, 12, size, Content::balls_and_dice, way, 60, 4});
      assert_int_equal(cup.lost_on_its_way(0.7), 0);
    }
}

// ---- held out: not looked at before the rest passed ----

void nor_out_of_others(void**) {
  const Scene scenes[] = {
      {6, 0.3, 0.2, 0.01, 18, 0.02, Content::hulls, reversed(5), 60, 1},
      {8, 0.1, 0.1, 0.003, 9, 0.012, Content::dice, slanted(), 120, 4},
      {16, 0.25, 0.1, 0.002, 20, 0.01, Content::balls_and_dice, jerked(10), 60, 4},
      {6, 1, 0.6, 0.01, 12, 0.05, Content::hulls, slanted(), 60, 4, "soft_step"},
      {12, 0.2, 0.15, 0.004, 27, 0.014, Content::dice, swept(), 60, 4, "soft_step"},
      {10, 0.15, 0.1, 0.001, 36, 0.006, Content::balls_and_dice, shaken(6), 240, 1},
      {9, 0.2, 0.12, 0.0025, 4, 0.004, Content::dice, reversed(8), 120, 1},
      {12, 0.2, 0.15, 0.0025, 30, 0.008, Content::hulls, jerked(20), 120, 4},
      {12, 0.2, 0.15, 0.002, 12, 0.01, Content::balls_and_dice, rocked(), 60, 4},
  };
  for (const Scene& s : scenes) {
    Cup cup(s);
    assert_int_equal(cup.lost_on_its_way(0.55), 0);
  }
}

/// Slabs and discs turn by radians a substep when a cup that reverses hits them: their rows are made anew, and sweeps
/// lead them elsewhere in the same substep.
void nor_slabs_out_of_one_that_reverses(void**) {
  for (const Real speed : {9.0, 11.0, 13.0})
    for (const Real wall : {0.002, 0.004, 0.01})
      for (const Real size : {0.012, 0.02, 0.03}) {
        static OneOf turn(1, 5);
        if (!turn.next()) continue;
        Cup cup({12, 0.2, 0.15, wall, 12, size, Content::slabs, reversed(speed), 60, 4});
        const int lost = cup.lost_on_its_way(2);
        if (lost > 0) print_error("%d lost at %g m/s, wall %g, size %g\n", lost, speed, wall, size);
        assert_int_equal(lost, 0);
      }
}

/// It falls, bounces, and is rolled about by what is in it.
void nor_out_of_one_that_is_thrown(void**) {
  for (const Real density : {300.0, 3000.0}) {
    Cup cup({12, 0.2, 0.15, 0.004, 12, 0.012, Content::balls_and_dice, {}, 60, 4}, BodyType::dynamic, density);
    cup.ground();
    cup.world.set_velocity(cup.body, Vec3(9, -6, 2), Vec3(3, 5, -14));
    cup.run(static_cast<int>(90 * kShare), 1.0 / 60);
    assert_int_equal(cup.lost(), 0);
  }
}

/// Cards that flutter hit each other again and again, at their corners in turn.
struct Cards : TestWorld {
  Cards(int count, const Vec3& gravity, Real thick, int seed) : TestWorld(gravity) {
    std::uint32_t state = static_cast<std::uint32_t>(seed);
    const auto any = [&](Real lo, Real hi) {
      state = state * 1664525u + 1013904223u;
      return lo + (hi - lo) * (state >> 8) / 16777216;
    };
    const Shape* const card = keep(box(Vec3(0.031, 0.044, thick / 2)));
    for (int i = 0; i < count; ++i) {
      const std::uint32_t b = add(card, Vec3(any(-0.03, 0.03), 0.05 + 0.02 * i, any(-0.03, 0.03)), BodyType::dynamic,
                                  exp_map(Vec3(any(0, 3), 0, 0)));
      world.set_velocity(b, Vec3::zero(), Vec3(any(-5, 5), any(-5, 5), any(-5, 5)));
    }
  }
  Real kinetic_energy() const {
    Real sum = 0;
    for (std::uint32_t i = 0; i < world.scene.bodies.slots(); ++i)
      if (world.scene.type[i] == BodyType::dynamic)
        sum += (world.scene.mass[i] * world.state.v[i].squared_norm() +
                world.state.omega[i].dot(inertia_at(world.scene, i, world.state.q[i]) * world.state.omega[i])) /
               2;
    return sum;
  }
};

void hits_of_cards_are_bounded(void**) {
  for (const int seed : {7, 8}) {
    Cards t(18, Vec3(0, -9.81, 0), 0.0005, seed);
    const std::uint32_t below = t.ground();
    Real may_fall = t.kinetic_energy();
    for (std::uint32_t i = 0; i < below; ++i) may_fall += t.world.scene.mass[i] * 9.81 * t.world.state.x[i].y();
    for (int i = 0; i < static_cast<int>(75 * kShare); ++i) {
      t.world.step(1.0 / 60);
      // Half of what bodies may be hit, and they come together once.
      assert_true(t.world.report.sweep_hits <= 4u * 18u * (SweptBody::kMostHits + 1));
      assert_true(t.kinetic_energy() <= may_fall);
      for (std::uint32_t k = 0; k < below; ++k) assert_true(t.world.state.x[k].y() > -0.001);
    }
  }
}

/// Without weight and ground: two packs that meet.
void what_goes_on_as_one_keeps_momentum(void**) {
  std::size_t hits = 0;
  for (const int seed : {1, 2, 3}) {
    Cards t(12, Vec3::zero(), 0.002, seed);
    for (std::uint32_t i = 0; i < 12; ++i)
      t.world.set_velocity(i, Vec3(0, i < 6 ? 4 : -4, 0.1 * i), t.world.state.omega[i]);
    const Vec3 before = momentum(t.world);
    Real energy = t.kinetic_energy();
    for (int i = 0; i < 30; ++i) {
      t.world.step(1.0 / 60);
      hits += t.world.report.sweep_hits;
      if (t.world.report.sweep_hits > 0) assert_true(t.kinetic_energy() <= energy * (1 + 1e-6));
      energy = t.kinetic_energy();
    }
    assert_true((momentum(t.world) - before).norm() < 1e-9 * 4 * 12 * t.world.scene.mass[0]);
  }
  assert_true(hits > 20);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(nothing_gets_out_of_a_cup),          cmocka_unit_test(nor_out_of_others),
      cmocka_unit_test(nor_slabs_out_of_one_that_reverses), cmocka_unit_test(nor_out_of_one_that_is_thrown),
      cmocka_unit_test(hits_of_cards_are_bounded),          cmocka_unit_test(what_goes_on_as_one_keeps_momentum),
  };
  return cmocka_run_group_tests_name("oracle/crowded_cups", tests, nullptr, nullptr);
}
