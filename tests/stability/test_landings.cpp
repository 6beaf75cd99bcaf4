// What is long or flat lands on one end, which sends the other one down within the same step: nothing of it goes through the
// ground. Contacts of a step are found as it begins, where the other end is not known yet.
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "carom_test.h"
#include "collision/support.h"
#include "sliced.h"
#include "world_builder.h"

using namespace carom;
using namespace carom::test;

namespace {

struct Landing {
  const char* name;
  std::function<Shape(Real size, Real thin)> rod, plate;
};

/// Points of which a hull has no declared faces.
Shape spindle(Real half_length, Real radius) {
  std::vector<Vec3> points = {Vec3(0, half_length, 0), Vec3(0, -half_length, 0)};
  for (int k = 0; k < 6; ++k) {
    const Real a = k * std::numbers::pi / 3;
    points.push_back(radius * Vec3(std::cos(a), 0, std::sin(a)));
  }
  return hull(points);
}

const std::vector<Landing>& landings() {
  static const std::vector<Landing> kAll = {
      {"box", [](Real l, Real t) { return box(Vec3(t, l, t)); }, [](Real l, Real t) { return box(Vec3(l, t, l)); }},
      {"cylinder", [](Real l, Real t) { return cylinder(t, l); }, [](Real l, Real t) { return cylinder(l, t); }},
      {"capsule", [](Real l, Real t) { return capsule(t, l); }, [](Real l, Real t) { return cylinder(l, t); }},
      {"spindle", [](Real l, Real t) { return spindle(l, t); }, [](Real l, Real t) { return spindle(t, l); }},
  };
  return kAll;
}

/// m, how far its lowest point is below y = 0.
Real depth(const World& world, std::uint32_t body, const Shape& shape) {
  const Mat3 r = world.state.q[body].matrix();
  const Vec3 down = r.transpose() * Vec3(0, -1, 0);
  Vec3 lowest = Vec3::zero();
  SupportFault fault;
  assert_true(collision::full_support(shape, down, lowest, fault));
  return -(world.state.x[body] + r * lowest).y();
}

}  // namespace

static void no_end_goes_through_the_ground(void**) {
  Random random(20261130);
  const int draws = sliced(400, 60, 12);
  for (const Landing& landing : landings())
    for (const Real hz : {30.0, 60.0, 120.0}) {
      Real worst = 0;
      for (int i = 0; i < draws; ++i) {
        const Real length = random.uniform(0.05, 0.6), thin = length * random.uniform(0.02, 0.15);
        const bool is_rod = random.uniform(0, 1) < 0.6;
        TestWorld t;
        const std::uint32_t material = t.material(random.uniform(0, 1), 0);
        t.ground(material);
        const Shape* const shape = t.keep((is_rod ? landing.rod : landing.plate)(length, thin));
        const Vec3 turn(random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-3, 3));
        const Real height = length + random.uniform(0.2, 2);
        const std::uint32_t body = t.add(shape, Vec3(0, height, 0), BodyType::dynamic, exp_map(turn), material);
        for (int k = 0; k < static_cast<int>(hz); ++k) {
          t.world.step(1 / hz);
          worst = std::max(worst, depth(t.world, body, *shape) / (2 * thin));
        }
      }
      print_message("%s at %g Hz: deepest %.2g of a thickness\n", landing.name, double(hz), double(worst));
      assert_true(worst < 0.5);  // as deep as its middle: from there on it may come out on the other side
    }
}

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(no_end_goes_through_the_ground)};
  return cmocka_run_group_tests_name("stability/landings", tests, nullptr, nullptr);
}
