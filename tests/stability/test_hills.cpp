// Bodies of every shape dropped on, thrown at and rolled over height fields: none gets through, none stays sunk.
//
//   tests_stability hills 300    falls of each kind in place of one, or four by night: the large sweep, some minutes
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "carom_test.h"
#include "collision/support.h"
#include "scenery_builder.h"
#include "sliced.h"
#include "world_builder.h"

using namespace carom;
using namespace carom::test;

namespace {

int falls_of_each = sliced(4, 1, 1);

struct Dice {
  std::uint64_t state;
  Real operator()(Real lo, Real hi) {
    state ^= state << 13, state ^= state >> 7, state ^= state << 17;
    return lo + (hi - lo) * static_cast<Real>(state >> 11) * 0x1p-53;
  }
  Vec3 within(Real most) {
    Vec3 x;
    for (int i = 0; i < 3; ++i) x[i] = (*this)(-most, most);
    return x;
  }
  Quat turn() {
    Quat q;
    do {
      const Vec3 v = within(1);
      q = Quat((*this)(-1, 1), v.x(), v.y(), v.z());
    } while (!(q.squared_norm() > 0.01 && q.squared_norm() < 1));
    return normalized(q);
  }
};

constexpr int kSide = 17;  // vertices

/// Hills in a bowl, from one corner at the origin on.
struct Hills {
  Real spacing;  // m
  std::vector<Real> height;

  /// @param slope  the most that a height differs from its neighbour's, in steps of the grid
  Hills(Dice& dice, Real step, Real slope) : spacing(step) {
    for (int z = 0; z < kSide; ++z)
      for (int x = 0; x < kSide; ++x) {
        const Real edge = reach(spacing * Vec3(x, 0, z)), square = edge * edge;
        height.push_back(spacing * (dice(0, slope) + 8 * square * square * square));
      }
  }
  Real at(int x, int z) const { return height[static_cast<std::size_t>(z * kSide + x)]; }
  Shape shape() const {
    return height_field(kSide, kSide, spacing, spacing,
                        [&](std::uint32_t x, std::uint32_t z) { return at(static_cast<int>(x), static_cast<int>(z)); });
  }
  /// How far out a place is: 0 in the middle, 1 at the rim.
  Real reach(const Vec3& p) const {
    return std::max(std::fabs(p.x() / spacing - 8), std::fabs(p.z() / spacing - 8)) / 8;
  }
  /// m: how far a place is above the ground along the normal there; cells are divided from the first corner to the far
  /// one.
  Real above(const Vec3& p, Vec3* normal = nullptr) const {
    const Real u = p.x() / spacing, v = p.z() / spacing;
    const int x = std::clamp(static_cast<int>(u), 0, kSide - 2), z = std::clamp(static_cast<int>(v), 0, kSide - 2);
    const Real s = u - x, t = v - z;
    const Real du = s >= t ? at(x + 1, z) - at(x, z) : at(x + 1, z + 1) - at(x, z + 1);
    const Real dv = s >= t ? at(x + 1, z + 1) - at(x + 1, z) : at(x, z + 1) - at(x, z);
    const Vec3 n = Vec3(-du / spacing, 1, -dv / spacing).normalized();
    if (normal) *normal = n;
    return (p.y() - (at(x, z) + du * s + dv * t)) * n.y();
  }
};

enum class Made { box, sphere, capsule, cylinder, cone, ellipsoid, hull, undeclared };
constexpr Made kAll[] = {Made::box,  Made::sphere,    Made::capsule, Made::cylinder,
                         Made::cone, Made::ellipsoid, Made::hull,    Made::undeclared};

struct Fall {
  Made kind = Made::box;
  Real spacing, slope;  // of the hills: m, 1
  Real size;            // m: the longest half of the body; others are up to three times less
  Real hz;
  Real height = 1;           // m: that it falls from
  Real speed = 0, spin = 0;  // m/s, rad/s: the most, along each axis
  Real friction = 0.5;
  Real thin = 1;   // how many times thinner than else
  int bodies = 1;  // one above the other
};

Vec3 halves(const Fall& f, Dice& dice) {
  const Real a = dice(0.35, 1), b = dice(0.35, 1);
  return f.size * Vec3(a / f.thin, 1, b);
}

const Shape* shape_for(TestWorld& t, const Fall& f, Dice& dice) {
  const Vec3 h = halves(f, dice);
  std::vector<Vec3> corners;
  switch (f.kind) {
    case Made::box:
      return t.keep(box(h));
    case Made::sphere:
      return t.keep(sphere(h.x()));
    case Made::capsule:
      return t.keep(capsule(h.x(), h.y()));
    case Made::cylinder:
      return t.keep(cylinder(h.x(), h.y()));
    case Made::cone:
      return t.keep(cone(h.x(), h.y()));
    case Made::ellipsoid:
      return t.keep(ellipsoid(h));
    case Made::hull:
      for (int axis = 0; axis < 3; ++axis)
        for (const Real side : {-1.0, 1.0}) corners.push_back(side * h.times(Vec3(axis == 0, axis == 1, axis == 2)));
      for (int i = 0; i < 8; ++i)
        corners.push_back(0.7 * h.times(Vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1)));
      return t.keep(hull(corners));
    default: {
      Shape* const s = const_cast<Shape*>(t.keep(cylinder(h.x(), h.y())));
      s->form = Form::none;  // its mass is known: what is left is a support function
      return s;
    }
  }
}

/// m: how deep the body's points are in the ground, of those that look down and are over the field; negative above it.
Real depth(const TestWorld& t, const Hills& hills, const Shape& shape, std::uint32_t body) {
  const Vec3 x = t.world.state.x[body];
  const Mat3 r = t.world.state.q[body].matrix();
  Vec3 n;
  hills.above(x, &n);
  Real most = -kInfinity;
  SupportFault fault;
  for (int i = -2; i <= 2; ++i)
    for (int j = -2; j <= 2; ++j) {
      Vec3 point;
      const Vec3 way = r.transpose() * Vec3(0.5 * i - n.x(), -n.y(), 0.5 * j - n.z());
      assert_true(full_support(shape, way.normalized(), point, fault));
      const Vec3 place = x + r * (point - t.world.scene.center[body]);
      if (hills.reach(place) < 1) most = std::max(most, -hills.above(place));
    }
  return most;
}

struct Course {
  Real under = 0;  // s, at a time: its centre in the ground
  Real deep = 0;   // s, at a time: so deep that anybody sees it
  bool over_rim = false;
};

/// m, that a body may stay deep: 1 mm that is left unresolved, and 2 % of its thickness.
Real borne(const Shape& shape) { return 0.001 + 0.02 * thickness(shape); }

Course run(const Fall& f, std::uint64_t seed) {
  Dice dice{seed * 0x9E3779B97F4A7C15u + 1};
  for (int i = 0; i < 8; ++i) dice(0, 1);
  const Hills hills(dice, f.spacing, f.slope);
  TestWorld t;
  const std::uint32_t material = t.material(f.friction, 0);
  t.add(t.keep(hills.shape()), Vec3::zero(), BodyType::fixed, Quat::identity(), material);
  const Real middle = 8 * f.spacing;
  std::vector<std::pair<std::uint32_t, const Shape*>> bodies;
  for (int k = 0; k < f.bodies; ++k) {
    const Shape* const shape = shape_for(t, f, dice);
    const Real x = middle + dice(-2, 2) * f.spacing, z = middle + dice(-2, 2) * f.spacing;
    const Real y = f.slope * f.spacing + (1.5 + 2.5 * k) * f.size + f.height;
    const Quat q = dice.turn();
    bodies.emplace_back(t.add(shape, Vec3(x, y, z), BodyType::dynamic, q, material), shape);
    const Vec3 v = dice.within(f.speed), w = dice.within(f.spin);
    t.world.set_velocity(bodies.back().first, v, w);
  }
  Course most;
  std::vector<Course> now(bodies.size());
  for (int step = 0; step < 3 * f.hz; ++step) {
    t.world.step(1 / f.hz);
    for (std::size_t k = 0; k < bodies.size(); ++k) {
      const auto& [body, shape] = bodies[k];
      now[k].over_rim |= hills.reach(t.world.state.x[body]) > 1;
      if (now[k].over_rim) continue;
      now[k].under = hills.above(t.world.state.x[body]) < 0 ? now[k].under + 1 / f.hz : 0;
      now[k].deep = depth(t, hills, *shape, body) > 5 * borne(*shape) ? now[k].deep + 1 / f.hz : 0;
      most.under = std::max(most.under, now[k].under), most.deep = std::max(most.deep, now[k].deep);
    }
  }
  return most;
}

constexpr Real kLasting = 1.0 / 6;  // s: an impact is over by then

void check(Fall f, int first = 1) {
  static OneOf turn(1, 5);
  for (const Made kind : kAll) {
    if (!turn.next()) continue;
    for (int seed = first; seed < first + falls_of_each; ++seed) {
      f.kind = kind;
      const Course c = run(f, static_cast<std::uint64_t>(seed));
      assert_true(c.under < kLasting);
      assert_true(c.deep < kLasting);
    }
  }
}

}  // namespace

/// Bodies smaller than a cell, as large, larger; hills from nearly flat to steeper than one in one.
static void what_is_dropped_on_hills_stays_on_them(void**) {
  for (const Real hz : {30.0, 60.0, 120.0, 240.0})
    for (const Real spacing : {0.1, 0.3, 1.0})
      for (const Real slope : {0.1, 0.5, 1.2})
        check({.spacing = spacing, .slope = slope, .size = hz < 50 ? 0.12 : 0.06, .hz = hz});
}

static void what_is_thrown_at_hills_stays_on_them(void**) {
  for (const Real hz : {60.0, 144.0})
    for (const Real size : {0.05, 0.2})
      for (const Real speed : {3.0, 8.0})
        check({.spacing = 0.3, .slope = 0.8, .size = size, .hz = hz, .height = 0.3, .speed = speed, .spin = 15});
}

static void what_comes_faster_than_contacts_reach_does_not_pass(void**) {
  for (const Real speed : {20.0, 60.0})
    for (const Real spacing : {0.15, 0.5})
      check({.spacing = spacing, .slope = 0.3, .size = 0.07, .hz = 60, .height = 3, .speed = speed, .spin = 5});
}

static void what_rolls_over_hills_does_not_sink_into_them(void**) {
  for (const Real friction : {0.2, 1.0})
    for (const Real hz : {60.0, 90.0})
      check({.spacing = 0.4,
             .slope = 0.15,
             .size = 0.1,
             .hz = hz,
             .height = 0.02,
             .speed = 4,
             .spin = 40,
             .friction = friction});
}

// Scenes that were looked at only after those above held.

static void a_heap_on_hills_stays_on_them(void**) {
  for (const Real spacing : {0.13, 0.7})
    check({.spacing = spacing, .slope = 0.4, .size = 0.09, .hz = 60, .height = 0.2, .spin = 4, .bodies = 6}, 40);
}

static void what_is_four_times_flatter_stays_on_hills(void**) {
  for (const Real hz : {60.0, 180.0})
    check({.spacing = 0.25, .slope = 0.6, .size = 0.1, .hz = hz, .height = 0.7, .spin = 3, .thin = 4}, 60);
}

static void other_sizes_and_steps_stay_on_hills(void**) {
  check({.spacing = 0.07, .slope = 0.9, .size = 0.4, .hz = 45, .spin = 2}, 80);
  check({.spacing = 2.3, .slope = 0.25, .size = 0.03, .hz = 75, .speed = 1}, 80);
  check({.spacing = 0.05, .slope = 0.3, .size = 0.025, .hz = 200, .height = 2, .spin = 30}, 80);
  check({.spacing = 8, .slope = 0.1, .size = 1.5, .hz = 30, .height = 4, .speed = 5, .spin = 1, .friction = 0.1}, 80);
}

int main(int argc, char** argv) {
  if (argc > 1) falls_of_each = std::atoi(argv[1]);
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(what_is_dropped_on_hills_stays_on_them),
      cmocka_unit_test(what_is_thrown_at_hills_stays_on_them),
      cmocka_unit_test(what_comes_faster_than_contacts_reach_does_not_pass),
      cmocka_unit_test(what_rolls_over_hills_does_not_sink_into_them),
      cmocka_unit_test(a_heap_on_hills_stays_on_them),
      cmocka_unit_test(what_is_four_times_flatter_stays_on_hills),
      cmocka_unit_test(other_sizes_and_steps_stay_on_hills),
  };
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
