// `carom shapes`: the shape plugins that were found, what they take and what they declare.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>

#include "cli/commands.h"
#include "cli/table.h"

namespace carom::tools {
namespace {

std::string form_name(std::uint32_t form) {
  static const char* const kNames[] = {"none", "sphere", "capsule", "box", "polytope", "cylinder", "cone", "ellipsoid"};
  return form < std::size(kNames) ? kNames[form] : "unknown";
}

std::string declarations(const carom_shape_plugin& plugin) {
  if (!plugin.geometry) return "nothing: all is derived from the support function";
  const carom_geometry& g = *plugin.geometry;
  std::string text = "form " + form_name(g.form);
  if (g.core_radius_param < plugin.param_count)
    text += std::string("; core radius ") + plugin.params[g.core_radius_param].name;
  if (g.mass_form != CAROM_FORM_NONE) text += "; mass of a " + form_name(g.mass_form);
  return text;
}

void print_plugin(Engine& engine, const std::string& name, const std::string& file) {
  const carom_shape_plugin& plugin = engine.describe(engine.plugin(name));
  std::printf("%s  (%s, version %u)\n  %s\n", name.c_str(), plugin.id, plugin.version, file.c_str());
  for (std::uint32_t i = 0; i < plugin.param_count; ++i)
    std::printf("    %-12s %g to %g %s\n", plugin.params[i].name, plugin.params[i].min, plugin.params[i].max,
                plugin.params[i].unit);
  if (plugin.param_tail_group)
    std::printf("    the last %u repeat, at least %u times\n", plugin.param_tail_group, plugin.param_tail_min);
  for (std::uint32_t k = 0; plugin.struct_size >= sizeof plugin && k < plugin.rule_count; ++k)
    std::printf("    rule: %s\n", plugin.rules[k].text);
  std::printf("    declares %s\n\n", declarations(plugin).c_str());
}

constexpr rlim_t kSeconds = 5;  // of computing, that a plugin may take to be loaded and told of

/// A plugin is a file of a stranger's: it is loaded in a child, which may hang or crash alone.
/// @param print  -> exit code   @return likewise
template <class Print>
int print_in_child(const std::string& name, const std::string& file, Print&& print) {
  std::fflush(stdout);
  const pid_t child = fork();
  if (child == 0) {
    const rlimit most = {kSeconds, kSeconds + 1};
    setrlimit(RLIMIT_CPU, &most);
    const int code = print();
    std::fflush(stdout);
    _exit(code);
  }
  int status = 0;
  if (child < 0 || waitpid(child, &status, 0) != child)
    throw Error("cannot start a process of its own for " + name, "free memory or processes, and try again");
  if (WIFEXITED(status)) return WEXITSTATUS(status);
  std::printf("%s  REFUSED: %s %s\n  what to do: run `carom check %s`\n\n", name.c_str(), file.c_str(),
              WTERMSIG(status) == SIGXCPU ? "did not return within 5 s" : "crashed", file.c_str());
  return kExitBadNews;
}

void print_shapes(Context& context) {
  Engine engine(context.plugins());
  const std::map<std::string, std::string> files = engine.path().all();
  if (files.empty()) engine.path().find("sphere");  // throws the error that says where we looked
  for (const auto& found : files) {
    const std::string &name = found.first, &file = found.second;
    const int code = print_in_child(name, file, [&] {
      try {
        print_plugin(engine, name, file);
        return 0;
      } catch (const Error& error) {
        std::printf("%s  REFUSED: %s\n  what to do: %s\n\n", name.c_str(), error.what(), error.remedy.c_str());
        return kExitBadNews;
      }
    });
    if (code != 0) context.exit_code = code;
  }
  std::printf("half_space  (built in, static bodies only: it is not bounded)\n");
}

}  // namespace

void add_shapes_command(CLI::App& app, Context& context) {
  app.add_subcommand("shapes", "List the shape plugins found: parameters, bounds, declarations")->callback([&context] {
    print_shapes(context);
  });
}

}  // namespace carom::tools
