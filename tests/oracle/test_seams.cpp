// Seams of flush colliders are not felt: what slides over them keeps its height and its speed, whatever the ground is
// made of. Steps, walls and grooves act as ever.
#include <numbers>

#include "carom_test.h"
#include "scenery_builder.h"
#include "sliced.h"
#include "world_builder.h"

using namespace carom;
using namespace carom::test;

namespace {

struct Ride {
  Real speed, step;  // m/s, s
  bool skew;         // the ground is tilted with its gravity, and the seams run aslant
};
constexpr Ride kRides[] = {{5, 1.0 / 60, false}, {20, 1.0 / 60, true}, {1, 1.0 / 60, true}, {11, 1.0 / 30, false}};
const std::size_t kMostRides = sliced<std::size_t>(4, 4, 2);
constexpr Real kRadius = 0.1;
// m: what soft contacts give way by under a body that was set down in exact touch, for any ground (a single box, too).
constexpr Real kSettles = 1.3e-4;
constexpr Real kHop = 1e-4, kLost = 1e-3;

enum class Tiles { boxes, bond, hulls, meshes, fields, beside, parts, driven, hull_field, driven_mesh, count };
enum class Mover { ball, box, stick, can, count };

Shape square(Real h) {
  Triangles t;
  t.vertex(-h, 0, -h), t.vertex(h, 0, -h), t.vertex(h, 0, h), t.vertex(-h, 0, h);
  t.triangle(0, 2, 1), t.triangle(0, 3, 2);
  return mesh(t);
}
Shape slab(Real h) {
  std::vector<Vec3> corners;
  for (int i = 0; i < 8; ++i) corners.emplace_back(i & 1 ? h : -h, i & 2 ? 0 : -0.3, i & 4 ? h : -h);
  return hull(corners);
}

/// Square tiles whose tops are y = 0, all turned alike.
struct Floor : TestWorld {
  Floor(Tiles kind, Real side, const Quat& tilt, const Quat& turn)
      : TestWorld(tilt * Vec3(0, -9.81, 0)), smooth(material(0, 0)) {
    const Real h = side / 2;
    const Shape *const brick = keep(box(Vec3(h, 0.25, h))), *const hulled = keep(slab(h));
    const Shape *const flat = keep(square(h)), *const field = keep(height_field(
                                                   3, 3, h, h, [](std::uint32_t, std::uint32_t) { return 0.0; }));
    const Quat q = tilt * turn;
    const BodyType type = kind == Tiles::driven ? BodyType::kinematic : BodyType::fixed;
    const std::uint32_t whole = kind == Tiles::parts ? add(nullptr, Vec3::zero(), type, q) : 0;
    for (int i = -5; i <= 9; ++i)
      for (int k = -5; k <= 6; ++k) {
        const bool odd = (i + k) % 2 != 0;
        const Shape* tile = brick;
        if (kind == Tiles::hulls) tile = hulled;
        if (kind == Tiles::meshes || (kind == Tiles::beside && odd)) tile = flat;
        if (kind == Tiles::fields) tile = field;
        if (kind == Tiles::hull_field) tile = odd ? hulled : field;
        if (kind == Tiles::driven_mesh && odd) tile = flat;
        const Real shift = kind == Tiles::bond && k % 2 != 0 ? 0.5 : 0;
        Vec3 at(side * (i + shift), tile == brick ? -0.25 : 0, side * (k + 0.5));
        if (tile == field) at -= Vec3(h, 0, h);
        if (kind == Tiles::parts) {
          world.add_collider(whole, tile, Pose{Quat::identity(), at}, 1000, smooth);
          continue;
        }
        const BodyType own = kind == Tiles::driven_mesh && !odd ? BodyType::kinematic : type;
        const std::uint32_t body = add(tile, q * at, own, q, smooth);
        if (kind == Tiles::driven) world.set_velocity(body, q * Vec3(0.7, 0, 0), Vec3::zero());
      }
  }
  std::uint32_t smooth;
};

Shape mover(Mover kind) {
  switch (kind) {
    case Mover::ball:
      return sphere(kRadius);
    case Mover::box:
      return box(Vec3(0.12, kRadius, 0.09));
    case Mover::stick:
      return capsule(0.04, kRadius - 0.04);
    default:
      return cylinder(0.11, kRadius);
  }
}

void nothing_feels_a_seam(void**) {
  const Quat tilt = exp_map(Vec3(0.2, 0.1, -0.4)), turn = exp_map(Vec3(0, 0.35, 0)), none = Quat::identity();
  for (int tiles = 0; tiles < static_cast<int>(Tiles::count); ++tiles)
    for (int m = 0; m < static_cast<int>(Mover::count); ++m)
      for (std::size_t k = 0; k < kMostRides; ++k) {
        const Ride& ride = kRides[k];
        const Quat up = ride.skew ? tilt : none;
        Floor f(static_cast<Tiles>(tiles), ride.skew ? 0.43 : 0.5, up, ride.skew ? turn : none);
        const std::uint32_t body = f.add(f.keep(mover(static_cast<Mover>(m))), up * Vec3(-0.913, kRadius, 0.0131),
                                         BodyType::dynamic, up, f.smooth);
        f.world.set_velocity(body, up * Vec3(ride.speed, 0, 0), Vec3::zero());
        if (static_cast<Mover>(m) == Mover::stick)
          f.world.set_attribute(body, AttributeId::locks, {Real(kAngularLocks)});
        Real hop = 0, dip = 0;
        for (int i = 0; i * ride.step * ride.speed < 1.8; ++i) {
          f.world.step(ride.step);
          const Real rise = (up.conjugate() * f.world.state.x[body]).y() - kRadius;
          hop = std::max(hop, rise), dip = std::max(dip, -rise);
        }
        const Vec3 v = up.conjugate() * f.world.state.v[body];
        const bool fine = hop < kHop && dip < kSettles && std::fabs(v.x() / ride.speed - 1) < kLost &&
                          std::fabs(v.z() / ride.speed) < kLost;
        if (!fine)
          print_error("tiles %d, mover %d, ride %zu: hop %g, dip %g, v %g %g\n", tiles, m, k, hop, dip, v.x(), v.z());
        assert_true(fine);
      }
}

/// A sled of two flush boxes, over rails of pieces that end under it: seams of the body itself.
void nor_does_a_body_of_parts(void**) {
  for (const Real speed : {2.0, 7.0, 18.0}) {
    TestWorld t;
    const std::uint32_t smooth = t.material(0, 0);
    const Shape *const rail = t.keep(box(Vec3(0.21, 0.05, 0.04))), *const part = t.keep(box(Vec3(0.1, 0.05, 0.4)));
    for (int i = -5; i <= 8; ++i)
      for (const Real z : {-0.3, 0.3}) t.add(rail, Vec3(0.42 * i, -0.05, z), BodyType::fixed, Quat::identity(), smooth);
    const std::uint32_t sled = t.add(nullptr, Vec3(-1.313, 0.05, 0));
    for (const Real x : {-0.1, 0.1})
      t.world.add_collider(sled, part, Pose{Quat::identity(), Vec3(x, 0, 0)}, 1000, smooth);
    t.world.set_velocity(sled, Vec3(speed, 0, 0), Vec3::zero());
    Real off = 0;
    for (int i = 0; i * speed / 60 < 2.5; ++i) {
      t.world.step(1.0 / 60);
      off = std::max(off, std::fabs(t.world.state.x[sled].y() - 0.05));
    }
    assert_true(off < kSettles);
    assert_true(std::fabs(t.world.state.v[sled].x() / speed - 1) < kLost);
  }
}

/// What lies and rolls, its axis across its way, over slabs that end under it at any angle: by every fraction of a turn in a step.
void nor_does_what_rolls_on_its_side(void**) {
  struct Roll {
    Real radius, half, speed, heading;  // m, m, m/s, rad
    bool is_capsule;
    Tiles tiles;
  };
  constexpr Roll kRolls[] = {{0.17, 0.24, 5.5, 0, false, Tiles::boxes},  {0.12, 0.31, 9.3, 0.4, true, Tiles::hulls},
                             {0.23, 0.18, 17, 0, true, Tiles::boxes},    {0.1, 0.33, 19, -0.9, false, Tiles::parts},
                             {0.31, 0.4, 3.1, 0.2, true, Tiles::beside}, {0.15, 0.2, 14, 0.1, false, Tiles::bond}};
  for (const Roll& roll : kRolls)
    for (const Real friction : {0.3, 0.9}) {
      Floor f(roll.tiles, 0.83, Quat::identity(), exp_map(Vec3(0, 0.05, 0)));
      const std::uint32_t rough = f.material(friction, 0);
      const Quat heads = exp_map(Vec3(0, roll.heading, 0)), lies = heads * exp_map(Vec3(std::numbers::pi / 2, 0, 0));
      const Vec3 way = heads * Vec3(1, 0, 0), axis = heads * Vec3(0, 0, 1);
      const Shape* const shape =
          f.keep(roll.is_capsule ? capsule(roll.radius, roll.half) : cylinder(roll.radius, roll.half));
      const std::uint32_t body = f.add(shape, Vec3(-1.27, roll.radius, 0.021), BodyType::dynamic, lies, rough);
      f.world.set_velocity(body, roll.speed * way, -roll.speed / roll.radius * axis);
      Real off = 0;
      for (int i = 0; i * roll.speed / 60 < 3; ++i) {
        f.world.step(1.0 / 60);
        off = std::max(off, std::fabs(f.world.state.x[body].y() - roll.radius));
      }
      const Vec3& v = f.world.state.v[body];
      if (!(off < kHop)) print_error("tiles %d, %g m/s: off %g\n", static_cast<int>(roll.tiles), roll.speed, off);
      assert_true(off < kHop);
      assert_true(std::fabs(v.dot(way) / roll.speed - 1) < kLost);
    }
}

/// Nor where triangles lie beside what is solid: within a step it rolls from one onto the other, and both are asked where it is.
void nor_does_it_from_a_solid_onto_triangles(void**) {
  struct Roll {
    Tiles tiles;
    Real radius, half, speed, heading, dt;  // m, m, m/s, rad, s
    bool is_capsule;
  };
  constexpr Roll kRolls[] = {{Tiles::beside, 0.09, 0.07, 7, 0.23, 1.0 / 50, false},
                             {Tiles::beside, 0.09, 0.07, 7, 0.15, 1.0 / 50, false},
                             {Tiles::hull_field, 0.09, 0.07, 12, -0.31, 1.0 / 50, false},
                             {Tiles::hull_field, 0.07, 0.1, 20, -0.19, 1.0 / 60, true},
                             {Tiles::driven_mesh, 0.13, 0.21, 4.4, 0.33, 1.0 / 60, false},
                             {Tiles::driven_mesh, 0.11, 0.16, 17, 0.07, 1.0 / 120, true}};
  for (const Roll& roll : kRolls)
    for (const Real turned : {0.18, 0.38, 0.92}) {
      Floor f(roll.tiles, 1.13, Quat::identity(), exp_map(Vec3(0, turned, 0)));
      const std::uint32_t rough = f.material(0.5, 0);
      const Quat heads = exp_map(Vec3(0, roll.heading, 0)), lies = heads * exp_map(Vec3(std::numbers::pi / 2, 0, 0));
      const Vec3 way = heads * Vec3(1, 0, 0), axis = heads * Vec3(0, 0, 1);
      const Shape* const shape =
          f.keep(roll.is_capsule ? capsule(roll.radius, roll.half) : cylinder(roll.radius, roll.half));
      const std::uint32_t body =
          f.add(shape, Vec3(0.013, roll.radius, 0.021) - 3.5 * way, BodyType::dynamic, lies, rough);
      f.world.set_velocity(body, roll.speed * way, -roll.speed / roll.radius * axis);
      Real off = 0;
      for (int i = 0; i * roll.speed * roll.dt < 7; ++i) {
        f.world.step(roll.dt);
        off = std::max(off, std::fabs(f.world.state.x[body].y() - roll.radius));
      }
      const Vec3& v = f.world.state.v[body];
      if (!(off < kHop))
        print_error("tiles %d by %g rad, %g m/s: off %g\n", static_cast<int>(roll.tiles), turned, roll.speed, off);
      assert_true(off < kHop);
      assert_true((v - roll.speed * way).norm() < kLost * roll.speed);
    }
}

/// A step down by as much as is no flush neighbour: what rolls over its edge falls.
void nor_is_an_edge_a_seam(void**) {
  for (const Real speed : {2.0, 6.0, 11.0}) {
    TestWorld t;
    const std::uint32_t m = t.material(0.6, 0);
    const Shape* const slab = t.keep(box(Vec3(1, 0.25, 1)));
    t.add(slab, Vec3(-1, -0.25, 0), BodyType::fixed, Quat::identity(), m);
    t.add(slab, Vec3(1, -0.45, 0), BodyType::fixed, Quat::identity(), m);
    const std::uint32_t body = t.add(t.keep(cylinder(0.15, 0.3)), Vec3(-0.7, 0.15, 0), BodyType::dynamic,
                                     exp_map(Vec3(std::numbers::pi / 2, 0, 0)), m);
    t.world.set_velocity(body, Vec3(speed, 0, 0), Vec3(0, 0, -speed / 0.15));
    Real lowest = 1;
    for (int i = 0; i * speed / 60 < 1.4 + 0.25 * speed; ++i) {
      t.world.step(1.0 / 60);
      const Vec3& x = t.world.state.x[body];
      assert_true(x.x() > -1e-3 || x.y() > 0.149);
      if (x.x() < 1.8) lowest = std::min(lowest, x.y());
    }
    // What flies off the edge is as low as the fall over what is left of the lower slab lets it be.
    const Real falls = 9.81 / 2 * (1.8 / speed) * (1.8 / speed);
    assert_true(lowest < 0.15 - 0.9 * std::min(falls, 0.2) + 0.01);
  }
}

/// A step of 5 cm, and a wall that stands on a tile or beside one: no farther than to touch.
void what_stands_out_stops(void**) {
  for (const bool from_below : {false, true})
    for (const Real height : {0.05, 1.0})
      for (const Real speed : {1.0, 5.0, 20.0})
        for (const bool ball : {false, true}) {
          Floor f(Tiles::boxes, 0.5, Quat::identity(), Quat::identity());
          const Real foot = from_below ? -0.4 : 0, half = (height - foot) / 2;
          // A seam of the tiles lies under its face.
          const Shape* const block = f.keep(box(Vec3(0.25, half, 2)));
          f.add(block, Vec3(1.0, foot + half, 0), BodyType::fixed, Quat::identity(), f.smooth);
          const std::uint32_t body = f.add(f.keep(ball ? sphere(kRadius) : box(Vec3::constant(kRadius))),
                                           Vec3(0, kRadius, 0.0131), BodyType::dynamic, Quat::identity(), f.smooth);
          f.world.set_velocity(body, Vec3(speed, 0, 0), Vec3::zero());
          Real most = 0;
          for (int i = 0; i * speed / 60 < 1; ++i) {
            f.world.step(1.0 / 60);
            if (f.world.state.x[body].y() < height + 0.9 * kRadius) most = std::max(most, f.world.state.x[body].x());
          }
          // A ball on the edge of the step has its centre nearer by what Pythagoras says.
          const Real reach = height < kRadius && ball ? std::sqrt(kRadius * kRadius - 0.05 * 0.05) : kRadius;
          if (height == 1.0) assert_true(most < 0.75 - reach + 2e-3);
          assert_true(f.world.state.v[body].x() < 0.5 * speed);
        }
}

/// Two boxes apart: the ball between them touches both, and lies where Pythagoras says.
void a_groove_bears_on_both_sides(void**) {
  for (const Real half_width : {0.02, 0.06}) {
    TestWorld t;
    const Shape* const brick = t.keep(box(Vec3(1, 1, 1)));
    for (const Real side : {-1.0, 1.0}) t.add(brick, Vec3(side * (1 + half_width), -1, 0), BodyType::fixed);
    const Real y = std::sqrt(kRadius * kRadius - half_width * half_width);
    const std::uint32_t ball = t.add(t.keep(sphere(kRadius)), Vec3(0, y + 1e-3, 0));
    t.run(120, 1.0 / 60);
    assert_true(std::fabs(t.world.state.x[ball].y() - y) < 2e-4);
    int sides = 0;
    for (std::uint32_t i = 0; i < t.world.pairs.size(); ++i) sides += t.world.pairs.place(i).points > 0;
    assert_int_equal(sides, 2);
  }
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(nothing_feels_a_seam),
      cmocka_unit_test(nor_does_a_body_of_parts),
      cmocka_unit_test(nor_does_what_rolls_on_its_side),
      cmocka_unit_test(nor_does_it_from_a_solid_onto_triangles),
      cmocka_unit_test(nor_is_an_edge_a_seam),
      cmocka_unit_test(what_stands_out_stops),
      cmocka_unit_test(a_groove_bears_on_both_sides),
  };
  return cmocka_run_group_tests_name("oracle/seams", tests, nullptr, nullptr);
}
