// Coins, washers and lids that are poured onto each other: the depth that they leave after each step, of their thickness.
//
// A coin comes down on its rim and swings flat within a step. Its face is looked for from the rim, so that four points
// bear it: with the rim's one point it rocked, and lay 0.9 to 1.6 of its thickness deep in another.
#include <algorithm>
#include <vector>

#include "carom_test.h"
#include "collision/scenery/ask.h"
#include "sliced.h"
#include "world_builder.h"

using namespace carom;
using namespace carom::test;

namespace {

/// m, of the two that are deepest in each other now.
Real deepest(const World& world, const std::vector<std::uint32_t>& bodies, const Shape& shape) {
  Real depth = 0;
  for (const std::uint32_t a : bodies)
    for (const std::uint32_t b : bodies) {
      const Pose at_a = world.pose(a), at_b = world.pose(b);
      if (a >= b || (at_b.p - at_a.p).norm() > 2 * shape.bounding_radius) continue;
      const Frame frame_a(at_a.q.matrix(), at_a.p), frame_b(at_b.q.matrix(), at_b.p);
      QueryResult found;
      SupportFault fault;
      any_shape::distance(shape, shape, relative(frame_a, frame_b), {}, nullptr, found, fault);
      depth = std::max(depth, -found.separation);
    }
  return depth;
}

struct Depths {
  Real most = 0, last = 0;  // of the thickness: after any step, and in the last 20
};

/// One falls after the other, turned at random, onto the ground.   @param thickness  m
Depths pour(Shape shape, Real thickness, int count, Real dt, std::uint64_t seed) {
  Random random(seed);
  TestWorld t;
  const std::uint32_t m = t.material(0.3, 0);
  t.ground(m);
  const Shape* kept = t.keep(std::move(shape));
  const Real r = kept->bounding_radius;
  std::vector<std::uint32_t> bodies;
  for (int i = 0; i < count; ++i) {
    const Real x = random.uniform(-0.5, 0.5), z = random.uniform(-0.5, 0.5);  // in this order anywhere
    const Quat q = exp_map(random.uniform(0, 3) * random.direction());
    bodies.push_back(t.add(kept, Vec3(x * r, (1.1 + 2.2 * i) * r, z * r), BodyType::dynamic, q, m));
  }
  Depths d;
  const int steps = static_cast<int>(1.5 / dt);
  for (int i = 0; i < steps; ++i) {
    t.run(1, dt);
    const Real depth = deepest(t.world, bodies, *kept) / thickness;
    d.most = std::max(d.most, depth);
    if (i >= steps - 20) d.last = std::max(d.last, depth);
  }
  return d;
}

}  // namespace

static void thin_round_bodies_that_are_poured_stay_out_of_each_other(void**) {
  struct Kind {
    const char* name;
    Shape shape;
    Real thickness, dt;
  };
  const Kind kinds[] = {{"coins of 2 mm", cylinder(0.01, 0.001), 0.002, 1.0 / 60},
                        {"washers of 0.5 mm", cylinder(0.003, 0.00025), 0.0005, 1.0 / 60},
                        {"lids of 2 cm", cylinder(0.07, 0.01), 0.02, 1.0 / 60},
                        {"coins of 1.2 mm", cylinder(0.0085, 0.0006), 0.0012, 1.0 / 120}};
  for (const Kind& k : kinds) {
    std::vector<Real> most, last;
    for (std::uint64_t seed = 1; seed <= 7; ++seed) {
      const Depths d = pour(k.shape, k.thickness, 8, k.dt, seed);
      most.push_back(d.most), last.push_back(d.last);
    }
    std::sort(most.begin(), most.end()), std::sort(last.begin(), last.end());
    print_message("%s: median of seven pours %.2f, the worst %.2f; in the end %.2f, %.2f\n", k.name, double(most[3]),
                  double(most[6]), double(last[3]), double(last[6]));
    assert_true(most[3] < 0.5);  // before the middle of one passes the face of the other, and it leaves on the far side
    assert_true(last[3] < 0.2);
  }
}

/// A stack let go with small gaps, which closes layer by layer.   @return whether all lie on each other after 4 s
static bool stands(const Shape& shape, Real thickness, int count, Real gap, Real dt) {
  TestWorld t;
  const std::uint32_t m = t.material(0.35, 0);
  t.ground(m);
  const Shape* kept = t.keep(shape);
  std::vector<std::uint32_t> bodies;
  for (int i = 0; i < count; ++i) {
    const Real x = 0.1 * (i % 3), z = 0.12 * (i % 4);
    bodies.push_back(t.add(kept, thickness * Vec3(x, 0.5 + i * (1 + gap), z), BodyType::dynamic, Quat::identity(), m));
  }
  t.run(static_cast<int>(4 / dt), dt);
  Real top = 0;
  for (const std::uint32_t i : bodies) top = std::max(top, t.world.pose(i).p.y());
  return std::fabs(top / thickness - (count - 0.5)) < 0.02 * count;
}

/// In contact through their neighbours, in impacts that no step solves exactly: 34 of 108 fell over. Three still do, so one in
/// twelve may.
static void thin_bodies_that_are_dropped_stay_a_stack(void**) {
  int fallen = 0, all = 0;
  OneOf scenes(1, 5);
  for (const Real thickness : {0.0006, 0.0013, 0.003, 0.006}) {
    const Shape shapes[] = {box(thickness * Vec3(4, 0.5, 4)), cylinder(8 * thickness, thickness / 2),
                            box(thickness * Vec3(12, 0.5, 7))};
    for (const Shape& shape : shapes)
      for (const int count : {9, 12, 14})
        for (const Real gap : {0.15, 0.4}) {
          if (!scenes.next()) continue;
          ++all;
          if (stands(shape, thickness, count, gap, 1.0 / 60)) continue;
          print_message("fallen: %g mm, %d of gap %g\n", double(1e3 * thickness), count, double(gap));
          ++fallen;
        }
  }
  print_message("%d of %d stacks fell\n", fallen, all);
  assert_true(12 * fallen <= all);
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(thin_bodies_that_are_dropped_stay_a_stack),
      cmocka_unit_test(thin_round_bodies_that_are_poured_stay_out_of_each_other),
  };
  return cmocka_run_group_tests_name("stability/coins", tests, nullptr, nullptr);
}
