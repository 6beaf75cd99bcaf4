// `carom shapes`: the shape plugins that were found, what they take and what they declare.
#include <cstdio>

#include "cli/children.h"
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

constexpr unsigned kSeconds = 5;  // of computing, that a plugin may take to be loaded and told of

/// @param words  name, file, folders of plugins
int print_shape(void*, const std::vector<std::string>& words) {
  try {
    Engine engine(PluginPath(std::vector<std::string>(words.begin() + 2, words.end())));
    print_plugin(engine, words[0], words[1]);
    return 0;
  } catch (const Error& error) {
    std::printf("%s  REFUSED: %s\n  what to do: %s\n\n", words[0].c_str(), error.what(), error.remedy.c_str());
    return kExitBadNews;
  }
}

/// A plugin is a file of a stranger's: it is loaded in a child, which may hang or crash alone.   @return exit code
int print_in_child(const std::string& name, const std::string& file, const std::vector<std::string>& folders) {
  std::vector<std::string> words = {name, file};
  words.insert(words.end(), folders.begin(), folders.end());
  SharedMemory none(1);
  const ChildEnd end = run_in_child(print_shape_work, words, kSeconds, none);
  if (end.left && end.status != kChildThrew) return end.status;
  std::printf("%s  REFUSED: %s %s\n  what to do: run `carom check %s`\n\n", name.c_str(), file.c_str(),
              end.out_of_time ? "did not return within 5 s" : "crashed", file.c_str());
  return kExitBadNews;
}

void print_shapes(Context& context) {
  const PluginPath path = context.plugins();
  const std::map<std::string, std::string> files = path.all();
  if (files.empty()) path.find("sphere");  // throws the error that says where we looked
  for (const auto& [name, file] : files)
    if (const int code = print_in_child(name, file, path.folders())) context.exit_code = code;
  std::printf("half_space  (built in, static bodies only: it is not bounded)\n");
}

}  // namespace

const ChildWork print_shape_work = {"shapes", print_shape};

void add_shapes_command(CLI::App& app, Context& context) {
  app.add_subcommand("shapes", "List the shape plugins found: parameters, bounds, declarations")->callback([&context] {
    print_shapes(context);
  });
}

}  // namespace carom::tools
