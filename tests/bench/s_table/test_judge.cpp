// What the table says of quality: known overlaps, energies and parabolas, and the way to other engines' frames and
// back.
#include <cmath>

#include "carom_test.h"
#include "judge.h"

using namespace carom;
using namespace carom::bench;

static std::vector<BodyState> start_of(const tools::Stage& stage) {
  std::vector<BodyState> states(stage.actors.size());
  for (std::size_t i = 0; i < states.size(); ++i) {
    const tools::Actor& actor = stage.actors[i];
    Vec::Map(states[i].position) = actor.position;
    Eigen::Vector4d::Map(states[i].orientation) = actor.orientation.coeffs();
    Vec::Map(states[i].velocity) = actor.linear_velocity;
    Vec::Map(states[i].omega) = actor.angular_velocity;
  }
  return states;
}

static void depth_energy_escape_and_fall_are_what_geometry_says(void**) {
  tools::Engine engine(tools::PluginPath({CAROM_PLUGIN_DIR}));
  tools::Stage stage(engine);
  tools::build(tools::find_scene("pyramid"), {{{"n", 2}, {"gap", 0.1}}, ""}, stage);  // ground, two cubes, one on top
  const Plan plan(stage);
  const Judge judge(plan);
  std::vector<BodyState> states = start_of(stage);
  const Verdict at_first = judge.judge(states, 0);
  // The cubes touch exactly; 1e-6 is the relative tolerance of the distance.
  assert_true(at_first.max_penetration < 1e-5 && at_first.mean_energy == 0 && at_first.standing.fallen == 0);
  assert_int_equal(at_first.escaped + at_first.lost, 0);

  states[1].position[1] -= 0.02;  // 20 mm into the ground; away from the cube above it
  states[2].position[1] -= 0.01;  // 10 mm, likewise
  states[3].velocity[0] = 2;      // 1,000 kg: 2,000 J; a third of it a body
  states[3].omega[1] = 3;         // 1000/6 kg m^2: 750 J
  const Verdict sunk = judge.judge(states, 0);
  assert_true(std::fabs(sunk.max_penetration - 0.02) < 1e-5 && std::fabs(sunk.mean_penetration - 0.015) < 1e-5);
  assert_int_equal(sunk.overlaps, 2);
  assert_true(std::fabs(sunk.mean_energy - 2750.0 / 3) < 1e-6);

  states[2].position[1] = -3;  // half a metre is a fall, a metre below the ground an escape
  states[3].velocity[2] = NAN;
  const Verdict gone = judge.judge(states, 0);
  assert_int_equal(gone.standing.fallen, 1);
  assert_int_equal(gone.escaped, 1);
  assert_int_equal(gone.lost, 1);
}

static void joined_bodies_may_overlap_and_others_may_not(void**) {
  tools::Engine engine(tools::PluginPath({CAROM_PLUGIN_DIR}));
  tools::Stage stage(engine);
  tools::build(tools::find_scene("net"), {{{"n", 2}}, ""}, stage);  // a square of balls, joined along its edges
  const Plan plan(stage);
  const Judge judge(plan);
  std::vector<BodyState> states = start_of(stage);
  Vec::Map(states[1].position) = vec(states[0].position) + Vec(0.1, 0, 0);
  assert_int_equal(judge.judge(states, 0).overlaps, 0);
  Vec::Map(states[3].position) = vec(states[0].position) + Vec(0, 0.3, 0);  // across: no joint; radius 0.2 m
  const Verdict across = judge.judge(states, 0);
  assert_int_equal(across.overlaps, 1);
  assert_true(std::fabs(across.max_penetration - 0.1) < 1e-5);
}

static void a_particle_on_its_parabola_has_no_error(void**) {
  tools::Engine engine(tools::PluginPath({CAROM_PLUGIN_DIR}));
  tools::Stage stage(engine);
  tools::build(tools::find_scene("particles"), {{{"n", 3}}, ""}, stage);
  const Plan plan(stage);
  std::vector<BodyState> states = start_of(stage);
  for (BodyState& s : states) {
    Vec::Map(s.position) += 2 * vec(s.velocity);
    s.position[1] -= 0.5 * 9.81 * 4;
  }
  states[1].position[2] += 0.25;
  assert_true(std::fabs(Judge(plan).judge(states, 2).flight_error - 0.25) < 1e-12);  // rounding of metres
}

static void principal_frames_are_about_the_centre_of_mass_and_lead_back(void**) {
  tools::Engine engine(tools::PluginPath({CAROM_PLUGIN_DIR}));
  tools::Stage stage(engine);
  tools::build(tools::find_scene("bunnies"), {{{"n", 4}}, ""}, stage);
  const Plan plan(stage);
  const WorldPlan world = plan.world(false);
  std::vector<BodyState> states;
  bool off_centre = false;
  for (std::size_t i = 0; i < world.count; ++i) {
    const BodyPlan& body = world.bodies[i];
    states.push_back(body.start);
    if (body.solid != Solid::hull) continue;
    // The inertia that the other engines get, turned back, is the one that Carom has.
    const Member& member = plan.members()[i];
    const Eigen::Matrix3d axes = member.axes.toRotationMatrix();
    const Eigen::Matrix3d back = axes * Vec(body.inertia).asDiagonal() * axes.transpose();
    assert_true((back - member.inertia).norm() < 1e-12 * member.inertia.norm());
    assert_true(body.triangle_count == 2 * (body.param_count / 3) - 4);  // Euler: a closed surface
    off_centre = off_centre || member.center.norm() > 1e-3;
  }
  assert_true(off_centre);
  plan.to_body_frames(states);
  for (std::size_t i = 0; i < world.count; ++i) {
    const tools::Actor& actor = stage.actors[i];
    // A few roundings of positions of some metres.
    assert_true((vec(states[i].position) - actor.position).norm() < 1e-14 * (1 + actor.position.norm()));
    assert_true(quat(states[i].orientation).angularDistance(actor.orientation) < 1e-7);  // acos near 1: root of epsilon
  }
}

static void what_other_engines_lack_is_refused(void**) {
  tools::Engine engine(tools::PluginPath({CAROM_PLUGIN_DIR}));
  tools::Stage stage(engine);
  tools::build(tools::find_scene("seesaw"), {}, stage);  // a plank of several parts
  bool refused = false;
  try {
    const Plan plan(stage);
  } catch (const tools::Error& error) {
    refused = !error.remedy.empty();
  }
  assert_true(refused);
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(depth_energy_escape_and_fall_are_what_geometry_says),
      cmocka_unit_test(joined_bodies_may_overlap_and_others_may_not),
      cmocka_unit_test(a_particle_on_its_parabola_has_no_error),
      cmocka_unit_test(principal_frames_are_about_the_centre_of_mass_and_lead_back),
      cmocka_unit_test(what_other_engines_lack_is_refused),
  };
  return cmocka_run_group_tests_name("bench/judge", tests, nullptr, nullptr);
}
