// Shapes at rest on whole contact patches stay at rest for a minute: a tenth of a millimetre, whatever they stand on.
//
// The solver leaves velocity errors up to velocity_tolerance alone (1e-4 m/s by default: 6 mm in a minute, if they all
// pointed the same way; measured, up to 0.13 mm), and stops after velocity_iterations a point (4 by default: in the
// first step, which has no impulses to start from, that leaves a body on three points 0.2 mm off). Both are dials, and
// both are turned up here, so that the bound is for the contacts: a point that flickers, teleports or lies beside the
// shape would show.
#include <vector>

#include "carom_test.h"
#include "world_builder.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr Real kStep = 1.0 / 60;
constexpr Real kDrift = 1e-4;      // m
constexpr Real kTolerance = 1e-5;  // m/s

/// A sphere of 42 vertices: an icosahedron's, and the middles of its edges pushed out.
Shape round_hull(Real radius) {
  const Real golden = (1 + std::sqrt(Real(5))) / 2;
  std::vector<Vec3> v;
  for (const int i : {-1, 1})
    for (const int j : {-1, 1})
      for (int k = 0; k < 3; ++k) {
        Vec3 x = Vec3::zero();
        x[k] = i, x[(k + 1) % 3] = j * golden;
        v.push_back(x.normalized());
      }
  const Real edge = 2 / std::sqrt(1 + golden * golden);
  for (std::size_t i = 0; i < 12; ++i)
    for (std::size_t j = i + 1; j < 12; ++j)
      if ((v[i] - v[j]).norm() < 1.01 * edge) v.push_back((v[i] + v[j]).normalized());
  for (Vec3& x : v) x *= radius;
  return hull(v);
}

/// A shape turned so that the flat piece with this outward normal and distance from its origin lies on y = 0.
struct Rest {
  Shape shape;
  Vec3 normal;
  Real distance;  // m
};

std::vector<Rest> rests() {
  std::vector<Rest> all;
  all.push_back({box(Vec3(0.5, 0.25, 0.5)), -Vec3::unit_y(), 0.25});
  all.push_back({cylinder(0.3, 0.5), Vec3::unit_x(), 0.3});
  all.push_back({cylinder(0.3, 0.05), -Vec3::unit_y(), 0.05});
  all.push_back({cone(0.3, 0.4), -Vec3::unit_y(), 0.4});
  const Vec3 side = Vec3(0.8, 0.3, 0).normalized();
  all.push_back({cone(0.3, 0.4), side, 0.4 * side.y()});
  Shape round = round_hull(0.4);
  make_faces(round);
  const Vec3 n = round.faces.normal[0];
  const double* x = &round.vertices[3 * round.faces.loop[0]];
  const Real distance = n.dot(Vec3(x[0], x[1], x[2]));
  all.push_back({std::move(round), n, distance});
  return all;
}

void turn_up_the_solver(TestWorld& t) {
  t.world.set_dial(Dial::velocity_tolerance, kTolerance);
  t.world.set_dial(Dial::velocity_iterations, 50);
}

void assert_stays(ManifoldKind kind, bool on_slab, bool routines, Rest rest) {
  TestWorld t;
  t.world.set_dial(Dial::manifold, static_cast<Real>(kind));
  t.world.set_dial(Dial::pair_routines, routines);
  turn_up_the_solver(t);
  if (on_slab) {
    Shape slab = box(Vec3(5, 0.5, 5));
    make_faces(slab);
    t.add(t.keep(std::move(slab)), Vec3(0, -0.5, 0), BodyType::fixed);
  } else {
    t.ground();
  }
  make_faces(rest.shape);
  const Real size = rest.shape.bounding_radius;
  const std::uint32_t b = t.add(t.keep(std::move(rest.shape)), Vec3(0, rest.distance, 0), BodyType::dynamic,
                                turn_between(rest.normal, -Vec3::unit_y()));
  const Vec3 x = t.world.state.x[b];
  const Quat q = t.world.state.q[b];
  for (int i = 0; i < 3600; ++i) {
    t.world.step(kStep);
    const Real turn = 2 * (t.world.state.q[b] * q.conjugate()).vec().norm();
    assert_true((t.world.state.x[b] - x).norm() < kDrift);
    assert_true(turn * size < 2 * kDrift);  // no point of it moved farther than the centre and this
    assert_true(t.world.report.contact_points >= 2);
  }
  // As slow as the solver lets it be: its energy is that of the tolerance.
  assert_true(t.world.state.v[b].norm() < 4 * kTolerance);
  assert_true(t.world.state.omega[b].norm() * size < 8 * kTolerance);
}

}  // namespace

static void shapes_at_rest_stay_at_rest_on_probed_patches(void**) {
  for (const bool on_slab : {false, true})
    for (Rest& rest : rests()) assert_stays(ManifoldKind::patch, on_slab, false, std::move(rest));
}

static void shapes_at_rest_stay_at_rest_on_clipped_patches(void**) {
  for (const bool on_slab : {false, true})
    for (Rest& rest : rests()) assert_stays(ManifoldKind::clip, on_slab, false, std::move(rest));
}

static void shapes_at_rest_stay_at_rest_beside_specific_routines(void**) {
  for (const ManifoldKind kind : {ManifoldKind::patch, ManifoldKind::clip})
    for (const bool on_slab : {false, true})
      for (Rest& rest : rests()) assert_stays(kind, on_slab, true, std::move(rest));
}

static void a_stack_of_cylinders_and_hulls_stands_on_probed_patches(void**) {
  // Coins under a box under a coin: faces, rims and corners on each other, none of it known to a routine.
  for (const ManifoldKind kind : {ManifoldKind::patch, ManifoldKind::clip}) {
    TestWorld t;
    t.world.set_dial(Dial::manifold, static_cast<Real>(kind));
    turn_up_the_solver(t);
    t.world.set_dial(Dial::pair_routines, 0);
    t.ground();
    Shape crate = box(Vec3(0.3, 0.1, 0.3));
    make_faces(crate);
    const Shape *coin = t.keep(cylinder(0.3, 0.1)), *brick = t.keep(std::move(crate));
    std::vector<std::uint32_t> stack;
    for (int i = 0; i < 4; ++i)
      stack.push_back(
          t.add(i == 2 ? brick : coin, Vec3(0, 0.1 + 0.2 * i, 0), BodyType::dynamic, exp_map(Vec3(0, i, 0))));
    t.run(3600, kStep);
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec3 moved = t.world.state.x[stack[i]] - Vec3(0, 0.1 + 0.2 * static_cast<Real>(i), 0);
      assert_true(std::hypot(moved.x(), moved.z()) < kDrift * static_cast<Real>(i + 1));
      // Each level may sink into the one below by what the solver leaves of a penetration.
      assert_true(std::fabs(moved.y()) < static_cast<Real>(i + 1) * t.world.scene.dials[Dial::position_tolerance]);
    }
  }
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(shapes_at_rest_stay_at_rest_on_probed_patches),
      cmocka_unit_test(shapes_at_rest_stay_at_rest_on_clipped_patches),
      cmocka_unit_test(shapes_at_rest_stay_at_rest_beside_specific_routines),
      cmocka_unit_test(a_stack_of_cylinders_and_hulls_stands_on_probed_patches),
  };
  return cmocka_run_group_tests_name("stability/rest_patches", tests, nullptr, nullptr);
}
