// One participant among 10,000 bodies costs one participant's work, counted in instructions: the test runs itself under
// callgrind, which counts those of steps alone. Skipped where there is no valgrind, or a sanitizer in its way.
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>

#include "carom_test.h"
#include "subjects.h"

#if __has_include(<valgrind/callgrind.h>) && !defined(CAROM_SANITIZED)
#include <valgrind/callgrind.h>
#define CAROM_COUNTS 1
#else
#define CAROM_COUNTS 0
#endif

using namespace carom;
using namespace carom::test;

namespace {

constexpr int kWarm = 3, kCounted = 4, kSome = 1000, kCrowd = 10000;

std::string label(const char* what, int crowd) { return std::string(what) + " " + std::to_string(crowd); }

/// A step, that one participant may cost more among many than alone: a look at lists that are longer by a run of slots.
constexpr double kSlack = 100;
/// And where the crowd takes its step apart from who is bound, by contacts, joints or forces that depend on the state: loops
/// that begin once more.
constexpr double kFlight = 4000;
bool binds(const Subject& s) { return s.row != +EffectId::gravity && s.row != +EffectId::user_force; }

#if CAROM_COUNTS
void count(const char* what, int crowd, const std::function<void(Stage0&)>& call) {
  const std::string name = label(what, crowd);  // alive until callgrind has read it
  Stage0 s(crowd);
  if (call) call(s);
  s.steps(kWarm);
  CALLGRIND_ZERO_STATS;
  CALLGRIND_TOGGLE_COLLECT;
  s.steps(kCounted);
  CALLGRIND_TOGGLE_COLLECT;
  CALLGRIND_DUMP_STATS_AT(name.c_str());
}

void count_all() {
  for (const int crowd : {0, kSome, kCrowd}) {
    count("nobody", crowd, {});
    for (const Subject& s : subjects())
      if (s.spares) count(effect_table()[s.row].name, crowd, s.call);
  }
}

/// Instructions a step, by label, from the files that callgrind wrote.
std::map<std::string, double> read_counts(const std::filesystem::path& folder) {
  std::map<std::string, double> counts;
  for (const auto& file : std::filesystem::directory_iterator(folder)) {
    std::ifstream in(file.path());
    std::string line, name;
    while (std::getline(in, line)) {
      constexpr std::string_view kTrigger = "desc: Trigger: Client Request: ", kTotals = "totals: ";
      if (line.starts_with(kTrigger)) name = line.substr(kTrigger.size());
      if (line.starts_with(kTotals) && !name.empty())
        counts[name] = std::strtod(line.c_str() + kTotals.size(), nullptr) / kCounted;
    }
  }
  return counts;
}

std::string g_self;

void one_among_ten_thousand_costs_what_one_alone_costs(void**) {
  if (std::system("valgrind --version > /dev/null 2>&1") != 0) {
    print_message("no valgrind here: not counted\n");
    skip();
  }
  char folder[] = "/tmp/carom_counts_XXXXXX";
  assert_non_null(mkdtemp(folder));
  const std::string command =
      "valgrind -q --tool=callgrind --collect-atstart=no --callgrind-out-file=" + std::string(folder) + "/out '" +
      g_self + "' instructions --count > /dev/null 2>&1";
  assert_int_equal(std::system(command.c_str()), 0);
  const std::map<std::string, double> counts = read_counts(folder);
  std::filesystem::remove_all(folder);
  assert_true(counts.size() > 20 && counts.at(label("nobody", kCrowd)) > 10 * counts.at(label("nobody", 0)));
  for (const Subject& s : subjects()) {
    if (!s.spares) continue;
    const char* const name = effect_table()[s.row].name;
    const auto cost = [&](int crowd) { return counts.at(label(name, crowd)) - counts.at(label("nobody", crowd)); };
    const double alone = cost(0), some = cost(kSome), among = cost(kCrowd);
    print_message("%-19s %7.0f instructions a step alone, %7.0f among %d, %7.0f among %d\n", name, alone, some, kSome,
                  among, kCrowd);
    if (!(alone > 0) || among > some + kSlack || among > alone + (binds(s) ? kFlight : kSlack)) {
      print_error("%s costs %g alone and %g among %d\n", name, alone, among, kCrowd);
      assert_true(false);
    }
  }
}
#else
void one_among_ten_thousand_costs_what_one_alone_costs(void**) {
  print_message("built without valgrind's header, or with a sanitizer: not counted\n");
  skip();
}
#endif

}  // namespace

int main(int argc, char** argv) {
#if CAROM_COUNTS
  if (argc > 1) return count_all(), 0;
  g_self = std::filesystem::read_symlink("/proc/self/exe").string();
#else
  (void)argc, (void)kSome, (void)kCrowd, (void)kSlack, (void)kFlight, (void)binds, (void)kWarm, (void)kCounted,
      (void)label;
#endif
  (void)argv;
  const CMUnitTest tests[] = {cmocka_unit_test(one_among_ten_thousand_costs_what_one_alone_costs)};
  return cmocka_run_group_tests_name("effects/instructions", tests, nullptr, nullptr);
}
