// `carom replay FILE`: does a recorded session come out the same here? If not, where does it part, and by what?
#include "replay/replay.h"

#include <cstdio>
#include <memory>

#include "cli/commands.h"
#include "replay/script.h"

namespace carom::tools {
namespace {

struct ReplayOptions {
  std::string file;
  std::uint32_t threads = 1;
};

void print_parting(const replay::Outcome& outcome) {
  const replay::Parting& p = *outcome.parting;
  if (!p.refused.empty()) {
    std::printf("after step %llu a call is refused that went well when it was recorded: %s\n",
                static_cast<unsigned long long>(p.step), p.refused.c_str());
  } else {
    std::printf("step %llu comes out otherwise than recorded; all before it are the same\n",
                static_cast<unsigned long long>(p.step));
  }
  std::printf("  calls since the step before:\n");
  for (const std::string& call : p.calls) std::printf("    %s\n", call.c_str());
  if (!p.refused.empty()) return;
  if (p.sections.empty()) {
    std::printf(
        "  what differs is not known: states were not recorded (carom run --record-states, CAROM_RECORD_STATES)\n");
    return;
  }
  std::printf("  what differs: %s", p.sections.c_str());
  if (p.first) std::printf("; first %s", replay::name_of_handle(p.first).c_str());
  if (p.second) std::printf(" and %s", replay::name_of_handle(p.second).c_str());
  std::printf("\n");
  for (const std::string& detail : p.details) std::printf("    %s\n", detail.c_str());
}

void run_replay(const ReplayOptions& options, Context& context) {
  Engine engine(context.plugins());
  engine.set_threads(options.threads);
  engine.load_all();
  const replay::Outcome outcome = replay::play(engine.get(), replay::read_file(options.file));
  std::printf("%s: %llu steps, %llu calls made again%s\n", options.file.c_str(),
              static_cast<unsigned long long>(outcome.steps), static_cast<unsigned long long>(outcome.calls),
              outcome.parting ? "" : ", every step as recorded");
  if (outcome.parting) {
    print_parting(outcome);
    context.exit_code = kExitBadNews;
  } else if (!outcome.ended) {
    std::printf("  the recording was never ended: whoever made it may not have come back from the call after these\n");
  }
}

}  // namespace

void add_replay_command(CLI::App& app, Context& context) {
  auto options = std::make_shared<ReplayOptions>();
  CLI::App* replay =
      app.add_subcommand("replay", "Do a recorded session again; name the first step that differs, and why");
  replay->add_option("FILE", options->file, "What `carom run --record` or a program's recording wrote")->required();
  replay->add_option("--threads", options->threads, "Threads that share a step; the outcome is the same")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  replay->callback([options, &context] { run_replay(*options, context); });
}

}  // namespace carom::tools
