// Where shape plugins are found: the library takes absolute paths only, so the search is ours.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "host/host.h"
#include "host/system.h"

namespace carom::tools {
namespace fs = std::filesystem;

PluginPath::PluginPath(std::vector<std::string> explicit_dirs) {
  auto add = [this](const fs::path& folder) {
    std::error_code ignored;
    const fs::path full = fs::weakly_canonical(fs::absolute(folder, ignored), ignored);
    folders_.push_back((full.empty() ? folder : full).string());
  };
  for (const std::string& dir : explicit_dirs) add(dir);
  if (const char* variable = std::getenv("CAROM_PLUGIN_PATH")) {
    std::stringstream list(variable);
    for (std::string dir; std::getline(list, dir, kBetweenFolders);)
      if (!dir.empty()) add(dir);
  }
  if (const fs::path base = own_base(); !base.empty()) {
    add(base / "plugins");
    add(base / CAROM_INSTALL_LIBDIR / "carom" / "plugins");
  }
}

std::string own_base(const char* link) {
  const fs::path own = own_program(link);
  return own.parent_path().parent_path().string();
}

bool is_plugin_name(const std::string& name) {
  const auto plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  };
  return !name.empty() && name.size() <= 64 && plain(name.front()) &&
         std::all_of(name.begin(), name.end(), [&](char c) { return plain(c) || c == '.'; });
}

namespace {

/// Whether a file lies in a folder, links resolved.   @param folder  canonical
bool lies_in(const fs::path& file, const fs::path& folder) {
  std::error_code failed;
  const fs::path real = fs::canonical(file, failed);
  return !failed && std::mismatch(folder.begin(), folder.end(), real.begin(), real.end()).first == folder.end();
}

}  // namespace

std::string PluginPath::find(const std::string& name) const {
  if (!is_plugin_name(name))
    throw Error("'" + name.substr(0, 80) + "' is no name of a shape plugin",
                "give its id alone: up to 64 letters, digits, _, - or dots; `carom shapes` lists them");
  std::string searched;
  for (const std::string& folder : folders_) {
    const fs::path candidate = fs::path(folder) / (name + kPluginEnding);
    std::error_code ignored;
    if (fs::is_regular_file(candidate, ignored)) {
      if (lies_in(candidate, folder)) return candidate.string();
      searched += "\n    " + folder + " (what stands there is a link out of it)";
    } else {
      searched += "\n    " + folder;
    }
  }
  std::vector<std::string> known;
  for (const auto& plugin : all()) known.push_back(plugin.first);
  const std::string near = nearest_name(name, known);
  throw Error("the shape plugin '" + name + kPluginEnding +
                  "' was not found; searched:" + (searched.empty() ? " nowhere" : searched),
              (near.empty() ? "" : "did you mean '" + near + "'? `carom shapes` lists all that are there; else ") +
                  "build the plugins (cmake --build --preset demo), or point --plugins DIR or CAROM_PLUGIN_PATH at the "
                  "folder that holds them");
}

std::map<std::string, std::string> PluginPath::all() const {
  std::map<std::string, std::string> found;
  for (const std::string& folder : folders_) {
    std::error_code failed;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, failed))
      if (entry.path().extension() == kPluginEnding && is_plugin_name(entry.path().stem().string()) &&
          entry.is_regular_file(failed) && lies_in(entry.path(), folder))
        found.emplace(entry.path().stem().string(), entry.path().string());
  }
  return found;
}

}  // namespace carom::tools
