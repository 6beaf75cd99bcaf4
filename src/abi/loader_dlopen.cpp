// Shared objects by dlopen(): Linux with glibc. The only file that knows ELF.
#include <dlfcn.h>
#include <elf.h>
#include <sys/stat.h>

#include "abi/float_scope.h"
#include "abi/loader.h"

// dladdr1() and RTLD_DL_SYMENT: glibc's way to ask how large a symbol is.
#include <link.h>

namespace carom::abi {

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
    entry.room = found->st_size;
  }
  entry.description = static_cast<const carom_shape_plugin*>(symbol);
  return entry;
}

}  // namespace carom::abi
