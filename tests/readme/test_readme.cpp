// What the README names exists: folders of its map, pictures, presets, subcommands, dials; and its two commands fit
// each other. Paths in backticks are the business of abi/readme_paths.
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "carom_test.h"

namespace {

namespace fs = std::filesystem;
const fs::path kRoot = CAROM_SOURCE_DIR;

std::string read(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

const std::string& readme() {
  static const std::string text = read(kRoot / "README.md");
  return text;
}

/// README.md and the page of the command: what either shows has to work.
const std::string& shown() {
  static const std::string text = readme() + read(kRoot / "src/tools/README.md");
  return text;
}

/// First group of every match.
std::vector<std::string> all(const std::string& text, const char* pattern) {
  const std::regex expression(pattern);
  std::vector<std::string> out;
  for (std::sregex_iterator i(text.begin(), text.end(), expression), end; i != end; ++i) out.push_back((*i)[1]);
  return out;
}

/// The one command after `<!-- command: NAME -->`.
std::string command(const std::string& name) {
  const auto found = all(readme(), ("<!-- command: " + name + " -->\n```sh\n([^\n]+)\n```").c_str());
  return found.size() == 1 ? found[0] : "";
}

std::set<std::string> packages(const std::string& line) {
  const auto list = all(line, "--no-install-recommends ([^&]*)&&");
  if (list.size() != 1) return {};
  const auto words = all(list[0], "(\\S+)");
  return {words.begin(), words.end()};
}

std::string output_of(const std::string& line) {
  std::string out;
  FILE* pipe = popen((line + " 2>&1").c_str(), "r");
  if (!pipe) return out;
  char buffer[4096];
  for (std::size_t n; (n = fread(buffer, 1, sizeof buffer, pipe)) > 0;) out.append(buffer, n);
  pclose(pipe);
  return out;
}

/// Report all that is missing before failing: one run, one list.
void assert_none(const std::vector<std::string>& missing, const char* what) {
  for (const std::string& m : missing) print_error("README.md names %s, %s\n", m.c_str(), what);
  assert_true(missing.empty());
}

}  // namespace

static void every_folder_of_the_map_and_every_picture_exists(void**) {
  std::vector<std::string> paths = all(readme(), "\\]\\(([^)#:]+)\\)");  // pictures and links
  for (const std::string& p : all(readme(), "\n    ([a-z]+(?:/[a-z]+)*/) ")) {
    paths.push_back(p);
    const auto line = all(readme(), ("\n    " + p + " ([^\n]*)").c_str());
    assert_int_equal(line.size(), 1);
    for (const std::string& inside : all(line[0], "([a-z_]+/|[a-z_]+\\.(?:h|cpp))")) paths.push_back(p + inside);
  }
  assert_true(paths.size() > 15);
  std::vector<std::string> missing;
  for (const std::string& p : paths)
    if (!fs::exists(kRoot / p)) missing.push_back(p);
  assert_none(missing, "which does not exist");
}

static void every_preset_exists(void**) {
  const std::string presets = read(kRoot / "CMakePresets.json");
  std::vector<std::string> named = all(readme(), "(?:cmake|ctest)[^\n]*--preset ([a-z]+)"), missing;
  const auto list = all(readme(), "CMake presets: ([^.]*)\\.");
  assert_int_equal(list.size(), 1);
  for (const std::string& p : all(list[0], "`([a-z]+)`")) named.push_back(p);
  assert_true(named.size() >= 8);
  for (const std::string& p : named)
    if (presets.find("{\"name\": \"" + p + "\"") == std::string::npos) missing.push_back(p);
  assert_none(missing, "which is no preset in CMakePresets.json");
}

static void every_subcommand_is_one_and_none_is_kept_secret(void**) {
  const std::string help = output_of(std::string(CAROM_COMMAND) + " --help");
  const auto list = help.find("Subcommands:");
  assert_true(list != std::string::npos);
  const auto known_list = all(help.substr(list), "\n  ([a-z]+) ");
  const std::set<std::string> known(known_list.begin(), known_list.end());
  const auto used_list = all(shown(), "(?:`|\n    |bin/)carom ([a-z]+)");
  const std::set<std::string> used(used_list.begin(), used_list.end());
  std::vector<std::string> missing;
  std::set_difference(used.begin(), used.end(), known.begin(), known.end(), std::back_inserter(missing));
  assert_none(missing, "which is no subcommand of carom");
  std::set_difference(known.begin(), known.end(), used.begin(), used.end(), std::back_inserter(missing));
  for (const std::string& m : missing)
    print_error("neither README.md nor src/tools/README.md names the subcommand %s\n", m.c_str());
  assert_true(missing.empty());
}

static void every_scene_and_dial_that_is_run_exists(void**) {
  const std::string scenes = output_of(std::string(CAROM_COMMAND) + " list");
  const std::string dials = output_of(std::string(CAROM_COMMAND) + " dials");
  std::vector<std::string> missing;
  for (const std::string& s : all(shown(), "carom run ([a-z]+)"))
    if (scenes.find(s) == std::string::npos) missing.push_back(s);
  for (const std::string& d : all(shown(), "--dial ([a-z_]+)="))
    if (dials.find(d) == std::string::npos) missing.push_back(d);
  assert_none(missing, "which is neither a scene nor a dial");
}

static void the_main_job_runs_in_an_empty_folder_and_writes_its_file(void**) {
  const auto arguments = all(command("main job"), "build/demo/bin/carom (run [^&]*)$");
  assert_int_equal(arguments.size(), 1);
  const auto file = all(arguments[0], "--gltf (\\S+)");
  assert_int_equal(file.size(), 1);
  const fs::path folder = fs::temp_directory_path() / ("carom_readme_" + std::to_string(getpid()));
  fs::create_directory(folder);
  const std::string said =
      output_of("cd " + folder.string() + " && " + CAROM_COMMAND + " " + arguments[0] + " && echo it ended well");
  const bool written = fs::exists(folder / file[0]) && fs::file_size(folder / file[0]) > 0;
  fs::remove_all(folder);
  if (said.find("it ended well") == std::string::npos) print_error("%s", said.c_str());
  assert_true(said.find("it ended well") != std::string::npos);
  assert_true(written);
}

static void the_two_commands_are_single_lines_and_the_second_needs_all_of_the_first(void**) {
  const std::string demo = command("main job"), tests = command("tests");
  assert_true(demo.find("build/demo/bin/carom run seesaw") != std::string::npos);
  assert_true(tests.find("&& .ci/test") != std::string::npos);
  const auto few = packages(demo), many = packages(tests);
  assert_true(few.size() > 5);
  assert_true(std::includes(many.begin(), many.end(), few.begin(), few.end()));
}

static void a_page_is_enough(void**) {
  const auto lines = std::count(readme().begin(), readme().end(), '\n');
  if (lines > 150)
    print_error("README.md has %ld lines: 150 are enough, the rest belongs to the pages that it links\n", long(lines));
  assert_true(lines <= 150);
}

static void hello_checks_every_result_in_25_lines_without_a_path_in_argv(void**) {
  const auto programs = all(readme(), "```c\n([^`]*)```");
  assert_true(!programs.empty());
  const std::string& hello = programs[0];
  assert_true(std::count(hello.begin(), hello.end(), '\n') <= 25);
  assert_true(hello.find("argv") == std::string::npos);
  std::string rest = hello;  // without what is checked, and what is no call
  for (const char* checked : {"TRY(carom_", "CAROM_ERROR_INIT"})
    for (std::size_t at; (at = rest.find(checked)) != std::string::npos;) rest.erase(at, std::string(checked).size());
  const auto unchecked = all(rest, "(carom_[a-z_]+)\\(");
  for (const std::string& call : unchecked) print_error("README.md's hello does not check %s()\n", call.c_str());
  assert_true(unchecked.empty());
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(a_page_is_enough),
      cmocka_unit_test(hello_checks_every_result_in_25_lines_without_a_path_in_argv),
      cmocka_unit_test(every_folder_of_the_map_and_every_picture_exists),
      cmocka_unit_test(every_preset_exists),
      cmocka_unit_test(every_subcommand_is_one_and_none_is_kept_secret),
      cmocka_unit_test(every_scene_and_dial_that_is_run_exists),
      cmocka_unit_test(the_main_job_runs_in_an_empty_folder_and_writes_its_file),
      cmocka_unit_test(the_two_commands_are_single_lines_and_the_second_needs_all_of_the_first),
  };
  return cmocka_run_group_tests_name("readme", tests, nullptr, nullptr);
}
