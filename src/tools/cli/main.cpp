// The `carom` command: reads the command line, hands over to one subcommand, prints what went wrong and what to do.
#include <cstdio>
#include <filesystem>
#include <memory>

#include "cli/children.h"
#include "cli/commands.h"
#include "cli/explain.h"
#include "host/files.h"

namespace carom::tools {
namespace {

/// `carom help [COMMAND]`: as `carom COMMAND --help`.
void add_help_command(CLI::App& app) {
  const auto words = std::make_shared<std::vector<std::string>>();
  CLI::App* command = app.add_subcommand("help", "What a command does and takes, as `carom COMMAND --help`");
  command->add_option("COMMAND", *words, "Of which; none: of all, in short");
  command->callback([words, &app] { std::printf("%s", help_of(app, *words).c_str()); });
}

/// @return what is wrong with a folder that --plugins names; "" if nothing
std::string plugin_folder_fault(const std::string& folder) {
  std::error_code failed;
  if (std::filesystem::is_directory(folder, failed)) return "";
  return (std::filesystem::exists(folder, failed) ? folder + " is no folder" : "there is no folder " + folder) +
         "; name the folder that holds the shape plugins (*.so); after a build it is build/demo/plugins";
}

int fail(const Error& error) {
  std::fprintf(stderr, "carom: %s\n  what to do: %s\n", error.what(), error.remedy.c_str());
  return kExitCannotRun;
}

}  // namespace
}  // namespace carom::tools

int main(int argc, char** argv) {
  using namespace carom::tools;
  if (const int status = child_main(argc, argv, {probe_work, print_shape_work}); status >= 0) return status;
  CLI::App app{"Carom: rigid-body physics whose shapes are plugins. Try: carom run seesaw --gltf seesaw.gltf", "carom"};
  app.require_subcommand(1);
  app.allow_windows_style_options(false);  // the same words on every system; /a/path is none
  app.set_version_flag("--version", "carom " + std::to_string(CAROM_VERSION_MAJOR) + "." +
                                        std::to_string(CAROM_VERSION_MINOR) + "." +
                                        std::to_string(CAROM_VERSION_PATCH));
  app.fallthrough();  // options of carom itself may follow the subcommand
  app.footer("Exit codes: 0 done; 1 bad news (an invalid plugin, a run that went wrong); 2 could not run.");
  Context context;
  app.add_option("--plugins", context.plugin_dirs,
                 "Folder with shape plugins (repeatable); also CAROM_PLUGIN_PATH, then the folders of this program")
      ->type_name("DIR")
      ->check(plugin_folder_fault)
      ->allow_extra_args(false);
  const auto mib = [](std::size_t& bytes) { return [&bytes](const std::size_t& n) { bytes = n << 20; }; };
  app.add_option_function<std::size_t>("--file-limit", mib(file_limits().largest),
                                       "Largest file that is read; default: 256 MiB")
      ->type_name("MIB")
      ->check(CLI::Range(1, 1 << 20));
  app.add_option("--file-factor", file_limits().factor,
                 "Bytes of memory that a scene file may take for each that is read of it, beyond 64 MiB")
      ->type_name("N")
      ->check(CLI::Range(1, 1 << 20))
      ->capture_default_str();
  add_help_command(app);
  add_run_command(app, context);
  add_replay_command(app, context);
  add_plan_command(app, context);
  add_scaling_command(app, context);
  add_sweep_command(app, context);
  add_export_command(app, context);
  add_list_command(app, context);
  add_shapes_command(app, context);
  add_dials_command(app, context);
  add_check_command(app, context);
  add_paper_command(app, context);
  add_accuracy_command(app, context);
  add_tune_command(app, context);
  add_jury_command(app, context);
  add_import_command(app, context);
  add_pack_command(app, context);
  add_view_command(app, context);
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp& help) {
    return app.exit(help);
  } catch (const CLI::CallForVersion& version) {
    return app.exit(version);
  } catch (const CLI::ParseError& wrong) {
    return fail(explain(app, wrong));
  } catch (const Error& error) {
    return fail(error);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "carom: %s\n  what to do: check memory and disk space; if both are fine, please report this\n",
                 error.what());
    return kExitCannotRun;
  }
  return context.exit_code;
}
