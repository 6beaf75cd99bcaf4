// The `carom` command as a person meets it: exit codes, errors that say what to do, `carom check` on invalid plugins.
#include <carom/carom.h>

#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "carom_command.h"

using command_test::Outcome, command_test::run_carom;

namespace {

Outcome carom(const std::string& arguments, bool errors_too = true) { return run_carom(arguments, errors_too); }

bool says(const Outcome& o, const std::string& text) { return o.text.find(text) != std::string::npos; }

/// @param seconds  of CPU that the check may take: a busy machine with sanitizers needs over one for all but the first stages
void invalid_plugin(const char* name, const char* must_say, int seconds = 60) {
  const Outcome o =
      carom("check " + std::string(CAROM_INVALIDS) + "/" + name + ".so --seconds " + std::to_string(seconds));
  if (o.code != 1 || !says(o, must_say)) std::printf("%s: %d\n%s\n", name, o.code, o.text.c_str());
  assert_int_equal(o.code, 1);
  assert_true(says(o, "INVALID"));
  assert_true(says(o, "what to do"));
  assert_true(says(o, must_say));
}

}  // namespace

/// Shards one after the other are the whole, to the byte, however many there are; one that was cut off goes on; what is
/// no shard, no range and no file of the sweep is refused.
static void shards_of_a_sweep_join_to_the_whole(void**) {
  const std::string sweep = "sweep falling --over n=2..4 --over-dial substeps=1,3 --seconds 0.2 ";
  const Outcome whole = carom(sweep, false);
  assert_int_equal(whole.code, 0);
  std::size_t lines = 0;
  for (const char c : whole.text) lines += c == '\n';
  assert_int_equal(lines, 6);
  for (const int n : {1, 2, 4, 9}) {
    std::string joined;
    for (int i = 1; i <= n; ++i)
      joined += carom(sweep + "--shard " + std::to_string(i) + "/" + std::to_string(n), false).text;
    assert_true(joined == whole.text);
  }
  const nlohmann::json line = nlohmann::json::parse(whole.text.substr(0, whole.text.find('\n')));
  const Outcome run = carom("run falling --n 2 --dial substeps=1 --seconds 0.2 --json", false);
  assert_true(line["hash"] == nlohmann::json::parse(run.text)["hash"]);
  const std::string path =
      (std::filesystem::temp_directory_path() / ("carom_sweep_" + std::to_string(getpid()) + ".jsonl")).string();
  for (const std::size_t kept : {std::size_t{0}, whole.text.find('\n') + 20, whole.text.size()}) {
    std::ofstream(path, std::ios::binary) << whole.text.substr(0, kept);
    assert_int_equal(carom(sweep + "--out " + path).code, 0);
    std::ifstream file(path, std::ios::binary);
    assert_true(std::string(std::istreambuf_iterator<char>(file), {}) == whole.text);
  }
  for (const char* const wrong :
       {"--shard 0/2", "--shard 3/2", "--shard 1", "--over n", "--over n=5..2", "--over n=1,,2"}) {
    const Outcome o = carom(sweep + wrong);
    assert_true(o.code == 2 && says(o, "what to do"));
  }
  const Outcome other = carom("sweep falling --over n=2..3 --seconds 0.2 --out " + path);
  assert_true(other.code == 2 && says(other, "something else"));
  std::remove(path.c_str());
}

static void errors_exit_nonzero_and_say_what_to_do(void**) {
  const struct {
    const char *line, *expected;
  } cases[] = {
      {"run sesaw", "did you mean 'seesaw'"},
      {"run", "no scene is named"},
      {"", "carom run seesaw"},
      {"run falling --n 0", "from 1 to 100000"},
      {"run falling --set m=3", "it has: n"},
      {"run falling --set n", "name=value"},
      {"run falling --n 4 --dt -1", "--dt"},
      {"run falling --n 4 --dial brod_phase=grid", "did you mean 'broad_phase'"},
      {"run falling --n 4 --dial broad_phase=octree", "brute_force, sweep_and_prune, grid, tree"},
      {"run falling --n 4 --dial substeps=0", "what to do"},
      {"run falling --n 4 --dial direct_impact_share=1", "it is fixed"},
      {"run falling --n 4 --gltf motion.obj", ".gltf or .glb"},
      {"run falling --n 4 --gltf /no/such/folder/x.glb", "folder"},
      {"run falling --n 4 --csv /no/such/folder/x.csv", "folder"},
      {"run seesaw --mesh /no/such/mesh.obj", "check the path and its permissions"},
      {"run falling --n 4 --force wnd", "the effects are: gyroscopic, "},
      {"plan sesaw", "did you mean 'seesaw'"},
      {"plan falling --n 4 --forbid gravty", "did you mean 'gravity'"},
      {"plan falling --n 4 --forbid drag --force drag", "both forbidden and forced"},
      {"plan falling --n 4 --seconds 0", "--seconds"},
      {"check /no/such/plugin.so", "carom shapes"},
      {"check box 1 1", "half_extent"},
      {"check box 1 1 0", "half_extent"},
      // Words: commands, options, arguments.
      {"rn seesaw", "did you mean 'run'"},
      {"Run seesaw", "did you mean 'run'"},
      {"falling", "write: carom run falling"},
      {"help rn", "did you mean 'run'"},
      {"accuracy rn", "did you mean 'run'"},
      {"accuracy", "carom help accuracy"},
      {"--verison", "did you mean '--version'"},
      {"run seesaw --secnds 3", "did you mean '--seconds'"},
      {"run falling foo", "write: carom run [SCENE]"},
      {"list foo", "write: carom list"},
      {"export falling", "write: carom export SCENE FILE"},
      {"accuracy sweep slide", "--out FILE.json|FILE.csv"},
      // Numbers.
      {"run falling --n abc", "--n cannot be 'abc'"},
      {"run falling --n", "write: --n"},
      {"plan falling --seconds x", "--seconds cannot be 'x'"},
      {"run falling --seconds 0", "at most 1e6"},
      {"run falling --dt 2", "from 1e-9 to 1"},
      {"run falling --threads 0", "from 1 to 256"},
      {"run falling --threads abc", "from 1 to 256"},
      {"run falling --accuracy 0", "--accuracy 1e-3"},
      {"run falling --accuracy nan", "--accuracy 1e-3"},
      {"run falling --dial substeps=1e6", "a whole number from 1 to 64"},
      {"run falling --dial substeps=2.5", "a whole number from 1 to 64"},
      {"run falling --dial position_tolerance=nan", "give a number from"},
      {"run falling --dial =3", "names no dial"},
      {"run falling --preset fats", "did you mean 'fast'"},
      {"view --port 99999", "from 0 to 65535"},
      // Files and folders.
      {"--plugins /no/such list", "there is no folder /no/such"},
      {"shapes --plugins /dev/null", "is no folder"},
      {"run .", "is a folder, not a scene"},
      {"plan /dev/null", "is no scene file"},
      {"run nowhere/at.all", "there is no file"},
      {"run " CAROM_SOURCE_DIR "/README.md", "is no scene file"},
      {"run falling --n 4 --svg a.jpg", ".svg or .png"},
      {"run falling --n 4 --filmstrip a", ".svg or .png"},
      {"run falling --n 4 --ledger-svg a.pdf", ".svg or .png"},
      {"accuracy ask mixed --svg a.jpg", ".svg or .png"},
      {"run falling --n 4 --svg /no/such/folder/a.svg", "mkdir -p /no/such/folder"},
      {"run falling --n 4 --save /no/such/folder/w", "mkdir -p /no/such/folder"},
      {"run falling --n 4 --record .", "it is a folder"},
      {"run falling --load /dev/null", "--save FILE"},
      {"run --load no_such_file", "there is no file"},
      {"replay " CAROM_SOURCE_DIR "/README.md", "carom run SCENE --record FILE"},
      {"check spere", "did you mean 'sphere'"},
  };
  for (const auto& c : cases) {
    const Outcome o = carom(c.line);
    if (o.code != 2 || !says(o, c.expected)) std::printf("carom %s: %d\n%s\n", c.line, o.code, o.text.c_str());
    assert_int_equal(o.code, 2);
    assert_true(says(o, "what to do"));
    assert_true(says(o, c.expected));
    // Words of the shell: no function of the C interface, none of its types' fields.
    const std::string remedy = o.text.substr(o.text.rfind("what to do"));
    const bool plain = remedy.find("()") == std::string::npos && !says(o, "->");
    if (!plain) std::printf("carom %s: %s\n", c.line, o.text.c_str());
    assert_true(plain);
    assert_false(says(o, "look for:"));  // it is told before the run begins
  }
}

static void help_is_a_command(void**) {
  const Outcome all = carom("help"), run = carom("help run"), nested = carom("help accuracy ask");
  assert_int_equal(all.code, 0);
  assert_true(says(all, "Subcommands:") && says(all, "carom run seesaw"));
  assert_true(all.text == carom("--help").text);
  assert_true(run.code == 0 && says(run, "--gltf") && run.text == carom("run --help").text);
  assert_true(nested.code == 0 && says(nested, "carom accuracy ask") && says(nested, "--tolerance"));
}

static void lists_show_every_scene_shape_and_dial(void**) {
  const Outcome scenes = carom("list"), shapes = carom("shapes"), dials = carom("dials");
  assert_int_equal(scenes.code, 0);
  assert_int_equal(shapes.code, 0);
  assert_int_equal(dials.code, 0);
  for (const char* name : {"seesaw", "catapult", "bunnies", "particles", "falling"}) assert_true(says(scenes, name));
  for (const char* name : {"sphere", "box", "capsule", "cylinder", "cone", "ellipsoid", "hull"})
    assert_true(says(shapes, name));
  for (const char* name : {"broad_phase", "sweep_and_prune", "gjk_tolerance", "Constants", "direct_impact_share = 0.1",
                           "facet_tilt = 0.03 rad"})
    assert_true(says(dials, name));
}

static void a_run_reports_itself_as_json_and_csv(void**) {
  const std::string csv = "command_steps.csv", motion = "command_motion.csv";
  const Outcome o = carom("run falling --n 8 --seconds 0.5 --json --csv-steps " + csv + " --csv " + motion, false);
  assert_int_equal(o.code, 0);
  const nlohmann::json summary = nlohmann::json::parse(o.text);
  assert_int_equal(summary.at("steps").get<int>(), 30);
  assert_int_equal(summary.at("bodies").get<int>(), 13);
  assert_true(summary.at("steps_per_s").at("min").get<double>() > 0);
  double in_stages = 0;
  for (const auto& [name, seconds] : summary.at("stage_s").items()) in_stages += seconds.get<double>();
  assert_true(in_stages > 0 && in_stages <= summary.at("computing_s").get<double>());
  auto lines = [](const std::string& path) {
    std::ifstream file(path);
    int count = 0;
    for (std::string line; std::getline(file, line);) ++count;
    return count;
  };
  assert_int_equal(lines(csv), 31);
  assert_int_equal(lines(motion), 1 + 8 * 16);  // 8 bodies that move, 0.5 s at 30 frames a second, both ends
  std::remove(csv.c_str());
  std::remove(motion.c_str());
}

static void the_same_run_twice_ends_in_the_same_bits(void**) {
  const auto hash = [] {
    return nlohmann::json::parse(carom("run falling --n 12 --seconds 1 --json", false).text)
        .at("hash")
        .get<std::string>();
  };
  assert_string_equal(hash().c_str(), hash().c_str());
}

static void a_run_tells_what_happened_before_what_it_cost(void**) {
  const Outcome told = carom("run seesaw --seconds 0.1");
  assert_true(says(told, "simulated 0.10 s of world time in 12 steps:") && says(told, "\ncost:") &&
              says(told, "state hash:"));
  assert_true(told.text.find("simulated") < told.text.find("\ncost:"));
  assert_true(told.text.find("state hash") < told.text.find("ms/step"));
}

static void a_plan_tells_what_runs_for_whom_and_what_is_left_out(void**) {
  const auto effects_of = [](const std::string& arguments) {
    const Outcome o = carom("plan falling --n 8 --json " + arguments, false);
    assert_int_equal(o.code, 0);
    nlohmann::json by_name;
    const nlohmann::json plan = nlohmann::json::parse(o.text);
    for (const auto& effect : plan.at("effects")) by_name[effect.at("name")] = effect;
    return by_name;
  };
  const nlohmann::json plain = effects_of("");
  assert_int_equal(plain.size(), CAROM_EFFECT_COUNT);
  assert_int_equal(plain.at("gravity").at("participants").get<int>(), 8);
  assert_true(plain.at("gravity").at("evaluations").get<int>() >= 8 * 60);  // 1 s: once a step at least
  assert_true(plain.at("gravity").at("seconds").get<double>() > 0);
  assert_true(plain.at("friction").at("seconds").is_null());  // in the loops of its stage, so by difference
  assert_true(plain.at("friction").at("difference").at("seconds").get<double>() < 1e-2);
  assert_true(plain.at("friction").at("difference").at("spread").get<double>() >= 0);
  assert_false(plain.at("gravity").contains("difference"));
  assert_false(plain.at("drag").at("runs").get<bool>());
  assert_int_equal(plain.at("drag").at("bytes").get<int>(), 0);
  assert_string_equal(plain.at("drag").at("reason").get<std::string>().c_str(), "no body has drag");

  const nlohmann::json changed = effects_of("--forbid gravity --force drag --seconds 0.1");
  assert_false(changed.at("gravity").at("runs").get<bool>());
  assert_string_equal(changed.at("gravity").at("mode").get<std::string>().c_str(), "forbidden");
  assert_int_equal(changed.at("gravity").at("wanted").get<int>(), 8);
  assert_int_equal(changed.at("gravity").at("evaluations").get<int>(), 0);
  assert_string_equal(changed.at("drag").at("mode").get<std::string>().c_str(), "forced");
  assert_int_equal(changed.at("drag").at("participants").get<int>(), 8);
  assert_int_equal(changed.at("drag").at("wanted").get<int>(), 0);

  const Outcome text = carom("plan falling --n 8 --forbid gravity");
  assert_int_equal(text.code, 0);
  for (const char* expected :
       {"participants", "left out", "no body has drag", "though the scene calls for it: 8 bodies"})
    assert_true(says(text, expected));
}

static void a_run_shows_its_plan_and_minds_what_is_forbidden_or_forced(void**) {
  const auto run = [](const std::string& arguments) {
    return nlohmann::json::parse(carom("run falling --n 8 --seconds 0.5 --json " + arguments, false).text);
  };
  const nlohmann::json plain = run(""), seen = run("--plan"), forced = run("--force drag"),
                       light = run("--forbid gravity");
  assert_false(plain.contains("plan"));
  assert_int_equal(seen.at("plan").at("effects").size(), CAROM_EFFECT_COUNT);
  assert_true(seen.at("hash") == plain.at("hash"));    // looking at it changes nothing,
  assert_true(forced.at("hash") == plain.at("hash"));  // nor does what nobody calls for,
  assert_true(light.at("hash") != plain.at("hash"));   // but this does
  assert_true(says(carom("run falling --n 8 --seconds 0.1 --plan"), "the plan of the last step"));
  assert_string_equal(carom("run falling --n 8 --seconds 0.1 --plan --quiet").text.c_str(), "");
}

static void valid_plugins_pass_the_check(void**) {
  for (const char* name : {"sphere", "box", "capsule", "cylinder", "cone", "ellipsoid", "hull", "template"}) {
    const Outcome o = carom(std::string("check ") + name);
    if (o.code) std::printf("%s\n", o.text.c_str());
    assert_int_equal(o.code, 0);
    assert_true(says(o, "valid"));
  }
  assert_int_equal(carom("check " CAROM_INVALIDS "/valid.so").code, 0);
  assert_int_equal(carom("check box 0.5 2 0.25").code, 0);
}

/// A folder of strangers' plugins: each is listed or refused, whatever one of them does.
static void a_plugin_that_hangs_or_crashes_keeps_no_other_from_the_list(void**) {
  const Outcome o = carom("--plugins " CAROM_INVALIDS " shapes");
  assert_int_equal(o.code, 1);
  assert_true(says(o, "hang  REFUSED") && says(o, "did not return within 5 s") && says(o, "run `carom check"));
  assert_true(says(o, "valid  (") && says(o, "sphere  (carom.sphere") && says(o, "half_space  (built in"));
}

static void a_plugin_that_hangs_is_stopped_and_the_direction_named(void**) {
  invalid_plugin("hang", "did not come back within 1 s", 1);
  invalid_plugin("hang", "direction:  (", 1);
}

static void a_plugin_that_crashes_takes_only_the_child_with_it(void**) { invalid_plugin("crash", "direction:  ("); }
static void a_plugin_that_leaves_the_call_is_told_how(void**) {
  invalid_plugin("abort", "it crashed (signal 6: Aborted)");
  invalid_plugin("exit", "it ended the process (status 0)");
  invalid_plugin("throw", "it threw an exception");
  for (const char* name : {"abort", "exit", "jump", "throw"}) invalid_plugin(name, "direction:  (");
}

static void nan_dents_lengths_memory_and_false_declarations_are_caught(void**) {
  invalid_plugin("nan", "NaN");
  invalid_plugin("dent", "convex");
  invalid_plugin("length", "length");
  invalid_plugin("rules", "keeps its rules");
  invalid_plugin("memory", "second time");
  invalid_plugin("declaration", "CAROM_E_DECLARATION_FALSE");
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(errors_exit_nonzero_and_say_what_to_do),
      cmocka_unit_test(shards_of_a_sweep_join_to_the_whole),
      cmocka_unit_test(help_is_a_command),
      cmocka_unit_test(lists_show_every_scene_shape_and_dial),
      cmocka_unit_test(a_run_reports_itself_as_json_and_csv),
      cmocka_unit_test(the_same_run_twice_ends_in_the_same_bits),
      cmocka_unit_test(a_run_tells_what_happened_before_what_it_cost),
      cmocka_unit_test(a_plan_tells_what_runs_for_whom_and_what_is_left_out),
      cmocka_unit_test(a_run_shows_its_plan_and_minds_what_is_forbidden_or_forced),
      cmocka_unit_test(valid_plugins_pass_the_check),
      cmocka_unit_test(a_plugin_that_hangs_or_crashes_keeps_no_other_from_the_list),
      cmocka_unit_test(a_plugin_that_hangs_is_stopped_and_the_direction_named),
      cmocka_unit_test(a_plugin_that_crashes_takes_only_the_child_with_it),
      cmocka_unit_test(a_plugin_that_leaves_the_call_is_told_how),
      cmocka_unit_test(nan_dents_lengths_memory_and_false_declarations_are_caught),
  };
  return cmocka_run_group_tests_name("tools/command", tests, nullptr, nullptr);
}
