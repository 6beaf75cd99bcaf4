// No cliff between regimes: the same motion with something beside that nobody sees, a drag, a field, a spring, a motor of
// 1e-15, a limit out of reach, a collider or a body that touches nothing. Not exactness is asked here, which other tests
// hold each scene to, but that what is exact stays so.
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "carom_test.h"
#include "rattle_scenes.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr Real kHair = 1e-15, kDt = 1.0 / 60;
constexpr int kSteps = 120;
const Vec3 kZ(0, 0, 1);

/// What a scene has: bodies that are watched, and joints that may be driven.
struct Scene {
  TestWorld t;
  std::vector<std::uint32_t> bodies, joints;
  std::uint32_t rough = t.material(1, 0), smooth = t.material(0.1, 0);

  std::uint32_t solid(const Shape& shape, const Vec3& at, const Quat& q, std::uint32_t material) {
    bodies.push_back(t.add(t.keep(shape), at, BodyType::dynamic, q, material));
    return bodies.back();
  }
  std::uint32_t link(const Vec3& at, Real mass, const Vec3& inertia) {
    bodies.push_back(add_body(t, at, mass, inertia));
    return bodies.back();
  }
  std::uint32_t hold(JointKind kind, std::uint32_t a, std::uint32_t b, const Vec3& at, const Quat& axes = x_along(kZ)) {
    joints.push_back(join(t, kind, a, b, at, axes));
    return joints.back();
  }
};

using Build = std::function<void(Scene&)>;
struct Named {
  const char* what;
  Build build;
};

/// A disc or a top that leans by `lean`, its lowest point at the origin, where it does not slip, turning about the vertical and its own axis.
void lean_on_floor(Scene& s, const Shape& shape, const Vec3& low, Real lean, Real round, Real spin) {
  s.t.ground(s.rough);
  const Quat q = exp_map(-lean * kZ);
  const Vec3 at = -1 * (q * low), omega = round * Vec3(0, 1, 0) + spin * (q * Vec3(0, 1, 0));
  const std::uint32_t body = s.solid(shape, at, q, s.rough);
  s.t.world.set_velocity(body, omega.cross(s.t.world.state.x[body]), omega);
}

void wheel(Scene& s) { lean_on_floor(s, cylinder(0.3, 0.02), Vec3(0.3, -0.02, 0), 1.2, 0.8, 9); }
void coin(Scene& s) { lean_on_floor(s, cylinder(0.3, 0.01), Vec3(0.3, -0.01, 0), 0.4, 6, -5.6); }
void top(Scene& s) { lean_on_floor(s, cone(0.2, 0.2), Vec3(0, 0.2, 0), std::numbers::pi - 0.3, -1.2, 200); }
void rolling_cone(Scene& s) {
  const Real half = 0.4, height = 0.6, c = std::cos(half);
  s.t.world.scene.gravity = kG * Vec3(std::sin(0.3), -std::cos(0.3), 0);
  s.t.ground(s.rough);
  const Vec3 axis(c * std::cos(0.9), std::sin(half), c * std::sin(0.9));
  s.solid(cone(height * std::tan(half), height / 2), height / 2 * axis, turn_between(Vec3(0, 1, 0), -1 * axis),
          s.rough);
}
void ladder(Scene& s) {
  const Real half = 1, radius = 0.05, angle = 1.1;
  s.t.ground(s.smooth);
  s.t.add(s.t.keep(half_space(Vec3(1, 0, 0), 0)), Vec3::zero(), BodyType::fixed, Quat::identity(), s.smooth);
  s.solid(capsule(radius, half), Vec3(radius + half * std::cos(angle), radius + half * std::sin(angle), 0),
          turn_between(Vec3(0, 1, 0), Vec3(-std::cos(angle), std::sin(angle), 0)), s.smooth);
}
void turntable(Scene& s) {
  const std::uint32_t table =
      s.t.add(s.t.keep(half_space(Vec3(0, 1, 0), 0)), Vec3::zero(), BodyType::kinematic, Quat::identity(), s.rough);
  s.t.world.set_velocity(table, Vec3::zero(), Vec3(0, 2, 0));
  const std::uint32_t ball = s.solid(sphere(0.1), Vec3(0.5, 0.1, 0), Quat::identity(), s.rough);
  s.t.world.set_velocity(ball, Vec3(0.3, 0, 0.2), Vec3(-6, 0, -3));
}
void egg(Scene& s) { lean_on_floor(s, ellipsoid(Vec3(0.2, 0.3, 0.2)), Vec3(0, -0.3, 0), 0, 3, 0); }

void pendulum(Scene& s) {
  const std::uint32_t rod = s.link(Vec3(0.5, 0, 0), 1, Vec3(1e-3, 1.0 / 12, 1.0 / 12));
  s.hold(JointKind::hinge, kInvalid, rod, Vec3::zero());
}
void double_pendulum(Scene& s) {
  const Vec3 inertia(1e-3, 0.02, 0.02);
  const std::uint32_t one = s.link(Vec3(0.25, 0, 0), 1, inertia), two = s.link(Vec3(0.75, 0, 0), 1, inertia);
  s.hold(JointKind::hinge, kInvalid, one, Vec3::zero());
  s.hold(JointKind::hinge, one, two, Vec3(0.5, 0, 0));
}
void slider_crank(Scene& s) {
  const std::uint32_t crank = s.link(Vec3(0, 0.1, 0), 1, Vec3(0.01, 0.01, 0.01)),
                      rod = s.link(Vec3(0.2, 0.1, 0), 0.5, Vec3(0.001, 0.01, 0.01)),
                      piston = s.link(Vec3(0.4, 0, 0), 0.3, Vec3(0.001, 0.001, 0.001));
  s.hold(JointKind::hinge, kInvalid, crank, Vec3::zero());
  s.hold(JointKind::hinge, crank, rod, Vec3(0, 0.2, 0));
  s.hold(JointKind::hinge, rod, piston, Vec3(0.4, 0, 0));
  s.hold(JointKind::slider, kInvalid, piston, Vec3(0.4, 0, 0), Quat::identity());
  s.t.world.set_velocity(crank, Vec3(-0.3, 0, 0), Vec3(0, 0, 3));
}
void tree(Scene& s) {
  s.link(Vec3::zero(), 5, Vec3(0.1, 0.12, 0.15));
  s.t.world.set_velocity(s.bodies[0], Vec3::zero(), Vec3(0.5, 1, -0.7));
  for (std::size_t i = 1; i < 13; ++i) {
    const Real angle = 0.7 * static_cast<Real>(i);
    const std::uint32_t parent = s.bodies[(i - 1) / 2];
    const Vec3 way(std::cos(angle), std::sin(3 * angle), std::sin(angle)), at = s.t.world.state.x[parent] + 0.2 * way;
    const std::uint32_t body = s.link(at + 0.15 * way, 1, Vec3(0.02, 0.03, 0.04));
    s.hold(JointKind::hinge, parent, body, at, x_along(Vec3(std::sin(angle), 0.5, std::cos(angle)).normalized()));
  }
}
void gear_pair(Scene& s) {
  const std::uint32_t a = s.link(Vec3(0.3, 0, 0), 2, Vec3(0.1, 0.1, 0.1)),
                      b = s.link(Vec3(2, -0.2, 0), 1, Vec3(0.1, 0.1, 0.1));
  s.hold(JointKind::hinge, kInvalid, a, Vec3::zero());
  s.hold(JointKind::hinge, kInvalid, b, Vec3(2, 0, 0));
  s.t.world.set_transmission(join(s.t, JointKind::gear, a, b, Vec3::zero(), x_along(kZ)), {2});
}
void pulley(Scene& s) {
  const std::uint32_t a = s.link(Vec3(0.8, -1.5, 0), 1, Vec3::constant(0.1)),
                      b = s.link(Vec3(2, -2, 0), 1.4, Vec3::constant(0.1));
  JointDef def;
  def.kind = JointKind::pulley, def.body_a = a, def.body_b = b;
  const std::uint32_t rope = handle_slot(s.t.world.add_joint(def));
  s.t.world.set_transmission(rope, {1, Vec3::zero(), Vec3(2, 0, 0), 3.7});
}

const Named kTouching[] = {{"wheel", wheel},   {"coin", coin},           {"top", top}, {"cone", rolling_cone},
                           {"ladder", ladder}, {"turntable", turntable}, {"egg", egg}};
const Named kJointed[] = {{"pendulum", pendulum},         {"double pendulum", double_pendulum},
                          {"slider-crank", slider_crank}, {"tree", tree},
                          {"gear pair", gear_pair},       {"pulley", pulley}};

// ---- scenes that the rules were not made by ----

void tipping_box(Scene& s) {  // on an edge, beyond which it falls at first
  s.t.ground(s.rough);
  const Quat q = exp_map(0.6 * kZ);
  s.solid(box(Vec3(0.2, 0.3, 0.25)), -1 * (q * Vec3(-0.2, -0.3, 0)), q, s.rough);
}
void hoop(Scene& s) {  // straight on, down a slope
  s.t.world.scene.gravity = kG * Vec3(std::sin(0.2), -std::cos(0.2), 0);
  lean_on_floor(s, cylinder(0.25, 0.05), Vec3(0.25, -0.05, 0), std::numbers::pi / 2 - 0.1, 0, -4);
}
void puck_on_its_rim(Scene& s) { lean_on_floor(s, cylinder(0.15, 0.06), Vec3(0.15, -0.06, 0), 0.9, 1.5, 7); }

void cardan(Scene& s) {
  const std::uint32_t a = s.link(Vec3(0.25, 0, 0), 1, Vec3(0.01, 0.03, 0.03)),
                      b = s.link(Vec3(0.7, -0.15, 0), 1, Vec3(0.01, 0.03, 0.03));
  s.hold(JointKind::hinge, kInvalid, a, Vec3::zero(), Quat::identity());
  s.hold(JointKind::universal, a, b, Vec3(0.5, 0, 0), Quat::identity());
  s.t.world.set_velocity(a, Vec3::zero(), Vec3(6, 0, 0));
}
void crane(Scene& s) {  // six axes: some locked, some free, one sprung
  const std::uint32_t cart = s.link(Vec3(0, 1, 0), 3, Vec3(0.1, 0.1, 0.1)),
                      load = s.link(Vec3(0.3, 0.2, 0.1), 1, Vec3(0.02, 0.02, 0.03));
  for (const bool is_load : {false, true}) {
    const std::uint32_t j =
        s.hold(JointKind::six_axis, is_load ? cart : kInvalid, is_load ? load : cart, Vec3(0, 1, 0), Quat::identity());
    for (std::uint32_t k = 0; k < kAxes; ++k) {
      JointAxis axis;
      if (is_load ? k < 3 : k > 0) axis.mode = AxisMode::locked;
      if (!is_load && k == 0) axis.spring = {Gains::force, 40, 1};
      s.t.world.set_joint_axis(j, k, axis);
    }
  }
}
void rope_of_rods(Scene& s) {
  for (const std::uint32_t i : chain(s.t, 8, 0.2, 0.3, 0.6)) s.bodies.push_back(i);
  for (std::uint32_t j = 0; j < 8; ++j) s.joints.push_back(j);
}

const Named kFreshTouching[] = {{"box", tipping_box}, {"hoop", hoop}, {"puck", puck_on_its_rim}};
const Named kFreshJointed[] = {{"cardan", cardan}, {"crane", crane}, {"rope", rope_of_rods}};

/// What stands beside.
void each_body(Scene& s, const std::function<void(std::uint32_t)>& f) {
  for (const std::uint32_t i : s.bodies) f(i);
}
void drag(Scene& s) {
  each_body(s, [&](std::uint32_t i) { s.t.world.set_attribute(i, AttributeId::drag, {kHair, kHair}); });
}
void damping(Scene& s) {
  each_body(s, [&](std::uint32_t i) { s.t.world.set_damping(i, kHair, kHair); });
}
void field(Scene& s) {
  FieldDef def;
  def.vector = Vec3(0, kHair, 0);
  s.t.world.add_field(def);
}
void whirl(Scene& s) {
  FieldDef def;
  def.kind = FieldKind::vortex, def.strength = def.pull = kHair, def.core = 1;
  s.t.world.add_field(def);
}
void water(Scene& s) {
  WaterDef def;
  def.density = kHair, def.drag = 1, def.level = 10;
  s.t.world.set_water(&def);
}
void spring(Scene& s) {
  SpringDef def;
  def.body_b = s.bodies.back(), def.anchor_a = Vec3(3, 4, 5), def.stiffness = kHair, def.damping = kHair;
  s.t.world.add_spring(def);
}
void bead(Scene& s) {
  const Shape* const ball = s.t.keep(sphere(0.001));
  each_body(s, [&](std::uint32_t i) { s.t.world.add_collider(i, ball, Pose{}, 0, s.rough); });
}
void stranger(Scene& s) { s.t.add(s.t.keep(sphere(0.1)), Vec3(0, 100, 0)); }
void neighbour(Scene& s) { s.t.add(s.t.keep(box(Vec3::constant(0.5))), Vec3(50, 0.5, 0)); }

void magnet(Scene& s) {
  FieldDef def;
  def.kind = FieldKind::magnetic, def.vector = Vec3(0, kHair, 0);
  s.t.world.add_field(def);
  each_body(s, [&](std::uint32_t i) { s.t.world.set_attribute(i, AttributeId::magnetic_moment, {1, 0, 0}); });
}

void motor(Scene& s) {
  for (const std::uint32_t j : s.joints)
    if (has(joint(s.t, j).def.kind, Coordinate::twist)) set_motor(s.t, j, Coordinate::twist, 0, kHair);
}
void servo(Scene& s) {
  for (const std::uint32_t j : s.joints)
    if (has(joint(s.t, j).def.kind, Coordinate::twist)) set_spring(s.t, j, Coordinate::twist, 0.3, 1e-9, 1e-7);
}
void axes(Scene& s) {
  for (const std::uint32_t j : s.joints)
    for (std::uint32_t k = 0; joint(s.t, j).def.kind == JointKind::six_axis && k < kAxes; ++k) {
      JointAxis axis = s.t.world.joints.axes_of(joint(s.t, j)).axis[k];
      if (axis.mode == AxisMode::locked) continue;
      axis.friction = kHair, axis.drive = AxisDrive::position, axis.gains = {Gains::force, kHair, kHair};
      s.t.world.set_joint_axis(j, k, axis);
    }
}
void limit(Scene& s) {
  for (const std::uint32_t j : s.joints)
    if (has(joint(s.t, j).def.kind, Coordinate::twist)) set_limit(s.t, j, Coordinate::twist, -1e3, 1e3);
}

const Named kBeside[] = {{"drag", drag},           {"damping", damping}, {"field", field}, {"whirl", whirl},
                         {"water", water},         {"spring", spring},   {"bead", bead},   {"stranger", stranger},
                         {"neighbour", neighbour}, {"magnet", magnet}};
const Named kDriven[] = {{"motor", motor}, {"servo", servo}, {"limit", limit}, {"axes", axes}};

/// Where bodies are, step by step.
std::vector<Vec3> run(const Build& build, const Build& beside, int order) {
  Scene s;
  s.t.world.set_dial(Dial::joint_order, order);
  build(s);
  if (beside) beside(s);
  std::vector<Vec3> way;
  for (int i = 0; i < kSteps; ++i) {
    s.t.world.step(kDt);
    for (const std::uint32_t body : s.bodies) way.push_back(s.t.world.state.x[body]);
  }
  return way;
}

void compare(std::span<const Named> scenes, std::span<const Named> beside, int order) {
  Real worst_of_all = 0;
  for (const Named& scene : scenes) {
    const std::vector<Vec3> alone = run(scene.build, nullptr, order);
    for (const Named& change : beside) {
      const std::vector<Vec3> changed = run(scene.build, change.build, order);
      Real worst = 0;
      for (std::size_t i = 0; i < alone.size(); ++i) worst = std::max(worst, (alone[i] - changed[i]).norm());
      if (!(worst <= 1e-9))
        std::printf("  %s, %s beside it, order %d: %.1e m\n", scene.what, change.what, order, worst);
      worst_of_all = std::max(worst_of_all, worst);
    }
  }
  std::printf("  order %d: %.1e m at most\n", order, worst_of_all);
  assert_true(worst_of_all <= 1e-9);
}

}  // namespace

static void what_touches_moves_the_same(void**) {
  compare(kTouching, kBeside, 2);
  compare(kFreshTouching, kBeside, 2);
}

static void what_joints_hold_moves_the_same(void**) {
  for (const int order : kOrders) {
    compare(kJointed, kBeside, order);
    compare(kJointed, kDriven, order);
    compare(kFreshJointed, kBeside, order);
    compare(kFreshJointed, kDriven, order);
  }
}

int main() {
  const struct CMUnitTest tests[] = {cmocka_unit_test(what_touches_moves_the_same),
                                     cmocka_unit_test(what_joints_hold_moves_the_same)};
  return cmocka_run_group_tests_name("oracle/cliffs", tests, nullptr, nullptr);
}
