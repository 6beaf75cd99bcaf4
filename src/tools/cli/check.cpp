// `carom check PLUGIN.so`: is this shape plugin valid? Tried in a child process; prints a witness when it is not.
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <new>

#include "check/probe.h"
#include "cli/children.h"
#include "cli/commands.h"
#include "cli/table.h"

namespace carom::tools {
namespace {

struct CheckOptions {
  std::string plugin;
  std::vector<double> params;
  unsigned seconds = 20;
};

/// A file as given, or a plugin's short name on the search path.
std::string absolute_path(const std::string& given, const PluginPath& path) {
  std::error_code failed;
  if (std::filesystem::is_regular_file(given, failed)) return std::filesystem::absolute(given).string();
  if (std::filesystem::path(given).filename() == given && !given.ends_with(kPluginEnding)) return path.find(given);
  throw Error("there is no file " + given,
              "give the path of a shared object, or the name of a plugin that `carom shapes` lists");
}

std::string triple(const double v[3]) { return format("(%.17g, %.17g, %.17g)", v[0], v[1], v[2]); }

void print_witness(const Witness& witness, bool has_point) {
  std::string params;
  for (std::uint64_t i = 0; i < std::min<std::uint64_t>(witness.param_count, kParamsShown); ++i)
    params += (i ? " " : "") + format("%.17g", witness.params[i]);
  if (witness.param_count > kParamsShown)
    params += format(" ... (%llu in all)", static_cast<unsigned long long>(witness.param_count));
  std::printf("     parameters: %s\n     direction:  %s\n", params.empty() ? "none" : params.c_str(),
              triple(witness.dir).c_str());
  if (has_point) std::printf("     point:      %s\n", triple(witness.out).c_str());
}

/// The child ended before its verdict: how, and with which input.
void print_death(const ChildEnd& end, const Verdict& verdict, unsigned seconds) {
  std::string how;
  if (end.out_of_time)
    how = format("it did not come back within %u s", seconds);
  else if (end.signal)
    how = format("it crashed (signal %d: %s)", end.signal, signal_text(end.signal).c_str());
  else if (verdict.threw)
    how = "it threw an exception";
  else
    how = format("it ended the process (status %d)", end.status);
  std::printf("  INVALID: %s, while %s\n", how.c_str(), phase_text(verdict.phase));
  if (verdict.phase >= Phase::sample && verdict.phase <= Phase::shapes && verdict.phase != Phase::threads)
    print_witness(verdict.current, false);
  std::printf(
      "     what to do: %s\n",
      end.out_of_time
          ? "a support function needs no open-ended loop: bound every loop and check what ends it for this input"
      : verdict.threw || !end.signal || end.signal == SIGABRT
          ? "return other than 0 instead: no exception, abort(), exit() or longjmp() may leave a support function"
          : "check array indices against param_len and every pointer; run it under valgrind with this input");
}

int print_verdict(const Verdict& verdict, const ChildEnd& end, const CheckOptions& options) {
  const bool finished = end.left && end.status == 0 && verdict.complete && !verdict.threw;
  std::printf("  %s; %llu calls, %llu parameter sets, %llu shapes made%s\n", verdict.id[0] ? verdict.id : "(no id)",
              static_cast<unsigned long long>(verdict.calls), static_cast<unsigned long long>(verdict.param_sets),
              static_cast<unsigned long long>(verdict.shapes),
              verdict.seconds_per_call > 0 ? format(", %.0f ns a call", 1e9 * verdict.seconds_per_call).c_str() : "");
  int invalid = 0;
  for (const Finding& finding : verdict.findings) {
    if (!finding.seen) continue;
    ++invalid;
    std::printf(
        "  INVALID: %s%s\n", finding.what,
        finding.seen > 1 ? format(" (seen %llu times)", static_cast<unsigned long long>(finding.seen)).c_str() : "");
    if (finding.has_witness) print_witness(finding.witness, true);
    std::printf("     what to do: %s\n", finding.remedy);
  }
  if (!finished) print_death(end, verdict, options.seconds);
  if (invalid || !finished) return kExitBadNews;
  std::printf(
      "  valid: every support point finite, repeatable, free of the direction's length, and of one convex set;\n"
      "  its declarations agree with its support function\n");
  return 0;
}

/// @param words  path of the plugin, then the parameters to judge it with, if any
int probe_here(void* shared, const std::vector<std::string>& words) {
  auto& verdict = *static_cast<Verdict*>(shared);
  ProbeRequest request;
  request.path = words[0];
  for (std::size_t i = 1; i < words.size(); ++i) request.params.push_back(std::strtod(words[i].c_str(), nullptr));
  request.params_given = !request.params.empty();
  try {
    probe(verdict, request);
  } catch (...) {
    verdict.threw = 1;
  }
  return 0;
}

void check(const CheckOptions& options, Context& context) {
  const std::string path = absolute_path(options.plugin, context.plugins());
  std::vector<std::string> words = {path};
  for (const double param : options.params) words.push_back(format("%a", param));
  SharedMemory shared(sizeof(Verdict));
  const auto* verdict = new (shared.data()) Verdict();
  const ChildEnd end = run_in_child(probe_work, words, options.seconds, shared);
  if (verdict->usage)
    throw Error("these parameters do not fit the plugin: " + std::string(verdict->usage_text),
                "give what `carom shapes` shows for it, or none to have some chosen");
  std::printf("%s\n", path.c_str());
  context.exit_code = print_verdict(*verdict, end, options);
}

}  // namespace

const ChildWork probe_work = {"check", probe_here};

void add_check_command(CLI::App& app, Context& context) {
  auto options = std::make_shared<CheckOptions>();
  CLI::App* command = app.add_subcommand(
      "check",
      "Is this shape plugin valid? Tried in a child process; a witness where it is invalid. Its code runs: this is no sandbox");
  command->add_option("PLUGIN", options->plugin, "A shared object, or the name of a plugin that `carom shapes` lists")
      ->required();
  command->add_option("PARAMS", options->params, "Parameters of the shape; none: several sets within its bounds");
  command->add_option("--seconds", options->seconds, "CPU limit; a function that takes longer counts as hanging")
      ->check(CLI::Range(1u, 3600u))
      ->capture_default_str();
  command->footer("Exit codes: 0 valid; 1 it is invalid, hangs or crashes; 2 it could not be tried.");
  command->callback([options, &context] { check(*options, context); });
}

}  // namespace carom::tools
