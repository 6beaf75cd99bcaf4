// Shared objects of shape plugins: the one thing of the boundary that differs between operating systems. loader.cpp is
// the same on all; of loader_*.cpp one is compiled, which CAROM_LOADER names: `dlopen`, `windows` or `none`.
#pragma once

#include <carom/plugin.h>

#include <cstddef>
#include <cstdio>
#include <string_view>

#include "abi/guard.h"

namespace carom::abi {

/// What a plugin's author exports, where it lies in memory.
struct EntrySymbol {
  const carom_shape_plugin* description = nullptr;  // null: the call has failed
  std::size_t bytes = 0;                            // that may be read there; 0: unknown
};

/// Bring a shared object into the process, for good, and find CAROM_SHAPE_PLUGIN_SYMBOL in it. The host's
/// floating-point environment is as before.
/// @param path      argument 2 of the call
/// @param smallest  bytes that a description has at least
/// @errors PLUGIN_PATH (not absolute, no file); PLUGIN_LOAD (no object of this system, or without the symbol; or this
/// library loads none); PLUGIN_ABI (the symbol is no data of that size)
EntrySymbol load_entry_symbol(Call& call, const char* path, std::size_t smallest);

/// Where a plugin's file is, and where it was looked for.
struct PluginFile {
  char path[4096] = {0};  // "": there is none
  char searched[sizeof carom_error::message] = {0};
};
/// Look for NAME.so, or NAME.dll on Windows, in the folders of $CAROM_PLUGIN_PATH, beside the library, and where plugins
/// are installed.
void find_plugin_file(std::string_view name, PluginFile& file);

/// What loader_*.cpp says of its system. Paths are UTF-8.
namespace system {

extern const char* const kEnding;  // ".so"; null: nothing is loaded here
extern const char kBetween;        // two folders of a list
extern const char* const kSlashes;
extern const char* const kOpenCl;  // the loader of OpenCL, as the system finds it; null: nothing is loaded here

bool is_absolute(std::string_view path);
bool is_file(const char* path);
/// A variable that whoever starts the program sets, or null; also where it has more rights than they.
/// @param space  [size] for a copy, where the system's own is no UTF-8
const char* variable(const char* name, char* space, std::size_t size);
/// This library's own file.   @param path  [size] "" where that is unknown
void own_file(char* path, std::size_t size);
/// A file, to read its bytes; null: it can't be read.
std::FILE* open_file(const char* path);

struct Symbol {
  const void* at = nullptr;  // null: there is none, `why` says it
  std::size_t bytes = 0;     // from there on: of the symbol, or of the memory that it is in; 0: unknown
  bool is_data = true;
};
/// Never closed: unloading is logical. Nor by the host: code of a shape that a step is calling must not go away.
/// @param why  [size] what the system says
Symbol load(const char* path, const char* symbol, char* why, std::size_t size);

}  // namespace system
}  // namespace carom::abi
