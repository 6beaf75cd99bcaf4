// `carom accuracy` as a person meets it: what it lists, what it prints, its table, and its exit codes.
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "carom_command.h"

using command_test::Outcome, command_test::run_carom;

namespace {

Outcome carom(const std::string& arguments) { return run_carom("accuracy " + arguments); }

std::vector<std::string> cells(const std::string& line) {  // commas inside quotes belong to a cell
  std::vector<std::string> list(1);
  bool quoted = false;
  for (char c : line) {
    if (c == '"') quoted = !quoted;
    if (c == ',' && !quoted)
      list.emplace_back();
    else if (c != '"')
      list.back() += c;
  }
  return list;
}

}  // namespace

static void the_list_names_scenes_bounds_and_truths(void**) {
  const Outcome list = carom("list");
  assert_int_equal(list.code, 0);
  for (const char* word : {"bouncing", "rolling", "massratio1e6", "kapla", "1e-10", "v^2 / (2 mu g)"})
    assert_true(list.says(word));
}

static void a_run_prints_error_bound_peers_and_cost(void**) {
  const Outcome good = carom("run skid --dial solver=severity --dial substeps=1");
  assert_int_equal(good.code, 0);
  for (const char* word : {"onset of rolling", "yes", "ms/s", "truth:"}) assert_true(good.says(word));
  const Outcome bad = carom("run slide --dt 1/30 --dial solver=severity --dial substeps=1");  // off by v h / 2 = 8 cm
  assert_int_equal(bad.code, 1);
  assert_true(bad.says("0.0023 Box3D") && bad.says(" no"));
}

static void the_table_holds_what_was_measured(void**) {
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / ("carom_accuracy_" + std::to_string(getpid()) + ".csv");
  carom("run slide --steps-halved 1 --dial solver=severity --dial substeps=2 --csv " + file.string());
  std::ifstream in(file);
  std::vector<std::vector<std::string>> rows;
  for (std::string line; std::getline(in, line);) rows.push_back(cells(line));
  in.close();
  std::filesystem::remove(file);
  assert_int_equal(rows.size(), 5);  // header; two errors at two steps
  for (const auto& row : rows) assert_int_equal(row.size(), rows[0].size());
  assert_string_equal(rows[1][0].c_str(), "slide");
  assert_true(std::atof(rows[1][1].c_str()) == 2 * std::atof(rows[3][1].c_str()));
  // Two substeps of 1/120 s: off by v h / 2 = 2.1 cm, to a step's part of the last metre.
  assert_true(std::fabs(std::atof(rows[1][4].c_str()) - 5.0 / 240) < 1e-3);
  assert_string_equal(rows[1].back().c_str(), "solver=severity substeps=2");
}

static void what_cannot_be_run_says_what_to_do(void**) {
  const struct {
    const char *line, *expected;
  } cases[] = {{"run slidee", "did you mean 'slide'"},
               {"run slide --dt 1/x", "--dt 1/60"},
               {"run slide --dt 1/0", "time step"},
               {"run slide --dt -1", "time step"},
               {"run slide --steps-halved 99", "0 to 10"},
               {"run slide --dial solvr=severity", "did you mean 'solver'"},
               {"run slide --set nu=1", "it has:"},
               {"run all --set mu=1", "name the scene"},
               {"run", "SCENE"},
               {"run slide --seconds -1", "more than 0"},
               {"run slide --csv /nowhere/at/all.csv", "what to do"}};
  for (const auto& c : cases) {
    const Outcome outcome = carom(c.line);
    if (outcome.code != 2 || !outcome.says(c.expected))
      std::printf("%s: %d\n%s", c.line, outcome.code, outcome.text.c_str());
    assert_int_equal(outcome.code, 2);
    assert_true(outcome.says(c.expected));
  }
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(the_list_names_scenes_bounds_and_truths),
      cmocka_unit_test(a_run_prints_error_bound_peers_and_cost),
      cmocka_unit_test(the_table_holds_what_was_measured),
      cmocka_unit_test(what_cannot_be_run_says_what_to_do),
  };
  return cmocka_run_group_tests_name("tools/accuracy_command", tests, nullptr, nullptr);
}
