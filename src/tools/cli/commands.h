// The subcommands of `carom`: one file and one add_<name>_command() each. main.cpp calls them in the order of --help.
// Exit codes of every command: 0 done; 1 it ran and the result is bad news (an invalid plugin, a run that went
// wrong); 2 it could not run (usage, missing files, plugins not found).
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "host/host.h"

namespace carom::tools {

/// What subcommands share. A command's callback may set exit_code, and may throw Error (printed with its remedy, exit
/// 2).
struct Context {
  std::vector<std::string> plugin_dirs;  ///< --plugins DIR, repeated
  int exit_code = 0;
  PluginPath plugins() const { return PluginPath(plugin_dirs); }
};

inline constexpr int kExitBadNews = 1;
inline constexpr int kExitCannotRun = 2;

void add_run_command(CLI::App& app, Context& context);
void add_replay_command(CLI::App& app, Context& context);
void add_plan_command(CLI::App& app, Context& context);
void add_scaling_command(CLI::App& app, Context& context);
void add_sweep_command(CLI::App& app, Context& context);
void add_export_command(CLI::App& app, Context& context);
void add_list_command(CLI::App& app, Context& context);
void add_shapes_command(CLI::App& app, Context& context);
void add_dials_command(CLI::App& app, Context& context);
void add_check_command(CLI::App& app, Context& context);
void add_paper_command(CLI::App& app, Context& context);
void add_accuracy_command(CLI::App& app, Context& context);
void add_tune_command(CLI::App& app, Context& context);
void add_jury_command(CLI::App& app, Context& context);
void add_import_command(CLI::App& app, Context& context);
void add_pack_command(CLI::App& app, Context& context);
void add_view_command(CLI::App& app, Context& context);

/// The values of repeated --set NAME=NUMBER.   @throws Error
std::vector<std::pair<std::string, double>> values_from(const std::vector<std::string>& sets);

}  // namespace carom::tools
