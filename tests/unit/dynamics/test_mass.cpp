// Mass properties of bodies against closed forms, and what editing a world does to them.
#include "carom_test.h"
#include "world_builder.h"

using namespace carom;
using namespace carom::test;

// Sums of a handful of terms: a few roundings each.
static void assert_near(Real got, Real want, Real scale) {
  assert_true(std::fabs(got - want) <= 16 * kEpsilon * scale);
}

static BodyDef dynamic_at(const Vec3& p) {
  BodyDef def;
  def.pose.p = p;
  return def;
}

static void a_dynamic_body_without_colliders_is_a_particle_of_one_kilogram(void**) {
  TestWorld t;
  const std::uint32_t b = t.add(nullptr, Vec3(1, 2, 3));
  assert_true(t.world.scene.mass[b] == 1 && t.world.scene.inv_mass[b] == 1);
  assert_true(t.world.scene.inv_inertia[b] == Mat3::zero());
}

static void two_boxes_make_the_box_that_they_tile(void**) {
  TestWorld t;
  const Shape* half = t.keep(box(Vec3(0.5, 1, 1.5)));
  const std::uint32_t b = t.add(nullptr, Vec3::zero());
  t.world.add_collider(b, half, {Quat::identity(), Vec3(-0.5, 4, 0)}, 500, Colliders::kNoMaterial);
  t.world.add_collider(b, half, {Quat::identity(), Vec3(0.5, 4, 0)}, 500, Colliders::kNoMaterial);
  const Real m = 500 * 2 * 2 * 3;  // of a box 2 x 2 x 3
  assert_near(t.world.scene.mass[b], m, m);
  assert_true((t.world.scene.center[b] - Vec3(0, 4, 0)).norm() <= 16 * kEpsilon * 4);
  const Mat3& i = t.world.scene.inertia[b];
  assert_near(i(0, 0), m / 12 * (4 + 9), m * 16);
  assert_near(i(1, 1), m / 12 * (4 + 9), m * 16);
  assert_near(i(2, 2), m / 12 * (4 + 4), m * 16);
  assert_near(i(0, 1), 0, m * 16);
  assert_true((i * t.world.scene.inv_inertia[b] - Mat3::identity()).abs().max_entry() < 1e-13);
}

static void a_turned_collider_turns_its_inertia(void**) {
  TestWorld t;
  const Shape* plank = t.keep(box(Vec3(1, 2, 3)));
  const std::uint32_t b = t.add(nullptr, Vec3::zero());
  const Quat quarter = exp_map(Vec3(0, 0, 1.57079632679489662));
  t.world.add_collider(b, plank, {quarter, Vec3::zero()}, 1, Colliders::kNoMaterial);
  const Real m = 48;  // x and y have changed places
  assert_near(t.world.scene.inertia[b](0, 0), m / 12 * (4 + 36), m * 40);
  assert_near(t.world.scene.inertia[b](1, 1), m / 12 * (16 + 36), m * 40);
}

static void a_given_mass_scales_the_inertia_of_the_colliders(void**) {
  for (const Real density : {1000.0, 0.0}) {  // with density 0 everywhere, colliders weigh by volume
    TestWorld t;
    BodyDef def;
    def.has_mass = true;
    def.mass = 6;
    const std::uint32_t b = handle_slot(t.world.add_body(def));
    assert_true(t.world.scene.inv_inertia[b] == Mat3::zero());
    t.world.add_collider(b, t.keep(sphere(0.5)), Pose{}, density, Colliders::kNoMaterial);
    assert_true(t.world.scene.mass[b] == 6);
    assert_near(t.world.scene.inertia[b](1, 1), 0.4 * 6 * 0.25, 1);
  }
}

static void a_given_inertia_that_is_not_positive_definite_stops_rotation(void**) {
  TestWorld t;
  BodyDef def;
  def.has_mass = def.has_inertia = true;
  def.mass = 2;
  def.inertia = Mat3::diagonal(Vec3(1, 0, 1));
  const std::uint32_t b = handle_slot(t.world.add_body(def));
  assert_true(t.world.scene.inertia[b] == Mat3::zero() && t.world.scene.inv_inertia[b] == Mat3::zero());
}

static void static_and_kinematic_bodies_have_no_mass(void**) {
  TestWorld t;
  const Shape* ball = t.keep(sphere(1));
  for (const BodyType type : {BodyType::fixed, BodyType::kinematic}) {
    const std::uint32_t b = t.add(ball, Vec3::zero(), type);
    assert_true(t.world.scene.mass[b] == 0 && t.world.scene.inv_mass[b] == 0);
    assert_true(t.world.scene.inv_inertia[b] == Mat3::zero());
  }
}

static void the_frame_and_the_velocity_of_the_centre_survive_a_new_collider(void**) {
  TestWorld t;
  BodyDef def = dynamic_at(Vec3(1, 2, 3));
  def.pose.q = exp_map(Vec3(0.3, -0.2, 0.5));
  def.velocity = Vec3(4, 5, 6);
  def.omega = Vec3(0, 1, 0);
  const std::uint32_t b = handle_slot(t.world.add_body(def));
  const Handle h =
      t.world.add_collider(b, t.keep(sphere(0.5)), {Quat::identity(), Vec3(2, 0, 0)}, 1000, Colliders::kNoMaterial);
  assert_true((t.world.pose(b).p - Vec3(1, 2, 3)).norm() < 1e-14);
  assert_true((t.world.state.x[b] - t.world.pose(b).apply(Vec3(2, 0, 0))).norm() < 1e-14);
  assert_true(t.world.state.v[b] == Vec3(4, 5, 6));
  t.world.remove_collider(handle_slot(h));
  assert_true((t.world.pose(b).p - Vec3(1, 2, 3)).norm() < 1e-14);
  assert_true(t.world.scene.mass[b] == 1);
}

static void slots_come_back_clean(void**) {
  TestWorld t;
  const Shape* ball = t.keep(sphere(0.5));
  t.ground();
  const std::uint32_t a = t.add(ball, Vec3(0, 0.5, 0));
  t.run(3, 1.0 / 60);
  t.world.set_velocity(a, Vec3(1, 1, 1), Vec3::zero());
  t.world.set_force(a, Vec3(1, 1, 1), Vec3::zero());
  t.world.remove_body(a);
  assert_int_equal(t.world.scene.colliders.live.size(), 1);
  t.world.step(1.0 / 60);
  assert_int_equal(t.world.report.contact_points, 0);
  const std::uint32_t b = t.add(ball, Vec3(5, 9, 0));
  assert_int_equal(a, b);
  assert_true(t.world.state.v[b] == Vec3::zero() && t.world.state.force[b] == Vec3::zero());
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(a_dynamic_body_without_colliders_is_a_particle_of_one_kilogram),
      cmocka_unit_test(two_boxes_make_the_box_that_they_tile),
      cmocka_unit_test(a_turned_collider_turns_its_inertia),
      cmocka_unit_test(a_given_mass_scales_the_inertia_of_the_colliders),
      cmocka_unit_test(a_given_inertia_that_is_not_positive_definite_stops_rotation),
      cmocka_unit_test(static_and_kinematic_bodies_have_no_mass),
      cmocka_unit_test(the_frame_and_the_velocity_of_the_centre_survive_a_new_collider),
      cmocka_unit_test(slots_come_back_clean),
  };
  return cmocka_run_group_tests_name("dynamics/mass", tests, nullptr, nullptr);
}
