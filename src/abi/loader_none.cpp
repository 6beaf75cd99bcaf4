// Systems whose shared objects the library can't load: WebAssembly (the host brings a side module into memory and
// registers it by pointer) and, for now, all without glibc.
#include "abi/loader.h"

namespace carom::abi {

EntrySymbol load_entry_symbol(Call& call, const char* path, std::size_t) {
  call.fail(CAROM_E_PLUGIN_LOAD, 2,
            "\"%.120s\": this build of the library loads no shared objects; use carom_plugin_register()", path);
  return {};
}

void find_plugin_file(std::string_view, PluginFile&) {}

}  // namespace carom::abi
