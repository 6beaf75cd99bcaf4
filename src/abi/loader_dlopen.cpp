// Shared objects by dlopen(): Linux with glibc. The only file that knows ELF.
#include <dlfcn.h>
#include <elf.h>
#include <sys/stat.h>

#include <algorithm>
#include <climits>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "core/float_scope.h"
#include "abi/loader.h"

// dladdr1() and RTLD_DL_SYMENT: glibc's way to ask how large a symbol is.
#include <link.h>

namespace carom::abi {
namespace {

/// No memory of the heap: a host counts that.
class Search {
 public:
  Search(std::string_view name, PluginFile& file) : name_(name), file_(file) {
    if (const char* variable = secure_getenv("CAROM_PLUGIN_PATH")) look_in_list(variable);
    Dl_info here;
    char real[PATH_MAX];
    if (dladdr(reinterpret_cast<const void*>(&carom_version), &here) && here.dli_fname &&
        realpath(here.dli_fname, real))
      look_beside(real);
#ifdef CAROM_INSTALLED_PLUGINS
    look(CAROM_INSTALLED_PLUGINS, "");
#endif
  }

 private:
  void look(std::string_view folder, const char* below) {
    if (file_.path[0] || folder.empty() || folder.front() != '/') return;
    const auto length = static_cast<int>(folder.size());
    const int size = std::snprintf(file_.path, sizeof file_.path, "%.*s%s/%.*s.so", length, folder.data(), below,
                                   static_cast<int>(name_.size()), name_.data());
    struct stat status;
    if (size > 0 && static_cast<std::size_t>(size) < sizeof file_.path && stat(file_.path, &status) == 0 &&
        S_ISREG(status.st_mode))
      return;
    file_.path[0] = 0;
    const std::size_t at = strnlen(file_.searched, sizeof file_.searched);
    std::snprintf(file_.searched + at, sizeof file_.searched - at, "%s%.*s%s", at ? ", " : "", length, folder.data(),
                  below);
  }
  void look_in_list(std::string_view list) {
    while (!list.empty()) {
      const std::size_t end = std::min(list.find(':'), list.size());
      look(list.substr(0, end), "");
      list.remove_prefix(std::min(end + 1, list.size()));
    }
  }
  /// In the tree of a build plugins lie beside the library's folder, where it is installed below it.
  void look_beside(std::string_view library) {
    const std::string_view folder = library.substr(0, library.rfind('/')), parent = folder.substr(0, folder.rfind('/'));
    look(folder, "/carom/plugins");
    look(folder, "/plugins");
    look(parent, "/plugins");
    look(folder, "");
  }

  std::string_view name_;
  PluginFile& file_;
};

}  // namespace

void find_plugin_file(std::string_view name, PluginFile& file) { Search(name, file); }

EntrySymbol load_entry_symbol(Call& call, const char* path, std::size_t smallest) {
  EntrySymbol entry;
  if (path[0] != '/') {
    call.fail(CAROM_E_PLUGIN_PATH, 2, "\"%.180s\" is not an absolute path", path);
    return entry;
  }
  struct stat status;
  if (stat(path, &status) != 0 || !S_ISREG(status.st_mode)) {
    call.fail(CAROM_E_PLUGIN_PATH, 2, "\"%.180s\" is not a readable file", path);
    return entry;
  }
  // Never closed: unloading is logical. NODELETE besides, should the host close it: code of a shape that a step is
  // calling must not go away.
  void* library;
  {
    const FloatScope scope;  // constructors of an -Ofast plugin set flush-to-zero
    library = dlopen(path, RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
  }
  const void* symbol = library ? dlsym(library, CAROM_SHAPE_PLUGIN_SYMBOL) : nullptr;
  if (!symbol) {
    const char* why = dlerror();
    call.fail(CAROM_E_PLUGIN_LOAD, 2, "%.220s", why ? why : "the entry symbol is NULL");
    return entry;
  }
  Dl_info info;
  const ElfW(Sym)* found = nullptr;
  if (dladdr1(symbol, &info, const_cast<void**>(reinterpret_cast<const void**>(&found)), RTLD_DL_SYMENT) && found) {
    const bool is_data = ELF64_ST_TYPE(found->st_info) == STT_OBJECT;
    if (!is_data || found->st_size < smallest) {
      call.fail(CAROM_E_PLUGIN_ABI, 2, CAROM_SHAPE_PLUGIN_SYMBOL " is %s of %llu bytes, not a carom_shape_plugin",
                is_data ? "data" : "no data but something else", static_cast<unsigned long long>(found->st_size));
      return entry;
    }
    entry.bytes = found->st_size;
  }
  entry.description = static_cast<const carom_shape_plugin*>(symbol);
  return entry;
}

}  // namespace carom::abi
