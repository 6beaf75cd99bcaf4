// What surfaces close on: no velocity obeys the law, and yet nothing gains more than those surfaces could give.
#include <numbers>

#include "carom_test.h"
#include "joint_scenes.h"
#include "sliced.h"

using namespace carom;
using namespace carom::test;

namespace {

/// Numbers from 0 to 1, the same everywhere.
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : state_(seed * 2862933555777941757u + 3037000493u) {}
  Real operator()() {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return static_cast<Real>(state_ >> 11) * 0x1p-53;
  }
  Real operator()(Real low, Real high) { return low + (high - low) * (*this)(); }

 private:
  std::uint64_t state_;
};

Quat turned_about(const Vec3& axis, Real angle) {
  const Vec3 u = std::sin(angle / 2) * axis;
  return {std::cos(angle / 2), u.x(), u.y(), u.z()};
}

/// A turn about any axis, by angles from 0 to `most`, rad. (What is drawn stands in braces: arguments have no order.)
Quat any_turn(Draw& draw, Real most) {
  const Vec3 axis{draw(-1, 1), draw(-1, 1), draw(-1, 1)};
  return turned_about(axis.normalized(), draw(0, most));
}

/// What is deep between surfaces that went through it gets several times that at once where normals jump: 2.7 times was
/// seen in 840 scenes. Before pinches were found, energies grew by factors of 1e5 to 1e10; by the exact law, which has
/// an answer where surfaces close at a small angle, by up to 900.
constexpr Real kSqueezedMore = 4;

struct Pinch {
  TestWorld t;
  std::vector<std::uint32_t> bodies, jaws;
  Real speed = 0;  // m/s, of the fastest surface
  Real friction = 0;
};

/// Some bodies in a box of static walls, into which plates are driven.
void draw_pinch(Pinch& p, std::uint64_t seed) {
  Draw draw(seed);
  TestWorld& t = p.t;
  t.world.set_dial(Dial::continuous, 0);  // of what solvers do
  p.friction = draw(0.1, 1.2);
  const std::uint32_t m = t.material(p.friction, 0);
  t.ground(m);
  const Real size = draw() < 0.5 ? draw(0.02, 0.1) : draw(0.1, 1), room = draw(1.5, 3) * size;
  const Shape* wall = t.keep(box(Vec3(0.1 * size, 4 * size, 4 * size)));
  t.add(wall, Vec3(-room - 0.1 * size, 4 * size, 0), BodyType::fixed, Quat::identity(), m);
  const std::uint32_t jaw =
      t.add(wall, Vec3(room + 0.1 * size, 4 * size, 0), BodyType::kinematic, any_turn(draw, 0.3), m);
  p.jaws = {jaw};
  p.speed = draw(0.05, 2) * size;
  const Vec3 way{draw(-1, 1), draw(-1, 1), draw(-1, 1)}, spin = way * (draw() * 0.3);
  t.world.set_velocity(jaw, Vec3{-p.speed, draw(-0.5, 0.5) * p.speed, draw(-0.5, 0.5) * p.speed}, spin);
  p.speed = 2 * p.speed + spin.norm() * 8 * size;
  const int count = 1 + static_cast<int>(draw() * 6);
  for (int i = 0; i < count; ++i) {
    const Shape* shape = nullptr;
    const Real r = draw(0.3, 0.5) * size;
    switch (static_cast<int>(draw() * 4)) {
      case 0:
        shape = t.keep(sphere(r));
        break;
      case 1:
        shape = t.keep(box(Vec3{r, draw(0.3, 1) * r, draw(0.3, 1) * r}));
        break;
      case 2:
        shape = t.keep(capsule(0.5 * r, 0.5 * r));
        break;
      default:
        shape = t.keep(cylinder(0.6 * r, 0.8 * r));
        break;
    }
    BodyDef def;
    def.pose.p = Vec3{draw(-0.8, 0.8) * size, (0.6 + 1.1 * i) * size, draw(-0.3, 0.3) * size};
    def.pose.q = any_turn(draw, 3);
    p.bodies.push_back(handle_slot(t.world.add_body(def)));
    const Real density = draw() < 0.3 ? draw(10, 100) : draw(500, 8000);
    t.world.add_collider(p.bodies.back(), shape, Pose{}, density, m);
  }
}

/// Steps a scene until its jaw has crossed it.
/// @return the largest energy of motion, over what falls and surfaces could give. Two surfaces that close at a small
///         angle squeeze out what is between them at their speed over the angle, and hold it where friction is more
///         than that: so no faster than 1 / mu of theirs.
Real worst_energy(Pinch& p, Real dt) {
  World& w = p.t.world;
  const State& s = w.state;
  Real given = 0, lifted = 0, worst = 0;
  const auto height = [&] {
    Real sum = 0;
    for (const std::uint32_t b : p.bodies) sum += w.scene.mass[b] * kG * s.x[b].y();
    return sum;
  };
  const Real push = w.scene.dials[Dial::push_speed];
  const Real squeezed = p.speed * (1 + 1 / p.friction);
  for (const std::uint32_t b : p.bodies) given += w.scene.mass[b] * (squeezed * squeezed + push * push) / 2;
  for (int i = 0; i < 240; ++i) {
    lifted = std::max(lifted, height());
    w.step(dt);
    Real motion = 0;
    for (const std::uint32_t b : p.bodies) {
      assert_true(finite(s.x[b]) && finite(s.v[b]));
      const Vec3 spin = s.q[b].conjugate() * s.omega[b];
      motion += w.scene.mass[b] * s.v[b].squared_norm() / 2 + spin.dot(w.scene.inertia[b] * spin) / 2;
    }
    worst = std::max(worst, motion / (given + lifted - std::min(lifted, height()) + 0.05 * lifted));
  }
  return worst;
}

}  // namespace

static void what_a_jaw_closes_on_is_not_shot_out(void**) {
  Real worst = 0;
  for (std::uint64_t seed = 1; seed <= sliced<std::uint64_t>(60, 20, 4); ++seed)
    for (const int solver : {kDirectChoice, kAutoChoice}) {
      Pinch p;
      draw_pinch(p, seed);
      p.t.world.set_dial(Dial::solver, solver);
      const Real of = worst_energy(p, 1.0 / 60);
      if (of > kSqueezedMore)
        print_error("seed %llu, solver %d: %g\n", static_cast<unsigned long long>(seed), solver, of);
      worst = std::max(worst, of);
    }
  assert_true(worst < kSqueezedMore);
}
/// Scenes in which the exact law shot out what it could not hold, and their neighbours. Not looked at before it was mended:
/// 2001 to 2300, of which those stand here.
static void what_the_law_would_shoot_out_yields(void**) {
  for (const std::uint64_t seed : {2031, 2045, 2060, 2100, 2160, 2207, 2250}) {
    Pinch p;
    draw_pinch(p, seed);
    p.t.world.set_dial(Dial::solver, kDirectChoice);
    assert_true(worst_energy(p, 1.0 / 60) < kSqueezedMore);
  }
}
static void at_other_steps_neither(void**) {
  Real worst = 0;
  for (std::uint64_t seed = 1001; seed <= 1000 + sliced<std::uint64_t>(60, 20, 4); ++seed)
    for (const Real rate : {30, 120}) {
      Pinch p;
      draw_pinch(p, seed);
      const Real of = worst_energy(p, 1 / rate);
      if (of > kSqueezedMore) print_error("seed %llu, rate %g: %g\n", static_cast<unsigned long long>(seed), rate, of);
      worst = std::max(worst, of);
    }
  assert_true(worst < kSqueezedMore);
}

/// A ball between the ground and a plate that comes down: no velocity obeys the law. It stays where it is.
static void a_ball_under_a_press(void**) {
  for (const Real speed : {0.01, 0.1, 1.0}) {
    TestWorld t;
    t.ground();
    const std::uint32_t ball = t.add(t.keep(sphere(0.1)), Vec3(0, 0.1, 0));
    const std::uint32_t plate = t.add(t.keep(box(Vec3(1, 0.1, 1))), Vec3(0, 0.3 + 0.1 * speed, 0), BodyType::kinematic);
    t.world.set_velocity(plate, Vec3(0, -speed, 0), Vec3::zero());
    std::uint64_t wedged = 0;
    for (int i = 0; i < 12 + static_cast<int>(1 / speed); ++i) {
      t.world.step(1.0 / 60);
      wedged += t.world.report.wedged_groups;
      assert_true(t.world.state.v[ball].norm() < 3 * speed + kG / 60);
    }
    (void)wedged;
    const Vec3 x = t.world.state.x[ball];
    assert_true(std::fabs(x.x()) < 0.01 && std::fabs(x.z()) < 0.01);
  }
}

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(what_a_jaw_closes_on_is_not_shot_out),
                              cmocka_unit_test(what_the_law_would_shoot_out_yields),
                              cmocka_unit_test(at_other_steps_neither), cmocka_unit_test(a_ball_under_a_press)};
  return cmocka_run_group_tests_name("stability/pinched", tests, nullptr, nullptr);
}
