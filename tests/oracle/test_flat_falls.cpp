// What falls flat and is symmetric stays so: the four impulses of an impact are equal, so it neither turns nor drifts,
// whatever is wider, the box or what it falls on.
//
// Impulses that are equal to 1e-12 leave turns and drifts of 1e-12 of the speed over the size. A box of 1 m at 7 m/s is
// held to 1e-11 of each, through ten falls and more.
#include "carom_test.h"
#include "scenery_builder.h"
#include "world_builder.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr Real kSymmetric = 1e-11;  // m/s, rad/s
// What bounces low is the solver's at last, which bears it by up to 36 points, to its tolerance of velocities.
constexpr Real kSymmetricOnPieces = 1e-4;

struct Fall {
  Vec3 half = Vec3::constant(0.5);  // m
  Real floor = 0.5;                 // m, half a side
  Real height = 3, restitution = 1, friction = 0.6;
  int per_second = 60, seconds = 6;
  Real aside = 0;  // m
};

/// @return m, how high it comes after its second impact
Real run(const Fall& f, Real symmetric) {
  TestWorld t;
  const std::uint32_t m = t.material(f.friction, f.restitution);
  Shape floor = box(Vec3(f.floor, 0.25, f.floor)), body = box(f.half);
  make_faces(floor), make_faces(body);
  t.add(t.keep(std::move(floor)), Vec3(0, -0.25, 0), BodyType::fixed, Quat::identity(), m);
  const std::uint32_t b =
      t.add(t.keep(std::move(body)), Vec3(f.aside, f.height, 0), BodyType::dynamic, Quat::identity(), m);
  int impacts = 0;
  Real top = 0, before = 0;
  for (int i = 0; i < f.seconds * f.per_second; ++i) {
    t.world.step(1.0 / f.per_second);
    const Vec3 &v = t.world.state.v[b], &omega = t.world.state.omega[b];
    assert_true(std::fabs(v.x()) <= symmetric && std::fabs(v.z()) <= symmetric);
    assert_true(omega.abs().max_entry() <= symmetric);
    impacts += before < 0 && v.y() > 0;
    before = v.y();
    if (impacts == 2) top = std::max(top, t.world.state.x[b].y());
  }
  return top;
}

}  // namespace

static void a_box_on_a_wider_and_on_a_narrower_floor(void**) {
  for (const Real floor : {0.03, 0.1, 0.25, 0.375, 0.5, 1.0})
    for (const int per_second : {60, 120}) {
      Fall f;
      f.floor = floor, f.per_second = per_second;
      const Real top = run(f, kSymmetric);
      // One sixtieth of a second beside the top of a fall: g h^2 / 2 below it.
      assert_true(top < 3 + 1e-9 && top > 3 - 9.81 / 2 / 3600 - 1e-9);
    }
}

/// As long as they bounce: what lands for good is the solver's, which goes from point to point.
static void plates_and_rods_with_other_materials(void**) {
  for (const Real friction : {0.0, 0.2, 2.0})
    for (const Real restitution : {0.9, 1.0})
      for (const Vec3& half : {Vec3(0.4, 0.02, 0.4), Vec3(0.05, 0.6, 0.05), Vec3(0.7, 0.1, 0.2)}) {
        Fall f;
        f.half = half, f.floor = 0.15, f.friction = friction, f.restitution = restitution;
        f.height = 1.5, f.seconds = 2;
        run(f, kSymmetric);
      }
}

/// Ground of pieces that meet under the box: tiles, and grids of triangles of which corners lie under its corners.
static void on_ground_of_pieces(void**) {
  enum class Pieces { tiles, field, parts };
  for (const Pieces pieces : {Pieces::tiles, Pieces::field, Pieces::parts})
    for (const Real side : {0.25, 0.4, 1.1})  // m, of a piece
      for (const Real speed : {0.0, 3.0, 12.0}) {
        TestWorld t;
        const std::uint32_t m = t.material(0.4, 0.8);
        const Shape* const tile = t.keep(box(Vec3(side / 2, 0.2, side / 2)));
        const std::uint32_t whole =
            pieces == Pieces::parts ? t.add(nullptr, Vec3::zero(), BodyType::fixed, Quat::identity(), m) : 0;
        for (int i = -3; i < 3 && pieces != Pieces::field; ++i)
          for (int k = -3; k < 3; ++k) {
            const Vec3 at(side * (i + 0.5), -0.2, side * (k + 0.5));
            if (pieces == Pieces::parts)
              t.world.add_collider(whole, tile, Pose{Quat::identity(), at}, 1000, m);
            else
              t.add(tile, at, BodyType::fixed, Quat::identity(), m);
          }
        if (pieces == Pieces::field)
          t.add(t.keep(height_field(9, 9, side, side, [](std::uint32_t, std::uint32_t) { return 0.0; })),
                Vec3(-4 * side, 0, -4 * side), BodyType::fixed, Quat::identity(), m);
        const std::uint32_t b =
            t.add(t.keep(box(Vec3(side, 0.3 * side, side))), Vec3(0, 1.6, 0), BodyType::dynamic, Quat::identity(), m);
        t.world.set_velocity(b, Vec3(0, -speed, 0), Vec3::zero());
        for (int i = 0; i < 60; ++i) {
          t.world.step(1.0 / 60);
          const Vec3 &v = t.world.state.v[b], &omega = t.world.state.omega[b];
          const Real off = std::max({std::fabs(v.x()), std::fabs(v.z()), side * omega.abs().max_entry()});
          if (!(off < kSymmetricOnPieces))
            print_error("pieces %d of %g m at %g m/s: %g\n", int(pieces), side, speed, off);
          assert_true(off < kSymmetricOnPieces);
        }
      }
}

/// No special way for what is symmetric: a hair beside it, it is off by a hair times what impacts can make of that.
static void a_hair_aside(void**) {
  for (const Real floor : {0.03, 0.1, 0.4}) {
    Fall f;
    f.floor = floor, f.aside = 1e-9;
    // A point's impulse off the middle by 1e-9 m turns the box by m v 1e-9 / I = 6e-8 rad/s an impact. Ten impacts,
    // each of which may double what it meets, stay below a thousand times that.
    const Real top = run(f, 1e-4);
    assert_true(top < 3 + 1e-6 && top > 3 - 2e-3);
  }
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(a_box_on_a_wider_and_on_a_narrower_floor),
      cmocka_unit_test(plates_and_rods_with_other_materials),
      cmocka_unit_test(on_ground_of_pieces),
      cmocka_unit_test(a_hair_aside),
  };
  return cmocka_run_group_tests_name("oracle/flat_falls", tests, nullptr, nullptr);
}
