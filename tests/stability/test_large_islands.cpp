// Joints of islands that are too large for Newton's method hold all the same: heaps of dolls, bridges, mail, ladders, worms.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>

#include "carom_test.h"
#include "joint_scenes.h"
#include "shapes.h"

using namespace carom;
using namespace carom::test;

namespace {

using Build = std::function<void(TestWorld&, Random&)>;

/// Trunk, head, and four limbs of two bones, about a point.
void doll(TestWorld& t, const Vec3& at, Real size) {
  const auto along = [&](Real x, Real y) { return at + size * Vec3(x, y, 0); };
  const std::uint32_t trunk = t.add(t.keep(box(size * Vec3(0.16, 0.28, 0.1))), at);
  const std::uint32_t head = t.add(t.keep(sphere(0.12 * size)), along(0, 0.42));
  join(t, JointKind::ball, trunk, head, along(0, 0.3));
  const Shape* limb = t.keep(capsule(0.05 * size, 0.1 * size));
  for (const Real side : {-1.0, 1.0})
    for (const Real top : {0.22, -0.3}) {
      const Real x = side * (top > 0 ? 0.24 : 0.1);
      const std::uint32_t upper = t.add(limb, along(x, top - 0.18)), lower = t.add(limb, along(x, top - 0.54));
      join(t, JointKind::ball, trunk, upper, along(x, top));
      join(t, JointKind::hinge, upper, lower, along(x, top - 0.36), x_along(Vec3(1, 0, 0)));
    }
}

void heap_of_dolls(TestWorld& t, Random& random, int count, Real size) {
  t.ground();
  for (int i = 0; i < count; ++i)
    doll(t, Vec3(size * random.uniform(-0.5, 0.5), size * (1.2 + 0.9 * i), size * random.uniform(-0.5, 0.5)), size);
}

/// Planks between two banks, each on two joints, that sag by an arc; and boxes dropped on them.
void bridge(TestWorld& t, Random& random, int planks, int boxes, Real heaviest) {
  const Real length = 0.4, turn = 0.7, radius = planks * length / turn;
  const auto at = [&](Real way, Real z) {
    const Real angle = way / radius - turn / 2;
    return Vec3(radius * std::sin(angle), radius * (1 - std::cos(angle)), z);
  };
  const Shape *plank = t.keep(box({0.18, 0.04, 0.7})), *load = t.keep(box({0.15, 0.15, 0.15}));
  std::uint32_t before = kInvalid;
  for (int i = 0; i <= planks; ++i) {
    const std::uint32_t next = i == planks ? kInvalid
                                           : t.add(plank, at((i + 0.5) * length, 0), BodyType::dynamic,
                                                   exp_map(Vec3(0, 0, (i + 0.5) * length / radius - turn / 2)));
    for (const Real z : {-0.6, 0.6}) join(t, JointKind::ball, before, next, at(i * length, z));
    before = next;
  }
  for (int i = 0; i < boxes; ++i) {
    const Real way = planks * length * random.uniform(0.2, 0.8);
    const std::uint32_t b = t.add(nullptr, at(way, random.uniform(-0.4, 0.4)) + Vec3(0, 0.8 + 0.5 * i, 0));
    t.world.add_collider(b, load, Pose{}, random.uniform(1, heaviest) / load->mass.volume, Colliders::kNoMaterial);
  }
}

/// Balls side by side in a square, each joined to its neighbours, that fall over a post.
void mail(TestWorld& t, Random& random, int across) {
  t.ground();
  const Shape* ring = t.keep(sphere(0.05));
  std::vector<std::uint32_t> row;
  for (int i = 0; i < across; ++i)
    for (int k = 0; k < across; ++k) {
      const Vec3 at(0.15 * i, 1.6 + 1e-3 * random.uniform(-1, 1), 0.15 * k);
      const std::uint32_t b = t.add(ring, at);
      if (i > 0) join(t, JointKind::ball, row[static_cast<std::size_t>(k)], b, at - Vec3(0.075, 0, 0));
      if (k > 0) join(t, JointKind::ball, b - 1, b, at - Vec3(0, 0, 0.075));
      if (i == 0)
        row.push_back(b);
      else
        row[static_cast<std::size_t>(k)] = b;
    }
  t.add(t.keep(box({0.2, 0.5, 0.2})), Vec3(0.075 * across, 0.5, 0.075 * across), BodyType::fixed);
}

/// Chains of capsules that grow thicker and heavier, on hinges of changing direction, dropped on each other.
void worms(TestWorld& t, Random& random, int count, int links) {
  t.ground();
  for (int w = 0; w < count; ++w) {
    std::uint32_t before = kInvalid;
    Real x = random.uniform(-0.4, 0.4);
    const Real y = 0.3 + 0.35 * w, z = random.uniform(-0.6, 0.6);
    for (int i = 0; i < links; ++i) {
      const Real r = 0.03 + 0.03 * i / links, half = 0.08;
      x += half + r;
      const std::uint32_t b =
          t.add(t.keep(capsule(r, half)), Vec3(x, y, z), BodyType::dynamic, exp_map(Vec3(0, 0, -1.5707963)));
      if (before != kInvalid)
        join(t, JointKind::hinge, before, b, Vec3(x - half - r, y, z), x_along(i % 2 ? Vec3(0, 1, 0) : Vec3(0, 0, 1)));
      before = b, x += half + r;
    }
  }
}

/// A chain held out level, with a ball of so many times a link's mass, that swings into a wall of blocks.
void wrecking_ball(TestWorld& t, Random& random, int links, Real ratio) {
  t.ground();
  const Real length = 0.12, height = links * length + 0.7;
  const Shape* link = t.keep(capsule(0.02, 0.035));
  std::uint32_t before = kInvalid;
  for (int i = 0; i < links; ++i) {
    const std::uint32_t b = t.add(link, Vec3((i + 0.5) * length, height, random.uniform(-1e-3, 1e-3)),
                                  BodyType::dynamic, exp_map(Vec3(0, 0, -1.5707963)));
    join(t, JointKind::ball, before, b, Vec3(i * length, height, 0));
    before = b;
  }
  const Shape* ball = t.keep(sphere(0.4));
  const std::uint32_t b = t.add(nullptr, Vec3(links * length + 0.4, height, 0));
  t.world.add_collider(b, ball, Pose{}, ratio * 1000 * link->mass.volume / ball->mass.volume, Colliders::kNoMaterial);
  join(t, JointKind::ball, before, b, Vec3(links * length, height, 0));
  const Shape* block = t.keep(box({0.2, 0.1, 0.2}));
  for (int row = 0; row < 8; ++row)
    for (int k = 0; k < 6; ++k) t.add(block, Vec3(-0.6, 0.1 + 0.2 * row, 0.41 * (k - 2.5 + 0.5 * (row % 2))));
}

struct Course {
  Real gap = 0;     // m or rad
  Real gained = 0;  // J, over what there was
  Real depth = 0;   // m, in the end
};
Course follow(const Build& build, Real dt, Real hair, std::uint64_t seed) {
  TestWorld t;
  Random random(seed);
  build(t, random);
  if (hair > 0) {
    for (std::uint32_t j = 0; j < t.world.joints.slots.slots(); ++j)
      if (joint(t, j).def.kind == JointKind::hinge) set_motor(t, j, Coordinate::twist, 0, hair);
    const std::uint32_t on = joint(t, 0).def.body_b;
    join(t, JointKind::weld, on, add_body(t, t.world.state.x[on], hair, Vec3::constant(hair)), t.world.state.x[on]);
  }
  Course c;
  const Real first = energy_of(t);
  for (int i = 0; i < 2.5 / dt; ++i) {
    t.run(1, dt);
    c.gap = std::max(c.gap, worst_gap(t)), c.gained = std::max(c.gained, energy_of(t) - first);
  }
  c.depth = t.world.report.max_penetration;
  return c;
}

struct Case {
  const char* name;
  Build build;
};
const Case kCases[] = {
    {"7 dolls", [](TestWorld& t, Random& r) { heap_of_dolls(t, r, 7, 1); }},
    {"15 dolls of half the size", [](TestWorld& t, Random& r) { heap_of_dolls(t, r, 15, 0.5); }},
    {"a bridge of 70", [](TestWorld& t, Random& r) { bridge(t, r, 70, 12, 60); }},
    {"a bridge of 100 under heavy loads", [](TestWorld& t, Random& r) { bridge(t, r, 100, 20, 400); }},
    {"mail of 12 x 12", [](TestWorld& t, Random& r) { mail(t, r, 12); }},
    {"a ball of 300 on 130 links", [](TestWorld& t, Random& r) { wrecking_ball(t, r, 130, 300); }},
    {"9 worms of 18", [](TestWorld& t, Random& r) { worms(t, r, 9, 18); }},
};

}  // namespace

static void joints_of_large_islands_hold(void**) {
  for (const Case& of : kCases)
    for (const std::uint64_t seed : {11, 12})
      for (const Real dt : {1.0 / 30, 1.0 / 60, 1.0 / 120}) {
        const Course c = follow(of.build, dt, 0, seed);
        std::printf("%s, seed %d, 1/%.0f s: gap %.1e, gained %.1e J, sinks %.1e m\n", of.name, int(seed), 1 / dt, c.gap,
                    c.gained, c.depth);
        assert_true(c.gap < (dt > 0.02 ? 5e-3 : 1e-3));  // passes over places end before a chain at 17 m/s is closed
        assert_true(c.gained < 1e-6);
      }
}

/// A motor of next to no force on each hinge, and a bead of next to no mass on a head.
static void a_hair_beside_them_they_hold_too(void**) {
  for (const Case& of : kCases) {
    const Course c = follow(of.build, 1.0 / 60, 1e-15, 11);
    std::printf("%s, a hair beside: gap %.1e, gained %.1e J\n", of.name, c.gap, c.gained);
    assert_true(c.gap < 1e-3);
    assert_true(c.gained < 1e-6);
  }
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(joints_of_large_islands_hold),
      cmocka_unit_test(a_hair_beside_them_they_hold_too),
  };
  return cmocka_run_group_tests_name("stability/large_islands", tests, nullptr, nullptr);
}
