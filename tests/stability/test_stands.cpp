// What was built and stands is solved once, and stays where it was put: no step of it costs more than looking.
#include <cmath>
#include <vector>

#include "carom_test.h"
#include "dynamics/effects.h"
#include "sliced.h"
#include "world_builder.h"

using namespace carom;
using namespace carom::test;

namespace {

/// Steps of Newton's method in the last step, of what the direct solver solves alone.
Real newton_steps(const World& w) { return static_cast<Real>(w.report.velocity_impulses + w.report.position_moves); }

struct Standing {
  TestWorld t;
  Random random{7};
  std::vector<std::uint32_t> bodies;
  std::vector<Vec3> places;

  explicit Standing(const Vec3& gravity = Vec3(0, -9.81, 0)) : t(gravity) { t.ground(); }

  void put(const Shape* shape, const Vec3& at, const Quat& q = Quat::identity()) {
    bodies.push_back(t.add(shape, at, BodyType::dynamic, q));
    places.push_back(at);
  }
  /// @param pitch  1: cubes of a row touch; more: they don't
  void pyramid(int base, Real half, Real along = 0, Real pitch = 1) {
    const Shape* cube = t.keep(box(Vec3(half, half, half)));
    for (int row = 0; row < base; ++row)
      for (int i = 0; i < base - row; ++i) put(cube, half * Vec3(pitch * (2 * i + row), 2 * row + 1, along));
  }
  /// @param askew  m, the most that a block stands off the axis
  void column(int blocks, const Vec3& half, Real askew) {
    const Shape* block = t.keep(box(half));
    for (int i = 0; i < blocks; ++i) {
      const Real x = random.uniform(-askew, askew);
      put(block, Vec3(x, half.y() * (2 * i + 1), random.uniform(-askew, askew)));
    }
  }
  /// Courses of three planks, each across the last.
  void tower(int courses) {
    const Shape* plank = t.keep(box(Vec3(0.375, 0.075, 0.12)));
    const Quat across(0, std::sqrt(0.5), 0, std::sqrt(0.5));
    for (int i = 0; i < courses; ++i)
      for (int k = -1; k <= 1; ++k)
        put(plank, i % 2 ? Vec3(0.25 * k, 0.075 * (2 * i + 1), 0) : Vec3(0, 0.075 * (2 * i + 1), 0.25 * k),
            i % 2 ? across : Quat::identity());
  }
  Real worst_place() const {
    Real worst = 0;
    for (std::size_t i = 0; i < bodies.size(); ++i)
      worst = std::max(worst, (t.world.state.x[bodies[i]] - places[i]).norm());
    return worst;
  }

  /// @param off  m, from where it was put, at most
  /// @param allowed  steps of Newton's method after the first step, in all
  void stands(Real seconds, Real dt, Real off, Real allowed) {
    const auto steps = static_cast<int>(std::lround(seconds / dt));
    Real taken = 0, first = 0;
    for (int i = 0; i < steps; ++i) {
      t.world.step(dt);
      const Real now = newton_steps(t.world);
      (i == 0 ? first : taken) += now;
    }
    print_message("%zu bodies: %g steps of Newton at first, %g in %d steps; off by %.1e m\n", bodies.size(), first,
                  taken, steps - 1, worst_place());
    assert_true(t.world.report.direct_groups > 0);
    assert_true(taken <= allowed);
    assert_true(worst_place() < off);
  }
};

constexpr Real kOff = 1e-8;  // m: what is solved to 1e-6 m/s moves 4e-9 m in the substep before it is stopped
// What is held anew now and then costs less than the sweep that it saves, and nobody sees it.
constexpr Real kSeldom = 0.1, kSeldomOff = 1e-6;  // steps of Newton's method a step; m

}  // namespace

// Pyramids of 9 rows and more drift to 4e-8 m and stay there: of 22 half did within 10 s, all within 40 s.
static void a_pyramid_is_solved_once(void**) {
  constexpr Real kDrift = 1e-7;  // m
  Standing s;
  s.pyramid(10, 0.5);
  s.stands(10, 1.0 / 60, kDrift, 0);
}

static void columns_are_solved_while_their_corners_find_their_loads(void**) {
  for (const Real askew : {0.0, 0.001, 0.003, 0.01}) {
    Standing s;
    s.column(40, Vec3(0.5, 0.5, 0.5), askew);
    s.stands(15, 1.0 / 60, kOff, 12);
  }
}

// Looked at only after the mend worked.
static void so_does_what_it_was_not_made_for(void**) {
  {
    Standing s;
    s.pyramid(7, 0.1);
    s.stands(20, 1.0 / 30, kSeldomOff, kSeldom * 20 * 30);
  }
  {
    Standing s(Vec3(0, -25, 0));
    s.pyramid(14, 0.25);
    s.stands(5, 1.0 / 120, kSeldomOff, kSeldom * 5 * 120);
  }
  {
    Standing s;
    s.column(25, Vec3(0.3, 0.2, 0.4), 0.02);
    s.stands(20, 1.0 / 50, kSeldomOff, kSeldom * 20 * 50);
  }
  {
    Standing s;
    for (int i = 0; i < 3; ++i) s.pyramid(4 + i, 0.2, 5.0 * i);
    s.stands(10, 1.0 / 60, kSeldomOff, kSeldom * 10 * 60);
  }
  {
    Standing s;
    s.tower(12);
    s.stands(10, 1.0 / 60, kSeldomOff, kSeldom * 10 * 60);
  }
}

/// Large blocks sink little of their size on soft contacts, so loads alone don't ask for the direct solver: they stood for a
/// second, and then sank by a centimetre.
static void large_blocks_stand_on(void**) {
  for (const Real half : {0.9, 1.0, 2.5})
    for (const int base : {9, 12, 15}) {
      Standing s;
      s.pyramid(base, half);
      s.stands(6, 1.0 / 60, kSeldomOff, kSeldom * 6 * 60);
    }
  Standing s;
  s.pyramid(11, 1.3, 0, 1.02);
  s.stands(8, 1.0 / 90, kSeldomOff, kSeldom * 8 * 90);
}

/// Large structures drift off their answer by a millionth of a metre a second, again and again: that takes a factor or two, not
/// Newton's method from its beginning (10 steps and more).
static void what_drifts_is_set_right_by_a_factor_or_two(void**) {
  const auto holds = [](Standing& s, Real dt) {
    const int steps = sliced(480, 480, 120);
    s.t.run(120, dt);
    int dear = 0;
    Real taken = 0;
    for (int i = 0; i < steps; ++i) {
      s.t.world.step(dt);
      const Real now = newton_steps(s.t.world);
      taken += now;
      dear += now > 2;
    }
    print_message("%zu bodies: %g factors in %d steps, more than two in %d; off by %.1e m\n", s.bodies.size(), taken,
                  steps, dear, s.worst_place());
    assert_true(dear <= steps / 20);  // where contacts at the edges of their cones change places
    assert_true(s.worst_place() < kSeldomOff);
  };
  std::vector<int> bases = {26, 29, 30};
  bases.resize(sliced<std::size_t>(3, 3, 1));
  for (const int base : bases) {
    Standing s;
    s.pyramid(base, base == 26 ? 0.2 : 0.5, 0, base == 29 ? 1.2 : 1.05);
    holds(s, base == 29 ? 1.0 / 80 : 1.0 / 60);
  }
  Standing wall(Vec3(0, -4, 0));
  const Shape* block = wall.t.keep(box(Vec3(0.3, 0.15, 0.15)));
  for (int row = 0; row < 14; ++row)
    for (int k = 0; k < 18 - row % 2; ++k) wall.put(block, Vec3(0.6 * (k + 0.5 * (row % 2)), 0.15 + 0.3 * row, 0));
  holds(wall, 1.0 / 50);
}

/// A pyramid of 253 blocks, and boxes put at its foot, body by body: it dropped 32 mm at body 257.
static void nothing_jumps_at_a_number_of_bodies(void**) {
  Standing s;
  s.pyramid(22, 0.5);
  s.t.run(60, 1.0 / 60);
  const Shape* cube = s.t.keep(box(Vec3(0.5, 0.5, 0.5)));
  for (int k = 0; k < 12; ++k) {
    s.put(cube, Vec3(22 + k, 0.5, 0));
    s.t.run(30, 1.0 / 60);
    assert_true(s.worst_place() < 1e-5);
  }
}

/// Walls of 156 to 273 blocks (whose top course is a short one: no block overhangs), and loads of 90 to 110 times what bears them.
static void nor_between_sizes_or_ratios(void**) {
  for (const int rows : {8, 10, 12, 14}) {
    Standing s;
    const Shape* block = s.t.keep(box(Vec3(0.3, 0.15, 0.15)));
    for (int row = 0; row < rows; ++row)
      for (int k = 0; k < 20 - row % 2; ++k) s.put(block, Vec3(0.601 * (k + 0.5 * (row % 2)), 0.15 + 0.3 * row, 0));
    s.t.run(90, 1.0 / 60);
    assert_true(s.worst_place() < 1e-5);
  }
  for (Real ratio = 90; ratio <= 110; ratio += 1) {
    Standing s;
    const Shape *light = s.t.keep(box(Vec3(0.25, 0.25, 0.25))), *heavy = s.t.keep(box(Vec3(0.5, 0.5, 0.5)));
    for (int i = 0; i < 6; ++i) s.put(light, Vec3(0, 0.25 + 0.5 * i, 0));
    BodyDef def;
    def.pose.p = Vec3(0, 3.5, 0);
    const std::uint32_t load = handle_slot(s.t.world.add_body(def));
    s.t.world.add_collider(load, heavy, Pose{}, 1000 * ratio / 8, s.t.material(0.5, 0));
    s.t.run(120, 1.0 / 60);
    assert_true(s.worst_place() < 1e-5);
  }
}

namespace {

/// A box of a stack, of which the middles of mass of all above it lie well over what bears them.
struct Layer {
  Vec3 half, at;  // m
  Real density;   // kg/m^3
  Real mass() const { return 8 * half.x() * half.y() * half.z() * density; }
};

/// Whether what is from a box on would tip over the one below it, or nearly: within a fifth of the width where they touch.
bool tips(const std::vector<Layer>& stack, std::size_t i) {
  Real mass = 0;
  Vec3 moment = Vec3::zero();
  for (std::size_t k = i; k < stack.size(); ++k) mass += stack[k].mass(), moment += stack[k].mass() * stack[k].at;
  const Layer &above = stack[i], &below = stack[i - 1];
  for (const int axis : {0, 2}) {
    const Real low = std::max(above.at[axis] - above.half[axis], below.at[axis] - below.half[axis]);
    const Real high = std::min(above.at[axis] + above.half[axis], below.at[axis] + below.half[axis]);
    const Real middle = moment[axis] / mass, room = 0.2 * (high - low);
    if (!(middle > low + room && middle < high - room)) return true;
  }
  return false;
}

/// Of 11 to 15 boxes of like sizes, 5 mm to 2 m, and of densities of 100 to 8,000 kg/m^3, one beside the other's middle.
std::vector<Layer> draw(Random& random) {
  std::vector<Layer> stack;
  const Real size = 0.005 * std::pow(400, random.uniform(0, 1));
  const auto count = static_cast<std::size_t>(random.uniform(11, 16));
  Vec3 top = Vec3::zero();
  while (stack.size() < count) {
    Layer layer;
    for (int k = 0; k < 3; ++k) layer.half[k] = size * random.uniform(0.5, 1.5);
    layer.density = 100 * std::pow(80, random.uniform(0, 1));
    const Vec3 before = stack.empty() ? Vec3(Vec3::zero()) : stack.back().half;
    const Real x = 0.3 * std::min(before.x(), layer.half.x()), z = 0.3 * std::min(before.z(), layer.half.z());
    const Real aside = random.uniform(-x, x), along = random.uniform(-z, z);
    layer.at = top + Vec3(aside, layer.half.y(), along);
    top = layer.at + Vec3(0, layer.half.y(), 0);
    stack.push_back(layer);
    for (std::size_t i = stack.size(); i-- > 1 && !stack.empty();)
      if (tips(stack, i)) stack.clear(), top.set_zero();
  }
  return stack;
}

}  // namespace

/// Whether it stands after 3 s, let go with gaps between its layers, which close one after the other.
static bool stands(const std::vector<Layer>& stack, Real solver, Real gap, Real friction, Real rate) {
  TestWorld t;
  t.world.set_dial(Dial::solver, solver);
  const std::uint32_t material = t.material(friction, 0);
  t.ground(material);
  std::vector<std::uint32_t> bodies;
  for (const Layer& layer : stack) {
    BodyDef def;
    def.pose.p = layer.at + Vec3(0, gap * layer.half.y() * static_cast<Real>(bodies.size() + 1), 0);
    bodies.push_back(handle_slot(t.world.add_body(def)));
    t.world.add_collider(bodies.back(), t.keep(box(layer.half)), Pose{}, layer.density, material);
  }
  t.run(static_cast<int>(3 * rate), 1 / rate);
  for (std::size_t k = 0; k < stack.size(); ++k)
    if (!((t.world.state.x[bodies[k]] - stack[k].at).norm() < 0.05 * stack[k].half.norm())) return false;
  return true;
}

/// Such impacts take as much work in one substep as a stack at rest takes in an hour. What stands where work has no bound, stands
/// where it has one, but for one of a hundred: 7 of 300 fell.
static void what_is_set_down_stands(void**) {
  Random random(3);
  int fallen = 0;
  const int all = sliced(300, 150, 15);
  for (int i = 0; i < all; ++i) {
    const std::vector<Layer> stack = draw(random);
    const Real gap = random.uniform(0, 0.01), friction = random.uniform(0.3, 0.9);
    constexpr Real kRates[] = {30, 50, 60, 75, 100, 120};
    const Real rate = kRates[static_cast<int>(random.uniform(0, 6))];
    const bool falls = !stands(stack, kAutoChoice, gap, friction, rate);
    if (!falls || !stands(stack, kDirectChoice, gap, friction, rate)) continue;
    print_message("%d: %zu boxes of %g m, %g Hz, fell\n", i, stack.size(), double(stack[0].half.y()), double(rate));
    ++fallen;
  }
  assert_true(100 * fallen <= all);
}

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(what_is_set_down_stands),
                              cmocka_unit_test(a_pyramid_is_solved_once),
                              cmocka_unit_test(columns_are_solved_while_their_corners_find_their_loads),
                              cmocka_unit_test(so_does_what_it_was_not_made_for),
                              cmocka_unit_test(large_blocks_stand_on),
                              cmocka_unit_test(what_drifts_is_set_right_by_a_factor_or_two),
                              cmocka_unit_test(nothing_jumps_at_a_number_of_bodies),
                              cmocka_unit_test(nor_between_sizes_or_ratios)};
  return cmocka_run_group_tests_name("stability/stands", tests, nullptr, nullptr);
}
