// Every scene builds and runs finite; meshes are read, scaled and reduced as they say.
#include <cmath>
#include <cstdio>
#include <fstream>

#include "carom_test.h"
#include "scenes/run.h"
#include "scenes/tower.h"

using namespace carom::tools;

static void every_scene_runs_half_a_second_finite_and_inside(void**) {
  for (const Scene& scene : all_scenes()) {
    Engine engine(PluginPath({CAROM_PLUGIN_DIR}));
    Stage stage(engine);
    Settings settings;
    if (scene.name == "falling" || scene.name == "particles") settings.values = {{"n", 60}};
    if (scene.name == "bunnies" || scene.name == "pyramid") settings.values = {{"n", 4}};
    if (scene.name == "stacks") settings.values = {{"n", 2}, {"height", 4}};
    if (scene.name == "quoits") settings.values = {{"n", 2}, {"parts", 1}};
    if (scene.name == "ragdoll") settings.values = {{"n", 1}};
    if (scene.name == "sleepers") settings.values = {{"n", 20}};
    const auto observer = build(scene, settings, stage);
    const RunSummary run = simulate(stage, observer.get(), 0.5, scene.dt);
    assert_int_equal(run.steps, std::lround(0.5 / scene.dt));
    assert_int_equal(run.faults, 0);
    for (const KindSummary& kind : where_it_ended(stage)) {
      assert_int_equal(kind.not_finite, 0);
      assert_int_equal(kind.escaped, 0);
    }
    if (observer) assert_false(observer->tell(stage).empty());
  }
}

static void the_seesaw_throws_the_bunny_and_the_row_falls(void**) {
  // The installed bunny or its stand-in, whichever is there: the throw has to come off with either.
  const Scene& scene = find_scene("seesaw");
  Engine engine(PluginPath({CAROM_PLUGIN_DIR}));
  Stage stage(engine);
  const auto observer = build(scene, {}, stage);
  simulate(stage, observer.get(), scene.seconds, scene.dt);
  for (const std::string& line : observer->tell(stage)) std::printf("  %s\n", line.c_str());
  assert_true(observer->came_off(stage));
  for (const char* plugin : {"sphere", "box", "cylinder", "hull"}) {
    const std::vector<std::string> loaded = engine.loaded();
    assert_true(std::find(loaded.begin(), loaded.end(), plugin) != loaded.end());
  }
}

/// The first story tells the truth: all dominoes fall whatever is asked for, and in the scene a hair beside it.
static void the_seesaw_tells_the_same_story_at_every_setting(void**) {
  struct Asked {
    const char* preset;
    double accuracy;  ///< 0: none
  };
#ifdef CAROM_SANITIZED
  const Asked asked[] = {{"fast", 0}, {"balanced", 0}};
#else
  const Asked asked[] = {{"fast", 0},      {"balanced", 0},    {"accurate", 0},
                         {"reference", 0}, {"balanced", 1e-2}, {"balanced", 1e-3}};
#endif
  const std::vector<std::pair<std::string, double>> beside[] = {
      {}, {{"drop", 0.0999}}, {{"spacing", 0.5205}, {"aside", -0.1001}}};
  const Scene& scene = find_scene("seesaw");
  Engine engine(PluginPath({CAROM_PLUGIN_DIR}));
  std::size_t told = 0;
  for (const Asked& ask : asked)
    for (const auto& values : beside) {
      Stage stage(engine);
      const auto observer = build(scene, {values, ""}, stage);
      stage.world.set_preset(ask.preset);
      if (ask.accuracy > 0) stage.world.ask(ask.accuracy);
      simulate(stage, observer.get(), scene.seconds, scene.dt,
               [&](const carom_step_report&) { return !observer->came_off(stage); });
      if (!observer->came_off(stage)) {
        std::printf("preset %s, accuracy %g, %s\n", ask.preset, ask.accuracy,
                    values.empty() ? "as it is" : values.front().first.c_str());
        for (const std::string& line : observer->tell(stage)) std::printf("  %s\n", line.c_str());
      }
      told += observer->came_off(stage);
    }
  assert_int_equal(told, std::size(asked) * std::size(beside));
}

/// Where /proc is not mounted the name by which the program was started says where its plugins are.
static void the_program_finds_itself_without_proc(void**) {
  const std::string base = own_base();
  assert_false(base.empty());
  assert_string_equal(own_base("/no/such/link").c_str(), base.c_str());
}

static void the_catapult_breaks_the_wall(void**) {
  const Scene& scene = find_scene("catapult");
  Engine engine(PluginPath({CAROM_PLUGIN_DIR}));
  Stage stage(engine);
  const auto observer = build(scene, {}, stage);
  simulate(stage, observer.get(), scene.seconds, scene.dt);
  for (const std::string& line : observer->tell(stage)) std::printf("  %s\n", line.c_str());
  assert_true(observer->came_off(stage));
}

static void belts_carry_every_box_to_the_turntable(void**) {
  const Scene& scene = find_scene("conveyor");
  Engine engine(PluginPath({CAROM_PLUGIN_DIR}));
  Stage stage(engine);
  const auto observer = build(scene, {}, stage);
  simulate(stage, observer.get(), scene.seconds, scene.dt);
  for (const std::string& line : observer->tell(stage)) std::printf("  %s\n", line.c_str());
  assert_true(observer->came_off(stage));
}

static void people_on_stairs_keep_their_joints_and_limits_and_come_to_rest(void**) {
  // The direct solver undoes what is off by more than 1e-9 m or rad in every substep. By springs (auto) joints gape by
  // centimetres as somebody hits the stairs, and are shut at rest.
  const struct {
    const char* solver;
    double gap, angle;  // m, rad: at any time
  } cases[] = {{"solver=direct", 1e-7, 1e-6}, {"solver=auto", 0.06, 0.3}};
  for (const auto& c : cases) {
    const Scene& scene = find_scene("ragdoll");
    Engine engine(PluginPath({CAROM_PLUGIN_DIR}));
    Stage stage(engine);
    const auto observer = build(scene, {{{"n", 1}}, ""}, stage);
    stage.world.set_dial(c.solver);
    double gap = 0, angle = 0, first = 0, last = 0;
    const RunSummary run =
        simulate(stage, observer.get(), scene.seconds, scene.dt, [&](const carom_step_report& report) {
          last = 0;
          for (const Tie& tie : stage.ties) {
            carom_joint_state state{};
            state.struct_size = sizeof state;
            assert_int_equal(carom_joint_get_state(stage.world.get(), tie.joint, &state, nullptr), CAROM_OK);
            gap = std::max(gap, state.gap), angle = std::max(angle, state.angle);
            if (tie.kind != CAROM_JOINT_HINGE) continue;  // knees and elbows bend one way
            const double twist = state.coordinate[CAROM_COORDINATE_TWIST];
            const bool is_elbow = stage.actors[tie.b].name.starts_with("forearm");
            assert_true((is_elbow ? -twist : twist) > -c.angle);
          }
          for (std::size_t i = 0; i < stage.actors.size(); ++i)
            if (stage.actors[i].type == CAROM_BODY_DYNAMIC) last = std::max(last, stage.velocity(i).norm());
          if (report.steps == 1) first = last;
          return true;
        });
    for (const std::string& line : observer->tell(stage)) std::printf("  %s: %s\n", c.solver, line.c_str());
    assert_int_equal(run.faults, 0);
    assert_true(gap < c.gap && angle < c.angle);
    assert_true(first > 1.5 && last < 0.1 && observer->came_off(stage));
  }
}

static void crates_float_and_leaves_are_carried_up(void**) {
  const Scene& scene = find_scene("weather");
  Engine engine(PluginPath({CAROM_PLUGIN_DIR}));
  Stage stage(engine);
  const auto observer = build(scene, {}, stage);
  const RunSummary run = simulate(stage, observer.get(), scene.seconds, scene.dt);
  for (const std::string& line : observer->tell(stage)) std::printf("  %s\n", line.c_str());
  assert_true(observer->came_off(stage));
  assert_int_equal(run.faults, 0);
  for (const KindSummary& kind : where_it_ended(stage)) assert_int_equal(kind.escaped + kind.not_finite, 0);
  std::vector<std::string> running;
  for (const carom_plan_line& line : stage.world.plan())
    if (line.runs && line.effect != CAROM_PLAN_NO_EFFECT) running.emplace_back(line.name);
  for (const char* effect : {"drag", "wind", "fields", "springs", "buoyancy"})
    assert_true(std::find(running.begin(), running.end(), effect) != running.end());
}

static void a_pyramid_of_three_rows_stands_and_a_hit_wall_does_not(void**) {
  for (const char* name : {"pyramid", "wall"}) {
    const Scene& scene = find_scene(name);
    Engine engine(PluginPath({CAROM_PLUGIN_DIR}));
    Stage stage(engine);
    Settings settings;
    settings.values = scene.name == "pyramid" ? decltype(settings.values){{"n", 3}}
                                              : decltype(settings.values){{"columns", 4}, {"rows", 3}};
    const auto observer = build(scene, settings, stage);
    assert_int_equal(standing(stage).fallen, 0);
    simulate(stage, observer.get(), 1, scene.dt);
    for (const std::string& line : observer->tell(stage)) std::printf("  %s\n", line.c_str());
    assert_true(observer->came_off(stage));
  }
}

static void a_block_has_fallen_when_it_sinks_or_strays_by_half_an_edge_or_is_not_finite(void**) {
  Engine engine(PluginPath({CAROM_PLUGIN_DIR}));
  Stage stage(engine);
  build(find_scene("pyramid"), {{{"n", 1}, {"gap", 0}}, ""}, stage);  // the ground, and a cube of 1 m at 0.5 m
  const struct {
    Vec moved;
    std::size_t fallen;
  } cases[] = {{{0, 0, 0}, 0},     {{0, -0.504, 0}, 0}, {{0, -0.506, 0}, 1},  // room: 0.5 m and 1 % of 0.5 m
               {{0.3, 0, 0.4}, 0}, {{0.4, 0, 0.4}, 1},  {{0, 3, 0}, 0},      {{NAN, 0, 0}, 1}};
  for (const auto& c : cases) {
    std::vector<Vec> positions;
    for (const Actor& actor : stage.actors) positions.push_back(actor.position + c.moved);
    const Standing s = standing(stage, positions);
    assert_int_equal(s.blocks, 1);
    assert_int_equal(s.fallen, c.fallen);
  }
}

static void a_scene_is_the_same_world_every_time(void**) {
  std::uint64_t hashes[2];
  for (std::uint64_t& hash : hashes) {
    Engine engine(PluginPath({CAROM_PLUGIN_DIR}));
    Stage stage(engine);
    build(find_scene("falling"), {{{"n", 30}}, ""}, stage);
    hash = stage.world.hash();
  }
  assert_true(hashes[0] == hashes[1]);
}

static void obj_faces_come_in_every_notation_and_bad_lines_are_named(void**) {
  const char* path = "scenes_test.obj";
  std::ofstream(path)
      << "# pyramid\nv 0 0 0\nv 2 0 0\nv 2 0 2\nv 0 0 2\nvn 0 1 0\nv 1 3 1\nf 1 2 3 4\nf 1/1 5//2 2/1/1\n"
         "f -4 -1 3\n";
  Mesh mesh = read_obj(path);
  assert_int_equal(mesh.points.size(), 5);
  assert_int_equal(mesh.faces.size(), 4);  // the square is two triangles
  assert_true(mesh.faces[3] == (std::array<std::uint32_t, 3>{1, 4, 2}));
  fit_to_height(mesh, 1.5);
  assert_true(std::fabs(mesh.points[4].y() - 0.75) < 1e-12 && std::fabs(mesh.points[0].x() + 0.5) < 1e-12);
  for (const char* bad : {"v 0 0\n", "v 0 0 nan\n", "v 0 0 0\nf 1 2 3\n", "v 0 0 0\nf 1 1\n", "f a b c\n", "\n"}) {
    std::ofstream(path) << bad;
    bool refused = false;
    try {
      read_obj(path);
    } catch (const Error& error) {
      refused = !error.remedy.empty();
    }
    assert_true(refused);
  }
  std::remove(path);
}

/// A cube with 8 corners, its face centres, and one vertex that sticks out of a face.
static std::vector<Vec> spiked_cube(double spike) {
  std::vector<Vec> points;
  for (int i = 0; i < 8; ++i) points.emplace_back(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
  points.emplace_back(0.3, 0.2, 0.1);
  points.emplace_back(0, 1 + spike, 0);
  return points;
}

static void a_hull_drops_inner_points_and_faces_outward(void**) {
  const Mesh hull = convex_hull(spiked_cube(0.5));
  assert_int_equal(hull.points.size(), 9);
  assert_int_equal(hull.faces.size(), 14);  // Euler: 2 V - 4 triangles
  for (const auto& f : hull.faces) {
    const Vec &a = hull.points[f[0]], &b = hull.points[f[1]], &c = hull.points[f[2]];
    const Vec normal = (b - a).cross(c - a);
    for (const Vec& p : hull.points) assert_true(normal.dot(p - a) <= 1e-12);
  }
}

static void reducing_a_hull_keeps_the_count_and_measures_the_loss(void**) {
  // Without its spike a cube loses exactly the spike's height; a spike below the limit's greed is what goes first.
  const Mesh full = convex_hull(spiked_cube(0.25));
  assert_int_equal(reduce_hull(full, 9).hull.points.size(), 9);
  assert_true(reduce_hull(full, 9).loss == 0);
  const ReducedHull less = reduce_hull(full, 8);
  assert_true(less.hull.points.size() <= 8);
  assert_true(less.loss > 0 && less.loss < 2.3);
  const Bunny many = load_bunny("", 0.5, 128), few = load_bunny("", 0.5, 32);
  assert_true(many.hull.hull.points.size() <= 128 && few.hull.hull.points.size() <= 32);
  assert_true(many.hull.loss < few.hull.loss && few.hull.loss < 0.05);
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(every_scene_runs_half_a_second_finite_and_inside),
      cmocka_unit_test(the_seesaw_throws_the_bunny_and_the_row_falls),
      cmocka_unit_test(the_program_finds_itself_without_proc),
      cmocka_unit_test(the_seesaw_tells_the_same_story_at_every_setting),
      cmocka_unit_test(the_catapult_breaks_the_wall),
      cmocka_unit_test(belts_carry_every_box_to_the_turntable),
      cmocka_unit_test(people_on_stairs_keep_their_joints_and_limits_and_come_to_rest),
      cmocka_unit_test(crates_float_and_leaves_are_carried_up),
      cmocka_unit_test(a_pyramid_of_three_rows_stands_and_a_hit_wall_does_not),
      cmocka_unit_test(a_block_has_fallen_when_it_sinks_or_strays_by_half_an_edge_or_is_not_finite),
      cmocka_unit_test(a_scene_is_the_same_world_every_time),
      cmocka_unit_test(obj_faces_come_in_every_notation_and_bad_lines_are_named),
      cmocka_unit_test(a_hull_drops_inner_points_and_faces_outward),
      cmocka_unit_test(reducing_a_hull_keeps_the_count_and_measures_the_loss),
  };
  return cmocka_run_group_tests_name("tools/scenes", tests, nullptr, nullptr);
}
