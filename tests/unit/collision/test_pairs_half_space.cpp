// Shapes against the half-space: what each rests on, point by point.
#include <algorithm>
#include <vector>

#include "carom_test.h"
#include "pair_cases.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr Real kReach = 0.01;  // m: the default contact distance
constexpr Real kRightAngle = 1.57079632679489661923;

/// Contacts with the ground y <= 0; B turned by phi, its origin at height y.
Candidates on_ground(const Shape& b, const Vec3& phi, Real y) {
  const Shape ground = half_space(Vec3::unit_y(), 0);
  Candidates found;
  pair_entry(Form::half_space, b.form).routine(ground, b, Frame(exp_map(phi).matrix(), Vec3(0, y, 0)), kReach, found);
  return found;
}

int at_height(const Candidates& found, Real height, Real tol) {
  return static_cast<int>(std::count_if(found.point, found.point + found.count, [&](const ContactPoint& p) {
    return std::fabs(p.separation - height) <= tol && std::fabs(p.on_a.y()) <= tol && p.normal == Vec3::unit_y();
  }));
}

/// How far the points reach in the plane, in the direction where they reach least.
Real least_reach(const Candidates& found) {
  Real least = kInfinity;
  for (int i = 0; i < 64; ++i) {
    const SinCos u = sin_cos(i * kRightAngle / 16);
    Real most = -kInfinity;
    for (int k = 0; k < found.count; ++k)
      most = std::max(most, u.cos * found.point[k].on_a.x() + u.sin * found.point[k].on_a.z());
    least = std::min(least, most);
  }
  return least;
}

}  // namespace

static void a_box_rests_on_a_face_an_edge_or_a_corner(void**) {
  const Shape brick = box(Vec3(0.3, 0.2, 0.4));
  const Candidates face = on_ground(brick, Vec3(0, 0.7, 0), 0.199);
  assert_int_equal(face.count, 4);
  assert_int_equal(at_height(face, -0.001, 4 * kEpsilon), 4);
  const Candidates edge = on_ground(brick, Vec3(0, 0, kRightAngle / 2), 0.5 / std::sqrt(2.0));
  assert_int_equal(edge.count, 2);
  assert_int_equal(at_height(edge, 0, 4 * kEpsilon), 2);
  const Candidates corner = on_ground(brick, Vec3(0.5, 0.1, 0.6), 0.45);
  assert_true(corner.count <= 1);
  // A plate thinner than the reach: its upper corners are near, but carry nothing.
  const Candidates plate = on_ground(box(Vec3(1, 0.002, 1)), Vec3::zero(), 0.002);
  assert_int_equal(plate.count, 4);
  assert_int_equal(at_height(plate, 0, 4 * kEpsilon), 4);
}

static void corners_keep_their_names_whichever_face_looks_down(void**) {
  const Shape cube = box(Vec3(1, 1, 1));
  const Candidates one = on_ground(cube, Vec3(0, 0, kRightAngle / 2 - 1e-9), std::sqrt(2.0));
  const Candidates other = on_ground(cube, Vec3(0, 0, kRightAngle / 2 + 1e-9), std::sqrt(2.0));
  assert_int_equal(one.count, 2);
  assert_int_equal(other.count, 2);
  for (int k = 0; k < 2; ++k)
    assert_true(std::any_of(other.point, other.point + 2,
                            [&](const ContactPoint& p) { return p.feature == one.point[k].feature; }));
}

static void a_cylinder_stands_on_its_rim_and_lies_on_a_line(void**) {
  const Shape pin = cylinder(0.4, 0.5);
  for (const Real tilt : {0.0, 1e-12, 1e-9, 1e-6, 1e-3}) {
    const Candidates standing = on_ground(pin, Vec3(tilt, 0, 0), 0.5);
    assert_int_equal(standing.count, 4);
    assert_int_equal(at_height(standing, 0, tilt * 0.4 + tilt * tilt + 1e-12), 4);
    assert_true(least_reach(standing) >= 0.4 * std::sqrt(0.5) - 1e-3);  // a square in the rim's circle
    const Real deep = 0.5 - 0.5 * std::cos(tilt) - 0.4 * std::sin(tilt);
    assert_true(std::fabs(deepest(standing)->separation - deep) <= 1e-9);
  }
  const Candidates lying = on_ground(pin, Vec3(kRightAngle, 0, 0), 0.399);
  assert_int_equal(lying.count, 2);
  assert_int_equal(at_height(lying, -0.001, 8 * kEpsilon), 2);
  assert_true(std::fabs(std::fabs(lying.point[0].on_a.z() - lying.point[1].on_a.z()) - 1) <= 8 * kEpsilon);
  assert_int_equal(on_ground(pin, Vec3(0.6, 0, 0), 0.5 * std::cos(0.6) + 0.4 * std::sin(0.6)).count, 1);
}

static void a_cone_stands_lies_and_balances(void**) {
  const Shape hat = cone(0.4, 0.5);
  const Candidates standing = on_ground(hat, Vec3::zero(), 0.5);
  assert_int_equal(standing.count, 4);
  assert_true(least_reach(standing) >= 0.4 * std::sqrt(0.5) - 1e-9);
  // On its side: from the apex to the rim, a line of length hypot(2 h, r). The half angle at the apex is atan(r / 2 h).
  const Real half_angle = std::atan(0.4), height = 0.5 * std::sin(half_angle);
  const Candidates lying = on_ground(hat, Vec3(kRightAngle + half_angle, 0, 0), height);
  assert_int_equal(lying.count, 2);
  assert_int_equal(at_height(lying, 0, 1e-12), 2);
  assert_true(std::fabs((lying.point[0].on_a - lying.point[1].on_a).norm() - std::hypot(1, 0.4)) <= 1e-12);
  const Candidates balancing = on_ground(hat, Vec3(2 * kRightAngle, 0, 0), 0.5);
  assert_int_equal(balancing.count, 1);
  assert_int_equal(at_height(balancing, 0, 1e-12), 1);
}

static void a_capsule_lies_on_both_its_ends(void**) {
  const Shape pill = capsule(0.2, 0.5);
  assert_int_equal(on_ground(pill, Vec3(kRightAngle, 0, 0), 0.2).count, 2);
  assert_int_equal(at_height(on_ground(pill, Vec3(kRightAngle, 0, 0), 0.2), 0, 4 * kEpsilon), 2);
  assert_int_equal(on_ground(pill, Vec3::zero(), 0.7).count, 1);
}

static void a_round_body_touches_in_one_point(void**) {
  assert_int_equal(at_height(on_ground(sphere(0.3), Vec3(1, 2, 3), 0.29), -0.01, 4 * kEpsilon), 1);
  // Radii 0.3, 0.5, 0.4 turned about z by t: half height sqrt(0.3^2 sin^2 t + 0.5^2 cos^2 t).
  const Real half = std::hypot(0.3 * std::sin(0.5), 0.5 * std::cos(0.5));
  assert_int_equal(at_height(on_ground(ellipsoid(Vec3(0.3, 0.5, 0.4)), Vec3(0, 0, 0.5), half), 0, 8 * kEpsilon), 1);
}

static void a_polytope_rests_on_eight_well_spread_vertices_at_most(void**) {
  std::vector<Vec3> corners;
  for (const Real x : {-0.3, 0.3})
    for (const Real y : {-0.2, 0.2})
      for (const Real z : {-0.4, 0.4}) corners.push_back(Vec3(x, y, z));
  const Candidates brick = on_ground(hull(corners), Vec3(0, 0.3, 0), 0.2);
  assert_int_equal(brick.count, 4);
  assert_int_equal(at_height(brick, 0, 4 * kEpsilon), 4);

  std::vector<Vec3> prism;  // 200 corners a face, and a crowd of vertices just above that must not displace them
  for (int i = 0; i < 200; ++i) {
    const SinCos u = sin_cos(0.01 + i * kRightAngle / 50);
    prism.push_back(Vec3(u.cos, -0.2, u.sin));
    prism.push_back(Vec3(1.01 * u.cos, -0.195, 1.01 * u.sin));
    prism.push_back(Vec3(u.cos, 0.2, u.sin));
  }
  const Candidates drum = on_ground(hull(prism), Vec3::zero(), 0.2);
  assert_int_equal(at_height(drum, 0, 4 * kEpsilon), drum.count);
  assert_true(drum.count >= 7);
  // Seven azimuths: the chord between two lies cos(pi / 7) out; corners are 1.8 degrees (0.0314 rad) apart.
  assert_true(least_reach(drum) >= std::cos(2 * kRightAngle / 7 + 0.0315));

  std::vector<Vec3> ball;
  Random random(31);
  for (int i = 0; i < 2000; ++i) ball.push_back(random.direction());
  const Candidates rolling = on_ground(hull(ball), Vec3::zero(), 0.999);
  Real lowest = kInfinity;
  for (const Vec3& v : ball) lowest = std::min(lowest, v.y() + 0.999);
  assert_true(rolling.count >= 1);
  assert_true(std::fabs(deepest(rolling)->separation - lowest) <= 4 * kEpsilon);
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(a_box_rests_on_a_face_an_edge_or_a_corner),
      cmocka_unit_test(corners_keep_their_names_whichever_face_looks_down),
      cmocka_unit_test(a_cylinder_stands_on_its_rim_and_lies_on_a_line),
      cmocka_unit_test(a_cone_stands_lies_and_balances),
      cmocka_unit_test(a_capsule_lies_on_both_its_ends),
      cmocka_unit_test(a_round_body_touches_in_one_point),
      cmocka_unit_test(a_polytope_rests_on_eight_well_spread_vertices_at_most),
  };
  return cmocka_run_group_tests_name("collision/pairs_half_space", tests, nullptr, nullptr);
}
