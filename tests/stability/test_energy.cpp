// The bound of kinetic energy that solver/direct/README.md proves, at work: every step of these scenes is watched, so that a
// solution of the convex problem which gives more ends the program. What drives give is counted as they give it.
#include <functional>
#include <numbers>
#include <random>
#include <vector>

#include "carom_test.h"
#include "joint_scenes.h"
#include "sliced.h"

using namespace carom;
using namespace carom::test;
using dynamics::JointKind;

namespace {

/// Draws that are the same everywhere.
class Draw {
 public:
  explicit Draw(unsigned seed) : engine_(seed) {}
  Real operator()(Real low, Real high) { return low + (high - low) * Real(engine_() / 4294967295.0); }

 private:
  std::mt19937 engine_;
};

std::uint32_t add(TestWorld& t, const Shape* shape, const Vec3& at, Real density, std::uint32_t material,
                  const Quat& turn = Quat::identity()) {
  BodyDef def;
  def.pose = {turn, at};
  const std::uint32_t body = handle_slot(t.world.add_body(def));
  t.world.add_collider(body, shape, Pose{}, density, material);
  return body;
}

void door(TestWorld& t, Draw& draw) {
  const std::uint32_t m = t.material(draw(0, 1), 0);
  t.ground(m);
  const Real width = draw(0.3, 2), height = draw(0.5, 2);
  const std::uint32_t leaf =
      add(t, t.keep(box(Vec3(width / 2, height / 2, 0.03))), Vec3(width / 2, height / 2, 0), draw(100, 2000), m);
  const std::uint32_t hinge = join(t, JointKind::hinge, kInvalid, leaf, Vec3::zero(), x_along(Vec3(0, 1, 0)));
  set_motor(t, hinge, Coordinate::twist, draw(-3, 3), draw(10, 1e4));
  add(t, t.keep(box(Vec3::constant(0.1))), Vec3(0.8 * width, 0.1, draw(-0.5, 0.5)), 500, m);
}

/// Planks between two posts, crates on them.
void bridge(TestWorld& t, Draw& draw) {
  t.ground();
  const int planks = static_cast<int>(draw(4, 12));
  const Real half = 0.25;
  const Shape* const plank = t.keep(box(Vec3(0.95 * half, 0.04, 0.5)));
  std::uint32_t before = kInvalid;
  for (int i = 0; i <= planks; ++i) {
    const std::uint32_t body =
        i == planks ? kInvalid : add(t, plank, Vec3((2 * i + 1) * half, 2, 0), 600, Colliders::kNoMaterial);
    for (const Real z : {-0.4, 0.4})
      join(t, JointKind::hinge, before, body, Vec3(2 * i * half, 2, z), x_along(Vec3(0, 0, 1)));
    before = body;
  }
  const Real ratio = std::pow(10.0, draw(0, 2));
  for (int i = 0; i < 4; ++i)
    add(t, t.keep(box(Vec3::constant(draw(0.1, 0.25)))), Vec3(draw(0, 2 * planks * half), 2.5 + 0.6 * i, 0),
        600 * ratio, Colliders::kNoMaterial);
}

/// A net of knots, held at its rim, and a ball that falls into it.
void net(TestWorld& t, Draw& draw) {
  const int side = static_cast<int>(draw(3, 6));
  const Real pitch = 0.3;
  const Shape* const ball = t.keep(sphere(0.25 * pitch));
  std::vector<std::uint32_t> knot;
  for (int i = 0; i < side; ++i)
    for (int k = 0; k < side; ++k) {
      const Vec3 at(pitch * i, 2, pitch * k);
      knot.push_back(t.add(ball, at));
      const std::size_t self = knot.size() - 1;
      if (i > 0) join(t, JointKind::ball, knot[self - side], knot[self], at - Vec3(pitch / 2, 0, 0));
      if (k > 0) join(t, JointKind::ball, knot[self - 1], knot[self], at - Vec3(0, 0, pitch / 2));
      if ((i == 0 || i == side - 1) && (k == 0 || k == side - 1)) join(t, JointKind::ball, kInvalid, knot[self], at);
    }
  const Real middle = pitch * (side - 1) / 2;
  add(t, t.keep(sphere(1.5 * pitch)), Vec3(middle, 2.8, middle), std::pow(10.0, draw(2, 4)), Colliders::kNoMaterial);
}

/// Limbs with limits and springs, down some stairs.
void doll(TestWorld& t, Draw& draw) {
  t.ground();
  for (int i = 0; i < 4; ++i)
    t.add(t.keep(box(Vec3(0.5, 0.1 + 0.1 * i, 1))), Vec3(-0.8 * i, 0.1 + 0.1 * i, 0), BodyType::fixed);
  const Vec3 at(draw(-2.5, -1.5), 2, 0);
  const std::uint32_t trunk = add(t, t.keep(box(Vec3(0.15, 0.25, 0.1))), at, 900, Colliders::kNoMaterial);
  const Shape* const limb = t.keep(capsule(0.06, 0.2));
  for (const Real side : {-1.0, 1.0})
    for (const Real end : {-1.0, 1.0}) {
      const Vec3 root = at + Vec3(0.2 * side, 0.25 * end, 0), out(0.22 * side, 0, 0);
      const std::uint32_t upper =
          add(t, limb, root + out, 900, Colliders::kNoMaterial, turn_between(Vec3(0, 1, 0), Vec3(1, 0, 0)));
      const std::uint32_t socket = join(t, JointKind::hinge, trunk, upper, root, x_along(Vec3(0, 0, 1)));
      set_limit(t, socket, Coordinate::twist, -1, 1);
      set_spring(t, socket, Coordinate::twist, draw(-0.5, 0.5), draw(0.5, 5), 1);
    }
  t.world.set_velocity(trunk, Vec3(draw(0, 4), 0, 0), Vec3(0, 0, draw(-5, 5)));
}

/// A wall comes down on a box that hangs on a hinge.
void pinch(TestWorld& t, Draw& draw) {
  t.ground();
  const std::uint32_t arm = add(t, t.keep(box(Vec3(0.3, 0.1, 0.2))), Vec3(0.3, 0.11, 0), 1000, Colliders::kNoMaterial);
  join(t, JointKind::hinge, kInvalid, arm, Vec3(0, 0.11, 0), x_along(Vec3(0, 0, 1)));
  for (int i = 0; i < 3; ++i) add(t, t.keep(sphere(0.08)), Vec3(0.2 + 0.2 * i, 0.3, 0), 1000, Colliders::kNoMaterial);
  const std::uint32_t press = t.add(t.keep(box(Vec3(1, 0.1, 1))), Vec3(0.3, 0.6, 0), BodyType::kinematic);
  t.world.set_velocity(press, Vec3(draw(-0.2, 0.2), -draw(0.1, 1), 0), Vec3(0, 0, draw(-0.3, 0.3)));
}

/// Wheels on motors and springs, over some bumps.
void car(TestWorld& t, Draw& draw) {
  const std::uint32_t m = t.material(1, 0);
  t.ground(m);
  for (int i = 0; i < 4; ++i)
    t.add(t.keep(box(Vec3(0.1, 0.05, 2))), Vec3(2 + draw(0, 4), 0, 0), BodyType::fixed, Quat::identity(), m);
  const std::uint32_t chassis = add(t, t.keep(box(Vec3(1, 0.2, 0.5))), Vec3(0, 0.75, 0), 300, m);
  const Shape* const wheel = t.keep(cylinder(0.3, 0.1));
  const Real speed = draw(-20, 20), torque = draw(20, 200);
  for (const Real x : {-0.8, 0.8})
    for (const Real z : {-0.7, 0.7}) {
      const Vec3 at(x, 0.31, z);
      const std::uint32_t hub = add_body(t, at, 10, Vec3::constant(0.1));
      const std::uint32_t strut = join(t, JointKind::slider, chassis, hub, at, x_along(Vec3(0, 1, 0)));
      set_spring(t, strut, Coordinate::slide, 0, draw(2, 6), 0.5);
      set_limit(t, strut, Coordinate::slide, -0.15, 0.15);
      const std::uint32_t round = add(t, wheel, at, 500, m, turn_between(Vec3(0, 1, 0), Vec3(0, 0, 1)));
      set_motor(t, join(t, JointKind::hinge, hub, round, at, x_along(Vec3(0, 0, 1))), Coordinate::twist, speed, torque);
    }
}

/// Two fingers on an arm that swings hold a cube.
void gripper(TestWorld& t, Draw& draw) {
  const std::uint32_t m = t.material(0.8, 0);
  const std::uint32_t arm = add(t, t.keep(box(Vec3(0.5, 0.03, 0.03))), Vec3(0.5, 1, 0), 500, m);
  set_motor(t, join(t, JointKind::hinge, kInvalid, arm, Vec3(0, 1, 0), x_along(Vec3(0, 1, 0))), Coordinate::twist,
            draw(-4, 4), 500);
  const Vec3 at(1.15, 1, 0);
  add(t, t.keep(box(Vec3::constant(0.05))), at, draw(200, 4000), m);
  for (const Real side : {-1.0, 1.0}) {
    const Vec3 pad = at + Vec3(0, 0, 0.0701 * side);
    const std::uint32_t finger = add(t, t.keep(box(Vec3(0.05, 0.04, 0.02))), pad, 1000, m);
    set_motor(t, join(t, JointKind::slider, arm, finger, pad, x_along(Vec3(0, 0, -side))), Coordinate::slide, 0.1, 300);
  }
}

/// A heavy ball on light links swings into a pile.
void wrecker(TestWorld& t, Draw& draw) {
  t.ground();
  const int links = static_cast<int>(draw(4, 12));
  std::uint32_t before = kInvalid;
  const Shape* const link = t.keep(box(Vec3(0.09, 0.02, 0.02)));
  for (int i = 0; i < links; ++i) {
    const std::uint32_t body = add(t, link, Vec3(-0.1 - 0.2 * i, 2.6, 0), 1000, Colliders::kNoMaterial);
    join(t, JointKind::ball, before, body, Vec3(-0.2 * i, 2.6, 0));
    before = body;
  }
  const Vec3 end(-0.2 * links, 2.6, 0);
  const std::uint32_t ball =
      add(t, t.keep(sphere(0.25)), end - Vec3(0.25, 0, 0), std::pow(10.0, draw(3, 5)), Colliders::kNoMaterial);
  join(t, JointKind::ball, before, ball, end);
  for (int i = 0; i < 6; ++i)
    add(t, t.keep(box(Vec3::constant(0.2))), Vec3(0.3 + 0.01 * i, 0.2 + 0.4 * i, 0), 800, Colliders::kNoMaterial);
}

/// Boxes made one in another, every other hinged to the one before.
void overlapped(TestWorld& t, Draw& draw) {
  t.ground();
  const Real half = draw(0.1, 0.3), pitch = draw(1.2, 1.7) * half;
  std::uint32_t before = kInvalid;
  for (int i = 0; i < 12; ++i) {
    const Vec3 at((i % 3) * pitch, half + (i / 6) * pitch, (i / 3 % 2) * pitch);
    const std::uint32_t body = t.add(t.keep(box(Vec3::constant(half))), at);
    if (i % 2) join(t, JointKind::hinge, before, body, (t.world.state.x[before] + at) / 2, x_along(Vec3(0, 1, 0)));
    before = body;
  }
}

/// Draws of one kind.   @param beyond  J, that steps whose work did not suffice have given more than they may
void watch(const char* what, void (*build)(TestWorld&, Draw&), Real beyond = 0) {
  const int seeds = sliced(12, 6, 1);
  for (int seed = 0; seed < seeds; ++seed) {
    TestWorld t;
    t.world.watches_stages = true;
    Draw draw(static_cast<unsigned>(seed));
    build(t, draw);
    if (seed % 3 == 1) t.world.set_dial(Dial::solver, kDirectChoice);
    const Real dt = seed % 2 ? 1.0 / 120 : 1.0 / 60;
    Real excess = 0, energy = 0;
    std::uint64_t newton = 0;
    for (int i = 0; i < 2 / dt; ++i) {
      t.world.step(dt);
      const dynamics::StepReport& report = t.world.report;
      excess += report.excess_energy, newton += newton_steps(t);
      energy = std::max(energy, report.linear_energy + report.angular_energy);
    }
    if (excess > beyond * energy) print_message("%s %d: %g of %g J\n", what, seed, double(excess), double(energy));
    assert_true(excess <= beyond * energy);
    assert_true(newton > 0);  // else nothing was looked at
  }
}

}  // namespace

static void doors_give_no_more_than_they_may(void**) { watch("door", door); }
static void nor_do_bridges(void**) { watch("bridge", bridge); }
static void nor_nets(void**) { watch("net", net); }
static void nor_limbs_on_stairs(void**) { watch("doll", doll); }
static void nor_what_surfaces_close_on(void**) { watch("pinch", pinch); }
static void nor_wheels_on_springs_and_motors(void**) { watch("car", car); }
static void nor_grippers_on_arms(void**) { watch("gripper", gripper); }
static void nor_a_heavy_ball_on_light_links(void**) { watch("wrecker", wrecker); }
static void nor_what_is_made_overlapping(void**) { watch("overlapped", overlapped); }

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(doors_give_no_more_than_they_may),
                              cmocka_unit_test(nor_do_bridges),
                              cmocka_unit_test(nor_nets),
                              cmocka_unit_test(nor_limbs_on_stairs),
                              cmocka_unit_test(nor_what_surfaces_close_on),
                              cmocka_unit_test(nor_wheels_on_springs_and_motors),
                              cmocka_unit_test(nor_grippers_on_arms),
                              cmocka_unit_test(nor_a_heavy_ball_on_light_links),
                              cmocka_unit_test(nor_what_is_made_overlapping)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
