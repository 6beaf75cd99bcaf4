// Shared objects of shape plugins: the one thing of the boundary that differs between operating systems. One
// loader_*.cpp is
// compiled, which CAROM_LOADER names: `dlopen` where there is ELF and glibc, else `none`.
#pragma once

#include <cstddef>

#include <carom/plugin.h>

#include "abi/guard.h"

namespace carom::abi {

/// What a plugin's author exports, where it lies in memory.
struct EntrySymbol {
  const carom_shape_plugin* description = nullptr;  // null: the call has failed
  std::size_t room = 0;                             // bytes of the symbol; 0: unknown
};

/// Bring a shared object into the process, for good, and find CAROM_SHAPE_PLUGIN_SYMBOL in it. The host's
/// floating-point
/// environment is as before.
/// @param path      argument 2 of the call
/// @param smallest  bytes that a description has at least
/// @errors PLUGIN_PATH (not absolute, no file); PLUGIN_LOAD (no object of this system, or without the symbol; or this
/// library
///         loads none); PLUGIN_ABI (the symbol is no data of that size)
EntrySymbol load_entry_symbol(Call& call, const char* path, std::size_t smallest);

}  // namespace carom::abi
