// Whole contact patches: the points that geometry says, from normals that are off, at any pose, through any motion.
//
// Tolerances: a corner that a support function returns is exact; placing it, and cutting sides, costs some 64 u of the
// sizes involved. What lies on a curve is found by tilted directions: settle_facet leaves 1e-9 of the radius to the
// side.
#include <algorithm>
#include <functional>
#include <vector>

#include "carom_test.h"
#include "collision/manifold/facet.h"
#include "collision/narrow/narrow_phase.h"
#include "pair_cases.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr Real kPi = 3.14159265358979323846;
constexpr Real kRounding = 64 * 8 * kEpsilon;  // m: places within 8 m
constexpr ManifoldKind kKinds[] = {ManifoldKind::patch, ManifoldKind::clip};

ManifoldSettings with(ManifoldKind kind) { return {kind, 0.02, 0.01}; }

Shape faced(Shape s) {
  make_faces(s);
  return s;
}

Frame turned(const Vec3& by, const Vec3& to) { return Frame(exp_map(by).matrix(), to); }

/// Two shapes that touch along a known normal (A's frame, A to B).
struct Touch {
  const Shape &a, &b;
  Frame at_a, at_b;
  Vec3 normal;  // world
  Real separation;
  Vec3 place;  // world, somewhere in the patch
};

struct Found {
  Manifold manifold;
  PatchMemory memory;
  std::uint64_t calls = 0;
};

/// What a query would say of a touch, its normal turned off by some angle. Points have no value until they are added.
Candidates candidate_of(const Touch& t, const Vec3& off = Vec3::zero()) {
  Candidates found;
  ContactPoint& p = found.add();
  p.normal = exp_map(off) * t.normal;
  p.on_a = t.at_a.apply_inverse(t.place), p.on_b = t.at_b.apply_inverse(t.place + t.separation * t.normal);
  p.separation = t.separation;
  return found;
}

/// The patch that starts from the touch's normal, turned off by some angle.
Found patch_of(const Touch& t, ManifoldKind kind, const Vec3& off = Vec3::zero()) {
  const Candidates found = candidate_of(t, off);
  Found f;
  SupportFault fault;
  assert_true(update_patch({t.a, t.b, t.at_a, t.at_b, 0}, found, with(kind), f.manifold, f.memory, f.calls, fault));
  return f;
}

/// B on top of A's plane y = 0, both moved somewhere in the world.
Touch on_top(const Shape& a, Real top, const Shape& b, const Frame& above, Real gap, Random& random) {
  const Frame world = turned(3 * random.direction(), random.in_cube(2));
  const Frame down(Mat3::identity(), Vec3(0, -top, 0)), up(Mat3::identity(), Vec3(0, gap, 0));
  return {a, b, world * down, world * up * above, world.rotate(Vec3::unit_y()), gap, world.apply(above.p)};
}

void assert_consistent(const Touch& t, const Found& f, Real separation, Real tolerance) {
  for (int k = 0; k < f.manifold.count; ++k) {
    const ContactPoint& p = f.manifold.point[k];
    assert_true((p.normal - t.normal).norm() < 1e-9);
    const Vec3 gap = t.at_b.apply(p.on_b) - t.at_a.apply(p.on_a);
    assert_true((gap - p.separation * p.normal).norm() < tolerance);
    assert_true(std::fabs(p.separation - separation) < tolerance);
  }
}

/// Each of the places (B's frame) is a point of the manifold, and there are no others.
void assert_at(const Found& f, const std::vector<Vec3>& places, Real tolerance) {
  assert_int_equal(f.manifold.count, places.size());
  for (const Vec3& x : places)
    assert_true(std::any_of(f.manifold.point, f.manifold.point + f.manifold.count,
                            [&](const ContactPoint& p) { return (p.on_b - x).norm() < tolerance; }));
}

/// Every gap, kind and error of the normal up to 1e-2 rad.
void at_many(const std::function<void(Real gap, ManifoldKind kind, const Vec3& off, Random& random)>& check) {
  Random random(11);
  for (int trial = 0; trial < 60; ++trial)
    for (const ManifoldKind kind : kKinds)
      for (const Real gap : {-2e-3, 0.0, 3e-3})
        check(gap, kind, trial == 0 ? Vec3(Vec3::zero()) : Vec3(1e-2 * random.uniform(0, 1) * random.direction()),
              random);
}

/// A prism around y: n corners on a circle.
Shape prism(int n, Real radius, Real half_height) {
  std::vector<Vec3> points;
  for (int i = 0; i < n; ++i) {
    const SinCos c = sin_cos(0.3 + 2 * kPi * i / n);
    points.push_back(Vec3(radius * c.cos, half_height, radius * c.sin));
    points.push_back(Vec3(radius * c.cos, -half_height, radius * c.sin));
  }
  return faced(hull(points));
}

/// Angle between a cone's axis and its side; the pose in which it lies on y = 0, tip and rim along x.
Frame lying_cone(const Shape& c) {
  const Vec3 out = Vec3(2 * c.half_height, c.radius, 0).normalized();  // normal of the side that looks along x
  const Mat3 r = exp_map(Vec3(0, 0, -kPi / 2 - std::atan2(out.y(), out.x()))).matrix();
  return Frame(r, Vec3(0, -(r * Vec3(0, c.half_height, 0)).y(), 0));
}

Real area(const Manifold& m) {  // of four points in order round the patch, any order: the largest crossing of diagonals
  Real best = 0;
  const int order[3][4] = {{0, 1, 2, 3}, {0, 2, 1, 3}, {0, 1, 3, 2}};
  for (const auto& o : order)
    best = std::max(
        best, (m.point[o[2]].on_b - m.point[o[0]].on_b).cross(m.point[o[3]].on_b - m.point[o[1]].on_b).norm() / 2);
  return best;
}

}  // namespace

static void a_box_on_a_box_stands_on_its_four_corners(void**) {
  const Shape slab = faced(box(Vec3(2, 0.5, 2))), brick = faced(box(Vec3(0.3, 0.2, 0.4)));
  at_many([&](Real gap, ManifoldKind kind, const Vec3& off, Random& random) {
    const Frame above = turned(Vec3(0, random.uniform(-3, 3), 0), Vec3(0.3, 0.2, -0.2));
    const Touch t = on_top(slab, 0.5, brick, above, gap, random);
    const Found f = patch_of(t, kind, off);
    assert_at(f, {Vec3(0.3, -0.2, 0.4), Vec3(-0.3, -0.2, 0.4), Vec3(-0.3, -0.2, -0.4), Vec3(0.3, -0.2, -0.4)},
              kRounding);
    assert_consistent(t, f, gap, kRounding);
    assert_true(f.calls == (kind == ManifoldKind::clip ? 0 : 18));
    assert_true(f.memory.firm);
  });
}

static void boxes_that_overhang_share_the_cut_of_their_faces(void**) {
  const Shape a = faced(box(Vec3(0.5, 0.5, 0.5))), b = faced(box(Vec3(0.5, 0.2, 0.5)));
  at_many([&](Real gap, ManifoldKind kind, const Vec3& off, Random& random) {
    const Touch t = on_top(a, 0.5, b, Frame(Mat3::identity(), Vec3(0.4, 0.2, -0.7)), gap, random);
    const Found f = patch_of(t, kind, off);
    // A spans [-0.5, 0.5]^2, B [-0.1, 0.9] x [-1.2, -0.2]: they share [-0.1, 0.5] x [-0.5, -0.2].
    assert_at(f, {Vec3(-0.5, -0.2, 0.2), Vec3(0.1, -0.2, 0.2), Vec3(-0.5, -0.2, 0.5), Vec3(0.1, -0.2, 0.5)}, kRounding);
    assert_consistent(t, f, gap, kRounding);
  });
}

static void a_lying_cylinder_touches_along_its_whole_length(void**) {
  const Shape slab = faced(box(Vec3(2, 0.5, 2))), roller = cylinder(0.3, 0.5);
  at_many([&](Real gap, ManifoldKind kind, const Vec3& off, Random& random) {
    const Frame above = turned(Vec3(0, random.uniform(-3, 3), 0), Vec3(0.3, 0.3, -0.2)) *
                        turned(Vec3(kPi / 2, 0, 0), Vec3::zero()) *
                        turned(Vec3(0, random.uniform(-3, 3), 0), Vec3::zero());
    const Touch t = on_top(slab, 0.5, roller, above, gap, random);
    const Found f = patch_of(t, kind, off);
    const Vec3 down = -0.3 * above.rotate_inverse(Vec3::unit_y());
    assert_at(f, {down + Vec3(0, 0.5, 0), down - Vec3(0, 0.5, 0)}, 1e-9);
    assert_consistent(t, f, gap, kRounding);
    assert_true(f.calls <= 9 + 21);
    assert_false(f.memory.firm);  // it may roll
  });
}

static void a_coin_and_a_cone_stand_on_four_points_of_their_rims(void**) {
  const Shape slab = faced(box(Vec3(2, 0.5, 2))), coin = cylinder(0.3, 0.05), hat = cone(0.3, 0.4);
  at_many([&](Real gap, ManifoldKind kind, const Vec3& off, Random& random) {
    for (const Shape* s : {&coin, &hat}) {
      const Frame above = turned(Vec3(0, random.uniform(-3, 3), 0), Vec3(0.3, s->half_height, -0.2));
      const Touch t = on_top(slab, 0.5, *s, above, gap, random);
      const Found f = patch_of(t, kind, off);
      assert_int_equal(f.manifold.count, 4);
      for (int k = 0; k < 4; ++k) {
        const Vec3& x = f.manifold.point[k].on_b;
        assert_true(std::fabs(x.y() + s->half_height) < kRounding);
        assert_true(std::fabs(std::hypot(x.x(), x.z()) - 0.3) < kRounding);
      }
      assert_true(area(f.manifold) > 2 * 0.3 * 0.3 * (1 - 1e-6));  // a square: the most that four points can hold
      assert_consistent(t, f, gap, kRounding);
      assert_true(f.calls <= 9 + 17);
    }
  });
}

static void an_ellipsoid_touches_in_exactly_one_point(void**) {
  const Shape slab = faced(box(Vec3(2, 0.5, 2)));
  at_many([&](Real gap, ManifoldKind kind, const Vec3& off, Random& random) {
    const Vec3 radii{random.uniform(0.05, 0.5), random.uniform(0.05, 0.5), random.uniform(0.05, 0.5)};
    const Shape egg = ellipsoid(radii);
    const Mat3 r = exp_map(3 * random.direction()).matrix();
    const Vec3 n = r.transpose() * Vec3::unit_y(), scaled = radii.times(n);
    const Frame above(r, Vec3(0.3, scaled.norm(), -0.2));
    const Touch t = on_top(slab, 0.5, egg, above, gap, random);
    const Found f = patch_of(t, kind, off);
    assert_at(f, {Vec3(-radii.times(scaled / scaled.norm()))}, kRounding);
    assert_consistent(t, f, gap, kRounding);
    assert_true(f.calls <= 9 + 25);
  });
}

static void a_lying_cone_touches_from_tip_to_rim(void**) {
  const Shape slab = faced(box(Vec3(2, 0.5, 2)));
  at_many([&](Real gap, ManifoldKind kind, const Vec3& off, Random& random) {
    const Real radius = random.uniform(0.1, 0.5), half_height = random.uniform(0.1, 0.5);  // in this order anywhere
    const Shape hat = cone(radius, half_height);
    const Frame above = lying_cone(hat) * turned(Vec3(0, 0, 0), Vec3::zero());
    const Touch t = on_top(slab, 0.5, hat, above, gap, random);
    const Found f = patch_of(t, kind, off);
    assert_at(f, {Vec3(0, hat.half_height, 0), Vec3(hat.radius, -hat.half_height, 0)},
              1e-7);  // 1e-4 rad of tilt, times 1e-3 that
                      // the stage before leaves of it
    assert_consistent(t, f, gap, kRounding);
    assert_true(f.calls <= 9 + 25);
  });
}

static void rounded_shapes_stand_under_their_cores(void**) {
  const Shape slab = faced(box(Vec3(2, 0.5, 2))), pebble = rounded_box(Vec3(0.3, 0.2, 0.4), 0.1),
              pill = capsule(0.1, 0.4);
  at_many([&](Real gap, ManifoldKind kind, const Vec3& off, Random& random) {
    const Frame spun = turned(Vec3(0, random.uniform(-3, 3), 0), Vec3(0.3, 0, -0.2));
    const Touch t = on_top(slab, 0.5, pebble, Frame(spun.r, spun.p + Vec3(0, 0.3, 0)), gap, random);
    const Found f = patch_of(t, kind, off);
    assert_at(f, {Vec3(0.3, -0.3, 0.4), Vec3(-0.3, -0.3, 0.4), Vec3(-0.3, -0.3, -0.4), Vec3(0.3, -0.3, -0.4)},
              kRounding);
    assert_consistent(t, f, gap, kRounding);
    const Frame lying = Frame(spun.r, spun.p + Vec3(0, 0.1, 0)) * turned(Vec3(kPi / 2, 0, 0), Vec3::zero());
    const Touch u = on_top(slab, 0.5, pill, lying, gap, random);
    const Found g = patch_of(u, kind, off);
    const Vec3 down = -0.1 * lying.rotate_inverse(Vec3::unit_y());
    assert_at(g, {down + Vec3(0, 0.4, 0), down - Vec3(0, 0.4, 0)}, kRounding);
    assert_consistent(u, g, gap, kRounding);
  });
}

static void crossing_edges_and_crossing_cylinders_meet_in_one_point(void**) {
  const Shape bar = faced(box(Vec3(1, 0.1, 0.1))), rod = cylinder(0.1, 1);
  const Real half = 0.1 * std::sqrt(Real(2));
  at_many([&](Real gap, ManifoldKind kind, const Vec3& off, Random& random) {
    const Real turn = random.uniform(0.3, 2.8), slide = random.uniform(-0.5, 0.5);
    const Frame spin = turned(Vec3(0, turn, 0), Vec3(slide, 0, 0));
    const Frame edge = turned(Vec3(kPi / 4, 0, 0), Vec3::zero());
    const Frame world = turned(3 * random.direction(), random.in_cube(2));
    const auto at = [&](Real y) { return Frame(Mat3::identity(), Vec3(0, y, 0)); };
    const Touch t{bar,
                  bar,
                  world * at(-half) * edge,
                  world * at(half + gap) * spin * edge,
                  world.rotate(Vec3::unit_y()),
                  gap,
                  world.apply(spin.p)};
    const Found f = patch_of(t, kind, off);
    assert_at(f, {t.at_b.apply_inverse(world.apply(Vec3(slide, gap, 0)))}, 1e-12);
    assert_consistent(t, f, gap, 1e-12);
    const Frame lying = turned(Vec3(0, 0, kPi / 2), Vec3::zero());
    const Touch u{rod, rod, world * at(-0.1) * lying, world * at(0.1 + gap) * spin * lying, t.normal, gap, t.place};
    const Found g = patch_of(u, kind, off);
    assert_int_equal(g.manifold.count, 1);
    // The cylinders' common normal is across both axes, each known to the 1e-6 that their two rings leave.
    assert_true((u.at_b.apply(g.manifold.point[0].on_b) - world.apply(Vec3(slide, gap, 0))).norm() < 1e-5);
    assert_true(std::fabs(g.manifold.point[0].separation - gap) < 1e-9);
  });
}

static void a_face_of_many_corners_keeps_four_that_hold_its_area(void**) {
  const Shape slab = faced(box(Vec3(2, 0.5, 2)));
  at_many([&](Real gap, ManifoldKind kind, const Vec3& off, Random& random) {
    for (const int n : {3, 5, 6, 8, 12, 100}) {
      const Shape p = prism(n, 0.4, 0.2);
      const Frame above = turned(Vec3(0, random.uniform(-3, 3), 0), Vec3(0.3, 0.2, -0.2));
      const Touch t = on_top(slab, 0.5, p, above, gap, random);
      const Found f = patch_of(t, kind, off);
      assert_int_equal(f.manifold.count, std::min(n, 4));
      assert_consistent(t, f, gap, kRounding);
      for (int k = 0; k < f.manifold.count; ++k)
        assert_true(std::fabs(std::hypot(f.manifold.point[k].on_b.x(), f.manifold.point[k].on_b.z()) - 0.4) <
                    kRounding);
      // Four corners of a regular polygon hold at least a half of the largest square (n = 5: 1.6 of 2 radius^2).
      if (n > 3) assert_true(area(f.manifold) > 0.4 * 0.4);
    }
  });
}

static void a_tilted_box_touches_where_it_is_lowest_and_hovers_elsewhere(void**) {
  const Shape slab = faced(box(Vec3(2, 0.5, 2))), brick = faced(box(Vec3(0.3, 0.2, 0.4)));
  Random random(5);
  for (const ManifoldKind kind : kKinds)
    for (const Real tilt : {1e-6, 1e-4, 1e-3, 1e-2}) {
      // Turned about z: the corners at x = +0.3 rise, those at -0.3 are lowest.
      const Frame lean = turned(Vec3(0, 0, tilt), Vec3::zero());
      const Real low = -(lean.rotate(Vec3(-0.3, -0.2, 0))).y();
      const Touch t = on_top(slab, 0.5, brick, Frame(lean.r, Vec3(0, low, 0)), 0, random);
      const Found f = patch_of(t, kind, 1e-3 * random.direction());
      assert_int_equal(f.manifold.count, 4);
      for (int k = 0; k < 4; ++k) {
        const ContactPoint& p = f.manifold.point[k];
        const Real height = p.on_b.x() < 0 ? 0 : 0.6 * sin_cos(tilt).sin;
        assert_true(std::fabs(p.separation - height) < 1e-12);
        assert_true((p.normal - t.normal).norm() < 1e-12);  // the slab's: it separates better than the brick's
      }
    }
}

static void a_face_that_leans_is_found_as_far_as_the_reach_goes(void**) {
  // A fast body's contact distance covers its step: all corners that may touch within it count, those behind do not.
  const Shape slab = faced(box(Vec3(2, 0.5, 2))), brick = faced(box(Vec3(0.3, 0.2, 0.4)));
  Random random(13);
  for (const ManifoldKind kind : kKinds)
    for (int trial = 0; trial < 50; ++trial) {
      const Real tilt = random.uniform(0.05, 0.25), turn = random.uniform(-3, 3);
      const Frame lean =
          turned(Vec3(0, turn, 0), Vec3::zero()) * turned(tilt * Vec3(1, 0, 1).normalized(), Vec3::zero());
      std::vector<Real> height;
      for (const Real x : {-0.3, 0.3})
        for (const Real z : {-0.4, 0.4}) height.push_back(lean.rotate(Vec3(x, -0.2, z)).y());
      std::sort(height.begin(), height.end());
      const Touch t = on_top(slab, 0.5, brick, Frame(lean.r, Vec3(0, -height[0], 0)), 0, random);
      const Candidates found = candidate_of(t);
      for (const int near : {2, 3, 4}) {  // so many corners within reach
        ManifoldSettings settings = with(kind);
        settings.contact_distance = near == 4 ? 0.4 : (height[near - 1] + height[near]) / 2 - height[0];
        if (leaning(brick, settings.contact_distance) < 1.05 * tilt) continue;
        Manifold m;
        PatchMemory memory;
        std::uint64_t calls = 0;
        SupportFault fault;
        assert_true(update_patch({t.a, t.b, t.at_a, t.at_b, 0}, found, settings, m, memory, calls, fault));
        assert_int_equal(m.count, near);
        assert_true(calls <= 2 * 17);
        for (int k = 0; k < m.count; ++k) {
          const Vec3 corner = t.at_b.apply(m.point[k].on_b) - t.at_a.apply(m.point[k].on_a);
          assert_true((corner - m.point[k].separation * t.normal).norm() < 1e-12);
          assert_true(std::any_of(height.begin(), height.end(),
                                  [&](Real h) { return std::fabs(h - height[0] - m.point[k].separation) < 1e-12; }));
        }
      }
    }
}

/// A coin comes down on its rim. Its face is found from there as far as the reach goes, as that of a box from a corner.
static void a_face_that_leans_is_found_from_its_rim(void**) {
  const Shape slab = faced(box(Vec3(2, 0.5, 2)));
  Random random(29);
  for (const ManifoldKind kind : kKinds)
    for (int trial = 0; trial < 200; ++trial) {
      const Real tilt = random.uniform(0.04, 0.28), radius = random.uniform(0.002, 0.5), half = 0.1 * radius;
      const bool is_cone = trial % 3 == 0;
      const Shape coin = is_cone ? cone(radius, half) : cylinder(radius, half);
      const Frame lean = turned(Vec3(0, random.uniform(-3, 3), 0), Vec3::zero()) *
                         turned(tilt * Vec3::unit_z(), Vec3::zero()) *
                         turned(Vec3(0, random.uniform(-3, 3), 0), Vec3::zero());
      const Real lowest = -half * std::cos(tilt) - radius * std::sin(tilt);
      const Touch t = on_top(slab, 0.5, coin, Frame(lean.r, Vec3(0, -lowest, 0)), 0, random);
      Candidates found = candidate_of(t);
      const Vec3 down = lean.rotate_inverse(-Vec3::unit_y());
      const Vec3 rim = radius / std::hypot(down.x(), down.z()) * Vec3(down.x(), 0, down.z()) - half * Vec3::unit_y();
      found.point[0].on_b = rim, found.point[0].on_a = t.at_a.apply_inverse(t.at_b.apply(rim));
      ManifoldSettings settings = with(kind);
      settings.contact_distance = 2 * radius * std::sin(tilt) * 1.2;
      if (leaning(coin, settings.contact_distance) < 1.05 * tilt) continue;
      Manifold m;
      PatchMemory memory;
      std::uint64_t calls = 0;
      SupportFault fault;
      assert_true(update_patch({t.a, t.b, t.at_a, t.at_b, 0}, found, settings, m, memory, calls, fault));
      assert_int_equal(m.count, 4);
      assert_true(calls <= 9 + 33);
      Real nearest = kInfinity, farthest = 0;
      for (int k = 0; k < m.count; ++k) {
        assert_true(std::fabs(m.point[k].on_b.y() + half) < 1e-9 * radius);  // of the face
        const Vec3 across = t.at_b.apply(m.point[k].on_b) - t.at_a.apply(m.point[k].on_a);
        assert_true((across - m.point[k].separation * t.normal).norm() < 1e-9 * radius);
        nearest = std::min(nearest, m.point[k].separation), farthest = std::max(farthest, m.point[k].separation);
      }
      assert_true(nearest < 0.1 * radius * tilt);  // where it comes down
      assert_true(farthest > nearest + 0.01 * radius * tilt);
    }
}

static void a_half_space_carries_whatever_lies_on_it(void**) {
  const Shape ground = half_space(Vec3::unit_y(), 0);
  const Shape brick = faced(box(Vec3(0.3, 0.2, 0.4))), coin = cylinder(0.3, 0.05), roller = cylinder(0.3, 0.5),
              egg = ellipsoid(Vec3(0.3, 0.2, 0.4));
  Random random(6);
  for (int trial = 0; trial < 100; ++trial)
    for (const ManifoldKind kind : kKinds)
      for (const bool swapped : {false, true}) {
        const Frame world = turned(3 * random.direction(), random.in_cube(2));
        const Frame spun = turned(Vec3(0, random.uniform(-3, 3), 0), Vec3(1, -1e-3, 2));
        const auto count = [&](const Shape& s, const Frame& f, Real height) {
          const Frame at = world * Frame(f.r, f.p + Vec3(0, height, 0));
          const Vec3 up = world.rotate(Vec3::unit_y());
          const Touch t =
              swapped ? Touch{s, ground, at, world, -up, -1e-3, at.p} : Touch{ground, s, world, at, up, -1e-3, at.p};
          const Found found = patch_of(t, kind);
          assert_consistent(t, found, -1e-3, 1e-12);
          return found.manifold.count;
        };
        assert_int_equal(count(brick, spun, 0.2), 4);
        assert_int_equal(count(coin, spun, 0.05), 4);
        assert_int_equal(count(roller, spun * turned(Vec3(kPi / 2, 0, 0), Vec3::zero()), 0.3), 2);
        assert_int_equal(count(egg, spun, 0.2), 1);
      }
}

static void a_box_of_a_millimetre_has_four_corners_too(void**) {
  const Shape slab = faced(box(Vec3(0.1, 0.05, 0.1))), grain = faced(box(Vec3::constant(5e-4)));
  Random random(7);
  for (const ManifoldKind kind : kKinds) {
    const Touch t = on_top(slab, 0.05, grain, Frame(Mat3::identity(), Vec3(0.01, 5e-4, 0.02)), 1e-5, random);
    assert_int_equal(patch_of(t, kind).manifold.count, 4);
  }
}

namespace {

/// A pair in the narrow phase, step by step.
struct Steps {
  Colliders table{std::pmr::get_default_resource()};
  Array<Pair> all{{0, 1}};
  PairTable pairs{std::pmr::get_default_resource()};
  NarrowSettings settings;
  NarrowReport report;
  Array<SupportFault> faults;

  Steps(const Shape& a, const Shape& b, ManifoldKind kind) {
    settings.query.routines = false;
    settings.manifold = with(kind);
    settings.manifold.keep_distance = 2e-4;
    table.shape = {&a, &b};
    table.frame.resize(2);
    table.travel.resize(2, 0);
    table.reach.resize(2, 0);
  }
  const Manifold& step(const Frame& a, const Frame& b) {
    table.place(0, a), table.place(1, b);
    pairs.update(all);
    report = NarrowReport{};
    narrow_phase(table, settings, pairs, report, faults);
    return pairs[0].manifold;
  }
};

struct Rest {
  const char* name;
  Shape shape;
  Frame at;  // above a slab whose top is y = 0
  int points;
};

std::vector<Rest> resting_shapes() {
  std::vector<Rest> all;
  all.push_back({"box", faced(box(Vec3(0.3, 0.2, 0.4))), turned(Vec3(0, 0.4, 0), Vec3(0.1, 0.2, 0)), 4});
  all.push_back({"lying cylinder", cylinder(0.3, 0.5), turned(Vec3(kPi / 2, 0, 0), Vec3(0, 0.3, 0.1)), 2});
  all.push_back({"coin", cylinder(0.3, 0.05), turned(Vec3(0, 0.4, 0), Vec3(0.1, 0.05, 0)), 4});
  all.push_back({"cone", cone(0.3, 0.4), turned(Vec3(0, 0.4, 0), Vec3(0.1, 0.4, 0)), 4});
  all.push_back({"rounded box", rounded_box(Vec3(0.3, 0.2, 0.4), 0.1), turned(Vec3(0, 0.4, 0), Vec3(0.1, 0.3, 0)), 4});
  all.push_back({"prism", prism(7, 0.4, 0.2), turned(Vec3(0, 0.4, 0), Vec3(0.1, 0.2, 0)), 4});
  return all;
}

}  // namespace

static void turning_the_world_leaves_the_points_where_they_are(void**) {
  const Shape slab = faced(box(Vec3(2, 0.5, 2)));
  const Frame below(Mat3::identity(), Vec3(0, -0.5, 0));
  Random random(8);
  for (const Rest& rest : resting_shapes())
    for (const ManifoldKind kind : kKinds) {
      Steps steps(slab, rest.shape, kind);
      const Manifold first = steps.step(below, rest.at);
      assert_int_equal(first.count, rest.points);
      for (std::uint32_t i = 1; i <= 50; ++i) {
        const Frame world = turned(3 * random.direction(), random.in_cube(10));
        steps.pairs[0].patch.firm = false;  // ask again: a relative pose that did not change would be kept
        const Manifold& now = steps.step(world * below, world * rest.at);
        assert_int_equal(now.count, rest.points);
        for (int k = 0; k < now.count; ++k) {
          assert_true((now.point[k].on_a - first.point[k].on_a).norm() < 1e-9);
          assert_true((now.point[k].on_b - first.point[k].on_b).norm() < 1e-9);
          assert_int_equal(now.point[k].age, i);
        }
      }
    }
}

static void sliding_and_turning_bodies_keep_their_points(void**) {
  // 1 mm and 3 mrad a step, as bodies at 6 cm/s do; what a point may move in a step is bounded by that, too.
  const Shape slab = faced(box(Vec3(4, 0.5, 4)));
  const Frame below(Mat3::identity(), Vec3(0, -0.5, 0));
  Random random(9);
  for (const Rest& rest : resting_shapes())
    for (const ManifoldKind kind : kKinds) {
      Steps steps(slab, rest.shape, kind);
      Manifold before = steps.step(below, rest.at);
      for (std::uint32_t i = 1; i <= 300; ++i) {
        const Frame slide(exp_map(Vec3(0, 3e-3 * i, 0)).matrix(), Vec3(1e-3 * i, 0, -5e-4 * i));
        const Frame jitter = turned(1e-5 * random.direction(), 1e-6 * random.direction());
        const Manifold& now = steps.step(below, slide * rest.at * jitter);
        assert_int_equal(now.count, rest.points);
        for (int k = 0; k < now.count; ++k) {
          assert_int_equal(now.point[k].age, i);
          assert_true((now.point[k].on_a - before.point[k].on_a).norm() < 1e-3 * 1.2 + 3e-3 * 1.0);
          // In the body they stay where they are; along a lying cylinder they creep with the jitter of its roll.
          assert_true((now.point[k].on_b - before.point[k].on_b).norm() < 5e-5);
        }
        before = now;
      }
    }
}

static void a_patch_is_kept_while_little_moves_and_asked_for_again_after(void**) {
  const Shape slab = faced(box(Vec3(2, 0.5, 2))), brick = faced(box(Vec3(0.3, 0.2, 0.4)));
  const Frame below(Mat3::identity(), Vec3(0, -0.5, 0));
  for (const ManifoldKind kind : kKinds) {
    Steps steps(slab, brick, kind);
    steps.step(below, turned(Vec3::zero(), Vec3(0, 0.2, 0)));
    assert_int_equal(steps.report.kept_patches, 0);
    assert_true(steps.report.support_calls > 0);
    const Manifold& kept = steps.step(below, turned(Vec3::zero(), Vec3(1.5e-4, 0.2001, 0)));
    assert_int_equal(steps.report.kept_patches, 1);
    assert_int_equal(steps.report.support_calls, 0);
    for (int k = 0; k < 4; ++k) {
      assert_true(std::fabs(kept.point[k].separation - 1e-4) < 1e-15);
      assert_int_equal(kept.point[k].age, 1);
    }
    steps.step(below, turned(Vec3::zero(), Vec3(2.1e-4, 0.2, 0)));
    assert_int_equal(steps.report.kept_patches, 0);
    steps.step(below, turned(Vec3(0, 3e-4, 0), Vec3(2.1e-4, 0.2, 0)));  // 3e-4 rad at 0.54 m
    assert_int_equal(steps.report.kept_patches, 1);
    steps.step(below, turned(Vec3(0, 5e-4, 0), Vec3(2.1e-4, 0.2, 0)));
    assert_int_equal(steps.report.kept_patches, 0);
    steps.step(below, turned(Vec3::zero(), Vec3(0, 0.3, 0)));  // far apart
    assert_int_equal(steps.pairs[0].manifold.count, 0);
    steps.step(below, turned(Vec3::zero(), Vec3(0, 0.3, 0)));
    assert_int_equal(steps.report.kept_patches, 0);
  }
}

static void kept_separations_are_what_asking_again_would_say(void**) {
  const Shape slab = faced(box(Vec3(2, 0.5, 2))), brick = faced(box(Vec3(0.3, 0.2, 0.4)));
  const Frame below(Mat3::identity(), Vec3(0, -0.5, 0));
  Random random(10);
  for (int trial = 0; trial < 200; ++trial) {
    Steps kept(slab, brick, ManifoldKind::patch), fresh(slab, brick, ManifoldKind::patch);
    kept.step(below, turned(Vec3::zero(), Vec3(0, 0.2, 0)));
    const Frame moved = turned(1e-4 * random.direction(), Vec3(0, 0.2, 0) + 1e-4 * random.direction());
    const Manifold &m = kept.step(below, moved), &f = fresh.step(below, moved);
    assert_int_equal(kept.report.kept_patches, 1);
    for (int k = 0; k < 4; ++k) {
      Real nearest = kInfinity, difference = 0;
      for (int j = 0; j < 4; ++j) {
        const Real d = (m.point[k].on_b - f.point[j].on_b).norm();
        if (d < nearest) nearest = d, difference = m.point[k].separation - f.point[j].separation;
      }
      assert_true(nearest < 1e-12);  // the same corner
      assert_true(std::fabs(difference) < 1e-12);
    }
  }
}

static void edges_that_cross_are_kept_within_the_square_of_the_way(void**) {
  const Shape a = faced(box(Vec3(0.5, 0.5, 0.5))), b = faced(box(Vec3(0.3, 0.3, 0.6)));
  const Real quarter = std::acos(Real(-1)) / 4, apart = std::sqrt(0.5) + 0.3 * std::sqrt(2.0);
  const Frame below(exp_map(Vec3(quarter, 0, 0)).matrix(), Vec3::zero()),
      over(exp_map(Vec3(0, 0, quarter)).matrix(), Vec3(0, apart + 1e-3, 0));
  Random random(14);
  for (const bool routines : {false, true})
    for (const Real way : {1e-4, 1e-3, 3e-3})
      for (int trial = 0; trial < 100; ++trial) {
        Steps kept(a, b, ManifoldKind::clip), fresh(a, b, ManifoldKind::clip);
        kept.settings.query.routines = fresh.settings.query.routines = routines;
        kept.settings.manifold.keep_distance = 2 * way, fresh.settings.manifold.keep_distance = 0;
        assert_int_equal(kept.step(below, over).count, 1);
        const Real radius = std::min(a.bounding_radius, b.bounding_radius);
        const Real angle = random.uniform(0, 1) * way / radius, shift = random.uniform(0, 1) * way;
        const Frame turn(exp_map(angle * random.direction()).matrix(), Vec3::zero());
        const Frame moved(over.r * turn.r, over.p + shift * random.direction());
        const Manifold &m = kept.step(below, moved), &f = fresh.step(below, moved);
        assert_int_equal(kept.report.kept_patches, 1);
        assert_int_equal(fresh.report.kept_patches, 0);
        // With the normal of the beginning: off by the turn, d / r at most, times the way along the surfaces.
        const Real d = motion_bound(over, moved, a.bounding_radius, b.bounding_radius);
        Real least = kInfinity;
        for (int k = 0; k < f.count; ++k) least = std::min(least, f.point[k].separation);
        assert_true(std::fabs(m.point[0].separation - least) < d * d / radius + 1e-12);
      }
}

static void a_shape_that_fails_while_it_is_probed_is_reported(void**) {
  static int left;
  Shape slab = box(Vec3(2, 0.5, 2)), invalid_plugin = box(Vec3(0.3, 0.2, 0.4));
  invalid_plugin.form = Form::none;  // else the engine would speak for it
  invalid_plugin.support = [](void* user, const double* p, std::uint64_t n, const double* d,
                              double* out) -> std::int32_t { return --left < 0 ? 7 : box_support(user, p, n, d, out); };
  Random random(12);
  for (left = 0; left < 9;) {
    const int allowed = left;
    const Touch t = on_top(slab, 0.5, invalid_plugin, turned(Vec3::zero(), Vec3(0, 0.2, 0)), 0, random);
    const Candidates found = candidate_of(t);
    Manifold m;
    m.count = 3;
    PatchMemory memory;
    std::uint64_t calls = 0;
    SupportFault fault;
    assert_false(
        update_patch({t.a, t.b, t.at_a, t.at_b, 0}, found, with(ManifoldKind::patch), m, memory, calls, fault));
    assert_int_equal(fault.kind, SupportFault::returned);
    assert_ptr_equal(fault.shape, &invalid_plugin);
    assert_int_equal(m.count, 0);
    assert_false(memory.firm);
    left = allowed + 1;
  }
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(a_box_on_a_box_stands_on_its_four_corners),
      cmocka_unit_test(boxes_that_overhang_share_the_cut_of_their_faces),
      cmocka_unit_test(a_lying_cylinder_touches_along_its_whole_length),
      cmocka_unit_test(a_coin_and_a_cone_stand_on_four_points_of_their_rims),
      cmocka_unit_test(an_ellipsoid_touches_in_exactly_one_point),
      cmocka_unit_test(a_lying_cone_touches_from_tip_to_rim),
      cmocka_unit_test(rounded_shapes_stand_under_their_cores),
      cmocka_unit_test(crossing_edges_and_crossing_cylinders_meet_in_one_point),
      cmocka_unit_test(a_face_of_many_corners_keeps_four_that_hold_its_area),
      cmocka_unit_test(a_tilted_box_touches_where_it_is_lowest_and_hovers_elsewhere),
      cmocka_unit_test(a_face_that_leans_is_found_as_far_as_the_reach_goes),
      cmocka_unit_test(a_face_that_leans_is_found_from_its_rim),
      cmocka_unit_test(a_half_space_carries_whatever_lies_on_it),
      cmocka_unit_test(a_box_of_a_millimetre_has_four_corners_too),
      cmocka_unit_test(turning_the_world_leaves_the_points_where_they_are),
      cmocka_unit_test(sliding_and_turning_bodies_keep_their_points),
      cmocka_unit_test(a_patch_is_kept_while_little_moves_and_asked_for_again_after),
      cmocka_unit_test(kept_separations_are_what_asking_again_would_say),
      cmocka_unit_test(edges_that_cross_are_kept_within_the_square_of_the_way),
      cmocka_unit_test(a_shape_that_fails_while_it_is_probed_is_reported),
  };
  return cmocka_run_group_tests_name("collision/patch", tests, nullptr, nullptr);
}
