// The `carom` command: reads the command line, hands over to one subcommand, prints what went wrong and what to do.
#include <cstdio>

#include "cli/commands.h"

int main(int argc, char** argv) {
  using namespace carom::tools;
  CLI::App app{"Carom: rigid-body physics whose shapes are plugins. Try: carom run seesaw --gltf seesaw.gltf", "carom"};
  app.require_subcommand(1);
  app.fallthrough();  // options of carom itself may follow the subcommand
  app.footer("Exit codes: 0 done; 1 bad news (a dishonest plugin, a run that went wrong); 2 could not run.");
  Context context;
  app.add_option("--plugins", context.plugin_dirs,
                 "Folder with shape plugins (repeatable); also CAROM_PLUGIN_PATH, then the folders of this program")
      ->type_name("DIR")
      ->allow_extra_args(false);
  add_run_command(app, context);
  add_replay_command(app, context);
  add_plan_command(app, context);
  add_export_command(app, context);
  add_list_command(app, context);
  add_shapes_command(app, context);
  add_dials_command(app, context);
  add_check_command(app, context);
  add_paper_command(app, context);
  add_accuracy_command(app, context);
  add_tune_command(app, context);
  add_import_command(app, context);
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& wrong) {
    std::fprintf(stderr, "carom: %s\n  what to do: see `carom --help`, or `carom COMMAND --help` for its options\n",
                 wrong.what());
    return kExitCannotRun;
  } catch (const Error& error) {
    std::fprintf(stderr, "carom: %s\n  what to do: %s\n", error.what(), error.remedy.c_str());
    return kExitCannotRun;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "carom: %s\n  what to do: check memory and disk space; if both are fine, please report this\n",
                 error.what());
    return kExitCannotRun;
  }
  return context.exit_code;
}
