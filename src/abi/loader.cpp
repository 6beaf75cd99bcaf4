// Where plugins are looked for, and what is said of a file that is none.
#include "abi/loader.h"

#include <algorithm>
#include <cstdio>
#include <cstring>

#include "abi/object_file.h"
#include "core/float_scope.h"

namespace carom::abi {
namespace {

/// No memory of the heap: a host counts that.
class Search {
 public:
  Search(std::string_view name, PluginFile& file) : name_(name), file_(file) {
    char space[1 << 15];
    if (const char* list = system::variable("CAROM_PLUGIN_PATH", space, sizeof space)) look_in_list(list);
    char own[sizeof file.path];
    system::own_file(own, sizeof own);
    if (own[0]) look_beside(own);
#ifdef CAROM_INSTALLED_PLUGINS
    look(CAROM_INSTALLED_PLUGINS, "");
#endif
  }

 private:
  void look(std::string_view folder, const char* below) {
    if (file_.path[0] || !system::is_absolute(folder)) return;
    const auto length = static_cast<int>(folder.size());
    const int size = std::snprintf(file_.path, sizeof file_.path, "%.*s%s/%.*s%s", length, folder.data(), below,
                                   static_cast<int>(name_.size()), name_.data(), system::kEnding);
    if (size > 0 && static_cast<std::size_t>(size) < sizeof file_.path && system::is_file(file_.path)) return;
    file_.path[0] = 0;
    const std::size_t at = strnlen(file_.searched, sizeof file_.searched);
    std::snprintf(file_.searched + at, sizeof file_.searched - at, "%s%.*s%s", at ? ", " : "", length, folder.data(),
                  below);
  }
  void look_in_list(std::string_view list) {
    while (!list.empty()) {
      const std::size_t end = std::min(list.find(system::kBetween), list.size());
      look(list.substr(0, end), "");
      list.remove_prefix(std::min(end + 1, list.size()));
    }
  }
  static std::string_view folder_of(std::string_view path) {
    return path.substr(0, path.find_last_of(system::kSlashes));
  }
  /// In the tree of a build plugins lie beside the library's folder, where it is installed below it. On Windows the
  /// library lies where programs do, and plugins below ../lib.
  void look_beside(std::string_view library) {
    const std::string_view folder = folder_of(library), parent = folder_of(folder);
    look(folder, "/carom/plugins");
    look(folder, "/plugins");
    look(parent, "/plugins");
#ifdef _WIN32
    look(parent, "/lib/carom/plugins");
#endif
    look(folder, "");
  }

  std::string_view name_;
  PluginFile& file_;
};

/// Whether a file is for another system or processor, or for none, or a part of one.   @return false: the call has failed
bool is_of_this_system(Call& call, const char* path) {
  unsigned char head[4096];
  std::size_t read = 0;
  long size = 0;
  if (std::FILE* file = system::open_file(path)) {
    read = std::fread(head, 1, sizeof head, file);
    size = std::fseek(file, 0, SEEK_END) == 0 ? std::ftell(file) : 0;
    std::fclose(file);
  }
  const ObjectKind given = object_kind(head, read), own = own_kind();
  const auto same = [](const char* a, const char* b) { return !a || !b || std::strcmp(a, b) == 0; };
  if (!given.system)
    return call.fail(CAROM_E_PLUGIN_LOAD, 2, "\"%.180s\" is no shared object", path) ||
           call.advise(
               "name the file that the compiler made of the plugin: cc -shared -fPIC -O2 myshape.c -o myshape.so");
  if (same(given.system, own.system) && same(given.machine, own.machine))
    return given.least <= static_cast<std::uint64_t>(size) ||
           call.fail(CAROM_E_PLUGIN_LOAD, 2, "\"%.180s\" breaks off: it has %ld bytes of %llu", path, size,
                     static_cast<unsigned long long>(given.least)) ||
           call.advise("copy it again, whole, or build the plugin again");
  return call.fail(CAROM_E_PLUGIN_LOAD, 2, "\"%.100s\" is for %s%s%s, this program for %s%s%s", path, given.system,
                   given.machine ? ", " : "", given.machine ? given.machine : "", own.system, own.machine ? ", " : "",
                   own.machine ? own.machine : "") ||
         call.advise("build the plugin again with the compiler of this system and processor");
}

/// What to do about the loader's words, which glibc, musl and dyld write in their own ways; others keep the code's remedy.
void advise_on_load(Call& call, const char* why) {
  if (std::strstr(why, "GLIBC_"))
    call.advise(
        "build the plugin on this system, or on the oldest that it has to run on: its own has a newer C library");
  else if (std::strstr(why, "cannot open shared object file") || std::strstr(why, "Error loading shared library") ||
           std::strstr(why, "Library not loaded"))
    call.advise("install the library that is named, or link it into the plugin: cc -shared ... libNAME.a");
}

}  // namespace

void find_plugin_file(std::string_view name, PluginFile& file) {
  if (system::kEnding) Search(name, file);
}

EntrySymbol load_entry_symbol(Call& call, const char* path, std::size_t smallest) {
  if (!system::kEnding) {
    call.fail(CAROM_E_PLUGIN_LOAD, 2, "\"%.120s\": this build of the library loads no shared objects", path);
    call.advise("give the address of its description to carom_plugin_register()");
    return {};
  }
  if (!system::is_absolute(path)) {
    call.fail(CAROM_E_PLUGIN_PATH, 2, "\"%.180s\" is not an absolute path", path);
    return {};
  }
  if (!system::is_file(path)) {
    call.fail(CAROM_E_PLUGIN_PATH, 2, "\"%.180s\" is not a readable file", path);
    return {};
  }
  if (!is_of_this_system(call, path)) return {};
  char why[sizeof carom_error::message] = {0};
  system::Symbol symbol;
  {
    const core::FloatScope scope;  // constructors of an -Ofast plugin set flush-to-zero
    symbol = system::load(path, CAROM_SHAPE_PLUGIN_SYMBOL, why, sizeof why);
  }
  if (!symbol.at) {  // some systems name the file themselves
    const bool named = std::strstr(why, path);
    call.fail(CAROM_E_PLUGIN_LOAD, 2, "%.100s%s%.140s", named ? "" : path, named ? "" : ": ",
              why[0] ? why : "the entry symbol is NULL");
    advise_on_load(call, why);
    return {};
  }
  if (!symbol.is_data || (symbol.bytes && symbol.bytes < smallest)) {
    call.fail(CAROM_E_PLUGIN_ABI, 2, CAROM_SHAPE_PLUGIN_SYMBOL " is %s of %llu bytes, not a carom_shape_plugin",
              symbol.is_data ? "data" : "no data but something else", static_cast<unsigned long long>(symbol.bytes));
    return {};
  }
  return {static_cast<const carom_shape_plugin*>(symbol.at), symbol.bytes};
}

}  // namespace carom::abi
