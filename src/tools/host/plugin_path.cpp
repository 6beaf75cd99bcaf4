// Where shape plugins are found: the library takes absolute paths only, so the search is ours.
#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "host/host.h"

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
    for (std::string dir; std::getline(list, dir, ':');)
      if (!dir.empty()) add(dir);
  }
  std::error_code failed;
  const fs::path executable = fs::read_symlink("/proc/self/exe", failed);
  if (!failed) {
    const fs::path base = executable.parent_path().parent_path();
    add(base / "plugins");
    add(base / CAROM_INSTALL_LIBDIR / "carom" / "plugins");
  }
}

std::string PluginPath::find(const std::string& name) const {
  std::string searched;
  for (const std::string& folder : folders_) {
    const fs::path candidate = fs::path(folder) / (name + ".so");
    std::error_code ignored;
    if (fs::is_regular_file(candidate, ignored)) return candidate.string();
    searched += "\n    " + folder;
  }
  throw Error(
      "the shape plugin '" + name + ".so' was not found; searched:" + (searched.empty() ? " nowhere" : searched),
      "build the plugins (cmake --build --preset demo), or point --plugins DIR or CAROM_PLUGIN_PATH at the "
      "folder that holds them");
}

std::map<std::string, std::string> PluginPath::all() const {
  std::map<std::string, std::string> found;
  for (const std::string& folder : folders_) {
    std::error_code failed;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, failed))
      if (entry.path().extension() == ".so" && entry.is_regular_file(failed))
        found.emplace(entry.path().stem().string(), entry.path().string());
  }
  return found;
}

}  // namespace carom::tools
