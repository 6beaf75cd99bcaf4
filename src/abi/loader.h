// Shared objects of shape plugins: the one thing of the boundary that differs between operating systems. One
// loader_*.cpp is compiled, which CAROM_LOADER names: `dlopen` where there is ELF and glibc, else `none`.
#pragma once

#include <carom/plugin.h>

#include <cstddef>
#include <string_view>

#include "abi/guard.h"

namespace carom::abi {

/// What a plugin's author exports, where it lies in memory.
struct EntrySymbol {
  const carom_shape_plugin* description = nullptr;  // null: the call has failed
  std::size_t bytes = 0;                            // size of the symbol; 0: unknown
};

/// Bring a shared object into the process, for good, and find CAROM_SHAPE_PLUGIN_SYMBOL in it. The host's
/// floating-point environment is as before.
/// @param path      argument 2 of the call
/// @param smallest  bytes that a description has at least
/// @errors PLUGIN_PATH (not absolute, no file); PLUGIN_LOAD (no object of this system, or without the symbol; or this
/// library
///         loads none); PLUGIN_ABI (the symbol is no data of that size)
EntrySymbol load_entry_symbol(Call& call, const char* path, std::size_t smallest);

/// Where a plugin's file is, and where it was looked for.
struct PluginFile {
  char path[4096] = {0};  // "": there is none
  char searched[sizeof carom_error::message] = {0};
};
/// Look for NAME.so in the folders of $CAROM_PLUGIN_PATH, beside the library, and where plugins are installed.
void find_plugin_file(std::string_view name, PluginFile& file);

}  // namespace carom::abi
